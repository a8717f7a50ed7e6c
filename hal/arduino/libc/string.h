// String and memory functions. This header declares only avr-libc's names, because a sketch may define its
// own `index` or `rindex`, for example.
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void* memccpy(void* to, const void* from, int stop_at, size_t n);
void* memchr(const void* memory, int c, size_t n);
int memcmp(const void* a, const void* b, size_t n);
void* memcpy(void* to, const void* from, size_t n);
void* memmem(const void* hay, size_t hay_size, const void* needle, size_t needle_size);
void* memmove(void* to, const void* from, size_t n);
void* memrchr(const void* memory, int c, size_t n);
void* memset(void* memory, int c, size_t n);
int strcasecmp(const char* a, const char* b);
char* strcasestr(const char* hay, const char* needle);
char* strcat(char* to, const char* from);
char* strchr(const char* text, int c);
char* strchrnul(const char* text, int c);
int strcmp(const char* a, const char* b);
char* strcpy(char* to, const char* from);
size_t strcspn(const char* text, const char* reject);
char* strdup(const char* text);
size_t strlcat(char* to, const char* from, size_t size);
size_t strlcpy(char* to, const char* from, size_t size);
size_t strlen(const char* text);
char* strlwr(char* text);
int strncasecmp(const char* a, const char* b, size_t n);
char* strncat(char* to, const char* from, size_t n);
int strncmp(const char* a, const char* b, size_t n);
char* strncpy(char* to, const char* from, size_t n);
size_t strnlen(const char* text, size_t most);
char* strpbrk(const char* text, const char* accept);
char* strrchr(const char* text, int c);
char* strrev(char* text);
char* strsep(char** text, const char* separators);
size_t strspn(const char* text, const char* accept);
char* strstr(const char* hay, const char* needle);
char* strtok(char* text, const char* separators);
char* strtok_r(char* text, const char* separators, char** state);
char* strupr(char* text);

#ifdef __cplusplus
}
#endif
