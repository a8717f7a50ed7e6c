// Selects a mode by keypad, remote control or Bluetooth, displays the mode, and beeps. Uses no libraries.
const int ROWS[4] = {6, 7, 8, 9};
const int COLUMNS[3] = {10, A0, A1};
const char KEYS[4][4] = {"123", "456", "789", "*0#"};
const int RS = 12, EN = 11, DATA[4] = {5, 4, 3, 2};
const int IR = A2, BUZZER = 13;

void nibble(int bits) {
  for (int i = 0; i < 4; i++) digitalWrite(DATA[i], (bits >> i) & 1);
  digitalWrite(EN, HIGH);
  delayMicroseconds(1);
  digitalWrite(EN, LOW);
  delayMicroseconds(50);
}

void lcd(int isData, int byte_) {
  digitalWrite(RS, isData);
  nibble(byte_ >> 4);
  nibble(byte_ & 15);
  if (!isData && byte_ < 4) delay(2);
}

void show(const char* text) {
  lcd(0, 0x01);
  while (*text) lcd(1, *text++);
}

void beginLcd() {
  delay(50);
  for (int i = 0; i < 3; i++) {
    nibble(3);
    delay(5);
  }
  nibble(2);
  lcd(0, 0x28);
  lcd(0, 0x0C);
  lcd(0, 0x06);
}

char key() {
  char found = 0;
  for (int column = 0; column < 3; column++) {
    pinMode(COLUMNS[column], OUTPUT);
    digitalWrite(COLUMNS[column], LOW);
    for (int row = 0; row < 4; row++)
      if (digitalRead(ROWS[row]) == LOW) found = KEYS[row][column];
    pinMode(COLUMNS[column], INPUT);
  }
  return found;
}

// Returns the command of an NEC message that has just begun, or -1 for any other signal.
int command() {
  if (pulseIn(IR, HIGH, 20000) < 4000) return -1;
  unsigned long bits = 0;
  for (int i = 0; i < 32; i++)
    if (pulseIn(IR, HIGH, 5000) > 1000) bits |= 1UL << i;
  int wanted = (bits >> 16) & 0xFF;
  return (int)((bits >> 24) & 0xFF) == (0xFF ^ wanted) ? wanted : -1;
}

void chosen(const char* by, int what) {
  char text[17];
  sprintf(text, "%s %d", by, what);
  show(text);
  tone(BUZZER, 1000, 100);
  Serial.println(text);
}

void setup() {
  Serial.begin(9600);
  for (int i = 0; i < 4; i++) pinMode(ROWS[i], INPUT_PULLUP);
  for (int i = 0; i < 4; i++) pinMode(DATA[i], OUTPUT);
  pinMode(RS, OUTPUT);
  pinMode(EN, OUTPUT);
  pinMode(IR, INPUT);
  beginLcd();
  show("Choose");
}

void loop() {
  static char last = 0;
  char now = key();
  if (now && now != last) chosen("key", now - '0');
  last = now;
  if (digitalRead(IR) == LOW) {
    int wanted = command();
    if (wanted >= 0) chosen("remote", wanted);
  }
  if (Serial.available()) chosen("phone", Serial.read() - '0');
}
