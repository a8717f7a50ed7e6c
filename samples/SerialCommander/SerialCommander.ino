// Remote control by the serial monitor: F 500 = forward for 500 ms (B, L, R likewise), V 0.8 = speed factor,
// D = distance by an ultrasonic sensor. Every command blocks until it has finished.
float factor = 1.0;
#define echoPin 3
#define trigPin 2
void setup() {
  Serial.begin(9600);
  Serial.setTimeout(50);
  pinMode(trigPin, OUTPUT); pinMode(echoPin, INPUT);
  DDRB |= B00000110;          // pins 9, 10
  DDRD |= B11100000;          // pins 5, 6, 7
  pinMode(8, OUTPUT);
  while (!Serial) ;
  Serial.println("OK");
}
void go(int l, int r) {
  l *= factor; r *= factor;
  digitalWrite(7, l > 0); digitalWrite(8, l < 0);
  digitalWrite(9, r > 0); digitalWrite(10, r < 0);
  analogWrite(5, abs(l)); analogWrite(6, abs(r));
}
void loop() {
  if (Serial.available() == 0) return;
  char c = Serial.read();
  long t; 
  switch (toupper(c)) {
    case 'F': t = Serial.parseInt(); go(200, 200); delay(t); go(0, 0); break;
    case 'B': t = Serial.parseInt(); go(-200, -200); delay(t); go(0, 0); break;
    case 'L': t = Serial.parseInt(); go(-150, 150); delay(t); go(0, 0); break;
    case 'R': t = Serial.parseInt(); go(150, -150); delay(t); go(0, 0); break;
    case 'V': factor = Serial.parseFloat(); Serial.print("factor "); Serial.println(factor); return;
    case 'D': {
      digitalWrite(trigPin, HIGH); delayMicroseconds(10); digitalWrite(trigPin, LOW);
      Serial.print(pulseIn(echoPin, HIGH) * 0.0343 / 2, 0); Serial.println(" cm");
      return;
    }
    case '\n': case '\r': return;
    default: Serial.print("? "); Serial.println(c); return;
  }
  Serial.print(c); Serial.print(' '); Serial.print(t); Serial.println(" done");
}
