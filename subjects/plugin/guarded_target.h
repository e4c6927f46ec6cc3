// A target for untrusted code: guard words around every row, closed pages around the whole.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_GUARDED_TARGET_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_GUARDED_TARGET_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rasterproof::subjects {

/// `rows` rows of `row_length` entries of `words` 32-bit words each, every word `fill`.
class GuardedCounts {
 public:
  GuardedCounts(std::size_t row_length, std::size_t rows, std::size_t words = 1,
                std::uint32_t fill = 0);
  ~GuardedCounts();
  GuardedCounts(const GuardedCounts&) = delete;
  GuardedCounts& operator=(const GuardedCounts&) = delete;

  /// The first word of the first row. Entries of an even number of words are aligned to 8 bytes.
  std::uint32_t* data();
  /// Entries from the start of one row to the start of the next: the same for all sizes of entries.
  std::size_t stride() const { return stride_ / words_; }
  /// The words of a row.
  std::span<const std::uint32_t> Row(std::size_t row) const;
  /// Describes where something was written outside the rows; nothing if nothing was.
  std::string Damage() const;

 private:
  std::string Found(std::size_t first, std::size_t last) const;

  std::size_t words_;
  std::size_t row_length_;  ///< in words, like the stride
  std::size_t rows_;
  std::size_t stride_;
  std::size_t open_bytes_;
  std::byte* open_ = nullptr;        ///< between two closed pages
  std::span<std::uint32_t> counts_;  ///< guards and rows
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PLUGIN_GUARDED_TARGET_H_
