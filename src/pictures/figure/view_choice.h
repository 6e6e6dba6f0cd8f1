// From where a scene is looked at.
#pragma once

#include <optional>
#include <vector>

#include "pictures/solids/projection.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

// The view in which least is lost: arrows seen at their length, points and heads apart, plates not edge-on, nothing
// that matters behind a body. `bodies` and `arrows` are what is drawn.
View chosen_view(const scene::Scene& scene, const std::vector<int>& bodies, const std::vector<scene::Arrow>& arrows,
                 const std::vector<scene::Pose>& poses);
// The view across the plane of a problem of which all lies and acts in one; nothing otherwise.
std::optional<View> view_across_plane(const scene::Scene& scene, const std::vector<scene::Pose>& poses);
// That of the scene's cones or of its invariable plane: one looks into them, and sees how high they are.
View chosen_view_of_cones(const scene::Scene& scene, const std::vector<int>& bodies,
                          const std::vector<scene::Pose>& poses);
// The same for a motion that ends in these poses: the ways that points have gone are seen at their length.
View chosen_view_of_motion(const scene::Scene& scene, const std::vector<int>& bodies,
                           const std::vector<scene::Pose>& poses);

}  // namespace poinsot::pictures
