// rasterproof browser: opens the page that judges a GPU by WebGL2 or WebGPU.
#ifndef RASTERPROOF_TOOL_BROWSER_CMD_BROWSER_H_
#define RASTERPROOF_TOOL_BROWSER_CMD_BROWSER_H_

#include <optional>
#include <string>

namespace rasterproof::tool {

/// The name of the page as a file.
inline constexpr const char* kBrowserPage = "passport.html";

/// The page's file: installed beside the command, or as `./run web` built it.
///
/// Returns:    nothing if there is none.
std::optional<std::string> FindBrowserPage();

/// Prints the page's address, and opens it with xdg-open where there are that and a desktop.
///
/// Error:      InputError if the page is not there.
int RunBrowser();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_BROWSER_CMD_BROWSER_H_
