// The hardest cases of a value, and what a drawer makes of them.
#ifndef RASTERPROOF_BENCH_JUDGED_CASES_H_
#define RASTERPROOF_BENCH_JUDGED_CASES_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "bench/parameter.h"
#include "bench/scene_drawer.h"
#include "core/profile.h"

namespace rasterproof::bench {

/// What a drawer does at one value.
struct CaseErrors {
  std::uint64_t asked = 0;  ///< cases that it took
  std::uint64_t wrong = 0;  ///< of them
  std::optional<HardCase> first_wrong;
  double displacement = 0;  ///< largest distance of a wrong sample from its triangle, pixels
  /// Largest |error of E| over its bound at a sample; NaN: it shows no E, or nothing is stated.
  double share_of_bound = std::numeric_limits<double>::quiet_NaN();
};

/// Whether edge values are compared with their bounds too: of Compared::kSample.
enum class WithBounds : std::uint8_t { kNo, kYes };

/// The cases of every value that was asked for, with what is right of them, both worked out once.
class JudgedCases {
 public:
  /// What the drawer gets wrong at the value.
  CaseErrors Of(SceneDrawer& drawer, const Parameter& parameter, double value, WithBounds bounds);

 private:
  struct Cases {
    std::vector<HardCase> cases;
    std::list<std::pair<Profile, std::vector<bool>>> covered;  // of each model
  };
  const std::vector<bool>& CoveredBy(const Profile& model, Cases& of) const;

  std::map<std::pair<const Parameter*, double>, Cases> known_;
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_JUDGED_CASES_H_
