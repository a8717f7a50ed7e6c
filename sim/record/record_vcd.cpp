#include "sim/record/record_vcd.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/record/number_text.h"
#include "sim/wire/run_columns.h"

namespace robosim::record {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;
constexpr std::size_t kLongestLine = kLongestNumber + 16, kLongestTime = 24;
// Changes that arrive with at most this delay are sorted by time. Changes with a longer delay may be written
// out of order.
constexpr std::int64_t kLatest_ns = 1'000'000'000;
constexpr std::size_t kFewWaiting = 4096;

// Returns an identifier of printable characters. The first numbers get the shortest identifiers.
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

void VcdRecorder::ask(wire::RunRequest& request) const { request.pins = request.io = true; }

void VcdRecorder::begin(const RecordedRun& run) {
  for (const RecordedRobot& robot : run.robots)
    begin_board(robot.name, *find_board(robot.info.board.name.c_str()));
  if (boards_.empty()) {
    const BoardSpec& board = *find_board(run.robot_info.board.name.c_str());
    begin_board(board.name, board);
  }
  write_header();
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
  if (signal == kNone) return;
  waiting_.push_back({t_ns, value, signal});
  for (std::size_t i = waiting_.size() - 1; i > 0 && waiting_[i - 1].t_ns > t_ns; --i)
    std::swap(waiting_[i - 1], waiting_[i]);
  if (waiting_.size() < most_waiting_) return;
  write_changes(waiting_.back().t_ns - kLatest_ns);
  most_waiting_ = std::max(kFewWaiting, 2 * waiting_.size());
}

void VcdRecorder::add_byte(Board& board, const wire::SerialByte& byte) {
  const auto& signals = byte.sent ? board.sent : board.received;
  bool& flipped = board.flipped[byte.sent ? 0 : 1];
  flipped = !flipped;
  change(byte.t_ns, signals[0], byte.value);
  change(byte.t_ns, signals[1], flipped);
}

const VcdRecorder::PinSignals* VcdRecorder::signals_of(int agent, const std::string& pin) {
  const auto number = static_cast<std::size_t>(agent);
  if (number >= boards_.size()) return nullptr;
  Board& board = boards_[number];
  std::uint64_t key = 0;
  if (pin.size() < sizeof key) std::memcpy(&key, pin.data(), pin.size());
  for (const auto& [known, signals] : board.met)
    if (known == key && key != 0) return signals;
  const auto found = board.pins.find(pin);
  if (found == board.pins.end()) return nullptr;
  if (key != 0) board.met.emplace_back(key, &found->second);
  return &found->second;
}

void VcdRecorder::add(const wire::Event& event) {
  if (const auto* volts = std::get_if<wire::VoltsSeen>(&event)) {
    if (const PinSignals* signals = signals_of(volts->agent, volts->pin))
      change(volts->t_ns, signals->volts, volts->volts);
  } else if (const auto* drive = std::get_if<wire::PinChange>(&event)) {
    const PinSignals* signals = signals_of(drive->agent, drive->pin);
    if (!signals) return;
    change(drive->t_ns, signals->level, static_cast<int>(wire::pin_level(*drive)));
    change(drive->t_ns, signals->duty, drive->duty);
    change(drive->t_ns, signals->tone, drive->tone_hz);
  } else if (const auto* level = std::get_if<wire::LevelSeen>(&event)) {
    if (const PinSignals* signals = signals_of(level->agent, level->pin))
      change(level->t_ns, signals->level, level->level);
  } else if (const auto* byte = std::get_if<wire::SerialByte>(&event)) {
    if (const auto number = static_cast<std::size_t>(byte->agent); number < boards_.size())
      add_byte(boards_[number], *byte);
  }
}

char* VcdRecorder::write(char* to, const Signal& signal, double value) {
  const int whole = static_cast<int>(value);
  switch (signal.kind) {
    case Signal::Kind::wire:
      *to++ = "01zx"[whole & 3];
      break;
    case Signal::Kind::real:
      *to++ = 'r';
      to = put_number(to, value);
      *to++ = ' ';
      break;
    case Signal::Kind::byte:
      to = fmt::format_to(to, FMT_COMPILE("b{:b} "), whole);
      break;
  }
  to = std::copy(signal.id.begin(), signal.id.end(), to);
  *to++ = '\n';
  return to;
}

void VcdRecorder::write_header() {
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

  values_.assign(signals_.size(), 0.0);
  for (const Board& board : boards_)
    for (const auto& [name, signals] : board.pins)
      if (signals.level != kNone)
        values_[signals.level] = static_cast<int>(wire::PinLevel::floating);  // a reset makes all pins inputs
  char line[kLongestLine];
  for (std::size_t i = 0; i < signals_.size(); ++i) out.append(line, write(line, signals_[i], values_[i]));
  file_.add(out += "$end\n");
}

char* VcdRecorder::go_to(char* to, std::int64_t t_ns) {
  now_ns_ = t_ns;
  *to++ = '#';
  to = put_number(to, t_ns);
  *to++ = '\n';
  return to;
}

void VcdRecorder::write_changes(std::int64_t until_ns) {
  std::size_t written = 0;
  for (; written < waiting_.size() && waiting_[written].t_ns <= until_ns; ++written) {
    const Change& change = waiting_[written];
    if (values_[change.signal] == change.value) continue;
    values_[change.signal] = change.value;
    char* to = file_.room(kLongestTime + kLongestLine);
    if (change.t_ns > now_ns_) to = go_to(to, change.t_ns);
    file_.added(write(to, signals_[change.signal], change.value));
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(written));
}

void VcdRecorder::finish(const result::RunResult& result) {
  ended(result);
  for (const result::RunResult& other : result.others) ended(other);
  write_changes(std::numeric_limits<std::int64_t>::max());
  if (last_ns_ > now_ns_) file_.added(go_to(file_.room(kLongestTime), last_ns_));
  file_.finish();
}

// Extends the file to the run's last whole hundredth of a second.
void VcdRecorder::ended(const result::RunResult& result) {
  const std::int64_t end_ns = std::llround(result.time_s * 1e9);
  last_ns_ = std::max(last_ns_, end_ns - end_ns % kRecordEvery_ns);
}

}  // namespace robosim::record
