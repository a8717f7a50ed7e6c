// Runs random instructions on Robosim's AVR processor and on avr8js, each from the same random state. Then
// compares program counter, cycles, status, stack pointer, registers and memory.
//
// Skips the instructions that avr8js 0.21 does not execute as the manual says (docs/evidence/conformance.md
// lists them). Also skips accesses at the ends of flash and memory, which avr8js does not support. Needs
// node, and a folder in which `npm install avr8js` has been run. ROBOSIM_AVR8JS names this folder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "sim/base/child.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/avr_cpu/random_program.h"

namespace robosim::avr {
namespace against_avr8js_test {

constexpr std::size_t kPrograms = 5000;
constexpr std::uint32_t kFurthestJump = 0x1000;  // words
const std::set<std::string> kWrongThere{"CBI", "FMULSU", "NEG"};

/// Formats the state without flag H, which avr8js wrongly computes from bit 0.
std::string state_of(const Cpu& cpu, std::uint64_t cycles) {
  std::string text = fmt::format("{} {} {} {}", cpu.pc(), cycles, cpu.sreg() & ~unsigned{Cpu::kH}, cpu.sp());
  for (std::size_t i = 0; i < 32; ++i) text += fmt::format(" {}", cpu.data[i]);
  std::uint32_t sum = 0;
  for (std::size_t at = 0; at < cpu.data.size(); ++at)
    if (at < ManualModel::kSp || at > ManualModel::kSreg) sum = sum * 31 + cpu.data[at];
  return text + fmt::format(" {}", sum);
}

/// Returns the name of the instruction at `pc`, or "".
std::string name_at(const ManualModel& manual, std::uint32_t pc) {
  const auto row = ManualModel::row_of(manual.flash[pc]);
  return row ? ManualModel::rows()[*row].name : "";
}

class Avr8js : public testing::TestWithParam<bool> {};

TEST_P(Avr8js, DoesWithRandomInstructionsWhatTheProcessorDoes) {
  const char* const folder = std::getenv("ROBOSIM_AVR8JS");
  if (!folder) GTEST_SKIP() << "ROBOSIM_AVR8JS does not name a folder with avr8js";
  const bool long_pc = GetParam();
  std::mt19937 random(long_pc ? 23 : 17);
  Pair pair(random, long_pc);
  const auto words = static_cast<std::uint32_t>(pair.manual.flash.size());
  const auto memory = pair.manual.data;
  const test::TemporaryFolder scratch;
  const auto file = scratch.path() / "programs.txt";
  std::ofstream out(file);
  const auto line = [&](const auto& numbers) {
    for (const auto number : numbers) out << unsigned{number} << ' ';
    out << '\n';
  };
  line(pair.manual.flash);
  line(memory);
  std::vector<std::string> due, names;
  while (due.size() < kPrograms) {
    Start start = pair.random_start(random);
    start.pc = std::clamp(start.pc, kFurthestJump, words - kFurthestJump);
    for (const std::size_t high : {27u, 29u, 31u}) start.registers[high] &= 0x7F;
    pair.manual.data = memory;
    std::copy(memory.begin(), memory.end(), pair.cpu.data.begin());
    pair.begin(start);
    const std::string name = name_at(pair.manual, start.pc);
    const std::uint64_t before = pair.cpu.cycle();
    if (kWrongThere.contains(name) || !pair.run(1) || pair.manual.pc >= words) continue;
    const std::uint64_t cycles = pair.cpu.cycle() - before;
    out << fmt::format("{} {} {} {} {} {} ", start.pc, start.sreg, start.sp, start.rampz, start.eind, cycles);
    line(start.registers);
    due.push_back(state_of(pair.cpu, cycles));
    names.push_back(name);
  }
  out.close();
  std::istringstream states(output_of({"node", ROBOSIM_AVR8JS_SCRIPT, folder, file.string()}));
  for (std::size_t i = 0; i < due.size(); ++i) {
    std::string theirs;
    std::getline(states, theirs);
    EXPECT_EQ(due[i], theirs) << names[i];
  }
}

INSTANTIATE_TEST_SUITE_P(OfProgramCounters, Avr8js, testing::Bool(),
                         [](const auto& of) { return std::string(of.param ? "Of22Bits" : "Of16Bits"); });

}  // namespace against_avr8js_test
}  // namespace robosim::avr
