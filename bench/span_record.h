// The spans of the exact kernels, found once, to be only written.
#ifndef RASTERPROOF_BENCH_SPAN_RECORD_H_
#define RASTERPROOF_BENCH_SPAN_RECORD_H_

#include <cstddef>
#include <vector>

#include "library/kernels/kernel.h"

namespace rasterproof::bench {

/// Spans in the form in which they are written.
class SpanRecord {
 public:
  SpanRecord() = default;
  /// What the exact kernel covers of the scene.
  SpanRecord(library::kernels::Target target, const library::kernels::KernelScene& scene);
  /// What the kernel of clip space covers.
  SpanRecord(library::kernels::Target target, const library::kernels::ClipScene& scene);

  /// The record outlives it.
  library::kernels::KnownSpans View() const {
    return {triangles_.data(), triangles_.size(), rows_.data()};
  }

 private:
  // In the order in which kernels find them.
  void Add(const library::kernels::KernelSpan& span);
  void AddRow(const library::kernels::KernelSpan& span, library::kernels::KnownTriangle& t);
  void FinishTriangle();
  template <class SomeScene>
  void Record(const SomeScene& scene,
              void (*draw)(library::kernels::Target, library::kernels::KernelView),
              library::kernels::Target target);

  std::vector<library::kernels::KernelSpan> spans_;  // of the triangle under way
  std::vector<library::kernels::KnownTriangle> triangles_;
  std::vector<library::kernels::KnownRows> rows_;
  std::size_t at_ = 0;  // the first group of rows of the triangle under way
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_SPAN_RECORD_H_
