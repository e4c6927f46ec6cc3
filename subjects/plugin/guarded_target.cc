#include "subjects/plugin/guarded_target.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <new>

namespace rasterproof::subjects {
namespace {

// No count that a rasterizer would leave there by itself.
constexpr std::uint32_t kGuard = 0x5a5a5a5a;
constexpr std::size_t kGuardColumns = 16;
constexpr std::size_t kGuardRows = 4;

}  // namespace

// From low to high: a closed page, guard rows, the rows, each with guard columns behind it, guard
// rows up to the end of a page, a closed page.
GuardedCounts::GuardedCounts(std::size_t row_length, std::size_t rows, std::size_t words,
                             std::uint32_t fill)
    : words_(words),
      row_length_(row_length * words),
      rows_(rows),
      stride_((row_length + kGuardColumns) * words) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t count = (rows + 2 * kGuardRows) * stride_;
  const std::size_t open_bytes = (count * sizeof(std::uint32_t) + page - 1) / page * page;
  mapped_bytes_ = open_bytes + 2 * page;
  void* const mapped = mmap(nullptr, mapped_bytes_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  mapped_ = static_cast<std::byte*>(mapped);
  if (mprotect(mapped_ + page, open_bytes, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  // Against the closed page behind it, so that one count too far is seen at once or in a guard.
  std::byte* const end = mapped_ + page + open_bytes;
  counts_ = {reinterpret_cast<std::uint32_t*>(end - count * sizeof(std::uint32_t)), count};
  std::ranges::fill(counts_, kGuard);
  for (std::size_t row = 0; row < rows_; ++row)
    std::fill_n(data() + row * stride_, row_length_, fill);
}

GuardedCounts::~GuardedCounts() { munmap(mapped_, mapped_bytes_); }

std::uint32_t* GuardedCounts::data() { return counts_.data() + kGuardRows * stride_; }

std::span<const std::uint32_t> GuardedCounts::Row(std::size_t row) const {
  return counts_.subspan((kGuardRows + row) * stride_, row_length_);
}

std::string GuardedCounts::Damage() const {
  for (std::size_t k = 0; k < counts_.size(); ++k) {
    const std::size_t row = k / stride_;
    const std::size_t column = k % stride_;
    const bool is_row = row >= kGuardRows && row < kGuardRows + rows_;
    if ((is_row && column < row_length_) || counts_[k] == kGuard) continue;
    const std::string at = "column " + std::to_string(column / words_) + " of row ";
    const auto number = static_cast<std::ptrdiff_t>(row) - static_cast<std::ptrdiff_t>(kGuardRows);
    return at + std::to_string(number) + " of a target of " + std::to_string(rows_) + " rows of " +
           std::to_string(row_length_ / words_) + " counts";
  }
  return "";
}

}  // namespace rasterproof::subjects
