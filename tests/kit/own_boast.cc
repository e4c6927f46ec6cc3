// A type of one's own that states what only methods of this project may, under the name BOAST.
#include <memory>

#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "kit/main.h"

struct Boast {
  static rasterproof::SubjectInfo Info() {
    rasterproof::SubjectInfo info;
    info.states_exact = true;
    info.proofs = {{"the direct form is never wrong", "edge_direct.g"}};
    return info;
  }

  void Draw(const rasterproof::Scene& scene, rasterproof::CoverageCounts& counts) {
    counts += rasterproof::exact::Coverage(scene, Info().profile);
  }
};

int main(int argc, char** argv) {
  return rasterproof::kit::Main(argc, argv, BOAST, [] {
    return std::unique_ptr<rasterproof::Subject>(
        std::make_unique<rasterproof::RasterizerSubject<Boast>>(BOAST));
  });
}
