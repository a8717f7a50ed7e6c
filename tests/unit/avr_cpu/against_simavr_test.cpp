// Runs random instructions on Robosim's AVR processor and on libsimavr's, each from the same random state.
// Then compares program counter, cycles, status, stack pointer, registers and memory.
//
// Skips instructions that libsimavr 1.6 lacks or does not execute as the chip does: SPM, SLEEP and BREAK.
// Also skips I/O instructions and WDR, whose effects are outside of the processor, and jumps out of flash.
// Skips `LPM r30, Z+` and `LPM r31, Z+`, because the manual leaves their results undefined. Skips ELPM, EIJMP
// and EICALL, which an ATmega328P does not have.
extern "C" {
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>
}

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <random>

#include "hal/board/atmega328p.h"
#include "sim/mcu/avr/cpu.h"
#include "tests/support/effort.h"

namespace robosim::avr {
namespace against_simavr_test {

constexpr std::uint32_t kAt = 0x1000;  // flash address of the instruction
constexpr Address kLastRam = 0x8FF, kFirstRam = 0x100;
constexpr std::size_t kFlash = 0x2000;  // bytes of random flash; the rest is erased
constexpr int kInstructions = test::rounds(20000);

bool is_compared(const Instruction& i) {
  switch (i.op) {
    case Op::illegal:
    case Op::sleep:
    case Op::break_:
    case Op::spm:
    case Op::wdr:
    case Op::in:
    case Op::out:
    case Op::sbi:
    case Op::cbi:
    case Op::sbic:
    case Op::sbis:
    case Op::elpm:
    case Op::elpm_0:
    case Op::elpm_inc:
    case Op::eijmp:
    case Op::eicall:
      return false;
    case Op::lpm_inc:
      return i.a != 30 && i.a != 31;
    default:
      return true;
  }
}

class Simavr {
 public:
  Simavr() : avr_(avr_make_mcu_by_name("atmega328p")) {
    avr_init(avr_);
    avr_->frequency = 16000000;
    avr_->log = LOG_NONE;
  }
  ~Simavr() {
    avr_terminate(avr_);
    std::free(avr_);
  }
  avr_t* operator->() const { return avr_; }
  avr_t* get() const { return avr_; }

 private:
  avr_t* avr_;
};

class Pair {
 public:
  explicit Pair(std::mt19937& random) : flash_(kFlash), noise_(2 * ram_end(kAtmega328p)) {
    for (auto& byte : flash_) byte = static_cast<std::uint8_t>(random());
    for (auto& byte : noise_) byte = static_cast<std::uint8_t>(random());
    std::memset(theirs_->flash, 0xFF, kAtmega328p.flash_bytes);
    std::memcpy(theirs_->flash, flash_.data(), flash_.size());
  }

  /// Runs one random instruction. Returns false if it was skipped.
  bool run(std::mt19937& random) {
    const auto word = static_cast<std::uint16_t>(random());
    auto next = static_cast<std::uint16_t>(random() & 0x3FFF);
    const Instruction instruction = decode(word, next);
    if (!is_compared(instruction)) return false;
    if (instruction.op == Op::lds || instruction.op == Op::sts) next = kFirstRam + next % 0x700;
    put(kAt, word);
    put(kAt + 2, next);
    Cpu ours(kAtmega328p, flash_, kLastRam);
    const std::uint8_t* const noise = noise_.data() + random() % ram_end(kAtmega328p);
    std::memcpy(ours.data.data(), noise, 32);
    std::memcpy(ours.data.data() + kFirstRam, noise + kFirstRam, kLastRam + 1u - kFirstRam);
    std::memcpy(theirs_->data, noise, 32);
    std::memcpy(theirs_->data + kFirstRam, noise + kFirstRam, kLastRam + 1u - kFirstRam);
    for (const Address pointer : {26, 28, 30}) {
      const std::uint32_t to = 0x140 + random() % 0x600;
      ours.data[pointer] = theirs_->data[pointer] = static_cast<std::uint8_t>(to);
      ours.data[pointer + 1u] = theirs_->data[pointer + 1] = static_cast<std::uint8_t>(to >> 8);
    }
    const auto sp = static_cast<std::uint16_t>(0x200 + random() % 0x600);
    theirs_->data[R_SPL] = static_cast<std::uint8_t>(sp);
    theirs_->data[R_SPH] = static_cast<std::uint8_t>(sp >> 8);
    ours.set_sp(sp);
    const auto status = static_cast<std::uint8_t>(random() & 0x7F);
    for (int bit = 0; bit < 8; ++bit) theirs_->sreg[bit] = status >> bit & 1;
    ours.set_sreg(status);
    ours.set_pc(kAt / 2);
    ours.skip_to(1000);
    theirs_->pc = kAt;
    theirs_->cycle = 1000;
    theirs_->run_cycle_limit = theirs_->run_cycle_count = 1;
    theirs_->state = cpu_Running;

    const avr_flashaddr_t their_pc = avr_run_one(theirs_.get());
    if (ours.run(1001) == Cpu::Stop::outside || ours.pc() >= kFlash / 2) return false;
    std::uint8_t their_status = 0;
    for (int bit = 0; bit < 8; ++bit)
      their_status |= static_cast<std::uint8_t>((theirs_->sreg[bit] ? 1 : 0) << bit);
    SCOPED_TRACE(testing::Message() << std::hex << "opcode " << word << " " << next << ", SREG before "
                                    << int{status});
    EXPECT_EQ(2 * ours.pc(), their_pc);
    EXPECT_EQ(ours.cycle(), theirs_->cycle);
    EXPECT_EQ(int{ours.sreg()}, int{their_status});
    EXPECT_EQ(ours.sp(), theirs_->data[R_SPL] | theirs_->data[R_SPH] << 8);
    EXPECT_EQ(0, std::memcmp(ours.data.data(), theirs_->data, 32)) << "registers";
    EXPECT_EQ(0,
              std::memcmp(ours.data.data() + kFirstRam, theirs_->data + kFirstRam, kLastRam + 1u - kFirstRam))
        << "memory";
    return true;
  }

 private:
  void put(std::uint32_t at, std::uint16_t word) {
    flash_[at] = theirs_->flash[at] = static_cast<std::uint8_t>(word);
    flash_[at + 1] = theirs_->flash[at + 1] = static_cast<std::uint8_t>(word >> 8);
  }

  Simavr theirs_;
  std::vector<std::uint8_t> flash_, noise_;
};

TEST(Cpu, DoesWithRandomInstructionsWhatSimavrDoes) {
  std::mt19937 random(1);
  Pair pair(random);
  int compared = 0;
  for (int i = 0; i < kInstructions && !HasFailure(); ++i) compared += pair.run(random);
  EXPECT_GT(compared, kInstructions / 2);
}

}  // namespace against_simavr_test
}  // namespace robosim::avr
