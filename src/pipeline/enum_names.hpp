#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include "pipeline/params.hpp"

namespace facet {

/// Names of an enumeration's values, in order of the values, as configs spell them.
template <class Enum>
inline constexpr auto enum_names = nullptr;

template <>
inline constexpr auto enum_names<Sensor> = sensor_names;
template <>
inline constexpr std::array<std::string_view, 2> enum_names<TemporalMode>{"mean", "robust"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<FillPrefer>{"nearest", "far"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<WienerGain>{"paper", "lim"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<WienerNoise>{"sensor", "mean"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<GradientOperator>{"sobel", "central"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<DepthEdgeMode>{"jump", "canny"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<CreaseMode>{"normals", "paper", "gaussian"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<CreaseClosure>{"basins", "canny"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<CreaseAngle>{"atan2", "atan"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<Convexity>{"signed", "hessian"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<MorphologyMode>{"none", "bridge", "paper"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<PruningMode>{"stability", "gonzalez", "none"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<ContourMode>{"regions", "edge_map"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<PoseCentre>{"inliers", "contour"};

template <class Enum>
constexpr std::string_view enum_name(Enum value) {
  return enum_names<Enum>[static_cast<std::size_t>(value)];
}
template <class Enum>
constexpr std::optional<Enum> parse_enum(std::string_view name) {
  for (std::size_t i = 0; i < enum_names<Enum>.size(); ++i)
    if (enum_names<Enum>[i] == name) return static_cast<Enum>(i);
  return std::nullopt;
}

}  // namespace facet
