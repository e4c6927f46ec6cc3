#include <string_view>

#include "report/bench_page_parts.h"

namespace rasterproof::report {

// Colours of Okabe and Ito; on dark paper the two darkest are lightened.
const std::string_view kBenchStyle = R"(
:root { --f32: #0072b2; --f64: #56b4e9; --fixed: #e69f00; --exact: #009e73; --yours: #d55e00; }
@media (prefers-color-scheme: dark) {
  :root { --f32: #4a9fe0; --f64: #9ad6f7; --exact: #2fc397; --yours: #ff8a3d; }
}
.questions li { padding: 0.25rem 0; }
.questions .why::before { content: "– "; }
.decisions.needs { table-layout: fixed; min-width: 45rem; }
.scroll.whole { max-height: none; }
.needs thead th + th { border-left: 1px solid var(--line); }
.decisions td .why { display: block; font-size: 0.8rem; }
.decisions th .why { display: block; font-weight: 400; }
.decisions td { border-left: 1px solid var(--line); }
.needs th:first-child { width: 18%; }
.decisions th .name { white-space: normal; }
.decisions .figures, .decisions .tied { display: block; }
.decisions .figures { font-size: 0.82rem; }
.decisions .figures b, .decisions .figures i { white-space: nowrap; font-style: normal; }
.decisions td > .name { white-space: normal; overflow-wrap: anywhere; font-weight: 600; }
.yours { color: var(--yours); font-weight: 600; }
.pick { display: flex; flex-wrap: wrap; gap: 0.5rem 1.2rem; margin: 1rem 0; font-size: 0.9rem; }
.pick[hidden], .save[hidden] { display: none; }
.pick select, .save button {
  font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line);
  border-radius: 6px; padding: 0.15rem 0.4rem;
}
.save button { cursor: pointer; padding: 0.3rem 0.7rem; }
.save { display: flex; flex-wrap: wrap; gap: 0.5rem; max-width: none; font-size: 0.85rem; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.pareto { margin: 0; }
#bench-plot {
  border: 1px solid var(--line); border-radius: 8px; background: var(--card); padding: 0.5rem;
}
#bench-plot .panel { max-width: 44rem; margin: 0 auto; }
#bench-said { min-height: 3.2em; max-width: none; margin: 0.4rem 0; color: var(--ink); }
.plot { display: block; width: 100%; height: auto; }
.plot text { font: 11px system-ui, "Noto Sans", "DejaVu Sans", sans-serif; fill: var(--ink); }
.plot .soft { fill: var(--soft); }
.plot .place { font-weight: 600; font-size: 10px; }
.plot .grid { stroke: var(--line); fill: none; }
.plot .lane { stroke: var(--soft); stroke-dasharray: 3 3; fill: none; }
.plot path.bar { all: unset; fill: none; stroke: var(--ink); stroke-width: 1; }
.plot .front { fill: none; stroke: var(--exact); stroke-width: 1.5; opacity: 0.7; }
.plot .line { fill: none; stroke-width: 1.5; stroke: var(--f32); }
.plot .line:hover { stroke-width: 3; }
.plot .line.float64 { stroke: var(--f64); stroke-dasharray: 6 2; }
.plot .line.fixed-point { stroke: var(--fixed); stroke-dasharray: 2 2; }
.plot .line.exact { stroke: var(--exact); stroke-width: 2.2; }
.plot .line.yours { stroke: var(--yours); stroke-width: 2.2; }
.plot .edge { stroke: var(--ink); stroke-width: 1.2; fill: none; }
.plot .sample { fill: var(--yours); }
.panels, .curves, .prints, .cases {
  display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(24rem, 100%), 1fr));
}
.curves { grid-template-columns: repeat(auto-fill, minmax(min(22rem, 100%), 1fr)); }
.curves.costs { grid-template-columns: repeat(auto-fill, minmax(min(34rem, 100%), 1fr)); }
.pair { display: contents; }
.curve { margin: 0; }
.curve figcaption { font-size: 0.85rem; }
.curve figcaption .why { display: block; }
.curve details { margin: 0; }
.curve summary { padding: 0; }
.curve p.why { margin: 0; }
.curve ol {
  margin: 0.2rem 0; padding-left: 2.2rem; font-size: 0.8rem; columns: 2; column-gap: 2.2rem;
}
.curve li { break-inside: avoid; overflow-wrap: anywhere; }
.curve li::marker { font-weight: 600; }
.float32::marker { color: var(--f32); }
.float64::marker { color: var(--f64); }
.fixed-point::marker { color: var(--fixed); }
.exact::marker { color: var(--exact); }
li.yours::marker { color: var(--yours); }
.plot .cliff { stroke: var(--bad); stroke-width: 1.8; fill: none; }
.scroll.cliffs { max-height: 65vh; }
#cliffs th, #cliffs td { padding: 0.3rem 0.45rem; }
#cliffs tbody th { min-width: 12rem; max-width: 20rem; line-height: 1.35; }
#cliffs tbody th .name { white-space: normal; overflow-wrap: anywhere; font-size: 0.78rem; }
#cliffs td { border-left: 1px solid var(--line); font-size: 0.76rem; line-height: 1.35; }
#cliffs td b, #cliffs td i { display: block; font-style: normal; font-weight: 400; }
#cliffs .fails i { color: var(--bad); }
#cliffs .holds, #cliffs .held { background: var(--good-wash); }
#cliffs td[tabindex] { cursor: pointer; }
#cliffs td[aria-selected] { outline: 2px solid var(--link); outline-offset: -2px; }
#cliff-shown { min-height: 4.5rem; margin: 0.5rem 0; }
#cliff-shown p { margin: 0; max-width: none; font-size: 0.9rem; }
.prints { grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); }
.prints figure, .cases figure { margin: 0; }
.prints img { width: 100%; image-rendering: pixelated; border: 1px solid var(--line); }
.cases svg { max-width: 11rem; border: 1px solid var(--line); background: var(--card); }
@media print {
  .pick, .save { display: none; }
  .panels { grid-template-columns: 1fr 1fr; }
  svg, tr, figure { break-inside: avoid; }
  .scroll.cliffs { max-height: none; }
  #cliff-shown { display: none; }
}
)";

}  // namespace rasterproof::report
