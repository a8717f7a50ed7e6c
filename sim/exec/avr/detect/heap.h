// Detects a heap that grows until it meets the stack, a fragmented heap, and failed allocations.
//
//   log += String(position) + ' ';          each pass of loop(): the text is longer, and so is the heap
//   Motor* m = new Motor(5);                each time, and never deleted
//
// The chip has 2 KB. Growth in each pass fills them in a minute, but not on the bench. Then malloc() fails, a
// String silently becomes empty, and `new` returns a null pointer. Or the stack grows into the heap, and a
// function returns to nowhere. A freed block leaves a hole between used ones, which serves only for
// allocations of at most its size. So a fragmented heap (strings of many lengths, some freed, some not) grows
// although enough is free.
//
//   heap_grows      in each third of the run, without its first second, the heap's end has risen several
//                   times
//   heap_in_pieces  after the first second, and without heap_grows: the end has risen three times although
//                   the requested number of bytes was free, in pieces each of which was too small
//   no_memory       malloc() or realloc() has failed; reports whether fragmentation was the reason
//
// Not detected: a heap that rises by an occasional step; pieces that a small object will soon need.
//
// Fix it by printing text without storing it, or by a buffer of fixed size (char line[32]). One reserve() in
// setup() helps, too, as do objects that are created once.
//
// avr-libc stores the free pieces in a list, `__flp`. Each has its size, then the address of the next one
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
    std::uint16_t sp = 0;  ///< after the return
    std::uint16_t bytes = 0;
  };
  /// The free pieces below the heap's end.
  struct Pieces {
    int count = 0, bytes = 0, largest = 0;
  };
  /// A rise of the heap's end.
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
  std::vector<std::uint32_t> returns_;    ///< addresses to which they return
  std::optional<Asked> asked_;            ///< from the outer of the two
  std::vector<Growth> growths_;
  SourceLine grown_at_;                ///< last time
  std::optional<Detected> in_pieces_;  ///< the worst rise for that reason, and their number
  int worst_bytes_ = 0;                ///< bytes that were free at that rise
  Sightings seen_;
};

}  // namespace robosim::exec::avr
