// Models external interrupts on the host (data sheet, chapter 13): INTn and pin change interrupts. On a Blue
// Pill, every pin can cause an interrupt. A pin without an INTn causes interrupts only after
// attachInterrupt().
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

struct ExternalRegisters {
  uint8_t sense = 0;           ///< EICRA, two bits per INTn: 0 low level, 1 any edge, 2 falling, 3 rising
  uint8_t mask = 0;            ///< EIMSK
  uint8_t flags = 0;           ///< EIFR
  uint8_t change_control = 0;  ///< PCICR, bit 0 = port B
  uint8_t change_flags = 0;    ///< PCIFR
  uint8_t change_mask[kChip.change_count] = {};  ///< PCMSKn
  uint8_t low = 0;  ///< INTn with sense 0 whose level is low, one bit each; not a register of the chip
};
extern ExternalRegisters external;

constexpr int kExternals = kChip.external_count;
static_assert(kExternals <= 4, "EICRA has the sense of four");

enum Edge : uint8_t { kAnyEdge = 1, kFalling = 2, kRising = 3 };

/// A set of the board's pins, one bit each.
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
  /// Returns the lowest pin that is in both sets, or kNoPin if there is no such pin.
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

/// The interrupts of pins without an INTn, for boards with more interrupt pins than INTn.
struct Lines {
  PinSet enabled, flags;
  uint8_t sense[kPins] = {};  ///< an Edge for each pin
};
extern Lines lines;

/// Returns whether this pin can cause an interrupt by `lines`.
bool has_line(Pin pin);
/// Clears the lowest flag of `lines` that is raised and enabled. Returns its pin, or kNoPin without such a
/// flag.
Pin take_line();

/// Requests from the executor the edges that can cause an interrupt, a count or a capture. Call this function
/// after a change of the registers above.
ROBOSIM_RARE void refresh_external();
/// The pins whose edges are requested.
extern PinSet heard;
/// Handles the edges that have reached pins in `heard` until now. Call it before a change of a pin's drive.
void hear();
/// Handles the edge that a change of the pin's drive may have caused. Call it after the change.
void drive_changed(Pin pin);
/// Handles an edge that arrived at an input at the time `at`.
void external_edge(Pin pin, bool level, SimTime at);
/// Handles the level that a pin in `heard` has from `at` on, as an input or as an output. A change of level
/// is an edge.
void hear_level(Pin pin, bool level, SimTime at);
/// Returns the external interrupts that are raised and enabled, one bit per vector: INTn, pin changes, and
/// kLines. A low level on INTn, if selected, keeps its interrupt raised as long as the level lasts.
inline uint32_t pending_external() {
  constexpr uint32_t kAllExternal = (1u << kExternals) - 1, kAllChanges = (1u << kChip.change_count) - 1;
  const uint32_t edges = (external.flags | external.low) & external.mask & kAllExternal;
  const uint32_t changes = external.change_flags & external.change_control & kAllChanges;
  const bool by_line = lines.flags.first_common(lines.enabled) != kNoPin;
  return edges << kExternal0 | changes << kPinChange0 | (by_line ? 1u << kLines : 0u);
}
/// Clears the flag of an edge when the handler of `vector` starts.
void acknowledge_external(int vector);
/// Returns whether any external interrupt is enabled.
bool external_may_interrupt();

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
