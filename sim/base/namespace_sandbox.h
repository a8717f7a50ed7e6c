// ProgramSandbox where the kernel has no Landlock (Raspberry Pi OS builds its own without): a file system of
// its own, in which nothing is but what may be seen. It takes a namespace of users, which needs no root, but
// that the kernel or the container allows it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim {

class NamespaceSandbox {
 public:
  /// Those that are not there are left out; below what may be written everything may be written.
  NamespaceSandbox(const std::vector<std::filesystem::path>& read,
                   const std::vector<std::filesystem::path>& write);

  /// In a fork, before it becomes a program; the working folder is / then. Async-signal-safe. False if it
  /// cannot be.
  bool enter() const;

  /// Whether this machine lets us. Found out once, by a fork that tries.
  static bool possible();

 private:
  struct Place {
    std::string path, real;          ///< as it is to be seen; below kOld, without links
    std::vector<std::string> above;  ///< folders to make for it, outermost first
    bool folder = false, writable = false;
    unsigned long flags = 0;  ///< of its mount, which a namespace may not drop
  };
  void add(const std::filesystem::path& path, bool writable);
  bool show(const Place& place) const;

  std::vector<Place> places_;
  std::string user_map_, group_map_;
};

}  // namespace robosim
