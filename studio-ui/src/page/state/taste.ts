// Preferences of this browser: they belong to the reader, not to the document, and are kept between visits.
import { computed, effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { ANGLES, type Angles } from "../lib/rotation";
import type { Theme } from "../../viewer";

export type Led = "actuators" | "platform";

export interface Taste {
  /** null: as the system says. */
  chosen: Signal<Theme | null>;
  /** Light on paper. */
  theme: ReadonlySignal<Theme>;
  /** How the three angles of a turn are given. */
  angles: Signal<Angles>;
  /** What the sliders of a robot with limbs move. */
  led: Signal<Led>;
  /** Whether single keys, without Ctrl, do something. */
  single: Signal<boolean>;
  /** Share of the width that the steps take, and of the height of the other side that the picture takes. */
  across: Signal<number>;
  down: Signal<number>;
}

/** Pixels of the steps to begin with: lines of text grow no longer, until there is room for a second column of them. */
const steps = (window: number): number => Math.min(WIDEST, window / 2) + Math.max(0, window - WIDE) / 2;
const [WIDEST, WIDE] = [860, 2560];
/** Pixels that the numbers below the picture need where they stand in columns. */
const BELOW = 520;
/** Pixels of a window so low that the picture needs more of it than the way below the sliders. */
const LOW = 780;

const KEY = "gcrules-studio";

export function createTaste(): Taste {
  const kept = read();
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const system = signal<Theme>(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => (system.value = dark.matches ? "dark" : "light"));

  const chosen = signal<Theme | null>(kept.chosen === "light" || kept.chosen === "dark" ? kept.chosen : null);
  const angles = signal(ANGLES.find((kind) => kind === kept.angles) ?? "vector");
  const single = signal(kept.single !== false);
  const led = signal<Led>(kept.led === "platform" ? "platform" : "actuators");
  const across = signal(share(kept.across, Math.max(0.2, steps(innerWidth) / innerWidth)));
  const down = signal(share(kept.down, innerWidth > 2 * WIDEST ? Math.min(Math.max(0.62, 1 - BELOW / innerHeight), 0.75) : innerHeight < LOW ? 0.47 : 0.42));
  const printed = signal(false);
  addEventListener("beforeprint", () => (printed.value = true));
  addEventListener("afterprint", () => (printed.value = false));
  const theme = computed<Theme>(() => (printed.value ? "light" : (chosen.value ?? system.value)));

  effect(() => void (document.documentElement.dataset.theme = theme.value));
  effect(() => write({ chosen: chosen.value, angles: angles.value, led: led.value, single: single.value, across: across.value, down: down.value }));
  return { chosen, theme, angles, led, single, across, down };
}

const share = (x: unknown, otherwise: number): number =>
  typeof x === "number" && x >= 0.2 && x <= 0.8 ? x : otherwise;

function read(): Record<string, unknown> {
  try {
    return (JSON.parse(localStorage.getItem(KEY) ?? "{}") as Record<string, unknown> | null) ?? {};
  } catch {
    return {}; // storage may be forbidden: preferences then last as long as the page
  }
}

function write(value: Record<string, unknown>): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(value));
  } catch {
    // see read
  }
}
