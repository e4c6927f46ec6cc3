#include "tool/check/causes.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "fmt/ranges.h"

namespace rasterproof::tool {
namespace {

using props::Cause;
using props::CauseKind;

// "a rasterizer that A", or "either a rasterizer that A or one that B".
std::string Suspected(const Cause& cause) {
  constexpr std::size_t kMostNamed = 3;
  if (cause.what.size() == 1) return "a rasterizer that " + cause.what.front();
  std::string text = "either a rasterizer that " + cause.what.front();
  for (std::size_t k = 1; k < std::min(kMostNamed, cause.what.size()); ++k)
    text += ", or one that " + cause.what[k];
  if (cause.what.size() <= kMostNamed) return text;
  return text + fmt::format(", or one of {} others", cause.what.size() - kMostNamed);
}

std::string FoundText(const Cause& cause, const props::Causes& causes) {
  switch (cause.kind) {
    case CauseKind::kModel:
      return fmt::format("your answers equal those of {} ({} of {} draws)", Suspected(cause),
                         cause.reproduced, cause.draws);
    case CauseKind::kPart:
      if (cause.together != 0) {
        return fmt::format(
            "your answers equal those of a rasterizer with {} faults at once ({} of {} draws); one "
            "of them: it {}",
            cause.together, cause.reproduced, cause.draws, cause.what.front());
      }
      return fmt::format(
          "{} of the {} wrong draws equal those of {}, which no draw refutes; the others equal "
          "those "
          "of other causes",
          cause.reproduced, cause.draws, Suspected(cause));
    case CauseKind::kNothingDrawn:
      return fmt::format("nothing was drawn at all: 0 of {} draws cover anything", cause.draws);
    case CauseKind::kCircumstance:
      return fmt::format("no suspect explains it; what is drawn wrong is right {}",
                         cause.what.front());
    case CauseKind::kMistake:
      return fmt::format("your numbers equal those of {} ({} of {} numbers)", Suspected(cause),
                         cause.reproduced, cause.draws);
    case CauseKind::kShownValues:
      return fmt::format("{}the fault is in values shown beside coverage: {}",
                         causes.wrong == 0 ? fmt::format("all {} are as stated; ",
                                                         Counted(causes.draws, "draw", "draws"))
                                           : "",
                         cause.what.front());
    case CauseKind::kUnexplained:
      break;
  }
  if (cause.rests_on_few) {
    return fmt::format("too few draws to name a cause: only {} drawn wrong, as by {}",
                       Counted(cause.wrong_scenes, "scene is", "scenes are"), Suspected(cause));
  }
  return fmt::format("no suspect explains it ({} suspects, {} draws)", causes.suspects,
                     causes.draws);
}

}  // namespace

std::string NameOfCause(const Cause& cause) { return cause.name.empty() ? "none" : cause.name; }

std::string CauseText(const Cause& cause, const props::Causes& causes) {
  std::string text = FoundText(cause, causes);
  if (!cause.only_with.empty())
    text += fmt::format("; it fails only with {}", fmt::join(cause.only_with, " and "));
  if (!cause.pattern.empty()) text += "; every wrong sample " + cause.pattern;
  return text;
}

std::string CausesText(const Findings& found) {
  const std::vector<Cause>& causes = found.causes.all;
  if (causes.empty()) return "";
  const auto explained = static_cast<std::size_t>(std::ranges::count_if(
      found.all, [](const Finding& finding) { return finding.cause.has_value(); }));
  std::string text;
  for (const Cause& cause : causes) {
    text += fmt::format("cause: {}; docs/causes.md#{}\n", CauseText(cause, found.causes),
                        NameOfCause(cause));
    if (explained == 1) continue;
    std::vector<std::string_view> names;
    for (const std::size_t k : cause.properties) names.push_back(found.all[k].result.property);
    const bool is_open = cause.kind == CauseKind::kUnexplained;
    text += fmt::format("  {} {}\n", is_open ? "open:" : "explains", fmt::join(names, ", "));
  }
  if (found.causes.is_cut_short) {
    text +=
        "  the search for causes ran out of time and may have missed another suspect; raise "
        "--cause-seconds\n";
  }
  const auto named = std::ranges::count_if(
      causes, [](const Cause& c) { return c.kind != CauseKind::kUnexplained; });
  return text + fmt::format("{}, {}\n",
                            Counted(explained, "violated property", "violated properties"),
                            Counted(static_cast<std::size_t>(named), "cause", "causes"));
}

}  // namespace rasterproof::tool
