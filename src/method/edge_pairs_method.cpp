#include "method/edge_pairs_method.hpp"

#include "edge_pairs/edge_pair_finder.hpp"
#include "method/wall_time.hpp"

namespace facet {
namespace {

class EdgePairsMethod final : public Method {
 public:
  EdgePairsMethod(const EdgePairParams& params, const DepthNoise& noise) : finder_(params, noise) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    times = {};
    times.total_ms = milliseconds_of([&] { finder_.find(frame.depth_m.view(), frame.camera, prediction); });
  }
  void reset_history() override {}

 private:
  EdgePairFinder finder_;
};

}  // namespace

std::optional<PredictedParts> yields_edge_pairs(const MethodSpec&) {
  return PredictedParts{.regions = false, .edges = true, .grasps = true};
}

std::unique_ptr<Method> make_edge_pairs(const MethodSpec& spec, const MethodContext& context) {
  return std::make_unique<EdgePairsMethod>(spec.edge_pairs, noise_of(context.dataset_sensor));
}

}  // namespace facet
