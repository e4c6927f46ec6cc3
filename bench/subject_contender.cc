// Subjects of the user's: libraries in this process, programs in their own.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/contender.h"
#include "core/bench_result.h"
#include "core/call_end.h"
#include "core/clock.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {
namespace {

// What is the same of both: who it is, and its triangles drawn alone.
class SubjectContender : public Contender {
 public:
  explicit SubjectContender(Subject& subject) : subject_(subject) {
    const SubjectInfo& info = subject.Info();
    model_ = info.profile;
    method_.name = info.name;
    method_.summary = info.summary;
    method_.kind = "yours";
    method_.target = "its own";
    const bool is_mask = info.coverage == CoverageKind::kMask;
    method_.sink =
        NameOf(is_mask ? library::kernels::Sink::kMask : library::kernels::Sink::kFacing);
    method_.traversal = method_.arithmetic = "its own";
    method_.space = info.takes_window ? "window" : "clip";
    method_.model = info.profile.name;
    method_.is_users = true;
    method_.coordinate_limit = info.profile.coordinate_limit;
    method_.vertex_bytes = sizeof(Vertex);
    method_.pixel_bits = 8 * sizeof(std::uint64_t);
    if (info.draws_elsewhere) method_.clock = BenchClock::kWall;
  }

  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    if (Takes(subject_.Info(), family.scene)) return std::nullopt;
    return "it does not take the family's vertices";
  }

  void Load(const FamilyInput& family) override {
    scene_ = std::make_shared<const Scene>(family.scene);
    Scene without_triangles = family.scene;
    without_triangles.triangles.clear();
    empty_ = std::make_shared<const Scene>(std::move(without_triangles));
    outside_ = 0;
  }

  // Counts without facings have no counterpart in the model's.
  bool MoveDrawn(CoverageCounts& to) override {
    if (subject_.Info().coverage != CoverageKind::kFacingCounts) return false;
    to = DrawOne(subject_, Job(scene_)).counts;
    return true;
  }

  void LimitTime(double seconds) override { most_of_a_family_ = seconds; }
  bool IsSlowAlone() const override { return true; }
  void DrawAlone(std::size_t triangle, const PixelRect& area,
                 std::vector<std::uint8_t>& box) override {
    DrawJob job = Job(scene_);
    job.triangles = {scene_->triangles[triangle]};
    const CoverageCounts counts = DrawOne(subject_, job).counts;
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) all += counts.Count(i) != 0 ? 1 : 0;
    std::size_t at = 0;
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = area.x0; x < area.x1; ++x) {
        box[at] = counts.Count(counts.Index(x, y)) != 0 ? 1 : 0;
        all -= box[at++];
      }
    }
    outside_ += all;
  }
  std::uint64_t LeftBehind() override { return std::exchange(outside_, 0); }

  // Many small scenes in few calls.
  std::vector<std::uint8_t> CoverAlone(std::span<const std::size_t> triangles,
                                       const PixelRect& /*target*/, Pixel at) override {
    constexpr std::size_t kCall = 1024;
    std::vector<std::uint8_t> covered;
    while (covered.size() < triangles.size()) {
      std::vector<DrawJob> jobs;
      for (const std::size_t triangle :
           triangles.subspan(covered.size(), std::min(kCall, triangles.size() - covered.size()))) {
        jobs.push_back(Job(std::make_shared<const Scene>(SceneAlone(triangle))));
      }
      const std::vector<DrawOutcome> outcomes = subject_.DrawMany(jobs);
      for (const DrawOutcome& outcome : outcomes) {
        const CoverageCounts& counts = outcome.Get().counts;
        covered.push_back(counts.Count(counts.Index(at.x, at.y)) != 0 ? 1 : 0);
      }
    }
    return covered;
  }

  std::vector<PixelValues> ValuesAlone(std::size_t triangle,
                                       std::span<const Pixel> pixels) override {
    std::vector<PixelValues> values;
    if (subject_.Info().coverage != CoverageKind::kFragments) return values;
    DrawJob job = Job(scene_);
    job.triangles = {scene_->triangles[triangle]};
    job.wants = kEverything;
    const Drawing drawing = DrawOne(subject_, job);
    for (const Pixel& at : pixels) {
      PixelValues& shown = values.emplace_back();
      const std::size_t i = drawing.counts.Index(at.x, at.y);
      if (drawing.counts.Count(i) == 0) continue;
      if (!drawing.barycentrics.empty()) shown.barycentrics = drawing.barycentrics[i];
      if (!drawing.depths.empty()) shown.depth = drawing.depths[i];
    }
    return values;
  }

 protected:
  // Judged as a whole, alone for a while, and measured in one round.
  void RequireTimeFor(double one_draw) const {
    constexpr int kDraws = 15;
    if (kDraws * one_draw <= most_of_a_family_) return;
    std::array<char, 200> why{};
    std::snprintf(
        why.data(), why.size(),
        "a draw takes %.2g s, and %d of them more than the %.2g s that the budget has for "
        "it here; give a --budget %.1f times as large, or fewer families",
        one_draw, kDraws, most_of_a_family_, std::max(1.1, kDraws * one_draw / most_of_a_family_));
    throw SubjectStop(Stop::kTooSlow, why.data());
  }
  Scene SceneAlone(std::size_t triangle) const {
    Scene alone;
    alone.name = scene_->name;
    alone.width = scene_->width;
    alone.height = scene_->height;
    alone.precision = scene_->precision;
    alone.clip_space = scene_->clip_space;
    const auto corners = Corners(*scene_, scene_->triangles[triangle]);
    alone.vertices.assign(corners.begin(), corners.end());
    alone.triangles = {{0, 1, 2}};
    return alone;
  }
  static DrawJob Job(std::shared_ptr<const Scene> scene) {
    DrawJob job(std::move(scene), {}, 1);
    job.wants = kCoverageAlone;
    return job;
  }
  double Triangles() const { return std::max(1.0, static_cast<double>(scene_->triangles.size())); }
  double SecondsOf(const DrawTime& time) const {
    return method_.clock == BenchClock::kWall ? time.wall_seconds : time.seconds;
  }
  DrawTime TimeOf(const DrawJob& job, int repeats) const {
    if (const std::optional<DrawTime> told = subject_.TimeDraws(job, repeats)) return *told;
    return Timed([&] {
      for (int k = 0; k < repeats; ++k) DrawOne(subject_, job);
    });
  }

  Subject& subject_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Scene> empty_;
  double most_of_a_family_ = INFINITY;
  std::uint64_t outside_ = 0;  // samples outside of the areas of triangles drawn alone
};

// What a draw beyond the subject's own limit says.
template <class Draw>
void InTime(double seconds, const Draw& draw) {
  try {
    draw();
  } catch (const SubjectStop& stop) {
    if (stop.stop() != Stop::kTooSlow) throw;
    throw SubjectStop(stop.stop(), "one draw takes more than " +
                                       std::to_string(std::lround(seconds)) +
                                       " s; give a larger --budget, or fewer families");
  }
}

class LibraryContender final : public SubjectContender {
 public:
  LibraryContender(Subject& subject, std::string march, Subject* first, double most_seconds)
      : SubjectContender(subject), first_(first), most_seconds_(most_seconds) {
    method_.march = std::move(march);
  }

  void Load(const FamilyInput& family) override {
    SubjectContender::Load(family);
    if (first_ != nullptr) {
      double one = 0;
      InTime(most_seconds_,
             [&] { one = Timed([&] { DrawOne(*first_, Job(scene_)); }).wall_seconds; });
      RequireTimeFor(one);
    }
  }

  DrawTime Draw() override {
    const DrawTime converting = TimeOf(Job(empty_), 1);
    const DrawTime all = TimeOf(Job(scene_), 1);
    conversion_seconds_ = SecondsOf(converting) / Triangles();
    const double wall = std::max(0.0, all.wall_seconds - converting.wall_seconds);
    const double processor = std::max(0.0, all.seconds - converting.seconds);
    return {.seconds = method_.clock == BenchClock::kWall ? wall : processor, .wall_seconds = wall};
  }

 private:
  Subject* first_;
  double most_seconds_;
};

// The least squares' slope of times over draws, not below 0, and where it meets 0 draws.
struct Line {
  double slope = 0;
  double start = 0;
};

Line FittedLine(std::span<const double> draws, std::span<const double> seconds) {
  const auto count = static_cast<double>(draws.size());
  double mean_draws = 0;
  double mean_seconds = 0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    mean_draws += draws[i] / count;
    mean_seconds += seconds[i] / count;
  }
  double above = 0;
  double below = 0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    above += (draws[i] - mean_draws) * (seconds[i] - mean_seconds);
    below += (draws[i] - mean_draws) * (draws[i] - mean_draws);
  }
  const double slope = std::max(0.0, above / below);
  return {.slope = slope, .start = std::max(0.0, mean_seconds - slope * mean_draws)};
}

class ProgramContender final : public SubjectContender {
 public:
  ProgramContender(Subject& subject, double most_seconds, std::string name)
      : SubjectContender(subject), most_seconds_(most_seconds) {
    if (!name.empty()) method_.name = std::move(name);
    method_.times_requests = !subject.Info().takes_repeats;
    if (method_.clock != BenchClock::kWall) method_.clock = BenchClock::kProgram;
  }

  // The first draw starts it, and the second one is warm.
  void Load(const FamilyInput& family) override {
    SubjectContender::Load(family);
    InTime(most_seconds_, [&] { TimeOf(Job(scene_), 1); });
    const double one = TimeOf(Job(scene_), 1).wall_seconds;
    RequireTimeFor(one);
    if (method_.times_requests) {
      conversion_seconds_ = SlopeOf(Job(empty_), 1).seconds / Triangles();
    }
    draws_ = 1;
    if (method_.times_requests) return;
    // What draws have in common, a request's words and its answer's, may be most of the time.
    const double enough = std::max(one + kEnough, kResolved * one);
    const auto takes_longer = [&](int draws, int times) {
      for (int k = 0; k < times; ++k) {
        if (TimeOf(Job(scene_), draws).wall_seconds < enough) return false;
      }
      return true;
    };
    if (one > kLong && takes_longer(kFewDraws, 1)) return;
    while (!takes_longer(draws_, kSeen)) {
      if (draws_ == kMostDraws) {
        throw SubjectStop(
            Stop::kNotDrawable,
            "its answer to " + std::to_string(kMostDraws) +
                " draws takes no longer than to one: it ignores 'takes repeats', or a draw costs "
                "nothing beside its request; leave out 'repeats', or give larger scenes");
      }
      draws_ *= 2;
    }
  }

  DrawTime Draw() override { return SlopeOf(Job(scene_), draws_); }

 private:
  static constexpr double kLong = 0.25;    // seconds of one draw from which on no more are asked
  static constexpr double kEnough = 0.01;  // that k draws take beyond what they have in common
  static constexpr int kMostDraws = 1024;
  static constexpr int kFewDraws = 4;
  static constexpr int kSeen = 3;  // times that they must take longer: a busy machine waits, too
  static constexpr double kResolved = 1.5;  // times what one draw takes that some must take

  DrawTime SlopeOf(const DrawJob& job, int draws) {
    constexpr std::array<int, 3> kTimes{1, 2, 4};
    std::array<double, 3> counts{};
    std::array<double, 3> seconds{};
    std::array<double, 3> walls{};
    for (std::size_t i = 0; i < kTimes.size(); ++i) {
      const DrawTime time = TimeOf(job, kTimes[i] * draws);
      counts[i] = kTimes[i] * draws;
      seconds[i] = SecondsOf(time);
      walls[i] = time.wall_seconds;
    }
    const Line line = FittedLine(counts, seconds);
    if (!method_.times_requests) conversion_seconds_ = line.start / Triangles();
    return {.seconds = line.slope, .wall_seconds = FittedLine(counts, walls).slope};
  }

  double most_seconds_;
  int draws_ = 1;
};

}  // namespace

std::unique_ptr<Contender> MakeSubjectContender(Subject& subject, std::string march, Subject* first,
                                                double most_seconds) {
  return std::make_unique<LibraryContender>(subject, std::move(march), first, most_seconds);
}

std::unique_ptr<Contender> MakeProgramContender(Subject& subject, double most_seconds,
                                                std::string name) {
  return std::make_unique<ProgramContender>(subject, most_seconds, std::move(name));
}

}  // namespace rasterproof::bench
