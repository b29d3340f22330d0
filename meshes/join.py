#!/usr/bin/env python3
"""Joins two vessels of a result of `vasorod solve` at their seam into one surface, as a scan after
the operation shows their lumen: with spoil.py, a test of `vasorod prepare`. Needs numpy alone."""

import argparse
import pathlib
import struct
import zlib

import numpy as np

import spoil
import vtp


def seam(vein, artery):
    """The two boundary loops, of as many points each, that lie on each other: vertices of the vein,
    those of the artery at the same places, and the largest distance between them."""
    best = None
    for a in spoil.boundary_loops(vein[1]):
        for b in spoil.boundary_loops(artery[1]):
            if len(a) != len(b):
                continue
            apart = np.linalg.norm(vein[0][a][:, None] - artery[0][b][None], axis=2)
            gap = apart.min(axis=1).max()
            if best is None or gap < best[2]:
                best = np.array(a), np.array(b)[apart.argmin(axis=1)], gap
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("vein", type=pathlib.Path, help="its VTP file in the result folder")
    parser.add_argument("artery", type=pathlib.Path, help="that of the vessel it was sewn to")
    parser.add_argument("lumen", type=pathlib.Path, help="the VTP file to write")
    options = parser.parse_args()
    vessels = []
    for path in (options.vein, options.artery):
        try:
            vessels.append(vtp.read_vtp(path))
        except (OSError, ValueError, IndexError, struct.error, zlib.error) as error:
            parser.error(f"{path}: found {error}, expected a vessel of a result folder")
    vein, artery = vessels
    found = seam(vein, artery)
    # mm; a converged seam at `paper` has been 0.004 apart
    if found is None or found[2] > 0.05 or len(set(found[1])) < len(found[1]):
        parser.error(f"{options.vein}: found no end that lies on one of {options.artery}")
    number = np.arange(len(vein[0])) + len(artery[0])
    number[found[0]] = found[1]
    points = np.vstack([artery[0], vein[0]])
    triangles = np.vstack([artery[1], number[vein[1]]])
    used = np.unique(triangles)
    place = np.zeros(len(points), dtype=int)
    place[used] = np.arange(len(used))
    vtp.write_vtp(options.lumen, points[used], place[triangles])


if __name__ == "__main__":
    main()
