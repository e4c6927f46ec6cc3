// What a benchmark found, as data: io::ParseBench reads it back.
#ifndef RASTERPROOF_REPORT_BENCH_JSON_H_
#define RASTERPROOF_REPORT_BENCH_JSON_H_

#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// All that there is, the raw times included.
///
/// Properties: BenchToJson(io::ParseBench(BenchToJson(result))) is the same text: numbers are as
///             short as reads back to them, except raw times, which are rounded to six digits.
std::string BenchToJson(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_JSON_H_
