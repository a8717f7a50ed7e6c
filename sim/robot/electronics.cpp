#include "sim/robot/electronics.h"

#include <algorithm>

#include "sim/robot/part_reader.h"

namespace robosim::robot {
namespace {

constexpr double kLedVolts = 1.2;

}  // namespace

class AnalogInputs::Input final : public PinSource {
 public:
  Input(const AnalogInputs& all, PinSource& source, Scale scale, Pin pin)
      : all_(all), source_(source), scale_(scale), nominal_(all.board_.spec().supply_volts), pin_(pin) {
    all.snapshots_.add(state_);
  }

  double volts(SimTime t) override {
    double volts = source_.volts(t);
    if (scale_ == Scale::volts) volts /= all_.supply_.share;
    // Each pin has its own noise samples.
    if (all_.noise_volts_ > 0.0)
      volts += all_.noise_volts_ * all_.noise_.gauss(state_.samples++ * kMaxPins + pin_);
    return std::clamp(volts, 0.0, nominal_);
  }
  bool level(SimTime t) override { return source_.level(t); }
  SimTime same_until(SimTime t) override { return source_.same_until(t); }
  double source_ohms() const override { return source_.source_ohms(); }

 private:
  struct State {
    std::uint64_t samples = 0;
  };

  const AnalogInputs& all_;
  PinSource& source_;
  const Scale scale_;
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
  return {volts / nominal, std::max(volts - kLedVolts, 0.0) / (nominal - kLedVolts)};
}

AnalogInputs::AnalogInputs(RobotPort& board, const Supply& supply, double noise_volts,
                           const NoiseStream& noise, SnapshotRegistry& snapshots)
    : board_(board), supply_(supply), noise_volts_(noise_volts), noise_(noise), snapshots_(snapshots) {}

AnalogInputs::~AnalogInputs() = default;

void AnalogInputs::connect(Pin pin, PinSource& source, Scale scale) {
  inputs_.push_back(std::make_unique<Input>(*this, source, scale, pin));
  board_.connect(pin, *inputs_.back());
}

}  // namespace robosim::robot
