// Of tool/large_pages.cc, which this program has as every test does.
#include <gtest/gtest.h>
#include <malloc.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <limits>
#include <new>
#include <sstream>
#include <string>

namespace {

constexpr std::size_t kLarge = std::size_t{1} << 22;

std::uintptr_t AddressOf(const void* memory) { return reinterpret_cast<std::uintptr_t>(memory); }

// Of the mapping that holds it, as /proc/self/smaps says. Empty where it says none.
std::string FlagsOfMapping(std::uintptr_t address) {
  std::ifstream smaps("/proc/self/smaps");
  bool is_there = false;
  for (std::string line; std::getline(smaps, line);) {
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (std::istringstream(line) >> std::hex >> begin >> dash >> end && dash == '-') {
      is_there = begin <= address && address < end;
    } else if (is_there && line.starts_with("VmFlags:")) {
      return line + ' ';
    }
  }
  return {};
}

// Blocks of a megabyte, as of the counts of a case: given back, each costs a fault a page again.
// First: the C library's own thresholds rise with the first larger block that is freed.
TEST(LargePages, AreNotNeededWhereFreedBlocksAreKept) {
#ifdef __GLIBC__
  std::array<void*, 16> blocks{};
  for (void*& block : blocks) block = ::operator new(kLarge / 4);
  for (void* block : blocks) ::operator delete(block);
  EXPECT_GE(mallinfo2().fordblks, blocks.size() * (kLarge / 4));
#else
  GTEST_SKIP() << "another C library";
#endif
}

// Before others: what large blocks leave free may be given to it later.
TEST(LargePages, AreNotAskedForSmallerBlocks) {
  void* const memory = ::operator new(kLarge - 1);
  EXPECT_EQ(FlagsOfMapping(AddressOf(memory)).find(" hg "), std::string::npos);
  ::operator delete(memory);
}

TEST(LargePages, HoldBlocksOfFourMegabytesAndMore) {
  for (const std::size_t bytes : {kLarge, kLarge + 1, 5 * kLarge}) {
    void* const memory = ::operator new(bytes);
    EXPECT_EQ(AddressOf(memory) % (std::size_t{1} << 21), 0U) << bytes;
    const std::string flags = FlagsOfMapping(AddressOf(memory));
    if (!flags.empty() && std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled")) {
      EXPECT_NE(flags.find(" hg "), std::string::npos) << flags;
    }
    ::operator delete(memory);
  }
}

TEST(LargePages, ThrowWhereNoMemoryIsThatLarge) {
  // The compiler refuses a constant that large.
  const volatile std::size_t most = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW(::operator delete(::operator new(most)), std::bad_alloc);
  EXPECT_THROW(::operator delete(::operator new(most / 2)), std::bad_alloc);
}

}  // namespace
