// A library in this very process, and what it may do to it.
#include "subjects/plugin/plugin.h"

#include <gtest/gtest.h>

#include <cfenv>

#include "core/drawing.h"
#include "core/error.h"

namespace rasterproof::subjects {
namespace {

// Counts 1 where it finds its own rounding mode, which it sets in its first call.
constexpr const char* kRounds = FAULTY_PLUGINS "/faulty_ROUNDS.so";

TEST(Plugin, KeepsItsRoundingModeToItself) {
  ASSERT_EQ(std::fegetround(), FE_TONEAREST);
  const LoadedPlugin loaded = LoadPlugin(kRounds);
  EXPECT_EQ(loaded.subject->Show({}).counts.front[0], 0U);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "who judges is not to round as it does";
  EXPECT_EQ(loaded.subject->Show({}).counts.front[0], 1U) << "it is drawn with as it is";
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(Plugin, IsNotGivenTargetsThatNobodyTakes) {
  const LoadedPlugin loaded = LoadPlugin(kRounds);
  DrawJob large;
  large.scene.width = 16384;
  large.scene.height = 16384;
  large.samples = 4;
  EXPECT_THROW(loaded.subject->Show(large), InputError);
}

}  // namespace
}  // namespace rasterproof::subjects
