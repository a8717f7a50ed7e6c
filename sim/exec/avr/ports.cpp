#include "sim/exec/avr/ports.h"

#include "hal/board/avr_timer.h"

namespace robosim::exec::avr {
namespace {

constexpr std::uint8_t mask_of(const ChipPin& pin) { return static_cast<std::uint8_t>(1 << pin.bit); }

constexpr std::uint8_t kAllPins = 0xFF;
constexpr int kExternalClock = 6;
constexpr std::uint8_t kInputCapture = 0x20;

}  // namespace

Ports::Ports(Link& link)
    : link_(link),
      chip_(link.chip.spec()),
      ports_(chip_.port_count),
      timer_pins_(chip_.timer_count),
      registers_(chip_.ram_address) {
  const auto at = [&](std::uint32_t address) -> Register& { return registers_.at(address); };
  for (int number = 0; number < chip_.port_count; ++number) {
    for (std::uint32_t i = 0; i < 3; ++i) at(chip_.ports[number].address + i).port = number;
    // libsimavr would take every pull-up for a level that is there; levels come from the board alone.
    Port& port = port_at(number);
    port.module = link.chip.find_module<avr_ioport_t>("port", number);
    port.module->external.pull_mask = kAllPins;
    port.module->external.pull_value = 0;
    port.pins.fill(kNoPin);
  }
  for (int number = 0; number < chip_.timer_count; ++number) {
    const TimerSpec& timer = chip_.timers[number];
    for (const std::uint32_t address : {timer.control, timer.control + 1, std::uint32_t{timer.compare[0]},
                                        std::uint32_t{timer.compare[1]}, std::uint32_t{timer.capture}})
      if (address) at(address).timer = number;
    timer_pins_[static_cast<std::size_t>(number)].fill(kNoPin);
  }
  for (const reg::Address address : {reg::kEimsk, reg::kEicra, reg::kPcicr})
    at(address).selects_interrupts = true;
  for (std::uint32_t i = 0; i < chip_.change_count; ++i) at(reg::kPcmsk0 + i).selects_interrupts = true;

  const BoardSpec& board = link.board.spec();
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    const ChipPin& place = board.pins[pin].chip_pin;
    if (place.port < 0) continue;
    digital_pins_.push_back(pin);
    port_at(place.port).pins[place.bit] = pin;
    if (place.timer >= 0) timer_pins_[static_cast<std::size_t>(place.timer)][place.output] = pin;
    if (place.counted_by >= 0) at(chip_.timers[place.counted_by].control + 1).selects_interrupts = true;
    if (place.captured_by >= 0) at(chip_.timers[place.captured_by].enables).selects_interrupts = true;
  }
}

const ChipPin& Ports::place_of(Pin pin) const { return link_.board.spec().pins[pin].chip_pin; }

void Ports::write(reg::Address address, std::uint8_t value) {
  const int port = registers_[address].port;
  const reg::Address latch = latch_register(port), direction = direction_register(port);
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
  const int number = registers_[address].port;
  if (address != pin_register(number)) return link_.chip.read_through(address);
  const avr_t& avr = *link_.chip.simavr();
  // libsimavr does sbi as a read and a write of all bits; on the chip it toggles one pin.
  if ((avr.flash[avr.pc + 1] & 0xFD) == 0x98) return 0;
  const std::uint8_t direction = link_.chip.data(direction_register(number));
  const std::uint8_t asked = asked_bits();
  Port& port = port_at(number);
  const SimTime now = link_.now();
  for (unsigned bit = 0; bit < port.pins.size(); ++bit) {
    const auto mask = static_cast<std::uint8_t>(1 << bit);
    const Pin pin = port.pins[bit];
    if (!(asked & mask & ~direction) || pin == kNoPin) continue;
    last_read_ = pin;
    last_read_at_ = link_.chip.cycle();
    const bool level = link_.board.read_level(pin, now);
    port.seen = static_cast<std::uint8_t>(level ? port.seen | mask : port.seen & ~mask);
  }
  const std::uint8_t latch = link_.chip.data(latch_register(number));
  return static_cast<std::uint8_t>((port.seen & ~direction) | (latch & direction));
}

int Ports::connection(int timer, int channel) const {
  return robosim::avr::connection(link_.chip.data(control_register(timer)), channel);
}

PinDrive Ports::timer_drive(int timer, int channel) const {
  namespace avr = robosim::avr;
  const Chip& chip = link_.chip;
  const TimerSpec& spec = chip_.timers[timer];
  const bool wide = spec.bits == 16;
  const auto word = [&](reg::Address low) {
    return static_cast<std::uint16_t>(chip.data(low) | chip.data(static_cast<reg::Address>(low + 1)) << 8);
  };
  const auto compare = [&](int c) -> std::uint16_t {
    return wide ? word(spec.compare[c]) : chip.data(spec.compare[c]);
  };
  const std::uint8_t control_a = chip.data(control_register(timer));
  const std::uint8_t control_b = chip.data(static_cast<reg::Address>(spec.control + 1));
  const avr::Counting how = avr::counting(spec, control_a, control_b);
  const std::int64_t top = avr::top_of(how, compare(0), wide ? word(spec.capture) : std::uint16_t{0});
  return avr::timer_drive(how, avr::prescaler(spec, control_b), top, compare(channel),
                          avr::connection(control_a, channel), chip.clock_hz());
}

PinDrive Ports::drive_of(Pin pin) const {
  const ChipPin& place = place_of(pin);
  const std::uint8_t mask = mask_of(place);
  const bool latch = link_.chip.data(latch_register(place.port)) & mask;
  PinDrive drive;
  if (!(link_.chip.data(direction_register(place.port)) & mask)) {
    drive.mode = latch ? PinMode::input_pullup : PinMode::input;
    return drive;
  }
  if (place.timer >= 0 && connection(place.timer, place.output) != 0)
    return timer_drive(place.timer, place.output);
  drive.mode = PinMode::output;
  drive.level = latch;
  drive.duty = latch ? 1.0 : 0.0;
  return drive;
}

void Ports::refresh(Pin pin) { link_.board.set_drive(pin, drive_of(pin), link_.now()); }

void Ports::refresh_port(int port) {
  for (const Pin pin : port_at(port).pins)
    if (pin != kNoPin) refresh(pin);
}

void Ports::timer_changed(int number) {
  for (const Pin pin : timer_pins_[static_cast<std::size_t>(number)])
    if (pin != kNoPin) refresh(pin);
}

bool Ports::notices_edges(Pin pin) const {
  const auto data = [&](std::uint32_t address) {
    return link_.chip.data(static_cast<reg::Address>(address));
  };
  const ChipPin& place = place_of(pin);
  const int group = place.change / 8;
  if (place.change >= 0 && data(reg::kPcicr) >> group & 1 &&
      data(reg::kPcmsk0 + static_cast<std::uint32_t>(group)) >> place.change % 8 & 1)
    return true;
  if (place.external >= 0 && data(reg::kEimsk) >> place.external & 1) return true;
  if (place.counted_by >= 0 && (data(chip_.timers[place.counted_by].control + 1) & 7) >= kExternalClock)
    return true;
  return place.captured_by >= 0 && data(chip_.timers[place.captured_by].enables) & kInputCapture;
}

void Ports::want_edges(Pin pin, bool wanted) {
  if (link_.board.wants_edges(pin) == wanted) return;
  const bool level = link_.board.set_wants_edges(pin, wanted, link_.now());
  if (!wanted) return;
  const ChipPin& place = place_of(pin);
  avr_ioport_t& module = *port_at(place.port).module;
  const std::uint8_t mask = mask_of(place);
  module.external.pull_value = static_cast<std::uint8_t>(level ? module.external.pull_value | mask
                                                               : module.external.pull_value & ~mask);
  avr_irq_t& irq = module.io.irq[place.bit];
  irq.value = level;
  irq.flags &= static_cast<std::uint8_t>(~IRQ_FLAG_INIT);
  if (place.external >= 0)
    avr_io_getirq(link_.chip.simavr(), AVR_IOCTL_EXTINT_GETIRQ(), place.external)->value = level;
}

void Ports::follow_levels() {
  avr_t* const avr = link_.chip.simavr();
  for (int number = 0; number < chip_.external_count; ++number) {
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
  for (const Pin pin : digital_pins_) want_edges(pin, notices_edges(pin));
  follow_levels();
}

void Ports::deliver(const BoardInput& edge) {
  const ChipPin& place = place_of(edge.pin);
  if (place.port < 0) return;
  avr_ioport_t& module = *port_at(place.port).module;
  const std::uint8_t mask = mask_of(place);
  if (link_.chip.data(direction_register(place.port)) & mask) return;
  std::uint8_t& levels = module.external.pull_value;
  levels = static_cast<std::uint8_t>(edge.value ? levels | mask : levels & ~mask);
  avr_raise_irq(module.io.irq + place.bit, edge.value);
}

void Ports::was_reset() {
  for (const Pin pin : digital_pins_) {
    refresh(pin);
    link_.board.set_wants_edges(pin, false, link_.now());
  }
}

}  // namespace robosim::exec::avr
