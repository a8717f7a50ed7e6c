#include "tests/museum/stage.h"

#include <stdlib.h>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/process.h"

namespace robosim::museum {
namespace fs = std::filesystem;

namespace {

constexpr const char* kChanged[] = {"firmware", "tests/firmware/sketches"};
constexpr const char* kLinked[] = {"hal", "maps", "sim"};

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

/// Returns GoogleTest's filter for this target and the chosen suites.
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
  return mutate::run_tests(folder_ / "bin/tests", filter(choice), folder_, folder_);
}

void take_environment() {
  for (const char* name : {"ROBOSIM_REQUIRE", "ROBOSIM_TARGETS", "ROBOSIM_TEST_SEEDS", "GITHUB_ACTIONS"})
    ::unsetenv(name);
  ::setenv("ROBOSIM_ARTIFACTS", "none", 1);
  ::setenv("XDG_CACHE_HOME", ROBOSIM_MUSEUM_WORK "/cache", 1);
}

}  // namespace robosim::museum
