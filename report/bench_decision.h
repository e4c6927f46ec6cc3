// Which rows of a bench count, which of them no other one beats, and which is the cheapest that
// meets a need: the page, the picture and docs/bench.md ask here, so that they can't differ.
#ifndef RASTERPROOF_REPORT_BENCH_DECISION_H_
#define RASTERPROOF_REPORT_BENCH_DECISION_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

/// The sink that all methods have: counts by facing.
inline constexpr std::string_view kCommonSink = "facing";

/// What is shown of an error: that it is 0 by proof, that none was seen, or how large it is.
enum class ErrorLane : std::uint8_t {
  kProved,  ///< 0, by proof, inside the method's limit
  kNone,    ///< 0 of N
  kRate,    ///< some
  kLost,    ///< whole triangles were not drawn: no distance says how wrong that is
  kNotJudged
};

/// The errors that a reader may ask for.
enum class ErrorKind : std::uint8_t {
  kReal,          ///< share of the pairs at most a pixel from an edge, against real geometry
  kOwn,           ///< the same against the method's own model
  kDisplacement,  ///< largest distance of a wrong sample from its triangle's boundary, pixels
  kLeaks,         ///< gaps and overlaps of the pairs beside a shared edge, by the own model
  kEdge           ///< largest |error of E| over the edge's length, pixels
};
inline constexpr std::array kErrorKinds{ErrorKind::kReal, ErrorKind::kOwn, ErrorKind::kDisplacement,
                                        ErrorKind::kLeaks, ErrorKind::kEdge};

/// "share wrong, by real geometry"
std::string_view ErrorName(ErrorKind kind);
/// Whether an error is a distance in pixels; else it is a share.
bool IsInPixels(ErrorKind kind);

/// An error of a row; smaller lanes are better, and of one lane smaller values.
struct RowError {
  ErrorLane lane = ErrorLane::kNotJudged;
  double value = 0;
};
RowError ErrorOf(const BenchResult& result, const BenchRow& row, ErrorKind kind);

/// How many of the row's pairs beside edges are wrong; 1 where all wrong ones lie farther off: what
/// is wrong anywhere is never shown as 0.
std::uint64_t WrongBesideEdges(const BenchRow& row, const BenchErrors& errors);

/// Whether the row is the baseline measured a second time: the floor of the noise, and no method.
bool IsBaselineAgain(const BenchResult& result, const BenchRow& row);

/// Returns whether the row was drawn in six rounds or more: of fewer no interval holds the median
/// with 95 %.
inline bool HasInterval(const BenchRow& row) { return row.seconds.size() >= 6; }

/// Returns "1.23 [1.1, 1.4]", its ratio with the interval, or "1.23 (3 rounds)" where it has none.
std::string RatioText(const BenchRow& row, int digits);

/// Whether the row counts: judged, inside its method's coordinate limit, under 1 % wrong, and no
/// baseline that was measured again. A wrong answer is often fast.
bool IsRival(const BenchResult& result, const BenchRow& row);

/// The rivals of a family and sink that no other one beats: none is cheaper by more than both
/// intervals and no more wrong, none is tied in time and less wrong. Cheapest first.
///
/// Properties: of rows whose intervals overlap none beats the other by its time: they are tied.
std::vector<const BenchRow*> Frontier(const BenchResult& result, std::uint32_t family,
                                      std::string_view sink, ErrorKind kind);

/// What a reader may need, strictest first.
enum class Need : std::uint8_t {
  kProvedZero,  ///< 0 wrong against real geometry, by proof
  kZeroOfN,     ///< 0 wrong were seen
  kNoLeaks,     ///< no gap and no overlap was seen along shared edges, by the own model
  kMilliPixel,  ///< no triangle lost, no wrong sample 1/1000 pixel from its triangle's boundary
  kAnything
};
inline constexpr std::array kNeeds{Need::kProvedZero, Need::kZeroOfN, Need::kNoLeaks,
                                   Need::kMilliPixel, Need::kAnything};
std::string_view NeedName(Need need);
bool Meets(const BenchResult& result, const BenchRow& row, Need need);

/// The cheapest method into counts by facing that meets a need.
struct Decision {
  /// Of those tied with the cheapest by median the one with the least error.
  const BenchRow* row = nullptr;
  std::vector<const BenchRow*> tied;  ///< others whose ratio's interval overlaps the cheapest's
  double ratio = 1;                   ///< of its ratio's median to that of the family's fastest
  bool is_tied_with_fastest = false;  ///< their intervals overlap
};
/// Nothing if no rival meets it.
std::optional<Decision> Decide(const BenchResult& result, std::uint32_t family, Need need);

/// Nanoseconds of a row's median for a triangle of its family.
double NanosecondsATriangle(const BenchResult& result, const BenchRow& row);

/// Milliseconds of a frame each of whose pixels is covered once by triangles of the row's family.
double MillisecondsAFrame(const BenchResult& result, const BenchRow& row, std::uint64_t pixels);

/// "kernel-exact avx512"; where it is the compiler's choice, the instruction set is not named.
std::string FullName(const BenchMethod& method);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_DECISION_H_
