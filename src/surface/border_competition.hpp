#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/host_threads.hpp"
#include "core/image_view.hpp"
#include "surface/basin_graph.hpp"
#include "surface/patch_fit.hpp"

namespace facet {

/// What regions compete with.
struct Competition {
  const BasinLandscape& landscape;
  std::span<const PatchFit> patches;  ///< by region
  DepthNoise noise;
  double sigmas = 0;  ///< a gain of fewer deviations of a reading is noise
};

/// Moves borders between regions to where their patches meet, which is where the crease is: a pixel changes
/// to the neighbouring region whose patch explains the readings around it best, if by more than noise.
class BorderCompetition {
 public:
  /// Borders move by `passes` pixels at most. `region`: per pixel, -1 = none; such pixels stay so.
  void run(HostThreads& threads, const Competition& competition, int passes, ImageView<std::int32_t> region);

 private:
  struct Move {
    int pixel;
    std::int32_t region;
  };
  /// What one worker finds.
  struct Part {
    std::vector<int> pixels;
    std::vector<Move> moves;
  };
  void list(int pixel, std::vector<int>& pixels);
  void list_border_pixels(HostThreads& threads, ImageView<const std::int32_t> region);
  void list_pixels_around_moves(Size size);
  void find_moves(HostThreads& threads, const Competition& competition, ImageView<const std::int32_t> region);

  std::vector<int> pixels_;           ///< to look at in this pass
  std::vector<std::uint8_t> listed_;  ///< by pixel
  std::vector<Part> parts_;
};

}  // namespace facet
