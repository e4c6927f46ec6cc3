// Fingerprints of a benchmark's contenders: records, pictures and words.
#ifndef RASTERPROOF_TOOL_BENCH_FINGERPRINTS_H_
#define RASTERPROOF_TOOL_BENCH_FINGERPRINTS_H_

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/contender.h"
#include "bench/fingerprint.h"
#include "core/bench_result.h"

namespace rasterproof::tool {

/// The bytes of a PNG file: what is drawn, left, beside what is exact by the method's own model, in
/// four colours. x grows to the right, y down.
///
/// Shape:      512 x 256.
std::string FingerprintPng(const bench::Fingerprint& print);

/// Adds the fingerprints of these steps to the result, of the first contender of every name, and
/// writes each as FOLDER/NAME-STEP.png unless there is no folder.
///
/// Domain:     contenders in the order of the result's methods; those that it lacks are added.
/// Returns:    a sentence for each one without a fingerprint: why.
std::vector<std::string> RunFingerprints(
    std::span<const std::unique_ptr<bench::Contender>> contenders,
    std::span<const bench::FingerprintStep> steps, const std::string& folder, BenchResult& result);

/// For people: the wrong places of each method at each step.
std::string FingerprintTable(const BenchResult& result);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_BENCH_FINGERPRINTS_H_
