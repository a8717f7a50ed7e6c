// A stack that has room until an interrupt comes at the wrong moment.
//
//   void report() { char line[120]; sprintf(line, …); … }     loop()'s deepest: 20 bytes are left
//   ISR(TIMER1_COMPA_vect) { error = kp * read(); }           takes 40, wherever it comes
//
//   variables | heap -> ...   20 ...  <- stack of the main program
//           40 <------------------- and a handler's on top
//
// Where the two have not met in this run, they will: by chance, one interrupt in thousands. Then variables
// are overwritten, a line's threshold or an object's pointer, or the function returns to nowhere.
//
// Told is, where the main program was next to the variables and the heap as it was then, with interrupts on:
// the bytes that were free there, less those of the handler that took most of the stack. Handlers do not nest
// on an AVR, but for those that enable interrupts again: to their bytes are added those of the deepest other.
// It is told if fewer than 16 remain. That is what a handler takes that takes a branch which this run has not
// seen: a call (2 or 3 bytes), a few saved registers and a number or two of its own.
//
// Looked at are handlers that have run, and were enabled at that moment. What it cannot see: a handler that
// is enabled only while the main program is less deep; code that has not run; that a handler takes so much
// only when the main program has let it. Sketches with stacks of their own (an RTOS) are left out.
//
// Mended by texts in flash (F("…"), PROGMEM), smaller buffers, no recursion, no String that lasts.
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
  /// An instruction, and the calls that were open then, the innermost first; which line that is, is asked
  /// only if there is something to tell.
  using Chain = std::vector<std::uint32_t>;
  /// Of a vector.
  struct Handler {
    int bytes = 0;       ///< the most, its return address included; 0 = it never ran
    bool nests = false;  ///< others may come while it runs
    Chain where;         ///< it took most
  };
  /// A handler that runs.
  struct Open {
    int vector = 0;           ///< 0 = not known
    std::uint16_t began = 0;  ///< the stack pointer as it was before
    std::uint32_t interrupted = 0;
  };
  /// The main program's moment with the least room.
  struct Nearest {
    int room = 0;
    bool has_heap = false;       ///< it is the heap that is next
    std::uint64_t may_come = 0;  ///< interrupts that were enabled there; a bit a vector
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
  const std::uint32_t main_;  ///< 0 = not known
  const std::uint16_t heap_;  ///< the variable that holds the heap's end; 0 = there is no heap
  const robosim::avr::Cpu::Call low_, written_;  ///< who else is told
  std::vector<Handler> handlers_;                ///< by vector
  std::vector<Open> open_;                       ///< the innermost last
  std::uint64_t ran_ = 0;                        ///< a bit a vector
  Nearest nearest_;
  bool has_own_stacks_ = false;
};

}  // namespace robosim::exec::avr
