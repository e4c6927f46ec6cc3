// Which file and function of two builds makes them draw differently.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_BLAME_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_BLAME_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lab/sweep/sweep_builds.h"
#include "lab/sweep/sweep_runner.h"

namespace rasterproof::lab {

struct SweepBlame {
  std::string file;      ///< exchanging its object alone changes a sample; empty: none is known
  std::string function;  ///< exchanging it alone does; empty: none is known
  std::string remark;    ///< why not more is known; empty if all is
};

/// Links parts of the build into the base, or into the base for the build's target: each file
/// alone, then each function of that file alone, compiled with -fno-inline.
///
/// Domain:     a build that draws one of these cases otherwise than the base.
SweepBlame Blame(SweepRunner& runner, const Choices& choices,
                 const std::vector<std::size_t>& cases);

/// Assembly whose global symbols a linker can exchange one by one: none stands in a group.
struct ExchangeableAssembly {
  std::string text;
  std::vector<std::string> functions;
  std::vector<std::string> objects;    ///< data
  std::vector<std::string> was_local;  ///< of both, those that only their own file saw
};

/// Local data becomes global, and with `with_local_functions` so do local functions.
ExchangeableAssembly MakeExchangeable(std::string_view assembly, bool with_local_functions);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_BLAME_H_
