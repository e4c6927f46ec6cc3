// Drawers and parameters as rows of a result.
#ifndef RASTERPROOF_BENCH_CASE_DRAWERS_H_
#define RASTERPROOF_BENCH_CASE_DRAWERS_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "bench/contender.h"
#include "bench/parameter.h"
#include "bench/scene_drawer.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

/// The parameter's index in the result, where it is added if it is not there.
std::uint32_t ParameterIn(BenchResult& result, const BenchParameter& parameter);
std::uint32_t ParameterIn(BenchResult& result, const Parameter& parameter);

/// The index of the method with the name, target and sink; it is added if there is none.
std::uint32_t MethodIn(BenchResult& result, const BenchMethod& method);

/// Whether `names` holds the name, or none at all.
bool IsAsked(std::string_view name, std::span<const std::string> names);

/// Calls for the first contender of each name that draws triangles alone; the baseline's twin is
/// left out, and so is what `names` does not name, unless it is empty. From `end` on, as
/// WallSeconds(), it calls no more: `what` of the others was not measured.
/// Methods that the result lacks are added.
void ForEachDrawer(std::span<const std::unique_ptr<Contender>> contenders,
                   std::span<const std::string> names, double end, const std::string& what,
                   BenchResult& result,
                   const std::function<void(SceneDrawer& drawer, std::uint32_t method)>& call);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CASE_DRAWERS_H_
