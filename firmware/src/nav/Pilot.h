// The base class of Explorer and Navigator. It tracks the robot's node and heading, and turns the robot.
#ifndef LINEKIT_NAV_PILOT_H
#define LINEKIT_NAV_PILOT_H

#include "Network.h"

namespace nav {

template <class Walker, class Network>
class Pilot {
 public:
  typedef typename Network::Id Id;

  /// Returns the robot's node, or kNone before it reaches the first node.
  Id here() const { return here_; }
  /// Returns the robot's heading. At a station the heading is along the line.
  Heading heading() const { return heading_; }

 protected:
  Pilot(Walker& walker, Network& network) : walker_(walker), network_(network) {}

  /// Turns to an arm of the robot's node. At a station the robot does not turn, because it already faces the
  /// line.
  void take(uint8_t slot) {
    const Heading out = headingOf(network_, here_, slot);
    if (!network_.isStation(here_)) walker_.leave(turnBetween(heading_, out));
    heading_ = out;
  }

  /// Turns the robot back. Call this after the landmarks `end` and `blocked`.
  void turnBack() {
    walker_.leave(Turn::back);
    heading_ = opposite(heading_);
  }

  /// Sets the robot's node and heading on arrival at `node` by the arm in `slot`. Returns false if the
  /// landmark contradicts the network.
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

  /// Tells the walker that it is at the place of the junction `node`.
  void placeOn(Id node) {
    walker_.relocate(rotated(network_.place(node), static_cast<uint8_t>(4 - frame_)));
    placed_ = true;
  }

  Walker& walker_;
  Network& network_;
  Id here_ = Network::kNone;
  Heading heading_ = 0;
  // The walker measures headings and places from its initial pose. After a power cycle, that pose can differ
  // from the initial pose of the Explorer, in whose frame the network is stored.
  Heading frame_ = 0;   ///< heading 0 of the walker, as a heading of the network
  bool placed_ = true;  ///< whether the walker's places, rotated by frame_, equal the network's places
};

}  // namespace nav

#endif
