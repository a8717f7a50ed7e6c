const int speeds[] = {0, 120, 170};

void motorsBegin() {
  for (byte pin : MOTOR_PINS) pinMode(pin, OUTPUT);
}

void one(byte en, byte in1, byte in2, int speed) {
  digitalWrite(in1, speed > 0);
  digitalWrite(in2, speed < 0);
  analogWrite(en, min(abs(speed), 255));
}

void steer(float where, Mode how) {
  int v = speeds[how];
  int turn = where * v;
  one(EN_L, MOTOR_PINS[0], MOTOR_PINS[1], v + turn);
  one(EN_R, MOTOR_PINS[2], MOTOR_PINS[3], v - turn);
}
