// Drives a robot from landmark to landmark, to any node of a known network.
//
//   nav::Navigator<MyWalker, MyNetwork, nav::TreeOrDijkstra<>> navigator(walker, network);
//   navigator.start(explorer.here(), explorer.heading());      // after a scan
//   if (!navigator.goTo(nav::stationNode(network, 3))) refuse();
//   while (navigator.step()) showProgress();
//   if (navigator.state() == nav::NavState::arrived) …
//
// If the robot meets an obstacle on a line, the navigator records it in the network. Then it goes back to the
// last node, and plans another path. If there is no other path, it reports no_way and stays at that node.
// goTo() may then name another node.
//
// At a station the robot turns to face along the line, ready to leave. At a junction it keeps its heading.
//
// After a power cycle, load the network from EEPROM and call restore() instead of start(). restore() detects
// the lines around the robot, and returns false if they differ from the network.
//
// A planner is any type with
//
//   Id next(const Network&, Id here, Id to)   the next node on the path, or kNone
//   void forget()                             called when its earlier plans become invalid
//
// Available: ClimbPlanner (trees, no memory), DijkstraPlanner, TreeOrDijkstra, and PathPlanner for any of the
// planners in Plan.h. Only the planner that is named as the template argument takes flash.
#ifndef LINEKIT_NAV_NAVIGATOR_H
#define LINEKIT_NAV_NAVIGATOR_H

#include "Limits.h"
#include "Pilot.h"
#include "Plan.h"

namespace nav {

enum class NavState : uint8_t {
  idle,     ///< no destination yet
  driving,  ///< on the way; after each step() the robot stands at a node
  arrived,
  no_way,   ///< obstacles block every path; the robot stands at a node, here()
  trapped,  ///< obstacles in front and behind: the robot stands on a line that leaves from here()
  lost      ///< the walker reported `lost`, or a landmark that contradicts the network
};

template <class Walker, class Network, class Planner>
class Navigator : public Pilot<Walker, Network> {
  typedef Pilot<Walker, Network> Base;

 public:
  typedef typename Network::Id Id;

  Navigator(Walker& walker, Network& network) : Base(walker, network) {}
  Navigator(Walker& walker, Network& network, const Planner& planner)
      : Base(walker, network), planner_(planner) {}

  /// Sets the robot's node and heading, after a scan by an explorer with the same walker.
  void start(Id here, Heading heading) {
    here_ = to_ = here;
    heading_ = heading;
    frame_ = 0;
    placed_ = true;
    state_ = NavState::idle;
    planner_.forget();
  }

  /// Sets the robot's node and heading after a power cycle, and detects the lines around the robot. Returns
  /// false, and sets the state `lost`, if they differ from the network.
  bool restore(Id here, Heading heading) {
    start(here, heading);
    state_ = NavState::lost;
    if (here >= network_.size()) return false;
    const bool station = network_.isStation(here);
    const Landmark at = walker_.begin();
    if (at.kind != (station ? LandmarkKind::end : LandmarkKind::junction)) return false;
    if (station && at.arms != 0) heading_ = headingOf(network_, here, 0);
    frame_ = static_cast<Heading>((heading_ - at.heading) & 3);
    if (rotatedArms(at.arms, frame_) != network_.arms(here)) return false;
    placed_ = false;
    if (!station && Walker::kKnowsPlaces) this->placeOn(here);
    state_ = NavState::idle;
    return true;
  }

  /// Sets the destination. Returns false, without effect, if there is no such node, or the robot is trapped
  /// or does not know its position.
  bool goTo(Id to) {
    if (to >= network_.size() || here_ >= network_.size()) return false;
    if (state_ == NavState::trapped || state_ == NavState::lost) return false;
    to_ = to;
    state_ = here_ == to ? NavState::arrived : NavState::driving;
    planner_.forget();
    return true;
  }

  /// Moves to the next node. Returns false after the drive has ended; state() then returns the result.
  bool step() {
    if (state_ != NavState::driving) return false;
    const Id next = planner_.next(network_, here_, to_);
    const uint8_t slot = next == Network::kNone ? kNoSlot : slotTowards(network_, here_, next);
    if (slot == kNoSlot) {
      state_ = NavState::no_way;
    } else {
      drive(slot, next);
    }
    return state_ == NavState::driving;
  }

  NavState state() const { return state_; }
  Id destination() const { return to_; }
  Planner& planner() { return planner_; }

 private:
  using Base::arrive;
  using Base::frame_;
  using Base::heading_;
  using Base::here_;
  using Base::network_;
  using Base::placed_;
  using Base::take;
  using Base::turnBack;
  using Base::walker_;

  void drive(uint8_t slot, Id next) {
    const Id from = here_;
    const uint8_t back = network_.backSlot(from, slot);
    take(slot);
    Landmark met = walker_.follow();
    if (met.kind == LandmarkKind::blocked) {
      network_.block(from, slot);
      planner_.forget();
      turnBack();
      met = walker_.follow();
      if (met.kind == LandmarkKind::blocked) {
        state_ = NavState::trapped;
      } else if (!arrive(met, from, slot)) {
        state_ = NavState::lost;
      }
    } else if (!arrive(met, next, back)) {
      state_ = NavState::lost;
    } else if (next == to_) {
      state_ = NavState::arrived;
    }
  }

  Planner planner_;
  Id to_ = Network::kNone;
  NavState state_ = NavState::idle;
};

}  // namespace nav

#endif
