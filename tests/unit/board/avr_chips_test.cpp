// Compares the data of AVR chips with avr-libc's headers, and the data of their boards' pins with Arduino's
// pins_arduino.h. avr-g++ evaluates these headers.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/file.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim {
namespace avr_chips_test {

using testing::HasSubstr;

constexpr char kArduino[] = "/usr/share/arduino/hardware/arduino/avr";

std::vector<const BoardSpec*> avr_boards() {
  std::vector<const BoardSpec*> boards;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (std::string_view(board->chip->target) == "avr") boards.push_back(board);
  return boards;
}

/// The output of avr-g++ for a source, and the error messages.
struct Compiled {
  std::string output, errors;
};
Compiled compiled(const std::string& source, const std::string& arguments) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "source.cpp", out = folder.path() / "out", err = folder.path() / "err";
  write_file(file, source);
  const std::string command = fmt::format("avr-g++ -std=gnu++11 -w {} '{}' >'{}' 2>'{}'", arguments,
                                          file.string(), out.string(), err.string());
  const bool ok = std::system(command.c_str()) == 0;
  return {read_file(out), ok ? "" : read_file(err)};
}

/// Collects static_asserts about numbers. The compiler checks them.
class Statements {
 public:
  void equal(const std::string& name, long long ours) {
    text_ += fmt::format("static_assert(({}) == {}, \"{}: ours is {:#x}\");\n", name, ours, name, ours);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Adds assertions about a timer that shares its registers with another timer. The names and bits of these
/// registers differ from those of an ATmega's timer.
void state_shared_timer(Statements& are, const TimerSpec& timer) {
  const std::string n = std::to_string(timer.number);
  are.equal("TCNT" + n, timer.count);
  are.equal("OCR" + n + "A", timer.compare[0]);
  are.equal("OCR" + n + "B", timer.compare[1]);
  if (timer.top) {
    are.equal("TCCR" + n, timer.control);
    are.equal("OCR" + n + "C", timer.top);
  } else {
    are.equal("TCCR" + n + "A", timer.control);
    are.equal("TCCR" + n + "B", timer.control_b);
  }
  are.equal("TIMSK", timer.enables);
  are.equal("TIFR", timer.flags);
  const char* const kBits[] = {"TOV{}", "OCF{}A", "OCF{}B"};
  const char* const kEnables[] = {"TOIE{}", "OCIE{}A", "OCIE{}B"};
  for (int bit = 0; bit < 3; ++bit) {
    are.equal(fmt::format(fmt::runtime(kBits[bit]), n), timer.flag_bits[bit]);
    are.equal(fmt::format(fmt::runtime(kEnables[bit]), n), timer.flag_bits[bit]);
  }
  are.equal("TIMER" + n + "_COMPA_vect_num", timer.vector);
  are.equal("TIMER" + n + "_COMPB_vect_num", timer.match_b_vector ? timer.match_b_vector : timer.vector + 1);
  are.equal("TIMER" + n + "_OVF_vect_num", timer.overflow_vector);
}

void state_registers(Statements& are, const ChipSpec& chip) {
  const AvrRegisters& at = chip.at;
  const bool small = chip.small_core;
  are.equal(small ? "MCUCR" : "EICRA", at.external_sense);
  are.equal("ISC00", 0);
  are.equal(small ? "GIMSK" : "EIMSK", at.external_enables);
  are.equal(small ? "GIFR" : "EIFR", at.external_flags);
  are.equal("INT0", at.external_bit);
  are.equal("INTF0", at.external_bit);
  are.equal(small ? "GIMSK" : "PCICR", at.change_enables);
  are.equal(small ? "GIFR" : "PCIFR", at.change_flags);
  are.equal(small ? "PCIE" : "PCIE0", at.change_bit);
  are.equal(small ? "PCIF" : "PCIF0", at.change_bit);
  are.equal(small ? "PCMSK" : "PCMSK0", at.change_masks);
  are.equal("1 << PUD", at.pull_ups_off);
  are.equal(small ? "MCUCR" : "SMCR", at.sleep);
  are.equal("1 << SE", at.sleep_enable);
  are.equal(small ? "1 << SM0 | 1 << SM1" : "1 << SM0 | 1 << SM1 | 1 << SM2", at.sleep_modes);
  are.equal("CLKPR", at.clock_divisor);
  are.equal(small ? "WDTCR" : "WDTCSR", at.watchdog);
  are.equal("GTCCR", at.timers);
  are.equal("EECR", at.eeprom);
  are.equal("EEDR", at.eeprom + 1);
  are.equal("EEARL", at.eeprom + 2);
  are.equal("ADCL", at.adc_data);
  are.equal("ADCSRA", at.adc_control);
  are.equal("ADCSRB", at.adc_control_b);
  are.equal("ADMUX", at.adc_multiplexer);
  are.equal("DIDR0", at.digital_off[0]);
  are.equal("GPIOR0", at.general[0]);
  are.equal("GPIOR1", at.general[1]);
  if (at.pll) are.equal("PLLCSR", at.pll);
}

void state_timer(Statements& are, const TimerSpec& timer) {
  const std::string n = std::to_string(timer.number);
  if (shares_flags(timer)) return state_shared_timer(are, timer);
  if (timer.bits == kHighSpeedBits) {
    are.equal("TC4H", timer.control - 1);
    are.equal("TCCR4A", timer.control);
    are.equal("TCCR4D", timer.control + 3);
    for (int output = 0; output < 4; ++output)
      are.equal(fmt::format("OCR4{}", static_cast<char>('A' + output)), timer.compare[0] + output);
    are.equal("TCNT4", timer.count);
    are.equal("TIMSK4", timer.enables);
    are.equal("TIFR4", timer.flags);
    are.equal("TIMER4_COMPA_vect_num", timer.vector);
    return;
  }
  are.equal("TCCR" + n + "A", timer.control);
  are.equal("TCCR" + n + "B", timer.control + 1);
  are.equal("TCNT" + n, timer.count);
  are.equal("OCR" + n + "A", timer.compare[0]);
  are.equal("OCR" + n + "B", timer.compare[1]);
  are.equal("TIMSK" + n, timer.enables);
  are.equal("TIFR" + n, timer.flags);
  are.equal("TIMER" + n + "_COMPA_vect_num", timer.vector);
  are.equal("TIMER" + n + "_COMPB_vect_num", timer.vector + 1);
  if (timer.compare[2]) {
    are.equal("OCR" + n + "C", timer.compare[2]);
    are.equal("TIMER" + n + "_COMPC_vect_num", timer.vector + 2);
  }
  are.equal("TIMER" + n + "_OVF_vect_num", timer.vector + channels(timer));
  if (timer.capture) {
    are.equal("ICR" + n, timer.capture);
    are.equal("TIMER" + n + "_CAPT_vect_num", timer.vector - 1);
  }
}

std::string statements_about(const ChipSpec& chip) {
  Statements are;
  for (int i = 0; i < 3; ++i) are.equal(fmt::format("SIGNATURE_{}", i), chip.signature[i]);
  are.equal("RAMSTART", chip.ram_address);
  are.equal("RAMEND", ram_end(chip) - 1);
  are.equal("FLASHEND", chip.flash_bytes - 1);
  are.equal("E2END", chip.eeprom_bytes - 1);
  are.equal("_VECTORS_SIZE", chip.vectors * (chip.flash_bytes > 0x2000 ? 4 : 2));
  are.equal("INT0_vect_num", chip.external_vector);
  are.equal("PCINT0_vect_num", chip.change_vector);
  are.equal("WDT_vect_num", chip.watchdog_vector);
  are.equal(chip.small_core ? "EE_RDY_vect_num" : "EE_READY_vect_num", chip.eeprom_vector);
  state_registers(are, chip);
  for (int i = 0; i < chip.port_count; ++i) {
    are.equal(fmt::format("PIN{}", chip.ports[i].letter), chip.ports[i].address);
    are.equal(fmt::format("PORT{}", chip.ports[i].letter), chip.ports[i].address + 2);
  }
  for (int i = 0; i < chip.timer_count; ++i) state_timer(are, chip.timers[i]);
  for (int i = 0; i < chip.uart_count; ++i) {
    const UartSpec& uart = chip.uarts[i];
    const int n = uart.number;
    are.equal(fmt::format("UCSR{}A", n), uart.address);
    are.equal(fmt::format("UBRR{}", n), uart.divider);
    are.equal(fmt::format("UDR{}", n), uart.data);
    are.equal(fmt::format("USART{}_RX_vect_num", chip.uart_count > 1 || n > 0 ? std::to_string(n) : ""),
              uart.vector);
  }
  are.equal("ADC_vect_num", chip.adc.vector);
  if (chip.spi.address) {
    are.equal("SPCR", chip.spi.address);
    are.equal("SPI_STC_vect_num", chip.spi.vector);
  }
  if (chip.twi.address) {
    are.equal("TWBR", chip.twi.address);
    are.equal("TWI_vect_num", chip.twi.vector);
  }
  if (chip.usb.address) {
    are.equal("USBCON", chip.usb.address);
    are.equal("UEINT", chip.usb.address + 0x1C);
    are.equal("PLLCSR", chip.usb.pll);
    are.equal("USB_GEN_vect_num", chip.usb.vector);
    are.equal("USB_COM_vect_num", chip.usb.vector + 1);
  }
  are.equal("ACSR", chip.comparator.address);
  are.equal(chip.small_core ? "ANA_COMP_vect_num" : "ANALOG_COMP_vect_num", chip.comparator.vector);
  return are.text();
}

/// The power reduction bit that stops a peripheral, as in <avr/power.h>.
struct Stop {
  std::string peripheral;
  std::uint16_t address;
  int bit;
};
std::vector<Stop> stops_of(const ChipSpec& chip) {
  std::vector<Stop> stops{{"adc", chip.adc.reduction, chip.adc.reduction_bit}};
  if (chip.spi.address) stops.push_back({"spi", chip.spi.reduction, chip.spi.reduction_bit});
  if (chip.twi.address) stops.push_back({"twi", chip.twi.reduction, chip.twi.reduction_bit});
  if (chip.usb.address) stops.push_back({"usb", chip.usb.reduction, chip.usb.reduction_bit});
  for (int i = 0; i < chip.timer_count; ++i)
    stops.push_back({fmt::format("timer{}", chip.timers[i].number), chip.timers[i].reduction,
                     chip.timers[i].reduction_bit});
  for (int i = 0; i < chip.uart_count; ++i)
    stops.push_back(
        {fmt::format("usart{}", chip.uarts[i].number), chip.uarts[i].reduction, chip.uarts[i].reduction_bit});
  return stops;
}

/// Returns the chips of all AVR boards, each chip once.
std::vector<const ChipSpec*> avr_chips() {
  std::vector<const ChipSpec*> chips;
  for (const BoardSpec* board : avr_boards())
    if (std::find(chips.begin(), chips.end(), board->chip) == chips.end()) chips.push_back(board->chip);
  return chips;
}

TEST(AvrChips, HaveTheirRegistersAndVectorsWhereAvrLibcHasThem) {
  ROBOSIM_NEEDS_TARGET("avr");
  for (const ChipSpec* chip : avr_chips()) {
    SCOPED_TRACE(chip->name);
    // With _SFR_ASM_COMPAT, the name of a register stands for its address, not for its content.
    const std::string arguments = fmt::format("-mmcu={} -D_SFR_ASM_COMPAT=1", chip->compiler_name);
    EXPECT_EQ(
        compiled("#include <avr/io.h>\n" + statements_about(*chip), arguments + " -fsyntax-only").errors, "");
    std::string source = "#include <avr/power.h>\n";
    for (const Stop& stop : stops_of(*chip))
      source += fmt::format("\"{0}\" power_{0}_disable()\n", stop.peripheral);
    const std::string power = compiled(source, arguments + " -E -P").output;
    for (const Stop& stop : stops_of(*chip)) {
      const std::string address = stop.address < 0x60 ? fmt::format("({:#x}) + 0x20", stop.address - 0x20)
                                                      : fmt::format("{:#x}", stop.address);
      EXPECT_THAT(power, HasSubstr(fmt::format("\"{}\" (({}) |= (uint8_t)(1 << {}))", stop.peripheral,
                                               address, stop.bit)));
    }
  }
}

/// Returns the numbers of an array `{ 5 , (1 << (3)) , ... }` in preprocessed source.
std::vector<int> array_of(const std::string& source, const std::string& name) {
  std::vector<int> numbers;
  const std::size_t begin = source.find('{', source.find(name + "[] = {"));
  if (begin == source.npos) return numbers;
  const std::string text = source.substr(begin, source.find('}', begin) - begin);
  static const std::regex kEntry(R"((?:\(1 << \(\s*(\d+)\s*\)\))|(\d+))");
  for (std::sregex_iterator entry(text.begin(), text.end(), kEntry), end; entry != end; ++entry)
    numbers.push_back(std::stoi((*entry)[1].matched ? (*entry)[1] : (*entry)[2]));
  return numbers;
}

/// Returns the name that Arduino.h gives to a pin's timer output, such as TIMER0A.
std::string arduinos_timer(const BoardSpec& board, const PinSpec& pin) {
  if (!pin.pwm) return "NOT_ON_TIMER";
  return fmt::format("TIMER{}{}", board.chip->timers[pin.chip_pin.timer].number,
                     static_cast<char>('A' + pin.chip_pin.output));
}

TEST(AvrBoards, HaveArduinosPins) {
  ROBOSIM_NEEDS_TARGET("avr");
  for (const BoardSpec* board : avr_boards()) {
    SCOPED_TRACE(board->name);
    const std::string arguments = fmt::format(
        "-mmcu={0} -DARDUINO=10819 -DF_CPU={1}L -D{2} -DARDUINO_ARCH_AVR -I{3}/cores/arduino "
        "-I{3}/variants/{4}",
        board->chip->compiler_name, board->clock_hz, board->macro, kArduino, board->variant);
    const Compiled source = compiled("#define ARDUINO_MAIN\n#include <Arduino.h>\n", arguments + " -E -P");
    ASSERT_EQ(source.errors, "");
    const std::vector<int> ports = array_of(source.output, "digital_pin_to_port_PGM"),
                           bits = array_of(source.output, "digital_pin_to_bit_mask_PGM");
    Statements are;
    std::string timers;
    int digital = 0, analog = 0;
    for (int number = 0; number < board->pin_count; ++number) {
      const PinSpec& pin = board->pins[number];
      if (number >= board->analog_pin_0 && pin.analog_channel >= 0)
        are.equal(fmt::format("PIN_A{}", analog++), number);
      if (!pin.digital) continue;
      ASSERT_LT(static_cast<std::size_t>(digital), ports.size());
      EXPECT_EQ(board->chip->ports[pin.chip_pin.port].letter, 'A' + ports[digital] - 1) << pin.name;
      EXPECT_EQ(pin.chip_pin.bit, bits[digital]) << pin.name;
      ++digital;
      // The Gemma's variant does not define digitalPinHasPWM().
      if (!board->chip->small_core) are.equal(fmt::format("digitalPinHasPWM({})", number), pin.pwm);
      are.equal(fmt::format("digitalPinToInterrupt({})", number), pin.interrupt);
      timers += fmt::format("static_assert(timers[{}] == {}, \"D{}: ours is {}\");\n", number,
                            arduinos_timer(*board, pin), number, arduinos_timer(*board, pin));
    }
    EXPECT_EQ(static_cast<std::size_t>(digital), ports.size());
    are.equal("LED_BUILTIN", board->led_builtin);
    const std::vector<int> on_timers = array_of(source.output, "digital_pin_to_timer_PGM");
    const Compiled check =
        compiled(fmt::format("#include <Arduino.h>\nconstexpr int timers[] = {{{}}};\n{}{}",
                             fmt::join(on_timers, ", "), timers, are.text()),
                 arguments + " -fsyntax-only");
    EXPECT_EQ(check.errors, "");
  }
}

}  // namespace avr_chips_test
}  // namespace robosim
