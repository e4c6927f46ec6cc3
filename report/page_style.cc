#include <string_view>

#include "report/page_parts.h"

namespace rasterproof::report {

// Green is for states that hold and for nothing else. Verdicts differ by shape and word as well.
const std::string_view kPageStyle = R"(
:root {
  --paper: #fcfcfb; --card: #ffffff; --ink: #23262d; --soft: #626975; --line: #e3e5e9;
  --shade: #f4f5f7; --good: #00795a; --good-wash: #e3f4ee; --bad: #b94a00; --bad-wash: #fdeade;
  --over: #005f96; --link: #005f96;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16181c; --card: #1d2025; --ink: #e4e6ea; --soft: #9aa2ae; --line: #31353d;
    --shade: #23272d; --good: #43c59e; --good-wash: #16352c; --bad: #ff9a55; --bad-wash: #42260f;
    --over: #62b5ea; --link: #7cc0ee;
  }
}
* { box-sizing: border-box; }
html { font-size: 16px; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font-family: system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif;
  line-height: 1.55;
}
main { max-width: 84rem; margin: 0 auto; padding: 3rem 1.5rem 6rem; }
h1 { font-size: 2rem; font-weight: 650; letter-spacing: -0.015em; margin: 0; }
h2 { font-size: 1.35rem; font-weight: 620; letter-spacing: -0.01em; margin: 3.5rem 0 0.2rem; }
h3 { font-size: 1.02rem; font-weight: 620; margin: 2rem 0 0.6rem; }
h4 { font-size: 0.9rem; font-weight: 620; color: var(--soft); margin: 1.4rem 0 0.4rem; }
p { margin: 0.3rem 0 1rem; max-width: 46rem; }
section > p, .extent, .aside { color: var(--soft); }
a { color: var(--link); text-decoration: none; }
a:hover { text-decoration: underline; }
code, pre, .number, .name {
  font-family: ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace;
}
code, pre, .name { font-size: 0.84rem; }
pre {
  background: var(--shade); border-radius: 6px; padding: 0.6rem 0.8rem; margin: 0.4rem 0;
  overflow-x: auto; white-space: pre-wrap; overflow-wrap: anywhere;
}
.scroll {
  overflow-x: auto; border: 1px solid var(--line); border-radius: 10px; background: var(--card);
}
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; }
th, td { padding: 0.42rem 0.7rem; text-align: left; vertical-align: baseline; }
thead th {
  font-weight: 560; color: var(--soft); font-size: 0.8rem; border-bottom: 1px solid var(--line);
}
.noted { min-width: 11rem; }
tbody tr + tr > * { border-top: 1px solid var(--line); }
tbody th { font-weight: 450; }
th.name, tbody th > .name { white-space: nowrap; }
.number {
  text-align: right; font-size: 0.84rem; font-variant-numeric: tabular-nums; white-space: nowrap;
}
thead .number { font-family: inherit; font-size: 0.8rem; white-space: normal; }
.zero, .none { color: var(--soft); }
.wrong, .missing { color: var(--bad); font-weight: 600; }
.unexpected { color: var(--over); font-weight: 600; }
.split { border-left: 1px solid var(--line); }
.chip {
  display: inline-block; padding: 0.05rem 0.6rem; border-radius: 99px; font-size: 0.8rem;
  font-weight: 600; white-space: nowrap;
}
.chip.holds { color: var(--good); background: var(--good-wash); }
.chip.violated { color: var(--bad); background: var(--bad-wash); }
.chip.idle { color: var(--soft); border: 1px dashed var(--soft); }
.chip.none { color: var(--soft); font-weight: 400; padding: 0; }
.mark {
  display: inline-block; width: 1.35rem; text-align: center; border-radius: 4px;
  font-weight: 700;
}
.mark.holds { color: var(--good); }
.mark.violated { color: var(--bad); background: var(--bad-wash); }
.mark.idle { color: var(--soft); font-weight: 400; }
.mark.none { color: var(--soft); font-weight: 400; opacity: 0.6; }
.key .mark { margin-left: 1rem; }
.key .mark:first-child { margin-left: 0; }
.key { font-size: 0.88rem; color: var(--soft); max-width: none; }
.glossary {
  display: flex; flex-wrap: wrap; gap: 0.4rem 2rem; margin: 1.6rem 0 0.8rem; font-size: 0.88rem;
}
.glossary dt { display: inline; font-weight: 620; }
.glossary dd { display: inline; margin: 0 0 0 0.4rem; color: var(--soft); }
.fit { width: fit-content; max-width: 100%; }
.matrix { width: auto; }
.matrix td { text-align: center; padding: 0.2rem 0.25rem; }
.matrix th { white-space: nowrap; }
.matrix td.number { text-align: right; padding: 0.2rem 0.55rem; }
.matrix thead th.upright {
  writing-mode: vertical-rl; transform: rotate(180deg); padding: 0.7rem 0.1rem; text-align: left;
}
.matrix tbody th {
  position: sticky; left: 0; background: var(--card); padding: 0.2rem 1rem 0.2rem 0.8rem;
}
.bar { display: block; width: 100%; min-width: 3rem; height: 4px; margin-top: 3px; }
.bar rect { fill: var(--soft); opacity: 0.55; }
figure { margin: 1.6rem 0 2.4rem; }
figure svg, figure img {
  max-width: 100%; height: auto; border: 1px solid var(--line); border-radius: 10px;
  background: #ffffff;
}
figure img { image-rendering: auto; }
figcaption { font-size: 0.92rem; margin-bottom: 0.5rem; }
details {
  border: 1px solid var(--line); border-radius: 10px; background: var(--card); margin: 0.6rem 0;
  padding: 0 1rem;
}
details[open] { padding-bottom: 1.2rem; }
details .scroll { border-radius: 6px; }
summary { cursor: pointer; padding: 0.6rem 0; }
summary .chip { margin-left: 0.6rem; }
ul.plain { list-style: none; margin: 0; padding: 0; font-size: 0.9rem; }
ul.plain li { padding: 0.15rem 0; }
.why { color: var(--soft); font-size: 0.85rem; overflow-wrap: anywhere; }
@media print {
  main { max-width: none; padding: 0; }
  .scroll { overflow: visible; }
}
)";

}  // namespace rasterproof::report
