#include "sim/robot/electronics.h"

#include <algorithm>

#include "sim/robot/part_reader.h"

namespace robosim::robot {
namespace {

constexpr double kLedVolts = 1.2;

}  // namespace

class AnalogInputs::Input final : public PinSource {
 public:
  Input(const AnalogInputs& all, PinSource& source, Pin pin)
      : all_(all), source_(source), nominal_(all.board_.spec().supply_volts), pin_(pin) {
    all.snapshots_.add(state_);
  }

  Source output(SimTime t, double supply) override {
    const Source exact = source_.output(t, supply);
    // Each pin has its own noise samples.
    const double noise =
        all_.noise_volts_ * (supply / nominal_) * all_.noise_.gauss(state_.samples++ * kMaxPins + pin_);
    return {std::clamp(exact.volts + noise, 0.0, supply), exact.ohms};
  }
  bool level(SimTime t) override { return source_.level(t); }
  SimTime same_until(SimTime t) override { return source_.same_until(t); }

 private:
  struct State {
    std::uint64_t samples = 0;
  };

  const AnalogInputs& all_;
  PinSource& source_;
  const double nominal_;
  const Pin pin_;
  State state_;
};

Electronics read_electronics(const ConfigValue& table) {
  TableReader reader(table, "[electronics]");
  Electronics electronics;
  electronics.adc_noise = read_parameter(reader, "adc_noise", Dimension::ratio, {0.0, 0.0}, 0.0, 50.0);
  electronics.fed_by_battery = reader.boolean("fed_by_battery", false);
  reader.finish();
  return electronics;
}

Supply supply_at(double battery_volts, const BoardSpec& board) {
  const double nominal = board.supply_volts;
  const double volts = std::clamp(battery_volts - board.regulator_drop_volts, board.brown_out_volts, nominal);
  return {volts, std::max(volts - kLedVolts, 0.0) / (nominal - kLedVolts)};
}

AnalogInputs::AnalogInputs(RobotPort& board, double noise_volts, const NoiseStream& noise,
                           SnapshotRegistry& snapshots)
    : board_(board), noise_volts_(noise_volts), noise_(noise), snapshots_(snapshots) {}

AnalogInputs::~AnalogInputs() = default;

void AnalogInputs::connect(Pin pin, PinSource& source) {
  inputs_.push_back(std::make_unique<Input>(*this, source, pin));
  board_.connect(pin, *inputs_.back());
}

}  // namespace robosim::robot
