// Collects the evidence for the sentence that explains a verdict.
#include <algorithm>

#include "sim/run/agent.h"

namespace robosim::run {

judge::Evidence Agent::evidence(judge::Verdict verdict, SimTime t) {
  judge::Evidence e;
  e.verdict = verdict;
  e.t = t;
  e.limit = verdict == judge::Verdict::timeout ? t : setup_.limit;
  e.map = setup_.map;
  e.goal = &goal_;
  e.progress = &progress_;
  e.judge = &judge_;
  e.crash = crash_;
  if (const exec::HostAccess* const host = executor_.host_access())
    e.divisions_by_zero = host->divisions_by_zero();
  e.exceeded = state_.exceeded;
  e.int_bits = executor_.int_bits();
  e.board = &board_.spec();
  e.wiring = robot_.wiring();
  e.went_high = state_.went_high;
  e.was_output = state_.was_output;
  e.was_pulled_up = state_.was_pulled_up;
  e.on_chip = executor_.chip_access() != nullptr;
  e.in_contact = body_.in_contact();
  const world::Contacts contacts = body_.contacts_with(world_.walls());
  if (body_.collided_with_body())
    e.stopped_by = "another robot";
  else if (!contacts.empty())
    e.stopped_by = world::to_string(world_.walls().solid_at(*contacts.begin()));
  e.toppled = body_.toppled();
  e.at = body_.pose().position;
  e.left_command = robot_.left_command();
  e.turning_drive = std::max(body_.turning_drive(world::left), body_.turning_drive(world::right));
  e.right_command = robot_.right_command();
  for (const world::Side side : {world::left, world::right})
    e.strongest_command[side] = robot_.strongest_command(side);
  for (const robot::WiredPin& wired : e.wiring) {
    if (wired.type.rfind("reflectance", 0) != 0 || wired.pin >= board_.spec().pin_count) continue;
    const exec::PinUse& use = executor_.probe().use(wired.pin);
    const SimTime seen = use.awaited ? t : use.last_seen;  // an interrupt counts as a read
    if (seen >= 0) e.sensors_read = e.sensors_read == kNever ? seen : std::max(e.sensors_read, seen);
  }
  e.line_side = state_.line_side;
  e.steered = state_.steered;
  e.faults = player_.faults();
  e.power = player_.power();
  e.moved = body_.wheel_travel() > 0.0;
  e.distance_m = body_.distance();
  e.off_line = state_.off_line_ticks * kTick;
  e.collisions = body_.collisions();
  if (verdict != judge::Verdict::reached) e.activity = executor_.activity();
  const bool is_pulse = e.activity.call.starts_with("pulseIn");
  const Pin looked_at = e.activity.polled != kNoPin && !is_pulse ? e.activity.polled : e.activity.pin;
  if (looked_at != kNoPin) {
    e.pin_level = executor_.probe().level(looked_at, t);
    const exec::PinUse& use = executor_.probe().use(looked_at);
    e.pin_changed = use.was_low && use.was_high;
  }
  return e;
}

}  // namespace robosim::run
