#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "sim/base/bundle.h"
#include "sim/base/file.h"
#include "sim/build/assembly.h"
#include "sim/build/cache.h"
#include "sim/build/compile.h"
#include "sim/build/core.h"
#include "sim/build/elf_facts.h"
#include "sim/build/libraries.h"
#include "sim/build/messages.h"
#include "sim/build/prototypes.h"
#include "sim/build/sketch.h"
#include "sim/build/source.h"
#include "sim/build/walls.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

/// One build: what has been found and made so far.
class Build {
 public:
  Build(const Sketch& sketch, const Toolchain& toolchain, const Cache& cache, const LibraryFinder& finder,
        const GenuineCore& core)
      : sketch_(sketch), toolchain_(toolchain), cache_(cache), finder_(finder), core_(core), work_(cache) {}

  /// Compiles and links; gives the image, still in the work folder.
  fs::path image() {
    const Object core = core_object(toolchain_, cache_, work_.path());
    inputs_.files = core.inputs;
    compile_all();
    std::vector<fs::path> objects = linked_objects();
    for (const Object& object : objects_)
      inputs_.files.insert(inputs_.files.end(), object.inputs.begin(), object.inputs.end());
    // hal/host's constructors run first; an archive gives what those before it have left open.
    objects.insert(toolchain_.target.archiver.name ? objects.end() : objects.begin(), core.path);
    const fs::path image = work_.path() / (sketch_.name + toolchain_.target.image_ending);
    const auto link = run_walled({link_command(toolchain_, objects, image, work_.path(), places())})[0];
    if (link.status != 0) fail_link(toolchain_, sketch_, objects_, link.output);
    const std::vector<fs::path>& linked = toolchain_.core.linked;
    inputs_.files.insert(inputs_.files.end(), linked.begin(), linked.end());
    inputs_.folders = finder_.listed();
    for (const Library& library : libraries_) {
      inputs_.folders.insert(inputs_.folders.end(), library.listed.begin(), library.listed.end());
      const fs::path properties = library.folder / "library.properties";
      if (fs::exists(properties)) inputs_.files.push_back(properties);
    }
    return image;
  }

  const Inputs& inputs() const { return inputs_; }
  const std::vector<Library>& libraries() const { return libraries_; }
  const std::string& messages() const { return messages_; }
  /// gcov's, of each of the sketch's own sources.
  const std::vector<BundledFile>& notes() const { return notes_; }

 private:
  /// All objects, those of a library that wants it so as an archive.
  std::vector<fs::path> linked_objects() const {
    std::vector<fs::path> linked;
    for (const Object& object : objects_)
      if (object.archive.empty()) linked.push_back(object.path);
    for (const Library& library : libraries_) {
      std::vector<fs::path> members;
      for (const Object& object : objects_)
        if (object.archive == "libraries/" + library.name) members.push_back(object.path);
      if (members.empty()) continue;
      linked.push_back(work_.path() / fmt::format("library{}.a", linked.size()));
      const CommandResult result = run_walled({archive_command(toolchain_, members, linked.back())})[0];
      if (result.status != 0) fail(toolchain_.target, text(result));
    }
    return linked;
  }

  std::vector<CommandResult> run_walled(std::vector<Command> commands) const {
    std::vector<fs::path> read = read_by_all(toolchain_, {sketch_.folder, cache_.folder()});
    for (const Library& library : libraries_) read.push_back(library.folder);
    const Walls walls(read, work_.path());
    for (Command& command : commands) command.walls = &walls;
    return run(commands);
  }

  std::string text(const CommandResult& result) const {
    return readable(toolchain_, sketch_.folder, result.output);
  }

  void compile_all() {
    std::vector<Unit> units;
    if (!sketch_.inos.empty()) units.push_back(ino_unit());
    for (const auto* sources : {&sketch_.sources, &sketch_.assembler})
      for (const std::string& source : *sources) {
        Unit unit = sketch_unit();
        unit.source = source;
        units.push_back(unit);
      }
    std::size_t libraries_taken = 0;
    for (;;) {
      for (; libraries_taken < libraries_.size(); ++libraries_taken) {
        const Library& library = libraries_[libraries_taken];
        for (const std::string& source : library.sources) units.push_back(library_unit(library, source));
        if (!toolchain_.target.chip) continue;
        for (const std::string& source : library.assembler) units.push_back(library_unit(library, source));
      }
      if (units.empty()) return;
      units = compile(units);
    }
  }

  Core::Names places() const {
    Core::Names names = {{work_.path(), "."}, {toolchain_.core.root, toolchain_.core.place}};
    for (const Library& library : libraries_) names.emplace_back(library.folder, "libraries/" + library.name);
    names.emplace_back(sketch_.folder, ".");
    return names;
  }

  Unit sketch_unit() const {
    Unit unit;
    unit.folder = sketch_.folder;
    unit.place = ".";
    unit.includes = {sketch_.folder};
    return unit;
  }

  Unit library_unit(const Library& library, const std::string& source) const {
    Unit unit;
    unit.kind = Unit::Kind::library;
    unit.folder = library.folder;
    unit.place = "libraries/" + library.name;
    unit.archived = library.archive && toolchain_.target.chip;
    unit.source = (library.folder / source).string();
    return unit;
  }

  std::string name_of(const Unit& unit) const {
    if (!unit.input.empty()) return sketch_.inos[0];
    if (unit.kind == Unit::Kind::sketch) return unit.source;
    return unit.place + unit.source.substr(unit.folder.string().size());
  }

  Object object_of(const Unit& unit, const fs::path& path, std::vector<fs::path> inputs) const {
    return {name_of(unit), path, std::move(inputs), unit.archived ? unit.place : ""};
  }

  std::vector<fs::path> include_folders(const Unit& unit) const {
    std::vector<fs::path> folders;
    if (unit.kind == Unit::Kind::sketch) folders.push_back(unit.folder);
    for (const Library& library : libraries_)
      folders.insert(folders.end(), library.includes.begin(), library.includes.end());
    return folders;
  }

  // The .ino files, joined and with prototypes. Preprocessing finds the libraries they include, one at a
  // time.
  Unit ino_unit() {
    const std::string joined = join_inos(sketch_);
    Unit unit = sketch_unit();
    unit.input = work_.path() / "joined.cpp";
    write_file(unit.input, joined);
    const fs::path preprocessed = work_.path() / "preprocessed.cpp";
    for (;;) {
      unit.includes = include_folders(unit);
      const CommandResult result = run_walled({preprocess_command(toolchain_, unit, preprocessed)})[0];
      if (result.status == 0) break;
      if (!add_library_for(result)) fail(toolchain_.target, text(result));
    }
    write_file(unit.input, add_prototypes(joined, read_file(preprocessed), sketch_.inos, work_.path()));
    return unit;
  }

  /// Gives the units that are to be compiled again, because they need a library that was found only now.
  std::vector<Unit> compile(std::vector<Unit> units) {
    std::vector<Command> commands;
    std::vector<fs::path> objects;
    std::vector<std::string> keys;
    std::vector<std::size_t> slots;
    std::vector<Unit> started;
    for (Unit& unit : units) {
      unit.includes = include_folders(unit);
      const std::string key = unit_key(unit);
      const auto entry = is_kept(unit) ? cache_.find(key) : std::nullopt;
      if (entry) {
        add_message(entry->facts.at("messages"));
        objects_.push_back(object_of(unit, entry->result, split_paths(entry->facts.at("inputs"))));
        continue;
      }
      slots.push_back(objects_.size());
      objects_.emplace_back();
      objects.push_back(work_.path() / fmt::format("{}.o", count_++));
      commands.push_back(compile_command(toolchain_, unit, objects.back()));
      keys.push_back(key);
      started.push_back(unit);
    }
    const auto since = fs::file_time_type::clock::now();
    std::vector<CommandResult> results = run_walled(commands);
    assemble(started, objects, results);

    std::vector<Unit> again;
    std::string errors;
    std::vector<std::size_t> unused;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::string messages = text(results[i]);
      if (results[i].status == 0) {
        add_message(messages);
        objects_[slots[i]] = keep(started[i], keys[i], objects[i], messages, since);
        continue;
      }
      unused.push_back(slots[i]);
      if (add_library_for(results[i]))
        again.push_back(started[i]);
      else
        errors += messages + '\n';
    }
    if (!errors.empty()) fail(toolchain_.target, errors.substr(0, errors.size() - 1));
    std::for_each(unused.rbegin(), unused.rend(), [&](std::size_t slot) {
      objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(slot));
    });
    return again;
  }

  /// The second half of a compilation, for those that have succeeded so far.
  void assemble(const std::vector<Unit>& units, const std::vector<fs::path>& objects,
                std::vector<CommandResult>& results) const {
    std::vector<std::size_t> compiled;
    std::vector<Command> commands;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (results[i].status != 0 || !through_assembly(toolchain_, units[i])) continue;
      const fs::path assembly = objects[i].string() + ".s";
      write_file(assembly, with_places_of_asm(call_in_endless_loops(read_file(assembly))));
      compiled.push_back(i);
      commands.push_back(assemble_command(toolchain_, objects[i]));
    }
    const std::vector<CommandResult> assembled = run_walled(commands);
    for (std::size_t i = 0; i < compiled.size(); ++i) {
      results[compiled[i]].status = assembled[i].status;
      results[compiled[i]].output += assembled[i].output;
    }
  }

  /// Whether its object goes into the cache: not that of the joined .ino files, nor one with notes beside it.
  bool is_kept(const Unit& unit) const { return unit.input.empty() && !is_counted(toolchain_, unit); }

  std::string unit_key(const Unit& unit) const {
    return fmt::format("unit\n{}\n{}\n{}\n{}", recipe(toolchain_), unit.folder.string(), unit.source,
                       join_paths(unit.includes));
  }

  Object keep(const Unit& unit, const std::string& key, const fs::path& object, const std::string& messages,
              fs::file_time_type since) {
    std::vector<fs::path> inputs = read_dependencies(object.string() + ".d", unit.folder);
    if (is_counted(toolchain_, unit))
      notes_.push_back({notes_name(unit), read_file(object.string() + ".gcno")});
    if (!is_kept(unit)) return object_of(unit, object, std::move(inputs));
    const Entry entry = cache_.store(key, {inputs, {}}, object, fs::path(unit.source).stem().string() + ".o",
                                     {{"inputs", join_paths(inputs)}, {"messages", messages}}, since);
    return object_of(unit, entry.result, std::move(inputs));
  }

  void add_message(const std::string& message) {
    if (!message.empty()) messages_ += message + '\n';
  }

  /// True if the compilation failed for a header whose library has now been added.
  bool add_library_for(const CommandResult& failed) {
    Place place;
    const std::string header = missing_header(failed.output, &place);
    if (header.empty()) return false;
    place.file = readable(toolchain_, sketch_.folder, place.file);
    const Library* library = finder_.find(header);
    if (!library) fail_without_library(toolchain_, core_, finder_, place, header);
    const bool known = std::any_of(libraries_.begin(), libraries_.end(),
                                   [&](const Library& one) { return one.folder == library->folder; });
    if (!known) libraries_.push_back(*library);
    return true;
  }

  const Sketch& sketch_;
  const Toolchain& toolchain_;
  const Cache& cache_;
  const LibraryFinder& finder_;
  const GenuineCore& core_;
  WorkFolder work_;
  std::vector<Library> libraries_;  ///< in the order in which they were found
  std::vector<Object> objects_;
  std::vector<BundledFile> notes_;
  Inputs inputs_;
  std::string messages_;
  int count_ = 0;
};

/// A product of an image, from the cache or made anew: the image's content is all that it depends on.
fs::path product_of(const Target& target, const Product& product, const Entry& entry, const Cache& cache) {
  const std::string key =
      fmt::format("product\n{}{}\n{}", product.program.name, product.ending, entry.facts.at("image_sha256"));
  if (const auto known = cache.find(key)) return known->result;
  const WorkFolder work(cache);
  const std::string name = entry.result.stem().string() + product.ending;
  const auto since = fs::file_time_type::clock::now();
  const CommandResult result = run(product_command(target, product, entry.result, work.path() / name));
  if (result.status != 0) check_machine(product.program.name, result.output);
  if (result.status != 0) throw std::runtime_error(product.program.name + (": " + result.output));
  return cache.store(key, {}, work.path() / name, name, {}, since).result;
}

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
  std::string key = fmt::format("image\n{}{}\n", recipe(toolchain), sketch.folder.string());
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.headers})
    key += fmt::format("{}\n", fmt::join(*names, "\n"));
  for (const std::string& name : sketch.assembler) key += fmt::format("{}\n", name);
  return key + join_paths(folders);
}

}  // namespace

Image build(const Request& request) try {
  const Target& target = find_target(request.target);
  if (request.sanitize) check_can_sanitize(request.target);
  if (request.coverage) check_can_cover(request.target);
  const Sketch sketch = read_sketch(request.sketch);
  if (!target.chip && !sketch.assembler.empty())
    throw InputError({sketch.assembler[0]}, "assembler sources are for the chip: build for the target avr");
  const Cache cache(cache_folder());
  const GenuineCore genuine = find_core();
  const Compiler compiler = find_compiler(target);
  Toolchain toolchain{target,
                      compiler,
                      {},
                      core_for(target, request.board, genuine, cache.folder()),
                      request.board,
                      request.warnings,
                      request.sanitize,
                      request.coverage};
  const std::vector<fs::path> folders =
      library_folders(sketch.folder, request.libraries, toolchain.core.libraries);
  const std::string key = image_key(toolchain, sketch, folders);
  if (const auto entry = cache.find(key); entry && (!request.coverage || cache.find(notes_key(*entry))))
    return image_of(target, sketch, *entry, cache, true);

  const auto since = fs::file_time_type::clock::now();
  toolchain.facts = ask(toolchain.compiler, cache.folder());
  const std::string sketch_sha256 = content_sha256(sketch);
  const LibraryFinder finder(folders);
  Build build(sketch, toolchain, cache, finder, genuine);
  const fs::path made = build.image();

  Inputs inputs = build.inputs();
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.assembler, &sketch.headers})
    for (const std::string& name : *names) inputs.files.push_back(sketch.folder / name);
  const std::string bytes = read_file(made);
  const ElfSize size = elf_size(ElfFile(bytes, made.string()));
  std::string libraries;
  for (const Library& library : build.libraries()) libraries += library.name + '\n';
  const std::uint64_t text_bytes = size.text + (target.chip ? size.initialised : 0);
  const Entry entry = cache.store(key, inputs, made, sketch.name + target.image_ending,
                                  {{"sketch_sha256", sketch_sha256},
                                   {"image_sha256", sha256(bytes)},
                                   {"compiler", toolchain.facts.name},
                                   {"libraries", libraries},
                                   {"messages", build.messages()},
                                   {"text_bytes", std::to_string(text_bytes)},
                                   {"data_bytes", std::to_string(size.data)}},
                                  since);
  if (request.coverage) {
    const WorkFolder work(cache);
    write_file(work.path() / "notes", pack(build.notes()));
    cache.store(notes_key(entry), {}, work.path() / "notes", sketch.name + ".notes", {}, since);
  }
  return image_of(target, sketch, entry, cache, false);
} catch (const fs::filesystem_error& error) {
  throw InputError({error.path1().string()}, "cannot be used: " + error.code().message());
}

}  // namespace robosim::build
