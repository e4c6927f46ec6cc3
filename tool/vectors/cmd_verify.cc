// rasterproof vectors verify: answers that contradict every legal drawing.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/subject.h"
#include "core/target_size.h"
#include "fmt/format.h"
#include "io/output.h"
#include "io/vectors_file.h"
#include "model/target_profile.h"
#include "tool/exit_status.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/session.h"
#include "tool/vectors/cmd_vectors.h"
#include "tool/vectors/vectors_verdict.h"

namespace rasterproof::tool {
namespace {

// The subject's samples lie elsewhere: what it covers is no answer.
void RequireSamplesOf(const SubjectInfo& info, const TestVector& vector) {
  const TargetProfile profile(info.profile, vector.scene);
  if (profile.pattern == vector.pattern && profile.y_axis == vector.y_axis) return;
  throw InputError("subject " + info.name,
                   "its sample locations differ from those of case " + vector.name +
                       ", or its y axis points the other way",
                   "generate vectors for a profile with its sample locations and y axis");
}

bool ShowsCounts(const SubjectInfo& info) {
  return info.coverage == CoverageKind::kFacingCounts || info.coverage == CoverageKind::kCounts;
}

// What the subject covers of each triangle, drawn alone, and how often it counts each sample of all
// of them in one call. Nothing of scenes that it does not take.
VectorsDrawn DrawBy(Subject& subject, const std::vector<TestVector>& vectors) {
  VectorsDrawn drawn{.triangles = {}, .in_one_call = false};
  Progress progress;
  progress.Stage("drawing by " + subject.Info().name, vectors.size());
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    progress.Done(v);
    const TestVector& vector = vectors[v];
    RequireSamplesOf(subject.Info(), vector);
    if (!Takes(subject.Info(), vector.scene)) continue;
    for (std::size_t t = 0; t < vector.triangles.size(); ++t) {
      Scene alone = vector.scene;
      alone.triangles = {vector.scene.triangles[t]};
      const CoverageCounts counts = Draw(subject, alone);
      std::vector<std::size_t>& covered = drawn.triangles[{v, t}];
      for (std::size_t s = 0; s < counts.size(); ++s)
        if (counts.Count(s) != 0) covered.push_back(s);
    }
    if (vector.joint.empty() || !ShowsCounts(subject.Info())) continue;
    const CoverageCounts counts = Draw(subject, vector.scene);
    std::vector<std::uint32_t>& together = drawn.together[v];
    for (std::size_t s = 0; s < counts.size(); ++s) together.push_back(counts.Count(s));
  }
  return drawn;
}

// The file's text. What is written for a test bench is no file of vectors to judge by.
std::string VectorsText(const std::string& path) {
  const bool is_folder = path != "-" && std::filesystem::is_directory(path);
  std::string text = is_folder ? std::string() : io::ReadFile(path);
  const bool is_table = text.starts_with("//") || text.starts_with("/*");
  if (!is_folder && !is_table) return text;
  throw InputError(
      path == "-" ? "standard input" : path,
      "it is not in the format jsonl, the only one that verify reads",
      "generate it again with the same options and --format jsonl; its cases stay the same");
}

std::string Plural(std::uint64_t n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string VerdictText(const VectorsVerdict& verdict) {
  std::string text;
  for (const std::string& line : verdict.contradictions) text += line + "\n";
  if (verdict.contradicted > verdict.contradictions.size()) {
    text += fmt::format("... and {} more; --show N prints more of them\n",
                        verdict.contradicted - verdict.contradictions.size());
  }
  if (verdict.missing != 0) {
    text += fmt::format("no answer for {}, {} answered in part\n",
                        Plural(verdict.missing, "triangle"), Plural(verdict.partly, "case"));
  }
  if (verdict.contradicted != 0) {
    return text + fmt::format("{} in {}, of {} with answers\n",
                              Plural(verdict.contradicted, "contradiction"),
                              Plural(verdict.cases_contradicted, "case"),
                              verdict.cases + verdict.partly);
  }
  return text + fmt::format("no contradiction in {}, {} among them\n",
                            Plural(verdict.cases, "case"),
                            Plural(verdict.joint, "joint constraint"));
}

}  // namespace

int RunVerify(const VerifyOptions& options) {
  if (options.answers.empty() == options.subject.empty()) {
    throw InputError("vectors verify", "no answers are given",
                     "give a file of answers, or a subject by --subject, --plugin or --exec");
  }
  if (options.vectors == "-" && options.answers == "-") {
    throw InputError("vectors verify", "both files are standard input", "name one of them");
  }
  const auto place = [](const std::string& path) {
    return path == "-" ? std::string("standard input") : path;
  };
  const io::VectorsFile file =
      io::ParseVectors(VectorsText(options.vectors), place(options.vectors));
  VectorsDrawn drawn{.triangles = {}, .in_one_call = !options.alone};
  if (options.subject.empty()) {
    drawn.triangles =
        io::ParseAnswers(io::ReadFile(options.answers), place(options.answers), file.vectors);
  } else {
    const std::unique_ptr<Subject> subject = MakeSubject(options.subject);
    drawn = DrawBy(*subject, file.vectors);
  }
  const VectorsVerdict verdict = JudgeDrawn(file, drawn, options.shown);
  io::WriteStandardOutput(VerdictText(verdict));
  if (verdict.contradicted != 0) return kExitViolated;
  return verdict.cases + verdict.partly != 0 ? kExitHolds : kExitInconclusive;
}

}  // namespace rasterproof::tool
