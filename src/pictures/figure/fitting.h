// What a panel must hold, the projection in which it fills its part of the paper, and the panel as a drawing.
#pragma once

#include <cstddef>
#include <vector>

#include "pictures/figure/panel.h"

namespace poinsot::pictures {

struct Size {
  double width = 400, height = 300;
};
// The more panels stand side by side, the smaller each is.
Size size_of_panels(std::size_t count);
// That of the statement's figure, which has more room where many bodies are to be told apart.
Size size_of_model(std::size_t bodies);

std::vector<int> all_bodies(const scene::Scene& scene);
// The places that a drawing must hold.
std::vector<Vector> places_of(const scene::Scene& scene, const std::vector<int>& bodies,
                              const std::vector<scene::Pose>& poses, const std::vector<scene::Arrow>& arrows,
                              bool with_symbols);
// The diagonal of the box on the axes of the ground that holds the places.
double extent_of(const std::vector<Vector>& places);
// The projection in which the places fill the size.
Projection fitted(const View& view, const std::vector<Vector>& places, const Size& size);

// The labels of a panel placed, and what it covers.
Drawing finished(Panel& panel);

}  // namespace poinsot::pictures
