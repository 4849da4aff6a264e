// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "dirichlet/triangulation.h"
#include "polygons.h"
#include "refusal.h"

namespace dirichlet {
namespace {

TEST(Triangulation, knows_quads_two_of_whose_sides_cross) {
  const Polygon even = in_plane({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), slanted = in_plane({{0, 0}, {4, 1}, {3, 0}, {1, 2}});
  Polygon bent = even;
  bent[2][2] = 0.05; // as on a curved surface
  for (const Polygon& quad : {even, slanted, bent})
    for (std::size_t start = 0; start < 4; ++start) {
      Polygon turned = quad;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
      for (const double scale : {1.0, 1e-160, 1e149}) EXPECT_TRUE(crosses(tilted(turned, scale)));
    }
}

TEST(Triangulation, splits_a_polygon_thin_as_by_rounding_that_crosses_itself_and_tells_it_and_refuses_a_wider_one) {
  const auto pentagon = [](double width) { return in_plane({{0, 0}, {3, 3 * width}, {3, 0}, {2, 0}, {0, 2 * width}}); };
  for (const double scale : {1.0, 1e-160, 1e149}) {
    const Polygon thin = tilted(pentagon(1e-6), scale), wide = tilted(pentagon(1e-4), scale);
    EXPECT_TRUE(splits(5, triangulate(thin)));
    EXPECT_TRUE(crosses(thin));
    EXPECT_REFUSED(triangulate(wide), TopologyError, "face 0 crosses itself");
    const Polygon simple = tilted(in_plane({{0, 0}, {3, 0}, {3, 3e-6}, {2, 1e-6}, {0, 2e-6}}), scale);
    EXPECT_TRUE(splits(5, triangulate(simple)));
    EXPECT_FALSE(crosses(simple));
    EXPECT_FALSE(crosses(tilted(pentagon(0), scale))); // flat
  }
}

TEST(Triangulation, refuses_a_polygon_that_crosses_itself_and_names_it) {
  const Polygon eight = in_plane({{0, 0}, {3, 3}, {3, 0}, {2, 0}, {0, 2}});
  const Polygon even = in_plane({{0, 0}, {2, 2}, {3, 1}, {2, 0}, {0, 2}, {-1, 1}}); // of the area 0
  Polygon star(5);
  const Polygon ring = around(5, [](Index) { return 1; });
  for (std::size_t i = 0; i < 5; ++i) star[i] = ring[2 * i % 5];
  for (const Polygon& polygon : {eight, even, tilted(even), star, tilted(star), with_split_sides(star)})
    EXPECT_REFUSED(triangulate(polygon), TopologyError, "face 0 crosses itself");

  std::vector<double> positions = flatten(ring);
  EXPECT_REFUSED(dirichlet::triangulate(positions, std::vector<Index>{0, 3, 8, 13, 18},
                                        std::vector<Index>{0, 1, 2, 0, 1, 2, 3, 4, 0, 2, 4, 1, 3, 4, 2, 0, 3, 1}),
                 TopologyError, "face 2", "1 more face");
}

} // namespace
} // namespace dirichlet
