// One set of choices for the whole mesh: fair to every legal subject, merciless to one that is
// legal sample by sample only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "core/profile_keys.h"
#include "core/snap.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "props/domains/domain.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

SubjectInfo FreeInfo(int bits, double tolerance, bool any_owner) {
  SubjectInfo info = testing::SnappedInfo(bits);
  info.profile.freedom = {.snap_tolerance = tolerance,
                          .ties = any_owner ? TieOwnership::kAxisAligned : TieOwnership::kStated};
  return info;
}

void AddTo(CoverageCounts& counts, const CoverageCounts& more) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts.front[k] += more.front[k];
    counts.back[k] += more.back[k];
  }
}

// Draws each triangle by the profile that `of` makes of the stated one.
FakeSubject EachBy(const SubjectInfo& info,
                   const std::function<void(Profile&, const Triangle&)>& of) {
  return {info, [profile = info.profile, of](const Scene& scene, const DrawOptions& options,
                                             CoverageCounts& counts) {
            for (const Triangle& t : scene.triangles) {
              Scene one = scene;
              one.triangles = {t};
              Profile own = profile;
              of(own, t);
              AddTo(counts, exact::Coverage(one, own, options));
            }
          }};
}

// Ties of the snap go up for one of two neighbours and down for the other.
FakeSubject SnapsNeighboursApart(const SubjectInfo& info) {
  return EachBy(info, [](Profile& profile, const Triangle& t) {
    const bool odd = std::max({t[0], t[1], t[2]}) % 2 != 0;
    profile.snap.rule = odd ? SnapRule::kHalfUp : SnapRule::kNearestEven;
  });
}

Verdict OneLegalModelExplainsTheMesh(Subject& subject, const Case& c) {
  return RunCase(subject, *FindProperty("OneLegalModelExplainsTheMesh"), c);
}

struct Tried {
  int violated = 0;
  int exercised = 0;
  std::vector<Case> violations;
};

Tried Try(Subject& subject, std::string_view domain, int cases) {
  Tried tried;
  for (int k = 0; k < cases; ++k) {
    PhiloxSource bits(3, static_cast<std::uint64_t>(k));
    const Case c = FindDomain(domain)->draw(bits, subject.Info());
    const Verdict verdict = OneLegalModelExplainsTheMesh(subject, c);
    tried.exercised += verdict.outcome == Outcome::kHolds ? 1 : 0;
    if (verdict.outcome != Outcome::kViolated) continue;
    ++tried.violated;
    tried.violations.push_back(c);
  }
  return tried;
}

void ExpectLegal(FakeSubject subject, std::string_view what) {
  for (const std::string_view domain : {"shared-snap-ties", "snap-ties", "shared-edge", "fans"}) {
    const Tried tried = Try(subject, domain, 40);
    EXPECT_EQ(tried.violated, 0) << what << " on " << domain;
    EXPECT_GT(tried.exercised, 20) << what << " on " << domain;
  }
}

TEST(JointLegality, EveryRoundingWithinTheToleranceIsLegal) {
  for (const SnapRule rule : {SnapRule::kNearestEven, SnapRule::kNearestAway, SnapRule::kHalfUp}) {
    ExpectLegal(
        testing::WithProfile(FreeInfo(8, 0.6, false), [rule](Profile& p) { p.snap.rule = rule; }),
        SnapRuleName(rule));
  }
  for (const SnapRule rule : {SnapRule::kFloor, SnapRule::kTruncate, SnapRule::kNearestEven}) {
    ExpectLegal(
        testing::WithProfile(FreeInfo(4, 1.0, false), [rule](Profile& p) { p.snap.rule = rule; }),
        SnapRuleName(rule));
  }
  ExpectLegal(
      testing::WithProfile(
          FreeInfo(8, 0.6, false),
          [](Profile& p) { p.snap = {8, SnapRule::kHalfUp, SnapForm::kFloat32Difference, 0.5}; }),
      "half-up of float32(x - 1/2)");
}

TEST(JointLegality, EveryConsistentTieRuleIsLegalWhereTheRuleIsFree) {
  for (const TieRule& rule : kConsistentRules) {
    ExpectLegal(
        testing::WithProfile(FreeInfo(8, 0, true), [rule](Profile& p) { p.tie_rule = rule; }),
        TieRuleName(rule));
  }
}

TEST(JointLegality, WhatTheToleranceDoesNotAllowIsFound) {
  FakeSubject floor = testing::WithProfile(FreeInfo(4, 0.6, false),
                                           [](Profile& p) { p.snap.rule = SnapRule::kFloor; });
  EXPECT_GT(Try(floor, "snap-ties", 60).violated, 0);
  FakeSubject coarse =
      testing::WithProfile(FreeInfo(8, 0.6, false), [](Profile& p) { p.snap.bits = 4; });
  EXPECT_GT(Try(coarse, "snap-ties", 60).violated, 0);
  FakeSubject two_rules = EachBy(FreeInfo(8, 0, true), [](Profile& profile, const Triangle& t) {
    profile.tie_rule = kConsistentRules[std::max({t[0], t[1], t[2]}) % 2 == 0 ? 0 : 3];
  });
  EXPECT_GT(Try(two_rules, "fans", 60).violated, 0);
  FakeSubject mesh_differs(
      FreeInfo(8, 0.6, false),
      [](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        Profile profile = FreeInfo(8, 0.6, false).profile;
        if (scene.triangles.size() > 1) profile.tie_rule.sign_x = -1;
        AddTo(counts, exact::Coverage(scene, profile, options));
      });
  EXPECT_GT(Try(mesh_differs, "fans", 60).violated, 0);
}

// Every model that the case's freedom allows one triangle to be drawn by.
std::vector<CoverageCounts> LegalDraws(const Case& c, const Triangle& t) {
  Scene one = c.scene;
  one.triangles = {{0, 1, 2}};
  one.precision = Precision::kFloat64;
  one.vertices.resize(3);
  Profile placed = c.profile;
  placed.snap = {};
  std::vector<CoverageCounts> draws;
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  const std::function<void(std::size_t)> choose = [&](std::size_t k) {
    if (k == 3) {
      draws.push_back(exact::Coverage(one, placed));
      return;
    }
    const double tolerance = c.profile.freedom.snap_tolerance;
    for (const double x : GridPointsWithin(v[k].x, c.profile.snap, tolerance)) {
      for (const double y : GridPointsWithin(v[k].y, c.profile.snap, tolerance)) {
        one.vertices[k] = {x, y};
        choose(k + 1);
      }
    }
  };
  choose(0);
  return draws;
}

// The judge that this property replaces: each sample of each triangle by itself is as some legal
// model has it.
bool IsLegalSampleBySample(Subject& subject, const Case& c) {
  for (const Triangle& t : c.scene.triangles) {
    Scene one = c.scene;
    one.triangles = {t};
    CoverageCounts seen(one.width, one.height);
    DrawOnto(subject, one, {}, seen);
    const std::vector<CoverageCounts> legal = LegalDraws(c, t);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (std::ranges::none_of(legal, [&](const CoverageCounts& draw) {
            return draw.front[k] == seen.front[k] && draw.back[k] == seen.back[k];
          })) {
        return false;
      }
    }
  }
  return true;
}

TEST(JointLegality, NeighboursSnappedApartAreFoundThoughEachSampleIsLegal) {
  FakeSubject subject = SnapsNeighboursApart(FreeInfo(4, 0.6, false));
  const Tried tried = Try(subject, "shared-snap-ties", 300);
  ASSERT_GT(tried.violated, 3);
  int let_through = 0;
  for (const Case& c : tried.violations) {
    let_through += IsLegalSampleBySample(subject, c) ? 1 : 0;
    const Verdict verdict = OneLegalModelExplainsTheMesh(subject, c);
    ASSERT_TRUE(verdict.witness.has_value());
    EXPECT_NE(verdict.message.find("triangles 0, 1 together"), std::string::npos)
        << verdict.message;
  }
  EXPECT_EQ(let_through, tried.violated) << "each triangle alone is legal";
  RecordProperty("violated of 300", tried.violated);
}

TEST(JointLegality, AppliesToFreeProfilesOnly) {
  FakeSubject exact_model = testing::Sound(testing::SnappedInfo(8));
  PhiloxSource bits(3, 0);
  const Case c = FindDomain("fans")->draw(bits, exact_model.Info());
  EXPECT_EQ(OneLegalModelExplainsTheMesh(exact_model, c).outcome, Outcome::kNotApplicable);
}

}  // namespace
}  // namespace rasterproof::props
