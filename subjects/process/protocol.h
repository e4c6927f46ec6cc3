// What goes over the pipe to a program that draws, and what comes back. Text: any language can read
// and write it.
//
// A request is a line, then a line for each vertex and each triangle:
//     draw ID WIDTH HEIGHT SAMPLES window|clip VERTICES TRIANGLES [cull=front|back]
//          [scissor=X0,Y0,X1,Y1] [tile=N] [threads=N]
//     X Y Z W
//     I J K
// Coordinates are decimal numbers that a reader of doubles reads back exactly (floats too, then
// narrowed), or inf, -inf, nan. The answer is
//     counts ID
// and HEIGHT lines of WIDTH * SAMPLES integers, top row first; as many lines again with the counts
// of the back faces if the program tells facings apart. Or one line: `refused ID REASON`, or
// `fault ID REASON` for what it found out about itself.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_
#define RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"

namespace rasterproof::subjects {

struct DrawRequest {
  std::uint64_t id = 0;
  Scene scene;
  int samples = 1;
  DrawOptions options;
};

std::string RequestText(const DrawRequest& request);
/// Reads the next request; nothing at the end of the stream.
///
/// Error:      InputError with the number of the request and what was expected in it.
std::optional<DrawRequest> ReadRequest(std::istream& in);

/// The answer to a request, in the counts' own shape; the back faces only if `facings`.
std::string CountsText(std::uint64_t id, const CoverageCounts& counts, bool facings);

enum class AnswerKind : std::uint8_t { kCounts, kRefused, kFault };

struct AnswerHead {
  AnswerKind kind = AnswerKind::kCounts;
  std::string reason;  ///< of a refusal or a fault
};

/// Parses an answer's first line.
///
/// Error:      SubjectFault if it is no answer to request `id`.
AnswerHead ParseAnswerHead(std::string_view line, std::uint64_t id);
/// Parses one row of counts into `row`.
///
/// Error:      SubjectFault if there are not `n` integers of [0, 2^32) and nothing else.
void ParseCountsRow(std::string_view line, std::size_t n, std::uint32_t* row);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_
