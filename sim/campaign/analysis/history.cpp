#include "sim/campaign/analysis/history.h"

#include <cmath>
#include <utility>

namespace robosim::analysis {
namespace {

constexpr double kDriven = 0.02;  // smallest share of the full command that counts as driving

// At the end of a run, an unfinished line that is older than this is a prompt. A newer one was cut off.
constexpr std::int64_t kSilence_ns = 100'000'000;

bool ends_line(char c) { return c == '\n' || c == '\r'; }

}  // namespace

Manoeuvre manoeuvre_of(double left, double right) {
  const double mean = (left + right) / 2, half_difference = (right - left) / 2;
  if (std::fabs(left) < kDriven && std::fabs(right) < kDriven) return Manoeuvre::stands;
  if (2.0 * std::fabs(mean) < std::fabs(half_difference))
    return half_difference > 0.0 ? Manoeuvre::turns_left : Manoeuvre::turns_right;
  return mean > 0.0 ? Manoeuvre::ahead : Manoeuvre::back;
}

const char* name_of(Manoeuvre manoeuvre) {
  switch (manoeuvre) {
    case Manoeuvre::stands:
      return "stands";
    case Manoeuvre::ahead:
      return "drives ahead";
    case Manoeuvre::back:
      return "drives back";
    case Manoeuvre::turns_left:
      return "turns left on the spot";
    case Manoeuvre::turns_right:
      return "turns right on the spot";
  }
  return "";
}

HistoryRecorder::HistoryRecorder(std::string target, PlaceFinder place) : place_(std::move(place)) {
  history_.target = std::move(target);
}

void HistoryRecorder::visit(std::int64_t t_ns, std::string place) {
  if (place.empty() || (!history_.places.empty() && history_.places.back().text == place)) return;
  history_.places.push_back({t_ns, std::move(place)});
}

void HistoryRecorder::add(const wire::Sample& sample) {
  const std::int64_t t_ns = sample.t_us * 1000;
  const Manoeuvre now = manoeuvre_of(sample.left, sample.right);
  auto& stretches = history_.stretches;
  // A sample contains the motor commands of the previous tick, so they apply from the previous sample on.
  if (stretches.empty() || stretches.back().manoeuvre != now) stretches.push_back({last_ns_, last_ns_, now});
  Stretch& stretch = stretches.back();
  const double before = static_cast<double>(stretch.duration_ns()),
               added = static_cast<double>(t_ns - last_ns_);
  if (before + added > 0.0) {
    stretch.left = (stretch.left * before + sample.left * added) / (before + added);
    stretch.right = (stretch.right * before + sample.right * added) / (before + added);
  }
  stretch.to_ns = t_ns;
  last_ns_ = t_ns;
  if (!place_) return;
  std::string place = place_(sample);
  if (place == kOffTheLine) history_.lost_ns = t_ns;
  visit(t_ns, std::move(place));
}

void HistoryRecorder::add(const wire::SerialText& serial) {
  for (const char c : serial.text) {
    if (ends_line(c)) {
      line_open_ = false;
      continue;
    }
    if (!line_open_) history_.lines.push_back({serial.t_ns, ""});
    line_open_ = true;
    history_.lines.back().text += c;
    history_.lines.back().t_ns = serial.t_ns;
  }
}

void HistoryRecorder::add(const wire::Event& event) {
  if (history_.lost_ns) return;
  if (const auto* sample = std::get_if<wire::Sample>(&event)) add(*sample);
  if (const auto* serial = std::get_if<wire::SerialText>(&event)) add(*serial);
  if (const auto* note = std::get_if<wire::Note>(&event)) {
    if (const auto* lap = note->is<result::LapDone>()) visit(note->t_ns, "lap " + std::to_string(lap->lap));
    if (note->is<result::CollisionBegan>()) visit(note->t_ns, "a collision");
  }
}

History HistoryRecorder::finish(const result::RunResult& result) {
  history_.verdict = result.verdict;
  history_.why = result.why;
  history_.end_ns = static_cast<std::int64_t>(std::llround(result.time_s * 1e9));
  if (line_open_ && history_.end_ns - history_.lines.back().t_ns < kSilence_ns) history_.lines.pop_back();
  return std::move(history_);
}

}  // namespace robosim::analysis
