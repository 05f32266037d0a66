"""Models of links and joints as text of the formats of model files."""
