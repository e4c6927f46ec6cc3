// A sound rasterizer, and some with a known fault for tests of the engines that must find it.
#ifndef RASTERPROOF_TESTS_PROPS_FAULTY_SUBJECTS_H_
#define RASTERPROOF_TESTS_PROPS_FAULTY_SUBJECTS_H_

#include <functional>
#include <span>
#include <string_view>

#include "core/case.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/property.h"
#include "tests/fake_subject.h"

namespace rasterproof::props::testing {

SubjectInfo RealInfo(Precision input = Precision::kFloat32);
SubjectInfo SnappedInfo(int bits);

/// Adds the exact coverage of the scene under the default profile.
void DrawRight(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);

FakeSubject Sound(const SubjectInfo& info);
/// The exact model of another profile than the one it states.
FakeSubject WithProfile(const SubjectInfo& info, const std::function<void(Profile&)>& change);
/// Never draws into the last column of the target.
FakeSubject DropsLastColumn(const SubjectInfo& info);
/// Covers samples on edges from both sides.
FakeSubject Inclusive(const SubjectInfo& info);
/// Edge functions in float or double, evaluated as written, under the top-left rule.
FakeSubject NaiveFloat32(const SubjectInfo& info);
FakeSubject NaiveFloat64(const SubjectInfo& info);
/// Loses every triangle whose box is `side` pixels or more across.
FakeSubject LosesLarge(const SubjectInfo& info, double side);
/// Throws when a vertex lies left of x = -1.
FakeSubject Throwing(const SubjectInfo& info);

/// Properties that the subject's counts are the model's.
Property ModelProperty(std::span<const std::string_view> domains);
/// What it says of the case.
Verdict CoverageIsTheModels(Subject& subject, const Case& c);

}  // namespace rasterproof::props::testing

#endif  // RASTERPROOF_TESTS_PROPS_FAULTY_SUBJECTS_H_
