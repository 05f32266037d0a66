// gcrules under Pyodide: one interpreter, asked one command line, script or example after the other. In a page it lives in
// worker.mjs; the tests drive it under Node.

const ARCHIVE = "gcrules.zip";
const FOLDER = "/home/gcrules";

// Start it. `loadPyodide` is Pyodide's own; `folder` is where Pyodide's files lie; `read` gives the bytes of a file there.
export async function start(loadPyodide, folder, read) {
  const [python, archive] = await Promise.all([loadPyodide({ indexURL: folder, env: { HOME: FOLDER, PYTHONUTF8: "1" } }), read(ARCHIVE)]);
  python.unpackArchive(archive, "zip", { extractDir: "/lib/gcrules" });
  python.runPython("import sys; sys.path.insert(0, '/lib/gcrules')");
  const desk = python.pyimport("gcrules.apps.browser").Desk(FOLDER);
  const version = python.runPython("from gcrules.core.version import __version__; __version__");
  python.setStdin({ stdin: () => null });

  // What is printed goes to `hear(text, stream)` as it comes. The answer: the exit code and the files that were written.
  function asked(question, text, hear) {
    for (const [stream, set] of [["out", python.setStdout], ["err", python.setStderr]]) {
      const decoder = new TextDecoder();
      set.call(python, { isatty: false, write: (bytes) => (hear(decoder.decode(bytes, { stream: true }), stream), bytes.length) });
    }
    const code = desk[question](text);
    python.runPython("import sys; sys.stdout.flush(); sys.stderr.flush()");
    const names = desk.new_files();
    const files = names.toJs().map((name) => ({ name, bytes: python.FS.readFile(`${FOLDER}/${name}`) }));
    names.destroy();
    return { code, files };
  }

  // A message of the studio's page and its reply; `hear(message)` takes those that go before it.
  let studio = null;
  function request(text, hear) {
    studio ??= python.pyimport("gcrules.apps.studio.in_page").Answering();
    return { reply: studio.answer(text, hear) };
  }

  return {
    version,
    request,
    line: (text, hear) => asked("answer", text, hear),
    script: (text, hear) => asked("run_script", text, hear),
    session: (text, hear) => asked("run_session", text, hear),
  };
}
