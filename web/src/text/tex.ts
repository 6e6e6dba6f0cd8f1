// The TeX of a formula, which the answer document holds as text: 73*a^2*m*omega^2/360. The form of the result is that
// of the program's worked solutions.

const greek = new Set(
  (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi " +
    "omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega varphi"
  ).split(" "),
);
const functions: Record<string, string> = {
  asin: "\\arcsin",
  acos: "\\arccos",
  atan: "\\arctan",
  atan2: "\\operatorname{atan2}",
  sin: "\\sin",
  cos: "\\cos",
  tan: "\\tan",
  exp: "\\exp",
  log: "\\log",
  sinh: "\\sinh",
  cosh: "\\cosh",
  tanh: "\\tanh",
  abs: "abs",
  sqrt: "sqrt",
};
const relations: Record<string, string> = {
  "==": "=",
  "!=": "\\neq",
  "<=": "\\leq",
  ">=": "\\geq",
  "<": "<",
  ">": ">",
};

// Text that TeX takes letter by letter.
export function escapedTex(text: string): string {
  const escapes: Record<string, string> = {
    "\\": "\\textbackslash{}",
    "~": "\\textasciitilde{}",
    "^": "\\textasciicircum{}",
  };
  return text.replace(/[\\~^{}$&#%_]/g, (letter) => escapes[letter] ?? `\\${letter}`);
}

// phidot is \dot{\phi}; what is no letter with a rate is a word.
function letterTex(base: string): string {
  if (greek.has(base)) return `\\${base}`;
  if (base.length === 1) return escapedTex(base);
  const [, stem = "", rate = ""] = /^(.+?)(d?dot)$/.exec(base) ?? [];
  if (greek.has(stem) || /^[A-Za-z]$/.test(stem)) return `\\${rate}{${letterTex(stem)}}`;
  return `\\mathit{${escapedTex(base)}}`;
}

// omega1 is \omega_{1}, Fdt is \mathit{Fdt}; what is no name is text.
export function nameTex(whole: string): string {
  const primes = /'*$/.exec(whole)?.[0] ?? "";
  const name = whole.slice(0, whole.length - primes.length);
  if (!/^[A-Za-z0-9_]+$/.test(name)) return `\\text{${escapedTex(whole)}}`;
  const [, stem = name, digits = ""] = /^(.+?)([0-9]*)$/.exec(name) ?? [];
  const low = stem.indexOf("_");
  const base = low > 0 ? stem.slice(0, low) : stem;
  const index = (low > 0 ? stem.slice(low + 1) : "") + digits;
  const letter = letterTex(base);
  const wordIndex = /^[A-Za-z_0-9]{2,}$/.test(index) && /[A-Za-z]/.test(index);
  return (index ? `${letter}_{${wordIndex ? `\\mathrm{${escapedTex(index)}}` : escapedTex(index)}}` : letter) + primes;
}

// The TeX of a unit such as kg*m^2/s.
export function unitTex(unit: string): string {
  if (unit === "") return "";
  if (unit === "deg") return "^{\\circ}";
  const text = unit
    .split(/([*/^])/)
    .map((part) => (part === "*" ? "\\," : part === "/" ? "/" : part === "^" ? "^" : escapedUnit(part)))
    .join("");
  return `\\mathrm{${text.replace(/\^(-?[0-9]+)/g, "^{$1}")}}`;
}
const escapedUnit = (part: string): string => (part === "ohm" ? "\\Omega" : escapedTex(part));

interface Form {
  tex: string;
  kind: "sum" | "negative" | "product" | "quotient" | "power" | "call" | "number" | "name";
}

class FormulaReader {
  private readonly tokens: string[];
  private next = 0;

  constructor(text: string) {
    this.tokens = text.match(/[0-9]+\.?[0-9]*(?:e[+-]?[0-9]+)?|\.[0-9]+|[A-Za-z_][A-Za-z_0-9]*'*|[=!<>]=|[^\s]/g) ?? [];
  }

  read(): string {
    let tex = this.sum().tex;
    while (this.peek() in relations) tex += ` ${relations[this.take()] ?? ""} ${this.sum().tex}`;
    if (this.next < this.tokens.length) throw new SyntaxError(`unexpected ${this.peek()}`);
    return tex;
  }

  private peek(): string {
    return this.tokens[this.next] ?? "";
  }

  private take(expected?: string): string {
    const token = this.peek();
    if (token === "" || (expected !== undefined && token !== expected)) throw new SyntaxError(`expected ${expected}`);
    this.next += 1;
    return token;
  }

  private sum(): Form {
    let form = this.product();
    while (this.peek() === "+" || this.peek() === "-") {
      const sign = this.take();
      const part = this.product();
      const bracketed = part.tex.startsWith("-") || (sign === "-" && part.kind === "sum");
      form = { tex: `${form.tex} ${sign} ${bracketed ? inBrackets(part) : part.tex}`, kind: "sum" };
    }
    return form;
  }

  private product(): Form {
    if (this.peek() === "-") {
      this.take();
      const part = this.product();
      return {
        tex: `-${part.kind === "sum" || part.tex.startsWith("-") ? inBrackets(part) : part.tex}`,
        kind: "negative",
      };
    }
    let form = this.power();
    while (this.peek() === "*" || this.peek() === "/") {
      const sign = this.take();
      const part = this.power();
      if (sign === "/") {
        form = { tex: `\\frac{${form.tex}}{${part.tex}}`, kind: "quotient" };
      } else {
        const dot = /^[0-9.]/.test(part.tex) ? " \\cdot " : " ";
        form = { tex: factor(form) + dot + factor(part), kind: "product" };
      }
    }
    return form;
  }

  private power(): Form {
    const base = this.atom();
    if (this.peek() !== "^") return base;
    this.take();
    const exponent = this.peek() === "-" ? this.take() + this.atom().tex : this.atom().tex;
    if (base.kind === "call") {
      const raised = raisedCall(base.tex, exponent);
      if (raised !== null) return { tex: raised, kind: "power" };
    }
    const simple = base.kind === "number" || base.kind === "name";
    return { tex: `${simple ? base.tex : inBrackets(base)}^{${exponent}}`, kind: "power" };
  }

  private atom(): Form {
    const token = this.take();
    if (token === "(") {
      const inner = this.sum();
      this.take(")");
      return inner;
    }
    if (/^[0-9.]/.test(token)) {
      const [mantissa = token, exponent] = token.split("e");
      return exponent === undefined
        ? { tex: token, kind: "number" }
        : { tex: `${mantissa} \\cdot 10^{${Number(exponent)}}`, kind: "product" };
    }
    if (!/^[A-Za-z_]/.test(token)) throw new SyntaxError(`unexpected ${token}`);
    return this.peek() === "(" ? this.call(token) : { tex: nameTex(token), kind: "name" };
  }

  private call(name: string): Form {
    this.take("(");
    const parts = [this.sum()];
    while (this.peek() === ",") {
      this.take();
      parts.push(this.sum());
    }
    this.take(")");
    const inside = parts.map((part) => part.tex).join(", ");
    if (name === "sqrt") return { tex: `\\sqrt{${inside}}`, kind: "call" };
    if (name === "abs") return { tex: `\\left|${inside}\\right|`, kind: "call" };
    const tex = functions[name] ?? `\\operatorname{${escapedTex(name)}}`;
    const bare = parts.length === 1 && parts[0]?.kind === "name";
    return { tex: bare ? `${tex} ${inside}` : `${tex}\\left(${inside}\\right)`, kind: "call" };
  }
}

const inBrackets = (form: Form): string => `\\left(${form.tex}\\right)`;
const factor = (form: Form): string => (form.kind === "sum" || form.kind === "negative" ? inBrackets(form) : form.tex);

// \sin x to the power 2 is \sin^{2} x.
function raisedCall(tex: string, exponent: string): string | null {
  const match = /^(\\(?:sin|cos|tan|sinh|cosh|tanh|exp|log))(.*)$/s.exec(tex);
  return match ? `${match[1] ?? ""}^{${exponent}}${match[2] ?? ""}` : null;
}

// The TeX of a formula or a comparison of formulas; null if the text is none.
export function formulaTex(text: string): string | null {
  try {
    return new FormulaReader(text).read();
  } catch (error) {
    if (error instanceof SyntaxError) return null;
    throw error;
  }
}
