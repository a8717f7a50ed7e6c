// Converts lines of the runner protocol from and to values, for both ends of the protocol. Lines are written
// with a line feed at the end, and may be read with or without it.
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

/// Reports that the runner broke the protocol, or died: a fault of Robosim (exit status 3).
class RunnerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reports that a run was interrupted, and that its runner then died, or was killed because it sent nothing
/// for two seconds. There is no result.
class Unstoppable : public RunnerError {
 public:
  using RunnerError::RunnerError;
};

// The client's functions.

std::string to_line(long long id, const Request& request);
/// Writes a request for a run that is driven step by step. The run serves this request during a pause.
std::string to_line(long long id, const DrivenRequest& request);
/// Writes a request for a run in step with the wall clock.
std::string to_line(long long id, const LiveRequest& request);

/// One line from a runner.
struct Line {
  long long id = -1;  ///< id of the answered request; -1 = none (hello)
  Answer content;
};

/// Parses a line. Throws RunnerError, quoting the line, if the line does not match the protocol. Unknown keys
/// are skipped. The line of a Batch is followed by the batch's bytes.
Line parse_line(std::string_view text);

/// Parses the first line of a runner, `program`. Throws RunnerError, with a sentence for users, if `program`
/// is not a Robosim runner or has another protocol version.
Hello parse_hello(std::string_view text, const std::string& program);

// The runner's functions.

/// The number that a client has chosen for a request; monostate = none.
using Id = std::variant<std::monostate, std::int64_t, std::uint64_t, double>;

/// A parsed line of a client: the request, or a sentence that says why the line is invalid.
template <class Any>
struct Asked {
  Id id;
  std::optional<Any> request;
  std::string fault;
};

Asked<Request> parse_request(std::string_view text);
Asked<DrivenRequest> parse_driven_request(std::string_view text);
Asked<LiveRequest> parse_live_request(std::string_view text);

/// Writes an answer. The bytes of a Batch follow its line.
std::string to_line(const Id& id, const Answer& answer);
/// Writes the line of a Batch with `bytes` bytes, without these bytes.
std::string batch_line(const Id& id, std::size_t bytes);

}  // namespace robosim::wire
