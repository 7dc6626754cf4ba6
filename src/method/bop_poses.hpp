#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "prediction/prediction.hpp"

namespace facet {

/// One row of a file of poses.
struct BopPose {
  int line = 0;  ///< where it stands in the file
  int surface = 0;
  double score = 0;
  SurfacePose pose;
};

/// Poses by frame, as the BOP challenge has them: a CSV with the header scene_id,im_id,obj_id,score,R,t,time,
/// R the nine numbers of a rotation by rows, t in millimetres, apart by spaces; model to camera. Here obj_id
/// is the surface's value in the label image, and its model has the axes of surface poses: z the normal
/// towards the camera. Throws Error{data} naming file, line and rule; R must be a rotation to within 0.001.
std::map<std::string, std::vector<BopPose>> read_bop_poses(const std::filesystem::path& file,
                                                           const std::string& frame_id);

/// Gives the surfaces their poses, of several for one surface that with the best score. Throws Error{data}
/// where a pose is of no label of the image.
void apply_poses(const std::filesystem::path& file, const std::vector<BopPose>& poses,
                 std::vector<Surface>& surfaces);

}  // namespace facet
