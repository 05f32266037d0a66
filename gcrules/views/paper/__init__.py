"""A section for a paper: LaTeX text, figures in TikZ, and the works that it cites."""
