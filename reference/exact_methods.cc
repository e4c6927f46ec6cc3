// The methods of the table that are exact for every finite input.
#include <utility>
#include <vector>

#include "reference/edge_values.h"
#include "reference/edge_walks.h"
#include "reference/fill.h"
#include "reference/filtered_form.h"
#include "reference/method_rows.h"
#include "reference/proved.h"
#include "reference/spans.h"
#include "reference/whole_scene.h"

namespace rasterproof::reference {
namespace {

Method ExactMethod(std::string_view name, std::string_view summary, decltype(Stages::fill) fill,
                   std::vector<Proof> proofs) {
  static const ExactEdgeValues edge_values;
  Method method = WindowMethod(name, summary, Precision::kFloat64);
  method.info.states_exact = true;
  method.info.proofs = std::move(proofs);
  method.stages.facing = &ExactFacing;
  method.stages.fill = fill;
  method.edges = &edge_values;
  return method;
}

// What float32 holds goes to the exact kernel: the same crossings, many edges at a time.
bool DrawWhole(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  if (!KernelsPay(scene) || !KernelsTake(scene)) return false;
  DrawByKernel(scene, options, counts);
  return true;
}

Method SpansMethod() {
  Method method =
      ExactMethod("spans-exact",
                  "the crossing of each edge and row, guessed and corrected exactly: float32 by "
                  "vectors, the rest in double",
                  &FillSpans, CrossingProofs());
  method.whole = &DrawWhole;
  return method;
}

}  // namespace

std::vector<Method> ExactMethods() {
  return {
      SpansMethod(),
      ExactMethod("filtered-exact",
                  "a filter in double at every sample, exact arithmetic where it can't tell",
                  &FillByWalk<FreshWalk<FilteredForm>>, FilterProofs()),
  };
}

}  // namespace rasterproof::reference
