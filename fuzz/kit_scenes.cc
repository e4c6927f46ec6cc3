// The scenes of kit/hard_scenes.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/case.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/subject_info.h"
#include "core/suggestion.h"
#include "exact/edge.h"
#include "kit/hard_scenes.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/judging/witness.h"
#include "props/shrink/cost.h"
#include "props/shrink/passes.h"
#include "props/shrink/shrink.h"

namespace rasterproof::kit {
namespace {

constexpr std::uint64_t kHardSeed = 1;

SubjectInfo InfoOf(std::string_view profile) {
  const auto preset = PresetProfile(std::string(profile));
  if (!preset) {
    const std::vector<std::string_view> names(kPresetProfiles.begin(), kPresetProfiles.end());
    throw InputError("profile \"" + std::string(profile) + "\"", "there is no such preset",
                     Suggestion(profile, names) + "some are" + ListedNames(names));
  }
  SubjectInfo info;
  info.name = "yours";
  info.profile = *preset;
  info.takes_clip = false;
  return info;
}

bool DrawsFor(const props::Domain& domain, const SubjectInfo& info) {
  return !domain.clip && !domain.non_finite && props::Suits(domain, info);
}

// Of the sample's distance from the line, in double: which one is next is not decided exactly.
double OffBy(Point2 a, Point2 b, Point2 p) {
  const double e = (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
  return std::fabs(e) / std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-300);
}

std::string Quoted(double x) { return "\"" + props::HexText(x) + "\""; }

}  // namespace

std::vector<std::string_view> HardDomains(std::string_view profile) {
  const SubjectInfo info = InfoOf(profile);
  std::vector<std::string_view> names;
  for (const props::Domain& domain : props::Domains()) {
    if (DrawsFor(domain, info)) names.push_back(domain.name);
  }
  return names;
}

Scene DrawHardScene(std::string_view domain, std::string_view profile, std::uint64_t number) {
  const SubjectInfo info = InfoOf(profile);
  const props::Domain* const found = props::FindDomain(domain);
  if (found == nullptr || !DrawsFor(*found, info)) {
    const std::vector<std::string_view> names = HardDomains(profile);
    throw InputError(
        "domain \"" + std::string(domain) + "\"",
        "it draws no finite scenes of window space for profile " + std::string(profile),
        Suggestion(domain, names) + "these do:" + ListedNames(names));
  }
  props::PhiloxSource bits(kHardSeed, number);
  return found->draw(bits, info).scene;
}

std::vector<Scene> SimplerScenes(const Scene& scene) {
  Case c;
  c.scene = scene;
  std::vector<Scene> simpler;
  for (Case& candidate : props::ShrinkCandidates(c)) {
    if (!(candidate.scene == scene)) simpler.push_back(std::move(candidate.scene));
  }
  return simpler;
}

std::string SceneText(const Scene& scene) {
  std::string text = "{\"rasterproof_scene\": 1, \"width\": " + std::to_string(scene.width) +
                     ", \"height\": " + std::to_string(scene.height) + ", \"vertices\": [";
  for (std::size_t k = 0; k < scene.vertices.size(); ++k) {
    const Vertex& v = scene.vertices[k];
    text += (k == 0 ? "[" : ", [") + Quoted(v.x) + ", " + Quoted(v.y) + "]";
  }
  text += "], \"triangles\": [";
  for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
    const Triangle& t = scene.triangles[k];
    text += (k == 0 ? "[" : ", [") + std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " +
            std::to_string(t[2]) + "]";
  }
  return text + "]}";
}

EdgeSample DrawEdgeSample(std::string_view profile, std::uint64_t number) {
  const Scene scene = DrawHardScene("near-edge", profile, number);
  EdgeSample nearest;
  double least = INFINITY;
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = WindowPoint(v[k]);
      const Point2 b = WindowPoint(v[(k + 1) % 3]);
      for (int pixel = 0; pixel < scene.width * scene.height; ++pixel) {
        const int row = pixel / scene.width;
        const Point2 p{pixel % scene.width + 0.5, row + 0.5};
        const double off = a == b ? INFINITY : OffBy(a, b, p);
        if (off >= least) continue;
        least = off;
        nearest = {a, b, p};
      }
    }
  }
  return nearest;
}

std::vector<EdgeSample> SimplerEdgeSamples(const EdgeSample& from) {
  constexpr std::array<Point2 EdgeSample::*, 3> kPoints{&EdgeSample::a, &EdgeSample::b,
                                                        &EdgeSample::sample};
  std::vector<EdgeSample> simpler;
  const auto cost = [&](const EdgeSample& one) {
    std::uint64_t sum = 0;
    for (const auto point : kPoints) {
      sum += props::CoordinateCost((one.*point).x) + props::CoordinateCost((one.*point).y);
    }
    return sum;
  };
  // Together, which leaves a sample on its edge: moved by whole pixels, and the ends drawn in.
  const auto add = [&](const EdgeSample& one) {
    if (cost(one) < cost(from)) simpler.push_back(one);
  };
  const Point2 whole{std::floor(from.sample.x), std::floor(from.sample.y)};
  const auto minus = [](Point2 p, Point2 q) { return Point2{p.x - q.x, p.y - q.y}; };
  const auto drawn_in = [&](Point2 p, double by) {
    return Point2{from.sample.x + std::floor((p.x - from.sample.x) / by),
                  from.sample.y + std::floor((p.y - from.sample.y) / by)};
  };
  add({minus(from.a, whole), minus(from.b, whole), minus(from.sample, whole)});
  for (const double by : {64.0, 8.0, 2.0, 1.0}) {
    const Point2 a = drawn_in(from.a, by);
    // The sample in the middle, exactly.
    add({a, {2 * from.sample.x - a.x, 2 * from.sample.y - a.y}, from.sample});
    add({a, drawn_in(from.b, by), from.sample});
    add({drawn_in(from.a, by), from.b, from.sample});
    add({from.a, drawn_in(from.b, by), from.sample});
  }
  for (const auto point : kPoints) {
    for (double Point2::* const axis : {&Point2::x, &Point2::y}) {
      for (const double x : props::SimplerCoordinates(from.*point.*axis)) {
        if (props::CoordinateCost(x) >= props::CoordinateCost(from.*point.*axis)) continue;
        EdgeSample one = from;
        one.*point.*axis = x;
        simpler.push_back(one);
      }
    }
  }
  return simpler;
}

int ExactSign(const EdgeSample& at) { return exact::EdgeSign(at.a, at.b, at.sample); }

}  // namespace rasterproof::kit
