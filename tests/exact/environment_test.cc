#include "exact/environment.h"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <stdexcept>
#include <string>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "exact/edge.h"

namespace rasterproof::exact {
namespace {

TEST(Environment, OfThisTestIsHonest) {
  const Environment environment = InspectEnvironment();
  EXPECT_TRUE(environment.Honest()) << environment.Complaint();
  EXPECT_EQ(environment.Complaint(), "");
  EXPECT_NO_THROW(RequireHonestEnvironment());
  EXPECT_FALSE(environment.compiler.empty());
  EXPECT_NE(environment.flags.find("-ffp-contract=off"), std::string::npos) << environment.flags;
}

TEST(Environment, IsRefusedUnderEveryDirectedRounding) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Environment environment = InspectEnvironment();
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(environment.round_to_nearest);
    EXPECT_NE(environment.Complaint().find("rounding mode"), std::string::npos);
  }
}

#ifdef __SSE2__
TEST(Environment, IsRefusedIfSubnormalsAreFlushedOrTakenForZero) {
  constexpr unsigned kFlushToZero = 0x8000;
  constexpr unsigned kDenormalsAreZero = 0x0040;
  const unsigned before = _mm_getcsr();
  for (const unsigned mode : {kFlushToZero, kDenormalsAreZero}) {
    _mm_setcsr(before | mode);
    const Environment environment = InspectEnvironment();
    bool refused = false;
    try {
      RequireHonestEnvironment();
    } catch (const std::logic_error&) {
      refused = true;
    }
    // The integer decider is immune.
    const int sign = EdgeSign({0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}, Decider::kIntegers);
    _mm_setcsr(before);
    EXPECT_FALSE(environment.subnormals_kept) << mode;
    EXPECT_TRUE(refused);
    EXPECT_EQ(sign, -1);
  }
}
#endif

// Fails where the whole build lets the compiler fuse or drop roundings, not only the oracle's file.
TEST(Environment, OfThisFileNeitherFusesNorDropsRoundings) {
  volatile double a = 1 + 0x1p-27;
  volatile double c = -(1 + 0x1p-26);
  const double x = a;
  const double z = c;
  EXPECT_EQ(x * x + z, 0);
}

}  // namespace
}  // namespace rasterproof::exact
