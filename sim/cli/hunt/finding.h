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

struct HuntFinding {
  Symptom symptom;
  HuntWorld world;              ///< the smallest that was found
  std::set<std::string> needs;  ///< what of it is not plain
  double time_s = 0.0;          ///< simulated, when it was over
  std::size_t run = 0;          ///< the first, counted from 1; 0 = the plain one
  std::size_t times = 1;        ///< runs that are taken to be the same
  std::string replay;           ///< the command
  std::string text;             ///< for people
  std::string check;            ///< a [[check]] that fails as long as the fault is there

  /// Whether such a run is taken to have the same cause: the same place in the sketch, or the same behaviour
  /// in a world that has all that this one needs.
  bool explains(const Symptom& other, const std::set<std::string>& needs_of_other) const;
};

/// Writes `out`/NUMBER: the world's files, its script and a page that replays it; fills in the texts, with
/// paths in the check from the folder of the findings. Throws InputError.
void keep(HuntFinding& finding, std::size_t number, const HuntBench& bench, const HuntArguments& arguments,
          const std::filesystem::path& out);

}  // namespace robosim::cli
