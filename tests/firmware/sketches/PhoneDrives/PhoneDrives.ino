// A phone drives the robot by Bluetooth: `f` drives forward, and `s` stops. Other bytes are refused.
#include <SoftwareSerial.h>

SoftwareSerial phone(2, 3);

void drive(int speed) {
  digitalWrite(7, HIGH);
  digitalWrite(8, LOW);
  digitalWrite(9, HIGH);
  digitalWrite(10, LOW);
  analogWrite(5, speed);
  analogWrite(6, speed);
}

void setup() {
  for (int pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  phone.begin(9600);
  phone.println("ready");
}

void loop() {
  if (!phone.available()) return;
  char wish = phone.read();
  if (wish == 'f') drive(120);
  if (wish == 's') drive(0);
  phone.println(wish == 'f' ? "forward" : wish == 's' ? "stop" : "what?");
}
