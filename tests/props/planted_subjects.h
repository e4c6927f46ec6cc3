// Rasterizers with a known fault, for tests of the engines that must find it.
#ifndef RASTERPROOF_TESTS_PROPS_PLANTED_SUBJECTS_H_
#define RASTERPROOF_TESTS_PROPS_PLANTED_SUBJECTS_H_

#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "core/case.h"
#include "core/coverage.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/property.h"

namespace rasterproof::props::testing {

/// A subject that draws by a function.
class PlantedSubject final : public Subject {
 public:
  using DrawFunction = std::function<void(const Scene&, const DrawOptions&, CoverageCounts&)>;

  PlantedSubject(SubjectInfo info, DrawFunction draw)
      : info_(std::move(info)), draw_(std::move(draw)) {}
  /// The same as a subject from outside: cases are drawn together.
  static PlantedSubject Outside(SubjectInfo info, DrawFunction draw) {
    PlantedSubject subject(std::move(info), std::move(draw));
    subject.shares_calls_ = true;
    return subject;
  }
  bool SharesCalls() const override { return shares_calls_; }
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    draw_(scene, options, counts);
  }

 private:
  SubjectInfo info_;
  DrawFunction draw_;
  bool shares_calls_ = false;
};

SubjectInfo RealInfo(Precision input = Precision::kFloat32);
SubjectInfo SnappedInfo(int bits);

PlantedSubject Sound(const SubjectInfo& info);
/// The exact model of another profile than the one it states.
PlantedSubject WithProfile(const SubjectInfo& info, const std::function<void(Profile&)>& change);
/// Never draws into the last column of the target.
PlantedSubject DropsLastColumn(const SubjectInfo& info);
/// Covers samples on edges from both sides.
PlantedSubject Inclusive(const SubjectInfo& info);
/// Edge functions in float or double, evaluated as written, under the top-left rule.
PlantedSubject NaiveFloat32(const SubjectInfo& info);
PlantedSubject NaiveFloat64(const SubjectInfo& info);
/// Loses every triangle whose box is `side` pixels or more across.
PlantedSubject LosesLarge(const SubjectInfo& info, double side);
/// Throws when a vertex lies left of x = -1.
PlantedSubject Throwing(const SubjectInfo& info);

/// Properties that the subject's counts are the model's.
Property ModelProperty(std::span<const std::string_view> domains);
/// What it says of the case.
Verdict CoverageIsTheModels(Subject& subject, const Case& c);

}  // namespace rasterproof::props::testing

#endif  // RASTERPROOF_TESTS_PROPS_PLANTED_SUBJECTS_H_
