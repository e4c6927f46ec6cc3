// The whole command with your own rasterizer as its subject.
//
//     #include "kit/main.h"
//     struct Mine {
//       void Draw(const rasterproof::Scene& scene, rasterproof::CoverageCounts& counts);
//     };
//     RASTERPROOF_MAIN(Mine)
//
// Instead of Draw, a type may have `Drawing Show(const DrawJob& job)`, which gives primitive ids,
// barycentrics and depths too, and centroids, values and derivatives where the job wants them; and
// `std::vector<Drawing> ShowMany(std::span<const DrawJob> jobs)` if it draws several scenes in one
// call. A `static SubjectInfo Info()` says which.
//
// The program links all that the command is made of, so this header is for projects that take the
// source, and not installed. With the installed package a type is a suite of kit/gtest.h, or a
// plugin (kit/rasterproof_plugin.h).
//
// The program takes the verbs of rasterproof; Mine is the subject if none is named. It runs in its
// own process: a crash or a hang is a finding.
#ifndef RASTERPROOF_KIT_MAIN_H_
#define RASTERPROOF_KIT_MAIN_H_

#include <functional>
#include <memory>
#include <string>

#include "core/call_end.h"
#include "core/rasterizer.h"
#include "core/subject.h"

namespace rasterproof::kit {

/// Runs the command. Returns its exit status.
int Main(int argc, char** argv, const std::string& name,
         std::function<std::unique_ptr<Subject>()> make);

}  // namespace rasterproof::kit

/// Defines main. `Type` models rasterproof::Rasterizer.
#define RASTERPROOF_MAIN(Type)                              \
  int main(int argc, char** argv) {                         \
    return rasterproof::kit::Main(argc, argv, #Type, [] {   \
      return std::unique_ptr<rasterproof::Subject>(         \
          new rasterproof::RasterizerSubject<Type>(#Type)); \
    });                                                     \
  }

#endif  // RASTERPROOF_KIT_MAIN_H_
