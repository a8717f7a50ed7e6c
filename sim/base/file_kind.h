// Detects the kind of a user's file from its content, for messages about files of the wrong kind.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace robosim {

enum class FileKind { map, robot, checks, fleet, script, sketch, image, recording, log, table };

/// Returns the kind of a file if the content clearly shows it.
std::optional<FileKind> kind_of(std::string_view text);

/// Throws InputError if `text` is clearly of another kind than `wanted`: "a.map: expected a robot file, got a
/// map; give it with --map". Call this after reading the file has failed.
void refuse_other_kind(std::string_view text, FileKind wanted, const std::string& file);

/// Returns the result of `read`. If `read` throws InputError, first calls refuse_other_kind().
template <class Read>
auto read_as(FileKind wanted, std::string_view text, const std::string& file, Read read) {
  try {
    return read();
  } catch (const InputError&) {
    refuse_other_kind(text, wanted, file);
    throw;
  }
}

}  // namespace robosim
