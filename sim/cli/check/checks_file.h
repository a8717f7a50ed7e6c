// checks.toml: what `robosim test` is to check. docs/checks.md explains it and lists the keys.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/cli/arguments.h"
#include "sim/cli/check/promises.h"
#include "sim/cli/sweep/figures.h"

namespace robosim::cli {

/// The allowed range of a figure, both ends included.
struct FigureLimit {
  const Figure* figure;
  std::optional<double> min;
  std::optional<double> max;
};

/// One `[[check]]`.
struct Check {
  std::string name;
  Place place;
  SweepArguments sweep;             ///< its runs; sketches are still to be filled in
  std::string fleet;                ///< a file of several robots, run in place of the sketch; empty = none
  std::vector<std::string> expect;  ///< verdicts of which a run must end with one
  std::vector<FigureLimit> limits;
  std::vector<std::string> serial;    ///< texts that the sketch must send, one after the other
  std::vector<std::string> shows;     ///< texts that parts must tell, one after the other
  bool detect = true;                 ///< detectors must see nothing
  std::vector<std::string> stations;  ///< that must be visited, in any order
  std::vector<Promise> promises;      ///< of the file
};

/// What the file says of all runs, if it is there. Throws InputError.
std::vector<Promise> promises_in(const std::filesystem::path& file);

/// All checks of a file, in its order. Values of flags are judged by the command line's own parser, so that a
/// flag means the same in both. Paths are relative to the file's folder. Throws InputError.
std::vector<Check> read_checks(const std::filesystem::path& file);
/// `text` is the content of `file`.
std::vector<Check> parse_checks(std::string_view text, const std::filesystem::path& file);

}  // namespace robosim::cli
