// What each rival draws, pixel for pixel: plain loops over one number at a time, for tests.
#ifndef RASTERPROOF_TESTS_LIBRARY_RIVAL_DEFINITIONS_H_
#define RASTERPROOF_TESTS_LIBRARY_RIVAL_DEFINITIONS_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "library/rivals/rival.h"
#include "tests/library/drawn_scenes.h"
#include "tests/library/kernel_definitions.h"

namespace rasterproof::library::rivals {

using kernels::Covered;
using kernels::KernelTriangle;
using kernels::KernelVertex;

namespace definitions {

struct Box {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  bool IsEmpty() const { return x0 >= x1 || y0 >= y1; }
  bool IsSmall() const { return x1 - x0 <= 8 && y1 - y0 <= 8; }
};

enum class Form { kDirect, kAffine, kStepped };

inline Form FormOf(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::kFloat32Affine:
    case Arithmetic::kFloat64Affine:
      return Form::kAffine;
    case Arithmetic::kFloat32Stepped:
    case Arithmetic::kFloat64Stepped:
      return Form::kStepped;
    case Arithmetic::kFloat32Direct:
    case Arithmetic::kFloat64Direct:
    case Arithmetic::kInt32:
    case Arithmetic::kInt64:
    case Arithmetic::kUnchecked:
      break;
  }
  return Form::kDirect;
}

inline int FirstCentreFrom(float v, int size) {
  return static_cast<int>(std::clamp(std::ceil(v - 0.5F), 0.0F, static_cast<float>(size)));
}
inline int FirstCentreBeyond(float v, int size) {
  return static_cast<int>(std::clamp(std::floor(v - 0.5F) + 1.0F, 0.0F, static_cast<float>(size)));
}
template <class T>
T Centre(int pixel) {
  return static_cast<T>(pixel) + T{0.5};
}

/// Sorts by y. Returns whether corners were swapped an odd number of times.
inline bool SortByY(KernelTriangle& t) {
  bool odd = false;
  for (const std::size_t k : std::array<std::size_t, 3>{0, 1, 0}) {
    if (!(t[k + 1].y < t[k].y)) continue;
    std::swap(t[k], t[k + 1]);
    odd = !odd;
  }
  return odd;
}

template <class T>
T TwiceArea(const KernelTriangle& t) {
  const auto x = [&](std::size_t k) { return static_cast<T>(t[k].x); };
  const auto y = [&](std::size_t k) { return static_cast<T>(t[k].y); };
  return (x(2) - x(0)) * (y(1) - y(0)) - (y(2) - y(0)) * (x(1) - x(0));
}

/// Three edge functions, positive inside, with their values in each form.
template <class T>
struct RealEdges {
  Form form;
  Box box;
  std::array<T, 3> vx{}, vy{}, a{}, b{}, c{}, least{};

  RealEdges(const KernelTriangle& t, bool is_front, int width, int height, Form of) : form(of) {
    const KernelTriangle v = is_front ? t : KernelTriangle{t[0], t[2], t[1]};
    const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
    box = {FirstCentreFrom(x_min, width), FirstCentreBeyond(x_max, width),
           FirstCentreFrom(y_min, height), FirstCentreBeyond(y_max, height)};
    for (std::size_t k = 0; k < 3; ++k) {
      const KernelVertex& next = v[(k + 1) % 3];
      vx[k] = v[k].x;
      vy[k] = v[k].y;
      a[k] = static_cast<T>(next.y) - vy[k];
      b[k] = vx[k] - static_cast<T>(next.x);
      c[k] = -(vx[k] * a[k] + vy[k] * b[k]);
      const bool owns_ties = a[k] > 0 || (a[k] == 0 && b[k] > 0);
      least[k] = owns_ties ? 0 : std::numeric_limits<T>::min();
    }
  }
  /// The direct form, which the stepped one starts from.
  T First(std::size_t k, int x, int y) const {
    return (Centre<T>(x) - vx[k]) * a[k] + (Centre<T>(y) - vy[k]) * b[k];
  }
  /// At the pixel (x, y), stepped from (x0, y0).
  std::array<T, 3> At(int x, int y, int x0, int y0) const {
    std::array<T, 3> e{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (form == Form::kDirect) {
        e[k] = First(k, x, y);
      } else if (form == Form::kAffine) {
        e[k] = a[k] * Centre<T>(x) + (b[k] * Centre<T>(y) + c[k]);
      } else {
        e[k] = (First(k, x0, y0) + b[k] * static_cast<T>(y - y0)) + a[k] * static_cast<T>(x - x0);
      }
    }
    return e;
  }
};

template <class T>
bool AllReach(const std::array<T, 3>& e, const std::array<T, 3>& least) {
  return e[0] >= least[0] && e[1] >= least[1] && e[2] >= least[2];
}

inline void Incremental(const RealEdges<float>& edges, Covered& covered) {
  const Box& box = edges.box;
  std::array<float, 3> row{};
  for (std::size_t k = 0; k < 3; ++k) row[k] = edges.First(k, box.x0, box.y0);
  for (int y = box.y0; y < box.y1; ++y) {
    std::vector<bool> inside;
    for (int x = box.x0; x < box.x1; ++x) {
      const int column = x - box.x0;
      std::array<float, 3> e{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (box.IsSmall()) {
          e[k] = row[k];
          for (int i = 0; i < column; ++i) e[k] += edges.a[k];
        } else {
          e[k] = row[k] + edges.a[k] * static_cast<float>(column % 32);
          for (int i = 0; i < column / 32; ++i) e[k] += edges.a[k] * 32.0F;
        }
      }
      inside.push_back(AllReach(e, edges.least));
    }
    // The row ends where 32 consecutive pixels are outside after some that are inside.
    bool was_inside = false;
    for (std::size_t from = 0; from < inside.size(); from += 32) {
      const std::size_t to = std::min(from + 32, inside.size());
      bool any = false;
      for (std::size_t i = from; i < to; ++i) {
        any |= inside[i];
        if (inside[i]) covered.pixels.emplace_back(box.x0 + static_cast<int>(i), y);
      }
      if (was_inside && !any) break;
      was_inside |= any;
    }
    for (std::size_t k = 0; k < 3; ++k) row[k] += edges.b[k];
  }
}

/// The tile whose first pixel is (x, y); (x0, y0) is the first tile's.
template <class T>
void Tile(const RealEdges<T>& edges, int x, int y, int x0, int y0, Covered& covered) {
  const Box& box = edges.box;
  const std::array<T, 3> t = edges.At(x, y, x0, y0);
  std::array<T, 3> reject{}, accept{};
  for (std::size_t k = 0; k < 3; ++k) {
    const T a = edges.a[k];
    const T b = edges.b[k];
    reject[k] = edges.least[k] - (7 * std::max(a, T{0}) + 7 * std::max(b, T{0}));
    accept[k] = edges.least[k] - (7 * std::min(a, T{0}) + 7 * std::min(b, T{0}));
  }
  if (!AllReach(t, reject)) return;
  const bool all = AllReach(t, accept);
  for (int j = y; j < y + 8; ++j) {
    for (int i = x; i < x + 8; ++i) {
      if (i < box.x0 || i >= box.x1 || j < box.y0 || j >= box.y1) continue;
      std::array<T, 3> e = edges.At(i, j, x0, y0);
      for (std::size_t k = 0; k < 3 && edges.form == Form::kStepped; ++k) {
        e[k] = t[k] + (static_cast<T>(i - x) * edges.a[k] + static_cast<T>(j - y) * edges.b[k]);
      }
      if (all || AllReach(e, edges.least)) covered.pixels.emplace_back(i, j);
    }
  }
}

template <class T>
void Tiles(const RealEdges<T>& edges, Covered& covered) {
  const Box& box = edges.box;
  if (!box.IsSmall()) {
    for (int y = box.y0 & ~7; y < box.y1; y += 8) {
      for (int x = box.x0 & ~7; x < box.x1; x += 8) {
        Tile(edges, x, y, box.x0 & ~7, box.y0 & ~7, covered);
      }
    }
    return;
  }
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      if (AllReach(edges.At(x, y, box.x0, box.y0), edges.least)) covered.pixels.emplace_back(x, y);
    }
  }
}

template <class T>
void Spans(KernelTriangle t, Form form, int width, int height, Covered& covered) {
  SortByY(t);
  const auto [x_min, x_max] = std::minmax({t[0].x, t[1].x, t[2].x});
  const int x0 = FirstCentreFrom(x_min, width);
  const int x1 = FirstCentreFrom(x_max, width);
  const int end = FirstCentreFrom(t[2].y, height);
  for (int row = FirstCentreFrom(t[0].y, height); row < end; ++row) {
    const T y = Centre<T>(row);
    const auto crossing = [&](const KernelVertex& from, const KernelVertex& to) {
      const T ax = from.x, ay = from.y, bx = to.x, by = to.y;
      const T slope = (bx - ax) / (by - ay);
      const auto along = [&](T start, T below) {
        return sizeof(T) == sizeof(double) ? std::fma(below, slope, start) : start + below * slope;
      };
      T at = along(ax - T{0.5}, y - ay);
      if (form == Form::kAffine) at = along(along(ax - T{0.5}, -ay), y);
      if (form == Form::kStepped) {
        const T first = Centre<T>(FirstCentreFrom(from.y, height));
        at = along(along(ax - T{0.5}, first - ay), y - first);
      }
      if (std::isnan(at)) return x0;
      return static_cast<int>(std::clamp(std::ceil(at), static_cast<T>(x0), static_cast<T>(x1)));
    };
    const int one = crossing(t[0], t[2]);
    const int other = y < t[1].y ? crossing(t[0], t[1]) : crossing(t[1], t[2]);
    for (int x = std::min(one, other); x < std::max(one, other); ++x) {
      covered.pixels.emplace_back(x, row);
    }
  }
}

/// A triangle snapped to 1/256 px, nearest-even.
struct Snapped {
  bool is_in_range = true;
  std::array<std::int64_t, 3> x{}, y{};
  std::int64_t area = 0;

  explicit Snapped(const KernelTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(std::abs(t[k].x) <= kFixedRange && std::abs(t[k].y) <= kFixedRange)) {
        is_in_range = false;
        return;
      }
      x[k] = std::llrint(static_cast<double>(t[k].x) * 256);
      y[k] = std::llrint(static_cast<double>(t[k].y) * 256);
    }
    area = (x[2] - x[0]) * (y[1] - y[0]) - (y[2] - y[0]) * (x[1] - x[0]);
  }
};

/// Tiles of integers: what the snapped triangle covers.
inline Covered FixedTiles(const KernelTriangle& t, int width, int height) {
  Covered covered;
  Snapped s(t);
  if (!s.is_in_range || s.area == 0) return covered;
  covered.is_front = s.area > 0;
  if (s.area < 0) {
    std::swap(s.x[1], s.x[2]);
    std::swap(s.y[1], s.y[2]);
  }
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t a = s.y[(k + 1) % 3] - s.y[k];
        const std::int64_t b = s.x[k] - s.x[(k + 1) % 3];
        const std::int64_t e = (256 * i + 128 - s.x[k]) * a + (256 * j + 128 - s.y[k]) * b;
        inside &= e > 0 || (e == 0 && (a > 0 || (a == 0 && b > 0)));
      }
      if (inside) covered.pixels.emplace_back(i, j);
    }
  }
  return covered;
}

/// Spans of integers: crossings in 1/2^32 px.
inline Covered FixedSpans(const KernelTriangle& t, int width, int height) {
  Covered covered;
  Snapped s(t);
  if (!s.is_in_range || s.area == 0) return covered;
  covered.is_front = s.area > 0;
  for (const std::size_t k : std::array<std::size_t, 3>{0, 1, 0}) {
    if (s.y[k + 1] >= s.y[k]) continue;
    std::swap(s.y[k], s.y[k + 1]);
    std::swap(s.x[k], s.x[k + 1]);
  }
  const auto first_centre = [](std::int64_t v, int size) {
    return static_cast<int>(std::clamp<std::int64_t>((v + 127) >> 8, 0, size));
  };
  const auto [x_min, x_max] = std::minmax({s.x[0], s.x[1], s.x[2]});
  const int x0 = first_centre(x_min, width);
  const int x1 = first_centre(x_max, width);
  const int end = first_centre(s.y[2], height);
  for (int row = first_centre(s.y[0], height); row < end; ++row) {
    const auto crossing = [&](std::size_t a, std::size_t b) {
      const int first = first_centre(s.y[a], height);
      const double slope =
          static_cast<double>(s.x[b] - s.x[a]) / static_cast<double>(s.y[b] - s.y[a]);
      const double below = static_cast<double>(256 * first + 128 - s.y[a]);
      const std::int64_t start =
          s.x[a] * (1 << 24) + std::llrint(below * slope * 0x1p24) + 0x7fffffff;
      const std::int64_t at = start + (row - first) * static_cast<std::int64_t>(slope * 0x1p32);
      return std::clamp(static_cast<int>(at >> 32), x0, x1);
    };
    const int one = crossing(0, 2);
    const int other = 256 * std::int64_t{row} + 128 < s.y[1] ? crossing(0, 1) : crossing(1, 2);
    for (int x = std::min(one, other); x < std::max(one, other); ++x) {
      covered.pixels.emplace_back(x, row);
    }
  }
  return covered;
}

/// The rival of clip space.
inline Covered Homogeneous(const std::array<kernels::ClipVertex, 3>& v, int width, int height) {
  Covered covered;
  std::array<float, 3> a{}, b{}, c{};
  for (std::size_t k = 0; k < 3; ++k) {
    const kernels::ClipVertex& i = v[k];
    const kernels::ClipVertex& j = v[(k + 1) % 3];
    a[k] = j.y * i.w - j.w * i.y;
    b[k] = j.w * i.x - j.x * i.w;
    c[k] = j.x * i.y - j.y * i.x;
  }
  const float area = (a[0] * v[2].x + b[0] * v[2].y) + c[0] * v[2].w;
  if (!(std::abs(area) > 0) || std::isinf(area)) return covered;
  covered.is_front = area > 0;
  const float sign = covered.is_front ? 1 : -1;
  const auto [least_w, most_w] = std::minmax({v[0].w, v[1].w, v[2].w});
  if (!(most_w > 0)) return covered;
  int x0 = 0, y0 = 0, x1 = width, y1 = height;
  if (least_w > 0) {
    const std::array<float, 3> x{v[0].x / v[0].w, v[1].x / v[1].w, v[2].x / v[2].w};
    const std::array<float, 3> y{v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w};
    x0 = FirstCentreFrom(std::ranges::min(x), width);
    x1 = FirstCentreFrom(std::ranges::max(x), width);
    y0 = FirstCentreFrom(std::ranges::min(y), height);
    y1 = FirstCentreFrom(std::ranges::max(y), height);
  }
  for (int row = y0; row < y1; ++row) {
    int first = x0, last = x1;
    for (std::size_t k = 0; k < 3; ++k) {
      if (a[k] != 0) {
        const float at = std::ceil((-(c[k] / a[k]) - 0.5F) + Centre<float>(row) * -(b[k] / a[k]));
        const int column =
            std::isnan(at)
                ? x0
                : static_cast<int>(std::clamp(at, static_cast<float>(x0), static_cast<float>(x1)));
        (a[k] > 0) == covered.is_front ? first = std::max(first, column)
                                       : last = std::min(last, column);
        continue;
      }
      const int cut = FirstCentreFrom(-(c[k] / b[k]), height);
      const float down = sign * b[k];
      const bool inside = down > 0 ? row >= cut : down < 0 ? row < cut : sign * c[k] > 0;
      if (!inside) last = first;
    }
    for (int x = first; x < last; ++x) covered.pixels.emplace_back(x, row);
  }
  return covered;
}

}  // namespace definitions

template <class T>
Covered DefineReal(const Rival& rival, const KernelTriangle& t, int width, int height) {
  const definitions::Form form = definitions::FormOf(rival.arithmetic);
  Covered covered;
  const bool is_spans =
      rival.traversal == Traversal::kSpans || rival.traversal == Traversal::kMaskTiles;
  KernelTriangle of_area = t;  // spans in float64 have it of the sorted corners
  const bool odd = is_spans && sizeof(T) == sizeof(double) && definitions::SortByY(of_area);
  const T area = definitions::TwiceArea<T>(of_area);
  if (area == 0 || !std::isfinite(area)) return covered;
  covered.is_front = (area > 0) != odd;
  if (is_spans) {
    definitions::Spans<T>(t, form, width, height, covered);
    return covered;
  }
  const definitions::RealEdges<T> edges(t, covered.is_front, width, height, form);
  if (edges.box.IsEmpty()) return covered;
  if constexpr (sizeof(T) == sizeof(float)) {
    if (rival.traversal == Traversal::kRows) {
      definitions::Incremental(edges, covered);
      return covered;
    }
  }
  definitions::Tiles(edges, covered);
  return covered;
}

/// What the rival covers of a target by one triangle.
///
/// Domain:     not kTwin.
inline Covered Define(const Rival& rival, const KernelTriangle& t, int width, int height) {
  switch (rival.arithmetic) {
    case Arithmetic::kFloat32Direct:
    case Arithmetic::kFloat32Affine:
    case Arithmetic::kFloat32Stepped:
      return DefineReal<float>(rival, t, width, height);
    case Arithmetic::kFloat64Direct:
    case Arithmetic::kFloat64Affine:
    case Arithmetic::kFloat64Stepped:
      return DefineReal<double>(rival, t, width, height);
    case Arithmetic::kInt32:
    case Arithmetic::kInt64:
    case Arithmetic::kUnchecked:
      break;
  }
  return rival.traversal == Traversal::kSpans ? definitions::FixedSpans(t, width, height)
                                              : definitions::FixedTiles(t, width, height);
}

}  // namespace rasterproof::library::rivals

#endif  // RASTERPROOF_TESTS_LIBRARY_RIVAL_DEFINITIONS_H_
