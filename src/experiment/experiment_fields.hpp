#pragma once

#include "experiment/experiment.hpp"
#include "pipeline/params_fields.hpp"
#include "study/design_names.hpp"

namespace facet {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<PoseScoring>{"auto", "true", "false"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<StreamPace>{"fixed", "recorded", "fastest"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<QueuePolicy>{"block", "drop"};
template <>
inline constexpr auto enum_names<StageId> = [] {
  std::array<std::string_view, stage_count> keys;
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = stage_names[i].key;
  return keys;
}();

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
  visit("disputed", o.disputed,
        FieldInfo{"frames", 0, 10000, "frames that the methods disagree on, kept as pictures"});
}

template <class Options, class Visitor>
void visit_ablation_fields(Options& o, Visitor&& visit) {
  visit("design", o.design, FieldInfo{"", 0, 0, "which combinations of the switches run"});
  visit("base", o.base, FieldInfo{"", 0, 0, "method whose switches are turned"});
}

template <class Options, class Visitor>
void visit_stream_fields(Options& o, Visitor&& visit) {
  visit("pace", o.pace, FieldInfo{"", 0, 0, "at rate_hz, at the recorded times, or as fast as possible"});
  visit("rate_hz", o.rate_hz, FieldInfo{"frames/s", 0.01, 100000, "pace fixed"});
  visit("frames", o.frames,
        FieldInfo{"frames", 0, 100000000, "offered; 0 = as many as `seconds` allow, else each once"});
  visit("seconds", o.seconds, FieldInfo{"s", 0, 1000000, "how long frames are offered; 0 = no limit"});
  visit("warmup", o.warmup, FieldInfo{"frames", 0, 1000000, "offered before those that count"});
  visit("policy", o.policy,
        FieldInfo{"", 0, 0, "where the first queue is full: wait, or give up the oldest frame"});
  visit("queue_frames", o.queue_frames, FieldInfo{"frames", 1, 1024, "room of every queue"});
}

template <class Options, class Visitor>
void visit_stream_filter_fields(Options& o, Visitor&& visit) {
  visit("name", o.name, FieldInfo{"", 0, 0, "name of the filter in every output"});
  visit("until", o.until, FieldInfo{"", 0, 0, "its last stage"});
  visit("threads", o.threads, FieldInfo{"threads", 1, 1024, "frames at a time"});
}

template <class Value, class Visitor>
void visit_seed_field(Value& seed, Visitor&& visit) {
  visit("seed", seed, FieldInfo{"", 0, 2147483647, "feeds every random choice"});
}

}  // namespace facet
