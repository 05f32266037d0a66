// Formulas: KaTeX sets what arithmatex has marked. Nothing is loaded from elsewhere.
document.addEventListener("DOMContentLoaded", () => {
  for (const place of document.querySelectorAll(".arithmatex")) {
    renderMathInElement(place, {
      delimiters: [
        { left: "\\(", right: "\\)", display: false },
        { left: "\\[", right: "\\]", display: true },
      ],
      throwOnError: true,
    });
  }
});

// The index of the catalog: buttons for the groups and a field for joints, legs and names, in place of the plain links.
document.addEventListener("DOMContentLoaded", () => {
  const links = [...document.querySelectorAll("article p")].find((p) => p.textContent.startsWith("Groups: "));
  if (!links) return;
  const sections = [...document.querySelectorAll("article h2")].map((heading) => {
    const parts = [heading];
    for (let next = heading.nextElementSibling; next && next.tagName !== "H2"; next = next.nextElementSibling) parts.push(next);
    return { title: heading.firstChild.textContent.trim(), parts, rows: parts.flatMap((p) => [...p.querySelectorAll("tbody tr")]) };
  }).filter((s) => s.rows.some((row) => row.querySelector("svg, img")));
  const bar = document.createElement("div");
  bar.className = "gc-filter";
  const field = Object.assign(document.createElement("input"), { type: "search", placeholder: "joints, legs or name: 5-4, Aa Ab Ba, octahedral" });
  field.setAttribute("aria-label", "Filter the classes");
  const count = document.createElement("output");
  let chosen = null;
  const buttons = [["All", null], ...sections.map((s) => [s.title, s])].map(([title, section]) => {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: title });
    button.addEventListener("click", () => { chosen = section; show(); });
    bar.append(button);
    return [button, section];
  });
  const show = () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const section of sections) {
      let here = 0;
      for (const row of section.rows) {
        const text = row.textContent.toLowerCase();
        row.hidden = !words.every((word) => text.includes(word));
        here += !row.hidden;
      }
      const open = (!chosen || chosen === section) && here > 0;
      for (const part of section.parts) part.hidden = !open;
      shown += open ? here : 0;
    }
    for (const [button, section] of buttons) button.setAttribute("aria-pressed", String(section === chosen));
    count.textContent = `${shown} classes`;
  };
  field.addEventListener("input", show);
  bar.append(field, count);
  links.replaceWith(bar);
  show();
});
