#pragma once

#include <filesystem>
#include <string>

#include "edge_pairs/edge_pair_params.hpp"
#include "method/external_params.hpp"
#include "method/plane_params.hpp"
#include "method/stored_params.hpp"
#include "pipeline/params.hpp"

namespace facet {

/// One entry of an experiment's `methods`. Of the parameters only those of its kind count.
struct MethodSpec {
  std::string name = "default";
  std::string kind = "pipeline";  ///< a name of the table in method/registry.hpp
  PipelineParams params;          ///< kind pipeline
  std::filesystem::path folder;   ///< predictions: where they are; external: where the command runs
  StoredParams stored;            ///< kind predictions
  ExternalParams external;        ///< kind external
  EdgePairParams edge_pairs;      ///< kind edge_pairs
  RgbdPlaneParams rgbd;           ///< kind opencv_rgbd
  PclPlaneParams pcl;             ///< kind pcl_planes
};

}  // namespace facet
