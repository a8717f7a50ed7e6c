// Provides the fixture for tests of a recording's page, run.html. Records one run for all tests of a program.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "sim/record/recording.h"
#include "tests/browser/driver.h"

namespace robosim::test {

/// A suite that several test files share, so that its cases share a browser and a recording.
class Page : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder;
    write_file(*folder / "go.script",
               "at 1s press start 100ms\nat 2500ms cover S3 200ms\nat 4s send \"hi\\n\"\n");
    const Ended ended = robosim_command({"run", "PidFollower", "--map", "tight", "--script", "go.script",
                                         "--record", "run.html", "--record", "run.rec"},
                                        folder->path());
    if (ended.status != 0) throw std::runtime_error(ended.err);
    recording = new record::Recording(record::Recording::read(file()));
  }
  static void TearDownTestSuite() {
    delete recording;
    delete folder;
    recording = nullptr;
    folder = nullptr;
  }
  void SetUp() override { ROBOSIM_NEEDS_BROWSER(); }
  static std::filesystem::path file() { return *folder / "run.html"; }

  static inline Folder* folder = nullptr;
  static inline record::Recording* recording = nullptr;
};

}  // namespace robosim::test
