// What of a run is a finding, without anybody having said what the sketch should do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cli/hunt/world.h"
#include "sim/wire/messages.h"

namespace robosim::cli {

/// The run in the plain world, that others are held against.
struct Plain {
  wire::RunResult result;
  wire::RobotInfo robot;
  bool reached() const { return result.verdict == "reached"; }
  /// On the way to the goal.
  double speed_m_s() const { return result.time_s > 0.0 ? result.metrics.distance_m / result.time_s : 0.0; }
};
/// Whether the sketch has set the pins of a motor.
bool has_motors(const wire::RunResult& result, const wire::RobotInfo& robot);
/// Whether it looks at the line at all.
bool reads_the_floor(const wire::RunResult& result, const wire::RobotInfo& robot);

/// The kind of what a detector has seen.
inline constexpr const char* kDetected = "detected";
/// Further than a robot comes that only twitches.
inline constexpr double kMoved_m = 0.1;
/// The trait of a run in which it did.
inline constexpr const char* kDrives = "drives";
/// The kind of what the compiler warns of.
inline constexpr const char* kWarned = "warned";
/// The kind of what two runs do that should be alike.
inline constexpr const char* kUnlike = "unlike";

struct Symptom {
  std::string kind;      ///< "crashed", "lost", "late" …
  std::string group;     ///< equal where the cause is taken to be one: the kind, and where in the sketch
  std::string sentence;  ///< what happened
  /// How the robot behaved, rather than a fault in the program that can be shown: where the plain world has
  /// it, too, others tell nothing new.
  bool is_behaviour = false;
};

/// In simulated seconds: a robot as fast as it is in the plain world would long be there. 0 = nobody knows.
double patience_s(const HuntWorld& world, const HuntSpace& space, const Plain& plain);

/// Checks change a sketch's timing, who is switched off begins anew wherever it is, who was held or twisted
/// may be anywhere, and who tours one floor by luck tours no others: how the robot behaves then says nothing
/// of the sketch.
bool tells_behaviour(const HuntWorld& world, const HuntSpace& space);

std::optional<Symptom> symptom_of(const wire::RunResult& result, const HuntWorld& world,
                                  const HuntSpace& space, const Plain& plain);
/// What detectors have seen, each for itself.
std::vector<Symptom> detected_in(const wire::RunResult& result);

/// What the compiler's `messages` warn of in the sketch that is hardly ever meant: an = in a condition, an if
/// without a body, a constant that does not fit.
std::vector<Symptom> warned_in(const std::string& messages);

/// What must never come, or must always, as checks.toml has it.
std::optional<Symptom> broken_promise(const wire::RunResult& result, const std::vector<Promise>& promises);
/// What must come sometimes, and did.
std::vector<std::string> kept_promises(const wire::RunResult& result, const std::vector<Promise>& promises);

/// What a run has come to, in words that come again in a run like it: places it came to, what was sent
/// (without its numbers). A run with a new one is worth to be followed by others like it.
std::vector<std::string> traits_of(const wire::RunResult& result);
/// When the first of these traits, of an event or of a line that was sent, was seen.
Moment moment_of(const std::vector<std::string>& traits, const wire::RunResult& result);

}  // namespace robosim::cli
