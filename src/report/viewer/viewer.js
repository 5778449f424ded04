(()=>{var Ky={skull_forehead:"skull",back_shoulders:"back or shoulders",neck_front:"front of the neck"},jy={stop:"stands still",forward:"walks straight ahead",left45:"turns left by 45° and walks",left90:"turns left by 90° and walks",right45:"turns right by 45° and walks",right90:"turns right by 90° and walks",back:"steps back",run:"runs straight ahead"},Qy={upright:"upright","bend-forward":"bent forward","bend-left":"bent to the left","bend-right":"bent to the right","bend-forward-left":"bent forward and to the left","bend-forward-right":"bent forward and to the right",kneel:"kneeling",crouch:"crouching",crawl:"crawling"},Si=n=>Ky[n]??String(n).replaceAll("_"," "),Ce=n=>`${n.toFixed(2)}x`,vn=n=>`${n.toFixed(0)} N`,Zp=n=>`${n.toFixed(0)} N/cm²`,Bl=n=>`${n.toFixed(2)} m`,Zn=n=>`${n.toFixed(2)} m/s`,Te=n=>`${n.toFixed(2)} s`,zl=({begins_s:n})=>`${Te(n)} after the FMU's start`,Vl=n=>`(${n.map(t=>t.toFixed(2)).join(", ")}) m`,De=n=>String(n).replace(/\B(?=(\d{3})+(?!\d))/g,","),fe=(n,t)=>`${De(n)} ${t}${Number(n)===1?"":"s"}`;function ss(n,t=Math.round){let e=100*n;if(e===0)return"0 %";if(e<1e-6)return"less than 0.000001 %";let i=e>=.995?1:Math.min(7,1-Math.floor(Math.log10(e))),s=10**i,r=t(e*s)/s;return`${(r>=100&&n<1?99.9:r).toFixed(i).replace(/(\.\d*?[1-9])0+$/,"$1")} %`}var Jp={momentary:"presses",held:"holds",toggled:"switches"},Kp=[];function jp(n){Kp=n}var no=[];function Qp(n){no=n??[]}function tm({name:n,by:t,kind:e,opens:i,by_either:s}){let r=i===void 0?Jp[e]:i?"opens":"closes";return`${t==="anyone"?"a colleague":s?"one of the people":"the person"} ${r} ${n}`}function tv(n){let t=Kp[Number(n)-1],e=t?.by==="anyone"?"a colleague ":"";return t?`${e}${t.door?"opens or closes":Jp[t.kind]} ${t.name}`:`works control ${n}`}function io(n){let[t,...e]=n.split("+press");return[t.split("&").map((s,r)=>{let[o,a]=s.split("/"),c=no[r]===void 0?"":`${no[r]} `;return a===void 0?s:`${c}${jy[o]??o}, ${Qy[a]??a}`}).join("; "),...e.map(tv)].join(", ")}var _r=()=>no.length>0?"somebody":"the person",em=()=>no.length>0?"both people":"the person",nm=n=>no.length>0?io(n):`the person ${io(n)}`;function im(n,t){let e=[];for(let i of n)e.at(-1)?.name===i?e.at(-1).times+=1:e.push({name:i,times:1});return e.map(({name:i,times:s})=>`${s>1?`${s} x `:""}${io(i)}, ${+(s*t).toFixed(2)} s`)}var Bn=({class:n})=>n==="force"||n==="head_contact",Xu="thing in the hand";function Ni({class:n,judged:t,body_region:e,person:i,arm:s}){let r=`${s?.held_m?Xu:Si(e)}${i===void 0?"":` of ${i}`}`;switch(n){case"clamping":return`clamps the ${r}${t?.clamping?` against ${t.clamping.against}`:""}`;case"pressure":return`presses the ${r}`;case"moving_contact":return`touches the ${r} while it moves`;case"separation":return`is too near the ${r}`;default:return`hits the ${r}`}}function sm({class:n,judged:t,ratio:e,force_n:i,limit_n:s},r){let{clamping:o,pressure:a,separation:c,limit:l}=t??{};if(n==="separation"&&c){let{distance_m:u,required_m:f}=c;return typeof f=="number"?[`${Bl(f-u)} too near`,`${Bl(u)} away, ${Bl(f)} needed`]:["too near",`${Bl(u)} away from a robot that does not stop`]}if(n==="moving_contact")return["no contact allowed",`touched at ${Zn(r)}`];if(l==="pressure"&&a)return[`${Ce(e)} the limit`,`${Zp(a.n_cm2)}, limit ${Zp(a.limit_n_cm2)}`];let[d,h]=o?[o.force_n,o.limit_n]:[i,s];return[`${Ce(e)} the limit`,`${vn(d)}, limit ${vn(h)} for what cannot give way`]}var Gl=n=>["skull_forehead","face","neck_front"].includes(n);function rm(n){let{clamping:t,limit:e}=n.judged??{};return n.class==="clamping"&&e==="force"&&t?Zn(t.closing_m_s*t.limit_n/t.force_n):Bn(n)?Gl(n.body_region)?"none":Zn(n.safe_below_m_s):n.class==="moving_contact"?"none":"-"}var qu=n=>n.class==="head_contact"?"none allowed":vn(n.limit_n),om=n=>Bn(n)?`${vn(n.force_n)} / ${qu(n)}`:sm(n,n.speed_m_s).join(": "),am=2,Hl=`The two differ by more than a factor of ${am}.`;function Fi(n,{speed_criterion:t}){let e=t==="approach",i={name:"with the robot's own speed",force:n.force_n,ratio:n.force_n/n.limit_n,speed:n.speed_m_s,decides:!e},s={name:"with the speed of approach (the person's walking included)",force:n.directed_force_n,ratio:n.directed_ratio,speed:n.approach_m_s,decides:e};if(!Bn(n))return{own:i,approach:s,decides:{ratio:n.ratio},apart:!1};let[r,o]=[i.ratio,s.ratio].sort((a,c)=>a-c);return{own:i,approach:s,decides:e?s:i,apart:o>am*r}}var $s=(n,t)=>t<1&&Gl(n)?`no contact allowed (${Ce(t)})`:Ce(t),Wl=({speed_criterion:n})=>n==="approach"?"the speed of approach (the person's walking included)":"the robot's own speed";function xr(n,t=n){let{class:e,ratio:i,force_n:s,limit_n:r}=n;if(!Bn(n))return sm(n,t.speed_m_s);let o=`${vn(s)}, limit ${vn(r)}`;return e==="head_contact"?["no contact allowed",`${o} (${Ce(i)})`]:[`${Ce(i)} the limit`,o]}function so(n){return n==null?"not tried":n?"yes":"NO"}function lm(n){let t=e=>e.person_detected?`reports ${_r()}${typeof e.since_s=="number"?` for ${Te(e.since_s)}`:""}`:`does not report ${_r()}`;return n.map(e=>`${e.name} ${t(e)}`).join(", ")||"no sensor"}function Yu(n){return n.filter(e=>e.person_detected).map(e=>typeof e.since_s=="number"?`${e.name} ${Te(e.since_s)}`:e.name).join(", ")||"none"}function cm(n){return n.sequences===null||n.sequences===void 0?fe(n.times_found,"time"):fe(n.sequences,"sequence")}var ro=[{key:"task",label:"Task: who does what there (ISO 12100, 5.2)",long:!0},{key:"severity",label:"Severity",options:[["S1","S1: slight, reversible"],["S2","S2: serious, irreversible or death"]]},{key:"exposure",label:"Exposure",options:[["F1","F1: seldom or short"],["F2","F2: frequent or long"]]},{key:"avoidance",label:"Avoidance",options:[["P1","P1: possible"],["P2","P2: scarcely possible"]]},{key:"decision",label:"Decision",options:["open","reduce","accepted","not credible"].map(n=>[n,n])},{key:"measure",label:"Protective measure",long:!0},{key:"residual",label:"Residual risk",long:!0},{key:"by",label:"By"},{key:"date",label:"Date",type:"date"}],ev={S1F1P1:"a",S1F1P2:"b",S1F2P1:"b",S1F2P2:"c",S2F1P1:"c",S2F1P2:"d",S2F2P1:"d",S2F2P2:"e"},vr=({severity:n,exposure:t,avoidance:e})=>ev[`${n}${t}${e}`]??null,hm=n=>Object.fromEntries(Object.entries(n).sort(([t],[e])=>t<e?-1:1));function um({assessments:n,cell:t,causeOf:e}){let i=new Map(Object.entries(n).map(([h,u])=>[h,{...u}])),s=[],r=new Set,o=()=>s.forEach(h=>h());addEventListener("beforeunload",h=>{r.size>0&&h.preventDefault()});let a=ro.find(h=>h.key==="decision").options.map(([h])=>h),c=[...i.values()].map(h=>h.decision).filter(Boolean),l=h=>i.get(h)??{},d=h=>l(h).decision||null;return{decisions:[...new Set([...a,...c])],of:l,own:d,ofCause:h=>d(h)??"open",decision:h=>d(h)??d(e(h)?.id)??"open",set(h,u,f){let m=Object.fromEntries(ro.map(x=>[x.key,""]));i.set(h,{...m,...i.get(h),[u]:f}),r.add(h),o()},unsaved(){let h=[...r].filter(f=>f.startsWith("C-")).length,u=r.size-h;return[h>0?fe(h,"cause"):"",u>0?fe(u,"single way"):""].filter(Boolean).join(" and ")},text(){let h=Object.fromEntries([...i].map(([u,f])=>[u,hm(f)]));return`${JSON.stringify({assessments:hm(h),cell:t.name,format:1},null,2)}
`},saved(){r.clear(),o()},follow:h=>s.push(h)}}var nv="http://www.w3.org/2000/svg";function dm(n,t,e){for(let[i,s]of Object.entries(t))i.startsWith("on")?n.addEventListener(i.slice(2),s):s!=null&&s!==!1&&n.setAttribute(i,s===!0?"":s);return n.append(...e.flat().filter(i=>i!=null)),n}function C(n,t={},...e){return dm(document.createElement(n),t,e)}function bt(n,t={},...e){return dm(document.createElementNS(nv,n),t,e)}function ma(n,t){t?n.setAttribute("aria-current","true"):n.removeAttribute("aria-current")}function Pn(n,t,...e){return C("section",{id:n,"aria-labelledby":`${n}-title`},C("h2",{id:`${n}-title`},t),...e)}function ci(n){let t=C("dl");for(let[e,i]of n)i!=null&&i!==""&&t.append(C("div",{},C("dt",{},e),C("dd",{},i)));return t}function Xs(n){let t=C("code",{},n),e=C("button",{type:"button",class:"copy screen-only",onclick:i},"Copy");async function i(){try{await navigator.clipboard.writeText(n),e.textContent="Copied"}catch{getSelection().selectAllChildren(t),e.textContent="Marked: press Ctrl+C"}setTimeout(()=>e.textContent="Copy",2500)}return C("div",{class:"command"},t,e)}function $l(n){let t=new DOMParser().parseFromString(n,"image/svg+xml").documentElement;if(t.localName!=="svg")return C("p",{class:"note"},"The drawing cannot be read.");for(let s of[t,...t.querySelectorAll("*")]){["script","foreignObject"].includes(s.localName)&&s.remove();for(let{name:r}of[...s.attributes])(r.startsWith("on")||r.endsWith("href"))&&s.removeAttribute(r)}let e=t.getAttribute("width"),i=t.getAttribute("height");return!t.hasAttribute("viewBox")&&e&&i&&t.setAttribute("viewBox",`0 0 ${e} ${i}`),t.setAttribute("role","img"),document.importNode(t,!0)}var Xl=100,fm=212,iv=.3,sv=[["upper_arm","M27.4 46.5 C25 54 21.4 70 20 82 L28.2 84.2 C29.6 74 32.6 62 34 52.5 L34 46 C31.6 43.2 29 43.6 27.4 46.5 Z"],["lower_arm","M19.8 83.6 C17.4 92 15.6 103 14.8 112 L21.2 113.6 C23.6 105 26.9 95 28 85.8 Z"],["hand","M14.6 113.6 C11.8 118 11.2 124 12.8 129.5 C14.8 132.5 18 131.8 19 128.4 L22.6 124.2 C23.4 121 21.6 118 21 115.2 Z"],["thigh","M32.2 104.8 C31.4 118 33 134 35.2 149 L46.2 149 C47.8 136 48.9 122 48.9 108.6 Z"],["lower_leg","M35.3 150.6 C33.8 160 34.6 174 37 190 C36.6 195 33.6 199.4 32.6 203.4 C34.6 206.6 43.4 206.6 45.2 203.4 C45.2 198 44.3 195 44.5 190 C46.4 176 47.5 162 46.2 150.6 Z"]],pm=["pelvis","M35 86.2 C33.4 91 32.5 97 32.2 103.2 L48.6 107.2 L50 104.4 L51.4 107.2 L67.8 103.2 C67.5 97 66.6 91 65 86.2 Z"],rv="M45 28.4 C47.5 31 52.5 31 55 28.4 L55.8 35.4 L44.2 35.4 Z",ov="M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.4 42.8 34.6 45.2 C37 42.2 41 40.2 46.2 39.4 L45.6 36.6 Z",av=[["skull_forehead","M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 Z"],["face","M39.4 16.2 L60.6 16.2 C60.6 23.4 55.2 30 50 30 C44.8 30 39.4 23.4 39.4 16.2 Z"],["neck_front",rv],["chest","M47 39.4 C41.4 40.4 37 42.6 34.8 46 L35 53 C34.8 58.6 35 62.4 35.8 66 L64.2 66 C65 62.4 65.2 58.6 65 53 L65.2 46 C63 42.6 58.6 40.4 53 39.4 Z"],["abdomen","M36 67.2 C36.6 73 36.3 78.6 35.2 85 L64.8 85 C63.7 78.6 63.4 73 64 67.2 Z"],pm],lv=[["skull_forehead","M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 C60.8 22 57 28.2 50 28.2 C43 28.2 39.2 22 39.4 15 Z"],["neck","M44.6 26.6 C47.5 30 52.5 30 55.4 26.6 L55.8 35.4 L44.2 35.4 Z"],["back_shoulders","M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.6 43 34.8 46 L35 53 C34.8 64 36.9 72 35.2 85 L64.8 85 C63.1 72 65.2 64 65 53 L65.2 46 C67.4 43 70.8 42.6 73 46 C72.8 44.6 72.4 43.3 71.4 42 C68 38.2 60 38.6 56 36.6 Z"],pm],cv={front:"M45.6 18.6 h0.01 M54.4 18.6 h0.01 M46.6 24.8 C48.6 26.2 51.4 26.2 53.4 24.8 M50 70 v6",back:"M50 40 V82 M42.6 52 C41 57 41.4 61 44 63 M57.4 52 C59 57 58.6 61 56 63"};function hv(n){let t=[...sv,...n==="front"?[["back_shoulders",ov]]:[]];return[...(n==="front"?av:lv).map(([e,i])=>[e,i,!1]),...t.flatMap(([e,i])=>[[e,i,!1],[e,i,!0]])]}function uv({lines:n}){let t=new Map;for(let{body_region:e,ratio:i}of n)t.set(e,Math.max(t.get(e)??0,i));return[...t].sort(([,e],[,i])=>i-e)}function ql(n){let t=new Map(uv(n)),e=Math.max(...t.values()),i=([d,h])=>{let u=$s(d,h);return`${Si(d)}${u===Ce(h)?"":":"} ${u}`},s=[];function r([d,h,u]){let f=t.get(d),m=f!==void 0,x=bt("path",{d:h,class:m?"region hit":"region","data-region":d,transform:u?`translate(${Xl} 0) scale(-1 1)`:null,style:m?`--heat:${Math.max(iv,f/e).toFixed(3)}`:null},bt("title",{},m?`${i([d,f])}, as many times the limit`:`${Si(d)}: not hit`));return s.push(x),x}let o=(d,h)=>bt("g",{transform:`translate(${h} 0)`},hv(d).map(r),bt("path",{class:"feature",d:cv[d]}),bt("text",{x:Xl/2,y:fm+9},d)),a=[...t].map(i),c=[...t.keys()].map((d,h)=>C("li",{"data-region":d},a[h]));return{element:C("figure",{class:"body-outline","data-test":"body-outline"},bt("svg",{viewBox:`2 -2 ${2*Xl-14} ${fm+15}`,role:"img","aria-label":`Person from the front and from the back. Hit, times the limit: ${a.join(", ")}.`},o("front",-3),o("back",Xl-11)),C("ul",{class:"regions","aria-hidden":"true"},c)),mark(d){for(let h of[...s,...c])h.classList.toggle("selected",h.dataset.region===d)}}}var Zu=3,dv=120,mm=["#c2410c","#1d6fb8","#7c3aed","#15803d","#a16207","#0e7490","#be185d","#57606a"],ga=({number:n})=>mm[(n-1)%mm.length],qs=n=>C("span",{class:"badge",style:`background:${ga(n)}`},String(n.number));function Ju(n,t){let{begins:e}=n.hazard(t.worst);return[["share",typeof t.share=="number"?`${ss(t.share)} of all sequences`:""],["earliest",e?`worst begins ${zl(e)}`:`after ${Te(t.earliest_time_s)}`],["ways",`${fe(t.hazards.length,"way")}, ${t.confirmed===t.hazards.length?t.confirmed===1?"confirmed":"all confirmed":`${t.confirmed} confirmed`}`]].filter(([,i])=>i)}function gm({change:n,checked:t,complete:e,enough_until_s:i,removes_all:s,less:r}){let o=typeof i=="number",a=[["With it this cause was not met any more; other causes are left.","It removes this cause; other causes are left."],["Tried in part: with it no hazard was met any more.","Tried in part: with it nothing is hazardous from the starts in the cell file; from elsewhere that is not shown."],["",`Enough: with it nothing in this cell is hazardous any more, by any sequence from the start and from anywhere until ${i} s.`]][Number(s)+Number(s&&e&&o)][Number(e)];return C("li",{"data-test":"change",class:s?"all":null},C("b",{},n),C("p",{},a),C("p",{class:"note"},`Checked: ${t}${e?"":" (not every sequence)"}.`.replace(/\.\.$/,".")),r?C("p",{class:"note"},r):null)}function Ku(n,t){let{own:e,approach:i,decides:s,apart:r}=Fi(n.hazard(t.worst),n.scan.settings),o=s===e?i:e;return r?C("p",{class:"flag"},`${o.name[0].toUpperCase()}${o.name.slice(1)}: ${Ce(o.ratio)} the limit, ${vn(o.force)}.`):null}function ju({id:n,advice:t}){let e=C("h4",{},"What to change");if(!t)return C("div",{class:"remedy"},e,C("p",{"data-test":"no-advice"},"Changes are tried out by:"),Xs(`fmi-hazard explain . ${n}`));let{changes:i,note:s}=t,r=i.slice(Zu);return C("div",{class:"remedy"},e,i.length>0?C("ol",{class:"changes"},i.slice(0,Zu).map(gm)):C("p",{"data-test":"no-change"},"No single change that was tried keeps this cause from being met."),r.length>0?C("details",{},C("summary",{},`${fe(r.length,"other change")}`),C("ol",{class:"changes",start:Zu+1},r.map(gm))):null,s?C("p",{class:"note"},s):null)}function _m(n,t,{choose:e,assess:i,assessments:s}){let[r,o]=xr(t,n.hazard(t.worst)),a=ql(t),c=C("p",{class:"decided","data-test":"cause-decision"}),l=p=>g=>{!(g.ctrlKey||g.metaKey||g.shiftKey)&&String(getSelection())===""&&(g.preventDefault(),g.stopPropagation(),e(p))},d=p=>{let g=n.hazard(p);return C("li",{},C("a",{href:`#${p}`,"data-test":"way","data-id":p,onclick:l(p)},C("span",{class:"id"},p),` ${Ce(Fi(g,n.scan.settings).decides.ratio)} after ${Te(g.time_s)}`))},h=(p,g)=>Bn(t)?$s(p,g):Ce(g),u=({body_region:p,robot_link:g,ratio:y,hazards:M})=>C("details",{class:"line","data-test":"line"},C("summary",{},`${g} ${Ni({...n.hazard(M[0]),body_region:p})}: `,C("b",{},h(p,y)),`, ${fe(M.length,"way")}`),C("ul",{class:"ways"},M.map(d))),f=C("a",{href:`#${t.id}`,onclick:l(t.id)},t.sentence),m=C("article",{class:"cause","data-test":"cause","data-id":t.id,style:`--cause:${ga(t)}`},C("header",{class:"cause-head"},qs(t),C("h3",{class:t.sentence.length>dv?"long":null,"data-test":"cause-sentence"},f),C("span",{class:"id"},t.id)),C("p",{class:"severity"},C("b",{class:"worst"},r)," ",C("span",{},o)),Ku(n,t),C("ul",{class:"figures"},Ju(n,t).map(([p,g])=>C("li",{class:`figure-${p}`},g))),C("div",{class:"cause-body"},ju(t),a.element),C("div",{class:"decision-row"},c,C("button",{type:"button",class:"screen-only",onclick:i},"Assess it")),C("details",{class:"lines","data-test":"lines"},C("summary",{},`${fe(t.hazards.length,"way")} of this cause, by region and link`),t.lines.map(u)));m.addEventListener("click",p=>{m.classList.contains("compact")&&!p.defaultPrevented&&String(getSelection())===""&&e(t.id)});function x(){let p=vr(s.of(t.id)),g=t.hazards.filter(y=>s.own(y)!==null).length;c.replaceChildren("Decision: ",C("b",{},s.ofCause(t.id)),p?` · PL r: ${p}`:"",g>0?` · ${fe(g,"way")} decided on ${g===1?"its":"their"} own`:"")}return s.follow(x),x(),{element:m,show(p){m.classList.toggle("compact",p===null),ma(m,p!==null),p!==null&&(a.mark(n.hazard(p).body_region),m.querySelectorAll('[data-test="way"]').forEach(g=>ma(g,g.dataset.id===p)))},focus:()=>f.focus({preventScroll:!0})}}function xm(n,t,e,{picture:i,assess:s}){let r=C("div",{class:"chosen"}),o=C("div",{class:"others"}),a=C("div",{class:"hero"},r,i);function c(d){let h=t.now.cause,u=o.contains(document.activeElement);t.select(d),u&&l.get(t.now.cause).focus(),t.now.cause===h?i.scrollIntoView({block:"nearest"}):a.scrollIntoView({block:"start"})}let l=new Map(n.causes.map(d=>[d.id,_m(n,d,{choose:c,assess:s,assessments:e})]));return t.follow(({cause:d,hazard:h})=>{for(let[f,m]of l)m.show(f===d?h:null);let u=[...l].filter(([f])=>f!==d).map(([,f])=>f.element);r.firstElementChild!==l.get(d).element&&(r.replaceChildren(l.get(d).element),o.replaceChildren(...u.length>0?[C("h3",{},`${fe(u.length,"other cause")}, worst first`),...u]:[]))}),Pn("causes",`${fe(n.causes.length,"cause")}${n.causes.length>1?", worst first":""}`,a,o)}var fv={shown:"shown",assumed:"accepted",open:"open"},pv=n=>({shown:()=>n.figure,assumed:()=>`${n.by}: ${n.because} (${n.tried})`,open:()=>n.what_to_do?`${n.why}. ${n.what_to_do}.`:n.why})[n.standing](),mv=n=>C("tr",{class:n.standing},C("td",{},fv[n.standing]),C("td",{},n.about?`${n.says} (${n.about})`:n.says),C("td",{},pv(n))),gv=["open","assumed","shown"];function ym({obligations:n}){if(!n||n.length===0)return null;let t=gv.flatMap(i=>n.filter(s=>s.standing===i)),e=n.flatMap(i=>i.accept?[i.accept]:[]);return C("div",{"data-test":"rests-on"},C("h3",{},"What this result rests on"),C("div",{class:"scroll",tabindex:0},C("table",{class:"plain obligations"},C("thead",{},C("tr",{},["","needed","known"].map(i=>C("th",{scope:"col"},i)))),C("tbody",{},t.map(mv)))),e.length>0?[C("p",{},"Whoever accepts what was only tried out adds to the cell file:"),C("pre",{"data-test":"accept"},e.join(`
`))]:null)}var _a=({settings:n})=>n.strategy==="anywhere";function Yl({certificate:n,settings:t,spent:e}){if(t.strategy==="anywhere")return`people who come from anywhere that no sensor sees, at any moment within ${t.until_s} s of the FMU's start`;let i=`a quick search of ${fe(e.iterations,"sequence")}`;if(n){let s=`all beginnings of ${n.complete_for_actions} of ${n.horizon} actions`;return t.strategy==="auto"?`${i}, and ${s}`:s}return t.strategy==="auto"?`${i} alone, with seed ${t.seed}`:`${fe(e.iterations,"iteration")} of ${t.strategy} with seed ${t.seed}`}var _v={says:"This result was written by an earlier version, which did not say what it rests on. Scan again.",covers:""},Qu=({headline:n})=>n??_v;function vm({scan:n,cell:t}){let{says:e,covers:i}=Qu(n);return C("header",{class:"top"},C("div",{class:"title"},C("h1",{},t.name),C("p",{class:"kicker"},`${n.tool} · hazard report`)),C("p",{class:`verdict ${n.verdict}`,"data-test":"verdict"},e),C("p",{class:"scope","data-test":"scope"},i),C("p",{class:"note"},`A hazard is a way, found in the model, for a person to be ${n.settings.criteria?"harmed by what this cell counts as unsafe":"hit harder than ISO/TS 15066 allows"}. The report helps an assessment; it does not show that the cell is safe.`))}var bm=n=>`${(1e3*n).toFixed(0)} ms`;function xv({transitions:n,compared:t,merges:e,merges_compared:i}){let s=(a,c)=>a===c?`all ${De(c)}`:`${De(a)} of ${De(c)}`,r=e>0?`, and ${s(i,e)} merges gone on with`:"",o=t===n&&i===e?"":"; a sample, chosen by a key";return t>0?`${s(t,n)} FMU transitions, by fresh instances from the start${r}${o}`:""}function yv(n){let{certificate:t,settings:e}=n;if(_a(n))return[C("h3",{},"From anywhere"),C("p",{"data-test":"anywhere"},`Looked at: ${Yl(n)}. What is not known is told under what this result rests on.`)];if(!t)return[C("h3",{},"Not complete"),C("p",{"data-test":"incomplete"},"There is no certificate of completeness: not every sequence of actions was looked at, so there may be hazards that are not listed. ","A complete search of the same cell: ",C("code",{},"--strategy exhaustive"),".")];let i=t.random_search;return[C("h3",{},t.complete?"Certificate: complete":"Not complete"),t.complete||t.complete_for_actions>=t.horizon?null:C("p",{"data-test":"incomplete"},`Only the beginnings of ${t.complete_for_actions} of ${t.horizon} actions were all looked at; hazards that need more actions may be missing.`),ci([["within",`${t.actions} actions, ${t.horizon} in a row, ${bm(e.action_s)} each; contact checked every ${bm(e.contact_check_interval_s)}; reach tolerance ${(1e3*e.reach_tolerance_m).toFixed(0)} mm`],["sequences",`${De(t.covered)} of ${De(t.sequences)} accounted for`],["hazardous",`${De(t.hazardous)}: ${ss(t.hazardous_share)}`],["harmless",De(t.harmless)],["too far away",`${De(t.excluded)} cannot meet the robot any more in the time that is left`],["not evaluated",t.not_evaluated==="0"?"":`${De(t.not_evaluated)}: the FMU could not finish them`],["distinct states",`${De(t.states)}; equal FMU states told by ${t.merged_by}${t.merged>0?` (${De(t.merged)} histories merged, ${De(t.merges_tried_out)} of the merges tried out)`:""}`],["run again",xv(t.run_again)],["random search",i&&t.hazardous_share>0?`one in ${De((1/t.hazardous_share).toFixed(0))} random sequences is hazardous, so it needs that many iterations on average; within ${i.iterations} it finds nothing in ${ss(i.miss_probability)} of runs`:""]])]}function vv(n){if(!n)return[];let t=n.hazardous===0?`below ${ss(n.hazardous_share_below,Math.ceil)}, one-sided`:`${ss(n.hazardous_share_interval[0],Math.floor)} to ${ss(n.hazardous_share_interval[1],Math.ceil)}, Clopper-Pearson`,e=n.unlisted;return[C("h3",{},"Residual: what is left, by random sequences alone"),ci([["random sequences",`${De(n.random_sequences)}, of these ${De(n.hazardous)} hazardous${n.not_evaluated>0?`, ${De(n.not_evaluated)} not evaluated`:""}`],["hazardous share",`of all sequences: ${t}`],["not listed here",e?`one more random sequence ends in a hazard not listed with probability below ${ss(e.probability_below,Math.ceil)} (${De(e.met_others)} of ${De(e.checked)} later ones did; Good-Turing estimate ${ss(e.good_turing_estimate)})`:""],["confidence",`95 % each; for ${n.holds_for}`]])]}var Mm=n=>n<1e6?`${n.toFixed(2)} m${n<0?" (shapes overlap)":""}`:"never near";function bv(n=[]){return n.length<2?[]:n.map(({name:t,moved:e,top_speed_m_s:i,instants_in_reach:s,closest_approach_m:r})=>{let o=e||i>=.001?`up to ${Zn(i)}`:"never moved",a=s>0&&r>=1e6?"":`; closest approach of the body ${Mm(r)}`;return[t,`${o}${a}; near enough to touch at ${fe(s,"instant")}`]})}function Mv(n,t){let{coverage:e,spent:i,certificate:s}=n;if(_a(n)){let a=`${fe(i.fmu_steps,"FMU step")}, ${fe(i.fmu_states,"FMU state")}, ${fe(i.contact_checks,"set")} of poses, ${fe(i.arm_checks,"arm search").replace("searchs","searches")}`;return[C("h3",{},"Coverage"),ci([["spent",a]])]}let r=t.sensors,o=e.sensor_actions.map((a,c)=>`${r[c]} in ${fe(a,"action")}`).join(", ");return[C("h3",{},"Coverage"),ci([["sequences",s?"":`${De(i.iterations)}, ${De(e.episodes_not_evaluated)} not evaluated`],["spent",`${fe(e.actions,"action")}, ${fe(i.fmu_steps,"FMU step")}, ${fe(i.fmu_states,"FMU state")}, ${fe(e.contact_checks,"contact check")}, ${fe(e.arm_checks,"arm search").replace("searchs","searches")}${e.arm_checks_incomplete>0?` (${De(e.arm_checks_incomplete)} ended early)`:""}${e.arm_runs_not_evaluated>0?`; ${De(e.arm_runs_not_evaluated)} runs in which a plane tells of an arm could not be finished by the FMU`:""}`],["robot",`moved at up to ${Zn(e.robot_top_speed_m_s)}; within arm's reach at ${fe(e.checks_with_robot_in_arm_reach,"instant")}`],["closest approach",`of the body: ${Mm(e.closest_approach_m)}`],...bv(e.robots),["within the limits",`${fe(e.contacts_within_limits,"contact")}${e.contacts_within_limits>0?`, highest ${Ce(e.highest_ratio_within_limits)}`:""}`],["walks",`obstacles stopped the person ${fe(e.walks_blocked,"time")}`],["sensors",o?`reported the person: ${o}`:"none in this cell: the safeguard is the guarding itself"]])]}function Sv(n){return n.length===0?[C("h3",{},"Faults of the FMU"),C("p",{},"None: the FMU finished every action that it was asked for.")]:[C("h3",{},"Faults of the FMU"),C("p",{},`${fe(n.length,"action")} could not be finished; what would come after is not evaluated.`),C("ul",{class:"faults"},n.map(t=>C("li",{},C("p",{class:"message"},t.message),C("p",{class:"note"},t.actions.join(", ")))))]}function Sm({scan:n,cell:t}){let e=n.warnings.map(i=>C("li",{},i));return Pn("coverage","What the search covered",ym(n),e.length>0?C("ul",{class:"warnings","data-test":"warnings"},e):null,C("div",{class:"columns"},C("div",{},yv(n),vv(n.residual)),C("div",{},Mv(n,t),Sv(n.faults))))}var Em=n=>Uint8Array.from(atob(n),t=>t.charCodeAt(0));function br(n){let t=Em(n),e=new DataView(t.buffer);return Float32Array.from({length:t.length/4},(i,s)=>e.getFloat32(4*s,!0))}async function wm(n){let t=new Blob([Em(n)]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(t).json()}function wv(n,t){let e={...n,step:t.step_s,links:br(n.links),body:br(n.body),arms:br(n.arms),...n.moved?{moved:n.moved.map(i=>({...i,centre_m:br(i.centre_m)}))}:{},...n.beside?{beside:br(n.beside),beside_arms:br(n.beside_arms)}:{}};for(let i of["time_s","distance_m","speed_m_s","force_ratio"])e[i]=br(n[i]);return e}async function Tm(){let n=JSON.parse(document.getElementById("data").textContent);if(n.format!==2)throw new Error(`data of format ${n.format}, but this viewer reads format 2`);let t=await wm(n.replays);n.cell.looks=n.cell.looks?await wm(n.cell.looks):[];let e=new Map(t.map(l=>[l.id,l])),i=new Map,s=new Map(n.scan.hazards.map(l=>[l.id,l])),r=n.scan.causes??[],o=new Map(r.map((l,d)=>[l.id,{...l,number:d+1}])),a=new Map([...o.values()].flatMap(l=>l.hazards.map(d=>[d,l]))),c=n.scan.hazards.filter(({id:l})=>!a.has(l));if(c.length>0)throw new Error(`${c[0].id} is in no cause`);return{...n,replays:t,causes:[...o.values()],cause:l=>o.get(l),causeOf:l=>a.get(l),hazard:l=>s.get(l),replay(l){return!i.has(l)&&e.has(l)&&i.set(l,wv(e.get(l),n.cell)),i.get(l)},topView:l=>e.get(l)?.top_view}}var td="assessments.json";function Ev(n,{decisions:t}){let e={"data-test":`assess-${n.key}`,name:n.key};if(n.options){let i=n.key==="decision"?t.map(r=>[r,r]):n.options,s=C("option",{value:""},"–");return C("select",e,s,i.map(([r,o])=>C("option",{value:r},o)))}return n.long?C("textarea",{...e,rows:2}):C("input",{...e,type:n.type??"text"})}function Tv(n){let t=URL.createObjectURL(new Blob([n],{type:"application/json"}));C("a",{href:t,download:td}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function Am(n,t,e){let i=ro.map(p=>[p,Ev(p,e)]),s=C("p",{class:"subject","data-test":"assess-subject"}),r=C("input",{type:"checkbox","data-test":"assess-scope",onchange:m}),o=C("span"),a=C("output",{class:"plr","data-test":"plr"}),c=C("output",{"data-test":"unsaved"}),l=C("button",{type:"button",class:"primary","data-test":"save",onclick:u},`Save ${td}`),d=null,h=()=>r.checked?t.now.hazard:t.now.cause;function u(){Tv(e.text()),e.saved()}function f(){let p=vr(e.of(h()));a.textContent=p?`PL r: ${p}`:"PL r: follows from severity, exposure and avoidance";let g=e.unsaved();c.textContent=g?`Unsaved edits of ${g}.`:"";let y=e.own(t.now.hazard);o.textContent=` only this row: ${t.now.hazard}${y?` (decided on its own: ${y})`:""}`}function m(){let p=n.hazard(t.now.hazard),g=n.cause(t.now.cause);s.replaceChildren(C("b",{},h()),r.checked?`: only ${p.robot_link} ${Ni(p)}, ${Ce(p.ratio)}. What is left empty is as for the cause.`:`, for ${g.hazards.length===1?"its one way":`all its ${fe(g.hazards.length,"way")}`}: ${g.sentence}`);for(let[y,M]of i){let b=e.of(h())[y.key]??"";M.tagName==="SELECT"&&![...M.options].some(R=>R.value===b)&&M.append(C("option",{value:b},b)),y.key==="decision"&&(M.options[0].hidden=!r.checked,M.options[0].textContent=`as for the cause (${e.ofCause(g.id)})`),M.value=b||(y.key==="decision"&&!r.checked?"open":"")}f()}for(let[p,g]of i)g.addEventListener("input",()=>e.set(h(),p.key,g.value));t.follow(p=>{p.cause!==d&&(d=p.cause,r.checked=!1),m()}),e.follow(f);let x=Pn("assessment","Assessment (ISO 12100)",s,C("label",{class:"scope-switch"},r,o),C("form",{onsubmit:p=>p.preventDefault()},i.map(([p,g])=>C("label",{class:p.long?"long":null},C("span",{},p.label),g))),C("p",{class:"plr-line"},a,C("span",{class:"note"}," Required performance level by the risk graph of ISO 13849-1, Annex A.")),C("p",{class:"save"},l,c),C("p",{class:"note"},`Saves the assessments of all causes and rows, those given to this report included, as one file. Keep ${td} beside the cell file, in git: scans read it and never write it. This page itself keeps no edits.`));return{element:x,show(){x.scrollIntoView({block:"start"}),i[0][1].focus({preventScroll:!0})}}}function Ys(n,t,e){let i=[0,1,2].map(a=>e[a]-t[a]),s=i.reduce((a,c)=>a+c*c,0),r=s>0?i.reduce((a,c,l)=>a+c*(n[l]-t[l]),0)/s:0,o=Math.max(0,Math.min(1,r));return Math.hypot(...[0,1,2].map(a=>n[a]-t[a]-o*i[a]))}function Cm(n,t,{a:e,b:i,radius:s}){for(let o=0;o<24;o++){let a=o/24;if(Ys(n.map((c,l)=>c+a*(t[l]-c)),e,i)<s)return!0}return!1}function ed([n,t,e,i],[s,r,o]){let[a,c,l]=[2*(t*o-e*r),2*(e*s-n*o),2*(n*r-t*s)];return[s+i*a+t*l-e*c,r+i*c+e*a-n*l,o+i*l+n*c-t*a]}function nd(n){let t=[...n].sort(([i,s],[r,o])=>i-r||s-o),e=i=>{let s=[];for(let r of i){for(;s.length>1;){let[o,a]=s.slice(-2);if((a[0]-o[0])*(r[1]-o[1])-(a[1]-o[1])*(r[0]-o[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return[...e(t),...e(t.reverse())]}function Nn({centre_m:n,size_m:t,quaternion:e}){let i=[-.5,.5],s=i.flatMap(r=>i.flatMap(o=>i.map(a=>[r*t[0],o*t[1],a*t[2]])));return nd(s.map(r=>ed(e,r)).map(([r,o])=>[n[0]+r,n[1]+o]))}function Zl([n,t],e){return e.every(([i,s],r)=>{let[o,a]=e[(r+1)%e.length];return(o-i)*(t-s)-(a-s)*(n-i)>=0})}var oo=(n,t)=>[n[t],n[t+1],n[t+2]];function wi(n,t,e,i){let s=6*(e*t.body.length+i);return{a:oo(n.body,s),b:oo(n.body,s+3),radius:t.body[i].radius_m}}var Mr=["left","right"];function Sr(n,t,e){let i=9*(2*t+e);return[0,3,6].map(s=>oo(n.arms,i+s))}function Rm(n,t,e){let[[i],[s]]=Mr.map((c,l)=>Sr(n,e,l)),[r,o]=[i[0]-s[0],i[1]-s[1]],a=Math.hypot(r,o);if(a<.02){let c=t.person_heading_deg*Math.PI/180;return[Math.cos(c),Math.sin(c),0]}return[o/a,-r/a,0]}var Pm=n=>({upper_arm:0,lower_arm:1,hand:2})[n];function rs(n,t,e,i){let s=7*(e*t.links.length+i),r=t.links[i];return r.shape==="capsule"?{a:oo(n.links,s),b:oo(n.links,s+3),radius:r.radius_m}:{position:oo(n.links,s),quaternion:[...n.links.slice(s+3,s+7)]}}function ao(n,{position:t,quaternion:e}){return n.points_m.map(i=>ed(e,i).map((s,r)=>s+t[r]))}function xa(n,t,e,i){let s=rs(n,t,e,i);return s.position?ao(t.links[i],s):[s.a,s.b]}function id(n,t){return n.reduce((e,i)=>t(i)<t(e)?i:e,n[0])}function Im(n,t,e){let i=s=>{let{a:r,b:o,radius:a}=wi(n,t,n.contact_frame,s);return Ys(e.body_point_m,r,o)-a};return id([...t.body.keys()],i)}function Lm(n,t,e){let i=[...t.links.keys()].filter(r=>{let{name:o,robot:a}=t.links[r];return o===e.robot_link||`${a}/${o}`===e.robot_link}),s=r=>{let o=rs(n,t,n.contact_frame,r),a=e.contact_point_m;return o.position?Math.min(...ao(t.links[r],o).map(c=>Ys(a,c,c))):Ys(a,o.a,o.b)-o.radius};return id(i.length>0?i:[...t.links.keys()],s)}function sd(n){let t=[...n.body.keys()].filter(e=>n.body[e].region.endsWith("shank"));return t.length>0?t:[n.body.length-1]}function Dm(n,t){let e=sd(t);return Array.from({length:n.frames},(i,s)=>{let r=e.map(o=>wi(n,t,s,o).b);return[0,1].map(o=>r.reduce((a,c)=>a+c[o],0)/r.length)})}function rd(n,t){let e=i=>-wi(n,t,0,i).a[2];return id([...t.body.keys()],e)}var lr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},cr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},xg=0,Hd=1,yg=2;var cl=1,vg=2,zo=3,hr=0,Qn=1,Ci=2,Lr=0,Vo=1,Wd=2,$d=3,Xd=4,bg=5;var Dr=100,Mg=101,Sg=102,wg=103,Eg=104,Tg=200,Ag=201,Cg=202,Rg=203,qd=204,Yd=205,Pg=206,Ig=207,Lg=208,Dg=209,Ng=210,Fg=211,Ug=212,Og=213,kg=214,Tc=0,Ac=1,Cc=2,Ao=3,Rc=4,Pc=5,Ic=6,Lc=7,hh=0,Bg=1,zg=2,us=0,Zd=1,Jd=2,Kd=3,jd=4,Qd=5,tf=6,ef=7;var nf=300,Nr=301,Go=302,uh=303,dh=304,Dc=1e3,as=1001,Nc=1002,Ln=1003,Vg=1004;var hl=1005;var jn=1006,fh=1007;var Is=1008;var ni=1009,sf=1010,rf=1011,Ho=1012,ph=1013,Hi=1014,Wi=1015,$i=1016,mh=1017,gh=1018,Fr=1020,of=35902,af=35899,lf=1021,cf=1022,Xi=1023,As=1026,Ls=1027,hf=1028,_h=1029,ur=1030,xh=1031;var yh=1033,ul=33776,dl=33777,fl=33778,pl=33779,vh=35840,bh=35841,Mh=35842,Sh=35843,wh=36196,Eh=37492,Th=37496,Ah=37488,Ch=37489,ml=37490,Rh=37491,Ph=37808,Ih=37809,Lh=37810,Dh=37811,Nh=37812,Fh=37813,Uh=37814,Oh=37815,kh=37816,Bh=37817,zh=37818,Vh=37819,Gh=37820,Hh=37821,Wh=36492,$h=36494,Xh=36495,qh=36283,Yh=36284,gl=36285,Zh=36286;var Ra=2300,Fc=2301,wc=2302,Ld=2303,Dd=2400,Nd=2401,Fd=2402;var Gg=3200;var Jh=0,Hg=1,Ds="",di="srgb",Pa="srgb-linear",Ia="linear",Ne="srgb";var Ec=7680;var Wg=519,$g=512,Xg=513,qg=514,uf=515,Yg=516,Zg=517,df=518,ff=519,Jg=35044;var pf="300 es",Ti=2e3,Co=2001;function Av(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Cv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function La(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Kg(){let n=La("canvas");return n.style.display="block",n}var Nm={},Ro=null;function mf(...n){let t="THREE."+n.shift();Ro?Ro("log",t,...n):console.log(t,...n)}function jg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function te(...n){n=jg(n);let t="THREE."+n.shift();if(Ro)Ro("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function se(...n){n=jg(n);let t="THREE."+n.shift();if(Ro)Ro("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Ea(...n){let t=n.join(" ");t in Nm||(Nm[t]=!0,te(...n))}function Qg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var t0={[Tc]:Tc,[Cc]:Ic,[Rc]:Rc,[Ao]:Pc,[Ac]:Ac,[Ic]:Cc,[Lc]:Lc,[Pc]:Ao},zi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Fm=1234567,wo=Math.PI/180,Po=180/Math.PI;function Ur(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]+"-"+zn[t&255]+zn[t>>8&255]+"-"+zn[t>>16&15|64]+zn[t>>24&255]+"-"+zn[e&63|128]+zn[e>>8&255]+"-"+zn[e>>16&255]+zn[e>>24&255]+zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]).toLowerCase()}function oe(n,t,e){return Math.max(t,Math.min(e,n))}function gf(n,t){return(n%t+t)%t}function Rv(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Pv(n,t,e){return n!==t?(e-n)/(t-n):0}function Ta(n,t,e){return(1-e)*n+e*t}function Iv(n,t,e,i){return Ta(n,t,1-Math.exp(-e*i))}function Lv(n,t=1){return t-Math.abs(gf(n,t*2)-t)}function Dv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Nv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Fv(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Uv(n,t){return n+Math.random()*(t-n)}function Ov(n){return n*(.5-Math.random())}function kv(n){n!==void 0&&(Fm=n);let t=Fm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Bv(n){return n*wo}function zv(n){return n*Po}function Vv(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Gv(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function _f(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Hv(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),d=o((t+i)/2),h=r((t-i)/2),u=o((t-i)/2),f=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*d,c*h,c*u,a*l);break;case"YZY":n.set(c*u,a*d,c*h,a*l);break;case"ZXZ":n.set(c*h,c*u,a*d,a*l);break;case"XZX":n.set(a*d,c*m,c*f,a*l);break;case"YXY":n.set(c*f,a*d,c*m,a*l);break;case"ZYZ":n.set(c*m,c*f,a*d,a*l);break;default:te("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function xf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function e0(n,t){if(t.constructor===Float32Array)return n;let e=xf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function n0(n,t){if(t.constructor===Float32Array)return n;let e=xf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var yf={DEG2RAD:wo,RAD2DEG:Po,generateUUID:Ur,clamp:oe,euclideanModulo:gf,mapLinear:Rv,inverseLerp:Pv,lerp:Ta,damp:Iv,pingpong:Lv,smoothstep:Dv,smootherstep:Nv,randInt:Fv,randFloat:Uv,randFloatSpread:Ov,seededRandom:kv,degToRad:Bv,radToDeg:zv,isPowerOfTwo:Vv,ceilPowerOfTwo:Gv,floorPowerOfTwo:_f,setQuaternionFromProperEuler:Hv,normalize:n0,denormalize:e0},Ot=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(oe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(oe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Fn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],d=i[s+2],h=i[s+3],u=r[o+0],f=r[o+1],m=r[o+2],x=r[o+3];if(h!==x||c!==u||l!==f||d!==m){let p=c*u+l*f+d*m+h*x;p<0&&(u=-u,f=-f,m=-m,x=-x,p=-p);let g=1-a;if(p<.9995){let y=Math.acos(p),M=Math.sin(y);g=Math.sin(g*y)/M,a=Math.sin(a*y)/M,c=c*g+u*a,l=l*g+f*a,d=d*g+m*a,h=h*g+x*a}else{c=c*g+u*a,l=l*g+f*a,d=d*g+m*a,h=h*g+x*a;let y=1/Math.sqrt(c*c+l*l+d*d+h*h);c*=y,l*=y,d*=y,h*=y}}t[e]=c,t[e+1]=l,t[e+2]=d,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],d=i[s+3],h=r[o],u=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+d*h+c*f-l*u,t[e+1]=c*m+d*u+l*h-a*f,t[e+2]=l*m+d*f+a*u-c*h,t[e+3]=d*m-a*h-c*u-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),d=a(s/2),h=a(r/2),u=c(i/2),f=c(s/2),m=c(r/2);switch(o){case"XYZ":this._x=u*d*h+l*f*m,this._y=l*f*h-u*d*m,this._z=l*d*m+u*f*h,this._w=l*d*h-u*f*m;break;case"YXZ":this._x=u*d*h+l*f*m,this._y=l*f*h-u*d*m,this._z=l*d*m-u*f*h,this._w=l*d*h+u*f*m;break;case"ZXY":this._x=u*d*h-l*f*m,this._y=l*f*h+u*d*m,this._z=l*d*m+u*f*h,this._w=l*d*h-u*f*m;break;case"ZYX":this._x=u*d*h-l*f*m,this._y=l*f*h+u*d*m,this._z=l*d*m-u*f*h,this._w=l*d*h+u*f*m;break;case"YZX":this._x=u*d*h+l*f*m,this._y=l*f*h+u*d*m,this._z=l*d*m-u*f*h,this._w=l*d*h-u*f*m;break;case"XZY":this._x=u*d*h-l*f*m,this._y=l*f*h-u*d*m,this._z=l*d*m+u*f*h,this._w=l*d*h+u*f*m;break;default:te("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],d=e[6],h=e[10],u=i+a+h;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(d-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(d-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+d)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+d)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(oe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,d=e._w;return this._x=i*d+o*a+s*l-r*c,this._y=s*d+o*c+r*a-i*l,this._z=r*d+o*l+i*c-s*a,this._w=o*d-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),d=Math.sin(l);c=Math.sin(c*l)/d,e=Math.sin(e*l)/d,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Um.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Um.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),d=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+c*l+o*h-a*d,this.y=i+c*d+a*l-r*h,this.z=s+c*h+r*d-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this.z=oe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this.z=oe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(oe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return od.copy(this).projectOnVector(t),this.sub(od)}reflect(t){return this.sub(od.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(oe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},od=new O,Um=new Fn,ae=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let d=this.elements;return d[0]=t,d[1]=s,d[2]=a,d[3]=e,d[4]=r,d[5]=c,d[6]=i,d[7]=o,d[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],d=i[4],h=i[7],u=i[2],f=i[5],m=i[8],x=s[0],p=s[3],g=s[6],y=s[1],M=s[4],b=s[7],R=s[2],w=s[5],_=s[8];return r[0]=o*x+a*y+c*R,r[3]=o*p+a*M+c*w,r[6]=o*g+a*b+c*_,r[1]=l*x+d*y+h*R,r[4]=l*p+d*M+h*w,r[7]=l*g+d*b+h*_,r[2]=u*x+f*y+m*R,r[5]=u*p+f*M+m*w,r[8]=u*g+f*b+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],d=t[8];return e*o*d-e*a*l-i*r*d+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],d=t[8],h=d*o-a*l,u=a*c-d*r,f=l*r-o*c,m=e*h+i*u+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return t[0]=h*x,t[1]=(s*l-d*i)*x,t[2]=(a*i-s*o)*x,t[3]=u*x,t[4]=(d*e-s*c)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(i*c-l*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Ea("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ad.makeScale(t,e)),this}rotate(t){return Ea("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ad.makeRotation(-t)),this}translate(t,e){return Ea("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ad.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ad=new ae,Om=new ae().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),km=new ae().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Wv(){let n={enabled:!0,workingColorSpace:Pa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ne&&(s.r=Ts(s.r),s.g=Ts(s.g),s.b=Ts(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ne&&(s.r=Eo(s.r),s.g=Eo(s.g),s.b=Eo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ds?Ia:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Pa]:{primaries:t,whitePoint:i,transfer:Ia,toXYZ:Om,fromXYZ:km,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:t,whitePoint:i,transfer:Ne,toXYZ:Om,fromXYZ:km,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:di}}}),n}var Se=Wv();function Ts(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Eo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var lo,Uc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{lo===void 0&&(lo=La("canvas")),lo.width=t.width,lo.height=t.height;let s=lo.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=lo}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=La("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ts(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ts(e[i]/255)*255):e[i]=Ts(e[i]);return{data:e,width:t.width,height:t.height}}else return te("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},$v=0,Io=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:$v++}),this.uuid=Ur(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ld(s[o].image)):r.push(ld(s[o]))}else r=ld(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ld(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Uc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(te("Texture: Unable to serialize Texture."),{})}var Xv=0,cd=new O,ei=class n extends zi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=as,s=as,r=jn,o=Is,a=Xi,c=ni,l=n.DEFAULT_ANISOTROPY,d=Ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Xv++}),this.uuid=Ur(),this.name="",this.source=new Io(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ot(0,0),this.repeat=new Ot(1,1),this.center=new Ot(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ae,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=d,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(cd).x}get height(){return this.source.getSize(cd).y}get depth(){return this.source.getSize(cd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){te(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==nf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Dc:t.x=t.x-Math.floor(t.x);break;case as:t.x=t.x<0?0:1;break;case Nc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Dc:t.y=t.y-Math.floor(t.y);break;case as:t.y=t.y<0?0:1;break;case Nc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=nf;ei.DEFAULT_ANISOTROPY=1;var nn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],d=c[4],h=c[8],u=c[1],f=c[5],m=c[9],x=c[2],p=c[6],g=c[10];if(Math.abs(d-u)<.01&&Math.abs(h-x)<.01&&Math.abs(m-p)<.01){if(Math.abs(d+u)<.1&&Math.abs(h+x)<.1&&Math.abs(m+p)<.1&&Math.abs(l+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(l+1)/2,b=(f+1)/2,R=(g+1)/2,w=(d+u)/4,_=(h+x)/4,T=(m+p)/4;return M>b&&M>R?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=w/i,r=_/i):b>R?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=w/s,r=T/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=T/r),this.set(i,s,r,e),this}let y=Math.sqrt((p-m)*(p-m)+(h-x)*(h-x)+(u-d)*(u-d));return Math.abs(y)<.001&&(y=1),this.x=(p-m)/y,this.y=(h-x)/y,this.z=(u-d)/y,this.w=Math.acos((l+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this.z=oe(this.z,t.z,e.z),this.w=oe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this.z=oe(this.z,t,e),this.w=oe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(oe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Oc=class extends zi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new nn(0,0,t,e),this.scissorTest=!1,this.viewport=new nn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Io(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},pi=class extends Oc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Da=class extends ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var kc=class extends ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ve=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,c,l,d,h,u,f,m,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,d,h,u,f,m,x,p)}set(t,e,i,s,r,o,a,c,l,d,h,u,f,m,x,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=d,g[10]=h,g[14]=u,g[3]=f,g[7]=m,g[11]=x,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/co.setFromMatrixColumn(t,0).length(),r=1/co.setFromMatrixColumn(t,1).length(),o=1/co.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),d=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let u=o*d,f=o*h,m=a*d,x=a*h;e[0]=c*d,e[4]=-c*h,e[8]=l,e[1]=f+m*l,e[5]=u-x*l,e[9]=-a*c,e[2]=x-u*l,e[6]=m+f*l,e[10]=o*c}else if(t.order==="YXZ"){let u=c*d,f=c*h,m=l*d,x=l*h;e[0]=u+x*a,e[4]=m*a-f,e[8]=o*l,e[1]=o*h,e[5]=o*d,e[9]=-a,e[2]=f*a-m,e[6]=x+u*a,e[10]=o*c}else if(t.order==="ZXY"){let u=c*d,f=c*h,m=l*d,x=l*h;e[0]=u-x*a,e[4]=-o*h,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*d,e[9]=x-u*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let u=o*d,f=o*h,m=a*d,x=a*h;e[0]=c*d,e[4]=m*l-f,e[8]=u*l+x,e[1]=c*h,e[5]=x*l+u,e[9]=f*l-m,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let u=o*c,f=o*l,m=a*c,x=a*l;e[0]=c*d,e[4]=x-u*h,e[8]=m*h+f,e[1]=h,e[5]=o*d,e[9]=-a*d,e[2]=-l*d,e[6]=f*h+m,e[10]=u-x*h}else if(t.order==="XZY"){let u=o*c,f=o*l,m=a*c,x=a*l;e[0]=c*d,e[4]=-h,e[8]=l*d,e[1]=u*h+x,e[5]=o*d,e[9]=f*h-m,e[2]=m*h-f,e[6]=a*d,e[10]=x*h+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(qv,t,Yv)}lookAt(t,e,i){let s=this.elements;return hi.subVectors(t,e),hi.lengthSq()===0&&(hi.z=1),hi.normalize(),Zs.crossVectors(i,hi),Zs.lengthSq()===0&&(Math.abs(i.z)===1?hi.x+=1e-4:hi.z+=1e-4,hi.normalize(),Zs.crossVectors(i,hi)),Zs.normalize(),Jl.crossVectors(hi,Zs),s[0]=Zs.x,s[4]=Jl.x,s[8]=hi.x,s[1]=Zs.y,s[5]=Jl.y,s[9]=hi.y,s[2]=Zs.z,s[6]=Jl.z,s[10]=hi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],d=i[1],h=i[5],u=i[9],f=i[13],m=i[2],x=i[6],p=i[10],g=i[14],y=i[3],M=i[7],b=i[11],R=i[15],w=s[0],_=s[4],T=s[8],k=s[12],D=s[1],N=s[5],G=s[9],W=s[13],P=s[2],B=s[6],Y=s[10],H=s[14],ht=s[3],U=s[7],J=s[11],$=s[15];return r[0]=o*w+a*D+c*P+l*ht,r[4]=o*_+a*N+c*B+l*U,r[8]=o*T+a*G+c*Y+l*J,r[12]=o*k+a*W+c*H+l*$,r[1]=d*w+h*D+u*P+f*ht,r[5]=d*_+h*N+u*B+f*U,r[9]=d*T+h*G+u*Y+f*J,r[13]=d*k+h*W+u*H+f*$,r[2]=m*w+x*D+p*P+g*ht,r[6]=m*_+x*N+p*B+g*U,r[10]=m*T+x*G+p*Y+g*J,r[14]=m*k+x*W+p*H+g*$,r[3]=y*w+M*D+b*P+R*ht,r[7]=y*_+M*N+b*B+R*U,r[11]=y*T+M*G+b*Y+R*J,r[15]=y*k+M*W+b*H+R*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],d=t[2],h=t[6],u=t[10],f=t[14],m=t[3],x=t[7],p=t[11],g=t[15],y=c*f-l*u,M=a*f-l*h,b=a*u-c*h,R=o*f-l*d,w=o*u-c*d,_=o*h-a*d;return e*(x*y-p*M+g*b)-i*(m*y-p*R+g*w)+s*(m*M-x*R+g*_)-r*(m*b-x*w+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],d=t[10];return e*(o*d-a*l)-i*(r*d-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],d=t[8],h=t[9],u=t[10],f=t[11],m=t[12],x=t[13],p=t[14],g=t[15],y=e*a-i*o,M=e*c-s*o,b=e*l-r*o,R=i*c-s*a,w=i*l-r*a,_=s*l-r*c,T=d*x-h*m,k=d*p-u*m,D=d*g-f*m,N=h*p-u*x,G=h*g-f*x,W=u*g-f*p,P=y*W-M*G+b*N+R*D-w*k+_*T;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/P;return t[0]=(a*W-c*G+l*N)*B,t[1]=(s*G-i*W-r*N)*B,t[2]=(x*_-p*w+g*R)*B,t[3]=(u*w-h*_-f*R)*B,t[4]=(c*D-o*W-l*k)*B,t[5]=(e*W-s*D+r*k)*B,t[6]=(p*b-m*_-g*M)*B,t[7]=(d*_-u*b+f*M)*B,t[8]=(o*G-a*D+l*T)*B,t[9]=(i*D-e*G-r*T)*B,t[10]=(m*w-x*b+g*y)*B,t[11]=(h*b-d*w-f*y)*B,t[12]=(a*k-o*N-c*T)*B,t[13]=(e*N-i*k+s*T)*B,t[14]=(x*M-m*R-p*y)*B,t[15]=(d*R-h*M+u*y)*B,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,d=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,d*a+i,d*c-s*o,0,l*c-s*a,d*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,d=o+o,h=a+a,u=r*l,f=r*d,m=r*h,x=o*d,p=o*h,g=a*h,y=c*l,M=c*d,b=c*h,R=i.x,w=i.y,_=i.z;return s[0]=(1-(x+g))*R,s[1]=(f+b)*R,s[2]=(m-M)*R,s[3]=0,s[4]=(f-b)*w,s[5]=(1-(u+g))*w,s[6]=(p+y)*w,s[7]=0,s[8]=(m+M)*_,s[9]=(p-y)*_,s[10]=(1-(u+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=co.set(s[0],s[1],s[2]).length(),a=co.set(s[4],s[5],s[6]).length(),c=co.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ui.copy(this);let l=1/o,d=1/a,h=1/c;return Ui.elements[0]*=l,Ui.elements[1]*=l,Ui.elements[2]*=l,Ui.elements[4]*=d,Ui.elements[5]*=d,Ui.elements[6]*=d,Ui.elements[8]*=h,Ui.elements[9]*=h,Ui.elements[10]*=h,e.setFromRotationMatrix(Ui),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=Ti,c=!1){let l=this.elements,d=2*r/(e-t),h=2*r/(i-s),u=(e+t)/(e-t),f=(i+s)/(i-s),m,x;if(c)m=r/(o-r),x=o*r/(o-r);else if(a===Ti)m=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Co)m=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=d,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=m,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ti,c=!1){let l=this.elements,d=2/(e-t),h=2/(i-s),u=-(e+t)/(e-t),f=-(i+s)/(i-s),m,x;if(c)m=1/(o-r),x=o/(o-r);else if(a===Ti)m=-2/(o-r),x=-(o+r)/(o-r);else if(a===Co)m=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=d,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=h,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=m,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},co=new O,Ui=new Ve,qv=new O(0,0,0),Yv=new O(1,1,1),Zs=new O,Jl=new O,hi=new O,Bm=new Ve,zm=new Fn,Cs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],d=s[9],h=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(oe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-d,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-oe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(oe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-oe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(oe(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-d,l),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-oe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-d,f),this._y=0);break;default:te("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Bm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Bm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return zm.setFromEuler(this),this.setFromQuaternion(zm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Cs.DEFAULT_ORDER="XYZ";var Lo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Zv=0,Vm=new O,ho=new Fn,bs=new Ve,Kl=new O,ya=new O,Jv=new O,Kv=new Fn,Gm=new O(1,0,0),Hm=new O(0,1,0),Wm=new O(0,0,1),$m={type:"added"},jv={type:"removed"},uo={type:"childadded",child:null},hd={type:"childremoved",child:null},Un=class n extends zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Zv++}),this.uuid=Ur(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new O,e=new Cs,i=new Fn,s=new O(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ve},normalMatrix:{value:new ae}}),this.matrix=new Ve,this.matrixWorld=new Ve,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Lo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ho.setFromAxisAngle(t,e),this.quaternion.multiply(ho),this}rotateOnWorldAxis(t,e){return ho.setFromAxisAngle(t,e),this.quaternion.premultiply(ho),this}rotateX(t){return this.rotateOnAxis(Gm,t)}rotateY(t){return this.rotateOnAxis(Hm,t)}rotateZ(t){return this.rotateOnAxis(Wm,t)}translateOnAxis(t,e){return Vm.copy(t).applyQuaternion(this.quaternion),this.position.add(Vm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Gm,t)}translateY(t){return this.translateOnAxis(Hm,t)}translateZ(t){return this.translateOnAxis(Wm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Kl.copy(t):Kl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ya.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bs.lookAt(ya,Kl,this.up):bs.lookAt(Kl,ya,this.up),this.quaternion.setFromRotationMatrix(bs),s&&(bs.extractRotation(s.matrixWorld),ho.setFromRotationMatrix(bs),this.quaternion.premultiply(ho.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent($m),uo.child=t,this.dispatchEvent(uo),uo.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(jv),hd.child=t,this.dispatchEvent(hd),hd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bs.multiply(t.parent.matrixWorld)),t.applyMatrix4(bs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent($m),uo.child=t,this.dispatchEvent(uo),uo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ya,t,Jv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ya,Kv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,d=c.length;l<d;l++){let h=c[l];r(t.shapes,h)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),d=o(t.images),h=o(t.shapes),u=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),d.length>0&&(i.images=d),h.length>0&&(i.shapes=h),u.length>0&&(i.skeletons=u),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let c=[];for(let l in a){let d=a[l];delete d.metadata,c.push(d)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Un.DEFAULT_UP=new O(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var fi=class extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}},Qv={type:"move"},Do=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new fi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new fi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new fi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let x of t.hand.values()){let p=e.getJointPose(x,i),g=this._getHandJoint(l,x);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let d=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],u=d.position.distanceTo(h.position),f=.02,m=.005;l.inputState.pinching&&u>f+m?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&u<=f-m&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Qv)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new fi;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},i0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Js={h:0,s:0,l:0},jl={h:0,s:0,l:0};function ud(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ce=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=di){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=i,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Se.workingColorSpace){if(t=gf(t,1),e=oe(e,0,1),i=oe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ud(o,r,t+1/3),this.g=ud(o,r,t),this.b=ud(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=di){function i(r){r!==void 0&&parseFloat(r)<1&&te("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:te("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);te("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=di){let i=i0[t.toLowerCase()];return i!==void 0?this.setHex(i,e):te("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ts(t.r),this.g=Ts(t.g),this.b=Ts(t.b),this}copyLinearToSRGB(t){return this.r=Eo(t.r),this.g=Eo(t.g),this.b=Eo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=di){return Se.workingToColorSpace(Vn.copy(this),t),Math.round(oe(Vn.r*255,0,255))*65536+Math.round(oe(Vn.g*255,0,255))*256+Math.round(oe(Vn.b*255,0,255))}getHexString(t=di){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(Vn.copy(this),e);let i=Vn.r,s=Vn.g,r=Vn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,d=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=d<=.5?h/(o+a):h/(2-o-a),o){case i:c=(s-r)/h+(s<r?6:0);break;case s:c=(r-i)/h+2;break;case r:c=(i-s)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=d,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(Vn.copy(this),e),t.r=Vn.r,t.g=Vn.g,t.b=Vn.b,t}getStyle(t=di){Se.workingToColorSpace(Vn.copy(this),t);let e=Vn.r,i=Vn.g,s=Vn.b;return t!==di?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Js),this.setHSL(Js.h+t,Js.s+e,Js.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Js),t.getHSL(jl);let i=Ta(Js.h,jl.h,e),s=Ta(Js.s,jl.s,e),r=Ta(Js.l,jl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new ce;ce.NAMES=i0;var Na=class extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Cs,this.environmentIntensity=1,this.environmentRotation=new Cs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Oi=new O,Ms=new O,dd=new O,Ss=new O,fo=new O,po=new O,Xm=new O,fd=new O,pd=new O,md=new O,gd=new nn,_d=new nn,xd=new nn,Bi=class n{constructor(t=new O,e=new O,i=new O){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Oi.subVectors(t,e),s.cross(Oi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Oi.subVectors(s,e),Ms.subVectors(i,e),dd.subVectors(t,e);let o=Oi.dot(Oi),a=Oi.dot(Ms),c=Oi.dot(dd),l=Ms.dot(Ms),d=Ms.dot(dd),h=o*l-a*a;if(h===0)return r.set(0,0,0),null;let u=1/h,f=(l*c-a*d)*u,m=(o*d-a*c)*u;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Ss)===null?!1:Ss.x>=0&&Ss.y>=0&&Ss.x+Ss.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,Ss)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Ss.x),c.addScaledVector(o,Ss.y),c.addScaledVector(a,Ss.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return gd.setScalar(0),_d.setScalar(0),xd.setScalar(0),gd.fromBufferAttribute(t,e),_d.fromBufferAttribute(t,i),xd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(gd,r.x),o.addScaledVector(_d,r.y),o.addScaledVector(xd,r.z),o}static isFrontFacing(t,e,i,s){return Oi.subVectors(i,e),Ms.subVectors(t,e),Oi.cross(Ms).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Oi.subVectors(this.c,this.b),Ms.subVectors(this.a,this.b),Oi.cross(Ms).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;fo.subVectors(s,i),po.subVectors(r,i),fd.subVectors(t,i);let c=fo.dot(fd),l=po.dot(fd);if(c<=0&&l<=0)return e.copy(i);pd.subVectors(t,s);let d=fo.dot(pd),h=po.dot(pd);if(d>=0&&h<=d)return e.copy(s);let u=c*h-d*l;if(u<=0&&c>=0&&d<=0&&c-d>0)return o=c/(c-d),e.copy(i).addScaledVector(fo,o);md.subVectors(t,r);let f=fo.dot(md),m=po.dot(md);if(m>=0&&f<=m)return e.copy(r);let x=f*l-c*m;if(x<=0&&l>=0&&m<=0)return a=l/(l-m),e.copy(i).addScaledVector(po,a);let p=d*m-f*h;if(p<=0&&h-d>=0&&f-m>=0)return Xm.subVectors(r,s),a=(h-d)/(h-d+(f-m)),e.copy(s).addScaledVector(Xm,a);let g=1/(p+x+u);return o=x*g,a=u*g,e.copy(i).addScaledVector(fo,o).addScaledVector(po,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},tr=class{constructor(t=new O(1/0,1/0,1/0),e=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(ki.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(ki.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=ki.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ki):ki.fromBufferAttribute(r,o),ki.applyMatrix4(t.matrixWorld),this.expandByPoint(ki);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ql.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ql.copy(i.boundingBox)),Ql.applyMatrix4(t.matrixWorld),this.union(Ql)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ki),ki.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(va),tc.subVectors(this.max,va),mo.subVectors(t.a,va),go.subVectors(t.b,va),_o.subVectors(t.c,va),Ks.subVectors(go,mo),js.subVectors(_o,go),wr.subVectors(mo,_o);let e=[0,-Ks.z,Ks.y,0,-js.z,js.y,0,-wr.z,wr.y,Ks.z,0,-Ks.x,js.z,0,-js.x,wr.z,0,-wr.x,-Ks.y,Ks.x,0,-js.y,js.x,0,-wr.y,wr.x,0];return!yd(e,mo,go,_o,tc)||(e=[1,0,0,0,1,0,0,0,1],!yd(e,mo,go,_o,tc))?!1:(ec.crossVectors(Ks,js),e=[ec.x,ec.y,ec.z],yd(e,mo,go,_o,tc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ki).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ki).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ws[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ws[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ws[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ws[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ws[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ws[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ws[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ws[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ws),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ws=[new O,new O,new O,new O,new O,new O,new O,new O],ki=new O,Ql=new tr,mo=new O,go=new O,_o=new O,Ks=new O,js=new O,wr=new O,va=new O,tc=new O,ec=new O,Er=new O;function yd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Er.fromArray(n,r);let a=s.x*Math.abs(Er.x)+s.y*Math.abs(Er.y)+s.z*Math.abs(Er.z),c=t.dot(Er),l=e.dot(Er),d=i.dot(Er);if(Math.max(-Math.max(c,l,d),Math.min(c,l,d))>a)return!1}return!0}var _n=new O,nc=new Ot,tb=0,ls=class extends zi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tb++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Jg,this.updateRanges=[],this.gpuType=Wi,this.version=0,this._normalizationScale=t!==void 0?xf(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)nc.fromBufferAttribute(this,e),nc.applyMatrix3(t),this.setXY(e,nc.x,nc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):e0(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):n0(t,this.array)}};var Fa=class extends ls{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Ua=class extends ls{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ye=class extends ls{constructor(t,e,i){super(new Float32Array(t),e,i)}},eb=new tr,ba=new O,vd=new O,Cr=class{constructor(t=new O,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):eb.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ba.subVectors(t,this.center);let e=ba.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ba,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(vd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ba.copy(t.center).add(vd)),this.expandByPoint(ba.copy(t.center).sub(vd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},nb=0,Ei=new Ve,bd=new Un,xo=new O,ui=new tr,Ma=new tr,In=new O,Qe=class n extends zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:nb++}),this.uuid=Ur(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Av(t)?Ua:Fa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ae().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ei.makeRotationFromQuaternion(t),this.applyMatrix4(Ei),this}rotateX(t){return Ei.makeRotationX(t),this.applyMatrix4(Ei),this}rotateY(t){return Ei.makeRotationY(t),this.applyMatrix4(Ei),this}rotateZ(t){return Ei.makeRotationZ(t),this.applyMatrix4(Ei),this}translate(t,e,i){return Ei.makeTranslation(t,e,i),this.applyMatrix4(Ei),this}scale(t,e,i){return Ei.makeScale(t,e,i),this.applyMatrix4(Ei),this}lookAt(t){return bd.lookAt(t),bd.updateMatrix(),this.applyMatrix4(bd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(xo).negate(),this.translate(xo.x,xo.y,xo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ye(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&te("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ui.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,ui.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,ui.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(ui.min),this.boundingBox.expandByPoint(ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Cr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(t){let i=this.boundingSphere.center;if(ui.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ma.setFromBufferAttribute(a),this.morphTargetsRelative?(In.addVectors(ui.min,Ma.min),ui.expandByPoint(In),In.addVectors(ui.max,Ma.max),ui.expandByPoint(In)):(ui.expandByPoint(Ma.min),ui.expandByPoint(Ma.max))}ui.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)In.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(In));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,d=a.count;l<d;l++)In.fromBufferAttribute(a,l),c&&(xo.fromBufferAttribute(t,l),In.add(xo)),s=Math.max(s,i.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ls(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new O,c[k]=new O;let d=new O,h=new O,u=new O,f=new Ot,m=new Ot,x=new Ot,p=new O,g=new O;function y(k,D,N){l[k]=l[D]=l[N]=1,d.fromBufferAttribute(i,k),h.fromBufferAttribute(i,D),u.fromBufferAttribute(i,N),f.fromBufferAttribute(r,k),m.fromBufferAttribute(r,D),x.fromBufferAttribute(r,N),h.sub(d),u.sub(d),m.sub(f),x.sub(f);let G=1/(m.x*x.y-x.x*m.y);isFinite(G)&&(p.copy(h).multiplyScalar(x.y).addScaledVector(u,-m.y).multiplyScalar(G),g.copy(u).multiplyScalar(m.x).addScaledVector(h,-x.x).multiplyScalar(G),a[k].add(p),a[D].add(p),a[N].add(p),c[k].add(g),c[D].add(g),c[N].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let k=0,D=M.length;k<D;++k){let N=M[k],G=N.start,W=N.count;for(let P=G,B=G+W;P<B;P+=3)y(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let b=new O,R=new O,w=new O,_=new O;function T(k){w.fromBufferAttribute(s,k),_.copy(w);let D=a[k];b.copy(D),b.sub(w.multiplyScalar(w.dot(D))).normalize(),R.crossVectors(_,D);let G=R.dot(c[k])<0?-1:1;o.setXYZW(k,b.x,b.y,b.z,G)}for(let k=0,D=i.count;k<D;++k)l[k]&&T(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ls(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,f=i.count;u<f;u++)i.setXYZ(u,0,0,0);let s=new O,r=new O,o=new O,a=new O,c=new O,l=new O,d=new O,h=new O;if(t)for(let u=0,f=t.count;u<f;u+=3){let m=t.getX(u+0),x=t.getX(u+1),p=t.getX(u+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,p),d.subVectors(o,r),h.subVectors(s,r),d.cross(h),a.fromBufferAttribute(i,m),c.fromBufferAttribute(i,x),l.fromBufferAttribute(i,p),a.add(d),c.add(d),l.add(d),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),d.subVectors(o,r),h.subVectors(s,r),d.cross(h),i.setXYZ(u+0,d.x,d.y,d.z),i.setXYZ(u+1,d.x,d.y,d.z),i.setXYZ(u+2,d.x,d.y,d.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)In.fromBufferAttribute(t,e),In.normalize(),t.setXYZ(e,In.x,In.y,In.z)}toNonIndexed(){function t(a,c){let l=a.array,d=a.itemSize,h=a.normalized,u=new l.constructor(c.length*d),f=0,m=0;for(let x=0,p=c.length;x<p;x++){a.isInterleavedBufferAttribute?f=c[x]*a.data.stride+a.offset:f=c[x]*d;for(let g=0;g<d;g++)u[m++]=l[f++]}return new ls(u,d,h)}if(this.index===null)return te("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let d=0,h=l.length;d<h;d++){let u=l[d],f=t(u,i);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],d=[];for(let h=0,u=l.length;h<u;h++){let f=l[h];d.push(f.toJSON(t.data))}d.length>0&&(s[c]=d,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let d=s[l];this.setAttribute(l,d.clone(e))}let r=t.morphAttributes;for(let l in r){let d=[],h=r[l];for(let u=0,f=h.length;u<f;u++)d.push(h[u].clone(e));this.morphAttributes[l]=d}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,d=o.length;l<d;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Md=new O,ib=new O,sb=new ae,Jn=class{constructor(t=new O(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Md.subVectors(i,e).cross(ib.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Md),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||sb.getNormalMatrix(t),s=this.coplanarPoint(Md).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},rb=0,cs=class extends zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:rb++}),this.uuid=Ur(),this.name="",this.type="Material",this.blending=Vo,this.side=hr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=qd,this.blendDst=Yd,this.blendEquation=Dr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=Ao,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Wg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ec,this.stencilZFail=Ec,this.stencilZPass=Ec,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){te(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ce().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Jn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ot().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ot().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Es=new O,Sd=new O,ic=new O,sc=new O,er=class{constructor(t=new O,e=new O(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Es)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Es.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Es.copy(this.origin).addScaledVector(this.direction,e),Es.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Sd.copy(t).add(e).multiplyScalar(.5),ic.copy(e).sub(t).normalize(),sc.copy(this.origin).sub(Sd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ic),a=sc.dot(this.direction),c=-sc.dot(ic),l=sc.lengthSq(),d=Math.abs(1-o*o),h,u,f,m;if(d>0)if(h=o*c-a,u=o*a-c,m=r*d,h>=0)if(u>=-m)if(u<=m){let x=1/d;h*=x,u*=x,f=h*(h+o*u+2*a)+u*(o*h+u+2*c)+l}else u=r,h=Math.max(0,-(o*u+a)),f=-h*h+u*(u+2*c)+l;else u=-r,h=Math.max(0,-(o*u+a)),f=-h*h+u*(u+2*c)+l;else u<=-m?(h=Math.max(0,-(-o*r+a)),u=h>0?-r:Math.min(Math.max(-r,-c),r),f=-h*h+u*(u+2*c)+l):u<=m?(h=0,u=Math.min(Math.max(-r,-c),r),f=u*(u+2*c)+l):(h=Math.max(0,-(o*r+a)),u=h>0?r:Math.min(Math.max(-r,-c),r),f=-h*h+u*(u+2*c)+l);else u=o>0?-r:r,h=Math.max(0,-(o*u+a)),f=-h*h+u*(u+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Sd).addScaledVector(ic,u),f}intersectSphere(t,e){if(t.radius<0)return null;Es.subVectors(t.center,this.origin);let i=Es.dot(this.direction),s=Es.dot(Es)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,d=1/this.direction.y,h=1/this.direction.z,u=this.origin;return l>=0?(i=(t.min.x-u.x)*l,s=(t.max.x-u.x)*l):(i=(t.max.x-u.x)*l,s=(t.min.x-u.x)*l),d>=0?(r=(t.min.y-u.y)*d,o=(t.max.y-u.y)*d):(r=(t.max.y-u.y)*d,o=(t.min.y-u.y)*d),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-u.z)*h,c=(t.max.z-u.z)*h):(a=(t.max.z-u.z)*h,c=(t.min.z-u.z)*h),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Es)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,d=a.z,h=t.x-o.x,u=t.y-o.y,f=t.z-o.z,m=e.x-o.x,x=e.y-o.y,p=e.z-o.z,g=i.x-o.x,y=i.y-o.y,M=i.z-o.z,b=Math.abs(c),R=Math.abs(l),w=Math.abs(d),_,T,k,D,N,G,W,P,B,Y,H,ht;if(b>=R&&b>=w?(k=c,G=h,B=m,ht=g,c>=0?(_=l,T=d,D=u,N=f,W=x,P=p,Y=y,H=M):(_=d,T=l,D=f,N=u,W=p,P=x,Y=M,H=y)):R>=w?(k=l,G=u,B=x,ht=y,l>=0?(_=d,T=c,D=f,N=h,W=p,P=m,Y=M,H=g):(_=c,T=d,D=h,N=f,W=m,P=p,Y=g,H=M)):(k=d,G=f,B=p,ht=M,d>=0?(_=c,T=l,D=h,N=u,W=m,P=x,Y=g,H=y):(_=l,T=c,D=u,N=h,W=x,P=m,Y=y,H=g)),k===0)return null;let U=_/k,J=T/k,$=1/k,st=D-U*G,lt=N-J*G,Z=W-U*B,pt=P-J*B,mt=Y-U*ht,Mt=H-J*ht,tt=mt*pt-Mt*Z,xt=st*Mt-lt*mt,it=Z*lt-pt*st;if(s){if(tt<0||xt<0||it<0)return null}else if((tt<0||xt<0||it<0)&&(tt>0||xt>0||it>0))return null;let rt=tt+xt+it;if(rt===0)return null;let Ft=$*(tt*G+xt*B+it*ht);return(rt>0?Ft<0:Ft>0)?null:this.at(Ft/rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ai=class extends cs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=hh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},qm=new Ve,Tr=new er,rc=new Cr,Ym=new O,oc=new O,ac=new O,lc=new O,wd=new O,cc=new O,Zm=new O,hc=new O,Fe=class extends Un{constructor(t=new Qe,e=new Ai){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){cc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let d=a[c],h=r[c];d!==0&&(wd.fromBufferAttribute(h,t),o?cc.addScaledVector(wd,d):cc.addScaledVector(wd.sub(e),d))}e.add(cc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),rc.copy(i.boundingSphere),rc.applyMatrix4(r),Tr.copy(t.ray).recast(t.near),!(rc.containsPoint(Tr.origin)===!1&&(Tr.intersectSphere(rc,Ym)===null||Tr.origin.distanceToSquared(Ym)>(t.far-t.near)**2))&&(qm.copy(r).invert(),Tr.copy(t.ray).applyMatrix4(qm),!(i.boundingBox!==null&&Tr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Tr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,d=r.attributes.uv1,h=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=u.length;m<x;m++){let p=u[m],g=o[p.materialIndex],y=Math.max(p.start,f.start),M=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let b=y,R=M;b<R;b+=3){let w=a.getX(b),_=a.getX(b+1),T=a.getX(b+2);s=uc(this,g,t,i,l,d,h,w,_,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let p=m,g=x;p<g;p+=3){let y=a.getX(p),M=a.getX(p+1),b=a.getX(p+2);s=uc(this,o,t,i,l,d,h,y,M,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let m=0,x=u.length;m<x;m++){let p=u[m],g=o[p.materialIndex],y=Math.max(p.start,f.start),M=Math.min(c.count,Math.min(p.start+p.count,f.start+f.count));for(let b=y,R=M;b<R;b+=3){let w=b,_=b+1,T=b+2;s=uc(this,g,t,i,l,d,h,w,_,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),x=Math.min(c.count,f.start+f.count);for(let p=m,g=x;p<g;p+=3){let y=p,M=p+1,b=p+2;s=uc(this,o,t,i,l,d,h,y,M,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function ob(n,t,e,i,s,r,o,a){let c;if(t.side===Qn?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===hr,a),c===null)return null;hc.copy(a),hc.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(hc);return l<e.near||l>e.far?null:{distance:l,point:hc.clone(),object:n}}function uc(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,oc),n.getVertexPosition(c,ac),n.getVertexPosition(l,lc);let d=ob(n,t,e,i,oc,ac,lc,Zm);if(d){let h=new O;Bi.getBarycoord(Zm,oc,ac,lc,h),s&&(d.uv=Bi.getInterpolatedAttribute(s,a,c,l,h,new Ot)),r&&(d.uv1=Bi.getInterpolatedAttribute(r,a,c,l,h,new Ot)),o&&(d.normal=Bi.getInterpolatedAttribute(o,a,c,l,h,new O),d.normal.dot(i.direction)>0&&d.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new O,materialIndex:0};Bi.getNormal(oc,ac,lc,u.normal),d.face=u,d.barycoord=h}return d}var Bc=class extends ei{constructor(t=null,e=1,i=1,s,r,o,a,c,l=Ln,d=Ln,h,u){super(null,o,a,c,l,d,s,r,h,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ar=new Cr,ab=new Ot(.5,.5),dc=new O,nr=class{constructor(t=new Jn,e=new Jn,i=new Jn,s=new Jn,r=new Jn,o=new Jn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ti,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],d=r[4],h=r[5],u=r[6],f=r[7],m=r[8],x=r[9],p=r[10],g=r[11],y=r[12],M=r[13],b=r[14],R=r[15];if(s[0].setComponents(l-o,f-d,g-m,R-y).normalize(),s[1].setComponents(l+o,f+d,g+m,R+y).normalize(),s[2].setComponents(l+a,f+h,g+x,R+M).normalize(),s[3].setComponents(l-a,f-h,g-x,R-M).normalize(),i)s[4].setComponents(c,u,p,b).normalize(),s[5].setComponents(l-c,f-u,g-p,R-b).normalize();else if(s[4].setComponents(l-c,f-u,g-p,R-b).normalize(),e===Ti)s[5].setComponents(l+c,f+u,g+p,R+b).normalize();else if(e===Co)s[5].setComponents(c,u,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ar.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ar.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ar)}intersectsSprite(t){Ar.center.set(0,0,0);let e=ab.distanceTo(t.center);return Ar.radius=.7071067811865476+e,Ar.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ar)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(dc.x=s.normal.x>0?t.max.x:t.min.x,dc.y=s.normal.y>0?t.max.y:t.min.y,dc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(dc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Jm=new Ve,zc=class n{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Jm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new nr),i[s].setFromProjectionMatrix(Jm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new nr),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Vi=class extends cs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Vc=new O,Gc=new O,Km=new Ve,Sa=new er,fc=new Cr,Ed=new O,jm=new O,Oa=class extends Un{constructor(t=new Qe,e=new Vi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Vc.fromBufferAttribute(e,s-1),Gc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Vc.distanceTo(Gc);t.setAttribute("lineDistance",new ye(i,1))}else te("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),fc.copy(i.boundingSphere),fc.applyMatrix4(s),fc.radius+=r,t.ray.intersectsSphere(fc)===!1)return;Km.copy(s).invert(),Sa.copy(t.ray).applyMatrix4(Km);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,d=i.index,u=i.attributes.position;if(d!==null){let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let x=f,p=m-1;x<p;x+=l){let g=d.getX(x),y=d.getX(x+1),M=pc(this,t,Sa,c,g,y,x);M&&e.push(M)}if(this.isLineLoop){let x=d.getX(m-1),p=d.getX(f),g=pc(this,t,Sa,c,x,p,m-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let x=f,p=m-1;x<p;x+=l){let g=pc(this,t,Sa,c,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=pc(this,t,Sa,c,m-1,f,m-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function pc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Vc.fromBufferAttribute(a,s),Gc.fromBufferAttribute(a,r),e.distanceSqToSegment(Vc,Gc,Ed,jm)>i)return;Ed.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(Ed);if(!(l<t.near||l>t.far))return{distance:l,point:jm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Qm=new O,tg=new O,ir=class extends Oa{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Qm.fromBufferAttribute(e,s),tg.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Qm.distanceTo(tg);t.setAttribute("lineDistance",new ye(i,1))}else te("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},ka=class extends Oa{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Ba=class extends ei{constructor(t=[],e=Nr,i,s,r,o,a,c,l,d){super(t,e,i,s,r,o,a,c,l,d),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Rs=class extends ei{constructor(t,e,i=Hi,s,r,o,a=Ln,c=Ln,l,d=As,h=1){if(d!==As&&d!==Ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:h};super(u,s,r,o,a,c,d,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Io(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},za=class extends Rs{constructor(t,e=Hi,i=Nr,s,r,o=Ln,a=Ln,c,l=As){let d={width:t,height:t,depth:1},h=[d,d,d,d,d,d];super(t,t,e,i,s,r,o,a,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Va=class extends ei{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},sr=class n extends Qe{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],d=[],h=[],u=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new ye(l,3)),this.setAttribute("normal",new ye(d,3)),this.setAttribute("uv",new ye(h,2));function m(x,p,g,y,M,b,R,w,_,T,k){let D=b/_,N=R/T,G=b/2,W=R/2,P=w/2,B=_+1,Y=T+1,H=0,ht=0,U=new O;for(let J=0;J<Y;J++){let $=J*N-W;for(let st=0;st<B;st++){let lt=st*D-G;U[x]=lt*y,U[p]=$*M,U[g]=P,l.push(U.x,U.y,U.z),U[x]=0,U[p]=0,U[g]=w>0?1:-1,d.push(U.x,U.y,U.z),h.push(st/_),h.push(1-J/T),H+=1}}for(let J=0;J<T;J++)for(let $=0;$<_;$++){let st=u+$+B*J,lt=u+$+B*(J+1),Z=u+($+1)+B*(J+1),pt=u+($+1)+B*J;c.push(st,lt,pt),c.push(lt,Z,pt),ht+=6}a.addGroup(f,ht,k),f+=ht,u+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Rr=class n extends Qe{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let d=[],h=[],u=[],f=[],m=0,x=[],p=i/2,g=0;y(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(d),this.setAttribute("position",new ye(h,3)),this.setAttribute("normal",new ye(u,3)),this.setAttribute("uv",new ye(f,2));function y(){let b=new O,R=new O,w=0,_=(e-t)/i;for(let T=0;T<=r;T++){let k=[],D=T/r,N=D*(e-t)+t;for(let G=0;G<=s;G++){let W=G/s,P=W*c+a,B=Math.sin(P),Y=Math.cos(P);R.x=N*B,R.y=-D*i+p,R.z=N*Y,h.push(R.x,R.y,R.z),b.set(B,_,Y).normalize(),u.push(b.x,b.y,b.z),f.push(W,1-D),k.push(m++)}x.push(k)}for(let T=0;T<s;T++)for(let k=0;k<r;k++){let D=x[k][T],N=x[k+1][T],G=x[k+1][T+1],W=x[k][T+1];(t>0||k!==0)&&(d.push(D,N,W),w+=3),(e>0||k!==r-1)&&(d.push(N,G,W),w+=3)}l.addGroup(g,w,0),g+=w}function M(b){let R=m,w=new Ot,_=new O,T=0,k=b===!0?t:e,D=b===!0?1:-1;for(let G=1;G<=s;G++)h.push(0,p*D,0),u.push(0,D,0),f.push(.5,.5),m++;let N=m;for(let G=0;G<=s;G++){let P=G/s*c+a,B=Math.cos(P),Y=Math.sin(P);_.x=k*Y,_.y=p*D,_.z=k*B,h.push(_.x,_.y,_.z),u.push(0,D,0),w.x=B*.5+.5,w.y=Y*.5*D+.5,f.push(w.x,w.y),m++}for(let G=0;G<s;G++){let W=R+G,P=N+G;b===!0?d.push(P,P+1,W):d.push(P+1,P,W),T+=3}l.addGroup(g,T,b===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var mc=new O,gc=new O,Td=new O,_c=new Bi,Ga=class extends Qe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(wo*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],d=["a","b","c"],h=new Array(3),u=new Map,f=[];for(let m=0;m<c;m+=3){o?(l[0]=o.getX(m),l[1]=o.getX(m+1),l[2]=o.getX(m+2)):(l[0]=m,l[1]=m+1,l[2]=m+2);let{a:x,b:p,c:g}=_c;if(x.fromBufferAttribute(a,l[0]),p.fromBufferAttribute(a,l[1]),g.fromBufferAttribute(a,l[2]),_c.getNormal(Td),h[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,h[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,h[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){let M=(y+1)%3,b=h[y],R=h[M],w=_c[d[y]],_=_c[d[M]],T=`${b}_${R}`,k=`${R}_${b}`,D=u.get(k);D?(Td.dot(D.normal)<=r&&(f.push(w.x,w.y,w.z),f.push(_.x,_.y,_.z)),u.set(k,null)):u.has(T)||u.set(T,{index0:l[y],index1:l[M],normal:Td.clone()})}}for(let m of u.values())if(m){let{index0:x,index1:p}=m;mc.fromBufferAttribute(a,x),gc.fromBufferAttribute(a,p),f.push(mc.x,mc.y,mc.z),f.push(gc.x,gc.y,gc.z)}this.setAttribute("position",new ye(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},mi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){te("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)i=this.getPoint(o/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,o;e?o=e:o=t*i[r-1];let a=0,c=r-1,l;for(;a<=c;)if(s=Math.floor(a+(c-a)/2),l=i[s]-o,l<0)a=s+1;else if(l>0)c=s-1;else{c=s;break}if(s=c,i[s]===o)return s/(r-1);let d=i[s],u=i[s+1]-d,f=(o-d)/u;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),c=e||(o.isVector2?new Ot:new O);return c.copy(a).sub(o).normalize(),c}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new O,s=[],r=[],o=[],a=new O,c=new Ve;for(let f=0;f<=t;f++){let m=f/t;s[f]=this.getTangentAt(m,new O)}r[0]=new O,o[0]=new O;let l=Number.MAX_VALUE,d=Math.abs(s[0].x),h=Math.abs(s[0].y),u=Math.abs(s[0].z);d<=l&&(l=d,i.set(1,0,0)),h<=l&&(l=h,i.set(0,1,0)),u<=l&&i.set(0,0,1),a.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(oe(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(c.makeRotationAxis(a,m))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(oe(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let m=1;m<=t;m++)r[m].applyMatrix4(c.makeRotationAxis(s[m],f*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},No=class extends mi{constructor(t=0,e=0,i=1,s=1,r=0,o=Math.PI*2,a=!1,c=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=c}getPoint(t,e=new Ot){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,c=this.aX+this.xRadius*Math.cos(a),l=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let d=Math.cos(this.aRotation),h=Math.sin(this.aRotation),u=c-this.aX,f=l-this.aY;c=u*d-f*h+this.aX,l=u*h+f*d+this.aY}return i.set(c,l)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Hc=class extends No{constructor(t,e,i,s,r,o){super(t,e,i,i,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function vf(){let n=0,t=0,e=0,i=0;function s(r,o,a,c){n=r,t=a,e=-3*r+3*o-2*a-c,i=2*r-2*o+a+c}return{initCatmullRom:function(r,o,a,c,l){s(o,a,l*(a-r),l*(c-o))},initNonuniformCatmullRom:function(r,o,a,c,l,d,h){let u=(o-r)/l-(a-r)/(l+d)+(a-o)/d,f=(a-o)/d-(c-o)/(d+h)+(c-a)/h;u*=d,f*=d,s(o,a,u,f)},calc:function(r){let o=r*r,a=o*r;return n+t*r+e*o+i*a}}}var eg=new O,ng=new O,Ad=new vf,Cd=new vf,Rd=new vf,Wc=class extends mi{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new O){let i=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),c=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:c===0&&a===r-1&&(a=r-2,c=1);let l,d;this.closed||a>0?l=s[(a-1)%r]:(ng.subVectors(s[0],s[1]).add(s[0]),l=ng);let h=s[a%r],u=s[(a+1)%r];if(this.closed||a+2<r?d=s[(a+2)%r]:(eg.subVectors(s[r-1],s[r-2]).add(s[r-1]),d=eg),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,m=Math.pow(l.distanceToSquared(h),f),x=Math.pow(h.distanceToSquared(u),f),p=Math.pow(u.distanceToSquared(d),f);x<1e-4&&(x=1),m<1e-4&&(m=x),p<1e-4&&(p=x),Ad.initNonuniformCatmullRom(l.x,h.x,u.x,d.x,m,x,p),Cd.initNonuniformCatmullRom(l.y,h.y,u.y,d.y,m,x,p),Rd.initNonuniformCatmullRom(l.z,h.z,u.z,d.z,m,x,p)}else this.curveType==="catmullrom"&&(Ad.initCatmullRom(l.x,h.x,u.x,d.x,this.tension),Cd.initCatmullRom(l.y,h.y,u.y,d.y,this.tension),Rd.initCatmullRom(l.z,h.z,u.z,d.z,this.tension));return i.set(Ad.calc(c),Cd.calc(c),Rd.calc(c)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new O().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function ig(n,t,e,i,s){let r=(i-t)*.5,o=(s-e)*.5,a=n*n,c=n*a;return(2*e-2*i+r+o)*c+(-3*e+3*i-2*r-o)*a+r*n+e}function lb(n,t){let e=1-n;return e*e*t}function cb(n,t){return 2*(1-n)*n*t}function hb(n,t){return n*n*t}function Aa(n,t,e,i){return lb(n,t)+cb(n,e)+hb(n,i)}function ub(n,t){let e=1-n;return e*e*e*t}function db(n,t){let e=1-n;return 3*e*e*n*t}function fb(n,t){return 3*(1-n)*n*n*t}function pb(n,t){return n*n*n*t}function Ca(n,t,e,i,s){return ub(n,t)+db(n,e)+fb(n,i)+pb(n,s)}var Ha=class extends mi{constructor(t=new Ot,e=new Ot,i=new Ot,s=new Ot){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new Ot){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(Ca(t,s.x,r.x,o.x,a.x),Ca(t,s.y,r.y,o.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},$c=class extends mi{constructor(t=new O,e=new O,i=new O,s=new O){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new O){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(Ca(t,s.x,r.x,o.x,a.x),Ca(t,s.y,r.y,o.y,a.y),Ca(t,s.z,r.z,o.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Wa=class extends mi{constructor(t=new Ot,e=new Ot){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Ot){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Ot){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Xc=class extends mi{constructor(t=new O,e=new O){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new O){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new O){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},$a=class extends mi{constructor(t=new Ot,e=new Ot,i=new Ot){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new Ot){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(Aa(t,s.x,r.x,o.x),Aa(t,s.y,r.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},qc=class extends mi{constructor(t=new O,e=new O,i=new O){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new O){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(Aa(t,s.x,r.x,o.x),Aa(t,s.y,r.y,o.y),Aa(t,s.z,r.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Xa=class extends mi{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Ot){let i=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,c=s[o===0?o:o-1],l=s[o],d=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return i.set(ig(a,c.x,l.x,d.x,h.x),ig(a,c.y,l.y,d.y,h.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new Ot().fromArray(s))}return this}},sg=Object.freeze({__proto__:null,ArcCurve:Hc,CatmullRomCurve3:Wc,CubicBezierCurve:Ha,CubicBezierCurve3:$c,EllipseCurve:No,LineCurve:Wa,LineCurve3:Xc,QuadraticBezierCurve:$a,QuadraticBezierCurve3:qc,SplineCurve:Xa}),Yc=class extends mi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let i=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new sg[i](e,t))}return this}getPoint(t,e){let i=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=i){let o=s[r]-i,a=this.curves[r],c=a.getLength(),l=c===0?0:1-o/c;return a.getPointAt(l,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let i=0,s=this.curves.length;i<s;i++)e+=this.curves[i].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],i;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,c=o.getPoints(a);for(let l=0;l<c.length;l++){let d=c[l];i&&i.equals(d)||(e.push(d),i=d)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,i=this.curves.length;e<i;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(new sg[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},qa=class extends Yc{constructor(t){super(),this.type="Path",this.currentPoint=new Ot,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,i=t.length;e<i;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let i=new Wa(this.currentPoint.clone(),new Ot(t,e));return this.curves.push(i),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,i,s){let r=new $a(this.currentPoint.clone(),new Ot(t,e),new Ot(i,s));return this.curves.push(r),this.currentPoint.set(i,s),this}bezierCurveTo(t,e,i,s,r,o){let a=new Ha(this.currentPoint.clone(),new Ot(t,e),new Ot(i,s),new Ot(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),i=new Xa(e);return this.curves.push(i),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,i,s,r,o){let a=this.currentPoint.x,c=this.currentPoint.y;return this.absarc(t+a,e+c,i,s,r,o),this}absarc(t,e,i,s,r,o){return this.absellipse(t,e,i,i,s,r,o),this}ellipse(t,e,i,s,r,o,a,c){let l=this.currentPoint.x,d=this.currentPoint.y;return this.absellipse(t+l,e+d,i,s,r,o,a,c),this}absellipse(t,e,i,s,r,o,a,c){let l=new No(t,e,i,s,r,o,a,c);if(this.curves.length>0){let h=l.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(l);let d=l.getPoint(1);return this.currentPoint.copy(d),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},Fo=class extends qa{constructor(t){super(t),this.uuid=Ur(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let i=0,s=this.holes.length;i<s;i++)e[i]=this.holes[i].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,i=this.holes.length;e<i;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(new qa().fromJSON(s))}return this}};function mb(n,t,e=2){let i=t&&t.length,s=i?t[0]*e:n.length,r=s0(n,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,c,l;if(i&&(r=vb(n,t,r,e)),n.length>80*e){a=n[0],c=n[1];let d=a,h=c;for(let u=e;u<s;u+=e){let f=n[u],m=n[u+1];f<a&&(a=f),m<c&&(c=m),f>d&&(d=f),m>h&&(h=m)}l=Math.max(d-a,h-c),l=l!==0?32767/l:0}return Ya(r,o,e,a,c,l,0),o}function s0(n,t,e,i,s){let r;if(s===Ib(n,t,e,i)>0)for(let o=t;o<e;o+=i)r=rg(o/i|0,n[o],n[o+1],r);else for(let o=e-i;o>=t;o-=i)r=rg(o/i|0,n[o],n[o+1],r);return r&&Uo(r,r.next)&&(Ja(r),r=r.next),r}function Pr(n,t){if(!n)return n;t||(t=n);let e=n,i;do if(i=!1,!e.steiner&&(Uo(e,e.next)||rn(e.prev,e,e.next)===0)){if(Ja(e),e=t=e.prev,e===e.next)break;i=!0}else e=e.next;while(i||e!==t);return t}function Ya(n,t,e,i,s,r,o){if(!n)return;!o&&r&&Eb(n,i,s,r);let a=n;for(;n.prev!==n.next;){let c=n.prev,l=n.next;if(r?_b(n,i,s,r):gb(n)){t.push(c.i,n.i,l.i),Ja(n),n=l.next,a=l.next;continue}if(n=l,n===a){o?o===1?(n=xb(Pr(n),t),Ya(n,t,e,i,s,r,2)):o===2&&yb(n,t,e,i,s,r):Ya(Pr(n),t,e,i,s,r,1);break}}}function gb(n){let t=n.prev,e=n,i=n.next;if(rn(t,e,i)>=0)return!1;let s=t.x,r=e.x,o=i.x,a=t.y,c=e.y,l=i.y,d=Math.min(s,r,o),h=Math.min(a,c,l),u=Math.max(s,r,o),f=Math.max(a,c,l),m=i.next;for(;m!==t;){if(m.x>=d&&m.x<=u&&m.y>=h&&m.y<=f&&wa(s,a,r,c,o,l,m.x,m.y)&&rn(m.prev,m,m.next)>=0)return!1;m=m.next}return!0}function _b(n,t,e,i){let s=n.prev,r=n,o=n.next;if(rn(s,r,o)>=0)return!1;let a=s.x,c=r.x,l=o.x,d=s.y,h=r.y,u=o.y,f=Math.min(a,c,l),m=Math.min(d,h,u),x=Math.max(a,c,l),p=Math.max(d,h,u),g=Ud(f,m,t,e,i),y=Ud(x,p,t,e,i),M=n.prevZ,b=n.nextZ;for(;M&&M.z>=g&&b&&b.z<=y;){if(M.x>=f&&M.x<=x&&M.y>=m&&M.y<=p&&M!==s&&M!==o&&wa(a,d,c,h,l,u,M.x,M.y)&&rn(M.prev,M,M.next)>=0||(M=M.prevZ,b.x>=f&&b.x<=x&&b.y>=m&&b.y<=p&&b!==s&&b!==o&&wa(a,d,c,h,l,u,b.x,b.y)&&rn(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;M&&M.z>=g;){if(M.x>=f&&M.x<=x&&M.y>=m&&M.y<=p&&M!==s&&M!==o&&wa(a,d,c,h,l,u,M.x,M.y)&&rn(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;b&&b.z<=y;){if(b.x>=f&&b.x<=x&&b.y>=m&&b.y<=p&&b!==s&&b!==o&&wa(a,d,c,h,l,u,b.x,b.y)&&rn(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function xb(n,t){let e=n;do{let i=e.prev,s=e.next.next;!Uo(i,s)&&o0(i,e,e.next,s)&&Za(i,s)&&Za(s,i)&&(t.push(i.i,e.i,s.i),Ja(e),Ja(e.next),e=n=s),e=e.next}while(e!==n);return Pr(e)}function yb(n,t,e,i,s,r){let o=n;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Cb(o,a)){let c=a0(o,a);o=Pr(o,o.next),c=Pr(c,c.next),Ya(o,t,e,i,s,r,0),Ya(c,t,e,i,s,r,0);return}a=a.next}o=o.next}while(o!==n)}function vb(n,t,e,i){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*i,c=r<o-1?t[r+1]*i:n.length,l=s0(n,a,c,i,!1);l===l.next&&(l.steiner=!0),s.push(Ab(l))}s.sort(bb);for(let r=0;r<s.length;r++)e=Mb(s[r],e);return e}function bb(n,t){let e=n.x-t.x;if(e===0&&(e=n.y-t.y,e===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=i-s}return e}function Mb(n,t){let e=Sb(n,t);if(!e)return t;let i=a0(e,n);return Pr(i,i.next),Pr(e,e.next)}function Sb(n,t){let e=t,i=n.x,s=n.y,r=-1/0,o;if(Uo(n,e))return e;do{if(Uo(n,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let h=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(h<=i&&h>r&&(r=h,o=e.x<e.next.x?e:e.next,h===i))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,c=o.x,l=o.y,d=1/0;e=o;do{if(i>=e.x&&e.x>=c&&i!==e.x&&r0(s<l?i:r,s,c,l,s<l?r:i,s,e.x,e.y)){let h=Math.abs(s-e.y)/(i-e.x);Za(e,n)&&(h<d||h===d&&(e.x>o.x||e.x===o.x&&wb(o,e)))&&(o=e,d=h)}e=e.next}while(e!==a);return o}function wb(n,t){return rn(n.prev,n,t.prev)<0&&rn(t.next,n,n.next)<0}function Eb(n,t,e,i){let s=n;do s.z===0&&(s.z=Ud(s.x,s.y,t,e,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,Tb(s)}function Tb(n){let t,e=1;do{let i=n,s;n=null;let r=null;for(t=0;i;){t++;let o=i,a=0;for(let l=0;l<e&&(a++,o=o.nextZ,!!o);l++);let c=e;for(;a>0||c>0&&o;)a!==0&&(c===0||!o||i.z<=o.z)?(s=i,i=i.nextZ,a--):(s=o,o=o.nextZ,c--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;i=o}r.nextZ=null,e*=2}while(t>1);return n}function Ud(n,t,e,i,s){return n=(n-e)*s|0,t=(t-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,n|t<<1}function Ab(n){let t=n,e=n;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==n);return e}function r0(n,t,e,i,s,r,o,a){return(s-o)*(t-a)>=(n-o)*(r-a)&&(n-o)*(i-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(i-a)}function wa(n,t,e,i,s,r,o,a){return!(n===o&&t===a)&&r0(n,t,e,i,s,r,o,a)}function Cb(n,t){return n.next.i!==t.i&&n.prev.i!==t.i&&!Rb(n,t)&&(Za(n,t)&&Za(t,n)&&Pb(n,t)&&(rn(n.prev,n,t.prev)||rn(n,t.prev,t))||Uo(n,t)&&rn(n.prev,n,n.next)>0&&rn(t.prev,t,t.next)>0)}function rn(n,t,e){return(t.y-n.y)*(e.x-t.x)-(t.x-n.x)*(e.y-t.y)}function Uo(n,t){return n.x===t.x&&n.y===t.y}function o0(n,t,e,i){let s=yc(rn(n,t,e)),r=yc(rn(n,t,i)),o=yc(rn(e,i,n)),a=yc(rn(e,i,t));return!!(s!==r&&o!==a||s===0&&xc(n,e,t)||r===0&&xc(n,i,t)||o===0&&xc(e,n,i)||a===0&&xc(e,t,i))}function xc(n,t,e){return t.x<=Math.max(n.x,e.x)&&t.x>=Math.min(n.x,e.x)&&t.y<=Math.max(n.y,e.y)&&t.y>=Math.min(n.y,e.y)}function yc(n){return n>0?1:n<0?-1:0}function Rb(n,t){let e=n;do{if(e.i!==n.i&&e.next.i!==n.i&&e.i!==t.i&&e.next.i!==t.i&&o0(e,e.next,n,t))return!0;e=e.next}while(e!==n);return!1}function Za(n,t){return rn(n.prev,n,n.next)<0?rn(n,t,n.next)>=0&&rn(n,n.prev,t)>=0:rn(n,t,n.prev)<0||rn(n,n.next,t)<0}function Pb(n,t){let e=n,i=!1,s=(n.x+t.x)/2,r=(n.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(i=!i),e=e.next;while(e!==n);return i}function a0(n,t){let e=Od(n.i,n.x,n.y),i=Od(t.i,t.x,t.y),s=n.next,r=t.prev;return n.next=t,t.prev=n,e.next=s,s.prev=e,i.next=e,e.prev=i,r.next=i,i.prev=r,i}function rg(n,t,e,i){let s=Od(n,t,e);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function Ja(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function Od(n,t,e){return{i:n,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Ib(n,t,e,i){let s=0;for(let r=t,o=e-i;r<e;r+=i)s+=(n[o]-n[r])*(n[r+1]+n[o+1]),o=r;return s}var kd=class{static triangulate(t,e,i=2){return mb(t,e,i)}},To=class n{static area(t){let e=t.length,i=0;for(let s=e-1,r=0;r<e;s=r++)i+=t[s].x*t[r].y-t[r].x*t[s].y;return i*.5}static isClockWise(t){return n.area(t)<0}static triangulateShape(t,e){let i=[],s=[],r=[];og(t),ag(i,t);let o=t.length;e.forEach(og);for(let c=0;c<e.length;c++)s.push(o),o+=e[c].length,ag(i,e[c]);let a=kd.triangulate(i,s);for(let c=0;c<a.length;c+=3)r.push(a.slice(c,c+3));return r}};function og(n){let t=n.length;t>2&&n[t-1].equals(n[0])&&n.pop()}function ag(n,t){for(let e=0;e<t.length;e++)n.push(t[e].x),n.push(t[e].y)}var Ir=class n extends Qe{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,d=c+1,h=t/a,u=e/c,f=[],m=[],x=[],p=[];for(let g=0;g<d;g++){let y=g*u-o;for(let M=0;M<l;M++){let b=M*h-r;m.push(b,-y,0),x.push(0,0,1),p.push(M/a),p.push(1-g/c)}}for(let g=0;g<c;g++)for(let y=0;y<a;y++){let M=y+l*g,b=y+l*(g+1),R=y+1+l*(g+1),w=y+1+l*g;f.push(M,b,w),f.push(b,R,w)}this.setIndex(f),this.setAttribute("position",new ye(m,3)),this.setAttribute("normal",new ye(x,3)),this.setAttribute("uv",new ye(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}},Oo=class n extends Qe{constructor(t=.5,e=1,i=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:i,phiSegments:s,thetaStart:r,thetaLength:o},i=Math.max(3,i),s=Math.max(1,s);let a=[],c=[],l=[],d=[],h=t,u=(e-t)/s,f=new O,m=new Ot;for(let x=0;x<=s;x++){for(let p=0;p<=i;p++){let g=r+p/i*o;f.x=h*Math.cos(g),f.y=h*Math.sin(g),c.push(f.x,f.y,f.z),l.push(0,0,1),m.x=(f.x/e+1)/2,m.y=(f.y/e+1)/2,d.push(m.x,m.y)}h+=u}for(let x=0;x<s;x++){let p=x*(i+1);for(let g=0;g<i;g++){let y=g+p,M=y,b=y+i+1,R=y+i+2,w=y+1;a.push(M,b,w),a.push(b,R,w)}}this.setIndex(a),this.setAttribute("position",new ye(c,3)),this.setAttribute("normal",new ye(l,3)),this.setAttribute("uv",new ye(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}},Ka=class n extends Qe{constructor(t=new Fo([new Ot(0,.5),new Ot(-.5,-.5),new Ot(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};let i=[],s=[],r=[],o=[],a=0,c=0;if(Array.isArray(t)===!1)l(t);else for(let d=0;d<t.length;d++)l(t[d]),this.addGroup(a,c,d),a+=c,c=0;this.setIndex(i),this.setAttribute("position",new ye(s,3)),this.setAttribute("normal",new ye(r,3)),this.setAttribute("uv",new ye(o,2));function l(d){let h=s.length/3,u=d.extractPoints(e),f=u.shape,m=u.holes;To.isClockWise(f)===!1&&(f=f.reverse());for(let p=0,g=m.length;p<g;p++){let y=m[p];To.isClockWise(y)===!0&&(m[p]=y.reverse())}let x=To.triangulateShape(f,m);for(let p=0,g=m.length;p<g;p++){let y=m[p];f=f.concat(y)}for(let p=0,g=f.length;p<g;p++){let y=f[p];s.push(y.x,y.y,0),r.push(0,0,1),o.push(y.x,y.y)}for(let p=0,g=x.length;p<g;p++){let y=x[p],M=y[0]+h,b=y[1]+h,R=y[2]+h;i.push(M,b,R),c+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes;return Lb(e,t)}static fromJSON(t,e){let i=[];for(let s=0,r=t.shapes.length;s<r;s++){let o=e[t.shapes[s]];i.push(o)}return new n(i,t.curveSegments)}};function Lb(n,t){if(t.shapes=[],Array.isArray(n))for(let e=0,i=n.length;e<i;e++){let s=n[e];t.shapes.push(s.uuid)}else t.shapes.push(n.uuid);return t}var Ps=class n extends Qe{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,d=[],h=new O,u=new O,f=[],m=[],x=[],p=[];for(let g=0;g<=i;g++){let y=[],M=g/i,b=o+M*a,R=t*Math.cos(b),w=Math.sqrt(t*t-R*R),_=0;g===0&&o===0?_=.5/e:g===i&&c===Math.PI&&(_=-.5/e);for(let T=0;T<=e;T++){let k=T/e,D=s+k*r;h.x=-w*Math.cos(D),h.y=R,h.z=w*Math.sin(D),m.push(h.x,h.y,h.z),u.copy(h).normalize(),x.push(u.x,u.y,u.z),p.push(k+_,1-M),y.push(l++)}d.push(y)}for(let g=0;g<i;g++)for(let y=0;y<e;y++){let M=d[g][y+1],b=d[g][y],R=d[g+1][y],w=d[g+1][y+1];(g!==0||o>0)&&f.push(M,b,w),(g!==i-1||c<Math.PI)&&f.push(b,R,w)}this.setIndex(f),this.setAttribute("position",new ye(m,3)),this.setAttribute("normal",new ye(x,3)),this.setAttribute("uv",new ye(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ja=class extends cs{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new ce(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Or(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(lg(s))s.isRenderTargetTexture?(te("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(lg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Gn(n){let t={};for(let e=0;e<n.length;e++){let i=Or(n[e]);for(let s in i)t[s]=i[s]}return t}function lg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Db(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function bf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var l0={clone:Or,merge:Gn},Nb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Fb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,hs=class extends cs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Nb,this.fragmentShader=Fb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Or(t.uniforms),this.uniformsGroups=Db(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ce().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ot().fromArray(s.value);break;case"v3":this.uniforms[i].value=new O().fromArray(s.value);break;case"v4":this.uniforms[i].value=new nn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ae().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ve().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Zc=class extends hs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Gi=class extends cs{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Jh,this.normalScale=new Ot(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=hh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Jc=class extends cs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Gg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Kc=class extends cs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function yo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function vc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var rr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},jc=class extends rr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Dd,endingEnd:Dd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nd:r=t,a=2*e-i;break;case Fd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case Nd:o=t,c=2*i-e;break;case Fd:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,d=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*d,this._offsetNext=o*d}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,d=this._offsetPrev,h=this._offsetNext,u=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),x=m*m,p=x*m,g=-u*p+2*u*x-u*m,y=(1+u)*p+(-1.5-2*u)*x+(-.5+u)*m+1,M=(-1-f)*p+(1.5+f)*x+.5*m,b=f*p-f*x;for(let R=0;R!==a;++R)r[R]=g*o[d+R]+y*o[l+R]+M*o[c+R]+b*o[h+R];return r}},Qc=class extends rr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,d=(i-e)/(s-e),h=1-d;for(let u=0;u!==a;++u)r[u]=o[l+u]*h+o[c+u]*d;return r}},th=class extends rr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},eh=class extends rr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,d=this.inTangents,h=this.outTangents;if(!d||!h){let m=(i-e)/(s-e),x=1-m;for(let p=0;p!==a;++p)r[p]=o[l+p]*x+o[c+p]*m;return r}let u=a*2,f=t-1;for(let m=0;m!==a;++m){let x=o[l+m],p=o[c+m],g=f*u+m*2,y=h[g],M=h[g+1],b=t*u+m*2,R=d[b],w=d[b+1],_=Ob(i,e,y,R,s);r[m]=c0(_,x,M,w,p)}return r}};function c0(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Ub(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Ob(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=c0(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=Ub(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var gi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=yo(e,this.TimeBufferType),this.values=yo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:yo(t.times,Array),values:yo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),vc(t.settings)&&(i.settings={inTangents:yo(t.settings.inTangents,Array),outTangents:yo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new th(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Qc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new jc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new eh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ra:e=this.InterpolantFactoryMethodDiscrete;break;case Fc:e=this.InterpolantFactoryMethodLinear;break;case wc:e=this.InterpolantFactoryMethodSmooth;break;case Ld:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return te("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ra;case this.InterpolantFactoryMethodLinear:return Fc;case this.InterpolantFactoryMethodSmooth:return wc;case this.InterpolantFactoryMethodBezier:return Ld}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;vc(this.settings)&&(cg(this.settings.inTangents,t),cg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;vc(this.settings)&&(hg(this.settings.inTangents,t),hg(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){se("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){se("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&Cv(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){se("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===wc,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],d=t[a+1];if(l!==d&&(a!==1||l!==t[0]))if(s)c=!0;else{let h=a*i,u=h-i,f=h+i;for(let m=0;m!==i;++m){let x=e[h+m];if(x!==e[u+m]||x!==e[f+m]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*i,u=o*i;for(let f=0;f!==i;++f)e[u+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,vc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function cg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function hg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=Fc;var or=class extends gi{constructor(t,e,i){super(t,e,i)}};or.prototype.ValueTypeName="bool";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Ra;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var nh=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};nh.prototype.ValueTypeName="color";var ih=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};ih.prototype.ValueTypeName="number";var sh=class extends rr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let d=l+a;l!==d;l+=4)Fn.slerpFlat(r,0,o,l-a,o,l,c);return r}},Qa=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new sh(this.times,this.values,this.getValueSize(),t)}};Qa.prototype.ValueTypeName="quaternion";Qa.prototype.InterpolantFactoryMethodSmooth=void 0;var ar=class extends gi{constructor(t,e,i){super(t,e,i)}};ar.prototype.ValueTypeName="string";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Ra;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var rh=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};rh.prototype.ValueTypeName="vector";var oh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(d){a++,r===!1&&s.onStart!==void 0&&s.onStart(d,o,a),r=!0},this.itemEnd=function(d){o++,s.onProgress!==void 0&&s.onProgress(d,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(d){s.onError!==void 0&&s.onError(d)},this.resolveURL=function(d){return d=d.normalize("NFC"),c?c(d):d},this.setURLModifier=function(d){return c=d,this},this.addHandler=function(d,h){return l.push(d,h),this},this.removeHandler=function(d){let h=l.indexOf(d);return h!==-1&&l.splice(h,2),this},this.getHandler=function(d){for(let h=0,u=l.length;h<u;h+=2){let f=l[h],m=l[h+1];if(f.global&&(f.lastIndex=0),f.test(d))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},h0=new oh,ah=class{constructor(t){this.manager=t!==void 0?t:h0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};ah.DEFAULT_MATERIAL_NAME="__DEFAULT";var tl=class extends Un{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},el=class extends tl{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ce(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Pd=new Ve,ug=new O,dg=new O,lh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ot(512,512),this.mapType=ni,this.map=null,this.mapPass=null,this.matrix=new Ve,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new nr,this._frameExtents=new Ot(1,1),this._viewportCount=1,this._viewports=[new nn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;ug.setFromMatrixPosition(t.matrixWorld),e.position.copy(ug),dg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(dg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Pd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Pd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Co||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(Pd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},bc=new O,Mc=new Fn,os=new O,nl=class extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ve,this.projectionMatrix=new Ve,this.projectionMatrixInverse=new Ve,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(bc,Mc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(bc,Mc,os.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(bc,Mc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(bc,Mc,os.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Qs=new O,fg=new Ot,pg=new Ot,Kn=class extends nl{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Po*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(wo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Po*2*Math.atan(Math.tan(wo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Qs.x,Qs.y).multiplyScalar(-t/Qs.z),Qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Qs.x,Qs.y).multiplyScalar(-t/Qs.z)}getViewSize(t,e){return this.getViewBounds(t,fg,pg),e.subVectors(pg,fg)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(wo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var il=class extends nl{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,d=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=d*this.view.offsetY,c=a-d*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Bd=class extends lh{constructor(){super(new il(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},sl=class extends tl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.target=new Un,this.shadow=new Bd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var vo=-90,bo=1,ko=class extends Un{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(vo,bo,t,e);s.layers=this.layers,this.add(s);let r=new Kn(vo,bo,t,e);r.layers=this.layers,this.add(r);let o=new Kn(vo,bo,t,e);o.layers=this.layers,this.add(o);let a=new Kn(vo,bo,t,e);a.layers=this.layers,this.add(a);let c=new Kn(vo,bo,t,e);c.layers=this.layers,this.add(c);let l=new Kn(vo,bo,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===Ti)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Co)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,d]=this.children,h=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,d),t.setRenderTarget(h,u,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},ch=class extends Kn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Mf="\\[\\]\\.:\\/",kb=new RegExp("["+Mf+"]","g"),Sf="[^"+Mf+"]",Bb="[^"+Mf.replace("\\.","")+"]",zb=/((?:WC+[\/:])*)/.source.replace("WC",Sf),Vb=/(WCOD+)?/.source.replace("WCOD",Bb),Gb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Sf),Hb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Sf),Wb=new RegExp("^"+zb+Vb+Gb+Hb+"$"),$b=["material","materials","bones","map"],zd=class{constructor(t,e,i){let s=i||je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},je=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(kb,"")}static parseTrackName(t){let e=Wb.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);$b.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){te("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let d=0;d<t.length;d++)if(t[d].name===l){l=d;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;se("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};je.Composite=zd;je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};je.prototype.GetterByBindingType=[je.prototype._getValue_direct,je.prototype._getValue_array,je.prototype._getValue_arrayElement,je.prototype._getValue_toArray];je.prototype.SetterByBindingTypeAndVersioning=[[je.prototype._setValue_direct,je.prototype._setValue_direct_setNeedsUpdate,je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[je.prototype._setValue_array,je.prototype._setValue_array_setNeedsUpdate,je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[je.prototype._setValue_arrayElement,je.prototype._setValue_arrayElement_setNeedsUpdate,je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[je.prototype._setValue_fromArray,je.prototype._setValue_fromArray_setNeedsUpdate,je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var VR=new Float32Array(1);var mg=new Ve,rl=class{constructor(t,e,i=0,s=1/0){this.ray=new er(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Lo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):se("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return mg.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(mg),this}intersectObject(t,e=!0,i=[]){return Vd(t,this,i,e),i.sort(gg),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Vd(t[s],this,i,e);return i.sort(gg),i}};function gg(n,t){return n.distance-t.distance}function Vd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Vd(r[o],t,e,!0)}}var Bo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=oe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(oe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Gd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var _g=new O,Sc=new O,Mo=new O,So=new O,Id=new O,Xb=new O,qb=new O,ol=class{constructor(t=new O,e=new O){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){_g.subVectors(t,this.start),Sc.subVectors(this.end,this.start);let i=Sc.dot(Sc);if(i===0)return 0;let r=Sc.dot(_g)/i;return e&&(r=oe(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=Xb,i=qb){let s=10000000000000001e-32,r,o,a=this.start,c=t.start,l=this.end,d=t.end;Mo.subVectors(l,a),So.subVectors(d,c),Id.subVectors(a,c);let h=Mo.dot(Mo),u=So.dot(So),f=So.dot(Id);if(h<=s&&u<=s)return e.copy(a),i.copy(c),e.distanceToSquared(i);if(h<=s)r=0,o=f/u,o=oe(o,0,1);else{let m=Mo.dot(Id);if(u<=s)o=0,r=oe(-m/h,0,1);else{let x=Mo.dot(So),p=h*u-x*x;p!==0?r=oe((x*f-m*u)/p,0,1):r=0,o=(x*r+f)/u,o<0?(o=0,r=oe(-m/h,0,1)):o>1&&(o=1,r=oe((x-m)/h,0,1))}}return e.copy(a).addScaledVector(Mo,r),i.copy(c).addScaledVector(So,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var al=class extends ir{constructor(t=10,e=10,i=4473924,s=8947848){i=new ce(i),s=new ce(s);let r=e/2,o=t/e,a=t/2,c=[],l=[];for(let u=0,f=0,m=-a;u<=e;u++,m+=o){c.push(-a,0,m,a,0,m),c.push(m,0,-a,m,0,a);let x=u===r?i:s;x.toArray(l,f),f+=3,x.toArray(l,f),f+=3,x.toArray(l,f),f+=3,x.toArray(l,f),f+=3}let d=new Qe;d.setAttribute("position",new ye(c,3)),d.setAttribute("color",new ye(l,3));let h=new Vi({vertexColors:!0,toneMapped:!1});super(d,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ll=class extends zi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function wf(n,t,e,i){let s=Yb(i);switch(e){case lf:return n*t;case hf:return n*t/s.components*s.byteLength;case _h:return n*t/s.components*s.byteLength;case ur:return n*t*2/s.components*s.byteLength;case xh:return n*t*2/s.components*s.byteLength;case cf:return n*t*3/s.components*s.byteLength;case Xi:return n*t*4/s.components*s.byteLength;case yh:return n*t*4/s.components*s.byteLength;case ul:case dl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case fl:case pl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case bh:case Sh:return Math.max(n,16)*Math.max(t,8)/4;case vh:case Mh:return Math.max(n,8)*Math.max(t,8)/2;case wh:case Eh:case Ah:case Ch:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Th:case ml:case Rh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ph:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ih:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Lh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Dh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Nh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Fh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Uh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Oh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case kh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Bh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case zh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Vh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Gh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Hh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Wh:case $h:case Xh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case qh:case Yh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case gl:case Zh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Yb(n){switch(n){case ni:case sf:return{byteLength:1,components:1};case Ho:case rf:case $i:return{byteLength:2,components:1};case mh:case gh:return{byteLength:2,components:4};case Hi:case ph:case Wi:return{byteLength:4,components:1};case of:case af:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?te("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function L0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Jb(n){let t=new WeakMap;function e(a,c){let l=a.array,d=a.usage,h=l.byteLength,u=n.createBuffer();n.bindBuffer(c,u),n.bufferData(c,l,d),a.onUploadCallback();let f;if(l instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=n.SHORT;else if(l instanceof Uint32Array)f=n.UNSIGNED_INT;else if(l instanceof Int32Array)f=n.INT;else if(l instanceof Int8Array)f=n.BYTE;else if(l instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,c,l){let d=c.array,h=c.updateRanges;if(n.bindBuffer(l,a),h.length===0)n.bufferSubData(l,0,d);else{h.sort((f,m)=>f.start-m.start);let u=0;for(let f=1;f<h.length;f++){let m=h[u],x=h[f];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++u,h[u]=x)}h.length=u+1;for(let f=0,m=h.length;f<m;f++){let x=h[f];n.bufferSubData(l,x.start*d.BYTES_PER_ELEMENT,d,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let d=t.get(a);(!d||d.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var Kb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,jb=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Qb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,tM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,eM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,nM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,iM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,sM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,rM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,oM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,aM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,lM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,cM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,hM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,uM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,dM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,fM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,pM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,mM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,gM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_M=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,xM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,yM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,vM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,bM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,MM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,SM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,wM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,EM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,TM="gl_FragColor = linearToOutputTexel( gl_FragColor );",AM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,CM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,RM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,PM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,IM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,LM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,DM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,NM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,FM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,UM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,OM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,kM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,BM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,zM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,VM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,GM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,HM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,WM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,$M=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,XM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,qM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,YM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,ZM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,JM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,KM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,QM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,tS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,eS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,nS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,iS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,sS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,rS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,oS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,aS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,lS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,cS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,hS=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,uS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,dS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,fS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,pS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,mS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,gS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_S=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,yS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,vS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,bS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,MS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,SS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,wS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ES=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,TS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,AS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,CS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,RS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,PS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,IS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,LS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,DS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,NS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,FS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,US=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,OS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,kS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,BS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,zS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,VS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,GS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,HS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,WS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,$S=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,XS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,YS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,ZS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,JS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,KS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,QS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ew=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,iw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,sw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,rw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,ow=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,aw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,cw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,hw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,uw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,fw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,mw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,_w=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,xw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,bw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Mw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Sw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ww=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Ew=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Tw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Aw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Cw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Rw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ge={alphahash_fragment:Kb,alphahash_pars_fragment:jb,alphamap_fragment:Qb,alphamap_pars_fragment:tM,alphatest_fragment:eM,alphatest_pars_fragment:nM,aomap_fragment:iM,aomap_pars_fragment:sM,batching_pars_vertex:rM,batching_vertex:oM,begin_vertex:aM,beginnormal_vertex:lM,bsdfs:cM,iridescence_fragment:hM,bumpmap_pars_fragment:uM,clipping_planes_fragment:dM,clipping_planes_pars_fragment:fM,clipping_planes_pars_vertex:pM,clipping_planes_vertex:mM,color_fragment:gM,color_pars_fragment:_M,color_pars_vertex:xM,color_vertex:yM,common:vM,defaultnormal_vertex:bM,displacementmap_pars_vertex:MM,displacementmap_vertex:SM,emissivemap_fragment:wM,emissivemap_pars_fragment:EM,colorspace_fragment:TM,colorspace_pars_fragment:AM,envmap_fragment:CM,envmap_common_pars_fragment:RM,envmap_pars_fragment:PM,envmap_pars_vertex:IM,envmap_physical_pars_fragment:GM,envmap_vertex:LM,fog_vertex:DM,fog_pars_vertex:NM,fog_fragment:FM,fog_pars_fragment:UM,gradientmap_pars_fragment:OM,lightmap_pars_fragment:kM,lights_lambert_fragment:BM,lights_lambert_pars_fragment:zM,lights_pars_begin:VM,lights_toon_fragment:HM,lights_toon_pars_fragment:WM,lights_phong_fragment:$M,lights_phong_pars_fragment:XM,lights_physical_fragment:qM,lights_physical_pars_fragment:YM,lights_fragment_begin:ZM,lights_fragment_maps:JM,lights_fragment_end:KM,lightprobes_pars_fragment:jM,logdepthbuf_fragment:QM,logdepthbuf_pars_fragment:tS,logdepthbuf_pars_vertex:eS,logdepthbuf_vertex:nS,map_fragment:iS,map_pars_fragment:sS,map_particle_fragment:rS,map_particle_pars_fragment:oS,metalnessmap_fragment:aS,metalnessmap_pars_fragment:lS,morphinstance_vertex:cS,morphcolor_vertex:hS,morphnormal_vertex:uS,morphtarget_pars_vertex:dS,morphtarget_vertex:fS,normal_fragment_begin:pS,normal_fragment_maps:mS,normal_pars_fragment:gS,normal_pars_vertex:_S,normal_vertex:xS,normalmap_pars_fragment:yS,clearcoat_normal_fragment_begin:vS,clearcoat_normal_fragment_maps:bS,clearcoat_pars_fragment:MS,iridescence_pars_fragment:SS,opaque_fragment:wS,packing:ES,premultiplied_alpha_fragment:TS,project_vertex:AS,dithering_fragment:CS,dithering_pars_fragment:RS,roughnessmap_fragment:PS,roughnessmap_pars_fragment:IS,shadowmap_pars_fragment:LS,shadowmap_pars_vertex:DS,shadowmap_vertex:NS,shadowmask_pars_fragment:FS,skinbase_vertex:US,skinning_pars_vertex:OS,skinning_vertex:kS,skinnormal_vertex:BS,specularmap_fragment:zS,specularmap_pars_fragment:VS,tonemapping_fragment:GS,tonemapping_pars_fragment:HS,transmission_fragment:WS,transmission_pars_fragment:$S,uv_pars_fragment:XS,uv_pars_vertex:qS,uv_vertex:YS,worldpos_vertex:ZS,background_vert:JS,background_frag:KS,backgroundCube_vert:jS,backgroundCube_frag:QS,cube_vert:tw,cube_frag:ew,depth_vert:nw,depth_frag:iw,distance_vert:sw,distance_frag:rw,equirect_vert:ow,equirect_frag:aw,linedashed_vert:lw,linedashed_frag:cw,meshbasic_vert:hw,meshbasic_frag:uw,meshlambert_vert:dw,meshlambert_frag:fw,meshmatcap_vert:pw,meshmatcap_frag:mw,meshnormal_vert:gw,meshnormal_frag:_w,meshphong_vert:xw,meshphong_frag:yw,meshphysical_vert:vw,meshphysical_frag:bw,meshtoon_vert:Mw,meshtoon_frag:Sw,points_vert:ww,points_frag:Ew,shadow_vert:Tw,shadow_frag:Aw,sprite_vert:Cw,sprite_frag:Rw},zt={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ae},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ae}},envmap:{envMap:{value:null},envMapRotation:{value:new ae},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ae}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ae}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ae},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ae},normalScale:{value:new Ot(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ae},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ae}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ae}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ae}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0},uvTransform:{value:new ae}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new Ot(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ae},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0}}},fs={basic:{uniforms:Gn([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.fog]),vertexShader:ge.meshbasic_vert,fragmentShader:ge.meshbasic_frag},lambert:{uniforms:Gn([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new ce(0)},envMapIntensity:{value:1}}]),vertexShader:ge.meshlambert_vert,fragmentShader:ge.meshlambert_frag},phong:{uniforms:Gn([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ge.meshphong_vert,fragmentShader:ge.meshphong_frag},standard:{uniforms:Gn([zt.common,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.roughnessmap,zt.metalnessmap,zt.fog,zt.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag},toon:{uniforms:Gn([zt.common,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.gradientmap,zt.fog,zt.lights,{emissive:{value:new ce(0)}}]),vertexShader:ge.meshtoon_vert,fragmentShader:ge.meshtoon_frag},matcap:{uniforms:Gn([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,{matcap:{value:null}}]),vertexShader:ge.meshmatcap_vert,fragmentShader:ge.meshmatcap_frag},points:{uniforms:Gn([zt.points,zt.fog]),vertexShader:ge.points_vert,fragmentShader:ge.points_frag},dashed:{uniforms:Gn([zt.common,zt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ge.linedashed_vert,fragmentShader:ge.linedashed_frag},depth:{uniforms:Gn([zt.common,zt.displacementmap]),vertexShader:ge.depth_vert,fragmentShader:ge.depth_frag},normal:{uniforms:Gn([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,{opacity:{value:1}}]),vertexShader:ge.meshnormal_vert,fragmentShader:ge.meshnormal_frag},sprite:{uniforms:Gn([zt.sprite,zt.fog]),vertexShader:ge.sprite_vert,fragmentShader:ge.sprite_frag},background:{uniforms:{uvTransform:{value:new ae},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ge.background_vert,fragmentShader:ge.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ae}},vertexShader:ge.backgroundCube_vert,fragmentShader:ge.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ge.cube_vert,fragmentShader:ge.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ge.equirect_vert,fragmentShader:ge.equirect_frag},distance:{uniforms:Gn([zt.common,zt.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ge.distance_vert,fragmentShader:ge.distance_frag},shadow:{uniforms:Gn([zt.lights,zt.fog,{color:{value:new ce(0)},opacity:{value:1}}]),vertexShader:ge.shadow_vert,fragmentShader:ge.shadow_frag}};fs.physical={uniforms:Gn([fs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ae},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ae},clearcoatNormalScale:{value:new Ot(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ae},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ae},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ae},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ae},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ae},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ae},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ae},transmissionSamplerSize:{value:new Ot},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ae},attenuationDistance:{value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ae},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ae},anisotropyVector:{value:new Ot},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ae}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag};var Kh={r:0,b:0,g:0},Pw=new Ve,D0=new ae;D0.set(-1,0,0,0,1,0,0,0,1);function Iw(n,t,e,i,s,r){let o=new ce(0),a=s===!0?0:1,c,l,d=null,h=0,u=null;function f(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let b=y.backgroundBlurriness>0;M=t.get(M,b)}return M}function m(y){let M=!1,b=f(y);b===null?p(o,a):b&&b.isColor&&(p(b,1),M=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,M){let b=f(M);b&&b.isCubeTexture?(l===void 0&&(l=new Fe(new sr(1,1,1),new hs({name:"BackgroundCubeMaterial",uniforms:Or(fs.backgroundCube.uniforms),vertexShader:fs.backgroundCube.vertexShader,fragmentShader:fs.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,w,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Pw.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(D0),l.material.toneMapped=Se.getTransfer(b.colorSpace)!==Ne,(d!==b||h!==b.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,d=b,h=b.version,u=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new Fe(new Ir(2,2),new hs({name:"BackgroundMaterial",uniforms:Or(fs.background.uniforms),vertexShader:fs.background.vertexShader,fragmentShader:fs.background.fragmentShader,side:hr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=Se.getTransfer(b.colorSpace)!==Ne,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(d!==b||h!==b.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,d=b,h=b.version,u=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function p(y,M){y.getRGB(Kh,bf(n)),e.buffers.color.setClear(Kh.r,Kh.g,Kh.b,M,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,p(o,a)},render:m,addToRenderList:x,dispose:g}}function Lw(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(N,G,W,P,B){let Y=!1,H=h(N,P,W,G);r!==H&&(r=H,l(r.object)),Y=f(N,P,W,B),Y&&m(N,P,W,B),B!==null&&t.update(B,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(N,G,W,P),B!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function c(){return n.createVertexArray()}function l(N){return n.bindVertexArray(N)}function d(N){return n.deleteVertexArray(N)}function h(N,G,W,P){let B=P.wireframe===!0,Y=i[G.id];Y===void 0&&(Y={},i[G.id]=Y);let H=N.isInstancedMesh===!0?N.id:0,ht=Y[H];ht===void 0&&(ht={},Y[H]=ht);let U=ht[W.id];U===void 0&&(U={},ht[W.id]=U);let J=U[B];return J===void 0&&(J=u(c()),U[B]=J),J}function u(N){let G=[],W=[],P=[];for(let B=0;B<e;B++)G[B]=0,W[B]=0,P[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:P,object:N,attributes:{},index:null}}function f(N,G,W,P){let B=r.attributes,Y=G.attributes,H=0,ht=W.getAttributes();for(let U in ht)if(ht[U].location>=0){let $=B[U],st=Y[U];if(st===void 0&&(U==="instanceMatrix"&&N.instanceMatrix&&(st=N.instanceMatrix),U==="instanceColor"&&N.instanceColor&&(st=N.instanceColor)),$===void 0||$.attribute!==st||st&&$.data!==st.data)return!0;H++}return r.attributesNum!==H||r.index!==P}function m(N,G,W,P){let B={},Y=G.attributes,H=0,ht=W.getAttributes();for(let U in ht)if(ht[U].location>=0){let $=Y[U];$===void 0&&(U==="instanceMatrix"&&N.instanceMatrix&&($=N.instanceMatrix),U==="instanceColor"&&N.instanceColor&&($=N.instanceColor));let st={};st.attribute=$,$&&$.data&&(st.data=$.data),B[U]=st,H++}r.attributes=B,r.attributesNum=H,r.index=P}function x(){let N=r.newAttributes;for(let G=0,W=N.length;G<W;G++)N[G]=0}function p(N){g(N,0)}function g(N,G){let W=r.newAttributes,P=r.enabledAttributes,B=r.attributeDivisors;W[N]=1,P[N]===0&&(n.enableVertexAttribArray(N),P[N]=1),B[N]!==G&&(n.vertexAttribDivisor(N,G),B[N]=G)}function y(){let N=r.newAttributes,G=r.enabledAttributes;for(let W=0,P=G.length;W<P;W++)G[W]!==N[W]&&(n.disableVertexAttribArray(W),G[W]=0)}function M(N,G,W,P,B,Y,H){H===!0?n.vertexAttribIPointer(N,G,W,B,Y):n.vertexAttribPointer(N,G,W,P,B,Y)}function b(N,G,W,P){x();let B=P.attributes,Y=W.getAttributes(),H=G.defaultAttributeValues;for(let ht in Y){let U=Y[ht];if(U.location>=0){let J=B[ht];if(J===void 0&&(ht==="instanceMatrix"&&N.instanceMatrix&&(J=N.instanceMatrix),ht==="instanceColor"&&N.instanceColor&&(J=N.instanceColor)),J!==void 0){let $=J.normalized,st=J.itemSize,lt=t.get(J);if(lt===void 0)continue;let Z=lt.buffer,pt=lt.type,mt=lt.bytesPerElement,Mt=pt===n.INT||pt===n.UNSIGNED_INT||J.gpuType===ph;if(J.isInterleavedBufferAttribute){let tt=J.data,xt=tt.isInterleavedBuffer===!0?tt.stride:tt.itemSize,it=J.offset;if(tt.isInstancedInterleavedBuffer||tt.isInstancedBufferAttribute){for(let rt=0;rt<U.locationSize;rt++)g(U.location+rt,tt.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let rt=0;rt<U.locationSize;rt++)p(U.location+rt);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let rt=0;rt<U.locationSize;rt++)M(U.location+rt,st/U.locationSize,pt,$,xt*mt,(it+st/U.locationSize*rt)*mt,Mt)}else{if(J.isInstancedBufferAttribute){for(let tt=0;tt<U.locationSize;tt++)g(U.location+tt,J.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let tt=0;tt<U.locationSize;tt++)p(U.location+tt);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let tt=0;tt<U.locationSize;tt++)M(U.location+tt,st/U.locationSize,pt,$,st*mt,st/U.locationSize*tt*mt,Mt)}}else if(H!==void 0){let $=H[ht];if($!==void 0)switch($.length){case 2:n.vertexAttrib2fv(U.location,$);break;case 3:n.vertexAttrib3fv(U.location,$);break;case 4:n.vertexAttrib4fv(U.location,$);break;default:n.vertexAttrib1fv(U.location,$)}}}}y()}function R(){k();for(let N in i){let G=i[N];for(let W in G){let P=G[W];for(let B in P){let Y=P[B];for(let H in Y)d(Y[H].object),delete Y[H];delete P[B]}}delete i[N]}}function w(N){if(i[N.id]===void 0)return;let G=i[N.id];for(let W in G){let P=G[W];for(let B in P){let Y=P[B];for(let H in Y)d(Y[H].object),delete Y[H];delete P[B]}}delete i[N.id]}function _(N){for(let G in i){let W=i[G];for(let P in W){let B=W[P];if(B[N.id]===void 0)continue;let Y=B[N.id];for(let H in Y)d(Y[H].object),delete Y[H];delete B[N.id]}}}function T(N){for(let G in i){let W=i[G],P=N.isInstancedMesh===!0?N.id:0,B=W[P];if(B!==void 0){for(let Y in B){let H=B[Y];for(let ht in H)d(H[ht].object),delete H[ht];delete B[Y]}delete W[P],Object.keys(W).length===0&&delete i[G]}}}function k(){D(),o=!0,r!==s&&(r=s,l(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:D,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:p,disableUnusedAttributes:y}}function Dw(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,d){d!==0&&(n.drawArraysInstanced(i,c,l,d),e.update(l,i,d))}function a(c,l,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,d);let u=0;for(let f=0;f<d;f++)u+=l[f];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Nw(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Xi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===$i&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ni&&_!==Wi&&!T&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",d=c(l);d!==l&&(te("WebGLRenderer:",l,"not supported, using",d,"instead."),l=d);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&te("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&te("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:b,maxSamples:R,samples:w}}function Fw(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Jn,a=new ae,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,u){let f=h.length!==0||u||i!==0||s;return s=u,i=h.length,f},this.beginShadows=function(){r=!0,d(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,u){e=d(h,u,0)},this.setState=function(h,u,f){let m=h.clippingPlanes,x=h.clipIntersection,p=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!p)r?d(null):l();else{let y=r?0:i,M=y*4,b=g.clippingState||null;c.value=b,b=d(m,u,M,f);for(let R=0;R!==M;++R)b[R]=e[R];g.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function d(h,u,f,m){let x=h!==null?h.length:0,p=null;if(x!==0){if(p=c.value,m!==!0||p===null){let g=f+x*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(p===null||p.length<g)&&(p=new Float32Array(g));for(let M=0,b=f;M!==x;++M,b+=4)o.copy(h[M]).applyMatrix4(y,a),o.normal.toArray(p,b),p[b+3]=o.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}var yl=class extends pi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Ba(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new sr(5,5,5),r=new hs({name:"CubemapFromEquirect",uniforms:Or(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qn,blending:Lr});r.uniforms.tEquirect.value=e;let o=new Fe(s,r),a=e.minFilter;return e.minFilter===Is&&(e.minFilter=jn),new ko(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},u0=256,Uw=3,Ow=20,N0=256,F0=16,kw=3,Bw=new O,zw=new ce,Qh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ko(1,10,null),this._boxMesh=new Fe(new sr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Bw}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),d=this._getSourceTarget(!0);e>0&&(d.texture.mipmapsAutoUpdate=!1);let h=c.autoClear,u=c.autoClearColor,f=c.autoClearDepth,m=c.autoClearStencil,x=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,x===null&&(t.background=c.getClearColor(zw));let p=new ko(i,s,d);return p.position.copy(a),p.update(c,t),c.autoClear=h,c.autoClearColor=u,c.autoClearDepth=f,c.autoClearStencil=m,t.background=x,e>0&&(d.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=p0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=f0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(u0,_f(t))}_fromTexture(t,e){t.mapping===Nr||t.mapping===Go?this._setSize(t.image.length===0?u0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=d0(t,!1,!1),i=Math.log2(t)-Uw;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=d0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Nr||t.mapping===Go?(this._cubemapMaterial===null&&(this._cubemapMaterial=p0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=f0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Vw(),this._integrationMaterial=Gw());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/F0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-kw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(N0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Hw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function d0(n,t,e){return new yl(n,{minFilter:Is,generateMipmaps:t,type:$i,colorSpace:Pa,depthBuffer:e})}function vl(n,t,e){return new hs({name:n,uniforms:t,vertexShader:ge.cube_vert,fragmentShader:e,side:Qn,blending:Lr,depthTest:!1,depthWrite:!1})}function Vw(){return vl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${N0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Gw(){return vl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:F0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Hw(){return vl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ow}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function f0(){return vl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function p0(){return vl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Ww(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===uh||f===dh)if(t.has(u)){let m=t.get(u).texture;return a(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let x=new yl(m.height);return x.fromEquirectangularTexture(n,u),t.set(u,x),u.addEventListener("dispose",l),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,m=f===uh||f===dh,x=f===Nr||f===Go;if(m||x){let p=e.get(u),g=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return i===null&&(i=new Qh(n)),p=m?i.fromEquirectangular(u,p):i.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),p.texture;if(p!==void 0)return p.texture;{let y=u.image;return m&&y&&y.height>0||x&&y&&c(y)?(i===null&&(i=new Qh(n)),p=m?i.fromEquirectangular(u):i.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),u.addEventListener("dispose",d),p.texture):null}}}return u}function a(u,f){return f===uh?u.mapping=Nr:f===dh&&(u.mapping=Go),u}function c(u){let f=0,m=6;for(let x=0;x<m;x++)u[x]!==void 0&&f++;return f===m}function l(u){let f=u.target;f.removeEventListener("dispose",l);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function d(u){let f=u.target;f.removeEventListener("dispose",d);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function $w(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Ea("WebGLRenderer: "+i+" extension not supported."),s}}}function Xw(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){c(m.target)}function c(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let x=r.get(m);x&&(t.remove(x),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function l(m,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function d(m){let x=m.attributes;for(let p in x)t.update(x[p],n.ARRAY_BUFFER)}function h(m){let x=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let y=x!==null?x.array.length:p.array.length/3-1,M=p.count>=65535?Ua:Fa,b=new M(Math.ceil(y/3)*6,1),R=b.array;if(x!==null){let _=x.array;g=x.version;for(let T=0,k=0;T<y;T+=3){let D=_[T+0],N=_[T+1],G=_[T+2];R[k++]=D,R[k++]=N,R[k++]=N,R[k++]=G,R[k++]=G,R[k++]=D}}else{g=p.version;for(let _=0,T=0;_<y;_+=3){let k=_+0,D=_+1,N=_+2;R[T++]=k,R[T++]=D,R[T++]=D,R[T++]=N,R[T++]=N,R[T++]=k}}b.version=g;let w=r.get(m);w&&t.remove(w),r.set(m,b)}function u(m){let x=r.get(m);if(x){let p=m.index;p!==null&&x.version<p.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let x=s[m].deref();x!==void 0&&c(x)}}return{get:l,update:d,getWireframeAttribute:u,dispose:f}}function qw(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function c(h,u){n.drawElements(i,u,r,h*o),e.update(u,i,1)}function l(h,u,f){f!==0&&(n.drawElementsInstanced(i,u,r,h*o,f),e.update(u,i,f))}function d(h,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,h,0,f);let x=0;for(let p=0;p<f;p++)x+=u[p];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=d}function Yw(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Zw(n,t,e){let i=new WeakMap,s=new nn;function r(o,a,c){let l=o.morphTargetInfluences,d=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=d!==void 0?d.length:0,u=i.get(a);if(u===void 0||u.count!==h){let k=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",k)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;f===!0&&(M=1),m===!0&&(M=2),x===!0&&(M=3);let b=a.attributes.position.count*M,R=1;b>t.maxTextureSize&&(R=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let w=new Float32Array(b*R*4*h),_=new Da(w,b,R,h);_.type=Wi,_.needsUpdate=!0;let T=M*4;for(let D=0;D<h;D++){let N=p[D],G=g[D],W=y[D],P=b*R*4*D;for(let B=0;B<N.count;B++){let Y=B*T;f===!0&&(s.fromBufferAttribute(N,B),w[P+Y+0]=s.x,w[P+Y+1]=s.y,w[P+Y+2]=s.z,w[P+Y+3]=0),m===!0&&(s.fromBufferAttribute(G,B),w[P+Y+4]=s.x,w[P+Y+5]=s.y,w[P+Y+6]=s.z,w[P+Y+7]=0),x===!0&&(s.fromBufferAttribute(W,B),w[P+Y+8]=s.x,w[P+Y+9]=s.y,w[P+Y+10]=s.z,w[P+Y+11]=W.itemSize===4?s.w:1)}}u={count:h,texture:_,size:new Ot(b,R)},i.set(a,u),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<l.length;x++)f+=l[x];let m=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(n,"morphTargetBaseInfluence",m),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function Jw(n,t,e,i,s){let r=new WeakMap;function o(l){let d=s.render.frame,h=l.geometry,u=t.get(l,h);if(r.get(u)!==d&&(t.update(u),r.set(u,d)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==d&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,d))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==d&&(f.update(),r.set(f,d))}return u}function a(){r=new WeakMap}function c(l){let d=l.target;d.removeEventListener("dispose",c),i.releaseStatesOfObject(d),e.remove(d.instanceMatrix),d.instanceColor!==null&&e.remove(d.instanceColor)}return{update:o,dispose:a}}var Kw={[Zd]:"LINEAR_TONE_MAPPING",[Jd]:"REINHARD_TONE_MAPPING",[Kd]:"CINEON_TONE_MAPPING",[jd]:"ACES_FILMIC_TONE_MAPPING",[tf]:"AGX_TONE_MAPPING",[ef]:"NEUTRAL_TONE_MAPPING",[Qd]:"CUSTOM_TONE_MAPPING"};function jw(n,t,e,i,s,r){let o=new pi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,d=new Qe;d.setAttribute("position",new ye([-1,3,0,-1,-1,0,3,-1,0],3)),d.setAttribute("uv",new ye([0,2,0,0,2,0],2));let h=new Zc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Fe(d,h),f=new il(-1,1,1,-1,0,1),m=null,x=null,p=!1,g,y=null,M=[],b=!1;this.setSize=function(R,w){o.setSize(R,w),a!==null&&a.setSize(R,w),c!==null&&c.setSize(R,w);for(let _=0;_<M.length;_++){let T=M[_];T.setSize&&T.setSize(R,w)}},this.setEffects=function(R){M=R,b=M.length>0&&M[0].isRenderPass===!0;let w=o.width,_=o.height;M.length>0&&a===null&&(a=new pi(w,_,{type:$i,depthBuffer:!1,stencilBuffer:!1}),c=new pi(w,_,{type:$i,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&M.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&l===null&&(l=new Rs(w,_),r===!0&&(l.format=Ls,l.type=Fr)),o.dispose(),o.depthTexture=T?l:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<M.length;k++){let D=M[k];D.setSize&&D.setSize(w,_),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(l)}},this.begin=function(R,w){if(p||R.toneMapping===us&&M.length===0)return!1;if(y=w,w!==null){let _=w.width,T=w.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return b===!1&&R.setRenderTarget(o),g=R.toneMapping,R.toneMapping=us,!0},this.hasRenderPass=function(){return b},this.end=function(R,w){R.toneMapping=g,p=!0;let _=o,T=a;for(let k=0;k<M.length;k++){let D=M[k];D.enabled!==!1&&(D.render(R,T,_,w),D.needsSwap!==!1&&(_=T,T=T===a?c:a))}if(m!==R.outputColorSpace||x!==R.toneMapping){m=R.outputColorSpace,x=R.toneMapping,h.defines={},Se.getTransfer(m)===Ne&&(h.defines.SRGB_TRANSFER="");let k=Kw[x];k&&(h.defines[k]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(y),R.render(u,f),y=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),d.dispose(),h.dispose()}}var U0=new ei,O0=new Rs(1,1),k0=new za(1),B0=new Da,z0=new kc,V0=new Ba,m0=[],g0=[],_0=new Float32Array(16),x0=new Float32Array(9),y0=new Float32Array(4);function $o(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=m0[s];if(r===void 0&&(r=new Float32Array(s),m0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function bn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Mn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function eu(n,t){let e=g0[t];e===void 0&&(e=new Int32Array(t),g0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Qw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function t1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2fv(this.addr,t),Mn(e,t)}}function e1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(bn(e,t))return;n.uniform3fv(this.addr,t),Mn(e,t)}}function n1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4fv(this.addr,t),Mn(e,t)}}function i1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Mn(e,t)}else{if(bn(e,i))return;y0.set(i),n.uniformMatrix2fv(this.addr,!1,y0),Mn(e,i)}}function s1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Mn(e,t)}else{if(bn(e,i))return;x0.set(i),n.uniformMatrix3fv(this.addr,!1,x0),Mn(e,i)}}function r1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Mn(e,t)}else{if(bn(e,i))return;_0.set(i),n.uniformMatrix4fv(this.addr,!1,_0),Mn(e,i)}}function o1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function a1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2iv(this.addr,t),Mn(e,t)}}function l1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;n.uniform3iv(this.addr,t),Mn(e,t)}}function c1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4iv(this.addr,t),Mn(e,t)}}function h1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function u1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2uiv(this.addr,t),Mn(e,t)}}function d1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;n.uniform3uiv(this.addr,t),Mn(e,t)}}function f1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4uiv(this.addr,t),Mn(e,t)}}function nu(n){return n.version===0&&(n.compareFunction=ff,n.needsUpdate=!0),n}function p1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=nu(O0):r=U0,e.setTexture2D(t||r,s)}function m1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||z0,s)}function g1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=nu(k0):r=V0,e.setTextureCube(t||r,s)}function _1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||B0,s)}function x1(n){switch(n){case 5126:return Qw;case 35664:return t1;case 35665:return e1;case 35666:return n1;case 35674:return i1;case 35675:return s1;case 35676:return r1;case 5124:case 35670:return o1;case 35667:case 35671:return a1;case 35668:case 35672:return l1;case 35669:case 35673:return c1;case 5125:return h1;case 36294:return u1;case 36295:return d1;case 36296:return f1;case 35678:case 36198:case 36298:case 36306:case 35682:return p1;case 35679:case 36299:case 36307:return m1;case 35680:case 36300:case 36308:case 36293:return g1;case 36289:case 36303:case 36311:case 36292:return _1}}function y1(n,t){n.uniform1fv(this.addr,t)}function v1(n,t){let e=$o(t,this.size,2);n.uniform2fv(this.addr,e)}function b1(n,t){let e=$o(t,this.size,3);n.uniform3fv(this.addr,e)}function M1(n,t){let e=$o(t,this.size,4);n.uniform4fv(this.addr,e)}function S1(n,t){let e=$o(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function w1(n,t){let e=$o(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function E1(n,t){let e=$o(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function T1(n,t){n.uniform1iv(this.addr,t)}function A1(n,t){n.uniform2iv(this.addr,t)}function C1(n,t){n.uniform3iv(this.addr,t)}function R1(n,t){n.uniform4iv(this.addr,t)}function P1(n,t){n.uniform1uiv(this.addr,t)}function I1(n,t){n.uniform2uiv(this.addr,t)}function L1(n,t){n.uniform3uiv(this.addr,t)}function D1(n,t){n.uniform4uiv(this.addr,t)}function N1(n,t,e){let i=this.cache,s=t.length,r=eu(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=nu(O0):o=U0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function F1(n,t,e){let i=this.cache,s=t.length,r=eu(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||z0,r[o])}function U1(n,t,e){let i=this.cache,s=t.length,r=eu(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=nu(k0):o=V0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function O1(n,t,e){let i=this.cache,s=t.length,r=eu(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||B0,r[o])}function k1(n){switch(n){case 5126:return y1;case 35664:return v1;case 35665:return b1;case 35666:return M1;case 35674:return S1;case 35675:return w1;case 35676:return E1;case 5124:case 35670:return T1;case 35667:case 35671:return A1;case 35668:case 35672:return C1;case 35669:case 35673:return R1;case 5125:return P1;case 36294:return I1;case 36295:return L1;case 36296:return D1;case 35678:case 36198:case 36298:case 36306:case 35682:return N1;case 35679:case 36299:case 36307:return F1;case 35680:case 36300:case 36308:case 36293:return U1;case 36289:case 36303:case 36311:case 36292:return O1}}var Af=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=x1(e.type)}},Cf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=k1(e.type)}},Rf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Ef=/(\w+)(\])?(\[|\.)?/g;function v0(n,t){n.seq.push(t),n.map[t.id]=t}function B1(n,t,e){let i=n.name,s=i.length;for(Ef.lastIndex=0;;){let r=Ef.exec(i),o=Ef.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){v0(e,l===void 0?new Af(a,n,t):new Cf(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Rf(a),v0(e,h)),e=h}}}var Wo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);B1(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function b0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var z1=37297,V1=0;function G1(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var M0=new ae;function H1(n){Se._getMatrix(M0,Se.workingColorSpace,n);let t=`mat3( ${M0.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(n)){case Ia:return[t,"LinearTransferOETF"];case Ne:return[t,"sRGBTransferOETF"];default:return te("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function S0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+G1(n.getShaderSource(t),a)}else return r}function W1(n,t){let e=H1(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var $1={[Zd]:"Linear",[Jd]:"Reinhard",[Kd]:"Cineon",[jd]:"ACESFilmic",[tf]:"AgX",[ef]:"Neutral",[Qd]:"Custom"};function X1(n,t){let e=$1[t];return e===void 0?(te("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var jh=new O;function q1(){Se.getLuminanceCoefficients(jh);let n=jh.x.toFixed(4),t=jh.y.toFixed(4),e=jh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Y1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(xl).join(`
`)}function Z1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function J1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function xl(n){return n!==""}function w0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function E0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var K1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Pf(n){return n.replace(K1,j1)}function j1(n,t){let e=ge[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Pf(e)}var Q1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function T0(n){return n.replace(Q1,tE)}function tE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function A0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var eE={[cl]:"SHADOWMAP_TYPE_PCF",[zo]:"SHADOWMAP_TYPE_VSM"};function nE(n){return eE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var iE={[Go]:"ENVMAP_MODE_REFRACTION"};function sE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":iE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var rE={[hh]:"ENVMAP_BLENDING_MULTIPLY",[Bg]:"ENVMAP_BLENDING_MIX",[zg]:"ENVMAP_BLENDING_ADD"};function oE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":rE[n.combine]||"ENVMAP_BLENDING_NONE"}function aE(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=nE(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",d=sE(e),h=oE(e),u=Y1(e),f=Z1(r),m=s.createProgram(),x,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(xl).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(xl).join(`
`),p.length>0&&(p+=`
`)):(x=[A0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+d:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(xl).join(`
`),p=[A0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+d:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==us?"#define TONE_MAPPING":"",e.toneMapping!==us?ge.tonemapping_pars_fragment:"",e.toneMapping!==us?X1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ge.colorspace_pars_fragment,W1("linearToOutputTexel",e.outputColorSpace),q1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(xl).join(`
`)),o=Pf(o),o=w0(o,e),o=E0(o,e),a=Pf(a),a=w0(a,e),a=E0(a,e),o=T0(o),a=T0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",e.glslVersion===pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let y=g+x+o,M=g+p+a,b=b0(s,s.VERTEX_SHADER,y),R=b0(s,s.FRAGMENT_SHADER,M);s.attachShader(m,b),s.attachShader(m,R),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function w(D){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(m)||"",G=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(R)||"",P=N.trim(),B=G.trim(),Y=W.trim(),H=!0,ht=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,b,R);else{let U=S0(s,b,"vertex"),J=S0(s,R,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+P+`
`+U+`
`+J)}else P!==""?te("WebGLProgram: Program Info Log:",P):(B===""||Y==="")&&(ht=!1);ht&&(D.diagnostics={runnable:H,programLog:P,vertexShader:{log:B,prefix:x},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(b),s.deleteShader(R),_=new Wo(s,m),T=J1(s,m)}let _;this.getUniforms=function(){return _===void 0&&w(this),_};let T;this.getAttributes=function(){return T===void 0&&w(this),T};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(m,z1)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=V1++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=R,this}var lE=0,If=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Lf(t),e.set(t,i)),i}},Lf=class{constructor(t){this.id=lE++,this.code=t,this.usedTimes=0}};function cE(n){return n===ur||n===ml||n===gl}function hE(n,t,e,i,s,r){let o=new Lo,a=new If,c=new Set,l=[],d=new Map,h=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function m(_,T,k,D,N,G){let W=D.fog,P=N.geometry,B=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?D.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=t.get(_.envMap||B,Y),ht=u[_.type],U=i.precision;_.precision!==null&&(U=i.getMaxPrecision(_.precision),U!==_.precision&&te("WebGLProgram.getParameters:",_.precision,"not supported, using",U,"instead."));let J=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,$=J!==void 0?J.length:0,st=0;P.morphAttributes.position!==void 0&&(st=1),P.morphAttributes.normal!==void 0&&(st=2),P.morphAttributes.color!==void 0&&(st=3);let lt,Z,pt,mt;if(ht){let Nt=fs[ht];lt=Nt.vertexShader,Z=Nt.fragmentShader}else{lt=_.vertexShader,Z=_.fragmentShader;let Nt=a.getVertexShaderStage(_),pe=a.getFragmentShaderStage(_);a.update(_,Nt,pe),pt=Nt.id,mt=pe.id}let Mt=n.getRenderTarget(),tt=n.state.buffers.depth.getReversed(),xt=N.isInstancedMesh===!0,it=N.isBatchedMesh===!0,rt=!!_.map,Ft=!!_.matcap,Ut=!!H,Lt=Ut&&H.isPMREMTexture===!0,Jt=!!_.aoMap,he=!!_.lightMap,Ee=!!_.bumpMap&&_.wireframe===!1,ve=!!_.normalMap,Ge=!!_.displacementMap,de=!!_.emissiveMap,We=!!_.metalnessMap,Oe=!!_.roughnessMap,on=_.anisotropy>0,z=_.clearcoat>0,Dt=_.diffuseRoughness>0,jt=_.dispersion>0,ue=_.retroreflectivity>0,Ct=_.iridescence>0,$e=_.sheen>0,Yt=_.transmission>0,Qt=on&&!!_.anisotropyMap,I=z&&!!_.clearcoatMap,S=z&&!!_.clearcoatNormalMap,K=z&&!!_.clearcoatRoughnessMap,_t=Dt&&!!_.diffuseRoughnessMap,dt=Ct&&!!_.iridescenceMap,wt=Ct&&!!_.iridescenceThicknessMap,Et=$e&&!!_.sheenColorMap,ot=$e&&!!_.sheenRoughnessMap,ct=!!_.specularMap,vt=!!_.specularColorMap,V=!!_.specularIntensityMap,ut=Yt&&!!_.transmissionMap,at=Yt&&!!_.thicknessMap,Rt=!!_.gradientMap,St=!!_.alphaMap,At=_.alphaTest>0,Zt=!!_.alphaHash,ne=!!_.extensions,gt=us;_.toneMapped&&(Mt===null||Mt.isXRRenderTarget===!0)&&(gt=n.toneMapping);let $t=Lt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ie={shaderID:ht,shaderType:_.type,shaderName:_.name,vertexShader:lt,fragmentShader:Z,defines:_.defines,customVertexShaderID:pt,customFragmentShaderID:mt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:U,batching:it,batchingColor:it&&N._colorsTexture!==null,instancing:xt,instancingColor:xt&&N.instanceColor!==null,instancingMorph:xt&&N.morphTexture!==null,outputColorSpace:Mt===null?n.outputColorSpace:Mt.isXRRenderTarget===!0?Mt.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:rt,matcap:Ft,envMap:Ut,envMapMode:Ut&&H.mapping,envMapPMREM:Lt,envMapMaxLod:Lt?$t.length-1:null,envMapSize:Lt?$t[0].width:null,aoMap:Jt,lightMap:he,bumpMap:Ee,normalMap:ve,displacementMap:Ge,emissiveMap:de,normalMapObjectSpace:ve&&_.normalMapType===Hg,normalMapTangentSpace:ve&&_.normalMapType===Jh,packedNormalMap:ve&&_.normalMapType===Jh&&cE(_.normalMap.format),metalnessMap:We,roughnessMap:Oe,anisotropy:on,anisotropyMap:Qt,clearcoat:z,clearcoatMap:I,clearcoatNormalMap:S,clearcoatRoughnessMap:K,diffuseRoughness:Dt,diffuseRoughnessMap:_t,dispersion:jt,retroreflection:ue,iridescence:Ct,iridescenceMap:dt,iridescenceThicknessMap:wt,sheen:$e,sheenColorMap:Et,sheenRoughnessMap:ot,specularMap:ct,specularColorMap:vt,specularIntensityMap:V,transmission:Yt,transmissionMap:ut,thicknessMap:at,gradientMap:Rt,opaque:_.transparent===!1&&_.blending===Vo&&_.alphaToCoverage===!1,alphaMap:St,alphaTest:At,alphaHash:Zt,combine:_.combine,mapUv:rt&&f(_.map.channel),aoMapUv:Jt&&f(_.aoMap.channel),lightMapUv:he&&f(_.lightMap.channel),bumpMapUv:Ee&&f(_.bumpMap.channel),normalMapUv:ve&&f(_.normalMap.channel),displacementMapUv:Ge&&f(_.displacementMap.channel),emissiveMapUv:de&&f(_.emissiveMap.channel),metalnessMapUv:We&&f(_.metalnessMap.channel),roughnessMapUv:Oe&&f(_.roughnessMap.channel),anisotropyMapUv:Qt&&f(_.anisotropyMap.channel),clearcoatMapUv:I&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:K&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:_t&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:dt&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:wt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:Et&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:ot&&f(_.sheenRoughnessMap.channel),specularMapUv:ct&&f(_.specularMap.channel),specularColorMapUv:vt&&f(_.specularColorMap.channel),specularIntensityMapUv:V&&f(_.specularIntensityMap.channel),transmissionMapUv:ut&&f(_.transmissionMap.channel),thicknessMapUv:at&&f(_.thicknessMap.channel),alphaMapUv:St&&f(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(ve||on),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(rt||St),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&ve===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:tt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:st,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:G.filter(Nt=>Nt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:gt,decodeVideoTexture:rt&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Ne,decodeVideoTextureEmissive:de&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Ne,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ci,flipSided:_.side===Qn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ne&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ne&&_.extensions.multiDraw===!0||it)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ie.vertexUv1s=c.has(1),ie.vertexUv2s=c.has(2),ie.vertexUv3s=c.has(3),c.clear(),ie}function x(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let k in _.defines)T.push(k),T.push(_.defines[k]);return _.isRawShaderMaterial===!1&&(p(T,_),g(T,_),T.push(n.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function p(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function g(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let T=u[_.type],k;if(T){let D=fs[T];k=l0.clone(D.uniforms)}else k=_.uniforms;return k}function M(_,T){let k=d.get(T);return k!==void 0?++k.usedTimes:(k=new aE(n,T,_,s),l.push(k),d.set(T,k)),k}function b(_){if(--_.usedTimes===0){let T=l.indexOf(_);l[T]=l[l.length-1],l.pop(),d.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function w(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:y,acquireProgram:M,releaseProgram:b,releaseShaderCache:R,programs:l,dispose:w}}function uE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function dE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function C0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function R0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,m,x,p,g){let y=n[t];return y===void 0?(y={id:u.id,object:u,geometry:f,material:m,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:p,group:g},n[t]=y):(y.id=u.id,y.object=u,y.geometry=f,y.material=m,y.materialVariant=o(u),y.groupOrder=x,y.renderOrder=u.renderOrder,y.z=p,y.group=g),t++,y}function c(u,f,m,x,p,g,y){y.reversedDepth===!0&&(p=-p);let M=a(u,f,m,x,p,g);m.transmission>0?i.push(M):m.transparent===!0?s.push(M):e.push(M)}function l(u,f,m,x,p,g){let y=a(u,f,m,x,p,g);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):e.unshift(y)}function d(u,f){e.length>1&&e.sort(u||dE),i.length>1&&i.sort(f||C0),s.length>1&&s.sort(f||C0)}function h(){for(let u=t,f=n.length;u<f;u++){let m=n[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:h,sort:d}}function fE(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new R0,n.set(i,[o])):s>=r.length?(o=new R0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function pE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new O,color:new ce};break;case"SpotLight":e={position:new O,direction:new O,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new O,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new O,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new O,halfWidth:new O,halfHeight:new O};break}return n[t.id]=e,e}}}function mE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var gE=0;function _E(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function xE(n){let t=new pE,e=mE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new O);let s=new O,r=new Ve,o=new Ve;function a(l){let d=0,h=0,u=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let f=0,m=0,x=0,p=0,g=0,y=0,M=0,b=0,R=0,w=0,_=0,T=0,k=0,D=0;l.sort(_E);for(let G=0,W=l.length;G<W;G++){let P=l[G],B=P.color,Y=P.intensity,H=P.distance,ht=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===ur?ht=P.shadow.map.texture:ht=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)d+=B.r*Y,h+=B.g*Y,u+=B.b*Y;else if(P.isLightProbe){for(let U=0;U<9;U++)i.probe[U].addScaledVector(P.sh.coefficients[U],Y);D++}else if(P.isSunLight){let U=t.get(P);if(U.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let J=P.shadow,$=e.get(P);$.shadowIntensity=J.intensity,$.shadowBias=J.bias,$.shadowNormalBias=J.normalBias,$.shadowRadius=J.radius,$.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[m]=$,i.sunShadowMap[m]=ht;let st=J.getViewportCount();for(let lt=0;lt<st;lt++)i.sunShadowMatrix[x+lt]=J.getMatrix(lt),i.sunShadowCascade[x+lt]=J._cascadeData[lt];x+=st,m++}i.sun[f]=U,f++}else if(P.isDirectionalLight){let U=t.get(P);if(U.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let J=P.shadow,$=e.get(P);$.shadowIntensity=J.intensity,$.shadowBias=J.bias,$.shadowNormalBias=J.normalBias,$.shadowRadius=J.radius,$.shadowMapSize=J.mapSize,i.directionalShadow[p]=$,i.directionalShadowMap[p]=ht,i.directionalShadowMatrix[p]=P.shadow.matrix,R++}i.directional[p]=U,p++}else if(P.isSpotLight){let U=t.get(P);U.position.setFromMatrixPosition(P.matrixWorld),U.color.copy(B).multiplyScalar(Y),U.distance=H,U.coneCos=Math.cos(P.angle),U.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),U.decay=P.decay,i.spot[y]=U;let J=P.shadow;if(P.map&&(i.spotLightMap[T]=P.map,T++,J.updateMatrices(P),P.castShadow&&k++),i.spotLightMatrix[y]=J.matrix,P.castShadow){let $=e.get(P);$.shadowIntensity=J.intensity,$.shadowBias=J.bias,$.shadowNormalBias=J.normalBias,$.shadowRadius=J.radius,$.shadowMapSize=J.mapSize,i.spotShadow[y]=$,i.spotShadowMap[y]=ht,_++}y++}else if(P.isRectAreaLight){let U=t.get(P);U.color.copy(B).multiplyScalar(Y),U.halfWidth.set(P.width*.5,0,0),U.halfHeight.set(0,P.height*.5,0),i.rectArea[M]=U,M++}else if(P.isPointLight){let U=t.get(P);if(U.color.copy(P.color).multiplyScalar(P.intensity),U.distance=P.distance,U.decay=P.decay,P.castShadow){let J=P.shadow,$=e.get(P);$.shadowIntensity=J.intensity,$.shadowBias=J.bias,$.shadowNormalBias=J.normalBias,$.shadowRadius=J.radius,$.shadowMapSize=J.mapSize,$.shadowCameraNear=J.camera.near,$.shadowCameraFar=J.camera.far,i.pointShadow[g]=$,i.pointShadowMap[g]=ht,i.pointShadowMatrix[g]=P.shadow.matrix,w++}i.point[g]=U,g++}else if(P.isHemisphereLight){let U=t.get(P);U.skyColor.copy(P.color).multiplyScalar(Y),U.groundColor.copy(P.groundColor).multiplyScalar(Y),i.hemi[b]=U,b++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=zt.LTC_FLOAT_1,i.rectAreaLTC2=zt.LTC_FLOAT_2):(i.rectAreaLTC1=zt.LTC_HALF_1,i.rectAreaLTC2=zt.LTC_HALF_2)),i.ambient[0]=d,i.ambient[1]=h,i.ambient[2]=u;let N=i.hash;(N.sunLength!==f||N.directionalLength!==p||N.pointLength!==g||N.spotLength!==y||N.rectAreaLength!==M||N.hemiLength!==b||N.numSunShadows!==m||N.numDirectionalShadows!==R||N.numPointShadows!==w||N.numSpotShadows!==_||N.numSpotMaps!==T||N.numLightProbes!==D)&&(i.sun.length=f,i.directional.length=p,i.spot.length=y,i.rectArea.length=M,i.point.length=g,i.hemi.length=b,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+T-k,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=D,N.sunLength=f,N.directionalLength=p,N.pointLength=g,N.spotLength=y,N.rectAreaLength=M,N.hemiLength=b,N.numSunShadows=m,N.numDirectionalShadows=R,N.numPointShadows=w,N.numSpotShadows=_,N.numSpotMaps=T,N.numLightProbes=D,i.version=gE++)}function c(l,d){let h=0,u=0,f=0,m=0,x=0,p=0,g=d.matrixWorldInverse;for(let y=0,M=l.length;y<M;y++){let b=l[y];if(b.isSunLight){let R=i.sun[h];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),u++}else if(b.isSpotLight){let R=i.spot[m];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),m++}else if(b.isRectAreaLight){let R=i.rectArea[x];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),R.halfWidth.set(b.width*.5,0,0),R.halfHeight.set(0,b.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let R=i.hemi[p];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(g),p++}}}return{setup:a,setupView:c,state:i}}function P0(n){let t=new xE(n),e=[],i=[],s=[];function r(h){d.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function c(){t.setup(e),s.sort((h,u)=>h.priority-u.priority||h.id-u.id)}function l(h){t.setupView(e,h)}let d={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:d,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function yE(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new P0(n),t.set(s,[a])):r>=o.length?(a=new P0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var vE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,bE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,ME=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],SE=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],I0=new Ve,_l=new O,Tf=new O;function wE(n,t,e){let i=new nr,s=new Ot,r=new Ot,o=new nn,a=new Jc,c=new Kc,l={},d=e.maxTextureSize,h={[hr]:Qn,[Qn]:hr,[Ci]:Ci},u=new hs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ot},radius:{value:4}},vertexShader:vE,fragmentShader:bE}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let m=new Qe;m.setAttribute("position",new ls(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Fe(m,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=cl;let g=this.type;this.render=function(w,_,T){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===vg&&(te("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=cl);let k=n.getRenderTarget(),D=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),G=n.state;G.setBlending(Lr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=g!==this.type;W&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(B=>B.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,B=w.length;P<B;P++){let Y=w[P],H=Y.shadow;if(H===void 0){te("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ht=H.getFrameExtents();s.multiply(ht),r.copy(H.mapSize),(s.x>d||s.y>d)&&(s.x>d&&(r.x=Math.floor(d/ht.x),s.x=r.x*ht.x,H.mapSize.x=r.x),s.y>d&&(r.y=Math.floor(d/ht.y),s.y=r.y*ht.y,H.mapSize.y=r.y));let U=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=U,H.map===null||W===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===zo){if(Y.isPointLight){te("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new pi(s.x,s.y,{format:ur,type:$i,minFilter:jn,magFilter:jn,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new Rs(s.x,s.y,Wi),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=As,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln}else Y.isPointLight?(H.map=new yl(s.x),H.map.depthTexture=new za(s.x,Hi)):(H.map=new pi(s.x,s.y),H.map.depthTexture=new Rs(s.x,s.y,Hi)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=As,this.type===cl?(H.map.depthTexture.compareFunction=U?df:uf,H.map.depthTexture.minFilter=jn,H.map.depthTexture.magFilter=jn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let J=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Y.isPointLight!==!0&&H.updateMatrices(Y,T);let $=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let st=0;st<J;st++){let lt=H.getCamera(st);if(Y.isPointLight){let Z=H.camera,pt=H.matrix,mt=Y.distance||Z.far;mt!==Z.far&&(Z.far=mt,Z.updateProjectionMatrix()),_l.setFromMatrixPosition(Y.matrixWorld),Z.position.copy(_l),Tf.copy(Z.position),Tf.add(ME[st]),Z.up.copy(SE[st]),Z.lookAt(Tf),Z.updateMatrixWorld(),pt.makeTranslation(-_l.x,-_l.y,-_l.z),I0.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),H._frustum.setFromProjectionMatrix(I0,Z.coordinateSystem,Z.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,st),n.clear();else{st===0&&(n.setRenderTarget(H.map),n.clear());let Z=H.getViewport(st);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),G.viewport(o)}i=H.getFrustum(st),b(_,T,lt,Y,$,this.type)}H.isPointLightShadow!==!0&&this.type===zo&&y(H,T),H.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(k,D,N)};function y(w,_){let T=t.update(x);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new pi(s.x,s.y,{format:ur,type:$i}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(_,null,T,u,x,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(_,null,T,f,x,null)}function M(w,_,T,k){let D=null,N=T.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(N!==void 0)D=N;else if(D=T.isPointLight===!0?c:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let G=D.uuid,W=_.uuid,P=l[G];P===void 0&&(P={},l[G]=P);let B=P[W];B===void 0&&(B=D.clone(),P[W]=B,_.addEventListener("dispose",R)),D=B}if(D.visible=_.visible,D.wireframe=_.wireframe,k===zo?D.side=_.shadowSide!==null?_.shadowSide:_.side:D.side=_.shadowSide!==null?_.shadowSide:h[_.side],D.alphaMap=_.alphaMap,D.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,D.map=_.map,D.clipShadows=_.clipShadows,D.clippingPlanes=_.clippingPlanes,D.clipIntersection=_.clipIntersection,D.displacementMap=_.displacementMap,D.displacementScale=_.displacementScale,D.displacementBias=_.displacementBias,D.wireframeLinewidth=_.wireframeLinewidth,D.linewidth=_.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let G=n.properties.get(D);G.light=T}return D}function b(w,_,T,k,D,N){if(w.visible===!1)return;if(w.layers.test(D)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&N===zo)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,w.matrixWorld);let P=t.update(w),B=w.material;if(Array.isArray(B)){let Y=P.groups;for(let H=0,ht=Y.length;H<ht;H++){let U=Y[H],J=B[U.materialIndex];if(J&&J.visible){let $=M(w,J,k,N);w.onBeforeShadow(n,w,_,T,P,$,U),n.renderBufferDirect(T,null,P,$,w,U),w.onAfterShadow(n,w,_,T,P,$,U)}}}else if(B.visible){let Y=M(w,B,k,N);w.onBeforeShadow(n,w,_,T,P,Y,null),n.renderBufferDirect(T,null,P,Y,w,null),w.onAfterShadow(n,w,_,T,P,Y,null)}}let W=w.children;for(let P=0,B=W.length;P<B;P++)b(W[P],_,T,k,D,N)}function R(w){w.target.removeEventListener("dispose",R);for(let T in l){let k=l[T],D=w.target.uuid;D in k&&(k[D].dispose(),delete k[D])}}}function EE(n,t){function e(){let V=!1,ut=new nn,at=null,Rt=new nn(0,0,0,0);return{setMask:function(St){at!==St&&!V&&(n.colorMask(St,St,St,St),at=St)},setLocked:function(St){V=St},setClear:function(St,At,Zt,ne,gt){gt===!0&&(St*=ne,At*=ne,Zt*=ne),ut.set(St,At,Zt,ne),Rt.equals(ut)===!1&&(n.clearColor(St,At,Zt,ne),Rt.copy(ut))},reset:function(){V=!1,at=null,Rt.set(-1,0,0,0)}}}function i(){let V=!1,ut=!1,at=null,Rt=null,St=null;return{setReversed:function(At){if(ut!==At){let Zt=t.get("EXT_clip_control");At?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),ut=At;let ne=St;St=null,this.setClear(ne)}},getReversed:function(){return ut},setTest:function(At){At?tt(n.DEPTH_TEST):xt(n.DEPTH_TEST)},setMask:function(At){at!==At&&!V&&(n.depthMask(At),at=At)},setFunc:function(At){if(ut&&(At=t0[At]),Rt!==At){switch(At){case Tc:n.depthFunc(n.NEVER);break;case Ac:n.depthFunc(n.ALWAYS);break;case Cc:n.depthFunc(n.LESS);break;case Ao:n.depthFunc(n.LEQUAL);break;case Rc:n.depthFunc(n.EQUAL);break;case Pc:n.depthFunc(n.GEQUAL);break;case Ic:n.depthFunc(n.GREATER);break;case Lc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Rt=At}},setLocked:function(At){V=At},setClear:function(At){St!==At&&(St=At,ut&&(At=1-At),n.clearDepth(At))},reset:function(){V=!1,at=null,Rt=null,St=null,ut=!1}}}function s(){let V=!1,ut=null,at=null,Rt=null,St=null,At=null,Zt=null,ne=null,gt=null;return{setTest:function($t){V||($t?tt(n.STENCIL_TEST):xt(n.STENCIL_TEST))},setMask:function($t){ut!==$t&&!V&&(n.stencilMask($t),ut=$t)},setFunc:function($t,ie,Nt){(at!==$t||Rt!==ie||St!==Nt)&&(n.stencilFunc($t,ie,Nt),at=$t,Rt=ie,St=Nt)},setOp:function($t,ie,Nt){(At!==$t||Zt!==ie||ne!==Nt)&&(n.stencilOp($t,ie,Nt),At=$t,Zt=ie,ne=Nt)},setLocked:function($t){V=$t},setClear:function($t){gt!==$t&&(n.clearStencil($t),gt=$t)},reset:function(){V=!1,ut=null,at=null,Rt=null,St=null,At=null,Zt=null,ne=null,gt=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,d={},h={},u={},f=new WeakMap,m=[],x=null,p=!1,g=null,y=null,M=null,b=null,R=null,w=null,_=null,T=new ce(0,0,0),k=0,D=!1,N=null,G=null,W=null,P=null,B=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ht=0,U=n.getParameter(n.VERSION);U.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(U)[1]),H=ht>=1):U.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(U)[1]),H=ht>=2);let J=null,$={},st=n.getParameter(n.SCISSOR_BOX),lt=n.getParameter(n.VIEWPORT),Z=new nn().fromArray(st),pt=new nn().fromArray(lt);function mt(V,ut,at,Rt){let St=new Uint8Array(4),At=n.createTexture();n.bindTexture(V,At),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<at;Zt++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(ut,0,n.RGBA,1,1,Rt,0,n.RGBA,n.UNSIGNED_BYTE,St):n.texImage2D(ut+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,St);return At}let Mt={};Mt[n.TEXTURE_2D]=mt(n.TEXTURE_2D,n.TEXTURE_2D,1),Mt[n.TEXTURE_CUBE_MAP]=mt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Mt[n.TEXTURE_2D_ARRAY]=mt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Mt[n.TEXTURE_3D]=mt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),tt(n.DEPTH_TEST),o.setFunc(Ao),Ee(!1),ve(Hd),tt(n.CULL_FACE),Jt(Lr);function tt(V){d[V]!==!0&&(n.enable(V),d[V]=!0)}function xt(V){d[V]!==!1&&(n.disable(V),d[V]=!1)}function it(V,ut){return u[V]!==ut?(n.bindFramebuffer(V,ut),u[V]=ut,V===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=ut),V===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=ut),!0):!1}function rt(V,ut){let at=m,Rt=!1;if(V){at=f.get(ut),at===void 0&&(at=[],f.set(ut,at));let St=V.textures;if(at.length!==St.length||at[0]!==n.COLOR_ATTACHMENT0){for(let At=0,Zt=St.length;At<Zt;At++)at[At]=n.COLOR_ATTACHMENT0+At;at.length=St.length,Rt=!0}}else at[0]!==n.BACK&&(at[0]=n.BACK,Rt=!0);Rt&&n.drawBuffers(at)}function Ft(V){return x!==V?(n.useProgram(V),x=V,!0):!1}let Ut={[Dr]:n.FUNC_ADD,[Mg]:n.FUNC_SUBTRACT,[Sg]:n.FUNC_REVERSE_SUBTRACT};Ut[wg]=n.MIN,Ut[Eg]=n.MAX;let Lt={[Tg]:n.ZERO,[Ag]:n.ONE,[Cg]:n.SRC_COLOR,[qd]:n.SRC_ALPHA,[Ng]:n.SRC_ALPHA_SATURATE,[Lg]:n.DST_COLOR,[Pg]:n.DST_ALPHA,[Rg]:n.ONE_MINUS_SRC_COLOR,[Yd]:n.ONE_MINUS_SRC_ALPHA,[Dg]:n.ONE_MINUS_DST_COLOR,[Ig]:n.ONE_MINUS_DST_ALPHA,[Fg]:n.CONSTANT_COLOR,[Ug]:n.ONE_MINUS_CONSTANT_COLOR,[Og]:n.CONSTANT_ALPHA,[kg]:n.ONE_MINUS_CONSTANT_ALPHA};function Jt(V,ut,at,Rt,St,At,Zt,ne,gt,$t){if(V===Lr){p===!0&&(xt(n.BLEND),p=!1);return}if(p===!1&&(tt(n.BLEND),p=!0),V!==bg){if(V!==g||$t!==D){if((y!==Dr||R!==Dr)&&(n.blendEquation(n.FUNC_ADD),y=Dr,R=Dr),$t)switch(V){case Vo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Wd:n.blendFunc(n.ONE,n.ONE);break;case $d:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Xd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:se("WebGLState: Invalid blending: ",V);break}else switch(V){case Vo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Wd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case $d:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Xd:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",V);break}M=null,b=null,w=null,_=null,T.set(0,0,0),k=0,g=V,D=$t}return}St=St||ut,At=At||at,Zt=Zt||Rt,(ut!==y||St!==R)&&(n.blendEquationSeparate(Ut[ut],Ut[St]),y=ut,R=St),(at!==M||Rt!==b||At!==w||Zt!==_)&&(n.blendFuncSeparate(Lt[at],Lt[Rt],Lt[At],Lt[Zt]),M=at,b=Rt,w=At,_=Zt),(ne.equals(T)===!1||gt!==k)&&(n.blendColor(ne.r,ne.g,ne.b,gt),T.copy(ne),k=gt),g=V,D=!1}function he(V,ut){V.side===Ci?xt(n.CULL_FACE):tt(n.CULL_FACE);let at=V.side===Qn;ut&&(at=!at),Ee(at),V.blending===Vo&&V.transparent===!1?Jt(Lr):Jt(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Rt=V.stencilWrite;a.setTest(Rt),Rt&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),de(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?tt(n.SAMPLE_ALPHA_TO_COVERAGE):xt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ee(V){N!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),N=V)}function ve(V){V!==xg?(tt(n.CULL_FACE),V!==G&&(V===Hd?n.cullFace(n.BACK):V===yg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):xt(n.CULL_FACE),G=V}function Ge(V){V!==W&&(H&&n.lineWidth(V),W=V)}function de(V,ut,at){V?(tt(n.POLYGON_OFFSET_FILL),(P!==ut||B!==at)&&(P=ut,B=at,o.getReversed()&&(ut=-ut,at=-at),n.polygonOffset(ut,at))):xt(n.POLYGON_OFFSET_FILL)}function We(V){V?tt(n.SCISSOR_TEST):xt(n.SCISSOR_TEST)}function Oe(V){V===void 0&&(V=n.TEXTURE0+Y-1),J!==V&&(n.activeTexture(V),J=V)}function on(V,ut,at){at===void 0&&(J===null?at=n.TEXTURE0+Y-1:at=J);let Rt=$[at];Rt===void 0&&(Rt={type:void 0,texture:void 0},$[at]=Rt),(Rt.type!==V||Rt.texture!==ut)&&(J!==at&&(n.activeTexture(at),J=at),n.bindTexture(V,ut||Mt[V]),Rt.type=V,Rt.texture=ut)}function z(){let V=$[J];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Dt(){try{n.compressedTexImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function jt(){try{n.compressedTexImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function ue(){try{n.texSubImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function $e(){try{n.compressedTexSubImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function Qt(){try{n.texStorage2D(...arguments)}catch(V){se("WebGLState:",V)}}function I(){try{n.texStorage3D(...arguments)}catch(V){se("WebGLState:",V)}}function S(){try{n.texImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function K(){try{n.texImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function _t(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function dt(V,ut){h[V]!==ut&&(n.pixelStorei(V,ut),h[V]=ut)}function wt(V){Z.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),Z.copy(V))}function Et(V){pt.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),pt.copy(V))}function ot(V,ut){let at=l.get(ut);at===void 0&&(at=new WeakMap,l.set(ut,at));let Rt=at.get(V);Rt===void 0&&(Rt=n.getUniformBlockIndex(ut,V.name),n.uniformBlockBinding(ut,Rt,Rt),at.set(V,Rt))}function ct(V,ut,at){let St=l.get(ut).get(V);c[St]!==at&&(n.bindBufferBase(n.UNIFORM_BUFFER,St,at),c[St]=at)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),d={},h={},J=null,$={},u={},c={},f=new WeakMap,m=[],x=null,p=!1,g=null,y=null,M=null,b=null,R=null,w=null,_=null,T=new ce(0,0,0),k=0,D=!1,N=null,G=null,W=null,P=null,B=null,Z.set(0,0,n.canvas.width,n.canvas.height),pt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:tt,disable:xt,bindFramebuffer:it,drawBuffers:rt,useProgram:Ft,setBlending:Jt,setMaterial:he,setFlipSided:Ee,setCullFace:ve,setLineWidth:Ge,setPolygonOffset:de,setScissorTest:We,activeTexture:Oe,bindTexture:on,unbindTexture:z,compressedTexImage2D:Dt,compressedTexImage3D:jt,texImage2D:S,texImage3D:K,pixelStorei:dt,getParameter:_t,updateUBOMapping:ot,uniformBlockBinding:ct,texStorage2D:Qt,texStorage3D:I,texSubImage2D:ue,texSubImage3D:Ct,compressedTexSubImage2D:$e,compressedTexSubImage3D:Yt,scissor:wt,viewport:Et,reset:vt}}function TE(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ot,d=new WeakMap,h=new Set,u,f=new WeakMap,m=new Set,x=new FinalizationRegistry(I=>m.delete(I)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,S){return p?new OffscreenCanvas(I,S):La("canvas")}function y(I,S,K){let _t=1,dt=Qt(I);if((dt.width>K||dt.height>K)&&(_t=K/Math.max(dt.width,dt.height)),_t<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let wt=Math.floor(_t*dt.width),Et=Math.floor(_t*dt.height);u===void 0&&(u=g(wt,Et));let ot=S?g(wt,Et):u;return ot.width=wt,ot.height=Et,ot.getContext("2d").drawImage(I,0,0,wt,Et),te("WebGLRenderer: Texture has been resized from ("+dt.width+"x"+dt.height+") to ("+wt+"x"+Et+")."),ot}else return"data"in I&&te("WebGLRenderer: Image in DataTexture is too big ("+dt.width+"x"+dt.height+")."),I;return I}function M(I){return I.generateMipmaps}function b(I){n.generateMipmap(I)}function R(I){return I.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?n.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(I,S,K,_t,dt,wt=!1){if(I!==null){if(n[I]!==void 0)return n[I];te("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let Et;_t&&(Et=t.get("EXT_texture_norm16"),Et||te("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ot=S;if(S===n.RED&&(K===n.FLOAT&&(ot=n.R32F),K===n.HALF_FLOAT&&(ot=n.R16F),K===n.UNSIGNED_BYTE&&(ot=n.R8),K===n.UNSIGNED_SHORT&&Et&&(ot=Et.R16_EXT),K===n.SHORT&&Et&&(ot=Et.R16_SNORM_EXT)),S===n.RED_INTEGER&&(K===n.UNSIGNED_BYTE&&(ot=n.R8UI),K===n.UNSIGNED_SHORT&&(ot=n.R16UI),K===n.UNSIGNED_INT&&(ot=n.R32UI),K===n.BYTE&&(ot=n.R8I),K===n.SHORT&&(ot=n.R16I),K===n.INT&&(ot=n.R32I)),S===n.RG&&(K===n.FLOAT&&(ot=n.RG32F),K===n.HALF_FLOAT&&(ot=n.RG16F),K===n.UNSIGNED_BYTE&&(ot=n.RG8),K===n.UNSIGNED_SHORT&&Et&&(ot=Et.RG16_EXT),K===n.SHORT&&Et&&(ot=Et.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(K===n.UNSIGNED_BYTE&&(ot=n.RG8UI),K===n.UNSIGNED_SHORT&&(ot=n.RG16UI),K===n.UNSIGNED_INT&&(ot=n.RG32UI),K===n.BYTE&&(ot=n.RG8I),K===n.SHORT&&(ot=n.RG16I),K===n.INT&&(ot=n.RG32I)),S===n.RGB_INTEGER&&(K===n.UNSIGNED_BYTE&&(ot=n.RGB8UI),K===n.UNSIGNED_SHORT&&(ot=n.RGB16UI),K===n.UNSIGNED_INT&&(ot=n.RGB32UI),K===n.BYTE&&(ot=n.RGB8I),K===n.SHORT&&(ot=n.RGB16I),K===n.INT&&(ot=n.RGB32I)),S===n.RGBA_INTEGER&&(K===n.UNSIGNED_BYTE&&(ot=n.RGBA8UI),K===n.UNSIGNED_SHORT&&(ot=n.RGBA16UI),K===n.UNSIGNED_INT&&(ot=n.RGBA32UI),K===n.BYTE&&(ot=n.RGBA8I),K===n.SHORT&&(ot=n.RGBA16I),K===n.INT&&(ot=n.RGBA32I)),S===n.RGB&&(K===n.UNSIGNED_SHORT&&Et&&(ot=Et.RGB16_EXT),K===n.SHORT&&Et&&(ot=Et.RGB16_SNORM_EXT),K===n.UNSIGNED_INT_5_9_9_9_REV&&(ot=n.RGB9_E5),K===n.UNSIGNED_INT_10F_11F_11F_REV&&(ot=n.R11F_G11F_B10F)),S===n.RGBA){let ct=wt?Ia:Se.getTransfer(dt);K===n.FLOAT&&(ot=n.RGBA32F),K===n.HALF_FLOAT&&(ot=n.RGBA16F),K===n.UNSIGNED_BYTE&&(ot=ct===Ne?n.SRGB8_ALPHA8:n.RGBA8),K===n.UNSIGNED_SHORT&&Et&&(ot=Et.RGBA16_EXT),K===n.SHORT&&Et&&(ot=Et.RGBA16_SNORM_EXT),K===n.UNSIGNED_SHORT_4_4_4_4&&(ot=n.RGBA4),K===n.UNSIGNED_SHORT_5_5_5_1&&(ot=n.RGB5_A1)}return(ot===n.R16F||ot===n.R32F||ot===n.RG16F||ot===n.RG32F||ot===n.RGBA16F||ot===n.RGBA32F)&&t.get("EXT_color_buffer_float"),ot}function _(I,S){let K;return I?S===null||S===Hi||S===Fr?K=n.DEPTH24_STENCIL8:S===Wi?K=n.DEPTH32F_STENCIL8:S===Ho&&(K=n.DEPTH24_STENCIL8,te("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Hi||S===Fr?K=n.DEPTH_COMPONENT24:S===Wi?K=n.DEPTH_COMPONENT32F:S===Ho&&(K=n.DEPTH_COMPONENT16),K}function T(I,S){return M(I)===!0||I.isFramebufferTexture&&I.minFilter!==Ln&&I.minFilter!==jn?Math.log2(Math.max(S.width,S.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?S.mipmaps.length:1}function k(I){let S=new WeakRef(I);i.get(I).__ref=S,m.add(S),x.register(I,S,S)}function D(I){let S=i.get(I).__ref;S!==void 0&&(m.delete(S),x.unregister(S))}function N(I){W(I.target)}function G(I){P(I.target)}function W(I){I.removeEventListener("dispose",N),D(I),Y(I),I.isVideoTexture&&d.delete(I),I.isHTMLTexture&&h.delete(I)}function P(I){I.removeEventListener("dispose",G),D(I),ht(I)}function B(){for(let I of m){let S=I.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):W(S))}m.clear(),h.clear()}function Y(I){let S=i.get(I);if(S.__webglInit===void 0)return;let K=I.source,_t=f.get(K);if(_t){let dt=_t[S.__cacheKey];dt.usedTimes--,dt.usedTimes===0&&H(I),Object.keys(_t).length===0&&f.delete(K)}i.remove(I)}function H(I){let S=i.get(I);n.deleteTexture(S.__webglTexture);let K=I.source,_t=f.get(K);delete _t[S.__cacheKey],o.memory.textures--}function ht(I){let S=i.get(I);S.__depthDisposeCallback&&S.__depthDisposeCallback();let K=I.depthTexture;if(K&&K.renderTarget===I&&W(K),I.isWebGLCubeRenderTarget)for(let dt=0;dt<6;dt++){if(Array.isArray(S.__webglFramebuffer[dt]))for(let wt=0;wt<S.__webglFramebuffer[dt].length;wt++)n.deleteFramebuffer(S.__webglFramebuffer[dt][wt]);else n.deleteFramebuffer(S.__webglFramebuffer[dt]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[dt])}else{if(Array.isArray(S.__webglFramebuffer))for(let dt=0;dt<S.__webglFramebuffer.length;dt++)n.deleteFramebuffer(S.__webglFramebuffer[dt]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let dt=0;dt<S.__webglColorRenderbuffer.length;dt++)S.__webglColorRenderbuffer[dt]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[dt]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let _t=I.textures;for(let dt=0,wt=_t.length;dt<wt;dt++){let Et=i.get(_t[dt]);Et.__webglTexture&&(n.deleteTexture(Et.__webglTexture),o.memory.textures--),i.remove(_t[dt])}i.remove(I)}let U=0;function J(){U=0}function $(){return U}function st(I){U=I}function lt(){let I=U;return I>=s.maxTextures&&te("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),U+=1,I}function Z(I){let S=[];return S.push(I.wrapS),S.push(I.wrapT),S.push(I.wrapR||0),S.push(I.magFilter),S.push(I.minFilter),S.push(I.anisotropy),S.push(I.internalFormat),S.push(I.format),S.push(I.type),S.push(I.generateMipmaps),S.push(I.mipmapsAutoUpdate),S.push(I.premultiplyAlpha),S.push(I.flipY),S.push(I.unpackAlignment),S.push(I.colorSpace),S.join()}function pt(I,S){let K=i.get(I);if(I.isVideoTexture&&$e(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&K.__version!==I.version){let _t=I.image;if(_t===null)te("WebGLRenderer: Texture marked for update but no image data found.");else if(_t.complete===!1)te("WebGLRenderer: Texture marked for update but image is incomplete");else{he(K,I,S);return}}else I.isExternalTexture&&(K.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,K.__webglTexture,n.TEXTURE0+S)}function mt(I,S){let K=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&K.__version!==I.version){he(K,I,S);return}else I.isExternalTexture&&(K.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,K.__webglTexture,n.TEXTURE0+S)}function Mt(I,S){let K=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&K.__version!==I.version){he(K,I,S);return}e.bindTexture(n.TEXTURE_3D,K.__webglTexture,n.TEXTURE0+S)}function tt(I,S){let K=i.get(I);if(I.version>0&&K.__version!==I.version){Ee(K,I,S);return}e.bindTexture(n.TEXTURE_CUBE_MAP,K.__webglTexture,n.TEXTURE0+S)}let xt={[Dc]:n.REPEAT,[as]:n.CLAMP_TO_EDGE,[Nc]:n.MIRRORED_REPEAT},it={[Ln]:n.NEAREST,[Vg]:n.NEAREST_MIPMAP_NEAREST,[hl]:n.NEAREST_MIPMAP_LINEAR,[jn]:n.LINEAR,[fh]:n.LINEAR_MIPMAP_NEAREST,[Is]:n.LINEAR_MIPMAP_LINEAR},rt={[$g]:n.NEVER,[ff]:n.ALWAYS,[Xg]:n.LESS,[uf]:n.LEQUAL,[qg]:n.EQUAL,[df]:n.GEQUAL,[Yg]:n.GREATER,[Zg]:n.NOTEQUAL};function Ft(I,S){if(S.type===Wi&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===jn||S.magFilter===fh||S.magFilter===hl||S.magFilter===Is||S.minFilter===jn||S.minFilter===fh||S.minFilter===hl||S.minFilter===Is)&&te("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(I,n.TEXTURE_WRAP_S,xt[S.wrapS]),n.texParameteri(I,n.TEXTURE_WRAP_T,xt[S.wrapT]),(I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY)&&n.texParameteri(I,n.TEXTURE_WRAP_R,xt[S.wrapR]),n.texParameteri(I,n.TEXTURE_MAG_FILTER,it[S.magFilter]),n.texParameteri(I,n.TEXTURE_MIN_FILTER,it[S.minFilter]),S.compareFunction&&(n.texParameteri(I,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(I,n.TEXTURE_COMPARE_FUNC,rt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Ln||S.minFilter!==hl&&S.minFilter!==Is||S.type===Wi&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let K=t.get("EXT_texture_filter_anisotropic");n.texParameterf(I,K.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function Ut(I,S){let K=!1;I.__webglInit===void 0&&(I.__webglInit=!0,S.addEventListener("dispose",N),k(S));let _t=S.source,dt=f.get(_t);dt===void 0&&(dt={},f.set(_t,dt));let wt=Z(S);if(wt!==I.__cacheKey){dt[wt]===void 0&&(dt[wt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,K=!0),dt[wt].usedTimes++;let Et=dt[I.__cacheKey];Et!==void 0&&(dt[I.__cacheKey].usedTimes--,Et.usedTimes===0&&H(S)),I.__cacheKey=wt,I.__webglTexture=dt[wt].texture}return K}function Lt(I,S,K){return Math.floor(Math.floor(I/K)/S)}function Jt(I,S,K,_t){let wt=I.updateRanges;if(wt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,K,_t,S.data);else{wt.sort((V,ut)=>V.start-ut.start);let Et=0;for(let V=1;V<wt.length;V++){let ut=wt[Et],at=wt[V],Rt=ut.start+ut.count,St=Lt(at.start,S.width,4),At=Lt(ut.start,S.width,4);at.start<=Rt+1&&St===At&&Lt(at.start+at.count-1,S.width,4)===St?ut.count=Math.max(ut.count,at.start+at.count-ut.start):(++Et,wt[Et]=at)}wt.length=Et+1;let ot=e.getParameter(n.UNPACK_ROW_LENGTH),ct=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let V=0,ut=wt.length;V<ut;V++){let at=wt[V],Rt=Math.floor(at.start/4),St=Math.ceil(at.count/4),At=Rt%S.width,Zt=Math.floor(Rt/S.width),ne=St,gt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,At),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,At,Zt,ne,gt,K,_t,S.data)}I.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,ot),e.pixelStorei(n.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function he(I,S,K){let _t=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(_t=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(_t=n.TEXTURE_3D);let dt=Ut(I,S),wt=S.source;e.bindTexture(_t,I.__webglTexture,n.TEXTURE0+K);let Et=i.get(wt);if(wt.version!==Et.__version||dt===!0){if(e.activeTexture(n.TEXTURE0+K),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let gt=Se.getPrimaries(Se.workingColorSpace),$t=S.colorSpace===Ds?null:Se.getPrimaries(S.colorSpace),ie=S.colorSpace===Ds||gt===$t?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie)}e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let ct=y(S.image,!1,s.maxTextureSize);ct=Yt(S,ct);let vt=r.convert(S.format,S.colorSpace),V=r.convert(S.type),ut=w(S.internalFormat,vt,V,S.normalized,S.colorSpace,S.isVideoTexture);Ft(_t,S);let at,Rt=S.mipmaps,St=S.isVideoTexture!==!0,At=Et.__version===void 0||dt===!0,Zt=wt.dataReady,ne=T(S,ct);if(S.isDepthTexture)ut=_(S.format===Ls,S.type),At&&(St?e.texStorage2D(n.TEXTURE_2D,1,ut,ct.width,ct.height):e.texImage2D(n.TEXTURE_2D,0,ut,ct.width,ct.height,0,vt,V,null));else if(S.isDataTexture)if(Rt.length>0){St&&At&&e.texStorage2D(n.TEXTURE_2D,ne,ut,Rt[0].width,Rt[0].height);for(let gt=0,$t=Rt.length;gt<$t;gt++)at=Rt[gt],St?Zt&&e.texSubImage2D(n.TEXTURE_2D,gt,0,0,at.width,at.height,vt,V,at.data):e.texImage2D(n.TEXTURE_2D,gt,ut,at.width,at.height,0,vt,V,at.data);S.generateMipmaps=!1}else St?(At&&e.texStorage2D(n.TEXTURE_2D,ne,ut,ct.width,ct.height),Zt&&Jt(S,ct,vt,V)):e.texImage2D(n.TEXTURE_2D,0,ut,ct.width,ct.height,0,vt,V,ct.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){St&&At&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ne,ut,Rt[0].width,Rt[0].height,ct.depth);for(let gt=0,$t=Rt.length;gt<$t;gt++)if(at=Rt[gt],S.format!==Xi)if(vt!==null)if(St){if(Zt)if(S.layerUpdates.size>0){let ie=wf(at.width,at.height,S.format,S.type);for(let Nt of S.layerUpdates){let pe=at.data.subarray(Nt*ie/at.data.BYTES_PER_ELEMENT,(Nt+1)*ie/at.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,gt,0,0,Nt,at.width,at.height,1,vt,pe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,gt,0,0,0,at.width,at.height,ct.depth,vt,at.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,gt,ut,at.width,at.height,ct.depth,0,at.data,0,0);else te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else St?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,gt,0,0,0,at.width,at.height,ct.depth,vt,V,at.data):e.texImage3D(n.TEXTURE_2D_ARRAY,gt,ut,at.width,at.height,ct.depth,0,vt,V,at.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{St&&At&&e.texStorage2D(n.TEXTURE_2D,ne,ut,Rt[0].width,Rt[0].height);for(let gt=0,$t=Rt.length;gt<$t;gt++)at=Rt[gt],S.format!==Xi?vt!==null?St?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,gt,0,0,at.width,at.height,vt,at.data):e.compressedTexImage2D(n.TEXTURE_2D,gt,ut,at.width,at.height,0,at.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):St?Zt&&e.texSubImage2D(n.TEXTURE_2D,gt,0,0,at.width,at.height,vt,V,at.data):e.texImage2D(n.TEXTURE_2D,gt,ut,at.width,at.height,0,vt,V,at.data)}else if(S.isDataArrayTexture)if(St){if(At&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ne,ut,ct.width,ct.height,ct.depth),Zt)if(S.layerUpdates.size>0){let gt=wf(ct.width,ct.height,S.format,S.type);for(let $t of S.layerUpdates){let ie=ct.data.subarray($t*gt/ct.data.BYTES_PER_ELEMENT,($t+1)*gt/ct.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,$t,ct.width,ct.height,1,vt,V,ie)}S.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ct.width,ct.height,ct.depth,vt,V,ct.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ut,ct.width,ct.height,ct.depth,0,vt,V,ct.data);else if(S.isData3DTexture)St?(At&&e.texStorage3D(n.TEXTURE_3D,ne,ut,ct.width,ct.height,ct.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ct.width,ct.height,ct.depth,vt,V,ct.data)):e.texImage3D(n.TEXTURE_3D,0,ut,ct.width,ct.height,ct.depth,0,vt,V,ct.data);else if(S.isFramebufferTexture){if(At)if(St)e.texStorage2D(n.TEXTURE_2D,ne,ut,ct.width,ct.height);else{let gt=ct.width,$t=ct.height;for(let ie=0;ie<ne;ie++)e.texImage2D(n.TEXTURE_2D,ie,ut,gt,$t,0,vt,V,null),gt>>=1,$t>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let gt=n.canvas;if(gt.hasAttribute("layoutsubtree")||gt.setAttribute("layoutsubtree","true"),ct.parentNode!==gt){gt.appendChild(ct),h.add(S),gt.onpaint=$t=>{let ie=$t.changedElements;for(let Nt of h)ie.includes(Nt.image)&&(Nt.needsUpdate=!0)},gt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ct);else{let ie=n.RGBA,Nt=n.RGBA,pe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ie,Nt,pe,ct)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Rt.length>0){if(St&&At){let gt=Qt(Rt[0]);e.texStorage2D(n.TEXTURE_2D,ne,ut,gt.width,gt.height)}for(let gt=0,$t=Rt.length;gt<$t;gt++)at=Rt[gt],St?Zt&&e.texSubImage2D(n.TEXTURE_2D,gt,0,0,vt,V,at):e.texImage2D(n.TEXTURE_2D,gt,ut,vt,V,at);S.generateMipmaps=!1}else if(St){if(At){let gt=Qt(ct);e.texStorage2D(n.TEXTURE_2D,ne,ut,gt.width,gt.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,V,ct)}else e.texImage2D(n.TEXTURE_2D,0,ut,vt,V,ct);M(S)&&S.mipmapsAutoUpdate===!0&&b(_t),Et.__version=wt.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function Ee(I,S,K){if(S.image.length!==6)return;let _t=Ut(I,S),dt=S.source;e.bindTexture(n.TEXTURE_CUBE_MAP,I.__webglTexture,n.TEXTURE0+K);let wt=i.get(dt);if(dt.version!==wt.__version||_t===!0){e.activeTexture(n.TEXTURE0+K);let Et=Se.getPrimaries(Se.workingColorSpace),ot=S.colorSpace===Ds?null:Se.getPrimaries(S.colorSpace),ct=S.colorSpace===Ds||Et===ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ct);let vt=S.isCompressedTexture||S.image[0].isCompressedTexture,V=S.image[0]&&S.image[0].isDataTexture,ut=[];for(let Nt=0;Nt<6;Nt++)!vt&&!V?ut[Nt]=y(S.image[Nt],!0,s.maxCubemapSize):ut[Nt]=V?S.image[Nt].image:S.image[Nt],ut[Nt]=Yt(S,ut[Nt]);let at=ut[0],Rt=r.convert(S.format,S.colorSpace),St=r.convert(S.type),At=w(S.internalFormat,Rt,St,S.normalized,S.colorSpace),Zt=S.isVideoTexture!==!0,ne=wt.__version===void 0||_t===!0,gt=dt.dataReady,$t=T(S,at);Ft(n.TEXTURE_CUBE_MAP,S);let ie;if(S.isDepthTexture){if(At=_(S.format===Ls,S.type),ne)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,At,at.width,at.height);else for(let Nt=0;Nt<6;Nt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,At,at.width,at.height,0,Rt,St,null)}else if(vt){Zt&&ne&&e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,At,at.width,at.height);for(let Nt=0;Nt<6;Nt++){ie=ut[Nt].mipmaps;for(let pe=0;pe<ie.length;pe++){let Ye=ie[pe];S.format!==Xi?Rt!==null?Zt?gt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe,0,0,Ye.width,Ye.height,Rt,Ye.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe,At,Ye.width,Ye.height,0,Ye.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?gt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe,0,0,Ye.width,Ye.height,Rt,St,Ye.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe,At,Ye.width,Ye.height,0,Rt,St,Ye.data)}}}else{if(ie=S.mipmaps,Zt&&ne){ie.length>0&&$t++;let Nt=Qt(ut[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,At,Nt.width,Nt.height)}for(let Nt=0;Nt<6;Nt++)if(V){Zt?gt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,ut[Nt].width,ut[Nt].height,Rt,St,ut[Nt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,At,ut[Nt].width,ut[Nt].height,0,Rt,St,ut[Nt].data);for(let pe=0;pe<ie.length;pe++){let Wn=ie[pe].image[Nt].image;Zt?gt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe+1,0,0,Wn.width,Wn.height,Rt,St,Wn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe+1,At,Wn.width,Wn.height,0,Rt,St,Wn.data)}}else{Zt?gt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,Rt,St,ut[Nt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,At,Rt,St,ut[Nt]);for(let pe=0;pe<ie.length;pe++){let Ye=ie[pe];Zt?gt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe+1,0,0,Rt,St,Ye.image[Nt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,pe+1,At,Rt,St,Ye.image[Nt])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),wt.__version=dt.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function ve(I,S,K,_t,dt,wt){let Et=r.convert(K.format,K.colorSpace),ot=r.convert(K.type),ct=w(K.internalFormat,Et,ot,K.normalized,K.colorSpace),vt=i.get(S),V=i.get(K);if(V.__renderTarget=S,!vt.__hasExternalTextures){let ut=Math.max(1,S.width>>wt),at=Math.max(1,S.height>>wt);dt===n.TEXTURE_3D||dt===n.TEXTURE_2D_ARRAY?e.texImage3D(dt,wt,ct,ut,at,S.depth,0,Et,ot,null):e.texImage2D(dt,wt,ct,ut,at,0,Et,ot,null)}e.bindFramebuffer(n.FRAMEBUFFER,I),Ct(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,dt,V.__webglTexture,0,ue(S)):(dt===n.TEXTURE_2D||dt>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&dt<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,_t,dt,V.__webglTexture,wt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ge(I,S,K){if(n.bindRenderbuffer(n.RENDERBUFFER,I),S.depthBuffer){let _t=S.depthTexture,dt=_t&&_t.isDepthTexture?_t.type:null,wt=_(S.stencilBuffer,dt),Et=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ue(S),wt,S.width,S.height):K?n.renderbufferStorageMultisample(n.RENDERBUFFER,ue(S),wt,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,wt,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Et,n.RENDERBUFFER,I)}else{let _t=S.textures;for(let dt=0;dt<_t.length;dt++){let wt=_t[dt],Et=r.convert(wt.format,wt.colorSpace),ot=r.convert(wt.type),ct=w(wt.internalFormat,Et,ot,wt.normalized,wt.colorSpace);Ct(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ue(S),ct,S.width,S.height):K?n.renderbufferStorageMultisample(n.RENDERBUFFER,ue(S),ct,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ct,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function de(I,S,K){let _t=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,I),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let dt=i.get(S.depthTexture);dt.__renderTarget=S;let wt=_t?S.depthTexture.image[0]:S.depthTexture.image;(!dt.__webglTexture||wt.width!==S.width||wt.height!==S.height)&&(wt.width=S.width,wt.height=S.height,S.depthTexture.needsUpdate=!0),_t?tt(S.depthTexture,0):pt(S.depthTexture,0);let Et=dt.__webglTexture,ot=ue(S),ct=_t?n.TEXTURE_CUBE_MAP_POSITIVE_X+K:n.TEXTURE_2D,vt=S.depthTexture.format===Ls?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===As)Ct(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,ct,Et,0,ot):n.framebufferTexture2D(n.FRAMEBUFFER,vt,ct,Et,0);else if(S.depthTexture.format===Ls)Ct(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,ct,Et,0,ot):n.framebufferTexture2D(n.FRAMEBUFFER,vt,ct,Et,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function We(I){let S=i.get(I),K=I.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==I.depthTexture){let _t=I.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),_t){let dt=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,_t.removeEventListener("dispose",dt)};_t.addEventListener("dispose",dt),S.__depthDisposeCallback=dt}S.__boundDepthTexture=_t}if(I.depthTexture&&!S.__autoAllocateDepthBuffer)if(K)for(let _t=0;_t<6;_t++)de(S.__webglFramebuffer[_t],I,_t);else I.texture.mipmaps.length>0?de(S.__webglFramebuffer[0],I,0):de(S.__webglFramebuffer,I,0);else if(K){S.__webglDepthbuffer=[];for(let _t=0;_t<6;_t++)if(e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[_t]),S.__webglDepthbuffer[_t]===void 0)S.__webglDepthbuffer[_t]=n.createRenderbuffer(),Ge(S.__webglDepthbuffer[_t],I,!1);else{let dt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=S.__webglDepthbuffer[_t];n.bindRenderbuffer(n.RENDERBUFFER,wt),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,wt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Ge(S.__webglDepthbuffer,I,!1);else{let dt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,wt),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,wt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Oe(I,S,K){let _t=i.get(I);S!==void 0&&ve(_t.__webglFramebuffer,I,I.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),K!==void 0&&We(I)}function on(I){let S=I.texture,K=i.get(I),_t=i.get(S);I.addEventListener("dispose",G),k(I);let dt=I.textures,wt=I.isWebGLCubeRenderTarget===!0,Et=dt.length>1;if(Et||(_t.__webglTexture===void 0&&(_t.__webglTexture=n.createTexture()),_t.__version=S.version,o.memory.textures++),wt){K.__webglFramebuffer=[];for(let ot=0;ot<6;ot++)if(S.mipmaps.length>0){K.__webglFramebuffer[ot]=[];for(let ct=0;ct<S.mipmaps.length;ct++)K.__webglFramebuffer[ot][ct]=n.createFramebuffer()}else K.__webglFramebuffer[ot]=n.createFramebuffer()}else{if(S.mipmaps.length>0){K.__webglFramebuffer=[];for(let ot=0;ot<S.mipmaps.length;ot++)K.__webglFramebuffer[ot]=n.createFramebuffer()}else K.__webglFramebuffer=n.createFramebuffer();if(Et)for(let ot=0,ct=dt.length;ot<ct;ot++){let vt=i.get(dt[ot]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(I.samples>0&&Ct(I)===!1){K.__webglMultisampledFramebuffer=n.createFramebuffer(),K.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,K.__webglMultisampledFramebuffer);for(let ot=0;ot<dt.length;ot++){let ct=dt[ot];K.__webglColorRenderbuffer[ot]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,K.__webglColorRenderbuffer[ot]);let vt=r.convert(ct.format,ct.colorSpace),V=r.convert(ct.type),ut=w(ct.internalFormat,vt,V,ct.normalized,ct.colorSpace,I.isXRRenderTarget===!0),at=ue(I);n.renderbufferStorageMultisample(n.RENDERBUFFER,at,ut,I.width,I.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ot,n.RENDERBUFFER,K.__webglColorRenderbuffer[ot])}n.bindRenderbuffer(n.RENDERBUFFER,null),I.depthBuffer&&(K.__webglDepthRenderbuffer=n.createRenderbuffer(),Ge(K.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(wt){e.bindTexture(n.TEXTURE_CUBE_MAP,_t.__webglTexture),Ft(n.TEXTURE_CUBE_MAP,S);for(let ot=0;ot<6;ot++)if(S.mipmaps.length>0)for(let ct=0;ct<S.mipmaps.length;ct++)ve(K.__webglFramebuffer[ot][ct],I,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ot,ct);else ve(K.__webglFramebuffer[ot],I,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ot,0);M(S)?b(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(Et){for(let ot=0,ct=dt.length;ot<ct;ot++){let vt=dt[ot],V=i.get(vt),ut=n.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ut=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,V.__webglTexture),Ft(ut,vt),ve(K.__webglFramebuffer,I,vt,n.COLOR_ATTACHMENT0+ot,ut,0),M(vt)&&b(ut)}e.unbindTexture()}else{let ot=n.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ot=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,_t.__webglTexture),Ft(ot,S),S.mipmaps.length>0)for(let ct=0;ct<S.mipmaps.length;ct++)ve(K.__webglFramebuffer[ct],I,S,n.COLOR_ATTACHMENT0,ot,ct);else ve(K.__webglFramebuffer,I,S,n.COLOR_ATTACHMENT0,ot,0);M(S)?b(ot):S.mipmaps.length>0&&n.texParameteri(ot,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&We(I)}function z(I){let S=I.textures;for(let K=0,_t=S.length;K<_t;K++){let dt=S[K];if(M(dt)&&dt.mipmapsAutoUpdate===!0){let wt=R(I),Et=i.get(dt).__webglTexture;e.bindTexture(wt,Et),b(wt),e.unbindTexture()}}}let Dt=[];function jt(I){if(I.samples>0){if(Ct(I)===!1){let S=I.textures,K=I.width,_t=I.height,dt=n.COLOR_BUFFER_BIT,wt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Et=i.get(I),ot=S.length>1;if(ot)for(let vt=0;vt<S.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Et.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Et.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Et.__webglFramebuffer);for(let vt=0;vt<S.length;vt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(dt|=n.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(dt|=n.STENCIL_BUFFER_BIT)),ot){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Et.__webglColorRenderbuffer[vt]);let V=i.get(S[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,K,_t,0,0,K,_t,dt,n.NEAREST),c===!0&&(Dt.length=0,Dt.push(n.COLOR_ATTACHMENT0+vt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Dt.push(wt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Dt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ot)for(let vt=0;vt<S.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,Et.__webglColorRenderbuffer[vt]);let V=i.get(S[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,V,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Et.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&c){let S=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ue(I){return Math.min(s.maxSamples,I.samples)}function Ct(I){let S=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function $e(I){let S=o.render.frame;d.get(I)!==S&&(d.set(I,S),I.update())}function Yt(I,S){let K=I.colorSpace,_t=I.format,dt=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||K!==Pa&&K!==Ds&&(Se.getTransfer(K)===Ne?(_t!==Xi||dt!==ni)&&te("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",K)),S}function Qt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=lt,this.resetTextureUnits=J,this.getTextureUnits=$,this.setTextureUnits=st,this.setTexture2D=pt,this.setTexture2DArray=mt,this.setTexture3D=Mt,this.setTextureCube=tt,this.rebindTextures=Oe,this.setupRenderTarget=on,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=We,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=Ct,this.dispose=B}function AE(n,t){function e(i,s=Ds){let r,o=Se.getTransfer(s);if(i===ni)return n.UNSIGNED_BYTE;if(i===mh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===gh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===of)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===af)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===sf)return n.BYTE;if(i===rf)return n.SHORT;if(i===Ho)return n.UNSIGNED_SHORT;if(i===ph)return n.INT;if(i===Hi)return n.UNSIGNED_INT;if(i===Wi)return n.FLOAT;if(i===$i)return n.HALF_FLOAT;if(i===lf)return n.ALPHA;if(i===cf)return n.RGB;if(i===Xi)return n.RGBA;if(i===As)return n.DEPTH_COMPONENT;if(i===Ls)return n.DEPTH_STENCIL;if(i===hf)return n.RED;if(i===_h)return n.RED_INTEGER;if(i===ur)return n.RG;if(i===xh)return n.RG_INTEGER;if(i===yh)return n.RGBA_INTEGER;if(i===ul||i===dl||i===fl||i===pl)if(o===Ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ul)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ul)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===vh||i===bh||i===Mh||i===Sh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===vh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===bh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Mh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Sh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===wh||i===Eh||i===Th||i===Ah||i===Ch||i===ml||i===Rh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===wh||i===Eh)return o===Ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Th)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ah)return r.COMPRESSED_R11_EAC;if(i===Ch)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ml)return r.COMPRESSED_RG11_EAC;if(i===Rh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Fh||i===Uh||i===Oh||i===kh||i===Bh||i===zh||i===Vh||i===Gh||i===Hh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ph)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ih)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Lh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Dh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Nh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Fh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Uh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Oh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===kh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Bh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===zh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Vh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Gh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Hh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Wh||i===$h||i===Xh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Wh)return o===Ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===$h)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Xh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===qh||i===Yh||i===gl||i===Zh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===qh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Yh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===gl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Zh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var CE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Df=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Va(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new hs({vertexShader:CE,fragmentShader:RE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Fe(new Ir(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Nf=class extends zi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,d=null,h=null,u=null,f=null,m=null,x=typeof XRWebGLBinding<"u",p=new Df,g={},y=e.getContextAttributes(),M=null,b=null,R=[],w=[],_=new Ot,T=null,k=null,D=new Kn;D.viewport=new nn;let N=new Kn;N.viewport=new nn;let G=[D,N],W=new ch,P=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let pt=R[Z];return pt===void 0&&(pt=new Do,R[Z]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(Z){let pt=R[Z];return pt===void 0&&(pt=new Do,R[Z]=pt),pt.getGripSpace()},this.getHand=function(Z){let pt=R[Z];return pt===void 0&&(pt=new Do,R[Z]=pt),pt.getHandSpace()};function Y(Z){let pt=w.indexOf(Z.inputSource);if(pt===-1)return;let mt=R[pt];mt!==void 0&&(mt.update(Z.inputSource,Z.frame,l||o),mt.dispatchEvent({type:Z.type,data:Z.inputSource}))}function H(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ht);for(let Z=0;Z<R.length;Z++){let pt=w[Z];pt!==null&&(w[Z]=null,R[Z].disconnect(pt))}P=null,B=null,p.reset();for(let Z in g)delete g[Z];if(t.setRenderTarget(M),f=null,u=null,h=null,s=null,b=null,lt.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),k!==null){let Z=k.camera;Z.fov=k.fov,Z.zoom=k.zoom,Z.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&te("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,i.isPresenting===!0&&te("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(Z){l=Z},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ht),y.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let mt=null,Mt=null,tt=null;y.depth&&(tt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,mt=y.stencil?Ls:As,Mt=y.stencil?Fr:Hi);let xt={colorFormat:e.RGBA8,depthFormat:tt,scaleFactor:r};h=this.getBinding(),u=h.createProjectionLayer(xt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),b=new pi(u.textureWidth,u.textureHeight,{format:Xi,type:ni,depthTexture:new Rs(u.textureWidth,u.textureHeight,Mt,void 0,void 0,void 0,void 0,void 0,void 0,mt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let mt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,mt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new pi(f.framebufferWidth,f.framebufferHeight,{format:Xi,type:ni,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),lt.setContext(s),lt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ht(Z){for(let pt=0;pt<Z.removed.length;pt++){let mt=Z.removed[pt],Mt=w.indexOf(mt);Mt>=0&&(w[Mt]=null,R[Mt].disconnect(mt))}for(let pt=0;pt<Z.added.length;pt++){let mt=Z.added[pt],Mt=w.indexOf(mt);if(Mt===-1){for(let xt=0;xt<R.length;xt++)if(xt>=w.length){w.push(mt),Mt=xt;break}else if(w[xt]===null){w[xt]=mt,Mt=xt;break}if(Mt===-1)break}let tt=R[Mt];tt&&tt.connect(mt)}}function U(Z,pt){pt===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(pt.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let pt=Z.near,mt=Z.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(mt=p.depthFar)),W.near=N.near=D.near=pt,W.far=N.far=D.far=mt,(P!==W.near||B!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),P=W.near,B=W.far),W.layers.mask=Z.layers.mask|6,D.layers.mask=W.layers.mask&-5,N.layers.mask=W.layers.mask&-3;let Mt=Z.parent,tt=W.cameras;U(W,Mt);for(let xt=0;xt<tt.length;xt++)U(tt[xt],Mt);W.projectionMatrix.copy(D.projectionMatrix),W.projectionMatrixInverse.copy(D.projectionMatrixInverse),k===null&&Z.isPerspectiveCamera&&(k={camera:Z,fov:Z.fov,zoom:Z.zoom}),J(Z,W,Mt)};function J(Z,pt,mt){mt===null?Z.matrix.copy(pt.matrixWorld):(Z.matrix.copy(mt.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(pt.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(pt.projectionMatrix),Z.projectionMatrixInverse.copy(pt.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Po*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(u===null&&f===null))return c},this.setFoveation=function(Z){c=Z,u!==null&&(u.fixedFoveation=Z),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Z)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(W)},this.getCameraTexture=function(Z){return g[Z]};let $=null;function st(Z,pt){if(d=pt.getViewerPose(l||o),m=pt,d!==null){let mt=d.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Mt=!1;mt.length!==W.cameras.length&&(W.cameras.length=0,Mt=!0);for(let rt=0;rt<mt.length;rt++){let Ft=mt[rt],Ut=null;if(f!==null)Ut=f.getViewport(Ft);else{let Jt=h.getViewSubImage(u,Ft);Ut=Jt.viewport,rt===0&&(t.setRenderTargetTextures(b,Jt.colorTexture,Jt.depthStencilTexture),t.setRenderTarget(b))}let Lt=G[rt];Lt===void 0&&(Lt=new Kn,Lt.layers.enable(rt),Lt.viewport=new nn,G[rt]=Lt),Lt.matrix.fromArray(Ft.transform.matrix),Lt.matrix.decompose(Lt.position,Lt.quaternion,Lt.scale),Lt.projectionMatrix.fromArray(Ft.projectionMatrix),Lt.projectionMatrixInverse.copy(Lt.projectionMatrix).invert(),Lt.viewport.set(Ut.x,Ut.y,Ut.width,Ut.height),rt===0&&(W.matrix.copy(Lt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Mt===!0&&W.cameras.push(Lt)}let tt=s.enabledFeatures;if(tt&&tt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let rt=h.getDepthInformation(mt[0]);rt&&rt.isValid&&rt.texture&&p.init(rt,s.renderState)}if(tt&&tt.includes("camera-access")&&x){t.state.unbindTexture(),h=i.getBinding();for(let rt=0;rt<mt.length;rt++){let Ft=mt[rt].camera;if(Ft){let Ut=g[Ft];Ut||(Ut=new Va,g[Ft]=Ut);let Lt=h.getCameraImage(Ft);Ut.sourceTexture=Lt}}}}for(let mt=0;mt<R.length;mt++){let Mt=w[mt],tt=R[mt];Mt!==null&&tt!==void 0&&tt.update(Mt,pt,l||o)}$&&$(Z,pt),pt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:pt}),m=null}let lt=new L0;lt.setAnimationLoop(st),this.setAnimationLoop=function(Z){$=Z},this.dispose=function(){}}},PE=new Ve,G0=new ae;G0.set(-1,0,0,0,1,0,0,0,1);function IE(n,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,bf(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,y,M,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),h(p,g)):g.isMeshPhongMaterial?(r(p,g),d(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),u(p,g),g.isMeshPhysicalMaterial&&f(p,g,b)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),x(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?c(p,g,y,M):g.isSpriteMaterial?l(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===Qn&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===Qn&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let y=t.get(g),M=y.envMap,b=y.envMapRotation;M&&(p.envMap.value=M,p.envMapRotation.value.setFromMatrix4(PE.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(G0),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function c(p,g,y,M){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*y,p.scale.value=M*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function l(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function d(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function h(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function u(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,y){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Qn&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=y.texture,p.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function x(p,g){let y=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(y.matrixWorld),p.nearDistance.value=y.shadow.camera.near,p.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function LE(n,t,e,i){let s={},r={};function o(y,M){let b=M.program;i.uniformBlockBinding(y,b,s[y.id])}function a(y,M){let b=s[y.id];b===void 0&&(m(y),b=c(y),s[y.id]=b,y.addEventListener("dispose",p));let R=M.program;i.updateUBOMapping(y,R);let w=t.render.frame;r[y.id]!==w&&(l(y),r[y.id]=w)}function c(y){let M=n.createBuffer(),b=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,b,R),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function l(y){let M=s[y.id],b=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let w=0,_=b.length;w<_;w++){let T=b[w];if(Array.isArray(T))for(let k=0,D=T.length;k<D;k++)d(T[k],w,k,R);else d(T,w,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(y,M,b,R){if(u(y,M,b,R)===!0){let w=y.__offset,_=y.value;if(Array.isArray(_)){let T=0;for(let k=0;k<_.length;k++){let D=_[k],N=x(D,!0);h(D,y.__data,T),T+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,y.__data)}}function h(y,M,b){typeof y=="number"||typeof y=="boolean"?M[b]=y:y.isMatrix3?(M[b]=y.elements[0],M[b+1]=y.elements[1],M[b+2]=y.elements[2],M[b+3]=0,M[b+4]=y.elements[3],M[b+5]=y.elements[4],M[b+6]=y.elements[5],M[b+7]=0,M[b+8]=y.elements[6],M[b+9]=y.elements[7],M[b+10]=y.elements[8],M[b+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-b),b):y.toArray(M,b)}function u(y,M,b,R){let w=y.value,_=M+"_"+b;if(Array.isArray(w)){R[_]===void 0&&(R[_]=[]);let T=R[_],k=!1;for(let D=0;D<w.length;D++)f(w[D],T,D)===!0&&(k=!0);return k}return f(w,R,_)}function f(y,M,b){if(M[b]===void 0)return typeof y=="number"||typeof y=="boolean"?M[b]=y:ArrayBuffer.isView(y)?M[b]=y.slice():M[b]=y.clone(),!0;{let R=M[b];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return M[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function m(y){let M=y.uniforms,b=0,R=16;for(let _=0,T=M.length;_<T;_++){let k=Array.isArray(M[_])?M[_]:[M[_]];for(let D=0,N=k.length;D<N;D++){let G=k[D],W=Array.isArray(G.value)?G.value:[G.value],P=Array.isArray(M[_])||Array.isArray(G.value),B=b;for(let H=0,ht=W.length;H<ht;H++){let U=W[H],J=x(U,P),$=b%R,st=$%J.boundary,lt=$+st;b+=st,lt!==0&&R-lt<J.storage&&(b+=R-lt),H===0&&(B=b),b+=J.storage}let Y=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Y((b-B)/Float32Array.BYTES_PER_ELEMENT),G.__offset=B}}let w=b%R;return w>0&&(b+=R-w),y.__size=b,y.__cache={},this}function x(y,M){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?te("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):te("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(y){let M=y.target;M.removeEventListener("dispose",p),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var DE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ds=null;function NE(){return ds===null&&(ds=new Bc(DE,16,16,ur,$i),ds.name="DFG_LUT",ds.minFilter=jn,ds.magFilter=jn,ds.wrapS=as,ds.wrapT=as,ds.generateMipmaps=!1,ds.needsUpdate=!0),ds}var tu=class{constructor(t={}){let{canvas:e=Kg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:d="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ni}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=f,p=new Set([yh,xh,_h]),g=new Set([ni,Hi,Ho,Fr,mh,gh]),y=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},R=null,w=null,_=[],T=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=us,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,N=!1,G=null,W=null,P=null,B=null;this._outputColorSpace=di;let Y=0,H=0,ht=null,U=-1,J=null,$=new nn,st=new nn,lt=null,Z=new ce(0),pt=0,mt=e.width,Mt=e.height,tt=1,xt=null,it=null,rt=new nn(0,0,mt,Mt),Ft=new nn(0,0,mt,Mt),Ut=!1,Lt=new nr,Jt=new zc,he=!1,Ee=!1,ve=new Ve,Ge=new O,de=new nn,We={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Oe=!1;function on(){return ht===null?tt:1}let z=i;function Dt(A,X){return e.getContext(A,X)}let jt,ue,Ct,$e,Yt,Qt,I,S,K,_t,dt,wt,Et,ot,ct,vt,V,ut,at,Rt,St,At,Zt;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:d,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",$t,!1),e.addEventListener("webglcontextrestored",ie,!1),e.addEventListener("webglcontextcreationerror",Nt,!1),z===null){let X="webgl2";if(z=Dt(X,A),z===null)throw Dt(X)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ne()}catch(A){throw e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",ie,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),se("WebGLRenderer: "+A.message),A}function ne(){jt=new $w(z),jt.init(),St=new AE(z,jt),ue=new Nw(z,jt,t,St),Ct=new EE(z,jt),ue.reversedDepthBuffer&&u&&Ct.buffers.depth.setReversed(!0),W=z.createFramebuffer(),P=z.createFramebuffer(),B=z.createFramebuffer(),$e=new Yw(z),Yt=new uE,Qt=new TE(z,jt,Ct,Yt,ue,St,$e),I=new Ww(D),S=new Jb(z),At=new Lw(z,S),K=new Xw(z,S,$e,At),_t=new Jw(z,K,S,At,$e),ut=new Zw(z,ue,Qt),ct=new Fw(Yt),dt=new hE(D,I,jt,ue,At,ct),wt=new IE(D,Yt),Et=new fE,ot=new yE(jt),V=new Iw(D,I,Ct,_t,m,c),vt=new wE(D,_t,ue),Zt=new LE(z,$e,ue,Ct),at=new Dw(z,jt,$e),Rt=new qw(z,jt,$e),$e.programs=dt.programs,D.capabilities=ue,D.extensions=jt,D.properties=Yt,D.renderLists=Et,D.shadowMap=vt,D.state=Ct,D.info=$e}x!==ni&&(k=new jw(x,e.width,e.height,a,s,r));let gt=new Nf(D,z);this.xr=gt,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let A=jt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=jt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(A){A!==void 0&&(tt=A,this.setSize(mt,Mt,!1))},this.getSize=function(A){return A.set(mt,Mt)},this.setSize=function(A,X,nt=!0){if(gt.isPresenting){te("WebGLRenderer: Can't change size while VR device is presenting.");return}mt=A,Mt=X,e.width=Math.floor(A*tt),e.height=Math.floor(X*tt),nt===!0&&(e.style.width=A+"px",e.style.height=X+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,A,X)},this.getDrawingBufferSize=function(A){return A.set(mt*tt,Mt*tt).floor()},this.setDrawingBufferSize=function(A,X,nt){mt=A,Mt=X,tt=nt,e.width=Math.floor(A*nt),e.height=Math.floor(X*nt),this.setViewport(0,0,A,X)},this.setEffects=function(A){if(x===ni){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let X=0;X<A.length;X++)if(A[X].isOutputPass===!0){te("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy($)},this.getViewport=function(A){return A.copy(rt)},this.setViewport=function(A,X,nt,j){A.isVector4?rt.set(A.x,A.y,A.z,A.w):rt.set(A,X,nt,j),Ct.viewport($.copy(rt).multiplyScalar(on()).round())},this.getScissor=function(A){return A.copy(Ft)},this.setScissor=function(A,X,nt,j){A.isVector4?Ft.set(A.x,A.y,A.z,A.w):Ft.set(A,X,nt,j),Ct.scissor(st.copy(Ft).multiplyScalar(on()).round())},this.getScissorTest=function(){return Ut},this.setScissorTest=function(A){Ct.setScissorTest(Ut=A)},this.setOpaqueSort=function(A){xt=A},this.setTransparentSort=function(A){it=A},this.getClearColor=function(A){return A.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(A=!0,X=!0,nt=!0){let j=0;if(A){let Q=!1;if(ht!==null){let Pt=ht.texture.format;Q=p.has(Pt)}if(Q){let Pt=ht.texture.type,kt=g.has(Pt),It=V.getClearColor(),Bt=V.getClearAlpha(),qt=It.r,re=It.g,_e=It.b;kt?(y[0]=qt,y[1]=re,y[2]=_e,y[3]=Bt,z.clearBufferuiv(z.COLOR,0,y)):(M[0]=qt,M[1]=re,M[2]=_e,M[3]=Bt,z.clearBufferiv(z.COLOR,0,M))}else j|=z.COLOR_BUFFER_BIT}X&&(j|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&(j|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),j!==0&&z.clear(j)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),G=A},this.dispose=function(){e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",ie,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),V.dispose(),Et.dispose(),ot.dispose(),Qt.dispose(),Yt.dispose(),I.dispose(),_t.dispose(),K.dispose(),At.dispose(),Zt.dispose(),dt.dispose(),gt.dispose(),gt.removeEventListener("sessionstart",Fl),gt.removeEventListener("sessionend",Ki),gs.stop()};function $t(A){A.preventDefault(),mf("WebGLRenderer: Context Lost."),N=!0}function ie(){mf("WebGLRenderer: Context Restored."),N=!1;let A=$e.autoReset,X=vt.enabled,nt=vt.autoUpdate,j=vt.needsUpdate,Q=vt.type;ne(),$e.autoReset=A,vt.enabled=X,vt.autoUpdate=nt,vt.needsUpdate=j,vt.type=Q}function Nt(A){se("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function pe(A){let X=A.target;X.removeEventListener("dispose",pe),Ye(X)}function Ye(A){Wn(A),Yt.remove(A)}function Wn(A){let X=Yt.get(A).programs;X!==void 0&&(X.forEach(function(nt){dt.releaseProgram(nt)}),A.isShaderMaterial&&dt.releaseShaderCache(A))}this.renderBufferDirect=function(A,X,nt,j,Q,Pt){X===null&&(X=We);let kt=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,It=ha(A,X,nt,j,Q);Ct.setMaterial(j,kt);let Bt=nt.index,qt=1;if(j.wireframe===!0){if(Bt=K.getWireframeAttribute(nt),Bt===void 0)return;qt=2}let re=nt.drawRange,_e=nt.attributes.position,Xt=re.start*qt,xe=(re.start+re.count)*qt;Pt!==null&&(Xt=Math.max(Xt,Pt.start*qt),xe=Math.min(xe,(Pt.start+Pt.count)*qt)),Bt!==null?(Xt=Math.max(Xt,0),xe=Math.min(xe,Bt.count)):_e!=null&&(Xt=Math.max(Xt,0),xe=Math.min(xe,_e.count));let sn=xe-Xt;if(sn<0||sn===1/0)return;At.setup(Q,j,It,nt,Bt);let ke,Be=at;if(Bt!==null&&(ke=S.get(Bt),Be=Rt,Be.setIndex(ke)),Q.isMesh)j.wireframe===!0?(Ct.setLineWidth(j.wireframeLinewidth*on()),Be.setMode(z.LINES)):Be.setMode(z.TRIANGLES);else if(Q.isLine){let yn=j.linewidth;yn===void 0&&(yn=1),Ct.setLineWidth(yn*on()),Q.isLineSegments?Be.setMode(z.LINES):Q.isLineLoop?Be.setMode(z.LINE_LOOP):Be.setMode(z.LINE_STRIP)}else Q.isPoints?Be.setMode(z.POINTS):Q.isSprite&&Be.setMode(z.TRIANGLES);if(Q.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))Be.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let yn=Q._multiDrawStarts,Ht=Q._multiDrawCounts,fn=Q._multiDrawCount,Me=Bt?S.get(Bt).bytesPerElement:1,xs=Yt.get(j).currentProgram.getUniforms();for(let pn=0;pn<fn;pn++)xs.setValue(z,"_gl_DrawID",pn),Be.render(yn[pn]/Me,Ht[pn])}else if(Q.isInstancedMesh)Be.renderInstances(Xt,sn,Q.count);else if(nt.isInstancedBufferGeometry){let yn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Ht=Math.min(nt.instanceCount,yn);Be.renderInstances(Xt,sn,Ht)}else Be.render(Xt,sn)};function aa(A,X,nt,j){G!==null&&A.isNodeMaterial&&G.setObject(j,A),he===!0&&ct.setState(A,nt,!1),A.transparent===!0&&A.side===Ci&&A.forceSinglePass===!1?(A.side=Qn,A.needsUpdate=!0,ji(A,X,j),A.side=hr,A.needsUpdate=!0,ji(A,X,j),A.side=Ci):ji(A,X,j)}this.compile=function(A,X,nt=null){nt===null&&(nt=A),G!==null&&G.renderStart(A,X,nt),w=ot.get(nt),w.init(X),T.push(w),nt.traverseVisible(function(Q){Q.isLight&&Q.layers.test(X.layers)&&(w.pushLight(Q),Q.castShadow&&w.pushShadow(Q))}),A!==nt&&A.traverseVisible(function(Q){Q.isLight&&Q.layers.test(X.layers)&&(w.pushLight(Q),Q.castShadow&&w.pushShadow(Q))}),w.setupLights(),G!==null&&G.updateLights(w.state.lightsArray),Ee=this.localClippingEnabled,he=ct.init(this.clippingPlanes,Ee),he===!0&&ct.setGlobalState(this.clippingPlanes,X),G!==null&&vt.render(w.state.shadowsArray,nt,X);let j=new Set;return A.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Pt=Q.material;if(Pt)if(Array.isArray(Pt))for(let kt=0;kt<Pt.length;kt++){let It=Pt[kt];aa(It,nt,X,Q),j.add(It)}else aa(Pt,nt,X,Q),j.add(Pt)}),w=T.pop(),G!==null&&G.renderEnd(),j},this.compileAsync=function(A,X,nt=null){let j=this.compile(A,X,nt);return new Promise(Q=>{function Pt(){if(j.forEach(function(kt){let Bt=Yt.get(kt).currentProgram;(Bt===void 0||Bt.isReady())&&j.delete(kt)}),j.size===0){Q(A);return}setTimeout(Pt,10)}jt.get("KHR_parallel_shader_compile")!==null?Pt():setTimeout(Pt,10)})};let $r=null;function Uu(A){$r&&$r(A)}function Fl(){gs.stop()}function Ki(){gs.start()}let gs=new L0;gs.setAnimationLoop(Uu),typeof self<"u"&&gs.setContext(self),this.setAnimationLoop=function(A){$r=A,gt.setAnimationLoop(A),A===null?gs.stop():gs.start()},gt.addEventListener("sessionstart",Fl),gt.addEventListener("sessionend",Ki),this.render=function(A,X){if(X!==void 0&&X.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;G!==null&&G.renderStart(A,X);let nt=gt.enabled===!0&&gt.isPresenting===!0,j=k!==null&&(ht===null||nt)&&k.begin(D,ht);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),X.parent===null&&X.matrixWorldAutoUpdate===!0&&X.updateMatrixWorld(),gt.enabled===!0&&gt.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(gt.cameraAutoUpdate===!0&&gt.updateCamera(X),X=gt.getCamera()),A.isScene===!0&&A.onBeforeRender(D,A,X,ht),w=ot.get(A,T.length),w.init(X),w.state.textureUnits=Qt.getTextureUnits(),T.push(w),ve.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),X.isArrayCamera?Jt.setFromArrayCamera(X):Lt.setFromProjectionMatrix(ve,Ti,X.reversedDepth),Ee=this.localClippingEnabled,he=ct.init(this.clippingPlanes,Ee),R=Et.get(A,_.length),R.init(),_.push(R),this.info.render.frame++,gt.enabled===!0&&gt.isPresenting===!0){let kt=D.xr.getDepthSensingMesh();kt!==null&&_s(kt,X,-1/0,D.sortObjects)}_s(A,X,0,D.sortObjects),R.finish(),G!==null&&G.updateLights(w.state.lightsArray),D.sortObjects===!0&&R.sort(xt,it),Oe=gt.enabled===!1||gt.isPresenting===!1||gt.hasDepthSensing()===!1,Oe&&V.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),he===!0&&ct.beginShadows();let Q=w.state.shadowsArray;if(vt.render(Q,A,X),he===!0&&ct.endShadows(),(j&&k.hasRenderPass())===!1){let kt=R.opaque,It=R.transmissive;if(w.setupLights(),X.isArrayCamera){let Bt=X.cameras;if(It.length>0)for(let qt=0,re=Bt.length;qt<re;qt++){let _e=Bt[qt];Ii(kt,It,A,_e)}Oe&&V.render(A);for(let qt=0,re=Bt.length;qt<re;qt++){let _e=Bt[qt];la(R,A,_e,_e.viewport)}}else It.length>0&&Ii(kt,It,A,X),Oe&&V.render(A),la(R,A,X)}ht!==null&&H===0&&(Qt.updateMultisampleRenderTarget(ht),Qt.updateRenderTargetMipmap(ht)),j&&k.end(D),A.isScene===!0&&A.onAfterRender(D,A,X),At.resetDefaultState(),U=-1,J=null,T.pop(),T.length>0?(w=T[T.length-1],Qt.setTextureUnits(w.state.textureUnits),he===!0&&ct.setGlobalState(D.clippingPlanes,w.state.camera)):w=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,G!==null&&G.renderEnd()};function _s(A,X,nt,j){if(A.visible===!1)return;if(A.layers.test(X.layers)){if(A.isGroup)nt=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(X);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){let kt=X.isArrayCamera?Jt:Lt;if(!A.frustumCulled||A.intersectsFrustum(kt)){j&&de.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ve);let It=_t.update(A),Bt=A.material;Bt.visible&&R.push(A,It,Bt,nt,de.z,null,X)}}else if(A.isMesh||A.isLine||A.isPoints){let kt=X.isArrayCamera?Jt:Lt;if(!A.frustumCulled||A.intersectsFrustum(kt)){let It=_t.update(A),Bt=A.material;if(j&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),de.copy(A.boundingSphere.center)):(It.boundingSphere===null&&It.computeBoundingSphere(),de.copy(It.boundingSphere.center)),de.applyMatrix4(A.matrixWorld).applyMatrix4(ve)),Array.isArray(Bt)){let qt=It.groups;for(let re=0,_e=qt.length;re<_e;re++){let Xt=qt[re],xe=Bt[Xt.materialIndex];xe&&xe.visible&&R.push(A,It,xe,nt,de.z,Xt,X)}}else Bt.visible&&R.push(A,It,Bt,nt,de.z,null,X)}}}let Pt=A.children;for(let kt=0,It=Pt.length;kt<It;kt++)_s(Pt[kt],X,nt,j)}function la(A,X,nt,j){let{opaque:Q,transmissive:Pt,transparent:kt}=A;w.setupLightsView(nt),he===!0&&ct.setGlobalState(D.clippingPlanes,nt),j&&Ct.viewport($.copy(j)),Q.length>0&&an(Q,X,nt),Pt.length>0&&an(Pt,X,nt),kt.length>0&&an(kt,X,nt),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function Ii(A,X,nt,j){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[j.id]===void 0){let Xt=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[j.id]=new pi(1,1,{generateMipmaps:!0,type:Xt?$i:ni,minFilter:Is,samples:Math.max(4,ue.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let Pt=w.state.transmissionRenderTarget[j.id],kt=j.viewport||$;Pt.setSize(kt.z*D.transmissionResolutionScale,kt.w*D.transmissionResolutionScale);let It=D.getRenderTarget(),Bt=D.getActiveCubeFace(),qt=D.getActiveMipmapLevel();D.setRenderTarget(Pt),D.getClearColor(Z),pt=D.getClearAlpha(),pt<1&&D.setClearColor(16777215,.5),D.clear(),Oe&&V.render(nt);let re=D.toneMapping;D.toneMapping=us;let _e=j.viewport;if(j.viewport!==void 0&&(j.viewport=void 0),w.setupLightsView(j),he===!0&&ct.setGlobalState(D.clippingPlanes,j),an(A,nt,j),Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt),jt.has("WEBGL_multisampled_render_to_texture")===!1){let Xt=!1;for(let xe=0,sn=X.length;xe<sn;xe++){let ke=X[xe],{object:Be,geometry:yn,material:Ht,group:fn}=ke;if(Ht.side===Ci&&Be.layers.test(j.layers)){let Me=Ht.side;Ht.side=Qn,Ht.needsUpdate=!0,un(Be,nt,j,yn,Ht,fn),Ht.side=Me,Ht.needsUpdate=!0,Xt=!0}}Xt===!0&&(Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt))}D.setRenderTarget(It,Bt,qt),D.setClearColor(Z,pt),_e!==void 0&&(j.viewport=_e),D.toneMapping=re}function an(A,X,nt){let j=X.isScene===!0?X.overrideMaterial:null;for(let Q=0,Pt=A.length;Q<Pt;Q++){let kt=A[Q],{object:It,geometry:Bt,group:qt}=kt,re=kt.material;re.allowOverride===!0&&j!==null&&(re=j),It.layers.test(nt.layers)&&un(It,X,nt,Bt,re,qt)}}function un(A,X,nt,j,Q,Pt){G!==null&&Q.isNodeMaterial&&G.setObject(A,Q),A.onBeforeRender(D,X,nt,j,Q,Pt),A.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Q.onBeforeRender(D,X,nt,j,A,Pt),Q.transparent===!0&&Q.side===Ci&&Q.forceSinglePass===!1?(Q.side=Qn,Q.needsUpdate=!0,D.renderBufferDirect(nt,X,j,Q,A,Pt),Q.side=hr,Q.needsUpdate=!0,D.renderBufferDirect(nt,X,j,Q,A,Pt),Q.side=Ci):D.renderBufferDirect(nt,X,j,Q,A,Pt),A.onAfterRender(D,X,nt,j,Q,Pt)}function dn(A){let X=0;for(let nt of A)nt.texture!==null&&X++;return X}function ji(A,X,nt){X.isScene!==!0&&(X=We);let j=Yt.get(A),Q=w.state.lights,Pt=w.state.shadowsArray,kt=Q.state.version,It=dt.getParameters(A,Q.state,Pt,X,nt,w.state.lightProbeGridArray),Bt=dt.getProgramCacheKey(It),qt=j.programs;j.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?X.environment:null,j.fog=X.fog;let re=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;j.envMap=I.get(A.envMap||j.environment,re),j.envMapRotation=j.environment!==null&&A.envMap===null?X.environmentRotation:A.envMapRotation,qt===void 0&&(A.addEventListener("dispose",pe),qt=new Map,j.programs=qt,j.programVariants=new Map);let _e=qt.get(Bt);if(_e!==void 0){if(j.currentProgram===_e&&j.lightsStateVersion===kt)return ca(A,It),_e}else It.uniforms=dt.getUniforms(A),G!==null&&A.isNodeMaterial&&G.build(A,nt,It),A.onBeforeCompile(It,D),_e=dt.acquireProgram(It,Bt),qt.set(Bt,_e),j.uniforms=It.uniforms;let Xt=j.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Xt.clippingPlanes=ct.uniform),ca(A,It),j.needsLights=zs(A),j.lightsStateVersion=kt,j.needsLights&&(Xt.ambientLightColor.value=Q.state.ambient,Xt.lightProbe.value=Q.state.probe,Xt.sunLights.value=Q.state.sun,Xt.sunLightShadows.value=Q.state.sunShadow,Xt.directionalLights.value=Q.state.directional,Xt.directionalLightShadows.value=Q.state.directionalShadow,Xt.spotLights.value=Q.state.spot,Xt.spotLightShadows.value=Q.state.spotShadow,Xt.rectAreaLights.value=Q.state.rectArea,Xt.ltc_1.value=Q.state.rectAreaLTC1,Xt.ltc_2.value=Q.state.rectAreaLTC2,Xt.pointLights.value=Q.state.point,Xt.pointLightShadows.value=Q.state.pointShadow,Xt.hemisphereLights.value=Q.state.hemi,Xt.sunShadowMatrix.value=Q.state.sunShadowMatrix,Xt.sunShadowCascade.value=Q.state.sunShadowCascade,Xt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,Xt.spotLightMatrix.value=Q.state.spotLightMatrix,Xt.spotLightMap.value=Q.state.spotLightMap,Xt.pointShadowMatrix.value=Q.state.pointShadowMatrix),j.numLightProbeGrids=dn(w.state.lightProbeGridArray),j.currentProgram=_e,j.uniformsList=null,_e}function ri(A,X,nt,j,Q){let Pt=Yt.get(A),kt=Pt.currentProgram.id+","+j+","+Q,It=Pt.programVariants.get(kt);return It===void 0?(It=ji(A,X,nt),Pt.programVariants.set(kt,It)):(Pt.currentProgram=It,Pt.uniformsList=null,Pt.outputColorSpace=j,Pt.toneMapping=Q),It}function Bs(A){if(A.uniformsList===null){let X=A.currentProgram.getUniforms();A.uniformsList=Wo.seqWithValue(X.seq,A.uniforms)}return A.uniformsList}function ca(A,X){let nt=Yt.get(A);nt.outputColorSpace=X.outputColorSpace,nt.batching=X.batching,nt.batchingColor=X.batchingColor,nt.instancing=X.instancing,nt.instancingColor=X.instancingColor,nt.instancingMorph=X.instancingMorph,nt.skinning=X.skinning,nt.morphTargets=X.morphTargets,nt.morphNormals=X.morphNormals,nt.morphColors=X.morphColors,nt.morphTargetsCount=X.morphTargetsCount,nt.numClippingPlanes=X.numClippingPlanes,nt.numIntersection=X.numClipIntersection,nt.vertexAlphas=X.vertexAlphas,nt.vertexTangents=X.vertexTangents,nt.toneMapping=X.toneMapping}function ha(A,X,nt,j,Q){X.isScene!==!0&&(X=We),Qt.resetTextureUnits();let Pt=X.fog,kt=j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial?X.environment:null,It=ht===null?D.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:Se.workingColorSpace,Bt=j.isMeshStandardMaterial||j.isMeshLambertMaterial&&!j.envMap||j.isMeshPhongMaterial&&!j.envMap,qt=I.get(j.envMap||kt,Bt),re=j.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,_e=!!nt.attributes.tangent&&(!!j.normalMap||j.anisotropy>0),Xt=!!nt.morphAttributes.position,xe=!!nt.morphAttributes.normal,sn=!!nt.morphAttributes.color,ke=us;j.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(ke=D.toneMapping);let Be=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,yn=Be!==void 0?Be.length:0,Ht=Yt.get(j),fn=w.state.lights;if(he===!0&&(Ee===!0||A!==J)){let ze=A===J&&j.id===U;ct.setState(j,A,ze)}let Me=!1,xs=!1;j.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==fn.state.version||Q.isBatchedMesh&&Ht.batching===!1||!Q.isBatchedMesh&&Ht.batching===!0||Q.isBatchedMesh&&Ht.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Ht.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Ht.instancing===!1||!Q.isInstancedMesh&&Ht.instancing===!0||Q.isSkinnedMesh&&Ht.skinning===!1||!Q.isSkinnedMesh&&Ht.skinning===!0||Q.isInstancedMesh&&Ht.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Ht.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Ht.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Ht.instancingMorph===!1&&Q.morphTexture!==null||Ht.envMap!==qt||j.fog===!0&&Ht.fog!==Pt||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==ct.numPlanes||Ht.numIntersection!==ct.numIntersection)||Ht.vertexAlphas!==re||Ht.vertexTangents!==_e||Ht.morphTargets!==Xt||Ht.morphNormals!==xe||Ht.morphColors!==sn||Ht.morphTargetsCount!==yn||Ht.numLightProbeGrids!==dn(w.state.lightProbeGridArray)?Me=!0:(Ht.outputColorSpace!==It||Ht.toneMapping!==ke)&&(xs=!0):(Me=!0,Ht.__version=j.version);let pn=Ht.currentProgram;(Me===!0||xs===!0)&&(pn=xs===!0?ri(j,X,Q,It,ke):ji(j,X,Q),G&&j.isNodeMaterial&&G.onUpdateProgram(j,pn,Ht));let Yr=!1,Qi=!1,ys=!1,me=pn.getUniforms(),ln=Ht.uniforms;if(Ct.useProgram(pn.program)&&(Yr=!0,Qi=!0,ys=!0),j.id!==U&&(U=j.id,Qi=!0),Yr||J!==A){Ct.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),me.setValue(z,"projectionMatrix",A.projectionMatrix),me.setValue(z,"viewMatrix",A.matrixWorldInverse);let mn=me.map.cameraPosition;mn!==void 0&&mn.setValue(z,Ge.setFromMatrixPosition(A.matrixWorld)),ue.logarithmicDepthBuffer&&me.setValue(z,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(j.isMeshPhongMaterial||j.isMeshToonMaterial||j.isMeshLambertMaterial||j.isMeshBasicMaterial||j.isMeshStandardMaterial||j.isShaderMaterial)&&me.setValue(z,"isOrthographic",A.isOrthographicCamera===!0),J!==A&&(J=A,Qi=!0,ys=!0)}if(Ht.needsLights&&(fn.state.sunShadowMap.length>0&&me.setValue(z,"sunShadowMap",fn.state.sunShadowMap,Qt),fn.state.directionalShadowMap.length>0&&me.setValue(z,"directionalShadowMap",fn.state.directionalShadowMap,Qt),fn.state.spotShadowMap.length>0&&me.setValue(z,"spotShadowMap",fn.state.spotShadowMap,Qt),fn.state.pointShadowMap.length>0&&me.setValue(z,"pointShadowMap",fn.state.pointShadowMap,Qt)),Q.isSkinnedMesh){me.setOptional(z,Q,"bindMatrix"),me.setOptional(z,Q,"bindMatrixInverse");let ze=Q.skeleton;ze&&(ze.boneTexture===null&&ze.computeBoneTexture(),me.setValue(z,"boneTexture",ze.boneTexture,Qt))}Q.isBatchedMesh&&(me.setOptional(z,Q,"batchingTexture"),me.setValue(z,"batchingTexture",Q._matricesTexture,Qt),me.setOptional(z,Q,"batchingIdTexture"),me.setValue(z,"batchingIdTexture",Q._indirectTexture,Qt),me.setOptional(z,Q,"batchingColorTexture"),Q._colorsTexture!==null&&me.setValue(z,"batchingColorTexture",Q._colorsTexture,Qt));let $n=nt.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&ut.update(Q,nt,pn),(Qi||Ht.receiveShadow!==Q.receiveShadow)&&(Ht.receiveShadow=Q.receiveShadow,me.setValue(z,"receiveShadow",Q.receiveShadow)),(j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial)&&j.envMap===null&&X.environment!==null&&(ln.envMapIntensity.value=X.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=NE()),Qi){if(me.setValue(z,"toneMappingExposure",D.toneMappingExposure),Ht.needsLights&&Xr(ln,ys),Pt&&j.fog===!0&&wt.refreshFogUniforms(ln,Pt),wt.refreshMaterialUniforms(ln,j,tt,Mt,w.state.transmissionRenderTarget[A.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let ze=b,mn=0;for(let kn of w.state.lightProbeGridArray)kn.texture!==null&&(ze.textures[mn]=kn.texture,ze.min[mn]=kn.boundingBox.min,ze.max[mn]=kn.boundingBox.max,ze.resolution[mn]=kn.resolution,mn++);for(let kn in ze)ze[kn].length=mn;ln.probesSH.value=ze.textures,ln.probesMin.value=ze.min,ln.probesMax.value=ze.max,ln.probesResolution.value=ze.resolution}Wo.upload(z,Bs(Ht),ln,Qt)}if(j.isShaderMaterial&&j.uniformsNeedUpdate===!0&&(Wo.upload(z,Bs(Ht),ln,Qt),j.uniformsNeedUpdate=!1),j.isSpriteMaterial&&me.setValue(z,"center",Q.center),me.setValue(z,"modelViewMatrix",Q.modelViewMatrix),me.setValue(z,"normalMatrix",Q.normalMatrix),me.setValue(z,"modelMatrix",Q.matrixWorld),j.uniformsGroups!==void 0){let ze=j.uniformsGroups;for(let mn=0,kn=ze.length;mn<kn;mn++){let Ul=ze[mn];Zt.update(Ul,pn),Zt.bind(Ul,pn)}}return pn}function Xr(A,X){A.ambientLightColor.needsUpdate=X,A.lightProbe.needsUpdate=X,A.sunLights.needsUpdate=X,A.sunLightShadows.needsUpdate=X,A.directionalLights.needsUpdate=X,A.directionalLightShadows.needsUpdate=X,A.pointLights.needsUpdate=X,A.pointLightShadows.needsUpdate=X,A.spotLights.needsUpdate=X,A.spotLightShadows.needsUpdate=X,A.rectAreaLights.needsUpdate=X,A.hemisphereLights.needsUpdate=X}function zs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(A,X,nt){let j=Yt.get(A);j.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,j.__autoAllocateDepthBuffer===!1&&(j.__useRenderToTexture=!1),Yt.get(A.texture).__webglTexture=X,Yt.get(A.depthTexture).__webglTexture=j.__autoAllocateDepthBuffer?void 0:nt,j.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,X){let nt=Yt.get(A);nt.__webglFramebuffer=X,nt.__useDefaultFramebuffer=X===void 0},this.setRenderTarget=function(A,X=0,nt=0){ht=A,Y=X,H=nt;let j=null,Q=!1,Pt=!1;if(A){let It=Yt.get(A);if(It.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(z.FRAMEBUFFER,It.__webglFramebuffer),$.copy(A.viewport),st.copy(A.scissor),lt=A.scissorTest,Ct.viewport($),Ct.scissor(st),Ct.setScissorTest(lt),U=-1;return}else if(It.__webglFramebuffer===void 0)Qt.setupRenderTarget(A);else if(It.__hasExternalTextures)Qt.rebindTextures(A,Yt.get(A.texture).__webglTexture,Yt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let re=A.depthTexture;if(It.__boundDepthTexture!==re){if(re!==null&&Yt.has(re)&&(A.width!==re.image.width||A.height!==re.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Qt.setupDepthRenderbuffer(A)}}let Bt=A.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(Pt=!0);let qt=Yt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(qt[X])?j=qt[X][nt]:j=qt[X],Q=!0):A.samples>0&&Qt.useMultisampledRTT(A)===!1?j=Yt.get(A).__webglMultisampledFramebuffer:Array.isArray(qt)?j=qt[nt]:j=qt,$.copy(A.viewport),st.copy(A.scissor),lt=A.scissorTest}else $.copy(rt).multiplyScalar(tt).floor(),st.copy(Ft).multiplyScalar(tt).floor(),lt=Ut;if(nt!==0&&(j=W),Ct.bindFramebuffer(z.FRAMEBUFFER,j)&&Ct.drawBuffers(A,j),Ct.viewport($),Ct.scissor(st),Ct.setScissorTest(lt),Q){let It=Yt.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+X,It.__webglTexture,nt)}else if(Pt){let It=X;for(let Bt=0;Bt<A.textures.length;Bt++){let qt=Yt.get(A.textures[Bt]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Bt,qt.__webglTexture,nt,It)}}else if(A!==null&&nt!==0){let It=Yt.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,It.__webglTexture,nt)}U=-1};function qr(A){let X=Yt.get(A);return(X.__readFormat!==A.format||X.__readType!==A.type)&&(X.__readFormat=A.format,X.__readType=A.type,X.__formatReadable=ue.textureFormatReadable(A.format),X.__typeReadable=ue.textureTypeReadable(A.type)),X}this.readRenderTargetPixels=function(A,X,nt,j,Q,Pt,kt,It=0){if(!(A&&A.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Yt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&kt!==void 0&&(Bt=Bt[kt],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){Ct.bindFramebuffer(z.FRAMEBUFFER,Bt);try{let qt=A.textures[It],re=qt.format,_e=qt.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+It);let Xt=qr(qt);if(Xt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Xt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}X>=0&&X<=A.width-j&&nt>=0&&nt<=A.height-Q&&z.readPixels(X,nt,j,Q,St.convert(re),St.convert(_e),Pt)}finally{let qt=ht!==null?Yt.get(ht).__webglFramebuffer:null;Ct.bindFramebuffer(z.FRAMEBUFFER,qt)}}},this.readRenderTargetPixelsAsync=async function(A,X,nt,j,Q,Pt,kt,It=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Yt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&kt!==void 0&&(Bt=Bt[kt],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(X>=0&&X<=A.width-j&&nt>=0&&nt<=A.height-Q){Ct.bindFramebuffer(z.FRAMEBUFFER,Bt);let qt=A.textures[It],re=qt.format,_e=qt.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+It);let Xt=qr(qt);if(Xt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Xt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,xe),z.bufferData(z.PIXEL_PACK_BUFFER,Pt.byteLength,z.STREAM_READ),z.readPixels(X,nt,j,Q,St.convert(re),St.convert(_e),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let sn=ht!==null?Yt.get(ht).__webglFramebuffer:null;Ct.bindFramebuffer(z.FRAMEBUFFER,sn);let ke=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await Qg(z,ke,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,xe),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Pt),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(xe),z.deleteSync(ke),Pt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,X=null,nt=0){let j=Math.pow(2,-nt),Q=Math.floor(A.image.width*j),Pt=Math.floor(A.image.height*j),kt=X!==null?X.x:0,It=X!==null?X.y:0;Qt.setTexture2D(A,0),z.copyTexSubImage2D(z.TEXTURE_2D,nt,0,0,kt,It,Q,Pt),Ct.unbindTexture()},this.copyTextureToTexture=function(A,X,nt=null,j=null,Q=0,Pt=0){let kt,It,Bt,qt,re,_e,Xt,xe,sn,ke=A.isCompressedTexture?A.mipmaps[Pt]:A.image;if(nt!==null)kt=nt.max.x-nt.min.x,It=nt.max.y-nt.min.y,Bt=nt.isBox3?nt.max.z-nt.min.z:1,qt=nt.min.x,re=nt.min.y,_e=nt.isBox3?nt.min.z:0;else{let me=Math.pow(2,-Q);kt=Math.floor(ke.width*me),It=Math.floor(ke.height*me),A.isDataArrayTexture?Bt=ke.depth:A.isData3DTexture?Bt=Math.floor(ke.depth*me):Bt=1,qt=0,re=0,_e=0}j!==null?(Xt=j.x,xe=j.y,sn=j.z):(Xt=0,xe=0,sn=0);let Be=St.convert(X.format),yn=St.convert(X.type),Ht;X.isData3DTexture?(Qt.setTexture3D(X,0),Ht=z.TEXTURE_3D):X.isDataArrayTexture||X.isCompressedArrayTexture?(Qt.setTexture2DArray(X,0),Ht=z.TEXTURE_2D_ARRAY):(Qt.setTexture2D(X,0),Ht=z.TEXTURE_2D),Ct.activeTexture(z.TEXTURE0),Ct.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,X.flipY),Ct.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,X.premultiplyAlpha),Ct.pixelStorei(z.UNPACK_ALIGNMENT,X.unpackAlignment);let fn=Ct.getParameter(z.UNPACK_ROW_LENGTH),Me=Ct.getParameter(z.UNPACK_IMAGE_HEIGHT),xs=Ct.getParameter(z.UNPACK_SKIP_PIXELS),pn=Ct.getParameter(z.UNPACK_SKIP_ROWS),Yr=Ct.getParameter(z.UNPACK_SKIP_IMAGES);Ct.pixelStorei(z.UNPACK_ROW_LENGTH,ke.width),Ct.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ke.height),Ct.pixelStorei(z.UNPACK_SKIP_PIXELS,qt),Ct.pixelStorei(z.UNPACK_SKIP_ROWS,re),Ct.pixelStorei(z.UNPACK_SKIP_IMAGES,_e);let Qi=A.isDataArrayTexture||A.isData3DTexture,ys=X.isDataArrayTexture||X.isData3DTexture;if(A.isDepthTexture){let me=Yt.get(A),ln=Yt.get(X),$n=Yt.get(me.__renderTarget),ze=Yt.get(ln.__renderTarget);Ct.bindFramebuffer(z.READ_FRAMEBUFFER,$n.__webglFramebuffer),Ct.bindFramebuffer(z.DRAW_FRAMEBUFFER,ze.__webglFramebuffer);for(let mn=0;mn<Bt;mn++)Qi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Yt.get(A).__webglTexture,Q,_e+mn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Yt.get(X).__webglTexture,Pt,sn+mn)),z.blitFramebuffer(qt,re,qt+kt,re+It,Xt,xe,Xt+kt,xe+It,z.DEPTH_BUFFER_BIT,z.NEAREST);Ct.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(Q!==0||A.isRenderTargetTexture||Yt.has(A)){let me=Yt.get(A),ln=Yt.get(X);Ct.bindFramebuffer(z.READ_FRAMEBUFFER,P),Ct.bindFramebuffer(z.DRAW_FRAMEBUFFER,B);for(let $n=0;$n<Bt;$n++)Qi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,me.__webglTexture,Q,_e+$n):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,me.__webglTexture,Q),ys?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ln.__webglTexture,Pt,sn+$n):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ln.__webglTexture,Pt),Q!==0?z.blitFramebuffer(qt,re,qt+kt,re+It,Xt,xe,Xt+kt,xe+It,z.COLOR_BUFFER_BIT,z.NEAREST):ys?z.copyTexSubImage3D(Ht,Pt,Xt,xe,sn+$n,qt,re,kt,It):z.copyTexSubImage2D(Ht,Pt,Xt,xe,qt,re,kt,It);Ct.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else ys?A.isDataTexture||A.isData3DTexture?z.texSubImage3D(Ht,Pt,Xt,xe,sn,kt,It,Bt,Be,yn,ke.data):X.isCompressedArrayTexture?z.compressedTexSubImage3D(Ht,Pt,Xt,xe,sn,kt,It,Bt,Be,ke.data):z.texSubImage3D(Ht,Pt,Xt,xe,sn,kt,It,Bt,Be,yn,ke):A.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Pt,Xt,xe,kt,It,Be,yn,ke.data):A.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Pt,Xt,xe,ke.width,ke.height,Be,ke.data):z.texSubImage2D(z.TEXTURE_2D,Pt,Xt,xe,kt,It,Be,yn,ke);Ct.pixelStorei(z.UNPACK_ROW_LENGTH,fn),Ct.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Me),Ct.pixelStorei(z.UNPACK_SKIP_PIXELS,xs),Ct.pixelStorei(z.UNPACK_SKIP_ROWS,pn),Ct.pixelStorei(z.UNPACK_SKIP_IMAGES,Yr),Pt===0&&X.generateMipmaps===!0&&X.mipmapsAutoUpdate===!0&&z.generateMipmap(Ht),Ct.unbindTexture()},this.initRenderTarget=function(A){Yt.get(A).__webglFramebuffer===void 0&&Qt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Qt.setTextureCube(A,0):A.isData3DTexture?Qt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Qt.setTexture2DArray(A,0):Qt.setTexture2D(A,0),Ct.unbindTexture()},this.resetState=function(){Y=0,H=0,ht=null,Ct.reset(),At.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var H0=10,W0=.8,FE=(n,t)=>[Math.min(...n.map(({p:e})=>e.getComponent(t))),Math.max(...n.map(({p:e})=>e.getComponent(t)))];function UE(n,t){let e=[],i=(o,a)=>o.forEach(c=>e.push({p:new O(...c),radius:a})),s=n.contact_frame,r=new Set(Array.from({length:H0+1},(o,a)=>Math.round(a*s/H0)));for(let o of r)t.body.forEach((a,c)=>{let{a:l,b:d,radius:h}=wi(n,t,o,c);i([l,d],h)}),Mr.forEach((a,c)=>i(Sr(n,o,c),.06)),t.links.forEach((a,c)=>i(xa(n,t,o,c),a.radius_m??0));return i([n.contact_m],.1),e}function $0(n,t,[e,i]){let s=([r,o],a)=>Math.max(r-W0,Math.min(o+W0,a));return n.flatMap(([r,o])=>t.map(a=>({p:new O(s(e,r),s(i,o),a),radius:.03})))}function Ff([n,t],e){let i=e.map((s,r)=>[[...s,0],[...e[(r+1)%e.length],0]]);return Math.min(...i.map(([s,r])=>Ys([n,t,0],s,r)))}function OE({zones:n,obstacles:t}){let e=(i,s)=>i.map((r,o)=>({a:r,b:i[(o+1)%i.length],top:s}));return[...n.filter(({kind:i})=>i==="curtain"||i==="door").map(i=>e(i.polygon_m,i.z_m[1])),...t.map(i=>e(Nn(i),i.centre_m[2]+i.size_m[2]/2))]}function X0(n,t,e){let i=UE(n,t),s=[0,1].map(h=>FE(i,h)),r=n.contact_frame,o=[...t.links.keys()],a=[...t.body.keys()].map(h=>wi(n,t,r,h)).concat(o.map(h=>rs(n,t,r,h)).filter(h=>!h.position)),c=t.zones.filter(h=>n.sensors.find(({name:u})=>u===h.name)?.detected.includes("1")),l=t.obstacles.map(h=>({item:h,distance:Ff(n.contact_m,Nn(h))})).sort((h,u)=>h.distance-u.distance),d=[0,1].map(h=>o.reduce((u,f)=>u+xa(n,t,r,f)[0][h],0)/o.length);return{points:i,bounds:s,others:[...c.map(h=>$0(h.polygon_m,h.z_m,s)),...l.slice(0,1).map(({item:h})=>$0(Nn(h),[-.5,.5].map(u=>h.centre_m[2]+u*h.size_m[2]),s))],capsules:a.filter(({a:h,b:u,radius:f})=>Ys(n.contact_m,h,u)>f+.03),contact:n.contact_m,person:e.person_xy_m,robot:d,walls:OE(t)}}var kE=8,Uf=n=>[0,1,2].map(t=>n.reduce((e,i)=>e+i[t],0)/n.length),Xo=({kind:n,name:t})=>t.toLowerCase().includes(n)?t:`${n} ${t}`,BE=(n,t)=>[...n].sort((e,i)=>Math.hypot(e[0]-t[0],e[1]-t[1])-Math.hypot(i[0]-t[0],i[1]-t[1]));function q0(n,t,e){let i=n.map((s,r)=>Uf([[...s,t],[...n[(r+1)%n.length],t]]));return BE([...i,...n.map(s=>[...s,t])],e)}function Y0({replay:n,cell:t,hazard:e,hitting:i,marks:s,colours:r,frame:o}){let a=n.contact_m,c=f=>()=>f,l=()=>{let f=rs(n,t,o(),i),m=f.position?ao(t.links[i],f):[f.a,f.b],[x,p]=Uf(m),g=Math.max(...m.map(y=>y[2]))+(f.radius??0);return[[x,p,g],Uf(m)]},d=t.zones.map(f=>{let m=f.kind==="curtain"||f.kind==="door",x=q0(f.polygon_m,m?f.z_m[1]:Math.max(...f.z_m),a);return{text:Xo(f),kind:"zone",colour:r[f.kind],anchors:c(x)}}),h=t.obstacles.map((f,m)=>({item:f,index:m,polygon:Nn(f),distance:Ff(a,Nn(f))})).sort((f,m)=>f.distance-m.distance).slice(0,kE).map(({item:f,index:m,polygon:x})=>{let p=(n.moved??[]).find(({obstacle:M})=>M===m);if(p){let M=()=>[...p.centre_m.slice(3*o(),3*o()+3)];return{text:f.name,kind:"obstacle",anchors:()=>p.there[o()]==="1"?[M()]:[]}}let g=[.5,0,-.45].map(M=>f.centre_m[2]+M*f.size_m[2]),y=g.flatMap(M=>q0(x,M,a));return{text:f.name,kind:"obstacle",anchors:c([[...f.centre_m.slice(0,2),g[0]],...y])}}),u=s.map(({text:f,at:m})=>({text:f,kind:"tick",anchors:c([m])}));return[{text:e.robot_link,kind:"hitting",anchors:l},...d,...h,...u]}var Ns=.025,zE=1e3,VE=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e])));function GE(n){if(!n.points_m)return n;let t=([i,s,r],[o,a,c])=>o*i+a*s+c*r,e=VE.map(i=>n.points_m.reduce((s,r)=>t(r,i)>t(s,i)?r:s));return{...n,points_m:[...new Set(e)]}}function Of(n,t,e,i,s=t.links[i]){let r=rs(n,t,e,i);return r.position?{polygon:nd(ao(s,r).map(([o,a])=>[o,a])),radius:0}:{polygon:[r.a.slice(0,2),r.b.slice(0,2)],radius:r.radius}}function HE([n,t],[[e,i],[s,r]],o){let[a,c]=[s-e,r-i],l=a*a+c*c,d=l>0?Math.max(0,Math.min(1,((n-e)*a+(t-i)*c)/l)):0;return(n-e-d*a)**2+(t-i-d*c)**2<=o*o}function Z0(n,t,[[e,i],[s,r]]){let[o,a]=[i-e,r-s].map(f=>Math.ceil(f/Ns)),c=new Uint8Array(o*a),l=t.links.map(GE),d=Math.max(1,Math.ceil(n.reduce((f,m)=>f+m.frames,0)/zE));function h({polygon:f,radius:m}){let x=(b,R,w)=>{let _=f.map(k=>k[b]),T=Math.floor((Math.min(..._)-m-R)/Ns);return[Math.max(0,T),Math.min(w-1,Math.floor((Math.max(..._)+m-R)/Ns))]},[[p,g],[y,M]]=[x(0,e,o),x(1,s,a)];for(let b=y;b<=M;b++)for(let R=p;R<=g;R++){let w=b*o+R,_=[e+(R+.5)*Ns,s+(b+.5)*Ns];c[w]||=m>0?HE(_,f,m):Zl(_,f)}}for(let f of n)for(let m=0;m<f.frames;m+=d)l.forEach((x,p)=>h(Of(f,t,m,p,x)));let u=[];for(let f=0;f<a;f++)for(let m=0;m<o;m++){let x=m;for(;m<o&&c[f*o+m];)m+=1;m>x&&u.push({x:e+x*Ns,y:s+f*Ns,width:(m-x)*Ns,height:1.2*Ns})}return u}var kr=.1,J0=.4,K0=1.2,j0=.42,Q0=.1,WE=[.2,.34,.48].flatMap(n=>[-90,-45,-135,0,180,45,135,90].map(t=>[n*Math.cos(t*Math.PI/180),n*Math.sin(t*Math.PI/180)])),qo={person:n=>n.person_xy_m,contact:n=>n.contact_point_m};function $E(n,t){let e=new Map;for(let i of n){let[s,r]=t(i),o=[s,r].map(l=>Math.floor(l/kr+1e-6)),a=o.join(","),c=e.get(a)??{corner:o,hazards:[]};c.hazards.push(i),e.set(a,c)}return[...e.values()]}function XE({cell:n,scan:t}){let e=(n.robots??[]).flatMap(a=>a.base_m?[a.base_m]:[]),i=[n.start.xy_m,...e,...t.hazards.flatMap(a=>[qo.person(a),qo.contact(a)])],s=a=>[0,1].map(c=>[Math.min(...a.map(l=>l[c])),Math.max(...a.map(l=>l[c]))]),r=s(i);return s([...i,...n.obstacles.flatMap(Nn),...n.zones.flatMap(a=>a.polygon_m)]).map(([a,c],l)=>[Math.max(a,r[l][0]-K0)-J0,Math.min(c,r[l][1]+K0)+J0])}function t_(n,t,e,i){let s=e.map(([r,o],a)=>C("label",{},C("input",{type:"radio",name:n,value:r,checked:a===0,"data-test":`${n}-${r}`,onchange:()=>i(r)}),` ${o}`));return C("fieldset",{},C("legend",{},t),s)}function e_(n,t){return[0,1].map(e=>{let[i,s]=t[e].map((o,a)=>o+(a===0?.3:-.3)),r=n.map(o=>Math.max(i,Math.min(s,o[e])));return(Math.min(...r)+Math.max(...r))/2})}function n_(n,t,e){let{cell:i,scan:s}=n,r=XE(n),[[o,a],[c,l]]=r,d=([it,rt])=>[it-o,l-rt].map(Ft=>Number(Ft.toFixed(3))),h=it=>it.map(rt=>d(rt).join(",")).join(" "),u=it=>it.reduce((rt,Ft)=>f(Ft)>f(rt)?Ft:rt),f=it=>Fi(it,s.settings).decides.ratio,m="person",x="cause",p=bt("g",{class:"bins"}),g=bt("path",{class:"sweep"},bt("title",{},"where robots are at some time in the replays of this report")),y=bt("g",{class:"robot"}),M=bt("g",{class:"selected-place"}),b=bt("g",{class:"cause-places"}),R=C("output",{"data-test":"bin",class:"told screen-only"}),w="Point at a bin to read it; click it to see only its hazards in the table.",_=it=>R.textContent=it||w;_("");let T=(it,rt,Ft)=>(Object.entries({tabindex:"0",role:"button","aria-label":rt}).forEach(([Lt,Jt])=>it.setAttribute(Lt,Jt)),["mouseenter","focus"].forEach(Lt=>it.addEventListener(Lt,()=>_(rt))),["mouseleave","blur"].forEach(Lt=>it.addEventListener(Lt,()=>_(""))),it.addEventListener("click",Ft),it.addEventListener("keydown",Lt=>{(Lt.key==="Enter"||Lt.key===" ")&&(Lt.preventDefault(),Lt.stopPropagation(),Ft())}),it);function k(){let it=$E(s.hazards,qo[m]),rt=({hazards:Jt})=>x==="count"?Jt.length:Math.max(...Jt.map(f)),Ft=it.map(rt),[Ut,Lt]=[Math.min(...Ft),Math.max(...Ft)];p.replaceChildren(...it.map(Jt=>{let[he,Ee]=Jt.corner.map(jt=>jt*kr),ve=u(Jt.hazards),Ge=`${m==="person"?"person at":"contact at"} ${he.toFixed(1)} to ${(he+kr).toFixed(1)}, ${Ee.toFixed(1)} to ${(Ee+kr).toFixed(1)} m`,de=`${Ge}: ${fe(Jt.hazards.length,"hazard")}, worst ${Ce(f(ve))}, cause ${n.causeOf(ve.id).number}`,We=()=>{e({name:Ge,ids:new Set(Jt.hazards.map(jt=>jt.id))}),t.select(ve.id)},Oe=Lt>Ut?(rt(Jt)-Ut)/(Lt-Ut):1,[on,z]=d([he,Ee+kr]),Dt=x==="cause"?`fill:${ga(n.causeOf(ve.id))}`:`--heat:${Oe.toFixed(3)}`;return T(bt("rect",{x:on,y:z,width:kr,height:kr,style:Dt,"data-test":"map-bin"}),de,We)})),N.textContent=x==="cause"?"Each bin has the colour of its worst cause.":x==="count"?`${fe(Ut,"hazard")} (pale) to ${Lt} (dark) in a bin`:`worst ratio ${Ce(Ut)} (pale) to ${Ce(Lt)} (dark)`,D()}function D(){let it=[];b.replaceChildren(...n.causes.map(rt=>{let[Ft,Ut]=d(qo[m](n.hazard(rt.worst))),Lt=([Ge,de])=>it.every(([We,Oe])=>Math.hypot(Ge-We,de-Oe)>2.2*Q0),Jt=WE.map(([Ge,de])=>[Ft+Ge,Ut+de]),[he,Ee]=Jt.find(Lt)??Jt[0];it.push([he,Ee]);let ve=bt("g",{class:"cause-place","data-test":"place-cause","data-id":rt.id,transform:`translate(${he.toFixed(3)} ${Ee.toFixed(3)})`,style:`--cause:${ga(rt)}`},bt("line",{x2:(Ft-he).toFixed(3),y2:(Ut-Ee).toFixed(3)}),bt("circle",{r:Q0}),bt("text",{y:.045},String(rt.number)));return T(ve,`cause ${rt.number}: ${rt.sentence}`,()=>t.select(rt.id))}))}let N=C("span",{class:"note"}),G=([it,rt])=>it>o&&it<a&&rt>c&&rt<l,W=(it,[rt,Ft],Ut)=>{let[Lt,Jt]=d([rt,Ft]);return bt("text",{x:Lt,y:Jt,class:`name ${Ut}`},it)},P=i.obstacles.filter(it=>!it.follows),B=P.map(it=>bt("polygon",{points:h(Nn(it)),class:"obstacle"},bt("title",{},it.name))),Y=i.zones.map(it=>bt(it.polygon_m.length>2?"polygon":"polyline",{points:h(it.polygon_m),class:`zone ${it.kind}`},bt("title",{},`${it.kind} ${it.name}`))),H=[...P.map(it=>W(it.name,e_(Nn(it),r),"obstacle-name")),...i.zones.map(it=>{let[rt,Ft]=[0,1].map(Ut=>Math.max(r[Ut][0]+.05,Math.min(...it.polygon_m.map(Lt=>Lt[Ut]))));return W(Xo(it),[rt+.05,Ft+.05],`zone-name ${it.kind}`)})],[ht,U]=d(i.start.xy_m),J=bt("g",{class:"start",transform:`translate(${ht} ${U}) rotate(${-i.start.heading_deg})`},bt("circle",{r:.12}),bt("path",{d:"M 0.12 0 H 0.3 M 0.22 -0.07 L 0.3 0 L 0.22 0.07"}),bt("title",{},"start of the person")),$=[a-o,l-c],st=([it,rt])=>Array.from({length:Math.floor(rt)-Math.ceil(it)+1},(Ft,Ut)=>Math.ceil(it)+Ut),lt=bt("g",{class:"ruler"},bt("path",{d:`M 0 0 V ${$[1].toFixed(3)} H ${$[0].toFixed(3)}`}),st([r[0][0]+.2,r[0][1]-.15]).map(it=>[bt("path",{d:`M ${(it-o).toFixed(3)} ${$[1].toFixed(3)} v 0.05`}),bt("text",{x:(it-o).toFixed(3),y:($[1]+.19).toFixed(3)},`${it} m`)]).flat(),st([r[1][0]+.1,r[1][1]-.1]).map(it=>[bt("path",{d:`M 0 ${(l-it).toFixed(3)} h -0.05`}),bt("text",{x:-.08,y:(l-it+.04).toFixed(3),class:"left"},`${it} m`)]).flat(),bt("text",{x:-.1,y:($[1]+.19).toFixed(3),class:"left"},"x, y")),Z=bt("clipPath",{id:"map-frame"},bt("rect",{width:$[0].toFixed(3),height:$[1].toFixed(3)})),pt=bt("svg",{viewBox:`${-j0} 0 ${($[0]+j0).toFixed(3)} ${($[1]+.26).toFixed(3)}`,class:"map",role:"group","aria-label":"the cell from above","data-test":"map"},bt("defs",{},Z),bt("g",{"clip-path":"url(#map-frame)"},g,Y,B,y,p,M,J),H.filter((it,rt)=>G(e_(rt<P.length?Nn(P[rt]):i.zones[rt-P.length].polygon_m,r))),b,lt);function mt(it,rt){let Ft=i.links.map((Ut,Lt)=>{let{polygon:Jt,radius:he}=Of(it,i,it.contact_frame,Lt),Ee=Ut.name===rt||`${Ut.robot}/${Ut.name}`===rt?"hitting":null,ve=Jt.map(d);if(he===0)return bt("polygon",{points:h(Jt),class:Ee});let[[Ge,de],[We,Oe]]=ve;return bt("line",{x1:Ge,y1:de,x2:Ge===We&&de===Oe?We+.001:We,y2:Oe,"stroke-width":2*he,class:Ee})});y.replaceChildren(...Ft,bt("title",{},"robot at the contact of the selected hazard"))}let Mt=!1;function tt(){if(!Mt){Mt=!0;let it=n.replays.map(({id:Ft})=>n.replay(Ft)),rt=Z0(it,i,r).map(({x:Ft,y:Ut,width:Lt,height:Jt})=>`M${(Ft-o).toFixed(3)} ${(l-Ut).toFixed(3)}h${Lt.toFixed(3)}v${(-Jt).toFixed(3)}h${(-Lt).toFixed(3)}z`);g.setAttribute("d",rt.join(""))}}new IntersectionObserver(it=>it.some(rt=>rt.isIntersecting)&&tt(),{rootMargin:"400px"}).observe(pt),t.follow(({hazard:it,cause:rt})=>{let Ft=n.hazard(it),[Ut,Lt]=d(qo.person(Ft)),[Jt,he]=d(qo.contact(Ft));M.replaceChildren(bt("line",{x1:Ut,y1:Lt,x2:Jt,y2:he}),bt("circle",{cx:Ut,cy:Lt,r:.09},bt("title",{},`${it}: person`)),bt("path",{d:`M ${Jt} ${he} m -0.06 -0.06 l 0.12 0.12 m 0 -0.12 l -0.12 0.12`},bt("title",{},`${it}: contact`)));let Ee=n.replay(it)??n.replay(n.cause(rt).worst)??n.replay(n.replays[0]?.id);Ee?mt(Ee,Ft.robot_link):y.replaceChildren()}),k();let xt=n.causes.slice(0,8).map(it=>C("li",{},qs(it),` ${it.sentence}`));return Pn("map","Where it happens",C("div",{class:"filters screen-only"},t_("place","bins of",[["person","person"],["contact","contact"]],it=>(m=it,k())),t_("colour","colour",[["cause","cause"],["count","number of hazards"],["ratio","worst ratio"]],it=>(x=it,k()))),pt,C("p",{class:"map-line"},R," ",N),C("ul",{class:"map-key"},xt),C("p",{class:"note"},"Ring: the selected hazard's person; cross: its contact. Arrow: start. Blue: robot at that contact, and pale where robots go in the replays. Grey: obstacles. Dashed: sensor zones. Numbers: worst way of each cause."))}function qE(n){let{speed_m_s:t,safe_below_m_s:e,limit_n:i,force_n:s,effective_mass_kg:r}=n;return`F = v √(μ k) = ${e>0?`${Zn(t)} × ${(i/e).toFixed(0)} N/(m/s) = `:""}${vn(s)}; limit ${vn(i)}, met at ${Zn(e)}. Effective mass of the robot ${r.toFixed(2)} kg; v is the robot's own speed.`}function YE(n,t){let{own:e,approach:i,decides:s,apart:r}=Fi(n,t),o=a=>C("li",{class:a===s?"decides":null},`${a.name}, ${Zn(a.speed)}: ${vn(a.force)}, ${Ce(a.ratio)} the limit`,a===s?C("b",{}," (decides)"):null);return C("div",{"data-test":"forces"},C("ul",{class:"plain-list"},o(e),o(i)),r?C("p",{class:"flag","data-test":"apart"},`${Hl} ${e.ratio>i.ratio?"Most of the robot's speed is not towards the person.":"Most of the speed is the person's own walking."}`):null)}var i_=(n,t)=>C("ol",{class:"sequence"},im(n,t).map(e=>C("li",{},e)));function ZE(n,t){if(!Bn(n))return`The robot's ${n.robot_link}, which moves at ${Zn(n.speed_m_s)}, ${Ni(n)} after ${Te(n.time_s)}.`;let{decides:e}=Fi(n,t),i=`The robot's ${n.robot_link} ${Ni(n)} at ${Zn(n.speed_m_s)} after ${Te(n.time_s)}: ${Ce(e.ratio)} the limit.`;return Gl(n.body_region)?`${i} A moving robot may not touch it at all, whatever the force.`:i}function JE(n){let[t,e]=xr(n);return C("div",{"data-test":"forces"},C("p",{},C("b",{},t),` ${e}`,C("b",{}," (decides)")),n.class==="separation"?null:C("p",{class:"note"},`On somebody who can give way: ${vn(n.force_n)}, ${Ce(n.force_n/n.limit_n)} the limit.`))}function KE({judged:n,effective_mass_kg:t}){let{clamping:e,pressure:i,separation:s,limit:r}=n??{};if(s)return`${typeof s.stops_after_s=="number"?`Stopped at that instant the robot stands after ${Te(s.stops_after_s)}, up to ${s.travel_m.toFixed(3)} m farther`:"The robot does not stop"}, as the FMU shows.`;if(e&&r==="force"){let{closing_m_s:o,gap_m:a,travel_m:c,force_n:l,limit_n:d}=e,h=c>0?`; after a contact the link goes on by ${(1e3*c).toFixed(0)} mm`:"";return`${(1e3*a).toFixed(0)} mm of room${h}. F = c √(m k) = ${vn(l)} with c = ${Zn(o)}, at which the gap closes, and the robot's effective mass m = ${t.toFixed(2)} kg; quasi-static limit ${vn(d)}.`}return i?`By what the cell file says of how small the surface is that touches${i.clamped?"; the part cannot give way":""}.`:""}function iu(n,t,{short:e=!1}={}){let i=t.action_s,s=n.shortest.actions.join()===n.actions.join(),r=n.bend_fraction<1?`, bent as far as obstacles leave it (${(100*n.bend_fraction).toFixed(0)} %)`:"",o=ci([["what",ZE(n,t)],["where",`${n.class==="separation"?"nearest point of the robot":"contact"} at ${Vl(n.contact_point_m)}; ${n.person??"the person"} stands at ${Vl(n.person_xy_m)}, looks to ${((n.person_heading_deg%360+360)%360).toFixed(0)}°${r}`],["begins",n.begins?`at ${Vl(n.begins.xy_m)}, looking to ${n.begins.heading_deg.toFixed(0)}°, ${zl(n.begins)}; times count from then`:""],["force",Bn(n)?YE(n,t):""],["broken",Bn(n)?"":JE(n)],["how computed",e?"":Bn(n)?qE(n):KE(n)],["arm",n.arm&&!e?`${n.arm.side} arm. An arm pose is searched at every instant; the one shown is that at the contact.`:""],["way of the arm",n.through.map(a=>`past ${a.sensor} ${Te(a.since_s)} before the contact${a.until_s>0?", ahead of the body":""}; the robot is where it is when that reports it`).join("; ")],["sensors",`${n.class==="separation"?"then":"at the contact"}: ${lm(n.sensors)}`],["programme phase",n.phase===null||e?"":String(n.phase)],["found",e?"":`${cm(n)}; earliest contact at ${Te(n.earliest_time_s)}${n.first_iteration>0?`; first in iteration ${n.first_iteration}`:""}`],["confirmed",`by a fresh instance without any restore: ${so(n.confirmed)}`],["worst sequence",i_(n.actions,i)],["shortest and calmest",e?"":s?"the same sequence":[`${Ce(n.shortest.ratio)}${n.judged?.limit==="force"||Bn(n)?`, ${vn(n.shortest.force_n)}`:""} at ${Te(n.shortest.time_s)}; confirmed: ${so(n.shortest.confirmed)}`,i_(n.shortest.actions,i)]],["replay it",e?"":[Xs(`fmi-hazard replay scan.json ${n.id}`)," in the folder with this report"]]]);return e||o.setAttribute("data-test","facts"),o}var s_=.35,r_=1,su=6,jE={narrow:.034,wide:.021},QE="(max-width: 640px)",tT=.6,c_=[{below:1,text:"head or throat touched: no contact is allowed",colour:"#fff3b8"},{below:1.25,text:"hit with up to 1.25 times the limit",colour:"#fed06b"},{below:1.5,text:"1.25 to 1.5 times",colour:"#fd8d3c"},{below:2,text:"1.5 to 2 times",colour:"#d7261e"},{below:1/0,text:"twice the limit and more",colour:"#7a0024"}],h_="not looked at to the end",u_=({ground:n})=>n.unseen_m.length+n.watched_m.length>0,o_=["#440154","#3b528b","#21918c","#5ec962","#d8e219"],kf=n=>c_.find(({below:t})=>n<t),eT=(n,t)=>`${(n*t*t).toFixed(n*t*t<.095?2:1)} m²`,a_=n=>(Math.round(100*n)/100+0).toFixed(2),bl=([n,t])=>`${a_(n)}, ${a_(t)} m`,l_=(n,t)=>`${Te(n*t)} to ${Te((n+1)*t)}`;function nT(n){let t=n.map(c=>c.earliest_s),[e,i]=[Math.min(...t),Math.max(...t)],s=i-e<1e-9?1:o_.length,r=c=>e+(i-e)*c/s,o=Array.from({length:s},(c,l)=>({text:s===1?Te(e):`${Te(r(l))} to ${Te(r(l+1))}`,colour:o_[l]}));return{classes:o,of:c=>o[Math.max(0,Math.min(s-1,Math.floor(s*(c-e)/(i-e||1))))]}}function iT({cell:n,whole:t}){let e=(n.robots??[]).flatMap(l=>l.base_m?[l.base_m]:[]),i=l=>l.flatMap(([d,h,u,f])=>[[d,h],[u,f]]),s=[...t.floor.map(({xy_m:l})=>l),...t.open_m,...e,...i(t.ground.swept_m),...t.places.slice(0,su).flatMap(l=>[l.xy_m,l.start_m])],r=[...s,...n.obstacles.flatMap(Nn),...n.zones.flatMap(l=>l.polygon_m)],o=l=>[0,1].map(d=>l.reduce(([h,u],f)=>[Math.min(h,f[d]),Math.max(u,f[d])],[1/0,-1/0])),[a,c]=[s.length>0?s:[n.start.xy_m],r.length>0?r:[n.start.xy_m]].map(o);return a.map(([l,d],h)=>[Math.max(c[h][0],l-r_)-s_,Math.min(c[h][1],d+r_)+s_])}function sT(n,t){let e=t.map(([i,s],r)=>[Math.max(i,Math.min(...n.map(o=>o[r]))),Math.min(s,Math.max(...n.map(o=>o[r])))]);return e.every(([i,s])=>i<=s)?e.map(([i,s])=>(i+s)/2):null}function d_(n,t){let{cell:e,whole:i}=n,s=i.cell_m,r=iT(n),[[o,a],[c,l]]=r,d=[a-o,l-c],h=jE[matchMedia(QE).matches?"narrow":"wide"]*Math.max(d[0],.8*d[1],2),u=tt=>Number(tt.toFixed(3)),f=([tt,xt])=>[u(tt-o),u(l-xt)],m=tt=>tt.map(xt=>f(xt).join(",")).join(" "),x=tt=>tt.map(([xt,it,rt,Ft])=>`M${f([xt,Ft]).join(" ")}h${u(rt-xt)}v${u(Ft-it)}h${u(xt-rt)}z`).join(""),p=([tt,xt],it,rt=s)=>{let[Ft,Ut]=f([tt-rt/2,xt+rt/2]);return bt("rect",{x:Ft,y:Ut,width:u(rt),height:u(rt),...it})},g=(tt,[xt,it],rt)=>{let[Ft,Ut]=f([xt,it]);return bt("text",{x:Ft,y:Ut,class:`name ${rt}`,"font-size":u(h)},tt)},y=i.floor.map(tt=>p(tt.xy_m,{class:"hit","data-test":"whole-square"},tt.unseen?s:tT*s)),M=p([0,0],{class:"cursor",visibility:"hidden"}),b=i.places.slice(0,su),R=b.map(tt=>f(tt.xy_m)),w=.85*h,_=([tt,xt])=>{let it=[2.6,4,5.8,8].flatMap(Ut=>Array.from({length:12},(Lt,Jt)=>[tt+Ut*h*Math.cos(Jt/1.91),xt-Ut*h*Math.sin(Jt/1.91)])),rt=([Ut,Lt])=>Ut>w&&Lt>w&&Ut<d[0]-w&&Lt<d[1]-w&&R.every(([Jt,he])=>Math.hypot(Ut-Jt,Lt-he)>2.3*w),Ft=it.find(rt)??[tt,xt];return R.push(Ft),Ft},T=b.map((tt,xt)=>{let[it,rt]=f(tt.xy_m),[Ft,Ut]=f(tt.start_m),[Lt,Jt]=_([it,rt]),he=tt.walks_in?[bt("path",{class:"way",d:`M${Ft} ${Ut}L${it} ${rt}`}),bt("circle",{class:"from",cx:Ft,cy:Ut,r:u(.4*h)})]:[];return bt("g",{class:"hit-place","data-test":"whole-place"},...he,bt("path",{class:"lead",d:`M${u(Lt)} ${u(Jt)}L${it} ${rt}`}),bt("circle",{class:"at",cx:it,cy:rt,r:u(.25*h)}),bt("circle",{class:"disc",cx:u(Lt),cy:u(Jt),r:u(w)}),bt("text",{x:u(Lt),y:u(Jt+.37*h),"font-size":u(h)},String(xt+1)),bt("title",{},Bf(tt)))}),k=(e.robots??[]).filter(tt=>tt.base_m).map(tt=>{let[xt,it]=f(tt.base_m),rt=u(.9*h);return bt("g",{class:"base"},bt("circle",{cx:xt,cy:it,r:u(.6*h)}),bt("path",{d:`M${xt-rt} ${it}h${2*rt}M${xt} ${it-rt}v${2*rt}`}),g(tt.name,[tt.base_m[0],tt.base_m[1]+1.3*h],"base-name"))}),D=e.obstacles.map(tt=>bt("polygon",{points:m(Nn(tt)),class:"obstacle"},bt("title",{},tt.name))),N=e.zones.map(tt=>bt(tt.polygon_m.length>2?"polygon":"polyline",{points:m(tt.polygon_m),class:`zone ${tt.kind}`},bt("title",{},Xo(tt)))),G=e.zones.flatMap(tt=>{let xt=sT(tt.polygon_m,r)&&[0,1].map(it=>Math.max(r[it][0],Math.min(...tt.polygon_m.map(rt=>rt[it])))+.4*h);return xt?[g(Xo(tt),xt,"zone-name")]:[]}),W=([tt,xt])=>Array.from({length:Math.max(0,Math.floor(xt)-Math.ceil(tt)+1)},(it,rt)=>Math.ceil(tt)+rt),P=u(.5*h),B=[bt("path",{d:`M0 0V${u(d[1])}H${u(d[0])}`}),...W(r[0]).flatMap(tt=>[bt("path",{d:`M${u(tt-o)} ${u(d[1])}v${P}`}),bt("text",{x:u(tt-o),y:u(d[1]+1.6*h),"font-size":u(h)},`${tt} m`)]),...W(r[1]).flatMap(tt=>[bt("path",{d:`M0 ${u(l-tt)}h${-P}`}),bt("text",{x:u(-.8*h),y:u(l-tt+.35*h),class:"left","font-size":u(h)},`${tt} m`)])],[Y,H]=[u(d[0]-1-h),u(d[1]-1.2*h)],ht=[bt("path",{d:`M${Y} ${u(H-.4*h)}v${u(.4*h)}h1v${u(-.4*h)}`}),bt("text",{x:Y+.5,y:u(H-.5*h),"font-size":u(h)},"1 m")],U={width:u(d[0]),height:u(d[1])},J=bt("pattern",{id:`${t}-unknown`,width:.05,height:.05,patternUnits:"userSpaceOnUse",patternTransform:"rotate(45)"},bt("rect",{width:.05,height:.05,class:"blank"}),bt("rect",{width:.02,height:.05,class:"stripe"})),$=bt("pattern",{id:`${t}-unlooked`,width:.08,height:.08,patternUnits:"userSpaceOnUse",patternTransform:"rotate(-45)"},bt("rect",{width:.08,height:.08,class:"blank"}),bt("rect",{width:.01,height:.08,class:"stripe"})),st={style:`fill:url(#${t}-unlooked)`,"data-test":"whole-unlooked"},lt=bt("g",{class:"open",style:`fill:url(#${t}-unknown)`},...i.open_m.map(tt=>p(tt,{}))),Z=bt("svg",{viewBox:[-4.2*h,-.3*h,d[0]+6*h,d[1]+2.6*h].map(u).join(" "),class:"whole-map",role:"img","aria-label":"the floor from above","data-test":"whole-map"},bt("defs",{},J,$,bt("clipPath",{id:`${t}-frame`},bt("rect",U))),bt("g",{"clip-path":`url(#${t}-frame)`},bt("rect",u_(i)?{...U,class:"nowhere"}:{...U,...st}),bt("path",{d:x(i.ground.unseen_m),class:"unseen"}),bt("path",{d:x(i.ground.watched_m),class:"watched"}),i.not_looked_at_m.length>0?bt("path",{d:x(i.not_looked_at_m),...st}):null,bt("path",{d:x(i.ground.swept_m),class:"swept"}),lt,bt("g",{class:"hits"},...y),N,D,k,G,M,bt("g",{class:"scale-bar"},...ht)),...T,bt("g",{class:"whole-ruler"},...B));return{element:Z,colour:tt=>y.forEach((xt,it)=>{let rt=tt(i.floor[it]);xt.setAttribute("style",rt===null?"":`fill:${rt}`),xt.classList.toggle("else",rt===null)}),point:tt=>{if(M.setAttribute("visibility",tt?"visible":"hidden"),tt){let[xt,it]=f([tt[0]-s/2,tt[1]+s/2]);M.setAttribute("x",xt),M.setAttribute("y",it)}},under:tt=>{let xt=Z.getScreenCTM()?.inverse(),{x:it,y:rt}=new DOMPoint(tt.clientX,tt.clientY).matrixTransform(xt);return[it+o,l-rt]},bounds:r}}function Bf(n){let t=typeof n.time_s=="number"?` after ${Te(n.time_s)}`:"",e=n.walks_in?`walks from ${bl(n.start_m)} to ${bl(n.xy_m)}`:`stands at ${bl(n.xy_m)}`;return`${$s(n.body_region,n.ratio)}: ${Si(n.body_region)} hit by ${n.robot_link}${t}; ${e}, ${n.posture}${n.confirmed?"":"; not confirmed"}`}var f_=(n,t)=>C("li",{},C("span",{class:"surface",style:n}),C("span",{},t)),ps=(n,t)=>C("li",{},C("span",{class:`surface ${n}`}),C("span",{},t));function p_({whole:n,cell:t}){return[n.floor.every(({unseen:e})=>e)?null:ps("small","small: only who walks in, if they get there in time"),n.open_m.length>0?ps("unknown","not known whether anybody is hit there"):null,n.looked_at?ps("unseen","people come here unseen; no hit found"):ps("unlooked",h_),n.looked_at&&n.ground.watched_m.length>0?ps("watched","sensors see people here, or on the way here; no hit found"):null,u_(n)?ps("nowhere","nobody can stand here, or gets here"):null,n.ground.swept_m.length>0?ps("swept","below what the robots sweep"):null,t.obstacles.length>0?ps("obstacle","obstacle"):null,t.zones.length>0?ps("zone","where sensors see"):null].filter(Boolean)}var m_="Colours tell the worst that was tried in each square; it may be worse.",rT="A moment shows who is hit then of those who are hit at some moment. Others may be hit then where no colour is.";function g_(n){let{whole:t}=n,e=d_(n,"whole-paper");return e.colour(i=>kf(i.ratio).colour),C("article",{"data-test":"print-whole",class:"whole-page"},C("h2",{},"The floor"),C("p",{},t.said),e.element,C("ul",{class:"whole-key"},__(t).map(({text:i,colour:s})=>f_(`background:${s}`,i)),p_(n)),C("p",{class:"note"},m_),C("ol",{class:"whole-places"},t.places.slice(0,su).map(i=>C("li",{},Bf(i)))))}var __=({floor:n})=>c_.filter(({below:t})=>t>1||n.some(e=>e.ratio<1));function x_(n){let{whole:t}=n,e=t.cell_m,i=d_(n,"whole"),s=([P,B])=>[P,B].map(Y=>Math.floor(Y/e+1e-6)).join(","),r=new Map(t.floor.map(P=>[s(P.xy_m),P])),o=new Set(t.open_m.map(s)),a=nT(t.floor),c=t.floor.flatMap(P=>P.spans.map(([B])=>B)),l=Math.max(Math.ceil(t.until_s/t.span_s-1e-6)-1,...c,0),d="worst",h=c.length>0?Math.min(...c):0,u=null,f=C("output",{"data-test":"whole-told",class:"told screen-only"}),m=C("ul",{class:"whole-key","data-test":"whole-key"}),x=C("p",{class:"note"}),p="Point at the floor, or touch it, to read a square; arrow keys move on.";function g(){let P=u&&r.get(s(u));if(!u)f.textContent=p;else if(P){let B=d==="moment"?P.spans.find(([H])=>H===h):null,Y=d!=="moment"?"":B?`; now ${Ce(B[1])}`:"; now no hit found";f.textContent=`${bl(P.xy_m)}: up to ${Ce(P.ratio)}, first at ${Te(P.earliest_s)}${P.unseen?"":", only who walks in, if in time"}${Y}`}else f.textContent=`${bl(u)}: ${o.has(s(u))?"not known":t.looked_at?"no hit found":h_}`;i.point(u)}let y=C("input",{type:"range",min:0,max:l,step:1,value:h,"aria-label":"moment","data-test":"whole-slider",oninput:()=>(h=Number(y.value),w("moment"))}),M=C("output",{class:"whole-now","data-test":"whole-now"});function b(){let P=d==="moment",B=J=>J.spans.find(([$])=>$===h)?.[1],Y={worst:J=>kf(J.ratio).colour,earliest:J=>a.of(J.earliest_s).colour,moment:J=>B(J)===void 0?null:kf(B(J)).colour};i.colour(Y[d]);let ht=(d==="earliest"?a.classes:__(t)).map(({text:J,colour:$})=>f_(`background:${$}`,d==="earliest"?`first hit at ${J}`:J));m.replaceChildren(...ht,...P?[ps("else","hit at other moments")]:[],...p_(n)),y.setAttribute("aria-valuetext",l_(h,t.span_s));let U=t.floor.filter(J=>B(J)!==void 0).length;M.textContent=P?`${l_(h,t.span_s)}: ${U===0?"no hit found":`hits on ${eT(U,e)}`}`:`0 to ${Te(t.until_s)}`,x.textContent=P?rT:d==="earliest"?"Colours tell the earliest moment, after the start, at which a hit was found in each square.":m_,g()}let R=[["worst","how hard"],["earliest","how early"],...t.followed&&c.length>0?[["moment","at one moment"]]:[]].map(([P,B],Y)=>{let H=C("input",{type:"radio",name:"whole",value:P,checked:Y===0,"data-test":`whole-${P}`,onchange:()=>w(P)});return[P,H,C("label",{},H,` ${B}`)]});function w(P){d=P,R.forEach(([B,Y])=>Y.checked=B===P),b()}let{element:_,bounds:T}=i,k=P=>P.every((B,Y)=>B>=T[Y][0]&&B<=T[Y][1]),D=P=>{u=P&&k(P)?P.map(B=>(Math.floor(B/e+1e-6)+.5)*e):null,g()};["pointermove","pointerdown"].forEach(P=>_.addEventListener(P,B=>D(i.under(B)))),_.addEventListener("pointerleave",P=>P.pointerType==="mouse"&&D(null)),_.setAttribute("tabindex","0"),_.addEventListener("keydown",P=>{let B={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[P.key];if(B){P.preventDefault(),P.stopPropagation();let Y=t.floor.reduce((ht,U)=>U.ratio>ht.ratio?U:ht,t.floor[0]),H=u?u.map((ht,U)=>ht+B[U]*e):Y?.xy_m??T.map(([ht,U])=>(ht+U)/2);k(H)&&D(H)}});let N=(P,B)=>P.id&&n.hazard(P.id)?C("a",{href:`#${P.id}`},B):B,G=t.places.slice(0,su).map(P=>C("li",{onmouseenter:()=>D(P.xy_m),onmouseleave:()=>D(null)},N(P,Bf(P)))),W=t.places.length-G.length;return b(),Pn("whole","The floor",C("p",{class:"whole-head","data-test":"whole-head"},t.said),C("div",{class:"filters screen-only"},t.floor.length>0?C("fieldset",{},C("legend",{},"colour"),R.map(([,,P])=>P)):null,t.followed&&c.length>0?C("span",{class:"whole-time"},y,M):null),C("div",{class:"whole"},C("div",{},_,f),C("div",{},m,x,G.length>0?C("h3",{},"Worst ways to be hit"):null,C("ol",{class:"whole-places"},G),W>0?C("p",{class:"note"},`And ${fe(W,"way")} more, less bad or not confirmed.`):null)))}var zf=8,y_=(n,t,e)=>C("table",{class:`plain ${e}`},C("thead",{},C("tr",{},n.map(i=>C("th",{scope:"col"},i)))),C("tbody",{},t.map(i=>C("tr",{},i.map(s=>C("td",{},s))))));function oT({scan:n}){let{certificate:t,spent:e}=n;return _a(n)?`${Yl(n)}.`:t?.complete?`All ${De(t.sequences)} sequences of ${t.horizon} actions, ${Te(n.settings.action_s)} each, in this model.`:`${fe(e.iterations,"sequence")} of actions; the search is not complete.`}function aT(n,t){let{scan:e,cell:i}=n,{says:s,covers:r}=Qu(e),o=n.causes.map(a=>[qs(a),a.sentence,xr(a)[0],lT(a),t.ofCause(a.id),vr(t.of(a.id))??"–"]);return C("article",{class:"first","data-test":"print-first"},C("p",{class:"kicker"},`${e.tool} · hazard report`),C("h1",{},i.name),C("p",{class:"verdict"},s),C("p",{},r),C("h3",{},"Causes, worst first"),y_(["","cause","worst","what to change","decision","PL r"],o,"causes"),C("h3",{},"What the search covered"),ci([["cell file",[e.subject.cell_found,"; SHA-256 ",C("code",{},e.subject.cell_sha256)]],["FMU",e.subject.fmus.flatMap((a,c)=>[c>0?"; ":"",`${a.unit?`${a.unit}: `:""}${a.model_name}; SHA-256 `,C("code",{},a.sha256)])],["looked at",oT(n)],["made again by",C("code",{},n.reproduce)]]),C("h3",{},"Assessed by"),C("div",{class:"sign"},["Name","Date","Signature"].map(a=>C("p",{},a))),C("p",{class:"note"},`A hazard is a way, found in the model, for a person to be ${e.settings.criteria?"harmed by what this cell counts as unsafe":"hit harder than ISO/TS 15066 allows"}. This report helps an assessment; it does not show that the cell is safe.`))}var lT=({advice:n})=>n?.changes[0]?.change??(n?"no single change found":"not looked for");function cT(n,t,e){let i=n.hazard(t.worst),[s,r]=xr(t,i),o=ql(t);o.mark(i.body_region);let a=n.topView(t.worst),c=e.of(t.id),l=t.hazards.filter(h=>e.own(h)!==null),d=t.lines.map(({body_region:h,held:u,robot_link:f,ratio:m,hazards:x})=>[u?Xu:Si(h),f,$s(h,m),De(x.length)]);return C("article",{"data-test":"print-cause","data-id":t.id},C("h2",{},qs(t),` ${t.sentence}`),C("p",{class:"severity"},C("b",{},s),` ${r}`),Ku(n,t),C("p",{},[...Ju(n,t).map(([,h])=>h),t.id].join(" · ")),C("div",{class:"print-pictures"},a?$l(a):C("p",{class:"note"},"This report carries no drawing of its worst way."),o.element),C("div",{class:"print-columns"},C("div",{},ju(t)),C("div",{},C("h4",{},"Assessment (ISO 12100)"),ci([...ro.map(({key:h,label:u})=>[u.split(":")[0].toLowerCase(),h==="decision"?e.ofCause(t.id):c[h]]),["PL r",vr(c)??""],["decided apart",l.map(h=>`${h}: ${e.own(h)}`).join(", ")]]))),C("h4",{},`Its worst way, ${t.worst}`),iu(i,n.scan.settings,{short:!0}),C("h4",{},"Ways by region and link"),y_(["body region","hit by","worst","ways"],d.slice(0,zf),"lines"),d.length>zf?C("p",{class:"note"},`And ${fe(d.length-zf,"other pair")} of region and link, less bad; scan.json has them all.`):null)}function v_(n,t){let e=C("section",{class:"print-only",id:"print"});return addEventListener("beforeprint",()=>e.replaceChildren(aT(n,t),...n.whole?[g_(n)]:[],...n.causes.map(i=>cT(n,i,t)))),addEventListener("afterprint",()=>e.replaceChildren()),e}var b_=n=>C("code",{class:"hash"},n);function hT(n){let t=n?.result??String(n);switch(t){case"exact":return"exact";case"not_offered":return"not offered";case"differs":return`WRONG, differs by up to ${n.largest.toExponential(2)}`;case"failed":return`FAILED: ${n.reason}`;default:return t}}function uT({subject:n,tool:t}){let e=n.fmus.map(s=>[s.unit?`FMU ${s.unit}`:"FMU",[`${s.model_name}, FMI ${s.fmi_version}, by ${s.generation_tool||"an unnamed tool"}; SHA-256 `,b_(s.sha256)]]),i=[["tool",t],["cell",n.cell],["cell file",[`${n.cell_found}; SHA-256 `,b_(n.cell_sha256)]],...e];return C("div",{},C("h3",{},"Subject"),C("dl",{},i.map(([s,r])=>C("div",{},C("dt",{},s),C("dd",{},r)))),n.couplings.length>0?C("ul",{},n.couplings.map(s=>C("li",{},s))):null)}var Gf=n=>n.replaceAll("_"," "),dT=[["_m_s"," m/s"],["_s"," s"],["_m"," m"],["_deg"," degrees"]];function M_(n,t){let e=[t].flat().every(r=>typeof r=="number"),[i,s]=e&&dT.find(([r])=>n.endsWith(r))||["",""];return[Gf(n.slice(0,n.length-i.length)),`${Vf(t)}${s}`]}function Vf(n){return typeof n=="number"?String(Number(n.toPrecision(12))):typeof n=="boolean"?n?"yes":"no":Array.isArray(n)?n.map(t=>t!==null&&typeof t=="object"?`(${Vf(t)})`:Vf(t)).join("; ")||"none":n!==null&&typeof n=="object"?Object.entries(n).map(([t,e])=>{let[i,s]=M_(t,e);return e!==null&&typeof e=="object"&&!Array.isArray(e)?`${i} (${s})`:`${i} ${s}`}).join(", "):n===null?"none":String(n)}function fT(n){let t=Object.entries(n).map(([e,i])=>e==="speed_criterion"?[Gf(e),Wl(n)]:M_(e,i));return[C("h3",{},"Settings"),ci(t)]}function pT(n){let t=Object.entries(n).map(([e,i])=>[Gf(e.replace(/_s$/,"")),typeof i=="object"&&i!==null?hT(i):`${i}${e.endsWith("_s")?" s":""}`]);return[C("h3",{},"Self-test of the FMU"),C("p",{class:"note"},"Whether runs repeat exactly, and what saved states, reset and copies are worth."),ci(t)]}function mT({standard_edition:n,tables:t}){let e=t.filter(s=>!s.verified).length,i=t.map(s=>C("tr",{},C("td",{},s.title),C("td",{},s.verified?"verified":"not verified"),C("td",{},s.source),C("td",{},s.confidence)));return C("div",{},C("h3",{},"Limits and tables"),C("p",{},`${n}. ${e} of ${t.length} tables are not yet verified against the purchased standards.`),C("div",{class:"scroll",tabindex:0},C("table",{class:"plain"},C("thead",{},C("tr",{},["table","state","source","confidence"].map(s=>C("th",{scope:"col"},s)))),C("tbody",{},i))))}function S_({scan:n,assumptions:t,reproduce:e}){return Pn("provenance","What was scanned",C("div",{class:"columns"},uT(n),C("div",{},fT(n.settings)),C("div",{},pT(n.self_test))),mT(n),C("h3",{},"Assumptions"),C("ul",{class:"assumptions","data-test":"assumptions"},t.map(i=>C("li",{},i))),C("h3",{},"Reproduce"),C("p",{class:"note"},"In the folder with this report:"),Xs(e),C("p",{class:"note"},"This page carries three.js (MIT licence, © three.js authors) and uPlot (MIT licence, © 2022 Leon Sorokin); the full texts are at the end of its script."))}var w_=.01;function gT(n,t){let e=[...n.keys()].filter(i=>i>0&&n[i]<w_&&n[i-1]>=w_);return e.find(i=>i>=t)??e[0]??-1}function E_(n,t){let e=n.sensors.map(({name:o,detected:a})=>({frame:a.indexOf("1"),kind:"sensor",text:`${o} reports`})).filter(({frame:o})=>o>=0),i=e.length>0?Math.min(...e.map(({frame:o})=>o)):0,s=gT(n.speed_m_s,i);return[...(t.worked??[]).map(o=>({frame:Math.round(o.at_s/n.step),kind:"press",text:tm(o)})),...e,{frame:n.contact_frame,kind:"contact",text:t.class==="separation"?"too near":"contact"},...s>=0?[{frame:s,kind:"rest",text:`${t.robot_link} stands still`}]:[]].sort((o,a)=>o.frame-a.frame)}function T_(){let n=[],t=1,e=1,i=0,s=.5,r=!1,o=null,a=()=>n.forEach(d=>d({frame:i,playing:r}));function c(d){if(!r)return;o??={now:d,frame:i};let h=o.frame+Math.floor((d-o.now)/1e3*(s/e));h!==i&&(i=Math.min(h,t-1),r=i<t-1,a()),requestAnimationFrame(c)}let l={get frame(){return i},get playing(){return r},load(d,h,u){[t,e]=[d,h],l.seek(u)},seek(d){i=Math.max(0,Math.min(t-1,Math.round(d))),r=!1,a()},pause(){r=!1,a()},toggle(){r=!r,o=null,r&&(i=i>=t-1?0:i,requestAnimationFrame(c)),a()},setSpeed(d){s=d,o=null},follow:d=>n.push(d)};return l}var _T="uplot",xT="u-hz",yT="u-vt",vT="u-title",bT="u-wrap",MT="u-under",ST="u-over",wT="u-axis",Vr="u-off",ET="u-select",TT="u-cursor-x",AT="u-cursor-y",CT="u-cursor-pt",RT="u-legend",PT="u-live",IT="u-inline",LT="u-series",DT="u-marker",A_="u-label",NT="u-value",Sl="width",wl="height";var C_="bottom",Yo="left",Hf="right",op="#000",R_=op+"0",Wf="mousemove",P_="mousedown",$f="mouseup",I_="mouseenter",L_="mouseleave",D_="dblclick",FT="resize",UT="scroll",N_="change",cu="dppxchange",ap="--",ea=typeof window<"u",Jf=ea?document:null,Jo=ea?window:null,OT=ea?navigator:null,Ie,ru;function Kf(){let n=devicePixelRatio;Ie!=n&&(Ie=n,ru&&Qf(N_,ru,Kf),ru=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),Gr(N_,ru,Kf),Jo.dispatchEvent(new CustomEvent(cu)))}function _i(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function jf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function tn(n,t,e){n.style[t]=e+"px"}function qi(n,t,e,i){let s=Jf.createElement(n);return t!=null&&_i(s,t),e?.insertBefore(s,i),s}function Ri(n,t){return qi("div",n,t)}var F_=new WeakMap;function ms(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=F_.get(n);r!=o&&(n.style.transform=r,F_.set(n,r),t<0||e<0||t>i||e>s?_i(n,Vr):jf(n,Vr))}var U_=new WeakMap;function O_(n,t,e){let i=t+e,s=U_.get(n);i!=s&&(U_.set(n,i),n.style.background=t,n.style.borderColor=e)}var k_=new WeakMap;function B_(n,t,e,i){let s=t+""+e,r=k_.get(n);s!=r&&(k_.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var lp={passive:!0},kT={...lp,capture:!0};function Gr(n,t,e,i){t.addEventListener(n,e,i?kT:lp)}function Qf(n,t,e,i){t.removeEventListener(n,e,lp)}ea&&Kf();function Yi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:xi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function fx(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var px=n=>n!=null,mx=n=>n!=null&&n>0,du=fx(px),BT=fx(mx);function zT(n,t,e,i=0,s=!1){let r=s?BT:du,o=s?mx:px;[t,e]=r(n,t,e);let a=n[t],c=n[t];if(t>-1)if(i==1)a=n[t],c=n[e];else if(i==-1)a=n[e],c=n[t];else for(let l=t;l<=e;l++){let d=n[l];o(d)&&(d<a?a=d:d>c&&(c=d))}return[a??Xe,c??-Xe]}function fu(n,t,e,i){let s=G_(n),r=G_(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Fs:gx,a=s==1?xi:Pi,c=r==1?Pi:xi,l=a(o(wn(n))),d=c(o(wn(t))),h=Ko(e,l),u=Ko(e,d);return e==10&&(l<0&&(h=qe(h,-l)),d<0&&(u=qe(u,-d))),i||e==2?(n=h*s,t=u*r):(n=vx(n,h),t=pu(t,u)),[n,t]}function cp(n,t,e,i){let s=fu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var hp=.1,z_={mode:3,pad:hp},Tl={pad:0,soft:null,mode:0},VT={min:Tl,max:Tl};function hu(n,t,e,i){return mu(e)?V_(n,t,e):(Tl.pad=e,Tl.soft=i?0:null,Tl.mode=i?3:0,V_(n,t,VT))}function Re(n,t){return n??t}function GT(n,t,e){for(t=Re(t,0),e=Re(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function V_(n,t,e){let i=e.min,s=e.max,r=Re(i.pad,0),o=Re(s.pad,0),a=Re(i.hard,-Xe),c=Re(s.hard,Xe),l=Re(i.soft,Xe),d=Re(s.soft,-Xe),h=Re(i.mode,0),u=Re(s.mode,0),f=t-n,m=Fs(f),x=ti(wn(n),wn(t)),p=Fs(x),g=wn(p-m);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&l!=Xe&&(r=0),u==2&&d!=-Xe&&(o=0)));let y=f||x||1e3,M=Fs(y),b=Ko(10,xi(M)),R=y*(f==0?n==0?.1:1:r),w=qe(vx(n-R,b/10),24),_=n>=l&&(h==1||h==3&&w<=l||h==2&&w>=l)?l:Xe,T=ti(a,w<_&&n>=_?_:Zi(_,w)),k=y*(f==0?t==0?.1:1:o),D=qe(pu(t+k,b/10),24),N=t<=d&&(u==1||u==3&&D>=d||u==2&&D<=d)?d:-Xe,G=Zi(c,D>N&&t<=N?N:ti(N,D));return T==G&&T==0&&(G=100),[T,G]}var HT=new Intl.NumberFormat(ea?OT.language:"en-US"),up=n=>HT.format(n),yi=Math,lu=yi.PI,wn=yi.abs,xi=yi.floor,Sn=yi.round,Pi=yi.ceil,Zi=yi.min,ti=yi.max,Ko=yi.pow,G_=yi.sign,Fs=yi.log10,gx=yi.log2,WT=(n,t=1)=>yi.sinh(n)*t,Xf=(n,t=1)=>yi.asinh(n/t),Xe=1/0;function H_(n){return(Fs((n^n>>31)-(n>>31))|0)+1}function tp(n,t,e){return Zi(ti(n,t),e)}function _x(n){return typeof n=="function"}function we(n){return _x(n)?n:()=>n}var $T=()=>{},xx=n=>n,yx=(n,t)=>t,XT=n=>null,W_=n=>!0,$_=(n,t)=>n==t,qT=/\.\d*?(?=9{6,}|0{6,})/gm,Hr=n=>{if(Mx(n)||fr.has(n))return n;let t=`${n}`,e=t.match(qT);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Hr(s)}e${r}`}return qe(n,i)};function Br(n,t){return Hr(qe(Hr(n/t))*t)}function pu(n,t){return Hr(Pi(Hr(n/t))*t)}function vx(n,t){return Hr(xi(Hr(n/t))*t)}function qe(n,t=0){if(Mx(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Sn(i)/e}var fr=new Map;function bx(n){return((""+n).split(".")[1]||"").length}function Cl(n,t,e,i){let s=[],r=i.map(bx);for(let o=t;o<e;o++){let a=wn(o),c=qe(Ko(n,o),a);for(let l=0;l<i.length;l++){let d=n==10?+`${i[l]}e${o}`:i[l]*c,h=(o>=0?0:a)+(o>=r[l]?0:r[l]),u=n==10?d:qe(d,h);s.push(u),fr.set(u,h)}}return s}var Al={},dp=[],jo=[null,null],dr=Array.isArray,Mx=Number.isInteger,YT=n=>n===void 0;function X_(n){return typeof n=="string"}function mu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function ZT(n){return n!=null&&typeof n=="object"}var JT=Object.getPrototypeOf(Uint8Array),Sx="__proto__";function Qo(n,t=mu){let e;if(dr(n)){let i=n.find(s=>s!=null);if(dr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Qo(n[s],t)}else e=n.slice()}else if(n instanceof JT)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Sx&&(e[i]=Qo(n[i],t))}else e=n;return e}function xn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Sx&&(mu(n[s])?xn(n[s],Qo(i[s])):n[s]=Qo(i[s]))}return n}var KT=0,jT=1,QT=2;function tA(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function eA(n,t){if(sA(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return rA(o[0])||(o=iA(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let d=0;d<l;d++)e.add(c[d])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let d=a[l],h=Array(s).fill(void 0),u=t?t[o][l]:jT,f=[];for(let m=0;m<d.length;m++){let x=d[m],p=r.get(c[m]);x===null?u!=KT&&(h[p]=x,u==QT&&f.push(p)):h[p]=x}tA(h,f,s),i.push(h)}}return i}var nA=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function iA(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[i[c]];s.push(a)}return s}function sA(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function rA(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ti(1,xi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var wx=["January","February","March","April","May","June","July","August","September","October","November","December"],Ex=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Tx(n){return n.slice(0,3)}var oA=Ex.map(Tx),aA=wx.map(Tx),lA={MMMM:wx,MMM:aA,WWWW:Ex,WWW:oA};function Ml(n){return(n<10?"0":"")+n}function cA(n){return(n<10?"00":n<100?"0":"")+n}var hA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Ml(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ml(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Ml(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ml(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ml(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>cA(n.getMilliseconds())};function fp(n,t){t=t||lA;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?hA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var uA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function dA(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==uA?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Ax=n=>n%1==0,uu=[1,2,2.5,5],fA=Cl(10,-32,0,uu),Cx=Cl(10,0,32,uu),pA=Cx.filter(Ax),zr=fA.concat(Cx),pp=`
`,Rx="{YYYY}",q_=pp+Rx,Px="{M}/{D}",El=pp+Px,ou=El+"/{YY}",Ix="{aa}",mA="{h}:{mm}",Zo=mA+Ix,Y_=pp+Zo,Z_=":{ss}",Ue=null;function Lx(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,c=(n==1?Cl(10,0,3,uu).filter(Ax):Cl(10,-3,0,uu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Rx,Ue,Ue,Ue,Ue,Ue,Ue,1],[s*28,"{MMM}",q_,Ue,Ue,Ue,Ue,Ue,1],[s,Px,q_,Ue,Ue,Ue,Ue,Ue,1],[i,"{h}"+Ix,ou,Ue,El,Ue,Ue,Ue,1],[e,Zo,ou,Ue,El,Ue,Ue,Ue,1],[t,Z_,ou+" "+Zo,Ue,El+" "+Zo,Ue,Y_,Ue,1],[n,Z_+".{fff}",ou+" "+Zo,Ue,El+" "+Zo,Ue,Y_,Ue,1]];function d(h){return(u,f,m,x,p,g)=>{let y=[],M=p>=o,b=p>=r&&p<o,R=h(m),w=qe(R*n,3),_=qf(R.getFullYear(),M?0:R.getMonth(),b||M?1:R.getDate()),T=qe(_*n,3);if(b||M){let k=b?p/r:0,D=M?p/o:0,N=w==T?w:qe(qf(_.getFullYear()+D,_.getMonth()+k,1)*n,3),G=new Date(Sn(N/n)),W=G.getFullYear(),P=G.getMonth();for(let B=0;N<=x;B++){let Y=qf(W+D*B,P+k*B,1),H=Y-h(qe(Y*n,3));N=qe((+Y+H)*n,3),N<=x&&y.push(N)}}else{let k=p>=s?s:p,D=xi(m)-xi(w),N=T+D+pu(w-T,k);y.push(N);let G=h(N),W=G.getHours()+G.getMinutes()/e+G.getSeconds()/i,P=p/i,B=u.axes[f]._space,Y=g/B;for(;N=qe(N+p,n==1?0:3),!(N>x);)if(P>1){let H=xi(qe(W+P,6))%24,J=h(N).getHours()-H;J>1&&(J=-1),N-=J*i,W=(W+P)%24;let $=y[y.length-1];qe((N-$)/p,3)*Y>=.7&&y.push(N)}else y.push(N)}return y}}return[c,l,d]}var[gA,_A,xA]=Lx(1),[yA,vA,bA]=Lx(.001);Cl(2,-53,53,[1]);function J_(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function K_(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],c,l,d,h,u,f;return i.map(m=>{let x=n(m),p=x.getFullYear(),g=x.getMonth(),y=x.getDate(),M=x.getHours(),b=x.getMinutes(),R=x.getSeconds(),w=p!=c&&a[2]||g!=l&&a[3]||y!=d&&a[4]||M!=h&&a[5]||b!=u&&a[6]||R!=f&&a[7]||a[1];return c=p,l=g,d=y,h=M,u=b,f=R,w(x)})}}function MA(n,t){let e=fp(t);return(i,s,r,o,a)=>s.map(c=>e(n(c)))}function qf(n,t,e){return new Date(n,t,e)}function j_(n,t){return t(n)}var SA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Q_(n,t){return(e,i,s,r)=>r==null?ap:t(n(i))}function wA(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function EA(n,t){return n.series[t].fill(n,t)}var TA={show:!0,live:!0,isolate:!1,mount:$T,markers:{show:!0,width:2,stroke:wA,fill:EA,dash:"solid"},idx:null,idxs:null,values:[]};function AA(n,t){let e=n.cursor.points,i=Ri(),s=e.size(n,t);tn(i,Sl,s),tn(i,wl,s);let r=s/-2;tn(i,"marginLeft",r),tn(i,"marginTop",r);let o=e.width(n,t,s);return o&&tn(i,"borderWidth",o),i}function CA(n,t){let e=n.series[t].points;return e._fill||e._stroke}function RA(n,t){let e=n.series[t].points;return e._stroke||e._fill}function PA(n,t){return n.series[t].points.size}var Yf=[0,0];function IA(n,t,e){return Yf[0]=t,Yf[1]=e,Yf}function au(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Zf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var LA={show:!0,x:!0,y:!0,lock:!1,move:IA,points:{one:!1,show:AA,size:PA,width:0,stroke:RA,fill:CA},bind:{mousedown:au,mouseup:au,click:au,dblclick:au,mousemove:Zf,mouseleave:Zf,mouseenter:Zf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Dx={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mp=xn({},Dx,{filter:yx}),Nx=xn({},mp,{size:10}),Fx=xn({},Dx,{show:!1}),gp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Ux="bold "+gp,Ox=1.5,tx={show:!0,scale:"x",stroke:op,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ux,side:2,grid:mp,ticks:Nx,border:Fx,font:gp,lineGap:Ox,rotate:0},DA="Value",NA="Time",ex={show:!0,scale:"x",auto:!1,sorted:1,min:Xe,max:-Xe,idxs:[]};function FA(n,t,e,i,s){return t.map(r=>r==null?"":up(r))}function UA(n,t,e,i,s,r,o){let a=[],c=fr.get(s)||0;e=o?e:qe(pu(e,s),c);for(let l=e;l<=i;l=qe(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function ep(n,t,e,i,s,r,o){let a=[],c=n.scales[n.axes[t].scale].log,l=c==10?Fs:gx,d=xi(l(e));s=Ko(c,d),c==10&&(s=zr[Yi(s,zr)]);let h=e,u=s*c;c==10&&(u=zr[Yi(u,zr)]);do a.push(h),h=h+s,c==10&&!fr.has(h)&&(h=qe(h,fr.get(s))),h>=u&&(s=h,u=s*c,c==10&&(u=zr[Yi(u,zr)]));while(h<=i);return a}function OA(n,t,e,i,s,r,o){let c=n.scales[n.axes[t].scale].asinh,l=i>c?ep(n,t,ti(c,e),i,s):[c],d=i>=0&&e<=0?[0]:[];return(e<-c?ep(n,t,ti(c,-i),-e,s):[c]).reverse().map(u=>-u).concat(d,l)}var kx=/./,kA=/[12357]/,BA=/[125]/,nx=/1/,np=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function zA(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],c=n.valToPos,l=r._space,d=c(10,o),h=c(9,o)-d>=l?kx:c(7,o)-d>=l?kA:c(5,o)-d>=l?BA:nx;if(h==nx){let u=wn(c(1,o)-d);if(u<l)return np(t.slice().reverse(),a.distr,h,Pi(l/u)).reverse()}return np(t,a.distr,h,1)}function VA(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,c=n.valToPos,l=wn(c(1,o)-c(2,o));return l<a?np(t.slice().reverse(),3,kx,Pi(a/l)).reverse():t}function GA(n,t,e,i){return i==null?ap:t==null?"":up(t)}var ix={show:!0,scale:"y",stroke:op,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ux,side:3,grid:mp,ticks:Nx,border:Fx,font:gp,lineGap:Ox,rotate:0};function HA(n,t){let e=3+(n||1)*2;return qe(e*t,3)}function WA(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=wn(o-r),c=n.series[t],l=a/(c.points.space*Ie);return i[1]-i[0]<=l}var sx={scale:null,auto:!0,sorted:0,min:Xe,max:-Xe},Bx=(n,t,e,i,s)=>s,rx={show:!0,auto:!0,sorted:0,gaps:Bx,alpha:1,facets:[xn({},sx,{scale:"x"}),xn({},sx,{scale:"y"})]},ox={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Bx,alpha:1,points:{show:WA,filter:null},values:null,min:Xe,max:-Xe,idxs:[],path:null,clip:null};function $A(n,t,e,i,s){return e/10}var zx={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},XA=xn({},zx,{time:!1,ori:1}),ax={};function Vx(n,t){let e=ax[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,c,l){for(let d=0;d<e.plots.length;d++)e.plots[d]!=s&&e.plots[d].pub(i,s,r,o,a,c,l)}},n!=null&&(ax[n]=e)),e}var ta=1,ip=2;function Wr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,c=r[0],l=i==2?r[1]:r[t],d=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,m=a.width,x=a.height,p=n.valToPosH,g=n.valToPosV;return d.ori==0?e(s,c,l,d,h,p,g,u,f,m,x,_u,na,yu,Hx,$x):e(s,c,l,d,h,g,p,f,u,x,m,xu,ia,yp,Wx,Xx)}function _p(n,t){let e=0,i=0,s=Re(n.bands,dp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function qA(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,c=n.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Us(n,t,e,i,s,r){return Wr(n,t,(o,a,c,l,d,h,u,f,m,x,p)=>{let g=o.pxRound,y=l.dir*(l.ori==0?1:-1),M=l.ori==0?na:ia,b,R;y==1?(b=e,R=i):(b=i,R=e);let w=g(h(a[b],l,x,f)),_=g(u(c[b],d,p,m)),T=g(h(a[R],l,x,f)),k=g(u(r==1?d.max:d.min,d,p,m)),D=new Path2D(s);return M(D,T,k),M(D,w,k),M(D,w,_),D})}function gu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?yu:yp,c=e;for(let h=0;h<n.length;h++){let u=n[h];if(u[1]>u[0]){let f=u[0]-c;f>0&&a(o,c,i,f,i+r),c=u[1]}}let l=e+s-c,d=10;l>0&&a(o,c,i-d/2,l,i+r+d)}return o}function YA(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function xp(n,t,e,i,s,r,o){let a=[],c=n.length;for(let l=s==1?e:i;l>=e&&l<=i;l+=s)if(t[l]===null){let h=l,u=l;if(s==1)for(;++l<=i&&t[l]===null;)u=l;else for(;--l>=e&&t[l]===null;)u=l;let f=r(n[h]),m=u==h?f:r(n[u]),x=h-s;f=o<=0&&x>=0&&x<c?r(n[x]):f;let g=u+s;m=o>=0&&g>=0&&g<c?r(n[g]):m,m>=f&&a.push([f,m])}return a}function lx(n){return n==0?xx:n==1?Sn:t=>Br(t,n)}function Gx(n){let t=n==0?_u:xu,e=n==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},i=n==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,d=0)=>{l==0&&d==0?i(s,r,o,a,c):(l=Zi(l,a/2,c/2),d=Zi(d,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,d),e(s,r,o+c,r,o,d),e(s,r,o,r+a,o,l),s.closePath())}}var _u=(n,t,e)=>{n.moveTo(t,e)},xu=(n,t,e)=>{n.moveTo(e,t)},na=(n,t,e)=>{n.lineTo(t,e)},ia=(n,t,e)=>{n.lineTo(e,t)},yu=Gx(0),yp=Gx(1),Hx=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Wx=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},$x=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Xx=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function qx(n){return(t,e,i,s,r)=>Wr(t,e,(o,a,c,l,d,h,u,f,m,x,p)=>{let{pxRound:g,points:y}=o,M,b;l.ori==0?(M=_u,b=Hx):(M=xu,b=Wx);let R=qe(y.width*Ie,3),w=(y.size-y.width)/2*Ie,_=qe(w*2,3),T=new Path2D,k=new Path2D,{left:D,top:N,width:G,height:W}=t.bbox;yu(k,D-_,N-_,G+_*2,W+_*2);let P=B=>{if(c[B]!=null){let Y=g(h(a[B],l,x,f)),H=g(u(c[B],d,p,m));M(T,Y+w,H),b(T,Y,H,w,0,lu*2)}};if(r)r.forEach(P);else for(let B=i;B<=s;B++)P(B);return{stroke:R>0?T:null,fill:T,clip:k,flags:ta|ip}})}function Yx(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var ZA=Yx(na),JA=Yx(ia);function Zx(n){let t=Re(n?.alignGaps,0);return(e,i,s,r)=>Wr(e,i,(o,a,c,l,d,h,u,f,m,x,p)=>{[s,r]=du(c,s,r);let g=o.pxRound,y=W=>g(h(W,l,x,f)),M=W=>g(u(W,d,p,m)),b,R;l.ori==0?(b=na,R=ZA):(b=ia,R=JA);let w=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ta},T=_.stroke,k=!1;if(r-s>=x*4){let W=lt=>e.posToVal(lt,l.key,!0),P=null,B=null,Y,H,ht,U=y(a[w==1?s:r]),J=y(a[s]),$=y(a[r]),st=W(w==1?J+1:$-1);for(let lt=w==1?s:r;lt>=s&&lt<=r;lt+=w){let Z=a[lt],mt=(w==1?Z<st:Z>st)?U:y(Z),Mt=c[lt];mt==U?Mt!=null?(H=Mt,P==null?(b(T,mt,M(H)),Y=P=B=H):H<P?P=H:H>B&&(B=H)):Mt===null&&(k=!0):(P!=null&&R(T,U,M(P),M(B),M(Y),M(H)),Mt!=null?(H=Mt,b(T,mt,M(H)),P=B=Y=H):(P=B=null,Mt===null&&(k=!0)),U=mt,st=W(U+w))}P!=null&&P!=B&&ht!=U&&R(T,U,M(P),M(B),M(Y),M(H))}else for(let W=w==1?s:r;W>=s&&W<=r;W+=w){let P=c[W];P===null?k=!0:P!=null&&b(T,y(a[W]),M(P))}let[N,G]=_p(e,i);if(o.fill!=null||N!=0){let W=_.fill=new Path2D(T),P=o.fillTo(e,i,o.min,o.max,N),B=M(P),Y=y(a[s]),H=y(a[r]);w==-1&&([H,Y]=[Y,H]),b(W,H,B),b(W,Y,B)}if(!o.spanGaps){let W=[];k&&W.push(...xp(a,c,s,r,w,y,t)),_.gaps=W=o.gaps(e,i,s,r,W),_.clip=gu(W,l.ori,f,m,x,p)}return G!=0&&(_.band=G==2?[Us(e,i,s,r,T,-1),Us(e,i,s,r,T,1)]:Us(e,i,s,r,T,G)),_})}function KA(n){let t=Re(n.align,1),e=Re(n.ascDesc,!1),i=Re(n.alignGaps,0),s=Re(n.extend,!1);return(r,o,a,c)=>Wr(r,o,(l,d,h,u,f,m,x,p,g,y,M)=>{[a,c]=du(h,a,c);let b=l.pxRound,{left:R,width:w}=r.bbox,_=J=>b(m(J,u,y,p)),T=J=>b(x(J,f,M,g)),k=u.ori==0?na:ia,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ta},N=D.stroke,G=u.dir*(u.ori==0?1:-1),W=T(h[G==1?a:c]),P=_(d[G==1?a:c]),B=P,Y=P;s&&t==-1&&(Y=R,k(N,Y,W)),k(N,P,W);for(let J=G==1?a:c;J>=a&&J<=c;J+=G){let $=h[J];if($==null)continue;let st=_(d[J]),lt=T($);t==1?k(N,st,W):k(N,B,lt),k(N,st,lt),W=lt,B=st}let H=B;s&&t==1&&(H=R+w,k(N,H,W));let[ht,U]=_p(r,o);if(l.fill!=null||ht!=0){let J=D.fill=new Path2D(N),$=l.fillTo(r,o,l.min,l.max,ht),st=T($);k(J,H,st),k(J,Y,st)}if(!l.spanGaps){let J=[];J.push(...xp(d,h,a,c,G,_,i));let $=l.width*Ie/2,st=e||t==1?$:-$,lt=e||t==-1?-$:$;J.forEach(Z=>{Z[0]+=st,Z[1]+=lt}),D.gaps=J=l.gaps(r,o,a,c,J),D.clip=gu(J,u.ori,p,g,y,M)}return U!=0&&(D.band=U==2?[Us(r,o,a,c,N,-1),Us(r,o,a,c,N,1)]:Us(r,o,a,c,N,U)),D})}function cx(n,t,e,i,s,r,o=Xe){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(t[c]!==void 0){if(a!=null){let d=wn(n[c]-n[a]);d<l&&(l=d,o=wn(e(n[c],i,s,r)-e(n[a],i,s,r)))}a=c}}return o}function jA(n){n=n||Al;let t=Re(n.size,[.6,Xe,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=we(s),o=1-t[0],a=Re(t[1],Xe),c=Re(t[2],1),l=Re(n.disp,Al),d=Re(n.each,f=>{}),{fill:h,stroke:u}=l;return(f,m,x,p)=>Wr(f,m,(g,y,M,b,R,w,_,T,k,D,N)=>{let G=g.pxRound,W=e,P=i*Ie,B=a*Ie,Y=c*Ie,H,ht;b.ori==0?[H,ht]=r(f,m):[ht,H]=r(f,m);let U=b.dir*(b.ori==0?1:-1),J=b.ori==0?yu:yp,$=b.ori==0?d:(Dt,jt,ue,Ct,$e,Yt,Qt)=>{d(Dt,jt,ue,$e,Ct,Qt,Yt)},st=Re(f.bands,dp).find(Dt=>Dt.series[0]==m),lt=st!=null?st.dir:0,Z=g.fillTo(f,m,g.min,g.max,lt),pt=G(_(Z,R,N,k)),mt,Mt,tt,xt=D,it=G(g.width*Ie),rt=!1,Ft=null,Ut=null,Lt=null,Jt=null;h!=null&&(it==0||u!=null)&&(rt=!0,Ft=h.values(f,m,x,p),Ut=new Map,new Set(Ft).forEach(Dt=>{Dt!=null&&Ut.set(Dt,new Path2D)}),it>0&&(Lt=u.values(f,m,x,p),Jt=new Map,new Set(Lt).forEach(Dt=>{Dt!=null&&Jt.set(Dt,new Path2D)})));let{x0:he,size:Ee}=l;if(he!=null&&Ee!=null){W=1,y=he.values(f,m,x,p),he.unit==2&&(y=y.map(ue=>f.posToVal(T+ue*D,b.key,!0)));let Dt=Ee.values(f,m,x,p);Ee.unit==2?Mt=Dt[0]*D:Mt=w(Dt[0],b,D,T)-w(0,b,D,T),xt=cx(y,M,w,b,D,T,xt),tt=xt-Mt+P}else xt=cx(y,M,w,b,D,T,xt),tt=xt*o+P,Mt=xt-tt;tt<1&&(tt=0),it>=Mt/2&&(it=0),tt<5&&(G=xx);let ve=tt>0,Ge=xt-tt-(ve?it:0);Mt=G(tp(Ge,Y,B)),mt=(W==0?Mt/2:W==U?0:Mt)-W*U*((W==0?P/2:0)+(ve?it/2:0));let de={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},We=rt?null:new Path2D,Oe=null;if(st!=null)Oe=f.data[st.series[1]];else{let{y0:Dt,y1:jt}=l;Dt!=null&&jt!=null&&(M=jt.values(f,m,x,p),Oe=Dt.values(f,m,x,p))}let on=H*Mt,z=ht*Mt;for(let Dt=U==1?x:p;Dt>=x&&Dt<=p;Dt+=U){let jt=M[Dt];if(jt==null)continue;if(Oe!=null){let K=Oe[Dt]??0;if(jt-K==0)continue;pt=_(K,R,N,k)}let ue=b.distr!=2||l!=null?y[Dt]:Dt,Ct=w(ue,b,D,T),$e=_(Re(jt,Z),R,N,k),Yt=G(Ct-mt),Qt=G(ti($e,pt)),I=G(Zi($e,pt)),S=Qt-I;if(jt!=null){let K=jt<0?z:on,_t=jt<0?on:z;rt?(it>0&&Lt[Dt]!=null&&J(Jt.get(Lt[Dt]),Yt,I+xi(it/2),Mt,ti(0,S-it),K,_t),Ft[Dt]!=null&&J(Ut.get(Ft[Dt]),Yt,I+xi(it/2),Mt,ti(0,S-it),K,_t)):J(We,Yt,I+xi(it/2),Mt,ti(0,S-it),K,_t),$(f,m,Dt,Yt-it/2,I,Mt+it,S)}}return it>0?de.stroke=rt?Jt:We:rt||(de._fill=g.width==0?g._fill:g._stroke??g._fill,de.width=0),de.fill=rt?Ut:We,de})}function QA(n,t){let e=Re(t?.alignGaps,0);return(i,s,r,o)=>Wr(i,s,(a,c,l,d,h,u,f,m,x,p,g)=>{[r,o]=du(l,r,o);let y=a.pxRound,M=H=>y(u(H,d,p,m)),b=H=>y(f(H,h,g,x)),R,w,_;d.ori==0?(R=_u,_=na,w=$x):(R=xu,_=ia,w=Xx);let T=d.dir*(d.ori==0?1:-1),k=M(c[T==1?r:o]),D=k,N=[],G=[];for(let H=T==1?r:o;H>=r&&H<=o;H+=T)if(l[H]!=null){let U=c[H],J=M(U);N.push(D=J),G.push(b(l[H]))}let W={stroke:n(N,G,R,_,w,y),fill:null,clip:null,band:null,gaps:null,flags:ta},P=W.stroke,[B,Y]=_p(i,s);if(a.fill!=null||B!=0){let H=W.fill=new Path2D(P),ht=a.fillTo(i,s,a.min,a.max,B),U=b(ht);_(H,D,U),_(H,k,U)}if(!a.spanGaps){let H=[];H.push(...xp(c,l,r,o,T,M,e)),W.gaps=H=a.gaps(i,s,r,o,H),W.clip=gu(H,d.ori,m,x,p,g)}return Y!=0&&(W.band=Y==2?[Us(i,s,r,o,P,-1),Us(i,s,r,o,P,1)]:Us(i,s,r,o,P,Y)),W})}function tC(n){return QA(eC,n)}function eC(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let c=Array(o),l=Array(o-1),d=Array(o-1),h=Array(o-1);for(let u=0;u<o-1;u++)d[u]=t[u+1]-t[u],h[u]=n[u+1]-n[u],l[u]=d[u]/h[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(h[u-1]+h[u])/((2*h[u]+h[u-1])/l[u-1]+(h[u]+2*h[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+h[u]/3,t[u]+c[u]*h[u]/3,n[u+1]-h[u]/3,t[u+1]-c[u+1]*h[u]/3,n[u+1],t[u+1])}return a}var sp=new Set;function hx(){for(let n of sp)n.syncRect(!0)}ea&&(Gr(FT,Jo,hx),Gr(UT,Jo,hx,!0),Gr(cu,Jo,()=>{On.pxRatio=Ie}));var nC=Zx(),iC=qx();function ux(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>rp(r,o,t,e))}function sC(n,t){return n.map((e,i)=>i==0?{}:xn({},t,e))}function rp(n,t,e,i){return xn({},t==0?e:i,n)}function Jx(n,t,e){return t==null?jo:[t,e]}var rC=Jx;function oC(n,t,e){return t==null?jo:hu(t,e,hp,!0)}function Kx(n,t,e,i){return t==null?jo:fu(t,e,n.scales[i].log,!1)}var aC=Kx;function jx(n,t,e,i){return t==null?jo:cp(t,e,n.scales[i].log,!1)}var lC=jx;function cC(n,t,e,i,s){let r=ti(H_(n),H_(t)),o=t-n,a=Yi(s/i*o,e);do{let c=e[a],l=i*c/o;if(l>=s&&r+(c<5?fr.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function dx(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Sn((e=+s)*Ie))+"px"),[n,t,e]}function hC(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=qe(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function On(n,t,e){let i={mode:Re(n.mode,1)},s=i.mode;function r(v,E,L,F){let q=E.valToPct(v);return F+L*(E.dir==-1?1-q:q)}function o(v,E,L,F){let q=E.valToPct(v);return F+L*(E.dir==-1?q:1-q)}function a(v,E,L,F){return E.ori==0?r(v,E,L,F):o(v,E,L,F)}i.valToPosH=r,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=Ri(_T);if(n.id!=null&&(l.id=n.id),_i(l,n.class),n.title){let v=Ri(vT,l);v.textContent=n.title}let d=qi("canvas"),h=i.ctx=d.getContext("2d"),u=Ri(bT,l);Gr("click",u,v=>{v.target===m&&(Ze!=Kr||en!=jr)&&Dn.click(i,v)},!0);let f=i.under=Ri(MT,u);u.appendChild(d);let m=i.over=Ri(ST,u);n=Qo(n);let x=+Re(n.pxAlign,1),p=lx(x);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let g=n.ms||.001,y=i.series=s==1?ux(n.series||[],ex,ox,!1):sC(n.series||[null],rx),M=i.axes=ux(n.axes||[],tx,ix,!0),b=i.scales={},R=i.bands=n.bands||[];R.forEach(v=>{v.fill=we(v.fill||null),v.dir=Re(v.dir,-1)});let w=s==2?y[1].facets[0].scale:y[0].scale,_={axes:ys,series:xe},T=(n.drawOrder||["axes","series"]).map(v=>_[v]);function k(v){let E=v.distr==3?L=>Fs(L>0?L:v.clamp(i,L,v.min,v.max,v.key)):v.distr==4?L=>Xf(L,v.asinh):v.distr==100?L=>v.fwd(L):L=>L;return L=>{let F=E(L),{_min:q,_max:et}=v,ft=et-q;return(F-q)/ft}}function D(v){let E=b[v];if(E==null){let L=(n.scales||Al)[v]||Al;if(L.from!=null){D(L.from);let F=xn({},b[L.from],L,{key:v});F.valToPct=k(F),b[v]=F}else{E=b[v]=xn({},v==w?zx:XA,L),E.key=v;let F=E.time,q=E.range,et=dr(q);if((v!=w||s==2&&!F)&&(et&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?z_:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?z_:{mode:1,hard:q[1],soft:q[1]}},et=!1),!et&&mu(q))){let ft=q;q=(yt,Tt,Vt)=>Tt==null?jo:hu(Tt,Vt,ft)}E.range=we(q||(F?rC:v==w?E.distr==3?aC:E.distr==4?lC:Jx:E.distr==3?Kx:E.distr==4?jx:oC)),E.auto=we(et?!1:E.auto),E.clamp=we(E.clamp||$A),E._min=E._max=null,E.valToPct=k(E)}}}D("x"),D("y"),s==1&&y.forEach(v=>{D(v.scale)}),M.forEach(v=>{D(v.scale)});for(let v in n.scales)D(v);let N=b[w],G=N.distr,W,P;N.ori==0?(_i(l,xT),W=r,P=o):(_i(l,yT),W=o,P=r);let B={};for(let v in b){let E=b[v];(E.min!=null||E.max!=null)&&(B[v]={min:E.min,max:E.max},E.min=E.max=null)}let Y=n.tzDate||(v=>new Date(Sn(v/g))),H=n.fmtDate||fp,ht=g==1?xA(Y):bA(Y),U=K_(Y,J_(g==1?_A:vA,H)),J=Q_(Y,j_(SA,H)),$=[],st=i.legend=xn({},TA,n.legend),lt=i.cursor=xn({},LA,{drag:{y:s==2}},n.cursor),Z=st.show,pt=lt.show,mt=st.markers;st.idxs=$,mt.width=we(mt.width),mt.dash=we(mt.dash),mt.stroke=we(mt.stroke),mt.fill=we(mt.fill);let Mt,tt,xt,it=[],rt=[],Ft,Ut=!1,Lt={};if(st.live){let v=y[1]?y[1].values:null;Ut=v!=null,Ft=Ut?v(i,1,0):{_:0};for(let E in Ft)Lt[E]=ap}if(Z)if(Mt=qi("table",RT,l),xt=qi("tbody",null,Mt),st.mount(i,Mt),Ut){tt=qi("thead",null,Mt,xt);let v=qi("tr",null,tt);qi("th",null,v);for(var Jt in Ft)qi("th",A_,v).textContent=Jt}else _i(Mt,IT),st.live&&_i(Mt,PT);let he={show:!0},Ee={show:!1};function ve(v,E){if(E==0&&(Ut||!st.live||s==2))return jo;let L=[],F=qi("tr",LT,xt,xt.childNodes[E]);_i(F,v.class),v.show||_i(F,Vr);let q=qi("th",null,F);if(mt.show){let yt=Ri(DT,q);if(E>0){let Tt=mt.width(i,E);Tt&&(yt.style.border=Tt+"px "+mt.dash(i,E)+" "+mt.stroke(i,E)),yt.style.background=mt.fill(i,E)}}let et=Ri(A_,q);v.label instanceof HTMLElement?et.appendChild(v.label):et.textContent=v.label,E>0&&(mt.show||(et.style.color=v.width>0?mt.stroke(i,E):mt.fill(i,E)),de("click",q,yt=>{if(lt._lock)return;ne(yt);let Tt=y.indexOf(v);if((yt.ctrlKey||yt.metaKey)!=st.isolate){let Vt=y.some((Gt,Wt)=>Wt>0&&Wt!=Tt&&Gt.show);y.forEach((Gt,Wt)=>{Wt>0&&ts(Wt,Vt?Wt==Tt?he:Ee:he,!0,gn.setSeries)})}else ts(Tt,{show:!v.show},!0,gn.setSeries)},!1),ie&&de(I_,q,yt=>{lt._lock||(ne(yt),ts(y.indexOf(v),to,!0,gn.setSeries))},!1));for(var ft in Ft){let yt=qi("td",NT,F);yt.textContent="--",L.push(yt)}return[F,L]}let Ge=new Map;function de(v,E,L,F=!0){let q=Ge.get(E)||{},et=lt.bind[v](i,E,L,F);et&&(Gr(v,E,q[v]=et),Ge.set(E,q))}function We(v,E,L){let F=Ge.get(E)||{};for(let q in F)(v==null||q==v)&&(Qf(q,E,F[q]),delete F[q]);v==null&&Ge.delete(E)}let Oe=0,on=0,z=0,Dt=0,jt=0,ue=0,Ct=jt,$e=ue,Yt=z,Qt=Dt,I=0,S=0,K=0,_t=0;i.bbox={};let dt=!1,wt=!1,Et=!1,ot=!1,ct=!1,vt=!1;function V(v,E,L){(L||v!=i.width||E!=i.height)&&ut(v,E),me(!1),Et=!0,wt=!0,kn()}function ut(v,E){i.width=Oe=z=v,i.height=on=Dt=E,jt=ue=0,At(),Zt();let L=i.bbox;I=L.left=Br(jt*Ie,.5),S=L.top=Br(ue*Ie,.5),K=L.width=Br(z*Ie,.5),_t=L.height=Br(Dt*Ie,.5)}let at=3;function Rt(){let v=!1,E=0;for(;!v;){E++;let L=Yr(E),F=Qi(E);v=E==at||L&&F,v||(ut(i.width,i.height),wt=!0)}}function St({width:v,height:E}){V(v,E)}i.setSize=St;function At(){let v=!1,E=!1,L=!1,F=!1;M.forEach((q,et)=>{if(q.show&&q._show){let{side:ft,_size:yt}=q,Tt=ft%2,Vt=q.label!=null?q.labelSize:0,Gt=yt+Vt;Gt>0&&(Tt?(z-=Gt,ft==3?(jt+=Gt,F=!0):L=!0):(Dt-=Gt,ft==0?(ue+=Gt,v=!0):E=!0))}}),Ki[0]=v,Ki[1]=L,Ki[2]=E,Ki[3]=F,z-=Ii[1]+Ii[3],jt+=Ii[3],Dt-=Ii[2]+Ii[0],ue+=Ii[0]}function Zt(){let v=jt+z,E=ue+Dt,L=jt,F=ue;function q(et,ft){switch(et){case 1:return v+=ft,v-ft;case 2:return E+=ft,E-ft;case 3:return L-=ft,L+ft;case 0:return F-=ft,F+ft}}M.forEach((et,ft)=>{if(et.show&&et._show){let yt=et.side;et._pos=q(yt,et._size),et.label!=null&&(et._lpos=q(yt,et.labelSize))}})}if(lt.dataIdx==null){let v=lt.hover,E=v.skip=new Set(v.skip??[]);E.add(void 0);let L=v.prox=we(v.prox),F=v.bias??=0;lt.dataIdx=(q,et,ft,yt)=>{if(et==0)return ft;let Tt=ft,Vt=L(q,et,ft,yt)??Xe,Gt=Vt>=0&&Vt<Xe,Wt=N.ori==0?z:Dt,le=lt.left,Pe=t[0],Ae=t[et];if(E.has(Ae[ft])){Tt=null;let be=null,ee=null,Kt;if(F==0||F==-1)for(Kt=ft;be==null&&Kt-- >0;)E.has(Ae[Kt])||(be=Kt);if(F==0||F==1)for(Kt=ft;ee==null&&Kt++<Ae.length;)E.has(Ae[Kt])||(ee=Kt);if(be!=null||ee!=null)if(Gt){let Ke=be==null?-1/0:W(Pe[be],N,Wt,0),cn=ee==null?1/0:W(Pe[ee],N,Wt,0),Rn=le-Ke,He=cn-le;Rn<=He?Rn<=Vt&&(Tt=be):He<=Vt&&(Tt=ee)}else Tt=ee==null?be:be==null?ee:ft-be<=ee-ft?be:ee}else Gt&&wn(le-W(Pe[ft],N,Wt,0))>Vt&&(Tt=null);return Tt}}let ne=v=>{lt.event=v};lt.idxs=$,lt._lock=!1;let gt=lt.points;gt.show=we(gt.show),gt.size=we(gt.size),gt.stroke=we(gt.stroke),gt.width=we(gt.width),gt.fill=we(gt.fill);let $t=i.focus=xn({},n.focus||{alpha:.3},lt.focus),ie=$t.prox>=0,Nt=ie&&gt.one,pe=[],Ye=[],Wn=[];function aa(v,E){let L=gt.show(i,E);if(L instanceof HTMLElement)return _i(L,CT),_i(L,v.class),ms(L,-10,-10,z,Dt),m.insertBefore(L,pe[E]),L}function $r(v,E){if(s==1||E>0){let L=s==1&&b[v.scale].time,F=v.value;v.value=L?X_(F)?Q_(Y,j_(F,H)):F||J:F||GA,v.label=v.label||(L?NA:DA)}if(Nt||E>0){v.width=v.width==null?1:v.width,v.paths=v.paths||nC||XT,v.fillTo=we(v.fillTo||qA),v.pxAlign=+Re(v.pxAlign,x),v.pxRound=lx(v.pxAlign),v.stroke=we(v.stroke||null),v.fill=we(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let L=HA(ti(1,v.width),1),F=v.points=xn({},{size:L,width:ti(1,L*.2),stroke:v.stroke,space:L*2,paths:iC,_stroke:null,_fill:null},v.points);F.show=we(F.show),F.filter=we(F.filter),F.fill=we(F.fill),F.stroke=we(F.stroke),F.paths=we(F.paths),F.pxAlign=v.pxAlign}if(Z){let L=ve(v,E);it.splice(E,0,L[0]),rt.splice(E,0,L[1]),st.values.push(null)}if(pt){$.splice(E,0,null);let L=null;Nt?E==0&&(L=aa(v,E)):E>0&&(L=aa(v,E)),pe.splice(E,0,L),Ye.splice(E,0,0),Wn.splice(E,0,0)}Cn("addSeries",E)}function Uu(v,E){E=E??y.length,v=s==1?rp(v,E,ex,ox):rp(v,E,{},rx),y.splice(E,0,v),$r(y[E],E)}i.addSeries=Uu;function Fl(v){if(y.splice(v,1),Z){st.values.splice(v,1),rt.splice(v,1);let E=it.splice(v,1)[0];We(null,E.firstChild),E.remove()}pt&&($.splice(v,1),pe.splice(v,1)[0].remove(),Ye.splice(v,1),Wn.splice(v,1)),Cn("delSeries",v)}i.delSeries=Fl;let Ki=[!1,!1,!1,!1];function gs(v,E){if(v._show=v.show,v.show){let L=v.side%2,F=b[v.scale];F==null&&(v.scale=L?y[1].scale:w,F=b[v.scale]);let q=F.time;v.size=we(v.size),v.space=we(v.space),v.rotate=we(v.rotate),dr(v.incrs)&&v.incrs.forEach(ft=>{!fr.has(ft)&&fr.set(ft,bx(ft))}),v.incrs=we(v.incrs||(F.distr==2?pA:q?g==1?gA:yA:zr)),v.splits=we(v.splits||(q&&F.distr==1?ht:F.distr==3?ep:F.distr==4?OA:UA)),v.stroke=we(v.stroke),v.grid.stroke=we(v.grid.stroke),v.ticks.stroke=we(v.ticks.stroke),v.border.stroke=we(v.border.stroke);let et=v.values;v.values=dr(et)&&!dr(et[0])?we(et):q?dr(et)?K_(Y,J_(et,H)):X_(et)?MA(Y,et):et||U:et||FA,v.filter=we(v.filter||(F.distr>=3&&F.log==10?zA:F.distr==3&&F.log==2?VA:yx)),v.font=dx(v.font),v.labelFont=dx(v.labelFont),v._size=v.size(i,null,E,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Ki[E]=!0,v._el=Ri(wT,u))}}function _s(v,E,L,F){let[q,et,ft,yt]=L,Tt=E%2,Vt=0;return Tt==0&&(yt||et)&&(Vt=E==0&&!q||E==2&&!ft?Sn(tx.size/3):0),Tt==1&&(q||ft)&&(Vt=E==1&&!et||E==3&&!yt?Sn(ix.size/2):0),Vt}let la=i.padding=(n.padding||[_s,_s,_s,_s]).map(v=>we(Re(v,_s))),Ii=i._padding=la.map((v,E)=>v(i,E,Ki,0)),an,un=null,dn=null,ji=s==1?y[0].idxs:null,ri=null,Bs=!1;function ca(v,E){if(t=v??[],i.data=i._data=t,s==2){an=0;for(let L=1;L<y.length;L++)an+=t[L][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ri=t[0],an=ri.length;let L=t;if(G==2){L=t.slice();let F=L[0]=Array(an);for(let q=0;q<an;q++)F[q]=q}i._data=t=L}if(me(!0),Cn("setData"),G==2&&(Et=!0),E!==!1){let L=N;L.auto(i,Bs)?ha():Gs(w,L.min,L.max),ot=ot||lt.left>=0,vt=!0,kn()}}i.setData=ca;function ha(){Bs=!0;let v,E;s==1&&(an>0?(un=ji[0]=0,dn=ji[1]=an-1,v=t[0][un],E=t[0][dn],G==2?(v=un,E=dn):v==E&&(G==3?[v,E]=fu(v,v,N.log,!1):G==4?[v,E]=cp(v,v,N.log,!1):N.time?E=v+Sn(86400/g):[v,E]=hu(v,E,hp,!0))):(un=ji[0]=v=null,dn=ji[1]=E=null)),Gs(w,v,E)}let Xr,zs,qr,A,X,nt,j,Q,Pt,kt;function It(v,E,L,F,q,et){v??=R_,L??=dp,F??="butt",q??=R_,et??="round",v!=Xr&&(h.strokeStyle=Xr=v),q!=zs&&(h.fillStyle=zs=q),E!=qr&&(h.lineWidth=qr=E),et!=X&&(h.lineJoin=X=et),F!=nt&&(h.lineCap=nt=F),L!=A&&h.setLineDash(A=L)}function Bt(v,E,L,F){E!=zs&&(h.fillStyle=zs=E),v!=j&&(h.font=j=v),L!=Q&&(h.textAlign=Q=L),F!=Pt&&(h.textBaseline=Pt=F)}function qt(v,E,L,F,q=0){if(F.length>0&&v.auto(i,Bs)&&(E==null||E.min==null)){let et=Re(un,0),ft=Re(dn,F.length-1),yt=L.min==null?zT(F,et,ft,q,v.distr==3):[L.min,L.max];v.min=Zi(v.min,L.min=yt[0]),v.max=ti(v.max,L.max=yt[1])}}let re={min:null,max:null};function _e(){for(let F in b){let q=b[F];B[F]==null&&(q.min==null||B[w]!=null&&q.auto(i,Bs))&&(B[F]=re)}for(let F in b){let q=b[F];B[F]==null&&q.from!=null&&B[q.from]!=null&&(B[F]=re)}B[w]!=null&&me(!0);let v={};for(let F in B){let q=B[F];if(q!=null){let et=v[F]=Qo(b[F],ZT);if(q.min!=null)xn(et,q);else if(F!=w||s==2)if(an==0&&et.from==null){let ft=et.range(i,null,null,F);et.min=ft[0],et.max=ft[1]}else et.min=Xe,et.max=-Xe}}if(an>0){y.forEach((F,q)=>{if(s==1){let et=F.scale,ft=B[et];if(ft==null)return;let yt=v[et];if(q==0){let Tt=yt.range(i,yt.min,yt.max,et);yt.min=Tt[0],yt.max=Tt[1],un=Yi(yt.min,t[0]),dn=Yi(yt.max,t[0]),dn-un>1&&(t[0][un]<yt.min&&un++,t[0][dn]>yt.max&&dn--),F.min=ri[un],F.max=ri[dn]}else F.show&&F.auto&&qt(yt,ft,F,t[q],F.sorted);F.idxs[0]=un,F.idxs[1]=dn}else if(q>0&&F.show&&F.auto){let[et,ft]=F.facets,yt=et.scale,Tt=ft.scale,[Vt,Gt]=t[q],Wt=v[yt],le=v[Tt];Wt!=null&&qt(Wt,B[yt],et,Vt,et.sorted),le!=null&&qt(le,B[Tt],ft,Gt,ft.sorted),F.min=ft.min,F.max=ft.max}});for(let F in v){let q=v[F],et=B[F];if(q.from==null&&(et==null||et.min==null)){let ft=q.range(i,q.min==Xe?null:q.min,q.max==-Xe?null:q.max,F);q.min=ft[0],q.max=ft[1]}}}for(let F in v){let q=v[F];if(q.from!=null){let et=v[q.from];if(et.min==null)q.min=q.max=null;else{let ft=q.range(i,et.min,et.max,F);q.min=ft[0],q.max=ft[1]}}}let E={},L=!1;for(let F in v){let q=v[F],et=b[F];if(et.min!=q.min||et.max!=q.max){et.min=q.min,et.max=q.max;let ft=et.distr;et._min=ft==3?Fs(et.min):ft==4?Xf(et.min,et.asinh):ft==100?et.fwd(et.min):et.min,et._max=ft==3?Fs(et.max):ft==4?Xf(et.max,et.asinh):ft==100?et.fwd(et.max):et.max,E[F]=L=!0}}if(L){y.forEach((F,q)=>{s==2?q>0&&E.y&&(F._paths=null):E[F.scale]&&(F._paths=null)});for(let F in E)Et=!0,Cn("setScale",F);pt&&lt.left>=0&&(ot=vt=!0)}for(let F in B)B[F]=null}function Xt(v){let E=tp(un-1,0,an-1),L=tp(dn+1,0,an-1);for(;v[E]==null&&E>0;)E--;for(;v[L]==null&&L<an-1;)L++;return[E,L]}function xe(){if(an>0){let v=y.some(E=>E._focus)&&kt!=$t.alpha;v&&(h.globalAlpha=kt=$t.alpha),y.forEach((E,L)=>{if(L>0&&E.show&&(sn(L,!1),sn(L,!0),E._paths==null)){let F=kt;kt!=E.alpha&&(h.globalAlpha=kt=E.alpha);let q=s==2?[0,t[L][0].length-1]:Xt(t[L]);E._paths=E.paths(i,L,q[0],q[1]),kt!=F&&(h.globalAlpha=kt=F)}}),y.forEach((E,L)=>{if(L>0&&E.show){let F=kt;kt!=E.alpha&&(h.globalAlpha=kt=E.alpha),E._paths!=null&&ke(L,!1);{let q=E._paths!=null?E._paths.gaps:null,et=E.points.show(i,L,un,dn,q),ft=E.points.filter(i,L,et,q);(et||ft)&&(E.points._paths=E.points.paths(i,L,un,dn,ft),ke(L,!0))}kt!=F&&(h.globalAlpha=kt=F),Cn("drawSeries",L)}}),v&&(h.globalAlpha=kt=1)}}function sn(v,E){let L=E?y[v].points:y[v];L._stroke=L.stroke(i,v),L._fill=L.fill(i,v)}function ke(v,E){let L=E?y[v].points:y[v],{stroke:F,fill:q,clip:et,flags:ft,_stroke:yt=L._stroke,_fill:Tt=L._fill,_width:Vt=L.width}=L._paths;Vt=qe(Vt*Ie,3);let Gt=null,Wt=Vt%2/2;E&&Tt==null&&(Tt=Vt>0?"#fff":yt);let le=L.pxAlign==1&&Wt>0;if(le&&h.translate(Wt,Wt),!E){let Pe=I-Vt/2,Ae=S-Vt/2,be=K+Vt,ee=_t+Vt;Gt=new Path2D,Gt.rect(Pe,Ae,be,ee)}E?Ht(yt,Vt,L.dash,L.cap,Tt,F,q,ft,et):Be(v,yt,Vt,L.dash,L.cap,Tt,F,q,ft,Gt,et),le&&h.translate(-Wt,-Wt)}function Be(v,E,L,F,q,et,ft,yt,Tt,Vt,Gt){let Wt=!1;Tt!=0&&R.forEach((le,Pe)=>{if(le.series[0]==v){let Ae=y[le.series[1]],be=t[le.series[1]],ee=(Ae._paths||Al).band;dr(ee)&&(ee=le.dir==1?ee[0]:ee[1]);let Kt,Ke=null;Ae.show&&ee&&GT(be,un,dn)?(Ke=le.fill(i,Pe)||et,Kt=Ae._paths.clip):ee=null,Ht(E,L,F,q,Ke,ft,yt,Tt,Vt,Gt,Kt,ee),Wt=!0}}),Wt||Ht(E,L,F,q,et,ft,yt,Tt,Vt,Gt)}let yn=ta|ip;function Ht(v,E,L,F,q,et,ft,yt,Tt,Vt,Gt,Wt){It(v,E,L,F,q),(Tt||Vt||Wt)&&(h.save(),Tt&&h.clip(Tt),Vt&&h.clip(Vt)),Wt?(yt&yn)==yn?(h.clip(Wt),Gt&&h.clip(Gt),Me(q,ft),fn(v,et,E)):yt&ip?(Me(q,ft),h.clip(Wt),fn(v,et,E)):yt&ta&&(h.save(),h.clip(Wt),Gt&&h.clip(Gt),Me(q,ft),h.restore(),fn(v,et,E)):(Me(q,ft),fn(v,et,E)),(Tt||Vt||Wt)&&h.restore()}function fn(v,E,L){L>0&&(E instanceof Map?E.forEach((F,q)=>{h.strokeStyle=Xr=q,h.stroke(F)}):E!=null&&v&&h.stroke(E))}function Me(v,E){E instanceof Map?E.forEach((L,F)=>{h.fillStyle=zs=F,h.fill(L)}):E!=null&&v&&h.fill(E)}function xs(v,E,L,F){let q=M[v],et;if(F<=0)et=[0,0];else{let ft=q._space=q.space(i,v,E,L,F),yt=q._incrs=q.incrs(i,v,E,L,F,ft);et=cC(E,L,yt,F,ft)}return q._found=et}function pn(v,E,L,F,q,et,ft,yt,Tt,Vt){let Gt=ft%2/2;x==1&&h.translate(Gt,Gt),It(yt,ft,Tt,Vt,yt),h.beginPath();let Wt,le,Pe,Ae,be=q+(F==0||F==3?-et:et);L==0?(le=q,Ae=be):(Wt=q,Pe=be);for(let ee=0;ee<v.length;ee++)E[ee]!=null&&(L==0?Wt=Pe=v[ee]:le=Ae=v[ee],h.moveTo(Wt,le),h.lineTo(Pe,Ae));h.stroke(),x==1&&h.translate(-Gt,-Gt)}function Yr(v){let E=!0;return M.forEach((L,F)=>{if(!L.show)return;let q=b[L.scale];if(q.min==null){L._show&&(E=!1,L._show=!1,me(!1));return}else L._show||(E=!1,L._show=!0,me(!1));let et=L.side,ft=et%2,{min:yt,max:Tt}=q,[Vt,Gt]=xs(F,yt,Tt,ft==0?z:Dt);if(Gt==0)return;let Wt=q.distr==2,le=L._splits=L.splits(i,F,yt,Tt,Vt,Gt,Wt),Pe=q.distr==2?le.map(Kt=>ri[Kt]):le,Ae=q.distr==2?ri[le[1]]-ri[le[0]]:Vt,be=L._values=L.values(i,L.filter(i,Pe,F,Gt,Ae),F,Gt,Ae);L._rotate=et==2?L.rotate(i,be,F,Gt):0;let ee=L._size;L._size=Pi(L.size(i,be,F,v)),ee!=null&&L._size!=ee&&(E=!1)}),E}function Qi(v){let E=!0;return la.forEach((L,F)=>{let q=L(i,F,Ki,v);q!=Ii[F]&&(E=!1),Ii[F]=q}),E}function ys(){for(let v=0;v<M.length;v++){let E=M[v];if(!E.show||!E._show)continue;let L=E.side,F=L%2,q,et,ft=E.stroke(i,v),yt=L==0||L==3?-1:1,[Tt,Vt]=E._found;if(E.label!=null){let qn=E.labelGap*yt,li=Sn((E._lpos+qn)*Ie);Bt(E.labelFont[0],ft,"center",L==2?"top":C_),h.save(),F==1?(q=et=0,h.translate(li,Sn(S+_t/2)),h.rotate((L==3?-lu:lu)/2)):(q=Sn(I+K/2),et=li);let gr=_x(E.label)?E.label(i,v,Tt,Vt):E.label;h.fillText(gr,q,et),h.restore()}if(Vt==0)continue;let Gt=b[E.scale],Wt=F==0?K:_t,le=F==0?I:S,Pe=E._splits,Ae=Gt.distr==2?Pe.map(qn=>ri[qn]):Pe,be=Gt.distr==2?ri[Pe[1]]-ri[Pe[0]]:Tt,ee=E.ticks,Kt=E.border,Ke=ee.show?ee.size:0,cn=Sn(Ke*Ie),Rn=Sn((E.alignTo==2?E._size-Ke-E.gap:E.gap)*Ie),He=E._rotate*-lu/180,hn=p(E._pos*Ie),oi=(cn+Rn)*yt,Xn=hn+oi;et=F==0?Xn:0,q=F==1?Xn:0;let bi=E.font[0],Li=E.align==1?Yo:E.align==2?Hf:He>0?Yo:He<0?Hf:F==0?"center":L==3?Hf:Yo,ns=He||F==1?"middle":L==2?"top":C_;Bt(bi,ft,Li,ns);let ai=E.font[1]*E.lineGap,Mi=Pe.map(qn=>p(a(qn,Gt,Wt,le))),Di=E._values;for(let qn=0;qn<Di.length;qn++){let li=Di[qn];if(li!=null){F==0?q=Mi[qn]:et=Mi[qn],li=""+li;let gr=li.indexOf(`
`)==-1?[li]:li.split(/\n/gm);for(let Yn=0;Yn<gr.length;Yn++){let Yp=gr[Yn];He?(h.save(),h.translate(q,et+Yn*ai),h.rotate(He),h.fillText(Yp,0,0),h.restore()):h.fillText(Yp,q,et+Yn*ai)}}}ee.show&&pn(Mi,ee.filter(i,Ae,v,Vt,be),F,L,hn,cn,qe(ee.width*Ie,3),ee.stroke(i,v),ee.dash,ee.cap);let is=E.grid;is.show&&pn(Mi,is.filter(i,Ae,v,Vt,be),F,F==0?2:1,F==0?S:I,F==0?_t:K,qe(is.width*Ie,3),is.stroke(i,v),is.dash,is.cap),Kt.show&&pn([hn],[1],F==0?1:0,F==0?1:2,F==1?S:I,F==1?_t:K,qe(Kt.width*Ie,3),Kt.stroke(i,v),Kt.dash,Kt.cap)}Cn("drawAxes")}function me(v){y.forEach((E,L)=>{L>0&&(E._paths=null,v&&(s==1?(E.min=null,E.max=null):E.facets.forEach(F=>{F.min=null,F.max=null})))})}let ln=!1,$n=!1,ze=[];function mn(){$n=!1;for(let v=0;v<ze.length;v++)Cn(...ze[v]);ze.length=0}function kn(){ln||(nA(Pp),ln=!0)}function Ul(v,E=!1){ln=!0,$n=E,v(i),Pp(),E&&ze.length>0&&queueMicrotask(mn)}i.batch=Ul;function Pp(){if(dt&&(_e(),dt=!1),Et&&(Rt(),Et=!1),wt){if(tn(f,Yo,jt),tn(f,"top",ue),tn(f,Sl,z),tn(f,wl,Dt),tn(m,Yo,jt),tn(m,"top",ue),tn(m,Sl,z),tn(m,wl,Dt),tn(u,Sl,Oe),tn(u,wl,on),d.width=Sn(Oe*Ie),d.height=Sn(on*Ie),M.forEach(({_el:v,_show:E,_size:L,_pos:F,side:q})=>{if(v!=null)if(E){let et=q===3||q===0?L:0,ft=q%2==1;tn(v,ft?"left":"top",F-et),tn(v,ft?"width":"height",L),tn(v,ft?"top":"left",ft?ue:jt),tn(v,ft?"height":"width",ft?Dt:z),jf(v,Vr)}else _i(v,Vr)}),Xr=zs=qr=X=nt=j=Q=Pt=A=null,kt=1,fa(!0),jt!=Ct||ue!=$e||z!=Yt||Dt!=Qt){me(!1);let v=z/Yt,E=Dt/Qt;if(pt&&!ot&&lt.left>=0){lt.left*=v,lt.top*=E,Zr&&ms(Zr,Sn(lt.left),0,z,Dt),Jr&&ms(Jr,0,Sn(lt.top),z,Dt);for(let L=0;L<pe.length;L++){let F=pe[L];F!=null&&(Ye[L]*=v,Wn[L]*=E,ms(F,Pi(Ye[L]),Pi(Wn[L]),z,Dt))}}if(Je.show&&!ct&&Je.left>=0&&Je.width>0){Je.left*=v,Je.width*=v,Je.top*=E,Je.height*=E;for(let L in Gu)tn(Qr,L,Je[L])}Ct=jt,$e=ue,Yt=z,Qt=Dt}Cn("setSize"),wt=!1}Oe>0&&on>0&&(h.clearRect(0,0,d.width,d.height),Cn("drawClear"),T.forEach(v=>v()),Cn("draw")),Je.show&&ct&&(Ol(Je),ct=!1),pt&&ot&&(mr(null,!0,!1),ot=!1),st.show&&st.live&&vt&&(zu(),vt=!1),c||(c=!0,i.status=1,Cn("ready")),Bs=!1,ln=!1}i.redraw=(v,E)=>{Et=E||!1,v!==!1?Gs(w,N.min,N.max):kn()};function Ou(v,E){let L=b[v];if(L.from==null){if(an==0){let F=L.range(i,E.min,E.max,v);E.min=F[0],E.max=F[1]}if(E.min>E.max){let F=E.min;E.min=E.max,E.max=F}if(an>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;v==w&&L.distr==2&&an>0&&(E.min=Yi(E.min,t[0]),E.max=Yi(E.max,t[0]),E.min==E.max&&E.max++),B[v]=E,dt=!0,kn()}}i.setScale=Ou;let ku,Bu,Zr,Jr,Ip,Lp,Kr,jr,Dp,Np,Ze,en,Vs=!1,Dn=lt.drag,Tn=Dn.x,An=Dn.y;pt&&(lt.x&&(ku=Ri(TT,m)),lt.y&&(Bu=Ri(AT,m)),N.ori==0?(Zr=ku,Jr=Bu):(Zr=Bu,Jr=ku),Ze=lt.left,en=lt.top);let Je=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Qr=Je.show?Ri(ET,Je.over?m:f):null;function Ol(v,E){if(Je.show){for(let L in v)Je[L]=v[L],L in Gu&&tn(Qr,L,v[L]);E!==!1&&Cn("setSelect")}}i.setSelect=Ol;function By(v){if(y[v].show)Z&&jf(it[v],Vr);else if(Z&&_i(it[v],Vr),pt){let L=Nt?pe[0]:pe[v];L!=null&&ms(L,-10,-10,z,Dt)}}function Gs(v,E,L){Ou(v,{min:E,max:L})}function ts(v,E,L,F){E.focus!=null&&Wy(v),E.show!=null&&y.forEach((q,et)=>{et>0&&(v==et||v==null)&&(q.show=E.show,By(et),s==2?(Gs(q.facets[0].scale,null,null),Gs(q.facets[1].scale,null,null)):Gs(q.scale,null,null),kn())}),L!==!1&&Cn("setSeries",v,E),F&&pa("setSeries",i,v,E)}i.setSeries=ts;function zy(v,E){xn(R[v],E)}function Vy(v,E){v.fill=we(v.fill||null),v.dir=Re(v.dir,-1),E=E??R.length,R.splice(E,0,v)}function Gy(v){v==null?R.length=0:R.splice(v,1)}i.addBand=Vy,i.setBand=zy,i.delBand=Gy;function Hy(v,E){y[v].alpha=E,pt&&pe[v]!=null&&(pe[v].style.opacity=E),Z&&it[v]&&(it[v].style.opacity=E)}let vs,Hs,pr,to={focus:!0};function Wy(v){if(v!=pr){let E=v==null,L=$t.alpha!=1;y.forEach((F,q)=>{if(s==1||q>0){let et=E||q==0||q==v;F._focus=E?null:et,L&&Hy(q,et?1:$t.alpha)}}),pr=v,L&&kn()}}Z&&ie&&de(L_,Mt,v=>{lt._lock||(ne(v),pr!=null&&ts(null,to,!0,gn.setSeries))});function es(v,E,L){let F=b[E];L&&(v=v/Ie-(F.ori==1?ue:jt));let q=z;F.ori==1&&(q=Dt,v=q-v),F.dir==-1&&(v=q-v);let et=F._min,ft=F._max,yt=v/q,Tt=et+(ft-et)*yt,Vt=F.distr;return Vt==3?Ko(10,Tt):Vt==4?WT(Tt,F.asinh):Vt==100?F.bwd(Tt):Tt}function $y(v,E){let L=es(v,w,E);return Yi(L,t[0],un,dn)}i.valToIdx=v=>Yi(v,t[0]),i.posToIdx=$y,i.posToVal=es,i.valToPos=(v,E,L)=>b[E].ori==0?r(v,b[E],L?K:z,L?I:0):o(v,b[E],L?_t:Dt,L?S:0),i.setCursor=(v,E,L)=>{Ze=v.left,en=v.top,mr(null,E,L)};function Fp(v,E){tn(Qr,Yo,Je.left=v),tn(Qr,Sl,Je.width=E)}function Up(v,E){tn(Qr,"top",Je.top=v),tn(Qr,wl,Je.height=E)}let ua=N.ori==0?Fp:Up,da=N.ori==1?Fp:Up;function Xy(){if(Z&&st.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&Ut)continue;let E=st.values[v],L=0;for(let F in E)rt[v][L++].firstChild.nodeValue=E[F]}}function zu(v,E){if(v!=null&&(v.idxs?v.idxs.forEach((L,F)=>{$[F]=L}):YT(v.idx)||$.fill(v.idx),st.idx=$[0]),Z&&st.live){for(let L=0;L<y.length;L++)(L>0||s==1&&!Ut)&&qy(L,$[L]);Xy()}vt=!1,E!==!1&&Cn("setLegend")}i.setLegend=zu;function qy(v,E){let L=y[v],F=v==0&&G==2?ri:t[v],q;Ut?q=L.values(i,v,E)??Lt:(q=L.value(i,E==null?null:F[E],v,E),q=q==null?Lt:{_:q}),st.values[v]=q}function mr(v,E,L){Dp=Ze,Np=en,[Ze,en]=lt.move(i,Ze,en),lt.left=Ze,lt.top=en,pt&&(Zr&&ms(Zr,Sn(Ze),0,z,Dt),Jr&&ms(Jr,0,Sn(en),z,Dt));let F,q=un>dn;vs=Xe,Hs=null;let et=N.ori==0?z:Dt,ft=N.ori==1?z:Dt;if(Ze<0||an==0||q){F=lt.idx=null;for(let yt=0;yt<y.length;yt++){let Tt=pe[yt];Tt!=null&&ms(Tt,-10,-10,z,Dt)}ie&&ts(null,to,!0,v==null&&gn.setSeries),st.live&&($.fill(F),vt=!0)}else{let yt,Tt,Vt;s==1&&(yt=N.ori==0?Ze:en,Tt=es(yt,w),F=lt.idx=Yi(Tt,t[0],un,dn),Vt=W(t[0][F],N,et,0));let Gt=-10,Wt=-10,le=0,Pe=0,Ae=!0,be="",ee="";for(let Kt=s==2?1:0;Kt<y.length;Kt++){let Ke=y[Kt],cn=$[Kt],Rn=cn==null?null:s==1?t[Kt][cn]:t[Kt][1][cn],He=lt.dataIdx(i,Kt,F,Tt),hn=He==null?null:s==1?t[Kt][He]:t[Kt][1][He];if(vt=vt||hn!=Rn||He!=cn,$[Kt]=He,Kt>0&&Ke.show){let oi=He==null?-10:He==F?Vt:W(s==1?t[0][He]:t[Kt][0][He],N,et,0),Xn=hn==null?-10:P(hn,s==1?b[Ke.scale]:b[Ke.facets[1].scale],ft,0);if(ie&&hn!=null){let bi=N.ori==1?Ze:en,Li=wn($t.dist(i,Kt,He,Xn,bi));if(Li<vs){let ns=$t.bias;if(ns!=0){let ai=es(bi,Ke.scale),Mi=hn>=0?1:-1,Di=ai>=0?1:-1;Di==Mi&&(Di==1?ns==1?hn>=ai:hn<=ai:ns==1?hn<=ai:hn>=ai)&&(vs=Li,Hs=Kt)}else vs=Li,Hs=Kt}}if(vt||Nt){let bi,Li;N.ori==0?(bi=oi,Li=Xn):(bi=Xn,Li=oi);let ns,ai,Mi,Di,is,qn,li=!0,gr=gt.bbox;if(gr!=null){li=!1;let Yn=gr(i,Kt);Mi=Yn.left,Di=Yn.top,ns=Yn.width,ai=Yn.height}else Mi=bi,Di=Li,ns=ai=gt.size(i,Kt);if(qn=gt.fill(i,Kt),is=gt.stroke(i,Kt),Nt)Kt==Hs&&vs<=$t.prox&&(Gt=Mi,Wt=Di,le=ns,Pe=ai,Ae=li,be=qn,ee=is);else{let Yn=pe[Kt];Yn!=null&&(Ye[Kt]=Mi,Wn[Kt]=Di,B_(Yn,ns,ai,li),O_(Yn,qn,is),ms(Yn,Pi(Mi),Pi(Di),z,Dt))}}}}if(Nt){let Kt=$t.prox,Ke=pr==null?vs<=Kt:vs>Kt||Hs!=pr;if(vt||Ke){let cn=pe[0];cn!=null&&(Ye[0]=Gt,Wn[0]=Wt,B_(cn,le,Pe,Ae),O_(cn,be,ee),ms(cn,Pi(Gt),Pi(Wt),z,Dt))}}}if(Je.show&&Vs)if(v!=null){let[yt,Tt]=gn.scales,[Vt,Gt]=gn.match,[Wt,le]=v.cursor.sync.scales,Pe=v.cursor.drag;if(Tn=Pe._x,An=Pe._y,Tn||An){let{left:Ae,top:be,width:ee,height:Kt}=v.select,Ke=v.scales[Wt].ori,cn=v.posToVal,Rn,He,hn,oi,Xn,bi=yt!=null&&Vt(yt,Wt),Li=Tt!=null&&Gt(Tt,le);bi&&Tn?(Ke==0?(Rn=Ae,He=ee):(Rn=be,He=Kt),hn=b[yt],oi=W(cn(Rn,Wt),hn,et,0),Xn=W(cn(Rn+He,Wt),hn,et,0),ua(Zi(oi,Xn),wn(Xn-oi))):ua(0,et),Li&&An?(Ke==1?(Rn=Ae,He=ee):(Rn=be,He=Kt),hn=b[Tt],oi=P(cn(Rn,le),hn,ft,0),Xn=P(cn(Rn+He,le),hn,ft,0),da(Zi(oi,Xn),wn(Xn-oi))):da(0,ft)}else Hu()}else{let yt=wn(Dp-Ip),Tt=wn(Np-Lp);if(N.ori==1){let le=yt;yt=Tt,Tt=le}Tn=Dn.x&&yt>=Dn.dist,An=Dn.y&&Tt>=Dn.dist;let Vt=Dn.uni;Vt!=null?Tn&&An&&(Tn=yt>=Vt,An=Tt>=Vt,!Tn&&!An&&(Tt>yt?An=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||An)&&(Tn=An=!0);let Gt,Wt;Tn&&(N.ori==0?(Gt=Kr,Wt=Ze):(Gt=jr,Wt=en),ua(Zi(Gt,Wt),wn(Wt-Gt)),An||da(0,ft)),An&&(N.ori==1?(Gt=Kr,Wt=Ze):(Gt=jr,Wt=en),da(Zi(Gt,Wt),wn(Wt-Gt)),Tn||ua(0,et)),!Tn&&!An&&(ua(0,0),da(0,0))}if(Dn._x=Tn,Dn._y=An,v==null){if(L){if(qp!=null){let[yt,Tt]=gn.scales;gn.values[0]=yt!=null?es(N.ori==0?Ze:en,yt):null,gn.values[1]=Tt!=null?es(N.ori==1?Ze:en,Tt):null}pa(Wf,i,Ze,en,z,Dt,F)}if(ie){let yt=L&&gn.setSeries,Tt=$t.prox;pr==null?vs<=Tt&&ts(Hs,to,!0,yt):vs>Tt?ts(null,to,!0,yt):Hs!=pr&&ts(Hs,to,!0,yt)}}vt&&(st.idx=F,zu()),E!==!1&&Cn("setCursor")}let Ws=null;Object.defineProperty(i,"rect",{get(){return Ws==null&&fa(!1),Ws}});function fa(v=!1){v?Ws=null:(Ws=m.getBoundingClientRect(),Cn("syncRect",Ws))}function Op(v,E,L,F,q,et,ft){lt._lock||Vs&&v!=null&&v.movementX==0&&v.movementY==0||(Vu(v,E,L,F,q,et,ft,!1,v!=null),v!=null?mr(null,!0,!0):mr(E,!0,!1))}function Vu(v,E,L,F,q,et,ft,yt,Tt){if(Ws==null&&fa(!1),ne(v),v!=null)L=v.clientX-Ws.left,F=v.clientY-Ws.top;else{if(L<0||F<0){Ze=-10,en=-10;return}let[Vt,Gt]=gn.scales,Wt=E.cursor.sync,[le,Pe]=Wt.values,[Ae,be]=Wt.scales,[ee,Kt]=gn.match,Ke=E.axes[0].side%2==1,cn=N.ori==0?z:Dt,Rn=N.ori==1?z:Dt,He=Ke?et:q,hn=Ke?q:et,oi=Ke?F:L,Xn=Ke?L:F;if(Ae!=null?L=ee(Vt,Ae)?a(le,b[Vt],cn,0):-10:L=cn*(oi/He),be!=null?F=Kt(Gt,be)?a(Pe,b[Gt],Rn,0):-10:F=Rn*(Xn/hn),N.ori==1){let bi=L;L=F,F=bi}}Tt&&(E==null||E.cursor.event.type==Wf)&&((L<=1||L>=z-1)&&(L=Br(L,z)),(F<=1||F>=Dt-1)&&(F=Br(F,Dt))),yt?(Ip=L,Lp=F,[Kr,jr]=lt.move(i,L,F)):(Ze=L,en=F)}let Gu={width:0,height:0,left:0,top:0};function Hu(){Ol(Gu,!1)}let kp,Bp,zp,Vp;function Gp(v,E,L,F,q,et,ft){Vs=!0,Tn=An=Dn._x=Dn._y=!1,Vu(v,E,L,F,q,et,ft,!0,!1),v!=null&&(de($f,Jf,Hp,!1),pa(P_,i,Kr,jr,z,Dt,null));let{left:yt,top:Tt,width:Vt,height:Gt}=Je;kp=yt,Bp=Tt,zp=Vt,Vp=Gt}function Hp(v,E,L,F,q,et,ft){Vs=Dn._x=Dn._y=!1,Vu(v,E,L,F,q,et,ft,!1,!0);let{left:yt,top:Tt,width:Vt,height:Gt}=Je,Wt=Vt>0||Gt>0,le=kp!=yt||Bp!=Tt||zp!=Vt||Vp!=Gt;if(Wt&&le&&Ol(Je),Dn.setScale&&Wt&&le){let Pe=yt,Ae=Vt,be=Tt,ee=Gt;if(N.ori==1&&(Pe=Tt,Ae=Gt,be=yt,ee=Vt),Tn&&Gs(w,es(Pe,w),es(Pe+Ae,w)),An)for(let Kt in b){let Ke=b[Kt];Kt!=w&&Ke.from==null&&Ke.min!=Xe&&Gs(Kt,es(be+ee,Kt),es(be,Kt))}Hu()}else lt.lock&&(lt._lock=!lt._lock,mr(E,!0,v!=null));v!=null&&(We($f,Jf),pa($f,i,Ze,en,z,Dt,null))}function Yy(v,E,L,F,q,et,ft){if(lt._lock)return;ne(v);let yt=Vs;if(Vs){let Tt=!0,Vt=!0,Gt=10,Wt,le;N.ori==0?(Wt=Tn,le=An):(Wt=An,le=Tn),Wt&&le&&(Tt=Ze<=Gt||Ze>=z-Gt,Vt=en<=Gt||en>=Dt-Gt),Wt&&Tt&&(Ze=Ze<Kr?0:z),le&&Vt&&(en=en<jr?0:Dt),mr(null,!0,!0),Vs=!1}Ze=-10,en=-10,$.fill(null),mr(null,!0,!0),yt&&(Vs=yt)}function Wp(v,E,L,F,q,et,ft){lt._lock||(ne(v),ha(),Hu(),v!=null&&pa(D_,i,Ze,en,z,Dt,null))}function $p(){M.forEach(hC),V(i.width,i.height,!0)}Gr(cu,Jo,$p);let eo={};eo.mousedown=Gp,eo.mousemove=Op,eo.mouseup=Hp,eo.dblclick=Wp,eo.setSeries=(v,E,L,F)=>{let q=gn.match[2];L=q(i,E,L),L!=-1&&ts(L,F,!0,!1)},pt&&(de(P_,m,Gp),de(Wf,m,Op),de(I_,m,v=>{ne(v),fa(!1)}),de(L_,m,Yy),de(D_,m,Wp),sp.add(i),i.syncRect=fa);let kl=i.hooks=n.hooks||{};function Cn(v,E,L){$n?ze.push([v,E,L]):v in kl&&kl[v].forEach(F=>{F.call(null,i,E,L)})}(n.plugins||[]).forEach(v=>{for(let E in v.hooks)kl[E]=(kl[E]||[]).concat(v.hooks[E])});let Xp=(v,E,L)=>L,gn=xn({key:null,setSeries:!1,filters:{pub:W_,sub:W_},scales:[w,y[1]?y[1].scale:null],match:[$_,$_,Xp],values:[null,null]},lt.sync);gn.match.length==2&&gn.match.push(Xp),lt.sync=gn;let qp=gn.key,Wu=Vx(qp);function pa(v,E,L,F,q,et,ft){gn.filters.pub(v,E,L,F,q,et,ft)&&Wu.pub(v,E,L,F,q,et,ft)}Wu.sub(i);function Zy(v,E,L,F,q,et,ft){gn.filters.sub(v,E,L,F,q,et,ft)&&eo[v](null,E,L,F,q,et,ft)}i.pub=Zy;function Jy(){Wu.unsub(i),sp.delete(i),Ge.clear(),Qf(cu,Jo,$p),l.remove(),Mt?.remove(),Cn("destroy")}i.destroy=Jy;function $u(){Cn("init",n,t),ca(t||n.data,!1),B[w]?Ou(w,B[w]):ha(),ct=Je.show&&(Je.width>0||Je.height>0),ot=vt=!0,V(n.width,n.height)}return y.forEach($r),M.forEach(gs),e?e instanceof HTMLElement?(e.appendChild(l),$u()):e(i,$u):$u(),i}On.assign=xn;On.fmtNum=up;On.rangeNum=hu;On.rangeLog=fu;On.rangeAsinh=cp;On.orient=Wr;On.pxRatio=Ie;On.join=eA;On.fmtDate=fp,On.tzDate=dA;On.sync=Vx;{On.addGap=YA,On.clipGaps=gu;let n=On.paths={points:qx};n.linear=Zx,n.stepped=KA,n.bars=jA,n.spline=tC}var vp=92,bp=14,Qx=132,uC="replay",dC=[{key:"force_ratio",title:"a hit at this speed would be",others:"a hit of somebody who can give way would be",unit:"x",of:"x the limit",limit:1,colour:"--hitting"},{key:"distance_m",title:"gap to what is hit",unit:"m",limit:0,colour:"--accent"},{key:"speed_m_s",title:"speed of the link",unit:"m/s",colour:"--path"}],sa=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function fC(n){return t=>{let e=t.valToPos(n,"y",!0),{ctx:i,bbox:s}=t;i.save(),i.strokeStyle=sa("--ink"),i.setLineDash([6,5]),i.beginPath(),i.moveTo(s.left,e),i.lineTo(s.left+s.width,e),i.stroke(),i.restore()}}function pC(n){return t=>{let{ctx:e,bbox:i}=t;e.save();for(let{frame:s,kind:r}of n()){let o=t.valToPos(t.data[0][s],"x",!0);e.strokeStyle=sa(`--event-${r}`),e.lineWidth=1.5*devicePixelRatio,e.beginPath(),e.moveTo(o,i.top),e.lineTo(o,i.top+i.height),e.stroke()}e.restore()}}function mC(n){return(t,e,i)=>{let s=[e,i,n].filter(c=>c!=null),[r,o]=s.length>0?[Math.min(...s),Math.max(...s)]:[0,1],a=Math.max(.08*(o-r),.02);return[r<0?r-a:r===0?0:Math.max(0,r-a),o+a]}}function ty(n){let t=dC.map(h=>{let u=C("b"),f=C("div",{class:"plot"}),m=C("span",{},h.title);return{...h,value:u,box:f,named:m,element:C("figure",{},C("figcaption",{},m," ",u),f)}}),e=C("div",{class:"plots","data-test":"plots"},t.map(h=>h.element)),i=null,s=[],r=0,o=()=>Math.max(i.frames-1,1);function a({colour:h,limit:u,unit:f}){let m={stroke:sa("--ink-soft"),grid:{stroke:sa("--line"),width:1},ticks:{stroke:sa("--line"),width:1},font:"11px system-ui, sans-serif"};return{width:Math.max(e.clientWidth,200),height:Qx,padding:[6,bp,0,0],legend:{show:!1},cursor:{sync:{key:uC,setSeries:!1},drag:{x:!1,y:!1},y:!1,points:{size:7}},scales:{x:{time:!1,range:(x,p,g)=>[p,g]},y:{range:mC(u)}},axes:[{...m,size:22,gap:2,values:(x,p)=>p.map(g=>`${+g.toFixed(2)} s`)},{...m,size:vp,gap:4,space:24,values:(x,p)=>p.map(g=>`${+g.toFixed(2)} ${f}`)}],series:[{},{stroke:sa(h),width:2,points:{show:!1}}],hooks:{draw:[pC(()=>s),...u===void 0?[]:[fC(u)]]}}}function c(h){let u=C("div",{class:"now"});h.over.append(u),h.now=u;let f=m=>{let{left:x,width:p}=h.over.getBoundingClientRect();n((m.clientX-x)/p*o())};h.over.addEventListener("pointerdown",m=>{h.over.setPointerCapture(m.pointerId),f(m)}),h.over.addEventListener("pointermove",m=>m.buttons===1&&f(m))}function l(){for(let h of t){h.plot?.destroy();let u=[...i[h.key]].map(f=>Number.isFinite(f)?f:null);h.plot=new On(a(h),[[...i.time_s],u],h.box),c(h.plot)}d(r)}function d(h){r=h;for(let{plot:u,key:f,value:m,unit:x,of:p}of t){u.now.style.left=`${100*r/o()}%`;let g=i[f][r];m.textContent=Number.isFinite(g)?`${g.toFixed(2)}${p??` ${x}`}`:"none"}}return new ResizeObserver(()=>{for(let{plot:h}of t)h?.setSize({width:Math.max(e.clientWidth,200),height:Qx})}).observe(e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>i&&l()),{element:e,load(h,u,f){[i,s,r]=[h,u,0],t.forEach(({named:m,title:x,others:p})=>m.textContent=f?x:p??x),l()},show:d}}var vu=3,Mp=18,bu=13;function ey(){let n=C("div",{class:"labels","aria-hidden":"true","data-test":"labels"}),t=[],e=!0,i=(r,o)=>r.left<o.right+vu&&o.left<r.right+vu&&r.top<o.bottom+vu&&o.top<r.bottom+vu;function s({camera:r,width:o,height:a,free:c}){let l=new O,d=u=>(l.set(...u).project(r),[(l.x+1)/2*o,(1-l.y)/2*a]),h=c.map(d).map(([u,f])=>({left:u-bu,right:u+bu,top:f-bu,bottom:f+bu}));for(let u of t){let{label:f,anchors:m,kind:x}=u;u.size?.[0]||(u.size=[f.offsetWidth,f.offsetHeight]);let[p,g]=u.size,M=m().flatMap(b=>{let[R,w]=d(b),_=l.z<1;return(x==="tick"?[[-p/2,-g/2]]:[[-p/2,-g-6],[-p/2,Mp],[Mp,-g/2],[-p-Mp,-g/2]]).map(([k,D])=>({left:R+k,right:R+k+p,top:w+D,bottom:w+D+g,seen:_}))}).find(b=>b.seen&&b.left>=2&&b.right<=o-2&&b.top>=2&&b.bottom<=a-2&&!h.some(R=>i(b,R)));f.style.visibility=M?"visible":"hidden",M&&(h.push(M),f.style.transform=`translate(${M.left.toFixed(1)}px, ${M.top.toFixed(1)}px)`)}}return{element:n,get on(){return e},toggle(){e=!e,n.hidden=!e},set(r){t=r.map(({text:o,kind:a,colour:c,anchors:l})=>({kind:a,anchors:l,label:C("span",{class:`tag ${a}`,style:c?`border-color:${c}`:null},o)})),n.replaceChildren(...t.map(({label:o})=>o))},place:r=>e&&s(r)}}var ny={type:"change"},wp={type:"start"},sy={type:"end"},Mu=new er,iy=new Jn,gC=Math.cos(70*yf.DEG2RAD),En=new O,ii=2*Math.PI,Le={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Sp=1e-6,Su=class extends ll{constructor(t,e=null){super(t,e),this.state=Le.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:lr.ROTATE,MIDDLE:lr.DOLLY,RIGHT:lr.PAN},this.touches={ONE:cr.ROTATE,TWO:cr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new Fn,this._lastTargetPosition=new O,this._quat=new Fn().setFromUnitVectors(t.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Bo,this._sphericalDelta=new Bo,this._scale=1,this._panOffset=new O,this._rotateStart=new Ot,this._rotateEnd=new Ot,this._rotateDelta=new Ot,this._panStart=new Ot,this._panEnd=new Ot,this._panDelta=new Ot,this._dollyStart=new Ot,this._dollyEnd=new Ot,this._dollyDelta=new Ot,this._dollyDirection=new O,this._mouse=new Ot,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=xC.bind(this),this._onPointerDown=_C.bind(this),this._onPointerUp=yC.bind(this),this._onContextMenu=TC.bind(this),this._onMouseWheel=MC.bind(this),this._onKeyDown=SC.bind(this),this._onTouchStart=wC.bind(this),this._onTouchMove=EC.bind(this),this._onMouseDown=vC.bind(this),this._onMouseMove=bC.bind(this),this._interceptControlDown=AC.bind(this),this._interceptControlUp=CC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Le.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ny),this.update(),this.state=Le.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;En.copy(e).sub(this.target),En.applyQuaternion(this._quat),this._spherical.setFromVector3(En),this.autoRotate&&this.state===Le.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ii:i>Math.PI&&(i-=ii),s<-Math.PI?s+=ii:s>Math.PI&&(s-=ii),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(En.setFromSpherical(this._spherical),En.applyQuaternion(this._quatInverse),e.copy(this.target).add(En),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=En.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new O(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=En.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Mu.origin.copy(this.object.position),Mu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Mu.direction))<gC?this.object.lookAt(this.target):(iy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Mu.intersectPlane(iy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Sp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Sp||this._lastTargetPosition.distanceToSquared(this.target)>Sp?(this.dispatchEvent(ny),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ii/60*this.autoRotateSpeed*t:ii/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){En.setFromMatrixColumn(e,0),En.multiplyScalar(-t),this._panOffset.add(En)}_panUp(t,e){this.screenSpacePanning===!0?En.setFromMatrixColumn(e,1):(En.setFromMatrixColumn(e,0),En.crossVectors(this.object.up,En)),En.multiplyScalar(t),this._panOffset.add(En)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;En.copy(s).sub(this.target);let r=En.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Ot,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function _C(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function xC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function yC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(sy),this.state=Le.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function vC(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case lr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Le.DOLLY;break;case lr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Le.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Le.ROTATE}break;case lr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Le.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Le.PAN}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(wp)}function bC(n){switch(this.state){case Le.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Le.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Le.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function MC(n){this.enabled===!1||this.enableZoom===!1||this.state!==Le.NONE||(n.preventDefault(),this.dispatchEvent(wp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(sy))}function SC(n){this.enabled!==!1&&this._handleKeyDown(n)}function wC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case cr.ROTATE:if(this.enableRotate===!1){this.state=Le.NONE;break}this._handleTouchStartRotate(n),this.state=Le.TOUCH_ROTATE;break;case cr.PAN:if(this.enablePan===!1){this.state=Le.NONE;break}this._handleTouchStartPan(n),this.state=Le.TOUCH_PAN;break;default:this.state=Le.NONE}break;case 2:switch(this.touches.TWO){case cr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Le.TOUCH_DOLLY_PAN;break;case cr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Le.TOUCH_DOLLY_ROTATE;break;default:this.state=Le.NONE}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(wp)}function EC(n){switch(this._trackPointer(n),this.state){case Le.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Le.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Le.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Le.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Le.NONE}}function TC(n){this.enabled!==!1&&n.preventDefault()}function AC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function CC(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var RC=new O(0,0,1),ra=Math.PI/180;function wu(n,t){return new O(Math.cos(n)*Math.cos(t),Math.sin(n)*Math.cos(t),Math.sin(t))}function Ep(n,t,e){let i=Math.abs(t.z)>.999?new O(0,1,0):RC,s=new O().crossVectors(i,t).normalize(),r=new O().crossVectors(t,s),o=[s,r],a=new O;for(let h of[s,r,t]){let u=n.map(({p:f})=>h.dot(f));a.addScaledVector(h,(Math.min(...u)+Math.max(...u))/2)}let c=Math.tan(e.fov*ra/2),l=[c*e.aspect,c],d=.3;for(let{p:h,radius:u}of n){let f=h.clone().sub(a);o.forEach((m,x)=>{let p=(Math.abs(m.dot(f))+u)/l[x]+t.dot(f)+u;d=Math.max(d,p)})}return{position:a.clone().addScaledVector(t,1.06*d),target:a,distance:d}}var PC=1.25;function Eu({points:n,others:t},e,i){let s=Ep(n,e,i),r=PC*s.distance,o=n;for(let a of t){let c=Ep([...o,...a],e,i);c.distance<=r&&(o=[...o,...a],s=c)}return s}function ry(n,t,{a:e,b:i,top:s}){let[r,o]=[t[0]-n[0],t[1]-n[1]],[a,c]=[i[0]-e[0],i[1]-e[1]],l=r*c-o*a,d=((e[0]-n[0])*c-(e[1]-n[1])*a)/l,h=((e[0]-n[0])*o-(e[1]-n[1])*r)/l;return l!==0&&d>0&&d<1&&h>0&&h<1&&n[2]+d*(t[2]-n[2])<s}function oy(n,t){let{points:e,capsules:i,walls:s,contact:r,person:o,robot:a}=n,c=Math.atan2(a[1]-o[1],a[0]-o[0]),l=24*ra,d=[];for(let m=-175;m<=180;m+=5){let x=wu(c+m*ra,l),p=Ep(e,x,t),g=p.position.toArray(),y=i.filter(R=>Cm(g,r,R)).length,M=s.filter(R=>R.some(w=>ry(g,r,w)||ry(g,[...o,1],w))).length,b=Math.abs(Math.abs(m)-115)/60;d.push({towards:x,distance:p.distance,cost:y+.6*Math.min(M,2)+b})}let h=Math.min(...d.map(m=>m.distance)),u=m=>m.cost+1.5*(m.distance/h-1),f=d.reduce((m,x)=>u(x)<u(m)?x:m);return Eu(n,f.towards,t)}function ay(n,t,e){let{contact:i,person:s,robot:r}=t,o=Math.atan2(r[1]-s[1],r[0]-s[0]);switch(n){case"top":return Eu(t,wu(-Math.PI/2,89.9*ra),e);case"front":return Eu(t,wu(-Math.PI/2,6*ra),e);case"side":return Eu(t,wu(0,6*ra),e);case"contact":{let a=oy(t,e),c=new O(...i),l=a.position.clone().sub(a.target).normalize();return{position:c.clone().addScaledVector(l,1.1),target:c}}case"eye":{let a=new O(...t.head),c=new O(...i);return a.distanceTo(c)<.4&&c.copy(a).add(new O(Math.cos(o),Math.sin(o),-.2)),{position:a,target:c}}default:return oy(t,e)}}var Au=20,Tu=.08,IC=.05,ly=.11,LC=.2,DC=.7,NC=new Gi({color:"#59636f"});function cy(){let n=new Fe(new Ir(Au,Au),new ja({opacity:.18}));return n.receiveShadow=!0,n.position.z=.002,n}function hy({axis:n,grid:t}){let e=new al(Au,Au,n,t);return e.rotation.x=Math.PI/2,e}var Cu=class extends ir{constructor(){super(new Qe,new Vi)}set colour(t){this.material.color=new ce(t)}fit(t,e){let[[i,s],[r,o]]=t.map(([M,b])=>[M-.05,b+.05]),a=(M,b)=>Array.from({length:Math.max(0,Math.floor(b)-Math.ceil(M)+1)},(R,w)=>Math.ceil(M)+w),c=(M,b,R,w)=>b.every(_=>Math.abs(_-w)>=Math.abs(R-w))?`${M} ${R} m`:`${R}`,[l,d]=[a(i,s),a(r,o)],h=(M,b,R)=>Math.abs(b-R)>Math.abs(M-R)?[b,1]:[M,-1],[[u,f],[m,x]]=[h(i,s,e.x),h(r,o,e.y)],p=.014,g=[i,m,p,s,m,p,u,r,p,u,o,p],y=[];for(let M of l)g.push(M,m,p,M,m+x*Tu,p),y.push({text:c("x",l,M,u),at:[M,m+2.6*x*Tu,0]});for(let M of d)g.push(u,M,p,u+f*Tu,M,p),y.push({text:c("y",d,M,m),at:[u+2.6*f*Tu,M,0]});return this.geometry.dispose(),this.geometry=new Qe().setAttribute("position",new ye(g,3)),y}};function FC([n,t,e],i){let s=0;for(let r of i){let o=r.size_m[2]/2,[a,c]=[r.centre_m[2]-o,r.centre_m[2]+o];Zl([n,t],Nn(r))&&a<e&&(s=Math.max(s,Math.min(c,e)))}return e-s>IC?s:null}function uy([n,t],e,i,s,r){let o=new Fe(new Rr(s,1.2*s,i-e,28),NC);return o.rotation.x=Math.PI/2,o.position.set(n,t,(e+i)/2),o.castShadow=!0,o.userData.name=`${r} (drawn by the report; not in the cell file)`,o}function dy({robots:n,obstacles:t}){return(n??[]).flatMap(({name:e,base_m:i,upright:s})=>{let r=i&&s?FC(i,t):null;return r===null?[]:[uy(i,r,i[2],ly,`below ${e}`)]})}function fy(n,t){return(n.robots??[]).flatMap(({name:e,base_m:i,upright:s})=>{if(!i||!s)return[];let o=n.links.flatMap((l,d)=>l.robot===e?xa(t,n,0,d).map(h=>({p:h,radius:l.radius_m??0})):[]).filter(({p:l})=>Math.hypot(l[0]-i[0],l[1]-i[1])<LC),a=Math.min(...o.map(({p:l,radius:d})=>l[2]-d)),c=a-i[2];return c>.01&&c<DC?[uy(i,i[2],a+.02,.8*ly,`base of ${e}`)]:[]})}var Pu=0,UC=1,OC=new O,py=new ol,Tp=new Jn,my=new O,Ru=new Bi,Iu=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new Lu,this.unassigned=new Lu,this.vertices=[]}setFromPoints(t){if(t.length>=4){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.vertices.push(new Ap(t[e]));this._compute()}return this}setFromObject(t){let e=[];return t.updateMatrixWorld(!0),t.traverse(function(i){let s=i.geometry;if(s!==void 0){let r=s.attributes.position;if(r!==void 0)for(let o=0,a=r.count;o<a;o++){let c=new O;c.fromBufferAttribute(r,o).applyMatrix4(i.matrixWorld),e.push(c)}}}),this.setFromPoints(e)}containsPoint(t){let e=this.faces;for(let i=0,s=e.length;i<s;i++)if(e[i].distanceToPoint(t)>this.tolerance)return!1;return!0}intersectRay(t,e){let i=this.faces,s=-1/0,r=1/0;for(let o=0,a=i.length;o<a;o++){let c=i[o],l=c.distanceToPoint(t.origin),d=c.normal.dot(t.direction);if(l>0&&d>=0)return null;let h=d!==0?-l/d:0;if(!(h<=0)&&(d>0?r=Math.min(h,r):s=Math.max(h,s),s>r))return null}return s!==-1/0?t.at(s,e):t.at(r,e),e}intersectsRay(t){return this.intersectRay(t,OC)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(t,e){return t.face=e,e.outside===null?this.assigned.append(t):this.assigned.insertBefore(e.outside,t),e.outside=t,this}_removeVertexFromFace(t,e){return t===e.outside&&(t.next!==null&&t.next.face===e?e.outside=t.next:e.outside=null),this.assigned.remove(t),this}_removeAllVerticesFromFace(t){if(t.outside!==null){let e=t.outside,i=t.outside;for(;i.next!==null&&i.next.face===t;)i=i.next;return this.assigned.removeSubList(e,i),e.prev=i.next=null,t.outside=null,e}}_deleteFaceVertices(t,e){let i=this._removeAllVerticesFromFace(t);if(i!==void 0)if(e===void 0)this.unassigned.appendChain(i);else{let s=i;do{let r=s.next;e.distanceToPoint(s.point)>this.tolerance?this._addVertexToFace(s,e):this.unassigned.append(s),s=r}while(s!==null)}return this}_resolveUnassignedPoints(t){if(this.unassigned.isEmpty()===!1){let e=this.unassigned.first();do{let i=e.next,s=this.tolerance,r=null;for(let o=0;o<t.length;o++){let a=t[o];if(a.mark===Pu){let c=a.distanceToPoint(e.point);if(c>s&&(s=c,r=a),s>1e3*this.tolerance)break}}r!==null&&this._addVertexToFace(e,r),e=i}while(e!==null)}return this}_computeExtremes(){let t=new O,e=new O,i=[],s=[];for(let r=0;r<3;r++)i[r]=s[r]=this.vertices[0];t.copy(this.vertices[0].point),e.copy(this.vertices[0].point);for(let r=0,o=this.vertices.length;r<o;r++){let a=this.vertices[r],c=a.point;for(let l=0;l<3;l++)c.getComponent(l)<t.getComponent(l)&&(t.setComponent(l,c.getComponent(l)),i[l]=a);for(let l=0;l<3;l++)c.getComponent(l)>e.getComponent(l)&&(e.setComponent(l,c.getComponent(l)),s[l]=a)}return this.tolerance=3*Number.EPSILON*(Math.max(Math.abs(t.x),Math.abs(e.x))+Math.max(Math.abs(t.y),Math.abs(e.y))+Math.max(Math.abs(t.z),Math.abs(e.z))),{min:i,max:s}}_computeInitialHull(){let t=this.vertices,e=this._computeExtremes(),i=e.min,s=e.max,r=0,o=0;for(let u=0;u<3;u++){let f=s[u].point.getComponent(u)-i[u].point.getComponent(u);f>r&&(r=f,o=u)}let a=i[o],c=s[o],l,d;r=0,py.set(a.point,c.point);for(let u=0,f=this.vertices.length;u<f;u++){let m=t[u];if(m!==a&&m!==c){py.closestPointToPoint(m.point,!0,my);let x=my.distanceToSquared(m.point);x>r&&(r=x,l=m)}}r=-1,Tp.setFromCoplanarPoints(a.point,c.point,l.point);for(let u=0,f=this.vertices.length;u<f;u++){let m=t[u];if(m!==a&&m!==c&&m!==l){let x=Math.abs(Tp.distanceToPoint(m.point));x>r&&(r=x,d=m)}}let h=[];if(Tp.distanceToPoint(d.point)<0){h.push(Ji.create(a,c,l),Ji.create(d,c,a),Ji.create(d,l,c),Ji.create(d,a,l));for(let u=0;u<3;u++){let f=(u+1)%3;h[u+1].getEdge(2).setTwin(h[0].getEdge(f)),h[u+1].getEdge(1).setTwin(h[f+1].getEdge(0))}}else{h.push(Ji.create(a,l,c),Ji.create(d,a,c),Ji.create(d,c,l),Ji.create(d,l,a));for(let u=0;u<3;u++){let f=(u+1)%3;h[u+1].getEdge(2).setTwin(h[0].getEdge((3-u)%3)),h[u+1].getEdge(0).setTwin(h[f+1].getEdge(1))}}for(let u=0;u<4;u++)this.faces.push(h[u]);for(let u=0,f=t.length;u<f;u++){let m=t[u];if(m!==a&&m!==c&&m!==l&&m!==d){r=this.tolerance;let x=null;for(let p=0;p<4;p++){let g=this.faces[p].distanceToPoint(m.point);g>r&&(r=g,x=this.faces[p])}x!==null&&this._addVertexToFace(m,x)}}return this}_reindexFaces(){let t=[];for(let e=0;e<this.faces.length;e++){let i=this.faces[e];i.mark===Pu&&t.push(i)}return this.faces=t,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let t,e=0,i=this.assigned.first().face,s=i.outside;do{let r=i.distanceToPoint(s.point);r>e&&(e=r,t=s),s=s.next}while(s!==null&&s.face===i);return t}}_computeHorizon(t,e,i,s){this._deleteFaceVertices(i),i.mark=UC;let r;e===null?r=e=i.getEdge(0):r=e.next;do{let o=r.twin,a=o.face;a.mark===Pu&&(a.distanceToPoint(t)>this.tolerance?this._computeHorizon(t,o,a,s):s.push(r)),r=r.next}while(r!==e);return this}_addAdjoiningFace(t,e){let i=Ji.create(t,e.tail(),e.head());return this.faces.push(i),i.getEdge(-1).setTwin(e.twin),i.getEdge(0)}_addNewFaces(t,e){this.newFaces=[];let i=null,s=null;for(let r=0;r<e.length;r++){let o=e[r],a=this._addAdjoiningFace(t,o);i===null?i=a:a.next.setTwin(s),this.newFaces.push(a.face),s=a}return i.next.setTwin(s),this}_addVertexToHull(t){let e=[];return this.unassigned.clear(),this._removeVertexFromFace(t,t.face),this._computeHorizon(t.point,null,t.face,e),this._addNewFaces(t,e),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let t;for(this._computeInitialHull();(t=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(t);return this._reindexFaces(),this._cleanup(),this}},Ji=class n{constructor(){this.normal=new O,this.midpoint=new O,this.area=0,this.constant=0,this.outside=null,this.mark=Pu,this.edge=null}static create(t,e,i){let s=new n,r=new Rl(t,s),o=new Rl(e,s),a=new Rl(i,s);return r.next=a.prev=o,o.next=r.prev=a,a.next=o.prev=r,s.edge=r,s.compute()}getEdge(t){let e=this.edge;for(;t>0;)e=e.next,t--;for(;t<0;)e=e.prev,t++;return e}compute(){let t=this.edge.tail(),e=this.edge.head(),i=this.edge.next.head();return Ru.set(t.point,e.point,i.point),Ru.getNormal(this.normal),Ru.getMidpoint(this.midpoint),this.area=Ru.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(t){return this.normal.dot(t)-this.constant}},Rl=class{constructor(t,e){this.vertex=t,this.prev=null,this.next=null,this.twin=null,this.face=e}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let t=this.head(),e=this.tail();return e!==null?e.point.distanceTo(t.point):-1}lengthSquared(){let t=this.head(),e=this.tail();return e!==null?e.point.distanceToSquared(t.point):-1}setTwin(t){return this.twin=t,t.twin=this,this}},Ap=class{constructor(t){this.point=t,this.prev=null,this.next=null,this.face=null}},Lu=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(t,e){return e.prev=t.prev,e.next=t,e.prev===null?this.head=e:e.prev.next=e,t.prev=e,this}insertAfter(t,e){return e.prev=t,e.next=t.next,e.next===null?this.tail=e:e.next.prev=e,t.next=e,this}append(t){return this.head===null?this.head=t:this.tail.next=t,t.prev=this.tail,t.next=null,this.tail=t,this}appendChain(t){for(this.head===null?this.head=t:this.tail.next=t,t.prev=this.tail;t.next!==null;)t=t.next;return this.tail=t,this}remove(t){return t.prev===null?this.head=t.next:t.prev.next=t.next,t.next===null?this.tail=t.prev:t.next.prev=t.prev,this}removeSubList(t,e){return t.prev===null?this.head=e.next:t.prev.next=e.next,e.next===null?this.tail=t.prev:e.next.prev=t.prev,this}isEmpty(){return this.head===null}};var Du=class extends Qe{constructor(t=[]){super();let e=[],i=[],r=new Iu().setFromPoints(t).faces;for(let o=0;o<r.length;o++){let a=r[o],c=a.edge;do{let l=c.head().point;e.push(l.x,l.y,l.z),i.push(a.normal.x,a.normal.y,a.normal.z),c=c.next}while(c!==a.edge)}this.setAttribute("position",new ye(e,3)),this.setAttribute("normal",new ye(i,3))}};var Pl=new Ps(1,28,18),kC=new Rr(1,1,1,28,1,!0),BC=new O(0,1,0),Os=class extends fi{constructor(t,e){super(),this.tube=new Fe(kC,e),this.ends=[new Fe(Pl,e),new Fe(Pl,e)],this.ends.forEach(i=>i.scale.setScalar(t)),this.radius=t,this.add(this.tube,...this.ends),this.children.forEach(i=>i.castShadow=!0)}place(t,e){let[i,s]=[new O(...t),new O(...e)],r=s.clone().sub(i),o=r.length();this.ends[0].position.copy(i),this.ends[1].position.copy(s),this.tube.visible=o>1e-6,this.tube.visible&&(this.tube.position.copy(i).addScaledVector(r,.5),this.tube.scale.set(this.radius,o,this.radius),this.tube.quaternion.setFromUnitVectors(BC,r.divideScalar(o)))}set material(t){this.children.forEach(e=>e.material=t)}},Il=class extends Fe{constructor(t,e,i){if(e){let s=e.flatMap(r=>r.flatMap(o=>t[o]));super(new Qe().setAttribute("position",new ye(s,3)),i),this.geometry.computeVertexNormals()}else super(new Du(t.map(s=>new O(...s))),i);this.castShadow=!0}place(t,e){this.position.set(...t),this.quaternion.set(...e)}};function _y({centre_m:n,size_m:t,quaternion:e},i,s){let r=new sr(...t),o=new Fe(r,i);return o.add(new ir(new Ga(r),s)),o.position.set(...n),o.quaternion.copy(new Fn(...e)),o}function zC(n,t,e){let i=[];return n.slice(n.length===2?1:0).forEach((s,r)=>{let o=n.at(n.length===2?0:r-1);i.push(...o,t,...s,t,...s,e,...o,t,...s,e,...o,e)}),new Qe().setAttribute("position",new ye(i,3))}function Cp(n,t,e){return new ka(new Qe().setFromPoints(n.map(([i,s])=>new O(i,s,t))),e)}var gy={mat:.16,field:.07,curtain:.1,door:.1,post:.07,button:.6},VC={mat:.55,field:.3,curtain:.26,door:.26,post:.3,button:1},Nu=class extends fi{constructor({kind:t,polygon_m:e,z_m:[i,s]},r){super(),this.kind=t,this.fill=new Ai({color:r,transparent:!0,opacity:gy[t]??.1,side:Ci,depthWrite:!1}),this.edge=new Vi({color:r});let o=Math.max(i,.006);if(t==="curtain"||t==="door"||t==="button")this.add(new Fe(zC(e,i,s),this.fill),Cp(e,o,this.edge),Cp(e,s,this.edge));else{let a=t==="field"?Math.max(s,o):o,c=new Fe(new Ka(new Fo(e.map(([l,d])=>new Ot(l,d)))),this.fill);c.position.z=a,this.add(c,Cp(e,a,this.edge))}}set lit(t){let e=t?VC:gy;this.fill.opacity=e[this.kind]??.2}};function xy(n,t,e){let i=[];for(let s=1;s<n.length;s++){let[[r,o],[a,c]]=[n[s-1],n[s]],l=Math.hypot(a-r,c-o);if(l>1e-6){let[d,h]=[(o-c)/l*(t/2),(a-r)/l*(t/2)],u=.012;i.push(r+d,o+h,u,r-d,o-h,u,a-d,c-h,u,r+d,o+h,u,a-d,c-h,u,a+d,c+h,u)}}return new Fe(new Qe().setAttribute("position",new ye(i,3)),e)}var Dl={skin:"#e9bd97",shirt:"#8f8467",trousers:"#4b5058",shoes:"#3f352c",cap:"#8a5a2b",touched:"#c2185b"},yy=[.095,.018,.043],vy=[.145,.05,.06],by=[.13,.22],My={from:.08,radius:.014},GC=.4,Hn=Object.fromEntries(Object.entries(Dl).map(([n,t])=>[n,new Gi({color:t})])),HC=new Ai({color:Dl.touched,transparent:!0,opacity:.1,depthWrite:!1}),WC=new Ps(1,28,12,0,2*Math.PI,0,Math.PI/2),Sy=new O(1,0,0),vi=n=>new O(...n);function Fu(n,t){let e=new Fe(Pl,t);return e.scale.set(...n),e.castShadow=!0,e}function wy(n){return/head|skull|face|neck/.test(n)?Hn.skin:/thigh|shank|pelvis|leg/.test(n)?Hn.trousers:Hn.shirt}function $C(){let n=new Fe(WC,Hn.cap);n.scale.setScalar(1.07),n.position.y=.16;let t=Fu([.72,.09,.74],Hn.cap);t.position.set(.86,.3,0);let e=Fu([.2,.24,.15],Hn.skin);e.position.set(1,-.08,0);let i=new fi;return i.add(n,t,e),Object.assign(i,{hat:[n,t],nose:e})}var Ll=class extends fi{constructor(t,e){super(),this.cell=t;let{upper_arm_radius_m:i,forearm_radius_m:s,hand_radius_m:r}=t.arm;this.parts=t.body.map(a=>e(new Os(a.radius_m,wy(a.region)),a.region.replaceAll("_"," "))),this.arms=Mr.map(a=>[e(new Os(i,Hn.shirt),`${a} upper arm`),e(new Os(s,Hn.skin),`${a} lower arm`),e(Fu(yy,Hn.skin),`${a} hand`)]),this.legs=sd(t),this.feet=this.legs.map(()=>e(Fu(vy,Hn.shoes),"foot")),this.face=e($C(),"head");let o=t.arm.held_m>0;this.around=e(new Fe(Pl,HC),`the hand${o?", or what it holds,":""} may be anywhere in this sphere`),this.around.scale.setScalar(r),this.held=e(new Os(My.radius,Hn.trousers),"what the hand holds"),this.held.visible=!1,this.add(...this.parts,...this.arms.flat(),...this.feet,this.face,this.around,this.held)}loadOther(t,e){if(this.visible=!!t.beside,this.visible){let i={...t,body:t.beside,arms:t.beside_arms,arm:null};Object.assign(this,{replay:i,hazard:e,head:rd(i,this.cell),touching:null}),this.face.scale.setScalar(this.cell.body[this.head].radius_m)}}load(t,e){Object.assign(this,{replay:t,hazard:e,head:rd(t,this.cell)});let i=t.arm?Mr.indexOf(t.arm.side):-1,s=Pm(e.body_region);this.touching=i>=0&&s!==void 0?{side:i,limb:s}:null,this.held.visible=!!e.arm?.held_m;let r=t.arm?-1:Im(t,this.cell,e),o=(c,l)=>c?Hn.touched:l;this.parts.forEach((c,l)=>c.material=o(l===r,wy(this.cell.body[l].region))),this.arms.forEach((c,l)=>c.forEach((d,h)=>d.material=o(l===i&&h===s,h===0?Hn.shirt:Hn.skin)));let a=r===this.head&&e.body_region==="skull_forehead";this.face.hat.forEach(c=>c.material=o(a,Hn.cap)),this.face.nose.material=o(r===this.head,Hn.skin),this.face.scale.setScalar(this.cell.body[this.head].radius_m)}place(t){let{replay:e,cell:i,touching:s}=this;this.parts.forEach((a,c)=>{let{a:l,b:d}=wi(e,i,t,c);a.place(l,d)});let r=Mr.map((a,c)=>Sr(e,t,c));this.arms.forEach(([a,c,l],d)=>{let[h,u,f]=r[d];a.place(h,u),c.place(u,f),this.placeHand(l,u,f,t,s?.limb===2&&s.side===d)});let o=vi(Rm(e,this.hazard,t));this.feet.forEach((a,c)=>{let{a:l,b:d}=wi(e,i,t,this.legs[c]),h=l[2]<d[2]?l:d;a.position.set(h[0],h[1],vy[1]).addScaledVector(o,.06),a.quaternion.setFromUnitVectors(Sy,o)}),this.placeFace(r,o,t),this.around.visible=s?.limb===2&&t>=e.contact_frame,this.around.visible&&this.around.position.set(...r[s.side][2])}placeHand(t,e,i,s,r){let{replay:o}=this,a=vi(i),c=a.clone().sub(vi(e)).normalize(),l=2*yy[0];if(r){let d=vi(Sr(o,o.contact_frame,this.touching.side)[2]),h=vi(o.contact_m).sub(d),u=h.length(),f=Math.max(0,Math.min(1,1-(o.contact_frame-s)*o.step/GC));u>.02&&(c.lerp(h.divideScalar(u),f).normalize(),l+=f*(Math.max(by[0],Math.min(by[1],u))-l))}if(r&&this.held.visible){let d=vi(o.contact_m).sub(vi(Sr(o,o.contact_frame,this.touching.side)[2])).length(),h=u=>a.clone().addScaledVector(c,u).toArray();this.held.place(h(My.from),h(d))}t.scale.x=l/2,t.position.copy(a).addScaledVector(c,l/2),t.quaternion.setFromUnitVectors(Sy,c)}placeFace([[t],[e]],i,s){let{a:r,b:o}=wi(this.replay,this.cell,s,this.head),a=vi(r).add(vi(o)).multiplyScalar(.5),c=vi(t).sub(vi(e)),l=a.clone().sub(vi(t).add(vi(e)).multiplyScalar(.5));(c.lengthSq()<1e-4||l.lengthSq()<1e-4)&&(l.set(0,0,1),c.crossVectors(l,i));let d=c.cross(l).normalize();l.normalize(),this.face.position.copy(a),this.face.quaternion.copy(new Fn().setFromRotationMatrix(new Ve().makeBasis(d,l,new O().crossVectors(d,l))))}set headless(t){this.parts[this.head].visible=!t,this.face.visible=!t}eye(t){return wi(this.replay,this.cell,t,this.head).a}spots(t){return this.parts.map((e,i)=>wi(this.replay,this.cell,t,i).a)}get drawn(){let[t,e]=this.arms[0].map(i=>i.radius);return{upper_arm_radius_m:t,forearm_radius_m:e,hand_sphere_m:this.around.visible?this.around.scale.x:null,touched:this.touching??"body"}}};var si={robot:"#7894b4",hitting:"#e4572e",person:Dl.shirt,touched:Dl.touched,contact:"#ffffff",path:"#2a9d8f",mat:"#d9a400",field:"#3b82f6",curtain:"#16a34a",door:"#0d9488",post:"#9333ea",button:"#db2777",obstacle:"#8b93a0"},Ey={light:{sky:"#eef1f5",grid:"#b9c1cc",axis:"#b9c1cc",mark:"#4d5866"},dark:{sky:"#1b2027",grid:"#3a434f",axis:"#3a434f",mark:"#a3afbd"}},Ty=matchMedia("(prefers-color-scheme: dark)"),Ay=n=>new Gi({color:n}),Cy=n=>new Gi({color:n,transparent:!0,opacity:.2,depthWrite:!1}),ks={robot:Ay(si.robot),hitting:Ay(si.hitting),robotShape:Cy(si.robot),hittingShape:Cy(si.hitting),obstacle:new Gi({color:si.obstacle,transparent:!0,opacity:.22,depthWrite:!1}),edge:new Vi({color:si.obstacle}),path:new Ai({color:si.path})};function XC(n){n.add(new el("#ffffff","#9aa3b0",2.1));let t=new sl("#ffffff",1.9);return t.position.set(-3,-4,9),t.castShadow=!0,t.shadow.mapSize.set(1024,1024),Object.assign(t.shadow.camera,{left:-5,right:5,top:5,bottom:-5,near:1,far:20}),n.add(t,t.target),t}function qC(){let n=new Ai({color:si.contact,depthTest:!1,transparent:!0}),t=new Ai({color:"#000000",depthTest:!1,transparent:!0}),e=new Fe(new Ps(.018,16,12),n),i=new Fe(new Oo(.045,.058,40),n),s=new Fe(new Oo(.04,.063,40),t);return[e.renderOrder,i.renderOrder,s.renderOrder]=[12,11,10],e.add(i,s),e.materials=[n,t],e}function YC({mesh:n}){let t=e=>[...e.getWorldPosition(new O)];return{at:t(n),shape:t(n.parent),clear:n.parent.material.transparent&&!n.material.transparent}}function Ry(n,t,e,i){let s=new tu({canvas:n,antialias:!0});s.setPixelRatio(Math.min(devicePixelRatio,2)),s.shadowMap.enabled=!0;let r=new Na,o=new Kn(40,1,.02,200);o.up.set(0,0,1);let a=new Su(o,n),c=XC(r),l=[],d=($,st)=>($.userData.name=st,l.push($),$),h=qC(),u=new Cu,f=dy(t);l.push(...f),r.add(cy(),u,h,...f);let m=t.obstacles.map($=>d(_y($,ks.obstacle,ks.edge),$.name));r.add(...m);let x=t.zones.map($=>d(new Nu($,si[$.kind]??si.obstacle),`${$.kind} ${$.name}`)),p=t.links.map($=>{let{radius_m:st,points_m:lt,triangles:Z}=$,pt=$.shape==="capsule"?new Os(st,ks.robot):new Il(lt,Z,ks.robot);return d(pt,t.links.some(mt=>mt.robot!==$.robot)?`${$.robot}/${$.name}`:$.name)}),g=t.looks.map(({link:$,points_m:st,triangles:lt})=>{let Z=new Il(st,lt,ks.robot);return p[$].add(Z),p[$].castShadow=!1,{link:$,mesh:Z}}),y=new Ll(t,d),M=new Ll(t,$=>d($,"the other person"));r.add(...x,...p,y,M);let b=null,R=null,w=null,_=0,T=null,k=null,D=0,N="overview",G=!1;function W(){G||(G=!0,requestAnimationFrame(()=>{G=!1,h.children.forEach($=>$.quaternion.copy(o.quaternion)),h.scale.setScalar(Math.max(.25,Math.min(2,o.position.distanceTo(h.position)/3.5))),s.render(r,o),e.place({camera:o,width:n.clientWidth,height:n.clientHeight,free:R?[R.contact_m,...y.spots(D)]:[]})}))}function P(){let $=Ty.matches?Ey.dark:Ey.light;r.background=new ce($.sky),u.colour=$.mark,b&&(r.remove(b),b.dispose()),b=hy($),r.add(b),W()}function B(){let{clientWidth:$,clientHeight:st}=n;$>0&&st>0&&(s.setSize($,st,!1),o.aspect=$/st,o.updateProjectionMatrix(),W())}function Y($){N=$,B(),H()}function H(){let $=ay(N,{...k,head:y.eye(D)},o);if(o.position.copy($.position),a.target.copy($.target),a.update(),y.headless=N==="eye",N!=="eye"){let st=u.fit(k.bounds,o.position);e.set(Y0({replay:R,cell:t,hazard:y.hazard,hitting:_,marks:st,colours:si,frame:()=>D}))}W()}let ht=new Ot,U=new rl;function J($){let{left:st,top:lt,width:Z,height:pt}=n.getBoundingClientRect();ht.set(2*($.clientX-st)/Z-1,1-2*($.clientY-lt)/pt),U.setFromCamera(ht,o);let mt=U.intersectObjects(l.filter(xt=>xt.visible),!0),tt=(mt.find(({object:xt})=>xt.material&&!xt.material.transparent&&xt.isMesh)??mt.find(({object:xt})=>xt.isMesh))?.object;for(;tt&&!tt.userData.name;)tt=tt.parent;i(tt?.userData.name??"")}return a.addEventListener("change",W),a.addEventListener("start",()=>{N="free",y.headless=!1}),n.addEventListener("pointermove",$=>$.buttons===0&&J($)),n.addEventListener("pointerleave",()=>i("")),Ty.addEventListener("change",P),new ResizeObserver(()=>{B(),k&&N!=="free"&&H()}).observe(n),B(),P(),{load($,st){R=$,w&&(r.remove(w),w.geometry.dispose()),_=Lm(R,t,st);let lt=Z=>Z===_?"hitting":"robot";p.forEach((Z,pt)=>Z.material=ks[lt(pt)]);for(let{link:Z,mesh:pt}of g)pt.material=ks[lt(Z)],p[Z].material=ks[`${lt(Z)}Shape`];y.load(R,st),M.loadOther(R,st),w=xy(Dm(R,t),.03,ks.path),r.add(w),h.position.set(...R.contact_m),T===null&&(T=fy(t,R),T.forEach(Z=>r.add(Z)),l.push(...T)),k=X0(R,t,st),c.position.set(R.contact_m[0]-3,R.contact_m[1]-4,9),c.target.position.set(R.contact_m[0],R.contact_m[1],0)},show($){D=$,p.forEach((Z,pt)=>{let mt=rs(R,t,D,pt);mt.position?Z.place(mt.position,mt.quaternion):Z.place(mt.a,mt.b)}),y.place(D),M.visible&&M.place(D);let st=(y.hazard.worked??[]).filter(({at_s:Z})=>Math.round(Z/R.step)<=D);m.forEach((Z,pt)=>{let mt=t.obstacles[pt].opened_by;Z.visible=mt===void 0||st.filter(Mt=>Mt.name===mt).length%2===0});for(let{obstacle:Z,there:pt,centre_m:mt}of R.moved??[])m[Z].visible=pt[D]==="1",m[Z].position.fromArray(mt,3*D);let lt=D>=R.contact_frame;h.materials.forEach(Z=>Z.opacity=lt?1:.35),x.forEach((Z,pt)=>{let mt=R.sensors.find(Mt=>Mt.name===t.zones[pt].name);Z.lit=mt?.detected[D]==="1"}),N==="eye"&&Y("eye"),W()},look:Y,draw:W,get drawn(){o.updateMatrixWorld();let $=k.points.filter(({p:st})=>{let{x:lt,y:Z,z:pt}=st.clone().project(o);return Math.abs(lt)>1||Math.abs(Z)>1||pt>1}).length;return{...y.drawn,pedestals:f.length,outside:$,looks:g.map(YC)}}}}function Py({zones:n,looks:t}){let e=new Set(n.map(r=>r.kind)),i=[["hitting","link that hits"],["touched","part that is hit"],["robot","robot"],["person","person"],["path","way of the person"],["obstacle","obstacle"],...[...e].map(r=>[r,r])],s=r=>C("i",{class:"swatch",style:`background:${si[r]??si.obstacle}`});return C("ul",{class:"legend screen-only"},i.map(([r,o])=>C("li",{},s(r),o)),C("li",{},C("i",{class:"swatch ring"}),"contact"),t.length>0?C("li",{},"Clear around the robot: the shapes that are judged."):null,n.length>0?C("li",{},"Zones are filled while they report."):null)}function Iy(n){let t=C("canvas",{"data-test":"scene","aria-label":"the cell in three dimensions; drag to turn, wheel to zoom"}),e=C("span",{class:"pointed"}),i=C("div",{class:"flat"}),s=ey(),r=C("div",{class:"stage screen-only"},t,s.element,e),o=C("button",{type:"button","data-test":"names","aria-pressed":"true",title:"Show or hide the names in the picture",onclick:c},"names"),a=null;function c(){s.toggle(),o.setAttribute("aria-pressed",String(s.on)),a?.draw()}function l(){a=null,r.replaceChildren(C("p",{class:"notice","data-test":"no-webgl"},"This browser shows no 3-D graphics (WebGL), so here is the contact seen from above; everything else works."),i)}let d=document.createElement("canvas").getContext("webgl2");if(d){d.getExtension("WEBGL_lose_context")?.loseContext();try{a=Ry(t,n,s,h=>e.textContent=h),t.addEventListener("webglcontextlost",l)}catch{l()}}else l();return{element:r,names:o,get scene(){return a},drawFlat:h=>i.replaceChildren(h?$l(h):""),show(h){a&&(a.show(h),t.dataset.drawn=JSON.stringify(a.drawn))},look:h=>a?.look(h)}}function ZC(n){return[...n.matchAll(/1+/g)].map(t=>[t.index,t.index+t[0].length])}function Ly(n,t){return n.findLastIndex(e=>e.frame<=t)}function Dy(n){let t=C("div",{class:"strips",style:`--gutter:${vp}px; --right:${bp}px`,onclick:o}),e=1,i=[],s=l=>l.map(({frame:d,kind:h,text:u})=>C("div",{class:`event ${h}`,style:`left:${100*d/e}%`,title:u})),r=(l,d)=>`left:${100*l/e}%;width:${100*(Math.min(d,e)-l)/e}%`;function o(l){let d=l.target.closest(".track");if(d){let{left:h,width:u}=d.getBoundingClientRect();n((l.clientX-h)/u*e)}}function a(l,d,h,u){return C("div",{class:`strip ${d}`},C("span",{class:"label",title:l},l),C("div",{class:"track"},h,s(u),C("div",{class:"now"})))}function c(l){let d=[];return l.forEach(({name:h,frame:u},f)=>{let m=l[f+1]?.frame??e;d.at(-1)?.name===h?d.at(-1).to=m:d.push({name:h,from:u,to:m})}),d}return{element:t,load(l,d){e=Math.max(l.frames-1,1);let h=l.sensors.map(({name:u,detected:f})=>a(u,"sensor",ZC(f).map(([m,x])=>C("div",{class:"on",style:r(m,x),title:`${u} reports ${_r()}`})),d));i=c(l.actions).map(({name:u,from:f,to:m})=>{let[x,...p]=io(u).split(", "),g=C("div",{class:"action",style:r(f,m),title:io(u)},C("span",{},x),C("span",{},p.join(", ")));return{from:f,to:m,block:g}}),t.replaceChildren(...h,a(em(),"actions",i.map(({block:u})=>u),d))},show(l){t.querySelectorAll(".now").forEach(d=>d.style.left=`${100*l/e}%`),i.forEach(({from:d,to:h,block:u})=>u.classList.toggle("current",l>=d&&(l<h||h>=e)))}}}var JC=[.1,.25,.5,1],KC=[["overview","3/4"],["top","top"],["front","front"],["side","side"],["eye","person's eye"],["contact","contact"]],Nl=(n,t,e,i)=>C("button",{type:"button","data-test":n,title:e,onclick:i},t);function jC(n,t){return n.closest("input, select, textarea, [contenteditable]")||t===" "&&n.closest("button, [role=button], summary")}function Ny(n,{look:t,inView:e}){let i=1,s=0,r=Nl("play","▶ Play","Play or pause (space)",()=>n.toggle()),o=C("input",{type:"range",min:0,step:1,"data-test":"scrub","aria-label":"time",oninput:()=>n.seek(Number(o.value))}),a=p=>()=>n.seek(n.frame+p),c=p=>()=>n.seek(p()),l=C("select",{"data-test":"speed",onchange:()=>n.setSpeed(Number(l.value))},JC.map(p=>C("option",{value:p,selected:p===.5},`${p}x`))),d=KC.map(([p,g])=>Nl(`view-${p}`,g,`View: ${g}`,()=>t(p))),h=C("div",{class:"ticks","aria-hidden":"true"}),u=C("ol",{class:"events","data-test":"events","aria-label":"what happens"}),f=C("div",{class:"transport screen-only"},C("div",{class:"row"},r,Nl("back","◀|","One frame back (left)",a(-1)),Nl("forward","|▶","One frame on (right)",a(1)),C("div",{class:"scrubber"},h,o),Nl("to-contact","Contact","Jump to the contact",c(()=>s)),C("label",{},"speed ",l)),u),m=C("div",{class:"row views screen-only",role:"group","aria-label":"views"},d),x={" ":()=>n.toggle(),ArrowLeft:a(-1),ArrowRight:a(1),Home:c(()=>0),End:c(()=>i-1)};return document.addEventListener("keydown",p=>{let g=x[p.key],y=!p.ctrlKey&&!p.metaKey&&!p.altKey&&!p.shiftKey;g&&y&&e()&&!p.defaultPrevented&&!jC(p.target,p.key)&&(p.preventDefault(),g())}),n.follow(({frame:p,playing:g})=>{o.value=p,r.textContent=g?"❚❚ Pause":"▶ Play"}),{element:f,views:m,load(p,g){[i,s]=[p.frames,p.contact_frame],o.max=i-1,h.replaceChildren(...g.map(({frame:y,kind:M})=>C("i",{class:M,style:`left:${100*y/Math.max(i-1,1)}%`}))),u.replaceChildren(...g.map(({frame:y,kind:M,text:b})=>C("li",{},C("button",{type:"button",class:M,title:`Go to ${Te(y*p.step)}`,onclick:()=>n.seek(y)},C("b",{},Te(y*p.step)),` ${b}`))))}}}function Fy(n,t){let{cell:e,scan:i}=n,s=C("span"),r=Iy(e),o=T_(),a=ty(o.seek),c=Dy(o.seek),l=C("p",{class:"instant","data-test":"instant"}),d=C("div",{class:"facts"}),h=!1,u=null,f=null,m=Ny(o,{look:r.look,inView:()=>h&&u!==null});new IntersectionObserver(w=>h=w.at(-1).isIntersecting).observe(r.element);function x(w){let _=u.actions[Ly(u.actions,w)]?.name,T=u.sensors.filter(D=>D.detected[w]==="1").map(D=>D.name),k=[`${Te(w*e.step_s)} of ${Te((u.frames-1)*e.step_s)}`,_?nm(_):"start"];return u.sensors.length>0&&k.push(T.length>0?`${T.join(", ")} ${T.length>1?"report":"reports"} ${_r()}`:`no sensor reports ${_r()}`),w===u.contact_frame&&k.push(`${f.class==="separation"?"":"contact: "}${f.robot_link} ${Ni(f)}`),k.join(" · ")}o.follow(({frame:w})=>{u&&(r.show(w),a.show(w),c.show(w),l.textContent=x(w))}),r.scene?m.views.append(r.names):m.views.hidden=!0;let p=C("p",{class:"shown-hazard"}),g=C("div",{},r.element,m.element,l,m.views,r.scene?Py(e):null),y=C("div",{class:"notice","data-test":"no-replay"}),M=C("div",{class:"graphs screen-only"},a.element,c.element);function b({hazard:w}){f=n.hazard(w),u=n.replay(w)??null,s.textContent=`${w}: ${f.robot_link} ${Ni(f)}`;let _=n.causeOf(w)?.worst===w;if(p.replaceChildren(C("b",{},_?"Its worst way":"One of its ways"),`: ${f.robot_link} ${Ni(f)} after ${Te(f.time_s)} `,C("span",{class:"id"},w)),d.replaceChildren(iu(f,i.settings)),g.hidden=u===null,M.hidden=u===null,y.hidden=u!==null,!u){o.pause(),y.replaceChildren(C("p",{},`This report carries the replays of the worst ways only, not of ${w}. To get it, in the folder with this report:`),Xs(`fmi-hazard report . --hazard ${w}`));return}let T=E_(u,f);r.drawFlat(n.topView(w)),r.scene?.load(u,f),m.load(u,T),a.load(u,T,Bn(f)),c.load(u,T),o.load(u.frames,e.step_s,u.contact_frame),r.look("overview"),r.show(u.contact_frame)}let R=Pn("replay","",C("div",{class:"replay"},M,d));return R.querySelector("h2").append("How it comes to this ",s),{picture:C("div",{class:"picture"},p,g,y),element:R,start:()=>t.follow(b)}}var oa=()=>{try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}};function Uy(n){let t=new Map(n.flatMap(l=>l.hazards.map(d=>[d,l.id]))),e=new Map(n.map(l=>[l.id,l.worst])),i=l=>t.has(l)||e.has(l),s=l=>e.has(l)?{cause:l,hazard:e.get(l)}:{cause:t.get(l),hazard:l},r=[],o=i(oa())?oa():n[0]?.id,a=o===void 0?{cause:null,hazard:null}:s(o);function c(l){let d=s(l);d.hazard!==a.hazard&&(a=d,r.forEach(h=>h(a)))}return addEventListener("hashchange",()=>{i(oa())&&c(oa())}),{get now(){return a},get namesHazard(){return t.has(oa())},get unknown(){let l=oa();return/^[CH]-/.test(l)&&!i(l)?l:null},select(l){history.replaceState(null,"",`#${encodeURIComponent(l)}`),c(l)},follow(l){r.push(l),a.hazard!==null&&l(a)}}}function QC({decisionOf:n,worst:t,counted:e,causeOf:i,settings:s,others:r}){let a=l=>l.sequences??l.times_found,c=l=>Fi(l,s);return[["id",l=>l.id,l=>C("a",{href:`#${l.id}`,class:"id"},l.id)],["cause",l=>i(l.id).number,l=>qs(i(l.id)),!0],["ratio",l=>c(l).decides.ratio,l=>tR(c(l),t),!0],["body region",l=>Si(l.body_region),l=>Si(l.body_region)],["hit by",l=>l.robot_link,l=>l.robot_link],["force: own speed",l=>l.force_n,l=>vn(l.force_n),!0],["force: approach",l=>l.directed_force_n,l=>vn(l.directed_force_n),!0],["limit",l=>l.limit_n,qu,!0],...r?[["what is broken",l=>l.class,om]]:[],["speed",l=>l.speed_m_s,l=>Zn(l.speed_m_s),!0],["safe below",l=>l.safe_below_m_s,rm,!0],["time",l=>l.time_s,l=>Te(l.time_s),!0],[e?"sequences":"times found",l=>Number(a(l)),l=>De(a(l)),!0],["report the person",l=>Yu(l.sensors),l=>Yu(l.sensors)],["confirmed",l=>so(l.confirmed),l=>so(l.confirmed)],["decision",l=>n(l.id),l=>n(l.id)]]}function tR({decides:{ratio:n},own:t,approach:e,apart:i},s){let r=Math.max(s,1.05),o=a=>`${(100*a/r).toFixed(1)}%`;return C("span",{class:"ratio"},i?C("span",{class:"flag","data-test":"apart",title:`${Hl} Own speed ${Ce(t.ratio)}, approach ${Ce(e.ratio)}.`},"differ"):null,C("span",{class:"bar screen-only","aria-hidden":"true"},C("span",{class:n>=1?"over":"under",style:`width:${o(n)}`}),C("span",{class:"mark",style:`left:${o(1)}`})),C("b",{},Ce(n)))}function Rp(n,t,e,i){let s=[C("option",{value:""},"all"),...e.map(([r,o])=>C("option",{value:r},o))];return C("label",{},`${n} `,C("select",{"data-test":t,onchange:i},s))}function Oy(n,t,e,i){let s=n.scan.hazards,{settings:r}=n.scan,o=Math.max(...s.map(U=>Fi(U,r).decides.ratio)),a=U=>e.decision(U),c=s.some(U=>U.sequences!==null),l=QC({decisionOf:a,worst:o,counted:c,causeOf:n.causeOf,settings:r,others:s.some(U=>!Bn(U))}),d=U=>[...new Set(s.map(U))].sort(),h={column:2,descending:!0},u=null,f=C("input",{type:"search",placeholder:"any text","data-test":"filter",oninput:N}),m=Rp("region","filter-region",d(U=>U.body_region).map(U=>[U,Si(U)]),N),x=Rp("hit by","filter-link",d(U=>U.robot_link).map(U=>[U,U]),N),p=Rp("decision","filter-decision",e.decisions.map(U=>[U,U]),N),g=C("output",{"data-test":"shown"}),y=C("button",{type:"button",hidden:!0,"data-test":"clear-bin",onclick:()=>G(null)}),M=new Map(s.map(U=>[U.id,_(U)])),b=new Map,R=C("tbody",{onkeydown:T}),w=l.map(([U,,,J],$)=>C("th",{scope:"col",class:J?"number":null},C("button",{type:"button","data-test":`sort-${$}`,onclick:()=>k($)},U)));function _(U){let J=l.map(([,,st,lt])=>C("td",{class:lt?"number":null},st(U))),$=C("tr",{"data-test":"row","data-id":U.id,class:U.class},J);return $.addEventListener("click",st=>{st.ctrlKey||st.metaKey||st.shiftKey||String(getSelection())||(st.preventDefault(),t.select(U.id))}),$}function T(U){let J={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[U.key],$=J&&U.target.closest("tr")?.[J]?.querySelector("a");$&&(U.preventDefault(),$.focus())}function k(U){let J=!!l[U][3];h={column:U,descending:h.column===U?!h.descending:J},N()}function D(U){let J=(st,lt)=>!st.querySelector("select").value||st.querySelector("select").value===lt,$=f.value.trim().toLowerCase();return(u===null||u.ids.has(U.id))&&J(m,U.body_region)&&J(x,U.robot_link)&&J(p,a(U.id))&&$.split(/\s+/).every(st=>b.get(U.id).includes(st))}function N(){let[,U]=l[h.column],J=h.descending?-1:1,st=[...s].sort((lt,Z)=>J*(U(lt)<U(Z)?-1:U(lt)>U(Z)?1:0)).filter(D);R.replaceChildren(...st.map(lt=>M.get(lt.id))),g.textContent=st.length===s.length?`${s.length} shown`:`${st.length} of ${s.length} shown`,w.forEach((lt,Z)=>{let pt=h.descending?"descending":"ascending";lt.setAttribute("aria-sort",Z===h.column?pt:"none")})}function G(U){u=U,y.hidden=u===null,y.textContent=u===null?"":`only ${u.name} ✕`,Y.open||=u!==null,N()}function W(){for(let U of s)M.get(U.id).lastElementChild.textContent=a(U.id),b.set(U.id,M.get(U.id).textContent.toLowerCase());N()}let P=n.scan.hazards.some(U=>U.class==="head_contact")?C("p",{class:"note"},"“None allowed”: a moving robot may not touch head or throat at all; the ratio is that to the force limit and may be below 1."):null,B=C("button",{type:"button",class:"to-replay screen-only","data-test":"to-replay",onclick:i}),Y=C("details",{"data-test":"ways"},C("summary",{},s.length===1?"The one way, as a row":`All ${De(s.length)} ways, one row each`),C("div",{class:"filters screen-only"},C("label",{},"filter ",f),m,x,p,y,g),B,C("div",{class:"scroll",tabindex:0},C("table",{class:"hazards"},C("thead",{},C("tr",{},w)),R)),C("p",{class:"note"},`Force with the robot's own speed, and with the speed of approach (the person's walking included); ${Wl(r)} decides. “differ”: by more than a factor of 2.`),P);e.follow(W),W(),t.follow(({hazard:U})=>{B.textContent=`Show the replay of ${U}`;for(let[J,$]of M)$.setAttribute("aria-selected",J===U),ma($.querySelector("a"),J===U)});let H=()=>Y.open||=t.namesHazard;return addEventListener("hashchange",H),H(),{element:Pn("hazards","Every way by itself",Y),setBin:G}}function eR(n){let t=C("p",{class:"notice","data-test":"unknown-id"}),e=()=>{t.hidden=n.unknown===null,t.textContent=n.unknown===null?"":`The address names ${n.unknown}, which this report does not hold.`};return addEventListener("hashchange",e),e(),t}async function nR(n){let t=await Tm();jp(t.scan.settings.controls??[]),Qp(t.scan.settings.second?.names),n.append(vm(t));let e=Uy(t.causes);if(n.append(eR(e),...t.whole?[x_(t)]:[]),t.causes.length>0){let i=um(t),s=Fy(t,e),r=Oy(t,e,i,()=>s.picture.scrollIntoView({block:"start"})),o=Am(t,e,i);n.append(v_(t,i),xm(t,e,i,{picture:s.picture,assess:o.show}),s.element,C("div",{class:"pair"},n_(t,e,r.setBin),o.element),r.element),s.start()}else n.append(Pn("hazards","Hazards",C("p",{"data-test":"none"},"None was found. What that is worth is told by what the search covered, below.")));n.append(Sm(t),S_(t))}var ky=document.getElementById("report");nR(ky).catch(n=>{throw ky.append(C("p",{class:"notice"},`This report cannot be shown: ${n.message}. scan.json beside it holds the same results.`)),n});})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
/*! three.js (in this file)
 * The MIT License
 *
 * Copyright © 2010-2026 three.js authors
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy
 * of this software and associated documentation files (the "Software"), to deal
 * in the Software without restriction, including without limitation the rights
 * to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is
 * furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in
 * all copies or substantial portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 * IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 * FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 * LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 * OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
 * THE SOFTWARE.
 */
/*! uPlot (in this file)
 * The MIT License (MIT)
 *
 * Copyright (c) 2022 Leon Sorokin
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy
 * of this software and associated documentation files (the "Software"), to deal
 * in the Software without restriction, including without limitation the rights
 * to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is
 * furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in
 * all copies or substantial portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 * IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 * FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 * LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 * OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
 * THE SOFTWARE.
 */
