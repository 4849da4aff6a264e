// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh_io.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

#include "mesh_checks.h"
#include "mesh_io/checked_file.h"
#include "mesh_io/encode.h"
#include "mesh_io/openmesh_reader.h"

namespace dirichlet {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

[[noreturn]] void refuse_ending(const fs::path& path) {
  throw InputError(message(path.string(), " has the ending '", path.extension().string(),
                           "', but only .obj, .ply, .off and .stl are known"));
}

[[noreturn]] void refuse_access(const fs::path& path, std::string_view verb, std::error_code reason) {
  throw InputError(message(path.string(), " cannot be ", verb, ": ", reason.message()));
}

std::error_code last_error() {
  return {errno, std::generic_category()};
}

FileBytes read_bytes(const fs::path& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  if (in && in.peek() != std::ifstream::traits_type::eof()) out << in.rdbuf();
  if (!in.is_open() || in.bad() || !out) refuse_access(path, "read", last_error());
  return {path.string(), std::move(out).str()};
}

/// Where a link leads, so that it stays one.
fs::path followed(const fs::path& path) {
  std::error_code error;
  fs::path real = fs::is_symlink(path, error) ? fs::canonical(path, error) : path;
  return error ? path : real;
}

/// Beside the target, so that the rename stays within one file system; gone again unless it was renamed.
class FileBeside {
 public:
  explicit FileBeside(const fs::path& target)
      : named_(target), target_(followed(target)),
        path_(target_.parent_path() / message(".", std::random_device{}(), ".part")) {}
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  ~FileBeside() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

  void write(const std::string& bytes) {
    errno = 0;
    std::error_code error;
    const fs::file_status target = fs::status(target_, error);
    if (fs::is_regular_file(target) && !std::ofstream(target_, std::ios::app)) // which a renaming does not ask
      refuse_access(named_, "written", last_error());
    std::ofstream out(path_, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) refuse_access(named_, "written", last_error());
    if (fs::is_regular_file(target)) fs::permissions(path_, target.permissions(), error);
  }

  void become_target() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) refuse_access(named_, "written", error);
  }

 private:
  const fs::path& named_;
  fs::path target_;
  fs::path path_;
};

std::string encode(const fs::path& path, const MeshView& mesh, std::span<const unsigned char> colors) {
  const std::string ending = ending_of(path);
  if (ending == ".ply") return encode_ply(mesh, colors);
  if (!colors.empty()) throw InputError(message(path.string(), ": colours can be written to .ply files only"));
  if (ending == ".obj") return encode_obj(mesh);
  if (ending == ".off") return encode_off(mesh);
  if (ending == ".stl") return encode_stl(mesh);
  refuse_ending(path);
}

void check_sizes(std::span<const Index> offsets) {
  std::ptrdiff_t first = 0, count = 0;
  for (std::ptrdiff_t f = std::ssize(offsets) - 2; f >= 0; --f)
    if (offsets[static_cast<std::size_t>(f) + 1] - offsets[static_cast<std::size_t>(f)] < 3) {
      first = f;
      ++count;
    }
  if (count > 0)
    throw InputError(message("face ", first, " has fewer than three corners", and_more(count - 1, "such face")));
}

} // namespace

MeshArrays read_mesh_file(const fs::path& path) {
  struct Format {
    std::string_view ending;
    CheckedFile (*check)(const FileBytes&);
  };
  constexpr std::array<Format, 4> formats{
      {{".obj", check_obj}, {".ply", check_ply}, {".off", check_off}, {".stl", check_stl}}};
  const std::string ending = ending_of(path);
  const auto format = std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.ending == ending; });
  if (format == formats.end()) refuse_ending(path);

  const FileBytes file = read_bytes(path);
  if (file.bytes.empty()) throw InputError(message(file.name, " is empty"));
  CheckedFile checked = format->check(file);
  if (checked.faces == 0) throw InputError(message(file.name, " has no faces"));
  return read_with_openmesh(file.name, ending, std::move(checked));
}

void write_mesh_file(const fs::path& path, std::span<const double> positions, std::span<const Index> offsets,
                     std::span<const Index> corners, std::span<const unsigned char> colors) {
  check_positions(positions);
  check_offsets(offsets, corners.size());
  check_corner_range(offsets, corners, static_cast<Index>(positions.size() / 3));
  check_sizes(offsets);
  if (!colors.empty() && colors.size() != positions.size())
    throw InputError(
        message("there are ", counted(colors.size() / 3, "colour"), " for ", counted(positions.size() / 3, "vertex")));
  const std::string bytes = encode(path, {positions, offsets, corners}, colors);
  FileBeside file(path);
  file.write(bytes);
  file.become_target();
}

} // namespace dirichlet
