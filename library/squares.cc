#include "library/squares.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/own_precision.h"
#include "core/vertex.h"
#include "library/edge_squares.h"
#include "library/exact_sign.h"
#include "library/rasterize.h"

namespace rasterproof {
namespace {

using library::ColumnRange;
using library::EdgeSquares;

struct Corner {
  float x;
  float y;
  float z;

  Point2 Place() const { return {x, y}; }
};
using Corners = std::array<Corner, 3>;

// Calls act(corners) for each triangle that has an area, counter-clockwise on screen.
template <class Act>
void ForEachTriangle(const RasterMesh& mesh, const Act& act) {
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    Corners v{};
    bool is_finite = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const float* const from = mesh.positions.data() + std::size_t{3} * mesh.indices[t + k];
      v[k] = {from[0], from[1], from[2]};
      is_finite = is_finite && std::isfinite(v[k].x) && std::isfinite(v[k].y);
    }
    if (!is_finite) continue;
    const int turn = library::EdgeSign(v[0].Place(), v[1].Place(), v[2].Place());
    if (turn == 0) continue;
    if (turn < 0) std::swap(v[1], v[2]);
    act(v);
  }
}

// A place as a number; -0 is 0.
std::uint64_t KeyOf(const Corner& v) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(v.x + 0.0F)} << 32 |
         std::bit_cast<std::uint32_t>(v.y + 0.0F);
}
Point2 PlaceOf(std::uint64_t key) {
  return {std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32)),
          std::bit_cast<float>(static_cast<std::uint32_t>(key))};
}

struct ChainEdge {
  std::uint64_t from;
  std::uint64_t to;    // from < to; `turns` says which way it runs
  std::int64_t turns;  // 0: no edge

  bool IsAlong(const ChainEdge& other) const { return from == other.from && to == other.to; }
};

// Edges of which pairs of opposite ones cancel. Most meet their opposite soon, in a table that a
// cache holds; what is pushed out of it is sorted in the end.
class Outline {
 public:
  explicit Outline(std::size_t triangles)
      : table_(std::bit_ceil(
            static_cast<std::size_t>(16 * std::sqrt(static_cast<double>(triangles) + 16)))) {}

  void Add(const Corner& from, const Corner& to) {
    const std::uint64_t a = KeyOf(from);
    const std::uint64_t b = KeyOf(to);
    const ChainEdge edge{std::min(a, b), std::max(a, b), a < b ? 1 : -1};
    ChainEdge& slot = table_[SlotOf(edge)];
    if (slot.IsAlong(edge)) {
      slot.turns += edge.turns;
      return;
    }
    if (slot.turns != 0) pushed_out_.push_back(slot);
    slot = edge;
  }

  /// Calls act(a, b) for each edge that is left.
  template <class Act>
  void ForEach(const Act& act) {
    for (const ChainEdge& edge : table_) {
      if (edge.turns != 0) pushed_out_.push_back(edge);
    }
    std::ranges::sort(pushed_out_, {}, [](const ChainEdge& e) { return std::pair(e.from, e.to); });
    for (std::size_t k = 0; k < pushed_out_.size();) {
      const ChainEdge& edge = pushed_out_[k];
      std::int64_t turns = 0;
      for (; k < pushed_out_.size() && pushed_out_[k].IsAlong(edge); ++k) {
        turns += pushed_out_[k].turns;
      }
      if (turns != 0) act(PlaceOf(edge.from), PlaceOf(edge.to));
    }
  }

 private:
  std::size_t SlotOf(const ChainEdge& edge) const {
    const std::uint64_t mixed = (edge.from ^ edge.to * 0x9e3779b97f4a7c15) * 0xd6e8feb86659fd93;
    return static_cast<std::size_t>(mixed >> 32) & (table_.size() - 1);
  }

  std::vector<ChainEdge> table_;
  std::vector<ChainEdge> pushed_out_;
};

// Rows of bits, pixel x at bit x & 7 of byte x >> 3.
struct Bits {
  std::byte* memory;
  std::size_t pitch;

  std::byte* Row(int y) const { return memory + static_cast<std::size_t>(y) * pitch; }
  bool IsSet(int x, int y) const {
    return (Row(y)[x >> 3] >> (x & 7) & std::byte{1}) != std::byte{0};
  }
  // act(byte, mask) for each byte of which some of the columns' bits are.
  template <class Act>
  void ForEachByte(int y, ColumnRange columns, const Act& act) const {
    std::byte* const row = Row(y);
    for (int x = columns.first; x < columns.last;) {
      const int end = std::min(columns.last, (x | 7) + 1);
      act(row[x >> 3], static_cast<std::byte>((0xffU << (x & 7)) & (0xffU >> (-end & 7))));
      x = end;
    }
  }
  void Set(int y, ColumnRange columns) const {
    ForEachByte(y, columns, [](std::byte& byte, std::byte mask) { byte |= mask; });
  }
  void Empty(int y, ColumnRange columns) const {
    ForEachByte(y, columns, [](std::byte& byte, std::byte mask) { byte &= ~mask; });
  }
};

// Calls act(row, columns) for the squares that a triangle with area meets. In a row's strip it is
// as wide as its edges are there: it is convex.
template <class Act>
void ForEachRowOfSquares(const Corners& v, int width, int height, const Act& act) {
  std::array<std::optional<EdgeSquares>, 3> edges;
  int first = height;
  int end = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k].emplace(v[k].Place(), v[(k + 1) % 3].Place(), width, height);
    first = std::min(first, edges[k]->first_row());
    end = std::max(end, edges[k]->end_row());
  }
  for (int j = first; j < end; ++j) {
    ColumnRange all{width, 0};
    for (auto& edge : edges) {
      if (j < edge->first_row() || j >= edge->end_row()) continue;
      const ColumnRange columns = edge->At(j);
      all = {std::min(all.first, columns.first), std::max(all.last, columns.last)};
    }
    if (all.first < all.last) act(j, all);
  }
}

// Whether centres are covered, edges of the outline taken out.
struct InnerMask {
  std::vector<std::byte> memory;
  Bits bits;
};
InnerMask InnerMaskOf(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set) {
  RasterTarget mask{.output = RasterOutput::kMask,
                    .width = target.width,
                    .height = target.height,
                    .pitch = (static_cast<std::size_t>(target.width) + 7) / 8};
  InnerMask inner{std::vector<std::byte>(RoomFor(mask)), {}};
  inner.bits = {inner.memory.data(), mask.pitch};
  mask.memory = inner.memory;
  Rasterize(mesh, mask, set);
  Outline outline(mesh.indices.size() / 3);
  ForEachTriangle(mesh, [&](const Corners& v) {
    for (std::size_t k = 0; k < 3; ++k) outline.Add(v[k], v[(k + 1) % 3]);
  });
  outline.ForEach([&](Point2 a, Point2 b) {
    EdgeSquares edge(a, b, target.width, target.height);
    for (int j = edge.first_row(); j < edge.end_row(); ++j) inner.bits.Empty(j, edge.At(j));
  });
  return inner;
}

// Holds a real number: each operation is rounded to nearest, then moved out by a unit in the last
// place or more, so no error is left to bound. At least 2^-200, so that nothing is subnormal; at
// most 2^129 2^129 2^298 2^129 is computed of float32s, so nothing overflows.
struct Enclosure {
  double low;
  double high;

  static double Reach(double value) { return std::fabs(value) * 0x1p-52 + 0x1p-200; }
  static Enclosure Around(double low, double high) {
    return {low - Reach(low), high + Reach(high)};
  }
  friend Enclosure operator+(Enclosure a, Enclosure b) {
    return Around(a.low + b.low, a.high + b.high);
  }
  friend Enclosure operator-(Enclosure a, Enclosure b) {
    return Around(a.low - b.high, a.high - b.low);
  }
  friend Enclosure operator*(Enclosure a, Enclosure b) {
    const auto [least, most] =
        std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return Around(least, most);
  }
  // b.low > 0.
  friend Enclosure operator/(Enclosure a, Enclosure b) {
    const auto [least, most] =
        std::minmax({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
    return Around(least, most);
  }
};

float RoundedUp(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded >= value ? rounded
                          : std::nextafterf(rounded, std::numeric_limits<float>::infinity());
}

// The greatest z of a triangle's plane over a square, and at most that of its vertices.
class FarthestDepth {
 public:
  explicit FarthestDepth(const Corners& v) : v_(v), most_(std::max({v[0].z, v[1].z, v[2].z})) {
    is_finite_ = std::isfinite(v[0].z) && std::isfinite(v[1].z) && std::isfinite(v[2].z);
    const auto from_first = [&](float Corner::* member, std::size_t k) {
      return Of(v[k].*member) - Of(v[0].*member);
    };
    const Enclosure x1 = from_first(&Corner::x, 1), x2 = from_first(&Corner::x, 2);
    const Enclosure y1 = from_first(&Corner::y, 1), y2 = from_first(&Corner::y, 2);
    const Enclosure z1 = from_first(&Corner::z, 1), z2 = from_first(&Corner::z, 2);
    // Twice the area, positive: E of a counter-clockwise triangle.
    const Enclosure area = x2 * y1 - x1 * y2;
    has_plane_ = is_finite_ && area.low > 0;
    if (!has_plane_) return;
    dx_ = (z2 * y1 - z1 * y2) / area;
    dy_ = (x2 * z1 - x1 * z2) / area;
  }
  bool is_finite() const { return is_finite_; }
  void SetRow(int j) { row_ = Of(v_[0].z) + dy_ * Side(j, v_[0].y); }
  /// Over column i of the row that was set.
  float Over(int i) const {
    if (!has_plane_) return most_;
    const Enclosure z = row_ + dx_ * Side(i, v_[0].x);
    return z.high < most_ ? RoundedUp(z.high) : most_;
  }

 private:
  static Enclosure Of(float value) { return {value, value}; }
  static Enclosure Side(int from, float x) {
    return Enclosure{static_cast<double>(from), from + 1.0} - Of(x);
  }

  Corners v_;
  float most_;
  bool is_finite_ = false;
  bool has_plane_ = false;
  Enclosure dx_{};
  Enclosure dy_{};
  Enclosure row_{};
};

void DrawOuterMask(const RasterMesh& mesh, const RasterTarget& target) {
  const Bits bits{target.memory.data(), target.pitch};
  ForEachTriangle(mesh, [&](const Corners& v) {
    ForEachRowOfSquares(v, target.width, target.height,
                        [&](int j, ColumnRange columns) { bits.Set(j, columns); });
  });
}

void DrawInnerMask(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set) {
  const InnerMask inner = InnerMaskOf(mesh, target, set);
  const std::size_t row_bytes = inner.bits.pitch;
  for (int y = 0; y < target.height; ++y) {
    std::byte* const row = target.memory.data() + static_cast<std::size_t>(y) * target.pitch;
    for (std::size_t k = 0; k < row_bytes; ++k) row[k] |= inner.bits.Row(y)[k];
  }
}

void DrawInnerDepths(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set) {
  const InnerMask inner = InnerMaskOf(mesh, target, set);
  const auto width = static_cast<std::size_t>(target.width);
  std::vector<float> farthest(width * static_cast<std::size_t>(target.height),
                              -std::numeric_limits<float>::infinity());
  ForEachTriangle(mesh, [&](const Corners& v) {
    FarthestDepth depth(v);
    ForEachRowOfSquares(v, target.width, target.height, [&](int j, ColumnRange columns) {
      float* const row = farthest.data() + static_cast<std::size_t>(j) * width;
      if (!depth.is_finite()) inner.bits.Empty(j, columns);
      depth.SetRow(j);
      for (int i = columns.first; i < columns.last; ++i) {
        if (inner.bits.IsSet(i, j)) row[i] = std::max(row[i], depth.Over(i));
      }
    });
  });
  for (int y = 0; y < target.height; ++y) {
    auto* const row =
        reinterpret_cast<float*>(target.memory.data() + static_cast<std::size_t>(y) * target.pitch);
    const float* const from = farthest.data() + static_cast<std::size_t>(y) * width;
    for (int x = 0; x < target.width; ++x) {
      if (inner.bits.IsSet(x, y)) row[x] = std::min(row[x], from[x]);
    }
  }
}

}  // namespace

void DrawSquares(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set) {
  if (target.output == RasterOutput::kOuterMask) {
    DrawOuterMask(mesh, target);
  } else if (target.output == RasterOutput::kInnerMask) {
    DrawInnerMask(mesh, target, set);
  } else {
    DrawInnerDepths(mesh, target, set);
  }
}

}  // namespace rasterproof
