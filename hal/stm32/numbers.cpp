// Implements the C standard's strfromd(), which is missing in newlib, for "%.Nf", "%.Ne" and "%.NE". Uses
// newlib's exact conversion.
#include <stddef.h>
#include <stdlib.h>

extern "C" {

struct _reent;
extern _reent* _impure_ptr;
/// Returns the digits of `value` without trailing zeros (a function of newlib). Mode 2 returns at most
/// `count` digits, mode 3 at most `count` decimals. `*point` receives the position of the decimal point (9999
/// for NaN and infinity).
char* _dtoa_r(_reent*, double value, int mode, int count, int* point, int* negative, char** end);
}

namespace {

class Text {
 public:
  Text(char* to, size_t size) : to_(to), size_(size) {}
  void put(char c) {
    if (length_ + 1 < size_) to_[length_] = c;
    ++length_;
  }
  void digits(const char*& from, int count) {
    for (; count > 0; --count) put(*from ? *from++ : '0');
  }
  int finish() {
    if (size_ > 0) to_[length_ < size_ ? length_ : size_ - 1] = '\0';
    return static_cast<int>(length_);
  }

 private:
  char* to_;
  size_t size_, length_ = 0;
};

void put_fixed(Text& out, const char* digits, int point, int decimals) {
  if (point <= 0) out.put('0');
  out.digits(digits, point);
  if (decimals == 0) return;
  out.put('.');
  for (; point < 0 && decimals > 0; ++point, --decimals) out.put('0');
  out.digits(digits, decimals);
}

void put_exponential(Text& out, const char* digits, int point, int decimals, char letter) {
  const bool zero = *digits == '0' || !*digits;
  out.digits(digits, 1);
  if (decimals > 0) out.put('.');
  out.digits(digits, decimals);
  const int exponent = zero ? 0 : point - 1;
  out.put(letter);
  out.put(exponent < 0 ? '-' : '+');
  char text[6];
  ultoa(static_cast<unsigned long>(exponent < 0 ? -exponent : exponent), text, 10);
  if (!text[1]) out.put('0');
  for (const char* c = text; *c; ++c) out.put(*c);
}

}  // namespace

extern "C" int strfromd(char* to, size_t size, const char* format, double value) {
  constexpr int kNoNumber = 9999;
  int decimals = 0;
  const char* c = format + 2;
  for (; *c >= '0' && *c <= '9'; ++c) decimals = 10 * decimals + (*c - '0');
  const bool fixed = *c == 'f';
  int point = 0, negative = 0;
  const char* digits =
      _dtoa_r(_impure_ptr, value, fixed ? 3 : 2, fixed ? decimals : decimals + 1, &point, &negative, nullptr);
  Text out(to, size);
  if (negative) out.put('-');
  if (point == kNoNumber) {
    for (const char* name = *digits == 'I' ? "inf" : "nan"; *name; ++name) out.put(*name);
  } else if (fixed) {
    put_fixed(out, digits, point, decimals);
  } else {
    put_exponential(out, digits, point, decimals, *c);
  }
  return out.finish();
}
