// Formats integers, characters and strings like avr-libc's default vfprintf. A floating-point conversion
// prints "?". The sketch has no stdout, so printf and puts print nothing.
#include <stdint.h>
#include <stdio.h>
#include <string.h>

namespace {

/// Collects text in a buffer that may be too small or missing.
class Output {
 public:
  Output(char* to, size_t size) : to_(to), size_(size) {}

  void put(char c) {
    if (length_ + 1 < size_) to_[length_] = c;
    ++length_;
  }
  void put(const char* text, size_t n) {
    for (size_t i = 0; i < n; ++i) put(text[i]);
  }
  void fill(char c, int n) {
    for (; n > 0; --n) put(c);
  }
  int finish() {
    if (size_) to_[length_ < size_ ? length_ : size_ - 1] = '\0';
    return static_cast<int>(length_);
  }

 private:
  char* to_;
  size_t size_;
  size_t length_ = 0;
};

struct Conversion {
  bool left = false, plus = false, space = false, alternate = false, zero = false;
  int width = 0;
  int precision = -1;
  int longs = 0;  ///< number of `l` modifiers; a negative value counts `h` modifiers
};

void put_text(Output& out, const Conversion& conversion, const char* text, size_t length) {
  const int padding = conversion.width - static_cast<int>(length);
  if (!conversion.left) out.fill(' ', padding);
  out.put(text, length);
  if (conversion.left) out.fill(' ', padding);
}

void put_number(Output& out, Conversion conversion, uint64_t magnitude, bool negative, bool is_signed,
                unsigned base, bool upper) {
  char digits[24];
  int count = 0;
  const bool was_zero = magnitude == 0;
  for (; magnitude; magnitude /= base) {
    const auto digit = static_cast<char>(magnitude % base);
    digits[count++] = static_cast<char>(digit < 10 ? '0' + digit : (upper ? 'A' : 'a') + digit - 10);
  }
  if (was_zero && conversion.precision != 0) digits[count++] = '0';
  char prefix[2];
  int prefix_length = 0;
  if (is_signed && (negative || conversion.plus || conversion.space))
    prefix[prefix_length++] = negative ? '-' : conversion.plus ? '+' : ' ';
  if (conversion.alternate && base == 16 && !was_zero) {
    prefix[prefix_length++] = '0';
    prefix[prefix_length++] = upper ? 'X' : 'x';
  }
  if (conversion.alternate && base == 8 && conversion.precision <= count) conversion.precision = count + 1;
  int zeros = conversion.precision > count ? conversion.precision - count : 0;
  if (conversion.zero && !conversion.left && conversion.precision < 0 &&
      conversion.width > count + prefix_length)
    zeros = conversion.width - count - prefix_length;
  const int padding = conversion.width - count - zeros - prefix_length;
  if (!conversion.left) out.fill(' ', padding);
  out.put(prefix, static_cast<size_t>(prefix_length));
  out.fill('0', zeros);
  while (count) out.put(digits[--count]);
  if (conversion.left) out.fill(' ', padding);
}

int64_t signed_argument(const Conversion& conversion, va_list* arguments) {
  if (conversion.longs >= 2) return va_arg(*arguments, long long);
  if (conversion.longs == 1) return va_arg(*arguments, long);
  const int value = va_arg(*arguments, int);
  return conversion.longs == 0    ? value
         : conversion.longs == -1 ? static_cast<short>(value)
                                  : static_cast<signed char>(value);
}

uint64_t unsigned_argument(const Conversion& conversion, va_list* arguments) {
  if (conversion.longs >= 2) return va_arg(*arguments, unsigned long long);
  if (conversion.longs == 1) return va_arg(*arguments, unsigned long);
  const unsigned value = va_arg(*arguments, unsigned);
  return conversion.longs == 0    ? value
         : conversion.longs == -1 ? static_cast<unsigned short>(value)
                                  : static_cast<unsigned char>(value);
}

int number_or_star(const char*& format, va_list* arguments) {
  if (*format == '*') {
    ++format;
    return va_arg(*arguments, int);
  }
  int n = 0;
  for (; *format >= '0' && *format <= '9'; ++format) n = n * 10 + (*format - '0');
  return n;
}

Conversion parse(const char*& format, va_list* arguments) {
  Conversion conversion;
  for (;; ++format) {
    if (*format == '-')
      conversion.left = true;
    else if (*format == '+')
      conversion.plus = true;
    else if (*format == ' ')
      conversion.space = true;
    else if (*format == '#')
      conversion.alternate = true;
    else if (*format == '0')
      conversion.zero = true;
    else
      break;
  }
  conversion.width = number_or_star(format, arguments);
  if (conversion.width < 0) {
    conversion.left = true;
    conversion.width = -conversion.width;
  }
  if (*format == '.') {
    ++format;
    conversion.precision = number_or_star(format, arguments);
  }
  for (;; ++format) {
    if (*format == 'l')
      ++conversion.longs;
    else if (*format == 'h')
      --conversion.longs;
    else
      break;
  }
  return conversion;
}

}  // namespace

extern "C" {

int vsnprintf(char* to, size_t size, const char* format, va_list given) {
  Output out(to, size);
  va_list arguments;
  va_copy(arguments, given);
  while (*format) {
    if (*format != '%') {
      out.put(*format++);
      continue;
    }
    ++format;
    const Conversion conversion = parse(format, &arguments);
    const char kind = *format;
    if (!kind) break;
    ++format;
    switch (kind) {
      case 'd':
      case 'i': {
        const int64_t value = signed_argument(conversion, &arguments);
        const auto bits = static_cast<uint64_t>(value);
        put_number(out, conversion, value < 0 ? 0 - bits : bits, value < 0, true, 10, false);
        break;
      }
      case 'u':
        put_number(out, conversion, unsigned_argument(conversion, &arguments), false, false, 10, false);
        break;
      case 'o':
        put_number(out, conversion, unsigned_argument(conversion, &arguments), false, false, 8, false);
        break;
      case 'x':
      case 'X':
        put_number(out, conversion, unsigned_argument(conversion, &arguments), false, false, 16, kind == 'X');
        break;
      case 'p': {
        Conversion pointer = conversion;
        pointer.alternate = true;
        put_number(out, pointer, reinterpret_cast<uintptr_t>(va_arg(arguments, void*)), false, false, 16,
                   false);
        break;
      }
      case 'c': {
        const char c = static_cast<char>(va_arg(arguments, int));
        put_text(out, conversion, &c, 1);
        break;
      }
      case 's':
      case 'S': {
        const char* text = va_arg(arguments, const char*);
        if (!text) text = "(null)";
        put_text(out, conversion, text,
                 conversion.precision < 0 ? strlen(text)
                                          : strnlen(text, static_cast<size_t>(conversion.precision)));
        break;
      }
      case 'e':
      case 'E':
      case 'f':
      case 'F':
      case 'g':
      case 'G':
        (void)va_arg(arguments, double);
        put_text(out, conversion, "?", 1);
        break;
      default:
        out.put(kind);
    }
  }
  va_end(arguments);
  return out.finish();
}

int vsprintf(char* to, const char* format, va_list arguments) {
  return vsnprintf(to, static_cast<size_t>(-1) / 2, format, arguments);
}

int snprintf(char* to, size_t size, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vsnprintf(to, size, format, arguments);
  va_end(arguments);
  return length;
}

int sprintf(char* to, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vsprintf(to, format, arguments);
  va_end(arguments);
  return length;
}

int vprintf(const char* format, va_list arguments) { return vsnprintf(nullptr, 0, format, arguments); }

int printf(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vprintf(format, arguments);
  va_end(arguments);
  return length;
}

int putchar(int c) { return c; }
int puts(const char*) { return 0; }

}  // extern "C"
