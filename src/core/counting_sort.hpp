#pragma once

#include <cstddef>
#include <vector>

namespace facet {

/// Sorts by a whole number from 0 to key_count - 1 that key(item) gives; equal ones keep their order. Keeps
/// its memory.
template <class T>
class CountingSort {
 public:
  template <class Key>
  void operator()(std::vector<T>& items, int key_count, const Key& key) {
    place_.assign(static_cast<std::size_t>(key_count) + 1, 0);
    for (const T& item : items) ++place_[static_cast<std::size_t>(key(item)) + 1];
    for (std::size_t i = 1; i < place_.size(); ++i) place_[i] += place_[i - 1];
    sorted_.resize(items.size());
    for (const T& item : items)
      sorted_[static_cast<std::size_t>(place_[static_cast<std::size_t>(key(item))]++)] = item;
    items.swap(sorted_);
  }

 private:
  std::vector<T> sorted_;
  std::vector<int> place_;  ///< of the next item with that key
};

}  // namespace facet
