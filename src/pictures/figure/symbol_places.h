// Where the symbols of joints, supports and contacts stand in a figure.
#pragma once

#include <optional>
#include <vector>

#include "pictures/figure/panel.h"
#include "pictures/solids/gimbals.h"

namespace poinsot::pictures {

bool is_contact(const scene::Symbol& symbol);
// Whether the ground holds a bearing in which a body turns.
bool turns_about_fixed_axis(const scene::Symbol& symbol);

// The axis of a symbol on ground axes, or zero. The normal of a contact does not turn with the body that rolls.
Vector axis_on_ground(const Panel& panel, const scene::Symbol& symbol);

// Of most the one place; of gimbals two on the ring, of a body that turns about a fixed axis in its middle two where
// the axis leaves it, of a contact that has moved on the point of the body that is lowest on the surface.
std::vector<Vector> places_of_symbol(const Panel& panel, const scene::Symbol& symbol,
                                     const std::vector<std::optional<Gimbal>>& gimbals);

// Whether all of some body stands between a place and the viewer, so that the body hides what is there. A place inside
// of a body is where the body is held, and no more hidden than the body.
bool is_behind_body(const Panel& panel, const Vector& place);

}  // namespace poinsot::pictures
