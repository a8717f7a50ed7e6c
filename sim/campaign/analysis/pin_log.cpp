#include "sim/campaign/analysis/pin_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robosim::analysis {
namespace {

std::string hundredths(double value, const char* unit) {
  const auto whole = std::llround(100.0 * value);
  const std::string rest = std::to_string(whole % 100);
  return std::to_string(whole / 100) + "." + (rest.size() < 2 ? "0" : "") + rest + unit;
}

const char* word_of(bool level) { return level ? "HIGH" : "LOW"; }

std::string text_of(const wire::PinChange& change) {
  if (change.mode != "output") return change.mode == "input" ? "an input" : "an input with pull-up";
  if (change.tone_hz > 0) return "tone of " + std::to_string(change.tone_hz) + " Hz";
  if (change.pwm) return std::to_string(std::lround(100.0 * change.duty)) + " %";
  return word_of(change.level);
}

}  // namespace

bool PinLog::take(Uses& uses, PinUse use) {
  const auto known = uses.find(use.pin);
  if (known != uses.end() && use.t_ns > moment_ns_) return false;
  uses[use.pin] = std::move(use);
  return true;
}

void PinLog::add(const wire::Event& event) {
  if (const auto* level = std::get_if<wire::LevelSeen>(&event))
    take(reads_, {level->t_ns, level->pin, word_of(level->level), level->source});
  if (const auto* volts = std::get_if<wire::VoltsSeen>(&event))
    take(reads_, {volts->t_ns, volts->pin, hundredths(volts->volts, " V"), volts->source});
  if (const auto* change = std::get_if<wire::PinChange>(&event)) {
    const PinUse use{change->t_ns, change->pin, text_of(*change), change->source};
    if (take(writes_, use) && (!last_write_ || use.t_ns <= moment_ns_)) last_write_ = use;
  }
  if (const auto* byte = std::get_if<wire::SerialByte>(&event); byte && byte->sent) {
    const auto c = static_cast<char>(byte->value);
    if (c == '\n' || c == '\r') {
      if (!lines_.back().text.empty()) lines_.emplace_back();
    } else {
      lines_.back().text += c;
      lines_.back().sources.push_back(byte->source);
    }
  }
}

std::vector<PinUse> PinLog::list(const Uses& uses) {
  std::vector<PinUse> all;
  for (const auto& [pin, use] : uses) all.push_back(use);
  return all;
}

result::SourceLine PinLog::source_of(const std::string& text, std::size_t at) const {
  for (auto line = lines_.rbegin(); line != lines_.rend(); ++line)
    if (line->text == text && !line->sources.empty())
      return line->sources[std::min(at, line->sources.size() - 1)];
  return {};
}

}  // namespace robosim::analysis
