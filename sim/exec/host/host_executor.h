// Implements the executor for firmware that is compiled for this computer (hal/host). Firmware is a shared
// object that runs on a fiber, in virtual time.
//
// If firmware causes a signal, its fiber never continues, and a Crash is reported. For this purpose, power-on
// installs handlers of SIGSEGV, SIGBUS, SIGILL, SIGFPE and SIGSYS. Signals that firmware did not cause are
// passed to the previous handler.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/hang_probe_backoff.h"
#include "sim/exec/core/watchdog_resets.h"
#include "sim/exec/host/divisions.h"
#include "sim/exec/host/image_file.h"
#include "sim/exec/host/injected_delays.h"
#include "sim/exec/host/unsupported_features.h"

namespace robosim::exec {

class HostExecutor final : public Executor, public HostAccess {
 public:
  /// `image` is a file built by robosim_sketch. power_on() reads the file each time.
  HostExecutor(const BoardSpec& spec, std::filesystem::path image);
  ~HostExecutor() override;

  RobotPort& board() override { return board_; }
  BoardProbe& probe() override { return board_; }
  /// Starts the firmware. Throws InputError if the image cannot be loaded.
  void power_on(SimTime t) override;
  /// Prepares for confinement (confinement.h). Reads the image now, unless the caller passes its content as
  /// `image`. Later, finds source lines by `lines` instead of starting addr2line. Must be called before the
  /// process is confined.
  void prepare_for_confinement(AddressLines lines, std::shared_ptr<const ImageContent> image = nullptr);
  void power_off(SimTime t) override;
  void run_until(SimTime t) override;
  SimTime sleeps_until() const override;
  void sleep_until(SimTime t) override { reached_ = t; }
  const std::optional<Crash>& crash() const override { return crash_; }
  Activity activity() override;
  SourceLine source() override;
  std::string call_now() const override;
  SimTime last_call() const override;
  bool hangs() override;
  HostAccess* host_access() override { return this; }
  int watchdog_resets() const override { return watchdog_resets_.count(); }
  const std::vector<DivisionByZero>& divisions_by_zero() const override { return divisions_.lines(); }
  const std::vector<Lack>& lacks() const override { return unsupported_features_.all(); }
  std::vector<ArchivedFile> counters() override;
  bool has_boards_eeprom() const override { return true; }
  /// Sets whether firmware that only polls may stay suspended, from the next power_on(). This changes only
  /// the duration of the simulation (hal/host/polling.h).
  void skip_waiting(bool may) { skips_waiting_ = may; }
  void set_lateness(const std::vector<Lateness>& lateness) override { injected_delays_.set(lateness); }
  void watch_actions(ActionWatcher& watcher) override { action_watcher_ = &watcher; }
  void set_clock_drift(int ppm, SimTime t) override { clocked_.drift(ppm, t); }

 private:
  class Instance;

  void look_at_silence();
  void restart();

  BoardState board_;
  ClockedBoard clocked_{board_};
  ImageFile image_;
  bool skips_waiting_ = true;
  InjectedDelays injected_delays_;
  std::unique_ptr<Instance> instance_;
  ActionWatcher* action_watcher_ = nullptr;
  std::optional<Crash> crash_;
  WatchdogResets watchdog_resets_;
  Divisions divisions_;
  UnsupportedFeatures unsupported_features_;
  std::vector<ArchivedFile> counters_;  ///< counters of earlier power cycles
  SimTime reached_ = 0;                 ///< time up to which the firmware has run
  HangProbeBackoff hang_probe_backoff_;
  SimTime watch_until_ = 0;
};

}  // namespace robosim::exec
