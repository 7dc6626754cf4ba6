#pragma once

#include <string_view>

namespace facet {

/// CSS of the HTML reports: one column on a phone, print, light and dark.
inline constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --line: #8883; --soft: #8881; --accent: #0b6bb8; --page: #fbfbfa; --card: #fff; }
@media (prefers-color-scheme: dark) { :root { --accent: #62b5f5; --page: #15171a; --card: #1d2024; } }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; background: var(--page); }
body { font: 16px/1.55 system-ui, sans-serif; max-width: 76rem; margin: 0 auto; padding: 1rem 1.1rem 4rem; }
header { border-bottom: 3px solid var(--accent); margin-bottom: .4rem; }
h1 { font-size: clamp(1.4rem, 4vw, 2rem); margin: .6rem 0 .5rem; letter-spacing: -.01em; }
nav { display: flex; gap: .1rem 1rem; overflow-x: auto; padding: .4rem 0; white-space: nowrap; font-size: .92rem; }
a { color: var(--accent); text-decoration: none; } a:hover { text-decoration: underline; }
h2 { font-size: 1.22rem; margin: 2.4rem 0 .7rem; } summary h2 { display: inline; }
summary { cursor: pointer; margin: 1.6rem 0 .4rem; }
p { max-width: 62rem; margin: .5rem 0; }
.scroll { overflow: auto; margin: .2rem 0 .7rem; } .long { max-height: 36rem; }
.dense th, .dense td { padding: .24rem .34rem; font-size: .82rem; }
.long thead { position: sticky; top: 0; z-index: 1; }
thead th { background: var(--page); } th:first-child { z-index: 2; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
.caption { font-weight: 600; font-size: .92rem; margin: 1.1rem 0 0; }
th, td { padding: .26rem .75rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th { font-weight: 600; border-bottom: 2px solid var(--line); } tbody tr:hover td { background: var(--soft); }
th:first-child, td:first-child { position: sticky; left: 0; background: var(--page); text-align: left; padding-left: .1rem; }
th.other, td.other { opacity: .72; font-style: italic; }
.words td { text-align: left; white-space: normal; overflow-wrap: anywhere; } .words th { text-align: left; }
.words:has(th:nth-child(4)) { min-width: 46rem; } .words td.good, .words td.bad { white-space: nowrap; }
td.part { padding-left: 1.1rem; opacity: .8; } td.good { color: #0a8560; font-weight: 600; }
td.bad { color: #c2410c; font-weight: 600; }
@media (prefers-color-scheme: dark) { td.good { color: #45d3a3; } td.bad { color: #ff9550; } }
.note { font-size: .85rem; opacity: .8; margin: .2rem 0; overflow-wrap: anywhere; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)); gap: .9rem; margin: 1rem 0; }
.tile, .plot { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: .8rem 1rem; }
.tile h3, .plot h3 { font-size: .95rem; margin: 0 0 .5rem; }
.tile dl { margin: 0; display: grid; grid-template-columns: 1fr auto; gap: .1rem .8rem; align-items: baseline; }
.tile dt { font-size: .86rem; opacity: .8; } .tile dd { margin: 0; text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.tile dd:first-of-type { font-size: 1.7rem; font-weight: 650; line-height: 1.2; color: var(--accent); }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 27rem), 1fr)); gap: .9rem; margin: .8rem 0; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 34rem), 1fr)); gap: 1rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px; }
figcaption { font-size: .85rem; overflow-wrap: anywhere; padding: .15rem 0 .4rem; }
figcaption code { font-size: .8rem; }
@media (max-width: 40rem) { .chart { font-size: 13.5px; } .chart .tick { font-size: 12.5px; } body { padding: .6rem .8rem 3rem; } th, td { padding: .26rem .5rem; } table { font-size: .84rem; } }
@media print {
  body { max-width: none; font-size: 10.5pt; } nav { display: none; } .scroll { overflow: visible; max-height: none; }
  .plot, .tile, figure, tr { break-inside: avoid; } h2, .caption { break-after: avoid; }
  html { background: none; } .chart { max-height: 21cm; } th { white-space: normal; } th, td { padding: .15rem .3rem; }
  table { font-size: 8pt; } th:first-child, td:first-child { position: static; } }
)";

}  // namespace facet
