#include "sim/exec/stm32/spi.h"

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// Registers and bits (RM0008 25.5).
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
    : link_(link), clocks_(clocks), number_(number), base_(number == 1 ? kSpi1 : kSpi2) {
  link.snapshots.add(state_);
}

bool Spi::masters() const { return state_.control & kSpe && state_.control & kMstr; }

bool Spi::drives(ChipPin pin, PinDrive& drive) const {
  const SpiPins pins = spi_pins(number_, link_.map);
  if (!masters() || (pin != pins.clock && pin != pins.out)) return false;
  drive.level = pin == pins.clock && state_.control & kCpol;
  return true;
}

void Spi::refresh_pins() {
  const SpiPins pins = spi_pins(number_, link_.map);
  link_.pin_changed(pins.clock);
  link_.pin_changed(pins.out);
}

void Spi::refresh_line() {
  const bool high = (state_.status & kSpiTxe && state_.control2 & kSpiTxeie) ||
                    (state_.status & kSpiRxne && state_.control2 & kSpiRxneie) ||
                    (state_.status & (kOvr | kModf) && state_.control2 & kErrie);
  link_.nvic.set_line(number_ == 1 ? kIrqSpi1 : kIrqSpi2, high);
}

// Returns the DMA channels that the SPI requests, by table 78.
unsigned Spi::dma_requests() const {
  unsigned requests = 0;
  if (state_.control2 & kRxDmaEn && state_.status & kSpiRxne) requests |= dma_channel(number_ == 1 ? 2 : 4);
  if (masters() && state_.control2 & kTxDmaEn && state_.status & kSpiTxe)
    requests |= dma_channel(number_ == 1 ? 3 : 5);
  return requests;
}

void Spi::shift(Cycle at) {
  const Cycle bus = clocks_.bus_divider(base_);
  const Cycle bits = state_.control & kDff ? 16 : 8;
  state_.shifting = true;
  state_.done_at = at + (bits * bus << ((state_.control >> 3 & 7) + 1));
  state_.status |= kBsy;
}

void Spi::update() {
  while (state_.shifting && link_.clock.now >= state_.done_at) {
    state_.shifting = false;
    const bool receives = !(state_.control & kBidiMode);
    const std::uint32_t all = state_.control & kDff ? 0xFFFF : 0xFF;
    if (receives && state_.status & kSpiRxne) state_.status |= kOvr;
    if (receives && !(state_.status & kSpiRxne)) {
      state_.received = link_.pin_level(spi_pins(number_, link_.map).in) ? all : 0;
      state_.status |= kSpiRxne;
    }
    if (state_.status & kSpiTxe) {
      state_.status &= ~kBsy;
    } else {
      state_.status |= kSpiTxe;
      shift(state_.done_at);
    }
    refresh_line();
  }
}

void Spi::reset(Address) {
  state_ = {};
  refresh_line();
  refresh_pins();
}

std::uint32_t Spi::read(Address address) {
  update();
  switch (address - base_) {
    case kSpiCr1:
      return state_.control;
    case kSpiCr2:
      return state_.control2;
    case kSpiSr: {
      const std::uint32_t value = state_.status;
      // Clears OVR if firmware has read the data register before this status register.
      if (!(state_.status & kSpiRxne)) state_.status &= ~kOvr;
      return value;
    }
    case kSpiDr:
      state_.status &= ~kSpiRxne;
      refresh_line();
      return state_.received;
    case kSpiCrcpr:
      return state_.crc;
    default:
      return 0;
  }
}

bool Spi::write(Address address, std::uint32_t value) {
  update();
  bool modelled = true;
  switch (address - base_) {
    case kSpiCr1: {
      state_.control = value & 0xFFFF;
      state_.status &= ~kModf;
      const bool selected =
          value & kSsm ? !(value & kSsi)
                       : !(state_.control2 & kSsoe) && !link_.pin_level(spi_pins(number_, link_.map).select);
      if (masters() && selected) {  // another master selects this SPI (25.3.10)
        state_.status |= kModf;
        state_.control &= ~(kSpe | kMstr);
      }
      const bool only_receives =
          state_.control & kBidiMode ? !(state_.control & kBidiOe) : bool(state_.control & kRxOnly);
      modelled = !(value & kCrcEn) && !(masters() && only_receives);
      if (!(state_.control & kSpe)) {
        state_.shifting = false;
        state_.status = (state_.status & ~kBsy) | kSpiTxe;
      }
      refresh_pins();
      break;
    }
    case kSpiCr2:
      state_.control2 = value & 0xFF;
      break;
    case kSpiSr:
      break;
    case kSpiDr:
      if (masters() && !state_.shifting) {
        shift(link_.clock.now);
      } else {
        state_.waiting = value;
        state_.status &= ~kSpiTxe;
      }
      break;
    case kSpiCrcpr:
      state_.crc = value & 0xFFFF;
      break;
    default:
      modelled = (value & 0x0C00) == 0;  // SPI_I2SCFGR: I2S is not modelled
  }
  refresh_line();
  return modelled;
}

}  // namespace robosim::exec::stm32
