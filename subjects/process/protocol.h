// What goes over the pipe to a program that draws, and what comes back. Text: any language can read
// and write it.
//
// A request is a line, then a line for each vertex and each triangle:
//     draw ID WIDTH HEIGHT SAMPLES window|clip VERTICES TRIANGLES [cull=front|back]
//          [scissor=X0,Y0,X1,Y1] [tile=N] [threads=N]
//     X Y Z W
//     I J K
// Coordinates are decimal numbers that a reader of doubles reads back exactly (floats too, then
// narrowed), or inf, -inf, nan. The answer to a request depends on what the program shows:
//     counts ID      HEIGHT lines of WIDTH * SAMPLES integers, top row first; as many lines again
//                    with the counts of the back faces if the program tells facings apart
//     ids ID         HEIGHT lines of as many indices of triangles; -1 where none won the sample
//     fragments ID   the same, but each index (not -1) is followed by W0 W1 W2 DEPTH
// Or one line: `refused ID REASON`, or `fault ID REASON` for what it found out about itself.
//
// A program that shows edge values is asked for them in one line:
//     edge ID AX AY BX BY PX PY                             E(a, b; p), evaluated afresh
//     walk ID AX AY BX BY PX PY x|y +1|-1 LENGTH STEPS      from p, STEPS steps of LENGTH pixels
// and answers `values ID V ...`: one number, or STEPS + 1, the first of them at p.
//
// A program that takes batches may be told `batch N` before N requests: it may draw them in one
// call. It answers each of them, in order. One that does not is sent requests before it has
// answered the earlier ones all the same, as many as the tool has at hand.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_
#define RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof::subjects {

struct DrawRequest {
  std::uint64_t id = 0;
  DrawJob job;
};

std::string RequestText(std::uint64_t id, const DrawJob& job);
/// The line that tells a program to take the next n requests as one call.
std::string BatchText(std::size_t n);
/// Reads the next call: a request, or as many as a batch line announces. Empty at the end of the
/// stream.
///
/// Error:      InputError with the number of the request and what was expected in it.
std::vector<DrawRequest> ReadCall(std::istream& in);

/// The answer to a request.
std::string AnswerText(std::uint64_t id, const Drawing& drawing, CoverageKind kind);

/// Gives the next line of an answer. No right answer's has more than so many bytes: who reads need
/// not wait for the end of one that has.
using NextLine = std::function<std::string(std::size_t most_bytes)>;

/// Reads the answer to a request, line by line.
///
/// Error:      SubjectFault if it is no answer to request `id` of this kind and shape, or tells of
///             a fault; InputError if it is a refusal; what next_line throws.
Drawing ReadAnswer(std::uint64_t id, const DrawJob& job, const SubjectInfo& info,
                   const NextLine& next_line);

/// Asks for edge values.
struct EdgeRequest {
  std::uint64_t id = 0;
  Point2 a;
  Point2 b;
  Point2 p;
  std::optional<Step> step;  ///< of a walk; nothing: the value at p alone
  int steps = 0;

  std::size_t Values() const { return static_cast<std::size_t>(steps) + 1; }
};

std::string RequestText(const EdgeRequest& request);
/// Reads the next request if it asks for edge values; else the stream stays where it is.
///
/// Error:      InputError as ReadCall.
std::optional<EdgeRequest> ReadEdgeRequest(std::istream& in);
std::string ValuesText(std::uint64_t id, std::span<const double> values);
/// Reads the answer to an edge request.
///
/// Error:      as ReadAnswer.
std::vector<double> ReadValues(const EdgeRequest& request, const std::string& subject,
                               const NextLine& next_line);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_
