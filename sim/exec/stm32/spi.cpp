#include "sim/exec/stm32/spi.h"

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// RM0008 25.5
constexpr Address kSpiCr1 = 0x00, kSpiCr2 = 0x04, kSpiSr = 0x08, kSpiDr = 0x0C, kSpiCrcpr = 0x10;
constexpr std::uint32_t kCpol = 1u << 1, kMstr = 1u << 2, kSpe = 1u << 6, kSsi = 1u << 8, kSsm = 1u << 9,
                        kRxOnly = 1u << 10, kDff = 1u << 11, kCrcEn = 1u << 13, kBidiOe = 1u << 14,
                        kBidiMode = 1u << 15;  // SPI_CR1
constexpr std::uint32_t kRxDmaEn = 1u << 0, kTxDmaEn = 1u << 1, kSsoe = 1u << 2, kErrie = 1u << 5,
                        kSpiRxneie = 1u << 6, kSpiTxeie = 1u << 7;  // SPI_CR2
constexpr std::uint32_t kSpiRxne = 1u << 0, kSpiTxe = 1u << 1, kModf = 1u << 5, kOvr = 1u << 6,
                        kBsy = 1u << 7;  // SPI_SR

}  // namespace

Spi::Spi(Link& link, const Clocks& clocks, int number)
    : link_(link), clocks_(clocks), number_(number), base_(number == 1 ? kSpi1 : kSpi2) {}

bool Spi::masters() const { return control_ & kSpe && control_ & kMstr; }

bool Spi::drives(ChipPin pin, PinDrive& drive) const {
  const SpiPins pins = spi_pins(number_, link_.map);
  if (!masters() || (pin != pins.clock && pin != pins.out)) return false;
  drive.level = pin == pins.clock && control_ & kCpol;
  return true;
}

void Spi::refresh_pins() {
  const SpiPins pins = spi_pins(number_, link_.map);
  link_.pin_changed(pins.clock);
  link_.pin_changed(pins.out);
}

void Spi::refresh_line() {
  const bool high = (status_ & kSpiTxe && control2_ & kSpiTxeie) ||
                    (status_ & kSpiRxne && control2_ & kSpiRxneie) ||
                    (status_ & (kOvr | kModf) && control2_ & kErrie);
  link_.nvic.set_line(number_ == 1 ? kIrqSpi1 : kIrqSpi2, high);
}

// Table 78
unsigned Spi::dma_requests() const {
  unsigned requests = 0;
  if (control2_ & kRxDmaEn && status_ & kSpiRxne) requests |= dma_channel(number_ == 1 ? 2 : 4);
  if (masters() && control2_ & kTxDmaEn && status_ & kSpiTxe) requests |= dma_channel(number_ == 1 ? 3 : 5);
  return requests;
}

void Spi::shift(Cycle at) {
  const Cycle bus = clocks_.bus_divider(base_);
  const Cycle bits = control_ & kDff ? 16 : 8;
  shifting_ = true;
  done_at_ = at + (bits * bus << ((control_ >> 3 & 7) + 1));
  status_ |= kBsy;
}

void Spi::update() {
  while (shifting_ && link_.clock.now >= done_at_) {
    shifting_ = false;
    const bool receives = !(control_ & kBidiMode);
    const std::uint32_t all = control_ & kDff ? 0xFFFF : 0xFF;
    if (receives && status_ & kSpiRxne) status_ |= kOvr;
    if (receives && !(status_ & kSpiRxne)) {
      received_ = link_.pin_level(spi_pins(number_, link_.map).in) ? all : 0;
      status_ |= kSpiRxne;
    }
    if (status_ & kSpiTxe) {
      status_ &= ~kBsy;
    } else {
      status_ |= kSpiTxe;
      shift(done_at_);
    }
    refresh_line();
  }
}

void Spi::reset(Address) {
  static_cast<SpiRegisters&>(*this) = {};
  refresh_line();
  refresh_pins();
}

std::uint32_t Spi::read(Address address) {
  update();
  switch (address - base_) {
    case kSpiCr1:
      return control_;
    case kSpiCr2:
      return control2_;
    case kSpiSr: {
      const std::uint32_t value = status_;
      // A read of the data before this one, and OVR is gone.
      if (!(status_ & kSpiRxne)) status_ &= ~kOvr;
      return value;
    }
    case kSpiDr:
      status_ &= ~kSpiRxne;
      refresh_line();
      return received_;
    case kSpiCrcpr:
      return crc_;
    default:
      return 0;
  }
}

bool Spi::write(Address address, std::uint32_t value) {
  update();
  bool modelled = true;
  switch (address - base_) {
    case kSpiCr1: {
      control_ = value & 0xFFFF;
      status_ &= ~kModf;
      const bool selected =
          value & kSsm ? !(value & kSsi)
                       : !(control2_ & kSsoe) && !link_.pin_level(spi_pins(number_, link_.map).select);
      if (masters() && selected) {  // 25.3.10: another master
        status_ |= kModf;
        control_ &= ~(kSpe | kMstr);
      }
      const bool only_receives = control_ & kBidiMode ? !(control_ & kBidiOe) : bool(control_ & kRxOnly);
      modelled = !(value & kCrcEn) && !(masters() && only_receives);
      if (!(control_ & kSpe)) {
        shifting_ = false;
        status_ = (status_ & ~kBsy) | kSpiTxe;
      }
      refresh_pins();
      break;
    }
    case kSpiCr2:
      control2_ = value & 0xFF;
      break;
    case kSpiSr:
      break;
    case kSpiDr:
      if (masters() && !shifting_) {
        shift(link_.clock.now);
      } else {
        waiting_ = value;
        status_ &= ~kSpiTxe;
      }
      break;
    case kSpiCrcpr:
      crc_ = value & 0xFFFF;
      break;
    default:
      modelled = (value & 0x0C00) == 0;  // SPI_I2SCFGR: no I2S
  }
  refresh_line();
  return modelled;
}

}  // namespace robosim::exec::stm32
