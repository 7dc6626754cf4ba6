#include "surface/basin_merging.hpp"

#include <utility>

#include "surface/renumber.hpp"

namespace facet {
namespace {

/// Basins of fewer independent readings than this may be noise.
constexpr double min_readings = 5;
/// Where no strength is known, that few readings tell no crease: a patch of them is what its prior says.
constexpr double blind_readings = 1.5;

}  // namespace

void BasinMerging::merge(HostThreads& threads, const BasinLandscape& landscape, const MergeParams& params,
                         const DepthNoise& noise, Image<std::int32_t>& region) {
  const double px = double{noise.pixels_per_reading};
  const int count = shallow_.join(
      threads, landscape,
      {min_readings * px, blind_readings * px, double{params.step_ratio}, double{params.fit_sigmas}, noise},
      region, contacts_);
  const ImageView<const std::int32_t> numbers = std::as_const(region).view();
  graph_.build(threads, landscape, numbers, count, contacts_);

  const auto focal_px = static_cast<double>(landscape.camera.fx);
  fits_.resize(static_cast<std::size_t>(count));
  constexpr std::size_t least_fits = 256;  // a tenth of a millisecond
  threads.for_each_part(fits_.size(), least_fits, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      fits_[i] = fit_region(graph_.moments(static_cast<int>(i)), params, noise, focal_px);
  });

  judgements_.assign(graph_.borders().size(), {});
  const auto& lots = lots_.cast(graph_.borders(), count, threads.workers());
  joinings_.resize(lots.size());
  threads.share_out(threads.workers(), [&](int lot, int) {
    const auto i = static_cast<std::size_t>(lot);
    joinings_[i].run({graph_, fits_, judgements_, params, noise, focal_px}, lots[i]);
  });

  first_of_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) first_of_[static_cast<std::size_t>(i)] = graph_.find(i);
  renumber(threads, numbers, first_of_, region.view());
  competition_.run(threads, {landscape, fits_, noise, double{params.fit_sigmas}}, params.border_moves_px,
                   region.view());
}

}  // namespace facet
