#include "subjects/process/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/subject_info.h"
#include "subjects/process/serve.h"
#include "subjects/process/text.h"
#include "tests/fake_subject.h"
#include "tests/share.h"

namespace rasterproof::subjects {
namespace {

DrawRequest SomeRequest() {
  Scene scene;
  scene.width = 3;
  scene.height = 2;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{0.1, -0.0, 0x1p-1074, 1},
                    {1e300, std::numeric_limits<double>::infinity(), 0, 1},
                    {0x1.fffffffffffffp1023, 1.0 / 3, -2, 1}};
  scene.triangles = {{0, 1, 2}, {2, 1, 0}};
  DrawRequest request{7, {scene, {}, 2}};
  request.job.options.cull = Cull::kBack;
  request.job.options.scissor = PixelRect{-1, 0, 2, 2};
  request.job.options.tile = 8;
  request.job.options.threads = 3;
  return request;
}

// A subject that takes all options and, if it takes words, `same` and `wants`.
SubjectInfo Info(CoverageKind kind = CoverageKind::kFacingCounts, bool words = false) {
  SubjectInfo info;
  info.coverage = kind;
  info.takes_same = info.takes_wants = words;
  info.takes_threads = true;
  return info;
}

std::string TextOf(const DrawRequest& request) {
  return RequestsText(request.id, {&request.job, 1}, Info());
}

std::vector<DrawRequest> ReadCall(const std::string& text) {
  std::istringstream in(text);
  return RequestReader(in).NextCall();
}

TEST(Protocol, CarriesARequestWithoutLosingABit) {
  const DrawRequest request = SomeRequest();
  std::istringstream in(TextOf(request));
  RequestReader reader(in);
  const std::vector<DrawRequest> read = reader.NextCall();
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].id, request.id);
  EXPECT_EQ(read[0].job.samples, request.job.samples);
  EXPECT_EQ(SceneOf(read[0].job), SceneOf(request.job));
  EXPECT_EQ(read[0].job.options, request.job.options);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(read[0].job.scene->vertices[0].y), std::uint64_t{1} << 63);
  EXPECT_TRUE(reader.NextCall().empty());
}

TEST(Protocol, CarriesWhatIsNoNumber) {
  DrawRequest request = SomeRequest();
  Scene scene = *request.job.scene;
  scene.vertices[1].x = std::numeric_limits<double>::quiet_NaN();
  request.job.scene = std::make_shared<const Scene>(scene);
  const std::vector<DrawRequest> read = ReadCall(TextOf(request));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_NE(read[0].job.scene->vertices[1].x, read[0].job.scene->vertices[1].x);
}

TEST(Protocol, RefusesRequestsThatAreNone) {
  const std::string good = TextOf(SomeRequest());
  const auto refuses = [](const std::string& text) {
    EXPECT_THROW(ReadCall(text), InputError) << text;
  };
  refuses("draw 1 2 3\n");
  refuses("paint 1 2 2 1 window 0 0\n");
  refuses("draw 1 0 2 1 window 0 0\n");
  refuses("draw 1 65537 2 1 window 0 0\n");
  refuses("draw 1 2 2 1 window 0 0 colour=red\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 3\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 x 1\n");
  refuses("draw 1 2 2 1 window 1 1\n1 2 0 1\n0 0 1\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 0 1 1\n");
  refuses("draw 1 2 2 1 window same 0\n");
  refuses("draw 1 2 2 1 window 0 0 scissor=1,2,3\n");
  refuses("draw 1 2 2 1 window 0 0 scissor=1,2,3,4,5\n");
  refuses("draw 1 2 2 1 window 0 0 wants=\n");
  refuses("draw 1 2 2 1 window 0 0 wants=primitive-ids,colours\n");
  refuses(good.substr(0, good.size() / 2));
}

TEST(Protocol, NamesThePlaceOfANumberThatIsNone) {
  const auto said = [](const std::string& text) -> std::string {
    try {
      ReadCall(text);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const std::string number = said("draw 5 2 2 1 window 2 0\n1 2 0 1\n1 0x1p3 0 1\n");
  EXPECT_NE(number.find("request 5, vertex 1"), std::string::npos) << number;
  EXPECT_NE(number.find("0x1p3"), std::string::npos) << number;
  const std::string missing = said("draw 5 2 2 1 window 1 1\n1 2 0 1\n0 0\n");
  EXPECT_NE(missing.find("request 5, triangle 0"), std::string::npos) << missing;
  EXPECT_NE(missing.find("3 numbers"), std::string::npos) << missing;
}

// Draws of one scene: its second triangle, all, all of it on a larger target, all of another scene.
std::vector<DrawJob> SomeJobs() {
  const DrawJob whole = SomeRequest().job;
  DrawJob second = whole;
  second.triangles = {whole.scene->triangles[1]};
  Scene larger = *whole.scene;
  ++larger.width;
  Scene other = *whole.scene;
  other.vertices[0].y = 0;  // it was -0
  return {second, whole, {larger, {}, 1}, {other, {}, 1}, {other, {}, 1}};
}

std::size_t LinesOf(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

TEST(Protocol, SendsVerticesOnceToWhoTakesTheSame) {
  const std::vector<DrawJob> jobs = SomeJobs();
  const std::string every = RequestsText(1, jobs, Info());
  const std::string once = RequestsText(1, jobs, Info(CoverageKind::kFacingCounts, true));
  EXPECT_EQ(LinesOf(every), LinesOf(once) + 3 * jobs[0].scene->vertices.size())
      << "of the other scene a bit differs, and its vertices come again";
  for (const std::string& text : {every, once}) {
    const std::vector<DrawRequest> read = ReadCall(BatchText(jobs.size()) + text);
    ASSERT_EQ(read.size(), jobs.size());
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      EXPECT_EQ(SceneOf(read[k].job), SceneOf(jobs[k])) << k;
      EXPECT_EQ(std::signbit(read[k].job.scene->vertices[0].y), k < 3) << k;
      EXPECT_EQ(read[k].job.options, jobs[k].options) << k;
    }
  }
}

TEST(Protocol, SharesWhatIsTheSameBehindThePipeToo) {
  const std::vector<DrawRequest> read =
      ReadCall(BatchText(5) + RequestsText(1, SomeJobs(), Info(CoverageKind::kFacingCounts, true)));
  ASSERT_EQ(read.size(), 5U);
  EXPECT_EQ(read[0].job.scene, read[1].job.scene);
  EXPECT_NE(read[1].job.scene, read[2].job.scene) << "another target";
  EXPECT_EQ(read[3].job.scene, read[4].job.scene);
}

TEST(Protocol, AsksForWhatIsWantedOfWhatIsShownAlone) {
  const auto asked = [](CoverageKind kind, bool words, Outputs wants) {
    DrawJob job;
    job.wants = wants;
    const std::string text = RequestsText(1, {&job, 1}, Info(kind, words));
    return text.substr(std::string("draw 1 1 1 1 window 0 0").size());
  };
  const Outputs depths{.primitive_ids = false, .barycentrics = false, .depths = true};
  EXPECT_EQ(asked(CoverageKind::kFragments, true, kEverything), "\n");
  EXPECT_EQ(asked(CoverageKind::kFragments, true, depths), " wants=primitive-ids,depths\n");
  EXPECT_EQ(asked(CoverageKind::kFragments, true, kCoverageAndPrimitiveIds),
            " wants=primitive-ids\n");
  EXPECT_EQ(asked(CoverageKind::kFragments, true, kCoverageAlone), " wants=coverage\n");
  EXPECT_EQ(asked(CoverageKind::kPrimitiveIds, true, kCoverageAlone), " wants=coverage\n");
  EXPECT_EQ(asked(CoverageKind::kPrimitiveIds, true, kCoverageAndPrimitiveIds), "\n");
  EXPECT_EQ(asked(CoverageKind::kPrimitiveIds, true, depths), "\n")
      << "it shows none, but whose they are";
  EXPECT_EQ(asked(CoverageKind::kMask, true, kCoverageAlone), "\n");
  EXPECT_EQ(asked(CoverageKind::kFragments, false, kCoverageAlone), "\n");
  for (const Outputs wants : {kEverything, kCoverageAndPrimitiveIds, kCoverageAlone}) {
    DrawJob job;
    job.wants = wants;
    const std::string text = RequestsText(1, {&job, 1}, Info(CoverageKind::kFragments, true));
    EXPECT_EQ(ReadCall(text).at(0).job.wants, wants) << text;
  }
}

// The answer to request 12, a scene of 2 triangles on a target of one row.
Drawing Read(const std::string& answer, CoverageKind kind, int width, bool words = false,
             Outputs wants = kEverything) {
  Scene scene;
  scene.width = width;
  scene.triangles.resize(2);
  DrawJob job(scene, {}, 1);
  job.wants = wants;
  std::istringstream lines(answer);
  std::string line;
  std::string bytes;
  const auto next_bytes = [&](std::size_t count) {
    bytes.resize(count);
    lines.read(bytes.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(lines.gcount()) < count) BreakDown("it ends within an array");
    return std::string_view(bytes);
  };
  return ReadAnswer(
      12, job, Info(kind, words),
      [&](std::size_t) {
        if (!std::getline(lines, line)) line.clear();
        return std::string_view(line);
      },
      next_bytes);
}

TEST(Protocol, ReadsCountsAndNothingElse) {
  const Drawing drawing = Read("counts 12\n 1 4294967295\t3\r\n", CoverageKind::kCounts, 3);
  EXPECT_EQ(drawing.counts.front, (std::vector<std::uint32_t>{1, 4294967295U, 3}));
  EXPECT_EQ(drawing.counts.back, (std::vector<std::uint32_t>{0, 0, 0}));
  for (const char* const head :
       {"", "counts 1", "counts 123", "count 12", "12 counts", "primitive-ids 12"}) {
    EXPECT_THROW(Read(std::string(head) + "\n1 2 3\n", CoverageKind::kCounts, 3), SubjectStop)
        << head;
  }
  for (const char* const row :
       {"1 2", "1 2 3 4", "1 x 3", "1 -2 3", "1 4294967296 3", "1 2 3x", "1 2.5 3"}) {
    EXPECT_THROW(Read("counts 12\n" + std::string(row) + "\n", CoverageKind::kCounts, 3),
                 SubjectStop)
        << row;
  }
}

TEST(Protocol, TellsRefusalsFromFaults) {
  const auto end = [](const char* answer) {
    return EndOf([&] { Read(answer, CoverageKind::kCounts, 1); }).stop;
  };
  EXPECT_EQ(end("refused 12 too large\n"), Stop::kRefused);
  EXPECT_EQ(end("fault 12\n"), Stop::kBrokeDown);
}

TEST(Protocol, ReadsPrimitiveIdsOfTheSceneAndNoOthers) {
  const Drawing drawing = Read("primitive-ids 12\n0 -1 1\n", CoverageKind::kPrimitiveIds, 3);
  EXPECT_EQ(drawing.primitive_ids, (std::vector<std::int32_t>{0, kNoPrimitive, 1}));
  EXPECT_EQ(drawing.counts.front, (std::vector<std::uint32_t>{1, 0, 1}));
  for (const char* const row : {"0 2 1", "0 -2 1", "0 1", "0 1 1 1", "0 x 1"}) {
    EXPECT_THROW(
        Read("primitive-ids 12\n" + std::string(row) + "\n", CoverageKind::kPrimitiveIds, 3),
        SubjectStop)
        << row;
  }
}

TEST(Protocol, CarriesFragmentsWithoutLosingABit) {
  Drawing drawing;
  drawing.counts = CoverageCounts(3, 1);
  drawing.counts.front = {1, 0, 1};
  drawing.primitive_ids = {1, kNoPrimitive, 0};
  drawing.barycentrics = {{0.1, 1.0 / 3, -0x1p-1074}, {}, {1, 0, 0}};
  drawing.depths = {0x1.fffffffffffffp1023, 0, -2};
  const Drawing read = Read(AnswerText(12, drawing, CoverageKind::kFragments, kEverything),
                            CoverageKind::kFragments, 3);
  EXPECT_EQ(read.counts, drawing.counts);
  EXPECT_EQ(read.primitive_ids, drawing.primitive_ids);
  EXPECT_EQ(read.barycentrics, drawing.barycentrics);
  EXPECT_EQ(read.depths, drawing.depths);
  for (const char* const row : {"0 1 1 1 1 -1", "-1 -1 0 1 1 1", "-1 1 1 1 1 1 1 1 1 1"}) {
    EXPECT_THROW(Read("fragments 12\n" + std::string(row) + "\n", CoverageKind::kFragments, 3),
                 SubjectStop)
        << row;
  }
}

TEST(Protocol, CarriesWhatIsWantedAndNoMore) {
  Drawing drawing;
  drawing.counts = CoverageCounts(2, 1);
  drawing.counts.front = {1, 0};
  drawing.primitive_ids = {1, kNoPrimitive};
  drawing.barycentrics = {{0.25, 0.5, 0.25}, {}};
  drawing.depths = {0.125, 0};
  const CoverageKind kind = CoverageKind::kFragments;
  const Outputs barycentrics{.primitive_ids = false, .barycentrics = true, .depths = false};
  const Outputs depths{.primitive_ids = false, .barycentrics = false, .depths = true};
  EXPECT_EQ(AnswerText(12, drawing, kind, kCoverageAlone), "counts 12\n1 0\n");
  EXPECT_EQ(AnswerText(12, drawing, kind, kCoverageAndPrimitiveIds), "primitive-ids 12\n1 -1\n");
  EXPECT_EQ(AnswerText(12, drawing, kind, barycentrics), "fragments 12\n1 0.25 0.5 0.25 -1\n");
  EXPECT_EQ(AnswerText(12, drawing, kind, depths), "fragments 12\n1 0.125 -1\n");
  for (const Outputs wants :
       {kCoverageAlone, kCoverageAndPrimitiveIds, barycentrics, depths, kEverything}) {
    const Drawing read = Read(AnswerText(12, drawing, kind, wants), kind, 2, true, wants);
    EXPECT_EQ(read.counts, drawing.counts);
    EXPECT_EQ(read.primitive_ids.empty(), wants == kCoverageAlone);
    EXPECT_EQ(read.barycentrics,
              wants.barycentrics ? drawing.barycentrics : decltype(read.barycentrics)());
    EXPECT_EQ(read.depths, wants.depths ? drawing.depths : decltype(read.depths)());
    const Drawing older = Read(AnswerText(12, drawing, kind, kEverything), kind, 2, false, wants);
    EXPECT_EQ(older.primitive_ids, drawing.primitive_ids)
        << "who takes no wants answers with everything";
    EXPECT_EQ(older.barycentrics, read.barycentrics) << "and what is not wanted is not kept";
  }
  EXPECT_THROW(Read("fragments 12\n1 0 0 1 0.5 -1\n", kind, 2, true, kCoverageAndPrimitiveIds),
               SubjectStop);
}

TEST(Protocol, ReadsNumbersAsStrtodDoesAndWritesThemBack) {
  std::mt19937_64 bits(1);
  constexpr int kNumbers = Cases(20000);
  for (int n = 0; n < kNumbers; ++n) {
    const auto x = std::bit_cast<double>(bits());
    TextWriter text;
    text.AddNumber(x);
    const std::string word = text.Take();
    double read = 0;
    ASSERT_TRUE(WordReader(word).Number(read)) << word;
    EXPECT_EQ(std::isnan(read), std::isnan(x)) << word;
    if (std::isnan(x)) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(x)) << word;
    const double other = std::strtod(word.c_str(), nullptr);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(other), std::bit_cast<std::uint64_t>(x)) << word;
    EXPECT_LE(word.size(), kMostOfANumber);
  }
}

// Words of a few letters that numbers are made of: most are none.
TEST(Protocol, TakesForANumberWhatStrtodTakesWholeAndNothingElse) {
  std::mt19937_64 bits(2);
  constexpr std::string_view kLetters = "0123456789..--+eExinfa";
  constexpr int kWords = Cases(50000);
  int numbers = 0;
  for (int n = 0; n < kWords; ++n) {
    std::string word;
    for (std::uint64_t length = 1 + bits() % 6; length > 0; --length) {
      word += kLetters[bits() % kLetters.size()];
    }
    char* stop = nullptr;
    const double expected = std::strtod(word.c_str(), &stop);
    // from_chars knows no leading +, no 0x, and calls what no double holds no number.
    const bool is_number = *stop == '\0' && word[0] != '+' && word.find('x') == std::string::npos &&
                           (!std::isinf(expected) || word.find('i') != std::string::npos);
    double read = 0;
    const bool taken = WordReader(word).Number(read);
    if (is_number && expected == 0 && !taken) continue;  // it underflows, or is 0
    EXPECT_EQ(taken, is_number) << word;
    if (!taken || std::isnan(expected)) continue;
    ++numbers;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(expected)) << word;
  }
  EXPECT_GT(numbers, kWords / 100);
}

TEST(Protocol, CarriesIntegersUpToTheLastOfTheirType) {
  for (const std::int32_t x : {0, 9, 10, -1, -10, 2147483647, -2147483647 - 1}) {
    TextWriter text;
    text.AddNumber(x);
    text.Add(' ');
    text.AddNumber(std::uint32_t{4294967295U});
    const std::string line = text.Take();
    WordReader words(line);
    std::int32_t read = 0;
    std::uint32_t last = 0;
    EXPECT_TRUE(words.Number(read) && words.Number(last) && words.AtEnd()) << line;
    EXPECT_EQ(read, x);
    EXPECT_EQ(last, 4294967295U);
  }
  std::int32_t too_large = 0;
  EXPECT_FALSE(WordReader("2147483648").Number(too_large));
}

TEST(Protocol, AsksForManyEdgeValuesAtOnce) {
  const std::vector<EdgeRequest> requests{
      {3, {0.1, 2}, {3, 4}, {5, 6}, std::nullopt, 0},
      {4, {1, 2}, {3, 4}, {5, -0.0}, Step{true, -1, 16}, 7},
  };
  const std::string text = RequestsText(requests);
  EXPECT_EQ(text, "edge 3 0.1 2 3 4 5 6\nsteps 4 1 2 3 4 5 -0 y -1 16 7\n");
  std::istringstream in(text + "\n");
  RequestReader reader(in);
  EXPECT_EQ(reader.NextEdgeRequest()->id, 3U);
  EXPECT_TRUE(reader.HasMore());
  const EdgeRequest stepping = *reader.NextEdgeRequest();
  EXPECT_EQ(stepping.steps, 7);
  EXPECT_TRUE(stepping.step->along_y && stepping.step->sign == -1 && stepping.step->length == 16);
  EXPECT_FALSE(reader.HasMore()) << "a blank line is no request";
  for (const char* const bad : {"edge 1 2 3 4 5 6\n", "edge 1 2 3 4 5 6 7 8\n",
                                "steps 1 2 3 4 5 6 7 z +1 1 1\n", "steps 1 2 3 4 5 6 7 x 1 1 1\n",
                                "steps 1 2 3 4 5 6 7 x +1 0 1\n", "edge 1 2 3 4 5 6 a\n"}) {
    std::istringstream stream(bad);
    EXPECT_THROW(RequestReader(stream).NextEdgeRequest(), InputError) << bad;
  }
}

TEST(Protocol, TakesABlankLineForNoRequest) {
  std::istringstream in("edge 1 0 0 1 0 0 1\n \t\r\n\r\nedge 2 0 0 1 0 0 2\n \r\n");
  RequestReader reader(in);
  EXPECT_TRUE(reader.NextEdgeRequest());
  EXPECT_TRUE(reader.HasMore());
  EXPECT_TRUE(reader.NextEdgeRequest());
  EXPECT_FALSE(reader.HasMore());
}

TEST(Protocol, TakesABatchAsOneCall) {
  const DrawRequest request = SomeRequest();
  const std::vector<DrawJob> jobs(3, request.job);
  std::istringstream in(BatchText(2) + RequestsText(7, jobs, Info()));
  RequestReader reader(in);
  const std::vector<DrawRequest> batch = reader.NextCall();
  ASSERT_EQ(batch.size(), 2U);
  EXPECT_EQ(batch[1].id, 8U);
  EXPECT_EQ(SceneOf(batch[1].job), SceneOf(request.job));
  EXPECT_EQ(reader.NextCall().size(), 1U);
  for (const std::string text :
       {"batch\n", "batch 0\n", "batch 70000\n", "batch x\n", "batch 1\n", "batch 1\nbatch 1\n"}) {
    EXPECT_THROW(ReadCall(text), InputError) << text;
  }
}

TEST(Protocol, AsksForRepeatsWhereTheyAreTaken) {
  DrawRequest request = SomeRequest();
  request.job.repeats = 40;
  EXPECT_EQ(TextOf(request).find("repeats"), std::string::npos);
  SubjectInfo info = Info();
  info.takes_repeats = true;
  const std::string text = RequestsText(request.id, {&request.job, 1}, info);
  EXPECT_EQ(ReadCall(text).front().job.repeats, 40);
  for (const std::string number : {"0", "-1", "1048577", "x", ""}) {
    EXPECT_THROW(ReadCall("draw 1 3 2 1 window 0 0 repeats=" + number + "\n"), InputError)
        << number;
  }
}

FakeSubject Speaker() {
  return {SubjectInfo{}, [](const Scene& scene, const DrawOptions&, CoverageCounts& counts) {
            if (scene.width == 1) throw InputError("place", "too\nsmall", "more");
            if (scene.width == 2) BreakDown("it broke");
            counts.front[0] = 5;
            counts.back[1] = 6;
          }};
}

TEST(Serve, DrawsRepeatsAndAnswersOnce) {
  FakeSubject speaker = Speaker();
  int drawn = 0;
  speaker.on_answer = [&](const std::vector<DrawOutcome>& outcomes) {
    for (const DrawOutcome& outcome : outcomes) drawn += outcome.end.stop == Stop::kNone ? 1 : 0;
  };
  std::istringstream in("draw 1 3 1 1 window 0 0 repeats=5\ndraw 2 1 1 1 window 0 0 repeats=5\n");
  std::string said;
  Serve(speaker, in, [&](const std::string& text) { said += text; });
  EXPECT_EQ(said, "counts 1\n5 0 0\n0 6 0\nrefused 2 place: too small; more\n");
  EXPECT_EQ(drawn, 5);
}

TEST(Serve, AnswersRefusesAndConfesses) {
  FakeSubject speaker = Speaker();
  std::istringstream in(
      "draw 1 1 1 1 window 0 0\ndraw 2 2 1 1 window 0 0\n\ndraw 3 3 2 1 window 0 0\n");
  std::string said;
  Serve(speaker, in, [&](const std::string& text) { said += text; });
  EXPECT_EQ(
      said,
      "refused 1 place: too small; more\nfault 2 it broke\ncounts 3\n5 0 0\n0 0 0\n0 6 0\n0 0 "
      "0\n");
}

TEST(Serve, ConfessesWhatIsLeftOutOrLacksAPart) {
  const auto said_of = [](CoverageKind kind) {
    FakeSubject subject({}, [](const Scene&, const DrawOptions&, CoverageCounts&) {});
    subject.info.coverage = kind;
    subject.on_answer = [](std::vector<DrawOutcome>& outcomes) { outcomes.pop_back(); };
    std::istringstream in("batch 2\ndraw 1 1 1 1 window 0 0\ndraw 2 1 1 1 window 0 0\n");
    std::string said;
    Serve(subject, in, [&](const std::string& text) { said += text; });
    return said;
  };
  EXPECT_EQ(said_of(CoverageKind::kFacingCounts), "counts 1\n0\n0\nfault 2 it left out a scene\n");
  EXPECT_EQ(said_of(CoverageKind::kFragments).substr(0, 7), "fault 1") << "it shows none";
}

TEST(Serve, AnswersABatchUpToTheFirstFault) {
  FakeSubject speaker = Speaker();
  std::istringstream in(
      "batch 4\ndraw 1 1 1 1 window 0 0\ndraw 2 3 1 1 window 0 0\ndraw 3 2 1 1 window 0 0\n"
      "draw 4 3 1 1 window 0 0\n");
  std::string said;
  Serve(speaker, in, [&](const std::string& text) { said += text; });
  EXPECT_EQ(said, "refused 1 place: too small; more\ncounts 2\n5 0 0\n0 6 0\nfault 3 it broke\n");
}

}  // namespace
}  // namespace rasterproof::subjects
