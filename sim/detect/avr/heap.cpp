#include "sim/detect/avr/heap.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/exec/avr/registers.h"

namespace robosim::detect::avr {
namespace {

constexpr SimTime kSettled = kSecond;
constexpr std::size_t kMostGrowths = 4096;
constexpr int kMostPieces = 1024;  // ends the search if the sketch has overwritten the list
constexpr int kTimesInPieces = 3;
// A finding requires this number of growths, and this growth in bytes, in each third of a run.
constexpr int kThirds = 3, kTimesInThird = 3, kBytesInThird = 8;

}  // namespace

Heap::Heap(const RunningProgram& program)
    : program_(program),
      machine_(program.machine),
      malloc_(program.firmware.find("malloc").value_or(0)),
      realloc_(program.firmware.find("realloc").value_or(0)),
      end_(program.firmware.find_variable("__brkval").value_or(0)),
      free_(program.firmware.find_variable("__flp").value_or(0)) {
  if (end_ == 0) return;
  for (const std::uint32_t place : {malloc_, realloc_})
    if (place != 0) machine_.chip().show(*this, place);
}

std::uint16_t Heap::word(reg::Address at) const {
  return static_cast<std::uint16_t>(machine_.chip().data(at) |
                                    machine_.chip().data(static_cast<reg::Address>(at + 1)) << 8);
}

void Heap::visited(std::uint32_t pc, Cycle) {
  if (asked_ && pc == asked_->returns_to && machine_.chip().sp() == asked_->sp) return answered();
  // Ignores calls of malloc() by realloc(). Any other new request replaces the open request, which cannot
  // return any more. This happens after a reset, for example.
  const bool is_within =
      asked_ && machine_.chip().sp() + machine_.chip().spec().return_address_bytes < asked_->sp;
  if (!is_within && (pc == malloc_ || pc == realloc_))
    asked(word(exec::avr::kArgument[pc == realloc_ ? 1 : 0]));
}

void Heap::asked(std::uint16_t bytes) {
  WatchedChip& chip = machine_.chip();
  const auto at = static_cast<reg::Address>(chip.sp() + 1);
  const int address_bytes = chip.spec().return_address_bytes;
  asked_ = {chip.return_address(at), static_cast<std::uint16_t>(chip.sp() + address_bytes), bytes};
  if (std::find(returns_.begin(), returns_.end(), asked_->returns_to) != returns_.end()) return;
  returns_.push_back(asked_->returns_to);
  chip.show(*this, asked_->returns_to);
}

Heap::Pieces Heap::pieces() const {
  Pieces all;
  if (free_ == 0) return all;
  const unsigned ram = ram_end(machine_.chip().spec());
  for (unsigned at = word(free_); at != 0 && at + 3 <= ram && all.count < kMostPieces;
       at = word(static_cast<reg::Address>(at + 2))) {
    const int bytes = word(static_cast<reg::Address>(at));
    ++all.count;
    all.bytes += bytes;
    all.largest = std::max(all.largest, bytes);
  }
  return all;
}

void Heap::answered() {
  const Asked asked = *std::exchange(asked_, std::nullopt);
  if (word(exec::avr::kArgument[0]) == 0 && asked.bytes > 0) {
    const Pieces free = pieces();
    seen_.add(
        {result::detector("no_memory"),
         fmt::format("no memory was left for {} bytes{}: a String silently becomes empty or stays "
                     "unchanged, and “new” returns a null pointer",
                     asked.bytes,
                     free.bytes < asked.bytes
                         ? ""
                         : fmt::format(", although {} are free, in {} pieces of which the largest has {},",
                                       free.bytes, free.count, free.largest)),
         "Store less in RAM: print texts instead of joining them, use F(\"…\") for constant texts and a char "
         "array of fixed size for texts that change.",
         program_.diagnosis().where_now(), 1e-9 * static_cast<double>(machine_.now()), 1});
    return;
  }
  const std::uint16_t end = word(end_);
  if ((!growths_.empty() && end <= growths_.back().end) || growths_.size() >= kMostGrowths) return;
  const std::uint16_t before = growths_.empty() ? end : growths_.back().end;
  growths_.push_back({machine_.now(), end});
  grown_at_ = program_.diagnosis().where_now();
  // Excludes a block at the end of the heap, which realloc() enlarges in place.
  if (word(exec::avr::kArgument[0]) >= before && machine_.now() > kSettled) note_pieces(asked.bytes, end);
}

void Heap::note_pieces(int asked, int end) {
  const Pieces free = pieces();
  if (free.bytes < asked) return;
  const int times = in_pieces_ ? in_pieces_->times + 1 : 1;
  const double now_s = 1e-9 * static_cast<double>(machine_.now());
  const double first_s = in_pieces_ ? in_pieces_->first_s : now_s;
  if (free.bytes > worst_bytes_) {
    worst_bytes_ = free.bytes;
    in_pieces_ = {
        result::detector("heap_in_pieces"),
        fmt::format("the heap grew to hold {} more bytes, although {} of its bytes were free, in {} pieces "
                    "of at most "
                    "{} bytes; {} bytes are left between the heap and the stack",
                    asked, free.bytes, free.count, free.largest,
                    std::max(0, machine_.chip().lowest_sp() - end)),
        "Texts of many lengths, some stored and some temporary, leave holes: reserve() each stored text "
        "once, in setup(), or store it in a char array of fixed size. Print temporary texts instead of "
        "joining them.",
        grown_at_,
        first_s,
        times};
  }
  in_pieces_->times = times;
}

std::optional<Detected> Heap::growth() const {
  const SimTime span = machine_.now() - kSettled;
  if (growths_.empty() || span <= 0) return std::nullopt;
  int times[kThirds] = {}, bytes[kThirds] = {};
  std::uint16_t before = growths_.front().end;
  for (const Growth& growth : growths_) {
    if (growth.at > kSettled) {
      const auto third =
          static_cast<std::size_t>(std::min<SimTime>((growth.at - kSettled) * kThirds / span, kThirds - 1));
      ++times[third];
      bytes[third] += growth.end - before;
    }
    before = growth.end;
  }
  for (int third = 0; third < kThirds; ++third)
    if (times[third] < kTimesInThird || bytes[third] < kBytesInThird) return std::nullopt;
  const int grown = bytes[0] + bytes[1] + bytes[2];
  const double rate = grown / (1e-9 * static_cast<double>(span));
  const double left = std::max(0, machine_.chip().lowest_sp() - growths_.back().end);
  Detected seen;
  seen.detector = result::detector("heap_grows");
  seen.what = fmt::format(
      "the heap has grown by {} bytes, {:.0f} each second, and keeps growing: it will reach the stack in "
      "about {:.0f} s",
      grown, rate, left / rate);
  seen.mend =
      "Print a text instead of storing it, or store it in a char array of fixed size; reserve() once, in "
      "setup(); delete everything that “new” has created.";
  seen.where = grown_at_;
  seen.first_s = 1e-9 * static_cast<double>(growths_.front().at);
  seen.times = times[0] + times[1] + times[2];
  return seen;
}

std::vector<Detected> Heap::found(SimTime) const {
  std::vector<Detected> all = seen_.all();
  if (auto grows = growth())
    all.push_back(std::move(*grows));
  else if (in_pieces_ && in_pieces_->times >= kTimesInPieces)
    all.push_back(*in_pieces_);
  return all;
}

}  // namespace robosim::detect::avr
