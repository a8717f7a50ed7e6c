#include "sim/exec/stm32/bus.h"

#include <fmt/format.h>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr Address kBitBandEnd = 0x44000000;
constexpr Address kAhb = 0x40018000;  ///< from here on AHB, below APB

struct Range {
  Address begin, end;
  const char* name;
};
// RM0008 3.3, table 3; PM0056 4.1.
constexpr Range kRanges[] = {
    {0x40000000, 0x40000400, "TIM2"},   {0x40000400, 0x40000800, "TIM3"},
    {0x40000800, 0x40000C00, "TIM4"},   {0x40002800, 0x40002C00, "RTC"},
    {0x40002C00, 0x40003000, "WWDG"},   {0x40003000, 0x40003400, "IWDG"},
    {0x40003800, 0x40003C00, "SPI2"},   {0x40004400, 0x40004800, "USART2"},
    {0x40004800, 0x40004C00, "USART3"}, {0x40005400, 0x40005800, "I2C1"},
    {0x40005800, 0x40005C00, "I2C2"},   {0x40005C00, 0x40006000, "USB"},
    {0x40006000, 0x40006400, "USB"},    {0x40006400, 0x40006800, "CAN1"},
    {0x40006C00, 0x40007000, "BKP"},    {0x40007000, 0x40007400, "PWR"},
    {0x40010000, 0x40010400, "AFIO"},   {0x40010400, 0x40010800, "EXTI"},
    {0x40010800, 0x40010C00, "GPIOA"},  {0x40010C00, 0x40011000, "GPIOB"},
    {0x40011000, 0x40011400, "GPIOC"},  {0x40011400, 0x40011800, "GPIOD"},
    {0x40011800, 0x40011C00, "GPIOE"},  {0x40012400, 0x40012800, "ADC1"},
    {0x40012800, 0x40012C00, "ADC2"},   {0x40012C00, 0x40013000, "TIM1"},
    {0x40013000, 0x40013400, "SPI1"},   {0x40013800, 0x40013C00, "USART1"},
    {0x40020000, 0x40020400, "DMA1"},   {0x40021000, 0x40021400, "RCC"},
    {0x40022000, 0x40022400, "FLASH"},  {0x40023000, 0x40023400, "CRC"},
    {0xE0000000, 0xE0001000, "ITM"},    {0xE0001000, 0xE0002000, "DWT"},
    {0xE0002000, 0xE0003000, "FPB"},    {0xE000E010, 0xE000E020, "SysTick"},
    {0xE000E100, 0xE000ED00, "NVIC"},   {0xE000ED00, 0xE000ED90, "SCB"},
    {0xE000EDF0, 0xE000EF00, "debug"},  {0xE0042000, 0xE0042400, "DBGMCU"},
};

Timer::Place place_of(int timer) {
  const TimerSpec& spec = kStm32f103c8.timers[timer];
  Timer::Place place{spec.control, static_cast<Irq>(spec.vector), {}};
  for (int i = 0; i < kStm32f103c8.pin_count; ++i)
    if (const auto& pin = kStm32f103c8.pins[i]; pin.timer == timer)
      place.pins[pin.output] = {pin.port, pin.bit};
  return place;
}

/// The pin by which a USART sends.
constexpr ChipPin sending_pin(const UartSpec& uart) {
  const std::string_view name = uart.tx;
  for (int i = 0; i < kStm32f103c8.pin_count; ++i)
    if (const auto& pin = kStm32f103c8.pins[i]; name == pin.name) return {pin.port, pin.bit};
  return {};
}

constexpr ChipPin kSends[] = {sending_pin(stm32f103c8::kUarts[0]), sending_pin(stm32f103c8::kUarts[1]),
                              sending_pin(stm32f103c8::kUarts[2])};
ChipPin sending_pin(const Usart& usart) { return kSends[usart.number() - 1]; }

}  // namespace

const char* Bus::name_at(Address address) {
  for (const Range& range : kRanges)
    if (address >= range.begin && address < range.end) return range.name;
  return "";
}

Bus::Bus(ClockedBoard& board, FlashMemory& memory, SimTime began)
    : link_{board, Clock(began)},
      clocks_(link_),
      flash_(link_, memory),
      ports_(link_, [this](ChipPin pin) { return alternate(pin); }),
      systick_(link_),
      timers_{Timer(link_, place_of(stm32f103c8::kTim1), [this](ChipPin pin) { ports_.refresh(pin); }),
              Timer(link_, place_of(stm32f103c8::kTim2), [this](ChipPin pin) { ports_.refresh(pin); }),
              Timer(link_, place_of(stm32f103c8::kTim3), [this](ChipPin pin) { ports_.refresh(pin); }),
              Timer(link_, place_of(stm32f103c8::kTim4), [this](ChipPin pin) { ports_.refresh(pin); })},
      adcs_{Adc(link_, clocks_, kAdc1), Adc(link_, clocks_, kAdc2)},
      usarts_{Usart(link_, clocks_, 0), Usart(link_, clocks_, 1), Usart(link_, clocks_, 2)} {}

PinDrive Bus::alternate(ChipPin pin) const {
  PinDrive drive;
  drive.mode = PinMode::output;
  for (const Usart& usart : usarts_) {
    if (!usart.sends()) continue;
    const ChipPin sends = sending_pin(usart);
    if (pin.port != sends.port || pin.bit != sends.bit) continue;
    drive.level = true;  // a line at rest; its bytes are told as bytes
    return drive;
  }
  for (const Timer& timer : timers_)
    if (timer.drives(pin, drive)) break;
  return drive;
}

Timer* Bus::timer_at(Address address) {
  for (Timer& timer : timers_)
    if (timer.owns(address)) return &timer;
  return nullptr;
}

Usart* Bus::usart_at(Address address) {
  for (Usart& usart : usarts_)
    if (usart.owns(address)) return &usart;
  return nullptr;
}

Adc* Bus::adc_at(Address address) {
  for (Adc& adc : adcs_)
    if (adc.owns(address)) return &adc;
  return nullptr;
}

// RM0008 table 63: one interrupt for both.
void Bus::refresh_adc_line() { link_.nvic.set_line(kIrqAdc, adcs_[0].interrupts() || adcs_[1].interrupts()); }

// RM0008 7.3.7, 7.3.8: without its clock a peripheral reads 0 and takes nothing.
bool Bus::has_clock(Address address) const {
  const bool is_exti = Ports::owns_exti(address) && address >= kExti;
  return is_exti || clocks_.has_clock(address);
}

// RM0008 7.3.3, 7.3.4.
void Bus::reset_held() {
  for (Timer& timer : timers_)
    if (clocks_.holds_in_reset(timer.base())) timer.reset();
  for (Adc& adc : adcs_)
    if (clocks_.holds_in_reset(adc.base())) adc.reset();
  refresh_adc_line();
  for (Usart& usart : usarts_) {
    if (!clocks_.holds_in_reset(usart.base())) continue;
    usart.reset();
    ports_.refresh(sending_pin(usart));
  }
  for (int port = 0; port < kStm32f103c8.port_count; ++port)
    if (clocks_.holds_in_reset(kGpioA + kPortBytes * static_cast<Address>(port))) ports_.reset_port(port);
  if (clocks_.holds_in_reset(kAfio)) ports_.reset_afio();
}

void Bus::refuse(Address address, bool write, std::uint32_t value) {
  if (unmodelled_) return;
  const std::string name = name_at(address);
  unmodelled_ = {address, value, write,
                 fmt::format("register 0x{:08X}{}", address, name.empty() ? "" : " (" + name + ")")};
}

std::uint32_t Bus::load_word(Address address) {
  if (SysTick::owns(address)) return systick_.read(address);
  if (Nvic::owns(address)) {
    systick_.update();
    std::uint32_t value = 0;
    if (!link_.nvic.read(address, value)) refuse(address, false);
    return value;
  }
  if (Clocks::owns(address)) return clocks_.read(address);
  if (Flash::owns(address)) return flash_.read(address);
  Timer* const timer = timer_at(address);
  Usart* const usart = timer ? nullptr : usart_at(address);
  Adc* const adc = adc_at(address);
  if (!timer && !usart && !adc && !Ports::owns(address)) {
    refuse(address, false);
    return 0;
  }
  if (!has_clock(address)) return 0;
  if (timer) return timer->read(address);
  if (adc) {
    const std::uint32_t value = adc->read(address);
    refresh_adc_line();
    return value;
  }
  if (usart) return usart->read(address);
  return ports_.read(address);
}

bool Bus::write(Address address, std::uint32_t value) {
  if (SysTick::owns(address)) return systick_.write(address, value), true;
  if (Nvic::owns(address)) return link_.nvic.write(address, value);
  if (Clocks::owns(address)) {
    const bool modelled = clocks_.write(address, value);
    if (address == kRccApb1Rstr || address == kRccApb2Rstr) reset_held();
    return modelled;
  }
  if (Flash::owns(address)) return flash_.write(address, value);
  Timer* const timer = timer_at(address);
  Usart* const usart = timer ? nullptr : usart_at(address);
  Adc* const adc = adc_at(address);
  if (!timer && !usart && !adc && !Ports::owns(address)) return false;
  if (!has_clock(address) || clocks_.holds_in_reset(address)) return true;
  if (timer) return timer->write(address, value);
  if (adc) {
    const bool modelled = adc->write(address, value);
    refresh_adc_line();
    return modelled;
  }
  if (usart) {
    const bool sent = usart->sends(), modelled = usart->write(address, value);
    if (usart->sends() != sent) ports_.refresh(sending_pin(*usart));
    return modelled;
  }
  return ports_.write(address, value);
}

void Bus::store_word(Address address, std::uint32_t value) {
  if (!write(address, value)) refuse(address, true, value);
}

bool Bus::load_bit(Address address, std::uint32_t& value) {
  if (address < kBitBand || address >= kBitBandEnd) return false;
  const Address byte = kPeripherals + (address - kBitBand) / 32;
  const Address word = byte & ~3u;
  const unsigned bit = (address - kBitBand) / 4 % 8 + 8 * (byte - word);
  const bool input = Ports::owns(word) && !Ports::owns_exti(word) && word % kPortBytes == kIdr;
  if (input && bit < 16)
    value = has_clock(word) && ports_.read_input({Ports::port_of(word), static_cast<int>(bit)});
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
  last_address_ = address;
  if (Flash::owns_memory(address)) return flash_.read_memory(address, size);
  std::uint32_t value = 0;
  if (load_bit(address, value)) return value;
  value = load_word(address & ~3u) >> (8 * (address & 3));
  return size == 4 ? value : value & ((1u << (8 * size)) - 1);
}

void Bus::store(Address address, std::uint32_t value, unsigned size) {
  last_address_ = address;
  if (flash_.programs(address, size)) return flash_.program(address, value);
  if (store_bit(address, value)) return;
  if (size == 4) return store_word(address & ~3u, value);
  const std::uint32_t low = value & ((1u << (8 * size)) - 1);
  if (address >= kPeripherals && address < kAhb) {
    // APB repeats a byte or half over the word (RM0008 3.1).
    return store_word(address & ~3u, size == 1 ? low * 0x01010101u : low * 0x00010001u);
  }
  const unsigned shift = 8 * (address & 3);
  const std::uint32_t mask = ((1u << (8 * size)) - 1) << shift;
  store_word(address & ~3u, (load_word(address & ~3u) & ~mask) | low << shift);
}

Cycle Bus::next_event() const {
  Cycle next = std::min({systick_.next_event(), adcs_[0].next_event(), adcs_[1].next_event()});
  for (const Usart& usart : usarts_) next = std::min(next, usart.next_event());
  for (const Timer& timer : timers_) next = std::min(next, timer.next_event());
  return next;
}

void Bus::update() {
  systick_.update();
  for (Timer& timer : timers_) timer.update();
  for (Adc& adc : adcs_) adc.update();
  refresh_adc_line();
  for (Usart& usart : usarts_) usart.update();
}

void Bus::take_inputs() {
  BoardInput input;
  while (link_.board.take_input(link_.clock.time_of(link_.clock.now), input)) {
    if (input.kind == BoardInput::Kind::edge)
      ports_.deliver(input);
    else
      for (Usart& usart : usarts_) usart.receive(input.value);
  }
}

}  // namespace robosim::exec::stm32
