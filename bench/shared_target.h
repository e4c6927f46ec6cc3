// Memory that contenders draw onto and share.
#ifndef RASTERPROOF_BENCH_SHARED_TARGET_H_
#define RASTERPROOF_BENCH_SHARED_TARGET_H_

#include <memory>

namespace rasterproof::bench {

/// The last target of a kind, for as long as anybody holds it: of sixty contenders that draw one
/// after the other none is luckier with its pages, and a run holds one target, not sixty.
template <class Target>
class SharedTarget {
 public:
  /// That one if it fits, else what `make` makes: of unknown content.
  template <class Fits, class Make>
  std::shared_ptr<Target> Of(const Fits& fits, const Make& make) {
    std::shared_ptr<Target> target = last_.lock();
    if (target == nullptr || !fits(*target)) {
      target = std::make_shared<Target>(make());
      last_ = target;
    }
    return target;
  }

 private:
  std::weak_ptr<Target> last_;
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_SHARED_TARGET_H_
