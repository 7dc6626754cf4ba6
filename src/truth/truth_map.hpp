#pragma once

#include <cstdint>
#include <vector>

#include "core/image.hpp"
#include "truth/truth.hpp"

namespace facet {

/// What a pixel is in the truth.
enum class TruthRegion : std::uint8_t {
  background,  ///< neither surface nor support nor void: room, floor, walls
  surface,     ///< of a surface that counts
  support,     ///< the table top
  ignored,     ///< void: taken out of truth and prediction before any overlap
};

/// The truth of a frame by pixel.
struct TruthMap {
  Image<std::uint16_t> surfaces;  ///< index in Truth::surfaces + 1, 0 = none; void pixels removed
  Image<TruthRegion> regions;
  std::vector<int> area_px;          ///< per surface, after overlap and void removal
  std::vector<bool> surface_counts;  ///< false: void, fewer than counted_surface_px pixels remain
  Image<std::uint16_t> drawn;        ///< as `surfaces`, before void pixels are removed
};

/// Rasterises the polygons and applies the void rules. `object_masks` (visible objects, 0 = none) and
/// `depth_m` (raw, 0 = missing) may be empty; where given they must have the size of the truth, Error{data}
/// otherwise. Void are the pixels of ignore polygons, of objects covered by no surface polygon, without depth
/// outside every surface and support polygon, and of surfaces that do not count.
TruthMap rasterise(const Truth& truth, const Image<std::uint16_t>& object_masks, const Image<float>& depth_m);

}  // namespace facet
