// Limits of what holds within so narrow a range of values that steps pass over it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace narrow_window_test {

using std::numbers::pi;

// A block needs a force between W (sin b - mu cos b) and W (sin b + mu cos b), whatever it has by itself.
TEST(NarrowWindow, ForcesThatHoldABlockOnASteepSlope) {
  constexpr double W = 500;
  for (const double mu : {0.1, 0.05, 1e-3, 1e-5})
    for (const double degrees : {15.0, 30.0, 71.0})
      for (const bool open : {true, false}) {
        const double b = degrees * pi / 180;
        const SolvedText solved(
            "title: t\ngiven: {W: 500 N, mu: " + std::to_string(mu) + ", b: " + std::to_string(degrees) +
            (open ? " deg}\nletters: {P: N}\n" : " deg, P: 30 N}\n") +
            "points: {C: [0, 0, 0]}\nbodies: {block: {particle: C, weight: W}}\n"
            "contacts: {slope: {of: block, at: C, normal: '[sin(b), cos(b), 0]', friction: mu}}\n"
            "loads: {hold: {force: P, along: '[-cos(b), sin(b), 0]', body: block}}\ngravity: -y\ninstants: {now: "
            "rest}\n"
            "ask: {least: {smallest: P, while: sticking(slope)}, most: {largest: P, while: sticking(slope)}}\n");
        EXPECT_NEAR(solved.number("least"), W * (std::sin(b) - mu * std::cos(b)), 1e-11 * W) << mu << " " << degrees;
        EXPECT_NEAR(solved.number("most"), W * (std::sin(b) + mu * std::cos(b)), 1e-11 * W) << mu << " " << degrees;
      }
}

TEST(NarrowWindow, ForcesThatHoldALoadOnARopeRoundAPost) {
  const SolvedText solved(
      "title: t\nplane: [x, y]\ngiven: {W: 600 N, mu: 0.02, r: 50 mm}\nletters: {P: N}\npoints: {O: [0, 0]}\n"
      "bodies: {load: {particle: '[r, -1 m]', weight: W}, hand: {particle: '[-r, -1 m]', weight: 1 N}}\n"
      "cords: {rope: {from: load, at: '[r, -1 m]', over: [{O: {radius: r, friction: mu}}], to: hand, end: '[-r, -1 "
      "m]'}}\n"
      "loads: {hold: {force: [0, -P], at: '[-r, -1 m]', body: hand}}\ngravity: -y\n"
      "facts: {velocity(load): [0, 0], velocity(hand): [0, 0]}\n"
      "ask: {least: {smallest: P, while: sticking(rope on O)}, most: {largest: P, while: sticking(rope on O)}}\n");
  EXPECT_NEAR(solved.number("least"), 600 * std::exp(-0.02 * pi) - 1, 1e-5);
  EXPECT_NEAR(solved.number("most"), 600 * std::exp(0.02 * pi) - 1, 1e-5);
}

// A pendulum of length L swings at sqrt(g/L): between 2 and 2.0001 rad/s in a ten thousandth of its lengths.
TEST(NarrowWindow, ComparisonsOfWhichBothSidesAreClose) {
  const SolvedText solved(
      "title: t\nletters: {L: m}\npoints: {O: [0, 0, 0], G: [0, -L, 0]}\nbodies: {bob: {particle: G, mass: 1 kg}}\n"
      "joints: {pivot: {revolute: z, at: O, to: bob}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {most: {largest: L, while: ['max(frequencies(bob)) > 2 rad/s', 'max(frequencies(bob)) < 2.0001 "
      "rad/s']}}\n");
  EXPECT_NEAR(solved.number("most"), 9.80665 / 4, 1e-7);
}

TEST(NarrowWindow, WhatHoldsNowhereIsStillSaid) {
  const SolvedText solved(
      "title: t\nletters: {L: m}\npoints: {O: [0, 0, 0], G: [0, -L, 0]}\nbodies: {bob: {particle: G, mass: 1 kg}}\n"
      "joints: {pivot: {revolute: z, at: O, to: bob}}\ngravity: -y\ninstants: {now: rest}\n"
      "ask: {most: {largest: L, while: ['max(frequencies(bob)) > 2 rad/s', 'max(frequencies(bob)) < 1.9999 "
      "rad/s']}}\n");
  EXPECT_TRUE(solved.reason("most").starts_with("it holds at none of")) << solved.reason("most");
}

// Towards zero steps of parts of themselves never end.
TEST(NarrowWindow, IsNotSoughtTowardsZeroForEver) {
  const SolvedText solved(
      "title: t\nletters: {P: N}\npoints: {O: [0, 0, 0], A: [0, -1 m, 0]}\nbodies: {b: {particle: A, mass: 1 kg}}\n"
      "cords: {c: {from: ground, at: O, to: b, end: A}}\nloads: {p: {force: P, along: y, body: b}}\ngravity: none\n"
      "instants: {now: rest}\nask: {most: {largest: P, while: [taut(c), P > 0 N]}}\n");
  EXPECT_TRUE(solved.reason("most").starts_with("it holds at none of")) << solved.reason("most");
}

}  // namespace narrow_window_test
}  // namespace poinsot::problem
