#include "pipeline/params.hpp"

#include <gtest/gtest.h>
#include <set>

#include "pipeline/modes.hpp"
#include "pipeline/params_fields.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

/// Calls visit(key, value, info) for the numbers among the parameters.
template <class Visit>
void visit_numbers(PipelineParams& params, const Visit& visit) {
  visit_fields(params, [&](std::string_view key, auto& value, const FieldInfo& info) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, float>) visit(key, value, info);
  });
}

TEST(PipelineParams, TheDefaultsAndTheModesAreValid) {
  for (const Mode& mode : modes) EXPECT_NO_THROW(validate(mode.params)) << mode.name;
}

TEST(PipelineParams, EveryKeyIsThereOnceAndDocumented) {
  PipelineParams params;
  std::set<std::string> keys;
  visit_fields(params, [&](std::string_view key, auto&, const FieldInfo& info) {
    EXPECT_TRUE(keys.emplace(key).second) << key;
    EXPECT_FALSE(info.doc.empty()) << key;
  });
  EXPECT_GT(keys.size(), 40u);
}

TEST(PipelineParams, EveryNumberHasARangeThatHoldsItsDefault) {
  PipelineParams params;
  visit_numbers(params, [](std::string_view key, auto& value, const FieldInfo& info) {
    EXPECT_LT(info.min, info.max) << key;
    EXPECT_GE(value, info.min) << key;
    EXPECT_LE(value, info.max) << key;
  });
}

TEST(PipelineParams, KeysThatNameAUnitHaveIt) {
  const std::pair<std::string_view, std::string_view> endings[]{{"_px", "px"},     {"_mm", "mm"},
                                                                {"_deg", "deg"},   {"_per_px", "1/px"},
                                                                {"_per_m", "1/m"}, {"_sigmas", "sigma"}};
  PipelineParams params;
  visit_fields(params, [&](std::string_view key, auto&, const FieldInfo& info) {
    std::string_view expected = info.unit;
    for (const auto& [ending, unit] : endings)
      if (key.ends_with(ending)) expected = unit;
    EXPECT_EQ(info.unit, expected) << key;
  });
}

TEST(PipelineParams, ANumberOutsideItsRangeIsNamedWithItsValue) {
  PipelineParams valid;
  visit_numbers(valid, [](std::string_view key, auto&, const FieldInfo& info) {
    for (const double wrong : {info.min - 1, info.max + 1}) {
      PipelineParams params;
      std::string printed;
      visit_numbers(params, [&](std::string_view k, auto& value, const FieldInfo&) {
        if (k != key) return;
        value = static_cast<std::remove_reference_t<decltype(value)>>(wrong);
        printed = std::to_string(value);
      });
      expect_error(ErrorKind::config, std::string(key) + ": must lie in", [&] { validate(params); });
      expect_error(ErrorKind::config, "got " + printed, [&] { validate(params); });
    }
  });
}

TEST(PipelineParams, AnEvenWindowIsRejected) {
  PipelineParams params;
  params.wiener.window_px = 4;
  expect_error(ErrorKind::config, "wiener.window_px: must be odd, got 4", [&] { validate(params); });
}

TEST(PipelineParams, ANumberThatIsNoneIsRejected) {
  PipelineParams params;
  params.dd.jump_ratio = std::numeric_limits<float>::quiet_NaN();
  expect_error(ErrorKind::config, "dd.jump_ratio", [&] { validate(params); });
}

TEST(PipelineParams, ContradictingValuesAreRejected) {
  const std::pair<const char*, void (*)(PipelineParams&)> cases[]{
      {"dd.low_per_px", [](PipelineParams& p) { p.dd.low_per_px = 2 * p.dd.high_per_px; }},
      {"cd.low_deg", [](PipelineParams& p) { p.cd.low_deg = p.cd.high_deg + 1; }},
      {"cd.closure", [](PipelineParams& p) { p.cd.mode = CreaseMode::paper; }},
      {"morphology.small_element_px", [](PipelineParams& p) { p.morphology.small_element_px = 11; }}};
  for (const auto& [key, spoil] : cases) {
    PipelineParams params;
    spoil(params);
    expect_error(ErrorKind::config, key, [&] { validate(params); });
  }
}

TEST(PipelineParams, NamesOfEnumerationsCanBeReadBack) {
  PipelineParams params;
  visit_fields(params, [](std::string_view key, auto& value, const FieldInfo&) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>) {
      EXPECT_EQ(parse_enum<Value>(enum_name(value)), value) << key;
      EXPECT_FALSE(parse_enum<Value>("no such name")) << key;
    }
  });
}

}  // namespace
}  // namespace facet
