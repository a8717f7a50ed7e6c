// Finds sketches that exist only for tests: small ones, with parts that Robosim's examples do not have.
#pragma once

#include <string>

#include "sim/base/file.h"

/// Returns the folder of one of tests/firmware/sketches.
inline std::string test_sketch(const std::string& name) {
  return (robosim::data_folder() / "tests/firmware/sketches" / name).string();
}
