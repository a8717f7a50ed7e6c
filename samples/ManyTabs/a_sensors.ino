static float seen = 0;

void sensorsBegin() {
  for (byte i = 0; i < SENSORS; i++) pinMode(SENSOR_PINS[i], INPUT);
}

Reading look() {
  Reading r;
  r.black = 0;
  r.position = 0;
  for (byte i = 0; i < SENSORS; i++) {
    if (digitalRead(SENSOR_PINS[i])) {
      r.black++;
      r.position += (int)i - 1;
    }
  }
  if (r.black) {
    r.position /= r.black;
    if (r.position != 0) seen = r.position;
  }
  r.lastSeen = seen;
  return r;
}
