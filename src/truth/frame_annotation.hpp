#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "truth/true_pose.hpp"
#include "truth/truth.hpp"

namespace facet {

/// Everything that is known of the truth of one frame. All parts may be absent, not all at once.
struct FrameAnnotation {
  std::optional<Truth> truth;                  ///< surfaces and edges
  Image<std::uint16_t> object_masks;           ///< visible objects, 0 = none; empty without
  std::vector<TruePose> poses;                 ///< of surfaces of `truth`
  std::string source;                          ///< where it is from, for people
  std::vector<std::filesystem::path> files{};  ///< that were read for it
};

/// Reads what a folder knows of the frame `id` of that size: ID.json (annotation), ID.objects.png (one
/// channel of 8- or 16-bit integers; without it `given_masks` stands in), ID.geometry.json (planes and
/// centroids of the surfaces). Nothing where the first two are both absent. Throws Error{data} naming file
/// and all broken rules.
std::optional<FrameAnnotation> read_frame_annotation(const std::filesystem::path& folder,
                                                     const std::string& id, Size size,
                                                     const Image<std::uint16_t>& given_masks);

/// Reads an image of object masks. Throws Error{data} naming file and rule.
Image<std::uint16_t> read_object_masks(const std::filesystem::path& path);

/// What is wrong between an annotation and the object masks of its frame: a surface whose polygons lie mostly
/// on another mask than that of its group_id, or an edge whose group_id is in no mask; one line each.
std::vector<std::string> mask_problems(const Truth& truth, const Image<std::uint16_t>& object_masks);

}  // namespace facet
