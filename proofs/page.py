import re,os,subprocess
from pathlib import Path
import importlib.metadata as md
os.chdir("/work/w/files")
plain=lambda n: re.sub(r"[-_.]+","-",n).lower()
L={"sim/jsbsim/requirements.txt":"simulation","ground/report-requirements.txt":"reports","ground/requirements.txt":"station","ground/campaign-requirements.txt":"campaigns","tests/requirements.txt":"tests","scripts/trace/requirements.txt":"trace","scripts/coverage-requirements.txt":"coverage","scripts/laws/requirements.txt":"laws"}
K={"colorlog":"MIT","gcovr":"BSD-3-Clause","hypothesis":"MPL-2.0","aiohappyeyeballs":"PSF-2.0","cosmic-ray":"MIT","contourpy":"BSD-3-Clause","cycler":"BSD-3-Clause","docutils":"Public Domain AND BSD-2-Clause AND PSF-2.0 AND GPL-3.0-or-later","jsbsim":"LGPL-2.1-or-later","kiwisolver":"BSD-3-Clause","matplotlib":"PSF-2.0","partd":"BSD-3-Clause","ply":"BSD-3-Clause","pymavlink":"LGPL-3.0-only","pysocks":"BSD-3-Clause","python-datauri":"Unlicense","scipy":"BSD-3-Clause","semantic-version":"BSD-2-Clause","xlrd":"BSD-3-Clause","yamcs-client":"LGPL-3.0-only","yamcs-pymdb":"LGPL-3.0-only","zict":"BSD-3-Clause","shellingham":"ISC","lz4":"BSD-3-Clause","jinja2":"BSD-3-Clause","webencodings":"BSD-3-Clause","protobuf":"BSD-3-Clause","mit license":"MIT","tree-sitter-ada":"MIT"}
def norm(s):
    s=s.strip()
    return {"MIT License":"MIT","Apache 2.0":"Apache-2.0","Apache License 2.0":"Apache-2.0","Apache Software License":"Apache-2.0","Python Software Foundation License":"PSF-2.0","Mozilla Public License 2.0 (MPL 2.0)":"MPL-2.0","ISC License":"ISC"}.get(s,s)
def lic(n):
    if plain(n) in K: return K[plain(n)]
    m=md.metadata(n)
    cl=[c.split(" :: ")[-1] for c in m.get_all("Classifier") or [] if c.startswith("License ::") and c!="License :: OSI Approved"]
    for c in (m.get("License-Expression"), m.get("License"), *cl):
        if c and c.strip(): return norm(c)
seen={}
for f,use in L.items():
    for l in open(f):
        if "==" in l and not l.startswith("#"):
            n,v=l.rstrip(" \\\n").split("==")
            seen.setdefault(plain(n),(n,v,[]))[2].append(use)
rows=[f"| {n} | {v} | {lic(n)} | {', '.join(u)} |" for _,(n,v,u) in sorted(seen.items())]
out=subprocess.run(["python3","/tmp/sc/jars.py"],capture_output=True,text=True).stdout
J={"Apache 2.0":"Apache-2.0","Apache License, Version 2.0":"Apache-2.0","The Apache Software License, Version 2.0":"Apache-2.0","Apache Software Licenses":"Apache-2.0","Apache License 2.0":"Apache-2.0","The MIT License":"MIT","MIT License":"MIT","GNU Library or Lesser General Public License":"LGPL-2.1-or-later","GNU Lesser General Public License":"LGPL-2.1-or-later","GPL v2 with the Classpath exception":"GPL-2.0-only WITH Classpath-exception-2.0","GNU Lesser General Public License (LGPL)":"LGPL-3.0-only","GNU Affero General Public License (AGPL)":"AGPL-3.0-only","GNU General Public License, version 2":"GPL-2.0-only"}
jars=[]
for l in out.splitlines():
    n,g,ls=l.split(" ",2)
    ls=eval(ls)
    jars.append(f"| `{n}` | {g.replace('/','.')} | {' OR '.join(J.get(x,x) for x in ls)} |")
page=f"""# Everything that URV uses from others

URV itself is under Apache-2.0 (`LICENSE`). The flight software (`src`) uses
nothing but GNAT's run-time library. The rest is for the simulation, the ground
station, the tests and the proof. A test compares this page with the pinned
files (SEC-17, SEC-18); licences are those that the packages name.

## Debian packages

`scripts/setup.sh` installs them with apt-get, which checks Debian's signatures.
It is the only step that needs root.

| package | for | licence |
|---|---|---|
| gnat, gprbuild | compiler and builder | GPL-3.0-or-later, the run-time library with GCC's exception |
| gcc, g++, binutils | the C of fuzzing and benchmarks, sizes | GPL-3.0-or-later |
| libaunit | unit tests | GPL-3.0-or-later WITH GCC-exception-3.1 |
| python3, python3-venv | simulation, station, scripts | PSF-2.0 |
| default-jre-headless | Yamcs | GPL-2.0-only WITH Classpath-exception-2.0 |
| maven | gets Yamcs | Apache-2.0 |
| afl++ | fuzzing | Apache-2.0 |
| chromium, fonts-dejavu-core | tests of the page | BSD-3-Clause; Bitstream Vera |
| socat | tests of serial lines | GPL-2.0-only |
| rt-tests | timing | GPL-2.0-or-later |
| git | mutation | GPL-2.0-only |

GNATprove 12 is Alire's crate `gnatprove`, GPL-3.0-or-later. The model of the
aircraft in `sim/jsbsim` is URV's own.

## Python packages

`scripts/setup.sh` installs them into `.venv` with `pip --require-hashes
--only-binary :all:`: only wheels whose SHA-256 is in the lists. A wheel is
unpacked; no code of it runs while it is installed. After a change of a version
`scripts/hashes.py LIST` writes the hashes.

| use | list |
|---|---|
{chr(10).join(f"| {u} | `{f}` |" for f,u in L.items())}

| package | version | licence | for |
|---|---|---|---|
{chr(10).join(rows)}

plotly's wheel has plotly.js (MIT), which is in each report.

## Yamcs

Maven gets the archive of missions and its web pages, with what they need, when
somebody calls `make ground` or `make test`; they run as a process of their own.
`ground/yamcs/pom.xml` pins the version, `ground/yamcs/SHA256SUMS` each file:
with another one there set-up ends. Maven's own plug-ins, which fetch the files,
are checked only against the checksums of the server that they come from.

| file | from | licence |
|---|---|---|
{chr(10).join(jars)}
"""
Path("docs/dependencies.md").write_text(page)
