// Runs tasks from a table, each with its own period, without delay(). One task plays a melody by tone().
typedef void (*TaskFunction)();
struct Task { TaskFunction run; unsigned int period; unsigned long due; };

void readSensors(); void control(); void sing(); void blink(); void status();
Task tasks[] = {
  {readSensors, 2, 0},
  {control, 10, 0},
  {sing, 150, 0},
  {blink, 500, 0},
  {status, 2000, 0},
};

#define NOTE_C5 523
#define NOTE_E5 659
#define NOTE_G5 784
const int melody[] = {NOTE_C5, NOTE_E5, NOTE_G5, NOTE_E5, NOTE_C5, 0, NOTE_G5, 0};
int value[5], position_ = 0;
bool lit = false;

void setup() {
  Serial.begin(19200);
  for (int i = 5; i <= 11; i++) pinMode(i, OUTPUT);
  pinMode(13, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
}

void loop() {
  unsigned long now = millis();
  for (Task& t : tasks) {
    if ((long)(now - t.due) >= 0) {
      t.due += t.period;
      t.run();
    }
  }
}

void readSensors() {
  for (int i = 0; i < 5; i++) value[i] = (3 * value[i] + analogRead(i)) / 4;
}

void control() {
  long num = 0, den = 1;
  for (int i = 0; i < 5; i++) {
    int v = max(value[i] - 200, 0);
    num += 100L * v * (i - 2);
    den += v;
  }
  position_ = num / den;
  analogWrite(5, constrain(90 + position_ / 2, 0, 255));
  analogWrite(6, constrain(90 - position_ / 2, 0, 255));
}

void sing() {
  static byte n = 0;
  int note = melody[n++ % (sizeof melody / sizeof *melody)];
  if (note) tone(11, note, 120);
  else noTone(11);
}

void blink() {
  lit = !lit;
  digitalWrite(13, lit);
}

void status() {
  Serial.print(F("position "));
  Serial.println(position_ / 50);
}
