// Tests emulated boards whose chip is not an ATmega328P. The sketches use features in which these chips
// differ from an ATmega328P.
#include <map>

#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::boards_test {

using testing::HasSubstr;

class Boards : public AvrTest {};

TEST_F(Boards, ANano168HasHalfTheMemory) {
  board_name_ = "nano168";
  EXPECT_EQ(output(R"(
#include <EEPROM.h>
void setup() {
  Serial.begin(115200);
  Serial.println(RAMEND, HEX);
  Serial.println(EEPROM.length());
  EEPROM.write(511, 77);
  Serial.println(EEPROM.read(511));
}
void loop() {}
)"),
            "4FF\r\n512\r\n77\r\n");
  try {
    build(
        "char big[1100]; void setup() { Serial.begin(9600); Serial.println(big); } void loop() { ++big[3]; "
        "}");
    FAIL() << "it fits";
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("but the nano168 has 1024 of RAM"));
  }
}

TEST_F(Boards, AMegaHasPinsTimersAndChannelsThatAnUnoHasNot) {
  board_name_ = "mega";
  start(R"(
volatile int edges;
void count() { ++edges; }
void setup() {
  Serial.begin(115200);
  pinMode(49, OUTPUT);
  digitalWrite(49, HIGH);
  const uint8_t pins[] = {2, 4, 7, 8, 12, 13, 44, 46};
  for (uint8_t pin : pins) analogWrite(pin, 51);
  attachInterrupt(digitalPinToInterrupt(18), count, RISING);
  Serial.println(analogRead(A8));
  Serial.println(analogRead(A15));
  Serial.println(analogRead(A0));
  analogReference(INTERNAL2V56);
  Serial.println(analogRead(A15));
  pinMode(30, INPUT_PULLUP);
  Serial.println(digitalRead(30));
  delay(20);
  Serial.println(edges);
}
void loop() {}
)");
  FixedSource one(1.0), two(2.0), four(4.0);
  Pulse pulse(15 * kMillisecond, 16 * kMillisecond);
  board().connect(62, one);
  board().connect(69, two);
  board().connect(54, four);
  board().connect(18, pulse);
  run(14 * kMillisecond);
  board().schedule_edge(18, true, 15 * kMillisecond);
  run(2 * kMillisecond);
  run(20 * kMillisecond);
  ASSERT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_EQ(numbers(), (std::vector<long long>{204, 409, 819, 800, 1, 1}));
  EXPECT_TRUE(board().drive(49).level);
  EXPECT_EQ(board().drive(30).mode, PinMode::input_pullup);
  for (const Pin pin : {4, 13}) EXPECT_EQ(board().drive(pin).duty, 52.0 / 256) << "timer 0, pin " << int{pin};
  for (const Pin pin : {2, 7, 8, 12, 44, 46})
    EXPECT_EQ(board().drive(pin).duty, 0.2) << "phase correct, pin " << int{pin};
}

TEST_F(Boards, AMegasCodeAndConstantsMayLieBehind128KB) {
  board_name_ = "mega";
  EXPECT_EQ(output(R"(
#define BIG(n) const uint8_t big##n[30000] PROGMEM = {n}
BIG(1); BIG(2); BIG(3); BIG(4); BIG(5);
struct Base { virtual int value(int n) { return n; } };
struct Deeper : Base { int value(int n) override { return n == 0 ? 7 : value(n - 1) + 1; } };
Base* make() { static Deeper deeper; return &deeper; }
void __attribute__((noinline)) show(int n) { Serial.println(n); }
void (*volatile shower)(int) = show;
void setup() {
  Serial.begin(115200);
  uint32_t at = pgm_get_far_address(big5);
  Serial.println(at > 0x1FFFF - 30000 || pgm_get_far_address(big1) > 0x1FFFF - 30000);
  show(pgm_read_byte_far(at) + pgm_read_byte_far(pgm_get_far_address(big1)) +
       pgm_read_byte_far(pgm_get_far_address(big2) + (millis() >> 15)) +
       pgm_read_byte_far(pgm_get_far_address(big3)) + pgm_read_byte_far(pgm_get_far_address(big4)));
  shower(make()->value(40));
}
void loop() {}
)"),
            "1\r\n15\r\n47\r\n");
  EXPECT_GT(built_.text_bytes, 0x20000u);
}

TEST_F(Boards, SerialLinesThatNothingIsConnectedToSendAllTheSame) {
  board_name_ = "mega";
  EXPECT_EQ(output(R"(
void setup() {
  Serial.begin(115200);
  Serial1.begin(9600);
  Serial3.begin(57600);
  unsigned long began = micros();
  Serial1.print("0123456789");
  Serial3.print("0123456789");
  Serial1.flush();
  Serial.println((micros() - began) / 1000);
  Serial.println(Serial1.available());
}
void loop() {}
)"),
            "10\r\n0\r\n");
}

TEST_F(Boards, ALeonardosSerialIsItsUsb) {
  board_name_ = "leonardo";
  std::string expected = "begun\r\n";
  for (int i = 0; i < 60; ++i) expected += std::to_string(i) + " is a number; ";
  start(R"(
void setup() {
  Serial.println("before anybody listens");
  while (!Serial) {}
  Serial.println("begun");
  for (int i = 0; i < 60; ++i) { Serial.print(i); Serial.print(" is a number; "); }
}
void loop() {
  while (Serial.available()) Serial.write(Serial.read() + 1);
  delay(5);
}
)");
  run(119 * kMillisecond);
  EXPECT_EQ(serial_, "") << "the computer has not found the board yet";
  run(60 * kMillisecond);
  EXPECT_EQ(serial_, expected);
  serial_.clear();
  for (int i = 0; i < 200; ++i) board().receive_byte('a', now_ + i * kMicrosecond);
  run(40 * kMillisecond);
  ASSERT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_EQ(serial_, std::string(200, 'b')) << "the computer keeps bytes that exceed the chip's 128";
}

TEST_F(Boards, ALeonardoHasPwmAndAnalogInputsInOtherPlaces) {
  board_name_ = "micro";
  start(R"(
void setup() {
  const uint8_t pins[] = {3, 5, 6, 9, 10, 11, 13};
  for (uint8_t pin : pins) analogWrite(pin, 51);
  Serial1.begin(57600);
  int a0 = analogRead(A0), a6 = analogRead(A6), a11 = analogRead(A11);
  while (!Serial) {}
  Serial.println(a0);
  Serial.println(a6);
  Serial.println(a11);
}
void loop() {}
)");
  FixedSource one(1.0), two(2.0), four(4.0);
  board().connect(18, one);
  board().connect(find_pin(board().spec(), "A6"), two);
  board().connect(12, four);
  run(200 * kMillisecond);
  ASSERT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_EQ(numbers(), (std::vector<long long>{204, 409, 819}));
  for (const Pin pin : {3, 11}) EXPECT_EQ(board().drive(pin).duty, 52.0 / 256) << "timer 0, pin " << int{pin};
  for (const Pin pin : {5, 6, 9, 10, 13})
    EXPECT_EQ(board().drive(pin).duty, 0.2) << "phase correct, pin " << int{pin};
}

// The sketch raises pin 0 at every start, and pin 1 only after a watchdog reset.
constexpr const char* kLooksWhoResetIt = R"(
#include <avr/wdt.h>
void setup() {
  pinMode(0, OUTPUT);
  pinMode(1, OUTPUT);
  digitalWrite(0, HIGH);
  digitalWrite(1, MCUSR & _BV(WDRF) ? HIGH : LOW);
  if (MCUSR & _BV(WDRF)) { MCUSR = 0; wdt_disable(); for (;;) {} }
  MCUSR = 0;
  wdt_enable(WDTO_60MS);
}
void loop() {}
)";

TEST_F(Boards, ABareChipSaysThatItsWatchdogHasBitten) {
  board_name_ = "attiny85";
  start(kLooksWhoResetIt);
  run(50 * kMillisecond);
  EXPECT_FALSE(board().drive(1).level);
  run(250 * kMillisecond);
  ASSERT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_TRUE(board().drive(1).level);
}

TEST_F(Boards, ABootLoaderHidesThatTheWatchdogHasBitten) {
  board_name_ = "digispark";
  start(kLooksWhoResetIt);
  run(150 * kMillisecond);
  ASSERT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_FALSE(board().drive(1).level);
  EXPECT_GE(changes(0).size(), 5u) << "the sketch has started again";
}

TEST_F(Boards, AnAttiny85HasPwmOnThreePinsOfTwoTimersAndNoSerial) {
  board_name_ = "digispark";
  start(R"(
#include <EEPROM.h>
volatile byte edges;
ISR(PCINT0_vect) { ++edges; }
void setup() {
  const uint8_t pins[] = {0, 1, 4};
  for (uint8_t pin : pins) analogWrite(pin, 51);
  EEPROM.write(511, analogRead(A1) >> 2);
  EEPROM.write(510, EEPROM.length() >> 2);
  PCMSK = _BV(PCINT3);
  GIMSK = _BV(PCIE);
  unsigned long began = millis();
  while (millis() - began < 20) {}
  EEPROM.write(509, edges);
}
void loop() {}
)");
  struct : EepromWatcher {
    void eeprom_written(std::uint16_t address, std::uint8_t, std::uint8_t value, SimTime) override {
      written[address] = value;
    }
    std::map<int, int> written;
  } watcher;
  board().watch_eeprom(watcher);
  FixedSource one(1.0);
  Pulse pulse(15 * kMillisecond, 16 * kMillisecond);
  board().connect(2, one);
  board().connect(3, pulse);
  run(14 * kMillisecond);
  board().schedule_edge(3, true, 15 * kMillisecond);
  board().schedule_edge(3, false, 16 * kMillisecond);
  run(30 * kMillisecond);
  ASSERT_FALSE(avr_->crash()) << avr_->crash()->reason;
  EXPECT_EQ(watcher.written, (std::map<int, int>{{509, 2}, {510, 512 / 4}, {511, 51}}));
  for (const Pin pin : {0, 1}) EXPECT_EQ(board().drive(pin).duty, 52.0 / 256) << "timer 0, pin " << int{pin};
  EXPECT_EQ(board().drive(4).duty, 51.0 / 256) << "timer 1";
}

}  // namespace robosim::exec::boards_test
