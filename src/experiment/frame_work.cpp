#include "experiment/frame_work.hpp"

#include <exception>

#include "experiment/dataset_truth.hpp"
#include "experiment/run_directory.hpp"
#include "file/file_bytes.hpp"
#include "file/portable_name.hpp"
#include "method/registry.hpp"
#include "overlay/overlay.hpp"
#include "prediction/prediction_io.hpp"
#include "score/frame_score.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

void count_edges(const Prediction& prediction, FrameRow& row) {
  for (int y = 0; y < prediction.edges.height(); ++y)
    for (int x = 0; x < prediction.edges.width(); ++x) {
      const EdgeKind kind = edge_kind_of(prediction.edges(x, y));
      row.depth_edge_px += kind == EdgeKind::depth ? 1 : 0;
      row.convex_edge_px += kind == EdgeKind::convex ? 1 : 0;
      row.concave_edge_px += kind == EdgeKind::concave ? 1 : 0;
    }
}

void describe(const Prediction& prediction, FrameRow& row) {
  row.reason = escaped_utf8(prediction.note);
  row.surfaces = static_cast<int>(prediction.surfaces.size());
  for (const Surface& surface : prediction.surfaces) {
    row.posed += surface.pose.has_value();
    row.curved += surface.curved;
    row.labelled_px += surface.area_px;
  }
  for (const RejectedRegion& region : prediction.rejected) ++row.rejected[region.reason];
  count_edges(prediction, row);
}

std::string kind_of(const DatasetSpec& spec, const std::string& frame) {
  for (std::size_t i = 0; i < spec.kinds.size(); ++i)
    if (spec.frames[i] == frame) return escaped_utf8(spec.kinds[i]);
  return {};
}

SequenceRow sequence_row(const Frame& frame, const Prediction& prediction, StabilityTracker& tracker) {
  const StabilityInput input{frame.depth_m.view(), frame.camera, frame.T_world_camera, prediction};
  return {frame.timestamp_s, frame.T_world_camera.has_value(), prediction.window, tracker.next(input)};
}

}  // namespace

void FrameWork::keep_finished(const std::vector<FrameRow>& rows) {
  for (const FrameRow& row : rows)
    if (row.status == FrameStatus::ok && row.config_hash == identity_.config_hash &&
        row.build == identity_.build)
      finished_[{row.dataset, row.frame, row.method}] = row;
}

std::pair<FrameRow, bool> FrameWork::evaluate(const Unit& unit, std::size_t index, Method& method,
                                              StabilityTracker& tracker) {
  const Dataset& data = *plan_.datasets[unit.dataset].data;
  FrameRow row;
  row.dataset = data.name();
  row.frame = escaped_utf8(data.frame_id(index));
  row.method = experiment_.methods[unit.method].name;
  row.config_hash = identity_.config_hash;
  row.build = identity_.build;
  row.status = FrameStatus::data_error;
  row.is_sequence = data.is_sequence();
  row.kind = kind_of(plan_.datasets[unit.dataset].spec, data.frame_id(index));
  if (const std::optional<FrameLevel> level = data.level(index)) {
    row.axis = level->axis;
    row.level = level->value;
  }
  Prediction prediction;
  Frame frame;
  std::optional<FrameTruth> truth;
  try {
    frame = data.load(index);
    truth = truth_of(data, index, frame, row);
    row.input_hash = data_lock_.input_hash(frame);
    const auto done = finished_.find({row.dataset, row.frame, row.method});
    const bool finished = done != finished_.end() && done->second.input_hash == row.input_hash;
    // A sequence's frame must pass through the method again, for the sake of those that follow.
    if (finished && !data.is_sequence()) return {done->second, true};
    row.status = FrameStatus::method_error;
    StageTimes times;
    method.process(frame, prediction, times);
    if (data.is_sequence()) row.sequence = sequence_row(frame, prediction, tracker);
    if (finished) return {done->second, true};
    note_program_time(unit, row, times);
    if (truth) row.score = score_frame(*truth, prediction, predicted_parts(unit, prediction));
  } catch (const std::exception& e) {
    row.reason = escaped_utf8(e.what());
    tracker.interrupt();
    if (row.status == FrameStatus::method_error && truth) row.score = score_missing_prediction(*truth);
    return {row, false};
  }
  row.status = FrameStatus::ok;
  row.width_px = frame.depth_m.width();
  row.height_px = frame.depth_m.height();
  row.missing_px = static_cast<std::int64_t>(frame.missing_px);
  describe(prediction, row);
  write_outputs(frame, prediction, row);
  return {row, false};
}

std::optional<FrameTruth> FrameWork::truth_of(const Dataset& data, std::size_t index, Frame& frame,
                                              FrameRow& row) const {
  const ScoreOptions& wanted = experiment_.score;
  if (!wanted.surfaces && !wanted.edges && !wanted.objects && wanted.pose == PoseScoring::off) return {};
  return read_truth(data, index, frame, row.truth_source);
}

/// What a method declares, or else what its prediction shows.
PredictedParts FrameWork::predicted_parts(const Unit& unit, const Prediction& prediction) const {
  const MethodSpec& spec = experiment_.methods[unit.method];
  const std::optional<PredictedParts> declared = find_method_kind(spec).yields(spec);
  return declared ? *declared : parts_of(prediction);
}

/// Times of methods that run elsewhere are taken here, once, and stand apart from those of the timing pass.
void FrameWork::note_program_time(const Unit& unit, const FrameRow& row, const StageTimes& times) {
  if (find_method_kind(experiment_.methods[unit.method]).computes_here || times.total_ms <= 0) return;
  const std::lock_guard lock(mutex_);
  io_times_.push_back({row.dataset, row.frame, row.method, "program", times.total_ms});
}

void FrameWork::write_outputs(Frame& frame, const Prediction& prediction, FrameRow& row) {
  frame.id = portable_name(frame.id);  // names the files
  const fs::path place = fs::path(row.method) / row.dataset;
  const double ms = milliseconds_of([&] {
    if (experiment_.outputs.predictions)
      write_prediction(prediction, directory_ / "predictions" / place / frame.id);
    if (!experiment_.outputs.overlays) return;
    write_overlays(frame, prediction, directory_ / "overlays" / place);
    row.pictures = {("overlays" / place / (frame.id + ".png")).generic_string()};
  });
  const std::lock_guard lock(mutex_);
  io_times_.push_back({row.dataset, row.frame, row.method, "write", ms});
}

}  // namespace facet
