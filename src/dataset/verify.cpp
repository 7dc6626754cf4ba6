#include "dataset/verify.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace facet {
namespace {

/// Sums that the shares of the report are made of.
struct PixelCount {
  std::size_t all = 0, missing = 0;
};

void count_size(Size size, DatasetReport& report) {
  const auto known = std::find_if(report.image_sizes.begin(), report.image_sizes.end(),
                                  [&](const DatasetReport::ImageSize& entry) { return entry.size == size; });
  if (known != report.image_sizes.end()) {
    ++known->frames;
  } else {
    report.image_sizes.push_back({size, 1});
  }
}

void extend_range(const Image<float>& depth_m, DatasetReport& report) {
  for (int y = 0; y < depth_m.height(); ++y) {
    for (int x = 0; x < depth_m.width(); ++x) {
      const float depth = depth_m(x, y);
      if (depth <= 0) continue;
      report.nearest_m = report.nearest_m > 0 ? std::min(report.nearest_m, depth) : depth;
      report.farthest_m = std::max(report.farthest_m, depth);
    }
  }
}

void add_frame(const Frame& frame, DatasetReport& report, PixelCount& pixels) {
  ++report.readable;
  report.with_color += !frame.color.empty();
  report.with_masks += frame.object_masks.has_value();
  count_size(frame.depth_m.size(), report);
  extend_range(frame.depth_m, report);
  pixels.all += static_cast<std::size_t>(frame.depth_m.size().area());
  pixels.missing += frame.missing_px;
}

}  // namespace

bool DatasetReport::is_whole() const {
  return problems.empty() && readable == frames &&
         std::all_of(groups.begin(), groups.end(),
                     [](const FrameGroup& group) { return group.absent.empty(); });
}

DatasetReport verify_dataset(const DatasetSpec& spec) {
  const auto dataset = open_dataset(spec);
  DatasetReport report;
  report.description = dataset->description();
  report.sensor = dataset->sensor();
  report.is_sequence = dataset->is_sequence();
  report.frames = dataset->size();
  PixelCount pixels;
  for (std::size_t i = 0; i < dataset->size(); ++i) {
    try {
      add_frame(dataset->load(i), report, pixels);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::data) throw;
      report.problems.push_back({dataset->frame_id(i), e.what()});
    }
  }
  if (pixels.all > 0)
    report.missing_share = static_cast<double>(pixels.missing) / static_cast<double>(pixels.all);
  if (const auto inspect = find_reader(spec.reader).inspect) inspect(spec, report);
  return report;
}

}  // namespace facet
