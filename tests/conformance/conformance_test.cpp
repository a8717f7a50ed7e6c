// Runs each program of tests/conformance/avr on Robosim's emulated AVR and on the target host, and compares
// its report with the data sheet.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/conformance/bench.h"
#include "tests/conformance/host.h"
#include "tests/conformance/program.h"
#include "tests/support/require_target.h"

namespace robosim::conformance {
namespace conformance_test {

/// A program on one of its chips.
struct Case {
  Program program;
  std::string chip;
};
void PrintTo(const Case& one, std::ostream* out) { *out << one.program.name << " on the " << one.chip; }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Program& program : programs_in(ROBOSIM_CONFORMANCE_PROGRAMS))
    for (const std::string& chip : program.chips) all.push_back({program, chip});
  return all;
}

class Conformance : public testing::TestWithParam<Case> {};

TEST_P(Conformance, ReportsWhatTheDataSheetSays) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Program& program = GetParam().program;
  const auto flash = compile(program, GetParam().chip);
  Bench bench(chip_named(GetParam().chip), flash);
  bench.wire_to_itself(program.loop);
  bench.run(program.cycles);
  EXPECT_TRUE(bench.ended) << "the program has not ended after " << program.cycles << " cycles, at word "
                           << bench.chip.cpu().pc() << " of flash";
  EXPECT_TRUE(is_right(program, {bench.reported, true}))
      << program.sentence << " (" << program.source << ")\n  expected " << text_of(program.expected)
      << "\n  reported " << text_of(bench.reported);
}

INSTANTIATE_TEST_SUITE_P(Of, Conformance, testing::ValuesIn(cases()),
                         [](const auto& of) { return of.param.program.name + "_" + of.param.chip; });

class HostConformance : public testing::TestWithParam<Program> {};

// A program must fail on the host if it gives a reason in a `Host:` line, and pass otherwise.
TEST_P(HostConformance, ReportsWhatTheDataSheetSaysOrStatesItsReason) {
  const Program& program = GetParam();
  const Report report = run_on_host(program);
  EXPECT_EQ(is_right(program, report), program.host.empty())
      << program.sentence << " (" << program.source << ")\n  expected " << text_of(program.expected)
      << "\n  reported " << text_of(report.bytes) << (report.ended ? "" : ", has not ended")
      << "\n  reason to fail on the host: " << program.host;
}

std::vector<Program> programs_for_the_host() {
  std::vector<Program> all = programs_in(ROBOSIM_CONFORMANCE_PROGRAMS);
  std::erase_if(all, [](const Program& program) { return !is_for(program, kHostChip); });
  return all;
}

INSTANTIATE_TEST_SUITE_P(Of, HostConformance, testing::ValuesIn(programs_for_the_host()),
                         [](const auto& of) { return of.param.name; });

}  // namespace conformance_test
}  // namespace robosim::conformance
