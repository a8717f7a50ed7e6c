// A run, from a client's request to its result. The caller decides where the run executes (fork, confined
// process, browser tab), what controls it, and who receives its events.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/judge/outcome.h"
#include "sim/map/map.h"
#include "sim/robot/description.h"
#include "sim/run/prepared_map.h"
#include "sim/run/simulation.h"
#include "sim/runner/event_batcher.h"
#include "sim/runner/event_encoder.h"
#include "sim/wire/messages.h"

namespace robosim::runner {

/// Makes an executor for the target in the request; an empty `target` means the target of the runner program.
using MakeExecutor = std::function<std::unique_ptr<exec::Executor>(
    const std::string& target, const BoardSpec& board, const std::filesystem::path& image)>;

/// Returns all robots of a request, including the first.
std::vector<wire::AgentRequest> agents_of(const wire::RunRequest& request);

/// The hashes of the files on which a result depends.
struct Inputs {
  std::string map_sha256, robot_sha256, image_sha256;
};
Inputs inputs_of(const std::string& map_sha256, const std::string& image, const robot::Description& robot);

/// Returns the result for an outcome, including the hashes of the files on which it depends.
result::RunResult result_of(const judge::Outcome& outcome, const wire::RunRequest& request,
                            const Inputs& inputs);

map::Draw draw_of(const wire::RunRequest& request);

/// A map, and the initial state of a simulation on it.
struct ReadMap {
  /// Reads the map. Throws InputError.
  ReadMap(const std::filesystem::path& file, map::Draw draw);
  const map::Map map;
  const std::string sha256;
  std::unique_ptr<run::PreparedMap> prepared_map;  ///< for the first simulation, which sets it to null
};

/// Returns the missions of a request's robots on a map. Throws InputError if a mission is invalid.
std::vector<run::Mission> missions_of(const wire::RunRequest& request, const map::Map& map);

/// Robots, by their names in a request.
using Robots = std::map<std::string, std::shared_ptr<const robot::Description>>;

class RequestedRun {
 public:
  /// Reads all files, except those of `robots` and `map`, which have been read already. `request` and the
  /// memory of `batches` must outlive this object. Throws InputError or ToolMissing.
  RequestedRun(const MakeExecutor& make, const wire::RunRequest& request, Tell tell,
               SharedBatches batches = {}, Robots robots = {}, std::shared_ptr<ReadMap> map = nullptr);

  /// Returns the executor of robot `number`.
  exec::Executor& executor(std::size_t number = 0) { return *members_[number].executor; }
  /// Lets `server` halt the first robot's chip, and run it in reverse if that is possible. `server` outlives
  /// this object.
  void debug_with(exec::gdb::Server& server);
  /// Returns the set-up, for settings outside the request, such as the controller of the run.
  run::Setup& setup() { return setup_; }
  /// Sends buffered output: incomplete lines of sketches, and columns.
  void flush(SimTime t);

  /// Runs to the end, without reading any more files. Call this function only once.
  result::RunResult go();
  /// Returns the result for the outcomes of the run's robots. Used by callers that run the simulation
  /// themselves, instead of calling go().
  result::RunResult result_of(const std::vector<judge::Outcome>& outcomes);

 private:
  /// A robot of the run.
  struct Member {
    wire::AgentRequest asked;
    const robot::Description* robot = nullptr;
    std::unique_ptr<exec::Executor> executor;
    Inputs inputs;
    std::unique_ptr<EventEncoder> encoder;
  };

  void add(const MakeExecutor& make, wire::AgentRequest asked, const Tell& tell);
  const robot::Description& robot_named(const std::string& name);
  std::vector<judge::Outcome> simulate() const;
  judge::Outcome inquire() const;

  const wire::RunRequest& request_;
  const std::shared_ptr<ReadMap> map_;
  Robots robots_;
  std::unique_ptr<EventBatcher> batcher_;  ///< null = events are passed on one by one
  std::deque<Member> members_;
  run::Setup setup_;
  exec::gdb::Server* debugger_ = nullptr;
};

}  // namespace robosim::runner
