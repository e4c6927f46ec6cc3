#include "io/output.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>

#include "core/error.h"
#include "gtest/gtest.h"

namespace rasterproof::io {
namespace {

namespace fs = std::filesystem;

std::string MessageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(no error)";
}

std::ptrdiff_t FilesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

// A fresh folder for each test.
class OutputTest : public testing::Test {
 protected:
  OutputTest() {
    std::string name = testing::TempDir() + "/output_test.XXXXXX";
    folder_ = ::mkdtemp(name.data());
  }
  ~OutputTest() override { fs::remove_all(folder_); }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

// Standard output goes to `fd` while this lives.
class StandardOutputTo {
 public:
  explicit StandardOutputTo(int fd) : before_(::dup(STDOUT_FILENO)) {
    std::fflush(stdout);  // what the test program itself has said goes where it belongs
    ::dup2(fd, STDOUT_FILENO);
  }
  ~StandardOutputTo() {
    ::dup2(before_, STDOUT_FILENO);
    ::close(before_);
  }

 private:
  int before_;
};

TEST_F(OutputTest, WhatIsWrittenIsThere) {
  const std::string content("a\0b\n", 4);
  WriteFile(Path("new"), content);
  EXPECT_EQ(ReadFile(Path("new")), content);
  WriteFile(Path("new"), "");
  EXPECT_EQ(ReadFile(Path("new")), "");
  EXPECT_EQ(FilesIn(folder_), 1);
}

TEST_F(OutputTest, ModesAndLinksSurvive) {
  WriteFile(Path("file"), "old");
  fs::permissions(Path("file"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("file", Path("link"));
  WriteFile(Path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(Path("link")));
  EXPECT_EQ(ReadFile(Path("file")), "new");
  EXPECT_EQ(fs::status(Path("file")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

// A limit on the size of files stands in for a disk that fills up half way through.
TEST_F(OutputTest, AFullDiskLeavesTheOldFileAndNothingElse) {
  WriteFile(Path("file"), "old");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{4096, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = MessageOf([&] { WriteFile(Path("file"), std::string(100000, 'x')); });
  const std::string fresh = MessageOf([&] { WriteFile(Path("new"), std::string(100000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, Path("file") +
                         ": can't be written (File too large); make room there or choose another "
                         "place");
  EXPECT_NE(fresh, "(no error)");
  EXPECT_EQ(ReadFile(Path("file")), "old");
  EXPECT_EQ(FilesIn(folder_), 1);
}

TEST_F(OutputTest, AFileThatCouldNotBeWrittenIsToldBeforehand) {
  for (const std::string& path : {Path("new"), std::string("new"), std::string("-"), std::string(),
                                  std::string("/dev/null")}) {
    EXPECT_EQ(MessageOf([&] { RequireFileCanBe(path); }), "(no error)") << path;
  }
  EXPECT_EQ(FilesIn(folder_), 0);
  EXPECT_EQ(MessageOf([&] { RequireFileCanBe(folder_); }),
            MessageOf([&] { WriteFile(folder_, "x"); }));
  EXPECT_EQ(MessageOf([&] { RequireFileCanBe(Path("none/new")); }),
            MessageOf([&] { WriteFile(Path("none/new"), "x"); }));
  EXPECT_NE(MessageOf([&] { RequireFileCanBe(Path("none/new")); }), "(no error)");
}

// The pipe comes first and the devices only if it has survived: a writer that replaces what is no
// file would, run by root, replace the machine's own devices.
TEST_F(OutputTest, DevicesAndPipesAreWrittenDirectly) {
  ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
  const int both_ends = ::open(Path("pipe").c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(both_ends, 0);
  WriteFile(Path("pipe"), "content");
  ASSERT_TRUE(fs::is_fifo(Path("pipe")));
  std::array<char, 16> received{};
  EXPECT_EQ(::read(both_ends, received.data(), received.size()), 7);
  EXPECT_STREQ(received.data(), "content");
  ::close(both_ends);

  std::string long_one;
  std::thread reader([&] { long_one = ReadFile(Path("pipe")); });
  const std::string content(300000, 'y');  // more than a pipe holds
  WriteFile(Path("pipe"), content);
  reader.join();
  EXPECT_EQ(long_one, content);

  EXPECT_EQ(MessageOf([] { WriteFile("/dev/null", "x"); }), "(no error)");
  EXPECT_NE(MessageOf([] { WriteFile("/dev/full", "x"); })
                .find("/dev/full: can't be written (No "
                      "space left on device)"),
            std::string::npos);
}

TEST_F(OutputTest, PlacesThatCannotBeWrittenAreNamed) {
  const auto write = [](const std::string& path) {
    return MessageOf([&] { WriteFile(path, "x"); });
  };
  EXPECT_NE(write(folder_.string()).find("Is a directory"), std::string::npos);
  EXPECT_TRUE(write(Path("no/file")).starts_with(Path("no/file") + ": can't be written"));
  WriteFile(Path("file"), "x");
  EXPECT_NE(write(Path("file/below")).find("Not a directory"), std::string::npos);
  EXPECT_NE(MessageOf([&] { MakeFolder(Path("file")); }).find("can't be made a folder"),
            std::string::npos);
  EXPECT_NE(MessageOf([&] { MakeFolder(Path("file/below")); }), "(no error)");
  EXPECT_EQ(MessageOf([&] { MakeFolder(Path("a/b/c")); }), "(no error)");
  EXPECT_EQ(MessageOf([&] { MakeFolder(Path("a/b/c")); }), "(no error)");
  EXPECT_EQ(FilesIn(folder_), 2);
}

TEST_F(OutputTest, StandardOutputSaysWhenItIsFull) {
  const int full = ::open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  std::string message;
  {
    const StandardOutputTo redirected(full);
    message = MessageOf([] { WriteStandardOutput("1 2 3\n"); });
  }
  ::close(full);
  EXPECT_NE(message.find("standard output: can't be written (No space left"), std::string::npos)
      << message;
}

TEST_F(OutputTest, StandardOutputThatNobodyReadsAnyMoreIsNoError) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  ::close(pipe[0]);
  std::string message;
  {
    const StandardOutputTo redirected(pipe[1]);
    message = MessageOf([] { WriteStandardOutput("1 2 3\n"); });
  }
  ::close(pipe[1]);
  EXPECT_EQ(message, "(no error)");
}

TEST_F(OutputTest, StandardOutputIsWrittenWhole) {
  const std::string content(1 << 20, 'z');
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  std::size_t received = 0;
  std::thread reader([&] {
    std::array<char, 1000> block{};
    for (ssize_t n = 0; (n = ::read(pipe[0], block.data(), block.size())) > 0;) {
      received += static_cast<std::size_t>(n);
    }
  });
  {
    const StandardOutputTo redirected(pipe[1]);
    WriteStandardOutput(content);
  }
  ::close(pipe[1]);
  reader.join();
  ::close(pipe[0]);
  EXPECT_EQ(received, content.size());
}

TEST_F(OutputTest, HugeFilesAreRefusedUnread) {
  WriteFile(Path("huge"), "x");
  fs::resize_file(Path("huge"), (std::uintmax_t{1} << 30) + 1);
  EXPECT_NE(MessageOf([&] { ReadFile(Path("huge")); }).find("huge: is larger than 1 GiB"),
            std::string::npos);
}

TEST_F(OutputTest, APipeThatNobodyWritesIntoIsRefused) {
  ASSERT_EQ(::mkfifo(Path("idle").c_str(), 0600), 0);
  EXPECT_EQ(MessageOf([&] { ReadFile(Path("idle")); }),
            Path("idle") + ": is a pipe that nobody writes into; start its writer, or give a file");
}

TEST_F(OutputTest, APipeIsReadToItsEndHoweverSlowItsWriter) {
  ASSERT_EQ(::mkfifo(Path("slow").c_str(), 0600), 0);
  std::thread writer([&] {
    const int pipe = ::open(Path("slow").c_str(), O_WRONLY);
    for (const std::string text : {"first ", "second"}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      EXPECT_EQ(::write(pipe, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    ::close(pipe);
  });
  EXPECT_EQ(ReadFile(Path("slow")), "first second");
  writer.join();
}

TEST_F(OutputTest, ADeviceIsRefusedBeforeItIsRead) {
  fs::create_symlink("/dev/zero", Path("endless.json"));
  EXPECT_EQ(MessageOf([&] { ReadFile(Path("endless.json")); }),
            Path("endless.json") + ": is a device; give a file");
}

}  // namespace
}  // namespace rasterproof::io
