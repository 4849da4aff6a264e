// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "dirichlet/error.h"
#include "message.h"

namespace dirichlet {

/// A file as it was read: its name for complaints, and all its bytes.
struct FileBytes {
  std::string name;
  std::string bytes;
};

/// A word for a complaint: in quotes, its first characters, nothing unprintable.
std::string quoted(std::string_view word);

/// Whether a decimal number that no floating type can hold is too small for it rather than too large.
bool underflows(std::string_view word);

/// A whole word as a number, or nothing. Independent of the locale. A number too small for T is 0, one too large is
/// infinite.
template <class T>
std::optional<T> parse(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  if (error != std::errc::result_out_of_range || !std::is_floating_point_v<T>) return std::nullopt;
  return underflows(word) ? T{0} : std::numeric_limits<T>::infinity();
}

/// A text file, word by word. Knows the line it is on; lines end in LF, CR LF or CR, and a byte order mark is skipped.
class TextScanner {
 public:
  struct Syntax {
    char comment = '\0';       ///< starts a comment that runs to the end of the line; none when 0
    bool continuation = false; ///< a backslash at the end of a line joins it to the next
  };

  TextScanner(const FileBytes& file, Syntax syntax);

  /// The next word of this line; empty at its end.
  std::string_view word();

  /// The next word of this line or a later one. \throws InputError  the file ends; `what` says what is missing.
  std::string_view expect(std::string_view what);

  /// A word as a number. \throws InputError  it is none, or no coordinate that a mesh may have; `what` says what it
  /// should be.
  double coordinate(std::string_view word) const;
  std::int64_t whole(std::string_view word, std::string_view what) const;

  bool next_line(); ///< skips what is left of this line; false at the end of the file
  bool at_end();    ///< nothing is left but blanks, comments and line ends
  void unread(std::size_t characters) { position_ -= characters; } ///< of the last word

  [[nodiscard]] std::size_t position() const { return position_; } ///< byte offset
  [[nodiscard]] std::size_t remaining() const { return text_.size() - position_; }
  [[nodiscard]] std::string where() const { return message(name_, ", line ", line_); }

  template <class... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    throw InputError(message(where(), ": ", parts...));
  }

 private:
  void skip_blanks();
  [[nodiscard]] bool at_line_end() const;
  void pass_line_end();

  std::string_view name_;
  std::string_view text_;
  Syntax syntax_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

} // namespace dirichlet
