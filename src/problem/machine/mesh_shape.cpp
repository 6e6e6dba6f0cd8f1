#include <stdexcept>

#include "problem/entries/read_meshes.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/shape_arguments.h"

namespace poinsot::problem {

template <class Scalar>
ShapeValues<Scalar> mesh_shape(const ShapeArguments<Scalar>& arguments, const Vector3<Scalar>& p_OM) {
  if (is_exact<Scalar>) throw NoFormula("the numbers of a mesh are not exact");
  if (!arguments.shape().mesh) throw std::logic_error("a mesh of the statement has not been read");
  const MeshSolid& solid = *arguments.shape().mesh;
  // The solid itself is constant, but its place may vary.
  const ShapeProperties<Scalar> properties{lifted<Scalar>(solid.properties.measure),
                                           lifted<Scalar>(solid.properties.center) + p_OM,
                                           lifted<Scalar>(solid.properties.inertia_center)};
  return arguments.values(Extent::volume, properties, [&] {
    ParticleSet<double> set = particles::solid_of_mesh(solid.mesh);
    for (WeightedParticle<double>& particle : set.particles) particle.position += plain(p_OM);
    return set;
  });
}

template ShapeValues<double> mesh_shape(const ShapeArguments<double>&, const Vector3<double>&);
template ShapeValues<Dual<1>> mesh_shape(const ShapeArguments<Dual<1>>&, const Vector3<Dual<1>>&);
template ShapeValues<Formula> mesh_shape(const ShapeArguments<Formula>&, const Vector3<Formula>&);

}  // namespace poinsot::problem
