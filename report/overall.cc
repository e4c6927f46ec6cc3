// What a certificate comes to, and what it does not speak for.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "fmt/format.h"
#include "report/certificate.h"

namespace rasterproof::report {
namespace {

constexpr std::string_view kObserved = ": observed, not judged";

// Empty if none is.
std::string Violations(const Certificate& certificate) {
  const auto violated = std::ranges::count_if(
      certificate.tested,
      [&](const PropertyResult& result) { return IsFailure(result, certificate.fail_on); });
  const auto wrong = std::ranges::count_if(certificate.measured, [&](const SceneResult& result) {
    return IsJudged(certificate, result) && result.difference.wrong != 0;
  });
  std::string text;
  if (violated != 0) text = fmt::format("properties violated: {}", violated);
  if (wrong != 0)
    text += fmt::format("{}scenes with wrong samples: {}", violated ? "; " : "", wrong);
  return text;
}

// Empty if something of the contract was put to the test.
std::string WhyNotExercised(const Certificate& certificate) {
  const bool judged = std::ranges::any_of(certificate.measured, [&](const SceneResult& result) {
    return IsJudged(certificate, result) && result.difference.samples != 0;
  });
  if (judged) return "";
  if (std::ranges::count(certificate.tested, Outcome::kHolds, &PropertyResult::outcome) == 0) {
    return "nothing was exercised";
  }
  if (certificate.contract_untested.empty()) return "";
  return "its contract was not put to the test: " + certificate.contract_untested;
}

void AddOnce(const std::string& statement, const std::string& by, std::vector<Evidence>& list) {
  if (!std::ranges::count(list, statement, &Evidence::statement)) list.push_back({statement, by});
}

}  // namespace

std::string WhyNotJudged(const Certificate& certificate, const SceneResult& result) {
  const Profile& own = certificate.subject.profile;
  if (!result.applicable) return "not applicable: " + result.message;
  if (!result.message.empty()) return result.message;
  if (result.profile != own.name) {
    return "against " + result.profile + ", which is not the subject's profile" +
           std::string(kObserved);
  }
  if (certificate.subject.states_exact || HasOneModel(own)) return "";
  return "its profile leaves more than one result legal" + std::string(kObserved);
}

bool IsJudged(const Certificate& certificate, const SceneResult& result) {
  return WhyNotJudged(certificate, result).empty();
}

Overall OverallOf(const Certificate& certificate) {
  const std::string violations = Violations(certificate);
  if (!violations.empty()) return {Outcome::kViolated, violations};
  if (certificate.interrupted) {
    return {Outcome::kInconclusive, "interrupted before all was done"};
  }
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome != Outcome::kInconclusive) continue;
    return {Outcome::kInconclusive,
            NameOf(result) + (result.message.empty() ? "" : ": " + result.message)};
  }
  const std::string why = WhyNotExercised(certificate);
  if (!why.empty()) return {Outcome::kInconclusive, why};
  const auto lacks = std::ranges::count_if(certificate.tested, [&](const PropertyResult& result) {
    return IsLackOfQuality(result, certificate.fail_on);
  });
  std::string but = certificate.contract_thin;
  if (lacks != 0) {
    but += fmt::format("{}properties short of quality: {}", but.empty() ? "" : "; ", lacks);
  }
  return {Outcome::kHolds, but};
}

std::string OverallVerdict(const Certificate& certificate) {
  return std::string(OutcomeName(OverallOf(certificate).outcome));
}

std::vector<Evidence> ScenesNotDrawn(const Certificate& certificate) {
  std::vector<Evidence> list;
  for (const SceneResult& result : certificate.measured) {
    if (!result.applicable) AddOnce("scene " + result.scene, result.message, list);
  }
  return list;
}

std::vector<Evidence> NotApplicable(const Certificate& certificate) {
  std::vector<Evidence> list;
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome == Outcome::kNotApplicable) AddOnce(NameOf(result), result.message, list);
  }
  std::ranges::copy(ScenesNotDrawn(certificate), std::back_inserter(list));
  return list;
}

std::vector<Evidence> Exhausted(const Certificate& certificate) {
  std::vector<Evidence> list;
  for (const PropertyResult& result : certificate.tested) {
    if (!IsExhausted(result)) continue;
    list.push_back(
        {NameOf(result), fmt::format("all {} of {} cases, {} of which put it to the test{}{}",
                                     result.cases, result.world_cases, result.cases_exercised,
                                     result.message.empty() ? "" : "; ", result.message)});
  }
  return list;
}

std::map<std::string, std::uint64_t> TiersByName(const Certificate& certificate) {
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [name, tier] : kTiers) counts.emplace(name, certificate.oracle_tiers.*tier);
  return counts;
}

std::string GapsText(const PropertyResult& result) {
  if (result.in_gaps == 0) return "";
  return fmt::format("{} samples lie in cracks or holes of the scenes themselves", result.in_gaps);
}

std::string Reservations(const PropertyResult& result) {
  std::string text;
  const std::string refused =
      fmt::format("exercised in {} of {} cases, {} refused", result.cases_exercised, result.cases,
                  result.cases_refused);
  if (result.cases_refused != 0 && !result.message_counts_refused) {
    const bool holds = result.outcome == Outcome::kHolds;
    text = (holds ? "holds where it did not refuse: " : "") + refused;
  }
  if (result.not_judged != 0) {
    text += fmt::format("{}{} samples not judged: a legal choice could turn a triangle there",
                        text.empty() ? "" : "; ", result.not_judged);
  }
  if (const std::string gaps = GapsText(result); !gaps.empty()) {
    text += (text.empty() ? "" : "; ") + gaps;
  }
  return text;
}

std::string Said(const PropertyResult& result) {
  const std::string reservations = Reservations(result);
  const bool both = !result.message.empty() && !reservations.empty();
  return result.message + (both ? "; " : "") + reservations;
}

}  // namespace rasterproof::report
