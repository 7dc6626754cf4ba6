#pragma once

#include "core/sensor.hpp"
#include "pipeline/frame_input.hpp"
#include "synth/azure_kinect.hpp"
#include "synth/synthetic_frame.hpp"

namespace facet {

/// A built-in scene seen by a simulated sensor from any place near the view's own.
class SequenceCamera {
 public:
  SequenceCamera(View view, Sensor sensor) : view_(std::move(view)), sensor_(sensor) {}

  Camera camera() const {
    return sensor_ == Sensor::azure_kinect ? Camera{504, 504, 319.5f, 287.5f} : kinect_v1_camera();
  }
  Size size() const { return sensor_ == Sensor::azure_kinect ? Size{640, 576} : kinect_v1_size(); }
  DepthNoise noise() const { return noise_of(sensor_); }
  /// The view's own pose, then moved in the camera's axes.
  RigidMotion pose(const RigidMotion& moved = {}) const { return view_.T_world_camera * moved; }
  Image<float> measured(std::uint64_t seed, const RigidMotion& moved = {}) const {
    const Rendering exact = render(PosedScene(view_.scene, pose(moved)), camera(), size());
    return sensor_ == Sensor::azure_kinect ? measure(AzureKinect{}, exact, camera(), seed)
                                           : measure(KinectV1{}, exact, camera(), seed);
  }
  Image<float> exact(const RigidMotion& moved = {}) const {
    return render(PosedScene(view_.scene, pose(moved)), camera(), size()).depth_m;
  }

 private:
  View view_;
  Sensor sensor_;
};

}  // namespace facet
