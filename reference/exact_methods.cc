// The methods of the table that are exact for every finite input.
#include <vector>

#include "reference/draw.h"
#include "reference/edge_values.h"
#include "reference/edge_walks.h"
#include "reference/filtered_form.h"
#include "reference/method_rows.h"
#include "reference/spans.h"

namespace rasterproof::reference {
namespace {

void DrawSceneBySpans(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  ForEachTriangle(scene, options, counts, [&](const TriangleTask& task) {
    DrawSpans(task.v, task.clip, options.cull, counts);
  });
}

Method ExactMethod(std::string_view name, std::string_view summary,
                   void (*draw)(const Scene&, const RasterOptions&, CoverageCounts&)) {
  static const ExactEdgeValues edge_values;
  Method method = WindowMethod(name, summary, Precision::kFloat64);
  method.info.claims_exact = true;
  method.draw = draw;
  method.edges = &edge_values;
  return method;
}

}  // namespace

std::vector<Method> ExactMethods() {
  return {
      ExactMethod("spans-exact",
                  "the crossing of each edge and row, guessed in double and corrected exactly",
                  &DrawSceneBySpans),
      ExactMethod("filtered-exact",
                  "a filter in double at every sample, exact arithmetic where it can't tell",
                  &DrawScene<FreshWalk<FilteredForm>>),
  };
}

}  // namespace rasterproof::reference
