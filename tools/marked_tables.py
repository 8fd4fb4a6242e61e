"""Tables in a page that a tool writes, between two marks that name the table and the tool:

    <!-- effects: begin. Written by tools/effects_report.py. -->
    <!-- effects: end -->
"""

from tool_errors import end_with, read_text, write_text


def parts(page, table, tool):
    """What stands before the table, the table, and what stands after it; the marks belong to the outer two."""
    begin, end = f"<!-- {table}: begin. Written by {tool}. -->\n", f"<!-- {table}: end -->"
    if begin not in page or end not in page:
        end_with(f"the page has lost the marks around the table '{table}': {begin.strip()} ... {end}")
    before, rest = page.split(begin, 1)
    rows, after = rest.split(end, 1)
    return before + begin, rows, end + after


def with_table(page, table, tool, text):
    """The text of the page with another table."""
    before, _, after = parts(page, table, tool)
    return before + text + after


def put_row(path, table, tool, cells):
    """Writes a row into the table of the page at `path`, in the place of the row whose first cell is the same."""
    before, rows, after = parts(read_text(path), table, tool)
    rows, row = rows.splitlines(), f"| {' | '.join(cells)} |"
    alike = [k for k, old in enumerate(rows) if old.startswith(f"| {cells[0]} |")]
    rows[alike[0] if alike else len(rows):alike[0] + 1 if alike else len(rows)] = [row]
    write_text(path, before + "\n".join([*rows, ""]) + after)
