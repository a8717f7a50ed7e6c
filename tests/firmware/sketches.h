// Finds sketches that exist only for tests. They are small, and use parts that Robosim's examples do not use.
#pragma once

#include <string>

#include "sim/base/file.h"

/// Returns the path of the folder `name` in tests/firmware/sketches.
inline std::string test_sketch(const std::string& name) {
  return (robosim::data_folder() / "tests/firmware/sketches" / name).string();
}
