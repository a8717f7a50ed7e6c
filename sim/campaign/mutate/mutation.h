// Defines a small change of a sketch's source. A mutation breaks the sketch like a typical mistake. A neutral
// change must not affect any test.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace robosim::mutate {

/// Replaces the bytes from offset `from` to offset `to` in a file by `now`.
struct Edit {
  std::string file;  ///< relative to the sketch's folder
  std::size_t from = 0, to = 0;
  std::string now;

  friend bool operator==(const Edit&, const Edit&) = default;
};

struct Mutation {
  std::string kind;         ///< "relational", "constant" …; docs/howto/mutation.md lists them
  std::vector<Edit> edits;  ///< in one file, sorted by place; the first has the mutation's place
  int line = 0;             ///< line of the first edit, from 1
  std::string was, now;     ///< for display: the text at the first place, and its replacement

  friend bool operator==(const Mutation&, const Mutation&) = default;
};

/// Return a mutation's place, "sketch.ino:20", its change, "`11` for `10`", and both in one readable line:
///   sketch.ino:20  constant: `11` for `10`
std::string where(const Mutation& mutation);
std::string what(const Mutation& mutation);
std::string described(const Mutation& mutation);

/// Returns `text` with all edits applied.
std::string changed(std::string text, const std::vector<Edit>& edits);

}  // namespace robosim::mutate
