#include "sim/wire/batch.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr char kSample = 's', kPin = 'p', kLevel = 'l', kVolts = 'v', kByte = 'b', kColumns = 'c';
constexpr const char* kModes[] = {"input", "input_pullup", "output"};
constexpr std::uint8_t kHigh = 1, kPwm = 2;
constexpr std::size_t kMostListed = 65'535;

/// The bytes of one event, which are added to the others at once.
class Packed {
 public:
  Packed(char kind, int agent, std::int64_t t) {
    put(kind);
    put(static_cast<std::uint8_t>(agent));
    put(t);
  }
  template <class T>
  void put(const T& number) {
    std::memcpy(bytes_ + size_, &number, sizeof number);
    size_ += sizeof number;
  }
  /// At most one, of at most kMostName.
  void put_name(std::string_view name) {
    put(static_cast<std::uint8_t>(name.size()));
    std::memcpy(bytes_ + size_, name.data(), name.size());
    size_ += name.size();
  }
  void add_to(std::string& all) const { all.append(bytes_, size_); }

 private:
  char bytes_[BatchWriter::kMostName + 128];
  std::size_t size_ = 0;
};

bool fits(int agent) { return agent >= 0 && agent < static_cast<int>(kMostAgents); }

/// Nothing that a batch has no place for.
template <class Detail>
bool is_plain(const Detail& detail) {
  return fits(detail.agent) && detail.source.file.empty();
}
bool is_short(const std::string& name) { return name.size() <= BatchWriter::kMostName; }

bool has_room_for(const Columns& columns) {
  const auto named = [](const ColumnSpec& spec) { return is_short(spec.name); };
  return fits(columns.agent) && columns.sources.size() <= kMostListed &&
         columns.streams.size() <= kMostListed &&
         std::all_of(columns.sources.begin(), columns.sources.end(),
                     [](const SourceLine& line) { return is_short(line.function) && is_short(line.file); }) &&
         std::all_of(columns.streams.begin(), columns.streams.end(), [&](const Rows& rows) {
           return is_short(rows.stream) && rows.bytes.size() <= kMostListed &&
                  (rows.columns.empty() || rows.columns.size() == rows.bytes.size()) &&
                  std::all_of(rows.columns.begin(), rows.columns.end(), named) &&
                  std::all_of(rows.bytes.begin(), rows.bytes.end(), [](const std::string& bytes) {
                    return bytes.size() <= std::numeric_limits<std::uint32_t>::max();
                  });
         });
}

template <class T>
void put(std::string& to, T number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  to.append(bytes, sizeof number);
}
void put_name(std::string& to, const std::string& name) {
  put(to, static_cast<std::uint8_t>(name.size()));
  to += name;
}

void put_rows(std::string& to, const Rows& rows) {
  put_name(to, rows.stream);
  put(to, rows.count);
  put(to, static_cast<std::uint16_t>(rows.bytes.size()));
  put(to, static_cast<std::uint8_t>(!rows.columns.empty()));
  for (const ColumnSpec& spec : rows.columns) {
    put_name(to, spec.name);
    put(to, spec.scale);
    put(to, static_cast<std::uint8_t>(spec.order));
  }
  for (const std::string& bytes : rows.bytes) {
    put(to, static_cast<std::uint32_t>(bytes.size()));
    to += bytes;
  }
}

[[noreturn]] void refuse() {
  throw RunnerError("the runner said something unexpected: a batch that does not hold whole events");
}

/// Its events are made once, and filled again and again.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  bool done() const { return bytes_.empty(); }

  /// Until the next call.
  const Event& next() {
    const char kind = number<char>();
    const int agent = number<std::uint8_t>();
    const auto t = number<std::int64_t>();
    if (t < 0 || t > (kind == kSample ? kLatest_ns / 1000 : kLatest_ns)) refuse();
    switch (kind) {
      case kSample:
        read(begun<Sample>(sample_, agent), t);
        return sample_;
      case kPin:
        read(begun<PinChange>(pin_, agent), t);
        return pin_;
      case kLevel: {
        auto& level = begun<LevelSeen>(level_, agent);
        level.t_ns = t;
        level.pin = name();
        level.level = number<std::uint8_t>() != 0;
        return level_;
      }
      case kVolts: {
        auto& volts = begun<VoltsSeen>(volts_, agent);
        volts.t_ns = t;
        volts.pin = name();
        volts.volts = number<double>();
        return volts_;
      }
      case kByte: {
        auto& byte = begun<SerialByte>(byte_, agent);
        byte.t_ns = t;
        byte.value = number<std::uint8_t>();
        byte.sent = number<std::uint8_t>() != 0;
        return byte_;
      }
      case kColumns:
        columns_ = columns(agent);
        return columns_;
      default:
        refuse();
    }
  }

 private:
  template <class Kind>
  static Kind& begun(Event& event, int agent) {
    Kind& kind = *std::get_if<Kind>(&event);
    kind.agent = agent;
    return kind;
  }

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) refuse();
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view name() { return take(number<std::uint8_t>()); }

  void read(Sample& s, std::int64_t t_us) {
    s.t_us = t_us;
    for (double* value : {&s.x_mm, &s.y_mm, &s.yaw_rad, &s.speed_mm_s, &s.cross_track_mm, &s.left, &s.right,
                          &s.wheels_mm_s[0], &s.wheels_mm_s[1]})
      *value = number<double>();
    const std::size_t count = number<std::uint16_t>();
    const std::string_view readings = take(count * sizeof(double));
    s.readings.resize(count);
    std::copy(readings.begin(), readings.end(), reinterpret_cast<char*>(s.readings.data()));
  }

  void read(PinChange& p, std::int64_t t_ns) {
    p.t_ns = t_ns;
    p.pin = name();
    const auto mode = number<std::uint8_t>();
    if (mode >= std::size(kModes)) refuse();
    p.mode = kModes[mode];
    const auto flags = number<std::uint8_t>();
    p.level = flags & kHigh;
    p.pwm = flags & kPwm;
    p.duty = number<double>();
    p.tone_hz = number<std::uint32_t>();
  }

  Columns columns(int agent) {
    Columns columns;
    columns.agent = agent;
    for (auto left = number<std::uint16_t>(); left > 0; --left) {
      SourceLine& line = columns.sources.emplace_back();
      line.function = name();
      line.file = name();
      line.line = number<std::int32_t>();
    }
    for (auto left = number<std::uint16_t>(); left > 0; --left) {
      Rows& rows = columns.streams.emplace_back();
      rows.stream = name();
      rows.count = number<std::int64_t>();
      const auto width = number<std::uint16_t>();
      const bool has_specs = number<std::uint8_t>() != 0;
      if (rows.count < 0) refuse();
      for (std::uint16_t i = 0; has_specs && i < width; ++i) {
        ColumnSpec& spec = rows.columns.emplace_back();
        spec.name = name();
        spec.scale = number<double>();
        spec.order = number<std::uint8_t>();
      }
      for (std::uint16_t i = 0; i < width; ++i) rows.bytes.emplace_back(take(number<std::uint32_t>()));
    }
    return columns;
  }

  std::string_view bytes_;
  Event sample_ = Sample{}, pin_ = PinChange{}, level_ = LevelSeen{}, volts_ = VoltsSeen{},
        byte_ = SerialByte{}, columns_ = Columns{};
};

}  // namespace

void BatchWriter::happened(std::int64_t t_ns) {
  if (bytes_.empty()) since_ns_ = t_ns;
  latest_ns_ = t_ns;
}

void BatchWriter::add_pin(int agent, std::int64_t t_ns, std::string_view pin, int mode, bool level, bool pwm,
                          double duty, std::uint32_t tone_hz) {
  happened(t_ns);
  Packed packed(kPin, agent, t_ns);
  packed.put_name(pin);
  packed.put(static_cast<std::uint8_t>(mode));
  packed.put(static_cast<std::uint8_t>((level ? kHigh : 0) | (pwm ? kPwm : 0)));
  packed.put(duty);
  packed.put(tone_hz);
  packed.add_to(bytes_);
}

void BatchWriter::add_level(int agent, std::int64_t t_ns, std::string_view pin, bool level) {
  happened(t_ns);
  Packed packed(kLevel, agent, t_ns);
  packed.put_name(pin);
  packed.put(static_cast<std::uint8_t>(level));
  packed.add_to(bytes_);
}

void BatchWriter::add_volts(int agent, std::int64_t t_ns, std::string_view pin, double volts) {
  happened(t_ns);
  Packed packed(kVolts, agent, t_ns);
  packed.put_name(pin);
  packed.put(volts);
  packed.add_to(bytes_);
}

void BatchWriter::add_byte(int agent, std::int64_t t_ns, std::uint8_t value, bool sent) {
  happened(t_ns);
  Packed packed(kByte, agent, t_ns);
  packed.put(value);
  packed.put(static_cast<std::uint8_t>(sent));
  packed.add_to(bytes_);
}

bool BatchWriter::add(const Sample& s) {
  if (!fits(s.agent) || !s.at_station.empty() || s.readings.size() > kMostListed) return false;
  happened(s.t_us * 1000);
  Packed packed(kSample, s.agent, s.t_us);
  for (const double number : {s.x_mm, s.y_mm, s.yaw_rad, s.speed_mm_s, s.cross_track_mm, s.left, s.right,
                              s.wheels_mm_s[0], s.wheels_mm_s[1]})
    packed.put(number);
  packed.put(static_cast<std::uint16_t>(s.readings.size()));
  packed.add_to(bytes_);
  bytes_.append(reinterpret_cast<const char*>(s.readings.data()), s.readings.size() * sizeof(double));
  return true;
}

bool BatchWriter::add(const Columns& columns) {
  if (!has_room_for(columns)) return false;
  Packed(kColumns, columns.agent, 0).add_to(bytes_);
  put(bytes_, static_cast<std::uint16_t>(columns.sources.size()));
  for (const SourceLine& line : columns.sources) {
    put_name(bytes_, line.function);
    put_name(bytes_, line.file);
    put(bytes_, static_cast<std::int32_t>(line.line));
  }
  put(bytes_, static_cast<std::uint16_t>(columns.streams.size()));
  for (const Rows& rows : columns.streams) put_rows(bytes_, rows);
  return true;
}

bool BatchWriter::add(const Event& event) {
  if (const auto* sample = std::get_if<Sample>(&event)) return add(*sample);
  if (const auto* columns = std::get_if<Columns>(&event)) return add(*columns);
  if (const auto* p = std::get_if<PinChange>(&event)) {
    const auto* mode = std::find(std::begin(kModes), std::end(kModes), p->mode);
    if (!is_plain(*p) || !is_short(p->pin) || mode == std::end(kModes)) return false;
    add_pin(p->agent, p->t_ns, p->pin, static_cast<int>(mode - std::begin(kModes)), p->level, p->pwm, p->duty,
            p->tone_hz);
  } else if (const auto* level = std::get_if<LevelSeen>(&event)) {
    if (!is_plain(*level) || !is_short(level->pin)) return false;
    add_level(level->agent, level->t_ns, level->pin, level->level);
  } else if (const auto* volts = std::get_if<VoltsSeen>(&event)) {
    if (!is_plain(*volts) || !is_short(volts->pin)) return false;
    add_volts(volts->agent, volts->t_ns, volts->pin, volts->volts);
  } else if (const auto* byte = std::get_if<SerialByte>(&event)) {
    if (!is_plain(*byte)) return false;
    add_byte(byte->agent, byte->t_ns, byte->value, byte->sent);
  } else {
    return false;
  }
  return true;
}

Batch BatchWriter::take() { return {static_cast<std::int64_t>(bytes_.size()), std::exchange(bytes_, {})}; }

void unpack(std::string_view bytes, const OnEvent& on_event) {
  for (Unpacker unpacker(bytes); !unpacker.done();) on_event(unpacker.next());
}

}  // namespace robosim::wire
