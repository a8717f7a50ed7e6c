// type = "encoder": counts a wheel's rotation, on one channel or on two in quadrature.
//
// The position q counts quarter periods. It depends on the wheel's angle `a` in rad, and on `periods`, the
// number of periods per turn:
//   q = 4 periods a / (2 pi) + 1.5
//   channel A is high if floor(q) mod 4 is 0 or 1, channel B if it is 1 or 2
// In forward motion, A therefore leads B. Before the wheel has turned, both channels are high. The wheel's
// rate is constant within a tick, so the time of each edge is exact to the nanosecond.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_encoder(PartReader&);

class EncoderSpec final : public PartSpec {
 public:
  Side wheel = world::left;
  double periods = 0.0;  ///< number of periods of one channel per turn of the wheel
  Pin a = kNoPin;
  Pin b = kNoPin;  ///< kNoPin = a single channel
  bool reversed = false;

  std::unique_ptr<Part> make(PartContext&) const override;
};

class EncoderPart final : public Part, public Breakable {
 public:
  EncoderPart(const EncoderSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void read(std::vector<Reading>&) const override;

  const std::string& name() const override { return spec_.name; }
  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 private:
  class Channel final : public PinSource {
   public:
    Channel(EncoderPart& encoder, int shift) : encoder_(encoder), shift_(shift) {}
    bool level(SimTime t) override { return level_of(encoder_.quarter(t)); }
    bool level_of(std::int64_t quarter) const { return ((quarter + shift_) & 2) == 0; }

   private:
    EncoderPart& encoder_;
    const int shift_;
  };

  /// Returns floor(q) at `t`, a time inside the current tick.
  std::int64_t quarter(SimTime t) const;
  /// Returns the first time in the tick at which quarter() has reached or passed `edge`. `forward` is the
  /// direction of travel.
  SimTime time_of(std::int64_t edge, bool forward) const;
  void announce(std::int64_t from, std::int64_t to);

  struct State {
    // The value of q at the time `looked_at`, the start of a tick, and its change per ns. Updated when q is
    // read.
    double at = 1.5;
    double per_ns = 0.0;
    SimTime looked_at = -1;
    std::int64_t last = 1;  // value of quarter() up to which edges have been scheduled
    bool followed = false;  // the board requested edges in the last tick
    bool dead = false;
  };

  const EncoderSpec& spec_;
  PartContext& context_;
  Channel a_;
  Channel b_;
  const double quarters_per_rad_;
  mutable State state_;
};

}  // namespace robosim::robot
