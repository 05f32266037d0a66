"""The studio: a page on the user's own machine that leads through an analysis (`gcrules studio`).

`protocol` says what the page asks and is told, `subject` what is studied; one module makes each view of it (`study`,
`stages`, `numbers`, `bench`, `manual_replay`, `export`, …), `answers` joins them to the methods. `app` is the server,
`guard` keeps strangers out, `session` speaks with one page, `pool` and `worker` do the long work in other processes.
"""
