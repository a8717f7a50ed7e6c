#include "sim/exec/avr/ports.h"

#include "hal/board/avr_timer.h"

namespace robosim::exec::avr {
namespace {

constexpr int kPinsOfPort[3] = {6, 6, 8};  // B, C, D: as far as an Arduino's sketch has them
constexpr Pin kFirstPin[3] = {8, 14, 0};

constexpr int port_of(Pin pin) { return pin < 8 ? 2 : pin < 14 ? 0 : 1; }
constexpr int bit_of(Pin pin) { return pin - kFirstPin[port_of(pin)]; }
constexpr std::uint8_t mask_of(Pin pin) { return static_cast<std::uint8_t>(1 << bit_of(pin)); }
constexpr reg::Address pin_register(int port) { return static_cast<reg::Address>(reg::kPinB + 3 * port); }
constexpr reg::Address ddr_register(int port) { return static_cast<reg::Address>(reg::kDdrB + 3 * port); }
constexpr reg::Address port_register(int port) { return static_cast<reg::Address>(reg::kPortB + 3 * port); }

constexpr Pin kTimerPins[3][2] = {{6, 5}, {9, 10}, {11, 3}};
constexpr reg::Address kControlA[3] = {reg::kTccr0a, reg::kTccr1a, reg::kTccr2a};
constexpr reg::Address kCompare[3][2] = {
    {reg::kOcr0a, reg::kOcr0b}, {reg::kOcr1aL, reg::kOcr1bL}, {reg::kOcr2a, reg::kOcr2b}};
constexpr std::int64_t kClock_hz = 16'000'000;

constexpr std::uint8_t kAllPins = 0xFF;
constexpr int kExternalClock = 6;
constexpr std::uint8_t kInputCapture = 0x20;

}  // namespace

Ports::Ports(Link& link) : link_(link) {
  for (int port = 0; port < kPorts; ++port)
    modules_[static_cast<std::size_t>(port)] = link.chip.find_module<avr_ioport_t>("port", port);
  // libsimavr would take every pull-up for a level that is there; levels come from the board alone.
  for (avr_ioport_t* module : modules_) {
    module->external.pull_mask = kAllPins;
    module->external.pull_value = 0;
  }
}

void Ports::write(reg::Address address, std::uint8_t value) {
  const int port = (address - reg::kPinB) / 3;
  const reg::Address latch = port_register(port), direction = ddr_register(port);
  const std::uint8_t latched = link_.chip.data(latch), directed = link_.chip.data(direction);
  link_.chip.write_through(address, value);
  if (latched != link_.chip.data(latch) || directed != link_.chip.data(direction)) refresh_port(port);
}

std::uint8_t Ports::asked_bits() const {
  const avr_t& avr = *link_.chip.simavr();
  const auto word = [&](std::uint32_t pc) { return avr.flash[pc] | avr.flash[pc + 1] << 8; };
  const int op = word(avr.pc);
  if ((op & 0xFD00) == 0x9900) return static_cast<std::uint8_t>(1 << (op & 7));  // sbic, sbis
  const bool in = (op & 0xF800) == 0xB000;
  const bool ld = (op & 0xFE07) == 0x8000 || (op & 0xFE0F) == 0x900C;
  if (!in && !ld) return kAllPins;
  const int target = op >> 4 & 31;
  const int next = word(avr.pc + 2);
  if ((next & 0xFC00) == 0x2000 && (next >> 4 & 31) == target) {  // and
    const int other = (next & 0xF) | (next >> 5 & 0x10);
    return other == target ? kAllPins : avr.data[other];
  }
  // The core's digitalRead(): the mask is and-ed with the value, which the result, 0 or 1, then takes the
  // place of.
  const int after = word(avr.pc + 4);
  const bool replaced = (after & 0xF000) == 0xE000 && 16 + (after >> 4 & 15) == target;  // ldi
  if ((next & 0xFC00) == 0x2000 && ((next & 0xF) | (next >> 5 & 0x10)) == target && replaced)
    return avr.data[next >> 4 & 31];
  if ((next & 0xF000) == 0x7000 && 16 + (next >> 4 & 15) == target)  // andi
    return static_cast<std::uint8_t>((next >> 4 & 0xF0) | (next & 0xF));
  return kAllPins;
}

std::uint8_t Ports::read(reg::Address address) {
  const int port = (address - reg::kPinB) / 3;
  if (address != pin_register(port)) return link_.chip.read_through(address);
  const avr_t& avr = *link_.chip.simavr();
  // libsimavr does sbi as a read and a write of all bits; on the chip it toggles one pin.
  if ((avr.flash[avr.pc + 1] & 0xFD) == 0x98) return 0;
  const std::uint8_t direction = link_.chip.data(ddr_register(port));
  const std::uint8_t asked = asked_bits();
  std::uint8_t& seen = seen_[static_cast<std::size_t>(port)];
  const SimTime now = link_.now();
  for (int bit = 0; bit < kPinsOfPort[port]; ++bit) {
    const auto mask = static_cast<std::uint8_t>(1 << bit);
    if (!(asked & mask & ~direction)) continue;
    const auto pin = static_cast<Pin>(kFirstPin[port] + bit);
    last_read_ = pin;
    last_read_at_ = link_.chip.cycle();
    const bool level = link_.board.read_level(pin, now);
    seen = static_cast<std::uint8_t>(level ? seen | mask : seen & ~mask);
  }
  return static_cast<std::uint8_t>((seen & ~direction) | (link_.chip.data(port_register(port)) & direction));
}

int Ports::connection(int timer, int channel) const {
  return robosim::avr::connection(link_.chip.data(kControlA[timer]), channel);
}

PinDrive Ports::timer_drive(int timer, int channel) const {
  namespace avr = robosim::avr;
  const Chip& chip = link_.chip;
  const auto word = [&](reg::Address low) {
    return static_cast<std::uint16_t>(chip.data(low) | chip.data(static_cast<reg::Address>(low + 1)) << 8);
  };
  const auto compare = [&](int c) -> std::uint16_t {
    return timer == 1 ? word(kCompare[1][c]) : chip.data(kCompare[timer][c]);
  };
  const std::uint8_t control_a = chip.data(kControlA[timer]);
  const std::uint8_t control_b = chip.data(static_cast<reg::Address>(kControlA[timer] + 1));
  const avr::Counting how = avr::counting(timer, control_a, control_b);
  const std::int64_t top = avr::top_of(how, compare(0), timer == 1 ? word(reg::kIcr1L) : std::uint16_t{0});
  return avr::timer_drive(how, avr::prescaler(timer, control_b), top, compare(channel),
                          avr::connection(control_a, channel), kClock_hz);
}

PinDrive Ports::drive_of(Pin pin) const {
  const int port = port_of(pin);
  const std::uint8_t mask = mask_of(pin);
  const bool latch = link_.chip.data(port_register(port)) & mask;
  PinDrive drive;
  if (!(link_.chip.data(ddr_register(port)) & mask)) {
    drive.mode = latch ? PinMode::input_pullup : PinMode::input;
    return drive;
  }
  for (int timer = 0; timer < 3; ++timer)
    for (int channel = 0; channel < 2; ++channel)
      if (kTimerPins[timer][channel] == pin && connection(timer, channel) != 0)
        return timer_drive(timer, channel);
  drive.mode = PinMode::output;
  drive.level = latch;
  drive.duty = latch ? 1.0 : 0.0;
  return drive;
}

void Ports::refresh(Pin pin) { link_.board.set_drive(pin, drive_of(pin), link_.now()); }

void Ports::refresh_port(int port) {
  for (int bit = 0; bit < kPinsOfPort[port]; ++bit) refresh(static_cast<Pin>(kFirstPin[port] + bit));
}

void Ports::timer_changed(int number) {
  for (const Pin pin : kTimerPins[number]) refresh(pin);
}

bool Ports::notices_edges(Pin pin) const {
  const Chip& chip = link_.chip;
  const int port = port_of(pin);
  const auto changes = static_cast<reg::Address>(reg::kPcmsk0 + port);
  if (chip.data(reg::kPcicr) >> port & 1 && chip.data(changes) & mask_of(pin)) return true;
  switch (pin) {
    case 2:
      return chip.data(reg::kEimsk) & 1;
    case 3:
      return chip.data(reg::kEimsk) & 2;
    case 4:
      return (chip.data(reg::kTccr0b) & 7) >= kExternalClock;
    case 5:
      return (chip.data(reg::kTccr1b) & 7) >= kExternalClock;
    case 8:
      return chip.data(reg::kTimsk1) & kInputCapture;
    default:
      return false;
  }
}

void Ports::want_edges(Pin pin, bool wanted) {
  if (link_.board.wants_edges(pin) == wanted) return;
  const bool level = link_.board.set_wants_edges(pin, wanted, link_.now());
  if (!wanted) return;
  avr_ioport_t& module = *modules_[static_cast<std::size_t>(port_of(pin))];
  const std::uint8_t mask = mask_of(pin);
  module.external.pull_value = static_cast<std::uint8_t>(level ? module.external.pull_value | mask
                                                               : module.external.pull_value & ~mask);
  avr_irq_t& irq = module.io.irq[bit_of(pin)];
  irq.value = level;
  irq.flags &= static_cast<std::uint8_t>(~IRQ_FLAG_INIT);
  if (pin == 2 || pin == 3)
    avr_io_getirq(link_.chip.simavr(), AVR_IOCTL_EXTINT_GETIRQ(), pin - 2)->value = level;
}

void Ports::follow_levels() {
  avr_t* const avr = link_.chip.simavr();
  for (int number = 0; number < 2; ++number) {
    const bool enabled = link_.chip.data(reg::kEimsk) >> number & 1;
    const bool by_level = (link_.chip.data(reg::kEicra) >> (2 * number) & 3) == 0;
    const bool strict = enabled && by_level;
    if (avr_extint_is_strict_lvl_trig(avr, static_cast<std::uint8_t>(number)) == strict) continue;
    avr_extint_set_strict_lvl_trig(avr, static_cast<std::uint8_t>(number), strict);
    avr_irq_t* const irq = avr_io_getirq(avr, AVR_IOCTL_EXTINT_GETIRQ(), number);
    if (strict && irq->value == 0) avr_raise_irq(irq, 0);
  }
}

void Ports::interrupts_changed() {
  for (Pin pin = 0; pin < 20; ++pin) want_edges(pin, notices_edges(pin));
  follow_levels();
}

void Ports::deliver(const BoardInput& edge) {
  if (edge.pin >= 20) return;
  avr_ioport_t& module = *modules_[static_cast<std::size_t>(port_of(edge.pin))];
  const std::uint8_t mask = mask_of(edge.pin);
  if (link_.chip.data(ddr_register(port_of(edge.pin))) & mask) return;
  std::uint8_t& levels = module.external.pull_value;
  levels = static_cast<std::uint8_t>(edge.value ? levels | mask : levels & ~mask);
  avr_raise_irq(module.io.irq + bit_of(edge.pin), edge.value);
}

void Ports::was_reset() {
  for (Pin pin = 0; pin < 20; ++pin) {
    refresh(pin);
    link_.board.set_wants_edges(pin, false, link_.now());
  }
}

}  // namespace robosim::exec::avr
