// Numbers as text: a true minus sign, few digits, powers of ten only where they are needed.
export function short(value: number, digits = 4): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (!Number.isFinite(value)) return "∞";
  if (size >= 1e5 || size < 1e-3) return power(value, digits);
  return minus(Number(value.toPrecision(digits)).toString());
}

/** Always as wide: for a number that changes while it is watched. */
export function steady(value: number): string {
  const size = Math.abs(value);
  const text = size !== 0 && size < 1e-4 ? power(size, 3) : size.toFixed(5);
  return (value < 0 ? "−" : value > 0 ? "+" : " ") + text;
}

function power(value: number, digits: number): string {
  const [mantissa = "", exponent = ""] = value.toExponential(digits - 1).split("e");
  return `${minus(mantissa)} × 10${[...String(Number(exponent))].map((c) => SUPERSCRIPT[c] ?? c).join("")}`;
}

const SUPERSCRIPT: Record<string, string> = Object.fromEntries([..."0123456789-"].map((c, i) => [c, "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"[i] ?? c]));

const minus = (text: string): string => text.replace("-", "−");
