#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image_view.hpp"
#include "surface/pose.hpp"
#include "surface/regions.hpp"
#include "surface/support_params.hpp"
#include "surface/surface_borders.hpp"

namespace facet {

/// What the support is found from and joined in.
struct SupportInput {
  ImageView<std::uint16_t> labels;
  ImageView<std::uint8_t> edges;
  const RegionPixels& pixels;  ///< of the labels
  Camera camera;
  DepthNoise noise;
  PoseParams pose;  ///< how planes are fitted
  std::uint64_t seed = 0;
};

/// The surface that the objects stand on: the largest plane that faces up and from which more of its
/// touching neighbours rise than fall away. Occluders cut it into pieces; those in its plane become one label
/// again. Other surfaces stay apart even in one plane: faces of two boxes may be flush. Keeps its memory
/// between frames.
class Support {
 public:
  /// Finds the support and joins its pieces: their pixels get its label, creases between them vanish from the
  /// edges, labels stay 1 ... n. Returns n.
  int unite(const SupportInput& input, const SupportParams& params);
  /// The support's plane; empty where none was found.
  const std::optional<Plane>& plane() const { return plane_; }
  /// The support's label in a later numbering of the same pixels, 0 = none.
  int label_in(ImageView<const std::uint16_t> labels) const;

 private:
  bool is_supporting(const SupportInput& input, int label) const;
  void find(const SupportInput& input, const SupportParams& params);
  void find_pieces(const SupportInput& input, const SupportParams& params);
  void relabel(const SupportInput& input);

  std::optional<Plane> plane_;
  int label_ = 0;
  int place_ = 0;  ///< raster index of one of its pixels
  SurfaceBorders borders_;
  std::vector<int> by_area_;              ///< labels, largest first
  std::vector<std::uint16_t> new_label_;  ///< by label
  int count_ = 0;                         ///< of new labels
};

}  // namespace facet
