// A run of a table made again, to look at it: its recording, and where its robot left the line.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"
#include "sim/cli/report/sweep_rows.h"
#include "sim/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/record/floor_shapes.h"
#include "sim/tui/progress.h"

namespace robosim::cli {

struct MadeAgain {
  std::string recording;                       ///< the bytes of a .rec
  std::vector<std::array<double, 2>> left_mm;  ///< x, y: where the line was left
  std::optional<record::FloorShapes> floor;    ///< absent if the map is too large to be drawn
};

/// Where no sensor sees the line any more, for 20 ms or longer: as the page of a recording tells it.
std::vector<std::array<double, 2>> places_left(const std::string& recording);

class MakeAgain {
 public:
  /// With the options that the sweep had.
  explicit MakeAgain(const RunArguments& each);
  /// Nothing if it comes out as another run than the table's. Throws InputError, ToolMissing.
  std::optional<MadeAgain> operator()(const SweptRun& run);

 private:
  client::Runner& runner(const std::string& target);

  launch::Launch launch_;
  tui::Progress progress_;
  launch::Launcher launcher_;
  std::map<std::string, client::Runner> runners_;  ///< by target
};

}  // namespace robosim::cli
