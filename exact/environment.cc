#include "exact/environment.h"

#include <array>
#include <cfenv>
#include <string>
#if !defined(__wasm__)
#include <fstream>
#endif

#include "core/own_precision.h"

namespace rasterproof::exact {
namespace {

// Read through volatile so that the processor computes, in the mode it is in, and not the compiler.
double Opaque(double x) {
  volatile double v = x;
  return v;
}

bool RoundsToNearest() {
  // 1 + 2^-54 and -1 - 2^-54 round to 1 and -1 under rounding to nearest. Other modes change one of
  // them, or fegetround reports the mode.
  return std::fegetround() == FE_TONEAREST && Opaque(1) + Opaque(0x1p-54) == Opaque(1) &&
         Opaque(-1) - Opaque(0x1p-54) == Opaque(-1) && Opaque(1) - Opaque(0x1p-55) == Opaque(1);
}

bool KeepsSubnormals() {
  // Flush to zero loses a subnormal result, denormals are zero a subnormal operand.
  return Opaque(0x1p-1022) * Opaque(0.5) != 0 && Opaque(0x1p-1074) * Opaque(0x1p60) != 0;
}

// (1 + 2^-27)^2 = 1 + 2^-26 + 2^-54: the product rounds the last term away, a fused one keeps it.
bool ContractionIsOff() {
  const double a = Opaque(1 + 0x1p-27);
  const double c = Opaque(-(1 + 0x1p-26));
  return a * a + c == 0;
}

// Two neighbouring values at once, as g++ 12's vectoriser takes them: at -O2 it drops the rounding
// of double -> float -> double from such a pair. Not inlined: known values would be folded.
[[gnu::noinline]] void RoundPairToFloat(const double* values, double* rounded) {
  const auto first = static_cast<float>(values[0] * values[2]);
  const auto second = static_cast<float>(values[1] * values[2]);
  rounded[0] = first;
  rounded[1] = second;
}

bool KeepsFloatRounding() {
  const std::array<double, 3> values{Opaque(1), Opaque(2), Opaque(1.0 / 3)};
  std::array<double, 2> rounded{};
  RoundPairToFloat(values.data(), rounded.data());
  return rounded[0] == 0x1.555556p-2 && rounded[1] == 0x1.555556p-1;
}

// valgrind maps its own tool into the process. Its emulation ignores the rounding modes that
// interval arithmetic needs.
bool RunsUnderValgrind() {
#if defined(__wasm__)
  return false;
#else
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find("vgpreload") != std::string::npos ||
        line.find("/valgrind/") != std::string::npos) {
      return true;
    }
  }
  return false;
#endif
}

std::string CompilerName() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

}  // namespace

Environment InspectEnvironment() {
  static const bool under_valgrind = RunsUnderValgrind();
  Environment environment;
  environment.round_to_nearest = RoundsToNearest();
  environment.subnormals_kept = KeepsSubnormals();
  environment.contraction_off = ContractionIsOff();
  environment.float_rounding_kept = KeepsFloatRounding();
  environment.under_valgrind = under_valgrind;
  environment.compiler = CompilerName();
  environment.flags = std::string(RASTERPROOF_BUILD_FLAGS);
  return environment;
}

std::string Environment::Complaint() const {
  std::string complaint;
  const auto add = [&](bool wrong, const char* text) {
    if (!wrong) return;
    complaint += complaint.empty() ? "the oracle cannot be trusted here: " : "; ";
    complaint += text;
  };
  add(!round_to_nearest, "the rounding mode is not to nearest (call fesetround(FE_TONEAREST))");
  add(!subnormals_kept,
      "subnormals are flushed to zero (do not link with -ffast-math; clear FTZ and DAZ in MXCSR)");
  add(!contraction_off,
      "the compiler fuses a * b + c (build with -ffp-contract=off and without -ffast-math)");
  add(!float_rounding_kept,
      "the compiler drops the rounding of a double to float32 (build with "
      "-fno-tree-slp-vectorize)");
  add(under_valgrind, "valgrind does not honour rounding modes (run outside valgrind)");
  return complaint;
}

}  // namespace rasterproof::exact
