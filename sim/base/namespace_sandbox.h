// Implements ProgramSandbox if the kernel has no Landlock (Raspberry Pi OS builds its own without it). Uses a
// separate file system with only the visible files. It takes a user namespace, which needs no root, but must
// be allowed by kernel and container.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim {

class NamespaceSandbox {
 public:
  /// Skips missing paths; everything below a writable path is writable.
  NamespaceSandbox(const std::vector<std::filesystem::path>& read,
                   const std::vector<std::filesystem::path>& write);

  /// Enters it, in a fork before it becomes a program; the working folder is / then. Async-signal-safe.
  /// Returns false on failure.
  bool enter() const;

  /// Returns whether this machine allows it. Determined once, by a fork that tries.
  static bool possible();

 private:
  struct Place {
    std::string path, real;          ///< in the sandbox; below kOld, without links
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
