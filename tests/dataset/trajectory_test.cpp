#include "dataset/trajectory.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace facet {
namespace {

void expect_near(Vec3d a, Vec3d b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(a.z, b.z, 1e-9);
}

TEST(Trajectory, a_quaternion_turns_as_its_axis_and_angle_say) {
  const double half = std::numbers::pi / 8;
  const auto motion = motion_from_quaternion({0, 0, std::sin(half), std::cos(half)}, {1, 2, 3});
  ASSERT_TRUE(motion);
  const RigidMotion expected = rotation({0, 0, 1}, std::numbers::pi / 4);
  expect_near(motion->ex, expected.ex);
  expect_near(motion->ey, expected.ey);
  expect_near(motion->ez, expected.ez);
  expect_near(motion->origin, {1, 2, 3});
}

TEST(Trajectory, a_matrix_is_a_motion_only_where_its_rotation_is_one) {
  const std::array<double, 16> good{0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
  const auto motion = motion_from_matrix(good);
  ASSERT_TRUE(motion);
  expect_near(motion->apply({1, 0, 0}), {5, 7, 7});
  std::array<double, 16> mirrored = good, scaled = good, empty{};
  mirrored[10] = -1;
  scaled[4] = 1.1;
  EXPECT_FALSE(motion_from_matrix(mirrored));
  EXPECT_FALSE(motion_from_matrix(scaled));
  EXPECT_FALSE(motion_from_matrix(empty));
}

TEST(Trajectory, interpolates_between_neighbours_and_not_beyond_them) {
  // The second pose is written with the opposite sign, which is the same rotation.
  const Trajectory path(text_lines("1.0 0 0 0 0 0 0 1\n1.1 1 0 0 0 0 -0.70710678 -0.70710678\n"));
  const auto middle = path.at(1.05, 0.1);
  ASSERT_TRUE(middle);
  expect_near(middle->origin, {0.5, 0, 0});
  expect_near(middle->ex, rotation({0, 0, 1}, std::numbers::pi / 4).ex);
  EXPECT_TRUE(path.at(1.0, 0));
  EXPECT_FALSE(path.at(1.05, 0.04));
  EXPECT_FALSE(path.at(0.99, 1));
  EXPECT_FALSE(path.at(1.11, 1));
}

TEST(Trajectory, counts_lines_that_hold_no_pose) {
  const Trajectory path(text_lines("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0\n3 0 0 0 0 0 0 0\n4 x 0 0 0 0 0 1\n"));
  EXPECT_EQ(path.size(), 1u);
  EXPECT_EQ(path.broken_lines(), 3u);
}

TEST(Trajectory, takes_any_bytes) {
  std::mt19937 random(1);
  const std::string alphabet("0123456789.-+eE \n\t#x\0\xff", 22);
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (unsigned i = 0; i < random() % 200; ++i) text += alphabet[random() % alphabet.size()];
    const auto lines = text_lines(text);
    const Trajectory path(lines);
    EXPECT_EQ(path.size() + path.broken_lines(), lines.size());
    if (const auto motion = path.at(1, 1)) {
      EXPECT_NEAR(norm(motion->ex), 1, 1e-6);
    }
  }
}

}  // namespace
}  // namespace facet
