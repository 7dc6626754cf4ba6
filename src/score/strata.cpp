#include <array>
#include <limits>

#include "score/summary.hpp"

namespace facet {
namespace {

/// A class of clutter: values from the bound of the class before up to, and with, `most`.
struct ClutterClass {
  const char* label;
  double most;
};
constexpr double any = std::numeric_limits<double>::infinity();

struct ClutterAxis {
  const char* name;
  double (*value)(const Clutter&);
  bool (*is_known)(const AnnotatedParts&);
  std::array<ClutterClass, 4> classes;
};

constexpr ClutterAxis axes[]{
    {"objects",
     [](const Clutter& c) { return static_cast<double>(c.objects); },
     [](const AnnotatedParts&) { return true; },
     {{{"0-3", 3}, {"4-6", 6}, {"7-10", 10}, {"11+", any}}}},
    {"surfaces",
     [](const Clutter& c) { return static_cast<double>(c.surfaces); },
     [](const AnnotatedParts& has) { return has.surfaces; },
     {{{"0-5", 5}, {"6-10", 10}, {"11-20", 20}, {"21+", any}}}},
    {"occluded_share",
     [](const Clutter& c) { return c.occluded_share; },
     [](const AnnotatedParts& has) { return has.edges; },
     {{{"0-0.05", 0.05}, {"0.05-0.15", 0.15}, {"0.15-0.3", 0.3}, {"0.3+", any}}}},
    {"contacts",
     [](const Clutter& c) { return static_cast<double>(c.contacts); },
     [](const AnnotatedParts& has) { return has.edges; },
     {{{"0", 0}, {"1-2", 2}, {"3-5", 5}, {"6+", any}}}},
};

}  // namespace

std::vector<Stratum> stratify_scores(const ScoreCollection& collection, const BootstrapOptions& options) {
  std::vector<Stratum> strata;
  for (const ClutterAxis& axis : axes) {
    double above = -1;
    for (const ClutterClass& c : axis.classes) {
      ScoreCollection members;
      for (const auto& frame : collection.frames) {
        const double value = axis.value(frame.score.clutter);
        if (axis.is_known(frame.score.annotated) && value > above && value <= c.most)
          members.frames.push_back(frame);
      }
      above = c.most;
      if (!members.frames.empty()) strata.push_back({axis.name, c.label, summarise_scores(members, options)});
    }
  }
  return strata;
}

}  // namespace facet
