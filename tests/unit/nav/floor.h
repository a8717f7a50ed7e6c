// Simulates an abstract floor, which is a network of lines. Any two arms may be joined, because lines bend as
// needed. Also simulates a robot on this floor, with the Walker interface of firmware/src/nav.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firmware/src/nav/Landmark.h"

namespace nav_test {

using nav::rotated;
using nav::rotatedArms;

/// An arm of a node: the beginning of a line in one of four directions.
struct Arm {
  int node;
  nav::Heading heading;
  friend bool operator==(const Arm&, const Arm&) = default;
};

/// A network of lines. Headings and places are in the floor's frame, not in the robot's frame.
class Floor {
 public:
  struct Node {
    nav::Place at;
    uint8_t arms = 0;
    std::array<int, 4> line{-1, -1, -1, -1};
  };
  struct Line {
    Arm a, b;
    uint32_t cost;
    bool blocked = false;
  };

  int addNode(nav::Place at) {
    nodes.push_back({at});
    return static_cast<int>(nodes.size()) - 1;
  }
  int addNode() { return addNode({150 * static_cast<int32_t>(nodes.size()), 500}); }
  /// Adds a line between two free arms. Returns its number.
  int join(Arm a, Arm b, uint32_t cost = 10);
  int degree(int node) const { return nav::slotCount(nodes[node].arms); }
  bool isStation(int node) const { return degree(node) <= 1; }
  /// Returns the arm at the other end of a line.
  Arm across(int line, Arm from) const { return lines[line].a == from ? lines[line].b : lines[line].a; }

  std::vector<Node> nodes;
  std::vector<Line> lines;
};

/// The start of a robot: on the arm's node, with the arm's heading. If `on_line` is true, the robot has
/// already left the node through the arm, and is on the line.
struct Stand {
  Arm arm;
  bool on_line = false;
};

class FloorWalker {
 public:
  FloorWalker(Floor& floor, Stand start);

  nav::Landmark begin();
  nav::Landmark follow();
  void leave(nav::Turn turn);
  void relocate(const nav::Place& at);

  /// Returns the rotation of the walker's frame relative to the floor's frame, in quarter turns.
  int frame() const { return frame_; }
  /// Returns whether the robot is on a node. at() returns the node, and the heading in the floor's frame.
  bool onNode() const { return line_ < 0; }
  Arm at() const { return at_; }

  /// The number of times that the robot started along each line, from each of the line's ends.
  std::vector<std::array<int, 2>> runs;
  int follows = 0;
  /// Number of invalid commands: to follow a missing line, to turn where turning is impossible, or to
  /// relocate to a wrong place.
  int errors = 0;
  /// The error of odometry at each landmark, in the unit of nav::Place. The error does not accumulate.
  int32_t drift = 0;
  /// True if the robot does not know where it started, as after a power cycle. The first relocate() may then
  /// set any place.
  bool strange = false;
  /// An obstacle appears on line `block_line` before follow() number `block_before`, counted from 0.
  int block_before = -1, block_line = -1;

 private:
  nav::Landmark landmark(nav::LandmarkKind kind, uint32_t cost) const;
  nav::Landmark arriveBy(Arm in, uint32_t cost);

  Floor& floor_;
  Arm at_;               ///< on a node: the node and the heading; on a line: the arm where the robot entered
  int line_ = -1;        ///< the line on which the robot is
  bool inward_ = false;  ///< on a line: whether the robot faces the arm at_
  bool must_turn_ = false;
  int frame_ = 0;
  nav::Place origin_{0, 0}, offset_{0, 0};
};

/// A walker without odometry. It computes headings from the commanded turns, and does not notice bends.
class BlindWalker {
 public:
  static const bool kKnowsPlaces = false;
  BlindWalker(Floor& floor, Stand start) : walker(floor, start) {}

  nav::Landmark begin() { return blind(walker.begin()); }
  nav::Landmark follow() { return blind(walker.follow()); }
  void leave(nav::Turn turn) {
    walker.leave(turn);
    heading_ = nav::turned(heading_, turn);
  }
  void relocate(const nav::Place&) {}

  FloorWalker walker;

 private:
  nav::Landmark blind(nav::Landmark met) {
    met.arms = rotatedArms(met.arms, heading_ - met.heading);
    met.heading = heading_;
    met.at = {0, 0};
    return met;
  }
  nav::Heading heading_ = 0;
};

/// A walker with odometry.
class SeeingWalker : public FloorWalker {
 public:
  static const bool kKnowsPlaces = true;
  using FloorWalker::FloorWalker;
};

}  // namespace nav_test
