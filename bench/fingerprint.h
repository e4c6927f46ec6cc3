// The picture of one decision over neighbouring inputs: what a method says of a sample beside a
// shared edge while one end of the edge goes through 256 x 256 places. After Kettner, Mehlhorn,
// Pion, Schirra and Yap, "Classroom examples of robustness problems in geometric computations"
// (2008), who look at an orientation test in double this way.
#ifndef RASTERPROOF_BENCH_FINGERPRINT_H_
#define RASTERPROOF_BENCH_FINGERPRINT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/contender.h"
#include "bench/family.h"
#include "core/profile.h"

namespace rasterproof::bench {

/// Between neighbouring places.
struct FingerprintStep {
  std::string_view name;
  double pixels = 0;
};

/// An ulp is that of float32 from 0.5 on, where the places' middle is.
inline constexpr std::array kFingerprintSteps{
    FingerprintStep{"1 ulp", 0x1p-24}, FingerprintStep{"2^-12", 0x1p-12},
    FingerprintStep{"1/256", 0x1p-8}, FingerprintStep{"1/16", 0x1p-4}};

/// Which of the two triangles of the shared edge cover the sample.
enum class SampleOwner : std::uint8_t { kInside, kBoth, kNeither, kOutside };

/// What a method says in every place, and what its own model says.
struct Fingerprint {
  /// Places along either axis: 256, or every fourth of them, 64, where drawing one takes long.
  int side = 0;
  /// Row-major: x grows along the row, y from row to row.
  std::vector<SampleOwner> drawn;
  std::vector<SampleOwner> exact;

  std::uint64_t Wrong() const;
};

/// The places of one step.
///
/// The end A of the shared edge A B goes through (0.5 + i step, 0.5 + j step), i and j from -128 to
/// 127; B is (24.5, 24.5), the sample (12.5, 12.5), in the middle of the edge where i = j = 0, and
/// on its line wherever i = j. The inside is the triangle A B (2.5, 30.5), the outside the triangle
/// B A (30.5, 2.5): in every place exactly one of them covers the sample. All numbers are float32.
class FingerprintPlaces {
 public:
  static constexpr int kSide = 256;

  explicit FingerprintPlaces(const FingerprintStep& step);

  /// Why there is no fingerprint of it; nothing if there is one.
  std::optional<std::string> WhyNot(const Contender& contender) const;
  /// Draws both triangles of every place, each alone, and looks at the sample. In clip space
  /// every w is 1.
  ///
  /// Domain:     WhyNot() says nothing.
  /// Error:      of a user's subject: what it throws.
  Fingerprint Of(Contender& contender);

 private:
  const std::vector<SampleOwner>& ExactBy(const Profile& model);

  FamilyInput window_;
  FamilyInput clip_;
  std::list<std::pair<Profile, std::vector<SampleOwner>>> exact_;  // of each model
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_FINGERPRINT_H_
