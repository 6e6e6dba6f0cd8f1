// Formulas, numbers and Markdown of the page, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { packages, source } from "./support.mjs";

const { formulaTex, nameTex, unitTex, escapedTex } = await source("text/tex.ts");
const { rounded, roundedTogether } = await source("text/numbers.ts");
const katex = packages("katex");

// Numbers from a seed, the same each time.
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

// The value of TeX as the page writes it: fractions, roots, functions, products by juxtaposition.
class TexValue {
  constructor(tex, letters) {
    this.tokens = tex.match(/\\[a-zA-Z]+|[0-9.]+|[a-zA-Z]|[{}()^_+\-|,]/g);
    this.letters = letters;
    this.next = 0;
  }
  peek() {
    return this.tokens[this.next];
  }
  take(expected) {
    const token = this.tokens[this.next++];
    if (expected !== undefined) assert.equal(token, expected);
    return token;
  }
  group() {
    this.take("{");
    const value = this.sum();
    this.take("}");
    return value;
  }
  sum() {
    let value = this.peek() === "-" ? (this.take(), -this.product()) : this.product();
    while (this.peek() === "+" || this.peek() === "-") value += this.take() === "+" ? this.product() : -this.product();
    return value;
  }
  product() {
    let value = this.power();
    for (;;) {
      const token = this.peek();
      if (token === "\\cdot") this.take();
      else if (token === undefined || "}),+-|".includes(token) || token === "\\right") return value;
      value *= this.power();
    }
  }
  power() {
    const base = this.atom();
    if (this.peek() !== "^") return base;
    this.take();
    return base ** this.group();
  }
  atom() {
    const token = this.take();
    if (token === "\\frac") return this.group() / this.group();
    if (token === "\\sqrt") return Math.sqrt(this.group());
    if (token === "\\left") {
      this.take("(");
      const value = this.sum();
      this.take("\\right");
      this.take(")");
      return value;
    }
    if (token === "\\sin" || token === "\\cos") {
      const exponent = this.peek() === "^" ? (this.take(), this.group()) : 1;
      return Math[token.slice(1)](this.atom()) ** exponent;
    }
    if (/^[0-9.]/.test(token)) return Number(token);
    if (this.peek() === "_") {
      this.take();
      this.take("{");
      const name = token.replace("\\", "") + this.take();
      this.take("}");
      return this.letters[name];
    }
    return this.letters[token.replace("\\", "")];
  }
}

function formula(chance, depth) {
  const leaf = ["a", "m", "omega", "L2", "3", "7", "0.5"];
  if (depth === 0 || chance() < 0.15) return leaf[Math.floor(chance() * leaf.length)];
  const one = () => formula(chance, depth - 1);
  const kinds = [
    () => `(${one()} + ${one()})`,
    () => `(${one()} - ${one()})`,
    () => `${one()}*${one()}`,
    () => `${one()}/(${one()})`,
    () => `(${one()})^2`,
    () => `sin(${one()})^2`,
    () => `cos(${one()})`,
    () => `(-${one()})`,
    () => `sqrt((${one()})^2 + 1)`,
  ];
  return kinds[Math.floor(chance() * kinds.length)]();
}

test("the TeX of a formula has the formula's value", () => {
  const chance = random(5);
  const letters = { a: 1.3, m: 0.7, omega: 2.1, L2: 1.9 };
  let tried = 0;
  for (let i = 0; i < 400; ++i) {
    const text = formula(chance, 4);
    const script = text
      .replaceAll("^", "**")
      .replace(/\b(sin|cos|sqrt)\b/g, "Math.$1")
      .replace(/\(-/g, "(0-");
    const expected = new Function(...Object.keys(letters), `return ${script}`)(...Object.values(letters));
    if (!Number.isFinite(expected)) continue;
    const tex = formulaTex(text);
    const value = new TexValue(tex, letters).sum();
    assert.ok(Math.abs(value - expected) <= 1e-9 * Math.max(1, Math.abs(expected)), `${text} became ${tex}`);
    katex.renderToString(tex, { throwOnError: true });
    tried += 1;
  }
  assert.ok(tried > 300, `${tried} formulas`);
});

test("names, units and comparisons are written as in worked solutions", () => {
  assert.equal(nameTex("omega1"), "\\omega_{1}");
  assert.equal(nameTex("Fdt"), "\\mathit{Fdt}");
  assert.equal(nameTex("theta'"), "\\theta'");
  assert.equal(nameTex("m"), "m");
  assert.equal(nameTex("phidot"), "\\dot{\\phi}");
  assert.equal(nameTex("xddot1"), "\\ddot{x}_{1}");
  assert.equal(nameTex("robot"), "\\mathit{robot}");
  assert.equal(unitTex("kg*m^2/s"), "\\mathrm{kg\\,m^{2}/s}");
  assert.equal(formulaTex("a > 0"), "a > 0");
  assert.equal(formulaTex("abs(F) <= g*m"), "\\left|F\\right| \\leq g m");
  assert.equal(formulaTex("-m*r^2/4"), "-\\frac{m r^{2}}{4}");
});

test("what is no formula is none, and any text can be escaped", () => {
  for (const text of ["", "a +", "(a", "a b", "f(", "</script>", "a\\b", "$x$", "^2"])
    assert.equal(formulaTex(text), null, text);
  const chance = random(3);
  const letters = "ab\\{}$&#%_^~<> ";
  for (let i = 0; i < 200; ++i) {
    const text = Array.from({ length: 8 }, () => letters[Math.floor(chance() * letters.length)]).join("");
    katex.renderToString(`\\text{${escapedTex(text)}}`, { throwOnError: true });
  }
});

test("numbers are rounded as in the program's text", () => {
  assert.deepEqual([0, 669.0486385, 1e-7, 123456789, -0.00012345678].map(rounded), [
    "0",
    "669.049",
    "1e-7",
    "1.23457e8",
    "-0.000123457",
  ]);
  assert.deepEqual(roundedTogether([10.64823980003572, 1.8174391491687978, 0]), ["10.6482", "1.8174", "0"]);
  assert.deepEqual(roundedTogether([1, 1e-17, -3e-9]), ["1", "0", "0"]);
});
