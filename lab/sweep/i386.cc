#include "lab/sweep/i386.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>

namespace rasterproof::lab {
namespace {

// An ELF file with one segment, loaded at 0x08048000: exit(0) by the system call of i386.
constexpr std::array<unsigned char, 93>
    kExits{0x7f, 'E',  'L',  'F',  1,    1,    1,    0,    0,    0,    0,
           0,    0,    0,    0,    0,  // ident
           2,    0,    3,    0,    1,    0,    0,    0,    0x54, 0x80, 0x04,
           0x08, 0x34, 0,    0,    0,  // entry
           0,    0,    0,    0,    0,    0,    0,    0,    0x34, 0,    0x20,
           0,    1,    0,    0,    0,  //
           0,    0,    0,    0,        //
           1,    0,    0,    0,    0,    0,    0,    0,    0,    0x80, 0x04,
           0x08, 0,    0x80, 0x04, 0x08, 0x5d, 0,    0,    0,    0x5d, 0,
           0,    0,    5,    0,    0,    0,    0,    0x10, 0,    0,  // load
           0xb8, 1,    0,    0,    0,    0x31, 0xdb, 0xcd, 0x80};

bool RunsOnce() {
  const int file = memfd_create("i386", MFD_CLOEXEC);
  if (file < 0) return false;
  int status = -1;
  if (write(file, kExits.data(), kExits.size()) == static_cast<ssize_t>(kExits.size())) {
    const pid_t child = fork();
    if (child == 0) {
      std::array<char, 5> name{"i386"};
      const std::array<char*, 2> argv{name.data(), nullptr};
      fexecve(file, argv.data(), environ);
      _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child) status = -1;
  }
  close(file);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool RunsI386() {
  static const bool runs = RunsOnce();
  return runs;
}

}  // namespace rasterproof::lab
