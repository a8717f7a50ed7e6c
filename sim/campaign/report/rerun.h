// Repeats a run for a report, to get its recording and the places where its robot left the line.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/launch/client/runner.h"
#include "sim/launch/fleet.h"
#include "sim/launch/launch.h"
#include "sim/record/floor_shapes.h"
#include "sim/record/recording.h"

namespace robosim::campaign {

/// The parts of a recording that a report needs.
struct RecordingExtract {
  std::string map;       ///< its name
  std::string map_text;  ///< empty if the map is too large to be drawn; `floor` is then unset
  std::optional<record::FloorShapes> floor;
  /// x, y where a robot last saw the line, before at least 20 ms without sight of the line.
  std::vector<std::array<double, 2>> left_mm;
};

RecordingExtract extract_of(const record::Recording& recording);

class Rerun {
 public:
  /// `listener` receives the reports of compilations.
  explicit Rerun(launch::Listener listener) : launcher_(std::move(listener)) {}
  /// Repeats a run and returns its recording, the bytes of a .rec file. Returns nullopt if the repeated run
  /// has another trace hash. Throws InputError, ToolMissing.
  std::optional<std::string> operator()(launch::Launch launch, const std::string& trace_hash);
  /// Repeats a run of several robots. `common` is the part that their requests have in common.
  std::optional<std::string> operator()(launch::Fleet fleet, wire::RunRequest common,
                                        const std::string& trace_hash);

 private:
  std::optional<std::string> run(client::Runner& by, const record::RecordedRun& what,
                                 const std::string& trace_hash);
  client::Runner& runner(const std::string& target);

  launch::Launcher launcher_;
  std::map<std::string, client::Runner> runners_;  ///< by target
};

}  // namespace robosim::campaign
