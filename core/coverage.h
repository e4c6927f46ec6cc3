// How often each sample was covered.
#ifndef RASTERPROOF_CORE_COVERAGE_H_
#define RASTERPROOF_CORE_COVERAGE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterproof {

/// Counts per sample, separately for front and back facing. Front is positive area:
/// counter-clockwise on screen.
///
/// Shape:      row-major [height][width][sample], top row first.
struct CoverageCounts {
  int width = 0;
  int height = 0;
  int samples = 1;
  std::vector<std::uint32_t> front;
  std::vector<std::uint32_t> back;

  CoverageCounts() = default;
  CoverageCounts(int w, int h, int s = 1)
      : width(w), height(h), samples(s), front(Size(w, h, s)), back(Size(w, h, s)) {}

  static std::size_t Size(int w, int h, int s) {
    return static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(s);
  }
  std::size_t size() const { return front.size(); }
  /// Index of sample s of the pixel in column i and row `row` from the top.
  std::size_t Index(int i, int row, int s = 0) const {
    return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(i)) *
               static_cast<std::size_t>(samples) +
           static_cast<std::size_t>(s);
  }
  /// Number of triangles that cover the sample.
  std::uint32_t Count(std::size_t index) const { return front[index] + back[index]; }
  /// Front minus back: the signed coverage.
  std::int64_t Signed(std::size_t index) const {
    return std::int64_t{front[index]} - std::int64_t{back[index]};
  }

  /// Adds counts of the same shape.
  ///
  /// Error:      InputError if there are more of one than of the other.
  CoverageCounts& operator+=(const CoverageCounts& more);

  friend bool operator==(const CoverageCounts&, const CoverageCounts&) = default;
};

/// Error:      InputError if there are more of one than of the other.
void RequireAsMany(const CoverageCounts& a, const CoverageCounts& b);

/// The differences between a subject's counts and the expected ones. Missing and unexpected samples
/// are counted separately.
struct CoverageDifference {
  std::uint64_t samples = 0;     ///< samples compared
  std::uint64_t covered = 0;     ///< samples that the expected counts cover at least once
  std::uint64_t wrong = 0;       ///< samples whose counts differ (front or back)
  std::uint64_t missing = 0;     ///< wrong samples counted less often than expected
  std::uint64_t unexpected = 0;  ///< wrong samples counted more often than expected
  std::size_t first_wrong = 0;   ///< index of the first wrong sample, if any
};

/// Domain:     both of the same shape.
/// Error:      InputError if there are more of one than of the other.
CoverageDifference Compare(const CoverageCounts& observed, const CoverageCounts& expected);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_COVERAGE_H_
