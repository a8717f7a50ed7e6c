// Bytes as text: RFC 4648, chapter 4.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

std::string base64(std::string_view bytes);
/// Throws InputError for any character that is not base64's.
std::string from_base64(std::string_view text);

}  // namespace robosim
