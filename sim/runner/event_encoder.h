// Converts a run's reports to protocol events.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "hal/board/board_spec.h"
#include "sim/exec/core/executor.h"
#include "sim/run/simulation.h"
#include "sim/runner/event_batcher.h"
#include "sim/wire/messages.h"
#include "sim/wire/run_columns.h"

namespace robosim::runner {

class EventEncoder final : public run::Listener {
 public:
  /// Reports the events to which `request` subscribes, for robot number `agent`. Frequent events go
  /// through `batcher` if it is not null and the request's events come in batches. All arguments except
  /// `tell` must outlive this object.
  EventEncoder(const wire::RunRequest& request, int agent, const BoardSpec& board, exec::Executor& executor,
               Tell tell, EventBatcher* batcher);

  void began(const run::Beginning& beginning) override;
  void sampled(const run::Sample& sample) override;
  void happened(const result::RunEvent& event) override;
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override;
  bool wants_inputs() const override { return wants_inputs_ || columns_; }
  bool minds_turns() const override;
  void level_seen(Pin pin, bool level, SimTime t) override;
  void volts_seen(Pin pin, double volts, SimTime t) override;
  void byte_received(std::uint8_t byte, SimTime t) override;
  void byte_sent(std::uint8_t byte, SimTime t) override;

  /// Sends the sketch's serial output that is not a complete line yet.
  void flush_serial(SimTime t);
  /// Sends the buffered columns.
  void flush_columns();

 private:
  bool in_span(SimTime t) const;
  const exec::SourceLine& driving(Pin pin, const PinDrive& drive) const;
  int source_of(Pin pin, const PinDrive& drive) { return sources_ ? number_of_source(pin, drive) : 0; }
  int number_of_source(Pin pin, const PinDrive& drive);
  /// Returns whether the batcher can append an event without first appending a record of its time or name.
  /// This is the case for most events. This code is small, since recording a run must be fast.
  static bool goes_on(const EventBatcher* batcher, int agent, SimTime t, Pin pin) {
    return batcher && batcher->follows(agent, t, pin);
  }
  // Handle the events for which goes_on() returns false.
  [[gnu::noinline]] void change_pin(Pin pin, const PinDrive& drive, SimTime t);
  [[gnu::noinline]] void see_volts(Pin pin, double volts, SimTime t);
  // Report an event of a pin if there is no batcher.
  [[gnu::noinline]] void tell_pin(Pin pin, const PinDrive& drive, SimTime t);
  [[gnu::noinline]] void tell_level(Pin pin, bool level, SimTime t);
  [[gnu::noinline]] void tell_volts(Pin pin, double volts, SimTime t);
  /// Reports an event of this encoder's robot.
  template <typename Event>
  void tell(Event event);
  template <typename Event>
  void detail(Event event);

  const wire::RunRequest& request_;
  const int agent_;
  const BoardSpec& board_;
  exec::Executor& executor_;
  exec::ChipAccess* const chip_;  ///< null on the host
  Tell tell_;
  EventBatcher* const batcher_;  ///< null = events and columns are passed on directly
  const bool wants_columns_, wants_pins_, wants_inputs_;
  const bool hears_pins_;               ///< if false, changes of pins are ignored
  EventBatcher* quick_pins_ = nullptr;  ///< the batcher if it gets all pin events, without sources; or null
  EventBatcher* const quick_inputs_;    ///< the batcher if it gets all input events; or null
  std::string line_;
  std::optional<wire::RunColumns> columns_;
  std::optional<wire::SourceNumbers> sources_;  ///< set if the client makes columns that have source lines
  wire::Sample sample_;                         ///< last sample
};

}  // namespace robosim::runner
