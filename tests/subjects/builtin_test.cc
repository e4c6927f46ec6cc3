// The built-in subjects: one per method, one per method with canonical edges, kernels, the plan.
#include "subjects/builtin/builtin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "reference/method.h"

namespace rasterproof::subjects {
namespace {

Scene Fan() {
  Scene scene;
  scene.width = scene.height = 16;
  scene.vertices = {{8.25, 7.5}, {0.5, 0.5}, {15.5, 0.25}, {15.5, 15.5}, {0.125, 15.75}};
  scene.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  return scene;
}

/// The same fan as any subject takes it: clip space has w = 1 already.
Scene FanFor(const SubjectInfo& info) {
  Scene scene = Fan();
  scene.clip_space = !info.takes_window;
  return scene;
}

CoverageCounts Drawn(Subject& subject, const DrawOptions& options = {}) {
  CoverageCounts counts(16, 16, subject.Info().profile.pattern.samples());
  DrawOnto(subject, FanFor(subject.Info()), options, counts);
  return counts;
}

TEST(BuiltinTest, EveryMethodIsASubjectAndTheCanonicalOnesTwice) {
  const std::vector<std::string> names = BuiltinNames();
  std::size_t expected = 0;
  for (const reference::Method& method : reference::Methods()) {
    const std::string name(method.name);
    EXPECT_EQ(std::ranges::count(names, name), 1) << name;
    EXPECT_EQ(std::ranges::count(names, name + ":canonical"), method.can_be_canonical ? 1 : 0)
        << name;
    expected += method.can_be_canonical ? 2 : 1;
  }
  for (const char* const name :
       {"kernel-incremental", "kernel-tiles", "kernel-fixed-tiles", "kernel-scanline",
        "kernel-exact-unsafe", "kernel-clip", "planned"}) {
    EXPECT_EQ(std::ranges::count(names, name), 1) << name;
    ++expected;
  }
  EXPECT_EQ(names.size(), expected);
  for (const std::string& name : names) {
    const std::unique_ptr<Subject> subject = MakeBuiltin(name);
    ASSERT_NE(subject, nullptr) << name;
    EXPECT_EQ(subject->Info().name, name);
  }
}

TEST(BuiltinTest, NamesThatAreNoSubjectGiveNone) {
  for (const char* const name : {"", "f32", "spans-exact:canonical", ":canonical",
                                 "f32-direct:", "f32-direct:canonical:canonical", "F32-DIRECT"}) {
    EXPECT_EQ(MakeBuiltin(name), nullptr) << name;
  }
}

TEST(BuiltinTest, OnlySoundMethodsStateToBeExact) {
  for (const char* const name : {"spans-exact", "filtered-exact", "i64-snap8", "i32-snap4",
                                 "planned", "kernel-fixed-tiles", "kernel-clip"}) {
    EXPECT_TRUE(MakeBuiltin(name)->Info().states_exact) << name;
  }
  for (const char* const name : {"textbook", "f32-direct", "f32-direct:canonical", "f64-kahan",
                                 "kernel-scanline", "kernel-exact-unsafe"}) {
    EXPECT_FALSE(MakeBuiltin(name)->Info().states_exact) << name;
  }
}

TEST(BuiltinTest, EqualCallsGiveEqualCountsFromManyThreadsAtOnce) {
  for (const std::string& name : BuiltinNames()) {
    const std::unique_ptr<Subject> subject = MakeBuiltin(name);
    const CoverageCounts expected = Drawn(*subject);
    EXPECT_NE(expected, CoverageCounts(16, 16, expected.samples)) << name;
    std::vector<CoverageCounts> results(4);
    {
      std::vector<std::jthread> threads;
      for (CoverageCounts& result : results) {
        threads.emplace_back([&] { result = Drawn(*subject); });
      }
    }
    for (const CoverageCounts& result : results) EXPECT_EQ(result, expected) << name;
  }
}

TEST(BuiltinTest, CanonicalSubjectsShowCanonicalEdgeValues) {
  const Point2 a{0.1F, 0.7F};
  const Point2 b{300.3F, 99.9F};
  const auto antisymmetric = [&](const char* name) {
    const std::unique_ptr<Subject> subject = MakeBuiltin(name);
    bool holds = true;
    for (double x = 100.5; x < 200; ++x) {
      const Point2 p{x, 50.5};
      holds = holds && subject->Edges()->Value(a, b, p) == -subject->Edges()->Value(b, a, p);
    }
    return holds;
  };
  EXPECT_TRUE(antisymmetric("f32-direct:canonical"));
  EXPECT_FALSE(antisymmetric("f32-direct"));
}

TEST(BuiltinTest, BarycentricsBelongToUnsnappedWindowSubjects) {
  EXPECT_NE(MakeBuiltin("f32-direct")->Barycentrics(), nullptr);
  EXPECT_NE(MakeBuiltin("spans-exact")->Barycentrics(), nullptr);
  EXPECT_EQ(MakeBuiltin("i64-snap8")->Barycentrics(), nullptr);
}

TEST(BuiltinTest, WhatIsProvedOfBarycentricsIsOfSubjectsThatShowThem) {
  for (const std::string& name : BuiltinNames()) {
    const std::unique_ptr<Subject> subject = MakeBuiltin(name);
    const auto of_barycentrics = std::ranges::count_if(
        subject->Info().proofs,
        [](const Proof& proof) { return proof.script.starts_with("barycentrics_"); });
    EXPECT_EQ(of_barycentrics, subject->Barycentrics() != nullptr ? 3 : 0) << name;
  }
}

}  // namespace
}  // namespace rasterproof::subjects
