// The motors are on pins 2, 4, 7 and 12, which have no PWM. A busy loop generates pulses at 100 Hz.
#define LF 2       // ENABLE of the left motor
#define LPHASE 4
#define RF 7
#define RPHASE 12
unsigned int dutyL, dutyR;            // high time in us, of a period of 10000 us
void pulse() {
  unsigned long t = micros() % 10000;
  digitalWrite(LF, t < dutyL);
  digitalWrite(RF, t < dutyR);
}
void setup() {
  pinMode(LF, OUTPUT); pinMode(LPHASE, OUTPUT); pinMode(RF, OUTPUT); pinMode(RPHASE, OUTPUT);
  digitalWrite(LPHASE, HIGH);
  digitalWrite(RPHASE, HIGH);
}
void loop() {
  int d = analogRead(A5) - analogRead(A4);   // right - left
  dutyL = constrain(2500 + 4L * d, 0, 9000);
  dutyR = constrain(2500 - 4L * d, 0, 9000);
  for (byte i = 0; i < 50; i++) pulse();
}
