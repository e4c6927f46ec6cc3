// Writes the page of a made-up bench and certificate: what tests/tool/page_browser_test.py opens.
#include <string>

#include "io/output.h"
#include "report/page.h"
#include "tests/report/sample_bench.h"
#include "tests/report/sample_results.h"

int main(int, char** arguments) {
  rasterproof::report::Page page;
  page.title = "a report";
  page.certificates = {rasterproof::report::SampleCertificate()};
  page.bench = rasterproof::report::SampleBench();
  rasterproof::io::WriteFile(arguments[1], rasterproof::report::PageToHtml(page));
  return 0;
}
