#include "props/judging/moved_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "model/snap_scene.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// In larger cases the moves cost more than they show.
constexpr std::size_t kMostSamples = 4096;
constexpr std::size_t kMostTriangles = 16;

// The moves, from small to large. A length of 0 means the next number of the format.
struct MoveLength {
  double pixels = 0;
  const char* words = "";
};

std::array<MoveLength, 3> LengthsOf(const Profile& profile) {
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
bool StatesItsCoverage(const PlacedCase& c) {
  if (!WithinLimits(c.scene, c.profile) || !IsUnclipped(c.scene, c.profile) ||
      exact::WhyNotDecided(c)) {
    return false;
  }
  return c.profile.degenerate_triangles == DegenerateTriangles::kNothing || c.flat.empty();
}

}  // namespace

std::optional<std::string> WhyNotMoved(const PlacedCase& c) {
  if (c.scene.triangles.empty() || c.scene.triangles.size() > kMostTriangles ||
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.pattern.samples()) >
          kMostSamples) {
    return "the case has no triangle, or is large";
  }
  return std::nullopt;
}

MovedScenes::MovedScenes(const PlacedCase& c, const legal::Sight& sight)
    : c_(c), sight_(sight), expected_(c, sight, WholeTarget(c)) {}

std::vector<MovedScene> MovedScenes::ByOneVertex() const {
  std::vector<MovedScene> scenes;
  for (const MoveLength& length : LengthsOf(c_.profile)) {
    const Triangle& first = c_.scene.triangles.front();
    if (auto moved = FirstThatDiffers(first, length.pixels, length.words)) {
      scenes.push_back(*std::move(moved));
    }
  }
  return scenes;
}

std::optional<MovedScene> MovedScenes::BehindTheFirst() const {
  const Triangle& first = c_.scene.triangles.front();
  const auto behind = std::ranges::find_if(c_.scene.triangles, [&](const Triangle& t) {
    return std::ranges::none_of(t,
                                [&](std::int32_t v) { return std::ranges::count(first, v) != 0; });
  });
  if (behind == c_.scene.triangles.end()) return std::nullopt;
  for (const double pixels : {1.0, 4.0}) {
    if (auto moved = FirstThatDiffers(*behind, pixels, pixels == 1 ? "a pixel" : "four pixels")) {
      return moved;
    }
  }
  return std::nullopt;
}

std::optional<MovedScene> MovedScenes::FirstThatDiffers(const Triangle& triangle, double pixels,
                                                        const char* words) const {
  for (const std::int32_t index : triangle) {
    const auto vertex = static_cast<std::size_t>(index);
    for (double Vertex::* const axis : {&Vertex::x, &Vertex::y}) {
      for (const double sign : {1.0, -1.0}) {
        Scene moved = c_.scene;
        double& x = moved.vertices[vertex].*axis;
        x = MovedBy(x, pixels, sign, moved.precision);
        const std::string change = "vertex " + std::to_string(vertex) + " moved by " + words;
        if (auto scene = IfItDiffers(std::move(moved), change)) return scene;
      }
    }
  }
  return std::nullopt;
}

std::optional<MovedScene> MovedScenes::OtherContent() const {
  Scene exchanged = c_.scene;
  for (Vertex& v : exchanged.vertices) std::swap(v.x, v.y);
  if (auto scene = IfItDiffers(std::move(exchanged), "x and y of all vertices exchanged")) {
    return scene;
  }
  Scene reversed = c_.scene;
  reversed.vertices.assign(c_.scene.vertices.rbegin(), c_.scene.vertices.rend());
  return IfItDiffers(std::move(reversed), "its vertices in the reverse order");
}

std::optional<MovedScene> MovedScenes::IfItDiffers(Scene scene, const std::string& change) const {
  const PlacedCase moved = c_.With(scene);
  if (!StatesItsCoverage(moved)) return std::nullopt;
  legal::Allowed expected(moved, sight_, WholeTarget(c_));
  if (!expected.why_not().empty() || expected.Apart(expected_) == 0) return std::nullopt;
  return MovedScene{std::move(scene), std::move(expected), change};
}

}  // namespace rasterproof::props
