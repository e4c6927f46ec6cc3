#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/float_environment.h"
#include "library/arguments.h"
#include "library/draw.h"
#include "library/kernels/kernel.h"
#include "library/rasterize.h"
#include "library/squares.h"

namespace rasterproof {
namespace kernels = library::kernels;

namespace library {
namespace {

// Triangles that a worker takes at a time where their order is not seen.
constexpr std::size_t kTriangles = 1024;

}  // namespace

// Threads that wait for work. The caller of ForEach is one of them.
class Threads {
 public:
  explicit Threads(int count) {
    try {
      for (int k = 1; k < count; ++k) threads_.emplace_back([this, k] { Work(k); });
    } catch (...) {
      Stop();
      throw;
    }
  }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  ~Threads() { Stop(); }

  // act(0) to act(count - 1), each in a thread.
  void ForEach(const std::function<void(int)>& act) {
    {
      const std::scoped_lock lock(mutex_);
      act_ = &act;
      at_work_ = threads_.size();
      ++round_;
    }
    begins_.notify_all();
    act(0);
    std::unique_lock lock(mutex_);
    ends_.wait(lock, [&] { return at_work_ == 0; });
  }

 private:
  void Stop() {
    {
      const std::scoped_lock lock(mutex_);
      act_ = nullptr;
      ++round_;
    }
    begins_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void Work(int number) {
    for (std::uint64_t done = 0;;) {
      const std::function<void(int)>* act = nullptr;
      {
        std::unique_lock lock(mutex_);
        begins_.wait(lock, [&] { return round_ != done; });
        done = round_;
        act = act_;
      }
      if (act == nullptr) return;
      (*act)(number);
      const std::scoped_lock lock(mutex_);
      if (--at_work_ == 0) ends_.notify_one();
    }
  }

  std::mutex mutex_;
  std::condition_variable begins_;
  std::condition_variable ends_;
  std::uint64_t round_ = 0;
  std::size_t at_work_ = 0;
  const std::function<void(int)>* act_ = nullptr;
  std::vector<std::thread> threads_;
};

// Phases are short beside what it takes to wake a thread that sleeps: these yield at first.
class Barrier {
 public:
  explicit Barrier(int count) : count_(count) {}

  void Wait() {
    const int phase = phase_.load(std::memory_order_acquire);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == count_) {
      arrived_.store(0, std::memory_order_relaxed);
      phase_.store(phase + 1, std::memory_order_release);
      phase_.notify_all();
      return;
    }
    for (int k = 0; k < kYields; ++k) {
      if (phase_.load(std::memory_order_acquire) != phase) return;
      std::this_thread::yield();
    }
    phase_.wait(phase, std::memory_order_acquire);
  }

 private:
  static constexpr int kYields = 1000;
  int count_;
  std::atomic<int> arrived_{0};
  std::atomic<int> phase_{0};
};

// A target of a worker's own, with room. Empty before a drawing, and made so again by the merge.
class OwnTarget {
 public:
  void MakeLike(const RasterTarget& target) {
    if (is_empty_ && own_.output == target.output && own_.width == target.width &&
        own_.height == target.height) {
      return;
    }
    is_empty_ = false;
    RasterTarget own{.output = target.output, .width = target.width, .height = target.height};
    own.pitch = RowBytes(target);
    const std::size_t bytes = RoomFor(own);
    std::array<Plane, 2> planes;
    for (std::size_t k = 0; k < PlanesOf(target, planes).size(); ++k) {
      if (sizes_[k] < bytes) {
        // Not touched before the thread that draws into it clears it.
        sizes_[k] = 0;
        memory_[k] = std::make_unique_for_overwrite<std::byte[]>(bytes);
        sizes_[k] = bytes;
      }
      (k == 0 ? own.memory : own.back) = {memory_[k].get(), bytes};
    }
    Clear(own);
    own_ = own;
    is_empty_ = true;
  }
  const RasterTarget& target() const { return own_; }
  void SetEmpty(bool is_empty) { is_empty_ = is_empty; }

 private:
  RasterTarget own_;
  std::array<std::unique_ptr<std::byte[]>, 2> memory_;
  std::array<std::size_t, 2> sizes_{};
  bool is_empty_ = false;
};

namespace {

template <class T, class Merge>
void MergeRow(std::byte* into, std::byte* from, std::size_t count, T empty, const Merge& merge) {
  auto* const to = reinterpret_cast<T*>(into);
  auto* const add = reinterpret_cast<T*>(from);
  for (std::size_t k = 0; k < count; ++k) {
    to[k] = merge(to[k], add[k]);
    add[k] = empty;
  }
}

// Moves what was drawn by triangles that come after all of `into`. `first` is the number of theirs.
void MergeRow(RasterOutput output, std::byte* into, std::byte* from, std::size_t bytes,
              std::uint32_t first) {
  const std::size_t words = bytes / 4;
  if (output == RasterOutput::kCounts) {
    MergeRow(into, from, bytes, std::uint8_t{0}, [](std::uint8_t a, std::uint8_t b) {
      const auto sum = static_cast<std::uint8_t>(a + b);
      return sum < a ? std::uint8_t{255} : sum;
    });
  } else if (output == RasterOutput::kFacingCounts) {
    MergeRow(into, from, words, std::uint32_t{0}, std::plus<>());
  } else if (output == RasterOutput::kMask) {
    MergeRow(into, from, bytes, std::byte{0}, std::bit_or<>());
  } else if (output == RasterOutput::kIds) {
    MergeRow(into, from, words, kNoTriangle, [first](std::uint32_t a, std::uint32_t b) {
      return b == kNoTriangle ? a : first + b;
    });
  } else {
    MergeRow(into, from, words, std::numeric_limits<float>::infinity(),
             [](float a, float b) { return b < a ? b : a; });
  }
}

// Ids and, of equal depths, the first one's sign are those of an order.
bool IsOrderSeen(RasterOutput output) {
  return output == RasterOutput::kIds || output == RasterOutput::kDepths;
}

}  // namespace
}  // namespace library

class RasterWorkers::Crew {
 public:
  Crew(int count, ForEach for_each) : count_(count), for_each_(std::move(for_each)), own_(Size()) {
    if (!for_each_) threads_ = std::make_unique<library::Threads>(count);
  }

  /// Returns whether all indices are of positions; else nothing is drawn.
  bool Draw(const RasterMesh& mesh, const RasterTarget& target, kernels::Target simd) {
    next_ = 0;
    may_go_on_ = true;
    // The first worker draws into the target where that allocates nothing.
    first_own_ = library::HasRoom(target) ? 1 : 0;
    Run({[&](int k) { Prepare(k, mesh, target); }, [&](int k) { DrawPart(k, mesh, target, simd); },
         [&](int k) { MergeRows(k, mesh, target); }});
    if (!may_go_on_) return false;
    for (int k = first_own_; k < count_; ++k) OwnOf(k).SetEmpty(true);
    return true;
  }
  int count() const { return count_; }

 private:
  std::size_t Size() const { return static_cast<std::size_t>(count_); }

  // Each phase by all workers, before the next one. What is thrown is thrown after all have ended;
  // after it, or where an index is of no vertex, no phase does anything.
  void Run(const std::array<std::function<void(int)>, 3>& phases) {
    std::vector<std::exception_ptr> thrown(Size());
    const auto guarded = [&](const std::function<void(int)>& phase, int k) {
      try {
        if (may_go_on_) phase(k);
      } catch (...) {
        thrown[static_cast<std::size_t>(k)] = std::current_exception();
        may_go_on_ = false;
      }
    };
    if (threads_ != nullptr) {
      library::Barrier all(count_);
      threads_->ForEach([&](int k) {
        for (const auto& phase : phases) {
          guarded(phase, k);
          all.Wait();
        }
      });
    } else {
      for (const auto& phase : phases) for_each_(count_, [&](int k) { guarded(phase, k); });
    }
    for (const std::exception_ptr& one : thrown) {
      if (one != nullptr) std::rethrow_exception(one);
    }
  }

  // The first triangle of worker k's, where each has one run of them.
  std::size_t FirstOf(int k, std::size_t triangles) const {
    return triangles * static_cast<std::size_t>(k) / Size();
  }

  library::OwnTarget& OwnOf(int k) { return own_[static_cast<std::size_t>(k)]; }

  // All that may fail.
  void Prepare(int k, const RasterMesh& mesh, const RasterTarget& target) {
    if (k >= first_own_) OwnOf(k).MakeLike(target);
    const std::size_t triangles = mesh.indices.size() / 3;
    if (library::HaveVertices(mesh, FirstOf(k, triangles), FirstOf(k + 1, triangles))) return;
    may_go_on_ = false;
  }

  void DrawPart(int k, const RasterMesh& mesh, const RasterTarget& target, kernels::Target simd) {
    if (k >= first_own_) OwnOf(k).SetEmpty(false);
    const RasterTarget& own = k >= first_own_ ? OwnOf(k).target() : target;
    const std::size_t triangles = mesh.indices.size() / 3;
    const auto draw = [&](std::size_t first, std::size_t end) {
      library::Draw(
          {mesh.positions, mesh.indices.subspan(3 * first, 3 * (end - first)), mesh.space}, own,
          simd);
    };
    if (library::IsOrderSeen(target.output)) {
      draw(FirstOf(k, triangles), FirstOf(k + 1, triangles));
      return;
    }
    for (;;) {
      const std::size_t first = next_.fetch_add(library::kTriangles, std::memory_order_relaxed);
      if (first >= triangles) return;
      draw(first, std::min(first + library::kTriangles, triangles));
    }
  }

  void MergeRows(int k, const RasterMesh& mesh, const RasterTarget& target) {
    const FloatEnvironment sane;
    const int first = target.height * k / count_;
    const int end = target.height * (k + 1) / count_;
    std::array<library::Plane, 2> into, from;
    library::PlanesOf(target, into);
    for (int worker = first_own_; worker < count_; ++worker) {
      const RasterTarget& own = OwnOf(worker).target();
      const auto planes = library::PlanesOf(own, from);
      for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        for (int y = first; y < end; ++y) {
          const auto row = static_cast<std::size_t>(y);
          library::MergeRow(target.output, into[plane].data() + row * target.pitch,
                            planes[plane].data() + row * own.pitch, own.pitch,
                            static_cast<std::uint32_t>(FirstOf(worker, mesh.indices.size() / 3)));
        }
      }
    }
  }

  int count_;
  ForEach for_each_;
  std::unique_ptr<library::Threads> threads_;
  std::vector<library::OwnTarget> own_;
  std::atomic<std::size_t> next_{0};  // triangle that no worker took
  std::atomic<bool> may_go_on_{true};
  int first_own_ = 1;  // the first worker that draws into memory of its own
};

namespace {

int RequireCount(int count) {
  constexpr int kMostWorkers = 256;
  if (count >= 1 && count <= kMostWorkers) return count;
  throw InputError("count", std::to_string(count) + " workers",
                   "give 1 to " + std::to_string(kMostWorkers));
}

}  // namespace

RasterWorkers::RasterWorkers(int count)
    : crew_(std::make_unique<Crew>(RequireCount(count), nullptr)) {}

RasterWorkers::RasterWorkers(int count, ForEach for_each) {
  if (!for_each) throw InputError("for_each", "empty", "give a function to call, or only a count");
  crew_ = std::make_unique<Crew>(RequireCount(count), std::move(for_each));
}

RasterWorkers::~RasterWorkers() = default;

void RasterWorkers::Rasterize(const RasterMesh& mesh, const RasterTarget& target,
                              InstructionSet set) {
  if (crew_->count() == 1 || IsOfSquares(target.output)) {
    rasterproof::Rasterize(mesh, target, set);
    return;
  }
  const kernels::Target simd = library::RequireAllButIndices(mesh, target, set);
  library::RequireApart(mesh, "target.memory", target.memory);
  library::RequireApart(mesh, "target.back", target.back);
  if (!crew_->Draw(mesh, target, simd)) library::RequireIndices(mesh);
}

}  // namespace rasterproof
