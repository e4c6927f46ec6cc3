// Bench files: results of a benchmark as JSON, the output of `rasterproof bench --json`.
#ifndef RASTERPROOF_REPORT_BENCH_JSON_H_
#define RASTERPROOF_REPORT_BENCH_JSON_H_

#include <string>
#include <string_view>

#include "core/bench_result.h"

namespace rasterproof::report {

/// The text of a bench file with the whole result, raw times included.
///
/// Properties: BenchToJson(ParseBench(BenchToJson(result), place)) is the same text: numbers are as
///             short as reads back to them, except raw times, which are rounded to six digits. It
///             can stand in a script element of a page as it is: "<" is written "\u003c".
std::string BenchToJson(const BenchResult& result);

/// The record of a bench file's text. `place` begins the place of every error.
///
/// Error:      InputError if it is not a bench file of version 3, for values out of their range,
///             and for rows that name a family, method or parameter that the file does not list.
BenchResult ParseBench(std::string_view text, const std::string& place);

/// The same of a file; "-" is standard input.
BenchResult ReadBench(const std::string& path);

/// The result as its file tells it, times rounded: what is printed of it is what `bench --from`
/// prints of the file.
BenchResult AsRecorded(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_JSON_H_
