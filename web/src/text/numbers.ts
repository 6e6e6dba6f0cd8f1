// Numbers as a reader wants them: rounded as the program's text output rounds.

const digits = 6;

function leadingPower(number: number): number {
  return Number(number.toExponential(digits - 1).split("e")[1]);
}

function trimmed(text: string): string {
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short;
}

function withExponent(number: number, decimals: number): string {
  const [mantissa = "0", exponent = "0"] = number.toExponential(decimals).split("e");
  return `${trimmed(mantissa)}e${Number(exponent)}`;
}

const isPlain = (power: number): boolean => power >= -4 && power < digits;

export function rounded(number: number): string {
  if (number === 0) return "0";
  if (!Number.isFinite(number)) return String(number);
  const power = leadingPower(number);
  return isPlain(power) ? trimmed(number.toFixed(digits - 1 - power)) : withExponent(number, digits - 1);
}

// The components of a vector, rounded to the place of the last digit of the largest.
export function roundedTogether(numbers: number[]): string[] {
  const largest = Math.max(...numbers.map(Math.abs));
  if (largest === 0 || !Number.isFinite(largest)) return numbers.map(rounded);
  const leading = leadingPower(largest);
  const last = leading - digits + 1;
  return numbers.map((number) => {
    if (isPlain(leading)) return trimmed(number.toFixed(Math.min(100, -last)));
    if (Math.abs(number) < 0.5 * 10 ** last) return "0";
    return withExponent(number, Math.max(0, leadingPower(number) - last));
  });
}

// 1.5e-7 as TeX.
export function numberTex(text: string): string {
  const [mantissa = "", exponent] = text.split("e");
  return exponent === undefined ? mantissa : `${mantissa} \\cdot 10^{${Number(exponent)}}`;
}

// A misfit such as 3e-16.
export function residual(number: number | null): string {
  if (number === null) return "not formed";
  return number === 0 ? "0" : number.toExponential(0).replace("e+", "e");
}
