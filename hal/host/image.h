// The interface between a firmware image and its executor; nothing else crosses it.
//
// An image is a shared object: sketch, libraries, Arduino core and hal/host. It exports one symbol,
// `robosim_image`. The executor loads it from a private copy and runs `Image::run` on a fiber. Both share a
// FirmwareState of plain words, which are read in every tick.
//
//   executor                                  firmware, on its fiber
//   limit = t; next_input = …; resume  ──►    runs; its clock `now` advances with all that it does
//                                      ◄──    now >= limit: wake = its next activity; Host::yield()
//
// A firmware that waits until `wake` need not be resumed earlier, unless there is input.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "hal/board/firmware_port.h"

namespace robosim {
namespace host {

/// Version of these declarations. Increment it with every change; an image of another version is refused.
constexpr uint32_t kImageVersion = 16;

/// An input that reaches the chip from outside, whether or not firmware is reading.
struct Input {
  enum class Kind : uint8_t { edge, byte };
  Kind kind = Kind::edge;
  Pin pin = kNoPin;   ///< of an edge
  uint8_t value = 0;  ///< level after the edge, or the byte received
  SimTime at = 0;
};

/// gcc's AddressSanitizer record of a global variable.
struct GlobalRecord {
  uintptr_t begin;
  uintptr_t bytes;
  uintptr_t bytes_with_gap;
  const char* name;
  const char* source;
  uintptr_t constructed;
  const void* place;
  uintptr_t indicator;
};

/// An access that an address check has stopped.
struct BadAccess {
  uintptr_t address = 0;
  size_t bytes = 0;
  bool write = false;
  uintptr_t first = 0;  ///< the first address in there that must not be accessed
  uint8_t mark = 0;     ///< the value of its shadow; 0: it belongs to no object of the sketch
  uintptr_t block = 0;  ///< the block of the heap that holds or precedes the address; 0 = none
  size_t block_bytes = 0;
};

/// The services of the executor. All calls come from the fiber.
class Host {
 public:
  /// Called when firmware has reached its limit; returns when it may continue, with a later limit.
  virtual void yield() = 0;
  /// During FirmwareState::watched: called when a basic block begins. All state of its function and its
  /// callers is on the stack from `stack` on, and in the image's variables.
  virtual void block_begins(const uint8_t* stack) = 0;
  /// Stores variables, heap, and the stack as in block_begins(); and whether they were equal then.
  virtual void take_state(const uint8_t* stack) = 0;
  virtual bool has_state(const uint8_t* stack) = 0;
  /// Returns until when, exclusive, reads of `pin` surely equal the present one; `now` = unknown.
  virtual SimTime same_until(Pin pin, SimTime now) = 0;
  /// Takes the earliest input at or before `until`; returns false if there is none. Updates
  /// FirmwareState::next_input.
  virtual bool take_input(SimTime until, Input& input) = 0;
  /// Starts or stops to deliver edges on `pin` as input, from `now` on. Returns its present level.
  virtual bool want_edges(Pin pin, bool wanted, SimTime now) = 0;
  /// Turns on the UART's receiver, with `byte_time` for each byte; 0 turns it off, and bytes are lost.
  virtual void listen(SimTime byte_time, SimTime now) = 0;
  /// Reports that firmware cannot continue; does not return. `file` may be null; then `where`, a code
  /// address, is the place.
  virtual void crash(const char* reason, const char* file, uint32_t line, const void* where) = 0;
  /// Resets the chip by the watchdog; does not return.
  virtual void bite() = 0;
  /// Reports a failed check of gcc's UndefinedBehaviorSanitizer; does not return. `check` is its handler's
  /// name without "__ubsan_handle_"; `data` and the values are the handler's arguments from gcc.
  virtual void undefined(const char* check, const void* data, uintptr_t value, uintptr_t other,
                         const void* where) = 0;
  /// Reports that firmware is about to divide by zero, and continues as on the chip. `data` as above.
  virtual void divides_by_zero(const void* data, const void* where) = 0;
  /// Reports that firmware uses a feature of the chip that the image lacks; its behaviour then differs from
  /// the chip's. `what` is a literal with the sketch's name for it: "CLKPR".
  virtual void lacks(const char* what, const void* where) = 0;
  /// For an image with address checks: passes `count` records of gcc's AddressSanitizer on global variables.
  virtual void globals(const GlobalRecord* records, size_t count) = 0;
  /// For such an image: reports an access to memory that the sketch may not access; does not return.
  virtual void bad_access(const BadAccess& access, const void* where) = 0;

 protected:
  ~Host() = default;
};

/// A call of the Arduino API, stored cheaply: `name` is a literal.
struct ApiCall {
  const char* name = "";  ///< "digitalRead", or a register's name: "PORTB"
  int32_t argument[2] = {0, 0};
  int8_t arguments = 0;  ///< the number of stored ones; -1: not a function, written without parentheses
  Pin pin = kNoPin;
};

/// A simulated slowdown of the firmware: for `by` it only serves interrupts. This happens once, at the first
/// place after `from`: before setup(), at the end of a loop() or at the beginning of a delay(). If `by` is
/// negative, the next delay() is that much shorter.
struct Lateness {
  SimTime from = kNever;
  SimTime by = 0;
};

struct FirmwareState {
  // The executor's:
  SimTime limit = 0;            ///< firmware stops here, ns
  SimTime next_input = kNever;  ///< when the next input arrives
  uint8_t* heap = nullptr;      ///< the arena of malloc
  size_t heap_bytes = 0;
  uint8_t* stack = nullptr;  ///< the stack of the fiber
  size_t stack_bytes = 0;
  const Lateness* lateness = nullptr;  ///< the next; the last one is at kNever
  SimTime late_from = kNever;          ///< its beginning
  bool watched = false;                ///< Host::block_begins() must be called
  bool may_skip = true;                ///< rounds that only wait may be skipped (polling.h)
  bool called_up = false;              ///< it must run to `limit`, although it only waits
  // The firmware's:
  SimTime now = 0;                   ///< its clock
  SimTime wake = 0;                  ///< at a yield: time of the firmware's next own action
  const void* place = nullptr;       ///< return address in the last basic block, or of the last API call
  SimTime last_call = 0;             ///< last call of the API outside interrupt handlers
  ApiCall call;                      ///< that call
  Pin read_pin = kNoPin;             ///< of the last digital read outside interrupt handlers
  SimTime read_at = 0;               ///< when that was
  bool waiting = false;              ///< inside that call (delay, a full Serial buffer, ...)
  bool polls = false;                ///< at a yield: it repeats rounds without changes until `wake`,
  bool polls_by_calls = false;       ///< and those rounds call the API
  size_t heap_used = 0;              ///< bytes of the arena up to the highest that malloc has returned so far
  bool touched = true;               ///< more than queries has happened since the executor cleared this
  bool endless = false;              ///< in a loop without any block
  const char* stopped_by = nullptr;  ///< "exit(0)" once firmware has stopped itself
};

/// Receives the counters of a sketch that was built for coverage.
class CounterSink {
 public:
  /// Begins a file (.gcda, as gcov reads it).
  virtual void begin(const char* file) = 0;
  virtual void add(const void* bytes, size_t count) = 0;

 protected:
  ~CounterSink() = default;
};

struct Image {
  uint32_t version;  ///< kImageVersion
  FirmwareState* state;
  /// Runs constructors, init(), setup(), then loop() for ever. Starts at `now`. Never returns.
  void (*run)(FirmwarePort& board, Host& host, SimTime now);
  /// Address checks: the byte at `address` / 8 + shadow defines which of 8 bytes are accessible
  /// (addresses.h). The value 0 means no checks; else its executor maps the shadow of [begin, end), heap and
  /// stack.
  uintptr_t shadow;
  const void* begin;
  const void* end;
  /// Variables of the core that change by themselves, and that sketches see only through calls; or that never
  /// change.
  const char* clockwork_begin;
  const char* clockwork_end;
  /// Variables of the core that do not change unless FirmwareState::touched.
  const char* settings_begin;
  const char* settings_end;
  /// Returns whether an interrupt is enabled that may occur even if firmware calls nothing. Those of the
  /// core's clock and its Serial do not count. `held_back` includes those that a clear I flag blocks, as in
  /// handlers and where firmware reads what handlers write. Call it outside the fiber, as the next one.
  bool (*may_interrupt)(bool held_back);
  /// Passes the counts since the start; may be called at any time outside the fiber. Null: the image was not
  /// built for coverage.
  void (*counters)(CounterSink& sink);
};

}  // namespace host
}  // namespace robosim

/// The only symbol that an image exports.
extern "C" __attribute__((visibility("default"))) const robosim::host::Image robosim_image;
