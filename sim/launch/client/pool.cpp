#include "sim/launch/client/pool.h"

#include <poll.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "sim/base/error.h"

namespace robosim::client {
namespace {

/// Maximum number of runs that may begin after an unfinished run. Their results wait in memory for the
/// unfinished run.
constexpr std::size_t kMostAhead = 10'000;
/// Limits the wall time of one poll(), because a signal that arrives just before poll() does not wake it.
constexpr int kSlice_ms = 100;

Answer failure_of(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const InputError& error) {
    return Failure{Failure::Kind::input, error.what()};
  } catch (const ToolMissing& error) {
    return Failure{Failure::Kind::tool, error.what()};
  } catch (const std::exception& error) {
    return Failure{Failure::Kind::internal, error.what()};
  }
}

}  // namespace

/// A runner process that executes one run at a time.
struct Pool::Worker {
  std::unique_ptr<Runner> runner;
  std::string target;  ///< target of the runner
  bool busy = false;
  std::size_t run = 0;

  /// Starts a run. Throws the exceptions of Runner.
  void begin(std::size_t index, Task task, const Start& start) {
    if (!runner || target != task.target) {
      runner.reset();
      runner = std::make_unique<Runner>(start(task.target));
      target = task.target;
    }
    task.request.started = false;  // omits an event that a pool ignores, and saves context switches
    runner->begin(task.request);
    run = index;
    busy = true;
  }

  /// Returns the answer if it has arrived.
  std::optional<Answer> take() {
    try {
      std::optional<result::RunResult> result = runner->take();
      if (!result) return std::nullopt;
      busy = false;
      return std::move(*result);
    } catch (...) {
      const auto answer = failure_of(std::current_exception());
      if (std::get<Failure>(answer).kind == Failure::Kind::internal) runner.reset();
      busy = false;
      return answer;
    }
  }

  void stop() {
    if (!busy) return;
    runner->kill();
    runner.reset();
    busy = false;
  }
};

/// The progress of a batch.
struct Pool::Work {
  const Batch& batch;
  std::size_t begun = 0;   ///< number of the first run that has neither begun nor been skipped
  std::size_t handed = 0;  ///< number of the first run that has not been passed on yet
  std::map<std::size_t, Answer> waiting = {};

  bool wanted(std::size_t i) const { return !batch.wanted || batch.wanted(i); }

  /// Returns the next run to begin.
  std::optional<std::size_t> next_to_begin() {
    while (begun < batch.count && !wanted(begun)) ++begun;
    if (begun == batch.count || begun >= handed + kMostAhead) return std::nullopt;
    return begun++;
  }

  void begin_one(Worker& worker, const Start& start);

  void hand_over() {
    for (; handed < batch.count; ++handed) {
      auto answer = waiting.extract(handed);
      if (!wanted(handed)) continue;
      if (answer.empty()) return;
      batch.answered(handed, std::move(answer.mapped()));
    }
  }

  /// Passes on the answers of all finished runs, even if an earlier run is unfinished.
  void hand_over_rest() {
    for (auto& [i, answer] : waiting) {
      if (wanted(i)) batch.answered(i, std::move(answer));
    }
  }
};

Pool::Pool(std::size_t workers, Start start) : workers_(workers), start_(std::move(start)) {
  if (!start_) start_ = [](const std::string& target) { return Runner(target); };
}

Pool::~Pool() {
  for (Worker& worker : workers_) worker.stop();
}

void Pool::Work::begin_one(Worker& worker, const Start& start) {
  const auto next = next_to_begin();
  if (!next) return;
  try {
    worker.begin(*next, batch.task(*next), start);
  } catch (...) {
    waiting.emplace(*next, failure_of(std::current_exception()));
  }
}

bool Pool::run(const Batch& batch) {
  Work work{batch};
  std::vector<pollfd> ready;
  std::vector<Worker*> busy;
  while (!interrupted_) {
    work.hand_over();
    if (work.handed == batch.count) return true;
    ready.clear();
    busy.clear();
    for (Worker& worker : workers_) {
      if (worker.busy && !work.wanted(worker.run)) worker.stop();
      if (!worker.busy) work.begin_one(worker, start_);
      if (!worker.busy) continue;
      ready.push_back({worker.runner->descriptor(), POLLIN, 0});
      busy.push_back(&worker);
    }
    if (::poll(ready.data(), ready.size(), work.waiting.contains(work.handed) ? 0 : kSlice_ms) <= 0) continue;
    for (std::size_t i = 0; i < busy.size(); ++i) {
      if (ready[i].revents == 0) continue;
      if (auto answer = busy[i]->take()) work.waiting.emplace(busy[i]->run, std::move(*answer));
    }
  }
  for (Worker& worker : workers_) worker.stop();
  work.hand_over();
  work.hand_over_rest();
  return false;
}

}  // namespace robosim::client
