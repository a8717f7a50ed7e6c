// Implements functions of avr-libc's <string.h> that the host's C library may lack.
#include <string.h>

extern "C" {

size_t strlcpy(char* to, const char* from, size_t size) {
  const size_t length = strlen(from);
  if (size) {
    const size_t n = length < size ? length : size - 1;
    memcpy(to, from, n);
    to[n] = '\0';
  }
  return length;
}

size_t strlcat(char* to, const char* from, size_t size) {
  const size_t used = strnlen(to, size);
  return used + (used == size ? strlen(from) : strlcpy(to + used, from, size - used));
}

char* strlwr(char* text) {
  for (char* c = text; *c; ++c)
    if (*c >= 'A' && *c <= 'Z') *c = static_cast<char>(*c + ('a' - 'A'));
  return text;
}

char* strupr(char* text) {
  for (char* c = text; *c; ++c)
    if (*c >= 'a' && *c <= 'z') *c = static_cast<char>(*c - ('a' - 'A'));
  return text;
}

char* strrev(char* text) {
  if (!*text) return text;
  for (char *a = text, *b = text + strlen(text) - 1; a < b; ++a, --b) {
    const char c = *a;
    *a = *b;
    *b = c;
  }
  return text;
}

}  // extern "C"
