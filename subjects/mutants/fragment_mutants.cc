// Barycentrics and depths of fragments: whose corners they belong to, what is asked for, how small
// a triangle is. Sound ones in float32 by each of the usual forms, and bugs just outside.
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/subject_info.h"
#include "subjects/mutants/centroids.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

using Places = std::array<Point2, 3>;
using Shown = std::function<void(ShownFragment&)>;
using Float3 = std::array<float, 3>;

CentroidStages Showing(BarycentricsOf of, Shown shown) {
  CentroidStages stages;
  stages.base.profile.name = "fragments";
  stages.barycentrics_of = of;
  stages.shown = std::move(shown);
  stages.shows_centroids = false;
  return stages;
}

CentroidStages Under(std::string_view preset, BarycentricsOf of, Shown shown) {
  CentroidStages stages = Showing(of, std::move(shown));
  stages.base = StagesOfPreset(preset);
  return stages;
}

float EdgeValue32(Point2 a, Point2 b, Point2 p) {
  const auto ax = static_cast<float>(a.x), ay = static_cast<float>(a.y);
  const float first = (static_cast<float>(p.x) - ax) * (static_cast<float>(b.y) - ay);
  const float second = (static_cast<float>(p.y) - ay) * (static_cast<float>(b.x) - ax);
  return first - second;
}

Float3 Edges32(const Places& v, Point2 p) {
  return {EdgeValue32(v[1], v[2], p), EdgeValue32(v[2], v[0], p), EdgeValue32(v[0], v[1], p)};
}

Float3 OverTheArea(const Places& v, Point2 p) {
  const float area = EdgeValue32(v[0], v[1], v[2]);
  const Float3 e = Edges32(v, p);
  return {e[0] / area, e[1] / area, e[2] / area};
}

Float3 OverTheSum(const Places& v, Point2 p) {
  const Float3 e = Edges32(v, p);
  const float sum = e[0] + e[1] + e[2];
  return {e[0] / sum, e[1] / sum, e[2] / sum};
}

Float3 OneLessTheOthers(const Places& v, Point2 p) {
  const Float3 l = OverTheArea(v, p);
  return {l[0], l[1], 1 - l[0] - l[1]};
}

float DepthByBarycentrics(const Float3& l, const std::array<double, 3>& z) {
  return l[0] * static_cast<float>(z[0]) + l[1] * static_cast<float>(z[1]) +
         l[2] * static_cast<float>(z[2]);
}

float DepthByDeltas(const Float3& l, const std::array<double, 3>& z) {
  const auto from = static_cast<float>(z[0]);
  return from + l[1] * (static_cast<float>(z[1]) - from) + l[2] * (static_cast<float>(z[2]) - from);
}

// Where depth is all that is asked for it comes by the other way round.
void Take(ShownFragment& f, const Float3& l) {
  f.barycentrics = {l[0], l[1], l[2]};
  f.depth = f.wants.barycentrics ? DepthByBarycentrics(l, f.z) : DepthByDeltas(l, f.z);
}

bool IsOdd(const ShownFragment& f) { return (f.indices[0] + f.indices[1] + f.indices[2]) % 2 != 0; }

// Either is as good for who does not say.
void ByTriangle(ShownFragment& f) { Take(f, OverTheArea(IsOdd(f) ? f.placed : f.given, f.at)); }

double EdgeValueOf(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// As if twice the area were `area`.
void TakeOver(ShownFragment& f, const Places& v, double area) {
  f.barycentrics = {EdgeValueOf(v[1], v[2], f.at) / area, EdgeValueOf(v[2], v[0], f.at) / area,
                    EdgeValueOf(v[0], v[1], f.at) / area};
  f.depth = 0;
  for (std::size_t i = 0; i < 3; ++i) f.depth += f.barycentrics[i] * f.z[i];
}

void TakeOf(ShownFragment& f, const Places& v) { TakeOver(f, v, EdgeValueOf(v[0], v[1], v[2])); }

Places Middles(const Places& a, const Places& b) {
  Places middles;
  for (std::size_t k = 0; k < 3; ++k) {
    middles[k] = {(a[k].x + b[k].x) / 2, (a[k].y + b[k].y) / 2};
  }
  return middles;
}

bool IsDepthAlone(const ShownFragment& f) { return f.wants.depths && !f.wants.barycentrics; }
bool IsBarycentricsAlone(const ShownFragment& f) { return f.wants.barycentrics && !f.wants.depths; }

constexpr BarycentricsOf kGiven = BarycentricsOf::kGiven;
constexpr BarycentricsOf kSnapped = BarycentricsOf::kSnapped;
constexpr BarycentricsOf kEither = BarycentricsOf::kEither;

std::vector<Mutant> OfOtherCorners() {
  return {
      {"fragments-of-given",
       "barycentrics are of the corners as given, where the snapped are meant", "",
       Showing(kSnapped, [](ShownFragment& f) { TakeOf(f, f.given); }), "shown-values",
       "FragmentBarycentricsStayWithinTheirError"},
      {"fragments-of-snapped", "barycentrics are of the snapped corners, where the given are meant",
       "", Showing(kGiven, [](ShownFragment& f) { TakeOf(f, f.placed); }), "shown-values",
       "FragmentBarycentricsStayWithinTheirError"},
      {"fragments-of-neither", "barycentrics are of corners half way to the grid", "",
       Showing(kEither, [](ShownFragment& f) { TakeOf(f, Middles(f.given, f.placed)); }),
       "shown-values", "FragmentBarycentricsStayWithinTheirError"},
      {"fragments-small-areas", "areas below a 64th of a pixel are taken for that", "",
       Showing(kSnapped,
               [](ShownFragment& f) {
                 const double area = EdgeValueOf(f.placed[0], f.placed[1], f.placed[2]);
                 const double least = 2.0 / 64;
                 if (std::fabs(area) < least) TakeOver(f, f.placed, std::copysign(least, area));
               }),
       "shown-values", "FragmentBarycentricsSumToOne"},
      {"fragments-late-vertices-deep", "vertices from the 33rd on lie 2^-8 too deep", "",
       Showing(kSnapped,
               [](ShownFragment& f) {
                 for (std::size_t i = 0; i < 3; ++i) {
                   if (f.indices[i] >= 32) f.depth += f.barycentrics[i] * 0x1p-8;
                 }
               }),
       "shown-values", "FragmentDepthFollowsItsBarycentrics"},
  };
}

std::vector<Mutant> AskedAlone() {
  return {
      {"fragments-depth-alone-flat", "depth asked for alone is the first vertex's", "",
       Showing(kSnapped,
               [](ShownFragment& f) {
                 if (IsDepthAlone(f)) f.depth = f.z[0];
               }),
       "shown-values", "FragmentDepthFollowsItsBarycentrics"},
      {"fragments-depth-alone-of-given", "depth asked for alone is of the corners as given", "",
       Showing(kSnapped,
               [](ShownFragment& f) {
                 if (IsDepthAlone(f)) TakeOf(f, f.given);
               }),
       "shown-values", "FragmentDepthFollowsItsBarycentrics"},
      {"vulkan-fragments-depth-alone-off", "depth asked for alone is off by a quarter", "",
       Under("vulkan", kSnapped,
             [](ShownFragment& f) {
               if (IsDepthAlone(f)) f.depth *= 1.25;
             }),
       "shown-values", "FragmentDepthStaysInTheHull"},
      {"fragments-barycentrics-alone-rotated",
       "barycentrics asked for alone belong to the next vertex", "",
       Showing(kSnapped,
               [](ShownFragment& f) {
                 const std::array<double, 3> l = f.barycentrics;
                 if (IsBarycentricsAlone(f)) f.barycentrics = {l[1], l[2], l[0]};
               }),
       "shown-values", "FragmentBarycentricsStayWithinTheirError"},
  };
}

std::vector<Mutant> FragmentMutants() {
  std::vector<Mutant> table = OfOtherCorners();
  for (Mutant& planted : AskedAlone()) table.push_back(std::move(planted));
  return table;
}

std::vector<Mutant> FragmentVariants() {
  return {
      {"fragments-given-area", "barycentrics of the corners as given, over the area in float32", "",
       Showing(kGiven, [](ShownFragment& f) { Take(f, OverTheArea(f.given, f.at)); })},
      {"fragments-given-one-less", "the third barycentric is one less the others, in float32", "",
       Showing(kGiven, [](ShownFragment& f) { Take(f, OneLessTheOthers(f.given, f.at)); })},
      {"fragments-snapped-area", "barycentrics of the snapped corners, over the area in float32",
       "", Showing(kSnapped, [](ShownFragment& f) { Take(f, OverTheArea(f.placed, f.at)); })},
      {"fragments-snapped-sum", "barycentrics of the snapped corners, over their sum in float32",
       "", Showing(kSnapped, [](ShownFragment& f) { Take(f, OverTheSum(f.placed, f.at)); })},
      {"fragments-unstated-given", "barycentrics of the corners as given, and it does not say so",
       "", Showing(kEither, [](ShownFragment& f) { Take(f, OverTheSum(f.given, f.at)); })},
      {"fragments-unstated-snapped", "barycentrics of the snapped corners, and it does not say so",
       "", Showing(kEither, [](ShownFragment& f) { Take(f, OneLessTheOthers(f.placed, f.at)); })},
      {"fragments-unstated-by-triangle", "barycentrics of given or snapped corners, by triangle",
       "", Showing(kEither, ByTriangle)},
      {"vulkan-fragments-given", "barycentrics of the corners as given, in float32", "",
       Under("vulkan", kGiven, [](ShownFragment& f) { Take(f, OverTheArea(f.given, f.at)); })},
      {"vulkan-fragments-unstated", "barycentrics of given or snapped corners, by triangle", "",
       Under("vulkan", kEither, ByTriangle)},
      {"gl-fragments-unstated", "barycentrics of given corners, of snapped ones for depth alone",
       "",
       Under("gl", kEither,
             [](ShownFragment& f) {
               Take(f, OverTheSum(IsDepthAlone(f) ? f.placed : f.given, f.at));
             })},
  };
}

}  // namespace

extern constinit const MutantTable kFragmentMutants{MutantKind::kPlanted, 23, FragmentMutants};
extern constinit const MutantTable kFragmentVariants{MutantKind::kLegal, 15, FragmentVariants};

}  // namespace rasterproof::subjects::mutants
