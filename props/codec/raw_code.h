// The raw part of the fuzz code: a whole case, with the bits of every float.
//
//   255, 0         what no domain begins with
//   flags          one byte, RawFlag
//   cull           one byte: none, front, back
//   width, height  two bytes each, less 1
//   [tile] [threads]                                     counts, where the flags say so
//   [scissor]      x0, y0, x1, y1: four bytes each
//   vertices, triangles                                  counts
//   each vertex    x, y, [z], [w]: 4 bytes each, 8 with kDouble, least byte first
//   each triangle  three counts, modulo the number of vertices
//   [name] [origin]                                      a count and as many characters, each
//
// A count is seven bits a byte, the least first, 128 added to all but the last. Missing bytes are
// zeros.
#ifndef RASTERPROOF_PROPS_CODEC_RAW_CODE_H_
#define RASTERPROOF_PROPS_CODEC_RAW_CODE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"

namespace rasterproof::props {

/// Returns whether the bytes begin as the raw code does.
bool IsRawCode(std::span<const std::uint8_t> bytes);

/// Returns the case that they encode. A precision, clip space, options or fixed-point coordinates
/// that the subject does not take are left out or rounded.
///
/// Domain:     any bytes that IsRawCode.
Case RawCase(std::span<const std::uint8_t> bytes, const SubjectInfo& info);

/// The raw code of a case. Its profile and its channels are not part of it.
///
/// Domain:     as EncodeCase.
std::vector<std::uint8_t> RawCodeOf(const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CODEC_RAW_CODE_H_
