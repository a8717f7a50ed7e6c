// Messages about unknown words: what was probably meant, and what is allowed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim {

/// Lists names: "d, oval and tight".
std::string all_of(const std::vector<std::string>& names);

/// Returns the candidate that differs least from `word`, if so few letters differ that it may be a slip, or
/// one that begins with it.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates);

/// Returns "did you mean oval? There are d, oval and tight".
std::string guess_and_list(const std::string& name, const std::vector<std::string>& candidates);
/// Returns "there is no map “ovla”; did you mean oval? There are d, oval and tight". `what`: "map", for
/// example.
std::string unknown_name(const std::string& what, const std::string& name,
                         const std::vector<std::string>& candidates);

}  // namespace robosim
