// Interrupts by pins (datasheet, chapter 13): INT0 and INT1 on pins 2 and 3, and the three pin change
// interrupts. A Blue Pill has one for each pin; those of 4 and up come by attachInterrupt alone.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host {

struct ExternalRegisters {
  uint8_t sense = 0;                   ///< EICRA: two bits each: 0 low level, 1 any edge, 2 falling, 3 rising
  uint8_t mask = 0;                    ///< EIMSK
  uint8_t flags = 0;                   ///< EIFR
  uint8_t change_control = 0;          ///< PCICR, bit 0 = port B
  uint8_t change_flags = 0;            ///< PCIFR
  uint8_t change_mask[3] = {0, 0, 0};  ///< PCMSK0..2: ports B, C, D
};
extern ExternalRegisters external;

enum Edge : uint8_t { kAnyEdge = 1, kFalling = 2, kRising = 3 };

/// Pins that interrupt on an edge, on boards that have more such pins than INT0 and INT1.
struct Lines {
  uint32_t enabled = 0, flags = 0;  ///< one bit each pin
  uint8_t sense[kMostPins] = {};    ///< Edge
};
extern Lines lines;

/// Whether this pin of the board interrupts through `lines`.
bool has_line(Pin pin);
/// The lowest pin whose flag is raised and enabled, and clears the flag; kNoPin if there is none.
Pin take_line();

/// After a change of the registers: tells the executor which edges matter.
void refresh_external();
/// An edge has arrived.
void external_edge(Pin pin, bool level);
/// Vectors 1..5 that are raised and enabled, one bit each, and kLines. A low level raises its flag for as
/// long as it lasts.
uint32_t pending_external();
/// The handler of vector `number` starts: edges clear their flag.
void acknowledge_external(int number);
void reset_external();

}  // namespace host
}  // namespace robosim
