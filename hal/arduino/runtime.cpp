// Defines runtime functions and variables that compiled C++ requires. As on a bare-metal AVR, static objects
// are never destroyed.
#include <stddef.h>

extern "C" {

void* __dso_handle = nullptr;

int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }
#ifdef __ARM_EABI__  // the function's name on 32-bit ARM
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }
#endif

int errno = 0;

// The bounds of the chip's heap, for sketches that print the size of their free memory. On the host, these
// variables have no meaning, so the printed value has no meaning either.
char __heap_start = 0;
char* __brkval = nullptr;
char* __malloc_heap_start = nullptr;
char* __malloc_heap_end = nullptr;
size_t __malloc_margin = 128;

}  // extern "C"
