#include "sim/wire/batch.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr char kSample = 's', kPin = 'p', kLevel = 'l', kVolts = 'v', kByte = 'b';
constexpr const char* kModes[] = {"input", "input_pullup", "output"};
constexpr std::uint8_t kHigh = 1, kPwm = 2;
constexpr std::size_t kMostPinName = 255, kMostReadings = 65'535;

template <class T>
void put(std::string& to, const T& number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  to.append(bytes, sizeof number);
}

void put_head(std::string& to, char kind, int agent, std::int64_t t) {
  to += kind;
  to += static_cast<char>(agent);
  put(to, t);
}

void put_name(std::string& to, const std::string& name) {
  to += static_cast<char>(name.size());
  to += name;
}

bool fits(int agent) { return agent >= 0 && agent < static_cast<int>(kMostAgents); }

/// Nothing that a batch has no place for.
template <class Detail>
bool is_plain(const Detail& detail) {
  return fits(detail.agent) && detail.source.file.empty();
}

class Packer {
 public:
  explicit Packer(std::string& to) : to_(to) {}

  bool operator()(const Sample& s) const {
    if (!fits(s.agent) || !s.at_station.empty() || s.readings.size() > kMostReadings) return false;
    put_head(to_, kSample, s.agent, s.t_us);
    const double numbers[] = {s.x_mm, s.y_mm,  s.yaw_rad,        s.speed_mm_s,    s.cross_track_mm,
                              s.left, s.right, s.wheels_mm_s[0], s.wheels_mm_s[1]};
    put(to_, numbers);
    put(to_, static_cast<std::uint16_t>(s.readings.size()));
    to_.append(reinterpret_cast<const char*>(s.readings.data()), s.readings.size() * sizeof(double));
    return true;
  }
  bool operator()(const PinChange& p) const {
    const auto mode = std::find(std::begin(kModes), std::end(kModes), p.mode);
    if (!is_plain(p) || p.pin.size() > kMostPinName || mode == std::end(kModes)) return false;
    put_head(to_, kPin, p.agent, p.t_ns);
    put_name(to_, p.pin);
    to_ += static_cast<char>(mode - std::begin(kModes));
    to_ += static_cast<char>((p.level ? kHigh : 0) | (p.pwm ? kPwm : 0));
    put(to_, p.duty);
    put(to_, p.tone_hz);
    return true;
  }
  bool operator()(const LevelSeen& l) const {
    if (!is_plain(l) || l.pin.size() > kMostPinName) return false;
    put_head(to_, kLevel, l.agent, l.t_ns);
    put_name(to_, l.pin);
    to_ += static_cast<char>(l.level);
    return true;
  }
  bool operator()(const VoltsSeen& v) const {
    if (!is_plain(v) || v.pin.size() > kMostPinName) return false;
    put_head(to_, kVolts, v.agent, v.t_ns);
    put_name(to_, v.pin);
    put(to_, v.volts);
    return true;
  }
  bool operator()(const SerialByte& b) const {
    if (!is_plain(b)) return false;
    put_head(to_, kByte, b.agent, b.t_ns);
    to_ += static_cast<char>(b.value);
    to_ += static_cast<char>(b.sent);
    return true;
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }

 private:
  std::string& to_;
};

[[noreturn]] void refuse(const char* problem) {
  throw RunnerError(std::string("the runner said something unexpected: a batch ") + problem);
}
[[noreturn]] void refuse() { refuse("that does not hold whole events"); }

std::int64_t time_of(const Event& event) {
  if (const auto* sample = std::get_if<Sample>(&event)) return sample->t_us * 1000;
  return std::visit(
      [](const auto& e) -> std::int64_t {
        if constexpr (requires { e.t_ns; })
          return e.t_ns;
        else
          return 0;
      },
      event);
}

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  bool done() const { return bytes_.empty(); }

  Event next() {
    const char kind = number<char>();
    const int agent = number<std::uint8_t>();
    const auto t = number<std::int64_t>();
    if (t < 0 || t > (kind == kSample ? kLatest_ns / 1000 : kLatest_ns)) refuse();
    switch (kind) {
      case kSample:
        return sample(agent, t);
      case kPin:
        return pin(agent, t);
      case kLevel: {
        std::string name = text();
        return LevelSeen{t, std::move(name), number<std::uint8_t>() != 0, {}, agent};
      }
      case kVolts: {
        std::string name = text();
        return VoltsSeen{t, std::move(name), number<double>(), {}, agent};
      }
      case kByte: {
        const auto value = number<std::uint8_t>();
        return SerialByte{t, value, number<std::uint8_t>() != 0, {}, agent};
      }
      default:
        refuse();
    }
  }

 private:
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
  std::string text() { return std::string(take(number<std::uint8_t>())); }

  Sample sample(int agent, std::int64_t t_us) {
    Sample s;
    s.agent = agent;
    s.t_us = t_us;
    for (double* value : {&s.x_mm, &s.y_mm, &s.yaw_rad, &s.speed_mm_s, &s.cross_track_mm, &s.left, &s.right,
                          &s.wheels_mm_s[0], &s.wheels_mm_s[1]})
      *value = number<double>();
    const std::size_t count = number<std::uint16_t>();
    const std::string_view readings = take(count * sizeof(double));
    s.readings.resize(count);
    std::copy(readings.begin(), readings.end(), reinterpret_cast<char*>(s.readings.data()));
    return s;
  }

  PinChange pin(int agent, std::int64_t t_ns) {
    PinChange p;
    p.agent = agent;
    p.t_ns = t_ns;
    p.pin = text();
    const auto mode = number<std::uint8_t>();
    if (mode >= std::size(kModes)) refuse();
    p.mode = kModes[mode];
    const auto flags = number<std::uint8_t>();
    p.level = flags & kHigh;
    p.pwm = flags & kPwm;
    p.duty = number<double>();
    p.tone_hz = number<std::uint32_t>();
    return p;
  }

  std::string_view bytes_;
};

}  // namespace

bool BatchWriter::add(const Event& event) {
  const bool is_first = bytes_.empty();
  if (!std::visit(Packer(bytes_), event)) return false;
  latest_ns_ = time_of(event);
  if (is_first) since_ns_ = latest_ns_;
  return true;
}

Batch BatchWriter::take() {
  Batch batch{base64(bytes_)};
  bytes_.clear();
  return batch;
}

void unpack(const Batch& batch, const OnEvent& on_event) {
  std::string bytes;
  try {
    bytes = from_base64(batch.bytes);
  } catch (const InputError&) {
    refuse("that is not base64");
  }
  for (Unpacker unpacker(bytes); !unpacker.done();) on_event(unpacker.next());
}

}  // namespace robosim::wire
