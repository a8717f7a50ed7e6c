/* Shows a menu on a 16x2 display (HD44780 in 4-bit mode, without a library). Three buttons each use one pin.
   SELECT starts the race; the display then shows the time. */
enum { RS = 12, EN = 11, D4 = A4, D5 = A3, D6 = A2, D7 = A1 };
enum { UP = 2, DOWN = 3, SELECT = 4 };
int speedLevel = 3;
boolean racing = false;
unsigned long t0, lastDraw;

void pulseNibble(byte n) {
  digitalWrite(D4, n & 1); digitalWrite(D5, n >> 1 & 1); digitalWrite(D6, n >> 2 & 1); digitalWrite(D7, n >> 3 & 1);
  digitalWrite(EN, HIGH); delayMicroseconds(2); digitalWrite(EN, LOW); delayMicroseconds(60);
}
void lcdByte(byte b, byte rs) { digitalWrite(RS, rs); pulseNibble(b >> 4); pulseNibble(b & 15); }
void lcdCommand(byte b) { lcdByte(b, LOW); if (b < 4) delay(2); }
void lcdPrint(const __FlashStringHelper* s) {
  PGM_P p = reinterpret_cast<PGM_P>(s);
  while (char c = pgm_read_byte(p++)) lcdByte(c, HIGH);
}
void lcdNumber(unsigned n) {
  char text[6];
  utoa(n, text, 10);
  for (char* c = text; *c; ++c) lcdByte(*c, HIGH);
}

void setup() {
  pinMode(RS, OUTPUT); pinMode(EN, OUTPUT); pinMode(D4, OUTPUT); pinMode(D5, OUTPUT); pinMode(D6, OUTPUT); pinMode(D7, OUTPUT);
  pinMode(UP, INPUT_PULLUP); pinMode(DOWN, INPUT_PULLUP); pinMode(SELECT, INPUT_PULLUP);
  for (byte p = 5; p <= 10; ++p) pinMode(p, OUTPUT);
  delay(50);
  for (byte i = 0; i < 3; ++i) { digitalWrite(RS, LOW); pulseNibble(3); delay(5); }
  pulseNibble(2);
  lcdCommand(0x28); lcdCommand(0x0C); lcdCommand(0x01);
  lcdPrint(F("Line racer"));
  draw();
}

void draw() {
  lcdCommand(0xC0);
  if (racing) {
    lcdPrint(F("t = "));
    lcdNumber((millis() - t0) / 1000);
    lcdPrint(F(" s     "));
  } else {
    lcdPrint(F("speed "));
    lcdNumber(speedLevel);
    lcdPrint(F("   "));
  }
}

bool pressed(byte pin) {
  if (digitalRead(pin)) return false;
  delay(30);
  while (!digitalRead(pin)) ;
  delay(30);
  return true;
}

void loop() {
  if (!racing) {
    if (pressed(UP) && speedLevel < 9) { speedLevel++; draw(); }
    if (pressed(DOWN) && speedLevel > 1) { speedLevel--; draw(); }
    if (pressed(SELECT)) { racing = true; t0 = millis(); lcdCommand(0x01); draw(); }
    return;
  }
  if (millis() - lastDraw > 500) { lastDraw = millis(); draw(); }
  int v = 60 + speedLevel * 10;
  bool l = digitalRead(A0), r = digitalRead(A5);
  digitalWrite(7, !l); digitalWrite(8, l); digitalWrite(9, !r); digitalWrite(10, r);
  analogWrite(5, l ? 80 : v);
  analogWrite(6, r ? 80 : v);
}
