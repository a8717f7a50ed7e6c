#include "sim/campaign/mutate/test_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/process.h"

namespace robosim::mutate {
namespace fs = std::filesystem;

namespace {

constexpr int kTimeIsUp = 124;  // exit status of the program `timeout`

/// Converts "On/PidFollower" and "StartsAtOnce/host" to PidFollower.StartsAtOnce.
std::string plain_name(const std::string& suite, const std::string& test) {
  const std::size_t slash = suite.find('/');
  return (slash == std::string::npos ? suite : suite.substr(slash + 1)) + "." +
         test.substr(0, test.find('/'));
}

TestRun read_report(const std::string& report) {
  TestRun run;
  const nlohmann::json json = nlohmann::json::parse(report);
  for (const auto& suite : json.at("testsuites")) {
    for (const auto& test : suite.at("testsuite")) {
      const std::string in = suite.at("name"), name = test.at("name");
      if (test.contains("failures") && run.failed.empty()) {
        run.failed = plain_name(in, name);
        run.message = test.at("failures").at(0).at("failure");
      } else if (test.at("result") == "COMPLETED") {
        ++run.passed;
        run.traces[in + "." + name] = test.value("robosim_traces", "");
      } else if (test.at("result") == "SKIPPED") {
        ++run.skipped;
      }
    }
  }
  return run;
}

}  // namespace

TestRun run_tests(const fs::path& program, const std::string& filter, const fs::path& folder,
                  const fs::path& scratch, int most_seconds) {
  const fs::path timeout = build::find_program("timeout");
  if (timeout.empty())
    throw ToolMissing("the program timeout is missing; the Debian package coreutils contains it");
  const fs::path report = scratch / "report.json";
  fs::remove(report);
  std::vector<std::string> words = {timeout.string(),  std::to_string(most_seconds),
                                    program.string(),  "--gtest_fail_fast",
                                    "--gtest_brief=1", "--gtest_output=json:" + report.string()};
  if (!filter.empty()) words.push_back("--gtest_filter=" + filter);
  const build::CommandResult result = build::run(build::Command{words, folder, {}});
  if (result.status > 1 || !fs::exists(report))
    throw ProgramBroke(fmt::format("{} ended with status {}{}{}", program.filename().string(), result.status,
                                   fs::exists(report) ? "" : ", but wrote no report, unlike GoogleTest",
                                   result.output.empty() ? "" : ":\n" + result.output),
                       result.status == kTimeIsUp);
  TestRun run = read_report(read_file(report));
  // An exception shows that the test could not start a run; the robot's behaviour does not throw exceptions.
  // Either the sketch does not compile, or the test requests something that does not exist.
  if (run.message.find("C++ exception with description") != std::string::npos)
    throw CouldNotRun(fmt::format("{} could not be run:\n{}", run.failed, run.message));
  return run;
}

}  // namespace robosim::mutate
