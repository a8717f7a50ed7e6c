// Takes snapshots of state that changes during a run. The owners of the state register each piece once. The
// registry can then copy and restore all pieces.
//
//   ButtonPart::ButtonPart(PartContext& context) { context.snapshots.add(state_); }
//   const SnapshotRegistry::Snapshot before = snapshots.save();   …   snapshots.restore(before);
//
// restore() writes to the pieces' own addresses, so that pointers to pieces stay valid.
#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace robosim {

class SnapshotRegistry {
 public:
  struct Snapshot {
    std::vector<std::byte> bytes;
    std::vector<std::any> values;  ///< copies of pieces that are not trivially copyable
  };

  /// Registers `state`, which must outlive this object.
  template <typename State>
  void add(State& state) {
    if constexpr (std::is_trivially_copyable_v<State>) {
      add_bytes(&state, sizeof state);
    } else {
      values_.push_back({&state, [](const void* from) { return std::any(*static_cast<const State*>(from)); },
                         [](void* to, const std::any& value) {
                           *static_cast<State*>(to) = std::any_cast<const State&>(value);
                         }});
    }
  }
  /// Registers memory of a fixed size.
  void add_memory(std::span<std::uint8_t> memory) { add_bytes(memory.data(), memory.size()); }

  Snapshot save() const;
  /// Restores all pieces from a snapshot.
  void restore(const Snapshot& copy);

 private:
  struct Bytes {
    std::byte* begin;
    std::size_t size;
  };
  struct Value {
    void* at;
    std::any (*copy)(const void* from);
    void (*restore)(void* to, const std::any& value);
  };

  void add_bytes(void* begin, std::size_t size);

  std::vector<Bytes> bytes_;
  std::vector<Value> values_;
  std::size_t size_ = 0;
};

}  // namespace robosim
