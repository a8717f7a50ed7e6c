#include "sim/exec/stm32/ports.h"

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr int kExtiLines = 19;  // lines 16 to 18 belong to PVD, RTC alarm and USB
constexpr std::uint32_t kLines = (1u << kExtiLines) - 1;

Irq irq_of(int line) {
  if (line < 5) return static_cast<Irq>(kIrqExti0 + line);
  if (line < 16) return line < 10 ? kIrqExti9_5 : kIrqExti15_10;
  return line == 16 ? kIrqPvd : line == 17 ? kIrqRtcAlarm : kIrqUsbWakeup;
}

}  // namespace

Ports::Ports(Link& link, std::function<PinDrive(ChipPin)> alternate, std::function<Pulse(ChipPin)> pulse,
             std::function<bool(ChipPin)> watched)
    : link_(link), alternate_(std::move(alternate)), pulse_(std::move(pulse)), watched_(std::move(watched)) {
  link.snapshots.add(state_);
  for (auto& port : numbers_) port.fill(kNoPin);
  const BoardSpec& spec = link.board.spec();
  for (Pin pin = 0; pin < spec.pin_count; ++pin) {
    const auto& place = spec.pins[pin].chip_pin;
    if (place.port >= 0) numbers_[static_cast<std::size_t>(place.port)][place.bit] = pin;
  }
}

std::uint32_t Ports::configuration(ChipPin pin) const {
  const Port& port = state_.ports[static_cast<std::size_t>(pin.port)];
  return port.configuration[static_cast<std::size_t>(pin.bit / 8)] >> (4 * (pin.bit % 8)) & 15;
}

PinDrive Ports::drive_of(ChipPin pin) const {
  const std::uint32_t c = configuration(pin);
  const bool output = state_.ports[static_cast<std::size_t>(pin.port)].output >> pin.bit & 1;
  PinDrive drive;
  if (is_debuggers(pin, link_.map)) {
    drive.mode = pin.bit == 15 || pin.bit == 4 ? PinMode::input_pullup : PinMode::input;  // 9.3.5
    return drive;
  }
  if ((c & 3) == 0) {
    if (c == kPulled && output) drive.mode = PinMode::input_pullup;
    return drive;
  }
  const bool open_drain = c & 4;
  drive.mode = PinMode::output;
  drive.level = output;
  if (c & 8) drive = alternate_(pin);
  if (open_drain && drive.level && !drive.pwm) return PinDrive{};
  drive.duty = drive.pwm ? drive.duty : drive.level ? 1.0 : 0.0;
  return drive;
}

void Ports::refresh(ChipPin pin) {
  if (pin == kNoChipPin) return;
  if (number_of(pin) == kNoPin) return;
  const PinDrive drive = drive_of(pin);
  std::uint32_t& pwm = state_.ports[static_cast<std::size_t>(pin.port)].pwm;
  pwm = (pwm & ~(1u << pin.bit)) | (drive.pwm ? 1u << pin.bit : 0);
  link_.board.set_drive_heard(number_of(pin), drive, link_.clock.time());
}

void Ports::refresh_port(int port) {
  for (int bit = 0; bit < kBits; ++bit) refresh({port, bit});
}

void Ports::reset(Address block) {
  if (owns_port(block)) {
    state_.ports[static_cast<std::size_t>(port_of(block))] = {};
    refresh_port(port_of(block));
    return;
  }
  if (block == kAfio) {
    change_map(0);
    state_.sources = {};
  } else {
    state_.mask = state_.events = state_.rising = state_.falling = state_.pending = state_.software = 0;
  }
  watch();
  interrupts_changed();
}

bool Ports::level(ChipPin pin) const {
  if (pin == kNoChipPin || number_of(pin) == kNoPin) return false;
  return link_.board.read_level(number_of(pin), link_.clock.time(), ReadIntent::port);
}

Pin Ports::note_read(ChipPin pin) {
  const Pin number = number_of(pin);
  if (number == kNoPin || configuration(pin) == kAnalog) return kNoPin;
  state_.last_read = number;
  state_.last_read_at = link_.clock.now;
  return number;
}

bool Ports::read_input(ChipPin pin) {
  const Pin number = note_read(pin);
  if (number == kNoPin) return false;
  link_.note_read(number);
  return makes_pwm(pin) ? pulse_(pin).level : link_.board.read_level(number, link_.clock.time());
}

Cycle Ports::input_same_until(ChipPin pin) const {
  constexpr Cycle kRounding = 4;  // largest error, in cycles, of a converted board time
  const Pin number = number_of(pin);
  if (number == kNoPin || configuration(pin) == kAnalog) return kNoCycle;
  if (makes_pwm(pin)) return pulse_(pin).until;
  const SimTime until = link_.board.same_until(number, link_.clock.time());
  if (until == kNever) return kNoCycle;
  const Cycle cycle = link_.clock.cycle_at(until);
  return cycle > kRounding ? cycle - kRounding : 0;
}

Cycle Ports::same_until(Address address) const {
  if (!owns_port(address) || address % kPortBytes != kIdr) return kNoCycle;
  Cycle until = kNoCycle;
  for (int bit = 0; bit < kBits; ++bit) until = std::min(until, input_same_until({port_of(address), bit}));
  return until;
}

std::uint32_t Ports::read(Address address) {
  if (!owns_port(address)) {
    if (address >= kAfioExticr1 && address < kAfioExticr1 + 16)
      return state_.sources[(address - kAfioExticr1) / 4];
    switch (address) {
      case kAfioMapr:
        return link_.map;
      case kExtiImr:
        return state_.mask;
      case kExtiEmr:
        return state_.events;
      case kExtiSwier:
        return state_.software;
      case kExtiRtsr:
        return state_.rising;
      case kExtiFtsr:
        return state_.falling;
      case kExtiPr:
        return state_.pending;
      default:
        return 0;
    }
  }
  const int number = port_of(address);
  const Port& port = state_.ports[static_cast<std::size_t>(number)];
  switch (address - kGpioA - kPortBytes * static_cast<Address>(number)) {
    case kCrl:
      return port.configuration[0];
    case kCrh:
      return port.configuration[1];
    case kOdr:
      return port.output;
    case kIdr: {
      std::uint32_t levels = 0;
      Pin read = kNoPin;
      for (int bit = 0; bit < kBits; ++bit)
        if (const Pin pin = note_read({number, bit}); pin != kNoPin) {
          read = read == kNoPin ? pin : InputReads::kSeveral;
          if (makes_pwm({number, bit}) ? pulse_({number, bit}).level
                                       : link_.board.read_level(pin, link_.clock.time(), ReadIntent::port))
            levels |= 1u << bit;
        }
      if (read != kNoPin) link_.note_read(read);
      return levels;
    }
    default:
      return 0;
  }
}

bool Ports::write(Address address, std::uint32_t value) {
  if (!owns_port(address)) return write_exti(address, value);
  const int port = port_of(address);
  return write_port(port, address - kGpioA - kPortBytes * static_cast<Address>(port), value);
}

bool Ports::write_port(int number, Address offset, std::uint32_t value) {
  Port& port = state_.ports[static_cast<std::size_t>(number)];
  std::uint32_t changed = 0;
  const auto set_output = [&](std::uint32_t output) {
    changed = port.output ^ output;
    port.output = output;
  };
  switch (offset) {
    case kCrl:
    case kCrh:
      port.configuration[offset == kCrh] = value;
      refresh_port(number);
      return true;
    case kOdr:
      set_output(value & 0xFFFF);
      break;
    case kBsrr:
      set_output((port.output & ~(value >> 16)) | (value & 0xFFFF));
      break;
    case kBrr:
      set_output(port.output & ~(value & 0xFFFF));
      break;
    case kIdr:
      return true;
    default:
      return false;  // GPIOx_LCKR
  }
  for (int bit = 0; bit < kBits; ++bit)
    if (changed >> bit & 1) refresh({number, bit});
  return true;
}

int Ports::source(int line) const {
  return static_cast<int>(state_.sources[static_cast<std::size_t>(line / 4)] >> (4 * (line % 4)) & 15);
}

bool Ports::write_exti(Address address, std::uint32_t value) {
  if (address >= kAfioExticr1 && address < kAfioExticr1 + 16) {
    state_.sources[(address - kAfioExticr1) / 4] = value & 0xFFFF;
    watch();
    return true;
  }
  switch (address) {
    case kAfioMapr:
      change_map(value);
      return true;
    case kExtiImr:
      state_.mask = value & kLines;
      break;
    case kExtiEmr:
      state_.events = value & kLines;
      break;
    case kExtiRtsr:
      state_.rising = value & kLines;
      break;
    case kExtiFtsr:
      state_.falling = value & kLines;
      break;
    case kExtiSwier: {
      const std::uint32_t set = value & kLines & ~state_.software;
      state_.software |= set;
      came(set);
      return true;
    }
    case kExtiPr:
      state_.pending &= ~value;
      state_.software &= ~value;
      break;
    default:
      return value == 0;  // AFIO_EVCR
  }
  watch();
  interrupts_changed();
  return true;
}

void Ports::change_map(std::uint32_t map) {
  link_.map = map;
  for (int port = 0; port < kPorts; ++port) refresh_port(port);
  watch();
}

void Ports::watch() {
  for (int port = 0; port < kPorts; ++port)
    for (int line = 0; line < kBits; ++line) {
      const Pin number = number_of({port, line});
      if (number == kNoPin) continue;
      const bool by_line = (state_.mask | state_.events) >> line & 1 &&
                           (state_.rising | state_.falling) >> line & 1 && source(line) == port;
      const bool wanted = by_line || watched_({port, line});
      link_.board.set_wants_edges(number, wanted, link_.clock.time());
    }
}

void Ports::interrupts_changed() {
  for (const Irq irq : {kIrqExti0, kIrqExti1, kIrqExti2, kIrqExti3, kIrqExti4, kIrqExti9_5, kIrqExti15_10,
                        kIrqPvd, kIrqRtcAlarm, kIrqUsbWakeup}) {
    bool high = false;
    for (int line = 0; line < kExtiLines; ++line)
      if (irq_of(line) == irq && state_.pending & state_.mask & 1u << line) high = true;
    link_.nvic.set_line(irq, high);
  }
}

void Ports::deliver(const BoardInput& edge) {
  if (edge.pin >= link_.board.spec().pin_count) return;
  const auto& pin = link_.board.spec().pins[edge.pin].chip_pin;
  if (!((state_.mask | state_.events) >> pin.bit & 1) || source(pin.bit) != pin.port) return;
  if (!((edge.value ? state_.rising : state_.falling) >> pin.bit & 1)) return;
  came(1u << pin.bit);
}

void Ports::alarmed() {
  constexpr std::uint32_t kLine = 1u << 17;
  if (state_.rising & kLine) came(kLine);
}

// Sets the pending bits, the event and the signals of the lines (RM0008 10.2.5, figure 21).
void Ports::came(std::uint32_t lines) {
  state_.pending |= lines;
  if (lines & state_.events) link_.nvic.set_event();
  link_.signal((lines & 1u << 11 ? kExti11 : 0) | (lines & 1u << 15 ? kExti15 : 0));
  interrupts_changed();
}

}  // namespace robosim::exec::stm32
