// Requests to a program that draws and its answers, over a pipe. They are text, which any language
// can read and write.
//
// A request is a line, then a line for each vertex and each triangle:
//     draw ID WIDTH HEIGHT SAMPLES window|clip VERTICES TRIANGLES [cull=front|back]
//          [scissor=X0,Y0,X1,Y1] [tile=N] [threads=N] [float=MODE] [wants=...] [repeats=N]
//     X Y Z W
//     I J K
// Coordinates are decimal numbers that a reader of doubles reads back exactly (floats too, then
// narrowed), or inf, -inf, nan. The answer to a request depends on what the program shows:
//     counts ID      HEIGHT lines of WIDTH * SAMPLES integers, top row first; as many lines again
//                    with the counts of the back faces if the program reports facings
//     primitive-ids ID HEIGHT lines of as many indices of triangles; -1 where none won the sample
//     fragments ID   the same, but each index (not -1) is followed by W0 W1 W2 DEPTH
// Or one line: `refused ID REASON`, `fault ID REASON` for what it found out about itself, or
// `no-memory ID REASON` if its process may have no more memory, which is no finding.
//
// Three words come to programs that say that they take them (SubjectInfo), the first two no more
// often than they save something:
//     same       in place of VERTICES: those of the request before; no lines of vertices follow
//     wants=...  not all that the program shows. coverage: the answer is `counts ID`, 1 where
//                anything won the sample. primitive-ids: it is `primitive-ids ID`.
//                primitive-ids,barycentrics or primitive-ids,depths: it is `fragments ID`, and
//                after each index come W0 W1 W2 alone, or DEPTH alone. centroids among them, for a
//                program that shows them: C0 C1 C2, the barycentrics at the fragment's centroid,
//                come last. No request without that word asks for them.
//     npy        at the end of the line: the vertices, unless they are the same, and then the
//                triangles follow as arrays of NumPy's format NPY 1.0, '<f8' of VERTICES rows of
//                four and '<i4' of TRIANGLES rows of three, in place of the lines
//
// A program that shows values, which takes wants too, may be sent, with `values` or
// `values,derivatives` at the end of wants=...:
//     channels=N  after the vertices and before the triangles come N lines, one a channel:
//                     NAME flat|linear|perspective|inverse-w sample|centre|centroid V0 V1 ...
//                 one number a vertex, none with inverse-w. With npy the line ends before them, and
//                 an array '<f8' of VERTICES rows of one follows it, none with inverse-w
//     channels=same  those that were sent last; no request since then had vertices of its own
// In the answer the N values come last after each index, in the order of the channels; with
// derivatives each of them is followed by its derivatives by x and by y: V0 DX0 DY0 V1 DX1 DY1 ...
//
// An answer's line may always end with the same word: `counts ID npy` and one array of integers of
// any size follow, (HEIGHT, WIDTH * SAMPLES) or (HEIGHT, WIDTH, SAMPLES), and of a program that
// reports facings (2, HEIGHT, ...); `primitive-ids ID npy` likewise.
//
// Only a host of a library is sent float=MODE (core/float_mode.h), the mode in which it calls it.
//
// The first request of a call has its own vertices.
//
// A program that takes repeats is sent repeats=N where it is timed: it draws the scene N times,
// each onto an empty target, and answers as for once. The time of one draw is the slope of its
// processor time over N, in which starting, reading and answering cancel.
//
// A program that shows edge values is asked for them in one line:
//     edge ID AX AY BX BY PX PY                             E(a, b; p), evaluated at p
//     steps ID AX AY BX BY PX PY x|y +1|-1 LENGTH STEPS      from p, STEPS steps of LENGTH pixels
// and answers `values ID V ...`: one number, or STEPS + 1, the first of them at p.
//
// A program that takes batches may be sent `batch N` before N requests: it may draw them in one
// call. It answers each of them, in order. Any program, with batches or without, may be sent
// further requests, for edge values too, before it has answered the earlier ones.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_
#define RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/channel.h"
#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof::subjects {

class WordReader;

struct DrawRequest {
  std::uint64_t id = 0;
  DrawJob job;
};

/// A request for edge values.
struct EdgeRequest {
  std::uint64_t id = 0;
  Point2 a;
  Point2 b;
  Point2 p;
  std::optional<Step> step;  ///< of a run of steps; nothing: the value at p alone
  int steps = 0;

  std::size_t Values() const { return static_cast<std::size_t>(steps) + 1; }
};

/// The requests for the jobs of one call, numbered from `first_id` on. Options and words that the
/// subject does not take are left out.
std::string RequestsText(std::uint64_t first_id, std::span<const DrawJob> jobs,
                         const SubjectInfo& info);
/// The line that announces the next n requests as one call.
std::string BatchText(std::size_t n);
std::string RequestsText(std::span<const EdgeRequest> requests);

/// Returns the outputs that a request to the subject for this job asks for.
Outputs Requested(const DrawJob& job, const SubjectInfo& info);
/// Returns the outputs, in addition to coverage, of the answer to a job that wants these: those
/// that the subject shows. Barycentrics and depths always come with ids.
Outputs Answered(CoverageKind kind, Outputs wants);

/// Reads requests with any words, one after the other.
///
/// Domain:     a stream that outlives this.
/// Error:      every read: InputError with the number of the request and the expected text.
class RequestReader {
 public:
  explicit RequestReader(std::istream& in) : in_(in) {}

  /// The next call: a request, or as many as a batch line announces. Empty at the end of the
  /// stream. Requests for the same vertices share them.
  std::vector<DrawRequest> NextCall();
  /// Whether another request can be read without waiting.
  bool HasMore();
  /// Reads the next request if it asks for edge values; else leaves it unread.
  std::optional<EdgeRequest> NextEdgeRequest();

 private:
  bool Peek();
  bool NextLine();
  DrawRequest NextRequest();
  // The lists of a request: as lines, or as arrays; of no vertices or channels: those before.
  struct Lists {
    std::uint64_t id = 0;
    bool as_arrays = false;
    std::optional<std::size_t> vertices = {};
    std::optional<std::size_t> channels = 0;
  };
  void ReadOptions(WordReader& words, const std::string& where, DrawJob& job, Lists& lists);
  std::shared_ptr<const Scene> SceneFor(Scene target, const Lists& lists);
  std::vector<Vertex> NextVertices(std::size_t count, const Lists& lists);
  Channel NextChannel(std::size_t index, std::size_t vertices, const Lists& lists);
  std::vector<Triangle> NextTriangles(std::size_t count, const Lists& lists);
  std::string_view NextBytesOf(std::size_t count);

  std::istream& in_;
  std::string line_;
  std::string bytes_;
  bool has_line_ = false;              ///< line_ is still to be read
  std::shared_ptr<const Scene> last_;  ///< of the request before: vertices and channels
};

/// The answer to a request for a job that wants these outputs.
std::string AnswerText(std::uint64_t id, const Drawing& drawing, CoverageKind kind, Outputs wants);
std::string ValuesText(std::uint64_t id, std::span<const double> values);

/// Returns the next line of an answer, valid until the next call. The argument is the most bytes
/// that a correct answer's line has: the reader need not wait for the end of a longer one.
using NextLine = std::function<std::string_view(std::size_t most_bytes)>;

/// Returns the next bytes of a stream, exactly so many, valid until the next call.
using NextBytes = std::function<std::string_view(std::size_t count)>;

/// Reads the answer to a request, line by line. Outputs that the job does not want may be left out.
///
/// Error:      SubjectStop if it is not an answer to request `id` of this kind and shape, or
///             reports a fault or a refusal; any exception of next_line and next_bytes.
Drawing ReadAnswer(std::uint64_t id, const DrawJob& job, const SubjectInfo& info,
                   const NextLine& next_line, const NextBytes& next_bytes);
/// Reads the answer to an edge request.
///
/// Error:      as ReadAnswer.
std::vector<double> ReadValues(const EdgeRequest& request, const std::string& subject,
                               const NextLine& next_line);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROTOCOL_H_
