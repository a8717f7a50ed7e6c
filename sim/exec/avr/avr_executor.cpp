#include "sim/exec/avr/avr_executor.h"

#include "sim/exec/avr/debug_port.h"
#include "sim/exec/avr/diagnosis.h"
#include "sim/exec/avr/driven_lines.h"
#include "sim/exec/avr/hang.h"
#include "sim/exec/avr/loop_locator.h"
#include "sim/exec/avr/running_program.h"
#include "sim/exec/avr/why/backward_slice.h"

namespace robosim::exec {

struct AvrExecutor::Image {
  Image(const std::filesystem::path& file, const BoardSpec& spec)
      : firmware(avr::Firmware::read(file, spec)), debug(file), loop(avr::locate_loop(firmware, debug)) {}

  avr::Firmware firmware;
  DebugInfo debug;
  LoopMarks loop;
};

class AvrExecutor::Running final : public RunningChip {
 public:
  Running(const Image& image, ClockedBoard& board, SimTime t, avr::DebugPort* debugger,
          avr::BackwardSlice* causes, robosim::avr::Chip*& chip)
      : image_(image),
        board_(board.spec()),
        machine_(image.firmware, image.loop, board, t),
        debugger_(debugger),
        causes_(causes),
        chip_(chip) {
    chip_ = &machine_.chip().chip();
    if (debugger) machine_.set_debug_port(debugger);
    if (causes) causes->plug_into(machine_);
    if (image.firmware.needs_larger_chip()) machine_.chip().look_for_tearing(image.debug);
  }
  ~Running() override {
    if (debugger_) debugger_->unplug();
    if (causes_) causes_->unplug();
    if (chip_ == &machine_.chip().chip()) chip_ = nullptr;
  }

  void count(LineCounts& lines) { machine_.chip().count(lines); }
  void detect(const MakeChipDetectors& make, const std::vector<Pin>& counted) {
    detectors_ = make({machine_, image_.firmware, image_.debug, board_}, counted);
  }
  std::vector<Detected> detected() const override {
    std::vector<Detected> all;
    for (const auto& detector : detectors_)
      for (Detected& seen : detector->found(machine_.now())) all.push_back(std::move(seen));
    return all;
  }
  void trace_drives() { lines_.emplace(machine_.chip(), machine_.stack(), image_.debug); }
  void run_until(SimTime t) override { machine_.run_until(t); }
  bool has_crashed() const override { return machine_.chip().fault().has_value(); }
  Crash crash() const override { return diagnosis().crash(*machine_.chip().fault()); }
  Resources resources() const override { return machine_.resources(); }
  int watchdog_resets() const override { return machine_.chip().watchdog_resets(); }
  bool is_asleep() const override { return machine_.chip().is_asleep(); }
  SimTime last_io() const override { return machine_.clock_map().time_of(machine_.chip().last_io()); }
  bool hangs() const override { return avr::hangs(machine_.chip(), image_.firmware); }
  Activity activity() const override { return diagnosis().activity(); }
  SourceLine where_now() const override { return diagnosis().where_now(); }
  SourceLine sketch_line() const override { return diagnosis().sketch_line(); }
  SourceLine printing(const SourceLine&) const override {
    return diagnosis().place_of_calls(machine_.stack().open_calls());
  }
  const SourceLine& driving(Pin pin, const PinDrive& drive) const override {
    return lines_ ? lines_->line_of(machine_.adapter().chip_pin(pin), drive.pwm)
                  : RunningChip::driving(pin, drive);
  }
  void trace_bytes(TxProvenance& bytes) override { machine_.trace_bytes(bytes); }
  std::any save() const override { return machine_.save(); }
  void restore(const std::any& saved) override {
    machine_.restore(std::any_cast<const avr::Machine::Saved&>(saved));
    if (debugger_) debugger_->restored();
  }
  std::vector<std::uint8_t> ram() const override { return machine_.chip().ram(); }
  void was_browned_out(const std::vector<std::uint8_t>& ram) override {
    machine_.chip().was_browned_out(ram);
  }
  void set_clock(SimTime start) override { machine_.set_clock(start); }

 private:
  avr::Diagnosis diagnosis() const { return {image_.firmware, image_.debug, machine_}; }

  const Image& image_;
  const BoardSpec& board_;
  avr::Machine machine_;
  std::vector<std::unique_ptr<Detector>> detectors_;
  std::optional<avr::DrivenLines> lines_;  ///< finds the lines that drive pins; nullopt = not requested
  avr::DebugPort* debugger_;               ///< null without a debugger
  avr::BackwardSlice* causes_;             ///< null if find_causes() was not called
  robosim::avr::Chip*& chip_;              ///< Firmware::chip, which this object sets and clears
};

class AvrExecutor::Firmware final : public ChipFirmware {
 public:
  Firmware(const std::filesystem::path& file, const BoardSpec& spec, MakeChipDetectors make_detectors)
      : image_(file, spec), make_detectors_(std::move(make_detectors)) {}

  const std::string& file() const override { return image_.firmware.file; }
  int int_bits() const override { return 16; }
  bool fits_chip() const override { return !image_.firmware.needs_larger_chip(); }
  bool has_boards_eeprom() const override { return true; }
  const std::vector<std::uint8_t>& eeprom() const override { return image_.firmware.eeprom; }
  std::string why_clock_stays() const override {
    if (!image_.firmware.named) return "the clock is found by symbols, which a .hex file lacks";
    const bool has_clock = image_.firmware.find_variable("timer0_millis") && image_.firmware.find("main");
    return has_clock ? "" : "it never calls millis()";
  }
  void debug_with(gdb::Server& server, ClockedBoard& board) override {
    debugger_ = std::make_unique<avr::DebugPort>(server, image_.firmware, board);
  }
  std::unique_ptr<RunningChip> power_on(ClockedBoard& board, SimTime t) override {
    auto running = std::make_unique<Running>(image_, board, t, debugger_.get(), causes_.get(), chip);
    chip->idle().allow(!runs_waiting_loops);
    if (lines) running->count(*lines);
    if (traces_drives) running->trace_drives();
    if (detects && make_detectors_ && fits_chip()) running->detect(make_detectors_, counted_);
    return running;
  }

  void detect(const std::vector<Pin>& counted) override {
    detects = true;
    counted_ = counted;
  }
  void count_lines() override { lines = std::make_unique<LineCounts>(image_.debug); }
  bool trace_drives() override { return traces_drives = image_.debug.is_there(); }
  CauseFinder* find_causes(ClockedBoard& board) override {
    if (!image_.debug.is_there()) return nullptr;
    causes_ = std::make_unique<avr::BackwardSlice>(image_.firmware, image_.debug, board);
    return causes_.get();
  }
  std::string line_counts() const override { return lines ? lines->text() : ""; }

  robosim::avr::Chip* chip = nullptr;  ///< null while the power is off
  bool runs_waiting_loops = false;
  bool traces_drives = false;
  bool detects = false;
  std::unique_ptr<LineCounts> lines;  ///< null = lines are not counted

 private:
  const Image image_;
  const MakeChipDetectors make_detectors_;
  std::vector<Pin> counted_;  ///< pins on which every edge matters to the detectors
  std::unique_ptr<avr::DebugPort> debugger_;
  std::unique_ptr<avr::BackwardSlice> causes_;
};

AvrExecutor::AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image,
                         MakeChipDetectors make_detectors)
    : AvrExecutor(spec, new Firmware(image, spec, std::move(make_detectors))) {}

AvrExecutor::AvrExecutor(const BoardSpec& spec, Firmware* firmware)
    : ChipExecutor(spec, std::unique_ptr<ChipFirmware>(firmware)), firmware_(*firmware) {}

void AvrExecutor::run_waiting_loops() { firmware_.runs_waiting_loops = true; }

const robosim::avr::Chip* AvrExecutor::chip() const { return firmware_.chip; }

}  // namespace robosim::exec
