// A scene covers what its own vertices say, though one that differs in a vertex alone came before.
//
// What is kept of a call (set-up, tiles, a whole image) and found again by less than all that it
// was made of shows where a small move changes what is covered: in the model, or, where the profile
// leaves a choice, in every legal model.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "model/snap_scene.h"
#include "props/judging/flat_triangles.h"
#include "props/judging/gate.h"
#include "props/judging/legal_counts.h"
#include "props/judging/redraw.h"
#include "props/properties/all.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {
namespace {

// Of larger cases the moves cost more than they show.
constexpr std::size_t kMostSamples = 4096;
constexpr std::size_t kMostTriangles = 16;

struct Successor {
  Scene scene;
  LegalCounts expected;
  std::string change;  // completes "drawn after the case, with ..."
};

// The moves, from small to large. A distance of 0 stands for the next number of the format.
struct Distance {
  double pixels = 0;
  const char* words = "";
};

std::array<Distance, 3> DistancesOf(const Profile& profile) {
  if (profile.freedom.MovesVertices() && !profile.snap.IsNone()) {
    const int coarsest = LegalGrids(profile.snap, profile.freedom).front().bits;
    return {{{std::ldexp(1.0, 1 - coarsest), "two steps of the coarsest legal grid"},
             {std::ldexp(1.0, 3 - coarsest), "eight steps of the coarsest legal grid"},
             {1, "a pixel"}}};
  }
  int bits = profile.snap.IsNone() ? 8 : profile.snap.bits;
  if (profile.fixed) bits = profile.fixed->fraction_bits;
  return {{{0, "an ulp"}, {std::ldexp(1.0, -bits), "a subpixel step"}, {1, "a pixel"}}};
}

double MovedBy(double x, double distance, double sign, Precision precision) {
  const double moved = x + sign * distance;
  if (precision == Precision::kFloat64) {
    return distance == 0 ? std::nextafter(x, sign * HUGE_VAL) : moved;
  }
  const auto narrow = static_cast<float>(moved);
  return distance == 0 ? std::nextafter(narrow, static_cast<float>(sign) * HUGE_VALF) : narrow;
}

// Whether the profile says what the case's scene covers, triangles without area included.
bool IsStated(const Case& c) {
  if (!WithinLimits(c.scene, c.profile) || !CanBeGiven(c.scene, c.profile) ||
      !IsUnclipped(c.scene, c.profile) || exact::WhyNotDecided(c.scene, c.profile)) {
    return false;
  }
  return c.profile.degenerate_triangles == DegenerateTriangles::kNothing ||
         FlatTriangles(c).empty();
}

class Successors {
 public:
  explicit Successors(const Case& c) : c_(c), expected_(c.scene, c) {}

  const LegalCounts& expected() const { return expected_; }

  // The first move of one vertex by the distance that changes what is covered, if any does.
  std::optional<Successor> MovedOneVertex(const Distance& distance) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(c_.scene.triangles.front()[k]);
      for (double Vertex::* const axis : {&Vertex::x, &Vertex::y}) {
        for (const double sign : {1.0, -1.0}) {
          Scene moved = c_.scene;
          double& x = moved.vertices[vertex].*axis;
          x = MovedBy(x, distance.pixels, sign, moved.precision);
          const std::string change =
              "vertex " + std::to_string(vertex) + " moved by " + distance.words;
          if (auto successor = IfItDiffers(std::move(moved), change)) return successor;
        }
      }
    }
    return std::nullopt;
  }

  // Other vertices under the same indices, as many: x and y exchanged, or the list turned round.
  std::optional<Successor> OtherContent() const {
    Scene exchanged = c_.scene;
    for (Vertex& v : exchanged.vertices) std::swap(v.x, v.y);
    if (auto successor = IfItDiffers(std::move(exchanged), "x and y of all vertices exchanged")) {
      return successor;
    }
    Scene reversed = c_.scene;
    reversed.vertices.assign(c_.scene.vertices.rbegin(), c_.scene.vertices.rend());
    return IfItDiffers(std::move(reversed), "its vertices in the reverse order");
  }

 private:
  std::optional<Successor> IfItDiffers(Scene scene, const std::string& change) const {
    if (!IsStated({scene, c_.profile, c_.options, {}})) return std::nullopt;
    LegalCounts expected(scene, c_);
    if (expected.Apart(expected_) == 0) return std::nullopt;
    return Successor{std::move(scene), std::move(expected), change};
  }

  const Case& c_;
  LegalCounts expected_;
};

// The case, each successor behind it, and the case again.
std::vector<DrawQuestion> DrawsOf(const Case& c, const std::vector<Successor>& successors) {
  std::vector<DrawQuestion> draws{LegalCounts::QuestionOf(c.scene, c)};
  for (const Successor& successor : successors) {
    draws.push_back(LegalCounts::QuestionOf(successor.scene, c));
  }
  draws.push_back(draws.front());
  return draws;
}

Verdict Judged(const Answers& answers, bool counts, const LegalCounts& first,
               const std::vector<Successor>& successors) {
  std::uint64_t changed = 0;
  for (const Successor& s : successors) changed += s.expected.Apart(first);
  for (std::size_t d = 0; d < answers.draws.size(); ++d) {
    const bool is_the_case = d == 0 || d > successors.size();
    std::string of;
    if (d != 0) of += is_the_case ? ", drawn once more" : ", drawn after the case, with ";
    if (!is_the_case) of += successors[d - 1].change + ",";
    const LegalCounts& expected = is_the_case ? first : successors[d - 1].expected;
    Verdict verdict = expected.VerdictOn(answers.draws[d]->counts, counts, changed, of);
    if (verdict.outcome == Outcome::kViolated) return OfDraw(d, std::move(verdict));
  }
  return Verdict::Held(changed);
}

Asked Ask(const Case& c, const Description& subject) {
  if (c.scene.triangles.empty() || c.scene.triangles.size() > kMostTriangles ||
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.pattern.samples()) >
          kMostSamples) {
    return NothingAsked("the case has no triangle, or is large");
  }
  if (auto why = WhyNoLegalCounts(c.scene, c.profile)) return NothingAsked(*why);
  const Successors of(c);
  std::vector<Successor> successors;
  for (const Distance& distance : DistancesOf(c.profile)) {
    if (auto moved = of.MovedOneVertex(distance)) successors.push_back(*std::move(moved));
  }
  if (successors.empty()) return NothingAsked("no vertex that moves changes what is covered");
  if (auto other = of.OtherContent()) successors.push_back(*std::move(other));
  Questions questions;
  questions.company = Company::kInOrderAlone;
  questions.draws = DrawsOf(c, successors);
  const CoverageKind kind = subject.info.coverage;
  const bool counts = kind == CoverageKind::kFacingCounts || kind == CoverageKind::kCounts;
  return OneCheck(
      std::move(questions),
      [counts, first = of.expected(), successors = std::move(successors)](const Answers& answers) {
        return Judged(answers, counts, first, successors);
      });
}

constexpr std::array kRules{kCountsTies, kStatesSamplePositions};

}  // namespace

constinit const Property kNewVerticesGiveNewCoverage{
    .name = "NewVerticesGiveNewCoverage",
    .group = "extremes",
    .clause = "What a scene covers follows from its own vertices, not from what was drawn before.",
    .required_by = kLegalModelClauses,
    .tolerance = kExact,
    .domains = kNearEdges,
    .is_about_sequence = true,
    .gate = Where({.any_model = true, .rules = kRules, .asks_oracle = true},
                  "a vertex of its first triangle that can move and change what is covered"),
    .ask = Ask,
};

}  // namespace rasterproof::props
