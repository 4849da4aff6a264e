// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io/text_scanner.h"

#include "mesh_checks.h"

namespace dirichlet {
namespace {

constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

} // namespace

std::string quoted(std::string_view word) {
  constexpr std::size_t most = 24;
  std::string result = "'";
  for (const char c : word.substr(0, most)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (word.size() > most ? "…'" : "'");
}

bool underflows(std::string_view word) {
  if (const auto e = word.find_first_of("eE"); e != std::string_view::npos) return word.substr(e + 1).starts_with('-');
  return word.find_first_not_of("+-0") == word.find('.');
}

TextScanner::TextScanner(const FileBytes& file, Syntax syntax) : name_(file.name), text_(file.bytes), syntax_(syntax) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

bool TextScanner::at_line_end() const {
  return position_ == text_.size() || is_line_end(text_[position_]);
}

void TextScanner::pass_line_end() {
  if (position_ == text_.size()) return;
  position_ += text_.substr(position_).starts_with("\r\n") ? 2 : 1;
  ++line_;
}

void TextScanner::skip_blanks() {
  while (!at_line_end()) {
    const char c = text_[position_];
    const bool last_of_line = position_ + 1 == text_.size() || is_line_end(text_[position_ + 1]);
    if (is_blank(c))
      ++position_;
    else if (syntax_.continuation && c == '\\' && last_of_line) {
      ++position_;
      pass_line_end();
    } else if (syntax_.comment != '\0' && c == syntax_.comment)
      position_ = std::min(text_.find_first_of("\r\n", position_), text_.size());
    else
      return;
  }
}

std::string_view TextScanner::word() {
  skip_blanks();
  const std::size_t begin = position_;
  while (!at_line_end() && !is_blank(text_[position_]) &&
         (syntax_.comment == '\0' || text_[position_] != syntax_.comment))
    ++position_;
  return text_.substr(begin, position_ - begin);
}

std::string_view TextScanner::expect(std::string_view what) {
  if (at_end()) fail("the file ends where ", what, " should be");
  return word();
}

double TextScanner::coordinate(std::string_view word) const {
  const auto value = parse<double>(word);
  if (!value) fail(quoted(word), " is not a number, but should be a coordinate");
  if (!is_coordinate(*value)) fail("a coordinate is ", quoted(word), ", which is not finite or beyond 1e150");
  return *value;
}

std::int64_t TextScanner::whole(std::string_view word, std::string_view what) const {
  const auto value = parse<std::int64_t>(word);
  if (!value) fail(quoted(word), " is not a whole number, but should be ", what);
  return *value;
}

bool TextScanner::next_line() {
  while (!word().empty()) {
  }
  pass_line_end();
  return position_ < text_.size();
}

bool TextScanner::at_end() {
  for (skip_blanks(); position_ < text_.size() && at_line_end(); skip_blanks()) pass_line_end();
  return position_ == text_.size();
}

} // namespace dirichlet
