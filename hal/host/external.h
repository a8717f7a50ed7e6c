// Interrupts by pins (datasheet, chapter 13): INTn, and the pin change interrupts. A Blue Pill has one for
// each pin; those without an INTn come by attachInterrupt alone, under the number of the pin.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

struct ExternalRegisters {
  uint8_t sense = 0;           ///< EICRA: two bits each: 0 low level, 1 any edge, 2 falling, 3 rising
  uint8_t mask = 0;            ///< EIMSK
  uint8_t flags = 0;           ///< EIFR
  uint8_t change_control = 0;  ///< PCICR, bit 0 = port B
  uint8_t change_flags = 0;    ///< PCIFR
  uint8_t change_mask[kChip.change_count] = {};  ///< PCMSKn
  uint8_t low = 0;  ///< no register: those of INTn whose low level interrupts, and lasts
};
extern ExternalRegisters external;

constexpr int kExternals = kChip.external_count;
static_assert(kExternals <= 4, "EICRA has the sense of four");

enum Edge : uint8_t { kAnyEdge = 1, kFalling = 2, kRising = 3 };

/// A bit for each of the board's pins.
struct PinSet {
  uint32_t words[(kPins + 31) / 32] = {};

  bool has(Pin pin) const { return words[pin / 32] >> pin % 32 & 1; }
  bool any() const {
    for (const uint32_t word : words)
      if (word) return true;
    return false;
  }
  void add(Pin pin) { words[pin / 32] |= 1u << pin % 32; }
  void remove(Pin pin) { words[pin / 32] &= ~(1u << pin % 32); }
  /// The lowest pin of both; kNoPin if there is none.
  Pin first_common(const PinSet& other) const {
    int number = 0;
    for (const uint32_t& word : words) {
      const uint32_t both = word & other.words[&word - words];
      if (both) return static_cast<Pin>(number + __builtin_ctz(both));
      number += 32;
    }
    return kNoPin;
  }
};

/// Pins that interrupt on an edge, on boards that have more such pins than INTn.
struct Lines {
  PinSet enabled, flags;
  uint8_t sense[kPins] = {};  ///< Edge
};
extern Lines lines;

/// Whether this pin of the board interrupts through `lines`.
bool has_line(Pin pin);
/// The lowest pin whose flag is raised and enabled, and clears the flag; kNoPin if there is none.
Pin take_line();

/// After a change of the registers: tells the executor which edges matter.
ROBOSIM_RARE void refresh_external();
/// Pins of which they do.
extern PinSet heard;
/// Takes what has reached such pins until now; and what has come of it that one is driven in another way.
void hear();
void drive_changed(Pin pin);
/// An edge has arrived at an input, at that moment.
void external_edge(Pin pin, bool level, SimTime at);
/// The level of a pin that matters, whoever makes it, from a moment on: an edge, if it had the other one.
void hear_level(Pin pin, bool level, SimTime at);
/// The vectors of INTn and pin changes that are raised and enabled, one bit each, and kLines. A low level
/// raises its flag for as long as it lasts.
inline uint32_t pending_external() {
  constexpr uint32_t kAllExternal = (1u << kExternals) - 1, kAllChanges = (1u << kChip.change_count) - 1;
  const uint32_t edges = (external.flags | external.low) & external.mask & kAllExternal;
  const uint32_t changes = external.change_flags & external.change_control & kAllChanges;
  const bool by_line = lines.flags.first_common(lines.enabled) != kNoPin;
  return edges << kExternal0 | changes << kPinChange0 | (by_line ? 1u << kLines : 0u);
}
/// The handler of `vector` starts: edges clear their flag.
void acknowledge_external(int vector);
/// Whether one of them is enabled.
bool external_may_interrupt();

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
