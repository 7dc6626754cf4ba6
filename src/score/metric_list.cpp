#include "score/metric_list.hpp"

namespace facet {

void MetricList::add_tally(std::string name, const MetricNeeds& needs,
                           std::function<Tally(const FrameScore&)> tally) {
  metrics.push_back({std::move(name), needs.truth, needs.prediction, MetricRule::proportion,
                     [tally = std::move(tally)](const FrameScore& f) {
                       const Tally t = tally(f);
                       return MetricSums{static_cast<double>(t.hit), static_cast<double>(t.n)};
                     }});
}

void MetricList::add_ratio(std::string name, const MetricNeeds& needs,
                           std::function<MetricSums(const FrameScore&)> sums) {
  metrics.push_back({std::move(name), needs.truth, needs.prediction, MetricRule::ratio, std::move(sums)});
}

void MetricList::add_precision_recall(const std::string& name, const MetricNeeds& needs,
                                      const std::function<MetricSums(const FrameScore&)>& sums) {
  metrics.push_back({name + "_precision", needs.truth, needs.prediction, MetricRule::precision, sums});
  metrics.push_back({name + "_recall", needs.truth, needs.prediction, MetricRule::recall, sums});
  metrics.push_back({name + "_f", needs.truth, needs.prediction, MetricRule::f_score, sums});
}

}  // namespace facet
