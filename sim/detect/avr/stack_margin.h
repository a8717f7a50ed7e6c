// Detects a stack that has too little room if an interrupt occurs at the wrong moment.
//
//   void report() { char line[120]; sprintf(line, …); … }     deepest call of loop(): leaves 20 bytes free
//   ISR(TIMER1_COMPA_vect) { error = kp * read(); }           may run at any time, and needs 40 bytes
//
//   variables | heap -> ...   20 ...  <- stack of the main program
//           40 <------------------- stack of a handler on top
//
// In this run, the interrupt may never have occurred during the deepest call. On a robot, one of thousands of
// interrupts occurs during this call by chance. The stack then overwrites variables, such as a threshold or a
// pointer. Or a return address is overwritten, and a function returns to an invalid address.
//
// The detector measures the smallest distance between the main program's stack and the variables or heap
// while interrupts are on. From that distance, the detector subtracts the stack use of the deepest handler.
// On an AVR, a handler can interrupt another handler only if the other handler enables interrupts. The stack
// use of each handler that enables interrupts is therefore subtracted, too.
//
// A finding is a remainder of fewer than 16 bytes. A handler may need 16 bytes for a branch that this run has
// not executed: a call (2 or 3 bytes), a few saved registers and one or two local numbers.
//
// The detector considers only handlers that have run, and that were enabled when the main program's stack was
// deepest. Not detected: a handler that is enabled only while the main program's stack is less deep; code
// that has not run; a handler whose stack use depends on the state of the main program. Sketches with several
// stacks (an RTOS) are not examined.
//
// To fix the sketch, store texts in flash (F("…"), PROGMEM), use smaller buffers, and avoid recursion and
// long-lived Strings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/detect/avr/chip_detector.h"
#include "sim/mcu/avr/cpu.h"

namespace robosim::detect::avr {

class StackMargin final : public ChipDetector {
 public:
  explicit StackMargin(const RunningProgram& program);
  ~StackMargin() override;
  StackMargin(const StackMargin&) = delete;
  StackMargin& operator=(const StackMargin&) = delete;

  void visited(std::uint32_t pc, Cycle at) override;
  void entered(int vector, Cycle at) override;
  void left() override;
  std::vector<Detected> found(SimTime) const override;

 private:
  /// The addresses of an instruction and of the calls that led there, the innermost first. Source lines are
  /// looked up only for a finding.
  using Chain = std::vector<std::uint32_t>;
  /// The stack use of a vector's handler.
  struct Handler {
    int bytes = 0;       ///< largest stack use, with the return address; 0 = has not run
    bool nests = false;  ///< the handler enables interrupts
    Chain where;         ///< place of the largest stack use
  };
  /// A running handler.
  struct Open {
    int vector = 0;           ///< 0 = unknown
    std::uint16_t began = 0;  ///< stack pointer before the handler
    std::uint32_t interrupted = 0;
  };
  /// The main program's state when the stack had the least room.
  struct Nearest {
    int room = 0;
    bool has_heap = false;       ///< the heap is nearer than the variables
    std::uint64_t may_come = 0;  ///< interrupts enabled at that time; one bit per vector
    Chain where;
    SimTime at = 0;
  };

  void went_low();
  void pointer_written();
  void look();
  void look_at_main();
  void look_at_handler();
  void await_deeper();
  int heap_end() const;
  Chain here(std::uint32_t until) const;
  SourceLine place(const Chain& chain) const;
  std::string name(int vector) const;

  Machine& machine_;
  const Firmware& firmware_;
  const DebugInfo& debug_;
  robosim::avr::Cpu& cpu_;
  const std::uint32_t main_;                     ///< 0 = unknown
  const std::uint16_t heap_;                     ///< address of the variable with the heap's end; 0 = no heap
  const robosim::avr::Cpu::Call low_, written_;  ///< earlier listeners, which this object calls
  std::vector<Handler> handlers_;                ///< by interrupt vector
  std::vector<Open> open_;                       ///< running handlers, the innermost last
  std::uint64_t ran_ = 0;                        ///< handlers that have run; one bit per vector
  Nearest nearest_;
  bool has_own_stacks_ = false;
};

}  // namespace robosim::detect::avr
