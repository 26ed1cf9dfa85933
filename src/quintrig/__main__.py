"""``python -m quintrig``: the command line."""

from quintrig.cli import main

if __name__ == "__main__":
    main()
