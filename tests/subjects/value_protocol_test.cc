// Channels and values on the pipe: asked for where they are shown and wanted, there and back.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/channel.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "subjects/process/protocol.h"
#include "subjects/process/serve.h"
#include "tests/fake_subject.h"

namespace rasterproof::subjects {
namespace {

Outputs ValuesToo(Outputs wants, bool derivatives) {
  wants.values = true;
  wants.derivatives = derivatives;
  return wants;
}

SubjectInfo Shows(int protocol) {
  SubjectInfo info;
  info.coverage = CoverageKind::kFragments;
  info.takes_same = info.takes_wants = protocol >= 2;
  info.takes_npy = protocol >= 3;
  info.fragments.shows_values = info.fragments.shows_derivatives = true;
  return info;
}

Scene TwoPixels() {
  Scene scene;
  scene.width = 2;
  scene.height = 1;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{0, 0}, {1, 0}, {0, 1}};
  scene.triangles = {{0, 1, 2}};
  scene.channels = {{"u", Interpolation::kPerspective, EvaluatedAt::kSample, {0.1, -0.0, 1e300}},
                    {"q", Interpolation::kInverseW, EvaluatedAt::kCentroid, {}},
                    {"id", Interpolation::kFlat, EvaluatedAt::kCentre, {1, INFINITY, 3}}};
  return scene;
}

DrawJob Wanting(Outputs wants, const Scene& scene = TwoPixels()) {
  DrawJob job(scene, {}, 1);
  job.wants = wants;
  return job;
}

std::string Text(const std::vector<DrawJob>& jobs, const SubjectInfo& info) {
  return RequestsText(1, jobs, info);
}

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

std::size_t Times(std::string_view text, std::string_view part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++times;
  return times;
}

std::vector<DrawJob> Read(const std::string& text) {
  std::istringstream in(text);
  RequestReader reader(in);
  std::vector<DrawJob> jobs;
  for (std::vector<DrawRequest> call = reader.NextCall(); !call.empty(); call = reader.NextCall())
    jobs.push_back(call.front().job);
  return jobs;
}

TEST(ValueProtocol, RequestsReadBack) {
  const Outputs wants = ValuesToo(kCoverageAndPrimitiveIds, true);
  const std::string lines = Text({Wanting(wants)}, Shows(2));
  EXPECT_EQ(lines,
            "draw 1 2 1 1 window 3 1 wants=primitive-ids,values,derivatives channels=3\n"
            "0 0 0 1\n1 0 0 1\n0 1 0 1\n"
            "u perspective sample 0.1 -0 1e+300\nq inverse-w centroid\nid flat centre 1 inf 3\n"
            "0 1 2\n");
  for (const std::string& text : {lines, Text({Wanting(wants)}, Shows(3))}) {
    const std::vector<DrawJob> read = Read(text);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(SceneOf(read[0]), TwoPixels());
    EXPECT_TRUE(std::signbit(read[0].scene->channels[0].values[1]));
    EXPECT_EQ(read[0].wants, wants);
  }
  Scene empty = TwoPixels();
  empty.vertices.clear();
  empty.triangles.clear();
  for (Channel& channel : empty.channels) channel.values.clear();
  for (const int protocol : {2, 3})
    EXPECT_EQ(SceneOf(Read(Text({Wanting(wants, empty)}, Shows(protocol)))[0]), empty);
}

TEST(ValueProtocol, AsksWhereTheyAreShownAndWanted) {
  const DrawJob job = Wanting(ValuesToo(kEverything, true));
  EXPECT_TRUE(Contains(Text({job}, Shows(2)),
                       " wants=primitive-ids,barycentrics,depths,values,derivatives channels=3\n"));
  SubjectInfo values_alone = Shows(2);
  values_alone.fragments.shows_derivatives = false;
  EXPECT_TRUE(Contains(Text({job}, values_alone), ",depths,values channels=3\n"));
  SubjectInfo shows_none = values_alone;
  shows_none.fragments.shows_values = false;
  Scene without = TwoPixels();
  without.channels.clear();
  for (const std::string& text :
       {Text({job}, shows_none), Text({Wanting(job.wants, without)}, Shows(2)),
        Text({Wanting(kEverything)}, Shows(2)), Text({job}, Shows(1))}) {
    EXPECT_FALSE(Contains(text, "channels") || Contains(text, "values")) << text;
    EXPECT_FALSE(Contains(text, "perspective")) << text;
  }
}

TEST(ValueProtocol, SendsChannelsOnce) {
  const DrawJob first = Wanting(ValuesToo(kCoverageAndPrimitiveIds, false));
  DrawJob unasked = first;
  unasked.wants = kEverything;
  Scene other_channels = *first.scene;
  other_channels.channels[0].values[1] = 0.0;
  Scene wider = *first.scene;
  wider.width = 3;
  Scene moved = *first.scene;
  moved.vertices[0].x = 0.5;
  const std::vector<DrawJob> jobs{first,
                                  unasked,
                                  first,
                                  Wanting(first.wants, other_channels),
                                  Wanting(first.wants, wider),
                                  unasked,
                                  Wanting(first.wants, moved)};
  for (const int protocol : {2, 3}) {
    const std::string text = Text(jobs, Shows(protocol));
    EXPECT_EQ(Times(text, "channels=same"), 1U);
    EXPECT_EQ(Times(text, "channels=3"), 4U);
    const std::vector<DrawJob> read = Read(text);
    ASSERT_EQ(read.size(), jobs.size());
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      EXPECT_EQ(read[k].wants, jobs[k].wants);
      if (jobs[k].wants.values) {
        EXPECT_EQ(SceneOf(read[k]), SceneOf(jobs[k])) << k;
      }
    }
    EXPECT_TRUE(std::signbit(read[2].scene->channels[0].values[1]));
    EXPECT_FALSE(std::signbit(read[3].scene->channels[0].values[1]));
    EXPECT_EQ(read[0].scene, read[2].scene) << "it shares them";
  }
}

TEST(ValueProtocol, RefusesChannelsThatAreNone) {
  const std::string head = "draw 5 2 1 1 window 1 0 wants=primitive-ids,values channels=";
  const std::string vertex = "\n0 0 0 1\n";
  const auto refuses = [](const std::string& text, std::string_view said) {
    try {
      Read(text);
      ADD_FAILURE() << "taken: " << text;
    } catch (const InputError& error) {
      EXPECT_TRUE(Contains(error.what(), said)) << text << "\n" << error.what();
    }
  };
  for (const char* const none : {"0", "65"}) refuses(head + none + vertex, "give 1 to 64 channels");
  refuses(head + "x" + vertex, "give a number, not x");
  refuses(head + "same" + vertex,
          "request 5: not what a request looks like; give channels=N: no request");
  const std::string both = "give channels=N and values among wants=..., or neither";
  refuses("draw 5 2 1 1 window 1 0 wants=primitive-ids,values" + vertex, both);
  refuses("draw 5 2 1 1 window 1 0 wants=primitive-ids channels=1" + vertex, both);
  refuses("draw 5 2 1 1 window 1 0 wants=primitive-ids,derivatives" + vertex, both);
  const std::pair<const char*, const char*> bad[] = {
      {"", "request 5, channel 0: not what"},
      {"u smooth sample 1", "give NAME flat|linear|perspective|inverse-w sample|centre|centroid"},
      {"u linear corner 1", "give NAME flat|linear|perspective|inverse-w sample|centre|centroid"},
      {"u linear sample", "channel 0 (u): not what a request looks like; give 1 numbers"},
      {"u linear sample 1 2", "give 1 numbers, one a vertex"},
      {"u linear sample x", "give 1 numbers, one a vertex"},
      {"q inverse-w sample 1", "channel 0 (q): not what a request looks like; give no numbers"},
  };
  for (const auto& [line, said] : bad) refuses(head + "1" + vertex + line + "\n", said);
  // Arrays.
  const std::string text = Text({Wanting(ValuesToo(kCoverageAndPrimitiveIds, false))}, Shows(3));
  const auto changed = [&](std::string_view from, std::string_view to) {
    std::string wrong = text;
    return wrong.replace(wrong.find(from), from.size(), to);
  };
  refuses(changed("u perspective sample", "u perspective sample 1"), "as an array after the line");
  refuses(changed("(3, 1), }", "(1, 3), }"), "request 1, its channel u: an array has shape (1, 3)");
  refuses(text.substr(0, text.find("id flat") + 140), "array");
}

Drawing Answered(const std::string& answer, const DrawJob& job) {
  std::istringstream lines(answer);
  std::string line;
  return ReadAnswer(1, job, Shows(2),
                    [&](std::size_t) {
                      std::getline(lines, line);
                      return std::string_view(line);
                    },
                    {});
}

TEST(ValueProtocol, AnswersReadBack) {
  Drawing drawing;
  drawing.counts = CoverageCounts(2, 1);
  drawing.counts.front = {0, 1};
  drawing.primitive_ids = {kNoPrimitive, 0};
  drawing.barycentrics = {{}, {0.25, 0.5, 0.25}};
  drawing.depths = {0, 0.125};
  drawing.values = {0, 0, 0, 0.1, -0.0, INFINITY};
  drawing.derivatives = {{}, {}, {}, {1, 2}, {3, 4}, {5, 0.1}};
  const Outputs ids = kCoverageAndPrimitiveIds;
  const auto text = [&](Outputs wants) {
    return AnswerText(1, drawing, CoverageKind::kFragments, wants);
  };
  const Outputs alone = ValuesToo(ids, false);
  EXPECT_EQ(text(alone), "fragments 1\n-1 0 0.1 -0 inf\n");
  const Drawing values = Answered(text(alone), Wanting(alone));
  EXPECT_EQ(values.values, drawing.values);
  EXPECT_TRUE(std::signbit(values.values[4]));
  EXPECT_TRUE(values.derivatives.empty() && values.barycentrics.empty());

  const Outputs both = ValuesToo(ids, true);
  EXPECT_EQ(text(both), "fragments 1\n-1 0 0.1 1 2 -0 3 4 inf 5 0.1\n");
  EXPECT_EQ(Answered(text(both), Wanting(both)).derivatives, drawing.derivatives);
  const Outputs all = ValuesToo(kEverything, true);
  const Drawing everything = Answered(text(all), Wanting(all));
  EXPECT_EQ(everything.barycentrics, drawing.barycentrics);
  EXPECT_EQ(everything.depths, drawing.depths);
  EXPECT_EQ(everything.values, drawing.values);
  EXPECT_EQ(everything.derivatives, drawing.derivatives);
  for (const char* const wrong :
       {"fragments 1\n-1 0 1 2\n", "fragments 1\n-1 0 1 2 3 4\n", "fragments 1\n-1 0 1 2 x\n"})
    EXPECT_THROW(Answered(wrong, Wanting(alone)), SubjectStop) << wrong;
}

TEST(ValueProtocol, ServesWhatASubjectShows) {
  FakeSubject subject = FakeSubject::Showing(Shows(1), [](const DrawJob& job) {
    Drawing drawing;
    drawing.counts = CoverageCounts(job.scene->width, job.scene->height);
    drawing.primitive_ids.assign(drawing.counts.size(), 0);
    for (std::size_t k = 0; k < drawing.counts.size(); ++k)
      for (const Channel& channel : job.scene->channels)
        drawing.values.push_back(channel.values.empty() ? 0.5 : channel.values[2]);
    return drawing;
  });
  const auto said = [&](bool derivatives) {
    std::istringstream in(
        Text({Wanting(ValuesToo(kCoverageAndPrimitiveIds, derivatives))}, Shows(3)));
    std::string text;
    Serve(subject, in, [&](const std::string& more) { text += more; });
    return text;
  };
  EXPECT_EQ(said(false), "fragments 1\n0 1e+300 0.5 3 0 1e+300 0.5 3\n");
  EXPECT_EQ(said(true).substr(0, 7), "fault 1") << "it has no derivatives";
}

}  // namespace
}  // namespace rasterproof::subjects
