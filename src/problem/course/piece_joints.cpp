// Joints along a piece of a motion whose friction follows from what they carry, or is against their slip in several
// ways together, whose size is then given. The equations of motion need not know the reactions of joints; they are
// found here as what the bodies beyond a joint need besides all else that acts on them (Newton and Euler for all of
// them together). Accelerations and reactions are linear in the frictions, so that those without friction and those
// with one unit in each joint tell them for any; the frictions along the slips are then the roots of
//   x + m (|V1| + |V2| + ...) = 0   (quantities/joint_pressing.h),
// found by Newton's method from x = 0 (instant/joint_friction.cpp says why that is the only root).
#include <algorithm>
#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/solve/instant/closure.h"
#include "problem/course/motion_piece.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

using Eigen::Index;

constexpr Index most_components = 24;  // that the supports of one joint can carry together
using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, most_components>;
using SixVector = Eigen::Matrix<double, 6, 1>;

SixVector about(const SpatialForce<double>& wrench, const Vector3<double>& P, double length) {
  const Vector3<double> moment = (wrench.moment - cross(P, wrench.force)) / length;
  SixVector v;
  v << wrench.force.x, wrench.force.y, wrench.force.z, moment.x, moment.y, moment.z;
  return v;
}

}  // namespace

void Course::Piece::set_up_joint_friction() {
  const Mechanism<double>& mechanism = machine_.mechanism;
  for (RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.pressing.empty() && !contact.found_with_reactions()) continue;
    if (contact.grip == Grip::slides)
      for (const RubbingWay<double>& way : contact.ways) machine_.mechanism.drives[way.drive].held = false;
    JointLoad load{&contact, std::vector<bool>(static_cast<std::size_t>(mechanism.tree.body_count()))};
    if (contact.pressing.empty()) {
      loads_on_joints_.push_back(std::move(load));
      continue;
    }
    const int child = mechanism.drives[contact.ways.front().drive].along.body;
    for (int i = 0; i < mechanism.tree.body_count(); ++i) {
      const int parent = mechanism.tree.body(i).parent;
      load.beyond[static_cast<std::size_t>(i)] =
          i == child || (parent != ground && load.beyond[static_cast<std::size_t>(parent)]);
      // Links between the freedoms of a joint have coordinates that are driven, and move by themselves.
      const bool link = std::ranges::any_of(
          mechanism.drives, [&](const Drive<double>& drive) { return drive.coordinate == mechanism.tree.body(i).v; });
      if (load.beyond[static_cast<std::size_t>(i)] && !mechanism.takes_part[static_cast<std::size_t>(i)] && !link)
        refuse_load(contact, "beyond it a frame moves as stated", "let the frame hold the joint, or ask at an instant");
    }
    for (std::size_t k = 0; k < mechanism.components.size(); ++k)
      if (std::ranges::any_of(contact.pressing,
                              [&](const auto& part) { return part.action == mechanism.components[k].action; }))
        load.components.push_back(k);
    loads_on_joints_.push_back(std::move(load));
  }
}

void Course::Piece::refuse_load(const RoughContactOf<double>& contact, const std::string& why,
                                const std::string& hint) const {
  const auto stated = std::ranges::find(motion_.situation_.contacts, contact.name, &Contact::name);
  throw UnansweredError(motion_.situation_.file, stated->friction->mark,
                        "what joint '" + contact.name +
                            "' carries, and with it its friction, is not known along the "
                            "motion: " +
                            why,
                        hint);
}

// Whether the equations of motion determine what acts on the bodies beyond the joint, and statics how its supports
// share it.
void Course::Piece::check_joint_loads() {
  if (loads_on_joints_.empty()) return;
  accelerate(now_.q, now_.v, acceleration_);
  const Mechanism<double>& mechanism = machine_.mechanism;
  for (const JointLoad& load : loads_on_joints_) {
    if (load.contact->pressing.empty()) continue;
    for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
      const Action& action = mechanism.actions[static_cast<std::size_t>(mechanism.components[k].action)];
      if (!acting_[static_cast<std::size_t>(mechanism.components[k].action)]) continue;
      const std::string& joint = action.kind == ActionKind::support ? action.joint : action.name;
      const bool in_tree = (action.kind == ActionKind::joint || action.kind == ActionKind::support) &&
                           std::ranges::find(machine_.loop_joints, joint) == machine_.loop_joints.end();
      if (in_tree || action.name == hold_of_plane || dynamics_->component_determined(k)) continue;
      refuse_load(*load.contact, "how '" + action.name + "' shares the load is open",
                  "leave out what is carried twice, or state the problem in a plane, plane: [x, y]");
    }
    if (static_cast<Index>(load.components.size()) > most_components ||
        shares_of(load, SpatialForce<double>::zero()).empty())
      refuse_load(*load.contact, "its supports share the load in a way that statics does not tell",
                  "let each support carry only what the others do not");
  }
}

std::vector<double> Course::Piece::shares_of(const JointLoad& load, const SpatialForce<double>& needed) const {
  const Vector3<double> P = limit_state_.position(load.contact->at);
  const double length = motion_.start_->scales().length;
  Columns columns(6, static_cast<Index>(load.components.size()));
  for (std::size_t i = 0; i < load.components.size(); ++i)
    columns.col(static_cast<Index>(i)) =
        about(limit_state_.component_wrench(machine_.mechanism.components[load.components[i]]), P, length);
  Eigen::ColPivHouseholderQR<Columns> qr(columns);
  constexpr double same = 1e-9;  // supports as close to one another share nothing that statics could tell
  qr.setThreshold(same);
  if (qr.rank() < columns.cols()) return {};
  const auto found = qr.solve(about(needed, P, length)).eval();
  return {found.data(), found.data() + found.size()};
}

// The effort of one way of a joint that moves, by its friction along the slip.
double Course::Piece::effort_of(const JointLoad& load, const RubbingWay<double>& way) const {
  return load.friction * effort_for_friction(limit_state_, *load.contact, way);
}

// After accelerations at the state of limit_state_.
std::vector<Vector3<double>> Course::Piece::pressing_at(const JointLoad& load) const {
  if (load.contact->pressing.empty()) return {};
  const Mechanism<double>& mechanism = machine_.mechanism;
  const Workspace<double>& w = limit_state_.workspace();
  const Vector3<double> origin = Vector3<double>::zero();
  const RoughContactOf<double>& contact = *load.contact;
  SpatialForce<double> needed = SpatialForce<double>::zero();
  for (int i = 0; i < mechanism.tree.body_count(); ++i) {
    if (!load.beyond[static_cast<std::size_t>(i)]) continue;
    const Momentum<double> rate = body_momentum_rate(mechanism.tree, w, i, origin);
    const SpatialInertia<double>& I = mechanism.tree.body(i).inertia;
    const BodyMotion<double>& motion = w.motion[static_cast<std::size_t>(i + 1)];
    const Vector3<double> g = mechanism.tree.gravity();
    needed.force += rate.linear - I.mass * g;
    needed.moment += rate.angular - cross(I.mass * motion.p + motion.R * I.first_moment, g);
  }
  const auto is_beyond = [&](int body) { return body != ground && load.beyond[static_cast<std::size_t>(body)]; };
  const auto take_off = [&](int action, double size, const SpatialForce<double>& wrench) {
    const Action& acts = mechanism.actions[static_cast<std::size_t>(action)];
    needed += (is_beyond(acts.from) ? size : 0.0) * wrench;
    needed += (is_beyond(acts.on) ? -size : 0.0) * wrench;
  };
  for (const auto& [action, force] : limit_state_.known_forces()) take_off(action, 1, wrench_of(force));
  for (std::size_t k = 0; k < mechanism.components.size(); ++k)
    if (const double size = dynamics_->component_force(k); size != 0)
      take_off(mechanism.components[k].action, size, limit_state_.component_wrench(mechanism.components[k]));
  for (const Drive<double>& drive : mechanism.drives)
    if (drive.held) take_off(drive.action, dynamics_->held_effort(drive.coordinate), limit_state_.drive_wrench(drive));
  for (const JointLoad& one : loads_on_joints_)
    if (one.contact->grip == Grip::slides)
      for (const RubbingWay<double>& way : one.contact->ways) {
        const Drive<double>& drive = mechanism.drives[way.drive];
        take_off(drive.action, effort_of(one, way), limit_state_.drive_wrench(drive));
      }
  // What acts on `to` is reversed where the bodies beyond the joint hold it.
  const Action& joint = mechanism.actions[static_cast<std::size_t>(contact.action)];
  if (!is_beyond(joint.on)) needed = -1.0 * needed;
  const Vector3<double> P = limit_state_.position(contact.at);
  const std::vector<double> shares = shares_of(load, needed);
  const RubbingWay<double>& first = contact.ways.front();
  const double friction =
      contact.grip == Grip::slides ? effort_of(load, first) : dynamics_->held_effort(first.coordinate);
  std::vector<Vector3<double>> vectors;
  for (const PressingPart<double>& part : contact.pressing) {
    SpatialForce<double> wrench = SpatialForce<double>::zero();
    for (std::size_t i = 0; i < load.components.size(); ++i) {
      const Component<double>& component = mechanism.components[load.components[i]];
      if (component.action == part.action && i < shares.size())
        wrench += shares[i] * limit_state_.component_wrench(component);
    }
    vectors.push_back(pressing_of(part, limit_state_.direction(contact.motions[1].along), P, wrench, friction));
  }
  return vectors;
}

// What presses in all in a joint, after accelerate().
double Course::Piece::pressing_now(const RoughContactOf<double>& contact, std::span<const double> a) {
  limit_state_.set_accelerations({a.begin(), a.end()});
  double sum = 0;
  for (const Vector3<double>& V :
       pressing_at(*std::ranges::find(loads_on_joints_, &contact, [](const JointLoad& load) { return load.contact; })))
    sum += norm(V);
  return sum;
}

// The accelerations, with the frictions of the joints that move.
void Course::Piece::accelerate_with_joints(std::span<const double> q, std::span<const double> v, std::span<double> a) {
  limit_state_.set_positions({q.begin(), q.end()});
  solve::update_contacts(machine_.mechanism, limit_state_);
  limit_state_.set_velocities({v.begin(), v.end()});
  std::vector<JointLoad*> moving;
  for (JointLoad& load : loads_on_joints_)
    if (load.contact->grip == Grip::slides) moving.push_back(&load);
  const auto take = [&](JointLoad& load, double friction) {
    load.friction = friction;
    for (const RubbingWay<double>& way : load.contact->ways) dynamics_->set_effort(way.drive, effort_of(load, way));
  };
  const auto pressing = [&] {
    dynamics_->accelerations(q, v, a);
    limit_state_.set_accelerations({a.begin(), a.end()});
    std::vector<std::vector<Vector3<double>>> all;
    for (const JointLoad* load : moving) all.push_back(pressing_at(*load));
    return all;
  };
  for (JointLoad* load : moving) take(*load, 0);
  const auto without = pressing();
  const std::size_t n = moving.size();
  if (n == 0) return;
  std::vector<std::vector<std::vector<Vector3<double>>>> slope(n);  // by the friction of each joint
  std::vector<std::vector<double>> by_friction(n, std::vector<double>(n));
  for (std::size_t j = 0; j < n; ++j) {
    const double size =
        motion_.start_->natural_size(moving[j]->contact->turning ? dimensions::moment : dimensions::force);
    const double unit = size > 0 ? size : 1;
    take(*moving[j], unit);
    slope[j] = pressing();
    take(*moving[j], 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < without[i].size(); ++k) {
        slope[j][i][k] = (slope[j][i][k] - without[i][k]) / unit;
        by_friction[i][j] += moving[i]->contact->sliding * norm(slope[j][i][k]);
      }
  }
  if (!(bound_on_eigenvalues(by_friction) < 1))
    refuse_load(
        *moving.front()->contact,
        "it has so much friction that what it carries grows faster with its friction than its friction with that",
        "reduce the friction, or let the joint bear at a greater length or smaller radius");
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Index>(n)), off(static_cast<Index>(n));
  Eigen::MatrixXd J(static_cast<Index>(n), static_cast<Index>(n));
  constexpr int most_steps = 60;
  constexpr double exactly = 1e-15;  // of the frictions: their last place
  for (int step = 0; step < most_steps; ++step) {
    J.setIdentity();
    off = x;
    for (std::size_t i = 0; i < n; ++i) {
      const RoughContactOf<double>& contact = *moving[i]->contact;
      const double resists = contact.sliding;
      if (contact.pressing.empty()) off[static_cast<Index>(i)] += resists;
      for (std::size_t k = 0; k < without[i].size(); ++k) {
        Vector3<double> V = without[i][k];
        for (std::size_t j = 0; j < n; ++j) V += x[static_cast<Index>(j)] * slope[j][i][k];
        const double size = norm(V);
        if (!(size > 0)) continue;
        off[static_cast<Index>(i)] += resists * size;
        for (std::size_t j = 0; j < n; ++j)
          J(static_cast<Index>(i), static_cast<Index>(j)) += resists * dot(V, slope[j][i][k]) / size;
      }
    }
    const Eigen::VectorXd change = J.partialPivLu().solve(off);
    x -= change;
    if (!(change.cwiseAbs().maxCoeff() > exactly * x.cwiseAbs().maxCoeff())) break;
  }
  for (std::size_t j = 0; j < n; ++j) take(*moving[j], x[static_cast<Index>(j)]);
  dynamics_->accelerations(q, v, a);
}

double Course::Piece::power_of_joints(const State<double>& state) const {
  double power = 0;
  for (const JointLoad& load : loads_on_joints_)
    if (load.contact->grip == Grip::slides)
      for (const RubbingWay<double>& way : load.contact->ways)
        power += effort_of(load, way) * state.v[static_cast<std::size_t>(way.coordinate)];
  return power;
}

}  // namespace poinsot::problem
