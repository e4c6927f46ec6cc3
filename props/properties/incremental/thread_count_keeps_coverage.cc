// The number of threads that share the work leaves no trace in the coverage.
#include <string>

#include "core/coverage.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/all.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {
namespace thread_count_keeps_coverage {

Asked Ask(const PlacedCase& c, const Description& /*subject*/) {
  DrawOptions options = WholeTarget(c);
  options.threads = 1;
  Asked asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, options)));
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(c.scene, c.profile, options),
        [&c, threads](const CoverageCounts& observed, const CoverageCounts& base) {
          return SameCounts(observed, base, DecisionsOf(c),
                            "one thread's with " + std::to_string(threads) + " threads");
        }));
  }
  return asked;
}

}  // namespace thread_count_keeps_coverage

constinit const Property kThreadCountKeepsCoverage{
    .name = "ThreadCountKeepsCoverage",
    .group = "incremental",
    .clause = "Sharing the work among threads is not observable.",
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.space = Space::kEither,
             .shows = Shows::kThreads,
             .any_model = true,
             .judges_clipped = true},
    .ask = thread_count_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
