#include "dataset/timed_list.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "dataset/image_folder.hpp"

namespace facet {
namespace {

TimedList list_of(const ImageFolder& folder, std::string_view text) {
  return timed_list(text_lines(text), folder.path());
}

std::vector<TimedFile> files_at(const std::vector<double>& times_s) {
  std::vector<TimedFile> files;
  for (const double time_s : times_s) files.push_back({time_s, {}});
  return files;
}

TEST(TimedList, puts_entries_in_order_and_counts_what_it_leaves_out) {
  const ImageFolder folder;
  for (const char* name : {"1.png", "2.png", "3.png"}) folder.write_depth(name, 1000);
  const TimedList list =
      list_of(folder, "3 3.png\n1 1.png\n2 2.png\n2 1.png\n4 3.png\n5 lost.png\nx 1.png\n6 2.png 7\n");
  ASSERT_EQ(list.files.size(), 3u);
  EXPECT_EQ(list.files[0].timestamp_s, 1);
  EXPECT_EQ(list.files[2].file, folder.path() / "3.png");
  EXPECT_EQ(list.out_of_order, 2u);
  EXPECT_EQ(list.duplicates, 2u);
  EXPECT_EQ(list.missing, 1u);
  EXPECT_EQ(list.broken_lines, 2u);
  EXPECT_EQ(list.remarks("depth.txt").size(), 4u);
  EXPECT_EQ(list.remarks("depth.txt")[1], "1 entry of depth.txt left out: the file is missing");
}

TEST(TimedList, has_no_remarks_where_all_is_well) {
  const ImageFolder folder;
  folder.write_depth("1.png", 1000);
  EXPECT_TRUE(list_of(folder, "# depth\n1 1.png\n").remarks("depth.txt").empty());
}

TEST(TimedList, pairs_the_closest_first_and_each_entry_once) {
  const auto partner = associate(files_at({0.0, 0.1, 0.2, 0.9}), files_at({0.09, 0.12, 0.205}), 0.05);
  ASSERT_EQ(partner.size(), 4u);
  EXPECT_FALSE(partner[0]);
  EXPECT_EQ(partner[1], 0u);
  EXPECT_EQ(partner[2], 2u);
  EXPECT_FALSE(partner[3]);
}

TEST(TimedList, pairs_as_all_pairs_compared_would) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> time_s(0, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> a, b;
    for (unsigned i = 0; i < random() % 12; ++i) a.push_back(time_s(random));
    for (unsigned i = 0; i < random() % 12; ++i) b.push_back(time_s(random));
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    const auto partner = associate(files_at(a), files_at(b), 0.1);
    std::vector<bool> free_a(a.size(), true), free_b(b.size(), true);
    while (true) {  // takes the closest free pair again and again
      double closest = 0.1 + 1e-12;
      std::size_t i_best = a.size(), k_best = 0;
      for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
          if (free_a[i] && free_b[k] && std::abs(a[i] - b[k]) < closest)
            closest = std::abs(a[i] - b[k]), i_best = i, k_best = k;
      if (i_best == a.size()) break;
      free_a[i_best] = free_b[k_best] = false;
      ASSERT_TRUE(partner[i_best]);
      EXPECT_NEAR(std::abs(a[i_best] - b[*partner[i_best]]), closest, 1e-12);
    }
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(partner[i].has_value(), !free_a[i]);
  }
}

}  // namespace
}  // namespace facet
