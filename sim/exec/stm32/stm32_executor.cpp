#include "sim/exec/stm32/stm32_executor.h"

#include "sim/exec/stm32/debug_port.h"
#include "sim/exec/stm32/diagnosis.h"
#include "sim/exec/stm32/driven_lines.h"
#include "sim/exec/stm32/engine.h"
#include "sim/exec/stm32/hang.h"
#include "sim/exec/stm32/loop_locator.h"

namespace robosim::exec {

struct Stm32Executor::Image {
  Image(const std::filesystem::path& file, const BoardSpec& spec)
      : firmware(stm32::Firmware::read(file, spec)), debug(file), loop(stm32::locate_loop(firmware, debug)) {}

  stm32::Firmware firmware;
  DebugInfo debug;
  LoopMarks loop;
};

class Stm32Executor::Running final : public RunningChip {
 public:
  Running(const Image& image, ClockedBoard& board, stm32::FlashMemory& memory, stm32::Engine& engine,
          SimTime t, stm32::DebugPort* debugger, stm32::Machine*& seen)
      : image_(image),
        machine_(image.firmware, image.loop, board, memory, engine, t),
        debugger_(debugger),
        seen_(seen) {
    seen_ = &machine_;
    if (debugger) machine_.set_debug_port(debugger);
  }
  ~Running() override {
    if (debugger_) debugger_->unplug();
    if (seen_ == &machine_) seen_ = nullptr;
  }

  void run_waiting_loops() { machine_.cpu().idle().allow(false); }
  void count(LineCounts& lines) { machine_.cpu().count(lines); }

  void trace_drives() { lines_.emplace(machine_, image_.debug); }

  void run_until(SimTime t) override { machine_.run_until(t); }
  bool has_crashed() const override { return machine_.cpu().fault().has_value(); }
  Crash crash() const override { return diagnosis().crash(*machine_.cpu().fault()); }
  Resources resources() const override { return machine_.resources(); }
  int watchdog_resets() const override { return machine_.watchdog_resets(); }
  bool is_asleep() const override { return machine_.cpu().is_asleep(); }
  SimTime last_io() const override { return machine_.time_of(machine_.cpu().last_io()); }
  bool hangs() const override { return stm32::hangs(machine_, image_.firmware); }
  Activity activity() const override { return diagnosis().activity(); }
  SourceLine where_now() const override { return diagnosis().where_now(); }
  SourceLine printing(const SourceLine& before) const override {
    // A tail call leaves no return address on the stack. Therefore tries the latest jump from a line of the
    // sketch first, then `before`, then the open calls.
    SourceLine line = diagnosis().place_of(machine_.cpu().last_jumps());
    if (line.file.empty()) line = before;
    return line.file.empty() ? diagnosis().place_of(machine_.open_calls()) : line;
  }
  const SourceLine& driving(Pin pin, const PinDrive& drive) const override {
    if (!lines_) return RunningChip::driving(pin, drive);
    return lines_->line_of(machine_.bus().link().board.spec().pins[pin], drive.pwm);
  }
  void trace_bytes(TxProvenance& bytes) override { machine_.trace_bytes(bytes); }
  void set_clock(SimTime start) override { machine_.set_clock(start); }
  std::any save() const override { return machine_.save(); }
  void restore(const std::any& saved) override {
    machine_.restore(std::any_cast<const stm32::Machine::Saved&>(saved));
    if (debugger_) debugger_->restored();
  }

 private:
  stm32::Diagnosis diagnosis() const { return {image_.firmware, image_.debug, machine_}; }

  const Image& image_;
  stm32::Machine machine_;
  std::optional<stm32::DrivenLines> lines_;  ///< finds the lines that drive pins; nullopt = not requested
  stm32::DebugPort* debugger_;               ///< null without a debugger
  stm32::Machine*& seen_;                    ///< Firmware::machine, which this object sets and clears
};

class Stm32Executor::Firmware final : public ChipFirmware {
 public:
  Firmware(const std::filesystem::path& file, const BoardSpec& spec)
      : image_(file, spec), flash_(image_.firmware.flash) {}

  const std::string& file() const override { return image_.firmware.file; }
  int int_bits() const override { return 32; }
  bool fits_chip() const override { return true; }
  bool has_boards_eeprom() const override { return false; }
  std::string why_clock_stays() const override {
    const Symbols& symbols = image_.firmware.symbols;
    return symbols.find("robosim_millis") && symbols.find("main")
               ? ""
               : "it is not built with the core of Robosim";
  }
  void debug_with(gdb::Server& server, ClockedBoard& board) override {
    debugger_ = std::make_unique<stm32::DebugPort>(server, image_.firmware, board);
  }
  std::unique_ptr<RunningChip> power_on(ClockedBoard& board, SimTime t) override {
    auto running = std::make_unique<Running>(image_, board, flash_, engine_, t, debugger_.get(), machine);
    if (runs_waiting_loops) running->run_waiting_loops();
    if (lines) running->count(*lines);
    if (traces_drives) running->trace_drives();
    return running;
  }

  void count_lines() override { lines = std::make_unique<LineCounts>(image_.debug); }
  bool trace_drives() override { return traces_drives = image_.debug.is_there(); }
  std::any save() const override { return flash_.save(); }
  void restore(const std::any& saved) override {
    for (const stm32::Address page : flash_.restore(std::any_cast<const stm32::FlashMemory::State&>(saved)))
      if (machine) machine->cpu().forget(robosim::stm32::kFlash + page);
  }
  std::string line_counts() const override { return lines ? lines->text() : ""; }

  stm32::Machine* machine = nullptr;  ///< null while the power is off
  bool runs_waiting_loops = false, traces_drives = false;
  std::unique_ptr<LineCounts> lines;  ///< null = lines are not counted

 private:
  const Image image_;
  stm32::FlashMemory flash_;
  stm32::Engine engine_{flash_};
  std::unique_ptr<stm32::DebugPort> debugger_;
};

Stm32Executor::Stm32Executor(const BoardSpec& spec, const std::filesystem::path& image)
    : Stm32Executor(spec, new Firmware(image, spec)) {}

Stm32Executor::Stm32Executor(const BoardSpec& spec, Firmware* firmware)
    : ChipExecutor(spec, std::unique_ptr<ChipFirmware>(firmware)), firmware_(*firmware) {}

void Stm32Executor::run_waiting_loops() { firmware_.runs_waiting_loops = true; }

const stm32::Machine* Stm32Executor::machine() const { return firmware_.machine; }

}  // namespace robosim::exec
