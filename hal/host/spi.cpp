#include "hal/host/spi.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host {

Spi spi;

namespace {

constexpr Port port_named(const char* pin) { return static_cast<Port>(pin[1] - 'B'); }
constexpr uint8_t mask_named(const char* pin) { return static_cast<uint8_t>(1 << (pin[2] - '0')); }
constexpr Port kInPort = port_named(kChip.spi.in), kSelectPort = port_named(kChip.spi.select);
constexpr uint8_t kInMask = mask_named(kChip.spi.in), kSelectMask = mask_named(kChip.spi.select);

}  // namespace

void Spi::set_control(uint8_t value) {
  rare_used = true;
  control_ = value;
  if (!(value & kSpe)) master_.shifting = false;
  look_at_select();
}

// Makes the chip a slave if SS is an input at low level (19.3.2).
void Spi::look_at_select() {
  if (!master_.is_on(control_) || ports[kSelectPort].direction & kSelectMask) return;
  if (!(read_port(kSelectPort) & kSelectMask)) master_.lose_bus(control_, status_);
}

uint8_t Spi::take() {
  master_.touch_data(status_);
  return master_.received;
}

void Spi::send(uint8_t) {
  master_.touch_data(status_);
  look_at_select();
  if (master_.begin(control_, status_)) due_ = state.now + cycles(master_.takes(control_, status_));
}

void Spi::sync() {
  if (master_.shifting && state.now >= due_) master_.end(status_, read_port(kInPort) & kInMask);
}

}  // namespace host
}  // namespace robosim
