// Attributes over covered pixels: what is asked for, drawn by library/kernels.
#include <array>
#include <cstddef>
#include <functional>
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

float Decide(const kernels::ValueDrawing& v, std::size_t channel, int column, int row) {
  library::ValueQuotient q{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t corner = v.indices[std::size_t{3} * v.triangle + k];
    const float* const at = &v.positions[v.coordinates * corner];
    q.x[k] = at[0];
    q.y[k] = at[1];
    q.w[k] = v.coordinates == 4 ? at[3] : 1;
    q.c[k] = v.numbers[corner * v.channels + channel];
    q.e[k] = v.is_linear ? q.w[k] : 1;
    q.c[k] *= q.e[k];
  }
  return library::NearestValue(q, column + 0.5, row + 0.5);
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

namespace library {

void DrawValues(const RasterMesh& mesh, const RasterValues& values, kernels::Target simd,
                const std::function<void(void (*)(const void*, const kernels::KernelSpan&),
                                         const void*)>& for_each_span) {
  const auto channels = static_cast<std::size_t>(values.channels);
  const bool is_nearest = values.rounding == RasterRounding::kNearest;
  std::vector<kernels::ValueChannel> of_channels(channels);
  constexpr std::size_t kBeyond = 16;  // the last vector of a row
  std::vector<double> reciprocals(
      is_nearest && channels > 1 ? static_cast<std::size_t>(values.width) + kBeyond : 0);
  kernels::ValueDrawing drawing{};
  drawing.positions = mesh.positions.data();
  drawing.indices = mesh.indices.data();
  drawing.coordinates = CoordinatesOf(mesh.space);
  drawing.numbers = values.numbers.data();
  drawing.channels = channels;
  // In the window both are the same.
  drawing.is_linear = values.interpolation == RasterInterpolation::kLinear;
  drawing.width = values.width;
  drawing.height = values.height;
  drawing.pitch = values.pitch;
  drawing.values = values.values.data();
  drawing.dx = values.dx.empty() ? nullptr : values.dx.data();
  drawing.dy = values.dy.empty() ? nullptr : values.dy.data();
  drawing.decide = &Decide;
  drawing.of_channels = of_channels.data();
  drawing.reciprocals = reciprocals.data();
  drawing.triangle = kNoTriangle;
  kernels::ValueDrawing* const state = &drawing;
  const kernels::ValueTable& table = ValuesOf(simd);
  for_each_span(is_nearest ? table.nearest : table.fast, static_cast<const void*>(&state));
}

}  // namespace library

void RasterizeValues(const RasterMesh& mesh, const RasterValues& values, InstructionSet set) {
  library::RequireSize("values.", values.width, values.height);
  library::RequireMesh(mesh);
  const kernels::Target simd = library::RequireSet(set);
  RequireNumbers(mesh, values);
  RequirePlanes(mesh, values);
  const FloatEnvironment sane;
  library::DrawValues(mesh, values, simd, [&](auto* on_span, const void* state) {
    library::DrawSpans(mesh, values.width, values.height, simd, on_span, state);
  });
}

}  // namespace rasterproof
