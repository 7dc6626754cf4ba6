#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truth/truth.hpp"

namespace facet {

/// A broken rule of an annotation file.
struct AnnotationProblem {
  std::optional<std::size_t> shape;  ///< index in `shapes`; nothing where the file as a whole is meant
  std::string rule;                  ///< what is wrong, with the value found
};

/// What could be read of an annotation, and everything that is wrong with it.
struct Annotation {
  Truth truth;
  std::vector<AnnotationProblem> problems;
};

/// Reads the LabelMe format, version 5, with the labels `surface/N`, `edge/N`, `support/0` and `ignore/N`.
/// Points are shifted by -0.5 px unless the file carries the flag `pixel_centres`. `size` is that of the
/// frame. Never throws for what the text holds; every broken rule is listed, not the first alone.
Annotation parse_annotation(std::string_view text, Size size);

/// The same from a file; Error{data} names the file and all problems, one per line.
Truth read_annotation(const std::filesystem::path& path, Size size);

/// LabelMe text with the flag `pixel_centres`; parse_annotation() gives the same truth back.
std::string annotation_text(const Truth& truth, const std::string& image_name);

}  // namespace facet
