#pragma once

#include "record/run_record.hpp"

namespace facet {

/// Times a fixed block of OpenCV operations on a fixed image, on the calling thread.
Calibration measure_calibration();

}  // namespace facet
