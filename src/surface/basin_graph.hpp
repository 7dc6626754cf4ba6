#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/camera.hpp"
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
};

/// A basin, or several that were joined.
struct Basin {
  int parent = 0;                   ///< union-find over basins
  std::int32_t name = 0;            ///< the smallest of the names of its basins
  float lowest = unknown_strength;  ///< of the known strengths inside
  PatchMoments moments;
};

/// The border between two regions.
struct BasinBorder {
  static constexpr std::size_t most_points = 12;

  int a = 0, b = 0;                 ///< a < b
  int length = 0;                   ///< pairs of neighbours
  int known = 0;                    ///< of these, where the strength is known
  float sum = 0;                    ///< of the known strengths
  float lowest = unknown_strength;  ///< of the known strengths
  int points = 0;
  std::array<SeamPoint, most_points> point{};  ///< spread over the border

  std::span<const SeamPoint> seam() const { return {point.data(), static_cast<std::size_t>(points)}; }
  /// Mean strength; unknown_strength where it is known along fewer than three pairs.
  float strength() const;
};

/// Basins and the borders between them, joined step by step.
class BasinGraph {
 public:
  void build(const BasinLandscape& landscape);
  /// Joins the region named by basin `b` to that of `a`; both are their own parents.
  void join(int a, int b);
  int find(int i);
  /// Names the sides of every border by their present regions, drops borders inside a region and joins those
  /// between the same two. Afterwards they are in order of (a, b).
  void update_borders();
  /// Names of the regions, per pixel.
  void write_regions(const BasinLandscape& landscape, ImageView<std::int32_t> region);

  Basin& basin(int i) { return basins_[static_cast<std::size_t>(i)]; }
  const Basin& basin(int i) const { return basins_[static_cast<std::size_t>(i)]; }
  int basin_count() const { return static_cast<int>(basins_.size()); }
  std::vector<BasinBorder>& borders() { return borders_; }

 private:
  struct Contact {
    int a, b;
    int place;  ///< raster index, twice, plus the direction
    float strength;
  };
  struct Place {
    int a, b;
    int index;
  };
  void collect_basins(const BasinLandscape& landscape);
  void collect_contacts(const BasinLandscape& landscape);
  void collect_borders(const BasinLandscape& landscape);
  static BasinBorder border_of(const BasinLandscape& landscape, std::span<const Contact> contacts);

  std::vector<Basin> basins_;
  std::vector<BasinBorder> borders_, joined_, parts_;
  std::vector<Place> order_;
  std::vector<Contact> contacts_;    ///< pairs of neighbours in different basins
  std::vector<std::int32_t> index_;  ///< basin index by raster index of its name
};

}  // namespace facet
