#include "exact/edge_widths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"

namespace rasterproof::exact {
namespace {

// From the first to the last number of a coordinate.
struct UnitRange {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

struct PointBox {
  UnitRange x;
  UnitRange y;
  std::int64_t step = 1;  ///< from one of its points to the next
};

struct PointPlace {
  std::string id;
  std::string words;
  std::vector<PointBox> boxes;  ///< one for each sample of a pixel that has one there
};

using EdgeFormula = std::function<EdgeInteger(const EdgeInput&)>;

struct EdgeTerm {
  std::string form;
  std::string id;
  std::string words;
  // The value, and the one with x and y exchanged: both are held by a register of this width.
  std::vector<EdgeFormula> formulas;
  bool depends_on_p = true;
  bool is_of_offsets = false;  ///< also where p is a sample's offset in its pixel
};

EdgeInteger Wide(std::int64_t x) { return x; }
EdgeInteger A(const EdgeInput& e) { return Wide(e.by) - e.ay; }
EdgeInteger B(const EdgeInput& e) { return Wide(e.ax) - e.bx; }
EdgeInteger C(const EdgeInput& e) { return Wide(e.ay) * e.bx - Wide(e.ax) * e.by; }

std::int64_t OnePixel(const EdgeUnit& unit) { return std::int64_t{1} << unit.UnitBits(); }

// Of vertices a unit of the input may be two of these.
std::int64_t VertexStep(const EdgeUnit& unit) {
  return std::int64_t{1} << (unit.UnitBits() - unit.input.fraction_bits);
}

UnitRange VertexRange(const EdgeUnit& unit) {
  const std::int64_t numbers = std::int64_t{1}
                               << (unit.input.integer_bits + unit.input.fraction_bits);
  const std::int64_t least = unit.input.is_signed ? -numbers / 2 : 0;
  return {least * VertexStep(unit), (least + numbers - 1) * VertexStep(unit)};
}

std::int64_t InUnits(const EdgeUnit& unit, double pixels) {
  return static_cast<std::int64_t>(std::ldexp(pixels, unit.UnitBits()));
}

// The sample at `place` of the pixels [first, end).
UnitRange SamplesIn(const EdgeUnit& unit, double place, int first, int end) {
  const std::int64_t at = InUnits(unit, place);
  return {first * OnePixel(unit) + at, (end - 1) * OnePixel(unit) + at};
}

// Those of the target that lie in the range of vertices, and so in the box of some triangle.
std::optional<UnitRange> SamplesInReach(const EdgeUnit& unit, double place, int side) {
  const UnitRange vertices = VertexRange(unit);
  UnitRange samples = SamplesIn(unit, place, 0, side);
  if (vertices.last < samples.first) return std::nullopt;
  const std::int64_t last = (vertices.last - samples.first) / OnePixel(unit);
  samples.last = std::min(samples.last, samples.first + last * OnePixel(unit));
  return samples;
}

// So many pixels past both ends.
std::vector<PointBox> SamplesOf(const EdgeUnit& unit, int past) {
  std::vector<PointBox> boxes;
  for (const Point2& l : unit.pattern.locations) {
    boxes.push_back({SamplesIn(unit, l.x, -past, unit.width + past),
                     SamplesIn(unit, l.y, -past, unit.height + past), OnePixel(unit)});
  }
  return boxes;
}

std::vector<PointBox> ReachedSamplesOf(const EdgeUnit& unit) {
  std::vector<PointBox> boxes;
  for (const Point2& l : unit.pattern.locations) {
    const auto x = SamplesInReach(unit, l.x, unit.width);
    const auto y = SamplesInReach(unit, l.y, unit.height);
    if (x && y) boxes.push_back({*x, *y, OnePixel(unit)});
  }
  return boxes;
}

UnitRange TileCorners(const EdgeUnit& unit, int side, int past) {
  const std::int64_t tiles = (side + unit.tile - 1) / unit.tile;
  const std::int64_t tile = unit.tile * OnePixel(unit);
  return {-past * tile, (tiles + past) * tile};
}

std::vector<PointPlace> Places(const EdgeUnit& unit) {
  const auto corners = [&](int past) {
    return std::vector<PointBox>{{TileCorners(unit, unit.width, past),
                                  TileCorners(unit, unit.height, past),
                                  unit.tile * OnePixel(unit)}};
  };
  return {
      {"box", "sample in the box", ReachedSamplesOf(unit)},
      {"target", "sample on the target", SamplesOf(unit, 0)},
      {"corner", "corner of a tile", corners(0)},
      {"pixel-past", "a pixel past both ends", SamplesOf(unit, 1)},
      {"tile-past", "a tile past both ends", corners(1)},
  };
}

// From the pixel's upper left corner; as one place of several points.
PointPlace Offsets(const EdgeUnit& unit) {
  return {"offset", "sample in its pixel",
          SamplesOf({.input = unit.input, .pattern = unit.pattern}, 0)};
}

EdgeInteger BiasedEdge(const EdgeInput& e) { return EdgeOf(e) - 1; }

EdgeFormula Multiple(std::int64_t factor, EdgeInteger (*value)(const EdgeInput&)) {
  return [factor, value](const EdgeInput& e) { return factor * value(e); };
}

std::string CountOf(int tile) { return std::to_string(tile) + (tile == 1 ? " pixel" : " pixels"); }

std::vector<EdgeTerm> EdgeTerms(const EdgeUnit& unit) {
  using E = const EdgeInput&;
  const std::int64_t pixel = OnePixel(unit);
  std::vector<EdgeTerm> values = {
      {"direct", "b-a", "b - a", {A, B}, false},
      {"direct",
       "p-a",
       "p - a",
       {[](E e) { return Wide(e.px) - e.ax; }, [](E e) { return Wide(e.py) - e.ay; }}},
      {"direct",
       "product",
       "(p.x - a.x)(b.y - a.y)",
       {[](E e) { return (Wide(e.px) - e.ax) * A(e); },
        [](E e) { return (Wide(e.py) - e.ay) * B(e); }}},
      {"direct", "e", "E", {EdgeOf}},
      {"affine", "a", "A, B", {A, B}, false},
      {"affine",
       "c-product",
       "a.y b.x",
       {[](E e) { return Wide(e.ay) * e.bx; }, [](E e) { return Wide(e.ax) * e.by; }},
       false},
      {"affine", "c", "C = a.y b.x - a.x b.y", {C}, false},
      {"affine",
       "product",
       "A p.x, B p.y",
       {[](E e) { return A(e) * e.px; }, [](E e) { return B(e) * e.py; }},
       true,
       true},
      {"affine",
       "sum",
       "A p.x + B p.y",
       {[](E e) { return A(e) * e.px + B(e) * e.py; }},
       true,
       true},
      {"affine", "e", "E", {EdgeOf}},
      {"stepped", "step", "step of 1 pixel", {Multiple(pixel, A), Multiple(pixel, B)}, false},
  };
  if (unit.tile > 1) {
    values.push_back({"stepped",
                      "tile-step",
                      "step of " + CountOf(unit.tile),
                      {Multiple(pixel * unit.tile, A), Multiple(pixel * unit.tile, B)},
                      false});
  }
  values.push_back({"stepped", "e", "E, accumulated", {EdgeOf}});
  values.push_back({"biased", "e", "E, E - 1", {EdgeOf, BiasedEdge}});
  return values;
}

// Calls take with each of the 64 inputs whose coordinates are ends of their ranges.
template <class Take>
void AtCorners(const UnitRange& vertices, const PointBox& p, const Take& take) {
  const std::array<UnitRange, 6> ranges = {vertices, vertices, vertices, vertices, p.x, p.y};
  for (unsigned corner = 0; corner < 64; ++corner) {
    std::array<std::int64_t, 6> at{};
    for (unsigned k = 0; k < 6; ++k)
      at[k] = (corner >> k & 1U) != 0 ? ranges[k].last : ranges[k].first;
    take(EdgeInput{at[0], at[1], at[2], at[3], at[4], at[5]});
  }
}

// A width, and what takes it.
struct FoundWidth {
  EdgeWidth width;
  EdgeFormula formula;
  PointBox box;  ///< where p lies
};

// The width of one formula at one place. Bits are those that least and most take together, so of
// formulas for x and for y the wider one is kept.
FoundWidth WidthOf(const EdgeFormula& formula, const UnitRange& vertices, const PointPlace& place) {
  struct End {
    EdgeInteger value = 0;
    EdgeInput input;
    PointBox box;
  };
  std::optional<std::pair<End, End>> ends;
  for (const PointBox& box : place.boxes) {
    AtCorners(vertices, box, [&](const EdgeInput& input) {
      const End end{formula(input), input, box};
      if (!ends) ends.emplace(end, end);
      if (end.value < ends->first.value) ends->first = end;
      if (end.value > ends->second.value) ends->second = end;
    });
  }
  EdgeWidth width;
  width.least = ends->first.value;
  width.most = ends->second.value;
  width.bits = SignedBits(width.least, width.most);
  const bool is_most = SignedBits(width.most, width.most) == width.bits;
  const End& extreme = is_most ? ends->second : ends->first;
  width.witness = extreme.input;
  width.extreme = extreme.value;
  return {std::move(width), formula, extreme.box};
}

FoundWidth WidthOf(const EdgeTerm& value, const UnitRange& vertices, const PointPlace& place) {
  FoundWidth widest;
  for (const EdgeFormula& formula : value.formulas) {
    FoundWidth found = WidthOf(formula, vertices, place);
    if (found.width.bits > widest.width.bits) widest = std::move(found);
  }
  EdgeWidth& width = widest.width;
  width.id = value.form + '-' + value.id;
  if (value.depends_on_p) width.id += '-' + place.id;
  width.form = value.form;
  width.value = value.words;
  width.place = value.depends_on_p ? place.words : "";
  width.depends_on_p = value.depends_on_p;
  return widest;
}

std::vector<FoundWidth> FoundWidths(const EdgeUnit& unit) {
  const UnitRange vertices = VertexRange(unit);
  if (const auto why = WhyNoEdgeWidths(unit)) throw InputError(*why);
  const std::vector<PointPlace> places = Places(unit);
  std::vector<FoundWidth> widths;
  for (const EdgeTerm& value : EdgeTerms(unit)) {
    if (!value.depends_on_p) {
      widths.push_back(WidthOf(value, vertices, places.front()));
      continue;
    }
    for (const PointPlace& place : places) widths.push_back(WidthOf(value, vertices, place));
    if (value.is_of_offsets) widths.push_back(WidthOf(value, vertices, Offsets(unit)));
  }
  const EdgeTerm area = {"area", "e", "E(a, b; c), twice it", {EdgeOf}};
  widths.push_back(WidthOf(area, vertices,
                           {"vertex", "third vertex", {{vertices, vertices, VertexStep(unit)}}}));
  return widths;
}

// How far the value lies beyond n bits in two's complement, on the side of its sign; negative: n
// bits hold it.
EdgeInteger BeyondBits(EdgeInteger value, bool is_positive, int bits) {
  const EdgeInteger end = EdgeInteger{1} << (bits - 1);
  return is_positive ? value - end : -end - 1 - value;
}

// The input whose value is next beyond n bits, as far as each coordinate alone can bring it there:
// from the extreme one, each goes to the last place that still is beyond. The value is affine in
// it, so that place is found by halving.
EdgeWidth InputBeyond(const EdgeUnit& unit, const FoundWidth& found, int bits) {
  EdgeWidth width = found.width;
  const bool is_positive = width.extreme > 0;
  const UnitRange vertices = VertexRange(unit);
  EdgeInput& e = width.witness;
  const auto beyond = [&] { return BeyondBits(found.formula(e), is_positive, bits); };
  const auto move = [&](std::int64_t& coordinate, const UnitRange& range, std::int64_t step) {
    const std::int64_t from = coordinate;
    const std::int64_t by = from == range.first ? step : -step;
    const EdgeInteger before = beyond();
    std::int64_t low = 0;  // so many steps are known to be beyond
    std::int64_t high = (range.last - range.first) / step;
    const auto at = [&](std::int64_t steps) {
      coordinate = from + steps * by;
      return beyond();
    };
    if (at(high) < before) {
      while (low < high) {
        const std::int64_t middle = low + (high - low + 1) / 2;
        if (at(middle) >= 0) {
          low = middle;
        } else {
          high = middle - 1;
        }
      }
    }
    coordinate = from + low * by;
  };
  move(e.ax, vertices, VertexStep(unit));
  move(e.ay, vertices, VertexStep(unit));
  move(e.bx, vertices, VertexStep(unit));
  move(e.by, vertices, VertexStep(unit));
  move(e.px, found.box.x, found.box.step);
  move(e.py, found.box.y, found.box.step);
  width.id += "-beyond-" + std::to_string(bits);
  width.bits = bits + 1;
  width.extreme = found.formula(e);
  return width;
}

// Of an area: a right triangle at the target's corner, whose legs are as equal as may be. Nothing
// if vertices do not reach so far.
std::optional<EdgeWidth> RightTriangleBeyond(const EdgeUnit& unit, const FoundWidth& found,
                                             int bits) {
  EdgeWidth width = found.width;
  const bool is_positive = width.extreme > 0;
  const UnitRange vertices = VertexRange(unit);
  const std::int64_t step = VertexStep(unit);
  const std::int64_t from = std::max<std::int64_t>(vertices.first, 0);
  const EdgeInteger least = (EdgeInteger{1} << (bits - 1)) + (is_positive ? 0 : 1);
  const double steps =
      static_cast<double>(least) / (static_cast<double>(step) * static_cast<double>(step));
  const std::int64_t wide = step * static_cast<std::int64_t>(std::ceil(std::sqrt(steps)));
  std::int64_t high = step;
  while (high <= vertices.last && EdgeInteger{wide} * high < least) high += step;
  if (from + wide > vertices.last || from + high > vertices.last) return std::nullopt;
  width.witness = {from, from, from, from + high, from + wide, from};
  if (!is_positive) width.witness = {from, from, from + wide, from, from, from + high};
  width.id += "-beyond-" + std::to_string(bits);
  width.bits = bits + 1;
  width.extreme = found.formula(width.witness);
  return width;
}

int WideSign(EdgeInteger x) { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }

bool IsHeldBy(EdgeInteger value, int bits) { return SignedBits(value, value) <= bits; }

// How well c serves: 2 where the sign of E(a, b; p) decides whether p is covered, 3 where a
// register of one bit less holds the other two values.
int WorthOf(const EdgeWidth& width, std::int64_t cx, std::int64_t cy) {
  const EdgeInput& e = width.witness;
  const int area = WideSign(EdgeOf({e.ax, e.ay, e.bx, e.by, cx, cy}));
  if (area == 0) return 0;
  const auto between = [](std::int64_t p, std::int64_t a, std::int64_t b, std::int64_t c) {
    return p >= std::min({a, b, c}) && p <= std::max({a, b, c});
  };
  const bool holds_p = between(e.px, e.ax, e.bx, cx) && between(e.py, e.ay, e.by, cy);
  if (width.id.ends_with("-box") && !holds_p) return 0;
  const EdgeInteger second = EdgeOf({e.bx, e.by, cx, cy, e.px, e.py});
  const EdgeInteger third = EdgeOf({cx, cy, e.ax, e.ay, e.px, e.py});
  if (WideSign(second) != area || WideSign(third) != area) return 1;
  return IsHeldBy(second, width.bits - 1) && IsHeldBy(third, width.bits - 1) ? 3 : 2;
}

// Numbers for c's coordinate: ends of the range; beside the middle of a and b, which halves the
// other two values where p lies beyond the edge; beside p.
std::vector<std::int64_t> Candidates(const EdgeUnit& unit, std::int64_t a, std::int64_t b,
                                     std::int64_t p) {
  const UnitRange range = VertexRange(unit);
  const std::int64_t step = VertexStep(unit);
  std::vector<std::int64_t> list = {range.last, range.first};
  for (const std::int64_t near : {(a + b) / 2, p}) {
    for (const std::int64_t by : {std::int64_t{0}, step, -step}) {
      list.push_back(std::clamp(near / step * step + by, range.first, range.last));
    }
  }
  return list;
}

// A triangle of these corners, in units.
Scene SceneOf(const EdgeUnit& unit, const std::string& name,
              const std::array<std::pair<std::int64_t, std::int64_t>, 3>& corners) {
  Scene scene;
  scene.name = name;
  scene.width = unit.width;
  scene.height = unit.height;
  const int bits = unit.input.integer_bits + unit.input.fraction_bits;
  scene.precision = bits > 24 ? Precision::kFloat64 : Precision::kFloat32;
  const auto pixels = [&](std::int64_t n) {
    return std::ldexp(static_cast<double>(n), -unit.UnitBits());
  };
  for (const auto& [x, y] : corners) scene.vertices.push_back({pixels(x), pixels(y)});
  scene.triangles = {{0, 1, 2}};
  return scene;
}

}  // namespace

int EdgeUnit::UnitBits() const {
  int bits = input.fraction_bits;
  const auto is_on_grid = [&](double x) {
    const double scaled = std::ldexp(x, bits);
    return scaled == std::floor(scaled);
  };
  for (const Point2& l : pattern.locations) {
    while (!is_on_grid(l.x) || !is_on_grid(l.y)) ++bits;
  }
  return bits;
}

EdgeInteger EdgeOf(const EdgeInput& e) {
  return (Wide(e.px) - e.ax) * A(e) + (Wide(e.py) - e.ay) * B(e);
}

int SignedBits(EdgeInteger least, EdgeInteger most) {
  const auto bits = [](EdgeInteger x) {
    int count = 1;
    for (EdgeInteger rest = x < 0 ? -(x + 1) : x; rest != 0; rest >>= 1) ++count;
    return count;
  };
  return std::max(bits(least), bits(most));
}

EdgeInteger WrappedTo(EdgeInteger value, int bits) {
  const EdgeInteger span = EdgeInteger{1} << bits;
  EdgeInteger rest = value % span;
  if (rest < 0) rest += span;
  return rest >= span / 2 ? rest - span : rest;
}

std::optional<InputError> WhyNoEdgeWidths(const EdgeUnit& unit) {
  if (!ReachedSamplesOf(unit).empty()) return std::nullopt;
  return InputError("--fixed", "no sample lies in the range of vertices",
                    "give one more bit before or after the point");
}

std::vector<EdgeWidth> EdgeWidths(const EdgeUnit& unit) {
  std::vector<EdgeWidth> widths;
  for (FoundWidth& found : FoundWidths(unit)) widths.push_back(std::move(found.width));
  return widths;
}

std::vector<EdgeWidth> InputsBeyondBits(const EdgeUnit& unit) {
  std::vector<EdgeWidth> inputs;
  for (const FoundWidth& found : FoundWidths(unit)) {
    for (int bits = kFewestEdgeBits; bits + 1 < found.width.bits; ++bits) {
      std::optional<EdgeWidth> triangle;
      if (found.width.form == "area") triangle = RightTriangleBeyond(unit, found, bits);
      EdgeWidth input = triangle ? *std::move(triangle) : InputBeyond(unit, found, bits);
      if (SignedBits(input.extreme, input.extreme) == bits + 1) inputs.push_back(std::move(input));
    }
  }
  return inputs;
}

Scene WitnessScene(const EdgeUnit& unit, const EdgeWidth& width) {
  const EdgeInput& e = width.witness;
  std::int64_t x = e.ax;
  std::int64_t y = e.ay;
  int worth = -1;
  if (width.form == "area") {  // its value is that of this very triangle
    return SceneOf(unit, width.id, {{{e.ax, e.ay}, {e.bx, e.by}, {e.px, e.py}}});
  }
  for (const std::int64_t cx : Candidates(unit, e.ax, e.bx, e.px)) {
    for (const std::int64_t cy : Candidates(unit, e.ay, e.by, e.py)) {
      const int now = WorthOf(width, cx, cy);
      if (now <= worth) continue;
      worth = now;
      x = cx;
      y = cy;
    }
  }
  return SceneOf(unit, width.id, {{{e.ax, e.ay}, {e.bx, e.by}, {x, y}}});
}

}  // namespace rasterproof::exact
