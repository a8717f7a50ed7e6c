#include "sim/build/image_cache.h"

#include <fmt/format.h>

#include "sim/base/file.h"
#include "sim/build/messages.h"
#include "sim/build/process.h"
#include "sim/build/source.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

/// Returns a product of an image from the cache, or makes it. A product depends only on the image's content.
fs::path product_of(const Target& target, const Product& product, const Entry& entry, const Cache& cache) {
  const std::string key =
      key_of({"product", product.program.name, product.ending, entry.facts.at("image_sha256")});
  if (const auto known = cache.find(key)) return known->result;
  WorkFolder work(cache);
  const std::string name = entry.result.stem().string() + product.ending;
  const auto since = fs::file_time_type::clock::now();
  const fs::path made = work.scratch() / (std::string("product") + product.ending);
  const CommandResult result =
      run_within({work.given()}, {product_command(target, product, work.give(entry.result), made)})[0];
  if (result.status != 0) check_machine(product.program.name, result.output);
  if (result.status != 0) throw CompileError(product.program.name + (": " + result.output));
  return cache.store(key, {}, read_made(made), name, {}, since).result;
}

}  // namespace

const char* seen_by(const Toolchain& toolchain) { return toolchain.untrusted ? "untrusted\n" : ""; }

std::string notes_key(const Entry& entry) { return "notes\n" + entry.facts.at("image_sha256"); }

bool is_cached(const Toolchain& toolchain, const Unit& unit) {
  return unit.input.empty() && !is_counted(toolchain, unit);
}

std::string unit_key(const Toolchain& toolchain, const Unit& unit) {
  return key_of({"unit", recipe(toolchain), seen_by(toolchain),
                 std::to_string(static_cast<int>(toolchain.registers)), unit.folder.string(), unit.source,
                 unit.kind == Unit::Kind::sketch ? toolchain.static_checks : "",
                 key_of(std::vector<std::string>(unit.includes.begin(), unit.includes.end())),
                 key_of(headers_in(unit.folder))});
}

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
  std::vector<std::string> words = {"image", recipe(toolchain), seen_by(toolchain), sketch.folder.string(),
                                    toolchain.static_checks};
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.headers, &sketch.assembler})
    words.push_back(key_of(*names));
  for (const auto* paths : {&sketch.includes, &folders})
    words.push_back(key_of(std::vector<std::string>(paths->begin(), paths->end())));
  words.push_back(key_of(headers_in(sketch.folder)));
  return key_of(words);
}

}  // namespace robosim::build
