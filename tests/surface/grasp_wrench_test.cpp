#include "surface/grasp_wrench.hpp"

#include <Eigen/Dense>
#include <array>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace facet {
namespace {

constexpr double mu = 0.5;
constexpr double degree = M_PI / 180;
const double cone_deg = std::atan(mu) / degree;  // 26.6

using Polygon = std::vector<Vec2>;  ///< inside on the side left_of() the direction

/// Contact on the side that begins at corner i, `share` of its length along.
PlanarContact on_side(const Polygon& polygon, std::size_t i, double share = 0.5) {
  const Vec2 from = polygon[i], to = polygon[(i + 1) % polygon.size()];
  return {from + share * (to - from), normalized(left_of(to - from))};
}
PlanarContact on_disc(double angle_deg, double radius = 1) {
  const Vec2 outward{std::cos(angle_deg * degree), std::sin(angle_deg * degree)};
  return {radius * outward, -1.0 * outward};
}
const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon equilateral{{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}};

TEST(PlanarWrenches, OppositeSidesOfASquareHoldItAndAdjacentOnesDoNot) {
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(spans_planar_wrenches(on_side(square, i), on_side(square, (i + 2) % 4), mu));
    EXPECT_FALSE(spans_planar_wrenches(on_side(square, i), on_side(square, (i + 1) % 4), mu));
  }
}

TEST(PlanarWrenches, OppositeSidesOfARectangleHoldItWhateverItsSizeAndPlace) {
  for (const double scale : {1e-3, 0.1, 1.0, 1000.0})
    for (const Vec2 place : {Vec2{0, 0}, Vec2{5, -3}}) {
      Polygon rectangle{{0, 0}, {3, 0}, {3, 1}, {0, 1}};
      for (Vec2& corner : rectangle) corner = scale * (corner + place);
      EXPECT_TRUE(spans_planar_wrenches(on_side(rectangle, 0), on_side(rectangle, 2), mu));
      EXPECT_TRUE(spans_planar_wrenches(on_side(rectangle, 1), on_side(rectangle, 3), mu));
    }
}

TEST(PlanarWrenches, ParallelSidesHoldUpToAnOffsetThatFrictionBears) {
  const Polygon rectangle{{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  for (const double offset : {0.0, 0.2, 0.49, 0.51, 0.8, 1.5}) {  // friction bears mu times the width
    const bool holds = spans_planar_wrenches(on_side(rectangle, 0, 0.5 + offset / 8),
                                             on_side(rectangle, 2, 0.5 + offset / 8), mu);
    EXPECT_EQ(holds, offset < mu) << offset;
  }
}

TEST(PlanarWrenches, ADiscIsHeldAcrossItsMiddleAndUpToTheFrictionConesBesideIt) {
  for (int turn_deg = 0; turn_deg < 360; turn_deg += 15)
    for (const double bend_deg : {0.0, 10.0, cone_deg - 0.1, cone_deg + 0.1, 40.0, 89.0}) {
      // The chord makes the angle bend_deg with both normals.
      const bool holds = spans_planar_wrenches(on_disc(turn_deg), on_disc(turn_deg + 180 - 2 * bend_deg), mu);
      EXPECT_EQ(holds, bend_deg < cone_deg) << turn_deg << ", " << bend_deg;
    }
}

TEST(PlanarWrenches, ASlantedPairSlipsOnceItsSidesLeaveTheFrictionCones) {
  for (const double slant_deg : {5.0, cone_deg - 0.1, cone_deg + 0.1, 35.0, 60.0}) {
    const double s = std::tan(slant_deg * degree);  // a trapezoid whose sides both lean inwards
    const Polygon trapezoid{{-2, 0}, {2, 0}, {2 - s, 1}, {-2 + s, 1}};
    EXPECT_EQ(spans_planar_wrenches(on_side(trapezoid, 1), on_side(trapezoid, 3), mu), slant_deg < cone_deg)
        << slant_deg;
  }
}

TEST(PlanarWrenches, ASlantOnOneSideAloneIsBorneIfTheContactsLieOppositeForIt) {
  const PlanarContact left{{0, 0}, {1, 0}};
  const auto leaning = [](double deg, double y) {
    return PlanarContact{{1, y}, {-std::cos(deg * degree), std::sin(deg * degree)}};
  };
  EXPECT_TRUE(spans_planar_wrenches(left, leaning(20, 0), mu));
  EXPECT_FALSE(spans_planar_wrenches(left, leaning(30, 0), mu));
  EXPECT_TRUE(spans_planar_wrenches(left, leaning(30, -0.2), mu))
      << "11 degrees of the left cone, 19 of the right";
  EXPECT_FALSE(spans_planar_wrenches(left, leaning(30, 0.2), mu));
}

TEST(PlanarWrenches, AnEquilateralTriangleNeedsMoreFrictionThanTheTangentOf30Degrees) {
  for (std::size_t i = 0; i < 3; ++i) {
    const PlanarContact a = on_side(equilateral, i), b = on_side(equilateral, (i + 1) % 3);
    EXPECT_FALSE(spans_planar_wrenches(a, b, mu));
    EXPECT_FALSE(spans_planar_wrenches(a, b, 0.577));
    EXPECT_TRUE(spans_planar_wrenches(a, b, 0.578));
  }
}

TEST(PlanarWrenches, FingersInAHoleHoldItByPressingOutwards) {
  EXPECT_TRUE(spans_planar_wrenches({{-1, 0}, {-1, 0}}, {{1, 0}, {1, 0}}, mu));
  EXPECT_FALSE(spans_planar_wrenches({{-1, 0}, {1, 0}}, {{1, 0}, {1, 0}}, mu)) << "both press the same way";
}

TEST(PlanarWrenches, WithoutFrictionOrDistanceNothingIsHeld) {
  EXPECT_FALSE(spans_planar_wrenches(on_side(square, 0), on_side(square, 2), 0));
  EXPECT_FALSE(spans_planar_wrenches(on_side(square, 0), on_side(square, 0), mu));
  EXPECT_FALSE(spans_planar_wrenches({{0, 0}, {1, 0}}, {{0, 0}, {-1, 0}}, mu));
}

/// Whether three of the contacts' four extreme wrenches, none pulling, make up the given one.
bool bears(const PlanarContact& a, const PlanarContact& b, const Eigen::Vector3d& wrench) {
  std::array<Eigen::Vector3d, 4> extreme;
  std::size_t n = 0;
  for (const PlanarContact* contact : {&a, &b})
    for (const double side : {mu, -mu}) {
      const Vec2 force = contact->inward + side * left_of(contact->inward);
      extreme[n++] = {force.x, force.y, cross(contact->point, force)};
    }
  for (std::size_t out = 0; out < 4; ++out) {
    Eigen::Matrix3d columns;
    int column = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != out) columns.col(column++) = extreme[i];
    if (std::abs(columns.determinant()) < 1e-12) continue;
    if ((columns.inverse() * wrench).minCoeff() >= 0) return true;
  }
  return false;
}

TEST(PlanarWrenches, AgreeWithWhatRandomContactsBearAndWithTheConesOfTheirLine) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1), angle(-M_PI, M_PI);
  int closed = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto contact = [&] {
      const double turn = angle(random);
      return PlanarContact{{coordinate(random), coordinate(random)}, {std::cos(turn), std::sin(turn)}};
    };
    const PlanarContact a = contact(), b = contact();
    const bool holds = spans_planar_wrenches(a, b, mu);
    closed += holds;
    const Vec2 line = normalized(b.point - a.point);
    const double cosine = std::cos(cone_deg * degree), at_a = dot(line, a.inward), at_b = dot(line, b.inward);
    EXPECT_EQ(holds, (at_a > cosine && at_b < -cosine) || (at_a < -cosine && at_b > cosine));
    int borne = 0;
    for (int i = 0; i < 50; ++i)
      borne += bears(a, b, {coordinate(random), coordinate(random), coordinate(random)});
    if (holds) {
      EXPECT_EQ(borne, 50);
    } else {
      EXPECT_LT(borne, 50);
    }
  }
  EXPECT_GT(closed, 20);
}

}  // namespace
}  // namespace facet
