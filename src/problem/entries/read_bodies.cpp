#include "problem/entries/read_bodies.h"

#include <algorithm>

#include "problem/keys/keys.h"
#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

// Whether the argument of this shape is a point or a list of points.
bool takes_points(const std::string& kind) { return find_key("shape", kind)->type != KeyType::object; }

Shape read_shape(const std::string& kind, const Entry& entry, const std::string& file) {
  Shape shape;
  shape.kind = kind;
  shape.mark = entry.mark;
  if (takes_points(kind)) {
    shape.arguments.push_back({"points", parse_expression(entry, file), entry.mark});
    return shape;
  }
  const Members members(entry, file, {kind});
  for (const auto& [key, value] : entry.members) {
    const KeyType type = find_key(kind, key.text)->type;
    if (type == KeyType::text)
      shape.file = kind == "mesh" ? scalar_text(value, file, "the name of a file") : shape.file;
    if (type == KeyType::text || type == KeyType::unit) {
      // A word such as 'open' or a unit such as 'mm' is kept as it is written.
      scalar_text(value, file, "a word");
      continue;
    }
    shape.arguments.push_back({key.text, parse_expression(value, file), value.mark});
  }
  if (kind == "cylinder_shell" && members.find("ends")) {
    const std::string ends = members.text("ends");
    if (ends != "open" && ends != "closed")
      fail(file, members.mark_of("ends"), "'" + ends + "' is neither open nor closed");
    if (ends == "closed") shape.kind = "closed_cylinder_shell";
  }
  if (kind == "sector" && members.find("inner_radius")) shape.kind = "annular_sector";
  if (kind == "sector" && members.find("thickness")) shape.kind = "thick_sector";
  if (kind == "mesh") {
    members.require("file", "file: wheel.stl");
    const Entry& unit = members.require("unit", "unit: mm");
    try {
      shape.mesh_unit = parse_unit(scalar_text(unit, file, "a unit of length"));
    } catch (const std::invalid_argument& error) {
      fail(file, unit.mark, error.what());
    }
  }
  return shape;
}

std::optional<Shape> find_shape(const Members& members, const std::string& file, const std::string& owner) {
  std::optional<Shape> shape;
  std::string first;
  for (const auto& [key, value] : members.entry().members) {
    if (!find_key("shape", key.text)) continue;
    if (shape)
      fail(file, key.mark, owner + " has two shapes, '" + first + "' and '" + key.text + "'",
           "a body of several shapes lists them under parts:");
    first = key.text;
    shape = read_shape(key.text, value, file);
  }
  return shape;
}

Amount read_amount(const Members& members, const std::string& file, const std::string& owner) {
  Amount amount;
  amount.mass = members.expression("mass");
  amount.weight = members.expression("weight");
  amount.density = members.expression("density");
  amount.specific_weight = members.expression("specific_weight");
  std::string first;
  for (const char* key : {"mass", "weight", "density", "specific_weight"}) {
    if (!members.find(key)) continue;
    if (!first.empty())
      fail(file, members.mark_of(key), owner + " states both " + first + " and " + key, "state one of them");
    first = key;
  }
  return amount;
}

std::vector<Part> read_parts(const Entry& entry, const std::string& file) {
  if (entry.kind != Entry::Kind::map || entry.members.empty())
    fail(file, entry.mark, "expected named parts", "write parts: {rim: {ring: {...}}, hub: {disk: {...}}}");
  std::vector<Part> parts;
  for (const auto& [key, value] : entry.members) {
    check_name(key.text, key.mark, file);
    const Members members(value, file, {"part", "shape"});
    Part part;
    part.name = key.text;
    part.mark = key.mark;
    const std::optional<Shape> shape = find_shape(members, file, "part '" + key.text + "'");
    if (!shape) fail(file, value.mark, "part '" + key.text + "' has no shape", "give it one, such as rod: [A, B]");
    part.shape = *shape;
    part.amount = read_amount(members, file, "part '" + key.text + "'");
    part.hole = members.boolean("hole").value_or(false);
    parts.push_back(std::move(part));
  }
  return parts;
}

// Reads moments of inertia, named after the axes, and products, named after two axes in either order.
StatedInertia read_inertia(const std::string& key, const Entry& entry, const ReadContext& context) {
  const auto& axes = context.axes;
  std::vector<std::string> moments(axes.begin(), axes.end());
  std::vector<std::string> products;
  for (int i = 0; i < 3; ++i) {
    products.push_back(axes[i] + axes[(i + 1) % 3]);
    products.push_back(axes[(i + 1) % 3] + axes[i]);
  }
  std::vector<std::string> extra = key == "inertia_matrix" ? std::vector<std::string>{} : moments;
  if (key == "inertia") extra.insert(extra.end(), products.begin(), products.end());
  const Members members(entry, context.file, {key}, extra);

  StatedInertia inertia;
  inertia.mark = entry.mark;
  inertia.radii = key == "radii_of_gyration";
  inertia.about = members.expression("about");
  inertia.axes = members.list("axes");
  if (key == "inertia_matrix") {
    inertia.matrix = members.require_expression("rows", "rows: [[Ixx, -Ixy, -Izx], [...], [...]]");
    return inertia;
  }
  inertia.axis = members.expression("axis");
  inertia.axial = members.expression("axial");
  inertia.transverse = members.expression("transverse");
  for (int i = 0; i < 3; ++i) {
    inertia.moments[i] = members.expression(moments[i]);
    if (key != "inertia") continue;
    inertia.products[i] = members.expression(products[2 * i]);
    if (const auto turned = members.expression(products[2 * i + 1])) {
      if (inertia.products[i])
        fail(context.file, members.mark_of(products[2 * i + 1]),
             "the product of inertia " + products[2 * i] + " is stated twice, also as " + products[2 * i + 1]);
      inertia.products[i] = turned;
    }
  }
  const bool any_moment = std::any_of(inertia.moments.begin(), inertia.moments.end(),
                                      [](const auto& moment) { return moment.has_value(); });
  if (inertia.axis && any_moment)
    fail(context.file, entry.mark,
         key + " states both an axis of revolution and moments about " + axes[0] + ", " + axes[1] + ", " + axes[2],
         "state one or the other");
  if (inertia.axis && !(inertia.axial && inertia.transverse))
    fail(context.file, entry.mark, key + " with an axis needs axial and transverse");
  if (!inertia.axis && (inertia.axial || inertia.transverse))
    fail(context.file, entry.mark, key + " with axial and transverse needs the axis");
  const std::string rest = key == "inertia" ? members.text("rest") : "";
  if (!rest.empty() && rest != "any")
    fail(context.file, members.mark_of("rest"), "'" + rest + "' is not understood", "write rest: any, or leave it out");
  inertia.rest_any = rest == "any";
  inertia.flat = context.plane.has_value();
  const auto needed = [&](int i) { return !context.plane || static_cast<std::size_t>(i) == context.plane->normal(); };
  if (!inertia.axis && !inertia.rest_any)
    for (int i = 0; i < 3; ++i)
      if (!inertia.moments[i] && needed(i))
        fail(context.file, entry.mark, key + " leaves out " + axes[i],
             key == "inertia" ? "state it, or write rest: any" : "state it");
  return inertia;
}

}  // namespace

Body read_body(const std::string& name, Mark mark, const Entry& entry, const ReadContext& context) {
  Body body;
  body.name = name;
  body.mark = mark;
  const std::string& file = context.file;
  if (entry.kind == Entry::Kind::scalar && entry.text == "massless") {
    body.massless = true;
    return body;
  }
  const std::string owner = "body '" + name + "'";
  const Members members(entry, file, {"body", "shape"});
  body.amount = read_amount(members, file, owner);
  body.center = members.expression("center");
  if (const Entry* parts = members.find("parts")) body.parts = read_parts(*parts, file);
  if (const Entry* added = members.find("added")) body.added = read_parts(*added, file);
  if (auto shape = find_shape(members, file, owner)) {
    if (!body.parts.empty())
      fail(file, shape->mark, owner + " has both a shape and parts", "move the shape into parts:");
    Part part;
    part.name = name;
    part.shape = std::move(*shape);
    part.mark = mark;
    body.parts.push_back(std::move(part));
  }
  for (const char* key : {"radii_of_gyration", "inertia", "inertia_matrix"}) {
    const Entry* found = members.find(key);
    if (!found) continue;
    if (found->kind == Entry::Kind::scalar && found->text == "any") continue;  // as if the file did not mention it
    if (body.inertia) fail(file, found->mark, owner + " states its inertia twice");
    body.inertia = read_inertia(key, *found, context);
  }
  if (!body.parts.empty() && (body.inertia || body.center))
    fail(file, mark, owner + " has shapes and also states " + (body.inertia ? "its inertia" : "its mass center"),
         "the shapes give both; remove one");
  if (body.parts.empty() && !body.center)
    fail(file, mark, owner + " has neither a shape nor a mass center",
         "give it a shape, or mass, center and radii_of_gyration or inertia, or write massless");
  if (body.parts.empty() && !body.amount.mass && !body.amount.weight)
    fail(file, mark, owner + " has no mass", "write mass: or weight:");
  // If neither a shape nor numbers give the inertia it is open. Its mark is then that of the body.
  if (body.parts.empty() && !body.inertia) {
    body.inertia.emplace();
    body.inertia->mark = mark;
    body.inertia->rest_any = true;
  }
  return body;
}

}  // namespace poinsot::problem
