// Which way each quantity points in a planar problem.
#include "problem/plane/planar_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {
namespace planar_words_test {

// Numbers, truth values and texts, and what is told of directions across the plane.
const std::set<std::string> no_way{
    "kinetic_energy", "potential_energy", "mass", "weight", "distance", "moment_of_inertia", "radius_of_gyration",
    "tension", "normal_force", "period", "end_of_bouncing", "touching", "taut", "sticking", "sliding", "parting",
    "stable", "stability", "growth_rate", "frequencies", "eigenvalues", "modes", "response", "moments_of_inertia",
    "products_of_inertia", "inertia_matrix", "principal_moments", "principal_axes", "direction_angles", "axial_force",
    "symmetry_axis", "precession_axis", "precession_rate", "precession_sense", "spin_rate", "body_cone", "space_cone",
    "invariable_plane", "poinsot_ellipsoid", "polhode", "axis_stability",
    // Those of a joint and a load, and here there is none:
    "axis", "drive", "load"};

TEST(PlanarWords, EveryQuantityPointsInThePlaneOrAlongItsNormalOrIsListedHere) {
  const Statement statement = read_statement(
      "title: t\nplane: [x, y]\nbodies: {b: {particle: [0, 0], mass: 1 kg}}\nask: {m: mass(b)}\n", "t.yaml");
  const Situation& situation = statement.situations.at(0);
  const PlanarWords words(situation);
  for (const QuantityFunction& quantity : quantity_table()) {
    const std::string form = quantity.form;
    const Expression first = parse_expression(form.substr(0, std::min(form.find("), "), form.size()) + 1), "t.yaml");
    const bool points = words.pointing(first) != PlanarWords::Pointing::none;
    EXPECT_NE(points, no_way.contains(quantity.name)) << quantity.name << ": its list is in planar_words.cpp";
  }
}

}  // namespace planar_words_test
}  // namespace poinsot::problem
