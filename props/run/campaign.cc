#include "props/run/campaign.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "core/error.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/run/near_edge.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kCasesPerProgress = 16;

// The domains of the property that the subject takes.
std::vector<const Domain*> DomainsFor(const SubjectInfo& info, const Property& property) {
  std::vector<const Domain*> domains;
  for (const std::string_view name : property.domains) {
    const Domain* domain = FindDomain(name);
    if (domain != nullptr && Suits(*domain, info)) domains.push_back(domain);
  }
  return domains;
}

std::string SkippedDomains(const SubjectInfo& info, const Property& property) {
  std::string skipped;
  for (const std::string_view name : property.domains) {
    const Domain* domain = FindDomain(name);
    if (domain != nullptr && Suits(*domain, info)) continue;
    skipped += skipped.empty() ? "not drawn, the subject takes no such scenes: " : ", ";
    skipped += name;
  }
  return skipped;
}

void AddSentence(std::string& message, const std::string& sentence) {
  if (sentence.empty()) return;
  if (!message.empty()) message += "; ";
  message += sentence;
}

// What a run adds up to, case by case.
class Tally {
 public:
  Tally(PropertyResult& result, const std::vector<const Domain*>& domains)
      : result_(result), domains_(domains), drawn_(domains.size()), near_edge_(domains.size()) {}

  void AddCase(std::uint64_t index, const Case& c, const Verdict& verdict) {
    ++result_.cases;
    result_.exercised += verdict.exercised;
    if (verdict.exercised != 0) ++result_.cases_exercised;
    result_.worst_ratio = std::max(result_.worst_ratio, verdict.worst_ratio);
    const NearEdgeCounts counts = CountNearEdges(c);
    ++drawn_[index % domains_.size()];
    Add(near_edge_[index % domains_.size()], counts);
    Add(result_.near_edge, counts);
    if (verdict.outcome == Outcome::kNotApplicable) {
      ++not_applicable_;
      if (why_not_.empty()) why_not_ = verdict.message;
    }
  }

  // The outcome of a run without a violation.
  void Conclude() {
    if (result_.cases != 0 && not_applicable_ == result_.cases) {
      result_.outcome = Outcome::kNotApplicable;
      AddSentence(result_.message, why_not_);
      return;
    }
    const std::string dead = DeadDomains();
    const bool holds = result_.exercised != 0 && dead.empty();
    result_.outcome = holds ? Outcome::kHolds : Outcome::kNotExercised;
    if (result_.exercised == 0) AddSentence(result_.message, "no case put the claim to the test");
    AddSentence(result_.message, dead);
  }

 private:
  std::string DeadDomains() const {
    std::string dead;
    for (std::size_t d = 0; d < domains_.size(); ++d) {
      const NearEdgeCounts& counts = near_edge_[d];
      if (!domains_[d]->near_edge || drawn_[d] == 0) continue;
      if (counts.on_edge + counts.within_256 != 0) continue;
      dead += dead.empty() ? "no sample on or near an edge in near-edge domain " : ", ";
      dead += domains_[d]->name;
    }
    return dead;
  }

  PropertyResult& result_;
  const std::vector<const Domain*>& domains_;
  std::vector<std::uint64_t> drawn_;
  std::vector<NearEdgeCounts> near_edge_;
  std::uint64_t not_applicable_ = 0;
  std::string why_not_;
};

Case DrawFrom(const std::vector<const Domain*>& domains, const SubjectInfo& info,
              std::uint64_t seed, std::uint64_t index) {
  const Domain& domain = *domains[index % domains.size()];
  PhiloxSource bits(seed, index);
  Case c = domain.draw(bits, info);
  c.scene.name = domain.name;
  c.origin = "domain " + std::string(domain.name) + ", seed " + std::to_string(seed) + ", case " +
             std::to_string(index);
  return c;
}

void RecordViolation(PropertyResult& result, Subject& subject, const Property& property,
                     const Case& failing, std::uint64_t index, std::uint64_t shrink_budget) {
  result.outcome = Outcome::kViolated;
  result.failing_case = index;
  const auto fails = [&](const Case& candidate) {
    return RunCase(subject, property, candidate).outcome == Outcome::kViolated;
  };
  result.counterexample = Shrink(failing, fails, shrink_budget).minimal;
  result.verdict = RunCase(subject, property, *result.counterexample);
  if (result.verdict->outcome != Outcome::kViolated) {
    AddSentence(result.message,
                "the subject is not deterministic: its counterexample does not fail again");
    return;
  }
  AddSentence(result.message, result.verdict->message);
}

PropertyResult EmptyResult(const Subject& subject, const Property& property, std::uint64_t seed) {
  PropertyResult result;
  result.property = property.name;
  result.subject = subject.Info().name;
  result.clause = property.clause;
  result.tolerance = property.tolerance;
  result.seed = seed;
  return result;
}

}  // namespace

Case DrawCase(const SubjectInfo& info, const Property& property, std::uint64_t seed,
              std::uint64_t index) {
  const std::vector<const Domain*> domains = DomainsFor(info, property);
  if (domains.empty()) {
    throw InputError(std::string(property.name), "the subject takes scenes of none of its domains",
                     "choose another property or subject");
  }
  return DrawFrom(domains, info, seed, index);
}

Verdict RunCase(Subject& subject, const Property& property, const Case& c) {
  const auto threw = [](const std::string& what) {
    return Verdict::Violated(1, "the subject threw: " + what, Witness{});
  };
  try {
    return property.check(subject, c);
  } catch (const InputError& error) {
    // The oracle or the subject says that it takes no such scene.
    return Verdict::NotApplicable(error.what());
  } catch (const std::exception& error) {
    return threw(error.what());
  } catch (...) {
    return threw("something that is no std::exception");
  }
}

PropertyResult RunCampaign(Subject& subject, const Property& property,
                           const CampaignOptions& options) {
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  PropertyResult result = EmptyResult(subject, property, options.seed);
  const std::vector<const Domain*> domains = DomainsFor(subject.Info(), property);
  result.message = SkippedDomains(subject.Info(), property);
  if (domains.empty()) {
    result.outcome = Outcome::kNotApplicable;
    return result;
  }
  Tally tally(result, domains);
  for (std::uint64_t i = 0; i < options.cases; ++i) {
    if (options.seconds > 0 && elapsed() >= options.seconds) break;
    const std::uint64_t index = options.first_case + i;
    const Case c = DrawFrom(domains, subject.Info(), options.seed, index);
    const Verdict verdict = RunCase(subject, property, c);
    tally.AddCase(index, c, verdict);
    if (verdict.outcome == Outcome::kViolated) {
      RecordViolation(result, subject, property, c, index, options.shrink_budget);
      break;
    }
    if (options.progress && result.cases % kCasesPerProgress == 0) options.progress(result.cases);
  }
  if (result.outcome != Outcome::kViolated) tally.Conclude();
  result.seconds = elapsed();
  return result;
}

}  // namespace rasterproof::props
