// Formats and parses rows of text in RFC 4180's format (CSV).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim {

/// Returns a text as one field of a row, quoted only where necessary.
std::string csv_field(std::string_view text);

/// Splits a row without line feeds into fields; returns nothing if a quote is not closed.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

}  // namespace robosim
