#include "sim/exec/stm32/stm32_executor.h"

#include <algorithm>

#include "sim/exec/stm32/debug_port.h"
#include "sim/exec/stm32/diagnosis.h"

namespace robosim::exec {

struct Stm32Executor::Image {
  Image(const std::filesystem::path& file, const BoardSpec& spec)
      : firmware(stm32::Firmware::read(file, spec)), debug(file), loop(debug.entry_of("loop")) {
    if (const Symbol* symbol = firmware.symbols.find("loop"); !loop && symbol) loop = symbol->address;
  }

  stm32::Firmware firmware;
  DebugInfo debug;
  std::optional<std::uint32_t> loop;
};

Stm32Executor::Stm32Executor(const BoardSpec& spec, const std::filesystem::path& image)
    : board_(spec),
      image_(std::make_unique<Image>(image, spec)),
      eeprom_pages_(robosim::stm32::kEepromPages * robosim::stm32::kPageBytes, 0xFF) {}

Stm32Executor::~Stm32Executor() = default;

void Stm32Executor::power_on(SimTime t) {
  power_off(t);
  machine_ = std::make_unique<stm32::Machine>(image_->firmware, image_->loop, clocked_, eeprom_pages_,
                                              clocked_.begin_tick(t));
  if (clock_start_ > 0) machine_->set_clock(clock_start_);
  if (debug_port_) machine_->set_debug_port(debug_port_.get());
  if (written_) {
    // The jump that led out of the sketch, as a function's last call leaves no trace on the stack.
    written_->begin([this](const SourceLine& before) {
      const stm32::Diagnosis diagnosis(image_->firmware, image_->debug, *machine_);
      SourceLine line = diagnosis.place_of(machine_->cpu().last_jumps());
      if (line.file.empty()) line = before;
      return line.file.empty() ? diagnosis.place_of(machine_->open_calls()) : line;
    });
    machine_->trace_bytes(*written_);
  }
}

void Stm32Executor::power_off(SimTime t) {
  before_ = resources();
  if (debug_port_) debug_port_->unplug();
  machine_.reset();
  crash_.reset();
  board_.reset(t);
  reached_ = t;
}

void Stm32Executor::run_until(SimTime t) {
  if (!machine_ || crash_) return;
  machine_->run_until(clocked_.begin_tick(t));
  reached_ = t;
  if (const auto& fault = machine_->cpu().fault())
    crash_ = stm32::Diagnosis(image_->firmware, image_->debug, *machine_).crash(*fault);
  board_.forget_edges(t);
}

SimTime Stm32Executor::last_call() const {
  if (!machine_) return reached_;
  return machine_->cpu().is_asleep() ? reached_
                                     : clocked_.to_world(machine_->time_of(machine_->cpu().last_io()));
}

std::optional<Resources> Stm32Executor::resources() const {
  if (!machine_) return before_;
  Resources r = machine_->resources();
  if (before_) {
    r.stack_bytes_max = std::max(r.stack_bytes_max, before_->stack_bytes_max);
    r.loop_us_max = std::max(r.loop_us_max, before_->loop_us_max);
  }
  return r;
}

void Stm32Executor::set_clock_start(SimTime start) {
  if (!image_->firmware.symbols.find("robosim_millis") || !image_->firmware.symbols.find("main"))
    throw InputError({image_->firmware.file},
                     "has no clock that --clock could set (it is not built with Robosim's core)");
  clock_start_ = start;
}

void Stm32Executor::debug_with(gdb::Server& server) {
  debug_port_ = std::make_unique<stm32::DebugPort>(server, image_->firmware, clocked_);
}

SourceLine Stm32Executor::source() {
  return machine_ ? stm32::Diagnosis(image_->firmware, image_->debug, *machine_).where_now() : SourceLine{};
}

SourceLine Stm32Executor::source_of(std::uint8_t byte) {
  return written_ ? written_->take(byte) : SourceLine{};
}

Activity Stm32Executor::activity() {
  if (!machine_) {
    Activity activity;
    activity.last_call = reached_;
    return activity;
  }
  Activity activity = stm32::Diagnosis(image_->firmware, image_->debug, *machine_).activity();
  activity.last_call = clocked_.to_world(activity.last_call);
  if (crash_) activity.where = crash_->where;
  return activity;
}

}  // namespace robosim::exec
