// Tables of documents that tests make: what stands between two comments is what the test says.
#ifndef RASTERPROOF_TESTS_REFERENCE_DOCUMENT_BLOCK_H_
#define RASTERPROOF_TESTS_REFERENCE_DOCUMENT_BLOCK_H_

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace rasterproof::reference::witness {

/// Expects the document to have `table` between "<!-- name, made by ... -->" and
/// "<!-- name: to here -->". With RASTERPROOF_TABLES set it prints the table for
/// scripts/bound_tables instead.
inline void ExpectBlock(const std::string& document, const std::string& name,
                        const std::string& table) {
  if (std::getenv("RASTERPROOF_TABLES") != nullptr) {
    std::cout << "<!-- " << name << " -->\n" << table << "<!-- end -->\n";
    return;
  }
  std::ifstream file(document);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t comment = text.find("<!-- " + name + ", made by ");
  ASSERT_NE(comment, std::string::npos) << document << " has no block named " << name;
  const std::size_t begin = text.find('\n', comment) + 1;
  const std::size_t end = text.find("<!-- " + name + ": to here -->", begin);
  ASSERT_NE(end, std::string::npos) << document << ": the block " << name << " has no end";
  EXPECT_EQ(text.substr(begin, end - begin), table) << "run scripts/bound_tables";
}

}  // namespace rasterproof::reference::witness

#endif  // RASTERPROOF_TESTS_REFERENCE_DOCUMENT_BLOCK_H_
