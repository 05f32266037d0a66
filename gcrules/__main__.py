"""`python -m gcrules` is the command line."""

from gcrules.main import main

if __name__ == "__main__":
    main()
