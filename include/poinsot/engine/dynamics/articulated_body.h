// The articulated-body algorithm (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 7 and 9.2), the common
// road of forward_dynamics.h, hybrid_dynamics.h and constraint.h.
//
// All vectors stand on the axes of the tree's first body, each body's about its own origin: rotations of articulated
// inertias, the dearest part of the algorithm on body axes, disappear. The accelerations are split: first those of the
// bodies while every free coordinate has acceleration zero (with them the Newton-Euler force of each body, as in
// inverse_dynamics.h), then the change that the free coordinates make. The change obeys the equations of a tree at rest
// without gravity:
//
//   U = I S,  D = S . U,  u = tau - S . p
//   I_parent += X (I - U U^T / D) X^T,   p_parent += X (p + U u / D)
//   qdd = (u - U . change_of_parent) / D,   change = X^T change_of_parent + S qdd
//
// Joints of several coordinates eliminate them in turn; balls and free joints whose coordinates are all free are solved
// at once. A given (prescribed or locked) coordinate is not eliminated. Massless bodies need no care as long as each
// D > 0, that is, as long as no free coordinate moves massless bodies only; else the results are not finite. A ball or
// free joint whose body cannot take a couple about some line, as a slender rod about its own, is such a case: a moment
// of inertia that is no more than rounding beside the others counts as zero, for numbers and packs of them.
#pragma once

#include <concepts>
#include <span>

#include "poinsot/engine/dynamics/joint_motion.h"
#include "poinsot/engine/dynamics/workspace.h"

namespace poinsot::detail {

// A motion about another point of the same rigid body, r away.
template <class Scalar>
constexpr SpatialMotion<Scalar> motion_at(const SpatialMotion<Scalar>& m, const Vector3<Scalar>& r) {
  return {m.angular, m.linear + cross(m.angular, r)};
}
// A force about a point from which its old point is at r.
template <class Scalar>
constexpr SpatialForce<Scalar> force_from(const SpatialForce<Scalar>& f, const Vector3<Scalar>& r) {
  return {f.moment + cross(r, f.force), f.force};
}

// What the passes ask of the memory in which they keep a body: that of the workspace here, that of packs in
// packed_bodies.h.
template <class Scalar>
Workspace<Scalar>& workspace_of(Workspace<Scalar>& memory) {
  return memory;
}
template <class Scalar>
ArticulatedBody<Scalar>* slots_of(Workspace<Scalar>& memory) {
  return memory.articulated.data();
}
template <class Scalar>
void keep_motion(ArticulatedBody<Scalar>& slot, const Vector3<Scalar>& w, const Vector3<Scalar>& alpha,
                 const Vector3<Scalar>& a, const Matrix3<Scalar>& A) {
  slot.w = w;
  slot.alpha = alpha;
  slot.a = a;
  slot.A = A;
}
// The acceleration of the body's point at r relative to its origin.
template <class Scalar>
Vector3<Scalar> relative_acceleration(const ArticulatedBody<Scalar>& slot, const Vector3<Scalar>& r) {
  return slot.A * r;
}
template <class Scalar>
void keep_inertia(ArticulatedBody<Scalar>& slot, const SpatialInertia<Scalar>& own) {
  slot.inertia = ArticulatedInertia<Scalar>::of(own);
}
// With those outboard, once they all are added.
template <class Scalar>
const ArticulatedInertia<Scalar>& whole_inertia(const ArticulatedBody<Scalar>& slot, const Body<Scalar>&) {
  return slot.inertia;
}
// An inertia about the body's origin, of what is outboard.
template <class Scalar>
void add_inertia(ArticulatedBody<Scalar>& slot, const Body<Scalar>&, const ArticulatedInertia<Scalar>& outboard) {
  slot.inertia += outboard;
}
// What a revolute joint leaves of the inertia I of a body whose origin is at r.
template <class Scalar>
void add_reduced(ArticulatedBody<Scalar>& slot, const Body<Scalar>&, const ArticulatedInertia<Scalar>& I,
                 const SpatialForce<Scalar>& U, const Scalar& inverse_inertia, const Vector3<Scalar>& r) {
  slot.inertia += shifted(reduced(I, U, inverse_inertia), r);
}

// Places the body and carries its parent's motion to it while its own coordinates have no acceleration:
// w = w_p + w_J, alpha = alpha_p + w_p x w_J, a = a_p + A_p r + (2 w_p + w_J) x v_J. The first body of a tree stands on
// its own axes, on a ground that accelerates by -g.
template <class Scalar, class Slot>
inline void carry_motion(const Workspace<Scalar>& workspace, const Model<Scalar>& model, const Body<Scalar>& body,
                         const State<Scalar>& state, const Slot& parent, Slot& slot, Vector3<Scalar>& w,
                         Vector3<Scalar>& alpha, Vector3<Scalar>& a) {
  const Scalar* const qd = state.v.data() + body.v;
  if (body.parent == ground) {
    Matrix3<Scalar> R_ground;
    place_in_parent(workspace, body, state.q.data(), R_ground, slot.r);
    slot.R = Matrix3<Scalar>::identity();
    w = joint_motion(body, qd, slot.R).angular;
    alpha = Vector3<Scalar>::zero();
    a = -transpose_times(R_ground, model.gravity());
    if (body.joint == JointType::free) a += cross(w, three(qd + 3));
    return;
  }
  place_in_tree(workspace, model, body, state.q.data(), parent.R, slot.R, slot.r);
  w = parent.w;
  alpha = parent.alpha;
  a = parent.a + relative_acceleration(parent, slot.r);
  const Scalar two(2);
  switch (body.joint) {
    case JointType::screw:
      a += (two * body.pitch * qd[0]) * cross(parent.w, z_axis(slot.R));
      [[fallthrough]];
    case JointType::revolute: {
      const Vector3<Scalar> w_J = qd[0] * z_axis(slot.R);
      alpha += cross(parent.w, w_J);
      w += w_J;
      break;
    }
    case JointType::prismatic:
      a += (two * qd[0]) * cross(parent.w, z_axis(slot.R));
      break;
    case JointType::ball:
    case JointType::free: {
      const Vector3<Scalar> w_J = slot.R * three(qd);
      alpha += cross(parent.w, w_J);
      w += w_J;
      if (body.joint == JointType::free) a += cross(w + parent.w, slot.R * three(qd + 3));
      break;
    }
    case JointType::weld:
      break;
  }
}

// The Newton-Euler force of a body of revolution that turns about its axis e relative to its parent: w = w_p + s e.
// With I = J 1 + (C - J) e e^T the squares of s drop out of I alpha + w x I w, and with them their rounding, which for
// a fast rotor would exceed what moves it.
template <class Scalar, class Slot>
constexpr SpatialForce<Scalar> force_of_rotor(const Body<Scalar>& body, const Slot& slot,
                                              const Vector3<Scalar>& w_parent) {
  const Vector3<Scalar> e = z_axis(slot.R);
  const Vector3<Scalar> h = body.inertia.first_moment.z * e;
  const Vector3<Scalar> carried = cross(w_parent, e);
  const Scalar J = body.inertia.inertia.xx;
  const Scalar C_J = body.inertia.inertia.zz - J;
  const Vector3<Scalar> moment =
      J * slot.alpha + C_J * (dot(e, slot.alpha) * e + dot(e, slot.w) * carried) + cross(h, slot.a);
  const Vector3<Scalar> force =
      body.inertia.mass * slot.a + cross(slot.alpha, h) + body.inertia.first_moment.z * cross(slot.w, carried);
  return {moment, force};
}

// Poses, bias accelerations, and each body's own inertia and Newton-Euler force. given: accelerations of the given
// coordinates (entries of free ones are not read); null if all are free.
template <bool Hybrid, class Memory, class Scalar>
[[gnu::noinline]] void articulated_outwards(const Model<Scalar>& model, Memory& memory, const State<Scalar>& state,
                                            const Scalar* given) {
  auto* const slots = slots_of(memory);
  turn_joints(model, workspace_of(memory), state.q.data());
  for (int i = 0; i < model.body_count(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const auto& parent = slots[body.parent + 1];
    auto& slot = slots[i + 1];
    Vector3<Scalar> w;
    Vector3<Scalar> alpha;
    Vector3<Scalar> a;
    carry_motion(workspace_of(memory), model, body, state, parent, slot, w, alpha, a);
    if constexpr (Hybrid) {
      if (!body.all_free) {
        Scalar known[6] = {Scalar(0), Scalar(0), Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
        for (int k = 0; k < velocity_size(body.joint); ++k) {
          if (model.mode(body.v + k) == CoordinateMode::prescribed) known[k] = given[body.v + k];
        }
        const SpatialMotion<Scalar> own = joint_motion(body, known, slot.R);
        alpha += own.angular;
        a += own.linear;
      }
    }
    const Matrix3<Scalar> A = acceleration_matrix(alpha, w);
    keep_motion(slot, w, alpha, a, A);

    // Its inertia on the tree's axes, and the Newton-Euler force of these accelerations.
    const bool first = body.parent == ground;
    const Vector3<Scalar> h = first ? body.inertia.first_moment : slot.R * body.inertia.first_moment;
    const SymmetricMatrix3<Scalar> I = first ? body.inertia.inertia : turned(slot.R, body.inertia.inertia);
    const Scalar half_trace = Scalar(0.5) * (I.xx + I.yy + I.zz);
    const SymmetricMatrix3<Scalar> E{half_trace - I.xx, half_trace - I.yy, half_trace - I.zz, -I.xy, -I.yz, -I.zx};
    keep_inertia(slot, SpatialInertia<Scalar>{body.inertia.mass, h, I});
    if (body.axisymmetric && !first) {
      slot.bias = force_of_rotor(body, slot, parent.w);
      continue;
    }
    slot.bias.force = body.inertia.mass * a + A * h;
    slot.bias.moment = euler_moment(A, E) + cross(h, a);
  }
}

// A determinant of moments of inertia of this sum, or zero where it is no more than rounding.
template <class Scalar>
constexpr Scalar unless_rounding(const Scalar& determinant, const Scalar& size) {
  constexpr double rounding = 4e-15;
  if constexpr (std::floating_point<Scalar>) {
    return determinant > Scalar(rounding) * size * size * size ? determinant : Scalar(0);
  } else if constexpr (requires { determinant.lanes(); }) {
    auto lanes = determinant.lanes();
    where(!(lanes > (Scalar(rounding) * size * size * size).lanes()), lanes) = 0.0;
    return Scalar(lanes);
  } else {
    return determinant;
  }
}

// The inverse of the inertia that a joint with three turnings moves: not finite where that is singular to rounding.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> inverse_of_moved(const SymmetricMatrix3<Scalar>& a) {
  const Scalar cxx = a.yy * a.zz - a.yz * a.yz;
  const Scalar cxy = a.yz * a.zx - a.xy * a.zz;
  const Scalar czx = a.xy * a.yz - a.yy * a.zx;
  const Scalar determinant = a.xx * cxx + a.xy * cxy + a.zx * czx;
  const Scalar s = Scalar(1) / unless_rounding(determinant, a.xx + a.yy + a.zz);
  return {s * cxx, s * (a.zz * a.xx - a.zx * a.zx), s * (a.xx * a.yy - a.xy * a.xy),
          s * cxy, s * (a.xy * a.zx - a.xx * a.yz), s * czx};
}

// The change of motion that a free body's articulated inertia takes from the force b: I change = b, by blocks.
template <class Scalar>
SpatialMotion<Scalar> solved(const ArticulatedInertia<Scalar>& I, const SpatialForce<Scalar>& b) {
  const SymmetricMatrix3<Scalar> inverse_mass = inverse(I.mass);
  const Vector3<Scalar> g0 = inverse_mass * I.coupling.row0;
  const Vector3<Scalar> g1 = inverse_mass * I.coupling.row1;
  const Vector3<Scalar> g2 = inverse_mass * I.coupling.row2;
  const SymmetricMatrix3<Scalar> schur{
      I.inertia.xx - dot(g0, I.coupling.row0), I.inertia.yy - dot(g1, I.coupling.row1),
      I.inertia.zz - dot(g2, I.coupling.row2), I.inertia.xy - dot(g0, I.coupling.row1),
      I.inertia.yz - dot(g1, I.coupling.row2), I.inertia.zx - dot(g2, I.coupling.row0)};
  const Vector3<Scalar> angular =
      inverse_of_moved(schur) * (b.moment - Vector3<Scalar>{dot(g0, b.force), dot(g1, b.force), dot(g2, b.force)});
  return {angular, inverse_mass * (b.force - transpose_times(I.coupling, angular))};
}

// Eliminates the coordinates from the leaves to the ground. Factor: also compute the articulated inertias; else those
// of the last factoring are used. tau: forces of the free coordinates (entries of given ones are not read).
template <bool Hybrid, bool Factor, class Memory, class Scalar>
[[gnu::noinline]] void articulated_inwards(const Model<Scalar>& model, Memory& memory, const Scalar* tau) {
  auto* const slots = slots_of(memory);
  ArticulatedCoordinate<Scalar>* const coordinates = workspace_of(memory).coordinate.data();
  for (int i = model.body_count() - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    auto& slot = slots[i + 1];
    const bool outmost = body.parent == ground;
    const ArticulatedInertia<Scalar>& I = whole_inertia(slot, body);
    SpatialForce<Scalar> carried = slot.bias;
    const auto hand_on = [&](const ArticulatedInertia<Scalar>& left) {
      if (outmost) return;
      auto& parent = slots[body.parent + 1];
      if constexpr (Factor) add_inertia(parent, model.body(body.parent), shifted(left, slot.r));
      parent.bias += force_from(carried, slot.r);
    };

    if (body.joint == JointType::revolute && (!Hybrid || body.all_free)) {
      ArticulatedCoordinate<Scalar>& c = coordinates[body.v];
      const Vector3<Scalar> e = z_axis(slot.R);
      if constexpr (Factor) {
        c.U = {I.inertia * e, transpose_times(I.coupling, e)};
        c.inverse_inertia = Scalar(1) / dot(e, c.U.moment);
      }
      c.residual = tau[body.v] - dot(e, carried.moment);
      carried += (c.residual * c.inverse_inertia) * c.U;
      if (outmost) continue;
      auto& parent = slots[body.parent + 1];
      if constexpr (Factor) add_reduced(parent, model.body(body.parent), I, c.U, c.inverse_inertia, slot.r);
      parent.bias += force_from(carried, slot.r);
    } else if (body.joint == JointType::ball && (!Hybrid || body.all_free)) {
      // The joint's moment is known whole: n = I alpha + H a + n_bias gives alpha, and what is left is a mass.
      const Vector3<Scalar> n = outmost ? three(tau + body.v) : slot.R * three(tau + body.v);
      if constexpr (Factor) slot.inverse_inertia = inverse_of_moved(I.inertia);
      const Vector3<Scalar> turn = slot.inverse_inertia * (n - carried.moment);
      carried.moment = n;
      carried.force += transpose_times(I.coupling, turn);
      slot.change.angular = turn;
      if (Factor && !outmost) {
        const SymmetricMatrix3<Scalar>& J = slot.inverse_inertia;
        const Vector3<Scalar> h0 = I.coupling.column(0);
        const Vector3<Scalar> h1 = I.coupling.column(1);
        const Vector3<Scalar> h2 = I.coupling.column(2);
        const Vector3<Scalar> g0 = J * h0;
        const Vector3<Scalar> g1 = J * h1;
        const Vector3<Scalar> g2 = J * h2;
        hand_on({SymmetricMatrix3<Scalar>::zero(), Matrix3<Scalar>::zero(),
                 SymmetricMatrix3<Scalar>{I.mass.xx - dot(h0, g0), I.mass.yy - dot(h1, g1), I.mass.zz - dot(h2, g2),
                                          I.mass.xy - dot(h0, g1), I.mass.yz - dot(h1, g2), I.mass.zx - dot(h2, g0)}});
      } else {
        hand_on(I);
      }
    } else if (body.joint == JointType::free && (!Hybrid || body.all_free)) {
      // Nothing but the joint's own force is carried on.
      const SpatialForce<Scalar> own{three(tau + body.v), three(tau + body.v + 3)};
      const SpatialForce<Scalar> f = outmost ? own : SpatialForce<Scalar>{slot.R * own.moment, slot.R * own.force};
      slot.change = solved(I, f - carried);
      carried = f;
      if (!outmost) slots[body.parent + 1].bias += force_from(carried, slot.r);
    } else {
      ArticulatedInertia<Scalar> left = I;
      for (int k = velocity_size(body.joint) - 1; k >= 0; --k) {
        ArticulatedCoordinate<Scalar>& c = coordinates[body.v + k];
        const SpatialMotion<Scalar> S = coordinate_motion(body, k, slot.R);
        if constexpr (Factor) c.U = left * S;
        if (Hybrid && model.mode(body.v + k) != CoordinateMode::free) {
          c.residual = -dot(S, carried);
          continue;
        }
        if constexpr (Factor) {
          c.inverse_inertia = Scalar(1) / dot(S, c.U);
          left = reduced(left, c.U, c.inverse_inertia);
        }
        c.residual = tau[body.v + k] - dot(S, carried);
        carried += (c.residual * c.inverse_inertia) * c.U;
      }
      hand_on(left);
    }
  }
}

// Solves for the free coordinates from the ground to the leaves. For a free coordinate acceleration[k] is written (the
// change; the free coordinates had none before), for a given one force[k] is written.
template <bool Hybrid, class Memory, class Scalar>
[[gnu::noinline]] void articulated_back(const Model<Scalar>& model, Memory& memory, Scalar* acceleration,
                                        Scalar* force) {
  auto* const slots = slots_of(memory);
  const ArticulatedCoordinate<Scalar>* const coordinates = workspace_of(memory).coordinate.data();
  slots[0].change = SpatialMotion<Scalar>::zero();
  for (int i = 0; i < model.body_count(); ++i) {
    const Body<Scalar>& body = model.body(i);
    auto& slot = slots[i + 1];
    SpatialMotion<Scalar> change = motion_at(slots[body.parent + 1].change, slot.r);
    Scalar* const qdd = acceleration + body.v;
    if (body.joint == JointType::revolute && (!Hybrid || body.all_free)) {
      const ArticulatedCoordinate<Scalar>& c = coordinates[body.v];
      qdd[0] = (c.residual - dot(change, c.U)) * c.inverse_inertia;
      change.angular += qdd[0] * z_axis(slot.R);
    } else if (body.joint == JointType::ball && (!Hybrid || body.all_free)) {
      const Vector3<Scalar> angular =
          slot.change.angular - slot.inverse_inertia * (slot.inertia.coupling * change.linear);
      const Vector3<Scalar> own = transpose_times(slot.R, angular - change.angular);
      qdd[0] = own.x;
      qdd[1] = own.y;
      qdd[2] = own.z;
      change.angular = angular;
    } else if (body.joint == JointType::free && (!Hybrid || body.all_free)) {
      const SpatialMotion<Scalar> relative = slot.change - change;
      const Vector3<Scalar> turn = transpose_times(slot.R, relative.angular);
      const Vector3<Scalar> shift = transpose_times(slot.R, relative.linear);
      qdd[0] = turn.x;
      qdd[1] = turn.y;
      qdd[2] = turn.z;
      qdd[3] = shift.x;
      qdd[4] = shift.y;
      qdd[5] = shift.z;
      change = slot.change;
    } else {
      for (int k = 0; k < velocity_size(body.joint); ++k) {
        const ArticulatedCoordinate<Scalar>& c = coordinates[body.v + k];
        if (Hybrid && model.mode(body.v + k) != CoordinateMode::free) {
          force[body.v + k] = dot(change, c.U) - c.residual;
          continue;
        }
        qdd[k] = (c.residual - dot(change, c.U)) * c.inverse_inertia;
        change += qdd[k] * coordinate_motion(body, k, slot.R);
      }
    }
    slot.change = change;
  }
}

// External wrenches (on body axes about body origins) act against the bias.
template <class Scalar>
void subtract_external(const Model<Scalar>& model, Workspace<Scalar>& workspace,
                       std::span<const SpatialForce<Scalar>> external) {
  for (std::size_t i = 0; i < external.size(); ++i) {
    ArticulatedBody<Scalar>& slot = workspace.articulated[i + 1];
    const Matrix3<Scalar>& R_WB = model.body(static_cast<int>(i)).R_WB;
    slot.bias.moment -= slot.R * (R_WB * external[i].moment);
    slot.bias.force -= slot.R * (R_WB * external[i].force);
  }
}

}  // namespace poinsot::detail
