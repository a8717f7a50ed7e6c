// Computes all the time (checksum, floating point, sorting, text), and follows the line in between.
#include <util/crc16.h>

const uint8_t SENSORS[] = {A0, A1, A2, A3, A4};
uint8_t memory[128];
int16_t numbers[48];
uint32_t chance = 1;
float filtered[8];
unsigned long last;
volatile uint16_t result;

uint16_t next() {
  chance = chance * 1664525 + 1013904223;
  return chance >> 16;
}

uint16_t checksum() {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 0; i < sizeof memory; ++i) crc = _crc_ccitt_update(crc, memory[i] ^= crc);
  return crc;
}

void filter() {
  for (uint8_t i = 0; i < 8; ++i) filtered[i] += 0.2 * (sin(next() * 0.001) - filtered[i]);
}

void sort() {
  for (uint8_t i = 0; i < 48; ++i) numbers[i] = next();
  for (uint8_t i = 1; i < 48; ++i)
    for (uint8_t j = i; j > 0 && numbers[j - 1] > numbers[j]; --j) {
      int16_t swapped = numbers[j];
      numbers[j] = numbers[j - 1];
      numbers[j - 1] = swapped;
    }
}

void steer() {
  long weighted = 0, sum = 0;
  for (int8_t i = 0; i < 5; ++i) {
    int dark = max(analogRead(SENSORS[i]) - 100, 0);
    weighted += (long)dark * (i - 2) * 40;
    sum += dark;
  }
  int turn = sum > 100 ? weighted / sum : 0;
  analogWrite(5, constrain(80 + turn, 0, 255));
  analogWrite(6, constrain(80 - turn, 0, 255));
}

void setup() {
  for (int pin = 5; pin <= 10; ++pin) pinMode(pin, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}

void loop() {
  char text[12];
  result = checksum();
  filter();
  sort();
  result += strlen(itoa(numbers[0], text, 10)) + (uint16_t)(100 * filtered[1]);
  if (millis() - last >= 20) {
    last = millis();
    steer();
  }
}
