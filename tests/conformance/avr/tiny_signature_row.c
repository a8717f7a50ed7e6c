// The signature is 1E 93 0B.
// Source: 2586Q, 20.3
// Expect: 1e 93 0b
// Chips: attiny85
#include <avr/io.h>
#define SIGRD RSIG  // the name in <avr/boot.h>
#include <avr/boot.h>

#include "report.h"

int main(void) {
  report(boot_signature_byte_get(0));
  report(boot_signature_byte_get(2));
  report(boot_signature_byte_get(4));
  end_program();
}
