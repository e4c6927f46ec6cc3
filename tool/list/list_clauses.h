// The clause table, to read and as data.
#ifndef RASTERPROOF_TOOL_LIST_LIST_CLAUSES_H_
#define RASTERPROOF_TOOL_LIST_LIST_CLAUSES_H_

#include <string>
#include <string_view>

namespace rasterproof::tool {

/// Each specification with its clauses, a few lines each. With a prefix only the clauses whose id,
/// or whose specification's title, begins with it, and the specifications that have some.
///
/// Error:      InputError if no clause does.
std::string ListClauses(std::string_view prefix = "");

/// The same with all that the table holds, and the properties that enforce each clause.
std::string ClausesToJson(std::string_view prefix = "");

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LIST_LIST_CLAUSES_H_
