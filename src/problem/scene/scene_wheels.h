// What cords, belts and teeth go round: the wheels of bodies and the posts of the ground.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

// A circle that a cord or belt lies on, or the pitch circle of a gear, on ground axes at the shown instant.
struct SceneWheel {
  int body = scene::ground;  // its number in the scene
  Vector3<double> center{}, axis{};
  double radius = 0;
};
std::vector<SceneWheel> wheels_of(const SceneFigure& figure);

// The straight parts of a cord or belt that is led over wheels, each once, in the order of its links.
std::vector<const Component<double>*> straight_parts(const Mechanism<double>& mechanism, const std::string& cord);

// Of bodies without shape the disks of their wheels, which are stated; and the posts that the ground holds.
void add_wheels(SceneFigure& figure);
// Where cords and belts lie on wheels and posts. After add_links.
void add_wraps(SceneFigure& figure);
// The ground that is touched later, and the center toward which gravity pulls.
void add_later_surfaces(SceneFigure& figure);
// Straight parts have the names under which their tensions are asked for.
void name_tensions(SceneFigure& figure, const Statement& statement);

}  // namespace poinsot::problem
