#include "sim/runner/verdict_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>

#include "hal/board/board_spec.h"
#include "sim/runner/answers.h"

namespace robosim::runner {
namespace {

using exec::CauseStep;
using Kind = exec::CauseStep::Kind;

constexpr SimTime kSampleEvery = 10 * kMillisecond;
constexpr SimTime kHistory = 30 * kMillisecond;  // shortest record before the traced time
constexpr SimTime kBlind = 20 * kMillisecond;    // shortest reported time without a read of a line sensor
constexpr SimTime kLongestGap = 500 * kMillisecond;
constexpr int kMostGoingBack = 12, kMostStepByStep = 4, kMostForRegisters = 2;
constexpr std::size_t kMostLinks = 9, kMostOfStopping = 6, kMostLines = 16, kFewLines = 10;
constexpr SimTime kStillOff = 150 * kMillisecond;  // from the motors' switch-off to the traced time
constexpr SimTime kLongBefore = 300 * kMillisecond;
constexpr double kSameCommand = 0.02;
constexpr SimTime kOffForLong = 300 * kMillisecond;
constexpr double kMuchInHandlers = 0.3;

SimTime whole_ticks(SimTime t) { return (t + kTick - 1) / kTick * kTick; }

bool is_line_sensor(const robot::WiredPin& wired) { return wired.type.starts_with("reflectance"); }

/// Returns what drives and steers wheels: pins of the wheel `side` if any, otherwise of all wheels. If no pin
/// of the board does, returns the pins of shift registers, or the bytes sent to two-wire devices.
exec::CauseFinder::Effect driving(const std::vector<robot::WiredPin>& wiring,
                                  std::optional<world::Side> side) {
  std::vector<Pin> of_side, direct, between;
  bool has_motor = false;
  for (const robot::WiredPin& wired : wiring) {
    const bool drives = wired.steers || wired.type == "motor" || wired.type == "motors" ||
                        wired.type == "wheel-servo" || wired.type == "stepper";
    has_motor |= drives;
    if (wired.pin >= kMaxPins) continue;
    if (side && wired.wheel == *side) of_side.push_back(wired.pin);
    if (drives) direct.push_back(wired.pin);
    if (wired.type == "shift-register") between.push_back(wired.pin);
  }
  if (!of_side.empty()) return {of_side};
  if (!direct.empty()) return {direct};
  return {between, has_motor && between.empty()};
}

bool is_same(const result::SourceLine& a, const result::SourceLine& b) {
  return a.file == b.file && a.line == b.line;
}

void add_line(std::vector<result::SourceLine>& lines, const result::SourceLine& line, std::size_t most) {
  const bool there = std::any_of(lines.begin(), lines.end(),
                                 [&](const result::SourceLine& one) { return is_same(one, line); });
  if (!there && lines.size() < most) lines.push_back(line);
}

/// Returns whether a function is an ISR(), by the name that avr-libc gives it.
bool is_handler(const std::string& function) { return function.starts_with("__vector_"); }

/// Returns whether a step is a variable's declaration, or happened long before `t` or while the sketch began.
bool is_before(const CauseStep& step, SimTime t) {
  const std::string& function = step.where.function;
  const bool starts_up = function == "setup" || (function.starts_with("_") && !is_handler(function));
  return step.t + kLongBefore < t || step.kind == Kind::keeps || starts_up;
}

bool is_in(const std::vector<result::Cause>& chain, const result::SourceLine& where) {
  return std::any_of(chain.begin(), chain.end(), [&](const result::Cause& cause) {
    return std::any_of(cause.lines.begin(), cause.lines.end(),
                       [&](const result::SourceLine& line) { return is_same(line, where); });
  });
}

bool is_of_library(const result::SourceLine& line) { return line.file.starts_with("libraries/"); }

exec::CauseFinder& finder_of(const run::Setup& setup) {
  exec::ChipAccess* const chip = setup.agents.front().executor->chip_access();
  exec::CauseFinder* const finder = chip ? chip->find_causes() : nullptr;
  if (finder) return *finder;
  throw InputError(
      "tracing the cause of a verdict requires a sketch on the target avr, built with its debug information");
}

}  // namespace

Inquiry::Inquiry(const run::Setup& setup, const BoardSpec& board, std::vector<robot::WiredPin> wiring)
    : setup_([&] {
        run::Setup own = setup;
        own.agents.front().listener = this;
        own.samples_every = kSampleEvery;
        return own;
      }()),
      board_(board),
      wiring_(std::move(wiring)),
      causes_(finder_of(setup)),
      simulation_(setup_) {}

// --- the run

void Inquiry::sampled(const run::Sample& sample) {
  if (!looks_again_) commands_.push_back({sample.t, sample.left, sample.right});
}

void Inquiry::level_seen(Pin pin, bool level, SimTime t) {
  if (looks_again_) return seen_[pin].insert_or_assign(t, level ? "HIGH" : "LOW"), void();
  for (const robot::WiredPin& wired : wiring_)
    if (wired.pin == pin && is_line_sensor(wired) && (looks_.empty() || t >= looks_.back() + kTick))
      looks_.push_back(t);
}

void Inquiry::volts_seen(Pin pin, double volts, SimTime t) {
  if (looks_again_)
    seen_[pin].insert_or_assign(t, fmt::format("{:.2f} V", volts));
  else
    level_seen(pin, false, t);
}

void Inquiry::run_and_save() {
  while (!simulation_.is_over()) {
    moments_.add({simulation_.now(), simulation_.save()});
    simulation_.run_until(moments_.next());
  }
}

judge::Outcome Inquiry::go() {
  run_and_save();
  judge::Outcome outcome = std::move(simulation_.end().front());
  looks_again_ = true;
  if (!outcome.decisive.text.empty()) outcome.because = chain_of(outcome.decisive);
  return outcome;
}

// --- the second run

void Inquiry::run_again(std::size_t from, SimTime until) {
  simulation_.restore(moments_[from].snapshot);
  causes_.begin();
  simulation_.run_until(until);
  causes_.end();
}

/// Saves more snapshots after snapshot number `moment`. The snapshots of a long run are too far apart to
/// record all instructions in between.
void Inquiry::save_between(std::size_t moment) {
  const SimTime end = moments_[moment + 1].t;
  simulation_.restore(moments_[moment].snapshot);
  std::vector<IndexedSnapshot> between;
  for (SimTime t = moments_[moment].t + SnapshotIndex::kEvery; t < end; t += SnapshotIndex::kEvery) {
    simulation_.run_until(t);
    between.push_back({t, simulation_.save()});
  }
  moments_.insert(moment, between);
}

/// Returns the values of bytes; all nullopt if the chip has no power.
Inquiry::Bytes Inquiry::bytes_at(std::size_t moment, const std::vector<std::uint16_t>& addresses) {
  simulation_.restore(moments_[moment].snapshot);
  Bytes values;
  for (const std::uint16_t address : addresses) values.push_back(causes_.byte(address));
  return values;
}

/// Stops following bytes that have changed within 1 s before snapshot number `from`. Following a value that
/// is written repeatedly, such as a sum, would repeat the run for each write.
void Inquiry::give_up_what_changes(std::size_t from) {
  const std::vector<std::uint16_t> open = causes_.open_bytes();
  const Bytes now = bytes_at(from, open);
  std::set<std::uint16_t> changing;
  for (std::size_t moment = from; moment-- > 0 && moments_[moment].t + kSecond >= moments_[from].t;) {
    const Bytes then = bytes_at(moment, open);
    if (!then.empty() && !then.front()) break;  // the chip had no power
    for (std::size_t i = 0; i < open.size(); ++i)
      if (then[i] != now[i]) changing.insert(open[i]);
  }
  causes_.give_up({changing.begin(), changing.end()});
}

bool Inquiry::go_back(std::size_t& from, bool for_registers) {
  const std::vector<std::uint16_t> open = causes_.open_bytes();
  const Bytes later = bytes_at(from, open);
  for (std::size_t moment = from; moment-- > 0;) {
    const Bytes earlier = bytes_at(moment, open);
    const bool adjoins = for_registers && moment + 1 == from && causes_.open_registers();
    if (earlier == later && !adjoins) continue;
    if (const std::size_t before = moments_.size();
        moments_[moment + 1].t - moments_[moment].t > SnapshotIndex::kEvery) {
      save_between(moment);
      const std::size_t more = moments_.size() - before;
      if (moment < from) from += more;
      moment += more + 1;
      continue;
    }
    run_again(moment, moments_[moment + 1].t);
    causes_.follow(moment + 1 == from);
    // Nothing that happened before the chip had power is a cause.
    const bool is_off = !earlier.empty() && !earlier.front();
    from = is_off ? 0 : moment;
    return true;
  }
  return false;
}

template <typename Ask>
Inquiry::Steps Inquiry::trace(SimTime t, SimTime until, Ask ask) {
  const SimTime began = std::max<SimTime>(0, t - kHistory);
  std::size_t from = moments_.before(began);
  if (from + 1 < moments_.size() && moments_[from + 1].t - moments_[from].t > SnapshotIndex::kEvery) {
    save_between(from);
    from = moments_.before(began);
  }
  run_again(from, until);
  ask();
  causes_.follow(true);
  bool found = true;
  for (int times = 0; found && times < kMostGoingBack; ++times) {
    if (times >= kMostStepByStep && from > 0) give_up_what_changes(from);
    found = go_back(from, times < kMostForRegisters);
  }
  if (!found) causes_.close();  // the run has been searched back to its beginning
  return causes_.steps();
}

// --- the report

std::pair<SimTime, SimTime> Inquiry::blind_around(SimTime t) const {
  const auto behind = std::upper_bound(looks_.begin(), looks_.end(), t);
  if (behind == looks_.begin()) return {t, t};
  const SimTime last = *(behind - 1), next = behind == looks_.end() ? simulation_.now() : *behind;
  return {last, std::min(next, last + kLongestGap)};
}

std::vector<result::Cause> Inquiry::chain_of(const judge::Decisive& decisive) {
  const SimTime end = simulation_.now(), t = std::min(decisive.t, end);
  std::vector<result::Cause> chain;
  if (decisive.motors) {
    const auto gap = blind_around(t);
    const SimTime last = gap.first, next = gap.second;
    const bool blind = next - last >= kBlind && looks_.size() > 1;
    const exec::CauseFinder::Effect effect = driving(wiring_, unpowered_side());
    SimTime asked = decisive.off_since == t ? std::min(t + kStillOff, end - kTick) : t;
    // The chip sends a two-wire device a command once. Pins keep it.
    if (const auto command = commands_at(asked); effect.sends_two_wire && command)
      asked = std::min(asked, command->t);
    const SimTime until = std::min(end, whole_ticks(blind ? std::max(asked, next) : asked) + kTick);
    result::SourceLine pause;
    exec::CauseFinder::Share handlers;
    const Steps steps = trace(std::min(t, asked), until, [&] {
      causes_.ask(effect, asked + kTick);
      if (blind) pause = causes_.busiest(last, std::min(next, until));
      handlers = causes_.handlers(std::max<SimTime>(0, t - kHistory), until);
    });
    chain.push_back(motors_at(t, decisive.text));
    if (handlers.of_all >= kMuchInHandlers)
      chain.push_back({seconds(t),
                       fmt::format("interrupt handlers took {:.0f} % of the time, most of it here",
                                   100 * handlers.of_all),
                       {handlers.where}});
    if (!pause.file.empty())
      chain.push_back({seconds(last),
                       fmt::format("for {}{:.0f} ms it read no line sensor, and was here",
                                   next - last >= kLongestGap ? "at least " : "", 1e3 * seconds(next - last)),
                       {pause}});
    const bool stops_later = decisive.off_since != kNever && decisive.off_since != t;
    // If nothing drives the motors, many lines contribute. The chain then has fewer lines of each file, and
    // more files.
    const SimTime moment = std::min(t, asked);
    if (decisive.off_since == t)
      add_links(steps, moment, kMostLinks + kMostOfStopping, kFewLines, chain);
    else
      add_links(steps, moment, kMostLinks, stops_later ? kFewLines : kMostLines, chain);
    if (stops_later) tell_of_stopping(std::min(decisive.off_since, end), end, chain);
  } else {
    chain.push_back({seconds(t), decisive.text, {}});
  }
  tell_of_interrupts(decisive.place ? end : t, chain);
  if (!decisive.place) return chain;
  const Steps steps = trace(end, end, [&] { causes_.ask_place(end); });
  add_links(steps, end, std::max(kMostLinks + 1, chain.size()), kMostLines, chain);
  return chain;
}

/// Returns the wheel that never got power in the run, if the other wheel did.
std::optional<world::Side> Inquiry::unpowered_side() const {
  double left = 0.0, right = 0.0;
  for (const Command& command : commands_) {
    left = std::max(left, std::abs(command.left));
    right = std::max(right, std::abs(command.right));
  }
  if (left <= robot::kSmallestPulse && right > robot::kSmallestPulse) return world::left;
  if (right <= robot::kSmallestPulse && left > robot::kSmallestPulse) return world::right;
  return std::nullopt;
}

/// Adds the reasons why the robot stopped: why the motors were switched off, and why they stayed off.
void Inquiry::tell_of_stopping(SimTime t, SimTime end, std::vector<result::Cause>& chain) {
  const SimTime asked = std::min(t + kStillOff, end - kTick);
  const Steps steps = trace(t, whole_ticks(asked) + kTick,
                            [&] { causes_.ask(driving(wiring_, unpowered_side()), asked + kTick); });
  chain.push_back(motors_at(t, judge::kMotorsStayOff));
  add_links(steps, t, chain.size() + kMostOfStopping, kFewLines, chain);
}

void Inquiry::add_links(const Steps& steps, SimTime t, std::size_t most, std::size_t lines,
                        std::vector<result::Cause>& chain) const {
  Steps news;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(news),
               [&](const CauseStep& step) { return !is_in(chain, step.where); });
  for (result::Cause& link : links_of(news, t, most - std::min(most, chain.size()), lines))
    chain.push_back(std::move(link));
}

/// Adds the line that disabled interrupts, if interrupts have been off for kOffForLong or longer.
void Inquiry::tell_of_interrupts(SimTime t, std::vector<result::Cause>& chain) {
  const auto on_at = [&](std::size_t moment) {
    simulation_.restore(moments_[moment].snapshot);
    return causes_.interrupts_on();
  };
  std::size_t off = moments_.before(t);
  if (on_at(off)) return;
  while (off > 1 && !on_at(off - 1)) --off;  // interrupts are off at power-on
  if (moments_[off].t + kOffForLong > t) return;
  const std::size_t on = off - 1, before = moments_.size();
  save_between(on);
  for (off += moments_.size() - before; off > on + 1 && !on_at(off - 1);) --off;
  const bool were_on = on_at(off - 1);
  run_again(off - 1, moments_[off].t);
  if (const std::optional<CauseStep> step = causes_.switched_off(were_on))
    chain.push_back(
        {seconds(step->t), "interrupts were disabled here, and were off at all later checks", {step->where}});
}

/// Returns the motors' commands at `t`, with the time since which they have been about the same. Returns
/// nullopt before the first sample.
std::optional<Inquiry::Command> Inquiry::commands_at(SimTime t) const {
  const auto behind = std::upper_bound(commands_.begin(), commands_.end(), t + kSampleEvery,
                                       [](SimTime at, const Command& command) { return at < command.t; });
  if (behind == commands_.begin()) return std::nullopt;
  auto since = behind - 1;
  const Command now = *since;
  while (since != commands_.begin() && std::abs((since - 1)->left - now.left) < kSameCommand &&
         std::abs((since - 1)->right - now.right) < kSameCommand)
    --since;
  return Command{since->t, now.left, now.right};
}

result::Cause Inquiry::motors_at(SimTime t, const std::string& text) const {
  const std::optional<Command> command = commands_at(t);
  if (!command) return {seconds(t), text, {}};
  const auto percent = [](double share) { return std::lround(100.0 * share); };
  return {seconds(t),
          fmt::format("{}; motors: left {} %, right {} % since {:.2f} s", text, percent(command->left),
                      percent(command->right), seconds(command->t)),
          {}};
}

std::string Inquiry::name_of(Pin pin) const {
  for (const robot::WiredPin& wired : wiring_)
    if (wired.pin == pin)
      return fmt::format("{} ({})", wired.role.starts_with(wired.part) ? wired.role : wired.part,
                         board_.pins[pin].name);
  return board_.pins[pin].name;
}

std::string Inquiry::read_at(const CauseStep& step) const {
  const std::string name = name_of(step.pin);
  const auto seen = seen_.find(step.pin);
  if (seen == seen_.end()) return name;
  const auto later = seen->second.upper_bound(step.t);
  return later == seen->second.begin() ? name : name + " " + std::prev(later)->second;
}

std::vector<result::Cause> Inquiry::links_of(const Steps& steps, SimTime t, std::size_t most,
                                             std::size_t lines) const {
  std::vector<result::Cause> links;
  result::Cause read{0.0, "read", {}}, before{0.0, result::kSetBefore, {}};
  SimTime read_at_t = 0, set_at = 0;
  std::vector<std::string> names;                // file of each link without extension: x.h counts as x.cpp
  std::vector<std::set<std::string>> functions;  // functions of each link
  std::vector<result::SourceLine> of_libraries;
  const auto reads_here = [&](const CauseStep& step) {
    return std::any_of(steps.begin(), steps.end(), [&](const CauseStep& other) {
      return other.kind == Kind::reads && is_same(other.where, step.where);
    });
  };
  for (const CauseStep& step : steps) {
    if (step.where.function.starts_with("_GLOBAL__")) continue;  // its line is the end of the file
    if (step.kind == Kind::reads) {
      read.text += (read.lines.empty() ? " " : ", ") + read_at(step);
      read_at_t = std::max(read_at_t, step.t);
      add_line(read.lines, step.where, lines);
    } else if (reads_here(step)) {
      continue;
    } else if (is_before(step, t)) {
      set_at = std::max(set_at, step.t);
      add_line(is_of_library(step.where) ? of_libraries : before.lines, step.where, kMostLines);
    } else {
      const std::string name = std::filesystem::path(step.where.file).replace_extension().string();
      const auto known = std::find(names.begin(), names.end(), name);
      const auto number = static_cast<std::size_t>(known - names.begin());
      if (known == names.end()) {
        names.push_back(name);
        links.push_back({seconds(step.t), "in", {}});
        functions.emplace_back();
      }
      const std::string& function = step.where.function;
      if (links[number].lines.size() < lines && function != "main" &&
          functions[number].insert(function).second)
        links[number].text += (functions[number].size() > 1 ? ", " : " ") +
                              (is_handler(function) ? "an interrupt handler" : function + "()");
      links[number].t_s = std::max(links[number].t_s, seconds(step.t));
      add_line(links[number].lines, step.where, lines);
    }
  }
  for (const result::SourceLine& line : of_libraries) add_line(before.lines, line, kMostLines);
  read.t_s = seconds(read_at_t);
  before.t_s = seconds(set_at);
  const std::size_t others = !read.lines.empty() + !before.lines.empty();
  if (links.size() + others > most) links.resize(most > others ? most - others : 0);
  if (!read.lines.empty()) links.push_back(std::move(read));
  if (!before.lines.empty()) links.push_back(std::move(before));
  return links;
}

}  // namespace robosim::runner
