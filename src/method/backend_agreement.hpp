#pragma once

#include "pipeline/pipeline.hpp"

namespace facet {

/// Whether two pipelines make the same, to the bit, of two small frames: a table with a box, its shadow and
/// noise. Takes milliseconds: what tells a back end that cannot be trusted before a run, not a test of it.
bool agree_on_test_frames(Pipeline& one, Pipeline& other);

}  // namespace facet
