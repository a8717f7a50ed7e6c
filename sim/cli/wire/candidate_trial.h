// Tries out a draft of a robot with its sketch. The sketch's use of its pins refines the next draft. Of
// several possible wirings, the one that follows a line is chosen.
#pragma once

#include <filesystem>
#include <string>

#include "sim/cli/arguments.h"
#include "sim/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/wiring/draft.h"

namespace robosim::cli {

/// Returns whether it has driven a lap along the line. An easy map can be lapped with a mean cross-track
/// error of half the robot's width. So can it with sensors that see the line less than half of the time,
/// unless they are beside it.
bool follows_a_lap(const wire::RunResult& result, bool sensors_beside);

class CandidateTrial {
 public:
  /// `launch` has no robot; its scratch files go below `folder`.
  CandidateTrial(launch::Launch launch, const BoardSpec& board, const std::filesystem::path& folder,
                 launch::Listener listener);

  /// Makes drafts until a run shows nothing new. Throws InputError if the sketch does not build.
  wiring::RobotDraft draft();
  /// Sets `draft` to the one of its open variants that drives best. Returns the result of its run.
  wire::RunResult choose(wiring::RobotDraft& draft);
  /// Return the number of variants that choose() has tried, and whether the chosen one follows the line for a
  /// lap.
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
