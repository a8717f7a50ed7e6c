// Follows a course of the robotics club DPRG: black lines on white 12-inch tiles, curves of radius 6 inches.
// Converts five sensors to bits, and looks up the steering in a table.
const uint8_t EYES[5] PROGMEM = {A0, A1, A2, A3, A4};
const uint8_t L_EN = 5, L_FWD = 7, L_REV = 8, R_EN = 6, R_FWD = 9, R_REV = 10;
const uint8_t CRUISE = 80;

struct Rule {
  uint8_t seen;   // one bit per sensor, left to right; 1 = black
  int8_t steer;   // positive: to the right
};

const Rule RULES[] PROGMEM = {
    {0b10000, -70}, {0b11000, -45}, {0b01000, -26}, {0b01100, -12}, {0b11100, -26},
    {0b00100, 0},   {0b01110, 0},   {0b00110, 12},  {0b00111, 26},  {0b00010, 26},
    {0b00011, 45},  {0b00001, 70},
};

int8_t steering = 0;

uint8_t look() {
  uint8_t seen = 0;
  for (uint8_t i = 0; i < 5; i++) seen = seen << 1 | (analogRead(pgm_read_byte(&EYES[i])) > 500);
  return seen;
}

void setup() {
  const uint8_t outputs[] = {L_EN, L_FWD, L_REV, R_EN, R_FWD, R_REV};
  for (uint8_t pin : outputs) pinMode(pin, OUTPUT);
  digitalWrite(L_FWD, HIGH);
  digitalWrite(R_FWD, HIGH);
  Serial.begin(9600);
  Serial.println(F("DPRG"));
  delay(500);
}

void loop() {
  uint8_t seen = look();
  for (uint8_t i = 0; i < sizeof RULES / sizeof RULES[0]; i++)
    if (pgm_read_byte(&RULES[i].seen) == seen) steering = pgm_read_byte(&RULES[i].steer);
  // If no sensor sees the line, no rule matches, and the last steering value stays.
  analogWrite(L_EN, constrain(CRUISE + steering, 0, 255));
  analogWrite(R_EN, constrain(CRUISE - steering, 0, 255));
  delay(2);
}
