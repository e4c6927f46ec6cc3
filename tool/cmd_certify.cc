// rasterproof certify: everything that is known of a subject, as a certificate and a page.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "report/certificate.h"
#include "report/page.h"
#include "report/text.h"
#include "subjects/builtin/builtin.h"
#include "tool/certify.h"
#include "tool/commands.h"
#include "tool/exit_status.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/session.h"
#include "tool/shell.h"

namespace rasterproof::tool {
namespace {

// Certifies the subjects on every core; the order of the result is that of the names. Subjects that
// an interrupt kept from being begun are left out; so is the one that met `failure`, and those
// behind it.
std::vector<report::Certificate> CertifyAll(const std::vector<std::string>& names,
                                            const CertifyOptions& options, MeasuredScenes& scenes,
                                            Progress& progress, std::exception_ptr& failure) {
  std::vector<std::optional<report::Certificate>> begun(names.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  std::mutex failure_mutex;
  progress.Stage("certifying subjects", names.size());
  const auto work = [&] {
    for (std::size_t k = next++; k < names.size() && !Interrupted(); k = next++) {
      try {
        begun[k] = CertifySubject(names[k], options, scenes);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!Interrupted()) failure = std::current_exception();  // else it was not begun
        next = names.size();
      }
      progress.Done(++done);
    }
  };
  std::vector<std::thread> threads;
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  for (unsigned t = 0; t < std::min<std::size_t>(cores, names.size()); ++t) {
    threads.emplace_back(work);
  }
  for (std::thread& thread : threads) thread.join();
  std::vector<report::Certificate> certificates;
  for (std::optional<report::Certificate>& certificate : begun) {
    if (certificate) certificates.push_back(*std::move(certificate));
  }
  return certificates;
}

std::string FolderOf(const std::string& output, const report::Certificate& certificate) {
  return output + "/" + FileNameOf(certificate.subject.name);
}

// Every counterexample is saved as a case file; the certificate tells how to run it again.
void NameReplays(const std::string& output, report::Certificate& certificate) {
  const std::string& subject = certificate.subject.name;
  for (const PropertyResult& result : certificate.tested) {
    if (!result.counterexample) continue;
    const std::string path =
        fmt::format("{}/{}.json", FolderOf(output, certificate), result.property);
    std::string command = "rasterproof replay " + ShellWord(path);
    if (IsOutside(subject)) command += " --subject " + ShellWord(subject);  // no file names it
    certificate.replay[result.property] = command;
  }
}

void WriteCertificate(const std::string& output, const report::Certificate& certificate) {
  const std::string folder = FolderOf(output, certificate);
  io::MakeFolder(folder);
  io::WriteFile(folder + "/certificate.json", report::CertificateToJson(certificate));
  io::WriteFile(folder + "/junit.xml", report::JUnitXml(certificate));
  for (const PropertyResult& result : certificate.tested) {
    if (!result.counterexample) continue;
    io::WriteFile(folder + "/" + result.property + ".json",
                  io::CaseToJson({*result.counterexample, result.subject, result.property}));
  }
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
  if (samples == 0) return "no scene judged";
  return fmt::format("{:>9} of {} samples wrong", wrong, samples);
}

std::string SummaryLine(const report::Certificate& certificate) {
  const auto count = [&](Outcome outcome) {
    return std::ranges::count(certificate.tested, outcome, &PropertyResult::outcome);
  };
  const report::Overall overall = report::OverallOf(certificate);
  std::string line = fmt::format(
      "{:<38} {:<12} {:>3} hold {:>3} violated  {}{}", certificate.subject.name,
      OutcomeName(overall.outcome), count(Outcome::kHolds), count(Outcome::kViolated),
      WrongSamples(certificate), certificate.subject.claims_exact ? "  (claims exact)" : "");
  if (overall.outcome == Outcome::kInconclusive) line += "; " + overall.reason;
  if (overall.outcome == Outcome::kViolated && certificate.interrupted) line += "; interrupted";
  return report::CleanText(line) + "\n";
}

// What holds with reservations, and the scenes that were not drawn: told where they can be read.
std::string Remarks(const report::Certificate& certificate) {
  std::string text;
  const auto add = [&](const std::string& line) { text += "  " + report::CleanText(line) + "\n"; };
  for (const PropertyResult& result : certificate.tested) {
    const bool reserved = result.cases_refused != 0 || result.not_judged != 0;
    if (reserved) add(result.property + ": " + report::Said(result));
  }
  for (const report::Evidence& evidence : report::NotApplicable(certificate)) {
    if (evidence.claim.starts_with("scene ")) add(evidence.claim + ": " + evidence.by);
  }
  return text;
}

// A survey of every method is judged by what each claims: that a naive one fails is what it is here
// to show, and is observed (docs/decisions/0005).
bool Counts(const report::Certificate& certificate, Outcome outcome, bool survey) {
  return !survey || certificate.subject.claims_exact || outcome != Outcome::kViolated;
}

// Of several subjects the worst one tells.
int ExitStatus(const std::vector<report::Certificate>& certificates, bool survey) {
  int status = certificates.empty() ? kExitInconclusive : kExitHolds;
  for (const report::Certificate& certificate : certificates) {
    const Outcome outcome = report::OverallOf(certificate).outcome;
    if (Counts(certificate, outcome, survey)) status = WorseStatus(status, StatusOf(outcome));
  }
  return status;
}

// Each once, in order; misspelt names are found before any work.
std::vector<std::string> SubjectsOf(const CertifyOptions& options) {
  std::vector<std::string> names;
  for (const std::string& name : options.all ? subjects::BuiltinNames() : options.subjects) {
    if (std::ranges::find(names, name) != names.end()) continue;
    SayOfPreset(MakeSubject(name)->Info().profile);
    names.push_back(name);
  }
  return names;
}

std::string Summary(const std::vector<report::Certificate>& certificates, std::size_t asked,
                    bool survey) {
  std::string text;
  for (const report::Certificate& certificate : certificates) {
    text += SummaryLine(certificate);
    if (!survey) text += Remarks(certificate);
  }
  if (Interrupted()) {
    text += fmt::format("interrupted: {} of {} subjects begun; this is what is known so far\n",
                        certificates.size(), asked);
  }
  return text;
}

}  // namespace

int RunCertify(const CertifyOptions& options) {
  RequireHonestEnvironment();
  const std::vector<std::string> names = SubjectsOf(options);
  io::MakeFolder(options.output);
  report::Page page;
  std::exception_ptr failure;
  {
    Progress progress;
    MeasuredScenes scenes = LoadSceneSet(options.scene_set, progress);
    page.title = "rasterproof " RASTERPROOF_VERSION;
    page.certificates = CertifyAll(names, options, scenes, progress, failure);
    // What is known is written before anything else can go wrong.
    for (report::Certificate& certificate : page.certificates) {
      NameReplays(options.output, certificate);
      WriteCertificate(options.output, certificate);
    }
    if (failure) std::rethrow_exception(failure);
    if (!Interrupted()) page.pictures = TakePictures(scenes, page.certificates, progress);
  }
  const std::string path = options.output + "/report.html";
  io::WriteFile(path, report::PageToHtml(page));
  io::WriteStandardOutput(Summary(page.certificates, names.size(), options.all) +
                          "report: " + path + "\n");
  return ExitStatus(page.certificates, options.all);
}

}  // namespace rasterproof::tool
