// Coverage that some other program wrote down: rows of integers, or a picture.
#ifndef RASTERPROOF_IO_COUNTS_FILE_H_
#define RASTERPROOF_IO_COUNTS_FILE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/coverage.h"

namespace rasterproof::io {

/// What the numbers of a file are.
enum class FileHolds : std::uint8_t {
  kDrawing,  ///< rows of text: counts; a picture: what it shows
  kCounts,   ///< how often each sample is covered
  kIds       ///< 1 + the number of the triangle that each sample shows; 0: none
};

/// A target's coverage, as read from a file.
struct CountsFile {
  CoverageCounts counts;  ///< in `front`
  bool is_mask = false;   ///< 1 where a picture differs from its background: not how often
  /// Of kIds: the triangle at each sample, or kNoPrimitive. The counts are then unset.
  std::vector<std::int32_t> primitive_ids;
  /// The colours of a picture's corners that are not its background, RRGGBB, each once.
  std::vector<std::string> corners;
};

/// What a file is asked for.
struct CountsFormat {
  int width = 0;
  int height = 0;
  int samples = 1;
  std::string background = "000000";  ///< RRGGBB in hexadecimal
  FileHolds holds = FileHolds::kDrawing;
  std::size_t triangles = 0;  ///< of kIds: how many there are
};

/// Reads the output of `rasterproof coverage`: a number for every sample, row by row from the top,
/// the samples of a pixel side by side.
/// Or reads a picture: PNG, PGM or PPM by how it begins, or, where the path ends in ".raw", bytes
/// alone, top row first.
/// - As a drawing it has one sample in a pixel, and what does not have the background's colour is
///   covered. Raw bytes are 1, 3 or 4 to a pixel (grey, RGB, RGBA), which their number tells; the
///   fourth, alpha, is not looked at.
/// - Counts and ids are levels of grey: PGM, or raw with 1, 2 or 4 bytes to a number, low byte
///   first. Samples lie side by side: the picture is samples times as wide as the target.
///
/// Domain:     the file has the requested shape.
/// Error:      InputError with the line, or the column and row, and its fault.
CountsFile ReadCounts(const std::string& path, const CountsFormat& format);
/// Reads how many of each pixel's samples are covered, as a multisampled target is resolved: rows
/// of numbers from 0 to `samples`, or a picture of white triangles on black (PNG, PGM, PPM), whose
/// levels are shares of white, to one level of 8 bits.
///
/// Error:      InputError with the column and row: a colour, or a level that is no such share.
std::vector<std::uint32_t> ReadCovered(const std::string& path, int width, int height, int samples);
/// ReadCounts() of numbers that are at hand, in the order of CoverageCounts; kDrawing: of a mask.
///
/// Error:      InputError with `place`, and the column and row if one number is at fault.
CountsFile CountsFrom(std::vector<std::uint32_t> numbers, const std::string& place,
                      const CountsFormat& format);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_COUNTS_FILE_H_
