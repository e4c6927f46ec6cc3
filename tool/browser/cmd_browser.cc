#include "tool/browser/cmd_browser.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "core/error.h"
#include "fmt/format.h"
#include "io/output.h"
#include "tool/exit_status.h"
#include "tool/shared_files.h"

namespace rasterproof::tool {
namespace {

// The address of a file.
std::string AddressOf(const std::string& path) {
  constexpr std::string_view kPlain =
      "/-._~0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  std::string address = "file://";
  for (const char c : std::filesystem::absolute(path).string()) {
    if (kPlain.find(c) != std::string_view::npos) {
      address += c;
    } else {
      address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return address;
}

// Whether a program was started that shows it. It may be the browser itself, which is not waited
// for, and what it prints is not ours.
bool OpensOnDesktop(std::string address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  std::string program = "xdg-open";
  const std::array<char*, 3> arguments{program.data(), address.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int n : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, n, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  const bool is_started =
      posix_spawnp(&child, program.data(), &files, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  return is_started;
}

}  // namespace

std::optional<std::string> FindBrowserPage() {
  if (auto installed = FindShared(kBrowserPage)) return installed;
  return FindShared(fmt::format("build-web/{}", kBrowserPage));
}

int RunBrowser() {
  const auto page = FindBrowserPage();
  if (!page) {
    throw InputError(
        kBrowserPage, "the page is not installed",
        "build it with ./run web in the sources, and install again if the command is installed");
  }
  const std::string address = AddressOf(*page);
  io::WriteStandardOutput(address + "\n");
  if (!OpensOnDesktop(address))
    std::cerr << "there is no desktop with xdg-open: open the address in a browser\n";
  return kExitHolds;
}

}  // namespace rasterproof::tool
