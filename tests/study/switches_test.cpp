#include "study/switches.hpp"

#include <gtest/gtest.h>
#include <set>

namespace facet {
namespace {

TEST(Switches, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const AblationSwitch& s : ablation_switches()) EXPECT_TRUE(names.insert(s.name).second) << s.name;
  EXPECT_EQ(find_switch("wiener")->name, "wiener");
  EXPECT_EQ(find_switch("wienr"), nullptr);
}

TEST(Switches, TurnedOffLeaveValidParameters) {
  for (const AblationSwitch& s : ablation_switches()) {
    PipelineParams params;
    s.turn_off(params);
    EXPECT_NO_THROW(validate(params)) << s.name;
  }
}

TEST(Switches, SayThatTheGradientIsNotUsedByDefault) {
  const AblationSwitch& sobel = *find_switch("sobel");
  PipelineParams params;
  EXPECT_EQ(sobel.inert_because(params), "no step uses the gradient");
  params.dd.mode = DepthEdgeMode::canny;
  EXPECT_EQ(sobel.inert_because(params), "");
}

TEST(SameParams, SeesEveryField) {
  PipelineParams a, b;
  EXPECT_TRUE(same_params(a, b));
  b.grasp.friction += 0.1f;
  EXPECT_FALSE(same_params(a, b));
}

}  // namespace
}  // namespace facet
