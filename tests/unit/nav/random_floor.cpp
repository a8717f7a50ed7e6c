#include "random_floor.h"

#include <algorithm>

namespace nav_test {
namespace {

// Adds `arms` free arms in random directions.
void addArms(Dice& dice, int node, int arms, std::vector<Arm>& free) {
  const int spare = dice.below(4);
  for (int h = 0; h < 4; ++h)
    if (arms == 4 || h != spare) free.push_back({node, static_cast<nav::Heading>(h)});
}

Arm take(std::vector<Arm>& free, int i) {
  const Arm arm = free[i];
  free[i] = free.back();
  free.pop_back();
  return arm;
}

int addSomewhere(Dice& dice, Floor& floor) {
  // Each node has its own row of a lattice, so nodes are farther apart than any tolerance.
  const int n = static_cast<int>(floor.nodes.size());
  return floor.addNode({200 * dice.below(100) - 10000, 100 * n - 5000});
}

void addStation(Dice& dice, Floor& floor, Arm arm) {
  const int node = addSomewhere(dice, floor);
  floor.join(arm, {node, static_cast<nav::Heading>(dice.below(4))}, 1 + dice.below(100));
}

}  // namespace

Floor randomTree(Dice& dice, int nodes, bool four_way) {
  Floor floor;
  std::vector<Arm> free{{addSomewhere(dice, floor), static_cast<nav::Heading>(dice.below(4))}};
  // Counts each free arm as a node, because each free arm gets a station after this loop.
  while (static_cast<int>(floor.nodes.size() + free.size()) + (four_way ? 3 : 2) <= nodes) {
    const Arm from = take(free, dice.below(static_cast<int>(free.size())));
    const int node = addSomewhere(dice, floor);
    std::vector<Arm> arms;
    addArms(dice, node, four_way && dice.oneIn(2) ? 4 : 3, arms);
    floor.join(from, take(arms, dice.below(static_cast<int>(arms.size()))), 1 + dice.below(100));
    free.insert(free.end(), arms.begin(), arms.end());
  }
  for (const Arm& arm : free) addStation(dice, floor, arm);
  return floor;
}

Floor randomNet(Dice& dice, int junctions, int percent_stations) {
  Floor floor;
  std::vector<Arm> free;
  for (int i = 0; i < junctions; ++i) {
    const int node = addSomewhere(dice, floor);
    std::vector<Arm> arms;
    addArms(dice, node, 3 + dice.below(2), arms);
    if (i > 0)
      floor.join(take(free, dice.below(static_cast<int>(free.size()))),
                 take(arms, dice.below(static_cast<int>(arms.size()))), 1 + dice.below(100));
    free.insert(free.end(), arms.begin(), arms.end());
  }
  while (!free.empty()) {
    const Arm from = take(free, dice.below(static_cast<int>(free.size())));
    if (free.empty() || dice.below(100) < percent_stations) {
      addStation(dice, floor, from);
    } else {
      floor.join(from, take(free, dice.below(static_cast<int>(free.size()))), 1 + dice.below(100));
    }
  }
  return floor;
}

void blockSome(Dice& dice, Floor& floor, int one_in) {
  for (Floor::Line& line : floor.lines) line.blocked = dice.oneIn(one_in);
}

Stand randomStand(Dice& dice, const Floor& floor) {
  const int node = dice.below(static_cast<int>(floor.nodes.size()));
  nav::Heading heading = static_cast<nav::Heading>(dice.below(4));
  if (!dice.oneIn(3)) return {{node, heading}};
  while (floor.nodes[node].line[heading] < 0) heading = (heading + 1) & 3;
  return {{node, heading}, true};
}

}  // namespace nav_test
