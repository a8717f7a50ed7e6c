// Checks #include directives against may_include.txt, which lists the folders that each folder may include.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::structure {

/// The contents of files. The keys are paths from the checkout's root.
using Files = std::map<std::string, std::string>;

struct IncludeTable {
  std::vector<std::string> search;                        ///< folders, in the order of the search
  std::map<std::string, std::vector<std::string>> rows;   ///< folders that each folder may include
  std::map<std::string, std::vector<std::string>> alone;  ///< for each beginning of a header's name: the
                                                          ///< only folders that may include such headers
};

/// Reads the table. Throws InputError at a line that is not a row.
IncludeTable read_include_table(const std::string& file, std::string_view text);

/// Returns a message for each include that the table does not allow. The message names the file, the line and
/// the allowed folders.
std::vector<std::string> broken_rules(const IncludeTable& table, const Files& files);

/// Returns a message for each file that declares or defines something in a foreign namespace. A namespace
/// below robosim belongs to the folder in which most files open it. It is foreign to a file that may not
/// include this folder.
std::vector<std::string> foreign_namespaces(const IncludeTable& table, const Files& files);

/// Returns each cycle of files that include each other, as "a.h > b.h > a.h".
std::vector<std::string> include_cycles(const IncludeTable& table, const Files& files);

/// Returns a checkout's sources: .h, .c, .cpp and .ino files below hal, firmware, sim and tests.
Files read_sources(const std::string& root);

}  // namespace robosim::structure
