// Records arbitrary events of a runner as CSV and as VCD. The times in the VCD file must not decrease. Reads
// arbitrary bytes as a recording and as the CSV table of a sweep. A message that rejects a file must name the
// file. Each row of a valid table must be a run of the sweep.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/csv.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/campaign/sweep/sweep_table.h"
#include "sim/record/record_csv.h"
#include "sim/record/record_vcd.h"
#include "sim/record/recording.h"
#include "sim/wire/protocol.h"
#include "tests/fuzz/require.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace robosim;

void record_events(std::string_view text) {
  record::CsvRecorder table("fuzz.csv");
  static const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "fuzz.vcd";
  record::VcdRecorder signals(file);
  record::RecordedRun run;
  run.robot_info.board.name = "uno";
  signals.begin(run);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    try {
      const wire::Line read = wire::parse_line(line);
      if (const auto* event = std::get_if<wire::Event>(&read.content)) {
        table.add(*event);
        signals.add(*event);
      }
    } catch (const wire::RunnerError&) {
    }
  }
  signals.finish({});
  const std::string waves = read_file(file);
  std::filesystem::remove(file);
  long long last = -1;
  for (std::size_t at = waves.find("$enddefinitions"); at != waves.npos; at = waves.find("\n#", at + 1)) {
    if (waves[at] != '\n') continue;
    const long long t = std::stoll(waves.substr(at + 2, waves.find('\n', at + 2) - at - 2));
    require(t >= last, "the file is in the order of time");
    last = t;
  }
}

const campaign::SweepPlan& plan() {
  static const campaign::SweepPlan plan = [] {
    campaign::SweepPlan made;
    campaign::Combination& only = made.combinations.emplace_back();
    only.inputs.sketch = "S";
    only.inputs.map = "oval";
    only.inputs.robot = "uno5";
    only.inputs.target = "host";
    only.fingerprint.parts = {"01234567", "01234567", "01234567", "01234567"};
    made.first_seed = 1;
    made.seeds = 10;
    return made;
  }();
  return plan;
}

void read_table(std::string_view rows) {
  for (const std::string& text : {std::string(rows), campaign::sweep_header() + std::string(rows)}) {
    try {
      for (const campaign::SweepRow& row : campaign::read_sweep_rows(text, "fuzz.csv", plan())) {
        require(row.run < plan().runs(), "a row is of the plan");
        require(row.outcome.made() && row.line.back() == '\n', "a row is whole");
      }
    } catch (const InputError& error) {
      require(error.place().file == "fuzz.csv", "errors name the file");
    }
  }
}

void read_recording(std::string_view bytes) {
  try {
    record::Recording::decode(bytes, "fuzz.rec").play([](const wire::Event&) {});
  } catch (const InputError& error) {
    require(error.place().file == "fuzz.rec", "errors name the file");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  record_events(text);
  read_table(text);
  read_recording(text);
  return 0;
}
