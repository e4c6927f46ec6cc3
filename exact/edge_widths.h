// How many bits each intermediate value of an integer edge function takes.
#ifndef RASTERPROOF_EXACT_EDGE_WIDTHS_H_
#define RASTERPROOF_EXACT_EDGE_WIDTHS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/fixed_input.h"
#include "core/sample_pattern.h"
#include "core/scene.h"

namespace rasterproof::exact {

/// Holds every value below: of coordinates below 2^48 in magnitude products are below 2^98.
__extension__ using EdgeInteger = __int128;

/// An integer rasterizer, as far as it decides how large its numbers become.
///
/// Domain:     `input` as its type says (whether it wraps plays no role);
///             1 <= width, height <= kMaxTargetSide; 1 <= tile <= kMaxTargetSide.
/// Units:      pixels.
struct EdgeUnit {
  FixedInput input;
  int width = 1;
  int height = 1;
  int tile = 8;
  SamplePattern pattern = {};

  /// Units are 2^-UnitBits() pixel, the coarsest that vertices and samples are multiples of.
  int UnitBits() const;
};

/// An edge a -> b and the point p where it is evaluated.
///
/// Units:      2^-UnitBits() pixel.
struct EdgeInput {
  std::int64_t ax = 0, ay = 0, bx = 0, by = 0, px = 0, py = 0;

  friend bool operator==(const EdgeInput&, const EdgeInput&) = default;
};

/// The range of one intermediate value over all inputs.
struct EdgeWidth {
  std::string id;     ///< "direct-e-target": form, value, place
  std::string form;   ///< "direct", "affine", "stepped", "biased" or "area"
  std::string value;  ///< as a formula: "(p.x - a.x)(b.y - a.y)"
  std::string place;  ///< where p lies, in words; empty: the value does not depend on p
  int bits = 0;       ///< the fewest in two's complement that hold `least` and `most`
  EdgeInteger least = 0;
  EdgeInteger most = 0;
  EdgeInput witness;          ///< takes the value that `bits - 1` bits do not hold
  EdgeInteger extreme = 0;    ///< that value: `least` or `most`
  bool depends_on_p = false;  ///< else the witness's p is any sample in the box
};

/// Returns why EdgeWidths can't be asked; nothing if it can: some sample lies in the range of
/// vertices.
std::optional<InputError> WhyNoEdgeWidths(const EdgeUnit& unit);

/// The widths of every value of the three forms, p at each of these places: samples in the box of a
/// triangle (in the range of vertices), samples of the target, corners of its tiles, and one pixel
/// and one tile past both ends of a row and of a column. Twice the area is E at the third vertex.
/// Of several samples a pixel p is each of them.
///
///     direct   E = (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x)
///     affine   E = A p.x + B p.y + C, A = b.y - a.y, B = a.x - b.x, C = a.y b.x - a.x b.y
///     stepped  E += A, E += B, times one pixel or one tile
///     biased   E, or E - 1 where the edge does not own the samples on it: inside is then >= 0
///
/// A p.x + B p.y also where p is a sample's offset from its pixel's upper left corner: what a
/// sample adds to E there.
///
/// Properties: exact. Each value is affine in each of the six coordinates alone, and each of these
///             has its own range: so the least and the largest lie at the 64 corners, which are
///             computed, for each sample of a pixel. Both are taken on, as the ends of the ranges
///             are inputs.
/// Error:      WhyNoEdgeWidths().
std::vector<EdgeWidth> EdgeWidths(const EdgeUnit& unit);

/// Of fewer bits no edge function is made.
inline constexpr int kFewestEdgeBits = 8;

/// For each value of EdgeWidths(unit) and every n from kFewestEdgeBits to two less than its bits an
/// input whose value takes n + 1 bits, and hardly more than n: with n bits the extreme input may
/// pass by luck (an area of 4095^2 cut to 12 bits wraps to 1), a value next beyond 2^(n-1) has the
/// wrong sign. Their ids end with "-beyond-n", `bits` is n + 1 and `extreme` the value; `least` and
/// `most` are the value's over all inputs. An n is left out where no input was found.
///
/// Error:      as EdgeWidths.
std::vector<EdgeWidth> InputsBeyondBits(const EdgeUnit& unit);

/// The fewest bits of two's complement that hold both; 1 for 0 and -1.
int SignedBits(EdgeInteger least, EdgeInteger most);

/// What a register of so many bits holds of the value, in two's complement.
EdgeInteger WrappedTo(EdgeInteger value, int bits);

/// E of the input, exactly.
EdgeInteger EdgeOf(const EdgeInput& input);

/// A triangle a, b, c with the witness's edge. Of an area c is the witness's p. Else, if one was
/// found, c is such that E(a, b; p) decides
/// whether p is covered, and one bit less holds the other two values: the wrong sign is then seen.
/// A witness in the box lies in the box of this triangle.
///
/// Returns:    the scene on the unit's target, which may have more samples than the oracle draws.
Scene WitnessScene(const EdgeUnit& unit, const EdgeWidth& width);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_EDGE_WIDTHS_H_
