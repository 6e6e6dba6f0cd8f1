// What is so far apart that nothing of it is seen beside the way between: an axle on a frame that turns about the
// middle of a wide curve. As draughtsmen do, the way is drawn broken, and shorter than it is.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pictures/figure/panel.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

struct Shortened {
  scene::Scene scene;
  std::vector<std::string> bodies;  // those that are drawn nearer than they are
  // The plane across the way that is left, in its middle: what crosses it is broken there.
  Vector middle, along;
  // Where nothing but a frame that turns joins the parts, from its axis in one to the middle of the other.
  std::optional<std::array<Vector, 2>> radius{};
};
// The scene with its two parts near each other, if nothing lies between them and the way is many times what each of
// them takes. Nothing if it has no such parts, or nothing goes from one to the other that can be broken.
std::optional<Shortened> shortened(const scene::Scene& scene);

// Marks of what is broken: arms of bodies, cords and springs, the radius on which a frame carries.
void draw_breaks(Panel& panel, const Shortened& broken);

}  // namespace poinsot::pictures
