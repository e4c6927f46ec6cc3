// How sure a share is that was counted.
#ifndef RASTERPROOF_REPORT_PROPORTION_H_
#define RASTERPROOF_REPORT_PROPORTION_H_

#include <cstdint>

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

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PROPORTION_H_
