// What the wrong draws have in common.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "props/cause/cause.h"

namespace rasterproof::props {
namespace {

template <class Holds>
bool AnyVertex(const Scene& scene, const Holds& holds) {
  return std::ranges::any_of(scene.vertices, holds);
}

template <class Holds>
bool AnyTriangle(const Scene& scene, const Holds& holds) {
  return std::ranges::any_of(scene.triangles,
                             [&](const Triangle& t) { return holds(Corners(scene, t)); });
}

double DoubleArea(const std::array<Vertex, 3>& v) {
  return (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x);
}

bool HasEdge(const Scene& scene, double Vertex::* level) {
  return AnyTriangle(scene, [&](const std::array<Vertex, 3>& v) {
    return v[0].*level == v[1].*level || v[1].*level == v[2].*level || v[2].*level == v[0].*level;
  });
}

template <int power>
bool IsBeyond(const Scene& scene) {
  constexpr double kLimit = std::int64_t{1} << power;
  return AnyVertex(
      scene, [](const Vertex& v) { return std::max(std::fabs(v.x), std::fabs(v.y)) > kLimit; });
}

struct Trait {
  std::string_view words;
  bool (*has)(const Scene&);
};
constexpr auto kTraits = std::to_array<Trait>({
    {"x < 0", [](const Scene& s) { return AnyVertex(s, [](const Vertex& v) { return v.x < 0; }); }},
    {"y < 0", [](const Scene& s) { return AnyVertex(s, [](const Vertex& v) { return v.y < 0; }); }},
    {"coordinates beyond 16384", IsBeyond<14>},
    {"coordinates beyond 4096", IsBeyond<12>},
    {"coordinates beyond 1024", IsBeyond<10>},
    {"coordinates beyond 128", IsBeyond<7>},
    {"a horizontal edge", [](const Scene& s) { return HasEdge(s, &Vertex::y); }},
    {"a vertical edge", [](const Scene& s) { return HasEdge(s, &Vertex::x); }},
    {"meshes of 2 or more triangles", [](const Scene& s) { return s.triangles.size() > 1; }},
    {"more than 64 triangles", [](const Scene& s) { return s.triangles.size() > 64; }},
    {"negative area",
     [](const Scene& s) {
       return AnyTriangle(s, [](const auto& v) { return DoubleArea(v) < 0; });
     }},
    {"positive area",
     [](const Scene& s) {
       return AnyTriangle(s, [](const auto& v) { return DoubleArea(v) > 0; });
     }},
    {"less than half a square pixel of area",
     [](const Scene& s) {
       return AnyTriangle(s, [](const auto& v) { return std::fabs(DoubleArea(v)) < 1; });
     }},
    {"coordinates between multiples of 1/256",
     [](const Scene& s) {
       const auto between = [](double x) { return x * 256 != std::floor(x * 256); };
       return AnyVertex(s, [&](const Vertex& v) { return between(v.x) || between(v.y); });
     }},
    {"a vertex behind the eye",
     [](const Scene& s) { return AnyVertex(s, [](const Vertex& v) { return v.w <= 0; }); }},
    {"a coordinate that is not finite",
     [](const Scene& s) { return AnyVertex(s, [](const Vertex& v) { return !IsFinite(v); }); }},
    {"targets wider than 8 pixels", [](const Scene& s) { return s.width > 8; }},
    {"targets of more than 64 pixels a side",
     [](const Scene& s) { return std::max(s.width, s.height) > 64; }},
});

bool Has(const Observation& o, const Trait& trait) {
  return std::ranges::any_of(o.check.questions.draws,
                             [&](const DrawQuestion& q) { return trait.has(*q.job.scene); });
}

}  // namespace

std::vector<std::string> OnlyWith(std::span<const Observation> observations) {
  constexpr double kMostOfRight = 0.5;  // share of the right draws that may have it, too
  constexpr std::size_t kMostTraits = 2;
  std::vector<std::pair<double, std::string_view>> traits;
  for (const Trait& trait : kTraits) {
    std::size_t right = 0, shared = 0, wrong = 0;
    bool all = true;
    for (const Observation& o : observations) {
      if (!o.is_modelled) continue;
      const bool has = Has(o, trait);
      if (o.is_wrong) {
        ++wrong;
        all = all && has;
      } else {
        ++right;
        shared += has ? 1 : 0;
      }
    }
    if (!all || wrong == 0 || right == 0) continue;
    const double share = static_cast<double>(shared) / static_cast<double>(right);
    if (share <= kMostOfRight) traits.emplace_back(share, trait.words);
  }
  std::ranges::sort(traits);
  std::vector<std::string> words;
  for (const auto& [share, text] : traits) {
    if (words.size() < kMostTraits) words.emplace_back(text);
  }
  return words;
}

}  // namespace rasterproof::props
