// Every example of the built guide that has a button gives, in the engine of its pages, what the guide shows; every
// other one says why it does not.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { fileURLToPath, pathToFileURL } from "node:url";
import { before, test } from "node:test";

const SITE = new URL("../../build/site/", import.meta.url);
const FOLDER = fileURLToPath(new URL("assets/engine/", SITE));
const NAMED = { amp: "&", lt: "<", gt: ">", quot: '"' };
const BLOCK = /<div class="language-(?:console|gca|pycon|sh) highlight"((?: data-\w+="[^"]*")*)>(.*?)<\/pre><\/div>/gs;
const WHY = /^(Needs (NumPy|NetworkX|SymPy|a shell|a notebook)|Takes a minute here|Goes on from an example that does not run here): run it on your machine\.$/;

const unescape = (text) => text.replace(/&(?:#x([\da-f]+)|#(\d+)|(\w+));/gi, (_, hex, decimal, name) =>
  name ? NAMED[name] : String.fromCodePoint(hex ? parseInt(hex, 16) : Number(decimal)));
const words = (text) => text.replaceAll(/\s+/g, " ").replace(/file: \S+\//, "file: ").trim();

let engine;
before(async () => {
  const { loadPyodide } = await import(pathToFileURL(`${FOLDER}pyodide.mjs`));
  const { start } = await import(new URL("assets/try/engine.mjs", SITE));
  engine = await start(loadPyodide, FOLDER, (name) => readFileSync(FOLDER + name).buffer);
});

function ask(kind, text) {
  let out = "";
  const { code, files } = engine[kind](text, (piece) => { out += piece; });
  return { code, files, out };
}

const pages = readdirSync(SITE, { recursive: true }).filter((name) => name.endsWith(".html"));
const all = pages.flatMap((page) => {
  const session = [];
  return [...readFileSync(new URL(page, SITE), "utf8").matchAll(BLOCK)].map(([, attributes, shown]) => {
    const given = Object.fromEntries([...attributes.matchAll(/data-(\w+)="([^"]*)"/g)].map(([, name, value]) => [name, unescape(value)]));
    if (given.session) session.push(given.session);
    const kind = ["run", "script", "session"].find((name) => given[name]);
    return { page, kind, text: given[kind], why: given.why, session: [...session], plain: unescape(shown.replaceAll(/<[^>]*>/g, "")) };
  });
});
const blocks = all.filter(({ why }) => !why);

test("the guide has examples that run", () => {
  assert.ok(blocks.length > 200, `${blocks.length} examples`);
  for (const one of ["run", "script", "session"]) assert.ok(blocks.some(({ kind }) => kind === one), one);
});

for (const { page, why, session, text, plain } of all.filter((one) => one.why || !one.kind)) {
  test(`${page}: ${plain.trim().split("\n")[0]} does not run: ${why}`, () => {
    assert.match(why ?? "", WHY);
    if (text) {
      assert.notEqual(ask("session", JSON.stringify(session)).code, 0);
    } else if (/NumPy|NetworkX|SymPy/.test(why)) {
      const lines = plain.replaceAll("\\\n", "").split("\n").filter((line) => line.startsWith("$ "));
      assert.ok(lines.some((line) => /is not installed here/.test(ask("line", line).out)), lines.join());
    }
  });
}

for (const [number, { page, kind, text, session, plain }] of blocks.entries()) {
  test(`${page}: ${text.split("\n")[0]} (${number})`, () => {
    if (kind === "session") {
      const { code, out } = ask("session", JSON.stringify(session));
      assert.equal(code, 0, out);
      assert.equal(words(out), words(text));
      return;
    }
    if (kind === "script") {
      const { code, out } = ask("script", text);
      assert.ok(code === 0 || code === 1, out);
      return;
    }
    const parts = plain.replaceAll("\\\n", "").split(/^\$ .*$/m).slice(1);
    for (const [k, line] of text.split("\n").entries()) {
      const { out } = ask("line", line);
      const [seen, wanted] = [words(out), words(parts[k])];
      assert.doesNotMatch(seen, /is not installed here|fault of gcrules/);
      if (wanted && !/…|\.\.\.|\d s\b/.test(wanted)) assert.equal(seen, wanted);
    }
  });
}

// --- the studio's steps ---------------------------------------------------------------------------------------------

const SOURCES = [{ kind: "legs", legs: "ab af cb cd ed ef" }, { kind: "class", id: "6-6" }, { kind: "class", id: "3-3.1" }];
const PYTHON = fileURLToPath(new URL("../../.venv/bin/python", import.meta.url));
const SERVER = `
import json, sys
from gcrules.apps.studio.study import study
from gcrules.apps.studio.subject import read_subject
print(json.dumps([study(read_subject(source)) for source in json.loads(sys.argv[1])]))`;

function request(method, args) {
  const heard = [];
  const { reply } = engine.request(JSON.stringify({ id: 1, do: method, args }), (message) => heard.push(JSON.parse(message).progress));
  return { ...JSON.parse(reply), heard };
}

// Sums of floats differ in the last digit between versions of Python.
const rounded = (value) => JSON.parse(JSON.stringify(value), (_, one) => (typeof one === "number" ? Number(one.toPrecision(12)) : one));

test("structures are opened as the server of the studio opens them", () => {
  const wanted = JSON.parse(execFileSync(PYTHON, ["-c", SERVER, JSON.stringify(SOURCES)], { maxBuffer: 1e8 }));
  for (const [k, source] of SOURCES.entries()) {
    const { ok, result, error, heard } = request("open", { source });
    assert.ok(ok, error?.message);
    assert.deepEqual(rounded(result), rounded(wanted[k]));
    assert.deepEqual(heard, ["analysing", "stages"]);
  }
});

test("the bench answers beside an open structure, and numbers of poses need an installation", () => {
  const [source] = SOURCES;
  const pose = { translation: [0, 0, 0], quaternion: [1, 0, 0, 0] };
  for (const text of [":expand [[ab, af, cb, cd, ed, ef]]", ":straighten [bacd]", ":factor [abfc][acde][bdef] + [abfd][acbe][cdef]", ":prove ab /\\ cd == [abcd]"]) {
    const { ok, result, error } = request("bench", { text, source, pose });
    assert.ok(ok, error?.message);
    assert.equal(result.fault ?? null, null);
    assert.equal(result.results.length, 1);
  }
  const refused = request("pose", { source, pose });
  assert.equal(refused.ok, false);
  assert.match(refused.error.message, /NumPy/);
  assert.ok(request("gallery", {}).result.classes.length > 20);
});

test("faults of the line, files and what is missing are told", () => {
  const open = ask("line", 'gcrules analyze "ab');
  assert.equal(open.code, 2);
  assert.match(open.out, /error: the line is not complete/);
  const written = ask("line", 'gcrules analyze "ab af cb cd ed ef" -o answer.txt');
  assert.deepEqual(written.files.map(({ name }) => name), ["answer.txt"]);
  assert.deepEqual(ask("line", "gcrules cite").files, []);
  const missing = ask("line", "gcrules pose examples/octahedral.yaml");
  assert.equal(missing.code, 2);
  assert.match(missing.out, /needs numpy, which is not installed here/);
});
