// Drives straight on with PWM of timer 1 on both enable pins. A letter on the serial line selects the duty:
//   s  40 % at 490 Hz
//   f  40 % at 31 kHz
//   d  at 31 kHz: full power for a second, and then half power, which slows the robot down
//   b  full power for a second, and then both motors are shorted
void both(byte duty) {
  analogWrite(9, duty);
  analogWrite(10, duty);
}

void setup() {
  for (byte pin = 7; pin <= 13; pin++) pinMode(pin, OUTPUT);
  Serial.begin(115200);
  while (!Serial.available()) {}
  const char way = Serial.read();
  if (way != 's') TCCR1B = (TCCR1B & 0xF8) | 1;
  digitalWrite(7, HIGH);
  digitalWrite(12, HIGH);
  if (way == 's' || way == 'f') {
    both(102);
    return;
  }
  both(255);
  delay(1000);
  if (way == 'd') {
    both(128);
  } else {
    digitalWrite(8, HIGH);
    digitalWrite(13, HIGH);
  }
}

void loop() {}
