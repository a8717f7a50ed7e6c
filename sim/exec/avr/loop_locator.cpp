#include "sim/exec/avr/loop_locator.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "sim/exec/elf/loop_locator.h"
#include "sim/mcu/avr/decode.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Instruction;
using robosim::avr::Op;

// Functions of libgcc that the code of a switch statement calls or jumps to. These functions jump on through
// a table of addresses.
constexpr const char* kTableJumps[] = {"__tablejump2__", "__tablejump__", "__tablejump_elpm__"};

class Code final : public ChipCode {
 public:
  explicit Code(const Firmware& firmware)
      : firmware_(firmware), words_(static_cast<std::uint32_t>(firmware.flash.size() / 2)) {
    code_ = robosim::avr::decode(std::span(firmware.flash).first(2 * words_));
    for (const char* name : kTableJumps)
      if (const auto address = firmware.find(name)) table_jumps_.insert(*address / 2);
  }

  /// Returns the calls of a function, and the jumps to the function from other code.
  std::vector<std::uint32_t> calls_of(const Symbol& function) const override {
    std::vector<std::uint32_t> calls;
    const std::uint32_t begin = function.address, end = begin + function.size;
    for (std::uint32_t pc = 0; pc < std::min(words_, firmware_.code_end / 2); pc += code_[pc].words) {
      const Control control = control_of(code_[pc].op);
      const bool within = 2 * pc >= begin && 2 * pc < end;
      const bool leads = control == Control::call || control == Control::jump;
      if (leads && !within && target(pc) == begin / 2) calls.push_back(2 * pc);
    }
    return calls;
  }

  Steps steps_of(const Symbol& function) const override {
    const std::uint32_t begin = function.address / 2, end = (function.address + function.size) / 2;
    Steps steps;
    std::set<std::uint32_t> reached, behind_jumps;
    std::vector<std::uint32_t> anywhere;
    for (std::uint32_t pc = begin; pc < end && pc < words_; pc += code_[pc].words) {
      Step step;
      const auto add = [&](std::uint32_t to) {
        if (to < begin || to >= end) return;
        step.next.push_back(2 * to);
        reached.insert(2 * to);
      };
      const std::uint32_t next = pc + code_[pc].words;
      bool goes_on = true;
      switch (control_of(code_[pc].op)) {
        case Control::straight:
          break;
        case Control::jump:
          step.kind = Step::Kind::jump;
          goes_on = false;
          if (table_jumps_.contains(target(pc))) anywhere.push_back(2 * pc);
          add(target(pc));
          break;
        case Control::branch:
          step.kind = Step::Kind::call_or_branch;
          add(target(pc));
          break;
        case Control::skip:
          step.kind = Step::Kind::call_or_branch;
          if (next < words_) add(next + code_[next].words);
          break;
        case Control::indirect_jump:
          anywhere.push_back(2 * pc);
          goes_on = false;
          break;
        case Control::call:
        case Control::indirect_call:
          step.kind = Step::Kind::call_or_branch;
          break;
        case Control::returns:
          goes_on = false;
          break;
        case Control::stops:
          goes_on = code_[pc].op == Op::sleep;
          break;
      }
      if (goes_on) add(next);
      if (!goes_on) behind_jumps.insert(2 * next);
      steps.emplace(2 * pc, std::move(step));
    }
    // Assumes that a jump through a table leads to each case of a switch. A case is code that follows
    // a jump or return, and that no other instruction reaches.
    for (const std::uint32_t from : anywhere)
      for (const std::uint32_t to : behind_jumps)
        if (steps.contains(to) && !reached.contains(to)) steps[from].next.push_back(to);
    return steps;
  }

 private:
  std::uint32_t target(std::uint32_t pc) const {
    return robosim::avr::target_of(code_[pc], pc, firmware_.chip->flash_bytes / 2);
  }

  const Firmware& firmware_;
  std::uint32_t words_;
  std::vector<Instruction> code_;
  std::set<std::uint32_t> table_jumps_;  ///< word addresses of the functions in kTableJumps
};

}  // namespace

LoopMarks locate_loop(const Firmware& firmware, const DebugInfo& debug) {
  return exec::locate_loop(Code(firmware), firmware.symbols, debug);
}

}  // namespace robosim::exec::avr
