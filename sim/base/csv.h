// Tables of text as RFC 4180 has them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim {

/// A text as one field of a row; in quotes only where it must be.
std::string csv_field(std::string_view text);

/// The fields of a row that is one line; nothing if its quotes do not match.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

}  // namespace robosim
