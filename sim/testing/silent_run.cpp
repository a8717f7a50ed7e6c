#include "sim/testing/silent_run.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <exception>

#include "sim/base/error.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {
namespace {

int rehearsals = 0;

struct Rehearsal {
  Rehearsal() { ++rehearsals; }
  ~Rehearsal() { --rehearsals; }
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;
};

}  // namespace

bool is_silent_run() { return rehearsals > 0; }

bool fails_in(const Trial& trial, const std::function<void(Simulation&)>& body) {
  const Rehearsal rehearsal;
  ::testing::TestPartResultArray results;
  bool began = false;
  try {
    const ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    Simulation robot(trial);
    began = true;
    body(robot);
  } catch (const InputError&) {
    if (!began) throw;
    return true;
  } catch (const ToolMissing&) {
    throw;
  } catch (const std::exception&) {
    return true;
  }
  for (int i = 0; i < results.size(); ++i)
    if (results.GetTestPartResult(i).failed()) return true;
  return false;
}

void rerun_and_report(const Trial& trial, const std::function<void(Simulation&)>& body,
                      const std::string& why, const char* file, int line) {
  const ::testing::ScopedTrace trace(file, line, why);
  try {
    Simulation robot(trial);
    const std::string kept = robot.so_far().log().artifacts;
    const ::testing::ScopedTrace where(
        file, line,
        kept.empty() ? "nothing is kept" : "kept: " + kept + ", with the command that replays it");
    try {
      body(robot);
    } catch (const std::exception& problem) {  // the robot must still exist for the report
      ADD_FAILURE_AT(file, line) << problem.what();
    }
  } catch (const std::exception& problem) {
    ADD_FAILURE_AT(file, line) << problem.what();
  }
}

}  // namespace robosim::testing
