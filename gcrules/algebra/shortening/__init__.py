"""The shortest bracket polynomial equal to a given one: searches for short forms and proofs that none is shorter."""
