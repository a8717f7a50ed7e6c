// Intel HEX: what is flashed, as text. A line is `:` and bytes as two digits each: how many data bytes, 16
// bits of their address, the kind, the data, and a byte that makes the sum of all 0.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::exec {

/// The bytes from address 0 on; 0xFF where there are none. Throws InputError, which names `file` and the
/// line, for what is no such file, ends too early, or has bytes behind `flash_bytes`. Those from `room` on
/// are the boot loader's, of a .with_bootloader.hex, and left out.
std::vector<std::uint8_t> read_intel_hex(std::string_view text, const std::string& file, std::size_t room,
                                         std::size_t flash_bytes);

}  // namespace robosim::exec
