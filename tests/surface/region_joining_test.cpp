#include "surface/region_joining.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "core/image.hpp"

namespace facet {
namespace {

constexpr Size size{48, 16};
constexpr double unit = 1.0 / 4194304;
const Camera camera{200, 200, 23.5f, 7.5f};

/// Basins 8 px wide side by side, on a board at 1 m that turns by `turn` (change of q per pixel) in column 24
/// and with the given crease strength everywhere.
struct Board {
  Image<std::int32_t> basin{size}, inverse_depth{size};
  Image<float> strength;
  BasinGraph graph;
  std::vector<PatchFit> fits;
  std::vector<BorderJudgement> judgements;

  Board(double turn, float strength_everywhere, int barrier_x = -1) : strength(size, strength_everywhere) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        basin(x, y) = x == barrier_x ? -1 : x / 8;
        inverse_depth(x, y) = static_cast<std::int32_t>((1 - turn * std::max(x - 23.5, 0.0)) / unit);
      }
    const BasinLandscape landscape{basin.view(), inverse_depth.view(), unit, strength.view(), 0, camera};
    std::vector<BasinContact> contacts;
    collect_contacts(landscape, landscape.basin, 0, size.height, contacts);
    HostThreads one_thread;
    graph.build(one_thread, landscape, landscape.basin, 6, contacts);
    for (int i = 0; i < 6; ++i)
      fits.push_back(fit_region(graph.moments(i), {}, azure_kinect_noise(), camera.fx));
    judgements.resize(graph.borders().size());
  }
  /// Name of the region of every basin after joining across these borders.
  std::vector<int> joined(std::vector<int> borders, const MergeParams& params = {}) {
    RegionJoining().run({graph, fits, judgements, params, azure_kinect_noise(), double{camera.fx}}, borders);
    std::vector<int> names;
    for (int i = 0; i < 6; ++i) names.push_back(graph.find(i));
    return names;
  }
  std::vector<int> joined(const MergeParams& params = {}) {
    std::vector<int> all(graph.borders().size());
    std::iota(all.begin(), all.end(), 0);
    return joined(all, params);
  }
};

TEST(RegionJoining, JoinsWhatIsAlikeAndNoMore) {
  EXPECT_EQ(Board(0, 0.1f).joined(), std::vector<int>({0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(Board(0.01, 0.1f).joined(), std::vector<int>({0, 0, 0, 3, 3, 3})) << "63 degrees";
}

TEST(RegionJoining, StrongBordersAreJudgedTooWhenTheFacesAreSure) {
  EXPECT_EQ(Board(0, 1.5f).joined(), std::vector<int>({0, 0, 0, 0, 0, 0}));
}

TEST(RegionJoining, LeavesIslandsAloneWhoseBordersItIsNotGiven) {
  Board board(0, 0.1f, 23);
  ASSERT_EQ(board.graph.borders().size(), 4u);
  EXPECT_EQ(board.joined(std::vector<int>{}), std::vector<int>({0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(board.joined(std::vector<int>{2, 3}), std::vector<int>({0, 1, 2, 3, 3, 3}));
  EXPECT_EQ(board.joined(std::vector<int>{0, 1}), std::vector<int>({0, 0, 0, 3, 3, 3}));
}

TEST(RegionJoining, TheFitOfAJoinedRegionIsThatOfAllItsPixels) {
  Board board(0, 0.1f);
  board.joined();
  EXPECT_EQ(board.graph.moments(0).count(), size.area());
  EXPECT_NEAR(board.fits[0].at(20, 5).q, 1, 1e-5);
}

TEST(RegionJoining, TheAngleThatMakesACreaseIsAParameter) {
  MergeParams params;
  params.crease_deg = 80;
  params.step_ratio = 0.5f;
  EXPECT_EQ(Board(0.01, 0.1f).joined(params), std::vector<int>({0, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace facet
