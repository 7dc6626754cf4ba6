#include "stream/stream_options.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "pipeline/stage_range.hpp"

namespace facet {

void validate(const StreamOptions& options) {
  const std::vector<StreamFilter>& filters = options.filters;
  const auto reject = [](const std::string& rule) { throw Error(ErrorKind::config, "filters: " + rule); };
  const auto not_ascending = [](const StreamFilter& a, const StreamFilter& b) { return a.until >= b.until; };
  if (filters.empty() || filters.back().until != all_stages.last)
    reject("the last filter must run until " + std::string(stage_names.back().key));
  if (std::adjacent_find(filters.begin(), filters.end(), not_ascending) != filters.end())
    reject("`until` must name a later stage in every filter");
  if (filters.front().threads != 1)
    reject("the first filter must have one thread: its temporal average needs frames in order");
  for (auto filter = filters.begin(); filter != filters.end(); ++filter)
    if (std::any_of(filters.begin(), filter, [&](const auto& other) { return other.name == filter->name; }))
      reject("'" + filter->name + "' is the name of two");
}

}  // namespace facet
