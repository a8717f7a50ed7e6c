#include "sim/mcu/avr/chip.h"

#include <algorithm>
#include <utility>

#include "hal/board/avr_registers.h"
#include "sim/mcu/avr/adc.h"
#include "sim/mcu/avr/comparator.h"
#include "sim/mcu/avr/eeprom.h"
#include "sim/mcu/avr/external_interrupts.h"
#include "sim/mcu/avr/high_speed_timer.h"
#include "sim/mcu/avr/self_programming.h"
#include "sim/mcu/avr/spi.h"
#include "sim/mcu/avr/timer.h"
#include "sim/mcu/avr/timer_flags.h"
#include "sim/mcu/avr/twi.h"
#include "sim/mcu/avr/usart.h"
#include "sim/mcu/avr/usb_device.h"
#include "sim/mcu/avr/usb_host.h"
#include "sim/mcu/avr/watchdog.h"

namespace robosim::avr {
namespace {}  // namespace

Chip::Chip(const ChipSpec& spec, std::span<const std::uint8_t> flash, Address last_ram,
           ChipEnvironment& around, std::int64_t oscillator_hz)
    : core_(spec, flash, last_ram, around, oscillator_hz), pins_(core_), power_(core_), idle_(core_) {
  core_.cpu.on_time = Cpu::call<&Chip::do_due>(this);
  core_.cpu.on_mark<&Chip::may_pass_mark>(this);
  core_.reset = [](void* self, std::uint8_t flags) { static_cast<Chip*>(self)->reset_later(flags); };
  core_.reset_self = this;
  core_.keep(reset_flags_);
  call_ = core_.events.add<&Chip::called>(this);
  make_peripherals();
  power_on();
}

Chip::~Chip() = default;

void Chip::make_peripherals() {
  const auto add = [this](auto made) -> auto& {
    auto& peripheral = *made;
    peripherals_.push_back(std::move(made));
    return peripheral;
  };
  add(std::make_unique<ExternalInterrupts>(core_, pins_));
  Prescalers& prescalers = add(std::make_unique<Prescalers>(core_));
  power_.supply(prescalers, Power::Clock::io, 0, -1);
  SharedTimerFlags* shared = nullptr;
  Timer* captures = nullptr;  // captures the comparator's output
  for (int index = 0; index < core_.chip.timer_count; ++index) {
    const TimerSpec& spec = core_.chip.timers[index];
    const auto supply = [&](Peripheral& timer) {
      power_.supply(timer, Power::Clock::io, spec.reduction, spec.reduction_bit);
    };
    if (spec.bits == kHighSpeedBits) {
      supply(add(std::make_unique<HighSpeedTimer>(core_, pins_, index)));
      continue;
    }
    Timer& timer = add(std::make_unique<Timer>(core_, pins_, prescalers, index));
    supply(timer);
    if (index == core_.chip.comparator.captured_by) captures = &timer;
    if (!shares_flags(spec)) continue;
    if (!shared) shared = &add(std::make_unique<SharedTimerFlags>(core_, spec.flags, spec.enables));
    shared->add(timer);
  }
  for (int number = 0; number < core_.chip.uart_count; ++number) {
    const UartSpec& spec = core_.chip.uarts[number];
    usarts_.push_back(&add(std::make_unique<Usart>(core_, pins_, number)));
    power_.supply(*usarts_.back(), Power::Clock::io, spec.reduction, spec.reduction_bit);
  }
  const AdcSpec& adc = core_.chip.adc;
  power_.supply(add(std::make_unique<Adc>(core_, pins_)), Power::Clock::adc, adc.reduction,
                adc.reduction_bit);
  if (core_.chip.comparator.address)
    power_.supply(add(std::make_unique<Comparator>(core_, pins_, captures)), Power::Clock::io, 0, -1);
  if (const SpiSpec& spi = core_.chip.spi; spi.address)
    power_.supply(add(std::make_unique<Spi>(core_, pins_)), Power::Clock::io, spi.reduction,
                  spi.reduction_bit);
  if (const TwiSpec& twi = core_.chip.twi; twi.address)
    power_.supply(add(std::make_unique<Twi>(core_, pins_)), Power::Clock::io, twi.reduction,
                  twi.reduction_bit);
  if (const UsbSpec& usb = core_.chip.usb; usb.address) {
    UsbDevice& device = add(std::make_unique<UsbDevice>(core_));
    usb_host_ = &add(std::make_unique<UsbHost>(core_, device));
    power_.supply(*usb_host_, Power::Clock::io, usb.reduction, usb.reduction_bit);
  }
  add(std::make_unique<Eeprom>(core_));
  add(std::make_unique<Watchdog>(core_));
  add(std::make_unique<SelfProgramming>(core_));
}

void Chip::receive(int line, std::uint16_t data, Cycle at) {
  if (const auto number = static_cast<std::size_t>(line); number < usarts_.size()) {
    usarts_[number]->receive(data, at);
  } else if (usb_host_) {
    usb_host_->receive(static_cast<std::uint8_t>(data));
  }
}

void Chip::power_on() {
  power_.reset(0);
  pins_.reset(0);
  for (const auto& peripheral : peripherals_) peripheral->reset(0);
  core_.at(reg::kMcusr) = kPorf;
}

void Chip::reset(std::uint8_t flags) {
  idle_.interrupted();
  const Cycle now = cycle();
  const std::uint8_t earlier = core_.at(reg::kMcusr);
  const Cycle call = core_.events.due(call_);
  core_.events.cancel_all();
  core_.interrupts.state = 0;
  core_.cpu.reset();
  core_.at(reg::kMcusr) = earlier | flags;
  power_.reset(now);
  pins_.reset(now);
  for (const auto& peripheral : peripherals_) peripheral->reset(now);
  core_.events.schedule(call_, call);
  core_.cpu.look_up();
  core_.environment.was_reset(core_.at(reg::kMcusr), now);
}

void Chip::reset_later(std::uint8_t flags) {
  reset_flags_ |= flags;
  core_.cpu.look_up();
}

bool Chip::may_pass_mark() {
  if (!core_.visitor || !core_.visitor->visited(core_.cpu.pc(), core_.now())) return false;
  idle_.visited(core_.cpu.pc());
  return true;
}

void Chip::do_due() { core_.events.run(core_.now()); }

std::uint64_t Chip::may_interrupt() const {
  std::uint64_t vectors = 0;
  for (const auto& peripheral : peripherals_) vectors |= peripheral->may_interrupt();
  return vectors;
}

Chip::Stop Chip::run_to(Cycle until) {
  Cpu& cpu = core_.cpu;
  idle_.interrupted();
  for (;;) {
    core_.events.run(cpu.cycle());
    if (reset_flags_) reset(std::exchange(reset_flags_, std::uint8_t{0}));
    const bool requested = core_.interrupts.any() && cpu.interrupts_enabled();
    if (power_.is_asleep()) {
      if (!requested) {
        if (!cpu.interrupts_enabled() && !core_.reset_may_come) return Stop::off;
        if (cpu.cycle() >= until) return Stop::reached;
        const Cycle then = std::min(until, core_.events.next_urgent());
        idle_.slept(then - cpu.cycle());
        cpu.skip_to(then);
        if (singly_) return Stop::stopped;
        continue;
      }
      power_.wake(cpu.cycle());
      continue;
    }
    if (requested && cpu.interruptible()) {
      const int vector = core_.interrupts.first();
      core_.interrupts.entered(vector);
      idle_.interrupted();
      cpu.enter(vector);
      if (!singly_) cpu.count_time(std::min(until, core_.events.next()));
      continue;
    }
    if (cpu.cycle() >= until) return Stop::reached;
    const Cycle horizon = std::min(until, core_.events.next());
    const bool one = singly_ || requested, watched = !one && idle_.watches();
    if (watched) idle_.before();
    const Stop why = cpu.run(one || watched ? cpu.cycle() + 1 : horizon);
    if (watched) idle_.after();
    if (why == Stop::mark) {
      const bool is_head = cpu.is_head(cpu.pc());
      if (is_head && !one) idle_.at_head(std::min(until, core_.events.next_urgent()));
      if (!cpu.has_mark(cpu.pc()) || (is_head && may_pass_mark())) continue;
    }
    if (why == Stop::sleep) {
      power_.sleep(cpu.cycle());
    } else if (why != Stop::reached) {
      return why;
    }
    if (singly_) return Stop::stopped;
  }
}

void Chip::restore(const SnapshotRegistry::Snapshot& saved) {
  core_.snapshots.restore(saved);
  idle_.moved_in_time();
}

}  // namespace robosim::avr
