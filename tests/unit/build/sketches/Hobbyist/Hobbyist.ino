// Follows a line as a hobbyist's sketch does. Uses short global names, String, a static object whose
// constructor sets up pins, and a motor library from a libraries folder.
#include <RobotMotor.h>

#define KP 0.08
#define KD 0.6

int error, last_error;
int index;
int position = 2000;
double y0;
bool stop;
int path[10], time, link;
String status = "starting";
char read[4];

class Lamp {
 public:
  Lamp(int p) : pin(p) { pinMode(pin, OUTPUT); }
  void set(bool on) { digitalWrite(pin, on ? HIGH : LOW); }

 private:
  int pin;
};

static Lamp lamp(LED_BUILTIN);
RobotMotor left(5, 7), right(6, 8);
const int sensors[] = {A0, A1, A2, A3, A4};

void setup() {
  Serial.begin(9600);
  left.begin();
  right.begin();
  status += " with ";
  status = status + 5 + " sensors";
  Serial.println(status);
  lamp.set(true);
}

void loop() {
  position = readLine();
  error = position - 2000;
  y0 = KP * error + KD * (error - last_error);
  last_error = error;
  drive(150 + y0, 150 - y0);
  if (++index == 100) {
    Serial.print("position ");
    Serial.println(position);
    index = 0;
    if (stop) exit(0);
  }
  delay(5);
}

int readLine() {
  long weighted = 0, sum = 0;
  for (int i = 0; i < 5; i++) {
    int value = analogRead(sensors[i]);
    weighted += 1000L * i * value;
    sum += value;
  }
  return sum == 0 ? position : weighted / sum;
}

void drive(int l, int r) {
  left.set(constrain(l, 0, 255));
  right.set(constrain(r, 0, 255));
}
