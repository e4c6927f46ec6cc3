#include "library/rasterize.h"

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
#include "library/arguments.h"
#include "library/draw.h"
#include "library/kernels/kernel.h"
#include "library/kernels/kernel_table.h"
#include "library/squares.h"

namespace rasterproof {
namespace {

namespace kernels = library::kernels;

using library::BytesOfRows;
using library::Plane;
using library::PlanesOf;
using library::RequireMesh;
using library::RequireSet;
using library::RequireSize;
using library::RequireTarget;
using library::RowBytes;
using library::TargetsOf;
using library::UnitOf;

// What the kernels' vectors read and rewrite: see library/kernels/sinks.h.
constexpr std::size_t kRoomRows = 7;
constexpr std::size_t kRoomPixels = 64;

kernels::Sink SinkOf(RasterOutput output) {
  constexpr std::array kSinks{kernels::Sink::kCount8, kernels::Sink::kFacing, kernels::Sink::kMask,
                              kernels::Sink::kId, kernels::Sink::kDepth};
  return kSinks[static_cast<std::size_t>(output)];
}

kernels::KernelView ViewOf(const RasterMesh& mesh, int width, int height) {
  kernels::KernelView view{};
  view.vertices = mesh.positions.data();
  view.indices = mesh.indices.data();
  view.triangles = mesh.indices.size() / 3;
  view.width = width;
  view.height = height;
  constexpr std::array kNearPlanes{kernels::NearPlane::kNone, kernels::NearPlane::kNone,
                                   kernels::NearPlane::kZero, kernels::NearPlane::kMinusW};
  view.near_plane = kNearPlanes[static_cast<std::size_t>(mesh.space)];
  return view;
}

void DrawView(const RasterMesh& mesh, kernels::Target simd, kernels::Sink sink,
              const kernels::KernelView& view) {
  if (mesh.space == RasterSpace::kWindow) {
    kernels::DrawExact(simd, sink, view);
  } else {
    kernels::DrawClip(simd, sink, view);
  }
}

// How many rows have room below them and after them.
int RowsWithRoom(const RasterTarget& target) {
  std::array<Plane, 2> both;
  std::size_t bytes = target.memory.size();
  for (const Plane& plane : PlanesOf(target, both)) bytes = std::min(bytes, plane.size());
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

void library::DrawSpans(const RasterMesh& mesh, int width, int height, kernels::Target simd,
                        void (*on_span)(const void* state, const kernels::KernelSpan& span),
                        const void* state) {
  kernels::KernelView view = ViewOf(mesh, width, height);
  view.on_span = on_span;
  view.state = state;
  if (mesh.space == RasterSpace::kWindow) {
    kernels::DrawExactSpans(simd, view);
  } else {
    kernels::DrawClipSpans(simd, view);
  }
}

bool library::HasRoom(const RasterTarget& target) { return RowsWithRoom(target) == target.height; }

void library::Draw(const RasterMesh& mesh, const RasterTarget& target, kernels::Target simd) {
  const kernels::Sink sink = SinkOf(target.output);

  const FloatEnvironment sane;
  std::array<Plane, 2> both;
  const auto planes = PlanesOf(target, both);
  const int direct = RowsWithRoom(target);
  std::vector<LastRows> last;
  if (direct < target.height) {
    for (const Plane& plane : planes) last.emplace_back(target, plane, direct);
  }

  kernels::KernelView view = ViewOf(mesh, target.width, direct);
  if (direct > 0) {
    for (std::size_t k = 0; k < planes.size(); ++k) view.planes[k] = planes[k].data();
    view.pitch = PitchInUnits(target, target.pitch);
    DrawView(mesh, simd, sink, view);
  }
  if (last.empty()) return;
  view.first_row = direct;
  view.height = target.height;
  for (std::size_t k = 0; k < last.size(); ++k) view.planes[k] = last[k].Plane(direct);
  view.pitch = PitchInUnits(target, last.front().pitch());
  DrawView(mesh, simd, sink, view);
  for (LastRows& rows : last) rows.PutBack();
}

void Rasterize(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set) {
  const kernels::Target simd = library::RequireAllButIndices(mesh, target, set);
  library::RequireIndices(mesh);
  if (IsOfSquares(target.output)) {
    const FloatEnvironment sane;
    DrawSquares(mesh, target, set);
  } else {
    library::Draw(mesh, target, simd);
  }
}

void Rasterize(const RasterMesh& mesh, int width, int height,
               const std::function<void(const RasterSpan&)>& on_span, InstructionSet set) {
  RequireSize("", width, height);
  RequireMesh(mesh);
  if (!on_span) throw InputError("on_span", "empty", "give a function to call");
  const kernels::Target simd = RequireSet(set);
  const FloatEnvironment sane;
  library::DrawSpans(
      mesh, width, height, simd,
      [](const void* state, const kernels::KernelSpan& span) {
        (*static_cast<const std::function<void(const RasterSpan&)>*>(state))(
            {span.triangle, span.is_front, span.row, span.x0, span.x1});
      },
      &on_span);
}

void MarkEmptyTriangles(const RasterMesh& mesh, int width, int height,
                        std::span<std::uint8_t> is_empty, InstructionSet set) {
  if (is_empty.data() == nullptr && !is_empty.empty()) {
    throw InputError("is_empty", "null", "give a byte for each triangle");
  }
  if (is_empty.size() != mesh.indices.size() / 3) {
    throw InputError("is_empty", std::to_string(is_empty.size()) + " bytes",
                     "give one for each triangle");
  }
  RequireSize("", width, height);
  RequireMesh(mesh);
  library::RequireApart(mesh, "is_empty", std::as_bytes(is_empty));
  const kernels::Target simd = RequireSet(set);
  std::ranges::fill(is_empty, std::uint8_t{1});
  const FloatEnvironment sane;
  library::DrawSpans(
      mesh, width, height, simd,
      [](const void* state, const kernels::KernelSpan& span) {
        (*static_cast<const std::span<std::uint8_t>*>(state))[span.triangle] = 0;
      },
      &is_empty);
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
