// Reads Intel HEX, the text format for flash content. A line is `:` and bytes of two digits each: the number
// of data bytes, their 16-bit address, the record type, the data, and a checksum that makes the sum of all
// bytes 0.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::exec {

/// Returns the bytes from address 0 on, with 0xFF in gaps. Skips bytes from `room` on, since a
/// .with_bootloader.hex has its boot loader there. Throws InputError, which names `file` and the line, for
/// other formats, truncated files, and bytes after `flash_bytes`.
std::vector<std::uint8_t> read_intel_hex(std::string_view text, const std::string& file, std::size_t room,
                                         std::size_t flash_bytes);

}  // namespace robosim::exec
