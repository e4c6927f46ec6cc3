// Vectors: what a file states of drawn cases, held against the deciders that it does not use.
#include "props/vectors/draw_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/ulp.h"
#include "exact/coverage.h"
#include "exact/values.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "model/snap_scene.h"
#include "props/vectors/stated_world.h"
#include "props/vectors/value_vectors.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

std::vector<TestVector> VectorsFor(const Profile& profile, std::uint64_t cases,
                                   bool only_on_lattice = false) {
  std::vector<TestVector> vectors;
  DrawVectors(profile, {.cases = cases, .only_on_lattice = only_on_lattice},
              [&](const TestVector& vector) {
                vectors.push_back(vector);
                return true;
              });
  return vectors;
}

Scene Alone(const TestVector& vector, std::size_t t) {
  Scene alone = vector.scene;
  alone.triangles = {vector.scene.triangles[t]};
  return alone;
}

std::vector<std::size_t> CoveredBy(const CoverageCounts& counts) {
  std::vector<std::size_t> covered;
  for (std::size_t s = 0; s < counts.size(); ++s)
    if (counts.Count(s) != 0) covered.push_back(s);
  return covered;
}

bool HasAll(const std::vector<std::size_t>& all, const std::vector<std::size_t>& some) {
  return std::ranges::includes(all, some);
}

std::vector<std::size_t> MustOrMay(const TriangleVector& triangle) {
  std::vector<std::size_t> both;
  std::ranges::merge(triangle.must, triangle.may, std::back_inserter(both));
  return both;
}

TEST(Vectors, OfOneModelAreWhatTheLegalModelsSay) {
  const Profile profile = *PresetProfile("d3d11-canonical");
  for (const TestVector& vector : VectorsFor(profile, 120)) {
    const legal::Decided decided = legal::DecidedSamples(vector.scene, {profile, vector.scene});
    ASSERT_EQ(vector.triangles.size(), decided.triangles.size());
    EXPECT_TRUE(vector.joint.empty());
    for (std::size_t t = 0; t < vector.triangles.size(); ++t) {
      EXPECT_EQ(vector.triangles[t].must, decided.triangles[t].must) << vector.name;
      EXPECT_TRUE(vector.triangles[t].may.empty());
      EXPECT_EQ(vector.triangles[t].facing, decided.triangles[t].facing) << vector.name;
    }
  }
}

// Every set has the canonical model of its specification: its drawing contradicts nothing.
TEST(Vectors, OfASetAdmitItsCanonicalModel) {
  for (const char* api : {"vulkan", "d3d11", "gl", "webgpu"}) {
    const Profile profile = *PresetProfile(api);
    const Profile canonical = *PresetProfile("d3d11-canonical");
    std::uint64_t joint = 0;
    for (const TestVector& vector : VectorsFor(profile, kOneCaseIn > 1 ? 40 : 80)) {
      std::vector<std::vector<std::size_t>> covered;
      for (std::size_t t = 0; t < vector.triangles.size(); ++t) {
        covered.push_back(CoveredBy(exact::Coverage(Alone(vector, t), canonical)));
        EXPECT_TRUE(HasAll(covered[t], vector.triangles[t].must)) << api << vector.name;
        EXPECT_TRUE(HasAll(MustOrMay(vector.triangles[t]), covered[t])) << api << vector.name;
      }
      for (const JointVector& at : vector.joint) {
        ++joint;
        const auto count = std::ranges::count_if(at.triangles, [&](std::size_t t) {
          return std::ranges::binary_search(covered[t], at.sample);
        });
        EXPECT_NE(std::ranges::count(at.counts, count), 0) << api << vector.name;
      }
    }
    EXPECT_GT(joint, 0U) << api;
  }
}

// A square of two triangles whose diagonal passes through sample centres: under vulkan each of
// them may leave such a sample to the other, and not both.
TEST(Vectors, SayThatExactlyOneOfTwoNeighboursOwnsASample) {
  Case c;
  c.profile = *PresetProfile("vulkan");
  c.scene.width = 4;
  c.scene.height = 4;
  c.scene.vertices = {{0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}};
  c.scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto vector = VectorOf(c, {});
  ASSERT_TRUE(vector);
  ASSERT_TRUE(vector->on_lattice);
  EXPECT_EQ((*vector->on_lattice)[1], (std::array<std::int32_t, 2>{896, 128}));
  const std::size_t on_the_diagonal = 1 * 4 + 1;
  for (const TriangleVector& triangle : vector->triangles) {
    EXPECT_TRUE(std::ranges::binary_search(triangle.may, on_the_diagonal));
    EXPECT_EQ(triangle.facing, -1);  // clockwise on screen
  }
  EXPECT_EQ(vector->triangles[0].must, (std::vector<std::size_t>{1 * 4 + 2}));
  const JointVector exactly_one{on_the_diagonal, {0, 1}, {1}};
  EXPECT_NE(std::ranges::count(vector->joint, exactly_one), 0);
  // At the square's corners, where both triangles end, nothing is stated.
  EXPECT_TRUE(std::ranges::none_of(
      vector->joint, [](const JointVector& at) { return at.sample == 0 || at.sample == 15; }));
}

TEST(Vectors, AreOfEveryHardKind) {
  std::set<std::string> domains;
  NearEdgeCounts near;
  std::size_t on_lattice = 0;
  const std::vector<TestVector> vectors = VectorsFor(*PresetProfile("vulkan"), 200);
  ASSERT_EQ(vectors.size(), 200U);
  for (const TestVector& vector : vectors) {
    domains.insert(vector.name.substr(0, vector.name.find(':')));
    near += vector.near_edges;
    on_lattice += vector.on_lattice ? 1 : 0;
    EXPECT_LE(std::max(vector.scene.width, vector.scene.height), kMostVectorSide);
    EXPECT_LE(vector.triangles.size(), kMostVectorTriangles);
  }
  for (const char* name : {"near-edge", "edges-through-samples", "needles", "shared-edge", "fans",
                           "degenerate", "snap-ties"})
    EXPECT_TRUE(domains.contains(name)) << name;
  for (const auto& [name, counter] : kNearEdgeCounters) EXPECT_GT(near.*counter, 0U) << name;
  EXPECT_GT(on_lattice, 50U);
}

TEST(Vectors, AreTheSameEachTimeAndOthersUnderAnotherSeed) {
  const Profile profile = *PresetProfile("d3d11-canonical");
  const std::vector<TestVector> vectors = VectorsFor(profile, 60);
  const std::vector<TestVector> again = VectorsFor(profile, 60);
  ASSERT_EQ(vectors.size(), again.size());
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    EXPECT_EQ(vectors[v].name, again[v].name);
    EXPECT_EQ(vectors[v].scene, again[v].scene);
    EXPECT_EQ(vectors[v].triangles, again[v].triangles);
  }
  for (const TestVector& vector : VectorsFor(profile, 60, /*only_on_lattice=*/true))
    EXPECT_TRUE(vector.on_lattice);
  std::vector<TestVector> others;
  DrawVectors(profile, {.seed = 2, .cases = 3}, [&](const TestVector& vector) {
    others.push_back(vector);
    return others.size() < 2;
  });
  ASSERT_EQ(others.size(), 2U);
  EXPECT_NE(others[0].scene, vectors[0].scene);
}

// The ends of each interval hold, and the floats beside them do not: by the oracle, from the error
// as it is stated.
TEST(Vectors, HaveIntervalsOfValuesWithExactEnds) {
  Profile profile = *PresetProfile("d3d11-canonical");
  profile.values.error = {.ulps = 1.5, .absolute = 0x1p-30};
  std::size_t values = 0;
  DrawVectors(profile, {.cases = 40, .with_values = true}, [&](const TestVector& vector) {
    const Scene placed = SnapVertices(vector.scene, {profile, vector.scene});
    for (const ValueVector& value : vector.values) {
      const Triangle& t = vector.scene.triangles[value.triangle];
      std::array<Point2, 3> at{};
      std::array<double, 3> w{}, a{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto v = static_cast<std::size_t>(t[i]);
        at[i] = WindowPoint(placed.vertices[v]);
        w[i] = vector.w[v];
        a[i] = vector.scene.channels[value.channel].values[v];
      }
      const auto width = static_cast<std::size_t>(vector.scene.width);
      const exact::Interpolant there(exact::WindowTriangle(at, w),
                                     {static_cast<double>(value.sample % width) + 0.5,
                                      static_cast<double>(value.sample / width) + 0.5});
      const auto exact = *there.Value(Interpolation::kPerspective, exact::ToAttribute(a));
      const auto holds = [&](float x) {
        return exact::IsWithin(static_cast<double>(x), exact, 0, profile.values.error,
                               Precision::kFloat32);
      };
      EXPECT_EQ(value.value.nearest, exact.ToFloat());
      EXPECT_TRUE(holds(value.value.low) && holds(value.value.high)) << vector.name;
      EXPECT_FALSE(holds(MoveByUlps(value.value.low, -1))) << vector.name;
      EXPECT_FALSE(holds(MoveByUlps(value.value.high, 1))) << vector.name;
      ++values;
    }
    return true;
  });
  EXPECT_GT(values, 1000U);
  EXPECT_THROW(RequireStatesValues(*PresetProfile("d3d11")), InputError);
}

TEST(Vectors, AreRefusedToProfilesThatStateNoSingleSamples) {
  for (const char* name : {"vulkan-4x", "d3d12-conservative-3"}) {
    const auto profile = PresetProfile(name);
    ASSERT_TRUE(profile) << name;
    EXPECT_THROW(RequireStatesSamples(*profile), InputError) << name;
  }
  Profile closed = *PresetProfile("d3d11-canonical");
  closed.contract = Contract::kClosed;
  EXPECT_THROW(RequireStatesSamples(closed), InputError);
  for (const char* name : {"real", "vulkan", "vulkan-standard-4x", "d3d11-8x", "gl", "webgpu"})
    EXPECT_NO_THROW(RequireStatesSamples(*PresetProfile(name))) << name;
}

TEST(StatedWorld, HasEveryTriangleOnce) {
  for (const char* name : {"u1.0", "s1.0", "1.1"}) {
    const StatedWorld world = ParseStatedWorld(name);
    const std::uint64_t cases = std::min<std::uint64_t>(world.Cases(), 4096);
    std::set<std::vector<double>> triangles;
    for (std::uint64_t k = 0; k < cases; ++k) {
      const Case c = CaseOfStatedWorld(world, k, *PresetProfile("d3d11-canonical"));
      std::vector<double> coordinates;
      for (const Vertex& v : c.scene.vertices) coordinates.insert(coordinates.end(), {v.x, v.y});
      const double least = world.has_sign ? -2 : 0;
      EXPECT_EQ(c.scene.width, 2);
      EXPECT_GE(std::ranges::min(coordinates), least);
      EXPECT_LE(std::ranges::max(coordinates), 2 - std::ldexp(1.0, -world.fraction_bits));
      triangles.insert(coordinates);
    }
    EXPECT_EQ(triangles.size(), cases) << name;
  }
  EXPECT_EQ(ParseStatedWorld("1.0").Cases(), 64U);
  EXPECT_EQ(ParseStatedWorld("2.1").Cases(), 262'144U);
  EXPECT_EQ(ParseStatedWorld("s2.1").Name(), "s2.1");
}

TEST(StatedWorld, OfOtherWordsIsRefused) {
  for (const char* text :
       {"", "3", "3.", "x3.2", "3.2.1", "0.4", "7.0", "6.5", "s5.5", "-1.2", "s"})
    EXPECT_THROW(ParseStatedWorld(text), InputError) << text;
}

TEST(Vectors, NameTheClausesThatRequireThem) {
  const Profile vulkan = *PresetProfile("vulkan");
  EXPECT_EQ(SampleClausesOf(vulkan),
            (std::vector<std::string>{"vulkan.point-sampling", "vulkan.subpixel-bits"}));
  EXPECT_EQ(JointClausesOf(vulkan), (std::vector<std::string>{"vulkan.common-edge"}));
  EXPECT_TRUE(SampleClausesOf(*PresetProfile("vulkan-canonical")).empty());
}

}  // namespace
}  // namespace rasterproof::props
