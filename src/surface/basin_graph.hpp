#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/counting_sort.hpp"
#include "core/disjoint_sets.hpp"
#include "core/host_threads.hpp"
#include "surface/basin_contacts.hpp"
#include "surface/basin_landscape.hpp"
#include "surface/patch_fit.hpp"
#include "surface/patch_seam.hpp"

namespace facet {

/// The border between two regions.
struct BasinBorder {
  int a = 0, b = 0;  ///< basins on its sides, a < b
  int length = 0;    ///< pairs of neighbours; 0 = gone: its sides are one, or another has it
  int known = 0;     ///< of these, where the strength is known
  float sum = 0;     ///< of the known strengths
  Seam seam{};       ///< points spread over the border

  /// Mean strength; unknown_strength where it is known along fewer than three pairs.
  float strength() const;
};

/// Basins and the borders between them, joined step by step. A region is named by its first basin; there is
/// one border between any two regions that touch. What is not linked by borders may be joined at the same
/// time.
class BasinGraph {
 public:
  /// `basin`: numbers below `count`, -1 = none; `contacts`: all between them, which are sorted.
  void build(HostThreads& threads, const BasinLandscape& landscape, ImageView<const std::int32_t> basin,
             int count, std::vector<BasinContact>& contacts);
  /// Makes one region of two. `touched` receives the borders that went from one to the other or grew.
  void join(int a, int b, std::vector<int>& touched);
  /// The region that a basin belongs to.
  int find(int i) { return sets_.find(i); }
  /// Calls visit(i) for every border of a region.
  template <class Visit>
  void for_each_border_of(int region, const Visit& visit) {
    int* link = &first_[static_cast<std::size_t>(region)];
    last_[static_cast<std::size_t>(region)] = -1;
    while (*link >= 0) {
      const int side = *link;
      int& next = next_[static_cast<std::size_t>(side)];
      if (border(side / 2).length == 0) {
        *link = next;
        continue;
      }
      visit(side / 2);
      last_[static_cast<std::size_t>(region)] = side;
      link = &next;
    }
  }
  /// The pixels of a region.
  const PatchMoments& moments(int region) const { return moments_[static_cast<std::size_t>(region)]; }
  BasinBorder& border(int i) { return borders_[static_cast<std::size_t>(i)]; }
  const std::vector<BasinBorder>& borders() const { return borders_; }

 private:
  static void collect_moments(const BasinLandscape& landscape, ImageView<const std::int32_t> basin,
                              int begin_y, int end_y, std::vector<PatchMoments>& moments);
  void collect_moments(HostThreads& threads, const BasinLandscape& landscape,
                       ImageView<const std::int32_t> basin, int count);
  void collect_borders(HostThreads& threads, const BasinLandscape& landscape,
                       std::span<const BasinContact> contacts);
  static BasinBorder border_of(const BasinLandscape& landscape, std::span<const BasinContact> contacts);
  void list_borders();
  int neighbour_across(int border_index, int region);
  int border_between(int a, int b);

  std::vector<PatchMoments> moments_, lower_moments_;
  DisjointSets sets_;
  std::vector<BasinBorder> borders_;
  // The borders of every region as a linked list of their sides: 2 i and 2 i + 1 are those of border i.
  std::vector<int> first_, last_;    ///< side by region, -1 = none
  std::vector<int> next_;            ///< side by side, -1 = none
  std::vector<int> degree_;          ///< by region, at least its number of borders
  std::vector<std::size_t> begins_;  ///< of the contacts of each border, and their end
  CountingSort<BasinContact> sort_;
};

}  // namespace facet
