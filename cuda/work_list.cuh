#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <variant>
#include <vector>

#include "cuda/error.cuh"

namespace facet {

/// Work for the device in the order in which it is to be done, not yet given to it. Lists with the same
/// content do the same to the same memory.
class WorkList {
 public:
  using Content = std::vector<std::uint64_t>;

  /// A kernel; its arguments lie in the content of the list.
  struct Call {
    static constexpr std::size_t most_arguments = 3;
    const void* kernel;
    dim3 blocks, threads;
    std::array<std::size_t, most_arguments> argument_at;
  };
  /// Memory that follows in one piece.
  struct Copy {
    void* to;
    const void* from;
    std::size_t bytes;
    cudaMemcpyKind kind;
  };
  struct Mark {
    cudaEvent_t event;
  };
  using Piece = std::variant<Call, Copy, Mark>;

  template <class... Arguments>
  void call(const void* kernel, dim3 blocks, dim3 threads, const Arguments&... arguments) {
    static_assert(sizeof...(arguments) <= Call::most_arguments);
    note(kernel, blocks.x, blocks.y, threads.x, threads.y);
    pieces_.push_back(Call{kernel, blocks, threads, {note(arguments)...}});
  }
  void copy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
    note(to, from, bytes, kind);
    pieces_.push_back(Copy{to, from, bytes, kind});
  }
  void mark(cudaEvent_t event) {
    note(event);
    pieces_.push_back(Mark{event});
  }
  void clear() {
    pieces_.clear();
    content_.clear();
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  const Content& content() const { return content_; }
  /// As the runtime takes them. They last until the list changes.
  std::array<void*, Call::most_arguments> arguments_of(const Call& call) const {
    std::array<void*, Call::most_arguments> arguments{};
    for (std::size_t i = 0; i < arguments.size(); ++i)
      arguments[i] = const_cast<std::uint64_t*>(content_.data() + call.argument_at[i]);
    return arguments;
  }

 private:
  /// Where the value lies in the content from now on. What pads it is zero, so that equal values are equal.
  /// (GCC 12 forgets what pads the members after an array of padded structs: such arrays come last.)
  template <class T>
  std::size_t note(T value) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::uint64_t));
    __builtin_clear_padding(&value);
    const std::size_t at = content_.size();
    content_.resize(at + (sizeof value + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    std::memcpy(content_.data() + at, &value, sizeof value);
    return at;
  }
  template <class... Values>
  requires(sizeof...(Values) > 1) void note(const Values&... values) { (note(values), ...); }

  std::vector<Piece> pieces_;
  Content content_;
};

}  // namespace facet
