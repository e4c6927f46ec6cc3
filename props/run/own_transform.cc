#include "props/run/own_transform.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "model/transform.h"

namespace rasterproof::props {
namespace {

// A place by its bits: NaN is a place as well, and -0 is not +0.
using PlaceBits = std::array<std::uint64_t, 2>;

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
  std::map<PlaceBits, Vertex> clip_of;
  for (Vertex& v : scene.vertices) {
    const auto [found, is_new] = clip_of.try_emplace(PlaceOf(v));
    if (is_new) {
      found->second = Rounded(
          ToClip(v, DrawW(bits), *info.profile.transform, scene.width, scene.height), info.input);
    }
    const double z = v.z;
    v = found->second;
    v.z = z;
  }
  scene.clip_space = true;
  scene.precision = info.input;
  window.profile = info.profile;
  return window;
}

Case SeenCase(const Case& c) {
  if (!c.profile.transform || !c.scene.clip_space) return c;
  Case seen = c;
  seen.scene = ToWindow(c.scene, *c.profile.transform);
  seen.profile.transform.reset();
  return seen;
}

}  // namespace rasterproof::props
