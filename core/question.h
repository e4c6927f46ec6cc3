// What a subject is asked, and what it answers, as plain values.
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

/// How much of what one call shows is asked for.
enum class Parts : std::uint8_t {
  kFacings,  ///< counts by facing; of a subject that tells none, added up from calls for its parts
  kWhole     ///< one call, answered as the subject answers it
};

struct DrawQuestion {
  DrawJob job;
  Parts parts = Parts::kFacings;
  /// Every count before the draw. What a subject outside this process draws is added to it.
  std::uint32_t fill = 0;
  /// Into the target that the draw before it left.
  bool onto_the_last = false;
  /// Drawn by the subject's twin.
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

/// What may share calls with the draws of a check.
enum class Company : std::uint8_t {
  kAny,
  kInOrderAlone,  ///< calls in their order, and no others in between
  kOneCallAlone   ///< all in one call, and nothing else in it
};

/// What is asked at once. One list for each kind of question.
struct Questions {
  Company company = Company::kAny;
  std::vector<DrawQuestion> draws;
  std::vector<EdgeQuestion> edges;
  std::vector<StepsQuestion> steps;
  std::vector<BarycentricQuestion> barycentrics;
  std::vector<InterpolationQuestion> interpolations;
  std::vector<DistanceQuestion> distances;
};

/// The answers to some questions, each list in the order of asking. Where they end early some lists
/// are shorter.
struct Answers {
  /// Those of the check's `bases` first, then its own.
  std::vector<std::shared_ptr<const Drawing>> draws;
  std::vector<double> edges;
  std::vector<std::vector<double>> steps;
  std::vector<std::array<double, 3>> barycentrics;
  std::vector<double> interpolations;
  std::vector<std::array<double, 3>> distances;
  CallEnd end;  ///< why they end early, if they do
  /// Which draw of the question it was, counted from 0, where that is known.
  std::optional<std::size_t> stopped_at = std::nullopt;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_QUESTION_H_
