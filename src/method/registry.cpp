#include "method/registry.hpp"

#include <array>
#include <string>

#include "core/error.hpp"
#include "method/edge_pairs_method.hpp"
#include "method/external.hpp"
#include "method/opencv_rgbd.hpp"
#include "method/pcl_planes.hpp"
#include "method/pipeline_method.hpp"
#include "method/stored_predictions.hpp"

namespace facet {
namespace {

std::optional<PredictedParts> shown_by_predictions(const MethodSpec&) {
  return std::nullopt;
}

}  // namespace

std::span<const MethodKind> method_kinds() {
  static const std::array table{
      MethodKind{.name = "pipeline",
                 .doc = "the edge-based surface segmentation pipeline, in any of its modes",
                 .source = "Roberts, Jabalameli and Behal, Robotics 2022, 11(1), 7; configs/modes has others",
                 .licence = "Apache-2.0",
                 .has_stages = true,
                 .yields = yields_of_pipeline,
                 .make = make_pipeline_method},
      MethodKind{.name = "edge_pairs",
                 .doc = "edge pairs, in the manner of [19]: grasps from opposing edges, without contours",
                 .source = "reconstructed from Jabalameli and Behal, Robotics 2019, 8(3), 63, whose code and "
                           "thresholds are not public",
                 .licence = "Apache-2.0",
                 .yields = yields_edge_pairs,
                 .make = make_edge_pairs},
      MethodKind{.name = "opencv_rgbd",
                 .doc = "OpenCV's plane finder, cv::rgbd::RgbdPlane, on its normals",
                 .source = "module rgbd of opencv_contrib",
                 .licence = "Apache-2.0",
                 .yields = yields_planes,
                 .make = make_opencv_rgbd},
      MethodKind{.name = "pcl_planes",
                 .doc = "PCL's organized multi-plane segmentation, and its organized edges",
                 .source = "Point Cloud Library; Trevor et al. 2013, Choi et al., IROS 2013",
                 .licence = "BSD-3-Clause",
                 .yields = yields_pcl_planes,
                 .make = make_pcl_planes,
                 .absent = what_pcl_planes_lack()},
      MethodKind{.name = "predictions",
                 .doc = "what any program has written into a folder",
                 .source = "whoever wrote them",
                 .licence = "theirs",
                 .folder = "where they are",
                 .computes_here = false,
                 .yields = shown_by_predictions,
                 .make = make_stored_predictions},
      MethodKind{.name = "external",
                 .doc = "any program, run on every frame or once on all of them",
                 .source = "whoever wrote it",
                 .licence = "theirs",
                 .folder = "where the command runs; without: beside the experiment file",
                 .computes_here = false,
                 .yields = shown_by_predictions,
                 .make = make_external_method,
                 .prepare = run_external_batch},
  };
  return table;
}

const MethodKind& find_method_kind(const MethodSpec& spec) {
  for (const MethodKind& kind : method_kinds())
    if (kind.name == spec.kind) return kind;
  throw Error(ErrorKind::config, "method '" + spec.name + "': no kind is called '" + spec.kind + "'");
}

void require_available(const MethodSpec& spec) {
  const MethodKind& kind = find_method_kind(spec);
  if (!kind.absent.empty())
    throw Error(ErrorKind::not_measured,
                "method '" + spec.name + "' of kind " + spec.kind + ": " + std::string(kind.absent));
}

std::unique_ptr<Method> make_method(const MethodSpec& spec, const MethodContext& context) {
  require_available(spec);
  return find_method_kind(spec).make(spec, context);
}

}  // namespace facet
