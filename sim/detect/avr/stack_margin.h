// Detects a stack that has too little room if an interrupt occurs at the wrong moment.
//
//   void report() { char line[120]; sprintf(line, …); … }     deepest call of loop(): leaves 20 bytes free
//   ISR(TIMER1_COMPA_vect) { error = kp * read(); }           needs 40 bytes, at any time
//
//   variables | heap -> ...   20 ...  <- stack of the main program
//           40 <------------------- stack of a handler on top
//
// If the two stacks have not coincided in this run, they will by chance, in one of thousands of interrupts.
// The stack then overwrites variables, such as a line's threshold or an object's pointer. Alternatively the
// function returns to an invalid address.
//
// The detector measures the smallest distance between the main program's stack and the variables or heap
// while interrupts are on. From that distance, the detector subtracts the stack use of the deepest handler.
// Handlers do not nest on an AVR, except those that enable interrupts. The stack use of all nesting handlers
// is subtracted, too.
//
// A finding is a remainder of fewer than 16 bytes. A handler may need 16 bytes for a branch that this run has
// not executed: a call (2 or 3 bytes), a few saved registers and one or two local numbers.
//
// Only handlers that have run, and were enabled at the deepest moment, count. Not detected: a handler that is
// enabled only while the main program's stack is less deep; code that has not run; a handler whose stack use
// depends on the state of the main program. Sketches with several stacks (an RTOS) are not examined.
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
  /// An instruction and its open calls, the innermost first. The line is looked up only for a finding.
  using Chain = std::vector<std::uint32_t>;
  /// The stack use of a vector's handler.
  struct Handler {
    int bytes = 0;       ///< largest stack use, including the return address; 0 = never ran
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
    std::uint64_t may_come = 0;  ///< enabled interrupts; one bit per vector
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
  const robosim::avr::Cpu::Call low_, written_;  ///< previous listeners, which are also called
  std::vector<Handler> handlers_;                ///< by vector
  std::vector<Open> open_;                       ///< running handlers, the innermost last
  std::uint64_t ran_ = 0;                        ///< handlers that have run; one bit per vector
  Nearest nearest_;
  bool has_own_stacks_ = false;
};

}  // namespace robosim::detect::avr
