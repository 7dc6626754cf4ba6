#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

TEST(AblateCommand, RunsTheVariantsAndStoresWhatTheSwitchesAreWorth) {
  FacetProcess facet;
  write_small_frames(facet.folder() / "frames", {"f0", "f1", "f2"});
  facet.write("exp.yaml",
              "schema: 1\n" + small_dataset +
                  "ablation: {design: cumulative, base: default, switches: [wiener, sobel, validation]}\n"
                  "timing: {warmup: 1, repeats: 2}\n");
  const auto result = facet.run({"ablate", "exp.yaml", "-o", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("sobel: n/a, no step uses the gradient"));
  const auto run = facet.latest("out", "exp");
  const auto costs = nlohmann::json::parse(file_text(run / "timing/ablation.json")).at("rows");
  ASSERT_EQ(costs.size(), 3u);
  EXPECT_EQ(costs[0].at("switch"), "wiener");
  EXPECT_EQ(costs[0].at("n"), 3);
  const auto effects = nlohmann::json::parse(file_text(run / "metrics/ablation.json")).at("rows");
  EXPECT_TRUE(effects[0].at("change").is_null());  // these frames have no truth
  EXPECT_EQ(effects[0].at("reason"), "no frame is scored for all of its methods");
  EXPECT_TRUE(std::filesystem::exists(run / "strips/cumulative_default/small/f1.png"));
  EXPECT_EQ(facet.run({"report", run.string()}).out.substr(0, 200), result.out.substr(0, 200));
}

TEST(AblateCommand, NeedsItsSection) {
  FacetProcess facet;
  facet.write("exp.yaml", "schema: 1\n");
  const auto result = facet.run({"ablate", "exp.yaml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("`ablation`"));
}

}  // namespace
}  // namespace facet
