#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace facet {

/// Which blocks of rows the passes over a mask have to look at, up to eight kinds of passes that take turns:
/// those in or beside which a pixel went since that kind of pass was there. Keeps its memory.
class DueBlocks {
 public:
  /// Every block is due in every pass.
  void reset(int height) {
    height_ = height;
    due_.assign(static_cast<std::size_t>((height + block_rows - 1) / block_rows) + 2, 0xFF);
    found_.assign(due_.size(), 0);
  }

  /// A pass of kind `turn`. find(first, behind) finds what is to go from these rows and tells whether there
  /// is any, for all blocks that are due; then remove(first, behind) is called where there was. Returns
  /// whether there was any.
  template <class Find, class Remove>
  bool pass(int turn, const Find& find, const Remove& remove) {
    const auto bit = static_cast<std::uint8_t>(1u << turn);
    bool any = false;
    for_each_block([&](std::size_t block, int first, int behind) {
      found_[block] = (due_[block] & bit) != 0 && find(first, behind);
      due_[block] &= static_cast<std::uint8_t>(~bit);
    });
    for_each_block([&](std::size_t block, int first, int behind) {
      if (!found_[block]) return;
      remove(first, behind);
      due_[block - 1] = due_[block] = due_[block + 1] = 0xFF;
      any = true;
    });
    return any;
  }

 private:
  static constexpr int block_rows = 16;

  template <class Visit>
  void for_each_block(const Visit& visit) const {  // there is a block more on either side
    for (std::size_t block = 1; block + 1 < due_.size(); ++block) {
      const int first = (static_cast<int>(block) - 1) * block_rows;
      visit(block, first, std::min(first + block_rows, height_));
    }
  }

  int height_ = 0;
  std::vector<std::uint8_t> due_, found_;
};

}  // namespace facet
