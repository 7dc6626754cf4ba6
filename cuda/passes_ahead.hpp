#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>

namespace facet {

/// An iterated stage asks after every pass whether it changed anything, and ends with the first that did not.
/// On a device the answer is a while on its way. So that neither side waits, a stage is given at once as many
/// passes as it needed the last time, and asked then; further passes are begun before the answers for the
/// last ones are there. Those that turn out to be too many do no harm: a pass that changed nothing leaves
/// nothing to change for the next.
class PassesAhead {
 public:
  static constexpr std::size_t count = 2;  ///< passes whose answers are waited for while another runs
  static constexpr std::size_t slots = 64;
  /// Expected passes are a multiple of it, so that stages of about one length ask the same of the device.
  static constexpr std::size_t step = 4;

  /// Operations of a pass may raise the flag from here on.
  void begin() { is_open_ = true; }
  /// False between an iterated stage's passes and the next stage's first: the question stands for a clear
  /// start.
  bool is_open() const { return is_open_; }
  void restart() {
    is_open_ = false;
    passes_ = 0;
    stage_ = nullptr;
  }
  /// The first kernel of a stage tells which one it is.
  void note_kernel(const void* kernel) {
    if (stage_ == nullptr) stage_ = kernel;
  }
  /// Ends a pass: the slot that its answer goes to.
  std::size_t end() {
    is_open_ = false;
    return passes_++ % slots;
  }
  std::size_t last() const { return passes_ - 1; }  ///< pass that was ended
  /// Whether the device must be given what there is: not where more passes are expected.
  bool is_to_give() const { return passes_ >= expected(); }
  /// The pass whose answer is due now, nothing where the stage has only begun.
  std::optional<std::size_t> due() const {
    if (passes_ == expected()) return last();
    if (passes_ <= expected() + count) return std::nullopt;
    return last() - count;
  }
  /// The stage ended: pass `unchanging` changed nothing. has_changed(pass) tells of those before.
  template <class HasChanged>
  void ended(std::size_t unchanging, const HasChanged& has_changed) {
    const std::size_t earliest_known = passes_ > slots ? passes_ - slots : 0;
    while (unchanging > earliest_known && !has_changed(unchanging - 1)) --unchanging;
    expected_[stage_] = (unchanging + step) / step * step;
  }

 private:
  std::size_t expected() const {
    const auto found = expected_.find(stage_);
    return found == expected_.end() ? 0 : found->second;
  }

  bool is_open_ = false;
  std::size_t passes_ = 0;
  const void* stage_ = nullptr;
  std::unordered_map<const void*, std::size_t> expected_;
};

}  // namespace facet
