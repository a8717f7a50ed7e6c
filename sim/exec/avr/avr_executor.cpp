#include "sim/exec/avr/avr_executor.h"

#include "sim/exec/avr/debug_port.h"
#include "sim/exec/avr/diagnosis.h"
#include "sim/exec/avr/loop.h"

namespace robosim::exec {
namespace {

struct Image {
  Image(const std::filesystem::path& file, const BoardSpec& spec)
      : firmware(avr::Firmware::read(file, spec)), debug(file), loop(avr::rounds_of_loop(firmware, debug)) {}

  avr::Firmware firmware;
  DebugInfo debug;
  Rounds loop;
};

class RunningAvr final : public RunningChip {
 public:
  RunningAvr(const Image& image, ClockedBoard& board, SimTime t, avr::DebugPort* debugger)
      : image_(image), machine_(image.firmware, image.loop, board, t), debugger_(debugger) {
    if (debugger) machine_.set_debug_port(debugger);
  }
  ~RunningAvr() override {
    if (debugger_) debugger_->unplug();
  }

  void run_until(SimTime t) override { machine_.run_until(t); }
  bool has_crashed() const override { return machine_.chip().fault().has_value(); }
  Crash crash() const override { return diagnosis().crash(*machine_.chip().fault()); }
  Resources resources() const override { return machine_.resources(); }
  bool is_asleep() const override { return machine_.chip().is_asleep(); }
  SimTime last_io() const override { return machine_.link().time_of(machine_.chip().last_io()); }
  Activity activity() const override { return diagnosis().activity(); }
  SourceLine where_now() const override { return diagnosis().where_now(); }
  SourceLine printing(const SourceLine&) const override {
    return diagnosis().place_of_calls(machine_.stack().open_calls());
  }
  void trace_bytes(WrittenBytes& bytes) override { machine_.trace_bytes(bytes); }
  void set_clock(SimTime start) override { machine_.set_clock(start); }

 private:
  avr::Diagnosis diagnosis() const { return {image_.firmware, image_.debug, machine_}; }

  const Image& image_;
  avr::Machine machine_;
  avr::DebugPort* debugger_;  ///< null = nobody debugs
};

class AvrFirmware final : public ChipFirmware {
 public:
  AvrFirmware(const std::filesystem::path& file, const BoardSpec& spec) : image_(file, spec) {}

  const std::string& file() const override { return image_.firmware.file; }
  int int_bits() const override { return 16; }
  bool fits_chip() const override { return !image_.firmware.needs_larger_chip(); }
  bool has_boards_eeprom() const override { return true; }
  const std::vector<std::uint8_t>& eeprom() const override { return image_.firmware.eeprom; }
  std::string why_clock_stays() const override {
    if (!image_.firmware.named) return "a .hex has no names to find it by";
    const bool has_clock = image_.firmware.find_variable("timer0_millis") && image_.firmware.find("main");
    return has_clock ? "" : "it never calls millis()";
  }
  void debug_with(gdb::Server& server, ClockedBoard& board) override {
    debugger_ = std::make_unique<avr::DebugPort>(server, image_.firmware, board);
  }
  std::unique_ptr<RunningChip> power_on(ClockedBoard& board, SimTime t) override {
    return std::make_unique<RunningAvr>(image_, board, t, debugger_.get());
  }

 private:
  const Image image_;
  std::unique_ptr<avr::DebugPort> debugger_;
};

}  // namespace

AvrExecutor::AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image)
    : ChipExecutor(spec, std::make_unique<AvrFirmware>(image, spec)) {}

}  // namespace robosim::exec
