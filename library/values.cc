// Attributes over covered pixels: planes set up in double, rows filled by library/kernels.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/float_environment.h"
#include "core/own_precision.h"
#include "library/arguments.h"
#include "library/draw.h"
#include "library/kernels/kernel.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/value_table.h"
#include "library/nearest_value.h"
#include "library/rasterize.h"

namespace rasterproof {
namespace {

namespace kernels = library::kernels;

const kernels::ValueTable& ValuesOf(kernels::Target target) {
#if defined(__x86_64__)
  if (target == kernels::Target::kAvx512) return kernels::kAvx512Values;
  if (target == kernels::Target::kAvx2) return kernels::kAvx2Values;
#endif
  (void)target;
  return kernels::kScalarValues;
}

// a x + b y + c, and the sums of the magnitudes of the products that make each up.
struct Line {
  double a = 0, b = 0, c = 0;
  double a_reach = 0, b_reach = 0, c_reach = 0;

  void Add(const Line& line, double factor) {
    const double reach = std::fabs(factor);
    a += line.a * factor;
    b += line.b * factor;
    c += line.c * factor;
    a_reach += line.a_reach * reach;
    b_reach += line.b_reach * reach;
    c_reach += line.c_reach * reach;
  }
  bool IsNothing() const { return a_reach + b_reach + c_reach == 0; }
  kernels::ValuePlane Times(double scale) const {
    return {static_cast<float>(a * scale), static_cast<float>(b * scale),
            static_cast<float>(c * scale)};
  }
};

// At most 4 roundings to a coefficient (a difference of exact products, the product with the
// number, two sums), 3 to a x, b y and both sums: 7, and those of the reach.
constexpr double kLineError = 8 * 0x1p-53;

// n / d over columns [x0, x1) of a row as the kernel computes it.
struct ValueRow {
  double n_x, n_row, n_error;
  double d_x, d_row, d_error;

  ValueRow(const Line& n, const Line& d, int row, int x1)
      : n_x(n.a), n_row(n.c + n.b * (row + 0.5)), d_x(d.a), d_row(d.c + d.b * (row + 0.5)) {
    n_error = kLineError * (n.c_reach + n.b_reach * (row + 0.5) + n.a_reach * x1);
    d_error = kLineError * (d.c_reach + d.b_reach * (row + 0.5) + d.a_reach * x1);
  }

  // How many of its last places a quotient of columns [x0, x1) may be off, or -1 where that is not
  // bounded so. Both lines are least and greatest at an end of the span.
  std::int64_t Doubt(int x0, int x1) const {
    const double n0 = n_row + n_x * (x0 + 0.5);
    const double n1 = n_row + n_x * (x1 - 0.5);
    const double d0 = d_row + d_x * (x0 + 0.5);
    const double d1 = d_row + d_x * (x1 - 0.5);
    if (std::signbit(n0) != std::signbit(n1) || std::signbit(d0) != std::signbit(d1)) return -1;
    const double least_n = std::min(std::fabs(n0), std::fabs(n1));
    const double least_d = std::min(std::fabs(d0), std::fabs(d1));
    const double most_n = std::max(std::fabs(n0), std::fabs(n1));
    const double most_d = std::max(std::fabs(d0), std::fabs(d1));
    constexpr double kMostShare = 0x1p-28;  // of both: below 2^26 places
    const bool is_bounded = n_error < kMostShare * least_n && d_error < kMostShare * least_d;
    // No middle of subnormal floats, and none beyond the largest.
    const bool is_normal = least_n > 0x1p-125 * most_d && most_n < 0x1p127 * least_d;
    if (!is_bounded || !is_normal) return -1;
    const double share = n_error / least_n + d_error / least_d + kernels::kQuotientError;
    return static_cast<std::int64_t>(share * (1 + 0x1p-10) * 0x1p53) + 2;
  }
};

struct Channel {
  Line n;
  kernels::ValuePlane plane = {};
  kernels::ValuePlane d_plane = {};
  bool is_finite = true;
};

// One triangle after the other, each from its top row down.
class ValueDrawer {
 public:
  ValueDrawer(const RasterMesh& mesh, const RasterValues& values, const kernels::ValueTable& table)
      : mesh_(mesh),
        values_(values),
        table_(table),
        divides_(mesh.space != RasterSpace::kWindow &&
                 values.interpolation == RasterInterpolation::kPerspective),
        channels_(static_cast<std::size_t>(values.channels)) {}

  void Draw(const kernels::KernelSpan& span) {
    if (span.triangle != triangle_) SetUp(span.triangle);
    row_ = span.row;
    for (channel_ = 0; channel_ < channels_.size(); ++channel_) {
      const std::size_t plane = channel_ * static_cast<std::size_t>(values_.height);
      const std::size_t pixel = (plane + static_cast<std::size_t>(row_)) * values_.pitch +
                                static_cast<std::size_t>(span.x0);
      DrawRow(channels_[channel_], span, pixel);
    }
  }

 private:
  void SetUp(std::uint32_t triangle);
  void SetUpChannel(std::size_t channel);
  // The most that a line is over the target.
  double MostOf(const Line& line) const {
    return std::fabs(line.a) * values_.width + std::fabs(line.b) * values_.height +
           std::fabs(line.c);
  }
  void DrawRow(const Channel& channel, const kernels::KernelSpan& span, std::size_t pixel);
  void DrawNearest(const ValueRow& row, int x0, int x1, float* value);
  static float Decide(const void* drawer, int column) {
    const ValueDrawer& self = *static_cast<const ValueDrawer*>(drawer);
    return library::NearestValue(self.QuotientOf(self.channel_), column + 0.5, self.row_ + 0.5);
  }
  std::array<double, 3> NumbersOf(std::size_t channel) const {
    std::array<double, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = values_.numbers[corners_[k] * channels_.size() + channel];
      if (values_.interpolation == RasterInterpolation::kLinear) c[k] *= w_[k];
    }
    return c;
  }
  library::ValueQuotient QuotientOf(std::size_t channel) const {
    const bool is_linear = values_.interpolation == RasterInterpolation::kLinear;
    return {x_, y_, w_, NumbersOf(channel), is_linear ? w_ : std::array<double, 3>{1, 1, 1}};
  }

  const RasterMesh& mesh_;
  const RasterValues& values_;
  const kernels::ValueTable& table_;
  bool divides_;
  std::vector<Channel> channels_;
  // Of the triangle.
  std::uint32_t triangle_ = kNoTriangle;
  std::array<std::size_t, 3> corners_{};
  std::array<double, 3> x_{}, y_{}, w_{1, 1, 1};
  std::array<Line, 3> beta_{};
  Line d_;
  // Where it is.
  int row_ = 0;
  std::size_t channel_ = 0;
};

void ValueDrawer::SetUp(std::uint32_t triangle) {
  triangle_ = triangle;
  const std::size_t each = library::CoordinatesOf(mesh_.space);
  for (std::size_t k = 0; k < 3; ++k) {
    corners_[k] = mesh_.indices[std::size_t{3} * triangle + k];
    const float* const v = &mesh_.positions[each * corners_[k]];
    x_[k] = v[0];
    y_[k] = v[1];
    if (each == 4) w_[k] = v[3];
  }
  d_ = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto minor = [](double p, double q, double r, double s, double& of, double& reach) {
      of = p * q - r * s;
      reach = std::fabs(p * q) + std::fabs(r * s);
    };
    Line& beta = beta_[i];
    minor(y_[j], w_[k], w_[j], y_[k], beta.a, beta.a_reach);
    minor(w_[j], x_[k], x_[j], w_[k], beta.b, beta.b_reach);
    minor(x_[j], y_[k], y_[j], x_[k], beta.c, beta.c_reach);
  }
  if (values_.interpolation == RasterInterpolation::kPerspective && each == 4) {
    for (const Line& beta : beta_) d_.Add(beta, 1);
  } else {  // the determinant, by its first column
    const Line& beta = beta_[0];
    d_.c = beta.a * x_[0] + beta.b * y_[0] + beta.c * w_[0];
    d_.c_reach = beta.a_reach * std::fabs(x_[0]) + beta.b_reach * std::fabs(y_[0]) +
                 beta.c_reach * std::fabs(w_[0]);
  }
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) SetUpChannel(channel);
}

void ValueDrawer::SetUpChannel(std::size_t channel) {
  const std::array<double, 3> c = NumbersOf(channel);
  Channel& of = channels_[channel];
  of.is_finite = std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]);
  of.n = {};
  for (std::size_t i = 0; i < 3; ++i) of.n.Add(beta_[i], c[i]);
  // By a power of two, so that the greater of n and d is about 2^100 and the least part of the
  // other one a normal float; where nothing divides, by d itself.
  const double reach = std::max(MostOf(of.n), MostOf(d_));
  const bool is_scalable = reach > 0 && std::isfinite(reach);
  const double scale = !divides_     ? 1 / d_.c
                       : is_scalable ? std::ldexp(1, 100 - std::ilogb(reach))
                                     : 1;
  of.plane = of.n.Times(scale);
  of.d_plane = d_.Times(scale);
}

void ValueDrawer::DrawRow(const Channel& channel, const kernels::KernelSpan& span,
                          std::size_t pixel) {
  float* const value = &values_.values[pixel];
  const auto fill = [&](std::span<float> plane, float with) {
    if (!plane.empty()) std::fill_n(&plane[pixel], span.x1 - span.x0, with);
  };
  if (!channel.is_finite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto plane : {values_.values, values_.dx, values_.dy}) fill(plane, nan);
  } else if (values_.rounding == RasterRounding::kNearest) {
    if (channel.n.IsNothing()) {
      fill(values_.values, 0);
    } else {
      DrawNearest(ValueRow(channel.n, d_, span.row, span.x1), span.x0, span.x1, value);
    }
  } else {
    const bool has_derivatives = !values_.dx.empty();
    table_.values({channel.plane, channel.d_plane, divides_, span.row, span.x0, span.x1, value,
                   has_derivatives ? &values_.dx[pixel] : nullptr,
                   has_derivatives ? &values_.dy[pixel] : nullptr});
  }
}

void ValueDrawer::DrawNearest(const ValueRow& row, int x0, int x1, float* value) {
  const std::int64_t doubt = row.Doubt(x0, x1);
  constexpr int kLeast = 8;  // columns that are worth another try
  if (doubt >= 0) {
    table_.nearest({row.n_x, row.n_row, row.d_x, row.d_row, x0, x1, value, doubt, &Decide, this});
  } else if (x1 - x0 > kLeast) {
    const int middle = x0 + (x1 - x0) / 2;
    DrawNearest(row, x0, middle, value);
    DrawNearest(row, middle, x1, value + (middle - x0));
  } else {
    for (int x = x0; x < x1; ++x) value[x - x0] = Decide(this, x);
  }
}

void RequireNumbers(const RasterMesh& mesh, const RasterValues& values) {
  if (values.channels < 1 || values.channels > kMostRasterChannels) {
    throw InputError("values.channels", std::to_string(values.channels),
                     "give 1 to " + std::to_string(kMostRasterChannels));
  }
  const std::size_t numbers = library::VerticesOf(mesh) * static_cast<std::size_t>(values.channels);
  if (values.numbers.size() != numbers) {
    throw InputError("values.numbers", std::to_string(values.numbers.size()) + " of them",
                     "give values.channels of each vertex, " + std::to_string(numbers));
  }
  if (values.interpolation > RasterInterpolation::kLinear) {
    throw InputError("values.interpolation", "there is no such one",
                     "give one of RasterInterpolation");
  }
  if (values.rounding > RasterRounding::kNearest) {
    throw InputError("values.rounding", "there is no such one", "give one of RasterRounding");
  }
}

void RequirePlanes(const RasterMesh& mesh, const RasterValues& values) {
  const auto width = static_cast<std::size_t>(values.width);
  if (values.pitch < width) {
    throw InputError("values.pitch", std::to_string(values.pitch) + " pixels",
                     "give at least a row, " + std::to_string(width));
  }
  const std::size_t rows =
      static_cast<std::size_t>(values.channels) * static_cast<std::size_t>(values.height);
  const std::size_t least = (rows - 1) * values.pitch + width;
  const auto require = [&](const std::string& name, std::span<float> plane) {
    if (plane.size() < least) {
      throw InputError(name, std::to_string(plane.size()) + " numbers",
                       "give " + std::to_string(least));
    }
    library::RequireApart(mesh, name, std::as_bytes(plane));
  };
  require("values.values", values.values);
  if (values.dx.empty() && values.dy.empty()) return;
  if (values.rounding == RasterRounding::kNearest) {
    throw InputError("values.dx", "no derivative is correctly rounded",
                     "ask for derivatives by RasterRounding::kFast");
  }
  require("values.dx", values.dx);
  require("values.dy", values.dy);
}

}  // namespace

void RasterizeValues(const RasterMesh& mesh, const RasterValues& values, InstructionSet set) {
  library::RequireSize("values.", values.width, values.height);
  library::RequireMesh(mesh);
  const kernels::Target simd = library::RequireSet(set);
  RequireNumbers(mesh, values);
  RequirePlanes(mesh, values);
  const FloatEnvironment sane;
  ValueDrawer drawer(mesh, values, ValuesOf(simd));
  ValueDrawer* const state = &drawer;
  library::DrawSpans(
      mesh, values.width, values.height, simd,
      [](const void* of, const kernels::KernelSpan& span) {
        (*static_cast<ValueDrawer* const*>(of))->Draw(span);
      },
      static_cast<const void*>(&state));
}

}  // namespace rasterproof
