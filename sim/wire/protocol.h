// Lines of the runner protocol from and to values. Everything that knows JSON keys is in protocol.cpp.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::wire {

/// The runner broke the protocol, or died: a fault of Robosim's own (exit status 3).
class RunnerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An interrupted run did not answer within seconds, or was killed: there is no result.
class Unstoppable : public RunnerError {
 public:
  using RunnerError::RunnerError;
};

/// `{"id": 1, "error": …}`.
struct ErrorAnswer {
  std::string kind;  ///< "input", "tool" or "internal"
  std::string message;
};

/// One line of a runner.
struct Line {
  long long id = -1;  ///< of the request that it answers; -1 = none (hello)
  std::variant<Hello, ErrorAnswer, RobotInfo, Event, RunResult, Paused, Accepted, Eeprom, Refused> content;
};

/// Throws RunnerError, quoting the line, if it is none of the protocol's.
Line parse_line(std::string_view text);

/// Each with its final line feed.
std::string describe_robot_line(long long id, const std::string& robot);
std::string run_line(long long id, const RunRequest& request);
// To a run that stands still.
std::string act_line(long long id, const std::string& lines);
/// `to_ns` < 0: without end.
std::string go_on_line(long long id, std::int64_t to_ns, const std::vector<Stop>& stops);
std::string eeprom_line(long long id);
std::string end_line(long long id);

}  // namespace robosim::wire
