// Bundles the page and the viewer into gcrules/apps/studio/static, which is committed.
//   node build.mjs           writes the bundle
//   node build.mjs --check   compares it with the committed one; exit 1 and the names of stale files
//   node build.mjs --watch   writes it again at every change, with source maps
import { build, context } from "esbuild";
import {
  cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const target = join(here, "..", "gcrules", "apps", "studio", "static");
const check = process.argv.includes("--check");
const watch = process.argv.includes("--watch");

const common = {
  absWorkingDir: here,
  bundle: true,
  minify: !watch,
  sourcemap: watch ? "inline" : false,
  target: "es2022",
  charset: "utf8",
  legalComments: "eof", // the viewer is copied into reports, its notices with it
  metafile: true,
  logLevel: "warning",
  jsx: "automatic",
  jsxImportSource: "preact",
  loader: { ".woff2": "file", ".woff": "empty", ".ttf": "empty", ".svg": "text" },
  assetNames: "fonts/[name]",
};

const bundles = (out) => [
  // the page of `gcrules studio`
  { ...common, entryPoints: { studio: "src/page/main.tsx" }, outdir: out, format: "esm" },
  // the viewer by itself: a classic script that defines `GcrulesViewer` (module scripts do not load from file://);
  // gcrules/apps/notebook/widget.py makes the module of the notebook widget of it
  { ...common, entryPoints: { viewer: "src/viewer/index.ts" }, outdir: out, format: "iife", globalName: "GcrulesViewer" },
];

function listed(folder, below = folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? listed(path, below) : [relative(below, path)];
  });
}

/** The licences of the packages that these files come from. */
function licences(files) {
  const names = files.map((file) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]).filter(Boolean);
  return [...new Set(names)].sort().map((name) => {
    const folder = join(here, "node_modules", name);
    const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const text = readFileSync(join(folder, readdirSync(folder).find((n) => /^licen[cs]e/i.test(n))), "utf8");
    return `${name} ${version} (${license})\n\n${text.trim()}\n`;
  }).join(`\n${"-".repeat(80)}\n\n`);
}

async function write(out) {
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const inputs = [];
  for (const options of bundles(out)) {
    if (watch) await (await context(options)).watch();
    else inputs.push(...Object.keys((await build(options)).metafile.inputs));
  }
  writeFileSync(join(out, "LICENSES.txt"), licences(inputs));
  cpSync(join(here, "src", "page", "index.html"), join(out, "index.html"));
}

if (check) {
  const fresh = mkdtempSync(join(tmpdir(), "studio-"));
  await write(fresh);
  const names = new Set([...listed(fresh), ...(existsSync(target) ? listed(target) : [])]);
  const same = (name) =>
    [fresh, target].every((f) => existsSync(join(f, name))) &&
    readFileSync(join(fresh, name)).equals(readFileSync(join(target, name)));
  const stale = [...names].filter((name) => !same(name)).sort();
  rmSync(fresh, { recursive: true });
  if (stale.length) {
    console.error(`the bundle is stale (npm run build): ${stale.join(", ")}`);
    process.exit(1);
  }
  console.log(`the bundle is up to date: ${names.size} files`);
} else if (watch) {
  await write(target);
} else {
  // elsewhere first: a fault in the sources leaves the old bundle as it is
  const fresh = mkdtempSync(join(tmpdir(), "studio-"));
  await write(fresh);
  rmSync(target, { recursive: true, force: true });
  cpSync(fresh, target, { recursive: true });
  rmSync(fresh, { recursive: true });
}
