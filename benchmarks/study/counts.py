"""How much a solver did (`counts` in result.json). With the same kernels of OpenBLAS
(store.py) the numbers do not depend on the machine, so that they show a slower or faster solver
where times do not."""

# Per count: its tolerance as a share of the baseline's value, and at least so many. Rounding can
# move an iteration, and with it a solve; entries of a factor follow from the mesh.
TOLERANCES = {
    "factorisations": (0.1, 1),
    "solves": (0.1, 3),
    "gradients": (0.1, 3),
    "hessians": (0.1, 1),
    "outer": (0.1, 1),
    "factor_nonzeros": (0.01, 0),
}
COLUMNS = tuple(TOLERANCES)


def counts_of(result):
    """The counts of a result.json by name; None where the program did not write them yet."""
    counts = result.get("counts", {})
    return {name: counts.get(name) for name in COLUMNS}


def moved(old, new):
    """[(name, old, new, share of old)] beyond the tolerance. A table from before these columns has
    no old value, and a run that failed no new one: there is nothing to compare."""
    found = []
    for name, (share, least) in TOLERANCES.items():
        a, b = old.get(name), new.get(name)
        if a is not None and b is not None and abs(b - a) > max(share * a, least):
            found.append((name, a, b, (b - a) / a if a else None))
    return found
