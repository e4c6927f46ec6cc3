#include "tests/subjects/conformance_baseline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "model/transform.h"

namespace rasterproof {
namespace {

constexpr int kSide = 128;
constexpr double kFuzz = 3.0 / 256;

using Corners3 = std::array<Point2, 3>;

Scene SceneOf(const Subject& subject, int side) {
  Scene scene;
  scene.width = side;
  scene.height = side;
  scene.clip_space = !subject.Info().takes_window;
  return scene;
}

void Add(Scene& scene, const Corners3& corners) {
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  for (const Point2& p : corners) {
    scene.vertices.push_back({double{static_cast<float>(p.x)}, double{static_cast<float>(p.y)}});
  }
  scene.triangles.push_back({first, first + 1, first + 2});
}

CoverageCounts Drawn(Subject& subject, const Scene& scene) {
  CoverageCounts counts(scene.width, scene.height, subject.Info().profile.pattern.samples());
  Scene given = scene;
  if (const auto& transform = subject.Info().profile.transform; transform && transform->map) {
    for (Vertex& v : given.vertices) v = ToClip(v, 1, *transform, scene.width, scene.height);
    given.precision = Precision::kFloat64;
  }
  DrawOnto(subject, given, {}, counts);
  return counts;
}

Point2 PlaceOf(const Subject& subject, int side, int x, int row, int s) {
  const Profile& profile = subject.Info().profile;
  return profile.pattern.At(x, profile.y_axis == YAxis::kDown ? row : side - 1 - row, s);
}

// Distance to the nearest edge line, positive inside.
double Depth(const Corners3& v, Point2 p) {
  const auto edge = [](Point2 a, Point2 b, Point2 q) {
    return (q.x - a.x) * (b.y - a.y) - (q.y - a.y) * (b.x - a.x);
  };
  const double sign = edge(v[0], v[1], v[2]) > 0 ? 1 : -1;
  double least = 1e9;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = v[i];
    const Point2& b = v[(i + 1) % 3];
    least = std::min(least, sign * edge(a, b, p) / std::hypot(b.x - a.x, b.y - a.y));
  }
  return least;
}

// Wrong samples of one triangle, those within the fuzz of an edge left out.
int WrongSamples(Subject& subject, const Corners3& v) {
  Scene scene = SceneOf(subject, kSide);
  Add(scene, v);
  const CoverageCounts counts = Drawn(subject, scene);
  int wrong = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int x = 0; x < kSide; ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const double depth = Depth(v, PlaceOf(subject, kSide, x, row, s));
        if (std::fabs(depth) <= kFuzz) continue;
        wrong += (counts.Count(counts.Index(x, row, s)) != 0) != (depth > 0) ? 1 : 0;
      }
    }
  }
  return wrong;
}

using Quad = std::array<Point2, 4>;

Quad RotatedSquare(Point2 centre, double half, double angle) {
  Quad q;
  for (std::size_t k = 0; k < 4; ++k) {
    const double at = angle + static_cast<double>(k) * std::acos(0.0);
    q[k] = {centre.x + half * std::cos(at), centre.y + half * std::sin(at)};
  }
  return q;
}

// The two triangles of a square: samples covered twice, and inner ones not covered.
int WrongInQuad(Subject& subject, const Quad& q, bool reversed) {
  const Point2 centre{(q[0].x + q[2].x) / 2, (q[0].y + q[2].y) / 2};
  const double half = std::hypot(q[0].x - centre.x, q[0].y - centre.y);
  Scene scene = SceneOf(subject, kSide);
  Add(scene, {q[0], q[1], q[2]});
  if (reversed) {
    Add(scene, {q[0], q[3], q[2]});
  } else {
    Add(scene, {q[0], q[2], q[3]});
  }
  const CoverageCounts counts = Drawn(subject, scene);
  int wrong = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int x = 0; x < kSide; ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const Point2 p = PlaceOf(subject, kSide, x, row, s);
        const std::uint32_t count = counts.Count(counts.Index(x, row, s));
        // Well inside the quad: within the circle that its sides touch.
        const bool inner = std::hypot(p.x - centre.x, p.y - centre.y) < half / std::sqrt(2.0) - 1;
        wrong += count > 1 || (inner && count == 0) ? 1 : 0;
      }
    }
  }
  return wrong;
}

}  // namespace

Baseline CtsLike(Subject& subject) {
  const std::array<Corners3, 9> triangles{{{{{9.6, 9.6}, {118.4, 12.8}, {64, 115.2}}},
                                           {{{32, 25.6}, {35.2, 96}, {102.4, 57.6}}},
                                           {{{12.8, 121.6}, {118.4, 108.8}, {115.2, 118.4}}},
                                           {{{-12.8, 38.4}, {70.4, -6.4}, {83.2, 137.6}}},
                                           {{{64, 6.4}, {70.4, 121.6}, {60.8, 121.6}}},
                                           {{{6.4, 6.4}, {6.4, 121.6}, {121.6, 121.6}}},
                                           {{{44.8, 44.8}, {57.6, 51.2}, {48, 60.8}}},
                                           {{{121.6, 6.4}, {121.6, 19.2}, {6.4, 115.2}}},
                                           {{{19.2, 64}, {108.8, 57.6}, {64, 70.4}}}}};
  const int samples = subject.Info().profile.pattern.samples();
  const int allowed = samples == 1 ? 0 : 10;
  for (const Corners3& v : triangles) {
    if (WrongSamples(subject, v) > allowed) return Baseline::kFails;
  }
  std::mt19937 bits(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits()) / 4294967296.0;
  };
  // The whole target, its diagonal through samples; then ordinary quads, quads of both windings,
  // and quads that hang over the target.
  const Quad whole{{{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}};
  if (WrongInQuad(subject, whole, false) + WrongInQuad(subject, whole, true) > 0) {
    return Baseline::kFails;
  }
  for (int k = 0; k < 24; ++k) {
    const bool hangs_over = k % 3 == 2;
    const double x = hangs_over ? uniform(56, 72) : uniform(32, 96);
    const Point2 centre{x, hangs_over ? uniform(56, 72) : uniform(32, 96)};
    const double half = hangs_over ? uniform(70, 85) : uniform(12, 30);
    if (WrongInQuad(subject, RotatedSquare(centre, half, uniform(0, 3)), k % 3 == 1) > 0) {
      return Baseline::kFails;
    }
  }
  return Baseline::kPasses;
}

namespace {

// Which sides of a square with edges through samples own them, if that is a convention at all.
struct Convention {
  bool known = false;
  TieRule rule;
};

Convention Probe(Subject& subject) {
  constexpr int kProbe = 16;
  const Point2 at = PlaceOf(subject, kProbe, 2, 2, 0);
  const Point2 far = PlaceOf(subject, kProbe, 6, 6, 0);
  Scene scene = SceneOf(subject, kProbe);
  Add(scene, {{{at.x, at.y}, {far.x, at.y}, {far.x, far.y}}});
  Add(scene, {{{at.x, at.y}, {far.x, far.y}, {at.x, far.y}}});
  const CoverageCounts counts = Drawn(subject, scene);
  const auto count = [&](int x, int row) { return counts.Count(counts.Index(x, row)); };
  const bool left = count(2, 4) == 1;
  const bool right = count(6, 4) == 1;
  const bool top = count(4, 2) == 1;
  const bool bottom = count(4, 6) == 1;
  Convention convention;
  if (left == right || top == bottom || count(4, 4) != 1) return convention;
  convention.rule = {static_cast<std::int8_t>(left ? 1 : -1),
                     static_cast<std::int8_t>(top ? 1 : -1), false, false};
  convention.known = true;
  return convention;
}

// A triangle of a few subpixels around every sample of a small target must fill it.
bool DrawsEverySample(Subject& subject) {
  constexpr int kProbe = 16;
  constexpr double kReach = 2.5 / 256;
  Scene scene = SceneOf(subject, kProbe);
  for (int row = 0; row < kProbe; ++row) {
    for (int x = 0; x < kProbe; ++x) {
      const Point2 p = PlaceOf(subject, kProbe, x, row, 0);
      Add(scene,
          {{{p.x - kReach, p.y - kReach}, {p.x + kReach, p.y - kReach}, {p.x, p.y + kReach}}});
    }
  }
  const CoverageCounts counts = Drawn(subject, scene);
  for (int row = 0; row < kProbe; ++row) {
    for (int x = 0; x < kProbe; ++x) {
      if (counts.Count(counts.Index(x, row)) != 1) return false;
    }
  }
  return true;
}

}  // namespace

Baseline PiglitLike(Subject& subject) {
  const Convention convention = Probe(subject);
  if (!convention.known || !DrawsEverySample(subject)) return Baseline::kSkips;
  Profile profile = subject.Info().profile;
  profile.tie_rule = convention.rule;
  std::mt19937 bits(1);
  const auto place = [&] { return static_cast<double>(bits() % (kSide * 2)) / 2; };
  for (int k = 0; k < 200; ++k) {
    Corners3 v;
    for (Point2& p : v) {
      const double x = place();
      p = {x, place()};
    }
    Scene scene = SceneOf(subject, kSide);
    Add(scene, v);
    Profile placed = profile;  // the scene is the window's
    placed.transform.reset();
    const CoverageCounts expected = exact::Coverage(scene, scene.clip_space ? profile : placed);
    const CoverageCounts observed = Drawn(subject, scene);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if ((expected.Count(i) != 0) != (observed.Count(i) != 0)) return Baseline::kFails;
    }
  }
  return Baseline::kPasses;
}

}  // namespace rasterproof
