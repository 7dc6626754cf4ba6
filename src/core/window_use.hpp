#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace facet {

/// Why a window of frames began with the frame it is asked for.
enum class WindowStart {
  continued,  ///< it did not: the frame joined those before it
  first,      ///< nothing was before it
  size,       ///< the frame before had another size
  gap,        ///< too long since the frame before, or time ran backwards
  motion,     ///< the camera has moved
};
/// Their names, in order of the values.
inline constexpr std::array<std::string_view, 5> window_start_names{"continued", "first", "size", "gap",
                                                                    "motion"};

/// Which frames a result was computed from: the current one and those before it.
struct WindowUse {
  int frames = 1;
  WindowStart start = WindowStart::first;
  std::optional<double> mean_age_s{};  ///< of the frames; nothing where their times are not known
};

}  // namespace facet
