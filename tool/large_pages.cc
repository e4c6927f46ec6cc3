// Memory of the command `rasterproof` and of tests: large blocks come in large pages where the
// system gives them on request, and else are only slower. The counts of a target of 2^24 samples
// are 32,768 small pages, and to get each was over half of the time of a check with few cases. What
// is freed is kept for the next block: pictures of a megabyte, which are made for every case, were
// given back and asked for again page by page.
#include <malloc.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

#ifdef __GLIBC__
// The C library's own thresholds move with what is freed; both are fixed here, before `main`. Older
// ones refuse more than 32 MiB of the second.
constexpr int kKept = 1 << 30;  // bytes that are not given back while the program runs
[[maybe_unused]] const bool is_kept =
    mallopt(M_TRIM_THRESHOLD, kKept) == 1 &&
    (mallopt(M_MMAP_THRESHOLD, kKept) == 1 || mallopt(M_MMAP_THRESHOLD, 1 << 25) == 1);
#endif

}  // namespace

// The language's own, for a whole program: a library leaves its user's as they are.
void* operator new(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  const bool is_large = bytes >= 2 * kPage;
  void* const memory = is_large ? std::aligned_alloc(kPage, bytes) : std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  if (is_large) madvise(memory, bytes, MADV_HUGEPAGE);
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*bytes*/) noexcept { std::free(memory); }
