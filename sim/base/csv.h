// Tables of text in RFC 4180's format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim {

/// Returns a text as one field of a row, quoted only where necessary.
std::string csv_field(std::string_view text);

/// Splits a row that is one line into its fields; returns nothing if its quotes do not match.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

}  // namespace robosim
