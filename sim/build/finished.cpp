#include "sim/build/finished.h"

#include <fmt/format.h>

#include "sim/base/file.h"
#include "sim/build/compile.h"
#include "sim/build/messages.h"
#include "sim/build/process.h"
#include "sim/build/walls.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

/// A product of an image, from the cache or made anew: the image's content is all that it depends on.
fs::path product_of(const Target& target, const Product& product, const Entry& entry, const Cache& cache) {
  const std::string key =
      fmt::format("product\n{}{}\n{}", product.program.name, product.ending, entry.facts.at("image_sha256"));
  if (const auto known = cache.find(key)) return known->result;
  const WorkFolder work(cache);
  const std::string name = entry.result.stem().string() + product.ending;
  const auto since = fs::file_time_type::clock::now();
  // Not the image alone: another process that builds the same puts its equal one in this one's place.
  const Walls walls({cache.folder()}, work.path());
  Command command = product_command(target, product, entry.result, work.path() / name);
  command.walls = &walls;
  const CommandResult result = run(command);
  if (result.status != 0) check_machine(product.program.name, result.output);
  if (result.status != 0) throw std::runtime_error(product.program.name + (": " + result.output));
  return cache.store(key, {}, work.path() / name, name, {}, since).result;
}

}  // namespace

const char* seen_by(const Toolchain& toolchain) { return toolchain.untrusted ? "untrusted\n" : ""; }

std::string notes_key(const Entry& entry) { return "notes\n" + entry.facts.at("image_sha256"); }

Image image_of(const Target& target, const Sketch& sketch, const Entry& entry, const Cache& cache,
               bool from_cache) {
  Image image;
  image.name = sketch.name;
  image.image = entry.result;
  for (const Product& product : target.products)
    image.products.push_back(product_of(target, product, entry, cache));
  image.sketch_sha256 = entry.facts.at("sketch_sha256");
  image.image_sha256 = entry.facts.at("image_sha256");
  image.compiler = entry.facts.at("compiler");
  for (const fs::path& library : split_paths(entry.facts.at("libraries")))
    image.libraries.push_back(library.string());
  image.messages = entry.facts.at("messages");
  image.text_bytes = std::stoull(entry.facts.at("text_bytes"));
  image.data_bytes = std::stoull(entry.facts.at("data_bytes"));
  image.from_cache = from_cache;
  if (const auto notes = cache.find(notes_key(entry))) image.notes = notes->result;
  return image;
}

std::string image_key(const Toolchain& toolchain, const Sketch& sketch,
                      const std::vector<fs::path>& folders) {
  std::string key =
      fmt::format("image\n{}{}{}\n", recipe(toolchain), seen_by(toolchain), sketch.folder.string());
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.headers})
    key += fmt::format("{}\n", fmt::join(*names, "\n"));
  for (const std::string& name : sketch.assembler) key += fmt::format("{}\n", name);
  return key + join_paths(sketch.includes) + join_paths(folders);
}

}  // namespace robosim::build
