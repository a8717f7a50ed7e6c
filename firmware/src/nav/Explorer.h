// Explores a network of lines and records it as a graph: every station, every junction, every obstacle.
//
// The explorer makes a depth-first walk. An arm is a line that leaves a node. At a new junction the explorer
// adds a node and takes the first arm to the right. It explores everything beyond that arm, comes back, and
// takes the next arm. After the last arm it returns along the arm of its first arrival. A line that leads to
// a known junction closes a cycle: the explorer records the line and goes back. So the robot drives along
// every line once in each direction.
//
// The explorer recognises a junction by its coordinates, so it needs a Walker with odometry (kKnowsPlaces).
// Without odometry it treats every junction as new, which is correct only if the lines form a tree. If they
// form a cycle, the scan continues until the network's memory is full. It then ends with ScanState::full.
//
// The scan can begin anywhere. If it begins at the end of a line, that end is station 1 and the root of the
// graph. If it begins on a junction, that junction is the root. Otherwise the first node that the robot meets
// is the root. The robot explores the root's arm of arrival last.
//
// An obstacle is recorded at the arm that leads to it. If the robot also meets the obstacle from the other
// side, the arm on that side gets a record, too. The line between the two arms stays unknown. If the robot
// later arrives by a blocked arm, that arm is open again.
//
//   nav::Explorer<MyWalker, MyNetwork> explorer(walker, network);
//   while (explorer.step()) showProgress();
//   if (explorer.state() == nav::ScanState::complete) …
#ifndef LINEKIT_NAV_EXPLORER_H
#define LINEKIT_NAV_EXPLORER_H

#include "Pilot.h"

namespace nav {

enum class ScanState : uint8_t {
  running,
  complete,  ///< every reachable line is known; the robot stands at the root
  full,      ///< the network's storage is full; its content is correct, but incomplete
  cut_off,   ///< a new obstacle blocks the way back; the network's content is correct
  lost       ///< the walker reported `lost`, or a landmark that contradicts the network
};

template <class Walker, class Network>
class Explorer : public Pilot<Walker, Network> {
  typedef Pilot<Walker, Network> Base;

 public:
  typedef typename Network::Id Id;

  Explorer(Walker& walker, Network& network) : Base(walker, network) {}

  /// Moves to the next node. The first call clears the network and detects the lines around the robot.
  /// Returns false after the scan has ended; state() then returns the result.
  bool step() {
    if (state_ != ScanState::running) return false;
    if (!begun_) {
      begin();
    } else if (here_ == Network::kNone) {
      findRoot();
    } else {
      goOn();
    }
    return state_ == ScanState::running;
  }

  /// Makes the next step() begin a new scan.
  void restart() {
    state_ = ScanState::running;
    begun_ = blocked_behind_ = false;
  }

  ScanState state() const { return state_; }

 private:
  using Base::arrive;
  using Base::heading_;
  using Base::here_;
  using Base::network_;
  using Base::take;
  using Base::turnBack;
  using Base::walker_;

  void begin() {
    begun_ = true;
    network_.clear();
    here_ = Network::kNone;
    const Landmark at = walker_.begin();
    heading_ = at.heading;
    switch (at.kind) {
      case LandmarkKind::line:
        return;
      case LandmarkKind::end:
        here_ = network_.addStation(Network::kNone, 0, at.arms == 0 ? 0 : armBehind(opposite(heading_)),
                                    opposite(heading_), 0);
        if (at.arms == 0) state_ = ScanState::complete;
        return;
      case LandmarkKind::junction:
        if ((at.arms & 15) != 0) return addRoot(at);
        break;
      default:
        break;
    }
    lose();
  }

  // Adds the junction on which the robot begins as the root. Its slot 0, which is explored last, is the arm
  // behind the robot. If that arm is missing, slot 0 is the first existing arm of left, straight and right.
  void addRoot(const Landmark& at) {
    Heading last = opposite(heading_);
    while (!hasArm(at.arms, last)) last = static_cast<Heading>((last + 1) & 3);
    here_ = network_.addJunction(Network::kNone, 0, at.arms, opposite(last), at.at, 0);
    if (here_ == Network::kNone) state_ = ScanState::full;
  }

  // Follows the line on which the scan has begun. The first node on that line becomes the root.
  void findRoot() {
    const Landmark met = walker_.follow();
    heading_ = met.heading;
    if (isJunction(met)) {
      here_ = network_.addJunction(Network::kNone, 0, met.arms, heading_, met.at, 0);
      if (here_ == Network::kNone) state_ = ScanState::full;
    } else if (met.kind == LandmarkKind::end) {
      here_ = network_.addStation(Network::kNone, 0, armBehind(heading_), heading_, 0);
      turnBack();
    } else if (met.kind == LandmarkKind::blocked) {
      if (blocked_behind_) state_ = ScanState::complete;  // a line between two obstacles
      blocked_behind_ = true;
      turnBack();
      return;
    } else if (met.kind == LandmarkKind::loop) {
      state_ = ScanState::complete;
      return;
    } else {
      return lose();
    }
    if (blocked_behind_ && here_ != Network::kNone) network_.block(here_, 0);
  }

  void goOn() {
    const uint8_t count = slots(network_, here_);
    for (uint8_t i = 1; i <= count; ++i) {
      const uint8_t slot = i == count ? 0 : i;
      if (network_.link(here_, slot) == Network::kNone) return explore(slot);
    }
    if (network_.parent(here_) == Network::kNone) {
      state_ = ScanState::complete;
    } else {
      goBack();
    }
  }

  void goBack() {
    const Id from = here_, parent = network_.parent(from);
    const uint8_t slot = network_.backSlot(from, 0);
    take(0);
    const Landmark met = walker_.follow();
    if (met.kind != LandmarkKind::blocked) {
      if (!arrive(met, parent, slot)) lose();
      return;
    }
    network_.block(from, 0);
    state_ = ScanState::cut_off;
    retreat(from, 0);
  }

  void explore(uint8_t slot) {
    const Id from = here_;
    take(slot);
    const Landmark met = walker_.follow();
    heading_ = met.heading;
    bool has_room;
    if (met.kind == LandmarkKind::end) {
      here_ = network_.addStation(from, slot, armBehind(heading_), heading_, met.cost);
      has_room = here_ != Network::kNone;
      if (has_room) return turnBack();
    } else if (met.kind == LandmarkKind::blocked) {
      has_room = network_.block(from, slot);
    } else if (isJunction(met)) {
      const Id known = Walker::kKnowsPlaces ? network_.find(met.at) : Id(Network::kNone);
      if (known != Network::kNone) return close(met, from, slot, known);
      here_ = network_.addJunction(from, slot, met.arms, heading_, met.at, met.cost);
      has_room = here_ != Network::kNone;
      if (has_room) return;
    } else {
      return lose();
    }
    if (!has_room) state_ = ScanState::full;
    retreat(from, slot);
  }

  // Records a line that has led to a known junction, and goes back along that line.
  void close(const Landmark& met, Id from, uint8_t slot, Id known) {
    const uint8_t arms = network_.arms(known);
    if (!hasArm(arms, opposite(heading_))) return lose();
    const uint8_t back = slotOf(arms, network_.entry(known), opposite(heading_));
    const Id behind = network_.link(known, back);
    if (behind != Network::kNone && behind != Network::kBlocked) return lose();
    if (known == from && back == slot) return lose();
    const bool has_room = network_.join(from, slot, known, back, met.cost);
    if (has_room && known == from) {  // a line from a junction to itself
      if (!arrive(met, known, back)) lose();
      return;
    }
    if (!has_room) state_ = ScanState::full;
    walker_.relocate(network_.place(known));
    retreat(from, slot);
  }

  /// Goes back to `from` along the line at its `slot`. If a new obstacle blocks that line, the robot
  /// turns round again. It then drives to the node at the other end, if that node is known.
  void retreat(Id from, uint8_t slot) {
    const Id ahead = network_.link(from, slot);
    turnBack();
    Landmark met = walker_.follow();
    if (met.kind != LandmarkKind::blocked || ahead >= network_.size()) {
      if (!arrive(met, from, slot)) lose();
      return;
    }
    const uint8_t ahead_slot = network_.backSlot(from, slot);
    network_.block(from, slot);
    state_ = ScanState::cut_off;
    turnBack();
    met = walker_.follow();
    if (!arrive(met, ahead, ahead_slot)) lose();
  }

  static bool isJunction(const Landmark& met) {
    return met.kind == LandmarkKind::junction && hasArm(met.arms, opposite(met.heading));
  }
  static uint8_t armBehind(Heading heading) { return static_cast<uint8_t>(1 << opposite(heading)); }

  void lose() { state_ = ScanState::lost; }

  ScanState state_ = ScanState::running;
  bool begun_ = false;
  bool blocked_behind_ = false;  ///< the robot met an obstacle before the first node
};

}  // namespace nav

#endif
