// Runtime functions that compiled C++ requires. As on a bare-metal AVR, static objects are never destroyed.
#include <stddef.h>

extern "C" {

void* __dso_handle = nullptr;

int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }
#ifdef __ARM_EABI__  // the name on 32-bit ARM
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }
#endif

int errno = 0;

// Bounds of the chip's heap, for sketches that print their free memory. They have no meaning on the host, so
// the printed value is meaningless, too.
char __heap_start = 0;
char* __brkval = nullptr;
char* __malloc_heap_start = nullptr;
char* __malloc_heap_end = nullptr;
size_t __malloc_margin = 128;

}  // extern "C"
