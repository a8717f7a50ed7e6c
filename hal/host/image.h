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
  uint8_t mark = 0;     ///< what its shadow holds; 0: it belongs to nothing of the sketch
  uintptr_t block = 0;  ///< the block of the heap that the address is in or behind; 0 = none
  size_t block_bytes = 0;
};

/// The services of the executor. All calls come from the fiber.
class Host {
 public:
  /// Firmware has reached its limit; returns when it may go on, with a later limit.
  virtual void yield() = 0;
  /// While FirmwareState::watched: a basic block begins. All that its function and its callers keep lies on
  /// the stack from `stack` on, and in the image's variables.
  virtual void block_begins(const uint8_t* stack) = 0;
  /// Keeps variables, heap, and the stack as in block_begins(); and whether they are as they were then.
  virtual void take_state(const uint8_t* stack) = 0;
  virtual bool has_state(const uint8_t* stack) = 0;
  /// Until when, exclusive, reads of `pin` surely give what they give now; `now` = nobody knows.
  virtual SimTime same_until(Pin pin, SimTime now) = 0;
  /// The earliest input at or before `until`; false if there is none. Updates FirmwareState::next_input.
  virtual bool take_input(SimTime until, Input& input) = 0;
  /// Edges on `pin` shall arrive as input from `now` on, where its level is what this returns; or no longer.
  virtual bool want_edges(Pin pin, bool wanted, SimTime now) = 0;
  /// The UART's receiver listens, and a byte takes `byte_time`; 0 = it does not listen, bytes are lost.
  virtual void listen(SimTime byte_time, SimTime now) = 0;
  /// Firmware can run no further; does not return. `file` may be null, then `where`, a code address, tells
  /// the place.
  virtual void crash(const char* reason, const char* file, uint32_t line, const void* where) = 0;
  /// The watchdog resets the chip; does not return.
  virtual void bite() = 0;
  /// A check of gcc's UndefinedBehaviorSanitizer has failed; does not return. `check` is its handler's name
  /// without "__ubsan_handle_"; `data` and the values are what gcc hands to that.
  virtual void undefined(const char* check, const void* data, uintptr_t value, uintptr_t other,
                         const void* where) = 0;
  /// Firmware is about to divide by zero, and goes on as on the chip. `data` as above.
  virtual void divides_by_zero(const void* data, const void* where) = 0;
  /// Firmware uses something of the chip that the image lacks; what it does then is not what the chip does.
  /// `what` is a literal, as a sketch names it: "CLKPR".
  virtual void lacks(const char* what, const void* where) = 0;
  /// Of an image with address checks: `count` records of gcc's AddressSanitizer on global variables.
  virtual void globals(const GlobalRecord* records, size_t count) = 0;
  /// Of such an image: an access to memory that is not the sketch's to access; does not return.
  virtual void bad_access(const BadAccess& access, const void* where) = 0;

 protected:
  ~Host() = default;
};

/// A call of the Arduino API, stored cheaply: `name` is a literal.
struct ApiCall {
  const char* name = "";  ///< "digitalRead", or a register's name: "PORTB"
  int32_t argument[2] = {0, 0};
  int8_t arguments = 0;  ///< how many of them count; -1: not a function, written without parentheses
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
  uint8_t* stack = nullptr;  ///< the fiber's
  size_t stack_bytes = 0;
  const Lateness* lateness = nullptr;  ///< the next; the last one is at kNever
  SimTime late_from = kNever;          ///< its beginning
  bool watched = false;                ///< Host::block_begins() is wanted
  bool may_skip = true;                ///< rounds in which it only waits may be left out (polling.h)
  bool called_up = false;              ///< it shall come to `limit`, though it only waits
  // The firmware's:
  SimTime now = 0;                   ///< its clock
  SimTime wake = 0;                  ///< at a yield: when firmware next does something by itself
  const void* place = nullptr;       ///< return address in the basic block, or of the API call, that ran last
  SimTime last_call = 0;             ///< when the API was last called outside interrupt handlers
  ApiCall call;                      ///< that call
  Pin read_pin = kNoPin;             ///< of the last digital read outside interrupt handlers
  SimTime read_at = 0;               ///< when that was
  bool waiting = false;              ///< inside that call (delay, a full Serial buffer, ...)
  bool polls = false;                ///< at a yield: it goes rounds that change nothing until `wake`,
  bool polls_by_calls = false;       ///< in which it calls the API
  size_t heap_used = 0;              ///< bytes of the arena that malloc has ever given, with all before them
  bool touched = true;               ///< more has been done than to ask, since the executor cleared this
  bool endless = false;              ///< in a loop without any block
  const char* stopped_by = nullptr;  ///< "exit(0)" once firmware gave up by itself
};

/// Receives the counters of a sketch that was built for coverage.
class CounterSink {
 public:
  /// From here on it is about this file (.gcda, as gcov reads it).
  virtual void begin(const char* file) = 0;
  virtual void add(const void* bytes, size_t count) = 0;

 protected:
  ~CounterSink() = default;
};

struct Image {
  uint32_t version;  ///< kImageVersion
  FirmwareState* state;
  /// Constructors, init(), setup(), then loop() for ever. Starts at `now`. Never returns.
  void (*run)(FirmwarePort& board, Host& host, SimTime now);
  /// Address checks: the byte at `address` / 8 + shadow says of 8 bytes how many may be accessed. 0 = the
  /// image has none; else its executor maps the shadow of [begin, end), heap and stack.
  uintptr_t shadow;
  const void* begin;
  const void* end;
  /// Variables of the core that go on by themselves, and that sketches see through calls alone; or that never
  /// change.
  const char* clockwork_begin;
  const char* clockwork_end;
  /// Variables of the core that stay as they are unless FirmwareState::touched.
  const char* settings_begin;
  const char* settings_end;
  /// Whether an interrupt is enabled, other than those of the core's clock and its Serial, that may come
  /// though firmware calls nothing; or would be, were the I flag set, with `held_back`. It is clear in
  /// handlers and where firmware reads what handlers write. To be called outside the fiber, as is the next.
  bool (*may_interrupt)(bool held_back);
  /// Gives what has been counted since the start; may be called at any time outside the fiber. Null: the
  /// image was not built for coverage.
  void (*counters)(CounterSink& sink);
};

}  // namespace host
}  // namespace robosim

/// The only symbol that an image exports.
extern "C" __attribute__((visibility("default"))) const robosim::host::Image robosim_image;
