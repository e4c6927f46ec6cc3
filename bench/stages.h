// The error budget of a frame: what each stage from a mesh to its samples moves when it alone is
// inexact.
#ifndef RASTERPROOF_BENCH_STAGES_H_
#define RASTERPROOF_BENCH_STAGES_H_

#include <array>
#include <span>
#include <vector>

#include "core/bench_result.h"
#include "core/vertex.h"
#include "exact/edge.h"

namespace rasterproof::bench {

/// A mesh and how it is seen.
///
/// Domain:     places, matrix and near plane are float32, and have so few bits that every row times
///             a place is a double without rounding.
struct FrameInput {
  int width = 0;
  int height = 0;
  double near_w = 0;  ///< what lies at w below this is clipped away; positive
  /// Rows that give x, y and w of clip space scaled to the viewport: window = x / w, y / w.
  std::array<std::array<double, 4>, 3> matrix{};
  std::vector<std::array<double, 3>> places;
  std::vector<Triangle> triangles;
};

/// The stages that are inexact. None: the frame as exact arithmetic has it.
struct InexactStages {
  /// Products and sums of a row rounded to float32, left to right.
  bool transform = false;
  /// New vertices on the near plane: A + t (B - A) with t = (w_A - n) / (w_A - w_B), from the end
  /// in front, every operation rounded to float32. With none of those below.
  bool clip = false;
  /// x / w and y / w rounded to float32, once.
  bool divide = false;
  /// x / w and y / w rounded to the nearest multiple of 2^-snap_bits. -1: not at all.
  int snap_bits = -1;
  /// f32-direct's E(a, b; p), every operation rounded to float32, its operands not.
  bool coverage = false;
};

/// A torus of 65,536 / part^2 triangles, seen in perspective from so near that the near plane cuts
/// it.
FrameInput TorusFrame(int part);

/// Draws the frame once for each of these, with its stages inexact and every triangle by itself,
/// and compares it with the exact frame at every pixel centre at most a pixel from the boundary of
/// what the near plane leaves of the triangle.
///
/// Units:      displacement: largest distance of a wrong sample from that boundary, pixels.
/// Error:      of the distances, a few ulps of the coordinates in double. Corners that are snapped,
///             or covered in float32, are rounded to double first.
std::vector<BenchStage> JudgeStages(const FrameInput& frame, std::span<const InexactStages> inexact,
                                    exact::Decider decider = exact::Decider::kFast);

/// Adds the budget of TorusFrame(part) to the result: transform, clip, divide, snap to 1/256 and
/// coverage.
///
/// Cost:       of part 2, 1.5 million decisions a stage, 3 seconds; of part 4 half as much.
void RunStages(int part, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_STAGES_H_
