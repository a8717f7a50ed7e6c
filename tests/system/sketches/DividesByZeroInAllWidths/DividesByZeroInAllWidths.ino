// Computes quotients and remainders that are not defined: by zero, and of the most negative number by -1.
volatile int8_t a8, b8;
volatile uint8_t ua8, ub8;
volatile int16_t a16, b16;
volatile uint16_t ua16, ub16;
volatile int32_t a32, b32;
volatile uint32_t ua32, ub32;
volatile int64_t a64, b64;
volatile uint64_t ua64, ub64;

void show(int32_t quotient, int32_t remainder) {
  Serial.print(quotient);
  Serial.print(' ');
  Serial.println(remainder);
}

#define SHOW(type, a, b)         \
  {                              \
    type q = a / b, r = a % b;   \
    show((int32_t)q, (int32_t)r); \
  }

void divide(int32_t dividend, int8_t divisor) {
  a8 = ua8 = a16 = ua16 = a32 = ua32 = a64 = ua64 = dividend;
  b8 = ub8 = b16 = ub16 = b32 = ub32 = b64 = ub64 = divisor;
  SHOW(int8_t, a8, b8)
  SHOW(uint8_t, ua8, ub8)
  SHOW(int16_t, a16, b16)
  SHOW(uint16_t, ua16, ub16)
  SHOW(int32_t, a32, b32)
  SHOW(uint32_t, ua32, ub32)
#ifndef ARDUINO_BLUEPILL_F103C8  // the STM32's library gives other 64-bit results
  SHOW(int64_t, a64, b64)
  SHOW(uint64_t, ua64, ub64)
#endif
  int mixed = ua8 / ub8;
  show(mixed, 0);
  show((int32_t)ua8 / b8, 0);
}

void setup() {
  Serial.begin(115200);
  const int32_t dividends[] = {0, 1, 100, -1, -100, -2147483647L - 1};
  for (uint8_t i = 0; i < 6; i++) {
    divide(dividends[i], 0);
    divide(dividends[i], -1);
    divide(dividends[i], 7);
  }
  volatile int empty = 500;
  Serial.println(map(900, empty, empty, 10, 90));
  Serial.println(map(100, empty, empty, 10, 90));
}

void loop() {}
