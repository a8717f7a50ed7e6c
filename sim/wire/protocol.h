// Converts lines of the runner protocol from and to values, for both of its ends. Each line has its line feed
// at the end here, and may be read with or without.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "sim/wire/live.h"
#include "sim/wire/messages.h"

namespace robosim::wire {

/// The runner broke the protocol, or died: a fault of Robosim (exit status 3).
class RunnerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An interrupted run did not answer within seconds, or was killed: there is no result.
class Unstoppable : public RunnerError {
 public:
  using RunnerError::RunnerError;
};

// The client's end.

std::string to_line(long long id, const Request& request);
/// Converts a request to a paused run.
std::string to_line(long long id, const DrivenRequest& request);
/// Converts a request to a run in step with the wall clock.
std::string to_line(long long id, const LiveRequest& request);

/// One line from a runner.
struct Line {
  long long id = -1;  ///< of the request that it answers; -1 = none (hello)
  Answer content;
};

/// Parses a line. Throws RunnerError, quoting the line, if it is not of the protocol. Unknown keys are
/// skipped. After the line of a Batch its bytes follow.
Line parse_line(std::string_view text);

/// Parses the first line of a runner, `program`. Throws RunnerError, with a sentence for users, if that is
/// not a runner of Robosim or has another version of the protocol.
Hello parse_hello(std::string_view text, const std::string& program);

// The runner's end.

/// The number that a client has chosen for its request; monostate = none.
using Id = std::variant<std::monostate, std::int64_t, std::uint64_t, double>;

/// A client's line: a request, or nothing and one sentence on the error.
template <class Any>
struct Asked {
  Id id;
  std::optional<Any> request;
  std::string fault;
};

Asked<Request> parse_request(std::string_view text);
Asked<DrivenRequest> parse_driven_request(std::string_view text);
Asked<LiveRequest> parse_live_request(std::string_view text);

/// Writes an answer; a Batch with its bytes.
std::string to_line(const Id& id, const Answer& answer);
/// Writes the line of a Batch of that size, without its bytes.
std::string batch_line(const Id& id, std::size_t bytes);

}  // namespace robosim::wire
