#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/plan.hpp"
#include "prediction/prediction.hpp"
#include "record/gallery.hpp"
#include "report/document.hpp"
#include "score/frame_truth.hpp"

namespace facet {

/// What a method makes of one frame, computed anew: its frame, prediction and truth.
struct FrameAgain {
  Frame frame;
  Prediction prediction;
  std::optional<FrameTruth> truth;
};
/// A frame of a sequence is preceded by as many of its frames as a method may remember.
FrameAgain process_again(const PlannedDataset& planned, std::size_t index, const MethodSpec& method,
                         std::uint64_t seed);

/// Draws every entry beside its truth into `directory`/gallery/METHOD/DATASET/FRAME.png and names the file in
/// it. What cannot be drawn keeps the picture it has; returns a line for each of those, with the reason.
std::vector<std::string> draw_gallery(const Experiment& experiment, const Plan& plan,
                                      const std::filesystem::path& directory,
                                      std::vector<GalleryEntry>& entries);

/// Draws every entry as a strip of the truth and of what every method made of the frame, into
/// `directory`/gallery/disputed/DATASET/FRAME.png, from the predictions that the run has stored, and names
/// the file in it. Returns a line for each that cannot be drawn, with the reason.
std::vector<std::string> draw_disputed(const Experiment& experiment, const Plan& plan,
                                       const std::filesystem::path& directory,
                                       std::vector<GalleryEntry>& entries);

/// What `facet gallery` is told.
struct GalleryRequest {
  std::filesystem::path run;
  std::optional<std::filesystem::path> baseline;
  std::string metric = "surface_f1_0.5";
  int worst = 12;
  std::optional<std::string> data_root;
};
/// Draws the worst frames of a stored run, writes gallery/gallery.json and report/gallery.html and returns
/// what that page says: the frames with the command that runs each again. Throws Error{not_measured} where no
/// frame has a value.
Report make_gallery(const GalleryRequest& request);

}  // namespace facet
