// Cliffs of a benchmark as text.
#ifndef RASTERPROOF_REPORT_LIMITS_TEXT_H_
#define RASTERPROOF_REPORT_LIMITS_TEXT_H_

#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// "4097", "2^53", "2^24 + 1", "94906265", "2^-24".
std::string ValueText(double value);

/// What a cliff says: "proved to 4096, first seen failing at 4098, not proved between".
std::string CliffText(const BenchCliff& cliff);

/// The cliffs alone: a section for each parameter, a line for each method.
std::string LimitsToTable(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_LIMITS_TEXT_H_
