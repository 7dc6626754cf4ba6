#include "surface/basin_merging.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace facet {
namespace {

/// Pixels per independent reading: sensors correlate the noise of neighbouring pixels (block matching windows).
constexpr double pixels_per_reading = 20;
/// A border known along fewer pixels than this says nothing by itself; the fits decide.
constexpr double min_known_border_px = 3;

}  // namespace

void PlaneMoments::add(double px, double py, double pq) {
  n += 1, x += px, y += py, q += pq;
  xx += px * px, xy += px * py, yy += py * py;
  xq += px * pq, yq += py * pq, qq += pq * pq;
}

PlaneMoments& PlaneMoments::operator+=(const PlaneMoments& o) {
  n += o.n, x += o.x, y += o.y, q += o.q;
  xx += o.xx, xy += o.xy, yy += o.yy;
  xq += o.xq, yq += o.yq, qq += o.qq;
  return *this;
}

double PlaneMoments::residual() const {
  if (n < 4) return 0;
  const double mx = x / n, my = y / n, mq = q / n;
  const double sxx = xx - n * mx * mx, sxy = xy - n * mx * my, syy = yy - n * my * my;
  const double sxq = xq - n * mx * mq, syq = yq - n * my * mq, sqq = qq - n * mq * mq;
  const double det = sxx * syy - sxy * sxy;
  if (det < 1e-9 * n) return std::max(0.0, sqq);
  const double a = (sxq * syy - syq * sxy) / det, b = (syq * sxx - sxq * sxy) / det;
  return std::max(0.0, sqq - a * sxq - b * syq);
}

bool BasinMerging::Candidate::operator<(const Candidate& other) const {
  return std::tie(rise, a, b) > std::tie(other.rise, other.a, other.b);
}

int BasinMerging::find(int i) {
  auto at = [&](int k) -> int& { return basins_[static_cast<std::size_t>(k)].parent; };
  while (at(i) != i) i = at(i) = at(at(i));
  return i;
}

void BasinMerging::add_border_pair(const BasinLandscape& l, int a, int b, int x0, int y0, int x1, int y1) {
  auto& of_a = basins_[static_cast<std::size_t>(a)].border_with;
  const auto [place, is_new] = of_a.try_emplace(b, static_cast<int>(borders_.size()));
  if (is_new) {
    borders_.emplace_back();
    basins_[static_cast<std::size_t>(b)].border_with.emplace(a, place->second);
  }
  Border& border = borders_[static_cast<std::size_t>(place->second)];
  ++border.length_px;
  if (l.distance_px(x0, y0) <= l.guard_px || l.distance_px(x1, y1) <= l.guard_px) return;
  border.strength_sum += std::max(l.strength(x0, y0), l.strength(x1, y1));
  border.strength_count += 1;
}

void BasinMerging::collect(const BasinLandscape& l) {
  const int width = l.basin.width, height = l.basin.height;
  basins_.clear();
  borders_.clear();
  index_.assign(static_cast<std::size_t>(l.basin.size().area()), -1);
  const auto index_at = [&](int x, int y) {
    const std::int32_t name = l.basin(x, y);
    return name < 0 ? -1 : index_[static_cast<std::size_t>(name)];
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::int32_t name = l.basin(x, y);
      if (name < 0) continue;
      std::int32_t& index = index_[static_cast<std::size_t>(name)];
      if (index < 0) {
        index = static_cast<std::int32_t>(basins_.size());
        basins_.emplace_back();
        basins_.back().parent = index;
        basins_.back().name = name;
      }
      Basin& basin = basins_[static_cast<std::size_t>(index)];
      basin.moments.add(x - 0.5 * width, y - 0.5 * height, 1.0 / l.depth_m(x, y));
      if (l.distance_px(x, y) <= l.guard_px) continue;
      basin.strength_sum += l.strength(x, y);
      basin.strength_count += 1;
    }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int own = index_at(x, y);
      if (own < 0) continue;
      const int right = x + 1 < width ? index_at(x + 1, y) : -1, below = y + 1 < height ? index_at(x, y + 1) : -1;
      if (right >= 0 && right != own) add_border_pair(l, own, right, x, y, x + 1, y);
      if (below >= 0 && below != own) add_border_pair(l, own, below, x, y, x, y + 1);
    }
}

float BasinMerging::rise_of(int a, int b, const Border& border) const {
  if (border.strength_count < min_known_border_px) return 0;
  const auto inside = [&](int i) {
    const Basin& basin = basins_[static_cast<std::size_t>(i)];
    return basin.strength_count > 0 ? basin.strength_sum / basin.strength_count : 0.0;
  };
  return static_cast<float>(border.strength_sum / border.strength_count - std::max(inside(a), inside(b)));
}

void BasinMerging::consider(int a, int b) {
  if (a > b) std::swap(a, b);
  const Basin& first = basins_[static_cast<std::size_t>(a)];
  const Basin& second = basins_[static_cast<std::size_t>(b)];
  const Border& border = borders_[static_cast<std::size_t>(first.border_with.at(b))];
  queue_.push({rise_of(a, b, border), a, b, first.version, second.version});
}

bool BasinMerging::is_crease(const Candidate& c) {
  const Basin& a = basins_[static_cast<std::size_t>(c.a)];
  const Basin& b = basins_[static_cast<std::size_t>(c.b)];
  const Border& border = borders_[static_cast<std::size_t>(a.border_with.at(c.b))];
  const float least_rise = 2 * std::sin(criteria_.rise_deg / 2 / 57.29578f);
  const bool known = border.strength_count >= min_known_border_px;
  if (known && c.rise < least_rise) return false;
  PlaneMoments both = a.moments;
  both += b.moments;
  const double gain = both.residual() - a.moments.residual() - b.moments.residual();
  const double q = both.q / both.n;  // mean inverse depth; noise of q = noise of z times q^2
  const double sigma = noise_.sigma_m(static_cast<float>(1 / q)) * q * q;
  return gain / 3 / (sigma * sigma * pixels_per_reading) >= criteria_.fit_ratio;
}

void BasinMerging::unite(int a, int b) {
  if (basins_[static_cast<std::size_t>(a)].border_with.size() < basins_[static_cast<std::size_t>(b)].border_with.size())
    std::swap(a, b);
  Basin& into = basins_[static_cast<std::size_t>(a)];
  Basin& from = basins_[static_cast<std::size_t>(b)];
  from.parent = a;
  ++into.version;
  into.name = std::min(into.name, from.name);
  into.strength_sum += from.strength_sum;
  into.strength_count += from.strength_count;
  into.moments += from.moments;
  into.border_with.erase(b);
  from.border_with.erase(a);
  for (const auto& [other, border] : from.border_with) {
    auto& of_other = basins_[static_cast<std::size_t>(other)].border_with;
    of_other.erase(b);
    const auto [place, is_new] = into.border_with.try_emplace(other, border);
    if (is_new) {
      of_other.emplace(a, border);
      continue;
    }
    Border& joined = borders_[static_cast<std::size_t>(place->second)];
    const Border& added = borders_[static_cast<std::size_t>(border)];
    joined.strength_sum += added.strength_sum;
    joined.strength_count += added.strength_count;
    joined.length_px += added.length_px;
  }
  from.border_with.clear();
  for (const auto& [other, border] : into.border_with) consider(a, other);
}

void BasinMerging::merge(const BasinLandscape& l, const MergeCriteria& criteria, const DepthNoise& noise,
                         Image<std::int32_t>& region) {
  criteria_ = criteria;
  noise_ = noise;
  collect(l);
  queue_ = {};
  for (int i = 0; i < static_cast<int>(basins_.size()); ++i)
    for (const auto& [other, border] : basins_[static_cast<std::size_t>(i)].border_with)
      if (i < other) consider(i, other);
  while (!queue_.empty()) {
    const Candidate c = queue_.top();
    queue_.pop();
    const Basin& a = basins_[static_cast<std::size_t>(c.a)];
    const Basin& b = basins_[static_cast<std::size_t>(c.b)];
    const bool stale = a.parent != c.a || b.parent != c.b || a.version != c.version_a || b.version != c.version_b;
    if (!stale && !is_crease(c)) unite(c.a, c.b);
  }
  region.resize(l.basin.size());
  for (int y = 0; y < l.basin.height; ++y)
    for (int x = 0; x < l.basin.width; ++x) {
      const std::int32_t name = l.basin(x, y);
      region(x, y) = name < 0 ? -1 : basins_[static_cast<std::size_t>(find(index_[static_cast<std::size_t>(name)]))].name;
    }
}

}  // namespace facet
