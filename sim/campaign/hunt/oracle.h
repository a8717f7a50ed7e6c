// Detects findings in a run, without any specification of the sketch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/hunt/test_case.h"
#include "sim/wire/messages.h"

namespace robosim::campaign {

/// The baseline run, with which other runs are compared.
struct Baseline {
  result::RunResult result;
  wire::RobotInfo robot;
  bool reached() const { return result.verdict == "reached"; }
  /// Returns the mean speed on the way to the goal.
  double speed_m_s() const { return result.time_s > 0.0 ? result.metrics.distance_m / result.time_s : 0.0; }
};
/// Returns whether the sketch has set the pins of a motor.
bool has_motors(const result::RunResult& result, const wire::RobotInfo& robot);
/// Returns whether the sketch reads the line at all.
bool reads_the_floor(const result::RunResult& result, const wire::RobotInfo& robot);

/// The kind of a detector's finding.
inline constexpr const char* kDetected = "detected";
/// Minimum distance of a robot that drives, m. A shorter movement is only a twitch.
inline constexpr double kMoved_m = 0.1;
/// The trait of a run in which the robot moved farther than kMoved_m.
inline constexpr const char* kDrives = "drives";
/// The kind of a compiler warning.
inline constexpr const char* kWarned = "warned";
/// The kind of a difference between two runs that should be alike.
inline constexpr const char* kUnlike = "unlike";

struct Symptom {
  std::string kind;      ///< "crashed", "lost", "late" …
  std::string group;     ///< equal for apparently equal causes: the kind, and the place in the sketch
  std::string sentence;  ///< what happened
  /// The symptom is the robot's behaviour, not a provable fault in the program. If the baseline run has the
  /// same behaviour, other runs with this behaviour show nothing new.
  bool is_behaviour = false;
};

/// Returns the simulated time in seconds after which a robot with its baseline speed would long have arrived;
/// 0 = unknown.
double longest_wait_s(const TestCase& test_case, const HuntSpace& space, const Baseline& baseline);

/// Returns whether the robot's behaviour in this test case is evidence of a fault. Excludes builds with
/// checks, which change the timing. Excludes power cycles and manual moves, after which the robot may be
/// anywhere. Excludes drawn maps of a kind on which the sketch does not reliably reach its goal.
bool tells_behaviour(const TestCase& test_case, const HuntSpace& space);

std::optional<Symptom> symptom_of(const result::RunResult& result, const TestCase& test_case,
                                  const HuntSpace& space, const Baseline& baseline);
/// Returns the detectors' findings, one by one.
std::vector<Symptom> detected_in(const result::RunResult& result);

/// Returns the compiler's warnings in `messages` about code that is rarely intended. Examples: an `=` in a
/// condition, an `if` without a body, a constant that does not fit.
std::vector<Symptom> warned_in(const std::string& messages);

/// Returns a broken `never` or `always` assertion of checks.toml.
std::optional<Symptom> failed_assertion(const result::RunResult& result,
                                        const std::vector<TextAssertion>& assertions);
/// Returns the `sometimes` assertions that the run satisfied.
std::vector<std::string> passed_assertions(const result::RunResult& result,
                                           const std::vector<TextAssertion>& assertions);

/// Returns the traits of a run: reached places, and output without numbers. Similar runs have equal traits. A
/// run with a new trait is worth varying.
std::vector<std::string> traits_of(const result::RunResult& result);
/// Returns the moment of the first of these traits that is an event or a sent line.
Moment moment_of(const std::vector<std::string>& traits, const result::RunResult& result);

}  // namespace robosim::campaign
