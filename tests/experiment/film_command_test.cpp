#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FilmCommand : public ::testing::Test {
 protected:
  FilmCommand() {
    write_small_frames(facet.folder() / "frames", {"f8", "f9", "f10"});
    write_experiment("sequence: true, rate_hz: 30, ", true);
  }
  void write_experiment(const std::string& sequence, bool overlays) {
    std::string dataset = small_dataset;
    dataset.insert(dataset.find("intrinsics"), sequence);
    facet.write("exp.yaml", fmt::format("schema: 1\n{}methods: [{{name: default}}]\ntiming: {{repeats: 0}}\n"
                                        "outputs: {{overlays: {}}}\n",
                                        dataset, overlays));
  }
  fs::path run() {
    const auto result = facet.run({"run", "exp.yaml", "-o", "out", "-q"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return facet.latest("out", "exp");
  }
  FacetProcess facet;
};

TEST_F(FilmCommand, MakesAFilmAndAContactSheetOfEverySequence) {
  const fs::path run_directory = run();
  const auto result = facet.run({"gallery", run_directory.string(), "--film"});
  EXPECT_TRUE(fs::exists(run_directory / "films/default/small.png"));
  EXPECT_THAT(file_text(run_directory / "report/films.html"), HasSubstr("small / default"));
  EXPECT_THAT(result.out, HasSubstr("3 of 3"));
  if (result.exit_code == 6) {
    EXPECT_THAT(result.out, HasSubstr("No films: this binary was built without OpenCV's videoio"));
    return;
  }
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string film = file_text(run_directory / "films/default/small.avi");
  EXPECT_EQ(film.substr(0, 4) + film.substr(8, 3), "RIFFAVI");
}

TEST_F(FilmCommand, SaysWhatIsMissing) {
  write_experiment("", true);
  const auto still = facet.run({"gallery", run().string(), "--film"});
  EXPECT_EQ(still.exit_code, 6);
  EXPECT_THAT(still.err, HasSubstr("no sequence was processed"));
  write_experiment("sequence: true, ", false);
  const auto bare = facet.run({"gallery", run().string(), "--film"});
  EXPECT_EQ(bare.exit_code, 6);
  EXPECT_THAT(bare.err, HasSubstr("outputs.overlays: true"));
  EXPECT_EQ(facet.run({"gallery", "nowhere", "--film"}).exit_code, 4);
  EXPECT_EQ(facet.run({"gallery", "nowhere", "--film", "--worst", "3"}).exit_code, 2);
}

TEST_F(FilmCommand, LeavesNoPartOfAFilmOnAFullDisk) {
  const fs::path run_directory = run();
  const auto result = facet.run({"gallery", run_directory.string(), "--film"}, [] {
    const rlimit limit{100000, 100000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(result.exit_code, 70);
  EXPECT_FALSE(fs::exists(run_directory / "films/default/small.avi"));
}

}  // namespace
}  // namespace facet
