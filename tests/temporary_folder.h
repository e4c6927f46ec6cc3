// A fresh folder for a test, which goes when the test ends.
#ifndef RASTERPROOF_TESTS_TEMPORARY_FOLDER_H_
#define RASTERPROOF_TESTS_TEMPORARY_FOLDER_H_

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace rasterproof {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = testing::TempDir() + "/rasterproof_test.XXXXXX";
    const char* const made = ::mkdtemp(name.data());
    if (made == nullptr) throw std::filesystem::filesystem_error("mkdtemp", name, {});
    folder_ = made;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  const std::filesystem::path& path() const { return folder_; }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_TEMPORARY_FOLDER_H_
