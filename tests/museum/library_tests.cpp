#include "tests/museum/library_tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/process.h"
#include "sim/campaign/mutate/test_report.h"

namespace robosim::museum {
namespace fs = std::filesystem;

namespace {

constexpr int kMostSeconds = 120;
constexpr const char* kPony = "firmware/examples/PonyNavigator";  // parts of this sketch have unit tests
constexpr const char* kLookAtEachAccess = "-fsanitize=address,undefined";

std::vector<std::string> sources_in(const std::string& folder) {
  std::vector<std::string> sources;
  for (const auto& entry : fs::directory_iterator(data_folder() / folder))
    if (entry.path().extension() == ".cpp")
      sources.push_back(folder + "/" + entry.path().filename().string());
  std::sort(sources.begin(), sources.end());
  return sources;
}

std::string object_name(const std::string& source) {
  std::string name = source;
  std::replace(name.begin(), name.end(), '/', '_');
  return name + ".o";
}

bool run(std::vector<std::string> words, const fs::path& folder, std::string& output) {
  words.insert(words.begin(), ROBOSIM_CXX);
  const build::CommandResult result = build::run(build::Command{std::move(words), folder, {}});
  output = result.output;
  return result.status == 0;
}

/// Compiles a source file with the firmware in `root`, and everything else from the source tree.
bool compile(const fs::path& root, const std::string& source, const fs::path& object, std::string& output) {
  const fs::path tree = data_folder(), of_root = root / source;
  const fs::path file = source.starts_with("firmware/") ? of_root : tree / source;
  return run(
      {"-std=c++20", "-O1", "-w", "-MD", kLookAtEachAccess, "-fno-sanitize-recover=all", "-I" + root.string(),
       "-I" + (root / "firmware/src").string(), "-I" + (root / kPony).string(), "-I" + tree.string(),
       "-I" + (tree / "tests/unit/firmware/fake").string(), "-c", file.string(), "-o", object.string()},
      object.parent_path(), output);
}

bool link(const std::vector<std::string>& objects, const fs::path& program, std::string& output) {
  std::vector<std::string> words = objects;
  words.insert(words.end(),
               {kLookAtEachAccess, "-o", program.string(), "-lgtest_main", "-lgtest", "-pthread"});
  return run(std::move(words), program.parent_path(), output);
}

/// Returns why a sanitizer ended the program; removes memory addresses. Returns "" if no sanitizer ended it.
std::string sanitizers_word(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("runtime error:") != std::string::npos) return line;
    const std::size_t at = line.find("AddressSanitizer: ");
    if (at != std::string::npos) return line.substr(at, line.find(" on ", at) - at);
  }
  return "";
}

/// Returns the first failure, or how the program ended. Returns "" if it succeeded.
std::string failure_of(const fs::path& program) {
  const std::string name = program.filename().string();
  try {
    const mutate::TestRun run =
        mutate::run_tests(program, "", program.parent_path(), program.parent_path(), kMostSeconds);
    return run.failed.empty() ? "" : name + ": " + run.failed;
  } catch (const mutate::CouldNotRun& threw) {
    return name + ": " + threw.what();
  } catch (const mutate::ProgramBroke& broke) {
    if (broke.late) return name + " hangs";
    const std::string said = sanitizers_word(broke.what());
    return said.empty() ? broke.what() : name + ": " + said;
  }
}

}  // namespace

LibraryTests::LibraryTests(fs::path folder) : folder_(std::move(folder)) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  programs_ = {{"nav_test", sources_in("tests/unit/nav")},
               {"firmware_test", sources_in("tests/unit/firmware")}};
  for (const char* more : {"tests/unit/firmware/fake", "firmware/src", kPony})
    for (const std::string& source : sources_in(more)) programs_[1].sources.push_back(source);
  std::string output;
  for (const Program& program : programs_) {
    std::vector<std::string> objects;
    for (const std::string& source : program.sources) {
      objects.push_back(object(source).string());
      if (!compile(data_folder(), source, object(source), output))
        throw InputError(source + " does not compile:\n" + output);
    }
    if (!link(objects, folder_ / program.name, output)) throw InputError(program.name + ":\n" + output);
    const std::string failed = failure_of(folder_ / program.name);
    if (!failed.empty()) throw InputError("without any bug there fails " + failed);
  }
}

fs::path LibraryTests::object(const std::string& source) const { return folder_ / object_name(source); }

std::string LibraryTests::failure(const Stage& stage, const std::string& changed) const {
  const fs::path folder = stage.scratch() / "library_tests";
  fs::create_directories(folder);
  std::string output;
  for (const Program& program : programs_) {
    std::vector<std::string> objects;
    bool any = false, compiles = true;
    for (const std::string& source : program.sources) {
      const fs::path was = object(source), now = folder / object_name(source);
      const bool anew = read_file(fs::path(was).replace_extension(".d")).find(changed) != std::string::npos;
      objects.push_back((anew ? now : was).string());
      any |= anew;
      compiles = compiles && (!anew || compile(stage.data(), source, now, output));
    }
    if (!any || !compiles || !link(objects, folder / program.name, output)) continue;
    const std::string failed = failure_of(folder / program.name);
    if (!failed.empty()) return failed;
  }
  return "";
}

}  // namespace robosim::museum
