// The methods of the table that are exact for every finite input.
#include <vector>

#include "reference/edge_values.h"
#include "reference/edge_walks.h"
#include "reference/fill.h"
#include "reference/filtered_form.h"
#include "reference/method_rows.h"
#include "reference/spans.h"

namespace rasterproof::reference {
namespace {

Method ExactMethod(std::string_view name, std::string_view summary, decltype(Stages::fill) fill) {
  static const ExactEdgeValues edge_values;
  Method method = WindowMethod(name, summary, Precision::kFloat64);
  method.info.states_exact = true;
  method.stages.facing = &ExactFacing;
  method.stages.fill = fill;
  method.edges = &edge_values;
  return method;
}

}  // namespace

std::vector<Method> ExactMethods() {
  return {
      ExactMethod("spans-exact",
                  "the crossing of each edge and row, guessed in double and corrected exactly",
                  &FillSpans),
      ExactMethod("filtered-exact",
                  "a filter in double at every sample, exact arithmetic where it can't tell",
                  &FillByWalk<FreshWalk<FilteredForm>>),
  };
}

}  // namespace rasterproof::reference
