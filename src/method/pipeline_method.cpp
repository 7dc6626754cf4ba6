#include "method/pipeline_method.hpp"

#include <utility>

namespace facet {
namespace {

class PipelineMethod final : public Method {
 public:
  explicit PipelineMethod(std::unique_ptr<Pipeline> pipeline) : pipeline_(std::move(pipeline)) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    pipeline_->process(
        {frame.depth_m.view(), frame.camera, frame.timestamp_s, frame.T_world_camera, frame.counted.view()},
        result_);
    times = result_.times;
    prediction.window = result_.window;
    // Swapped, not copied: both sides keep their memory for the next frame.
    std::swap(prediction.labels, result_.labels);
    std::swap(prediction.edges, result_.edges);
    std::swap(prediction.surfaces, result_.surfaces);
    std::swap(prediction.rejected, result_.rejected);
    std::swap(prediction.note, result_.note);
    prediction.grasps.clear();
  }
  void reset_history() override { pipeline_->reset_history(); }

 private:
  std::unique_ptr<Pipeline> pipeline_;
  FrameResult result_;
};

}  // namespace

PipelineParams with_sensor(PipelineParams params, Sensor dataset_sensor) {
  if (params.sensor == Sensor::automatic) params.sensor = dataset_sensor;
  if (params.sensor == Sensor::automatic) params.sensor = Sensor::kinect_v1;
  return params;
}

std::optional<PredictedParts> yields_of_pipeline(const MethodSpec& spec) {
  const bool poses = spec.params.pose.enabled;
  return PredictedParts{.edges = true, .poses = poses, .grasps = poses && spec.params.grasp.enabled};
}

std::unique_ptr<Method> wrap_pipeline(std::unique_ptr<Pipeline> pipeline) {
  return std::make_unique<PipelineMethod>(std::move(pipeline));
}

std::unique_ptr<Method> make_pipeline_method(const MethodSpec& spec, const MethodContext& context) {
  return wrap_pipeline(
      std::move(make_pipelines(context.backend, 1, with_sensor(spec.params, context.dataset_sensor),
                               context.seed, context.threads)
                    .front()));
}

}  // namespace facet
