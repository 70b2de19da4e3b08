"""The look of a report: light and dark, wide and narrow, on screen and on paper."""

from __future__ import annotations

from typing import Final

PAGE_STYLE: Final = """\
:root{color-scheme:light dark;--paper:#fff;--ink:#1b2026;--soft:#545d68;--rule:#d3d8de;
--panel:#f4f6f8;--part:#cfdcec;--jaw:#8b939c;--push:#1b2026;--accent:#1d5a9e;--bar:#86a8cf;
--good:#1c6b3c}
@media (prefers-color-scheme:dark){:root{--paper:#13161a;--ink:#e7eaee;--soft:#a5aeb9;
--rule:#3a424c;--panel:#1c2127;--part:#2f4c6d;--jaw:#78818b;--push:#e7eaee;--accent:#82b6f2;
--bar:#41699a;--good:#7fd3a0}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);line-height:1.5;
font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",Arial,sans-serif}
main{max-width:62rem;margin:0 auto;padding:1.5rem 1.25rem 4rem}
h1{font-size:1.9rem;line-height:1.2;margin:.2rem 0 .6rem}
h2{font-size:1.3rem;line-height:1.3;margin:3rem 0 .6rem;padding-top:1rem;
border-top:1px solid var(--rule)}
h1,p,figcaption,caption{overflow-wrap:anywhere}
p{margin:.5rem 0 1rem;max-width:46rem}
a{color:var(--accent)}
.soft,figcaption,caption{color:var(--soft)}
.hero{display:flex;flex-wrap:wrap;gap:1.5rem 2.5rem;align-items:center}
.hero>svg{flex:0 0 auto;width:12rem;height:auto;max-height:14rem}
.hero>div{flex:1 1 22rem}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(9.5rem,1fr));gap:.75rem;
margin:1.5rem 0 0;padding:0}
.facts div{background:var(--panel);border-radius:.5rem;padding:.7rem .9rem}
.facts dt{color:var(--soft);font-size:.85rem;line-height:1.3}
.facts dd{margin:0 0 .15rem;font-size:1.45rem;font-weight:600;
font-variant-numeric:tabular-nums;overflow-wrap:anywhere}
.facts dd.long{font-size:1.05rem}
.facts div{display:flex;flex-direction:column-reverse;justify-content:flex-end}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
caption{text-align:left;padding:.2rem 0 .5rem}
caption span{display:inline-block;position:sticky;left:0;max-width:min(46rem,calc(100vw - 2rem))}
th,td{padding:.35rem .8rem;text-align:right;border-bottom:1px solid var(--rule);
vertical-align:baseline;white-space:nowrap}
thead th{white-space:normal;max-width:11rem}
thead th{font-weight:600;color:var(--soft);font-size:.88rem;vertical-align:bottom;
border-bottom:2px solid var(--soft)}
tbody th{font-weight:600}
.left{text-align:left}
tr.chosen{background:var(--panel);font-weight:600}
.wide{overflow-x:auto;margin:.5rem 0 1rem;
background:linear-gradient(to right,var(--paper) 40%,transparent) left/2.5rem 100% no-repeat local,
linear-gradient(to left,var(--paper) 40%,transparent) right/2.5rem 100% no-repeat local,
linear-gradient(to right,#80808080,transparent) left/.9rem 100% no-repeat scroll,
linear-gradient(to left,#80808080,transparent) right/.9rem 100% no-repeat scroll}
.wide:focus-visible{outline:3px solid var(--accent);outline-offset:2px}
.wide>svg{display:block;max-width:100%;height:auto;min-width:38rem}
details{margin:.6rem 0;border:1px solid var(--rule);border-radius:.5rem;padding:.1rem .9rem}
summary{cursor:pointer;padding:.45rem 0;font-weight:600}
code,.exact td,.exact th{font-family:ui-monospace,"DejaVu Sans Mono",Menlo,Consolas,monospace;
font-size:.88em}
.exact td{overflow-wrap:anywhere;white-space:normal}
code{background:var(--panel);border-radius:.25rem;padding:.1em .3em;overflow-wrap:anywhere}
.defs{position:absolute}
.player{position:relative}
.player>input{position:absolute;opacity:0;width:1px;height:1px;margin:0}
.steps{display:flex;flex-wrap:wrap;gap:.35rem;margin:.8rem 0}
.steps label{border:1px solid var(--soft);border-radius:.4rem;padding:.3rem .7rem;cursor:pointer;
min-width:2.6rem;text-align:center;user-select:none}
.steps label:hover{border-color:var(--accent);color:var(--accent)}
.said p{display:none;min-height:4.5rem;margin:.4rem 0}
.stage{display:grid;grid-template-columns:repeat(3,1fr);gap:.75rem}
.of4{grid-template-columns:repeat(4,1fr)}.of2,.of1{grid-template-columns:repeat(2,minmax(0,20rem))}
.panel{margin:0;background:var(--panel);border-radius:.5rem;padding:.4rem .4rem .6rem;
text-align:center}
.panel svg{display:block;width:100%;height:auto}
.panel figcaption{font-size:.9rem;line-height:1.35;font-variant-numeric:tabular-nums}
.panel b,.strip b{color:var(--ink)}
.panel b.yes,.strip b.yes{color:var(--good)}
.part{fill:var(--part);stroke:var(--ink);stroke-width:3;stroke-linejoin:round;fill-rule:evenodd}
.pointer{fill:none;stroke:var(--ink);stroke-width:2}
.first{fill:var(--ink)}
.mass{fill:var(--paper);stroke:var(--ink);stroke-width:3}
.jaw{fill:var(--jaw);stroke:var(--ink);stroke-width:1.5}
.pushing{fill:var(--push)}
.strip td,.strip th{text-align:center}
.strip{width:100%}.strip td,.strip tbody th{padding:.2rem;vertical-align:middle}
.still{display:block;width:7rem;height:7rem;margin:auto}
.sg-text{fill:var(--ink)}
.sg-part{fill:var(--part);stroke:var(--ink)}
.sg-hole,.sg-mass{fill:var(--paper);stroke:var(--ink)}
.sg-vertex,.sg-image,.sg-arrowhead{fill:var(--ink);stroke:var(--ink)}
.sg-arrow,.sg-heading{stroke:var(--ink)}
.sg-hull,.sg-ghost,.sg-frame,.sg-diagonal,.sg-drop,.sg-jump{stroke:var(--soft)}
.sg-grid,.sg-rule{stroke:var(--rule)}
.sg-curve,.sg-step{stroke:var(--accent)}
.sg-closed{fill:var(--accent);stroke:var(--accent)}
.sg-hollow{fill:var(--paper);stroke:var(--accent)}
.sg-bar,.sg-caught{fill:var(--bar);stroke:var(--ink)}
@media (max-width:40rem){main{padding:1rem .8rem 3rem}h1{font-size:1.5rem}
.stage,.of4{grid-template-columns:repeat(2,1fr)}.hero>svg{width:8rem}
th,td{padding:.3rem .5rem}.facts{grid-template-columns:1fr 1fr}}
@media print{:root{color-scheme:light;--paper:#fff;--ink:#000;--soft:#333;--rule:#bbb;
--panel:#f2f2f2;--part:#d9d9d9;--jaw:#888;--push:#000;--accent:#000;--bar:#aaa;--good:#000}
.player{display:none}body{font-size:10.5pt}main{max-width:none;padding:0}
h2{break-after:avoid}tr,figure,.wide>svg{break-inside:avoid}.wide{overflow:visible}
.wide>svg{min-width:0}.still{width:4.2rem;height:4.2rem}}
"""
