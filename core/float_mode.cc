#include "core/float_mode.h"

#include <algorithm>
#include <cfenv>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

// WebAssembly rounds to nearest and has no flags: no other mode is set, and none is found.
#if defined(__wasm__)
#define FE_UPWARD FE_TONEAREST
#define FE_DOWNWARD FE_TONEAREST
#define FE_TOWARDZERO FE_TONEAREST
#define FE_DIVBYZERO 0
#define FE_INVALID 0
#define FE_OVERFLOW 0
#endif

namespace rasterproof {
namespace {

constexpr int kTrapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

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
  const auto number = std::ranges::find(kFloatModeNames, name) - kFloatModeNames.begin();
  if (number == std::ssize(kFloatModeNames)) return std::nullopt;
  return static_cast<FloatMode>(number);
}

bool HasFloatMode(FloatMode mode) {
  if (mode == FloatMode::kFlushToZero) return FloatEnvironment::kFlushToZero != 0;
  return mode != FloatMode::kDenormalsAreZero || FloatEnvironment::kDenormalsAreZero != 0;
}

FloatEnvironment::Bits ControlBits(FloatMode mode) {
  switch (mode) {
    case FloatMode::kFlushToZero:
      return FloatEnvironment::kFlushToZero;
    case FloatMode::kDenormalsAreZero:
      return FloatEnvironment::kDenormalsAreZero;
    case FloatMode::kUpward:
      return FloatEnvironment::kUpward;
    case FloatMode::kDownward:
      return FloatEnvironment::kDownward;
    case FloatMode::kTowardZero:
      return FloatEnvironment::kTowardZero;
    case FloatMode::kUsual:
    case FloatMode::kTrapping:
      return 0;
  }
  return 0;
}

WithinFloatMode::WithinFloatMode(FloatMode mode) : mode_(mode) {
  if (mode_ == FloatMode::kUsual) return;
  std::fegetenv(&before_);
  std::fesetround(RoundingOf(mode_));
  FloatEnvironment::Set((FloatEnvironment::Current() & ~FloatEnvironment::kMode) |
                        ControlBits(mode_));
  std::feclearexcept(FE_ALL_EXCEPT);
}

WithinFloatMode::~WithinFloatMode() {
  if (mode_ != FloatMode::kUsual) std::fesetenv(&before_);
}

std::string WithinFloatMode::Complaint() const {
  if (mode_ == FloatMode::kUsual) return {};
  // Both: on x86-64 fegetround reads the x87 control word, and code for MXCSR leaves that alone.
  if (std::fegetround() != RoundingOf(mode_) ||
      (FloatEnvironment::Current() & FloatEnvironment::kMode) != ControlBits(mode_)) {
    return "it changed the caller's floating-point mode, which was '" +
           std::string(FloatModeName(mode_)) + "', and did not restore it";
  }
  const int raised = std::fetestexcept(kTrapped);
  if (mode_ != FloatMode::kTrapping || raised == 0) return {};
  return "it raises " + RaisedText(raised) + ", which ends a program that traps it (SIGFPE)";
}

}  // namespace rasterproof
