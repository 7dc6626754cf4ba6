#include "method/stored_predictions.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "method/bop_poses.hpp"
#include "method/coco_instances.hpp"
#include "prediction/label_images.hpp"
#include "prediction/prediction_io.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view label_ending = ".labels.png";

class StoredPredictions final : public Method {
 public:
  explicit StoredPredictions(const MethodSpec& spec) : folder_(spec.folder) {
    const StoredParams& stored = spec.stored;
    if (!stored.instances.empty()) instances_.emplace(folder_ / stored.instances, stored.frame_id);
    if (stored.poses.empty()) return;
    pose_file_ = folder_ / stored.poses;
    poses_ = read_bop_poses(pose_file_, stored.frame_id);
  }

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    times = {};
    const Size size = frame.depth_m.size();
    if (instances_) {
      prediction = {};
      prediction.labels = instances_->labels_of(frame.id, size);
      complete_surfaces(folder_, prediction);
    } else {
      prediction = read_prediction(folder_ / frame.id, size);
    }
    if (const auto found = poses_.find(frame.id); found != poses_.end())
      apply_poses(pose_file_, found->second, prediction.surfaces);
  }
  void reset_history() override {}

 private:
  fs::path folder_, pose_file_;
  std::optional<CocoInstances> instances_;
  std::map<std::string, std::vector<BopPose>> poses_;
};

std::vector<std::string> label_images_in(const fs::path& folder) {
  std::vector<std::string> ids;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    std::string id = fs::relative(entry.path(), folder).generic_string();
    if (!id.ends_with(label_ending)) continue;
    id.resize(id.size() - label_ending.size());
    ids.push_back(std::move(id));
  }
  return ids;
}

}  // namespace

std::unique_ptr<Method> make_stored_predictions(const MethodSpec& spec, const MethodContext&) {
  if (spec.folder.empty())
    throw Error(ErrorKind::config, "method '" + spec.name + "': kind predictions needs a folder");
  if (!fs::is_directory(spec.folder))
    throw Error(ErrorKind::data,
                "method '" + spec.name + "': " + printable(spec.folder) + ": folder is missing");
  return std::make_unique<StoredPredictions>(spec);
}

std::vector<std::string> predictions_without_frame(const MethodSpec& spec,
                                                   const std::vector<std::string>& frame_ids) {
  const StoredParams& stored = spec.stored;
  std::vector<std::string> named =
      stored.instances.empty() ? label_images_in(spec.folder)
                               : CocoInstances(spec.folder / stored.instances, stored.frame_id).frames();
  if (!stored.poses.empty())
    for (const auto& [frame, poses] : read_bop_poses(spec.folder / stored.poses, stored.frame_id))
      named.push_back(frame);
  const std::set<std::string> known(frame_ids.begin(), frame_ids.end());
  std::set<std::string> extra;
  for (std::string& id : named)
    if (!known.contains(id)) extra.insert(std::move(id));
  return {extra.begin(), extra.end()};
}

}  // namespace facet
