// Errors of coverage, pair by pair: every decision of a method about a triangle and a sample.
#ifndef RASTERPROOF_BENCH_ERRORS_H_
#define RASTERPROOF_BENCH_ERRORS_H_

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/contender.h"
#include "bench/family.h"
#include "core/bench_result.h"
#include "core/profile.h"
#include "core/scene.h"

namespace rasterproof::bench {

/// The triangles of a family that are judged, and who their neighbours among them are.
class JudgedTriangles {
 public:
  /// All triangles, or every n-th block of 64 of them, so that their areas add up to about
  /// `most_pixels`.
  JudgedTriangles(const Scene& scene, std::uint64_t most_pixels);

  const std::vector<std::size_t>& indices() const { return indices_; }
  /// The other judged triangle that has the edge from corner k to the next: of an edge that exactly
  /// two of them have. -1 otherwise.
  std::int64_t NeighbourAt(std::size_t triangle, std::size_t k) const;

 private:
  using Edge = std::pair<std::int32_t, std::int32_t>;  // smaller index first
  Edge EdgeOf(std::size_t triangle, std::size_t k) const;

  const Scene& scene_;
  std::vector<std::size_t> indices_;
  std::map<Edge, std::vector<std::size_t>> owners_;
};

/// Returns what the family is made of, its judged triangles looked at sample by sample.
BenchFamily Describe(const FamilyInput& family, const JudgedTriangles& judged);

/// What a contender gets wrong.
struct Judgement {
  BenchErrors real;
  BenchErrors own;
  BenchLeaks leaks;
  std::uint64_t judged_triangles = 0;
  std::uint64_t boundary_pairs = 0;  ///< (triangle, sample) at most a pixel from an edge
};

/// Judges contenders on one family, pair by pair. What exact geometry covers is worked out once for
/// each model.
class CoverageJudge {
 public:
  /// The family and the judged triangles outlive the judge.
  CoverageJudge(const FamilyInput& family, const JudgedTriangles& judged);
  ~CoverageJudge();

  /// Draws every judged triangle alone and compares it with real geometry, and with the contender's
  /// own model. Errors of a name are found once, whatever its instruction set and sink. Of one that
  /// is slow alone as many blocks of 64 triangles are judged as it draws in some seconds.
  ///
  /// Domain:     a contender that DrawsAlone() and has loaded the family.
  const Judgement& Of(Contender& contender);

 private:
  struct Answers;  // of one model
  const Answers& AnswersOf(const Profile& model);
  std::vector<std::size_t> PlacesFor(const Contender& contender) const;

  const FamilyInput& family_;
  const JudgedTriangles& judged_;
  std::list<Answers> answers_;
  std::map<std::string, Judgement> known_;
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_ERRORS_H_
