// The body cone rolls on the space cone (section 18.11): about the axis of symmetry with half angle gamma, about H_G
// with half angle |gamma - theta|, touching along the angular velocity. Without symmetry w runs on the polhode in the
// body and on the herpolhode in space, which lies in the invariable plane across H_G.
#include "problem/scene/scene_free_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "poinsot/engine/mass/principal_axes.h"
#include "poinsot/engine/motion/closed_form/torque_free.h"
#include "problem/explanation/explanation_figures.h"

namespace poinsot::problem {
namespace {

constexpr double same_moment = 1e-9;  // as a part of the moments: what axisymmetric data differ by
constexpr double same_direction = 1e-9;
constexpr int points_on_path = 240;
constexpr double drawn_part = 0.4;  // of the figure, for the largest angular velocity

bool is_free(const Mechanism<double>& mechanism, int body) {
  if (!(mechanism.tree.body(body).inertia.mass > 0) || mechanism.tree.body(body).parent != ground) return false;
  if (velocity_size(mechanism.tree.body(body).joint) != 6) return false;
  return std::none_of(mechanism.actions.begin(), mechanism.actions.end(), [&](const Action& action) {
    const bool sudden = action.kind == ActionKind::impulse || action.kind == ActionKind::impact;
    return !sudden && (action.on == body || action.from == body);
  });
}

double angle_between(const Vector3<double>& a, const Vector3<double>& b) {
  return std::atan2(norm(Vector3<double>(cross(a, b))), dot(a, b));
}

void add_cones(scene::Scene& scene, int number, const scene::Body& body, const Vector3<double>& symmetry,
               const Vector3<double>& w, const Vector3<double>& H) {
  const Vector3<double> w_G = body.pose.R * w, H_G = body.pose.R * H;
  const Vector3<double> axis = dot(symmetry, w) < 0 ? -symmetry : symmetry;
  scene.cones.push_back({"body cone", number, body.center, axis, angle_between(axis, w), normalized(w)});
  scene.cones.push_back({"space cone", scene::ground, body.pose.R * body.center + body.pose.p, normalized(H_G),
                         angle_between(H_G, w_G), normalized(w_G)});
}

void add_paths(scene::Scene& scene, int number, const scene::Body& body, const TorqueFreeMotion& motion) {
  const Polhode& polhode = motion.polhode();
  const double scale = drawn_part * scene.length / polhode.speed_range().maximum;
  // Without a period, on the separatrix, as long as it takes to come near the axis.
  const bool closed = std::isfinite(polhode.period());
  constexpr double decays = 10;
  const double time = closed ? polhode.period() : decays / static_cast<double>(std::abs(polhode.solution().rate));
  const Vector3<double> center = body.pose.R * body.center + body.pose.p;
  scene::Curve in_body{scene::CurveKind::polhode, "polhode", number, closed, {}};
  scene::Curve in_space{scene::CurveKind::herpolhode, "herpolhode", scene::ground, false, {}};
  constexpr int periods = 4;
  for (int k = 0; k <= points_on_path; ++k)
    in_body.points.push_back(body.center + scale * motion.angular_velocity(time * k / points_on_path));
  for (int k = 0; k <= periods * points_on_path; ++k) {
    const TorqueFreeMotion::State at = motion.at(time * k / points_on_path);
    in_space.points.push_back(center + scale * (rotation_matrix(at.attitude) * at.angular_velocity));
  }
  scene.curves.push_back(std::move(in_body));
  scene.curves.push_back(std::move(in_space));
}

// A body on which nothing acts, on its axes as drawn.
struct FreeBody {
  int number = 0;  // in the scene
  SymmetricMatrix3<double> inertia;
  Vector3<double> w;
};

std::vector<FreeBody> free_bodies(const SceneFigure& figure, const MotionState& reached) {
  solve::MechanismState state(figure.mechanism());
  state.set_positions(reached.q);
  state.set_velocities(reached.v);
  std::vector<FreeBody> found;
  for (std::size_t k = 0; k < figure.situation().bodies.size(); ++k) {
    const int number = static_cast<int>(k), tree_body = figure.tree_body(number);
    if (!is_free(figure.mechanism(), tree_body)) continue;
    const auto& motion = state.workspace().motion[static_cast<std::size_t>(tree_body + 1)];
    if (figure.vanishes(motion.w, dimensions::angular_velocity)) continue;
    const Matrix3<double>& R = figure.scene().bodies[k].pose.R;
    found.push_back(
        {number, rotated(transpose(R), mass_of(state, tree_body).inertia_center), transpose_times(R, motion.w)});
  }
  return found;
}

}  // namespace

bool add_free_motion(SceneFigure& figure, const MotionState& reached) {
  const std::vector<FreeBody> found = free_bodies(figure, reached);
  for (const FreeBody& free : found) {
    const scene::Body& body = figure.scene().bodies[static_cast<std::size_t>(free.number)];
    const Vector3<double> H = free.inertia * free.w;
    const PrincipalAxes<double> principal = principal_axes(free.inertia);
    const Vector3<double>& moments = principal.moments;
    if (!(moments.x > 0) || norm(Vector3<double>(cross(free.w, H))) <= same_direction * norm(free.w) * norm(H))
      continue;
    // The moments ascend.
    const bool low = moments.y - moments.x <= same_moment * moments.z;
    const bool high = moments.z - moments.y <= same_moment * moments.z;
    if (low || high)
      add_cones(figure.scene(), free.number, body, principal.axes.column(low ? 2 : 0), free.w, H);
    else
      add_paths(figure.scene(), free.number, body,
                TorqueFreeMotion::of_tensor(free.inertia, quaternion_of(body.pose.R), free.w));
  }
  return !found.empty();
}

void add_turning(SceneFigure& figure, const MotionState& reached) {
  const std::vector<FreeBody> found = free_bodies(figure, reached);
  if (found.size() != 1 || figure.scene().bodies.size() != 1) return;
  const FreeBody& free = found.front();
  const scene::Body& body = figure.scene().bodies.front();
  if (!(principal_axes(free.inertia).moments.x > 0)) return;
  const TorqueFreeMotion turning = TorqueFreeMotion::of_tensor(free.inertia, quaternion_of(body.pose.R), free.w);
  constexpr int turns = 3;
  const double time = turns * 2 * std::numbers::pi / norm(free.w);
  const Vector3<double> center = body.pose.R * body.center + body.pose.p;
  scene::Motion motion;
  for (int k = 0; k <= points_on_path; ++k) {
    motion.times.push_back(time * k / points_on_path);
    const Matrix3<double> R = rotation_matrix(turning.attitude(motion.times.back()));
    motion.poses.push_back({{R, center - R * body.center}});
  }
  figure.scene().motion = std::move(motion);
  figure.scene().notes.push_back("the motion shows how '" + body.name +
                                 "' turns: how its mass center moves is not stated");
}

}  // namespace poinsot::problem
