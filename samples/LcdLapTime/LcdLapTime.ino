// Shows lap times on a 16x2 LCD with a PCF8574 backpack. Counts a lap at the black bar across the track.
#include "Lcd.h"

Lcd lcd(0x3F);

const int s1 = 7, s2 = 4, s3 = 12;                    // outer left, middle, outer right
const int pwma = 3, ain1 = 5, ain2 = 6;
const int pwmb = 11, bin1 = 9, bin2 = 10;

int laps = 0;
unsigned long lapStart = 0, lastBar = 0;
float best = 0;

void setup() {
  pinMode(s1, INPUT); pinMode(s2, INPUT); pinMode(s3, INPUT);
  pinMode(pwma, OUTPUT); pinMode(ain1, OUTPUT); pinMode(ain2, OUTPUT);
  pinMode(pwmb, OUTPUT); pinMode(bin1, OUTPUT); pinMode(bin2, OUTPUT);
  lcd.begin();
  lcd.print("Ready...");
  delay(1500);
  lapStart = millis();
  lcd.clear();
  lcd.print("Lap 0");
}

void speeds(int l, int r) {
  digitalWrite(ain1, l >= 0 ? HIGH : LOW); digitalWrite(ain2, l >= 0 ? LOW : HIGH);
  digitalWrite(bin1, r >= 0 ? HIGH : LOW); digitalWrite(bin2, r >= 0 ? LOW : HIGH);
  analogWrite(pwma, abs(l));
  analogWrite(pwmb, abs(r));
}

void loop() {
  boolean a = digitalRead(s1), b = digitalRead(s2), c = digitalRead(s3);
  if (a && c) {
    bar();
    speeds(130, 130);
  } else if (a) {
    speeds(0, 150);
  } else if (c) {
    speeds(150, 0);
  } else {
    speeds(140, 140);
  }
}

void bar() {
  if (millis() - lastBar < 1000) return;     // still the same bar
  lastBar = millis();
  float t = (millis() - lapStart) / 1000.0;
  lapStart = millis();
  laps++;
  if (laps > 1 && (best == 0 || t < best)) best = t;
  lcd.setCursor(0, 0);
  lcd.print("Lap ");
  lcd.print(laps);
  lcd.setCursor(0, 1);
  lcd.print(t, 1);
  lcd.print(" s ");
  if (best > 0) {
    lcd.print("best ");
    lcd.print(best, 1);
  }
}
