#include "report/statistics.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(Statistics, MeanAndDeviationOfAKnownSample) {
  const std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
  EXPECT_DOUBLE_EQ(mean_of(values), 5);
  EXPECT_NEAR(deviation_of(values), std::sqrt(32.0 / 7), 1e-12);
  EXPECT_EQ(deviation_of(std::vector<double>{3}), 0);
  EXPECT_EQ(mean_of({}), 0);
}

TEST(Statistics, OneWildValueIsAnOutlierAndEqualValuesHaveNone) {
  EXPECT_EQ(count_outliers(std::vector<double>{10, 11, 10.5, 9.5, 10.2, 50}), 1);
  EXPECT_EQ(count_outliers(std::vector<double>{5, 5, 5, 5, 9}), 0);
  EXPECT_EQ(count_outliers({}), 0);
}

TEST(Statistics, StudentsQuantilesAgreeWithThePrintedTables) {
  EXPECT_NEAR(student_t_975(1), 12.706, 1e-3);
  EXPECT_NEAR(student_t_975(10), 2.2281, 1e-4);
  EXPECT_NEAR(student_t_975(11), 2.2010, 2e-4);
  EXPECT_NEAR(student_t_975(30), 2.0423, 1e-4);
  EXPECT_NEAR(student_t_975(1000), 1.9623, 1e-4);
}

TEST(Statistics, ALineIsFoundExactlyAndItsIntervalHasNoWidth) {
  const auto fit = fit_line(std::vector<double>{1, 2, 3, 4}, std::vector<double>{5, 7, 9, 11});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 2, 1e-12);
  EXPECT_NEAR(fit->intercept, 3, 1e-12);
  EXPECT_NEAR(fit->slope_high - fit->slope_low, 0, 1e-9);
}

TEST(Statistics, TheSlopesIntervalAgreesWithAHandComputedCase) {
  // x = 1..4, y = 1, 3, 2, 4: slope 0.8, residual sum 1.8, standard error sqrt(0.9 / 5), t(2) = 4.3027.
  const auto fit = fit_line(std::vector<double>{1, 2, 3, 4}, std::vector<double>{1, 3, 2, 4});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 0.8, 1e-12);
  EXPECT_NEAR(fit->slope_high - fit->slope, 4.3027 * std::sqrt(0.9 / 5), 1e-4);
}

TEST(Statistics, TwoPointsOrOneXGiveNoLine) {
  EXPECT_FALSE(fit_line(std::vector<double>{1, 2}, std::vector<double>{1, 2}));
  EXPECT_FALSE(fit_line(std::vector<double>{3, 3, 3}, std::vector<double>{1, 2, 3}));
}

}  // namespace
}  // namespace facet
