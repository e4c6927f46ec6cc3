#include "props/judging/values/centroid_queries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/attributes.h"
#include "exact/coverage.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/redraw.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// Polygons with rational corners cost some hundred microseconds each.
constexpr std::size_t kMostPartlyCovered = 8;
constexpr std::size_t kMostCovered = 11;

constexpr Outputs kCentroidsAlone{
    .primitive_ids = true, .barycentrics = false, .depths = false, .centroids = true};

// A triangle that is drawn alone.
struct CentroidTriangle {
  int number = 0;
  std::array<Point2, 3> owners;  // the corners that barycentrics belong to
  PrimitivePlanes primitive;
};

// A pixel of which some sample is covered.
struct CoveredPixel {
  std::size_t first = 0;  // index of its first sample
  std::vector<bool> covered;

  bool IsPartly() const { return std::ranges::count(covered, false) != 0; }
};

// The corner of least x and y.
Point2 CornerOf(const PlacedCase& c, int x, int row) {
  const Point2 sample = PlaceOf(c, x, row, 0).at;
  const Point2 location = c.profile.pattern.locations[0];
  return {sample.x - location.x, sample.y - location.y};
}

double RoundingOfAPoint(const SubjectInfo& info, const Scene& target) {
  if (info.fragments.barycentric_error > 0) return 0;
  const double u = info.input == Precision::kFloat32 ? 0x1p-24 : 0x1p-53;
  return u * std::max(target.width, target.height);
}

LegalPlaces Grown(const LegalPlaces& places, double by) {
  return {{places.low.x - by, places.low.y - by}, {places.high.x + by, places.high.y + by}};
}

std::vector<CentroidTriangle> TrianglesToJudge(const PlacedCase& c, const Description& subject) {
  const BarycentricsOf of = subject.info.fragments.barycentrics_of;
  const Scene& owners = of == BarycentricsOf::kSnapped ? c.placed : c.scene;
  std::vector<CentroidTriangle> triangles;
  for (const CornersPlace& place : SomeProperTriangles(c)) {
    const auto t = static_cast<std::size_t>(place.triangle);
    // Who does not say whose barycentrics it shows is judged where both are the same.
    if (of == BarycentricsOf::kEither && !StaysWhereGiven(c, c.scene.triangles[t])) continue;
    const auto legal = LegalPlacesOf(c, c.scene.triangles[t]);
    if (!legal) continue;
    CentroidTriangle triangle{place.triangle, {}, nullptr};
    const std::array<Vertex, 3> v = Corners(owners, owners.triangles[t]);
    for (std::size_t k = 0; k < 3; ++k) triangle.owners[k] = WindowPoint(v[k]);
    if (exact::Facing(triangle.owners) == 0) continue;
    triangle.primitive = PrimitiveOf(subject.info, c.scene, *legal);
    triangles.push_back(std::move(triangle));
  }
  return triangles;
}

// At most this many of them, evenly spread.
void Thin(std::vector<CoveredPixel>& pixels, std::size_t most) {
  const std::size_t stride = pixels.size() / most + 1;
  std::vector<CoveredPixel> kept;
  for (std::size_t k = 0; k < pixels.size(); k += stride) kept.push_back(std::move(pixels[k]));
  pixels = std::move(kept);
}

std::vector<CoveredPixel> SomePixels(const Drawing& drawing) {
  const auto samples = static_cast<std::size_t>(drawing.counts.samples);
  std::vector<CoveredPixel> partly;
  std::vector<CoveredPixel> wholly;
  for (std::size_t first = 0; first < drawing.primitive_ids.size(); first += samples) {
    CoveredPixel pixel{first, std::vector<bool>(samples)};
    for (std::size_t s = 0; s < samples; ++s) {
      pixel.covered[s] = drawing.primitive_ids[first + s] != kNoPrimitive;
    }
    if (std::ranges::count(pixel.covered, true) == 0) continue;
    (pixel.IsPartly() ? partly : wholly).push_back(std::move(pixel));
  }
  Thin(partly, kMostPartlyCovered);
  Thin(wholly, kMostCovered - partly.size());
  std::ranges::move(wholly, std::back_inserter(partly));
  return partly;
}

std::string WordsOf(const PlacedCase& c, Point2 at, const std::vector<bool>& covered) {
  const bool is_centre =
      c.profile.pattern.samples() == 1 || std::ranges::count(covered, false) == 0;
  return (is_centre ? "the pixel's centre, " : "the first covered sample, ") + HexText(at);
}

std::array<double, 3> TolerancesAt(const SubjectInfo& info, const CentroidFragment& fragment,
                                   Point2 corner) {
  if (!fragment.region.at) return BarycentricTolerancesInPixel(info, fragment.query.v, corner);
  BarycentricQuery there = fragment.query;
  there.place.at = *fragment.region.at;
  return BarycentricTolerances(info, there);
}

// The values that the samples of the pixel show, each once.
void AddFragments(const PlacedCase& c, const SubjectInfo& info, const CentroidTriangle& triangle,
                  const Drawing& drawing, const CoveredPixel& pixel,
                  std::vector<CentroidFragment>& fragments) {
  std::vector<std::array<double, 3>> seen;
  for (std::size_t s = 0; s < pixel.covered.size(); ++s) {
    const std::size_t k = pixel.first + s;
    if (!pixel.covered[s]) continue;
    const std::array<double, 3>& shown = drawing.centroids[k];
    if (std::ranges::find(seen, shown) != seen.end()) continue;
    seen.push_back(shown);
    const Witness at = WitnessAtIndex(drawing.counts, k);
    CentroidFragment fragment;
    fragment.query = {triangle.number, triangle.owners, PlaceOf(c, at.x, at.y, at.sample), true};
    fragment.region = RegionOf(c, triangle.primitive, fragment.query.place, pixel.covered);
    fragment.barycentrics = shown;
    fragment.tolerances = TolerancesAt(info, fragment, CornerOf(c, at.x, at.y));
    fragments.push_back(std::move(fragment));
  }
}

Distance DistanceFromPoint(const CentroidFragment& fragment, Point2 at) {
  const auto exact_there = *exact::Barycentrics(fragment.query.v, at);
  Distance worst;
  for (std::size_t i = 0; i < 3; ++i) {
    const Distance one =
        CompareWithExact(fragment.barycentrics[i], exact_there[i], fragment.tolerances[i]);
    worst = {worst.within && one.within, std::max(worst.ratio, one.ratio)};
  }
  return worst;
}

}  // namespace

std::optional<Point2> StatedCentroid(const PlacedCase& c, int x, int row,
                                     const std::vector<bool>& covered) {
  const bool is_whole = std::ranges::count(covered, false) == 0;
  const bool is_direct3d = c.profile.centroid == Centroid::kDirect3D;
  if (covered.size() == 1 || (is_direct3d && is_whole)) {
    const Point2 corner = CornerOf(c, x, row);
    return Point2{corner.x + 0.5, corner.y + 0.5};
  }
  if (!is_direct3d) return std::nullopt;
  const auto first = std::ranges::find(covered, true) - covered.begin();
  return PlaceOf(c, x, row, static_cast<int>(first)).at;
}

std::vector<bool> CoveredInPixel(const Drawing& drawing, std::size_t index) {
  const auto samples = static_cast<std::size_t>(drawing.counts.samples);
  std::vector<bool> covered(samples);
  for (std::size_t s = 0; s < samples; ++s)
    covered[s] = drawing.primitive_ids[index - index % samples + s] != kNoPrimitive;
  return covered;
}

PrimitivePlanes PrimitiveOf(const SubjectInfo& info, const Scene& target,
                            const std::array<LegalPlaces, 3>& places) {
  std::vector<Point2> corners;
  for (const LegalPlaces& place : places) {
    for (const Point2 p : CornersOf(Grown(place, RoundingOfAPoint(info, target)))) {
      if (std::ranges::find(corners, p) == corners.end()) corners.push_back(p);
    }
  }
  return std::make_shared<const std::vector<exact::HalfPlane>>(exact::HullOf(corners));
}

CentroidRegion RegionOf(const PlacedCase& c, const PrimitivePlanes& primitive,
                        const SamplePlace& place, const std::vector<bool>& covered) {
  const Point2 corner = CornerOf(c, place.x, place.row);
  CentroidRegion region{
      .at = StatedCentroid(c, place.x, place.row, covered),
      .low = corner,
      .high = {corner.x + 1, corner.y + 1},
      .primitive = primitive,
      .words = "a point of the triangle and of its pixel, from " + HexText(corner) + " on"};
  if (region.at) region.words = WordsOf(c, *region.at, covered);
  return region;
}

Distance DistanceFromRegion(const CentroidFragment& fragment) {
  if (!AreFinite(fragment.barycentrics)) return {false, 0};
  const CentroidRegion& region = fragment.region;
  if (region.at) return DistanceFromPoint(fragment, *region.at);
  std::array<exact::Rational, 3> low;
  std::array<exact::Rational, 3> high;
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = exact::Rational(fragment.barycentrics[i]) - exact::Rational(fragment.tolerances[i]);
    high[i] = exact::Rational(fragment.barycentrics[i]) + exact::Rational(fragment.tolerances[i]);
  }
  std::vector<exact::HalfPlane> planes = exact::WhereBarycentricsAre(fragment.query.v, low, high);
  planes.insert(planes.end(), region.primitive->begin(), region.primitive->end());
  return {exact::RectangleMeets(region.low, region.high, planes), 0};
}

bool HasAPoint(const CentroidRegion& region) {
  return region.at || exact::RectangleMeets(region.low, region.high, *region.primitive);
}

Checks AskCentroids(const PlacedCase& c, const Description& subject,
                    Verdict (*judge)(const std::vector<CentroidFragment>&)) {
  std::vector<CentroidTriangle> triangles = TrianglesToJudge(c, subject);
  if (triangles.empty()) return NotExercised("no triangle has an area, or all may be clipped");
  Questions questions;
  const DrawQuestion whole = WholeCallOf(c.scene, c.profile, c.options);
  for (const CentroidTriangle& triangle : triangles) {
    DrawQuestion& one = questions.draws.emplace_back(whole);
    one.job.triangles = {{c.scene.triangles[static_cast<std::size_t>(triangle.number)]}};
    one.job.wants = kCentroidsAlone;
  }
  return OneCheck(std::move(questions),
                  [&c, &subject, judge, triangles = std::move(triangles)](const Answers& answers) {
                    std::vector<CentroidFragment> fragments;
                    for (std::size_t k = 0; k < triangles.size(); ++k) {
                      const Drawing& drawing = *answers.draws[k];
                      for (const CoveredPixel& pixel : SomePixels(drawing)) {
                        AddFragments(c, subject.info, triangles[k], drawing, pixel, fragments);
                      }
                    }
                    return judge(fragments);
                  });
}

}  // namespace rasterproof::props
