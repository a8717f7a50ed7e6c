// Provides the system calls that the C library (newlib) requires: memory for malloc, and the program's end.
#include <assert.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

extern "C" {

extern char _end[];  ///< the end of the variables (stm32f103c8.ld)

char* robosim_heap_end = _end;

void* _sbrk(ptrdiff_t bytes) {
  constexpr ptrdiff_t kMargin = 256;  // bytes reserved for the stack
  char* const before = robosim_heap_end;
  char* const stack = static_cast<char*>(__builtin_frame_address(0));
  if (bytes > stack - kMargin - before) return reinterpret_cast<void*>(-1);
  robosim_heap_end = before + bytes;
  return before;
}

/// Ends the program after exit() or a failed assert(): loops forever with interrupts off, as on an Uno.
__attribute__((noreturn, noinline)) void robosim_stop_program() {
  __asm__ volatile("cpsid i");
  for (;;) __asm__ volatile("wfi");
}

void exit(int) { robosim_stop_program(); }
void _exit(int) { robosim_stop_program(); }
void abort() { robosim_stop_program(); }
void __assert(const char*, const char*, int, const char*) { robosim_stop_program(); }
/// Ends the program for newlib's assert().
void __assert_func(const char*, int, const char*, const char*) { robosim_stop_program(); }

}  // extern "C"
