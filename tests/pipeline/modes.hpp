#pragma once

#include "pipeline/params.hpp"

namespace facet {

/// The parameters of configs/modes/naive.yaml.
inline PipelineParams naive_params() {
  PipelineParams p;
  p.temporal.enabled = false;
  p.outline.fattening_px = 0;
  p.fill.enabled = false;
  p.wiener.enabled = false;
  p.gradient.op = GradientOperator::central;
  p.dd.mode = DepthEdgeMode::canny;
  p.dd.relocate = false;
  p.cd.mode = CreaseMode::paper;
  p.cd.weighted = false;
  p.cd.closure = CreaseClosure::canny;
  p.morphology.mode = MorphologyMode::none;
  p.pruning.mode = PruningMode::none;
  p.support.enabled = false;
  p.validation.enabled = false;
  p.objects.enabled = false;
  return p;
}

/// The parameters of configs/modes/paper.yaml.
inline PipelineParams paper_params() {
  PipelineParams p;
  p.temporal.mode = TemporalMode::mean;
  p.temporal.max_motion_sigmas = 0;
  p.outline.fattening_px = 0;
  p.fill.prefer = FillPrefer::nearest;
  p.fill.max_hole_px = 0;
  p.fill.max_passes = 32;
  p.wiener = {true, WienerGain::paper, WienerNoise::mean, 3, false};
  p.dd.mode = DepthEdgeMode::canny;
  p.cd.mode = CreaseMode::paper;
  p.cd.closure = CreaseClosure::canny;
  p.edge_kind.convexity = Convexity::hessian;
  p.morphology.mode = MorphologyMode::paper;
  p.pruning = {PruningMode::gonzalez, 10};
  p.support.enabled = false;
  p.contours.mode = ContourMode::edge_map;
  p.pose.centre = PoseCentre::contour;
  p.objects.enabled = false;
  return p;
}

/// A named mode, for tests that run all three.
struct Mode {
  const char* name;
  PipelineParams params;
};
inline const Mode modes[]{{"default", {}}, {"paper", paper_params()}, {"naive", naive_params()}};

}  // namespace facet
