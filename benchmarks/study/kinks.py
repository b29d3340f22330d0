"""At which curvature a tube kinks, over the pressure in its lumen: bends to ever larger shares of
Brazier's curvature at that pressure, each from rest."""

import inflated_bends
from tables import write_extended

SHARES = {  # of Brazier's curvature at the pressure, by p / p_c
    0: (0.75, 0.8, 0.85, 0.9, 0.95, 1.0, 1.05),
    1: (0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8),
    5: (0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65),
}
AROUND = (32, 48)
SECTION = "rigid"
FILE = "kinks.csv"


def plan():
    """What inflated_bends.KEYS name."""
    return [
        (SECTION, share, ratio, "coupled", around)
        for ratio, shares in SHARES.items()
        for around in AROUND
        for share in shares
    ]


def all_runs():
    return [inflated_bends.run(*one) for one in plan()]


def make_table(store, path):
    note = "Long tubes with rigid ends bent to shares of Brazier's curvature at the pressure;"
    note += " columns as in inflated_bends.csv"
    keys = inflated_bends.KEYS
    write_extended(path, keys, plan(), *inflated_bends.rows_of(store, plan()), note)
