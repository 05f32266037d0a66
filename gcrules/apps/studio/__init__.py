"""The studio: a page on the user's own machine that leads through an analysis (`gcrules studio`).

`views` says what the page is told, `subject` what is studied; one module makes each view of it (`study`, `stages`,
`numbers`, `hand`, `bench`, `taking`, …), `methods` is the table of everything that can be asked. `app` is the server,
`guard` keeps strangers out, `session` speaks with one page, `pool` and `worker` do the long work in other processes.
"""
