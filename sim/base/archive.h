// Packs several small files into one: a line with the name and size of each file, followed by the file's
// bytes.
//
//   Blink.ino.gcda 132\n<132 bytes>helper.cpp.gcda 88\n<88 bytes>
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robosim {

struct ArchivedFile {
  std::string name;  ///< must not contain a line feed
  std::string content;
};

std::string pack(const std::vector<ArchivedFile>& files);
/// Unpacks an archive. Throws InputError if the bytes are not an archive.
std::vector<ArchivedFile> unpack(std::string_view archive);

}  // namespace robosim
