// The methods of rotation.h: for the numbers (attitude, angular velocity) that it integrates, and for a body in the
// coordinates of its joints.
#pragma once

#include <memory>

#include "engine/motion/closed_form/body_coordinates.h"
#include "engine/motion/integrator/step_method.h"
#include "engine/motion/rotation/principal_body.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {

// What its flows and methods refer to: the body, kept as long as any of them.
struct Rotor {
  explicit Rotor(const RotatingBody& body) : given(body), principal(given) {}
  RotatingBody given;
  PrincipalBody principal;
};

// Collocation in steps of its own choice, and equal steps.
std::unique_ptr<StepMethod> make_rotation_collocation(const std::shared_ptr<const Rotor>& rotor,
                                                      const IntegrationOptions& options);
std::unique_ptr<StepMethod> make_rotation_in_equal_steps(const std::shared_ptr<const Rotor>& rotor,
                                                         const IntegrationOptions& options);

// The collocation in coordinates of joints: in steps of about a radian at most, so that angles can be followed. The
// body has a fixed point.
std::unique_ptr<StepMethod> make_body_method(std::shared_ptr<const BodyCoordinates> coordinates,
                                             const RotatingBody& body, const IntegrationOptions& options);

}  // namespace poinsot
