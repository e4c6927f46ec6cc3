// Snapping: the grid point of any coordinate is the one that the rule's definition in rationals
// names.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/profile_keys.h"
#include "core/snap.h"
#include "exact/rational.h"
#include "fuzz/fuzz_target.h"
#include "model/snap.h"
#include "props/domains/bit_source.h"
#include "props/judging/witness.h"

namespace {

using rasterproof::Snap;
using rasterproof::SnapForm;
using rasterproof::SnapRule;
using rasterproof::exact::Rational;

constexpr int kCoordinates = 64;
// Differences are stated below this.
constexpr double kExactBelow = 0x1p34;

bool IsEven(double whole) { return std::fmod(whole, 2) == 0; }

// From here on every double is a whole number, and so a place of every grid.
constexpr double kAllWhole = 0x1p53;

// Whether `units` is what the rule makes of `exact`, both in units of the grid.
bool Follows(SnapRule rule, double units, const Rational& exact) {
  const Rational off = Rational(units) - exact;
  const Rational half(0.5);
  switch (rule) {
    case SnapRule::kFloor:
      return off.Sign() <= 0 && off > Rational(-1.0);
    case SnapRule::kTruncate:
      return off.Abs() < Rational(1.0) && (off.Sign() == 0 || off.Sign() == -exact.Sign());
    case SnapRule::kHalfUp:
      return off <= half && off > -half;
    case SnapRule::kNearestAway:
      return off.Abs() < half || (off.Abs() == half && off.Sign() == exact.Sign());
    case SnapRule::kNearestEven:
      return off.Abs() < half || (off.Abs() == half && IsEven(units));
  }
  return false;
}

void LookAt(double x, const Snap& snap) {
  if (!std::isfinite(x)) return;
  if (snap.form != SnapForm::kCoordinate && std::fabs(x) >= kExactBelow) return;
  const double snapped = rasterproof::SnapCoordinate(x, snap);
  if (std::fabs(x) >= kAllWhole) {
    if (snapped == x) return;
    rasterproof::fuzz::Fail(rasterproof::props::HexText(x) + " is on every grid, and was moved");
  }
  Rational given = x;
  if (snap.form != SnapForm::kCoordinate) given -= snap.origin;
  if (snap.form == SnapForm::kFloat32Difference) given = Rational(double{given.ToFloat()});
  const double origin = snap.form == SnapForm::kCoordinate ? 0 : snap.origin;
  const Rational scale = std::ldexp(1.0, snap.bits);
  // Exact: the grid has few bits below one, and what is on it has no more than 53.
  const Rational units = (Rational(snapped) - Rational(origin)) * scale;
  const double whole = units.ToDouble();
  if (Rational(whole) == units && whole == std::trunc(whole) &&
      Follows(snap.rule, whole, given * scale) && !(snapped == 0 && std::signbit(snapped))) {
    return;
  }
  rasterproof::fuzz::Fail(
      rasterproof::props::HexText(x) + " snaps to " + rasterproof::props::HexText(snapped) +
      " with " + std::to_string(snap.bits) + " bits, " + std::string(SnapRuleName(snap.rule)) +
      ", " + std::string(SnapFormName(snap.form)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::props::ByteSource bits(std::span(data, size));
  Snap snap;
  snap.bits = static_cast<int>(bits.Bits(8) % (rasterproof::kMaxSubpixelBits + 1));
  snap.rule = static_cast<SnapRule>(bits.Bits(8) % 5);
  snap.form = static_cast<SnapForm>(bits.Bits(8) % 3);
  if (snap.form != SnapForm::kCoordinate) {
    snap.origin = std::ldexp(static_cast<double>(bits.Bits(8)), -8);
  }
  for (std::size_t k = 4; k < size && k < std::size_t{8} * kCoordinates; k += 8) {
    const std::uint64_t raw = bits.Bits(64);
    LookAt(std::bit_cast<double>(raw), snap);
    // Half the bits as a place near the target: whole steps and ties of every grid.
    LookAt(std::ldexp(static_cast<double>(static_cast<std::int32_t>(raw)), -20), snap);
  }
  return rasterproof::fuzz::kLookedAt;
}
