#include "report/chart.hpp"

namespace facet {

std::string chart_style() {
  std::string css = R"(
:root { --c0:#0b6bb8; --c1:#cf5408; --c2:#0a8560; --c3:#b04c95; --c4:#9a7000; --c5:#5356b8; --grid:#0000001a; }
@media (prefers-color-scheme: dark) {
  :root { --c0:#62b5f5; --c1:#ff9550; --c2:#45d3a3; --c3:#f09bd7; --c4:#e9c453; --c5:#b0b2ff; --grid:#ffffff22; } }
.chart { width: 100%; height: auto; display: block; font: 12px system-ui, sans-serif; fill: currentColor; }
.chart .tick { font-size: 11px; opacity: .8; } .chart .grid { stroke: var(--grid); }
.chart .zero { stroke: currentColor; stroke-dasharray: 3 3; opacity: .6; }
.chart .wire { fill: none; stroke-width: 1.9; stroke-linejoin: round; } .chart .bar { stroke-width: 1.5; opacity: .65; }
.chart .box { fill-opacity: .28; stroke-width: 1.2; } .chart .middle { stroke-width: 2.4; }
.chart .band { fill-opacity: .16; stroke: none; } .chart circle.touch { fill-opacity: 0; stroke: none; }
.chart circle, .chart rect, .chart path { fill-opacity: .72; }
)";
  for (const char digit : {'0', '1', '2', '3', '4', '5'}) {
    const std::string name = std::string("c") + digit;
    css += ".chart ." + name + " { fill: var(--" + name + "); stroke: var(--" + name + "); }\n";
  }
  // After the colours: lines have none inside.
  return css +
         ".chart .wire { fill: none; } .chart circle, .chart rect:not(.box), .chart path, .chart .band { "
         "stroke: none; }\n";
}

}  // namespace facet
