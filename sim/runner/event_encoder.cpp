#include "sim/runner/event_encoder.h"

#include <utility>
#include <vector>

#include "sim/runner/answers.h"

namespace robosim::runner {

template <typename Event>
void EventEncoder::tell(Event event) {
  event.agent = agent_;
  tell_(std::move(event));
}

EventEncoder::EventEncoder(const wire::RunRequest& request, int agent, const BoardSpec& board,
                           exec::Executor& executor, Tell tell, EventBatcher* batcher)
    : request_(request),
      agent_(agent),
      board_(board),
      executor_(executor),
      chip_(executor.chip_access()),
      tell_(std::move(tell)),
      batcher_(wire::comes_in_batches(request) ? batcher : nullptr),
      wants_columns_(request.columns_every_ns > 0),
      wants_pins_(request.pins || (wants_columns_ && batcher_)),
      wants_inputs_(request.io || (wants_columns_ && batcher_)),
      hears_pins_(wants_pins_ || wants_columns_),
      quick_inputs_(wants_inputs_ ? batcher_ : nullptr) {
  sample_.agent = agent;
  const bool has_sources = wants_columns_ && chip_ && chip_->trace_drives();
  if (wants_pins_ && !has_sources) quick_pins_ = batcher_;
  if (!wants_columns_) return;
  if (batcher_) {
    if (has_sources) sources_.emplace();
    return;
  }
  std::vector<std::string> pins;
  for (Pin pin = 0; pin < board.pin_count; ++pin) pins.push_back(board.pins[pin].name);
  columns_.emplace(pins, has_sources);
}

void EventEncoder::began(const run::Beginning& beginning) {
  if (request_.started) tell(to_wire(beginning));
  if (columns_) columns_->begin(beginning.readings);
  if (sources_) batcher_->sources(agent_);
  if (request_.gdb_port > 0) tell_(wire::DebuggerAwaited{request_.gdb_port});
}

void EventEncoder::sampled(const run::Sample& s) {
  const SimTime every = request_.samples_every_ns;
  const bool is_told = every > 0 && (s.t % every == 0 || request_.interactive),
             is_in_columns = wants_columns_ && s.t % request_.columns_every_ns == 0;
  if (!is_told && !is_in_columns) return;
  if (batcher_) return batcher_->sample(agent_, s);
  to_wire(s, sample_);
  if (is_told) tell(sample_);
  if (!is_in_columns) return;
  columns_->add(sample_);
  if (s.t % wire::kColumnsEvery_ns == 0) flush_columns();
}

bool EventEncoder::minds_turns() const {
  return request_.serial || request_.io || wants_pins_ || wants_inputs_ || wants_columns_;
}

void EventEncoder::happened(const result::RunEvent& event) {
  if (request_.notes) tell(wire::note_of(event));
}

void EventEncoder::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  if (!hears_pins_) return;
  if (goes_on(quick_pins_, agent_, t, pin))
    return quick_pins_->pin(agent_, t, pin, board_.pins[pin].name, drive, 0);
  change_pin(pin, drive, t);
}

void EventEncoder::change_pin(Pin pin, const PinDrive& drive, SimTime t) {
  if (columns_)
    columns_->add_pin(pin, t,
                      wire::pin_level(drive.mode == PinMode::output, drive.mode == PinMode::input_pullup,
                                      drive.pwm, drive.duty, drive.tone_hz),
                      drive.duty, drive.tone_hz, &driving(pin, drive));
  if (!wants_pins_) return;
  if (batcher_) return batcher_->pin(agent_, t, pin, board_.pins[pin].name, drive, source_of(pin, drive));
  tell_pin(pin, drive, t);
}

void EventEncoder::tell_pin(Pin pin, const PinDrive& drive, SimTime t) {
  static constexpr const char* kModes[] = {"input", "input_pullup", "output"};
  detail(wire::PinChange{t,
                         board_.pins[pin].name,
                         kModes[static_cast<int>(drive.mode)],
                         drive.level,
                         drive.pwm,
                         drive.duty,
                         drive.tone_hz,
                         {}});
}

void EventEncoder::level_seen(Pin pin, bool level, SimTime t) {
  if (batcher_ && wants_inputs_) return batcher_->level(agent_, t, pin, board_.pins[pin].name, level);
  tell_level(pin, level, t);
}

void EventEncoder::tell_level(Pin pin, bool level, SimTime t) {
  if (columns_)
    columns_->add_pin(pin, t, level ? wire::PinLevel::high : wire::PinLevel::low, level ? 1.0 : 0.0, 0);
  if (wants_inputs_) detail(wire::LevelSeen{t, board_.pins[pin].name, level, {}});
}

void EventEncoder::volts_seen(Pin pin, double volts, SimTime t) {
  if (goes_on(quick_inputs_, agent_, t, pin))
    return quick_inputs_->volts(agent_, t, pin, board_.pins[pin].name, volts);
  see_volts(pin, volts, t);
}

void EventEncoder::see_volts(Pin pin, double volts, SimTime t) {
  if (batcher_ && wants_inputs_) return batcher_->volts(agent_, t, pin, board_.pins[pin].name, volts);
  tell_volts(pin, volts, t);
}

void EventEncoder::tell_volts(Pin pin, double volts, SimTime t) {
  if (columns_) columns_->add_volts(pin, t, volts);
  if (wants_inputs_) detail(wire::VoltsSeen{t, board_.pins[pin].name, volts, {}});
}

void EventEncoder::byte_received(std::uint8_t byte, SimTime t) {
  if (request_.io) detail(wire::SerialByte{t, byte, false, {}});
}

void EventEncoder::byte_sent(std::uint8_t byte, SimTime t) {
  if (request_.io) {
    wire::SerialByte event{t, byte, true, {}};
    if (request_.source_ns) event.source = chip_ ? chip_->source_of(byte) : executor_.source();
    if (!request_.source_ns || in_span(t)) tell(std::move(event));
  }
  if (!request_.serial) return;
  line_ += static_cast<char>(byte);
  if (byte == '\n' || line_.size() >= 256) flush_serial(t);
}

const exec::SourceLine& EventEncoder::driving(Pin pin, const PinDrive& drive) const {
  static const exec::SourceLine unknown;
  return chip_ ? chip_->driving(pin, drive) : unknown;
}

int EventEncoder::number_of_source(Pin pin, const PinDrive& drive) {
  const int number = sources_->of(driving(pin, drive));
  for (const result::SourceLine& line : sources_->take_new()) batcher_->source(agent_, line);
  return number;
}

void EventEncoder::flush_serial(SimTime t) {
  if (!line_.empty()) tell(wire::SerialText{t, line_});
  line_.clear();
}

void EventEncoder::flush_columns() {
  if (!columns_) return;
  wire::Columns columns = columns_->take();
  if (!columns.streams.empty()) tell(std::move(columns));
}

bool EventEncoder::in_span(SimTime t) const {
  return t >= request_.source_ns->first && t < request_.source_ns->second;
}

template <typename Event>
void EventEncoder::detail(Event event) {
  if (request_.source_ns) {
    if (!in_span(event.t_ns)) return;
    event.source = executor_.source();
  }
  tell(std::move(event));
}

}  // namespace robosim::runner
