#pragma once

#include <memory>

#include "record/run_record.hpp"

namespace facet {

/// A fixed block of OpenCV operations on a fixed image, timed on the calling thread.
class CalibrationBlock {
 public:
  CalibrationBlock();
  ~CalibrationBlock();
  double run_ms();

 private:
  struct Images;
  std::unique_ptr<Images> images_;
};

/// Times the block many times over.
Calibration measure_calibration();

}  // namespace facet
