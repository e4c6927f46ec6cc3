// rasterproof_oracle.h.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/float_environment.h"
#include "core/own_precision.h"
#include "core/profile.h"
#include "core/sample_text.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/target_size.h"
#include "exact/attributes.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/placed_scene.h"
#include "exact/values.h"
#include "io/case_file.h"
#include "io/json_writer.h"
#include "kit/rasterproof_oracle.h"
#include "legal/allowed.h"
#include "legal/alone.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "model/snap.h"
#include "model/target_profile.h"

struct rasterproof_oracle_profile {
  rasterproof::Profile stated;
  std::uint64_t serial = 0;  ///< no other profile ever opened has it
};

namespace rasterproof::kit {
namespace {

thread_local std::array<char, 1024> last_message{};

void SetMessage(std::string_view message) {
  const std::size_t n = message.copy(last_message.data(), last_message.size() - 1);
  last_message[n] = '\0';
}

rasterproof_oracle_status Fail(rasterproof_oracle_status status, std::string_view message) {
  SetMessage(message);
  return status;
}

// A preset's name alone is no JSON. They are told apart by the first character, so that a name that
// is no preset's is reported as a name.
Profile ProfileOf(const std::string& text_or_preset) {
  const std::size_t begin = text_or_preset.find_first_not_of(" \t\r\n");
  const bool is_json =
      begin != std::string::npos && (text_or_preset[begin] == '{' || text_or_preset[begin] == '"');
  return io::ParseProfile(is_json ? text_or_preset : io::JsonString(text_or_preset), "the profile");
}

// The profile states nothing of what was asked.
struct NotDecided {
  std::string why;
};

template <class Act>
rasterproof_oracle_status Guarded(const Act& act) noexcept {
  try {
    const FloatEnvironment sane;
    act();
    return RASTERPROOF_ORACLE_OK;
  } catch (const NotDecided& not_decided) {
    return Fail(RASTERPROOF_ORACLE_NOT_DECIDED, not_decided.why);
  } catch (const InputError& error) {
    return Fail(RASTERPROOF_ORACLE_BAD_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return Fail(RASTERPROOF_ORACLE_NO_MEMORY,
                "not enough memory; draw on a smaller target, or in parts");
  } catch (const std::exception& error) {
    return Fail(RASTERPROOF_ORACLE_FAULT, error.what());
  } catch (...) {
    return Fail(RASTERPROOF_ORACLE_FAULT, "an exception of an unknown type");
  }
}

template <class T>
T& Required(T* argument, const char* name) {
  if (argument == nullptr) throw InputError(name, "null", "give one");
  return *argument;
}

template <class T>
std::span<T> ArrayOf(T* values, std::size_t size, const std::string& name) {
  if (values == nullptr && size != 0) throw InputError(name, "null", "give the array");
  return {values, size};
}

Scene SceneOf(const rasterproof_oracle_scene* argument, const Profile& profile) {
  const rasterproof_oracle_scene& given = Required(argument, "scene");
  RequireTargetSize("scene", given.width, given.height, profile.pattern.samples());
  constexpr std::size_t kMostListed = std::size_t{1} << 26;
  if (given.vertex_count > kMostListed || given.triangle_count > kMostListed) {
    throw InputError("scene", "more than 2^26 vertices or triangles", "give it in parts");
  }
  Scene scene;
  scene.name = "scene";
  scene.width = given.width;
  scene.height = given.height;
  scene.precision = Precision::kFloat64;
  scene.clip_space = given.clip_space != 0;
  const std::span<const double> numbers =
      ArrayOf(given.vertices, 4 * given.vertex_count, "scene.vertices");
  for (std::size_t v = 0; v < given.vertex_count; ++v) {
    const auto xyzw = numbers.subspan(4 * v, 4);
    const double w = scene.clip_space ? xyzw[3] : 1;
    scene.vertices.push_back({xyzw[0], xyzw[1], xyzw[2], w});
  }
  const std::span<const std::int32_t> indices =
      ArrayOf(given.triangles, 3 * given.triangle_count, "scene.triangles");
  for (std::size_t t = 0; t < given.triangle_count; ++t) {
    for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
      if (indices[k] >= 0 && static_cast<std::size_t>(indices[k]) < given.vertex_count) continue;
      throw InputError("scene.triangles, triangle " + std::to_string(t),
                       "index " + std::to_string(indices[k]) + " of " +
                           std::to_string(given.vertex_count) + " vertices",
                       "give indices from 0 on");
    }
    scene.triangles.push_back({indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
  }
  return scene;
}

std::size_t SamplesOf(const Scene& scene, const Profile& profile) {
  return CoverageCounts::Size(scene.width, scene.height, profile.pattern.samples());
}

void RequireSize(std::size_t size, std::size_t wanted, const std::string& shape) {
  if (size == wanted) return;
  throw InputError("size", std::to_string(size) + " elements",
                   "give " + shape + ", " + std::to_string(wanted));
}

void RequireCounts(std::size_t size, const Scene& scene, const Profile& profile) {
  RequireSize(size, SamplesOf(scene, profile), "height * width * samples of a pixel");
}

// For each triangle and sample, a rasterproof_oracle_decision.
std::vector<std::uint8_t> DecisionsOf(const Scene& scene, const Profile& profile) {
  if (auto why = legal::WhyNotAlone(scene, profile)) throw NotDecided{*std::move(why)};
  const std::size_t samples = SamplesOf(scene, profile);
  std::vector<std::uint8_t> decisions(scene.triangles.size() * samples,
                                      RASTERPROOF_ORACLE_MUST_NOT);
  std::size_t first = 0;
  for (const legal::TriangleDecided& triangle : legal::DecideAlone(scene, profile)) {
    const auto of = std::span(decisions).subspan(std::exchange(first, first + samples), samples);
    if (triangle.is_anything) std::ranges::fill(of, std::uint8_t{RASTERPROOF_ORACLE_MAY});
    for (const std::size_t s : triangle.must) of[s] = RASTERPROOF_ORACLE_MUST;
    for (const std::size_t s : triangle.may) of[s] = RASTERPROOF_ORACLE_MAY;
  }
  return decisions;
}

void RequireJoint(const Scene& scene, const Profile& profile) {
  if (auto why = legal::WhyNotJoint(scene, {profile, scene})) throw NotDecided{*std::move(why)};
}

CoverageCounts ModelOf(const Scene& scene, const Profile& profile) {
  const exact::PlacedScene placed(scene, profile);
  if (const auto why = exact::WhyNotDecided(placed)) throw NotDecided{why->what()};
  return exact::Coverage(placed);
}

std::string WhyNotLegal(const legal::JointVerdict& verdict, const Scene& scene, int samples) {
  if (!verdict.core || verdict.core->requirements.empty()) return "no legal model explains it";
  const legal::Core& core = *verdict.core;
  const legal::Requirement& first = core.requirements.front();
  const std::string at = SampleText(first.sample, scene.width, samples);
  if (core.requirements.size() > 1) {
    return "no legal model explains " + std::to_string(core.requirements.size()) +
           " samples together; the first: " + at;
  }
  return at + ": covered " + std::to_string(first.least) +
         (first.least == first.most ? " times" : " times or more") + "; legal models cover it " +
         RangeText(first.legal_least, first.legal_most) + " times";
}

// "2", "1 to 3", "1 or more".
std::string AllowedText(const legal::Allowed& allowed, std::size_t s) {
  const std::uint32_t most = allowed.Most(s);
  if (most == legal::Allowed::kUnbounded) return std::to_string(allowed.Least(s)) + " or more";
  return RangeText(allowed.Least(s), most);
}

// Judges a profile that names every vertex's place, where legal::JudgeJointly() is not for the
// scene: clip space, a transform of its own.
std::int32_t JudgeByPlaces(const Scene& scene, const legal::Allowed& allowed,
                           const CoverageCounts& drawn) {
  const std::vector<std::size_t> wrong = allowed.Wrong(drawn);
  if (wrong.empty()) return RASTERPROOF_ORACLE_LEGAL;
  const std::size_t s = wrong.front();
  SetMessage(SampleText(s, scene.width, drawn.samples) + ": covered " +
             std::to_string(drawn.Count(s)) + " times; the model covers it " +
             AllowedText(allowed, s) + " times");
  return RASTERPROOF_ORACLE_NOT_LEGAL;
}

std::int32_t Judge(const Scene& scene, const Profile& profile, const CoverageCounts& drawn,
                   bool is_mask) {
  const TargetProfile target(profile, scene);
  const bool is_searched = !legal::WhyNotJoint(scene, target);
  if (!is_searched && HasOneModel(profile) && !legal::WhyNotAlone(scene, profile)) {
    const legal::Allowed allowed(exact::PlacedScene(scene, profile),
                                 {is_mask ? CoverageKind::kMask : CoverageKind::kCounts});
    return JudgeByPlaces(scene, allowed, drawn);
  }
  RequireJoint(scene, profile);
  legal::Observed observed;
  observed.together = &drawn;
  observed.is_mask = is_mask;
  const legal::JointVerdict verdict = legal::JudgeJointly(scene, target, observed);
  switch (verdict.legality) {
    case legal::Legality::kLegal:
      return RASTERPROOF_ORACLE_LEGAL;
    case legal::Legality::kNotLegal:
      SetMessage(WhyNotLegal(verdict, scene, drawn.samples));
      return RASTERPROOF_ORACLE_NOT_LEGAL;
    case legal::Legality::kNotJudged:
      break;
  }
  SetMessage("a component of the scene, " + std::to_string(verdict.largest_given_up) +
             " triangles, is too large to search");
  return RASTERPROOF_ORACLE_NOT_JUDGED;
}

// The decisions of the triangle that this thread asked for last, sample by sample, are kept.
struct LastTriangle {
  std::uint64_t serial = 0;
  int width = 0;
  int height = 0;
  std::array<double, 6> corners{};
  std::vector<std::uint8_t> decisions;
};

bool IsSame(const LastTriangle& last, std::uint64_t serial, int width, int height,
            const std::array<double, 6>& corners) {
  return last.serial == serial && last.width == width && last.height == height &&
         last.corners == corners;  // a NaN is equal to nothing, and decided anew
}

std::atomic<std::uint64_t> profiles_opened{0};

}  // namespace
}  // namespace rasterproof::kit

namespace kit = rasterproof::kit;
using kit::Guarded;
using kit::Required;

extern "C" {

uint32_t rasterproof_oracle_version(void) { return RASTERPROOF_ORACLE_VERSION; }

const char* rasterproof_oracle_message(void) { return kit::last_message.data(); }

rasterproof_oracle_status rasterproof_oracle_open(const char* text_or_preset,
                                                  rasterproof_oracle_profile** opened) {
  return Guarded([&] {
    rasterproof_oracle_profile*& to = Required(opened, "opened");
    rasterproof::exact::RequireHonestEnvironment();
    auto profile = std::make_unique<rasterproof_oracle_profile>();
    profile->stated = kit::ProfileOf(&Required(text_or_preset, "text_or_preset"));
    profile->serial = ++kit::profiles_opened;
    to = profile.release();
  });
}

void rasterproof_oracle_close(rasterproof_oracle_profile* profile) { delete profile; }

int32_t rasterproof_oracle_samples(const rasterproof_oracle_profile* profile) {
  return profile == nullptr ? 0 : profile->stated.pattern.samples();
}

rasterproof_oracle_status rasterproof_oracle_place(const rasterproof_oracle_profile* profile,
                                                   int32_t width, int32_t height, double x,
                                                   double y, double* placed_x, double* placed_y) {
  return Guarded([&] {
    const rasterproof::Profile& stated = Required(profile, "profile").stated;
    double& to_x = Required(placed_x, "placed_x");
    double& to_y = Required(placed_y, "placed_y");
    rasterproof::RequireTargetSize("width, height", width, height, stated.pattern.samples());
    rasterproof::Scene scene;
    scene.width = width;
    scene.height = height;
    scene.precision = rasterproof::Precision::kFloat64;
    scene.vertices = {{x, y}};
    const rasterproof::exact::PlacedScene placed(std::move(scene), stated);
    if (placed.why_not_placed) throw kit::NotDecided{placed.why_not_placed->what()};
    to_x = placed.placed.vertices[0].x;
    to_y = placed.placed.vertices[0].y;
  });
}

rasterproof_oracle_status rasterproof_oracle_counts(const rasterproof_oracle_profile* profile,
                                                    const rasterproof_oracle_scene* scene,
                                                    uint32_t* front, uint32_t* back, size_t size) {
  return Guarded([&] {
    const rasterproof::Profile& stated = Required(profile, "profile").stated;
    const rasterproof::Scene given = kit::SceneOf(scene, stated);
    kit::RequireCounts(size, given, stated);
    const auto to_front = kit::ArrayOf(front, size, "front");
    const auto to_back = kit::ArrayOf(back, size, "back");
    const rasterproof::CoverageCounts counts = kit::ModelOf(given, stated);
    std::ranges::copy(counts.front, to_front.begin());
    std::ranges::copy(counts.back, to_back.begin());
  });
}

rasterproof_oracle_status rasterproof_oracle_decide(const rasterproof_oracle_profile* profile,
                                                    const rasterproof_oracle_scene* scene,
                                                    uint8_t* decisions, size_t size) {
  return Guarded([&] {
    const rasterproof::Profile& stated = Required(profile, "profile").stated;
    const rasterproof::Scene given = kit::SceneOf(scene, stated);
    kit::RequireSize(size, kit::SamplesOf(given, stated) * given.triangles.size(),
                     "triangle_count * height * width * samples of a pixel");
    const auto to = kit::ArrayOf(decisions, size, "decisions");
    std::ranges::copy(kit::DecisionsOf(given, stated), to.begin());
  });
}

rasterproof_oracle_status rasterproof_oracle_bounds(const rasterproof_oracle_profile* profile,
                                                    const rasterproof_oracle_scene* scene,
                                                    uint32_t* least, uint32_t* most, size_t size) {
  return Guarded([&] {
    const rasterproof::Profile& stated = Required(profile, "profile").stated;
    const rasterproof::Scene given = kit::SceneOf(scene, stated);
    kit::RequireCounts(size, given, stated);
    const auto to_least = kit::ArrayOf(least, size, "least");
    const auto to_most = kit::ArrayOf(most, size, "most");
    kit::RequireJoint(given, stated);
    const rasterproof::legal::Decided decided =
        rasterproof::legal::DecidedSamples(given, {stated, given});
    for (std::size_t s = 0; s < size; ++s) {
      to_least[s] = static_cast<std::uint32_t>(decided.Least(s));
      to_most[s] = static_cast<std::uint32_t>(decided.Most(s));
    }
  });
}

rasterproof_oracle_status rasterproof_oracle_judge(const rasterproof_oracle_profile* profile,
                                                   const rasterproof_oracle_scene* scene,
                                                   const uint32_t* counts, size_t size,
                                                   int32_t is_mask, int32_t* verdict) {
  return Guarded([&] {
    const rasterproof::Profile& stated = Required(profile, "profile").stated;
    const rasterproof::Scene given = kit::SceneOf(scene, stated);
    kit::RequireCounts(size, given, stated);
    const auto shown = kit::ArrayOf(counts, size, "counts");
    std::int32_t& to = Required(verdict, "verdict");
    rasterproof::CoverageCounts drawn(given.width, given.height, stated.pattern.samples());
    std::ranges::copy(shown, drawn.front.begin());
    to = kit::Judge(given, stated, drawn, is_mask != 0);
  });
}

// NOLINTNEXTLINE(readability-function-size): numbers alone, for callers without structures.
int32_t rasterproof_oracle_covers(const rasterproof_oracle_profile* profile, int32_t width,
                                  int32_t height, double x0, double y0, double x1, double y1,
                                  double x2, double y2, int32_t column, int32_t row, int32_t s) {
  std::int32_t decision = 0;
  const rasterproof_oracle_status status = Guarded([&] {
    const rasterproof::Profile& stated = Required(profile, "profile").stated;
    rasterproof::RequireTargetSize("width, height", width, height, stated.pattern.samples());
    const bool is_within = column >= 0 && column < width && row >= 0 && row < height && s >= 0 &&
                           s < stated.pattern.samples();
    if (!is_within) {
      throw rasterproof::InputError("column, row, s", "not a sample of the target",
                                    "count each from 0");
    }
    thread_local kit::LastTriangle last;
    const std::array<double, 6> corners{x0, y0, x1, y1, x2, y2};
    if (!kit::IsSame(last, profile->serial, width, height, corners)) {
      rasterproof::Scene scene;
      scene.width = width;
      scene.height = height;
      scene.precision = rasterproof::Precision::kFloat64;
      scene.vertices = {{x0, y0}, {x1, y1}, {x2, y2}};
      scene.triangles = {{0, 1, 2}};
      last.serial = 0;
      last.decisions = kit::DecisionsOf(scene, stated);
      last = {profile->serial, width, height, corners, std::move(last.decisions)};
    }
    const auto samples = static_cast<std::size_t>(stated.pattern.samples());
    const std::size_t pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(column);
    decision = last.decisions[pixel * samples + static_cast<std::size_t>(s)];
  });
  return status == RASTERPROOF_ORACLE_OK ? decision : status;
}

int32_t rasterproof_oracle_edge_sign(double ax, double ay, double bx, double by, double px,
                                     double py) {
  for (const double x : {ax, ay, bx, by, px, py}) {
    if (!std::isfinite(x)) return 2;
  }
  const rasterproof::FloatEnvironment sane;
  return rasterproof::exact::EdgeSign({ax, ay}, {bx, by}, {px, py});
}

// NOLINTNEXTLINE(readability-function-size)
rasterproof_oracle_status rasterproof_oracle_barycentrics(double x0, double y0, double x1,
                                                          double y1, double x2, double y2,
                                                          double px, double py, double* b0,
                                                          double* b1, double* b2) {
  return Guarded([&] {
    double& to0 = Required(b0, "b0");
    double& to1 = Required(b1, "b1");
    double& to2 = Required(b2, "b2");
    for (const double x : {x0, y0, x1, y1, x2, y2, px, py}) {
      if (!std::isfinite(x))
        throw rasterproof::InputError("a coordinate", "not finite", "give finite numbers");
    }
    const auto exact = rasterproof::exact::Barycentrics({{{x0, y0}, {x1, y1}, {x2, y2}}}, {px, py});
    if (!exact) throw kit::NotDecided{"the triangle has no area"};
    to0 = (*exact)[0].ToDouble();
    to1 = (*exact)[1].ToDouble();
    to2 = (*exact)[2].ToDouble();
  });
}

// NOLINTNEXTLINE(readability-function-size)
rasterproof_oracle_status rasterproof_oracle_value(const double corners[9], const double numbers[3],
                                                   int32_t interpolation, double px, double py,
                                                   double* value, double* by_x, double* by_y) {
  namespace exact = rasterproof::exact;
  using rasterproof::InputError;
  return Guarded([&] {
    double& to = Required(value, "value");
    const std::span<const double, 9> v(&Required(corners, "corners"), 9);
    const std::span<const double, 3> a(&Required(numbers, "numbers"), 3);
    const auto is_finite = [](double x) { return std::isfinite(x); };
    if (!std::ranges::all_of(v, is_finite) || !std::ranges::all_of(a, is_finite) ||
        !std::isfinite(px) || !std::isfinite(py)) {
      throw InputError("a corner, a number or the point", "not finite", "give finite numbers");
    }
    if (interpolation < 1 || interpolation > 3) {
      throw InputError("interpolation", std::to_string(interpolation), "give 1, 2 or 3");
    }
    const exact::Interpolant interpolant(
        {{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}}, {px, py});
    const auto found = interpolant.Derivatives(
        static_cast<rasterproof::Interpolation>(interpolation), {a[0], a[1], a[2]});
    if (!found) throw kit::NotDecided{"the triangle has no area, or the point is on its horizon"};
    to = found->value.ToDouble();
    if (by_x != nullptr) *by_x = found->dx.ToDouble();
    if (by_y != nullptr) *by_y = found->dy.ToDouble();
  });
}

}  // extern "C"
