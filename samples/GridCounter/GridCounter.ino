// Follows a grid: 3 crossings, right turn, 2 crossings, right turn, 1 crossing, stop (robotics club, task 3).
const byte L_EYE = 2, C_EYE = 3, R_EYE = 4;   // 1 = black
#define ENA 5
#define IN1 8
#define IN2 9
#define IN3 10
#define IN4 12
#define ENB 6

struct Step { byte crossings; char then; };
const Step plan[] = { {3, 'R'}, {2, 'R'}, {1, 'S'} };
byte crossing = 0, leg = 0;

void motor(int l, int r) {
  digitalWrite(IN1, l > 0); digitalWrite(IN2, l < 0);
  digitalWrite(IN3, r > 0); digitalWrite(IN4, r < 0);
  analogWrite(ENA, abs(l)); analogWrite(ENB, abs(r));
}

void follow() {
  bool l = digitalRead(L_EYE), c = digitalRead(C_EYE), r = digitalRead(R_EYE);
  if (l && !r) motor(10, 60);
  else if (r && !l) motor(60, 10);
  else motor(55, 55);
}

bool onCrossing() {
  return digitalRead(L_EYE) && digitalRead(R_EYE);
}

void turnRight() {
  motor(55, 55); delay(250);         // moves the wheels onto the crossing
  motor(50, -50);
  while (digitalRead(C_EYE)) ;          // turns away from the old line
  delay(100);
  while (!digitalRead(C_EYE)) ;
  motor(0, 0); delay(200);
}

void setup() {
  for (byte p = 2; p <= 4; p++) pinMode(p, INPUT);
  for (byte p = 5; p <= 12; p++) if (p != 7 && p != 11) pinMode(p, OUTPUT);
  Serial.begin(9600);
  delay(1000);
}

void loop() {
  follow();
  if (!onCrossing()) return;
  crossing++;
  Serial.print("crossing "); Serial.println(crossing);
  if (crossing == plan[leg].crossings) {
    crossing = 0;
    if (plan[leg].then == 'R') {
      turnRight();
    } else {
      motor(0, 0);
      Serial.println("arrived");
      for (;;) ;
    }
    leg++;
  } else {
    while (onCrossing()) follow();     // counts the crossing only once
    delay(50);
  }
}
