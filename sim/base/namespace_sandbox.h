// Implements ProgramSandbox for kernels without Landlock, as on Raspberry Pi OS. Uses a separate file system
// that contains only the visible files. The sandbox requires a user namespace, which does not need root. The
// kernel and the container must allow user namespaces.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim {

class NamespaceSandbox {
 public:
  /// Skips missing paths. Everything below a writable path is writable.
  NamespaceSandbox(const std::vector<std::filesystem::path>& read,
                   const std::vector<std::filesystem::path>& write);

  /// Enters the sandbox. Call this in a fork, before exec. Afterwards the working folder is /.
  /// Async-signal-safe. Returns false on failure.
  bool enter() const;

  /// Returns whether this machine allows the sandbox. The first call tries the sandbox in a fork; later calls
  /// return the same result.
  static bool possible();

 private:
  struct Place {
    std::string path;                ///< in the sandbox
    std::string real;                ///< path of the original in the old root (kOld), without links
    std::vector<std::string> above;  ///< parent folders to create, outermost first
    bool folder = false, writable = false;
    unsigned long flags = 0;  ///< mount flags that a namespace must not change
  };
  void add(const std::filesystem::path& path, bool writable);
  bool show(const Place& place) const;

  std::vector<Place> places_;
  std::string user_map_, group_map_;
};

}  // namespace robosim
