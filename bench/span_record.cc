#include "bench/span_record.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/float_environment.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {

namespace kernels = library::kernels;

SpanRecord::SpanRecord(kernels::Target target, const kernels::KernelScene& scene) {
  Record(scene, &kernels::DrawExactSpans, target);
}

SpanRecord::SpanRecord(kernels::Target target, const kernels::ClipScene& scene) {
  Record(scene, &kernels::DrawClipSpans, target);
}

template <class SomeScene>
void SpanRecord::Record(const SomeScene& scene, void (*draw)(kernels::Target, kernels::KernelView),
                        kernels::Target target) {
  const FloatEnvironment sane;
  SpanRecord* const record = this;
  kernels::KernelView view = kernels::ViewOf(scene);
  view.state = static_cast<const void*>(&record);
  view.on_span = [](const void* state, const kernels::KernelSpan& span) {
    (*static_cast<SpanRecord* const*>(state))->Add(span);
  };
  draw(target, view);
  FinishTriangle();
}

void SpanRecord::Add(const kernels::KernelSpan& span) {
  if (!spans_.empty() && spans_.back().triangle != span.triangle) FinishTriangle();
  spans_.push_back(span);
}

void SpanRecord::FinishTriangle() {
  if (spans_.empty()) return;
  kernels::KnownTriangle& t = triangles_.emplace_back();
  t.triangle = spans_.front().triangle;
  t.is_front = spans_.front().is_front;
  t.y = spans_.front().row;
  t.x = std::ranges::min(spans_, {}, &kernels::KernelSpan::x0).x0;
  t.width = std::ranges::max(spans_, {}, &kernels::KernelSpan::x1).x1 - t.x;
  const int height = spans_.back().row + 1 - t.y;
  constexpr int kSmall = 8;
  if (t.width > kSmall || height > kSmall) t.rows = height;
  for (const kernels::KernelSpan& span : spans_) AddRow(span, t);
  spans_.clear();
  at_ = rows_.size();
}

void SpanRecord::AddRow(const kernels::KernelSpan& span, kernels::KnownTriangle& t) {
  const int row = span.row - t.y;
  if (t.rows == 0) {
    const std::uint64_t columns = ((std::uint64_t{1} << (span.x1 - span.x0)) - 1)
                                  << (span.x0 - t.x);
    t.bits |= columns << (8 * row);
    return;
  }
  rows_.resize(at_ + static_cast<std::size_t>((t.rows - 1) / kernels::kKnownRows) + 1);
  kernels::KnownRows& group = rows_[at_ + static_cast<std::size_t>(row / kernels::kKnownRows)];
  group.first[row % kernels::kKnownRows] = span.x0;
  group.last[row % kernels::kKnownRows] = span.x1;
}

}  // namespace rasterproof::bench
