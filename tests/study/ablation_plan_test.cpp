#include "study/ablation_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

const std::vector<MethodSpec> methods{MethodSpec{}};

AblationPlan plan(AblationDesign design, const std::vector<std::string>& switches) {
  return plan_ablations({{.design = design, .switches = switches}}, methods);
}

std::vector<std::string> names(const AblationPlan& plan) {
  std::vector<std::string> out;
  for (const MethodSpec& method : plan.methods) out.push_back(method.name);
  return out;
}

TEST(AblationPlan, LeaveOneOutComparesAllWithAllButOne) {
  const AblationPlan p = plan(AblationDesign::leave_one_out, {"fill", "wiener"});
  EXPECT_THAT(names(p), ElementsAre("default.all", "default.no-fill", "default.no-wiener"));
  EXPECT_THAT(p.comparisons[1].pairs, ElementsAre(Pair("default.all", "default.no-wiener")));
  EXPECT_FALSE(p.methods[2].params.wiener.enabled);
  EXPECT_TRUE(p.methods[2].params.fill.enabled);
}

TEST(AblationPlan, OneInComparesNoneWithOne) {
  const AblationPlan p = plan(AblationDesign::one_in, {"fill", "wiener"});
  EXPECT_THAT(names(p), ElementsAre("default.fill", "default.none", "default.wiener"));
  EXPECT_THAT(p.comparisons[0].pairs, ElementsAre(Pair("default.fill", "default.none")));
}

TEST(AblationPlan, CumulativeAddsOneAfterTheOther) {
  const AblationPlan p = plan(AblationDesign::cumulative, {"fill", "wiener", "validation"});
  EXPECT_THAT(p.comparisons[0].pairs, ElementsAre(Pair("default.fill", "default.none")));
  EXPECT_THAT(p.comparisons[1].pairs, ElementsAre(Pair("default.fill-wiener", "default.fill")));
  EXPECT_THAT(p.comparisons[2].pairs, ElementsAre(Pair("default.all", "default.fill-wiener")));
}

TEST(AblationPlan, FactorialRunsEverySubsetOnce) {
  const AblationPlan p = plan(AblationDesign::factorial, {"fill", "wiener", "validation"});
  EXPECT_EQ(p.methods.size(), 8u);
  EXPECT_EQ(p.comparisons[0].pairs.size(), 4u);
}

TEST(AblationPlan, SaysWhyASwitchCanHaveNoEffect) {
  const AblationPlan p = plan(AblationDesign::leave_one_out, {"fill", "morphology", "sobel", "relocation"});
  EXPECT_EQ(p.comparisons[0].not_applicable, "");
  EXPECT_EQ(p.comparisons[1].not_applicable, "off in method default already");
  EXPECT_EQ(p.comparisons[2].not_applicable, "no step uses the gradient");
  EXPECT_EQ(p.comparisons[3].not_applicable, "it needs depth edges by Canny");
  EXPECT_THAT(names(p), ElementsAre("default.all", "default.no-fill")) << "what cannot differ does not run";
}

TEST(AblationPlan, SharesMethodsBetweenDesigns) {
  const AblationPlan p = plan_ablations({{.design = AblationDesign::leave_one_out, .switches = {"fill"}},
                                         {.design = AblationDesign::one_in, .switches = {"fill"}}},
                                        methods);
  EXPECT_EQ(p.methods.size(), 2u);
  EXPECT_EQ(p.comparisons[0].pairs, p.comparisons[1].pairs);
}

TEST(AblationPlan, RefusesWhatItCannotPlan) {
  const auto refuses = [](const AblationOptions& options, const std::string& part) {
    expect_error(ErrorKind::config, part, [&] { plan_ablations({options}, methods); });
  };
  refuses({.base = "paper", .switches = {"fill"}}, "base paper");
  refuses({}, "no switch is named");
  refuses({.design = AblationDesign::factorial,
           .switches = {"fill", "wiener", "sobel", "jump", "basins", "detrend"}},
          "5 switches at most");
}

}  // namespace
}  // namespace facet
