#include "props/run/trial.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_errors.h"
#include "model/target_model.h"
#include "props/judging/flat_triangles.h"
#include "props/judging/redraw.h"
#include "props/run/batching.h"
#include "props/run/guarded.h"
#include "props/run/judge.h"
#include "props/run/own_transform.h"

namespace rasterproof::props {
namespace {

// Checks what the profile promises of the case: its model is the one for the target's size, and
// triangles of zero area are taken out where it leaves what they cover unspecified.
Verdict CheckAsPromised(Subject& subject, const Property& property, const Case& c) {
  if (c.profile.targets.empty() && c.profile.zero_area == ZeroArea::kNothing) {
    return property.check(subject, c);
  }
  Case judged = c;
  judged.profile = ForTarget(c.profile, c.scene.width, c.scene.height);
  // A crash or a write outside the target is no freedom of flat triangles.
  if (c.profile.zero_area == ZeroArea::kNothing || property.group == "extremes") {
    return property.check(subject, judged);
  }
  if (c.scene.clip_space && !judged.profile.snap.IsNone()) {
    return {Outcome::kNotExercised, 0, 0, "the area after the division and snapping is not decided",
            std::nullopt};
  }
  const std::vector<std::size_t> flat = FlatTriangles(judged);
  std::vector<std::size_t> kept;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    if (!std::ranges::binary_search(flat, t)) kept.push_back(t);
  }
  Verdict verdict = property.check(subject, OnlyTriangles(judged, kept));
  if (verdict.witness && verdict.witness->triangle >= 0) {
    const auto among_kept = static_cast<std::size_t>(verdict.witness->triangle);
    verdict.witness->triangle = static_cast<int>(kept[among_kept]);
  }
  if (verdict.outcome == Outcome::kViolated && !flat.empty()) {
    verdict.message += "; it numbers the triangles without those of zero area";
  }
  return verdict;
}

Trial Judge(Subject& subject, const Property& property, const Case& c) {
  try {
    return {CheckSeen(subject, c, [&](Subject& seen, const Case& seen_case) {
      return CheckAsPromised(seen, property, seen_case);
    })};
  } catch (const SubjectRefusal& refusal) {
    return {Verdict::Refused(refusal.what())};
  } catch (const InputError& error) {
    // The oracle says that it decides no such scene, or a transform that it reaches none.
    return {Verdict::NotApplicable(error.what())};
  } catch (const SubjectHang& hang) {
    return {Verdict::Violated(1, std::string("the subject failed: ") + hang.what(), Witness{}),
            true, true};
  } catch (const SubjectFault& fault) {
    return {Verdict::Violated(1, std::string("the subject failed: ") + fault.what(), Witness{}),
            true};
  } catch (const SubjectDeadline& deadline) {
    return {Verdict::Inconclusive(deadline.what()), false, false, true};
  } catch (const SubjectTooSlow& slow) {
    return {Verdict::Inconclusive(slow.what())};
  } catch (const std::exception& error) {
    throw JudgingFault(std::string(property.name) + " on " +
                       (c.origin.empty() ? "scene " + c.scene.name : c.origin) + ": " +
                       error.what());
  }
}

}  // namespace

Trial TryCase(Subject& subject, const Property& property, const Case& c) {
  if (property.ask != nullptr) return TryAsked(subject, property, c);
  // Draws from outside are guarded at the rasterizer itself: what lies around it is ours.
  if (BatchingOf(subject) != nullptr) return Judge(subject, property, c);
  GuardedSubject guarded(subject);
  return Judge(guarded, property, c);
}

}  // namespace rasterproof::props
