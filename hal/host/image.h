// The complete interface between a firmware image and its executor.
//
// An image is a shared object: sketch, libraries, Arduino core and hal/host. It exports one symbol,
// `robosim_image`. The executor loads a private copy of the image, and runs `Image::run` on a fiber. Image
// and executor share a FirmwareState, which consists of plain words.
//
//   executor                                  firmware, on its fiber
//   limit = t; next_input = …; resume  ──►    runs; its clock `now` advances with every action
//                                      ◄──    now >= limit: wake = time of its next action; Host::yield()
//
// The executor need not resume the firmware before `wake`, unless an input arrives.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "hal/board/firmware_action.h"
#include "hal/board/firmware_port.h"
#include "hal/board/input_reads.h"

namespace robosim {
namespace host {

/// The version of these declarations. Increment the version with every change. An image of another version is
/// rejected.
constexpr uint32_t kImageVersion = 19;

/// An input that reaches the chip from outside without a read by firmware.
struct Input {
  enum class Kind : uint8_t { edge, byte };
  Kind kind = Kind::edge;
  Pin pin = kNoPin;   ///< pin of the edge
  uint8_t value = 0;  ///< level after the edge, or the byte received
  SimTime at = 0;
};

/// A record that describes a global variable. gcc's AddressSanitizer generates these records.
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

/// An access that an address check has rejected.
struct BadAccess {
  uintptr_t address = 0;
  size_t bytes = 0;
  bool write = false;
  uintptr_t first = 0;  ///< first forbidden address of the access
  uint8_t mark = 0;     ///< shadow byte of `first`; 0 = the address belongs to no object of the sketch
  uintptr_t block = 0;  ///< heap block that contains or precedes `first`; 0 = none
  size_t block_bytes = 0;
};

/// The services of the executor. All functions are called on the firmware's fiber.
class Host {
 public:
  /// Suspends firmware that has reached its limit. Returns when the firmware may continue, with a later
  /// limit.
  virtual void yield() = 0;
  /// Reports the beginning of a basic block while FirmwareState::watched is set. All state of the running
  /// functions is on the stack from `stack` on, and in the image's variables.
  virtual void block_begins(const uint8_t* stack) = 0;
  /// Store variables, heap, and the stack from `stack` on, or return whether they equal the stored state.
  virtual void take_state(const uint8_t* stack) = 0;
  virtual bool has_state(const uint8_t* stack) = 0;
  /// Returns the time before which reads of `pin` certainly return the present level; `now` = unknown.
  virtual SimTime same_until(Pin pin, SimTime now) = 0;
  /// Moves the earliest input at or before `until` to `input`. Returns false if there is no such input.
  /// Updates FirmwareState::next_input.
  virtual bool take_input(SimTime until, Input& input) = 0;
  /// Starts or stops the delivery of edges on `pin` by take_input(), from `now` on. Returns the pin's present
  /// level if the delivery starts, else false.
  virtual bool want_edges(Pin pin, bool wanted, SimTime now) = 0;
  /// Turns the UART's receiver on; each byte lasts `byte_time`. A `byte_time` of 0 turns the receiver off, so
  /// that arriving bytes are lost.
  virtual void listen(SimTime byte_time, SimTime now) = 0;
  /// Reports that firmware cannot continue; does not return. If `file` is null, the code address `where`
  /// identifies the source line.
  virtual void crash(const char* reason, const char* file, uint32_t line, const void* where) = 0;
  /// Resets the chip on behalf of the watchdog; does not return.
  virtual void bite() = 0;
  /// Reports a failed check of gcc's UndefinedBehaviorSanitizer; does not return. `check` is the handler's
  /// name without "__ubsan_handle_"; `data`, `value` and `other` are the handler's arguments.
  virtual void undefined(const char* check, const void* data, uintptr_t value, uintptr_t other,
                         const void* where) = 0;
  /// Reports that firmware is about to divide by zero. The firmware then continues with the chip's result.
  /// `data` is the argument of the sanitizer's handler, or null.
  virtual void divides_by_zero(const void* data, const void* where) = 0;
  /// Reports the use of a chip feature that the image does not simulate. Firmware may then behave differently
  /// than on the chip. `what` is a string literal with the usual name of the feature: "CLKPR".
  virtual void lacks(const char* what, const void* where) = 0;
  /// Reports an action that may be a mistake. The firmware then continues as the chip does.
  virtual void acted(const FirmwareAction& action) = 0;
  /// Passes `count` records of global variables. Only images with address checks call this function.
  virtual void globals(const GlobalRecord* records, size_t count) = 0;
  /// Reports an access that an address check has rejected; does not return. Only images with address checks
  /// call this function.
  virtual void bad_access(const BadAccess& access, const void* where) = 0;

 protected:
  ~Host() = default;
};

/// A call of the Arduino API. `name` is a string literal, so that storing a call is cheap.
struct ApiCall {
  const char* name = "";  ///< "digitalRead", or a register's name: "PORTB"
  int32_t argument[2] = {0, 0};
  int8_t arguments = 0;  ///< number of stored arguments; -1 = access to a register
  Pin pin = kNoPin;
};

/// A simulated slowdown of the firmware. For the time `by`, the firmware only serves interrupts. This happens
/// once, at the first of these moments after `from`: before setup(), at the end of a loop(), at the beginning
/// of a delay(). If `by` is negative, the next delay() is shorter by -`by`.
struct Lateness {
  SimTime from = kNever;
  SimTime by = 0;
};

struct FirmwareState {
  // Written by the executor:
  SimTime limit = 0;            ///< time at which firmware must yield, in ns
  SimTime next_input = kNever;  ///< time of the next input
  uint8_t* heap = nullptr;      ///< arena of malloc()
  size_t heap_bytes = 0;
  uint8_t* stack = nullptr;  ///< stack of the fiber
  size_t stack_bytes = 0;
  const Lateness* lateness = nullptr;  ///< next entry; the last entry is at kNever
  SimTime late_from = kNever;          ///< `from` of that entry
  bool watched = false;                ///< Host::block_begins() must be called
  bool may_skip = true;                ///< rounds in which firmware only waits may be skipped (polling.h)
  bool called_up = false;              ///< firmware must run to `limit`, even if it only waits
  // Written by the firmware:
  SimTime now = 0;                   ///< firmware's clock
  SimTime wake = 0;                  ///< at a yield: time of the firmware's next action
  const void* place = nullptr;       ///< code address in the last basic block, or after the last API call
  SimTime last_call = 0;             ///< time of the last API call outside interrupt handlers
  ApiCall call;                      ///< that call
  InputReads reads;                  ///< last reads of inputs by the API
  SimTime read_at = 0;               ///< time of the last digital read outside interrupt handlers
  bool waiting = false;              ///< an API call is waiting (delay(), a full Serial buffer, …)
  bool polls = false;                ///< at a yield: firmware repeats the same round until `wake` (polling.h)
  bool polls_by_calls = false;       ///< at such a yield: the round calls the API
  size_t heap_used = 0;              ///< bytes from the arena's start to the highest end of a block so far
  bool touched = true;               ///< firmware did more than queries since the executor cleared this flag
  bool endless = false;              ///< firmware is in an endless loop that has no basic block
  const char* stopped_by = nullptr;  ///< "exit(0)" once the firmware has stopped itself
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
  /// Runs constructors, init() and setup(), then loop() repeatedly. Starts at `now` and never returns.
  void (*run)(FirmwarePort& board, Host& host, SimTime now);
  /// The offset of the shadow memory for address checks; 0 = no checks. The byte at `address` / 8 + `shadow`
  /// defines which of 8 bytes are accessible (addresses.h). The executor maps the shadow memory of the image
  /// ([begin, end)), the heap and the stack.
  uintptr_t shadow;
  const void* begin;
  const void* end;
  /// The bounds of core variables that do not count as firmware state (Host::take_state()). These variables
  /// are constant, or change without an action of the sketch. Sketches see their values only through calls.
  const char* clockwork_begin;
  const char* clockwork_end;
  /// The bounds of core variables that change only if FirmwareState::touched is set.
  const char* settings_begin;
  const char* settings_end;
  /// Returns whether an enabled interrupt, a watchdog reset or tone() may act even if firmware calls nothing.
  /// Interrupts of the core's clock and of Serial do not count. If `held_back`, also considers interrupts
  /// that wait for the I flag. The flag is clear in handlers, and between a sketch's cli() and sei().
  /// Call this function outside the fiber.
  bool (*may_interrupt)(bool held_back);
  /// Passes the execution counts since the start to `sink`. Call this function outside the fiber, at any
  /// time. Null if the image was not built for coverage.
  void (*counters)(CounterSink& sink);
};

}  // namespace host
}  // namespace robosim

/// The only symbol that an image exports.
extern "C" __attribute__((visibility("default"))) const robosim::host::Image robosim_image;
