#include "sim/campaign/wiring/source_blocks.h"

#include <algorithm>
#include <utility>

namespace robosim::wiring {
namespace {

constexpr int kDeepest = 300;                   // maximum depth of nested blocks and of else-if branches
constexpr std::size_t kLongestHead = 400;       // maximum number of tokens in a function's head
constexpr std::size_t kMostCopied = 1'000'000;  // maximum number of tokens in all conditions of a source

class BlockReader {
 public:
  explicit BlockReader(const Tokens& tokens) : tokens_(tokens) {}

  std::vector<Block> run() {
    while (at_ < tokens_.size() && copied_ < kMostCopied) {
      if (tokens_[at_].kind == Token::Kind::define)
        skip_define();
      else if (is_function())
        read_function();
      else if (is("{") && at_ > 0 && tokens_[at_ - 1].is("="))
        skip_pair("{", "}");
      else
        ++at_;
    }
    return std::move(blocks_);
  }

 private:
  bool is(std::string_view text, std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].is(text);
  }
  bool is_word(std::size_t ahead) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].kind == Token::Kind::word;
  }
  int line() const { return at_ < tokens_.size() ? tokens_[at_].line : 0; }

  void skip_define() {
    while (at_ < tokens_.size() && !is(kEndOfDefine)) ++at_;
  }

  // Returns the index after the pair of brackets that begins at `from`.
  std::size_t after_pair(std::size_t from, const char* open, const char* close,
                         std::size_t most = std::string::npos) const {
    int depth = 0;
    for (std::size_t i = from; i < tokens_.size() && i - from < most; ++i) {
      if (tokens_[i].is(open)) ++depth;
      if (tokens_[i].is(close) && --depth == 0) return i + 1;
    }
    return tokens_.size();
  }
  void skip_pair(const char* open, const char* close) { at_ = after_pair(at_, open, close); }

  // Returns whether `name(…) {` is next. A constructor's initialisers may precede the brace.
  bool is_function() const {
    if (!is_word(0) || !is("(", 1)) return false;
    std::size_t i = after_pair(at_ + 1, "(", ")", kLongestHead);
    const std::size_t end = std::min(i + kLongestHead, tokens_.size());
    while (i < end && !tokens_[i].is("{") && !tokens_[i].is(";") && !tokens_[i].is("=") &&
           !tokens_[i].is("}"))
      ++i;
    return i < end && tokens_[i].is("{");
  }

  void read_function() {
    const std::size_t first_block = blocks_.size();
    Block head;
    head.function = tokens_[at_].text;
    head.function_begin = at_;
    const std::size_t end = after_pair(at_ + 1, "(", ")");
    for (std::size_t i = at_ + 2; i < end; ++i)
      if ((tokens_[i].is(",") || i + 1 == end) && tokens_[i - 1].kind == Token::Kind::word)
        head.parameters.emplace_back(tokens_[i - 1].text);
    at_ = end;
    while (at_ < tokens_.size() && !is("{")) ++at_;
    read_body(head, 0);
    for (std::size_t i = first_block; i < blocks_.size(); ++i) blocks_[i].function_end = at_;
  }

  // Reads a block with its braces, or one statement.
  void read_body(const Block& head, int depth) {
    Block block = head;
    block.first_line = line();
    const bool has_braces = is("{");
    if (has_braces) ++at_;
    while (at_ < tokens_.size() && !is("}")) {
      read_statement(block, depth);
      if (!has_braces) break;
    }
    block.last_line = line();
    if (has_braces && at_ < tokens_.size()) ++at_;
    add(block);
  }

  void add(const Block& block) {
    if (!block.statements.empty()) blocks_.push_back(block);
  }

  void read_statement(Block& block, int depth) {
    if (depth > kDeepest || copied_ >= kMostCopied) {
      ++at_;
    } else if (tokens_[at_].kind == Token::Kind::define) {
      skip_define();
    } else if (is("if") && is("(", 1)) {
      read_if(block, depth);
    } else if ((is("while") || is("switch")) && is("(", 1)) {
      Block inner = without_statements(block);
      inner.conditions.push_back(condition());
      read_body(inner, depth + 1);
    } else if (is("for") && is("(", 1)) {
      ++at_;
      skip_pair("(", ")");
      read_body(without_statements(block), depth + 1);
    } else if (is("{")) {
      read_body(without_statements(block), depth + 1);
    } else if (is("else") || is("do")) {
      ++at_;
    } else if (is("case") || is("default")) {
      read_case(block);
    } else {
      read_plain(block);
    }
  }

  // Copies a block without its statements. Counts the copied tokens, because nested blocks with long
  // conditions could take too much memory.
  Block without_statements(const Block& block) {
    Block inner = block;
    inner.statements.clear();
    inner.has_case = false;
    for (const Condition& condition : inner.conditions) copied_ += condition.tokens.size() + 1;
    return inner;
  }

  // Reads `if (…) … else …`.
  void read_if(Block& block, int depth) {
    Block inner = without_statements(block);
    inner.conditions.push_back(condition());
    read_body(inner, depth + 1);
    if (!is("else")) return;
    ++at_;
    inner.conditions.back().is_negated = true;
    if (is("if"))
      read_statement(inner, depth + 1);
    else
      read_body(inner, depth + 1);
  }

  // Begins another block at `case 'F':`.
  void read_case(Block& block) {
    Block done = block;
    done.last_line = line();
    add(done);
    block.statements.clear();
    block.first_line = line();
    const bool is_default = is("default");
    Tokens label;
    for (++at_; at_ < tokens_.size() && !is(":"); ++at_) label.push_back(tokens_[at_]);
    if (at_ < tokens_.size()) ++at_;
    if (block.has_case) block.conditions.pop_back();
    block.has_case = !is_default && !block.conditions.empty();
    if (!block.has_case) return;
    // Treats the label as a comparison with the value of the switch.
    Condition condition = block.conditions.back();
    condition.line = block.first_line;
    const Token equal{"=", {}, block.first_line};
    condition.tokens.insert(condition.tokens.end(), {equal, equal});
    condition.tokens.insert(condition.tokens.end(), label.begin(), label.end());
    block.conditions.push_back(std::move(condition));
  }

  void read_plain(Block& block) {
    Statement statement{{}, line()};
    int depth = 0;
    for (; at_ < tokens_.size(); ++at_) {
      if (depth == 0 && (is(";") || is("}"))) break;
      if (is("(") || is("{") || is("[")) ++depth;
      if (is(")") || is("}") || is("]")) --depth;
      statement.tokens.push_back(tokens_[at_]);
    }
    if (is(";")) ++at_;
    if (!statement.tokens.empty()) block.statements.push_back(std::move(statement));
  }

  // Reads the word and the condition of `if (…)`.
  Condition condition() {
    ++at_;
    Condition one{{}, false, line()};
    const std::size_t end = after_pair(at_, "(", ")");
    for (std::size_t i = at_ + 1; i + 1 < end; ++i) one.tokens.push_back(tokens_[i]);
    at_ = end;
    return one;
  }

  const Tokens& tokens_;
  std::size_t at_ = 0;
  std::size_t copied_ = 0;
  std::vector<Block> blocks_;
};

// Finds the functions that run: setup(), loop(), and each function whose name is in running code.
class RunningCode {
 public:
  explicit RunningCode(std::vector<SourceText>& sources) {
    for (SourceText& source : sources)
      for (Block& block : source.blocks) by_name_[block.function].push_back({&block, &source.tokens});
  }

  void mark(std::vector<SourceText>& sources) {
    if (by_name_.count("setup") + by_name_.count("loop") == 0) return;
    for (auto& [name, blocks] : by_name_)
      for (const BlockOf& one : blocks) one.block->runs = false;
    for (const char* const root : {"setup", "loop", "main", "ISR", "SIGNAL", "serialEvent"}) reach(root);
    for (const SourceText& source : sources) reach_from_globals(source);
    while (!reached_.empty()) {
      const BlockOf one = reached_.back();
      reached_.pop_back();
      for (std::size_t i = one.block->function_begin + 1; i < one.block->function_end; ++i)
        reach((*one.tokens)[i].text);
    }
  }

 private:
  struct BlockOf {
    Block* block;
    const Tokens* tokens;
  };

  void reach(std::string_view name) {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return;
    for (const BlockOf& one : found->second) {
      one.block->runs = true;
      reached_.push_back(one);
    }
    by_name_.erase(found);
  }

  // Calls reach() for names outside of functions, except names in declarations: void turn(int angle);
  void reach_from_globals(const SourceText& source) {
    const Tokens& tokens = source.tokens;
    std::map<std::size_t, std::size_t> functions;  // begin and end
    for (const Block& block : source.blocks) functions.emplace(block.function_begin, block.function_end);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (const auto function = functions.find(i); function != functions.end()) i = function->second;
      const bool is_declared = i > 0 && i + 1 < tokens.size() && tokens[i + 1].is("(") &&
                               (tokens[i - 1].kind == Token::Kind::word || tokens[i - 1].is("*"));
      if (i < tokens.size() && !is_declared) reach(tokens[i].text);
    }
  }

  std::map<std::string, std::vector<BlockOf>, std::less<>> by_name_;
  std::vector<BlockOf> reached_;
};

}  // namespace

void mark_running(std::vector<SourceText>& sources) { RunningCode(sources).mark(sources); }

std::map<std::string, int> assignments_in(const std::vector<SourceText>& sources) {
  std::map<std::string, int> counts;
  for (const SourceText& source : sources)
    for (std::size_t i = 0; i + 2 < source.tokens.size(); ++i) {
      const Token &word = source.tokens[i], &next = source.tokens[i + 1], &after = source.tokens[i + 2];
      if (word.kind != Token::Kind::word) continue;
      const bool is_sign = next.is("+") || next.is("-");
      const bool is_set = next.is("=") && !after.is("=");
      if (is_set || (is_sign && (after.is("=") || after.is(next.text)))) ++counts[std::string(word.text)];
    }
  return counts;
}

std::vector<Block> blocks_of(const Tokens& tokens) { return BlockReader(tokens).run(); }

WordList words_of(const Tokens& tokens) {
  WordList words;
  for (const Token& token : tokens) {
    if (token.kind != Token::Kind::word) continue;
    const WordList more = words_of(token.text);
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

SourceText::SourceText(std::string name, std::string content)
    : file(std::move(name)),
      text(std::make_shared<const std::string>(std::move(content))),
      tokens(tokens_of(*text)),
      blocks(blocks_of(tokens)) {
  constexpr std::size_t kLongestComment = 10'000;  // the rest of a longer line is not read
  for (build::Comment comment : build::comments_of(*text)) {
    comment.text = comment.text.substr(0, kLongestComment);
    comments.push_back({comment, words_of_text(comment.text)});
  }
}

}  // namespace robosim::wiring
