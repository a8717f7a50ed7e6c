#include "sim/record/record_vcd.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/base/file.h"
#include "sim/wire/run_columns.h"

namespace robosim::record {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

// Printable characters, the shortest first.
std::string identifier(std::size_t number) {
  constexpr std::size_t kFirst = 33, kCount = 94;
  std::string id;
  do {
    id += static_cast<char>(kFirst + number % kCount);
    number /= kCount;
  } while (number > 0);
  return id;
}

}  // namespace

void VcdRecorder::ask(wire::RunRequest& request) const {
  Recorder::ask(request);
  request.pins = request.io = true;
}

void VcdRecorder::begin(const RecordedRun& run) {
  for (const RecordedRobot& robot : run.robots)
    begin_board(robot.name, *find_board(robot.info.board.name.c_str()));
  if (!boards_.empty()) return;
  const BoardSpec& board = *find_board(run.robot_info.board.name.c_str());
  begin_board(board.name, board);
}

void VcdRecorder::begin_board(const std::string& scope, const BoardSpec& board) {
  Board& own = boards_.emplace_back();
  own.scope = scope;
  using Kind = Signal::Kind;
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    const PinSpec& spec = board.pins[pin];
    const std::string name = spec.name;
    PinSignals& signals = own.pins[name];
    signals.level = spec.digital ? declare(name, Kind::wire) : kNone;
    signals.duty = spec.pwm ? declare(name + "_duty", Kind::real) : kNone;
    signals.tone = spec.digital ? declare(name + "_tone_hz", Kind::real) : kNone;
    signals.volts = spec.analog_channel >= 0 ? declare(name + "_volts", Kind::real) : kNone;
  }
  const char* names[] = {"tx", "rx"};
  for (auto* bytes : {&own.sent, &own.received}) {
    const std::string name = names[bytes == &own.received];
    (*bytes)[0] = declare(name, Kind::byte);
    (*bytes)[1] = declare(name + "_flip", Kind::wire);
  }
  own.end = signals_.size();
}

std::uint32_t VcdRecorder::declare(std::string name, Signal::Kind kind) {
  signals_.push_back({std::move(name), kind, identifier(signals_.size())});
  return static_cast<std::uint32_t>(signals_.size() - 1);
}

void VcdRecorder::change(std::int64_t t_ns, std::uint32_t signal, double value) {
  if (signal != kNone) changes_.push_back({t_ns, signal, value});
}

void VcdRecorder::add_byte(Board& board, const wire::SerialByte& byte) {
  const auto& signals = byte.sent ? board.sent : board.received;
  bool& flipped = board.flipped[byte.sent ? 0 : 1];
  flipped = !flipped;
  change(byte.t_ns, signals[0], byte.value);
  change(byte.t_ns, signals[1], flipped);
}

void VcdRecorder::add(const wire::Event& event) {
  const auto signals_of = [&](int agent, const std::string& pin) {
    constexpr PinSignals kUnknown{kNone, kNone, kNone, kNone};
    const auto number = static_cast<std::size_t>(agent);
    if (number >= boards_.size()) return kUnknown;
    const auto found = boards_[number].pins.find(pin);
    return found == boards_[number].pins.end() ? kUnknown : found->second;
  };
  if (const auto* drive = std::get_if<wire::PinChange>(&event)) {
    const PinSignals signals = signals_of(drive->agent, drive->pin);
    change(drive->t_ns, signals.level, static_cast<int>(wire::pin_level(*drive)));
    change(drive->t_ns, signals.duty, drive->duty);
    change(drive->t_ns, signals.tone, drive->tone_hz);
  } else if (const auto* level = std::get_if<wire::LevelSeen>(&event)) {
    change(level->t_ns, signals_of(level->agent, level->pin).level, level->level);
  } else if (const auto* volts = std::get_if<wire::VoltsSeen>(&event)) {
    change(volts->t_ns, signals_of(volts->agent, volts->pin).volts, volts->volts);
  } else if (const auto* byte = std::get_if<wire::SerialByte>(&event)) {
    if (const auto number = static_cast<std::size_t>(byte->agent); number < boards_.size())
      add_byte(boards_[number], *byte);
  } else if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    last_ns_ = std::max(last_ns_, sample->t_us * 1000);
  }
}

void VcdRecorder::write(std::string& out, const Signal& signal, double value) {
  auto to = std::back_inserter(out);
  const int whole = static_cast<int>(value);
  switch (signal.kind) {
    case Signal::Kind::wire:
      fmt::format_to(to, "{}{}\n", "01zx"[whole & 3], signal.id);
      break;
    case Signal::Kind::real:
      fmt::format_to(to, "r{} {}\n", value, signal.id);
      break;
    case Signal::Kind::byte:
      fmt::format_to(to, "b{:b} {}\n", whole, signal.id);
      break;
  }
}

std::string VcdRecorder::text() const {
  std::string out = "$version Robosim $end\n$timescale 1 ns $end\n";
  constexpr const char* kTypes[] = {"wire 1", "real 64", "reg 8"};
  std::size_t next = 0;
  for (const Board& board : boards_) {
    out += fmt::format("$scope module {} $end\n", board.scope);
    for (; next < board.end; ++next)
      fmt::format_to(std::back_inserter(out), "$var {} {} {} $end\n",
                     kTypes[static_cast<int>(signals_[next].kind)], signals_[next].id, signals_[next].name);
    out += "$upscope $end\n";
  }
  out += "$enddefinitions $end\n#0\n$dumpvars\n";

  std::vector<double> values(signals_.size(), 0.0);
  for (const Board& board : boards_)
    for (const auto& [name, signals] : board.pins)
      if (signals.level != kNone)
        values[signals.level] = static_cast<int>(wire::PinLevel::floating);  // a reset leaves inputs
  for (std::size_t i = 0; i < signals_.size(); ++i) write(out, signals_[i], values[i]);
  out += "$end\n";

  std::vector<Change> changes = changes_;
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.t_ns < b.t_ns; });
  std::int64_t now = 0;
  for (const Change& change : changes) {
    if (values[change.signal] == change.value) continue;
    values[change.signal] = change.value;
    if (change.t_ns != now) out += fmt::format("#{}\n", now = change.t_ns);
    write(out, signals_[change.signal], change.value);
  }
  if (last_ns_ > now) out += fmt::format("#{}\n", last_ns_);
  return out;
}

void VcdRecorder::finish(const wire::RunResult&) { write_file(path_, text()); }

}  // namespace robosim::record
