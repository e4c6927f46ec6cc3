// The exact kernel on every domain, sink and instruction set, against the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/primitive_ids.h"
#include "library/kernels/crossing_errors.h"
#include "library/kernels/kernel.h"
#include "library/kernels/kernel_table.h"
#include "library/rasterize.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "tests/props/faulty_subjects.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::library::kernels {
namespace {

struct Given {
  std::vector<KernelVertex> vertices;
  std::vector<std::uint32_t> indices;
  KernelScene View(const Scene& scene) const {
    return {vertices, indices, scene.width, scene.height};
  }
};

Given GivenOf(const Scene& scene) {
  Given given;
  for (const Vertex& v : scene.vertices) {
    given.vertices.push_back(
        {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
  }
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) given.indices.push_back(static_cast<std::uint32_t>(index));
  }
  return given;
}

// The rows from `first` to before `last` alone.
void DrawBand(Target target, const KernelScene& scene, int first, int last, Surface& surface) {
  KernelView view = ViewOf(scene);
  Attach(surface, view);
  view.height = last;
  view.first_row = first;
  DrawExact(target, surface.sink(), view);
}

void ExpectCounts(Surface& surface, const CoverageCounts& expected, const std::string& name) {
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::size_t k = expected.Index(x, y, 0);
      const std::uint64_t counts = expected.front[k] | std::uint64_t{expected.back[k]} << 32;
      ASSERT_EQ(surface.At(x, y), counts) << name << " (" << x << ", " << y << ")";
    }
  }
}

// Whole, and in two bands.
void ExpectExact(const Scene& scene, const std::string& name) {
  const Given given = GivenOf(scene);
  const CoverageCounts expected = exact::Coverage(scene, Profile{});
  for (const Target target : SupportedTargets()) {
    const std::string where = name + " " + std::string(NameOf(target));
    Surface surface(Sink::kFacing, scene.width, scene.height);
    Draw(target, given.View(scene), surface);
    ExpectCounts(surface, expected, where);
    surface.Clear();
    const int middle = scene.height / 2;
    if (middle > 0) DrawBand(target, given.View(scene), 0, middle, surface);
    DrawBand(target, given.View(scene), middle, scene.height, surface);
    ExpectCounts(surface, expected, where + " in bands");
  }
}

// Bytes of a pixel in memory, and of a row's pixels. A mask's are bits.
std::size_t PixelBytes(Sink sink) { return sink == Sink::kCount8 || sink == Sink::kMask ? 1 : 4; }
std::size_t RowBytes(const Surface& surface) {
  const auto width = static_cast<std::size_t>(surface.width());
  return surface.sink() == Sink::kMask ? (width + 7) / 8 : width * PixelBytes(surface.sink());
}

void ExpectSame(Surface& surface, Surface& expected, const std::string& name) {
  const std::size_t pitch = static_cast<std::size_t>(surface.pitch()) * PixelBytes(surface.sink());
  for (const int k : {0, 1}) {
    if (surface.plane(k) == nullptr) continue;
    for (int y = 0; y < surface.height(); ++y) {
      const std::size_t row = pitch * static_cast<std::size_t>(y);
      ASSERT_EQ(std::memcmp(surface.plane(k) + row, expected.plane(k) + row, RowBytes(surface)), 0)
          << name << ' ' << NameOf(surface.sink()) << ", plane " << k << ", row " << y;
    }
  }
}

// Up to this many pixels times triangles the oracle says who covers each pixel last.
constexpr std::uint64_t kMostForIds = 1 << 22;

// What the scalar kernel keeps is what the oracle counts. Depths, and ids of larger scenes, are for
// the kernels to agree on.
void ExpectKept(Surface& surface, const Scene& scene, const CoverageCounts& expected,
                const std::string& name) {
  if (surface.sink() == Sink::kFacing) return ExpectCounts(surface, expected, name);
  if (surface.sink() == Sink::kDepth) return;
  std::vector<std::int32_t> last;
  if (surface.sink() == Sink::kId) {
    if (scene.triangles.size() * expected.size() > kMostForIds) return;
    last = exact::PrimitiveIds({scene, Profile{}}, {}, Visible::kLastDrawn);
  }
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::size_t k = expected.Index(x, y, 0);
      const std::uint64_t most = surface.sink() == Sink::kMask ? 1 : 255;
      const std::uint64_t kept = surface.sink() == Sink::kId
                                     ? static_cast<std::uint32_t>(last[k])
                                     : std::min<std::uint64_t>(expected.Count(k), most);
      ASSERT_EQ(surface.At(x, y), kept)
          << name << ' ' << NameOf(surface.sink()) << " (" << x << ", " << y << ")";
    }
  }
}

// From so many triangles on, workers draw in threads; below, waking them takes longer than drawing.
constexpr std::size_t kThreaded = 4096;

// The library's workers, which draw into the memory of surfaces: their parts at once, or one part
// after another.
class Crews {
 public:
  static constexpr std::array kCounts{1, 2, 3, 5};

  void Draw(const Given& given, std::size_t crew, Surface& surface) {
    const std::size_t bytes = PixelBytes(surface.sink());
    RasterTarget target{.output = kOutputs[static_cast<std::size_t>(surface.sink())],
                        .width = surface.width(),
                        .height = surface.height(),
                        .pitch = static_cast<std::size_t>(surface.pitch()) * bytes};
    // A surface has at least so many rows.
    const std::size_t room = static_cast<std::size_t>(surface.height() + 8) * target.pitch;
    target.memory = {surface.plane(0), room};
    if (surface.sink() == Sink::kFacing) target.back = {surface.plane(1), room};
    const std::span<const float> positions(&given.vertices.data()->x, 3 * given.vertices.size());
    auto& crews = given.indices.size() >= 3 * kThreaded ? at_once_ : in_turn_;
    crews[crew].Rasterize({positions, given.indices}, target);
  }

 private:
  static constexpr std::array kOutputs{RasterOutput::kCounts, RasterOutput::kFacingCounts,
                                       RasterOutput::kMask, RasterOutput::kIds,
                                       RasterOutput::kDepths};
  using Crew = RasterWorkers;
  static void InTurn(int count, const std::function<void(int)>& act) {
    for (int k = 0; k < count; ++k) act(k);
  }

  std::array<Crew, 4> at_once_{Crew(1), Crew(2), Crew(3), Crew(5)};
  std::array<Crew, 4> in_turn_{Crew(1, InTurn), Crew(2, InTurn), Crew(3, InTurn), Crew(5, InTurn)};
};

// The scalar kernel is the oracle; every other target, and the library by every number of workers,
// is the scalar kernel.
void ExpectExactEverywhere(const Scene& scene, Crews& crews, const std::string& name) {
  const Given given = GivenOf(scene);
  const CoverageCounts expected = exact::Coverage(scene, Profile{});
  for (const Sink sink : kSinks) {
    Surface scalar(sink, scene.width, scene.height);
    Draw(Target::kScalar, given.View(scene), scalar);
    ExpectKept(scalar, scene, expected, name);
    Surface other(sink, scene.width, scene.height);
    for (const Target target : SupportedTargets().subspan(1)) {
      other.Clear();
      Draw(target, given.View(scene), other);
      ExpectSame(other, scalar, name + " " + std::string(NameOf(target)));
    }
    for (std::size_t k = 0; k < Crews::kCounts.size(); ++k) {
      other.Clear();
      crews.Draw(given, k, other);
      ExpectSame(other, scalar, name + " workers " + std::to_string(Crews::kCounts[k]));
    }
    if (testing::Test::HasFatalFailure()) return;
  }
}

bool IsOfWindowFloats(const Scene& scene, std::int64_t most_pixels) {
  return !scene.clip_space && scene.precision == Precision::kFloat32 &&
         std::int64_t{scene.width} * scene.height <= most_pixels;
}

// Adds the scene's triangles, each with depths of random corners. The target grows to hold the
// scene's, up to so many pixels; beyond, it cuts them off.
void Join(const Scene& scene, std::int64_t most_pixels, reference::RandomValues& random,
          Scene& all) {
  const int width = std::max(all.width, scene.width);
  const int height = std::max(all.height, scene.height);
  if (std::int64_t{width} * height <= most_pixels) {
    all.width = width;
    all.height = height;
  }
  const auto first = static_cast<std::int32_t>(all.vertices.size());
  for (Vertex v : scene.vertices) {
    v.z = static_cast<float>(random.Uniform(-1, 1));
    all.vertices.push_back(v);
  }
  for (const Triangle& t : scene.triangles) {
    all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

// Draws at least so many triangles of the domain and returns how many: cases alone, in crowds, and
// in crowds of several parts for each worker on larger targets.
std::uint64_t ExpectExactOnDomain(const props::Domain& domain, std::uint64_t wanted, Crews& crews) {
  const SubjectInfo info = props::testing::RealInfo();
  reference::RandomValues random(35);
  std::uint64_t drawn = 0;
  std::uint64_t index = 0;
  for (int crowd = 0; drawn < wanted; ++crowd) {
    const bool is_large = crowd % 64 == 63;
    const std::size_t least = is_large ? 8192 : crowd % 4 == 0 ? 1 : 128;
    const std::int64_t most_pixels = is_large ? 1 << 18 : 1 << 16;
    Scene all;
    const std::uint64_t from = index;
    while (all.triangles.size() < least) {
      if (index > 1000 && drawn + all.triangles.size() == 0) return 0;  // it gives no such scenes
      props::PhiloxSource bits(1, index++);
      const Case c = domain.draw(bits, info);
      if (IsOfWindowFloats(c.scene, most_pixels)) Join(c.scene, most_pixels, random, all);
    }
    ExpectExactEverywhere(
        all, crews,
        std::string(domain.name) + ":" + std::to_string(from) + " to " + std::to_string(index - 1));
    if (testing::Test::HasFatalFailure()) return drawn;
    drawn += all.triangles.size();
  }
  return drawn;
}

// How many triangles of all domains: RASTERPROOF_TRIANGLES, or a case of each.
std::uint64_t HowMany() {
  const char* more = std::getenv("RASTERPROOF_TRIANGLES");
  return more == nullptr ? 0 : std::strtoull(more, nullptr, 10);
}

TEST(ExactKernel, EqualsTheOracleOnEveryDomain) {
  const SubjectInfo info = props::testing::RealInfo();
  const auto of_windows = std::ranges::count(props::Domains(), false, &props::Domain::clip);
  const std::uint64_t of_each = HowMany() / static_cast<std::uint64_t>(of_windows) + 1;
  Crews crews;
  std::uint64_t drawn = 0;
  int domains = 0;
  for (const props::Domain& domain : props::Domains()) {
    if (domain.clip) continue;
    for (int i = 0; i < Cases(60); ++i) {
      props::PhiloxSource bits(1, static_cast<std::uint64_t>(i));
      const Case c = domain.draw(bits, info);
      if (!IsOfWindowFloats(c.scene, 1 << 16)) continue;
      ExpectExact(c.scene, std::string(domain.name) + ":" + std::to_string(i));
      if (HasFatalFailure()) return;
    }
    const std::uint64_t of_this = ExpectExactOnDomain(domain, of_each, crews);
    if (HasFatalFailure()) return;
    drawn += of_this;
    domains += of_this > 0 ? 1 : 0;
  }
  std::cout << drawn << " triangles of " << domains << " domains: 0 samples differ\n";
}

// Edges that miss a pixel centre by less than a guess is off, in each tier: the far end of an edge
// through a vertex and a centre, rounded to float.
TEST(ExactKernel, EqualsTheOracleWhereEdgesMissCentres) {
  reference::RandomValues random(84);
  // Small, near, in steps, in double.
  struct Tier {
    int side;
    double left;
  };
  for (const auto& [side, left] : {Tier{6, 0}, Tier{48, 0}, Tier{200, 0}, Tier{200, 20000}}) {
    for (int i = 0; i < Cases(60); ++i) {
      Scene scene;
      scene.width = scene.height = side;
      for (int t = 0; t < 64; ++t) {
        const auto within = [&] { return random.Uniform(0, side); };
        const double x = std::floor(within()) + 0.5;
        const double y = std::floor(within()) + 0.5;
        const Vertex a{.x = static_cast<float>(within() - left), .y = static_cast<float>(within())};
        const double far = random.Uniform(1, 2);
        const double end_x = std::clamp(a.x + far * (x - a.x), 0.0, static_cast<double>(side));
        const double end_y = y == a.y ? y : a.y + (end_x - a.x) * (y - a.y) / (x - a.x);
        const Vertex b{.x = static_cast<float>(end_x), .y = static_cast<float>(end_y)};
        const Vertex c{.x = static_cast<float>(within()), .y = static_cast<float>(within())};
        const auto first = static_cast<std::int32_t>(scene.vertices.size());
        scene.vertices.insert(scene.vertices.end(), {a, b, c});
        scene.triangles.push_back({first, first + 1, first + 2});
      }
      ExpectExact(scene, std::to_string(side) + (left > 0 ? " far:" : ":") + std::to_string(i));
      if (HasFatalFailure()) return;
    }
  }
}

// The kernel's formula for one edge and row, in T, fused or not: what it is off.
template <class T>
double GuessError(const std::array<float, 4>& edge, double row, T error, bool fused) {
  const auto [ax, ay, cx, cy] = edge;
  const T slope = (T{cx} - T{ax}) / (T{cy} - T{ay});
  const T from = T{ax} + (T{0.5} + error);
  const T down = static_cast<T>(row) - T{ay};
  const T guess = fused ? std::fma(down, slope, from) : down * slope + from;
  using Long = long double;  // 64 bits: a product of differences of floats and a quotient
  const Long crossing =
      Long{ax} + (Long{row} - Long{ay}) * (Long{cx} - Long{ax}) / (Long{cy} - Long{ay});
  return static_cast<double>(std::fabs(Long{guess} - Long{0.5} - Long{error} - crossing));
}

// Of edges with both ends within [least, most], the largest error over its bound.
template <class T>
double WorstGuess(double least, double most, T error, std::uint64_t seed) {
  reference::RandomValues random(seed);
  double worst = 0;
  for (int i = 0; i < Cases(400'000); ++i) {
    std::array<float, 4> edge{};
    for (float& v : edge) v = static_cast<float>(random.Uniform(least, most));
    if (i % 4 == 0) edge[3] = std::nextafterf(edge[1], 1e9F);  // flat
    if (i % 4 == 1) edge[2] = edge[0] + static_cast<float>(random.Uniform(-1e-3, 1e-3));
    if (!(edge[1] < edge[3])) continue;
    const double row = std::floor(random.Uniform(edge[1], edge[3])) + 0.5;
    if (!(row >= double{edge[1]} && row < double{edge[3]})) continue;
    for (const bool fused : {false, true}) {
      worst = std::max(worst, GuessError<T>(edge, row, error, fused) / double{error});
    }
  }
  return worst;
}

TEST(ExactKernel, GuessesStayWithinTheirErrors) {
  // Before it is cut off, for which there is half of it.
  const double small = WorstGuess<float>(-0.5, 8.5, kSmallCrossingError / 2, 81);
  const double near = WorstGuess<float>(-0.5, 64.5, kNearCrossingError, 82);
  const double wide =
      WorstGuess<double>(-double{kGuessDomain}, double{kGuessDomain}, kCrossingError, 83);
  std::cout << "largest error / bound: small " << small << ", near " << near << ", wide " << wide
            << '\n';
  EXPECT_LT(small, 1);
  EXPECT_LT(near, 1);
  EXPECT_LT(wide, 1);
  EXPECT_GT(small, 0.05) << "the search looks where there is no error";
  EXPECT_GT(near, 0.05);
  EXPECT_GT(wide, 0.02);
}

}  // namespace
}  // namespace rasterproof::library::kernels
