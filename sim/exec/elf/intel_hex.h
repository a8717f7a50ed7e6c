// Reads Intel HEX, the text format for flash content. A line is `:` and bytes of two digits each: the number
// of data bytes, 16 bits of their address, the kind, the data, and a checksum. The sum of all bytes
// is 0.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::exec {

/// Returns the bytes from address 0 on; 0xFF for gaps. Skips those from `room` on: they are the boot
/// loader's, in a .with_bootloader.hex. Throws InputError, which names `file` and the line, for other
/// formats, truncated files, and bytes after `flash_bytes`.
std::vector<std::uint8_t> read_intel_hex(std::string_view text, const std::string& file, std::size_t room,
                                         std::size_t flash_bytes);

}  // namespace robosim::exec
