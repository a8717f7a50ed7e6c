#include "sim/runner/request.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/run/simulation.h"
#include "sim/runner/keys.h"

namespace robosim::runner {
using nlohmann::json;

RunRequest parse_run_request(const json& object) {
  Keys keys(object);
  keys.find("id");
  keys.find("do");
  RunRequest request;
  request.image = keys.required_text("image");
  request.map = keys.required_text("map");
  request.robot = keys.required_text("robot");
  request.start = keys.text("start");
  request.goal = keys.text("goal");
  request.limit = keys.whole("for_ns", run::kDefaultLimit);
  request.seed = keys.unsigned_whole("seed", 1);
  const std::string profile = keys.text("profile", "typical");
  if (profile != "typical" && profile != "ideal")
    throw InputError(fmt::format("unknown profile \"{}\"; known are ideal and typical", profile));
  request.profile = profile == "ideal" ? robot::Profile::ideal : robot::Profile::typical;
  request.script = keys.text("script");
  request.script_file = keys.text("script_file", "script");
  request.counters = keys.text("counters");
  request.samples_every = keys.whole("samples_every_ns", 0);
  if (request.samples_every % kTick != 0) Keys::wrong("samples_every_ns", "a multiple of the tick, 1000000");
  request.clock_start = keys.whole("clock_ns", 0);
  request.interactive = keys.truth("interactive", false);
  if (const json* span = keys.find("source")) {
    const bool sound = span->is_array() && span->size() == 2 && (*span)[0].is_number_integer() &&
                       (*span)[1].is_number_integer();
    if (!sound) Keys::wrong("source", "two times in nanoseconds, as in [0, 1000000]");
    request.source.emplace((*span)[0].get<SimTime>(), (*span)[1].get<SimTime>());
  }
  const std::int64_t port = keys.whole("gdb_port", 0);
  if (port > 65535) Keys::wrong("gdb_port", "a port, 1 to 65535, or 0");
  request.gdb_port = static_cast<int>(port);
  if (const json* stream = keys.find("stream")) {
    if (!stream->is_array()) Keys::wrong("stream", "an array");
    for (const json& name : *stream) {
      if (name == "pin") {
        request.stream_pins = true;
      } else if (name == "serial") {
        request.stream_serial = true;
      } else if (name == "note") {
        request.stream_notes = true;
      } else if (name == "io") {
        request.stream_io = true;
      } else {
        Keys::wrong("stream", "an array of \"pin\", \"serial\", \"note\" and \"io\"");
      }
    }
  }
  keys.finish();
  return request;
}

}  // namespace robosim::runner
