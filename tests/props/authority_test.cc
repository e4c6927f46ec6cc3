// Who asks for a property: a clause, the stated model, or users alone.
#include "props/authority.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/profile.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "core/value_rule.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

// A profile of the name that leaves more than one result legal.
Profile LegalSet(std::string_view name) {
  Profile profile;
  profile.name = name;
  profile.snap = {8, SnapRule::kNearestEven};
  profile.freedom.snap_tolerance = 0.6;
  return profile;
}

Profile OneModel(std::string_view name) {
  Profile profile = LegalSet(name);
  profile.freedom = {};
  return profile;
}

Grounds GroundsOf(std::string_view property, const Profile& profile) {
  return AuthorityOf(*FindProperty(property), profile);
}

std::vector<std::string> IdsOf(const Grounds& grounds) {
  std::vector<std::string> ids;
  for (const Clause* clause : grounds.clauses) ids.emplace_back(clause->id);
  return ids;
}

TEST(Authority, EveryClauseThatARowNamesExistsAndRequires) {
  for (const Property& property : Catalog()) {
    for (const std::string_view id : property.required_by) {
      ASSERT_NE(FindClause(id), nullptr) << property.name << ": " << id;
      EXPECT_NE(FindClause(id)->force, Force::kSilent) << property.name << ": " << id;
    }
    for (const std::string_view id : property.required_with_error) {
      ASSERT_NE(FindClause(id), nullptr) << property.name << ": " << id;
      EXPECT_EQ(FindClause(id)->force, Force::kRequired) << property.name << ": " << id;
    }
  }
}

TEST(Authority, ASentenceOfTheProfilesOwnSpecificationRequires) {
  const Grounds vulkan = GroundsOf("SharedEdgeSamplesAreCoveredOnce", LegalSet("vulkan"));
  EXPECT_EQ(vulkan.authority, Authority::kClause);
  EXPECT_EQ(IdsOf(vulkan),
            (std::vector<std::string>{"vulkan.common-edge", "vulkan.point-sampling"}));
  EXPECT_EQ(IdsOf(GroundsOf("IntegerTranslationMovesCoverage", LegalSet("gl"))),
            (std::vector<std::string>{"gl.translation"}));
}

TEST(Authority, WhatNoSentenceRequiresIsQuality) {
  EXPECT_EQ(GroundsOf("IntegerTranslationMovesCoverage", LegalSet("vulkan")).authority,
            Authority::kQuality);
  EXPECT_EQ(GroundsOf("TriangleOrderKeepsCoverage", LegalSet("gl")).authority, Authority::kQuality);
  EXPECT_EQ(GroundsOf("ClosedMeshCancels", LegalSet("vulkan")).authority, Authority::kQuality)
      << "at a silhouette both polygons lie on one side of their edge";
  EXPECT_EQ(GroundsOf("ClosedMeshCancels", LegalSet("d3d11")).authority, Authority::kClause);
  EXPECT_EQ(GroundsOf("EqualDrawsGiveEqualCounts", LegalSet("d3d11")).authority,
            Authority::kQuality);
  EXPECT_EQ(GroundsOf("TriangleOrderKeepsCoverage", LegalSet("webgpu")).authority,
            Authority::kClause);
}

TEST(Authority, AModelOrAUsersOwnProfileIsItsOwnAuthority) {
  for (const char* property :
       {"IntegerTranslationMovesCoverage", "TriangleOrderKeepsCoverage", "ClosedMeshCancels"}) {
    EXPECT_EQ(GroundsOf(property, OneModel("real")).authority, Authority::kStatedModel) << property;
    EXPECT_EQ(GroundsOf(property, OneModel("vulkan-canonical")).authority, Authority::kStatedModel)
        << property;
  }
  EXPECT_EQ(GroundsOf("ClosedMeshCancels", LegalSet("mine")).authority, Authority::kStatedModel);
  EXPECT_EQ(GroundsOf("TriangleOrderKeepsCoverage", OneModel("vulkan")).authority,
            Authority::kStatedModel)
      << "what is stated leaves one model";
}

TEST(Authority, AUsersOwnFreedomStatesNoMoreThanItsWords) {
  Profile mine = LegalSet("mine");
  EXPECT_EQ(GroundsOf("IntegerTranslationMovesCoverage", mine).authority, Authority::kQuality);
  mine.translation_invariant = true;
  EXPECT_EQ(GroundsOf("IntegerTranslationMovesCoverage", mine).authority, Authority::kStatedModel);
}

TEST(Authority, OnceAtAVertexIsQualityUnlessAnOwnerIsStated) {
  for (const char* name : {"gl", "vulkan", "webgpu", "mine"}) {
    EXPECT_EQ(GroundsOf("OpenTiesAreCoveredOnce", LegalSet(name)).authority, Authority::kQuality)
        << name;
  }
}

// What clauses say of exact barycentrics binds who says how far off its own may be.
TEST(Authority, AClauseAndAStatedErrorRequireTogether) {
  constexpr std::string_view kWithin = "FragmentBarycentricsStayWithinTheirError";
  for (const auto& [set, clause] : {std::pair{"gl", "gl.barycentric"},
                                    {"vulkan", "vulkan.barycentric"},
                                    {"d3d11", "d3d11.interpolator"},
                                    {"webgpu", "webgpu.barycentric"}}) {
    SubjectInfo info;
    info.profile = *PresetProfile(set);
    const std::array properties{kWithin, std::string_view("FragmentBarycentricsSumToOne")};
    for (const std::string_view property : properties) {
      EXPECT_EQ(AuthorityOf(*FindProperty(property), info).authority, Authority::kQuality)
          << set << ", " << property;
    }
    info.fragments.barycentric_error = 1e-5;
    for (const std::string_view property : properties) {
      const Grounds grounds = AuthorityOf(*FindProperty(property), info);
      EXPECT_EQ(grounds.authority, Authority::kClause) << set << ", " << property;
      EXPECT_EQ(IdsOf(grounds), std::vector<std::string>{clause}) << property;
    }
    EXPECT_EQ(AuthorityOf(*FindProperty("FragmentDepthFollowsItsBarycentrics"), info).authority,
              Authority::kQuality)
        << set << ": no error of depth is stated";
  }
}

// Clauses about depths and values bind who states the error of those, and no other.
TEST(Authority, EachErrorCallsTheClausesOfItsOwn) {
  SubjectInfo info;
  info.profile = *PresetProfile("vulkan");
  info.fragments.barycentric_error = 1e-5;
  const auto of = [&](std::string_view property) {
    return IdsOf(AuthorityOf(*FindProperty(property), info));
  };
  using Ids = std::vector<std::string>;
  EXPECT_EQ(of("ClipBarycentricsStayWithinTheirError"), Ids{"vulkan.barycentric-inputs"});
  EXPECT_EQ(of("ClipDepthsStayWithinTheirError"), Ids{});
  EXPECT_EQ(of("ValuesStayWithinTheirError"), Ids{});
  info.fragments.depth_error = 1e-6;
  EXPECT_EQ(of("ClipDepthsStayWithinTheirError"), Ids{"vulkan.depth"});
  info.profile.values.error.ulps = 2;
  EXPECT_EQ(of("ValuesStayWithinTheirError"), (Ids{"vulkan.perspective", "vulkan.linear"}));
  for (const std::string_view exact :
       {"EqualValuesStayEqual", "ValuesStayInTheHull", "VerticesKeepTheirValues",
        "DerivativesStayWithinTheirError", "CoveredSamplesHoldNumbers",
        "PermutedVerticesKeepTheirValues", "ValuesAreMonotoneAlongRows"})
    EXPECT_EQ(of(exact), Ids{}) << exact << ": no text speaks of a last bit";
  EXPECT_EQ(of("CentroidValuesStayWithinTheirError"), of("ValuesStayWithinTheirError"));
}

TEST(Authority, ClausesOfOtherValuesRequireNothing) {
  SubjectInfo info;
  const auto of = [&](std::string_view property) {
    return IdsOf(AuthorityOf(*FindProperty(property), info));
  };
  using Ids = std::vector<std::string>;
  constexpr std::string_view kFlat = "FlatValuesComeFromTheProvokingVertex";
  for (const auto& [set, first, last] :
       {std::tuple{"gl", Ids{"gl.flat", "gl.provoking"}, Ids{"gl.flat", "gl.provoking"}},
        {"d3d11", Ids{"d3d11.flat", "d3d11.leading-vertex"}, Ids{}},
        {"webgpu", Ids{"webgpu.flat"}, Ids{}}}) {
    info.profile = *PresetProfile(set);
    info.profile.values.provoking = ProvokingVertex::kFirst;
    EXPECT_EQ(of(kFlat), first) << set;
    info.profile.values.provoking = ProvokingVertex::kLast;
    EXPECT_EQ(of(kFlat), last) << set;
  }
  info.profile = *PresetProfile("d3d11");
  info.profile.values.derivatives = DerivativesBy::kFine;
  EXPECT_EQ(of("QuadDifferencesEqualDifferencesOfValues"), Ids{"d3d11.derivative-fine"});
  info.profile.values.quads = QuadOrigin::kOdd;
  EXPECT_EQ(of("QuadDifferencesEqualDifferencesOfValues"), Ids{}) << "the text leaves it open";
  info.profile = *PresetProfile("gl");
  info.profile.values.derivatives = DerivativesBy::kFine;
  EXPECT_EQ(of("QuadDifferencesEqualDifferencesOfValues"), Ids{}) << "they may be approximate";
  info.fragments.depth_error = 1e-6;
  info.profile.values.depth = DepthFormat::kUnorm24;
  EXPECT_EQ(of("DepthsAreOfTheirFormat"), Ids{"gl.depth-conversion"});
  info.profile.values.depth_rounding = DepthRounding::kNearest;
  EXPECT_EQ(of("DepthsAreOfTheirFormat"), Ids{}) << "either neighbour is legal";
  info.profile.values.depth_rounding = DepthRounding::kEither;
  info.profile.values.depth = DepthFormat::kFloat32;
  EXPECT_EQ(of("DepthsAreOfTheirFormat"), Ids{}) << "nothing is converted";
}

// With several samples OpenGL and Vulkan let a value at the centre be of elsewhere in the pixel.
TEST(Authority, ACentreOfSeveralSamplesIsNobodysInOpenGlAndVulkan) {
  for (const auto& [set, is_required] : {std::pair{"gl", true},
                                         {"gl-4x", false},
                                         {"vulkan-4x", false},
                                         {"d3d11-4x", true},
                                         {"webgpu-4x", true}}) {
    SubjectInfo info;
    info.profile = *PresetProfile(set);
    info.profile.values.error.ulps = 2;
    info.profile.values.centres = true;
    const Grounds grounds = AuthorityOf(*FindProperty("ValuesStayWithinTheirError"), info);
    EXPECT_EQ(grounds.authority == Authority::kClause, is_required) << set;
  }
}

TEST(Authority, BoundsThatASubjectStatesAreItsOwn) {
  for (const char* property : {"EdgeErrorStaysWithinItsBound", "BarycentricsSumToOne",
                               "SteppingStaysWithinItsBound", "EdgeIsZeroAtItsEnds"}) {
    EXPECT_EQ(GroundsOf(property, LegalSet("vulkan")).authority, Authority::kStatedModel)
        << property;
  }
}

TEST(Authority, ASpecificationHasTheClausesOfItsBase) {
  EXPECT_EQ(IdsOf(GroundsOf("NonFiniteTrianglesCoverNothing", LegalSet("d3d12"))),
            (std::vector<std::string>{"d3d11.nan"}));
  EXPECT_EQ(GroundsOf("NonFiniteTrianglesCoverNothing", LegalSet("gl")).authority,
            Authority::kQuality);
}

TEST(Authority, ClausesOfOtherSquaresRequireNothing) {
  const auto ids = [](std::string_view property, std::string_view preset) {
    return IdsOf(GroundsOf(property, *PresetProfile(preset)));
  };
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ids("SquaresThatMustBeAreCovered", "d3d12-conservative-1"), Ids{"d3d12.must-cover"});
  EXPECT_EQ(ids("SquaresThatMustBeAreCovered", "d3d12-conservative-2"),
            (Ids{"d3d12.must-cover", "d3d12.flat-tier-2"}));
  EXPECT_EQ(ids("SquaresThatMustBeAreCovered", "d3d12-inner"), Ids{"d3d12.inner-omission"});
  EXPECT_EQ(ids("SquaresOutsideTheMayRegionStayFree", "d3d12-conservative-1"),
            Ids{"d3d12.may-cover-tier-1"});
  EXPECT_EQ(ids("SquaresOutsideTheMayRegionStayFree", "d3d12-conservative-3"),
            Ids{"d3d12.may-cover-tier-2"});
  EXPECT_EQ(ids("SquaresOutsideTheMayRegionStayFree", "d3d12-inner"), Ids{"d3d12.inner-coverage"});
  EXPECT_EQ(ids("SquaresOutsideTheMayRegionStayFree", "vulkan-underestimate"),
            Ids{"vulkan.underestimate"});
  EXPECT_EQ(ids("SquaresThatMustBeAreCovered", "vulkan-overestimate"), Ids{"vulkan.overestimate"});
  EXPECT_EQ(ids("SquaresThatMustBeAreCovered", "pdf-fill"),
            (Ids{"pdf.fill", "pdf.empty-interior"}));
  EXPECT_EQ(GroundsOf("SquaresThatMustBeAreCovered", *PresetProfile("voxel")).authority,
            Authority::kStatedModel);
}

TEST(Authority, QualityFailsOnlyWhereItIsAskedTo) {
  PropertyResult result;
  result.outcome = Outcome::kViolated;
  for (const Authority authority : {Authority::kClause, Authority::kStatedModel}) {
    result.authority = authority;
    EXPECT_TRUE(IsFailure(result, FailOn::kStated));
    EXPECT_TRUE(IsFailure(result, FailOn::kQuality));
    EXPECT_FALSE(IsLackOfQuality(result, FailOn::kStated));
  }
  result.authority = Authority::kQuality;
  EXPECT_FALSE(IsFailure(result, FailOn::kStated));
  EXPECT_TRUE(IsFailure(result, FailOn::kQuality));
  EXPECT_TRUE(IsLackOfQuality(result, FailOn::kStated));
  EXPECT_FALSE(IsLackOfQuality(result, FailOn::kQuality));
  result.outcome = Outcome::kHolds;
  EXPECT_FALSE(IsFailure(result, FailOn::kQuality));
  EXPECT_FALSE(IsLackOfQuality(result, FailOn::kStated));
}

}  // namespace
}  // namespace rasterproof::props
