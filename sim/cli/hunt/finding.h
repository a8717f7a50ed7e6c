// What a hunt has found, and the files that it leaves of it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "sim/cli/hunt/bench.h"
#include "sim/cli/hunt/symptom.h"

namespace robosim::cli {

/// The run that shows a finding.
struct Shown {
  struct Option {
    std::string name, value;
    bool own_file = false;  ///< the value is a file in the finding's folder

    /// With that folder in front, if it is one.
    std::string value_in(const std::filesystem::path& folder) const;
  };
  std::string where;            ///< "avr with checks, oval"
  std::string sketch;           ///< as the command names it
  std::vector<Option> options;  ///< that are not as usual
  bool checked = false;         ///< by --sanitize
  bool detected = false;        ///< by a detector
  bool compared = false;        ///< by `robosim compare`
};

struct HuntFinding {
  Symptom symptom;
  HuntWorld world;              ///< the smallest that was found
  std::set<std::string> needs;  ///< what of it is not plain
  double time_s = 0.0;          ///< simulated, when it was over
  std::size_t times = 1;        ///< runs that are taken to be the same
  Shown shown;

  /// Whether such a run is taken to have the same cause: the same place in the sketch, or the same behaviour
  /// in a world that has all that this one needs.
  bool explains(const Symptom& other, const std::set<std::string>& needs_of_other) const;
};

/// For people, with the command that makes the run again. Its files are in `out`/NUMBER.
std::string hunt_text(const HuntFinding& finding, std::size_t number, const std::filesystem::path& out);
/// A [[check]] that fails as long as the fault is there, with paths from the folder of the findings.
std::string hunt_check(const HuntFinding& finding, std::size_t number);

/// Writes `out`/NUMBER: the world's files, its script and a page that replays it; fills in what is shown.
/// Throws InputError.
void keep(HuntFinding& finding, std::size_t number, const HuntBench& bench, const HuntArguments& arguments,
          const std::filesystem::path& out);

}  // namespace robosim::cli
