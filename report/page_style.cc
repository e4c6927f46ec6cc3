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
main { max-width: 84rem; margin: 0 auto; padding: 2.5rem 1.5rem 6rem; }
h1 { font-size: 1.15rem; font-weight: 600; color: var(--soft); margin: 0; }
h1.name { color: var(--ink); font-size: 1.6rem; overflow-wrap: anywhere; }
h2 { font-size: 1.35rem; font-weight: 620; letter-spacing: -0.01em; margin: 3rem 0 0.2rem; }
h3, h3.name { font-size: 0.95rem; font-weight: 620; margin: 1.4rem 0 0.3rem; }
p { margin: 0.3rem 0 1rem; max-width: 46rem; }
.lead {
  font-size: 1.35rem; line-height: 1.4; max-width: 60rem; margin: 0.5rem 0;
  overflow-wrap: anywhere;
}
a { color: var(--link); text-decoration: none; }
a:hover { text-decoration: underline; }
code, pre, .number, .name {
  font-family: ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace;
}
code, pre, .name { font-size: 0.84rem; }
pre {
  background: var(--shade); border-radius: 6px; padding: 0.6rem 0.8rem; margin: 0.4rem 0;
  white-space: pre-wrap; overflow-wrap: anywhere;
}
pre code { display: block; padding-left: 2ch; text-indent: -2ch; }
pre span { display: inline-block; max-width: 100%; text-indent: 0; }
.scroll {
  overflow: auto; max-height: min(60rem, 90vh); border: 1px solid var(--line); border-radius: 8px;
  background: var(--card);
}
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; }
th, td { padding: 0.42rem 0.7rem; text-align: left; vertical-align: baseline; }
thead { position: sticky; top: 0; z-index: 2; }
thead th {
  font-weight: 560; color: var(--soft); font-size: 0.8rem; background: var(--card);
  box-shadow: inset 0 -1px var(--line); vertical-align: bottom;
}
tbody tr + tr > * { border-top: 1px solid var(--line); }
tbody th {
  font-weight: 450; position: sticky; left: 0; z-index: 1; background: var(--card);
}
tbody th.name, tbody th > .name, td > .name { white-space: nowrap; }
.verdicts { table-layout: fixed; min-width: 62rem; }
.verdicts th:first-child { width: 25%; }
.verdicts th:nth-child(8) { width: 18%; }
thead tr:first-child th:first-child { position: sticky; left: 0; z-index: 3; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.number { font-size: 0.84rem; }
thead .number { font-family: inherit; white-space: normal; }
thead button {
  font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: pointer;
  text-align: inherit;
}
thead button:hover { color: var(--link); }
[aria-sort] button { color: var(--ink); }
[aria-sort="ascending"] button::before { content: "▲ "; font-size: 0.65rem; }
[aria-sort="descending"] button::before { content: "▼ "; font-size: 0.65rem; }
.right { color: var(--good); }
.zero, .none { color: var(--soft); }
.wrong, .missing { color: var(--bad); font-weight: 600; }
.unexpected { color: var(--over); font-weight: 600; }
.split { border-left: 1px solid var(--line); }
.remark { min-width: 12.5rem; }
.most { white-space: nowrap; }
.names { min-width: 14rem; line-height: 1.7; }
.chip {
  display: inline-block; padding: 0.05rem 0.6rem; border-radius: 99px; font-size: 0.8rem;
  font-weight: 600; white-space: nowrap;
}
.chip.holds { color: var(--good); background: var(--good-wash); }
.chip.violated { color: var(--bad); background: var(--bad-wash); }
.chip.idle { color: var(--soft); border: 1px dashed var(--soft); }
.chip.none { color: var(--soft); font-weight: 400; padding: 0; }
.columns {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(min(22rem, 100%), 1fr));
  gap: 0.3rem 2rem; margin: 0.9rem 0; font-size: 0.85rem;
}
.columns dt { display: inline; font-weight: 620; }
.columns dd { display: inline; margin: 0 0 0 0.4rem; color: var(--soft); }
.matrix { width: auto; }
.matrix td.number { padding: 0.2rem 0.55rem; }
.upright { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap; }
.bar { display: block; width: 100%; min-width: 3rem; height: 4px; margin-top: 3px; }
.bar rect { fill: var(--soft); opacity: 0.55; }
figure { margin: 1.4rem 0 2rem; }
figure .scroll { max-height: none; background: #ffffff; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption { font-size: 0.92rem; margin-bottom: 0.4rem; overflow-wrap: anywhere; }
article { margin: 1.8rem 0; }
.said { margin: 0.2rem 0; }
article h3 { margin-bottom: 0; }
details { margin: 0.8rem 0; }
section > details, .group > details {
  border: 1px solid var(--line); border-radius: 10px; background: var(--card); padding: 0 1rem;
}
section > details[open], .group > details[open] { padding-bottom: 1rem; }
td details { margin: 0; }
summary { cursor: pointer; padding: 0.6rem 0; }
td summary { padding: 0; }
ul.plain { list-style: none; margin: 0; padding: 0; font-size: 0.9rem; }
ul.plain li { padding: 0.15rem 0; overflow-wrap: anywhere; }
.why { color: var(--soft); font-size: 0.85rem; overflow-wrap: anywhere; }
section > .why, header > .why { font-size: 1rem; }
@media (max-width: 44rem) {
  main { padding: 1.5rem 0.8rem 4rem; }
  .lead { font-size: 1.15rem; }
  th, td { padding: 0.4rem 0.5rem; }
  tbody th.name, tbody th > .name { white-space: normal; overflow-wrap: anywhere; }
  tbody th { min-width: 9rem; max-width: 10rem; }
  .wide img { max-width: 50rem; }
  .verdicts { table-layout: auto; min-width: 0; }
  section > details, .group > details { padding: 0 0.6rem; }
}
@media print {
  main { max-width: none; padding: 0; }
  .scroll { overflow: visible; max-height: none; }
}
)";

}  // namespace rasterproof::report
