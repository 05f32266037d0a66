// Drawings made by the server, as elements. Nothing in them may run or load anything.
export function readSvg(text: string): SVGSVGElement | null {
  const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  if (!(root instanceof SVGSVGElement)) return null;
  root.querySelectorAll("script, foreignObject, iframe, image, use").forEach((element) => element.remove());
  for (const element of [root, ...root.querySelectorAll("*")]) {
    for (const { name, value } of [...element.attributes]) {
      const refers = /href$/i.test(name) && !value.startsWith("#");
      if (/^on/i.test(name) || refers || /url\s*\(\s*["']?(?!#)/i.test(value)) element.removeAttribute(name);
    }
  }
  root.querySelectorAll("style").forEach((style) => /@import|url\s*\(/i.test(style.textContent ?? "") && style.remove());
  return document.importNode(root, true);
}
