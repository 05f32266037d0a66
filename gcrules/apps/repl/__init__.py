"""The interactive session: an interpreter without a terminal, and the front ends for terminals and for pipes."""
