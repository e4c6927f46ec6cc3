// Draws and answers as bytes that JavaScript reads and writes as typed arrays.
//
// Little-endian. Requests: their number and a zero, then of each fourteen 32-bit integers
//     width height samples clip cull scissor x0 y0 x1 y1 wants channels vertices triangles
// (clip, scissor: 0 or 1; cull: 0 none, 1 front, 2 back; wants: the sum of 1 barycentrics, 2
// depths, 4 centroids, 8 values, 16 derivatives), four doubles a vertex; of each channel two
// integers, its core/channel.h Interpolation and EvaluatedAt, and a double a vertex, none of 1/w;
// three integers a triangle, and one more zero if that makes an odd number of integers: each begins
// at a multiple of 8 bytes.
// Answers, in the same order, 32-bit integers: how the draw ended, a length, and that many of what
// follows.
//     0 answered: numbers, [height][width][sample]: counts, of facing-counts twice as many, those
//       of back faces last; a mask; or ids of triangles, -1 where there is none. Of fragments the
//       ids, and then doubles, what is wanted, in the order above: three barycentrics a sample, a
//       depth, three centroids, a value of each channel, two derivatives of each
//     1 refused, 2 broke down, 3 out of memory: bytes of the reason, zeros up to a multiple of 4
#ifndef RASTERPROOF_WEB_ENGINE_PACKED_H_
#define RASTERPROOF_WEB_ENGINE_PACKED_H_

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing.h"
#include "core/subject_info.h"

namespace rasterproof::web {

std::string PackedJobs(std::span<const DrawJob> jobs, const SubjectInfo& info);

/// Returns the outcomes of the jobs, or of the first ones.
///
/// Error:      InputError if the bytes are no answers to them.
std::vector<DrawOutcome> OutcomesFrom(std::string_view bytes, std::span<const DrawJob> jobs,
                                      const SubjectInfo& info);

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_PACKED_H_
