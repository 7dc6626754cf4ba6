#include "dataset/numbered_frames.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(NumberedFrames, tell_their_time_by_the_last_number_of_their_name) {
  const NumberedFrames numbered = number_frames({"cam1_0012_depth", "cam1_0009_depth"}, 30);
  ASSERT_EQ(numbered.frames.size(), 2u);
  EXPECT_EQ(numbered.frames[0].id, "cam1_0009_depth");
  EXPECT_DOUBLE_EQ(numbered.frames[0].timestamp_s, 0.3);
  EXPECT_DOUBLE_EQ(numbered.frames[1].timestamp_s, 0.4);
  EXPECT_EQ(numbered.remarks, std::vector<std::string>{"2 of 4 frames absent, by their numbers"});
}

TEST(NumberedFrames, leave_out_what_has_no_number_or_another_frames) {
  const NumberedFrames numbered = number_frames({"1", "01", "2", "calibration"}, 30);
  EXPECT_EQ(numbered.frames.size(), 2u);
  EXPECT_EQ(numbered.remarks, (std::vector<std::string>{"1 entry left out: no number in the name",
                                                        "1 entry left out: another frame has the number"}));
}

TEST(NumberedFrames, may_be_none) {
  EXPECT_TRUE(number_frames({}, 30).frames.empty());
  EXPECT_TRUE(number_frames({}, 30).remarks.empty());
}

TEST(NumberedFrames, are_lost_where_times_leave_gaps) {
  EXPECT_EQ(frames_lost({0, 0.033, 0.067, 0.1, 0.2, 0.233}), 2u);
  EXPECT_EQ(frames_lost({0, 0.034, 0.066, 0.1}), 0u);
  EXPECT_EQ(frames_lost({5}), 0u);
  EXPECT_EQ(frames_lost({}), 0u);
}

}  // namespace
}  // namespace facet
