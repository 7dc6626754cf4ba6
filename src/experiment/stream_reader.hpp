#pragma once

#include "experiment/section_reader.hpp"
#include "stream/stream_options.hpp"

namespace facet {

/// Reads the section `stream`.
StreamOptions read_stream(const ConfigValue& value, ConfigErrors& errors, OriginTable& origins);

}  // namespace facet
