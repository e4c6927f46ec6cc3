// The spelled-out part of the fuzz code: decoding and encoding.
#ifndef RASTERPROOF_PROPS_CODEC_SPELLED_H_
#define RASTERPROOF_PROPS_CODEC_SPELLED_H_

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::props {

inline constexpr int kMostSpelledSide = 32;
inline constexpr int kMostSpelledTriangles = 8;
inline constexpr int kMostSpelledVertices = 16;

// The first byte of a coordinate is its anchor. From kFirstFarAnchor on it stands for magnitudes
// 2^7, 2^8, ... of either sign; the others count half pixels from kFirstPixel on and start again
// past the largest target.
inline constexpr std::uint64_t kFirstFarAnchor = 240;
inline constexpr std::uint64_t kHalfPixels = 80;
inline constexpr double kFirstPixel = -4;

// The second byte of a coordinate: below 128 the half pixel itself, so that a sixteenth of all
// edges join two of them; then a few steps of the lattice next to it; then a subpixel.
inline constexpr std::uint64_t kFirstStep = 128;
inline constexpr std::uint64_t kFirstSubpixel = 192;
inline constexpr std::array<int, 8> kSpelledSteps{1, -1, 2, -2, 3, -3, 16, -16};

/// The coordinate that two bytes stand for.
double SpelledCoordinate(std::uint64_t anchor, std::uint64_t fine, const InputLattice& lattice);

/// Returns bytes that LatticeCase decodes to the case, after a first byte of 0; nothing if they
/// can't express a part of it. Parts that no byte encodes may still differ: the caller compares.
std::optional<std::vector<std::uint8_t>> SpellCase(const Case& c, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CODEC_SPELLED_H_
