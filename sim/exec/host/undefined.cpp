#include "sim/exec/host/undefined.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "sim/exec/host/image_file.h"

namespace robosim::exec {
namespace {

using ubsan::Location, ubsan::Type, ubsan::OneType, ubsan::TwoTypes;

struct Mismatch {
  Location at;
  const Type* type;
  std::uint8_t log_alignment;
  std::uint8_t use;  ///< use of the pointer: index into kUses
};

struct Argument {
  Location at;
  Location attribute;
  int number;
};

constexpr const char* kUses[] = {"read of",
                                 "write of",
                                 "reference to",
                                 "access to a member of",
                                 "call of a member function of",
                                 "use of a constructor of",
                                 "conversion of",
                                 "conversion of"};

std::string name(const Type& type) {
  std::string text = type.name;
  if (text.size() >= 2 && text.front() == '\'') text = text.substr(1, text.size() - 2);
  for (const std::string_view word : {"struct ", "class ", "union ", "enum "})
    if (text.starts_with(word)) text.erase(0, word.size());
  return text;
}

std::string with_article(const std::string& text) {
  const bool vowel = !text.empty() && std::string_view("aeiouAEIOU").find(text[0]) != std::string_view::npos;
  return (vowel ? "an " : "a ") + text;
}

std::string a(const Type& type) { return with_article(name(type)); }

int bits(const Type& type) { return type.kind == Type::integer ? 1 << (type.info >> 1) : type.info; }
bool is_signed(const Type& type) { return type.info & 1; }

/// An integer of up to 64 bits.
struct Whole {
  std::uint64_t bits;  // the bits above the type's width are copies of the sign bit
  bool is_signed;
};

/// Returns a value of `bits` bits. `handle` is the value itself or, if the value is wider than a register,
/// its address.
template <typename T>
T stored(std::uintptr_t handle, int bits) {
  T result = 0;
  const auto bytes = static_cast<std::size_t>(bits) / 8;
  if (bytes <= sizeof handle) {
    std::memcpy(&result, &handle, std::min(bytes, sizeof result));
  } else {
    std::memcpy(&result, reinterpret_cast<const void*>(handle), std::min(bytes, sizeof result));
  }
  return result;
}

Whole integer(const Type& type, std::uintptr_t handle) {
  const int width = std::min(bits(type), 64);
  const auto raw = stored<std::uint64_t>(handle, width);
  const std::uint64_t sign = std::uint64_t{1} << (width - 1);
  const std::uint64_t low = raw & (sign - 1 + sign);
  return {is_signed(type) && (low & sign) ? low | ~(sign - 1) : low, is_signed(type)};
}

std::string text(Whole value) {
  return value.is_signed ? fmt::format("{}", static_cast<std::int64_t>(value.bits))
                         : fmt::format("{}", value.bits);
}

std::string range(const Type& type) {
  const std::uint64_t sign = std::uint64_t{1} << (std::min(bits(type), 64) - 1);
  const Whole low{is_signed(type) ? ~(sign - 1) : 0, is_signed(type)};
  const Whole high{is_signed(type) ? sign - 1 : sign - 1 + sign, is_signed(type)};
  return fmt::format("{} to {}", text(low), text(high));
}

std::string does_not_fit(const Type& type) {
  return fmt::format("does not fit {}, which holds {} here", a(type), range(type));
}

std::string number(const Type& type, std::uintptr_t handle) {
  if (type.kind == Type::integer) return text(integer(type, handle));
  if (bits(type) == 32) return fmt::format("{}", stored<float>(handle, 32));
  if (bits(type) == 64) return fmt::format("{}", stored<double>(handle, 64));
  return "number";
}

// If all bytes of a value are 0xFE, returns a remark that the variable may never have been set. The compiler
// fills local variables with 0xFE (sim/build/target.cpp).
std::string if_never_set(const Type& type, std::uintptr_t handle) {
  constexpr std::uintptr_t kFilling = 0xFE;
  const int width = std::min(bits(type), 64);
  const auto raw = stored<std::uint64_t>(handle, width);
  for (int bit = 0; bit < width; bit += 8)
    if ((raw >> bit & 0xFF) != kFilling) return "";
  return width < 16 ? "" : " (a local variable that was never set?)";
}

std::string explain_overflow(const OneType& data, const char* sign, std::uintptr_t left,
                             std::uintptr_t right) {
  return fmt::format("{} {} {} {}", text(integer(*data.type, left)), sign, text(integer(*data.type, right)),
                     does_not_fit(*data.type));
}

std::string explain_division(const OneType& data, std::uintptr_t left, std::uintptr_t right) {
  const bool whole = data.type->kind == Type::integer;
  if (!whole || integer(*data.type, right).bits == 0) return "division by zero";
  return explain_overflow(data, "/", left, right);
}

std::string explain_shift(const TwoTypes& data, std::uintptr_t by) {
  const int width = bits(*data.first);
  return fmt::format("a shift by {} bits, but {} has {} here: 0 to {} are possible",
                     text(integer(*data.second, by)), a(*data.first), width, width - 1);
}

std::string explain_index(const TwoTypes& data, std::uintptr_t index) {
  const std::string array = name(*data.first);
  const std::size_t open = array.find('[');
  const int length = open == array.npos ? 0 : std::atoi(array.c_str() + open + 1);
  std::string valid = "it has no elements";
  if (length > 0) valid = fmt::format("valid indices are 0 to {}", length - 1);
  return fmt::format("index {}{} is outside of the array, {}: {}", text(integer(*data.second, index)),
                     if_never_set(*data.second, index), with_article(array), valid);
}

std::string explain_mismatch(const Mismatch& data, std::uintptr_t address) {
  const std::uintptr_t alignment = std::uintptr_t{1} << data.log_alignment;
  const std::string use =
      fmt::format("{} {}", data.use < std::size(kUses) ? kUses[data.use] : "use of", a(*data.type));
  if (address == 0) return use + " through a null pointer";
  if (address % alignment != 0)
    return fmt::format(
        "{} at an address that is not a multiple of {} (the Uno accepts it, other chips do not)", use,
        alignment);
  return use + " at an address with too little memory for it";
}

std::string explain_pointer(std::uintptr_t base, std::uintptr_t result) {
  if (base == 0) return "arithmetic with a null pointer";
  if (result == 0) return "a pointer became null by arithmetic";
  return "arithmetic moved a pointer beyond the end of memory";
}

std::string explain_value(const OneType& data, std::uintptr_t value) {
  const std::string allowed = name(*data.type) == "bool" ? "only 0 and 1 are possible" : "none of its values";
  return fmt::format("{} holds {}{}: {}", a(*data.type), text(integer(*data.type, value)),
                     if_never_set(*data.type, value), allowed);
}

std::string explain_conversion(const TwoTypes& data, std::uintptr_t value) {
  return fmt::format("{} {}{} {}", name(*data.first), number(*data.first, value),
                     if_never_set(*data.first, value), does_not_fit(*data.second));
}

std::string reason(std::string_view check, const void* data, std::uintptr_t value, std::uintptr_t other) {
  const auto& one = *static_cast<const OneType*>(data);
  const auto& two = *static_cast<const TwoTypes*>(data);
  if (check == "divrem_overflow") return explain_division(one, value, other);
  if (check == "add_overflow") return explain_overflow(one, "+", value, other);
  if (check == "sub_overflow") return explain_overflow(one, "-", value, other);
  if (check == "mul_overflow") return explain_overflow(one, "*", value, other);
  if (check == "negate_overflow")
    return fmt::format("-({}) {}", text(integer(*one.type, value)), does_not_fit(*one.type));
  if (check == "shift_out_of_bounds") return explain_shift(two, other);
  if (check == "out_of_bounds") return explain_index(two, value);
  if (check == "type_mismatch_v1") return explain_mismatch(*static_cast<const Mismatch*>(data), value);
  if (check == "pointer_overflow") return explain_pointer(value, other);
  if (check == "load_invalid_value") return explain_value(one, value);
  if (check == "float_cast_overflow") return explain_conversion(two, value);
  if (check == "vla_bound_not_positive")
    return fmt::format("an array of {} elements", text(integer(*one.type, value)));
  if (check == "missing_return") return "the function should return a value, but ends without return";
  if (check == "nonnull_arg")
    return fmt::format("argument {} is a null pointer, which is not allowed",
                       static_cast<const Argument*>(data)->number);
  if (check == "builtin_unreachable") return "a place that the program marks as never reached";
  return fmt::format("undefined behaviour ({})", check);
}

}  // namespace

Undefined explain_undefined(std::string_view check, const void* data, std::uintptr_t value,
                            std::uintptr_t other) {
  const auto& at = *static_cast<const Location*>(data);
  Undefined found{std::string(check), reason(check, data, value, other), "", 0};
  if (at.file) {
    found.file = at.file;
    found.line = static_cast<int>(at.line);
  }
  return found;
}

void take_place(const Undefined& fault, SourceLine& place) {
  if (is_own_file(fault.file)) return;
  place.file = fault.file.starts_with("./") ? fault.file.substr(2) : fault.file;
  place.line = fault.line;
}

}  // namespace robosim::exec
