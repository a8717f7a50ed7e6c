// A heap that grows until it meets the stack, one that lies in pieces, and memory that was not there.
//
//   log += String(position) + ' ';          each pass of loop(): the text is longer, and so is the heap
//   Motor* m = new Motor(5);                each time, and nobody gives it back
//
// The chip has 2 KB. What grows with each pass fills them in a minute, not on the bench: then malloc() finds
// nothing, a String silently becomes empty, `new` gives a null pointer; or the stack grows into the heap and
// returns to nowhere. What is given back leaves a hole between what is kept, and serves only for what is no
// larger: a heap in pieces (String s of many lengths, some kept and some not) grows though enough is free.
//
//   heap_grows      in each third of the run, the first second aside, the heap's end has moved on, again and
//                   again
//   heap_in_pieces  the first second aside, and without heap_grows, its end has moved on three times though
//                   as many bytes as were asked for were free, in pieces each of which was too small
//   no_memory       malloc() or realloc() has given nothing; and whether it was for that reason
//
// What it cannot see: a heap that grows by a step now and then; pieces that something small will need soon.
//
// Mended by text that is printed, not kept; a buffer of fixed size (char line[32]); reserve() once, in
// setup(); objects that are made once.
//
// avr-libc keeps the free pieces in a list, `__flp`: of each its bytes, then where the next one is
// (avr-libc's stdlib_private.h, struct __freelist).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"

namespace robosim::exec::avr {

class Heap final : public Detector {
 public:
  Heap(Machine& machine, const Firmware& firmware, WhereNow where);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found() const override;

 private:
  struct Asked {
    std::uint32_t returns_to = 0;
    std::uint16_t sp = 0;  ///< behind the return
    std::uint16_t bytes = 0;
  };
  /// What is free below the heap's end.
  struct Pieces {
    int count = 0, bytes = 0, largest = 0;
  };
  /// The heap's end has moved on.
  struct Growth {
    SimTime at = 0;
    std::uint16_t end = 0;
  };

  std::uint16_t word(reg::Address at) const;
  void asked(std::uint16_t bytes);
  void answered();
  Pieces pieces() const;
  void note_pieces(int asked, int end);
  std::optional<Detected> growth() const;

  Machine& machine_;
  const WhereNow where_;
  const std::uint32_t malloc_, realloc_;  ///< 0 = there is none
  const std::uint16_t end_;               ///< the variable that holds the heap's end
  const std::uint16_t free_;              ///< the one that holds the first free piece
  std::vector<std::uint32_t> returns_;    ///< places where they come back to
  std::optional<Asked> asked_;            ///< by the outer of the two
  std::vector<Growth> growths_;
  SourceLine grown_at_;                ///< last
  std::optional<Detected> in_pieces_;  ///< the worst time that it grew for that reason, and how often
  int worst_bytes_ = 0;                ///< that were free then
  Sightings seen_;
};

}  // namespace robosim::exec::avr
