// The host target: firmware as a shared object, on its own fiber, in virtual time (hal/host).
//
// A fault of the firmware (a signal on its fiber) abandons the fiber and becomes a Crash. For that, handlers
// of SIGSEGV, SIGBUS, SIGILL and SIGFPE are installed at power-on; a signal that is not the firmware's goes
// to whoever handled it before.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/exec/core/bites.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/silence.h"
#include "sim/exec/host/divisions.h"
#include "sim/exec/host/image_file.h"
#include "sim/exec/host/lacks.h"
#include "sim/exec/host/late_times.h"

namespace robosim::exec {

class HostExecutor final : public Executor {
 public:
  /// `image` as robosim_sketch builds it; it is read at every power_on().
  HostExecutor(const BoardSpec& spec, std::filesystem::path image);
  ~HostExecutor() override;

  RobotPort& board() override { return board_; }
  BoardProbe& probe() override { return board_; }
  /// Throws InputError if the image cannot be loaded.
  void power_on(SimTime t) override;
  /// To be called before the process is confined (confinement.h): what needs files is done now, and what
  /// needs programs by `lines`. `image`: what the image's file holds, if that is known.
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
  const std::vector<DivisionByZero>& divisions_by_zero() const override { return divisions_.lines(); }
  const std::vector<Lack>& lacks() const override { return lacks_.all(); }
  std::vector<BundledFile> counters() override;
  bool has_boards_eeprom() const override { return true; }
  /// Whether firmware that only waits may be left asleep, which changes nothing but the time that it takes
  /// here (hal/host/polling.h); from the next power_on() on.
  void skip_waiting(bool may) { skips_waiting_ = may; }
  void set_lateness(const std::vector<Lateness>& lateness) override { late_times_.set(lateness); }
  void set_clock_drift(int ppm, SimTime t) override { clocked_.drift(ppm, t); }

 private:
  class Instance;

  void look_at_silence();
  void restart();

  BoardState board_;
  ClockedBoard clocked_{board_};
  ImageFile image_;
  bool skips_waiting_ = true;
  LateTimes late_times_;
  std::unique_ptr<Instance> instance_;
  std::optional<Crash> crash_;
  Bites bites_;
  Divisions divisions_;
  Lacks lacks_;
  std::vector<BundledFile> counters_;  ///< of the power cycles before
  SimTime reached_ = 0;                ///< until when firmware has run
  Silence silence_;
  SimTime watch_until_ = 0;
};

}  // namespace robosim::exec
