#include "stage/gradient.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"
#include "support/mat.hpp"

namespace facet {
namespace {

constexpr GradientOperator operators[]{GradientOperator::sobel, GradientOperator::central};

struct Gradient {
  Image<float> x, y;
};
Gradient gradient_of(const Image<float>& depth_m, GradientOperator op) {
  CpuExecutor executor;
  Gradient g{Image<float>(depth_m.size()), Image<float>(depth_m.size())};
  gradient(executor, {op}, depth_m.view(), g.x.view(), g.y.view());
  return g;
}

TEST(Gradient, OfAConstantIsZeroUpToTheBordersAndAroundHoles) {
  const auto depth =
      make_image<float>({33, 9}, [](int x, int y) { return (x * 7 + y * 3) % 11 == 0 ? 0.0 : 1.3; });
  for (const GradientOperator op : operators) {
    const Gradient g = gradient_of(depth, op);
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 33; ++x) {
        EXPECT_EQ(g.x(x, y), 0);
        EXPECT_EQ(g.y(x, y), 0);
      }
  }
}

TEST(Gradient, OfARampIsItsSlopeInMetresPerPixel) {
  const auto ramp = make_image<float>({33, 9}, [](int x, int y) { return 1.0 + 0.004 * x - 0.007 * y; });
  for (const GradientOperator op : operators) {
    const Gradient g = gradient_of(ramp, op);
    for (int y = 1; y < 8; ++y)
      for (int x = 1; x < 32; ++x) {
        EXPECT_NEAR(g.x(x, y), 0.004, 1e-6);
        EXPECT_NEAR(g.y(x, y), -0.007, 1e-6);
      }
  }
}

TEST(Gradient, EqualsOpenCVsSobelWhereNothingIsMissing) {
  Image<float> depth = random_depth_without_holes({61, 43}, 3);
  cv::Mat_<float> expected_x, expected_y;
  cv::Sobel(as_mat(depth), expected_x, CV_32F, 1, 0, 3, 1.0 / 8, 0, cv::BORDER_REPLICATE);
  cv::Sobel(as_mat(depth), expected_y, CV_32F, 0, 1, 3, 1.0 / 8, 0, cv::BORDER_REPLICATE);
  const Gradient g = gradient_of(depth, GradientOperator::sobel);
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 61; ++x) {
      EXPECT_NEAR(g.x(x, y), expected_x(y, x), 1e-6);
      EXPECT_NEAR(g.y(x, y), expected_y(y, x), 1e-6);
    }
}

TEST(Gradient, CentralDifferencesEqualOpenCVsFilterWhereNothingIsMissing) {
  Image<float> depth = random_depth_without_holes({61, 43}, 3);
  cv::Mat_<float> expected_x, expected_y;
  const cv::Mat_<float> row = (cv::Mat_<float>(1, 3) << -0.5f, 0, 0.5f);
  cv::filter2D(as_mat(depth), expected_x, CV_32F, row, {-1, -1}, 0, cv::BORDER_REPLICATE);
  cv::filter2D(as_mat(depth), expected_y, CV_32F, row.t(), {-1, -1}, 0, cv::BORDER_REPLICATE);
  const Gradient g = gradient_of(depth, GradientOperator::central);
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 61; ++x) {
      EXPECT_NEAR(g.x(x, y), expected_x(y, x), 1e-6);
      EXPECT_NEAR(g.y(x, y), expected_y(y, x), 1e-6);
    }
}

TEST(Gradient, IsZeroWhereDepthIsMissing) {
  const Image<float> depth = random_depth({61, 43}, 3);
  for (const GradientOperator op : operators) {
    const Gradient g = gradient_of(depth, op);
    for (int y = 0; y < 43; ++y)
      for (int x = 0; x < 61; ++x)
        if (depth(x, y) == 0) {
          EXPECT_EQ(g.x(x, y), 0);
          EXPECT_EQ(g.y(x, y), 0);
        }
  }
}

TEST(Gradient, AHoleMakesNoSlopeLargerThanItsSurroundings) {
  const auto ramp =
      make_image<float>({33, 9}, [](int x, int y) { return x == 16 && y > 2 ? 0.0 : 2.0 + 0.004 * x; });
  for (const GradientOperator op : operators) {
    const Gradient g = gradient_of(ramp, op);
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 33; ++x) EXPECT_LE(std::abs(g.x(x, y)), 0.004f + 1e-6f);
  }
}

TEST(Gradient, SpreadsNoiseByTheStatedFactor) {
  const float sigma = 0.01f / std::sqrt(12.0f);
  const auto noisy =
      make_image<float>({400, 300}, [](int x, int y) { return 1 + 0.01f * noise_at(8, x, y); });
  for (const GradientOperator op : operators) {
    const Gradient g = gradient_of(noisy, op);
    double squares = 0;
    for (int y = 1; y < 299; ++y)
      for (int x = 1; x < 399; ++x) squares += static_cast<double>(g.x(x, y) * g.x(x, y));
    const double measured = std::sqrt(squares / (398 * 298)) / static_cast<double>(sigma);
    EXPECT_NEAR(measured / static_cast<double>(gradient_noise_factor(op)), 1, 0.02);
  }
}

TEST(Gradient, SobelSmoothsNoiseBetterThanCentralDifferences) {  // figure 5
  EXPECT_LT(gradient_noise_factor(GradientOperator::sobel), gradient_noise_factor(GradientOperator::central));
}

TEST(Gradient, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const GradientOperator op : operators)
      expect_same_on_every_executor([&](auto& executor) {
        std::tuple out{Image<float>(depth.size()), Image<float>(depth.size())};
        gradient(executor, {op}, depth.view(), std::get<0>(out).view(), std::get<1>(out).view());
        return out;
      });
  });
}

}  // namespace
}  // namespace facet
