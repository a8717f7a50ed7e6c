#include "sim/exec/avr/avr_executor.h"

#include <algorithm>

#include "sim/exec/avr/debug_port.h"
#include "sim/exec/avr/diagnosis.h"

namespace robosim::exec {

struct AvrExecutor::Image {
  Image(const std::filesystem::path& file, const BoardSpec& spec)
      : firmware(avr::Firmware::read(file, spec)), debug(file), loop(debug.entry_of("loop")) {
    if (!loop) loop = firmware.find("loop");
    if (loop) loop = firmware.loop_head(*loop);
  }

  avr::Firmware firmware;
  DebugInfo debug;
  std::optional<std::uint32_t> loop;
};

AvrExecutor::AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image)
    : board_(spec), image_(std::make_unique<Image>(image, spec)) {}

AvrExecutor::~AvrExecutor() = default;

void AvrExecutor::power_on(SimTime t) {
  power_off(t);
  machine_ = std::make_unique<avr::Machine>(image_->firmware, image_->loop, clocked_, clocked_.begin_tick(t));
  if (clock_start_ > 0) machine_->set_clock(clock_start_);
  if (debug_port_) machine_->set_debug_port(debug_port_.get());
  if (written_) {
    written_->begin([this](const SourceLine&) {
      const avr::Diagnosis diagnosis(image_->firmware, image_->debug, *machine_);
      return diagnosis.place_of_calls(machine_->stack().open_calls());
    });
    machine_->trace_bytes(*written_);
  }
}

void AvrExecutor::power_off(SimTime t) {
  before_ = resources();
  if (debug_port_) debug_port_->unplug();
  machine_.reset();
  crash_.reset();
  board_.reset(t);
  reached_ = t;
}

void AvrExecutor::run_until(SimTime t) {
  if (!machine_ || crash_) return;
  machine_->run_until(clocked_.begin_tick(t));
  reached_ = t;
  if (const auto& fault = machine_->chip().fault())
    crash_ = avr::Diagnosis(image_->firmware, image_->debug, *machine_).crash(*fault);
  board_.forget_edges(t);
}

SimTime AvrExecutor::last_call() const {
  if (!machine_) return reached_;
  return machine_->chip().is_asleep()
             ? reached_
             : clocked_.to_world(machine_->link().time_of(machine_->chip().last_io()));
}

std::optional<Resources> AvrExecutor::resources() const {
  if (image_->firmware.needs_larger_chip()) return std::nullopt;
  if (!machine_) return before_;
  Resources r = machine_->resources();
  if (before_) {
    r.stack_bytes_max = std::max(r.stack_bytes_max, before_->stack_bytes_max);
    r.loop_us_max = std::max(r.loop_us_max, before_->loop_us_max);
  }
  return r;
}

void AvrExecutor::set_clock_start(SimTime start) {
  if (!image_->firmware.find_variable("timer0_millis") || !image_->firmware.find("main"))
    throw InputError({image_->firmware.file},
                     "has no clock that --clock could set (it never calls millis())");
  clock_start_ = start;
}

void AvrExecutor::debug_with(gdb::Server& server) {
  debug_port_ = std::make_unique<avr::DebugPort>(server, image_->firmware, clocked_);
}

SourceLine AvrExecutor::source() {
  return machine_ ? avr::Diagnosis(image_->firmware, image_->debug, *machine_).where_now() : SourceLine{};
}

SourceLine AvrExecutor::source_of(std::uint8_t byte) {
  return written_ ? written_->take(byte) : SourceLine{};
}

Activity AvrExecutor::activity() {
  if (!machine_) {
    Activity activity;
    activity.last_call = reached_;
    return activity;
  }
  Activity activity = avr::Diagnosis(image_->firmware, image_->debug, *machine_).activity();
  activity.last_call = clocked_.to_world(activity.last_call);
  if (crash_) activity.where = crash_->where;
  return activity;
}

}  // namespace robosim::exec
