// node compile.mjs FOLDER ARCHIVE: the modules of a folder, compiled by the Python that Pyodide is, as one archive.
import { writeFileSync } from "node:fs";
import { loadPyodide } from "pyodide";

const [folder, archive] = process.argv.slice(2);
const python = await loadPyodide();
python.FS.mkdirTree("/in");
python.FS.mount(python.FS.filesystems.NODEFS, { root: folder }, "/in");
python.runPython(`
import compileall, os, shutil, zipfile
from py_compile import PycInvalidationMode
shutil.copytree("/in", "/out")
assert compileall.compile_dir("/out", quiet=1, legacy=True, invalidation_mode=PycInvalidationMode.UNCHECKED_HASH)
with zipfile.ZipFile("/archive.zip", "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
    for folder, folders, names in os.walk("/out"):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(folder, name)
            if not name.endswith(".py") or "_plugins" in path or "_examples" in path:
                entry = zipfile.ZipInfo(os.path.relpath(path, "/out"), (2020, 1, 1, 0, 0, 0))
                entry.compress_type = zipfile.ZIP_DEFLATED
                with open(path, "rb") as file:
                    archive.writestr(entry, file.read())
`);
writeFileSync(archive, python.FS.readFile("/archive.zip"));
