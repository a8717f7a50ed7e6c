// A line follower for daily use: a button starts it, Serial commands tune it, and it stops by itself when
// something is wrong. Robot: robot.toml in this folder, uno5 with a battery divider.
//
//   button            starts and stops the robot
//   Serial, 115200    one command per line:
//                       go, go SECONDS, stop     drives, drives for SECONDS, stops
//                       speed 60..255            PWM on straight lines
//                       gain 10..200             how hard the robot steers
//                       calibrate                measures the sensors' range: turns left and right for 2 s
//                       odometer MM              sets the odometer
//                       save                     saves speed, gain and odometer in EEPROM
//                       status, help
//   LED               blinks while the robot stands, is on while it drives
//
// The robot stops if it sees no line for 0.3 s, or if the voltage is too low for 50 ms. On an AVR the
// watchdog resets the chip if loop() takes longer than 120 ms; the robot then stays stopped.

#include <LineKit.h>
#if defined(__AVR__)
#include <avr/wdt.h>
#endif

#include "CommandLine.h"
#include "Settings.h"

const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4};  // left to right
const uint8_t BUTTON_PIN = 4, LED_PIN = 13, BATTERY_PIN = A5;

#if defined(ARDUINO_ARCH_STM32)
const uint16_t FULL_SCALE_MV = 3300;
#else
const uint16_t FULL_SCALE_MV = 5000;
#endif
const uint8_t BATTERY_TENTHS = 4;      // the divider passes 4/10 of the battery's voltage
const uint16_t EMPTY_MV = 6400;        // two lithium cells
const uint16_t UM_PER_EDGE = 326;      // pi * 32 mm / (2 * 154.35)
const uint8_t STEP_MS = 5;
const uint16_t LOST_MS = 300, EMPTY_MS = 50, BLINK_MS = 250;
const uint8_t CALIBRATION_STEPS = 200; // of 10 ms each

const char HELP[] PROGMEM = "go [SECONDS], stop, speed 60..255, gain 10..200, calibrate, odometer MM, save, status";

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
WheelEncoders encoders(2, 3);
PushButton button(BUTTON_PIN);
PidController pid(0, 0, 0);
CommandLine command;
Settings settings;

bool driving = false;
uint32_t drive_ms = 0;  // duration of the drive; 0 = no limit
uint32_t started_at, stepped_at, seen_at, healthy_at, blinked_at;
uint32_t edges = 0;  // of both wheels, since the odometer was settings.odometer_mm
bool lit = false;

void feedWatchdog() {
#if defined(__AVR__)
  wdt_reset();
#endif
}

uint16_t batteryMillivolts() {
  return static_cast<uint16_t>(analogRead(BATTERY_PIN) * (FULL_SCALE_MV * 10UL / BATTERY_TENTHS) / 1024);
}

uint32_t odometer() { return settings.odometer_mm + edges / 2 * UM_PER_EDGE / 1000; }

void setOdometer(uint32_t mm) {
  settings.odometer_mm = mm;
  edges = 0;
}

void go(uint32_t ms) {
  pid.setGains(settings.gain, settings.gain, 0.04f * settings.gain);
  pid.reset();
  drive_ms = ms;
  started_at = seen_at = millis();
  driving = true;
  Serial.println(F("driving"));
}

void stop(const __FlashStringHelper* why) {
  motors.stop();
  driving = false;
  Serial.print(F("stopped: "));
  Serial.println(why);
}

void calibrate() {
  sensors.startCalibration();
  for (uint8_t i = 0; i < CALIBRATION_STEPS; ++i) {
    const int16_t turn = i < CALIBRATION_STEPS / 4 || i >= CALIBRATION_STEPS * 3 / 4 ? 60 : -60;
    motors.drive(-turn, turn);
    sensors.calibrate();
    feedWatchdog();
    delay(10);
  }
  motors.stop();
  Serial.println(F("calibrated"));
}

void sayStatus() {
  Serial.print(driving ? F("driving") : F("standing"));
  Serial.print(F(", speed "));
  Serial.print(settings.speed);
  Serial.print(F(", gain "));
  Serial.print(settings.gain);
  Serial.print(F(", odometer "));
  Serial.print(odometer());
  Serial.print(F(" mm, battery "));
  Serial.print(batteryMillivolts());
  Serial.println(F(" mV"));
}

void sayHelp() {
  for (const char* at = HELP; pgm_read_byte(at) != 0; ++at) {
    Serial.write(pgm_read_byte(at));
    feedWatchdog();
  }
  Serial.println();
}

void set(uint8_t& setting, uint8_t least, uint8_t most) {
  const long value = command.number();
  if (value < least || value > most) {
    Serial.println(F("refused"));
    return;
  }
  setting = static_cast<uint8_t>(value);
  Serial.println(F("ok"));
}

void obey() {
  if (command.is(PSTR("go"))) {
    go(command.number() * 1000UL);
  } else if (command.is(PSTR("stop"))) {
    stop(F("told"));
  } else if (command.is(PSTR("speed"))) {
    set(settings.speed, 60, 255);
  } else if (command.is(PSTR("gain"))) {
    set(settings.gain, 10, 200);
  } else if (command.is(PSTR("calibrate"))) {
    calibrate();
  } else if (command.is(PSTR("odometer"))) {
    setOdometer(command.number());
    Serial.println(F("ok"));
  } else if (command.is(PSTR("save"))) {
    setOdometer(odometer());
    storeSettings(settings);
    Serial.println(F("saved"));
  } else if (command.is(PSTR("status"))) {
    sayStatus();
  } else if (command.is(PSTR("help"))) {
    sayHelp();
  } else {
    Serial.println(F("unknown; try help"));
  }
}

void blink(uint32_t now) {
  if (now - blinked_at >= BLINK_MS) {
    blinked_at = now;
    lit = !lit;
  }
  digitalWrite(LED_PIN, driving || lit ? HIGH : LOW);
}

// Reads all sensors and steers, once per STEP_MS.
void step(uint32_t now) {
  const float dt = (now - stepped_at) / 1000.0f;
  stepped_at = now;
  sensors.read();
  const int16_t left = encoders.takeLeft(), right = encoders.takeRight();  // the macro abs() would take them twice
  edges += abs(left) + abs(right);
  if (batteryMillivolts() >= EMPTY_MV) healthy_at = now;
  if (!driving) return;
  if (sensors.seesLine()) seen_at = now;
  if (now - seen_at >= LOST_MS) return stop(F("no line"));
  if (now - healthy_at >= EMPTY_MS) return stop(F("battery empty"));
  if (drive_ms > 0 && now - started_at >= drive_ms) return stop(F("time is up"));
  const float off = sensors.position() / 1000.0f;  // in sensor pitches; positive: the line is to the right
  const float turn = pid.update(off, dt);
  const float speed = max(60.0f, settings.speed - 40 * abs(off));
  motors.drive(speed + turn, speed - turn);
}

void setup() {
  Serial.begin(115200);
  pinMode(LED_PIN, OUTPUT);
  sensors.begin();
  sensors.setRange(110, 880);  // raw readings on the floor and on the line
  motors.begin();
  encoders.begin();
  button.begin();
  pid.setLimits(-120, 120);
  if (!loadSettings(settings)) Serial.println(F("no settings: mine"));
  Serial.println(F("ready"));
  stepped_at = healthy_at = blinked_at = millis();
#if defined(__AVR__)
  wdt_enable(WDTO_120MS);
#endif
}

void loop() {
  feedWatchdog();
  button.update();
  if (button.wasPressed()) {
    if (driving) {
      stop(F("button"));
    } else {
      go(0);
    }
  }
  if (command.read()) obey();
  const uint32_t now = millis();
  blink(now);
  if (now - stepped_at >= STEP_MS) step(now);
}
