#include "sim/project/yaml.h"

#include <yaml.h>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/project/files.h"

namespace robosim::project {
namespace {

const yaml_node_t* as_node(const void* node) { return static_cast<const yaml_node_t*>(node); }

std::string text_of(const yaml_node_t* node) {
  if (!node || node->type != YAML_SCALAR_NODE) return {};
  return {reinterpret_cast<const char*>(node->data.scalar.value), node->data.scalar.length};
}

}  // namespace

struct YamlFile::Document {
  mutable yaml_document_t yaml;
  const yaml_node_t* node(int index) const { return yaml_document_get_node(&yaml, index); }
};

YamlFile::YamlFile(const std::filesystem::path& path) : document_(std::make_unique<Document>()) {
  const std::string content = read_file(path, kMostProjectFile_bytes);
  yaml_parser_t parser;
  if (!yaml_parser_initialize(&parser)) throw std::bad_alloc();
  yaml_parser_set_input_string(&parser, reinterpret_cast<const unsigned char*>(content.data()),
                               content.size());
  const bool good = yaml_parser_load(&parser, &document_->yaml) != 0;
  const Place place{path.string(), static_cast<int>(parser.problem_mark.line) + 1};
  const std::string problem = parser.problem ? parser.problem : "";
  yaml_parser_delete(&parser);
  if (!good) throw InputError(place, "is no YAML: " + problem);
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
