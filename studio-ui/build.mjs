// Bundles the viewer into gcrules/views/static, and the page into gcrules/apps/studio/static; both are committed.
//   node build.mjs           writes the bundles
//   node build.mjs --check   compares them with the committed ones; exit 1 and the names of stale files
//   node build.mjs --watch   writes it again at every change, with source maps
import { build, context } from "esbuild";
import {
  cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const target = join(here, "..", "gcrules");
const check = process.argv.includes("--check");
const watch = process.argv.includes("--watch");

const common = {
  absWorkingDir: here,
  bundle: true,
  minify: !watch,
  sourcemap: watch ? "inline" : false,
  target: "es2022",
  charset: "utf8",
  preserveSymlinks: true, // libraries are told by their folder, also where node_modules is a link
  legalComments: "eof", // the viewer is copied into reports, its notices with it
  metafile: true,
  logLevel: "warning",
  jsx: "automatic",
  jsxImportSource: "preact",
  loader: { ".woff2": "file", ".woff": "empty", ".ttf": "empty", ".svg": "text" },
  assetNames: "fonts/[name]",
};

/** The page takes the viewer from the script that stands before it, the same that reports and notebooks have. */
const sharedViewer = {
  name: "viewer",
  setup(build) {
    build.onResolve({ filter: /\/viewer$/ }, () => ({ path: "viewer", namespace: "script" }));
    build.onLoad({ filter: /^/, namespace: "script" }, () => ({ contents: "module.exports = GcrulesViewer" }));
  },
};

/** Folder of gcrules → what is built into it. */
const BUNDLES = {
  // a classic script that defines `GcrulesViewer` (module scripts do not load from file://);
  // gcrules/apps/notebook/widget.py makes the module of the notebook widget of it
  "views/static": { entryPoints: { viewer: "src/viewer/index.ts" }, format: "iife", globalName: "GcrulesViewer" },
  // the page of `gcrules studio`, without the viewer
  "apps/studio/static": { entryPoints: { studio: "src/page/main.tsx" }, format: "esm", plugins: [sharedViewer] },
};

function listed(folder, below = folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? listed(path, below) : [relative(below, path)];
  });
}

/** The licences of the packages that these files come from. */
function licences(files) {
  const names = files.map((file) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]).filter(Boolean);
  if (names.length === 0) throw new Error("no library was found whose licence belongs to the bundle");
  return [...new Set(names)].sort().map((name) => {
    const folder = join(here, "node_modules", name);
    const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const text = readFileSync(join(folder, readdirSync(folder).find((n) => /^licen[cs]e/i.test(n))), "utf8");
    return `${name} ${version} (${license})\n\n${text.trim()}\n`;
  }).join(`\n${"-".repeat(80)}\n\n`);
}

async function write(root) {
  for (const [folder, own] of Object.entries(BUNDLES)) {
    const outdir = join(root, folder);
    const options = { ...common, ...own, outdir };
    rmSync(outdir, { recursive: true, force: true });
    mkdirSync(outdir, { recursive: true });
    if (watch) await (await context(options)).watch();
    else writeFileSync(join(outdir, "LICENSES.txt"), licences(Object.keys((await build(options)).metafile.inputs)));
  }
  cpSync(join(here, "src", "page", "index.html"), join(root, "apps/studio/static", "index.html"));
}

if (watch) {
  await write(target);
} else {
  // elsewhere first: a fault in the sources leaves the old bundles as they are
  const fresh = mkdtempSync(join(tmpdir(), "studio-"));
  await write(fresh);
  const folders = Object.keys(BUNDLES);
  const below = (root) =>
    folders.flatMap((f) => (existsSync(join(root, f)) ? listed(join(root, f)) : []).map((name) => join(f, name)));
  const names = new Set([...below(fresh), ...below(target)]);
  const same = (name) =>
    [fresh, target].every((f) => existsSync(join(f, name))) &&
    readFileSync(join(fresh, name)).equals(readFileSync(join(target, name)));
  const stale = [...names].filter((name) => !same(name)).sort();
  if (check && stale.length) {
    console.error(`the bundle is stale (npm run build): ${stale.join(", ")}`);
    process.exitCode = 1;
  } else if (check) {
    console.log(`the bundle is up to date: ${names.size} files`);
  } else {
    for (const folder of folders) {
      rmSync(join(target, folder), { recursive: true, force: true });
      cpSync(join(fresh, folder), join(target, folder), { recursive: true });
    }
  }
  rmSync(fresh, { recursive: true });
}
