// Builds an image: compiles the sketch, its libraries and the core, and links the objects (sketch.h).
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <system_error>

#include "sim/base/archive.h"
#include "sim/base/file.h"
#include "sim/build/arithmetic_warnings.h"
#include "sim/build/assembly.h"
#include "sim/build/cache.h"
#include "sim/build/clock_warnings.h"
#include "sim/build/compile.h"
#include "sim/build/condition_warnings.h"
#include "sim/build/core.h"
#include "sim/build/elf_facts.h"
#include "sim/build/image_cache.h"
#include "sim/build/indentation_warnings.h"
#include "sim/build/libraries.h"
#include "sim/build/messages.h"
#include "sim/build/narrow_ints.h"
#include "sim/build/pin_warnings.h"
#include "sim/build/project.h"
#include "sim/build/prototypes.h"
#include "sim/build/retry_reason.h"
#include "sim/build/sketch.h"
#include "sim/build/source.h"
#include "sim/build/static_checks.h"
#include "sim/build/units.h"
#include "sim/build/vector_hints.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

/// Maximum size of a preprocessed sketch that is checked for mistakes. Larger sketches need too much memory.
constexpr std::size_t kMostChecked_bytes = std::size_t{4} << 20;

/// The state of one build.
class Build {
 public:
  Build(const Sketch& sketch, const Toolchain& toolchain, const Cache& cache, const LibraryFinder& finder,
        const GenuineCore& core)
      : sketch_(sketch),
        toolchain_(toolchain),
        cache_(cache),
        finder_(finder),
        core_(core),
        work_(cache),
        checks_(static_checks(toolchain, core, cache.folder())) {
    shared_ = shared_files(sketch, toolchain.untrusted ? sketch.folder : reach_of(sketch.folder));
  }

  /// Compiles and links. Returns the image, which is in the linker's scratch folder.
  fs::path image() {
    const Object core = core_object(toolchain_, cache_, work_);
    inputs_.files = core.inputs;
    compile_all();
    if (keeps_addresses_) throw RetryReason{Registers::memory};
    std::vector<fs::path> objects = linked_objects();
    for (const Object& object : objects_)
      for (const fs::path& input : object.inputs) inputs_.files.push_back(input);
    // The constructors of hal/host must run first. An archive must follow the objects whose symbols it
    // resolves.
    objects.insert(toolchain_.target.archiver.name ? objects.end() : objects.begin(), core.path);
    const fs::path image = work_.scratch() / (std::string("image") + toolchain_.target.image_ending);
    const auto names = names_of_folders(sketch_, libraries_, toolchain_, image.parent_path());
    const auto link = run_walled({link_command(toolchain_, objects, image, names)}, objects)[0];
    if (link.status != 0)
      fail_or_try_as_avr([&] { fail_link(toolchain_, core_, sketch_, objects_, own_lines_, link.output); });
    for (const fs::path& linked : toolchain_.core.linked) inputs_.files.push_back(linked);
    inputs_.folders = finder_.listed();
    for (const Library& library : libraries_) {
      inputs_.folders.insert(inputs_.folders.end(), library.listed.begin(), library.listed.end());
      if (const fs::path properties = library.folder / "library.properties"; fs::exists(properties))
        inputs_.files.push_back(properties);
    }
    return image;
  }

  const Inputs& inputs() const { return inputs_; }
  const std::vector<Library>& libraries() const { return libraries_; }
  const std::string& messages() const { return messages_; }
  /// Returns gcov's notes on each of the sketch's own sources.
  const std::vector<ArchivedFile>& notes() const { return notes_; }

 private:
  /// Returns all objects. If a library requests an archive, its objects become one archive.
  std::vector<fs::path> linked_objects() {
    std::vector<fs::path> linked;
    for (const Object& object : objects_)
      if (object.archive.empty()) linked.push_back(object.path);
    for (const Library& library : libraries_) {
      std::vector<fs::path> members;
      for (const Object& object : objects_)
        if (object.archive == "libraries/" + library.name) members.push_back(object.path);
      if (members.empty()) continue;
      linked.push_back(work_.scratch() / fmt::format("library{}.a", linked.size()));
      const auto result = run_walled({archive_command(toolchain_, members, linked.back())}, members)[0];
      if (result.status != 0) fail(toolchain_, text(result));
    }
    return linked;
  }

  /// Runs the commands in sandboxes. The commands can read `objects`, but no other outputs of earlier
  /// commands.
  std::vector<CommandResult> run_walled(std::vector<Command> commands,
                                        const std::vector<fs::path>& objects = {}) const {
    std::vector<fs::path> read = read_by_all(toolchain_, shared_);
    for (const auto* more : {&sketch_.includes, &objects})
      read.insert(read.end(), more->begin(), more->end());
    read.insert(read.end(), {sketch_.folder, work_.given()});
    for (const Library& library : libraries_) read.push_back(library.folder);
    return run_within(read, std::move(commands));
  }

  std::string text(const CommandResult& result) const {
    return readable(toolchain_, sketch_.folder, result.output);
  }

  /// Calls `fail`, which throws an error. If libraries are used, may throw a RetryReason instead. The program
  /// is then compiled as for an AVR, because a library may declare the missing names only for an AVR.
  template <typename Fail>
  void fail_or_try_as_avr(Fail fail, bool about_library = false) const {
    if (libraries_.empty() || toolchain_.target.as_avr.empty() || toolchain_.registers == Registers::as_avr)
      fail();
    try {
      fail();
    } catch (const InputError&) {
      throw RetryReason{Registers::as_avr, about_library ? nullptr : std::current_exception()};
    }
  }

  /// Throws an error. Throws a RetryReason if the program may compile with another kind of registers (enum
  /// Registers), or with 16-bit ints. Libraries, and programs that store a register's address, may need
  /// another kind of registers.
  void fail_or_try_again(const std::string& messages) const {
    const bool objects = !toolchain_.target.memory.empty() && toolchain_.registers == Registers::objects;
    if (objects && messages.find(kRegisterClass) != std::string::npos) throw RetryReason{Registers::memory};
    if (!toolchain_.target.chip && !toolchain_.narrow_ints && wants_narrow_ints(messages)) try {
        fail(toolchain_, messages);
      } catch (const InputError&) {
        throw RetryReason{toolchain_.registers, std::current_exception(), true};
      }
    fail_or_try_as_avr([&] { fail(toolchain_, messages); }, is_about_library(messages, libraries_));
  }

  void compile_all() {
    std::vector<Unit> units;
    if (!sketch_.inos.empty()) units.push_back(ino_unit());
    for (const auto* sources : {&sketch_.sources, &sketch_.assembler})
      for (const std::string& source : *sources) {
        Unit unit = sketch_unit(sketch_);
        unit.source = source;
        units.push_back(unit);
      }
    std::size_t libraries_taken = 0;
    for (;;) {
      for (; libraries_taken < libraries_.size(); ++libraries_taken) {
        const Library& library = libraries_[libraries_taken];
        for (const auto* sources : {&library.sources, &library.assembler})
          for (const std::string& source : *sources)
            if (sources == &library.sources || toolchain_.target.chip)
              units.push_back(library_unit(toolchain_, library, source));
      }
      if (units.empty()) return;
      units = compile(units);
    }
  }

  Object object_of(const Unit& unit, const fs::path& path, std::vector<fs::path> inputs) const {
    return {name_of(sketch_, unit), path, std::move(inputs), unit.archived ? unit.place : ""};
  }

  // Joins the .ino files and adds prototypes. Preprocessing finds the included libraries one at a time.
  Unit ino_unit() {
    const std::string whole = join_inos(sketch_);
    const std::string joined = toolchain_.narrow_ints ? with_narrow_ints(whole) : whole;
    Unit unit = sketch_unit(sketch_);
    unit.input = work_.path() / "joined.cpp";
    write_file(unit.input, joined);
    fs::path preprocessed;
    for (;;) {
      preprocessed = work_.scratch() / "preprocessed.cpp";
      unit.includes = include_folders(unit, libraries_);
      const CommandResult result = run_walled({preprocess_command(toolchain_, unit, preprocessed)})[0];
      if (result.status == 0) break;
      if (!add_library_for(result)) fail_or_try_again(text(result));
    }
    const std::string text = read_made(preprocessed);
    own_lines_ = own_lines(text, sketch_.inos);
    if (toolchain_.warnings != Warnings::none && text.size() <= kMostChecked_bytes) {
      add_message(pin_warnings(own_lines_, toolchain_.board));
      add_message(arithmetic_warnings(own_lines_));
      add_message(condition_warnings(own_lines_));
      add_message(indentation_warnings(whole));
      std::vector<std::string> own_files = sketch_.inos;
      own_files.insert(own_files.end(), sketch_.headers.begin(), sketch_.headers.end());
      add_message(clock_warnings(text, own_files, toolchain_.board));
      if (!toolchain_.target.chip)
        add_message(core_handler_warnings(own_lines_, toolchain_.board, core_.avr_libc));
      add_message(usb_warning(own_lines_, toolchain_.board));
      if (sketch_.sources.empty() && libraries_.empty())
        add_message(serial_warning(own_lines_, text, toolchain_.board));
    }
    write_file(unit.input, add_prototypes(joined, text, sketch_.inos, work_.scratch()));
    ::malloc_trim(0);  // returns memory to the system: the checks of a large sketch free much memory
    return unit;
  }

  /// A unit that must be compiled, because its object is not cached.
  struct Job {
    Unit unit;
    std::string key;
    std::size_t slot;            ///< index in objects_
    fs::path compiled, object;   ///< compiler's output and final object; equal unless through_assembly()
    bool keeps_address = false;  ///< the unit stores a register's address, which `objects` do not have
  };

  /// Returns the warnings of the static checks about each unit that has been compiled. The checks run after
  /// the compilers, because checks and compilers together may take too much memory.
  std::vector<std::string> warnings_of_checks(const std::vector<Job>& jobs,
                                              const std::vector<CommandResult>& results) {
    std::vector<std::string> warnings(jobs.size());
    std::vector<Command> commands;
    std::vector<std::pair<std::size_t, const StaticCheck*>> checks;
    for (std::size_t i = 0; i < jobs.size(); ++i)
      for (const StaticCheck& check : checks_)
        if (results[i].status == 0 && jobs[i].unit.kind == Unit::Kind::sketch) {
          commands.push_back(check.command(jobs[i].unit, work_.scratch()));
          checks.emplace_back(i, &check);
        }
    if (commands.empty()) return warnings;
    const std::vector<CommandResult> checked = run_walled(std::move(commands));
    for (std::size_t k = 0; k < checks.size(); ++k) {
      const auto& [job, check] = checks[k];
      append_line(warnings[job], check->warnings(sketch_, checked[k].output, text(results[job])));
    }
    return warnings;
  }

  /// Compiles the units. Returns the units that must be compiled again, because a library that they need has
  /// just been found.
  std::vector<Unit> compile(std::vector<Unit> units) {
    std::vector<Command> commands;
    std::vector<Job> jobs;
    for (Unit& unit : units) {
      unit.includes = include_folders(unit, libraries_);
      const std::string key = unit_key(toolchain_, unit);
      if (const auto entry = is_cached(toolchain_, unit) ? cache_.find(key) : std::nullopt) {
        add_message(entry->facts.at("messages"));
        keeps_addresses_ |= entry->facts.at("keeps_addresses") == "yes";
        objects_.push_back(
            object_of(unit, work_.give(entry->result), split_paths(entry->facts.at("inputs"))));
        continue;
      }
      const fs::path object = work_.scratch() / fmt::format("{}.o", count_++);
      commands.push_back(compile_command(toolchain_, unit, object));
      jobs.push_back({unit, key, objects_.size(), object, object});
      objects_.emplace_back();
    }
    const auto since = fs::file_time_type::clock::now();
    std::vector<CommandResult> results = run_walled(std::move(commands));
    assemble(jobs, results);
    const std::vector<std::string> warnings = warnings_of_checks(jobs, results);

    std::vector<Unit> again;
    std::string errors;
    std::vector<std::size_t> unused;
    for (std::size_t i = 0; i < results.size(); ++i) {
      std::string messages = text(results[i]);
      if (results[i].status == 0) {
        append_line(messages, warnings[i]);
        check_object(toolchain_, jobs[i].unit, jobs[i].object);
        add_message(messages);
        objects_[jobs[i].slot] = keep(jobs[i], messages, since);
        keeps_addresses_ |= jobs[i].keeps_address;
        continue;
      }
      unused.push_back(jobs[i].slot);
      if (add_library_for(results[i]))
        again.push_back(jobs[i].unit);
      else
        errors += messages + '\n';
    }
    if (!errors.empty()) fail_or_try_again(errors.substr(0, errors.size() - 1));
    std::for_each(unused.rbegin(), unused.rend(), [&](std::size_t slot) {
      objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(slot));
    });
    return again;
  }

  /// Assembles the units that were compiled to assembly without an error.
  void assemble(std::vector<Job>& jobs, std::vector<CommandResult>& results) {
    std::vector<std::size_t> compiled;
    std::vector<Command> commands;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      Job& job = jobs[i];
      if (results[i].status != 0 || !through_assembly(toolchain_, job.unit)) continue;
      const std::string assembly = read_made(compiled_assembly(job.compiled));
      job.keeps_address =
          toolchain_.registers == Registers::objects && assembly.find(kRegisterMemory) != std::string::npos;
      job.object = work_.scratch() / job.compiled.filename();
      const fs::path changed = changed_assembly(job.object);
      write_file(changed, changed_for_host(assembly, quotient_by_zero(toolchain_.board)));
      compiled.push_back(i);
      commands.push_back(assemble_command(toolchain_, changed, job.object));
    }
    const std::vector<CommandResult> assembled = run_walled(commands);
    for (std::size_t i = 0; i < compiled.size(); ++i) {
      if (assembled[i].status != 0) check_changes(jobs[compiled[i]], assembled[i].output);
      results[compiled[i]].status = assembled[i].status;
      results[compiled[i]].output += assembled[i].output;
    }
  }

  /// Throws an internal error if the assembler accepts the compiler's assembly, but rejects the assembly
  /// after Robosim's changes. The sketch is then not to blame.
  void check_changes(const Job& job, const std::string& messages) {
    const fs::path assembly = compiled_assembly(job.compiled), object = work_.scratch() / "unchanged.o";
    if (run_walled({assemble_command(toolchain_, assembly, object)}, {assembly})[0].status == 0)
      fail_for_changes(toolchain_, cache_.folder() / "refused.s",
                       changed_for_host(read_made(assembly), quotient_by_zero(toolchain_.board)), messages);
  }

  Object keep(const Job& job, const std::string& messages, fs::file_time_type since) {
    auto inputs = read_dependencies(read_made(job.compiled.string() + ".d"), job.unit.folder);
    if (is_counted(toolchain_, job.unit))
      notes_.push_back({notes_name(job.unit), read_made(job.compiled.string() + ".gcno")});
    if (!is_cached(toolchain_, job.unit)) return object_of(job.unit, job.object, std::move(inputs));
    const Entry entry = cache_.store(job.key, {inputs, {}}, read_made(job.object),
                                     fs::path(job.unit.source).stem().string() + ".o",
                                     {{"inputs", join_paths(inputs)},
                                      {"messages", messages},
                                      {"keeps_addresses", job.keeps_address ? "yes" : "no"}},
                                     since);
    return object_of(job.unit, work_.give(entry.result), std::move(inputs));
  }

  void add_message(const std::string& message) {
    if (!message.empty()) messages_ += message + '\n';
  }
  static void append_line(std::string& text, const std::string& line) {
    text += (text.empty() || line.empty() ? "" : "\n") + line;
  }

  /// Returns true if the compilation failed because of a missing header and the header's library has now been
  /// added.
  bool add_library_for(const CommandResult& failed) {
    Place place;
    const std::string header = missing_header(failed.output, &place);
    if (header.empty()) return false;
    place.file = without_folders(toolchain_, sketch_.folder, place.file);
    check_seen(sketch_.folder, place, header);
    const Library* library = finder_.find(header);
    if (!library) fail_without_library(toolchain_, core_, finder_, sketch_.folder, place, header);
    if (std::none_of(libraries_.begin(), libraries_.end(),
                     [&](const Library& one) { return one.folder == library->folder; }))
      libraries_.push_back(*library);
    return true;
  }

  const Sketch& sketch_;
  const Toolchain& toolchain_;
  const Cache& cache_;
  const LibraryFinder& finder_;
  const GenuineCore& core_;
  WorkFolder work_;
  const std::vector<StaticCheck> checks_;
  std::vector<fs::path> shared_;
  std::vector<Library> libraries_;  ///< in the order in which they were found
  std::vector<Object> objects_;
  std::vector<ArchivedFile> notes_;
  Inputs inputs_;
  std::string messages_;
  std::string own_lines_;  ///< own_lines() of the preprocessed .ino files
  bool keeps_addresses_ = false;
  int count_ = 0;
};

/// Builds the program with the first kind of registers with which it compiles. Returns the build, and sets
/// `image` to the path of the image.
std::unique_ptr<Build> build_image(const Sketch& sketch, Toolchain& toolchain, const Cache& cache,
                                   const LibraryFinder& finder, const GenuineCore& core, fs::path& image) {
  std::exception_ptr otherwise;
  for (;;) try {
      auto build = std::make_unique<Build>(sketch, toolchain, cache, finder, core);
      image = build->image();
      return build;
    } catch (const RetryReason& better) {
      toolchain.registers = better.with;
      toolchain.narrow_ints |= better.narrow_ints;
      otherwise = better.otherwise;
    } catch (const InputError&) {
      if (otherwise) std::rethrow_exception(otherwise);
      throw;
    }
}

}  // namespace

Image build(const Request& request) try {
  const Target& target = find_target(request.target);
  if (request.sanitize) check_can_sanitize(request.target);
  const Sketch sketch = read_sketch(request.sketch, request.rules);
  if (!target.chip && !sketch.assembler.empty())
    throw InputError({sketch.assembler[0]}, "assembler sources require a chip: build for the target avr");
  const bool counts_itself = request.coverage && !target.chip;  // on a chip, the emulator counts the lines
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
                      counts_itself,
                      Registers::objects,
                      request.untrusted,
                      request.all_messages,
                      request.rules,
                      false,
                      request.core_begins};
  toolchain.static_checks = static_checks_identity(toolchain);
  const std::vector<fs::path> folders =
      library_folders(sketch.folder, request.libraries, toolchain.core.libraries);
  const std::string key = image_key(toolchain, sketch, folders);
  if (const auto entry = cache.find(key); entry && (!counts_itself || cache.find(notes_key(*entry))))
    return image_of(target, sketch, *entry, cache, true);

  const auto since = fs::file_time_type::clock::now();
  toolchain.facts = ask(toolchain.compiler, cache.folder());
  const std::string sketch_sha256 = content_sha256(sketch);
  const LibraryFinder finder(folders, toolchain.core.stand_ins);
  fs::path made;
  const auto build = build_image(sketch, toolchain, cache, finder, genuine, made);
  Inputs inputs = build->inputs();
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.assembler, &sketch.headers})
    for (const std::string& name : *names) inputs.files.push_back(sketch.folder / name);
  const std::string bytes = read_made(made);
  const ElfSize size = elf_size(ElfFile(bytes, made.string()));
  std::string libraries;
  for (const Library& library : build->libraries()) libraries += library.name + '\n';
  const Entry entry =
      cache.store(key, inputs, bytes, sketch.name + target.image_ending,
                  {{"sketch_sha256", sketch_sha256},
                   {"image_sha256", sha256(bytes)},
                   {"compiler", toolchain.facts.name},
                   {"libraries", libraries},
                   {"messages", build->messages()},
                   {"text_bytes", std::to_string(size.text + (target.chip ? size.initialised : 0))},
                   {"data_bytes", std::to_string(size.data)}},
                  since);
  if (counts_itself)
    cache.store(notes_key(entry), {}, pack(build->notes()), sketch.name + ".notes", {}, since);
  return image_of(target, sketch, entry, cache, false);
} catch (const fs::filesystem_error& error) {
  const bool is_foreign = error.code() == std::errc::permission_denied;
  throw InputError(
      {error.path1().string()},
      "cannot use the folder: " + error.code().message() +
          (is_foreign ? ": expected a folder that this user can write, for compiled sketches; remove "
                        "it, or set XDG_CACHE_HOME to another folder"
                      : ""));
}

}  // namespace robosim::build
