// Numbers beside coverage that a property compared, around the place where it failed.
#ifndef RASTERPROOF_CORE_COMPARED_NUMBERS_H_
#define RASTERPROOF_CORE_COMPARED_NUMBERS_H_

#include <cstdint>
#include <string>
#include <vector>

namespace rasterproof {

/// What a compared number is, and by which rule the numbers around the failing one are compared.
enum class NumberKind : std::uint8_t {
  kValue,
  kHeldValue,    ///< a value between the least and the greatest of its vertices
  kDerivativeX,  ///< of a value
  kDerivativeY,
  kDepth,
  kScreenBarycentric,  ///< that of the witness's edge
  kBarycentric
};

/// One number of a sample.
struct ComparedNumber {
  int x = 0;  ///< pixel column
  int y = 0;  ///< pixel row from the top
  int sample = 0;
  double observed = 0;
  double expected = 0;  ///< the exact number, rounded, or the nearest that is allowed
  double allowed = 0;   ///< the most that it may be off
  /// How far it is off, of which sign: in units of `allowed`, or in ulps where nothing is allowed.
  double off = 0;
};

/// The numbers of one channel, of the triangle that the failing sample shows.
struct ComparedNumbers {
  NumberKind kind = NumberKind::kValue;
  std::string what;                  ///< "channel \"signed\", perspective"
  bool is_in_ulps = false;           ///< `off` is, as nothing is allowed
  std::vector<ComparedNumber> list;  ///< the failing one first
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_COMPARED_NUMBERS_H_
