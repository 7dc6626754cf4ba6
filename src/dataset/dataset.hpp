#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/camera.hpp"
#include "core/image.hpp"
#include "core/rigid_motion.hpp"
#include "core/sensor.hpp"
#include "dataset/counted_depth.hpp"
#include "truth/frame_annotation.hpp"

namespace facet {

/// One decoded frame.
struct Frame {
  std::string id;        ///< unique within its data set; also the stem of its output files
  Image<float> depth_m;  ///< metres along the optical axis, 0 = missing
  CountedDepth counted;  ///< the same in whole units; empty where the files hold no integers
  cv::Mat color;         ///< 8-bit BGR; empty where there is none or where it does not fit the depth image
  Camera camera;
  std::optional<double> timestamp_s;          ///< of a sequence, where it is known
  std::optional<RigidMotion> T_world_camera;  ///< where the data set knows it
  std::optional<cv::Mat> object_masks;        ///< CV_16U, 0 = none; where the data set has them
  std::size_t missing_px = 0;                 ///< pixels without depth after reading
  std::vector<std::filesystem::path> files;   ///< everything that was read, for the data lock
};

/// What a data set varies, and its value in one frame: "noise", 0.5.
struct FrameLevel {
  std::string axis;
  double value = 0;
};

/// A data set: an ordered list of frames that are read one at a time. load() may be called from several
/// threads.
class Dataset {
 public:
  virtual ~Dataset() = default;
  virtual const std::string& name() const = 0;
  virtual std::string description() const = 0;  ///< one line for `dataset info`
  virtual Sensor sensor() const = 0;
  virtual bool is_sequence() const { return false; }  ///< frames are consecutive in time
  /// What its files lie below; empty: the root it was opened with.
  virtual std::filesystem::path folder() const { return {}; }
  virtual std::size_t size() const = 0;
  virtual std::string frame_id(std::size_t index) const = 0;
  /// What its description asks for and is not there: frames outside the sensor's range, entries of a list
  /// whose file is missing and the like.
  virtual std::vector<std::string> absent() const { return {}; }
  /// What a frame that was loaded lacks of what was asked for: "17 of 20 objects found room"; else empty.
  virtual std::string shortfall(std::size_t) const { return {}; }
  /// Where the frame stands on the axis that its set varies; nothing where that varies nothing.
  virtual std::optional<FrameLevel> level(std::size_t) const { return {}; }
  /// Reads and checks one frame; throws Error{data} naming the file and the broken rule.
  virtual Frame load(std::size_t index) const = 0;
  /// What is known of the truth of a frame that was loaded; nothing where it is not annotated. Throws
  /// Error{data} naming the file and every broken rule.
  virtual std::optional<FrameAnnotation> annotation(std::size_t index, const Frame& frame) const = 0;
};

}  // namespace facet
