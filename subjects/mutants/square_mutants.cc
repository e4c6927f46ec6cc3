// Bugs in covering whole pixels, and rasterizers at the bounds of what profiles of squares allow.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "core/square_presets.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr Snap kEight{8, SnapRule::kNearestEven};

SquareStages SquaresOf(std::string_view preset, SquareStages stages) {
  stages.profile = *SquarePreset(preset);
  return stages;
}

SquareStages SquaresOf(std::string_view preset) { return SquaresOf(preset, {}); }

double Left(const Points& v) { return std::min({v[0].x, v[1].x, v[2].x}); }
double Right(const Points& v) { return std::max({v[0].x, v[1].x, v[2].x}); }
double Top(const Points& v) { return std::min({v[0].y, v[1].y, v[2].y}); }
double Bottom(const Points& v) { return std::max({v[0].y, v[1].y, v[2].y}); }

double DoubledArea(const Points& v) {
  return (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
}

bool IsInOnePixel(const Points& v) {
  return std::floor(Left(v)) == std::floor(Right(v)) && std::floor(Top(v)) == std::floor(Bottom(v));
}

// Twice the area of a -> b and p: exact wherever squares and grid lines are at stake.
double SideOf(Point2 a, Point2 b, Point2 p) { return DoubledArea({a, b, p}); }

bool IsInside(const Points& v, Point2 p) {
  const double facing = DoubledArea(v) < 0 ? -1 : 1;
  return facing * SideOf(v[0], v[1], p) >= 0 && facing * SideOf(v[1], v[2], p) >= 0 &&
         facing * SideOf(v[2], v[0], p) >= 0;
}

// Met by nothing but a corner: beside the triangle's box along both axes.
bool LosesTouchedCorners(const SquareQuestion& q, bool sound) {
  const bool beside_x = Right(q.v) == q.low.x || Left(q.v) == q.high.x;
  const bool beside_y = Bottom(q.v) == q.low.y || Top(q.v) == q.high.y;
  return sound && !(beside_x && beside_y);
}

// An edge passes one of its corners, and the square lies beyond.
bool LosesCrossings(const SquareQuestion& q, bool sound) {
  const double facing = DoubledArea(q.v) < 0 ? -1 : 1;
  for (unsigned k = 0; k < 3; ++k) {
    double most = -1;
    for (const Point2& corner : CornersOf(q)) {
      most = std::max(most, facing * SideOf(q.v[k], q.v[(k + 1) % 3], corner));
    }
    if (most == 0) return false;
  }
  return sound;
}

// Only the three edges are asked, not the box: slivers reach far.
bool AsksEdgesOnly(const SquareQuestion& q, bool sound) {
  const double area = DoubledArea(q.v);
  if (area == 0) return sound;
  for (unsigned k = 0; k < 3; ++k) {
    const auto outside = [&](Point2 p) {
      return SideOf(q.v[k], q.v[(k + 1) % 3], p) * (area < 0 ? -1 : 1) < 0;
    };
    if (std::ranges::all_of(CornersOf(q), outside)) return false;
  }
  return true;
}

// What a corner in the triangle or a vertex in the square shows: an edge right across is missed.
bool AsksCornersOnly(const SquareQuestion& q, bool sound) {
  const auto in_square = [&](Point2 p) {
    return p.x >= q.low.x && p.x <= q.high.x && p.y >= q.low.y && p.y <= q.high.y;
  };
  return sound && (std::ranges::any_of(q.v, in_square) ||
                   std::ranges::any_of(CornersOf(q), [&](Point2 p) { return IsInside(q.v, p); }));
}

bool AsksTheCentre(const SquareQuestion& q, bool sound) {
  return sound && IsInside(q.v, {(q.low.x + q.high.x) / 2, (q.low.y + q.high.y) / 2});
}

bool TakesThreeCorners(const SquareQuestion& q, bool /*sound*/) {
  return DoubledArea(q.v) != 0 &&
         std::ranges::count_if(CornersOf(q), [&](Point2 p) { return IsInside(q.v, p); }) >= 3;
}

bool TakesTheBox(const SquareQuestion& q, bool /*sound*/) {
  return Left(q.v) <= q.high.x && Right(q.v) >= q.low.x && Top(q.v) <= q.high.y &&
         Bottom(q.v) >= q.low.y;
}

constexpr double kStep = kSquareStep;

std::vector<Mutant> SquareMutants() {
  return {
      {"squares-epsilon-inside", "a pixel that is met by less than 2^-20 pixel is left out", "",
       SquaresOf("voxel", {.half_width = -kStep}), "", "SquaresThatMustBeAreCovered"},
      {"squares-epsilon-outside", "a pixel that is missed by 2^-20 pixel is covered", "",
       SquaresOf("voxel", {.half_width = kStep}), "", "SquaresOutsideTheMayRegionStayFree"},
      {"squares-touched-corner-lost", "a pixel that is touched at a corner alone is left out", "",
       SquaresOf("voxel", {.instead = LosesTouchedCorners})},
      {"squares-crossing-lost", "an edge through the corner of a pixel does not meet it", "",
       SquaresOf("voxel", {.instead = LosesCrossings})},
      {"squares-open", "pixels and triangles are taken as open where closed ones are stated", "",
       SquaresOf("voxel", {.contact = Contact::kNone})},
      {"squares-half-open", "touched ceiling sides are left out where closed ones are stated", "",
       SquaresOf("voxel", {.contact = Contact::kFloor, .flat_contact = Contact::kFloor})},
      {"squares-half-open-swapped", "ceiling sides belong to pixels, floor sides don't", "",
       SquaresOf("pdf-fill", {.contact = Contact::kCeiling, .flat_contact = Contact::kCeiling})},
      {"squares-closed", "pixels are closed where half-open ones are stated", "",
       SquaresOf("pdf-fill", {.contact = Contact::kAny})},
      {"squares-flat-lost", "rectangles of no width or height paint nothing", "",
       SquaresOf("pdf-fill", {.contact = Contact::kNone, .draws_flat = false})},
      {"squares-thin-lost", "a thin triangle inside one pixel is lost", "",
       SquaresOf("voxel", {.drops =
                               [](const Points& v) {
                                 return IsInOnePixel(v) && std::fabs(DoubledArea(v)) < 0x1p-8;
                               }})},
      {"squares-band-doubled", "the uncertainty region is twice as wide as allowed", "",
       SquaresOf("d3d12-conservative-2", {.half_width = 0x1p-7, .placing = kEight})},
      {"squares-band-of-tier-1", "tier 1's uncertainty region is a pixel wide on every side", "",
       SquaresOf("d3d12-conservative-1", {.half_width = 1, .placing = kEight})},
      {"squares-band-just-beyond", "the uncertainty region is 1.875/256 pixel wide", "",
       SquaresOf("d3d12-conservative-2", {.half_width = 0x1p-8 + 0x1.cp-9, .placing = kEight})},
      {"squares-of-placed",
       "pixels are those that the snapped triangle overlaps, not the given one", "",
       SquaresOf("d3d12-conservative-2", {.contact = Contact::kNone, .placing = kEight})},
      {"squares-snapped-flat-lost", "triangles that snapping makes flat are dropped", "",
       SquaresOf("d3d12-conservative-2",
                 {.half_width = 0x1p-9, .placing = kEight, .draws_flat = false})},
      {"squares-slivers-reach-far", "slivers reach beyond their ends by as much as edges do", "",
       SquaresOf("d3d12-conservative-2",
                 {.half_width = 0x1p-8, .placing = kEight, .instead = AsksEdgesOnly})},
      {"squares-by-corners", "a pixel that an edge crosses between corners is left out", "",
       SquaresOf("gdal-all-touched", {.contact = Contact::kNone, .instead = AsksCornersOnly}), "",
       "MetSquaresIncludeCoveredCentres|SubdivisionLeavesNoSquareUntouched"},
      {"squares-by-centres", "a pixel is covered if its centre is", "",
       SquaresOf("vulkan-overestimate", {.instead = AsksTheCentre})},
      {"squares-box", "every pixel of the triangle's box is covered", "",
       SquaresOf("gdal-all-touched", {.instead = TakesTheBox})},
      {"squares-inner-of-placed", "inner coverage is that of the snapped triangle", "",
       SquaresOf("d3d12-inner", {.holds = true, .contact = Contact::kNone, .placing = kEight})},
      {"squares-inner-too-small", "inner coverage leaves out what is 1/64 pixel inside", "",
       SquaresOf("d3d12-inner", {.holds = true, .contact = Contact::kNone, .half_width = 0x1p-6})},
      {"squares-inner-touched", "a pixel that a side touches from within is inner", "",
       SquaresOf("d3d12-inner", {.holds = true})},
      {"squares-inner-by-three-corners", "a pixel with three corners inside lies inside", "",
       SquaresOf("vulkan-underestimate", {.holds = true, .instead = TakesThreeCorners}), "",
       "HeldSquaresHaveCoveredCentres"},
  };
}

std::vector<Mutant> SquareVariants() {
  const Snap four_down{4, SnapRule::kFloor};
  const Snap four_up{4, SnapRule::kNearestAway};
  return {
      {"squares-voxel", "a pixel is covered if the triangle touches it", "", SquaresOf("voxel")},
      {"squares-voxel-mask", "the same, as a mask", "",
       SquaresOf("voxel", {.coverage = CoverageKind::kMask})},
      {"squares-pdf-inside", "a pixel is painted if the insides meet, or a flat shape passes it",
       "", SquaresOf("pdf-fill", {.contact = Contact::kNone, .flat_contact = Contact::kFloor})},
      {"squares-pdf-boundary", "a pixel is painted if the boundary passes its half-open square", "",
       SquaresOf("pdf-fill", {.contact = Contact::kFloor, .flat_contact = Contact::kFloor})},
      {"squares-gdal-inside", "a pixel is burned if the insides meet", "",
       SquaresOf("gdal-all-touched", {.contact = Contact::kNone})},
      {"squares-gdal-least", "a pixel met by less than 0.01 pixel is not burned", "",
       SquaresOf("gdal-all-touched", {.contact = Contact::kNone, .half_width = -10486 * kStep})},
      {"squares-gdal-most", "a pixel missed by less than 0.01 pixel is burned", "",
       SquaresOf("gdal-all-touched", {.half_width = 10486 * kStep})},
      {"squares-tier-1-least", "no pixel more than the triangle as given overlaps", "",
       SquaresOf("d3d12-conservative-1", {.contact = Contact::kNone, .draws_flat = false})},
      {"squares-tier-1-most", "the whole uncertainty region, border contact and flat ones too", "",
       SquaresOf("d3d12-conservative-1", {.half_width = 0.5, .placing = kEight})},
      {"squares-tier-2-least", "no pixel more than the triangle as given overlaps, flat or not", "",
       SquaresOf("d3d12-conservative-2", {.contact = Contact::kNone})},
      {"squares-tier-2-minimum", "the smallest uncertainty region, 1/512 pixel", "",
       SquaresOf("d3d12-conservative-2", {.half_width = 0x1p-9, .placing = kEight})},
      {"squares-tier-2-most", "the largest uncertainty region, 1/256 pixel", "",
       SquaresOf("d3d12-conservative-2", {.half_width = 0x1p-8, .placing = kEight})},
      {"squares-tier-3-most", "the largest uncertainty region, snapped away from zero", "",
       SquaresOf("d3d12-conservative-3",
                 {.half_width = 0x1p-8, .placing = {8, SnapRule::kNearestAway}})},
      {"squares-inner-most", "every pixel inside the triangle as given", "",
       SquaresOf("d3d12-inner", {.holds = true, .contact = Contact::kNone})},
      {"squares-inner-least", "no pixel within 1/256 pixel of the snapped edge", "",
       SquaresOf(
           "d3d12-inner",
           {.holds = true, .contact = Contact::kNone, .half_width = 0x1p-8, .placing = kEight})},
      {"squares-overestimate-least", "snapped down to four bits, and no growth", "",
       SquaresOf("vulkan-overestimate", {.placing = four_down, .draws_flat = false})},
      {"squares-overestimate-grown", "grown by 3/4 pixel", "",
       SquaresOf("vulkan-overestimate", {.half_width = 0.75, .placing = kEight})},
      {"squares-overestimate-box", "grown to its box, as there is no bound", "",
       SquaresOf("vulkan-overestimate", {.instead = TakesTheBox})},
      {"squares-underestimate-most", "snapped to four bits", "",
       SquaresOf("vulkan-underestimate", {.holds = true, .placing = four_up})},
      {"squares-underestimate-less", "a pixel within 1/4 pixel of an edge is left out", "",
       SquaresOf("vulkan-underestimate", {.holds = true, .half_width = 0.25})},
  };
}

}  // namespace

extern constinit const MutantTable kSquareMutants{MutantKind::kPlanted, 15, SquareMutants};
extern constinit const MutantTable kSquareVariants{MutantKind::kLegal, 5, SquareVariants};

}  // namespace rasterproof::subjects::mutants
