// Finds Arduino libraries by the headers that a sketch includes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

/// A library in one of Arduino's two layouts: with `src/` (sources at any depth), or flat (sources in its
/// root and in `utility/`). A folder with `src/` has the first layout if it has a library.properties, or if
/// its root has no header. PlatformIO allows libraries without library.properties; their headers may also be
/// in `include/`.
struct Library {
  std::string name;     ///< as in library.properties, otherwise the folder's name
  bool named = false;   ///< library.properties contains the name
  std::string version;  ///< as in library.properties; empty = missing
  std::filesystem::path folder;
  std::vector<std::filesystem::path> includes;  ///< folders for -I
  std::vector<std::string> sources;             ///< .cpp and .c, relative to `folder`, sorted
  std::vector<std::string> assembler;           ///< .S files, relative to `folder`, sorted; for a chip only
  std::vector<std::filesystem::path> listed;    ///< folders that were read to find the files
  bool archive =
      false;  ///< library.properties has dot_a_linkage=true: for a chip, only needed objects are linked
};

/// Returns the libraries in `folders` that have this name in library.properties.
std::vector<Library> libraries_called(const std::string& name,
                                      const std::vector<std::filesystem::path>& folders);

/// Returns the folders that may contain a sketch's libraries. The sketch's own folders come first, then the
/// folders that the user has `chosen`. The folders of Robosim, of Arduino's IDE, of Debian's packages and of
/// the `core` follow in this order. Throws InputError if a chosen path is not a folder.
std::vector<std::filesystem::path> library_folders(const std::filesystem::path& sketch,
                                                   const std::vector<std::filesystem::path>& chosen,
                                                   const std::vector<std::filesystem::path>& core);

/// Finds libraries in folders, in the given order. A folder may contain libraries, or be a library.
class LibraryFinder {
 public:
  /// `stand_ins` is a folder of libraries, or empty. Each library in this folder replaces the genuine library
  /// of the same name, which need not be installed.
  explicit LibraryFinder(std::vector<std::filesystem::path> folders,
                         const std::filesystem::path& stand_ins = {});

  /// Returns the library that has `header` in its include folder; null if no library has this header. Within
  /// one folder, prefers the library with the header's name. The next choice is a library whose name begins
  /// with the header's name ("Servo-master"), then the first library in alphabetical order.
  ///
  /// A stand-in replaces a library that has the same name in library.properties. If that file contains no
  /// name, the name of the library's folder must begin with the header's name.
  const Library* find(const std::string& header) const;

  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// Returns the include folders of all libraries.
  std::vector<std::filesystem::path> includes() const;
  /// Returns all folders whose lists of names affect the results.
  std::vector<std::filesystem::path> listed() const;

 private:
  const Library* installed(const std::string& header) const;

  std::vector<std::filesystem::path> folders_;
  std::vector<Library> stand_ins_;
  std::vector<std::vector<Library>> libraries_;  ///< per entry of `folders_`
};

}  // namespace robosim::build
