#include "hal/host/register_memory.h"

#include "hal/host/access.h"
#include "hal/host/clock.h"

extern "C" {
alignas(2) uint8_t robosim_register_memory[ROBOSIM_REGISTER_BYTES];
}

namespace robosim {
namespace host {

namespace {

// The write that has not taken effect yet.
robosim_register written;
int written_bytes;
SimTime written_at;

uint16_t content(robosim_register address, int bytes) {
  const uint8_t* const at = robosim_register_memory + address;
  return static_cast<uint16_t>(bytes == 1 ? at[0] : at[0] | at[1] << 8);
}

__attribute__((always_inline)) inline bool is_register(uintptr_t at, robosim_register& address) {
  const uintptr_t offset = at - reinterpret_cast<uintptr_t>(robosim_register_memory);
  address = static_cast<robosim_register>(offset);
  return offset < ROBOSIM_REGISTER_BYTES;
}

void will_read(robosim_register address, int bytes, const void* place) {
  begin_access(address, bytes, place);
  const uint16_t value = register_value(address, bytes);
  robosim_register_memory[address] = static_cast<uint8_t>(value);
  if (bytes == 2) robosim_register_memory[address + 1] = static_cast<uint8_t>(value >> 8);
}

void settle() {
  unsettled = nullptr;
  const SimTime now = state.now;
  state.now = written_at;
  set_register(written, written_bytes, content(written, written_bytes));
  state.now = now;
  refresh_deadline();
}

void will_write(robosim_register address, int bytes, const void* place) {
  begin_access(address, bytes, place);
  settle_registers();  // ends a search for idle polling (polling.h) that begin_access() has begun
  unsettled = settle;
  written = address;
  written_bytes = bytes;
  written_at = state.now;
  deadline = state.now;  // the next basic block then applies the write
}

}  // namespace

}  // namespace host
}  // namespace robosim

// Defines a function that gcc's ThreadSanitizer code calls. Only accesses to 1 or 2 bytes can be registers.
#define ROBOSIM_WATCH(name, what, bytes)                                \
  void name(uintptr_t at) {                                             \
    robosim_register address;                                           \
    if (__builtin_expect(robosim::host::is_register(at, address), 0))   \
      robosim::host::what(address, bytes, __builtin_return_address(0)); \
  }
// Defines the variant that gcc uses for 16 bits at an address that may be odd.
#define ROBOSIM_WATCH_RANGE(name, what)                             \
  void name(uintptr_t at, uintptr_t bytes) {                        \
    robosim_register address;                                       \
    if (bytes == 2 && robosim::host::is_register(at, address))      \
      robosim::host::what(address, 2, __builtin_return_address(0)); \
  }
#define ROBOSIM_SAME(name, other) void name(uintptr_t) __attribute__((alias(#other)));
#define ROBOSIM_SAME_OF(kind)                                \
  ROBOSIM_SAME(__tsan_volatile_##kind##1, __tsan_##kind##1)  \
  ROBOSIM_SAME(__tsan_volatile_##kind##2, __tsan_##kind##2)  \
  ROBOSIM_SAME(__tsan_unaligned_##kind##2, __tsan_##kind##2) \
  ROBOSIM_SAME(__tsan_unaligned_volatile_##kind##2, __tsan_##kind##2)
#define ROBOSIM_IGNORE(size)                                      \
  ROBOSIM_SAME(__tsan_read##size, __tsan_init)                    \
  ROBOSIM_SAME(__tsan_write##size, __tsan_init)                   \
  ROBOSIM_SAME(__tsan_volatile_read##size, __tsan_init)           \
  ROBOSIM_SAME(__tsan_volatile_write##size, __tsan_init)          \
  ROBOSIM_SAME(__tsan_unaligned_read##size, __tsan_init)          \
  ROBOSIM_SAME(__tsan_unaligned_write##size, __tsan_init)         \
  ROBOSIM_SAME(__tsan_unaligned_volatile_read##size, __tsan_init) \
  ROBOSIM_SAME(__tsan_unaligned_volatile_write##size, __tsan_init)

extern "C" {

ROBOSIM_WATCH(__tsan_read1, will_read, 1)
ROBOSIM_WATCH(__tsan_read2, will_read, 2)
ROBOSIM_WATCH(__tsan_write1, will_write, 1)
ROBOSIM_WATCH(__tsan_write2, will_write, 2)
ROBOSIM_WATCH_RANGE(__tsan_read_range, will_read)
ROBOSIM_WATCH_RANGE(__tsan_write_range, will_write)
ROBOSIM_SAME_OF(read)
ROBOSIM_SAME_OF(write)

void __tsan_init() {}
ROBOSIM_IGNORE(4)
ROBOSIM_IGNORE(8)
ROBOSIM_IGNORE(16)
ROBOSIM_SAME(__tsan_vptr_update, __tsan_init)

}  // extern "C"
