#include "sim/world/motor_winding.h"

#include <cmath>

#include "sim/base/exponential.h"

namespace robosim::world {
namespace {

constexpr int kMostPeriods = 12;
constexpr double kSteady = 1e-12;  // A

// A quantity and its derivatives with respect to the current at the period's start and to E.
struct Value {
  double value = 0.0, by_start = 0.0, by_emf = 0.0;
};

class Period {
 public:
  Period(double emf, double per_ohm, double tau, double start) : emf_(emf), per_ohm_(per_ohm), tau_(tau) {
    now_ = {start, 1.0, 0.0};
  }

  void pass(const Phase& phase) {
    double left = phase.share, decay = phase.decay;
    while (left > 0.0) {
      const int way = way_in(phase);
      if (way < 0) {  // the current stays at 0, also after a small change of start or E
        now_ = {};
        return;
      }
      const double target = (phase.volts[way] - emf_) * per_ohm_;
      const double end = target + (now_.value - target) * decay;
      // If a path conducts equally both ways, the direction is irrelevant.
      const bool one = phase.volts[0] == phase.volts[1] && phase.supply[0] == phase.supply[1];
      if (one || (way == 0 ? end >= 0.0 : end <= 0.0)) {
        flow(left, decay, end, target, phase.supply[way]);
        return;
      }
      const double until_zero = target / (target - now_.value);  // decay until the current is 0
      const double lasts = -tau_ * log_of(until_zero);
      flow(lasts, until_zero, 0.0, target, phase.supply[way]);
      left -= lasts;
      decay = left > 0.0 ? decay_of(left / tau_) : 1.0;
      // After its change of sign, the current has another rate of change.
      const int other = way_in(phase);
      if (other < 0) {
        now_ = {};
        return;
      }
      const double rates = (phase.volts[other] - emf_) * per_ohm_ / target;
      now_ = {0.0, now_.by_start * rates, now_.by_emf * rates};
    }
  }

  const Value& now() const { return now_; }
  const Value& charge() const { return charge_; }
  const Value& drawn() const { return drawn_; }

 private:
  // Returns the direction in which the current flows or begins to flow: 0 forward, 1 backward, -1 neither.
  int way_in(const Phase& phase) const {
    if (now_.value > 0.0) return 0;
    if (now_.value < 0.0) return 1;
    if (phase.volts[0] > emf_) return 0;
    return phase.volts[1] < emf_ ? 1 : -1;
  }

  void flow(double lasts, double decay, double end, double target, double supply) {
    const Value next = {end, now_.by_start * decay, (now_.by_emf + per_ohm_) * decay - per_ohm_};
    const Value part = {target * lasts - tau_ * (next.value - now_.value),
                        -tau_ * (next.by_start - now_.by_start),
                        -per_ohm_ * lasts - tau_ * (next.by_emf - now_.by_emf)};
    add(charge_, part, 1.0);
    if (supply != 0.0) add(drawn_, part, supply);
    now_ = next;
  }

  static void add(Value& sum, const Value& part, double times) {
    sum.value += times * part.value;
    sum.by_start += times * part.by_start;
    sum.by_emf += times * part.by_emf;
  }

  const double emf_, per_ohm_, tau_;
  Value now_, charge_, drawn_;
};

// Returns the means of a current that reaches its final value at the beginning of each phase.
MeanCurrent settled(std::span<const Phase> phases, double emf, double per_ohm) {
  MeanCurrent mean;
  for (const Phase& phase : phases) {
    const int way = phase.volts[0] > emf ? 0 : 1;
    if (way == 1 && !(phase.volts[1] < emf)) continue;
    const double amps = phase.share * (phase.volts[way] - emf) * per_ohm, per_volt = -phase.share * per_ohm;
    mean.amps += amps;
    mean.amps_per_volt += per_volt;
    mean.drawn += phase.supply[way] * amps;
    mean.drawn_per_volt += phase.supply[way] * per_volt;
  }
  return mean;
}

}  // namespace

MeanCurrent mean_current(std::span<const Phase> phases, double emf, double per_ohm, double tau) {
  if (tau == 0.0 || phases.size() < 2) return settled(phases, emf, per_ohm);
  double start = 0.0;
  for (int n = 1;; ++n) {
    Period period(emf, per_ohm, tau, start);
    for (const Phase& phase : phases) period.pass(phase);
    const Value& end = period.now();
    const double off = end.value - start;
    if (std::fabs(off) > kSteady && n < kMostPeriods) {
      start += off / (1.0 - end.by_start);
      continue;
    }
    const double start_by_emf = end.by_emf / (1.0 - end.by_start);
    const auto per_volt = [start_by_emf](const Value& sum) {
      return sum.by_emf + sum.by_start * start_by_emf;
    };
    return {period.charge().value, per_volt(period.charge()), period.drawn().value, per_volt(period.drawn())};
  }
}

}  // namespace robosim::world
