// rasterproof certify: everything that is known of a subject, as a certificate and a page.
#include "tool/certify/cmd_certify.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <string>
#include <vector>

#include "core/authority.h"
#include "core/bench_result.h"
#include "core/error.h"
#include "core/subject_info.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "io/scene_file.h"
#include "props/domains/worlds.h"
#include "report/bench_json.h"
#include "report/bench_page.h"
#include "report/certificate.h"
#include "report/grounds.h"
#include "report/page.h"
#include "report/text.h"
#include "tool/browser/cmd_browser.h"
#include "tool/certify/certify.h"
#include "tool/certify/part_file.h"
#include "tool/certify/shard.h"
#include "tool/compare/comparison.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/resolve_case.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

// A part of a subject's certificate.
struct Task {
  std::size_t subject;
  std::size_t part;
};

// Does the parts of all certifications, shared among the workers. What it throws goes to `failure`.
void DoAll(const std::vector<SubjectFactory>& subjects, std::deque<Certification>& all, int jobs,
           Progress& progress, std::exception_ptr& failure) {
  std::vector<Task> tasks;
  std::vector<std::size_t> order;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const auto takes_long = [&](std::size_t part) { return all[s].TakesLong(part); };
    for (const std::size_t part : OrderOfWork(jobs, all[s].size(), takes_long)) {
      order.push_back(tasks.size() + part);
    }
    for (std::size_t part = 0; part < all[s].size(); ++part) tasks.push_back({s, part});
  }
  Crew crew(jobs, [&](std::size_t s) { return subjects[s].Make(); });
  std::atomic<std::size_t> done = 0;
  progress.Stage("certifying: properties and scenes", tasks.size());
  try {
    ShareWork(jobs, order, [&](std::size_t worker, std::size_t k) {
      const auto [subject, part] = tasks[k];
      try {
        if (!Interrupted()) all[subject].Do(part, crew.Of(worker, subject));
      } catch (...) {
        if (!Interrupted()) throw;  // else it was not begun
      }
      progress.Done(++done);
    });
  } catch (...) {  // thrown again once what is known is written
    failure = std::current_exception();
  }
}

// Certifies the subjects; the order of the result is theirs. Those that an interrupt kept from
// being begun are left out; so is the one that met `failure`, and those after it.
std::vector<report::Certificate> CertifyAll(const std::vector<SubjectFactory>& subjects,
                                            const CertifyOptions& options, const Source& source,
                                            MeasuredScenes& scenes, Progress& progress,
                                            std::exception_ptr& failure) {
  std::deque<Certification> all;
  for (const SubjectFactory& subject : subjects) all.emplace_back(subject, options, scenes, source);
  DoAll(subjects, all, options.jobs, progress, failure);
  std::vector<report::Certificate> certificates;
  for (const Certification& one : all) {
    if (failure && !one.IsDone()) break;
    if (one.IsBegun()) certificates.push_back(one.Result());
  }
  return certificates;
}

// A counterexample's file is named after its property, and after the world if it ran over one.
std::string FileStemOf(const PropertyResult& result) {
  return result.world.empty() ? result.property : result.property + "-" + result.world;
}

// Every subject has a folder, and every counterexample there a case file; the certificate says
// where, and how to run it again.
void NameFiles(const std::string& output, report::Certificate& certificate) {
  const std::string& subject = certificate.subject.name;
  certificate.folder = FileNameOf(subject);
  for (const PropertyResult& result : certificate.tested) {
    if (!result.counterexample) continue;
    const std::string path =
        fmt::format("{}/{}/{}.json", output, certificate.folder, FileStemOf(result));
    std::string command = "rasterproof replay " + ShellWord(path);
    if (IsOutside(subject)) command += " --subject " + ShellWord(subject);  // no file names it
    certificate.replay[NameOf(result)] = command;
  }
}

void WriteCertificate(const std::string& output, const report::Certificate& certificate) {
  const std::string folder = output + "/" + certificate.folder;
  io::MakeFolder(folder);
  io::WriteFile(folder + "/certificate.json", report::CertificateToJson(certificate));
  io::WriteFile(folder + "/certificate-times.json", report::TimesToJson(certificate));
  io::WriteFile(folder + "/junit.xml", report::JUnitXml(certificate));
  for (const PropertyResult& result : certificate.tested) {
    if (!result.counterexample) continue;
    const auto& found = *result.counterexample;
    io::WriteFile(
        folder + "/" + FileStemOf(result) + ".json",
        io::CaseToJson({found.value, result.subject, result.property, found.verdict.drawn}));
  }
}

// What the page's commands read: wrong decisions as scenes.
void WriteBenchCases(const std::string& output, const BenchResult& bench) {
  const std::vector<report::BenchCase> cases = report::BenchCases(bench);
  if (!cases.empty()) io::MakeFolder(output + "/bench");
  for (const report::BenchCase& one : cases) {
    io::WriteFile(output + "/" + one.file, io::SceneToJson(one.scene));
  }
}

// Larger targets cost each subject seconds and 2 GiB.
constexpr std::int64_t kMostPixelsOfReport = std::int64_t{1} << 26;

void WriteCatalogue(const std::string& output, const report::Catalogue& catalogue) {
  io::MakeFolder(output + "/families");
  for (std::size_t k = 0; k < catalogue.table.rows.size(); ++k) {
    const std::string path = output + "/" + report::FamilyPagePath(catalogue.table.rows[k]);
    io::WriteFile(path + ".html", report::FamilyPageToHtml(catalogue, k));
    if (const auto& picture = catalogue.pictures[k]) io::WriteFile(path + ".svg", picture->svg);
  }
  io::WriteFile(output + "/catalogue.json", report::ComparisonToJson(catalogue.table));
}

// Where failures open. The browser's page is copied beside the report, so that both can be moved;
// where it isn't installed there is no link.
std::string PlaygroundOf(const CertifyOptions& options,
                         const std::vector<report::Certificate>& certificates) {
  if (!options.browser.empty()) return options.browser;
  const bool is_violated = std::ranges::any_of(certificates, [](const report::Certificate& one) {
    return report::OverallOf(one).outcome == Outcome::kViolated;
  });
  const auto installed = FindBrowserPage();
  if (!is_violated || !installed) return {};
  io::WriteFile(options.output + "/" + kBrowserPage, io::ReadFile(*installed));
  return kBrowserPage;
}

// The page of all subjects comes last: what it leads to and shows is then there, each file whole.
std::string WritePages(const std::string& output, const report::Page& page) {
  for (const report::Picture& picture : page.pictures) {
    const std::string path = output + "/" + picture.file;
    io::MakeFolder(path.substr(0, path.rfind('/')));
    io::WriteFile(path, picture.content);
  }
  for (const report::Certificate& certificate : page.certificates) {
    io::WriteFile(output + "/" + certificate.folder + "/report.html",
                  report::SubjectPageToHtml(page, certificate));
  }
  if (page.bench) WriteBenchCases(output, *page.bench);
  if (page.catalogue) WriteCatalogue(output, *page.catalogue);
  const std::string path = output + "/report.html";
  io::WriteFile(path, report::PageToHtml(page));
  return path;
}

// How many scenes the joint verdict judged, and acquitted. Empty if none.
std::string LegalScenes(const report::Certificate& certificate) {
  std::uint64_t judged = 0;
  std::uint64_t legal = 0;
  for (const PropertyResult& result : certificate.tested) {
    if (!result.is_of_a_scene) continue;
    if (result.outcome == Outcome::kHolds) ++legal;
    if (result.outcome == Outcome::kHolds || result.outcome == Outcome::kViolated) ++judged;
  }
  return judged == 0 ? "" : fmt::format("{} of {} scenes have a legal model", legal, judged);
}

// Wrong samples over the scenes that the subject's own profile judges.
std::string WrongSamples(const report::Certificate& certificate) {
  std::uint64_t wrong = 0;
  std::uint64_t samples = 0;
  for (const SceneResult& result : certificate.measured) {
    if (!report::IsJudged(certificate, result)) continue;
    wrong += result.difference.wrong;
    samples += result.difference.samples;
  }
  if (samples == 0) {
    const std::string legal = LegalScenes(certificate);
    return legal.empty() ? "no scene judged" : legal;
  }
  return fmt::format("{:>9} of {} samples wrong", wrong, samples);
}

std::string SummaryLine(const report::Certificate& certificate) {
  const auto count = [&](Outcome outcome) {
    return std::ranges::count(certificate.tested, outcome, &PropertyResult::outcome);
  };
  const report::Overall overall = report::OverallOf(certificate);
  const auto lacks = std::ranges::count_if(certificate.tested, [&](const PropertyResult& result) {
    return IsLackOfQuality(result, certificate.fail_on);
  });
  std::string line = fmt::format(
      "{:<38} {:<12} {:>3} hold {:>3} violated  {}{}", certificate.subject.name,
      OutcomeName(overall.outcome), count(Outcome::kHolds), count(Outcome::kViolated) - lacks,
      WrongSamples(certificate), certificate.subject.states_exact ? "  (states exact)" : "");
  if (lacks != 0) line += fmt::format("; {} short of quality", lacks);
  if (overall.outcome == Outcome::kInconclusive) line += "; " + overall.reason;
  if (overall.outcome == Outcome::kHolds && !certificate.contract_thin.empty()) {
    line += "; " + certificate.contract_thin;
  }
  if (overall.outcome == Outcome::kViolated && certificate.interrupted) line += "; interrupted";
  return report::CleanText(line) + "\n";
}

// Says where to read of results with reservations and of scenes that were not drawn.
std::string Remarks(const report::Certificate& certificate) {
  std::string text;
  const auto add = [&](const std::string& line) { text += "  " + report::CleanText(line) + "\n"; };
  for (const report::Evidence& one : report::AssumptionsUnder(certificate.subject.profile)) {
    add("assumed: " + one.statement + ": " + one.by);
  }
  for (const PropertyResult& result : certificate.tested) {
    if (!IsLackOfQuality(result, certificate.fail_on)) continue;
    add(NameOf(result) + ": " + report::AuthorityText(result) + "; " + report::Said(result));
  }
  for (const PropertyResult& result : certificate.tested) {
    const bool reserved = result.cases_refused != 0 || result.not_judged != 0;
    if (reserved) add(NameOf(result) + ": " + report::Said(result));
  }
  for (const report::Evidence& one : report::Exhausted(certificate)) {
    add("exhausted: " + one.statement + ": " + one.by);
  }
  for (const report::Evidence& evidence : report::ScenesNotDrawn(certificate)) {
    add(evidence.statement + ": " + evidence.by);
  }
  const std::string not_asked = report::NotAskedText(certificate.not_asked);
  if (!not_asked.empty()) add("not asked: " + not_asked);
  return text;
}

// With --all, only methods that claim to be exact can fail the run; the naive ones are there to
// fail (docs/decisions/campaigns.md).
bool Counts(const report::Certificate& certificate, Outcome outcome, bool survey) {
  return !survey || certificate.subject.states_exact || outcome != Outcome::kViolated;
}

// The worst subject decides the exit status.
int ExitStatus(const std::vector<report::Certificate>& certificates, bool survey) {
  int status = certificates.empty() ? kExitInconclusive : kExitHolds;
  for (const report::Certificate& certificate : certificates) {
    const Outcome outcome = report::OverallOf(certificate).outcome;
    if (Counts(certificate, outcome, survey)) status = WorseStatus(status, StatusOf(outcome));
  }
  return status;
}

// Each once, in order; misspelt names are found before any work.
std::vector<SubjectFactory> SubjectsOf(const CertifyOptions& options) {
  std::vector<SubjectFactory> subjects;
  for (const std::string& name : options.all ? BuiltInNames() : options.subjects) {
    if (std::ranges::find(subjects, name, &SubjectFactory::name) != subjects.end()) continue;
    NotePreset(subjects.emplace_back(ResolveSubject(name, options.profile)).Make()->Info().profile);
  }
  return subjects;
}

// Misspelt names are found before any work.
void RequireWorlds(const std::vector<std::string>& worlds) {
  for (auto name = worlds.begin(); name != worlds.end(); ++name) {
    RequireWorld("--exhaustive", *name);
    if (std::find(worlds.begin(), name, *name) != name) {
      throw InputError("--exhaustive", "the world " + *name + " is named twice", "name it once");
    }
  }
}

std::string Summary(const std::vector<report::Certificate>& certificates, std::size_t asked,
                    bool survey) {
  std::string text;
  for (const report::Certificate& certificate : certificates) {
    text += SummaryLine(certificate);
    if (!survey) text += Remarks(certificate);
  }
  if (Interrupted()) {
    text += fmt::format("interrupted: {} of {} subjects begun; results so far:\n",
                        certificates.size(), asked);
  }
  return text;
}

// "part-2-of-5.json", "part-200-to-400.json"
std::string PartName(const SubjectPart& part) {
  if (part.shard) return fmt::format("part-{}-of-{}.json", part.shard->number, part.shard->count);
  return fmt::format("part-{}-to-{}.json", part.range.first, part.range.end);
}

std::string WritePart(const std::string& output, const SubjectPart& part) {
  const std::string folder = output + "/" + FileNameOf(part.subject);
  io::MakeFolder(folder);
  const std::string path = folder + "/" + PartName(part);
  io::WriteFile(path, PartToJson(part));
  const auto ended = std::ranges::count_if(part.tests, [](const PropertyResult& test) {
    return test.end == End::kFailed || test.end == End::kInconclusive;
  });
  return report::CleanText(fmt::format(
             "{}: cases {}..{} of each property, {} of {} ended early: {}", part.subject,
             part.range.first, part.range.end, ended, part.tests.size(), path)) +
         "\n";
}

// Whatever the cases show, the status says whether the parts were written: --merge judges.
int RunParts(const CertifyOptions& options, const Source& source) {
  const std::vector<SubjectFactory> subjects = SubjectsOf(options);
  MeasuredScenes none;
  std::deque<Certification> all;
  for (const SubjectFactory& subject : subjects) all.emplace_back(subject, options, none, source);
  std::exception_ptr failure;
  {
    Progress progress;
    DoAll(subjects, all, options.jobs, progress, failure);
  }
  if (failure) std::rethrow_exception(failure);
  if (Interrupted()) {
    io::WriteStandardOutput("interrupted: no part is written; run it again\n");
    return kExitInconclusive;
  }
  std::string text;
  for (const Certification& one : all) text += WritePart(options.output, one.ToPart());
  io::WriteStandardOutput(text);
  return kExitHolds;
}

void RequireForAPart(const CertifyOptions& options) {
  const std::string place = options.range ? "--cases A..B" : "--shard";
  const auto refuse = [&](const std::string& option, const std::string& remedy) {
    throw InputError(place, "a part of a campaign does not take " + option, remedy);
  };
  if (options.campaign.seconds > 0) refuse("--seconds", "give --cases instead");
  if (!options.scene_set.empty())
    refuse("--scenes", "give it to --merge, which measures the scenes");
  if (options.fail_on == FailOn::kQuality) refuse("--fail-on", "give it to --merge");
  if (options.catalogue) refuse("--catalogue", "give it to --merge, which makes the page");
  if (!options.bench.empty()) refuse("--bench", "give it to --merge, which makes the page");
  if (!options.survey.empty()) refuse("--survey", "give it to --merge, which makes the page");
  if (!options.browser.empty()) refuse("--browser", "give it to --merge, which makes the page");
  if (options.range && !options.shard.empty()) {
    refuse("--shard beside it", "give --cases N with --shard, or --cases A..B alone");
  }
  if (options.range && !options.worlds.empty()) {
    refuse("--exhaustive", "cut the campaign with --shard, which cuts worlds too");
  }
}

}  // namespace

int RunCertify(const CertifyOptions& options) {
  RequireHonestEnvironment();
  RequireWorlds(options.worlds);
  Source source;
  source.range = options.range;
  if (!options.shard.empty()) source.shard = ParseShard(options.shard, EnvironmentVariables());
  if (!source.IsAPart()) return Certify(options, source);
  RequireForAPart(options);
  return RunParts(options, source);
}

int Certify(const CertifyOptions& options, const Source& source) {
  const std::vector<SubjectFactory> subjects = SubjectsOf(options);
  report::Page page;
  if (!options.bench.empty()) page.bench = report::ReadBench(options.bench);
  if (!options.survey.empty()) page.surveys = report::SurveySection(options.survey);
  page.folder = ShellWord(options.output);
  io::MakeFolder(options.output);
  std::exception_ptr failure;
  {
    Progress progress;
    MeasuredScenes scenes = LoadSceneSet(options.scene_set, progress);
    page.title = "rasterproof " RASTERPROOF_VERSION;
    page.is_survey = options.all;
    page.certificates = CertifyAll(subjects, options, source, scenes, progress, failure);
    // What is known is written before anything else can go wrong.
    for (report::Certificate& certificate : page.certificates) {
      NameFiles(options.output, certificate);
      WriteCertificate(options.output, certificate);
    }
    if (failure) std::rethrow_exception(failure);
    page.playground = PlaygroundOf(options, page.certificates);
    page.value_methods = ValueMethodRows();
    if (!Interrupted()) ExplainValues(page.certificates, progress);
    if (!Interrupted()) page.pictures = TakePictures(scenes, page.certificates, progress);
  }
  if (options.catalogue) {
    page.catalogue =
        MeasureCatalogues(subjects,
                          {.seed = options.campaign.seed,
                           .cases = options.campaign.cases,
                           .most_pixels = kMostPixelsOfReport,
                           .limits = {.seconds = options.campaign.seconds, .stop = Interrupted}},
                          options.jobs);
  }
  const std::string path = WritePages(options.output, page);
  io::WriteStandardOutput(Summary(page.certificates, subjects.size(), options.all) +
                          "report: " + path + "\n");
  return ExitStatus(page.certificates, options.all);
}

}  // namespace rasterproof::tool
