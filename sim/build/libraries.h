// Arduino libraries, found by the headers that a sketch includes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

/// A library in one of Arduino's two layouts: with `src/` (sources at any depth), or flat (sources in its
/// root and in `utility/`). One with `src/` has a library.properties, or no header in its root, as PlatformIO
/// allows; then it may have its headers in `include/`.
struct Library {
  std::string name;     ///< as library.properties says, else its folder's name
  bool named = false;   ///< library.properties says it
  std::string version;  ///< as library.properties says; empty = it does not
  std::filesystem::path folder;
  std::vector<std::filesystem::path> includes;  ///< folders for -I
  std::vector<std::string> sources;             ///< .cpp and .c, relative to `folder`, sorted
  std::vector<std::string> assembler;           ///< .S, likewise, for a chip only
  std::vector<std::filesystem::path> listed;    ///< folders that were read to find these
  bool archive =
      false;  ///< library.properties has dot_a_linkage=true: for a chip only what is needed is linked
};

/// The libraries in `folders` that library.properties calls so.
std::vector<Library> libraries_called(const std::string& name,
                                      const std::vector<std::filesystem::path>& folders);

/// Where the libraries of a sketch are: in its own folder, in the folders that the user has `chosen`, in
/// Robosim, where Arduino's IDE keeps them, and the `core`'s. Throws InputError for a chosen one that is no
/// folder.
std::vector<std::filesystem::path> library_folders(const std::filesystem::path& sketch,
                                                   const std::vector<std::filesystem::path>& chosen,
                                                   const std::vector<std::filesystem::path>& core);

/// Where libraries are looked for, in this order. A folder may hold libraries, or be one.
class LibraryFinder {
 public:
  /// `stand_ins`: a folder of libraries that are taken instead of others of their names, and where there is
  /// none; or empty.
  explicit LibraryFinder(std::vector<std::filesystem::path> folders,
                         const std::filesystem::path& stand_ins = {});

  /// The library that has `header` in its include folder. Within one folder of libraries a library of the
  /// header's own name wins, then one whose name begins with it ("Servo-master"), then the first by name.
  /// A stand-in is taken instead of it if library.properties calls both the same, or it has none and its
  /// folder has the header's name. Null if there is none.
  const Library* find(const std::string& header) const;

  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// All folders whose list of names the answers depend on.
  std::vector<std::filesystem::path> listed() const;

 private:
  const Library* installed(const std::string& header) const;

  std::vector<std::filesystem::path> folders_;
  std::vector<Library> stand_ins_;
  std::vector<std::vector<Library>> libraries_;  ///< for each of `folders_`
};

}  // namespace robosim::build
