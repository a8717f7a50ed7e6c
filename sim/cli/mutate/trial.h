// The checks of a sketch, made on a changed copy of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/cache.h"
#include "sim/cli/check/check_result.h"
#include "sim/mutate/mutation.h"

namespace robosim::cli {

/// How a sketch did that was changed.
struct Trial {
  enum class Ending {
    passed,
    failed,        ///< a check found it
    late,          ///< one did, since time was up or the sketch hung
    not_compiled,  ///< it is no bug, then
    interrupted,
  };
  Ending ending = Ending::passed;
  std::vector<std::string> traces;  ///< the trace hashes of all runs
  std::string check;                ///< that found it
  std::string why;                  ///< in one sentence
};

/// A copy of the sketch's folder, in which one file at a time is changed.
class Workbench {
 public:
  /// `folder` holds the sketch, `path` is it or a file in it; `checks` is its file.
  Workbench(const std::filesystem::path& folder, const std::filesystem::path& path, std::string checks,
            std::size_t jobs);

  /// Of the sketch as it is.
  Trial try_unchanged() { return make_runs(); }
  Trial try_with(const mutate::Mutation& mutation);

 private:
  Trial make_runs();

  build::WorkFolder work_;
  std::filesystem::path copy_;
  std::string sketch_;
  std::string checks_;
  std::size_t jobs_;
};

}  // namespace robosim::cli
