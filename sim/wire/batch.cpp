#include "sim/wire/batch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr const char* kModes[] = {"input", "input_pullup", "output"};
constexpr std::uint8_t kMode = 3;
constexpr std::size_t kPins = 256;

bool fits(int agent) { return agent >= 0 && agent < static_cast<int>(kMostAgents); }

[[noreturn]] void refuse() {
  throw RunnerError("unexpected line of the runner: a batch with an incomplete event");
}

}  // namespace

bool comes_in_batches(const RunRequest& request) {
  return request.batches && !request.source_ns && !request.interactive;
}

void BatchWriter::name_pin(std::size_t number, const char* name) {
  if (number >= named_in_.size()) named_in_.resize((number | (kPins - 1)) + 1);
  named_in_[number] = batch_;
  const std::string_view text = std::string_view(name).substr(0, kMostName);
  end(put(put_head(at(), 'n', static_cast<int>(number >> 8), static_cast<std::uint8_t>(number),
                   static_cast<int>(text.size()), 0),
          text));
}

void BatchWriter::count_from(std::int64_t t_ns) {
  end(put(put_head(at(), 't', 0, 0, 0, 0), t_ns));
  from_ns_ = t_ns;
}

void BatchWriter::add_byte(int agent, std::int64_t t_ns, std::uint8_t value, bool sent) {
  begin_at(t_ns);
  end(put_head(at(), 'b', agent, value, sent, step_to(t_ns)));
}

void BatchWriter::add_sources(int agent) { end(put_head(at(), 'd', agent, 0, 0, 0)); }

void BatchWriter::add_source(int agent, const SourceLine& line) {
  const std::string_view function = std::string_view(line.function).substr(0, kMostName),
                         file = std::string_view(line.file).substr(0, kMostName);
  char* const to = put_head(at(), 'c', agent, static_cast<std::uint8_t>(function.size()),
                            static_cast<int>(file.size()), line.line);
  end(put(put(to, function), file));
}

template <std::size_t N>
bool BatchWriter::add_sample(int agent, std::int64_t t_us, int heading, const std::array<double, N>& numbers,
                             const std::vector<double>& readings) {
  const std::size_t bytes = readings.size() * sizeof(double), room = BatchMemory::kRoom_bytes - size();
  constexpr std::size_t kWithout = 128;
  if (!fits(agent) || bytes + kWithout > room) return false;
  char* to = put_head(at(), 's', agent, 0, heading, static_cast<std::int32_t>(readings.size()));
  to = put(put(to, t_us), numbers);
  for (const double reading : readings) to = put(to, reading);
  latest_ns_ = t_us * 1000;
  end(to);
  return true;
}

template bool BatchWriter::add_sample(int, std::int64_t, int, const std::array<double, 10>&,
                                      const std::vector<double>&);

bool BatchWriter::add(const Sample& s) {
  return s.at_station.empty() &&
         add_sample(s.agent, s.t_us, kWithYaw,
                    std::array{s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s, s.cross_track_mm, s.left, s.right,
                               s.wheels_mm_s[0], s.wheels_mm_s[1]},
                    s.readings);
}

bool BatchWriter::add(const Event& event) {
  if (const auto* sample = std::get_if<Sample>(&event)) return add(*sample);
  const auto* byte = std::get_if<SerialByte>(&event);
  if (!byte || !fits(byte->agent) || !byte->source.file.empty()) return false;
  add_byte(byte->agent, byte->t_ns, byte->value, byte->sent);
  return true;
}

Batch BatchWriter::take() {
  const std::size_t bytes =
      std::min(size(), BatchMemory::kRoom_bytes);  // firmware may have overwritten the size
  Batch batch{static_cast<std::int64_t>(bytes), std::string(memory_->bytes, bytes)};
  memory_->used.store(0, std::memory_order_release);
  begin_batch();
  return batch;
}

struct BatchReader::Robot {
  static constexpr std::size_t kUnknown = static_cast<std::size_t>(-1);
  Robot() { numbers.fill(kUnknown); }

  std::array<std::string, kPins> names;
  std::array<bool, kPins> named{};
  std::optional<RunColumns> columns;
  std::array<std::size_t, kPins> numbers;  ///< pin numbers in the columns
  std::vector<SourceLine> sources;

  std::size_t number_of(std::uint8_t pin) {
    if (numbers[pin] == kUnknown) numbers[pin] = columns->add_board_pin(names[pin]);
    return numbers[pin];
  }
};

/// Unpacks one batch. Constructs its events once, and then reuses them.
class BatchReader::Unpacker {
 public:
  Unpacker(BatchReader& reader, std::string_view bytes, const OnEvent& on_event)
      : reader_(reader), bytes_(bytes), on_event_(on_event) {
    for (const auto& robot : reader.robots_)
      if (robot) robot->named.fill(false);
  }

  bool done() const { return bytes_.empty(); }

  void next() {
    const auto head = number<BatchWriter::Head>();
    if (head.agent != agent_ || !robot_) robot_ = &reader_.robot(head.agent);
    Robot& robot = *robot_;
    agent_ = head.agent;
    pin_ = head.pin;
    other_ = head.other;
    step_ = head.number;
    switch (head.kind) {
      case 't':
        t_ns_ = number<std::int64_t>();
        if (t_ns_ < 0 || t_ns_ > kLatest_ns) refuse();
        break;
      case 'n':
        robot.names[pin_] = take(other_);
        robot.named[pin_] = true;
        break;
      case 's':
        sample(robot);
        break;
      case 'p':
        at_pin(robot);
        pin(robot);
        break;
      case 'l':
        at_pin(robot);
        if (robot.columns)
          robot.columns->add_pin(robot.number_of(pin_), t_ns_, other_ != 0 ? PinLevel::high : PinLevel::low,
                                 other_ != 0 ? 1.0 : 0.0, 0);
        if (!reader_.tells_inputs_) break;
        level_->pin = robot.names[pin_];
        level_->level = other_ != 0;
        tell(levels_, *level_);
        break;
      case 'v': {
        at_pin(robot);
        const auto volts = number<double>();
        if (robot.columns) robot.columns->add_volts(robot.number_of(pin_), t_ns_, volts);
        if (!reader_.tells_inputs_) break;
        seen_->pin = robot.names[pin_];
        seen_->volts = volts;
        tell(volts_, *seen_);
        break;
      }
      case 'b':
        go_on();
        byte_->value = pin_;
        byte_->sent = other_ != 0;
        tell(bytes_told_, *byte_);
        break;
      case 'd':
        if (robot.columns) robot.columns->with_sources();
        break;
      case 'c': {
        SourceLine& line = robot.sources.emplace_back();
        line.function = take(pin_);
        line.file = take(other_);
        line.line = step_;
        break;
      }
      default:
        refuse();
    }
  }

 private:
  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) refuse();
    const std::string_view taken(bytes_.data(), count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  void go_on() {
    t_ns_ += step_;
    if (static_cast<std::uint64_t>(t_ns_) > kLatest_ns) refuse();
  }
  void at_pin(const Robot& robot) {
    if (!robot.named[pin_]) refuse();
    go_on();
  }
  template <class Kind>
  void tell(const Event& event, Kind& kind) {
    kind.t_ns = t_ns_;
    kind.agent = agent_;
    on_event_(event);
  }

  void pin(Robot& robot) {
    const int mode = other_ & kMode;
    if (mode >= static_cast<int>(std::size(kModes))) refuse();
    const bool level = other_ & BatchWriter::kHigh, pwm = other_ & BatchWriter::kPwm;
    const auto duty = number<double>();
    const std::uint32_t tone_hz = other_ & BatchWriter::kTone ? number<std::uint32_t>() : 0,
                        source = other_ & BatchWriter::kSource ? number<std::uint32_t>() : 0;
    if (source > robot.sources.size()) refuse();
    if (robot.columns)
      robot.columns->add_pin(robot.number_of(pin_), t_ns_,
                             pin_level(mode == 2, mode == 1, pwm, duty, tone_hz), duty, tone_hz,
                             source != 0 ? &robot.sources[source - 1] : nullptr);
    if (!reader_.tells_pins_) return;
    change_->pin = robot.names[pin_];
    change_->mode = kModes[mode];
    change_->level = level;
    change_->pwm = pwm;
    change_->duty = duty;
    change_->tone_hz = tone_hz;
    tell(changes_, *change_);
  }

  void sample(Robot& robot) {
    Sample& s = *sample_;
    const std::size_t count = step_ < 0 ? bytes_.size() : static_cast<std::size_t>(step_);
    s.t_us = number<std::int64_t>();
    if (s.t_us < 0 || s.t_us > kLatest_ns / 1000) refuse();
    for (double* value : {&s.x_mm, &s.y_mm, &s.yaw_rad}) *value = number<double>();
    if (other_ != 0) s.yaw_rad = std::atan2(s.yaw_rad, number<double>());
    for (double* value :
         {&s.speed_mm_s, &s.cross_track_mm, &s.left, &s.right, &s.wheels_mm_s[0], &s.wheels_mm_s[1]})
      *value = number<double>();
    if (count > bytes_.size() / sizeof(double)) refuse();
    const std::string_view readings = take(count * sizeof(double));
    s.readings.resize(count);
    std::copy(readings.begin(), readings.end(), reinterpret_cast<char*>(s.readings.data()));
    s.agent = agent_;
    const std::int64_t told = reader_.samples_every_us_, kept = reader_.columns_every_us_;
    if (told > 0 && s.t_us % told == 0) on_event_(samples_);
    if (!robot.columns || s.t_us % kept != 0) return;
    robot.columns->add(s);
    if (s.t_us % (kColumnsEvery_ns / 1000) == 0) reader_.tell_columns(agent_, on_event_);
  }

  BatchReader& reader_;
  std::string_view bytes_;
  const OnEvent& on_event_;
  std::int64_t t_ns_ = 0;
  Robot* robot_ = nullptr;
  int agent_ = 0;
  std::uint8_t pin_ = 0, other_ = 0;
  std::int32_t step_ = 0;
  Event samples_ = Sample{}, changes_ = PinChange{}, levels_ = LevelSeen{}, volts_ = VoltsSeen{},
        bytes_told_ = SerialByte{};
  Sample* const sample_ = std::get_if<Sample>(&samples_);
  PinChange* const change_ = std::get_if<PinChange>(&changes_);
  LevelSeen* const level_ = std::get_if<LevelSeen>(&levels_);
  VoltsSeen* const seen_ = std::get_if<VoltsSeen>(&volts_);
  SerialByte* const byte_ = std::get_if<SerialByte>(&bytes_told_);
};

BatchReader::BatchReader(const RunRequest& request)
    : tells_pins_(request.pins),
      tells_inputs_(request.io),
      samples_every_us_(request.samples_every_ns / 1000),
      columns_every_us_(comes_in_batches(request) ? request.columns_every_ns / 1000 : 0) {}

BatchReader::BatchReader(BatchReader&&) noexcept = default;
BatchReader& BatchReader::operator=(BatchReader&&) noexcept = default;
BatchReader::~BatchReader() = default;

BatchReader::Robot& BatchReader::robot(int agent) {
  const auto number = static_cast<std::size_t>(agent);
  if (number >= robots_.size()) robots_.resize(number + 1);
  if (!robots_[number]) {
    robots_[number] = std::make_unique<Robot>();
    if (columns_every_us_ > 0) robots_[number]->columns.emplace(std::vector<std::string>{});
  }
  return *robots_[number];
}

void BatchReader::begin(const Started& started) {
  if (!fits(started.agent)) return;
  if (Robot& own = robot(started.agent); own.columns) own.columns->begin(started.readings);
}

void BatchReader::read(std::string_view bytes, const OnEvent& on_event) {
  for (Unpacker unpacker(*this, bytes, on_event); !unpacker.done();) unpacker.next();
}

void BatchReader::tell_columns(int agent, const OnEvent& on_event) {
  Columns columns = robot(agent).columns->take();
  columns.agent = agent;
  if (!columns.streams.empty()) on_event(columns);
}

void BatchReader::finish(const OnEvent& on_event) {
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (robots_[i] && robots_[i]->columns) tell_columns(static_cast<int>(i), on_event);
}

}  // namespace robosim::wire
