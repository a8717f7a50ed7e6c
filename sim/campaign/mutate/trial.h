// Runs a sketch's checks, or test programs, on a changed copy of the sketch.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/build/cache.h"
#include "sim/campaign/check/check_result.h"
#include "sim/campaign/mutate/mutation.h"

namespace robosim::mutate {

/// The result of testing a changed sketch.
struct Trial {
  enum class Ending {
    passed,
    failed,        ///< a check or a test found the change
    late,          ///< a check or a test failed by a timeout, or because the sketch hung
    not_compiled,  ///< the sketch does not compile, so the change is not a bug
    interrupted,
  };
  Ending ending = Ending::passed;
  std::vector<std::string> traces;  ///< the trace hashes of all runs
  std::string check;                ///< the check or test that failed
  std::string why;                  ///< in one sentence
};

/// A copy of the sketch's folder, in which one file at a time is changed.
class Workbench {
 public:
  /// `folder` contains the sketch; `path` is the folder, or a file in it.
  Workbench(const std::filesystem::path& folder, const std::filesystem::path& path);

  /// Tests the copy at the path `sketch`.
  using Ask = std::function<Trial(const std::string& sketch)>;

  Trial try_unchanged(const Ask& ask) const { return ask(sketch_); }
  Trial try_with(const Mutation& mutation, const Ask& ask) const;

  /// Return the folders of the original and the copy, with links resolved.
  const std::filesystem::path& original() const { return original_; }
  const std::filesystem::path& copy() const { return copy_; }
  /// Returns a folder for files that tests need.
  const std::filesystem::path& scratch() const { return work_.path(); }

 private:
  build::WorkFolder work_;
  std::filesystem::path original_, copy_;
  std::string sketch_;
};

/// Returns a function that runs the checks of a file.
Workbench::Ask ask_checks(std::string file, std::size_t jobs);

/// Returns a function that runs GoogleTest programs. The environment variable ROBOSIM_MUTANT makes them use
/// the copy of the sketch.
Workbench::Ask ask_tests(std::vector<std::string> programs, const Workbench& bench);

}  // namespace robosim::mutate
