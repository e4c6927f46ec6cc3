// The floating-point environment of a library, apart from that of this program.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_ENVIRONMENT_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_ENVIRONMENT_H_

#include <cfenv>

namespace rasterproof::subjects {

/// Rounding mode, flush to zero and the like, as a library left them: it finds them so at its next
/// call. A library that was built with -ffast-math, or sets a mode, is drawn with as it is, and
/// whoever reads its answers, or judges, is not.
class LibraryEnvironment {
 public:
  /// As this thread has it now.
  LibraryEnvironment() { std::fegetenv(&theirs_); }

  /// While this is there, the library's environment is this thread's.
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
