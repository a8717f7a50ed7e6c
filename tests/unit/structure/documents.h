// Checks references in documents: paths of the repository, functions, and links between documents.
#pragma once

#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// Returns a message for each dead reference in Markdown files: a link to a missing file or heading, or a
/// missing path such as `sim/base/error.h`. Web addresses are not checked. `root` is the checkout's path.
std::vector<std::string> dead_references(const Files& documents, const std::string& root);

/// Returns a message for each function that these files name but no source has, such as `read_map()` or
/// `Floor::coverage()`.
std::vector<std::string> dead_functions(const Files& documents, const Files& sources);

/// Returns a message for each missing document that sources name, such as docs/reference/maps.md.
std::vector<std::string> dead_mentions(const Files& sources, const std::string& root);

/// Returns the Markdown files in a checkout's root and below docs.
Files read_documents(const std::string& root);

/// Returns GitHub's anchor of a heading: "the-table---csv" for "The table (`--csv`)".
std::string anchor_of(const std::string& heading);

}  // namespace robosim::structure
