// Runs random programs on Robosim's AVR processor and on the model in manual_model.h. Runs several
// instructions at a time, so that the processor also executes pairs in one step. Then compares
// program counter, cycles, status, stack pointer, registers and 64 KB of memory.
//
// ROBOSIM_FUZZ=100000000 runs 100,000,000 instructions; the default is small.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

#include "tests/support/effort.h"
#include "tests/unit/avr_cpu/random_program.h"

namespace robosim::avr {
namespace against_manual_test {

constexpr int kBlocks = 40, kLongestBlock = 24;
constexpr long kFewest = 20;

std::uint64_t instructions() {
  const char* wanted = std::getenv("ROBOSIM_FUZZ");
  return wanted ? std::strtoull(wanted, nullptr, 10) : test::rounds(300'000ull);
}

/// Returns whether an instruction skips or branches on a condition.
bool chooses(const std::string& name) {
  return name == "CPSE" || name == "SBIC" || name == "SBIS" || name == "SBRC" || name == "SBRS" ||
         name.starts_with("BR");
}

class Manual : public testing::TestWithParam<bool> {};

TEST_P(Manual, SaysWhatTheProcessorDoesWithRandomInstructions) {
  const bool long_pc = GetParam();
  std::mt19937 random(long_pc ? 22 : 16);
  Pair pair(random, long_pc);
  std::uint64_t count = 0;
  while (count < instructions()) {
    pair.begin(pair.random_start(random));
    bool goes_on = true;
    for (int block = 0; block < kBlocks && goes_on; ++block) {
      const std::uint32_t from = pair.manual.pc;
      goes_on = pair.run(1 + static_cast<int>(random() % kLongestBlock));
      ASSERT_EQ(pair.difference(), "") << "after the instructions from word " << from << " on";
    }
    count = 0;
    for (const std::uint64_t ran : pair.manual.ran) count += ran;
  }
  // Checks that each instruction has run, and that each condition has been true and false.
  for (std::size_t row = 0; row < ManualModel::rows().size(); ++row) {
    const std::string name = ManualModel::rows()[row].name;
    if (!long_pc && (name.starts_with("ELPM") || name.starts_with("EI"))) continue;
    EXPECT_GE(pair.manual.ran[row], test::rounds(kFewest)) << name;
    if (!chooses(name)) continue;
    EXPECT_GT(pair.manual.jumped[row], 0u) << name;
    EXPECT_GT(pair.manual.ran[row], pair.manual.jumped[row]) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(OfProgramCounters, Manual, testing::Bool(),
                         [](const auto& of) { return std::string(of.param ? "Of22Bits" : "Of16Bits"); });

}  // namespace against_manual_test
}  // namespace robosim::avr
