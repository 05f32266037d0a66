// node sessions.mjs ENGINE ASKED ANSWERS: what examples of Python give, lists of texts by page in one file, into another.
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { start } from "../../docs/assets/try/engine.mjs";

const [engineFolder, asked, answers] = process.argv.slice(2);
const folder = `${engineFolder}/`;
const { loadPyodide } = await import(pathToFileURL(`${folder}pyodide.mjs`));
const engine = await start(loadPyodide, folder, (name) => readFileSync(folder + name).buffer);

const given = JSON.parse(readFileSync(asked, "utf8")).map((page) =>
  page.map((texts) => {
    let printed = "";
    const { code } = engine.session(JSON.stringify(texts), (piece) => { printed += piece; });
    return [code, printed];
  }));
writeFileSync(answers, JSON.stringify(given));
