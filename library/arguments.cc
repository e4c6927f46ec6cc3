#include "library/arguments.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "library/kernels/kernel.h"
#include "library/rasterize.h"

namespace rasterproof::library {

namespace {

constexpr int kMostPixels = 65536;
constexpr std::size_t kMostVertices = std::size_t{1} << 29;
bool IsMask(RasterOutput output) {
  return output == RasterOutput::kMask || output == RasterOutput::kInnerMask ||
         output == RasterOutput::kOuterMask;
}

std::string Text(std::size_t n) { return std::to_string(n); }

void RequirePitch(const RasterTarget& target) {
  const std::size_t unit = UnitOf(target.output);
  if (target.pitch < RowBytes(target)) {
    throw InputError("target.pitch", Text(target.pitch) + " bytes, less than a row's",
                     "give at least " + Text(RowBytes(target)));
  }
  if (target.pitch % unit != 0) {
    throw InputError("target.pitch", Text(target.pitch) + " bytes, not a multiple of a pixel's",
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

std::span<const std::byte> RowsOf(const RasterTarget& target, const Plane& plane) {
  return plane.first(BytesOfRows(target));
}

bool Overlap(std::span<const std::byte> a, std::span<const std::byte> b) {
  const std::less<const std::byte*> less;
  return less(a.data(), b.data() + b.size()) && less(b.data(), a.data() + a.size());
}

template <class T>
void RequireTuples(const std::string& name, std::size_t each, std::span<const T> values) {
  if (values.data() == nullptr && !values.empty()) {
    throw InputError(name, "null", "give the values, or none");
  }
  if (values.size() % each != 0) {
    throw InputError(name, Text(values.size()) + " of them",
                     std::string("give ") + (each == 3 ? "three" : "four") + " of each");
  }
  if (std::bit_cast<std::uintptr_t>(values.data()) % alignof(T) != 0) {
    throw InputError(name, "not aligned", "align it to " + Text(alignof(T)) + " bytes");
  }
}

void RequireShape(const RasterMesh& mesh) {
  if (mesh.space > RasterSpace::kClipNearMinusW) {
    throw InputError("mesh.space", "there is no such space", "give one of RasterSpace");
  }
  RequireTuples("mesh.positions", CoordinatesOf(mesh.space), mesh.positions);
  RequireTuples("mesh.indices", 3, mesh.indices);
  const std::size_t vertices = VerticesOf(mesh);
  if (vertices > kMostVertices) {
    throw InputError("mesh.positions", Text(vertices) + " vertices",
                     "draw parts of at most " + Text(kMostVertices));
  }
  if (mesh.indices.size() / 3 >= kNoTriangle) {
    throw InputError("mesh.indices", Text(mesh.indices.size() / 3) + " triangles",
                     "draw parts of fewer than " + Text(kNoTriangle));
  }
}

constexpr std::array<std::string_view, 6> kNames{"", "scalar", "sse4", "avx2", "avx512", "neon"};

}  // namespace

std::size_t CoordinatesOf(RasterSpace space) { return space == RasterSpace::kWindow ? 3 : 4; }

std::size_t VerticesOf(const RasterMesh& mesh) {
  return mesh.positions.size() / CoordinatesOf(mesh.space);
}

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

std::span<const Plane> PlanesOf(const RasterTarget& target, std::array<Plane, 2>& planes) {
  planes = {target.memory, target.back};
  return std::span(planes).first(target.output == RasterOutput::kFacingCounts ? 2 : 1);
}

void RequireSize(const std::string& place, int width, int height) {
  for (const auto& [name, side] : {std::pair("width", width), std::pair("height", height)}) {
    if (side >= 1 && side <= kMostPixels) continue;
    throw InputError(place + name, std::to_string(side) + " pixels",
                     "give 1 to " + std::to_string(kMostPixels));
  }
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
    throw InputError("target.back", "only facing counts have one", "leave it empty");
  }
  RequirePlane(target, "target.back", target.back);
  if (Overlap(RowsOf(target, target.memory), RowsOf(target, target.back))) {
    throw InputError("target.back", "it overlaps target.memory", "give memory of its own");
  }
}

void RequireApart(const RasterMesh& mesh, const std::string& name,
                  std::span<const std::byte> memory) {
  const auto require = [&](const std::string& of_mesh, std::span<const std::byte> values) {
    if (memory.empty() || values.empty() || !Overlap(memory, values)) return;
    throw InputError(name, "it overlaps " + of_mesh, "give memory of its own");
  };
  require("mesh.positions", std::as_bytes(mesh.positions));
  require("mesh.indices", std::as_bytes(mesh.indices));
}

bool HaveVertices(const RasterMesh& mesh, std::size_t first, std::size_t end) {
  std::uint32_t most = 0;
  for (const std::uint32_t index : mesh.indices.subspan(3 * first, 3 * (end - first))) {
    most = std::max(most, index);
  }
  return first == end || most < VerticesOf(mesh);
}

void RequireIndices(const RasterMesh& mesh) {
  if (HaveVertices(mesh, 0, mesh.indices.size() / 3)) return;
  const std::size_t vertices = VerticesOf(mesh);
  const auto first = std::ranges::find_if(mesh.indices, [&](auto i) { return i >= vertices; });
  throw InputError(
      "mesh.indices[" + Text(static_cast<std::size_t>(first - mesh.indices.begin())) + "]",
      Text(*first) + ", and there are " + Text(vertices) + " vertices",
      "give indices of positions");
}

void RequireMesh(const RasterMesh& mesh) {
  RequireShape(mesh);
  RequireIndices(mesh);
}

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

kernels::Target RequireAllButIndices(const RasterMesh& mesh, const RasterTarget& target,
                                     InstructionSet set) {
  RequireTarget(target);
  RequireShape(mesh);
  if (target.output >= RasterOutput::kInnerMask && mesh.space != RasterSpace::kWindow) {
    throw InputError("target.output", "squares need window space",
                     "give a mesh of window space, or ask for an output of centres");
  }
  std::array<Plane, 2> both;
  const auto planes = PlanesOf(target, both);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    RequireApart(mesh, k == 0 ? "target.memory" : "target.back", RowsOf(target, planes[k]));
  }
  return RequireSet(set);
}

}  // namespace rasterproof::library
