// rasterproof browser: its options.
#include "tool/browser/cmd_browser.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddBrowser(CLI::App* /*verb*/, const Invocation& /*call*/) { return RunBrowser; }

}  // namespace

extern constinit const Verb kBrowserVerb{"browser", VerbGroup::kEveryDay, 70,
                                         "Open the page that judges a GPU by WebGL2 or WebGPU",
                                         AddBrowser};

}  // namespace rasterproof::tool
