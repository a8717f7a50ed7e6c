// Scans a 4x3 keypad without a library. Keys select a mode: 1 follow the line, 2 turn on the spot, * stop.
const byte ROWS = 4, COLS = 3;
const char keys[ROWS][COLS] = {{'1','2','3'},{'4','5','6'},{'7','8','9'},{'*','0','#'}};
const byte rowPins[ROWS] = {A5, A4, A3, A2};
const byte colPins[COLS] = {13, 12, 4};

char mode = '*';
char lastKey = 0;
unsigned long pressedAt;

char scan() {
  for (byte c = 0; c < COLS; c++) {
    pinMode(colPins[c], OUTPUT);
    digitalWrite(colPins[c], LOW);
    for (byte r = 0; r < ROWS; r++) {
      if (digitalRead(rowPins[r]) == LOW) {
        pinMode(colPins[c], INPUT);
        return keys[r][c];
      }
    }
    pinMode(colPins[c], INPUT);
  }
  return 0;
}

void setup() {
  for (byte r = 0; r < ROWS; r++) pinMode(rowPins[r], INPUT_PULLUP);
  for (byte p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  Serial.begin(9600);
  Serial.println(F("1 follow, 2 turn, * stop"));
}

void wheels(int l, int r) {
  digitalWrite(7, l > 0); digitalWrite(8, l < 0); analogWrite(5, abs(l));
  digitalWrite(9, r > 0); digitalWrite(10, r < 0); analogWrite(6, abs(r));
}

void loop() {
  char k = scan();
  if (k != lastKey) {            // debounce
    lastKey = k;
    pressedAt = millis();
  } else if (k && millis() - pressedAt > 20 && k != mode) {
    if (k == '1' || k == '2' || k == '*') {
      mode = k;
      Serial.print(F("mode "));
      Serial.println(mode);
    } else {
      Serial.print(F("no programme "));
      Serial.println(k);
      pressedAt = millis() + 10000;
    }
  }
  if (mode == '1') {
    bool l = digitalRead(A0), r = digitalRead(A1);
    if (l) wheels(-80, 130);
    else if (r) wheels(130, -80);
    else wheels(130, 130);
  } else if (mode == '2') {
    wheels(100, -100);
  } else {
    wheels(0, 0);
  }
}
