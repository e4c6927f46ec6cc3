// What the library's calls are given: sizes of targets, and what is refused.
#ifndef RASTERPROOF_LIBRARY_ARGUMENTS_H_
#define RASTERPROOF_LIBRARY_ARGUMENTS_H_

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "library/kernels/kernel.h"
#include "library/rasterize.h"

namespace rasterproof::library {

/// Bytes of a pixel; of eight in a mask.
std::size_t UnitOf(RasterOutput output);
/// Bytes of a row, and of all rows from the first to the last one's last pixel.
std::size_t RowBytes(const RasterTarget& target);
std::size_t BytesOfRows(const RasterTarget& target);

/// memory, and back where the output has one.
using Plane = std::span<std::byte>;
std::span<const Plane> PlanesOf(const RasterTarget& target, std::array<Plane, 2>& planes);

/// Of each vertex; and how many vertices there are.
std::size_t CoordinatesOf(RasterSpace space);
std::size_t VerticesOf(const RasterMesh& mesh);

/// Each throws InputError, which names the argument and the remedy.
void RequireSize(const std::string& place, int width, int height);
void RequireTarget(const RasterTarget& target);
void RequireMesh(const RasterMesh& mesh);
library::kernels::Target RequireSet(InstructionSet set);
/// All of a call that draws into memory, but the values of indices.
library::kernels::Target RequireAllButIndices(const RasterMesh& mesh, const RasterTarget& target,
                                              InstructionSet set);
void RequireIndices(const RasterMesh& mesh);
void RequireApart(const RasterMesh& mesh, const std::string& name,
                  std::span<const std::byte> memory);
/// Whether triangles [first, end) have indices of positions.
bool HaveVertices(const RasterMesh& mesh, std::size_t first, std::size_t end);

/// Those of the kernels that bear the set's name: one or none.
std::span<const library::kernels::Target> TargetsOf(InstructionSet set);

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_ARGUMENTS_H_
