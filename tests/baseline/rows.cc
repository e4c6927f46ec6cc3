#include "tests/baseline/rows.h"

#include <bit>
#include <memory>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/verdict.h"
#include "fmt/format.h"
#include "tests/baseline/case_digest.h"
#include "tests/baseline/digest.h"
#include "tests/baseline/entry.h"

namespace rasterproof::baseline {
namespace {

constexpr std::string_view kNothing = "-";

// One line, whatever the text is.
std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\n') {
      escaped += "\\n";
    } else if (letter == '\t') {
      escaped += "\\t";
    } else if (letter == '\\') {
      escaped += "\\\\";
    } else {
      escaped += letter;
    }
  }
  return escaped.empty() ? std::string(kNothing) : escaped;
}

std::string StreamText(const Stream& stream) {
  if (stream.count == 0) return std::string(kNothing);
  return fmt::format("{}:{:016x}", stream.count, stream.digest.value());
}

std::string QueriesText(const Record& record) {
  std::string text;
  for (const auto& [name, stream] :
       {std::pair{"edges", record.edges}, std::pair{"steps", record.steps},
        std::pair{"barycentrics", record.barycentrics},
        std::pair{"interpolations", record.interpolations},
        std::pair{"distances", record.distances}}) {
    if (stream.count == 0) continue;
    text += fmt::format("{}{}:{}", text.empty() ? "" : " ", name, StreamText(stream));
  }
  return text.empty() ? std::string(kNothing) : text;
}

std::string WitnessText(const Verdict& verdict) {
  if (!verdict.witness) return std::string(kNothing);
  const auto& [triangle, edge, x, y, sample, observed, expected] = *verdict.witness;
  return fmt::format("triangle {} edge {} x {} y {} sample {} observed \"{}\" expected \"{}\"",
                     triangle, edge, x, y, sample, Escaped(observed), Escaped(expected));
}

std::string ComparedText(const Verdict& verdict) {
  if (verdict.compared == nullptr) return std::string(kNothing);
  Digest digest;
  Add(verdict.compared->observed, digest);
  Add(verdict.compared->expected, digest);
  return fmt::format("{:016x}", digest.value());
}

std::string VerdictText(const Tried& tried) {
  if (!tried.fault.empty()) {
    return fmt::format("FAULT\t0\t0\t0\t{}\t-\t-", Escaped(tried.fault));
  }
  const Verdict& verdict = tried.verdict;
  return fmt::format("{}\t{}\t{:x}\t{}\t{}\t{}\t{}", OutcomeName(verdict.outcome),
                     verdict.exercised, std::bit_cast<std::uint64_t>(verdict.worst_ratio),
                     verdict.not_judged, Escaped(verdict.message), WitnessText(verdict),
                     ComparedText(verdict));
}

std::string CaseRow(std::string_view key, const Case& c, Trials& trials) {
  const Tried tried = trials.Try(c);
  return fmt::format("{}\t{:016x}\t{}\t{}\t{}\t{}\n", key, CaseDigest(c), VerdictText(tried),
                     StreamText(tried.record.draws), StreamText(tried.record.calls),
                     QueriesText(tried.record));
}

// The rows of one seed, for a subject that no other case was shown to.
std::string SeedRows(const NamedSubject& subject, const std::string& property, std::uint64_t seed,
                     std::uint64_t cases) {
  Trials trials(subject.make(), property);
  std::string rows;
  for (std::uint64_t index = 0; index < cases; ++index) {
    const std::string key = fmt::format("{}\t{}\t{}", property, seed, index);
    try {
      rows += CaseRow(key, trials.Draw(seed, index), trials);
    } catch (const InputError& error) {
      // The subject takes no case of the property's: the next ones neither.
      return rows + fmt::format("{}\t-\tno case\t0\t0\t0\t{}\t-\t-\t-\t-\t-\n", key,
                                Escaped(error.what()));
    }
  }
  return rows;
}

std::string DigestRow(const std::string& property, const std::string& rows) {
  std::uint64_t count = 0;
  for (const char letter : rows) count += letter == '\n' ? 1 : 0;
  return fmt::format("{}\t{}\t{:016x}\n", property, count, Digest().Text(rows).value());
}

}  // namespace

std::string HeaderRow(const DumpOptions& options) {
  if (options.digests) return "property\trows\tdigest\n";
  return "property\tseed\tcase\tdrawn\toutcome\texercised\tratio\tnot_judged\tmessage\twitness\t"
         "compared\tdraws\tcalls\tqueries\n";
}

std::string PropertyRows(const NamedSubject& subject, const std::string& property,
                         const DumpOptions& options) {
  if (!subject.property.empty() && subject.property != property) return "";
  std::string rows;
  for (const std::uint64_t seed : options.seeds) {
    rows += SeedRows(subject, property, seed, subject.is_bug ? options.bug_cases : options.cases);
  }
  return options.digests ? DigestRow(property, rows) : rows;
}

}  // namespace rasterproof::baseline
