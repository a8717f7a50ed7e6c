// Reads Intel HEX, the text format for flash content. A line is `:` and a series of bytes, each in two
// hexadecimal digits. The bytes are the number of data bytes, a 16-bit address, the record type, the data,
// and a checksum. The checksum makes the sum of all bytes 0.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::exec {

/// Returns the bytes from address 0 on, with 0xFF in gaps. Skips bytes at addresses from `room` on, where the
/// boot loader of a .with_bootloader.hex is. Throws InputError for other formats, truncated files, and bytes
/// at addresses from `flash_bytes` on. The error names `file` and the line.
std::vector<std::uint8_t> read_intel_hex(std::string_view text, const std::string& file, std::size_t room,
                                         std::size_t flash_bytes);

}  // namespace robosim::exec
