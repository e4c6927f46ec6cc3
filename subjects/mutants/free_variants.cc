// Rasterizers that take the worst of what is legal, and the same with one illegal act each.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

using Harm = double (*)(Point2 at, Point2 grid_point);

double SquaredDistance(Point2 a, Point2 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// Neighbours that lie beside each other change sides.
double Farthest(Point2 at, Point2 grid_point) { return SquaredDistance(at, grid_point); }

constexpr Point2 kCentre{8, 8};
double Towards(Point2, Point2 grid_point) { return -SquaredDistance(kCentre, grid_point); }
double Away(Point2, Point2 grid_point) { return SquaredDistance(kCentre, grid_point); }

// No two vertices agree where to go.
double Anyhow(Point2 at, Point2 grid_point) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (const double x : {at.x, at.y, grid_point.x, grid_point.y}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 32;
  }
  return static_cast<double>(hash >> 12);
}

// Up and to the left in every other pixel, down and to the right in those between.
double Crosswise(Point2 at, Point2 grid_point) {
  const double pixels = std::floor(at.x) + std::floor(at.y);
  const double sign = std::fmod(pixels, 2.0) == 0 ? 1 : -1;
  return sign * (2 * grid_point.x + grid_point.y);
}

// Onto the samples, or as near as can be: ties.
double OntoSamples(Point2, Point2 grid_point) {
  const Point2 sample{std::floor(grid_point.x) + 0.5, std::floor(grid_point.y) + 0.5};
  return -SquaredDistance(grid_point, sample);
}

FreeStages Choosing(int bits, double tolerance, Harm harm) {
  FreeStages stages;
  stages.profile = FixedPointProfile();
  stages.profile.name = "free choice";
  stages.profile.snap.bits = bits;
  stages.profile.freedom.snap_tolerance = tolerance;
  stages.bits = bits;
  stages.tolerance = tolerance;
  stages.harm = harm;
  return stages;
}

// The grid is its own affair, or stated; which of its points a vertex takes is not.
FreeStages WithProfileOf(Contract contract, int stated_bits, int bits, Harm harm) {
  FreeStages stages = Choosing(bits, 1, harm);
  stages.profile.snap.bits = stated_bits;
  stages.profile.freedom = {};
  stages.profile.contract = contract;
  return stages;
}

FreeStages As(CoverageKind coverage, FreeStages stages) {
  stages.coverage = coverage;
  return stages;
}

FreeStages InClipSpace(FreeStages stages) {
  stages.takes_clip = true;
  return stages;
}

FreeStages WithRule(const TieRule& rule, FreeStages stages) {
  stages.profile.freedom.ties = TieOwnership::kAxisAligned;
  stages.rule = [rule](const std::array<Point2, 3>&) { return rule; };
  return stages;
}

constexpr TieRule kBottomRightY{-1, -1, true, false, false};

// Six of the variants have a twin that breaks the law once.
FreeStages Fold() { return Choosing(4, 1, Farthest); }
FreeStages Draw() { return As(CoverageKind::kCounts, Choosing(8, 0.6, Towards)); }
FreeStages Scatter() { return WithRule(kBottomRightY, Choosing(4, 1, Anyhow)); }
FreeStages Cross() { return As(CoverageKind::kFragments, Choosing(4, 1, Crosswise)); }
FreeStages Private() {
  return As(CoverageKind::kCounts, WithProfileOf(Contract::kWatertight, Snap::kNone, 2, Farthest));
}
FreeStages Pixels() {
  return As(CoverageKind::kMask, WithProfileOf(Contract::kWatertight, Snap::kNone, 0, Anyhow));
}

// Selects half of all triangles, whichever vertex their lists start with.
bool IsOdd(const std::array<Point2, 3>& v) {
  const double sum = v[0].x + v[1].x + v[2].x + 3 * (v[0].y + v[1].y + v[2].y);
  return std::fmod(std::floor(sum * 64), 2.0) != 0;
}

Point2 RoundedDown(Point2 p, double step) {
  return {std::floor(p.x / step) * step, std::floor(p.y / step) * step};
}

// Two grid points for one vertex: a step to the right in odd triangles.
Point2 Apart(const FreeCorner& corner, Point2 legal, double step) {
  return IsOdd(corner.triangle) ? Point2{legal.x + step, legal.y} : legal;
}

// One grid point for each vertex, and the last triangle of a sample.
FreeStages ShowsIds() {
  return {.profile = FixedPointProfile(), .coverage = CoverageKind::kPrimitiveIds};
}

std::vector<Mutant> FreeVariants() {
  return {
      {"free-farthest", "each vertex takes the farthest of its legal grid points", "", Fold()},
      {"free-towards", "each vertex is drawn towards a centre, and counts have no facing",
       "D3D's 0.6 of a step", Draw()},
      {"free-anyhow", "each vertex takes any legal grid point, and ties fall the other way", "",
       Scatter()},
      {"free-crosswise", "vertices move apart pixel by pixel, shown as fragments", "", Cross()},
      {"free-away", "each vertex is pushed away from a centre, shown as a mask", "",
       As(CoverageKind::kMask, Choosing(2, 1, Away))},
      {"free-onto-samples", "vertices make for the samples, shown as primitive ids", "",
       As(CoverageKind::kPrimitiveIds, Choosing(8, 0.6, OntoSamples))},
      {"free-ties", "only the tie rule is another one, and counts have no facing", "",
       As(CoverageKind::kCounts, WithRule(kBottomRightY, Choosing(8, 0, Farthest)))},
      {"free-whole-pixels", "each vertex takes any whole pixel beside it", "",
       Choosing(0, 1, Anyhow)},
      {"free-clip", "the farthest legal grid point from x / w, in clip space", "",
       InClipSpace(As(CoverageKind::kCounts, Choosing(4, 1, Farthest)))},
      {"free-clip-anyhow", "any legal grid point beside x / w, in clip space, as a mask", "",
       InClipSpace(As(CoverageKind::kMask, Choosing(8, 0.6, Anyhow)))},
      {"private-farthest", "a grid of its own, of quarter pixels, and its farthest points", "",
       Private()},
      {"private-pixels", "a grid of its own, of whole pixels, and any of its points", "", Pixels()},
      {"private-of-stated", "watertight, with any of the nearest points of the stated grid", "",
       WithProfileOf(Contract::kWatertight, 4, 4, Anyhow)},
      {"private-closed", "closed surfaces on a grid of its own, and counts have no facing", "",
       As(CoverageKind::kCounts, WithProfileOf(Contract::kClosed, Snap::kNone, 2, Anyhow))},
      {"private-clip", "watertight in clip space, any of the nearest points of the grid", "",
       InClipSpace(
           As(CoverageKind::kCounts, WithProfileOf(Contract::kWatertight, 4, 4, Farthest)))},
  };
}

std::vector<Mutant> FreeMutants() {
  FreeStages two_places = Fold();
  two_places.instead = [](const FreeCorner& corner, Point2 legal) {
    return IsOdd(corner.triangle) ? RoundedDown(corner.at, 0x1p-4) : legal;
  };
  FreeStages too_far = Draw();
  too_far.tolerance = 0.7;
  FreeStages rules = Scatter();
  rules.rule = [](const std::array<Point2, 3>& triangle) {
    return IsOdd(triangle) ? kTopLeft : kBottomRightY;
  };
  FreeStages crack = Cross();
  crack.instead = [](const FreeCorner& corner, Point2 legal) {
    return corner.is_turned ? RoundedDown(corner.at, 0x1p-4) : legal;
  };
  FreeStages byte = ShowsIds();
  byte.id = [](std::size_t number, std::size_t) { return number % 256; };
  FreeStages from_the_end = ShowsIds();
  from_the_end.id = [](std::size_t number, std::size_t count) { return count - 1 - number; };
  FreeStages apart = Private();
  apart.instead = [](const FreeCorner& corner, Point2 legal) { return Apart(corner, legal, 0.25); };
  FreeStages pixels_apart = Pixels();
  pixels_apart.instead = [](const FreeCorner& corner, Point2 legal) {
    return Apart(corner, legal, 1);
  };
  return {
      {"free-two-places", "a vertex of odd triangles takes another legal grid point", "",
       std::move(two_places), "", "OneLegalModelExplainsTheMesh"},
      {"free-too-far", "a grid point is taken that is 0.7 of a step off, where 0.6 is legal", "",
       std::move(too_far)},
      {"free-rules-mixed", "odd triangles have another consistent tie rule", "", std::move(rules),
       "", "OneLegalModelExplainsTheMesh"},
      {"free-turned-crack", "triangles that its choice turns take other legal grid points", "",
       std::move(crack)},
      {"private-two-places", "a vertex of odd triangles is a step of its own grid off", "",
       std::move(apart)},
      {"private-pixels-apart", "a vertex of odd triangles is a pixel off", "",
       std::move(pixels_apart)},
      {"ids-of-a-byte", "primitive ids keep 8 bits", "", std::move(byte), "",
       "PrimitiveIdFollowsTheStatedOrder"},
      {"ids-from-the-end", "primitive ids count from the end of the list", "",
       std::move(from_the_end), "", "OneCallDrawsLikeItsTriangles"},
  };
}

}  // namespace

extern constinit const MutantTable kFreeVariants{MutantKind::kLegal, 7, FreeVariants};
extern constinit const MutantTable kFreeMutants{MutantKind::kPlanted, 14, FreeMutants};

}  // namespace rasterproof::subjects::mutants
