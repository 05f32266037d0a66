"""What the page and the server say to each other over one websocket, described once: JSON, one object a message.

`requests` are the arguments of methods, whose types say how they are checked (`checking`, `shape_checks`);
`study_views` and `answer_views` are the answers, with shapes of `gcrules.views.scene_data`; `methods` is the table of
everything that can be asked. `tools/studio_protocol.py` writes all of it in TypeScript, `studio-ui/src/protocol.ts`.

The server keeps nothing between messages but caches: a request holds all that it needs (the source, the pose), so that
a restarted server goes on where the old one stopped. Nothing of the engine is loaded here, so that the server is there
at once.
"""
