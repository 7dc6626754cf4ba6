#pragma once

#include <cmath>

namespace facet {

/// 2-vector in some plane: the image [px] or that of a surface [m].
struct Vec2 {
  double x = 0, y = 0;

  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive where b lies on the side of y, seen from a = x.
inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}
/// Unit vector along `a`; the zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : Vec2{};
}
/// `a` turned by a right angle, x towards y.
inline Vec2 left_of(Vec2 a) {
  return {-a.y, a.x};
}

}  // namespace facet
