// What a report shows of the state of the page: the answers of its panels, the picture as it stands, notes, and the link.
import { LARGEST_PICTURE, LONGEST_LINK, LONGEST_NOTE, LONGEST_TITLE, type Note, type State } from "../../protocol";
import { linkOf } from "./fragment";
import { repeatables } from "./repeating";
import type { Store } from "./store";

export async function stateOf(store: Store): Promise<State> {
  const answers = repeatables(store).map(({ title, what, args: { source: _, ...args } }) => ({ title: shortened(title, LONGEST_TITLE), what, args }));
  const { fragment } = await linkOf(store.doc.peek());
  const link = fragment.length <= LONGEST_LINK ? location.origin + location.pathname + fragment : "";
  return { answers, picture: await pictureOf(store), notes: notesOf(store), link };
}

/** The picture in 3D in the colours of paper, as vectors where these are few; "" where there is none. */
async function pictureOf({ space, taste }: Store): Promise<string> {
  const viewer = space.viewer.peek();
  if (!viewer) return "";
  const theme = taste.theme.peek();
  viewer.setTheme("light");
  try {
    const svg = `data:image/svg+xml;base64,${base64Of(await viewer.snapshot("svg"))}`;
    if (svg.length <= LARGEST_PICTURE) return svg;
    return await smaller(await viewer.snapshot("png"));
  } finally {
    viewer.setTheme(theme);
  }
}

function base64Of(text: string): string {
  return btoa(Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte)).join(""));
}

/** A picture of as many pixels as a report takes. */
async function smaller(png: string): Promise<string> {
  const image = new Image();
  image.src = png;
  await image.decode();
  const canvas = document.createElement("canvas");
  for (let [share, found] = [1, png]; ; share *= 0.7) {
    if (found.length <= LARGEST_PICTURE) return found;
    canvas.width = Math.round(share * image.width);
    canvas.height = Math.round(share * image.height);
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    found = canvas.toDataURL("image/png");
  }
}

/** Those of the project, and of the robot in it that is open. */
function notesOf({ projecting }: Store): Note[] {
  const { title, note } = projecting.project.peek();
  const robot = projecting.open.peek();
  const all = [
    { title: title || "Project", text: note },
    { title: robot?.name || "This robot", text: robot?.note ?? "" },
  ];
  return all.filter(({ text }) => text.trim() !== "").map(({ title, text }) => ({ title: shortened(title, LONGEST_TITLE), text: shortened(text, LONGEST_NOTE) }));
}

/** As much of a text as a report takes, and that there is more. */
function shortened(text: string, longest: number): string {
  return text.length <= longest ? text : `${text.slice(0, longest - 1)}…`;
}
