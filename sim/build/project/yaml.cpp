#include "sim/build/project/yaml.h"

#include <fmt/format.h>
#include <yaml.h>

#include <new>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/project/files.h"

namespace robosim::project {
namespace {

const yaml_node_t* as_node(const void* node) { return static_cast<const yaml_node_t*>(node); }

std::string text_of(const yaml_node_t* node) {
  if (!node || node->type != YAML_SCALAR_NODE) return {};
  return {reinterpret_cast<const char*>(node->data.scalar.value), node->data.scalar.length};
}

struct Parser {
  explicit Parser(const std::string& content) {
    if (!yaml_parser_initialize(&yaml)) throw std::bad_alloc();
    yaml_parser_set_input_string(&yaml, reinterpret_cast<const unsigned char*>(content.data()),
                                 content.size());
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  ~Parser() { yaml_parser_delete(&yaml); }
  int line() const { return static_cast<int>(yaml.problem_mark.line) + 1; }

  yaml_parser_t yaml;
};

/// Returns how much an event changes the nesting depth.
int depth_of(yaml_event_type_t type) {
  if (type == YAML_SEQUENCE_START_EVENT || type == YAML_MAPPING_START_EVENT) return 1;
  return type == YAML_SEQUENCE_END_EVENT || type == YAML_MAPPING_END_EVENT ? -1 : 0;
}

// Limits the nesting depth, because libyaml's time is quadratic in it. Ignores invalid YAML, which the caller
// reports.
void check_depth(const std::string& content, const std::filesystem::path& path) {
  constexpr int kDeepestYaml = 64;
  Parser parser(content);
  yaml_event_type_t type = YAML_NO_EVENT;
  for (int depth = 0; type != YAML_STREAM_END_EVENT;) {
    yaml_event_t event;
    if (!yaml_parser_parse(&parser.yaml, &event)) return;
    type = event.type;
    const int line = static_cast<int>(event.start_mark.line) + 1;
    yaml_event_delete(&event);
    depth += depth_of(type);
    if (depth > kDeepestYaml)
      throw InputError({path.string(), line},
                       fmt::format("the YAML is nested too deeply: expected at most {} levels of lists and "
                                   "mappings",
                                   kDeepestYaml));
  }
}

}  // namespace

struct YamlFile::Document {
  mutable yaml_document_t yaml;
  const yaml_node_t* node(int index) const { return yaml_document_get_node(&yaml, index); }
};

YamlFile::YamlFile(const std::filesystem::path& path) : document_(std::make_unique<Document>()) {
  const std::string content = read_file(path, kMostProjectFile_bytes);
  check_depth(content, path);
  Parser parser(content);
  if (!yaml_parser_load(&parser.yaml, &document_->yaml))
    throw InputError(
        {path.string(), parser.line()},
        std::string("not valid YAML: ") + (parser.yaml.problem ? parser.yaml.problem : "it cannot be read"));
}

YamlFile::~YamlFile() { yaml_document_delete(&document_->yaml); }

YamlValue YamlFile::root() const { return {this, yaml_document_get_root_node(&document_->yaml)}; }

int YamlValue::line() const { return node_ ? static_cast<int>(as_node(node_)->start_mark.line) + 1 : 0; }

std::string YamlValue::text() const { return text_of(as_node(node_)); }

std::vector<std::pair<std::string, YamlValue>> YamlValue::members() const {
  std::vector<std::pair<std::string, YamlValue>> all;
  const yaml_node_t* node = as_node(node_);
  if (!node || node->type != YAML_MAPPING_NODE) return all;
  const YamlFile::Document& document = *file_->document_;
  for (const auto* pair = node->data.mapping.pairs.start; pair != node->data.mapping.pairs.top; ++pair)
    all.emplace_back(text_of(document.node(pair->key)), YamlValue(file_, document.node(pair->value)));
  return all;
}

YamlValue YamlValue::operator[](const std::string& key) const {
  for (const auto& [name, value] : members())
    if (name == key) return value;
  return {file_, nullptr};
}

std::vector<YamlValue> YamlValue::items() const {
  std::vector<YamlValue> all;
  const yaml_node_t* node = as_node(node_);
  if (!node || node->type != YAML_SEQUENCE_NODE) return all;
  for (const auto* item = node->data.sequence.items.start; item != node->data.sequence.items.top; ++item)
    all.push_back(YamlValue(file_, file_->document_->node(*item)));
  return all;
}

}  // namespace robosim::project
