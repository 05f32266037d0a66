"""`python -m gcrules` is the command line."""

from gcrules.apps.main import main

if __name__ == "__main__":
    main()
