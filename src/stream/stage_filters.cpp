#include "stream/stage_filters.hpp"

namespace facet {
namespace {

/// Frames in the queues behind the first filter, in the threads, and in the hands of the sink.
int most_frames_inside(const StreamOptions& options) {
  int frames = static_cast<int>(options.filters.size()) * options.queue_frames + 1;
  for (const StreamFilter& filter : options.filters) frames += filter.threads;
  return frames;
}

}  // namespace

StageFilters::StageFilters(const StreamOptions& options, const MakePipelines& make_pipelines)
    : cut_(options.filters) {
  validate(options);
  for (std::unique_ptr<Pipeline>& pipeline : make_pipelines(most_frames_inside(options)))
    free_.push_back(std::make_unique<Workspace>(Workspace{std::move(pipeline), {}}));
}

void StageFilters::warm_up(const FrameInput& frame) {
  for (const std::unique_ptr<Workspace>& workspace : free_) {
    workspace->pipeline->process(frame, workspace->result);
    workspace->pipeline->reset_history();
  }
}

std::vector<Filter> StageFilters::filters() {
  std::vector<Filter> filters;
  auto first = StageId::temporal;
  for (const StreamFilter& part : cut_) {
    const StageRange stages{first, part.until};
    filters.push_back({part.name, part.threads, [this, stages](Passage& passage) {
                         if (!passage.workspace) take_workspace(passage);
                         Workspace& workspace = *passage.workspace;
                         workspace.pipeline->run(stages, *passage.frame, workspace.result);
                       }});
    first = static_cast<StageId>(index_of(part.until) + 1);
  }
  return filters;
}

void StageFilters::give_back(Passage& passage) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(passage.workspace));
}

void StageFilters::take_workspace(Passage& passage) {
  const std::lock_guard lock(mutex_);
  passage.workspace = std::move(free_.back());  // the one used last: its memory is still in the caches
  free_.pop_back();
}

}  // namespace facet
