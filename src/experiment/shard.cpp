#include "experiment/shard.hpp"

#include <charconv>

#include "core/error.hpp"

namespace facet {

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto [slash, bad_index] = std::from_chars(text.data(), end, shard.index);
  const bool has_slash = bad_index == std::errc{} && slash != end && *slash == '/';
  const auto [rest, bad_count] = has_slash ? std::from_chars(slash + 1, end, shard.count)
                                           : std::from_chars_result{end, std::errc::invalid_argument};
  if (bad_count != std::errc{} || rest != end || shard.index < 1 || shard.index > shard.count)
    throw Error(ErrorKind::usage, "--shard " + text + ": expected I/N with 1 <= I <= N");
  return shard;
}

}  // namespace facet
