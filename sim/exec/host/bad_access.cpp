#include "sim/exec/host/bad_access.h"

#include <fmt/format.h>

#include <optional>
#include <sstream>

#include "hal/host/addresses.h"

namespace robosim::exec {
namespace {

struct Object {
  std::string what;  ///< "the variable speeds"
  std::uintptr_t begin = 0;
  std::uintptr_t bytes = 0;
};

std::string count(std::uintptr_t bytes) { return fmt::format("{} byte{}", bytes, bytes == 1 ? "" : "s"); }

/// Returns the distance of `address` from `object` in bytes; 0 if `address` is in the object.
std::uintptr_t distance(const Object& object, std::uintptr_t address) {
  if (address < object.begin) return object.begin - address;
  return address < object.begin + object.bytes ? 0 : address - (object.begin + object.bytes);
}

/// Reads a word of the firmware's memory, even where a sanitizer forbids access.
template <typename Word>
__attribute__((no_sanitize("address"))) Word word_at(std::uintptr_t address) {
  return *reinterpret_cast<const volatile Word*>(address);
}

Object object_of(const host::GlobalRecord& global) {
  return {fmt::format("the variable {}", global.name), global.begin, global.bytes};
}

std::optional<Object> global_near(std::uintptr_t address, const std::vector<host::GlobalRecord>& globals) {
  std::optional<Object> nearest;
  for (const host::GlobalRecord& global : globals)
    if (const Object one = object_of(global);
        !nearest || distance(one, address) < distance(*nearest, address))
      nearest = one;
  return nearest;
}

/// Parses the text by which gcc describes a stack frame. The text begins with the number of variables. Each
/// variable has four fields: its offset, its size, the length of the next field, and "name:line".
std::vector<Object> variables(std::uintptr_t frame, const char* text) {
  std::vector<Object> found;
  std::istringstream in(text);
  std::size_t number = 0;
  in >> number;
  for (std::size_t i = 0; i < number; ++i) {
    std::uintptr_t offset = 0, bytes = 0;
    std::size_t length = 0;
    if (!(in >> offset >> bytes >> length)) break;
    std::string name(length, '\0');
    in.get();
    in.read(name.data(), static_cast<std::streamsize>(length));
    name.resize(std::min(name.find(':'), name.size()));
    found.push_back({"the local variable " + name, frame + offset, bytes});
  }
  return found;
}

std::optional<Object> local_near(std::uintptr_t address, MemoryRange stack, std::uintptr_t shadow) {
  constexpr std::uintptr_t kMagic = 0x41B58AB3;  // first word of a frame that gcc describes by a text
  constexpr std::uintptr_t kGrain = 8;
  const auto bottom = reinterpret_cast<std::uintptr_t>(stack.begin);
  std::uintptr_t at = address / kGrain * kGrain;
  const auto mark = [&] { return word_at<std::uint8_t>(at / kGrain + shadow); };
  while (at > bottom && mark() != host::kStackBefore) at -= kGrain;
  while (at > bottom && mark() == host::kStackBefore) at -= kGrain;
  if (at <= bottom) return std::nullopt;
  const std::uintptr_t frame = at + kGrain;
  if (word_at<std::uintptr_t>(frame) != kMagic) return std::nullopt;
  std::optional<Object> nearest;
  for (const Object& one : variables(frame, word_at<const char*>(frame + sizeof(std::uintptr_t))))
    if (!nearest || distance(one, address) < distance(*nearest, address)) nearest = one;
  return nearest;
}

/// Returns a text about the position of the access: the part of the object, or the distance from the object.
std::string relation(const host::BadAccess& access, const Object& object) {
  const std::uintptr_t end = object.begin + object.bytes;
  if (access.address < object.begin) return count(object.begin - access.address) + " before";
  if (access.address < end) return "across the end of";
  if (access.address == end) return "right after";
  return count(access.address - end) + " after";
}

std::string beside(const host::BadAccess& access, const std::string& what,
                   const std::optional<Object>& object) {
  if (!object) return what + " next to a variable";
  return fmt::format("{}, {} {} ({})", what, relation(access, *object), object->what, count(object->bytes));
}

}  // namespace

std::string explain(const host::BadAccess& access, const std::vector<host::GlobalRecord>& globals,
                    MemoryRange stack, std::uintptr_t shadow) {
  const std::string what = fmt::format("{} of {}", access.write ? "write" : "read", count(access.bytes));
  std::optional<Object> block;
  if (access.block != 0) block = Object{"a block from malloc() or new", access.block, access.block_bytes};
  switch (access.mark) {
    case host::kGlobalGap:
      return beside(access, what, global_near(access.first, globals));
    case host::kStackBefore:
    case host::kStackBetween:
    case host::kStackBehind:
      return beside(access, what, local_near(access.first, stack, shadow));
    case host::kArrayBefore:
    case host::kArrayBehind:
      return what + " outside of a local array";
    case host::kOutOfScope: {
      const auto local = local_near(access.first, stack, shadow);
      return fmt::format("{} in {}, which no longer exists: its block has ended", what,
                         local ? local->what : "a local variable");
    }
    case host::kHeapGap:
      return beside(access, what, block);
    case host::kHeapFreed:
      return fmt::format("{} in a block of {} that was freed by free() or delete", what,
                         count(access.block_bytes));
    default:
      return what + " at a place where the sketch has no variable (a wild pointer or index?)";
  }
}

}  // namespace robosim::exec
