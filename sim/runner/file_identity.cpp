#include "sim/runner/file_identity.h"

#include <sys/stat.h>

#include <algorithm>

namespace robosim::runner {
namespace {

constexpr long long kSecond = 1'000'000'000;       // ns
constexpr long long kCoarse = 3 * kSecond;         // FAT has a resolution of 2 s
constexpr long long kFine = kSecond / 10;          // other file systems' times advance at least every 10 ms
constexpr std::size_t kWritten = 3, kChanged = 5;  // indices of seconds; nanoseconds follow them

}  // namespace

FileIdentity identity_of(const std::filesystem::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0) return {};
  return {static_cast<long long>(s.st_dev),
          static_cast<long long>(s.st_ino),
          s.st_size,
          s.st_mtim.tv_sec,
          s.st_mtim.tv_nsec,
          s.st_ctim.tv_sec,
          s.st_ctim.tv_nsec};
}

bool is_settled(const FileIdentity& identity, long long now) {
  const long long written = kSecond * identity[kWritten] + identity[kWritten + 1];
  const long long changed = kSecond * identity[kChanged] + identity[kChanged + 1];
  const long long grain = written % kSecond == 0 || changed % kSecond == 0 ? kCoarse : kFine;
  return std::max(written, changed) + grain < now;
}

}  // namespace robosim::runner
