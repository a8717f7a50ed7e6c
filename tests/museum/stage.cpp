#include "tests/museum/stage.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/process.h"

namespace robosim::museum {
namespace fs = std::filesystem;

namespace {

constexpr const char* kChanged[] = {"firmware", "tests/firmware/sketches"};
constexpr const char* kLinked[] = {"hal", "maps", "sim"};
constexpr const char* kMostSeconds = "600";
constexpr int kTimeIsUp = 124;  // timeout's

std::string program(const std::string& name, const std::string& package) {
  const fs::path found = build::find_program(name);
  if (found.empty()) throw ToolMissing(name + " is missing; the Debian package " + package + " brings it");
  return found.string();
}

build::CommandResult patch(const fs::path& folder, const Bug& bug, bool dry) {
  std::vector<std::string> words = {
      program("patch", "patch"), "-p1", "--force", "--fuzz=0", "--no-backup-if-mismatch", "--reject-file=-"};
  if (dry) words.push_back("--dry-run");
  return build::run(build::Command{words, folder, bug.patch});
}

/// GoogleTest's: of this target, and of the chosen suites.
std::string filter(const Choice& choice) {
  const bool host = choice.target == "host";
  const std::string ending = host ? "" : "/" + choice.target;
  std::string yes, no = host ? "*/avr:*/stm32" : "";
  for (const std::string& word : choice.words) {
    std::string& list = choice.others ? no : yes;
    list += (list.empty() ? "*" : ":*") + word + (choice.others ? "*.*" : "*.*" + ending);
  }
  if (yes.empty()) yes = "*" + ending;
  return yes + (no.empty() ? "" : "-" + no);
}

/// "On/PidFollower" and "StartsAtOnce/host" are PidFollower.StartsAtOnce.
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
      if (test.contains("failures") && run.failed.empty()) {
        run.failed = plain_name(suite.at("name"), test.at("name"));
        run.message = test.at("failures").at(0).at("failure");
      } else if (test.at("result") == "COMPLETED") {
        ++run.passed;
        run.traces[suite.at("name").get<std::string>() + "." + test.at("name").get<std::string>()] =
            test.value("robosim_traces", "");
      } else if (test.at("result") == "SKIPPED") {
        ++run.skipped;
      }
    }
  }
  return run;
}

}  // namespace

Stage::Stage(fs::path folder) : folder_(std::move(folder)) {
  fs::remove_all(folder_);
  for (const char* sub : {"bin", "libexec", "share/robosim"}) fs::create_directories(folder_ / sub);
  fs::copy_file(ROBOSIM_FIRMWARE_TESTS, folder_ / "bin/tests");
  fs::create_directory_symlink(helper_folder(), folder_ / "libexec/robosim");
  for (const char* name : kLinked) fs::create_directory_symlink(data_folder() / name, data() / name);
  restore();
}

void Stage::restore() {
  for (const char* name : kChanged) {
    fs::remove_all(data() / name);
    fs::create_directories(data() / name);
    fs::copy(data_folder() / name, data() / name, fs::copy_options::recursive);
  }
}

std::string Stage::complaint(const Bug& bug) const {
  const build::CommandResult result = patch(data(), bug, true);
  return result.status == 0 ? "" : result.output;
}

void Stage::spoil(const Bug& bug) {
  const build::CommandResult result = patch(data(), bug, false);
  if (result.status != 0) throw InputError({bug.patch.string()}, "no longer applies:\n" + result.output);
}

void Stage::spoil(const std::vector<mutate::Edit>& edits) {
  const fs::path file = data() / edits.at(0).file;
  write_file(file, mutate::changed(read_file(file), edits));
}

TestRun Stage::test(const Choice& choice) const {
  const fs::path report = folder_ / "report.json";
  fs::remove(report);
  const build::CommandResult result = build::run(build::Command{
      {program("timeout", "coreutils"), kMostSeconds, (folder_ / "bin/tests").string(), "--gtest_fail_fast",
       "--gtest_brief=1", "--gtest_filter=" + filter(choice), "--gtest_output=json:" + report.string()},
      folder_,
      {}});
  if (result.status > 1 || !fs::exists(report))
    throw SuiteBroke(
        fmt::format("the tests on {} ended with status {}:\n{}", choice.target, result.status, result.output),
        result.status == kTimeIsUp);
  const TestRun run = read_report(read_file(report));
  // Not what the robot did: the sketch does not compile, or the test asks for what does not exist.
  if (run.message.find("C++ exception with description") != std::string::npos)
    throw CouldNotRun(fmt::format("{} on {} could not be run:\n{}", run.failed, choice.target, run.message));
  return run;
}

}  // namespace robosim::museum
