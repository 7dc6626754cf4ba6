#include "cpu/tuned/fill_missing.hpp"

#include "cpu/tuned/edge_list.hpp"

namespace facet {
namespace {

constexpr std::uint8_t waiting = 2;  ///< open pixel that stands in the list already

/// Runs of missing pixels between two measured ones, along rows and along columns, no longer than the limit.
void mark_narrow_holes(ImageView<const float> depth_m, int max_hole_px, std::vector<int>& run_start,
                       ImageView<std::uint8_t> open) {
  const int width = depth_m.width;
  run_start.assign(static_cast<std::size_t>(width),
                   -1);  // first row of the column's current run; -1: none bounded
  for (int y = 0; y < depth_m.height; ++y) {
    int row_run = -1;
    for (int x = 0; x < width; ++x) {
      int& column_run = run_start[static_cast<std::size_t>(x)];
      if (!(depth_m(x, y) > 0)) continue;
      if (row_run >= 0 && x - row_run - 1 <= max_hole_px)
        for (int k = row_run + 1; k < x; ++k) open(k, y) = 1;
      if (column_run >= 0 && y - column_run - 1 <= max_hole_px)
        for (int k = column_run + 1; k < y; ++k) open(x, k) = 1;
      row_run = x;
      column_run = y;
    }
  }
}

void mark_open(const FillParams& params, ImageView<const float> depth_m, std::vector<int>& run_start,
               ImageView<std::uint8_t> open) {
  for (int y = 0; y < open.height; ++y)
    for (int x = 0; x < open.width; ++x) open(x, y) = params.max_hole_px == 0 && !(depth_m(x, y) > 0);
  if (params.max_hole_px > 0) mark_narrow_holes(depth_m, params.max_hole_px, run_start, open);
}

void mark_rims(const FillParams& params, ImageView<const float> depth_m, ImageView<std::uint8_t> rim) {
  for (int y = 0; y < rim.height; ++y) std::fill_n(rim.row(y), rim.width, std::uint8_t{0});
  if (params.prefer != FillPrefer::far) return;
  const FillRimOp op{depth_m, params.rim_jump, params.rim_search_px, rim};
  for (int y = 0; y < rim.height; ++y)
    for (int x = 0; x < rim.width; ++x) {
      if (depth_m(x, y) > 0) continue;
      for (int i = 0; i < 8; ++i) {
        const int bx = x + neighbour8(i).dx, by = y + neighbour8(i).dy;
        if (rim.size().contains(bx, by) && depth_m(bx, by) > 0 && !rim(bx, by)) op(bx, by, GuardedAccess{});
      }
    }
}

/// Sources, window means and offers of the current pass on images padded by two pixels, so that windows
/// around sources at the image's edge need no border test. Means and offers are computed once per pass.
class SharedOffers {
 public:
  SharedOffers(const FillCandidate& candidate, CpuScratch& scratch)
      : source_(scratch.values), mean_(scratch.means), offer_(scratch.offers), stamp_(scratch.stamps) {
    const Size size{candidate.depth_m.width + 2 * pad, candidate.depth_m.height + 2 * pad};
    source_.resize(size);
    mean_.resize(size);
    offer_.resize(size);
    stamp_.resize(size);
    source_.fill(0);
    stamp_.fill({-1, -1});
    for (int y = 0; y < candidate.depth_m.height; ++y)
      for (int x = 0; x < candidate.depth_m.width; ++x)
        source_(x + pad, y + pad) = candidate.rim(x, y) ? 0 : candidate.depth_m(x, y);
  }
  void start_pass(int pass) { pass_ = pass; }
  void add_source(int x, int y, float depth_m) { source_(x + pad, y + pad) = depth_m; }
  bool has_source(int x, int y) const {
    for (int i = 0; i < 8; ++i)
      if (source_(x + pad + neighbour8(i).dx, y + pad + neighbour8(i).dy) > 0) return true;
    return false;
  }
  float best_mean(int x, int y) {
    FillOffer best;
    for (int i = 0; i < 8; ++i) {
      const int bx = x + pad + neighbour8(i).dx, by = y + pad + neighbour8(i).dy;
      const float b = source_(bx, by);
      if (b > 0) best.take_better(offer(bx, by, b));
    }
    return best.mean_m;
  }

 private:
  static constexpr int pad = 2;

  const FillOffer& offer(int x, int y, float b_m) {
    if (stamp_(x, y).offer == pass_) return offer_(x, y);
    stamp_(x, y).offer = pass_;
    FillOffer best;
    for (int wy = y - 1; wy <= y + 1; ++wy)
      for (int wx = x - 1; wx <= x + 1; ++wx) {
        const float mean = window_mean(wx, wy);
        best.take_better({mean, mean > b_m ? mean - b_m : b_m - mean});
      }
    return offer_(x, y) = best;
  }
  float window_mean(int x, int y) {
    if (stamp_(x, y).mean == pass_) return mean_(x, y);
    stamp_(x, y).mean = pass_;
    float sum = 0, n = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      const float* row = source_.row(y + dy) + x;
      for (int dx = -1; dx <= 1; ++dx) {
        sum += row[dx];
        n += row[dx] > 0 ? 1.0f : 0.0f;
      }
    }
    return mean_(x, y) = sum / n;
  }

  Image<float>&source_, &mean_;
  Image<FillOffer>& offer_;
  Image<PassStamp>& stamp_;
  int pass_ = 0;
};

}  // namespace

void fill_missing(CpuExecutor& executor, const FillParams& params, ImageView<float> depth_m,
                  ImageView<std::uint8_t> filled, const FillScratch& scratch) {
  CpuScratch& memory = executor.scratch();
  mark_open(params, depth_m, memory.row_starts, scratch.open);
  mark_rims(params, depth_m, scratch.rim);
  executor.fill(filled, std::uint8_t{0});

  SharedOffers offers({depth_m, scratch.rim}, memory);
  std::vector<int>&front = memory.list_a, &next = memory.list_b;
  list_set_pixels(scratch.open, next);
  front.clear();
  for (const int i : next)
    if (offers.has_source(x_of(i), y_of(i))) front.push_back(i);
  for (int pass = 0; pass < params.max_passes && !front.empty(); ++pass) {
    offers.start_pass(pass);
    for (const int i : front) {
      const int x = x_of(i), y = y_of(i);
      scratch.proposal_m(x, y) = offers.best_mean(x, y);
    }
    next.clear();
    for (const int i : front) {
      const int x = x_of(i), y = y_of(i);
      depth_m(x, y) = scratch.proposal_m(x, y);
      offers.add_source(x, y, depth_m(x, y));
      scratch.open(x, y) = 0;
      filled(x, y) = 1;
    }
    for (const int i : front)
      for_each_set_neighbour(scratch.open, i, [&](int x, int y) {
        if (scratch.open(x, y) == waiting) return;
        scratch.open(x, y) = waiting;
        next.push_back(listed(x, y));
      });
    std::swap(front, next);
  }
}

}  // namespace facet
