// Domains of meshes that other programs make, of tilted edges and of tiles: each has what it is
// for. Least numbers are about half of what was measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/sample_pattern.h"
#include "core/snap.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "model/snap.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kConstructedCases = 200;

Case DrawConstructed(std::string_view domain, const SubjectInfo& info, std::uint64_t index) {
  PhiloxSource bits(1, index);
  return FindDomain(domain)->draw(bits, info);
}

std::array<Point2, 3> PlacesOf(const Scene& scene, const Triangle& t) {
  const auto v = Corners(scene, t);
  return {WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
}

// Samples strictly between the ends of ab and exactly on it, and their places in the pattern.
struct OnLine {
  std::set<int> places;
  int samples = 0;
};

OnLine SamplesOn(const Case& c, Point2 a, Point2 b) {
  OnLine on;
  for (int pixel = 0; pixel < c.scene.width * c.scene.height; ++pixel) {
    for (int s = 0; s < c.profile.pattern.samples(); ++s) {
      const Point2 p = c.profile.pattern.At(pixel % c.scene.width, pixel / c.scene.width, s);
      const double along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
      const double from_b = (p.x - b.x) * (a.x - b.x) + (p.y - b.y) * (a.y - b.y);
      if (along <= 0 || from_b <= 0 || exact::EdgeSign(a, b, p) != 0) continue;
      on.places.insert(s);
      ++on.samples;
    }
  }
  return on;
}

// Of the two places that both triangles have; their vertices may be repeated.
OnLine SamplesOnCommonEdge(const Case& c) {
  std::vector<Point2> common;
  for (const Point2 p : PlacesOf(c.scene, c.scene.triangles[0])) {
    if (std::ranges::count(PlacesOf(c.scene, c.scene.triangles[1]), p) != 0) common.push_back(p);
  }
  return common.size() == 2 ? SamplesOn(c, common[0], common[1]) : OnLine{};
}

TEST(PatternLines, PassSeveralPlacesOfThePatternInOneEdgeThatTwoTrianglesShare) {
  EXPECT_FALSE(Suits(*FindDomain("pattern-lines"), SnappedInfo(8)));
  for (const int samples : {2, 4, 8, 16}) {
    for (SubjectInfo info : {RealInfo(), SnappedInfo(8)}) {
      info.profile.pattern = *StandardPattern(samples);
      ASSERT_TRUE(Suits(*FindDomain("pattern-lines"), info));
      int meshes = 0;
      int of_two_places = 0;
      int of_six_samples = 0;
      for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
        const Case c = DrawConstructed("pattern-lines", info, i);
        const OnLine on = SamplesOnCommonEdge(c);
        EXPECT_GE(on.samples, 1) << samples << " samples, case " << i;
        meshes += c.scene.triangles.size() == 2 ? 1 : 0;
        of_two_places += on.places.size() >= 2 ? 1 : 0;
        of_six_samples += on.samples >= 6 ? 1 : 0;
      }
      EXPECT_EQ(meshes, kConstructedCases) << samples;
      EXPECT_GE(of_two_places, 70) << samples;
      EXPECT_GE(of_six_samples, 35) << samples;
    }
  }
}

bool CoversASample(const Scene& scene, const Profile& profile) {
  const CoverageCounts counts = exact::Coverage(scene, profile);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts.Count(k) != 0) return true;
  }
  return false;
}

// Whether the triangle's area changes its sign by the snap, and it covers a sample after that.
bool TurnsAndCovers(const Case& c, std::size_t t) {
  const std::array<Point2, 3> given = PlacesOf(c.scene, c.scene.triangles[t]);
  std::array<Point2, 3> snapped = given;
  for (Point2& p : snapped) {
    p = {SnapCoordinate(p.x, c.profile.snap), SnapCoordinate(p.y, c.profile.snap)};
  }
  const int facing = exact::Facing(snapped);
  if (facing == 0 || exact::Facing(given) != -facing) return false;
  Scene alone = c.scene;
  alone.triangles = {c.scene.triangles[t]};
  return CoversASample(alone, c.profile);
}

int CasesThatTurnAndCover(std::string_view domain, const SubjectInfo& info) {
  int cases = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const Case c = DrawConstructed(domain, info, i);
    bool found = false;
    for (std::size_t t = 0; t < c.scene.triangles.size() && !found; ++t) {
      found = TurnsAndCovers(c, t);
    }
    cases += found ? 1 : 0;
  }
  return cases;
}

TEST(TurnedBySnap, CoversASampleOfTheSideThatItHadNotBeforeTheSnap) {
  EXPECT_FALSE(Suits(*FindDomain("turned-by-snap"), RealInfo()));
  for (const int bits : {1, 4, 8, 16}) {
    for (const SnapRule rule : {SnapRule::kNearestEven, SnapRule::kFloor, SnapRule::kTruncate}) {
      SubjectInfo info = SnappedInfo(bits);
      info.profile.snap.rule = rule;
      EXPECT_GE(CasesThatTurnAndCover("turned-by-snap", info), 100) << bits << " bits";
    }
  }
  for (const std::string_view before : {"least-areas", "equal-after-snap"}) {
    EXPECT_EQ(CasesThatTurnAndCover(before, SnappedInfo(8)), 0) << before;
  }
}

// Whether the float64 determinant has another sign than the exact one.
bool IsMisjudgedInDouble(const std::array<Vertex, 3>& v) {
  const double rounded = v[0].x * (v[1].y * v[2].w - v[1].w * v[2].y) -
                         v[0].y * (v[1].x * v[2].w - v[1].w * v[2].x) +
                         v[0].w * (v[1].x * v[2].y - v[1].y * v[2].x);
  return exact::HomogeneousFacing(v) * rounded >= 0;
}

TEST(EyePlanes, CoverSamplesWhereTheDeterminantInDoubleHasTheWrongSign) {
  for (const auto& [precision, least] :
       {std::pair{Precision::kFloat32, 5}, {Precision::kFloat64, 40}}) {
    SubjectInfo info = RealInfo();
    info.takes_window = false;
    info.takes_clip = true;
    info.input = precision;
    int cases = 0;
    for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
      const Case c = DrawConstructed("eye-planes", info, i);
      bool found = false;
      for (const Triangle& t : c.scene.triangles) {
        Scene alone = c.scene;
        alone.triangles = {t};
        found =
            found || (IsMisjudgedInDouble(Corners(c.scene, t)) && CoversASample(alone, c.profile));
      }
      cases += found ? 1 : 0;
    }
    EXPECT_GE(cases, least);
  }
}

// Cases of two triangles, one of which reaches `far` pixels and one not, that cover a sample twice
// or leave one between them if only one of them is rounded down.
int CasesThatPartAtAFarCorner(std::string_view domain, const SubjectInfo& info, double far) {
  int cases = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const Case c = DrawConstructed(domain, info, i);
    if (c.scene.triangles.size() != 2) continue;
    CoverageCounts sum(c.scene.width, c.scene.height);
    std::size_t reaching = 0;
    for (const Triangle& t : c.scene.triangles) {
      Scene alone = c.scene;
      alone.triangles = {t};
      Profile profile = c.profile;
      const auto v = PlacesOf(c.scene, t);
      const bool reaches = std::ranges::any_of(
          v, [far](Point2 p) { return std::max(std::fabs(p.x), std::fabs(p.y)) >= far; });
      reaching += reaches ? 1 : 0;
      if (reaches) profile.snap.rule = SnapRule::kFloor;
      sum += exact::Coverage(alone, profile);
    }
    const CoverageCounts whole = exact::Coverage(c.scene, c.profile);
    bool differs = false;
    for (std::size_t k = 0; k < sum.size(); ++k)
      differs = differs || sum.Count(k) != whole.Count(k);
    cases += reaching == 1 && differs ? 1 : 0;
  }
  return cases;
}

TEST(NearBesideFar, PartWhereOneOfTwoPathsRoundsOtherwise) {
  SubjectInfo info = SnappedInfo(8);
  info.input = Precision::kFloat64;
  info.profile.coordinate_limit = 0x1p30;
  for (const auto& [far, least] :
       {std::pair{0x1p11, 30}, {0x1p24, 20}, {0x1p27, 12}, {0x1p29, 7}}) {
    EXPECT_GE(CasesThatPartAtAFarCorner("near-beside-far", info, far), least) << far;
  }
}

TEST(TiltedGrids, HaveSharedEdgesThroughSamplesThatAreNeitherLevelNorDiagonal) {
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8)}) {
    int cases = 0;
    for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
      const Case c = DrawConstructed("tilted-grids", info, i);
      std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
      bool has_hit = false;
      for (const Triangle& t : c.scene.triangles) {
        const auto v = PlacesOf(c.scene, t);
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t next = (k + 1) % 3;
          if (++uses[std::minmax({t[k], t[next]})] != 2) continue;
          if (std::fabs(v[next].x - v[k].x) == std::fabs(v[next].y - v[k].y)) continue;
          if (v[next].x == v[k].x || v[next].y == v[k].y) continue;
          has_hit = has_hit || SamplesOn(c, v[k], v[next]).samples > 0;
        }
      }
      cases += has_hit ? 1 : 0;
    }
    EXPECT_GT(cases, 23);
  }
}

TEST(DiagonalNeedles, AreAStepWideAndCoverSamples) {
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8)}) {
    int covering = 0;
    int thin = 0;
    for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
      const Case c = DrawConstructed("diagonal-needles", info, i);
      for (const Triangle& t : c.scene.triangles) {
        const auto v = PlacesOf(c.scene, t);
        const double twice_area =
            (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
        const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
        const double length = right - left;
        thin += twice_area != 0 && std::fabs(twice_area) <= length * 0x1p-8 ? 1 : 0;
      }
      const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
      bool covers = false;
      for (std::size_t s = 0; s < counts.size(); ++s) covers = covers || counts.Count(s) != 0;
      covering += covers ? 1 : 0;
    }
    EXPECT_GT(thin, 350);
    EXPECT_GT(covering, 78);
  }
}

TEST(TileBorders, AreMetWhateverTheSizeOfTheTile) {
  std::array<int, 5> on{};
  int thin = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const Case c = DrawConstructed("tile-borders", SnappedInfo(8), i);
    for (std::size_t k = 0; k < on.size(); ++k) {
      const double tile = std::ldexp(4.0, static_cast<int>(k));
      for (const Vertex& v : c.scene.vertices) {
        on[k] += v.x != 0 && std::remainder(v.x, tile) == 0 ? 1 : 0;
      }
    }
    for (const Triangle& t : c.scene.triangles) {
      const auto v = PlacesOf(c.scene, t);
      const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
      const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
      thin += std::fabs(right - left) == 1 || std::fabs(bottom - top) == 1 ? 1 : 0;
    }
  }
  for (const int vertices : on) EXPECT_GT(vertices, 80);
  EXPECT_GT(thin, 107);
}

// Whether an edge passes the outermost sample of a tile of 4 pixels, in one of its corners, and its
// value there is under 2^-30 of its largest at the other corners.
bool PassesACorner(const Scene& scene, const std::array<Point2, 3>& v) {
  constexpr double kTile = 4;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    const double across = std::fabs(b.x - a.x) + std::fabs(b.y - a.y);
    for (int j = 0; j < scene.height; ++j) {
      for (int i = 0; i < scene.width; ++i) {
        if ((i % 4 != 0 && i % 4 != 3) || (j % 4 != 0 && j % 4 != 3)) continue;
        const double e = (i + 0.5 - a.x) * (b.y - a.y) - (j + 0.5 - a.y) * (b.x - a.x);
        if (e != 0 && std::fabs(e) <= std::ldexp(kTile * across, -30)) return true;
      }
    }
  }
  return false;
}

TEST(FarTileCorners, ArePassedAsNearAsADoubleTellsFromFarOff) {
  int passed = 0;
  int before = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const auto passes = [&](std::string_view domain) {
      const Case c = DrawConstructed(domain, SnappedInfo(8), i);
      return std::ranges::any_of(c.scene.triangles, [&](const Triangle& t) {
        return PassesACorner(c.scene, PlacesOf(c.scene, t));
      });
    };
    passed += passes("far-tile-corners") ? 1 : 0;
    before += passes("tile-borders") ? 1 : 0;
  }
  EXPECT_GT(passed, 27);
  EXPECT_LT(before, 10);
}

TEST(RoundedArrangements, HaveFlatAndInvertedTrianglesAndEachEdgeOnceEachWay) {
  for (const SubjectInfo& info : {RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(8)}) {
    int flat = 0;
    int inverted = 0;
    int closed = 0;
    for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
      const Case c = DrawConstructed("rounded-arrangements", info, i);
      std::array<int, 3> facings{};
      std::map<std::pair<Point2, Point2>, int, decltype([](const auto& p, const auto& q) {
                 const auto key = [](const auto& e) {
                   return std::array{e.first.x, e.first.y, e.second.x, e.second.y};
                 };
                 return key(p) < key(q);
               })>
          edges;
      for (const Triangle& t : c.scene.triangles) {
        const auto v = PlacesOf(c.scene, t);
        ++facings[static_cast<std::size_t>(exact::Facing(v) + 1)];
        for (std::size_t k = 0; k < 3; ++k) {
          ++edges[{v[k], v[(k + 1) % 3]}];
          --edges[{v[(k + 1) % 3], v[k]}];
        }
      }
      const bool is_closed =
          std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
      closed += is_closed ? 1 : 0;
      flat += facings[1] != 0 ? 1 : 0;
      inverted += !is_closed && facings[0] != 0 && facings[2] != 0 ? 1 : 0;
      const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
      for (std::size_t s = 0; s < counts.size(); ++s) {
        ASSERT_EQ(std::abs(counts.Signed(s)), is_closed ? 0 : 1) << i;
      }
    }
    EXPECT_GT(flat, 80);
    EXPECT_GT(inverted, 19);
    EXPECT_GT(closed, 50);
  }
}

TEST(EqualAfterSnap, DifferAsGiven) {
  const SubjectInfo info = SnappedInfo(8);
  int equal = 0;
  int collinear = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const Case c = DrawConstructed("equal-after-snap", info, i);
    bool has_equal = false;
    bool has_collinear = false;
    for (const Triangle& t : c.scene.triangles) {
      const auto given = PlacesOf(c.scene, t);
      std::array<Point2, 3> v = given;
      for (Point2& p : v) {
        p = {SnapCoordinate(p.x, info.profile.snap), SnapCoordinate(p.y, info.profile.snap)};
      }
      if (exact::Facing(given) == 0 || exact::Facing(v) != 0) continue;
      const bool equals = v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
      has_equal = has_equal || equals;
      has_collinear = has_collinear || !equals;
    }
    equal += has_equal ? 1 : 0;
    collinear += has_collinear ? 1 : 0;
  }
  EXPECT_GT(equal, 93);
  EXPECT_GT(collinear, 77);
}

TEST(EqualAfterSnap, IsAStepApartWhereNothingIsSnapped) {
  int apart = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const Case c = DrawConstructed("equal-after-snap", RealInfo(), i);
    bool found = false;
    for (const Triangle& t : c.scene.triangles) {
      const auto v = PlacesOf(c.scene, t);
      const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
      found = found || std::nextafterf(static_cast<float>(left), 1e9F) == right;
    }
    apart += found ? 1 : 0;
  }
  EXPECT_GT(apart, 79);
}

double TwiceArea(const std::vector<Point2>& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point2 a = ring[k];
    const Point2 b = ring[(k + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return std::fabs(sum);
}

TEST(EarcutMeshes, RepeatVerticesHaveFlatEarsAndCoverAllButTheHoles) {
  int cases = 0;
  int complete = 0;
  int flat = 0;
  for (std::uint64_t i = 0; i < kConstructedCases; ++i) {
    const Case c = DrawConstructed("earcut-meshes", SnappedInfo(8), i);
    // Else the vertices are no longer those of the outline.
    if (c.scene.vertices.size() == 3 * c.scene.triangles.size()) continue;
    ++cases;
    std::vector<Point2> outline;
    std::set<std::pair<double, double>> places;
    for (const Vertex& v : c.scene.vertices) {
      outline.push_back(WindowPoint(v));
      places.insert({v.x, v.y});
    }
    EXPECT_LT(places.size(), outline.size()) << i;
    double covered = 0;
    bool has_flat = false;
    for (const Triangle& t : c.scene.triangles) {
      const auto v = PlacesOf(c.scene, t);
      covered += TwiceArea({v[0], v[1], v[2]});
      has_flat = has_flat || exact::Facing(v) == 0;
    }
    complete += covered == TwiceArea(outline) ? 1 : 0;
    flat += has_flat ? 1 : 0;
  }
  EXPECT_GT(cases, 86);
  EXPECT_GT(flat, 38);
  EXPECT_GE(complete, cases * 9 / 10);  // no ear is left in the others
}

}  // namespace
}  // namespace rasterproof::props
