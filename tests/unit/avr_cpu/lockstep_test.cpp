// Runs Robosim's example sketches in lockstep on the emulated chip and on libsimavr's processor. Compares
// program counter, cycles, status, stack pointer and registers after each instruction. Compares all RAM every
// 1024 instructions.
//
// The test does not use libsimavr's peripherals, but sets the values of I/O registers and the times of
// interrupts. tests/conformance compares the chip's peripherals with libsimavr.
//
// ROBOSIM_LOCKSTEP=50000000 compares 50,000,000 instructions of each sketch; the default is small.
extern "C" {
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>
}

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "hal/board/atmega328p.h"
#include "hal/board/board_spec.h"
#include "sim/build/sketch.h"
#include "sim/exec/avr/firmware.h"
#include "tests/conformance/bench.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim::avr {
namespace lockstep_test {

constexpr Address kLastRam = 0x8FF, kFirstIo = 0x20, kFirstRam = 0x100, kSreg = 0x5F, kSpl = 0x5D,
                  kEecr = 0x3F;
constexpr long kInstructions = 300'000;
constexpr long kMemoryEvery = 1024;

long instructions() {
  const char* wanted = std::getenv("ROBOSIM_LOCKSTEP");
  return wanted ? std::atol(wanted) : kInstructions;
}

/// libsimavr's processor; the test sets its I/O registers.
class Referee {
 public:
  explicit Referee(const std::vector<std::uint8_t>& flash) : avr_(avr_make_mcu_by_name("atmega328p")) {
    avr_init(avr_);
    avr_->log = LOG_NONE;
    std::memset(avr_->flash, 0xFF, kAtmega328p.flash_bytes);
    std::memcpy(avr_->flash, flash.data(), flash.size());
    for (auto& io : avr_->io) io = {nullptr, {this, &Referee::read}, {this, &Referee::write}};
    // libsimavr stores SREG bit by bit, so only its own code may access SREG.
    avr_->io[kSreg - kFirstIo] = {};
  }
  Referee(const Referee&) = delete;
  Referee& operator=(const Referee&) = delete;
  ~Referee() {
    avr_terminate(avr_);
    std::free(avr_);
  }

  /// Copies the state of `cpu`.
  void take(const Cpu& cpu) {
    std::memcpy(avr_->data, cpu.data.data(), kFirstIo);
    std::memcpy(avr_->data + kFirstRam, cpu.data.data() + kFirstRam, kLastRam + 1u - kFirstRam);
    avr_->data[kSpl] = static_cast<std::uint8_t>(cpu.sp());
    avr_->data[kSpl + 1] = static_cast<std::uint8_t>(cpu.sp() >> 8);
    for (int bit = 0; bit < 8; ++bit) avr_->sreg[bit] = cpu.sreg() >> bit & 1;
    avr_->pc = 2 * cpu.pc();
    avr_->cycle = cpu.cycle();
  }
  /// Runs one instruction. Its reads of I/O registers return `value`.
  void run(std::uint8_t value) {
    given_ = value;
    avr_->run_cycle_limit = avr_->run_cycle_count = 1;
    avr_->state = cpu_Running;
    avr_->pc = avr_run_one(avr_);
  }
  std::uint8_t status() const {
    unsigned status = 0;
    for (unsigned bit = 0; bit < 8; ++bit) status |= (avr_->sreg[bit] ? 1u : 0u) << bit;
    return static_cast<std::uint8_t>(status);
  }
  avr_t* operator->() const { return avr_; }

 private:
  static std::uint8_t read(avr_t*, avr_io_addr_t, void* self) { return static_cast<Referee*>(self)->given_; }
  static void write(avr_t* avr, avr_io_addr_t address, std::uint8_t value, void*) {
    avr->data[address] = value;
  }

  avr_t* avr_;
  std::uint8_t given_ = 0;
};

class Lockstep : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("avr");
    test::use_shared_cache();
  }
};

bool writes_eecr(const Instruction& i) {
  return (i.op == Op::out || i.op == Op::sbi || i.op == Op::cbi) && i.k == kEecr;
}

/// Returns the value that `instruction` read from an I/O register.
std::uint8_t given(const Instruction& instruction, const Cpu& cpu, bool skipped) {
  if (instruction.op == Op::sbic) return skipped ? 0x00 : 0xFF;
  if (instruction.op == Op::sbis) return skipped ? 0xFF : 0x00;
  return cpu.data[instruction.a & 31u];
}

TEST_P(Lockstep, IsTheSameAfterEachInstruction) {
  const BoardSpec& board = *find_board("uno");
  build::Request request{std::filesystem::path(ROBOSIM_EXAMPLES) / GetParam(), board};
  request.target = "avr";
  const auto firmware = exec::avr::Firmware::read(build::build(request).image, board);
  std::vector<std::uint8_t> flash = firmware.flash;
  flash.resize(kAtmega328p.flash_bytes, 0xFF);
  conformance::Bench bench(kAtmega328p, flash);
  Cpu& cpu = bench.chip.cpu();
  Referee referee(flash);
  referee.take(cpu);
  bench.chip.step_singly(true);
  std::uint32_t chance = 1;
  for (long count = 0; count < instructions();) {
    if (count % 5000 == 0) {
      // Changes voltages, levels and bytes, so that the sketch takes other branches.
      chance = chance * 1664525u + 1013904223u;
      bench.voltages[static_cast<int>(chance >> 16 & 7)] = 5.0 * (chance >> 24) / 256;
      bench.set_level(static_cast<int>(chance >> 8 & 0x0F), chance >> 30 & 1);
      if (chance >> 28 == 0) bench.chip.receive(0, '0' + (chance >> 20 & 7), cpu.cycle());
    }
    const int handlers = cpu.open_handlers();
    const std::uint32_t pc = cpu.pc();
    const Instruction& instruction = cpu.instruction(pc);
    const Cycle before = cpu.cycle();
    const Chip::Stop why = bench.chip.run_to(before + 1);
    if (cpu.open_handlers() > handlers) {
      referee.take(cpu);
      continue;
    }
    ASSERT_EQ(why, Chip::Stop::stopped);
    ++count;
    const Instruction& next = cpu.instruction(pc + instruction.words);
    const bool skipped = cpu.pc() == pc + instruction.words + next.words;
    referee.run(given(instruction, cpu, skipped));
    // A read of the EEPROM halts the chip for 4 cycles, a write for 2. libsimavr's processor does not halt.
    if (writes_eecr(instruction)) referee->cycle = cpu.cycle();
    ASSERT_EQ(2 * cpu.pc(), referee->pc) << "after word " << pc << ", instruction " << count;
    ASSERT_EQ(cpu.cycle(), referee->cycle) << "after word " << pc << ", instruction " << count;
    ASSERT_EQ(cpu.sreg(), referee.status()) << "after word " << pc << ", instruction " << count;
    ASSERT_EQ(cpu.sp(), referee->data[kSpl] | referee->data[kSpl + 1] << 8) << "after word " << pc;
    ASSERT_EQ(0, std::memcmp(cpu.data.data(), referee->data, kFirstIo)) << "after word " << pc;
    if (count % kMemoryEvery != 0) continue;
    ASSERT_EQ(0,
              std::memcmp(cpu.data.data() + kFirstRam, referee->data + kFirstRam, kLastRam + 1u - kFirstRam))
        << "after word " << pc;
  }
}

INSTANTIATE_TEST_SUITE_P(OfStockSketches, Lockstep,
                         testing::Values("PidFollower", "LeftPath", "RightPath", "AiNavigator",
                                         "PonyNavigator"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace lockstep_test
}  // namespace robosim::avr
