// The programs of tests/conformance/avr, each on the core: what it reports is what the data sheet says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hal/board/atmega328p.h"
#include "tests/conformance/bench.h"
#include "tests/conformance/program.h"
#include "tests/support/require_target.h"

namespace robosim::conformance {
namespace {

class Conformance : public testing::TestWithParam<Program> {};

TEST_P(Conformance, ReportsWhatTheDataSheetSays) {
  ROBOSIM_NEEDS_TARGET("avr");
  const Program& program = GetParam();
  const auto flash = compile(program, "atmega328p");
  Bench bench(kAtmega328p, flash);
  bench.run(program.cycles);
  EXPECT_TRUE(bench.ended) << "it has not ended after " << program.cycles << " cycles, at word "
                           << bench.chip.cpu().pc() << " of flash";
  EXPECT_TRUE(matches(program.expected, bench.reported))
      << program.sentence << " (" << program.source << ")\n  expected " << text_of(program.expected)
      << "\n  reported " << text_of(bench.reported);
}

INSTANTIATE_TEST_SUITE_P(Of, Conformance, testing::ValuesIn(programs_in(ROBOSIM_CONFORMANCE_PROGRAMS)),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace robosim::conformance
