// Detects a stack that has enough room only until an interrupt comes at the wrong moment.
//
//   void report() { char line[120]; sprintf(line, …); … }     loop()'s deepest: 20 bytes are left
//   ISR(TIMER1_COMPA_vect) { error = kp * read(); }           takes 40, wherever it comes
//
//   variables | heap -> ...   20 ...  <- stack of the main program
//           40 <------------------- and a handler's on top
//
// If the two have not met in this run, they will: by chance, one interrupt in thousands. Then variables are
// overwritten, such as a line's threshold or an object's pointer, or the function returns to nowhere.
//
// The detector measures the smallest distance of the main program's stack to variables and heap, with
// interrupts on. From these free bytes, the stack use of the deepest handler is subtracted. Handlers do not
// nest on an AVR, except those that enable interrupts: they count together with the deepest other one.
//
// A finding is a rest of fewer than 16 bytes. A handler may need 16 bytes for a branch which this run has not
// executed: for a call (2 or 3 bytes), a few saved registers and one or two local numbers.
//
// Only handlers that have run, and were enabled at that moment, count. Not detected: a handler that is
// enabled only while the main program is less deep; code that has not run. Nor a handler whose stack use
// depends on the state of the main program. Sketches with several stacks (an RTOS) are not examined.
//
// Fix it by texts in flash (F("…"), PROGMEM), smaller buffers, and without recursion and long-lived Strings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/avr/cpu.h"
#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

class StackMargin final : public Detector {
 public:
  StackMargin(Machine& machine, const Program& program);
  ~StackMargin() override;
  StackMargin(const StackMargin&) = delete;
  StackMargin& operator=(const StackMargin&) = delete;

  void visited(std::uint32_t pc, Cycle at) override;
  void entered(int vector, Cycle at) override;
  void left() override;
  std::vector<Detected> found() const override;

 private:
  /// An instruction, and the calls that were open then, the innermost first. Its line is looked up only for a
  /// finding.
  using Chain = std::vector<std::uint32_t>;
  /// The handler of a vector.
  struct Handler {
    int bytes = 0;       ///< the most, including its return address; 0 = it never ran
    bool nests = false;  ///< it enables interrupts
    Chain where;         ///< where it took most
  };
  /// A handler that runs.
  struct Open {
    int vector = 0;           ///< 0 = unknown
    std::uint16_t began = 0;  ///< the stack pointer before it
    std::uint32_t interrupted = 0;
  };
  /// The main program's moment with the least room.
  struct Nearest {
    int room = 0;
    bool has_heap = false;       ///< the heap is nearest, not the variables
    std::uint64_t may_come = 0;  ///< interrupts that were enabled there; one bit per vector
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
  const std::uint32_t main_;  ///< 0 = unknown
  const std::uint16_t heap_;  ///< the variable that holds the heap's end; 0 = there is no heap
  const robosim::avr::Cpu::Call low_, written_;  ///< previous listeners, called as well
  std::vector<Handler> handlers_;                ///< by vector
  std::vector<Open> open_;                       ///< the innermost last
  std::uint64_t ran_ = 0;                        ///< one bit per vector
  Nearest nearest_;
  bool has_own_stacks_ = false;
};

}  // namespace robosim::exec::avr
