#include <string_view>

#include "report/page_parts.h"

namespace rasterproof::report {

// A first click on numbers brings the largest up, on words the first of the alphabet; a second one
// turns the order. Cells without a number stay below.
const std::string_view kPageScript = R"("use strict";
function keyOf(row, column, isNumber) {
  const text = row.cells[column].textContent;
  return isNumber ? parseFloat(text.replace(/\s/g, "")) : text;
}
function sortBy(table, head, column) {
  const isNumber = head.classList.contains("number");
  const first = isNumber ? "descending" : "ascending";
  const other = isNumber ? "ascending" : "descending";
  const order = head.getAttribute("aria-sort") === first ? other : first;
  for (const cell of head.parentNode.cells) cell.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", order);
  const sign = order === "ascending" ? 1 : -1;
  const rows = Array.from(table.tBodies[0].rows);
  rows.sort((a, b) => {
    const x = keyOf(a, column, isNumber), y = keyOf(b, column, isNumber);
    if (!isNumber) return sign * x.localeCompare(y);
    return isNaN(x) - isNaN(y) || (isNaN(x) ? 0 : sign * (x - y));
  });
  table.tBodies[0].append(...rows);
}
for (const table of document.querySelectorAll("table.sorts")) {
  Array.from(table.tHead.rows[0].cells).forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    button.addEventListener("click", () => sortBy(table, head, column));
    head.append(button);
  });
}
)";

// tests/tool/certify_test.py holds it against the script of a page.
const std::string_view kPageScriptHash = "79ZpwiaLiYnGtCOItfZJqeXypWsJlZdYlAZAQU5UgjI=";

}  // namespace rasterproof::report
