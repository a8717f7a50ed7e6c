// Formats a call of the Arduino API as the sketch would write it.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "hal/host/image.h"

namespace robosim::exec {

/// Returns the call's text, such as "delay(5)"; empty if the firmware has made no call yet.
inline std::string text_of(const host::ApiCall& call) {
  if (*call.name == '\0') return "";
  if (call.arguments == 0) return fmt::format("{}()", call.name);
  const bool has_unsigned = std::string_view(call.name).substr(0, 5) == "delay";  // or delayMicroseconds
  if (has_unsigned) return fmt::format("{}({})", call.name, static_cast<std::uint32_t>(call.argument[0]));
  if (call.arguments == 1) return fmt::format("{}({})", call.name, call.argument[0]);
  if (call.arguments == 2) return fmt::format("{}({}, {})", call.name, call.argument[0], call.argument[1]);
  return call.name;
}

}  // namespace robosim::exec
