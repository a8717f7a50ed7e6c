#include "sim/record/record_png.h"

#include <sys/mman.h>
#include <unistd.h>

#include <system_error>

#include "sim/base/child.h"
#include "sim/base/error.h"

namespace robosim::record {
namespace {

constexpr const char* kPainter = "rsvg-convert";
constexpr const char* kTwice = "--zoom=2";  // doubles the resolution, for today's screens

/// Returns a new file that exists only in memory.
Descriptor nameless() {
  Descriptor file(::memfd_create("robosim", MFD_CLOEXEC));
  if (!file.is_open()) throw std::system_error(errno, std::generic_category(), "memfd_create");
  return file;
}

void put(const Descriptor& file, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t put = ::write(file.get(), text.data() + at, text.size() - at);
    if (put < 0) throw std::system_error(errno, std::generic_category(), "write");
    at += static_cast<std::size_t>(put);
  }
  ::lseek(file.get(), 0, SEEK_SET);
}

std::string all_of(const Descriptor& file) {
  std::string all(static_cast<std::size_t>(::lseek(file.get(), 0, SEEK_END)), '\0');
  const ssize_t got = ::pread(file.get(), all.data(), all.size(), 0);
  if (got < 0) throw std::system_error(errno, std::generic_category(), "read");
  return all;
}

}  // namespace

PngRecorder::PngRecorder(std::filesystem::path path) : SvgRecorder(path), name_(path.string()) {
  if (output_of({kPainter, "--version"}).empty())
    throw ToolMissing(name_ +
                      ": rsvg-convert, which paints .png, is missing; install it (sudo apt install "
                      "librsvg2-bin), or choose .svg");
}

std::string PngRecorder::content(const std::string& svg) const {
  const Descriptor drawn = nameless(), painted = nameless();
  put(drawn, svg);
  ChildStart start;
  start.words = {kPainter, "--unlimited", kTwice};
  start.input = drawn.get();
  start.output = painted.get();
  start.errors = ChildStart::kNothing;
  const Ending ending = Child(start).wait();
  if (!ending.ok()) throw InputError({name_}, "cannot be painted: rsvg-convert " + ending.text());
  return all_of(painted);
}

}  // namespace robosim::record
