// Writes the seed corpora: write_corpus DIR makes DIR/TARGET/NAME for every target and every
// example of the code.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "props/codec/codec.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_corpus DIR\n");
    return 2;
  }
  for (const char* target : {"edge_sign", "shared_edge", "barycentrics", "incremental"}) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / target;
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
  }
  return 0;
}
