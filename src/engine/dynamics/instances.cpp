// Compiles the templates of the dynamics room for every scalar they are made for, so that a change that breaks one of
// them breaks the build.
#include <tuple>

#include "poinsot/engine/dynamics/constraint.h"
#include "poinsot/engine/dynamics/dynamics_derivatives.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/dynamics/inertia_regressor.h"
#include "poinsot/engine/dynamics/inverse_dynamics.h"
#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/dynamics/mass_matrix.h"
#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/model/builder.h"

namespace poinsot {

template class ModelBuilder<double>;
template class ModelBuilder<long double>;
template class ModelBuilder<Dual<4>>;
template class ModelBuilder<Pack<4>>;
template class ModelBuilder<Pack<8>>;

namespace {

// Every algorithm of the room, named once.
template <class S>
constexpr auto algorithms() {
  return std::tuple{&inverse_dynamics<S>,
                    &joint_wrench<S>,
                    &ground_wrench<S>,
                    &forward_dynamics<S>,
                    &hybrid_dynamics<S>,
                    &hybrid_response<S>,
                    &mass_matrix<S>,
                    &mirror_lower_triangle<S>,
                    &inverse_dynamics_derivatives<S>,
                    &forward_dynamics_derivatives<S>,
                    &inertia_regressor<S>,
                    &update_poses<S>,
                    &update_velocities<S>,
                    &update_accelerations<S>,
                    &body_pose<S>,
                    &point_position<S>,
                    &point_velocity<S>,
                    &point_acceleration<S>,
                    &point_jacobian<S>,
                    &angular_jacobian<S>,
                    &wrench_of_force<S>,
                    &momentum<S>,
                    &momentum_rate<S>,
                    &body_momentum<S>,
                    &body_momentum_rate<S>,
                    &kinetic_energy<S>,
                    &potential_energy<S>,
                    &mass_center<S>,
                    &constraint_error<S>,
                    &constraint_rate<S>,
                    &constraint_acceleration<S>,
                    &constraint_jacobian<S>,
                    &constrained_dynamics<S>,
                    &integrate_position<S>,
                    &position_rate<S>,
                    &neutral_state<S>};
}

[[maybe_unused]] const auto over_double = algorithms<double>();
[[maybe_unused]] const auto over_long_double = algorithms<long double>();
[[maybe_unused]] const auto over_duals = algorithms<Dual<4>>();
[[maybe_unused]] const auto over_packs_of_4 = algorithms<Pack<4>>();
[[maybe_unused]] const auto over_packs_of_8 = algorithms<Pack<8>>();

}  // namespace

}  // namespace poinsot
