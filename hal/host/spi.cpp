#include "hal/host/spi.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"

namespace robosim {
namespace host {

Spi spi;

namespace {

constexpr uint8_t kSpie = 0x80, kSpe = 0x40, kMstr = 0x10, kRate = 0x03;  // SPCR
constexpr uint8_t kSpif = 0x80, kWcol = 0x40, kDouble = 0x01;             // SPSR
constexpr int kBitCycles[] = {4, 16, 64, 128};

constexpr Port port_named(const char* pin) { return static_cast<Port>(pin[1] - 'B'); }
constexpr uint8_t mask_named(const char* pin) { return static_cast<uint8_t>(1 << (pin[2] - '0')); }
constexpr Port kInPort = port_named(kChip.spi.in), kSelectPort = port_named(kChip.spi.select);
constexpr uint8_t kInMask = mask_named(kChip.spi.in), kSelectMask = mask_named(kChip.spi.select);

}  // namespace

void Spi::set_control(uint8_t value) {
  rare_used = true;
  control_ = value;
  if (!(value & kSpe)) shifts_ = false;
  look_at_select();
}

bool Spi::is_master() const { return (control_ & (kSpe | kMstr)) == (kSpe | kMstr); }

// Makes the chip a slave if SS is an input at low level (19.3.2).
void Spi::look_at_select() {
  if (!is_master() || ports[kSelectPort].direction & kSelectMask) return;
  if (read_port(kSelectPort) & kSelectMask) return;
  control_ &= static_cast<uint8_t>(~kMstr);
  status_ |= kSpif;
  shifts_ = false;
}

uint8_t Spi::status() {
  seen_ |= status_ & (kSpif | kWcol);
  return status_;
}

void Spi::touch() {
  status_ &= static_cast<uint8_t>(~seen_);
  seen_ = 0;
}

uint8_t Spi::take() {
  touch();
  return received_;
}

void Spi::send(uint8_t) {
  touch();
  look_at_select();
  if (shifts_) status_ |= kWcol;
  if (shifts_ || !is_master()) return;
  shifts_ = true;
  due_ = state.now + cycles(8 * kBitCycles[control_ & kRate] / (status_ & kDouble ? 2 : 1));
}

void Spi::sync() {
  if (!shifts_ || state.now < due_) return;
  shifts_ = false;
  received_ = read_port(kInPort) & kInMask ? 0xFF : 0;
  status_ |= kSpif;
}

bool Spi::pending() const { return control_ & kSpie && status_ & kSpif; }

bool Spi::may_interrupt() const { return control_ & kSpie && (shifts_ || status_ & kSpif); }

SimTime Spi::next() const { return shifts_ && control_ & kSpie ? due_ : kNever; }

void Spi::acknowledge() { status_ &= static_cast<uint8_t>(~kSpif); }

}  // namespace host
}  // namespace robosim
