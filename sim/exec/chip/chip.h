// What a target that emulates a chip has to provide; the rest is the same for all of them (chip_executor.h).
// All times here are by the chip's own clock.
#pragma once

#include <any>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/core/causes.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/written_bytes.h"

namespace robosim::exec {

/// A chip with its firmware, from power-on to power-off.
class RunningChip {
 public:
  virtual ~RunningChip() = default;

  /// Runs to the first instruction that ends at or behind `t`, or to the firmware's end.
  virtual void run_until(SimTime t) = 0;
  /// Whether the firmware can run no further.
  virtual bool has_crashed() const = 0;
  virtual Crash crash() const = 0;

  virtual Resources resources() const = 0;
  virtual bool is_asleep() const = 0;
  /// When it last accessed I/O outside handlers.
  virtual SimTime last_io() const = 0;
  /// Whether it never will again. Takes some milliseconds.
  virtual bool hangs() const = 0;
  /// But for its last_call. Costly, as are the next two.
  virtual Activity activity() const = 0;
  virtual SourceLine where_now() const = 0;
  /// Of the instruction that is running, or the calls that led there: the sketch's own line.
  virtual SourceLine sketch_line() const { return where_now(); }
  /// While the firmware prints a byte: the line of the sketch that does; `before` is that of the byte before.
  virtual SourceLine printing(const SourceLine& before) const = 0;
  /// What the firmware prints is told to `bytes`, which outlives this.
  virtual void trace_bytes(WrittenBytes& bytes) = 0;
  /// As Executor has it.
  virtual const SourceLine& driving(Pin pin, const PinDrive& drive) const {
    static const SourceLine unknown;
    return static_cast<void>(pin), static_cast<void>(drive), unknown;
  }
  /// All that changes while it runs, but for its board. Throws InputError where that cannot be copied.
  virtual std::any save() const = 0;
  /// Of a chip with the same firmware. It does nothing to the board.
  virtual void restore(const std::any& saved) = 0;
  /// Of its detectors, if there are any.
  virtual std::vector<Detected> detected() const { return {}; }
  /// What its RAM holds, of one that keeps it through a brown-out.
  virtual std::vector<std::uint8_t> ram() const { return {}; }
  /// Not power-on has reset it, but its brown-out detector: it has this RAM still. To be called before it
  /// runs.
  virtual void was_browned_out(const std::vector<std::uint8_t>& ram) { static_cast<void>(ram); }
  /// millis() begins with `start` when main() begins.
  virtual void set_clock(SimTime start) = 0;
};

/// Firmware for a chip, as read from its ELF file.
class ChipFirmware {
 public:
  virtual ~ChipFirmware() = default;

  virtual const std::string& file() const = 0;
  /// How wide its int is.
  virtual int int_bits() const = 0;
  /// Whether the real chip could hold it, so that its size and speed mean something.
  virtual bool fits_chip() const = 0;
  /// Whether its EEPROM is the board's.
  virtual bool has_boards_eeprom() const = 0;
  /// What the EEPROM begins with; what is not there is erased.
  virtual const std::vector<std::uint8_t>& eeprom() const {
    static const std::vector<std::uint8_t> kErased;
    return kErased;
  }
  /// Why set_clock() would do nothing: "it never calls millis()"; empty where it would work.
  virtual std::string why_clock_stays() const = 0;

  /// What the chip keeps without power and changes by itself, but for the board's EEPROM.
  virtual std::any save() const { return {}; }
  virtual void restore(const std::any&) {}

  /// From the next power-on, a debugger may halt it. Both outlive this.
  virtual void debug_with(gdb::Server& server, ClockedBoard& board) = 0;
  /// From the next power-on, it is counted how often lines run.
  virtual void count_lines() = 0;
  /// From the next power-on, the chip tells which lines drive pins, if this returns true.
  virtual bool trace_drives() { return false; }
  /// From the next power-on, detectors watch; as Executor has it.
  virtual void detect(const std::vector<Pin>& counted) { static_cast<void>(counted); }
  /// As Executor has it. `board` outlives this.
  virtual CauseFinder* find_causes(ClockedBoard& board) { return static_cast<void>(board), nullptr; }
  /// As LineCounts has it; empty where nothing is counted.
  virtual std::string line_counts() const = 0;
  /// One at a time; it ends before `board` and this do.
  virtual std::unique_ptr<RunningChip> power_on(ClockedBoard& board, SimTime t) = 0;
};

}  // namespace robosim::exec
