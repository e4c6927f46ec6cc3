#include "props/judging/freedom/place_ruler.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "model/snap_scene.h"
#include "props/judging/freedom/free_choices.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

constexpr int kWidestTarget = 64;
constexpr double kPart = 1.0 / kPlaceParts;

// From line `begin` of a pixel to line `end`.
struct Strip {
  int begin;
  int end;
};
using StripsOfAPixel = std::vector<Strip>;

// Bit `bit` of the reflected binary code of a part says whether a strip holds it: so strips of one
// drawing never touch within a pixel.
StripsOfAPixel StripsOf(int bit) {
  StripsOfAPixel strips;
  for (int part = 0; part < kPlaceParts; ++part) {
    const int code = part ^ (part >> 1);
    if (((code >> bit) & 1) == 0) continue;
    if (!strips.empty() && strips.back().end == part) {
      ++strips.back().end;
    } else {
      strips.push_back({part, part + 1});
    }
  }
  return strips;
}

Scene SceneOf(const PlacedCase& c, const StripsOfAPixel& of_a_pixel, bool along_rows) {
  Scene scene;
  scene.name = "place-ruler";
  scene.width = c.scene.width;
  scene.height = c.scene.height;
  scene.precision = c.scene.precision;
  const int pixels = along_rows ? scene.height : scene.width;
  const int length = along_rows ? scene.width : scene.height;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    for (const Strip& strip : of_a_pixel) {
      const double low = pixel + strip.begin * kPart;
      const double high = pixel + strip.end * kPart;
      const auto first = static_cast<std::int32_t>(scene.vertices.size());
      for (const Point2 at : {Point2{low, 0}, Point2{low, static_cast<double>(length)},
                              Point2{high, static_cast<double>(length)}, Point2{high, 0}}) {
        scene.vertices.push_back(along_rows ? Vertex{at.y, at.x} : Vertex{at.x, at.y});
      }
      scene.triangles.push_back({first, first + 1, first + 2});
      scene.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return scene;
}

// No legal model moves or clips any of it.
bool IsDrawnAsGiven(const PlacedCase& c) {
  return WithinLimits(c.scene, c.profile) && IsUnclipped(c.scene, c.profile) &&
         std::ranges::all_of(c.scene.triangles,
                             [&](const Triangle& t) { return StaysWhereGiven(c, t); });
}

}  // namespace

PlaceRuler PlaceRulerFor(const PlacedCase& c) {
  PlaceRuler ruler;
  if (c.before || c.profile.fixed || c.scene.clip_space ||
      std::max(c.scene.width, c.scene.height) > kWidestTarget) {
    return ruler;
  }
  for (const bool along_rows : {false, true}) {
    for (int bit = 0; (1 << bit) < kPlaceParts; ++bit) {
      const StripsOfAPixel of_a_pixel = StripsOf(bit);
      PlaceRuler::Strips strips{.scene = SceneOf(c, of_a_pixel, along_rows),
                                .along_rows = along_rows};
      if (!IsDrawnAsGiven(c.With(strips.scene))) return {};
      for (const Strip& strip : of_a_pixel) {
        // The last line of a pixel is the first of the next.
        if (strip.end == kPlaceParts) strips.within |= 1;
        for (int place = 2 * strip.begin; place <= 2 * strip.end; ++place) {
          const PlacesLeft::Set here = PlacesLeft::Set{1} << place;
          strips.within |= here;
          if (place != 2 * strip.begin && place != 2 * strip.end) strips.inside |= here;
        }
      }
      ruler.strips.push_back(std::move(strips));
    }
  }
  return ruler;
}

void PlacesLeft::See(const PlaceRuler::Strips& strips, bool covered) {
  left_[strips.along_rows ? 1 : 0] &= covered ? strips.within : ~strips.inside;
}

std::pair<Point2, Point2> PlacesLeft::Box() const {
  std::pair<Point2, Point2> box;
  for (const std::size_t axis : {0U, 1U}) {
    const int least = std::countr_zero(left_[axis]);
    const int most = static_cast<int>(std::bit_width(left_[axis])) - 1;
    const int low = least / 2;
    const int high = (most + 1) / 2;
    (axis == 0 ? box.first.x : box.first.y) = low * kPart;
    (axis == 0 ? box.second.x : box.second.y) = high * kPart;
  }
  return box;
}

}  // namespace rasterproof::props
