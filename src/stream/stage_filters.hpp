#pragma once

#include <functional>
#include <mutex>

#include "stream/filter_chain.hpp"
#include "stream/stream_options.hpp"

namespace facet {

/// The pipeline cut into filters, and the workspaces that its frames take turns with. Outlives the chain that
/// its filters run in.
class StageFilters {
 public:
  /// Makes that many pipelines that share past frames.
  using MakePipelines = std::function<std::vector<std::unique_ptr<Pipeline>>(int count)>;

  /// Workspaces for as many frames as a chain of these filters holds. Throws as validate() does.
  StageFilters(const StreamOptions& options, const MakePipelines& make_pipelines);
  /// Runs a frame in every workspace, so that all memory is there before the stream starts, and forgets it.
  void warm_up(const FrameInput& frame);
  std::vector<Filter> filters();
  /// To be called for every frame that has left the chain.
  void give_back(Passage& passage);

 private:
  void take_workspace(Passage& passage);

  std::vector<StreamFilter> cut_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> free_;
};

}  // namespace facet
