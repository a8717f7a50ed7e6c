// Reads tables and texts from program memory.
#include <avr/pgmspace.h>

const uint8_t levels[] PROGMEM = {0, 10, 40, 90, 160, 250};
const int speeds[5] PROGMEM = {-100, -50, 0, 50, 100};
const uint16_t waits[] PROGMEM = {100, 1000, 60000};
const float gains[] PROGMEM = {0.5, 1.5};
const char name_0[] PROGMEM = "left";
const char name_1[] PROGMEM = "right";
const char *const names[] PROGMEM = {name_0, name_1};

struct Step {
  uint8_t pin;
  int speed;
};
const Step steps[] PROGMEM = {{5, 100}, {6, -100}};

void setup() {
  Serial.begin(115200);
  Serial.println(F("in flash"));
  Serial.println(pgm_read_byte(&levels[4]));
  Serial.println((int)pgm_read_word(&speeds[0]));
  Serial.println(pgm_read_word_near(waits + 2));
  Serial.println(pgm_read_float(&gains[1]));
  char buffer[10];
  strcpy_P(buffer, (char *)pgm_read_word(&(names[1])));
  Serial.println(buffer);
  strncpy_P(buffer, (PGM_P)pgm_read_ptr(&names[0]), sizeof buffer);
  Serial.println(buffer);
  Step step;
  memcpy_P(&step, &steps[1], sizeof step);
  Serial.println(step.speed);
  Serial.println(strlen_P(PSTR("five!")));
}

void loop() {}
