// Stores a text that only grows, up to a mebibyte. Its snapshots share their common part, so that hundreds of
// snapshots take little more memory than one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace robosim::run {

class AppendOnlyText {
 public:
  struct Copy {
    std::vector<std::shared_ptr<const std::string>> pieces;  ///< kPiece bytes each
    std::string rest;
  };

  void add(char c) { text_ += c; }
  const std::string& text() const { return text_; }

  Copy save() const {
    for (std::size_t at = pieces_.size() * kPiece; at + kPiece <= text_.size(); at += kPiece)
      pieces_.push_back(std::make_shared<const std::string>(text_, at, kPiece));
    return {pieces_, text_.substr(pieces_.size() * kPiece)};
  }
  void restore(const Copy& saved) {
    const auto differ =
        std::mismatch(pieces_.begin(), pieces_.end(), saved.pieces.begin(), saved.pieces.end());
    text_.resize(static_cast<std::size_t>(differ.first - pieces_.begin()) * kPiece);
    for (auto piece = differ.second; piece != saved.pieces.end(); ++piece) text_ += **piece;
    text_ += saved.rest;
    pieces_ = saved.pieces;
  }

 private:
  static constexpr std::size_t kPiece = 4096;

  std::string text_;
  mutable std::vector<std::shared_ptr<const std::string>> pieces_;  ///< part of the text that has been saved
};

}  // namespace robosim::run
