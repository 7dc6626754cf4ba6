#pragma once

#include <chrono>
#include <memory>
#include <utility>

#include "method/method.hpp"

namespace facet {

/// A method one of whose stages takes longer by a share of its time: the planted regression that a gate must
/// find. It keeps the processor busy for as long as that takes.
class SlowedMethod : public Method {
 public:
  SlowedMethod(std::unique_ptr<Method> method, StageId stage, double share)
      : method_(std::move(method)), stage_(static_cast<std::size_t>(index_of(stage))), share_(share) {}

  void process(const Frame& frame, Prediction& prediction, StageTimes& times) override {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    method_->process(frame, prediction, times);
    const auto start = std::chrono::steady_clock::now();
    const Milliseconds extra(share_ * times.stage_ms[stage_]);
    Milliseconds passed{};
    while (passed < extra) passed = std::chrono::steady_clock::now() - start;
    times.stage_ms[stage_] += passed.count();
    times.total_ms += passed.count();
  }
  void reset_history() override { method_->reset_history(); }

 private:
  std::unique_ptr<Method> method_;
  std::size_t stage_;
  double share_;
};

}  // namespace facet
