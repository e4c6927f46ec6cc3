// What a benchmark found, times and errors of the same inputs in one run: measured by bench,
// rendered by report.
#ifndef RASTERPROOF_CORE_BENCH_RESULT_H_
#define RASTERPROOF_CORE_BENCH_RESULT_H_

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"
#include "core/value_result.h"
#include "core/vertex.h"

namespace rasterproof {

/// A median with its interval.
struct Interval {
  double low = 0;
  double median = 0;
  double high = 0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Returns the median with the interval that holds the true median with at least 95 %, from a sign
/// test: two order statistics.
///
/// Domain:     at least one value. Below six values no two of them hold it with 95 %: the interval
///             is all of them.
/// Properties: presupposes independent values, and nothing of how they are distributed.
/// Source:     Conover, Practical Nonparametric Statistics, section 3.2.
Interval MedianInterval(std::vector<double> values);

/// Returns whether two intervals have no number in common.
inline bool AreApart(const Interval& a, const Interval& b) {
  return a.high < b.low || b.high < a.low;
}

/// How a method's time is taken.
enum class BenchClock : std::uint8_t {
  kThread,   ///< processor time of this process: one thread draws
  kProgram,  ///< processor time of a program, by the slope over repeats of the scene in one request
  kWall      ///< elapsed time alone: what draws runs elsewhere
};

/// One way to draw, timed and tested.
struct BenchMethod {
  std::string name;     ///< "f32-direct", "kernel-exact", "mine.so"
  std::string summary;  ///< one line
  std::string kind;     ///< "float32", "float64", "fixed point", "exact", "yours"
  std::string target;   ///< instruction set: "compiler" (the compiler's options), "avx2", ...
  std::string sink;     ///< "facing", "count8", "mask", "id", "depth"
  /// How samples are visited: "box loop", "rows", "tiles", "spans", "known spans"; "its own".
  std::string traversal;
  /// In what, and in which form, they are decided: "f64-affine", "exact"; "none" of known spans.
  std::string arithmetic;
  std::string space;  ///< of the vertices that it reads: "window", "clip"
  /// -march of a plugin's compiler, if the file tells.
  std::string march;
  std::string model;  ///< name of the profile that it is held to; "real" for real geometry
  BenchClock clock = BenchClock::kThread;
  /// 0 wrong samples are proved of it: against its own model, inside its limit.
  bool is_proved = false;
  bool is_users = false;           ///< the user's own, not the project's
  double coordinate_limit = 0;     ///< beyond it nothing is stated; pixels
  std::uint64_t vertex_bytes = 0;  ///< that one vertex takes in the format that it reads
  std::uint64_t pixel_bits = 0;    ///< that one pixel takes in its sink
  /// A program that takes no repeats: its time is that of a request, reading the scene and writing
  /// the answer included; the conversion is that of a request for a scene without triangles.
  bool times_requests = false;

  friend bool operator==(const BenchMethod&, const BenchMethod&) = default;
};

/// Distances of samples from the nearest edge of their triangle, all pairs within a pixel: on it,
/// then up to 2^-16, 2^-8, 2^-4, 1 pixel.
struct EdgeDistances {
  static constexpr std::array<double, 5> kUpTo{0, 0x1p-16, 0x1p-8, 0x1p-4, 1};
  std::array<std::uint64_t, 5> pairs{};
};

/// A family of triangles, and what it is made of.
struct BenchFamily {
  std::string name;
  std::string summary;  ///< a sentence
  int width = 0;
  int height = 0;
  bool is_clip_space = false;
  /// Vertices were placed to be hard: shares are "k of N constructed", never a rate.
  bool is_constructed = false;
  /// Its triangles are independent draws of one distribution: 0 of N bounds the rate by 3/N.
  bool is_random = false;
  double largest_coordinate = 0;  ///< magnitude, pixels; of clip space before the division
  std::uint64_t triangles = 0;
  std::uint64_t covered = 0;  ///< pairs (triangle, sample) that exact geometry covers
  /// Of the triangles whose errors were counted (all, or every n-th block of 64):
  std::uint64_t judged_triangles = 0;
  std::uint64_t judged_covered = 0;
  std::uint64_t boundary_pairs = 0;  ///< (triangle, sample) at most a pixel from an edge
  std::uint64_t shared_pairs = 0;    ///< (edge of two triangles, sample) at most a pixel from it
  EdgeDistances distances;
  std::uint32_t baseline = 0;  ///< the method whose ratio is 1
  /// The baseline measured a second time under another name: its ratio is the noise's floor.
  std::uint32_t twin = 0;
  std::uint64_t rounds = 0;
};

/// A wrong decision, to be seen again: the family's triangle alone on the family's target.
struct BenchWitness {
  std::uint64_t triangle = 0;
  std::array<Vertex, 3> corners{};
  int x = 0;
  int y = 0;
  double distance = 0;  ///< of the sample from the triangle's boundary, pixels

  friend bool operator==(const BenchWitness&, const BenchWitness&) = default;
};

/// Decisions of a method on a family's judged triangles against one geometry.
struct BenchErrors {
  std::uint64_t missing = 0;     ///< pairs that it should cover
  std::uint64_t unexpected = 0;  ///< pairs that it should not
  /// Wrong pairs at most a pixel from an edge. The error rate counts only these.
  std::uint64_t beside_edges = 0;
  /// Missing pairs of triangles with 16 pairs or more of which nothing was drawn.
  std::uint64_t lost = 0;
  /// Largest distance of a wrong sample, not lost, from the triangle's boundary: how far an edge
  /// has to move to make the decision right. Pixels.
  double displacement = 0;
  /// 99.9 % of them are at most as far; NaN below 10,000 wrong pairs.
  double displacement_999 = std::numeric_limits<double>::quiet_NaN();
  std::optional<BenchWitness> worst;

  std::uint64_t Wrong() const { return missing + unexpected; }
};

/// What a method leaks along shared edges, held to its own model.
struct BenchLeaks {
  std::uint64_t gaps = 0;
  std::uint64_t overlaps = 0;

  std::uint64_t Sum() const { return gaps + overlaps; }
};

/// Values that a method computes besides coverage. NaN: it shows none.
struct BenchValues {
  double edge = std::numeric_limits<double>::quiet_NaN();  ///< largest |error of E| / length, px
  /// Largest |error of E| over its proven bound.
  double edge_share_of_bound = std::numeric_limits<double>::quiet_NaN();
  double barycentric = std::numeric_limits<double>::quiet_NaN();
  double depth = std::numeric_limits<double>::quiet_NaN();
};

/// One method on one family.
struct BenchRow {
  std::uint32_t family = 0;  ///< index in BenchResult::families
  std::uint32_t method = 0;  ///< index in BenchResult::methods
  /// Seconds of one draw of the family, a number for each round, in the order of the rounds.
  std::vector<double> seconds;
  Interval time;           ///< of the seconds
  double wall_median = 0;  ///< elapsed
  Interval ratio;          ///< to the baseline's of the same round
  /// What it costs to turn the family's vertices into its own and its answer into counts, seconds
  /// a triangle; not part of the time. NaN: nothing is converted.
  double conversion_seconds = std::numeric_limits<double>::quiet_NaN();
  /// Storing the covered samples takes more than half of the time.
  bool binds_at_store = false;
  /// Whether its decisions were judged; else the errors say nothing.
  bool is_judged = false;
  /// What was judged of it: all that the family says, or a part if its draws take long.
  std::uint64_t judged_triangles = 0;
  std::uint64_t boundary_pairs = 0;  ///< (triangle, sample) at most a pixel from an edge
  BenchErrors real;                  ///< against real geometry
  BenchErrors own;                   ///< against the method's own model
  BenchLeaks leaks;
  BenchValues values;
  /// Samples of the whole drawing that was timed whose counts are not the own model's; nothing of
  /// sinks that keep no counts by facing.
  std::optional<std::uint64_t> drawing_wrong;
};

/// What was not timed, and why.
struct BenchLeftOut {
  std::uint32_t family = 0;
  std::uint32_t method = 0;
  std::string why;
};

/// A number that makes triangles harder, or more costly, as it grows.
struct BenchParameter {
  std::string name;     ///< "aspect", "distance", "steps", "pixels", ...
  std::string summary;  ///< a sentence: what is varied and what is kept
  std::string unit;     ///< "pixels", "1"
  /// Its points have times; else errors.
  bool is_cost = false;
};

/// What a method does at one value of a parameter.
struct BenchPoint {
  double value = 0;
  std::uint64_t asked = 0;  ///< decisions
  std::uint64_t wrong = 0;  ///< of them, by the method's own model
  double displacement = 0;  ///< largest of a wrong one, pixels
  /// Largest |error of E| over its proven bound; NaN: it shows no E.
  double share_of_bound = std::numeric_limits<double>::quiet_NaN();
  Interval time;  ///< seconds a triangle; of costs alone
};

/// One method over one parameter.
struct BenchCurve {
  std::uint32_t method = 0;     ///< index in BenchResult::methods
  std::uint32_t parameter = 0;  ///< index in BenchResult::parameters
  std::vector<BenchPoint> points;
};

/// Up to which value of a parameter a method is right. Failing is not monotone: between what is
/// proved and first seen failing nothing is stated.
struct BenchCliff {
  std::uint32_t method = 0;
  std::uint32_t parameter = 0;
  /// 0 wrong is proved up to here; NaN: nothing is.
  double proved_to = std::numeric_limits<double>::quiet_NaN();
  /// The largest value below the first failing one that was tried and held; NaN: none held.
  double held_to = std::numeric_limits<double>::quiet_NaN();
  /// The least value that was seen failing; NaN: none was.
  double first_failing = std::numeric_limits<double>::quiet_NaN();
  /// The failing case: a scene, and the sample that is wrong in it.
  std::optional<Scene> scene;
  int x = 0;
  int y = 0;
};

/// What one stage of the pipeline moves when it alone is inexact.
struct BenchStage {
  std::string name;         ///< "transform", "clip", "divide", "snap", "coverage"
  std::string summary;      ///< a sentence: in which arithmetic it is done
  std::uint64_t wrong = 0;  ///< pairs that differ from those of the exact pipeline
  std::uint64_t asked = 0;  ///< pairs at most a pixel from an edge
  double displacement = 0;  ///< largest, pixels
};

/// What a method says of one sample with one vertex in many places, and what its own model says.
struct BenchFingerprint {
  std::uint32_t method = 0;
  std::string step;         ///< between neighbouring places: "1 ulp", "2^-12", "1/256", "1/16"
  std::uint64_t wrong = 0;  ///< places in which it is not as its own model
  std::string png;          ///< base64: 512 x 256 pixels, the method left, exact beside it
  /// 256 x 256; of a plugin or program 64 x 64 down to 8 x 8, by what drawing takes.
  std::uint64_t places = 65'536;
};

/// Where and how it was measured.
struct BenchSetting {
  std::string processor;
  std::string compiler;
  std::string flags;
  std::string commit;
  std::string command;
  std::string date;
  std::uint64_t seed = 0;
  bool is_quick = false;  ///< families of an eighth of their size, otherwise half
  /// How many processes wanted a processor, a mean over a minute, as the run began and ended. NaN:
  /// not said.
  double load_before = std::numeric_limits<double>::quiet_NaN();
  double load_after = std::numeric_limits<double>::quiet_NaN();
};

/// A whole run. Times mean something only beside others of the same run.
struct BenchResult {
  BenchSetting setting;
  std::vector<BenchMethod> methods;
  std::vector<BenchFamily> families;
  std::vector<BenchRow> rows;
  std::vector<BenchLeftOut> left_out;
  /// What the budget left no time for: "families: map", "limits: mine.so".
  std::vector<std::string> not_measured;
  std::vector<BenchParameter> parameters;
  std::vector<BenchCurve> curves;
  std::vector<BenchCliff> cliffs;
  std::vector<BenchStage> stages;
  std::vector<BenchFingerprint> fingerprints;
  std::vector<ValueBenchFamily> value_families;
  std::vector<ValueBenchRow> value_rows;
  std::vector<ValueBenchLimit> value_limits;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_BENCH_RESULT_H_
