// Accesses program memory (flash). On the host, data in program memory are ordinary constants. Each function
// with the suffix _P equals the function without the suffix.
#pragma once

#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define PROGMEM
#define PGM_P const char*
#define PGM_VOID_P const void*
#define PSTR(text) (text)
#define __ATTR_PROGMEM__

typedef void prog_void;
typedef char prog_char;
typedef unsigned char prog_uchar;
typedef int8_t prog_int8_t;
typedef uint8_t prog_uint8_t;
typedef int16_t prog_int16_t;
typedef uint16_t prog_uint16_t;
typedef int32_t prog_int32_t;
typedef uint32_t prog_uint32_t;
typedef int64_t prog_int64_t;
typedef uint64_t prog_uint64_t;
typedef uintptr_t uint_farptr_t;

#ifdef __cplusplus
namespace robosim_hal {
template <typename T, typename P>
inline T program_memory(P address) {
  T value;
  __builtin_memcpy(&value, (const void*)address, sizeof value);
  return value;
}
/// Reads a value with the width of its type. Sketches also use pgm_read_word for tables of `int` and of
/// pointers. These types have 16 bits on the chip, but more on the host.
template <typename T>
inline T program_word(const T* address) {
  return *address;
}
inline uint16_t program_word(const void* address) { return program_memory<uint16_t>(address); }
inline uint16_t program_word(const char* address) { return program_memory<uint16_t>(address); }
inline uint16_t program_word(const uint8_t* address) { return program_memory<uint16_t>(address); }
inline uint16_t program_word(uintptr_t address) { return program_memory<uint16_t>(address); }
}  // namespace robosim_hal
#define pgm_read_byte(address) (robosim_hal::program_memory<uint8_t>(address))
#define pgm_read_word(address) (robosim_hal::program_word(address))
#define pgm_read_dword(address) (robosim_hal::program_memory<uint32_t>(address))
#define pgm_read_float(address) (robosim_hal::program_memory<float>(address))
#define pgm_read_ptr(address) (robosim_hal::program_memory<void*>(address))
#else
#define pgm_read_byte(address) (*(const uint8_t*)(address))
#define pgm_read_word(address) (*(const uint16_t*)(address))
#define pgm_read_dword(address) (*(const uint32_t*)(address))
#define pgm_read_float(address) (*(const float*)(address))
#define pgm_read_ptr(address) (*(void* const*)(address))
#endif

#define pgm_read_byte_near(address) pgm_read_byte(address)
#define pgm_read_word_near(address) pgm_read_word(address)
#define pgm_read_dword_near(address) pgm_read_dword(address)
#define pgm_read_float_near(address) pgm_read_float(address)
#define pgm_read_ptr_near(address) pgm_read_ptr(address)
#define pgm_read_byte_far(address) pgm_read_byte(address)
#define pgm_read_word_far(address) pgm_read_word(address)
#define pgm_read_dword_far(address) pgm_read_dword(address)
#define pgm_read_float_far(address) pgm_read_float(address)
#define pgm_read_ptr_far(address) pgm_read_ptr(address)
#define pgm_get_far_address(variable) ((uintptr_t) & (variable))

#define memchr_P memchr
#define memcmp_P memcmp
#define memccpy_P memccpy
#define memcpy_P memcpy
#define memmem_P memmem
#define memrchr_P memrchr
#define strcasecmp_P strcasecmp
#define strcasestr_P strcasestr
#define strcat_P strcat
#define strchr_P strchr
#define strchrnul_P strchrnul
#define strcmp_P strcmp
#define strcpy_P strcpy
#define strcspn_P strcspn
#define strlcat_P strlcat
#define strlcpy_P strlcpy
#define strlen_P strlen
#define strncasecmp_P strncasecmp
#define strncat_P strncat
#define strncmp_P strncmp
#define strncpy_P strncpy
#define strnlen_P strnlen
#define strpbrk_P strpbrk
#define strrchr_P strrchr
#define strsep_P strsep
#define strspn_P strspn
#define strstr_P strstr
#define strtok_P strtok
#define strtok_rP strtok_r
#define printf_P printf
#define puts_P puts
#define snprintf_P snprintf
#define sprintf_P sprintf
#define sscanf_P sscanf
#define vprintf_P vprintf
#define vsnprintf_P vsnprintf
#define vsprintf_P vsprintf

// Functions with the suffix _PF accept far addresses, which are integers.
#define memcmp_PF(a, far_b, size) memcmp(a, (const void*)(far_b), size)
#define memcpy_PF(to, far_from, size) memcpy(to, (const void*)(far_from), size)
#define strlen_PF(far_text) strlen((const char*)(far_text))
#define strnlen_PF(far_text, size) strnlen((const char*)(far_text), size)
#define strcasecmp_PF(a, far_b) strcasecmp(a, (const char*)(far_b))
#define strcmp_PF(a, far_b) strcmp(a, (const char*)(far_b))
#define strcat_PF(a, far_b) strcat(a, (const char*)(far_b))
#define strcpy_PF(a, far_b) strcpy(a, (const char*)(far_b))
#define strstr_PF(a, far_b) strstr(a, (const char*)(far_b))
#define strncasecmp_PF(a, far_b, size) strncasecmp(a, (const char*)(far_b), size)
#define strncmp_PF(a, far_b, size) strncmp(a, (const char*)(far_b), size)
#define strncat_PF(a, far_b, size) strncat(a, (const char*)(far_b), size)
#define strncpy_PF(a, far_b, size) strncpy(a, (const char*)(far_b), size)
#define strlcat_PF(a, far_b, size) strlcat(a, (const char*)(far_b), size)
#define strlcpy_PF(a, far_b, size) strlcpy(a, (const char*)(far_b), size)
