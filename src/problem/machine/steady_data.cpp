// What a motion holds constant: masses, shapes, the places of joints, springs and dampers.
#include <string>

#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {
namespace {

class SteadyData {
 public:
  explicit SteadyData(const Situation& situation) : situation_(situation) {}

  void require(const std::optional<Expression>& expression, const std::string& owner) const {
    if (expression) require(*expression, owner);
  }
  void require(const Expression& expression, const std::string& owner) const {
    if (depends_on_time(situation_, expression))
      fail(situation_.file, expression.mark(), owner + " is stated with data that change with time",
           "loads, and what is stated of the freedoms of joints and of frames, may follow time; other data may not");
  }
  void require(const Amount& amount, const std::string& owner) const {
    for (const auto* one : {&amount.mass, &amount.weight, &amount.density, &amount.specific_weight})
      require(*one, owner);
  }
  void require(const std::vector<Part>& parts, const std::string& owner) const {
    for (const Part& part : parts) {
      require(part.amount, owner);
      for (const NamedExpression& argument : part.shape.arguments) require(argument.value, owner);
    }
  }

 private:
  const Situation& situation_;
};

}  // namespace

void require_steady_data(const Situation& situation) {
  const SteadyData steady(situation);
  for (const Body& body : situation.bodies) {
    const std::string owner = "body '" + body.name + "'";
    steady.require(body.amount, owner);
    steady.require(body.parts, owner);
    steady.require(body.added, owner);
    steady.require(body.center, owner);
    if (!body.inertia) continue;
    const StatedInertia& I = *body.inertia;
    for (const auto* numbers : {&I.moments, &I.products})
      for (const std::optional<Expression>& number : *numbers) steady.require(number, owner);
    for (const auto* one : {&I.about, &I.axis, &I.axial, &I.transverse, &I.matrix}) steady.require(*one, owner);
    for (const Expression& axis : I.axes) steady.require(axis, owner);
  }
  for (const Joint& joint : situation.joints) {
    const std::string owner = "joint '" + joint.name + "'";
    steady.require(joint.place, owner);
    steady.require(joint.at, owner);
    steady.require(joint.pitch, owner);
    for (const Freedom& freedom : joint.freedoms)
      for (const auto* one : {&freedom.direction, &freedom.stiffness, &freedom.free_position, &freedom.damping})
        steady.require(*one, owner);
  }
  for (const Gear& gear : situation.gears)
    for (const auto* one :
         {&gear.pressure_angle, &gear.normal_pressure_angle, &gear.helix_angle, &gear.lead, &gear.friction})
      steady.require(*one, "gear '" + gear.name + "'");
  for_each_stated_law(situation, [&]<StatedLaw Law>(const Law& law) {
    if (Law::may_follow_time) return;
    law.for_each_part([&](LawPart, const std::optional<Expression>& part) {
      steady.require(part, "'" + law.name + "' under " + Law::list + ":");
    });
  });
}

}  // namespace poinsot::problem
