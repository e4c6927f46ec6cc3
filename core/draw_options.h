// How a subject is asked to draw. Only culling and the scissor may change a result.
#ifndef RASTERPROOF_CORE_DRAW_OPTIONS_H_
#define RASTERPROOF_CORE_DRAW_OPTIONS_H_

#include <cstdint>
#include <optional>

#include "core/float_mode.h"

namespace rasterproof {

enum class Cull : std::uint8_t { kNone, kFront, kBack };

/// A half-open rectangle of pixels: [x0, x1) x [y0, y1), rows counted from the top.
struct PixelRect {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

struct DrawOptions {
  Cull cull = Cull::kNone;
  std::optional<PixelRect> scissor;
  /// Side of the square tiles that the target is walked in; 0: the subject's own choice.
  int tile = 0;
  /// Threads that share the triangles or tiles; 0: the subject's own choice.
  int threads = 1;
  /// The mode of the thread that draws, as its caller left it.
  FloatMode float_mode = FloatMode::kUsual;

  friend bool operator==(const DrawOptions&, const DrawOptions&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_DRAW_OPTIONS_H_
