// The pictures of the report page: real scenes as they are, and what the naive methods made of
// them.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "core/subject_errors.h"
#include "fmt/format.h"
#include "io/image.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "report/picture.h"
#include "tool/asked.h"
#include "tool/certify.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/session.h"
#include "tool/shell.h"

namespace rasterproof::tool {
namespace {

constexpr int kWidestPicture = 1024;  // a page should load at once
constexpr std::size_t kMostFailures = 12;

void PictureRender(const MeasuredScene& measured, std::vector<report::Picture>& pictures) {
  const reference::Method* method = reference::FindMethod("spans-exact");
  if (!measured.real() || measured.scene().width > kWidestPicture ||
      !Takes(method->info, measured.scene())) {
    return;
  }
  const FragmentBuffers fragments =
      reference::RasterizeFragments(measured.scene(), *method, {}, {.barycentrics = true});
  pictures.push_back(
      {measured.name() + ": barycentric barycentrics of the nearest triangle",
       fmt::format("{} --mode barycentrics --output {}", measured.CommandOf("render"),
                   ShellWord(FileNameOf(measured.name()) + ".png")),
       "", io::EncodePng(report::PaintBarycentrics(fragments))});
}

// The measurement on the scene by which the subject is violated; nullptr if it is not.
const SceneResult* WrongOn(const report::Certificate& certificate, const std::string& scene) {
  for (const SceneResult& result : certificate.measured) {
    if (result.scene == scene && result.difference.wrong != 0 &&
        report::IsJudged(certificate, result)) {
      return &result;
    }
  }
  return nullptr;
}

// The first place at which the subject differs from the model on the scene, explained; nothing if
// it doesn't.
void PictureFailure(const report::Certificate& certificate, const MeasuredScene& measured,
                    std::vector<report::Picture>& pictures) {
  const SceneResult* result = WrongOn(certificate, measured.name());
  if (result == nullptr) return;
  const std::string& name = certificate.subject.name;
  Case c;
  c.scene = measured.scene();
  c.profile = certificate.subject.profile;
  const CoverageDifference& difference = result->difference;
  Verdict verdict;
  verdict.message = fmt::format("{} on {}: {} of {} samples wrong, {} missing, {} unexpected", name,
                                measured.name(), difference.wrong, difference.samples,
                                difference.missing, difference.unexpected);
  const std::string replay = measured.CommandThatShows(name);
  try {
    const std::unique_ptr<Subject> subject = MakeSubject(name);
    const report::Explanation explanation = Explain(*subject, c, verdict, replay);
    pictures.push_back({explanation.headline, replay, report::ExplanationToSvg(explanation), ""});
  } catch (const InputError&) {
    // It drew the scene before and refuses it now: the certificate stands, the page has one picture
    // less.
    return;
  } catch (const SubjectTooSlow&) {
    return;  // or it was interrupted
  }
}

}  // namespace

std::vector<report::Picture> TakePictures(MeasuredScenes& scenes,
                                          const std::vector<report::Certificate>& certificates,
                                          Progress& progress) {
  std::vector<report::Picture> pictures;
  for (const std::unique_ptr<MeasuredScene>& measured : scenes) {
    progress.Stage("drawing " + measured->name());
    PictureRender(*measured, pictures);
  }
  // One failure of each scene, by the first subject that shows it and has not been shown yet, so
  // that the page tells of many subjects rather than of one many times.
  std::vector<std::string> shown;
  for (const std::unique_ptr<MeasuredScene>& measured : scenes) {
    if (shown.size() == kMostFailures) break;
    progress.Stage("explaining " + measured->name());
    for (const report::Certificate& certificate : certificates) {
      const std::string& name = certificate.subject.name;
      if (std::ranges::find(shown, name) != shown.end()) continue;
      const std::size_t before = pictures.size();
      PictureFailure(certificate, *measured, pictures);
      if (pictures.size() == before) continue;
      shown.push_back(name);
      break;
    }
  }
  return pictures;
}

}  // namespace rasterproof::tool
