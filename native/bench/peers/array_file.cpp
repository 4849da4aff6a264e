// SPDX-License-Identifier: GPL-3.0-or-later
#include "array_file.h"

#include <bit>
#include <fstream>
#include <stdexcept>
#include <string>

namespace peers {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are little-endian");
constexpr std::size_t kPreamble = 10; // \x93NUMPY, two bytes of version, two of the header's length
constexpr char kMagic[] = "\x93NUMPY\x01";

template <class Number>
std::vector<Number> read_numbers(const std::filesystem::path& path, const std::string& type) {
  std::ifstream file(path, std::ios::binary);
  std::string preamble(kPreamble, '\0');
  file.read(preamble.data(), kPreamble);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(preamble[i]); };
  std::string header(static_cast<std::size_t>(byte(8) + 256 * byte(9)), '\0');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  if (!file || !preamble.starts_with(kMagic) || header.find("'" + type + "'") == std::string::npos)
    throw std::runtime_error(path.string() + " is no array of " + type);
  const auto bytes = std::filesystem::file_size(path) - kPreamble - header.size();
  std::vector<Number> numbers(bytes / sizeof(Number));
  file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(bytes));
  return numbers;
}

} // namespace

std::vector<double> read_reals(const std::filesystem::path& path) {
  return read_numbers<double>(path, "<f8");
}

std::vector<std::int32_t> read_indices(const std::filesystem::path& path) {
  return read_numbers<std::int32_t>(path, "<i4");
}

void write_reals(const std::filesystem::path& path, std::span<const double> numbers) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(numbers.size()) + ",), }";
  header.resize((kPreamble + header.size() + 64) / 64 * 64 - kPreamble, ' '); // the format aligns the numbers
  header.back() = '\n';
  std::ofstream file(path, std::ios::binary);
  file.write(kMagic, 7);
  const char rest[] = {'\0', static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
  file.write(rest, sizeof rest);
  file << header;
  file.write(reinterpret_cast<const char*>(numbers.data()), static_cast<std::streamsize>(numbers.size_bytes()));
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

} // namespace peers
