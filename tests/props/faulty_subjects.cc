#include "tests/props/faulty_subjects.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "exact/coverage.h"
#include "props/judging/redraw.h"
#include "props/run/campaign.h"

namespace rasterproof::props::testing {
namespace {

template <class T>
T EdgeFunction(const Vertex& a, const Vertex& b, Point2 p) {
  const T left =
      (static_cast<T>(p.x) - static_cast<T>(a.x)) * (static_cast<T>(b.y) - static_cast<T>(a.y));
  const T right =
      (static_cast<T>(p.y) - static_cast<T>(a.y)) * (static_cast<T>(b.x) - static_cast<T>(a.x));
  return left - right;
}

template <class T>
bool Inside(const std::array<Vertex, 3>& v, Point2 p) {
  for (std::size_t e = 0; e < 3; ++e) {
    const Vertex& a = v[e];
    const Vertex& b = v[(e + 1) % 3];
    const T value = EdgeFunction<T>(a, b, p);
    const bool owned = b.y > a.y || (b.y == a.y && b.x < a.x);
    if (!(owned ? value >= 0 : value > 0)) return false;
  }
  return true;
}

template <class T>
void DrawNaively(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  const PixelRect box = options.scissor.value_or(PixelRect{0, 0, scene.width, scene.height});
  for (const Triangle& t : scene.triangles) {
    std::array<Vertex, 3> v = Corners(scene, t);
    const T area = EdgeFunction<T>(v[0], v[1], WindowPoint(v[2]));
    if (!(area != 0)) continue;
    if (options.cull == (area > 0 ? Cull::kFront : Cull::kBack)) continue;
    if (area < 0) std::swap(v[1], v[2]);
    std::vector<std::uint32_t>& side = area > 0 ? counts.front : counts.back;
    for (int row = box.y0; row < box.y1; ++row) {
      for (int i = box.x0; i < box.x1; ++i) {
        if (Inside<T>(v, {i + 0.5, row + 0.5})) ++side[counts.Index(i, row)];
      }
    }
  }
}

}  // namespace

SubjectInfo RealInfo(Precision input) {
  SubjectInfo info;
  info.name = "fake";
  info.input = input;
  return info;
}

SubjectInfo SnappedInfo(int bits) {
  SubjectInfo info = RealInfo();
  info.profile.snap.bits = bits;
  info.profile.coordinate_limit = 0x1p15;
  return info;
}

void DrawRight(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  counts += exact::Coverage(scene, Profile{}, options);
}

FakeSubject Sound(const SubjectInfo& info) {
  return {info, [profile = info.profile](const Scene& scene, const DrawOptions& options,
                                         CoverageCounts& counts) {
            counts += exact::Coverage(scene, profile, options);
          }};
}

FakeSubject WithProfile(const SubjectInfo& info, const std::function<void(Profile&)>& change) {
  Profile profile = info.profile;
  change(profile);
  return {info, [profile](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            counts += exact::Coverage(scene, profile, options);
          }};
}

FakeSubject DropsLastColumn(const SubjectInfo& info) {
  return {info, [profile = info.profile](const Scene& scene, const DrawOptions& options,
                                         CoverageCounts& counts) {
            counts += exact::Coverage(scene, profile, options);
            for (int row = 0; row < counts.height; ++row) {
              const std::size_t index = counts.Index(counts.width - 1, row);
              counts.front[index] = counts.back[index] = 0;
            }
          }};
}

FakeSubject Inclusive(const SubjectInfo& info) {
  return WithProfile(info, [](Profile& profile) { profile.tie_rule.inclusive = true; });
}

FakeSubject NaiveFloat32(const SubjectInfo& info) { return {info, DrawNaively<float>}; }

FakeSubject NaiveFloat64(const SubjectInfo& info) { return {info, DrawNaively<double>}; }

FakeSubject LosesLarge(const SubjectInfo& info, double side) {
  return {info, [profile = info.profile, side](const Scene& scene, const DrawOptions& options,
                                               CoverageCounts& counts) {
            Scene kept = scene;
            std::erase_if(kept.triangles, [&](const Triangle& t) {
              const std::array<Vertex, 3> v = Corners(scene, t);
              return std::fabs(v[0].x - v[1].x) >= side || std::fabs(v[1].x - v[2].x) >= side ||
                     std::fabs(v[2].x - v[0].x) >= side;
            });
            counts += exact::Coverage(kept, profile, options);
          }};
}

FakeSubject Throwing(const SubjectInfo& info) {
  return {info, [profile = info.profile](const Scene& scene, const DrawOptions& options,
                                         CoverageCounts& counts) {
            for (const Vertex& v : scene.vertices) {
              if (v.x < -1) throw std::runtime_error("negative column");
            }
            counts += exact::Coverage(scene, profile, options);
          }};
}

namespace {

Checks AskForTheModel(const PlacedCase& c, const Description& /*subject*/) {
  if (!WithinLimits(c.scene, c.profile)) return {};
  Questions questions;
  questions.draws.push_back(CountsOf(c.scene, c.profile, c.options));
  return OneCheck(std::move(questions), [&c](const Answers& answers) {
    const CoverageCounts expected = exact::Coverage(c.scene, c.profile, c.options);
    const CoverageDifference difference = Compare(answers.draws[0]->counts, expected);
    if (difference.wrong == 0) return Verdict::Held(difference.samples);
    const int pixel = static_cast<int>(difference.first_wrong);
    return Verdict::Violated(difference.samples, "wrong sample",
                             Witness{.x = pixel % c.scene.width,
                                     .y = pixel / c.scene.width,
                                     .observed = {},
                                     .expected = {}});
  });
}

}  // namespace

Property ModelProperty(std::span<const std::string_view> domains) {
  return {.name = "CoverageIsTheModels",
          .group = "coverage",
          .clause = "the counts are those of the canonical model",
          .tolerance = "none: exact",
          .domains = domains,
          .gate = {.space = Space::kEither,
                   .contract = ContractNeeded::kNone,
                   .bound_by = BoundBy::kNothing},
          .ask = AskForTheModel};
}

Verdict CoverageIsTheModels(Subject& subject, const Case& c) {
  return RunCase(subject, ModelProperty({}), c);
}

}  // namespace rasterproof::props::testing
