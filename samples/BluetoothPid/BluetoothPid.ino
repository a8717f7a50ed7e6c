#include <SoftwareSerial.h>

// Follows a line with PD control. A phone (Serial Bluetooth Terminal) sends commands to the HC-05 module:
//   g = go, s = stop, p80 = Kp in thousandths, d60 = Kd in hundredths, ? = show
SoftwareSerial BT(10, 11);  // RX, TX

#define AIN1 7
#define AIN2 8
#define PWMA 6
#define BIN1 4
#define BIN2 2
#define PWMB 5
#define STBY 9

float Kp = 0.08, Ki = 0.0, Kd = 0.6;
int baseSpeed = 110;
const int maxSpeed = 200;

bool running = false;
int P, D, previousError = 0;
int minimo[6], maximo[6];

void calibrate() {
  for (int i = 0; i < 6; i++) {
    minimo[i] = 1023;
    maximo[i] = 0;
  }
  for (int n = 0; n < 200; n++) {
    // turns left, right and left again over the line
    if (n < 50 || n >= 150) motors(-60, 60);
    else motors(60, -60);
    for (int i = 0; i < 6; i++) {
      int v = analogRead(i);
      if (v < minimo[i]) minimo[i] = v;
      if (v > maximo[i]) maximo[i] = v;
    }
    delay(5);
  }
  motors(0, 0);
}

int readLine() {
  static int last = 2500;
  unsigned long avg = 0;
  unsigned int sum = 0;
  bool onLine = false;
  for (int i = 0; i < 6; i++) {
    int v = map(analogRead(i), minimo[i], maximo[i], 0, 1000);
    v = constrain(v, 0, 1000);
    if (v > 200) onLine = true;
    if (v > 50) {
      avg += (long)v * (i * 1000);
      sum += v;
    }
  }
  if (!onLine) return last < 2500 ? 0 : 5000;
  last = avg / sum;
  return last;
}

void motors(int left, int right) {
  left = constrain(left, -maxSpeed, maxSpeed);
  right = constrain(right, -maxSpeed, maxSpeed);
  digitalWrite(AIN1, left >= 0);
  digitalWrite(AIN2, left < 0);
  analogWrite(PWMA, abs(left));
  digitalWrite(BIN1, right >= 0);
  digitalWrite(BIN2, right < 0);
  analogWrite(PWMB, abs(right));
}

void setup() {
  BT.begin(9600);
  pinMode(AIN1, OUTPUT);
  pinMode(AIN2, OUTPUT);
  pinMode(PWMA, OUTPUT);
  pinMode(BIN1, OUTPUT);
  pinMode(BIN2, OUTPUT);
  pinMode(PWMB, OUTPUT);
  pinMode(STBY, OUTPUT);
  pinMode(13, OUTPUT);
  digitalWrite(STBY, HIGH);
  digitalWrite(13, HIGH);
  calibrate();
  digitalWrite(13, LOW);
  BT.println("calibrated, send g");
  while (BT.read() != 'g') {
  }
  running = true;
}

void command() {
  char c = BT.read();
  switch (c) {
    case 'g': running = true; BT.println("go"); break;
    case 's': running = false; motors(0, 0); BT.println("stopped"); break;
    case 'p': Kp = BT.parseInt() / 1000.0; break;
    case 'd': Kd = BT.parseInt() / 100.0; break;
    case '?':
      BT.print("Kp ");
      BT.print(Kp);
      BT.print(" Kd ");
      BT.println(Kd);
      break;
  }
}

void loop() {
  if (BT.available()) command();
  if (!running) return;
  int error = readLine() - 2500;
  P = error;
  D = error - previousError;
  previousError = error;
  int turn = Kp * P + Kd * D;
  motors(baseSpeed + turn, baseSpeed - turn);
  delay(3);
}
