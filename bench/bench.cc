#include "bench/bench.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <list>
#include <string>
#include <utility>
#include <vector>

#include "bench/thread_seconds.h"
#include "exact/coverage.h"
#include "props/run/facings.h"

namespace rasterproof::bench {
namespace {

// Pixels of the triangles' bounding boxes inside the target: what a box-scanning method visits.
std::uint64_t BoxPixels(const Scene& scene) {
  std::uint64_t pixels = 0;
  for (const Triangle& triangle : scene.triangles) {
    const auto v = Corners(scene, triangle);
    const auto side = [](double a, double b, double c, int size) {
      const double low =
          std::clamp(std::floor(std::min({a, b, c})), 0.0, static_cast<double>(size));
      const double high =
          std::clamp(std::ceil(std::max({a, b, c})), 0.0, static_cast<double>(size));
      return static_cast<std::uint64_t>(high - low);
    };
    pixels +=
        side(v[0].x, v[1].x, v[2].x, scene.width) * side(v[0].y, v[1].y, v[2].y, scene.height);
  }
  return pixels;
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// The oracle's counts of one scene, computed once for all profiles that have the same model.
class Truths {
 public:
  explicit Truths(const Scene& scene) : scene_(scene) {}

  const CoverageCounts& Of(const Profile& profile) {
    const auto found = std::ranges::find_if(
        known_, [&](const Truth& truth) { return SameModel(truth.profile, profile); });
    if (found != known_.end()) return found->counts;
    return known_.emplace_back(profile, exact::Coverage(scene_, profile)).counts;
  }

 private:
  struct Truth {
    Truth(const Profile& p, CoverageCounts c) : profile(p), counts(std::move(c)) {}
    Profile profile;
    CoverageCounts counts;
  };

  const Scene& scene_;
  std::list<Truth> known_;  // references to the counts stay valid
};

// By what it states, not by its name.
std::string_view ArithmeticOf(const SubjectInfo& info) {
  if (!info.profile.snap.IsNone()) return "fixed point";
  if (info.states_exact) return "exact";
  return info.input == Precision::kFloat64 ? "float64" : "float32";
}

void BenchFamily(const Family& family, std::span<Subject* const> subjects,
                 const BenchOptions& options, std::vector<BenchRow>& rows) {
  std::vector<Subject*> takers;
  for (Subject* subject : subjects) {
    if (Takes(subject->Info(), family.scene)) takers.push_back(subject);
  }
  Truths truths(family.scene);
  std::vector<std::vector<double>> seconds(takers.size());
  std::vector<BenchRow> found(takers.size());
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    for (std::size_t k = 0; k < takers.size(); ++k) {
      const Profile& own = takers[k]->Info().profile;
      CoverageCounts counts(family.scene.width, family.scene.height, own.pattern.samples());
      const double start = ThreadSeconds();
      props::DrawByFacing(*takers[k], family.scene, {}, counts);
      seconds[k].push_back(ThreadSeconds() - start);
      if (repetition != 0) continue;
      found[k].against_own = Compare(counts, truths.Of(own));
      if (own.pattern == SamplePattern{}) {
        found[k].against_real = Compare(counts, truths.Of(Profile{}));
      }
    }
  }
  double baseline = 0;
  for (std::size_t k = 0; k < takers.size(); ++k) {
    BenchRow& row = found[k];
    row.family = family.name;
    row.subject = takers[k]->Info().name;
    row.arithmetic = ArithmeticOf(takers[k]->Info());
    row.triangles = family.scene.triangles.size();
    row.box_pixels = BoxPixels(family.scene);
    row.median_seconds = Median(seconds[k]);
    row.least_seconds = std::ranges::min(seconds[k]);
    if (k == 0 || row.subject == kBaseline) baseline = row.least_seconds;
  }
  for (BenchRow& row : found) row.ratio = baseline > 0 ? row.least_seconds / baseline : 0;
  rows.insert(rows.end(), found.begin(), found.end());
}

}  // namespace

BenchResult RunBench(std::span<Subject* const> subjects, const BenchOptions& options) {
  BenchResult result;
  const bool present = std::ranges::any_of(
      subjects, [](const Subject* subject) { return subject->Info().name == kBaseline; });
  result.baseline =
      present ? std::string(kBaseline) : (subjects.empty() ? "" : subjects.front()->Info().name);
  result.repetitions = options.repetitions;
  result.seed = options.seed;
  for (const Family& family : Families(options.seed)) {
    if (options.progress) options.progress(std::string(family.name));
    BenchFamily(family, subjects, options, result.rows);
  }
  return result;
}

}  // namespace rasterproof::bench
