// OpenCV: fillConvexPoly with 16 fractional bits. Pixel (i, j) has its sample at (i, j).
#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corners;

// Its coordinates are int32 with a shift: this conversion is the snap of the profile.
constexpr int kShift = 16;
constexpr double kLimit = 32767;

class OpencvBitmap {
 public:
  bool Resize(int width, int height) {
    if (width > kLimit || height > kLimit) return false;
    if (width != image_.cols || height != image_.rows) image_.create(height, width, CV_8UC1);
    return true;
  }
  void Clear() { image_.setTo(0); }
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, -kLimit, kLimit)) return false;
    std::array<cv::Point, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = {static_cast<int>(std::lrint(corners[k].x * (1 << kShift))),
                   static_cast<int>(std::lrint(corners[k].y * (1 << kShift)))};
    }
    cv::fillConvexPoly(image_, points.data(), 3, cv::Scalar(255), cv::LINE_8, kShift);
    return true;
  }
  bool Covered(int x, int y) const { return image_.ptr(y)[x] != 0; }

 private:
  cv::Mat image_;
};

// It draws the outline as well as the inside: neighbours overlap by design.
constexpr const char* kProfile = R"({"name": "opencv", "subpixel_bits": 16,
  "snap_rule": "nearest-even", "tie_rule": "inclusive", "sample_locations": [[0, 0]],
  "contract": "none", "coordinate_limit": 32767})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<OpencvBitmap>(
      "opencv", "cv::fillConvexPoly, LINE_8, shift 16", kProfile, RASTERPROOF_FLOAT64);
  return &plugin;
}
