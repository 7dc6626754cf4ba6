#pragma once

#include <filesystem>
#include <vector>

#include "prediction/prediction.hpp"

namespace facet {

/// The files of one prediction; `stem` is folder and frame id without an ending.
struct PredictionFiles {
  explicit PredictionFiles(const std::filesystem::path& stem);
  std::filesystem::path labels;    ///< STEM.labels.png: 16-bit, 0 = no surface, k = surface k
  std::filesystem::path edges;     ///< STEM.edges.png: 8-bit, EdgeKind + graspable_edge_bit
  std::filesystem::path surfaces;  ///< STEM.surfaces.json
};

/// Writes the three files (edges only where the prediction has them), each atomically, the label image last.
/// The same prediction gives the same bytes. Numbers that are not finite become null with a reason beside
/// them. Throws Error{internal} where the label image is empty or the files cannot be written.
void write_prediction(const Prediction& prediction, const std::filesystem::path& stem);

/// Reads a prediction of ours or of anyone's program. Only the label image must exist (8-bit or 16-bit grey
/// PNG); without a list of surfaces every label is a surface of which nothing but its area is known. Throws
/// Error{data} naming file and rule: missing or broken file, wrong pixel type, sizes that differ, unknown
/// edge code, unknown name or wrong type in the list, an id that stands twice or that no pixel of the label
/// image has, an area that is not the label's.
Prediction read_prediction(const std::filesystem::path& stem);

/// The same for a frame of that size; Error{data} too where the label image is of another.
Prediction read_prediction(const std::filesystem::path& stem, Size frame);

}  // namespace facet
