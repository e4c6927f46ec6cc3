// Answers: written on the far side, read on this one.
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/quoted.h"
#include "core/shown_outputs.h"
#include "subjects/process/npy.h"
#include "subjects/process/protocol.h"
#include "subjects/process/text.h"

namespace rasterproof::subjects {
namespace {

// Of the lines of a right answer: room for blanks and for programs that pad.
constexpr std::size_t kRoomOfANumber = 64;
constexpr std::size_t kMostOfAHead = std::size_t{1} << 16;  // a reason may be a long text
constexpr std::size_t kNumbersOfAFragment = 8;  // primitive id, barycentrics, depth, centroid
constexpr std::size_t kNumbersOfAValue = 3;     // with its derivatives
constexpr std::size_t kMostQuoted = 60;

constexpr std::size_t MostOfARow(std::size_t numbers) { return (numbers + 1) * kRoomOfANumber; }

bool IsOfFragments(Outputs answered) {
  return answered.barycentrics || answered.depths || answered.centroids || answered.values;
}

std::string_view AnswerWord(Outputs answered) {
  if (!answered.primitive_ids) return "counts";
  return IsOfFragments(answered) ? "fragments" : "primitive-ids";
}

// What follows `WORD ID` on the line if it begins so.
std::optional<std::string_view> AfterHead(std::string_view line, std::string_view word,
                                          std::uint64_t id) {
  const std::string head = std::string(word) + " " + std::to_string(id);
  if (!line.starts_with(head)) return std::nullopt;
  line.remove_prefix(head.size());
  if (line.empty()) return line;
  if (line.front() != ' ' && line.front() != '\r') return std::nullopt;
  return line.substr(1);
}

// Whether the line begins the answer to some request.
bool BeginsAnswer(std::string_view line) {
  for (const std::string_view word :
       {"counts ", "primitive-ids ", "fragments ", "values ", "fault ", "refused ", "no-memory "}) {
    std::uint64_t id = 0;
    if (line.starts_with(word) && WordReader(line.substr(word.size())).Number(id)) return id != 0;
  }
  return false;
}

// Returns what follows the head of an answer's first line.
std::string_view RequireHead(std::string_view line, std::string_view word, std::uint64_t id,
                             const std::string& subject) {
  if (const auto rest = AfterHead(line, word, id)) return *rest;
  if (const auto reason = AfterHead(line, "fault", id)) BreakDown(std::string(*reason));
  if (const auto reason = AfterHead(line, "no-memory", id)) {
    throw SubjectStop(Stop::kOutOfMemory, std::string(*reason));
  }
  if (const auto reason = AfterHead(line, "refused", id)) {
    const InputError refusal("subject " + subject, "it refused the scene: " + std::string(*reason),
                             "give it another one");
    throw SubjectStop(Stop::kRefused, refusal.what());
  }
  if (id == 1 && !line.empty() && !BeginsAnswer(line)) {
    throw SubjectDoesNotRun(
        subject,
        "its first line is " + Quoted(line, kMostQuoted) + ", not \"" + std::string(word) + " 1\"",
        "write only answers to standard output; greetings and logs go to standard error");
  }
  BreakDown("it answered " + Quoted(line, kMostQuoted) + ", not \"" + std::string(word) + " " +
            std::to_string(id) + "\" (was a line left over from an earlier answer?)");
}

// The numbers of one line of an answer, and where it goes wrong.
class RowReader {
 public:
  explicit RowReader(std::string_view line) : line_(line), words_(line) {}

  template <class T>
  T Next(std::size_t read, std::size_t wanted) {
    T value{};
    if (words_.Number(value)) return value;
    BreakDown("a row of its answer has " + std::to_string(read) + " samples, not " +
              std::to_string(wanted) + Shown());
  }
  void RequireEnd(std::size_t wanted) {
    if (words_.AtEnd()) return;
    BreakDown("a row of its answer has more than " + std::to_string(wanted) + " samples" + Shown());
  }

 private:
  std::string Shown() const { return ": " + Quoted(line_, kMostQuoted); }

  std::string_view line_;
  WordReader words_;
};

// Reads HEIGHT rows; take(row, index, column, columns) reads one sample from the row.
template <class Take>
void ReadRows(const CoverageCounts& shape, std::size_t numbers, const NextLine& next_line,
              const Take& take) {
  const auto columns = shape.size() / static_cast<std::size_t>(shape.height);
  for (std::size_t at = 0; at < shape.size(); at += columns) {
    RowReader row(next_line(MostOfARow(columns * numbers)));
    for (std::size_t k = 0; k < columns; ++k) take(row, at + k, k, columns);
    row.RequireEnd(columns);
  }
}

// A row of counts that are all 0, as nearly all rows of a large target: it is written and read as a
// whole.
std::string ZerosOf(std::size_t columns) {
  std::string zeros(2 * columns - 1, ' ');
  for (std::size_t k = 0; k < zeros.size(); k += 2) zeros[k] = '0';
  return zeros;
}

// Counts onto zeros.
void ReadCounts(const CoverageCounts& shape, std::vector<std::uint32_t>& side,
                const NextLine& next_line) {
  const auto columns = shape.size() / static_cast<std::size_t>(shape.height);
  const std::string zeros = ZerosOf(columns);
  for (std::size_t at = 0; at < shape.size(); at += columns) {
    const std::string_view line = next_line(MostOfARow(columns));
    if (line == zeros) continue;
    RowReader row(line);
    for (std::size_t k = 0; k < columns; ++k) {
      side[at + k] = row.Next<std::uint32_t>(k, columns);
    }
    row.RequireEnd(columns);
  }
}

// The shapes that an array of these counts may have, of each facing if there are several.
std::vector<std::vector<std::size_t>> ShapesOf(const CoverageCounts& shape, bool has_facings) {
  const auto height = static_cast<std::size_t>(shape.height);
  const auto width = static_cast<std::size_t>(shape.width);
  const auto samples = static_cast<std::size_t>(shape.samples);
  std::vector<std::vector<std::size_t>> shapes{{height, width * samples}, {height, width, samples}};
  if (has_facings) {
    for (std::vector<std::size_t>& sides : shapes) sides.insert(sides.begin(), 2);
  }
  return shapes;
}

void ReadCountsArray(CoverageCounts& counts, bool has_facings, const NextBytes& next_bytes) {
  const std::vector<std::int64_t> numbers =
      ReadNpyIntegers(ShapesOf(counts, has_facings), next_bytes);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] < 0 || numbers[k] > std::numeric_limits<std::uint32_t>::max()) {
      BreakDown("its answer counts " + std::to_string(numbers[k]) + " triangles at a sample");
    }
    auto& side = k < counts.size() ? counts.front : counts.back;
    side[k % counts.size()] = static_cast<std::uint32_t>(numbers[k]);
  }
}

void RequirePrimitiveId(std::int64_t id, std::size_t triangles) {
  if (id >= kNoPrimitive && id < static_cast<std::int64_t>(triangles)) return;
  BreakDown("it names triangle " + std::to_string(id) + " as visible at a sample, in a scene of " +
            std::to_string(triangles) + " triangles");
}

void ReadPrimitiveIdsArray(Drawing& drawing, std::size_t triangles, const NextBytes& next_bytes) {
  const std::vector<std::int64_t> ids =
      ReadNpyIntegers(ShapesOf(drawing.counts, false), next_bytes);
  drawing.primitive_ids.resize(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    RequirePrimitiveId(ids[k], triangles);
    drawing.primitive_ids[k] = static_cast<std::int32_t>(ids[k]);
    if (ids[k] != kNoPrimitive) drawing.counts.front[k] = 1;
  }
}

std::array<double, 3> NextBarycentrics(RowReader& row, std::size_t column, std::size_t columns) {
  std::array<double, 3> barycentrics{};
  for (double& barycentric : barycentrics) barycentric = row.Next<double>(column, columns);
  return barycentrics;
}

// `answered` is what the answer holds, the job's wants what of it is kept.
void ReadPrimitiveIds(Drawing& drawing, const DrawJob& job, Outputs answered,
                      const NextLine& next_line) {
  const std::size_t size = drawing.counts.size();
  const std::size_t channels = answered.values ? job.scene->channels.size() : 0;
  const std::size_t triangles = job.Triangles().size();
  const Outputs& wants = job.wants;
  drawing.primitive_ids.resize(size);
  if (answered.barycentrics && wants.barycentrics) drawing.barycentrics.resize(size);
  if (answered.depths && wants.depths) drawing.depths.resize(size);
  if (answered.centroids) drawing.centroids.resize(size);
  drawing.values.resize(size * channels);
  if (answered.derivatives) drawing.derivatives.resize(size * channels);
  const auto read = [&](RowReader& row, std::size_t index, std::size_t column,
                        std::size_t columns) {
    const auto id = row.Next<std::int32_t>(column, columns);
    RequirePrimitiveId(id, triangles);
    drawing.primitive_ids[index] = id;
    if (id == kNoPrimitive) return;
    drawing.counts.front[index] = 1;
    if (answered.barycentrics) {
      const std::array<double, 3> barycentrics = NextBarycentrics(row, column, columns);
      if (!drawing.barycentrics.empty()) drawing.barycentrics[index] = barycentrics;
    }
    if (answered.depths) {
      const auto depth = row.Next<double>(column, columns);
      if (!drawing.depths.empty()) drawing.depths[index] = depth;
    }
    if (answered.centroids) drawing.centroids[index] = NextBarycentrics(row, column, columns);
    for (std::size_t c = channels * index; c < channels * (index + 1); ++c) {
      drawing.values[c] = row.Next<double>(column, columns);
      if (!answered.derivatives) continue;
      for (double& along : drawing.derivatives[c]) along = row.Next<double>(column, columns);
    }
  };
  const std::size_t numbers = kNumbersOfAFragment + kNumbersOfAValue * channels;
  ReadRows(drawing.counts, IsOfFragments(answered) ? numbers : 1, next_line, read);
}

// HEIGHT rows; add(index) writes one sample.
template <class Add>
void AddRows(TextWriter& text, const CoverageCounts& shape, const Add& add) {
  const auto columns = shape.size() / static_cast<std::size_t>(shape.height);
  for (std::size_t at = 0; at < shape.size(); at += columns) {
    for (std::size_t k = 0; k < columns; ++k) {
      if (k != 0) text.Add(' ');
      add(at + k);
    }
    text.Add('\n');
  }
}

void AddCounts(TextWriter& text, const CoverageCounts& shape,
               const std::vector<std::uint32_t>& side) {
  const auto columns = shape.size() / static_cast<std::size_t>(shape.height);
  const std::string zeros = ZerosOf(columns) + '\n';
  for (std::size_t at = 0; at < shape.size(); at += columns) {
    const std::span<const std::uint32_t> row(side.data() + at, columns);
    if (std::ranges::all_of(row, [](std::uint32_t count) { return count == 0; })) {
      text.Add(zeros);
      continue;
    }
    for (const std::uint32_t& count : row) {
      if (&count != row.data()) text.Add(' ');
      text.AddNumber(count);
    }
    text.Add('\n');
  }
}

void AddNumbers(TextWriter& text, std::span<const double> numbers) {
  for (const double number : numbers) {
    text.Add(' ');
    text.AddNumber(number);
  }
}

void AddPrimitiveIds(TextWriter& text, const Drawing& drawing, Outputs answered) {
  const std::size_t channels = drawing.values.size() / drawing.counts.size();
  AddRows(text, drawing.counts, [&](std::size_t k) {
    text.AddNumber(drawing.primitive_ids[k]);
    if (drawing.primitive_ids[k] == kNoPrimitive) return;
    if (answered.barycentrics) AddNumbers(text, drawing.barycentrics[k]);
    if (answered.depths) AddNumbers(text, {&drawing.depths[k], 1});
    if (answered.centroids) AddNumbers(text, drawing.centroids[k]);
    if (!answered.values) return;
    for (std::size_t c = channels * k; c < channels * (k + 1); ++c) {
      AddNumbers(text, {&drawing.values[c], 1});
      if (answered.derivatives) AddNumbers(text, drawing.derivatives[c]);
    }
  });
}

}  // namespace

Outputs Requested(const DrawJob& job, const SubjectInfo& info) {
  return info.takes_wants ? ShownOutputs(job, info) : kEverything;
}

Outputs Answered(CoverageKind kind, Outputs wants) {
  const bool shows_fragments = kind == CoverageKind::kFragments;
  const bool shows_primitive_ids = kind == CoverageKind::kPrimitiveIds || shows_fragments;
  return {.primitive_ids = shows_primitive_ids && wants != kCoverageAlone,
          .barycentrics = shows_fragments && wants.barycentrics,
          .depths = shows_fragments && wants.depths,
          .centroids = shows_fragments && wants.centroids,
          .values = shows_fragments && wants.values,
          .derivatives = shows_fragments && wants.derivatives};
}

std::string AnswerText(std::uint64_t id, const Drawing& drawing, CoverageKind kind, Outputs wants) {
  const Outputs answered = Answered(kind, wants);
  TextWriter text;
  text.Add(AnswerWord(answered));
  text.Add(' ');
  text.AddNumber(id);
  text.Add('\n');
  const CoverageCounts& counts = drawing.counts;
  if (answered.primitive_ids) {
    AddPrimitiveIds(text, drawing, answered);
    return text.Take();
  }
  AddCounts(text, counts, counts.front);
  if (kind == CoverageKind::kFacingCounts) AddCounts(text, counts, counts.back);
  return text.Take();
}

Drawing ReadAnswer(std::uint64_t id, const DrawJob& job, const SubjectInfo& info,
                   const NextLine& next_line, const NextBytes& next_bytes) {
  const Outputs answered = Answered(info.coverage, Requested(job, info));
  const bool has_facings = info.coverage == CoverageKind::kFacingCounts;
  WordReader rest(RequireHead(next_line(kMostOfAHead), AnswerWord(answered), id, info.name));
  const bool is_array = rest.Word() == "npy";
  Drawing drawing;
  drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  if (is_array && IsOfFragments(answered))
    BreakDown("it gives fragments as an array; only counts and primitive ids can be one");
  if (answered.primitive_ids) {
    if (is_array) {
      ReadPrimitiveIdsArray(drawing, job.Triangles().size(), next_bytes);
    } else {
      ReadPrimitiveIds(drawing, job, answered, next_line);
    }
    return drawing;
  }
  if (is_array) {
    ReadCountsArray(drawing.counts, has_facings, next_bytes);
    return drawing;
  }
  ReadCounts(drawing.counts, drawing.counts.front, next_line);
  if (has_facings) {
    ReadCounts(drawing.counts, drawing.counts.back, next_line);
  }
  return drawing;
}

std::string ValuesText(std::uint64_t id, std::span<const double> values) {
  TextWriter text;
  text.Add("values ");
  text.AddNumber(id);
  for (const double value : values) {
    text.Add(' ');
    text.AddNumber(value);
  }
  text.Add('\n');
  return text.Take();
}

std::vector<double> ReadValues(const EdgeRequest& request, const std::string& subject,
                               const NextLine& next_line) {
  const std::size_t most = kMostOfAHead + MostOfARow(request.Values());
  RowReader row(RequireHead(next_line(most), "values", request.id, subject));
  std::vector<double> values(request.Values());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = row.Next<double>(k, values.size());
  row.RequireEnd(values.size());
  return values;
}

}  // namespace rasterproof::subjects
