"""A campaign of fuzzers: inputs drawn from grammars and by mutation, run in-process, judged by what any input must get.

`python -m tests.fuzz --help` says how to run it; CONTRIBUTING.md says when.
"""
