// Detects a heap that grows until it reaches the stack, a fragmented heap, and failed allocations.
//
//   log += String(position) + ' ';          each pass of loop() makes the text longer, and the heap larger
//   Motor* m = new Motor(5);                runs in each pass; the object is never deleted
//
// The chip has 2 KB of RAM. Growth in each pass fills the RAM within a minute, although not in a short test
// on the bench. Then malloc() fails, a String silently becomes empty, and `new` returns a null pointer.
// Alternatively the stack grows into the heap, and a function returns to an invalid address. A freed block
// leaves a hole between used blocks. Only allocations of at most its size fit into the hole. A fragmented
// heap (strings of many lengths, some freed, some not) therefore grows although enough bytes are free.
//
//   heap_grows      after the first second, the heap's end has risen three times in each third of the run, by
//                   at least 8 bytes in each third
//   heap_in_pieces  only without heap_grows. After the first second, the heap's end has risen three times
//                   although enough bytes were free, because each free piece was too small
//   no_memory       malloc() or realloc() has failed; reports whether fragmentation was the reason
//
// A heap that grows only rarely is not detected. Reported fragmentation may be harmless, because small
// objects may soon fill the free pieces.
//
// To fix the sketch, print text without storing it, or use a buffer of fixed size (char line[32]). One
// reserve() in setup(), and objects that are created only once, also help.
//
// avr-libc stores the free pieces in a list, `__flp`. Each piece contains its size, then the address of the
// next piece (avr-libc's stdlib_private.h, struct __freelist).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/detect/avr/chip_detector.h"

namespace robosim::detect::avr {

class Heap final : public ChipDetector {
 public:
  explicit Heap(const RunningProgram& program);

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found(SimTime) const override;

 private:
  struct Asked {
    std::uint32_t returns_to = 0;
    std::uint16_t sp = 0;  ///< stack pointer after the return
    std::uint16_t bytes = 0;
  };
  /// The free pieces below the heap's end, in bytes.
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

  const RunningProgram program_;
  Machine& machine_;
  const std::uint32_t malloc_, realloc_;  ///< addresses of the functions; 0 = missing
  const std::uint16_t end_;               ///< address of the variable with the heap's end
  const std::uint16_t free_;              ///< address of the variable with the first free piece
  std::vector<std::uint32_t> returns_;    ///< addresses to which the functions return
  std::optional<Asked> asked_;            ///< open request of the sketch to malloc() or realloc()
  std::vector<Growth> growths_;
  SourceLine grown_at_;                ///< source line of the last growth
  std::optional<Detected> in_pieces_;  ///< worst growth by fragmentation, with the number of growths
  int worst_bytes_ = 0;                ///< free bytes at the worst growth
  Sightings seen_;
};

}  // namespace robosim::detect::avr
