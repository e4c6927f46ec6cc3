// The number of threads that share the work leaves no trace in the coverage.
#include <string>

#include "core/draw_options.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace thread_count_keeps_coverage {

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  return CompareOption(c, &DrawOptions::threads, 1, {2, 3, 8}, [](int threads) {
    return "one thread's with " + std::to_string(threads) + " threads";
  });
}

}  // namespace thread_count_keeps_coverage

extern const Property kThreadCountKeepsCoverage;
constinit const Property kThreadCountKeepsCoverage{
    .name = "ThreadCountKeepsCoverage",
    .group = "coverage",
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
