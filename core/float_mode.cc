#include "core/float_mode.h"

#include <algorithm>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace rasterproof {
namespace {

// The bits for subnormal numbers, which <cfenv> does not name: of MXCSR, and of FPCR.
#if defined(__x86_64__)
constexpr std::uint64_t kFlushBit = 0x8000;
constexpr std::uint64_t kDenormalsBit = 0x0040;
std::uint64_t Bits() { return _mm_getcsr() & (kFlushBit | kDenormalsBit); }
void AddBits(std::uint64_t bits) { _mm_setcsr(_mm_getcsr() | static_cast<unsigned>(bits)); }
#elif defined(__aarch64__)
constexpr std::uint64_t kFlushBit = 1U << 24;
constexpr std::uint64_t kDenormalsBit = 0;
std::uint64_t Control() {
  std::uint64_t bits = 0;
  asm volatile("mrs %0, fpcr" : "=r"(bits));
  return bits;
}
std::uint64_t Bits() { return Control() & kFlushBit; }
void AddBits(std::uint64_t bits) {
  asm volatile("msr fpcr, %0" : : "r"(Control() | bits) : "memory");
}
#else
constexpr std::uint64_t kFlushBit = 0;
constexpr std::uint64_t kDenormalsBit = 0;
std::uint64_t Bits() { return 0; }
void AddBits(std::uint64_t /*bits*/) {}
#endif

constexpr int kTrapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

std::uint64_t SubnormalBitsOf(FloatMode mode) {
  if (mode == FloatMode::kFlushToZero) return kFlushBit;
  return mode == FloatMode::kDenormalsAreZero ? kDenormalsBit : 0;
}

int RoundingOf(FloatMode mode) {
  switch (mode) {
    case FloatMode::kUpward:
      return FE_UPWARD;
    case FloatMode::kDownward:
      return FE_DOWNWARD;
    case FloatMode::kTowardZero:
      return FE_TOWARDZERO;
    case FloatMode::kUsual:
    case FloatMode::kFlushToZero:
    case FloatMode::kDenormalsAreZero:
    case FloatMode::kTrapping:
      return FE_TONEAREST;
  }
  return FE_TONEAREST;
}

std::string RaisedText(int raised) {
  if ((raised & FE_INVALID) != 0) return "an invalid operation";
  return (raised & FE_DIVBYZERO) != 0 ? "a division by zero" : "an overflow";
}

}  // namespace

std::optional<FloatMode> FindFloatMode(std::string_view name) {
  const auto* const found = std::ranges::find(kFloatModeNames, name);
  if (found == kFloatModeNames.end()) return std::nullopt;
  return static_cast<FloatMode>(found - kFloatModeNames.begin());
}

bool HasFloatMode(FloatMode mode) {
  if (mode == FloatMode::kFlushToZero) return kFlushBit != 0;
  return mode != FloatMode::kDenormalsAreZero || kDenormalsBit != 0;
}

WithinFloatMode::WithinFloatMode(FloatMode mode) : mode_(mode) {
  if (mode_ == FloatMode::kUsual) return;
  std::fegetenv(&before_);
  std::fesetround(RoundingOf(mode_));
  AddBits(SubnormalBitsOf(mode_));
  std::feclearexcept(FE_ALL_EXCEPT);
}

WithinFloatMode::~WithinFloatMode() {
  if (mode_ != FloatMode::kUsual) std::fesetenv(&before_);
}

std::string WithinFloatMode::Complaint() const {
  if (mode_ == FloatMode::kUsual) return {};
  if (std::fegetround() != RoundingOf(mode_) || Bits() != SubnormalBitsOf(mode_)) {
    return "it changed the caller's floating-point mode, which was '" +
           std::string(FloatModeName(mode_)) + "', and did not restore it";
  }
  const int raised = std::fetestexcept(kTrapped);
  if (mode_ != FloatMode::kTrapping || raised == 0) return {};
  return "it raises " + RaisedText(raised) + ", which ends a program that traps it (SIGFPE)";
}

}  // namespace rasterproof
