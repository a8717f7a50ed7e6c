// Formats messages about unknown words: the probable correction, and the allowed words.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim {

/// Lists names: "d, oval and tight".
std::string all_of(const std::vector<std::string>& names);

/// Returns the candidate that differs least from `word`. The candidate must differ in few letters, as after a
/// typing error, or start with `word`. A candidate such as "laps:N" stands for laps with any parameter:
/// "lap:3" gives "laps:3".
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates);

/// Returns "; did you mean oval?", or nothing if no candidate is close.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);
/// Returns "expected oval or tight, got “ovla”; did you mean oval?".
std::string expected_one_of(const std::string& word, const std::vector<std::string>& allowed);

/// Returns "did you mean oval? There are d, oval and tight".
std::string guess_and_list(const std::string& name, const std::vector<std::string>& candidates);
/// Returns "there is no map “ovla”; did you mean oval? There are d, oval and tight". `what` is a noun such as
/// "map".
std::string unknown_name(const std::string& what, const std::string& name,
                         const std::vector<std::string>& candidates);

}  // namespace robosim
