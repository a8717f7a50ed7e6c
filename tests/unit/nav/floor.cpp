#include "floor.h"

#include <cstdlib>

namespace nav_test {

using nav::Landmark;
using nav::LandmarkKind;

int Floor::join(Arm a, Arm b, uint32_t cost) {
  lines.push_back({a, b, cost});
  const int line = static_cast<int>(lines.size()) - 1;
  for (const Arm& arm : {a, b}) {
    nodes[arm.node].arms = static_cast<uint8_t>(nodes[arm.node].arms | 1 << arm.heading);
    nodes[arm.node].line[arm.heading] = line;
  }
  return line;
}

FloorWalker::FloorWalker(Floor& floor, Stand start) : floor_(floor), at_(start.arm) {
  if (start.on_line) line_ = floor.nodes[at_.node].line[at_.heading];
}

Landmark FloorWalker::landmark(LandmarkKind kind, uint32_t cost) const {
  const Floor::Node& node = floor_.nodes[at_.node];
  const nav::Heading heading = inward_ ? nav::opposite(at_.heading) : at_.heading;
  nav::Place place = rotated({node.at.x - origin_.x, node.at.y - origin_.y}, -frame_);
  place.x += offset_.x + drift;
  place.y += offset_.y - drift;
  return {kind, rotatedArms(node.arms, -frame_), static_cast<nav::Heading>((heading - frame_) & 3), place,
          cost};
}

Landmark FloorWalker::begin() {
  runs.assign(floor_.lines.size(), {0, 0});
  const int degree = floor_.degree(at_.node);
  frame_ = at_.heading;
  origin_ = floor_.nodes[at_.node].at;
  if (line_ >= 0) return {LandmarkKind::line, 0, 0, {0, 0}, 0};
  if (degree > 1) return landmark(LandmarkKind::junction, 0);
  while (degree == 1 && floor_.nodes[at_.node].line[at_.heading] < 0) at_.heading = (at_.heading + 1) & 3;
  return landmark(LandmarkKind::end, 0);
}

Landmark FloorWalker::follow() {
  if (follows++ == block_before) floor_.lines[block_line].blocked = true;
  if (must_turn_) ++errors;
  if (line_ < 0) {
    line_ = floor_.nodes[at_.node].line[at_.heading];
    if (line_ < 0) {
      ++errors;
      return {LandmarkKind::lost, 0, 0, {0, 0}, 0};
    }
    ++runs[line_][floor_.lines[line_].a == at_ ? 0 : 1];
  }
  const Floor::Line& line = floor_.lines[line_];
  if (inward_) return arriveBy(at_, line.cost);
  if (!line.blocked) return arriveBy(floor_.across(line_, at_), line.cost);
  must_turn_ = true;
  return landmark(LandmarkKind::blocked, line.cost / 2);
}

Landmark FloorWalker::arriveBy(Arm in, uint32_t cost) {
  at_ = {in.node, nav::opposite(in.heading)};
  line_ = -1;
  inward_ = false;
  must_turn_ = floor_.isStation(in.node);
  return landmark(must_turn_ ? LandmarkKind::end : LandmarkKind::junction, cost);
}

void FloorWalker::leave(nav::Turn turn) {
  if ((must_turn_ || line_ >= 0) && turn != nav::Turn::back) ++errors;
  must_turn_ = false;
  if (line_ >= 0) {
    inward_ = !inward_;
    return;
  }
  at_.heading = nav::turned(at_.heading, turn);
  if (floor_.nodes[at_.node].line[at_.heading] < 0) ++errors;
}

void FloorWalker::relocate(const nav::Place& at) {
  const nav::Place& node = floor_.nodes[at_.node].at;
  const nav::Place here = rotated({node.x - origin_.x, node.y - origin_.y}, -frame_);
  const nav::Place off{at.x - here.x - offset_.x, at.y - here.y - offset_.y};
  if (strange) {
    offset_ = {at.x - here.x, at.y - here.y};
    strange = false;
  } else if (std::abs(off.x) > 60 || std::abs(off.y) > 60) {
    ++errors;
  }
}

}  // namespace nav_test
