// One run, from a client's request to its result. Where it takes place (a fork, a confined process, a tab of
// a browser), who drives it and where its events go is up to its owner.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/grid/map.h"
#include "sim/judge/outcome.h"
#include "sim/robot/description.h"
#include "sim/run/scenery.h"
#include "sim/run/simulation.h"
#include "sim/runner/bundler.h"
#include "sim/runner/narrator.h"
#include "sim/wire/messages.h"

namespace robosim::runner {

/// `target` as the request has it: empty = the runner's own.
using MakeExecutor = std::function<std::unique_ptr<exec::Executor>(
    const std::string& target, const BoardSpec& board, const std::filesystem::path& image)>;

/// All of its robots, the first one too.
std::vector<wire::AgentRequest> agents_of(const wire::RunRequest& request);

/// The files that a result rests on.
struct Inputs {
  std::string map_sha256, robot_sha256, image_sha256;
};
Inputs inputs_of(const std::string& map_sha256, const std::string& image, const robot::Description& robot);

/// An outcome, together with what it rests on.
wire::RunResult result_of(const judge::Outcome& outcome, const wire::RunRequest& request,
                          const Inputs& inputs);

grid::Draw draw_of(const wire::RunRequest& request);

/// A map, and what a simulation on it begins with.
struct ReadMap {
  /// Throws InputError.
  ReadMap(const std::filesystem::path& file, grid::Draw draw);
  const grid::Map map;
  const std::string sha256;
  std::unique_ptr<run::Scenery> scenery;  ///< for one simulation; null = it makes its own
};

/// The errands of a request's robots on a map. Throws InputError if one of them cannot be understood.
std::vector<run::Errand> errands_of(const wire::RunRequest& request, const grid::Map& map);

/// By the name that a request has for them.
using Robots = std::map<std::string, std::shared_ptr<const robot::Description>>;

class RequestedRun {
 public:
  /// Reads all files, but those of `robots` and `map`, which have been. `request` must outlive this, and so
  /// must where `batches` are. Throws InputError, and ToolMissing.
  RequestedRun(const MakeExecutor& make, const wire::RunRequest& request, Tell tell,
               SharedBatches batches = {}, Robots robots = {}, std::shared_ptr<ReadMap> map = nullptr);

  /// Of one robot, by its number.
  exec::Executor& executor(std::size_t number = 0) { return *members_[number].executor; }
  /// `server`, which outlives this, may halt the first robot's chip, and go back where that can be done.
  void debug_with(exec::gdb::Server& server);
  /// For what the request does not say: who may interrupt it, who drives it.
  run::Setup& setup() { return setup_; }
  /// Tells what is held back: what sketches have sent of a line; the columns.
  void flush(SimTime t);

  /// To its end; once. Reads no more files.
  wire::RunResult go();
  /// Of its robots, where somebody else has brought it to its end.
  wire::RunResult result_of(const std::vector<judge::Outcome>& outcomes);

 private:
  /// One robot.
  struct Member {
    wire::AgentRequest asked;
    const robot::Description* robot = nullptr;
    std::unique_ptr<exec::Executor> executor;
    Inputs inputs;
    std::unique_ptr<Narrator> narrator;
  };

  void add(const MakeExecutor& make, wire::AgentRequest asked, const Tell& tell);
  const robot::Description& robot_named(const std::string& name);
  std::vector<judge::Outcome> simulate() const;
  judge::Outcome inquire() const;

  const wire::RunRequest& request_;
  const std::shared_ptr<ReadMap> map_;
  Robots robots_;
  std::unique_ptr<Bundler> bundler_;  ///< null = each event is told by itself
  std::deque<Member> members_;
  run::Setup setup_;
  exec::gdb::Server* debugger_ = nullptr;
};

}  // namespace robosim::runner
