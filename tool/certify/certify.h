// The parts of `certify`: scenes with their exact coverage, certificates, pictures.
#ifndef RASTERPROOF_TOOL_CERTIFY_CERTIFY_H_
#define RASTERPROOF_TOOL_CERTIFY_CERTIFY_H_

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/counters.h"
#include "core/coverage.h"
#include "core/profile.h"
#include "core/result.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "io/scene_set.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "report/certificate.h"
#include "report/page.h"
#include "tool/certify/cmd_certify.h"
#include "tool/certify/part_file.h"
#include "tool/certify/shard.h"
#include "tool/progress.h"
#include "tool/resolve.h"

namespace rasterproof::tool {

/// A scene of the set, loaded once, with the oracle's counts per profile, computed once.
class MeasuredScene {
 public:
  /// `path`: how commands name the scene's file.
  MeasuredScene(const io::SceneEntry& entry, const std::string& path, Scene scene);

  const std::string& name() const { return name_; }
  bool real() const { return real_; }
  const Scene& scene() const { return scene_; }
  /// The command that draws this scene, to be followed by "--mode barycentrics --output ..." or
  /// the like.
  std::string CommandOf(const std::string& verb) const;
  /// The command that shows where the subject differs on this scene.
  std::string CommandThatShows(const std::string& subject) const;
  /// The oracle's counts under the profile. Safe to call from several threads.
  ///
  /// Error:      InputError where the profile's model is not defined on the scene.
  /// Properties: the decisions that they took are credited to the calling thread, whoever asked
  ///             first (exact::TierScope).
  const CoverageCounts& Truth(const Profile& profile);

 private:
  struct Known {
    Profile profile;
    CoverageCounts counts;
    TierCounts tiers;
  };

  std::string name_;
  bool real_;
  bool mesh_;
  std::string arguments_;
  Scene scene_;
  std::mutex mutex_;
  std::list<Known> truths_;
};

using MeasuredScenes = std::vector<std::unique_ptr<MeasuredScene>>;

/// Loads every scene of the set; empty: of scenes/certify.json, which lies beside the command.
///
/// Error:      InputError if there is no set, or a file of it can't be read.
MeasuredScenes LoadSceneSet(const std::string& path, Progress& progress);

/// Draws a scene of the set; what the subject breaks down over, refuses, or takes too long over
/// goes to the certificate too. Of a profile that leaves something free a row says whether one
/// legal model explains what was drawn. After a scene that it hangs on, a subject from outside gets
/// for the others no more than `pace` leaves of its time limit.
void MeasureOne(Subject& subject, MeasuredScene& measured, report::Certificate& certificate,
                props::Pace& pace);

/// Where results of properties come from: every case is run, or those of a shard or a range, or
/// parts that were run elsewhere are put together.
struct Source {
  std::optional<Shard> shard;
  std::optional<CaseRange> range;
  std::span<const SubjectPart> parts;

  bool IsAPart() const { return shard || range; }
};

/// A property, and the world whose cases it takes; none: drawn ones.
struct Test {
  const props::Property* property = nullptr;
  const props::World* world = nullptr;
};

/// One subject's certificate, in parts: every property, those of each world, then every scene.
class Certification {
 public:
  /// Domain:     subject, options, scenes and source that outlive this; worlds that there are;
  ///             parts of these properties and worlds.
  Certification(const SubjectFactory& subject, const CertifyOptions& options,
                MeasuredScenes& scenes, const Source& source);

  std::size_t size() const { return parts_.size(); }
  bool TakesLong(std::size_t part) const;
  /// Does a part of the work; other threads may do others at once, with subjects of their own.
  void Do(std::size_t part, Subject& subject);
  /// Whether a part was begun.
  bool IsBegun() const;
  /// Whether every part was done.
  bool IsDone() const;
  /// What came of the parts, in their order. Interrupted if one was, or was never done.
  ///
  /// Domain:     no other thread works on it.
  report::Certificate Result() const;
  /// What came of the source's cases.
  ///
  /// Domain:     every part is done.
  SubjectPart ToPart() const;

 private:
  struct Part {
    report::Certificate found;  ///< only what this part found
    PropertyResult result;      ///< of a property
    bool is_begun = false;
    bool is_done = false;
  };

  PropertyResult RunTest(Subject& subject, const Test& test);
  void DoTest(Subject& subject, std::size_t test, Part& mine);

  const SubjectFactory& subject_;
  SubjectInfo info_;
  std::vector<props::Shows> outputs_;
  const CertifyOptions& options_;
  MeasuredScenes& scenes_;
  const Source& source_;
  std::vector<Test> tests_;
  props::Pace pace_;
  props::Pace scene_pace_;  ///< scenes are large: small, fast cases do not predict their time
  std::vector<Part> parts_;
};

/// Returns the header that all parts of a campaign on the subject share: version, environment,
/// options, names of tests, and a library's hash.
SubjectPart DescribePart(const SubjectInfo& info, const std::vector<std::string>& worlds);

/// Writes certificates, files and page of the subjects, from a run or from the source's parts.
///
/// Returns:    the exit status.
int Certify(const CertifyOptions& options, const Source& source);

/// The reference's ways of interpolating, for the page.
std::vector<report::ValueMethodRow> ValueMethodRows();

/// Adds to subjects that show values what explains their violations, if a mistake does.
void ExplainValues(std::vector<report::Certificate>& certificates, Progress& progress);

/// Pictures of real scenes, and of what every violated subject got wrong, for the page to show.
///
/// Domain:     certificates that know their folders.
std::vector<report::Picture> TakePictures(MeasuredScenes& scenes,
                                          const std::vector<report::Certificate>& certificates,
                                          Progress& progress);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_CERTIFY_H_
