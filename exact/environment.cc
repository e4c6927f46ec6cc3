#include "exact/environment.h"

#include <cfenv>
#include <fstream>
#include <string>

namespace rasterproof::exact {
namespace {

// Read through volatile so that the processor computes, in the mode it is in, and not the compiler.
double Opaque(double x) {
  volatile double v = x;
  return v;
}

bool RoundsToNearest() {
  // 1 + 2^-54 and -1 - 2^-54 stay put only under rounding to nearest: up and towards zero move one
  // of them or fegetround tells.
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

// valgrind maps its own tool into the process. Its emulation ignores the rounding modes that
// interval arithmetic needs.
bool RunsUnderValgrind() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find("vgpreload") != std::string::npos ||
        line.find("/valgrind/") != std::string::npos) {
      return true;
    }
  }
  return false;
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
  add(under_valgrind, "valgrind does not honour rounding modes (run outside valgrind)");
  return complaint;
}

}  // namespace rasterproof::exact
