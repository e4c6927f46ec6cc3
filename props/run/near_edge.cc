#include "props/run/near_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/snap.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "model/snap.h"
#include "model/target_profile.h"
#include "model/wrap.h"
#include "props/domains/input_lattice.h"
#include "props/run/case_places.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostNearTriangles = 64;
constexpr long double kUnit = std::numeric_limits<long double>::epsilon();

struct LongPoint {
  long double x = 0;
  long double y = 0;
};

// An edge as a float sees it, and as the oracle does.
struct ProjectedEdge {
  LongPoint a;
  LongPoint b;
  Vertex exact_a;
  Vertex exact_b;
  bool clip_space = false;

  bool Through(Point2 p) const {
    if (clip_space) return exact::HomogeneousEdgeSign(exact_a, exact_b, p) == 0;
    return exact::EdgeSign(WindowPoint(exact_a), WindowPoint(exact_b), p) == 0;
  }
};

// Whether v has a place in the window; v is wrapped and snapped if it has, as the profile says.
bool PutIntoWindow(Vertex& v, bool clip_space, const Profile& profile) {
  if (!IsFinite(v)) return false;
  if (clip_space && !(v.w > 0)) return false;
  if (profile.fixed) v = {Wrapped(v.x, *profile.fixed), Wrapped(v.y, *profile.fixed), v.z, v.w};
  const Snap& snap = profile.snap;
  if (!snap.IsNone()) {
    if (clip_space) v = {v.x / v.w, v.y / v.w, v.z, 1};
    v.x = SnapCoordinate(v.x, snap);
    v.y = SnapCoordinate(v.y, snap);
  }
  return std::isfinite(v.x) && std::isfinite(v.y);
}

// An edge by its ends, whichever way it runs, to find the triangle that shares it.
struct EdgeSeen {
  std::array<double, 8> ends;
  bool has_tie = false;
};

EdgeSeen SeenOf(const ProjectedEdge& edge) {
  const auto words = [](const Vertex& v) { return std::array<double, 4>{v.x, v.y, v.z, v.w}; };
  const auto a = std::min(words(edge.exact_a), words(edge.exact_b));
  const auto b = std::max(words(edge.exact_a), words(edge.exact_b));
  return {{a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]}};
}

bool IsInFront(const std::array<Vertex, 3>& v) {
  return std::ranges::all_of(v, [](const Vertex& vertex) { return vertex.w > 0; });
}

LongPoint Projected(const Vertex& v) {
  if (v.w == 1) return {v.x, v.y};
  return {static_cast<long double>(v.x) / v.w, static_cast<long double>(v.y) / v.w};
}

class Counter {
 public:
  explicit Counter(const Case& c)
      : case_(c), profile_(c.profile, c.scene), lattice_(profile_, c.scene.precision) {}

  CaseEvidence Count() {
    const std::vector<Triangle>& triangles = case_.scene.triangles;
    for (std::size_t t = 0; t < std::min(kMostNearTriangles, triangles.size()); ++t) {
      CountTriangle(Corners(case_.scene, triangles[t]));
    }
    if (SharedEdgeHasTie()) Note(CasePlace::kTieOnSharedEdge);
    return {counts_, places_};
  }

 private:
  void Note(CasePlace place) { places_.set(IndexOf(place)); }

  bool SharedEdgeHasTie() {
    std::ranges::sort(edges_, {}, &EdgeSeen::ends);
    for (std::size_t k = 1; k < edges_.size(); ++k) {
      // Its samples are the same ones seen from either side.
      if (edges_[k].ends == edges_[k - 1].ends && edges_[k].has_tie) return true;
    }
    return false;
  }

  void NotePlacesOf(const std::array<LongPoint, 3>& v) {
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (right < 0 || bottom < 0 || left > case_.scene.width || top > case_.scene.height) {
      Note(CasePlace::kOffTarget);
    }
    const bool leaves =
        left < 0 || top < 0 || right > case_.scene.width || bottom > case_.scene.height;
    if (leaves && case_.scene.clip_space) Note(CasePlace::kClipped);
    for (const LongPoint& p : v) {
      for (int s = 0; s < profile_.pattern.samples(); ++s) NoteIfOnASample(p, s);
    }
  }

  void NoteIfOnASample(LongPoint p, int s) {
    const Point2 location = profile_.pattern.locations[static_cast<std::size_t>(s)];
    const long double column = p.x - location.x;
    const long double row = p.y - location.y;
    const bool is_there = column == std::floor(column) && row == std::floor(row) && column >= 0 &&
                          row >= 0 && column < case_.scene.width && row < case_.scene.height;
    if (is_there) Note(CasePlace::kVertexOnASample);
  }

  // By the sign of its area.
  void NoteFacing(int sign) {
    Note(sign == 0  ? CasePlace::kFlatTriangle
         : sign > 0 ? CasePlace::kPositiveArea
                    : CasePlace::kNegativeArea);
  }

  void NoteTie(const ProjectedEdge& edge) {
    edges_.back().has_tie = true;
    if (edge.a.y == edge.b.y) {
      Note(CasePlace::kTieOnHorizontalEdge);
    } else if (edge.a.x == edge.b.x) {
      Note(CasePlace::kTieOnVerticalEdge);
    } else {
      Note(CasePlace::kTieOnSlantedEdge);
    }
  }

  void CountTriangle(std::array<Vertex, 3> v) {
    const bool clip_space = case_.scene.clip_space;
    if (clip_space && std::ranges::all_of(v, IsFinite) && !IsInFront(v)) {
      Note(CasePlace::kClipped);
      NoteFacing(exact::HomogeneousFacing(v));
    }
    for (Vertex& vertex : v) {
      if (!PutIntoWindow(vertex, clip_space, profile_)) return;
    }
    const bool projected = clip_space && profile_.snap.IsNone();
    NotePlacesOf({Projected(v[0]), Projected(v[1]), Projected(v[2])});
    NoteFacing(projected
                   ? exact::HomogeneousFacing(v)
                   : exact::EdgeSign(WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])));
    for (std::size_t e = 0; e < 3; ++e) {
      const Vertex& a = v[(e + 1) % 3];
      const Vertex& b = v[(e + 2) % 3];
      const ProjectedEdge edge{Projected(a), Projected(b), a, b, projected};
      edges_.push_back(SeenOf(edge));
      for (int s = 0; s < profile_.pattern.samples(); ++s) CountEdge(edge, s);
    }
  }

  void CountEdge(const ProjectedEdge& edge, int s) {
    const long double dx = edge.b.x - edge.a.x;
    const long double dy = edge.b.y - edge.a.y;
    const bool steep = std::fabs(dy) >= std::fabs(dx);  // then walk down the rows
    const long double major = steep ? dy : dx;
    if (major == 0) return;
    const Point2 location = profile_.pattern.locations[static_cast<std::size_t>(s)];
    const double offset = steep ? location.y : location.x;
    const long double from = steep ? edge.a.y : edge.a.x;
    const long double to = steep ? edge.b.y : edge.b.x;
    const int lines = steep ? case_.scene.height : case_.scene.width;
    const auto clamped = [&](long double line) {
      return static_cast<int>(std::clamp<long double>(line, -1, lines));
    };
    const int first = std::max(0, clamped(std::ceil(std::min(from, to) - offset)));
    const int last = std::min(lines - 1, clamped(std::floor(std::max(from, to) - offset)));
    const long double slope = steep ? dx / dy : dy / dx;
    for (int line = first; line <= last; ++line) CountLine(edge, slope, s, steep, line);
  }

  // As CountLine(), in double, where that leaves no doubt: a long double may cost 30 times as much.
  // M is the largest |x| of the edge's ends. `at` is within 13 u (M + 1) of the crossing
  // (reference/proofs/row_crossing.g, the same form with a slope that is rounded once more); the
  // long double `at`, its error, and the two sums of a distance add less than 3 u (M + 1).
  //
  // Returns: whether it did; else nothing is counted.
  bool CountsLineInDouble(const ProjectedEdge& edge, long double slope, int s, bool steep,
                          int line) {
    const Point2 location = profile_.pattern.locations[static_cast<std::size_t>(s)];
    const double along = line + (steep ? location.y : location.x);
    const double offset = steep ? location.x : location.y;
    if (edge.exact_a.w != 1 || edge.exact_b.w != 1 ||
        along - line != (steep ? location.y : location.x))
      return false;
    const Point2 ends[] = {WindowPoint(edge.exact_a), WindowPoint(edge.exact_b)};
    const Point2 a = steep ? ends[0] : Point2{ends[0].y, ends[0].x};
    const Point2 b = steep ? ends[1] : Point2{ends[1].y, ends[1].x};
    const Point2& near = std::fabs(along - a.y) <= std::fabs(along - b.y) ? a : b;
    const double across = (along - near.y) * static_cast<double>(slope);
    const double at = near.x + across;
    const double doubt = 0x1p-49 * (std::max(std::fabs(a.x), std::fabs(b.x)) + 1);
    if (!(doubt <= 0.25)) return false;
    const double floor = std::floor(at - doubt - offset);
    if (floor != std::floor(at + doubt - offset)) return false;
    const int places = steep ? case_.scene.width : case_.scene.height;
    const auto before = static_cast<int>(std::clamp<double>(floor, -2, places));
    NearEdgeCounts counts;
    for (int place = std::max(0, before); place <= std::min(places - 1, before + 1); ++place) {
      const Point2 p =
          steep ? profile_.pattern.At(place, line, s) : profile_.pattern.At(line, place, s);
      const double distance = std::fabs(place + offset - at);
      const double step = lattice_.Step(steep ? p.x : p.y);
      const double steps = distance / step - 0.5;
      const double slack = doubt / step + 0x1p-50 * (steps + 1);
      const auto may_be = [&](double limit) { return std::fabs(steps - limit) <= slack; };
      if (!(distance > doubt) || may_be(1) || may_be(16) || may_be(256)) return false;
      ++counts.samples;
      if (steps <= 1) ++counts.within_1;
      if (steps <= 16) ++counts.within_16;
      if (steps <= 256) ++counts.within_256;
    }
    counts_ += counts;
    return true;
  }

  // The two samples of one row or column between which the edge passes.
  void CountLine(const ProjectedEdge& edge, long double slope, int s, bool steep, int line) {
    if (CountsLineInDouble(edge, slope, s, steep, line)) return;
    const Point2 location = profile_.pattern.locations[static_cast<std::size_t>(s)];
    const long double along = line + (steep ? location.y : location.x);
    const long double offset = steep ? location.x : location.y;
    const LongPoint a = steep ? edge.a : LongPoint{edge.a.y, edge.a.x};
    const LongPoint b = steep ? edge.b : LongPoint{edge.b.y, edge.b.x};
    // From the nearer end: four roundings of the way across from there, and the two ends' own.
    const LongPoint& near = std::fabs(along - a.y) <= std::fabs(along - b.y) ? a : b;
    const long double across = (along - near.y) * slope;
    const long double at = near.x + across;
    const long double error = 4 * kUnit * (std::fabs(across) + std::fabs(a.x) + std::fabs(b.x));
    const int places = steep ? case_.scene.width : case_.scene.height;
    const auto before =
        static_cast<int>(std::clamp<long double>(std::floor(at - offset), -2, places));
    for (int place = std::max(0, before); place <= std::min(places - 1, before + 1); ++place) {
      const Point2 p =
          steep ? profile_.pattern.At(place, line, s) : profile_.pattern.At(line, place, s);
      CountPair(edge, p, std::fabs(place + offset - at), error, steep ? p.x : p.y);
    }
  }

  void CountPair(const ProjectedEdge& edge, Point2 p, long double distance, long double error,
                 double coordinate) {
    ++counts_.samples;
    if (distance <= error && edge.Through(p)) {
      ++counts_.on_edge;
      NoteTie(edge);
      return;
    }
    // To the nearest whole step: a sample one step off is within 1 whatever the last bit says.
    const long double steps = (distance + error) / lattice_.Step(coordinate) - 0.5L;
    if (steps <= 1) ++counts_.within_1;
    if (steps <= 16) ++counts_.within_16;
    if (steps <= 256) ++counts_.within_256;
  }

  const Case& case_;
  TargetProfile profile_;
  InputLattice lattice_;
  NearEdgeCounts counts_;
  CasePlaces places_;
  std::vector<EdgeSeen> edges_;  ///< of every triangle, in order
};

}  // namespace

CaseEvidence EvidenceOfCase(const Case& c) { return Counter(c).Count(); }

NearEdgeCounts CountNearEdges(const Case& c) { return EvidenceOfCase(c).near_edge; }

}  // namespace rasterproof::props
