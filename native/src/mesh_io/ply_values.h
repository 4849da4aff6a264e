// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>

#include "mesh_io/byte_order.h"
#include "mesh_io/ply_header.h"

namespace dirichlet {

/// The numbers after a PLY header, one after the other, whichever way they are written.
class PlyValues {
 public:
  virtual ~PlyValues() = default;

  /// All types of PLY fit a double. \throws InputError  the file ends, or has something else than a number there
  virtual double next(PlyType type) = 0;

  virtual bool at_end() = 0;
  [[nodiscard]] virtual std::size_t position() const = 0;  ///< byte offset
  [[nodiscard]] virtual std::size_t remaining() const = 0; ///< bytes
  [[nodiscard]] virtual std::string where() const = 0;     ///< file and line or byte

  template <class... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    throw InputError(message(where(), ": ", parts...));
  }
};

class PlyText final : public PlyValues {
 public:
  explicit PlyText(TextScanner in) : in_(in) {}

  double next(PlyType type) override {
    const auto word = in_.expect("a number");
    if (is_whole(type)) return static_cast<double>(in_.whole(word, "a number"));
    const auto value = parse<double>(word);
    if (!value) fail(quoted(word), " is not a number");
    return *value;
  }
  bool at_end() override { return in_.at_end(); }
  [[nodiscard]] std::size_t position() const override { return in_.position(); }
  [[nodiscard]] std::size_t remaining() const override { return in_.remaining(); }
  [[nodiscard]] std::string where() const override { return in_.where(); }

 private:
  TextScanner in_;
};

class PlyBinary final : public PlyValues {
 public:
  PlyBinary(const FileBytes& file, std::size_t begin, std::endian order)
      : file_(file), position_(begin), order_(order) {}

  double next(PlyType type) override {
    last_ = position_;
    if (remaining() < size_of(type)) fail("the file ends where a number should be");
    const char* at = &file_.bytes[position_];
    position_ += size_of(type);
    switch (type) {
    case PlyType::int8:
      return load<std::int8_t>(at, order_);
    case PlyType::uint8:
      return load<std::uint8_t>(at, order_);
    case PlyType::int16:
      return load<std::int16_t>(at, order_);
    case PlyType::uint16:
      return load<std::uint16_t>(at, order_);
    case PlyType::int32:
      return load<std::int32_t>(at, order_);
    case PlyType::uint32:
      return load<std::uint32_t>(at, order_);
    case PlyType::float32:
      return load<float>(at, order_);
    case PlyType::float64:
      break;
    }
    return load<double>(at, order_);
  }
  bool at_end() override { return file_.bytes.find_first_not_of("\r\n", position_) == std::string::npos; }
  [[nodiscard]] std::size_t position() const override { return position_; }
  [[nodiscard]] std::size_t remaining() const override { return file_.bytes.size() - position_; }
  [[nodiscard]] std::string where() const override { return message(file_.name, ", byte ", last_); }

 private:
  const FileBytes& file_;
  std::size_t position_;
  std::size_t last_ = position_; ///< where the number begins that was read last
  std::endian order_;
};

} // namespace dirichlet
