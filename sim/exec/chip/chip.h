// Declares the interface that each target with an emulated chip implements. chip_executor.h implements the
// part that these targets have in common. All times in this file are measured by the chip's own clock.
#pragma once

#include <any>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/core/cause_finder.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/tx_provenance.h"

namespace robosim::exec {

/// A chip with its firmware, from power-on to power-off.
class RunningChip {
 public:
  virtual ~RunningChip() = default;

  /// Runs to the first instruction that ends at or after `t`, or to the firmware's end.
  virtual void run_until(SimTime t) = 0;
  /// Returns whether the firmware has crashed and cannot run any further. If so, crash() returns the report.
  virtual bool has_crashed() const = 0;
  virtual Crash crash() const = 0;

  virtual Resources resources() const = 0;
  virtual int watchdog_resets() const = 0;
  virtual bool is_asleep() const = 0;
  /// Returns when the firmware last accessed I/O outside interrupt handlers.
  virtual SimTime last_io() const = 0;
  /// Returns whether the firmware will never access I/O again. On an STM32, `true` is a guess, not a proof.
  /// Takes some milliseconds.
  virtual bool hangs() const = 0;
  /// Returns the firmware's activity, except Activity::last_call. This function is slow, because it reads
  /// debug information, as where_now() and sketch_line() do.
  virtual Activity activity() const = 0;
  virtual SourceLine where_now() const = 0;
  /// Returns the line of the sketch that is running. If a library is running, returns the line of the sketch
  /// that called the library.
  virtual SourceLine sketch_line() const { return where_now(); }
  /// Returns the line of the sketch that is printing a byte. `before` is the line of the previous byte.
  virtual SourceLine printing(const SourceLine& before) const = 0;
  /// Reports to `bytes` each byte that the firmware prints. `bytes` must outlive this chip.
  virtual void trace_bytes(TxProvenance& bytes) = 0;
  /// See ChipAccess::driving().
  virtual const SourceLine& driving(Pin pin, const PinDrive& drive) const {
    static const SourceLine unknown;
    return static_cast<void>(pin), static_cast<void>(drive), unknown;
  }
  /// Saves all state that changes during a run, except the state of the board. Throws InputError if the state
  /// cannot be saved.
  virtual std::any save() const = 0;
  /// Restores the state of a chip with the same firmware. The board is not changed.
  virtual void restore(const std::any& saved) = 0;
  /// Returns the findings of the detectors.
  virtual std::vector<Detected> detected() const { return {}; }
  /// Returns the content of the RAM, or nothing if the chip loses this content in a brown-out.
  virtual std::vector<std::uint8_t> ram() const { return {}; }
  /// Turns this power-on into a brown-out reset, after which the RAM contains `ram`. Must be called before
  /// the chip runs.
  virtual void was_browned_out(const std::vector<std::uint8_t>& ram) { static_cast<void>(ram); }
  /// Makes millis() count from `start` when main() begins.
  virtual void set_clock(SimTime start) = 0;
};

/// The firmware for a chip, as read from its ELF file.
class ChipFirmware {
 public:
  virtual ~ChipFirmware() = default;

  virtual const std::string& file() const = 0;
  /// Returns the width of int in bits.
  virtual int int_bits() const = 0;
  /// Returns whether the firmware fits into the real chip. If not, its size and speed are not meaningful.
  virtual bool fits_chip() const = 0;
  /// Returns whether the firmware uses the board's EEPROM.
  virtual bool has_boards_eeprom() const = 0;
  /// Returns the initial content of the first bytes of the EEPROM. All further bytes are 0xFF.
  virtual const std::vector<std::uint8_t>& eeprom() const {
    static const std::vector<std::uint8_t> kErased;
    return kErased;
  }
  /// Returns why set_clock() would have no effect, for example "it never calls millis()". Returns an empty
  /// text if set_clock() has an effect.
  virtual std::string why_clock_stays() const = 0;

  /// Saves the non-volatile state that the chip itself changes, except the board's EEPROM.
  virtual std::any save() const { return {}; }
  virtual void restore(const std::any&) {}

  /// Lets a debugger halt the chip from the next power-on. `server` and `board` must outlive this object.
  virtual void debug_with(gdb::Server& server, ClockedBoard& board) = 0;
  /// Counts how often each source line runs, from the next power-on.
  virtual void count_lines() = 0;
  /// Records which lines drive pins, from the next power-on. Returns false if that is impossible.
  virtual bool trace_drives() { return false; }
  /// Turns on the detectors at the next power-on; see ChipAccess::detect().
  virtual void detect(const std::vector<Pin>& counted) { static_cast<void>(counted); }
  /// See ChipAccess::find_causes(). `board` must outlive this object.
  virtual CauseFinder* find_causes(ClockedBoard& board) { return static_cast<void>(board), nullptr; }
  /// Returns LineCounts::text(), or an empty text if lines are not counted.
  virtual std::string line_counts() const = 0;
  /// Starts a chip. Only one chip may exist at a time. The chip must be destroyed before `board` and this
  /// object.
  virtual std::unique_ptr<RunningChip> power_on(ClockedBoard& board, SimTime t) = 0;
};

}  // namespace robosim::exec
