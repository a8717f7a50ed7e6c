// Robots on the edge: whether a target, with its clock a little off, does what another did in its place.
// docs/comparing.md says why that tells chance from a fault.
#pragma once

#include "sim/analysis/compare.h"

namespace robosim::analysis {

/// Whether `mine` does as `other` did where two targets differ, and for 2 s more; or ends as that does.
bool does_as(const History& mine, const History& other, const Difference& found);

/// Whether a target's own difference is of the sort of that found, within 2 s of it; or, wherever, between
/// the same two ways: the same two manoeuvres, the same two times at places of one sort.
bool is_alike(const Difference& own, const Difference& found);

/// It is where the robot is, and when: not what it says, and it has no cause that has a name.
bool is_of_driving(const Difference& difference);

}  // namespace robosim::analysis
