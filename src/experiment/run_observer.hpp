#pragma once

#include <cstddef>
#include <string>

#include "record/frame_row.hpp"

namespace facet {

/// Told how a run goes on; calls come one at a time, from any thread.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  virtual void on_note(const std::string& text) = 0;
  virtual void on_frame(const FrameRow& row, std::size_t done, std::size_t planned) = 0;
  /// `what` names the step: frames read, timing, ...
  virtual void on_step(const std::string& what, std::size_t done, std::size_t planned) = 0;
};

}  // namespace facet
