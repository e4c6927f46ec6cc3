// The clause table, to read and as data.
#ifndef RASTERPROOF_TOOL_LIST_CLAUSES_H_
#define RASTERPROOF_TOOL_LIST_CLAUSES_H_

#include <string>

namespace rasterproof::tool {

/// Each specification with its clauses, a few lines each.
std::string ListClauses();

/// The same with all that the table holds, and the properties that enforce each clause.
std::string ClausesToJson();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LIST_CLAUSES_H_
