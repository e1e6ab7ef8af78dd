import re,glob,os
from pathlib import Path
m2=Path.home()/".m2/repository"
idx={p.name:p for p in m2.rglob("*.jar")}
def lic(pom,depth=0):
    if not pom.exists(): pom=next(iter(pom.parent.glob("*.pom")))
    t=pom.read_text("utf-8","replace")
    t=re.sub(r"<!--.*?-->","",t,flags=re.S)
    found=re.findall(r"<license>.*?<name>(.*?)</name>",t,re.S)
    if found or depth>5: return found
    p=re.search(r"<parent>(.*?)</parent>",t,re.S)
    if not p: return []
    g,a,v=(re.search(f"<{x}>(.*?)</{x}>",p[1]).group(1) for x in ("groupId","artifactId","version"))
    pp=m2/g.replace(".","/")/a/v/f"{a}-{v}.pom"
    return lic(pp,depth+1) if pp.exists() else []
for l in open("/work/w/files/ground/yamcs/SHA256SUMS"):
    n=l.split()[1]; p=idx.get(n)
    print(n, p.parent.parent.parent.relative_to(m2) if p else None, lic(p.with_suffix(".pom")) if p else "?")
