extern "C" {
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_io.h>
}

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "sim/base/child.h"
#include "tests/conformance/bench.h"
#include "tests/conformance/referees.h"
#include "tests/support/temporary_folder.h"

namespace robosim::conformance {
namespace {

void on_report(avr_t*, avr_io_addr_t, std::uint8_t value, void* report) {
  static_cast<Report*>(report)->bytes.push_back(value);
}

void on_end(avr_t*, avr_io_addr_t, std::uint8_t, void* report) { static_cast<Report*>(report)->ended = true; }

}  // namespace

Report run_on_ours(const Program& program, std::span<const std::uint8_t> flash) {
  Bench bench(chip_named(program.chips.front()), flash);
  bench.wire_to_itself(program.loop);
  bench.run(program.cycles);
  return {bench.reported, bench.ended};
}

Report run_on_simavr(const Program& program, std::span<const std::uint8_t> flash) {
  Report report;
  avr_t* const avr = avr_make_mcu_by_name(program.chips.front().c_str());
  avr_init(avr);
  avr->log = LOG_NONE;
  avr->frequency = 16'000'000;
  avr->vcc = avr->avcc = avr->aref = 5000;
  avr->sleep = [](avr_t*, avr_cycle_count_t) {};
  std::memcpy(avr->flash, flash.data(), flash.size());
  avr->codeend = static_cast<avr_flashaddr_t>(flash.size());
  const AvrRegisters& at = chip_named(program.chips.front()).at;
  avr_register_io_write(avr, at.general[0], on_report, &report);
  avr_register_io_write(avr, at.general[1], on_end, &report);
  if (program.loop >= 0) {
    const auto usart = static_cast<unsigned>(AVR_IOCTL_UART_GETIRQ('0' + program.loop));
    avr_connect_irq(avr_io_getirq(avr, usart, UART_IRQ_OUTPUT), avr_io_getirq(avr, usart, UART_IRQ_INPUT));
  }
  int state = cpu_Running;
  while (!report.ended && state != cpu_Done && state != cpu_Crashed && avr->cycle < program.cycles)
    state = avr_run(avr);
  avr_terminate(avr);
  std::free(avr);
  return report;
}

std::optional<Report> run_on_avr8js(const Program& program, std::span<const std::uint8_t> flash) {
  const char* const folder = std::getenv("ROBOSIM_AVR8JS");
  if (!folder || program.chips.front() != "atmega328p") return std::nullopt;
  const test::TemporaryFolder scratch;
  const auto image = scratch.path() / "flash.bin";
  std::ofstream(image, std::ios::binary)
      .write(reinterpret_cast<const char*>(flash.data()), static_cast<std::streamsize>(flash.size()));
  std::istringstream words(output_of({"node", ROBOSIM_AVR8JS_SCRIPT, folder, image.string(),
                                      std::to_string(program.cycles), std::to_string(program.loop)}));
  Report report;
  std::string how;
  if (!(words >> how)) return std::nullopt;
  report.ended = how == "ended";
  for (std::string byte; words >> byte;)
    report.bytes.push_back(static_cast<std::uint8_t>(std::stoul(byte, nullptr, 16)));
  return report;
}

}  // namespace robosim::conformance
