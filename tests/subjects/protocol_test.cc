#include "subjects/process/protocol.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

#include "core/error.h"
#include "core/subject.h"
#include "subjects/process/serve.h"

namespace rasterproof::subjects {
namespace {

DrawRequest SomeRequest() {
  DrawRequest request;
  request.id = 7;
  request.samples = 2;
  request.scene.width = 3;
  request.scene.height = 2;
  request.scene.precision = Precision::kFloat64;
  request.scene.vertices = {{0.1, -0.0, 0x1p-1074, 1},
                            {1e300, std::numeric_limits<double>::infinity(), 0, 1},
                            {0x1.fffffffffffffp1023, 1.0 / 3, -2, 1}};
  request.scene.triangles = {{0, 1, 2}, {2, 1, 0}};
  request.options.cull = Cull::kBack;
  request.options.scissor = PixelRect{-1, 0, 2, 2};
  request.options.tile = 8;
  request.options.threads = 3;
  return request;
}

TEST(Protocol, CarriesARequestWithoutLosingABit) {
  const DrawRequest request = SomeRequest();
  std::istringstream in(RequestText(request));
  const std::optional<DrawRequest> read = ReadRequest(in);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->id, request.id);
  EXPECT_EQ(read->samples, request.samples);
  EXPECT_EQ(read->scene, request.scene);
  EXPECT_EQ(read->options, request.options);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(read->scene.vertices[0].y), std::uint64_t{1} << 63);
  EXPECT_FALSE(ReadRequest(in));
}

TEST(Protocol, CarriesWhatIsNoNumber) {
  DrawRequest request = SomeRequest();
  request.scene.vertices[1].x = std::numeric_limits<double>::quiet_NaN();
  std::istringstream in(RequestText(request));
  const std::optional<DrawRequest> read = ReadRequest(in);
  ASSERT_TRUE(read);
  EXPECT_NE(read->scene.vertices[1].x, read->scene.vertices[1].x);
}

TEST(Protocol, RefusesRequestsThatAreNone) {
  const std::string good = RequestText(SomeRequest());
  const auto refuses = [](const std::string& text) {
    std::istringstream in(text);
    EXPECT_THROW(ReadRequest(in), InputError) << text;
  };
  refuses("draw 1 2 3\n");
  refuses("paint 1 2 2 1 window 0 0\n");
  refuses("draw 1 0 2 1 window 0 0\n");
  refuses("draw 1 65537 2 1 window 0 0\n");
  refuses("draw 1 2 2 1 window 0 0 colour=red\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 3\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 x 1\n");
  refuses("draw 1 2 2 1 window 1 1\n1 2 0 1\n0 0 1\n");
  refuses(good.substr(0, good.size() / 2));
}

TEST(Protocol, ReadsAnswersAndNothingElse) {
  EXPECT_EQ(ParseAnswerHead("counts 12", 12).kind, AnswerKind::kCounts);
  EXPECT_EQ(ParseAnswerHead("refused 12 too large", 12).kind, AnswerKind::kRefused);
  EXPECT_EQ(ParseAnswerHead("refused 12 too large", 12).reason, "too large");
  EXPECT_EQ(ParseAnswerHead("fault 12", 12).kind, AnswerKind::kFault);
  for (const char* const line : {"", "counts 1", "counts 123", "count 12", "12 counts"}) {
    EXPECT_THROW(ParseAnswerHead(line, 12), SubjectFault) << line;
  }
  std::uint32_t row[3] = {};
  ParseCountsRow(" 1 4294967295\t3\r", 3, row);
  EXPECT_EQ(row[0], 1U);
  EXPECT_EQ(row[1], 4294967295U);
  EXPECT_EQ(row[2], 3U);
  for (const char* const line : {"1 2", "1 2 3 4", "1 x 3", "1 -2 3", "1 4294967296 3", "1 2 3x"}) {
    EXPECT_THROW(ParseCountsRow(line, 3, row), SubjectFault) << line;
  }
}

class Speaker final : public Subject {
 public:
  const SubjectInfo& Info() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions&, CoverageCounts& counts) override {
    if (scene.width == 1) throw InputError("place", "too\nsmall", "more");
    if (scene.width == 2) throw SubjectFault("it broke");
    counts.front[0] = 5;
    counts.back[1] = 6;
  }

 private:
  SubjectInfo info_;
};

TEST(Serve, AnswersRefusesAndConfesses) {
  Speaker speaker;
  std::istringstream in(
      "draw 1 1 1 1 window 0 0\ndraw 2 2 1 1 window 0 0\n\ndraw 3 3 2 1 window 0 0\n");
  std::string said;
  Serve(speaker, in, [&](const std::string& text) { said += text; });
  EXPECT_EQ(
      said,
      "refused 1 place: too small; more\nfault 2 it broke\ncounts 3\n5 0 0\n0 0 0\n0 6 0\n0 0 "
      "0\n");
}

}  // namespace
}  // namespace rasterproof::subjects
