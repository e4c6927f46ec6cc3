// A target for code that is not trusted: guarded counts around every row, closed pages around all.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_GUARDED_TARGET_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_GUARDED_TARGET_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rasterproof::subjects {

/// `rows` rows of `row_length` counts, all zero.
class GuardedCounts {
 public:
  GuardedCounts(std::size_t row_length, std::size_t rows);
  ~GuardedCounts();
  GuardedCounts(const GuardedCounts&) = delete;
  GuardedCounts& operator=(const GuardedCounts&) = delete;

  /// The first count of the first row.
  std::uint32_t* data();
  /// Counts from the start of one row to the start of the next.
  std::size_t stride() const { return stride_; }
  std::span<const std::uint32_t> Row(std::size_t row) const;
  /// Where something outside the rows was written, in words, or nothing.
  std::string Damage() const;

 private:
  std::size_t row_length_;
  std::size_t rows_;
  std::size_t stride_;
  std::size_t mapped_bytes_ = 0;
  std::byte* mapped_ = nullptr;
  std::span<std::uint32_t> counts_;  ///< guards and rows
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PLUGIN_GUARDED_TARGET_H_
