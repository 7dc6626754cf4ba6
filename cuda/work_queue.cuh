#pragma once

#include "cuda/graph_cache.cuh"
#include "cuda/stream.cuh"

namespace facet {

/// What a host thread asks of the device: collected until the host needs something of it, then given to the
/// device at once, as one graph where the same was asked before, else piece by piece.
class WorkQueue {
 public:
  template <class... Arguments>
  void call(const void* kernel, dim3 blocks, dim3 threads, const Arguments&... arguments) {
    collected_.call(kernel, blocks, threads, arguments...);
  }
  void copy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
    collected_.copy(to, from, bytes, kind);
  }
  /// Takes the time when what was collected before is done: at once where that is nothing, so that what the
  /// host does next counts. May be read when the work is finished.
  void mark(const Event& event) {
    const bool is_now = collected_.pieces().empty();
    collected_.mark(event.handle());
    if (is_now) give();
  }

  /// Gives the device all that was collected. Throws Error{not_measured} where it has no memory,
  /// Error{internal} where a kernel cannot be.
  void give() {
    if (collected_.pieces().empty()) return;
    if (graphs_.is_full()) {
      stream_.wait();
      graphs_.clear();
    }
    const bool is_alone = collected_.pieces().size() == 1;
    if (const Graph* graph = is_alone ? nullptr : graphs_.find(collected_))
      graph->launch(stream_);
    else
      for (const WorkList::Piece& piece : collected_.pieces())
        std::visit([this](const auto& what) { give(what); }, piece);
    collected_.clear();
  }
  /// The same; `event` tells when the device has done it.
  void give(const Event& event) {
    give();
    check_cuda(cudaEventRecord(event.handle(), stream_), "record an event");
  }
  /// The same, and waits until the device has done it.
  void finish() {
    give();
    stream_.wait();
    ++times_finished_;
  }
  std::uint64_t times_finished() const { return times_finished_; }
  /// What was collected and not given is not done.
  void discard() { collected_.clear(); }

 private:
  void give(const WorkList::Call& call) {
    auto arguments = collected_.arguments_of(call);
    check_cuda(cudaLaunchKernel(call.kernel, call.blocks, call.threads, arguments.data(), 0, stream_),
               "launch a kernel");
  }
  void give(const WorkList::Copy& copy) {
    check_cuda(cudaMemcpyAsync(copy.to, copy.from, copy.bytes, copy.kind, stream_), "copy memory");
  }
  void give(const WorkList::Mark& mark) {
    check_cuda(cudaEventRecord(mark.event, stream_), "record an event");
  }

  Stream stream_;
  WorkList collected_;
  GraphCache graphs_;
  std::uint64_t times_finished_ = 0;
};

}  // namespace facet
