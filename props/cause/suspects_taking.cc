// Suspects that take a triangle for another one: its facing, its size, its numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "exact/edge.h"
#include "props/cause/suspect.h"

namespace rasterproof::props {
namespace {

using Corners3 = std::array<Point2, 3>;

int ExactArea(const Corners3& v) { return exact::EdgeSign(v[0], v[1], v[2]); }

double AreaOf(const Corners3& v) { return variants::RoundedEdgeValue(v[0], v[1], v[2]); }

template <class Number>
int DirectArea(const Corners3& v) {
  const auto n = [](double x) { return static_cast<Number>(x); };
  const Number area = (n(v[2].x) - n(v[0].x)) * (n(v[1].y) - n(v[0].y)) -
                      (n(v[2].y) - n(v[0].y)) * (n(v[1].x) - n(v[0].x));
  return (area > 0) - (area < 0);
}

int SummedArea(const Corners3& v) {
  const auto cross = [](Point2 a, Point2 b) {
    return static_cast<float>(a.y) * static_cast<float>(b.x) -
           static_cast<float>(a.x) * static_cast<float>(b.y);
  };
  const float area = cross(v[0], v[1]) + cross(v[1], v[2]) + cross(v[2], v[0]);
  return (area > 0) - (area < 0);
}

void AddFacings(const Profile& profile, std::vector<Suspect>& list) {
  list.push_back({"facing", "exchanges front and back", {.facing = [](SuspectTriangle& t) {
                    t.front = !t.front;
                  }}});
  if (profile.culls == Cull::kNone) {
    list.push_back({"facing",
                    "always culls back faces (if it is meant to, state it in the profile: "
                    "\"culls\": \"back\")",
                    {.area = [](const Corners3& v) { return std::max(0, ExactArea(v)); }}});
    list.push_back({"facing",
                    "always culls front faces (if it is meant to, state it in the profile: "
                    "\"culls\": \"front\")",
                    {.area = [](const Corners3& v) { return std::min(0, ExactArea(v)); }}});
  } else {
    list.push_back({"facing",
                    "draws the side that the profile says it culls",
                    {.model = [](Profile& p, const Scene&) { p.culls = Cull::kNone; }}});
    list.push_back({"facing",
                    "culls the other side than the profile says",
                    {.model = [](Profile& p, const Scene&) {
                      p.culls = p.culls == Cull::kFront ? Cull::kBack : Cull::kFront;
                    }}});
  }
  list.push_back({"facing", "calls every triangle a front face", {.facing = [](SuspectTriangle& t) {
                    t.front = true;
                  }}});
  list.push_back(
      {"facing-arithmetic", "computes the area in float32, directly", {.area = DirectArea<float>}});
  list.push_back({"facing-arithmetic",
                  "computes the area in float32, as a sum of three products",
                  {.area = SummedArea}});
  list.push_back({"facing-arithmetic",
                  "computes the area in float64, directly",
                  {.area = DirectArea<double>}});
  list.push_back({"facing-arithmetic",
                  "leaves out triangles without area before the snap",
                  {.leaves_out = [](const SuspectTriangle& t, const Scene&) {
                    const Corners3 v{WindowPoint(t.given[0]), WindowPoint(t.given[1]),
                                     WindowPoint(t.given[2])};
                    return ExactArea(v) == 0;
                  }}});
  if (profile.snap.IsNone()) return;
  const double scale = std::ldexp(1.0, profile.snap.bits);
  for (const int bits : {31, 32, 33, 24, 48, 30, 28, 34, 36, 40}) {
    list.push_back(
        {"overflow",
         "wraps the area to " + std::to_string(bits) + " bits",
         {.area = [scale, bits](const Corners3& v) {
           __extension__ using Wide = __int128;
           const auto n = [scale](double x) {
             return Wide{static_cast<std::int64_t>(std::clamp(x * scale, -0x1p61, 0x1p61))};
           };
           const Wide area =
               n(v[2].x - v[0].x) * n(v[1].y - v[0].y) - n(v[2].y - v[0].y) * n(v[1].x - v[0].x);
           const auto cut =
               static_cast<std::int64_t>(static_cast<std::uint64_t>(area) << (64 - bits));
           return (cut > 0) - (cut < 0);
         }}});
  }
}

void AddCulling(std::vector<Suspect>& list) {
  list.push_back({"culling", "culls the other side", {.options = [](DrawOptions& o, const Scene&) {
                    if (o.cull != Cull::kNone)
                      o.cull = o.cull == Cull::kFront ? Cull::kBack : Cull::kFront;
                  }}});
  list.push_back({"culling", "culls nothing", {.options = [](DrawOptions& o, const Scene&) {
                    o.cull = Cull::kNone;
                  }}});
  for (const Cull side : {Cull::kFront, Cull::kBack}) {
    const std::string which = side == Cull::kFront ? "front" : "back";
    list.push_back({"culling",
                    "does not cull " + which + " faces",
                    {.options = [side](DrawOptions& o, const Scene&) {
                      if (o.cull == side) o.cull = Cull::kNone;
                    }}});
    list.push_back({"culling",
                    "culls " + which + " faces only where there is a scissor",
                    {.options = [side](DrawOptions& o, const Scene&) {
                      if (o.cull == side && !o.scissor) o.cull = Cull::kNone;
                    }}});
  }
}

double SpanAlong(const SuspectTriangle& t, double Point2::* axis) {
  const auto [least, most] = std::ranges::minmax(t.v, {}, axis);
  return most.*axis - least.*axis;
}

double FarthestOf(const SuspectTriangle& t) {
  double reach = 0;
  for (const Point2& p : t.v) reach = std::max({reach, std::fabs(p.x), std::fabs(p.y)});
  return reach;
}

double Thickness(const SuspectTriangle& t) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 a = t.v[i], b = t.v[(i + 1) % 3];
    longest = std::max(longest, Hypot(b.x - a.x, b.y - a.y));
  }
  return longest == 0 ? 0 : std::fabs(AreaOf(t.v)) / longest;
}

// A number of a triangle below or above which it may be left out.
struct Feature {
  std::string_view what;
  double (*of)(const SuspectTriangle&);
  int least, most;  // powers of two of the limits
  bool leaves_out_less;
};
constexpr auto kFeatures = std::to_array<Feature>({
    {"of less area than {} square pixels",
     [](const SuspectTriangle& t) { return std::fabs(AreaOf(t.v)) / 2; }, -24, 2, true},
    {"whose box is smaller than {} pixels on both axes",
     [](const SuspectTriangle& t) {
       return std::max(SpanAlong(t, &Point2::x), SpanAlong(t, &Point2::y));
     },
     -8, 2, true},
    {"whose box is smaller than {} pixels on an axis",
     [](const SuspectTriangle& t) {
       return std::min(SpanAlong(t, &Point2::x), SpanAlong(t, &Point2::y));
     },
     -8, 2, true},
    {"thinner than {} pixels", Thickness, -8, 1, true},
    {"of more than {} pixels a side",
     [](const SuspectTriangle& t) {
       return std::max(SpanAlong(t, &Point2::x), SpanAlong(t, &Point2::y));
     },
     8, 16, false},
    {"with a coordinate beyond {} pixels", FarthestOf, 7, 26, false},
    {"with a vertex left of or above -{} pixels",
     [](const SuspectTriangle& t) {
       double least = 0;
       for (const Point2& p : t.v) least = std::min({least, p.x, p.y});
       return -least;
     },
     -1, 14, false},
    {"with a vertex left of -{} pixels",
     [](const SuspectTriangle& t) { return -std::ranges::min(t.v, {}, &Point2::x).x; }, -1, 14,
     false},
    {"with a vertex above -{} pixels",
     [](const SuspectTriangle& t) { return -std::ranges::min(t.v, {}, &Point2::y).y; }, -1, 14,
     false},
});

std::string PowerText(int power) {
  if (power >= 0) return std::to_string(std::int64_t{1} << power);
  return power >= -10 ? "1/" + std::to_string(1 << -power) : "2^" + std::to_string(power);
}

void AddLost(std::vector<Suspect>& list) {
  for (const Feature& feature : kFeatures) {
    for (int power = feature.least; power <= feature.most; ++power) {
      const double limit = std::ldexp(1.0, power);
      std::string what(feature.what);
      const bool is_one = power == 0;
      if (const auto at = what.find("pixels"); is_one && at != std::string::npos)
        what.replace(at, 6, "pixel");
      what.replace(what.find("{}"), 2, PowerText(power));
      for (const bool is_strict : {true, false}) {
        list.push_back(
            {"lost-triangles",
             "leaves out triangles " + what,
             {.leaves_out = [of = feature.of, limit, is_strict, less = feature.leaves_out_less](
                                const SuspectTriangle& t, const Scene&) {
               const double n = of(t);
               if (n == limit) return !is_strict;
               return less ? n < limit : n > limit;
             }}});
      }
    }
  }
  for (const double limit : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    list.push_back({"lost-triangles",
                    "leaves out triangles of next to no area",
                    {.leaves_out = [limit](const SuspectTriangle& t, const Scene&) {
                      return std::fabs(AreaOf(t.v)) < limit;
                    }}});
  }
}

void AddBudgets(std::vector<Suspect>& list) {
  using Number = std::int64_t (*)(const SuspectTriangle&);
  const auto add = [&](const std::string& what, Number number) {
    const auto within = [number](std::int64_t budget) -> SuspectStages {
      return {.leaves_out = [=](const SuspectTriangle& t, const Scene&) {
        return number(t) >= budget;
      }};
    };
    list.push_back({"lost-triangles", what, {}, within});
  };
  add("leaves out triangles from number {} of the list on",
      [](const SuspectTriangle& t) { return static_cast<std::int64_t>(t.number); });
  add("leaves out triangles with vertices from number {} on",
      [](const SuspectTriangle& t) { return std::int64_t{std::ranges::max(t.indices)}; });
}

bool IsMiddleOutside(const SuspectTriangle& t, const Scene& scene, double up) {
  const double x = (t.v[0].x + t.v[1].x + t.v[2].x) / 3;
  const double y = up * (t.v[0].y + t.v[1].y + t.v[2].y) / 3;
  return x < 0 || y < 0 || x > scene.width || y > scene.height;
}

// By where they lie on the screen, or in depth.
void AddFilters(const Profile& profile, std::vector<Suspect>& list) {
  const double up = profile.y_axis == YAxis::kUp ? -1 : 1;
  list.push_back({"lost-triangles",
                  "leaves out triangles whose middle lies outside the target",
                  {.leaves_out = [up](const SuspectTriangle& t, const Scene& scene) {
                    return IsMiddleOutside(t, scene, up);
                  }}});
  const auto by_z = [&](const std::string& range, auto is_out) {
    const auto is_lost = [is_out](const Vertex& v) { return is_out(v.z); };
    list.push_back({"lost-triangles",
                    "leaves out triangles with a vertex of z " + range,
                    {.leaves_out = [is_lost](const SuspectTriangle& t, const Scene&) {
                      return std::ranges::any_of(t.given, is_lost);
                    }}});
    list.push_back({"lost-triangles",
                    "leaves out triangles with all vertices of z " + range,
                    {.leaves_out = [is_lost](const SuspectTriangle& t, const Scene&) {
                      return std::ranges::all_of(t.given, is_lost);
                    }}});
  };
  by_z("below 0", [](double z) { return z < 0; });
  by_z("above 1", [](double z) { return z > 1; });
  by_z("below -1", [](double z) { return z < -1; });
  by_z("below 0 or above 1", [](double z) { return z < 0 || z > 1; });
}

void AddOddInput(std::vector<Suspect>& list) {
  const auto taking = [](double (*number)(double)) {
    return SuspectStages{.vertices = [number](std::array<Vertex, 3>& corners) {
      for (Vertex& v : corners) v = {number(v.x), number(v.y), v.z, v.w};
    }};
  };
  list.push_back(
      {"not-finite", "takes NaN for zero", taking([](double x) { return std::isnan(x) ? 0 : x; })});
  for (const double end : {0x1p15, 0x1p14, 0x1p13, 0x1p20, 0x1p24, 0x1p30}) {
    list.push_back({"not-finite",
                    "clamps infinity to " + std::to_string(std::int64_t(end)),
                    {.vertices = [end](std::array<Vertex, 3>& corners) {
                      for (Vertex& v : corners) {
                        if (std::isinf(v.x)) v.x = std::copysign(end, v.x);
                        if (std::isinf(v.y)) v.y = std::copysign(end, v.y);
                      }
                    }}});
  }
  list.push_back({"not-finite",
                  "leaves out triangles with a z that is not finite",
                  {.leaves_out = [](const SuspectTriangle& t, const Scene&) {
                    return std::ranges::any_of(t.given,
                                               [](const Vertex& v) { return !std::isfinite(v.z); });
                  }}});
  list.push_back({"subnormals", "takes subnormal coordinates for zero", taking([](double x) {
                    return std::fabs(x) < double{std::numeric_limits<float>::min()} ? 0 : x;
                  })});
  SuspectStages flat;
  flat.draws_flat = true;
  list.push_back({"flat-triangles", "draws triangles without area", flat});
  flat.owns = [](const SuspectEdge& e, const SuspectTriangle& t, const SuspectSample&) {
    return ExactArea(t.v) == 0 || e.owns;
  };
  list.push_back({"flat-triangles", "draws triangles without area as lines", flat});
}

}  // namespace

void AddTaking(const Profile& profile, std::vector<Suspect>& list) {
  AddFacings(profile, list);
  AddCulling(list);
  AddLost(list);
  AddBudgets(list);
  AddFilters(profile, list);
  AddOddInput(list);
}

}  // namespace rasterproof::props
