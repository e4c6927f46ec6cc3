// The fixed-point methods of the table.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/box.h"
#include "reference/edge_values.h"
#include "reference/edge_walks.h"
#include "reference/fill.h"
#include "reference/integer_form.h"
#include "reference/method_rows.h"
#include "reference/proved.h"
#include "reference/spans.h"

namespace rasterproof::reference {
namespace {

template <class Form>
bool FitsForm(const Corners3& v) {
  return std::ranges::all_of(v, [](const Vertex& p) { return Form::Fits(WindowPoint(p)); });
}

template <class Form>
std::optional<Corners3> PlaceOnGrid(const Corners3& given) {
  std::optional<Corners3> v = PlaceAsGiven(given);
  if (!v) return v;
  for (Vertex& vertex : *v) {
    const Point2 p = Form::Snapped(WindowPoint(vertex));
    vertex.x = p.x;
    vertex.y = p.y;
  }
  return v;
}

// What leaves the integers' proven domain is drawn by the exact spans of its snapped vertices, so
// that no input overflows or is lost.
template <class Form>
int IntegerFacing(const Corners3& v, const RasterOptions& options) {
  return FitsForm<Form>(v) ? FacingBy<Form>(v, options) : ExactFacing(v, options);
}
template <class Form>
void FillIntegers(const Corners3& v, const RasterOptions& options, const FillTarget& to) {
  if (FitsForm<Form>(v)) {
    FillByWalk<RowWalk<Form>>(v, options, to);
  } else {
    FillSpans(v, options, to);
  }
}

template <class I, int kBits>
Method IntegerMethod(std::string_view name, std::string_view summary) {
  using Form = IntegerForm<I, kBits>;
  static const IntegerEdgeValues<I, kBits> edge_values;
  Method method =
      WindowMethod(name, summary, Precision::kFloat64, Form::kSnap, kIntegerCoordinateLimit<I>);
  method.info.states_exact = true;
  method.info.proofs = IntegerProofs();
  method.stages.place = &PlaceOnGrid<Form>;
  method.stages.facing = &IntegerFacing<Form>;
  method.stages.fill = &FillIntegers<Form>;
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
