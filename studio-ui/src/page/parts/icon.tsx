// Icons of one stroke on a 24 grid.
const PATHS = {
  start: "M4 4h7v7H4z M13 4h7v7h-7z M4 13h7v7H4z M13 13h7v7h-7z",
  guided: "M5 6h.01 M9 6h11 M5 12h.01 M9 12h11 M5 18h.01 M9 18h11",
  manual: "M8 13V5.5a1.5 1.5 0 0 1 3 0V12 M11 11.5v-2a1.5 1.5 0 0 1 3 0V12 M14 10.5a1.5 1.5 0 0 1 3 0V12 M17 11.5a1.5 1.5 0 0 1 3 0V16a6 6 0 0 1-6 6h-2c-2.1 0-3.4-.9-4.7-2.6L5 15.500a1.500 1.500 0 0 1 2.4-1.800L8 14.500",
  bench: "M8 8l-5 4.500L8 17 M16 8l5 4.500L16 17 M13.500 5l-3 15",
  draw: "M4 20l1-4L16.500 4.500a2.100 2.100 0 0 1 3 3L8 19z M14.500 6.500l3 3",
  "take-away": "M12 3v12 M7.500 10.500L12 15l4.500-4.500 M4 16v4h16v-4",
  undo: "M9 14L4 9l5-5 M4 9h10.500a5.500 5.500 0 0 1 0 11H10",
  redo: "M15 14l5-5-5-5 M20 9H9.500a5.500 5.500 0 0 0 0 11H14",
  sun: "M12 8a4 4 0 1 0 0 8a4 4 0 0 0 0-8 M12 2v2 M12 20v2 M4.900 4.900l1.400 1.400 M17.700 17.700l1.400 1.400 M2 12h2 M20 12h2 M4.900 19.100l1.400-1.400 M17.700 6.300l1.400-1.400",
  moon: "M20 14.500A8.500 8.500 0 0 1 9.500 4a8.500 8.500 0 1 0 10.500 10.500z",
  link: "M10 14a5 5 0 0 0 7.100 0l2.800-2.800a5 5 0 0 0-7.100-7.100L11.500 5.500 M14 10a5 5 0 0 0-7.100 0l-2.800 2.800a5 5 0 0 0 7.100 7.100l1.300-1.400",
  orbit: "M12 9.500a2.500 2.500 0 1 0 0 5a2.500 2.500 0 0 0 0-5 M21 12c0 2.500-4 4.500-9 4.500S3 14.500 3 12s4-4.500 9-4.500c2.200 0 4.300.4 5.900 1.100",
  translate: "M12 2v20 M2 12h20 M9 5l3-3 3 3 M9 19l3 3 3-3 M5 9l-3 3 3 3 M19 9l3 3-3 3",
  rotate: "M20 12a8 8 0 1 1-2.500-5.800 M20.500 3v4.500H16",
  layers: "M12 3l9 5-9 5-9-5z M3 12.500l9 5 9-5 M3 16.500l9 5 9-5",
  search: "M10.500 4a6.500 6.500 0 1 0 0 13a6.500 6.500 0 0 0 0-13 M15.500 15.500L21 21",
  map: "M4 20V4 M4 20h16 M7.500 16c3 0 3.500-9 7-9s2.500 5 5.500 5",
  file: "M6 3h8l4 4v14H6z M14 3v4h4",
  ok: "M5 12.500l4.500 4.500L19 7.500",
  warn: "M12 3.500l9.500 16.500h-19z M12 10v4.500 M12 17.200v.1",
  stop: "M8 3h8l5 5v8l-5 5H8l-5-5V8z M9 9l6 6 M15 9l-6 6",
  play: "M7 4.500v15l12-7.500z",
  pause: "M8 5v14 M16 5v14",
  next: "M9 5l7 7-7 7",
  back: "M15 5l-7 7 7 7",
  home: "M4 11l8-7 8 7 M6 9.500V20h12V9.500",
  target: "M12 4a8 8 0 1 0 0 16a8 8 0 0 0 0-16 M12 1.500v5 M12 17.500v5 M1.500 12h5 M17.500 12h5",
  close: "M6 6l12 12 M18 6L6 18",
  more: "M6 9l6 6 6-6",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name, size = 18 }: { name: IconName; size?: number }) {
  const bold = name === "guided";
  return (
    <svg class="icon" viewBox="0 0 24 24" width={size} height={size} aria-hidden="true" focusable="false">
      <path d={PATHS[name]} stroke-width={bold ? 2 : 1.7} />
    </svg>
  );
}
