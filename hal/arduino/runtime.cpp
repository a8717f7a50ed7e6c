// What compiled C++ expects of a runtime, as bare-metal AVR has it: static objects are never destroyed.
#include <stddef.h>

extern "C" {

void* __dso_handle = nullptr;

int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }
#ifdef __ARM_EABI__  // 32-bit ARM asks by this name
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }
#endif

int errno = 0;

// Sketches that print their free memory name these bounds of the chip's heap. They have no meaning here, and
// so has the figure: memory is the chip's business.
char __heap_start = 0;
char* __brkval = nullptr;
char* __malloc_heap_start = nullptr;
char* __malloc_heap_end = nullptr;
size_t __malloc_margin = 128;

}  // extern "C"
