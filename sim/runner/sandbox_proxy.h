// Connects a confined run to its runner. The run's process executes native firmware, which may write anything
// to any descriptor. Therefore the process has no descriptor of the client. The process reports to its
// runner, which has never run firmware, and the runner reports to the client. A random token in each message
// reveals messages that firmware has forged. The last message counts only if the process then ends by itself.
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

/// Answers a question that the run asks its runner.
using Ask = std::function<std::string(char what, const std::string& question)>;

class SandboxProxy {
 public:
  /// Prepares a connection. `batches` states whether the run will send batches of events. `lines` states
  /// whether the client will send lines to the run. Throws std::system_error.
  SandboxProxy(bool batches, bool lines);

  /// In the run's process: closes all descriptors except those of exec::ConfinedDescriptor and those in
  /// `kept`. `kept` has the images' sealed descriptors (ImageContent::sealed()), in ascending order.
  void enter(const std::vector<int>& kept);
  /// Confines this process permanently by calling exec::confine(), to which it passes `has_grown`.
  void confine(bool has_grown) const;
  /// Sends a line to the client immediately.
  void tell(const std::string& line) const;
  /// Sends the line that ends the run.
  void answer(const std::string& line) const;
  /// Asks the runner a question, and returns the answer. `what` is a lower-case letter.
  std::string ask(char what, const std::string& question) const;
  /// Reads input from the client.
  long read_some(char* to, std::size_t bytes) const;
  /// Returns the variable to which the run writes the time that it has reached.
  std::atomic<SimTime>& reached() const { return watch_->reached(); }
  /// Returns the batch that collects events; null without batches. In the runner: returns the batch with the
  /// events that have not been handed on.
  wire::BatchMemory* waiting() const {
    if (!batches_) return nullptr;
    return std::launder(reinterpret_cast<wire::BatchMemory*>((*batches_)->memories[batch_ % kBatches]));
  }
  /// Passes the waiting events to the client, before any later report. Returns an empty batch for further
  /// events.
  wire::BatchMemory& hand_on();
  /// Returns the variable to which the run writes the number of the robot whose firmware runs.
  std::atomic<int>& acting() const { return watch_->acting(); }

  struct Told {
    std::optional<std::string> answer;
    bool forged = false;  ///< code other than the runner's has written to the pipe
    RunWatch::Found found = RunWatch::Found::nothing;
  };
  /// In the runner: serves `run` until its last message, a forged message, or a finding of the watch. `id` is
  /// the id of the request. If there are lines, passes the client's input to the run.
  Told serve(const Child& run, const Ask& ask, const wire::Id& id, RunWatch::Limits limits);
  /// In the runner: returns the time that the run has reached.
  SimTime time() const { return watch_->time(); }

 private:
  struct Header {
    std::uint64_t token;
    std::uint64_t batches;  ///< number of batches handed on before this message
    std::uint32_t bytes;
    char what;
    char unused[3] = {};
  };
  void send(char what, const std::string& text) const;

  bool take(std::string& taken, const Ask& ask, const wire::Id& id, Told& told);
  /// Writes `text` to the run. Sets `told.found` if the watch ends the run before the text is read.
  void hand(const Pipe& pipe, std::string_view text, Told& told);
  /// Handles the batches before number `end`. Returns false if `end` is impossible.
  bool take_batches(std::size_t end, const wire::Id& id);
  std::size_t handed_on() const {
    return batches_ ? (*batches_)->handed_on.load(std::memory_order_acquire) : 0;
  }

  Pipe told_, answers_;
  std::optional<Pipe> lines_;
  std::unique_ptr<RunWatch> watch_ = std::make_unique<RunWatch>();
  /// The number of batches by which the run may be ahead of its runner. At this limit, the run waits. A
  /// reader may be busy compressing, or have no processor, for some milliseconds. A run fills three batches
  /// per millisecond.
  static constexpr std::size_t kBatches = 32;
  /// The number of batches after which the run wakes the runner. Waking costs as much as a few hundred
  /// events.
  static constexpr std::size_t kWaking = 4;
  struct Batches {
    /// The memory of the batches, a ring buffer. Zeroed memory is an empty batch. A run touches only the
    /// pages that it needs, because each page costs a page fault.
    alignas(wire::BatchMemory) std::byte memories[kBatches][sizeof(wire::BatchMemory)];
    std::atomic<std::size_t> handed_on{0};  ///< number handed on by the run
    std::atomic<std::size_t> taken{0};      ///< number emptied by the runner
  };
  std::optional<Shared<Batches>> batches_;
  std::size_t batch_ = 0;  ///< number of batches handed on; in the runner: number of batches emptied
  std::uint64_t token_ = 0;
  std::uint32_t key_[2] = {};
};

}  // namespace robosim::runner
