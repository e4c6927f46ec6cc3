// The number of threads that share the work leaves no trace in the coverage.
#include <cstdint>
#include <string>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (!subject.Info().takes_threads) {
    return Verdict::NotApplicable("the subject draws in one thread");
  }
  const Need need{.space = Space::kEither, .any_model_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  DrawOptions options = WholeTarget(c);
  options.threads = 1;
  const CoverageCounts expected = Drawn(subject, c.scene, c.profile, options);
  std::uint64_t exercised = 0;
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    const CoverageCounts observed = Drawn(subject, c.scene, c.profile, options);
    const Verdict verdict = SameCounts(observed, expected, DecisionsOf(c),
                                       "one thread's with " + std::to_string(threads) + " threads");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kThreadCountKeepsCoverage{
    .name = "ThreadCountKeepsCoverage",
    .group = "incremental",
    .clause = "Sharing the work among threads is not observable.",
    .precondition =
        "contract sample-exact; coordinates within the limit; the subject takes a "
        "number of threads",
    .tolerance = kExact,
    .domains = kCoverage,
    .check = Judge,
};

}  // namespace rasterproof::props
