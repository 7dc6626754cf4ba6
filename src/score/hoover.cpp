#include "score/hoover.hpp"

namespace facet {
namespace {

enum class Kind { correct, over, under };

struct Instance {
  Kind kind = Kind::correct;
  std::vector<int> truth{}, regions{};
  double mean_share = 0;
};

/// The partners of one surface or region and the pixels that it shares with them.
struct Partners {
  std::vector<int> indices{};
  int common_px = 0;

  void add(int index, int px) {
    indices.push_back(index);
    common_px += px;
  }
};

struct Areas {
  const TruthLabels& truth;
  const PredictedRegions& predicted;

  int truth_px(int i) const { return truth.area_px[static_cast<std::size_t>(i)]; }
  int region_px(int i) const { return predicted.regions[static_cast<std::size_t>(i)].area_px; }
  Instance instance(Kind kind, std::vector<int> truth_side, std::vector<int> region_side,
                    int common_px) const {
    int truth_total = 0, region_total = 0;
    for (const int t : truth_side) truth_total += truth_px(t);
    for (const int r : region_side) region_total += region_px(r);
    const double mean = common_px * (1.0 / truth_total + 1.0 / region_total) / 2;
    return {kind, std::move(truth_side), std::move(region_side), mean};
  }
};

/// Every instance, correct ones first, then over-, then under-segmented ones.
std::vector<Instance> all_instances(const Areas& areas, const std::vector<Overlap>& overlaps,
                                    double tolerance) {
  const auto reaches = [tolerance](int common_px, int area_px) {
    return common_px >= tolerance * area_px - 1e-9;
  };
  std::vector<Instance> out;
  std::vector<Partners> of_truth(areas.truth.size()), of_region(areas.predicted.regions.size());
  for (const Overlap& o : overlaps) {
    const bool most_of_region = reaches(o.px, areas.region_px(o.b));
    const bool most_of_truth = reaches(o.px, areas.truth_px(o.a));
    if (most_of_region && most_of_truth) out.push_back(areas.instance(Kind::correct, {o.a}, {o.b}, o.px));
    if (most_of_region) of_truth[static_cast<std::size_t>(o.a)].add(o.b, o.px);
    if (most_of_truth) of_region[static_cast<std::size_t>(o.b)].add(o.a, o.px);
  }
  for (int t = 0; t < static_cast<int>(of_truth.size()); ++t) {
    const Partners& p = of_truth[static_cast<std::size_t>(t)];
    if (p.indices.size() > 1 && reaches(p.common_px, areas.truth_px(t)))
      out.push_back(areas.instance(Kind::over, {t}, p.indices, p.common_px));
  }
  for (int r = 0; r < static_cast<int>(of_region.size()); ++r) {
    const Partners& p = of_region[static_cast<std::size_t>(r)];
    if (p.indices.size() > 1 && reaches(p.common_px, areas.region_px(r)))
      out.push_back(areas.instance(Kind::under, p.indices, {r}, p.common_px));
  }
  return out;
}

void count(const Instance& instance, HooverCounts& counts) {
  if (instance.kind == Kind::correct) {
    ++counts.correct;
  } else if (instance.kind == Kind::over) {
    ++counts.over;
    counts.over_regions += static_cast<int>(instance.regions.size());
  } else {
    ++counts.under;
    counts.under_truth += static_cast<int>(instance.truth.size());
  }
}

}  // namespace

HooverCounts hoover_counts(const RegionComparison& comparison, double tolerance) {
  const TruthLabels& truth = comparison.truth;
  const std::vector<RegionClass>& classes = comparison.classes;
  std::vector<Overlap> compared;
  for (const Overlap& o : comparison.overlaps)
    if (is_compared(classes[static_cast<std::size_t>(o.b)])) compared.push_back(o);
  std::vector<Instance> instances = all_instances({truth, comparison.predicted}, compared, tolerance);
  std::stable_sort(instances.begin(), instances.end(),
                   [](const Instance& a, const Instance& b) { return a.mean_share > b.mean_share; });
  HooverCounts counts{
      .truth = static_cast<int>(truth.size()),
      .predicted = static_cast<int>(std::count_if(classes.begin(), classes.end(), is_compared))};
  std::vector<bool> truth_taken(truth.size(), false), region_taken(classes.size(), false);
  for (const Instance& instance : instances) {
    const auto taken = [](const std::vector<bool>& set, const std::vector<int>& indices) {
      return std::any_of(indices.begin(), indices.end(),
                         [&](int i) { return set[static_cast<std::size_t>(i)]; });
    };
    if (taken(truth_taken, instance.truth) || taken(region_taken, instance.regions)) continue;
    for (const int t : instance.truth) truth_taken[static_cast<std::size_t>(t)] = true;
    for (const int r : instance.regions) region_taken[static_cast<std::size_t>(r)] = true;
    count(instance, counts);
  }
  counts.missed = counts.truth - counts.correct - counts.over - counts.under_truth;
  counts.noise = counts.predicted - counts.correct - counts.over_regions - counts.under;
  return counts;
}

}  // namespace facet
