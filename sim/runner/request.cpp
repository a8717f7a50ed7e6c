#include "sim/runner/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim/base/error.h"
#include "sim/run/simulation.h"

namespace robosim::runner {
namespace {

using nlohmann::json;

class Keys {
 public:
  explicit Keys(const json& object) : object_(object) {}

  std::string text(const char* key, const std::string& fallback = "") {
    const json* value = find(key);
    if (!value) return fallback;
    if (!value->is_string()) wrong(key, "a string");
    return value->get<std::string>();
  }
  std::string required_text(const char* key) {
    std::string value = text(key);
    if (value.empty()) throw InputError(fmt::format("the request lacks the key \"{}\"", key));
    return value;
  }
  std::int64_t whole(const char* key, std::int64_t fallback) {
    const json* value = find(key);
    if (!value) return fallback;
    if (!value->is_number_integer() || value->get<std::int64_t>() < 0) wrong(key, "a whole number from 0");
    return value->get<std::int64_t>();
  }
  std::uint64_t unsigned_whole(const char* key, std::uint64_t fallback) {
    const json* value = find(key);
    if (!value) return fallback;
    if (!value->is_number_unsigned()) wrong(key, "a whole number from 0");
    return value->get<std::uint64_t>();
  }
  const json* find(const char* key) {
    known_.emplace_back(key);
    const auto it = object_.find(key);
    return it == object_.end() ? nullptr : &*it;
  }
  void finish() const {
    for (const auto& [key, value] : object_.items())
      if (std::find(known_.begin(), known_.end(), key) == known_.end())
        throw InputError(fmt::format("unknown key \"{}\" in the request; known are {}", key, one_of(known_)));
  }
  [[noreturn]] static void wrong(const char* key, const char* wanted) {
    throw InputError(fmt::format("\"{}\" in the request must be {}", key, wanted));
  }

 private:
  const json& object_;
  std::vector<std::string> known_;
};

}  // namespace

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
  request.samples_every = keys.whole("samples_every_ns", 0);
  if (request.samples_every % kTick != 0) Keys::wrong("samples_every_ns", "a multiple of the tick, 1000000");
  request.clock_start = keys.whole("clock_ns", 0);
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
