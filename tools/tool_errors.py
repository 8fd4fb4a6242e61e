"""What ends a tool with one line: a file that cannot be read or written, a table or an option that is wrong."""

import argparse
import csv
import os
import sys


def end_with(message):
    """Ends the program with that line after its name."""
    sys.exit(f"{os.path.basename(sys.argv[0])}: {message}")


def read_text(path):
    """All of a text file."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            return file.read()
    except OSError as error:
        end_with(f"cannot read {path}: {error.strerror}")
    except UnicodeDecodeError:
        end_with(f"cannot read {path}: it is no text")


def write_text(path, text):
    """Writes a text file anew."""
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        end_with(f"cannot write {path}: {error.strerror}")


def rows_of(path, text):
    """The rows of a table, each a list of words; `path` is where its text is from."""
    try:
        return list(csv.reader(text.splitlines()))
    except csv.Error as error:
        end_with(f"{path} is no table: {error}")


def whole_number(text):
    """The type of an option that takes a whole number above 0."""
    try:
        value = int(text)
    except ValueError:
        value = 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"'{text}' must be a whole number above 0")
    return value
