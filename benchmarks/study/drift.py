"""Whether a row of a table is still what the baseline says: a tolerance per column, each with its
reason. A column that has none is an error, so that a new column cannot stay unchecked."""

import re
from dataclasses import dataclass

import counts
from tables import shown


@dataclass(frozen=True)
class Tolerance:
    share: float  # of the baseline's value
    least: float  # in the column's own unit
    reason: str

    def allows(self, old, new):
        return abs(new - old) <= max(self.share * abs(old), self.least)

    def __str__(self):
        return f"{self.share:g} of it or {self.least:g}"


@dataclass(frozen=True)
class Unchecked:
    reason: str


# Lengths over R, forces over the largest reaction. Both programs end their iterations well below
# 1e-6 of R; what another compiler or BLAS moves stays below that, and an error of 1e-4 is a
# difference of two shapes.
SHAPE = Tolerance(0.02, 2e-6, "a difference of two shapes that are each known to 1e-6 of R")
REACTION = Tolerance(0.02, 2e-5, "a difference of two reactions that are each known to 1e-5")
OWN_ERROR = Tolerance(0.05, 1e-6, "the reference's estimate, a difference of two of its meshes")
VALUE = Tolerance(0.005, 1e-6, "a value of its own: the curves and the joins allow as much")
SAME = Tolerance(1e-6, 1e-9, "follows from the scene alone; the table has six digits")
EXACT = Tolerance(0, 0, "a name or a number of things")
ESTIMATE = Tolerance(0.1, 0, "what `section` estimates of its own error, two digits")
ITERATIONS = Tolerance(0.1, 1, "rounding can move an iteration, and with it the next ones")
MACHINE = Unchecked("depends on the machine")

TOLERANCES = {
    **dict.fromkeys(("rms", "largest", "centerline_rms", "centerline_largest"), SHAPE),
    **dict.fromkeys(("rms_first", "rms_second", "variation"), SHAPE),
    **dict.fromkeys(("force", "moment", "reaction_signed", "reaction"), REACTION),
    **dict.fromkeys(("u_shape", "u_reaction", "reference_rms", "own_error"), OWN_ERROR),
    **dict.fromkeys(("flattening", "flattening_reference", "wrinkling_ratio", "strain"), VALUE),
    **dict.fromkeys(("mouth", "mouth_reference", "span", "width", "energy"), VALUE),
    **dict.fromkeys(("energy_reference", "support", "support_reference"), VALUE),
    **dict.fromkeys(("bending_energy", "stretching_energy", "binding_energy"), VALUE),
    **dict.fromkeys(("force_reference",), VALUE),
    **dict.fromkeys(("demand_stretch", "demand_twist", "demand_bend", "demand_press"), VALUE),
    **dict.fromkeys(("ratio", "thickness_over_radius", "length_over_radius"), SAME),
    **dict.fromkeys(("smallest_angle",), SAME),
    **dict.fromkeys(("family", "counted", "reference", "chosen", "vertices", "harmonics"), EXACT),
    **dict.fromkeys(("spans", "failure", "ending", "sentence", "crossings", "range"), EXACT),
    **dict.fromkeys(("cases", "certified", "other", "case", "load", "modulus", "model"), EXACT),
    **dict.fromkeys(("around", "law", "surface", "unknowns", "settled"), EXACT),
    **dict.fromkeys(("stiffness", "widening", "closed_form"), VALUE),
    **dict.fromkeys(("area_ratio", "perimeter_ratio"), VALUE),
    "drift": Tolerance(0, 1e-9, "only rounding and tolerances move a vessel as it was seen"),
    "factor": SAME,
    "most_iterations": ITERATIONS,
    "estimate": ESTIMATE,
    **dict.fromkeys(("seconds", "seconds_reference", "solve_seconds", "repeats"), MACHINE),
    "peak_bytes": Unchecked("depends on the libraries; factor_nonzeros says how large a solve is"),
    **{
        name: Tolerance(share, least, "rounding can move an iteration; see counts.py")
        for name, (share, least) in counts.TOLERANCES.items()
    },
}


def worded(text):
    """A sentence without its numbers, which the columns check."""
    return re.sub(r"[-+]?\d[\d.,e+-]*", "#", str(text))


def leading_number(value):
    """413 of `413 (E x 1e-06)`: which case was the worst may change where two are near."""
    return float(str(value).split(" ")[0])


def same(column, old, new, tolerance):
    if old is None or new is None:
        return old is new
    if column == "most_iterations":
        old, new = leading_number(old), leading_number(new)
    if isinstance(old, str) or isinstance(new, str):
        return worded(old) == worded(new)
    return tolerance.allows(old, new)


def drifts(keys, old, new, tolerances=TOLERANCES):
    """[(column, old, new, tolerance)] of one row that moved. A column that the baseline does not
    have yet is not compared, one that it has and the new row lacks is a drift."""
    found = []
    for column, before in old.items():
        if column in keys:
            continue
        if column not in tolerances:
            raise SystemExit(f"column {column}: found no tolerance, expected one in drift.py")
        tolerance = tolerances[column]
        if isinstance(tolerance, Unchecked):
            continue
        if before is None and column in counts.COLUMNS:
            continue  # a row from before the counts
        now = new.get(column)
        if not same(column, before, now, tolerance):
            found.append((column, before, now, tolerance))
    return found


def sentence(table, row, moved):
    """One drift with its numbers: row is the keys' values."""
    column, old, new, tolerance = moved
    name = ", ".join(map(shown, row))
    was, now = ("nothing" if value is None else shown(value) for value in (old, new))
    return f"{table}: {name}: {column} was {was}, is {now}, allowed {tolerance}"
