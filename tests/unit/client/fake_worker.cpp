// Replaces robosim-host in tests of the worker pool. A request's "image" tells this program what to do:
//   die          ends itself
//   never        does not answer
//   input        answers with an error of kind "input"
//   slow         sends many lines before it answers
//   any other    answers with this word as the verdict
// The program also ends itself if a request has "started": true. Such a request asks for an event at the
// start of the run. A pool does not need this event.
#include <unistd.h>

#include <iostream>
#include <string>

#include "sim/wire/protocol.h"

using namespace robosim::wire;

int main() {
  const auto say = [](const Id& id, const Answer& answer) { std::cout << to_line(id, answer) << std::flush; };
  say({}, Hello{"fake", kProtocol, "0.1.0", "host"});
  for (std::string line; std::getline(std::cin, line);) {
    const auto asked = parse_request(line);
    const auto& request = std::get<RunRequest>(*asked.request);
    const std::string& what = request.image;
    if (what == "die" || request.started) return 7;
    if (what == "never") ::pause();
    if (what == "input") {
      say(asked.id, ErrorAnswer{"input", "no such map"});
      continue;
    }
    for (int i = 0; what == "slow" && i < 5'000; ++i)
      std::cout << to_line(asked.id, Event(SerialText{i, "still here"}));
    RunResult result;
    result.verdict = what;
    result.time_s = 1.0;
    result.goal = "tour";
    result.for_s = 600.0;
    result.seed = request.seed;
    result.profile = "ideal";
    result.trace_hash = "1:";
    result.metrics.distance_m = 1.0;
    say(asked.id, result);
  }
}
