// Helpers of report.h and cycles.h for the target host. end_program() sends the reported bytes by the UART,
// followed by their number and by "END". On the host, every access to a register takes 2 cycles.
#pragma once

static uint8_t reported_[64], count_;

static inline void report(uint8_t byte) {
  reported_[count_++ % sizeof reported_] = byte;
  robosim_spend_cycles(1);
}
static inline void send_(uint8_t byte) {
  while (!(UCSR0A & _BV(UDRE0))) {
  }
  UDR0 = byte;
}
static inline __attribute__((noreturn)) void end_program(void) {
  cli();
  UCSR0B = _BV(TXEN0);
  for (uint8_t i = 0; i < count_; ++i) send_(reported_[i]);
  send_(count_);
  for (const char* end = "END"; *end; ++end) send_((uint8_t)*end);
  for (;;) {
  }
}

#define NOPS(count) robosim_spend_cycles(count)
#define IN_TAKES 2

/// Reads a register `cycles` cycles after the last access. If `cycles` is less than 2, reads after 2 cycles.
#define READ_AFTER(cycles, from)                                      \
  ({                                                                  \
    if ((cycles) > IN_TAKES) robosim_spend_cycles((cycles)-IN_TAKES); \
    uint8_t found_ = (from);                                          \
    found_;                                                           \
  })
#define OUT_IN(to, value, nops, from) \
  ({                                  \
    (to) = (value);                   \
    READ_AFTER((nops) + 1, from);     \
  })
#define STS_LDS(to, value, nops, from) \
  ({                                   \
    (to) = (value);                    \
    READ_AFTER((nops) + 2, from);      \
  })
#define OUT_OUT_IN(first, value1, second, value2, nops, from) \
  ({                                                          \
    (first) = (value1);                                       \
    OUT_IN(second, value2, nops, from);                       \
  })
