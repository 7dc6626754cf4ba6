#pragma once

#include <optional>
#include <unordered_map>

#include "cuda/graph.cuh"

namespace facet {

/// The graphs of the lists that came before. A frame of a running sequence does again what one of the last
/// frames did, in the same memory and with the same numbers, so that its lists are found here; a frame of
/// another size, or another parameter, makes other lists.
class GraphCache {
 public:
  /// The graph of a list, from the second time on that it comes: what comes once is not worth one. Null where
  /// there is none.
  const Graph* find(const WorkList& list) {
    const auto [place, is_new] = known_.try_emplace(list.content());
    Entry& entry = place->second;
    if (!is_new && !entry.tried) entry = {true, Graph::of(list)};
    return entry.graph ? &*entry.graph : nullptr;
  }
  /// Where this many lists are known, old ones may be among them; they are to be forgotten when the device
  /// has done its work.
  bool is_full() const { return known_.size() >= most_lists; }
  void clear() { known_.clear(); }

  static constexpr std::size_t most_lists = 512;

 private:
  struct Entry {
    bool tried = false;
    std::optional<Graph> graph;
  };
  struct Hash {
    std::size_t operator()(const WorkList::Content& content) const {
      std::uint64_t hash = 0xcbf29ce484222325u;  // as FNV-1a, word by word
      for (const std::uint64_t word : content) hash = (hash ^ word ^ hash >> 32) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(hash);
    }
  };

  std::unordered_map<WorkList::Content, Entry, Hash> known_;
};

}  // namespace facet
