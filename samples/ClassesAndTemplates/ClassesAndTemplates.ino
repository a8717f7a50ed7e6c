#include "Robot.h"

// Sensors and strategies are objects. The robot follows the line by the strategy that use() has set.
SensorBar<5> bar({A0, A1, A2, A3, A4});
Wheel left(5, 7, 8), right(6, 9, 10);
Proportional gentle(0.05f);
Derivative sharp(0.06f, 0.5f);
Robot robot(bar, left, right);

void setup() {
  Serial.begin(9600);
  robot.begin();
  robot.use(&gentle);
}

void loop() {
  robot.step();
  if (millis() > 3000 && robot.strategy() == &gentle) {
    robot.use(&sharp);
    Serial.println(robot.strategy()->name());
  }
  delay(2);
}
