#include <cstddef>
#include <memory>
#include <utility>

#include "exact/attributes.h"
#include "subjects/builtin/builtin.h"
#include "tests/props/planted_bugs.h"

namespace rasterproof::props {
namespace {

// The last triangle that the sound subject draws on each sample, its barycentrics and depth.
Drawing SoundFragments(Subject& sound, const DrawJob& job) {
  const Scene scene = SceneOf(job);
  Drawing drawing;
  drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
  drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
  drawing.barycentrics.resize(drawing.counts.size());
  drawing.depths.resize(drawing.counts.size());
  const SamplePattern& lattice = sound.Info().profile.pattern;
  DrawJob one = job;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    one.triangles = {scene.triangles[t]};
    const CoverageCounts covered = DrawOne(sound, one).counts;
    const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
    const std::array<Point2, 3> at{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
    for (int row = 0; row < scene.height; ++row) {
      for (int i = 0; i < scene.width * job.samples; ++i) {
        const std::size_t k = covered.Index(i / job.samples, row, i % job.samples);
        if (covered.Count(k) == 0) continue;
        const Point2 p = lattice.At(i / job.samples, row, i % job.samples);
        const auto barycentrics = *exact::Barycentrics(at, p);
        drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
        drawing.counts.front[k] = 1;
        drawing.barycentrics[k] = {barycentrics[0].ToDouble(), barycentrics[1].ToDouble(),
                                   barycentrics[2].ToDouble()};
        drawing.depths[k] = exact::Interpolate(at, {v[0].z, v[1].z, v[2].z}, p)->ToDouble();
      }
    }
  }
  if (job.wants.centroids && job.samples == 1) drawing.centroids = drawing.barycentrics;
  return drawing;
}

}  // namespace

PlantedSubject::PlantedSubject(std::unique_ptr<Subject> sound, Bug bug)
    : sound_(std::move(sound)), bug_(std::move(bug)), info_(sound_->Info()) {
  info_.name += " with a planted bug";
  info_.takes_threads = bug_.states_threads;
  if (bug_.show) info_.coverage = CoverageKind::kFragments;
  info_.fragments.shows_centroids = bug_.show && info_.profile.pattern.samples() == 1;
  info_.takes_batches = static_cast<bool>(bug_.batch);
  if (bug_.states) bug_.states(info_.profile);
}

Subject* PlantedSubject::Twin() {
  if (!twin_ && bug_.has_twin) {
    twin_ = std::make_unique<PlantedSubject>(subjects::MakeBuiltin(sound_->Info().name), bug_);
  }
  return twin_.get();
}

void PlantedSubject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  if (bug_.draw) {
    bug_.draw(*sound_, scene, options, counts);
  } else {
    DrawOnto(*sound_, scene, options, counts);
  }
}

Drawing PlantedSubject::Show(const DrawJob& job) {
  if (!bug_.show) return Subject::Show(job);
  Drawing drawing = SoundFragments(*sound_, job);
  bug_.show(drawing, job);
  return drawing;
}

std::vector<DrawOutcome> PlantedSubject::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes = Subject::DrawMany(jobs);
  if (bug_.batch && jobs.size() > 1) bug_.batch(outcomes);
  return outcomes;
}

double PlantedSubject::Value(Point2 a, Point2 b, Point2 p) const {
  const double sound = sound_->Edges()->Value(a, b, p);
  return bug_.value ? bug_.value(sound, a, b, p) : sound;
}

double PlantedSubject::ErrorBound(Point2 a, Point2 b, Point2 p) const {
  return sound_->Edges()->ErrorBound(a, b, p);
}

std::vector<double> PlantedSubject::Steps(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const {
  std::vector<double> values = sound_->Edges()->Steps(a, b, p, step, steps);
  if (bug_.stepping) bug_.stepping(values, step);
  return values;
}

std::vector<double> PlantedSubject::SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                                        int steps) const {
  return sound_->Edges()->SteppingErrorBounds(a, b, p, step, steps);
}

std::array<double, 3> PlantedSubject::Barycentrics(BarycentricForm form,
                                                   const std::array<Point2, 3>& v, Point2 p) const {
  std::array<double, 3> barycentrics = sound_->Barycentrics()->Barycentrics(form, v, p);
  if (bug_.barycentrics) bug_.barycentrics(barycentrics, form, v);
  return barycentrics;
}

std::array<double, 3> PlantedSubject::BarycentricErrorBounds(BarycentricForm form,
                                                             const std::array<Point2, 3>& v,
                                                             Point2 p) const {
  return sound_->Barycentrics()->BarycentricErrorBounds(form, v, p);
}

double PlantedSubject::SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                                     Point2 p) const {
  return sound_->Barycentrics()->SumErrorBound(form, v, p);
}

double PlantedSubject::Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                                   const std::array<double, 3>& attribute, Point2 p) const {
  return bug_.interpolate ? bug_.interpolate(*sound_->Barycentrics(), form, v, attribute, p)
                          : sound_->Barycentrics()->Interpolate(form, v, attribute, p);
}

double PlantedSubject::InterpolationErrorBound(InterpolationForm form,
                                               const std::array<Corner, 3>& v,
                                               const std::array<double, 3>& attribute,
                                               Point2 p) const {
  return sound_->Barycentrics()->InterpolationErrorBound(form, v, attribute, p);
}

std::array<double, 3> PlantedSubject::EdgeDistances(WireframeForm form,
                                                    const std::array<Point2, 3>& v,
                                                    Point2 p) const {
  return bug_.distances ? bug_.distances(*sound_->Barycentrics(), form, v, p)
                        : sound_->Barycentrics()->EdgeDistances(form, v, p);
}

}  // namespace rasterproof::props
