#include "method/stored_predictions.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "prediction/prediction_io.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view label_ending = ".labels.png";

class StoredPredictions final : public Method {
 public:
  explicit StoredPredictions(fs::path folder) : folder_(std::move(folder)) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    times = {};
    prediction = read_prediction(folder_ / frame.id, frame.depth_m.size());
  }
  void reset_history() override {}

 private:
  fs::path folder_;
};

}  // namespace

std::unique_ptr<Method> make_stored_predictions(const MethodSpec& spec, const MethodContext&) {
  if (spec.folder.empty())
    throw Error(ErrorKind::config, "method '" + spec.name + "': kind predictions needs a folder");
  if (!fs::is_directory(spec.folder))
    throw Error(ErrorKind::data,
                "method '" + spec.name + "': " + printable(spec.folder) + ": folder is missing");
  return std::make_unique<StoredPredictions>(spec.folder);
}

std::vector<std::string> predictions_without_frame(const MethodSpec& spec,
                                                   const std::vector<std::string>& frame_ids) {
  const std::set<std::string> known(frame_ids.begin(), frame_ids.end());
  std::vector<std::string> extra;
  for (const auto& entry : fs::recursive_directory_iterator(spec.folder)) {
    std::string id = fs::relative(entry.path(), spec.folder).generic_string();
    if (!id.ends_with(label_ending)) continue;
    id.resize(id.size() - label_ending.size());
    if (!known.contains(id)) extra.push_back(std::move(id));
  }
  std::sort(extra.begin(), extra.end());
  return extra;
}

}  // namespace facet
