// Explores a tree of lines, and then drives to any of its stations. Robot: pony (docs/howto/research.md).
//
//   button 1            starts a scan; if a line ends at the robot, that end is station 1
//   button 2            sets the position to station 1 of the stored map; first put the robot there
//   radio               accepts a destination: 8 bits, most significant first. A long beep reports any other
//                       number of bits, or a station that does not exist
//   digits              show the last station found during a scan, then the present station or destination
//   LEDs                light on a junction, at the end of a line, and while driving
//   collision sensor    makes the robot wait until the way is free; after five seconds the robot turns back
//
// Without encoders the robot cannot recognise a junction that it has visited, so the lines must form no loop.

#include <EEPROM.h>
#include <LineKit.h>
#include <nav/Explorer.h>
#include <nav/FixedTree.h>
#include <nav/Navigator.h>
#include <nav/NextPlanners.h>

#include "Pony.h"
#include "PonyWalker.h"

typedef nav::FixedTree<> Tree;
typedef nav::Navigator<PonyWalker, Tree, nav::ClimbPlanner> Driver;

const uint16_t SHORT_MS = 100, LONG_MS = 1000;
const uint8_t DASHES = 255;

Pony pony;
PushButton scan_button(4), station_button(12);
ClockedReceiver radio(5, 2, 3);  // data, clock, enable
PonyWalker walker(pony);
Tree tree;
Driver driver(walker, tree);
bool placed = false;  // whether the robot's position is known

// Stores a record's bytes in the EEPROM.
struct Memory {
  int at = 0;
  void put(uint8_t byte) { EEPROM.update(at++, byte); }
  uint8_t get() { return EEPROM.read(at++); }
};

void say(const __FlashStringHelper* text, int number) {
  Serial.print(text);
  Serial.println(number);
}

void refuse(const __FlashStringHelper* why) {
  Serial.println(why);
  pony.beep(LONG_MS);
}

void announce(uint8_t station) {
  say(F("at station "), station);
  pony.beep(SHORT_MS);
  pony.rest(2 * SHORT_MS);
}

void showPlace() {
  const bool at_station = placed && tree.isStation(driver.here());
  pony.show(at_station ? nav::stationNumber(tree, driver.here()) : DASHES);
}

void scan() {
  nav::Explorer<PonyWalker, Tree> explorer(walker, tree);
  Serial.println(F("scanning"));
  pony.show(0);
  uint8_t known = 0;
  while (explorer.step()) {
    for (; known < tree.size(); ++known) {
      if (!tree.isStation(known)) continue;
      pony.show(nav::stationNumber(tree, known));
      say(F("found station "), nav::stationNumber(tree, known));
    }
  }
  placed = explorer.state() != nav::ScanState::lost;
  if (placed) driver.start(explorer.here(), explorer.heading());
  showPlace();
  if (explorer.state() == nav::ScanState::lost) return refuse(F("lost the line"));
  if (explorer.state() == nav::ScanState::full) return refuse(F("too many nodes: is there a circle?"));
  if (explorer.state() == nav::ScanState::cut_off) return refuse(F("an obstacle cut the scan short"));
  Memory memory;
  tree.save(memory);
  pony.beep(SHORT_MS);
  say(F("scan complete, stations: "), tree.size() - tree.junctions());
}

void beAtStation1() {
  if (tree.size() == 0) return refuse(F("no map: scan first"));
  placed = driver.restore(nav::stationNode(tree, 1), 0);
  showPlace();
  if (!placed) return refuse(F("this is not the end of a line"));
  announce(1);
}

void goTo(uint8_t station) {
  const uint8_t node = nav::stationNode(tree, station);
  if (!placed) return refuse(F("refused: where am I?"));
  if (station == 0 || !driver.goTo(node)) return refuse(F("refused: no such station"));
  pony.show(station);
  say(F("to station "), station);
  while (driver.step()) {
  }
  if (driver.state() == nav::NavState::arrived) return announce(station);
  placed = driver.state() == nav::NavState::no_way;
  showPlace();
  refuse(placed ? F("no way: there is an obstacle") : F("lost"));
}

void setup() {
  Serial.begin(115200);
  pony.begin();
  scan_button.begin();
  station_button.begin();
  radio.begin();
  Memory memory;
  if (tree.load(memory)) say(F("map in memory, stations: "), tree.size() - tree.junctions());
  pony.show(DASHES);
  Serial.println(F("ready"));
}

void loop() {
  pony.step(0, 0);
  scan_button.update();
  station_button.update();
  if (scan_button.wasPressed()) scan();
  if (station_button.wasPressed()) beAtStation1();
  if (!radio.available()) return;
  if (radio.bits() == 8) {
    goTo(static_cast<uint8_t>(radio.value()));
  } else {
    refuse(F("refused: not 8 bits"));
  }
}
