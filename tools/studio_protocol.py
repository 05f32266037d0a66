"""The studio's protocol in TypeScript, for `studio-ui/src/protocol.ts`.

``python tools/studio_protocol.py`` writes that file; with ``--check`` it fails (exit code 1) where the file is stale.
Shapes keep their names but for `View` and `Json` at the end, which tell them from the engine's own values in Python.
"""

from __future__ import annotations

import ast
import json
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from gcrules.apps.studio.protocol import (
    answer_views,
    bench_words,
    limb_requests,
    limb_views,
    locus_views,
    motion_views,
    report_requests,
    requests,
    rule_views,
    study_views,
    where_views,
)
from gcrules.apps.studio.protocol.methods import METHODS, Method
from gcrules.core.shapes import EntryCount, OneOf
from gcrules.views import glossary, scene_data
from gcrules.views.report import stage_ids

TARGET = Path(__file__).resolve().parent.parent / "studio-ui" / "src" / "protocol.ts"
MODULES = (
    stage_ids,
    glossary,
    scene_data,
    requests,
    report_requests,
    limb_requests,
    study_views,
    answer_views,
    motion_views,
    locus_views,
    where_views,
    limb_views,
    bench_words,
    rule_views,
)

START = """\
// What the page and the server say to each other over one websocket: JSON, one object a message.
// Written by `npm run protocol` from gcrules/apps/studio/protocol and from scene_data.py and glossary.py
// of gcrules/views; change those.
"""
END = """\
export type Method = keyof Methods;

/** Of one `channel` only the latest unanswered request is worked on; older ones are answered `superseded`. */
export interface Request<M extends Method = Method> {
  id: number;
  do: M;
  args: Methods[M]["args"];
  channel?: string;
}

export type Reply<M extends Method = Method> =
  | { id: number; ok: true; result: Methods[M]["result"]; ms: number }
  | { id: number; ok: false; error: Fault }
  | { id: number; progress: string }
  | { id: number; part: Methods[M]["part"] };
"""
PLAIN = {"str": "string", "int": "number", "float": "number", "bool": "boolean", "Any": "unknown"}


def typescript() -> str:
    """The whole file."""
    parts = [START, *(part for module in MODULES for part in _module(module))]
    methods = "".join(
        f"  {name}: {{ args: {_name(m.args.__name__)}; result: {_name(m.answer.__name__)}; part: {_part(m)} }};\n"
        for name, m in METHODS.items()
    )
    return "\n".join([*parts, f"export interface Methods {{\n{methods}}}\n{END}"])


def _part(method: Method) -> str:
    return _name(method.part.__name__) if method.part else "never"


def _module(module: ModuleType) -> Iterator[str]:
    """Its public constants, aliases and typed dictionaries, in their sequence."""
    body = ast.parse(Path(str(module.__file__)).read_text(encoding="utf-8")).body
    known = {ast.unparse(s.targets[0]): s.value for s in body if isinstance(s, ast.Assign)}
    for statement, after in zip(body, [*body[1:], None], strict=True):
        match statement:
            case ast.ClassDef(name=name) if name in module.__all__:
                yield _comment(ast.get_docstring(statement)) + _interface(statement, module, known)
            case ast.Assign(targets=[ast.Name(id=name)], value=value) if name in module.__all__:
                data = getattr(module, name)
                if isinstance(data, (str, int, float)):
                    shown = f"const {name} = {_json(data)}"
                elif isinstance(data, tuple):
                    shown = f"const {name} = {_json(data)} as const"
                else:
                    shown = f"type {_name(name)} = {_type(value, module, known)}"
                yield f"{_comment(_doc(after))}export {shown};\n"


def _interface(shape: ast.ClassDef, module: ModuleType, known: Mapping[str, ast.expr]) -> str:
    bases = [_name(ast.unparse(b)) for b in shape.bases if ast.unparse(b) != "TypedDict"]
    lines = []
    for field, after in zip(shape.body, [*shape.body[1:], None], strict=True):
        if isinstance(field, ast.AnnAssign):
            optional = "?" * ast.unparse(field.annotation).startswith("NotRequired[")
            kind = _type(field.annotation, module, known)
            lines.append(f"{_comment(_doc(after), '  ')}  {ast.unparse(field.target)}{optional}: {kind};\n")
    if not lines:
        return f"export type {_name(shape.name)} = Record<string, never>;\n"
    extends = f" extends {bases[0]}" if bases else ""
    return f"export interface {_name(shape.name)}{extends} {{\n{''.join(lines)}}}\n"


def _type(e: ast.expr, module: ModuleType, known: Mapping[str, ast.expr]) -> str:
    """A type as TypeScript writes it; `known` are the aliases of the module."""

    def of(part: ast.expr) -> str:
        return _type(part, module, known)

    match e:
        case ast.Constant(value=None):
            return "null"
        case ast.Constant(value=str(name)):
            return _name(name)
        case ast.Name(id=name):
            return of(known[name]) if name.startswith("_") else PLAIN.get(name) or _name(name)
        case ast.BinOp(left=left, right=right):
            return f"{of(left)} | {of(right)}"
        case ast.Subscript(value=ast.Name(id="Literal"), slice=words):
            return " | ".join(_json(ast.literal_eval(w)) for w in getattr(words, "elts", [words]))
        case ast.Subscript(value=ast.Name(id="dict"), slice=ast.Tuple(elts=[_, item])):
            return f"Record<string, {of(item)}>"
        case ast.Subscript(value=ast.Name(id="list"), slice=item):
            return f"({of(item)})[]" if " | " in of(item) else f"{of(item)}[]"
        case ast.Subscript(value=ast.Name(id="NotRequired"), slice=inner):
            return of(inner)
        case ast.Subscript(value=ast.Name(id="Annotated"), slice=ast.Tuple(elts=[inner, *marks])):
            for mark in _marks(marks, module):
                if isinstance(mark, OneOf):
                    return " | ".join(map(_json, mark.words))
                if mark.least == mark.most:
                    return f"[{', '.join([of(inner).removesuffix('[]')] * mark.most)}]"
            return of(inner)
    raise TypeError(f"no type of the protocol: {ast.unparse(e)}")


def _marks(marks: Iterable[ast.expr], module: ModuleType) -> Iterator[OneOf | EntryCount]:
    """Those that say more than that a value is read with care."""
    for mark in marks:
        match mark:
            case ast.Call(func=ast.Name(id="OneOf"), args=[words]):
                yield OneOf(_constant(words, module))
            case ast.Call(func=ast.Name(id="EntryCount"), args=[least, most]):
                yield EntryCount(_constant(least, module), _constant(most, module))


def _constant(e: ast.expr, module: ModuleType) -> Any:
    return getattr(module, e.id) if isinstance(e, ast.Name) else ast.literal_eval(e)


def _name(name: str) -> str:
    return re.sub(r"(View|Json)$", "", name)


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def _doc(statement: ast.stmt | None) -> str | None:
    """A text that stands by itself, after what it says something of."""
    if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
        return str(statement.value.value)
    return None


def _comment(doc: str | None, indent: str = "") -> str:
    return f"{indent}/** {' '.join(doc.split())} */\n" if doc else ""


def main(arguments: list[str]) -> int:
    fresh = typescript()
    if "--check" not in arguments:
        TARGET.write_text(fresh, encoding="utf-8")
    elif TARGET.read_text(encoding="utf-8") != fresh:
        print("studio-ui/src/protocol.ts is stale (npm run protocol, or python tools/studio_protocol.py)")
        return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
