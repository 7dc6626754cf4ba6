#pragma once

#include <optional>
#include <utility>

#include "cuda/work_list.cuh"

namespace facet {

/// A list of work that the device knows: it is given again by one call.
class Graph {
 public:
  /// Nothing where the device does not take it; then the list is to be given piece by piece.
  static std::optional<Graph> of(const WorkList& list) {
    cudaGraph_t graph = nullptr;
    cudaGraphExec_t ready = nullptr;
    bool good = cudaGraphCreate(&graph, 0) == cudaSuccess;
    cudaGraphNode_t last = nullptr;
    for (const WorkList::Piece& piece : list.pieces())
      good = good && std::visit([&](const auto& what) { return append(graph, last, list, what); }, piece) ==
                         cudaSuccess;
    good = good && cudaGraphInstantiate(&ready, graph, 0) == cudaSuccess;
    if (graph != nullptr) static_cast<void>(cudaGraphDestroy(graph));
    if (good) return Graph(ready);
    static_cast<void>(cudaGetLastError());  // so that the next call does not report it again
    return std::nullopt;
  }
  Graph(Graph&& other) noexcept : ready_(std::exchange(other.ready_, nullptr)) {}
  Graph& operator=(Graph&& other) noexcept {
    std::swap(ready_, other.ready_);
    return *this;
  }
  ~Graph() {
    if (ready_ != nullptr) static_cast<void>(cudaGraphExecDestroy(ready_));
  }

  void launch(cudaStream_t stream) const { check_cuda(cudaGraphLaunch(ready_, stream), "launch a graph"); }

 private:
  explicit Graph(cudaGraphExec_t ready) : ready_(ready) {}

  // Each piece comes after the one before it: `last`, which becomes this one.
  static cudaError_t append(cudaGraph_t graph, cudaGraphNode_t& last, const WorkList& list,
                            const WorkList::Call& call) {
    auto arguments = list.arguments_of(call);
    cudaKernelNodeParams parameters{};
    parameters.func = const_cast<void*>(call.kernel);
    parameters.gridDim = call.blocks;
    parameters.blockDim = call.threads;
    parameters.kernelParams = arguments.data();
    const cudaGraphNode_t before = last;
    return cudaGraphAddKernelNode(&last, graph, &before, count_of(before), &parameters);
  }
  static cudaError_t append(cudaGraph_t graph, cudaGraphNode_t& last, const WorkList&,
                            const WorkList::Copy& copy) {
    const cudaGraphNode_t before = last;
    return cudaGraphAddMemcpyNode1D(&last, graph, &before, count_of(before), copy.to, copy.from, copy.bytes,
                                    copy.kind);
  }
  static cudaError_t append(cudaGraph_t graph, cudaGraphNode_t& last, const WorkList&,
                            const WorkList::Mark& mark) {
    const cudaGraphNode_t before = last;
    return cudaGraphAddEventRecordNode(&last, graph, &before, count_of(before), mark.event);
  }
  static std::size_t count_of(cudaGraphNode_t before) { return before == nullptr ? 0 : 1; }

  cudaGraphExec_t ready_;
};

}  // namespace facet
