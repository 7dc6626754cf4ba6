#include "experiment/stream_reader.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "experiment/experiment_fields.hpp"

namespace facet {
namespace {

StreamFilter read_filter(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
                         OriginTable& origins) {
  StreamFilter filter;
  SectionReader reader(value, where, errors, origins);
  for (const char* key : {"name", "until"})
    if (value.is_map() && value.find(key) == nullptr)
      errors.add(value.origin, reader.path_of(key), "nothing", "a value: every filter has name and until");
  visit_stream_filter_fields(filter, reader);
  reader.finish();
  return filter;
}

}  // namespace

StreamOptions read_stream(const ConfigValue& value, ConfigErrors& errors, OriginTable& origins) {
  StreamOptions options;
  SectionReader reader(value, "stream", errors, origins);
  visit_stream_fields(options, reader);
  const std::vector<ConfigValue> filters = reader.take_list("filters", "a list of filters");
  if (!filters.empty()) options.filters.clear();
  for (std::size_t i = 0; i < filters.size(); ++i)
    options.filters.push_back(read_filter(filters[i], fmt::format("stream.filters[{}]", i), errors, origins));
  reader.finish();
  try {
    if (errors.empty()) validate(options);
  } catch (const Error& e) {
    errors.add(value.origin, std::string("stream.") + e.what());
  }
  return options;
}

}  // namespace facet
