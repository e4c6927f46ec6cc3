// The page's part on error against run time, in the order of a reader's questions.
#ifndef RASTERPROOF_REPORT_BENCH_PAGE_H_
#define RASTERPROOF_REPORT_BENCH_PAGE_H_

#include <string>
#include <string_view>

#include "core/bench_result.h"

namespace rasterproof::report {

/// What proved coverage costs, in a sentence. Empty if no family has a proved method.
std::string BenchSentence(const BenchResult& bench);

/// The sections. `folder` is where the page lies, as a shell would be told: commands lead there.
std::string BenchSections(const BenchResult& bench, std::string_view folder);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_PAGE_H_
