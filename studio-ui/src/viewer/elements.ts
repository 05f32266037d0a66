// Pieces of the page that the explorer is made of.
import { runs } from "./names";

/** Four digits; large and small numbers with a power of ten. */
export function figure(value: number, unit = ""): HTMLElement {
  const plain = value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6);
  const [digits, power] = plain ? [String(Number(value.toPrecision(4)))] : value.toExponential(3).split("e");
  const signed = (text: string) => text.replace("-", "−").replace("+", "");
  const found = make("span", {}, signed(String(Number(digits))));
  if (power) found.append(" × 10", make("sup", {}, signed(power)));
  if (unit) found.append(` ${unit}`);
  return found;
}

export function named(label: string): HTMLElement {
  const parts = runs(label).map((run) => make(run.style === "italic" ? "i" : run.style === "sub" ? "sub" : "span", {}, run.text));
  return make("span", { class: "gcx-name" }, ...parts);
}

export function button(name: string, words: string, act: () => void): HTMLButtonElement {
  const found = make("button", { type: "button", title: words }, name);
  found.addEventListener("click", act);
  return found;
}

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Record<string, string>, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const found = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) found.setAttribute(key, value);
  found.append(...children);
  return found;
}
