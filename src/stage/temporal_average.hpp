#pragma once

#include <vector>

#include "core/depth_noise.hpp"
#include "core/image_view.hpp"
#include "core/upload_depth.hpp"

namespace facet {

enum class TemporalMode {
  mean,    ///< paper eq. 3: mean of the valid readings
  robust,  ///< mean of the readings within three sigma of their median: no mixing across a moving edge
};

struct TemporalParams {
  bool enabled = true;
  TemporalMode mode = TemporalMode::robust;
  int frames = 5;          ///< window, the current frame included [frames], 1..16
  float max_gap_s = 0.2f;  ///< a window ends where the next frame is later by more [s], 0..3600; 0 = never
  /// A window ends where the camera's motion has changed the depths by more, as root mean square, in
  /// deviations of the sensor's noise [sigma], 0..100; 0 = never.
  float max_motion_sigmas = 0.07f;
};

inline constexpr int max_temporal_frames = 16;

/// Average of the readings of one pixel over the window; missing readings (0) do not count, and a pixel that
/// no frame saw stays missing.
struct TemporalAverageOp {
  static constexpr int radius = 0;
  int count;
  TemporalMode mode;
  DepthNoise noise;
  ImageView<float> out;
  ImageView<const float> frames[max_temporal_frames];

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    float readings[max_temporal_frames];
    int n = 0;
    for (int i = 0; i < count; ++i) {
      const float z = frames[i](x, y);
      if (z > 0) readings[n++] = z;
    }
    out(x, y) = mode == TemporalMode::mean ? mean_within(readings, n, 0, 1e30f) : robust_mean(readings, n);
  }

 private:
  FACET_HD float robust_mean(float* readings, int n) const {
    for (int i = 1; i < n; ++i) {  // insertion sort: at most 16 values
      const float z = readings[i];
      int k = i;
      for (; k > 0 && readings[k - 1] > z; --k) readings[k] = readings[k - 1];
      readings[k] = z;
    }
    const float median = n > 0 ? readings[n / 2] : 0;
    return mean_within(readings, n, median, 3 * noise.sigma_m(median));
  }
  FACET_HD static float mean_within(const float* readings, int n, float centre, float tolerance) {
    float sum = 0, kept = 0;
    for (int i = 0; i < n; ++i) {
      const float d = readings[i] - centre;
      if (d <= tolerance && d >= -tolerance) sum += readings[i], kept += 1;
    }
    return kept > 0 ? sum / kept : 0;
  }
};

/// The last frames of a sequence, kept on the executor's side.
template <class Executor>
class TemporalHistory {
 public:
  /// Adds a frame from host memory (see upload_depth()); with `window` frames kept it replaces the oldest. A
  /// frame of another size starts over.
  void push(Executor& executor, ImageView<const float> depth_m, int window,
            const std::optional<DepthCounts>& counts = std::nullopt) {
    if (count_ > 0 && frames_[0].size() != depth_m.size()) clear();
    int slot = oldest_;
    if (count_ < window) {
      slot = count_++;
      if (static_cast<std::size_t>(count_) > frames_.size()) frames_.emplace_back();
      frames_[slot].resize(depth_m.size());
    } else {
      oldest_ = (oldest_ + 1) % window;
    }
    upload_depth(executor, depth_m, counts, frames_[slot].view());
  }
  void clear() { count_ = oldest_ = 0; }
  int count() const { return count_; }
  ImageView<const float> frame(int i) const { return frames_[i].view(); }

 private:
  std::vector<typename Executor::template Image<float>> frames_;
  int count_ = 0;
  int oldest_ = 0;
};

/// Running average over the last frames, the current one included (paper eq. 3, section 3.4.2).
/// `history` already holds the current frame. Writes `out`.
template <class Executor>
void temporal_average(Executor& executor, const TemporalParams& params, const DepthNoise& noise,
                      const TemporalHistory<Executor>& history, ImageView<float> out) {
  TemporalAverageOp op{history.count(), params.mode, noise, out, {}};
  for (int i = 0; i < history.count(); ++i) op.frames[i] = history.frame(i);
  executor.for_each_pixel(out.size(), op);
}

}  // namespace facet
