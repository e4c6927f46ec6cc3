// The table itself: names that others rely on, and what each row says of itself.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "reference/edge_forms.h"
#include "reference/edge_walks.h"
#include "reference/filtered_form.h"
#include "reference/homogeneous_edges.h"
#include "reference/integer_form.h"
#include "reference/method.h"

namespace rasterproof::reference {
namespace {

// What is no form, no walk and no sum is refused by its concept, not deep inside a template.
struct NoForm {
  using Scalar = float;
  using Point = PointOf<float>;
  float At(float, float) const { return 0; }
};
static_assert(EdgeForm<DirectForm<float>> && EdgeForm<FilteredForm> && !EdgeForm<NoForm>);
static_assert(SteppedForm<IntegerForm<std::int32_t, 4>> && !SteppedForm<FilteredForm>);
static_assert(RowWalking<FreshWalk<FilteredForm>> && !RowWalking<DirectForm<float>>);
static_assert(StepSum<PlainSum<float>, float> && !StepSum<float, float>);
static_assert(HomogeneousEdge<ExactHomogeneousEdge> && !HomogeneousEdge<Vertex>);

TEST(MethodTableTest, EveryNamedMethodIsThereOnce) {
  std::set<std::string> names;
  for (const Method& method : Methods()) {
    EXPECT_TRUE(names.emplace(method.name).second) << method.name;
    EXPECT_EQ(method.info.name, method.name);
    EXPECT_FALSE(method.summary.empty());
    EXPECT_NE(method.stages.fill, nullptr);
  }
  for (const char* const name :
       {"textbook", "f32-direct", "f32-direct-fma", "f32-kahan", "f32-affine", "f32-affine-fma",
        "f32-incremental", "f32-incremental-row", "f32-incremental-16",
        "f32-incremental-compensated", "f32-index", "f32-index-fma", "f64-direct", "f64-kahan",
        "f64-incremental", "i64-snap8", "i32-snap4", "filtered-exact", "spans-exact"}) {
    ASSERT_NE(FindMethod(name), nullptr) << name;
    EXPECT_NE(FindMethod(name)->edges, nullptr) << name;
  }
  EXPECT_EQ(FindMethod("f32"), nullptr);
}

TEST(MethodTableTest, FormatsProfilesAndStatementsFollowFromTheName) {
  for (const Method& method : Methods()) {
    if (!method.info.takes_window) continue;
    const std::string name(method.name);
    const bool is_float32 = name.starts_with("f32") || name == "textbook";
    const bool is_float = is_float32 || name.starts_with("f64");
    const bool is_integer = name.starts_with("i");
    EXPECT_EQ(method.info.input, is_float32 ? Precision::kFloat32 : Precision::kFloat64) << name;
    EXPECT_EQ(method.info.states_exact, !is_float) << name;
    EXPECT_EQ(method.can_be_canonical, is_float) << name;
    EXPECT_EQ(method.canonical_edges != nullptr, is_float) << name;
    EXPECT_EQ(method.info.profile.snap.IsNone(), !is_integer) << name;
    EXPECT_FALSE(method.info.profile.tie_rule.inclusive) << name;
  }
  EXPECT_EQ(FindMethod("i64-snap8")->info.profile.snap, (Snap{8, SnapRule::kNearestEven}));
  EXPECT_EQ(FindMethod("i32-snap4")->info.profile.snap, (Snap{4, SnapRule::kNearestEven}));
  EXPECT_EQ(FindMethod("i32-snap4")->info.profile.coordinate_limit, 1440);
  EXPECT_EQ(FindMethod("spans-exact")->info.profile.coordinate_limit,
            std::numeric_limits<double>::max());
}

TEST(MethodTableTest, ProofsAreOfTheMethodsOwnArithmetic) {
  using Scripts = std::vector<std::string>;
  const auto scripts = [](const char* name) {
    Scripts list;
    for (const Proof& proof : FindMethod(name)->info.proofs) list.push_back(proof.script);
    return list;
  };
  EXPECT_EQ(scripts("textbook"), Scripts{"edge_direct.g"}) << "it is the direct form";
  EXPECT_EQ(FindMethod("textbook")->info.proofs, FindMethod("f32-direct")->info.proofs);
  EXPECT_EQ(scripts("f32-direct-fma"), Scripts{"edge_direct.g"});
  EXPECT_EQ(scripts("f64-kahan"), Scripts{"edge_kahan.g"});
  EXPECT_EQ(scripts("f32-affine-fma"), Scripts{"edge_affine.g"});
  EXPECT_NE(FindMethod("f32-affine")->info.proofs, FindMethod("f32-affine-fma")->info.proofs);
  EXPECT_EQ(scripts("f32-incremental-16"), (Scripts{"edge_direct.g", "increment.g"}));
  EXPECT_EQ(scripts("f32-incremental-compensated"), Scripts{"edge_direct.g"});
  EXPECT_EQ(scripts("f32-index"), (Scripts{"edge_direct.g", "index.g"}));
  EXPECT_EQ(scripts("filtered-exact"), Scripts{"edge_filter.g"})
      << "its filter is another condition";
  EXPECT_EQ(scripts("spans-exact"),
            (Scripts{"row_crossing.g", "kernel_crossing.g", "kernel_steps.g"}));
  EXPECT_EQ(scripts("i32-snap4"), Scripts{"exactness.g"});
  EXPECT_EQ(scripts("hom-projected-f32"), Scripts{"edge_direct.g"});
  EXPECT_EQ(scripts("hom-exact"), (Scripts{"homogeneous.g", "clip_kernel.g", "clip_floats.g"}))
      << "of its filter, and of the kernel";
}

TEST(MethodTableTest, EveryScriptThatIsNamedIsThere) {
  for (const Method& method : Methods()) {
    for (const Proof& proof : method.info.proofs) {
      EXPECT_TRUE(std::filesystem::exists("reference/proofs/" + proof.script)) << proof.script;
      EXPECT_FALSE(proof.statement.empty());
    }
  }
}

}  // namespace
}  // namespace rasterproof::reference
