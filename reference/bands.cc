#include "reference/bands.h"

#include <algorithm>
#if defined(__STDCPP_THREADS__)
#include <thread>
#endif
#include <vector>

#include "reference/box.h"

namespace rasterproof::reference {
namespace {

#if defined(__STDCPP_THREADS__)
int ThreadsFor(const DrawOptions& options, int tile_rows) {
  const int wanted =
      options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(wanted, 1, std::min(tile_rows, kMaxThreads));
}

// Waits for its threads, as std::jthread does, which libc++ has from version 20 on.
class Others {
 public:
  Others() = default;
  Others(const Others&) = delete;
  Others& operator=(const Others&) = delete;
  ~Others() {
    for (std::thread& thread : threads_) thread.join();
  }

  template <class Work>
  void Begin(const Work& work) {
    threads_.emplace_back(work);
  }

 private:
  std::vector<std::thread> threads_;
};
#else
int ThreadsFor(const DrawOptions& /*options*/, int /*tile_rows*/) { return 1; }

struct Others {
  template <class Work>
  void Begin(const Work& /*work*/) {}
};
#endif

}  // namespace

void ForEachBand(const PixelRect& area, const DrawOptions& options,
                 const std::function<void(const PixelRect&)>& draw) {
  if (IsEmpty(area)) return;
  const int height = std::max(1, TileSide(options));
  const int first_tile = area.y0 / height;
  const int tile_rows = (area.y1 - 1) / height + 1 - first_tile;
  const int threads = ThreadsFor(options, tile_rows);
  const auto band = [&](int n) {
    // At most 2^16 tile rows times 2^8 threads: no product leaves int.
    const auto start = [&](int k) { return (first_tile + tile_rows * k / threads) * height; };
    return Intersection(area, {area.x0, start(n), area.x1, start(n + 1)});
  };
  Others others;
  for (int n = 1; n < threads; ++n) others.Begin([&, n] { draw(band(n)); });
  draw(band(0));
}

}  // namespace rasterproof::reference
