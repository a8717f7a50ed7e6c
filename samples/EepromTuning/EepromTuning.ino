#include <EEPROM.h>

// Stores PD constants in the EEPROM, so that they survive a power cut. Commands: kp=9, kd=60, save, show.
struct Settings {
  uint16_t magic;
  int16_t kp, kd;
  uint8_t speed;
};
const Settings defaults PROGMEM = {0xBEEF, 6, 40, 100};
Settings settings;

void load() {
  EEPROM.get(16, settings);
  if (settings.magic != 0xBEEF) {
    memcpy_P(&settings, &defaults, sizeof settings);
    Serial.println(F("defaults"));
  } else {
    Serial.println(F("loaded"));
  }
}

void show() {
  char text[40];
  sprintf_P(text, PSTR("kp=%d kd=%d speed=%u"), settings.kp, settings.kd, settings.speed);
  Serial.println(text);
}

void obey(char* line) {
  if (strcmp_P(line, PSTR("save")) == 0) {
    EEPROM.put(16, settings);
    Serial.println(F("saved"));
  } else if (!strcmp_P(line, PSTR("show"))) {
    show();
  } else if (char* equals = strchr(line, '=')) {
    *equals = 0;
    int value = atoi(equals + 1);
    if (!strcmp(line, "kp")) settings.kp = value;
    else if (!strcmp(line, "kd")) settings.kd = value;
    else if (!strcmp(line, "speed")) settings.speed = value;
    show();
  }
}

void readSerial() {
  static char line[16];
  static byte n = 0;
  while (Serial.available()) {
    char c = Serial.read();
    if (c == '\n') {
      line[n] = '\0';
      n = 0;
      obey(line);
    } else if (c != '\r' && n < sizeof line - 1) {
      line[n++] = c;
    }
  }
}

int position() {
  static const PROGMEM int weights[] = {-20, -10, 0, 10, 20};
  static int last = 0;
  long sum = 0;
  int total = 0;
  for (byte i = 0; i < 5; i++) {
    int v = analogRead(i) >> 3;
    if (v < 25) v = 0;
    sum += (long)v * (int)pgm_read_word(&weights[i]);
    total += v;
  }
  if (total > 20) last = sum * 5 / total;
  return last;
}

void setup() {
  Serial.begin(9600);
  for (byte p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  load();
  show();
}

void loop() {
  static int before = 0;
  readSerial();
  int error = position();
  int turn = (error * settings.kp) / 8 + (error - before) * settings.kd / 8;
  before = error;
  analogWrite(5, constrain(settings.speed + turn, 0, 255));
  analogWrite(6, constrain(settings.speed - turn, 0, 255));
  delay(4);
}
