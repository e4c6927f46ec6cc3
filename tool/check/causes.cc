#include "tool/check/causes.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "props/cause/cause_text.h"

namespace rasterproof::tool {
std::string CausesText(const Findings& found) {
  const std::vector<props::Cause>& causes = found.causes.all;
  if (causes.empty()) return "";
  const auto explained = static_cast<std::size_t>(std::ranges::count_if(
      found.all, [](const Finding& finding) { return finding.cause.has_value(); }));
  std::string text;
  for (const props::Cause& cause : causes) {
    text += fmt::format("cause: {}; docs/causes.md#{}\n", props::CauseText(cause, found.causes),
                        props::NameOfCause(cause));
    if (explained == 1) continue;
    std::vector<std::string_view> names;
    for (const std::size_t k : cause.properties) names.push_back(found.all[k].result.property);
    const bool is_open = cause.kind == props::CauseKind::kUnexplained;
    text += fmt::format("  {} {}\n", is_open ? "open:" : "explains", fmt::join(names, ", "));
  }
  if (found.causes.is_cut_short) {
    text +=
        "  the search for causes ran out of time and may have missed another suspect; raise "
        "--cause-seconds\n";
  }
  const auto named = std::ranges::count_if(
      causes, [](const props::Cause& c) { return c.kind != props::CauseKind::kUnexplained; });
  return text + fmt::format("{}, {}\n",
                            Counted(explained, "violated property", "violated properties"),
                            Counted(static_cast<std::size_t>(named), "cause", "causes"));
}

}  // namespace rasterproof::tool
