(()=>{var ds=i=>`${i.toFixed(2)}x`,Wn=i=>`${i.toFixed(2)} s`,an=(i,t)=>`${String(i).replace(/\B(?=(\d{3})+(?!\d))/g,",")} ${t}${i===1?"":"s"}`;var Wr=[{key:"task",label:"Task: who does what there (ISO 12100, 5.2)",long:!0},{key:"severity",label:"Severity",options:[["S1","S1: slight, reversible"],["S2","S2: serious, irreversible or death"]]},{key:"exposure",label:"Exposure",options:[["F1","F1: seldom or short"],["F2","F2: frequent or long"]]},{key:"avoidance",label:"Avoidance",options:[["P1","P1: possible"],["P2","P2: scarcely possible"]]},{key:"decision",label:"Decision",options:["open","reduce","accepted","not credible"].map(i=>[i,i])},{key:"measure",label:"Protective measure",long:!0},{key:"residual",label:"Residual risk",long:!0},{key:"by",label:"By"},{key:"date",label:"Date",type:"date"}],ey={S1F1P1:"a",S1F1P2:"b",S1F2P1:"b",S1F2P2:"c",S2F1P1:"c",S2F1P2:"d",S2F2P1:"d",S2F2P2:"e"},lr=({severity:i,exposure:t,avoidance:e})=>ey[`${i}${t}${e}`]??null,yp=i=>Object.fromEntries(Object.entries(i).sort(([t],[e])=>t<e?-1:1));function vp({assessments:i,cell:t,causeOf:e}){let n=new Map(Object.entries(i).map(([h,d])=>[h,{...d}])),s=[],r=new Set,o=()=>s.forEach(h=>h());addEventListener("beforeunload",h=>{r.size>0&&h.preventDefault()});let a=Wr.find(h=>h.key==="decision").options.map(([h])=>h),c=[...n.values()].map(h=>h.decision).filter(Boolean),l=h=>n.get(h)??{},u=h=>l(h).decision||null;return{decisions:[...new Set([...a,...c])],of:l,own:u,ofCause:h=>u(h)??"open",decision:h=>u(h)??u(e(h)?.id)??"open",set(h,d,f){let p=Object.fromEntries(Wr.map(x=>[x.key,""]));n.set(h,{...p,...n.get(h),[d]:f}),r.add(h),o()},unsaved(){let h=[...r].filter(f=>f.startsWith("C-")).length,d=r.size-h;return[h>0?an(h,"cause"):"",d>0?an(d,"single way"):""].filter(Boolean).join(" and ")},text(){let h=Object.fromEntries([...n].map(([d,f])=>[d,yp(f)]));return`${JSON.stringify({assessments:yp(h),cell:t.name,format:1},null,2)}
`},saved(){r.clear(),o()},follow:h=>s.push(h)}}var ny="http://www.w3.org/2000/svg";function bp(i,t,e){for(let[n,s]of Object.entries(t))n.startsWith("on")?i.addEventListener(n.slice(2),s):s!=null&&s!==!1&&i.setAttribute(n,s===!0?"":s);return i.append(...e.flat().filter(n=>n!=null)),i}function C(i,t={},...e){return bp(document.createElement(i),t,e)}function Mt(i,t={},...e){return bp(document.createElementNS(ny,i),t,e)}function Qo(i,t){t?i.setAttribute("aria-current","true"):i.removeAttribute("aria-current")}function Tn(i,t,...e){return C("section",{id:i,"aria-labelledby":`${i}-title`},C("h2",{id:`${i}-title`},t),...e)}function Zi(i){let t=C("dl");for(let[e,n]of i)n!=null&&n!==""&&t.append(C("div",{},C("dt",{},e),C("dd",{},n)));return t}function Os(i){let t=C("code",{},i),e=C("button",{type:"button",class:"copy screen-only",onclick:n},"Copy");async function n(){try{await navigator.clipboard.writeText(i),e.textContent="Copied"}catch{getSelection().selectAllChildren(t),e.textContent="Marked: press Ctrl+C"}setTimeout(()=>e.textContent="Copy",2500)}return C("div",{class:"command"},t,e)}function Ml(i){let t=new DOMParser().parseFromString(i,"image/svg+xml").documentElement;if(t.localName!=="svg")return C("p",{class:"note"},"This drawing is not SVG.");for(let s of[t,...t.querySelectorAll("*")]){["script","foreignObject"].includes(s.localName)&&s.remove();for(let{name:r}of[...s.attributes])(r.startsWith("on")||r.endsWith("href"))&&s.removeAttribute(r)}let e=t.getAttribute("width"),n=t.getAttribute("height");return!t.hasAttribute("viewBox")&&e&&n&&t.setAttribute("viewBox",`0 0 ${e} ${n}`),t.setAttribute("role","img"),document.importNode(t,!0)}var Sl=100,Mp=212,iy=.3,sy=[["upper_arm","M27.4 46.5 C25 54 21.4 70 20 82 L28.2 84.2 C29.6 74 32.6 62 34 52.5 L34 46 C31.6 43.2 29 43.6 27.4 46.5 Z"],["lower_arm","M19.8 83.6 C17.4 92 15.6 103 14.8 112 L21.2 113.6 C23.6 105 26.9 95 28 85.8 Z"],["hand","M14.6 113.6 C11.8 118 11.2 124 12.8 129.5 C14.8 132.5 18 131.8 19 128.4 L22.6 124.2 C23.4 121 21.6 118 21 115.2 Z"],["thigh","M32.2 104.8 C31.4 118 33 134 35.2 149 L46.2 149 C47.8 136 48.9 122 48.9 108.6 Z"],["lower_leg","M35.3 150.6 C33.8 160 34.6 174 37 190 C36.6 195 33.6 199.4 32.6 203.4 C34.6 206.6 43.4 206.6 45.2 203.4 C45.2 198 44.3 195 44.5 190 C46.4 176 47.5 162 46.2 150.6 Z"]],Sp=["pelvis","M35 86.2 C33.4 91 32.5 97 32.2 103.2 L48.6 107.2 L50 104.4 L51.4 107.2 L67.8 103.2 C67.5 97 66.6 91 65 86.2 Z"],ry="M45 28.4 C47.5 31 52.5 31 55 28.4 L55.8 35.4 L44.2 35.4 Z",oy="M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.4 42.8 34.6 45.2 C37 42.2 41 40.2 46.2 39.4 L45.6 36.6 Z",ay=[["skull_forehead","M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 Z"],["face","M39.4 16.2 L60.6 16.2 C60.6 23.4 55.2 30 50 30 C44.8 30 39.4 23.4 39.4 16.2 Z"],["neck_front",ry],["chest","M47 39.4 C41.4 40.4 37 42.6 34.8 46 L35 53 C34.8 58.6 35 62.4 35.8 66 L64.2 66 C65 62.4 65.2 58.6 65 53 L65.2 46 C63 42.6 58.6 40.4 53 39.4 Z"],["abdomen","M36 67.2 C36.6 73 36.3 78.6 35.2 85 L64.8 85 C63.7 78.6 63.4 73 64 67.2 Z"],Sp],ly=[["skull_forehead","M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 C60.8 22 57 28.2 50 28.2 C43 28.2 39.2 22 39.4 15 Z"],["neck","M44.6 26.6 C47.5 30 52.5 30 55.4 26.6 L55.8 35.4 L44.2 35.4 Z"],["back_shoulders","M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.6 43 34.8 46 L35 53 C34.8 64 36.9 72 35.2 85 L64.8 85 C63.1 72 65.2 64 65 53 L65.2 46 C67.4 43 70.8 42.6 73 46 C72.8 44.6 72.4 43.3 71.4 42 C68 38.2 60 38.6 56 36.6 Z"],Sp],cy={front:"M45.6 18.6 h0.01 M54.4 18.6 h0.01 M46.6 24.8 C48.6 26.2 51.4 26.2 53.4 24.8 M50 70 v6",back:"M50 40 V82 M42.6 52 C41 57 41.4 61 44 63 M57.4 52 C59 57 58.6 61 56 63"};function hy(i){let t=[...sy,...i==="front"?[["back_shoulders",oy]]:[]];return[...(i==="front"?ay:ly).map(([e,n])=>[e,n,!1]),...t.flatMap(([e,n])=>[[e,n,!1],[e,n,!0]])]}function uy({lines:i}){let t=new Map;for(let{body_region:e,ratio:n}of i)t.set(e,Math.max(t.get(e)??0,n));return t}function wl(i,t){let e=uy(i),n=Math.max(...e.values()),{regions:s}=t.causes[i.id],r=new Map(s),o=[];function a([d,f,p]){let x=e.get(d),m=x!==void 0,g=Mt("path",{d:f,class:m?"region hit":"region","data-region":d,transform:p?`translate(${Sl} 0) scale(-1 1)`:null,style:m?`--heat:${Math.max(iy,x/n).toFixed(3)}`:null},Mt("title",{},m?r.get(d):`${t.regions[d]}: not hit`));return o.push(g),g}let c=(d,f)=>Mt("g",{transform:`translate(${f} 0)`},hy(d).map(a),Mt("path",{class:"feature",d:cy[d]}),Mt("text",{x:Sl/2,y:Mp+9},d)),l=[...r.values()],u=s.map(([d,f])=>C("li",{"data-region":d},f));return{element:C("figure",{class:"body-outline","data-test":"body-outline"},Mt("svg",{viewBox:`2 -2 ${2*Sl-14} ${Mp+15}`,role:"img","aria-label":`Person, front and back. Hit: ${l.join(", ")}.`},c("front",-3),c("back",Sl-11)),C("ul",{class:"regions","aria-hidden":"true"},u)),mark(d){for(let f of[...o,...u])f.classList.toggle("selected",f.dataset.region===d)}}}var Mu=3,dy=120,wp=["#c2410c","#1d6fb8","#7c3aed","#15803d","#a16207","#0e7490","#be185d","#57606a"],ta=({number:i})=>wp[(i-1)%wp.length],ks=i=>C("span",{class:"badge",style:`background:${ta(i)}`},String(i.number)),Su=({share:i,earliest:t,ways:e})=>Object.entries({share:i,earliest:t,ways:e}).filter(([,n])=>n);function fy({change:i,removes_all:t,less:e},[n,s]){return C("li",{"data-test":"change",class:t?"all":null},C("b",{},i),C("p",{},n),C("p",{class:"note"},s),e?C("p",{class:"note"},e):null)}var wu=({other:i})=>i?C("p",{class:"flag"},i):null;function Eu({id:i,advice:t},e){let n=C("h4",{},"What to change");if(!t){let[c,l]=e.commands.explain;return C("div",{class:"remedy"},n,C("p",{"data-test":"no-advice"},c),Os(`${l}${i}`))}let{changes:s,no_change:r}=e.causes[i],o=t.changes.map((c,l)=>fy(c,s[l])),a=o.slice(Mu);return C("div",{class:"remedy"},n,o.length>0?C("ol",{class:"changes"},o.slice(0,Mu)):C("p",{"data-test":"no-change"},r),a.length>0?C("details",{},C("summary",{},an(a.length,"other change")),C("ol",{class:"changes",start:Mu+1},a)):null,t.note?C("p",{class:"note"},t.note):null)}function Ep(i,t,{choose:e,assess:n,assessments:s}){let{words:r}=i,o=r.causes[t.id],[a,c]=o.severity,l=wl(t,r),u=C("p",{class:"decided","data-test":"cause-decision"}),h=g=>y=>{!(y.ctrlKey||y.metaKey||y.shiftKey)&&String(getSelection())===""&&(y.preventDefault(),y.stopPropagation(),e(g))},d=g=>C("li",{},C("a",{href:`#${g}`,"data-test":"way","data-id":g,onclick:h(g)},C("span",{class:"id"},g),` ${r.hazards[g].way}`)),f=({hazards:g},y)=>C("details",{class:"line","data-test":"line"},C("summary",{},`${r.hazards[g[0]].deed}: `,C("b",{},o.lines[y][1]),`, ${an(g.length,"way")}`),C("ul",{class:"ways"},g.map(d))),p=C("a",{href:`#${t.id}`,onclick:h(t.id)},t.sentence),x=C("article",{class:"cause","data-test":"cause","data-id":t.id,style:`--cause:${ta(t)}`},C("header",{class:"cause-head"},ks(t),C("h3",{class:t.sentence.length>dy?"long":null,"data-test":"cause-sentence"},p),C("span",{class:"id"},t.id)),C("p",{class:"severity"},C("b",{class:"worst"},a)," ",C("span",{},c)),wu(o),C("ul",{class:"figures"},Su(o).map(([g,y])=>C("li",{class:`figure-${g}`},y))),C("div",{class:"cause-body"},Eu(t,r),l.element),C("div",{class:"decision-row"},u,C("button",{type:"button",class:"screen-only",onclick:n},"Assess it")),C("details",{class:"lines","data-test":"lines"},C("summary",{},`${an(t.hazards.length,"way")} of this cause, by region and link`),t.lines.map(f)));x.addEventListener("click",g=>{x.classList.contains("compact")&&!g.defaultPrevented&&String(getSelection())===""&&e(t.id)});function m(){let g=lr(s.of(t.id)),y=t.hazards.filter(M=>s.own(M)!==null).length;u.replaceChildren("Decision: ",C("b",{},s.ofCause(t.id)),g?` · PL r: ${g}`:"",y>0?` · ${an(y,"way")} decided on ${y===1?"its":"their"} own`:"")}return s.follow(m),m(),{element:x,show(g){x.classList.toggle("compact",g===null),Qo(x,g!==null),g!==null&&(l.mark(i.hazard(g).body_region),x.querySelectorAll('[data-test="way"]').forEach(y=>Qo(y,y.dataset.id===g)))},focus:()=>p.focus({preventScroll:!0})}}function Tp(i,t,e,{picture:n,assess:s}){let r=C("div",{class:"chosen"}),o=C("div",{class:"others"}),a=C("div",{class:"hero"},r,n);function c(u){let h=t.now.cause,d=o.contains(document.activeElement);t.select(u),d&&l.get(t.now.cause).focus(),t.now.cause===h?n.scrollIntoView({block:"nearest"}):a.scrollIntoView({block:"start"})}let l=new Map(i.causes.map(u=>[u.id,Ep(i,u,{choose:c,assess:s,assessments:e})]));return t.follow(({cause:u,hazard:h})=>{for(let[f,p]of l)p.show(f===u?h:null);let d=[...l].filter(([f])=>f!==u).map(([,f])=>f.element);r.firstElementChild!==l.get(u).element&&(r.replaceChildren(l.get(u).element),o.replaceChildren(...d.length>0?[C("h3",{},`${an(d.length,"other cause")}, worst first`),...d]:[]))}),Tn("causes",`${an(i.causes.length,"cause")}${i.causes.length>1?", worst first":""}`,a,o)}var py={shown:"shown",assumed:"accepted",open:"open"},my=i=>({shown:()=>i.figure,assumed:()=>`${i.by}: ${i.because} (${i.tried})`,open:()=>i.what_to_do?`${i.why}. ${i.what_to_do}.`:i.why})[i.standing](),gy=i=>C("tr",{class:i.standing},C("td",{},py[i.standing]),C("td",{},i.about?`${i.says} (${i.about})`:i.says),C("td",{},my(i))),_y=["open","assumed","shown"];function Ap({obligations:i},t){if(!i||i.length===0)return null;let e=_y.flatMap(s=>i.filter(r=>r.standing===s)),n=i.flatMap(s=>s.accept?[s.accept]:[]);return C("div",{"data-test":"rests-on"},C("h3",{},"What this result rests on"),C("div",{class:"scroll",tabindex:0},C("table",{class:"plain obligations"},C("thead",{},C("tr",{},["","needed","known"].map(s=>C("th",{scope:"col"},s)))),C("tbody",{},e.map(gy)))),n.length>0?[C("p",{},t.to_accept),C("pre",{"data-test":"accept"},n.join(`
`))]:null)}var xy=["certificate","residual"];function yy({id:i,title:t,says:e,rows:n=[]},{certificate:s,faults:r}){let o=i!=="certificate"||s?.complete;return[C("h3",{},t),e?C("p",{"data-test":o?null:"incomplete"},e):null,Zi(n),i==="faults"?C("ul",{class:"faults"},r.map(a=>C("li",{},C("p",{class:"message"},a.message),C("p",{class:"note"},a.actions.join(", "))))):null]}function Cp({scan:i,words:t}){let e=i.warnings.map(s=>C("li",{},s)),n=s=>C("div",{},t.searched.filter(({id:r})=>xy.includes(r)===s).flatMap(r=>yy(r,i)));return Tn("coverage","What the search covered",Ap(i,t),e.length>0?C("ul",{class:"warnings","data-test":"warnings"},e):null,C("div",{class:"columns"},n(!0),n(!1)))}var Pp=i=>Uint8Array.from(atob(i),t=>t.charCodeAt(0));function cr(i){let t=Pp(i),e=new DataView(t.buffer);return Float32Array.from({length:t.length/4},(n,s)=>e.getFloat32(4*s,!0))}async function Rp(i){let t=new Blob([Pp(i)]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(t).json()}function vy(i,t){let e={...i,step:t.step_s,links:cr(i.links),body:cr(i.body),arms:cr(i.arms),...i.moved?{moved:i.moved.map(n=>({...n,centre_m:cr(n.centre_m)}))}:{},...i.beside?{beside:cr(i.beside),beside_arms:cr(i.beside_arms)}:{}};for(let n of["time_s","distance_m","speed_m_s","force_ratio"])e[n]=cr(i[n]);return e}async function Ip(){let i=JSON.parse(document.getElementById("data").textContent);if(i.format!==3)throw new Error(`data of format ${i.format}, but this viewer reads format 3`);let t=await Rp(i.replays);i.cell.looks=i.cell.looks?await Rp(i.cell.looks):[];let e=new Map(t.map(l=>[l.id,l])),n=new Map,s=new Map(i.scan.hazards.map(l=>[l.id,l])),r=i.scan.causes??[],o=new Map(r.map((l,u)=>[l.id,{...l,number:u+1}])),a=new Map([...o.values()].flatMap(l=>l.hazards.map(u=>[u,l]))),c=i.scan.hazards.filter(({id:l})=>!a.has(l));if(c.length>0)throw new Error(`${c[0].id} is in no cause`);return{...i,replays:t,causes:[...o.values()],cause:l=>o.get(l),causeOf:l=>a.get(l),hazard:l=>s.get(l),replay(l){return!n.has(l)&&e.has(l)&&n.set(l,vy(e.get(l),i.cell)),n.get(l)},topView:l=>e.get(l)?.top_view}}var Tu="assessments.json";function by(i,{decisions:t}){let e={"data-test":`assess-${i.key}`,name:i.key};if(i.options){let n=i.key==="decision"?t.map(r=>[r,r]):i.options,s=C("option",{value:""},"–");return C("select",e,s,n.map(([r,o])=>C("option",{value:r},o)))}return i.long?C("textarea",{...e,rows:2}):C("input",{...e,type:i.type??"text"})}function My(i){let t=URL.createObjectURL(new Blob([i],{type:"application/json"}));C("a",{href:t,download:Tu}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function Lp(i,t,e){let n=Wr.map(m=>[m,by(m,e)]),s=C("p",{class:"subject","data-test":"assess-subject"}),r=C("input",{type:"checkbox","data-test":"assess-scope",onchange:p}),o=C("span"),a=C("output",{class:"plr","data-test":"plr"}),c=C("output",{"data-test":"unsaved"}),l=C("button",{type:"button",class:"primary","data-test":"save",onclick:d},`Save ${Tu}`),u=null,h=()=>r.checked?t.now.hazard:t.now.cause;function d(){My(e.text()),e.saved()}function f(){let m=lr(e.of(h()));a.textContent=m?`PL r: ${m}`:"PL r: follows from severity, exposure and avoidance";let g=e.unsaved();c.textContent=g?`Unsaved edits of ${g}.`:"";let y=e.own(t.now.hazard);o.textContent=` only this row: ${t.now.hazard}${y?` (decided on its own: ${y})`:""}`}function p(){let{deed:m,way:g}=i.words.hazards[t.now.hazard],y=i.cause(t.now.cause);s.replaceChildren(C("b",{},h()),r.checked?`: only ${m}, ${g}. What is left empty is as for the cause.`:`, for ${y.hazards.length===1?"its one way":`all its ${an(y.hazards.length,"way")}`}: ${y.sentence}`);for(let[M,b]of n){let R=e.of(h())[M.key]??"";b.tagName==="SELECT"&&![...b.options].some(w=>w.value===R)&&b.append(C("option",{value:R},R)),M.key==="decision"&&(b.options[0].hidden=!r.checked,b.options[0].textContent=`as for the cause (${e.ofCause(y.id)})`),b.value=R||(M.key==="decision"&&!r.checked?"open":"")}f()}for(let[m,g]of n)g.addEventListener("input",()=>e.set(h(),m.key,g.value));t.follow(m=>{m.cause!==u&&(u=m.cause,r.checked=!1),p()}),e.follow(f);let x=Tn("assessment","Assessment (ISO 12100)",s,C("label",{class:"scope-switch"},r,o),C("form",{onsubmit:m=>m.preventDefault()},n.map(([m,g])=>C("label",{class:m.long?"long":null},C("span",{},m.label),g))),C("p",{class:"plr-line"},a,C("span",{class:"note"}," Required performance level by the risk graph of ISO 13849-1, Annex A.")),C("p",{class:"save"},l,c),C("p",{class:"note"},`Saves the assessments of all causes and rows, those given to this report included, as one file. Keep ${Tu} beside the cell file, in git: scans read it and never write it. This page itself keeps no edits.`));return{element:x,show(){x.scrollIntoView({block:"start"}),n[0][1].focus({preventScroll:!0})}}}function Au([i,t,e,n],[s,r,o]){let[a,c,l]=[2*(t*o-e*r),2*(e*s-i*o),2*(i*r-t*s)];return[s+n*a+t*l-e*c,r+n*c+e*a-i*l,o+n*l+i*c-t*a]}function Cu(i){let t=[...i].sort(([n,s],[r,o])=>n-r||s-o),e=n=>{let s=[];for(let r of n){for(;s.length>1;){let[o,a]=s.slice(-2);if((a[0]-o[0])*(r[1]-o[1])-(a[1]-o[1])*(r[0]-o[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return[...e(t),...e(t.reverse())]}function Pn({centre_m:i,size_m:t,quaternion:e}){let n=[-.5,.5],s=n.flatMap(r=>n.flatMap(o=>n.map(a=>[r*t[0],o*t[1],a*t[2]])));return Cu(s.map(r=>Au(e,r)).map(([r,o])=>[i[0]+r,i[1]+o]))}function El([i,t],e){return e.every(([n,s],r)=>{let[o,a]=e[(r+1)%e.length];return(o-n)*(t-s)-(a-s)*(i-n)>=0})}function Bs(i,t,e){let n=[0,1,2].map(a=>e[a]-t[a]),s=n.reduce((a,c)=>a+c*c,0),r=s>0?n.reduce((a,c,l)=>a+c*(i[l]-t[l]),0)/s:0,o=Math.max(0,Math.min(1,r));return Math.hypot(...[0,1,2].map(a=>i[a]-t[a]-o*n[a]))}function Dp(i,t,{a:e,b:n,radius:s}){for(let o=0;o<24;o++){let a=o/24;if(Bs(i.map((c,l)=>c+a*(t[l]-c)),e,n)<s)return!0}return!1}var Xr=(i,t)=>[i[t],i[t+1],i[t+2]];function _i(i,t,e,n){let s=6*(e*t.body.length+n);return{a:Xr(i.body,s),b:Xr(i.body,s+3),radius:t.body[n].radius_m}}var hr=["left","right"];function ur(i,t,e){let n=9*(2*t+e);return[0,3,6].map(s=>Xr(i.arms,n+s))}function Np(i,t,e){let[[n],[s]]=hr.map((c,l)=>ur(i,e,l)),[r,o]=[n[0]-s[0],n[1]-s[1]],a=Math.hypot(r,o);if(a<.02){let c=t.person_heading_deg*Math.PI/180;return[Math.cos(c),Math.sin(c),0]}return[o/a,-r/a,0]}var Up=i=>({upper_arm:0,lower_arm:1,hand:2})[i];function Ji(i,t,e,n){let s=7*(e*t.links.length+n),r=t.links[n];return r.shape==="capsule"?{a:Xr(i.links,s),b:Xr(i.links,s+3),radius:r.radius_m}:{position:Xr(i.links,s),quaternion:[...i.links.slice(s+3,s+7)]}}function $r(i,{position:t,quaternion:e}){return i.points_m.map(n=>Au(e,n).map((s,r)=>s+t[r]))}function ea(i,t,e,n){let s=Ji(i,t,e,n);return s.position?$r(t.links[n],s):[s.a,s.b]}function Ru(i,t){return i.reduce((e,n)=>t(n)<t(e)?n:e,i[0])}function Fp(i,t,e){let n=s=>{let{a:r,b:o,radius:a}=_i(i,t,i.contact_frame,s);return Bs(e.body_point_m,r,o)-a};return Ru([...t.body.keys()],n)}function Op(i,t,e){let n=[...t.links.keys()].filter(r=>{let{name:o,robot:a}=t.links[r];return o===e.robot_link||`${a}/${o}`===e.robot_link}),s=r=>{let o=Ji(i,t,i.contact_frame,r),a=e.contact_point_m;return o.position?Math.min(...$r(t.links[r],o).map(c=>Bs(a,c,c))):Bs(a,o.a,o.b)-o.radius};return Ru(n.length>0?n:[...t.links.keys()],s)}function Pu(i){let t=[...i.body.keys()].filter(e=>i.body[e].region.endsWith("shank"));return t.length>0?t:[i.body.length-1]}function kp(i,t){let e=Pu(t);return Array.from({length:i.frames},(n,s)=>{let r=e.map(o=>_i(i,t,s,o).b);return[0,1].map(o=>r.reduce((a,c)=>a+c[o],0)/r.length)})}function Iu(i,t){let e=n=>-_i(i,t,0,n).a[2];return Ru([...t.body.keys()],e)}var fs=.025,Sy=1e3,wy=[-1,0,1].flatMap(i=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[i,t,e])));function Ey(i){if(!i.points_m)return i;let t=([n,s,r],[o,a,c])=>o*n+a*s+c*r,e=wy.map(n=>i.points_m.reduce((s,r)=>t(r,n)>t(s,n)?r:s));return{...i,points_m:[...new Set(e)]}}function Lu(i,t,e,n,s=t.links[n]){let r=Ji(i,t,e,n);return r.position?{polygon:Cu($r(s,r).map(([o,a])=>[o,a])),radius:0}:{polygon:[r.a.slice(0,2),r.b.slice(0,2)],radius:r.radius}}function Ty([i,t],[[e,n],[s,r]],o){let[a,c]=[s-e,r-n],l=a*a+c*c,u=l>0?Math.max(0,Math.min(1,((i-e)*a+(t-n)*c)/l)):0;return(i-e-u*a)**2+(t-n-u*c)**2<=o*o}function Bp(i,t,[[e,n],[s,r]]){let[o,a]=[n-e,r-s].map(f=>Math.ceil(f/fs)),c=new Uint8Array(o*a),l=t.links.map(Ey),u=Math.max(1,Math.ceil(i.reduce((f,p)=>f+p.frames,0)/Sy));function h({polygon:f,radius:p}){let x=(b,R,w)=>{let _=f.map(O=>O[b]),E=Math.floor((Math.min(..._)-p-R)/fs);return[Math.max(0,E),Math.min(w-1,Math.floor((Math.max(..._)+p-R)/fs))]},[[m,g],[y,M]]=[x(0,e,o),x(1,s,a)];for(let b=y;b<=M;b++)for(let R=m;R<=g;R++){let w=b*o+R,_=[e+(R+.5)*fs,s+(b+.5)*fs];c[w]||=p>0?Ty(_,f,p):El(_,f)}}for(let f of i)for(let p=0;p<f.frames;p+=u)l.forEach((x,m)=>h(Lu(f,t,p,m,x)));let d=[];for(let f=0;f<a;f++)for(let p=0;p<o;p++){let x=p;for(;p<o&&c[f*o+p];)p+=1;p>x&&d.push({x:e+x*fs,y:s+f*fs,width:(p-x)*fs,height:1.2*fs})}return d}var dr=.1,zp=.4,Vp=1.2,Gp=.42,Hp=.1,Ay=[.2,.34,.48].flatMap(i=>[-90,-45,-135,0,180,45,135,90].map(t=>[i*Math.cos(t*Math.PI/180),i*Math.sin(t*Math.PI/180)])),qr={person:i=>i.person_xy_m,contact:i=>i.contact_point_m};function Cy(i,t){let e=new Map;for(let n of i){let[s,r]=t(n),o=[s,r].map(l=>Math.floor(l/dr+1e-6)),a=o.join(","),c=e.get(a)??{corner:o,hazards:[]};c.hazards.push(n),e.set(a,c)}return[...e.values()]}function Ry({cell:i,scan:t}){let e=(i.robots??[]).flatMap(a=>a.base_m?[a.base_m]:[]),n=[i.start.xy_m,...e,...t.hazards.flatMap(a=>[qr.person(a),qr.contact(a)])],s=a=>[0,1].map(c=>[Math.min(...a.map(l=>l[c])),Math.max(...a.map(l=>l[c]))]),r=s(n);return s([...n,...i.obstacles.flatMap(Pn),...i.zones.flatMap(a=>a.polygon_m)]).map(([a,c],l)=>[Math.max(a,r[l][0]-Vp)-zp,Math.min(c,r[l][1]+Vp)+zp])}function Wp(i,t,e,n){let s=e.map(([r,o],a)=>C("label",{},C("input",{type:"radio",name:i,value:r,checked:a===0,"data-test":`${i}-${r}`,onchange:()=>n(r)}),` ${o}`));return C("fieldset",{},C("legend",{},t),s)}function Xp(i,t){return[0,1].map(e=>{let[n,s]=t[e].map((o,a)=>o+(a===0?.3:-.3)),r=i.map(o=>Math.max(n,Math.min(s,o[e])));return(Math.min(...r)+Math.max(...r))/2})}function $p(i,t,e){let{cell:n,scan:s}=i,r=Ry(i),[[o,a],[c,l]]=r,u=([$,ut])=>[$-o,l-ut].map(ft=>Number(ft.toFixed(3))),h=$=>$.map(ut=>u(ut).join(",")).join(" "),d=$=>$.reduce((ut,ft)=>ft.ratio>ut.ratio?ft:ut),f="person",p="cause",x=Mt("g",{class:"bins"}),m=Mt("path",{class:"sweep"},Mt("title",{},"where robots are at some time in the replays of this report")),g=Mt("g",{class:"robot"}),y=Mt("g",{class:"selected-place"}),M=Mt("g",{class:"cause-places"}),b=C("output",{"data-test":"bin",class:"told screen-only"}),R="Point at a bin to read it; click it to see only its hazards in the table.",w=$=>b.textContent=$||R;w("");let _=($,ut,ft)=>(Object.entries({tabindex:"0",role:"button","aria-label":ut}).forEach(([Nt,Ut])=>$.setAttribute(Nt,Ut)),["mouseenter","focus"].forEach(Nt=>$.addEventListener(Nt,()=>w(ut))),["mouseleave","blur"].forEach(Nt=>$.addEventListener(Nt,()=>w(""))),$.addEventListener("click",ft),$.addEventListener("keydown",Nt=>{(Nt.key==="Enter"||Nt.key===" ")&&(Nt.preventDefault(),Nt.stopPropagation(),ft())}),$);function E(){let $=Cy(s.hazards,qr[f]),ut=({hazards:Ut})=>p==="count"?Ut.length:Math.max(...Ut.map(te=>te.ratio)),ft=$.map(ut),[yt,Nt]=[Math.min(...ft),Math.max(...ft)];x.replaceChildren(...$.map(Ut=>{let[te,ee]=Ut.corner.map(Rt=>Rt*dr),we=d(Ut.hazards),ge=`${f==="person"?"person at":"contact at"} ${te.toFixed(1)} to ${(te+dr).toFixed(1)}, ${ee.toFixed(1)} to ${(ee+dr).toFixed(1)} m`,ke=`${ge}: ${an(Ut.hazards.length,"hazard")}, worst ${ds(we.ratio)}, cause ${i.causeOf(we.id).number}`,de=()=>{e({name:ge,ids:new Set(Ut.hazards.map(Rt=>Rt.id))}),t.select(we.id)},Ge=Nt>yt?(ut(Ut)-yt)/(Nt-yt):1,[Je,en]=u([te,ee+dr]),B=p==="cause"?`fill:${ta(i.causeOf(we.id))}`:`--heat:${Ge.toFixed(3)}`;return _(Mt("rect",{x:Je,y:en,width:dr,height:dr,style:B,"data-test":"map-bin"}),ke,de)})),D.textContent=p==="cause"?"Each bin has the colour of its worst cause.":p==="count"?`${an(yt,"hazard")} (pale) to ${Nt} (dark) in a bin`:`worst ratio ${ds(yt)} (pale) to ${ds(Nt)} (dark)`,O()}function O(){let $=[];M.replaceChildren(...i.causes.map(ut=>{let[ft,yt]=u(qr[f](i.hazard(ut.worst))),Nt=([ge,ke])=>$.every(([de,Ge])=>Math.hypot(ge-de,ke-Ge)>2.2*Hp),Ut=Ay.map(([ge,ke])=>[ft+ge,yt+ke]),[te,ee]=Ut.find(Nt)??Ut[0];$.push([te,ee]);let we=Mt("g",{class:"cause-place","data-test":"place-cause","data-id":ut.id,transform:`translate(${te.toFixed(3)} ${ee.toFixed(3)})`,style:`--cause:${ta(ut)}`},Mt("line",{x2:(ft-te).toFixed(3),y2:(yt-ee).toFixed(3)}),Mt("circle",{r:Hp}),Mt("text",{y:.045},String(ut.number)));return _(we,`cause ${ut.number}: ${ut.sentence}`,()=>t.select(ut.id))}))}let D=C("span",{class:"note"}),I=([$,ut])=>$>o&&$<a&&ut>c&&ut<l,G=($,[ut,ft],yt)=>{let[Nt,Ut]=u([ut,ft]);return Mt("text",{x:Nt,y:Ut,class:`name ${yt}`},$)},H=n.obstacles.filter($=>!$.follows),N=H.map($=>Mt("polygon",{points:h(Pn($)),class:"obstacle"},Mt("title",{},$.name))),F=n.zones.map($=>Mt($.polygon_m.length>2?"polygon":"polyline",{points:h($.polygon_m),class:`zone ${$.kind}`},Mt("title",{},$.title))),q=[...H.map($=>G($.name,Xp(Pn($),r),"obstacle-name")),...n.zones.map($=>{let[ut,ft]=[0,1].map(yt=>Math.max(r[yt][0]+.05,Math.min(...$.polygon_m.map(Nt=>Nt[yt]))));return G($.title,[ut+.05,ft+.05],`zone-name ${$.kind}`)})],[V,J]=u(n.start.xy_m),Z=Mt("g",{class:"start",transform:`translate(${V} ${J}) rotate(${-n.start.heading_deg})`},Mt("circle",{r:.12}),Mt("path",{d:"M 0.12 0 H 0.3 M 0.22 -0.07 L 0.3 0 L 0.22 0.07"}),Mt("title",{},"start of the person")),K=[a-o,l-c],W=([$,ut])=>Array.from({length:Math.floor(ut)-Math.ceil($)+1},(ft,yt)=>Math.ceil($)+yt),st=Mt("g",{class:"ruler"},Mt("path",{d:`M 0 0 V ${K[1].toFixed(3)} H ${K[0].toFixed(3)}`}),W([r[0][0]+.2,r[0][1]-.15]).map($=>[Mt("path",{d:`M ${($-o).toFixed(3)} ${K[1].toFixed(3)} v 0.05`}),Mt("text",{x:($-o).toFixed(3),y:(K[1]+.19).toFixed(3)},`${$} m`)]).flat(),W([r[1][0]+.1,r[1][1]-.1]).map($=>[Mt("path",{d:`M 0 ${(l-$).toFixed(3)} h -0.05`}),Mt("text",{x:-.08,y:(l-$+.04).toFixed(3),class:"left"},`${$} m`)]).flat(),Mt("text",{x:-.1,y:(K[1]+.19).toFixed(3),class:"left"},"x, y")),lt=Mt("clipPath",{id:"map-frame"},Mt("rect",{width:K[0].toFixed(3),height:K[1].toFixed(3)})),j=Mt("svg",{viewBox:`${-Gp} 0 ${(K[0]+Gp).toFixed(3)} ${(K[1]+.26).toFixed(3)}`,class:"map",role:"group","aria-label":"map of the cell","data-test":"map"},Mt("defs",{},lt),Mt("g",{"clip-path":"url(#map-frame)"},m,F,N,g,x,y,Z),q.filter(($,ut)=>I(Xp(ut<H.length?Pn(H[ut]):n.zones[ut-H.length].polygon_m,r))),M,st);function pt($,ut){let ft=n.links.map((yt,Nt)=>{let{polygon:Ut,radius:te}=Lu($,n,$.contact_frame,Nt),ee=yt.name===ut||`${yt.robot}/${yt.name}`===ut?"hitting":null,we=Ut.map(u);if(te===0)return Mt("polygon",{points:h(Ut),class:ee});let[[ge,ke],[de,Ge]]=we;return Mt("line",{x1:ge,y1:ke,x2:ge===de&&ke===Ge?de+.001:de,y2:Ge,"stroke-width":2*te,class:ee})});g.replaceChildren(...ft,Mt("title",{},"robot at the contact of the selected hazard"))}let mt=!1;function St(){if(!mt){mt=!0;let $=i.replays.map(({id:ft})=>i.replay(ft)),ut=Bp($,n,r).map(({x:ft,y:yt,width:Nt,height:Ut})=>`M${(ft-o).toFixed(3)} ${(l-yt).toFixed(3)}h${Nt.toFixed(3)}v${(-Ut).toFixed(3)}h${(-Nt).toFixed(3)}z`);m.setAttribute("d",ut.join(""))}}new IntersectionObserver($=>$.some(ut=>ut.isIntersecting)&&St(),{rootMargin:"400px"}).observe(j),t.follow(({hazard:$,cause:ut})=>{let ft=i.hazard($),[yt,Nt]=u(qr.person(ft)),[Ut,te]=u(qr.contact(ft));y.replaceChildren(Mt("line",{x1:yt,y1:Nt,x2:Ut,y2:te}),Mt("circle",{cx:yt,cy:Nt,r:.09},Mt("title",{},`${$}: person`)),Mt("path",{d:`M ${Ut} ${te} m -0.06 -0.06 l 0.12 0.12 m 0 -0.12 l -0.12 0.12`},Mt("title",{},`${$}: contact`)));let ee=i.replay($)??i.replay(i.cause(ut).worst)??i.replay(i.replays[0]?.id);ee?pt(ee,ft.robot_link):g.replaceChildren()}),E();let bt=i.causes.slice(0,8).map($=>C("li",{},ks($),` ${$.sentence}`));return Tn("map","Where it happens",C("div",{class:"filters screen-only"},Wp("place","bins of",[["person","person"],["contact","contact"]],$=>(f=$,E())),Wp("colour","colour",[["cause","cause"],["count","number of hazards"],["ratio","worst ratio"]],$=>(p=$,E()))),j,C("p",{class:"map-line"},b," ",D),C("ul",{class:"map-key"},bt),C("p",{class:"note"},"Ring: the selected hazard's person; cross: its contact. Arrow: start. Blue: robot at that contact, and pale where robots go in the replays. Grey: obstacles. Dashed: sensor zones. Numbers: worst way of each cause."))}function Py({forces:[i,t],apart:e}){let n=(s,r)=>C("li",{class:r===t?"decides":null},s,r===t?C("b",{}," (decides)"):null);return C("div",{"data-test":"forces"},C("ul",{class:"plain-list"},i.map(n)),e?C("p",{class:"flag","data-test":"apart"},e):null)}function Iy([i,t,e]){return C("div",{"data-test":"forces"},C("p",{},C("b",{},i),` ${t}`,C("b",{}," (decides)")),e?C("p",{class:"note"},e):null)}function qp(i,t,e){let n=[];for(let r of i)n.at(-1)?.name===r?n.at(-1).times+=1:n.push({name:r,times:1});let s=({name:r,times:o})=>`${o>1?`${o} x `:""}${t.actions[r]}, ${+(o*e).toFixed(2)} s`;return C("ol",{class:"sequence"},n.map(r=>C("li",{},s(r))))}function Tl({scan:i,words:t},e,{short:n=!1}={}){let s=i.settings.action_s,r=t.hazards[e.id],o=e.shortest.actions.join()===e.actions.join(),[,a]=t.commands.replay,c=Zi([["what",r.what],["person",r.person],["begins",r.begins],["force",r.forces?Py(r):""],["broken",r.broken?Iy(r.broken):""],["how computed",n?"":r.computed],["arm",e.arm&&!n?t.arm:""],["way of the arm",r.through?.join(" ")],["sensors",r.sensors],["programme phase",e.phase===null||n?"":String(e.phase)],["found",n?"":r.found],["confirmed",`${t.confirmed}: ${r.row.at(-1)}`],["worst sequence",qp(e.actions,t,s)],["shortest way",n?"":[r.shortest,o?"":qp(e.shortest.actions,t,s)]],["replay it",n?"":[t.commands.replay[0],Os(`${a}${e.id}`)]]]);return n||c.setAttribute("data-test","facts"),c}var Yp=.35,Zp=1,Al=6,Ly={narrow:.034,wide:.021},Dy="(max-width: 640px)",Ny=.6,Qp=[{below:1,text:"head or throat touched: no contact is allowed",colour:"#fff3b8"},{below:1.25,text:"hit with up to 1.25 times the limit",colour:"#fed06b"},{below:1.5,text:"1.25 to 1.5 times",colour:"#fd8d3c"},{below:2,text:"1.5 to 2 times",colour:"#d7261e"},{below:1/0,text:"twice the limit and more",colour:"#7a0024"}],tm="not looked at to the end",em=({ground:i})=>i.unseen_m.length+i.watched_m.length>0,Jp=["#440154","#3b528b","#21918c","#5ec962","#d8e219"],Du=i=>Qp.find(({below:t})=>i<t),Uy=(i,t)=>`${(i*t*t).toFixed(i*t*t<.095?2:1)} m²`,Kp=i=>(Math.round(100*i)/100+0).toFixed(2),na=([i,t])=>`${Kp(i)}, ${Kp(t)} m`,jp=(i,t)=>`${Wn(i*t)} to ${Wn((i+1)*t)}`;function Fy(i){let t=i.map(c=>c.earliest_s),[e,n]=[Math.min(...t),Math.max(...t)],s=n-e<1e-9?1:Jp.length,r=c=>e+(n-e)*c/s,o=Array.from({length:s},(c,l)=>({text:s===1?Wn(e):`${Wn(r(l))} to ${Wn(r(l+1))}`,colour:Jp[l]}));return{classes:o,of:c=>o[Math.max(0,Math.min(s-1,Math.floor(s*(c-e)/(n-e||1))))]}}function Oy({cell:i,whole:t}){let e=(i.robots??[]).flatMap(l=>l.base_m?[l.base_m]:[]),n=l=>l.flatMap(([u,h,d,f])=>[[u,h],[d,f]]),s=[...t.floor.map(({xy_m:l})=>l),...t.open_m,...e,...n(t.ground.swept_m),...t.places.slice(0,Al).flatMap(l=>[l.xy_m,l.start_m])],r=[...s,...i.obstacles.flatMap(Pn),...i.zones.flatMap(l=>l.polygon_m)],o=l=>[0,1].map(u=>l.reduce(([h,d],f)=>[Math.min(h,f[u]),Math.max(d,f[u])],[1/0,-1/0])),[a,c]=[s.length>0?s:[i.start.xy_m],r.length>0?r:[i.start.xy_m]].map(o);return a.map(([l,u],h)=>[Math.max(c[h][0],l-Zp)-Yp,Math.min(c[h][1],u+Zp)+Yp])}function ky(i,t){let e=t.map(([n,s],r)=>[Math.max(n,Math.min(...i.map(o=>o[r]))),Math.min(s,Math.max(...i.map(o=>o[r])))]);return e.every(([n,s])=>n<=s)?e.map(([n,s])=>(n+s)/2):null}function nm(i,t){let{cell:e,whole:n,words:s}=i,r=n.cell_m,o=Oy(i),[[a,c],[l,u]]=o,h=[c-a,u-l],d=Ly[matchMedia(Dy).matches?"narrow":"wide"]*Math.max(h[0],.8*h[1],2),f=$=>Number($.toFixed(3)),p=([$,ut])=>[f($-a),f(u-ut)],x=$=>$.map(ut=>p(ut).join(",")).join(" "),m=$=>$.map(([ut,ft,yt,Nt])=>`M${p([ut,Nt]).join(" ")}h${f(yt-ut)}v${f(Nt-ft)}h${f(ut-yt)}z`).join(""),g=([$,ut],ft,yt=r)=>{let[Nt,Ut]=p([$-yt/2,ut+yt/2]);return Mt("rect",{x:Nt,y:Ut,width:f(yt),height:f(yt),...ft})},y=($,[ut,ft],yt)=>{let[Nt,Ut]=p([ut,ft]);return Mt("text",{x:Nt,y:Ut,class:`name ${yt}`,"font-size":f(d)},$)},M=n.floor.map($=>g($.xy_m,{class:"hit","data-test":"whole-square"},$.unseen?r:Ny*r)),b=g([0,0],{class:"cursor",visibility:"hidden"}),R=n.places.slice(0,Al),w=R.map($=>p($.xy_m)),_=.85*d,E=([$,ut])=>{let ft=[2.6,4,5.8,8].flatMap(Ut=>Array.from({length:12},(te,ee)=>[$+Ut*d*Math.cos(ee/1.91),ut-Ut*d*Math.sin(ee/1.91)])),yt=([Ut,te])=>Ut>_&&te>_&&Ut<h[0]-_&&te<h[1]-_&&w.every(([ee,we])=>Math.hypot(Ut-ee,te-we)>2.3*_),Nt=ft.find(yt)??[$,ut];return w.push(Nt),Nt},O=R.map(($,ut)=>{let[ft,yt]=p($.xy_m),[Nt,Ut]=p($.start_m),[te,ee]=E([ft,yt]),we=$.walks_in?[Mt("path",{class:"way",d:`M${Nt} ${Ut}L${ft} ${yt}`}),Mt("circle",{class:"from",cx:Nt,cy:Ut,r:f(.4*d)})]:[];return Mt("g",{class:"hit-place","data-test":"whole-place"},...we,Mt("path",{class:"lead",d:`M${f(te)} ${f(ee)}L${ft} ${yt}`}),Mt("circle",{class:"at",cx:ft,cy:yt,r:f(.25*d)}),Mt("circle",{class:"disc",cx:f(te),cy:f(ee),r:f(_)}),Mt("text",{x:f(te),y:f(ee+.37*d),"font-size":f(d)},String(ut+1)),Mt("title",{},Nu($,s)))}),D=(e.robots??[]).filter($=>$.base_m).map($=>{let[ut,ft]=p($.base_m),yt=f(.9*d);return Mt("g",{class:"base"},Mt("circle",{cx:ut,cy:ft,r:f(.6*d)}),Mt("path",{d:`M${ut-yt} ${ft}h${2*yt}M${ut} ${ft-yt}v${2*yt}`}),y($.name,[$.base_m[0],$.base_m[1]+1.3*d],"base-name"))}),I=e.obstacles.map($=>Mt("polygon",{points:x(Pn($)),class:"obstacle"},Mt("title",{},$.name))),G=e.zones.map($=>Mt($.polygon_m.length>2?"polygon":"polyline",{points:x($.polygon_m),class:`zone ${$.kind}`},Mt("title",{},$.title))),H=e.zones.flatMap($=>{let ut=ky($.polygon_m,o)&&[0,1].map(ft=>Math.max(o[ft][0],Math.min(...$.polygon_m.map(yt=>yt[ft])))+.4*d);return ut?[y($.title,ut,"zone-name")]:[]}),N=([$,ut])=>Array.from({length:Math.max(0,Math.floor(ut)-Math.ceil($)+1)},(ft,yt)=>Math.ceil($)+yt),F=f(.5*d),q=[Mt("path",{d:`M0 0V${f(h[1])}H${f(h[0])}`}),...N(o[0]).flatMap($=>[Mt("path",{d:`M${f($-a)} ${f(h[1])}v${F}`}),Mt("text",{x:f($-a),y:f(h[1]+1.6*d),"font-size":f(d)},`${$} m`)]),...N(o[1]).flatMap($=>[Mt("path",{d:`M0 ${f(u-$)}h${-F}`}),Mt("text",{x:f(-.8*d),y:f(u-$+.35*d),class:"left","font-size":f(d)},`${$} m`)])],[V,J]=[f(h[0]-1-d),f(h[1]-1.2*d)],Z=[Mt("path",{d:`M${V} ${f(J-.4*d)}v${f(.4*d)}h1v${f(-.4*d)}`}),Mt("text",{x:V+.5,y:f(J-.5*d),"font-size":f(d)},"1 m")],K={width:f(h[0]),height:f(h[1])},W=Mt("pattern",{id:`${t}-unknown`,width:.05,height:.05,patternUnits:"userSpaceOnUse",patternTransform:"rotate(45)"},Mt("rect",{width:.05,height:.05,class:"blank"}),Mt("rect",{width:.02,height:.05,class:"stripe"})),st=Mt("pattern",{id:`${t}-unlooked`,width:.08,height:.08,patternUnits:"userSpaceOnUse",patternTransform:"rotate(-45)"},Mt("rect",{width:.08,height:.08,class:"blank"}),Mt("rect",{width:.01,height:.08,class:"stripe"})),lt={style:`fill:url(#${t}-unlooked)`,"data-test":"whole-unlooked"},j=Mt("g",{class:"open",style:`fill:url(#${t}-unknown)`},...n.open_m.map($=>g($,{}))),pt=Mt("svg",{viewBox:[-4.2*d,-.3*d,h[0]+6*d,h[1]+2.6*d].map(f).join(" "),class:"whole-map",role:"img","aria-label":"the floor from above","data-test":"whole-map"},Mt("defs",{},W,st,Mt("clipPath",{id:`${t}-frame`},Mt("rect",K))),Mt("g",{"clip-path":`url(#${t}-frame)`},Mt("rect",em(n)?{...K,class:"nowhere"}:{...K,...lt}),Mt("path",{d:m(n.ground.unseen_m),class:"unseen"}),Mt("path",{d:m(n.ground.watched_m),class:"watched"}),n.not_looked_at_m.length>0?Mt("path",{d:m(n.not_looked_at_m),...lt}):null,Mt("path",{d:m(n.ground.swept_m),class:"swept"}),j,Mt("g",{class:"hits"},...M),G,I,D,H,b,Mt("g",{class:"scale-bar"},...Z)),...O,Mt("g",{class:"whole-ruler"},...q));return{element:pt,colour:$=>M.forEach((ut,ft)=>{let yt=$(n.floor[ft]);ut.setAttribute("style",yt===null?"":`fill:${yt}`),ut.classList.toggle("else",yt===null)}),point:$=>{if(b.setAttribute("visibility",$?"visible":"hidden"),$){let[ut,ft]=p([$[0]-r/2,$[1]+r/2]);b.setAttribute("x",ut),b.setAttribute("y",ft)}},under:$=>{let ut=pt.getScreenCTM()?.inverse(),{x:ft,y:yt}=new DOMPoint($.clientX,$.clientY).matrixTransform(ut);return[ft+a,u-yt]},bounds:o}}function Nu(i,t){let e=i.ratio<1?`${t.not_allowed} (${ds(i.ratio)})`:ds(i.ratio),n=typeof i.time_s=="number"?` after ${Wn(i.time_s)}`:"",s=i.walks_in?`walks from ${na(i.start_m)} to ${na(i.xy_m)}`:`stands at ${na(i.xy_m)}`;return`${e}: ${t.regions[i.body_region]} hit by ${i.robot_link}${n}; ${s}, ${i.posture}${i.confirmed?"":"; not confirmed"}`}var im=(i,t)=>C("li",{},C("span",{class:"surface",style:i}),C("span",{},t)),Ki=(i,t)=>C("li",{},C("span",{class:`surface ${i}`}),C("span",{},t));function sm({whole:i,cell:t}){return[i.floor.every(({unseen:e})=>e)?null:Ki("small","small: only who walks in, if they get there in time"),i.open_m.length>0?Ki("unknown","not known whether anybody is hit there"):null,i.looked_at?Ki("unseen","people come here unseen; no hit found"):Ki("unlooked",tm),i.looked_at&&i.ground.watched_m.length>0?Ki("watched","sensors see people here, or on the way here; no hit found"):null,em(i)?Ki("nowhere","nobody can stand here, or gets here"):null,i.ground.swept_m.length>0?Ki("swept","below what the robots sweep"):null,t.obstacles.length>0?Ki("obstacle","obstacle"):null,t.zones.length>0?Ki("zone","where sensors see"):null].filter(Boolean)}var rm="Colours tell the worst that was tried in each square; it may be worse.",By="A moment shows who is hit then of those who are hit at some moment. Others may be hit then where no colour is.";function om(i){let{whole:t,words:e}=i,n=nm(i,"whole-paper");return n.colour(s=>Du(s.ratio).colour),C("article",{"data-test":"print-whole",class:"whole-page"},C("h2",{},"The floor"),C("p",{},t.said),n.element,C("ul",{class:"whole-key"},am(t).map(({text:s,colour:r})=>im(`background:${r}`,s)),sm(i)),C("p",{class:"note"},rm),C("ol",{class:"whole-places"},t.places.slice(0,Al).map(s=>C("li",{},Nu(s,e)))))}var am=({floor:i})=>Qp.filter(({below:t})=>t>1||i.some(e=>e.ratio<1));function lm(i){let{whole:t,words:e}=i,n=t.cell_m,s=nm(i,"whole"),r=([F,q])=>[F,q].map(V=>Math.floor(V/n+1e-6)).join(","),o=new Map(t.floor.map(F=>[r(F.xy_m),F])),a=new Set(t.open_m.map(r)),c=Fy(t.floor),l=t.floor.flatMap(F=>F.spans.map(([q])=>q)),u=Math.max(Math.ceil(t.until_s/t.span_s-1e-6)-1,...l,0),h="worst",d=l.length>0?Math.min(...l):0,f=null,p=C("output",{"data-test":"whole-told",class:"told screen-only"}),x=C("ul",{class:"whole-key","data-test":"whole-key"}),m=C("p",{class:"note"}),g="Point at the floor, or touch it, to read a square; arrow keys move on.";function y(){let F=f&&o.get(r(f));if(!f)p.textContent=g;else if(F){let q=h==="moment"?F.spans.find(([J])=>J===d):null,V=h!=="moment"?"":q?`; now ${ds(q[1])}`:"; now no hit found";p.textContent=`${na(F.xy_m)}: up to ${ds(F.ratio)}, first at ${Wn(F.earliest_s)}${F.unseen?"":", only who walks in, if in time"}${V}`}else p.textContent=`${na(f)}: ${a.has(r(f))?"not known":t.looked_at?"no hit found":tm}`;s.point(f)}let M=C("input",{type:"range",min:0,max:u,step:1,value:d,"aria-label":"moment","data-test":"whole-slider",oninput:()=>(d=Number(M.value),_("moment"))}),b=C("output",{class:"whole-now","data-test":"whole-now"});function R(){let F=h==="moment",q=W=>W.spans.find(([st])=>st===d)?.[1],V={worst:W=>Du(W.ratio).colour,earliest:W=>c.of(W.earliest_s).colour,moment:W=>q(W)===void 0?null:Du(q(W)).colour};s.colour(V[h]);let Z=(h==="earliest"?c.classes:am(t)).map(({text:W,colour:st})=>im(`background:${st}`,h==="earliest"?`first hit at ${W}`:W));x.replaceChildren(...Z,...F?[Ki("else","hit at other moments")]:[],...sm(i)),M.setAttribute("aria-valuetext",jp(d,t.span_s));let K=t.floor.filter(W=>q(W)!==void 0).length;b.textContent=F?`${jp(d,t.span_s)}: ${K===0?"no hit found":`hits on ${Uy(K,n)}`}`:`0 to ${Wn(t.until_s)}`,m.textContent=F?By:h==="earliest"?"Colours tell the earliest moment, after the start, at which a hit was found in each square.":rm,y()}let w=[["worst","how hard"],["earliest","how early"],...t.followed&&l.length>0?[["moment","at one moment"]]:[]].map(([F,q],V)=>{let J=C("input",{type:"radio",name:"whole",value:F,checked:V===0,"data-test":`whole-${F}`,onchange:()=>_(F)});return[F,J,C("label",{},J,` ${q}`)]});function _(F){h=F,w.forEach(([q,V])=>V.checked=q===F),R()}let{element:E,bounds:O}=s,D=F=>F.every((q,V)=>q>=O[V][0]&&q<=O[V][1]),I=F=>{f=F&&D(F)?F.map(q=>(Math.floor(q/n+1e-6)+.5)*n):null,y()};["pointermove","pointerdown"].forEach(F=>E.addEventListener(F,q=>I(s.under(q)))),E.addEventListener("pointerleave",F=>F.pointerType==="mouse"&&I(null)),E.setAttribute("tabindex","0"),E.addEventListener("keydown",F=>{let q={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[F.key];if(q){F.preventDefault(),F.stopPropagation();let V=t.floor.reduce((Z,K)=>K.ratio>Z.ratio?K:Z,t.floor[0]),J=f?f.map((Z,K)=>Z+q[K]*n):V?.xy_m??O.map(([Z,K])=>(Z+K)/2);D(J)&&I(J)}});let G=(F,q)=>F.id&&i.hazard(F.id)?C("a",{href:`#${F.id}`},q):q,H=t.places.slice(0,Al).map(F=>C("li",{onmouseenter:()=>I(F.xy_m),onmouseleave:()=>I(null)},G(F,Nu(F,e)))),N=t.places.length-H.length;return R(),Tn("whole","The floor",C("p",{class:"whole-head","data-test":"whole-head"},t.said),C("div",{class:"filters screen-only"},t.floor.length>0?C("fieldset",{},C("legend",{},"colour"),w.map(([,,F])=>F)):null,t.followed&&l.length>0?C("span",{class:"whole-time"},M,b):null),C("div",{class:"whole"},C("div",{},E,p),C("div",{},x,m,H.length>0?C("h3",{},"Worst ways to be hit"):null,C("ol",{class:"whole-places"},H),N>0?C("p",{class:"note"},`And ${an(N,"way")} more, less bad or not confirmed.`):null)))}var Uu=8,cm=(i,t,e)=>C("table",{class:`plain ${e}`},C("thead",{},C("tr",{},i.map(n=>C("th",{scope:"col"},n)))),C("tbody",{},t.map(n=>C("tr",{},n.map(s=>C("td",{},s))))));function zy(i,t){let{scan:e,words:n,cell:s}=i,{says:r,covers:o}=e.headline,a=i.causes.map(c=>[ks(c),c.sentence,n.causes[c.id].severity[0],Vy(c,n),t.ofCause(c.id),lr(t.of(c.id))??"–"]);return C("article",{class:"first","data-test":"print-first"},C("p",{class:"kicker"},`${e.tool} · hazard report`),C("h1",{},s.name),C("p",{class:"verdict"},r),C("p",{},o),C("h3",{},"Causes, worst first"),cm(["","cause","worst","what to change","decision","PL r"],a,"causes"),C("h3",{},"What the search covered"),Zi([["cell file",[e.subject.cell_found,"; SHA-256 ",C("code",{},e.subject.cell_sha256)]],["FMU",e.subject.fmus.flatMap((c,l)=>[l>0?"; ":"",`${c.unit?`${c.unit}: `:""}${c.model_name}; SHA-256 `,C("code",{},c.sha256)])],["made again by",C("code",{},i.reproduce)]]),C("h3",{},"Assessed by"),C("div",{class:"sign"},["Name","Date","Signature"].map(c=>C("p",{},c))),C("p",{class:"note"},n.hazard_is))}var Vy=({id:i,advice:t},e)=>t?.changes[0]?.change??e.causes[i].no_change;function Gy(i,t,e){let{words:n}=i,s=i.hazard(t.worst),r=n.causes[t.id],[o,a]=r.severity,c=wl(t,n);c.mark(s.body_region);let l=i.topView(t.worst),u=e.of(t.id),h=t.hazards.filter(f=>e.own(f)!==null),d=t.lines.map(({robot_link:f,hazards:p},x)=>{let[m,g]=r.lines[x];return[m,f,g,String(p.length)]});return C("article",{"data-test":"print-cause","data-id":t.id},C("h2",{},ks(t),` ${t.sentence}`),C("p",{class:"severity"},C("b",{},o),` ${a}`),wu(r),C("p",{},[...Su(r).map(([,f])=>f),t.id].join(" · ")),C("div",{class:"print-pictures"},l?Ml(l):C("p",{class:"note"},"This report carries no drawing of its worst way."),c.element),C("div",{class:"print-columns"},C("div",{},Eu(t,n)),C("div",{},C("h4",{},"Assessment (ISO 12100)"),Zi([...Wr.map(({key:f,label:p})=>[p.split(":")[0].toLowerCase(),f==="decision"?e.ofCause(t.id):u[f]]),["PL r",lr(u)??""],["decided apart",h.map(f=>`${f}: ${e.own(f)}`).join(", ")]]))),C("h4",{},`Its worst way, ${t.worst}`),Tl(i,s,{short:!0}),C("h4",{},"Ways by region and link"),cm(["body region","hit by","worst","ways"],d.slice(0,Uu),"lines"),d.length>Uu?C("p",{class:"note"},`And ${an(d.length-Uu,"other pair")} of region and link, less bad; scan.json has them all.`):null)}function hm(i,t){let e=C("section",{class:"print-only",id:"print"});return addEventListener("beforeprint",()=>e.replaceChildren(zy(i,t),...i.whole?[om(i)]:[],...i.causes.map(n=>Gy(i,n,t)))),addEventListener("afterprint",()=>e.replaceChildren()),e}var um=i=>C("code",{class:"hash"},i);function Hy({subject:i,tool:t}){let e=i.fmus.map(s=>[s.unit?`FMU ${s.unit}`:"FMU",[`${s.model_name}, FMI ${s.fmi_version}, by ${s.generation_tool||"an unnamed tool"}; SHA-256 `,um(s.sha256)]]),n=[["tool",t],["cell",i.cell],["cell file",[`${i.cell_found}; SHA-256 `,um(i.cell_sha256)]],...e];return C("div",{},C("h3",{},"Subject"),C("dl",{},n.map(([s,r])=>C("div",{},C("dt",{},s),C("dd",{},r)))),i.couplings.length>0?C("ul",{},i.couplings.map(s=>C("li",{},s))):null)}var Wy=i=>[C("h3",{},"Settings"),Zi(i)],Xy=i=>[C("h3",{},"Self-test of the FMU"),C("p",{class:"note"},"Whether runs repeat exactly, and what saved states, reset and copies are worth."),Zi(i)];function $y({tables:i},t){let e=i.map(n=>C("tr",{},C("td",{},n.title),C("td",{},n.verified?"verified":"not verified"),C("td",{},n.source),C("td",{},n.confidence)));return C("div",{},C("h3",{},"Limits and tables"),C("p",{},t),C("div",{class:"scroll",tabindex:0},C("table",{class:"plain"},C("thead",{},C("tr",{},["table","state","source","confidence"].map(n=>C("th",{scope:"col"},n)))),C("tbody",{},e))))}function dm({scan:i,words:t,assumptions:e,reproduce:n}){return Tn("provenance","Subject and settings",C("div",{class:"columns"},Hy(i),C("div",{},Wy(t.settings)),C("div",{},Xy(t.self_test))),$y(i,t.limits),C("h3",{},"Assumptions"),C("ul",{class:"assumptions","data-test":"assumptions"},e.map(s=>C("li",{},s))),C("h3",{},"Reproduce"),C("p",{class:"note"},t.commands.replay[0]),Os(n),C("p",{class:"note"},"This page carries three.js (MIT licence, © three.js authors) and uPlot (MIT licence, © 2022 Leon Sorokin); the full texts are at the end of its script."))}function qy(i,t){let e=[...i.keys()].filter(n=>n>0&&i[n]<.01&&i[n-1]>=.01);return e.find(n=>n>=t)??e[0]??-1}function fm(i,t,e){let n=e.hazards[t.id],s=i.sensors.map(({name:c,detected:l})=>({frame:l.indexOf("1"),kind:"sensor",text:`${c} ${e.people.begins}`})).filter(({frame:c})=>c>=0),r=s.length>0?Math.min(...s.map(({frame:c})=>c)):0,o=qy(i.speed_m_s,r);return[...(t.worked??[]).map(({at_s:c},l)=>({frame:Math.round(c/i.step),kind:"press",text:n.worked[l]})),...s,{frame:i.contact_frame,kind:"contact",text:n.event},...o>=0?[{frame:o,kind:"rest",text:n.rests}]:[]].sort((c,l)=>c.frame-l.frame)}function pm(){let i=[],t=1,e=1,n=0,s=.5,r=!1,o=null,a=()=>i.forEach(u=>u({frame:n,playing:r}));function c(u){if(!r)return;o??={now:u,frame:n};let h=o.frame+Math.floor((u-o.now)/1e3*(s/e));h!==n&&(n=Math.min(h,t-1),r=n<t-1,a()),requestAnimationFrame(c)}let l={get frame(){return n},get playing(){return r},load(u,h,d){[t,e]=[u,h],l.seek(d)},seek(u){n=Math.max(0,Math.min(t-1,Math.round(u))),r=!1,a()},pause(){r=!1,a()},toggle(){r=!r,o=null,r&&(n=n>=t-1?0:n,requestAnimationFrame(c)),a()},setSpeed(u){s=u,o=null},follow:u=>i.push(u)};return l}var Yy="uplot",Zy="u-hz",Jy="u-vt",Ky="u-title",jy="u-wrap",Qy="u-under",tv="u-over",ev="u-axis",mr="u-off",nv="u-select",iv="u-cursor-x",sv="u-cursor-y",rv="u-cursor-pt",ov="u-legend",av="u-live",lv="u-inline",cv="u-series",hv="u-marker",mm="u-label",uv="u-value",sa="width",ra="height";var gm="bottom",Yr="left",Fu="right",Qu="#000",_m=Qu+"0",Ou="mousemove",xm="mousedown",ku="mouseup",ym="mouseenter",vm="mouseleave",bm="dblclick",dv="resize",fv="scroll",Mm="change",Ll="dppxchange",td="--",eo=typeof window<"u",Hu=eo?document:null,Jr=eo?window:null,pv=eo?navigator:null,Ce,Cl;function Wu(){let i=devicePixelRatio;Ce!=i&&(Ce=i,Cl&&$u(Mm,Cl,Wu),Cl=matchMedia(`(min-resolution: ${Ce-.001}dppx) and (max-resolution: ${Ce+.001}dppx)`),gr(Mm,Cl,Wu),Jr.dispatchEvent(new CustomEvent(Ll)))}function si(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Xu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function qe(i,t,e){i.style[t]=e+"px"}function Ai(i,t,e,n){let s=Hu.createElement(i);return t!=null&&si(s,t),e?.insertBefore(s,n),s}function xi(i,t){return Ai("div",i,t)}var Sm=new WeakMap;function ji(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Sm.get(i);r!=o&&(i.style.transform=r,Sm.set(i,r),t<0||e<0||t>n||e>s?si(i,mr):Xu(i,mr))}var wm=new WeakMap;function Em(i,t,e){let n=t+e,s=wm.get(i);n!=s&&(wm.set(i,n),i.style.background=t,i.style.borderColor=e)}var Tm=new WeakMap;function Am(i,t,e,n){let s=t+""+e,r=Tm.get(i);s!=r&&(Tm.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var ed={passive:!0},mv={...ed,capture:!0};function gr(i,t,e,n){t.addEventListener(i,e,n?mv:ed)}function $u(i,t,e,n){t.removeEventListener(i,e,ed)}eo&&Wu();function Ci(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ri((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function eg(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var ng=i=>i!=null,ig=i=>i!=null&&i>0,Ul=eg(ng),gv=eg(ig);function _v(i,t,e,n=0,s=!1){let r=s?gv:Ul,o=s?ig:ng;[t,e]=r(i,t,e);let a=i[t],c=i[t];if(t>-1)if(n==1)a=i[t],c=i[e];else if(n==-1)a=i[e],c=i[t];else for(let l=t;l<=e;l++){let u=i[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??ze,c??-ze]}function Fl(i,t,e,n){let s=Pm(i),r=Pm(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ps:sg,a=s==1?ri:yi,c=r==1?yi:ri,l=a(o(xn(i))),u=c(o(xn(t))),h=Kr(e,l),d=Kr(e,u);return e==10&&(l<0&&(h=Ve(h,-l)),u<0&&(d=Ve(d,-u))),n||e==2?(i=h*s,t=d*r):(i=lg(i,h),t=Ol(t,d)),[i,t]}function nd(i,t,e,n){let s=Fl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var id=.1,Cm={mode:3,pad:id},aa={pad:0,soft:null,mode:0},xv={min:aa,max:aa};function Dl(i,t,e,n){return kl(e)?Rm(i,t,e):(aa.pad=e,aa.soft=n?0:null,aa.mode=n?3:0,Rm(i,t,xv))}function Te(i,t){return i??t}function yv(i,t,e){for(t=Te(t,0),e=Te(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Rm(i,t,e){let n=e.min,s=e.max,r=Te(n.pad,0),o=Te(s.pad,0),a=Te(n.hard,-ze),c=Te(s.hard,ze),l=Te(n.soft,ze),u=Te(s.soft,-ze),h=Te(n.mode,0),d=Te(s.mode,0),f=t-i,p=ps(f),x=Xn(xn(i),xn(t)),m=ps(x),g=xn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||t==0)&&(f=1e-24,h==2&&l!=ze&&(r=0),d==2&&u!=-ze&&(o=0)));let y=f||x||1e3,M=ps(y),b=Kr(10,ri(M)),R=y*(f==0?i==0?.1:1:r),w=Ve(lg(i-R,b/10),24),_=i>=l&&(h==1||h==3&&w<=l||h==2&&w>=l)?l:ze,E=Xn(a,w<_&&i>=_?_:Ri(_,w)),O=y*(f==0?t==0?.1:1:o),D=Ve(Ol(t+O,b/10),24),I=t<=u&&(d==1||d==3&&D>=u||d==2&&D<=u)?u:-ze,G=Ri(c,D>I&&t<=I?I:Xn(I,D));return E==G&&E==0&&(G=100),[E,G]}var vv=new Intl.NumberFormat(eo?pv.language:"en-US"),sd=i=>vv.format(i),oi=Math,Il=oi.PI,xn=oi.abs,ri=oi.floor,_n=oi.round,yi=oi.ceil,Ri=oi.min,Xn=oi.max,Kr=oi.pow,Pm=oi.sign,ps=oi.log10,sg=oi.log2,bv=(i,t=1)=>oi.sinh(i)*t,Bu=(i,t=1)=>oi.asinh(i/t),ze=1/0;function Im(i){return(ps((i^i>>31)-(i>>31))|0)+1}function qu(i,t,e){return Ri(Xn(i,t),e)}function rg(i){return typeof i=="function"}function Me(i){return rg(i)?i:()=>i}var Mv=()=>{},og=i=>i,ag=(i,t)=>t,Sv=i=>null,Lm=i=>!0,Dm=(i,t)=>i==t,wv=/\.\d*?(?=9{6,}|0{6,})/gm,_r=i=>{if(hg(i)||Vs.has(i))return i;let t=`${i}`,e=t.match(wv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${_r(s)}e${r}`}return Ve(i,n)};function fr(i,t){return _r(Ve(_r(i/t))*t)}function Ol(i,t){return _r(yi(_r(i/t))*t)}function lg(i,t){return _r(ri(_r(i/t))*t)}function Ve(i,t=0){if(hg(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return _n(n)/e}var Vs=new Map;function cg(i){return((""+i).split(".")[1]||"").length}function ca(i,t,e,n){let s=[],r=n.map(cg);for(let o=t;o<e;o++){let a=xn(o),c=Ve(Kr(i,o),a);for(let l=0;l<n.length;l++){let u=i==10?+`${n[l]}e${o}`:n[l]*c,h=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=i==10?u:Ve(u,h);s.push(d),Vs.set(d,h)}}return s}var la={},rd=[],jr=[null,null],zs=Array.isArray,hg=Number.isInteger,Ev=i=>i===void 0;function Nm(i){return typeof i=="string"}function kl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Tv(i){return i!=null&&typeof i=="object"}var Av=Object.getPrototypeOf(Uint8Array),ug="__proto__";function Qr(i,t=kl){let e;if(zs(i)){let n=i.find(s=>s!=null);if(zs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Qr(i[s],t)}else e=i.slice()}else if(i instanceof Av)e=i.slice();else if(t(i)){e={};for(let n in i)n!=ug&&(e[n]=Qr(i[n],t))}else e=i;return e}function pn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=ug&&(kl(i[s])?pn(i[s],Qr(n[s])):i[s]=Qr(n[s]))}return i}var Cv=0,Rv=1,Pv=2;function Iv(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Lv(i,t){if(Uv(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Fv(o[0])||(o=Nv(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let u=0;u<l;u++)e.add(c[u])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],h=Array(s).fill(void 0),d=t?t[o][l]:Rv,f=[];for(let p=0;p<u.length;p++){let x=u[p],m=r.get(c[p]);x===null?d!=Cv&&(h[m]=x,d==Pv&&f.push(m)):h[m]=x}Iv(h,f,s),n.push(h)}}return n}var Dv=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Nv(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[n[c]];s.push(a)}return s}function Uv(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Fv(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Xn(1,ri((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var dg=["January","February","March","April","May","June","July","August","September","October","November","December"],fg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function pg(i){return i.slice(0,3)}var Ov=fg.map(pg),kv=dg.map(pg),Bv={MMMM:dg,MMM:kv,WWWW:fg,WWW:Ov};function ia(i){return(i<10?"0":"")+i}function zv(i){return(i<10?"00":i<100?"0":"")+i}var Vv={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>ia(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ia(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>ia(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ia(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ia(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>zv(i.getMilliseconds())};function od(i,t){t=t||Bv;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Vv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Gv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Hv(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Gv?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var mg=i=>i%1==0,Nl=[1,2,2.5,5],Wv=ca(10,-32,0,Nl),gg=ca(10,0,32,Nl),Xv=gg.filter(mg),pr=Wv.concat(gg),ad=`
`,_g="{YYYY}",Um=ad+_g,xg="{M}/{D}",oa=ad+xg,Rl=oa+"/{YY}",yg="{aa}",$v="{h}:{mm}",Zr=$v+yg,Fm=ad+Zr,Om=":{ss}",Pe=null;function vg(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,c=(i==1?ca(10,0,3,Nl).filter(mg):ca(10,-3,0,Nl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,_g,Pe,Pe,Pe,Pe,Pe,Pe,1],[s*28,"{MMM}",Um,Pe,Pe,Pe,Pe,Pe,1],[s,xg,Um,Pe,Pe,Pe,Pe,Pe,1],[n,"{h}"+yg,Rl,Pe,oa,Pe,Pe,Pe,1],[e,Zr,Rl,Pe,oa,Pe,Pe,Pe,1],[t,Om,Rl+" "+Zr,Pe,oa+" "+Zr,Pe,Fm,Pe,1],[i,Om+".{fff}",Rl+" "+Zr,Pe,oa+" "+Zr,Pe,Fm,Pe,1]];function u(h){return(d,f,p,x,m,g)=>{let y=[],M=m>=o,b=m>=r&&m<o,R=h(p),w=Ve(R*i,3),_=zu(R.getFullYear(),M?0:R.getMonth(),b||M?1:R.getDate()),E=Ve(_*i,3);if(b||M){let O=b?m/r:0,D=M?m/o:0,I=w==E?w:Ve(zu(_.getFullYear()+D,_.getMonth()+O,1)*i,3),G=new Date(_n(I/i)),H=G.getFullYear(),N=G.getMonth();for(let F=0;I<=x;F++){let q=zu(H+D*F,N+O*F,1),V=q-h(Ve(q*i,3));I=Ve((+q+V)*i,3),I<=x&&y.push(I)}}else{let O=m>=s?s:m,D=ri(p)-ri(w),I=E+D+Ol(w-E,O);y.push(I);let G=h(I),H=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,N=m/n,F=d.axes[f]._space,q=g/F;for(;I=Ve(I+m,i==1?0:3),!(I>x);)if(N>1){let V=ri(Ve(H+N,6))%24,K=h(I).getHours()-V;K>1&&(K=-1),I-=K*n,H=(H+N)%24;let W=y[y.length-1];Ve((I-W)/m,3)*q>=.7&&y.push(I)}else y.push(I)}return y}}return[c,l,u]}var[qv,Yv,Zv]=vg(1),[Jv,Kv,jv]=vg(.001);ca(2,-53,53,[1]);function km(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Bm(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],c,l,u,h,d,f;return n.map(p=>{let x=i(p),m=x.getFullYear(),g=x.getMonth(),y=x.getDate(),M=x.getHours(),b=x.getMinutes(),R=x.getSeconds(),w=m!=c&&a[2]||g!=l&&a[3]||y!=u&&a[4]||M!=h&&a[5]||b!=d&&a[6]||R!=f&&a[7]||a[1];return c=m,l=g,u=y,h=M,d=b,f=R,w(x)})}}function Qv(i,t){let e=od(t);return(n,s,r,o,a)=>s.map(c=>e(i(c)))}function zu(i,t,e){return new Date(i,t,e)}function zm(i,t){return t(i)}var tb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vm(i,t){return(e,n,s,r)=>r==null?td:t(i(n))}function eb(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function nb(i,t){return i.series[t].fill(i,t)}var ib={show:!0,live:!0,isolate:!1,mount:Mv,markers:{show:!0,width:2,stroke:eb,fill:nb,dash:"solid"},idx:null,idxs:null,values:[]};function sb(i,t){let e=i.cursor.points,n=xi(),s=e.size(i,t);qe(n,sa,s),qe(n,ra,s);let r=s/-2;qe(n,"marginLeft",r),qe(n,"marginTop",r);let o=e.width(i,t,s);return o&&qe(n,"borderWidth",o),n}function rb(i,t){let e=i.series[t].points;return e._fill||e._stroke}function ob(i,t){let e=i.series[t].points;return e._stroke||e._fill}function ab(i,t){return i.series[t].points.size}var Vu=[0,0];function lb(i,t,e){return Vu[0]=t,Vu[1]=e,Vu}function Pl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Gu(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var cb={show:!0,x:!0,y:!0,lock:!1,move:lb,points:{one:!1,show:sb,size:ab,width:0,stroke:ob,fill:rb},bind:{mousedown:Pl,mouseup:Pl,click:Pl,dblclick:Pl,mousemove:Gu,mouseleave:Gu,mouseenter:Gu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},bg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ld=pn({},bg,{filter:ag}),Mg=pn({},ld,{size:10}),Sg=pn({},bg,{show:!1}),cd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wg="bold "+cd,Eg=1.5,Gm={show:!0,scale:"x",stroke:Qu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wg,side:2,grid:ld,ticks:Mg,border:Sg,font:cd,lineGap:Eg,rotate:0},hb="Value",ub="Time",Hm={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function db(i,t,e,n,s){return t.map(r=>r==null?"":sd(r))}function fb(i,t,e,n,s,r,o){let a=[],c=Vs.get(s)||0;e=o?e:Ve(Ol(e,s),c);for(let l=e;l<=n;l=Ve(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Yu(i,t,e,n,s,r,o){let a=[],c=i.scales[i.axes[t].scale].log,l=c==10?ps:sg,u=ri(l(e));s=Kr(c,u),c==10&&(s=pr[Ci(s,pr)]);let h=e,d=s*c;c==10&&(d=pr[Ci(d,pr)]);do a.push(h),h=h+s,c==10&&!Vs.has(h)&&(h=Ve(h,Vs.get(s))),h>=d&&(s=h,d=s*c,c==10&&(d=pr[Ci(d,pr)]));while(h<=n);return a}function pb(i,t,e,n,s,r,o){let c=i.scales[i.axes[t].scale].asinh,l=n>c?Yu(i,t,Xn(c,e),n,s):[c],u=n>=0&&e<=0?[0]:[];return(e<-c?Yu(i,t,Xn(c,-n),-e,s):[c]).reverse().map(d=>-d).concat(u,l)}var Tg=/./,mb=/[12357]/,gb=/[125]/,Wm=/1/,Zu=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function _b(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,u=c(10,o),h=c(9,o)-u>=l?Tg:c(7,o)-u>=l?mb:c(5,o)-u>=l?gb:Wm;if(h==Wm){let d=xn(c(1,o)-u);if(d<l)return Zu(t.slice().reverse(),a.distr,h,yi(l/d)).reverse()}return Zu(t,a.distr,h,1)}function xb(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,c=i.valToPos,l=xn(c(1,o)-c(2,o));return l<a?Zu(t.slice().reverse(),3,Tg,yi(a/l)).reverse():t}function yb(i,t,e,n){return n==null?td:t==null?"":sd(t)}var Xm={show:!0,scale:"y",stroke:Qu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wg,side:3,grid:ld,ticks:Mg,border:Sg,font:cd,lineGap:Eg,rotate:0};function vb(i,t){let e=3+(i||1)*2;return Ve(e*t,3)}function bb(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=xn(o-r),c=i.series[t],l=a/(c.points.space*Ce);return n[1]-n[0]<=l}var $m={scale:null,auto:!0,sorted:0,min:ze,max:-ze},Ag=(i,t,e,n,s)=>s,qm={show:!0,auto:!0,sorted:0,gaps:Ag,alpha:1,facets:[pn({},$m,{scale:"x"}),pn({},$m,{scale:"y"})]},Ym={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ag,alpha:1,points:{show:bb,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function Mb(i,t,e,n,s){return e/10}var Cg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Sb=pn({},Cg,{time:!1,ori:1}),Zm={};function Rg(i,t){let e=Zm[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,c,l)}},i!=null&&(Zm[i]=e)),e}var to=1,Ju=2;function xr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,m=i.valToPosH,g=i.valToPosV;return u.ori==0?e(s,c,l,u,h,m,g,d,f,p,x,zl,no,Gl,Ig,Dg):e(s,c,l,u,h,g,m,f,d,x,p,Vl,io,dd,Lg,Ng)}function hd(i,t){let e=0,n=0,s=Te(i.bands,rd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function wb(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ms(i,t,e,n,s,r){return xr(i,t,(o,a,c,l,u,h,d,f,p,x,m)=>{let g=o.pxRound,y=l.dir*(l.ori==0?1:-1),M=l.ori==0?no:io,b,R;y==1?(b=e,R=n):(b=n,R=e);let w=g(h(a[b],l,x,f)),_=g(d(c[b],u,m,p)),E=g(h(a[R],l,x,f)),O=g(d(r==1?u.max:u.min,u,m,p)),D=new Path2D(s);return M(D,E,O),M(D,w,O),M(D,w,_),D})}function Bl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Gl:dd,c=e;for(let h=0;h<i.length;h++){let d=i[h];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,n,f,n+r),c=d[1]}}let l=e+s-c,u=10;l>0&&a(o,c,n-u/2,l,n+r+u)}return o}function Eb(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function ud(i,t,e,n,s,r,o){let a=[],c=i.length;for(let l=s==1?e:n;l>=e&&l<=n;l+=s)if(t[l]===null){let h=l,d=l;if(s==1)for(;++l<=n&&t[l]===null;)d=l;else for(;--l>=e&&t[l]===null;)d=l;let f=r(i[h]),p=d==h?f:r(i[d]),x=h-s;f=o<=0&&x>=0&&x<c?r(i[x]):f;let g=d+s;p=o>=0&&g>=0&&g<c?r(i[g]):p,p>=f&&a.push([f,p])}return a}function Jm(i){return i==0?og:i==1?_n:t=>fr(t,i)}function Pg(i){let t=i==0?zl:Vl,e=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?n(s,r,o,a,c):(l=Ri(l,a/2,c/2),u=Ri(u,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,u),e(s,r,o+c,r,o,u),e(s,r,o,r+a,o,l),s.closePath())}}var zl=(i,t,e)=>{i.moveTo(t,e)},Vl=(i,t,e)=>{i.moveTo(e,t)},no=(i,t,e)=>{i.lineTo(t,e)},io=(i,t,e)=>{i.lineTo(e,t)},Gl=Pg(0),dd=Pg(1),Ig=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Lg=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Dg=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Ng=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Ug(i){return(t,e,n,s,r)=>xr(t,e,(o,a,c,l,u,h,d,f,p,x,m)=>{let{pxRound:g,points:y}=o,M,b;l.ori==0?(M=zl,b=Ig):(M=Vl,b=Lg);let R=Ve(y.width*Ce,3),w=(y.size-y.width)/2*Ce,_=Ve(w*2,3),E=new Path2D,O=new Path2D,{left:D,top:I,width:G,height:H}=t.bbox;Gl(O,D-_,I-_,G+_*2,H+_*2);let N=F=>{if(c[F]!=null){let q=g(h(a[F],l,x,f)),V=g(d(c[F],u,m,p));M(E,q+w,V),b(E,q,V,w,0,Il*2)}};if(r)r.forEach(N);else for(let F=n;F<=s;F++)N(F);return{stroke:R>0?E:null,fill:E,clip:O,flags:to|Ju}})}function Fg(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Tb=Fg(no),Ab=Fg(io);function Og(i){let t=Te(i?.alignGaps,0);return(e,n,s,r)=>xr(e,n,(o,a,c,l,u,h,d,f,p,x,m)=>{[s,r]=Ul(c,s,r);let g=o.pxRound,y=H=>g(h(H,l,x,f)),M=H=>g(d(H,u,m,p)),b,R;l.ori==0?(b=no,R=Tb):(b=io,R=Ab);let w=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:to},E=_.stroke,O=!1;if(r-s>=x*4){let H=lt=>e.posToVal(lt,l.key,!0),N=null,F=null,q,V,J,Z=y(a[w==1?s:r]),K=y(a[s]),W=y(a[r]),st=H(w==1?K+1:W-1);for(let lt=w==1?s:r;lt>=s&&lt<=r;lt+=w){let j=a[lt],mt=(w==1?j<st:j>st)?Z:y(j),St=c[lt];mt==Z?St!=null?(V=St,N==null?(b(E,mt,M(V)),q=N=F=V):V<N?N=V:V>F&&(F=V)):St===null&&(O=!0):(N!=null&&R(E,Z,M(N),M(F),M(q),M(V)),St!=null?(V=St,b(E,mt,M(V)),N=F=q=V):(N=F=null,St===null&&(O=!0)),Z=mt,st=H(Z+w))}N!=null&&N!=F&&J!=Z&&R(E,Z,M(N),M(F),M(q),M(V))}else for(let H=w==1?s:r;H>=s&&H<=r;H+=w){let N=c[H];N===null?O=!0:N!=null&&b(E,y(a[H]),M(N))}let[I,G]=hd(e,n);if(o.fill!=null||I!=0){let H=_.fill=new Path2D(E),N=o.fillTo(e,n,o.min,o.max,I),F=M(N),q=y(a[s]),V=y(a[r]);w==-1&&([V,q]=[q,V]),b(H,V,F),b(H,q,F)}if(!o.spanGaps){let H=[];O&&H.push(...ud(a,c,s,r,w,y,t)),_.gaps=H=o.gaps(e,n,s,r,H),_.clip=Bl(H,l.ori,f,p,x,m)}return G!=0&&(_.band=G==2?[ms(e,n,s,r,E,-1),ms(e,n,s,r,E,1)]:ms(e,n,s,r,E,G)),_})}function Cb(i){let t=Te(i.align,1),e=Te(i.ascDesc,!1),n=Te(i.alignGaps,0),s=Te(i.extend,!1);return(r,o,a,c)=>xr(r,o,(l,u,h,d,f,p,x,m,g,y,M)=>{[a,c]=Ul(h,a,c);let b=l.pxRound,{left:R,width:w}=r.bbox,_=K=>b(p(K,d,y,m)),E=K=>b(x(K,f,M,g)),O=d.ori==0?no:io,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:to},I=D.stroke,G=d.dir*(d.ori==0?1:-1),H=E(h[G==1?a:c]),N=_(u[G==1?a:c]),F=N,q=N;s&&t==-1&&(q=R,O(I,q,H)),O(I,N,H);for(let K=G==1?a:c;K>=a&&K<=c;K+=G){let W=h[K];if(W==null)continue;let st=_(u[K]),lt=E(W);t==1?O(I,st,H):O(I,F,lt),O(I,st,lt),H=lt,F=st}let V=F;s&&t==1&&(V=R+w,O(I,V,H));let[J,Z]=hd(r,o);if(l.fill!=null||J!=0){let K=D.fill=new Path2D(I),W=l.fillTo(r,o,l.min,l.max,J),st=E(W);O(K,V,st),O(K,q,st)}if(!l.spanGaps){let K=[];K.push(...ud(u,h,a,c,G,_,n));let W=l.width*Ce/2,st=e||t==1?W:-W,lt=e||t==-1?-W:W;K.forEach(j=>{j[0]+=st,j[1]+=lt}),D.gaps=K=l.gaps(r,o,a,c,K),D.clip=Bl(K,d.ori,m,g,y,M)}return Z!=0&&(D.band=Z==2?[ms(r,o,a,c,I,-1),ms(r,o,a,c,I,1)]:ms(r,o,a,c,I,Z)),D})}function Km(i,t,e,n,s,r,o=ze){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(t[c]!==void 0){if(a!=null){let u=xn(i[c]-i[a]);u<l&&(l=u,o=xn(e(i[c],n,s,r)-e(i[a],n,s,r)))}a=c}}return o}function Rb(i){i=i||la;let t=Te(i.size,[.6,ze,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),o=1-t[0],a=Te(t[1],ze),c=Te(t[2],1),l=Te(i.disp,la),u=Te(i.each,f=>{}),{fill:h,stroke:d}=l;return(f,p,x,m)=>xr(f,p,(g,y,M,b,R,w,_,E,O,D,I)=>{let G=g.pxRound,H=e,N=n*Ce,F=a*Ce,q=c*Ce,V,J;b.ori==0?[V,J]=r(f,p):[J,V]=r(f,p);let Z=b.dir*(b.ori==0?1:-1),K=b.ori==0?Gl:dd,W=b.ori==0?u:(Rt,Qt,ue,Pt,Be,Yt,Kt)=>{u(Rt,Qt,ue,Be,Pt,Kt,Yt)},st=Te(f.bands,rd).find(Rt=>Rt.series[0]==p),lt=st!=null?st.dir:0,j=g.fillTo(f,p,g.min,g.max,lt),pt=G(_(j,R,I,O)),mt,St,bt,$=D,ut=G(g.width*Ce),ft=!1,yt=null,Nt=null,Ut=null,te=null;h!=null&&(ut==0||d!=null)&&(ft=!0,yt=h.values(f,p,x,m),Nt=new Map,new Set(yt).forEach(Rt=>{Rt!=null&&Nt.set(Rt,new Path2D)}),ut>0&&(Ut=d.values(f,p,x,m),te=new Map,new Set(Ut).forEach(Rt=>{Rt!=null&&te.set(Rt,new Path2D)})));let{x0:ee,size:we}=l;if(ee!=null&&we!=null){H=1,y=ee.values(f,p,x,m),ee.unit==2&&(y=y.map(ue=>f.posToVal(E+ue*D,b.key,!0)));let Rt=we.values(f,p,x,m);we.unit==2?St=Rt[0]*D:St=w(Rt[0],b,D,E)-w(0,b,D,E),$=Km(y,M,w,b,D,E,$),bt=$-St+N}else $=Km(y,M,w,b,D,E,$),bt=$*o+N,St=$-bt;bt<1&&(bt=0),ut>=St/2&&(ut=0),bt<5&&(G=og);let ge=bt>0,ke=$-bt-(ge?ut:0);St=G(qu(ke,q,F)),mt=(H==0?St/2:H==Z?0:St)-H*Z*((H==0?N/2:0)+(ge?ut/2:0));let de={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ge=ft?null:new Path2D,Je=null;if(st!=null)Je=f.data[st.series[1]];else{let{y0:Rt,y1:Qt}=l;Rt!=null&&Qt!=null&&(M=Qt.values(f,p,x,m),Je=Rt.values(f,p,x,m))}let en=V*St,B=J*St;for(let Rt=Z==1?x:m;Rt>=x&&Rt<=m;Rt+=Z){let Qt=M[Rt];if(Qt==null)continue;if(Je!=null){let Q=Je[Rt]??0;if(Qt-Q==0)continue;pt=_(Q,R,I,O)}let ue=b.distr!=2||l!=null?y[Rt]:Rt,Pt=w(ue,b,D,E),Be=_(Te(Qt,j),R,I,O),Yt=G(Pt-mt),Kt=G(Xn(Be,pt)),P=G(Ri(Be,pt)),S=Kt-P;if(Qt!=null){let Q=Qt<0?B:en,_t=Qt<0?en:B;ft?(ut>0&&Ut[Rt]!=null&&K(te.get(Ut[Rt]),Yt,P+ri(ut/2),St,Xn(0,S-ut),Q,_t),yt[Rt]!=null&&K(Nt.get(yt[Rt]),Yt,P+ri(ut/2),St,Xn(0,S-ut),Q,_t)):K(Ge,Yt,P+ri(ut/2),St,Xn(0,S-ut),Q,_t),W(f,p,Rt,Yt-ut/2,P,St+ut,S)}}return ut>0?de.stroke=ft?te:Ge:ft||(de._fill=g.width==0?g._fill:g._stroke??g._fill,de.width=0),de.fill=ft?Nt:Ge,de})}function Pb(i,t){let e=Te(t?.alignGaps,0);return(n,s,r,o)=>xr(n,s,(a,c,l,u,h,d,f,p,x,m,g)=>{[r,o]=Ul(l,r,o);let y=a.pxRound,M=V=>y(d(V,u,m,p)),b=V=>y(f(V,h,g,x)),R,w,_;u.ori==0?(R=zl,_=no,w=Dg):(R=Vl,_=io,w=Ng);let E=u.dir*(u.ori==0?1:-1),O=M(c[E==1?r:o]),D=O,I=[],G=[];for(let V=E==1?r:o;V>=r&&V<=o;V+=E)if(l[V]!=null){let Z=c[V],K=M(Z);I.push(D=K),G.push(b(l[V]))}let H={stroke:i(I,G,R,_,w,y),fill:null,clip:null,band:null,gaps:null,flags:to},N=H.stroke,[F,q]=hd(n,s);if(a.fill!=null||F!=0){let V=H.fill=new Path2D(N),J=a.fillTo(n,s,a.min,a.max,F),Z=b(J);_(V,D,Z),_(V,O,Z)}if(!a.spanGaps){let V=[];V.push(...ud(c,l,r,o,E,M,e)),H.gaps=V=a.gaps(n,s,r,o,V),H.clip=Bl(V,u.ori,p,x,m,g)}return q!=0&&(H.band=q==2?[ms(n,s,r,o,N,-1),ms(n,s,r,o,N,1)]:ms(n,s,r,o,N,q)),H})}function Ib(i){return Pb(Lb,i)}function Lb(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=i[d+1]-i[d],l[d]=u[d]/h[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/l[d-1]+(h[d]+2*h[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+h[d]/3,t[d]+c[d]*h[d]/3,i[d+1]-h[d]/3,t[d+1]-c[d+1]*h[d]/3,i[d+1],t[d+1])}return a}var Ku=new Set;function jm(){for(let i of Ku)i.syncRect(!0)}eo&&(gr(dv,Jr,jm),gr(fv,Jr,jm,!0),gr(Ll,Jr,()=>{In.pxRatio=Ce}));var Db=Og(),Nb=Ug();function Qm(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>ju(r,o,t,e))}function Ub(i,t){return i.map((e,n)=>n==0?{}:pn({},t,e))}function ju(i,t,e,n){return pn({},t==0?e:n,i)}function kg(i,t,e){return t==null?jr:[t,e]}var Fb=kg;function Ob(i,t,e){return t==null?jr:Dl(t,e,id,!0)}function Bg(i,t,e,n){return t==null?jr:Fl(t,e,i.scales[n].log,!1)}var kb=Bg;function zg(i,t,e,n){return t==null?jr:nd(t,e,i.scales[n].log,!1)}var Bb=zg;function zb(i,t,e,n,s){let r=Xn(Im(i),Im(t)),o=t-i,a=Ci(s/n*o,e);do{let c=e[a],l=n*c/o;if(l>=s&&r+(c<5?Vs.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function tg(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=_n((e=+s)*Ce))+"px"),[i,t,e]}function Vb(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ve(t[2]*Ce,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function In(i,t,e){let n={mode:Te(i.mode,1)},s=n.mode;function r(v,T,L,U){let Y=T.valToPct(v);return U+L*(T.dir==-1?1-Y:Y)}function o(v,T,L,U){let Y=T.valToPct(v);return U+L*(T.dir==-1?Y:1-Y)}function a(v,T,L,U){return T.ori==0?r(v,T,L,U):o(v,T,L,U)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=xi(Yy);if(i.id!=null&&(l.id=i.id),si(l,i.class),i.title){let v=xi(Ky,l);v.textContent=i.title}let u=Ai("canvas"),h=n.ctx=u.getContext("2d"),d=xi(jy,l);gr("click",d,v=>{v.target===p&&(We!=Br||Ke!=zr)&&Rn.click(n,v)},!0);let f=n.under=xi(Qy,d);d.appendChild(u);let p=n.over=xi(tv,d);i=Qr(i);let x=+Te(i.pxAlign,1),m=Jm(x);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let g=i.ms||.001,y=n.series=s==1?Qm(i.series||[],Hm,Ym,!1):Ub(i.series||[null],qm),M=n.axes=Qm(i.axes||[],Gm,Xm,!0),b=n.scales={},R=n.bands=i.bands||[];R.forEach(v=>{v.fill=Me(v.fill||null),v.dir=Te(v.dir,-1)});let w=s==2?y[1].facets[0].scale:y[0].scale,_={axes:hs,series:xe},E=(i.drawOrder||["axes","series"]).map(v=>_[v]);function O(v){let T=v.distr==3?L=>ps(L>0?L:v.clamp(n,L,v.min,v.max,v.key)):v.distr==4?L=>Bu(L,v.asinh):v.distr==100?L=>v.fwd(L):L=>L;return L=>{let U=T(L),{_min:Y,_max:nt}=v,dt=nt-Y;return(U-Y)/dt}}function D(v){let T=b[v];if(T==null){let L=(i.scales||la)[v]||la;if(L.from!=null){D(L.from);let U=pn({},b[L.from],L,{key:v});U.valToPct=O(U),b[v]=U}else{T=b[v]=pn({},v==w?Cg:Sb,L),T.key=v;let U=T.time,Y=T.range,nt=zs(Y);if((v!=w||s==2&&!U)&&(nt&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?Cm:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?Cm:{mode:1,hard:Y[1],soft:Y[1]}},nt=!1),!nt&&kl(Y))){let dt=Y;Y=(xt,At,Vt)=>At==null?jr:Dl(At,Vt,dt)}T.range=Me(Y||(U?Fb:v==w?T.distr==3?kb:T.distr==4?Bb:kg:T.distr==3?Bg:T.distr==4?zg:Ob)),T.auto=Me(nt?!1:T.auto),T.clamp=Me(T.clamp||Mb),T._min=T._max=null,T.valToPct=O(T)}}}D("x"),D("y"),s==1&&y.forEach(v=>{D(v.scale)}),M.forEach(v=>{D(v.scale)});for(let v in i.scales)D(v);let I=b[w],G=I.distr,H,N;I.ori==0?(si(l,Zy),H=r,N=o):(si(l,Jy),H=o,N=r);let F={};for(let v in b){let T=b[v];(T.min!=null||T.max!=null)&&(F[v]={min:T.min,max:T.max},T.min=T.max=null)}let q=i.tzDate||(v=>new Date(_n(v/g))),V=i.fmtDate||od,J=g==1?Zv(q):jv(q),Z=Bm(q,km(g==1?Yv:Kv,V)),K=Vm(q,zm(tb,V)),W=[],st=n.legend=pn({},ib,i.legend),lt=n.cursor=pn({},cb,{drag:{y:s==2}},i.cursor),j=st.show,pt=lt.show,mt=st.markers;st.idxs=W,mt.width=Me(mt.width),mt.dash=Me(mt.dash),mt.stroke=Me(mt.stroke),mt.fill=Me(mt.fill);let St,bt,$,ut=[],ft=[],yt,Nt=!1,Ut={};if(st.live){let v=y[1]?y[1].values:null;Nt=v!=null,yt=Nt?v(n,1,0):{_:0};for(let T in yt)Ut[T]=td}if(j)if(St=Ai("table",ov,l),$=Ai("tbody",null,St),st.mount(n,St),Nt){bt=Ai("thead",null,St,$);let v=Ai("tr",null,bt);Ai("th",null,v);for(var te in yt)Ai("th",mm,v).textContent=te}else si(St,lv),st.live&&si(St,av);let ee={show:!0},we={show:!1};function ge(v,T){if(T==0&&(Nt||!st.live||s==2))return jr;let L=[],U=Ai("tr",cv,$,$.childNodes[T]);si(U,v.class),v.show||si(U,mr);let Y=Ai("th",null,U);if(mt.show){let xt=xi(hv,Y);if(T>0){let At=mt.width(n,T);At&&(xt.style.border=At+"px "+mt.dash(n,T)+" "+mt.stroke(n,T)),xt.style.background=mt.fill(n,T)}}let nt=xi(mm,Y);v.label instanceof HTMLElement?nt.appendChild(v.label):nt.textContent=v.label,T>0&&(mt.show||(nt.style.color=v.width>0?mt.stroke(n,T):mt.fill(n,T)),de("click",Y,xt=>{if(lt._lock)return;ie(xt);let At=y.indexOf(v);if((xt.ctrlKey||xt.metaKey)!=st.isolate){let Vt=y.some((Gt,Wt)=>Wt>0&&Wt!=At&&Gt.show);y.forEach((Gt,Wt)=>{Wt>0&&Xi(Wt,Vt?Wt==At?ee:we:ee,!0,fn.setSeries)})}else Xi(At,{show:!v.show},!0,fn.setSeries)},!1),se&&de(ym,Y,xt=>{lt._lock||(ie(xt),Xi(y.indexOf(v),Gr,!0,fn.setSeries))},!1));for(var dt in yt){let xt=Ai("td",uv,U);xt.textContent="--",L.push(xt)}return[U,L]}let ke=new Map;function de(v,T,L,U=!0){let Y=ke.get(T)||{},nt=lt.bind[v](n,T,L,U);nt&&(gr(v,T,Y[v]=nt),ke.set(T,Y))}function Ge(v,T,L){let U=ke.get(T)||{};for(let Y in U)(v==null||Y==v)&&($u(Y,T,U[Y]),delete U[Y]);v==null&&ke.delete(T)}let Je=0,en=0,B=0,Rt=0,Qt=0,ue=0,Pt=Qt,Be=ue,Yt=B,Kt=Rt,P=0,S=0,Q=0,_t=0;n.bbox={};let ht=!1,Et=!1,Tt=!1,rt=!1,at=!1,vt=!1;function z(v,T,L){(L||v!=n.width||T!=n.height)&&ct(v,T),pe(!1),Tt=!0,Et=!0,Nn()}function ct(v,T){n.width=Je=B=v,n.height=en=Rt=T,Qt=ue=0,Ct(),Zt();let L=n.bbox;P=L.left=fr(Qt*Ce,.5),S=L.top=fr(ue*Ce,.5),Q=L.width=fr(B*Ce,.5),_t=L.height=fr(Rt*Ce,.5)}let ot=3;function It(){let v=!1,T=0;for(;!v;){T++;let L=Fr(T),U=Wi(T);v=T==ot||L&&U,v||(ct(n.width,n.height),Et=!0)}}function wt({width:v,height:T}){z(v,T)}n.setSize=wt;function Ct(){let v=!1,T=!1,L=!1,U=!1;M.forEach((Y,nt)=>{if(Y.show&&Y._show){let{side:dt,_size:xt}=Y,At=dt%2,Vt=Y.label!=null?Y.labelSize:0,Gt=xt+Vt;Gt>0&&(At?(B-=Gt,dt==3?(Qt+=Gt,U=!0):L=!0):(Rt-=Gt,dt==0?(ue+=Gt,v=!0):T=!0))}}),Gi[0]=v,Gi[1]=L,Gi[2]=T,Gi[3]=U,B-=wi[1]+wi[3],Qt+=wi[3],Rt-=wi[2]+wi[0],ue+=wi[0]}function Zt(){let v=Qt+B,T=ue+Rt,L=Qt,U=ue;function Y(nt,dt){switch(nt){case 1:return v+=dt,v-dt;case 2:return T+=dt,T-dt;case 3:return L-=dt,L+dt;case 0:return U-=dt,U+dt}}M.forEach((nt,dt)=>{if(nt.show&&nt._show){let xt=nt.side;nt._pos=Y(xt,nt._size),nt.label!=null&&(nt._lpos=Y(xt,nt.labelSize))}})}if(lt.dataIdx==null){let v=lt.hover,T=v.skip=new Set(v.skip??[]);T.add(void 0);let L=v.prox=Me(v.prox),U=v.bias??=0;lt.dataIdx=(Y,nt,dt,xt)=>{if(nt==0)return dt;let At=dt,Vt=L(Y,nt,dt,xt)??ze,Gt=Vt>=0&&Vt<ze,Wt=I.ori==0?B:Rt,ce=lt.left,Ae=t[0],Ee=t[nt];if(T.has(Ee[dt])){At=null;let ve=null,ne=null,Jt;if(U==0||U==-1)for(Jt=dt;ve==null&&Jt-- >0;)T.has(Ee[Jt])||(ve=Jt);if(U==0||U==1)for(Jt=dt;ne==null&&Jt++<Ee.length;)T.has(Ee[Jt])||(ne=Jt);if(ve!=null||ne!=null)if(Gt){let $e=ve==null?-1/0:H(Ae[ve],I,Wt,0),rn=ne==null?1/0:H(Ae[ne],I,Wt,0),En=ce-$e,Oe=rn-ce;En<=Oe?En<=Vt&&(At=ve):Oe<=Vt&&(At=ne)}else At=ne==null?ve:ve==null?ne:dt-ve<=ne-dt?ve:ne}else Gt&&xn(ce-H(Ae[dt],I,Wt,0))>Vt&&(At=null);return At}}let ie=v=>{lt.event=v};lt.idxs=W,lt._lock=!1;let gt=lt.points;gt.show=Me(gt.show),gt.size=Me(gt.size),gt.stroke=Me(gt.stroke),gt.width=Me(gt.width),gt.fill=Me(gt.fill);let Xt=n.focus=pn({},i.focus||{alpha:.3},lt.focus),se=Xt.prox>=0,Ft=se&&gt.one,fe=[],He=[],Bn=[];function Xo(v,T){let L=gt.show(n,T);if(L instanceof HTMLElement)return si(L,rv),si(L,v.class),ji(L,-10,-10,B,Rt),p.insertBefore(L,fe[T]),L}function Dr(v,T){if(s==1||T>0){let L=s==1&&b[v.scale].time,U=v.value;v.value=L?Nm(U)?Vm(q,zm(U,V)):U||K:U||yb,v.label=v.label||(L?ub:hb)}if(Ft||T>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Db||Sv,v.fillTo=Me(v.fillTo||wb),v.pxAlign=+Te(v.pxAlign,x),v.pxRound=Jm(v.pxAlign),v.stroke=Me(v.stroke||null),v.fill=Me(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let L=vb(Xn(1,v.width),1),U=v.points=pn({},{size:L,width:Xn(1,L*.2),stroke:v.stroke,space:L*2,paths:Nb,_stroke:null,_fill:null},v.points);U.show=Me(U.show),U.filter=Me(U.filter),U.fill=Me(U.fill),U.stroke=Me(U.stroke),U.paths=Me(U.paths),U.pxAlign=v.pxAlign}if(j){let L=ge(v,T);ut.splice(T,0,L[0]),ft.splice(T,0,L[1]),st.values.push(null)}if(pt){W.splice(T,0,null);let L=null;Ft?T==0&&(L=Xo(v,T)):T>0&&(L=Xo(v,T)),fe.splice(T,0,L),He.splice(T,0,0),Bn.splice(T,0,0)}wn("addSeries",T)}function du(v,T){T=T??y.length,v=s==1?ju(v,T,Hm,Ym):ju(v,T,{},qm),y.splice(T,0,v),Dr(y[T],T)}n.addSeries=du;function xl(v){if(y.splice(v,1),j){st.values.splice(v,1),ft.splice(v,1);let T=ut.splice(v,1)[0];Ge(null,T.firstChild),T.remove()}pt&&(W.splice(v,1),fe.splice(v,1)[0].remove(),He.splice(v,1),Bn.splice(v,1)),wn("delSeries",v)}n.delSeries=xl;let Gi=[!1,!1,!1,!1];function as(v,T){if(v._show=v.show,v.show){let L=v.side%2,U=b[v.scale];U==null&&(v.scale=L?y[1].scale:w,U=b[v.scale]);let Y=U.time;v.size=Me(v.size),v.space=Me(v.space),v.rotate=Me(v.rotate),zs(v.incrs)&&v.incrs.forEach(dt=>{!Vs.has(dt)&&Vs.set(dt,cg(dt))}),v.incrs=Me(v.incrs||(U.distr==2?Xv:Y?g==1?qv:Jv:pr)),v.splits=Me(v.splits||(Y&&U.distr==1?J:U.distr==3?Yu:U.distr==4?pb:fb)),v.stroke=Me(v.stroke),v.grid.stroke=Me(v.grid.stroke),v.ticks.stroke=Me(v.ticks.stroke),v.border.stroke=Me(v.border.stroke);let nt=v.values;v.values=zs(nt)&&!zs(nt[0])?Me(nt):Y?zs(nt)?Bm(q,km(nt,V)):Nm(nt)?Qv(q,nt):nt||Z:nt||db,v.filter=Me(v.filter||(U.distr>=3&&U.log==10?_b:U.distr==3&&U.log==2?xb:ag)),v.font=tg(v.font),v.labelFont=tg(v.labelFont),v._size=v.size(n,null,T,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Gi[T]=!0,v._el=xi(ev,d))}}function ls(v,T,L,U){let[Y,nt,dt,xt]=L,At=T%2,Vt=0;return At==0&&(xt||nt)&&(Vt=T==0&&!Y||T==2&&!dt?_n(Gm.size/3):0),At==1&&(Y||dt)&&(Vt=T==1&&!nt||T==3&&!xt?_n(Xm.size/2):0),Vt}let $o=n.padding=(i.padding||[ls,ls,ls,ls]).map(v=>Me(Te(v,ls))),wi=n._padding=$o.map((v,T)=>v(n,T,Gi,0)),nn,ln=null,cn=null,Hi=s==1?y[0].idxs:null,ti=null,Is=!1;function qo(v,T){if(t=v??[],n.data=n._data=t,s==2){nn=0;for(let L=1;L<y.length;L++)nn+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ti=t[0],nn=ti.length;let L=t;if(G==2){L=t.slice();let U=L[0]=Array(nn);for(let Y=0;Y<nn;Y++)U[Y]=Y}n._data=t=L}if(pe(!0),wn("setData"),G==2&&(Tt=!0),T!==!1){let L=I;L.auto(n,Is)?Yo():Ns(w,L.min,L.max),rt=rt||lt.left>=0,vt=!0,Nn()}}n.setData=qo;function Yo(){Is=!0;let v,T;s==1&&(nn>0?(ln=Hi[0]=0,cn=Hi[1]=nn-1,v=t[0][ln],T=t[0][cn],G==2?(v=ln,T=cn):v==T&&(G==3?[v,T]=Fl(v,v,I.log,!1):G==4?[v,T]=nd(v,v,I.log,!1):I.time?T=v+_n(86400/g):[v,T]=Dl(v,T,id,!0))):(ln=Hi[0]=v=null,cn=Hi[1]=T=null)),Ns(w,v,T)}let Nr,Ls,Ur,A,X,it,tt,et,Lt,kt;function Dt(v,T,L,U,Y,nt){v??=_m,L??=rd,U??="butt",Y??=_m,nt??="round",v!=Nr&&(h.strokeStyle=Nr=v),Y!=Ls&&(h.fillStyle=Ls=Y),T!=Ur&&(h.lineWidth=Ur=T),nt!=X&&(h.lineJoin=X=nt),U!=it&&(h.lineCap=it=U),L!=A&&h.setLineDash(A=L)}function Bt(v,T,L,U){T!=Ls&&(h.fillStyle=Ls=T),v!=tt&&(h.font=tt=v),L!=et&&(h.textAlign=et=L),U!=Lt&&(h.textBaseline=Lt=U)}function qt(v,T,L,U,Y=0){if(U.length>0&&v.auto(n,Is)&&(T==null||T.min==null)){let nt=Te(ln,0),dt=Te(cn,U.length-1),xt=L.min==null?_v(U,nt,dt,Y,v.distr==3):[L.min,L.max];v.min=Ri(v.min,L.min=xt[0]),v.max=Xn(v.max,L.max=xt[1])}}let oe={min:null,max:null};function _e(){for(let U in b){let Y=b[U];F[U]==null&&(Y.min==null||F[w]!=null&&Y.auto(n,Is))&&(F[U]=oe)}for(let U in b){let Y=b[U];F[U]==null&&Y.from!=null&&F[Y.from]!=null&&(F[U]=oe)}F[w]!=null&&pe(!0);let v={};for(let U in F){let Y=F[U];if(Y!=null){let nt=v[U]=Qr(b[U],Tv);if(Y.min!=null)pn(nt,Y);else if(U!=w||s==2)if(nn==0&&nt.from==null){let dt=nt.range(n,null,null,U);nt.min=dt[0],nt.max=dt[1]}else nt.min=ze,nt.max=-ze}}if(nn>0){y.forEach((U,Y)=>{if(s==1){let nt=U.scale,dt=F[nt];if(dt==null)return;let xt=v[nt];if(Y==0){let At=xt.range(n,xt.min,xt.max,nt);xt.min=At[0],xt.max=At[1],ln=Ci(xt.min,t[0]),cn=Ci(xt.max,t[0]),cn-ln>1&&(t[0][ln]<xt.min&&ln++,t[0][cn]>xt.max&&cn--),U.min=ti[ln],U.max=ti[cn]}else U.show&&U.auto&&qt(xt,dt,U,t[Y],U.sorted);U.idxs[0]=ln,U.idxs[1]=cn}else if(Y>0&&U.show&&U.auto){let[nt,dt]=U.facets,xt=nt.scale,At=dt.scale,[Vt,Gt]=t[Y],Wt=v[xt],ce=v[At];Wt!=null&&qt(Wt,F[xt],nt,Vt,nt.sorted),ce!=null&&qt(ce,F[At],dt,Gt,dt.sorted),U.min=dt.min,U.max=dt.max}});for(let U in v){let Y=v[U],nt=F[U];if(Y.from==null&&(nt==null||nt.min==null)){let dt=Y.range(n,Y.min==ze?null:Y.min,Y.max==-ze?null:Y.max,U);Y.min=dt[0],Y.max=dt[1]}}}for(let U in v){let Y=v[U];if(Y.from!=null){let nt=v[Y.from];if(nt.min==null)Y.min=Y.max=null;else{let dt=Y.range(n,nt.min,nt.max,U);Y.min=dt[0],Y.max=dt[1]}}}let T={},L=!1;for(let U in v){let Y=v[U],nt=b[U];if(nt.min!=Y.min||nt.max!=Y.max){nt.min=Y.min,nt.max=Y.max;let dt=nt.distr;nt._min=dt==3?ps(nt.min):dt==4?Bu(nt.min,nt.asinh):dt==100?nt.fwd(nt.min):nt.min,nt._max=dt==3?ps(nt.max):dt==4?Bu(nt.max,nt.asinh):dt==100?nt.fwd(nt.max):nt.max,T[U]=L=!0}}if(L){y.forEach((U,Y)=>{s==2?Y>0&&T.y&&(U._paths=null):T[U.scale]&&(U._paths=null)});for(let U in T)Tt=!0,wn("setScale",U);pt&&lt.left>=0&&(rt=vt=!0)}for(let U in F)F[U]=null}function $t(v){let T=qu(ln-1,0,nn-1),L=qu(cn+1,0,nn-1);for(;v[T]==null&&T>0;)T--;for(;v[L]==null&&L<nn-1;)L++;return[T,L]}function xe(){if(nn>0){let v=y.some(T=>T._focus)&&kt!=Xt.alpha;v&&(h.globalAlpha=kt=Xt.alpha),y.forEach((T,L)=>{if(L>0&&T.show&&(Qe(L,!1),Qe(L,!0),T._paths==null)){let U=kt;kt!=T.alpha&&(h.globalAlpha=kt=T.alpha);let Y=s==2?[0,t[L][0].length-1]:$t(t[L]);T._paths=T.paths(n,L,Y[0],Y[1]),kt!=U&&(h.globalAlpha=kt=U)}}),y.forEach((T,L)=>{if(L>0&&T.show){let U=kt;kt!=T.alpha&&(h.globalAlpha=kt=T.alpha),T._paths!=null&&De(L,!1);{let Y=T._paths!=null?T._paths.gaps:null,nt=T.points.show(n,L,ln,cn,Y),dt=T.points.filter(n,L,nt,Y);(nt||dt)&&(T.points._paths=T.points.paths(n,L,ln,cn,dt),De(L,!0))}kt!=U&&(h.globalAlpha=kt=U),wn("drawSeries",L)}}),v&&(h.globalAlpha=kt=1)}}function Qe(v,T){let L=T?y[v].points:y[v];L._stroke=L.stroke(n,v),L._fill=L.fill(n,v)}function De(v,T){let L=T?y[v].points:y[v],{stroke:U,fill:Y,clip:nt,flags:dt,_stroke:xt=L._stroke,_fill:At=L._fill,_width:Vt=L.width}=L._paths;Vt=Ve(Vt*Ce,3);let Gt=null,Wt=Vt%2/2;T&&At==null&&(At=Vt>0?"#fff":xt);let ce=L.pxAlign==1&&Wt>0;if(ce&&h.translate(Wt,Wt),!T){let Ae=P-Vt/2,Ee=S-Vt/2,ve=Q+Vt,ne=_t+Vt;Gt=new Path2D,Gt.rect(Ae,Ee,ve,ne)}T?Ht(xt,Vt,L.dash,L.cap,At,U,Y,dt,nt):Ne(v,xt,Vt,L.dash,L.cap,At,U,Y,dt,Gt,nt),ce&&h.translate(-Wt,-Wt)}function Ne(v,T,L,U,Y,nt,dt,xt,At,Vt,Gt){let Wt=!1;At!=0&&R.forEach((ce,Ae)=>{if(ce.series[0]==v){let Ee=y[ce.series[1]],ve=t[ce.series[1]],ne=(Ee._paths||la).band;zs(ne)&&(ne=ce.dir==1?ne[0]:ne[1]);let Jt,$e=null;Ee.show&&ne&&yv(ve,ln,cn)?($e=ce.fill(n,Ae)||nt,Jt=Ee._paths.clip):ne=null,Ht(T,L,U,Y,$e,dt,xt,At,Vt,Gt,Jt,ne),Wt=!0}}),Wt||Ht(T,L,U,Y,nt,dt,xt,At,Vt,Gt)}let gn=to|Ju;function Ht(v,T,L,U,Y,nt,dt,xt,At,Vt,Gt,Wt){Dt(v,T,L,U,Y),(At||Vt||Wt)&&(h.save(),At&&h.clip(At),Vt&&h.clip(Vt)),Wt?(xt&gn)==gn?(h.clip(Wt),Gt&&h.clip(Gt),be(Y,dt),hn(v,nt,T)):xt&Ju?(be(Y,dt),h.clip(Wt),hn(v,nt,T)):xt&to&&(h.save(),h.clip(Wt),Gt&&h.clip(Gt),be(Y,dt),h.restore(),hn(v,nt,T)):(be(Y,dt),hn(v,nt,T)),(At||Vt||Wt)&&h.restore()}function hn(v,T,L){L>0&&(T instanceof Map?T.forEach((U,Y)=>{h.strokeStyle=Nr=Y,h.stroke(U)}):T!=null&&v&&h.stroke(T))}function be(v,T){T instanceof Map?T.forEach((L,U)=>{h.fillStyle=Ls=U,h.fill(L)}):T!=null&&v&&h.fill(T)}function cs(v,T,L,U){let Y=M[v],nt;if(U<=0)nt=[0,0];else{let dt=Y._space=Y.space(n,v,T,L,U),xt=Y._incrs=Y.incrs(n,v,T,L,U,dt);nt=zb(T,L,xt,U,dt)}return Y._found=nt}function un(v,T,L,U,Y,nt,dt,xt,At,Vt){let Gt=dt%2/2;x==1&&h.translate(Gt,Gt),Dt(xt,dt,At,Vt,xt),h.beginPath();let Wt,ce,Ae,Ee,ve=Y+(U==0||U==3?-nt:nt);L==0?(ce=Y,Ee=ve):(Wt=Y,Ae=ve);for(let ne=0;ne<v.length;ne++)T[ne]!=null&&(L==0?Wt=Ae=v[ne]:ce=Ee=v[ne],h.moveTo(Wt,ce),h.lineTo(Ae,Ee));h.stroke(),x==1&&h.translate(-Gt,-Gt)}function Fr(v){let T=!0;return M.forEach((L,U)=>{if(!L.show)return;let Y=b[L.scale];if(Y.min==null){L._show&&(T=!1,L._show=!1,pe(!1));return}else L._show||(T=!1,L._show=!0,pe(!1));let nt=L.side,dt=nt%2,{min:xt,max:At}=Y,[Vt,Gt]=cs(U,xt,At,dt==0?B:Rt);if(Gt==0)return;let Wt=Y.distr==2,ce=L._splits=L.splits(n,U,xt,At,Vt,Gt,Wt),Ae=Y.distr==2?ce.map(Jt=>ti[Jt]):ce,Ee=Y.distr==2?ti[ce[1]]-ti[ce[0]]:Vt,ve=L._values=L.values(n,L.filter(n,Ae,U,Gt,Ee),U,Gt,Ee);L._rotate=nt==2?L.rotate(n,ve,U,Gt):0;let ne=L._size;L._size=yi(L.size(n,ve,U,v)),ne!=null&&L._size!=ne&&(T=!1)}),T}function Wi(v){let T=!0;return $o.forEach((L,U)=>{let Y=L(n,U,Gi,v);Y!=wi[U]&&(T=!1),wi[U]=Y}),T}function hs(){for(let v=0;v<M.length;v++){let T=M[v];if(!T.show||!T._show)continue;let L=T.side,U=L%2,Y,nt,dt=T.stroke(n,v),xt=L==0||L==3?-1:1,[At,Vt]=T._found;if(T.label!=null){let Gn=T.labelGap*xt,ii=_n((T._lpos+Gn)*Ce);Bt(T.labelFont[0],dt,"center",L==2?"top":gm),h.save(),U==1?(Y=nt=0,h.translate(ii,_n(S+_t/2)),h.rotate((L==3?-Il:Il)/2)):(Y=_n(P+Q/2),nt=ii);let ar=rg(T.label)?T.label(n,v,At,Vt):T.label;h.fillText(ar,Y,nt),h.restore()}if(Vt==0)continue;let Gt=b[T.scale],Wt=U==0?Q:_t,ce=U==0?P:S,Ae=T._splits,Ee=Gt.distr==2?Ae.map(Gn=>ti[Gn]):Ae,ve=Gt.distr==2?ti[Ae[1]]-ti[Ae[0]]:At,ne=T.ticks,Jt=T.border,$e=ne.show?ne.size:0,rn=_n($e*Ce),En=_n((T.alignTo==2?T._size-$e-T.gap:T.gap)*Ce),Oe=T._rotate*-Il/180,on=m(T._pos*Ce),ei=(rn+En)*xt,Vn=on+ei;nt=U==0?Vn:0,Y=U==1?Vn:0;let mi=T.font[0],Ei=T.align==1?Yr:T.align==2?Fu:Oe>0?Yr:Oe<0?Fu:U==0?"center":L==3?Fu:Yr,qi=Oe||U==1?"middle":L==2?"top":gm;Bt(mi,dt,Ei,qi);let ni=T.font[1]*T.lineGap,gi=Ae.map(Gn=>m(a(Gn,Gt,Wt,ce))),Ti=T._values;for(let Gn=0;Gn<Ti.length;Gn++){let ii=Ti[Gn];if(ii!=null){U==0?Y=gi[Gn]:nt=gi[Gn],ii=""+ii;let ar=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let Hn=0;Hn<ar.length;Hn++){let xp=ar[Hn];Oe?(h.save(),h.translate(Y,nt+Hn*ni),h.rotate(Oe),h.fillText(xp,0,0),h.restore()):h.fillText(xp,Y,nt+Hn*ni)}}}ne.show&&un(gi,ne.filter(n,Ee,v,Vt,ve),U,L,on,rn,Ve(ne.width*Ce,3),ne.stroke(n,v),ne.dash,ne.cap);let Yi=T.grid;Yi.show&&un(gi,Yi.filter(n,Ee,v,Vt,ve),U,U==0?2:1,U==0?S:P,U==0?_t:Q,Ve(Yi.width*Ce,3),Yi.stroke(n,v),Yi.dash,Yi.cap),Jt.show&&un([on],[1],U==0?1:0,U==0?1:2,U==1?S:P,U==1?_t:Q,Ve(Jt.width*Ce,3),Jt.stroke(n,v),Jt.dash,Jt.cap)}wn("drawAxes")}function pe(v){y.forEach((T,L)=>{L>0&&(T._paths=null,v&&(s==1?(T.min=null,T.max=null):T.facets.forEach(U=>{U.min=null,U.max=null})))})}let sn=!1,zn=!1,Ue=[];function dn(){zn=!1;for(let v=0;v<Ue.length;v++)wn(...Ue[v]);Ue.length=0}function Nn(){sn||(Dv(tp),sn=!0)}function yl(v,T=!1){sn=!0,zn=T,v(n),tp(),T&&Ue.length>0&&queueMicrotask(dn)}n.batch=yl;function tp(){if(ht&&(_e(),ht=!1),Tt&&(It(),Tt=!1),Et){if(qe(f,Yr,Qt),qe(f,"top",ue),qe(f,sa,B),qe(f,ra,Rt),qe(p,Yr,Qt),qe(p,"top",ue),qe(p,sa,B),qe(p,ra,Rt),qe(d,sa,Je),qe(d,ra,en),u.width=_n(Je*Ce),u.height=_n(en*Ce),M.forEach(({_el:v,_show:T,_size:L,_pos:U,side:Y})=>{if(v!=null)if(T){let nt=Y===3||Y===0?L:0,dt=Y%2==1;qe(v,dt?"left":"top",U-nt),qe(v,dt?"width":"height",L),qe(v,dt?"top":"left",dt?ue:Qt),qe(v,dt?"height":"width",dt?Rt:B),Xu(v,mr)}else si(v,mr)}),Nr=Ls=Ur=X=it=tt=et=Lt=A=null,kt=1,Ko(!0),Qt!=Pt||ue!=Be||B!=Yt||Rt!=Kt){pe(!1);let v=B/Yt,T=Rt/Kt;if(pt&&!rt&&lt.left>=0){lt.left*=v,lt.top*=T,Or&&ji(Or,_n(lt.left),0,B,Rt),kr&&ji(kr,0,_n(lt.top),B,Rt);for(let L=0;L<fe.length;L++){let U=fe[L];U!=null&&(He[L]*=v,Bn[L]*=T,ji(U,yi(He[L]),yi(Bn[L]),B,Rt))}}if(Xe.show&&!at&&Xe.left>=0&&Xe.width>0){Xe.left*=v,Xe.width*=v,Xe.top*=T,Xe.height*=T;for(let L in xu)qe(Vr,L,Xe[L])}Pt=Qt,Be=ue,Yt=B,Kt=Rt}wn("setSize"),Et=!1}Je>0&&en>0&&(h.clearRect(0,0,u.width,u.height),wn("drawClear"),E.forEach(v=>v()),wn("draw")),Xe.show&&at&&(vl(Xe),at=!1),pt&&rt&&(or(null,!0,!1),rt=!1),st.show&&st.live&&vt&&(gu(),vt=!1),c||(c=!0,n.status=1,wn("ready")),Is=!1,sn=!1}n.redraw=(v,T)=>{Tt=T||!1,v!==!1?Ns(w,I.min,I.max):Nn()};function fu(v,T){let L=b[v];if(L.from==null){if(nn==0){let U=L.range(n,T.min,T.max,v);T.min=U[0],T.max=U[1]}if(T.min>T.max){let U=T.min;T.min=T.max,T.max=U}if(nn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;v==w&&L.distr==2&&nn>0&&(T.min=Ci(T.min,t[0]),T.max=Ci(T.max,t[0]),T.min==T.max&&T.max++),F[v]=T,ht=!0,Nn()}}n.setScale=fu;let pu,mu,Or,kr,ep,np,Br,zr,ip,sp,We,Ke,Ds=!1,Rn=lt.drag,Mn=Rn.x,Sn=Rn.y;pt&&(lt.x&&(pu=xi(iv,p)),lt.y&&(mu=xi(sv,p)),I.ori==0?(Or=pu,kr=mu):(Or=mu,kr=pu),We=lt.left,Ke=lt.top);let Xe=n.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Vr=Xe.show?xi(nv,Xe.over?p:f):null;function vl(v,T){if(Xe.show){for(let L in v)Xe[L]=v[L],L in xu&&qe(Vr,L,v[L]);T!==!1&&wn("setSelect")}}n.setSelect=vl;function Hx(v){if(y[v].show)j&&Xu(ut[v],mr);else if(j&&si(ut[v],mr),pt){let L=Ft?fe[0]:fe[v];L!=null&&ji(L,-10,-10,B,Rt)}}function Ns(v,T,L){fu(v,{min:T,max:L})}function Xi(v,T,L,U){T.focus!=null&&Yx(v),T.show!=null&&y.forEach((Y,nt)=>{nt>0&&(v==nt||v==null)&&(Y.show=T.show,Hx(nt),s==2?(Ns(Y.facets[0].scale,null,null),Ns(Y.facets[1].scale,null,null)):Ns(Y.scale,null,null),Nn())}),L!==!1&&wn("setSeries",v,T),U&&jo("setSeries",n,v,T)}n.setSeries=Xi;function Wx(v,T){pn(R[v],T)}function Xx(v,T){v.fill=Me(v.fill||null),v.dir=Te(v.dir,-1),T=T??R.length,R.splice(T,0,v)}function $x(v){v==null?R.length=0:R.splice(v,1)}n.addBand=Xx,n.setBand=Wx,n.delBand=$x;function qx(v,T){y[v].alpha=T,pt&&fe[v]!=null&&(fe[v].style.opacity=T),j&&ut[v]&&(ut[v].style.opacity=T)}let us,Us,rr,Gr={focus:!0};function Yx(v){if(v!=rr){let T=v==null,L=Xt.alpha!=1;y.forEach((U,Y)=>{if(s==1||Y>0){let nt=T||Y==0||Y==v;U._focus=T?null:nt,L&&qx(Y,nt?1:Xt.alpha)}}),rr=v,L&&Nn()}}j&&se&&de(vm,St,v=>{lt._lock||(ie(v),rr!=null&&Xi(null,Gr,!0,fn.setSeries))});function $i(v,T,L){let U=b[T];L&&(v=v/Ce-(U.ori==1?ue:Qt));let Y=B;U.ori==1&&(Y=Rt,v=Y-v),U.dir==-1&&(v=Y-v);let nt=U._min,dt=U._max,xt=v/Y,At=nt+(dt-nt)*xt,Vt=U.distr;return Vt==3?Kr(10,At):Vt==4?bv(At,U.asinh):Vt==100?U.bwd(At):At}function Zx(v,T){let L=$i(v,w,T);return Ci(L,t[0],ln,cn)}n.valToIdx=v=>Ci(v,t[0]),n.posToIdx=Zx,n.posToVal=$i,n.valToPos=(v,T,L)=>b[T].ori==0?r(v,b[T],L?Q:B,L?P:0):o(v,b[T],L?_t:Rt,L?S:0),n.setCursor=(v,T,L)=>{We=v.left,Ke=v.top,or(null,T,L)};function rp(v,T){qe(Vr,Yr,Xe.left=v),qe(Vr,sa,Xe.width=T)}function op(v,T){qe(Vr,"top",Xe.top=v),qe(Vr,ra,Xe.height=T)}let Zo=I.ori==0?rp:op,Jo=I.ori==1?rp:op;function Jx(){if(j&&st.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&Nt)continue;let T=st.values[v],L=0;for(let U in T)ft[v][L++].firstChild.nodeValue=T[U]}}function gu(v,T){if(v!=null&&(v.idxs?v.idxs.forEach((L,U)=>{W[U]=L}):Ev(v.idx)||W.fill(v.idx),st.idx=W[0]),j&&st.live){for(let L=0;L<y.length;L++)(L>0||s==1&&!Nt)&&Kx(L,W[L]);Jx()}vt=!1,T!==!1&&wn("setLegend")}n.setLegend=gu;function Kx(v,T){let L=y[v],U=v==0&&G==2?ti:t[v],Y;Nt?Y=L.values(n,v,T)??Ut:(Y=L.value(n,T==null?null:U[T],v,T),Y=Y==null?Ut:{_:Y}),st.values[v]=Y}function or(v,T,L){ip=We,sp=Ke,[We,Ke]=lt.move(n,We,Ke),lt.left=We,lt.top=Ke,pt&&(Or&&ji(Or,_n(We),0,B,Rt),kr&&ji(kr,0,_n(Ke),B,Rt));let U,Y=ln>cn;us=ze,Us=null;let nt=I.ori==0?B:Rt,dt=I.ori==1?B:Rt;if(We<0||nn==0||Y){U=lt.idx=null;for(let xt=0;xt<y.length;xt++){let At=fe[xt];At!=null&&ji(At,-10,-10,B,Rt)}se&&Xi(null,Gr,!0,v==null&&fn.setSeries),st.live&&(W.fill(U),vt=!0)}else{let xt,At,Vt;s==1&&(xt=I.ori==0?We:Ke,At=$i(xt,w),U=lt.idx=Ci(At,t[0],ln,cn),Vt=H(t[0][U],I,nt,0));let Gt=-10,Wt=-10,ce=0,Ae=0,Ee=!0,ve="",ne="";for(let Jt=s==2?1:0;Jt<y.length;Jt++){let $e=y[Jt],rn=W[Jt],En=rn==null?null:s==1?t[Jt][rn]:t[Jt][1][rn],Oe=lt.dataIdx(n,Jt,U,At),on=Oe==null?null:s==1?t[Jt][Oe]:t[Jt][1][Oe];if(vt=vt||on!=En||Oe!=rn,W[Jt]=Oe,Jt>0&&$e.show){let ei=Oe==null?-10:Oe==U?Vt:H(s==1?t[0][Oe]:t[Jt][0][Oe],I,nt,0),Vn=on==null?-10:N(on,s==1?b[$e.scale]:b[$e.facets[1].scale],dt,0);if(se&&on!=null){let mi=I.ori==1?We:Ke,Ei=xn(Xt.dist(n,Jt,Oe,Vn,mi));if(Ei<us){let qi=Xt.bias;if(qi!=0){let ni=$i(mi,$e.scale),gi=on>=0?1:-1,Ti=ni>=0?1:-1;Ti==gi&&(Ti==1?qi==1?on>=ni:on<=ni:qi==1?on<=ni:on>=ni)&&(us=Ei,Us=Jt)}else us=Ei,Us=Jt}}if(vt||Ft){let mi,Ei;I.ori==0?(mi=ei,Ei=Vn):(mi=Vn,Ei=ei);let qi,ni,gi,Ti,Yi,Gn,ii=!0,ar=gt.bbox;if(ar!=null){ii=!1;let Hn=ar(n,Jt);gi=Hn.left,Ti=Hn.top,qi=Hn.width,ni=Hn.height}else gi=mi,Ti=Ei,qi=ni=gt.size(n,Jt);if(Gn=gt.fill(n,Jt),Yi=gt.stroke(n,Jt),Ft)Jt==Us&&us<=Xt.prox&&(Gt=gi,Wt=Ti,ce=qi,Ae=ni,Ee=ii,ve=Gn,ne=Yi);else{let Hn=fe[Jt];Hn!=null&&(He[Jt]=gi,Bn[Jt]=Ti,Am(Hn,qi,ni,ii),Em(Hn,Gn,Yi),ji(Hn,yi(gi),yi(Ti),B,Rt))}}}}if(Ft){let Jt=Xt.prox,$e=rr==null?us<=Jt:us>Jt||Us!=rr;if(vt||$e){let rn=fe[0];rn!=null&&(He[0]=Gt,Bn[0]=Wt,Am(rn,ce,Ae,Ee),Em(rn,ve,ne),ji(rn,yi(Gt),yi(Wt),B,Rt))}}}if(Xe.show&&Ds)if(v!=null){let[xt,At]=fn.scales,[Vt,Gt]=fn.match,[Wt,ce]=v.cursor.sync.scales,Ae=v.cursor.drag;if(Mn=Ae._x,Sn=Ae._y,Mn||Sn){let{left:Ee,top:ve,width:ne,height:Jt}=v.select,$e=v.scales[Wt].ori,rn=v.posToVal,En,Oe,on,ei,Vn,mi=xt!=null&&Vt(xt,Wt),Ei=At!=null&&Gt(At,ce);mi&&Mn?($e==0?(En=Ee,Oe=ne):(En=ve,Oe=Jt),on=b[xt],ei=H(rn(En,Wt),on,nt,0),Vn=H(rn(En+Oe,Wt),on,nt,0),Zo(Ri(ei,Vn),xn(Vn-ei))):Zo(0,nt),Ei&&Sn?($e==1?(En=Ee,Oe=ne):(En=ve,Oe=Jt),on=b[At],ei=N(rn(En,ce),on,dt,0),Vn=N(rn(En+Oe,ce),on,dt,0),Jo(Ri(ei,Vn),xn(Vn-ei))):Jo(0,dt)}else yu()}else{let xt=xn(ip-ep),At=xn(sp-np);if(I.ori==1){let ce=xt;xt=At,At=ce}Mn=Rn.x&&xt>=Rn.dist,Sn=Rn.y&&At>=Rn.dist;let Vt=Rn.uni;Vt!=null?Mn&&Sn&&(Mn=xt>=Vt,Sn=At>=Vt,!Mn&&!Sn&&(At>xt?Sn=!0:Mn=!0)):Rn.x&&Rn.y&&(Mn||Sn)&&(Mn=Sn=!0);let Gt,Wt;Mn&&(I.ori==0?(Gt=Br,Wt=We):(Gt=zr,Wt=Ke),Zo(Ri(Gt,Wt),xn(Wt-Gt)),Sn||Jo(0,dt)),Sn&&(I.ori==1?(Gt=Br,Wt=We):(Gt=zr,Wt=Ke),Jo(Ri(Gt,Wt),xn(Wt-Gt)),Mn||Zo(0,nt)),!Mn&&!Sn&&(Zo(0,0),Jo(0,0))}if(Rn._x=Mn,Rn._y=Sn,v==null){if(L){if(_p!=null){let[xt,At]=fn.scales;fn.values[0]=xt!=null?$i(I.ori==0?We:Ke,xt):null,fn.values[1]=At!=null?$i(I.ori==1?We:Ke,At):null}jo(Ou,n,We,Ke,B,Rt,U)}if(se){let xt=L&&fn.setSeries,At=Xt.prox;rr==null?us<=At&&Xi(Us,Gr,!0,xt):us>At?Xi(null,Gr,!0,xt):Us!=rr&&Xi(Us,Gr,!0,xt)}}vt&&(st.idx=U,gu()),T!==!1&&wn("setCursor")}let Fs=null;Object.defineProperty(n,"rect",{get(){return Fs==null&&Ko(!1),Fs}});function Ko(v=!1){v?Fs=null:(Fs=p.getBoundingClientRect(),wn("syncRect",Fs))}function ap(v,T,L,U,Y,nt,dt){lt._lock||Ds&&v!=null&&v.movementX==0&&v.movementY==0||(_u(v,T,L,U,Y,nt,dt,!1,v!=null),v!=null?or(null,!0,!0):or(T,!0,!1))}function _u(v,T,L,U,Y,nt,dt,xt,At){if(Fs==null&&Ko(!1),ie(v),v!=null)L=v.clientX-Fs.left,U=v.clientY-Fs.top;else{if(L<0||U<0){We=-10,Ke=-10;return}let[Vt,Gt]=fn.scales,Wt=T.cursor.sync,[ce,Ae]=Wt.values,[Ee,ve]=Wt.scales,[ne,Jt]=fn.match,$e=T.axes[0].side%2==1,rn=I.ori==0?B:Rt,En=I.ori==1?B:Rt,Oe=$e?nt:Y,on=$e?Y:nt,ei=$e?U:L,Vn=$e?L:U;if(Ee!=null?L=ne(Vt,Ee)?a(ce,b[Vt],rn,0):-10:L=rn*(ei/Oe),ve!=null?U=Jt(Gt,ve)?a(Ae,b[Gt],En,0):-10:U=En*(Vn/on),I.ori==1){let mi=L;L=U,U=mi}}At&&(T==null||T.cursor.event.type==Ou)&&((L<=1||L>=B-1)&&(L=fr(L,B)),(U<=1||U>=Rt-1)&&(U=fr(U,Rt))),xt?(ep=L,np=U,[Br,zr]=lt.move(n,L,U)):(We=L,Ke=U)}let xu={width:0,height:0,left:0,top:0};function yu(){vl(xu,!1)}let lp,cp,hp,up;function dp(v,T,L,U,Y,nt,dt){Ds=!0,Mn=Sn=Rn._x=Rn._y=!1,_u(v,T,L,U,Y,nt,dt,!0,!1),v!=null&&(de(ku,Hu,fp,!1),jo(xm,n,Br,zr,B,Rt,null));let{left:xt,top:At,width:Vt,height:Gt}=Xe;lp=xt,cp=At,hp=Vt,up=Gt}function fp(v,T,L,U,Y,nt,dt){Ds=Rn._x=Rn._y=!1,_u(v,T,L,U,Y,nt,dt,!1,!0);let{left:xt,top:At,width:Vt,height:Gt}=Xe,Wt=Vt>0||Gt>0,ce=lp!=xt||cp!=At||hp!=Vt||up!=Gt;if(Wt&&ce&&vl(Xe),Rn.setScale&&Wt&&ce){let Ae=xt,Ee=Vt,ve=At,ne=Gt;if(I.ori==1&&(Ae=At,Ee=Gt,ve=xt,ne=Vt),Mn&&Ns(w,$i(Ae,w),$i(Ae+Ee,w)),Sn)for(let Jt in b){let $e=b[Jt];Jt!=w&&$e.from==null&&$e.min!=ze&&Ns(Jt,$i(ve+ne,Jt),$i(ve,Jt))}yu()}else lt.lock&&(lt._lock=!lt._lock,or(T,!0,v!=null));v!=null&&(Ge(ku,Hu),jo(ku,n,We,Ke,B,Rt,null))}function jx(v,T,L,U,Y,nt,dt){if(lt._lock)return;ie(v);let xt=Ds;if(Ds){let At=!0,Vt=!0,Gt=10,Wt,ce;I.ori==0?(Wt=Mn,ce=Sn):(Wt=Sn,ce=Mn),Wt&&ce&&(At=We<=Gt||We>=B-Gt,Vt=Ke<=Gt||Ke>=Rt-Gt),Wt&&At&&(We=We<Br?0:B),ce&&Vt&&(Ke=Ke<zr?0:Rt),or(null,!0,!0),Ds=!1}We=-10,Ke=-10,W.fill(null),or(null,!0,!0),xt&&(Ds=xt)}function pp(v,T,L,U,Y,nt,dt){lt._lock||(ie(v),Yo(),yu(),v!=null&&jo(bm,n,We,Ke,B,Rt,null))}function mp(){M.forEach(Vb),z(n.width,n.height,!0)}gr(Ll,Jr,mp);let Hr={};Hr.mousedown=dp,Hr.mousemove=ap,Hr.mouseup=fp,Hr.dblclick=pp,Hr.setSeries=(v,T,L,U)=>{let Y=fn.match[2];L=Y(n,T,L),L!=-1&&Xi(L,U,!0,!1)},pt&&(de(xm,p,dp),de(Ou,p,ap),de(ym,p,v=>{ie(v),Ko(!1)}),de(vm,p,jx),de(bm,p,pp),Ku.add(n),n.syncRect=Ko);let bl=n.hooks=i.hooks||{};function wn(v,T,L){zn?Ue.push([v,T,L]):v in bl&&bl[v].forEach(U=>{U.call(null,n,T,L)})}(i.plugins||[]).forEach(v=>{for(let T in v.hooks)bl[T]=(bl[T]||[]).concat(v.hooks[T])});let gp=(v,T,L)=>L,fn=pn({key:null,setSeries:!1,filters:{pub:Lm,sub:Lm},scales:[w,y[1]?y[1].scale:null],match:[Dm,Dm,gp],values:[null,null]},lt.sync);fn.match.length==2&&fn.match.push(gp),lt.sync=fn;let _p=fn.key,vu=Rg(_p);function jo(v,T,L,U,Y,nt,dt){fn.filters.pub(v,T,L,U,Y,nt,dt)&&vu.pub(v,T,L,U,Y,nt,dt)}vu.sub(n);function Qx(v,T,L,U,Y,nt,dt){fn.filters.sub(v,T,L,U,Y,nt,dt)&&Hr[v](null,T,L,U,Y,nt,dt)}n.pub=Qx;function ty(){vu.unsub(n),Ku.delete(n),ke.clear(),$u(Ll,Jr,mp),l.remove(),St?.remove(),wn("destroy")}n.destroy=ty;function bu(){wn("init",i,t),qo(t||i.data,!1),F[w]?fu(w,F[w]):Yo(),at=Xe.show&&(Xe.width>0||Xe.height>0),rt=vt=!0,z(i.width,i.height)}return y.forEach(Dr),M.forEach(as),e?e instanceof HTMLElement?(e.appendChild(l),bu()):e(n,bu):bu(),n}In.assign=pn;In.fmtNum=sd;In.rangeNum=Dl;In.rangeLog=Fl;In.rangeAsinh=nd;In.orient=xr;In.pxRatio=Ce;In.join=Lv;In.fmtDate=od,In.tzDate=Hv;In.sync=Rg;{In.addGap=Eb,In.clipGaps=Bl;let i=In.paths={points:Ug};i.linear=Og,i.stepped=Cb,i.bars=Rb,i.spline=Ib}var fd=92,pd=14,Vg=132,Gb="replay",Hb=[{key:"force_ratio",title:"a hit at this speed would be",others:"a hit of somebody who can give way would be",unit:"x",of:"x the limit",limit:1,colour:"--hitting"},{key:"distance_m",title:"gap to what is hit",unit:"m",limit:0,colour:"--accent"},{key:"speed_m_s",title:"speed of the link",unit:"m/s",colour:"--path"}],so=i=>getComputedStyle(document.documentElement).getPropertyValue(i).trim();function Wb(i){return t=>{let e=t.valToPos(i,"y",!0),{ctx:n,bbox:s}=t;n.save(),n.strokeStyle=so("--ink"),n.setLineDash([6,5]),n.beginPath(),n.moveTo(s.left,e),n.lineTo(s.left+s.width,e),n.stroke(),n.restore()}}function Xb(i){return t=>{let{ctx:e,bbox:n}=t;e.save();for(let{frame:s,kind:r}of i()){let o=t.valToPos(t.data[0][s],"x",!0);e.strokeStyle=so(`--event-${r}`),e.lineWidth=1.5*devicePixelRatio,e.beginPath(),e.moveTo(o,n.top),e.lineTo(o,n.top+n.height),e.stroke()}e.restore()}}function $b(i){return(t,e,n)=>{let s=[e,n,i].filter(c=>c!=null),[r,o]=s.length>0?[Math.min(...s),Math.max(...s)]:[0,1],a=Math.max(.08*(o-r),.02);return[r<0?r-a:r===0?0:Math.max(0,r-a),o+a]}}function Gg(i){let t=Hb.map(h=>{let d=C("b"),f=C("div",{class:"plot"}),p=C("span",{},h.title);return{...h,value:d,box:f,named:p,element:C("figure",{},C("figcaption",{},p," ",d),f)}}),e=C("div",{class:"plots","data-test":"plots"},t.map(h=>h.element)),n=null,s=[],r=0,o=()=>Math.max(n.frames-1,1);function a({colour:h,limit:d,unit:f}){let p={stroke:so("--ink-soft"),grid:{stroke:so("--line"),width:1},ticks:{stroke:so("--line"),width:1},font:"11px system-ui, sans-serif"};return{width:Math.max(e.clientWidth,200),height:Vg,padding:[6,pd,0,0],legend:{show:!1},cursor:{sync:{key:Gb,setSeries:!1},drag:{x:!1,y:!1},y:!1,points:{size:7}},scales:{x:{time:!1,range:(x,m,g)=>[m,g]},y:{range:$b(d)}},axes:[{...p,size:22,gap:2,values:(x,m)=>m.map(g=>`${+g.toFixed(2)} s`)},{...p,size:fd,gap:4,space:24,values:(x,m)=>m.map(g=>`${+g.toFixed(2)} ${f}`)}],series:[{},{stroke:so(h),width:2,points:{show:!1}}],hooks:{draw:[Xb(()=>s),...d===void 0?[]:[Wb(d)]]}}}function c(h){let d=C("div",{class:"now"});h.over.append(d),h.now=d;let f=p=>{let{left:x,width:m}=h.over.getBoundingClientRect();i((p.clientX-x)/m*o())};h.over.addEventListener("pointerdown",p=>{h.over.setPointerCapture(p.pointerId),f(p)}),h.over.addEventListener("pointermove",p=>p.buttons===1&&f(p))}function l(){for(let h of t){h.plot?.destroy();let d=[...n[h.key]].map(f=>Number.isFinite(f)?f:null);h.plot=new In(a(h),[[...n.time_s],d],h.box),c(h.plot)}u(r)}function u(h){r=h;for(let{plot:d,key:f,value:p,unit:x,of:m}of t){d.now.style.left=`${100*r/o()}%`;let g=n[f][r];p.textContent=Number.isFinite(g)?`${g.toFixed(2)}${m??` ${x}`}`:"none"}}return new ResizeObserver(()=>{for(let{plot:h}of t)h?.setSize({width:Math.max(e.clientWidth,200),height:Vg})}).observe(e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n&&l()),{element:e,load(h,d,f){[n,s,r]=[h,d,0],t.forEach(({named:p,title:x,others:m})=>p.textContent=f?x:m??x),l()},show:u}}var er={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},nr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},A0=0,jd=1,C0=2;var tl=1,R0=2,Oo=3,ir=0,Zn=1,Si=2,Ar=0,ko=1,Qd=2,tf=3,ef=4,P0=5;var Cr=100,I0=101,L0=102,D0=103,N0=104,U0=200,F0=201,O0=202,k0=203,nf=204,sf=205,B0=206,z0=207,V0=208,G0=209,H0=210,W0=211,X0=212,$0=213,q0=214,yc=0,vc=1,bc=2,wo=3,Mc=4,Sc=5,wc=6,Ec=7,ih=0,Y0=1,Z0=2,ss=0,rf=1,of=2,af=3,lf=4,cf=5,hf=6,uf=7;var df=300,Rr=301,Bo=302,sh=303,rh=304,Tc=1e3,ts=1001,Ac=1002,Cn=1003,J0=1004;var el=1005;var Yn=1006,oh=1007;var Ts=1008;var Kn=1009,ff=1010,pf=1011,zo=1012,ah=1013,Oi=1014,ki=1015,Bi=1016,lh=1017,ch=1018,Pr=1020,mf=35902,gf=35899,_f=1021,xf=1022,zi=1023,Ms=1026,As=1027,yf=1028,hh=1029,sr=1030,uh=1031;var dh=1033,nl=33776,il=33777,sl=33778,rl=33779,fh=35840,ph=35841,mh=35842,gh=35843,_h=36196,xh=37492,yh=37496,vh=37488,bh=37489,ol=37490,Mh=37491,Sh=37808,wh=37809,Eh=37810,Th=37811,Ah=37812,Ch=37813,Rh=37814,Ph=37815,Ih=37816,Lh=37817,Dh=37818,Nh=37819,Uh=37820,Fh=37821,Oh=36492,kh=36494,Bh=36495,zh=36283,Vh=36284,al=36285,Gh=36286;var va=2300,Cc=2301,_c=2302,Vd=2303,Gd=2400,Hd=2401,Wd=2402;var K0=3200;var Hh=0,j0=1,Cs="",ci="srgb",ba="srgb-linear",Ma="linear",Ie="srgb";var xc=7680;var Q0=519,t_=512,e_=513,n_=514,vf=515,i_=516,s_=517,bf=518,Mf=519,r_=35044;var Sf="300 es",bi=2e3,Eo=2001;function qb(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Yb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Sa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function o_(){let i=Sa("canvas");return i.style.display="block",i}var Hg={},To=null;function wf(...i){let t="THREE."+i.shift();To?To("log",t,...i):console.log(t,...i)}function a_(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=a_(i);let t="THREE."+i.shift();if(To)To("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function re(...i){i=a_(i);let t="THREE."+i.shift();if(To)To("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ga(...i){let t=i.join(" ");t in Hg||(Hg[t]=!0,jt(...i))}function l_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var c_={[yc]:yc,[bc]:wc,[Mc]:Mc,[wo]:Sc,[vc]:vc,[wc]:bc,[Ec]:Ec,[Sc]:wo},Ni=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Wg=1234567,bo=Math.PI/180,Ao=180/Math.PI;function Ir(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]+"-"+Un[t&255]+Un[t>>8&255]+"-"+Un[t>>16&15|64]+Un[t>>24&255]+"-"+Un[e&63|128]+Un[e>>8&255]+"-"+Un[e>>16&255]+Un[e>>24&255]+Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]).toLowerCase()}function ae(i,t,e){return Math.max(t,Math.min(e,i))}function Ef(i,t){return(i%t+t)%t}function Zb(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Jb(i,t,e){return i!==t?(e-i)/(t-i):0}function _a(i,t,e){return(1-e)*i+e*t}function Kb(i,t,e,n){return _a(i,t,1-Math.exp(-e*n))}function jb(i,t=1){return t-Math.abs(Ef(i,t*2)-t)}function Qb(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function tM(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function eM(i,t){return i+Math.floor(Math.random()*(t-i+1))}function nM(i,t){return i+Math.random()*(t-i)}function iM(i){return i*(.5-Math.random())}function sM(i){i!==void 0&&(Wg=i);let t=Wg+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function rM(i){return i*bo}function oM(i){return i*Ao}function aM(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function lM(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Tf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function cM(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+n)/2),u=o((t+n)/2),h=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*u,c*h,c*d,a*l);break;case"YZY":i.set(c*d,a*u,c*h,a*l);break;case"ZXZ":i.set(c*h,c*d,a*u,a*l);break;case"XZX":i.set(a*u,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*u,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*u,a*l);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Af(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function h_(i,t){if(t.constructor===Float32Array)return i;let e=Af(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function u_(i,t){if(t.constructor===Float32Array)return i;let e=Af(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Cf={DEG2RAD:bo,RAD2DEG:Ao,generateUUID:Ir,clamp:ae,euclideanModulo:Ef,mapLinear:Zb,inverseLerp:Jb,lerp:_a,damp:Kb,pingpong:jb,smoothstep:Qb,smootherstep:tM,randInt:eM,randFloat:nM,randFloatSpread:iM,seededRandom:sM,degToRad:rM,radToDeg:oM,isPowerOfTwo:aM,ceilPowerOfTwo:lM,floorPowerOfTwo:Tf,setQuaternionFromProperEuler:cM,normalize:u_,denormalize:h_},Ot=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ae(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ae(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ln=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let c=n[s+0],l=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||c!==d||l!==f||u!==p){let m=c*d+l*f+u*p+h*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),M=Math.sin(y);g=Math.sin(g*y)/M,a=Math.sin(a*y)/M,c=c*g+d*a,l=l*g+f*a,u=u*g+p*a,h=h*g+x*a}else{c=c*g+d*a,l=l*g+f*a,u=u*g+p*a,h=h*g+x*a;let y=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=y,l*=y,u*=y,h*=y}}t[e]=c,t[e+1]=l,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+c*f-l*d,t[e+1]=c*p+u*d+l*h-a*f,t[e+2]=l*p+u*f+a*d-c*h,t[e+3]=u*p-a*h-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(s/2),h=a(r/2),d=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*u*h+l*f*p,this._y=l*f*h-d*u*p,this._z=l*u*p+d*f*h,this._w=l*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+l*f*p,this._y=l*f*h-d*u*p,this._z=l*u*p-d*f*h,this._w=l*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-l*f*p,this._y=l*f*h+d*u*p,this._z=l*u*p+d*f*h,this._w=l*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-l*f*p,this._y=l*f*h+d*u*p,this._z=l*u*p-d*f*h,this._w=l*u*h+d*f*p;break;case"YZX":this._x=d*u*h+l*f*p,this._y=l*f*h+d*u*p,this._z=l*u*p-d*f*h,this._w=l*u*h-d*f*p;break;case"XZY":this._x=d*u*h-l*f*p,this._y=l*f*h-d*u*p,this._z=l*u*p+d*f*h,this._w=l*u*h+d*f*p;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],u=e[6],h=e[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ae(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,u=e._w;return this._x=n*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-n*l,this._z=r*u+o*l+n*c-s*a,this._w=o*u-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,e=Math.sin(e*l)/u,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},k=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Xg.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Xg.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+c*l+o*h-a*u,this.y=n+c*u+a*l-r*h,this.z=s+c*h+r*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this.z=ae(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this.z=ae(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ae(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return md.copy(this).projectOnVector(t),this.sub(md)}reflect(t){return this.sub(md.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ae(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},md=new k,Xg=new Ln,le=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l)}set(t,e,n,s,r,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],h=n[7],d=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],y=s[1],M=s[4],b=s[7],R=s[2],w=s[5],_=s[8];return r[0]=o*x+a*y+c*R,r[3]=o*m+a*M+c*w,r[6]=o*g+a*b+c*_,r[1]=l*x+u*y+h*R,r[4]=l*m+u*M+h*w,r[7]=l*g+u*b+h*_,r[2]=d*x+f*y+p*R,r[5]=d*m+f*M+p*w,r[8]=d*g+f*b+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return e*o*u-e*a*l-n*r*u+n*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=u*o-a*l,d=a*c-u*r,f=l*r-o*c,p=e*h+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=h*x,t[1]=(s*l-u*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(u*e-s*c)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*c-l*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return ga("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(gd.makeScale(t,e)),this}rotate(t){return ga("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(gd.makeRotation(-t)),this}translate(t,e){return ga("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(gd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},gd=new le,$g=new le().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),qg=new le().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function hM(){let i={enabled:!0,workingColorSpace:ba,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ie&&(s.r=bs(s.r),s.g=bs(s.g),s.b=bs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(s.r=Mo(s.r),s.g=Mo(s.g),s.b=Mo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cs?Ma:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ba]:{primaries:t,whitePoint:n,transfer:Ma,toXYZ:$g,fromXYZ:qg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:t,whitePoint:n,transfer:Ie,toXYZ:$g,fromXYZ:qg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),i}var Se=hM();function bs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Mo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var ro,Rc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{ro===void 0&&(ro=Sa("canvas")),ro.width=t.width,ro.height=t.height;let s=ro.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=ro}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Sa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=bs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(bs(e[n]/255)*255):e[n]=bs(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},uM=0,Co=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:uM++}),this.uuid=Ir(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(_d(s[o].image)):r.push(_d(s[o]))}else r=_d(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function _d(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Rc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var dM=0,xd=new k,Jn=class i extends Ni{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ts,s=ts,r=Yn,o=Ts,a=zi,c=Kn,l=i.DEFAULT_ANISOTROPY,u=Cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:dM++}),this.uuid=Ir(),this.name="",this.source=new Co(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Ot(0,0),this.repeat=new Ot(1,1),this.center=new Ot(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new le,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(xd).x}get height(){return this.source.getSize(xd).y}get depth(){return this.source.getSize(xd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==df)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Tc:t.x=t.x-Math.floor(t.x);break;case ts:t.x=t.x<0?0:1;break;case Ac:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Tc:t.y=t.y-Math.floor(t.y);break;case ts:t.y=t.y<0?0:1;break;case Ac:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=df;Jn.DEFAULT_ANISOTROPY=1;var je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],u=c[4],h=c[8],d=c[1],f=c[5],p=c[9],x=c[2],m=c[6],g=c[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+m)<.1&&Math.abs(l+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(l+1)/2,b=(f+1)/2,R=(g+1)/2,w=(u+d)/4,_=(h+x)/4,E=(p+m)/4;return M>b&&M>R?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=w/n,r=_/n):b>R?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=w/s,r=E/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=_/r,s=E/r),this.set(n,s,r,e),this}let y=Math.sqrt((m-p)*(m-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(h-x)/y,this.z=(d-u)/y,this.w=Math.acos((l+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this.z=ae(this.z,t.z,e.z),this.w=ae(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this.z=ae(this.z,t,e),this.w=ae(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ae(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Pc=class extends Ni{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Co(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ui=class extends Pc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},wa=class extends Jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ic=class extends Jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Fe=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,c,l,u,h,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l,u,h,d,f,p,x,m)}set(t,e,n,s,r,o,a,c,l,u,h,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/oo.setFromMatrixColumn(t,0).length(),r=1/oo.setFromMatrixColumn(t,1).length(),o=1/oo.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=c*u,e[4]=-c*h,e[8]=l,e[1]=f+p*l,e[5]=d-x*l,e[9]=-a*c,e[2]=x-d*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*u,f=c*h,p=l*u,x=l*h;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*u,f=c*h,p=l*u,x=l*h;e[0]=d-x*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=x-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=c*u,e[4]=p*l-f,e[8]=d*l+x,e[1]=c*h,e[5]=x*l+d,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,p=a*c,x=a*l;e[0]=c*u,e[4]=x-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-l*u,e[6]=f*h+p,e[10]=d-x*h}else if(t.order==="XZY"){let d=o*c,f=o*l,p=a*c,x=a*l;e[0]=c*u,e[4]=-h,e[8]=l*u,e[1]=d*h+x,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=x*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(fM,t,pM)}lookAt(t,e,n){let s=this.elements;return ai.subVectors(t,e),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),Gs.crossVectors(n,ai),Gs.lengthSq()===0&&(Math.abs(n.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),Gs.crossVectors(n,ai)),Gs.normalize(),Hl.crossVectors(ai,Gs),s[0]=Gs.x,s[4]=Hl.x,s[8]=ai.x,s[1]=Gs.y,s[5]=Hl.y,s[9]=ai.y,s[2]=Gs.z,s[6]=Hl.z,s[10]=ai.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],u=n[1],h=n[5],d=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],y=n[3],M=n[7],b=n[11],R=n[15],w=s[0],_=s[4],E=s[8],O=s[12],D=s[1],I=s[5],G=s[9],H=s[13],N=s[2],F=s[6],q=s[10],V=s[14],J=s[3],Z=s[7],K=s[11],W=s[15];return r[0]=o*w+a*D+c*N+l*J,r[4]=o*_+a*I+c*F+l*Z,r[8]=o*E+a*G+c*q+l*K,r[12]=o*O+a*H+c*V+l*W,r[1]=u*w+h*D+d*N+f*J,r[5]=u*_+h*I+d*F+f*Z,r[9]=u*E+h*G+d*q+f*K,r[13]=u*O+h*H+d*V+f*W,r[2]=p*w+x*D+m*N+g*J,r[6]=p*_+x*I+m*F+g*Z,r[10]=p*E+x*G+m*q+g*K,r[14]=p*O+x*H+m*V+g*W,r[3]=y*w+M*D+b*N+R*J,r[7]=y*_+M*I+b*F+R*Z,r[11]=y*E+M*G+b*q+R*K,r[15]=y*O+M*H+b*V+R*W,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],y=c*f-l*d,M=a*f-l*h,b=a*d-c*h,R=o*f-l*u,w=o*d-c*u,_=o*h-a*u;return e*(x*y-m*M+g*b)-n*(p*y-m*R+g*w)+s*(p*M-x*R+g*_)-r*(p*b-x*w+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],u=t[10];return e*(o*u-a*l)-n*(r*u-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],y=e*a-n*o,M=e*c-s*o,b=e*l-r*o,R=n*c-s*a,w=n*l-r*a,_=s*l-r*c,E=u*x-h*p,O=u*m-d*p,D=u*g-f*p,I=h*m-d*x,G=h*g-f*x,H=d*g-f*m,N=y*H-M*G+b*I+R*D-w*O+_*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let F=1/N;return t[0]=(a*H-c*G+l*I)*F,t[1]=(s*G-n*H-r*I)*F,t[2]=(x*_-m*w+g*R)*F,t[3]=(d*w-h*_-f*R)*F,t[4]=(c*D-o*H-l*O)*F,t[5]=(e*H-s*D+r*O)*F,t[6]=(m*b-p*_-g*M)*F,t[7]=(u*_-d*b+f*M)*F,t[8]=(o*G-a*D+l*E)*F,t[9]=(n*D-e*G-r*E)*F,t[10]=(p*w-x*b+g*y)*F,t[11]=(h*b-u*w-f*y)*F,t[12]=(a*O-o*I-c*E)*F,t[13]=(e*I-n*O+s*E)*F,t[14]=(x*M-p*R-m*y)*F,t[15]=(u*R-h*M+d*y)*F,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,u=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+n,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,u=o+o,h=a+a,d=r*l,f=r*u,p=r*h,x=o*u,m=o*h,g=a*h,y=c*l,M=c*u,b=c*h,R=n.x,w=n.y,_=n.z;return s[0]=(1-(x+g))*R,s[1]=(f+b)*R,s[2]=(p-M)*R,s[3]=0,s[4]=(f-b)*w,s[5]=(1-(d+g))*w,s[6]=(m+y)*w,s[7]=0,s[8]=(p+M)*_,s[9]=(m-y)*_,s[10]=(1-(d+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=oo.set(s[0],s[1],s[2]).length(),a=oo.set(s[4],s[5],s[6]).length(),c=oo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Pi.copy(this);let l=1/o,u=1/a,h=1/c;return Pi.elements[0]*=l,Pi.elements[1]*=l,Pi.elements[2]*=l,Pi.elements[4]*=u,Pi.elements[5]*=u,Pi.elements[6]*=u,Pi.elements[8]*=h,Pi.elements[9]*=h,Pi.elements[10]*=h,e.setFromRotationMatrix(Pi),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,s,r,o,a=bi,c=!1){let l=this.elements,u=2*r/(e-t),h=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(c)p=r/(o-r),x=o*r/(o-r);else if(a===bi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Eo)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=bi,c=!1){let l=this.elements,u=2/(e-t),h=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(c)p=1/(o-r),x=o/(o-r);else if(a===bi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Eo)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=h,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},oo=new k,Pi=new Fe,fM=new k(0,0,0),pM=new k(1,1,1),Gs=new k,Hl=new k,ai=new k,Yg=new Fe,Zg=new Ln,Ss=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ae(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ae(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ae(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ae(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ae(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ae(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Yg.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Yg,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Zg.setFromEuler(this),this.setFromQuaternion(Zg,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ss.DEFAULT_ORDER="XYZ";var Ro=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},mM=0,Jg=new k,ao=new Ln,gs=new Fe,Wl=new k,ha=new k,gM=new k,_M=new Ln,Kg=new k(1,0,0),jg=new k(0,1,0),Qg=new k(0,0,1),t0={type:"added"},xM={type:"removed"},lo={type:"childadded",child:null},yd={type:"childremoved",child:null},Dn=class i extends Ni{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:mM++}),this.uuid=Ir(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new k,e=new Ss,n=new Ln,s=new k(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Fe},normalMatrix:{value:new le}}),this.matrix=new Fe,this.matrixWorld=new Fe,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ro,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ao.setFromAxisAngle(t,e),this.quaternion.multiply(ao),this}rotateOnWorldAxis(t,e){return ao.setFromAxisAngle(t,e),this.quaternion.premultiply(ao),this}rotateX(t){return this.rotateOnAxis(Kg,t)}rotateY(t){return this.rotateOnAxis(jg,t)}rotateZ(t){return this.rotateOnAxis(Qg,t)}translateOnAxis(t,e){return Jg.copy(t).applyQuaternion(this.quaternion),this.position.add(Jg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Kg,t)}translateY(t){return this.translateOnAxis(jg,t)}translateZ(t){return this.translateOnAxis(Qg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(gs.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Wl.copy(t):Wl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ha.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?gs.lookAt(ha,Wl,this.up):gs.lookAt(Wl,ha,this.up),this.quaternion.setFromRotationMatrix(gs),s&&(gs.extractRotation(s.matrixWorld),ao.setFromRotationMatrix(gs),this.quaternion.premultiply(ao.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(t0),lo.child=t,this.dispatchEvent(lo),lo.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(xM),yd.child=t,this.dispatchEvent(yd),yd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),gs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),gs.multiply(t.parent.matrixWorld)),t.applyMatrix4(gs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(t0),lo.child=t,this.dispatchEvent(lo),lo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ha,t,gM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ha,_M,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];r(t.shapes,h)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new k(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var hi=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},yM={type:"move"},Po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new hi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new hi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new hi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),g=this._getHandJoint(l,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(yM)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new hi;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},d_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Hs={h:0,s:0,l:0},Xl={h:0,s:0,l:0};function vd(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ci){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=n,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Se.workingColorSpace){if(t=Ef(t,1),e=ae(e,0,1),n=ae(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=vd(o,r,t+1/3),this.g=vd(o,r,t),this.b=vd(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=ci){function n(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ci){let n=d_[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=bs(t.r),this.g=bs(t.g),this.b=bs(t.b),this}copyLinearToSRGB(t){return this.r=Mo(t.r),this.g=Mo(t.g),this.b=Mo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ci){return Se.workingToColorSpace(Fn.copy(this),t),Math.round(ae(Fn.r*255,0,255))*65536+Math.round(ae(Fn.g*255,0,255))*256+Math.round(ae(Fn.b*255,0,255))}getHexString(t=ci){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(Fn.copy(this),e);let n=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case n:c=(s-r)/h+(s<r?6:0);break;case s:c=(r-n)/h+2;break;case r:c=(n-s)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(Fn.copy(this),e),t.r=Fn.r,t.g=Fn.g,t.b=Fn.b,t}getStyle(t=ci){Se.workingToColorSpace(Fn.copy(this),t);let e=Fn.r,n=Fn.g,s=Fn.b;return t!==ci?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Hs),this.setHSL(Hs.h+t,Hs.s+e,Hs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Hs),t.getHSL(Xl);let n=_a(Hs.h,Xl.h,e),s=_a(Hs.s,Xl.s,e),r=_a(Hs.l,Xl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new he;he.NAMES=d_;var Ea=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ss,this.environmentIntensity=1,this.environmentRotation=new Ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ii=new k,_s=new k,bd=new k,xs=new k,co=new k,ho=new k,e0=new k,Md=new k,Sd=new k,wd=new k,Ed=new je,Td=new je,Ad=new je,Di=class i{constructor(t=new k,e=new k,n=new k){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ii.subVectors(t,e),s.cross(Ii);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ii.subVectors(s,e),_s.subVectors(n,e),bd.subVectors(t,e);let o=Ii.dot(Ii),a=Ii.dot(_s),c=Ii.dot(bd),l=_s.dot(_s),u=_s.dot(bd),h=o*l-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(l*c-a*u)*d,p=(o*u-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,xs)===null?!1:xs.x>=0&&xs.y>=0&&xs.x+xs.y<=1}static getInterpolation(t,e,n,s,r,o,a,c){return this.getBarycoord(t,e,n,s,xs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,xs.x),c.addScaledVector(o,xs.y),c.addScaledVector(a,xs.z),c)}static getInterpolatedAttribute(t,e,n,s,r,o){return Ed.setScalar(0),Td.setScalar(0),Ad.setScalar(0),Ed.fromBufferAttribute(t,e),Td.fromBufferAttribute(t,n),Ad.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ed,r.x),o.addScaledVector(Td,r.y),o.addScaledVector(Ad,r.z),o}static isFrontFacing(t,e,n,s){return Ii.subVectors(n,e),_s.subVectors(t,e),Ii.cross(_s).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ii.subVectors(this.c,this.b),_s.subVectors(this.a,this.b),Ii.cross(_s).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;co.subVectors(s,n),ho.subVectors(r,n),Md.subVectors(t,n);let c=co.dot(Md),l=ho.dot(Md);if(c<=0&&l<=0)return e.copy(n);Sd.subVectors(t,s);let u=co.dot(Sd),h=ho.dot(Sd);if(u>=0&&h<=u)return e.copy(s);let d=c*h-u*l;if(d<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),e.copy(n).addScaledVector(co,o);wd.subVectors(t,r);let f=co.dot(wd),p=ho.dot(wd);if(p>=0&&f<=p)return e.copy(r);let x=f*l-c*p;if(x<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(n).addScaledVector(ho,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return e0.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(e0,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(n).addScaledVector(co,o).addScaledVector(ho,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qs=class{constructor(t=new k(1/0,1/0,1/0),e=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Li.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Li.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Li.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Li):Li.fromBufferAttribute(r,o),Li.applyMatrix4(t.matrixWorld),this.expandByPoint(Li);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),$l.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),$l.copy(n.boundingBox)),$l.applyMatrix4(t.matrixWorld),this.union($l)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Li),Li.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ua),ql.subVectors(this.max,ua),uo.subVectors(t.a,ua),fo.subVectors(t.b,ua),po.subVectors(t.c,ua),Ws.subVectors(fo,uo),Xs.subVectors(po,fo),yr.subVectors(uo,po);let e=[0,-Ws.z,Ws.y,0,-Xs.z,Xs.y,0,-yr.z,yr.y,Ws.z,0,-Ws.x,Xs.z,0,-Xs.x,yr.z,0,-yr.x,-Ws.y,Ws.x,0,-Xs.y,Xs.x,0,-yr.y,yr.x,0];return!Cd(e,uo,fo,po,ql)||(e=[1,0,0,0,1,0,0,0,1],!Cd(e,uo,fo,po,ql))?!1:(Yl.crossVectors(Ws,Xs),e=[Yl.x,Yl.y,Yl.z],Cd(e,uo,fo,po,ql))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Li).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Li).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ys[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ys[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ys[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ys[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ys[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ys[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ys[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ys[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ys),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ys=[new k,new k,new k,new k,new k,new k,new k,new k],Li=new k,$l=new qs,uo=new k,fo=new k,po=new k,Ws=new k,Xs=new k,yr=new k,ua=new k,ql=new k,Yl=new k,vr=new k;function Cd(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){vr.fromArray(i,r);let a=s.x*Math.abs(vr.x)+s.y*Math.abs(vr.y)+s.z*Math.abs(vr.z),c=t.dot(vr),l=e.dot(vr),u=n.dot(vr);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var mn=new k,Zl=new Ot,vM=0,es=class extends Ni{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:vM++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=r_,this.updateRanges=[],this.gpuType=ki,this.version=0,this._normalizationScale=t!==void 0?Af(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Zl.fromBufferAttribute(this,e),Zl.applyMatrix3(t),this.setXY(e,Zl.x,Zl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):h_(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):u_(t,this.array)}};var Ta=class extends es{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Aa=class extends es{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var ye=class extends es{constructor(t,e,n){super(new Float32Array(t),e,n)}},bM=new qs,da=new k,Rd=new k,Sr=class{constructor(t=new k,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):bM.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;da.subVectors(t,this.center);let e=da.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(da,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Rd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(da.copy(t.center).add(Rd)),this.expandByPoint(da.copy(t.center).sub(Rd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},MM=0,vi=new Fe,Pd=new Dn,mo=new k,li=new qs,fa=new qs,An=new k,Ze=class i extends Ni{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:MM++}),this.uuid=Ir(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(qb(t)?Aa:Ta)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new le().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return vi.makeRotationFromQuaternion(t),this.applyMatrix4(vi),this}rotateX(t){return vi.makeRotationX(t),this.applyMatrix4(vi),this}rotateY(t){return vi.makeRotationY(t),this.applyMatrix4(vi),this}rotateZ(t){return vi.makeRotationZ(t),this.applyMatrix4(vi),this}translate(t,e,n){return vi.makeTranslation(t,e,n),this.applyMatrix4(vi),this}scale(t,e,n){return vi.makeScale(t,e,n),this.applyMatrix4(vi),this}lookAt(t){return Pd.lookAt(t),Pd.updateMatrix(),this.applyMatrix4(Pd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(mo).negate(),this.translate(mo.x,mo.y,mo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ye(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];li.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Sr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(t){let n=this.boundingSphere.center;if(li.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];fa.setFromBufferAttribute(a),this.morphTargetsRelative?(An.addVectors(li.min,fa.min),li.expandByPoint(An),An.addVectors(li.max,fa.max),li.expandByPoint(An)):(li.expandByPoint(fa.min),li.expandByPoint(fa.max))}li.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)An.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(An));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)An.fromBufferAttribute(a,l),c&&(mo.fromBufferAttribute(t,l),An.add(mo)),s=Math.max(s,n.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new es(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new k,c[O]=new k;let u=new k,h=new k,d=new k,f=new Ot,p=new Ot,x=new Ot,m=new k,g=new k;function y(O,D,I){l[O]=l[D]=l[I]=1,u.fromBufferAttribute(n,O),h.fromBufferAttribute(n,D),d.fromBufferAttribute(n,I),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,D),x.fromBufferAttribute(r,I),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let G=1/(p.x*x.y-x.x*p.y);isFinite(G)&&(m.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(G),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(G),a[O].add(m),a[D].add(m),a[I].add(m),c[O].add(g),c[D].add(g),c[I].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let O=0,D=M.length;O<D;++O){let I=M[O],G=I.start,H=I.count;for(let N=G,F=G+H;N<F;N+=3)y(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let b=new k,R=new k,w=new k,_=new k;function E(O){w.fromBufferAttribute(s,O),_.copy(w);let D=a[O];b.copy(D),b.sub(w.multiplyScalar(w.dot(D))).normalize(),R.crossVectors(_,D);let G=R.dot(c[O])<0?-1:1;o.setXYZW(O,b.x,b.y,b.z,G)}for(let O=0,D=n.count;O<D;++O)l[O]&&E(O);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new es(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new k,r=new k,o=new k,a=new k,c=new k,l=new k,u=new k,h=new k;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,x),l.fromBufferAttribute(n,m),a.add(u),c.add(u),l.add(u),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)An.fromBufferAttribute(t,e),An.normalize(),t.setXYZ(e,An.x,An.y,An.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,h=a.normalized,d=new l.constructor(c.length*u),f=0,p=0;for(let x=0,m=c.length;x<m;x++){a.isInterleavedBufferAttribute?f=c[x]*a.data.stride+a.offset:f=c[x]*u;for(let g=0;g<u;g++)d[p++]=l[f++]}return new es(d,u,h)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,h=l.length;u<h;u++){let d=l[u],f=t(d,n);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,d=l.length;h<d;h++){let f=l[h];u.push(f.toJSON(t.data))}u.length>0&&(s[c]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(e))}let r=t.morphAttributes;for(let l in r){let u=[],h=r[l];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Id=new k,SM=new k,wM=new le,$n=class{constructor(t=new k(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Id.subVectors(n,e).cross(SM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Id),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||wM.getNormalMatrix(t),s=this.coplanarPoint(Id).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},EM=0,ns=class extends Ni{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:EM++}),this.uuid=Ir(),this.name="",this.type="Material",this.blending=ko,this.side=ir,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=nf,this.blendDst=sf,this.blendEquation=Cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=wo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Q0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xc,this.stencilZFail=xc,this.stencilZPass=xc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new $n().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ot().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ot().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var vs=new k,Ld=new k,Jl=new k,Kl=new k,Ys=class{constructor(t=new k,e=new k(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,vs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=vs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(vs.copy(this.origin).addScaledVector(this.direction,e),vs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ld.copy(t).add(e).multiplyScalar(.5),Jl.copy(e).sub(t).normalize(),Kl.copy(this.origin).sub(Ld);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Jl),a=Kl.dot(this.direction),c=-Kl.dot(Jl),l=Kl.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*c-a,d=o*a-c,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*c)+l}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l):d<=p?(h=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ld).addScaledVector(Jl,d),f}intersectSphere(t,e){if(t.radius<0)return null;vs.subVectors(t.center,this.origin);let n=vs.dot(this.direction),s=vs.dot(vs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,c=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,c=(t.min.z-d.z)*h),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,vs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=n.x-o.x,y=n.y-o.y,M=n.z-o.z,b=Math.abs(c),R=Math.abs(l),w=Math.abs(u),_,E,O,D,I,G,H,N,F,q,V,J;if(b>=R&&b>=w?(O=c,G=h,F=p,J=g,c>=0?(_=l,E=u,D=d,I=f,H=x,N=m,q=y,V=M):(_=u,E=l,D=f,I=d,H=m,N=x,q=M,V=y)):R>=w?(O=l,G=d,F=x,J=y,l>=0?(_=u,E=c,D=f,I=h,H=m,N=p,q=M,V=g):(_=c,E=u,D=h,I=f,H=p,N=m,q=g,V=M)):(O=u,G=f,F=m,J=M,u>=0?(_=c,E=l,D=h,I=d,H=p,N=x,q=g,V=y):(_=l,E=c,D=d,I=h,H=x,N=p,q=y,V=g)),O===0)return null;let Z=_/O,K=E/O,W=1/O,st=D-Z*G,lt=I-K*G,j=H-Z*F,pt=N-K*F,mt=q-Z*J,St=V-K*J,bt=mt*pt-St*j,$=st*St-lt*mt,ut=j*lt-pt*st;if(s){if(bt<0||$<0||ut<0)return null}else if((bt<0||$<0||ut<0)&&(bt>0||$>0||ut>0))return null;let ft=bt+$+ut;if(ft===0)return null;let yt=W*(bt*G+$*F+ut*J);return(ft>0?yt<0:yt>0)?null:this.at(yt/ft,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Mi=class extends ns{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=ih,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},n0=new Fe,br=new Ys,jl=new Sr,i0=new k,Ql=new k,tc=new k,ec=new k,Dd=new k,nc=new k,s0=new k,ic=new k,Le=class extends Dn{constructor(t=new Ze,e=new Mi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){nc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],h=r[c];u!==0&&(Dd.fromBufferAttribute(h,t),o?nc.addScaledVector(Dd,u):nc.addScaledVector(Dd.sub(e),u))}e.add(nc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),jl.copy(n.boundingSphere),jl.applyMatrix4(r),br.copy(t.ray).recast(t.near),!(jl.containsPoint(br.origin)===!1&&(br.intersectSphere(jl,i0)===null||br.origin.distanceToSquared(i0)>(t.far-t.near)**2))&&(n0.copy(r).invert(),br.copy(t.ray).applyMatrix4(n0),!(n.boundingBox!==null&&br.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,br)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,R=M;b<R;b+=3){let w=a.getX(b),_=a.getX(b+1),E=a.getX(b+2);s=sc(this,g,t,n,l,u,h,w,_,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=a.getX(m),M=a.getX(m+1),b=a.getX(m+2);s=sc(this,o,t,n,l,u,h,y,M,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),M=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,R=M;b<R;b+=3){let w=b,_=b+1,E=b+2;s=sc(this,g,t,n,l,u,h,w,_,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(c.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=m,M=m+1,b=m+2;s=sc(this,o,t,n,l,u,h,y,M,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function TM(i,t,e,n,s,r,o,a){let c;if(t.side===Zn?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,t.side===ir,a),c===null)return null;ic.copy(a),ic.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(ic);return l<e.near||l>e.far?null:{distance:l,point:ic.clone(),object:i}}function sc(i,t,e,n,s,r,o,a,c,l){i.getVertexPosition(a,Ql),i.getVertexPosition(c,tc),i.getVertexPosition(l,ec);let u=TM(i,t,e,n,Ql,tc,ec,s0);if(u){let h=new k;Di.getBarycoord(s0,Ql,tc,ec,h),s&&(u.uv=Di.getInterpolatedAttribute(s,a,c,l,h,new Ot)),r&&(u.uv1=Di.getInterpolatedAttribute(r,a,c,l,h,new Ot)),o&&(u.normal=Di.getInterpolatedAttribute(o,a,c,l,h,new k),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new k,materialIndex:0};Di.getNormal(Ql,tc,ec,d.normal),u.face=d,u.barycoord=h}return u}var Lc=class extends Jn{constructor(t=null,e=1,n=1,s,r,o,a,c,l=Cn,u=Cn,h,d){super(null,o,a,c,l,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Mr=new Sr,AM=new Ot(.5,.5),rc=new k,Zs=class{constructor(t=new $n,e=new $n,n=new $n,s=new $n,r=new $n,o=new $n){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=bi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],y=r[12],M=r[13],b=r[14],R=r[15];if(s[0].setComponents(l-o,f-u,g-p,R-y).normalize(),s[1].setComponents(l+o,f+u,g+p,R+y).normalize(),s[2].setComponents(l+a,f+h,g+x,R+M).normalize(),s[3].setComponents(l-a,f-h,g-x,R-M).normalize(),n)s[4].setComponents(c,d,m,b).normalize(),s[5].setComponents(l-c,f-d,g-m,R-b).normalize();else if(s[4].setComponents(l-c,f-d,g-m,R-b).normalize(),e===bi)s[5].setComponents(l+c,f+d,g+m,R+b).normalize();else if(e===Eo)s[5].setComponents(c,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Mr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Mr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Mr)}intersectsSprite(t){Mr.center.set(0,0,0);let e=AM.distanceTo(t.center);return Mr.radius=.7071067811865476+e,Mr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Mr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(rc.x=s.normal.x>0?t.max.x:t.min.x,rc.y=s.normal.y>0?t.max.y:t.min.y,rc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(rc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},r0=new Fe,Dc=class i{constructor(){this.coordinateSystem=bi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];r0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Zs),n[s].setFromProjectionMatrix(r0,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Zs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Ui=class extends ns{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Nc=new k,Uc=new k,o0=new Fe,pa=new Ys,oc=new Sr,Nd=new k,a0=new k,Ca=class extends Dn{constructor(t=new Ze,e=new Ui){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Nc.fromBufferAttribute(e,s-1),Uc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Nc.distanceTo(Uc);t.setAttribute("lineDistance",new ye(n,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),oc.copy(n.boundingSphere),oc.applyMatrix4(s),oc.radius+=r,t.ray.intersectsSphere(oc)===!1)return;o0.copy(s).invert(),pa.copy(t.ray).applyMatrix4(o0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=l){let g=u.getX(x),y=u.getX(x+1),M=ac(this,t,pa,c,g,y,x);M&&e.push(M)}if(this.isLineLoop){let x=u.getX(p-1),m=u.getX(f),g=ac(this,t,pa,c,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=l){let g=ac(this,t,pa,c,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=ac(this,t,pa,c,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ac(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Nc.fromBufferAttribute(a,s),Uc.fromBufferAttribute(a,r),e.distanceSqToSegment(Nc,Uc,Nd,a0)>n)return;Nd.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Nd);if(!(l<t.near||l>t.far))return{distance:l,point:a0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var l0=new k,c0=new k,Js=class extends Ca{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)l0.fromBufferAttribute(e,s),c0.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+l0.distanceTo(c0);t.setAttribute("lineDistance",new ye(n,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Ra=class extends Ca{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Pa=class extends Jn{constructor(t=[],e=Rr,n,s,r,o,a,c,l,u){super(t,e,n,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var ws=class extends Jn{constructor(t,e,n=Oi,s,r,o,a=Cn,c=Cn,l,u=Ms,h=1){if(u!==Ms&&u!==As)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,c,u,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Co(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ia=class extends ws{constructor(t,e=Oi,n=Rr,s,r,o=Cn,a=Cn,c,l=Ms){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,n,s,r,o,a,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},La=class extends Jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ks=class i extends Ze{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new ye(l,3)),this.setAttribute("normal",new ye(u,3)),this.setAttribute("uv",new ye(h,2));function p(x,m,g,y,M,b,R,w,_,E,O){let D=b/_,I=R/E,G=b/2,H=R/2,N=w/2,F=_+1,q=E+1,V=0,J=0,Z=new k;for(let K=0;K<q;K++){let W=K*I-H;for(let st=0;st<F;st++){let lt=st*D-G;Z[x]=lt*y,Z[m]=W*M,Z[g]=N,l.push(Z.x,Z.y,Z.z),Z[x]=0,Z[m]=0,Z[g]=w>0?1:-1,u.push(Z.x,Z.y,Z.z),h.push(st/_),h.push(1-K/E),V+=1}}for(let K=0;K<E;K++)for(let W=0;W<_;W++){let st=d+W+F*K,lt=d+W+F*(K+1),j=d+(W+1)+F*(K+1),pt=d+(W+1)+F*K;c.push(st,lt,pt),c.push(lt,j,pt),J+=6}a.addGroup(f,J,O),f+=J,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var wr=class i extends Ze{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],m=n/2,g=0;y(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new ye(h,3)),this.setAttribute("normal",new ye(d,3)),this.setAttribute("uv",new ye(f,2));function y(){let b=new k,R=new k,w=0,_=(e-t)/n;for(let E=0;E<=r;E++){let O=[],D=E/r,I=D*(e-t)+t;for(let G=0;G<=s;G++){let H=G/s,N=H*c+a,F=Math.sin(N),q=Math.cos(N);R.x=I*F,R.y=-D*n+m,R.z=I*q,h.push(R.x,R.y,R.z),b.set(F,_,q).normalize(),d.push(b.x,b.y,b.z),f.push(H,1-D),O.push(p++)}x.push(O)}for(let E=0;E<s;E++)for(let O=0;O<r;O++){let D=x[O][E],I=x[O+1][E],G=x[O+1][E+1],H=x[O][E+1];(t>0||O!==0)&&(u.push(D,I,H),w+=3),(e>0||O!==r-1)&&(u.push(I,G,H),w+=3)}l.addGroup(g,w,0),g+=w}function M(b){let R=p,w=new Ot,_=new k,E=0,O=b===!0?t:e,D=b===!0?1:-1;for(let G=1;G<=s;G++)h.push(0,m*D,0),d.push(0,D,0),f.push(.5,.5),p++;let I=p;for(let G=0;G<=s;G++){let N=G/s*c+a,F=Math.cos(N),q=Math.sin(N);_.x=O*q,_.y=m*D,_.z=O*F,h.push(_.x,_.y,_.z),d.push(0,D,0),w.x=F*.5+.5,w.y=q*.5*D+.5,f.push(w.x,w.y),p++}for(let G=0;G<s;G++){let H=R+G,N=I+G;b===!0?u.push(N,N+1,H):u.push(N+1,N,H),E+=3}l.addGroup(g,E,b===!0?1:2),g+=E}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var lc=new k,cc=new k,Ud=new k,hc=new Di,Da=class extends Ze{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(bo*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],u=["a","b","c"],h=new Array(3),d=new Map,f=[];for(let p=0;p<c;p+=3){o?(l[0]=o.getX(p),l[1]=o.getX(p+1),l[2]=o.getX(p+2)):(l[0]=p,l[1]=p+1,l[2]=p+2);let{a:x,b:m,c:g}=hc;if(x.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),g.fromBufferAttribute(a,l[2]),hc.getNormal(Ud),h[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){let M=(y+1)%3,b=h[y],R=h[M],w=hc[u[y]],_=hc[u[M]],E=`${b}_${R}`,O=`${R}_${b}`,D=d.get(O);D?(Ud.dot(D.normal)<=r&&(f.push(w.x,w.y,w.z),f.push(_.x,_.y,_.z)),d.set(O,null)):d.has(E)||d.set(E,{index0:l[y],index1:l[M],normal:Ud.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;lc.fromBufferAttribute(a,x),cc.fromBufferAttribute(a,m),f.push(lc.x,lc.y,lc.z),f.push(cc.x,cc.y,cc.z)}this.setAttribute("position",new ye(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},di=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){jt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,c=r-1,l;for(;a<=c;)if(s=Math.floor(a+(c-a)/2),l=n[s]-o,l<0)a=s+1;else if(l>0)c=s-1;else{c=s;break}if(s=c,n[s]===o)return s/(r-1);let u=n[s],d=n[s+1]-u,f=(o-u)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),c=e||(o.isVector2?new Ot:new k);return c.copy(a).sub(o).normalize(),c}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new k,s=[],r=[],o=[],a=new k,c=new Fe;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new k)}r[0]=new k,o[0]=new k;let l=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),d=Math.abs(s[0].z);u<=l&&(l=u,n.set(1,0,0)),h<=l&&(l=h,n.set(0,1,0)),d<=l&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ae(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(c.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(ae(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(c.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Io=class extends di{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,c=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=c}getPoint(t,e=new Ot){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,c=this.aX+this.xRadius*Math.cos(a),l=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),d=c-this.aX,f=l-this.aY;c=d*u-f*h+this.aX,l=d*h+f*u+this.aY}return n.set(c,l)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Fc=class extends Io{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Rf(){let i=0,t=0,e=0,n=0;function s(r,o,a,c){i=r,t=a,e=-3*r+3*o-2*a-c,n=2*r-2*o+a+c}return{initCatmullRom:function(r,o,a,c,l){s(o,a,l*(a-r),l*(c-o))},initNonuniformCatmullRom:function(r,o,a,c,l,u,h){let d=(o-r)/l-(a-r)/(l+u)+(a-o)/u,f=(a-o)/u-(c-o)/(u+h)+(c-a)/h;d*=u,f*=u,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var h0=new k,u0=new k,Fd=new Rf,Od=new Rf,kd=new Rf,Oc=class extends di{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new k){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),c=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:c===0&&a===r-1&&(a=r-2,c=1);let l,u;this.closed||a>0?l=s[(a-1)%r]:(u0.subVectors(s[0],s[1]).add(s[0]),l=u0);let h=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(h0.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=h0),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(l.distanceToSquared(h),f),x=Math.pow(h.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(u),f);x<1e-4&&(x=1),p<1e-4&&(p=x),m<1e-4&&(m=x),Fd.initNonuniformCatmullRom(l.x,h.x,d.x,u.x,p,x,m),Od.initNonuniformCatmullRom(l.y,h.y,d.y,u.y,p,x,m),kd.initNonuniformCatmullRom(l.z,h.z,d.z,u.z,p,x,m)}else this.curveType==="catmullrom"&&(Fd.initCatmullRom(l.x,h.x,d.x,u.x,this.tension),Od.initCatmullRom(l.y,h.y,d.y,u.y,this.tension),kd.initCatmullRom(l.z,h.z,d.z,u.z,this.tension));return n.set(Fd.calc(c),Od.calc(c),kd.calc(c)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new k().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function d0(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,c=i*a;return(2*e-2*n+r+o)*c+(-3*e+3*n-2*r-o)*a+r*i+e}function CM(i,t){let e=1-i;return e*e*t}function RM(i,t){return 2*(1-i)*i*t}function PM(i,t){return i*i*t}function xa(i,t,e,n){return CM(i,t)+RM(i,e)+PM(i,n)}function IM(i,t){let e=1-i;return e*e*e*t}function LM(i,t){let e=1-i;return 3*e*e*i*t}function DM(i,t){return 3*(1-i)*i*i*t}function NM(i,t){return i*i*i*t}function ya(i,t,e,n,s){return IM(i,t)+LM(i,e)+DM(i,n)+NM(i,s)}var Na=class extends di{constructor(t=new Ot,e=new Ot,n=new Ot,s=new Ot){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Ot){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ya(t,s.x,r.x,o.x,a.x),ya(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},kc=class extends di{constructor(t=new k,e=new k,n=new k,s=new k){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new k){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ya(t,s.x,r.x,o.x,a.x),ya(t,s.y,r.y,o.y,a.y),ya(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ua=class extends di{constructor(t=new Ot,e=new Ot){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Ot){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Ot){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Bc=class extends di{constructor(t=new k,e=new k){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new k){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new k){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Fa=class extends di{constructor(t=new Ot,e=new Ot,n=new Ot){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Ot){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(xa(t,s.x,r.x,o.x),xa(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},zc=class extends di{constructor(t=new k,e=new k,n=new k){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new k){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(xa(t,s.x,r.x,o.x),xa(t,s.y,r.y,o.y),xa(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Oa=class extends di{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Ot){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,c=s[o===0?o:o-1],l=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(d0(a,c.x,l.x,u.x,h.x),d0(a,c.y,l.y,u.y,h.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new Ot().fromArray(s))}return this}},f0=Object.freeze({__proto__:null,ArcCurve:Fc,CatmullRomCurve3:Oc,CubicBezierCurve:Na,CubicBezierCurve3:kc,EllipseCurve:Io,LineCurve:Ua,LineCurve3:Bc,QuadraticBezierCurve:Fa,QuadraticBezierCurve3:zc,SplineCurve:Oa}),Vc=class extends di{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new f0[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],c=a.getLength(),l=c===0?0:1-o/c;return a.getPointAt(l,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,c=o.getPoints(a);for(let l=0;l<c.length;l++){let u=c[l];n&&n.equals(u)||(e.push(u),n=u)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new f0[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},ka=class extends Vc{constructor(t){super(),this.type="Path",this.currentPoint=new Ot,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new Ua(this.currentPoint.clone(),new Ot(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new Fa(this.currentPoint.clone(),new Ot(t,e),new Ot(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new Na(this.currentPoint.clone(),new Ot(t,e),new Ot(n,s),new Ot(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new Oa(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,c=this.currentPoint.y;return this.absarc(t+a,e+c,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,c){let l=this.currentPoint.x,u=this.currentPoint.y;return this.absellipse(t+l,e+u,n,s,r,o,a,c),this}absellipse(t,e,n,s,r,o,a,c){let l=new Io(t,e,n,s,r,o,a,c);if(this.curves.length>0){let h=l.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(l);let u=l.getPoint(1);return this.currentPoint.copy(u),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},Lo=class extends ka{constructor(t){super(t),this.uuid=Ir(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(new ka().fromJSON(s))}return this}};function UM(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=f_(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,c,l;if(n&&(r=zM(i,t,r,e)),i.length>80*e){a=i[0],c=i[1];let u=a,h=c;for(let d=e;d<s;d+=e){let f=i[d],p=i[d+1];f<a&&(a=f),p<c&&(c=p),f>u&&(u=f),p>h&&(h=p)}l=Math.max(u-a,h-c),l=l!==0?32767/l:0}return Ba(r,o,e,a,c,l,0),o}function f_(i,t,e,n,s){let r;if(s===KM(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=p0(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=p0(o/n|0,i[o],i[o+1],r);return r&&Do(r,r.next)&&(Va(r),r=r.next),r}function Er(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(Do(e,e.next)||tn(e.prev,e,e.next)===0)){if(Va(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function Ba(i,t,e,n,s,r,o){if(!i)return;!o&&r&&XM(i,n,s,r);let a=i;for(;i.prev!==i.next;){let c=i.prev,l=i.next;if(r?OM(i,n,s,r):FM(i)){t.push(c.i,i.i,l.i),Va(i),i=l.next,a=l.next;continue}if(i=l,i===a){o?o===1?(i=kM(Er(i),t),Ba(i,t,e,n,s,r,2)):o===2&&BM(i,t,e,n,s,r):Ba(Er(i),t,e,n,s,r,1);break}}}function FM(i){let t=i.prev,e=i,n=i.next;if(tn(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,c=e.y,l=n.y,u=Math.min(s,r,o),h=Math.min(a,c,l),d=Math.max(s,r,o),f=Math.max(a,c,l),p=n.next;for(;p!==t;){if(p.x>=u&&p.x<=d&&p.y>=h&&p.y<=f&&ma(s,a,r,c,o,l,p.x,p.y)&&tn(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function OM(i,t,e,n){let s=i.prev,r=i,o=i.next;if(tn(s,r,o)>=0)return!1;let a=s.x,c=r.x,l=o.x,u=s.y,h=r.y,d=o.y,f=Math.min(a,c,l),p=Math.min(u,h,d),x=Math.max(a,c,l),m=Math.max(u,h,d),g=Xd(f,p,t,e,n),y=Xd(x,m,t,e,n),M=i.prevZ,b=i.nextZ;for(;M&&M.z>=g&&b&&b.z<=y;){if(M.x>=f&&M.x<=x&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&ma(a,u,c,h,l,d,M.x,M.y)&&tn(M.prev,M,M.next)>=0||(M=M.prevZ,b.x>=f&&b.x<=x&&b.y>=p&&b.y<=m&&b!==s&&b!==o&&ma(a,u,c,h,l,d,b.x,b.y)&&tn(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;M&&M.z>=g;){if(M.x>=f&&M.x<=x&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&ma(a,u,c,h,l,d,M.x,M.y)&&tn(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;b&&b.z<=y;){if(b.x>=f&&b.x<=x&&b.y>=p&&b.y<=m&&b!==s&&b!==o&&ma(a,u,c,h,l,d,b.x,b.y)&&tn(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function kM(i,t){let e=i;do{let n=e.prev,s=e.next.next;!Do(n,s)&&m_(n,e,e.next,s)&&za(n,s)&&za(s,n)&&(t.push(n.i,e.i,s.i),Va(e),Va(e.next),e=i=s),e=e.next}while(e!==i);return Er(e)}function BM(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&YM(o,a)){let c=g_(o,a);o=Er(o,o.next),c=Er(c,c.next),Ba(o,t,e,n,s,r,0),Ba(c,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function zM(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,c=r<o-1?t[r+1]*n:i.length,l=f_(i,a,c,n,!1);l===l.next&&(l.steiner=!0),s.push(qM(l))}s.sort(VM);for(let r=0;r<s.length;r++)e=GM(s[r],e);return e}function VM(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function GM(i,t){let e=HM(i,t);if(!e)return t;let n=g_(e,i);return Er(n,n.next),Er(e,e.next)}function HM(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(Do(i,e))return e;do{if(Do(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let h=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(h<=n&&h>r&&(r=h,o=e.x<e.next.x?e:e.next,h===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,c=o.x,l=o.y,u=1/0;e=o;do{if(n>=e.x&&e.x>=c&&n!==e.x&&p_(s<l?n:r,s,c,l,s<l?r:n,s,e.x,e.y)){let h=Math.abs(s-e.y)/(n-e.x);za(e,i)&&(h<u||h===u&&(e.x>o.x||e.x===o.x&&WM(o,e)))&&(o=e,u=h)}e=e.next}while(e!==a);return o}function WM(i,t){return tn(i.prev,i,t.prev)<0&&tn(t.next,i,i.next)<0}function XM(i,t,e,n){let s=i;do s.z===0&&(s.z=Xd(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,$M(s)}function $M(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let l=0;l<e&&(a++,o=o.nextZ,!!o);l++);let c=e;for(;a>0||c>0&&o;)a!==0&&(c===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,c--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Xd(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function qM(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function p_(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function ma(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&p_(i,t,e,n,s,r,o,a)}function YM(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!ZM(i,t)&&(za(i,t)&&za(t,i)&&JM(i,t)&&(tn(i.prev,i,t.prev)||tn(i,t.prev,t))||Do(i,t)&&tn(i.prev,i,i.next)>0&&tn(t.prev,t,t.next)>0)}function tn(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function Do(i,t){return i.x===t.x&&i.y===t.y}function m_(i,t,e,n){let s=dc(tn(i,t,e)),r=dc(tn(i,t,n)),o=dc(tn(e,n,i)),a=dc(tn(e,n,t));return!!(s!==r&&o!==a||s===0&&uc(i,e,t)||r===0&&uc(i,n,t)||o===0&&uc(e,i,n)||a===0&&uc(e,t,n))}function uc(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function dc(i){return i>0?1:i<0?-1:0}function ZM(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&m_(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function za(i,t){return tn(i.prev,i,i.next)<0?tn(i,t,i.next)>=0&&tn(i,i.prev,t)>=0:tn(i,t,i.prev)<0||tn(i,i.next,t)<0}function JM(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function g_(i,t){let e=$d(i.i,i.x,i.y),n=$d(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function p0(i,t,e,n){let s=$d(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Va(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function $d(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function KM(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var qd=class{static triangulate(t,e,n=2){return UM(t,e,n)}},So=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];m0(t),g0(n,t);let o=t.length;e.forEach(m0);for(let c=0;c<e.length;c++)s.push(o),o+=e[c].length,g0(n,e[c]);let a=qd.triangulate(n,s);for(let c=0;c<a.length;c+=3)r.push(a.slice(c,c+3));return r}};function m0(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function g0(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var Tr=class i extends Ze{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(s),l=a+1,u=c+1,h=t/a,d=e/c,f=[],p=[],x=[],m=[];for(let g=0;g<u;g++){let y=g*d-o;for(let M=0;M<l;M++){let b=M*h-r;p.push(b,-y,0),x.push(0,0,1),m.push(M/a),m.push(1-g/c)}}for(let g=0;g<c;g++)for(let y=0;y<a;y++){let M=y+l*g,b=y+l*(g+1),R=y+1+l*(g+1),w=y+1+l*g;f.push(M,b,w),f.push(b,R,w)}this.setIndex(f),this.setAttribute("position",new ye(p,3)),this.setAttribute("normal",new ye(x,3)),this.setAttribute("uv",new ye(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},No=class i extends Ze{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],c=[],l=[],u=[],h=t,d=(e-t)/s,f=new k,p=new Ot;for(let x=0;x<=s;x++){for(let m=0;m<=n;m++){let g=r+m/n*o;f.x=h*Math.cos(g),f.y=h*Math.sin(g),c.push(f.x,f.y,f.z),l.push(0,0,1),p.x=(f.x/e+1)/2,p.y=(f.y/e+1)/2,u.push(p.x,p.y)}h+=d}for(let x=0;x<s;x++){let m=x*(n+1);for(let g=0;g<n;g++){let y=g+m,M=y,b=y+n+1,R=y+n+2,w=y+1;a.push(M,b,w),a.push(b,R,w)}}this.setIndex(a),this.setAttribute("position",new ye(c,3)),this.setAttribute("normal",new ye(l,3)),this.setAttribute("uv",new ye(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}},Ga=class i extends Ze{constructor(t=new Lo([new Ot(0,.5),new Ot(-.5,-.5),new Ot(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};let n=[],s=[],r=[],o=[],a=0,c=0;if(Array.isArray(t)===!1)l(t);else for(let u=0;u<t.length;u++)l(t[u]),this.addGroup(a,c,u),a+=c,c=0;this.setIndex(n),this.setAttribute("position",new ye(s,3)),this.setAttribute("normal",new ye(r,3)),this.setAttribute("uv",new ye(o,2));function l(u){let h=s.length/3,d=u.extractPoints(e),f=d.shape,p=d.holes;So.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,g=p.length;m<g;m++){let y=p[m];So.isClockWise(y)===!0&&(p[m]=y.reverse())}let x=So.triangulateShape(f,p);for(let m=0,g=p.length;m<g;m++){let y=p[m];f=f.concat(y)}for(let m=0,g=f.length;m<g;m++){let y=f[m];s.push(y.x,y.y,0),r.push(0,0,1),o.push(y.x,y.y)}for(let m=0,g=x.length;m<g;m++){let y=x[m],M=y[0]+h,b=y[1]+h,R=y[2]+h;n.push(M,b,R),c+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes;return jM(e,t)}static fromJSON(t,e){let n=[];for(let s=0,r=t.shapes.length;s<r;s++){let o=e[t.shapes[s]];n.push(o)}return new i(n,t.curveSegments)}};function jM(i,t){if(t.shapes=[],Array.isArray(i))for(let e=0,n=i.length;e<n;e++){let s=i[e];t.shapes.push(s.uuid)}else t.shapes.push(i.uuid);return t}var Es=class i extends Ze{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,u=[],h=new k,d=new k,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let y=[],M=g/n,b=o+M*a,R=t*Math.cos(b),w=Math.sqrt(t*t-R*R),_=0;g===0&&o===0?_=.5/e:g===n&&c===Math.PI&&(_=-.5/e);for(let E=0;E<=e;E++){let O=E/e,D=s+O*r;h.x=-w*Math.cos(D),h.y=R,h.z=w*Math.sin(D),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),m.push(O+_,1-M),y.push(l++)}u.push(y)}for(let g=0;g<n;g++)for(let y=0;y<e;y++){let M=u[g][y+1],b=u[g][y],R=u[g+1][y],w=u[g+1][y+1];(g!==0||o>0)&&f.push(M,b,w),(g!==n-1||c<Math.PI)&&f.push(b,R,w)}this.setIndex(f),this.setAttribute("position",new ye(p,3)),this.setAttribute("normal",new ye(x,3)),this.setAttribute("uv",new ye(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ha=class extends ns{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new he(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Lr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(_0(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(_0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function On(i){let t={};for(let e=0;e<i.length;e++){let n=Lr(i[e]);for(let s in n)t[s]=n[s]}return t}function _0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function QM(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Pf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var __={clone:Lr,merge:On},tS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,eS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,is=class extends ns{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tS,this.fragmentShader=eS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Lr(t.uniforms),this.uniformsGroups=QM(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ot().fromArray(s.value);break;case"v3":this.uniforms[n].value=new k().fromArray(s.value);break;case"v4":this.uniforms[n].value=new je().fromArray(s.value);break;case"m3":this.uniforms[n].value=new le().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Fe().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Gc=class extends is{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Fi=class extends ns{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Hh,this.normalScale=new Ot(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=ih,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Hc=class extends ns{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=K0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Wc=class extends ns{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function go(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function fc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var js=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Xc=class extends js{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gd,endingEnd:Gd}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hd:r=t,a=2*e-n;break;case Wd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Hd:o=t,c=2*n-e;break;case Wd:o=1,c=n+s[1]-s[0];break;default:o=t-1,c=e}let l=(n-e)*.5,u=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,y=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,M=(-1-f)*m+(1.5+f)*x+.5*p,b=f*m-f*x;for(let R=0;R!==a;++R)r[R]=g*o[u+R]+y*o[l+R]+M*o[c+R]+b*o[h+R];return r}},$c=class extends js{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(n-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[l+d]*h+o[c+d]*u;return r}},qc=class extends js{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Yc=class extends js{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(n-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[l+m]*x+o[c+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[l+p],m=o[c+p],g=f*d+p*2,y=h[g],M=h[g+1],b=t*d+p*2,R=u[b],w=u[b+1],_=iS(n,e,y,R,s);r[p]=x_(_,x,M,w,m)}return r}};function x_(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function nS(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function iS(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=x_(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let c=nS(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var fi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=go(e,this.TimeBufferType),this.values=go(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:go(t.times,Array),values:go(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),fc(t.settings)&&(n.settings={inTangents:go(t.settings.inTangents,Array),outTangents:go(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new qc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new $c(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Yc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case va:e=this.InterpolantFactoryMethodDiscrete;break;case Cc:e=this.InterpolantFactoryMethodLinear;break;case _c:e=this.InterpolantFactoryMethodSmooth;break;case Vd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return va;case this.InterpolantFactoryMethodLinear:return Cc;case this.InterpolantFactoryMethodSmooth:return _c;case this.InterpolantFactoryMethodBezier:return Vd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;fc(this.settings)&&(x0(this.settings.inTangents,t),x0(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;fc(this.settings)&&(y0(this.settings.inTangents,t),y0(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){re("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){re("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&Yb(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){re("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===_c,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(s)c=!0;else{let h=a*n,d=h-n,f=h+n;for(let p=0;p!==n;++p){let x=e[h+p];if(x!==e[d+p]||x!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,fc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function x0(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function y0(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=Cc;var Qs=class extends fi{constructor(t,e,n){super(t,e,n)}};Qs.prototype.ValueTypeName="bool";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=va;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Zc=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}};Zc.prototype.ValueTypeName="color";var Jc=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}};Jc.prototype.ValueTypeName="number";var Kc=class extends js{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(s-e),l=t*a;for(let u=l+a;l!==u;l+=4)Ln.slerpFlat(r,0,o,l-a,o,l,c);return r}},Wa=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Kc(this.times,this.values,this.getValueSize(),t)}};Wa.prototype.ValueTypeName="quaternion";Wa.prototype.InterpolantFactoryMethodSmooth=void 0;var tr=class extends fi{constructor(t,e,n){super(t,e,n)}};tr.prototype.ValueTypeName="string";tr.prototype.ValueBufferType=Array;tr.prototype.DefaultInterpolation=va;tr.prototype.InterpolantFactoryMethodLinear=void 0;tr.prototype.InterpolantFactoryMethodSmooth=void 0;var jc=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}};jc.prototype.ValueTypeName="vector";var Qc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=l.length;h<d;h+=2){let f=l[h],p=l[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},y_=new Qc,th=class{constructor(t){this.manager=t!==void 0?t:y_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};th.DEFAULT_MATERIAL_NAME="__DEFAULT";var Xa=class extends Dn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},$a=class extends Xa{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Bd=new Fe,v0=new k,b0=new k,eh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ot(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new Fe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zs,this._frameExtents=new Ot(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;v0.setFromMatrixPosition(t.matrixWorld),e.position.copy(v0),b0.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(b0),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Bd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Bd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Eo||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(Bd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},pc=new k,mc=new Ln,Qi=new k,qa=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Fe,this.projectionMatrix=new Fe,this.projectionMatrixInverse=new Fe,this.coordinateSystem=bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pc,mc,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pc,mc,Qi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(pc,mc,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pc,mc,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$s=new k,M0=new Ot,S0=new Ot,qn=class extends qa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ao*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(bo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ao*2*Math.atan(Math.tan(bo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){$s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set($s.x,$s.y).multiplyScalar(-t/$s.z),$s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set($s.x,$s.y).multiplyScalar(-t/$s.z)}getViewSize(t,e){return this.getViewBounds(t,M0,S0),e.subVectors(S0,M0)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(bo*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ya=class extends qa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Yd=class extends eh{constructor(){super(new Ya(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Za=class extends Xa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new Yd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var _o=-90,xo=1,Uo=class extends Dn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new qn(_o,xo,t,e);s.layers=this.layers,this.add(s);let r=new qn(_o,xo,t,e);r.layers=this.layers,this.add(r);let o=new qn(_o,xo,t,e);o.layers=this.layers,this.add(o);let a=new qn(_o,xo,t,e);a.layers=this.layers,this.add(a);let c=new qn(_o,xo,t,e);c.layers=this.layers,this.add(c);let l=new qn(_o,xo,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Eo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},nh=class extends qn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var If="\\[\\]\\.:\\/",sS=new RegExp("["+If+"]","g"),Lf="[^"+If+"]",rS="[^"+If.replace("\\.","")+"]",oS=/((?:WC+[\/:])*)/.source.replace("WC",Lf),aS=/(WCOD+)?/.source.replace("WCOD",rS),lS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Lf),cS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Lf),hS=new RegExp("^"+oS+aS+lS+cS+"$"),uS=["material","materials","bones","map"],Zd=class{constructor(t,e,n){let s=n||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(sS,"")}static parseTrackName(t){let e=hS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);uS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;re("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=Zd;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var sR=new Float32Array(1);var w0=new Fe,Ja=class{constructor(t,e,n=0,s=1/0){this.ray=new Ys(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new Ro,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):re("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return w0.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(w0),this}intersectObject(t,e=!0,n=[]){return Jd(t,this,n,e),n.sort(E0),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)Jd(t[s],this,n,e);return n.sort(E0),n}};function E0(i,t){return i.distance-t.distance}function Jd(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Jd(r[o],t,e,!0)}}var Fo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ae(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ae(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Kd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var T0=new k,gc=new k,yo=new k,vo=new k,zd=new k,dS=new k,fS=new k,Ka=class{constructor(t=new k,e=new k){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){T0.subVectors(t,this.start),gc.subVectors(this.end,this.start);let n=gc.dot(gc);if(n===0)return 0;let r=gc.dot(T0)/n;return e&&(r=ae(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=dS,n=fS){let s=10000000000000001e-32,r,o,a=this.start,c=t.start,l=this.end,u=t.end;yo.subVectors(l,a),vo.subVectors(u,c),zd.subVectors(a,c);let h=yo.dot(yo),d=vo.dot(vo),f=vo.dot(zd);if(h<=s&&d<=s)return e.copy(a),n.copy(c),e.distanceToSquared(n);if(h<=s)r=0,o=f/d,o=ae(o,0,1);else{let p=yo.dot(zd);if(d<=s)o=0,r=ae(-p/h,0,1);else{let x=yo.dot(vo),m=h*d-x*x;m!==0?r=ae((x*f-p*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=ae(-p/h,0,1)):o>1&&(o=1,r=ae((x-p)/h,0,1))}}return e.copy(a).addScaledVector(yo,r),n.copy(c).addScaledVector(vo,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var ja=class extends Js{constructor(t=10,e=10,n=4473924,s=8947848){n=new he(n),s=new he(s);let r=e/2,o=t/e,a=t/2,c=[],l=[];for(let d=0,f=0,p=-a;d<=e;d++,p+=o){c.push(-a,0,p,a,0,p),c.push(p,0,-a,p,0,a);let x=d===r?n:s;x.toArray(l,f),f+=3,x.toArray(l,f),f+=3,x.toArray(l,f),f+=3,x.toArray(l,f),f+=3}let u=new Ze;u.setAttribute("position",new ye(c,3)),u.setAttribute("color",new ye(l,3));let h=new Ui({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Qa=class extends Ni{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Df(i,t,e,n){let s=pS(n);switch(e){case _f:return i*t;case yf:return i*t/s.components*s.byteLength;case hh:return i*t/s.components*s.byteLength;case sr:return i*t*2/s.components*s.byteLength;case uh:return i*t*2/s.components*s.byteLength;case xf:return i*t*3/s.components*s.byteLength;case zi:return i*t*4/s.components*s.byteLength;case dh:return i*t*4/s.components*s.byteLength;case nl:case il:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case sl:case rl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ph:case gh:return Math.max(i,16)*Math.max(t,8)/4;case fh:case mh:return Math.max(i,8)*Math.max(t,8)/2;case _h:case xh:case vh:case bh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case yh:case ol:case Mh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Sh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case wh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Eh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Th:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Ah:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Ch:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Rh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ph:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Ih:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Lh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Dh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Nh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Uh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Fh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Oh:case kh:case Bh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case zh:case Vh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case al:case Gh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function pS(i){switch(i){case Kn:case ff:return{byteLength:1,components:1};case zo:case pf:case Bi:return{byteLength:2,components:1};case lh:case ch:return{byteLength:2,components:4};case Oi:case ah:case ki:return{byteLength:4,components:1};case mf:case gf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function V_(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function gS(i){let t=new WeakMap;function e(a,c){let l=a.array,u=a.usage,h=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,u),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,c,l){let u=c.array,h=c.updateRanges;if(i.bindBuffer(l,a),h.length===0)i.bufferSubData(l,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];i.bufferSubData(l,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(i.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var _S=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,xS=`#ifdef USE_ALPHAHASH
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
#endif`,yS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,vS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,bS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,MS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,SS=`#ifdef USE_AOMAP
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
#endif`,wS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ES=`#ifdef USE_BATCHING
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
#endif`,TS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,AS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,CS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,RS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,PS=`#ifdef USE_IRIDESCENCE
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
#endif`,IS=`#ifdef USE_BUMPMAP
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
#endif`,LS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,US=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,FS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,kS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,zS=`#define PI 3.141592653589793
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
} // validated`,VS=`vec3 transformedNormal = objectNormal;
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
#endif`,GS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,HS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,WS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,XS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,$S="gl_FragColor = linearToOutputTexel( gl_FragColor );",qS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,YS=`#ifdef USE_ENVMAP
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
#endif`,ZS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,JS=`#ifdef USE_ENVMAP
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
#endif`,KS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,jS=`#ifdef USE_ENVMAP
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
#endif`,QS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,tw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ew=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,nw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,iw=`#ifdef USE_GRADIENTMAP
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
}`,sw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,rw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ow=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,aw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,lw=`#ifdef USE_ENVMAP
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
#endif`,cw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,hw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,uw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,dw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,fw=`PhysicalMaterial material;
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
#endif`,pw=`uniform sampler2D dfgLUT;
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
}`,mw=`
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
#endif`,gw=`#if defined( RE_IndirectDiffuse )
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
#endif`,_w=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,xw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,yw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,vw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Mw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Sw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,ww=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Ew=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Tw=`#if defined( USE_POINTS_UV )
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
#endif`,Aw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Cw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Rw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Pw=`#if defined( USE_MORPHCOLORS )
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
#endif`,Iw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lw=`#ifdef USE_MORPHTARGETS
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
#endif`,Dw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Nw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Uw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Fw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ow=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Bw=`#ifdef USE_NORMALMAP
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
#endif`,zw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Vw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Gw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Hw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Ww=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Xw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,$w=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,qw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Yw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Zw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Jw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Kw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,jw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Qw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,t1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,e1=`float getShadowMask() {
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
}`,n1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,i1=`#ifdef USE_SKINNING
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
#endif`,s1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,r1=`#ifdef USE_SKINNING
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
#endif`,o1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,a1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,l1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,c1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,h1=`#ifdef USE_TRANSMISSION
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
#endif`,u1=`#ifdef USE_TRANSMISSION
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
#endif`,d1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,f1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,p1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,m1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,g1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,_1=`uniform sampler2D t2D;
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
}`,x1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,y1=`uniform float backgroundBlurriness;
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
}`,v1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,b1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,M1=`#include <common>
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
}`,S1=`#if DEPTH_PACKING == 3200
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
}`,w1=`#define DISTANCE
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
}`,E1=`#define DISTANCE
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
}`,T1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,A1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,C1=`uniform float scale;
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
}`,R1=`uniform vec3 diffuse;
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
}`,P1=`#include <common>
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
}`,I1=`uniform vec3 diffuse;
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
}`,L1=`#define LAMBERT
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
}`,D1=`#define LAMBERT
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
}`,N1=`#define MATCAP
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
}`,U1=`#define MATCAP
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
}`,F1=`#define NORMAL
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
}`,O1=`#define NORMAL
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
}`,k1=`#define PHONG
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
}`,B1=`#define PHONG
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
}`,z1=`#define STANDARD
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
}`,V1=`#define STANDARD
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
}`,G1=`#define TOON
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
}`,H1=`#define TOON
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
}`,W1=`uniform float size;
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
}`,X1=`uniform vec3 diffuse;
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
}`,$1=`#include <common>
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
}`,q1=`uniform vec3 color;
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
}`,Y1=`uniform float rotation;
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
}`,Z1=`uniform vec3 diffuse;
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
}`,me={alphahash_fragment:_S,alphahash_pars_fragment:xS,alphamap_fragment:yS,alphamap_pars_fragment:vS,alphatest_fragment:bS,alphatest_pars_fragment:MS,aomap_fragment:SS,aomap_pars_fragment:wS,batching_pars_vertex:ES,batching_vertex:TS,begin_vertex:AS,beginnormal_vertex:CS,bsdfs:RS,iridescence_fragment:PS,bumpmap_pars_fragment:IS,clipping_planes_fragment:LS,clipping_planes_pars_fragment:DS,clipping_planes_pars_vertex:NS,clipping_planes_vertex:US,color_fragment:FS,color_pars_fragment:OS,color_pars_vertex:kS,color_vertex:BS,common:zS,defaultnormal_vertex:VS,displacementmap_pars_vertex:GS,displacementmap_vertex:HS,emissivemap_fragment:WS,emissivemap_pars_fragment:XS,colorspace_fragment:$S,colorspace_pars_fragment:qS,envmap_fragment:YS,envmap_common_pars_fragment:ZS,envmap_pars_fragment:JS,envmap_pars_vertex:KS,envmap_physical_pars_fragment:lw,envmap_vertex:jS,fog_vertex:QS,fog_pars_vertex:tw,fog_fragment:ew,fog_pars_fragment:nw,gradientmap_pars_fragment:iw,lightmap_pars_fragment:sw,lights_lambert_fragment:rw,lights_lambert_pars_fragment:ow,lights_pars_begin:aw,lights_toon_fragment:cw,lights_toon_pars_fragment:hw,lights_phong_fragment:uw,lights_phong_pars_fragment:dw,lights_physical_fragment:fw,lights_physical_pars_fragment:pw,lights_fragment_begin:mw,lights_fragment_maps:gw,lights_fragment_end:_w,lightprobes_pars_fragment:xw,logdepthbuf_fragment:yw,logdepthbuf_pars_fragment:vw,logdepthbuf_pars_vertex:bw,logdepthbuf_vertex:Mw,map_fragment:Sw,map_pars_fragment:ww,map_particle_fragment:Ew,map_particle_pars_fragment:Tw,metalnessmap_fragment:Aw,metalnessmap_pars_fragment:Cw,morphinstance_vertex:Rw,morphcolor_vertex:Pw,morphnormal_vertex:Iw,morphtarget_pars_vertex:Lw,morphtarget_vertex:Dw,normal_fragment_begin:Nw,normal_fragment_maps:Uw,normal_pars_fragment:Fw,normal_pars_vertex:Ow,normal_vertex:kw,normalmap_pars_fragment:Bw,clearcoat_normal_fragment_begin:zw,clearcoat_normal_fragment_maps:Vw,clearcoat_pars_fragment:Gw,iridescence_pars_fragment:Hw,opaque_fragment:Ww,packing:Xw,premultiplied_alpha_fragment:$w,project_vertex:qw,dithering_fragment:Yw,dithering_pars_fragment:Zw,roughnessmap_fragment:Jw,roughnessmap_pars_fragment:Kw,shadowmap_pars_fragment:jw,shadowmap_pars_vertex:Qw,shadowmap_vertex:t1,shadowmask_pars_fragment:e1,skinbase_vertex:n1,skinning_pars_vertex:i1,skinning_vertex:s1,skinnormal_vertex:r1,specularmap_fragment:o1,specularmap_pars_fragment:a1,tonemapping_fragment:l1,tonemapping_pars_fragment:c1,transmission_fragment:h1,transmission_pars_fragment:u1,uv_pars_fragment:d1,uv_pars_vertex:f1,uv_vertex:p1,worldpos_vertex:m1,background_vert:g1,background_frag:_1,backgroundCube_vert:x1,backgroundCube_frag:y1,cube_vert:v1,cube_frag:b1,depth_vert:M1,depth_frag:S1,distance_vert:w1,distance_frag:E1,equirect_vert:T1,equirect_frag:A1,linedashed_vert:C1,linedashed_frag:R1,meshbasic_vert:P1,meshbasic_frag:I1,meshlambert_vert:L1,meshlambert_frag:D1,meshmatcap_vert:N1,meshmatcap_frag:U1,meshnormal_vert:F1,meshnormal_frag:O1,meshphong_vert:k1,meshphong_frag:B1,meshphysical_vert:z1,meshphysical_frag:V1,meshtoon_vert:G1,meshtoon_frag:H1,points_vert:W1,points_frag:X1,shadow_vert:$1,shadow_frag:q1,sprite_vert:Y1,sprite_frag:Z1},zt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new le}},envmap:{envMap:{value:null},envMapRotation:{value:new le},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new le}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new le}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new le},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new le},normalScale:{value:new Ot(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new le},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new le}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new le}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new le}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0},uvTransform:{value:new le}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Ot(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}}},os={basic:{uniforms:On([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:On([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:On([zt.common,zt.specularmap,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,zt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:On([zt.common,zt.envmap,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.roughnessmap,zt.metalnessmap,zt.fog,zt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:On([zt.common,zt.aomap,zt.lightmap,zt.emissivemap,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.gradientmap,zt.fog,zt.lights,{emissive:{value:new he(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:On([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,zt.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:On([zt.points,zt.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:On([zt.common,zt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:On([zt.common,zt.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:On([zt.common,zt.bumpmap,zt.normalmap,zt.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:On([zt.sprite,zt.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new le},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new le}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:On([zt.common,zt.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:On([zt.lights,zt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};os.physical={uniforms:On([os.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new le},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new le},clearcoatNormalScale:{value:new Ot(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new le},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new le},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new le},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new le},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new le},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new le},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new le},transmissionSamplerSize:{value:new Ot},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new le},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new le},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new le},anisotropyVector:{value:new Ot},anisotropyMap:{value:null},anisotropyMapTransform:{value:new le}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var Wh={r:0,b:0,g:0},J1=new Fe,G_=new le;G_.set(-1,0,0,0,1,0,0,0,1);function K1(i,t,e,n,s,r){let o=new he(0),a=s===!0?0:1,c,l,u=null,h=0,d=null;function f(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let b=y.backgroundBlurriness>0;M=t.get(M,b)}return M}function p(y){let M=!1,b=f(y);b===null?m(o,a):b&&b.isColor&&(m(b,1),M=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(y,M){let b=f(M);b&&b.isCubeTexture?(l===void 0&&(l=new Le(new Ks(1,1,1),new is({name:"BackgroundCubeMaterial",uniforms:Lr(os.backgroundCube.uniforms),vertexShader:os.backgroundCube.vertexShader,fragmentShader:os.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,w,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(J1.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(G_),l.material.toneMapped=Se.getTransfer(b.colorSpace)!==Ie,(u!==b||h!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new Le(new Tr(2,2),new is({name:"BackgroundMaterial",uniforms:Lr(os.background.uniforms),vertexShader:os.background.vertexShader,fragmentShader:os.background.fragmentShader,side:ir,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=Se.getTransfer(b.colorSpace)!==Ie,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function m(y,M){y.getRGB(Wh,Pf(i)),e.buffers.color.setClear(Wh.r,Wh.g,Wh.b,M,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:x,dispose:g}}function j1(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(I,G,H,N,F){let q=!1,V=h(I,N,H,G);r!==V&&(r=V,l(r.object)),q=f(I,N,H,F),q&&p(I,N,H,F),F!==null&&t.update(F,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(I,G,H,N),F!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(F).buffer))}function c(){return i.createVertexArray()}function l(I){return i.bindVertexArray(I)}function u(I){return i.deleteVertexArray(I)}function h(I,G,H,N){let F=N.wireframe===!0,q=n[G.id];q===void 0&&(q={},n[G.id]=q);let V=I.isInstancedMesh===!0?I.id:0,J=q[V];J===void 0&&(J={},q[V]=J);let Z=J[H.id];Z===void 0&&(Z={},J[H.id]=Z);let K=Z[F];return K===void 0&&(K=d(c()),Z[F]=K),K}function d(I){let G=[],H=[],N=[];for(let F=0;F<e;F++)G[F]=0,H[F]=0,N[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:H,attributeDivisors:N,object:I,attributes:{},index:null}}function f(I,G,H,N){let F=r.attributes,q=G.attributes,V=0,J=H.getAttributes();for(let Z in J)if(J[Z].location>=0){let W=F[Z],st=q[Z];if(st===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(st=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(st=I.instanceColor)),W===void 0||W.attribute!==st||st&&W.data!==st.data)return!0;V++}return r.attributesNum!==V||r.index!==N}function p(I,G,H,N){let F={},q=G.attributes,V=0,J=H.getAttributes();for(let Z in J)if(J[Z].location>=0){let W=q[Z];W===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(W=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(W=I.instanceColor));let st={};st.attribute=W,W&&W.data&&(st.data=W.data),F[Z]=st,V++}r.attributes=F,r.attributesNum=V,r.index=N}function x(){let I=r.newAttributes;for(let G=0,H=I.length;G<H;G++)I[G]=0}function m(I){g(I,0)}function g(I,G){let H=r.newAttributes,N=r.enabledAttributes,F=r.attributeDivisors;H[I]=1,N[I]===0&&(i.enableVertexAttribArray(I),N[I]=1),F[I]!==G&&(i.vertexAttribDivisor(I,G),F[I]=G)}function y(){let I=r.newAttributes,G=r.enabledAttributes;for(let H=0,N=G.length;H<N;H++)G[H]!==I[H]&&(i.disableVertexAttribArray(H),G[H]=0)}function M(I,G,H,N,F,q,V){V===!0?i.vertexAttribIPointer(I,G,H,F,q):i.vertexAttribPointer(I,G,H,N,F,q)}function b(I,G,H,N){x();let F=N.attributes,q=H.getAttributes(),V=G.defaultAttributeValues;for(let J in q){let Z=q[J];if(Z.location>=0){let K=F[J];if(K===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(K=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(K=I.instanceColor)),K!==void 0){let W=K.normalized,st=K.itemSize,lt=t.get(K);if(lt===void 0)continue;let j=lt.buffer,pt=lt.type,mt=lt.bytesPerElement,St=pt===i.INT||pt===i.UNSIGNED_INT||K.gpuType===ah;if(K.isInterleavedBufferAttribute){let bt=K.data,$=bt.isInterleavedBuffer===!0?bt.stride:bt.itemSize,ut=K.offset;if(bt.isInstancedInterleavedBuffer||bt.isInstancedBufferAttribute){for(let ft=0;ft<Z.locationSize;ft++)g(Z.location+ft,bt.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=bt.meshPerAttribute*bt.count)}else for(let ft=0;ft<Z.locationSize;ft++)m(Z.location+ft);i.bindBuffer(i.ARRAY_BUFFER,j);for(let ft=0;ft<Z.locationSize;ft++)M(Z.location+ft,st/Z.locationSize,pt,W,$*mt,(ut+st/Z.locationSize*ft)*mt,St)}else{if(K.isInstancedBufferAttribute){for(let bt=0;bt<Z.locationSize;bt++)g(Z.location+bt,K.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let bt=0;bt<Z.locationSize;bt++)m(Z.location+bt);i.bindBuffer(i.ARRAY_BUFFER,j);for(let bt=0;bt<Z.locationSize;bt++)M(Z.location+bt,st/Z.locationSize,pt,W,st*mt,st/Z.locationSize*bt*mt,St)}}else if(V!==void 0){let W=V[J];if(W!==void 0)switch(W.length){case 2:i.vertexAttrib2fv(Z.location,W);break;case 3:i.vertexAttrib3fv(Z.location,W);break;case 4:i.vertexAttrib4fv(Z.location,W);break;default:i.vertexAttrib1fv(Z.location,W)}}}}y()}function R(){O();for(let I in n){let G=n[I];for(let H in G){let N=G[H];for(let F in N){let q=N[F];for(let V in q)u(q[V].object),delete q[V];delete N[F]}}delete n[I]}}function w(I){if(n[I.id]===void 0)return;let G=n[I.id];for(let H in G){let N=G[H];for(let F in N){let q=N[F];for(let V in q)u(q[V].object),delete q[V];delete N[F]}}delete n[I.id]}function _(I){for(let G in n){let H=n[G];for(let N in H){let F=H[N];if(F[I.id]===void 0)continue;let q=F[I.id];for(let V in q)u(q[V].object),delete q[V];delete F[I.id]}}}function E(I){for(let G in n){let H=n[G],N=I.isInstancedMesh===!0?I.id:0,F=H[N];if(F!==void 0){for(let q in F){let V=F[q];for(let J in V)u(V[J].object),delete V[J];delete F[q]}delete H[N],Object.keys(H).length===0&&delete n[G]}}}function O(){D(),o=!0,r!==s&&(r=s,l(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:D,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:E,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:y}}function Q1(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function o(c,l,u){u!==0&&(i.drawArraysInstanced(n,c,l,u),e.update(l,n,u))}function a(c,l,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,u);let d=0;for(let f=0;f<u;f++)d+=l[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function tE(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==zi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let E=_===Bi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==Kn&&_!==ki&&!E&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",u=c(l);u!==l&&(jt("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:b,maxSamples:R,samples:w}}function eE(i){let t=this,e=null,n=0,s=!1,r=!1,o=new $n,a=new le,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,g=i.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):l();else{let y=r?0:n,M=y*4,b=g.clippingState||null;c.value=b,b=u(p,d,M,f);for(let R=0;R!==M;++R)b[R]=e[R];g.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=c.value,p!==!0||m===null){let g=f+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,b=f;M!==x;++M,b+=4)o.copy(h[M]).applyMatrix4(y,a),o.normal.toArray(m,b),m[b+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var hl=class extends ui{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Pa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ks(5,5,5),r=new is({name:"CubemapFromEquirect",uniforms:Lr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Zn,blending:Ar});r.uniforms.tEquirect.value=e;let o=new Le(s,r),a=e.minFilter;return e.minFilter===Ts&&(e.minFilter=Yn),new Uo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},v_=256,nE=3,iE=20,H_=256,W_=16,sE=3,rE=new k,oE=new he,$h=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Uo(1,10,null),this._boxMesh=new Le(new Ks(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=rE}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,x=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,x===null&&(t.background=c.getClearColor(oE));let m=new Uo(n,s,u);return m.position.copy(a),m.update(c,t),c.autoClear=h,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,t.background=x,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=S_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=M_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(v_,Tf(t))}_fromTexture(t,e){t.mapping===Rr||t.mapping===Bo?this._setSize(t.image.length===0?v_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=b_(t,!1,!1),n=Math.log2(t)-nE;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=b_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Rr||t.mapping===Bo?(this._cubemapMaterial===null&&(this._cubemapMaterial=S_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=M_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=aE(),this._integrationMaterial=lE());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/W_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-sE)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(H_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=cE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function b_(i,t,e){return new hl(i,{minFilter:Ts,generateMipmaps:t,type:Bi,colorSpace:ba,depthBuffer:e})}function ul(i,t,e){return new is({name:i,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:Zn,blending:Ar,depthTest:!1,depthWrite:!1})}function aE(){return ul("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${H_}u

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
	`)}function lE(){return ul("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:W_}},`

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
	`)}function cE(){return ul("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${iE}
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
	`)}function M_(){return ul("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function S_(){return ul("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function hE(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===sh||f===rh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new hl(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",l),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===sh||f===rh,x=f===Rr||f===Bo;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new $h(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||x&&y&&c(y)?(n===null&&(n=new $h(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===sh?d.mapping=Rr:f===rh&&(d.mapping=Bo),d}function c(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function uE(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ga("WebGLRenderer: "+n+" extension not supported."),s}}}function dE(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function u(p){let x=p.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function h(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=x!==null?x.array.length:m.array.length/3-1,M=m.count>=65535?Aa:Ta,b=new M(Math.ceil(y/3)*6,1),R=b.array;if(x!==null){let _=x.array;g=x.version;for(let E=0,O=0;E<y;E+=3){let D=_[E+0],I=_[E+1],G=_[E+2];R[O++]=D,R[O++]=I,R[O++]=I,R[O++]=G,R[O++]=G,R[O++]=D}}else{g=m.version;for(let _=0,E=0;_<y;_+=3){let O=_+0,D=_+1,I=_+2;R[E++]=O,R[E++]=D,R[E++]=D,R[E++]=I,R[E++]=I,R[E++]=O}}b.version=g;let w=r.get(p);w&&t.remove(w),r.set(p,b)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&c(x)}}return{get:l,update:u,getWireframeAttribute:d,dispose:f}}function fE(i,t,e){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function c(h,d){i.drawElements(n,d,r,h*o),e.update(d,n,1)}function l(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),e.update(d,n,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function pE(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function mE(i,t,e){let n=new WeakMap,s=new je;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let O=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),x===!0&&(M=3);let b=a.attributes.position.count*M,R=1;b>t.maxTextureSize&&(R=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let w=new Float32Array(b*R*4*h),_=new wa(w,b,R,h);_.type=ki,_.needsUpdate=!0;let E=M*4;for(let D=0;D<h;D++){let I=m[D],G=g[D],H=y[D],N=b*R*4*D;for(let F=0;F<I.count;F++){let q=F*E;f===!0&&(s.fromBufferAttribute(I,F),w[N+q+0]=s.x,w[N+q+1]=s.y,w[N+q+2]=s.z,w[N+q+3]=0),p===!0&&(s.fromBufferAttribute(G,F),w[N+q+4]=s.x,w[N+q+5]=s.y,w[N+q+6]=s.z,w[N+q+7]=0),x===!0&&(s.fromBufferAttribute(H,F),w[N+q+8]=s.x,w[N+q+9]=s.y,w[N+q+10]=s.z,w[N+q+11]=H.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new Ot(b,R)},n.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<l.length;x++)f+=l[x];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function gE(i,t,e,n,s){let r=new WeakMap;function o(l){let u=s.render.frame,h=l.geometry,d=t.get(l,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),n.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var _E={[rf]:"LINEAR_TONE_MAPPING",[of]:"REINHARD_TONE_MAPPING",[af]:"CINEON_TONE_MAPPING",[lf]:"ACES_FILMIC_TONE_MAPPING",[hf]:"AGX_TONE_MAPPING",[uf]:"NEUTRAL_TONE_MAPPING",[cf]:"CUSTOM_TONE_MAPPING"};function xE(i,t,e,n,s,r){let o=new ui(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new Ze;u.setAttribute("position",new ye([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ye([0,2,0,0,2,0],2));let h=new Gc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Le(u,h),f=new Ya(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,y=null,M=[],b=!1;this.setSize=function(R,w){o.setSize(R,w),a!==null&&a.setSize(R,w),c!==null&&c.setSize(R,w);for(let _=0;_<M.length;_++){let E=M[_];E.setSize&&E.setSize(R,w)}},this.setEffects=function(R){M=R,b=M.length>0&&M[0].isRenderPass===!0;let w=o.width,_=o.height;M.length>0&&a===null&&(a=new ui(w,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}),c=new ui(w,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&M.some(O=>O.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&l===null&&(l=new ws(w,_),r===!0&&(l.format=As,l.type=Pr)),o.dispose(),o.depthTexture=E?l:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let O=0;O<M.length;O++){let D=M[O];D.setSize&&D.setSize(w,_),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(l)}},this.begin=function(R,w){if(m||R.toneMapping===ss&&M.length===0)return!1;if(y=w,w!==null){let _=w.width,E=w.height;(o.width!==_||o.height!==E)&&this.setSize(_,E)}return b===!1&&R.setRenderTarget(o),g=R.toneMapping,R.toneMapping=ss,!0},this.hasRenderPass=function(){return b},this.end=function(R,w){R.toneMapping=g,m=!0;let _=o,E=a;for(let O=0;O<M.length;O++){let D=M[O];D.enabled!==!1&&(D.render(R,E,_,w),D.needsSwap!==!1&&(_=E,E=E===a?c:a))}if(p!==R.outputColorSpace||x!==R.toneMapping){p=R.outputColorSpace,x=R.toneMapping,h.defines={},Se.getTransfer(p)===Ie&&(h.defines.SRGB_TRANSFER="");let O=_E[x];O&&(h.defines[O]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(y),R.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),h.dispose()}}var X_=new Jn,$_=new ws(1,1),q_=new Ia(1),Y_=new wa,Z_=new Ic,J_=new Pa,w_=[],E_=[],T_=new Float32Array(16),A_=new Float32Array(9),C_=new Float32Array(4);function Go(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=w_[s];if(r===void 0&&(r=new Float32Array(s),w_[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function yn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function vn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Yh(i,t){let e=E_[t];e===void 0&&(e=new Int32Array(t),E_[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function yE(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function vE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;i.uniform2fv(this.addr,t),vn(e,t)}}function bE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(yn(e,t))return;i.uniform3fv(this.addr,t),vn(e,t)}}function ME(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;i.uniform4fv(this.addr,t),vn(e,t)}}function SE(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(yn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,n))return;C_.set(n),i.uniformMatrix2fv(this.addr,!1,C_),vn(e,n)}}function wE(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(yn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,n))return;A_.set(n),i.uniformMatrix3fv(this.addr,!1,A_),vn(e,n)}}function EE(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(yn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,n))return;T_.set(n),i.uniformMatrix4fv(this.addr,!1,T_),vn(e,n)}}function TE(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function AE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;i.uniform2iv(this.addr,t),vn(e,t)}}function CE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;i.uniform3iv(this.addr,t),vn(e,t)}}function RE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;i.uniform4iv(this.addr,t),vn(e,t)}}function PE(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function IE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;i.uniform2uiv(this.addr,t),vn(e,t)}}function LE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;i.uniform3uiv(this.addr,t),vn(e,t)}}function DE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;i.uniform4uiv(this.addr,t),vn(e,t)}}function Zh(i){return i.version===0&&(i.compareFunction=Mf,i.needsUpdate=!0),i}function NE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Zh($_):r=X_,e.setTexture2D(t||r,s)}function UE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Z_,s)}function FE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Zh(q_):r=J_,e.setTextureCube(t||r,s)}function OE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Y_,s)}function kE(i){switch(i){case 5126:return yE;case 35664:return vE;case 35665:return bE;case 35666:return ME;case 35674:return SE;case 35675:return wE;case 35676:return EE;case 5124:case 35670:return TE;case 35667:case 35671:return AE;case 35668:case 35672:return CE;case 35669:case 35673:return RE;case 5125:return PE;case 36294:return IE;case 36295:return LE;case 36296:return DE;case 35678:case 36198:case 36298:case 36306:case 35682:return NE;case 35679:case 36299:case 36307:return UE;case 35680:case 36300:case 36308:case 36293:return FE;case 36289:case 36303:case 36311:case 36292:return OE}}function BE(i,t){i.uniform1fv(this.addr,t)}function zE(i,t){let e=Go(t,this.size,2);i.uniform2fv(this.addr,e)}function VE(i,t){let e=Go(t,this.size,3);i.uniform3fv(this.addr,e)}function GE(i,t){let e=Go(t,this.size,4);i.uniform4fv(this.addr,e)}function HE(i,t){let e=Go(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function WE(i,t){let e=Go(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function XE(i,t){let e=Go(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function $E(i,t){i.uniform1iv(this.addr,t)}function qE(i,t){i.uniform2iv(this.addr,t)}function YE(i,t){i.uniform3iv(this.addr,t)}function ZE(i,t){i.uniform4iv(this.addr,t)}function JE(i,t){i.uniform1uiv(this.addr,t)}function KE(i,t){i.uniform2uiv(this.addr,t)}function jE(i,t){i.uniform3uiv(this.addr,t)}function QE(i,t){i.uniform4uiv(this.addr,t)}function tT(i,t,e){let n=this.cache,s=t.length,r=Yh(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Zh($_):o=X_;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function eT(i,t,e){let n=this.cache,s=t.length,r=Yh(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Z_,r[o])}function nT(i,t,e){let n=this.cache,s=t.length,r=Yh(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Zh(q_):o=J_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function iT(i,t,e){let n=this.cache,s=t.length,r=Yh(e,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Y_,r[o])}function sT(i){switch(i){case 5126:return BE;case 35664:return zE;case 35665:return VE;case 35666:return GE;case 35674:return HE;case 35675:return WE;case 35676:return XE;case 5124:case 35670:return $E;case 35667:case 35671:return qE;case 35668:case 35672:return YE;case 35669:case 35673:return ZE;case 5125:return JE;case 36294:return KE;case 36295:return jE;case 36296:return QE;case 35678:case 36198:case 36298:case 36306:case 35682:return tT;case 35679:case 36299:case 36307:return eT;case 35680:case 36300:case 36308:case 36293:return nT;case 36289:case 36303:case 36311:case 36292:return iT}}var Ff=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=kE(e.type)}},Of=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=sT(e.type)}},kf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Nf=/(\w+)(\])?(\[|\.)?/g;function R_(i,t){i.seq.push(t),i.map[t.id]=t}function rT(i,t,e){let n=i.name,s=n.length;for(Nf.lastIndex=0;;){let r=Nf.exec(n),o=Nf.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){R_(e,l===void 0?new Ff(a,i,t):new Of(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new kf(a),R_(e,h)),e=h}}}var Vo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);rT(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function P_(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var oT=37297,aT=0;function lT(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var I_=new le;function cT(i){Se._getMatrix(I_,Se.workingColorSpace,i);let t=`mat3( ${I_.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(i)){case Ma:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function L_(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+lT(i.getShaderSource(t),a)}else return r}function hT(i,t){let e=cT(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var uT={[rf]:"Linear",[of]:"Reinhard",[af]:"Cineon",[lf]:"ACESFilmic",[hf]:"AgX",[uf]:"Neutral",[cf]:"Custom"};function dT(i,t){let e=uT[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Xh=new k;function fT(){Se.getLuminanceCoefficients(Xh);let i=Xh.x.toFixed(4),t=Xh.y.toFixed(4),e=Xh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function pT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(cl).join(`
`)}function mT(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function gT(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function cl(i){return i!==""}function D_(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function N_(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var _T=/^[ \t]*#include +<([\w\d./]+)>/gm;function Bf(i){return i.replace(_T,xT)}function xT(i,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Bf(e)}var yT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function U_(i){return i.replace(yT,vT)}function vT(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function F_(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var bT={[tl]:"SHADOWMAP_TYPE_PCF",[Oo]:"SHADOWMAP_TYPE_VSM"};function MT(i){return bT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ST={[Bo]:"ENVMAP_MODE_REFRACTION"};function wT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":ST[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ET={[ih]:"ENVMAP_BLENDING_MULTIPLY",[Y0]:"ENVMAP_BLENDING_MIX",[Z0]:"ENVMAP_BLENDING_ADD"};function TT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":ET[i.combine]||"ENVMAP_BLENDING_NONE"}function AT(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=MT(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=wT(e),h=TT(e),d=pT(e),f=mT(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(cl).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(cl).join(`
`),m.length>0&&(m+=`
`)):(x=[F_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(cl).join(`
`),m=[F_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ss?"#define TONE_MAPPING":"",e.toneMapping!==ss?me.tonemapping_pars_fragment:"",e.toneMapping!==ss?dT("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,hT("linearToOutputTexel",e.outputColorSpace),fT(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(cl).join(`
`)),o=Bf(o),o=D_(o,e),o=N_(o,e),a=Bf(a),a=D_(a,e),a=N_(a,e),o=U_(o),a=U_(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===Sf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Sf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+x+o,M=g+m+a,b=P_(s,s.VERTEX_SHADER,y),R=P_(s,s.FRAGMENT_SHADER,M);s.attachShader(p,b),s.attachShader(p,R),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function w(D){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(b)||"",H=s.getShaderInfoLog(R)||"",N=I.trim(),F=G.trim(),q=H.trim(),V=!0,J=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,R);else{let Z=L_(s,b,"vertex"),K=L_(s,R,"fragment");re("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+N+`
`+Z+`
`+K)}else N!==""?jt("WebGLProgram: Program Info Log:",N):(F===""||q==="")&&(J=!1);J&&(D.diagnostics={runnable:V,programLog:N,vertexShader:{log:F,prefix:x},fragmentShader:{log:q,prefix:m}})}s.deleteShader(b),s.deleteShader(R),_=new Vo(s,p),E=gT(s,p)}let _;this.getUniforms=function(){return _===void 0&&w(this),_};let E;this.getAttributes=function(){return E===void 0&&w(this),E};let O=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(p,oT)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=aT++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=R,this}var CT=0,zf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Vf(t),e.set(t,n)),n}},Vf=class{constructor(t){this.id=CT++,this.code=t,this.usedTimes=0}};function RT(i){return i===sr||i===ol||i===al}function PT(i,t,e,n,s,r){let o=new Ro,a=new zf,c=new Set,l=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function p(_,E,O,D,I,G){let H=D.fog,N=I.geometry,F=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?D.environment:null,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||F,q),J=d[_.type],Z=n.precision;_.precision!==null&&(Z=n.getMaxPrecision(_.precision),Z!==_.precision&&jt("WebGLProgram.getParameters:",_.precision,"not supported, using",Z,"instead."));let K=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,W=K!==void 0?K.length:0,st=0;N.morphAttributes.position!==void 0&&(st=1),N.morphAttributes.normal!==void 0&&(st=2),N.morphAttributes.color!==void 0&&(st=3);let lt,j,pt,mt;if(J){let Ft=os[J];lt=Ft.vertexShader,j=Ft.fragmentShader}else{lt=_.vertexShader,j=_.fragmentShader;let Ft=a.getVertexShaderStage(_),fe=a.getFragmentShaderStage(_);a.update(_,Ft,fe),pt=Ft.id,mt=fe.id}let St=i.getRenderTarget(),bt=i.state.buffers.depth.getReversed(),$=I.isInstancedMesh===!0,ut=I.isBatchedMesh===!0,ft=!!_.map,yt=!!_.matcap,Nt=!!V,Ut=Nt&&V.isPMREMTexture===!0,te=!!_.aoMap,ee=!!_.lightMap,we=!!_.bumpMap&&_.wireframe===!1,ge=!!_.normalMap,ke=!!_.displacementMap,de=!!_.emissiveMap,Ge=!!_.metalnessMap,Je=!!_.roughnessMap,en=_.anisotropy>0,B=_.clearcoat>0,Rt=_.diffuseRoughness>0,Qt=_.dispersion>0,ue=_.retroreflectivity>0,Pt=_.iridescence>0,Be=_.sheen>0,Yt=_.transmission>0,Kt=en&&!!_.anisotropyMap,P=B&&!!_.clearcoatMap,S=B&&!!_.clearcoatNormalMap,Q=B&&!!_.clearcoatRoughnessMap,_t=Rt&&!!_.diffuseRoughnessMap,ht=Pt&&!!_.iridescenceMap,Et=Pt&&!!_.iridescenceThicknessMap,Tt=Be&&!!_.sheenColorMap,rt=Be&&!!_.sheenRoughnessMap,at=!!_.specularMap,vt=!!_.specularColorMap,z=!!_.specularIntensityMap,ct=Yt&&!!_.transmissionMap,ot=Yt&&!!_.thicknessMap,It=!!_.gradientMap,wt=!!_.alphaMap,Ct=_.alphaTest>0,Zt=!!_.alphaHash,ie=!!_.extensions,gt=ss;_.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(gt=i.toneMapping);let Xt=Ut?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,se={shaderID:J,shaderType:_.type,shaderName:_.name,vertexShader:lt,fragmentShader:j,defines:_.defines,customVertexShaderID:pt,customFragmentShaderID:mt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Z,batching:ut,batchingColor:ut&&I._colorsTexture!==null,instancing:$,instancingColor:$&&I.instanceColor!==null,instancingMorph:$&&I.morphTexture!==null,outputColorSpace:St===null?i.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:ft,matcap:yt,envMap:Nt,envMapMode:Nt&&V.mapping,envMapPMREM:Ut,envMapMaxLod:Ut?Xt.length-1:null,envMapSize:Ut?Xt[0].width:null,aoMap:te,lightMap:ee,bumpMap:we,normalMap:ge,displacementMap:ke,emissiveMap:de,normalMapObjectSpace:ge&&_.normalMapType===j0,normalMapTangentSpace:ge&&_.normalMapType===Hh,packedNormalMap:ge&&_.normalMapType===Hh&&RT(_.normalMap.format),metalnessMap:Ge,roughnessMap:Je,anisotropy:en,anisotropyMap:Kt,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:S,clearcoatRoughnessMap:Q,diffuseRoughness:Rt,diffuseRoughnessMap:_t,dispersion:Qt,retroreflection:ue,iridescence:Pt,iridescenceMap:ht,iridescenceThicknessMap:Et,sheen:Be,sheenColorMap:Tt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:z,transmission:Yt,transmissionMap:ct,thicknessMap:ot,gradientMap:It,opaque:_.transparent===!1&&_.blending===ko&&_.alphaToCoverage===!1,alphaMap:wt,alphaTest:Ct,alphaHash:Zt,combine:_.combine,mapUv:ft&&f(_.map.channel),aoMapUv:te&&f(_.aoMap.channel),lightMapUv:ee&&f(_.lightMap.channel),bumpMapUv:we&&f(_.bumpMap.channel),normalMapUv:ge&&f(_.normalMap.channel),displacementMapUv:ke&&f(_.displacementMap.channel),emissiveMapUv:de&&f(_.emissiveMap.channel),metalnessMapUv:Ge&&f(_.metalnessMap.channel),roughnessMapUv:Je&&f(_.roughnessMap.channel),anisotropyMapUv:Kt&&f(_.anisotropyMap.channel),clearcoatMapUv:P&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Q&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:_t&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ht&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:Et&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:Tt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(_.sheenRoughnessMap.channel),specularMapUv:at&&f(_.specularMap.channel),specularColorMapUv:vt&&f(_.specularColorMap.channel),specularIntensityMapUv:z&&f(_.specularIntensityMap.channel),transmissionMapUv:ct&&f(_.transmissionMap.channel),thicknessMapUv:ot&&f(_.thicknessMap.channel),alphaMapUv:wt&&f(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(ge||en),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(ft||wt),fog:!!H,useFog:_.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&ge===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:bt,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:W,morphTextureStride:st,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Ft=>Ft.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:gt,decodeVideoTexture:ft&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Ie,decodeVideoTextureEmissive:de&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Ie,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Si,flipSided:_.side===Zn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ie&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ie&&_.extensions.multiDraw===!0||ut)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return se.vertexUv1s=c.has(1),se.vertexUv2s=c.has(2),se.vertexUv3s=c.has(3),c.clear(),se}function x(_){let E=[];if(_.shaderID?E.push(_.shaderID):(E.push(_.customVertexShaderID),E.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)E.push(O),E.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(m(E,_),g(E,_),E.push(i.outputColorSpace)),E.push(_.customProgramCacheKey),E.join()}function m(_,E){_.push(E.precision),_.push(E.outputColorSpace),_.push(E.envMapMode),_.push(E.envMapPMREM),_.push(E.envMapMaxLod),_.push(E.envMapSize),_.push(E.mapUv),_.push(E.alphaMapUv),_.push(E.lightMapUv),_.push(E.aoMapUv),_.push(E.bumpMapUv),_.push(E.normalMapUv),_.push(E.displacementMapUv),_.push(E.emissiveMapUv),_.push(E.metalnessMapUv),_.push(E.roughnessMapUv),_.push(E.anisotropyMapUv),_.push(E.clearcoatMapUv),_.push(E.clearcoatNormalMapUv),_.push(E.clearcoatRoughnessMapUv),_.push(E.diffuseRoughnessMapUv),_.push(E.iridescenceMapUv),_.push(E.iridescenceThicknessMapUv),_.push(E.sheenColorMapUv),_.push(E.sheenRoughnessMapUv),_.push(E.specularMapUv),_.push(E.specularColorMapUv),_.push(E.specularIntensityMapUv),_.push(E.transmissionMapUv),_.push(E.thicknessMapUv),_.push(E.combine),_.push(E.fogExp2),_.push(E.sizeAttenuation),_.push(E.morphTargetsCount),_.push(E.numSunLights),_.push(E.numDirLights),_.push(E.numPointLights),_.push(E.numSpotLights),_.push(E.numSpotLightMaps),_.push(E.numHemiLights),_.push(E.numRectAreaLights),_.push(E.numSunLightShadows),_.push(E.numDirLightShadows),_.push(E.numPointLightShadows),_.push(E.numSpotLightShadows),_.push(E.numSpotLightShadowsWithMaps),_.push(E.numLightProbes),_.push(E.numLightProbeGrids),_.push(E.shadowMapType),_.push(E.toneMapping),_.push(E.numClippingPlanes),_.push(E.numClipIntersection),_.push(E.depthPacking)}function g(_,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let E=d[_.type],O;if(E){let D=os[E];O=__.clone(D.uniforms)}else O=_.uniforms;return O}function M(_,E){let O=u.get(E);return O!==void 0?++O.usedTimes:(O=new AT(i,E,_,s),l.push(O),u.set(E,O)),O}function b(_){if(--_.usedTimes===0){let E=l.indexOf(_);l[E]=l[l.length-1],l.pop(),u.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function w(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:y,acquireProgram:M,releaseProgram:b,releaseShaderCache:R,programs:l,dispose:w}}function IT(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function LT(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function O_(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function k_(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let y=i[t];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},i[t]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=m,y.group=g),t++,y}function c(d,f,p,x,m,g,y){y.reversedDepth===!0&&(m=-m);let M=a(d,f,p,x,m,g);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):e.push(M)}function l(d,f,p,x,m,g){let y=a(d,f,p,x,m,g);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):e.unshift(y)}function u(d,f){e.length>1&&e.sort(d||LT),n.length>1&&n.sort(f||O_),s.length>1&&s.sort(f||O_)}function h(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:h,sort:u}}function DT(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new k_,i.set(n,[o])):s>=r.length?(o=new k_,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function NT(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new k,color:new he};break;case"SpotLight":e={position:new k,direction:new k,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new k,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new k,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new k,halfWidth:new k,halfHeight:new k};break}return i[t.id]=e,e}}}function UT(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var FT=0;function OT(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function kT(i){let t=new NT,e=UT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new k);let s=new k,r=new Fe,o=new Fe;function a(l){let u=0,h=0,d=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,y=0,M=0,b=0,R=0,w=0,_=0,E=0,O=0,D=0;l.sort(OT);for(let G=0,H=l.length;G<H;G++){let N=l[G],F=N.color,q=N.intensity,V=N.distance,J=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===sr?J=N.shadow.map.texture:J=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=F.r*q,h+=F.g*q,d+=F.b*q;else if(N.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(N.sh.coefficients[Z],q);D++}else if(N.isSunLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,W=e.get(N);W.shadowIntensity=K.intensity,W.shadowBias=K.bias,W.shadowNormalBias=K.normalBias,W.shadowRadius=K.radius,W.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),n.sunShadow[p]=W,n.sunShadowMap[p]=J;let st=K.getViewportCount();for(let lt=0;lt<st;lt++)n.sunShadowMatrix[x+lt]=K.getMatrix(lt),n.sunShadowCascade[x+lt]=K._cascadeData[lt];x+=st,p++}n.sun[f]=Z,f++}else if(N.isDirectionalLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,W=e.get(N);W.shadowIntensity=K.intensity,W.shadowBias=K.bias,W.shadowNormalBias=K.normalBias,W.shadowRadius=K.radius,W.shadowMapSize=K.mapSize,n.directionalShadow[m]=W,n.directionalShadowMap[m]=J,n.directionalShadowMatrix[m]=N.shadow.matrix,R++}n.directional[m]=Z,m++}else if(N.isSpotLight){let Z=t.get(N);Z.position.setFromMatrixPosition(N.matrixWorld),Z.color.copy(F).multiplyScalar(q),Z.distance=V,Z.coneCos=Math.cos(N.angle),Z.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Z.decay=N.decay,n.spot[y]=Z;let K=N.shadow;if(N.map&&(n.spotLightMap[E]=N.map,E++,K.updateMatrices(N),N.castShadow&&O++),n.spotLightMatrix[y]=K.matrix,N.castShadow){let W=e.get(N);W.shadowIntensity=K.intensity,W.shadowBias=K.bias,W.shadowNormalBias=K.normalBias,W.shadowRadius=K.radius,W.shadowMapSize=K.mapSize,n.spotShadow[y]=W,n.spotShadowMap[y]=J,_++}y++}else if(N.isRectAreaLight){let Z=t.get(N);Z.color.copy(F).multiplyScalar(q),Z.halfWidth.set(N.width*.5,0,0),Z.halfHeight.set(0,N.height*.5,0),n.rectArea[M]=Z,M++}else if(N.isPointLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),Z.distance=N.distance,Z.decay=N.decay,N.castShadow){let K=N.shadow,W=e.get(N);W.shadowIntensity=K.intensity,W.shadowBias=K.bias,W.shadowNormalBias=K.normalBias,W.shadowRadius=K.radius,W.shadowMapSize=K.mapSize,W.shadowCameraNear=K.camera.near,W.shadowCameraFar=K.camera.far,n.pointShadow[g]=W,n.pointShadowMap[g]=J,n.pointShadowMatrix[g]=N.shadow.matrix,w++}n.point[g]=Z,g++}else if(N.isHemisphereLight){let Z=t.get(N);Z.skyColor.copy(N.color).multiplyScalar(q),Z.groundColor.copy(N.groundColor).multiplyScalar(q),n.hemi[b]=Z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=zt.LTC_FLOAT_1,n.rectAreaLTC2=zt.LTC_FLOAT_2):(n.rectAreaLTC1=zt.LTC_HALF_1,n.rectAreaLTC2=zt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let I=n.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==y||I.rectAreaLength!==M||I.hemiLength!==b||I.numSunShadows!==p||I.numDirectionalShadows!==R||I.numPointShadows!==w||I.numSpotShadows!==_||I.numSpotMaps!==E||I.numLightProbes!==D)&&(n.sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=M,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+E-O,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=D,I.sunLength=f,I.directionalLength=m,I.pointLength=g,I.spotLength=y,I.rectAreaLength=M,I.hemiLength=b,I.numSunShadows=p,I.numDirectionalShadows=R,I.numPointShadows=w,I.numSpotShadows=_,I.numSpotMaps=E,I.numLightProbes=D,n.version=FT++)}function c(l,u){let h=0,d=0,f=0,p=0,x=0,m=0,g=u.matrixWorldInverse;for(let y=0,M=l.length;y<M;y++){let b=l[y];if(b.isSunLight){let R=n.sun[h];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),d++}else if(b.isSpotLight){let R=n.spot[p];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let R=n.rectArea[x];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),R.halfWidth.set(b.width*.5,0,0),R.halfHeight.set(0,b.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(g),m++}}}return{setup:a,setupView:c,state:n}}function B_(i){let t=new kT(i),e=[],n=[],s=[];function r(h){u.camera=h,e.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){n.push(h)}function c(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function l(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function BT(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new B_(i),t.set(s,[a])):r>=o.length?(a=new B_(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var zT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,VT=`uniform sampler2D shadow_pass;
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
}`,GT=[new k(1,0,0),new k(-1,0,0),new k(0,1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1)],HT=[new k(0,-1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1),new k(0,-1,0),new k(0,-1,0)],z_=new Fe,ll=new k,Uf=new k;function WT(i,t,e){let n=new Zs,s=new Ot,r=new Ot,o=new je,a=new Hc,c=new Wc,l={},u=e.maxTextureSize,h={[ir]:Zn,[Zn]:ir,[Si]:Si},d=new is({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ot},radius:{value:4}},vertexShader:zT,fragmentShader:VT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ze;p.setAttribute("position",new es(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Le(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=tl;let g=this.type;this.render=function(w,_,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===R0&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=tl);let O=i.getRenderTarget(),D=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),G=i.state;G.setBlending(Ar),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=g!==this.type;H&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(F=>F.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,F=w.length;N<F;N++){let q=w[N],V=q.shadow;if(V===void 0){jt("WebGLShadowMap:",q,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let J=V.getFrameExtents();s.multiply(J),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/J.x),s.x=r.x*J.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/J.y),s.y=r.y*J.y,V.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=Z,V.map===null||H===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Oo){if(q.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new ui(s.x,s.y,{format:sr,type:Bi,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),V.map.texture.name=q.name+".shadowMap",V.map.depthTexture=new ws(s.x,s.y,ki),V.map.depthTexture.name=q.name+".shadowMapDepth",V.map.depthTexture.format=Ms,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Cn,V.map.depthTexture.magFilter=Cn}else q.isPointLight?(V.map=new hl(s.x),V.map.depthTexture=new Ia(s.x,Oi)):(V.map=new ui(s.x,s.y),V.map.depthTexture=new ws(s.x,s.y,Oi)),V.map.depthTexture.name=q.name+".shadowMap",V.map.depthTexture.format=Ms,this.type===tl?(V.map.depthTexture.compareFunction=Z?bf:vf,V.map.depthTexture.minFilter=Yn,V.map.depthTexture.magFilter=Yn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Cn,V.map.depthTexture.magFilter=Cn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let K=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();q.isPointLight!==!0&&V.updateMatrices(q,E);let W=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:E.layers;for(let st=0;st<K;st++){let lt=V.getCamera(st);if(q.isPointLight){let j=V.camera,pt=V.matrix,mt=q.distance||j.far;mt!==j.far&&(j.far=mt,j.updateProjectionMatrix()),ll.setFromMatrixPosition(q.matrixWorld),j.position.copy(ll),Uf.copy(j.position),Uf.add(GT[st]),j.up.copy(HT[st]),j.lookAt(Uf),j.updateMatrixWorld(),pt.makeTranslation(-ll.x,-ll.y,-ll.z),z_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),V._frustum.setFromProjectionMatrix(z_,j.coordinateSystem,j.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,st),i.clear();else{st===0&&(i.setRenderTarget(V.map),i.clear());let j=V.getViewport(st);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),G.viewport(o)}n=V.getFrustum(st),b(_,E,lt,q,W,this.type)}V.isPointLightShadow!==!0&&this.type===Oo&&y(V,E),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(O,D,I)};function y(w,_){let E=t.update(x);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new ui(s.x,s.y,{format:sr,type:Bi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(_,null,E,d,x,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(_,null,E,f,x,null)}function M(w,_,E,O){let D=null,I=E.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(I!==void 0)D=I;else if(D=E.isPointLight===!0?c:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let G=D.uuid,H=_.uuid,N=l[G];N===void 0&&(N={},l[G]=N);let F=N[H];F===void 0&&(F=D.clone(),N[H]=F,_.addEventListener("dispose",R)),D=F}if(D.visible=_.visible,D.wireframe=_.wireframe,O===Oo?D.side=_.shadowSide!==null?_.shadowSide:_.side:D.side=_.shadowSide!==null?_.shadowSide:h[_.side],D.alphaMap=_.alphaMap,D.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,D.map=_.map,D.clipShadows=_.clipShadows,D.clippingPlanes=_.clippingPlanes,D.clipIntersection=_.clipIntersection,D.displacementMap=_.displacementMap,D.displacementScale=_.displacementScale,D.displacementBias=_.displacementBias,D.wireframeLinewidth=_.wireframeLinewidth,D.linewidth=_.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let G=i.properties.get(D);G.light=E}return D}function b(w,_,E,O,D,I){if(w.visible===!1)return;if(w.layers.test(D)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&I===Oo)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,w.matrixWorld);let N=t.update(w),F=w.material;if(Array.isArray(F)){let q=N.groups;for(let V=0,J=q.length;V<J;V++){let Z=q[V],K=F[Z.materialIndex];if(K&&K.visible){let W=M(w,K,O,I);w.onBeforeShadow(i,w,_,E,N,W,Z),i.renderBufferDirect(E,null,N,W,w,Z),w.onAfterShadow(i,w,_,E,N,W,Z)}}}else if(F.visible){let q=M(w,F,O,I);w.onBeforeShadow(i,w,_,E,N,q,null),i.renderBufferDirect(E,null,N,q,w,null),w.onAfterShadow(i,w,_,E,N,q,null)}}let H=w.children;for(let N=0,F=H.length;N<F;N++)b(H[N],_,E,O,D,I)}function R(w){w.target.removeEventListener("dispose",R);for(let E in l){let O=l[E],D=w.target.uuid;D in O&&(O[D].dispose(),delete O[D])}}}function XT(i,t){function e(){let z=!1,ct=new je,ot=null,It=new je(0,0,0,0);return{setMask:function(wt){ot!==wt&&!z&&(i.colorMask(wt,wt,wt,wt),ot=wt)},setLocked:function(wt){z=wt},setClear:function(wt,Ct,Zt,ie,gt){gt===!0&&(wt*=ie,Ct*=ie,Zt*=ie),ct.set(wt,Ct,Zt,ie),It.equals(ct)===!1&&(i.clearColor(wt,Ct,Zt,ie),It.copy(ct))},reset:function(){z=!1,ot=null,It.set(-1,0,0,0)}}}function n(){let z=!1,ct=!1,ot=null,It=null,wt=null;return{setReversed:function(Ct){if(ct!==Ct){let Zt=t.get("EXT_clip_control");Ct?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),ct=Ct;let ie=wt;wt=null,this.setClear(ie)}},getReversed:function(){return ct},setTest:function(Ct){Ct?bt(i.DEPTH_TEST):$(i.DEPTH_TEST)},setMask:function(Ct){ot!==Ct&&!z&&(i.depthMask(Ct),ot=Ct)},setFunc:function(Ct){if(ct&&(Ct=c_[Ct]),It!==Ct){switch(Ct){case yc:i.depthFunc(i.NEVER);break;case vc:i.depthFunc(i.ALWAYS);break;case bc:i.depthFunc(i.LESS);break;case wo:i.depthFunc(i.LEQUAL);break;case Mc:i.depthFunc(i.EQUAL);break;case Sc:i.depthFunc(i.GEQUAL);break;case wc:i.depthFunc(i.GREATER);break;case Ec:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}It=Ct}},setLocked:function(Ct){z=Ct},setClear:function(Ct){wt!==Ct&&(wt=Ct,ct&&(Ct=1-Ct),i.clearDepth(Ct))},reset:function(){z=!1,ot=null,It=null,wt=null,ct=!1}}}function s(){let z=!1,ct=null,ot=null,It=null,wt=null,Ct=null,Zt=null,ie=null,gt=null;return{setTest:function(Xt){z||(Xt?bt(i.STENCIL_TEST):$(i.STENCIL_TEST))},setMask:function(Xt){ct!==Xt&&!z&&(i.stencilMask(Xt),ct=Xt)},setFunc:function(Xt,se,Ft){(ot!==Xt||It!==se||wt!==Ft)&&(i.stencilFunc(Xt,se,Ft),ot=Xt,It=se,wt=Ft)},setOp:function(Xt,se,Ft){(Ct!==Xt||Zt!==se||ie!==Ft)&&(i.stencilOp(Xt,se,Ft),Ct=Xt,Zt=se,ie=Ft)},setLocked:function(Xt){z=Xt},setClear:function(Xt){gt!==Xt&&(i.clearStencil(Xt),gt=Xt)},reset:function(){z=!1,ct=null,ot=null,It=null,wt=null,Ct=null,Zt=null,ie=null,gt=null}}}let r=new e,o=new n,a=new s,c={},l=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,M=null,b=null,R=null,w=null,_=null,E=new he(0,0,0),O=0,D=!1,I=null,G=null,H=null,N=null,F=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,J=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(Z)[1]),V=J>=1):Z.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),V=J>=2);let K=null,W={},st=i.getParameter(i.SCISSOR_BOX),lt=i.getParameter(i.VIEWPORT),j=new je().fromArray(st),pt=new je().fromArray(lt);function mt(z,ct,ot,It){let wt=new Uint8Array(4),Ct=i.createTexture();i.bindTexture(z,Ct),i.texParameteri(z,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(z,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Zt=0;Zt<ot;Zt++)z===i.TEXTURE_3D||z===i.TEXTURE_2D_ARRAY?i.texImage3D(ct,0,i.RGBA,1,1,It,0,i.RGBA,i.UNSIGNED_BYTE,wt):i.texImage2D(ct+Zt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,wt);return Ct}let St={};St[i.TEXTURE_2D]=mt(i.TEXTURE_2D,i.TEXTURE_2D,1),St[i.TEXTURE_CUBE_MAP]=mt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[i.TEXTURE_2D_ARRAY]=mt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),St[i.TEXTURE_3D]=mt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),bt(i.DEPTH_TEST),o.setFunc(wo),we(!1),ge(jd),bt(i.CULL_FACE),te(Ar);function bt(z){u[z]!==!0&&(i.enable(z),u[z]=!0)}function $(z){u[z]!==!1&&(i.disable(z),u[z]=!1)}function ut(z,ct){return d[z]!==ct?(i.bindFramebuffer(z,ct),d[z]=ct,z===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=ct),z===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=ct),!0):!1}function ft(z,ct){let ot=p,It=!1;if(z){ot=f.get(ct),ot===void 0&&(ot=[],f.set(ct,ot));let wt=z.textures;if(ot.length!==wt.length||ot[0]!==i.COLOR_ATTACHMENT0){for(let Ct=0,Zt=wt.length;Ct<Zt;Ct++)ot[Ct]=i.COLOR_ATTACHMENT0+Ct;ot.length=wt.length,It=!0}}else ot[0]!==i.BACK&&(ot[0]=i.BACK,It=!0);It&&i.drawBuffers(ot)}function yt(z){return x!==z?(i.useProgram(z),x=z,!0):!1}let Nt={[Cr]:i.FUNC_ADD,[I0]:i.FUNC_SUBTRACT,[L0]:i.FUNC_REVERSE_SUBTRACT};Nt[D0]=i.MIN,Nt[N0]=i.MAX;let Ut={[U0]:i.ZERO,[F0]:i.ONE,[O0]:i.SRC_COLOR,[nf]:i.SRC_ALPHA,[H0]:i.SRC_ALPHA_SATURATE,[V0]:i.DST_COLOR,[B0]:i.DST_ALPHA,[k0]:i.ONE_MINUS_SRC_COLOR,[sf]:i.ONE_MINUS_SRC_ALPHA,[G0]:i.ONE_MINUS_DST_COLOR,[z0]:i.ONE_MINUS_DST_ALPHA,[W0]:i.CONSTANT_COLOR,[X0]:i.ONE_MINUS_CONSTANT_COLOR,[$0]:i.CONSTANT_ALPHA,[q0]:i.ONE_MINUS_CONSTANT_ALPHA};function te(z,ct,ot,It,wt,Ct,Zt,ie,gt,Xt){if(z===Ar){m===!0&&($(i.BLEND),m=!1);return}if(m===!1&&(bt(i.BLEND),m=!0),z!==P0){if(z!==g||Xt!==D){if((y!==Cr||R!==Cr)&&(i.blendEquation(i.FUNC_ADD),y=Cr,R=Cr),Xt)switch(z){case ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Qd:i.blendFunc(i.ONE,i.ONE);break;case tf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ef:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:re("WebGLState: Invalid blending: ",z);break}else switch(z){case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Qd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case tf:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ef:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",z);break}M=null,b=null,w=null,_=null,E.set(0,0,0),O=0,g=z,D=Xt}return}wt=wt||ct,Ct=Ct||ot,Zt=Zt||It,(ct!==y||wt!==R)&&(i.blendEquationSeparate(Nt[ct],Nt[wt]),y=ct,R=wt),(ot!==M||It!==b||Ct!==w||Zt!==_)&&(i.blendFuncSeparate(Ut[ot],Ut[It],Ut[Ct],Ut[Zt]),M=ot,b=It,w=Ct,_=Zt),(ie.equals(E)===!1||gt!==O)&&(i.blendColor(ie.r,ie.g,ie.b,gt),E.copy(ie),O=gt),g=z,D=!1}function ee(z,ct){z.side===Si?$(i.CULL_FACE):bt(i.CULL_FACE);let ot=z.side===Zn;ct&&(ot=!ot),we(ot),z.blending===ko&&z.transparent===!1?te(Ar):te(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let It=z.stencilWrite;a.setTest(It),It&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),de(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?bt(i.SAMPLE_ALPHA_TO_COVERAGE):$(i.SAMPLE_ALPHA_TO_COVERAGE)}function we(z){I!==z&&(z?i.frontFace(i.CW):i.frontFace(i.CCW),I=z)}function ge(z){z!==A0?(bt(i.CULL_FACE),z!==G&&(z===jd?i.cullFace(i.BACK):z===C0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$(i.CULL_FACE),G=z}function ke(z){z!==H&&(V&&i.lineWidth(z),H=z)}function de(z,ct,ot){z?(bt(i.POLYGON_OFFSET_FILL),(N!==ct||F!==ot)&&(N=ct,F=ot,o.getReversed()&&(ct=-ct,ot=-ot),i.polygonOffset(ct,ot))):$(i.POLYGON_OFFSET_FILL)}function Ge(z){z?bt(i.SCISSOR_TEST):$(i.SCISSOR_TEST)}function Je(z){z===void 0&&(z=i.TEXTURE0+q-1),K!==z&&(i.activeTexture(z),K=z)}function en(z,ct,ot){ot===void 0&&(K===null?ot=i.TEXTURE0+q-1:ot=K);let It=W[ot];It===void 0&&(It={type:void 0,texture:void 0},W[ot]=It),(It.type!==z||It.texture!==ct)&&(K!==ot&&(i.activeTexture(ot),K=ot),i.bindTexture(z,ct||St[z]),It.type=z,It.texture=ct)}function B(){let z=W[K];z!==void 0&&z.type!==void 0&&(i.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Rt(){try{i.compressedTexImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function Qt(){try{i.compressedTexImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function ue(){try{i.texSubImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function Pt(){try{i.texSubImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function Be(){try{i.compressedTexSubImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function Yt(){try{i.compressedTexSubImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function Kt(){try{i.texStorage2D(...arguments)}catch(z){re("WebGLState:",z)}}function P(){try{i.texStorage3D(...arguments)}catch(z){re("WebGLState:",z)}}function S(){try{i.texImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function Q(){try{i.texImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function _t(z){return h[z]!==void 0?h[z]:i.getParameter(z)}function ht(z,ct){h[z]!==ct&&(i.pixelStorei(z,ct),h[z]=ct)}function Et(z){j.equals(z)===!1&&(i.scissor(z.x,z.y,z.z,z.w),j.copy(z))}function Tt(z){pt.equals(z)===!1&&(i.viewport(z.x,z.y,z.z,z.w),pt.copy(z))}function rt(z,ct){let ot=l.get(ct);ot===void 0&&(ot=new WeakMap,l.set(ct,ot));let It=ot.get(z);It===void 0&&(It=i.getUniformBlockIndex(ct,z.name),i.uniformBlockBinding(ct,It,It),ot.set(z,It))}function at(z,ct,ot){let wt=l.get(ct).get(z);c[wt]!==ot&&(i.bindBufferBase(i.UNIFORM_BUFFER,wt,ot),c[wt]=ot)}function vt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},K=null,W={},d={},c={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,M=null,b=null,R=null,w=null,_=null,E=new he(0,0,0),O=0,D=!1,I=null,G=null,H=null,N=null,F=null,j.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:bt,disable:$,bindFramebuffer:ut,drawBuffers:ft,useProgram:yt,setBlending:te,setMaterial:ee,setFlipSided:we,setCullFace:ge,setLineWidth:ke,setPolygonOffset:de,setScissorTest:Ge,activeTexture:Je,bindTexture:en,unbindTexture:B,compressedTexImage2D:Rt,compressedTexImage3D:Qt,texImage2D:S,texImage3D:Q,pixelStorei:ht,getParameter:_t,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:Kt,texStorage3D:P,texSubImage2D:ue,texSubImage3D:Pt,compressedTexSubImage2D:Be,compressedTexSubImage3D:Yt,scissor:Et,viewport:Tt,reset:vt}}function $T(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ot,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(P=>p.delete(P)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,S){return m?new OffscreenCanvas(P,S):Sa("canvas")}function y(P,S,Q){let _t=1,ht=Kt(P);if((ht.width>Q||ht.height>Q)&&(_t=Q/Math.max(ht.width,ht.height)),_t<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let Et=Math.floor(_t*ht.width),Tt=Math.floor(_t*ht.height);d===void 0&&(d=g(Et,Tt));let rt=S?g(Et,Tt):d;return rt.width=Et,rt.height=Tt,rt.getContext("2d").drawImage(P,0,0,Et,Tt),jt("WebGLRenderer: Texture has been resized from ("+ht.width+"x"+ht.height+") to ("+Et+"x"+Tt+")."),rt}else return"data"in P&&jt("WebGLRenderer: Image in DataTexture is too big ("+ht.width+"x"+ht.height+")."),P;return P}function M(P){return P.generateMipmaps}function b(P){i.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(P,S,Q,_t,ht,Et=!1){if(P!==null){if(i[P]!==void 0)return i[P];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let Tt;_t&&(Tt=t.get("EXT_texture_norm16"),Tt||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=S;if(S===i.RED&&(Q===i.FLOAT&&(rt=i.R32F),Q===i.HALF_FLOAT&&(rt=i.R16F),Q===i.UNSIGNED_BYTE&&(rt=i.R8),Q===i.UNSIGNED_SHORT&&Tt&&(rt=Tt.R16_EXT),Q===i.SHORT&&Tt&&(rt=Tt.R16_SNORM_EXT)),S===i.RED_INTEGER&&(Q===i.UNSIGNED_BYTE&&(rt=i.R8UI),Q===i.UNSIGNED_SHORT&&(rt=i.R16UI),Q===i.UNSIGNED_INT&&(rt=i.R32UI),Q===i.BYTE&&(rt=i.R8I),Q===i.SHORT&&(rt=i.R16I),Q===i.INT&&(rt=i.R32I)),S===i.RG&&(Q===i.FLOAT&&(rt=i.RG32F),Q===i.HALF_FLOAT&&(rt=i.RG16F),Q===i.UNSIGNED_BYTE&&(rt=i.RG8),Q===i.UNSIGNED_SHORT&&Tt&&(rt=Tt.RG16_EXT),Q===i.SHORT&&Tt&&(rt=Tt.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(Q===i.UNSIGNED_BYTE&&(rt=i.RG8UI),Q===i.UNSIGNED_SHORT&&(rt=i.RG16UI),Q===i.UNSIGNED_INT&&(rt=i.RG32UI),Q===i.BYTE&&(rt=i.RG8I),Q===i.SHORT&&(rt=i.RG16I),Q===i.INT&&(rt=i.RG32I)),S===i.RGB_INTEGER&&(Q===i.UNSIGNED_BYTE&&(rt=i.RGB8UI),Q===i.UNSIGNED_SHORT&&(rt=i.RGB16UI),Q===i.UNSIGNED_INT&&(rt=i.RGB32UI),Q===i.BYTE&&(rt=i.RGB8I),Q===i.SHORT&&(rt=i.RGB16I),Q===i.INT&&(rt=i.RGB32I)),S===i.RGBA_INTEGER&&(Q===i.UNSIGNED_BYTE&&(rt=i.RGBA8UI),Q===i.UNSIGNED_SHORT&&(rt=i.RGBA16UI),Q===i.UNSIGNED_INT&&(rt=i.RGBA32UI),Q===i.BYTE&&(rt=i.RGBA8I),Q===i.SHORT&&(rt=i.RGBA16I),Q===i.INT&&(rt=i.RGBA32I)),S===i.RGB&&(Q===i.UNSIGNED_SHORT&&Tt&&(rt=Tt.RGB16_EXT),Q===i.SHORT&&Tt&&(rt=Tt.RGB16_SNORM_EXT),Q===i.UNSIGNED_INT_5_9_9_9_REV&&(rt=i.RGB9_E5),Q===i.UNSIGNED_INT_10F_11F_11F_REV&&(rt=i.R11F_G11F_B10F)),S===i.RGBA){let at=Et?Ma:Se.getTransfer(ht);Q===i.FLOAT&&(rt=i.RGBA32F),Q===i.HALF_FLOAT&&(rt=i.RGBA16F),Q===i.UNSIGNED_BYTE&&(rt=at===Ie?i.SRGB8_ALPHA8:i.RGBA8),Q===i.UNSIGNED_SHORT&&Tt&&(rt=Tt.RGBA16_EXT),Q===i.SHORT&&Tt&&(rt=Tt.RGBA16_SNORM_EXT),Q===i.UNSIGNED_SHORT_4_4_4_4&&(rt=i.RGBA4),Q===i.UNSIGNED_SHORT_5_5_5_1&&(rt=i.RGB5_A1)}return(rt===i.R16F||rt===i.R32F||rt===i.RG16F||rt===i.RG32F||rt===i.RGBA16F||rt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function _(P,S){let Q;return P?S===null||S===Oi||S===Pr?Q=i.DEPTH24_STENCIL8:S===ki?Q=i.DEPTH32F_STENCIL8:S===zo&&(Q=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Oi||S===Pr?Q=i.DEPTH_COMPONENT24:S===ki?Q=i.DEPTH_COMPONENT32F:S===zo&&(Q=i.DEPTH_COMPONENT16),Q}function E(P,S){return M(P)===!0||P.isFramebufferTexture&&P.minFilter!==Cn&&P.minFilter!==Yn?Math.log2(Math.max(S.width,S.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?S.mipmaps.length:1}function O(P){let S=new WeakRef(P);n.get(P).__ref=S,p.add(S),x.register(P,S,S)}function D(P){let S=n.get(P).__ref;S!==void 0&&(p.delete(S),x.unregister(S))}function I(P){H(P.target)}function G(P){N(P.target)}function H(P){P.removeEventListener("dispose",I),D(P),q(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&h.delete(P)}function N(P){P.removeEventListener("dispose",G),D(P),J(P)}function F(){for(let P of p){let S=P.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):H(S))}p.clear(),h.clear()}function q(P){let S=n.get(P);if(S.__webglInit===void 0)return;let Q=P.source,_t=f.get(Q);if(_t){let ht=_t[S.__cacheKey];ht.usedTimes--,ht.usedTimes===0&&V(P),Object.keys(_t).length===0&&f.delete(Q)}n.remove(P)}function V(P){let S=n.get(P);i.deleteTexture(S.__webglTexture);let Q=P.source,_t=f.get(Q);delete _t[S.__cacheKey],o.memory.textures--}function J(P){let S=n.get(P);S.__depthDisposeCallback&&S.__depthDisposeCallback();let Q=P.depthTexture;if(Q&&Q.renderTarget===P&&H(Q),P.isWebGLCubeRenderTarget)for(let ht=0;ht<6;ht++){if(Array.isArray(S.__webglFramebuffer[ht]))for(let Et=0;Et<S.__webglFramebuffer[ht].length;Et++)i.deleteFramebuffer(S.__webglFramebuffer[ht][Et]);else i.deleteFramebuffer(S.__webglFramebuffer[ht]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ht])}else{if(Array.isArray(S.__webglFramebuffer))for(let ht=0;ht<S.__webglFramebuffer.length;ht++)i.deleteFramebuffer(S.__webglFramebuffer[ht]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ht=0;ht<S.__webglColorRenderbuffer.length;ht++)S.__webglColorRenderbuffer[ht]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ht]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let _t=P.textures;for(let ht=0,Et=_t.length;ht<Et;ht++){let Tt=n.get(_t[ht]);Tt.__webglTexture&&(i.deleteTexture(Tt.__webglTexture),o.memory.textures--),n.remove(_t[ht])}n.remove(P)}let Z=0;function K(){Z=0}function W(){return Z}function st(P){Z=P}function lt(){let P=Z;return P>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function j(P){let S=[];return S.push(P.wrapS),S.push(P.wrapT),S.push(P.wrapR||0),S.push(P.magFilter),S.push(P.minFilter),S.push(P.anisotropy),S.push(P.internalFormat),S.push(P.format),S.push(P.type),S.push(P.generateMipmaps),S.push(P.mipmapsAutoUpdate),S.push(P.premultiplyAlpha),S.push(P.flipY),S.push(P.unpackAlignment),S.push(P.colorSpace),S.join()}function pt(P,S){let Q=n.get(P);if(P.isVideoTexture&&Be(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&Q.__version!==P.version){let _t=P.image;if(_t===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(_t.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{ee(Q,P,S);return}}else P.isExternalTexture&&(Q.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,Q.__webglTexture,i.TEXTURE0+S)}function mt(P,S){let Q=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Q.__version!==P.version){ee(Q,P,S);return}else P.isExternalTexture&&(Q.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,Q.__webglTexture,i.TEXTURE0+S)}function St(P,S){let Q=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Q.__version!==P.version){ee(Q,P,S);return}e.bindTexture(i.TEXTURE_3D,Q.__webglTexture,i.TEXTURE0+S)}function bt(P,S){let Q=n.get(P);if(P.version>0&&Q.__version!==P.version){we(Q,P,S);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Q.__webglTexture,i.TEXTURE0+S)}let $={[Tc]:i.REPEAT,[ts]:i.CLAMP_TO_EDGE,[Ac]:i.MIRRORED_REPEAT},ut={[Cn]:i.NEAREST,[J0]:i.NEAREST_MIPMAP_NEAREST,[el]:i.NEAREST_MIPMAP_LINEAR,[Yn]:i.LINEAR,[oh]:i.LINEAR_MIPMAP_NEAREST,[Ts]:i.LINEAR_MIPMAP_LINEAR},ft={[t_]:i.NEVER,[Mf]:i.ALWAYS,[e_]:i.LESS,[vf]:i.LEQUAL,[n_]:i.EQUAL,[bf]:i.GEQUAL,[i_]:i.GREATER,[s_]:i.NOTEQUAL};function yt(P,S){if(S.type===ki&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Yn||S.magFilter===oh||S.magFilter===el||S.magFilter===Ts||S.minFilter===Yn||S.minFilter===oh||S.minFilter===el||S.minFilter===Ts)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,$[S.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,$[S.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,$[S.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ut[S.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ut[S.minFilter]),S.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,ft[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Cn||S.minFilter!==el&&S.minFilter!==Ts||S.type===ki&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let Q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,Q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function Nt(P,S){let Q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,S.addEventListener("dispose",I),O(S));let _t=S.source,ht=f.get(_t);ht===void 0&&(ht={},f.set(_t,ht));let Et=j(S);if(Et!==P.__cacheKey){ht[Et]===void 0&&(ht[Et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Q=!0),ht[Et].usedTimes++;let Tt=ht[P.__cacheKey];Tt!==void 0&&(ht[P.__cacheKey].usedTimes--,Tt.usedTimes===0&&V(S)),P.__cacheKey=Et,P.__webglTexture=ht[Et].texture}return Q}function Ut(P,S,Q){return Math.floor(Math.floor(P/Q)/S)}function te(P,S,Q,_t){let Et=P.updateRanges;if(Et.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,Q,_t,S.data);else{Et.sort((z,ct)=>z.start-ct.start);let Tt=0;for(let z=1;z<Et.length;z++){let ct=Et[Tt],ot=Et[z],It=ct.start+ct.count,wt=Ut(ot.start,S.width,4),Ct=Ut(ct.start,S.width,4);ot.start<=It+1&&wt===Ct&&Ut(ot.start+ot.count-1,S.width,4)===wt?ct.count=Math.max(ct.count,ot.start+ot.count-ct.start):(++Tt,Et[Tt]=ot)}Et.length=Tt+1;let rt=e.getParameter(i.UNPACK_ROW_LENGTH),at=e.getParameter(i.UNPACK_SKIP_PIXELS),vt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let z=0,ct=Et.length;z<ct;z++){let ot=Et[z],It=Math.floor(ot.start/4),wt=Math.ceil(ot.count/4),Ct=It%S.width,Zt=Math.floor(It/S.width),ie=wt,gt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,Ct),e.pixelStorei(i.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(i.TEXTURE_2D,0,Ct,Zt,ie,gt,Q,_t,S.data)}P.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,rt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,at),e.pixelStorei(i.UNPACK_SKIP_ROWS,vt)}}function ee(P,S,Q){let _t=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(_t=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(_t=i.TEXTURE_3D);let ht=Nt(P,S),Et=S.source;e.bindTexture(_t,P.__webglTexture,i.TEXTURE0+Q);let Tt=n.get(Et);if(Et.version!==Tt.__version||ht===!0){if(e.activeTexture(i.TEXTURE0+Q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let gt=Se.getPrimaries(Se.workingColorSpace),Xt=S.colorSpace===Cs?null:Se.getPrimaries(S.colorSpace),se=S.colorSpace===Cs||gt===Xt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se)}e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let at=y(S.image,!1,s.maxTextureSize);at=Yt(S,at);let vt=r.convert(S.format,S.colorSpace),z=r.convert(S.type),ct=w(S.internalFormat,vt,z,S.normalized,S.colorSpace,S.isVideoTexture);yt(_t,S);let ot,It=S.mipmaps,wt=S.isVideoTexture!==!0,Ct=Tt.__version===void 0||ht===!0,Zt=Et.dataReady,ie=E(S,at);if(S.isDepthTexture)ct=_(S.format===As,S.type),Ct&&(wt?e.texStorage2D(i.TEXTURE_2D,1,ct,at.width,at.height):e.texImage2D(i.TEXTURE_2D,0,ct,at.width,at.height,0,vt,z,null));else if(S.isDataTexture)if(It.length>0){wt&&Ct&&e.texStorage2D(i.TEXTURE_2D,ie,ct,It[0].width,It[0].height);for(let gt=0,Xt=It.length;gt<Xt;gt++)ot=It[gt],wt?Zt&&e.texSubImage2D(i.TEXTURE_2D,gt,0,0,ot.width,ot.height,vt,z,ot.data):e.texImage2D(i.TEXTURE_2D,gt,ct,ot.width,ot.height,0,vt,z,ot.data);S.generateMipmaps=!1}else wt?(Ct&&e.texStorage2D(i.TEXTURE_2D,ie,ct,at.width,at.height),Zt&&te(S,at,vt,z)):e.texImage2D(i.TEXTURE_2D,0,ct,at.width,at.height,0,vt,z,at.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){wt&&Ct&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ie,ct,It[0].width,It[0].height,at.depth);for(let gt=0,Xt=It.length;gt<Xt;gt++)if(ot=It[gt],S.format!==zi)if(vt!==null)if(wt){if(Zt)if(S.layerUpdates.size>0){let se=Df(ot.width,ot.height,S.format,S.type);for(let Ft of S.layerUpdates){let fe=ot.data.subarray(Ft*se/ot.data.BYTES_PER_ELEMENT,(Ft+1)*se/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,gt,0,0,Ft,ot.width,ot.height,1,vt,fe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,gt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,gt,ct,ot.width,ot.height,at.depth,0,ot.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else wt?Zt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,gt,0,0,0,ot.width,ot.height,at.depth,vt,z,ot.data):e.texImage3D(i.TEXTURE_2D_ARRAY,gt,ct,ot.width,ot.height,at.depth,0,vt,z,ot.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{wt&&Ct&&e.texStorage2D(i.TEXTURE_2D,ie,ct,It[0].width,It[0].height);for(let gt=0,Xt=It.length;gt<Xt;gt++)ot=It[gt],S.format!==zi?vt!==null?wt?Zt&&e.compressedTexSubImage2D(i.TEXTURE_2D,gt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(i.TEXTURE_2D,gt,ct,ot.width,ot.height,0,ot.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):wt?Zt&&e.texSubImage2D(i.TEXTURE_2D,gt,0,0,ot.width,ot.height,vt,z,ot.data):e.texImage2D(i.TEXTURE_2D,gt,ct,ot.width,ot.height,0,vt,z,ot.data)}else if(S.isDataArrayTexture)if(wt){if(Ct&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ie,ct,at.width,at.height,at.depth),Zt)if(S.layerUpdates.size>0){let gt=Df(at.width,at.height,S.format,S.type);for(let Xt of S.layerUpdates){let se=at.data.subarray(Xt*gt/at.data.BYTES_PER_ELEMENT,(Xt+1)*gt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Xt,at.width,at.height,1,vt,z,se)}S.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,z,at.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ct,at.width,at.height,at.depth,0,vt,z,at.data);else if(S.isData3DTexture)wt?(Ct&&e.texStorage3D(i.TEXTURE_3D,ie,ct,at.width,at.height,at.depth),Zt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,z,at.data)):e.texImage3D(i.TEXTURE_3D,0,ct,at.width,at.height,at.depth,0,vt,z,at.data);else if(S.isFramebufferTexture){if(Ct)if(wt)e.texStorage2D(i.TEXTURE_2D,ie,ct,at.width,at.height);else{let gt=at.width,Xt=at.height;for(let se=0;se<ie;se++)e.texImage2D(i.TEXTURE_2D,se,ct,gt,Xt,0,vt,z,null),gt>>=1,Xt>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let gt=i.canvas;if(gt.hasAttribute("layoutsubtree")||gt.setAttribute("layoutsubtree","true"),at.parentNode!==gt){gt.appendChild(at),h.add(S),gt.onpaint=Xt=>{let se=Xt.changedElements;for(let Ft of h)se.includes(Ft.image)&&(Ft.needsUpdate=!0)},gt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,at);else{let se=i.RGBA,Ft=i.RGBA,fe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,se,Ft,fe,at)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(It.length>0){if(wt&&Ct){let gt=Kt(It[0]);e.texStorage2D(i.TEXTURE_2D,ie,ct,gt.width,gt.height)}for(let gt=0,Xt=It.length;gt<Xt;gt++)ot=It[gt],wt?Zt&&e.texSubImage2D(i.TEXTURE_2D,gt,0,0,vt,z,ot):e.texImage2D(i.TEXTURE_2D,gt,ct,vt,z,ot);S.generateMipmaps=!1}else if(wt){if(Ct){let gt=Kt(at);e.texStorage2D(i.TEXTURE_2D,ie,ct,gt.width,gt.height)}Zt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,vt,z,at)}else e.texImage2D(i.TEXTURE_2D,0,ct,vt,z,at);M(S)&&S.mipmapsAutoUpdate===!0&&b(_t),Tt.__version=Et.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function we(P,S,Q){if(S.image.length!==6)return;let _t=Nt(P,S),ht=S.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+Q);let Et=n.get(ht);if(ht.version!==Et.__version||_t===!0){e.activeTexture(i.TEXTURE0+Q);let Tt=Se.getPrimaries(Se.workingColorSpace),rt=S.colorSpace===Cs?null:Se.getPrimaries(S.colorSpace),at=S.colorSpace===Cs||Tt===rt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=S.isCompressedTexture||S.image[0].isCompressedTexture,z=S.image[0]&&S.image[0].isDataTexture,ct=[];for(let Ft=0;Ft<6;Ft++)!vt&&!z?ct[Ft]=y(S.image[Ft],!0,s.maxCubemapSize):ct[Ft]=z?S.image[Ft].image:S.image[Ft],ct[Ft]=Yt(S,ct[Ft]);let ot=ct[0],It=r.convert(S.format,S.colorSpace),wt=r.convert(S.type),Ct=w(S.internalFormat,It,wt,S.normalized,S.colorSpace),Zt=S.isVideoTexture!==!0,ie=Et.__version===void 0||_t===!0,gt=ht.dataReady,Xt=E(S,ot);yt(i.TEXTURE_CUBE_MAP,S);let se;if(S.isDepthTexture){if(Ct=_(S.format===As,S.type),ie)if(Zt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ct,ot.width,ot.height);else for(let Ft=0;Ft<6;Ft++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,0,Ct,ot.width,ot.height,0,It,wt,null)}else if(vt){Zt&&ie&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Xt,Ct,ot.width,ot.height);for(let Ft=0;Ft<6;Ft++){se=ct[Ft].mipmaps;for(let fe=0;fe<se.length;fe++){let He=se[fe];S.format!==zi?It!==null?Zt?gt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe,0,0,He.width,He.height,It,He.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe,Ct,He.width,He.height,0,He.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?gt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe,0,0,He.width,He.height,It,wt,He.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe,Ct,He.width,He.height,0,It,wt,He.data)}}}else{if(se=S.mipmaps,Zt&&ie){se.length>0&&Xt++;let Ft=Kt(ct[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Xt,Ct,Ft.width,Ft.height)}for(let Ft=0;Ft<6;Ft++)if(z){Zt?gt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,0,0,0,ct[Ft].width,ct[Ft].height,It,wt,ct[Ft].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,0,Ct,ct[Ft].width,ct[Ft].height,0,It,wt,ct[Ft].data);for(let fe=0;fe<se.length;fe++){let Bn=se[fe].image[Ft].image;Zt?gt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe+1,0,0,Bn.width,Bn.height,It,wt,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe+1,Ct,Bn.width,Bn.height,0,It,wt,Bn.data)}}else{Zt?gt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,0,0,0,It,wt,ct[Ft]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,0,Ct,It,wt,ct[Ft]);for(let fe=0;fe<se.length;fe++){let He=se[fe];Zt?gt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe+1,0,0,It,wt,He.image[Ft]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ft,fe+1,Ct,It,wt,He.image[Ft])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),Et.__version=ht.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function ge(P,S,Q,_t,ht,Et){let Tt=r.convert(Q.format,Q.colorSpace),rt=r.convert(Q.type),at=w(Q.internalFormat,Tt,rt,Q.normalized,Q.colorSpace),vt=n.get(S),z=n.get(Q);if(z.__renderTarget=S,!vt.__hasExternalTextures){let ct=Math.max(1,S.width>>Et),ot=Math.max(1,S.height>>Et);ht===i.TEXTURE_3D||ht===i.TEXTURE_2D_ARRAY?e.texImage3D(ht,Et,at,ct,ot,S.depth,0,Tt,rt,null):e.texImage2D(ht,Et,at,ct,ot,0,Tt,rt,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),Pt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_t,ht,z.__webglTexture,0,ue(S)):(ht===i.TEXTURE_2D||ht>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ht<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,_t,ht,z.__webglTexture,Et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ke(P,S,Q){if(i.bindRenderbuffer(i.RENDERBUFFER,P),S.depthBuffer){let _t=S.depthTexture,ht=_t&&_t.isDepthTexture?_t.type:null,Et=_(S.stencilBuffer,ht),Tt=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Pt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ue(S),Et,S.width,S.height):Q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ue(S),Et,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,Et,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Tt,i.RENDERBUFFER,P)}else{let _t=S.textures;for(let ht=0;ht<_t.length;ht++){let Et=_t[ht],Tt=r.convert(Et.format,Et.colorSpace),rt=r.convert(Et.type),at=w(Et.internalFormat,Tt,rt,Et.normalized,Et.colorSpace);Pt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ue(S),at,S.width,S.height):Q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ue(S),at,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,at,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function de(P,S,Q){let _t=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ht=n.get(S.depthTexture);ht.__renderTarget=S;let Et=_t?S.depthTexture.image[0]:S.depthTexture.image;(!ht.__webglTexture||Et.width!==S.width||Et.height!==S.height)&&(Et.width=S.width,Et.height=S.height,S.depthTexture.needsUpdate=!0),_t?bt(S.depthTexture,0):pt(S.depthTexture,0);let Tt=ht.__webglTexture,rt=ue(S),at=_t?i.TEXTURE_CUBE_MAP_POSITIVE_X+Q:i.TEXTURE_2D,vt=S.depthTexture.format===As?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ms)Pt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,vt,at,Tt,0,rt):i.framebufferTexture2D(i.FRAMEBUFFER,vt,at,Tt,0);else if(S.depthTexture.format===As)Pt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,vt,at,Tt,0,rt):i.framebufferTexture2D(i.FRAMEBUFFER,vt,at,Tt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ge(P){let S=n.get(P),Q=P.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==P.depthTexture){let _t=P.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),_t){let ht=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,_t.removeEventListener("dispose",ht)};_t.addEventListener("dispose",ht),S.__depthDisposeCallback=ht}S.__boundDepthTexture=_t}if(P.depthTexture&&!S.__autoAllocateDepthBuffer)if(Q)for(let _t=0;_t<6;_t++)de(S.__webglFramebuffer[_t],P,_t);else P.texture.mipmaps.length>0?de(S.__webglFramebuffer[0],P,0):de(S.__webglFramebuffer,P,0);else if(Q){S.__webglDepthbuffer=[];for(let _t=0;_t<6;_t++)if(e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[_t]),S.__webglDepthbuffer[_t]===void 0)S.__webglDepthbuffer[_t]=i.createRenderbuffer(),ke(S.__webglDepthbuffer[_t],P,!1);else{let ht=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Et=S.__webglDepthbuffer[_t];i.bindRenderbuffer(i.RENDERBUFFER,Et),i.framebufferRenderbuffer(i.FRAMEBUFFER,ht,i.RENDERBUFFER,Et)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),ke(S.__webglDepthbuffer,P,!1);else{let ht=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Et=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Et),i.framebufferRenderbuffer(i.FRAMEBUFFER,ht,i.RENDERBUFFER,Et)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Je(P,S,Q){let _t=n.get(P);S!==void 0&&ge(_t.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Q!==void 0&&Ge(P)}function en(P){let S=P.texture,Q=n.get(P),_t=n.get(S);P.addEventListener("dispose",G),O(P);let ht=P.textures,Et=P.isWebGLCubeRenderTarget===!0,Tt=ht.length>1;if(Tt||(_t.__webglTexture===void 0&&(_t.__webglTexture=i.createTexture()),_t.__version=S.version,o.memory.textures++),Et){Q.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(S.mipmaps.length>0){Q.__webglFramebuffer[rt]=[];for(let at=0;at<S.mipmaps.length;at++)Q.__webglFramebuffer[rt][at]=i.createFramebuffer()}else Q.__webglFramebuffer[rt]=i.createFramebuffer()}else{if(S.mipmaps.length>0){Q.__webglFramebuffer=[];for(let rt=0;rt<S.mipmaps.length;rt++)Q.__webglFramebuffer[rt]=i.createFramebuffer()}else Q.__webglFramebuffer=i.createFramebuffer();if(Tt)for(let rt=0,at=ht.length;rt<at;rt++){let vt=n.get(ht[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Pt(P)===!1){Q.__webglMultisampledFramebuffer=i.createFramebuffer(),Q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Q.__webglMultisampledFramebuffer);for(let rt=0;rt<ht.length;rt++){let at=ht[rt];Q.__webglColorRenderbuffer[rt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Q.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),z=r.convert(at.type),ct=w(at.internalFormat,vt,z,at.normalized,at.colorSpace,P.isXRRenderTarget===!0),ot=ue(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ot,ct,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+rt,i.RENDERBUFFER,Q.__webglColorRenderbuffer[rt])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(Q.__webglDepthRenderbuffer=i.createRenderbuffer(),ke(Q.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Et){e.bindTexture(i.TEXTURE_CUBE_MAP,_t.__webglTexture),yt(i.TEXTURE_CUBE_MAP,S);for(let rt=0;rt<6;rt++)if(S.mipmaps.length>0)for(let at=0;at<S.mipmaps.length;at++)ge(Q.__webglFramebuffer[rt][at],P,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else ge(Q.__webglFramebuffer[rt],P,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);M(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(Tt){for(let rt=0,at=ht.length;rt<at;rt++){let vt=ht[rt],z=n.get(vt),ct=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ct=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ct,z.__webglTexture),yt(ct,vt),ge(Q.__webglFramebuffer,P,vt,i.COLOR_ATTACHMENT0+rt,ct,0),M(vt)&&b(ct)}e.unbindTexture()}else{let rt=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(rt=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,_t.__webglTexture),yt(rt,S),S.mipmaps.length>0)for(let at=0;at<S.mipmaps.length;at++)ge(Q.__webglFramebuffer[at],P,S,i.COLOR_ATTACHMENT0,rt,at);else ge(Q.__webglFramebuffer,P,S,i.COLOR_ATTACHMENT0,rt,0);M(S)?b(rt):S.mipmaps.length>0&&i.texParameteri(rt,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&Ge(P)}function B(P){let S=P.textures;for(let Q=0,_t=S.length;Q<_t;Q++){let ht=S[Q];if(M(ht)&&ht.mipmapsAutoUpdate===!0){let Et=R(P),Tt=n.get(ht).__webglTexture;e.bindTexture(Et,Tt),b(Et),e.unbindTexture()}}}let Rt=[];function Qt(P){if(P.samples>0){if(Pt(P)===!1){let S=P.textures,Q=P.width,_t=P.height,ht=i.COLOR_BUFFER_BIT,Et=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Tt=n.get(P),rt=S.length>1;if(rt)for(let vt=0;vt<S.length;vt++)e.bindFramebuffer(i.FRAMEBUFFER,Tt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+vt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Tt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+vt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Tt.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Tt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Tt.__webglFramebuffer);for(let vt=0;vt<S.length;vt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ht|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ht|=i.STENCIL_BUFFER_BIT)),rt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Tt.__webglColorRenderbuffer[vt]);let z=n.get(S[vt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,z,0)}i.blitFramebuffer(0,0,Q,_t,0,0,Q,_t,ht,i.NEAREST),c===!0&&(Rt.length=0,Rt.push(i.COLOR_ATTACHMENT0+vt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Rt.push(Et),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<S.length;vt++){e.bindFramebuffer(i.FRAMEBUFFER,Tt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+vt,i.RENDERBUFFER,Tt.__webglColorRenderbuffer[vt]);let z=n.get(S[vt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Tt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+vt,i.TEXTURE_2D,z,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Tt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&c){let S=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function ue(P){return Math.min(s.maxSamples,P.samples)}function Pt(P){let S=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Be(P){let S=o.render.frame;u.get(P)!==S&&(u.set(P,S),P.update())}function Yt(P,S){let Q=P.colorSpace,_t=P.format,ht=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Q!==ba&&Q!==Cs&&(Se.getTransfer(Q)===Ie?(_t!==zi||ht!==Kn)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",Q)),S}function Kt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(l.width=P.naturalWidth||P.width,l.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(l.width=P.displayWidth,l.height=P.displayHeight):(l.width=P.width,l.height=P.height),l}this.allocateTextureUnit=lt,this.resetTextureUnits=K,this.getTextureUnits=W,this.setTextureUnits=st,this.setTexture2D=pt,this.setTexture2DArray=mt,this.setTexture3D=St,this.setTextureCube=bt,this.rebindTextures=Je,this.setupRenderTarget=en,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Qt,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=ge,this.useMultisampledRTT=Pt,this.dispose=F}function qT(i,t){function e(n,s=Cs){let r,o=Se.getTransfer(s);if(n===Kn)return i.UNSIGNED_BYTE;if(n===lh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===ch)return i.UNSIGNED_SHORT_5_5_5_1;if(n===mf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===gf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ff)return i.BYTE;if(n===pf)return i.SHORT;if(n===zo)return i.UNSIGNED_SHORT;if(n===ah)return i.INT;if(n===Oi)return i.UNSIGNED_INT;if(n===ki)return i.FLOAT;if(n===Bi)return i.HALF_FLOAT;if(n===_f)return i.ALPHA;if(n===xf)return i.RGB;if(n===zi)return i.RGBA;if(n===Ms)return i.DEPTH_COMPONENT;if(n===As)return i.DEPTH_STENCIL;if(n===yf)return i.RED;if(n===hh)return i.RED_INTEGER;if(n===sr)return i.RG;if(n===uh)return i.RG_INTEGER;if(n===dh)return i.RGBA_INTEGER;if(n===nl||n===il||n===sl||n===rl)if(o===Ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===nl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===sl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===rl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===nl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===il)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===sl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===rl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===fh||n===ph||n===mh||n===gh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===fh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ph)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===mh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===gh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===_h||n===xh||n===yh||n===vh||n===bh||n===ol||n===Mh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===_h||n===xh)return o===Ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===yh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===vh)return r.COMPRESSED_R11_EAC;if(n===bh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===ol)return r.COMPRESSED_RG11_EAC;if(n===Mh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Sh||n===wh||n===Eh||n===Th||n===Ah||n===Ch||n===Rh||n===Ph||n===Ih||n===Lh||n===Dh||n===Nh||n===Uh||n===Fh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Sh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===wh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Eh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Th)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ah)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ch)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Rh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ph)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ih)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Lh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Dh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Nh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Uh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Fh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Oh||n===kh||n===Bh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Oh)return o===Ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===kh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===zh||n===Vh||n===al||n===Gh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===zh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Vh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===al)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Gh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Pr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var YT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ZT=`
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

}`,Gf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new La(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new is({vertexShader:YT,fragmentShader:ZT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Le(new Tr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Hf=class extends Ni{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Gf,g={},y=e.getContextAttributes(),M=null,b=null,R=[],w=[],_=new Ot,E=null,O=null,D=new qn;D.viewport=new je;let I=new qn;I.viewport=new je;let G=[D,I],H=new nh,N=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let pt=R[j];return pt===void 0&&(pt=new Po,R[j]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(j){let pt=R[j];return pt===void 0&&(pt=new Po,R[j]=pt),pt.getGripSpace()},this.getHand=function(j){let pt=R[j];return pt===void 0&&(pt=new Po,R[j]=pt),pt.getHandSpace()};function q(j){let pt=w.indexOf(j.inputSource);if(pt===-1)return;let mt=R[pt];mt!==void 0&&(mt.update(j.inputSource,j.frame,l||o),mt.dispatchEvent({type:j.type,data:j.inputSource}))}function V(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",J);for(let j=0;j<R.length;j++){let pt=w[j];pt!==null&&(w[j]=null,R[j].disconnect(pt))}N=null,F=null,m.reset();for(let j in g)delete g[j];if(t.setRenderTarget(M),f=null,d=null,h=null,s=null,b=null,lt.stop(),n.isPresenting=!1,t.setPixelRatio(E),t.setSize(_.width,_.height,!1),O!==null){let j=O.camera;j.fov=O.fov,j.zoom=O.zoom,j.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(j){l=j},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",V),s.addEventListener("inputsourceschange",J),y.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let mt=null,St=null,bt=null;y.depth&&(bt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,mt=y.stencil?As:Ms,St=y.stencil?Pr:Oi);let $={colorFormat:e.RGBA8,depthFormat:bt,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer($),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new ui(d.textureWidth,d.textureHeight,{format:zi,type:Kn,depthTexture:new ws(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,mt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let mt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,mt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ui(f.framebufferWidth,f.framebufferHeight,{format:zi,type:Kn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),lt.setContext(s),lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function J(j){for(let pt=0;pt<j.removed.length;pt++){let mt=j.removed[pt],St=w.indexOf(mt);St>=0&&(w[St]=null,R[St].disconnect(mt))}for(let pt=0;pt<j.added.length;pt++){let mt=j.added[pt],St=w.indexOf(mt);if(St===-1){for(let $=0;$<R.length;$++)if($>=w.length){w.push(mt),St=$;break}else if(w[$]===null){w[$]=mt,St=$;break}if(St===-1)break}let bt=R[St];bt&&bt.connect(mt)}}function Z(j,pt){pt===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(pt.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let pt=j.near,mt=j.far;m.texture!==null&&(m.depthNear>0&&(pt=m.depthNear),m.depthFar>0&&(mt=m.depthFar)),H.near=I.near=D.near=pt,H.far=I.far=D.far=mt,(N!==H.near||F!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,F=H.far),H.layers.mask=j.layers.mask|6,D.layers.mask=H.layers.mask&-5,I.layers.mask=H.layers.mask&-3;let St=j.parent,bt=H.cameras;Z(H,St);for(let $=0;$<bt.length;$++)Z(bt[$],St);H.projectionMatrix.copy(D.projectionMatrix),H.projectionMatrixInverse.copy(D.projectionMatrixInverse),O===null&&j.isPerspectiveCamera&&(O={camera:j,fov:j.fov,zoom:j.zoom}),K(j,H,St)};function K(j,pt,mt){mt===null?j.matrix.copy(pt.matrixWorld):(j.matrix.copy(mt.matrixWorld),j.matrix.invert(),j.matrix.multiply(pt.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(pt.projectionMatrix),j.projectionMatrixInverse.copy(pt.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=Ao*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(j){c=j,d!==null&&(d.fixedFoveation=j),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function(j){return g[j]};let W=null;function st(j,pt){if(u=pt.getViewerPose(l||o),p=pt,u!==null){let mt=u.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let St=!1;mt.length!==H.cameras.length&&(H.cameras.length=0,St=!0);for(let ft=0;ft<mt.length;ft++){let yt=mt[ft],Nt=null;if(f!==null)Nt=f.getViewport(yt);else{let te=h.getViewSubImage(d,yt);Nt=te.viewport,ft===0&&(t.setRenderTargetTextures(b,te.colorTexture,te.depthStencilTexture),t.setRenderTarget(b))}let Ut=G[ft];Ut===void 0&&(Ut=new qn,Ut.layers.enable(ft),Ut.viewport=new je,G[ft]=Ut),Ut.matrix.fromArray(yt.transform.matrix),Ut.matrix.decompose(Ut.position,Ut.quaternion,Ut.scale),Ut.projectionMatrix.fromArray(yt.projectionMatrix),Ut.projectionMatrixInverse.copy(Ut.projectionMatrix).invert(),Ut.viewport.set(Nt.x,Nt.y,Nt.width,Nt.height),ft===0&&(H.matrix.copy(Ut.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),St===!0&&H.cameras.push(Ut)}let bt=s.enabledFeatures;if(bt&&bt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=n.getBinding();let ft=h.getDepthInformation(mt[0]);ft&&ft.isValid&&ft.texture&&m.init(ft,s.renderState)}if(bt&&bt.includes("camera-access")&&x){t.state.unbindTexture(),h=n.getBinding();for(let ft=0;ft<mt.length;ft++){let yt=mt[ft].camera;if(yt){let Nt=g[yt];Nt||(Nt=new La,g[yt]=Nt);let Ut=h.getCameraImage(yt);Nt.sourceTexture=Ut}}}}for(let mt=0;mt<R.length;mt++){let St=w[mt],bt=R[mt];St!==null&&bt!==void 0&&bt.update(St,pt,l||o)}W&&W(j,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),p=null}let lt=new V_;lt.setAnimationLoop(st),this.setAnimationLoop=function(j){W=j},this.dispose=function(){}}},JT=new Fe,K_=new le;K_.set(-1,0,0,0,1,0,0,0,1);function KT(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Pf(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,M,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?c(m,g,y,M):g.isSpriteMaterial?l(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Zn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Zn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=t.get(g),M=y.envMap,b=y.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(JT.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(K_),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function c(m,g,y,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=M*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function l(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Zn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let y=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function jT(i,t,e,n){let s={},r={};function o(y,M){let b=M.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,M){let b=s[y.id];b===void 0&&(p(y),b=c(y),s[y.id]=b,y.addEventListener("dispose",m));let R=M.program;n.updateUBOMapping(y,R);let w=t.render.frame;r[y.id]!==w&&(l(y),r[y.id]=w)}function c(y){let M=i.createBuffer(),b=y.__size,R=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,R),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function l(y){let M=s[y.id],b=y.uniforms,R=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let w=0,_=b.length;w<_;w++){let E=b[w];if(Array.isArray(E))for(let O=0,D=E.length;O<D;O++)u(E[O],w,O,R);else u(E,w,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(y,M,b,R){if(d(y,M,b,R)===!0){let w=y.__offset,_=y.value;if(Array.isArray(_)){let E=0;for(let O=0;O<_.length;O++){let D=_[O],I=x(D,!0);h(D,y.__data,E),E+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,y.__data)}}function h(y,M,b){typeof y=="number"||typeof y=="boolean"?M[b]=y:y.isMatrix3?(M[b]=y.elements[0],M[b+1]=y.elements[1],M[b+2]=y.elements[2],M[b+3]=0,M[b+4]=y.elements[3],M[b+5]=y.elements[4],M[b+6]=y.elements[5],M[b+7]=0,M[b+8]=y.elements[6],M[b+9]=y.elements[7],M[b+10]=y.elements[8],M[b+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-b),b):y.toArray(M,b)}function d(y,M,b,R){let w=y.value,_=M+"_"+b;if(Array.isArray(w)){R[_]===void 0&&(R[_]=[]);let E=R[_],O=!1;for(let D=0;D<w.length;D++)f(w[D],E,D)===!0&&(O=!0);return O}return f(w,R,_)}function f(y,M,b){if(M[b]===void 0)return typeof y=="number"||typeof y=="boolean"?M[b]=y:ArrayBuffer.isView(y)?M[b]=y.slice():M[b]=y.clone(),!0;{let R=M[b];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return M[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function p(y){let M=y.uniforms,b=0,R=16;for(let _=0,E=M.length;_<E;_++){let O=Array.isArray(M[_])?M[_]:[M[_]];for(let D=0,I=O.length;D<I;D++){let G=O[D],H=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(M[_])||Array.isArray(G.value),F=b;for(let V=0,J=H.length;V<J;V++){let Z=H[V],K=x(Z,N),W=b%R,st=W%K.boundary,lt=W+st;b+=st,lt!==0&&R-lt<K.storage&&(b+=R-lt),V===0&&(F=b),b+=K.storage}let q=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new q((b-F)/Float32Array.BYTES_PER_ELEMENT),G.__offset=F}}let w=b%R;return w>0&&(b+=R-w),y.__size=b,y.__cache={},this}function x(y,M){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(y){let M=y.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var QT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),rs=null;function tA(){return rs===null&&(rs=new Lc(QT,16,16,sr,Bi),rs.name="DFG_LUT",rs.minFilter=Yn,rs.magFilter=Yn,rs.wrapS=ts,rs.wrapT=ts,rs.generateMipmaps=!1,rs.needsUpdate=!0),rs}var qh=class{constructor(t={}){let{canvas:e=o_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([dh,uh,hh]),g=new Set([Kn,Oi,zo,Pr,lh,ch]),y=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},R=null,w=null,_=[],E=[],O=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ss,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,I=!1,G=null,H=null,N=null,F=null;this._outputColorSpace=ci;let q=0,V=0,J=null,Z=-1,K=null,W=new je,st=new je,lt=null,j=new he(0),pt=0,mt=e.width,St=e.height,bt=1,$=null,ut=null,ft=new je(0,0,mt,St),yt=new je(0,0,mt,St),Nt=!1,Ut=new Zs,te=new Dc,ee=!1,we=!1,ge=new Fe,ke=new k,de=new je,Ge={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Je=!1;function en(){return J===null?bt:1}let B=n;function Rt(A,X){return e.getContext(A,X)}let Qt,ue,Pt,Be,Yt,Kt,P,S,Q,_t,ht,Et,Tt,rt,at,vt,z,ct,ot,It,wt,Ct,Zt;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Xt,!1),e.addEventListener("webglcontextrestored",se,!1),e.addEventListener("webglcontextcreationerror",Ft,!1),B===null){let X="webgl2";if(B=Rt(X,A),B===null)throw Rt(X)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ie()}catch(A){throw e.removeEventListener("webglcontextlost",Xt,!1),e.removeEventListener("webglcontextrestored",se,!1),e.removeEventListener("webglcontextcreationerror",Ft,!1),re("WebGLRenderer: "+A.message),A}function ie(){Qt=new uE(B),Qt.init(),wt=new qT(B,Qt),ue=new tE(B,Qt,t,wt),Pt=new XT(B,Qt),ue.reversedDepthBuffer&&d&&Pt.buffers.depth.setReversed(!0),H=B.createFramebuffer(),N=B.createFramebuffer(),F=B.createFramebuffer(),Be=new pE(B),Yt=new IT,Kt=new $T(B,Qt,Pt,Yt,ue,wt,Be),P=new hE(D),S=new gS(B),Ct=new j1(B,S),Q=new dE(B,S,Be,Ct),_t=new gE(B,Q,S,Ct,Be),ct=new mE(B,ue,Kt),at=new eE(Yt),ht=new PT(D,P,Qt,ue,Ct,at),Et=new KT(D,Yt),Tt=new DT,rt=new BT(Qt),z=new K1(D,P,Pt,_t,p,c),vt=new WT(D,_t,ue),Zt=new jT(B,Be,ue,Pt),ot=new Q1(B,Qt,Be),It=new fE(B,Qt,Be),Be.programs=ht.programs,D.capabilities=ue,D.extensions=Qt,D.properties=Yt,D.renderLists=Tt,D.shadowMap=vt,D.state=Pt,D.info=Be}x!==Kn&&(O=new xE(x,e.width,e.height,a,s,r));let gt=new Hf(D,B);this.xr=gt,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Qt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Qt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return bt},this.setPixelRatio=function(A){A!==void 0&&(bt=A,this.setSize(mt,St,!1))},this.getSize=function(A){return A.set(mt,St)},this.setSize=function(A,X,it=!0){if(gt.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}mt=A,St=X,e.width=Math.floor(A*bt),e.height=Math.floor(X*bt),it===!0&&(e.style.width=A+"px",e.style.height=X+"px"),O!==null&&O.setSize(e.width,e.height),this.setViewport(0,0,A,X)},this.getDrawingBufferSize=function(A){return A.set(mt*bt,St*bt).floor()},this.setDrawingBufferSize=function(A,X,it){mt=A,St=X,bt=it,e.width=Math.floor(A*it),e.height=Math.floor(X*it),this.setViewport(0,0,A,X)},this.setEffects=function(A){if(x===Kn){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let X=0;X<A.length;X++)if(A[X].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(W)},this.getViewport=function(A){return A.copy(ft)},this.setViewport=function(A,X,it,tt){A.isVector4?ft.set(A.x,A.y,A.z,A.w):ft.set(A,X,it,tt),Pt.viewport(W.copy(ft).multiplyScalar(en()).round())},this.getScissor=function(A){return A.copy(yt)},this.setScissor=function(A,X,it,tt){A.isVector4?yt.set(A.x,A.y,A.z,A.w):yt.set(A,X,it,tt),Pt.scissor(st.copy(yt).multiplyScalar(en()).round())},this.getScissorTest=function(){return Nt},this.setScissorTest=function(A){Pt.setScissorTest(Nt=A)},this.setOpaqueSort=function(A){$=A},this.setTransparentSort=function(A){ut=A},this.getClearColor=function(A){return A.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(A=!0,X=!0,it=!0){let tt=0;if(A){let et=!1;if(J!==null){let Lt=J.texture.format;et=m.has(Lt)}if(et){let Lt=J.texture.type,kt=g.has(Lt),Dt=z.getClearColor(),Bt=z.getClearAlpha(),qt=Dt.r,oe=Dt.g,_e=Dt.b;kt?(y[0]=qt,y[1]=oe,y[2]=_e,y[3]=Bt,B.clearBufferuiv(B.COLOR,0,y)):(M[0]=qt,M[1]=oe,M[2]=_e,M[3]=Bt,B.clearBufferiv(B.COLOR,0,M))}else tt|=B.COLOR_BUFFER_BIT}X&&(tt|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(tt|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),tt!==0&&B.clear(tt)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),G=A},this.dispose=function(){e.removeEventListener("webglcontextlost",Xt,!1),e.removeEventListener("webglcontextrestored",se,!1),e.removeEventListener("webglcontextcreationerror",Ft,!1),z.dispose(),Tt.dispose(),rt.dispose(),Kt.dispose(),Yt.dispose(),P.dispose(),_t.dispose(),Q.dispose(),Ct.dispose(),Zt.dispose(),ht.dispose(),gt.dispose(),gt.removeEventListener("sessionstart",xl),gt.removeEventListener("sessionend",Gi),as.stop()};function Xt(A){A.preventDefault(),wf("WebGLRenderer: Context Lost."),I=!0}function se(){wf("WebGLRenderer: Context Restored."),I=!1;let A=Be.autoReset,X=vt.enabled,it=vt.autoUpdate,tt=vt.needsUpdate,et=vt.type;ie(),Be.autoReset=A,vt.enabled=X,vt.autoUpdate=it,vt.needsUpdate=tt,vt.type=et}function Ft(A){re("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function fe(A){let X=A.target;X.removeEventListener("dispose",fe),He(X)}function He(A){Bn(A),Yt.remove(A)}function Bn(A){let X=Yt.get(A).programs;X!==void 0&&(X.forEach(function(it){ht.releaseProgram(it)}),A.isShaderMaterial&&ht.releaseShaderCache(A))}this.renderBufferDirect=function(A,X,it,tt,et,Lt){X===null&&(X=Ge);let kt=et.isMesh&&et.matrixWorld.determinantAffine()<0,Dt=Yo(A,X,it,tt,et);Pt.setMaterial(tt,kt);let Bt=it.index,qt=1;if(tt.wireframe===!0){if(Bt=Q.getWireframeAttribute(it),Bt===void 0)return;qt=2}let oe=it.drawRange,_e=it.attributes.position,$t=oe.start*qt,xe=(oe.start+oe.count)*qt;Lt!==null&&($t=Math.max($t,Lt.start*qt),xe=Math.min(xe,(Lt.start+Lt.count)*qt)),Bt!==null?($t=Math.max($t,0),xe=Math.min(xe,Bt.count)):_e!=null&&($t=Math.max($t,0),xe=Math.min(xe,_e.count));let Qe=xe-$t;if(Qe<0||Qe===1/0)return;Ct.setup(et,tt,Dt,it,Bt);let De,Ne=ot;if(Bt!==null&&(De=S.get(Bt),Ne=It,Ne.setIndex(De)),et.isMesh)tt.wireframe===!0?(Pt.setLineWidth(tt.wireframeLinewidth*en()),Ne.setMode(B.LINES)):Ne.setMode(B.TRIANGLES);else if(et.isLine){let gn=tt.linewidth;gn===void 0&&(gn=1),Pt.setLineWidth(gn*en()),et.isLineSegments?Ne.setMode(B.LINES):et.isLineLoop?Ne.setMode(B.LINE_LOOP):Ne.setMode(B.LINE_STRIP)}else et.isPoints?Ne.setMode(B.POINTS):et.isSprite&&Ne.setMode(B.TRIANGLES);if(et.isBatchedMesh)if(Qt.get("WEBGL_multi_draw"))Ne.renderMultiDraw(et._multiDrawStarts,et._multiDrawCounts,et._multiDrawCount);else{let gn=et._multiDrawStarts,Ht=et._multiDrawCounts,hn=et._multiDrawCount,be=Bt?S.get(Bt).bytesPerElement:1,cs=Yt.get(tt).currentProgram.getUniforms();for(let un=0;un<hn;un++)cs.setValue(B,"_gl_DrawID",un),Ne.render(gn[un]/be,Ht[un])}else if(et.isInstancedMesh)Ne.renderInstances($t,Qe,et.count);else if(it.isInstancedBufferGeometry){let gn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Ht=Math.min(it.instanceCount,gn);Ne.renderInstances($t,Qe,Ht)}else Ne.render($t,Qe)};function Xo(A,X,it,tt){G!==null&&A.isNodeMaterial&&G.setObject(tt,A),ee===!0&&at.setState(A,it,!1),A.transparent===!0&&A.side===Si&&A.forceSinglePass===!1?(A.side=Zn,A.needsUpdate=!0,Hi(A,X,tt),A.side=ir,A.needsUpdate=!0,Hi(A,X,tt),A.side=Si):Hi(A,X,tt)}this.compile=function(A,X,it=null){it===null&&(it=A),G!==null&&G.renderStart(A,X,it),w=rt.get(it),w.init(X),E.push(w),it.traverseVisible(function(et){et.isLight&&et.layers.test(X.layers)&&(w.pushLight(et),et.castShadow&&w.pushShadow(et))}),A!==it&&A.traverseVisible(function(et){et.isLight&&et.layers.test(X.layers)&&(w.pushLight(et),et.castShadow&&w.pushShadow(et))}),w.setupLights(),G!==null&&G.updateLights(w.state.lightsArray),we=this.localClippingEnabled,ee=at.init(this.clippingPlanes,we),ee===!0&&at.setGlobalState(this.clippingPlanes,X),G!==null&&vt.render(w.state.shadowsArray,it,X);let tt=new Set;return A.traverse(function(et){if(!(et.isMesh||et.isPoints||et.isLine||et.isSprite))return;let Lt=et.material;if(Lt)if(Array.isArray(Lt))for(let kt=0;kt<Lt.length;kt++){let Dt=Lt[kt];Xo(Dt,it,X,et),tt.add(Dt)}else Xo(Lt,it,X,et),tt.add(Lt)}),w=E.pop(),G!==null&&G.renderEnd(),tt},this.compileAsync=function(A,X,it=null){let tt=this.compile(A,X,it);return new Promise(et=>{function Lt(){if(tt.forEach(function(kt){let Bt=Yt.get(kt).currentProgram;(Bt===void 0||Bt.isReady())&&tt.delete(kt)}),tt.size===0){et(A);return}setTimeout(Lt,10)}Qt.get("KHR_parallel_shader_compile")!==null?Lt():setTimeout(Lt,10)})};let Dr=null;function du(A){Dr&&Dr(A)}function xl(){as.stop()}function Gi(){as.start()}let as=new V_;as.setAnimationLoop(du),typeof self<"u"&&as.setContext(self),this.setAnimationLoop=function(A){Dr=A,gt.setAnimationLoop(A),A===null?as.stop():as.start()},gt.addEventListener("sessionstart",xl),gt.addEventListener("sessionend",Gi),this.render=function(A,X){if(X!==void 0&&X.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;G!==null&&G.renderStart(A,X);let it=gt.enabled===!0&&gt.isPresenting===!0,tt=O!==null&&(J===null||it)&&O.begin(D,J);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),X.parent===null&&X.matrixWorldAutoUpdate===!0&&X.updateMatrixWorld(),gt.enabled===!0&&gt.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(gt.cameraAutoUpdate===!0&&gt.updateCamera(X),X=gt.getCamera()),A.isScene===!0&&A.onBeforeRender(D,A,X,J),w=rt.get(A,E.length),w.init(X),w.state.textureUnits=Kt.getTextureUnits(),E.push(w),ge.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),X.isArrayCamera?te.setFromArrayCamera(X):Ut.setFromProjectionMatrix(ge,bi,X.reversedDepth),we=this.localClippingEnabled,ee=at.init(this.clippingPlanes,we),R=Tt.get(A,_.length),R.init(),_.push(R),this.info.render.frame++,gt.enabled===!0&&gt.isPresenting===!0){let kt=D.xr.getDepthSensingMesh();kt!==null&&ls(kt,X,-1/0,D.sortObjects)}ls(A,X,0,D.sortObjects),R.finish(),G!==null&&G.updateLights(w.state.lightsArray),D.sortObjects===!0&&R.sort($,ut),Je=gt.enabled===!1||gt.isPresenting===!1||gt.hasDepthSensing()===!1,Je&&z.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),ee===!0&&at.beginShadows();let et=w.state.shadowsArray;if(vt.render(et,A,X),ee===!0&&at.endShadows(),(tt&&O.hasRenderPass())===!1){let kt=R.opaque,Dt=R.transmissive;if(w.setupLights(),X.isArrayCamera){let Bt=X.cameras;if(Dt.length>0)for(let qt=0,oe=Bt.length;qt<oe;qt++){let _e=Bt[qt];wi(kt,Dt,A,_e)}Je&&z.render(A);for(let qt=0,oe=Bt.length;qt<oe;qt++){let _e=Bt[qt];$o(R,A,_e,_e.viewport)}}else Dt.length>0&&wi(kt,Dt,A,X),Je&&z.render(A),$o(R,A,X)}J!==null&&V===0&&(Kt.updateMultisampleRenderTarget(J),Kt.updateRenderTargetMipmap(J)),tt&&O.end(D),A.isScene===!0&&A.onAfterRender(D,A,X),Ct.resetDefaultState(),Z=-1,K=null,E.pop(),E.length>0?(w=E[E.length-1],Kt.setTextureUnits(w.state.textureUnits),ee===!0&&at.setGlobalState(D.clippingPlanes,w.state.camera)):w=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,G!==null&&G.renderEnd()};function ls(A,X,it,tt){if(A.visible===!1)return;if(A.layers.test(X.layers)){if(A.isGroup)it=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(X);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){let kt=X.isArrayCamera?te:Ut;if(!A.frustumCulled||A.intersectsFrustum(kt)){tt&&de.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ge);let Dt=_t.update(A),Bt=A.material;Bt.visible&&R.push(A,Dt,Bt,it,de.z,null,X)}}else if(A.isMesh||A.isLine||A.isPoints){let kt=X.isArrayCamera?te:Ut;if(!A.frustumCulled||A.intersectsFrustum(kt)){let Dt=_t.update(A),Bt=A.material;if(tt&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),de.copy(A.boundingSphere.center)):(Dt.boundingSphere===null&&Dt.computeBoundingSphere(),de.copy(Dt.boundingSphere.center)),de.applyMatrix4(A.matrixWorld).applyMatrix4(ge)),Array.isArray(Bt)){let qt=Dt.groups;for(let oe=0,_e=qt.length;oe<_e;oe++){let $t=qt[oe],xe=Bt[$t.materialIndex];xe&&xe.visible&&R.push(A,Dt,xe,it,de.z,$t,X)}}else Bt.visible&&R.push(A,Dt,Bt,it,de.z,null,X)}}}let Lt=A.children;for(let kt=0,Dt=Lt.length;kt<Dt;kt++)ls(Lt[kt],X,it,tt)}function $o(A,X,it,tt){let{opaque:et,transmissive:Lt,transparent:kt}=A;w.setupLightsView(it),ee===!0&&at.setGlobalState(D.clippingPlanes,it),tt&&Pt.viewport(W.copy(tt)),et.length>0&&nn(et,X,it),Lt.length>0&&nn(Lt,X,it),kt.length>0&&nn(kt,X,it),Pt.buffers.depth.setTest(!0),Pt.buffers.depth.setMask(!0),Pt.buffers.color.setMask(!0),Pt.setPolygonOffset(!1)}function wi(A,X,it,tt){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[tt.id]===void 0){let $t=Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[tt.id]=new ui(1,1,{generateMipmaps:!0,type:$t?Bi:Kn,minFilter:Ts,samples:Math.max(4,ue.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let Lt=w.state.transmissionRenderTarget[tt.id],kt=tt.viewport||W;Lt.setSize(kt.z*D.transmissionResolutionScale,kt.w*D.transmissionResolutionScale);let Dt=D.getRenderTarget(),Bt=D.getActiveCubeFace(),qt=D.getActiveMipmapLevel();D.setRenderTarget(Lt),D.getClearColor(j),pt=D.getClearAlpha(),pt<1&&D.setClearColor(16777215,.5),D.clear(),Je&&z.render(it);let oe=D.toneMapping;D.toneMapping=ss;let _e=tt.viewport;if(tt.viewport!==void 0&&(tt.viewport=void 0),w.setupLightsView(tt),ee===!0&&at.setGlobalState(D.clippingPlanes,tt),nn(A,it,tt),Kt.updateMultisampleRenderTarget(Lt),Kt.updateRenderTargetMipmap(Lt),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let xe=0,Qe=X.length;xe<Qe;xe++){let De=X[xe],{object:Ne,geometry:gn,material:Ht,group:hn}=De;if(Ht.side===Si&&Ne.layers.test(tt.layers)){let be=Ht.side;Ht.side=Zn,Ht.needsUpdate=!0,ln(Ne,it,tt,gn,Ht,hn),Ht.side=be,Ht.needsUpdate=!0,$t=!0}}$t===!0&&(Kt.updateMultisampleRenderTarget(Lt),Kt.updateRenderTargetMipmap(Lt))}D.setRenderTarget(Dt,Bt,qt),D.setClearColor(j,pt),_e!==void 0&&(tt.viewport=_e),D.toneMapping=oe}function nn(A,X,it){let tt=X.isScene===!0?X.overrideMaterial:null;for(let et=0,Lt=A.length;et<Lt;et++){let kt=A[et],{object:Dt,geometry:Bt,group:qt}=kt,oe=kt.material;oe.allowOverride===!0&&tt!==null&&(oe=tt),Dt.layers.test(it.layers)&&ln(Dt,X,it,Bt,oe,qt)}}function ln(A,X,it,tt,et,Lt){G!==null&&et.isNodeMaterial&&G.setObject(A,et),A.onBeforeRender(D,X,it,tt,et,Lt),A.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),et.onBeforeRender(D,X,it,tt,A,Lt),et.transparent===!0&&et.side===Si&&et.forceSinglePass===!1?(et.side=Zn,et.needsUpdate=!0,D.renderBufferDirect(it,X,tt,et,A,Lt),et.side=ir,et.needsUpdate=!0,D.renderBufferDirect(it,X,tt,et,A,Lt),et.side=Si):D.renderBufferDirect(it,X,tt,et,A,Lt),A.onAfterRender(D,X,it,tt,et,Lt)}function cn(A){let X=0;for(let it of A)it.texture!==null&&X++;return X}function Hi(A,X,it){X.isScene!==!0&&(X=Ge);let tt=Yt.get(A),et=w.state.lights,Lt=w.state.shadowsArray,kt=et.state.version,Dt=ht.getParameters(A,et.state,Lt,X,it,w.state.lightProbeGridArray),Bt=ht.getProgramCacheKey(Dt),qt=tt.programs;tt.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?X.environment:null,tt.fog=X.fog;let oe=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;tt.envMap=P.get(A.envMap||tt.environment,oe),tt.envMapRotation=tt.environment!==null&&A.envMap===null?X.environmentRotation:A.envMapRotation,qt===void 0&&(A.addEventListener("dispose",fe),qt=new Map,tt.programs=qt,tt.programVariants=new Map);let _e=qt.get(Bt);if(_e!==void 0){if(tt.currentProgram===_e&&tt.lightsStateVersion===kt)return qo(A,Dt),_e}else Dt.uniforms=ht.getUniforms(A),G!==null&&A.isNodeMaterial&&G.build(A,it,Dt),A.onBeforeCompile(Dt,D),_e=ht.acquireProgram(Dt,Bt),qt.set(Bt,_e),tt.uniforms=Dt.uniforms;let $t=tt.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&($t.clippingPlanes=at.uniform),qo(A,Dt),tt.needsLights=Ls(A),tt.lightsStateVersion=kt,tt.needsLights&&($t.ambientLightColor.value=et.state.ambient,$t.lightProbe.value=et.state.probe,$t.sunLights.value=et.state.sun,$t.sunLightShadows.value=et.state.sunShadow,$t.directionalLights.value=et.state.directional,$t.directionalLightShadows.value=et.state.directionalShadow,$t.spotLights.value=et.state.spot,$t.spotLightShadows.value=et.state.spotShadow,$t.rectAreaLights.value=et.state.rectArea,$t.ltc_1.value=et.state.rectAreaLTC1,$t.ltc_2.value=et.state.rectAreaLTC2,$t.pointLights.value=et.state.point,$t.pointLightShadows.value=et.state.pointShadow,$t.hemisphereLights.value=et.state.hemi,$t.sunShadowMatrix.value=et.state.sunShadowMatrix,$t.sunShadowCascade.value=et.state.sunShadowCascade,$t.directionalShadowMatrix.value=et.state.directionalShadowMatrix,$t.spotLightMatrix.value=et.state.spotLightMatrix,$t.spotLightMap.value=et.state.spotLightMap,$t.pointShadowMatrix.value=et.state.pointShadowMatrix),tt.numLightProbeGrids=cn(w.state.lightProbeGridArray),tt.currentProgram=_e,tt.uniformsList=null,_e}function ti(A,X,it,tt,et){let Lt=Yt.get(A),kt=Lt.currentProgram.id+","+tt+","+et,Dt=Lt.programVariants.get(kt);return Dt===void 0?(Dt=Hi(A,X,it),Lt.programVariants.set(kt,Dt)):(Lt.currentProgram=Dt,Lt.uniformsList=null,Lt.outputColorSpace=tt,Lt.toneMapping=et),Dt}function Is(A){if(A.uniformsList===null){let X=A.currentProgram.getUniforms();A.uniformsList=Vo.seqWithValue(X.seq,A.uniforms)}return A.uniformsList}function qo(A,X){let it=Yt.get(A);it.outputColorSpace=X.outputColorSpace,it.batching=X.batching,it.batchingColor=X.batchingColor,it.instancing=X.instancing,it.instancingColor=X.instancingColor,it.instancingMorph=X.instancingMorph,it.skinning=X.skinning,it.morphTargets=X.morphTargets,it.morphNormals=X.morphNormals,it.morphColors=X.morphColors,it.morphTargetsCount=X.morphTargetsCount,it.numClippingPlanes=X.numClippingPlanes,it.numIntersection=X.numClipIntersection,it.vertexAlphas=X.vertexAlphas,it.vertexTangents=X.vertexTangents,it.toneMapping=X.toneMapping}function Yo(A,X,it,tt,et){X.isScene!==!0&&(X=Ge),Kt.resetTextureUnits();let Lt=X.fog,kt=tt.isMeshStandardMaterial||tt.isMeshLambertMaterial||tt.isMeshPhongMaterial?X.environment:null,Dt=J===null?D.outputColorSpace:J.isXRRenderTarget===!0?J.texture.colorSpace:Se.workingColorSpace,Bt=tt.isMeshStandardMaterial||tt.isMeshLambertMaterial&&!tt.envMap||tt.isMeshPhongMaterial&&!tt.envMap,qt=P.get(tt.envMap||kt,Bt),oe=tt.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,_e=!!it.attributes.tangent&&(!!tt.normalMap||tt.anisotropy>0),$t=!!it.morphAttributes.position,xe=!!it.morphAttributes.normal,Qe=!!it.morphAttributes.color,De=ss;tt.toneMapped&&(J===null||J.isXRRenderTarget===!0)&&(De=D.toneMapping);let Ne=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,gn=Ne!==void 0?Ne.length:0,Ht=Yt.get(tt),hn=w.state.lights;if(ee===!0&&(we===!0||A!==K)){let Ue=A===K&&tt.id===Z;at.setState(tt,A,Ue)}let be=!1,cs=!1;tt.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==hn.state.version||et.isBatchedMesh&&Ht.batching===!1||!et.isBatchedMesh&&Ht.batching===!0||et.isBatchedMesh&&Ht.batchingColor===!0&&et._colorsTexture===null||et.isBatchedMesh&&Ht.batchingColor===!1&&et._colorsTexture!==null||et.isInstancedMesh&&Ht.instancing===!1||!et.isInstancedMesh&&Ht.instancing===!0||et.isSkinnedMesh&&Ht.skinning===!1||!et.isSkinnedMesh&&Ht.skinning===!0||et.isInstancedMesh&&Ht.instancingColor===!0&&et.instanceColor===null||et.isInstancedMesh&&Ht.instancingColor===!1&&et.instanceColor!==null||et.isInstancedMesh&&Ht.instancingMorph===!0&&et.morphTexture===null||et.isInstancedMesh&&Ht.instancingMorph===!1&&et.morphTexture!==null||Ht.envMap!==qt||tt.fog===!0&&Ht.fog!==Lt||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==at.numPlanes||Ht.numIntersection!==at.numIntersection)||Ht.vertexAlphas!==oe||Ht.vertexTangents!==_e||Ht.morphTargets!==$t||Ht.morphNormals!==xe||Ht.morphColors!==Qe||Ht.morphTargetsCount!==gn||Ht.numLightProbeGrids!==cn(w.state.lightProbeGridArray)?be=!0:(Ht.outputColorSpace!==Dt||Ht.toneMapping!==De)&&(cs=!0):(be=!0,Ht.__version=tt.version);let un=Ht.currentProgram;(be===!0||cs===!0)&&(un=cs===!0?ti(tt,X,et,Dt,De):Hi(tt,X,et),G&&tt.isNodeMaterial&&G.onUpdateProgram(tt,un,Ht));let Fr=!1,Wi=!1,hs=!1,pe=un.getUniforms(),sn=Ht.uniforms;if(Pt.useProgram(un.program)&&(Fr=!0,Wi=!0,hs=!0),tt.id!==Z&&(Z=tt.id,Wi=!0),Fr||K!==A){Pt.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),pe.setValue(B,"projectionMatrix",A.projectionMatrix),pe.setValue(B,"viewMatrix",A.matrixWorldInverse);let dn=pe.map.cameraPosition;dn!==void 0&&dn.setValue(B,ke.setFromMatrixPosition(A.matrixWorld)),ue.logarithmicDepthBuffer&&pe.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(tt.isMeshPhongMaterial||tt.isMeshToonMaterial||tt.isMeshLambertMaterial||tt.isMeshBasicMaterial||tt.isMeshStandardMaterial||tt.isShaderMaterial)&&pe.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),K!==A&&(K=A,Wi=!0,hs=!0)}if(Ht.needsLights&&(hn.state.sunShadowMap.length>0&&pe.setValue(B,"sunShadowMap",hn.state.sunShadowMap,Kt),hn.state.directionalShadowMap.length>0&&pe.setValue(B,"directionalShadowMap",hn.state.directionalShadowMap,Kt),hn.state.spotShadowMap.length>0&&pe.setValue(B,"spotShadowMap",hn.state.spotShadowMap,Kt),hn.state.pointShadowMap.length>0&&pe.setValue(B,"pointShadowMap",hn.state.pointShadowMap,Kt)),et.isSkinnedMesh){pe.setOptional(B,et,"bindMatrix"),pe.setOptional(B,et,"bindMatrixInverse");let Ue=et.skeleton;Ue&&(Ue.boneTexture===null&&Ue.computeBoneTexture(),pe.setValue(B,"boneTexture",Ue.boneTexture,Kt))}et.isBatchedMesh&&(pe.setOptional(B,et,"batchingTexture"),pe.setValue(B,"batchingTexture",et._matricesTexture,Kt),pe.setOptional(B,et,"batchingIdTexture"),pe.setValue(B,"batchingIdTexture",et._indirectTexture,Kt),pe.setOptional(B,et,"batchingColorTexture"),et._colorsTexture!==null&&pe.setValue(B,"batchingColorTexture",et._colorsTexture,Kt));let zn=it.morphAttributes;if((zn.position!==void 0||zn.normal!==void 0||zn.color!==void 0)&&ct.update(et,it,un),(Wi||Ht.receiveShadow!==et.receiveShadow)&&(Ht.receiveShadow=et.receiveShadow,pe.setValue(B,"receiveShadow",et.receiveShadow)),(tt.isMeshStandardMaterial||tt.isMeshLambertMaterial||tt.isMeshPhongMaterial)&&tt.envMap===null&&X.environment!==null&&(sn.envMapIntensity.value=X.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=tA()),Wi){if(pe.setValue(B,"toneMappingExposure",D.toneMappingExposure),Ht.needsLights&&Nr(sn,hs),Lt&&tt.fog===!0&&Et.refreshFogUniforms(sn,Lt),Et.refreshMaterialUniforms(sn,tt,bt,St,w.state.transmissionRenderTarget[A.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let Ue=b,dn=0;for(let Nn of w.state.lightProbeGridArray)Nn.texture!==null&&(Ue.textures[dn]=Nn.texture,Ue.min[dn]=Nn.boundingBox.min,Ue.max[dn]=Nn.boundingBox.max,Ue.resolution[dn]=Nn.resolution,dn++);for(let Nn in Ue)Ue[Nn].length=dn;sn.probesSH.value=Ue.textures,sn.probesMin.value=Ue.min,sn.probesMax.value=Ue.max,sn.probesResolution.value=Ue.resolution}Vo.upload(B,Is(Ht),sn,Kt)}if(tt.isShaderMaterial&&tt.uniformsNeedUpdate===!0&&(Vo.upload(B,Is(Ht),sn,Kt),tt.uniformsNeedUpdate=!1),tt.isSpriteMaterial&&pe.setValue(B,"center",et.center),pe.setValue(B,"modelViewMatrix",et.modelViewMatrix),pe.setValue(B,"normalMatrix",et.normalMatrix),pe.setValue(B,"modelMatrix",et.matrixWorld),tt.uniformsGroups!==void 0){let Ue=tt.uniformsGroups;for(let dn=0,Nn=Ue.length;dn<Nn;dn++){let yl=Ue[dn];Zt.update(yl,un),Zt.bind(yl,un)}}return un}function Nr(A,X){A.ambientLightColor.needsUpdate=X,A.lightProbe.needsUpdate=X,A.sunLights.needsUpdate=X,A.sunLightShadows.needsUpdate=X,A.directionalLights.needsUpdate=X,A.directionalLightShadows.needsUpdate=X,A.pointLights.needsUpdate=X,A.pointLightShadows.needsUpdate=X,A.spotLights.needsUpdate=X,A.spotLightShadows.needsUpdate=X,A.rectAreaLights.needsUpdate=X,A.hemisphereLights.needsUpdate=X}function Ls(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return J},this.setRenderTargetTextures=function(A,X,it){let tt=Yt.get(A);tt.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,tt.__autoAllocateDepthBuffer===!1&&(tt.__useRenderToTexture=!1),Yt.get(A.texture).__webglTexture=X,Yt.get(A.depthTexture).__webglTexture=tt.__autoAllocateDepthBuffer?void 0:it,tt.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,X){let it=Yt.get(A);it.__webglFramebuffer=X,it.__useDefaultFramebuffer=X===void 0},this.setRenderTarget=function(A,X=0,it=0){J=A,q=X,V=it;let tt=null,et=!1,Lt=!1;if(A){let Dt=Yt.get(A);if(Dt.__useDefaultFramebuffer!==void 0){Pt.bindFramebuffer(B.FRAMEBUFFER,Dt.__webglFramebuffer),W.copy(A.viewport),st.copy(A.scissor),lt=A.scissorTest,Pt.viewport(W),Pt.scissor(st),Pt.setScissorTest(lt),Z=-1;return}else if(Dt.__webglFramebuffer===void 0)Kt.setupRenderTarget(A);else if(Dt.__hasExternalTextures)Kt.rebindTextures(A,Yt.get(A.texture).__webglTexture,Yt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let oe=A.depthTexture;if(Dt.__boundDepthTexture!==oe){if(oe!==null&&Yt.has(oe)&&(A.width!==oe.image.width||A.height!==oe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(A)}}let Bt=A.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(Lt=!0);let qt=Yt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(qt[X])?tt=qt[X][it]:tt=qt[X],et=!0):A.samples>0&&Kt.useMultisampledRTT(A)===!1?tt=Yt.get(A).__webglMultisampledFramebuffer:Array.isArray(qt)?tt=qt[it]:tt=qt,W.copy(A.viewport),st.copy(A.scissor),lt=A.scissorTest}else W.copy(ft).multiplyScalar(bt).floor(),st.copy(yt).multiplyScalar(bt).floor(),lt=Nt;if(it!==0&&(tt=H),Pt.bindFramebuffer(B.FRAMEBUFFER,tt)&&Pt.drawBuffers(A,tt),Pt.viewport(W),Pt.scissor(st),Pt.setScissorTest(lt),et){let Dt=Yt.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+X,Dt.__webglTexture,it)}else if(Lt){let Dt=X;for(let Bt=0;Bt<A.textures.length;Bt++){let qt=Yt.get(A.textures[Bt]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Bt,qt.__webglTexture,it,Dt)}}else if(A!==null&&it!==0){let Dt=Yt.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Dt.__webglTexture,it)}Z=-1};function Ur(A){let X=Yt.get(A);return(X.__readFormat!==A.format||X.__readType!==A.type)&&(X.__readFormat=A.format,X.__readType=A.type,X.__formatReadable=ue.textureFormatReadable(A.format),X.__typeReadable=ue.textureTypeReadable(A.type)),X}this.readRenderTargetPixels=function(A,X,it,tt,et,Lt,kt,Dt=0){if(!(A&&A.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Yt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&kt!==void 0&&(Bt=Bt[kt],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){Pt.bindFramebuffer(B.FRAMEBUFFER,Bt);try{let qt=A.textures[Dt],oe=qt.format,_e=qt.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Dt);let $t=Ur(qt);if($t.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($t.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}X>=0&&X<=A.width-tt&&it>=0&&it<=A.height-et&&B.readPixels(X,it,tt,et,wt.convert(oe),wt.convert(_e),Lt)}finally{let qt=J!==null?Yt.get(J).__webglFramebuffer:null;Pt.bindFramebuffer(B.FRAMEBUFFER,qt)}}},this.readRenderTargetPixelsAsync=async function(A,X,it,tt,et,Lt,kt,Dt=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Yt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&kt!==void 0&&(Bt=Bt[kt],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(X>=0&&X<=A.width-tt&&it>=0&&it<=A.height-et){Pt.bindFramebuffer(B.FRAMEBUFFER,Bt);let qt=A.textures[Dt],oe=qt.format,_e=qt.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Dt);let $t=Ur(qt);if($t.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($t.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,xe),B.bufferData(B.PIXEL_PACK_BUFFER,Lt.byteLength,B.STREAM_READ),B.readPixels(X,it,tt,et,wt.convert(oe),wt.convert(_e),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Qe=J!==null?Yt.get(J).__webglFramebuffer:null;Pt.bindFramebuffer(B.FRAMEBUFFER,Qe);let De=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await l_(B,De,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,xe),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Lt),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(xe),B.deleteSync(De),Lt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,X=null,it=0){let tt=Math.pow(2,-it),et=Math.floor(A.image.width*tt),Lt=Math.floor(A.image.height*tt),kt=X!==null?X.x:0,Dt=X!==null?X.y:0;Kt.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,it,0,0,kt,Dt,et,Lt),Pt.unbindTexture()},this.copyTextureToTexture=function(A,X,it=null,tt=null,et=0,Lt=0){let kt,Dt,Bt,qt,oe,_e,$t,xe,Qe,De=A.isCompressedTexture?A.mipmaps[Lt]:A.image;if(it!==null)kt=it.max.x-it.min.x,Dt=it.max.y-it.min.y,Bt=it.isBox3?it.max.z-it.min.z:1,qt=it.min.x,oe=it.min.y,_e=it.isBox3?it.min.z:0;else{let pe=Math.pow(2,-et);kt=Math.floor(De.width*pe),Dt=Math.floor(De.height*pe),A.isDataArrayTexture?Bt=De.depth:A.isData3DTexture?Bt=Math.floor(De.depth*pe):Bt=1,qt=0,oe=0,_e=0}tt!==null?($t=tt.x,xe=tt.y,Qe=tt.z):($t=0,xe=0,Qe=0);let Ne=wt.convert(X.format),gn=wt.convert(X.type),Ht;X.isData3DTexture?(Kt.setTexture3D(X,0),Ht=B.TEXTURE_3D):X.isDataArrayTexture||X.isCompressedArrayTexture?(Kt.setTexture2DArray(X,0),Ht=B.TEXTURE_2D_ARRAY):(Kt.setTexture2D(X,0),Ht=B.TEXTURE_2D),Pt.activeTexture(B.TEXTURE0),Pt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,X.flipY),Pt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,X.premultiplyAlpha),Pt.pixelStorei(B.UNPACK_ALIGNMENT,X.unpackAlignment);let hn=Pt.getParameter(B.UNPACK_ROW_LENGTH),be=Pt.getParameter(B.UNPACK_IMAGE_HEIGHT),cs=Pt.getParameter(B.UNPACK_SKIP_PIXELS),un=Pt.getParameter(B.UNPACK_SKIP_ROWS),Fr=Pt.getParameter(B.UNPACK_SKIP_IMAGES);Pt.pixelStorei(B.UNPACK_ROW_LENGTH,De.width),Pt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,De.height),Pt.pixelStorei(B.UNPACK_SKIP_PIXELS,qt),Pt.pixelStorei(B.UNPACK_SKIP_ROWS,oe),Pt.pixelStorei(B.UNPACK_SKIP_IMAGES,_e);let Wi=A.isDataArrayTexture||A.isData3DTexture,hs=X.isDataArrayTexture||X.isData3DTexture;if(A.isDepthTexture){let pe=Yt.get(A),sn=Yt.get(X),zn=Yt.get(pe.__renderTarget),Ue=Yt.get(sn.__renderTarget);Pt.bindFramebuffer(B.READ_FRAMEBUFFER,zn.__webglFramebuffer),Pt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let dn=0;dn<Bt;dn++)Wi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Yt.get(A).__webglTexture,et,_e+dn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Yt.get(X).__webglTexture,Lt,Qe+dn)),B.blitFramebuffer(qt,oe,qt+kt,oe+Dt,$t,xe,$t+kt,xe+Dt,B.DEPTH_BUFFER_BIT,B.NEAREST);Pt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Pt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(et!==0||A.isRenderTargetTexture||Yt.has(A)){let pe=Yt.get(A),sn=Yt.get(X);Pt.bindFramebuffer(B.READ_FRAMEBUFFER,N),Pt.bindFramebuffer(B.DRAW_FRAMEBUFFER,F);for(let zn=0;zn<Bt;zn++)Wi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,pe.__webglTexture,et,_e+zn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,pe.__webglTexture,et),hs?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,sn.__webglTexture,Lt,Qe+zn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,sn.__webglTexture,Lt),et!==0?B.blitFramebuffer(qt,oe,qt+kt,oe+Dt,$t,xe,$t+kt,xe+Dt,B.COLOR_BUFFER_BIT,B.NEAREST):hs?B.copyTexSubImage3D(Ht,Lt,$t,xe,Qe+zn,qt,oe,kt,Dt):B.copyTexSubImage2D(Ht,Lt,$t,xe,qt,oe,kt,Dt);Pt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Pt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else hs?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Ht,Lt,$t,xe,Qe,kt,Dt,Bt,Ne,gn,De.data):X.isCompressedArrayTexture?B.compressedTexSubImage3D(Ht,Lt,$t,xe,Qe,kt,Dt,Bt,Ne,De.data):B.texSubImage3D(Ht,Lt,$t,xe,Qe,kt,Dt,Bt,Ne,gn,De):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Lt,$t,xe,kt,Dt,Ne,gn,De.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Lt,$t,xe,De.width,De.height,Ne,De.data):B.texSubImage2D(B.TEXTURE_2D,Lt,$t,xe,kt,Dt,Ne,gn,De);Pt.pixelStorei(B.UNPACK_ROW_LENGTH,hn),Pt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,be),Pt.pixelStorei(B.UNPACK_SKIP_PIXELS,cs),Pt.pixelStorei(B.UNPACK_SKIP_ROWS,un),Pt.pixelStorei(B.UNPACK_SKIP_IMAGES,Fr),Lt===0&&X.generateMipmaps===!0&&X.mipmapsAutoUpdate===!0&&B.generateMipmap(Ht),Pt.unbindTexture()},this.initRenderTarget=function(A){Yt.get(A).__webglFramebuffer===void 0&&Kt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Kt.setTextureCube(A,0):A.isData3DTexture?Kt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Kt.setTexture2DArray(A,0):Kt.setTexture2D(A,0),Pt.unbindTexture()},this.resetState=function(){q=0,V=0,J=null,Pt.reset(),Ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var Jh=3,Wf=18,Kh=13;function j_(){let i=C("div",{class:"labels","aria-hidden":"true","data-test":"labels"}),t=[],e=!0,n=(r,o)=>r.left<o.right+Jh&&o.left<r.right+Jh&&r.top<o.bottom+Jh&&o.top<r.bottom+Jh;function s({camera:r,width:o,height:a,free:c}){let l=new k,u=d=>(l.set(...d).project(r),[(l.x+1)/2*o,(1-l.y)/2*a]),h=c.map(u).map(([d,f])=>({left:d-Kh,right:d+Kh,top:f-Kh,bottom:f+Kh}));for(let d of t){let{label:f,anchors:p,kind:x}=d;d.size?.[0]||(d.size=[f.offsetWidth,f.offsetHeight]);let[m,g]=d.size,M=p().flatMap(b=>{let[R,w]=u(b),_=l.z<1;return(x==="tick"?[[-m/2,-g/2]]:[[-m/2,-g-6],[-m/2,Wf],[Wf,-g/2],[-m-Wf,-g/2]]).map(([O,D])=>({left:R+O,right:R+O+m,top:w+D,bottom:w+D+g,seen:_}))}).find(b=>b.seen&&b.left>=2&&b.right<=o-2&&b.top>=2&&b.bottom<=a-2&&!h.some(R=>n(b,R)));f.style.visibility=M?"visible":"hidden",M&&(h.push(M),f.style.transform=`translate(${M.left.toFixed(1)}px, ${M.top.toFixed(1)}px)`)}}return{element:i,get on(){return e},toggle(){e=!e,i.hidden=!e},set(r){t=r.map(({text:o,kind:a,colour:c,anchors:l})=>({kind:a,anchors:l,label:C("span",{class:`tag ${a}`,style:c?`border-color:${c}`:null},o)})),i.replaceChildren(...t.map(({label:o})=>o))},place:r=>e&&s(r)}}var Q_={type:"change"},$f={type:"start"},ex={type:"end"},jh=new Ys,tx=new $n,eA=Math.cos(70*Cf.DEG2RAD),bn=new k,jn=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Xf=1e-6,Qh=class extends Qa{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:er.ROTATE,MIDDLE:er.DOLLY,RIGHT:er.PAN},this.touches={ONE:nr.ROTATE,TWO:nr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new Ln,this._lastTargetPosition=new k,this._quat=new Ln().setFromUnitVectors(t.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Fo,this._sphericalDelta=new Fo,this._scale=1,this._panOffset=new k,this._rotateStart=new Ot,this._rotateEnd=new Ot,this._rotateDelta=new Ot,this._panStart=new Ot,this._panEnd=new Ot,this._panDelta=new Ot,this._dollyStart=new Ot,this._dollyEnd=new Ot,this._dollyDelta=new Ot,this._dollyDirection=new k,this._mouse=new Ot,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=iA.bind(this),this._onPointerDown=nA.bind(this),this._onPointerUp=sA.bind(this),this._onContextMenu=uA.bind(this),this._onMouseWheel=aA.bind(this),this._onKeyDown=lA.bind(this),this._onTouchStart=cA.bind(this),this._onTouchMove=hA.bind(this),this._onMouseDown=rA.bind(this),this._onMouseMove=oA.bind(this),this._interceptControlDown=dA.bind(this),this._interceptControlUp=fA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Q_),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;bn.copy(e).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=jn:n>Math.PI&&(n-=jn),s<-Math.PI?s+=jn:s>Math.PI&&(s-=jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),e.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new k(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(jh.origin.copy(this.object.position),jh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(jh.direction))<eA?this.object.lookAt(this.target):(tx.setFromNormalAndCoplanarPoint(this.object.up,this.target),jh.intersectPlane(tx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Xf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Xf||this._lastTargetPosition.distanceToSquared(this.target)>Xf?(this.dispatchEvent(Q_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?jn/60*this.autoRotateSpeed*t:jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){bn.setFromMatrixColumn(e,0),bn.multiplyScalar(-t),this._panOffset.add(bn)}_panUp(t,e){this.screenSpacePanning===!0?bn.setFromMatrixColumn(e,1):(bn.setFromMatrixColumn(e,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(t),this._panOffset.add(bn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Ot,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function nA(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function iA(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function sA(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(ex),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function rA(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case er.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case er.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case er.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent($f)}function oA(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function aA(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent($f),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(ex))}function lA(i){this.enabled!==!1&&this._handleKeyDown(i)}function cA(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case nr.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case nr.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case nr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case nr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent($f)}function hA(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function uA(i){this.enabled!==!1&&i.preventDefault()}function dA(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function fA(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var pA=new k(0,0,1),Ho=Math.PI/180;function tu(i,t){return new k(Math.cos(i)*Math.cos(t),Math.sin(i)*Math.cos(t),Math.sin(t))}function qf(i,t,e){let n=Math.abs(t.z)>.999?new k(0,1,0):pA,s=new k().crossVectors(n,t).normalize(),r=new k().crossVectors(t,s),o=[s,r],a=new k;for(let h of[s,r,t]){let d=i.map(({p:f})=>h.dot(f));a.addScaledVector(h,(Math.min(...d)+Math.max(...d))/2)}let c=Math.tan(e.fov*Ho/2),l=[c*e.aspect,c],u=.3;for(let{p:h,radius:d}of i){let f=h.clone().sub(a);o.forEach((p,x)=>{let m=(Math.abs(p.dot(f))+d)/l[x]+t.dot(f)+d;u=Math.max(u,m)})}return{position:a.clone().addScaledVector(t,1.06*u),target:a,distance:u}}var mA=1.25;function eu({points:i,others:t},e,n){let s=qf(i,e,n),r=mA*s.distance,o=i;for(let a of t){let c=qf([...o,...a],e,n);c.distance<=r&&(o=[...o,...a],s=c)}return s}function nx(i,t,{a:e,b:n,top:s}){let[r,o]=[t[0]-i[0],t[1]-i[1]],[a,c]=[n[0]-e[0],n[1]-e[1]],l=r*c-o*a,u=((e[0]-i[0])*c-(e[1]-i[1])*a)/l,h=((e[0]-i[0])*o-(e[1]-i[1])*r)/l;return l!==0&&u>0&&u<1&&h>0&&h<1&&i[2]+u*(t[2]-i[2])<s}function ix(i,t){let{points:e,capsules:n,walls:s,contact:r,person:o,robot:a}=i,c=Math.atan2(a[1]-o[1],a[0]-o[0]),l=24*Ho,u=[];for(let p=-175;p<=180;p+=5){let x=tu(c+p*Ho,l),m=qf(e,x,t),g=m.position.toArray(),y=n.filter(R=>Dp(g,r,R)).length,M=s.filter(R=>R.some(w=>nx(g,r,w)||nx(g,[...o,1],w))).length,b=Math.abs(Math.abs(p)-115)/60;u.push({towards:x,distance:m.distance,cost:y+.6*Math.min(M,2)+b})}let h=Math.min(...u.map(p=>p.distance)),d=p=>p.cost+1.5*(p.distance/h-1),f=u.reduce((p,x)=>d(x)<d(p)?x:p);return eu(i,f.towards,t)}function sx(i,t,e){let{contact:n,person:s,robot:r}=t,o=Math.atan2(r[1]-s[1],r[0]-s[0]);switch(i){case"top":return eu(t,tu(-Math.PI/2,89.9*Ho),e);case"front":return eu(t,tu(-Math.PI/2,6*Ho),e);case"side":return eu(t,tu(0,6*Ho),e);case"contact":{let a=ix(t,e),c=new k(...n),l=a.position.clone().sub(a.target).normalize();return{position:c.clone().addScaledVector(l,1.1),target:c}}case"eye":{let a=new k(...t.head),c=new k(...n);return a.distanceTo(c)<.4&&c.copy(a).add(new k(Math.cos(o),Math.sin(o),-.2)),{position:a,target:c}}default:return ix(t,e)}}var iu=20,nu=.08,gA=.05,rx=.11,_A=.2,xA=.7,yA=new Fi({color:"#59636f"});function ox(){let i=new Le(new Tr(iu,iu),new Ha({opacity:.18}));return i.receiveShadow=!0,i.position.z=.002,i}function ax({axis:i,grid:t}){let e=new ja(iu,iu,i,t);return e.rotation.x=Math.PI/2,e}var su=class extends Js{constructor(){super(new Ze,new Ui)}set colour(t){this.material.color=new he(t)}fit(t,e){let[[n,s],[r,o]]=t.map(([M,b])=>[M-.05,b+.05]),a=(M,b)=>Array.from({length:Math.max(0,Math.floor(b)-Math.ceil(M)+1)},(R,w)=>Math.ceil(M)+w),c=(M,b,R,w)=>b.every(_=>Math.abs(_-w)>=Math.abs(R-w))?`${M} ${R} m`:`${R}`,[l,u]=[a(n,s),a(r,o)],h=(M,b,R)=>Math.abs(b-R)>Math.abs(M-R)?[b,1]:[M,-1],[[d,f],[p,x]]=[h(n,s,e.x),h(r,o,e.y)],m=.014,g=[n,p,m,s,p,m,d,r,m,d,o,m],y=[];for(let M of l)g.push(M,p,m,M,p+x*nu,m),y.push({text:c("x",l,M,d),at:[M,p+2.6*x*nu,0]});for(let M of u)g.push(d,M,m,d+f*nu,M,m),y.push({text:c("y",u,M,p),at:[d+2.6*f*nu,M,0]});return this.geometry.dispose(),this.geometry=new Ze().setAttribute("position",new ye(g,3)),y}};function vA([i,t,e],n){let s=0;for(let r of n){let o=r.size_m[2]/2,[a,c]=[r.centre_m[2]-o,r.centre_m[2]+o];El([i,t],Pn(r))&&a<e&&(s=Math.max(s,Math.min(c,e)))}return e-s>gA?s:null}function lx([i,t],e,n,s,r){let o=new Le(new wr(s,1.2*s,n-e,28),yA);return o.rotation.x=Math.PI/2,o.position.set(i,t,(e+n)/2),o.castShadow=!0,o.userData.name=`${r} (drawn by the report; not in the cell file)`,o}function cx({robots:i,obstacles:t}){return(i??[]).flatMap(({name:e,base_m:n,upright:s})=>{let r=n&&s?vA(n,t):null;return r===null?[]:[lx(n,r,n[2],rx,`below ${e}`)]})}function hx(i,t){return(i.robots??[]).flatMap(({name:e,base_m:n,upright:s})=>{if(!n||!s)return[];let o=i.links.flatMap((l,u)=>l.robot===e?ea(t,i,0,u).map(h=>({p:h,radius:l.radius_m??0})):[]).filter(({p:l})=>Math.hypot(l[0]-n[0],l[1]-n[1])<_A),a=Math.min(...o.map(({p:l,radius:u})=>l[2]-u)),c=a-n[2];return c>.01&&c<xA?[lx(n,n[2],a+.02,.8*rx,`base of ${e}`)]:[]})}var ux=10,dx=.8,bA=(i,t)=>[Math.min(...i.map(({p:e})=>e.getComponent(t))),Math.max(...i.map(({p:e})=>e.getComponent(t)))];function MA(i,t){let e=[],n=(o,a)=>o.forEach(c=>e.push({p:new k(...c),radius:a})),s=i.contact_frame,r=new Set(Array.from({length:ux+1},(o,a)=>Math.round(a*s/ux)));for(let o of r)t.body.forEach((a,c)=>{let{a:l,b:u,radius:h}=_i(i,t,o,c);n([l,u],h)}),hr.forEach((a,c)=>n(ur(i,o,c),.06)),t.links.forEach((a,c)=>n(ea(i,t,o,c),a.radius_m??0));return n([i.contact_m],.1),e}function fx(i,t,[e,n]){let s=([r,o],a)=>Math.max(r-dx,Math.min(o+dx,a));return i.flatMap(([r,o])=>t.map(a=>({p:new k(s(e,r),s(n,o),a),radius:.03})))}function Yf([i,t],e){let n=e.map((s,r)=>[[...s,0],[...e[(r+1)%e.length],0]]);return Math.min(...n.map(([s,r])=>Bs([i,t,0],s,r)))}function SA({zones:i,obstacles:t}){let e=(n,s)=>n.map((r,o)=>({a:r,b:n[(o+1)%n.length],top:s}));return[...i.filter(({kind:n})=>n==="curtain"||n==="door").map(n=>e(n.polygon_m,n.z_m[1])),...t.map(n=>e(Pn(n),n.centre_m[2]+n.size_m[2]/2))]}function px(i,t,e){let n=MA(i,t),s=[0,1].map(h=>bA(n,h)),r=i.contact_frame,o=[...t.links.keys()],a=[...t.body.keys()].map(h=>_i(i,t,r,h)).concat(o.map(h=>Ji(i,t,r,h)).filter(h=>!h.position)),c=t.zones.filter(h=>i.sensors.find(({name:d})=>d===h.name)?.detected.includes("1")),l=t.obstacles.map(h=>({item:h,distance:Yf(i.contact_m,Pn(h))})).sort((h,d)=>h.distance-d.distance),u=[0,1].map(h=>o.reduce((d,f)=>d+ea(i,t,r,f)[0][h],0)/o.length);return{points:n,bounds:s,others:[...c.map(h=>fx(h.polygon_m,h.z_m,s)),...l.slice(0,1).map(({item:h})=>fx(Pn(h),[-.5,.5].map(d=>h.centre_m[2]+d*h.size_m[2]),s))],capsules:a.filter(({a:h,b:d,radius:f})=>Bs(i.contact_m,h,d)>f+.03),contact:i.contact_m,person:e.person_xy_m,robot:u,walls:SA(t)}}var wA=8,Zf=i=>[0,1,2].map(t=>i.reduce((e,n)=>e+n[t],0)/i.length),EA=(i,t)=>[...i].sort((e,n)=>Math.hypot(e[0]-t[0],e[1]-t[1])-Math.hypot(n[0]-t[0],n[1]-t[1]));function mx(i,t,e){let n=i.map((s,r)=>Zf([[...s,t],[...i[(r+1)%i.length],t]]));return EA([...n,...i.map(s=>[...s,t])],e)}function gx({replay:i,cell:t,hazard:e,hitting:n,marks:s,colours:r,frame:o}){let a=i.contact_m,c=f=>()=>f,l=()=>{let f=Ji(i,t,o(),n),p=f.position?$r(t.links[n],f):[f.a,f.b],[x,m]=Zf(p),g=Math.max(...p.map(y=>y[2]))+(f.radius??0);return[[x,m,g],Zf(p)]},u=t.zones.map(f=>{let p=f.kind==="curtain"||f.kind==="door",x=mx(f.polygon_m,p?f.z_m[1]:Math.max(...f.z_m),a);return{text:f.title,kind:"zone",colour:r[f.kind],anchors:c(x)}}),h=t.obstacles.map((f,p)=>({item:f,index:p,polygon:Pn(f),distance:Yf(a,Pn(f))})).sort((f,p)=>f.distance-p.distance).slice(0,wA).map(({item:f,index:p,polygon:x})=>{let m=(i.moved??[]).find(({obstacle:M})=>M===p);if(m){let M=()=>[...m.centre_m.slice(3*o(),3*o()+3)];return{text:f.name,kind:"obstacle",anchors:()=>m.there[o()]==="1"?[M()]:[]}}let g=[.5,0,-.45].map(M=>f.centre_m[2]+M*f.size_m[2]),y=g.flatMap(M=>mx(x,M,a));return{text:f.name,kind:"obstacle",anchors:c([[...f.centre_m.slice(0,2),g[0]],...y])}}),d=s.map(({text:f,at:p})=>({text:f,kind:"tick",anchors:c([p])}));return[{text:e.robot_link,kind:"hitting",anchors:l},...u,...h,...d]}var ou=0,TA=1,AA=new k,_x=new Ka,Jf=new $n,xx=new k,ru=new Di,au=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new lu,this.unassigned=new lu,this.vertices=[]}setFromPoints(t){if(t.length>=4){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.vertices.push(new Kf(t[e]));this._compute()}return this}setFromObject(t){let e=[];return t.updateMatrixWorld(!0),t.traverse(function(n){let s=n.geometry;if(s!==void 0){let r=s.attributes.position;if(r!==void 0)for(let o=0,a=r.count;o<a;o++){let c=new k;c.fromBufferAttribute(r,o).applyMatrix4(n.matrixWorld),e.push(c)}}}),this.setFromPoints(e)}containsPoint(t){let e=this.faces;for(let n=0,s=e.length;n<s;n++)if(e[n].distanceToPoint(t)>this.tolerance)return!1;return!0}intersectRay(t,e){let n=this.faces,s=-1/0,r=1/0;for(let o=0,a=n.length;o<a;o++){let c=n[o],l=c.distanceToPoint(t.origin),u=c.normal.dot(t.direction);if(l>0&&u>=0)return null;let h=u!==0?-l/u:0;if(!(h<=0)&&(u>0?r=Math.min(h,r):s=Math.max(h,s),s>r))return null}return s!==-1/0?t.at(s,e):t.at(r,e),e}intersectsRay(t){return this.intersectRay(t,AA)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(t,e){return t.face=e,e.outside===null?this.assigned.append(t):this.assigned.insertBefore(e.outside,t),e.outside=t,this}_removeVertexFromFace(t,e){return t===e.outside&&(t.next!==null&&t.next.face===e?e.outside=t.next:e.outside=null),this.assigned.remove(t),this}_removeAllVerticesFromFace(t){if(t.outside!==null){let e=t.outside,n=t.outside;for(;n.next!==null&&n.next.face===t;)n=n.next;return this.assigned.removeSubList(e,n),e.prev=n.next=null,t.outside=null,e}}_deleteFaceVertices(t,e){let n=this._removeAllVerticesFromFace(t);if(n!==void 0)if(e===void 0)this.unassigned.appendChain(n);else{let s=n;do{let r=s.next;e.distanceToPoint(s.point)>this.tolerance?this._addVertexToFace(s,e):this.unassigned.append(s),s=r}while(s!==null)}return this}_resolveUnassignedPoints(t){if(this.unassigned.isEmpty()===!1){let e=this.unassigned.first();do{let n=e.next,s=this.tolerance,r=null;for(let o=0;o<t.length;o++){let a=t[o];if(a.mark===ou){let c=a.distanceToPoint(e.point);if(c>s&&(s=c,r=a),s>1e3*this.tolerance)break}}r!==null&&this._addVertexToFace(e,r),e=n}while(e!==null)}return this}_computeExtremes(){let t=new k,e=new k,n=[],s=[];for(let r=0;r<3;r++)n[r]=s[r]=this.vertices[0];t.copy(this.vertices[0].point),e.copy(this.vertices[0].point);for(let r=0,o=this.vertices.length;r<o;r++){let a=this.vertices[r],c=a.point;for(let l=0;l<3;l++)c.getComponent(l)<t.getComponent(l)&&(t.setComponent(l,c.getComponent(l)),n[l]=a);for(let l=0;l<3;l++)c.getComponent(l)>e.getComponent(l)&&(e.setComponent(l,c.getComponent(l)),s[l]=a)}return this.tolerance=3*Number.EPSILON*(Math.max(Math.abs(t.x),Math.abs(e.x))+Math.max(Math.abs(t.y),Math.abs(e.y))+Math.max(Math.abs(t.z),Math.abs(e.z))),{min:n,max:s}}_computeInitialHull(){let t=this.vertices,e=this._computeExtremes(),n=e.min,s=e.max,r=0,o=0;for(let d=0;d<3;d++){let f=s[d].point.getComponent(d)-n[d].point.getComponent(d);f>r&&(r=f,o=d)}let a=n[o],c=s[o],l,u;r=0,_x.set(a.point,c.point);for(let d=0,f=this.vertices.length;d<f;d++){let p=t[d];if(p!==a&&p!==c){_x.closestPointToPoint(p.point,!0,xx);let x=xx.distanceToSquared(p.point);x>r&&(r=x,l=p)}}r=-1,Jf.setFromCoplanarPoints(a.point,c.point,l.point);for(let d=0,f=this.vertices.length;d<f;d++){let p=t[d];if(p!==a&&p!==c&&p!==l){let x=Math.abs(Jf.distanceToPoint(p.point));x>r&&(r=x,u=p)}}let h=[];if(Jf.distanceToPoint(u.point)<0){h.push(Vi.create(a,c,l),Vi.create(u,c,a),Vi.create(u,l,c),Vi.create(u,a,l));for(let d=0;d<3;d++){let f=(d+1)%3;h[d+1].getEdge(2).setTwin(h[0].getEdge(f)),h[d+1].getEdge(1).setTwin(h[f+1].getEdge(0))}}else{h.push(Vi.create(a,l,c),Vi.create(u,a,c),Vi.create(u,c,l),Vi.create(u,l,a));for(let d=0;d<3;d++){let f=(d+1)%3;h[d+1].getEdge(2).setTwin(h[0].getEdge((3-d)%3)),h[d+1].getEdge(0).setTwin(h[f+1].getEdge(1))}}for(let d=0;d<4;d++)this.faces.push(h[d]);for(let d=0,f=t.length;d<f;d++){let p=t[d];if(p!==a&&p!==c&&p!==l&&p!==u){r=this.tolerance;let x=null;for(let m=0;m<4;m++){let g=this.faces[m].distanceToPoint(p.point);g>r&&(r=g,x=this.faces[m])}x!==null&&this._addVertexToFace(p,x)}}return this}_reindexFaces(){let t=[];for(let e=0;e<this.faces.length;e++){let n=this.faces[e];n.mark===ou&&t.push(n)}return this.faces=t,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let t,e=0,n=this.assigned.first().face,s=n.outside;do{let r=n.distanceToPoint(s.point);r>e&&(e=r,t=s),s=s.next}while(s!==null&&s.face===n);return t}}_computeHorizon(t,e,n,s){this._deleteFaceVertices(n),n.mark=TA;let r;e===null?r=e=n.getEdge(0):r=e.next;do{let o=r.twin,a=o.face;a.mark===ou&&(a.distanceToPoint(t)>this.tolerance?this._computeHorizon(t,o,a,s):s.push(r)),r=r.next}while(r!==e);return this}_addAdjoiningFace(t,e){let n=Vi.create(t,e.tail(),e.head());return this.faces.push(n),n.getEdge(-1).setTwin(e.twin),n.getEdge(0)}_addNewFaces(t,e){this.newFaces=[];let n=null,s=null;for(let r=0;r<e.length;r++){let o=e[r],a=this._addAdjoiningFace(t,o);n===null?n=a:a.next.setTwin(s),this.newFaces.push(a.face),s=a}return n.next.setTwin(s),this}_addVertexToHull(t){let e=[];return this.unassigned.clear(),this._removeVertexFromFace(t,t.face),this._computeHorizon(t.point,null,t.face,e),this._addNewFaces(t,e),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let t;for(this._computeInitialHull();(t=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(t);return this._reindexFaces(),this._cleanup(),this}},Vi=class i{constructor(){this.normal=new k,this.midpoint=new k,this.area=0,this.constant=0,this.outside=null,this.mark=ou,this.edge=null}static create(t,e,n){let s=new i,r=new dl(t,s),o=new dl(e,s),a=new dl(n,s);return r.next=a.prev=o,o.next=r.prev=a,a.next=o.prev=r,s.edge=r,s.compute()}getEdge(t){let e=this.edge;for(;t>0;)e=e.next,t--;for(;t<0;)e=e.prev,t++;return e}compute(){let t=this.edge.tail(),e=this.edge.head(),n=this.edge.next.head();return ru.set(t.point,e.point,n.point),ru.getNormal(this.normal),ru.getMidpoint(this.midpoint),this.area=ru.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(t){return this.normal.dot(t)-this.constant}},dl=class{constructor(t,e){this.vertex=t,this.prev=null,this.next=null,this.twin=null,this.face=e}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let t=this.head(),e=this.tail();return e!==null?e.point.distanceTo(t.point):-1}lengthSquared(){let t=this.head(),e=this.tail();return e!==null?e.point.distanceToSquared(t.point):-1}setTwin(t){return this.twin=t,t.twin=this,this}},Kf=class{constructor(t){this.point=t,this.prev=null,this.next=null,this.face=null}},lu=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(t,e){return e.prev=t.prev,e.next=t,e.prev===null?this.head=e:e.prev.next=e,t.prev=e,this}insertAfter(t,e){return e.prev=t,e.next=t.next,e.next===null?this.tail=e:e.next.prev=e,t.next=e,this}append(t){return this.head===null?this.head=t:this.tail.next=t,t.prev=this.tail,t.next=null,this.tail=t,this}appendChain(t){for(this.head===null?this.head=t:this.tail.next=t,t.prev=this.tail;t.next!==null;)t=t.next;return this.tail=t,this}remove(t){return t.prev===null?this.head=t.next:t.prev.next=t.next,t.next===null?this.tail=t.prev:t.next.prev=t.prev,this}removeSubList(t,e){return t.prev===null?this.head=e.next:t.prev.next=e.next,e.next===null?this.tail=t.prev:e.next.prev=t.prev,this}isEmpty(){return this.head===null}};var cu=class extends Ze{constructor(t=[]){super();let e=[],n=[],r=new au().setFromPoints(t).faces;for(let o=0;o<r.length;o++){let a=r[o],c=a.edge;do{let l=c.head().point;e.push(l.x,l.y,l.z),n.push(a.normal.x,a.normal.y,a.normal.z),c=c.next}while(c!==a.edge)}this.setAttribute("position",new ye(e,3)),this.setAttribute("normal",new ye(n,3))}};var fl=new Es(1,28,18),CA=new wr(1,1,1,28,1,!0),RA=new k(0,1,0),Rs=class extends hi{constructor(t,e){super(),this.tube=new Le(CA,e),this.ends=[new Le(fl,e),new Le(fl,e)],this.ends.forEach(n=>n.scale.setScalar(t)),this.radius=t,this.add(this.tube,...this.ends),this.children.forEach(n=>n.castShadow=!0)}place(t,e){let[n,s]=[new k(...t),new k(...e)],r=s.clone().sub(n),o=r.length();this.ends[0].position.copy(n),this.ends[1].position.copy(s),this.tube.visible=o>1e-6,this.tube.visible&&(this.tube.position.copy(n).addScaledVector(r,.5),this.tube.scale.set(this.radius,o,this.radius),this.tube.quaternion.setFromUnitVectors(RA,r.divideScalar(o)))}set material(t){this.children.forEach(e=>e.material=t)}},pl=class extends Le{constructor(t,e,n){if(e){let s=e.flatMap(r=>r.flatMap(o=>t[o]));super(new Ze().setAttribute("position",new ye(s,3)),n),this.geometry.computeVertexNormals()}else super(new cu(t.map(s=>new k(...s))),n);this.castShadow=!0}place(t,e){this.position.set(...t),this.quaternion.set(...e)}};function vx({centre_m:i,size_m:t,quaternion:e},n,s){let r=new Ks(...t),o=new Le(r,n);return o.add(new Js(new Da(r),s)),o.position.set(...i),o.quaternion.copy(new Ln(...e)),o}function PA(i,t,e){let n=[];return i.slice(i.length===2?1:0).forEach((s,r)=>{let o=i.at(i.length===2?0:r-1);n.push(...o,t,...s,t,...s,e,...o,t,...s,e,...o,e)}),new Ze().setAttribute("position",new ye(n,3))}function jf(i,t,e){return new Ra(new Ze().setFromPoints(i.map(([n,s])=>new k(n,s,t))),e)}var yx={mat:.16,field:.07,curtain:.1,door:.1,post:.07,button:.6},IA={mat:.55,field:.3,curtain:.26,door:.26,post:.3,button:1},hu=class extends hi{constructor({kind:t,polygon_m:e,z_m:[n,s]},r){super(),this.kind=t,this.fill=new Mi({color:r,transparent:!0,opacity:yx[t]??.1,side:Si,depthWrite:!1}),this.edge=new Ui({color:r});let o=Math.max(n,.006);if(t==="curtain"||t==="door"||t==="button")this.add(new Le(PA(e,n,s),this.fill),jf(e,o,this.edge),jf(e,s,this.edge));else{let a=t==="field"?Math.max(s,o):o,c=new Le(new Ga(new Lo(e.map(([l,u])=>new Ot(l,u)))),this.fill);c.position.z=a,this.add(c,jf(e,a,this.edge))}}set lit(t){let e=t?IA:yx;this.fill.opacity=e[this.kind]??.2}};function bx(i,t,e){let n=[];for(let s=1;s<i.length;s++){let[[r,o],[a,c]]=[i[s-1],i[s]],l=Math.hypot(a-r,c-o);if(l>1e-6){let[u,h]=[(o-c)/l*(t/2),(a-r)/l*(t/2)],d=.012;n.push(r+u,o+h,d,r-u,o-h,d,a-u,c-h,d,r+u,o+h,d,a-u,c-h,d,a+u,c+h,d)}}return new Le(new Ze().setAttribute("position",new ye(n,3)),e)}var gl={skin:"#e9bd97",shirt:"#8f8467",trousers:"#4b5058",shoes:"#3f352c",cap:"#8a5a2b",touched:"#c2185b"},Mx=[.095,.018,.043],Sx=[.145,.05,.06],wx=[.13,.22],Ex={from:.08,radius:.014},LA=.4,kn=Object.fromEntries(Object.entries(gl).map(([i,t])=>[i,new Fi({color:t})])),DA=new Mi({color:gl.touched,transparent:!0,opacity:.1,depthWrite:!1}),NA=new Es(1,28,12,0,2*Math.PI,0,Math.PI/2),Tx=new k(1,0,0),pi=i=>new k(...i);function uu(i,t){let e=new Le(fl,t);return e.scale.set(...i),e.castShadow=!0,e}function Ax(i){return/head|skull|face|neck/.test(i)?kn.skin:/thigh|shank|pelvis|leg/.test(i)?kn.trousers:kn.shirt}function UA(){let i=new Le(NA,kn.cap);i.scale.setScalar(1.07),i.position.y=.16;let t=uu([.72,.09,.74],kn.cap);t.position.set(.86,.3,0);let e=uu([.2,.24,.15],kn.skin);e.position.set(1,-.08,0);let n=new hi;return n.add(i,t,e),Object.assign(n,{hat:[i,t],nose:e})}var ml=class extends hi{constructor(t,e){super(),this.cell=t;let{upper_arm_radius_m:n,forearm_radius_m:s,hand_radius_m:r}=t.arm;this.parts=t.body.map(a=>e(new Rs(a.radius_m,Ax(a.region)),a.name)),this.arms=hr.map(a=>[e(new Rs(n,kn.shirt),`${a} upper arm`),e(new Rs(s,kn.skin),`${a} lower arm`),e(uu(Mx,kn.skin),`${a} hand`)]),this.legs=Pu(t),this.feet=this.legs.map(()=>e(uu(Sx,kn.shoes),"foot")),this.face=e(UA(),"head");let o=t.arm.held_m>0;this.around=e(new Le(fl,DA),`the hand${o?", or what it holds,":""} may be anywhere in this sphere`),this.around.scale.setScalar(r),this.held=e(new Rs(Ex.radius,kn.trousers),"what the hand holds"),this.held.visible=!1,this.add(...this.parts,...this.arms.flat(),...this.feet,this.face,this.around,this.held)}loadOther(t,e){if(this.visible=!!t.beside,this.visible){let n={...t,body:t.beside,arms:t.beside_arms,arm:null};Object.assign(this,{replay:n,hazard:e,head:Iu(n,this.cell),touching:null}),this.face.scale.setScalar(this.cell.body[this.head].radius_m)}}load(t,e){Object.assign(this,{replay:t,hazard:e,head:Iu(t,this.cell)});let n=t.arm?hr.indexOf(t.arm.side):-1,s=Up(e.body_region);this.touching=n>=0&&s!==void 0?{side:n,limb:s}:null,this.held.visible=!!e.arm?.held_m;let r=t.arm?-1:Fp(t,this.cell,e),o=(c,l)=>c?kn.touched:l;this.parts.forEach((c,l)=>c.material=o(l===r,Ax(this.cell.body[l].region))),this.arms.forEach((c,l)=>c.forEach((u,h)=>u.material=o(l===n&&h===s,h===0?kn.shirt:kn.skin)));let a=r===this.head&&e.body_region==="skull_forehead";this.face.hat.forEach(c=>c.material=o(a,kn.cap)),this.face.nose.material=o(r===this.head,kn.skin),this.face.scale.setScalar(this.cell.body[this.head].radius_m)}place(t){let{replay:e,cell:n,touching:s}=this;this.parts.forEach((a,c)=>{let{a:l,b:u}=_i(e,n,t,c);a.place(l,u)});let r=hr.map((a,c)=>ur(e,t,c));this.arms.forEach(([a,c,l],u)=>{let[h,d,f]=r[u];a.place(h,d),c.place(d,f),this.placeHand(l,d,f,t,s?.limb===2&&s.side===u)});let o=pi(Np(e,this.hazard,t));this.feet.forEach((a,c)=>{let{a:l,b:u}=_i(e,n,t,this.legs[c]),h=l[2]<u[2]?l:u;a.position.set(h[0],h[1],Sx[1]).addScaledVector(o,.06),a.quaternion.setFromUnitVectors(Tx,o)}),this.placeFace(r,o,t),this.around.visible=s?.limb===2&&t>=e.contact_frame,this.around.visible&&this.around.position.set(...r[s.side][2])}placeHand(t,e,n,s,r){let{replay:o}=this,a=pi(n),c=a.clone().sub(pi(e)).normalize(),l=2*Mx[0];if(r){let u=pi(ur(o,o.contact_frame,this.touching.side)[2]),h=pi(o.contact_m).sub(u),d=h.length(),f=Math.max(0,Math.min(1,1-(o.contact_frame-s)*o.step/LA));d>.02&&(c.lerp(h.divideScalar(d),f).normalize(),l+=f*(Math.max(wx[0],Math.min(wx[1],d))-l))}if(r&&this.held.visible){let u=pi(o.contact_m).sub(pi(ur(o,o.contact_frame,this.touching.side)[2])).length(),h=d=>a.clone().addScaledVector(c,d).toArray();this.held.place(h(Ex.from),h(u))}t.scale.x=l/2,t.position.copy(a).addScaledVector(c,l/2),t.quaternion.setFromUnitVectors(Tx,c)}placeFace([[t],[e]],n,s){let{a:r,b:o}=_i(this.replay,this.cell,s,this.head),a=pi(r).add(pi(o)).multiplyScalar(.5),c=pi(t).sub(pi(e)),l=a.clone().sub(pi(t).add(pi(e)).multiplyScalar(.5));(c.lengthSq()<1e-4||l.lengthSq()<1e-4)&&(l.set(0,0,1),c.crossVectors(l,n));let u=c.cross(l).normalize();l.normalize(),this.face.position.copy(a),this.face.quaternion.copy(new Ln().setFromRotationMatrix(new Fe().makeBasis(u,l,new k().crossVectors(u,l))))}set headless(t){this.parts[this.head].visible=!t,this.face.visible=!t}eye(t){return _i(this.replay,this.cell,t,this.head).a}spots(t){return this.parts.map((e,n)=>_i(this.replay,this.cell,t,n).a)}get drawn(){let[t,e]=this.arms[0].map(n=>n.radius);return{upper_arm_radius_m:t,forearm_radius_m:e,hand_sphere_m:this.around.visible?this.around.scale.x:null,touched:this.touching??"body"}}};var Qn={robot:"#7894b4",hitting:"#e4572e",person:gl.shirt,touched:gl.touched,contact:"#ffffff",path:"#2a9d8f",mat:"#d9a400",field:"#3b82f6",curtain:"#16a34a",door:"#0d9488",post:"#9333ea",button:"#db2777",obstacle:"#8b93a0"},Cx={light:{sky:"#eef1f5",grid:"#b9c1cc",axis:"#b9c1cc",mark:"#4d5866"},dark:{sky:"#1b2027",grid:"#3a434f",axis:"#3a434f",mark:"#a3afbd"}},Rx=matchMedia("(prefers-color-scheme: dark)"),Px=i=>new Fi({color:i}),Ix=i=>new Fi({color:i,transparent:!0,opacity:.2,depthWrite:!1}),Ps={robot:Px(Qn.robot),hitting:Px(Qn.hitting),robotShape:Ix(Qn.robot),hittingShape:Ix(Qn.hitting),obstacle:new Fi({color:Qn.obstacle,transparent:!0,opacity:.22,depthWrite:!1}),edge:new Ui({color:Qn.obstacle}),path:new Mi({color:Qn.path})};function FA(i){i.add(new $a("#ffffff","#9aa3b0",2.1));let t=new Za("#ffffff",1.9);return t.position.set(-3,-4,9),t.castShadow=!0,t.shadow.mapSize.set(1024,1024),Object.assign(t.shadow.camera,{left:-5,right:5,top:5,bottom:-5,near:1,far:20}),i.add(t,t.target),t}function OA(){let i=new Mi({color:Qn.contact,depthTest:!1,transparent:!0}),t=new Mi({color:"#000000",depthTest:!1,transparent:!0}),e=new Le(new Es(.018,16,12),i),n=new Le(new No(.045,.058,40),i),s=new Le(new No(.04,.063,40),t);return[e.renderOrder,n.renderOrder,s.renderOrder]=[12,11,10],e.add(n,s),e.materials=[i,t],e}function kA({mesh:i}){let t=e=>[...e.getWorldPosition(new k)];return{at:t(i),shape:t(i.parent),clear:i.parent.material.transparent&&!i.material.transparent}}function Lx(i,t,e,n){let s=new qh({canvas:i,antialias:!0});s.setPixelRatio(Math.min(devicePixelRatio,2)),s.shadowMap.enabled=!0;let r=new Ea,o=new qn(40,1,.02,200);o.up.set(0,0,1);let a=new Qh(o,i),c=FA(r),l=[],u=(W,st)=>(W.userData.name=st,l.push(W),W),h=OA(),d=new su,f=cx(t);l.push(...f),r.add(ox(),d,h,...f);let p=t.obstacles.map(W=>u(vx(W,Ps.obstacle,Ps.edge),W.name));r.add(...p);let x=t.zones.map(W=>u(new hu(W,Qn[W.kind]??Qn.obstacle),W.title)),m=t.links.map(W=>{let{radius_m:st,points_m:lt,triangles:j}=W,pt=W.shape==="capsule"?new Rs(st,Ps.robot):new pl(lt,j,Ps.robot);return u(pt,t.links.some(mt=>mt.robot!==W.robot)?`${W.robot}/${W.name}`:W.name)}),g=t.looks.map(({link:W,points_m:st,triangles:lt})=>{let j=new pl(st,lt,Ps.robot);return m[W].add(j),m[W].castShadow=!1,{link:W,mesh:j}}),y=new ml(t,u),M=new ml(t,W=>u(W,"the other person"));r.add(...x,...m,y,M);let b=null,R=null,w=null,_=0,E=null,O=null,D=0,I="overview",G=!1;function H(){G||(G=!0,requestAnimationFrame(()=>{G=!1,h.children.forEach(W=>W.quaternion.copy(o.quaternion)),h.scale.setScalar(Math.max(.25,Math.min(2,o.position.distanceTo(h.position)/3.5))),s.render(r,o),e.place({camera:o,width:i.clientWidth,height:i.clientHeight,free:R?[R.contact_m,...y.spots(D)]:[]})}))}function N(){let W=Rx.matches?Cx.dark:Cx.light;r.background=new he(W.sky),d.colour=W.mark,b&&(r.remove(b),b.dispose()),b=ax(W),r.add(b),H()}function F(){let{clientWidth:W,clientHeight:st}=i;W>0&&st>0&&(s.setSize(W,st,!1),o.aspect=W/st,o.updateProjectionMatrix(),H())}function q(W){I=W,F(),V()}function V(){let W=sx(I,{...O,head:y.eye(D)},o);if(o.position.copy(W.position),a.target.copy(W.target),a.update(),y.headless=I==="eye",I!=="eye"){let st=d.fit(O.bounds,o.position);e.set(gx({replay:R,cell:t,hazard:y.hazard,hitting:_,marks:st,colours:Qn,frame:()=>D}))}H()}let J=new Ot,Z=new Ja;function K(W){let{left:st,top:lt,width:j,height:pt}=i.getBoundingClientRect();J.set(2*(W.clientX-st)/j-1,1-2*(W.clientY-lt)/pt),Z.setFromCamera(J,o);let mt=Z.intersectObjects(l.filter($=>$.visible),!0),bt=(mt.find(({object:$})=>$.material&&!$.material.transparent&&$.isMesh)??mt.find(({object:$})=>$.isMesh))?.object;for(;bt&&!bt.userData.name;)bt=bt.parent;n(bt?.userData.name??"")}return a.addEventListener("change",H),a.addEventListener("start",()=>{I="free",y.headless=!1}),i.addEventListener("pointermove",W=>W.buttons===0&&K(W)),i.addEventListener("pointerleave",()=>n("")),Rx.addEventListener("change",N),new ResizeObserver(()=>{F(),O&&I!=="free"&&V()}).observe(i),F(),N(),{load(W,st){R=W,w&&(r.remove(w),w.geometry.dispose()),_=Op(R,t,st);let lt=j=>j===_?"hitting":"robot";m.forEach((j,pt)=>j.material=Ps[lt(pt)]);for(let{link:j,mesh:pt}of g)pt.material=Ps[lt(j)],m[j].material=Ps[`${lt(j)}Shape`];y.load(R,st),M.loadOther(R,st),w=bx(kp(R,t),.03,Ps.path),r.add(w),h.position.set(...R.contact_m),E===null&&(E=hx(t,R),E.forEach(j=>r.add(j)),l.push(...E)),O=px(R,t,st),c.position.set(R.contact_m[0]-3,R.contact_m[1]-4,9),c.target.position.set(R.contact_m[0],R.contact_m[1],0)},show(W){D=W,m.forEach((j,pt)=>{let mt=Ji(R,t,D,pt);mt.position?j.place(mt.position,mt.quaternion):j.place(mt.a,mt.b)}),y.place(D),M.visible&&M.place(D);let st=(y.hazard.worked??[]).filter(({at_s:j})=>Math.round(j/R.step)<=D);p.forEach((j,pt)=>{let mt=t.obstacles[pt].opened_by;j.visible=mt===void 0||st.filter(St=>St.name===mt).length%2===0});for(let{obstacle:j,there:pt,centre_m:mt}of R.moved??[])p[j].visible=pt[D]==="1",p[j].position.fromArray(mt,3*D);let lt=D>=R.contact_frame;h.materials.forEach(j=>j.opacity=lt?1:.35),x.forEach((j,pt)=>{let mt=R.sensors.find(St=>St.name===t.zones[pt].name);j.lit=mt?.detected[D]==="1"}),I==="eye"&&q("eye"),H()},look:q,draw:H,get drawn(){o.updateMatrixWorld();let W=O.points.filter(({p:st})=>{let{x:lt,y:j,z:pt}=st.clone().project(o);return Math.abs(lt)>1||Math.abs(j)>1||pt>1}).length;return{...y.drawn,pedestals:f.length,outside:W,looks:g.map(kA)}}}}function Dx({zones:i,looks:t}){let e=new Set(i.map(r=>r.kind)),n=[["hitting","link that hits"],["touched","part that is hit"],["robot","robot"],["person","person"],["path","way of the person"],["obstacle","obstacle"],...[...e].map(r=>[r,r])],s=r=>C("i",{class:"swatch",style:`background:${Qn[r]??Qn.obstacle}`});return C("ul",{class:"legend screen-only"},n.map(([r,o])=>C("li",{},s(r),o)),C("li",{},C("i",{class:"swatch ring"}),"contact"),t.length>0?C("li",{},"Clear around the robot: the shapes that are judged."):null,i.length>0?C("li",{},"Zones are filled while they report."):null)}function Nx(i){let t=C("canvas",{"data-test":"scene","aria-label":"the cell in three dimensions; drag to turn, wheel to zoom"}),e=C("span",{class:"pointed"}),n=C("div",{class:"flat"}),s=j_(),r=C("div",{class:"stage screen-only"},t,s.element,e),o=C("button",{type:"button","data-test":"names","aria-pressed":"true",title:"Show or hide the names in the picture",onclick:c},"names"),a=null;function c(){s.toggle(),o.setAttribute("aria-pressed",String(s.on)),a?.draw()}function l(){a=null,r.replaceChildren(C("p",{class:"notice","data-test":"no-webgl"},"This browser shows no 3-D graphics (WebGL), so here is the contact seen from above; everything else works."),n)}let u=document.createElement("canvas").getContext("webgl2");if(u){u.getExtension("WEBGL_lose_context")?.loseContext();try{a=Lx(t,i,s,h=>e.textContent=h),t.addEventListener("webglcontextlost",l)}catch{l()}}else l();return{element:r,names:o,get scene(){return a},drawFlat:h=>n.replaceChildren(h?Ml(h):""),show(h){a&&(a.show(h),t.dataset.drawn=JSON.stringify(a.drawn))},look:h=>a?.look(h)}}function BA(i){return[...i.matchAll(/1+/g)].map(t=>[t.index,t.index+t[0].length])}function Ux(i,t){return i.findLastIndex(e=>e.frame<=t)}function Fx(i,t){let e=C("div",{class:"strips",style:`--gutter:${fd}px; --right:${pd}px`,onclick:a}),n=1,s=[],r=u=>u.map(({frame:h,kind:d,text:f})=>C("div",{class:`event ${d}`,style:`left:${100*h/n}%`,title:f})),o=(u,h)=>`left:${100*u/n}%;width:${100*(Math.min(h,n)-u)/n}%`;function a(u){let h=u.target.closest(".track");if(h){let{left:d,width:f}=h.getBoundingClientRect();t((u.clientX-d)/f*n)}}function c(u,h,d,f){return C("div",{class:`strip ${h}`},C("span",{class:"label",title:u},u),C("div",{class:"track"},d,r(f),C("div",{class:"now"})))}function l(u){let h=[];return u.forEach(({name:d,frame:f},p)=>{let x=u[p+1]?.frame??n;h.at(-1)?.name===d?h.at(-1).to=x:h.push({name:d,from:f,to:x})}),h}return{element:e,load(u,h){n=Math.max(u.frames-1,1);let d=u.sensors.map(({name:f,detected:p})=>c(f,"sensor",BA(p).map(([x,m])=>C("div",{class:"on",style:o(x,m),title:`${f} ${i.people.reports}`})),h));s=l(u.actions).map(({name:f,from:p,to:x})=>{let m=i.actions[f],[g,...y]=m.split(", "),M=C("div",{class:"action",style:o(p,x),title:m},C("span",{},g),C("span",{},y.join(", ")));return{from:p,to:x,block:M}}),e.replaceChildren(...d,c(i.people.heading,"actions",s.map(({block:f})=>f),h))},show(u){e.querySelectorAll(".now").forEach(h=>h.style.left=`${100*u/n}%`),s.forEach(({from:h,to:d,block:f})=>f.classList.toggle("current",u>=h&&(u<d||d>=n)))}}}var zA=[.1,.25,.5,1],VA=[["overview","3/4"],["top","top"],["front","front"],["side","side"],["eye","person's eye"],["contact","contact"]],_l=(i,t,e,n)=>C("button",{type:"button","data-test":i,title:e,onclick:n},t);function GA(i,t){return i.closest("input, select, textarea, [contenteditable]")||t===" "&&i.closest("button, [role=button], summary")}function Ox(i,{look:t,inView:e}){let n=1,s=0,r=_l("play","▶ Play","Play or pause (space)",()=>i.toggle()),o=C("input",{type:"range",min:0,step:1,"data-test":"scrub","aria-label":"time",oninput:()=>i.seek(Number(o.value))}),a=m=>()=>i.seek(i.frame+m),c=m=>()=>i.seek(m()),l=C("select",{"data-test":"speed",onchange:()=>i.setSpeed(Number(l.value))},zA.map(m=>C("option",{value:m,selected:m===.5},`${m}x`))),u=VA.map(([m,g])=>_l(`view-${m}`,g,`View: ${g}`,()=>t(m))),h=C("div",{class:"ticks","aria-hidden":"true"}),d=C("ol",{class:"events","data-test":"events","aria-label":"what happens"}),f=C("div",{class:"transport screen-only"},C("div",{class:"row"},r,_l("back","◀|","One frame back (left)",a(-1)),_l("forward","|▶","One frame on (right)",a(1)),C("div",{class:"scrubber"},h,o),_l("to-contact","Contact","Jump to the contact",c(()=>s)),C("label",{},"speed ",l)),d),p=C("div",{class:"row views screen-only",role:"group","aria-label":"views"},u),x={" ":()=>i.toggle(),ArrowLeft:a(-1),ArrowRight:a(1),Home:c(()=>0),End:c(()=>n-1)};return document.addEventListener("keydown",m=>{let g=x[m.key],y=!m.ctrlKey&&!m.metaKey&&!m.altKey&&!m.shiftKey;g&&y&&e()&&!m.defaultPrevented&&!GA(m.target,m.key)&&(m.preventDefault(),g())}),i.follow(({frame:m,playing:g})=>{o.value=m,r.textContent=g?"❚❚ Pause":"▶ Play"}),{element:f,views:p,load(m,g){[n,s]=[m.frames,m.contact_frame],o.max=n-1,h.replaceChildren(...g.map(({frame:y,kind:M})=>C("i",{class:M,style:`left:${100*y/Math.max(n-1,1)}%`}))),d.replaceChildren(...g.map(({frame:y,kind:M,text:b})=>C("li",{},C("button",{type:"button",class:M,title:`Go to ${Wn(y*m.step)}`,onclick:()=>i.seek(y)},C("b",{},Wn(y*m.step)),` ${b}`))))}}}function kx(i,t){let{cell:e,words:n}=i,s=C("span"),r=Nx(e),o=pm(),a=Gg(o.seek),c=Fx(n,o.seek),l=C("p",{class:"instant","data-test":"instant"}),u=C("div",{class:"facts"}),h=!1,d=null,f=null,p=Ox(o,{look:r.look,inView:()=>h&&d!==null});new IntersectionObserver(w=>h=w.at(-1).isIntersecting).observe(r.element);function x(w){let _=d.actions[Ux(d.actions,w)]?.name,E=d.sensors.filter(I=>I.detected[w]==="1").map(I=>I.name),{people:O}=n,D=[`${Wn(w*e.step_s)} of ${Wn((d.frames-1)*e.step_s)}`,_?`${O.who} ${n.actions[_]}`.trim():"start"];return d.sensors.length>0&&D.push(E.length>0?`${E.join(", ")} ${E.length>1?O.report:O.reports}`:O.unseen),w===d.contact_frame&&D.push(n.hazards[f.id].deed),D.join(" · ")}o.follow(({frame:w})=>{d&&(r.show(w),a.show(w),c.show(w),l.textContent=x(w))}),r.scene?p.views.append(r.names):p.views.hidden=!0;let m=C("p",{class:"shown-hazard"}),g=C("div",{},r.element,p.element,l,p.views,r.scene?Dx(e):null),y=C("div",{class:"notice","data-test":"no-replay"}),M=C("div",{class:"graphs screen-only"},a.element,c.element);function b({hazard:w}){f=i.hazard(w),d=i.replay(w)??null;let{deed:_,way:E,forces:O}=n.hazards[w];s.textContent=`${w}: ${_}`;let D=i.causeOf(w)?.worst===w;if(m.replaceChildren(C("b",{},D?"Its worst way":"One of its ways"),`: ${_}, ${E} `,C("span",{class:"id"},w)),u.replaceChildren(Tl(i,f)),g.hidden=d===null,M.hidden=d===null,y.hidden=d!==null,!d){o.pause();let[G,H]=n.commands.report;y.replaceChildren(C("p",{},G),Os(`${H}${w}`));return}let I=fm(d,f,n);r.drawFlat(i.topView(w)),r.scene?.load(d,f),p.load(d,I),a.load(d,I,O!==void 0),c.load(d,I),o.load(d.frames,e.step_s,d.contact_frame),r.look("overview"),r.show(d.contact_frame)}let R=Tn("replay","",C("div",{class:"replay"},M,u));return R.querySelector("h2").append("How it comes to this ",s),{picture:C("div",{class:"picture"},m,g,y),element:R,start:()=>t.follow(b)}}var Wo=()=>{try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}};function Bx(i){let t=new Map(i.flatMap(l=>l.hazards.map(u=>[u,l.id]))),e=new Map(i.map(l=>[l.id,l.worst])),n=l=>t.has(l)||e.has(l),s=l=>e.has(l)?{cause:l,hazard:e.get(l)}:{cause:t.get(l),hazard:l},r=[],o=n(Wo())?Wo():i[0]?.id,a=o===void 0?{cause:null,hazard:null}:s(o);function c(l){let u=s(l);u.hazard!==a.hazard&&(a=u,r.forEach(h=>h(a)))}return addEventListener("hashchange",()=>{n(Wo())&&c(Wo())}),{get now(){return a},get namesHazard(){return t.has(Wo())},get unknown(){let l=Wo();return/^[CH]-/.test(l)&&!n(l)?l:null},select(l){history.replaceState(null,"",`#${encodeURIComponent(l)}`),c(l)},follow(l){r.push(l),a.hazard!==null&&l(a)}}}function HA({decisionOf:i,worst:t,counted:e,causeOf:n,words:s,others:r}){let a=u=>u.sequences??u.times_found,c=u=>h=>s.hazards[h.id].row[u],l=u=>s.regions[u.body_region];return[["id",u=>u.id,u=>C("a",{href:`#${u.id}`,class:"id"},u.id)],["cause",u=>n(u.id).number,u=>ks(n(u.id)),!0],["ratio",u=>u.ratio,u=>WA(u,t,s.hazards[u.id]),!0],["body region",l,l],["hit by",u=>u.robot_link,u=>u.robot_link],["force: own speed",u=>u.force_n,c(1),!0],["force: approach",u=>u.directed_force_n,c(2),!0],["limit",u=>u.limit_n,c(3),!0],...r?[["what is broken",u=>u.class,c(4)]]:[],["speed",u=>u.speed_m_s,c(5),!0],["safe below",u=>u.safe_below_m_s,c(6),!0],["time",u=>u.time_s,c(7),!0],[e?"sequences":"times found",u=>Number(a(u)),c(8),!0],["sensors that report",c(9),c(9)],["confirmed",c(10),c(10)],["decision",u=>i(u.id),u=>i(u.id)]]}function WA({ratio:i},t,{row:[e],apart:n,forces:s}){let r=Math.max(t,1.05),o=a=>`${(100*a/r).toFixed(1)}%`;return C("span",{class:"ratio"},n?C("span",{class:"flag","data-test":"apart",title:[n,...s[0]].join(`
`)},"differ"):null,C("span",{class:"bar screen-only","aria-hidden":"true"},C("span",{class:i>=1?"over":"under",style:`width:${o(i)}`}),C("span",{class:"mark",style:`left:${o(1)}`})),C("b",{},e))}function Qf(i,t,e,n){let s=[C("option",{value:""},"all"),...e.map(([r,o])=>C("option",{value:r},o))];return C("label",{},`${i} `,C("select",{"data-test":t,onchange:n},s))}function zx(i,t,e,n){let s=i.scan.hazards,{words:r}=i,o=Math.max(...s.map(J=>J.ratio)),a=J=>e.decision(J),c=s.some(J=>J.sequences!==null),l=HA({decisionOf:a,worst:o,counted:c,causeOf:i.causeOf,words:r,others:s.some(({id:J})=>r.hazards[J].broken)}),u=J=>[...new Set(s.map(J))].sort(),h={column:2,descending:!0},d=null,f=C("input",{type:"search",placeholder:"any text","data-test":"filter",oninput:I}),p=Qf("region","filter-region",u(J=>J.body_region).map(J=>[J,r.regions[J]]),I),x=Qf("hit by","filter-link",u(J=>J.robot_link).map(J=>[J,J]),I),m=Qf("decision","filter-decision",e.decisions.map(J=>[J,J]),I),g=C("output",{"data-test":"shown"}),y=C("button",{type:"button",hidden:!0,"data-test":"clear-bin",onclick:()=>G(null)}),M=new Map(s.map(J=>[J.id,_(J)])),b=new Map,R=C("tbody",{onkeydown:E}),w=l.map(([J,,,Z],K)=>C("th",{scope:"col",class:Z?"number":null},C("button",{type:"button","data-test":`sort-${K}`,onclick:()=>O(K)},J)));function _(J){let Z=l.map(([,,W,st])=>C("td",{class:st?"number":null},W(J))),K=C("tr",{"data-test":"row","data-id":J.id,class:J.class},Z);return K.addEventListener("click",W=>{W.ctrlKey||W.metaKey||W.shiftKey||String(getSelection())||(W.preventDefault(),t.select(J.id))}),K}function E(J){let Z={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[J.key],K=Z&&J.target.closest("tr")?.[Z]?.querySelector("a");K&&(J.preventDefault(),K.focus())}function O(J){let Z=!!l[J][3];h={column:J,descending:h.column===J?!h.descending:Z},I()}function D(J){let Z=(W,st)=>!W.querySelector("select").value||W.querySelector("select").value===st,K=f.value.trim().toLowerCase();return(d===null||d.ids.has(J.id))&&Z(p,J.body_region)&&Z(x,J.robot_link)&&Z(m,a(J.id))&&K.split(/\s+/).every(W=>b.get(J.id).includes(W))}function I(){let[,J]=l[h.column],Z=h.descending?-1:1,W=[...s].sort((st,lt)=>Z*(J(st)<J(lt)?-1:J(st)>J(lt)?1:0)).filter(D);R.replaceChildren(...W.map(st=>M.get(st.id))),g.textContent=W.length===s.length?`${s.length} shown`:`${W.length} of ${s.length} shown`,w.forEach((st,lt)=>{let j=h.descending?"descending":"ascending";st.setAttribute("aria-sort",lt===h.column?j:"none")})}function G(J){d=J,y.hidden=d===null,y.textContent=d===null?"":`only ${d.name} ✕`,F.open||=d!==null,I()}function H(){for(let J of s)M.get(J.id).lastElementChild.textContent=a(J.id),b.set(J.id,M.get(J.id).textContent.toLowerCase());I()}let N=C("button",{type:"button",class:"to-replay screen-only","data-test":"to-replay",onclick:n}),F=C("details",{"data-test":"ways"},C("summary",{},s.length===1?"The one way, as a row":`All ${an(s.length,"way")}, one row each`),C("div",{class:"filters screen-only"},C("label",{},"filter ",f),p,x,m,y,g),N,C("div",{class:"scroll",tabindex:0},C("table",{class:"hazards"},C("thead",{},C("tr",{},w)),R)),r.table_notes.map(J=>C("p",{class:"note"},J)));e.follow(H),H(),t.follow(({hazard:J})=>{N.textContent=`Show the replay of ${J}`;for(let[Z,K]of M)K.setAttribute("aria-selected",Z===J),Qo(K.querySelector("a"),Z===J)});let q=()=>F.open||=t.namesHazard;return addEventListener("hashchange",q),q(),{element:Tn("hazards","Every way by itself",F),setBin:G}}function Vx({scan:i,words:t,cell:e}){let{says:n,covers:s}=i.headline;return C("header",{class:"top"},C("div",{class:"title"},C("h1",{},e.name),C("p",{class:"kicker"},`${i.tool} · hazard report`)),C("p",{class:`verdict ${i.verdict}`,"data-test":"verdict"},n),C("p",{class:"scope","data-test":"scope"},s),C("p",{class:"note"},t.hazard_is))}function XA(i){let t=C("p",{class:"notice","data-test":"unknown-id"}),e=()=>{t.hidden=i.unknown===null,t.textContent=i.unknown===null?"":`The address names ${i.unknown}, which this report does not hold.`};return addEventListener("hashchange",e),e(),t}async function $A(i){let t=await Ip();i.append(Vx(t));let e=Bx(t.causes);if(i.append(XA(e),...t.whole?[lm(t)]:[]),t.causes.length>0){let n=vp(t),s=kx(t,e),r=zx(t,e,n,()=>s.picture.scrollIntoView({block:"start"})),o=Lp(t,e,n);i.append(hm(t,n),Tp(t,e,n,{picture:s.picture,assess:o.show}),s.element,C("div",{class:"pair"},$p(t,e,r.setBin),o.element),r.element),s.start()}else i.append(Tn("hazards","Hazards",C("p",{"data-test":"none"},t.words.nothing_found)));i.append(Cp(t),dm(t))}var Gx=document.getElementById("report");$A(Gx).catch(i=>{throw Gx.append(C("p",{class:"notice"},`This report cannot be shown: ${i.message}. See scan.json beside it.`)),i});})();
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
