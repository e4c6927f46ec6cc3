// The least that a rasterizer written in C++ must be: a type with a Draw.
#ifndef RASTERPROOF_CORE_RASTERIZER_H_
#define RASTERPROOF_CORE_RASTERIZER_H_

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/scene.h"
#include "core/stated_edges.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof {

/// Adds the coverage of every triangle of a scene to counts of its shape. Culling, scissor and
/// tiles are not asked for.
template <class R>
concept DrawsScenes =
    std::default_initializable<R> &&
    requires(R r, const Scene& scene, CoverageCounts& counts) { r.Draw(scene, counts); };

/// Like above, and obeys the options.
template <class R>
concept DrawsScenesByOptions = std::default_initializable<R> &&
                               requires(R r, const Scene& scene, const DrawOptions& options,
                                        CoverageCounts& counts) { r.Draw(scene, options, counts); };

/// Returns the outputs that its Info() states: counts, primitive ids, barycentrics and depths. The
/// job's triangles are its scene's own, and outputs that the job does not want may be left out.
template <class R>
concept ShowsDrawings = std::default_initializable<R> && requires(R r, const DrawJob& job) {
  { r.Show(job) } -> std::same_as<Drawing>;
};

/// Draws several scenes in one call and returns one drawing for each, in their order.
template <class R>
concept DrawsBatches = ShowsDrawings<R> && requires(R r, std::span<const DrawJob> jobs) {
  { r.ShowMany(jobs) } -> std::same_as<std::vector<Drawing>>;
};

/// Returns its value of E(a, b; p), evaluated at p without stepping.
template <class R>
concept ShowsEdgeValues = requires(R r, Point2 at) {
  { r.EdgeValue(at, at, at) } -> std::same_as<double>;
};

/// Returns its steps + 1 values on the way from p, the first at p.
template <class R>
concept ShowsEdgeSteps = ShowsEdgeValues<R> && requires(R r, Point2 at, Step step) {
  { r.EdgeSteps(at, at, at, step, 1) } -> std::same_as<std::vector<double>>;
};

template <class R>
concept Rasterizer = DrawsScenes<R> || DrawsScenesByOptions<R> || ShowsDrawings<R>;

/// A rasterizer may describe itself: `static SubjectInfo Info()`.
template <class R>
concept DescribesItself = requires {
  { R::Info() } -> std::same_as<SubjectInfo>;
};

/// A rasterizer as a subject.
template <Rasterizer R>
class RasterizerSubject final : public Subject {
 public:
  explicit RasterizerSubject(std::string name) {
    if constexpr (DescribesItself<R>) info_ = R::Info();
    info_.name = std::move(name);
    info_.takes_batches = DrawsBatches<R>;
    info_.edges.shows_values = ShowsEdgeValues<R>;
    info_.edges.shows_steps = ShowsEdgeSteps<R>;
    edges_.emplace(rasterizer_, info_);
    if constexpr (!DrawsScenesByOptions<R> && !ShowsDrawings<R>) {
      info_.takes_culling = info_.takes_scissor = info_.takes_tiles = false;
    }
  }
  const SubjectInfo& OwnInfo() const override { return info_; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    if constexpr (DrawsBatches<R>) {
      if (jobs.size() > 1 && AreInTheUsualMode(jobs)) return DrawBatch(jobs);
    }
    return Subject::DrawMany(jobs);
  }

  const EdgeEvaluator* Edges() const override { return ShowsEdgeValues<R> ? &*edges_ : nullptr; }

 protected:
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if constexpr (ShowsDrawings<R>) {
      Subject::Draw(scene, options, counts);
    } else if constexpr (DrawsScenesByOptions<R>) {
      rasterizer_.Draw(scene, options, counts);
    } else {
      rasterizer_.Draw(scene, counts);
    }
  }
  Drawing Show(const DrawJob& job) override {
    if constexpr (ShowsDrawings<R>) {
      return job.triangles ? rasterizer_.Show(Resolved(job)) : rasterizer_.Show(job);
    } else {
      return Subject::Show(job);
    }
  }

 private:
  class ShownEdges final : public StatedEdges {
   public:
    ShownEdges(R& rasterizer, const SubjectInfo& info)
        : StatedEdges(info.edges, info.input), rasterizer_(rasterizer) {}
    double Value(Point2 a, Point2 b, Point2 p) const override {
      if constexpr (ShowsEdgeValues<R>) return rasterizer_.EdgeValue(a, b, p);
      return 0;
    }
    std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
      if constexpr (ShowsEdgeSteps<R>) return rasterizer_.EdgeSteps(a, b, p, step, steps);
      return {};
    }

   private:
    R& rasterizer_;
  };

  std::vector<DrawOutcome> DrawBatch(std::span<const DrawJob> jobs) {
    std::vector<DrawJob> resolved;
    for (const DrawJob& job : jobs) resolved.push_back(Resolved(job));
    std::vector<DrawOutcome> outcomes(1);
    outcomes.front().end = EndOf([&] {
      std::vector<Drawing> drawings = rasterizer_.ShowMany(resolved);
      if (drawings.size() != jobs.size()) {
        BreakDown("it drew " + std::to_string(drawings.size()) + " of " +
                  std::to_string(jobs.size()) + " scenes");
      }
      outcomes.resize(jobs.size());
      for (std::size_t k = 0; k < jobs.size(); ++k) outcomes[k].drawing = std::move(drawings[k]);
    });
    return outcomes;
  }

  // The job with its triangles in its scene, where the user's type looks for them.
  static DrawJob Resolved(const DrawJob& job) {
    if (!job.triangles) return job;
    DrawJob resolved(SceneOf(job), job.options, job.samples);
    resolved.wants = job.wants;
    return resolved;
  }

  SubjectInfo info_;
  R rasterizer_;
  std::optional<ShownEdges> edges_;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_RASTERIZER_H_
