// Reads bench files, the output of `rasterproof bench --json`. report::BenchToJson writes them.
#ifndef RASTERPROOF_IO_BENCH_FILE_H_
#define RASTERPROOF_IO_BENCH_FILE_H_

#include <string>
#include <string_view>

#include "core/bench_result.h"

namespace rasterproof::io {

/// The record of a bench file's text. `place` begins the place of every error.
///
/// Error:      InputError if it is not a bench file of version 3, for values out of their range,
///             and for rows that name a family, method or parameter that the file does not list.
BenchResult ParseBench(std::string_view text, const std::string& place);

/// The same of a file; "-" is standard input.
BenchResult ReadBench(const std::string& path);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_BENCH_FILE_H_
