// Explores a network of lines, stores its map, and drives to any station by the fastest path. It is for
// Robosim's robot model uno5.
//
//   button          starts a scan from any line. The end of a line is a station; stations are numbered
//                   in the order of discovery
//   Serial, 115200  accepts a destination: a station's number or its name (NAMES), and a newline.
//                   Rejects anything else
//   LEDs            pin 13: on a junction, A5: at a station
//   buzzer          beeps briefly for success, and longer for an error
//   bumper          stops the robot; if the obstacle stays, the robot goes back and takes another path
//
// The EEPROM stores the map and the node at which the robot stopped, so a power cycle requires no new scan.
// If the robot was switched off between nodes, its position is unknown, and it must scan again.

#include <EEPROM.h>
#include <LineKit.h>
#include <nav/Explorer.h>
#include <nav/FixedNetwork.h>
#include <nav/Navigator.h>
#include <nav/NextPlanners.h>

#include "Memory.h"
#include "Walker.h"

// Names of the stations, starting with station 1. Change them for your floor, or remove them.
const char NAMES[] PROGMEM = "home\0dock\0shelf\0";

const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4};  // left to right
const uint8_t BUTTON_PIN = 4, BUMPER_PIN = 12;
const uint8_t LONGEST = 15;  // maximum length of a destination, in characters

typedef nav::FixedNetwork<60> Network;  // junctions less than 60 mm apart count as one
static_assert(Network::kRecordBytes <= STAND_AT, "the EEPROM is too small for this number of nodes");
typedef nav::Navigator<Walker, Network, nav::TreeOrDijkstra<> > Driver;

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
WheelEncoders encoders(2, 3);
PushButton button(BUTTON_PIN);
Walker walker(sensors, motors, encoders, BUMPER_PIN);
Network network;
Driver driver(walker, network);

// UNKNOWN: position unknown; STORED: read from the EEPROM, not yet verified; KNOWN: verified.
enum Placed : uint8_t { UNKNOWN, STORED, KNOWN } placed = UNKNOWN;
Stand stand;
char line[LONGEST + 2];
uint8_t length = 0;

void sayCount(uint8_t count, const __FlashStringHelper* what) {
  Serial.print(count);
  Serial.print(what);
  if (count != 1) Serial.print('s');
}

uint8_t stationCount() { return network.size() - network.junctions(); }

void sayNode(uint8_t node) {
  if (network.isStation(node)) {
    Serial.print(F("station "));
    Serial.print(nav::stationNumber(network, node));
  } else {
    Serial.print(F("junction "));
    Serial.print(network.row(node) + 1);
  }
}

// Returns the name of station `number`, or "".
const char* nameOf(uint8_t number) {
  const char* name = NAMES;
  while (--number > 0 && pgm_read_byte(name) != 0) name += strlen_P(name) + 1;
  return name;
}

void askForScan() { Serial.println(F("Put me on a line and press the button: I will scan.")); }

void ask() { Serial.println(F("destination?")); }

void loseMyself(const __FlashStringHelper* why) {
  placed = UNKNOWN;
  beep(BEEP_BAD);
  Serial.println(why);
  askForScan();
}

void sayWhere(const __FlashStringHelper* what, uint8_t node) {
  Serial.print(what);
  if (network.isStation(node)) {
    Serial.println(nav::stationNumber(network, node));
  } else {
    sayNode(node);
    Serial.println();
  }
}

// Stores the node at which the robot has stopped.
void settle() {
  placed = KNOWN;
  storeStand(driver.here(), driver.heading());
}

void sayFound(uint8_t first) {
  for (; first < network.size(); ++first) {
    Serial.print(F("found "));
    sayNode(first);
    Serial.println();
  }
}

void scan() {
  nav::Explorer<Walker, Network> explorer(walker, network);
  placed = UNKNOWN;
  forgetStand();
  Serial.println(F("scanning"));
  const uint32_t start = millis();
  network.clear();
  uint8_t known = 0;
  bool more = true;
  while (more) {
    more = explorer.step();
    sayFound(known);
    known = network.size();
  }
  if (explorer.state() == nav::ScanState::lost) return loseMyself(F("I have lost the line."));
  if (network.size() == 0) return loseMyself(F("There is no station and no junction here."));
  const bool complete = explorer.state() == nav::ScanState::complete;
  if (complete) {
    Serial.print(F("scan complete: "));
  } else if (explorer.state() == nav::ScanState::full) {
    Serial.print(F("My memory is full; there is more than I know: "));
  } else {
    Serial.print(F("An obstacle has cut the scan short; there is more than I know: "));
  }
  sayCount(stationCount(), F(" station"));
  Serial.print(F(", "));
  sayCount(network.junctions(), F(" junction"));
  Serial.print(F(", "));
  Serial.print((millis() - start) / 1000);
  Serial.println(F(" s"));
  beep(complete ? BEEP_GOOD : BEEP_BAD);
  EepromRecord record;
  network.save(record);
  driver.start(explorer.here(), explorer.heading());
  settle();
  sayWhere(F("at "), driver.here());
  ask();
}

void sayTurn(nav::Turn turn) {
  switch (turn) {
    case nav::Turn::straight:
      return Serial.print(F(" straight")), void();
    case nav::Turn::right:
      return Serial.print(F(" right")), void();
    case nav::Turn::back:
      return Serial.print(F(" back")), void();
    default:
      Serial.print(F(" left"));
  }
}

// Prints the junctions on the way, and the turn at each.
void sayWay() {
  const uint8_t to = driver.destination();
  uint8_t at = driver.here();
  nav::Heading facing = driver.heading();
  Serial.print(F("way:"));
  while (at != to) {
    const uint8_t next = driver.planner().next(network, at, to);
    const uint8_t slot = next == Network::kNone ? nav::kNoSlot : nav::slotTowards(network, at, next);
    if (slot == nav::kNoSlot) break;
    const nav::Heading out = nav::headingOf(network, at, slot);
    if (!network.isStation(at)) {
      Serial.print(' ');
      sayNode(at);
      sayTurn(nav::turnBetween(facing, out));
      Serial.print(',');
    }
    facing = nav::opposite(nav::headingOf(network, next, network.backSlot(at, slot)));
    at = next;
  }
  if (at == to) {
    Serial.print(' ');
    sayNode(to);
  } else {
    Serial.print(F(" none"));
  }
  Serial.println();
}

// Verifies the stored position after a power cycle.
bool lookRound() {
  if (driver.restore(stand.node, stand.heading)) {
    placed = KNOWN;
    return true;
  }
  forgetStand();
  loseMyself(F("I do not know where I am: this is not where I was switched off."));
  return false;
}

void goTo(uint8_t number) {
  if (placed == STORED && !lookRound()) return;
  driver.goTo(nav::stationNode(network, number));
  Serial.print(F("going to "));
  Serial.println(number);
  forgetStand();
  bool replan = true;
  do {
    if (replan) sayWay();
    walker.forgetObstacle();
    const bool more = driver.step();
    replan = walker.metObstacle();
    if (!more) break;
  } while (true);
  switch (driver.state()) {
    case nav::NavState::arrived:
      settle();
      beep(BEEP_GOOD);
      sayWhere(F("arrived at "), driver.here());
      return ask();
    case nav::NavState::no_way:
      settle();
      beep(BEEP_BAD);
      Serial.print(F("no way to "));
      Serial.println(number);
      sayWhere(F("at "), driver.here());
      return ask();
    case nav::NavState::trapped:
      return loseMyself(F("There are obstacles before and behind me."));
    default:
      return loseMyself(F("I do not know where I am."));
  }
}

void refuse() {
  beep(BEEP_BAD);
  Serial.print(F("refused. Stations: "));
  for (uint8_t number = 1; number <= stationCount(); ++number) {
    if (number > 1) Serial.print(F(", "));
    Serial.print(number);
    const char* name = nameOf(number);
    if (pgm_read_byte(name) == 0) continue;
    Serial.print(' ');
    Serial.print(reinterpret_cast<const __FlashStringHelper*>(name));
  }
  Serial.println();
}

// Returns the number of the station that the received text names, or 0.
uint8_t readDestination() {
  if (length > LONGEST) return 0;
  line[length] = 0;
  const uint8_t count = stationCount();
  uint16_t number = 0;
  bool digits = true;
  for (uint8_t i = 0; i < length && digits; ++i) {
    digits = line[i] >= '0' && line[i] <= '9';
    if (digits && number <= count) number = number * 10 + (line[i] - '0');
  }
  if (digits) return number <= count ? number : 0;
  for (uint8_t station = 1; station <= count; ++station) {
    const char* name = nameOf(station);
    if (pgm_read_byte(name) != 0 && strcmp_P(line, name) == 0) return station;
  }
  return 0;
}

void readSerial() {
  while (Serial.available() > 0) {
    const char c = Serial.read();
    if (c == '\r') continue;
    if (c != '\n') {
      if (length <= LONGEST) line[length++] = c;
      continue;
    }
    const bool empty = length == 0;
    const uint8_t number = readDestination();
    length = 0;
    if (empty) continue;
    if (placed == UNKNOWN) {
      Serial.println(F("refused: I do not know where I am."));
      askForScan();
    } else if (number == 0) {
      refuse();
    } else {
      goTo(number);
    }
  }
}

void setup() {
  Serial.begin(115200);
  button.begin();
  sensors.setRange(110, 880);  // on the floor, on the line
  walker.setup();
  Serial.println(F("ready"));
  EepromRecord record;
  if (isBlank()) return askForScan();
  if (!network.load(record)) return loseMyself(F("My map is damaged."));
  Serial.print(F("I have a map: "));
  sayCount(stationCount(), F(" station"));
  Serial.print(F(", "));
  sayCount(network.junctions(), F(" junction"));
  Serial.println();
  if (!loadStand(stand) || stand.node >= network.size())
    return loseMyself(F("I do not know where I am: I was switched off under way."));
  placed = STORED;
  sayWhere(F("at "), stand.node);
  ask();
}

void loop() {
  button.update();
  if (button.wasPressed()) scan();
  readSerial();
}
