// How sure a share is that was counted.
#ifndef RASTERPROOF_REPORT_PROPORTION_H_
#define RASTERPROOF_REPORT_PROPORTION_H_

#include <cstdint>
#include <string>

namespace rasterproof::report {

struct Interval {
  double low = 0;
  double high = 0;
};

/// Returns Wilson's interval of 95 % for the share of which `count` of `of` were seen.
///
/// Domain:     count <= of, of > 0.
/// Source:     Wilson, Probable inference, the law of succession, and statistical inference (1927).
Interval ProportionInterval(std::uint64_t count, std::uint64_t of);

/// Returns a share as a percentage of two digits, three from 99.5 % on: "0.45", "37", "100".
///
/// Domain:     0 <= share <= 1.
std::string Percent(double share);

/// Returns "3 of 100, 1 to 8.5 %": what was counted and its interval.
///
/// Domain:     as ProportionInterval.
std::string CountedText(std::uint64_t count, std::uint64_t of);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PROPORTION_H_
