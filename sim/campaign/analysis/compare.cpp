#include "sim/campaign/analysis/compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim/campaign/analysis/alignment.h"
#include "sim/campaign/analysis/compare_motors.h"
#include "sim/campaign/analysis/compare_streams.h"

namespace robosim::analysis {
namespace {

constexpr std::int64_t kSlipping_ns = kSecond_ns;  // this period before a loss of the line is not compared

std::string came_to(const TimedText& place) {
  return place.text == kOffTheLine ? "leaves the line" : "comes to " + place.text;
}

/// Returns the history up to `until`.
History up_to(std::int64_t until, History history) {
  const auto later = [&](const TimedText& text) { return text.t_ns > until; };
  std::erase_if(history.places, later);
  std::erase_if(history.lines, later);
  std::erase_if(history.stretches, [&](const Stretch& stretch) { return stretch.from_ns > until; });
  for (Stretch& stretch : history.stretches) stretch.to_ns = std::min(stretch.to_ns, until);
  history.lost_ns = until;
  return history;
}

/// Returns whether the robot lost the line, and the run ended as lost, stuck or timeout.
bool is_astray(const History& history) {
  return history.lost_ns &&
         (history.verdict == "lost" || history.verdict == "stuck" || history.verdict == "timeout");
}

class Comparer {
 public:
  Comparer(const History& a, const History& b, const Tolerance& tolerance)
      : sides_{&a, &b}, tolerance_(tolerance) {}

  Comparison compare() {
    split_lines();
    compare_places();
    compare_lines();
    clocks_.finish();
    compare_streams();
    for (std::size_t side = 0; side < 2; ++side)
      if (auto difference = missing_manoeuvre(sides_, side, clocks_)) report(std::move(*difference));
    if (auto difference = speed_difference(sides_, clocks_)) report(std::move(*difference));
    compare_verdicts();
    return std::move(result_);
  }

 private:
  void report(Difference difference) {
    if (!result_.first || difference.first_ns() < result_.first->first_ns())
      result_.first = std::move(difference);
  }
  void know(KnownDifference known) {
    if (std::find(result_.known.begin(), result_.known.end(), known) == result_.known.end())
      result_.known.push_back(std::move(known));
  }

  void split_lines() {
    Lanes all;
    std::map<std::string, std::array<std::vector<std::int64_t>, 2>> times;
    for (std::size_t side = 0; side < 2; ++side)
      for (const TimedText& text : sides_[side]->lines) {
        all[side].push_back({text.t_ns, text.text, take_apart(text.text), all[side].size()});
        times[all[side].back().parts.form][side].push_back(text.t_ns);
      }
    for (std::size_t side = 0; side < 2; ++side)
      for (Said& said : all[side]) {
        const auto& came = times[said.parts.form];
        if (is_stream(came[0]) || is_stream(came[1]))
          streams_[said.parts.form][side].push_back(std::move(said));
        else
          said_[side].push_back(std::move(said));
      }
  }

  /// Returns whether side `other` ran long enough to show an event. On this side, the last event that both
  /// sides share was at `since_ns`. The event is due `after_ns` later.
  bool had_time(std::size_t other, std::int64_t since_ns, std::int64_t after_ns) const {
    return seen_ns(*sides_[other]) >= since_ns + after_ns + tolerance_.time_for(after_ns);
  }

  /// Compares two lists of places or lines whose first `common` elements match. Reports a difference if only
  /// one of the lists has a further element.
  template <typename Marks, typename Make>
  void compare_rest(const Marks& a, const Marks& b, std::size_t common, const Make& make) {
    if (a.size() == b.size()) return;
    const std::size_t more = a.size() > b.size() ? 0 : 1, other = 1 - more;
    const Marks& longer = more == 0 ? a : b;
    const Marks& shorter = more == 0 ? b : a;
    const std::int64_t since = common > 0 ? longer[common - 1].t_ns : 0;
    const std::int64_t since_other = common > 0 ? shorter[common - 1].t_ns : 0;
    const std::int64_t after = longer[common].t_ns - since;
    if (!had_time(other, since_other, after)) return;
    Difference d = make(common);
    d.t_ns[more] = longer[common].t_ns;
    d.t_ns[other] = since_other + after;
    report(std::move(d));
  }

  /// Compares the times from the previous place or line to this one. If they differ too much, reports the
  /// difference and returns false.
  bool same_time(const std::array<std::int64_t, 2>& t, const std::array<std::int64_t, 2>& before,
                 const std::string& what, std::array<std::optional<std::size_t>, 2> line,
                 std::array<std::optional<std::size_t>, 2> place = {}) {
    const std::int64_t a = t[0] - before[0], b = t[1] - before[1];
    if (std::abs(a - b) <= tolerance_.time_for(std::max(a, b))) return true;
    const std::string since = before[0] + before[1] > 0 ? " after the previous one" : " after the start";
    Difference d{Difference::Kind::time,
                 what,
                 t,
                 {"comes " + seconds(a) + since, "comes " + seconds(b) + since},
                 "",
                 line,
                 place};
    report(std::move(d));
    return false;
  }

  void compare_places() {
    const auto& a = sides_[0]->places;
    const auto& b = sides_[1]->places;
    std::array<std::int64_t, 2> before{};
    std::size_t i = 0;
    for (; i < a.size() && i < b.size(); ++i) {
      const std::array<std::int64_t, 2> t{a[i].t_ns, b[i].t_ns};
      const std::string from = i > 0 ? "the way after " + a[i - 1].text : "the way from the start";
      if (a[i].text != b[i].text)
        return report({Difference::Kind::place, from, t, {came_to(a[i]), came_to(b[i])}, "", {}, {i, i}});
      if (!same_time(t, before, a[i].text + ", " + from, {}, {i, i})) return;
      clocks_.add(t[0], t[1]);
      before = t;
    }
    compare_rest(a, b, i, [&](std::size_t at) {
      const bool first = a.size() > b.size();
      const auto& longer = first ? a : b;
      Difference d{Difference::Kind::place,
                   "the way after " + (at > 0 ? longer[at - 1].text : "the start"),
                   {},
                   {},
                   "",
                   {}};
      d.sides[first ? 0 : 1] = came_to(longer[at]);
      d.sides[first ? 1 : 0] = "reaches no other place";
      d.place[first ? 0 : 1] = at;
      return d;
    });
  }

  void compare_lines() {
    const auto& a = said_[0];
    const auto& b = said_[1];
    std::array<std::int64_t, 2> before{};
    std::size_t i = 0;
    for (; i < a.size() && i < b.size(); ++i) {
      const std::array<std::int64_t, 2> t{a[i].t_ns, b[i].t_ns};
      const std::array<std::optional<std::size_t>, 2> line{a[i].number, b[i].number};
      const std::string what = "line " + std::to_string(a[i].number + 1) + " of the serial port";
      if (a[i].parts.form != b[i].parts.form)
        return report({Difference::Kind::line,
                       what,
                       t,
                       {"prints " + quoted(a[i].text), "prints " + quoted(b[i].text)},
                       "",
                       line});
      if (!same_numbers(a[i], b[i], what, line)) return;
      if (!same_time(t, before, what + ", " + quoted(a[i].text), line)) return;
      clocks_.add(t[0], t[1]);
      before = t;
    }
    compare_rest(a, b, i, [&](std::size_t at) {
      const bool first = a.size() > b.size();
      const Said& said = (first ? a : b)[at];
      Difference d{Difference::Kind::line,
                   "line " + std::to_string(said.number + 1) + " of the serial port",
                   {},
                   {},
                   "",
                   {}};
      d.sides[first ? 0 : 1] = "prints " + quoted(said.text);
      d.sides[first ? 1 : 0] = "prints nothing";
      d.line[first ? 0 : 1] = said.number;
      return d;
    });
  }

  bool same_numbers(const Said& a, const Said& b, const std::string& what,
                    const std::array<std::optional<std::size_t>, 2>& line) {
    for (std::size_t n = 0; n < a.parts.numbers.size(); ++n) {
      const Number& x = a.parts.numbers[n];
      const Number& y = b.parts.numbers[n];
      const Likeness alike = likeness(x, y, tolerance_.number);
      if (alike == Likeness::known) know({known_cause(x, y), {a.text, b.text}});
      if (alike != Likeness::different) continue;
      report({Difference::Kind::number,
              what,
              {a.t_ns, b.t_ns},
              {"prints " + quoted(a.text), "prints " + quoted(b.text)},
              width_cause(x, y),
              line});
      return false;
    }
    return true;
  }

  void compare_streams() {
    for (const auto& [form, lanes] : streams_)
      for (Difference& difference : stream_differences(form, lanes, sides_, clocks_, tolerance_))
        report(std::move(difference));
  }

  void compare_verdicts() {
    const History& a = *sides_[0];
    const History& b = *sides_[1];
    if (a.verdict == b.verdict || (is_astray(a) && is_astray(b))) return;
    const auto text = [](const History& h) { return h.verdict + ": " + h.why; };
    const bool first = a.end_ns <= b.end_ns;
    const std::array<std::int64_t, 2> t{first ? a.end_ns : clocks_.to_a(b.end_ns),
                                        first ? clocks_.to_b(a.end_ns) : b.end_ns};
    report({Difference::Kind::verdict, "the verdict", t, {text(a), text(b)}, "", {}});
  }

  std::array<const History*, 2> sides_;
  Tolerance tolerance_;
  Lanes said_;
  std::map<std::string, Lanes> streams_;
  Clocks clocks_;
  Comparison result_;
};

}  // namespace

Comparison compare(const History& a, const History& b, const Tolerance& tolerance) {
  if (!a.lost_ns || !b.lost_ns) return Comparer(a, b, tolerance).compare();
  const std::int64_t until = std::min(*a.lost_ns, *b.lost_ns) - kSlipping_ns;
  const History first = up_to(until, a), second = up_to(until, b);
  return Comparer(first, second, tolerance).compare();
}

const char* name_of(Difference::Kind kind) {
  switch (kind) {
    case Difference::Kind::place:
      return "place";
    case Difference::Kind::line:
      return "line";
    case Difference::Kind::number:
      return "number";
    case Difference::Kind::time:
      return "time";
    case Difference::Kind::motors:
      return "motors";
    case Difference::Kind::speed:
      return "speed";
    case Difference::Kind::verdict:
      return "verdict";
  }
  return "";
}

}  // namespace robosim::analysis
