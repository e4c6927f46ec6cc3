// Suspects that give samples on edges to others, or compute edge values otherwise.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "exact/edge.h"
#include "props/cause/suspect.h"

namespace rasterproof::props {
namespace {

__extension__ using Wide = __int128;

// Of what is not a number: neither on the edge nor inside, and of no area.
constexpr int kNoSign = -2;

template <class Number>
int SignOf(Number n) {
  return n > 0 ? 1 : n < 0 ? -1 : n == 0 ? 0 : kNoSign;
}

bool IsLevel(const SuspectEdge& e) { return e.a.y == e.b.y; }
bool IsUpright(const SuspectEdge& e) { return e.a.x == e.b.x; }
bool IsSlanted(const SuspectEdge& e) { return !IsLevel(e) && !IsUpright(e); }

using OwnsEdge = bool (*)(const SuspectEdge&);

SuspectStages OwningBy(OwnsEdge owns) {
  return {.owns = [owns](const SuspectEdge& e, const SuspectTriangle&, const SuspectSample&) {
    return owns(e);
  }};
}

void AddRuleNames(const TieRule& stated, std::vector<Suspect>& list) {
  std::vector<TieRule> rules(kConsistentRules.begin(), kConsistentRules.end());
  rules.push_back({.inclusive = true});
  rules.push_back({.exclusive = true});
  for (const TieRule& rule : rules) {
    if (rule == stated) continue;
    const std::string what = rule.inclusive   ? "covers every sample on an edge (>= on all edges)"
                             : rule.exclusive ? "covers no sample on an edge (> on all edges)"
                                              : "follows the tie rule " + TieRuleName(rule);
    list.push_back(
        {"tie-rule", what, {.model = [rule](Profile& p, const Scene&) { p.tie_rule = rule; }}});
  }
}

void AddKindsOfEdges(std::vector<Suspect>& list) {
  const auto add = [&](const std::string& what, OwnsEdge owns) {
    list.push_back({"tie-rule", what, OwningBy(owns)});
  };
  add("covers samples on every vertical left edge",
      [](const SuspectEdge& e) { return e.owns || (IsUpright(e) && e.b.y > e.a.y); });
  add("covers samples on no vertical left edge",
      [](const SuspectEdge& e) { return e.owns && !(IsUpright(e) && e.b.y > e.a.y); });
  add("covers samples on every vertical right edge",
      [](const SuspectEdge& e) { return e.owns || (IsUpright(e) && e.b.y < e.a.y); });
  add("covers samples on every top edge",
      [](const SuspectEdge& e) { return e.owns || (IsLevel(e) && e.b.x < e.a.x); });
  add("covers samples on no top edge",
      [](const SuspectEdge& e) { return e.owns && !(IsLevel(e) && e.b.x < e.a.x); });
  add("covers samples on every bottom edge",
      [](const SuspectEdge& e) { return e.owns || (IsLevel(e) && e.b.x > e.a.x); });
  add("covers samples on every horizontal edge",
      [](const SuspectEdge& e) { return e.owns || IsLevel(e); });
  add("covers samples on no horizontal edge",
      [](const SuspectEdge& e) { return e.owns && !IsLevel(e); });
  add("covers samples on every vertical edge",
      [](const SuspectEdge& e) { return e.owns || IsUpright(e); });
  add("covers samples on no vertical edge",
      [](const SuspectEdge& e) { return e.owns && !IsUpright(e); });
  add("covers samples on every slanted edge",
      [](const SuspectEdge& e) { return e.owns || IsSlanted(e); });
  add("covers samples on no slanted edge",
      [](const SuspectEdge& e) { return e.owns && !IsSlanted(e); });
  add("exchanges the owner of samples on horizontal edges",
      [](const SuspectEdge& e) { return e.owns != IsLevel(e); });
  add("exchanges the owner of samples on vertical edges",
      [](const SuspectEdge& e) { return e.owns != IsUpright(e); });
  add("exchanges the owner of samples on edges that are not horizontal",
      [](const SuspectEdge& e) { return e.owns == IsLevel(e); });
  add("exchanges the owner of samples on edges that fall to the right",
      [](const SuspectEdge& e) { return e.owns != (e.b.x > e.a.x && e.b.y > e.a.y); });
  add("exchanges the owner of samples on edges that rise to the left",
      [](const SuspectEdge& e) { return e.owns != (e.b.x < e.a.x && e.b.y < e.a.y); });
  add("exchanges the owner of samples on edges of one slope",
      [](const SuspectEdge& e) { return e.owns != ((e.b.x > e.a.x) == (e.b.y > e.a.y)); });
}

void AddKindsOfTriangles(std::vector<Suspect>& list) {
  const auto add = [&](const std::string& what, auto owns) {
    list.push_back({"tie-rule", what, {.owns = owns}});
  };
  for (const bool front : {false, true}) {
    const std::string of = front ? " of front faces" : " of back faces";
    add("follows the opposite tie rule on edges" + of,
        [front](const SuspectEdge& e, const SuspectTriangle& t, const SuspectSample&) {
          return e.owns != (t.front == front);
        });
    for (const bool owns : {false, true}) {
      add(std::string(owns ? "covers every sample on edges" : "covers no sample on edges") + of,
          [front, owns](const SuspectEdge& e, const SuspectTriangle& t, const SuspectSample&) {
            return t.front == front ? owns : e.owns;
          });
    }
  }
  for (int k = 0; k < 3; ++k) {
    const std::string of = " on the edge opposite vertex " + std::to_string(k);
    for (const bool owns : {false, true}) {
      add((owns ? "covers every sample" : "covers no sample") + of,
          [k, owns](const SuspectEdge& e, const SuspectTriangle&, const SuspectSample&) {
            return e.opposite == k ? owns : e.owns;
          });
    }
  }
  for (const bool larger : {false, true}) {
    add(std::string("gives a sample on an edge to the triangle that walks it to the ") +
            (larger ? "larger" : "smaller") + " vertex number",
        [larger](const SuspectEdge& e, const SuspectTriangle& t, const SuspectSample&) {
          const auto i = static_cast<std::size_t>(e.opposite);
          const bool grows = t.indices[(i + 1) % 3] < t.indices[(i + 2) % 3];
          return grows == larger;
        });
  }
  add("decides which edges own their samples before it snaps",
      [](const SuspectEdge& e, const SuspectTriangle& t, const SuspectSample&) {
        const auto i = static_cast<std::size_t>(e.opposite);
        const Vertex& a = t.given[(i + 1) % 3];
        const Vertex& b = t.given[(i + 2) % 3];
        return b.y > a.y || (b.y == a.y && b.x < a.x);
      });
  for (const int side : {4, 8, 16, 32}) {
    for (const int odd : {0, 1}) {
      add("follows the opposite tie rule in every other tile of " + std::to_string(side) +
              " pixels",
          [side, odd](const SuspectEdge& e, const SuspectTriangle&, const SuspectSample& s) {
            return e.owns != ((s.x / side + s.row / side) % 2 == odd);
          });
    }
  }
}

// An edge and a sample in steps of the grid that holds both.
struct InSteps {
  std::int64_t dx, dy;  // of the edge
  std::int64_t px, py;  // of the sample from its first end
  Wide Value() const { return Wide{px} * dy - Wide{py} * dx; }
};

InSteps StepsOf(const SuspectEdge& e, const SuspectSample& s, double scale) {
  const auto steps = [scale](double x) {
    return static_cast<std::int64_t>(std::clamp(x * scale, -0x1p61, 0x1p61));
  };
  return {steps(e.b.x - e.a.x), steps(e.b.y - e.a.y), steps(s.at.x - e.a.x), steps(s.at.y - e.a.y)};
}

std::int64_t WrappedTo(Wide n, int bits) {
  const int unused = 64 - bits;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(n) << unused) >> unused;
}

using ValueSign = std::function<int(const SuspectEdge&, const SuspectSample&)>;

// What is wrong with edge values may be wrong with the area, too, and shows at the samples that are
// looked at: those that the triangle's box holds, all of the pixels that it meets, or all.
void AddArithmetic(const std::string& cause, const std::string& what, const ValueSign& value,
                   std::vector<Suspect>& list) {
  using Box = void (*)(PixelRect&, const SuspectTriangle&, const Scene&);
  constexpr Box kMeets = [](PixelRect& box, const SuspectTriangle& t, const Scene&) {
    const auto [left, right] = std::ranges::minmax(t.v, {}, &Point2::x);
    const auto [top, bottom] = std::ranges::minmax(t.v, {}, &Point2::y);
    box = {ToPixel(std::floor(left.x)), ToPixel(std::floor(top.y)),
           ToPixel(std::floor(right.x)) + 1, ToPixel(std::floor(bottom.y)) + 1};
  };
  constexpr Box kAll = [](PixelRect& box, const SuspectTriangle&, const Scene& scene) {
    box = {0, 0, scene.width, scene.height};
  };
  for (const Box box : {kMeets, Box{nullptr}, kAll}) {
    SuspectStages stages{.value = value};
    if (box != nullptr) stages.box = box;
    list.push_back({cause, what, stages});
    stages.area = [value](const std::array<Point2, 3>& v) {
      const int sign = value({.a = v[0], .b = v[1], .opposite = 2}, {.at = v[2]});
      return sign == kNoSign ? 0 : sign;
    };
    list.push_back({cause, what + ", the area's too", stages});
  }
}

void AddIntegers(const Profile& profile, std::vector<Suspect>& list) {
  const int grid =
      profile.snap.IsNone() && profile.fixed ? profile.fixed->fraction_bits : profile.snap.bits;
  if (grid < 0) return;
  const double scale = std::ldexp(1.0, std::max(grid, 1));
  const auto add = [&](const std::string& cause, const std::string& what, auto value) {
    AddArithmetic(
        cause, what,
        [value, scale](const SuspectEdge& e, const SuspectSample& s) {
          return SignOf(value(StepsOf(e, s, scale)));
        },
        list);
  };
  for (const int bits : {32, 31, 33, 30, 24, 28, 48, 40, 34, 36}) {
    const std::string of = " to " + std::to_string(bits) + " bits";
    add("overflow", "wraps edge values" + of,
        [bits](const InSteps& i) { return WrappedTo(i.Value(), bits); });
    add("overflow", "wraps the products of edge values" + of, [bits](const InSteps& i) {
      return Wide{WrappedTo(Wide{i.px} * i.dy, bits)} - WrappedTo(Wide{i.py} * i.dx, bits);
    });
    add("overflow", "wraps the first product of edge values" + of, [bits](const InSteps& i) {
      return Wide{WrappedTo(Wide{i.px} * i.dy, bits)} - Wide{i.py} * i.dx;
    });
    add("overflow", "wraps the second product of edge values" + of, [bits](const InSteps& i) {
      return Wide{i.px} * i.dy - WrappedTo(Wide{i.py} * i.dx, bits);
    });
    add("overflow", "saturates edge values" + of, [bits](const InSteps& i) {
      const Wide end = Wide{1} << (bits - 1);
      return std::clamp(i.Value(), -end, end - 1);
    });
  }
  for (const int bits : {16, 15, 20, 24}) {
    add("overflow", "wraps the edges' deltas to " + std::to_string(bits) + " bits",
        [bits](const InSteps& i) {
          return Wide{i.px} * WrappedTo(i.dy, bits) - Wide{i.py} * WrappedTo(i.dx, bits);
        });
    add("overflow", "wraps all differences to " + std::to_string(bits) + " bits",
        [bits](const InSteps& i) {
          return Wide{WrappedTo(i.px, bits)} * WrappedTo(i.dy, bits) -
                 Wide{WrappedTo(i.py, bits)} * WrappedTo(i.dx, bits);
        });
  }
  for (int bits = 1; bits <= 12; ++bits) {
    const Wide step = Wide{1} << bits;
    add("edge-precision", "drops the last " + std::to_string(bits) + " bits of edge values",
        [bits](const InSteps& i) { return i.Value() >> bits; });
    add("edge-precision",
        "takes edge values below 2^" + std::to_string(bits) + " steps for on the edge",
        [step](const InSteps& i) { return i.Value() / step; });
    add("edge-precision", "covers samples within 2^" + std::to_string(bits) + " steps of an edge",
        [step](const InSteps& i) { return i.Value() > -step ? Wide{1} : Wide{-1}; });
    add("edge-precision", "covers no sample within 2^" + std::to_string(bits) + " steps of an edge",
        [step](const InSteps& i) { return i.Value() < step ? Wide{-1} : Wide{1}; });
  }
}

using Arithmetic = int (*)(const SuspectEdge&, Point2);

// The published forms, each rounding written out; `Number` is float or double.
template <class Number>
struct Forms {
  static Number N(double x) { return static_cast<Number>(x); }
  static Number DirectValue(const SuspectEdge& e, Point2 p) {
    return (N(p.x) - N(e.a.x)) * (N(e.b.y) - N(e.a.y)) -
           (N(p.y) - N(e.a.y)) * (N(e.b.x) - N(e.a.x));
  }
  static int Direct(const SuspectEdge& e, Point2 p) { return SignOf(DirectValue(e, p)); }
  static int DirectFinite(const SuspectEdge& e, Point2 p) {
    const Number value = DirectValue(e, p);
    return std::isfinite(value) ? SignOf(value) : kNoSign;
  }
  static int FusedFirst(const SuspectEdge& e, Point2 p) {
    const Number second = (N(p.y) - N(e.a.y)) * (N(e.b.x) - N(e.a.x));
    return SignOf(std::fma(N(p.x) - N(e.a.x), N(e.b.y) - N(e.a.y), -second));
  }
  static int FusedSecond(const SuspectEdge& e, Point2 p) {
    const Number first = (N(p.x) - N(e.a.x)) * (N(e.b.y) - N(e.a.y));
    return SignOf(std::fma(-(N(p.y) - N(e.a.y)), N(e.b.x) - N(e.a.x), first));
  }
  static int Affine(const SuspectEdge& e, Point2 p) {
    const Number a = N(e.b.y) - N(e.a.y);
    const Number b = N(e.a.x) - N(e.b.x);
    const Number c = N(e.a.y) * N(e.b.x) - N(e.a.x) * N(e.b.y);
    return SignOf(a * N(p.x) + b * N(p.y) + c);
  }
  static int AffineAnchored(const SuspectEdge& e, Point2 p) {
    const Number a = N(e.b.y) - N(e.a.y);
    const Number b = N(e.a.x) - N(e.b.x);
    const Number c = -(a * N(e.a.x) + b * N(e.a.y));
    return SignOf(a * N(p.x) + b * N(p.y) + c);
  }
  static int RoundedDifferences(const SuspectEdge& e, Point2 p) {
    const Point2 edge{double{N(e.b.x) - N(e.a.x)}, double{N(e.b.y) - N(e.a.y)}};
    const Point2 at{double{N(p.x) - N(e.a.x)}, double{N(p.y) - N(e.a.y)}};
    return exact::EdgeSign({0, 0}, edge, at);
  }
};

int Stepped(const SuspectEdge& e, const SuspectSample& s, int tile) {
  const int steps = s.x % tile;
  const double dx = e.b.x - e.a.x, dy = e.b.y - e.a.y;
  auto value = static_cast<float>((s.at.x - steps - e.a.x) * dy - (s.at.y - e.a.y) * dx);
  const auto step = static_cast<float>(dy);
  for (int n = 0; n < steps; ++n) value += step;
  return SignOf(value);
}

bool IsNear(const SuspectEdge& e, const SuspectSample& s, double tolerance) {
  return std::fabs(variants::RoundedEdgeValue(e.a, e.b, s.at)) < tolerance;
}

void AddFloats(const Profile& profile, std::vector<Suspect>& list) {
  const auto add = [&](const std::string& what, Arithmetic sign) {
    AddArithmetic(
        "float-edges", "computes edge values " + what,
        [sign](const SuspectEdge& e, const SuspectSample& s) { return sign(e, s.at); }, list);
  };
  using Float = Forms<float>;
  using Double = Forms<double>;
  add("in float32, directly", Float::Direct);
  add("in float32, directly, where infinite ones are outside", Float::DirectFinite);
  add("in float32, its first product fused", Float::FusedFirst);
  add("in float32, its second product fused", Float::FusedSecond);
  add("in float32 as a x + b y + c", Float::Affine);
  add("in float32 as a x + b y + c, c from the edge's first end", Float::AffineAnchored);
  add("exactly from differences rounded to float32", Float::RoundedDifferences);
  add("in float64, directly", Double::Direct);
  add("in float64 as a x + b y + c", Double::Affine);
  for (const int tile : {8, 16, 32, 64, 1 << 20}) {
    list.push_back({"float-edges",
                    "steps edge values along a row in float32" +
                        (tile < (1 << 20) ? " from tiles of " + std::to_string(tile) + " pixels"
                                          : std::string()),
                    {.value = [tile](const SuspectEdge& e, const SuspectSample& s) {
                      return Stepped(e, s, tile);
                    }}});
  }
  for (const double tolerance : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0x1p-23, 0x1p-20}) {
    list.push_back({"edge-precision",
                    "takes edge values near zero for zero",
                    {.value = [tolerance](const SuspectEdge& e, const SuspectSample& s) {
                      const bool is_near = IsNear(e, s, tolerance);
                      return is_near ? 0 : exact::EdgeSign(e.a, e.b, s.at);
                    }}});
    if (!profile.snap.IsNone()) continue;  // on a grid they are among the integers
    for (const int side : {1, -1}) {
      list.push_back({"edge-precision",
                      std::string(side > 0 ? "takes edge values near zero for inside"
                                           : "takes edge values near zero for outside"),
                      {.value = [tolerance, side](const SuspectEdge& e, const SuspectSample& s) {
                        const bool is_near = IsNear(e, s, tolerance);
                        return is_near ? side : exact::EdgeSign(e.a, e.b, s.at);
                      }}});
    }
  }
}

}  // namespace

void AddEdges(const Profile& profile, std::vector<Suspect>& list) {
  AddRuleNames(profile.tie_rule, list);
  AddKindsOfEdges(list);
  AddKindsOfTriangles(list);
  AddIntegers(profile, list);
  AddFloats(profile, list);
}

}  // namespace rasterproof::props
