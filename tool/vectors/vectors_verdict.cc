#include "tool/vectors/vectors_verdict.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sample_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "report/vectors_json.h"

namespace rasterproof::tool {
namespace {

using Samples = std::vector<std::size_t>;

std::string SamplePlace(const TestVector& vector, std::size_t sample) {
  return SampleText(sample, vector.scene.width, vector.pattern.samples());
}

std::string WhoRequires(const std::vector<std::string>& clauses) {
  return clauses.empty() ? "the stated model" : fmt::format("{}", fmt::join(clauses, ", "));
}

Samples Without(const Samples& all, const Samples& some) {
  Samples rest;
  std::ranges::set_difference(all, some, std::back_inserter(rest));
  return rest;
}

// Judges the vectors one by one.
class AnswersJudge {
 public:
  AnswersJudge(const io::VectorsFile& file, const VectorsDrawn& drawn, std::uint64_t shown)
      : header_(file.header), drawn_(drawn), shown_(shown) {}

  void Judge(std::size_t number, const TestVector& vector) {
    std::vector<const Samples*> covered;
    for (std::size_t t = 0; t < vector.triangles.size(); ++t) {
      const auto found = drawn_.triangles.find({number, t});
      covered.push_back(found == drawn_.triangles.end() ? nullptr : &found->second);
    }
    const auto missing = static_cast<std::uint64_t>(std::ranges::count(covered, nullptr));
    verdict_.missing += missing;
    if (missing == 0) ++verdict_.cases;
    if (missing != 0 && missing != covered.size()) ++verdict_.partly;
    const std::uint64_t before = verdict_.contradicted;
    for (std::size_t t = 0; t < covered.size(); ++t)
      if (covered[t] != nullptr) JudgeTriangle(vector, t, *covered[t]);
    const auto together = drawn_.together.find(number);
    for (const JointVector& joint : vector.joint) {
      if (together != drawn_.together.end()) {
        JudgeCount(vector, joint, CountBesideMust(vector, joint.sample, together->second));
      } else if (drawn_.in_one_call) {
        JudgeJoint(vector, joint, covered);
      }
    }
    if (verdict_.contradicted != before) ++verdict_.cases_contradicted;
  }
  VectorsVerdict Verdict() { return std::move(verdict_); }

 private:
  void Add(const std::string& text, const std::vector<std::string>& clauses) {
    if (verdict_.contradicted++ < shown_)
      verdict_.contradictions.push_back(text + ": " + WhoRequires(clauses));
  }

  void JudgeTriangle(const TestVector& vector, std::size_t t, const Samples& covered) {
    const TriangleVector& triangle = vector.triangles[t];
    const auto add = [&](const Samples& samples, std::string_view what) {
      for (const std::size_t s : samples) {
        Add(fmt::format("{} triangle {}, {}: {}", vector.name, t, SamplePlace(vector, s), what),
            header_.sample_clauses);
      }
    };
    add(Without(triangle.must, covered), "not covered, and must be");
    add(Without(Without(covered, triangle.must), triangle.may), "covered, and must not be");
  }

  void JudgeJoint(const TestVector& vector, const JointVector& joint,
                  const std::vector<const Samples*>& covered) {
    int count = 0;
    for (const std::size_t t : joint.triangles) {
      if (covered[t] == nullptr) return;
      count += std::ranges::binary_search(*covered[t], joint.sample) ? 1 : 0;
    }
    JudgeCount(vector, joint, count);
  }

  // How often the sample was counted beyond the triangles that must cover it.
  static int CountBesideMust(const TestVector& vector, std::size_t sample,
                             const std::vector<std::uint32_t>& together) {
    const auto must = std::ranges::count_if(vector.triangles, [&](const TriangleVector& triangle) {
      return std::ranges::binary_search(triangle.must, sample);
    });
    return static_cast<int>(together[sample]) - static_cast<int>(must);
  }

  void JudgeCount(const TestVector& vector, const JointVector& joint, int count) {
    ++verdict_.joint;
    if (std::ranges::count(joint.counts, count) != 0) return;
    Add(fmt::format("{} {}: {} of triangles {} cover it in one call, and {}", vector.name,
                    SamplePlace(vector, joint.sample), count, fmt::join(joint.triangles, ", "),
                    report::JointText(joint)),
        header_.joint_clauses);
  }

  const VectorsHeader& header_;
  const VectorsDrawn& drawn_;
  std::uint64_t shown_;
  VectorsVerdict verdict_;
};

}  // namespace

VectorsVerdict JudgeDrawn(const io::VectorsFile& file, const VectorsDrawn& drawn,
                          std::uint64_t shown) {
  AnswersJudge judge(file, drawn, shown);
  for (std::size_t v = 0; v < file.vectors.size(); ++v) judge.Judge(v, file.vectors[v]);
  return judge.Verdict();
}

}  // namespace rasterproof::tool
