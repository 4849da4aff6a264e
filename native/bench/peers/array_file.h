// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace peers {

/// All numbers of a NumPy file (.npy, version 1, C order, little-endian), whatever its shape.
/// \throws std::runtime_error  no such file, or numbers of another type
std::vector<double> read_reals(const std::filesystem::path& path);
std::vector<std::int32_t> read_indices(const std::filesystem::path& path);

/// One dimension.
void write_reals(const std::filesystem::path& path, std::span<const double> numbers);

} // namespace peers
