#pragma once

#include "experiment/experiment.hpp"
#include "pipeline/params_fields.hpp"
#include "study/design_names.hpp"

namespace facet {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<PoseScoring>{"auto", "true", "false"};

// The keys of an experiment's sections, as visit_fields() lists those of the pipeline. They drive the reader,
// --set, the range checks and configs/default.yaml.

template <class Options, class Visitor>
void visit_score_fields(Options& o, Visitor&& visit) {
  visit("surfaces", o.surfaces, FieldInfo{"", 0, 0, "score surfaces where there is truth"});
  visit("edges", o.edges, FieldInfo{"", 0, 0, "score edges where there is truth"});
  visit("objects", o.objects, FieldInfo{"", 0, 0, "score objects where there is truth"});
  visit("pose", o.pose, FieldInfo{"", 0, 0, "score poses; auto = where the truth has planes"});
}

template <class Options, class Visitor>
void visit_timing_fields(Options& o, Visitor&& visit) {
  visit("warmup", o.warmup, FieldInfo{"runs", 0, 10000, "runs of every frame before those that count"});
  visit("repeats", o.repeats,
        FieldInfo{"runs", 0, 100000, "counted runs of every frame; 0 = no timing pass"});
  visit("threads", o.threads, FieldInfo{"threads", 1, 1024, "threads inside one frame"});
}

template <class Options, class Visitor>
void visit_output_fields(Options& o, Visitor&& visit) {
  visit("predictions", o.predictions, FieldInfo{"", 0, 0, "write label images, edge images and surfaces"});
  visit("overlays", o.overlays, FieldInfo{"", 0, 0, "write pictures of every frame"});
  visit("gallery", o.gallery, FieldInfo{"frames", 0, 10000, "worst frames kept as pictures"});
}

template <class Options, class Visitor>
void visit_ablation_fields(Options& o, Visitor&& visit) {
  visit("design", o.design, FieldInfo{"", 0, 0, "which combinations of the switches run"});
  visit("base", o.base, FieldInfo{"", 0, 0, "method whose switches are turned"});
}

template <class Value, class Visitor>
void visit_seed_field(Value& seed, Visitor&& visit) {
  visit("seed", seed, FieldInfo{"", 0, 2147483647, "feeds every random choice"});
}

}  // namespace facet
