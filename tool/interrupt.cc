#include "tool/interrupt.h"

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace rasterproof::tool {
namespace {

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

std::atomic<int> arrived{0};
void (*once_arrived)() noexcept = nullptr;
std::array<std::atomic<bool>, kSignals.size()> caught{};  // those that the parent did not ignore

void OnSignal(int number) {
  arrived = number;
  for (std::size_t k = 0; k < kSignals.size(); ++k) {
    if (kSignals[k] != number && caught[k]) signal(kSignals[k], SIG_DFL);
  }
  once_arrived();
}

}  // namespace

void CatchInterrupts(void (*then)() noexcept) {
  once_arrived = then;
  for (std::size_t k = 0; k < kSignals.size(); ++k) {
    const int number = kSignals[k];
    struct sigaction before{};
    if (sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    struct sigaction action{};
    action.sa_handler = OnSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    caught[k] = true;
    sigaction(number, &action, nullptr);
  }
}

bool Interrupted() noexcept { return arrived != 0; }

int InterruptStatus() noexcept {
  const int number = arrived;
  return number == 0 ? 0 : 128 + number;
}

}  // namespace rasterproof::tool
