// Drives when the button is pressed, but reads the wrong pin: the button is at pin 4.
#include <LineKit.h>

const uint8_t BUTTON_PIN = 12;

DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));

void setup() {
  Serial.begin(115200);
  pinMode(BUTTON_PIN, INPUT_PULLUP);
  motors.begin();
  Serial.println(F("Ready: press start"));
}

void loop() {
  if (digitalRead(BUTTON_PIN) == LOW) motors.drive(120, 120);
  delay(5);
}
