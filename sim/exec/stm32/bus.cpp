#include "sim/exec/stm32/bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr Address kBitBandEnd = 0x44000000;

}  // namespace

Bus::Bus(ClockedBoard& board, FlashMemory& memory, SimTime began)
    : link_{board, Clock(began)},
      clocks_(link_, power_),
      flash_(link_, memory),
      ports_(
          link_, [this](ChipPin pin) { return alternate(pin); }, [this](ChipPin pin) { return pulse(pin); },
          [this](ChipPin pin) { return watched(pin); }),
      systick_(link_),
      timers_{Timer(link_, clocks_, stm32f103c8::kTim1), Timer(link_, clocks_, stm32f103c8::kTim2),
              Timer(link_, clocks_, stm32f103c8::kTim3), Timer(link_, clocks_, stm32f103c8::kTim4)},
      adc_line_(link_, kIrqAdc),
      adcs_{Adc(link_, clocks_, adc_line_, 0), Adc(link_, clocks_, adc_line_, 1)},
      usarts_{Usart(link_, clocks_, 0), Usart(link_, clocks_, 1), Usart(link_, clocks_, 2)},
      dma_(link_, *this),
      iwdg_(link_),
      wwdg_(link_, clocks_),
      spis_{Spi(link_, clocks_, 1), Spi(link_, clocks_, 2)},
      i2cs_{I2c(link_, clocks_, 1), I2c(link_, clocks_, 2)},
      power_(link_),
      backup_(link_, power_),
      rtc_(link_, power_, [this] { ports_.alarmed(); }),
      crc_(link_),
      tracing_(link_) {
  SnapshotRegistry& snapshots = link_.snapshots;
  snapshots.add(link_.clock);
  snapshots.add(link_.nvic);
  snapshots.add(link_.reset_cause);
  snapshots.add(link_.reads);
  snapshots.add(link_.listened_to);
  snapshots.add(link_.map);
  snapshots.add_memory({ram_.data(), kRamBytes});
  snapshots.add(state_);
  link_.watch_changed = [this] { ports_.watch(); };
  link_.pin_level = [this](ChipPin pin) { return ports_.level(pin); };
  link_.pin_changed = [this](ChipPin pin) { ports_.refresh(pin); };
  for (std::size_t i = 0; i < usarts_.size(); ++i) place(usarts_[i], stm32f103c8::kUarts[i].address);
  for (std::size_t i = 0; i < timers_.size(); ++i) place(timers_[i], kStm32f103c8.timers[i].control);
  link_.signal = [this](Signals signals) { signal(signals); };
  place(dma_, kDma1);
  place(adcs_[0], kAdc1);
  place(adcs_[1], kAdc2);
  place(clocks_, kRcc);
  place(flash_, kFlashIf);
  for (const PortSpec& port : stm32f103c8::kPorts) place(ports_, port.address);
  place(iwdg_, kIwdg);
  place(wwdg_, kWwdg);
  place(spis_[0], kSpi1);
  place(spis_[1], kSpi2);
  place(i2cs_[0], kI2c1);
  place(i2cs_[1], kI2c2);
  place(power_, kPwr);
  place(backup_, kBkp);
  place(rtc_, kRtc);
  place(crc_, kCrc);
  place(ports_, kAfio);
  place(ports_, kExti);
  add(systick_);
}

void Bus::place(Peripheral& peripheral, Address block) {
  blocks_[(block - kPeripherals) / kBlockBytes] = {&peripheral, clocks_.gate(block)};
  if (std::find(peripherals_.begin(), peripherals_.end(), &peripheral) == peripherals_.end()) add(peripheral);
}

void Bus::add(Peripheral& peripheral) {
  link_.snapshots.add(peripheral.noted_signals);
  peripheral.bus_index = peripherals_.size();
  peripherals_.push_back(&peripheral);
  state_.events.push_back(kNoCycle);
}

Bus::Block* Bus::block_at(Address address) {
  if (address - kPeripherals >= kEnd - kPeripherals) return nullptr;
  Block& block = blocks_[(address - kPeripherals) / kBlockBytes];
  return block.peripheral ? &block : nullptr;
}

PinDrive Bus::alternate(ChipPin pin) const {
  PinDrive drive;
  drive.mode = PinMode::output;
  for (const Peripheral* peripheral : peripherals_)
    if (peripheral->drives(pin, drive)) break;
  return drive;
}

Pulse Bus::pulse(ChipPin pin) const {
  PinDrive drive;
  for (const Peripheral* peripheral : peripherals_)
    if (peripheral->drives(pin, drive)) return peripheral->pulse(pin);
  return {};
}

bool Bus::watched(ChipPin pin) const {
  return std::any_of(peripherals_.begin(), peripherals_.end(),
                     [&](const Peripheral* peripheral) { return peripheral->watches(pin); });
}

void Bus::edge(const BoardInput& edge) {
  ports_.deliver(edge);
  if (edge.pin >= link_.board.spec().pin_count) return;
  const auto& place = link_.board.spec().pins[edge.pin].chip_pin;
  for (Peripheral* peripheral : peripherals_)
    peripheral->edge({place.port, place.bit}, edge.value, link_.clock.cycle_at(edge.at));
}

bool Bus::dma_load(Address address, unsigned bytes, std::uint32_t& value) {
  address &= ~(bytes - 1);
  if (const std::uint8_t* const from = ram_.at(address, bytes)) {
    std::memcpy(&value, from, bytes);
    return true;
  }
  if (!Flash::owns_memory(address) && !block_at(address)) return false;
  value = load(address, bytes);
  return true;
}

bool Bus::dma_store(Address address, unsigned bytes, std::uint32_t value) {
  address &= ~(bytes - 1);
  if (std::uint8_t* const to = ram_.at(address, bytes)) {
    std::memcpy(to, &value, bytes);
    return true;
  }
  if (!block_at(address)) return false;
  store_part(address, value, bytes);
  return true;
}

void Bus::serve_dma() {
  constexpr int kMostItems = 0x10000;  // limit, in case a peripheral never withdraws its request
  if (dma_.waiting() == 0 || std::exchange(state_.serves_dma, true)) return;
  for (int item = 0; item < kMostItems; ++item) {
    unsigned requests = 0;
    for (const Peripheral* peripheral : peripherals_) requests |= peripheral->dma_requests();
    if (!(requests & dma_.waiting())) break;
    const int served = dma_.serve(requests & dma_.waiting());
    for (Peripheral* peripheral : peripherals_) peripheral->dma_served(served);
  }
  state_.serves_dma = false;
  note_all_events();
}

void Bus::note_signals(Peripheral& peripheral) {
  if (std::exchange(peripheral.noted_signals, peripheral.listens()) == peripheral.noted_signals) return;
  link_.listened_to = 0;
  for (const Peripheral* other : peripherals_) link_.listened_to |= other->noted_signals;
  note_all_events();
}

void Bus::signal(Signals signals) {
  if (!(signals & link_.listened_to)) return;
  for (Peripheral* peripheral : peripherals_)
    if (const Signals heard = signals & peripheral->noted_signals) peripheral->heard(heard);
  note_all_events();
}

void Bus::note_event(Peripheral& peripheral) {
  const Cycle event = peripheral.next_event(),
              before = std::exchange(state_.events[peripheral.bus_index], event);
  if (event < state_.next_event)
    state_.next_event = event;
  else if (before == state_.next_event && before != event)
    find_next_event();
}

void Bus::find_next_event() {
  Cycle next = link_.reset_cause == Reset::none ? kNoCycle : 0;
  for (const Cycle event : state_.events) next = std::min(next, event);
  state_.next_event = next;
}

void Bus::note_all_events() {
  for (const Peripheral* peripheral : peripherals_)
    state_.events[peripheral->bus_index] = peripheral->next_event();
  find_next_event();
}

void Bus::reset() {
  clocks_.note(std::exchange(link_.reset_cause, Reset::none));
  link_.nvic = Nvic();
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].peripheral)
      blocks_[i].peripheral->reset(kPeripherals + static_cast<Address>(i) * kBlockBytes);
  systick_.reset(kStkCtrl);
  tracing_.reset(0);
  rtc_.set_clock(clocks_.rtc_hz());
  for (Peripheral* peripheral : peripherals_) note_signals(*peripheral);
  note_all_events();
}

void Bus::clocks_changed() {
  reset_held();
  rtc_.set_clock(clocks_.rtc_hz());
  if (clocks_.resets_backup_domain()) {
    backup_.reset_domain();
    rtc_.reset_domain();
  }
  note_all_events();
}

// Resets the peripherals that RCC holds in reset (RM0008 7.3.3, 7.3.4).
void Bus::reset_held() {
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].peripheral && blocks_[i].gate.holds_in_reset())
      blocks_[i].peripheral->reset(kPeripherals + static_cast<Address>(i) * kBlockBytes);
}

void Bus::refuse(Address address, bool write, std::uint32_t value) {
  if (state_.unmodelled) return;
  const std::string name = name_at(address);
  state_.unmodelled = {address, value, write,
                       fmt::format("register 0x{:08X}{}", address, name.empty() ? "" : " (" + name + ")")};
}

bool Bus::load_private(Address address, std::uint32_t& value) {
  if (SysTick::owns(address)) {
    value = systick_.read(address);
    note_event(systick_);
    return true;
  }
  if (Tracing::owns(address)) {
    value = tracing_.read(address);
    return true;
  }
  systick_.update();
  note_event(systick_);
  return Nvic::owns(address) && link_.nvic.read(address, value);
}

bool Bus::store_private(Address address, std::uint32_t value) {
  if (Tracing::owns(address)) return tracing_.write(address, value);
  if (!SysTick::owns(address)) {
    if (!Nvic::owns(address) || !link_.nvic.write(address, value)) return false;
    if (link_.nvic.take_reset_request()) {
      link_.reset_cause = Reset::software;
      state_.next_event = 0;
    }
    return true;
  }
  systick_.write(address, value);
  note_event(systick_);
  return true;
}

std::uint32_t Bus::load_word(Address address) {
  std::uint32_t value = 0;
  if (Block* const block = block_at(address)) {
    // A peripheral without a clock reads 0 and ignores writes (RM0008 7.3.7, 7.3.8).
    if (!block->gate.has_clock()) return 0;
    value = block->peripheral->read(address);
    note_event(*block->peripheral);
    serve_dma();
  } else if (!load_private(address, value)) {
    refuse(address, false);
  }
  return value;
}

void Bus::store_word(Address address, std::uint32_t value) {
  Block* const block = block_at(address);
  bool modelled = true;
  if (!block) {
    modelled = store_private(address, value);
  } else if (block->gate.has_clock() && !block->gate.holds_in_reset()) {
    modelled = block->peripheral->write(address, value);
    if (block->peripheral == &clocks_) clocks_changed();
    note_event(*block->peripheral);
    note_signals(*block->peripheral);
    serve_dma();
    if (link_.reset_cause != Reset::none) state_.next_event = 0;
  }
  if (!modelled) refuse(address, true, value);
}

Cycle Bus::same_until(Address address) {
  const bool is_bit = address >= kBitBand && address < kBitBandEnd;
  const Address word = (is_bit ? kPeripherals + (address - kBitBand) / 32 : address) & ~3u;
  if (const Block* const block = block_at(word)) {
    if (!block->gate.has_clock()) return kNoCycle;
    const int bit = static_cast<int>((address - kBitBand) / 4 % 32);
    if (is_bit && Ports::owns_port(word) && word % kPortBytes == kIdr && bit < 16)
      return ports_.input_same_until({Ports::port_of(word), bit});
    return block->peripheral->same_until(word);
  }
  return SysTick::owns(word) ? systick_.same_until(word) : Nvic::owns(word) ? kNoCycle : 0;
}

bool Bus::load_bit(Address address, std::uint32_t& value) {
  if (address < kBitBand || address >= kBitBandEnd) return false;
  const Address byte = kPeripherals + (address - kBitBand) / 32;
  const Address word = byte & ~3u;
  const unsigned bit = (address - kBitBand) / 4 % 8 + 8 * (byte - word);
  const bool input = Ports::owns_port(word) && word % kPortBytes == kIdr;
  if (input && bit < 16)
    value =
        block_at(word)->gate.has_clock() && ports_.read_input({Ports::port_of(word), static_cast<int>(bit)});
  else
    value = load_word(word) >> bit & 1;
  return true;
}

bool Bus::store_bit(Address address, std::uint32_t value) {
  if (address < kBitBand || address >= kBitBandEnd) return false;
  const Address byte = kPeripherals + (address - kBitBand) / 32;
  const Address word = byte & ~3u;
  const unsigned bit = (address - kBitBand) / 4 % 8 + 8 * (byte - word);
  store_word(word, (load_word(word) & ~(1u << bit)) | (value & 1) << bit);
  return true;
}

std::uint32_t Bus::load(Address address, unsigned size) {
  state_.last_address = address;
  if (size == 4 && block_at(address)) return load_word(address & ~3u);
  if (Flash::owns_memory(address)) return flash_.read_memory(address, size);
  std::uint32_t value = 0;
  if (load_bit(address, value)) return value;
  value = load_word(address & ~3u) >> (8 * (address & 3));
  return size == 4 ? value : value & ((1u << (8 * size)) - 1);
}

void Bus::store(Address address, std::uint32_t value, unsigned size) {
  if (before_store_) before_store_(address);
  state_.storing = true;
  store_part(address, value, size);
  state_.storing = false;
}

void Bus::store_part(Address address, std::uint32_t value, unsigned size) {
  state_.last_address = address;
  if (flash_.programs(address, size)) return flash_.program(address, value);
  if (store_bit(address, value)) return;
  if (size == 4) return store_word(address & ~3u, value);
  const std::uint32_t low = value & ((1u << (8 * size)) - 1);
  if (address >= kPeripherals && address < kAhb) {
    // The APB repeats a byte or halfword across the word (RM0008 3.1).
    return store_word(address & ~3u, size == 1 ? low * 0x01010101u : low * 0x00010001u);
  }
  const unsigned shift = 8 * (address & 3);
  const std::uint32_t mask = ((1u << (8 * size)) - 1) << shift;
  store_word(address & ~3u, (load_word(address & ~3u) & ~mask) | low << shift);
}

void Bus::update() {
  const Cycle now = link_.clock.now;
  if (now < state_.next_event) return;
  bool concerns_others = false;
  for (std::size_t i = 0; i < peripherals_.size(); ++i) {
    if (state_.events[i] > now) continue;
    peripherals_[i]->update();
    if (peripherals_[i]->acts_alone())
      state_.events[i] = peripherals_[i]->next_event();
    else
      concerns_others = true;
  }
  serve_dma();
  if (concerns_others)
    note_all_events();
  else
    find_next_event();
}

void Bus::take_inputs() {
  if (link_.board.next_input() == kNever) return;
  BoardInput input;
  while (link_.board.take_input(link_.clock.time_of(link_.clock.now), input)) {
    if (input.kind == BoardInput::Kind::edge)
      edge(input);
    else
      for (Usart& usart : usarts_) usart.receive(input.value);
    serve_dma();
    note_all_events();
  }
}

}  // namespace robosim::exec::stm32
