// Checks #include directives against may_include.txt, which lists the folders that each folder may include.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::structure {

/// The content of each file, by its path from the checkout's root.
using Files = std::map<std::string, std::string>;

struct IncludeTable {
  std::vector<std::string> search;                        ///< in order
  std::map<std::string, std::vector<std::string>> rows;   ///< by folder: the folders that it may include
  std::map<std::string, std::vector<std::string>> alone;  ///< by start of a header: folders that may include
                                                          ///< it
};

/// Reads the table. Throws InputError at a line that is not a row.
IncludeTable read_include_table(const std::string& file, std::string_view text);

/// Returns a message for each include that the table does not allow: file, line, and the allowed folders.
std::vector<std::string> broken_rules(const IncludeTable& table, const Files& files);

/// Returns a checkout's sources: .h, .c, .cpp and .ino files below hal, firmware, sim and tests.
Files read_sources(const std::string& root);

}  // namespace robosim::structure
