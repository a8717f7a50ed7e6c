// A test fixture that builds sketches. Each test has a temporary folder. All tests share one build cache, so
// the Arduino core is compiled only once.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "tests/support/temporary_folder.h"

namespace robosim::build {

class SketchTest : public testing::Test {
 protected:
  SketchTest() {
    test::use_shared_cache();
    ::setenv("HOME", (folder_ / "home").c_str(), 1);
  }
  ~SketchTest() override {
    for (const auto& [name, value] : environment_) ::setenv(name, value.c_str(), 1);
    ::unsetenv("TMPDIR");
  }

  /// Writes a file below the test's folder. Returns its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write_file(folder_ / name, content);
    return folder_ / name;
  }

  Image build_here(const std::string& name, std::vector<std::filesystem::path> libraries = {}) const {
    return build({folder_ / name, *find_board("uno"), "host", std::move(libraries)});
  }

  /// Builds the sketch `name`. Returns the message of the InputError, or "no error".
  std::string error_of(const std::string& name, std::vector<std::filesystem::path> libraries = {}) const {
    try {
      build_here(name, std::move(libraries));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();

 private:
  const std::pair<const char*, std::string> environment_[2] = {{"PATH", ::getenv("PATH")}, {"LC_ALL", "C"}};
};

inline const std::string kEmptySketch = "void setup() {}\nvoid loop() {}\n";

}  // namespace robosim::build
