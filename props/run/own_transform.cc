#include "props/run/own_transform.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "model/transform.h"
#include "props/domains/bit_source.h"

namespace rasterproof::props {
namespace {

PlaceBits PlaceOf(const Vertex& v) {
  return {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y)};
}

// What the subject takes that is nearest to the vertex.
Vertex Rounded(Vertex v, Precision input) {
  if (input == Precision::kFloat64) return v;
  for (double* const x : {&v.x, &v.y, &v.w}) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    // What is infinite on purpose stays so, and nothing else becomes it.
    *x = static_cast<float>(std::isfinite(*x) ? std::clamp(*x, -kLargest, kLargest) : *x);
  }
  return v;
}

// A power of two, with which many divisions are exact, a place next to one, or any float of
// [1/16, 16).
double DrawW(BitSource& bits) {
  const double power = std::ldexp(1.0, static_cast<int>(bits.Int(-4, 3)));
  if (bits.Chance(96)) return power;
  if (bits.Chance(96)) {
    const double beside = std::ldexp(1.0, -static_cast<int>(bits.Int(2, 23)));
    return power * (bits.Chance(128) ? 1 + beside : 1 - beside);
  }
  return power * (1 + std::ldexp(static_cast<double>(bits.Bits(23)), -23));
}

// Where a map's coordinates round otherwise: one of its steps beside, now and then.
double Beside(double x, BitSource& bits) {
  if (!bits.Chance(64)) return x;
  return std::nextafter(x, bits.Chance(128) ? HUGE_VAL : -HUGE_VAL);
}

Vertex DrawGiven(const Vertex& window, const Scene& scene, const SubjectInfo& info,
                 BitSource& bits) {
  const Transform& transform = *info.profile.transform;
  const double w = transform.map ? 1 : DrawW(bits);
  Vertex given = Rounded(ToClip(window, w, transform, scene.width, scene.height), info.input);
  if (!transform.map) return given;
  given.x = Beside(given.x, bits);
  given.y = Beside(given.y, bits);
  return Rounded(given, info.input);
}

SubjectInfo SeenInfo(SubjectInfo info) {
  info.input = info.profile.transform->precision;
  info.takes_window = true;
  info.takes_clip = false;
  info.profile.transform.reset();
  return info;
}

}  // namespace

SubjectInfo AsSeenByRecipes(const SubjectInfo& info) {
  return OwnsTransform(info) ? SeenInfo(info) : info;
}

Case PutBehindTransform(Case window, const SubjectInfo& info, BitSource& bits) {
  if (!OwnsTransform(info)) return window;
  Scene& scene = window.scene;
  std::map<PlaceBits, Vertex> given_of;
  for (Vertex& v : scene.vertices) {
    const auto [found, is_new] = given_of.try_emplace(PlaceOf(v));
    if (is_new) found->second = DrawGiven(v, scene, info, bits);
    const double z = v.z;
    v = found->second;
    v.z = z;
  }
  scene.clip_space = !info.profile.transform->map;
  scene.precision = info.input;
  window.profile = info.profile;
  return window;
}

Case SeenCase(const Case& c) {
  if (!TakesToWindow(c.profile, c.scene)) return c;
  Case seen = c;
  seen.scene = ToWindow(c.scene, *c.profile.transform);
  seen.profile.transform.reset();
  return seen;
}

PlacesOfTransform::PlacesOfTransform(const Scene& given, const Scene& window)
    : width_(given.width),
      height_(given.height),
      precision_(given.precision),
      clip_space_(given.clip_space) {
  for (std::size_t k = 0; k < given.vertices.size(); ++k) {
    given_of_.emplace(PlaceOf(window.vertices[k]), given.vertices[k]);
  }
}

bool PlacesOfTransform::IsOfTheTarget(const Scene& window) const {
  return window.width == width_ && window.height == height_;
}

std::optional<Scene> PlacesOfTransform::AsGiven(const Scene& window) const {
  if (!IsOfTheTarget(window)) return std::nullopt;
  Scene given = window;
  given.clip_space = clip_space_;
  given.precision = precision_;
  for (Vertex& v : given.vertices) {
    const auto found = given_of_.find(PlaceOf(v));
    if (found == given_of_.end()) return std::nullopt;
    const double z = v.z;
    v = found->second;
    v.z = z;
  }
  return given;
}

std::string PlacesOfTransform::WhyNot(const Scene& window) const {
  return IsOfTheTarget(window) ? "its transform takes no vertex to this place"
                               : "a viewport takes vertices elsewhere on this target";
}

}  // namespace rasterproof::props
