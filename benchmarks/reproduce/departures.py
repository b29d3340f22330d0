"""What the program does otherwise than sections 2 and 3 of the paper. Only rows whose paper's side
the project has on record (docs/notation.md, README.md, the comments of hybrid/): the text of the
paper is not kept here, so the table may lack a sentence."""

HEADER = ("place in the paper", "the paper", "the program", "why")

ROWS = (
    (
        "2, strains [1-2]",
        "Strains v and u of a rod; how it is divided into elements is not on record here.",
        "One rigid frame per node and one logarithm per element give both.",
        "Rigid motions cost nothing, and thin rods do not lock.",
    ),
    (
        "2, order of solving",
        "Rods first, surfaces second.",
        "`paper` does the same and states the force that the surfaces leave on the rods. `coupled`"
        " has one minimum of walls, seams and contacts.",
        "That force is balanced by nothing; a wall and its rod move together.",
    ),
    (
        "2, binding [7]",
        "The surface is bound to where its sections carry it, with k_c.",
        "`paper` does the same. In `coupled` the wall carries the whole energy, and the rod is its"
        " start, its frames and its report.",
        "Against finite elements `paper` misses bent tubes by some percent of the radius, `coupled`"
        " by about a tenth of a percent (docs/comparison.md).",
    ),
    (
        "2, bending and stretching [8, 9]",
        "Sums over vertices and edges with coefficients k_b and k_s, without area weights.",
        "`paper` keeps the sums. Coefficients that the scene does not give follow from E, nu and t"
        " of the wall and from the mesh. `coupled` has membrane and bending of triangles, exact in"
        " the wall's thickness.",
        "Equal constants mean another wall on another mesh.",
    ),
    (
        "2, solving the surfaces [13]",
        "Local-global iteration: edges are set to their rest length, then a linear system is"
        " solved.",
        "L-BFGS, preconditioned with the matrix of that system, until the residual is 1e-8.",
        "An iteration of [13] is one step of descent in that metric; the minimum is the same.",
    ),
    (
        "3, cut and incision",
        "The vein is cut and the artery incised at two picked points.",
        "The same, on the shapes at rest; what the cut adds is bound anew. The cut may be oblique,"
        " and the incision an ellipse.",
        "Nothing is interpolated from a deformed shape.",
    ),
    (
        "3, joining",
        "Springs between the vertices of the two openings.",
        "Springs with multipliers: the gap left is 0.1 % of the vein's radius at most. Pairs"
        " have equal shares of arc length, and the mouth is turned to where the twist is least.",
        "The stiffness of a spring does not decide the shape; pairs of unequal length add energy.",
    ),
    (
        "3, contact",
        "Contact pressure is shown (Fig. 4c-e); how it is computed is not on record here.",
        "Pressure is the multiplier of the gap between outer walls: 0 where they are apart. What"
        " overlaps at rest carries none. No friction.",
        "A penalty alone presses before walls touch or lets them pass.",
    ),
    (
        "3, walls as they were seen",
        "Vessels from CT; the energies [1-10] have no pressure and no stress at rest.",
        "`paper` does the same; at `coupled`, `skin` and `rod`, with `pressure` and"
        " `axial_prestretch`, a vessel starts in equilibrium as it was seen.",
        "Vessels in an image are under pressure, and a cut vein springs back.",
    ),
)
