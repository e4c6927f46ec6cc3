#include "subjects/plugin/guarded_target.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <new>

namespace rasterproof::subjects {
namespace {

// No count that a rasterizer would leave there by itself.
constexpr std::uint32_t kGuard = 0x5a5a5a5a;
constexpr std::size_t kGuardColumns = 16;
constexpr std::size_t kGuardRows = 4;

std::size_t PageBytes() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

// So many open bytes between two closed pages.
std::byte* Mapped(std::size_t open_bytes) {
  const std::size_t page = PageBytes();
  void* const mapped =
      mmap(nullptr, open_bytes + 2 * page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  std::byte* const open = static_cast<std::byte*>(mapped) + page;
  if (mprotect(open, open_bytes, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  // In large pages, as what operator new gives: tool/large_pages.cc.
  madvise(open, open_bytes, MADV_HUGEPAGE);
  return open;
}

void Unmap(std::byte* open, std::size_t open_bytes) {
  munmap(open - PageBytes(), open_bytes + 2 * PageBytes());
}

// Memory that targets of this thread had and others of that size will have: to map it costs more
// than a small draw.
class SpareMemory {
 public:
  SpareMemory() = default;
  ~SpareMemory() {
    for (const auto& [bytes, open] : spare_) Unmap(open, bytes);
  }
  SpareMemory(const SpareMemory&) = delete;
  SpareMemory& operator=(const SpareMemory&) = delete;

  std::byte* Take(std::size_t open_bytes) {
    const auto found = spare_.find(open_bytes);
    if (found == spare_.end()) return Mapped(open_bytes);
    std::byte* const open = found->second;
    spare_.erase(found);
    bytes_ -= open_bytes;
    return open;
  }
  void Give(std::byte* open, std::size_t open_bytes) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 24;
    if (bytes_ + open_bytes > kMostBytes) return Unmap(open, open_bytes);
    spare_.emplace(open_bytes, open);
    bytes_ += open_bytes;
  }

 private:
  std::multimap<std::size_t, std::byte*> spare_;
  std::size_t bytes_ = 0;
};

SpareMemory& Spare() {
  thread_local SpareMemory spare;
  return spare;
}

}  // namespace

// Lays out, from low to high: a closed page, guard rows, the rows, each followed by guard columns,
// guard rows up to the end of a page, a closed page.
GuardedCounts::GuardedCounts(std::size_t row_length, std::size_t rows, std::size_t words,
                             std::uint32_t fill)
    : words_(words),
      row_length_(row_length * words),
      rows_(rows),
      stride_((row_length + kGuardColumns) * words) {
  const std::size_t page = PageBytes();
  const std::size_t count = (rows + 2 * kGuardRows) * stride_;
  open_bytes_ = (count * sizeof(std::uint32_t) + page - 1) / page * page;
  open_ = Spare().Take(open_bytes_);
  // The counts end at the closed page, so that one count too far is seen at once or in a guard.
  std::byte* const end = open_ + open_bytes_;
  counts_ = {reinterpret_cast<std::uint32_t*>(end - count * sizeof(std::uint32_t)), count};
  std::ranges::fill(counts_, kGuard);
  for (std::size_t row = 0; row < rows_; ++row)
    std::fill_n(data() + row * stride_, row_length_, fill);
}

GuardedCounts::~GuardedCounts() { Spare().Give(open_, open_bytes_); }

std::uint32_t* GuardedCounts::data() { return counts_.data() + kGuardRows * stride_; }

std::span<const std::uint32_t> GuardedCounts::Row(std::size_t row) const {
  return counts_.subspan((kGuardRows + row) * stride_, row_length_);
}

// Where a guard of [first, last) was written.
std::string GuardedCounts::Found(std::size_t first, std::size_t last) const {
  const std::span<const std::uint32_t> guards = counts_.subspan(first, last - first);
  const auto damaged = std::ranges::find_if(guards, [](std::uint32_t c) { return c != kGuard; });
  if (damaged == guards.end()) return "";
  const auto k = first + static_cast<std::size_t>(damaged - guards.begin());
  const auto row =
      static_cast<std::ptrdiff_t>(k / stride_) - static_cast<std::ptrdiff_t>(kGuardRows);
  return "column " + std::to_string(k % stride_ / words_) + " of row " + std::to_string(row) +
         " of a target of " + std::to_string(rows_) + " rows of " +
         std::to_string(row_length_ / words_) + " counts";
}

std::string GuardedCounts::Damage() const {
  // Checks the words before the first row, after each row, and after the last row up to the end.
  std::size_t first = 0;
  for (std::size_t row = 0; row < rows_; ++row) {
    const std::size_t begin = (kGuardRows + row) * stride_;
    if (std::string found = Found(first, begin); !found.empty()) return found;
    first = begin + row_length_;
  }
  return Found(first, counts_.size());
}

}  // namespace rasterproof::subjects
