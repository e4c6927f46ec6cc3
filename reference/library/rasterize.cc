#include "kit/rasterize.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/float_environment.h"
#include "core/own_precision.h"
#include "reference/kernels/kernel.h"
#include "reference/kernels/kernel_table.h"
#include "reference/library/squares.h"

namespace rasterproof {
namespace {

namespace kernels = reference::kernels;

constexpr int kMostPixels = 65536;
constexpr std::size_t kMostVertices = std::size_t{1} << 29;
// What the kernels' vectors read and rewrite: see reference/kernels/sinks.h.
constexpr std::size_t kRoomRows = 7;
constexpr std::size_t kRoomPixels = 64;

kernels::Sink SinkOf(RasterOutput output) {
  constexpr std::array kSinks{kernels::Sink::kCount8, kernels::Sink::kFacing, kernels::Sink::kMask,
                              kernels::Sink::kId, kernels::Sink::kDepth};
  return kSinks[static_cast<std::size_t>(output)];
}

bool IsMask(RasterOutput output) {
  return output == RasterOutput::kMask || output == RasterOutput::kInnerMask ||
         output == RasterOutput::kOuterMask;
}

// Of a pixel, of eight in a mask.
std::size_t UnitOf(RasterOutput output) {
  return output == RasterOutput::kCounts || IsMask(output) ? 1 : sizeof(float);
}

std::size_t RowBytes(const RasterTarget& target) {
  const auto width = static_cast<std::size_t>(target.width);
  return IsMask(target.output) ? (width + 7) / 8 : width * UnitOf(target.output);
}

std::size_t BytesOfRows(const RasterTarget& target) {
  return static_cast<std::size_t>(target.height - 1) * target.pitch + RowBytes(target);
}

std::string Text(std::size_t n) { return std::to_string(n); }

void RequireSize(const std::string& place, int width, int height) {
  for (const auto& [name, side] : {std::pair("width", width), std::pair("height", height)}) {
    if (side >= 1 && side <= kMostPixels) continue;
    throw InputError(place + name, std::to_string(side) + " pixels",
                     "give 1 to " + std::to_string(kMostPixels));
  }
}

void RequirePitch(const RasterTarget& target) {
  const std::size_t unit = UnitOf(target.output);
  if (target.pitch < RowBytes(target)) {
    throw InputError("target.pitch", Text(target.pitch) + " bytes, less than a row's",
                     "give at least " + Text(RowBytes(target)));
  }
  if (target.pitch % unit != 0) {
    throw InputError("target.pitch", Text(target.pitch) + " bytes, not of whole pixels",
                     "give a multiple of " + Text(unit));
  }
}

void RequirePlane(const RasterTarget& target, const std::string& name, std::span<std::byte> plane) {
  if (plane.data() == nullptr) {
    throw InputError(name, "null", "give the memory that pixels are drawn into");
  }
  const auto rows = static_cast<std::size_t>(target.height - 1);
  const std::size_t row = RowBytes(target);
  if (plane.size() < row || (rows > 0 && target.pitch > (plane.size() - row) / rows)) {
    throw InputError(name, Text(plane.size()) + " bytes, less than its rows take",
                     "give height - 1 times the pitch and " + Text(row) + " for the last row");
  }
  if (std::bit_cast<std::uintptr_t>(plane.data()) % UnitOf(target.output) != 0) {
    throw InputError(name, "not aligned", "align it to " + Text(UnitOf(target.output)) + " bytes");
  }
}

// One or two.
using Plane = std::span<std::byte>;
std::span<const Plane> PlanesOf(const RasterTarget& target, std::array<Plane, 2>& planes) {
  planes = {target.memory, target.back};
  return std::span(planes).first(target.output == RasterOutput::kFacingCounts ? 2 : 1);
}

std::span<const std::byte> RowsOf(const RasterTarget& target, const Plane& plane) {
  return plane.first(BytesOfRows(target));
}

bool Overlap(std::span<const std::byte> a, std::span<const std::byte> b) {
  const std::less<const std::byte*> less;
  return less(a.data(), b.data() + b.size()) && less(b.data(), a.data() + a.size());
}

void RequireTarget(const RasterTarget& target) {
  if (target.output > RasterOutput::kInnerDepths) {
    throw InputError("target.output", "there is no such output", "give one of RasterOutput");
  }
  RequireSize("target.", target.width, target.height);
  RequirePitch(target);
  RequirePlane(target, "target.memory", target.memory);
  if (target.output != RasterOutput::kFacingCounts) {
    if (target.back.empty()) return;
    throw InputError("target.back", "facing counts alone have one", "leave it empty");
  }
  RequirePlane(target, "target.back", target.back);
  if (Overlap(RowsOf(target, target.memory), RowsOf(target, target.back))) {
    throw InputError("target.back", "it overlaps target.memory", "give memory of its own");
  }
}

template <class T>
void RequireTriples(const std::string& name, std::span<const T> values) {
  if (values.data() == nullptr && !values.empty()) {
    throw InputError(name, "null", "give the values, or none");
  }
  if (values.size() % 3 != 0) {
    throw InputError(name, Text(values.size()) + " of them", "give three of each");
  }
  if (std::bit_cast<std::uintptr_t>(values.data()) % alignof(T) != 0) {
    throw InputError(name, "not aligned", "align it to " + Text(alignof(T)) + " bytes");
  }
}

void RequireMesh(const RasterMesh& mesh) {
  RequireTriples("mesh.positions", mesh.positions);
  RequireTriples("mesh.indices", mesh.indices);
  const std::size_t vertices = mesh.positions.size() / 3;
  if (vertices > kMostVertices) {
    throw InputError("mesh.positions", Text(vertices) + " vertices",
                     "draw parts of at most " + Text(kMostVertices));
  }
  if (mesh.indices.size() / 3 >= kNoTriangle) {
    throw InputError("mesh.indices", Text(mesh.indices.size() / 3) + " triangles",
                     "draw parts of fewer than " + Text(kNoTriangle));
  }
}

void RequireApart(const RasterMesh& mesh, const RasterTarget& target) {
  std::array<Plane, 2> both;
  const auto planes = PlanesOf(target, both);
  const auto require = [&](const std::string& name, std::span<const std::byte> values) {
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (values.empty() || !Overlap(RowsOf(target, planes[k]), values)) continue;
      throw InputError(k == 0 ? "target.memory" : "target.back", "it overlaps " + name,
                       "give memory of its own");
    }
  };
  require("mesh.positions", std::as_bytes(mesh.positions));
  require("mesh.indices", std::as_bytes(mesh.indices));
}

void RequireIndices(const RasterMesh& mesh) {
  const std::size_t vertices = mesh.positions.size() / 3;
  std::uint32_t most = 0;
  for (const std::uint32_t index : mesh.indices) most = std::max(most, index);
  if (mesh.indices.empty() || most < vertices) return;
  const auto first = std::ranges::find_if(mesh.indices, [&](auto i) { return i >= vertices; });
  throw InputError(
      "mesh.indices[" + Text(static_cast<std::size_t>(first - mesh.indices.begin())) + "]",
      Text(*first) + ", and there are " + Text(vertices) + " vertices",
      "give indices of positions");
}

constexpr std::array<std::string_view, 6> kNames{"", "scalar", "sse4", "avx2", "avx512", "neon"};

// Those of the kernels that bear the set's name: one or none.
std::span<const kernels::Target> TargetsOf(InstructionSet set) {
  const auto all = kernels::SupportedTargets();
  if (set == InstructionSet::kBest) return all.last(1);
  const auto index = static_cast<std::size_t>(set);
  if (index >= kNames.size()) return {};
  for (const kernels::Target& target : all) {
    if (kernels::NameOf(target) == kNames[index]) return {&target, 1};
  }
  return {};
}

kernels::Target RequireSet(InstructionSet set) {
  const auto found = TargetsOf(set);
  if (!found.empty()) return found.front();
  throw InputError("set", "this machine or this build does not run it",
                   "give kBest, or ask IsSupported");
}

kernels::KernelView ViewOf(const RasterMesh& mesh, int width, int height) {
  kernels::KernelView view{};
  view.vertices = mesh.positions.data();
  view.indices = mesh.indices.data();
  view.triangles = mesh.indices.size() / 3;
  view.width = width;
  view.height = height;
  return view;
}

// How many rows have room below and behind them in memory of so many bytes.
int RowsWithRoom(const RasterTarget& target, std::size_t bytes) {
  const std::size_t behind = kRoomPixels * UnitOf(target.output);
  const std::size_t rows = bytes < behind ? 0 : (bytes - behind) / target.pitch;
  return static_cast<int>(
      std::min(rows - std::min(rows, kRoomRows), static_cast<std::size_t>(target.height)));
}

// The last rows of a plane, with room.
class LastRows {
 public:
  LastRows(const RasterTarget& target, std::span<std::byte> plane, int first_row)
      : row_bytes_(RowBytes(target)),
        pitch_((row_bytes_ + 3) / 4 * 4),
        from_pitch_(target.pitch),
        from_(plane.data() + static_cast<std::size_t>(first_row) * target.pitch),
        rows_(static_cast<std::size_t>(target.height - first_row)),
        copy_((rows_ + kRoomRows) * pitch_ + kRoomPixels * UnitOf(target.output)) {
    ForEachRow([&](std::byte* copy, std::byte* from) { std::memcpy(copy, from, row_bytes_); });
  }
  void PutBack() {
    ForEachRow([&](std::byte* copy, std::byte* from) { std::memcpy(from, copy, row_bytes_); });
  }
  std::size_t pitch() const { return pitch_; }
  /// Where row 0 would be.
  void* Plane(int first_row) {
    const auto skipped = static_cast<std::size_t>(first_row) * pitch_;
    return std::bit_cast<void*>(std::bit_cast<std::uintptr_t>(copy_.data()) - skipped);
  }

 private:
  template <class Do>
  void ForEachRow(const Do& act) {
    for (std::size_t row = 0; row < rows_; ++row) {
      act(copy_.data() + row * pitch_, from_ + row * from_pitch_);
    }
  }

  std::size_t row_bytes_;
  std::size_t pitch_;
  std::size_t from_pitch_;
  std::byte* from_;
  std::size_t rows_;
  std::vector<std::byte> copy_;
};

std::ptrdiff_t PitchInUnits(const RasterTarget& target, std::size_t pitch) {
  return static_cast<std::ptrdiff_t>(pitch / UnitOf(target.output));
}

}  // namespace

bool IsSupported(InstructionSet set) { return !TargetsOf(set).empty(); }

std::size_t RoomFor(const RasterTarget& target) {
  return (static_cast<std::size_t>(target.height) + kRoomRows) * target.pitch +
         kRoomPixels * UnitOf(target.output);
}

void Rasterize(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set) {
  RequireTarget(target);
  RequireMesh(mesh);
  RequireApart(mesh, target);
  RequireIndices(mesh);
  const kernels::Target simd = RequireSet(set);
  const FloatEnvironment sane;
  if (IsOfSquares(target.output)) {
    DrawSquares(mesh, target, set);
    return;
  }
  const kernels::Sink sink = SinkOf(target.output);

  std::array<Plane, 2> both;
  const auto planes = PlanesOf(target, both);
  std::size_t bytes = target.memory.size();
  for (const Plane& plane : planes) bytes = std::min(bytes, plane.size());
  const int direct = RowsWithRoom(target, bytes);
  std::vector<LastRows> last;
  if (direct < target.height) {
    for (const Plane& plane : planes) last.emplace_back(target, plane, direct);
  }

  kernels::KernelView view = ViewOf(mesh, target.width, direct);
  if (direct > 0) {
    for (std::size_t k = 0; k < planes.size(); ++k) view.planes[k] = planes[k].data();
    view.pitch = PitchInUnits(target, target.pitch);
    kernels::DrawExact(simd, sink, view);
  }
  if (last.empty()) return;
  view.first_row = direct;
  view.height = target.height;
  for (std::size_t k = 0; k < last.size(); ++k) view.planes[k] = last[k].Plane(direct);
  view.pitch = PitchInUnits(target, last.front().pitch());
  kernels::DrawExact(simd, sink, view);
  for (LastRows& rows : last) rows.PutBack();
}

void Rasterize(const RasterMesh& mesh, int width, int height,
               const std::function<void(const RasterSpan&)>& on_span, InstructionSet set) {
  RequireSize("", width, height);
  RequireMesh(mesh);
  RequireIndices(mesh);
  if (!on_span) throw InputError("on_span", "empty", "give a function to call");
  const kernels::Target simd = RequireSet(set);
  kernels::KernelView view = ViewOf(mesh, width, height);
  view.on_span = [](const void* state, const kernels::KernelSpan& span) {
    (*static_cast<const std::function<void(const RasterSpan&)>*>(state))(
        {span.triangle, span.is_front, span.row, span.x0, span.x1});
  };
  view.state = &on_span;
  const FloatEnvironment sane;
  kernels::DrawExactSpans(simd, view);
}

void MarkEmptyTriangles(const RasterMesh& mesh, int width, int height,
                        std::span<std::uint8_t> is_empty, InstructionSet set) {
  if (is_empty.size() != mesh.indices.size() / 3) {
    throw InputError("is_empty", Text(is_empty.size()) + " bytes", "give one for each triangle");
  }
  RequireSize("", width, height);
  RequireMesh(mesh);
  RequireIndices(mesh);
  const kernels::Target simd = RequireSet(set);
  std::ranges::fill(is_empty, std::uint8_t{1});
  kernels::KernelView view = ViewOf(mesh, width, height);
  view.on_span = [](const void* state, const kernels::KernelSpan& span) {
    (*static_cast<const std::span<std::uint8_t>*>(state))[span.triangle] = 0;
  };
  view.state = &is_empty;
  const FloatEnvironment sane;
  kernels::DrawExactSpans(simd, view);
}

void Clear(const RasterTarget& target) {
  RequireTarget(target);
  std::array<Plane, 2> both;
  for (const Plane& plane : PlanesOf(target, both)) {
    for (int y = 0; y < target.height; ++y) {
      std::byte* const row = plane.data() + static_cast<std::size_t>(y) * target.pitch;
      if (target.output == RasterOutput::kDepths || target.output == RasterOutput::kInnerDepths) {
        std::fill_n(reinterpret_cast<float*>(row), target.width,
                    std::numeric_limits<float>::infinity());
      } else {
        const int value = target.output == RasterOutput::kIds ? 0xff : 0;
        std::memset(row, value, RowBytes(target));
      }
    }
  }
}

}  // namespace rasterproof
