#pragma once

#include <optional>

namespace facet {

/// An iterated stage asks after every pass whether it changed anything, and ends with the first that did not.
/// On a device the answer is a while on its way. So that neither side waits, a pass is begun before the
/// answers for the last ones are there. Those that turn out to be too many do no harm: a pass that changed
/// nothing leaves nothing to change for the next.
class PassesAhead {
 public:
  static constexpr int count = 2;  ///< passes whose answers are waited for while another runs
  static constexpr int slots = count + 1;

  /// Operations of a pass may raise the flag from here on.
  void begin() { is_open_ = true; }
  /// False between an iterated stage's passes and the next stage's first: the question stands for a clear
  /// start.
  bool is_open() const { return is_open_; }
  void restart() {
    is_open_ = false;
    passes_ = 0;
  }
  /// Ends a pass: the slot that its answer goes to.
  int end() {
    is_open_ = false;
    return passes_++ % slots;
  }
  /// The slot of the answer that is due now, nothing where the stage has only begun.
  std::optional<int> due() const {
    if (passes_ <= count) return std::nullopt;
    return (passes_ - 1 - count) % slots;
  }

 private:
  bool is_open_ = false;
  int passes_ = 0;
};

}  // namespace facet
