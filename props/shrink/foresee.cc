#include "props/shrink/foresee.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

// All that shrinking changes, as bytes.
class CaseBytes {
 public:
  explicit CaseBytes(const Case& c) {
    const Scene& scene = c.scene;
    for (const int n : {scene.width, scene.height, scene.clip_space ? 1 : 0,
                        static_cast<int>(c.options.cull), c.options.tile, c.options.threads}) {
      Add(n);
    }
    const PixelRect whole{0, 0, -1, -1};
    const PixelRect& r = c.options.scissor ? *c.options.scissor : whole;
    for (const int n : {r.x0, r.y0, r.x1, r.y1}) Add(n);
    Add(scene.vertices.size());
    for (const Vertex& v : scene.vertices) {
      for (const double x : {v.x, v.y, v.z, v.w}) Add(x);
    }
    for (const Triangle& t : scene.triangles) Add(t);
  }
  std::string Take() { return std::move(bytes_); }

 private:
  template <class T>
  void Add(const T& value) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes_.append(raw.data(), raw.size());
  }

  std::string bytes_;
};

// What a step makes simpler. Steps of one kind fail about equally often.
enum class StepKind : std::uint8_t {
  kTriangles,
  kVertices,
  kTarget,
  kOptions,
  kAllCoordinates,
  kToZero,
  kCoordinate,
  kRepeated,  ///< what was tried before, when the case was larger, and did not fail
};
constexpr std::size_t kStepKinds = 8;

struct ShrinkStep {
  StepKind kind = StepKind::kOptions;
  std::string what;  ///< which one it is
};

ShrinkStep StepBetween(const Case& before, const Case& after) {
  const Scene& a = before.scene;
  const Scene& b = after.scene;
  const auto named = [](StepKind kind, auto... numbers) {
    ShrinkStep step{kind, std::to_string(static_cast<int>(kind))};
    ((step.what += " " + std::to_string(numbers)), ...);
    return step;
  };
  if (b.triangles.size() < a.triangles.size()) {
    return named(StepKind::kTriangles, BytesOf(after).size());
  }
  if (b.vertices.size() < a.vertices.size()) return named(StepKind::kVertices);
  if (b.width != a.width || b.height != a.height) {
    return named(StepKind::kTarget, b.width, b.height);
  }
  std::vector<ShrinkStep> changed;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    constexpr std::array kMembers{&Vertex::x, &Vertex::y, &Vertex::z, &Vertex::w};
    for (std::size_t m = 0; m < kMembers.size(); ++m) {
      const auto old_bits = std::bit_cast<std::uint64_t>(a.vertices[v].*kMembers[m]);
      const auto new_bits = std::bit_cast<std::uint64_t>(b.vertices[v].*kMembers[m]);
      if (old_bits == new_bits) continue;
      changed.push_back(
          named(new_bits == 0 ? StepKind::kToZero : StepKind::kCoordinate, v, m, new_bits));
    }
  }
  if (changed.empty()) return named(StepKind::kOptions);
  if (changed.size() == 1) return changed.front();
  return named(StepKind::kAllCoordinates);
}

// How often steps of each kind fail: some of experience, and what is known here.
class Experience {
 public:
  void Note(StepKind kind, bool fails) {
    Count& count = counts_[static_cast<std::size_t>(kind)];
    count.all += 1;
    if (fails) count.failed += 1;
  }
  double ShareOf(StepKind kind) const {
    const Count& count = counts_[static_cast<std::size_t>(kind)];
    return count.failed / count.all;
  }

 private:
  struct Count {
    double failed;
    double all;
  };
  std::array<Count, kStepKinds> counts_{
      {{3.5, 10}, {3, 10}, {4.5, 10}, {9, 10}, {4, 10}, {5.7, 10}, {1.9, 10}, {0.4, 10}}};
};

// The decisions about candidates of which nothing is known, in the order in which they come.
struct Course {
  double cost = 0;  ///< -log2 of its probability
  std::uint64_t number = 0;
  std::vector<bool> fails;

  friend bool operator<(const Course& a, const Course& b) {
    return std::pair(a.cost, a.number) > std::pair(b.cost, b.number);  // the cheapest comes first
  }
};

class Foreseeing {
 public:
  Foreseeing(const Case& failing, const KnownFailures& known, std::uint64_t budget)
      : failing_(failing), known_(known), budget_(budget), smallest_(failing) {}

  Case Run() {
    Follow({});
    while (!courses_.empty() && !is_full_ && followed_ < kMostCourses) {
      const Course course = courses_.top();
      courses_.pop();
      Follow(course);
    }
    return smallest_;
  }

 private:
  static constexpr std::uint64_t kMostCourses = 20'000;

  // Shrinks as if the candidates of which nothing is known failed as the course says, and on from
  // there as long as no other course is more probable.
  void Follow(Course course) {
    ++followed_;
    std::size_t next = 0;
    bool is_known_so_far = true;
    Case current = failing_;
    std::unordered_map<std::string, bool> supposed;
    std::unordered_set<std::string> rejected;
    const auto fails = [&](const Case& candidate) -> std::optional<bool> {
      const std::string bytes = BytesOf(candidate);
      ShrinkStep step = StepBetween(current, candidate);
      const StepKind kind = rejected.contains(step.what) ? StepKind::kRepeated : step.kind;
      const auto decide = [&](bool does_fail) {
        if (does_fail) {
          current = candidate;
        } else {
          rejected.insert(step.what);
        }
        return does_fail;
      };
      if (const auto known = Known(candidate, bytes, kind)) {
        if (decide(*known) && is_known_so_far) smallest_ = candidate;
        return known;
      }
      is_known_so_far = false;
      if (const auto it = supposed.find(bytes); it != supposed.end()) return decide(it->second);
      if (next == course.fails.size() && !Extend(course, candidate, bytes, kind)) {
        return std::nullopt;  // what this course was to show is asked for
      }
      const bool guess = course.fails[next++];
      supposed.emplace(bytes, guess);
      return decide(guess);
    };
    Shrink(failing_, fails, budget_);
  }

  std::optional<bool> Known(const Case& candidate, const std::string& bytes, StepKind kind) {
    const auto [it, is_new] = verdicts_.try_emplace(bytes);
    if (is_new) {
      it->second = known_.fails(candidate);
      if (it->second) experience_.Note(kind, *it->second);
    }
    return it->second;
  }

  // Asks for the candidate, goes on with the more probable answer and notes the other. Returns
  // whether it goes on: a course is left for a more probable one, and for good where there is no
  // room for more.
  bool Extend(Course& course, const Case& candidate, const std::string& bytes, StepKind kind) {
    if (wanted_.insert(bytes).second) is_full_ = !known_.want(candidate);
    if (is_full_) return false;
    const double share = experience_.ShareOf(kind);
    const bool guess = share > 0.5;
    Course other = course;
    other.number = ++numbered_;
    other.cost -= Log2(guess ? 1 - share : share);
    other.fails.push_back(!guess);
    course.cost -= Log2(guess ? share : 1 - share);
    course.fails.push_back(guess);
    courses_.push(std::move(other));
    if (course.cost <= courses_.top().cost) return true;
    course.number = ++numbered_;
    courses_.push(std::move(course));
    return false;
  }

  const Case& failing_;
  const KnownFailures& known_;
  std::uint64_t budget_;
  Case smallest_;
  bool is_full_ = false;
  std::uint64_t followed_ = 0;
  std::uint64_t numbered_ = 0;
  Experience experience_;
  std::unordered_map<std::string, std::optional<bool>> verdicts_;
  std::unordered_set<std::string> wanted_;
  std::priority_queue<Course> courses_;
};

}  // namespace

std::string BytesOf(const Case& c) { return CaseBytes(c).Take(); }

Case Foresee(const Case& failing, const KnownFailures& known, std::uint64_t budget) {
  return Foreseeing(failing, known, budget).Run();
}

}  // namespace rasterproof::props
