// Implements exec::CauseFinder for an AVR, by a backward slice of the executed instructions.
//
//   wanted values     registers, flags and bytes whose values contribute to the effect
//   instructions      belong to the slice if they computed a wanted value; their operands become wanted
//   branches          belong to the slice if they decided that an instruction of the slice ran
//   external inputs   (pins, ADC, clock, received bytes) end the slice
//
// An instruction of the sketch maps to its source line. An instruction of the Arduino core maps to the line
// of the sketch that called the core. If a call has not returned yet, its line is a cause, too. The distance
// of a cause from the effect is measured in lines.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/avr/machine.h"
#include "sim/exec/avr/why/branches.h"
#include "sim/exec/avr/why/instruction_log.h"
#include "sim/exec/avr/why/sketch_lines.h"
#include "sim/exec/core/cause_finder.h"

namespace robosim::exec::avr {

class BackwardSlice final : public CauseFinder {
 public:
  /// All arguments must outlive this object.
  BackwardSlice(const Firmware& firmware, const DebugInfo& debug, ClockedBoard& board)
      : firmware_(firmware), sketch_(debug), board_(board) {}

  /// Connects the machine at power-on, and disconnects it at power-off.
  void plug_into(Machine& machine);
  void unplug();

  void begin() override;
  void end() override;
  void ask(const Effect& effect, SimTime t) override;
  void ask_place(SimTime t) override;
  void follow(bool adjoins) override;
  std::vector<std::uint16_t> open_bytes() const override;
  void give_up(const std::vector<std::uint16_t>& bytes) override;
  bool open_registers() const override;
  std::optional<std::uint8_t> byte(std::uint16_t address) const override;
  void close() override;
  std::vector<CauseStep> steps() const override;
  SourceLine busiest(SimTime from, SimTime to) const override;
  Share handlers(SimTime from, SimTime to) const override;
  bool interrupts_on() const override;
  std::optional<CauseStep> switched_off(bool on) override;

 private:
  using Index = std::int32_t;  ///< index of an entry in the instruction log
  static constexpr Index kNone = -1;
  static constexpr Index kLater = std::numeric_limits<Index>::max();
  using Line = SketchLines::Line;  ///< null = not in the sketch
  struct Want {
    int far = 0;
    Line line = nullptr;
    Index by = kLater;  ///< last entry that reads the value; kLater = the reader ran after the log's end
  };
  /// An instruction of the slice. The search has not yet reached the branch that decided whether it ran.
  struct Pending {
    /// The instruction's address. kLast means: the branch before it, in the order of execution, decided.
    std::uint32_t pc = 0;
    Want want;
  };
  static constexpr std::uint32_t kLast = ~0u;
  static constexpr int kFarthest = 14;  ///< causes at a larger distance are ignored

  void forget();
  void find_frames();
  void set_out(SimTime t);
  SimTime time_of(Index index) const;
  std::vector<Line> lines_of(Index index) const;
  bool is_in_handler(Index index) const;
  void visit(Index index);
  void visit_branch(Index index);
  void visit_skipped_writes(Index index);
  Index meeting_behind(Index branch, std::uint32_t meets) const;
  std::optional<std::uint16_t> pointer_at(Index index, unsigned pair) const;
  bool sends(Index index) const;
  std::optional<Want> take_wanted(Index index);
  void take(Index index, Want want, CauseStep::Kind kind);
  void want_operands(Index index, Want want);
  void want_branch(Index index, Want want);
  void add_pending(Index index, Want want);
  int far_of_branch(std::uint32_t pc) const;
  bool comes_from_outside(Index index, Want want);
  void note(Line line, int far, CauseStep::Kind kind, SimTime t, Pin pin = kNoPin);
  void note_variable(std::uint32_t address, Want want);

  const Firmware& firmware_;
  const SketchLines sketch_;
  ClockedBoard& board_;
  Machine* machine_ = nullptr;  ///< null = the chip has no power
  bool records_ = false;        ///< between begin() and end()
  std::optional<InstructionLog> log_;
  std::optional<Branches> branches_;
  std::vector<std::uint32_t> calls_before_;  ///< word addresses of the calls open when the log began
  std::vector<Index> frames_;    ///< for each entry, the entry of the enclosing call or interrupt; or kNone
  Index from_ = kNone;           ///< entry at which the next follow() starts
  bool sends_two_wire_ = false;  ///< the next follow() starts from each byte that the chip sent

  std::array<std::optional<Want>, 32> registers_;
  std::array<std::optional<Want>, 8> flags_;
  std::map<std::uint16_t, Want> bytes_;
  std::map<std::uint16_t, std::uint8_t> bits_;       ///< relevant bits of I/O registers, by address
  std::map<Index, std::vector<Pending>> pending_;    ///< by the entry of the enclosing call
  std::map<std::pair<Line, Pin>, CauseStep> steps_;  ///< by line, and by the pin that the line has read
};

}  // namespace robosim::exec::avr
