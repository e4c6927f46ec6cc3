// Runs the properties on a mutant, a few cases at a time, until one of them finds the bug.
#ifndef RASTERPROOF_LAB_SELFTEST_SELFTEST_H_
#define RASTERPROOF_LAB_SELFTEST_SELFTEST_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/subject.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutants.h"

namespace rasterproof::lab {

/// What a hunt ended with.
struct Hunt {
  /// The violation that ended it, shrunken; nothing if every property held.
  std::optional<PropertyResult> violation;
  std::uint64_t cases = 0;      ///< run in all, over all properties, the violating one included
  std::uint64_t exercised = 0;  ///< cases that put a property to the test
  /// Runs that could not be judged: the subject is not deterministic, or refuses too much.
  std::uint64_t inconclusive = 0;
  double seconds = 0;  ///< shrinking included
};

/// Runs the catalogue on the subject until a property is violated.
///
/// Every property has its turn in rounds that grow fourfold: a bug that any property sees at once
/// does not wait for the thousandth case of another one. A property that says in the first round
/// that it does not apply is asked no more. Progress is in cases over all properties. A violation
/// of quality counts of properties named in `killers`: the bug may be one that no clause forbids.
Hunt HuntBug(Subject& subject, const props::CampaignOptions& options,
             std::span<const std::string> killers = {});

/// A hunt to be run: each mutant has one, and each legal variant several, which pass only by
/// running to the end.
struct HuntTask {
  subjects::MutantInfo mutant;
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;  ///< most cases a property
};
std::vector<HuntTask> HuntTasks(const std::vector<subjects::MutantInfo>& mutants,
                                std::uint64_t seed, std::uint64_t cases);

/// A mutant or legal variant, and what a hunt found of it.
struct HuntResult {
  subjects::MutantInfo mutant;
  std::uint64_t seed = 0;
  Hunt hunt;

  bool AsItShould() const { return hunt.violation.has_value() != mutant.legal; }
};

/// Makes the subject and hunts; `progress` is told of cases.
HuntResult RunHunt(const HuntTask& task, const std::function<void(std::uint64_t)>& progress);

/// What was found to explain a mutant's violation.
struct CauseFound {
  subjects::MutantInfo mutant;
  std::string name = {};  ///< of docs/causes.md; empty: none was named
  std::string what = {};
  bool is_circumstance = false;  ///< no suspect explains it, and something makes the draws right
  std::string property = {};     ///< the violated one
};
/// Explains the violation that a hunt ended with.
CauseFound FindCauseOf(const HuntResult& result);
/// A table row a mutant, then how many causes were named rightly, wrongly or not at all, in the
/// half that suspects were tuned on (an even FNV-1a hash of the name) and in the other one.
std::string CausesTable(std::span<const CauseFound> all);

/// What a self-test of so many cases found, as Markdown: a table row a mutant, then the figures.
std::string SelftestText(const std::vector<HuntResult>& results, std::uint64_t cases,
                         double seconds);
/// The same as JSON.
std::string SelftestJson(const std::vector<HuntResult>& results);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SELFTEST_SELFTEST_H_
