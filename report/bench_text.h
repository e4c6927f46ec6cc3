// What a benchmark found, as a table.
#ifndef RASTERPROOF_REPORT_BENCH_TEXT_H_
#define RASTERPROOF_REPORT_BENCH_TEXT_H_

#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// What is shown of the wrong decisions: proved, 0 of so many, or a rate.
enum class ErrorLane : std::uint8_t {
  kProved,  ///< 0, by proof, inside the method's limit
  kNone,    ///< 0 of N
  kRate,    ///< some
  kNotJudged
};

/// The lane of a row against real geometry: proved only where the model is real geometry.
ErrorLane LaneOf(const BenchResult& result, const BenchRow& row);

/// Nanoseconds of a row's median for a triangle of its family.
double NanosecondsATriangle(const BenchResult& result, const BenchRow& row);

/// A table a family, cheapest first within a sink.
std::string BenchToTable(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_TEXT_H_
