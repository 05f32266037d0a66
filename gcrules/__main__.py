"""`python -m gcrules` is the command line."""

from gcrules.cli import main

if __name__ == "__main__":
    main()
