// Memory of the command `rasterproof`: large blocks come in large pages where the system gives them
// on request. The counts of a target of 2^24 samples are 32,768 small pages, and to get each was
// over half of the time of a check with few cases.
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;
constexpr std::size_t kLarge = 2 * kPage;

void* Allocate(std::size_t bytes) {
  if (bytes < kLarge) return std::malloc(bytes == 0 ? 1 : bytes);
  const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
  if (whole < bytes) return nullptr;
  void* const memory = std::aligned_alloc(kPage, whole);
  // A system that refuses leaves small pages, which are only slower.
  if (memory != nullptr) madvise(memory, whole, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

// The language's own, for this program alone: a library leaves its user's as they are.
void* operator new(std::size_t bytes) {
  for (;;) {
    if (void* const memory = Allocate(bytes)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*bytes*/) noexcept { std::free(memory); }
