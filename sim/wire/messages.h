// Defines all messages of the runner protocol (docs/reference/runner-protocol.md) as C++ structs, or includes
// the headers that define them.
#pragma once

#include "sim/result/run_result.h"
#include "sim/wire/driven.h"
#include "sim/wire/robot_info.h"
#include "sim/wire/run_request.h"
#include "sim/wire/stream.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

/// The version of the protocol. Both ends must have the same version.
inline constexpr int kProtocol = 1;

/// The first message of a runner.
struct Hello {
  std::string program;  ///< "robosim-host"
  int protocol = 0;
  std::string version;       ///< Robosim's version: "0.1.0"
  std::string target;        ///< "host"
  std::string sandbox = "";  ///< "on", "off", "missing"; empty if the chip is emulated
  std::string no_sandbox_why = "";
};

template <class V>
void fields(V& v, Same<V, Hello>& h) {
  v("hello", h.program, "name of the runner's program");
  v("protocol", h.protocol, "version of the protocol that the runner uses");
  v("version", h.version, "version of Robosim");
  v("target", h.target, "target whose firmware the runner runs: `\"host\"`, `\"avr\"` or `\"stm32\"`");
  v("sandbox", h.sandbox,
    "whether a [sandbox](../explanation/security.md) confines runs: `\"on\"`, `\"off\"` by choice, or "
    "`\"missing\"` in the kernel; absent if the chip is emulated",
    {.presence = when(!h.sandbox.empty())});
  v("no_sandbox_why", h.no_sandbox_why, "why the sandbox is not on, a clause; absent if it is on",
    {.presence = when(!h.no_sandbox_why.empty())});
}

/// Reports that a request has failed.
struct ErrorAnswer {
  static constexpr const char* kKey = "error";
  std::string kind;  ///< "input", "tool" or "internal"
  std::string message;
};

template <class V>
void fields(V& v, Same<V, ErrorAnswer>& e) {
  v("kind", e.kind, "kind of the error: `\"input\"` (exit status 2), `\"internal\"` (3) or `\"tool\"` (5)");
  v("message", e.message, "the error, one sentence");
}

/// All messages of a runner.
using Answer =
    std::variant<Hello, ErrorAnswer, RobotInfo, Event, RunResult, Paused, Accepted, Eeprom, Refused>;

}  // namespace robosim::wire
