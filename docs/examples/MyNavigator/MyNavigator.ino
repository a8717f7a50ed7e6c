// A navigation algorithm of your own, as a sketch: copy this folder, change it, and run it.
//
//   robosim run ./MyNavigator --map d --robot uno5
//   robosim run ./MyNavigator --map d --robot uno5 --view
//
// LineKit's walker follows the line around bends to the next landmark: a junction, an end or an obstacle.
// The sketch decides which way the walker turns there. This example keeps to the left.

#include <LineKit.h>
#include <LineWalker.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4};  // left to right
const uint8_t BUMPER_PIN = 12;

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
WheelEncoders encoders(2, 3);
LineWalker walker(sensors, motors, encoders, BUMPER_PIN);

nav::Turn choose(const nav::Landmark& junction) {
  const nav::Turn wishes[] = {nav::Turn::left, nav::Turn::straight, nav::Turn::right};
  for (nav::Turn turn : wishes)
    if (nav::hasArm(junction.arms, nav::turned(junction.heading, turn))) return turn;
  return nav::Turn::back;
}

void setup() {
  Serial.begin(115200);
  sensors.setRange(110, 880);  // raw readings on the floor and on the line
  walker.setup();
  const nav::Landmark here = walker.begin();
  if (here.kind == nav::LandmarkKind::junction) walker.leave(choose(here));
}

void loop() {
  const nav::Landmark met = walker.follow();
  switch (met.kind) {
    case nav::LandmarkKind::junction:
      Serial.println(F("junction"));
      walker.leave(choose(met));
      break;
    case nav::LandmarkKind::end:
    case nav::LandmarkKind::blocked:
      Serial.println(met.kind == nav::LandmarkKind::end ? F("station") : F("obstacle"));
      walker.leave(nav::Turn::back);
      break;
    case nav::LandmarkKind::loop:  // a ring without landmarks: drive on
    case nav::LandmarkKind::line:
      break;
    case nav::LandmarkKind::lost:
      Serial.println(F("lost"));
      for (;;) delay(1000);
  }
}
