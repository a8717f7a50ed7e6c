// One run, from a client's request to its result. Where it takes place (a fork, a confined process, a tab of
// a browser), who drives it and where its events go is up to its owner.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "sim/exec/core/executor.h"
#include "sim/grid/map.h"
#include "sim/judge/outcome.h"
#include "sim/robot/description.h"
#include "sim/run/simulation.h"
#include "sim/runner/narrator.h"
#include "sim/wire/messages.h"

namespace robosim::runner {

using MakeExecutor =
    std::function<std::unique_ptr<exec::Executor>(const BoardSpec&, const std::filesystem::path& image)>;

/// The files that a result rests on.
struct Inputs {
  std::string map_sha256, robot_sha256, image_sha256;
};
Inputs inputs_of(const wire::RunRequest& request, const robot::Description& robot);

/// An outcome, together with what it rests on.
wire::RunResult result_of(const judge::Outcome& outcome, const wire::RunRequest& request,
                          const Inputs& inputs);

class RequestedRun {
 public:
  /// Reads all files. `request` must outlive this. Throws InputError, and ToolMissing.
  RequestedRun(const MakeExecutor& make, const wire::RunRequest& request, Tell tell);

  exec::Executor& executor() { return *executor_; }
  /// For what the request does not say: who may interrupt it, who drives it.
  run::Setup& setup() { return setup_; }
  /// Tells what is held back: what the sketch has sent of a line; the columns.
  void flush(SimTime t) {
    narrator_.flush_serial(t);
    narrator_.flush_columns();
  }

  /// To its end; once. Reads no more files.
  wire::RunResult go();

 private:
  const wire::RunRequest& request_;
  const grid::Map map_;
  const robot::Description robot_;
  const std::unique_ptr<exec::Executor> executor_;
  const Inputs inputs_;
  Narrator narrator_;
  run::Setup setup_;
};

}  // namespace robosim::runner
