// What a situation says in another way than the top of the file takes its place.
#include "problem/keys/laid_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::problem {
namespace laid_over_test {

// Maps by their keys in order, so that the order of the file does not count.
std::string said(const Entry& entry) {
  if (entry.is_scalar()) return entry.text;
  std::string text;
  if (entry.is_list()) {
    for (const Entry& item : entry.items) text += said(item) + " ";
    return "[" + text + "]";
  }
  std::vector<std::string> members;
  for (const auto& [key, value] : entry.members) members.push_back(key.text + ": " + said(value));
  std::ranges::sort(members);
  for (const std::string& member : members) text += member + "; ";
  return "{" + text + "}";
}
std::string said(const std::string& text) { return said(read_tree(text, "x.yaml")); }
std::string laid(const std::string& base, const std::string& overlay) {
  return said(laid_over(read_tree(base, "x.yaml"), read_tree(overlay, "x.yaml")));
}
std::string body(const std::string& text) { return "bodies: {b: {" + text + "}}\n"; }

TEST(LaidOver, AnotherShapeReplacesTheFirst) {
  const std::string disk = "disk: {center: O, normal: z, radius: r}, mass: m";
  const auto expect = [&](const std::string& base, const std::string& overlay, const std::string& result) {
    EXPECT_EQ(laid(body(base), body(overlay)), said(body(result))) << base << " under " << overlay;
  };
  expect(disk, "ring: {center: O, normal: z, radius: r}", "ring: {center: O, normal: z, radius: r}, mass: m");
  expect(disk, "rod: [A, B], density: q", "rod: [A, B], density: q");
  expect(disk, "disk: {radius: 2*r}", "disk: {center: O, normal: z, radius: 2*r}, mass: m");
  expect(disk, "center: O, inertia: {axis: z, axial: I, transverse: J}",
         "center: O, inertia: {axis: z, axial: I, transverse: J}, mass: m");
  expect("center: O, inertia: {x: I, y: I, z: I}, mass: m", "sphere: {center: O, radius: r}",
         "sphere: {center: O, radius: r}, mass: m");
  expect("center: O, inertia: {about: A, x: I, y: I, z: I}, mass: m", "inertia: {axis: z, axial: I, transverse: J}",
         "center: O, inertia: {about: A, axis: z, axial: I, transverse: J}, mass: m");
  expect("center: O, inertia: {x: I, y: I, z: I}, mass: m", "radii_of_gyration: {x: k, y: k, z: k}",
         "center: O, radii_of_gyration: {x: k, y: k, z: k}, mass: m");
  expect("center: O, inertia: {x: I, y: I, z: I}, mass: m", "inertia: {x: 2*I}",
         "center: O, inertia: {x: 2*I, y: I, z: I}, mass: m");
  expect("rectangle: {corners: [O, A, B]}, mass: m", "rectangle: {center: O, sides: [u, v]}",
         "rectangle: {center: O, sides: [u, v]}, mass: m");
  // Parts are added to parts; those that state their matter leave none of the whole.
  expect("parts: {a: {rod: [O, A], mass: m}}", "parts: {b: {particle: B, mass: n}}",
         "parts: {a: {rod: [O, A], mass: m}, b: {particle: B, mass: n}}");
  expect("parts: {a: {rod: [O, A], mass: m}}", "parts: {a: {particle: B, weight: n}}",
         "parts: {a: {particle: B, weight: n}}");
  expect(disk, "parts: {a: {rod: [O, A], mass: p}, b: {particle: B, mass: q}}",
         "parts: {a: {rod: [O, A], mass: p}, b: {particle: B, mass: q}}");
  expect(disk, "parts: {a: {rod: [O, A]}, b: {particle: B, mass: q}}",
         "parts: {a: {rod: [O, A]}, b: {particle: B, mass: q}}, mass: m");
}

TEST(LaidOver, WhatElseIsSaidInAnotherWay) {
  EXPECT_EQ(laid("joints: {j: {revolute: z, at: O, to: b, angle: q, rate: n}}\n", "joints: {j: {prismatic: x}}\n"),
            said("joints: {j: {prismatic: x, at: O, to: b}}\n"));
  EXPECT_EQ(laid("joints: {j: {revolute: z, at: O, to: b, angle: q, rate: n}}\n", "joints: {j: {angle: 0}}\n"),
            said("joints: {j: {revolute: z, at: O, to: b, angle: 0, rate: n}}\n"));
  EXPECT_EQ(laid("contacts: {c: {of: b, at: A, normal: y, no_slip: true}}\n", "contacts: {c: {friction: mu}}\n"),
            said("contacts: {c: {of: b, at: A, normal: y, friction: mu}}\n"));
  EXPECT_EQ(laid("contacts: {c: {of: b, at: A, normal: y}}\n", "contacts: {c: {corner: B}}\n"),
            said("contacts: {c: {of: b, corner: B, normal: y}}\n"));
  EXPECT_EQ(laid("loads: {p: {force: F, along: x, at: A, body: b}}\n", "loads: {p: {couple: M, about: z}}\n"),
            said("loads: {p: {couple: M, about: z, body: b}}\n"));
  EXPECT_EQ(laid("given: {m: 1 kg, n: 2}\ngravity: -y\n", "given: {n: 3}\ngravity: none\n"),
            said("given: {m: 1 kg, n: 3}\ngravity: none\n"));
}

}  // namespace laid_over_test
}  // namespace poinsot::problem
