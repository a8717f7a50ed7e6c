#include "sim/robot/parts/bluetooth.h"

#include <utility>

namespace robosim::robot {
namespace {

constexpr std::size_t kLongestLine = 200;
constexpr std::size_t kMostLines = 100;            // lines waiting to be reported; each tick reports one
constexpr SimTime kLineEnds = 200 * kMillisecond;  // after this pause, a line ends even without line feed

constexpr FaultKind kBluetoothFaults[] = {
    {Failure::ok, "works again"},
    {Failure::dead, "nothing arrives on either side"},
};

}  // namespace

std::shared_ptr<const PartSpec> read_bluetooth(PartReader& reader) {
  auto spec = std::make_shared<BluetoothSpec>();
  spec->wiring = read_serial_wiring(reader);
  return reader.finish(spec);
}

std::unique_ptr<Part> BluetoothSpec::make(PartContext& context) const {
  return std::make_unique<BluetoothPart>(*this, context);
}

BluetoothPart::BluetoothPart(const BluetoothSpec& spec, PartContext& context)
    : spec_(spec), line_(spec.wiring, context, [this](std::uint8_t byte, bool sound, SimTime t) {
        take(sound ? byte : '?', t);
      }) {
  context.snapshots.add(state_);
}

void BluetoothPart::register_with(PartRegistry& registry) {
  registry.breakable.push_back(this);
  registry.receivers.push_back(this);
  registry.text_outputs.push_back(this);
  line_.register_with(*this, registry);
}

void BluetoothPart::send(const Message& message, SimTime t) {
  if (state_.dead) return;
  for (const char c : message.text) line_.send(static_cast<std::uint8_t>(c), t);
}

void BluetoothPart::take(std::uint8_t byte, SimTime t) {
  if (state_.dead || byte == '\r') return;
  state_.heard_at = t;
  if (byte != '\n') state_.heard += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '?';
  if (byte != '\n' && state_.heard.size() < kLongestLine) return;
  if (!state_.heard.empty() && state_.lines.size() < kMostLines) state_.lines.push_back(state_.heard);
  state_.heard.clear();
}

std::string BluetoothPart::poll_text(SimTime t) {
  if (!state_.heard.empty() && t - state_.heard_at >= kLineEnds) take('\n', t);
  if (state_.lines.empty()) return {};
  std::string line = std::move(state_.lines.front());
  state_.lines.erase(state_.lines.begin());
  return line;
}

void BluetoothPart::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, line_.idle() ? 0.0 : 1.0});
}

std::span<const FaultKind> BluetoothPart::fault_kinds() const { return kBluetoothFaults; }

void BluetoothPart::fail(const Fault& fault) { state_.dead = fault.failure == Failure::dead; }

}  // namespace robosim::robot
