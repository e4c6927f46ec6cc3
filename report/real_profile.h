// The profile of exact real geometry, against which every subject is measured beside its own.
#ifndef RASTERPROOF_REPORT_REAL_PROFILE_H_
#define RASTERPROOF_REPORT_REAL_PROFILE_H_

#include <string_view>

namespace rasterproof::report {

inline constexpr std::string_view kRealProfile = "real";

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_REAL_PROFILE_H_
