// What compiled C++ expects of a runtime, as bare-metal AVR has it: static objects are never destroyed.
extern "C" {

void* __dso_handle = nullptr;

int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }

int errno = 0;

}  // extern "C"
