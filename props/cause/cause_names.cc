// The names of causes, in one place.
#include <string_view>
#include <vector>

#include "props/cause/cause.h"

namespace rasterproof::props {

std::vector<std::string_view> CauseNames() {
  return {"truncation",
          "rounding",
          "subpixel-bits",
          "sample-location",
          "sample-order",
          "y-axis",
          "tie-rule",
          "edge-precision",
          "overflow",
          "range",
          "float-edges",
          "facing",
          "facing-arithmetic",
          "culling",
          "lost-triangles",
          "flat-triangles",
          "not-finite",
          "subnormals",
          "bounding-box",
          "target-border",
          "tile-borders",
          "scissor",
          "counting",
          "vertices",
          "clip-space",
          "transform",
          "nothing-drawn",
          "not-repeatable",
          "threads",
          "float-mode",
          "tile-size",
          "target-contents",
          "earlier-draws",
          "list",
          "shown-values",
          "affine-weights",
          "exchanged-weights",
          "weights-by-w",
          "missing-division",
          "few-bits",
          "wrong-provoking-vertex",
          "wrong-place",
          "other-corners",
          "wrong-derivative",
          "wrong-quantity",
          "clamped-values",
          "depth-range",
          "depth-rounding",
          "none"};
}

}  // namespace rasterproof::props
