// Finds Arduino libraries by the headers that a sketch includes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

/// A library in one of Arduino's two layouts: with `src/` (sources at any depth), or flat (sources in its
/// root and in `utility/`). One with `src/` has a library.properties, or no header in its root, as PlatformIO
/// allows. Then its headers may be in `include/`.
struct Library {
  std::string name;     ///< as in library.properties, else its folder's name
  bool named = false;   ///< by library.properties
  std::string version;  ///< as in library.properties; empty = not there
  std::filesystem::path folder;
  std::vector<std::filesystem::path> includes;  ///< folders for -I
  std::vector<std::string> sources;             ///< .cpp and .c, relative to `folder`, sorted
  std::vector<std::string> assembler;           ///< .S files, relative to `folder`, sorted; for a chip only
  std::vector<std::filesystem::path> listed;    ///< folders that were read to find these
  bool archive =
      false;  ///< library.properties has dot_a_linkage=true: for a chip only needed objects are linked
};

/// Returns the libraries in `folders` with that name in library.properties.
std::vector<Library> libraries_called(const std::string& name,
                                      const std::vector<std::filesystem::path>& folders);

/// Returns where a sketch's libraries can be: in its own folder, and in those that the user has `chosen`.
/// Then follow those of Robosim, of Arduino's IDE, and of the `core`. Throws InputError if a chosen one is
/// not a folder.
std::vector<std::filesystem::path> library_folders(const std::filesystem::path& sketch,
                                                   const std::vector<std::filesystem::path>& chosen,
                                                   const std::vector<std::filesystem::path>& core);

/// Looks up libraries in these folders, in this order. A folder may hold libraries, or be one.
class LibraryFinder {
 public:
  /// `stand_ins`: a folder of libraries that replace others of their names, also missing ones; or empty.
  explicit LibraryFinder(std::vector<std::filesystem::path> folders,
                         const std::filesystem::path& stand_ins = {});

  /// Returns the library that has `header` in its include folder; null if there is none. Within one folder, a
  /// library with the header's name wins, then one whose name begins with it ("Servo-master"), then the first
  /// by name. A stand-in replaces it if library.properties has the same name in both. If that has no name,
  /// the stand-in's folder must have the header's name.
  const Library* find(const std::string& header) const;

  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// Returns all folders whose lists of names affect the answers.
  std::vector<std::filesystem::path> listed() const;

 private:
  const Library* installed(const std::string& header) const;

  std::vector<std::filesystem::path> folders_;
  std::vector<Library> stand_ins_;
  std::vector<std::vector<Library>> libraries_;  ///< per entry of `folders_`
};

}  // namespace robosim::build
