#include "robosim/testing/matchers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <regex>

#include "sim/testing/run_log.h"

namespace robosim::testing {
namespace {

constexpr double kMoved_mm = 10.0;  // shorter movements do not count as driving
constexpr double kBackwards_mm_s = 5.0;

using Finding = Requirement::Finding;

std::string list(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::vector<std::string> as_names(std::initializer_list<int> numbers) {
  std::vector<std::string> names;
  for (const int number : numbers) names.push_back(std::to_string(number));
  return names;
}

/// Returns the name that the map gives to a station. `station` is a name or a number.
std::string name_of(const RunLog& log, const std::string& station) {
  for (const auto& known : log.started.stations)
    if (known.name == station || std::to_string(known.id) == station) return known.name;
  return station;
}

bool moved(const Moment& a, const Moment& b) {
  return a.pose.x_mm != b.pose.x_mm || a.pose.y_mm != b.pose.y_mm || a.pose.yaw_rad != b.pose.yaw_rad;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 200;
  return text.size() > kMost ? "… " + in_quotes(text.substr(text.size() - kMost)) : in_quotes(text);
}

/// Returns the moment at which the robot stopped for good, or the end of the drive if the robot still moves.
Moment last_movement(const std::vector<Moment>& moments) {
  Moment last = moments.front();
  for (std::size_t i = 1; i < moments.size(); ++i)
    if (moved(moments[i - 1], moments[i])) last = moments[i];
  return last;
}

}  // namespace

bool Requirement::MatchAndExplain(const Drive& drive, std::ostream* out) const {
  const Finding finding = look_(drive);
  if (!out) return finding.holds;
  if (!finding.sentence.empty()) *out << "\n  " << finding.sentence;
  *out << drive.epilogue(finding.holds ? drive.end() : std::max(finding.when, drive.begin()));
  return finding.holds;
}

void Requirement::DescribeTo(std::ostream* out) const { *out << holds_; }
void Requirement::DescribeNegationTo(std::ostream* out) const { *out << fails_; }

Requirement Follows(Line, Within<Length> within) {
  const std::string clause = fmt::format("the line within {:g} mm", within.most.mm);
  return Requirement("follows " + clause, "does not follow " + clause, [=](const Drive& drive) -> Finding {
    const Moment worst = drive.worst();
    if (drive.distance().mm < kMoved_mm)
      return {false,
              fmt::format("it drove {:.0f} mm in total and stands at {}", drive.distance().mm,
                          place_of(worst.pose)),
              drive.end()};
    const std::string sentence =
        fmt::format("at {} it was {:.1f} mm off the line, at {}, driving at {:.0f} mm/s", seconds(worst.t),
                    worst.cross_track.mm, place_of(worst.pose), worst.speed.mm_per_s);
    return {worst.cross_track.mm <= within.most.mm, sentence, worst.t};
  });
}

Requirement Visits(std::vector<std::string> stations) {
  const std::string clause = "stations " + list(stations);
  return Requirement("visits " + clause, "does not visit " + clause, [=](const Drive& drive) -> Finding {
    const std::vector<std::string> came = drive.stations();
    std::vector<std::string> missed;
    for (const std::string& station : stations) {
      const std::string name = name_of(drive.log(), station);
      if (std::find(came.begin(), came.end(), name) == came.end()) missed.push_back(station);
    }
    if (missed.empty()) return {true, "it came to " + list(came), drive.end()};
    return {false,
            fmt::format("it did not come to {} before {}; it came to {}", list(missed), seconds(drive.end()),
                        list(came)),
            drive.end()};
  });
}

Requirement Visits(std::initializer_list<int> stations) { return Visits(as_names(stations)); }

Requirement VisitsInOrder(std::initializer_list<int> numbers) {
  const std::vector<std::string> stations = as_names(numbers);
  const std::string clause = "stations " + list(stations) + " in this order";
  return Requirement("visits " + clause, "does not visit " + clause, [=](const Drive& drive) -> Finding {
    std::vector<std::string> wanted;
    for (const std::string& station : stations) wanted.push_back(name_of(drive.log(), station));
    const std::vector<std::string> came = drive.stations();
    return {came == wanted, "it came to " + list(came), drive.end()};
  });
}

Requirement StopsWithin(Duration time) {
  const std::string clause = "within " + seconds(time);
  return Requirement("stops " + clause, "does not stop " + clause, [=](const Drive& drive) -> Finding {
    const Moment last = last_movement(drive.moments());
    const Duration took = last.t - drive.begin();
    return {took <= time,
            fmt::format("it still moved {} later, at {}, at {:.0f} mm/s", seconds(took), place_of(last.pose),
                        last.speed.mm_per_s),
            last.t};
  });
}

Requirement StopsWithin(Length way) {
  const std::string clause = fmt::format("within {:g} mm", way.mm);
  return Requirement("stops " + clause, "does not stop " + clause, [=](const Drive& drive) -> Finding {
    const std::vector<Moment> moments = drive.moments();
    const bool stands = moments.size() < 2 || !moved(moments[moments.size() - 2], moments.back());
    return {
        stands && drive.distance().mm <= way.mm,
        fmt::format("it moved on for {:.0f} mm, to {}{}", drive.distance().mm, place_of(moments.back().pose),
                    stands ? ", and stopped there" : ", and was still moving"),
        drive.end()};
  });
}

Doing at_all() {
  return {"at all", [](const Moment&, const Moment& now) { return now.left != 0.0 || now.right != 0.0; }};
}

Doing backwards() {
  return {"backwards",
          [](const Moment&, const Moment& now) { return now.speed.mm_per_s < -kBackwards_mm_s; }};
}

Doing off_the_line() {
  return {"with no sensor over a line", [](const Moment& before, const Moment& now) {
            return now.off_line && (moved(before, now) || now.left != 0.0 || now.right != 0.0);
          }};
}

Doing faster_than(Speed speed) {
  return {fmt::format("faster than {:g} mm/s", speed.mm_per_s),
          [=](const Moment&, const Moment& now) { return std::abs(now.speed.mm_per_s) > speed.mm_per_s; }};
}

Doing onto(int column, int row) {
  return {fmt::format("onto column {}, row {}", column, row),
          [=](const Moment&, const Moment& now) { return now.pose.column == column && now.pose.row == row; }};
}

Requirement NeverDrives(Doing what) {
  return Requirement("never drives " + what.clause, "drives " + what.clause,
                     [=](const Drive& drive) -> Finding {
                       Moment before;
                       bool first = true;
                       for (const Moment& now : drive.moments()) {
                         if (!first && what.is(before, now))
                           return {false,
                                   fmt::format("at {} it drove {}, at {}, at {:.0f} mm/s", seconds(now.t),
                                               what.clause, place_of(now.pose), now.speed.mm_per_s),
                                   now.t};
                         before = now;
                         first = false;
                       }
                       return {true, "it never did", drive.end()};
                     });
}

Requirement NeverCollides() {
  return Requirement("never collides", "collides", [](const Drive& drive) -> Finding {
    if (drive.collisions() == 0) return {true, "it collided with nothing", drive.end()};
    for (const RunLog::Entry& entry : drive.log().events) {
      if (entry.t_ns <= drive.begin().count() || !entry.collision) continue;
      const Duration t(entry.t_ns);
      Moment there = drive.moments().front();
      for (const Moment& moment : drive.moments())
        if (moment.t <= t) there = moment;
      return {false,
              fmt::format(
                  "at {} it hit a wall, an obstacle, a robot or the map's edge, at {}; {} time{} in total",
                  seconds(t), place_of(there.pose), drive.collisions(), drive.collisions() == 1 ? "" : "s"),
              t};
    }
    return {false, fmt::format("it collided {} times", drive.collisions()), drive.end()};
  });
}

Requirement SerialSays(std::string text) {
  const std::string clause = in_quotes(text);
  return Requirement("says " + clause, "does not say " + clause, [=](const Drive& drive) -> Finding {
    const std::string said = drive.serial();
    if (said.find(text) != std::string::npos) return {true, "it said this text", drive.end()};
    return {false, said.empty() ? std::string("it said nothing") : "it said " + shortened(said), drive.end()};
  });
}

// Limits the length of a line, since std::regex uses stack for each character. serial_matches() has the same
// limit.
constexpr std::size_t kLongestLine = 1000;

Requirement SerialMatches(std::string regex) {
  const std::string clause = "a line that matches /" + regex + "/";
  return Requirement("says " + clause, "does not say " + clause,
                     [=, pattern = std::regex(regex)](const Drive& drive) -> Finding {
                       const std::string said = drive.serial();
                       for (std::size_t begin = 0; begin < said.size();) {
                         const std::size_t end = std::min(said.find('\n', begin), said.size());
                         std::string line = said.substr(begin, std::min(end - begin, kLongestLine));
                         if (!line.empty() && line.back() == '\r') line.pop_back();
                         if (std::regex_search(line, pattern))
                           return {true, "it said " + in_quotes(line), drive.end()};
                         begin = end + 1;
                       }
                       return {false,
                               said.empty() ? std::string("it said nothing") : "it said " + shortened(said),
                               drive.end()};
                     });
}

namespace {

template <class Fits>
Finding scored(const Drive& drive, Fits fits) {
  const std::optional<Score> score = drive.score();
  if (!score)
    return {false,
            drive.verdict().empty()
                ? "the run goes on"
                : fmt::format("the goal of this run, {}, gave it no score", drive.log().started.goal),
            drive.end()};
  std::string text = fmt::format("it scored {:g} {}", score->value, score->unit);
  for (const Score::Part& part : score->parts) text += fmt::format(", {} of {}", part.what, part.count);
  return {fits(score->value), text, drive.end()};
}

}  // namespace

Requirement EndsAs(std::string verdict) {
  return Requirement(
      "ends as " + in_quotes(verdict), "does not end as " + in_quotes(verdict),
      [=](const Drive& drive) -> Finding {
        const std::string found = drive.verdict();
        return {found == verdict,
                found.empty() ? "the run goes on"
                              : fmt::format("it ended as {} at {}", in_quotes(found), seconds(drive.end())),
                drive.end()};
      });
}

Requirement ScoresAtLeast(double value) {
  return Requirement(fmt::format("scores at least {:g}", value), fmt::format("scores less than {:g}", value),
                     [=](const Drive& drive) { return scored(drive, [=](double s) { return s >= value; }); });
}

Requirement ScoresAtMost(double value) {
  return Requirement(fmt::format("scores at most {:g}", value), fmt::format("scores more than {:g}", value),
                     [=](const Drive& drive) { return scored(drive, [=](double s) { return s <= value; }); });
}

Requirement Reaches(std::string goal) {
  return Requirement("reaches " + goal, "does not reach " + goal, [=](const Drive& drive) -> Finding {
    const RunLog& log = drive.log();
    const std::string found = drive.verdict();
    if (log.started.goal != goal)
      return {false,
              fmt::format("the goal of this run is {}: set .goal = {} in its Trial", log.started.goal,
                          in_quotes(goal)),
              drive.end()};
    return {found == "reached",
            found == "reached" ? fmt::format("it did, after {}", seconds(drive.end()))
                               : fmt::format("the goal was not reached before {}", seconds(drive.end())),
            drive.end()};
  });
}

Requirement UsesAtMost(std::initializer_list<Limit> list_of_limits) {
  const std::vector<Limit> limits(list_of_limits);
  static constexpr const char* kNames[] = {"flash", "RAM for variables", "stack",
                                           "time for a pass of loop()"};
  const auto amount = [](const Limit& limit, std::int64_t value) {
    return limit.of == Limit::Of::loop_time ? fmt::format("{:.3f} ms", static_cast<double>(value) * 1e-6)
                                            : fmt::format("{} bytes", value);
  };
  std::string clause;
  for (const Limit& limit : limits)
    clause += fmt::format("{}{} of {}", clause.empty() ? "" : ", ", amount(limit, limit.most),
                          kNames[static_cast<int>(limit.of)]);
  return Requirement("uses at most " + clause, "uses more than " + clause,
                     [=](const Drive& drive) -> Finding {
                       const auto used = drive.usage();
                       if (!used)
                         return {false, "the target host has no chip: run this test on avr", drive.end()};
                       const std::int64_t values[] = {used->flash_bytes, used->ram_bytes, used->stack_bytes,
                                                      used->longest_loop.count()};
                       std::string over;
                       for (const Limit& limit : limits) {
                         const std::int64_t value = values[static_cast<int>(limit.of)];
                         if (value > limit.most)
                           over += fmt::format("{}it uses {} of {}", over.empty() ? "" : ", ",
                                               amount(limit, value), kNames[static_cast<int>(limit.of)]);
                       }
                       return {over.empty(), over.empty() ? "it does not use more" : over, drive.end()};
                     });
}

}  // namespace robosim::testing
