// Connects a confined run to its runner. The run's process holds native firmware, which may write anything to
// any descriptor. So it has none of the client's. It reports to its runner, which has run no firmware, and
// the runner reports to the client. Each message carries a token, and the last one counts only if the process
// then ends by itself.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/child.h"
#include "sim/runner/run_watch.h"
#include "sim/runner/shared.h"
#include "sim/wire/batch.h"
#include "sim/wire/protocol.h"

namespace robosim::runner {

/// A question from the run to its runner; returns the answer.
using Ask = std::function<std::string(char what, const std::string& question)>;

class SandboxProxy {
 public:
  /// `batches`: whether there will be batches of events; `lines`: whether there will be lines from the
  /// client. Throws std::system_error.
  SandboxProxy(bool batches, bool lines);

  /// In the run's process: limits its descriptors to those of exec::ConfinedDescriptor, and those of `kept`
  /// (ImageContent::sealed(), in ascending order).
  void enter(const std::vector<int>& kept);
  /// Confines this process for ever (sim/exec/host/confinement.h), if that is possible.
  void confine(bool has_grown) const;
  /// Sends a line to the client, now.
  void tell(const std::string& line) const;
  /// Sends the line that ends the run.
  void answer(const std::string& line) const;
  /// `what` is a lower-case letter.
  std::string ask(char what, const std::string& question) const;
  /// Reads lines from the client.
  long read_some(char* to, std::size_t bytes) const;
  /// Receives how far the run has come.
  std::atomic<SimTime>& reached() const { return watch_->reached(); }
  /// Returns the batch in which events wait until there are many; null without batches. In the runner: those
  /// that have not been handed on.
  wire::BatchMemory* waiting() const {
    if (!batches_) return nullptr;
    return std::launder(reinterpret_cast<wire::BatchMemory*>((*batches_)->memories[batch_ % kBatches]));
  }
  /// Hands the waiting events to the client in place, before later reports. Returns an empty batch for
  /// further events.
  wire::BatchMemory& hand_on();
  /// Receives the number of the robot whose firmware runs.
  std::atomic<int>& acting() const { return watch_->acting(); }

  struct Told {
    std::optional<std::string> answer;
    bool forged = false;  ///< code other than the runner's has written to it
    RunWatch::Found found = RunWatch::Found::nothing;
  };
  /// In the runner: serves `run` until its last message, a forged one, or until it will never end. `id`: of
  /// the request. If there are lines, the client's input is passed to the run.
  Told serve(const Child& run, const Ask& ask, const wire::Id& id, RunWatch::Limits limits);
  /// In the runner: returns how far the run has come.
  SimTime time() const { return watch_->time(); }

 private:
  struct Header {
    std::uint64_t token;
    std::uint64_t batches;  ///< the number of batches that were handed on before
    std::uint32_t bytes;
    char what;
    char unused[3] = {};
  };
  void send(char what, const std::string& text) const;

  bool take(std::string& taken, const Ask& ask, const wire::Id& id, Told& told);
  /// Writes to the run. Sets `told.found` if its watch ends it before it has read enough.
  void hand(const Pipe& pipe, std::string_view text, Told& told);
  /// Takes those before number `end`; returns false if that is more than possible.
  bool take_batches(std::size_t end, const wire::Id& id);
  std::size_t handed_on() const {
    return batches_ ? (*batches_)->handed_on.load(std::memory_order_acquire) : 0;
  }

  Pipe told_, answers_;
  std::optional<Pipe> lines_;
  std::unique_ptr<RunWatch> watch_ = std::make_unique<RunWatch>();
  /// The number of batches that the run may be ahead of its runner before it waits. A reader may be busy for
  /// some milliseconds, compressing, or without a processor; a run fills three in each.
  static constexpr std::size_t kBatches = 32;
  /// The number of batches after which the runner is woken. Each time costs the run as much as some hundred
  /// events.
  static constexpr std::size_t kWaking = 4;
  struct Batches {
    /// Used in turn. The zeroed memory is an empty batch. Pages that a run does not need are not touched, as
    /// each costs a page fault.
    alignas(wire::BatchMemory) std::byte memories[kBatches][sizeof(wire::BatchMemory)];
    std::atomic<std::size_t> handed_on{0};  ///< by the run
    std::atomic<std::size_t> taken{0};      ///< by the runner, which empties them
  };
  std::optional<Shared<Batches>> batches_;
  std::size_t batch_ = 0;  ///< handed on by the run; in the runner: taken
  std::uint64_t token_ = 0;
  std::uint32_t key_[2] = {};
};

}  // namespace robosim::runner
