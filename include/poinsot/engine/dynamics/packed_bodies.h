// Forward dynamics for packs of cases, in a memory of its own: a pack has several times the numbers of a case, so that
// to write them down takes a good part of the time. What is soon computed again is not kept, and the inertia of a body
// is only put together where one outboard of it is added.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/dynamics/articulated_body.h"

namespace poinsot {

// What is kept of a body, on the axes of its tree's first body about its own origin, as in ArticulatedBody.
template <class Scalar>
struct PackedBody {
  Matrix3<Scalar> R{};
  Vector3<Scalar> r{};
  Vector3<Scalar> w{};
  Vector3<Scalar> alpha{};
  Vector3<Scalar> a{};
  SpatialForce<Scalar> bias{};
  Vector3<Scalar> own_first_moment{};
  SymmetricMatrix3<Scalar> own_inertia{};
  bool has_outboard = false;  // whether `inertia` holds its own inertia and some outboard
  ArticulatedInertia<Scalar> inertia{};
  SymmetricMatrix3<Scalar> inverse_inertia{};
  SpatialMotion<Scalar> change{};
};

// One serves one thread, as the workspace does, of which it uses the angles and coordinates.
template <class Scalar>
struct PackedBodies {
  PackedBodies(const Model<Scalar>& model, Workspace<Scalar>& own_workspace)
      : workspace(own_workspace), bodies(static_cast<std::size_t>(model.body_count()) + 1) {}

  Workspace<Scalar>& workspace;
  std::vector<PackedBody<Scalar>> bodies;  // slot 0 is the ground
};

template <class Scalar>
Workspace<Scalar>& workspace_of(PackedBodies<Scalar>& memory) {
  return memory.workspace;
}
template <class Scalar>
PackedBody<Scalar>* slots_of(PackedBodies<Scalar>& memory) {
  return memory.bodies.data();
}
template <class Scalar>
void keep_motion(PackedBody<Scalar>& slot, const Vector3<Scalar>& w, const Vector3<Scalar>& alpha,
                 const Vector3<Scalar>& a, const Matrix3<Scalar>&) {
  slot.w = w;
  slot.alpha = alpha;
  slot.a = a;
}
template <class Scalar>
Vector3<Scalar> relative_acceleration(const PackedBody<Scalar>& slot, const Vector3<Scalar>& r) {
  return cross(slot.alpha, r) + cross(slot.w, cross(slot.w, r));
}
template <class Scalar>
void keep_inertia(PackedBody<Scalar>& slot, const SpatialInertia<Scalar>& own) {
  slot.own_first_moment = own.first_moment;
  slot.own_inertia = own.inertia;
  slot.has_outboard = false;
}

namespace detail {

template <class Scalar>
ArticulatedInertia<Scalar> own_inertia(const PackedBody<Scalar>& slot, const Body<Scalar>& body) {
  return ArticulatedInertia<Scalar>::of(
      SpatialInertia<Scalar>{body.inertia.mass, slot.own_first_moment, slot.own_inertia});
}

// Adds shifted(reduced(I, U, s), r) to a body's inertia, or (First) to its own, block by block, so that few numbers are
// in hand at a time.
template <bool First, class Scalar>
void put_reduced(PackedBody<Scalar>& slot, const Scalar& mass, const ArticulatedInertia<Scalar>& I,
                 const SpatialForce<Scalar>& U, const Scalar& s, const Vector3<Scalar>& r) {
  ArticulatedInertia<Scalar>& to = slot.inertia;
  const Vector3<Scalar>& f = U.force;
  const Vector3<Scalar> g = s * f;
  const SymmetricMatrix3<Scalar> M{I.mass.xx - g.x * f.x, I.mass.yy - g.y * f.y, I.mass.zz - g.z * f.z,
                                   I.mass.xy - g.x * f.y, I.mass.yz - g.y * f.z, I.mass.zx - g.z * f.x};
  if constexpr (First)
    to.mass = {mass + M.xx, mass + M.yy, mass + M.zz, M.xy, M.yz, M.zx};
  else
    to.mass += M;

  // H' = H + [r]x M, row by row, S = H + H'; the body's own is [h]x.
  const Vector3<Scalar>& n = U.moment;
  const Vector3<Scalar> m = s * n;
  const Vector3<Scalar>& h = slot.own_first_moment;
  const auto put = [](Vector3<Scalar>& row, const Vector3<Scalar>& C, const Vector3<Scalar>& first) {
    row = First ? first : row + C;
  };
  const Vector3<Scalar> H0 = I.coupling.row0 - m.x * f;
  const Vector3<Scalar> C0 =
      H0 + Vector3<Scalar>{r.y * M.zx - r.z * M.xy, r.y * M.yz - r.z * M.yy, r.y * M.zz - r.z * M.yz};
  put(to.coupling.row0, C0, {C0.x, C0.y - h.z, C0.z + h.y});
  const Vector3<Scalar> S0 = H0 + C0;
  const Vector3<Scalar> H1 = I.coupling.row1 - m.y * f;
  const Vector3<Scalar> C1 =
      H1 + Vector3<Scalar>{r.z * M.xx - r.x * M.zx, r.z * M.xy - r.x * M.yz, r.z * M.zx - r.x * M.zz};
  put(to.coupling.row1, C1, {C1.x + h.z, C1.y, C1.z - h.x});
  const Vector3<Scalar> S1 = H1 + C1;
  const Vector3<Scalar> H2 = I.coupling.row2 - m.z * f;
  const Vector3<Scalar> C2 =
      H2 + Vector3<Scalar>{r.x * M.xy - r.y * M.xx, r.x * M.yy - r.y * M.xy, r.x * M.yz - r.y * M.zx};
  put(to.coupling.row2, C2, {C2.x - h.y, C2.y + h.x, C2.z});
  const Vector3<Scalar> S2 = H2 + C2;

  const Scalar half(0.5);
  const SymmetricMatrix3<Scalar>& A = I.inertia;
  const SymmetricMatrix3<Scalar>& before = First ? slot.own_inertia : to.inertia;
  to.inertia.xx = before.xx + (A.xx - m.x * n.x + (r.y * S0.z - r.z * S0.y));
  to.inertia.yy = before.yy + (A.yy - m.y * n.y + (r.z * S1.x - r.x * S1.z));
  to.inertia.zz = before.zz + (A.zz - m.z * n.z + (r.x * S2.y - r.y * S2.x));
  to.inertia.xy = before.xy + (A.xy - m.x * n.y + half * (r.y * S1.z - r.z * S1.y + r.z * S0.x - r.x * S0.z));
  to.inertia.yz = before.yz + (A.yz - m.y * n.z + half * (r.z * S2.x - r.x * S2.z + r.x * S1.y - r.y * S1.x));
  to.inertia.zx = before.zx + (A.zx - m.z * n.x + half * (r.x * S0.y - r.y * S0.x + r.y * S2.z - r.z * S2.y));
}

}  // namespace detail

template <class Scalar>
const ArticulatedInertia<Scalar>& whole_inertia(PackedBody<Scalar>& slot, const Body<Scalar>& body) {
  if (!slot.has_outboard) slot.inertia = detail::own_inertia(slot, body);
  return slot.inertia;
}
template <class Scalar>
void add_inertia(PackedBody<Scalar>& slot, const Body<Scalar>& body, const ArticulatedInertia<Scalar>& outboard) {
  if (!slot.has_outboard) slot.inertia = detail::own_inertia(slot, body);
  slot.inertia += outboard;
  slot.has_outboard = true;
}
template <class Scalar>
void add_reduced(PackedBody<Scalar>& slot, const Body<Scalar>& body, const ArticulatedInertia<Scalar>& I,
                 const SpatialForce<Scalar>& U, const Scalar& inverse_inertia, const Vector3<Scalar>& r) {
  if (slot.has_outboard)
    detail::put_reduced<false>(slot, body.inertia.mass, I, U, inverse_inertia, r);
  else
    detail::put_reduced<true>(slot, body.inertia.mass, I, U, inverse_inertia, r);
  slot.has_outboard = true;
}

// As forward_dynamics() of forward_dynamics.h, without external wrenches.
template <class Scalar>
void forward_dynamics(const Model<Scalar>& model, PackedBodies<Scalar>& memory, const State<Scalar>& state,
                      std::span<const Scalar> force, std::span<Scalar> acceleration) {
  detail::require_size("forward_dynamics", "q", state.q.size(), model.position_size());
  detail::require_size("forward_dynamics", "v", state.v.size(), model.velocity_size());
  detail::require_size("forward_dynamics", "force", force.size(), model.velocity_size());
  detail::require_size("forward_dynamics", "acceleration", acceleration.size(), model.velocity_size());
  detail::articulated_outwards<false>(model, memory, state, static_cast<const Scalar*>(nullptr));
  detail::articulated_inwards<false, true>(model, memory, force.data());
  detail::articulated_back<false>(model, memory, acceleration.data(), static_cast<Scalar*>(nullptr));
}

}  // namespace poinsot
