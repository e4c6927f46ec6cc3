#include "tool/survey/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "core/case.h"
#include "core/snap.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "props/domains/bit_source.h"
#include "props/domains/recipes.h"

namespace rasterproof::tool {
namespace {

using props::PhiloxSource;

// Every family draws from a sequence of its own.
enum class Salt : std::uint64_t {
  kFitting = 0x7375727665790000,
  kUniform,
  kLattice,
  kNearEdge,
  kMixed,
  kFarNegative,
  kNearLimits,
  kDegenerate,
  kWide,
  kTall,
  kRectangles,
  kCover,
  kCoverOff,
  kCoverFar,
  kCoverWide
};

// What a recipe draws with: bits, the model it must keep to, and rounding to the input's format.
class Pen {
 public:
  Pen(Salt salt, std::uint64_t index, const Profile& model, Precision precision)
      : bits_(static_cast<std::uint64_t>(salt), index), model_(model), precision_(precision) {}

  double limit() const { return model_.coordinate_limit; }
  int Int(int low, int high) { return static_cast<int>(bits_.Int(low, high)); }
  bool Chance(int of_256) { return bits_.Chance(of_256); }
  double Real(double low, double high) {
    const double unit = static_cast<double>(bits_.Bits(53)) * 0x1p-53;
    return Held(low + unit * (high - low));
  }
  /// +-2^u, u uniform.
  double Magnitude(double low_exponent, double high_exponent) {
    const double size = std::exp2(Real(low_exponent, high_exponent));
    return Held(Chance(128) ? size : -size);
  }
  double LogLimit() const { return std::log2(limit()); }
  /// A value that the input's format holds, within the limit.
  double Held(double x) const {
    const double inside = std::clamp(x, -limit(), limit());
    return precision_ == Precision::kFloat32 ? double{static_cast<float>(inside)} : inside;
  }
  double OnLattice(double x) const {
    const int bits = model_.snap.IsNone() ? 4 : std::min(model_.snap.bits, 8);
    return Held(SnapCoordinate(x, {bits, SnapRule::kNearestEven}));
  }
  /// The next value of the input's format, `steps` steps on.
  double Nudged(double x, int steps) const {
    const double toward = steps < 0 ? -INFINITY : INFINITY;
    for (int k = 0; k < std::abs(steps); ++k) {
      x = precision_ == Precision::kFloat32
              ? double{std::nextafter(static_cast<float>(x), static_cast<float>(toward))}
              : std::nextafter(x, toward);
    }
    return Held(x);
  }
  Scene Target(int width, int height) const {
    Scene scene;
    scene.width = width;
    scene.height = height;
    scene.precision = precision_;
    return scene;
  }

 private:
  PhiloxSource bits_;
  const Profile& model_;
  Precision precision_;
};

void AddTriangle(Scene& scene, const std::array<Point2, 3>& corners) {
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  for (const Point2& p : corners) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles.push_back({first, first + 1, first + 2});
}

int Side(Pen& pen) {
  constexpr std::array<int, 6> kSides{8, 16, 24, 32, 48, 64};
  return kSides[static_cast<std::size_t>(pen.Int(0, 5))];
}

// `count` triangles, each corner from `corner(pen, scene)`.
template <class Corner>
Scene Singles(Pen pen, int width, int height, int count, Corner corner) {
  Scene scene = pen.Target(width, height);
  for (int t = 0; t < count; ++t) {
    const Point2 a = corner(pen, scene);
    const Point2 b = corner(pen, scene);
    const Point2 c = corner(pen, scene);
    AddTriangle(scene, {a, b, c});
  }
  return scene;
}

Point2 Uniform(Pen& pen, const Scene& scene) {
  const double x = pen.Real(-0.25 * scene.width, 1.25 * scene.width);
  return {x, pen.Real(-0.25 * scene.height, 1.25 * scene.height)};
}

Scene DrawUniform(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kUniform, index, model, precision);
  const int side = Side(pen);
  return Singles(pen, side, side, 1, Uniform);
}

Scene DrawLattice(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kLattice, index, model, precision);
  const int side = Side(pen);
  const double steps = std::exp2(pen.Int(0, 4));
  return Singles(pen, side, side, 1, [steps](Pen& p, const Scene& scene) {
    const Point2 at = Uniform(p, scene);
    const double x = p.OnLattice(std::nearbyint(at.x * steps) / steps);
    return Point2{x, p.OnLattice(std::nearbyint(at.y * steps) / steps)};
  });
}

// An edge through a sample along a short lattice vector, its ends off by a few ulps.
Scene NearEdge(std::uint64_t index, const Profile& model, Precision precision, int side) {
  Pen pen(Salt::kNearEdge, index, model, precision);
  Scene scene = pen.Target(side, side);
  const Point2 sample = model.lattice.At(pen.Int(0, side - 1), pen.Int(0, side - 1));
  const double dx = pen.Int(-32, 32) / 8.0;
  const double dy = pen.Int(-32, 32) / 8.0;
  const int before = pen.Int(1, 4);
  const int after = pen.Int(1, 4);
  const double coarse = pen.Chance(128) ? std::exp2(-pen.Int(6, 20)) : 0;
  const auto nudged = [&pen, coarse](double x) {
    const int steps = pen.Int(-2, 2);
    return coarse == 0 ? pen.Nudged(pen.Held(x), steps) : pen.Held(x + steps * coarse);
  };
  const double ax = nudged(sample.x - before * dx);
  const double ay = nudged(sample.y - before * dy);
  const double bx = nudged(sample.x + after * dx);
  const double by = nudged(sample.y + after * dy);
  AddTriangle(scene, {Point2{ax, ay}, Point2{bx, by}, Uniform(pen, scene)});
  return scene;
}

Scene DrawNearEdge(std::uint64_t index, const Profile& model, Precision precision) {
  constexpr std::array<int, 4> kSides{8, 16, 32, 64};
  return NearEdge(index, model, precision, kSides[index % 4]);
}

Scene DrawMixed(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kMixed, index, model, precision);
  const int side = Side(pen);
  return Singles(pen, side, side, 1, [](Pen& p, const Scene& scene) {
    const double low = p.Chance(64) ? -20 : 0;
    const double x = p.Chance(64) ? p.Real(0, scene.width) : p.Magnitude(low, p.LogLimit());
    return Point2{x, p.Chance(64) ? p.Real(0, scene.height) : p.Magnitude(low, p.LogLimit())};
  });
}

Scene DrawNearLimits(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kNearLimits, index, model, precision);
  const int side = Side(pen);
  return Singles(pen, side, side, 1, [](Pen& p, const Scene& scene) {
    const auto one = [&p](int size) {
      if (p.Chance(80)) return p.Real(0, size);
      const double end = p.limit() - (p.Chance(64) ? 0 : p.Real(0, p.limit() / 4));
      return p.Held(p.Chance(128) ? end : -end);
    };
    const double x = one(scene.width);
    return Point2{x, one(scene.height)};
  });
}

// Two corners free; the third on their line, on one of them, or a few steps beside it.
Scene DrawDegenerate(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kDegenerate, index, model, precision);
  const int side = Side(pen);
  Scene scene = pen.Target(side, side);
  Point2 a = Uniform(pen, scene);
  Point2 b = Uniform(pen, scene);
  if (pen.Chance(128)) {
    a = {pen.OnLattice(a.x), pen.OnLattice(a.y)};
    b = {pen.OnLattice(b.x), pen.OnLattice(b.y)};
  }
  const int kind = pen.Int(0, 3);
  const double share = kind == 0 ? 0 : pen.Int(-4, 8) / 4.0;
  Point2 c{pen.Held(a.x + share * (b.x - a.x)), pen.Held(a.y + share * (b.y - a.y))};
  if (kind == 2) c = {pen.Nudged(c.x, pen.Int(-3, 3)), pen.Nudged(c.y, pen.Int(-3, 3))};
  if (kind == 3) c.y = pen.Held(c.y + pen.Magnitude(-9, -3));
  AddTriangle(scene, {a, b, c});
  return scene;
}

Scene DrawWide(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kWide, index, model, precision);
  const int width = 1 << pen.Int(9, 12);
  return Singles(pen, width, pen.Int(1, 8), 1, Uniform);
}

Scene DrawTall(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kTall, index, model, precision);
  const int height = 1 << pen.Int(9, 12);
  return Singles(pen, pen.Int(1, 8), height, 1, Uniform);
}

// Two triangles at once that are the halves of an upright rectangle, or look like them: the corners
// in any order, now and then one of them moved.
Scene DrawRectangles(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kRectangles, index, model, precision);
  const int side = Side(pen);
  Scene scene = pen.Target(side, side);
  const Point2 a = Uniform(pen, scene);
  const Point2 c = Uniform(pen, scene);
  std::array<Point2, 4> corners{a, {c.x, a.y}, c, {a.x, c.y}};
  for (Point2& p : corners) scene.vertices.push_back({p.x, p.y, 0, 1});
  if (pen.Chance(64)) {
    Vertex& moved = scene.vertices[static_cast<std::size_t>(pen.Int(0, 3))];
    moved.x = pen.Held(moved.x + pen.Real(-4, 4));
  }
  for (int t = 0; t < 2; ++t) {
    const int apart = pen.Chance(192) ? pen.Int(0, 3) : -1;  // the corner that is left out
    Triangle triangle{pen.Int(0, 3), pen.Int(0, 3), pen.Int(0, 3)};
    if (apart >= 0) triangle = {(apart + 1) % 4, (apart + 2) % 4, (apart + 3) % 4};
    std::rotate(triangle.begin(), triangle.begin() + pen.Int(0, 2), triangle.end());
    if (pen.Chance(64)) std::swap(triangle[0], triangle[1]);
    scene.triangles.push_back(triangle);
  }
  return scene;
}

// --- Subdivisions of a polygon that contains the target ---

std::array<Point2, 3> Snapped(const Scene& scene, const Triangle& t, const Profile& model) {
  std::array<Point2, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& v = scene.vertices[static_cast<std::size_t>(t[k])];
    corners[k] = {SnapCoordinate(v.x, model.snap), SnapCoordinate(v.y, model.snap)};
  }
  return corners;
}

// Whether the three triangles that `vertex` makes of `t` turn as `t` does, before and after
// snapping.
bool Splits(const Scene& scene, const Triangle& t, std::int32_t vertex, const Profile& model) {
  const Profile unsnapped;
  for (const Profile* profile : {&unsnapped, &model}) {
    const int facing = exact::Facing(Snapped(scene, t, *profile));
    for (std::size_t k = 0; k < 3; ++k) {
      Triangle part = t;
      part[k] = vertex;
      if (facing == 0 || exact::Facing(Snapped(scene, part, *profile)) != facing) return false;
    }
  }
  return true;
}

void SplitSome(Scene& scene, Pen& pen, const Profile& model, bool on_lattice, int tries) {
  for (int n = 0; n < tries; ++n) {
    const auto which =
        static_cast<std::size_t>(pen.Int(0, static_cast<int>(scene.triangles.size()) - 1));
    const Triangle t = scene.triangles[which];
    double x = pen.Real(0, scene.width);
    double y = pen.Real(0, scene.height);
    if (on_lattice) x = pen.OnLattice(x), y = pen.OnLattice(y);
    const auto vertex = static_cast<std::int32_t>(scene.vertices.size());
    scene.vertices.push_back({x, y, 0, 1});
    if (!Splits(scene, t, vertex, model)) {
      scene.vertices.pop_back();
      continue;
    }
    scene.triangles[which] = {t[0], t[1], vertex};
    scene.triangles.push_back({t[1], t[2], vertex});
    scene.triangles.push_back({t[2], t[0], vertex});
  }
}

// A fan of four triangles around a hub in the target, the corners one in each outer quadrant: with
// the corners' sides of the target kept, it covers the target whatever they are. Then some splits.
Scene Cover(Pen pen, const Profile& model, int width, int height, bool on_lattice) {
  Scene scene = pen.Target(width, height);
  const auto beyond = [&pen, on_lattice] {
    const double size = 2 + std::fabs(pen.Magnitude(0, 6));
    return on_lattice ? std::nearbyint(size) : size;
  };
  const std::array<Point2, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const Point2& sign : signs) {
    const double x = pen.Held(sign.x < 0 ? -beyond() : width + beyond());
    const double y = pen.Held(sign.y < 0 ? -beyond() : height + beyond());
    scene.vertices.push_back({x, y, 0, 1});
  }
  double x = pen.Real(0.25 * width, 0.75 * width);
  double y = pen.Real(0.25 * height, 0.75 * height);
  if (on_lattice) x = pen.OnLattice(x), y = pen.OnLattice(y);
  scene.vertices.push_back({x, y, 0, 1});
  for (std::int32_t k = 0; k < 4; ++k) scene.triangles.push_back({k, (k + 1) % 4, 4});
  SplitSome(scene, pen, model, on_lattice, pen.Int(0, 12));
  for (Triangle& t : scene.triangles) {
    std::rotate(t.begin(), t.begin() + pen.Int(0, 2), t.end());
    if (pen.Chance(64)) std::swap(t[0], t[1]);
  }
  return scene;
}

Scene DrawCover(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kCover, index, model, precision);
  const int side = Side(pen);
  return Cover(pen, model, side, side, true);
}

Scene DrawCoverOff(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kCoverOff, index, model, precision);
  const int side = Side(pen);
  return Cover(pen, model, side, side, false);
}

Scene DrawCoverWide(std::uint64_t index, const Profile& model, Precision precision) {
  Pen pen(Salt::kCoverWide, index, model, precision);
  const int longer = 1 << pen.Int(8, 11);
  const int shorter = pen.Int(4, 16);
  const bool wide = pen.Chance(128);
  return Cover(pen, model, wide ? longer : shorter, wide ? shorter : longer, pen.Chance(128));
}

// The scenes of a domain that the catalogue draws from as well.
template <Salt salt, Case (*recipe)(props::BitSource&, const SubjectInfo&)>
Scene DrawRecipe(std::uint64_t index, const Profile& model, Precision precision) {
  PhiloxSource bits(static_cast<std::uint64_t>(salt), index);
  SubjectInfo info;
  info.profile = model;
  info.input = precision;
  return recipe(bits, info).scene;
}

constexpr auto kSingles = FamilyKind::kSingles;
constexpr auto kWhole = FamilyKind::kCover;
constexpr auto kIn = FamilyPlace::kInRange;
constexpr auto kNear = FamilyPlace::kNearLimits;
constexpr std::array<Family, 14> kFamilies{{
    {"uniform", kSingles, kIn, false, DrawUniform},
    {"on the lattice", kSingles, kIn, true, DrawLattice},
    {"near an edge", kSingles, kIn, false, DrawNearEdge},
    {"degenerate", kSingles, kIn, false, DrawDegenerate},
    {"wide target", kSingles, kIn, false, DrawWide},
    {"tall target", kSingles, kIn, false, DrawTall},
    {"rectangles", kSingles, kIn, false, DrawRectangles},
    {"mixed magnitudes", kSingles, kNear, false, DrawMixed},
    {"far negative corners", kSingles, kNear, true,
     DrawRecipe<Salt::kFarNegative, props::FarNegativeCorners>},
    {"near the limits", kSingles, kNear, false, DrawNearLimits},
    {"mesh on the lattice", kWhole, kIn, true, DrawCover},
    {"mesh off the lattice", kWhole, kIn, false, DrawCoverOff},
    {"mesh in a large target", kWhole, kIn, false, DrawCoverWide},
    {"mesh with far corners", kWhole, kNear, true,
     DrawRecipe<Salt::kCoverFar, props::CoveringFans>},
}};

}  // namespace

std::span<const Family> Families() { return kFamilies; }

Scene FittingScene(std::uint64_t index, Precision precision) {
  const Profile anywhere;
  if (index % 4 == 2) return NearEdge(index / 4, anywhere, precision, 16);
  Pen pen(Salt::kFitting, index, anywhere, precision);
  const double steps = std::exp2(pen.Int(0, 4));
  const bool on_lattice = index % 2 == 1;
  return Singles(pen, 16, 16, 1, [=](Pen& p, const Scene& scene) {
    const Point2 at = Uniform(p, scene);
    if (!on_lattice) return at;
    const double x = p.Held(std::nearbyint(at.x * steps) / steps);
    return Point2{x, p.Held(std::nearbyint(at.y * steps) / steps)};
  });
}

}  // namespace rasterproof::tool
