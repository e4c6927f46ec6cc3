// Shared code of the fuzz targets: it decodes bytes to a case, checks properties on it, and reports
// and aborts on a violation.
//
// A target binds its subjects and properties by name once, at its first input. Subjects whose bytes
// mean the same case share the decoding.
#ifndef RASTERPROOF_FUZZ_FUZZ_TARGET_H_
#define RASTERPROOF_FUZZ_FUZZ_TARGET_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/property.h"

namespace rasterproof::fuzz {

/// A property that must hold of a subject on every input.
struct Checked {
  std::string_view subject;   ///< "f32-direct", "mutant:ties-inclusive", "legal:snap-floor"
  std::string_view property;  ///< "CoverageEqualsTheModel"
};

/// The largest case that a target looks at. A larger one is passed over, and libFuzzer does not
/// keep its input: small targets first.
struct Limits {
  std::int64_t samples = 32 * 32;
  std::size_t triangles = 16;

  bool Admit(const Case& c) const;
};

/// The result of LLVMFuzzerTestOneInput.
inline constexpr int kLookedAt = 0;
inline constexpr int kPassedOver = -1;

/// A subject and the properties that are checked on it.
struct BoundSubject {
  Subject* subject = nullptr;
  std::vector<const props::Property*> properties;
  std::size_t slot = 0;  ///< of its first property; the others follow (fuzz/guidance.h)
};

/// Subjects to which the same bytes mean the same case.
struct Group {
  SubjectInfo info;  ///< the first subject's, used to decode
  std::vector<BoundSubject> subjects;
};

/// Subjects and properties, bound.
class Bound {
 public:
  /// Error:      aborts if a name is unknown.
  explicit Bound(std::span<const Checked> all, Limits limits = {});
  /// Binds a subject from outside this program and the named properties.
  Bound(std::unique_ptr<Subject> subject, std::span<const std::string_view> properties,
        Limits limits = {});

  /// Calls `look` with each group and the case that the bytes mean to it. A report shows this case
  /// if `look` fails.
  ///
  /// Domain:     any bytes; the decoder is total.
  /// Returns:    kPassedOver if every case is larger than the limits.
  int ForEachCase(std::span<const std::uint8_t> bytes,
                  const std::function<void(const Group&, const Case&)>& look) const;
  /// Checks every property.
  ///
  /// Error:      a violated property prints the case, its vertices in hex and the command that
  ///             shows it, and aborts.
  int PutToTheTest(std::span<const std::uint8_t> bytes) const;
  /// Checks one property of one subject, which a hash of the bytes chooses: each in its turn, and
  /// the same one each time that the bytes are replayed. Otherwise as PutToTheTest.
  int PutOneToTheTest(std::span<const std::uint8_t> bytes) const;

 private:
  int LookAt(const Group& group, std::span<const std::uint8_t> bytes,
             const std::function<void(const Group&, const Case&)>& look) const;
  void Bind(Subject& subject, const props::Property& property);

  Limits limits_;
  std::vector<std::unique_ptr<Subject>> subjects_;
  std::vector<Group> groups_;
  std::size_t slots_ = 0;
};

/// A built-in subject, a planted bug or a legal variant. Aborts if there is none of that name.
std::unique_ptr<Subject> SubjectNamed(std::string_view name);
/// The properties of the contract that the subject states, as far as they apply to it.
std::vector<std::string_view> ContractPropertiesOf(Subject& subject);
/// Aborts, and says why, if there is no such property or it does not apply to the subject.
void RequireApplies(Subject& subject, std::string_view property);

/// Judges the case by the properties of the bound subject, or by the one at an index. As
/// Bound::PutToTheTest. How far each error went is noted for libFuzzer.
void PutToTheTest(const BoundSubject& bound, const Case& c);
void PutToTheTest(const BoundSubject& bound, std::size_t index, const Case& c);

/// Prints what failed, with the case that is being looked at, and aborts.
[[noreturn]] void Fail(std::string_view what);

/// The case for a reader: its name, its target and its vertices in hex floats.
std::string TextOf(const Case& c);

}  // namespace rasterproof::fuzz

/// The entry that libFuzzer, AFL++'s driver and fuzz/replay_main.cc call.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif  // RASTERPROOF_FUZZ_FUZZ_TARGET_H_
