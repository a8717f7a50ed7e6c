// avr-libc's two error numbers. On the host nothing sets errno.
#pragma once

#define EDOM 33
#define ERANGE 34

#ifdef __cplusplus
extern "C" int errno;
#else
extern int errno;
#endif
