// The pictures of the report page: real scenes as they are, and what the naive methods made of
// them.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/image.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "report/picture.h"
#include "tool/certify.h"
#include "tool/failure.h"
#include "tool/session.h"

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
      reference::RasterizeFragments(measured.scene(), *method, {}, {.weights = true});
  pictures.push_back({measured.name() + ": barycentric weights of the nearest triangle",
                      fmt::format("rasterproof render {} --mode weights --output {}.png",
                                  measured.arguments(), measured.name()),
                      "", io::EncodePng(report::PaintWeights(fragments))});
}

// The first place at which the subject differs from the model on the scene, explained; nothing if
// it doesn't.
void PictureFailure(const std::string& name, MeasuredScene& measured,
                    std::vector<report::Picture>& pictures) {
  const std::unique_ptr<Subject> subject = MakeSubject(name);
  if (!Takes(subject->Info(), measured.scene())) return;
  std::string failure;
  const auto observed = DrawUnlessItFails(*subject, measured.scene(), {}, failure);
  if (!observed) return;  // told among the properties
  const CoverageDifference difference = Compare(*observed, measured.Truth(subject->Info().profile));
  if (difference.wrong == 0) return;
  Case c;
  c.scene = measured.scene();
  c.profile = subject->Info().profile;
  Verdict verdict;
  verdict.message =
      fmt::format("{} on {}: {} of {} samples wrong, {} gaps, {} overlaps", name, measured.name(),
                  difference.wrong, difference.samples, difference.gaps, difference.overlaps);
  const std::string replay =
      fmt::format("rasterproof explain {} --subject {}", measured.arguments(), name);
  const report::Explanation explanation = Explain(*subject, c, verdict, replay);
  pictures.push_back({explanation.headline, replay, report::ExplanationToSvg(explanation), ""});
}

}  // namespace

std::vector<report::Picture> TakePictures(std::vector<std::unique_ptr<MeasuredScene>>& scenes,
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
      PictureFailure(name, *measured, pictures);
      if (pictures.size() == before) continue;
      shown.push_back(name);
      break;
    }
  }
  return pictures;
}

}  // namespace rasterproof::tool
