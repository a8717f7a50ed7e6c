// A draft of a robot, tried out with the sketch that it is for: what the sketch then does to its pins makes
// the next draft, and which of several ways to wire it follows a line decides what nobody can guess.
#pragma once

#include <filesystem>
#include <string>

#include "sim/cli/arguments.h"
#include "sim/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/wiring/draft.h"

namespace robosim::cli {

/// Whether it has driven its lap along the line. A robot that is half its width off it on average comes round
/// an easy map, too; so does one whose sensors see it less than half of the time, unless they sit beside it.
bool follows_a_lap(const wire::RunResult& result, bool sensors_beside);

class TryOut {
 public:
  /// `launch` without a robot; its scratch files go below `folder`.
  TryOut(launch::Launch launch, const BoardSpec& board, const std::filesystem::path& folder,
         launch::Listener listener);

  /// Drafts, until a run shows nothing new. Throws InputError where the sketch does not build.
  wiring::RobotDraft draft();
  /// `draft` becomes the way that drives best of those that are open in it. Gives what came of its run.
  wire::RunResult choose(wiring::RobotDraft& draft);
  /// How many ways choose() has tried, and whether the chosen one follows the line for a lap.
  int tried() const { return tried_; }
  bool follows() const { return follows_; }

 private:
  wire::RunResult run(const wiring::RobotDraft& draft, double for_s, const std::string& goal,
                      wiring::PinHistory* history);

  launch::Launch launch_;
  const BoardSpec& board_;
  std::filesystem::path file_;
  launch::Launcher launcher_;
  client::Runner runner_;
  wiring::SketchNames names_;
  wiring::PinHistory history_;
  int tried_ = 0;
  bool follows_ = false;
};

}  // namespace robosim::cli
