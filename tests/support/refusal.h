// Catches the errors that Robosim reports to its users.
#pragma once

#include <string>

#include "sim/base/error.h"

namespace robosim::test {

/// Returns the message of the InputError that `body` throws, or `otherwise`.
template <class Body>
std::string refusal(Body&& body, const char* otherwise = "accepted") {
  try {
    body();
  } catch (const InputError& error) {
    return error.what();
  }
  return otherwise;
}

}  // namespace robosim::test
