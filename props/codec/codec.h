// Decodes fuzz bytes and encodes cases. Any bytes are a case, and a small change of the bytes is a
// small change of the case.
#ifndef RASTERPROOF_PROPS_CODEC_CODEC_H_
#define RASTERPROOF_PROPS_CODEC_CODEC_H_

#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"

namespace rasterproof::props {

/// Returns the case that the bytes encode. Every byte string is valid; missing bytes are zeros.
///
/// First byte: below 192 the triangles are spelled out, two bytes per coordinate (a place on half
/// pixels, a subpixel, a step of the lattice: hard places are one byte away from each other), or a
/// far magnitude. From 192 on the second byte is the number of a domain, whose recipe the other
/// bytes feed; if no domain has that number, or the subject does not take it, the bytes after it
/// spell the triangles out. So adding or removing a domain changes only its own bytes. 255 and then
/// 0, which is no domain's number: the raw code, the bits of every float (raw_code.h).
/// Properties: the scene is one that Takes(info, scene) accepts.
Case DecodeCase(std::span<const std::uint8_t> bytes, const SubjectInfo& info);

/// The spelled-out part of the code, from any source of bits.
Case LatticeCase(BitSource& bits, const SubjectInfo& info);

/// Returns bytes that encode the case: spelled out if that can express it and the case has neither
/// name nor origin, else the raw code.
///
/// Domain:     a case whose scene the subject takes, with options that it takes, judged by
///             info.profile; no more than 2^18 triangles and as many vertices; without channels,
///             which no byte encodes: those of another case are left out.
/// Properties: DecodeCase(EncodeCase(c, info), info) is c, bit by bit.
std::vector<std::uint8_t> EncodeCase(const Case& c, const SubjectInfo& info);

/// Returns whether two cases are equal; of numbers, whether their bits are: a NaN equals itself,
/// and -0 is not +0.
bool SameCase(const Case& a, const Case& b);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CODEC_CODEC_H_
