// Lets the runner's client control a run step by step (docs/reference/runner-protocol.md, "Driving a run step
// by step").
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "sim/run/simulation.h"
#include "sim/wire/protocol.h"

namespace robosim::runner {

class RemoteController final : public run::StepController {
 public:
  /// `before_pause` is called with the present time, before the client is notified of a pause.
  RemoteController(wire::Id id, std::string script_file, const std::atomic<bool>& interrupted,
                   std::function<void(SimTime)> before_pause)
      : id_(std::move(id)),
        script_file_(std::move(script_file)),
        interrupted_(interrupted),
        before_pause_(std::move(before_pause)) {}

  run::Leg next(run::Standstill& standstill) override;

 private:
  /// Returns how the run continues, or nothing if the request does not continue it.
  std::optional<run::Leg> serve(const wire::DrivenRequest& request, run::Standstill& standstill) const;
  void add_lines(const wire::Act& act, run::Standstill& standstill) const;
  void answer(const wire::Answer& answer) const;

  wire::Id id_;
  std::string script_file_;
  const std::atomic<bool>& interrupted_;
  std::function<void(SimTime)> before_pause_;
};

}  // namespace robosim::runner
