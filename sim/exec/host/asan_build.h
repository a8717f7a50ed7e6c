// Detects whether Robosim itself is compiled with AddressSanitizer.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define ROBOSIM_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ROBOSIM_ASAN 1
#endif
#endif
#ifdef ROBOSIM_ASAN
#include <sanitizer/asan_interface.h>
#endif
