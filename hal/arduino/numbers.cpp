// Converts numbers to text: implements avr-libc's itoa, ltoa, utoa, ultoa, dtostrf and dtostre.
#include <math.h>
#include <stdlib.h>
#include <string.h>

extern "C" {

/// Formats a double with exact digits (glibc). `format` is "%.3f" or similar.
int strfromd(char* text, size_t size, const char* format, double value);

char* ultoa(unsigned long value, char* text, int radix) {
  char* end = text;
  if (radix < 2 || radix > 36) {
    *text = '\0';
    return text;
  }
  do {
    const auto digit = static_cast<char>(value % static_cast<unsigned long>(radix));
    *end++ = static_cast<char>(digit < 10 ? '0' + digit : 'a' + digit - 10);
    value /= static_cast<unsigned long>(radix);
  } while (value);
  *end = '\0';
  return strrev(text);
}

char* utoa(unsigned int value, char* text, int radix) { return ultoa(value, text, radix); }

// Prints a sign in base 10. In every other base, prints the bits as an unsigned number of the type's width.
char* ltoa(long value, char* text, int radix) {
  const bool negative = radix == 10 && value < 0;
  if (negative) text[0] = '-';
  const auto magnitude = static_cast<unsigned long>(value);
  ultoa(negative ? 0ul - magnitude : magnitude, text + negative, radix);
  return text;
}

char* itoa(int value, char* text, int radix) {
  return radix == 10 ? ltoa(value, text, radix) : ultoa(static_cast<unsigned int>(value), text, radix);
}

char* dtostrf(double value, signed char width, unsigned char decimals, char* text) {
  char format[8] = "%.";
  strcat(ultoa(decimals, format + 2, 10), "f");
  const size_t wide = static_cast<size_t>(width < 0 ? -width : width);
  const auto length = static_cast<size_t>(strfromd(text, static_cast<size_t>(-1) / 4, format, value));
  if (length < wide) {
    if (width > 0) {
      memmove(text + (wide - length), text, length);
      memset(text, ' ', wide - length);
    } else {
      memset(text + length, ' ', wide - length);
    }
    text[wide] = '\0';
  }
  return text;
}

char* dtostre(double value, char* text, unsigned char decimals, unsigned char flags) {
  char format[8] = "%.";
  // The dtostre() of avr-libc prints at most 7 decimals.
  strcat(ultoa(decimals < 7 ? decimals : 7, format + 2, 10), flags & DTOSTR_UPPERCASE ? "E" : "e");
  char* number = text;
  if (!signbit(value)) {
    if (flags & DTOSTR_PLUS_SIGN)
      *number++ = '+';
    else if (flags & DTOSTR_ALWAYS_SIGN)
      *number++ = ' ';
  }
  strfromd(number, static_cast<size_t>(-1) / 4, format, value);
  return text;
}

}  // extern "C"
