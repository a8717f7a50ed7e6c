// The targets, as data: how to execute a sketch, and the values in which correct results differ.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::exec {

struct Target {
  const char *name, *board;
  std::unique_ptr<Executor> (*make_executor)(const BoardSpec&, const std::filesystem::path& image);
  double byte_us;     ///< duration of a byte at the chip's rate that is nearest to 9600 baud
  double handler_us;  ///< longest time from an edge to a handler's first write; on the host, to its exit
  bool names_tones;   ///< the executor reports a tone as a frequency, instead of edges

  // --- only for chips
  const char *robot_of_five, *robot_of_three;  ///< robots with this number of line sensors
  const char* program_counter;                 ///< gdb's number of this register, in hexadecimal
  const char *clock_handler,
      *clock_variable;  ///< the Arduino core's handler that counts milliseconds, and its counter
  /// Returns the address that gdb uses for a function or variable of an image.
  std::uint32_t (*address_of)(const std::filesystem::path& image, const BoardSpec&, const char* name);
  void (*run_waiting_loops)(Executor&);  ///< turns off the skipping of loops that wait
  std::uint64_t (*state_of)(Executor&);  ///< a hash of the chip's state; 0 before power-on
  double (*skipped_share)(Executor&);    ///< the share of the cycles that were skipped
};

/// Returns the target, or null if this build does not have it.
const Target* find_target(const std::string& name);
/// Returns those of the named targets that this build has.
std::vector<Target> targets(std::initializer_list<const char*> names);

inline std::string name_of(const testing::TestParamInfo<Target>& target) { return target.param.name; }
inline void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

}  // namespace robosim::exec
