// Encodes bytes as base64 text, and decodes such text (RFC 4648, chapter 4).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim {

std::string base64(std::string_view bytes);

/// Encodes bytes that arrive in pieces.
class Base64 {
 public:
  /// Returns an upper bound for the number of characters that encode `bytes` bytes.
  static constexpr std::size_t most(std::size_t bytes) { return (bytes + 2) / 3 * 4 + 4; }
  /// Writes to `to` all characters that are complete so far. Returns the end of the written text.
  char* put(char* to, std::string_view bytes);
  char* finish(char* to);

 private:
  char left_[3] = {};  ///< bytes of an incomplete group
  std::size_t left_size_ = 0;
};
/// Decodes base64, with or without padding. Throws InputError for invalid text.
std::string from_base64(std::string_view text);

}  // namespace robosim
