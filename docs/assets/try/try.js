// Run buttons at the examples, and the page "Try it here". The engine is a worker, started with the first question and
// kept in this page; Stop ends it.
(() => {
  const base = new URL("./", document.currentScript.src);
  let worker = null;
  let ready = null;
  let loaded = false;
  let giveUp = null;
  let number = 0;
  const waiting = new Map();

  const make = (tag, className, text = "") => Object.assign(document.createElement(tag), { className, textContent: text });

  function engine() {
    if (worker) return ready;
    worker = new Worker(new URL("worker.mjs", base), { type: "module" });
    ready = new Promise((resolve, reject) => {
      giveUp = reject;
      worker.addEventListener("message", ({ data }) => {
        const asked = waiting.get(data.id);
        if (data.kind === "ready") {
          loaded = true;
          resolve(data.version);
        }
        else if (data.kind === "piece") asked?.hear(data.piece, data.stream);
        else {
          if (!asked) return reject(new Error(data.text));
          waiting.delete(data.id);
          if (data.kind === "answer") asked.resolve(data);
          else asked.reject(new Error(data.text));
        }
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "the engine cannot be loaded")));
    });
    ready.catch(() => stop());
    return ready;
  }

  function stop() {
    worker?.terminate();
    giveUp?.(new Error("stopped"));
    worker = ready = giveUp = null;
    loaded = false;
    for (const asked of waiting.values()) asked.reject(new Error("stopped"));
    waiting.clear();
  }

  async function ask(kind, text, hear) {
    await engine();
    const id = ++number;
    return new Promise((resolve, reject) => {
      waiting.set(id, { resolve, reject, hear });
      worker.postMessage({ id, kind, text });
    });
  }

  // What the code of an answer means, as on the command line.
  const CODES = { 0: "", 1: "The answer is no.", 2: "The input is at fault.", 3: "Not decided within a limit." };

  // A place for answers, with a line that tells how things are.
  function panel() {
    const box = make("div", "gc-answer");
    const status = make("p", "gc-answer-status");
    status.setAttribute("role", "status");
    const text = make("pre", "");
    const code = make("code", "");
    const files = make("p", "gc-answer-files");
    text.append(code);
    text.tabIndex = 0;
    text.setAttribute("aria-label", "Answer");
    box.append(status, text, files);
    box.hidden = true;
    const hear = (piece, stream) => code.append(make("span", stream === "err" ? "gc-err" : "", piece));
    return { box, status, text, code, files, hear };
  }

  // Ask questions one after the other and show the answers; `button` becomes Stop meanwhile.
  async function show(place, button, questions) {
    if (button.dataset.running) return stop();
    const name = button.textContent;
    place.box.hidden = false;
    place.code.textContent = "";
    place.files.textContent = "";
    place.text.hidden = false;
    place.box.dataset.state = "running";
    button.dataset.running = "yes";
    button.textContent = "Stop";
    place.status.textContent = loaded ? "Computing …" : "Loading the engine, once for this page …";
    const since = performance.now();
    try {
      await engine();
      const began = performance.now();
      place.status.textContent = "Computing …";
      let code = 0;
      for (const [kind, text] of questions) {
        if (questions.length > 1) place.hear(`$ ${text}\n`, "out");
        const answer = await ask(kind, text, place.hear);
        code = answer.code;
        for (const { name: file, bytes } of answer.files) place.files.append(link(file, bytes));
      }
      const meaning = CODES[code] ?? `Exit code ${code}.`;
      place.status.textContent = `${meaning} Computed in this page in ${seconds(performance.now() - began)}.`.trim();
      place.box.dataset.state = "done";
      place.box.dataset.code = code;
      place.box.dataset.first = Math.round(performance.now() - since);
    } catch (fault) {
      place.status.textContent = fault.message === "stopped" ? "Stopped." : `The engine does not run here: ${fault.message}`;
      place.box.dataset.state = "failed";
    }
    place.text.hidden = !place.code.textContent;
    delete button.dataset.running;
    button.textContent = name;
  }

  const seconds = (ms) => `${(ms / 1000).toPrecision(2)} s`;

  function link(name, bytes) {
    const a = make("a", "", name);
    if (name === "script.gca") return "";
    a.href = URL.createObjectURL(new Blob([bytes]));
    a.download = name.split("/").pop();
    return a;
  }

  // The examples of the guide.
  document.addEventListener("DOMContentLoaded", () => {
    if (!location.protocol.startsWith("http")) return absent();
    const session = [];
    for (const block of document.querySelectorAll("[data-run], [data-script], [data-session], [data-why]")) {
      const { run, script, why } = block.dataset;
      if (block.dataset.session) session.push(block.dataset.session);
      if (why) {
        block.after(make("p", "gc-why", why));
        continue;
      }
      const questions = run ? run.split("\n").map((line) => ["line", line])
        : script ? [["script", script]] : [["session", JSON.stringify(session)]];
      const button = make("button", "gc-run", "Run");
      button.type = "button";
      button.title = "Run it in this page";
      const place = panel();
      button.addEventListener("click", () => show(place, button, questions));
      block.append(button);
      block.after(place.box);
    }
    page(document.getElementById("gc-try"));
  });

  // Opened from a folder a page may not start workers: it says so.
  function absent() {
    const place = document.getElementById("gc-try");
    if (place) place.firstElementChild.textContent = "A page that was opened from a folder may not start the engine. Serve the folder of this guide: python -m http.server";
  }

  // The page "Try it here": a field, examples, and the answer below.
  function page(place) {
    if (!place) return;
    const examples = JSON.parse(place.querySelector("script").textContent);
    const form = make("form", "gc-try-form");
    const bar = make("div", "gc-try-bar");
    const choice = make("select", "");
    choice.setAttribute("aria-label", "Example");
    for (const { title } of examples) choice.append(make("option", "", title));
    const field = make("textarea", "");
    Object.assign(field, { spellcheck: false, rows: 3, value: examples[0].text });
    field.setAttribute("aria-label", "Command lines, or a script");
    const button = make("button", "gc-try-run", "Run");
    button.type = "submit";
    const hint = make("span", "gc-try-hint", "Ctrl+Enter runs it");
    const fit = () => { field.rows = Math.max(3, field.value.split("\n").length + 1); };
    choice.addEventListener("change", () => { field.value = examples[choice.selectedIndex].text; fit(); field.focus(); });
    field.addEventListener("input", fit);
    field.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) { event.preventDefault(); form.requestSubmit(); }
    });
    const answers = panel();
    form.addEventListener("submit", (event) => { event.preventDefault(); show(answers, button, questions(field.value)); });
    bar.append(choice, button, hint);
    form.append(field, bar);
    place.replaceChildren(form, answers.box, studio());
    fit();
    engine().catch(() => {});
  }

  // The way to the studio, which is built beside the guide with the engine.
  function studio() {
    const words = make("p", "gc-try-studio", "Step by step, with drawings and in 3D: ");
    const link = make("a", "", "open the studio in this browser");
    link.href = new URL("../../studio/index.html", base).href;
    words.append(link);
    return words;
  }

  // Lines that begin with gcrules are commands; anything else is a script of statements.
  function questions(text) {
    const lines = text.split("\n").map((line) => line.replace(/^\$ /, "").trim()).filter(Boolean);
    if (lines.length && lines.every((line) => /^gcrules(\s|$)/.test(line))) return lines.map((line) => ["line", line]);
    return [["script", text]];
  }
})();
