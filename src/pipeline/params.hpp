#pragma once

#include "core/sensor.hpp"
#include "stage/crease_edges.hpp"
#include "stage/depth_edges.hpp"
#include "stage/edge_kind.hpp"
#include "stage/fill_missing.hpp"
#include "stage/gradient.hpp"
#include "stage/morphology.hpp"
#include "stage/outline_trim.hpp"
#include "stage/pruning.hpp"
#include "stage/temporal_average.hpp"
#include "stage/wiener.hpp"
#include "surface/contours.hpp"
#include "surface/grasp.hpp"
#include "surface/merge_params.hpp"
#include "surface/object_params.hpp"
#include "surface/pose.hpp"
#include "surface/support_params.hpp"
#include "surface/validation.hpp"

namespace facet {

/// Every parameter of the pipeline. The members' defaults are the toolkit's default mode; configs/modes/
/// holds the paper's literal choices and the naive recipe. Names, units and ranges: params_fields.hpp.
struct PipelineParams {
  Sensor sensor = Sensor::automatic;
  TemporalParams temporal;
  OutlineParams outline;
  FillParams fill;
  WienerParams wiener;
  GradientParams gradient;
  DepthEdgeParams dd;
  CreaseParams cd;
  MergeParams merge;
  EdgeKindParams edge_kind;
  MorphologyParams morphology;
  PruningParams pruning;
  SupportParams support;
  ContourParams contours;
  ValidationParams validation;
  PoseParams pose;
  GraspParams grasp;
  ObjectParams objects;
};

/// Throws Error{config} naming key, rule and value of the first parameter that is out of range.
void validate(const PipelineParams& params);

}  // namespace facet
