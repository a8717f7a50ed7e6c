#include "sim/campaign/analysis/compare_streams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace robosim::analysis {
namespace {

constexpr std::size_t kStream = 20;    // a text with more occurrences is a stream
constexpr std::size_t kStreamRow = 5;  // so is a text with this many occurrences within kStreamTime_ns
constexpr std::int64_t kStreamTime_ns = 2 * kSecond_ns;
constexpr std::size_t kMissedRow = 10;  // consecutive missing lines that count as a difference …
constexpr std::int64_t kMissedTime_ns = 5 * kSecond_ns;  // … if they span this time

class StreamComparer {
 public:
  StreamComparer(const Lanes& lanes, const std::array<const History*, 2>& sides, const Clocks& clocks,
                 const Tolerance& tolerance)
      : lanes_(lanes), sides_(sides), clocks_(clocks), tolerance_(tolerance) {}

  std::vector<Difference> compare(const std::string& form) {
    if (lanes_[0].empty() || lanes_[1].empty()) {
      compare_with_none(lanes_[0].empty() ? 1 : 0);
      return std::move(found_);
    }
    compare_rates();
    for (const std::size_t side : {0U, 1U}) compare_presence(side);
    find_last_places();
    if (compare_numbers(form, 0)) compare_numbers(form, 1);
    return std::move(found_);
  }

 private:
  std::int64_t other_clock(std::size_t side, std::int64_t t) const {
    return side == 0 ? clocks_.to_b(t) : clocks_.to_a(t);
  }

  void compare_with_none(std::size_t has) {
    const Said& said = lanes_[has].front();
    Difference d{Difference::Kind::line,
                 "line " + std::to_string(said.number + 1) + " of the serial port",
                 {},
                 {},
                 "",
                 {}};
    d.t_ns[has] = said.t_ns;
    d.t_ns[1 - has] = other_clock(has, said.t_ns);
    d.sides[has] = "prints " + quoted(said.text) + " repeatedly";
    d.sides[1 - has] = "prints no such line";
    d.line[has] = said.number;
    found_.push_back(std::move(d));
  }

  void compare_rates() {
    std::array<double, 2> rate{};
    for (std::size_t side = 0; side < 2; ++side) {
      const double s = 1e-9 * static_cast<double>(lanes_[side].back().t_ns - lanes_[side].front().t_ns);
      if (lanes_[side].size() < kStream / 2 || s <= 0.0) return;
      rate[side] = static_cast<double>(lanes_[side].size() - 1) / s;
    }
    if (std::fabs(rate[0] - rate[1]) <= tolerance_.time * std::max(rate[0], rate[1])) return;
    const auto text = [&](std::size_t side) {
      const auto tenths = static_cast<long long>(10.0 * rate[side] + 0.5);
      return "comes " + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " times a second";
    };
    found_.push_back({Difference::Kind::time,
                      "the line " + quoted(lanes_[0].front().text),
                      {lanes_[0].front().t_ns, lanes_[1].front().t_ns},
                      {text(0), text(1)},
                      "",
                      {lanes_[0].front().number, lanes_[1].front().number}});
  }

  /// Checks that the other side also prints `side`'s lines at about the same time.
  void compare_presence(std::size_t side) {
    const auto& others = lanes_[1 - side];
    const Said* first = nullptr;  // first missing line
    std::size_t missed = 0;
    for (const Said& said : lanes_[side]) {
      const std::int64_t t = other_clock(side, said.t_ns), about = std::max(kNear_ns, tolerance_.time_for(t));
      if (t + about > seen_ns(*sides_[1 - side])) return;
      const auto near = std::ranges::lower_bound(others, t - about, {}, &Said::t_ns);
      if (near != others.end() && near->t_ns <= t + about) {
        missed = 0;
        continue;
      }
      if (++missed == 1) first = &said;
      if (missed < kMissedRow || said.t_ns - first->t_ns < kMissedTime_ns) continue;
      Difference d{Difference::Kind::time, "the line " + quoted(first->text), {}, {}, "", {}};
      d.t_ns[side] = first->t_ns;
      d.t_ns[1 - side] = other_clock(side, first->t_ns);
      d.sides[side] = "prints it repeatedly";
      d.sides[1 - side] = "does not print it for at least " + seconds(said.t_ns - first->t_ns);
      d.line[side] = first->number;
      found_.push_back(std::move(d));
      return;
    }
  }

  /// Allows a deviation of 1 in numbers with a wide range, because the last digit of a measurement varies. A
  /// number with a small range may be a state, for which no deviation is allowed.
  void find_last_places() {
    last_places_.assign(lanes_[0].front().parts.numbers.size(), 0.0);
    for (std::size_t n = 0; n < last_places_.size(); ++n) {
      double low = lanes_[0].front().parts.numbers[n].value, high = low;
      for (const auto& lane : lanes_)
        for (const Said& said : lane) {
          low = std::min(low, said.parts.numbers[n].value);
          high = std::max(high, said.parts.numbers[n].value);
        }
      if (tolerance_.number * (high - low) >= 1.0) last_places_[n] = 1.0;
    }
  }

  /// Compares each number of `side`'s lines with the other side's numbers at about the same time. Returns
  /// false if a number differs.
  bool compare_numbers(const std::string& form, std::size_t side) {
    const auto& others = lanes_[1 - side];
    for (const Said& said : lanes_[side]) {
      const std::int64_t t = other_clock(side, said.t_ns);
      const auto from = std::ranges::lower_bound(others, t - kNear_ns, {}, &Said::t_ns);
      auto to = from;
      while (to != others.end() && to->t_ns <= t + kNear_ns) ++to;
      if (from == to) continue;
      for (std::size_t n = 0; n < said.parts.numbers.size(); ++n) {
        const Number& x = said.parts.numbers[n];
        double low = from->parts.numbers[n].value, high = low;
        bool found = false;
        for (auto it = from; it != to && !found; ++it) {
          const Number& y = it->parts.numbers[n];
          found = likeness(x, y, tolerance_.number) != Likeness::different;
          low = std::min(low, y.value);
          high = std::max(high, y.value);
        }
        const double slack = std::max((high - low) / 2, last_places_[n]);
        if (found || (x.value >= low - slack && x.value <= high + slack)) continue;
        const Said& near = *std::ranges::min_element(
            from, to, {}, [&](const Said& other) { return std::abs(other.t_ns - t); });
        Difference d{Difference::Kind::number, "the line " + quoted(form), {}, {}, "", {}};
        d.t_ns[side] = said.t_ns;
        d.t_ns[1 - side] = t;
        d.sides[side] = "prints " + quoted(said.text);
        d.sides[1 - side] = "prints " + quoted(near.text) + ", and nothing closer within a second";
        d.cause = width_cause(x, near.parts.numbers[n]);
        d.line[side] = said.number;
        d.line[1 - side] = near.number;
        found_.push_back(std::move(d));
        return false;
      }
    }
    return true;
  }

  const Lanes& lanes_;
  const std::array<const History*, 2>& sides_;
  const Clocks& clocks_;
  const Tolerance& tolerance_;
  std::vector<double> last_places_;  // allowed deviation of each number
  std::vector<Difference> found_;
};

}  // namespace

bool is_stream(const std::vector<std::int64_t>& came) {
  if (came.size() > kStream) return true;
  for (std::size_t i = kStreamRow; i <= came.size(); ++i)
    if (came[i - 1] - came[i - kStreamRow] <= kStreamTime_ns) return true;
  return false;
}

std::vector<Difference> stream_differences(const std::string& form, const Lanes& lanes,
                                           const std::array<const History*, 2>& sides, const Clocks& clocks,
                                           const Tolerance& tolerance) {
  return StreamComparer(lanes, sides, clocks, tolerance).compare(form);
}

}  // namespace robosim::analysis
