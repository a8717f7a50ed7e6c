// Tries out a draft of a robot with its sketch. The sketch's use of its pins refines the next draft. If
// several wirings are possible, chooses the wiring with which the robot follows the line furthest.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/campaign/wiring/draft.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"

namespace robosim::wiring {

/// Returns a board for the sketch (sketch_names.h).
GuessedBoard board_for(const launch::SketchChoice& sketch);

/// Returns whether the robot has followed the line for a lap. Excludes laps by luck, in which the RMS
/// cross-track error is at least 50 mm. Also excludes laps in which the sensors are off the line half of the
/// time. The second condition does not apply to `sensors_beside`: sensors that are next to the line and
/// rarely see the line.
bool follows_a_lap(const result::RunResult& result, bool sensors_beside);

/// A wiring that was tried, and what the sketch did with it.
struct Trial {
  Ways ways;
  double followed_m = 0.0;  ///< length of line that the robot followed; repetitions do not count
  bool follows = false;     ///< whether the robot followed the line for a lap
  result::RunResult result;
};

/// Returns all combinations of one or more ways (guess.h) that are true in `open`, the smallest first.
std::vector<Ways> combinations(const Ways& open);

/// Measures the length of the line that a robot followed: the number of different squares of 5 cm in which
/// its sensors were at most 3 cm from a line. A robot that turns on the spot adds no further squares.
class FollowedLine {
 public:
  void add(const wire::Sample& sample);
  /// Returns the length in m.
  double length() const;

 private:
  std::set<std::pair<int, int>> squares_;
};

class CandidateTrial {
 public:
  /// `launch` has no robot. Scratch files go into `folder`.
  CandidateTrial(launch::Launch launch, const BoardSpec& board, const std::filesystem::path& folder,
                 launch::Listener listener);

  /// Makes drafts until a run shows nothing new, but at most five. Throws InputError if the sketch does not
  /// build.
  RobotDraft draft();
  /// Tries the variants that `draft` leaves open, at most 64, until one follows the line for a lap. Then
  /// tries only variants that differ from this variant in one way, since these may follow the line more
  /// closely. Sets `draft` to the best variant. Returns all trials, that of the original draft first.
  std::vector<Trial> choose(RobotDraft& draft);

 private:
  /// Guesses a draft. Parts that the reader of robot files refuses become questions.
  RobotDraft guess(const Ways& ways);
  result::RunResult run(const RobotDraft& draft, double for_s, const std::string& goal,
                        const std::function<void(const wire::Event&)>& on_event);
  Trial attempt(const RobotDraft& draft, const Ways& ways);

  /// Finds the character after which the sketch reads pins most often, and sends it in all further runs.
  /// Sends none if the sketch reads pins nearly as often without a character.
  void choose_key(const RobotDraft& draft);

  launch::Launch launch_;
  const BoardSpec& board_;
  std::filesystem::path file_;
  launch::Launcher launcher_;
  client::Runner runner_;
  SketchNames names_;
  std::string key_;  ///< a line of a script that sends a character; empty = none
  PinHistory history_;
};

}  // namespace robosim::wiring
