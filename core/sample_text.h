// How a sample, its pixel and a range of numbers are worded.
#ifndef RASTERPROOF_CORE_SAMPLE_TEXT_H_
#define RASTERPROOF_CORE_SAMPLE_TEXT_H_

#include <cstddef>
#include <string>

namespace rasterproof {

/// "column 3 row 2".
inline std::string PixelText(std::size_t pixel, int width) {
  const auto columns = static_cast<std::size_t>(width);
  return "column " + std::to_string(pixel % columns) + " row " + std::to_string(pixel / columns);
}

/// The same, and " sample 1" where a pixel has several.
inline std::string SampleText(std::size_t sample, int width, int samples) {
  const auto each = static_cast<std::size_t>(samples);
  return PixelText(sample / each, width) +
         (samples > 1 ? " sample " + std::to_string(sample % each) : "");
}

/// "2", "1 to 3".
template <class Number>
std::string RangeText(Number least, Number most) {
  return std::to_string(least) + (least == most ? "" : " to " + std::to_string(most));
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SAMPLE_TEXT_H_
