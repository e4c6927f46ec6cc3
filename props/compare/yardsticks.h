// What drawings are compared with.
//
// To compare with the model nearest to a subject, see survey.h; with what it draws in another
// floating-point mode, float_modes.h.
#ifndef RASTERPROOF_PROPS_COMPARE_YARDSTICKS_H_
#define RASTERPROOF_PROPS_COMPARE_YARDSTICKS_H_

#include <cstddef>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/question.h"
#include "core/subject.h"
#include "props/compare/compare.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The profile that the subject is judged by: snapped, wrapped, within its limits. A sample is
/// wrong that no legal model allows.
Yardstick OwnModel(const Description& subject);

/// The vertices as given, with the subject's sample locations.
Yardstick RealGeometry(const Description& subject);
/// The profile of that: the sample locations and the y axis of the subject's own, and its tie rule
/// where that is one-sided.
Profile RealProfileOf(const Profile& own);

/// What another subject draws of the same question: counts where both show them, else which samples
/// are covered. Excuses cases that the other one does not draw.
///
/// Domain:     a subject that outlives the yardstick.
Yardstick AnotherSubject(const Description& subject, Subject& other);

/// Draws a case as OwnModel compares it: by facing where that can be judged.
Drawn DrawToJudge(Subject& subject, const Description& description, const PlacedCase& c);

/// The answers to some draws in one call.
Answers AnswersTo(Subject& subject, const PlacedCase& c, std::vector<DrawQuestion> draws);

/// Why a comparison under the gate does not apply to the case as it is judged; empty if it does.
std::string WhyNotCompared(const Gate& gate, const Description& subject, const PlacedCase& c);

/// The samples whose counts differ; without `counts`, those that one covers and the other does not.
///
/// Domain:     both of the same shape.
std::vector<std::size_t> WrongSamples(const CoverageCounts& drawn, const CoverageCounts& truth,
                                      bool counts = true);

/// The reading of these samples, with how far the furthest lies from an edge of the placed scene.
Reading Measured(const PlacedCase& c, const CoverageCounts& drawn, std::vector<std::size_t> wrong);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_YARDSTICKS_H_
