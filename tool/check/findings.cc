#include "tool/check/findings.h"

#include <algorithm>
#include <utility>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "props/run/conclude.h"
#include "report/grounds.h"
#include "report/text.h"
#include "tool/check/causes.h"
#include "tool/exit_status.h"
#include "tool/failure.h"

namespace rasterproof::tool {
namespace {

constexpr std::size_t kFew = 10;  // so many lines of properties that did not fail are shown

bool IsUnasked(const PropertyResult& result) {
  return result.outcome == Outcome::kNotApplicable && !result.counterexample;
}

std::uint64_t Known(const Findings& found) {
  return static_cast<std::uint64_t>(std::ranges::count(found.all, true, &Finding::is_known));
}

// Violations that fail nothing are none.
std::uint64_t CountOf(const Findings& found, Outcome outcome) {
  const auto count = std::ranges::count_if(found.all, [&](const Finding& finding) {
    return finding.result.outcome == outcome && !finding.is_known &&
           !IsLackOfQuality(finding.result, found.fail_on);
  });
  const bool one_more = outcome == Outcome::kInconclusive && found.is_contract_untested;
  return static_cast<std::uint64_t>(count) + (one_more ? 1 : 0);
}

std::uint64_t QualityOf(const Findings& found) {
  return static_cast<std::uint64_t>(std::ranges::count_if(found.all, [&](const Finding& finding) {
    return !finding.is_known && IsLackOfQuality(finding.result, found.fail_on);
  }));
}

// The outcome, or that it is a violation which fails nothing.
std::string_view OutcomeWord(const PropertyResult& result, FailOn fail_on) {
  return IsLackOfQuality(result, fail_on) ? AuthorityName(Authority::kQuality)
                                          : OutcomeName(result.outcome);
}

// Less is worse. A breakdown is worse than a wrong sample.
int Rank(const Findings& of, const Finding& finding) {
  const PropertyResult& result = finding.result;
  if (FailsTheRun(of, finding)) {
    const auto& found = result.counterexample;
    return found && found->verdict.outcome == Outcome::kViolated && !found->verdict.broke_down;
  }
  if (finding.is_known) return 4;
  switch (result.outcome) {
    case Outcome::kInconclusive:
      return 2;
    case Outcome::kRefused:
      return 3;
    case Outcome::kViolated:
      return 5;  // short of quality
    case Outcome::kNotExercised:
      return 6;
    case Outcome::kHolds:
      return 7;
    case Outcome::kNotApplicable:
      break;
  }
  return 8;
}

bool IsOfInterest(const Finding& finding) {
  const PropertyResult& result = finding.result;
  // Whoever gives a scene with a crack would see the crack.
  if (result.in_gaps != 0 && !finding.place.empty()) return true;
  if (HasWideError(result)) return true;
  return result.outcome != Outcome::kHolds && result.outcome != Outcome::kNotExercised;
}

// In full: scene, picture, edge values, the command.
std::string FullText(const Findings& found, const Finding& finding) {
  const Counterexample& failed = *finding.result.counterexample;
  std::string text = FailureText(found.info, finding.result.property, failed.value, failed.verdict,
                                 finding.replay);
  if (!failed.failing_case.empty()) text += "shrunk from " + failed.failing_case + "\n";
  return text;
}

// Two lines: where it failed, and the command.
std::string BriefText(const Findings& found, const Finding& finding) {
  const Counterexample& failed = *finding.result.counterexample;
  return FailureLine(found.info, finding.result.property, failed.value, failed.verdict) +
         "\nreplay: " + finding.replay + "\n";
}

// Why properties were not put to the subject: one line for each reason and scene.
class NotAsked {
 public:
  void Add(const Finding& finding) {
    std::string text = finding.place.empty() ? "" : finding.place + ": ";
    text += finding.result.message;
    const auto same = std::ranges::find(reasons_, text, &Reason::text);
    Reason& entry = same != reasons_.end() ? *same : reasons_.emplace_back(Reason{text, {}});
    entry.properties.push_back(finding.result.property);
    ++count_;
  }
  std::size_t count() const { return count_; }
  std::string Lines(const std::string& subject) const {
    std::string lines;
    for (const Reason& reason : reasons_) {
      lines += fmt::format("{:<16} {:<10} {}: {}\n", OutcomeName(Outcome::kNotApplicable), subject,
                           reason.text, fmt::join(reason.properties, ", "));
    }
    return lines;
  }

 private:
  struct Reason {
    std::string text;
    std::vector<std::string> properties;
  };
  std::vector<Reason> reasons_;
  std::size_t count_ = 0;
};

}  // namespace

bool FailsTheRun(const Findings& found, const Finding& finding) {
  return IsFailure(finding.result, found.fail_on) && !finding.is_known;
}

int StatusOf(const Findings& found) {
  if (found.expired != 0 || CountOf(found, Outcome::kViolated) != 0) return kExitViolated;
  if (CountOf(found, Outcome::kInconclusive) != 0) return kExitInconclusive;
  // Of properties on given scenes. A campaign has counted the refusals of its cases itself.
  if (props::RefusesTooMuch(CountOf(found, Outcome::kRefused), CountOf(found, Outcome::kHolds)))
    return kExitInconclusive;
  const bool is_any = CountOf(found, Outcome::kHolds) + QualityOf(found) + Known(found) != 0;
  return is_any ? kExitHolds : kExitInconclusive;
}

std::string Counted(std::size_t n, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string LastLine(const Findings& found) {
  const auto of = [&found](Outcome outcome) { return CountOf(found, outcome); };
  std::string line = fmt::format("{}: {} hold, {} violated, {} not exercised, {} not applicable",
                                 found.subject, of(Outcome::kHolds), of(Outcome::kViolated),
                                 of(Outcome::kNotExercised), of(Outcome::kNotApplicable));
  for (const Outcome outcome : {Outcome::kRefused, Outcome::kInconclusive}) {
    if (of(outcome) != 0) line += fmt::format(", {} {}", of(outcome), OutcomeName(outcome));
  }
  if (const auto quality = QualityOf(found)) line += fmt::format(", {} short of quality", quality);
  if (const auto known = Known(found)) line += fmt::format(", {} known to fail", known);
  if (found.expired != 0) line += fmt::format(", {} known but expired", found.expired);
  if (found.not_asked != 0)
    line += fmt::format(", {} not asked after the first failure", found.not_asked);
  std::uint64_t cases = 0;
  std::uint64_t refused = 0;
  for (const Finding& finding : found.all) {
    cases += finding.result.cases;
    refused += finding.result.cases_refused;
  }
  line += fmt::format("; {} cases", cases);
  if (refused != 0) line += fmt::format(", {} of them refused", refused);
  return line + "\n";
}

std::string OutcomeLine(const PropertyResult& result, FailOn fail_on, const std::string& counts) {
  std::string line = fmt::format("{:<16} {:<10} {:<50} {}", OutcomeWord(result, fail_on),
                                 result.subject, result.property, counts);
  if (result.cases_refused != 0) line += fmt::format(", {} refused", result.cases_refused);
  if (result.not_judged != 0) {
    line += fmt::format(", {} samples not judged: a legal choice could turn the triangle",
                        result.not_judged);
  }
  if (const std::string gaps = report::GapsText(result); !gaps.empty()) line += ", " + gaps;
  if (result.worst_ratio != 0) line += fmt::format(", error/bound {:.3f}", result.worst_ratio);
  if (!result.message.empty()) line += "; " + report::CleanText(result.message);
  return line + "; " + report::AuthorityText(result) + "\n";
}

std::string FindingsText(const Findings& found, bool verbose) {
  std::vector<const Finding*> order;
  NotAsked not_asked;
  std::size_t dull = 0;
  for (const Finding& finding : found.all) {
    if (IsUnasked(finding.result)) {
      not_asked.Add(finding);
      continue;
    }
    order.push_back(&finding);
    dull += IsOfInterest(finding) ? 0 : 1;
  }
  std::ranges::sort(order, {}, [&](const Finding* finding) {
    return std::pair(Rank(found, *finding), finding - found.all.data());
  });
  const bool all = verbose || found.all.size() <= kFew;
  std::string text;
  std::size_t shown = 0;
  std::size_t shortened = 0;
  for (const Finding* finding : order) {
    if (!all && !IsOfInterest(*finding)) continue;
    if (finding->is_known) {
      constexpr std::size_t kWord = 16;  // the width of a line's first word
      text += fmt::format("{:<{}}", "known", kWord) + finding->line.substr(kWord);
      if (verbose) text += FullText(found, *finding);
      continue;
    }
    text += finding->line;
    if (!finding->result.counterexample) continue;
    const bool in_full = verbose || shown++ == 0;
    text += in_full ? FullText(found, *finding) : BriefText(found, *finding);
    shortened += in_full ? 0 : 1;
  }
  if (all) text += not_asked.Lines(found.subject);
  std::vector<std::string> rest;
  if (shortened != 0)
    rest.push_back(Counted(shortened, "more failure in full", "more failures in full"));
  if (!all && dull != 0) {
    rest.push_back(Counted(dull, "property that holds or is not exercised",
                           "properties that hold or are not exercised"));
  }
  if (!all && not_asked.count() != 0) {
    rest.push_back(fmt::format("why {} not applicable",
                               Counted(not_asked.count(), "property is", "properties are")));
  }
  if (!rest.empty()) text += fmt::format("--verbose shows {}\n", fmt::join(rest, ", "));
  text += found.notes;
  if (found.unasked.empty()) return text;
  return text + fmt::format("{:<16} {:<10} {}\n", "not asked", found.subject,
                            report::NotAskedText(found.unasked));
}

}  // namespace rasterproof::tool
