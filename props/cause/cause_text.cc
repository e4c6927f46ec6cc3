#include "props/cause/cause_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace rasterproof::props {
namespace {

// "1 draw", "3 draws".
std::string CountedOf(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

// "a rasterizer that A", or "either a rasterizer that A or one that B".
std::string Suspected(const Cause& cause) {
  constexpr std::size_t kMostNamed = 3;
  if (cause.what.size() == 1) return "a rasterizer that " + cause.what.front();
  std::string text = "either a rasterizer that " + cause.what.front();
  for (std::size_t k = 1; k < std::min(kMostNamed, cause.what.size()); ++k)
    text += ", or one that " + cause.what[k];
  if (cause.what.size() <= kMostNamed) return text;
  return text + ", or one of " + std::to_string(cause.what.size() - kMostNamed) + " others";
}

// "3 of 5 draws".
std::string Share(const Cause& cause, std::string_view of) {
  return std::to_string(cause.reproduced) + " of " + std::to_string(cause.draws) + " " +
         std::string(of);
}

std::string FoundText(const Cause& cause, const Causes& causes) {
  switch (cause.kind) {
    case CauseKind::kModel:
      return "your answers equal those of " + Suspected(cause) + " (" + Share(cause, "draws") + ")";
    case CauseKind::kPart:
      if (cause.together != 0) {
        return "your answers equal those of a rasterizer with " + std::to_string(cause.together) +
               " faults at once (" + Share(cause, "draws") + "); one of them: it " +
               cause.what.front();
      }
      return std::to_string(cause.reproduced) + " of the " + std::to_string(cause.draws) +
             " wrong draws equal those of " + Suspected(cause) +
             ", which no draw refutes; the others equal those of other causes";
    case CauseKind::kNothingDrawn:
      return "nothing was drawn at all: 0 of " + std::to_string(cause.draws) +
             " draws cover anything";
    case CauseKind::kCircumstance:
      return "no suspect explains it; what is drawn wrong is right " + cause.what.front();
    case CauseKind::kMistake:
      return "your numbers equal those of " + Suspected(cause) + " (" + Share(cause, "numbers") +
             ")";
    case CauseKind::kShownValues: {
      const std::string all =
          "all " + CountedOf(causes.draws, "draw", "draws") + " are as stated; ";
      return (causes.wrong == 0 ? all : "") +
             "the fault is in values shown beside coverage: " + cause.what.front();
    }
    case CauseKind::kUnexplained:
      break;
  }
  if (cause.rests_on_few) {
    return "too few draws to name a cause: only " +
           CountedOf(cause.wrong_scenes, "scene is", "scenes are") + " drawn wrong, as by " +
           Suspected(cause);
  }
  return "no suspect explains it (" + std::to_string(causes.suspects) + " suspects, " +
         std::to_string(causes.draws) + " draws)";
}

}  // namespace

std::string NameOfCause(const Cause& cause) { return cause.name.empty() ? "none" : cause.name; }

std::string CauseText(const Cause& cause, const Causes& causes) {
  std::string text = FoundText(cause, causes);
  for (std::size_t k = 0; k < cause.only_with.size(); ++k)
    text += (k == 0 ? "; it fails only with " : " and ") + cause.only_with[k];
  if (!cause.pattern.empty()) text += "; every wrong sample " + cause.pattern;
  return text;
}

}  // namespace rasterproof::props
