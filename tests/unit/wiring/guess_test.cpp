#include "sim/campaign/wiring/guess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/campaign/wiring/draft.h"

namespace robosim::wiring {
namespace guess_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const BoardSpec& uno() { return *find_board("uno"); }

// A run, which is a list of events at pins. Each function adds one event.
struct Seen {
  PinHistory history{uno()};

  Seen& output(const char* pin, bool level, std::int64_t t_ms = 0) {
    return drive({t_ms * 1'000'000, pin, "output", level});
  }
  Seen& pwm(const char* pin, double duty, std::int64_t t_ms = 0) {
    return drive({t_ms * 1'000'000, pin, "output", false, true, duty});
  }
  Seen& pull_up(const char* pin) { return drive({0, pin, "input_pullup"}); }
  Seen& look(const char* pin) {
    history.add(wire::LevelSeen{++reads, pin, true});
    history.end(10'000'000'000);
    return *this;
  }
  /// Reads several pins of a port at once.
  Seen& look_at_port(std::initializer_list<const char*> pins) {
    ++reads;
    for (const char* const pin : pins) history.add(wire::LevelSeen{reads, pin, true});
    history.end(10'000'000'000);
    return *this;
  }
  std::int64_t reads = 0;

  Seen& measure(const char* pin) {
    history.add(wire::VoltsSeen{1, pin, 2.0});
    return *this;
  }
  Seen& drive(wire::PinChange change) {
    history.add(change);
    history.end(10'000'000'000);
    return *this;
  }
};

std::string guessed(const std::string& source, const Seen& run, const Ways& ways = {}) {
  return text_of(guess(uno(), names_in_text(source, "a.ino", uno()), run.history, ways));
}

TEST(Guess, AMotorOnAnL298NHasAnEnableByPwmAndTwoInputs) {
  Seen run;
  run.pwm("D9", 0.5)
      .output("D8", true)
      .output("D7", false)
      .pwm("D10", 0.5)
      .output("D6", true)
      .output("D5", false);
  const std::string text = guessed(
      "#define ENA 9\n#define ENB 10\n#define IN1 8\n#define IN2 7\n#define IN3 6\n#define IN4 5\n"
      "void setup() { pinMode(ENA, 1); pinMode(ENB, 1); pinMode(IN1, 1); pinMode(IN2, 1); pinMode(IN3, 1); "
      "pinMode(IN4, 1); }",
      run);
  EXPECT_THAT(text, HasSubstr("type = \"motor\"\npins = { en = 9, in1 = 8, in2 = 7 }"));
  EXPECT_THAT(text, HasSubstr("type = \"motor\"\npins = { en = 10, in1 = 6, in2 = 5 }"));
  EXPECT_THAT(text, HasSubstr("chip = \"l298n\""));
  EXPECT_THAT(text, Not(HasSubstr("guessed from the order"))) << "the names identify the left motor";
}

TEST(Guess, WithoutNamesTheWayThatItMostlyDrivesIsForward) {
  Seen run;
  run.pwm("D5", 0.5)
      .output("D7", false)
      .output("D8", true)
      .pwm("D6", 0.5)
      .output("D9", true)
      .output("D10", false);
  const std::string text = guessed("", run);
  EXPECT_THAT(text, HasSubstr("pins = { en = 5, in1 = 8, in2 = 7 }"));
  EXPECT_THAT(text, HasSubstr("pins = { en = 6, in1 = 9, in2 = 10 }"));
  EXPECT_THAT(text, HasSubstr("# ? which motor is the left one is guessed"));
}

TEST(Guess, WhereTheNamesSayForwardAndItDrivesTheOtherWayTheMotorsAreReversed) {
  Seen run;
  run.output("D4", false).output("D5", true).output("D6", false).output("D7", true);
  const std::string text = guessed(
      "#define leftForward 4\n#define leftBackward 5\n#define rightForward 6\n#define rightBackward 7\n"
      "void setup() { pinMode(leftForward, 1); pinMode(leftBackward, 1); pinMode(rightForward, 1); "
      "pinMode(rightBackward, 1); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = { in1 = 4, in2 = 5 }\nreversed = true"));
  EXPECT_THAT(text, HasSubstr("pins = { in1 = 6, in2 = 7 }\nreversed = true"));
}

TEST(Guess, APinForTheDirectionAndOneForTheSpeedArePhaseAndEnable) {
  Seen run;
  run.pwm("D5", 0.5).output("D4", true).pwm("D6", 0.5).output("D7", true);
  const std::string text = guessed(
      "int dirL = 4, speedL = 5, speedR = 6, dirR = 7;\n"
      "void setup() { pinMode(dirL, 1); pinMode(speedL, 1); pinMode(speedR, 1); pinMode(dirR, 1); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = { en = 5, phase = 4 }"));
  EXPECT_THAT(text, HasSubstr("chip = \"drv8835\""));
}

TEST(Guess, SensorsStandInTheOrderOfTheirSides) {
  Seen run;
  run.look("D2").look("D3").look("D4");
  const std::string text = guessed(
      "#define right_sensor 2\n#define middle_sensor 3\n#define left_sensor 4\n"
      "void loop() { digitalRead(right_sensor); digitalRead(middle_sensor); digitalRead(left_sensor); }",
      run);
  EXPECT_THAT(text, HasSubstr("read = \"digital\"\npins = [4, 3, 2]"));
}

TEST(Guess, DirIsTheRightSideWhereAnotherNameSaysEsq) {
  Seen run;
  run.look("D2").look("D3").pwm("D5", 0.5).output("D4", true).pwm("D6", 0.5).output("D7", true);
  const std::string text = guessed(
      "const int sensorDir = 2, sensorEsq = 3, dirMotorDir = 4, pwmMotorDir = 5, pwmMotorEsq = 6, dirEsq = "
      "7;\n"
      "void loop() { digitalRead(sensorDir); digitalRead(sensorEsq); digitalWrite(dirMotorDir, 1); "
      "analogWrite(pwmMotorDir, 9); analogWrite(pwmMotorEsq, 9); digitalWrite(dirEsq, 1); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = [3, 2]"));
  EXPECT_THAT(text, HasSubstr("name = \"left\"                       # pwmMotorEsq, dirEsq"));
  EXPECT_THAT(text, HasSubstr("name = \"right\"                      # pwmMotorDir, dirMotorDir"));
}

TEST(Guess, EncodersAndReceiversAreNoLineSensors) {
  Seen run;
  for (const char* pin : {"D2", "D4", "D7", "D8", "D11"}) run.look(pin);
  const std::string text = guessed(
      "#define stepsLeft 2\n#define steerIn 11\nint ir[] = {4, 7, 8};\n"
      "void setup() { attachInterrupt(digitalPinToInterrupt(stepsLeft), count, RISING); }\n"
      "void loop() { pulseIn(steerIn, HIGH); for (int i = 0; i < 3; i++) digitalRead(ir[i]); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = [4, 7, 8]"));
  EXPECT_THAT(text, HasSubstr("type = \"encoder\"\npins = { a = 2 }"));
}

TEST(Guess, TheBOfASecondMotorIsNoDirection) {
  Seen run;
  run.pwm("D3", 0.5).output("D2", false).pwm("D5", 0.5).output("D4", false);
  const std::string text = guessed(
      "const int motorA = 2, motorB = 4, motorA_PWM = 3, motorB_PWM = 5;\n"
      "void setup() { pinMode(motorA, 1); pinMode(motorB, 1); pinMode(motorA_PWM, 1); pinMode(motorB_PWM, "
      "1); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = { en = 3, phase = 2 }"));
  EXPECT_THAT(text, HasSubstr("pins = { en = 5, phase = 4 }"));
}

TEST(Guess, APinThatIsChargedAndThenReadIsAnRcSensor) {
  Seen run;
  for (const char* pin : {"A0", "A1"}) run.output(pin, true).drive({10'000, pin, "input"}).look(pin);
  EXPECT_THAT(guessed("int s[] = {A0, A1};", run), HasSubstr("read = \"rc\""));
}

TEST(Guess, ANameThatAPinFunctionTakesPrecedesANumberThatHappensToBeEqual) {
  Seen run;
  run.pwm("D5", 0.5)
      .output("D7", true)
      .output("D8", false)
      .pwm("D6", 0.5)
      .output("D9", true)
      .output("D10", false);
  const std::string text = guessed(
      "const int STEP = 8, ENA = 5, IN1 = 7, IN2 = 8, ENB = 6, IN3 = 9, IN4 = 10;\n"
      "void setup() { go(STEP); pinMode(ENA, OUTPUT); pinMode(IN1, OUTPUT); pinMode(IN2, OUTPUT); "
      "pinMode(ENB, OUTPUT); pinMode(IN3, OUTPUT); pinMode(IN4, OUTPUT); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = { en = 5, in1 = 7, in2 = 8 }"));
  EXPECT_THAT(text, Not(HasSubstr("STEP")));
}

TEST(Guess, APinThatTheRunsDoNotReachIsGuessedFromTheCallsAndAskedFor) {
  const std::string text = guessed(
      "const int eyes[] = {A0, A1, A2};\n"
      "void loop() { while (!Serial.available()) {} for (int i = 0; i < 3; i++) analogRead(eyes[i]); }",
      Seen());
  EXPECT_THAT(text, HasSubstr("read = \"analog\"\npins = [\"A0\", \"A1\", \"A2\"]"));
  EXPECT_THAT(text, HasSubstr("# ? pin A0, A1, A2 (eyes, a.ino:1) were not used in the runs"));
}

TEST(Guess, APortsOtherPinsAreNotReadOnPurpose) {
  EXPECT_THAT(guessed("void loop() { digitalRead(2); digitalRead(4); }",
                      Seen().look_at_port({"D2", "D3", "D4", "D5"})),
              HasSubstr("pins = [2, 4]"));
}

TEST(Guess, ASeedForRandomNumbersIsNoSensor) {
  const std::string text =
      guessed("void setup() { randomSeed(analogRead(0)); }\nvoid loop() { digitalRead(2); digitalRead(3); }",
              Seen().measure("A0").look("D2").look("D3"));
  EXPECT_THAT(text, HasSubstr("pins = [2, 3]"));
  EXPECT_THAT(text, Not(HasSubstr("pin A0")));
}

TEST(Guess, MotorsOnTheMotorShieldR3HaveFixedPins) {
  Seen run;
  run.pwm("D3", 0.5)
      .output("D12", true)
      .output("D9", false)
      .pwm("D11", 0.5)
      .output("D13", false)
      .output("D8", false);
  const std::string text = guessed("", run);
  EXPECT_THAT(text, HasSubstr("pins = { en = 3, phase = 12 }\n"));
  EXPECT_THAT(text, HasSubstr("pins = { en = 11, phase = 13 }\nreversed = true"));
  EXPECT_THAT(text, HasSubstr("# ? pin 9 is the brake of channel A"));
  EXPECT_THAT(guessed("", run.output("D7", true)), Not(HasSubstr("brake")))
      << "the shield does not use pin 7";
}

TEST(Guess, AToshibaDriverOnThePinsOfTheMotorShieldIsNoShield) {
  Seen run;
  run.pwm("D3", 0.5).output("D12", true).output("D13", false).output("D10", true);
  run.pwm("D11", 0.5).output("D8", true).output("D9", false);
  const std::string text = guessed(
      "#define PWMA 3\n#define AIN1 12\n#define AIN2 13\n#define PWMB 11\n#define BIN1 8\n#define BIN2 9\n"
      "#define STBY 10\nvoid setup() { pinMode(PWMA, 1); pinMode(AIN1, 1); pinMode(AIN2, 1); pinMode(PWMB, "
      "1); "
      "pinMode(BIN1, 1); pinMode(BIN2, 1); pinMode(STBY, 1); }",
      run);
  EXPECT_THAT(text,
              AllOf(HasSubstr("{ en = 3, in1 = 12, in2 = 13 }"), HasSubstr("{ en = 11, in1 = 8, in2 = 9 }"),
                    HasSubstr("standby = 10"), Not(HasSubstr("brake"))));
}

TEST(Guess, SensorsWithNumbersStandInTheirOrder) {
  Seen run;
  for (const char* pin : {"D12", "D2", "D3", "D4"}) run.look(pin);
  const std::string text = guessed(
      "#define S1 2\n#define S2 3\n#define S3 4\n#define S0 12\n"
      "void loop() { digitalRead(S0); digitalRead(S1); digitalRead(S2); digitalRead(S3); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = [12, 2, 3, 4]"));
  EXPECT_THAT(text, HasSubstr("# ? the order from left to right is guessed"));
}

TEST(Guess, SensorsThatAreAllNamedAfterOneSideHaveNoKnownOrder) {
  Seen run;
  for (const char* pin : {"D2", "D3", "D4"}) run.look(pin);
  EXPECT_THAT(guessed("#define L1 2\n#define L2 3\n#define L3 4\n"
                      "void loop() { digitalRead(L1); digitalRead(L2); digitalRead(L3); }",
                      run),
              HasSubstr("# ? the order from left to right is guessed"));
}

TEST(Guess, EachDistanceSensorHasTheTriggerThatSharesItsName) {
  Seen run;
  for (const char* pin : {"D3", "D5", "D7"}) run.output(pin, true);
  for (const char* pin : {"D4", "D6", "D8"}) run.look(pin);
  const std::string text = guessed(
      "#define trigLeft 3\n#define trigFront 5\n#define trigRight 7\n"
      "#define echoRight 8\n#define echoLeft 4\n#define echoFront 6\n"
      "void loop() { digitalWrite(trigLeft, 1); digitalWrite(trigFront, 1); digitalWrite(trigRight, 1); "
      "pulseIn(echoRight, HIGH); pulseIn(echoLeft, HIGH); pulseIn(echoFront, HIGH); }",
      run);
  EXPECT_THAT(text, AllOf(HasSubstr("{ trig = 3, echo = 4 }"), HasSubstr("{ trig = 5, echo = 6 }"),
                          HasSubstr("{ trig = 7, echo = 8 }")));
}

TEST(Guess, TheNumberOfAPinThatOneLibraryTakesIsNotAChannelOfAnother) {
  const std::string text = guessed(
      "#define RECEIVER 2\nvoid setup() { qtr.setSensorPins((const uint8_t[]){A0, A1, A2, A3}, 4); "
      "IrReceiver.begin(RECEIVER, false); }",
      Seen());
  EXPECT_THAT(text, HasSubstr("pins = [\"A0\", \"A1\", \"A2\", \"A3\"]"));
}

TEST(Guess, QtrSensorsAnalogTakesChannels) {
  EXPECT_THAT(guessed("QTRSensorsAnalog qtr((unsigned char[]){0, 1, 2}, 3, 4, 2);", Seen()),
              HasSubstr("read = \"analog\"\npins = [\"A0\", \"A1\", \"A2\"]"));
}

TEST(Guess, InputsWithoutNamesArePairedByGuess) {
  Seen run;
  run.pwm("D9", 0.5)
      .output("D7", true)
      .output("D8", false)
      .pwm("D10", 0.5)
      .output("D4", true)
      .output("D5", false);
  EXPECT_THAT(guessed("", run), HasSubstr("# ? which inputs belong to which PWM pin is guessed"));
}

TEST(Guess, PinsThatARegisterReadsAreSensors) {
  Seen run;
  run.look_at_port({"A0", "A1", "A2"});
  EXPECT_THAT(guessed("void loop() { byte line = PINC & 7; }", run),
              HasSubstr("pins = [\"A0\", \"A1\", \"A2\"]"));
  EXPECT_THAT(guessed("void loop() {}", run), Not(HasSubstr("A0")));
}

TEST(Guess, AMotorThatLeansBackAloneIsReversedAlone) {
  Seen run;
  run.pwm("D9", 0.5)
      .output("D8", true)
      .output("D7", false)
      .pwm("D10", 0.5)
      .output("D6", false)
      .output("D5", true);
  const std::string source =
      "int lEN = 9, lIN1 = 8, lIN2 = 7, rEN = 10, rIN1 = 6, rIN2 = 5;\n"
      "void setup() { pinMode(lEN, 1); pinMode(lIN1, 1); pinMode(lIN2, 1); pinMode(rEN, 1); pinMode(rIN1, "
      "1); "
      "pinMode(rIN2, 1); }";
  EXPECT_THAT(guessed(source, run), HasSubstr("pins = { en = 9, in1 = 8, in2 = 7 }\n\n"));
  EXPECT_THAT(guessed(source, run), HasSubstr("pins = { en = 10, in1 = 6, in2 = 5 }\nreversed = true"));
  EXPECT_THAT(guessed(source, run, {.right_reversed = true}), Not(HasSubstr("reversed = true")));
}

TEST(Guess, NoPinOfADriverIsForgotten) {
  Seen run;
  run.pwm("D9", 0.5).output("D10", false).pwm("D11", 0.5).output("D12", false);
  EXPECT_THAT(guessed("int motorE1 = 9, motorE2 = 10, motorD1 = 11, motorD2 = 12;\n"
                      "void setup() { pinMode(motorE1, 1); pinMode(motorE2, 1); pinMode(motorD1, 1); "
                      "pinMode(motorD2, 1); }",
                      run),
              AllOf(HasSubstr("{ in1 = 9, in2 = 10 }"), HasSubstr("{ in1 = 11, in2 = 12 }")));
}

TEST(Guess, SensorsStandInTheOrderOfTheirArrayAlsoIfOneHasANameOfItsOwn) {
  Seen run;
  run.measure("A2").measure("A1").measure("A0");
  EXPECT_THAT(guessed("#define floorSensor A0\nint all[] = {A2, A1, A0};\n"
                      "void loop() { analogRead(floorSensor); analogRead(all[1]); }",
                      run),
              HasSubstr("pins = [\"A2\", \"A1\", \"A0\"]"));
}

TEST(Guess, HalfLeftIsBetweenLeftAndTheMiddle) {
  Seen run;
  for (const char* pin : {"A0", "A1", "A2", "A3", "A4"}) run.measure(pin);
  EXPECT_THAT(
      guessed(
          "#define sensorEsquerda A4\n#define sensorEsquerdaMeio A3\n#define sensorMeio A0\n"
          "#define sensorDireita A2\n#define sensorDireitaMeio A1\n"
          "void loop() { analogRead(sensorEsquerda); analogRead(sensorEsquerdaMeio); analogRead(sensorMeio); "
          "analogRead(sensorDireita); analogRead(sensorDireitaMeio); }",
          run),
      HasSubstr("pins = [\"A4\", \"A3\", \"A0\", \"A1\", \"A2\"]"));
}

TEST(Guess, AServoNamedS1DoesNotClashWithTheFirstSensor) {
  const std::string text =
      guessed("Servo S1;\nvoid setup() { S1.attach(9); }\nvoid loop() { digitalRead(2); digitalRead(3); }",
              Seen().look("D2").look("D3"));
  EXPECT_THAT(text, HasSubstr("name = \"part_S1\""));
}

TEST(Guess, AColourSensorReadWithPulseInIsNoDistanceSensor) {
  Seen run;
  run.output("D10", true).look("D11").look("D16");
  EXPECT_THAT(
      guessed("#define trig 10\n#define echoPin 11\n#define colourOut 16\n"
              "void loop() { pulseIn(colourOut, LOW); digitalWrite(trig, 1); pulseIn(echoPin, HIGH); }",
              run),
      HasSubstr("pins = { trig = 10, echo = 11 }"));
}

TEST(Guess, TheWaysThatNobodyCanKnowMakeDifferentRobots) {
  Seen run;
  run.measure("A0").measure("A1").measure("A2").measure("A3");
  const std::string source = "int s[] = {A0, A1, A2, A3};";
  EXPECT_THAT(guessed(source, run), HasSubstr("# ? HIGH over black is guessed"));
  EXPECT_THAT(guessed(source, run), Not(HasSubstr("\nblack = ")));
  EXPECT_THAT(guessed(source, run, {.black_low = true}), HasSubstr("black = \"low\""));
  EXPECT_THAT(guessed(source, run, {.other_order = true}), HasSubstr("first = \"right\""));
}

TEST(Guess, ButtonsBuzzersAndLedsAreKnownByNameOrByUse) {
  Seen run;
  run.pull_up("D4").look("D4").look("D12").output("D13", true).output("D3", true);
  run.drive({0, "D11", "output", false, false, 0.0, 440});
  const std::string text = guessed(
      "#define BUMPER 12\nconst int statusLed = 3;\n"
      "void loop() { digitalRead(BUMPER); digitalWrite(statusLed, 1); }",
      run);
  EXPECT_THAT(text, HasSubstr("type = \"button\"\npin = 4\n"));
  EXPECT_THAT(text, HasSubstr("type = \"bumper\"\npin = 12\nresistor = true"));
  EXPECT_THAT(text, HasSubstr("type = \"buzzer\"\npin = 11\n"));
  EXPECT_THAT(text, HasSubstr("type = \"led\"\npin = 13\n"));
  EXPECT_THAT(text, HasSubstr("type = \"led\"\npin = 3\n"));
}

TEST(Guess, AnArrayHasSensorsOfOneKind) {
  Seen run;
  run.look("D2").look("D3").measure("A1").measure("A2").measure("A3");
  const std::string text = guessed("void loop() { digitalRead(2); digitalRead(3); }", run);
  EXPECT_THAT(text, HasSubstr("read = \"analog\"\npins = [\"A1\", \"A2\", \"A3\"]"));
  EXPECT_THAT(text, HasSubstr("# ? pin 2 is read"));
  EXPECT_THAT(text, HasSubstr("# ? pin 3 is read"));
  const std::string digital = guessed("", Seen().look("D2").look("D3").look("D4").measure("A0"));
  EXPECT_THAT(digital, HasSubstr("read = \"digital\"\npins = [2, 3, 4]"));
  EXPECT_THAT(digital, HasSubstr("# ? pin A0 is measured"));
  EXPECT_THAT(guessed("", Seen().look("D2").look("D3").look("D4")), Not(HasSubstr("# ? pin")));
}

TEST(Guess, EveryEncoderHasAWheel) {
  Seen run;
  run.look("D2").look("D3").look("D4").look("D7");
  const std::string named = guessed("Encoder motorLeftEncoder(2, 4), motorRightEncoder(3, 7);", run);
  EXPECT_THAT(named, HasSubstr("name = \"motorLeftEncoder\""));
  EXPECT_THAT(named, HasSubstr("periods = 20\nwheel = \"left\""));
  EXPECT_THAT(named, HasSubstr("periods = 20\nwheel = \"right\""));
  EXPECT_THAT(named, Not(HasSubstr("guessed from the order of the encoders")));
  const std::string bare = guessed("Encoder first(2, 4), second(3, 7);", run);
  EXPECT_THAT(bare, HasSubstr("wheel = \"left\"\n# ? periods"));
  EXPECT_THAT(bare, HasSubstr("wheel = \"right\"\n# ? periods"));
  EXPECT_THAT(bare, HasSubstr("# ? wheel: guessed from the order of the encoders"));
  const std::string edge = guessed(
      "const int encSag = 3;\nvoid setup() { attachInterrupt(digitalPinToInterrupt(encSag), f, RISING); }",
      Seen().look("D3"));
  EXPECT_THAT(edge, HasSubstr("type = \"encoder\"\npins = { a = 3 }\nperiods = 20\nwheel = \"right\""));
}

TEST(Guess, ServosWithSidesDriveWheelsOnlyIfNoMotorDoes) {
  const std::string servos =
      "Servo servo_lt, servo_rt;\nvoid setup() { servo_lt.attach(9); servo_rt.attach(10); }";
  const std::string wheels = guessed(servos, Seen().output("D9", true).output("D10", true));
  EXPECT_THAT(wheels,
              HasSubstr("name = \"left\"                       # attach, a.ino:2\ntype = \"wheel-servo\""));
  EXPECT_THAT(wheels, HasSubstr("chip = \"servo\""));
  Seen run;
  run.output("D9", true)
      .output("D10", true)
      .pwm("D5", 0.5)
      .output("D4", true)
      .pwm("D6", 0.5)
      .output("D7", true);
  const std::string gripper =
      guessed(servos +
                  "\nint dirL = 4, speedL = 5, speedR = 6, dirR = 7;\nvoid loop() { digitalWrite(dirL, 1); "
                  "analogWrite(speedL, 9); analogWrite(speedR, 9); digitalWrite(dirR, 1); }",
              run);
  EXPECT_THAT(gripper, HasSubstr("name = \"servo_lt\""));
  EXPECT_THAT(gripper, HasSubstr("pins = { en = 5, phase = 4 }"));
  EXPECT_THAT(gripper, Not(HasSubstr("wheel-servo")));
  EXPECT_THAT(guessed("Servo pan, arm;\nvoid setup() { pan.attach(9); arm.attach(10); }",
                      Seen().output("D9", true).output("D10", true)),
              Not(HasSubstr("wheel-servo")));
}

TEST(Guess, NamesOfPartsAreLettersAndDigits) {
  const std::string text =
      guessed("Servo joints[2];\nvoid setup() { joints[0].attach(9); joints[1].attach(10); }",
              Seen().output("D9", true).output("D10", true));
  EXPECT_THAT(text, HasSubstr("name = \"servo\""));
  EXPECT_THAT(text, HasSubstr("name = \"servo_2\""));
  EXPECT_EQ(part_name({}, std::string(60, 'x')), std::string(36, 'x'));
  EXPECT_EQ(part_name({}, "]"), "part");
}

TEST(Draft, APartThatIsRefusedBecomesAQuestion) {
  RobotDraft draft;
  draft.parts = {{"left", "motor", {{"pins", "{ en = 5 }"}}, "ENA", {}},
                 {"eye", "led", {{"pin", "99"}}, "", {}}};
  draft.standby = "77";
  const std::string text = text_of(draft);
  const auto line_of = [&](const char* what) {
    return static_cast<int>(
               std::count(text.begin(), text.begin() + static_cast<long>(text.find(what)), '\n')) +
           1;
  };
  RobotDraft eye = draft;
  EXPECT_TRUE(remove_refused(eye, line_of("pin = 99"), "pin: expected 0 to 19"));
  EXPECT_THAT(text_of(eye),
              HasSubstr("# ? how is eye wired (led)? As drafted, it is refused: pin: expected 0 to 19"));
  EXPECT_EQ(eye.parts.size(), 1u);
  RobotDraft motor = draft;
  EXPECT_TRUE(remove_refused(motor, line_of("[[part]]"), "no"));
  EXPECT_EQ(motor.parts.at(0).name, "eye");
  RobotDraft driver = draft;
  EXPECT_TRUE(remove_refused(driver, line_of("standby"), "no"));
  EXPECT_EQ(driver.standby, "");
  EXPECT_EQ(driver.parts.size(), 2u);
  EXPECT_TRUE(remove_refused(driver, 1, "no"));
  EXPECT_THAT(driver.parts, IsEmpty());
  EXPECT_FALSE(remove_refused(driver, 1, "no"));
}

TEST(Guess, LibrariesBringTheirParts) {
  Seen run;
  run.output("D9", true).output("D12", true).look("D11").look("D2").output("D3", true);
  const std::string text =
      guessed("NewPing sonar(12, 11, 200);\nSoftwareSerial bt(2, 3);\nvoid setup() { pan.attach(9); }", run);
  EXPECT_THAT(text, HasSubstr("type = \"hc-sr04\"\npins = { trig = 12, echo = 11 }"));
  EXPECT_THAT(text, HasSubstr("type = \"bluetooth\"\npins = { txd = 2, rxd = 3 }"));
  EXPECT_THAT(text, HasSubstr("name = \"pan\""));
  EXPECT_THAT(text, HasSubstr("type = \"servo\"\npin = 9"));
}

TEST(Guess, MotorShieldsAreKnownByTheirLibraries) {
  Seen run;
  for (const char* pin : {"D4", "D7", "D8", "D12"}) run.output(pin, true);
  run.pwm("D11", 0.5).pwm("D3", 0.5);
  const std::string first =
      guessed("AF_DCMotor leftMotor(2, MOTOR12_1KHZ);\nAF_DCMotor rightMotor(1);\n", run);
  EXPECT_THAT(first,
              HasSubstr("type = \"shift-register\"\npins = { data = 8, clock = 4, latch = 12, enable = 7 }"));
  EXPECT_THAT(first, HasSubstr("name = \"left\""));
  EXPECT_THAT(first, HasSubstr("pins = { en = 3, in1 = \"shield.Q1\", in2 = \"shield.Q4\" }"));
  EXPECT_THAT(first, HasSubstr("pins = { en = 11, in1 = \"shield.Q2\", in2 = \"shield.Q3\" }"));
  EXPECT_THAT(first, HasSubstr("chip = \"l293d\""));
  EXPECT_THAT(first, Not(HasSubstr("No part was found"))) << first;

  const std::string second = guessed(
      "Adafruit_MotorShield AFMS = Adafruit_MotorShield();\nAdafruit_DCMotor *l = AFMS.getMotor(1);\n"
      "Adafruit_DCMotor *r = AFMS.getMotor(4);\nLiquidCrystal_I2C lcd(0x3F, 16, 2);\n",
      Seen());
  EXPECT_THAT(second, HasSubstr("type = \"pca9685\"\naddress = 0x60"));
  EXPECT_THAT(second, HasSubstr("pins = { en = \"shield.8\", in1 = \"shield.10\", in2 = \"shield.9\" }"));
  EXPECT_THAT(second, HasSubstr("pins = { en = \"shield.7\", in1 = \"shield.5\", in2 = \"shield.6\" }"));
  EXPECT_THAT(second, HasSubstr("type = \"lcd-i2c\"\naddress = 0x3F"));
}

TEST(Guess, NumbersOfMotorsOnAShieldAreNoSides) {
  const std::string two = guessed("AF_DCMotor motor1(1);\nAF_DCMotor motor2(2);\n", Seen());
  EXPECT_THAT(two, HasSubstr("# ? the left motor is guessed from the numbers of the motors"));
  const std::string four = guessed(
      "AF_DCMotor motor1(1);\nAF_DCMotor motor2(2);\nAF_DCMotor motor3(3);\nAF_DCMotor motor4(4);\n", Seen());
  EXPECT_THAT(four, HasSubstr("motors 1 and 2 are assumed to drive this side"));
  EXPECT_THAT(four, HasSubstr("motors 3 and 4 are assumed to drive this side"));
  EXPECT_THAT(
      guessed("AF_DCMotor left(1);\nAF_DCMotor right(2);\nAF_DCMotor arm(4);\n", Seen()),
      HasSubstr("# ? the name of motor 4 of the shield (AF_DCMotor(4), a.ino:3) does not name a side"));
}

TEST(Guess, AnEnablePinThatStaysHighIsNoMotor) {
  Seen run;
  run.pwm("D5", 0.5).output("D6", false).pwm("D9", 0.5).output("D10", false).output("D8", true);
  const std::string motors =
      "void f() { analogWrite(LF, 1); analogWrite(LB, 0); analogWrite(RF, 1); "
      "analogWrite(RB, 0); digitalWrite(motorEnable, HIGH); }";
  const std::string text = guessed(
      "#define LF 5\n#define LB 6\n#define RF 9\n#define RB 10\nconst int motorEnable = 8;\n" + motors, run);
  EXPECT_THAT(text, HasSubstr("standby = 8"));
  EXPECT_THAT(text, HasSubstr("pins = { in1 = 5, in2 = 6 }"));
  EXPECT_THAT(text, HasSubstr("pins = { in1 = 9, in2 = 10 }"));
  const std::string bare = guessed(
      "void f() { analogWrite(5, 1); analogWrite(6, 0); analogWrite(9, 1); analogWrite(10, 0); }", run);
  EXPECT_THAT(bare, HasSubstr("standby = 8"));
  EXPECT_THAT(bare, HasSubstr("pins = { in1 = 9, in2 = 10 }"));
}

TEST(Guess, ElementsOfAnArrayAreWhatTheyAreGivenTo) {
  Seen run;
  run.pwm("D5", 0.5)
      .output("D6", false)
      .pwm("D9", 0.5)
      .output("D10", false)
      .look("D2")
      .look("D3")
      .output("D13", true);
  const std::string text = guessed(
      "int motorPins[] = {5, 6, 9, 10};\nconst int pins[] = {2, 3, 13};\n"
      "void f() { analogWrite(motorPins[0], 1); analogWrite(motorPins[1], 0); analogWrite(motorPins[2], 1); "
      "analogWrite(motorPins[3], 0); digitalRead(pins[0]); digitalRead(pins[1]); digitalWrite(pins[2], 1); }",
      run);
  EXPECT_THAT(text, HasSubstr("pins = { in1 = 5, in2 = 6 }"));
  EXPECT_THAT(text, HasSubstr("pins = { in1 = 9, in2 = 10 }"));
  EXPECT_THAT(text, HasSubstr("read = \"digital\"\npins = [2, 3]"));
}

TEST(Guess, PinsThatMakeNoTwoMotorsAlikeAreAskedFor) {
  Seen run;
  run.pwm("D5", 0.5).output("D7", true).output("D8", false).pwm("D6", 0.5);
  const std::string text = guessed(
      "const int leftPwm = 5, leftA = 7, leftB = 8, rightPwm = 6;\n"
      "void f() { analogWrite(leftPwm, 9); digitalWrite(leftA, 1); digitalWrite(leftB, 0); "
      "analogWrite(rightPwm, 9); }",
      run);
  EXPECT_THAT(text, Not(HasSubstr("type = \"motor\"")))
      << "no driver has three inputs for one motor and one for the other";
  EXPECT_THAT(text,
              HasSubstr("# ? pin 6 (rightPwm, a.ino:1) is driven by analogWrite: what is wired to it?"));
  const std::string both =
      guessed("Wheel left(5, 7, 8), right(6, 9, 10);", run.output("D9", true).output("D10", false));
  EXPECT_THAT(both, HasSubstr("pins = { en = 5, in1 = 7, in2 = 8 }"));
  EXPECT_THAT(both, HasSubstr("pins = { en = 6, in1 = 9, in2 = 10 }"));
}

TEST(Guess, KeypadsAndShiftRegistersAreKnownByWhatTheyAreGiven) {
  Seen run;
  for (const char* pin : {"D6", "D7", "D8", "D9"}) run.pull_up(pin).look(pin);
  for (const char* pin : {"D3", "D4", "D5", "A0", "A1", "A2"}) run.output(pin, false);
  const std::string text = guessed(
      "byte rowPins[4] = {9, 8, 7, 6};\nbyte colPins[3] = {5, 4, 3};\n"
      "Keypad pad = Keypad(makeKeymap(keys), rowPins, colPins, 4, 3);\n"
      "int latchPin = A0, clockPin = A1, dataPin = A2;\n"
      "void loop() { digitalWrite(latchPin, LOW); shiftOut(dataPin, clockPin, MSBFIRST, 7); }",
      run);
  EXPECT_THAT(text, HasSubstr("type = \"keypad\"\nrows = [9, 8, 7, 6]\ncolumns = [5, 4, 3]"));
  EXPECT_THAT(
      text, HasSubstr("type = \"shift-register\"\npins = { data = \"A2\", clock = \"A1\", latch = \"A0\" }"));
  EXPECT_THAT(text, HasSubstr("# ? what is connected to the outputs of REG?"));
}

TEST(Guess, NumbersGivenToADisplayNameNoPins) {
  Seen run;
  run.measure("A0").measure("A1").pull_up("A4").pull_up("A5");
  const std::string text = guessed(
      "Adafruit_SSD1306 lcd(128, 64, &Wire, -1);\nvoid f() { lcd.setCursor(14, 18); lcd.begin(16, 2); }",
      run);
  EXPECT_THAT(text, HasSubstr("type = \"ssd1306\""));
  EXPECT_THAT(text, HasSubstr("pins = [\"A0\", \"A1\"]"));
  EXPECT_THAT(text, Not(HasSubstr("type = \"button\"")));
  EXPECT_THAT(guessed("", Seen().pull_up("A4").pull_up("A5")),
              HasSubstr("pin A4 and pin A5 are used as the two-wire bus"));
}

TEST(Guess, NamesThatAreOnlyHandedOnCountWhereTheirPinsAreUsed) {
  Seen run;
  run.pwm("D3", 0.5)
      .output("D4", true)
      .output("D7", false)
      .pwm("D11", 0.5)
      .output("D12", true)
      .output("D8", false);
  const std::string source =
      "const byte L_PWM = 3, L_A = 4, L_B = 7, R_PWM = 11, R_A = 12, R_B = 8;\nconst int TURN = 10;\n"
      "void motor(byte pwm, byte a, byte b, int v) { digitalWrite(a, v > 0); digitalWrite(b, v < 0); "
      "analogWrite(pwm, v); }\n"
      "void setup() { byte all[] = {L_PWM, L_A, L_B, R_PWM, R_A, R_B}; for (byte p : all) pinMode(p, "
      "OUTPUT); }\n"
      "void loop() { motor(L_PWM, L_A, L_B, TURN); motor(R_PWM, R_A, R_B, -TURN); drive(TURN); }\n";
  const std::string text = guessed(source, run);
  EXPECT_THAT(text, HasSubstr("# L_PWM, L_A, L_B\ntype = \"motor\"\npins = { en = 3, in1 = 4, in2 = 7 }"));
  EXPECT_THAT(text, HasSubstr("# R_PWM, R_A, R_B\ntype = \"motor\"\npins = { en = 11, in1 = 12, in2 = 8 }"));
  EXPECT_THAT(text, Not(HasSubstr("TURN"))) << "pin 10 is not used";
}

TEST(Guess, WhatIsUsedAndNotUnderstoodIsAskedFor) {
  Seen run;
  run.look("D7");
  EXPECT_THAT(guessed("#define BATT 7\nvoid loop() { digitalRead(BATT); }", run),
              HasSubstr("# ? pin 7 (BATT, a.ino:1) is read: what is wired to it?"));
  EXPECT_THAT(guessed("#define TAIL 7\nvoid loop() { digitalRead(TAIL); }", Seen()),
              HasSubstr("# ? pin 7 (TAIL, a.ino:1) was not used in the runs"));
  EXPECT_THAT(guess(uno(), {}, PinHistory(uno()), {}).parts, IsEmpty());
}

}  // namespace guess_test
}  // namespace robosim::wiring
