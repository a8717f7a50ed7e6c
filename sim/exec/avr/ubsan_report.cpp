#include "sim/exec/avr/ubsan_report.h"

#include <array>
#include <cstring>

namespace robosim::exec::avr {
namespace {

constexpr reg::Address kWord = 2, kLocation = 3 * kWord;

/// Reads words, integers and texts from the chip's memory, where gcc has stored data about a check.
class Memory {
 public:
  explicit Memory(const WatchedChip& chip) : chip_(chip) {}

  std::uint16_t word(unsigned at) const { return static_cast<std::uint16_t>(bytes(at, kWord)); }
  std::uint64_t bytes(unsigned at, unsigned count) const {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < count; ++i)
      value |= std::uint64_t{chip_.data(static_cast<reg::Address>(at + i))} << (8 * i);
    return value;
  }
  std::string text(unsigned at) const {
    std::string text;
    for (; text.size() < kLongest; ++at) {
      const char c = static_cast<char>(chip_.data(static_cast<reg::Address>(at)));
      if (c == '\0') break;
      text += c;
    }
    return text;
  }

 private:
  static constexpr std::size_t kLongest = 4096;  // longest path of a source file, in bytes
  const WatchedChip& chip_;
};

/// Converts "'int [6]'" to "'int'". avr-gcc 5 gives the type `int` the name of the first array of `int`.
std::string without_lengths(std::string name) {
  const std::size_t length = name.find(" [");
  return length == name.npos ? name : name.replace(length, name.rfind(']') + 1 - length, "");
}

/// Converts gcc's description of a type from the chip's memory layout to the layout of the host.
class Type {
 public:
  enum class Of { value, array };

  Type(const Memory& memory, unsigned at, Of of) {
    const std::uint16_t head[] = {memory.word(at), memory.word(at + kWord)};
    std::memcpy(storage_.data(), head, sizeof head);
    const std::string whole = memory.text(at + 2 * kWord).substr(0, storage_.size() - sizeof head - 1);
    const std::string name = of == Of::array ? whole : without_lengths(whole);
    std::memcpy(storage_.data() + sizeof head, name.c_str(), name.size() + 1);
    bits_ = head[0] == ubsan::Type::integer ? 1u << (head[1] >> 1 & 7) : head[1];
  }
  const ubsan::Type* get() const { return reinterpret_cast<const ubsan::Type*>(storage_.data()); }
  unsigned bits() const { return bits_; }

  /// Returns a value of this type. If the type is wider than a pointer, `handle` is the address of the value.
  std::uint64_t value(const Memory& memory, std::uint16_t handle) const {
    return bits_ <= 8 * kWord ? handle : memory.bytes(handle, bits_ <= 64 ? bits_ / 8 : 8);
  }

 private:
  alignas(ubsan::Type) std::array<char, 128> storage_{};
  unsigned bits_ = 0;
};

/// Returns the argument by which the host's gcc passes a value to a check's handler. If the value is wider
/// than a pointer, gcc passes the value's address.
std::uintptr_t handle(const std::uint64_t& value, unsigned bits) {
  return bits <= 8 * sizeof(std::uintptr_t) ? static_cast<std::uintptr_t>(value)
                                            : reinterpret_cast<std::uintptr_t>(&value);
}

/// Returns whether the data of a float_cast_overflow check lacks a source location. The data of avr-gcc 5
/// starts with the float's type instead.
bool lacks_location(const Memory& memory, unsigned data) {
  return memory.word(memory.word(data)) == ubsan::Type::floating;
}

}  // namespace

std::optional<Undefined> failed_check(const Firmware& firmware, const WatchedChip& chip, const Fault& fault) {
  const Symbol* const handler =
      fault.kind == Fault::Kind::bad_opcode ? firmware.function_at(fault.pc) : nullptr;
  if (!handler || !handler->name.starts_with(kCheckPrefix)) return std::nullopt;
  std::string check = handler->name.substr(kCheckPrefix.size());
  if (const auto end = check.find("_abort"); end != check.npos) check.erase(end);

  const Memory memory(chip);
  const unsigned data = memory.word(kArgument[0]);
  const bool placed = check != "float_cast_overflow" || !lacks_location(memory, data);
  const unsigned types = data + (placed ? kLocation : 0);
  const bool is_index = check == "out_of_bounds";
  const Type first(memory, memory.word(types), is_index ? Type::Of::array : Type::Of::value);
  const Type second(memory, memory.word(types + kWord), Type::Of::value);
  const Type& of_value = is_index ? second : first;
  const Type& of_other = check == "shift_out_of_bounds" ? second : first;
  const std::uint64_t value = of_value.value(memory, memory.word(kArgument[1]));
  const std::uint64_t other = of_other.value(memory, memory.word(kArgument[2]));

  const std::string file = placed ? memory.text(memory.word(data)) : "";
  const std::uint32_t line = placed ? memory.word(data + kWord) : 0;
  const ubsan::TwoTypes two{{placed ? file.c_str() : nullptr, line, 0}, first.get(), second.get()};
  return explain_undefined(check, &two, handle(value, of_value.bits()), handle(other, of_other.bits()));
}

}  // namespace robosim::exec::avr
