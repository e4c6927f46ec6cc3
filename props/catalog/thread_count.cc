#include "props/catalog/thread_count.h"

#include <cstdint>
#include <string>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict ThreadCountKeepsCoverage(Subject& subject, const Case& c) {
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

}  // namespace rasterproof::props
