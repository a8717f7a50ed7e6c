#include "sim/exec/avr/race_candidates.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "hal/board/avr_registers.h"
#include "sim/base/elf/avr_addresses.h"
#include "sim/exec/avr/data_flow.h"
#include "sim/mcu/avr/instruction_effects.h"
#include "sim/mcu/avr/instruction_table.h"

namespace robosim::exec::avr {
namespace {

using robosim::avr::Control;
using robosim::avr::control_of;
using robosim::avr::Cpu;
using robosim::avr::Instruction;
using robosim::avr::InstructionRow;
using robosim::avr::Location;
using robosim::avr::Op;
using robosim::avr::registers_of;
using robosim::avr::row_of;

constexpr std::uint32_t kLargestNumber = 8;
// Largest distances in words: within an access, from an access to another read of the number, and from a
// comparison to its jump.
constexpr std::uint32_t kWordsOfAccess = 16, kWordsOfSecondLook = 48, kWordsOfJump = 8;
constexpr int kZeroRegister = 1;  // register that always contains 0 in code of avr-gcc
constexpr int kFramePointer = 28;

bool uses_pointer(const InstructionRow& row) {
  return row.location == Location::pointer || row.location == Location::displaced;
}

std::vector<std::uint32_t> addresses_of(const std::vector<DebugInfo::CodeLine>& lines) {
  std::vector<std::uint32_t> addresses;
  for (const DebugInfo::CodeLine& line : lines) addresses.push_back(line.address);
  std::sort(addresses.begin(), addresses.end());
  return addresses;
}

/// Follows a pointer register through code without jumps, from the first access by the pointer.
class PointerFlow {
 public:
  explicit PointerFlow(const Instruction& first)
      : pointer_(row_of(first.op).pointer), first_(place_of(first)) {
    follow(first);
  }
  bool is_known() const { return known_; }
  /// Returns the distance from the first access to this access; empty if this access uses another pointer.
  std::optional<int> distance(const Instruction& i) const {
    if (!uses_pointer(row_of(i.op)) || row_of(i.op).pointer != pointer_) return std::nullopt;
    return moved_ + place_of(i) - first_;
  }
  void follow(const Instruction& i) {
    const InstructionRow& row = row_of(i.op);
    const std::uint32_t pair = std::uint32_t{3} << pointer_;
    if ((i.op == Op::adiw || i.op == Op::sbiw) && i.a == pointer_)
      moved_ += i.op == Op::adiw ? i.b : -i.b;
    else if (uses_pointer(row) && row.pointer == pointer_ && (row.stores || !(pair >> i.a & 1)))
      moved_ += row.step;
    else if (registers_of(i).writes & pair)
      known_ = false;
  }

 private:
  /// Returns the accessed address relative to the pointer before the instruction.
  static int place_of(const Instruction& i) {
    const InstructionRow& row = row_of(i.op);
    return row.location == Location::displaced ? i.b : row.step < 0 ? row.step : 0;
  }

  const int pointer_, first_;
  int moved_ = 0;
  bool known_ = true;
};

class Finder {
 public:
  Finder(const Firmware& firmware, const DebugInfo& debug, const Cpu& cpu, const SharedNumbers& numbers)
      : firmware_(firmware),
        debug_(debug),
        cpu_(cpu),
        numbers_(numbers),
        off_(without_interrupts(cpu, firmware.code_end)),
        handlers_(of_handlers(cpu, firmware.code_end)),
        lines_(addresses_of(debug.lines())) {}

  std::vector<RaceCandidate> find() {
    look_at_functions();
    for (std::uint32_t pc = 0; pc < words(); pc += at(pc).words) {
      const Instruction& i = at(pc);
      if (const auto number = constant(i)) {
        size_of(*number) == 1 ? add_update(pc) : add_group(pc, *number);
      } else if (uses_pointer(row_of(i.op)) && !in_frame(pc)) {
        add_group_by_pointer(pc);
        add_update(pc);
      }
    }
    std::vector<RaceCandidate> all;
    for (auto& [pc, candidate] : found_) {
      candidate.guards = guards_of(pc);
      all.push_back(std::move(candidate));
    }
    return all;
  }

 private:
  using Reads = std::function<bool(std::uint32_t pc)>;

  std::uint32_t words() const { return firmware_.code_end / 2; }
  const Instruction& at(std::uint32_t pc) const { return cpu_.instruction(pc); }
  std::uint32_t size_of(std::size_t number) const { return numbers_.all()[number].size; }

  /// Returns the number that the instruction accesses by a constant address.
  std::optional<std::size_t> constant(const Instruction& i) const {
    if (i.op != Op::lds && i.op != Op::sts) return std::nullopt;
    return numbers_.at(static_cast<std::uint32_t>(i.k));
  }

  /// Collects the functions that have a frame pointer, and the places of all calls.
  void look_at_functions() {
    for (std::uint32_t pc = 0; pc < words(); pc += at(pc).words) {
      const Instruction& i = at(pc);
      if (i.op == Op::in && i.a == kFramePointer && i.k == robosim::avr::reg::kSpL)
        if (const Symbol* const function = firmware_.function_at(2 * pc)) framed_.insert(function->address);
      if (control_of(i.op) == Control::call || control_of(i.op) == Control::jump)
        calls_.emplace(target(pc), pc);
    }
  }
  std::uint32_t target(std::uint32_t pc) const {
    return robosim::avr::target_of(at(pc), pc, static_cast<std::uint32_t>(cpu_.flash().size() / 2));
  }
  /// Returns whether the instruction accesses a local variable by the frame pointer.
  bool in_frame(std::uint32_t pc) const {
    if (framed_.empty() || row_of(at(pc).op).pointer != kFramePointer) return false;
    const Symbol* const function = firmware_.function_at(2 * pc);
    return function && framed_.contains(function->address);
  }

  bool can_be_torn(std::uint32_t pc) const { return !off_[pc] && !handlers_[pc]; }
  /// Returns whether the instruction belongs to the sketch or a library. The search for an instruction's line
  /// is slow, so functions without lines of the sketch are skipped.
  bool is_sketchs(std::uint32_t pc) const {
    if (const Symbol* const function = firmware_.function_at(2 * pc); function && function->size > 0) {
      const auto line = std::lower_bound(lines_.begin(), lines_.end(), function->address);
      if (line == lines_.end() || *line >= function->address + function->size) return false;
    }
    return !debug_.place(2 * pc).file.empty();
  }

  void add_group(std::uint32_t pc, std::size_t number);
  void add_group_by_pointer(std::uint32_t pc);
  void add_update(std::uint32_t pc);
  bool is_read_again(std::uint32_t pc, const Reads& reads) const;
  bool is_called_again(std::uint32_t pc);
  bool reads_start_of(std::uint32_t pc, const Instruction& first) const;
  std::optional<int> distance(const Instruction& from, const Instruction& to) const;
  std::vector<int> guards_of(std::uint32_t pc) const;

  const Firmware& firmware_;
  const DebugInfo& debug_;
  const Cpu& cpu_;
  const SharedNumbers& numbers_;
  const std::vector<bool> off_, handlers_;
  const std::vector<std::uint32_t> lines_;  ///< addresses where lines of the sketch and its libraries begin
  std::set<std::uint32_t> framed_;          ///< byte addresses of functions with a frame pointer
  std::multimap<std::uint32_t, std::uint32_t> calls_;  ///< target and place of each call or jump, in words
  std::map<const Symbol*, bool> called_again_;         ///< is_called_again() by function
  std::map<std::uint32_t, RaceCandidate> found_;       ///< by word address
};

/// Adds an access to a number of several bytes at a constant address. The instruction at `pc` must access one
/// byte of the number, and a later instruction another byte.
void Finder::add_group(std::uint32_t pc, std::size_t number) {
  const Instruction& first = at(pc);
  for (std::uint32_t next = pc + first.words; next < pc + kWordsOfAccess; next += at(next).words) {
    const Instruction& i = at(next);
    if (control_of(i.op) != Control::straight) return;
    if (constant(i) != number) continue;
    if (i.op != first.op || i.k == first.k || !can_be_torn(next) || found_.contains(next)) return;
    const auto reads = [&](std::uint32_t place) {
      return at(place).op == Op::lds &&
             static_cast<std::uint32_t>(at(place).k) == numbers_.all()[number].begin;
    };
    if (!is_sketchs(next) || (first.op == Op::lds && (is_read_again(pc, reads) || is_called_again(pc))))
      return;
    found_[next] = {2 * next, first.op == Op::sts ? AccessKind::writes : AccessKind::reads, number, {}};
    return;
  }
}

/// Adds accesses that use the same pointer as the access at `pc`, and are at most 7 bytes away from it.
void Finder::add_group_by_pointer(std::uint32_t pc) {
  const Instruction& first = at(pc);
  const bool stores = row_of(first.op).stores;
  PointerFlow flow(first);
  std::optional<bool> is_guarded;
  for (std::uint32_t next = pc + first.words; next < pc + kWordsOfAccess && flow.is_known();
       next += at(next).words) {
    const Instruction& i = at(next);
    if (control_of(i.op) != Control::straight) return;
    const auto distance = flow.distance(i);
    flow.follow(i);
    if (!distance || row_of(i.op).stores != stores || std::abs(*distance) >= int{kLargestNumber}) continue;
    if (*distance == 0) return;
    if (!can_be_torn(next)) continue;
    if (!found_.contains(next)) {
      if (!is_guarded)
        is_guarded = !is_sketchs(pc) ||
                     (!stores &&
                      (is_read_again(pc, [&](std::uint32_t place) { return reads_start_of(place, first); }) ||
                       is_called_again(pc)));
      if (*is_guarded) return;
      found_[next] = {2 * next, stores ? AccessKind::writes : AccessKind::reads, std::nullopt, {}};
    }
    found_[next].earlier.push_back(-*distance);
  }
}

/// Returns whether the instruction at `pc` may read the same byte as `first`. Both must use the same pointer
/// and displacement. If the pointer is incremented, `pc` must be the first of several reads.
bool Finder::reads_start_of(std::uint32_t pc, const Instruction& first) const {
  const Instruction& i = at(pc);
  if (i.op != first.op) return false;
  if (row_of(i.op).location == Location::displaced) return i.b == first.b;
  return pc == 0 || row_of(at(pc - 1).op).pointer != row_of(i.op).pointer ||
         !uses_pointer(row_of(at(pc - 1).op));
}

/// Adds an update if the byte that is read at `pc` is changed and written back.
void Finder::add_update(std::uint32_t pc) {
  const Instruction& first = at(pc);
  const bool by_pointer = uses_pointer(row_of(first.op));
  if (row_of(first.op).stores) return;
  std::optional<PointerFlow> flow;
  if (by_pointer) flow.emplace(first);
  ValueFlow trail(first.a);
  for (std::uint32_t next = pc + first.words; next < pc + kWordsOfAccess; next += at(next).words) {
    const Instruction& i = at(next);
    if (control_of(i.op) != Control::straight || (flow && !flow->is_known())) return;
    const bool same = by_pointer ? flow->distance(i) == 0 : i.k == first.k;
    if (row_of(i.op).stores && same && (by_pointer || i.op == Op::sts)) {
      if (trail.is_changed(i.a) && can_be_torn(next) && !found_.contains(next) && is_sketchs(next))
        found_[next] = {2 * next,
                        AccessKind::writes_back,
                        by_pointer ? std::nullopt : numbers_.at(static_cast<std::uint32_t>(i.k)),
                        {0}};
      return;
    }
    trail.follow(i);
    if (flow) flow->follow(i);
  }
}

/// Returns whether the function reads the number twice near `pc`, and then compares two registers and jumps
/// back. The jump leads to the last read, or before it. Such a loop reads the number until two reads agree.
bool Finder::is_read_again(std::uint32_t pc, const Reads& reads) const {
  const Symbol* const function = firmware_.function_at(2 * pc);
  if (!function || function->size == 0) return false;
  const std::uint32_t begin = function->address / 2;
  const std::uint32_t end = std::min(pc + kWordsOfSecondLook, begin + function->size / 2);
  int count = 0;
  std::uint32_t last = 0, compared = 0;
  for (std::uint32_t here = begin; here < end; here += at(here).words) {
    if (here + kWordsOfSecondLook < pc) continue;
    const Instruction& i = at(here);
    // Ignores comparisons with r1, by which avr-gcc 14 tests a register for 0.
    const bool compares_two =
        (i.op == Op::cp || i.op == Op::cpc) && i.a != kZeroRegister && i.b != kZeroRegister;
    if (reads(here))
      ++count, last = here, compared = 0;
    else if (count >= 2 && compares_two)
      compared = here;
    else if (robosim::avr::is_call(i.op))
      compared = 0;
    const bool jumps = control_of(i.op) == Control::jump || control_of(i.op) == Control::branch;
    if (jumps && compared > 0 && here - compared <= kWordsOfJump && target(here) >= begin &&
        target(here) <= last)
      return true;
  }
  return false;
}

/// Returns the distance between the accessed addresses, if both are constants or have the same pointer.
std::optional<int> Finder::distance(const Instruction& from, const Instruction& to) const {
  const InstructionRow &a = row_of(from.op), &b = row_of(to.op);
  if (a.location != b.location || a.pointer != b.pointer) return std::nullopt;
  if (a.location == Location::address) return to.k - from.k;
  if (a.location == Location::displaced) return to.b - from.b;
  return std::nullopt;
}

/// Returns RaceCandidate::guards of the access at `pc`.
std::vector<int> Finder::guards_of(std::uint32_t pc) const {
  std::vector<int> guards;
  const Symbol* const function = firmware_.function_at(2 * pc);
  if (!function || function->size == 0) return guards;
  const std::uint32_t begin = std::max(function->address / 2, pc - std::min(pc, kWordsOfSecondLook));
  const std::uint32_t end = std::min(pc + kWordsOfSecondLook, (function->address + function->size) / 2);
  std::map<int, std::uint32_t> read;  // place of the last read after the access, by distance
  for (std::uint32_t here = pc + at(pc).words; here < end; here += at(here).words) {
    const Instruction& i = at(here);
    if (robosim::avr::is_call(i.op)) read.clear();
    if (const auto away = distance(at(pc), i); away && !row_of(i.op).stores) read[*away] = here;
    const bool jumps = control_of(i.op) == Control::jump || control_of(i.op) == Control::branch;
    if (!jumps || target(here) < begin || target(here) > pc) continue;
    for (std::uint32_t before = target(here); before < pc; before += at(before).words) {
      const auto away = distance(at(pc), at(before));
      const auto again = away ? read.find(*away) : read.end();
      if (again != read.end() && here - again->second <= kWordsOfJump) guards.push_back(*away);
    }
  }
  return guards;
}

/// Returns whether a caller of the function that contains `pc` calls the function again until two results
/// agree. Also returns true if the caller itself is called again in this way.
bool Finder::is_called_again(std::uint32_t pc) {
  const Symbol* const function = firmware_.function_at(2 * pc);
  if (!function) return false;
  const auto [known, is_new] = called_again_.try_emplace(function);
  if (!is_new) return known->second;
  const std::uint32_t entry = function->address / 2;
  const auto calls = [&](std::uint32_t place) {
    return control_of(at(place).op) == Control::call && target(place) == entry;
  };
  const auto [first, last] = calls_.equal_range(entry);
  return known->second = std::any_of(first, last, [&](const auto& call) {
           return is_read_again(call.second, calls) || is_called_again(call.second);
         });
}

}  // namespace

SharedNumbers::SharedNumbers(const Firmware& firmware, const DebugInfo& debug, std::size_t data_size)
    : at_(data_size) {
  const Symbol* variable = nullptr;
  for (DebugInfo::Number& number : debug.numbers()) {
    if (number.address < kAvrData || number.size < 1 || number.size > kLargestNumber) continue;
    const std::uint32_t begin = number.address - kAvrData, end = begin + number.size;
    const bool overlaps = !all_.empty() && begin < end_;
    if (overlaps || end > data_size || all_.size() >= std::numeric_limits<std::uint16_t>::max()) continue;
    if (!variable || number.address >= variable->address + variable->size)
      variable = firmware.symbols.variable_at(number.address);
    if (!variable || end + kAvrData > variable->address + variable->size) continue;
    if (all_.empty()) begin_ = begin;
    end_ = end;
    all_.push_back({begin, number.size, variable, std::move(number.path)});
    std::fill_n(at_.begin() + begin, number.size, static_cast<std::uint16_t>(all_.size()));
  }
}

std::optional<std::size_t> SharedNumbers::at(std::uint32_t address) const {
  if (address >= at_.size() || at_[address] == 0) return std::nullopt;
  return at_[address] - std::size_t{1};
}

std::vector<RaceCandidate> find_race_candidates(const Firmware& firmware, const DebugInfo& debug,
                                                const Cpu& cpu, const SharedNumbers& numbers) {
  return Finder(firmware, debug, cpu, numbers).find();
}

}  // namespace robosim::exec::avr
