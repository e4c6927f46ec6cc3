// What the field says of interpolated values, measured: lines that follow from a bench record.
#ifndef RASTERPROOF_REPORT_VALUE_ADVICE_H_
#define RASTERPROOF_REPORT_VALUE_ADVICE_H_

#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

/// A piece of advice and what the record says of it.
struct ValueAdvice {
  std::string_view text;    ///< "Interpolate in double"
  std::string_view method;  ///< who follows it
  std::string_view beside;  ///< what it is compared with
  std::string measured;     ///< a sentence
};

/// Those of which the record has both methods on a family.
std::vector<ValueAdvice> ValueAdviceOf(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_VALUE_ADVICE_H_
