// A word that is none of those allowed: what was probably meant, and what there is.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim {

/// "d, oval and tight"
std::string all_of(const std::vector<std::string>& names);

/// The candidate that differs least from `word`, if so few letters differ that it may be a slip, or that it
/// is the beginning of.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates);

/// "did you mean oval? There are d, oval and tight"
std::string guess_and_list(const std::string& name, const std::vector<std::string>& candidates);
/// "there is no map “ovla”; did you mean oval? There are d, oval and tight". `what` as in "map".
std::string unknown_name(const std::string& what, const std::string& name,
                         const std::vector<std::string>& candidates);

}  // namespace robosim
