#include "sim/exec/elf/intel_hex.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "sim/base/error.h"

namespace robosim::exec {
namespace {

constexpr std::size_t kHeadBytes = 4, kSumBytes = 1;
constexpr const char* kNotALine = "expected a line of an Intel HEX file";
enum Kind : unsigned { kData = 0, kEnd = 1, kSegment = 2, kStartSegment = 3, kUpper = 4, kStart = 5 };

/// Returns the bytes of a line; empty if the line is not valid Intel HEX.
std::vector<std::uint8_t> bytes_of(std::string_view line) {
  if (line.empty() || line[0] != ':' || line.size() % 2 == 0) return {};
  std::vector<std::uint8_t> bytes;
  unsigned sum = 0;
  for (std::size_t at = 1; at < line.size(); at += 2) {
    std::uint8_t byte = 0;
    const char* const end = line.data() + at + 2;
    if (std::from_chars(line.data() + at, end, byte, 16).ptr != end) return {};
    bytes.push_back(byte);
    sum += byte;
  }
  const bool whole =
      bytes.size() >= kHeadBytes + kSumBytes && bytes.size() == bytes[0] + kHeadBytes + kSumBytes;
  return whole && sum % 256 == 0 ? bytes : std::vector<std::uint8_t>{};
}

}  // namespace

std::vector<std::uint8_t> read_intel_hex(std::string_view text, const std::string& file, std::size_t room,
                                         std::size_t flash_bytes) {
  std::vector<std::uint8_t> flash;
  std::size_t base = 0;
  int number = 0;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.empty()) continue;
    const std::vector<std::uint8_t> bytes = bytes_of(line);
    if (bytes.empty()) throw InputError({file, number, 0}, kNotALine);
    const unsigned value = bytes.size() >= kHeadBytes + 2 ? bytes[4] << 8 | bytes[5] : 0;
    switch (bytes[3]) {
      case kData: {
        const std::size_t at = base + (bytes[1] << 8 | bytes[2]), end = at + bytes[0];
        if (end > flash_bytes)
          throw InputError(
              {file, number, 0},
              fmt::format("data beyond the end of the chip's flash: expected at most {} bytes", flash_bytes));
        if (at >= room) break;
        if (end > room) {
          throw InputError(
              {file, number, 0},
              fmt::format("data beyond the end of the board's flash for a sketch: expected at most {} bytes",
                          room));
        }
        if (flash.size() < end) flash.resize(end, 0xFF);
        std::copy_n(bytes.begin() + kHeadBytes, bytes[0], flash.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      }
      case kEnd:
        return flash;
      case kSegment:
        base = std::size_t{value} << 4;
        break;
      case kUpper:
        base = std::size_t{value} << 16;
        break;
      case kStartSegment:
      case kStart:
        break;
      default:
        throw InputError({file, number, 0}, kNotALine);
    }
  }
  throw InputError({file}, "the Intel HEX file is incomplete: expected the line :00000001FF at its end");
}

}  // namespace robosim::exec
