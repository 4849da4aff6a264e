// SPDX-License-Identifier: GPL-3.0-or-later
// Paintings one after another, some of them refused or cancelled: each has the field of a new solver, bit for bit.
//
// To the letters of add_surface, damage and paint come
//   !  paints what there is    -  wipes all    .  wipes the last    y x  other values, the vertices as they are
//   c  cancels the next one    w n  columns    L n  Laplacian
#include <cstring>
#include <memory>
#include <optional>

#include "damage.h"
#include "laws.h"

#include <gtest/gtest.h>

namespace dirichlet::fuzz {
namespace {

constexpr int kMostPaintings = 24; // in one input

class Painter {
 public:
  explicit Painter(Script script) : script_(script) {}

  void run() {
    expect_result_or_refusal([&] {
      while (!script_.at_end() && paintings_ < kMostPaintings) step(script_.letter());
    });
  }

 private:
  void step(char letter) {
    if (!mesh_ && (add_surface(soup_, letter, script_) || damage(soup_, letter, script_))) return;
    const auto count = static_cast<Index>(soup_.positions.size() / 3);
    if (fuzz::paint(painting_, count, letter, script_)) return;
    switch (letter) {
    case '!':
      paint();
      break;
    case '-':
      painting_ = {};
      break;
    case '.':
      wipe_last();
      break;
    case 'y':
      other_values();
      break;
    case 'c':
      options_.cancel.cancel();
      break;
    case 'L':
      laplacian_ = read_laplacian(script_);
      break;
    case 'w':
      columns_ = 1 + script_.number(8);
      break;
    default:
      break;
    }
  }

  void wipe_last() {
    if (painting_.vertices.empty()) return;
    painting_.vertices.pop_back();
    painting_.values.pop_back();
  }

  /// The first column is the painting's, the others are multiples of it.
  [[nodiscard]] Eigen::MatrixXd values(double factor) const {
    Eigen::MatrixXd all(painting_.values.size(), columns_);
    for (Index k = 0; k < columns_; ++k) all.col(k) = painting_.column() * (factor - 0.5 * k);
    return all;
  }

  void paint() {
    ++paintings_;
    if (!mesh_) mesh_ = makers::make_mesh(soup_);
    if (!solver_) solver_.emplace(*mesh_, options_, used_ = laplacian_);
    expect_result_or_refusal([&] {
      const Eigen::MatrixXd values = this->values(1);
      try {
        compare(solver_->paint(painting_.vertices, values), values);
      } catch (const CancelledError&) {
        EXPECT_TRUE(options_.cancel.is_cancelled());
        options_.cancel.reset();
        compare(solver_->paint(painting_.vertices, values), values);
      }
      last_ = painting_;
    });
    options_.cancel.reset();
  }

  /// Of the last painting that was not refused, which a refusal since has left alone.
  void other_values() {
    const double factor = script_.value();
    if (!solver_ || last_.vertices.empty()) return;
    ++paintings_;
    std::swap(last_, painting_);
    expect_result_or_refusal([&] {
      const Eigen::MatrixXd values = this->values(factor);
      compare(solver_->solve(values), values);
    });
    std::swap(last_, painting_);
  }

  void compare(const Field& field, const Eigen::MatrixXd& values) const {
    const Field fresh =
        HarmonicSolver(*mesh_, painting_.vertices, SolverOptions{.method = Method::direct}, used_).solve(values);
    ASSERT_EQ(field.values.size(), fresh.values.size());
    EXPECT_EQ(std::memcmp(field.values.data(), fresh.values.data(),
                          sizeof(double) * static_cast<std::size_t>(fresh.values.size())),
              0);
    EXPECT_EQ(field.report.undefined, fresh.report.undefined);
    EXPECT_EQ(field.report.warnings, fresh.report.warnings);
  }

  Script script_;
  makers::PolygonSoup soup_;
  Painting painting_, last_;
  Laplacian laplacian_ = Laplacian::graph, used_ = Laplacian::graph;
  Index columns_ = 1;
  int paintings_ = 0;
  SolverOptions options_{.method = Method::direct};
  std::unique_ptr<Mesh> mesh_;
  std::optional<HarmonicSolver> solver_;
};

} // namespace
} // namespace dirichlet::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dirichlet::fuzz;
  Painter(Script({data, size})).run();
  return 0;
}
