// A finding of a hunt, and the files that describe it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "sim/campaign/hunt/campaign_runner.h"
#include "sim/campaign/hunt/oracle.h"

namespace robosim::campaign {

/// Describes the run that shows a finding, so that the user can repeat it.
struct Shown {
  struct Option {
    std::string name, value;
    bool own_file = false;  ///< the value is a file in the finding's folder

    /// Returns the value, with the finding's `folder` in front if it is a file.
    std::string value_in(const std::filesystem::path& folder) const;
  };
  std::string where;            ///< "avr with checks, oval"
  std::string sketch;           ///< as written in the command
  std::vector<Option> options;  ///< the options that differ from the defaults
  bool checked = false;         ///< shown by --sanitize
  bool detected = false;        ///< shown by a detector
  bool compared = false;        ///< shown by `robosim compare`
};

struct HuntFinding {
  Symptom symptom;
  TestCase test_case;           ///< the smallest test case found
  std::set<std::string> needs;  ///< its differences from the baseline
  double time_s = 0.0;          ///< simulated time at the end of the run
  std::size_t times = 1;        ///< number of runs with apparently the same cause
  Shown shown;

  /// Returns whether another symptom apparently has the same cause as this finding. Errors must be at the
  /// same place in the sketch. Behaviour must be the same, in a test case that has all `needs` of this
  /// finding. A behaviour that the baseline run shows has no `needs`, and explains all other behaviour.
  bool explains(const Symptom& other, const std::set<std::string>& needs_of_other) const;
};

/// Returns the text for the user, with the command that repeats the run. The run's files are in the folder
/// `out`/NUMBER.
std::string hunt_text(const HuntFinding& finding, std::size_t number, const std::filesystem::path& out);
/// Returns a [[check]] that fails until the fault is fixed, with paths relative to the findings' folder.
/// Returns only comments for a finding that no single run shows.
std::string hunt_check(const HuntFinding& finding, std::size_t number, const std::filesystem::path& out);

/// Writes `out`/NUMBER: the test case's files, its script and a page that replays it; sets `finding.shown`.
/// Throws InputError.
void keep(HuntFinding& finding, std::size_t number, const CampaignRunner& campaign,
          const HuntOptions& options, const std::filesystem::path& out);

}  // namespace robosim::campaign
