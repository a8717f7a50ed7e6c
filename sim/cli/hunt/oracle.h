// Detects findings in a run, without any specification of the sketch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cli/hunt/test_case.h"
#include "sim/wire/messages.h"

namespace robosim::cli {

/// The baseline run, to which others are compared.
struct Baseline {
  wire::RunResult result;
  wire::RobotInfo robot;
  bool reached() const { return result.verdict == "reached"; }
  /// Returns the speed on the way to the goal.
  double speed_m_s() const { return result.time_s > 0.0 ? result.metrics.distance_m / result.time_s : 0.0; }
};
/// Returns whether the sketch has set the pins of a motor.
bool has_motors(const wire::RunResult& result, const wire::RobotInfo& robot);
/// Returns whether it reads the line at all.
bool reads_the_floor(const wire::RunResult& result, const wire::RobotInfo& robot);

/// The kind of a detector's finding.
inline constexpr const char* kDetected = "detected";
/// Farther than a robot moves that only twitches.
inline constexpr double kMoved_m = 0.1;
/// The trait of a run that moved so far.
inline constexpr const char* kDrives = "drives";
/// The kind of a compiler warning.
inline constexpr const char* kWarned = "warned";
/// The kind of a difference between two runs that should be alike.
inline constexpr const char* kUnlike = "unlike";

struct Symptom {
  std::string kind;      ///< "crashed", "lost", "late" …
  std::string group;     ///< equal for an apparently equal cause: the kind, and where in the sketch
  std::string sentence;  ///< what happened
  /// The robot's behaviour, not a provable fault in the program. If the baseline has it, too, other runs are
  /// nothing new.
  /// it, too, others tell nothing new.
  bool is_behaviour = false;
};

/// Returns simulated seconds after which a robot with its baseline speed would long have arrived. 0 =
/// unknown.
double longest_wait_s(const TestCase& test_case, const HuntSpace& space, const Baseline& baseline);

/// Returns whether the robot's behaviour in this test case says anything about the sketch. It does not with
/// checks, which change its timing. Nor after a power cycle, which restarts it anywhere, or a manual move,
/// which puts it anywhere. Nor if it tours one floor by luck.
bool tells_behaviour(const TestCase& test_case, const HuntSpace& space);

std::optional<Symptom> symptom_of(const wire::RunResult& result, const TestCase& test_case,
                                  const HuntSpace& space, const Baseline& baseline);
/// Returns the detectors' findings, one by one.
std::vector<Symptom> detected_in(const wire::RunResult& result);

/// Returns the compiler's warnings in `messages` on code that is hardly ever intended. Examples: an = in a
/// condition, an if without a body, a constant that does not fit.
std::vector<Symptom> warned_in(const std::string& messages);

/// Returns a broken `never` or `always` assertion of checks.toml.
std::optional<Symptom> failed_assertion(const wire::RunResult& result,
                                        const std::vector<TextAssertion>& assertions);
/// Returns the `sometimes` assertions that were kept.
std::vector<std::string> passed_assertions(const wire::RunResult& result,
                                           const std::vector<TextAssertion>& assertions);

/// Returns traits of a run, in words that repeat in a similar run: places that it reached, its output without
/// numbers. After a run with a new trait, similar runs are worthwhile.
std::vector<std::string> traits_of(const wire::RunResult& result);
/// Returns when the first of these traits, of an event or of a sent line, was seen.
Moment moment_of(const std::vector<std::string>& traits, const wire::RunResult& result);

}  // namespace robosim::cli
