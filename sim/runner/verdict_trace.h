// Runs a simulation, then traces the causes of its verdict.
//
//   - The run is saved at intervals.
//   - The run is repeated around the decisive moment of the verdict, and each instruction is recorded
//     (exec::CauseFinder).
//   - The causes may include bytes that were written long before the decisive moment. To find the write of
//     such a byte, the run is repeated from the last snapshot before it had its later value.
//   - The source lines of the causes become links of a chain. Lines that read pins form one link. Lines that
//     set a value long before the decisive moment form another. All other lines form a link for each file.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/core/cause_finder.h"
#include "sim/run/simulation.h"
#include "sim/runner/snapshot_index.h"

namespace robosim::runner {

class Inquiry final : run::Listener {
 public:
  /// Examines a run of one robot. `board`, and all objects that `setup` points to, must outlive this object.
  /// Throws InputError if the target does not support tracing, or the image has no debug information.
  Inquiry(const run::Setup& setup, const BoardSpec& board, std::vector<robot::WiredPin> wiring);

  /// Returns the run's outcome, including its causes.
  judge::Outcome go();

 private:
  struct Command {
    SimTime t = 0;
    double left = 0.0, right = 0.0;
  };
  using Bytes = std::vector<std::optional<std::uint8_t>>;
  using Steps = std::vector<exec::CauseStep>;

  bool wants_inputs() const override { return true; }
  void sampled(const run::Sample& sample) override;
  void level_seen(Pin pin, bool level, SimTime t) override;
  void volts_seen(Pin pin, double volts, SimTime t) override;

  void run_and_save();
  void run_again(std::size_t from, SimTime until);
  template <typename Ask>
  Steps trace(SimTime t, SimTime until, Ask ask);
  void save_between(std::size_t moment);
  Bytes bytes_at(std::size_t moment, const std::vector<std::uint16_t>& addresses);
  void give_up_what_changes(std::size_t from);
  bool go_back(std::size_t& from, bool for_registers);
  std::optional<world::Side> unpowered_side() const;
  std::pair<SimTime, SimTime> blind_around(SimTime t) const;

  std::vector<result::Cause> chain_of(const judge::Decisive& decisive);
  void tell_of_stopping(SimTime t, SimTime end, std::vector<result::Cause>& chain);
  /// Adds steps that are not in the chain yet, until the chain has `most` links. `lines` limits the number of
  /// lines in a link.
  void add_links(const Steps& steps, SimTime t, std::size_t most, std::size_t lines,
                 std::vector<result::Cause>& chain) const;
  void tell_of_interrupts(SimTime t, std::vector<result::Cause>& chain);
  std::vector<result::Cause> links_of(const Steps& steps, SimTime t, std::size_t most,
                                      std::size_t lines) const;
  std::optional<Command> commands_at(SimTime t) const;
  result::Cause motors_at(SimTime t, const std::string& text) const;
  std::string name_of(Pin pin) const;
  std::string read_at(const exec::CauseStep& step) const;

  run::Setup setup_;
  const BoardSpec& board_;
  const std::vector<robot::WiredPin> wiring_;
  exec::CauseFinder& causes_;
  bool looks_again_ = false;

  std::vector<Command> commands_;  ///< commands of the motors
  std::vector<SimTime> looks_;     ///< times when line sensors were read
  /// By pin and time: the values that firmware read while the run was repeated. The values do not
  /// arrive in the order of time, because later moments are repeated first.
  std::map<Pin, std::map<SimTime, std::string>> seen_;

  run::Simulation simulation_;  // its constructor already reports to the fields above
  SnapshotIndex moments_;
};

}  // namespace robosim::runner
