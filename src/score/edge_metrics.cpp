#include "score/metric_list.hpp"

namespace facet {
namespace {

void add_edge_recall(MetricList& list, const std::string& tolerance, EdgeRecall EdgeScore::*recall,
                     EdgeRecall EdgeScore::*kind_ignored) {
  const auto add = [&](const std::string& name, Tally EdgeRecall::*of, EdgeRecall EdgeScore::*from) {
    list.add_tally("edge_recall_" + name + "_" + tolerance, metric_needs::edges,
                   [of, from](const FrameScore& f) { return f.edges.*from.*of; });
  };
  add("graspable", &EdgeRecall::graspable, recall);
  add("all", &EdgeRecall::all, recall);
  add("depth", &EdgeRecall::depth, recall);
  add("convex", &EdgeRecall::convex, recall);
  add("concave", &EdgeRecall::concave, recall);
  add("kind_ignored", &EdgeRecall::all, kind_ignored);
  add("graspable_kind_ignored", &EdgeRecall::graspable, kind_ignored);
}

void add_edge_precision(MetricList& list, const std::string& tolerance, EdgePrecision EdgeScore::*precision,
                        Tally EdgeScore::*kind_ignored) {
  const auto add = [&](const std::string& name, Tally EdgePrecision::*of) {
    list.add_tally("edge_precision_" + name + tolerance, metric_needs::edges,
                   [of, precision](const FrameScore& f) { return f.edges.*precision.*of; });
  };
  add("", &EdgePrecision::all);
  add("depth_", &EdgePrecision::depth);
  add("convex_", &EdgePrecision::convex);
  add("concave_", &EdgePrecision::concave);
  list.add_tally("edge_precision_kind_ignored_" + tolerance, metric_needs::edges,
                 [kind_ignored](const FrameScore& f) { return f.edges.*kind_ignored; });
}

void add_boundary(MetricList& list, const std::string& group, BoundaryCounts FrameScore::*counts) {
  const auto add = [&](const char* what, bool predicted, bool truth) {
    list.add_ratio(std::string("boundary_") + what + "_" + group, metric_needs::edges,
                   [=](const FrameScore& f) {
                     const BoundaryCounts& b = f.*counts;
                     return MetricSums{(predicted && truth ? 2.0 : 1.0) * b.matched,
                                       (predicted ? 1.0 : 0.0) * b.predicted + (truth ? 1.0 : 0.0) * b.truth};
                   });
  };
  add("precision", true, false);
  add("recall", false, true);
  add("f", true, true);
}

}  // namespace

void add_edge_metrics(MetricList& list) {
  add_edge_recall(list, "6px", &EdgeScore::recall_6px, &EdgeScore::recall_kind_ignored_6px);
  add_edge_recall(list, "3px", &EdgeScore::recall_3px, &EdgeScore::recall_kind_ignored_3px);
  add_edge_precision(list, "6px", &EdgeScore::precision_6px, &EdgeScore::precision_kind_ignored_6px);
  add_edge_precision(list, "3px", &EdgeScore::precision_3px, &EdgeScore::precision_kind_ignored_3px);
  add_boundary(list, "depth", &FrameScore::boundary_depth);
  add_boundary(list, "crease", &FrameScore::boundary_crease);
}

}  // namespace facet
