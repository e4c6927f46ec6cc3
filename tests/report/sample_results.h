// Results as a run would hand them to the report, small enough to read.
#ifndef RASTERPROOF_TESTS_REPORT_SAMPLE_RESULTS_H_
#define RASTERPROOF_TESTS_REPORT_SAMPLE_RESULTS_H_

#include "report/certificate.h"

namespace rasterproof::report {

/// One property of every outcome, one judged scene and one observed, one entry in every section.
Certificate SampleCertificate();

/// A property with this name and outcome; violated ones carry a counterexample and a witness.
PropertyResult SampleProperty(const std::string& name, Outcome outcome);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_TESTS_REPORT_SAMPLE_RESULTS_H_
