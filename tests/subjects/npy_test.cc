// Arrays on the pipe: what is written is what is read, bit for bit, and anything else is refused.
#include "subjects/process/npy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/subject_info.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

using namespace std::string_literals;
using Shape = std::vector<std::size_t>;

// An array as NumPy 1.24 writes it: numpy.save of numpy.array(..., dtype=TYPE).
std::string Saved(const std::string& type, const std::string& shape, const std::string& numbers,
                  const std::string& order = "False") {
  std::string head =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  head.append(118 - 1 - head.size(), ' ');
  return "\x93NUMPY\x01\x00v\x00"s + head + "\n" + numbers;
}

// The bytes of a text, one after the other.
class TextBytes {
 public:
  explicit TextBytes(std::string text) : text_(std::move(text)) {}
  std::string_view operator()(std::size_t count) {
    if (count > text_.size() - at_) BreakDown("it ends within an array");
    at_ += count;
    return std::string_view(text_).substr(at_ - count, count);
  }

 private:
  std::string text_;
  std::size_t at_ = 0;
};

std::vector<std::int64_t> Integers(const std::string& text, const std::vector<Shape>& shapes) {
  return ReadNpyIntegers(shapes, TextBytes(text));
}

std::string WhyNone(const std::string& text, const std::vector<Shape>& shapes) {
  try {
    Integers(text, shapes);
    return "";
  } catch (const SubjectStop& stop) {
    return stop.what();
  }
}

TEST(Npy, ReadsIntegersOfEverySizeAsNumPySavesThem) {
  using V = std::vector<std::int64_t>;
  EXPECT_EQ(Integers(Saved("|u1", "(1, 2)", "\x01\xff"), {{1, 2}}), (V{1, 255}));
  EXPECT_EQ(Integers(Saved("|b1", "(1, 2)", "\x01\x00"s), {{1, 2}}), (V{1, 0}));
  EXPECT_EQ(Integers(Saved("|i1", "(2,)", "\x01\xff"), {{2}}), (V{1, -1}));
  EXPECT_EQ(Integers(Saved("<u2", "(2, 1)", "\x01\x02\xff\xff"), {{2, 1}}), (V{513, 65535}));
  EXPECT_EQ(Integers(Saved("<i4", "(1, 1)", "\xff\xff\xff\xff"), {{1, 1}}), (V{-1}));
  EXPECT_EQ(Integers(Saved("<u4", "(1, 1)", "\xff\xff\xff\xff"), {{1, 1}}), (V{4294967295}));
  EXPECT_EQ(Integers(Saved("<i8", "(1, 1)", "\x01\0\0\0\x01\0\0\0"s), {{1, 1}}), (V{4294967297}));
}

TEST(Npy, RefusesWhatIsNoSuchArrayAndSaysWhatItIs) {
  const auto says = [](const std::string& text, const std::string& part) {
    const std::string why = WhyNone(text, {{1, 2}, {1, 2, 1}});
    EXPECT_NE(why.find(part), std::string::npos) << why;
  };
  EXPECT_EQ(WhyNone(Saved("|u1", "(1, 2, 1)", "\x01\x02"), {{1, 2}, {1, 2, 1}}), "");
  says(Saved("|u1", "(2, 1)", "\x01\x02"), "has shape (2, 1), not (1, 2)");
  says(Saved("|u1", "(2, 1)", "\x01\x02", "True"), "column-major");
  says(Saved("<f8", "(1, 2)", std::string(16, '\0')), "numbers of type \"<f8\"");
  says(Saved(">i4", "(1, 2)", std::string(8, '\0')), "little-endian");
  says(Saved("|u1", "(1, 2)", "\x01"), "ends within an array");
  says("counts as text, of more than a few bytes", "it begins with \"counts a\"");
  says("\x93NUMPY\x07\x00v\x00"s + std::string(200, ' '), "of version 7");
  says("\x93NUMPY\x01\x00\xff\xff"s + std::string(200, ' '), "its head has 65535 bytes");
  says("\x93NUMPY\x01\x00\x02\x00{}"s, "has no 'descr'");
  says(Saved("|u1", "(1, two)", "\x01\x02"), "has no shape");
}

TEST(Npy, HasItsFirstNumberAtAMultipleOf64Bytes) {
  const std::vector<double> numbers{0.5, -0.0, std::numeric_limits<double>::infinity(), 0x1p-1074};
  const std::string text = NpyOf(numbers, 4);
  EXPECT_EQ(text.size() % 64, 32U) << "four doubles after the head";
  const std::vector<double> read = ReadNpyDoubles(1, 4, TextBytes(text));
  EXPECT_EQ(std::memcmp(read.data(), numbers.data(), 32), 0);
  EXPECT_TRUE(ReadNpyDoubles(0, 4, TextBytes(NpyOf(std::span<const double>(), 4))).empty());
  EXPECT_THROW(ReadNpyDoubles(2, 2, TextBytes(text)), SubjectStop);
}

DrawJob SomeJob() {
  Scene scene;
  scene.width = 2;
  scene.height = 1;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{0.1, -0.0, 0, 1}, {1e300, std::nan(""), 0, 1}, {0x1p-1074, 1.0 / 3, -2, 1}};
  scene.triangles = {{0, 1, 2}, {2, 1, 0}};
  return {scene, {}, 1};
}

SubjectInfo TakingNpy(CoverageKind kind) {
  SubjectInfo info;
  info.coverage = kind;
  info.takes_same = info.takes_wants = info.takes_npy = true;
  return info;
}

TEST(Npy, RequestsCarryListsAsArraysWithoutLosingABit) {
  const DrawJob job = SomeJob();
  DrawJob second = job;
  second.triangles = {job.scene->triangles[1]};
  const std::vector<DrawJob> jobs{job, second};
  const std::string text = RequestsText(1, jobs, TakingNpy(CoverageKind::kFacingCounts));
  EXPECT_EQ(text.substr(0, text.find('\n')), "draw 1 2 1 1 window 3 2 npy");
  EXPECT_NE(text.find("draw 2 2 1 1 window same 1 npy\n"), std::string::npos);
  std::istringstream in("batch 2\n" + text);
  RequestReader reader(in);
  const std::vector<DrawRequest> read = reader.NextCall();
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].job.Triangles().size(), 2U);
  EXPECT_EQ(read[1].job.Triangles()[0], job.scene->triangles[1]);
  EXPECT_EQ(read[0].job.scene, read[1].job.scene);
  EXPECT_EQ(std::memcmp(read[0].job.scene->vertices.data(), job.scene->vertices.data(),
                        3 * sizeof(Vertex)),
            0);
  EXPECT_TRUE(reader.NextCall().empty());
}

TEST(Npy, RequestsWhoseArraysAreNoneAreRefused) {
  const DrawJob job = SomeJob();
  const std::string good = RequestsText(1, {&job, 1}, TakingNpy(CoverageKind::kCounts));
  const auto why = [](const std::string& text) -> std::string {
    std::istringstream in(text);
    try {
      RequestReader(in).NextCall();
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(why(good), "");
  EXPECT_NE(why(good.substr(0, good.size() - 1)).find("ends within an array"), std::string::npos);
  std::string wrong = good;
  wrong.back() = '\x7f';  // the last index
  EXPECT_NE(why(wrong).find("triangle 1"), std::string::npos) << why(wrong);
  std::string fewer = good;
  fewer.replace(fewer.find("window 3 2"), 10, "window 4 2");
  EXPECT_NE(why(fewer).find("request 1, its vertices"), std::string::npos) << why(fewer);
}

Drawing Answered(const std::string& answer, CoverageKind kind) {
  const std::size_t end = answer.find('\n');
  TextBytes bytes(answer.substr(end + 1));
  const std::string head = answer.substr(0, end);
  return ReadAnswer(
      12, SomeJob(), TakingNpy(kind), [&](std::size_t) { return std::string_view(head); },
      [&](std::size_t n) { return bytes(n); });
}

TEST(Npy, AnswersMayBeArrays) {
  using U = std::vector<std::uint32_t>;
  const std::string counts = "counts 12 npy\n";
  EXPECT_EQ(
      Answered(counts + Saved("|u1", "(1, 2)", "\x01\x02"), CoverageKind::kCounts).counts.front,
      (U{1, 2}));
  const Drawing facings =
      Answered(counts + Saved("|u1", "(2, 1, 2)", "\x01\x02\x03\x04"), CoverageKind::kFacingCounts);
  EXPECT_EQ(facings.counts.front, (U{1, 2}));
  EXPECT_EQ(facings.counts.back, (U{3, 4}));
  const Drawing ids = Answered("primitive-ids 12 npy\n" + Saved("|i1", "(1, 2)", "\x01\xff"),
                               CoverageKind::kPrimitiveIds);
  EXPECT_EQ(ids.primitive_ids, (std::vector<std::int32_t>{1, -1}));
  EXPECT_EQ(ids.counts.front, (U{1, 0}));
  for (const auto& [numbers, kind, word] :
       {std::tuple("\x01\xff"s, CoverageKind::kCounts, "counts"),
        std::tuple("\x02\xff"s, CoverageKind::kPrimitiveIds, "primitive-ids"),
        std::tuple("\x01\xfe"s, CoverageKind::kPrimitiveIds, "primitive-ids")}) {
    EXPECT_THROW(Answered(word + " 12 npy\n"s + Saved("|i1", "(1, 2)", numbers), kind), SubjectStop)
        << word;
  }
  EXPECT_THROW(
      Answered("fragments 12 npy\n" + Saved("|i1", "(1, 2)", "\x01\xff"), CoverageKind::kFragments),
      SubjectStop);
}

}  // namespace
}  // namespace rasterproof::subjects
