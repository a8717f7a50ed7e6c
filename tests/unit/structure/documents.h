// Checks references in documents: paths in the repository, names of functions, and links between documents.
#pragma once

#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// Returns a message for each dead reference in Markdown files: a link to a missing file or heading, or a
/// missing path such as `sim/base/error.h`. Web addresses are not checked. `root` is the checkout's path.
std::vector<std::string> dead_references(const Files& documents, const std::string& root);

/// Returns a message for each function, such as `read_map()` or `Floor::coverage()`, that the documents name
/// but no source contains.
std::vector<std::string> dead_functions(const Files& documents, const Files& sources);

/// Returns a message for each test, such as `Explain.EveryVerdictIsASentenceOfItsOwn`, that the documents
/// name but no source contains.
std::vector<std::string> dead_tests(const Files& documents, const Files& sources);

/// Returns a message for each document, such as docs/reference/maps.md, that sources name but that is
/// missing.
std::vector<std::string> dead_mentions(const Files& sources, const std::string& root);

/// Reads the Markdown files in a checkout's root and below its folder docs.
Files read_documents(const std::string& root);

/// Returns the anchor that GitHub gives to a heading: "the-table---csv" for "The table (`--csv`)".
std::string anchor_of(const std::string& heading);

}  // namespace robosim::structure
