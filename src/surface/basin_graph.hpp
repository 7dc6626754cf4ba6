#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/camera.hpp"
#include "core/disjoint_sets.hpp"
#include "core/image.hpp"
#include "surface/patch_fit.hpp"
#include "surface/patch_seam.hpp"

namespace facet {

/// Above every strength.
inline constexpr float unknown_strength = 9.0f;

/// The over-segmentation into basins and what it was made from.
struct BasinLandscape {
  ImageView<const std::int32_t> basin;          ///< raster index naming the basin, -1 = none
  ImageView<const std::int32_t> inverse_depth;  ///< fixed point, as stage/normals.hpp makes it; unit below
  double inverse_depth_unit = 1;                ///< 1/m per step
  ImageView<const float> strength;              ///< crease strength, chord of the angle
  ImageView<const std::uint8_t> distance_px;
  int guard_px = 0;  ///< strength is known where the distance is larger
  float floor = 0;   ///< differences of strength below this are noise
  Camera camera;

  double q(int x, int y) const { return inverse_depth_unit * inverse_depth(x, y); }  ///< inverse depth [1/m]
};

/// A basin, or several that were joined.
struct Basin {
  float lowest = unknown_strength;  ///< of the known strengths inside
  PatchMoments moments;
};

/// The border between two regions.
struct BasinBorder {
  static constexpr std::size_t most_points = 12;

  int a = 0, b = 0;                 ///< basins on its sides, a < b
  int length = 0;                   ///< pairs of neighbours; 0 = gone: its sides are one, or another has it
  int known = 0;                    ///< of these, where the strength is known
  float sum = 0;                    ///< of the known strengths
  float lowest = unknown_strength;  ///< of the known strengths
  int points = 0;
  std::array<SeamPoint, most_points> point{};  ///< spread over the border

  std::span<const SeamPoint> seam() const { return {point.data(), static_cast<std::size_t>(points)}; }
  /// Mean strength; unknown_strength where it is known along fewer than three pairs.
  float strength() const;
};

/// Basins and the borders between them, joined step by step. A region is named by its first basin; there is
/// one border between any two regions that touch.
class BasinGraph {
 public:
  void build(const BasinLandscape& landscape);
  /// Makes one region of two. Returns the borders that went from one to the other or grew; valid until the
  /// next call.
  std::span<const int> join(int a, int b);
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
  /// Regions as find() names them, per pixel, -1 = none.
  void write_regions(const BasinLandscape& landscape, ImageView<std::int32_t> region);

  Basin& basin(int i) { return basins_[static_cast<std::size_t>(i)]; }
  const Basin& basin(int i) const { return basins_[static_cast<std::size_t>(i)]; }
  int basin_count() const { return static_cast<int>(basins_.size()); }
  BasinBorder& border(int i) { return borders_[static_cast<std::size_t>(i)]; }
  const std::vector<BasinBorder>& borders() const { return borders_; }

 private:
  struct Contact {
    int a, b;
    int place;  ///< raster index, twice, plus the direction
    float strength;
  };
  void collect_basins(const BasinLandscape& landscape);
  void collect_contacts(const BasinLandscape& landscape);
  void collect_borders(const BasinLandscape& landscape);
  static BasinBorder border_of(const BasinLandscape& landscape, std::span<const Contact> contacts);
  void list_borders();
  int neighbour_across(int border_index, int region);
  int border_between(int a, int b);

  std::vector<Basin> basins_;
  DisjointSets sets_;
  std::vector<BasinBorder> borders_;
  // The borders of every region as a linked list of their sides: 2 i and 2 i + 1 are those of border i.
  std::vector<int> first_, last_;  ///< side by region, -1 = none
  std::vector<int> next_;          ///< side by side, -1 = none
  std::vector<int> degree_;        ///< by region, at least its number of borders
  std::vector<int> touched_;
  std::vector<Contact> contacts_;    ///< pairs of neighbours in different basins
  std::vector<std::int32_t> index_;  ///< basin index by raster index of its name
};

}  // namespace facet
