"""The page: one file that needs no network. Texts of the sections are HTML already; what runs say is not."""
import base64
import html
import io
import re

from plot_run import Missing, plt
from reproduce_model import ABSENT, MISSED, REACHED, SHOWN, verdict_of

STYLE = """
:root { --ink: #252c31; --soft: #5f6a72; --line: #dde3e7; --tint: #f5f7f8; --blue: #173f5f; }
* { box-sizing: border-box; }
body { font: 16px/1.6 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; color: var(--ink);
  max-width: 68rem; margin: 0 auto; padding: 2.5rem 1.5rem 5rem; background: #fff; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .4rem; color: var(--blue); }
h2 { font-size: 1.45rem; margin: 3.5rem 0 .6rem; padding-top: .8rem; border-top: 2px solid var(--blue);
  color: var(--blue); }
h3 { font-size: 1.12rem; margin: 2rem 0 .5rem; }
p, li { max-width: 52rem; }
.soft { color: var(--soft); font-size: .92rem; }
.scroll { overflow-x: auto; margin: .8rem 0 1.2rem; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; line-height: 1.4; }
th { text-align: left; font-weight: 600; color: var(--soft); border-bottom: 2px solid var(--line);
  padding: .4rem .7rem; vertical-align: bottom; }
td { border-bottom: 1px solid var(--line); padding: .42rem .7rem; vertical-align: top; }
td, th { font-variant-numeric: tabular-nums; }
tr:hover td { background: var(--tint); }
figure { margin: 1.6rem 0; }
figure img { width: 100%; height: auto; display: block; border: 1px solid var(--line); border-radius: 4px; }
figcaption { color: var(--soft); font-size: .9rem; margin-top: .5rem; max-width: 56rem; }
.verdict { display: inline-block; padding: .05rem .55rem; border-radius: 1rem; font-size: .82rem;
  font-weight: 600; white-space: nowrap; }
.reached { background: #dff2ea; color: #14614a; } .missed { background: #fde3dc; color: #9c2c10; }
.missing { background: #fbeecb; color: #76560a; } .shown { background: #e9edf0; color: var(--soft); }
.note { background: var(--tint); border-left: 4px solid #f2b134; padding: .6rem 1rem; margin: .9rem 0;
  max-width: 56rem; font-size: .93rem; }
.absent { background: #fbeecb; border: 1px dashed #c79a2b; border-radius: 4px; padding: 1rem;
  color: #76560a; }
details { margin: .8rem 0; } summary { cursor: pointer; color: var(--blue); font-size: .93rem; }
code { background: var(--tint); padding: 0 .25rem; border-radius: 3px; font-size: .9em; }
a { color: var(--blue); }
@media print { h2 { break-before: page; } details { display: none; } }
"""


def escape(text):
    return html.escape(str(text), quote=True)


def plain(text):
    return re.sub("<[^>]*>", "", text)


def badge(verdict):
    return f'<span class="verdict {verdict}">{verdict}</span>'


def table(head, rows):
    cells = "".join(f"<th>{name}</th>" for name in head)
    body = "\n".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f'<div class="scroll"><table><thead><tr>{cells}</tr></thead>\n<tbody>{body}</tbody></table></div>'


def anchor(label):
    return re.sub("[^a-z0-9]+", "-", label.lower()).strip("-")


def picture(shown, results):
    """The picture as part of the page, or what it lacks."""
    caption = f"<figcaption>{shown.caption}</figcaption>"
    try:
        fig = shown.draw(results)
    except (Missing, KeyError, IndexError, ValueError, OSError) as missing:
        return f'<figure><div class="absent">No picture: {escape(missing)}</div>{caption}</figure>'
    data = io.BytesIO()
    fig.savefig(data, format="png", dpi=125, bbox_inches="tight", pad_inches=0.12)
    plt.close(fig)
    code = base64.b64encode(data.getvalue()).decode()
    alternative = escape(plain(shown.caption))
    return f'<figure><img alt="{alternative}" src="data:image/png;base64,{code}">{caption}</figure>'


def exhibit_part(section, exhibit, results):
    rows = []
    for row in exhibit.rows:
        judged = results.judge(row)
        rows.append((row.what, row.paper, row.reference, escape(judged.ours), judged.limit,
            badge(judged.verdict)))
    verdict = badge(verdict_of(results, section, exhibit))
    parts = [f'<h3 id="{anchor(exhibit.label)}">{exhibit.label}: {exhibit.title} {verdict}</h3>']
    if rows:
        parts.append(table(("quantity", "paper", "exact or reference", "ours", "limit", ""), rows))
    return parts + [picture(shown, results) for shown in exhibit.pictures]


def checks_part(section, results):
    rows = []
    for case in section.cases:
        for check in results.get(case.name).checks():
            value = check["value"]
            value = "not finite" if value is None else f"{value:.4g}"
            unit = "" if check["unit"] == "-" else check["unit"]
            rows.append((case.name, escape(check["quantity"]), f"{value} {escape(unit)}",
                         escape(check["limit"]), badge(check["verdict"])))
    if not rows:
        return ""
    missed = sum(MISSED in row[-1] for row in rows)
    return (f"<details{' open' * bool(missed)}><summary>What these scenes check: "
            f"{len(rows) - missed} reached, {missed} missed</summary>"
            + table(("run", "quantity", "value", "limit", ""), rows) + "</details>")


def section_part(section, results):
    parts = [f'<h2 id="{section.key}">{section.title}</h2>', section.text]
    for case in section.cases:
        problem = results.get(case.name).problem
        if problem:
            parts.append(f'<p class="absent"><b>{case.name}</b>: {escape(problem)}</p>')
    parts += [f'<p class="note">{note}</p>' for note in section.notes]
    for exhibit in section.exhibits:
        print(f"drawing {exhibit.label}", flush=True)
        parts += exhibit_part(section, exhibit, results)
    return "\n".join(parts + [checks_part(section, results)])


def index_part(sections, results):
    rows = []
    for section in sections:
        for exhibit in section.exhibits:
            first = exhibit.rows[0]
            judged = results.judge(first)
            rows.append((f'<a href="#{anchor(exhibit.label)}">{exhibit.label}</a>',
                f'{exhibit.title}<br><span class="soft">{first.what}</span>',
                         first.paper, first.reference, escape(judged.ours),
                         badge(verdict_of(results, section, exhibit))))
    return table(("of the paper", "what", "paper", "exact or reference", "ours", "verdict"), rows)


def cost_part(sections, results):
    rows = []
    for section in sections:
        for case in section.cases:
            result = results.get(case.name)
            s = result.summary
            called = case.scene + ".xml " + " ".join(case.arguments)
            if result.problem:
                rows.append((case.name, escape(called), "", "", "", "", escape(result.problem)))
                continue
            origin = f"re-used, run of {result.reused}" if result.reused else "run for this page"
            rows.append((case.name, f"<code>{escape(called)}</code>" + (case.about and f"<br>{case.about}"),
                         f"{s['wall_seconds']:.1f}", f"{s['particles']:,}", f"{s['steps']:,}",
                         f"{escape(s['version'])} ({escape(s['commit'])})", origin))
    return table(("run", "scene", "seconds", "particles", "steps", "program", ""), rows)


def outcome(sections, results):
    """How many exhibits there are of each verdict."""
    verdicts = [verdict_of(results, s, e) for s in sections for e in s.exhibits]
    return {verdict: verdicts.count(verdict) for verdict in (REACHED, MISSED, ABSENT)}


def write_page(path, title, introduction, sections, results, closing, version):
    count = outcome(sections, results)
    reused = [r for r in results.values() if r.reused]
    parts = [f"<h1>{title}</h1>", introduction,
             f'<p class="soft">{escape(version)}</p>',
             f"<p><b>{sum(count.values())} tables and figures:</b> "
             + ", ".join(f"{n} {badge(v)}" for v, n in count.items() if n) + "</p>"]
    if reused:
        others = sorted({f"{r.summary['version']} ({r.summary['commit']})" for r in reused})
        parts.append(f'<p class="note"><b>{len(reused)} of {len(results)} runs were not run again</b> '
                     f"(<code>--quick</code>); they were made by version {escape(', '.join(others))}. "
                     "Which ones stands at the page's end.</p>")
    parts.append(index_part(sections, results))
    parts.append(f'<p class="soft">{badge(REACHED)} all limits hold, those of the scenes and those of the '
                 f"page; {badge(SHOWN)} a number without a limit. {closing[0]}</p>")
    parts += [section_part(section, results) for section in sections]
    parts.append(closing[1])
    parts.append('<h2 id="cost">What each run cost</h2>' + cost_part(sections, results))
    text = (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{plain(title)}</title>'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<style>{STYLE}</style></head>\n<body>\n" + "\n".join(parts) + "\n</body></html>\n")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
