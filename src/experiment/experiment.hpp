#pragma once

#include <string>
#include <vector>

#include "dataset/registry.hpp"
#include "method/method_spec.hpp"
#include "stream/stream_options.hpp"
#include "study/ablation_plan.hpp"

namespace facet {

enum class PoseScoring { automatic, on, off };
struct ScoreOptions {
  bool surfaces = true;
  bool edges = true;
  bool objects = true;
  PoseScoring pose = PoseScoring::automatic;  ///< automatic: where the truth has planes or poses
};

struct TimingOptions {
  int warmup = 3;    ///< runs of every frame before those that count
  int repeats = 50;  ///< counted runs of every frame; 0 = no timing pass
  int threads = 1;   ///< inside one frame
};

struct OutputOptions {
  bool predictions = true;
  bool overlays = true;
  int gallery = 0;   ///< worst frames kept as pictures
  int disputed = 0;  ///< frames that the methods disagree on, kept as pictures
};

/// One parameter of a sweep and the values it takes.
struct SweepAxis {
  std::string parameter;
  std::vector<std::string> values;  ///< as text, checked against the parameter's type and range
};

/// What a run does: the content of an experiment file.
struct Experiment {
  std::string name;
  int seed = 1;
  std::vector<DatasetSpec> datasets;
  std::vector<MethodSpec> methods;
  ScoreOptions score;
  TimingOptions timing;
  OutputOptions outputs;
  std::vector<AblationOptions> ablations;  ///< each a design of its own
  std::vector<SweepAxis> sweep;
  StreamOptions stream;
};

}  // namespace facet
