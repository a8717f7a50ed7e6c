// Lines of the runner protocol from and to values, for both of its ends. Each line here has its line feed at
// the end, and may be read with or without.
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

// The client's end.

std::string to_line(long long id, const Request& request);
/// To a run that stands still.
std::string to_line(long long id, const DrivenRequest& request);
/// To a run that goes along with the wall clock.
std::string to_line(long long id, const LiveRequest& request);

/// One line of a runner.
struct Line {
  long long id = -1;  ///< of the request that it answers; -1 = none (hello)
  Answer content;
};

/// Throws RunnerError, quoting the line, if it is none of the protocol's. Keys that are not known are
/// skipped. Behind the line of a Batch its bytes follow.
Line parse_line(std::string_view text);

/// The first line of a runner, `program`. Throws RunnerError, with a sentence for people, if that is no
/// runner of Robosim's or speaks another version of the protocol.
Hello parse_hello(std::string_view text, const std::string& program);

// The runner's end.

/// Any number that a client has chosen for its request; monostate = it has chosen none.
using Id = std::variant<std::monostate, std::int64_t, std::uint64_t, double>;

/// What a client has asked: a request, or nothing and what is wrong with the line, in one sentence.
template <class Any>
struct Asked {
  Id id;
  std::optional<Any> request;
  std::string fault;
};

Asked<Request> parse_request(std::string_view text);
Asked<DrivenRequest> parse_driven_request(std::string_view text);
Asked<LiveRequest> parse_live_request(std::string_view text);

/// Of a Batch with its bytes.
std::string to_line(const Id& id, const Answer& answer);
/// Of a Batch of so many bytes, without them.
std::string batch_line(const Id& id, std::size_t bytes);

}  // namespace robosim::wire
