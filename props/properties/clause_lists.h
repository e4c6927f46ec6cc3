// The clauses that require what several properties state: ids of core/clauses/.
#ifndef RASTERPROOF_PROPS_PROPERTIES_CLAUSE_LISTS_H_
#define RASTERPROOF_PROPS_PROPERTIES_CLAUSE_LISTS_H_

#include <array>
#include <string_view>

namespace rasterproof::props {

// A sample off every edge is decided by all four; one on a shared edge by all but WebGPU.
inline constexpr auto kOneOwnerClauses = std::to_array<std::string_view>(
    {"gl.common-edge", "gl.point-sampling", "vulkan.common-edge", "vulkan.point-sampling",
     "d3d11.top-left", "d3d11.point-sampling", "webgpu.point-sampling"});
// A result is legal if one choice of places and owners explains it.
inline constexpr auto kLegalModelClauses = std::to_array<std::string_view>(
    {"gl.point-sampling", "gl.subpixel-bits", "gl.common-edge", "vulkan.point-sampling",
     "vulkan.subpixel-bits", "vulkan.common-edge", "d3d11.snap-tolerance", "d3d11.eight-bits",
     "d3d11.top-left", "d3d11.two-edges", "webgpu.point-sampling"});
// A device has one grid: calls that no grid explains together break the first, and a call that none
// explains by itself one of both.
inline constexpr auto kOneGridClauses = std::to_array<std::string_view>(
    {"gl.subpixel-bits", "gl.point-sampling", "vulkan.subpixel-bits", "vulkan.point-sampling"});
// Who has a sample on an edge, and what is required of all others: a drawing that no legal model
// explains breaks one of the two.
inline constexpr auto kEdgeOwnerClauses = std::to_array<std::string_view>(
    {"gl.common-edge", "vulkan.common-edge", "d3d11.top-left", "d3d11.two-edges"});
inline constexpr auto kPlacedSampleClauses = std::to_array<std::string_view>(
    {"gl.point-sampling", "gl.subpixel-bits", "vulkan.point-sampling", "vulkan.subpixel-bits",
     "d3d11.point-sampling", "d3d11.snap-tolerance", "d3d11.eight-bits", "webgpu.point-sampling"});
// At folds and silhouettes Direct3D's rule, which goes by position alone, is the only one that says
// who owns a sample.
inline constexpr auto kEveryEdgeClauses =
    std::to_array<std::string_view>({"d3d11.top-left", "d3d11.two-edges"});
inline constexpr auto kIndependentClauses =
    std::to_array<std::string_view>({"webgpu.independent-primitives"});
inline constexpr auto kScissorClauses = std::to_array<std::string_view>(
    {"gl.scissor", "vulkan.scissor", "d3d11.scissor", "webgpu.scissor"});
inline constexpr auto kRepeatableClauses =
    std::to_array<std::string_view>({"gl.repeatability", "vulkan.repeatability"});
inline constexpr auto kInsideTheTargetClauses =
    std::to_array<std::string_view>({"gl.framebuffer-bounds", "gl.no-termination",
                                     "vulkan.no-termination", "d3d11.scissor", "webgpu.scissor"});
inline constexpr auto kNanClauses = std::to_array<std::string_view>({"d3d11.nan"});
inline constexpr auto kZeroAreaClauses = std::to_array<std::string_view>({"d3d11.zero-area"});
inline constexpr auto kPoisonClauses =
    std::to_array<std::string_view>({"d3d11.nan", "webgpu.independent-primitives"});
inline constexpr auto kTranslationClauses = std::to_array<std::string_view>({"gl.translation"});
inline constexpr auto kOrderClauses =
    std::to_array<std::string_view>({"gl.command-order", "vulkan.rasterization-order"});
inline constexpr auto kFacingClauses = std::to_array<std::string_view>(
    {"gl.facing", "vulkan.facing", "d3d11.cull-after-snap", "webgpu.facing"});
inline constexpr auto kCentroidClauses = std::to_array<std::string_view>(
    {"gl.centroid", "vulkan.centroid", "d3d11.centroid", "webgpu.centroid"});
// Where the subject states its error: of exact barycentrics all four speak.
inline constexpr auto kBarycentricErrorClauses = std::to_array<std::string_view>(
    {"gl.barycentric", "vulkan.barycentric", "d3d11.interpolator", "webgpu.barycentric"});
// Where the subject states its error: formulas of exact numbers.
inline constexpr auto kClipBarycentricErrorClauses = std::to_array<std::string_view>(
    {"gl.barycentric", "gl.perspective", "vulkan.barycentric-inputs", "d3d11.perspective",
     "d3d11.interpolator", "webgpu.barycentric", "webgpu.interpolation"});
inline constexpr auto kValueErrorClauses = std::to_array<std::string_view>(
    {"gl.perspective", "gl.linear", "vulkan.perspective", "vulkan.linear", "d3d11.perspective",
     "d3d11.no-perspective", "d3d11.interpolator", "webgpu.barycentric", "webgpu.interpolation"});
inline constexpr auto kDepthErrorClauses =
    std::to_array<std::string_view>({"gl.depth", "vulkan.depth", "d3d11.depth", "webgpu.depth"});
inline constexpr auto kDepthFormatErrorClauses = std::to_array<std::string_view>(
    {"gl.depth-conversion", "vulkan.depth-conversion", "d3d11.depth-conversion"});
// Whatever the error of values: copied numbers, and differences of the subject's own.
inline constexpr auto kFlatClauses =
    std::to_array<std::string_view>({"gl.flat", "gl.provoking", "vulkan.flat", "vulkan.provoking",
                                     "d3d11.flat", "d3d11.leading-vertex", "webgpu.flat"});
inline constexpr auto kFineDifferenceClauses =
    std::to_array<std::string_view>({"vulkan.derivative-fine", "d3d11.derivative-fine"});
// Pixels as squares: what is met must be covered, what is held may be.
inline constexpr auto kSquaresMetClauses =
    std::to_array<std::string_view>({"gl.nv-conservative", "vulkan.overestimate",
                                     "d3d12.must-cover", "pdf.fill", "gdal.all-touched"});
inline constexpr auto kSquaresThatMustBeClauses = std::to_array<std::string_view>(
    {"gl.nv-conservative", "vulkan.overestimate", "d3d12.must-cover", "d3d12.flat-tier-2",
     "d3d12.inner-omission", "pdf.fill", "pdf.empty-interior", "gdal.all-touched"});
inline constexpr auto kSquaresHeldClauses =
    std::to_array<std::string_view>({"vulkan.underestimate", "d3d12.inner-coverage"});
inline constexpr auto kSquaresThatMayBeClauses = std::to_array<std::string_view>(
    {"vulkan.underestimate", "d3d12.may-cover-tier-1", "d3d12.may-cover-tier-2",
     "d3d12.inner-coverage", "pdf.shape", "pdf.fill", "gdal.all-touched"});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_CLAUSE_LISTS_H_
