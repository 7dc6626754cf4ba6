#pragma once

#include <memory>

#include "method/registry.hpp"
#include "pipeline/pipeline.hpp"

namespace facet {

/// The pipeline on the context's back end, with the sensor of the data set where the parameters say `auto`.
std::unique_ptr<Method> make_pipeline_method(const MethodSpec& spec, const MethodContext& context);

/// Edges always; poses and grasps unless the parameters switch them off.
std::optional<PredictedParts> yields_of_pipeline(const MethodSpec& spec);

/// Any pipeline as a method.
std::unique_ptr<Method> wrap_pipeline(std::unique_ptr<Pipeline> pipeline);

/// `params` with `auto` replaced by the data set's sensor, and by Kinect v1 where that declares none either.
PipelineParams with_sensor(PipelineParams params, Sensor dataset_sensor);

}  // namespace facet
