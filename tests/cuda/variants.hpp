#pragma once

#include <ostream>
#include <vector>

#include "pipeline/modes.hpp"

namespace facet {

inline void PrintTo(const Mode& mode, std::ostream* out) {
  *out << mode.name;
}

/// Default parameters but for what `change` sets.
template <class Change>
PipelineParams default_but(const Change& change) {
  PipelineParams p;
  change(p);
  return p;
}

/// The three modes, and what they leave out of the pixel operations that there are: together they run every
/// one of them.
inline std::vector<Mode> every_operation() {
  std::vector<Mode> all(std::begin(modes), std::end(modes));
  const auto add = [&](const char* name, const auto& change) { all.push_back({name, default_but(change)}); };
  add("gaussian", [](PipelineParams& p) {
    p.cd.mode = CreaseMode::gaussian;
    p.cd.closure = CreaseClosure::canny;
  });
  add("canny_on_normals", [](PipelineParams& p) { p.cd.closure = CreaseClosure::canny; });
  add("canny_on_depth", [](PipelineParams& p) { p.dd.mode = DepthEdgeMode::canny; });
  add("folded_angles", [](PipelineParams& p) {
    p.cd.mode = CreaseMode::paper;
    p.cd.closure = CreaseClosure::canny;
    p.cd.angle = CreaseAngle::atan;
  });
  add("stereo", [](PipelineParams& p) { p.sensor = Sensor::stereo; });
  add("bridge", [](PipelineParams& p) { p.morphology.mode = MorphologyMode::bridge; });
  add("mean_noise", [](PipelineParams& p) {
    p.wiener = {true, WienerGain::lim, WienerNoise::mean, 7, true};
  });
  add("plain_variance", [](PipelineParams& p) {
    p.wiener = {true, WienerGain::paper, WienerNoise::sensor, 5, false};
  });
  add("hessian", [](PipelineParams& p) { p.edge_kind.convexity = Convexity::hessian; });
  add("any_hole", [](PipelineParams& p) {
    p.fill.prefer = FillPrefer::nearest;
    p.fill.max_hole_px = 0;
  });
  return all;
}

}  // namespace facet
