// Reads checks.toml, the checks for `robosim test`. docs/reference/checks.md explains the file and lists its
// keys.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/campaign/check/text_assertions.h"
#include "sim/campaign/sweep/figures.h"
#include "sim/campaign/sweep/sweep_options.h"

namespace robosim::campaign {

/// The allowed range of a measurement, including both ends.
struct FigureLimit {
  const Figure* figure;
  std::optional<double> min;
  std::optional<double> max;
};

/// One `[[check]]`.
struct Check {
  std::string name;
  Place place;
  SweepOptions sweep;               ///< the runs of the check; the caller adds sketches
  std::string fleet;                ///< a file of several robots, which replaces the sketch; empty = none
  std::vector<std::string> expect;  ///< the verdicts that a run may end with
  std::vector<FigureLimit> limits;
  std::vector<std::string> serial;        ///< texts that the sketch must send, in this order
  std::vector<std::string> shows;         ///< texts that parts must show, in this order
  bool detect = true;                     ///< detectors must find nothing
  std::vector<std::string> stations;      ///< stations that must be visited, in any order
  std::vector<TextAssertion> assertions;  ///< assertions of the whole file
};

/// Returns the file's assertions about all runs; none if the file does not exist. Throws InputError.
std::vector<TextAssertion> text_assertions_in(const std::filesystem::path& file);

/// Returns all checks of a file, in its order. Each key means the same as the flag of `run` or `sweep` with
/// the same name. Paths are relative to the file's folder. Throws InputError.
std::vector<Check> read_checks(const std::filesystem::path& file);
/// Works like read_checks(), but reads `text`, the content of `file`.
std::vector<Check> parse_checks(std::string_view text, const std::filesystem::path& file);

}  // namespace robosim::campaign
