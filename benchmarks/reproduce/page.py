"""index.html: one page without any outside link. Every number carries the file and the key that it
comes from."""

from html import escape

from departures import HEADER, ROWS

TITLE = "Predictive Simulation of Bidirectional Glenn Shunt Using a Hybrid Blood Vessel Model"
COPYRIGHT = " The figure itself is not shown here for copyright."
STYLE = """body{font:16px/1.45 sans-serif;max-width:68rem;margin:2rem auto;padding:0 1rem;
color:#222}
h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2.6rem;border-top:1px solid #ccc;
padding-top:1rem}
.figures{display:flex;flex-wrap:wrap;gap:.8rem}figure{margin:0;flex:1 1 20rem;max-width:33rem}
img{width:100%;background:#fff;border:1px solid #ddd}figcaption{font-size:.85rem;color:#444}
table{border-collapse:collapse;margin:.8rem 0;font-size:.88rem}
td,th{border:1px solid #ccc;padding:.25rem .55rem;text-align:left;vertical-align:top}
td.n{text-align:right;white-space:nowrap}dt{font-weight:bold;float:left;clear:left;width:10.5rem}
dd{margin:0 0 .35rem 11rem}code{font-size:.85em}"""


def text_of(value):
    """Four significant digits; whole numbers in full, an exact zero as 0."""
    if value is None:
        return "-"
    if isinstance(value, int) or float(value).is_integer() and abs(value) < 1e6:
        return f"{int(value):,}"
    return f"{value:.4g}"


def shown(number, value):
    return text_of(value if value is None or number.times == 1 else number.times * value)


def number_row(work, number):
    source = (
        f' data-file="{escape(number.file)}" data-key="{escape(number.key)}"'
        f' data-times="{number.times:g}"'
    )
    return (
        f"<tr><td>{escape(number.label)}</td><td class=n>{escape(number.paper) or '-'}</td>"
        f"<td class=n{source}>{shown(number, work.value(number))}</td>"
        f"<td>{escape(number.unit)}</td></tr>"
    )


def section(work, panel):
    lines = [
        ("the paper", panel.paper + (COPYRIGHT if panel.figures else "")),
        ("reproduced", panel.reproduced),
        ("not reproduced", panel.missing),
        ("differs", panel.differs),
    ]
    text = [f'<section id="{panel.identity}"><h2>{escape(panel.title)}</h2><dl>']
    text += [f"<dt>{name}</dt><dd>{escape(line)}</dd>" for name, line in lines]
    text.append('</dl><div class="figures">')
    for figure in panel.figures:
        text.append(
            f'<figure><a href="{figure.file}"><img src="{figure.file}"'
            f' alt="{escape(figure.caption)}"></a>'
            f"<figcaption>{escape(figure.caption)}</figcaption></figure>"
        )
    text.append("</div>")
    if panel.numbers:
        text.append("<table><tr><th></th><th>paper</th><th>here</th><th></th></tr>")
        text += [number_row(work, number) for number in panel.numbers]
        text.append("</table>")
    return "\n".join([*text, "</section>"])


def departures_section():
    rows = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in ROWS
    )
    head = "".join(f"<th>{cell}</th>" for cell in HEADER)
    return (
        '<section id="departures"><h2>Sections 2 and 3: what the program does otherwise</h2>'
        "<p>The rows are those whose paper's side this project has on record; the text of the paper"
        " is not kept here, so a sentence may be missing. Words in quotes are fidelities of the"
        " program.</p><table><tr>" + head + "</tr>" + rows.replace("`", "&quot;") + "</table>"
        "</section>"
    )


def missing_section(missing):
    if not missing:
        return "<p>No panel is missing.</p>"
    items = "".join(
        f"<li>{escape(name)}: {escape(reason)}</li>" for name, reason in missing.items()
    )
    return f'<p>Panels that are missing:</p><ul id="missing">{items}</ul>'


def page(work, panels, missing, commit):
    how = "a quick run: fewer points in Fig. 3(d)" if work.quick else "a full run"
    return "\n".join(
        [
            '<!doctype html><html lang="en"><head><meta charset="utf-8">',
            "<title>The paper again</title>",
            f"<style>{STYLE}</style></head><body>",
            f"<h1>The figures and numbers of &ldquo;{TITLE}&rdquo; (MICCAI 2009), again</h1>",
            "<p><b>Research software, not for clinical use.</b> Every panel was computed and drawn"
            f" by this program; {how}, commit {escape(commit)}. The paper's CT images of a patient"
            " are not public: in their place stands the bundled infant anatomy, which is drawn."
            " Fidelity <code>paper</code> has the paper's energies in the paper's order. Commands"
            " of all outputs: codecheck.yml. Scenes and results: runs/.</p>",
            missing_section(missing),
            *(section(work, panel) for panel in panels),
            departures_section(),
            "</body></html>\n",
        ]
    )
