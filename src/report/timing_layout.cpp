#include "report/timing_summary.hpp"

namespace facet {
namespace {

using Keys = std::string_view;
constexpr std::array<Keys, 1> temporal{"temporal"};
constexpr std::array<Keys, 1> fill{"fill"};
constexpr std::array<Keys, 1> depth_strength{"depth_strength"};
constexpr std::array<Keys, 1> wiener{"wiener"};
constexpr std::array<Keys, 1> gradient{"gradient"};
constexpr std::array<Keys, 1> crease_strength{"crease_strength"};
constexpr std::array<Keys, 2> canny{"depth_canny", "crease_canny"};
constexpr std::array<Keys, 1> depth_canny{"depth_canny"};
constexpr std::array<Keys, 1> crease_canny{"crease_canny"};
constexpr std::array<Keys, 1> morphology{"morphology"};
constexpr std::array<Keys, 3> contours{"labelling", "support", "contours"};
constexpr std::array<Keys, 1> labelling{"labelling"};
constexpr std::array<Keys, 1> support{"support"};
constexpr std::array<Keys, 1> outlines{"contours"};
constexpr std::array<Keys, 1> validation{"validation"};
constexpr std::array<Keys, 1> objects{"objects"};

}  // namespace

std::span<const TimingRowLayout> table3_layout() {
  static const std::array<TimingRowLayout, 16> layout{{
      {"Temporal", temporal, false, {}},
      {"Fill", fill, false, PaperTime{0.66, 0.0}},
      {"DD", depth_strength, false, PaperTime{0.21, 0.0}},
      {"Wiener", wiener, false, PaperTime{2.10, 0.3}},
      {"Sobel", gradient, false, PaperTime{0.84, 0.0}},
      {"CD", crease_strength, false, PaperTime{0.36, 0.3}},
      {"Canny", canny, false, PaperTime{0.34, 0.3}},
      {"of DD", depth_canny, true, {}},
      {"of CD", crease_canny, true, {}},
      {"Morphology", morphology, false, PaperTime{4.80, 0.5}},
      {"Contours", contours, false, {}},
      {"labelling", labelling, true, {}},
      {"support", support, true, {}},
      {"outlines", outlines, true, {}},
      {"Validation", validation, false, PaperTime{1.87, 0.2}},
      {"Objects", objects, false, {}},
  }};
  return layout;
}

}  // namespace facet
