// robosim_museum: reports which bugs the suite of tests/firmware finds. docs/explanation/museum.md has the
// program's output.
//
//   robosim_museum [BUG...]          tries each BUG, or all bugs: applies its patch in bugs/ to a copy of the
//                                    firmware, and runs the suite; without a bug, the suite must pass
//   --docs FILE                      also writes the table into this page
//   --jobs N                         tries N bugs at a time; default: one per core
//   --check BUG...                   runs the quick check of CI: all patches apply, the page
//                                    docs/explanation/museum.md has all bugs, and these bugs are
//                                    caught
//
// If the host does not find a bug, the suite runs on the chips. If no chip finds it, the library's unit tests
// run. The status is 1 if a bug could not be tried. It is also 1 if a bug without a line “Survives:” was not
// caught, or a bug with such a line was caught.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <future>
#include <iostream>
#include <mutex>
#include <optional>
#include <thread>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/wall_clock.h"
#include "tests/museum/library_tests.h"
#include "tests/museum/stage.h"
#include "tests/museum/table.h"

namespace {

using namespace robosim;
using namespace robosim::museum;
namespace fs = std::filesystem;

const std::vector<std::string> kTargets = {"host", "avr", "stm32"};

struct Arguments {
  std::vector<std::string> bugs;
  std::string docs;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool check = false;
};

void say(const std::string& line) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  std::cerr << line << std::endl;
}

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] {
      if (i + 1 == argc) throw InputError(word + " needs a value");
      return std::string(argv[++i]);
    };
    if (word == "--check") {
      arguments.check = true;
    } else if (word == "--docs") {
      arguments.docs = value();
    } else if (word == "--jobs") {
      arguments.jobs = static_cast<unsigned>(std::max(1, std::atoi(value().c_str())));
    } else if (word.starts_with("-")) {
      throw InputError(word + " is unknown; there are --docs FILE, --jobs N, --check and names of bugs");
    } else {
      arguments.bugs.push_back(word);
    }
  }
  return arguments;
}

std::vector<const Bug*> chosen(const std::vector<Bug>& all, const Arguments& arguments) {
  std::vector<const Bug*> bugs;
  if (arguments.bugs.empty() && !arguments.check)
    for (const Bug& bug : all) bugs.push_back(&bug);
  for (const std::string& name : arguments.bugs) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Bug& bug) { return bug.name == name; });
    if (found == all.end()) throw InputError("there is no bug " + name + " in " + ROBOSIM_MUSEUM_BUGS);
    bugs.push_back(&*found);
  }
  return bugs;
}

/// Calls `task(stage, i)` for each i below `count`, with one thread for each stage.
template <typename Task>
void for_each(std::size_t count, std::vector<Stage>& stages, Task task) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::future<void>> workers;
  for (Stage& stage : stages)
    workers.push_back(std::async(std::launch::async, [&] {
      for (std::size_t i; (i = next++) < count;) task(stage, i);
    }));
  for (std::future<void>& worker : workers) worker.get();
}

/// Runs the suite on the unchanged firmware, and returns the usable targets.
std::vector<std::string> run_baseline(std::vector<Stage>& stages) {
  std::vector<TestRun> runs(kTargets.size());
  for_each(runs.size(), stages, [&](Stage& stage, std::size_t i) {
    runs[i] = stage.test({kTargets[i], {}});
    say(fmt::format("without a bug, {}: {} tests passed, {} skipped{}", kTargets[i], runs[i].passed,
                    runs[i].skipped, runs[i].failed.empty() ? "" : ", failed: " + runs[i].failed));
  });
  std::vector<std::string> targets;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].failed.empty())
      throw InputError("without any bug " + runs[i].failed + " fails on " + kTargets[i] +
                       ", so that a table would mean nothing:\n" + runs[i].message);
    if (runs[i].passed > 0) targets.push_back(kTargets[i]);
  }
  return targets;
}

/// Returns the first test that fails. Runs the suites that the bug names, then all others that the bug may
/// affect.
std::string first_failure(const Stage& stage, const Bug& bug, const std::string& target) {
  std::string failed = stage.test({target, bug.tests}).failed;
  if (failed.empty() && !bug.in_one_sketch()) failed = stage.test({target, bug.tests, true}).failed;
  return failed;
}

/// Returns the first failure of the library's unit tests, or "".
std::string unit_test_failure(const LibraryTests& library, const Stage& stage, const Bug& bug) {
  for (const std::string& file : bug.files)
    if (const std::string failed = library.failure(stage, file); !failed.empty()) return failed;
  return "";
}

/// Tries a bug on the host and, if the host does not find it, on all chips. With `one_is_enough`, stops at
/// the first chip that finds the bug. If no target finds it, runs the library's unit tests, unless `library`
/// is null.
Result try_bug(Stage& stage, const Bug& bug, const std::vector<std::string>& targets, bool one_is_enough,
               const LibraryTests* library) {
  Result result{&bug, {}, 0.0, ""};
  try {
    stage.restore();
    stage.spoil(bug);
    const std::int64_t start_us = wall_us();
    for (const std::string& target : targets) {
      const std::string failed = first_failure(stage, bug, target);
      if (!failed.empty()) result.catches.push_back({target, failed});
      if (result.on_host() || (one_is_enough && result.caught())) break;
    }
    if (library != nullptr && !result.caught())
      if (const std::string failed = unit_test_failure(*library, stage, bug); !failed.empty())
        result.catches.push_back({kUnitTests, failed});
    result.seconds = 1e-6 * static_cast<double>(wall_us() - start_us);
  } catch (const std::exception& problem) {
    result.trouble = problem.what();
  }
  return result;
}

bool is_as_told(const Result& result) {
  return result.trouble.empty() && result.caught() == result.bug->survives.empty();
}

std::string line_of(const Result& result) {
  if (!result.trouble.empty())
    return fmt::format("{}: could not be tried: {}", result.bug->name, result.trouble);
  return fmt::format("{}: {} ({:.1f} s){}", result.bug->name,
                     result.caught() ? "caught, " + catches_of(result) : "not caught", result.seconds,
                     is_as_told(result) ? ""
                     : result.caught()  ? " — though its patch says that it survives"
                                        : " — and its patch does not say why");
}

bool all_apply(const Stage& stage, const std::vector<Bug>& bugs) {
  bool all = true;
  for (const Bug& bug : bugs) {
    const std::string complaint = stage.complaint(bug);
    if (complaint.empty()) continue;
    all = false;
    say(bug.patch.string() + " no longer applies: update it for the present firmware\n" + complaint);
  }
  return all;
}

bool all_are_in(const fs::path& page, const std::vector<Bug>& bugs) {
  const std::string text = read_file(page);
  std::string missing;
  for (const Bug& bug : bugs)
    if (text.find("bugs/" + bug.name + ".patch") == std::string::npos) missing += " " + bug.name;
  if (!missing.empty()) say(page.string() + " lacks" + missing + "; the target museum writes its table");
  return missing.empty();
}

bool run(const Arguments& arguments) {
  const fs::path work =
      arguments.check ? fs::path(ROBOSIM_MUSEUM_WORK) / "check" : fs::path(ROBOSIM_MUSEUM_WORK);
  const std::vector<Bug> all = read_bugs(ROBOSIM_MUSEUM_BUGS);
  const std::vector<const Bug*> bugs = chosen(all, arguments);
  std::vector<Stage> stages;
  for (unsigned i = 0; i < arguments.jobs; ++i) stages.emplace_back(work / fmt::format("stage{}", i));
  if (!all_apply(stages[0], all)) return false;
  if (arguments.check && !all_are_in(data_folder() / "docs/explanation/museum.md", all)) return false;

  std::optional<LibraryTests> library;
  if (!arguments.check) library.emplace(work / "museum_library_tests");
  const std::vector<std::string> targets = arguments.check ? kTargets : run_baseline(stages);
  std::vector<Result> results(bugs.size());
  std::atomic<std::size_t> done = 0;
  for_each(bugs.size(), stages, [&](Stage& stage, std::size_t i) {
    results[i] = try_bug(stage, *bugs[i], targets, arguments.check, library ? &*library : nullptr);
    say(fmt::format("{}/{} {}", ++done, bugs.size(), line_of(results[i])));
  });
  bool good = true;
  for (const Result& result : results) {
    if (!is_as_told(result)) say(line_of(result));
    good = good && is_as_told(result);
  }
  if (arguments.check) return good;
  std::string asked;
  for (const std::string& target : targets) asked += (asked.empty() ? "" : ", ") + target;
  const std::string table = table_of(results, asked);
  std::cout << table;
  if (!arguments.docs.empty() && arguments.bugs.empty())
    write_file(arguments.docs, with_table(read_file(arguments.docs), table));
  return good;
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = read_arguments(argc, argv);
  take_environment();
  return run(arguments) ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "robosim_museum: " << error.what() << '\n';
  return 2;
}
