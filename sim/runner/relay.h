// Between a confined run and its runner. The run's process has firmware of this machine in it, which may
// write what it likes to any descriptor: so it has none of the client's. It tells its runner, which has run
// no firmware, and the runner tells the client. Each message carries a token, and the last one counts only if
// the process then ends by itself.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/child.h"
#include "sim/runner/run_watch.h"
#include "sim/runner/shared.h"
#include "sim/wire/batch.h"
#include "sim/wire/protocol.h"

namespace robosim::runner {

/// What the run asks of its runner, and the answer.
using Ask = std::function<std::string(char what, const std::string& question)>;

class Relay {
 public:
  /// `batches`: whether there will be batches of events; `lines`: whether lines from the client. Throws
  /// std::system_error.
  Relay(bool batches, bool lines);

  /// In the run's process: its descriptors are from now on those of exec::ConfinedDescriptor, those of `kept`
  /// (ImageContent::sealed(), in ascending order), and no others.
  void enter(const std::vector<int>& kept);
  /// Nothing new from the system for this process, ever (sim/exec/host/confinement.h), if that can be had.
  void confine(bool has_grown) const;
  /// A line for the client, now.
  void tell(const std::string& line) const;
  /// The line that ends the run.
  void answer(const std::string& line) const;
  /// `what` is a small letter.
  std::string ask(char what, const std::string& question) const;
  /// Of lines from the client.
  long read_some(char* to, std::size_t bytes) const;
  /// Is to be told how far the run has come.
  std::atomic<SimTime>& reached() const { return watch_->reached(); }
  /// Where events wait until there are many; null where there are no batches. In the runner: those that it
  /// has not been told of.
  wire::BatchMemory* waiting() const {
    if (!batches_) return nullptr;
    return std::launder(reinterpret_cast<wire::BatchMemory*>((*batches_)->memories[batch_ % kBatches]));
  }
  /// What waits goes to the client from where it is, before what is told later; further events wait in the
  /// memory that this gives, which is empty.
  wire::BatchMemory& hand_on();
  /// Is to be told the number of the robot whose firmware runs.
  std::atomic<int>& acting() const { return watch_->acting(); }

  struct Told {
    std::optional<std::string> answer;
    bool forged = false;  ///< something else than the runner's code has written to it
    RunWatch::Found found = RunWatch::Found::nothing;
  };
  /// In the runner: until `run` has said its last, or something forged, or will never end. `id`: of the
  /// request. Where there are lines, what the client writes goes to the run.
  Told serve(const Child& run, const Ask& ask, const wire::Id& id, RunWatch::Limits limits);
  /// In the runner: how far the run has come.
  SimTime time() const { return watch_->time(); }

 private:
  struct Header {
    std::uint64_t token;
    std::uint64_t batches;  ///< that were handed on before
    std::uint32_t bytes;
    char what;
    char unused[3] = {};
  };
  void send(char what, const std::string& text) const;

  bool take(std::string& taken, const Ask& ask, const wire::Id& id, Told& told);
  /// Those before number `end`; false if these are more than there can be.
  bool take_batches(std::size_t end, const wire::Id& id);
  std::size_t handed_on() const {
    return batches_ ? (*batches_)->handed_on.load(std::memory_order_acquire) : 0;
  }

  Pipe told_, answers_;
  std::optional<Pipe> lines_;
  std::unique_ptr<RunWatch> watch_ = std::make_unique<RunWatch>();
  /// So far the run gets ahead of its runner before it waits. Who reads what it tells may be busy for some
  /// milliseconds, compressing it, or without a processor; in each of them a run fills three.
  static constexpr std::size_t kBatches = 32;
  /// So many wake the runner: each time costs the run as much as some hundred events.
  static constexpr std::size_t kWaking = 4;
  struct Batches {
    /// In turn. Zeroes, which the memory is made of, are one with nothing in it: what no run comes to is not
    /// touched, as each page costs it a fault.
    alignas(wire::BatchMemory) std::byte memories[kBatches][sizeof(wire::BatchMemory)];
    std::atomic<std::size_t> handed_on{0};  ///< by the run
    std::atomic<std::size_t> taken{0};      ///< by the runner, which empties them
  };
  std::optional<Shared<Batches>> batches_;
  std::size_t batch_ = 0;  ///< how many the run has handed on; in the runner: how many it has taken
  std::uint64_t token_ = 0;
  std::uint32_t key_[2] = {};
};

}  // namespace robosim::runner
