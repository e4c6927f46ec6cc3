// Questions to a subject and its answers, as plain values.
#ifndef RASTERPROOF_CORE_QUESTION_H_
#define RASTERPROOF_CORE_QUESTION_H_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/vertex.h"

namespace rasterproof {

/// Whether an answer may be put together from several calls.
enum class Parts : std::uint8_t {
  kFacings,  ///< counts by facing, summed over several calls if the subject does not report facings
  kWhole     ///< one call, with the answer as the subject gives it
};

struct DrawQuestion {
  DrawJob job;
  Parts parts = Parts::kFacings;
  /// The value of every count before the draw. The draw of a subject in another process is added.
  std::uint32_t fill = 0;
  /// True if it draws into the target as the previous draw left it.
  bool onto_the_last = false;
  /// True if the subject's twin draws it.
  bool by_twin = false;
};

struct BarycentricQuestion {
  BarycentricForm form = BarycentricForm::kVertexArea;
  std::array<Point2, 3> v;
  Point2 p;
};

struct InterpolationQuestion {
  InterpolationForm form = InterpolationForm::kBarycentrics;
  std::array<Corner, 3> v;
  std::array<double, 3> attribute{};
  Point2 p;
};

/// The distance of p to each edge line.
struct DistanceQuestion {
  WireframeForm form = WireframeForm::kBarycentric;
  std::array<Point2, 3> v;
  Point2 p;
};

/// Which calls the draws of a check may share with other draws.
enum class Company : std::uint8_t {
  kAny,
  kInOrderAlone,  ///< calls in their order, with no others in between
  kOneCallAlone   ///< all in one call, with nothing else in it
};

/// The questions of one check, one list for each kind of question.
struct Questions {
  Company company = Company::kAny;
  std::vector<DrawQuestion> draws;
  std::vector<EdgeQuestion> edges;
  std::vector<StepsQuestion> steps;
  std::vector<BarycentricQuestion> barycentrics;
  std::vector<InterpolationQuestion> interpolations;
  std::vector<DistanceQuestion> distances;
};

/// The answers to some questions, each list in the order of asking. If the answers end early, some
/// lists are shorter.
struct Answers {
  /// The draws of the check's `bases` first, then its own.
  std::vector<std::shared_ptr<const Drawing>> draws;
  std::vector<double> edges;
  std::vector<std::vector<double>> steps;
  std::vector<std::array<double, 3>> barycentrics;
  std::vector<double> interpolations;
  std::vector<std::array<double, 3>> distances;
  CallEnd end;  ///< why they end early, if they do
  /// Index of the draw that ended them among the check's own, where that is known.
  std::optional<std::size_t> stopped_at = std::nullopt;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_QUESTION_H_
