// Scans a network of lines into a graph: every station, every junction, every obstacle.
//
// A depth-first walk, the right-hand arm first. At a junction it has not met before it makes a node, takes
// the first arm to the right, explores all that lies behind it, comes back, and takes the next arm; behind
// the last one it returns the way it first came. On a tree this is the right-hand walk round all of it. A
// line that leads to a junction it has met before closes a cycle: it notes the line and goes back. So every
// line is run along once in each direction.
//
// It knows a junction again by its place, so it needs a Walker with odometry (kKnowsPlaces). Without one it
// must take every junction for a new one: right on trees only; on cycles it goes on until the network is
// full, which is reported.
//
// Where it begins does not matter. At the end of a line, that end is station 1 and the root of the graph.
// Elsewhere the first node it meets is the root, and the arm by which it came there is explored last.
//
//   nav::Explorer<MyWalker, MyNetwork> explorer(walker, network);
//   while (explorer.step()) showProgress();
//   if (explorer.state() == nav::ScanState::complete) …
#ifndef LINEKIT_NAV_EXPLORER_H
#define LINEKIT_NAV_EXPLORER_H

#include "Network.h"

namespace nav {

enum class ScanState : uint8_t {
  running,
  complete,  ///< every line that can be reached is known; the robot stands at the root
  full,      ///< the network's storage ended; what is known is right, but there is more
  cut_off,   ///< an obstacle came to stand on the way back; what is known is right
  lost       ///< the walker is lost, or met something that cannot be there
};

template <class Walker, class Network>
class Explorer {
 public:
  typedef typename Network::Id Id;

  Explorer(Walker& walker, Network& network) : walker_(walker), network_(network) {}

  /// Goes on to the next node (the first call: looks round and clears the network). False once the scan has
  /// ended, see state().
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

  ScanState state() const { return state_; }
  /// The node at which the robot stands, or kNone while it has met none.
  Id here() const { return here_; }
  /// How the robot faces. At a station: along the line.
  Heading heading() const { return heading_; }

 private:
  void begin() {
    begun_ = true;
    network_.clear();
    const Landmark at = walker_.begin();
    heading_ = at.heading;
    if (at.kind == LandmarkKind::lost) {
      state_ = ScanState::lost;
    } else if (at.kind == LandmarkKind::end) {
      here_ = network_.addStation(Network::kNone, 0, at.arms, opposite(at.heading), 0);
      if (at.arms == 0) state_ = ScanState::complete;
    } else if (at.kind == LandmarkKind::junction) {
      // Slot 0, explored last, is what comes last of right, straight, left, back.
      Heading last = opposite(heading_);
      while (!hasArm(at.arms, last)) last = static_cast<Heading>((last + 1) & 3);
      here_ = network_.addJunction(Network::kNone, 0, at.arms, opposite(last), at.at, 0);
    }
  }

  // Begun in the middle of a line: the first node on it is the root.
  void findRoot() {
    const Landmark met = walker_.follow();
    switch (met.kind) {
      case LandmarkKind::junction:
        here_ = network_.addJunction(Network::kNone, 0, met.arms, met.heading, met.at, 0);
        heading_ = met.heading;
        break;
      case LandmarkKind::end:
        here_ = network_.addStation(Network::kNone, 0, met.arms, met.heading, 0);
        turnBack(met);
        break;
      case LandmarkKind::blocked:
        if (blocked_behind_) state_ = ScanState::complete;  // a piece of line between two obstacles
        blocked_behind_ = true;
        turnBack(met);
        return;
      case LandmarkKind::loop:
        state_ = ScanState::complete;
        return;
      default:
        state_ = ScanState::lost;
        return;
    }
    if (blocked_behind_) network_.block(here_, 0);
  }

  void goOn() {
    const uint8_t count = slots(network_, here_);
    for (uint8_t i = 1; i <= count; ++i) {
      const uint8_t slot = i == count ? 0 : i;
      if (network_.link(here_, slot) == Network::kNone) return explore(slot);
    }
    const Id parent = network_.parent(here_);
    if (parent == Network::kNone) {
      state_ = ScanState::complete;
      return;
    }
    const uint8_t slot = network_.backSlot(here_, 0);
    const Id from = here_;
    take(0);
    const Landmark met = walker_.follow();
    if (met.kind == LandmarkKind::blocked) {
      network_.block(from, 0);
      turnBack(met);
      arrive(walker_.follow(), from, 0);
      if (state_ == ScanState::running) state_ = ScanState::cut_off;
      return;
    }
    arrive(met, parent, slot);
  }

  void explore(uint8_t slot) {
    const Id from = here_;
    take(slot);
    const Landmark met = walker_.follow();
    bool has_room = true;
    if (met.kind == LandmarkKind::end) {
      const Id station = network_.addStation(from, slot, met.arms, met.heading, met.cost);
      turnBack(met);
      if (station != Network::kNone) {
        here_ = station;
        return;
      }
      has_room = false;
    } else if (met.kind == LandmarkKind::blocked) {
      has_room = network_.block(from, slot);
      turnBack(met);
    } else if (met.kind == LandmarkKind::junction) {
      const Id known = Walker::kKnowsPlaces ? network_.find(met.at) : Id(Network::kNone);
      if (known == Network::kNone) {
        const Id junction = network_.addJunction(from, slot, met.arms, met.heading, met.at, met.cost);
        if (junction != Network::kNone) {
          here_ = junction;
          heading_ = met.heading;
          return;
        }
        has_room = false;
      } else {
        if (!hasArm(network_.arms(known), opposite(met.heading))) return lose();
        const uint8_t arrived_by = slotOf(network_.arms(known), network_.entry(known), opposite(met.heading));
        if (network_.link(known, arrived_by) != Network::kNone) return lose();
        has_room = network_.join(from, slot, known, arrived_by, met.cost);
        if (has_room && known == from) {  // a line from a junction to itself
          arrive(met, known, arrived_by);
          return;
        }
        walker_.relocate(network_.place(known));
      }
      turnBack(met);
    } else {
      return lose();
    }
    arrive(walker_.follow(), from, slot);
    if (!has_room && state_ == ScanState::running) state_ = ScanState::full;
  }

  /// Turns to an arm of the node at which the robot stands. At a station it faces the line already.
  void take(uint8_t slot) {
    const Heading out = headingOf(network_, here_, slot);
    if (!network_.isStation(here_)) walker_.leave(turnBetween(heading_, out));
    heading_ = out;
  }

  void turnBack(const Landmark& met) {
    walker_.leave(Turn::back);
    heading_ = opposite(met.heading);
  }

  /// The walker has come to `node` by the arm in `slot`, or so it should be.
  void arrive(const Landmark& met, Id node, uint8_t slot) {
    const bool station = network_.isStation(node);
    if (met.kind != (station ? LandmarkKind::end : LandmarkKind::junction)) return lose();
    here_ = node;
    if (station) return turnBack(met);
    heading_ = opposite(headingOf(network_, node, slot));
    if (!Walker::kKnowsPlaces) return;
    if (met.heading != heading_ || network_.find(met.at) != node) return lose();
    walker_.relocate(network_.place(node));
  }

  void lose() { state_ = ScanState::lost; }

  Walker& walker_;
  Network& network_;
  Id here_ = Network::kNone;
  Heading heading_ = 0;
  ScanState state_ = ScanState::running;
  bool begun_ = false;
  bool blocked_behind_ = false;  ///< before the first node
};

}  // namespace nav

#endif
