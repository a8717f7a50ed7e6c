// Skips or fails tests whose tools are missing.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "sim/build/process.h"
#include "sim/build/sketch.h"

namespace robosim::test {

/// Returns whether the environment variable ROBOSIM_REQUIRE, such as "host,avr", names the target.
inline bool is_required(const std::string& target) {
  const char* required = std::getenv("ROBOSIM_REQUIRE");
  return required && ("," + std::string(required) + ",").find("," + target + ",") != std::string::npos;
}

}  // namespace robosim::test

/// Skips the test or SetUp if a tool of the target is missing. If ROBOSIM_REQUIRE names the target, the test
/// fails instead. The message names the tool's package in both cases.
#define ROBOSIM_NEEDS_TARGET(target)                                                 \
  do {                                                                               \
    const std::string missing = ::robosim::build::missing_tool(target);              \
    if (!missing.empty() && ::robosim::test::is_required(target)) FAIL() << missing; \
    if (!missing.empty()) GTEST_SKIP() << missing;                                   \
  } while (false)

/// Skips the test if clang++ is missing. Only `robosim mutate` needs clang++.
#define ROBOSIM_NEEDS_CLANG()                                                             \
  do {                                                                                    \
    const bool missing = ::robosim::build::find_program("clang++").empty();               \
    if (missing && ::robosim::test::is_required("clang")) FAIL() << "clang++ is missing"; \
    if (missing) GTEST_SKIP() << "clang++ is not installed";                              \
  } while (false)
