// The rule of who may include whom, as may_include.txt states it, and what breaks it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::structure {

/// The content of each file by its path from the checkout's root.
using Files = std::map<std::string, std::string>;

struct IncludeTable {
  std::vector<std::string> search;                        ///< folders, in this order
  std::map<std::string, std::vector<std::string>> rows;   ///< folder -> folders it may include
  std::map<std::string, std::vector<std::string>> alone;  ///< start of another's header -> folders that may
};

/// Throws InputError at a line that is no row.
IncludeTable read_include_table(const std::string& file, std::string_view text);

/// A sentence for each include that the table does not allow: the file and line, and what is allowed there.
std::vector<std::string> broken_rules(const IncludeTable& table, const Files& files);

/// The sources of a checkout: what ends in .h, .c, .cpp or .ino below hal, firmware, sim and tests.
Files read_sources(const std::string& root);

}  // namespace robosim::structure
