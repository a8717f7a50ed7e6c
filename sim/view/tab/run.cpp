// Runs Robosim in a browser tab (docs/howto/tab.md). Defines the functions that page/worker.js calls. Only
// one request runs at a time, with files that the worker has written into the module's file system.
#include <emscripten.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "sim/base/error.h"
#include "sim/detect/avr/chip_detectors.h"
#include "sim/exec/avr/avr_executor.h"
#include "sim/record/recording.h"
#include "sim/robot/describe.h"
#include "sim/runner/answers.h"
#include "sim/runner/requested_run.h"
#include "sim/wire/protocol.h"

// Calls the worker's `reached`, with the progress of the run.
EM_JS(void, tell_reached, (double t_s), { Module["reached"](t_s); });

namespace {

using namespace robosim;

constexpr std::int64_t kSampleEvery_ns = 10'000'000, kTellEvery_ns = 1'000'000'000;

std::string answer, recording;

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem(); }

record::RecordedRun recorded(const wire::RunRequest& request) {
  record::RecordedRun run;
  run.robosim = ROBOSIM_VERSION;
  run.sketch = stem_of(request.image);
  run.map = stem_of(request.map);
  run.robot = stem_of(request.robot);
  run.target = "avr";
  run.robot_info = runner::to_wire(robot::describe(robot::load_description(request.robot)));
  run.request = request;
  return run;
}

result::RunResult run(wire::RunRequest request) {
  request.columns_every_ns = kSampleEvery_ns;
  request.samples_every_ns = kTellEvery_ns;
  request.serial = request.notes = true;
  record::Gatherer gatherer;
  const auto hear = [&](const wire::Event& event) {
    gatherer.add(event);
    if (const auto* sample = std::get_if<wire::Sample>(&event))
      tell_reached(static_cast<double>(sample->t_us) * 1e-6);
  };
  runner::RequestedRun requested(
      [](const std::string&, const BoardSpec& board, const std::filesystem::path& image) {
        return std::make_unique<exec::AvrExecutor>(board, image, detect::avr::chip_detectors);
      },
      request, hear);
  gatherer.begin(recorded(request));
  const result::RunResult result = requested.go();
  recording = gatherer.content(result);
  return result;
}

wire::Answer answer_to(const wire::Asked<wire::Request>& asked) {
  if (!asked.request) return wire::ErrorAnswer{"input", asked.fault};
  try {
    return run(std::get<wire::RunRequest>(*asked.request));
  } catch (const InputError& error) {
    return wire::ErrorAnswer{"input", error.what()};
  } catch (const std::exception& error) {
    return wire::ErrorAnswer{"internal", error.what()};
  }
}

}  // namespace

extern "C" {

/// Runs the `request`, a line of the runner protocol. Returns the line with the result or an error.
EMSCRIPTEN_KEEPALIVE const char* robosim_run(const char* request) {
  recording.clear();
  const auto asked = wire::parse_request(request);
  answer = wire::to_line(asked.id, answer_to(asked));
  return answer.c_str();
}

/// Return the recording of the last run and its size. The recording is the content of a .rec before
/// compression; empty without a recording.
EMSCRIPTEN_KEEPALIVE const char* robosim_recording() { return recording.data(); }
EMSCRIPTEN_KEEPALIVE int robosim_recording_size() { return static_cast<int>(recording.size()); }
}
