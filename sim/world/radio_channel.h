// Models radio transmission between robots, byte by byte. Each radio receives from all other radios on its
// channel. Not modelled: range, and collisions of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hal/board/sim_time.h"

namespace robosim::world {

class RadioChannel {
 public:
  /// A byte, and the time at which it reaches a radio.
  struct Arrival {
    SimTime at = 0;
    std::uint8_t byte = 0;
  };

  /// Adds a radio, and returns its number.
  std::size_t add_radio(int channel);
  /// Sends a byte, which reaches the other radios at `at`. `at` must be in a later tick, so that the order of
  /// calls within a tick has no effect.
  void send(std::size_t from, std::uint8_t byte, SimTime at);
  /// Removes and returns the next byte that reaches this radio before `t`; nullopt = none.
  std::optional<Arrival> take(std::size_t radio, SimTime t);

  /// The state that changes during a run.
  struct State {
    std::vector<std::vector<Arrival>> arriving;  ///< for each radio, sorted by time, then by the byte's value
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  std::vector<int> channels_;  ///< one per radio
  State state_;
};

}  // namespace robosim::world
