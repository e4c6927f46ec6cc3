// The fixed-point methods of the table.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "reference/draw.h"
#include "reference/edge_values.h"
#include "reference/edge_walks.h"
#include "reference/integer_form.h"
#include "reference/method_rows.h"
#include "reference/proved.h"
#include "reference/spans.h"

namespace rasterproof::reference {
namespace {

/// Snaps each triangle and draws it in integers; one that leaves the integers' proven domain is
/// drawn by the exact spans of its snapped vertices, so that no input overflows or is lost.
template <class I, int kBits>
void DrawSnapped(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  using Form = IntegerForm<I, kBits>;
  ForEachTriangle(scene, options, counts, [&](TriangleTask task) {
    for (Point2& p : task.v) p = Form::Snapped(p);
    if (std::ranges::all_of(task.v, Form::Fits)) {
      DrawBox<RowWalk<Form>, TieRule::kTopLeft>(task, options, counts);
    } else {
      DrawSpans(task.v, task.clip, options.cull, counts);
    }
  });
}

template <class I, int kBits>
Method IntegerMethod(std::string_view name, std::string_view summary) {
  static const IntegerEdgeValues<I, kBits> edge_values;
  Method method = WindowMethod(name, summary, Precision::kFloat64, IntegerForm<I, kBits>::kSnap,
                               kIntegerCoordinateLimit<I>);
  method.info.claims_exact = true;
  method.info.proofs = IntegerProofs();
  method.draw = &DrawSnapped<I, kBits>;
  method.edges = &edge_values;
  return method;
}

}  // namespace

std::vector<Method> IntegerMethods() {
  return {
      IntegerMethod<std::int32_t, 4>(
          "i32-snap4", "snapped to 1/16 pixel, 32-bit integers; exact spans beyond 1440 pixels"),
      IntegerMethod<std::int64_t, 8>(
          "i64-snap8", "snapped to 1/256 pixel, 64-bit integers; exact spans beyond 2^22 pixels"),
  };
}

}  // namespace rasterproof::reference
