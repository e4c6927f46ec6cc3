// The floating-point environment of a library, apart from that of this program.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_ENVIRONMENT_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_ENVIRONMENT_H_

#include <cfenv>

namespace rasterproof::subjects {

/// Rounding mode, flush to zero and the like, as a library left them and as its next call finds
/// them. A library built with -ffast-math, or that sets a mode, draws in its own environment; the
/// code that reads its answers and judges them does not.
class LibraryEnvironment {
 public:
  /// Copies this thread's current environment.
  LibraryEnvironment() { std::fegetenv(&theirs_); }

  /// While this lives, the thread has the library's environment.
  class Within {
   public:
    explicit Within(LibraryEnvironment& library) : library_(library) {
      std::fegetenv(&ours_);
      std::fesetenv(&library_.theirs_);
    }
    ~Within() {
      std::fegetenv(&library_.theirs_);
      std::fesetenv(&ours_);
    }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

   private:
    LibraryEnvironment& library_;
    std::fenv_t ours_{};
  };

 private:
  std::fenv_t theirs_{};
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PLUGIN_ENVIRONMENT_H_
