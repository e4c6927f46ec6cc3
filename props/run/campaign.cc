#include "props/run/campaign.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "props/catalog/degenerate.h"
#include "props/catalog/redraw.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/run/batching.h"
#include "props/run/own_transform.h"
#include "props/run/property_domains.h"
#include "props/run/tally.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kCasesPerProgress = 16;
constexpr std::chrono::seconds kMostShrinking{60};

Case DrawFrom(const std::vector<const Domain*>& domains, const SubjectInfo& info,
              std::uint64_t seed, std::uint64_t index) {
  const Domain& domain = *domains[index % domains.size()];
  PhiloxSource bits(seed, index);
  Case c = DrawNamed(domain, bits, info);
  c.origin = "domain " + std::string(domain.name) + ", seed " + std::to_string(seed) + ", case " +
             std::to_string(index);
  return c;
}

Case Minimal(Subject& subject, const Property& property, const Case& failing,
             std::uint64_t budget) {
  // A subject that hangs costs its whole time limit at every step.
  const Clock::time_point end = Clock::now() + kMostShrinking;
  const auto fails = [&](const Case& candidate) {
    return Clock::now() < end &&
           RunCase(subject, property, candidate).outcome == Outcome::kViolated;
  };
  return Shrink(failing, fails, budget).minimal;
}

// Cases that are run together; the draws of one chunk share calls.
std::size_t ChunkSize(Subject& subject, const Property& property) {
  constexpr std::size_t kCasesInABatch = 32;
  const bool batches = BatchingOf(subject) != nullptr && !property.is_about_sequence;
  return batches ? kCasesInABatch : 1;
}

std::vector<Verdict> RunChunk(Subject& subject, const Property& property,
                              std::span<const Case> cases) {
  if (cases.size() == 1) return {RunCase(subject, property, cases.front())};
  return RunCasesInBatches(subject, *BatchingOf(subject), property, cases);
}

// The result of a run that ended with a violated case. What is violated among other cases must be
// violated alone, or else it is the company that matters.
PropertyResult Failed(Subject& subject, const Property& property, const Case& c,
                      const Verdict& verdict, const CampaignOptions& options, std::uint64_t index,
                      const Tally& tally) {
  const bool was_alone = ChunkSize(subject, property) == 1;
  if (was_alone || RunCase(subject, property, c).outcome == Outcome::kViolated) {
    return tally.Violated(subject, property, Minimal(subject, property, c, options.shrink_budget),
                          index);
  }
  PropertyResult result = tally.Violated(subject, property, c, index);
  result.verdict = verdict;
  result.message = verdict.message +
                   "; alone the case does not fail: what the subject draws "
                   "depends on other scenes";
  return result;
}

// Runs the cases until one fails or the time is up.
PropertyResult RunCases(Subject& subject, const Property& property, const CampaignOptions& options,
                        Clock::time_point start) {
  Tally tally(subject, property, options.seed);
  if (tally.domains().empty()) return tally.Concluded();
  const std::size_t chunk = ChunkSize(subject, property);
  for (std::uint64_t i = 0; i < options.cases;) {
    const std::chrono::duration<double> elapsed = Clock::now() - start;
    if (options.seconds > 0 && elapsed.count() >= options.seconds) break;
    std::vector<Case> cases;
    for (std::uint64_t n = i; n < std::min<std::uint64_t>(i + chunk, options.cases); ++n) {
      cases.push_back(
          DrawFrom(tally.domains(), subject.Info(), options.seed, options.first_case + n));
    }
    const std::vector<Verdict> verdicts = RunChunk(subject, property, cases);
    for (std::size_t k = 0; k < verdicts.size(); ++k, ++i) {
      const std::uint64_t index = options.first_case + i;
      tally.AddCase(index % tally.domains().size(), cases[k], verdicts[k]);
      if (verdicts[k].outcome == Outcome::kViolated) {
        return Failed(subject, property, cases[k], verdicts[k], options, index, tally);
      }
      if (options.progress && tally.cases() % kCasesPerProgress == 0) {
        options.progress(tally.cases());
      }
    }
  }
  return tally.Concluded();
}

// Checks what the profile promises of the case: its model is the one for the target's size, and
// triangles of zero area are taken out where it leaves what they cover unspecified.
Verdict CheckAsPromised(Subject& subject, const Property& property, const Case& c) {
  if (c.profile.targets.empty() && c.profile.zero_area == ZeroArea::kNothing) {
    return property.check(subject, c);
  }
  Case judged = c;
  judged.profile = ForTarget(c.profile, c.scene.width, c.scene.height);
  // A crash or a write outside the target is no freedom of flat triangles.
  if (c.profile.zero_area == ZeroArea::kNothing || property.group == "extremes") {
    return property.check(subject, judged);
  }
  if (c.scene.clip_space && !judged.profile.snap.IsNone()) {
    return {Outcome::kNotExercised, 0, 0, "the area after the division and snapping is not decided",
            std::nullopt};
  }
  const std::vector<std::size_t> flat = FlatTriangles(judged);
  std::vector<std::size_t> kept;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    if (!std::ranges::binary_search(flat, t)) kept.push_back(t);
  }
  Verdict verdict = property.check(subject, OnlyTriangles(judged, kept));
  if (verdict.witness && verdict.witness->triangle >= 0) {
    const auto among_kept = static_cast<std::size_t>(verdict.witness->triangle);
    verdict.witness->triangle = static_cast<int>(kept[among_kept]);
  }
  if (verdict.outcome == Outcome::kViolated && !flat.empty()) {
    verdict.message += "; it numbers the triangles without those of zero area";
  }
  return verdict;
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
    return CheckSeen(subject, c, [&](Subject& seen, const Case& seen_case) {
      return CheckAsPromised(seen, property, seen_case);
    });
  } catch (const InputError& error) {
    // The oracle or the subject says that it takes no such scene.
    return Verdict::NotApplicable(error.what());
  } catch (const SubjectFault& fault) {
    return Verdict::Violated(1, std::string("the subject failed: ") + fault.what(), Witness{});
  } catch (const std::exception& error) {
    return threw(error.what());
  } catch (...) {
    return threw("something that is no std::exception");
  }
}

PropertyResult RunCampaign(Subject& subject, const Property& property,
                           const CampaignOptions& options) {
  const Clock::time_point start = Clock::now();
  PropertyResult result = RunCases(subject, property, options, start);
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace rasterproof::props
