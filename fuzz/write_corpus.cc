// Writes seeds: write_corpus DIR makes DIR/NAME for every example of the code. scripts/fuzz_corpus
// keeps of them what each target needs.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "props/codec/codec.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_corpus DIR\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (const auto& example : rasterproof::props::CodecExamples()) {
    std::ofstream file(folder / example.name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(example.bytes.data()),
               static_cast<std::streamsize>(example.bytes.size()));
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", (folder / example.name).c_str());
      return 2;
    }
  }
  return 0;
}
