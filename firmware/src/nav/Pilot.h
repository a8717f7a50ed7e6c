// A robot's place on a network, and its actions at a node, for Explorer and Navigator.
#ifndef LINEKIT_NAV_PILOT_H
#define LINEKIT_NAV_PILOT_H

#include "Network.h"

namespace nav {

template <class Walker, class Network>
class Pilot {
 public:
  typedef typename Network::Id Id;

  /// The node at which the robot stands, or kNone while it has met none.
  Id here() const { return here_; }
  /// How the robot faces. At a station: along the line.
  Heading heading() const { return heading_; }

 protected:
  Pilot(Walker& walker, Network& network) : walker_(walker), network_(network) {}

  /// Turns to an arm of the node at which the robot stands. At a station it faces the line already.
  void take(uint8_t slot) {
    const Heading out = headingOf(network_, here_, slot);
    if (!network_.isStation(here_)) walker_.leave(turnBetween(heading_, out));
    heading_ = out;
  }

  /// After `end` and `blocked`.
  void turnBack() {
    walker_.leave(Turn::back);
    heading_ = opposite(heading_);
  }

  /// The walker has come to `node` by the arm in `slot`, or so it should be. False if that cannot be.
  bool arrive(const Landmark& met, Id node, uint8_t slot) {
    const bool station = network_.isStation(node);
    if (met.kind != (station ? LandmarkKind::end : LandmarkKind::junction)) return false;
    here_ = node;
    heading_ = opposite(headingOf(network_, node, slot));
    if (station) {
      turnBack();
      return true;
    }
    if (!Walker::kKnowsPlaces) return true;
    if (((met.heading + frame_) & 3) != heading_) return false;
    if (placed_ && !network_.isAt(node, rotated(met.at, frame_))) return false;
    placeOn(node);
    return true;
  }

  /// "You are on this junction."
  void placeOn(Id node) {
    walker_.relocate(rotated(network_.place(node), static_cast<uint8_t>(4 - frame_)));
    placed_ = true;
  }

  Walker& walker_;
  Network& network_;
  Id here_ = Network::kNone;
  Heading heading_ = 0;
  // The walker counts headings and places from how it stood when it began. After a power cycle that is
  // another way than when it scanned.
  Heading frame_ = 0;   ///< of the walker, in the network's headings
  bool placed_ = true;  ///< whether the walker's places are the network's, turned by frame_
};

}  // namespace nav

#endif
