#include "props/cause/evidence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/clock.h"
#include "model/snap_scene.h"
#include "props/cause/suspect.h"
#include "props/judging/redraw.h"
#include "props/run/case_order.h"
#include "props/run/description.h"
#include "props/run/judge.h"
#include "props/run/property_domains.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostAsked = 12;      // properties whose own checks are asked
constexpr std::uint64_t kCasesOfEach = 24;  // of the failed property's own campaign
constexpr std::uint64_t kCasesAround = 160;
constexpr double kMostWorkAround = 0x1p14;  // of a draw: every suspect may have to draw it
constexpr std::uint64_t kSeedOfCauses = 2;
// No case that the campaign itself has judged.
constexpr std::uint64_t kFirstAround = std::uint64_t{1} << 20;

// What is asked about a case, and put to the subject check by check.
class Gathering {
 public:
  Gathering(Subject& subject, Gathered& found, double seconds)
      : subject_(subject), found_(found), end_(SecondsOfDraws(subject) + seconds) {}

  bool IsOver() {
    if (!broke_down_ && SecondsOfDraws(subject_) > end_) found_.is_cut_short = true;
    return broke_down_ || found_.is_cut_short;
  }
  void AskAll(std::size_t failure, const Property& property, const Case& c);
  void AskOnce(std::size_t failure, const Case& c);

 private:
  bool Put(Observation observation);

  Subject& subject_;
  Gathered& found_;
  double end_;
  bool broke_down_ = false;
};

bool IsOpen(const PlacedCase& c) {
  const Profile& p = c.profile;
  if (!c.flat.empty() && p.degenerate_triangles == DegenerateTriangles::kUnspecified) return true;
  if (StatesGuardBand(p) && !IsUnclipped(c.placed, c.profile)) return true;
  if (WhyBeyondLimits(c.scene, p)) return true;
  return std::ranges::any_of(c.scene.triangles, [&](const Triangle& t) {
    return FinitenessOf(Corners(c.scene, t), p) == Finiteness::kUnstated;
  });
}

}  // namespace

std::optional<FailedProperty> FailedBy(const PropertyResult& result, const SubjectInfo& subject) {
  if (result.outcome != Outcome::kViolated || !result.counterexample) return std::nullopt;
  const Counterexample& found = *result.counterexample;
  if (found.verdict.outcome != Outcome::kViolated || found.verdict.broke_down) return std::nullopt;
  FailedProperty failure{FindProperty(result.property), {found.value}};
  if (failure.property == nullptr) return std::nullopt;
  if (found.value.name && !found.failing_case.empty())
    failure.cases.push_back(DrawCase(subject, *found.value.name));
  return failure;
}

bool IsModelled(const Observation& o, const SubjectInfo& info) {
  return !IsOpen(*o.placed) && std::ranges::all_of(o.check.questions.draws, [&](const auto& q) {
    return q.job.options.float_mode == FloatMode::kUsual && SuspectsDraw(*q.job.scene, info);
  });
}

namespace {

// Returns whether the subject can be asked on.
bool Gathering::Put(Observation observation) {
  const Request request{observation.placed.get(), &observation.check, &observation.bases};
  Answers answers = std::move(Submit(subject_, {&request, 1}).front());
  if (EndsTheCall(answers.end.stop)) broke_down_ = true;
  if (answers.end.stop != Stop::kNone) return false;
  observation.is_modelled = IsModelled(observation, subject_.Info());
  observation.seen = std::move(answers.draws);
  found_.observations.push_back(std::move(observation));
  return true;
}

void Gathering::AskAll(std::size_t failure, const Property& property, const Case& c) {
  const Description description = DescriptionOf(subject_);
  const auto judge = std::make_shared<CaseJudge>(property, c, description);
  const std::shared_ptr<const PlacedCase> placed(judge, &judge->Placed());
  std::vector<std::shared_ptr<const Drawing>> drawn;
  for (const Check& check : judge->AllChecks()) {
    if (check.questions.draws.empty() || IsOver()) continue;
    Observation observation{failure, placed, {}, drawn};
    observation.check.questions.company = check.questions.company;
    observation.check.questions.draws = check.questions.draws;
    if (!Put(std::move(observation))) return;
    const auto& seen = found_.observations.back().seen;
    drawn.insert(drawn.end(), seen.begin(), seen.end());
  }
}

void Gathering::AskOnce(std::size_t failure, const Case& c) {
  if (IsOver() || !Takes(subject_.Info(), c.scene)) return;
  const auto placed = std::make_shared<const PlacedCase>(Place(c, true));
  if (failure == Observation::kAround) {
    const bool is_cheap = WorkOf(placed->scene, subject_.Info()) <= kMostWorkAround;
    if (!is_cheap || !SuspectsDraw(placed->scene, subject_.Info()) || IsOpen(*placed)) return;
  }
  Observation observation{failure, placed};
  observation.check.questions.draws = {CountsOf(placed->scene, placed->profile, placed->options)};
  Put(std::move(observation));
}

// The case with its vertices moved a little or far, and by parts.
std::vector<Case> CasesNearby(const Case& c) {
  std::vector<Case> cases;
  const auto add = [&](auto change) {
    Case moved = c;
    moved.origin.clear();
    moved.name.reset();
    change(moved.scene);
    for (Vertex& v : moved.scene.vertices) {
      if (moved.scene.precision != Precision::kFloat32) continue;
      v.x = static_cast<float>(v.x);
      v.y = static_cast<float>(v.y);
    }
    if (WithinLimits(moved.scene, moved.profile)) cases.push_back(std::move(moved));
  };
  constexpr Point2 kMoves[] = {{1, 0},      {0, 1},      {-1, 0},      {0, -1},
                               {0x1p-8, 0}, {0, 0x1p-8}, {-0x1p-8, 0}, {0, -0x1p-8},
                               {0.5, 0.5},  {0x1p-9, 0}, {0, 0x1p-9},  {-64, 0},
                               {0, -64},    {256, 256},  {-4096, 0},   {4096, 4096}};
  for (const Point2& by : kMoves) {
    const auto moved = [&](Vertex& v) {
      v.x += by.x * v.w;
      v.y += by.y * v.w;
    };
    add([&](Scene& scene) { std::ranges::for_each(scene.vertices, moved); });
    add([&](Scene& scene) {
      if (!scene.vertices.empty()) moved(scene.vertices.front());
    });
  }
  // Far back, on a target cut so that it is cheap to draw: tells from which row or column on.
  const auto most = static_cast<int>(
      kMostWorkAround / static_cast<double>(std::max<std::size_t>(
                            1, c.scene.triangles.size() * c.profile.pattern.locations.size())));
  add([&](Scene& scene) {
    scene.height = std::min(scene.height, std::max(most / scene.width, 1));
    for (Vertex& v : scene.vertices) v.y -= 4096 * v.w;
  });
  add([&](Scene& scene) {
    scene.width = std::min(scene.width, std::max(most / scene.height, 1));
    for (Vertex& v : scene.vertices) v.x -= 4096 * v.w;
  });
  add([](Scene& scene) {
    for (Triangle& t : scene.triangles) std::swap(t[1], t[2]);
  });
  add([](Scene& scene) {
    for (Triangle& t : scene.triangles) t = {t[1], t[2], t[0]};
  });
  add([](Scene& scene) {
    for (Vertex& v : scene.vertices) v.x = scene.width * v.w - v.x;
  });
  add([](Scene& scene) {
    for (Vertex& v : scene.vertices) v.y = scene.height * v.w - v.y;
  });
  for (std::size_t t = 0; t < c.scene.triangles.size() && t < 8; ++t) {
    add([&](Scene& scene) { scene.triangles = {c.scene.triangles[t]}; });
  }
  return cases;
}

// Cases of the property's own campaign that it has not judged.
std::vector<Case> CasesOf(const SubjectInfo& info, const Property& property, std::uint64_t count) {
  const CaseOrder order(info, property, kSeedOfCauses);
  std::vector<Case> cases;
  for (std::uint64_t k = 0; k < count && !order.IsEmpty(); ++k) {
    cases.push_back(DrawCase(info, order.Name(kFirstAround + k)));
  }
  return cases;
}

bool SameDrawing(const Drawing& a, const Drawing& b) {
  return a.counts == b.counts &&
         (a.primitive_ids.empty() || b.primitive_ids.empty() || a.primitive_ids == b.primitive_ids);
}

}  // namespace

Gathered Gather(Subject& subject, std::span<const FailedProperty> failures, double seconds) {
  Gathered found;
  Gathering gathering(subject, found, seconds);
  const std::size_t asked = std::min(failures.size(), kMostAsked);
  for (std::size_t k = 0; k < asked; ++k) {
    for (const Case& c : failures[k].cases) gathering.AskAll(k, *failures[k].property, c);
  }
  for (std::size_t k = 0; k < asked; ++k) {
    // What is violated there need not be the coverage.
    const bool of_values = AsksForValues(subject, failures[k]);
    for (const Case& c : failures[k].cases)
      gathering.AskOnce(of_values ? Observation::kAround : k, c);
  }
  for (std::size_t k = 0; k < asked; ++k) {
    for (const Case& c : CasesNearby(failures[k].cases.front()))
      gathering.AskOnce(Observation::kAround, c);
    const std::uint64_t count = std::max<std::uint64_t>(6, kCasesOfEach / asked);
    for (const Case& c : CasesOf(subject.Info(), *failures[k].property, count))
      gathering.AskOnce(Observation::kAround, c);
  }
  const Property* any = FindProperty("CoverageEqualsTheModel");
  for (const Case& c : CasesOf(subject.Info(), *any, kCasesAround))
    gathering.AskOnce(Observation::kAround, c);
  return found;
}

Seen DrawnBy(Subject& other, const Observation& observation) {
  const Request request{observation.placed.get(), &observation.check, &observation.bases};
  return std::move(Submit(other, {&request, 1}).front()).draws;
}

bool AreAlike(const Seen& a, const Seen& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return SameDrawing(*x, *y); });
}

bool AsksForValues(Subject& subject, const FailedProperty& failure) {
  const Description description = DescriptionOf(subject);
  const CaseJudge judge(*failure.property, failure.cases.front(), description);
  const bool shows = failure.property->group == "barycentric";  // of the fragments of a draw
  return shows || std::ranges::any_of(judge.AllChecks(), [](const Check& check) {
           const Questions& q = check.questions;
           return !q.edges.empty() || !q.steps.empty() || !q.barycentrics.empty() ||
                  !q.interpolations.empty() || !q.distances.empty() ||
                  std::ranges::any_of(
                      q.draws, [](const DrawQuestion& draw) { return draw.job.wants.centroids; });
         });
}

std::size_t DrawsOf(std::span<const Observation> observations) {
  std::size_t draws = 0;
  for (const Observation& o : observations) draws += o.seen.size();
  return draws;
}

namespace {

// Whether both draw the same, NaN for NaN.
bool IsSameScene(const DrawJob& a, const DrawJob& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return a.options == b.options && a.scene->width == b.scene->width &&
         a.scene->height == b.scene->height && std::ranges::equal(a.Triangles(), b.Triangles()) &&
         std::ranges::equal(
             a.scene->vertices, b.scene->vertices, [&](const Vertex& v, const Vertex& w) {
               return same(v.x, w.x) && same(v.y, w.y) && same(v.z, w.z) && same(v.w, w.w);
             });
}

}  // namespace

std::size_t ScenesOf(std::span<const Observation* const> observations, std::size_t most) {
  std::vector<const DrawJob*> scenes;
  for (const Observation* o : observations) {
    const DrawJob& job = o->check.questions.draws.front().job;
    const bool is_new = std::ranges::none_of(
        scenes, [&](const DrawJob* other) { return IsSameScene(*other, job); });
    if (is_new) scenes.push_back(&job);
    if (scenes.size() >= most) break;
  }
  return scenes.size();
}

}  // namespace rasterproof::props
