#include "prediction/prediction_io.hpp"

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "prediction/label_images.hpp"
#include "prediction/surface_json.hpp"

namespace facet {
namespace {

std::filesystem::path with_ending(std::filesystem::path stem, const char* ending) {
  return stem += ending;
}

}  // namespace

PredictionFiles::PredictionFiles(const std::filesystem::path& stem)
    : labels(with_ending(stem, ".labels.png")),
      edges(with_ending(stem, ".edges.png")),
      surfaces(with_ending(stem, ".surfaces.json")) {}

void write_prediction(const Prediction& prediction, const std::filesystem::path& stem) {
  const PredictionFiles files(stem);
  if (prediction.labels.empty())
    throw Error(ErrorKind::internal, printable(files.labels) + ": the prediction has no label image");
  write_file_atomically(files.surfaces, surfaces_to_json(prediction));
  if (prediction.edges.empty()) {
    std::filesystem::remove(files.edges);  // of an earlier prediction that had edges
  } else {
    write_png_file(files.edges, as_mat(prediction.edges), PngEffort::least_time);
  }
  write_png_file(files.labels, as_mat(prediction.labels), PngEffort::least_time);
}

Prediction read_prediction(const std::filesystem::path& stem) {
  const PredictionFiles files(stem);
  Prediction prediction;
  prediction.labels = read_label_image(files.labels);
  if (std::filesystem::exists(files.edges))
    prediction.edges = read_edge_image(files.edges, prediction.labels.size());
  if (std::filesystem::exists(files.surfaces)) read_surfaces_json(files.surfaces, prediction);
  complete_surfaces(files.surfaces, prediction);
  return prediction;
}

Prediction read_prediction(const std::filesystem::path& stem, Size frame) {
  Prediction prediction = read_prediction(stem);
  require_size(PredictionFiles(stem).labels, prediction.labels.size(), frame);
  return prediction;
}

}  // namespace facet
