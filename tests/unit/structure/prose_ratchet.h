// Counts findings of the rules of prose by rule and area. The numbers of prose_ratchet.txt are upper limits
// of these counts.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

using RuleAndArea = std::pair<std::string, std::string>;
/// Messages by rule and area.
using Findings = std::map<RuleAndArea, std::vector<std::string>>;
using Ratchet = std::map<RuleAndArea, std::size_t>;

/// Returns the area of a file: its first two folders, "docs/howto"; or its name if it is in no folder.
std::string area_of(const std::string& path);

/// Adds what breaks the rules in documents, sources (with messages below sim, hal and firmware) and scripts.
void check_documents(const Files& documents, Findings& findings);
void check_sources(const Files& sources, Findings& findings);
void check_scripts(const Files& scripts, Findings& findings);
void check_names(const Files& files, Findings& findings);
void check_subjects(const std::vector<std::string>& subjects, Findings& findings);

/// Reads lines of a rule, an area and a number. `#` starts a comment. Throws InputError.
Ratchet read_ratchet(const std::string& file, std::string_view text);
std::string ratchet_text(const Findings& findings);

struct Comparison {
  std::vector<std::string> risen;   ///< a message for each number that has risen, with the findings
  std::vector<std::string> fallen;  ///< a message for each number that should be lowered
};
Comparison compare(const Findings& findings, const Ratchet& ratchet);

}  // namespace robosim::structure
