// rasterproof certify: everything that is known of a subject, as a certificate and a page.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "report/certificate.h"
#include "report/page.h"
#include "subjects/builtin/builtin.h"
#include "tool/certify.h"
#include "tool/commands.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

// ':' is no character for a folder's name everywhere.
std::string FolderName(std::string subject) {
  std::ranges::replace(subject, ':', '+');
  return subject;
}

// Certifies the subjects on every core; the order of the result is that of the names.
std::vector<report::Certificate> CertifyAll(const std::vector<std::string>& names,
                                            const CertifyOptions& options,
                                            std::vector<std::unique_ptr<MeasuredScene>>& scenes,
                                            Progress& progress) {
  std::vector<report::Certificate> certificates(names.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  progress.Stage("certifying subjects", names.size());
  const auto work = [&] {
    for (std::size_t k = next++; k < names.size(); k = next++) {
      try {
        certificates[k] = CertifySubject(names[k], options, scenes);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        failure = std::current_exception();
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
  if (failure) std::rethrow_exception(failure);
  return certificates;
}

std::string FolderOf(const std::string& output, const report::Certificate& certificate) {
  return output + "/" + FolderName(certificate.subject.name);
}

// Every counterexample is saved as a case file; the certificate tells how to run it again.
void NameReplays(const std::string& output, report::Certificate& certificate) {
  for (const PropertyResult& result : certificate.tested) {
    if (!result.counterexample) continue;
    certificate.replay[result.property] = fmt::format(
        "rasterproof replay {}/{}.json", FolderOf(output, certificate), result.property);
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
struct WrongOfOwn {
  std::uint64_t wrong = 0;
  std::uint64_t samples = 0;
};

WrongOfOwn CountWrong(const report::Certificate& certificate) {
  WrongOfOwn total;
  for (const SceneResult& result : certificate.measured) {
    if (!result.applicable || result.profile != certificate.subject.profile.name) continue;
    if (!result.message.empty()) continue;  // beyond the profile's limits
    total.wrong += result.difference.wrong;
    total.samples += result.difference.samples;
  }
  return total;
}

bool KeepsItsClaim(const report::Certificate& certificate) {
  return report::OverallVerdict(certificate) == "holds" && CountWrong(certificate).wrong == 0;
}

std::string SummaryLine(const report::Certificate& certificate) {
  std::size_t held = 0;
  std::size_t violated = 0;
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome == Outcome::kHolds) ++held;
    if (result.outcome == Outcome::kViolated) ++violated;
  }
  const WrongOfOwn wrong = CountWrong(certificate);
  return fmt::format("{:<38} {:<12} {:>3} hold {:>3} violated  {:>9} of {} samples wrong{}\n",
                     certificate.subject.name, report::OverallVerdict(certificate), held, violated,
                     wrong.wrong, wrong.samples,
                     certificate.claims_exact ? "  (claims exact)" : "");
}

}  // namespace

int RunCertify(const CertifyOptions& options) {
  RequireHonestEnvironment();
  const std::vector<std::string> names = options.all ? subjects::BuiltinNames() : options.subjects;
  // Misspelt names before any work.
  for (const std::string& name : names) SayOfPreset(MakeSubject(name)->Info().profile);
  io::MakeFolder(options.output);
  report::Page page;
  {
    Progress progress;
    std::vector<std::unique_ptr<MeasuredScene>> scenes = LoadSceneSet(options.scene_set, progress);
    page.title = "rasterproof " RASTERPROOF_VERSION;
    page.certificates = CertifyAll(names, options, scenes, progress);
    page.pictures = TakePictures(scenes, page.certificates, progress);
  }
  std::string text;
  bool claims_kept = true;
  bool violated = false;
  for (report::Certificate& certificate : page.certificates) {
    NameReplays(options.output, certificate);
    WriteCertificate(options.output, certificate);
    text += SummaryLine(certificate);
    const bool kept = KeepsItsClaim(certificate);
    violated = violated || !kept;
    if (certificate.claims_exact) claims_kept = claims_kept && kept;
  }
  const std::string path = options.output + "/report.html";
  io::WriteFile(path, report::PageToHtml(page));
  text += "report: " + path + "\n";
  io::WriteStandardOutput(text);
  // A survey of every method is judged by what each claims: that a naive one fails is what it is
  // here to show.
  if (options.all) return claims_kept ? kExitHolds : kExitViolated;
  return violated ? kExitViolated : kExitHolds;
}

}  // namespace rasterproof::tool
