// The zlib format, in which a recording is wrapped: written by libdeflate, which takes a third of zlib's
// time, and read by zlib, which need not know how much it will be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim::record {

std::string deflated(std::string_view bytes);
/// Throws InputError if the bytes are none that deflated() gave, were cut off, or come to more than
/// `most_bytes`.
std::string inflated(std::string_view bytes, std::size_t most_bytes);

}  // namespace robosim::record
