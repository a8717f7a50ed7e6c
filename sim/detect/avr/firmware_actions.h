// Finds the actions of firmware on an AVR that may be mistakes, and passes them to DoubtfulActions
// (doubtful_actions.h).
//
// Calls: debug information gives the address where a function of the API begins. It also gives the registers
// that have the function's arguments at this address. The same applies to inlined copies of a function.
// Calls are not found if the debug information gives no registers or constants for their arguments.
//
// Timers: the detector examines every instruction that stores to TCCRnA, TCCRnB or OCRnx at a constant
// address.
//
// Conversions: the ADC reports them (robosim::avr::Core::on_conversion).
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "sim/detect/avr/chip_detector.h"
#include "sim/detect/doubtful_actions.h"

namespace robosim::detect::avr {

class FirmwareActions final : public ChipDetector {
 public:
  explicit FirmwareActions(const RunningProgram& program);
  ~FirmwareActions() override;

  void visited(std::uint32_t pc, Cycle at) override;
  std::vector<Detected> found(SimTime now) const override { return actions_.found(now); }

 private:
  /// A store to a register of a timer.
  struct Store {
    int timer = 0;      ///< index in ChipSpec::timers
    int output = -1;    ///< the output whose OCRnx is written; -1 = none
    bool is_b = false;  ///< TCCRnB is written, not TCCRnA
  };

  /// A place where a function of the API begins.
  struct Function {
    FirmwareAction::Kind kind;
    int number;  ///< for Kind::missing_pin: index in kPinFunctions
    exec::DebugInfo::Entry entry;
  };

  void find_functions();
  void find_stores();
  void converted(int pin, double error);
  void called(const Function& function);
  /// Returns the flash address of the instruction that called the function, or that jumped to it at the end
  /// of another function.
  std::uint32_t caller_of(const Function& function) const;
  void stored(const Store& store, std::uint8_t value);
  void tell(FirmwareAction::Kind kind, int64_t first, int64_t second, int64_t third,
            const std::function<SourceLine()>& where);

  const RunningProgram program_;
  const robosim::avr::Cpu& cpu_;
  std::multimap<std::uint32_t, Function> functions_;  ///< by the byte address of their first instruction
  std::map<std::uint32_t, Store> stores_;             ///< by the byte address of the instruction
  DoubtfulActions actions_;
};

}  // namespace robosim::detect::avr
