// What the documents name: paths of the repository, and links to each other.
#pragma once

#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// A sentence for each reference in these Markdown files that leads nowhere: a link to a file or heading that
/// does not exist, or a path below the repository's folders (`sim/base/error.h`) that does not. Web addresses
/// are not looked at. `root` is the checkout's.
std::vector<std::string> dead_references(const Files& documents, const std::string& root);

/// The same for functions of ours, `read_map()` or `Floor::coverage()`, that these files name and no source
/// has.
std::vector<std::string> dead_functions(const Files& documents, const Files& sources);

/// The same for the documents that sources name: docs/reference/maps.md.
std::vector<std::string> dead_mentions(const Files& sources, const std::string& root);

/// The Markdown files of a checkout: those of its root and below docs.
Files read_documents(const std::string& root);

/// The anchor that GitHub gives a heading: "The table (`--csv`)" has "the-table---csv".
std::string anchor_of(const std::string& heading);

}  // namespace robosim::structure
