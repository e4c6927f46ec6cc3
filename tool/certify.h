// The parts of certification: scenes and their truth, one subject's certificate, the pictures.
#ifndef RASTERPROOF_TOOL_CERTIFY_H_
#define RASTERPROOF_TOOL_CERTIFY_H_

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "report/certificate.h"
#include "report/page.h"
#include "tool/commands.h"
#include "tool/progress.h"

namespace rasterproof::tool {

/// A scene of the set, loaded once, with the oracle's counts per profile, computed once.
class MeasuredScene {
 public:
  MeasuredScene(std::string name, bool real, std::string command_arguments, Scene scene);

  const std::string& name() const { return name_; }
  bool real() const { return real_; }
  /// What a command line needs to name this scene.
  const std::string& arguments() const { return arguments_; }
  const Scene& scene() const { return scene_; }
  /// The oracle's counts under the profile. Safe to call from several threads.
  ///
  /// Error:      InputError where the profile's model is not defined on the scene.
  const CoverageCounts& Truth(const Profile& profile);

 private:
  std::string name_;
  bool real_;
  std::string arguments_;
  Scene scene_;
  std::mutex mutex_;
  std::list<std::pair<Profile, CoverageCounts>> truths_;
};

/// Loads every scene of the set.
std::vector<std::unique_ptr<MeasuredScene>> LoadSceneSet(const std::string& path,
                                                         Progress& progress);

/// Runs every property and measures every scene; fills the certificate of one subject.
report::Certificate CertifySubject(const std::string& name, const CertifyOptions& options,
                                   std::vector<std::unique_ptr<MeasuredScene>>& scenes);

/// Pictures of real scenes and of what went wrong where.
std::vector<report::Picture> TakePictures(std::vector<std::unique_ptr<MeasuredScene>>& scenes,
                                          const std::vector<report::Certificate>& certificates,
                                          Progress& progress);

/// What was proved about a subject's arithmetic, with the script that proves it.
std::vector<report::Evidence> ProvedOf(const std::string& subject);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_H_
