(()=>{var uy={skull_forehead:"skull",back_shoulders:"back or shoulders",neck_front:"front of the neck"},dy={stop:"stands still",forward:"walks straight ahead",left45:"turns left by 45° and walks",left90:"turns left by 90° and walks",right45:"turns right by 45° and walks",right90:"turns right by 90° and walks"},fy={upright:"upright","bend-forward":"bent forward","bend-left":"bent to the left","bend-right":"bent to the right","bend-forward-left":"bent forward and to the left","bend-forward-right":"bent forward and to the right"},vn=n=>uy[n]??String(n).replaceAll("_"," "),Ze=n=>`${n.toFixed(2)}x`,ai=n=>`${n.toFixed(0)} N`,es=n=>`${n.toFixed(2)} m/s`,hn=n=>`${n.toFixed(2)} s`,Il=({begins_s:n})=>`${hn(n)} after the FMU's start`,Ll=n=>`(${n.map(t=>t.toFixed(2)).join(", ")}) m`,Ee=n=>String(n).replace(/\B(?=(\d{3})+(?!\d))/g,","),de=(n,t)=>`${Ee(n)} ${t}${Number(n)===1?"":"s"}`;function ns(n,t=Math.round){let e=100*n;if(e===0)return"0 %";if(e<1e-6)return"less than 0.000001 %";let i=e>=.995?1:Math.min(7,1-Math.floor(Math.log10(e))),s=10**i,r=t(e*s)/s;return`${(r>=100&&n<1?99.9:r).toFixed(i).replace(/(\.\d*?[1-9])0+$/,"$1")} %`}function qr(n){let[t,e]=n.split("/");return e===void 0?n:`${dy[t]??t}, ${fy[e]??e}`}function Dp(n,t){let e=[];for(let i of n)e.at(-1)?.name===i?e.at(-1).times+=1:e.push({name:i,times:1});return e.map(({name:i,times:s})=>`${s>1?`${s} x `:""}${qr(i)}, ${+(s*t).toFixed(2)} s`)}var Dl=n=>["skull_forehead","face","neck_front"].includes(n);function Np(n){return Dl(n.body_region)?"none":es(n.safe_below_m_s)}var Fp=n=>n.class==="head_contact"?"none allowed":ai(n.limit_n),Up=2,Nl=`The two differ by more than a factor of ${Up}.`;function Ii(n,{speed_criterion:t}){let e=t==="approach",i={name:"with the robot's own speed",force:n.force_n,ratio:n.force_n/n.limit_n,speed:n.speed_m_s,decides:!e},s={name:"with the speed of approach (the person's walking included)",force:n.directed_force_n,ratio:n.directed_ratio,speed:n.approach_m_s,decides:e},[r,o]=[i.ratio,s.ratio].sort((a,l)=>a-l);return{own:i,approach:s,decides:e?s:i,apart:o>Up*r}}var Yr=(n,t)=>t<1&&Dl(n)?`no contact allowed (${Ze(t)})`:Ze(t),Fl=({speed_criterion:n})=>n==="approach"?"the speed of approach (the person's walking included)":"the robot's own speed";function ca({class:n,ratio:t,force_n:e,limit_n:i}){let s=`${ai(e)}, limit ${ai(i)}`;return n==="head_contact"?["no contact allowed",`${s} (${Ze(t)})`]:[`${Ze(t)} the limit`,s]}function Zr(n){return n==null?"not tried":n?"yes":"NO"}function Op(n){let t=e=>e.person_detected?`reports the person${typeof e.since_s=="number"?` for ${hn(e.since_s)}`:""}`:"does not report the person";return n.map(e=>`${e.name} ${t(e)}`).join(", ")||"no sensor"}function Ou(n){return n.filter(e=>e.person_detected).map(e=>typeof e.since_s=="number"?`${e.name} ${hn(e.since_s)}`:e.name).join(", ")||"none"}function Bp(n){return n.sequences===null||n.sequences===void 0?de(n.times_found,"time"):de(n.sequences,"sequence")}var Kr=[{key:"task",label:"Task: who does what there (ISO 12100, 5.2)",long:!0},{key:"severity",label:"Severity",options:[["S1","S1: slight, reversible"],["S2","S2: serious, irreversible or death"]]},{key:"exposure",label:"Exposure",options:[["F1","F1: seldom or short"],["F2","F2: frequent or long"]]},{key:"avoidance",label:"Avoidance",options:[["P1","P1: possible"],["P2","P2: scarcely possible"]]},{key:"decision",label:"Decision",options:["open","reduce","accepted","not credible"].map(n=>[n,n])},{key:"measure",label:"Protective measure",long:!0},{key:"residual",label:"Residual risk",long:!0},{key:"by",label:"By"},{key:"date",label:"Date",type:"date"}],py={S1F1P1:"a",S1F1P2:"b",S1F2P1:"b",S1F2P2:"c",S2F1P1:"c",S2F1P2:"d",S2F2P1:"d",S2F2P2:"e"},fr=({severity:n,exposure:t,avoidance:e})=>py[`${n}${t}${e}`]??null,kp=n=>Object.fromEntries(Object.entries(n).sort(([t],[e])=>t<e?-1:1));function zp({assessments:n,cell:t,causeOf:e}){let i=new Map(Object.entries(n).map(([h,u])=>[h,{...u}])),s=[],r=new Set,o=()=>s.forEach(h=>h());addEventListener("beforeunload",h=>{r.size>0&&h.preventDefault()});let a=Kr.find(h=>h.key==="decision").options.map(([h])=>h),l=[...i.values()].map(h=>h.decision).filter(Boolean),c=h=>i.get(h)??{},d=h=>c(h).decision||null;return{decisions:[...new Set([...a,...l])],of:c,own:d,ofCause:h=>d(h)??"open",decision:h=>d(h)??d(e(h)?.id)??"open",set(h,u,f){let m=Object.fromEntries(Kr.map(_=>[_.key,""]));i.set(h,{...m,...i.get(h),[u]:f}),r.add(h),o()},unsaved(){let h=[...r].filter(f=>f.startsWith("C-")).length,u=r.size-h;return[h>0?de(h,"cause"):"",u>0?de(u,"single way"):""].filter(Boolean).join(" and ")},text(){let h=Object.fromEntries([...i].map(([u,f])=>[u,kp(f)]));return`${JSON.stringify({assessments:kp(h),cell:t.name,format:1},null,2)}
`},saved(){r.clear(),o()},follow:h=>s.push(h)}}var my="http://www.w3.org/2000/svg";function Vp(n,t,e){for(let[i,s]of Object.entries(t))i.startsWith("on")?n.addEventListener(i.slice(2),s):s!=null&&s!==!1&&n.setAttribute(i,s===!0?"":s);return n.append(...e.flat().filter(i=>i!=null)),n}function R(n,t={},...e){return Vp(document.createElement(n),t,e)}function ne(n,t={},...e){return Vp(document.createElementNS(my,n),t,e)}function ha(n,t){t?n.setAttribute("aria-current","true"):n.removeAttribute("aria-current")}function On(n,t,...e){return R("section",{id:n,"aria-labelledby":`${n}-title`},R("h2",{id:`${n}-title`},t),...e)}function li(n){let t=R("dl");for(let[e,i]of n)i!=null&&i!==""&&t.append(R("div",{},R("dt",{},e),R("dd",{},i)));return t}function Vs(n){let t=R("code",{},n),e=R("button",{type:"button",class:"copy screen-only",onclick:i},"Copy");async function i(){try{await navigator.clipboard.writeText(n),e.textContent="Copied"}catch{getSelection().selectAllChildren(t),e.textContent="Marked: press Ctrl+C"}setTimeout(()=>e.textContent="Copy",2500)}return R("div",{class:"command"},t,e)}function Ul(n){let t=new DOMParser().parseFromString(n,"image/svg+xml").documentElement;if(t.localName!=="svg")return R("p",{class:"note"},"The drawing cannot be read.");for(let s of[t,...t.querySelectorAll("*")]){["script","foreignObject"].includes(s.localName)&&s.remove();for(let{name:r}of[...s.attributes])(r.startsWith("on")||r.endsWith("href"))&&s.removeAttribute(r)}let e=t.getAttribute("width"),i=t.getAttribute("height");return!t.hasAttribute("viewBox")&&e&&i&&t.setAttribute("viewBox",`0 0 ${e} ${i}`),t.setAttribute("role","img"),document.importNode(t,!0)}var Ol=100,Gp=212,gy=.3,_y=[["upper_arm","M27.4 46.5 C25 54 21.4 70 20 82 L28.2 84.2 C29.6 74 32.6 62 34 52.5 L34 46 C31.6 43.2 29 43.6 27.4 46.5 Z"],["lower_arm","M19.8 83.6 C17.4 92 15.6 103 14.8 112 L21.2 113.6 C23.6 105 26.9 95 28 85.8 Z"],["hand","M14.6 113.6 C11.8 118 11.2 124 12.8 129.5 C14.8 132.5 18 131.8 19 128.4 L22.6 124.2 C23.4 121 21.6 118 21 115.2 Z"],["thigh","M32.2 104.8 C31.4 118 33 134 35.2 149 L46.2 149 C47.8 136 48.9 122 48.9 108.6 Z"],["lower_leg","M35.3 150.6 C33.8 160 34.6 174 37 190 C36.6 195 33.6 199.4 32.6 203.4 C34.6 206.6 43.4 206.6 45.2 203.4 C45.2 198 44.3 195 44.5 190 C46.4 176 47.5 162 46.2 150.6 Z"]],Hp=["pelvis","M35 86.2 C33.4 91 32.5 97 32.2 103.2 L48.6 107.2 L50 104.4 L51.4 107.2 L67.8 103.2 C67.5 97 66.6 91 65 86.2 Z"],xy="M45 28.4 C47.5 31 52.5 31 55 28.4 L55.8 35.4 L44.2 35.4 Z",yy="M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.4 42.8 34.6 45.2 C37 42.2 41 40.2 46.2 39.4 L45.6 36.6 Z",vy=[["skull_forehead","M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 Z"],["face","M39.4 16.2 L60.6 16.2 C60.6 23.4 55.2 30 50 30 C44.8 30 39.4 23.4 39.4 16.2 Z"],["neck_front",xy],["chest","M47 39.4 C41.4 40.4 37 42.6 34.8 46 L35 53 C34.8 58.6 35 62.4 35.8 66 L64.2 66 C65 62.4 65.2 58.6 65 53 L65.2 46 C63 42.6 58.6 40.4 53 39.4 Z"],["abdomen","M36 67.2 C36.6 73 36.3 78.6 35.2 85 L64.8 85 C63.7 78.6 63.4 73 64 67.2 Z"],Hp],by=[["skull_forehead","M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 C60.8 22 57 28.2 50 28.2 C43 28.2 39.2 22 39.4 15 Z"],["neck","M44.6 26.6 C47.5 30 52.5 30 55.4 26.6 L55.8 35.4 L44.2 35.4 Z"],["back_shoulders","M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.6 43 34.8 46 L35 53 C34.8 64 36.9 72 35.2 85 L64.8 85 C63.1 72 65.2 64 65 53 L65.2 46 C67.4 43 70.8 42.6 73 46 C72.8 44.6 72.4 43.3 71.4 42 C68 38.2 60 38.6 56 36.6 Z"],Hp],Sy={front:"M45.6 18.6 h0.01 M54.4 18.6 h0.01 M46.6 24.8 C48.6 26.2 51.4 26.2 53.4 24.8 M50 70 v6",back:"M50 40 V82 M42.6 52 C41 57 41.4 61 44 63 M57.4 52 C59 57 58.6 61 56 63"};function My(n){let t=[..._y,...n==="front"?[["back_shoulders",yy]]:[]];return[...(n==="front"?vy:by).map(([e,i])=>[e,i,!1]),...t.flatMap(([e,i])=>[[e,i,!1],[e,i,!0]])]}function wy({lines:n}){let t=new Map;for(let{body_region:e,ratio:i}of n)t.set(e,Math.max(t.get(e)??0,i));return[...t].sort(([,e],[,i])=>i-e)}function Bl(n){let t=new Map(wy(n)),e=Math.max(...t.values()),i=([d,h])=>{let u=Yr(d,h);return`${vn(d)}${u===Ze(h)?"":":"} ${u}`},s=[];function r([d,h,u]){let f=t.get(d),m=f!==void 0,_=ne("path",{d:h,class:m?"region hit":"region","data-region":d,transform:u?`translate(${Ol} 0) scale(-1 1)`:null,style:m?`--heat:${Math.max(gy,f/e).toFixed(3)}`:null},ne("title",{},m?`${i([d,f])}, as many times the limit`:`${vn(d)}: not hit`));return s.push(_),_}let o=(d,h)=>ne("g",{transform:`translate(${h} 0)`},My(d).map(r),ne("path",{class:"feature",d:Sy[d]}),ne("text",{x:Ol/2,y:Gp+9},d)),a=[...t].map(i),l=[...t.keys()].map((d,h)=>R("li",{"data-region":d},a[h]));return{element:R("figure",{class:"body-outline","data-test":"body-outline"},ne("svg",{viewBox:`2 -2 ${2*Ol-14} ${Gp+15}`,role:"img","aria-label":`Person from the front and from the back. Hit, times the limit: ${a.join(", ")}.`},o("front",-3),o("back",Ol-11)),R("ul",{class:"regions","aria-hidden":"true"},l)),mark(d){for(let h of[...s,...l])h.classList.toggle("selected",h.dataset.region===d)}}}var Bu=3,Ey=120,Wp=["#c2410c","#1d6fb8","#7c3aed","#15803d","#a16207","#0e7490","#be185d","#57606a"],ua=({number:n})=>Wp[(n-1)%Wp.length],Gs=n=>R("span",{class:"badge",style:`background:${ua(n)}`},String(n.number));function ku(n,t){let{begins:e}=n.hazard(t.worst);return[["share",typeof t.share=="number"?`${ns(t.share)} of all sequences`:""],["earliest",e?`worst begins ${Il(e)}`:`after ${hn(t.earliest_time_s)}`],["ways",`${de(t.hazards.length,"way")}, ${t.confirmed===t.hazards.length?t.confirmed===1?"confirmed":"all confirmed":`${t.confirmed} confirmed`}`]].filter(([,i])=>i)}function $p({change:n,checked:t,complete:e,removes_all:i,less:s}){let r=[["With it this cause was not met any more; other causes are left.","It removes this cause; other causes are left."],["With it no hazard was met any more.","With it nothing in this cell is hazardous any more."]][Number(i)][Number(e)];return R("li",{"data-test":"change",class:i?"all":null},R("b",{},n),R("p",{},r),R("p",{class:"note"},`Checked: ${t}${e?"":" (not every sequence)"}.`.replace(/\.\.$/,".")),s?R("p",{class:"note"},s):null)}function zu(n,t){let{own:e,approach:i,decides:s,apart:r}=Ii(n.hazard(t.worst),n.scan.settings),o=s===e?i:e;return r?R("p",{class:"flag"},`${o.name[0].toUpperCase()}${o.name.slice(1)}: ${Ze(o.ratio)} the limit, ${ai(o.force)}.`):null}function Vu({id:n,advice:t}){let e=R("h4",{},"What to change");if(!t)return R("div",{class:"remedy"},e,R("p",{"data-test":"no-advice"},"The smallest changes that help are found by:"),Vs(`fmi-hazard explain . ${n}`));let{changes:i,note:s}=t,r=i.slice(Bu);return R("div",{class:"remedy"},e,i.length>0?R("ol",{class:"changes"},i.slice(0,Bu).map($p)):R("p",{"data-test":"no-change"},"No single change that was tried removes this cause."),r.length>0?R("details",{},R("summary",{},`${de(r.length,"other change")} would do, too`),R("ol",{class:"changes",start:Bu+1},r.map($p))):null,s?R("p",{class:"note"},s):null)}function Xp(n,t,{choose:e,assess:i,assessments:s}){let[r,o]=ca(t),a=Bl(t),l=R("p",{class:"decided","data-test":"cause-decision"}),c=_=>p=>{!(p.ctrlKey||p.metaKey||p.shiftKey)&&String(getSelection())===""&&(p.preventDefault(),p.stopPropagation(),e(_))},d=_=>{let p=n.hazard(_);return R("li",{},R("a",{href:`#${_}`,"data-test":"way","data-id":_,onclick:c(_)},R("span",{class:"id"},_),` ${Ze(Ii(p,n.scan.settings).decides.ratio)} after ${hn(p.time_s)}`))},h=({body_region:_,robot_link:p,ratio:g,hazards:v})=>R("details",{class:"line","data-test":"line"},R("summary",{},`${p} hits the ${vn(_)}: `,R("b",{},Yr(_,g)),`, ${de(v.length,"way")}`),R("ul",{class:"ways"},v.map(d))),u=R("a",{href:`#${t.id}`,onclick:c(t.id)},t.sentence),f=R("article",{class:"cause","data-test":"cause","data-id":t.id,style:`--cause:${ua(t)}`},R("header",{class:"cause-head"},Gs(t),R("h3",{class:t.sentence.length>Ey?"long":null,"data-test":"cause-sentence"},u),R("span",{class:"id"},t.id)),R("p",{class:"severity"},R("b",{class:"worst"},r)," ",R("span",{},o)),zu(n,t),R("ul",{class:"figures"},ku(n,t).map(([_,p])=>R("li",{class:`figure-${_}`},p))),R("div",{class:"cause-body"},Vu(t),a.element),R("div",{class:"decision-row"},l,R("button",{type:"button",class:"screen-only",onclick:i},"Assess it")),R("details",{class:"lines","data-test":"lines"},R("summary",{},`${de(t.hazards.length,"way")} of this cause, by region and link`),t.lines.map(h)));f.addEventListener("click",_=>{f.classList.contains("compact")&&!_.defaultPrevented&&String(getSelection())===""&&e(t.id)});function m(){let _=fr(s.of(t.id)),p=t.hazards.filter(g=>s.own(g)!==null).length;l.replaceChildren("Decision: ",R("b",{},s.ofCause(t.id)),_?` · PL r: ${_}`:"",p>0?` · ${de(p,"way")} decided on ${p===1?"its":"their"} own`:"")}return s.follow(m),m(),{element:f,show(_){f.classList.toggle("compact",_===null),ha(f,_!==null),_!==null&&(a.mark(n.hazard(_).body_region),f.querySelectorAll('[data-test="way"]').forEach(p=>ha(p,p.dataset.id===_)))},focus:()=>u.focus({preventScroll:!0})}}function qp(n,t,e,{picture:i,assess:s}){let r=R("div",{class:"chosen"}),o=R("div",{class:"others"}),a=R("div",{class:"hero"},r,i);function l(d){let h=t.now.cause,u=o.contains(document.activeElement);t.select(d),u&&c.get(t.now.cause).focus(),t.now.cause===h?i.scrollIntoView({block:"nearest"}):a.scrollIntoView({block:"start"})}let c=new Map(n.causes.map(d=>[d.id,Xp(n,d,{choose:l,assess:s,assessments:e})]));return t.follow(({cause:d,hazard:h})=>{for(let[f,m]of c)m.show(f===d?h:null);let u=[...c].filter(([f])=>f!==d).map(([,f])=>f.element);r.firstElementChild!==c.get(d).element&&(r.replaceChildren(c.get(d).element),o.replaceChildren(...u.length>0?[R("h3",{},`${de(u.length,"other cause")}, worst first`),...u]:[]))}),On("causes",`${de(n.causes.length,"cause")}${n.causes.length>1?", worst first":""}`,a,o)}function Yp(n){let t=n.hazards.length,e=n.hazards.filter(i=>i.confirmed).length;switch(n.verdict){case"hazards_found":{let i=n.causes?.length??0,s=e===t?t===1?"confirmed":"all confirmed":`${Ee(e)} confirmed`;return`A person can be hit harder than allowed: ${de(i,"cause")}, ${de(t,"way")}, ${s} by a fresh replay.`}case"none_found":return"No hazard found in this model.";case"inconclusive":return"Inconclusive: nothing was found, which says nothing about the cell. See the notes under coverage.";case"fmu_failed":return"The FMU failed: nothing was found in what could be evaluated, which says little.";case"interrupted":return"Interrupted: nothing found so far.";default:return`Verdict: ${n.verdict}.`}}var Qr=({settings:n})=>n.strategy==="anywhere";function jr({certificate:n,settings:t,spent:e}){if(t.strategy==="anywhere")return`people who come from anywhere that no sensor sees, at any moment within ${t.until_s} s of the FMU's start`;let i=`a quick search of ${de(e.iterations,"sequence")}`;if(n){let s=`all beginnings of ${n.complete_for_actions} of ${n.horizon} actions`;return t.strategy==="auto"?`${i}, and ${s}`:s}return t.strategy==="auto"?`${i} alone, with seed ${t.seed}`:`${de(e.iterations,"iteration")} of ${t.strategy} with seed ${t.seed}`}function Zp(n){if(n.certificate?.complete){let e=n.hazards.length>0?"there are no others":"none of them is hazardous";return["Complete.",`All ${Ee(n.certificate.sequences)} sequences are accounted for: ${e} within the stated actions and horizon, in this model. A statement about the model, not about the real cell.`]}if(Qr(n)&&n.verdict==="none_found")return["Nothing was left open.",`Looked at: ${jr(n)}. A statement about the model, not about the real cell.`];let t=n.residual?" The residual figures under coverage bound what is left.":"";return["Not complete.",`Looked at: ${jr(n)}. Not finding more is not proof of safety.${t}`]}var Jp=n=>({sentence:Yp(n),scope:Zp(n)});function Kp({scan:n,cell:t}){let[e,i]=Zp(n);return R("header",{class:"top"},R("div",{class:"title"},R("h1",{},t.name),R("p",{class:"kicker"},`${n.tool} · hazard report`)),R("p",{class:`verdict ${n.verdict}`,"data-test":"verdict"},Yp(n)),R("p",{class:"scope","data-test":"scope"},R("strong",{},e),` ${i}`),R("p",{class:"note"},"A hazard is a way, found in the model, for a person to be hit harder than ISO/TS 15066 allows. The report helps an assessment; it does not show that the cell is safe."))}var jp=n=>`${(1e3*n).toFixed(0)} ms`;function Ty({transitions:n,compared:t,merges:e,merges_compared:i}){let s=(a,l)=>a===l?`all ${Ee(l)}`:`${Ee(a)} of ${Ee(l)}`,r=e>0?`, and ${s(i,e)} merges gone on with`:"",o=t===n&&i===e?"":"; a sample, chosen by a key";return t>0?`${s(t,n)} FMU transitions, by fresh instances from the start${r}${o}`:""}function Ay(n){let{certificate:t,settings:e}=n;if(Qr(n))return[R("h3",{},"From anywhere"),R("p",{"data-test":"anywhere"},`Looked at: ${jr(n)}. What is not known is told in the notes.`)];if(!t)return[R("h3",{},"Not complete"),R("p",{"data-test":"incomplete"},"There is no certificate of completeness: not every sequence of actions was looked at, so there may be hazards that are not listed. ","A complete search of the same cell: ",R("code",{},"--strategy exhaustive"),".")];let i=t.random_search;return[R("h3",{},t.complete?"Certificate: complete":"Not complete"),t.complete||t.complete_for_actions>=t.horizon?null:R("p",{"data-test":"incomplete"},`Only the beginnings of ${t.complete_for_actions} of ${t.horizon} actions were all looked at; hazards that need more actions may be missing.`),t.reasons.length>0?R("ul",{},t.reasons.map(s=>R("li",{},s))):null,li([["within",`${t.actions} actions, ${t.horizon} in a row, ${jp(e.action_s)} each; contact checked every ${jp(e.contact_check_interval_s)}; reach tolerance ${(1e3*e.reach_tolerance_m).toFixed(0)} mm`],["sequences",`${Ee(t.covered)} of ${Ee(t.sequences)} accounted for`],["hazardous",`${Ee(t.hazardous)}: ${ns(t.hazardous_share)}`],["harmless",Ee(t.harmless)],["too far away",`${Ee(t.excluded)} cannot meet the robot any more in the time that is left`],["not evaluated",t.not_evaluated==="0"?"":`${Ee(t.not_evaluated)}: the FMU could not finish them`],["distinct states",`${Ee(t.states)}; equal FMU states told by ${t.merged_by}${t.merged>0?` (${Ee(t.merged)} histories merged, ${Ee(t.merges_tried_out)} of the merges tried out)`:""}`],["run again",Ty(t.run_again)],["random search",i&&t.hazardous_share>0?`one in ${Ee((1/t.hazardous_share).toFixed(0))} random sequences is hazardous, so it needs that many iterations on average; within ${i.iterations} it finds nothing in ${ns(i.miss_probability)} of runs`:""]])]}function Cy(n){if(!n)return[];let t=n.hazardous===0?`below ${ns(n.hazardous_share_below,Math.ceil)}, one-sided`:`${ns(n.hazardous_share_interval[0],Math.floor)} to ${ns(n.hazardous_share_interval[1],Math.ceil)}, Clopper-Pearson`,e=n.unlisted;return[R("h3",{},"Residual: what is left, by random sequences alone"),li([["random sequences",`${Ee(n.random_sequences)}, of these ${Ee(n.hazardous)} hazardous${n.not_evaluated>0?`, ${Ee(n.not_evaluated)} not evaluated`:""}`],["hazardous share",`of all sequences: ${t}`],["not listed here",e?`one more random sequence ends in a hazard not listed with probability below ${ns(e.probability_below,Math.ceil)} (${Ee(e.met_others)} of ${Ee(e.checked)} later ones did; Good-Turing estimate ${ns(e.good_turing_estimate)})`:""],["confidence",`95 % each; for ${n.holds_for}`]])]}function Ry(n,t){let{coverage:e,spent:i,certificate:s}=n;if(Qr(n)){let l=`${de(i.fmu_steps,"FMU step")}, ${de(i.fmu_states,"FMU state")}, ${de(i.contact_checks,"set")} of poses, ${de(i.arm_checks,"arm search").replace("searchs","searches")}`;return[R("h3",{},"Coverage"),li([["spent",l]])]}let r=e.closest_approach_m<1e6?`${e.closest_approach_m.toFixed(2)} m${e.closest_approach_m<0?" (shapes overlap)":""}`:"never near",o=t.sensors,a=e.sensor_actions.map((l,c)=>`${o[c]} in ${de(l,"action")}`).join(", ");return[R("h3",{},"Coverage"),li([["sequences",s?"":`${Ee(i.iterations)}, ${Ee(e.episodes_not_evaluated)} not evaluated`],["spent",`${de(e.actions,"action")}, ${de(i.fmu_steps,"FMU step")}, ${de(i.fmu_states,"FMU state")}, ${de(e.contact_checks,"contact check")}, ${de(e.arm_checks,"arm search").replace("searchs","searches")}${e.arm_checks_incomplete>0?` (${Ee(e.arm_checks_incomplete)} ended early)`:""}${e.arm_runs_not_evaluated>0?`; ${Ee(e.arm_runs_not_evaluated)} runs in which a plane tells of an arm could not be finished by the FMU`:""}`],["robot",`moved at up to ${es(e.robot_top_speed_m_s)}; within arm's reach at ${de(e.checks_with_robot_in_arm_reach,"instant")}`],["closest approach",`of the body: ${r}`],["within the limits",`${de(e.contacts_within_limits,"contact")}${e.contacts_within_limits>0?`, highest ${Ze(e.highest_ratio_within_limits)}`:""}`],["walks",`obstacles stopped the person ${de(e.walks_blocked,"time")}`],["sensors",a?`reported the person: ${a}`:"none in this cell: the safeguard is the guarding itself"]])]}function Py(n){return n.length===0?[R("h3",{},"Faults of the FMU"),R("p",{},"None: the FMU finished every action that it was asked for.")]:[R("h3",{},"Faults of the FMU"),R("p",{},`${de(n.length,"action")} could not be finished; what would come after is not evaluated.`),R("ul",{class:"faults"},n.map(t=>R("li",{},R("p",{class:"message"},t.message),R("p",{class:"note"},t.actions.join(", ")))))]}function Qp({scan:n,cell:t}){let e=n.warnings.map(i=>R("li",{},i));return On("coverage","What the search covered",e.length>0?R("ul",{class:"warnings","data-test":"warnings"},e):null,R("div",{class:"columns"},R("div",{},Ay(n),Cy(n.residual)),R("div",{},Ry(n,t),Py(n.faults))))}var em=n=>Uint8Array.from(atob(n),t=>t.charCodeAt(0));function kl(n){let t=em(n),e=new DataView(t.buffer);return Float32Array.from({length:t.length/4},(i,s)=>e.getFloat32(4*s,!0))}async function tm(n){let t=new Blob([em(n)]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(t).json()}function Iy(n,t){let e={...n,step:t.step_s,links:kl(n.links),body:kl(n.body),arms:kl(n.arms)};for(let i of["time_s","distance_m","speed_m_s","force_ratio"])e[i]=kl(n[i]);return e}async function nm(){let n=JSON.parse(document.getElementById("data").textContent);if(n.format!==2)throw new Error(`data of format ${n.format}, but this viewer reads format 2`);let t=await tm(n.replays);n.cell.looks=n.cell.looks?await tm(n.cell.looks):[];let e=new Map(t.map(c=>[c.id,c])),i=new Map,s=new Map(n.scan.hazards.map(c=>[c.id,c])),r=n.scan.causes??[],o=new Map(r.map((c,d)=>[c.id,{...c,number:d+1}])),a=new Map([...o.values()].flatMap(c=>c.hazards.map(d=>[d,c]))),l=n.scan.hazards.filter(({id:c})=>!a.has(c));if(l.length>0)throw new Error(`${l[0].id} is in no cause`);return{...n,replays:t,causes:[...o.values()],cause:c=>o.get(c),causeOf:c=>a.get(c),hazard:c=>s.get(c),replay(c){return!i.has(c)&&e.has(c)&&i.set(c,Iy(e.get(c),n.cell)),i.get(c)},topView:c=>e.get(c)?.top_view}}var Gu="assessments.json";function Ly(n,{decisions:t}){let e={"data-test":`assess-${n.key}`,name:n.key};if(n.options){let i=n.key==="decision"?t.map(r=>[r,r]):n.options,s=R("option",{value:""},"–");return R("select",e,s,i.map(([r,o])=>R("option",{value:r},o)))}return n.long?R("textarea",{...e,rows:2}):R("input",{...e,type:n.type??"text"})}function Dy(n){let t=URL.createObjectURL(new Blob([n],{type:"application/json"}));R("a",{href:t,download:Gu}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function im(n,t,e){let i=Kr.map(p=>[p,Ly(p,e)]),s=R("p",{class:"subject","data-test":"assess-subject"}),r=R("input",{type:"checkbox","data-test":"assess-scope",onchange:m}),o=R("span"),a=R("output",{class:"plr","data-test":"plr"}),l=R("output",{"data-test":"unsaved"}),c=R("button",{type:"button",class:"primary","data-test":"save",onclick:u},`Save ${Gu}`),d=null,h=()=>r.checked?t.now.hazard:t.now.cause;function u(){Dy(e.text()),e.saved()}function f(){let p=fr(e.of(h()));a.textContent=p?`PL r: ${p}`:"PL r: follows from severity, exposure and avoidance";let g=e.unsaved();l.textContent=g?`Unsaved edits of ${g}.`:"";let v=e.own(t.now.hazard);o.textContent=` only this row: ${t.now.hazard}${v?` (decided on its own: ${v})`:""}`}function m(){let p=n.hazard(t.now.hazard),g=n.cause(t.now.cause);s.replaceChildren(R("b",{},h()),r.checked?`: only ${p.robot_link} hits the ${vn(p.body_region)}, ${Ze(p.ratio)}. What is left empty is as for the cause.`:`, for ${g.hazards.length===1?"its one way":`all its ${de(g.hazards.length,"way")}`}: ${g.sentence}`);for(let[v,S]of i){let b=e.of(h())[v.key]??"";S.tagName==="SELECT"&&![...S.options].some(C=>C.value===b)&&S.append(R("option",{value:b},b)),v.key==="decision"&&(S.options[0].hidden=!r.checked,S.options[0].textContent=`as for the cause (${e.ofCause(g.id)})`),S.value=b||(v.key==="decision"&&!r.checked?"open":"")}f()}for(let[p,g]of i)g.addEventListener("input",()=>e.set(h(),p.key,g.value));t.follow(p=>{p.cause!==d&&(d=p.cause,r.checked=!1),m()}),e.follow(f);let _=On("assessment","Assessment (ISO 12100)",s,R("label",{class:"scope-switch"},r,o),R("form",{onsubmit:p=>p.preventDefault()},i.map(([p,g])=>R("label",{class:p.long?"long":null},R("span",{},p.label),g))),R("p",{class:"plr-line"},a,R("span",{class:"note"}," Required performance level by the risk graph of ISO 13849-1, Annex A.")),R("p",{class:"save"},c,l),R("p",{class:"note"},`Saves the assessments of all causes and rows, those given to this report included, as one file. Keep ${Gu} beside the cell file, in git: scans read it and never write it. This page itself keeps no edits.`));return{element:_,show(){_.scrollIntoView({block:"start"}),i[0][1].focus({preventScroll:!0})}}}function Hs(n,t,e){let i=[0,1,2].map(a=>e[a]-t[a]),s=i.reduce((a,l)=>a+l*l,0),r=s>0?i.reduce((a,l,c)=>a+l*(n[c]-t[c]),0)/s:0,o=Math.max(0,Math.min(1,r));return Math.hypot(...[0,1,2].map(a=>n[a]-t[a]-o*i[a]))}function sm(n,t,{a:e,b:i,radius:s}){for(let o=0;o<24;o++){let a=o/24;if(Hs(n.map((l,c)=>l+a*(t[c]-l)),e,i)<s)return!0}return!1}function Hu([n,t,e,i],[s,r,o]){let[a,l,c]=[2*(t*o-e*r),2*(e*s-n*o),2*(n*r-t*s)];return[s+i*a+t*c-e*l,r+i*l+e*a-n*c,o+i*c+n*l-t*a]}function Wu(n){let t=[...n].sort(([i,s],[r,o])=>i-r||s-o),e=i=>{let s=[];for(let r of i){for(;s.length>1;){let[o,a]=s.slice(-2);if((a[0]-o[0])*(r[1]-o[1])-(a[1]-o[1])*(r[0]-o[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return[...e(t),...e(t.reverse())]}function jn({centre_m:n,size_m:t,quaternion:e}){let i=[-.5,.5],s=i.flatMap(r=>i.flatMap(o=>i.map(a=>[r*t[0],o*t[1],a*t[2]])));return Wu(s.map(r=>Hu(e,r)).map(([r,o])=>[n[0]+r,n[1]+o]))}function zl([n,t],e){return e.every(([i,s],r)=>{let[o,a]=e[(r+1)%e.length];return(o-i)*(t-s)-(a-s)*(n-i)>=0})}var to=(n,t)=>[n[t],n[t+1],n[t+2]];function bi(n,t,e,i){let s=6*(e*t.body.length+i);return{a:to(n.body,s),b:to(n.body,s+3),radius:t.body[i].radius_m}}var pr=["left","right"];function eo(n,t,e){let i=9*(2*t+e);return[0,3,6].map(s=>to(n.arms,i+s))}function rm(n,t,e){let[[i],[s]]=pr.map((l,c)=>eo(n,e,c)),[r,o]=[i[0]-s[0],i[1]-s[1]],a=Math.hypot(r,o);if(a<.02){let l=t.person_heading_deg*Math.PI/180;return[Math.cos(l),Math.sin(l),0]}return[o/a,-r/a,0]}var om=n=>({upper_arm:0,lower_arm:1,hand:2})[n];function is(n,t,e,i){let s=7*(e*t.links.length+i),r=t.links[i];return r.shape==="capsule"?{a:to(n.links,s),b:to(n.links,s+3),radius:r.radius_m}:{position:to(n.links,s),quaternion:[...n.links.slice(s+3,s+7)]}}function no(n,{position:t,quaternion:e}){return n.points_m.map(i=>Hu(e,i).map((s,r)=>s+t[r]))}function da(n,t,e,i){let s=is(n,t,e,i);return s.position?no(t.links[i],s):[s.a,s.b]}function $u(n,t){return n.reduce((e,i)=>t(i)<t(e)?i:e,n[0])}function am(n,t,e){let i=s=>{let{a:r,b:o,radius:a}=bi(n,t,n.contact_frame,s);return Hs(e.body_point_m,r,o)-a};return $u([...t.body.keys()],i)}function lm(n,t,e){let i=[...t.links.keys()].filter(r=>{let{name:o,robot:a}=t.links[r];return o===e.robot_link||`${a}/${o}`===e.robot_link}),s=r=>{let o=is(n,t,n.contact_frame,r),a=e.contact_point_m;return o.position?Math.min(...no(t.links[r],o).map(l=>Hs(a,l,l))):Hs(a,o.a,o.b)-o.radius};return $u(i.length>0?i:[...t.links.keys()],s)}function Xu(n){let t=[...n.body.keys()].filter(e=>n.body[e].region.endsWith("shank"));return t.length>0?t:[n.body.length-1]}function cm(n,t){let e=Xu(t);return Array.from({length:n.frames},(i,s)=>{let r=e.map(o=>bi(n,t,s,o).b);return[0,1].map(o=>r.reduce((a,l)=>a+l[o],0)/r.length)})}function hm(n,t){let e=i=>-bi(n,t,0,i).a[2];return $u([...t.body.keys()],e)}var ir={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},sr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Zm=0,Pd=1,Jm=2;var il=1,Km=2,Fo=3,rr=0,Zn=1,Ei=2,Mr=0,Uo=1,Id=2,Ld=3,Dd=4,jm=5;var wr=100,Qm=101,tg=102,eg=103,ng=104,ig=200,sg=201,rg=202,og=203,Nd=204,Fd=205,ag=206,lg=207,cg=208,hg=209,ug=210,dg=211,fg=212,pg=213,mg=214,_c=0,xc=1,yc=2,So=3,vc=4,bc=5,Sc=6,Mc=7,eh=0,gg=1,_g=2,cs=0,Ud=1,Od=2,Bd=3,kd=4,zd=5,Vd=6,Gd=7;var Hd=300,Er=301,Oo=302,nh=303,ih=304,wc=1e3,rs=1001,Ec=1002,In=1003,xg=1004;var sl=1005;var Yn=1006,sh=1007;var Cs=1008;var ti=1009,Wd=1010,$d=1011,Bo=1012,rh=1013,ki=1014,zi=1015,Vi=1016,oh=1017,ah=1018,Tr=1020,Xd=35902,qd=35899,Yd=1021,Zd=1022,Gi=1023,ws=1026,Rs=1027,Jd=1028,lh=1029,or=1030,ch=1031;var hh=1033,rl=33776,ol=33777,al=33778,ll=33779,uh=35840,dh=35841,fh=35842,ph=35843,mh=36196,gh=37492,_h=37496,xh=37488,yh=37489,cl=37490,vh=37491,bh=37808,Sh=37809,Mh=37810,wh=37811,Eh=37812,Th=37813,Ah=37814,Ch=37815,Rh=37816,Ph=37817,Ih=37818,Lh=37819,Dh=37820,Nh=37821,Fh=36492,Uh=36494,Oh=36495,Bh=36283,kh=36284,hl=36285,zh=36286;var Ma=2300,Tc=2301,mc=2302,yd=2303,vd=2400,bd=2401,Sd=2402;var yg=3200;var Vh=0,vg=1,Ps="",ui="srgb",wa="srgb-linear",Ea="linear",Ie="srgb";var gc=7680;var bg=519,Sg=512,Mg=513,wg=514,Kd=515,Eg=516,Tg=517,jd=518,Qd=519,Ag=35044;var tf="300 es",Mi=2e3,Mo=2001;function Ny(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Fy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ta(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Cg(){let n=Ta("canvas");return n.style.display="block",n}var um={},wo=null;function ef(...n){let t="THREE."+n.shift();wo?wo("log",t,...n):console.log(t,...n)}function Rg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Kt(...n){n=Rg(n);let t="THREE."+n.shift();if(wo)wo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ie(...n){n=Rg(n);let t="THREE."+n.shift();if(wo)wo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ya(...n){let t=n.join(" ");t in um||(um[t]=!0,Kt(...n))}function Pg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Ig={[_c]:_c,[yc]:Sc,[vc]:vc,[So]:bc,[xc]:xc,[Sc]:yc,[Mc]:Mc,[bc]:So},Ui=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],dm=1234567,yo=Math.PI/180,Eo=180/Math.PI;function Ar(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[t&255]+Bn[t>>8&255]+"-"+Bn[t>>16&15|64]+Bn[t>>24&255]+"-"+Bn[e&63|128]+Bn[e>>8&255]+"-"+Bn[e>>16&255]+Bn[e>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function re(n,t,e){return Math.max(t,Math.min(e,n))}function nf(n,t){return(n%t+t)%t}function Uy(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Oy(n,t,e){return n!==t?(e-n)/(t-n):0}function va(n,t,e){return(1-e)*n+e*t}function By(n,t,e,i){return va(n,t,1-Math.exp(-e*i))}function ky(n,t=1){return t-Math.abs(nf(n,t*2)-t)}function zy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Vy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Gy(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Hy(n,t){return n+Math.random()*(t-n)}function Wy(n){return n*(.5-Math.random())}function $y(n){n!==void 0&&(dm=n);let t=dm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Xy(n){return n*yo}function qy(n){return n*Eo}function Yy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Zy(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function sf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Jy(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),d=o((t+i)/2),h=r((t-i)/2),u=o((t-i)/2),f=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*d,l*h,l*u,a*c);break;case"YZY":n.set(l*u,a*d,l*h,a*c);break;case"ZXZ":n.set(l*h,l*u,a*d,a*c);break;case"XZX":n.set(a*d,l*m,l*f,a*c);break;case"YXY":n.set(l*f,a*d,l*m,a*c);break;case"ZYZ":n.set(l*m,l*f,a*d,a*c);break;default:Kt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function rf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Lg(n,t){if(t.constructor===Float32Array)return n;let e=rf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Dg(n,t){if(t.constructor===Float32Array)return n;let e=rf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var of={DEG2RAD:yo,RAD2DEG:Eo,generateUUID:Ar,clamp:re,euclideanModulo:nf,mapLinear:Uy,inverseLerp:Oy,lerp:va,damp:By,pingpong:ky,smoothstep:zy,smootherstep:Vy,randInt:Gy,randFloat:Hy,randFloatSpread:Wy,seededRandom:$y,degToRad:Xy,radToDeg:qy,isPowerOfTwo:Yy,ceilPowerOfTwo:Zy,floorPowerOfTwo:sf,setQuaternionFromProperEuler:Jy,normalize:Dg,denormalize:Lg},Dt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(re(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(re(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Dn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],d=i[s+2],h=i[s+3],u=r[o+0],f=r[o+1],m=r[o+2],_=r[o+3];if(h!==_||l!==u||c!==f||d!==m){let p=l*u+c*f+d*m+h*_;p<0&&(u=-u,f=-f,m=-m,_=-_,p=-p);let g=1-a;if(p<.9995){let v=Math.acos(p),S=Math.sin(v);g=Math.sin(g*v)/S,a=Math.sin(a*v)/S,l=l*g+u*a,c=c*g+f*a,d=d*g+m*a,h=h*g+_*a}else{l=l*g+u*a,c=c*g+f*a,d=d*g+m*a,h=h*g+_*a;let v=1/Math.sqrt(l*l+c*c+d*d+h*h);l*=v,c*=v,d*=v,h*=v}}t[e]=l,t[e+1]=c,t[e+2]=d,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],d=i[s+3],h=r[o],u=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+d*h+l*f-c*u,t[e+1]=l*m+d*u+c*h-a*f,t[e+2]=c*m+d*f+a*u-l*h,t[e+3]=d*m-a*h-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),d=a(s/2),h=a(r/2),u=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=u*d*h+c*f*m,this._y=c*f*h-u*d*m,this._z=c*d*m+u*f*h,this._w=c*d*h-u*f*m;break;case"YXZ":this._x=u*d*h+c*f*m,this._y=c*f*h-u*d*m,this._z=c*d*m-u*f*h,this._w=c*d*h+u*f*m;break;case"ZXY":this._x=u*d*h-c*f*m,this._y=c*f*h+u*d*m,this._z=c*d*m+u*f*h,this._w=c*d*h-u*f*m;break;case"ZYX":this._x=u*d*h-c*f*m,this._y=c*f*h+u*d*m,this._z=c*d*m-u*f*h,this._w=c*d*h+u*f*m;break;case"YZX":this._x=u*d*h+c*f*m,this._y=c*f*h+u*d*m,this._z=c*d*m-u*f*h,this._w=c*d*h-u*f*m;break;case"XZY":this._x=u*d*h-c*f*m,this._y=c*f*h-u*d*m,this._z=c*d*m+u*f*h,this._w=c*d*h+u*f*m;break;default:Kt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],d=e[6],h=e[10],u=i+a+h;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(d-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(d-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+d)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+d)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(re(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,d=e._w;return this._x=i*d+o*a+s*c-r*l,this._y=s*d+o*l+r*a-i*c,this._z=r*d+o*c+i*l-s*a,this._w=o*d-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),d=Math.sin(c);l=Math.sin(l*c)/d,e=Math.sin(e*c)/d,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(fm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(fm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),d=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*d,this.y=i+l*d+a*c-r*h,this.z=s+l*h+r*d-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this.z=re(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this.z=re(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(re(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return qu.copy(this).projectOnVector(t),this.sub(qu)}reflect(t){return this.sub(qu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(re(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},qu=new O,fm=new Dn,oe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let d=this.elements;return d[0]=t,d[1]=s,d[2]=a,d[3]=e,d[4]=r,d[5]=l,d[6]=i,d[7]=o,d[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],d=i[4],h=i[7],u=i[2],f=i[5],m=i[8],_=s[0],p=s[3],g=s[6],v=s[1],S=s[4],b=s[7],C=s[2],w=s[5],x=s[8];return r[0]=o*_+a*v+l*C,r[3]=o*p+a*S+l*w,r[6]=o*g+a*b+l*x,r[1]=c*_+d*v+h*C,r[4]=c*p+d*S+h*w,r[7]=c*g+d*b+h*x,r[2]=u*_+f*v+m*C,r[5]=u*p+f*S+m*w,r[8]=u*g+f*b+m*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8];return e*o*d-e*a*c-i*r*d+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8],h=d*o-a*c,u=a*l-d*r,f=c*r-o*l,m=e*h+i*u+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return t[0]=h*_,t[1]=(s*c-d*i)*_,t[2]=(a*i-s*o)*_,t[3]=u*_,t[4]=(d*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ya("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Yu.makeScale(t,e)),this}rotate(t){return ya("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Yu.makeRotation(-t)),this}translate(t,e){return ya("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Yu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Yu=new oe,pm=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),mm=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ky(){let n={enabled:!0,workingColorSpace:wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ie&&(s.r=Ms(s.r),s.g=Ms(s.g),s.b=Ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(s.r=vo(s.r),s.g=vo(s.g),s.b=vo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?Ea:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[wa]:{primaries:t,whitePoint:i,transfer:Ea,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ui},outputColorSpaceConfig:{drawingBufferColorSpace:ui}},[ui]:{primaries:t,whitePoint:i,transfer:Ie,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ui}}}),n}var Me=Ky();function Ms(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function vo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var io,Ac=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{io===void 0&&(io=Ta("canvas")),io.width=t.width,io.height=t.height;let s=io.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=io}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ta("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ms(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ms(e[i]/255)*255):e[i]=Ms(e[i]);return{data:e,width:t.width,height:t.height}}else return Kt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},jy=0,To=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jy++}),this.uuid=Ar(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Zu(s[o].image)):r.push(Zu(s[o]))}else r=Zu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Zu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ac.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Kt("Texture: Unable to serialize Texture."),{})}var Qy=0,Ju=new O,Qn=class n extends Ui{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=rs,s=rs,r=Yn,o=Cs,a=Gi,l=ti,c=n.DEFAULT_ANISOTROPY,d=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Qy++}),this.uuid=Ar(),this.name="",this.source=new To(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Dt(0,0),this.repeat=new Dt(1,1),this.center=new Dt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=d,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ju).x}get height(){return this.source.getSize(Ju).y}get depth(){return this.source.getSize(Ju).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Kt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Hd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case wc:t.x=t.x-Math.floor(t.x);break;case rs:t.x=t.x<0?0:1;break;case Ec:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case wc:t.y=t.y-Math.floor(t.y);break;case rs:t.y=t.y<0?0:1;break;case Ec:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=Hd;Qn.DEFAULT_ANISOTROPY=1;var en=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],d=l[4],h=l[8],u=l[1],f=l[5],m=l[9],_=l[2],p=l[6],g=l[10];if(Math.abs(d-u)<.01&&Math.abs(h-_)<.01&&Math.abs(m-p)<.01){if(Math.abs(d+u)<.1&&Math.abs(h+_)<.1&&Math.abs(m+p)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,b=(f+1)/2,C=(g+1)/2,w=(d+u)/4,x=(h+_)/4,T=(m+p)/4;return S>b&&S>C?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=w/i,r=x/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=w/s,r=T/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=T/r),this.set(i,s,r,e),this}let v=Math.sqrt((p-m)*(p-m)+(h-_)*(h-_)+(u-d)*(u-d));return Math.abs(v)<.001&&(v=1),this.x=(p-m)/v,this.y=(h-_)/v,this.z=(u-d)/v,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this.z=re(this.z,t.z,e.z),this.w=re(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this.z=re(this.z,t,e),this.w=re(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(re(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Cc=class extends Ui{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new en(0,0,t,e),this.scissorTest=!1,this.viewport=new en(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new To(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},fi=class extends Cc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Aa=class extends Qn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=rs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Rc=class extends Qn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=rs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Be=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,d,h,u,f,m,_,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,d,h,u,f,m,_,p)}set(t,e,i,s,r,o,a,l,c,d,h,u,f,m,_,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=d,g[10]=h,g[14]=u,g[3]=f,g[7]=m,g[11]=_,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/so.setFromMatrixColumn(t,0).length(),r=1/so.setFromMatrixColumn(t,1).length(),o=1/so.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),d=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let u=o*d,f=o*h,m=a*d,_=a*h;e[0]=l*d,e[4]=-l*h,e[8]=c,e[1]=f+m*c,e[5]=u-_*c,e[9]=-a*l,e[2]=_-u*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*d,f=l*h,m=c*d,_=c*h;e[0]=u+_*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*d,e[9]=-a,e[2]=f*a-m,e[6]=_+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*d,f=l*h,m=c*d,_=c*h;e[0]=u-_*a,e[4]=-o*h,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*d,e[9]=_-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*d,f=o*h,m=a*d,_=a*h;e[0]=l*d,e[4]=m*c-f,e[8]=u*c+_,e[1]=l*h,e[5]=_*c+u,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*d,e[4]=_-u*h,e[8]=m*h+f,e[1]=h,e[5]=o*d,e[9]=-a*d,e[2]=-c*d,e[6]=f*h+m,e[10]=u-_*h}else if(t.order==="XZY"){let u=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*d,e[4]=-h,e[8]=c*d,e[1]=u*h+_,e[5]=o*d,e[9]=f*h-m,e[2]=m*h-f,e[6]=a*d,e[10]=_*h+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(tv,t,ev)}lookAt(t,e,i){let s=this.elements;return ci.subVectors(t,e),ci.lengthSq()===0&&(ci.z=1),ci.normalize(),Ws.crossVectors(i,ci),Ws.lengthSq()===0&&(Math.abs(i.z)===1?ci.x+=1e-4:ci.z+=1e-4,ci.normalize(),Ws.crossVectors(i,ci)),Ws.normalize(),Vl.crossVectors(ci,Ws),s[0]=Ws.x,s[4]=Vl.x,s[8]=ci.x,s[1]=Ws.y,s[5]=Vl.y,s[9]=ci.y,s[2]=Ws.z,s[6]=Vl.z,s[10]=ci.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],d=i[1],h=i[5],u=i[9],f=i[13],m=i[2],_=i[6],p=i[10],g=i[14],v=i[3],S=i[7],b=i[11],C=i[15],w=s[0],x=s[4],T=s[8],B=s[12],F=s[1],L=s[5],G=s[9],H=s[13],N=s[2],$=s[6],Z=s[10],W=s[14],ut=s[3],D=s[7],q=s[11],K=s[15];return r[0]=o*w+a*F+l*N+c*ut,r[4]=o*x+a*L+l*$+c*D,r[8]=o*T+a*G+l*Z+c*q,r[12]=o*B+a*H+l*W+c*K,r[1]=d*w+h*F+u*N+f*ut,r[5]=d*x+h*L+u*$+f*D,r[9]=d*T+h*G+u*Z+f*q,r[13]=d*B+h*H+u*W+f*K,r[2]=m*w+_*F+p*N+g*ut,r[6]=m*x+_*L+p*$+g*D,r[10]=m*T+_*G+p*Z+g*q,r[14]=m*B+_*H+p*W+g*K,r[3]=v*w+S*F+b*N+C*ut,r[7]=v*x+S*L+b*$+C*D,r[11]=v*T+S*G+b*Z+C*q,r[15]=v*B+S*H+b*W+C*K,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],d=t[2],h=t[6],u=t[10],f=t[14],m=t[3],_=t[7],p=t[11],g=t[15],v=l*f-c*u,S=a*f-c*h,b=a*u-l*h,C=o*f-c*d,w=o*u-l*d,x=o*h-a*d;return e*(_*v-p*S+g*b)-i*(m*v-p*C+g*w)+s*(m*S-_*C+g*x)-r*(m*b-_*w+p*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],d=t[10];return e*(o*d-a*c)-i*(r*d-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8],h=t[9],u=t[10],f=t[11],m=t[12],_=t[13],p=t[14],g=t[15],v=e*a-i*o,S=e*l-s*o,b=e*c-r*o,C=i*l-s*a,w=i*c-r*a,x=s*c-r*l,T=d*_-h*m,B=d*p-u*m,F=d*g-f*m,L=h*p-u*_,G=h*g-f*_,H=u*g-f*p,N=v*H-S*G+b*L+C*F-w*B+x*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let $=1/N;return t[0]=(a*H-l*G+c*L)*$,t[1]=(s*G-i*H-r*L)*$,t[2]=(_*x-p*w+g*C)*$,t[3]=(u*w-h*x-f*C)*$,t[4]=(l*F-o*H-c*B)*$,t[5]=(e*H-s*F+r*B)*$,t[6]=(p*b-m*x-g*S)*$,t[7]=(d*x-u*b+f*S)*$,t[8]=(o*G-a*F+c*T)*$,t[9]=(i*F-e*G-r*T)*$,t[10]=(m*w-_*b+g*v)*$,t[11]=(h*b-d*w-f*v)*$,t[12]=(a*B-o*L-l*T)*$,t[13]=(e*L-i*B+s*T)*$,t[14]=(_*S-m*C-p*v)*$,t[15]=(d*C-h*S+u*v)*$,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,d=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,d*a+i,d*l-s*o,0,c*l-s*a,d*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,d=o+o,h=a+a,u=r*c,f=r*d,m=r*h,_=o*d,p=o*h,g=a*h,v=l*c,S=l*d,b=l*h,C=i.x,w=i.y,x=i.z;return s[0]=(1-(_+g))*C,s[1]=(f+b)*C,s[2]=(m-S)*C,s[3]=0,s[4]=(f-b)*w,s[5]=(1-(u+g))*w,s[6]=(p+v)*w,s[7]=0,s[8]=(m+S)*x,s[9]=(p-v)*x,s[10]=(1-(u+_))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=so.set(s[0],s[1],s[2]).length(),a=so.set(s[4],s[5],s[6]).length(),l=so.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Li.copy(this);let c=1/o,d=1/a,h=1/l;return Li.elements[0]*=c,Li.elements[1]*=c,Li.elements[2]*=c,Li.elements[4]*=d,Li.elements[5]*=d,Li.elements[6]*=d,Li.elements[8]*=h,Li.elements[9]*=h,Li.elements[10]*=h,e.setFromRotationMatrix(Li),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Mi,l=!1){let c=this.elements,d=2*r/(e-t),h=2*r/(i-s),u=(e+t)/(e-t),f=(i+s)/(i-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===Mi)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Mo)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Mi,l=!1){let c=this.elements,d=2/(e-t),h=2/(i-s),u=-(e+t)/(e-t),f=-(i+s)/(i-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===Mi)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===Mo)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},so=new O,Li=new Be,tv=new O(0,0,0),ev=new O(1,1,1),Ws=new O,Vl=new O,ci=new O,gm=new Be,_m=new Dn,Es=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],d=s[9],h=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(re(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-d,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-re(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(re(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-re(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(re(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-d,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-re(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-d,f),this._y=0);break;default:Kt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return gm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(gm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return _m.setFromEuler(this),this.setFromQuaternion(_m,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Es.DEFAULT_ORDER="XYZ";var Ao=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},nv=0,xm=new O,ro=new Dn,xs=new Be,Gl=new O,fa=new O,iv=new O,sv=new Dn,ym=new O(1,0,0),vm=new O(0,1,0),bm=new O(0,0,1),Sm={type:"added"},rv={type:"removed"},oo={type:"childadded",child:null},Ku={type:"childremoved",child:null},Nn=class n extends Ui{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:nv++}),this.uuid=Ar(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new O,e=new Es,i=new Dn,s=new O(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Be},normalMatrix:{value:new oe}}),this.matrix=new Be,this.matrixWorld=new Be,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ro.setFromAxisAngle(t,e),this.quaternion.multiply(ro),this}rotateOnWorldAxis(t,e){return ro.setFromAxisAngle(t,e),this.quaternion.premultiply(ro),this}rotateX(t){return this.rotateOnAxis(ym,t)}rotateY(t){return this.rotateOnAxis(vm,t)}rotateZ(t){return this.rotateOnAxis(bm,t)}translateOnAxis(t,e){return xm.copy(t).applyQuaternion(this.quaternion),this.position.add(xm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(ym,t)}translateY(t){return this.translateOnAxis(vm,t)}translateZ(t){return this.translateOnAxis(bm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(xs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Gl.copy(t):Gl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),fa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xs.lookAt(fa,Gl,this.up):xs.lookAt(Gl,fa,this.up),this.quaternion.setFromRotationMatrix(xs),s&&(xs.extractRotation(s.matrixWorld),ro.setFromRotationMatrix(xs),this.quaternion.premultiply(ro.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Sm),oo.child=t,this.dispatchEvent(oo),oo.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(rv),Ku.child=t,this.dispatchEvent(Ku),Ku.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),xs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),xs.multiply(t.parent.matrixWorld)),t.applyMatrix4(xs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Sm),oo.child=t,this.dispatchEvent(oo),oo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(fa,t,iv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(fa,sv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,d=l.length;c<d;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),d=o(t.images),h=o(t.shapes),u=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),d.length>0&&(i.images=d),h.length>0&&(i.shapes=h),u.length>0&&(i.skeletons=u),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let d=a[c];delete d.metadata,l.push(d)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new O(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var di=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},ov={type:"move"},Co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new di,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new di,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new di,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let p=e.getJointPose(_,i),g=this._getHandJoint(c,_);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let d=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],u=d.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&u>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ov)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new di;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Ng={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},$s={h:0,s:0,l:0},Hl={h:0,s:0,l:0};function ju(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var le=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ui){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Me.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Me.workingColorSpace){return this.r=t,this.g=e,this.b=i,Me.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Me.workingColorSpace){if(t=nf(t,1),e=re(e,0,1),i=re(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ju(o,r,t+1/3),this.g=ju(o,r,t),this.b=ju(o,r,t-1/3)}return Me.colorSpaceToWorking(this,s),this}setStyle(t,e=ui){function i(r){r!==void 0&&parseFloat(r)<1&&Kt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Kt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Kt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ui){let i=Ng[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Kt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ms(t.r),this.g=Ms(t.g),this.b=Ms(t.b),this}copyLinearToSRGB(t){return this.r=vo(t.r),this.g=vo(t.g),this.b=vo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ui){return Me.workingToColorSpace(kn.copy(this),t),Math.round(re(kn.r*255,0,255))*65536+Math.round(re(kn.g*255,0,255))*256+Math.round(re(kn.b*255,0,255))}getHexString(t=ui){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Me.workingColorSpace){Me.workingToColorSpace(kn.copy(this),e);let i=kn.r,s=kn.g,r=kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,d=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=d<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=d,t}getRGB(t,e=Me.workingColorSpace){return Me.workingToColorSpace(kn.copy(this),e),t.r=kn.r,t.g=kn.g,t.b=kn.b,t}getStyle(t=ui){Me.workingToColorSpace(kn.copy(this),t);let e=kn.r,i=kn.g,s=kn.b;return t!==ui?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL($s),this.setHSL($s.h+t,$s.s+e,$s.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL($s),t.getHSL(Hl);let i=va($s.h,Hl.h,e),s=va($s.s,Hl.s,e),r=va($s.l,Hl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new le;le.NAMES=Ng;var Ca=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Es,this.environmentIntensity=1,this.environmentRotation=new Es,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Di=new O,ys=new O,Qu=new O,vs=new O,ao=new O,lo=new O,Mm=new O,td=new O,ed=new O,nd=new O,id=new en,sd=new en,rd=new en,Fi=class n{constructor(t=new O,e=new O,i=new O){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Di.subVectors(t,e),s.cross(Di);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Di.subVectors(s,e),ys.subVectors(i,e),Qu.subVectors(t,e);let o=Di.dot(Di),a=Di.dot(ys),l=Di.dot(Qu),c=ys.dot(ys),d=ys.dot(Qu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let u=1/h,f=(c*l-a*d)*u,m=(o*d-a*l)*u;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,vs)===null?!1:vs.x>=0&&vs.y>=0&&vs.x+vs.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vs.x),l.addScaledVector(o,vs.y),l.addScaledVector(a,vs.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return id.setScalar(0),sd.setScalar(0),rd.setScalar(0),id.fromBufferAttribute(t,e),sd.fromBufferAttribute(t,i),rd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(id,r.x),o.addScaledVector(sd,r.y),o.addScaledVector(rd,r.z),o}static isFrontFacing(t,e,i,s){return Di.subVectors(i,e),ys.subVectors(t,e),Di.cross(ys).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Di.subVectors(this.c,this.b),ys.subVectors(this.a,this.b),Di.cross(ys).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ao.subVectors(s,i),lo.subVectors(r,i),td.subVectors(t,i);let l=ao.dot(td),c=lo.dot(td);if(l<=0&&c<=0)return e.copy(i);ed.subVectors(t,s);let d=ao.dot(ed),h=lo.dot(ed);if(d>=0&&h<=d)return e.copy(s);let u=l*h-d*c;if(u<=0&&l>=0&&d<=0&&l-d>0)return o=l/(l-d),e.copy(i).addScaledVector(ao,o);nd.subVectors(t,r);let f=ao.dot(nd),m=lo.dot(nd);if(m>=0&&f<=m)return e.copy(r);let _=f*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(lo,a);let p=d*m-f*h;if(p<=0&&h-d>=0&&f-m>=0)return Mm.subVectors(r,s),a=(h-d)/(h-d+(f-m)),e.copy(s).addScaledVector(Mm,a);let g=1/(p+_+u);return o=_*g,a=u*g,e.copy(i).addScaledVector(ao,o).addScaledVector(lo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Zs=class{constructor(t=new O(1/0,1/0,1/0),e=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ni.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ni.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ni.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(t.matrixWorld),this.expandByPoint(Ni);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Wl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Wl.copy(i.boundingBox)),Wl.applyMatrix4(t.matrixWorld),this.union(Wl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ni),Ni.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(pa),$l.subVectors(this.max,pa),co.subVectors(t.a,pa),ho.subVectors(t.b,pa),uo.subVectors(t.c,pa),Xs.subVectors(ho,co),qs.subVectors(uo,ho),mr.subVectors(co,uo);let e=[0,-Xs.z,Xs.y,0,-qs.z,qs.y,0,-mr.z,mr.y,Xs.z,0,-Xs.x,qs.z,0,-qs.x,mr.z,0,-mr.x,-Xs.y,Xs.x,0,-qs.y,qs.x,0,-mr.y,mr.x,0];return!od(e,co,ho,uo,$l)||(e=[1,0,0,0,1,0,0,0,1],!od(e,co,ho,uo,$l))?!1:(Xl.crossVectors(Xs,qs),e=[Xl.x,Xl.y,Xl.z],od(e,co,ho,uo,$l))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ni).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ni).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(bs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},bs=[new O,new O,new O,new O,new O,new O,new O,new O],Ni=new O,Wl=new Zs,co=new O,ho=new O,uo=new O,Xs=new O,qs=new O,mr=new O,pa=new O,$l=new O,Xl=new O,gr=new O;function od(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){gr.fromArray(n,r);let a=s.x*Math.abs(gr.x)+s.y*Math.abs(gr.y)+s.z*Math.abs(gr.z),l=t.dot(gr),c=e.dot(gr),d=i.dot(gr);if(Math.max(-Math.max(l,c,d),Math.min(l,c,d))>a)return!1}return!0}var _n=new O,ql=new Dt,av=0,os=class extends Ui{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:av++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Ag,this.updateRanges=[],this.gpuType=zi,this.version=0,this._normalizationScale=t!==void 0?rf(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)ql.fromBufferAttribute(this,e),ql.applyMatrix3(t),this.setXY(e,ql.x,ql.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Lg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Dg(t,this.array)}};var Ra=class extends os{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Pa=class extends os{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ve=class extends os{constructor(t,e,i){super(new Float32Array(t),e,i)}},lv=new Zs,ma=new O,ad=new O,yr=class{constructor(t=new O,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):lv.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ma.subVectors(t,this.center);let e=ma.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ma,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ad.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ma.copy(t.center).add(ad)),this.expandByPoint(ma.copy(t.center).sub(ad))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},cv=0,Si=new Be,ld=new Nn,fo=new O,hi=new Zs,ga=new Zs,Pn=new O,Ke=class n extends Ui{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:cv++}),this.uuid=Ar(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Ny(t)?Pa:Ra)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new oe().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Si.makeRotationFromQuaternion(t),this.applyMatrix4(Si),this}rotateX(t){return Si.makeRotationX(t),this.applyMatrix4(Si),this}rotateY(t){return Si.makeRotationY(t),this.applyMatrix4(Si),this}rotateZ(t){return Si.makeRotationZ(t),this.applyMatrix4(Si),this}translate(t,e,i){return Si.makeTranslation(t,e,i),this.applyMatrix4(Si),this}scale(t,e,i){return Si.makeScale(t,e,i),this.applyMatrix4(Si),this}lookAt(t){return ld.lookAt(t),ld.updateMatrix(),this.applyMatrix4(ld.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(fo).negate(),this.translate(fo.x,fo.y,fo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ve(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Kt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Zs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];hi.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,hi.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,hi.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(hi.min),this.boundingBox.expandByPoint(hi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new yr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(t){let i=this.boundingSphere.center;if(hi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ga.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(hi.min,ga.min),hi.expandByPoint(Pn),Pn.addVectors(hi.max,ga.max),hi.expandByPoint(Pn)):(hi.expandByPoint(ga.min),hi.expandByPoint(ga.max))}hi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Pn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Pn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,d=a.count;c<d;c++)Pn.fromBufferAttribute(a,c),l&&(fo.fromBufferAttribute(t,c),Pn.add(fo)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new os(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new O,l[B]=new O;let d=new O,h=new O,u=new O,f=new Dt,m=new Dt,_=new Dt,p=new O,g=new O;function v(B,F,L){c[B]=c[F]=c[L]=1,d.fromBufferAttribute(i,B),h.fromBufferAttribute(i,F),u.fromBufferAttribute(i,L),f.fromBufferAttribute(r,B),m.fromBufferAttribute(r,F),_.fromBufferAttribute(r,L),h.sub(d),u.sub(d),m.sub(f),_.sub(f);let G=1/(m.x*_.y-_.x*m.y);isFinite(G)&&(p.copy(h).multiplyScalar(_.y).addScaledVector(u,-m.y).multiplyScalar(G),g.copy(u).multiplyScalar(m.x).addScaledVector(h,-_.x).multiplyScalar(G),a[B].add(p),a[F].add(p),a[L].add(p),l[B].add(g),l[F].add(g),l[L].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let B=0,F=S.length;B<F;++B){let L=S[B],G=L.start,H=L.count;for(let N=G,$=G+H;N<$;N+=3)v(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let b=new O,C=new O,w=new O,x=new O;function T(B){w.fromBufferAttribute(s,B),x.copy(w);let F=a[B];b.copy(F),b.sub(w.multiplyScalar(w.dot(F))).normalize(),C.crossVectors(x,F);let G=C.dot(l[B])<0?-1:1;o.setXYZW(B,b.x,b.y,b.z,G)}for(let B=0,F=i.count;B<F;++B)c[B]&&T(B);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new os(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,f=i.count;u<f;u++)i.setXYZ(u,0,0,0);let s=new O,r=new O,o=new O,a=new O,l=new O,c=new O,d=new O,h=new O;if(t)for(let u=0,f=t.count;u<f;u+=3){let m=t.getX(u+0),_=t.getX(u+1),p=t.getX(u+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,p),d.subVectors(o,r),h.subVectors(s,r),d.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,p),a.add(d),l.add(d),c.add(d),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),d.subVectors(o,r),h.subVectors(s,r),d.cross(h),i.setXYZ(u+0,d.x,d.y,d.z),i.setXYZ(u+1,d.x,d.y,d.z),i.setXYZ(u+2,d.x,d.y,d.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Pn.fromBufferAttribute(t,e),Pn.normalize(),t.setXYZ(e,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function t(a,l){let c=a.array,d=a.itemSize,h=a.normalized,u=new c.constructor(l.length*d),f=0,m=0;for(let _=0,p=l.length;_<p;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*d;for(let g=0;g<d;g++)u[m++]=c[f++]}return new os(u,d,h)}if(this.index===null)return Kt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let d=0,h=c.length;d<h;d++){let u=c[d],f=t(u,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],d=[];for(let h=0,u=c.length;h<u;h++){let f=c[h];d.push(f.toJSON(t.data))}d.length>0&&(s[l]=d,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let d=s[c];this.setAttribute(c,d.clone(e))}let r=t.morphAttributes;for(let c in r){let d=[],h=r[c];for(let u=0,f=h.length;u<f;u++)d.push(h[u].clone(e));this.morphAttributes[c]=d}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,d=o.length;c<d;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var cd=new O,hv=new O,uv=new oe,Xn=class{constructor(t=new O(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=cd.subVectors(i,e).cross(hv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(cd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||uv.getNormalMatrix(t),s=this.coplanarPoint(cd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},dv=0,as=class extends Ui{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dv++}),this.uuid=Ar(),this.name="",this.type="Material",this.blending=Uo,this.side=rr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Nd,this.blendDst=Fd,this.blendEquation=wr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new le(0,0,0),this.blendAlpha=0,this.depthFunc=So,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=bg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=gc,this.stencilZFail=gc,this.stencilZPass=gc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Kt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new le().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Xn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Dt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Dt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ss=new O,hd=new O,Yl=new O,Zl=new O,Js=class{constructor(t=new O,e=new O(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ss)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ss.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ss.copy(this.origin).addScaledVector(this.direction,e),Ss.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){hd.copy(t).add(e).multiplyScalar(.5),Yl.copy(e).sub(t).normalize(),Zl.copy(this.origin).sub(hd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Yl),a=Zl.dot(this.direction),l=-Zl.dot(Yl),c=Zl.lengthSq(),d=Math.abs(1-o*o),h,u,f,m;if(d>0)if(h=o*l-a,u=o*a-l,m=r*d,h>=0)if(u>=-m)if(u<=m){let _=1/d;h*=_,u*=_,f=h*(h+o*u+2*a)+u*(o*h+u+2*l)+c}else u=r,h=Math.max(0,-(o*u+a)),f=-h*h+u*(u+2*l)+c;else u=-r,h=Math.max(0,-(o*u+a)),f=-h*h+u*(u+2*l)+c;else u<=-m?(h=Math.max(0,-(-o*r+a)),u=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+u*(u+2*l)+c):u<=m?(h=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(h=Math.max(0,-(o*r+a)),u=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+u*(u+2*l)+c);else u=o>0?-r:r,h=Math.max(0,-(o*u+a)),f=-h*h+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(hd).addScaledVector(Yl,u),f}intersectSphere(t,e){if(t.radius<0)return null;Ss.subVectors(t.center,this.origin);let i=Ss.dot(this.direction),s=Ss.dot(Ss)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,d=1/this.direction.y,h=1/this.direction.z,u=this.origin;return c>=0?(i=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(i=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),d>=0?(r=(t.min.y-u.y)*d,o=(t.max.y-u.y)*d):(r=(t.max.y-u.y)*d,o=(t.min.y-u.y)*d),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-u.z)*h,l=(t.max.z-u.z)*h):(a=(t.max.z-u.z)*h,l=(t.min.z-u.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Ss)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,d=a.z,h=t.x-o.x,u=t.y-o.y,f=t.z-o.z,m=e.x-o.x,_=e.y-o.y,p=e.z-o.z,g=i.x-o.x,v=i.y-o.y,S=i.z-o.z,b=Math.abs(l),C=Math.abs(c),w=Math.abs(d),x,T,B,F,L,G,H,N,$,Z,W,ut;if(b>=C&&b>=w?(B=l,G=h,$=m,ut=g,l>=0?(x=c,T=d,F=u,L=f,H=_,N=p,Z=v,W=S):(x=d,T=c,F=f,L=u,H=p,N=_,Z=S,W=v)):C>=w?(B=c,G=u,$=_,ut=v,c>=0?(x=d,T=l,F=f,L=h,H=p,N=m,Z=S,W=g):(x=l,T=d,F=h,L=f,H=m,N=p,Z=g,W=S)):(B=d,G=f,$=p,ut=S,d>=0?(x=l,T=c,F=h,L=u,H=m,N=_,Z=g,W=v):(x=c,T=l,F=u,L=h,H=_,N=m,Z=v,W=g)),B===0)return null;let D=x/B,q=T/B,K=1/B,nt=F-D*G,rt=L-q*G,tt=H-D*$,_t=N-q*$,mt=Z-D*ut,xt=W-q*ut,wt=mt*_t-xt*tt,ot=nt*xt-rt*mt,Et=tt*rt-_t*nt;if(s){if(wt<0||ot<0||Et<0)return null}else if((wt<0||ot<0||Et<0)&&(wt>0||ot>0||Et>0))return null;let vt=wt+ot+Et;if(vt===0)return null;let Ht=K*(wt*G+ot*$+Et*ut);return(vt>0?Ht<0:Ht>0)?null:this.at(Ht/vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},wi=class extends as{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new le(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Es,this.combine=eh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},wm=new Be,_r=new Js,Jl=new yr,Em=new O,Kl=new O,jl=new O,Ql=new O,ud=new O,tc=new O,Tm=new O,ec=new O,Le=class extends Nn{constructor(t=new Ke,e=new wi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){tc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let d=a[l],h=r[l];d!==0&&(ud.fromBufferAttribute(h,t),o?tc.addScaledVector(ud,d):tc.addScaledVector(ud.sub(e),d))}e.add(tc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Jl.copy(i.boundingSphere),Jl.applyMatrix4(r),_r.copy(t.ray).recast(t.near),!(Jl.containsPoint(_r.origin)===!1&&(_r.intersectSphere(Jl,Em)===null||_r.origin.distanceToSquared(Em)>(t.far-t.near)**2))&&(wm.copy(r).invert(),_r.copy(t.ray).applyMatrix4(wm),!(i.boundingBox!==null&&_r.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,_r)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,d=r.attributes.uv1,h=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=u.length;m<_;m++){let p=u[m],g=o[p.materialIndex],v=Math.max(p.start,f.start),S=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let b=v,C=S;b<C;b+=3){let w=a.getX(b),x=a.getX(b+1),T=a.getX(b+2);s=nc(this,g,t,i,c,d,h,w,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let p=m,g=_;p<g;p+=3){let v=a.getX(p),S=a.getX(p+1),b=a.getX(p+2);s=nc(this,o,t,i,c,d,h,v,S,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=u.length;m<_;m++){let p=u[m],g=o[p.materialIndex],v=Math.max(p.start,f.start),S=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let b=v,C=S;b<C;b+=3){let w=b,x=b+1,T=b+2;s=nc(this,g,t,i,c,d,h,w,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let p=m,g=_;p<g;p+=3){let v=p,S=p+1,b=p+2;s=nc(this,o,t,i,c,d,h,v,S,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function fv(n,t,e,i,s,r,o,a){let l;if(t.side===Zn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===rr,a),l===null)return null;ec.copy(a),ec.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ec);return c<e.near||c>e.far?null:{distance:c,point:ec.clone(),object:n}}function nc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Kl),n.getVertexPosition(l,jl),n.getVertexPosition(c,Ql);let d=fv(n,t,e,i,Kl,jl,Ql,Tm);if(d){let h=new O;Fi.getBarycoord(Tm,Kl,jl,Ql,h),s&&(d.uv=Fi.getInterpolatedAttribute(s,a,l,c,h,new Dt)),r&&(d.uv1=Fi.getInterpolatedAttribute(r,a,l,c,h,new Dt)),o&&(d.normal=Fi.getInterpolatedAttribute(o,a,l,c,h,new O),d.normal.dot(i.direction)>0&&d.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new O,materialIndex:0};Fi.getNormal(Kl,jl,Ql,u.normal),d.face=u,d.barycoord=h}return d}var Pc=class extends Qn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=In,d=In,h,u){super(null,o,a,l,c,d,s,r,h,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var xr=new yr,pv=new Dt(.5,.5),ic=new O,Ks=class{constructor(t=new Xn,e=new Xn,i=new Xn,s=new Xn,r=new Xn,o=new Xn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Mi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],d=r[4],h=r[5],u=r[6],f=r[7],m=r[8],_=r[9],p=r[10],g=r[11],v=r[12],S=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-d,g-m,C-v).normalize(),s[1].setComponents(c+o,f+d,g+m,C+v).normalize(),s[2].setComponents(c+a,f+h,g+_,C+S).normalize(),s[3].setComponents(c-a,f-h,g-_,C-S).normalize(),i)s[4].setComponents(l,u,p,b).normalize(),s[5].setComponents(c-l,f-u,g-p,C-b).normalize();else if(s[4].setComponents(c-l,f-u,g-p,C-b).normalize(),e===Mi)s[5].setComponents(c+l,f+u,g+p,C+b).normalize();else if(e===Mo)s[5].setComponents(l,u,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),xr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),xr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(xr)}intersectsSprite(t){xr.center.set(0,0,0);let e=pv.distanceTo(t.center);return xr.radius=.7071067811865476+e,xr.applyMatrix4(t.matrixWorld),this.intersectsSphere(xr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ic.x=s.normal.x>0?t.max.x:t.min.x,ic.y=s.normal.y>0?t.max.y:t.min.y,ic.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ic)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Am=new Be,Ic=class n{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Am.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ks),i[s].setFromProjectionMatrix(Am,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ks),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Oi=class extends as{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new le(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Lc=new O,Dc=new O,Cm=new Be,_a=new Js,sc=new yr,dd=new O,Rm=new O,Ia=class extends Nn{constructor(t=new Ke,e=new Oi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Lc.fromBufferAttribute(e,s-1),Dc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Lc.distanceTo(Dc);t.setAttribute("lineDistance",new ve(i,1))}else Kt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),sc.copy(i.boundingSphere),sc.applyMatrix4(s),sc.radius+=r,t.ray.intersectsSphere(sc)===!1)return;Cm.copy(s).invert(),_a.copy(t.ray).applyMatrix4(Cm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,d=i.index,u=i.attributes.position;if(d!==null){let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let _=f,p=m-1;_<p;_+=c){let g=d.getX(_),v=d.getX(_+1),S=rc(this,t,_a,l,g,v,_);S&&e.push(S)}if(this.isLineLoop){let _=d.getX(m-1),p=d.getX(f),g=rc(this,t,_a,l,_,p,m-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=f,p=m-1;_<p;_+=c){let g=rc(this,t,_a,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=rc(this,t,_a,l,m-1,f,m-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function rc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Lc.fromBufferAttribute(a,s),Dc.fromBufferAttribute(a,r),e.distanceSqToSegment(Lc,Dc,dd,Rm)>i)return;dd.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(dd);if(!(c<t.near||c>t.far))return{distance:c,point:Rm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Pm=new O,Im=new O,js=class extends Ia{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Pm.fromBufferAttribute(e,s),Im.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Pm.distanceTo(Im);t.setAttribute("lineDistance",new ve(i,1))}else Kt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},La=class extends Ia{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Da=class extends Qn{constructor(t=[],e=Er,i,s,r,o,a,l,c,d){super(t,e,i,s,r,o,a,l,c,d),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ts=class extends Qn{constructor(t,e,i=ki,s,r,o,a=In,l=In,c,d=ws,h=1){if(d!==ws&&d!==Rs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:h};super(u,s,r,o,a,l,d,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new To(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Na=class extends Ts{constructor(t,e=ki,i=Er,s,r,o=In,a=In,l,c=ws){let d={width:t,height:t,depth:1},h=[d,d,d,d,d,d];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Fa=class extends Qn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Qs=class n extends Ke{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],d=[],h=[],u=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ve(c,3)),this.setAttribute("normal",new ve(d,3)),this.setAttribute("uv",new ve(h,2));function m(_,p,g,v,S,b,C,w,x,T,B){let F=b/x,L=C/T,G=b/2,H=C/2,N=w/2,$=x+1,Z=T+1,W=0,ut=0,D=new O;for(let q=0;q<Z;q++){let K=q*L-H;for(let nt=0;nt<$;nt++){let rt=nt*F-G;D[_]=rt*v,D[p]=K*S,D[g]=N,c.push(D.x,D.y,D.z),D[_]=0,D[p]=0,D[g]=w>0?1:-1,d.push(D.x,D.y,D.z),h.push(nt/x),h.push(1-q/T),W+=1}}for(let q=0;q<T;q++)for(let K=0;K<x;K++){let nt=u+K+$*q,rt=u+K+$*(q+1),tt=u+(K+1)+$*(q+1),_t=u+(K+1)+$*q;l.push(nt,rt,_t),l.push(rt,tt,_t),ut+=6}a.addGroup(f,ut,B),f+=ut,u+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var vr=class n extends Ke{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let d=[],h=[],u=[],f=[],m=0,_=[],p=i/2,g=0;v(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(d),this.setAttribute("position",new ve(h,3)),this.setAttribute("normal",new ve(u,3)),this.setAttribute("uv",new ve(f,2));function v(){let b=new O,C=new O,w=0,x=(e-t)/i;for(let T=0;T<=r;T++){let B=[],F=T/r,L=F*(e-t)+t;for(let G=0;G<=s;G++){let H=G/s,N=H*l+a,$=Math.sin(N),Z=Math.cos(N);C.x=L*$,C.y=-F*i+p,C.z=L*Z,h.push(C.x,C.y,C.z),b.set($,x,Z).normalize(),u.push(b.x,b.y,b.z),f.push(H,1-F),B.push(m++)}_.push(B)}for(let T=0;T<s;T++)for(let B=0;B<r;B++){let F=_[B][T],L=_[B+1][T],G=_[B+1][T+1],H=_[B][T+1];(t>0||B!==0)&&(d.push(F,L,H),w+=3),(e>0||B!==r-1)&&(d.push(L,G,H),w+=3)}c.addGroup(g,w,0),g+=w}function S(b){let C=m,w=new Dt,x=new O,T=0,B=b===!0?t:e,F=b===!0?1:-1;for(let G=1;G<=s;G++)h.push(0,p*F,0),u.push(0,F,0),f.push(.5,.5),m++;let L=m;for(let G=0;G<=s;G++){let N=G/s*l+a,$=Math.cos(N),Z=Math.sin(N);x.x=B*Z,x.y=p*F,x.z=B*$,h.push(x.x,x.y,x.z),u.push(0,F,0),w.x=$*.5+.5,w.y=Z*.5*F+.5,f.push(w.x,w.y),m++}for(let G=0;G<s;G++){let H=C+G,N=L+G;b===!0?d.push(N,N+1,H):d.push(N+1,N,H),T+=3}c.addGroup(g,T,b===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var oc=new O,ac=new O,fd=new O,lc=new Fi,Ua=class extends Ke{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(yo*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],d=["a","b","c"],h=new Array(3),u=new Map,f=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:_,b:p,c:g}=lc;if(_.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),lc.getNormal(fd),h[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,h[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,h[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let v=0;v<3;v++){let S=(v+1)%3,b=h[v],C=h[S],w=lc[d[v]],x=lc[d[S]],T=`${b}_${C}`,B=`${C}_${b}`,F=u.get(B);F?(fd.dot(F.normal)<=r&&(f.push(w.x,w.y,w.z),f.push(x.x,x.y,x.z)),u.set(B,null)):u.has(T)||u.set(T,{index0:c[v],index1:c[S],normal:fd.clone()})}}for(let m of u.values())if(m){let{index0:_,index1:p}=m;oc.fromBufferAttribute(a,_),ac.fromBufferAttribute(a,p),f.push(oc.x,oc.y,oc.z),f.push(ac.x,ac.y,ac.z)}this.setAttribute("position",new ve(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},pi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Kt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)i=this.getPoint(o/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,o;e?o=e:o=t*i[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=i[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,i[s]===o)return s/(r-1);let d=i[s],u=i[s+1]-d,f=(o-d)/u;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Dt:new O);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new O,s=[],r=[],o=[],a=new O,l=new Be;for(let f=0;f<=t;f++){let m=f/t;s[f]=this.getTangentAt(m,new O)}r[0]=new O,o[0]=new O;let c=Number.MAX_VALUE,d=Math.abs(s[0].x),h=Math.abs(s[0].y),u=Math.abs(s[0].z);d<=c&&(c=d,i.set(1,0,0)),h<=c&&(c=h,i.set(0,1,0)),u<=c&&i.set(0,0,1),a.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(re(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,m))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(re(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let m=1;m<=t;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],f*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Ro=class extends pi{constructor(t=0,e=0,i=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Dt){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let d=Math.cos(this.aRotation),h=Math.sin(this.aRotation),u=l-this.aX,f=c-this.aY;l=u*d-f*h+this.aX,c=u*h+f*d+this.aY}return i.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Nc=class extends Ro{constructor(t,e,i,s,r,o){super(t,e,i,i,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function af(){let n=0,t=0,e=0,i=0;function s(r,o,a,l){n=r,t=a,e=-3*r+3*o-2*a-l,i=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,d,h){let u=(o-r)/c-(a-r)/(c+d)+(a-o)/d,f=(a-o)/d-(l-o)/(d+h)+(l-a)/h;u*=d,f*=d,s(o,a,u,f)},calc:function(r){let o=r*r,a=o*r;return n+t*r+e*o+i*a}}}var Lm=new O,Dm=new O,pd=new af,md=new af,gd=new af,Fc=class extends pi{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new O){let i=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,d;this.closed||a>0?c=s[(a-1)%r]:(Dm.subVectors(s[0],s[1]).add(s[0]),c=Dm);let h=s[a%r],u=s[(a+1)%r];if(this.closed||a+2<r?d=s[(a+2)%r]:(Lm.subVectors(s[r-1],s[r-2]).add(s[r-1]),d=Lm),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(h),f),_=Math.pow(h.distanceToSquared(u),f),p=Math.pow(u.distanceToSquared(d),f);_<1e-4&&(_=1),m<1e-4&&(m=_),p<1e-4&&(p=_),pd.initNonuniformCatmullRom(c.x,h.x,u.x,d.x,m,_,p),md.initNonuniformCatmullRom(c.y,h.y,u.y,d.y,m,_,p),gd.initNonuniformCatmullRom(c.z,h.z,u.z,d.z,m,_,p)}else this.curveType==="catmullrom"&&(pd.initCatmullRom(c.x,h.x,u.x,d.x,this.tension),md.initCatmullRom(c.y,h.y,u.y,d.y,this.tension),gd.initCatmullRom(c.z,h.z,u.z,d.z,this.tension));return i.set(pd.calc(l),md.calc(l),gd.calc(l)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new O().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Nm(n,t,e,i,s){let r=(i-t)*.5,o=(s-e)*.5,a=n*n,l=n*a;return(2*e-2*i+r+o)*l+(-3*e+3*i-2*r-o)*a+r*n+e}function mv(n,t){let e=1-n;return e*e*t}function gv(n,t){return 2*(1-n)*n*t}function _v(n,t){return n*n*t}function ba(n,t,e,i){return mv(n,t)+gv(n,e)+_v(n,i)}function xv(n,t){let e=1-n;return e*e*e*t}function yv(n,t){let e=1-n;return 3*e*e*n*t}function vv(n,t){return 3*(1-n)*n*n*t}function bv(n,t){return n*n*n*t}function Sa(n,t,e,i,s){return xv(n,t)+yv(n,e)+vv(n,i)+bv(n,s)}var Oa=class extends pi{constructor(t=new Dt,e=new Dt,i=new Dt,s=new Dt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new Dt){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(Sa(t,s.x,r.x,o.x,a.x),Sa(t,s.y,r.y,o.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Uc=class extends pi{constructor(t=new O,e=new O,i=new O,s=new O){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new O){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(Sa(t,s.x,r.x,o.x,a.x),Sa(t,s.y,r.y,o.y,a.y),Sa(t,s.z,r.z,o.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ba=class extends pi{constructor(t=new Dt,e=new Dt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Dt){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Dt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Oc=class extends pi{constructor(t=new O,e=new O){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new O){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new O){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ka=class extends pi{constructor(t=new Dt,e=new Dt,i=new Dt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new Dt){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(ba(t,s.x,r.x,o.x),ba(t,s.y,r.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Bc=class extends pi{constructor(t=new O,e=new O,i=new O){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new O){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(ba(t,s.x,r.x,o.x),ba(t,s.y,r.y,o.y),ba(t,s.z,r.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},za=class extends pi{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Dt){let i=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],d=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return i.set(Nm(a,l.x,c.x,d.x,h.x),Nm(a,l.y,c.y,d.y,h.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new Dt().fromArray(s))}return this}},Fm=Object.freeze({__proto__:null,ArcCurve:Nc,CatmullRomCurve3:Fc,CubicBezierCurve:Oa,CubicBezierCurve3:Uc,EllipseCurve:Ro,LineCurve:Ba,LineCurve3:Oc,QuadraticBezierCurve:ka,QuadraticBezierCurve3:Bc,SplineCurve:za}),kc=class extends pi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let i=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Fm[i](e,t))}return this}getPoint(t,e){let i=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=i){let o=s[r]-i,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let i=0,s=this.curves.length;i<s;i++)e+=this.curves[i].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],i;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let d=l[c];i&&i.equals(d)||(e.push(d),i=d)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,i=this.curves.length;e<i;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(new Fm[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},Va=class extends kc{constructor(t){super(),this.type="Path",this.currentPoint=new Dt,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,i=t.length;e<i;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let i=new Ba(this.currentPoint.clone(),new Dt(t,e));return this.curves.push(i),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,i,s){let r=new ka(this.currentPoint.clone(),new Dt(t,e),new Dt(i,s));return this.curves.push(r),this.currentPoint.set(i,s),this}bezierCurveTo(t,e,i,s,r,o){let a=new Oa(this.currentPoint.clone(),new Dt(t,e),new Dt(i,s),new Dt(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),i=new za(e);return this.curves.push(i),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,i,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,i,s,r,o),this}absarc(t,e,i,s,r,o){return this.absellipse(t,e,i,i,s,r,o),this}ellipse(t,e,i,s,r,o,a,l){let c=this.currentPoint.x,d=this.currentPoint.y;return this.absellipse(t+c,e+d,i,s,r,o,a,l),this}absellipse(t,e,i,s,r,o,a,l){let c=new Ro(t,e,i,s,r,o,a,l);if(this.curves.length>0){let h=c.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(c);let d=c.getPoint(1);return this.currentPoint.copy(d),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},Po=class extends Va{constructor(t){super(t),this.uuid=Ar(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let i=0,s=this.holes.length;i<s;i++)e[i]=this.holes[i].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,i=this.holes.length;e<i;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(new Va().fromJSON(s))}return this}};function Sv(n,t,e=2){let i=t&&t.length,s=i?t[0]*e:n.length,r=Fg(n,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(i&&(r=Av(n,t,r,e)),n.length>80*e){a=n[0],l=n[1];let d=a,h=l;for(let u=e;u<s;u+=e){let f=n[u],m=n[u+1];f<a&&(a=f),m<l&&(l=m),f>d&&(d=f),m>h&&(h=m)}c=Math.max(d-a,h-l),c=c!==0?32767/c:0}return Ga(r,o,e,a,l,c,0),o}function Fg(n,t,e,i,s){let r;if(s===Bv(n,t,e,i)>0)for(let o=t;o<e;o+=i)r=Um(o/i|0,n[o],n[o+1],r);else for(let o=e-i;o>=t;o-=i)r=Um(o/i|0,n[o],n[o+1],r);return r&&Io(r,r.next)&&(Wa(r),r=r.next),r}function br(n,t){if(!n)return n;t||(t=n);let e=n,i;do if(i=!1,!e.steiner&&(Io(e,e.next)||sn(e.prev,e,e.next)===0)){if(Wa(e),e=t=e.prev,e===e.next)break;i=!0}else e=e.next;while(i||e!==t);return t}function Ga(n,t,e,i,s,r,o){if(!n)return;!o&&r&&Lv(n,i,s,r);let a=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(r?wv(n,i,s,r):Mv(n)){t.push(l.i,n.i,c.i),Wa(n),n=c.next,a=c.next;continue}if(n=c,n===a){o?o===1?(n=Ev(br(n),t),Ga(n,t,e,i,s,r,2)):o===2&&Tv(n,t,e,i,s,r):Ga(br(n),t,e,i,s,r,1);break}}}function Mv(n){let t=n.prev,e=n,i=n.next;if(sn(t,e,i)>=0)return!1;let s=t.x,r=e.x,o=i.x,a=t.y,l=e.y,c=i.y,d=Math.min(s,r,o),h=Math.min(a,l,c),u=Math.max(s,r,o),f=Math.max(a,l,c),m=i.next;for(;m!==t;){if(m.x>=d&&m.x<=u&&m.y>=h&&m.y<=f&&xa(s,a,r,l,o,c,m.x,m.y)&&sn(m.prev,m,m.next)>=0)return!1;m=m.next}return!0}function wv(n,t,e,i){let s=n.prev,r=n,o=n.next;if(sn(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,d=s.y,h=r.y,u=o.y,f=Math.min(a,l,c),m=Math.min(d,h,u),_=Math.max(a,l,c),p=Math.max(d,h,u),g=Md(f,m,t,e,i),v=Md(_,p,t,e,i),S=n.prevZ,b=n.nextZ;for(;S&&S.z>=g&&b&&b.z<=v;){if(S.x>=f&&S.x<=_&&S.y>=m&&S.y<=p&&S!==s&&S!==o&&xa(a,d,l,h,c,u,S.x,S.y)&&sn(S.prev,S,S.next)>=0||(S=S.prevZ,b.x>=f&&b.x<=_&&b.y>=m&&b.y<=p&&b!==s&&b!==o&&xa(a,d,l,h,c,u,b.x,b.y)&&sn(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;S&&S.z>=g;){if(S.x>=f&&S.x<=_&&S.y>=m&&S.y<=p&&S!==s&&S!==o&&xa(a,d,l,h,c,u,S.x,S.y)&&sn(S.prev,S,S.next)>=0)return!1;S=S.prevZ}for(;b&&b.z<=v;){if(b.x>=f&&b.x<=_&&b.y>=m&&b.y<=p&&b!==s&&b!==o&&xa(a,d,l,h,c,u,b.x,b.y)&&sn(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function Ev(n,t){let e=n;do{let i=e.prev,s=e.next.next;!Io(i,s)&&Og(i,e,e.next,s)&&Ha(i,s)&&Ha(s,i)&&(t.push(i.i,e.i,s.i),Wa(e),Wa(e.next),e=n=s),e=e.next}while(e!==n);return br(e)}function Tv(n,t,e,i,s,r){let o=n;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Fv(o,a)){let l=Bg(o,a);o=br(o,o.next),l=br(l,l.next),Ga(o,t,e,i,s,r,0),Ga(l,t,e,i,s,r,0);return}a=a.next}o=o.next}while(o!==n)}function Av(n,t,e,i){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*i,l=r<o-1?t[r+1]*i:n.length,c=Fg(n,a,l,i,!1);c===c.next&&(c.steiner=!0),s.push(Nv(c))}s.sort(Cv);for(let r=0;r<s.length;r++)e=Rv(s[r],e);return e}function Cv(n,t){let e=n.x-t.x;if(e===0&&(e=n.y-t.y,e===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=i-s}return e}function Rv(n,t){let e=Pv(n,t);if(!e)return t;let i=Bg(e,n);return br(i,i.next),br(e,e.next)}function Pv(n,t){let e=t,i=n.x,s=n.y,r=-1/0,o;if(Io(n,e))return e;do{if(Io(n,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let h=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(h<=i&&h>r&&(r=h,o=e.x<e.next.x?e:e.next,h===i))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,d=1/0;e=o;do{if(i>=e.x&&e.x>=l&&i!==e.x&&Ug(s<c?i:r,s,l,c,s<c?r:i,s,e.x,e.y)){let h=Math.abs(s-e.y)/(i-e.x);Ha(e,n)&&(h<d||h===d&&(e.x>o.x||e.x===o.x&&Iv(o,e)))&&(o=e,d=h)}e=e.next}while(e!==a);return o}function Iv(n,t){return sn(n.prev,n,t.prev)<0&&sn(t.next,n,n.next)<0}function Lv(n,t,e,i){let s=n;do s.z===0&&(s.z=Md(s.x,s.y,t,e,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,Dv(s)}function Dv(n){let t,e=1;do{let i=n,s;n=null;let r=null;for(t=0;i;){t++;let o=i,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||i.z<=o.z)?(s=i,i=i.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;i=o}r.nextZ=null,e*=2}while(t>1);return n}function Md(n,t,e,i,s){return n=(n-e)*s|0,t=(t-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,n|t<<1}function Nv(n){let t=n,e=n;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==n);return e}function Ug(n,t,e,i,s,r,o,a){return(s-o)*(t-a)>=(n-o)*(r-a)&&(n-o)*(i-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(i-a)}function xa(n,t,e,i,s,r,o,a){return!(n===o&&t===a)&&Ug(n,t,e,i,s,r,o,a)}function Fv(n,t){return n.next.i!==t.i&&n.prev.i!==t.i&&!Uv(n,t)&&(Ha(n,t)&&Ha(t,n)&&Ov(n,t)&&(sn(n.prev,n,t.prev)||sn(n,t.prev,t))||Io(n,t)&&sn(n.prev,n,n.next)>0&&sn(t.prev,t,t.next)>0)}function sn(n,t,e){return(t.y-n.y)*(e.x-t.x)-(t.x-n.x)*(e.y-t.y)}function Io(n,t){return n.x===t.x&&n.y===t.y}function Og(n,t,e,i){let s=hc(sn(n,t,e)),r=hc(sn(n,t,i)),o=hc(sn(e,i,n)),a=hc(sn(e,i,t));return!!(s!==r&&o!==a||s===0&&cc(n,e,t)||r===0&&cc(n,i,t)||o===0&&cc(e,n,i)||a===0&&cc(e,t,i))}function cc(n,t,e){return t.x<=Math.max(n.x,e.x)&&t.x>=Math.min(n.x,e.x)&&t.y<=Math.max(n.y,e.y)&&t.y>=Math.min(n.y,e.y)}function hc(n){return n>0?1:n<0?-1:0}function Uv(n,t){let e=n;do{if(e.i!==n.i&&e.next.i!==n.i&&e.i!==t.i&&e.next.i!==t.i&&Og(e,e.next,n,t))return!0;e=e.next}while(e!==n);return!1}function Ha(n,t){return sn(n.prev,n,n.next)<0?sn(n,t,n.next)>=0&&sn(n,n.prev,t)>=0:sn(n,t,n.prev)<0||sn(n,n.next,t)<0}function Ov(n,t){let e=n,i=!1,s=(n.x+t.x)/2,r=(n.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(i=!i),e=e.next;while(e!==n);return i}function Bg(n,t){let e=wd(n.i,n.x,n.y),i=wd(t.i,t.x,t.y),s=n.next,r=t.prev;return n.next=t,t.prev=n,e.next=s,s.prev=e,i.next=e,e.prev=i,r.next=i,i.prev=r,i}function Um(n,t,e,i){let s=wd(n,t,e);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function Wa(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function wd(n,t,e){return{i:n,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Bv(n,t,e,i){let s=0;for(let r=t,o=e-i;r<e;r+=i)s+=(n[o]-n[r])*(n[r+1]+n[o+1]),o=r;return s}var Ed=class{static triangulate(t,e,i=2){return Sv(t,e,i)}},bo=class n{static area(t){let e=t.length,i=0;for(let s=e-1,r=0;r<e;s=r++)i+=t[s].x*t[r].y-t[r].x*t[s].y;return i*.5}static isClockWise(t){return n.area(t)<0}static triangulateShape(t,e){let i=[],s=[],r=[];Om(t),Bm(i,t);let o=t.length;e.forEach(Om);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,Bm(i,e[l]);let a=Ed.triangulate(i,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function Om(n){let t=n.length;t>2&&n[t-1].equals(n[0])&&n.pop()}function Bm(n,t){for(let e=0;e<t.length;e++)n.push(t[e].x),n.push(t[e].y)}var Sr=class n extends Ke{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,d=l+1,h=t/a,u=e/l,f=[],m=[],_=[],p=[];for(let g=0;g<d;g++){let v=g*u-o;for(let S=0;S<c;S++){let b=S*h-r;m.push(b,-v,0),_.push(0,0,1),p.push(S/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let S=v+c*g,b=v+c*(g+1),C=v+1+c*(g+1),w=v+1+c*g;f.push(S,b,w),f.push(b,C,w)}this.setIndex(f),this.setAttribute("position",new ve(m,3)),this.setAttribute("normal",new ve(_,3)),this.setAttribute("uv",new ve(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}},Lo=class n extends Ke{constructor(t=.5,e=1,i=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:i,phiSegments:s,thetaStart:r,thetaLength:o},i=Math.max(3,i),s=Math.max(1,s);let a=[],l=[],c=[],d=[],h=t,u=(e-t)/s,f=new O,m=new Dt;for(let _=0;_<=s;_++){for(let p=0;p<=i;p++){let g=r+p/i*o;f.x=h*Math.cos(g),f.y=h*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),m.x=(f.x/e+1)/2,m.y=(f.y/e+1)/2,d.push(m.x,m.y)}h+=u}for(let _=0;_<s;_++){let p=_*(i+1);for(let g=0;g<i;g++){let v=g+p,S=v,b=v+i+1,C=v+i+2,w=v+1;a.push(S,b,w),a.push(b,C,w)}}this.setIndex(a),this.setAttribute("position",new ve(l,3)),this.setAttribute("normal",new ve(c,3)),this.setAttribute("uv",new ve(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}},$a=class n extends Ke{constructor(t=new Po([new Dt(0,.5),new Dt(-.5,-.5),new Dt(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};let i=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(t)===!1)c(t);else for(let d=0;d<t.length;d++)c(t[d]),this.addGroup(a,l,d),a+=l,l=0;this.setIndex(i),this.setAttribute("position",new ve(s,3)),this.setAttribute("normal",new ve(r,3)),this.setAttribute("uv",new ve(o,2));function c(d){let h=s.length/3,u=d.extractPoints(e),f=u.shape,m=u.holes;bo.isClockWise(f)===!1&&(f=f.reverse());for(let p=0,g=m.length;p<g;p++){let v=m[p];bo.isClockWise(v)===!0&&(m[p]=v.reverse())}let _=bo.triangulateShape(f,m);for(let p=0,g=m.length;p<g;p++){let v=m[p];f=f.concat(v)}for(let p=0,g=f.length;p<g;p++){let v=f[p];s.push(v.x,v.y,0),r.push(0,0,1),o.push(v.x,v.y)}for(let p=0,g=_.length;p<g;p++){let v=_[p],S=v[0]+h,b=v[1]+h,C=v[2]+h;i.push(S,b,C),l+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes;return kv(e,t)}static fromJSON(t,e){let i=[];for(let s=0,r=t.shapes.length;s<r;s++){let o=e[t.shapes[s]];i.push(o)}return new n(i,t.curveSegments)}};function kv(n,t){if(t.shapes=[],Array.isArray(n))for(let e=0,i=n.length;e<i;e++){let s=n[e];t.shapes.push(s.uuid)}else t.shapes.push(n.uuid);return t}var As=class n extends Ke{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,d=[],h=new O,u=new O,f=[],m=[],_=[],p=[];for(let g=0;g<=i;g++){let v=[],S=g/i,b=o+S*a,C=t*Math.cos(b),w=Math.sqrt(t*t-C*C),x=0;g===0&&o===0?x=.5/e:g===i&&l===Math.PI&&(x=-.5/e);for(let T=0;T<=e;T++){let B=T/e,F=s+B*r;h.x=-w*Math.cos(F),h.y=C,h.z=w*Math.sin(F),m.push(h.x,h.y,h.z),u.copy(h).normalize(),_.push(u.x,u.y,u.z),p.push(B+x,1-S),v.push(c++)}d.push(v)}for(let g=0;g<i;g++)for(let v=0;v<e;v++){let S=d[g][v+1],b=d[g][v],C=d[g+1][v],w=d[g+1][v+1];(g!==0||o>0)&&f.push(S,b,w),(g!==i-1||l<Math.PI)&&f.push(b,C,w)}this.setIndex(f),this.setAttribute("position",new ve(m,3)),this.setAttribute("normal",new ve(_,3)),this.setAttribute("uv",new ve(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Xa=class extends as{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new le(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Cr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(km(s))s.isRenderTargetTexture?(Kt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(km(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function zn(n){let t={};for(let e=0;e<n.length;e++){let i=Cr(n[e]);for(let s in i)t[s]=i[s]}return t}function km(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function zv(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function lf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Me.workingColorSpace}var kg={clone:Cr,merge:zn},Vv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Gv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ls=class extends as{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Vv,this.fragmentShader=Gv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Cr(t.uniforms),this.uniformsGroups=zv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new le().setHex(s.value);break;case"v2":this.uniforms[i].value=new Dt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new O().fromArray(s.value);break;case"v4":this.uniforms[i].value=new en().fromArray(s.value);break;case"m3":this.uniforms[i].value=new oe().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Be().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},zc=class extends ls{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Bi=class extends as{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new le(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new le(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Vh,this.normalScale=new Dt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Es,this.combine=eh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Vc=class extends as{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=yg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Gc=class extends as{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function po(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function uc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var tr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Hc=class extends tr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:vd,endingEnd:vd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case bd:r=t,a=2*e-i;break;case Sd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case bd:o=t,l=2*i-e;break;case Sd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,d=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*d,this._offsetNext=o*d}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=this._offsetPrev,h=this._offsetNext,u=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),_=m*m,p=_*m,g=-u*p+2*u*_-u*m,v=(1+u)*p+(-1.5-2*u)*_+(-.5+u)*m+1,S=(-1-f)*p+(1.5+f)*_+.5*m,b=f*p-f*_;for(let C=0;C!==a;++C)r[C]=g*o[d+C]+v*o[c+C]+S*o[l+C]+b*o[h+C];return r}},Wc=class extends tr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=(i-e)/(s-e),h=1-d;for(let u=0;u!==a;++u)r[u]=o[c+u]*h+o[l+u]*d;return r}},$c=class extends tr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Xc=class extends tr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=this.inTangents,h=this.outTangents;if(!d||!h){let m=(i-e)/(s-e),_=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*_+o[l+p]*m;return r}let u=a*2,f=t-1;for(let m=0;m!==a;++m){let _=o[c+m],p=o[l+m],g=f*u+m*2,v=h[g],S=h[g+1],b=t*u+m*2,C=d[b],w=d[b+1],x=Wv(i,e,v,C,s);r[m]=zg(x,_,S,w,p)}return r}};function zg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Hv(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Wv(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=zg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Hv(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var mi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=po(e,this.TimeBufferType),this.values=po(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:po(t.times,Array),values:po(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),uc(t.settings)&&(i.settings={inTangents:po(t.settings.inTangents,Array),outTangents:po(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new $c(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Wc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Hc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Xc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ma:e=this.InterpolantFactoryMethodDiscrete;break;case Tc:e=this.InterpolantFactoryMethodLinear;break;case mc:e=this.InterpolantFactoryMethodSmooth;break;case yd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Kt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ma;case this.InterpolantFactoryMethodLinear:return Tc;case this.InterpolantFactoryMethodSmooth:return mc;case this.InterpolantFactoryMethodBezier:return yd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;uc(this.settings)&&(zm(this.settings.inTangents,t),zm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;uc(this.settings)&&(Vm(this.settings.inTangents,t),Vm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ie("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ie("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Fy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ie("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===mc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],d=t[a+1];if(c!==d&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,u=h-i,f=h+i;for(let m=0;m!==i;++m){let _=e[h+m];if(_!==e[u+m]||_!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,u=o*i;for(let f=0;f!==i;++f)e[u+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,uc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function zm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Vm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}mi.prototype.ValueTypeName="";mi.prototype.TimeBufferType=Float32Array;mi.prototype.ValueBufferType=Float32Array;mi.prototype.DefaultInterpolation=Tc;var er=class extends mi{constructor(t,e,i){super(t,e,i)}};er.prototype.ValueTypeName="bool";er.prototype.ValueBufferType=Array;er.prototype.DefaultInterpolation=Ma;er.prototype.InterpolantFactoryMethodLinear=void 0;er.prototype.InterpolantFactoryMethodSmooth=void 0;var qc=class extends mi{constructor(t,e,i,s){super(t,e,i,s)}};qc.prototype.ValueTypeName="color";var Yc=class extends mi{constructor(t,e,i,s){super(t,e,i,s)}};Yc.prototype.ValueTypeName="number";var Zc=class extends tr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let d=c+a;c!==d;c+=4)Dn.slerpFlat(r,0,o,c-a,o,c,l);return r}},qa=class extends mi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Zc(this.times,this.values,this.getValueSize(),t)}};qa.prototype.ValueTypeName="quaternion";qa.prototype.InterpolantFactoryMethodSmooth=void 0;var nr=class extends mi{constructor(t,e,i){super(t,e,i)}};nr.prototype.ValueTypeName="string";nr.prototype.ValueBufferType=Array;nr.prototype.DefaultInterpolation=Ma;nr.prototype.InterpolantFactoryMethodLinear=void 0;nr.prototype.InterpolantFactoryMethodSmooth=void 0;var Jc=class extends mi{constructor(t,e,i,s){super(t,e,i,s)}};Jc.prototype.ValueTypeName="vector";var Kc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(d){a++,r===!1&&s.onStart!==void 0&&s.onStart(d,o,a),r=!0},this.itemEnd=function(d){o++,s.onProgress!==void 0&&s.onProgress(d,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(d){s.onError!==void 0&&s.onError(d)},this.resolveURL=function(d){return d=d.normalize("NFC"),l?l(d):d},this.setURLModifier=function(d){return l=d,this},this.addHandler=function(d,h){return c.push(d,h),this},this.removeHandler=function(d){let h=c.indexOf(d);return h!==-1&&c.splice(h,2),this},this.getHandler=function(d){for(let h=0,u=c.length;h<u;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(d))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Vg=new Kc,jc=class{constructor(t){this.manager=t!==void 0?t:Vg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};jc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ya=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new le(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Za=class extends Ya{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new le(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},_d=new Be,Gm=new O,Hm=new O,Qc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Dt(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new Be,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ks,this._frameExtents=new Dt(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Gm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Gm),Hm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Hm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){_d.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(_d,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Mo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(_d)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},dc=new O,fc=new Dn,ss=new O,Ja=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Be,this.projectionMatrix=new Be,this.projectionMatrixInverse=new Be,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(dc,fc,ss),ss.x===1&&ss.y===1&&ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(dc,fc,ss.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(dc,fc,ss),ss.x===1&&ss.y===1&&ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(dc,fc,ss.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ys=new O,Wm=new Dt,$m=new Dt,qn=class extends Ja{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Eo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(yo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Eo*2*Math.atan(Math.tan(yo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ys.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ys.x,Ys.y).multiplyScalar(-t/Ys.z),Ys.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ys.x,Ys.y).multiplyScalar(-t/Ys.z)}getViewSize(t,e){return this.getViewBounds(t,Wm,$m),e.subVectors($m,Wm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(yo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ka=class extends Ja{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,d=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=d*this.view.offsetY,l=a-d*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Td=class extends Qc{constructor(){super(new Ka(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ja=class extends Ya{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Td}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var mo=-90,go=1,Do=class extends Nn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new qn(mo,go,t,e);s.layers=this.layers,this.add(s);let r=new qn(mo,go,t,e);r.layers=this.layers,this.add(r);let o=new qn(mo,go,t,e);o.layers=this.layers,this.add(o);let a=new qn(mo,go,t,e);a.layers=this.layers,this.add(a);let l=new qn(mo,go,t,e);l.layers=this.layers,this.add(l);let c=new qn(mo,go,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Mi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Mo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,d]=this.children,h=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,d),t.setRenderTarget(h,u,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},th=class extends qn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var cf="\\[\\]\\.:\\/",$v=new RegExp("["+cf+"]","g"),hf="[^"+cf+"]",Xv="[^"+cf.replace("\\.","")+"]",qv=/((?:WC+[\/:])*)/.source.replace("WC",hf),Yv=/(WCOD+)?/.source.replace("WCOD",Xv),Zv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",hf),Jv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",hf),Kv=new RegExp("^"+qv+Yv+Zv+Jv+"$"),jv=["material","materials","bones","map"],Ad=class{constructor(t,e,i){let s=i||Je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Je=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace($v,"")}static parseTrackName(t){let e=Kv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);jv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Kt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let d=0;d<t.length;d++)if(t[d].name===c){c=d;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Je.Composite=Ad;Je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Je.prototype.GetterByBindingType=[Je.prototype._getValue_direct,Je.prototype._getValue_array,Je.prototype._getValue_arrayElement,Je.prototype._getValue_toArray];Je.prototype.SetterByBindingTypeAndVersioning=[[Je.prototype._setValue_direct,Je.prototype._setValue_direct_setNeedsUpdate,Je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_array,Je.prototype._setValue_array_setNeedsUpdate,Je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_arrayElement,Je.prototype._setValue_arrayElement_setNeedsUpdate,Je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_fromArray,Je.prototype._setValue_fromArray_setNeedsUpdate,Je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var DC=new Float32Array(1);var Xm=new Be,Qa=class{constructor(t,e,i=0,s=1/0){this.ray=new Js(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Ao,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ie("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Xm.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Xm),this}intersectObject(t,e=!0,i=[]){return Cd(t,this,i,e),i.sort(qm),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Cd(t[s],this,i,e);return i.sort(qm),i}};function qm(n,t){return n.distance-t.distance}function Cd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Cd(r[o],t,e,!0)}}var No=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=re(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(re(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Rd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ym=new O,pc=new O,_o=new O,xo=new O,xd=new O,Qv=new O,tb=new O,tl=class{constructor(t=new O,e=new O){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Ym.subVectors(t,this.start),pc.subVectors(this.end,this.start);let i=pc.dot(pc);if(i===0)return 0;let r=pc.dot(Ym)/i;return e&&(r=re(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=Qv,i=tb){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,d=t.end;_o.subVectors(c,a),xo.subVectors(d,l),xd.subVectors(a,l);let h=_o.dot(_o),u=xo.dot(xo),f=xo.dot(xd);if(h<=s&&u<=s)return e.copy(a),i.copy(l),e.distanceToSquared(i);if(h<=s)r=0,o=f/u,o=re(o,0,1);else{let m=_o.dot(xd);if(u<=s)o=0,r=re(-m/h,0,1);else{let _=_o.dot(xo),p=h*u-_*_;p!==0?r=re((_*f-m*u)/p,0,1):r=0,o=(_*r+f)/u,o<0?(o=0,r=re(-m/h,0,1)):o>1&&(o=1,r=re((_-m)/h,0,1))}}return e.copy(a).addScaledVector(_o,r),i.copy(l).addScaledVector(xo,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var el=class extends js{constructor(t=10,e=10,i=4473924,s=8947848){i=new le(i),s=new le(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let u=0,f=0,m=-a;u<=e;u++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let _=u===r?i:s;_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3}let d=new Ke;d.setAttribute("position",new ve(l,3)),d.setAttribute("color",new ve(c,3));let h=new Oi({vertexColors:!0,toneMapped:!1});super(d,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var nl=class extends Ui{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function uf(n,t,e,i){let s=eb(i);switch(e){case Yd:return n*t;case Jd:return n*t/s.components*s.byteLength;case lh:return n*t/s.components*s.byteLength;case or:return n*t*2/s.components*s.byteLength;case ch:return n*t*2/s.components*s.byteLength;case Zd:return n*t*3/s.components*s.byteLength;case Gi:return n*t*4/s.components*s.byteLength;case hh:return n*t*4/s.components*s.byteLength;case rl:case ol:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case al:case ll:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case dh:case ph:return Math.max(n,16)*Math.max(t,8)/4;case uh:case fh:return Math.max(n,8)*Math.max(t,8)/2;case mh:case gh:case xh:case yh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case _h:case cl:case vh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case bh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Sh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case wh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Eh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Th:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ah:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Ch:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Rh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Ih:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Lh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Dh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Nh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Fh:case Uh:case Oh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Bh:case kh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case hl:case zh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function eb(n){switch(n){case ti:case Wd:return{byteLength:1,components:1};case Bo:case $d:case Vi:return{byteLength:2,components:1};case oh:case ah:return{byteLength:2,components:4};case ki:case rh:case zi:return{byteLength:4,components:1};case Xd:case qd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Kt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function c0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function ib(n){let t=new WeakMap;function e(a,l){let c=a.array,d=a.usage,h=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,d),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let d=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,d);else{h.sort((f,m)=>f.start-m.start);let u=0;for(let f=1;f<h.length;f++){let m=h[u],_=h[f];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++u,h[u]=_)}h.length=u+1;for(let f=0,m=h.length;f<m;f++){let _=h[f];n.bufferSubData(c,_.start*d.BYTES_PER_ELEMENT,d,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let d=t.get(a);(!d||d.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rb=`#ifdef USE_ALPHAHASH
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
#endif`,ob=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ab=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,hb=`#ifdef USE_AOMAP
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
#endif`,ub=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,db=`#ifdef USE_BATCHING
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
#endif`,fb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gb=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,_b=`#ifdef USE_IRIDESCENCE
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
#endif`,xb=`#ifdef USE_BUMPMAP
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
#endif`,yb=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,vb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,bb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Sb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Mb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,wb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Eb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Tb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Ab=`#define PI 3.141592653589793
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
} // validated`,Cb=`vec3 transformedNormal = objectNormal;
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
#endif`,Rb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Pb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Ib=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Lb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Db="gl_FragColor = linearToOutputTexel( gl_FragColor );",Nb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Fb=`#ifdef USE_ENVMAP
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
#endif`,Ub=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ob=`#ifdef USE_ENVMAP
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
#endif`,Bb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,kb=`#ifdef USE_ENVMAP
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
#endif`,zb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Vb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Gb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Hb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Wb=`#ifdef USE_GRADIENTMAP
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
}`,$b=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Xb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Yb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Zb=`#ifdef USE_ENVMAP
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
#endif`,Jb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Kb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,jb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Qb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,tS=`PhysicalMaterial material;
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
#endif`,eS=`uniform sampler2D dfgLUT;
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
}`,nS=`
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
#endif`,iS=`#if defined( RE_IndirectDiffuse )
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
#endif`,sS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,rS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,oS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,aS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,hS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,uS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,dS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,fS=`#if defined( USE_POINTS_UV )
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
#endif`,pS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,gS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,_S=`#if defined( USE_MORPHCOLORS )
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
#endif`,xS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yS=`#ifdef USE_MORPHTARGETS
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
#endif`,vS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,SS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,MS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ES=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,TS=`#ifdef USE_NORMALMAP
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
#endif`,AS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,CS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,RS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,PS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,IS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,LS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,DS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,NS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,FS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,US=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,OS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,BS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,kS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,zS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,VS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,GS=`float getShadowMask() {
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
}`,HS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,WS=`#ifdef USE_SKINNING
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
#endif`,$S=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,XS=`#ifdef USE_SKINNING
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
#endif`,qS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,YS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ZS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,JS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,KS=`#ifdef USE_TRANSMISSION
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
#endif`,jS=`#ifdef USE_TRANSMISSION
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
#endif`,QS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,tM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,eM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,nM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,iM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sM=`uniform sampler2D t2D;
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
}`,rM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oM=`uniform float backgroundBlurriness;
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
}`,aM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cM=`#include <common>
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
}`,hM=`#if DEPTH_PACKING == 3200
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
}`,uM=`#define DISTANCE
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
}`,dM=`#define DISTANCE
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
}`,fM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mM=`uniform float scale;
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
}`,gM=`uniform vec3 diffuse;
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
}`,_M=`#include <common>
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
}`,xM=`uniform vec3 diffuse;
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
}`,yM=`#define LAMBERT
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
}`,vM=`#define LAMBERT
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
}`,bM=`#define MATCAP
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
}`,SM=`#define MATCAP
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
}`,MM=`#define NORMAL
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
}`,wM=`#define NORMAL
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
}`,EM=`#define PHONG
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
}`,TM=`#define PHONG
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
}`,AM=`#define STANDARD
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
}`,CM=`#define STANDARD
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
}`,RM=`#define TOON
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
}`,PM=`#define TOON
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
}`,IM=`uniform float size;
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
}`,LM=`uniform vec3 diffuse;
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
}`,DM=`#include <common>
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
}`,NM=`uniform vec3 color;
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
}`,FM=`uniform float rotation;
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
}`,UM=`uniform vec3 diffuse;
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
}`,me={alphahash_fragment:sb,alphahash_pars_fragment:rb,alphamap_fragment:ob,alphamap_pars_fragment:ab,alphatest_fragment:lb,alphatest_pars_fragment:cb,aomap_fragment:hb,aomap_pars_fragment:ub,batching_pars_vertex:db,batching_vertex:fb,begin_vertex:pb,beginnormal_vertex:mb,bsdfs:gb,iridescence_fragment:_b,bumpmap_pars_fragment:xb,clipping_planes_fragment:yb,clipping_planes_pars_fragment:vb,clipping_planes_pars_vertex:bb,clipping_planes_vertex:Sb,color_fragment:Mb,color_pars_fragment:wb,color_pars_vertex:Eb,color_vertex:Tb,common:Ab,defaultnormal_vertex:Cb,displacementmap_pars_vertex:Rb,displacementmap_vertex:Pb,emissivemap_fragment:Ib,emissivemap_pars_fragment:Lb,colorspace_fragment:Db,colorspace_pars_fragment:Nb,envmap_fragment:Fb,envmap_common_pars_fragment:Ub,envmap_pars_fragment:Ob,envmap_pars_vertex:Bb,envmap_physical_pars_fragment:Zb,envmap_vertex:kb,fog_vertex:zb,fog_pars_vertex:Vb,fog_fragment:Gb,fog_pars_fragment:Hb,gradientmap_pars_fragment:Wb,lightmap_pars_fragment:$b,lights_lambert_fragment:Xb,lights_lambert_pars_fragment:qb,lights_pars_begin:Yb,lights_toon_fragment:Jb,lights_toon_pars_fragment:Kb,lights_phong_fragment:jb,lights_phong_pars_fragment:Qb,lights_physical_fragment:tS,lights_physical_pars_fragment:eS,lights_fragment_begin:nS,lights_fragment_maps:iS,lights_fragment_end:sS,lightprobes_pars_fragment:rS,logdepthbuf_fragment:oS,logdepthbuf_pars_fragment:aS,logdepthbuf_pars_vertex:lS,logdepthbuf_vertex:cS,map_fragment:hS,map_pars_fragment:uS,map_particle_fragment:dS,map_particle_pars_fragment:fS,metalnessmap_fragment:pS,metalnessmap_pars_fragment:mS,morphinstance_vertex:gS,morphcolor_vertex:_S,morphnormal_vertex:xS,morphtarget_pars_vertex:yS,morphtarget_vertex:vS,normal_fragment_begin:bS,normal_fragment_maps:SS,normal_pars_fragment:MS,normal_pars_vertex:wS,normal_vertex:ES,normalmap_pars_fragment:TS,clearcoat_normal_fragment_begin:AS,clearcoat_normal_fragment_maps:CS,clearcoat_pars_fragment:RS,iridescence_pars_fragment:PS,opaque_fragment:IS,packing:LS,premultiplied_alpha_fragment:DS,project_vertex:NS,dithering_fragment:FS,dithering_pars_fragment:US,roughnessmap_fragment:OS,roughnessmap_pars_fragment:BS,shadowmap_pars_fragment:kS,shadowmap_pars_vertex:zS,shadowmap_vertex:VS,shadowmask_pars_fragment:GS,skinbase_vertex:HS,skinning_pars_vertex:WS,skinning_vertex:$S,skinnormal_vertex:XS,specularmap_fragment:qS,specularmap_pars_fragment:YS,tonemapping_fragment:ZS,tonemapping_pars_fragment:JS,transmission_fragment:KS,transmission_pars_fragment:jS,uv_pars_fragment:QS,uv_pars_vertex:tM,uv_vertex:eM,worldpos_vertex:nM,background_vert:iM,background_frag:sM,backgroundCube_vert:rM,backgroundCube_frag:oM,cube_vert:aM,cube_frag:lM,depth_vert:cM,depth_frag:hM,distance_vert:uM,distance_frag:dM,equirect_vert:fM,equirect_frag:pM,linedashed_vert:mM,linedashed_frag:gM,meshbasic_vert:_M,meshbasic_frag:xM,meshlambert_vert:yM,meshlambert_frag:vM,meshmatcap_vert:bM,meshmatcap_frag:SM,meshnormal_vert:MM,meshnormal_frag:wM,meshphong_vert:EM,meshphong_frag:TM,meshphysical_vert:AM,meshphysical_frag:CM,meshtoon_vert:RM,meshtoon_frag:PM,points_vert:IM,points_frag:LM,shadow_vert:DM,shadow_frag:NM,sprite_vert:FM,sprite_frag:UM},Ut={common:{diffuse:{value:new le(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new Dt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new le(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new le(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new le(16777215)},opacity:{value:1},center:{value:new Dt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},us={basic:{uniforms:zn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:zn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new le(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:zn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new le(0)},specular:{value:new le(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:zn([Ut.common,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.roughnessmap,Ut.metalnessmap,Ut.fog,Ut.lights,{emissive:{value:new le(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:zn([Ut.common,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.gradientmap,Ut.fog,Ut.lights,{emissive:{value:new le(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:zn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:zn([Ut.points,Ut.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:zn([Ut.common,Ut.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:zn([Ut.common,Ut.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:zn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:zn([Ut.sprite,Ut.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:zn([Ut.common,Ut.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:zn([Ut.lights,Ut.fog,{color:{value:new le(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};us.physical={uniforms:zn([us.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new Dt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new le(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new Dt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{value:0},attenuationColor:{value:new le(0)},specularColor:{value:new le(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new Dt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var Gh={r:0,b:0,g:0},OM=new Be,h0=new oe;h0.set(-1,0,0,0,1,0,0,0,1);function BM(n,t,e,i,s,r){let o=new le(0),a=s===!0?0:1,l,c,d=null,h=0,u=null;function f(v){let S=v.isScene===!0?v.background:null;if(S&&S.isTexture){let b=v.backgroundBlurriness>0;S=t.get(S,b)}return S}function m(v){let S=!1,b=f(v);b===null?p(o,a):b&&b.isColor&&(p(b,1),S=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(v,S){let b=f(S);b&&b.isCubeTexture?(c===void 0&&(c=new Le(new Qs(1,1,1),new ls({name:"BackgroundCubeMaterial",uniforms:Cr(us.backgroundCube.uniforms),vertexShader:us.backgroundCube.vertexShader,fragmentShader:us.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,w,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(OM.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(h0),c.material.toneMapped=Me.getTransfer(b.colorSpace)!==Ie,(d!==b||h!==b.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,d=b,h=b.version,u=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Le(new Sr(2,2),new ls({name:"BackgroundMaterial",uniforms:Cr(us.background.uniforms),vertexShader:us.background.vertexShader,fragmentShader:us.background.fragmentShader,side:rr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=Me.getTransfer(b.colorSpace)!==Ie,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(d!==b||h!==b.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,d=b,h=b.version,u=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,S){v.getRGB(Gh,lf(n)),e.buffers.color.setClear(Gh.r,Gh.g,Gh.b,S,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,S=1){o.set(v),a=S,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:m,addToRenderList:_,dispose:g}}function kM(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(L,G,H,N,$){let Z=!1,W=h(L,N,H,G);r!==W&&(r=W,c(r.object)),Z=f(L,N,H,$),Z&&m(L,N,H,$),$!==null&&t.update($,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,b(L,G,H,N),$!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get($).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function d(L){return n.deleteVertexArray(L)}function h(L,G,H,N){let $=N.wireframe===!0,Z=i[G.id];Z===void 0&&(Z={},i[G.id]=Z);let W=L.isInstancedMesh===!0?L.id:0,ut=Z[W];ut===void 0&&(ut={},Z[W]=ut);let D=ut[H.id];D===void 0&&(D={},ut[H.id]=D);let q=D[$];return q===void 0&&(q=u(l()),D[$]=q),q}function u(L){let G=[],H=[],N=[];for(let $=0;$<e;$++)G[$]=0,H[$]=0,N[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:H,attributeDivisors:N,object:L,attributes:{},index:null}}function f(L,G,H,N){let $=r.attributes,Z=G.attributes,W=0,ut=H.getAttributes();for(let D in ut)if(ut[D].location>=0){let K=$[D],nt=Z[D];if(nt===void 0&&(D==="instanceMatrix"&&L.instanceMatrix&&(nt=L.instanceMatrix),D==="instanceColor"&&L.instanceColor&&(nt=L.instanceColor)),K===void 0||K.attribute!==nt||nt&&K.data!==nt.data)return!0;W++}return r.attributesNum!==W||r.index!==N}function m(L,G,H,N){let $={},Z=G.attributes,W=0,ut=H.getAttributes();for(let D in ut)if(ut[D].location>=0){let K=Z[D];K===void 0&&(D==="instanceMatrix"&&L.instanceMatrix&&(K=L.instanceMatrix),D==="instanceColor"&&L.instanceColor&&(K=L.instanceColor));let nt={};nt.attribute=K,K&&K.data&&(nt.data=K.data),$[D]=nt,W++}r.attributes=$,r.attributesNum=W,r.index=N}function _(){let L=r.newAttributes;for(let G=0,H=L.length;G<H;G++)L[G]=0}function p(L){g(L,0)}function g(L,G){let H=r.newAttributes,N=r.enabledAttributes,$=r.attributeDivisors;H[L]=1,N[L]===0&&(n.enableVertexAttribArray(L),N[L]=1),$[L]!==G&&(n.vertexAttribDivisor(L,G),$[L]=G)}function v(){let L=r.newAttributes,G=r.enabledAttributes;for(let H=0,N=G.length;H<N;H++)G[H]!==L[H]&&(n.disableVertexAttribArray(H),G[H]=0)}function S(L,G,H,N,$,Z,W){W===!0?n.vertexAttribIPointer(L,G,H,$,Z):n.vertexAttribPointer(L,G,H,N,$,Z)}function b(L,G,H,N){_();let $=N.attributes,Z=H.getAttributes(),W=G.defaultAttributeValues;for(let ut in Z){let D=Z[ut];if(D.location>=0){let q=$[ut];if(q===void 0&&(ut==="instanceMatrix"&&L.instanceMatrix&&(q=L.instanceMatrix),ut==="instanceColor"&&L.instanceColor&&(q=L.instanceColor)),q!==void 0){let K=q.normalized,nt=q.itemSize,rt=t.get(q);if(rt===void 0)continue;let tt=rt.buffer,_t=rt.type,mt=rt.bytesPerElement,xt=_t===n.INT||_t===n.UNSIGNED_INT||q.gpuType===rh;if(q.isInterleavedBufferAttribute){let wt=q.data,ot=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,Et=q.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let vt=0;vt<D.locationSize;vt++)g(D.location+vt,wt.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let vt=0;vt<D.locationSize;vt++)p(D.location+vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let vt=0;vt<D.locationSize;vt++)S(D.location+vt,nt/D.locationSize,_t,K,ot*mt,(Et+nt/D.locationSize*vt)*mt,xt)}else{if(q.isInstancedBufferAttribute){for(let wt=0;wt<D.locationSize;wt++)g(D.location+wt,q.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=q.meshPerAttribute*q.count)}else for(let wt=0;wt<D.locationSize;wt++)p(D.location+wt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let wt=0;wt<D.locationSize;wt++)S(D.location+wt,nt/D.locationSize,_t,K,nt*mt,nt/D.locationSize*wt*mt,xt)}}else if(W!==void 0){let K=W[ut];if(K!==void 0)switch(K.length){case 2:n.vertexAttrib2fv(D.location,K);break;case 3:n.vertexAttrib3fv(D.location,K);break;case 4:n.vertexAttrib4fv(D.location,K);break;default:n.vertexAttrib1fv(D.location,K)}}}}v()}function C(){B();for(let L in i){let G=i[L];for(let H in G){let N=G[H];for(let $ in N){let Z=N[$];for(let W in Z)d(Z[W].object),delete Z[W];delete N[$]}}delete i[L]}}function w(L){if(i[L.id]===void 0)return;let G=i[L.id];for(let H in G){let N=G[H];for(let $ in N){let Z=N[$];for(let W in Z)d(Z[W].object),delete Z[W];delete N[$]}}delete i[L.id]}function x(L){for(let G in i){let H=i[G];for(let N in H){let $=H[N];if($[L.id]===void 0)continue;let Z=$[L.id];for(let W in Z)d(Z[W].object),delete Z[W];delete $[L.id]}}}function T(L){for(let G in i){let H=i[G],N=L.isInstancedMesh===!0?L.id:0,$=H[N];if($!==void 0){for(let Z in $){let W=$[Z];for(let ut in W)d(W[ut].object),delete W[ut];delete $[Z]}delete H[N],Object.keys(H).length===0&&delete i[G]}}}function B(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:F,dispose:C,releaseStatesOfGeometry:w,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:p,disableUnusedAttributes:v}}function zM(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,d){d!==0&&(n.drawArraysInstanced(i,l,c,d),e.update(c,i,d))}function a(l,c,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,d);let u=0;for(let f=0;f<d;f++)u+=c[f];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function VM(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Gi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===Vi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==ti&&x!==zi&&!T&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",d=l(c);d!==c&&(Kt("WebGLRenderer:",c,"not supported, using",d,"instead."),c=d);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Kt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Kt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:v,maxVaryings:S,maxFragmentUniforms:b,maxSamples:C,samples:w}}function GM(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Xn,a=new oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,u){let f=h.length!==0||u||i!==0||s;return s=u,i=h.length,f},this.beginShadows=function(){r=!0,d(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,u){e=d(h,u,0)},this.setState=function(h,u,f){let m=h.clippingPlanes,_=h.clipIntersection,p=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!p)r?d(null):c();else{let v=r?0:i,S=v*4,b=g.clippingState||null;l.value=b,b=d(m,u,S,f);for(let C=0;C!==S;++C)b[C]=e[C];g.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function d(h,u,f,m){let _=h!==null?h.length:0,p=null;if(_!==0){if(p=l.value,m!==!0||p===null){let g=f+_*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<g)&&(p=new Float32Array(g));for(let S=0,b=f;S!==_;++S,b+=4)o.copy(h[S]).applyMatrix4(v,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,p}}var fl=class extends fi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Da(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Qs(5,5,5),r=new ls({name:"CubemapFromEquirect",uniforms:Cr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Zn,blending:Mr});r.uniforms.tEquirect.value=e;let o=new Le(s,r),a=e.minFilter;return e.minFilter===Cs&&(e.minFilter=Yn),new Do(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Gg=256,HM=3,WM=20,u0=256,d0=16,$M=3,XM=new O,qM=new le,Wh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Do(1,10,null),this._boxMesh=new Le(new Qs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=XM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),d=this._getSourceTarget(!0);e>0&&(d.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(qM));let p=new Do(i,s,d);return p.position.copy(a),p.update(l,t),l.autoClear=h,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=m,t.background=_,e>0&&(d.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=$g(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Wg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Gg,sf(t))}_fromTexture(t,e){t.mapping===Er||t.mapping===Oo?this._setSize(t.image.length===0?Gg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Hg(t,!1,!1),i=Math.log2(t)-HM;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Hg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Er||t.mapping===Oo?(this._cubemapMaterial===null&&(this._cubemapMaterial=$g()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Wg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=YM(),this._integrationMaterial=ZM());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/d0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-$M)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(u0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=JM());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Hg(n,t,e){return new fl(n,{minFilter:Cs,generateMipmaps:t,type:Vi,colorSpace:wa,depthBuffer:e})}function pl(n,t,e){return new ls({name:n,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:Zn,blending:Mr,depthTest:!1,depthWrite:!1})}function YM(){return pl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${u0}u

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
	`)}function ZM(){return pl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:d0}},`

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
	`)}function JM(){return pl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${WM}
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
	`)}function Wg(){return pl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function $g(){return pl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function KM(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===nh||f===ih)if(t.has(u)){let m=t.get(u).texture;return a(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let _=new fl(m.height);return _.fromEquirectangularTexture(n,u),t.set(u,_),u.addEventListener("dispose",c),a(_.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,m=f===nh||f===ih,_=f===Er||f===Oo;if(m||_){let p=e.get(u),g=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return i===null&&(i=new Wh(n)),p=m?i.fromEquirectangular(u,p):i.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),p.texture;if(p!==void 0)return p.texture;{let v=u.image;return m&&v&&v.height>0||_&&v&&l(v)?(i===null&&(i=new Wh(n)),p=m?i.fromEquirectangular(u):i.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),u.addEventListener("dispose",d),p.texture):null}}}return u}function a(u,f){return f===nh?u.mapping=Er:f===ih&&(u.mapping=Oo),u}function l(u){let f=0,m=6;for(let _=0;_<m;_++)u[_]!==void 0&&f++;return f===m}function c(u){let f=u.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function d(u){let f=u.target;f.removeEventListener("dispose",d);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function jM(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ya("WebGLRenderer: "+i+" extension not supported."),s}}}function QM(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(t.remove(_),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function d(m){let _=m.attributes;for(let p in _)t.update(_[p],n.ARRAY_BUFFER)}function h(m){let _=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let v=_!==null?_.array.length:p.array.length/3-1,S=p.count>=65535?Pa:Ra,b=new S(Math.ceil(v/3)*6,1),C=b.array;if(_!==null){let x=_.array;g=_.version;for(let T=0,B=0;T<v;T+=3){let F=x[T+0],L=x[T+1],G=x[T+2];C[B++]=F,C[B++]=L,C[B++]=L,C[B++]=G,C[B++]=G,C[B++]=F}}else{g=p.version;for(let x=0,T=0;x<v;x+=3){let B=x+0,F=x+1,L=x+2;C[T++]=B,C[T++]=F,C[T++]=F,C[T++]=L,C[T++]=L,C[T++]=B}}b.version=g;let w=r.get(m);w&&t.remove(w),r.set(m,b)}function u(m){let _=r.get(m);if(_){let p=m.index;p!==null&&_.version<p.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:d,getWireframeAttribute:u,dispose:f}}function tw(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,u){n.drawElements(i,u,r,h*o),e.update(u,i,1)}function c(h,u,f){f!==0&&(n.drawElementsInstanced(i,u,r,h*o,f),e.update(u,i,f))}function d(h,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,h,0,f);let _=0;for(let p=0;p<f;p++)_+=u[p];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=d}function ew(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function nw(n,t,e){let i=new WeakMap,s=new en;function r(o,a,l){let c=o.morphTargetInfluences,d=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=d!==void 0?d.length:0,u=i.get(a);if(u===void 0||u.count!==h){let B=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",B)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],S=0;f===!0&&(S=1),m===!0&&(S=2),_===!0&&(S=3);let b=a.attributes.position.count*S,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let w=new Float32Array(b*C*4*h),x=new Aa(w,b,C,h);x.type=zi,x.needsUpdate=!0;let T=S*4;for(let F=0;F<h;F++){let L=p[F],G=g[F],H=v[F],N=b*C*4*F;for(let $=0;$<L.count;$++){let Z=$*T;f===!0&&(s.fromBufferAttribute(L,$),w[N+Z+0]=s.x,w[N+Z+1]=s.y,w[N+Z+2]=s.z,w[N+Z+3]=0),m===!0&&(s.fromBufferAttribute(G,$),w[N+Z+4]=s.x,w[N+Z+5]=s.y,w[N+Z+6]=s.z,w[N+Z+7]=0),_===!0&&(s.fromBufferAttribute(H,$),w[N+Z+8]=s.x,w[N+Z+9]=s.y,w[N+Z+10]=s.z,w[N+Z+11]=H.itemSize===4?s.w:1)}}u={count:h,texture:x,size:new Dt(b,C)},i.set(a,u),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function iw(n,t,e,i,s){let r=new WeakMap;function o(c){let d=s.render.frame,h=c.geometry,u=t.get(c,h);if(r.get(u)!==d&&(t.update(u),r.set(u,d)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==d&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,d))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==d&&(f.update(),r.set(f,d))}return u}function a(){r=new WeakMap}function l(c){let d=c.target;d.removeEventListener("dispose",l),i.releaseStatesOfObject(d),e.remove(d.instanceMatrix),d.instanceColor!==null&&e.remove(d.instanceColor)}return{update:o,dispose:a}}var sw={[Ud]:"LINEAR_TONE_MAPPING",[Od]:"REINHARD_TONE_MAPPING",[Bd]:"CINEON_TONE_MAPPING",[kd]:"ACES_FILMIC_TONE_MAPPING",[Vd]:"AGX_TONE_MAPPING",[Gd]:"NEUTRAL_TONE_MAPPING",[zd]:"CUSTOM_TONE_MAPPING"};function rw(n,t,e,i,s,r){let o=new fi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,d=new Ke;d.setAttribute("position",new ve([-1,3,0,-1,-1,0,3,-1,0],3)),d.setAttribute("uv",new ve([0,2,0,0,2,0],2));let h=new zc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Le(d,h),f=new Ka(-1,1,1,-1,0,1),m=null,_=null,p=!1,g,v=null,S=[],b=!1;this.setSize=function(C,w){o.setSize(C,w),a!==null&&a.setSize(C,w),l!==null&&l.setSize(C,w);for(let x=0;x<S.length;x++){let T=S[x];T.setSize&&T.setSize(C,w)}},this.setEffects=function(C){S=C,b=S.length>0&&S[0].isRenderPass===!0;let w=o.width,x=o.height;S.length>0&&a===null&&(a=new fi(w,x,{type:Vi,depthBuffer:!1,stencilBuffer:!1}),l=new fi(w,x,{type:Vi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&S.some(B=>B.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ts(w,x),r===!0&&(c.format=Rs,c.type=Tr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let B=0;B<S.length;B++){let F=S[B];F.setSize&&F.setSize(w,x),T&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(C,w){if(p||C.toneMapping===cs&&S.length===0)return!1;if(v=w,w!==null){let x=w.width,T=w.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return b===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=cs,!0},this.hasRenderPass=function(){return b},this.end=function(C,w){C.toneMapping=g,p=!0;let x=o,T=a;for(let B=0;B<S.length;B++){let F=S[B];F.enabled!==!1&&(F.render(C,T,x,w),F.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(m!==C.outputColorSpace||_!==C.toneMapping){m=C.outputColorSpace,_=C.toneMapping,h.defines={},Me.getTransfer(m)===Ie&&(h.defines.SRGB_TRANSFER="");let B=sw[_];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(u,f),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),d.dispose(),h.dispose()}}var f0=new Qn,p0=new Ts(1,1),m0=new Na(1),g0=new Aa,_0=new Rc,x0=new Da,Xg=[],qg=[],Yg=new Float32Array(16),Zg=new Float32Array(9),Jg=new Float32Array(4);function zo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Xg[s];if(r===void 0&&(r=new Float32Array(s),Xg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function bn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Sn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Xh(n,t){let e=qg[t];e===void 0&&(e=new Int32Array(t),qg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function ow(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function aw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2fv(this.addr,t),Sn(e,t)}}function lw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(bn(e,t))return;n.uniform3fv(this.addr,t),Sn(e,t)}}function cw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4fv(this.addr,t),Sn(e,t)}}function hw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,i))return;Jg.set(i),n.uniformMatrix2fv(this.addr,!1,Jg),Sn(e,i)}}function uw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,i))return;Zg.set(i),n.uniformMatrix3fv(this.addr,!1,Zg),Sn(e,i)}}function dw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,i))return;Yg.set(i),n.uniformMatrix4fv(this.addr,!1,Yg),Sn(e,i)}}function fw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function pw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2iv(this.addr,t),Sn(e,t)}}function mw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;n.uniform3iv(this.addr,t),Sn(e,t)}}function gw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4iv(this.addr,t),Sn(e,t)}}function _w(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function xw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2uiv(this.addr,t),Sn(e,t)}}function yw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;n.uniform3uiv(this.addr,t),Sn(e,t)}}function vw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4uiv(this.addr,t),Sn(e,t)}}function qh(n){return n.version===0&&(n.compareFunction=Qd,n.needsUpdate=!0),n}function bw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=qh(p0):r=f0,e.setTexture2D(t||r,s)}function Sw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||_0,s)}function Mw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=qh(m0):r=x0,e.setTextureCube(t||r,s)}function ww(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||g0,s)}function Ew(n){switch(n){case 5126:return ow;case 35664:return aw;case 35665:return lw;case 35666:return cw;case 35674:return hw;case 35675:return uw;case 35676:return dw;case 5124:case 35670:return fw;case 35667:case 35671:return pw;case 35668:case 35672:return mw;case 35669:case 35673:return gw;case 5125:return _w;case 36294:return xw;case 36295:return yw;case 36296:return vw;case 35678:case 36198:case 36298:case 36306:case 35682:return bw;case 35679:case 36299:case 36307:return Sw;case 35680:case 36300:case 36308:case 36293:return Mw;case 36289:case 36303:case 36311:case 36292:return ww}}function Tw(n,t){n.uniform1fv(this.addr,t)}function Aw(n,t){let e=zo(t,this.size,2);n.uniform2fv(this.addr,e)}function Cw(n,t){let e=zo(t,this.size,3);n.uniform3fv(this.addr,e)}function Rw(n,t){let e=zo(t,this.size,4);n.uniform4fv(this.addr,e)}function Pw(n,t){let e=zo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Iw(n,t){let e=zo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Lw(n,t){let e=zo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Dw(n,t){n.uniform1iv(this.addr,t)}function Nw(n,t){n.uniform2iv(this.addr,t)}function Fw(n,t){n.uniform3iv(this.addr,t)}function Uw(n,t){n.uniform4iv(this.addr,t)}function Ow(n,t){n.uniform1uiv(this.addr,t)}function Bw(n,t){n.uniform2uiv(this.addr,t)}function kw(n,t){n.uniform3uiv(this.addr,t)}function zw(n,t){n.uniform4uiv(this.addr,t)}function Vw(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=qh(p0):o=f0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Gw(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||_0,r[o])}function Hw(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=qh(m0):o=x0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Ww(n,t,e){let i=this.cache,s=t.length,r=Xh(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||g0,r[o])}function $w(n){switch(n){case 5126:return Tw;case 35664:return Aw;case 35665:return Cw;case 35666:return Rw;case 35674:return Pw;case 35675:return Iw;case 35676:return Lw;case 5124:case 35670:return Dw;case 35667:case 35671:return Nw;case 35668:case 35672:return Fw;case 35669:case 35673:return Uw;case 5125:return Ow;case 36294:return Bw;case 36295:return kw;case 36296:return zw;case 35678:case 36198:case 36298:case 36306:case 35682:return Vw;case 35679:case 36299:case 36307:return Gw;case 35680:case 36300:case 36308:case 36293:return Hw;case 36289:case 36303:case 36311:case 36292:return Ww}}var pf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Ew(e.type)}},mf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=$w(e.type)}},gf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},df=/(\w+)(\])?(\[|\.)?/g;function Kg(n,t){n.seq.push(t),n.map[t.id]=t}function Xw(n,t,e){let i=n.name,s=i.length;for(df.lastIndex=0;;){let r=df.exec(i),o=df.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Kg(e,c===void 0?new pf(a,n,t):new mf(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new gf(a),Kg(e,h)),e=h}}}var ko=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Xw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function jg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var qw=37297,Yw=0;function Zw(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Qg=new oe;function Jw(n){Me._getMatrix(Qg,Me.workingColorSpace,n);let t=`mat3( ${Qg.elements.map(e=>e.toFixed(4))} )`;switch(Me.getTransfer(n)){case Ea:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return Kt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function t0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Zw(n.getShaderSource(t),a)}else return r}function Kw(n,t){let e=Jw(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var jw={[Ud]:"Linear",[Od]:"Reinhard",[Bd]:"Cineon",[kd]:"ACESFilmic",[Vd]:"AgX",[Gd]:"Neutral",[zd]:"Custom"};function Qw(n,t){let e=jw[t];return e===void 0?(Kt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Hh=new O;function t1(){Me.getLuminanceCoefficients(Hh);let n=Hh.x.toFixed(4),t=Hh.y.toFixed(4),e=Hh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function e1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(dl).join(`
`)}function n1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function i1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function dl(n){return n!==""}function e0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function n0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var s1=/^[ \t]*#include +<([\w\d./]+)>/gm;function _f(n){return n.replace(s1,r1)}function r1(n,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return _f(e)}var o1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function i0(n){return n.replace(o1,a1)}function a1(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function s0(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var l1={[il]:"SHADOWMAP_TYPE_PCF",[Fo]:"SHADOWMAP_TYPE_VSM"};function c1(n){return l1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var h1={[Oo]:"ENVMAP_MODE_REFRACTION"};function u1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":h1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var d1={[eh]:"ENVMAP_BLENDING_MULTIPLY",[gg]:"ENVMAP_BLENDING_MIX",[_g]:"ENVMAP_BLENDING_ADD"};function f1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":d1[n.combine]||"ENVMAP_BLENDING_NONE"}function p1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=c1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",d=u1(e),h=f1(e),u=e1(e),f=n1(r),m=s.createProgram(),_,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(dl).join(`
`),_.length>0&&(_+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(dl).join(`
`),p.length>0&&(p+=`
`)):(_=[s0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+d:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(dl).join(`
`),p=[s0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+d:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==cs?"#define TONE_MAPPING":"",e.toneMapping!==cs?me.tonemapping_pars_fragment:"",e.toneMapping!==cs?Qw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,Kw("linearToOutputTexel",e.outputColorSpace),t1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(dl).join(`
`)),o=_f(o),o=e0(o,e),o=n0(o,e),a=_f(a),a=e0(a,e),a=n0(a,e),o=i0(o),a=i0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,p=["#define varying in",e.glslVersion===tf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===tf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=g+_+o,S=g+p+a,b=jg(s,s.VERTEX_SHADER,v),C=jg(s,s.FRAGMENT_SHADER,S);s.attachShader(m,b),s.attachShader(m,C),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function w(F){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(m)||"",G=s.getShaderInfoLog(b)||"",H=s.getShaderInfoLog(C)||"",N=L.trim(),$=G.trim(),Z=H.trim(),W=!0,ut=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,b,C);else{let D=t0(s,b,"vertex"),q=t0(s,C,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+N+`
`+D+`
`+q)}else N!==""?Kt("WebGLProgram: Program Info Log:",N):($===""||Z==="")&&(ut=!1);ut&&(F.diagnostics={runnable:W,programLog:N,vertexShader:{log:$,prefix:_},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(b),s.deleteShader(C),x=new ko(s,m),T=i1(s,m)}let x;this.getUniforms=function(){return x===void 0&&w(this),x};let T;this.getAttributes=function(){return T===void 0&&w(this),T};let B=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(m,qw)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Yw++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=C,this}var m1=0,xf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new yf(t),e.set(t,i)),i}},yf=class{constructor(t){this.id=m1++,this.code=t,this.usedTimes=0}};function g1(n){return n===or||n===cl||n===hl}function _1(n,t,e,i,s,r){let o=new Ao,a=new xf,l=new Set,c=[],d=new Map,h=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,T,B,F,L,G){let H=F.fog,N=L.geometry,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?F.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,W=t.get(x.envMap||$,Z),ut=u[x.type],D=i.precision;x.precision!==null&&(D=i.getMaxPrecision(x.precision),D!==x.precision&&Kt("WebGLProgram.getParameters:",x.precision,"not supported, using",D,"instead."));let q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,K=q!==void 0?q.length:0,nt=0;N.morphAttributes.position!==void 0&&(nt=1),N.morphAttributes.normal!==void 0&&(nt=2),N.morphAttributes.color!==void 0&&(nt=3);let rt,tt,_t,mt;if(ut){let Lt=us[ut];rt=Lt.vertexShader,tt=Lt.fragmentShader}else{rt=x.vertexShader,tt=x.fragmentShader;let Lt=a.getVertexShaderStage(x),ue=a.getFragmentShaderStage(x);a.update(x,Lt,ue),_t=Lt.id,mt=ue.id}let xt=n.getRenderTarget(),wt=n.state.buffers.depth.getReversed(),ot=L.isInstancedMesh===!0,Et=L.isBatchedMesh===!0,vt=!!x.map,Ht=!!x.matcap,Bt=!!W,zt=Bt&&W.isPMREMTexture===!0,ge=!!x.aoMap,fe=!!x.lightMap,Ne=!!x.bumpMap&&x.wireframe===!1,_e=!!x.normalMap,ze=!!x.displacementMap,he=!!x.emissiveMap,We=!!x.metalnessMap,Qe=!!x.roughnessMap,rn=x.anisotropy>0,k=x.clearcoat>0,At=x.diffuseRoughness>0,jt=x.dispersion>0,ce=x.retroreflectivity>0,Ct=x.iridescence>0,Ve=x.sheen>0,qt=x.transmission>0,Jt=rn&&!!x.anisotropyMap,P=k&&!!x.clearcoatMap,M=k&&!!x.clearcoatNormalMap,Y=k&&!!x.clearcoatRoughnessMap,ft=At&&!!x.diffuseRoughnessMap,ct=Ct&&!!x.iridescenceMap,bt=Ct&&!!x.iridescenceThicknessMap,St=Ve&&!!x.sheenColorMap,it=Ve&&!!x.sheenRoughnessMap,at=!!x.specularMap,gt=!!x.specularColorMap,z=!!x.specularIntensityMap,lt=qt&&!!x.transmissionMap,st=qt&&!!x.thicknessMap,Rt=!!x.gradientMap,yt=!!x.alphaMap,Tt=x.alphaTest>0,Yt=!!x.alphaHash,te=!!x.extensions,dt=cs;x.toneMapped&&(xt===null||xt.isXRRenderTarget===!0)&&(dt=n.toneMapping);let Wt=zt?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,ee={shaderID:ut,shaderType:x.type,shaderName:x.name,vertexShader:rt,fragmentShader:tt,defines:x.defines,customVertexShaderID:_t,customFragmentShaderID:mt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:D,batching:Et,batchingColor:Et&&L._colorsTexture!==null,instancing:ot,instancingColor:ot&&L.instanceColor!==null,instancingMorph:ot&&L.morphTexture!==null,outputColorSpace:xt===null?n.outputColorSpace:xt.isXRRenderTarget===!0?xt.texture.colorSpace:Me.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:vt,matcap:Ht,envMap:Bt,envMapMode:Bt&&W.mapping,envMapPMREM:zt,envMapMaxLod:zt?Wt.length-1:null,envMapSize:zt?Wt[0].width:null,aoMap:ge,lightMap:fe,bumpMap:Ne,normalMap:_e,displacementMap:ze,emissiveMap:he,normalMapObjectSpace:_e&&x.normalMapType===vg,normalMapTangentSpace:_e&&x.normalMapType===Vh,packedNormalMap:_e&&x.normalMapType===Vh&&g1(x.normalMap.format),metalnessMap:We,roughnessMap:Qe,anisotropy:rn,anisotropyMap:Jt,clearcoat:k,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:Y,diffuseRoughness:At,diffuseRoughnessMap:ft,dispersion:jt,retroreflection:ce,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:bt,sheen:Ve,sheenColorMap:St,sheenRoughnessMap:it,specularMap:at,specularColorMap:gt,specularIntensityMap:z,transmission:qt,transmissionMap:lt,thicknessMap:st,gradientMap:Rt,opaque:x.transparent===!1&&x.blending===Uo&&x.alphaToCoverage===!1,alphaMap:yt,alphaTest:Tt,alphaHash:Yt,combine:x.combine,mapUv:vt&&f(x.map.channel),aoMapUv:ge&&f(x.aoMap.channel),lightMapUv:fe&&f(x.lightMap.channel),bumpMapUv:Ne&&f(x.bumpMap.channel),normalMapUv:_e&&f(x.normalMap.channel),displacementMapUv:ze&&f(x.displacementMap.channel),emissiveMapUv:he&&f(x.emissiveMap.channel),metalnessMapUv:We&&f(x.metalnessMap.channel),roughnessMapUv:Qe&&f(x.roughnessMap.channel),anisotropyMapUv:Jt&&f(x.anisotropyMap.channel),clearcoatMapUv:P&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:bt&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:St&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:it&&f(x.sheenRoughnessMap.channel),specularMapUv:at&&f(x.specularMap.channel),specularColorMapUv:gt&&f(x.specularColorMap.channel),specularIntensityMapUv:z&&f(x.specularIntensityMap.channel),transmissionMapUv:lt&&f(x.transmissionMap.channel),thicknessMapUv:st&&f(x.thicknessMap.channel),alphaMapUv:yt&&f(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(_e||rn),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!N.attributes.uv&&(vt||yt),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&_e===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:wt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:K,morphTextureStride:nt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:G.filter(Lt=>Lt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:dt,decodeVideoTexture:vt&&x.map.isVideoTexture===!0&&Me.getTransfer(x.map.colorSpace)===Ie,decodeVideoTextureEmissive:he&&x.emissiveMap.isVideoTexture===!0&&Me.getTransfer(x.emissiveMap.colorSpace)===Ie,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ei,flipSided:x.side===Zn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:te&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&x.extensions.multiDraw===!0||Et)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ee.vertexUv1s=l.has(1),ee.vertexUv2s=l.has(2),ee.vertexUv3s=l.has(3),l.clear(),ee}function _(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let B in x.defines)T.push(B),T.push(x.defines[B]);return x.isRawShaderMaterial===!1&&(p(T,x),g(T,x),T.push(n.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function p(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function g(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let T=u[x.type],B;if(T){let F=us[T];B=kg.clone(F.uniforms)}else B=x.uniforms;return B}function S(x,T){let B=d.get(T);return B!==void 0?++B.usedTimes:(B=new p1(n,T,x,s),c.push(B),d.set(T,B)),B}function b(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),d.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function w(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:v,acquireProgram:S,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:w}}function x1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function y1(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function r0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function o0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,m,_,p,g){let v=n[t];return v===void 0?(v={id:u.id,object:u,geometry:f,material:m,materialVariant:o(u),groupOrder:_,renderOrder:u.renderOrder,z:p,group:g},n[t]=v):(v.id=u.id,v.object=u,v.geometry=f,v.material=m,v.materialVariant=o(u),v.groupOrder=_,v.renderOrder=u.renderOrder,v.z=p,v.group=g),t++,v}function l(u,f,m,_,p,g,v){v.reversedDepth===!0&&(p=-p);let S=a(u,f,m,_,p,g);m.transmission>0?i.push(S):m.transparent===!0?s.push(S):e.push(S)}function c(u,f,m,_,p,g){let v=a(u,f,m,_,p,g);m.transmission>0?i.unshift(v):m.transparent===!0?s.unshift(v):e.unshift(v)}function d(u,f){e.length>1&&e.sort(u||y1),i.length>1&&i.sort(f||r0),s.length>1&&s.sort(f||r0)}function h(){for(let u=t,f=n.length;u<f;u++){let m=n[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:d}}function v1(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new o0,n.set(i,[o])):s>=r.length?(o=new o0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function b1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new O,color:new le};break;case"SpotLight":e={position:new O,direction:new O,color:new le,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new O,color:new le,distance:0,decay:0};break;case"HemisphereLight":e={direction:new O,skyColor:new le,groundColor:new le};break;case"RectAreaLight":e={color:new le,position:new O,halfWidth:new O,halfHeight:new O};break}return n[t.id]=e,e}}}function S1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Dt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Dt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Dt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var M1=0;function w1(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function E1(n){let t=new b1,e=S1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new O);let s=new O,r=new Be,o=new Be;function a(c){let d=0,h=0,u=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let f=0,m=0,_=0,p=0,g=0,v=0,S=0,b=0,C=0,w=0,x=0,T=0,B=0,F=0;c.sort(w1);for(let G=0,H=c.length;G<H;G++){let N=c[G],$=N.color,Z=N.intensity,W=N.distance,ut=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===or?ut=N.shadow.map.texture:ut=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)d+=$.r*Z,h+=$.g*Z,u+=$.b*Z;else if(N.isLightProbe){for(let D=0;D<9;D++)i.probe[D].addScaledVector(N.sh.coefficients[D],Z);F++}else if(N.isSunLight){let D=t.get(N);if(D.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let q=N.shadow,K=e.get(N);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize.copy(q.mapSize).multiply(q.getFrameExtents()),i.sunShadow[m]=K,i.sunShadowMap[m]=ut;let nt=q.getViewportCount();for(let rt=0;rt<nt;rt++)i.sunShadowMatrix[_+rt]=q.getMatrix(rt),i.sunShadowCascade[_+rt]=q._cascadeData[rt];_+=nt,m++}i.sun[f]=D,f++}else if(N.isDirectionalLight){let D=t.get(N);if(D.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let q=N.shadow,K=e.get(N);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize=q.mapSize,i.directionalShadow[p]=K,i.directionalShadowMap[p]=ut,i.directionalShadowMatrix[p]=N.shadow.matrix,C++}i.directional[p]=D,p++}else if(N.isSpotLight){let D=t.get(N);D.position.setFromMatrixPosition(N.matrixWorld),D.color.copy($).multiplyScalar(Z),D.distance=W,D.coneCos=Math.cos(N.angle),D.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),D.decay=N.decay,i.spot[v]=D;let q=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,q.updateMatrices(N),N.castShadow&&B++),i.spotLightMatrix[v]=q.matrix,N.castShadow){let K=e.get(N);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize=q.mapSize,i.spotShadow[v]=K,i.spotShadowMap[v]=ut,x++}v++}else if(N.isRectAreaLight){let D=t.get(N);D.color.copy($).multiplyScalar(Z),D.halfWidth.set(N.width*.5,0,0),D.halfHeight.set(0,N.height*.5,0),i.rectArea[S]=D,S++}else if(N.isPointLight){let D=t.get(N);if(D.color.copy(N.color).multiplyScalar(N.intensity),D.distance=N.distance,D.decay=N.decay,N.castShadow){let q=N.shadow,K=e.get(N);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize=q.mapSize,K.shadowCameraNear=q.camera.near,K.shadowCameraFar=q.camera.far,i.pointShadow[g]=K,i.pointShadowMap[g]=ut,i.pointShadowMatrix[g]=N.shadow.matrix,w++}i.point[g]=D,g++}else if(N.isHemisphereLight){let D=t.get(N);D.skyColor.copy(N.color).multiplyScalar(Z),D.groundColor.copy(N.groundColor).multiplyScalar(Z),i.hemi[b]=D,b++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ut.LTC_FLOAT_1,i.rectAreaLTC2=Ut.LTC_FLOAT_2):(i.rectAreaLTC1=Ut.LTC_HALF_1,i.rectAreaLTC2=Ut.LTC_HALF_2)),i.ambient[0]=d,i.ambient[1]=h,i.ambient[2]=u;let L=i.hash;(L.sunLength!==f||L.directionalLength!==p||L.pointLength!==g||L.spotLength!==v||L.rectAreaLength!==S||L.hemiLength!==b||L.numSunShadows!==m||L.numDirectionalShadows!==C||L.numPointShadows!==w||L.numSpotShadows!==x||L.numSpotMaps!==T||L.numLightProbes!==F)&&(i.sun.length=f,i.directional.length=p,i.spot.length=v,i.rectArea.length=S,i.point.length=g,i.hemi.length=b,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+T-B,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=F,L.sunLength=f,L.directionalLength=p,L.pointLength=g,L.spotLength=v,L.rectAreaLength=S,L.hemiLength=b,L.numSunShadows=m,L.numDirectionalShadows=C,L.numPointShadows=w,L.numSpotShadows=x,L.numSpotMaps=T,L.numLightProbes=F,i.version=M1++)}function l(c,d){let h=0,u=0,f=0,m=0,_=0,p=0,g=d.matrixWorldInverse;for(let v=0,S=c.length;v<S;v++){let b=c[v];if(b.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let C=i.directional[u];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),u++}else if(b.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),m++}else if(b.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:i}}function a0(n){let t=new E1(n),e=[],i=[],s=[];function r(h){d.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,u)=>h.priority-u.priority||h.id-u.id)}function c(h){t.setupView(e,h)}let d={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:d,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function T1(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new a0(n),t.set(s,[a])):r>=o.length?(a=new a0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var A1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,C1=`uniform sampler2D shadow_pass;
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
}`,R1=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],P1=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],l0=new Be,ul=new O,ff=new O;function I1(n,t,e){let i=new Ks,s=new Dt,r=new Dt,o=new en,a=new Vc,l=new Gc,c={},d=e.maxTextureSize,h={[rr]:Zn,[Zn]:rr,[Ei]:Ei},u=new ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Dt},radius:{value:4}},vertexShader:A1,fragmentShader:C1}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let m=new Ke;m.setAttribute("position",new os(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Le(m,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=il;let g=this.type;this.render=function(w,x,T){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===Km&&(Kt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=il);let B=n.getRenderTarget(),F=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),G=n.state;G.setBlending(Mr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=g!==this.type;H&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach($=>$.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,$=w.length;N<$;N++){let Z=w[N],W=Z.shadow;if(W===void 0){Kt("WebGLShadowMap:",Z,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ut=W.getFrameExtents();s.multiply(ut),r.copy(W.mapSize),(s.x>d||s.y>d)&&(s.x>d&&(r.x=Math.floor(d/ut.x),s.x=r.x*ut.x,W.mapSize.x=r.x),s.y>d&&(r.y=Math.floor(d/ut.y),s.y=r.y*ut.y,W.mapSize.y=r.y));let D=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=D,W.map===null||H===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===Fo){if(Z.isPointLight){Kt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new fi(s.x,s.y,{format:or,type:Vi,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),W.map.texture.name=Z.name+".shadowMap",W.map.depthTexture=new Ts(s.x,s.y,zi),W.map.depthTexture.name=Z.name+".shadowMapDepth",W.map.depthTexture.format=ws,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=In,W.map.depthTexture.magFilter=In}else Z.isPointLight?(W.map=new fl(s.x),W.map.depthTexture=new Na(s.x,ki)):(W.map=new fi(s.x,s.y),W.map.depthTexture=new Ts(s.x,s.y,ki)),W.map.depthTexture.name=Z.name+".shadowMap",W.map.depthTexture.format=ws,this.type===il?(W.map.depthTexture.compareFunction=D?jd:Kd,W.map.depthTexture.minFilter=Yn,W.map.depthTexture.magFilter=Yn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=In,W.map.depthTexture.magFilter=In);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Z.isPointLight!==!0&&W.updateMatrices(Z,T);let K=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:T.layers;for(let nt=0;nt<q;nt++){let rt=W.getCamera(nt);if(Z.isPointLight){let tt=W.camera,_t=W.matrix,mt=Z.distance||tt.far;mt!==tt.far&&(tt.far=mt,tt.updateProjectionMatrix()),ul.setFromMatrixPosition(Z.matrixWorld),tt.position.copy(ul),ff.copy(tt.position),ff.add(R1[nt]),tt.up.copy(P1[nt]),tt.lookAt(ff),tt.updateMatrixWorld(),_t.makeTranslation(-ul.x,-ul.y,-ul.z),l0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),W._frustum.setFromProjectionMatrix(l0,tt.coordinateSystem,tt.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,nt),n.clear();else{nt===0&&(n.setRenderTarget(W.map),n.clear());let tt=W.getViewport(nt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),G.viewport(o)}i=W.getFrustum(nt),b(x,T,rt,Z,K,this.type)}W.isPointLightShadow!==!0&&this.type===Fo&&v(W,T),W.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(B,F,L)};function v(w,x){let T=t.update(_);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new fi(s.x,s.y,{format:or,type:Vi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(x,null,T,u,_,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(x,null,T,f,_,null)}function S(w,x,T,B){let F=null,L=T.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(L!==void 0)F=L;else if(F=T.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=F.uuid,H=x.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let $=N[H];$===void 0&&($=F.clone(),N[H]=$,x.addEventListener("dispose",C)),F=$}if(F.visible=x.visible,F.wireframe=x.wireframe,B===Fo?F.side=x.shadowSide!==null?x.shadowSide:x.side:F.side=x.shadowSide!==null?x.shadowSide:h[x.side],F.alphaMap=x.alphaMap,F.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,F.map=x.map,F.clipShadows=x.clipShadows,F.clippingPlanes=x.clippingPlanes,F.clipIntersection=x.clipIntersection,F.displacementMap=x.displacementMap,F.displacementScale=x.displacementScale,F.displacementBias=x.displacementBias,F.wireframeLinewidth=x.wireframeLinewidth,F.linewidth=x.linewidth,T.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let G=n.properties.get(F);G.light=T}return F}function b(w,x,T,B,F,L){if(w.visible===!1)return;if(w.layers.test(F)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&L===Fo)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,w.matrixWorld);let N=t.update(w),$=w.material;if(Array.isArray($)){let Z=N.groups;for(let W=0,ut=Z.length;W<ut;W++){let D=Z[W],q=$[D.materialIndex];if(q&&q.visible){let K=S(w,q,B,L);w.onBeforeShadow(n,w,x,T,N,K,D),n.renderBufferDirect(T,null,N,K,w,D),w.onAfterShadow(n,w,x,T,N,K,D)}}}else if($.visible){let Z=S(w,$,B,L);w.onBeforeShadow(n,w,x,T,N,Z,null),n.renderBufferDirect(T,null,N,Z,w,null),w.onAfterShadow(n,w,x,T,N,Z,null)}}let H=w.children;for(let N=0,$=H.length;N<$;N++)b(H[N],x,T,B,F,L)}function C(w){w.target.removeEventListener("dispose",C);for(let T in c){let B=c[T],F=w.target.uuid;F in B&&(B[F].dispose(),delete B[F])}}}function L1(n,t){function e(){let z=!1,lt=new en,st=null,Rt=new en(0,0,0,0);return{setMask:function(yt){st!==yt&&!z&&(n.colorMask(yt,yt,yt,yt),st=yt)},setLocked:function(yt){z=yt},setClear:function(yt,Tt,Yt,te,dt){dt===!0&&(yt*=te,Tt*=te,Yt*=te),lt.set(yt,Tt,Yt,te),Rt.equals(lt)===!1&&(n.clearColor(yt,Tt,Yt,te),Rt.copy(lt))},reset:function(){z=!1,st=null,Rt.set(-1,0,0,0)}}}function i(){let z=!1,lt=!1,st=null,Rt=null,yt=null;return{setReversed:function(Tt){if(lt!==Tt){let Yt=t.get("EXT_clip_control");Tt?Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.ZERO_TO_ONE_EXT):Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.NEGATIVE_ONE_TO_ONE_EXT),lt=Tt;let te=yt;yt=null,this.setClear(te)}},getReversed:function(){return lt},setTest:function(Tt){Tt?wt(n.DEPTH_TEST):ot(n.DEPTH_TEST)},setMask:function(Tt){st!==Tt&&!z&&(n.depthMask(Tt),st=Tt)},setFunc:function(Tt){if(lt&&(Tt=Ig[Tt]),Rt!==Tt){switch(Tt){case _c:n.depthFunc(n.NEVER);break;case xc:n.depthFunc(n.ALWAYS);break;case yc:n.depthFunc(n.LESS);break;case So:n.depthFunc(n.LEQUAL);break;case vc:n.depthFunc(n.EQUAL);break;case bc:n.depthFunc(n.GEQUAL);break;case Sc:n.depthFunc(n.GREATER);break;case Mc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Rt=Tt}},setLocked:function(Tt){z=Tt},setClear:function(Tt){yt!==Tt&&(yt=Tt,lt&&(Tt=1-Tt),n.clearDepth(Tt))},reset:function(){z=!1,st=null,Rt=null,yt=null,lt=!1}}}function s(){let z=!1,lt=null,st=null,Rt=null,yt=null,Tt=null,Yt=null,te=null,dt=null;return{setTest:function(Wt){z||(Wt?wt(n.STENCIL_TEST):ot(n.STENCIL_TEST))},setMask:function(Wt){lt!==Wt&&!z&&(n.stencilMask(Wt),lt=Wt)},setFunc:function(Wt,ee,Lt){(st!==Wt||Rt!==ee||yt!==Lt)&&(n.stencilFunc(Wt,ee,Lt),st=Wt,Rt=ee,yt=Lt)},setOp:function(Wt,ee,Lt){(Tt!==Wt||Yt!==ee||te!==Lt)&&(n.stencilOp(Wt,ee,Lt),Tt=Wt,Yt=ee,te=Lt)},setLocked:function(Wt){z=Wt},setClear:function(Wt){dt!==Wt&&(n.clearStencil(Wt),dt=Wt)},reset:function(){z=!1,lt=null,st=null,Rt=null,yt=null,Tt=null,Yt=null,te=null,dt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,d={},h={},u={},f=new WeakMap,m=[],_=null,p=!1,g=null,v=null,S=null,b=null,C=null,w=null,x=null,T=new le(0,0,0),B=0,F=!1,L=null,G=null,H=null,N=null,$=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ut=0,D=n.getParameter(n.VERSION);D.indexOf("WebGL")!==-1?(ut=parseFloat(/^WebGL (\d)/.exec(D)[1]),W=ut>=1):D.indexOf("OpenGL ES")!==-1&&(ut=parseFloat(/^OpenGL ES (\d)/.exec(D)[1]),W=ut>=2);let q=null,K={},nt=n.getParameter(n.SCISSOR_BOX),rt=n.getParameter(n.VIEWPORT),tt=new en().fromArray(nt),_t=new en().fromArray(rt);function mt(z,lt,st,Rt){let yt=new Uint8Array(4),Tt=n.createTexture();n.bindTexture(z,Tt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Yt=0;Yt<st;Yt++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Rt,0,n.RGBA,n.UNSIGNED_BYTE,yt):n.texImage2D(lt+Yt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,yt);return Tt}let xt={};xt[n.TEXTURE_2D]=mt(n.TEXTURE_2D,n.TEXTURE_2D,1),xt[n.TEXTURE_CUBE_MAP]=mt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),xt[n.TEXTURE_2D_ARRAY]=mt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),xt[n.TEXTURE_3D]=mt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(n.DEPTH_TEST),o.setFunc(So),Ne(!1),_e(Pd),wt(n.CULL_FACE),ge(Mr);function wt(z){d[z]!==!0&&(n.enable(z),d[z]=!0)}function ot(z){d[z]!==!1&&(n.disable(z),d[z]=!1)}function Et(z,lt){return u[z]!==lt?(n.bindFramebuffer(z,lt),u[z]=lt,z===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=lt),z===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function vt(z,lt){let st=m,Rt=!1;if(z){st=f.get(lt),st===void 0&&(st=[],f.set(lt,st));let yt=z.textures;if(st.length!==yt.length||st[0]!==n.COLOR_ATTACHMENT0){for(let Tt=0,Yt=yt.length;Tt<Yt;Tt++)st[Tt]=n.COLOR_ATTACHMENT0+Tt;st.length=yt.length,Rt=!0}}else st[0]!==n.BACK&&(st[0]=n.BACK,Rt=!0);Rt&&n.drawBuffers(st)}function Ht(z){return _!==z?(n.useProgram(z),_=z,!0):!1}let Bt={[wr]:n.FUNC_ADD,[Qm]:n.FUNC_SUBTRACT,[tg]:n.FUNC_REVERSE_SUBTRACT};Bt[eg]=n.MIN,Bt[ng]=n.MAX;let zt={[ig]:n.ZERO,[sg]:n.ONE,[rg]:n.SRC_COLOR,[Nd]:n.SRC_ALPHA,[ug]:n.SRC_ALPHA_SATURATE,[cg]:n.DST_COLOR,[ag]:n.DST_ALPHA,[og]:n.ONE_MINUS_SRC_COLOR,[Fd]:n.ONE_MINUS_SRC_ALPHA,[hg]:n.ONE_MINUS_DST_COLOR,[lg]:n.ONE_MINUS_DST_ALPHA,[dg]:n.CONSTANT_COLOR,[fg]:n.ONE_MINUS_CONSTANT_COLOR,[pg]:n.CONSTANT_ALPHA,[mg]:n.ONE_MINUS_CONSTANT_ALPHA};function ge(z,lt,st,Rt,yt,Tt,Yt,te,dt,Wt){if(z===Mr){p===!0&&(ot(n.BLEND),p=!1);return}if(p===!1&&(wt(n.BLEND),p=!0),z!==jm){if(z!==g||Wt!==F){if((v!==wr||C!==wr)&&(n.blendEquation(n.FUNC_ADD),v=wr,C=wr),Wt)switch(z){case Uo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Id:n.blendFunc(n.ONE,n.ONE);break;case Ld:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Dd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ie("WebGLState: Invalid blending: ",z);break}else switch(z){case Uo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Id:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ld:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Dd:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",z);break}S=null,b=null,w=null,x=null,T.set(0,0,0),B=0,g=z,F=Wt}return}yt=yt||lt,Tt=Tt||st,Yt=Yt||Rt,(lt!==v||yt!==C)&&(n.blendEquationSeparate(Bt[lt],Bt[yt]),v=lt,C=yt),(st!==S||Rt!==b||Tt!==w||Yt!==x)&&(n.blendFuncSeparate(zt[st],zt[Rt],zt[Tt],zt[Yt]),S=st,b=Rt,w=Tt,x=Yt),(te.equals(T)===!1||dt!==B)&&(n.blendColor(te.r,te.g,te.b,dt),T.copy(te),B=dt),g=z,F=!1}function fe(z,lt){z.side===Ei?ot(n.CULL_FACE):wt(n.CULL_FACE);let st=z.side===Zn;lt&&(st=!st),Ne(st),z.blending===Uo&&z.transparent===!1?ge(Mr):ge(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Rt=z.stencilWrite;a.setTest(Rt),Rt&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),he(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?wt(n.SAMPLE_ALPHA_TO_COVERAGE):ot(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ne(z){L!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),L=z)}function _e(z){z!==Zm?(wt(n.CULL_FACE),z!==G&&(z===Pd?n.cullFace(n.BACK):z===Jm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):ot(n.CULL_FACE),G=z}function ze(z){z!==H&&(W&&n.lineWidth(z),H=z)}function he(z,lt,st){z?(wt(n.POLYGON_OFFSET_FILL),(N!==lt||$!==st)&&(N=lt,$=st,o.getReversed()&&(lt=-lt,st=-st),n.polygonOffset(lt,st))):ot(n.POLYGON_OFFSET_FILL)}function We(z){z?wt(n.SCISSOR_TEST):ot(n.SCISSOR_TEST)}function Qe(z){z===void 0&&(z=n.TEXTURE0+Z-1),q!==z&&(n.activeTexture(z),q=z)}function rn(z,lt,st){st===void 0&&(q===null?st=n.TEXTURE0+Z-1:st=q);let Rt=K[st];Rt===void 0&&(Rt={type:void 0,texture:void 0},K[st]=Rt),(Rt.type!==z||Rt.texture!==lt)&&(q!==st&&(n.activeTexture(st),q=st),n.bindTexture(z,lt||xt[z]),Rt.type=z,Rt.texture=lt)}function k(){let z=K[q];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function At(){try{n.compressedTexImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function jt(){try{n.compressedTexImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function ce(){try{n.texSubImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function Ve(){try{n.compressedTexSubImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function qt(){try{n.compressedTexSubImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function Jt(){try{n.texStorage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function P(){try{n.texStorage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function M(){try{n.texImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function Y(){try{n.texImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function ft(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function ct(z,lt){h[z]!==lt&&(n.pixelStorei(z,lt),h[z]=lt)}function bt(z){tt.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),tt.copy(z))}function St(z){_t.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),_t.copy(z))}function it(z,lt){let st=c.get(lt);st===void 0&&(st=new WeakMap,c.set(lt,st));let Rt=st.get(z);Rt===void 0&&(Rt=n.getUniformBlockIndex(lt,z.name),n.uniformBlockBinding(lt,Rt,Rt),st.set(z,Rt))}function at(z,lt,st){let yt=c.get(lt).get(z);l[yt]!==st&&(n.bindBufferBase(n.UNIFORM_BUFFER,yt,st),l[yt]=st)}function gt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),d={},h={},q=null,K={},u={},l={},f=new WeakMap,m=[],_=null,p=!1,g=null,v=null,S=null,b=null,C=null,w=null,x=null,T=new le(0,0,0),B=0,F=!1,L=null,G=null,H=null,N=null,$=null,tt.set(0,0,n.canvas.width,n.canvas.height),_t.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:ot,bindFramebuffer:Et,drawBuffers:vt,useProgram:Ht,setBlending:ge,setMaterial:fe,setFlipSided:Ne,setCullFace:_e,setLineWidth:ze,setPolygonOffset:he,setScissorTest:We,activeTexture:Qe,bindTexture:rn,unbindTexture:k,compressedTexImage2D:At,compressedTexImage3D:jt,texImage2D:M,texImage3D:Y,pixelStorei:ct,getParameter:ft,updateUBOMapping:it,uniformBlockBinding:at,texStorage2D:Jt,texStorage3D:P,texSubImage2D:ce,texSubImage3D:Ct,compressedTexSubImage2D:Ve,compressedTexSubImage3D:qt,scissor:bt,viewport:St,reset:gt}}function D1(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Dt,d=new WeakMap,h=new Set,u,f=new WeakMap,m=new Set,_=new FinalizationRegistry(P=>m.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,M){return p?new OffscreenCanvas(P,M):Ta("canvas")}function v(P,M,Y){let ft=1,ct=Jt(P);if((ct.width>Y||ct.height>Y)&&(ft=Y/Math.max(ct.width,ct.height)),ft<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let bt=Math.floor(ft*ct.width),St=Math.floor(ft*ct.height);u===void 0&&(u=g(bt,St));let it=M?g(bt,St):u;return it.width=bt,it.height=St,it.getContext("2d").drawImage(P,0,0,bt,St),Kt("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+bt+"x"+St+")."),it}else return"data"in P&&Kt("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),P;return P}function S(P){return P.generateMipmaps}function b(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(P,M,Y,ft,ct,bt=!1){if(P!==null){if(n[P]!==void 0)return n[P];Kt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let St;ft&&(St=t.get("EXT_texture_norm16"),St||Kt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=M;if(M===n.RED&&(Y===n.FLOAT&&(it=n.R32F),Y===n.HALF_FLOAT&&(it=n.R16F),Y===n.UNSIGNED_BYTE&&(it=n.R8),Y===n.UNSIGNED_SHORT&&St&&(it=St.R16_EXT),Y===n.SHORT&&St&&(it=St.R16_SNORM_EXT)),M===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.R8UI),Y===n.UNSIGNED_SHORT&&(it=n.R16UI),Y===n.UNSIGNED_INT&&(it=n.R32UI),Y===n.BYTE&&(it=n.R8I),Y===n.SHORT&&(it=n.R16I),Y===n.INT&&(it=n.R32I)),M===n.RG&&(Y===n.FLOAT&&(it=n.RG32F),Y===n.HALF_FLOAT&&(it=n.RG16F),Y===n.UNSIGNED_BYTE&&(it=n.RG8),Y===n.UNSIGNED_SHORT&&St&&(it=St.RG16_EXT),Y===n.SHORT&&St&&(it=St.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.RG8UI),Y===n.UNSIGNED_SHORT&&(it=n.RG16UI),Y===n.UNSIGNED_INT&&(it=n.RG32UI),Y===n.BYTE&&(it=n.RG8I),Y===n.SHORT&&(it=n.RG16I),Y===n.INT&&(it=n.RG32I)),M===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(it=n.RGB16UI),Y===n.UNSIGNED_INT&&(it=n.RGB32UI),Y===n.BYTE&&(it=n.RGB8I),Y===n.SHORT&&(it=n.RGB16I),Y===n.INT&&(it=n.RGB32I)),M===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),Y===n.UNSIGNED_INT&&(it=n.RGBA32UI),Y===n.BYTE&&(it=n.RGBA8I),Y===n.SHORT&&(it=n.RGBA16I),Y===n.INT&&(it=n.RGBA32I)),M===n.RGB&&(Y===n.UNSIGNED_SHORT&&St&&(it=St.RGB16_EXT),Y===n.SHORT&&St&&(it=St.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),M===n.RGBA){let at=bt?Ea:Me.getTransfer(ct);Y===n.FLOAT&&(it=n.RGBA32F),Y===n.HALF_FLOAT&&(it=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(it=at===Ie?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&St&&(it=St.RGBA16_EXT),Y===n.SHORT&&St&&(it=St.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function x(P,M){let Y;return P?M===null||M===ki||M===Tr?Y=n.DEPTH24_STENCIL8:M===zi?Y=n.DEPTH32F_STENCIL8:M===Bo&&(Y=n.DEPTH24_STENCIL8,Kt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===ki||M===Tr?Y=n.DEPTH_COMPONENT24:M===zi?Y=n.DEPTH_COMPONENT32F:M===Bo&&(Y=n.DEPTH_COMPONENT16),Y}function T(P,M){return S(P)===!0||P.isFramebufferTexture&&P.minFilter!==In&&P.minFilter!==Yn?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function B(P){let M=new WeakRef(P);i.get(P).__ref=M,m.add(M),_.register(P,M,M)}function F(P){let M=i.get(P).__ref;M!==void 0&&(m.delete(M),_.unregister(M))}function L(P){H(P.target)}function G(P){N(P.target)}function H(P){P.removeEventListener("dispose",L),F(P),Z(P),P.isVideoTexture&&d.delete(P),P.isHTMLTexture&&h.delete(P)}function N(P){P.removeEventListener("dispose",G),F(P),ut(P)}function $(){for(let P of m){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):H(M))}m.clear(),h.clear()}function Z(P){let M=i.get(P);if(M.__webglInit===void 0)return;let Y=P.source,ft=f.get(Y);if(ft){let ct=ft[M.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&W(P),Object.keys(ft).length===0&&f.delete(Y)}i.remove(P)}function W(P){let M=i.get(P);n.deleteTexture(M.__webglTexture);let Y=P.source,ft=f.get(Y);delete ft[M.__cacheKey],o.memory.textures--}function ut(P){let M=i.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let Y=P.depthTexture;if(Y&&Y.renderTarget===P&&H(Y),P.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(M.__webglFramebuffer[ct]))for(let bt=0;bt<M.__webglFramebuffer[ct].length;bt++)n.deleteFramebuffer(M.__webglFramebuffer[ct][bt]);else n.deleteFramebuffer(M.__webglFramebuffer[ct]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ct])}else{if(Array.isArray(M.__webglFramebuffer))for(let ct=0;ct<M.__webglFramebuffer.length;ct++)n.deleteFramebuffer(M.__webglFramebuffer[ct]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ct=0;ct<M.__webglColorRenderbuffer.length;ct++)M.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ct]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ft=P.textures;for(let ct=0,bt=ft.length;ct<bt;ct++){let St=i.get(ft[ct]);St.__webglTexture&&(n.deleteTexture(St.__webglTexture),o.memory.textures--),i.remove(ft[ct])}i.remove(P)}let D=0;function q(){D=0}function K(){return D}function nt(P){D=P}function rt(){let P=D;return P>=s.maxTextures&&Kt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),D+=1,P}function tt(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function _t(P,M){let Y=i.get(P);if(P.isVideoTexture&&Ve(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&Y.__version!==P.version){let ft=P.image;if(ft===null)Kt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Kt("WebGLRenderer: Texture marked for update but image is incomplete");else{fe(Y,P,M);return}}else P.isExternalTexture&&(Y.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+M)}function mt(P,M){let Y=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){fe(Y,P,M);return}else P.isExternalTexture&&(Y.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+M)}function xt(P,M){let Y=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){fe(Y,P,M);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+M)}function wt(P,M){let Y=i.get(P);if(P.version>0&&Y.__version!==P.version){Ne(Y,P,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+M)}let ot={[wc]:n.REPEAT,[rs]:n.CLAMP_TO_EDGE,[Ec]:n.MIRRORED_REPEAT},Et={[In]:n.NEAREST,[xg]:n.NEAREST_MIPMAP_NEAREST,[sl]:n.NEAREST_MIPMAP_LINEAR,[Yn]:n.LINEAR,[sh]:n.LINEAR_MIPMAP_NEAREST,[Cs]:n.LINEAR_MIPMAP_LINEAR},vt={[Sg]:n.NEVER,[Qd]:n.ALWAYS,[Mg]:n.LESS,[Kd]:n.LEQUAL,[wg]:n.EQUAL,[jd]:n.GEQUAL,[Eg]:n.GREATER,[Tg]:n.NOTEQUAL};function Ht(P,M){if(M.type===zi&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===Yn||M.magFilter===sh||M.magFilter===sl||M.magFilter===Cs||M.minFilter===Yn||M.minFilter===sh||M.minFilter===sl||M.minFilter===Cs)&&Kt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ot[M.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ot[M.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ot[M.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,Et[M.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,Et[M.minFilter]),M.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,vt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===In||M.minFilter!==sl&&M.minFilter!==Cs||M.type===zi&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function Bt(P,M){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",L),B(M));let ft=M.source,ct=f.get(ft);ct===void 0&&(ct={},f.set(ft,ct));let bt=tt(M);if(bt!==P.__cacheKey){ct[bt]===void 0&&(ct[bt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),ct[bt].usedTimes++;let St=ct[P.__cacheKey];St!==void 0&&(ct[P.__cacheKey].usedTimes--,St.usedTimes===0&&W(M)),P.__cacheKey=bt,P.__webglTexture=ct[bt].texture}return Y}function zt(P,M,Y){return Math.floor(Math.floor(P/Y)/M)}function ge(P,M,Y,ft){let bt=P.updateRanges;if(bt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,Y,ft,M.data);else{bt.sort((z,lt)=>z.start-lt.start);let St=0;for(let z=1;z<bt.length;z++){let lt=bt[St],st=bt[z],Rt=lt.start+lt.count,yt=zt(st.start,M.width,4),Tt=zt(lt.start,M.width,4);st.start<=Rt+1&&yt===Tt&&zt(st.start+st.count-1,M.width,4)===yt?lt.count=Math.max(lt.count,st.start+st.count-lt.start):(++St,bt[St]=st)}bt.length=St+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),gt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let z=0,lt=bt.length;z<lt;z++){let st=bt[z],Rt=Math.floor(st.start/4),yt=Math.ceil(st.count/4),Tt=Rt%M.width,Yt=Math.floor(Rt/M.width),te=yt,dt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Tt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Yt),e.texSubImage2D(n.TEXTURE_2D,0,Tt,Yt,te,dt,Y,ft,M.data)}P.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,gt)}}function fe(P,M,Y){let ft=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ft=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ft=n.TEXTURE_3D);let ct=Bt(P,M),bt=M.source;e.bindTexture(ft,P.__webglTexture,n.TEXTURE0+Y);let St=i.get(bt);if(bt.version!==St.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let dt=Me.getPrimaries(Me.workingColorSpace),Wt=M.colorSpace===Ps?null:Me.getPrimaries(M.colorSpace),ee=M.colorSpace===Ps||dt===Wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let at=v(M.image,!1,s.maxTextureSize);at=qt(M,at);let gt=r.convert(M.format,M.colorSpace),z=r.convert(M.type),lt=w(M.internalFormat,gt,z,M.normalized,M.colorSpace,M.isVideoTexture);Ht(ft,M);let st,Rt=M.mipmaps,yt=M.isVideoTexture!==!0,Tt=St.__version===void 0||ct===!0,Yt=bt.dataReady,te=T(M,at);if(M.isDepthTexture)lt=x(M.format===Rs,M.type),Tt&&(yt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,gt,z,null));else if(M.isDataTexture)if(Rt.length>0){yt&&Tt&&e.texStorage2D(n.TEXTURE_2D,te,lt,Rt[0].width,Rt[0].height);for(let dt=0,Wt=Rt.length;dt<Wt;dt++)st=Rt[dt],yt?Yt&&e.texSubImage2D(n.TEXTURE_2D,dt,0,0,st.width,st.height,gt,z,st.data):e.texImage2D(n.TEXTURE_2D,dt,lt,st.width,st.height,0,gt,z,st.data);M.generateMipmaps=!1}else yt?(Tt&&e.texStorage2D(n.TEXTURE_2D,te,lt,at.width,at.height),Yt&&ge(M,at,gt,z)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,gt,z,at.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){yt&&Tt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,lt,Rt[0].width,Rt[0].height,at.depth);for(let dt=0,Wt=Rt.length;dt<Wt;dt++)if(st=Rt[dt],M.format!==Gi)if(gt!==null)if(yt){if(Yt)if(M.layerUpdates.size>0){let ee=uf(st.width,st.height,M.format,M.type);for(let Lt of M.layerUpdates){let ue=st.data.subarray(Lt*ee/st.data.BYTES_PER_ELEMENT,(Lt+1)*ee/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,dt,0,0,Lt,st.width,st.height,1,gt,ue)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,dt,0,0,0,st.width,st.height,at.depth,gt,st.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,dt,lt,st.width,st.height,at.depth,0,st.data,0,0);else Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else yt?Yt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,dt,0,0,0,st.width,st.height,at.depth,gt,z,st.data):e.texImage3D(n.TEXTURE_2D_ARRAY,dt,lt,st.width,st.height,at.depth,0,gt,z,st.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{yt&&Tt&&e.texStorage2D(n.TEXTURE_2D,te,lt,Rt[0].width,Rt[0].height);for(let dt=0,Wt=Rt.length;dt<Wt;dt++)st=Rt[dt],M.format!==Gi?gt!==null?yt?Yt&&e.compressedTexSubImage2D(n.TEXTURE_2D,dt,0,0,st.width,st.height,gt,st.data):e.compressedTexImage2D(n.TEXTURE_2D,dt,lt,st.width,st.height,0,st.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):yt?Yt&&e.texSubImage2D(n.TEXTURE_2D,dt,0,0,st.width,st.height,gt,z,st.data):e.texImage2D(n.TEXTURE_2D,dt,lt,st.width,st.height,0,gt,z,st.data)}else if(M.isDataArrayTexture)if(yt){if(Tt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,lt,at.width,at.height,at.depth),Yt)if(M.layerUpdates.size>0){let dt=uf(at.width,at.height,M.format,M.type);for(let Wt of M.layerUpdates){let ee=at.data.subarray(Wt*dt/at.data.BYTES_PER_ELEMENT,(Wt+1)*dt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Wt,at.width,at.height,1,gt,z,ee)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,gt,z,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,gt,z,at.data);else if(M.isData3DTexture)yt?(Tt&&e.texStorage3D(n.TEXTURE_3D,te,lt,at.width,at.height,at.depth),Yt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,gt,z,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,gt,z,at.data);else if(M.isFramebufferTexture){if(Tt)if(yt)e.texStorage2D(n.TEXTURE_2D,te,lt,at.width,at.height);else{let dt=at.width,Wt=at.height;for(let ee=0;ee<te;ee++)e.texImage2D(n.TEXTURE_2D,ee,lt,dt,Wt,0,gt,z,null),dt>>=1,Wt>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let dt=n.canvas;if(dt.hasAttribute("layoutsubtree")||dt.setAttribute("layoutsubtree","true"),at.parentNode!==dt){dt.appendChild(at),h.add(M),dt.onpaint=Wt=>{let ee=Wt.changedElements;for(let Lt of h)ee.includes(Lt.image)&&(Lt.needsUpdate=!0)},dt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ee=n.RGBA,Lt=n.RGBA,ue=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ee,Lt,ue,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Rt.length>0){if(yt&&Tt){let dt=Jt(Rt[0]);e.texStorage2D(n.TEXTURE_2D,te,lt,dt.width,dt.height)}for(let dt=0,Wt=Rt.length;dt<Wt;dt++)st=Rt[dt],yt?Yt&&e.texSubImage2D(n.TEXTURE_2D,dt,0,0,gt,z,st):e.texImage2D(n.TEXTURE_2D,dt,lt,gt,z,st);M.generateMipmaps=!1}else if(yt){if(Tt){let dt=Jt(at);e.texStorage2D(n.TEXTURE_2D,te,lt,dt.width,dt.height)}Yt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,gt,z,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,gt,z,at);S(M)&&M.mipmapsAutoUpdate===!0&&b(ft),St.__version=bt.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function Ne(P,M,Y){if(M.image.length!==6)return;let ft=Bt(P,M),ct=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+Y);let bt=i.get(ct);if(ct.version!==bt.__version||ft===!0){e.activeTexture(n.TEXTURE0+Y);let St=Me.getPrimaries(Me.workingColorSpace),it=M.colorSpace===Ps?null:Me.getPrimaries(M.colorSpace),at=M.colorSpace===Ps||St===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let gt=M.isCompressedTexture||M.image[0].isCompressedTexture,z=M.image[0]&&M.image[0].isDataTexture,lt=[];for(let Lt=0;Lt<6;Lt++)!gt&&!z?lt[Lt]=v(M.image[Lt],!0,s.maxCubemapSize):lt[Lt]=z?M.image[Lt].image:M.image[Lt],lt[Lt]=qt(M,lt[Lt]);let st=lt[0],Rt=r.convert(M.format,M.colorSpace),yt=r.convert(M.type),Tt=w(M.internalFormat,Rt,yt,M.normalized,M.colorSpace),Yt=M.isVideoTexture!==!0,te=bt.__version===void 0||ft===!0,dt=ct.dataReady,Wt=T(M,st);Ht(n.TEXTURE_CUBE_MAP,M);let ee;if(M.isDepthTexture){if(Tt=x(M.format===Rs,M.type),te)if(Yt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Tt,st.width,st.height);else for(let Lt=0;Lt<6;Lt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,0,Tt,st.width,st.height,0,Rt,yt,null)}else if(gt){Yt&&te&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Tt,st.width,st.height);for(let Lt=0;Lt<6;Lt++){ee=lt[Lt].mipmaps;for(let ue=0;ue<ee.length;ue++){let $e=ee[ue];M.format!==Gi?Rt!==null?Yt?dt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue,0,0,$e.width,$e.height,Rt,$e.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue,Tt,$e.width,$e.height,0,$e.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue,0,0,$e.width,$e.height,Rt,yt,$e.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue,Tt,$e.width,$e.height,0,Rt,yt,$e.data)}}}else{if(ee=M.mipmaps,Yt&&te){ee.length>0&&Wt++;let Lt=Jt(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Tt,Lt.width,Lt.height)}for(let Lt=0;Lt<6;Lt++)if(z){Yt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,0,0,0,lt[Lt].width,lt[Lt].height,Rt,yt,lt[Lt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,0,Tt,lt[Lt].width,lt[Lt].height,0,Rt,yt,lt[Lt].data);for(let ue=0;ue<ee.length;ue++){let Vn=ee[ue].image[Lt].image;Yt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue+1,0,0,Vn.width,Vn.height,Rt,yt,Vn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue+1,Tt,Vn.width,Vn.height,0,Rt,yt,Vn.data)}}else{Yt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,0,0,0,Rt,yt,lt[Lt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,0,Tt,Rt,yt,lt[Lt]);for(let ue=0;ue<ee.length;ue++){let $e=ee[ue];Yt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue+1,0,0,Rt,yt,$e.image[Lt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Lt,ue+1,Tt,Rt,yt,$e.image[Lt])}}}S(M)&&M.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),bt.__version=ct.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function _e(P,M,Y,ft,ct,bt){let St=r.convert(Y.format,Y.colorSpace),it=r.convert(Y.type),at=w(Y.internalFormat,St,it,Y.normalized,Y.colorSpace),gt=i.get(M),z=i.get(Y);if(z.__renderTarget=M,!gt.__hasExternalTextures){let lt=Math.max(1,M.width>>bt),st=Math.max(1,M.height>>bt);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,bt,at,lt,st,M.depth,0,St,it,null):e.texImage2D(ct,bt,at,lt,st,0,St,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),Ct(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ft,ct,z.__webglTexture,0,ce(M)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ft,ct,z.__webglTexture,bt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function ze(P,M,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,P),M.depthBuffer){let ft=M.depthTexture,ct=ft&&ft.isDepthTexture?ft.type:null,bt=x(M.stencilBuffer,ct),St=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ce(M),bt,M.width,M.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,ce(M),bt,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,bt,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,P)}else{let ft=M.textures;for(let ct=0;ct<ft.length;ct++){let bt=ft[ct],St=r.convert(bt.format,bt.colorSpace),it=r.convert(bt.type),at=w(bt.internalFormat,St,it,bt.normalized,bt.colorSpace);Ct(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ce(M),at,M.width,M.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,ce(M),at,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,at,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function he(P,M,Y){let ft=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(M.depthTexture);ct.__renderTarget=M;let bt=ft?M.depthTexture.image[0]:M.depthTexture.image;(!ct.__webglTexture||bt.width!==M.width||bt.height!==M.height)&&(bt.width=M.width,bt.height=M.height,M.depthTexture.needsUpdate=!0),ft?wt(M.depthTexture,0):_t(M.depthTexture,0);let St=ct.__webglTexture,it=ce(M),at=ft?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,gt=M.depthTexture.format===Rs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===ws)Ct(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,at,St,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,gt,at,St,0);else if(M.depthTexture.format===Rs)Ct(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,at,St,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,gt,at,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function We(P){let M=i.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ft=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ft){let ct=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ft.removeEventListener("dispose",ct)};ft.addEventListener("dispose",ct),M.__depthDisposeCallback=ct}M.__boundDepthTexture=ft}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(Y)for(let ft=0;ft<6;ft++)he(M.__webglFramebuffer[ft],P,ft);else P.texture.mipmaps.length>0?he(M.__webglFramebuffer[0],P,0):he(M.__webglFramebuffer,P,0);else if(Y){M.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ft]),M.__webglDepthbuffer[ft]===void 0)M.__webglDepthbuffer[ft]=n.createRenderbuffer(),ze(M.__webglDepthbuffer[ft],P,!1);else{let ct=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=M.__webglDepthbuffer[ft];n.bindRenderbuffer(n.RENDERBUFFER,bt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,bt)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),ze(M.__webglDepthbuffer,P,!1);else{let ct=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,bt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,bt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Qe(P,M,Y){let ft=i.get(P);M!==void 0&&_e(ft.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&We(P)}function rn(P){let M=P.texture,Y=i.get(P),ft=i.get(M);P.addEventListener("dispose",G),B(P);let ct=P.textures,bt=P.isWebGLCubeRenderTarget===!0,St=ct.length>1;if(St||(ft.__webglTexture===void 0&&(ft.__webglTexture=n.createTexture()),ft.__version=M.version,o.memory.textures++),bt){Y.__webglFramebuffer=[];for(let it=0;it<6;it++)if(M.mipmaps.length>0){Y.__webglFramebuffer[it]=[];for(let at=0;at<M.mipmaps.length;at++)Y.__webglFramebuffer[it][at]=n.createFramebuffer()}else Y.__webglFramebuffer[it]=n.createFramebuffer()}else{if(M.mipmaps.length>0){Y.__webglFramebuffer=[];for(let it=0;it<M.mipmaps.length;it++)Y.__webglFramebuffer[it]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(St)for(let it=0,at=ct.length;it<at;it++){let gt=i.get(ct[it]);gt.__webglTexture===void 0&&(gt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Ct(P)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let it=0;it<ct.length;it++){let at=ct[it];Y.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[it]);let gt=r.convert(at.format,at.colorSpace),z=r.convert(at.type),lt=w(at.internalFormat,gt,z,at.normalized,at.colorSpace,P.isXRRenderTarget===!0),st=ce(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,st,lt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,Y.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),ze(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(bt){e.bindTexture(n.TEXTURE_CUBE_MAP,ft.__webglTexture),Ht(n.TEXTURE_CUBE_MAP,M);for(let it=0;it<6;it++)if(M.mipmaps.length>0)for(let at=0;at<M.mipmaps.length;at++)_e(Y.__webglFramebuffer[it][at],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,at);else _e(Y.__webglFramebuffer[it],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);S(M)?b(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(St){for(let it=0,at=ct.length;it<at;it++){let gt=ct[it],z=i.get(gt),lt=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(lt=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,z.__webglTexture),Ht(lt,gt),_e(Y.__webglFramebuffer,P,gt,n.COLOR_ATTACHMENT0+it,lt,0),S(gt)&&b(lt)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(it=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,ft.__webglTexture),Ht(it,M),M.mipmaps.length>0)for(let at=0;at<M.mipmaps.length;at++)_e(Y.__webglFramebuffer[at],P,M,n.COLOR_ATTACHMENT0,it,at);else _e(Y.__webglFramebuffer,P,M,n.COLOR_ATTACHMENT0,it,0);S(M)?b(it):M.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&We(P)}function k(P){let M=P.textures;for(let Y=0,ft=M.length;Y<ft;Y++){let ct=M[Y];if(S(ct)&&ct.mipmapsAutoUpdate===!0){let bt=C(P),St=i.get(ct).__webglTexture;e.bindTexture(bt,St),b(bt),e.unbindTexture()}}}let At=[];function jt(P){if(P.samples>0){if(Ct(P)===!1){let M=P.textures,Y=P.width,ft=P.height,ct=n.COLOR_BUFFER_BIT,bt=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(P),it=M.length>1;if(it)for(let gt=0;gt<M.length;gt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let gt=0;gt<M.length;gt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let z=i.get(M[gt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,Y,ft,0,0,Y,ft,ct,n.NEAREST),l===!0&&(At.length=0,At.push(n.COLOR_ATTACHMENT0+gt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&At.push(bt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,At))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let gt=0;gt<M.length;gt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let z=i.get(M[gt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ce(P){return Math.min(s.maxSamples,P.samples)}function Ct(P){let M=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ve(P){let M=o.render.frame;d.get(P)!==M&&(d.set(P,M),P.update())}function qt(P,M){let Y=P.colorSpace,ft=P.format,ct=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==wa&&Y!==Ps&&(Me.getTransfer(Y)===Ie?(ft!==Gi||ct!==ti)&&Kt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",Y)),M}function Jt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=rt,this.resetTextureUnits=q,this.getTextureUnits=K,this.setTextureUnits=nt,this.setTexture2D=_t,this.setTexture2DArray=mt,this.setTexture3D=xt,this.setTextureCube=wt,this.rebindTextures=Qe,this.setupRenderTarget=rn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=We,this.setupFrameBufferTexture=_e,this.useMultisampledRTT=Ct,this.dispose=$}function N1(n,t){function e(i,s=Ps){let r,o=Me.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===oh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ah)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Xd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===qd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Wd)return n.BYTE;if(i===$d)return n.SHORT;if(i===Bo)return n.UNSIGNED_SHORT;if(i===rh)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===zi)return n.FLOAT;if(i===Vi)return n.HALF_FLOAT;if(i===Yd)return n.ALPHA;if(i===Zd)return n.RGB;if(i===Gi)return n.RGBA;if(i===ws)return n.DEPTH_COMPONENT;if(i===Rs)return n.DEPTH_STENCIL;if(i===Jd)return n.RED;if(i===lh)return n.RED_INTEGER;if(i===or)return n.RG;if(i===ch)return n.RG_INTEGER;if(i===hh)return n.RGBA_INTEGER;if(i===rl||i===ol||i===al||i===ll)if(o===Ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===uh||i===dh||i===fh||i===ph)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===uh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===dh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ph)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===mh||i===gh||i===_h||i===xh||i===yh||i===cl||i===vh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===mh||i===gh)return o===Ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===_h)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===xh)return r.COMPRESSED_R11_EAC;if(i===yh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===cl)return r.COMPRESSED_RG11_EAC;if(i===vh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===bh||i===Sh||i===Mh||i===wh||i===Eh||i===Th||i===Ah||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===bh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Sh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===wh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Eh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Th)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ah)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ch)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Rh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ph)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ih)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Lh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Dh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Nh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Fh||i===Uh||i===Oh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Fh)return o===Ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Oh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Bh||i===kh||i===hl||i===zh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Bh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===kh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===hl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===zh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Tr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var F1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,U1=`
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

}`,vf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Fa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new ls({vertexShader:F1,fragmentShader:U1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Le(new Sr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},bf=class extends Ui{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,d=null,h=null,u=null,f=null,m=null,_=typeof XRWebGLBinding<"u",p=new vf,g={},v=e.getContextAttributes(),S=null,b=null,C=[],w=[],x=new Dt,T=null,B=null,F=new qn;F.viewport=new en;let L=new qn;L.viewport=new en;let G=[F,L],H=new th,N=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let _t=C[tt];return _t===void 0&&(_t=new Co,C[tt]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(tt){let _t=C[tt];return _t===void 0&&(_t=new Co,C[tt]=_t),_t.getGripSpace()},this.getHand=function(tt){let _t=C[tt];return _t===void 0&&(_t=new Co,C[tt]=_t),_t.getHandSpace()};function Z(tt){let _t=w.indexOf(tt.inputSource);if(_t===-1)return;let mt=C[_t];mt!==void 0&&(mt.update(tt.inputSource,tt.frame,c||o),mt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function W(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ut);for(let tt=0;tt<C.length;tt++){let _t=w[tt];_t!==null&&(w[tt]=null,C[tt].disconnect(_t))}N=null,$=null,p.reset();for(let tt in g)delete g[tt];if(t.setRenderTarget(S),f=null,u=null,h=null,s=null,b=null,rt.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(x.width,x.height,!1),B!==null){let tt=B.camera;tt.fov=B.fov,tt.zoom=B.zoom,tt.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Kt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Kt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ut),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let mt=null,xt=null,wt=null;v.depth&&(wt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,mt=v.stencil?Rs:ws,xt=v.stencil?Tr:ki);let ot={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};h=this.getBinding(),u=h.createProjectionLayer(ot),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),b=new fi(u.textureWidth,u.textureHeight,{format:Gi,type:ti,depthTexture:new Ts(u.textureWidth,u.textureHeight,xt,void 0,void 0,void 0,void 0,void 0,void 0,mt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let mt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,mt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new fi(f.framebufferWidth,f.framebufferHeight,{format:Gi,type:ti,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),rt.setContext(s),rt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ut(tt){for(let _t=0;_t<tt.removed.length;_t++){let mt=tt.removed[_t],xt=w.indexOf(mt);xt>=0&&(w[xt]=null,C[xt].disconnect(mt))}for(let _t=0;_t<tt.added.length;_t++){let mt=tt.added[_t],xt=w.indexOf(mt);if(xt===-1){for(let ot=0;ot<C.length;ot++)if(ot>=w.length){w.push(mt),xt=ot;break}else if(w[ot]===null){w[ot]=mt,xt=ot;break}if(xt===-1)break}let wt=C[xt];wt&&wt.connect(mt)}}function D(tt,_t){_t===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(_t.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let _t=tt.near,mt=tt.far;p.texture!==null&&(p.depthNear>0&&(_t=p.depthNear),p.depthFar>0&&(mt=p.depthFar)),H.near=L.near=F.near=_t,H.far=L.far=F.far=mt,(N!==H.near||$!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,$=H.far),H.layers.mask=tt.layers.mask|6,F.layers.mask=H.layers.mask&-5,L.layers.mask=H.layers.mask&-3;let xt=tt.parent,wt=H.cameras;D(H,xt);for(let ot=0;ot<wt.length;ot++)D(wt[ot],xt);H.projectionMatrix.copy(F.projectionMatrix),H.projectionMatrixInverse.copy(F.projectionMatrixInverse),B===null&&tt.isPerspectiveCamera&&(B={camera:tt,fov:tt.fov,zoom:tt.zoom}),q(tt,H,xt)};function q(tt,_t,mt){mt===null?tt.matrix.copy(_t.matrixWorld):(tt.matrix.copy(mt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(_t.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(_t.projectionMatrix),tt.projectionMatrixInverse.copy(_t.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Eo*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(tt){l=tt,u!==null&&(u.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(tt){return g[tt]};let K=null;function nt(tt,_t){if(d=_t.getViewerPose(c||o),m=_t,d!==null){let mt=d.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let xt=!1;mt.length!==H.cameras.length&&(H.cameras.length=0,xt=!0);for(let vt=0;vt<mt.length;vt++){let Ht=mt[vt],Bt=null;if(f!==null)Bt=f.getViewport(Ht);else{let ge=h.getViewSubImage(u,Ht);Bt=ge.viewport,vt===0&&(t.setRenderTargetTextures(b,ge.colorTexture,ge.depthStencilTexture),t.setRenderTarget(b))}let zt=G[vt];zt===void 0&&(zt=new qn,zt.layers.enable(vt),zt.viewport=new en,G[vt]=zt),zt.matrix.fromArray(Ht.transform.matrix),zt.matrix.decompose(zt.position,zt.quaternion,zt.scale),zt.projectionMatrix.fromArray(Ht.projectionMatrix),zt.projectionMatrixInverse.copy(zt.projectionMatrix).invert(),zt.viewport.set(Bt.x,Bt.y,Bt.width,Bt.height),vt===0&&(H.matrix.copy(zt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),xt===!0&&H.cameras.push(zt)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let vt=h.getDepthInformation(mt[0]);vt&&vt.isValid&&vt.texture&&p.init(vt,s.renderState)}if(wt&&wt.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let vt=0;vt<mt.length;vt++){let Ht=mt[vt].camera;if(Ht){let Bt=g[Ht];Bt||(Bt=new Fa,g[Ht]=Bt);let zt=h.getCameraImage(Ht);Bt.sourceTexture=zt}}}}for(let mt=0;mt<C.length;mt++){let xt=w[mt],wt=C[mt];xt!==null&&wt!==void 0&&wt.update(xt,_t,c||o)}K&&K(tt,_t),_t.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_t}),m=null}let rt=new c0;rt.setAnimationLoop(nt),this.setAnimationLoop=function(tt){K=tt},this.dispose=function(){}}},O1=new Be,y0=new oe;y0.set(-1,0,0,0,1,0,0,0,1);function B1(n,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,lf(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,v,S,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),h(p,g)):g.isMeshPhongMaterial?(r(p,g),d(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),u(p,g),g.isMeshPhysicalMaterial&&f(p,g,b)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),_(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,v,S):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===Zn&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===Zn&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let v=t.get(g),S=v.envMap,b=v.envMapRotation;S&&(p.envMap.value=S,p.envMapRotation.value.setFromMatrix4(O1.makeRotationFromEuler(b)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(y0),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,v,S){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*v,p.scale.value=S*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function d(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function h(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function u(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,v){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Zn&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function _(p,g){let v=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function k1(n,t,e,i){let s={},r={};function o(v,S){let b=S.program;i.uniformBlockBinding(v,b,s[v.id])}function a(v,S){let b=s[v.id];b===void 0&&(m(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",p));let C=S.program;i.updateUBOMapping(v,C);let w=t.render.frame;r[v.id]!==w&&(c(v),r[v.id]=w)}function l(v){let S=n.createBuffer(),b=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function c(v){let S=s[v.id],b=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let w=0,x=b.length;w<x;w++){let T=b[w];if(Array.isArray(T))for(let B=0,F=T.length;B<F;B++)d(T[B],w,B,C);else d(T,w,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(v,S,b,C){if(u(v,S,b,C)===!0){let w=v.__offset,x=v.value;if(Array.isArray(x)){let T=0;for(let B=0;B<x.length;B++){let F=x[B],L=_(F,!0);h(F,v.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,v.__data)}}function h(v,S,b){typeof v=="number"||typeof v=="boolean"?S[b]=v:v.isMatrix3?(S[b]=v.elements[0],S[b+1]=v.elements[1],S[b+2]=v.elements[2],S[b+3]=0,S[b+4]=v.elements[3],S[b+5]=v.elements[4],S[b+6]=v.elements[5],S[b+7]=0,S[b+8]=v.elements[6],S[b+9]=v.elements[7],S[b+10]=v.elements[8],S[b+11]=0):ArrayBuffer.isView(v)?S.set(v.subarray(0,S.length-b),b):v.toArray(S,b)}function u(v,S,b,C){let w=v.value,x=S+"_"+b;if(Array.isArray(w)){C[x]===void 0&&(C[x]=[]);let T=C[x],B=!1;for(let F=0;F<w.length;F++)f(w[F],T,F)===!0&&(B=!0);return B}return f(w,C,x)}function f(v,S,b){if(S[b]===void 0)return typeof v=="number"||typeof v=="boolean"?S[b]=v:ArrayBuffer.isView(v)?S[b]=v.slice():S[b]=v.clone(),!0;{let C=S[b];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return S[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function m(v){let S=v.uniforms,b=0,C=16;for(let x=0,T=S.length;x<T;x++){let B=Array.isArray(S[x])?S[x]:[S[x]];for(let F=0,L=B.length;F<L;F++){let G=B[F],H=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(S[x])||Array.isArray(G.value),$=b;for(let W=0,ut=H.length;W<ut;W++){let D=H[W],q=_(D,N),K=b%C,nt=K%q.boundary,rt=K+nt;b+=nt,rt!==0&&C-rt<q.storage&&(b+=C-rt),W===0&&($=b),b+=q.storage}let Z=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Z((b-$)/Float32Array.BYTES_PER_ELEMENT),G.__offset=$}}let w=b%C;return w>0&&(b+=C-w),v.__size=b,v.__cache={},this}function _(v,S){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Kt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Kt("WebGLRenderer: Unsupported uniform value type.",v),S===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(v){let S=v.target;S.removeEventListener("dispose",p),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var z1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),hs=null;function V1(){return hs===null&&(hs=new Pc(z1,16,16,or,Vi),hs.name="DFG_LUT",hs.minFilter=Yn,hs.magFilter=Yn,hs.wrapS=rs,hs.wrapT=rs,hs.generateMipmaps=!1,hs.needsUpdate=!0),hs}var $h=class{constructor(t={}){let{canvas:e=Cg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:d="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ti}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let _=f,p=new Set([hh,ch,lh]),g=new Set([ti,ki,Bo,Tr,oh,ah]),v=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,w=null,x=[],T=[],B=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,L=!1,G=null,H=null,N=null,$=null;this._outputColorSpace=ui;let Z=0,W=0,ut=null,D=-1,q=null,K=new en,nt=new en,rt=null,tt=new le(0),_t=0,mt=e.width,xt=e.height,wt=1,ot=null,Et=null,vt=new en(0,0,mt,xt),Ht=new en(0,0,mt,xt),Bt=!1,zt=new Ks,ge=new Ic,fe=!1,Ne=!1,_e=new Be,ze=new O,he=new en,We={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qe=!1;function rn(){return ut===null?wt:1}let k=i;function At(A,V){return e.getContext(A,V)}let jt,ce,Ct,Ve,qt,Jt,P,M,Y,ft,ct,bt,St,it,at,gt,z,lt,st,Rt,yt,Tt,Yt;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:d,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Wt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Lt,!1),k===null){let V="webgl2";if(k=At(V,A),k===null)throw At(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(A){throw e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Lt,!1),ie("WebGLRenderer: "+A.message),A}function te(){jt=new jM(k),jt.init(),yt=new N1(k,jt),ce=new VM(k,jt,t,yt),Ct=new L1(k,jt),ce.reversedDepthBuffer&&u&&Ct.buffers.depth.setReversed(!0),H=k.createFramebuffer(),N=k.createFramebuffer(),$=k.createFramebuffer(),Ve=new ew(k),qt=new x1,Jt=new D1(k,jt,Ct,qt,ce,yt,Ve),P=new KM(F),M=new ib(k),Tt=new kM(k,M),Y=new QM(k,M,Ve,Tt),ft=new iw(k,Y,M,Tt,Ve),lt=new nw(k,ce,Jt),at=new GM(qt),ct=new _1(F,P,jt,ce,Tt,at),bt=new B1(F,qt),St=new v1,it=new T1(jt),z=new BM(F,P,Ct,ft,m,l),gt=new I1(F,ft,ce),Yt=new k1(k,Ve,ce,Ct),st=new zM(k,jt,Ve),Rt=new tw(k,jt,Ve),Ve.programs=ct.programs,F.capabilities=ce,F.extensions=jt,F.properties=qt,F.renderLists=St,F.shadowMap=gt,F.state=Ct,F.info=Ve}_!==ti&&(B=new rw(_,e.width,e.height,a,s,r));let dt=new bf(F,k);this.xr=dt,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let A=jt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=jt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(A){A!==void 0&&(wt=A,this.setSize(mt,xt,!1))},this.getSize=function(A){return A.set(mt,xt)},this.setSize=function(A,V,et=!0){if(dt.isPresenting){Kt("WebGLRenderer: Can't change size while VR device is presenting.");return}mt=A,xt=V,e.width=Math.floor(A*wt),e.height=Math.floor(V*wt),et===!0&&(e.style.width=A+"px",e.style.height=V+"px"),B!==null&&B.setSize(e.width,e.height),this.setViewport(0,0,A,V)},this.getDrawingBufferSize=function(A){return A.set(mt*wt,xt*wt).floor()},this.setDrawingBufferSize=function(A,V,et){mt=A,xt=V,wt=et,e.width=Math.floor(A*et),e.height=Math.floor(V*et),this.setViewport(0,0,A,V)},this.setEffects=function(A){if(_===ti){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let V=0;V<A.length;V++)if(A[V].isOutputPass===!0){Kt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(K)},this.getViewport=function(A){return A.copy(vt)},this.setViewport=function(A,V,et,J){A.isVector4?vt.set(A.x,A.y,A.z,A.w):vt.set(A,V,et,J),Ct.viewport(K.copy(vt).multiplyScalar(rn()).round())},this.getScissor=function(A){return A.copy(Ht)},this.setScissor=function(A,V,et,J){A.isVector4?Ht.set(A.x,A.y,A.z,A.w):Ht.set(A,V,et,J),Ct.scissor(nt.copy(Ht).multiplyScalar(rn()).round())},this.getScissorTest=function(){return Bt},this.setScissorTest=function(A){Ct.setScissorTest(Bt=A)},this.setOpaqueSort=function(A){ot=A},this.setTransparentSort=function(A){Et=A},this.getClearColor=function(A){return A.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(A=!0,V=!0,et=!0){let J=0;if(A){let j=!1;if(ut!==null){let Pt=ut.texture.format;j=p.has(Pt)}if(j){let Pt=ut.texture.type,Nt=g.has(Pt),It=z.getClearColor(),Ft=z.getClearAlpha(),Xt=It.r,se=It.g,xe=It.b;Nt?(v[0]=Xt,v[1]=se,v[2]=xe,v[3]=Ft,k.clearBufferuiv(k.COLOR,0,v)):(S[0]=Xt,S[1]=se,S[2]=xe,S[3]=Ft,k.clearBufferiv(k.COLOR,0,S))}else J|=k.COLOR_BUFFER_BIT}V&&(J|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(J|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&k.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),G=A},this.dispose=function(){e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Lt,!1),z.dispose(),St.dispose(),it.dispose(),Jt.dispose(),qt.dispose(),P.dispose(),ft.dispose(),Y.dispose(),Tt.dispose(),Yt.dispose(),ct.dispose(),dt.dispose(),dt.removeEventListener("sessionstart",Al),dt.removeEventListener("sessionend",Yi),fs.stop()};function Wt(A){A.preventDefault(),ef("WebGLRenderer: Context Lost."),L=!0}function ee(){ef("WebGLRenderer: Context Restored."),L=!1;let A=Ve.autoReset,V=gt.enabled,et=gt.autoUpdate,J=gt.needsUpdate,j=gt.type;te(),Ve.autoReset=A,gt.enabled=V,gt.autoUpdate=et,gt.needsUpdate=J,gt.type=j}function Lt(A){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ue(A){let V=A.target;V.removeEventListener("dispose",ue),$e(V)}function $e(A){Vn(A),qt.remove(A)}function Vn(A){let V=qt.get(A).programs;V!==void 0&&(V.forEach(function(et){ct.releaseProgram(et)}),A.isShaderMaterial&&ct.releaseShaderCache(A))}this.renderBufferDirect=function(A,V,et,J,j,Pt){V===null&&(V=We);let Nt=j.isMesh&&j.matrixWorld.determinantAffine()<0,It=sa(A,V,et,J,j);Ct.setMaterial(J,Nt);let Ft=et.index,Xt=1;if(J.wireframe===!0){if(Ft=Y.getWireframeAttribute(et),Ft===void 0)return;Xt=2}let se=et.drawRange,xe=et.attributes.position,$t=se.start*Xt,ye=(se.start+se.count)*Xt;Pt!==null&&($t=Math.max($t,Pt.start*Xt),ye=Math.min(ye,(Pt.start+Pt.count)*Xt)),Ft!==null?($t=Math.max($t,0),ye=Math.min(ye,Ft.count)):xe!=null&&($t=Math.max($t,0),ye=Math.min(ye,xe.count));let nn=ye-$t;if(nn<0||nn===1/0)return;Tt.setup(j,J,It,et,Ft);let Fe,Ue=st;if(Ft!==null&&(Fe=M.get(Ft),Ue=Rt,Ue.setIndex(Fe)),j.isMesh)J.wireframe===!0?(Ct.setLineWidth(J.wireframeLinewidth*rn()),Ue.setMode(k.LINES)):Ue.setMode(k.TRIANGLES);else if(j.isLine){let yn=J.linewidth;yn===void 0&&(yn=1),Ct.setLineWidth(yn*rn()),j.isLineSegments?Ue.setMode(k.LINES):j.isLineLoop?Ue.setMode(k.LINE_LOOP):Ue.setMode(k.LINE_STRIP)}else j.isPoints?Ue.setMode(k.POINTS):j.isSprite&&Ue.setMode(k.TRIANGLES);if(j.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))Ue.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let yn=j._multiDrawStarts,Vt=j._multiDrawCounts,fn=j._multiDrawCount,Se=Ft?M.get(Ft).bytesPerElement:1,ms=qt.get(J).currentProgram.getUniforms();for(let pn=0;pn<fn;pn++)ms.setValue(k,"_gl_DrawID",pn),Ue.render(yn[pn]/Se,Vt[pn])}else if(j.isInstancedMesh)Ue.renderInstances($t,nn,j.count);else if(et.isInstancedBufferGeometry){let yn=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Vt=Math.min(et.instanceCount,yn);Ue.renderInstances($t,nn,Vt)}else Ue.render($t,nn)};function ea(A,V,et,J){G!==null&&A.isNodeMaterial&&G.setObject(J,A),fe===!0&&at.setState(A,et,!1),A.transparent===!0&&A.side===Ei&&A.forceSinglePass===!1?(A.side=Zn,A.needsUpdate=!0,Zi(A,V,J),A.side=rr,A.needsUpdate=!0,Zi(A,V,J),A.side=Ei):Zi(A,V,J)}this.compile=function(A,V,et=null){et===null&&(et=A),G!==null&&G.renderStart(A,V,et),w=it.get(et),w.init(V),T.push(w),et.traverseVisible(function(j){j.isLight&&j.layers.test(V.layers)&&(w.pushLight(j),j.castShadow&&w.pushShadow(j))}),A!==et&&A.traverseVisible(function(j){j.isLight&&j.layers.test(V.layers)&&(w.pushLight(j),j.castShadow&&w.pushShadow(j))}),w.setupLights(),G!==null&&G.updateLights(w.state.lightsArray),Ne=this.localClippingEnabled,fe=at.init(this.clippingPlanes,Ne),fe===!0&&at.setGlobalState(this.clippingPlanes,V),G!==null&&gt.render(w.state.shadowsArray,et,V);let J=new Set;return A.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Pt=j.material;if(Pt)if(Array.isArray(Pt))for(let Nt=0;Nt<Pt.length;Nt++){let It=Pt[Nt];ea(It,et,V,j),J.add(It)}else ea(Pt,et,V,j),J.add(Pt)}),w=T.pop(),G!==null&&G.renderEnd(),J},this.compileAsync=function(A,V,et=null){let J=this.compile(A,V,et);return new Promise(j=>{function Pt(){if(J.forEach(function(Nt){let Ft=qt.get(Nt).currentProgram;(Ft===void 0||Ft.isReady())&&J.delete(Nt)}),J.size===0){j(A);return}setTimeout(Pt,10)}jt.get("KHR_parallel_shader_compile")!==null?Pt():setTimeout(Pt,10)})};let Ur=null;function Au(A){Ur&&Ur(A)}function Al(){fs.stop()}function Yi(){fs.start()}let fs=new c0;fs.setAnimationLoop(Au),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(A){Ur=A,dt.setAnimationLoop(A),A===null?fs.stop():fs.start()},dt.addEventListener("sessionstart",Al),dt.addEventListener("sessionend",Yi),this.render=function(A,V){if(V!==void 0&&V.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(A,V);let et=dt.enabled===!0&&dt.isPresenting===!0,J=B!==null&&(ut===null||et)&&B.begin(F,ut);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),dt.enabled===!0&&dt.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(dt.cameraAutoUpdate===!0&&dt.updateCamera(V),V=dt.getCamera()),A.isScene===!0&&A.onBeforeRender(F,A,V,ut),w=it.get(A,T.length),w.init(V),w.state.textureUnits=Jt.getTextureUnits(),T.push(w),_e.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?ge.setFromArrayCamera(V):zt.setFromProjectionMatrix(_e,Mi,V.reversedDepth),Ne=this.localClippingEnabled,fe=at.init(this.clippingPlanes,Ne),C=St.get(A,x.length),C.init(),x.push(C),this.info.render.frame++,dt.enabled===!0&&dt.isPresenting===!0){let Nt=F.xr.getDepthSensingMesh();Nt!==null&&ps(Nt,V,-1/0,F.sortObjects)}ps(A,V,0,F.sortObjects),C.finish(),G!==null&&G.updateLights(w.state.lightsArray),F.sortObjects===!0&&C.sort(ot,Et),Qe=dt.enabled===!1||dt.isPresenting===!1||dt.hasDepthSensing()===!1,Qe&&z.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),fe===!0&&at.beginShadows();let j=w.state.shadowsArray;if(gt.render(j,A,V),fe===!0&&at.endShadows(),(J&&B.hasRenderPass())===!1){let Nt=C.opaque,It=C.transmissive;if(w.setupLights(),V.isArrayCamera){let Ft=V.cameras;if(It.length>0)for(let Xt=0,se=Ft.length;Xt<se;Xt++){let xe=Ft[Xt];Ci(Nt,It,A,xe)}Qe&&z.render(A);for(let Xt=0,se=Ft.length;Xt<se;Xt++){let xe=Ft[Xt];na(C,A,xe,xe.viewport)}}else It.length>0&&Ci(Nt,It,A,V),Qe&&z.render(A),na(C,A,V)}ut!==null&&W===0&&(Jt.updateMultisampleRenderTarget(ut),Jt.updateRenderTargetMipmap(ut)),J&&B.end(F),A.isScene===!0&&A.onAfterRender(F,A,V),Tt.resetDefaultState(),D=-1,q=null,T.pop(),T.length>0?(w=T[T.length-1],Jt.setTextureUnits(w.state.textureUnits),fe===!0&&at.setGlobalState(F.clippingPlanes,w.state.camera)):w=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,G!==null&&G.renderEnd()};function ps(A,V,et,J){if(A.visible===!1)return;if(A.layers.test(V.layers)){if(A.isGroup)et=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(V);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){let Nt=V.isArrayCamera?ge:zt;if(!A.frustumCulled||A.intersectsFrustum(Nt)){J&&he.setFromMatrixPosition(A.matrixWorld).applyMatrix4(_e);let It=ft.update(A),Ft=A.material;Ft.visible&&C.push(A,It,Ft,et,he.z,null,V)}}else if(A.isMesh||A.isLine||A.isPoints){let Nt=V.isArrayCamera?ge:zt;if(!A.frustumCulled||A.intersectsFrustum(Nt)){let It=ft.update(A),Ft=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),he.copy(A.boundingSphere.center)):(It.boundingSphere===null&&It.computeBoundingSphere(),he.copy(It.boundingSphere.center)),he.applyMatrix4(A.matrixWorld).applyMatrix4(_e)),Array.isArray(Ft)){let Xt=It.groups;for(let se=0,xe=Xt.length;se<xe;se++){let $t=Xt[se],ye=Ft[$t.materialIndex];ye&&ye.visible&&C.push(A,It,ye,et,he.z,$t,V)}}else Ft.visible&&C.push(A,It,Ft,et,he.z,null,V)}}}let Pt=A.children;for(let Nt=0,It=Pt.length;Nt<It;Nt++)ps(Pt[Nt],V,et,J)}function na(A,V,et,J){let{opaque:j,transmissive:Pt,transparent:Nt}=A;w.setupLightsView(et),fe===!0&&at.setGlobalState(F.clippingPlanes,et),J&&Ct.viewport(K.copy(J)),j.length>0&&on(j,V,et),Pt.length>0&&on(Pt,V,et),Nt.length>0&&on(Nt,V,et),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function Ci(A,V,et,J){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[J.id]===void 0){let $t=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[J.id]=new fi(1,1,{generateMipmaps:!0,type:$t?Vi:ti,minFilter:Cs,samples:Math.max(4,ce.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Me.workingColorSpace})}let Pt=w.state.transmissionRenderTarget[J.id],Nt=J.viewport||K;Pt.setSize(Nt.z*F.transmissionResolutionScale,Nt.w*F.transmissionResolutionScale);let It=F.getRenderTarget(),Ft=F.getActiveCubeFace(),Xt=F.getActiveMipmapLevel();F.setRenderTarget(Pt),F.getClearColor(tt),_t=F.getClearAlpha(),_t<1&&F.setClearColor(16777215,.5),F.clear(),Qe&&z.render(et);let se=F.toneMapping;F.toneMapping=cs;let xe=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),w.setupLightsView(J),fe===!0&&at.setGlobalState(F.clippingPlanes,J),on(A,et,J),Jt.updateMultisampleRenderTarget(Pt),Jt.updateRenderTargetMipmap(Pt),jt.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let ye=0,nn=V.length;ye<nn;ye++){let Fe=V[ye],{object:Ue,geometry:yn,material:Vt,group:fn}=Fe;if(Vt.side===Ei&&Ue.layers.test(J.layers)){let Se=Vt.side;Vt.side=Zn,Vt.needsUpdate=!0,un(Ue,et,J,yn,Vt,fn),Vt.side=Se,Vt.needsUpdate=!0,$t=!0}}$t===!0&&(Jt.updateMultisampleRenderTarget(Pt),Jt.updateRenderTargetMipmap(Pt))}F.setRenderTarget(It,Ft,Xt),F.setClearColor(tt,_t),xe!==void 0&&(J.viewport=xe),F.toneMapping=se}function on(A,V,et){let J=V.isScene===!0?V.overrideMaterial:null;for(let j=0,Pt=A.length;j<Pt;j++){let Nt=A[j],{object:It,geometry:Ft,group:Xt}=Nt,se=Nt.material;se.allowOverride===!0&&J!==null&&(se=J),It.layers.test(et.layers)&&un(It,V,et,Ft,se,Xt)}}function un(A,V,et,J,j,Pt){G!==null&&j.isNodeMaterial&&G.setObject(A,j),A.onBeforeRender(F,V,et,J,j,Pt),A.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),j.onBeforeRender(F,V,et,J,A,Pt),j.transparent===!0&&j.side===Ei&&j.forceSinglePass===!1?(j.side=Zn,j.needsUpdate=!0,F.renderBufferDirect(et,V,J,j,A,Pt),j.side=rr,j.needsUpdate=!0,F.renderBufferDirect(et,V,J,j,A,Pt),j.side=Ei):F.renderBufferDirect(et,V,J,j,A,Pt),A.onAfterRender(F,V,et,J,j,Pt)}function dn(A){let V=0;for(let et of A)et.texture!==null&&V++;return V}function Zi(A,V,et){V.isScene!==!0&&(V=We);let J=qt.get(A),j=w.state.lights,Pt=w.state.shadowsArray,Nt=j.state.version,It=ct.getParameters(A,j.state,Pt,V,et,w.state.lightProbeGridArray),Ft=ct.getProgramCacheKey(It),Xt=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?V.environment:null,J.fog=V.fog;let se=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=P.get(A.envMap||J.environment,se),J.envMapRotation=J.environment!==null&&A.envMap===null?V.environmentRotation:A.envMapRotation,Xt===void 0&&(A.addEventListener("dispose",ue),Xt=new Map,J.programs=Xt,J.programVariants=new Map);let xe=Xt.get(Ft);if(xe!==void 0){if(J.currentProgram===xe&&J.lightsStateVersion===Nt)return ia(A,It),xe}else It.uniforms=ct.getUniforms(A),G!==null&&A.isNodeMaterial&&G.build(A,et,It),A.onBeforeCompile(It,F),xe=ct.acquireProgram(It,Ft),Xt.set(Ft,xe),J.uniforms=It.uniforms;let $t=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&($t.clippingPlanes=at.uniform),ia(A,It),J.needsLights=Us(A),J.lightsStateVersion=Nt,J.needsLights&&($t.ambientLightColor.value=j.state.ambient,$t.lightProbe.value=j.state.probe,$t.sunLights.value=j.state.sun,$t.sunLightShadows.value=j.state.sunShadow,$t.directionalLights.value=j.state.directional,$t.directionalLightShadows.value=j.state.directionalShadow,$t.spotLights.value=j.state.spot,$t.spotLightShadows.value=j.state.spotShadow,$t.rectAreaLights.value=j.state.rectArea,$t.ltc_1.value=j.state.rectAreaLTC1,$t.ltc_2.value=j.state.rectAreaLTC2,$t.pointLights.value=j.state.point,$t.pointLightShadows.value=j.state.pointShadow,$t.hemisphereLights.value=j.state.hemi,$t.sunShadowMatrix.value=j.state.sunShadowMatrix,$t.sunShadowCascade.value=j.state.sunShadowCascade,$t.directionalShadowMatrix.value=j.state.directionalShadowMatrix,$t.spotLightMatrix.value=j.state.spotLightMatrix,$t.spotLightMap.value=j.state.spotLightMap,$t.pointShadowMatrix.value=j.state.pointShadowMatrix),J.numLightProbeGrids=dn(w.state.lightProbeGridArray),J.currentProgram=xe,J.uniformsList=null,xe}function ii(A,V,et,J,j){let Pt=qt.get(A),Nt=Pt.currentProgram.id+","+J+","+j,It=Pt.programVariants.get(Nt);return It===void 0?(It=Zi(A,V,et),Pt.programVariants.set(Nt,It)):(Pt.currentProgram=It,Pt.uniformsList=null,Pt.outputColorSpace=J,Pt.toneMapping=j),It}function Fs(A){if(A.uniformsList===null){let V=A.currentProgram.getUniforms();A.uniformsList=ko.seqWithValue(V.seq,A.uniforms)}return A.uniformsList}function ia(A,V){let et=qt.get(A);et.outputColorSpace=V.outputColorSpace,et.batching=V.batching,et.batchingColor=V.batchingColor,et.instancing=V.instancing,et.instancingColor=V.instancingColor,et.instancingMorph=V.instancingMorph,et.skinning=V.skinning,et.morphTargets=V.morphTargets,et.morphNormals=V.morphNormals,et.morphColors=V.morphColors,et.morphTargetsCount=V.morphTargetsCount,et.numClippingPlanes=V.numClippingPlanes,et.numIntersection=V.numClipIntersection,et.vertexAlphas=V.vertexAlphas,et.vertexTangents=V.vertexTangents,et.toneMapping=V.toneMapping}function sa(A,V,et,J,j){V.isScene!==!0&&(V=We),Jt.resetTextureUnits();let Pt=V.fog,Nt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?V.environment:null,It=ut===null?F.outputColorSpace:ut.isXRRenderTarget===!0?ut.texture.colorSpace:Me.workingColorSpace,Ft=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Xt=P.get(J.envMap||Nt,Ft),se=J.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,xe=!!et.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),$t=!!et.morphAttributes.position,ye=!!et.morphAttributes.normal,nn=!!et.morphAttributes.color,Fe=cs;J.toneMapped&&(ut===null||ut.isXRRenderTarget===!0)&&(Fe=F.toneMapping);let Ue=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,yn=Ue!==void 0?Ue.length:0,Vt=qt.get(J),fn=w.state.lights;if(fe===!0&&(Ne===!0||A!==q)){let Oe=A===q&&J.id===D;at.setState(J,A,Oe)}let Se=!1,ms=!1;J.version===Vt.__version?Vt.needsLights&&Vt.lightsStateVersion!==fn.state.version||j.isBatchedMesh&&Vt.batching===!1||!j.isBatchedMesh&&Vt.batching===!0||j.isBatchedMesh&&Vt.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Vt.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Vt.instancing===!1||!j.isInstancedMesh&&Vt.instancing===!0||j.isSkinnedMesh&&Vt.skinning===!1||!j.isSkinnedMesh&&Vt.skinning===!0||j.isInstancedMesh&&Vt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Vt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Vt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Vt.instancingMorph===!1&&j.morphTexture!==null||Vt.envMap!==Xt||J.fog===!0&&Vt.fog!==Pt||Vt.numClippingPlanes!==void 0&&(Vt.numClippingPlanes!==at.numPlanes||Vt.numIntersection!==at.numIntersection)||Vt.vertexAlphas!==se||Vt.vertexTangents!==xe||Vt.morphTargets!==$t||Vt.morphNormals!==ye||Vt.morphColors!==nn||Vt.morphTargetsCount!==yn||Vt.numLightProbeGrids!==dn(w.state.lightProbeGridArray)?Se=!0:(Vt.outputColorSpace!==It||Vt.toneMapping!==Fe)&&(ms=!0):(Se=!0,Vt.__version=J.version);let pn=Vt.currentProgram;(Se===!0||ms===!0)&&(pn=ms===!0?ii(J,V,j,It,Fe):Zi(J,V,j),G&&J.isNodeMaterial&&G.onUpdateProgram(J,pn,Vt));let kr=!1,Ji=!1,gs=!1,pe=pn.getUniforms(),an=Vt.uniforms;if(Ct.useProgram(pn.program)&&(kr=!0,Ji=!0,gs=!0),J.id!==D&&(D=J.id,Ji=!0),kr||q!==A){Ct.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),pe.setValue(k,"projectionMatrix",A.projectionMatrix),pe.setValue(k,"viewMatrix",A.matrixWorldInverse);let mn=pe.map.cameraPosition;mn!==void 0&&mn.setValue(k,ze.setFromMatrixPosition(A.matrixWorld)),ce.logarithmicDepthBuffer&&pe.setValue(k,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&pe.setValue(k,"isOrthographic",A.isOrthographicCamera===!0),q!==A&&(q=A,Ji=!0,gs=!0)}if(Vt.needsLights&&(fn.state.sunShadowMap.length>0&&pe.setValue(k,"sunShadowMap",fn.state.sunShadowMap,Jt),fn.state.directionalShadowMap.length>0&&pe.setValue(k,"directionalShadowMap",fn.state.directionalShadowMap,Jt),fn.state.spotShadowMap.length>0&&pe.setValue(k,"spotShadowMap",fn.state.spotShadowMap,Jt),fn.state.pointShadowMap.length>0&&pe.setValue(k,"pointShadowMap",fn.state.pointShadowMap,Jt)),j.isSkinnedMesh){pe.setOptional(k,j,"bindMatrix"),pe.setOptional(k,j,"bindMatrixInverse");let Oe=j.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),pe.setValue(k,"boneTexture",Oe.boneTexture,Jt))}j.isBatchedMesh&&(pe.setOptional(k,j,"batchingTexture"),pe.setValue(k,"batchingTexture",j._matricesTexture,Jt),pe.setOptional(k,j,"batchingIdTexture"),pe.setValue(k,"batchingIdTexture",j._indirectTexture,Jt),pe.setOptional(k,j,"batchingColorTexture"),j._colorsTexture!==null&&pe.setValue(k,"batchingColorTexture",j._colorsTexture,Jt));let Gn=et.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&lt.update(j,et,pn),(Ji||Vt.receiveShadow!==j.receiveShadow)&&(Vt.receiveShadow=j.receiveShadow,pe.setValue(k,"receiveShadow",j.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&V.environment!==null&&(an.envMapIntensity.value=V.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=V1()),Ji){if(pe.setValue(k,"toneMappingExposure",F.toneMappingExposure),Vt.needsLights&&Or(an,gs),Pt&&J.fog===!0&&bt.refreshFogUniforms(an,Pt),bt.refreshMaterialUniforms(an,J,wt,xt,w.state.transmissionRenderTarget[A.id]),Vt.needsLights&&Vt.numLightProbeGrids>0){let Oe=b,mn=0;for(let Un of w.state.lightProbeGridArray)Un.texture!==null&&(Oe.textures[mn]=Un.texture,Oe.min[mn]=Un.boundingBox.min,Oe.max[mn]=Un.boundingBox.max,Oe.resolution[mn]=Un.resolution,mn++);for(let Un in Oe)Oe[Un].length=mn;an.probesSH.value=Oe.textures,an.probesMin.value=Oe.min,an.probesMax.value=Oe.max,an.probesResolution.value=Oe.resolution}ko.upload(k,Fs(Vt),an,Jt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(ko.upload(k,Fs(Vt),an,Jt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&pe.setValue(k,"center",j.center),pe.setValue(k,"modelViewMatrix",j.modelViewMatrix),pe.setValue(k,"normalMatrix",j.normalMatrix),pe.setValue(k,"modelMatrix",j.matrixWorld),J.uniformsGroups!==void 0){let Oe=J.uniformsGroups;for(let mn=0,Un=Oe.length;mn<Un;mn++){let Cl=Oe[mn];Yt.update(Cl,pn),Yt.bind(Cl,pn)}}return pn}function Or(A,V){A.ambientLightColor.needsUpdate=V,A.lightProbe.needsUpdate=V,A.sunLights.needsUpdate=V,A.sunLightShadows.needsUpdate=V,A.directionalLights.needsUpdate=V,A.directionalLightShadows.needsUpdate=V,A.pointLights.needsUpdate=V,A.pointLightShadows.needsUpdate=V,A.spotLights.needsUpdate=V,A.spotLightShadows.needsUpdate=V,A.rectAreaLights.needsUpdate=V,A.hemisphereLights.needsUpdate=V}function Us(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ut},this.setRenderTargetTextures=function(A,V,et){let J=qt.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),qt.get(A.texture).__webglTexture=V,qt.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:et,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,V){let et=qt.get(A);et.__webglFramebuffer=V,et.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(A,V=0,et=0){ut=A,Z=V,W=et;let J=null,j=!1,Pt=!1;if(A){let It=qt.get(A);if(It.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(k.FRAMEBUFFER,It.__webglFramebuffer),K.copy(A.viewport),nt.copy(A.scissor),rt=A.scissorTest,Ct.viewport(K),Ct.scissor(nt),Ct.setScissorTest(rt),D=-1;return}else if(It.__webglFramebuffer===void 0)Jt.setupRenderTarget(A);else if(It.__hasExternalTextures)Jt.rebindTextures(A,qt.get(A.texture).__webglTexture,qt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let se=A.depthTexture;if(It.__boundDepthTexture!==se){if(se!==null&&qt.has(se)&&(A.width!==se.image.width||A.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Jt.setupDepthRenderbuffer(A)}}let Ft=A.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Pt=!0);let Xt=qt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Xt[V])?J=Xt[V][et]:J=Xt[V],j=!0):A.samples>0&&Jt.useMultisampledRTT(A)===!1?J=qt.get(A).__webglMultisampledFramebuffer:Array.isArray(Xt)?J=Xt[et]:J=Xt,K.copy(A.viewport),nt.copy(A.scissor),rt=A.scissorTest}else K.copy(vt).multiplyScalar(wt).floor(),nt.copy(Ht).multiplyScalar(wt).floor(),rt=Bt;if(et!==0&&(J=H),Ct.bindFramebuffer(k.FRAMEBUFFER,J)&&Ct.drawBuffers(A,J),Ct.viewport(K),Ct.scissor(nt),Ct.setScissorTest(rt),j){let It=qt.get(A.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+V,It.__webglTexture,et)}else if(Pt){let It=V;for(let Ft=0;Ft<A.textures.length;Ft++){let Xt=qt.get(A.textures[Ft]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ft,Xt.__webglTexture,et,It)}}else if(A!==null&&et!==0){let It=qt.get(A.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,It.__webglTexture,et)}D=-1};function Br(A){let V=qt.get(A);return(V.__readFormat!==A.format||V.__readType!==A.type)&&(V.__readFormat=A.format,V.__readType=A.type,V.__formatReadable=ce.textureFormatReadable(A.format),V.__typeReadable=ce.textureTypeReadable(A.type)),V}this.readRenderTargetPixels=function(A,V,et,J,j,Pt,Nt,It=0){if(!(A&&A.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=qt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Nt!==void 0&&(Ft=Ft[Nt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Ct.bindFramebuffer(k.FRAMEBUFFER,Ft);try{let Xt=A.textures[It],se=Xt.format,xe=Xt.type;A.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+It);let $t=Br(Xt);if($t.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($t.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=A.width-J&&et>=0&&et<=A.height-j&&k.readPixels(V,et,J,j,yt.convert(se),yt.convert(xe),Pt)}finally{let Xt=ut!==null?qt.get(ut).__webglFramebuffer:null;Ct.bindFramebuffer(k.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(A,V,et,J,j,Pt,Nt,It=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=qt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Nt!==void 0&&(Ft=Ft[Nt],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(V>=0&&V<=A.width-J&&et>=0&&et<=A.height-j){Ct.bindFramebuffer(k.FRAMEBUFFER,Ft);let Xt=A.textures[It],se=Xt.format,xe=Xt.type;A.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+It);let $t=Br(Xt);if($t.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($t.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ye=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ye),k.bufferData(k.PIXEL_PACK_BUFFER,Pt.byteLength,k.STREAM_READ),k.readPixels(V,et,J,j,yt.convert(se),yt.convert(xe),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let nn=ut!==null?qt.get(ut).__webglFramebuffer:null;Ct.bindFramebuffer(k.FRAMEBUFFER,nn);let Fe=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Pg(k,Fe,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ye),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Pt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(ye),k.deleteSync(Fe),Pt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,V=null,et=0){let J=Math.pow(2,-et),j=Math.floor(A.image.width*J),Pt=Math.floor(A.image.height*J),Nt=V!==null?V.x:0,It=V!==null?V.y:0;Jt.setTexture2D(A,0),k.copyTexSubImage2D(k.TEXTURE_2D,et,0,0,Nt,It,j,Pt),Ct.unbindTexture()},this.copyTextureToTexture=function(A,V,et=null,J=null,j=0,Pt=0){let Nt,It,Ft,Xt,se,xe,$t,ye,nn,Fe=A.isCompressedTexture?A.mipmaps[Pt]:A.image;if(et!==null)Nt=et.max.x-et.min.x,It=et.max.y-et.min.y,Ft=et.isBox3?et.max.z-et.min.z:1,Xt=et.min.x,se=et.min.y,xe=et.isBox3?et.min.z:0;else{let pe=Math.pow(2,-j);Nt=Math.floor(Fe.width*pe),It=Math.floor(Fe.height*pe),A.isDataArrayTexture?Ft=Fe.depth:A.isData3DTexture?Ft=Math.floor(Fe.depth*pe):Ft=1,Xt=0,se=0,xe=0}J!==null?($t=J.x,ye=J.y,nn=J.z):($t=0,ye=0,nn=0);let Ue=yt.convert(V.format),yn=yt.convert(V.type),Vt;V.isData3DTexture?(Jt.setTexture3D(V,0),Vt=k.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Jt.setTexture2DArray(V,0),Vt=k.TEXTURE_2D_ARRAY):(Jt.setTexture2D(V,0),Vt=k.TEXTURE_2D),Ct.activeTexture(k.TEXTURE0),Ct.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,V.flipY),Ct.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Ct.pixelStorei(k.UNPACK_ALIGNMENT,V.unpackAlignment);let fn=Ct.getParameter(k.UNPACK_ROW_LENGTH),Se=Ct.getParameter(k.UNPACK_IMAGE_HEIGHT),ms=Ct.getParameter(k.UNPACK_SKIP_PIXELS),pn=Ct.getParameter(k.UNPACK_SKIP_ROWS),kr=Ct.getParameter(k.UNPACK_SKIP_IMAGES);Ct.pixelStorei(k.UNPACK_ROW_LENGTH,Fe.width),Ct.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Fe.height),Ct.pixelStorei(k.UNPACK_SKIP_PIXELS,Xt),Ct.pixelStorei(k.UNPACK_SKIP_ROWS,se),Ct.pixelStorei(k.UNPACK_SKIP_IMAGES,xe);let Ji=A.isDataArrayTexture||A.isData3DTexture,gs=V.isDataArrayTexture||V.isData3DTexture;if(A.isDepthTexture){let pe=qt.get(A),an=qt.get(V),Gn=qt.get(pe.__renderTarget),Oe=qt.get(an.__renderTarget);Ct.bindFramebuffer(k.READ_FRAMEBUFFER,Gn.__webglFramebuffer),Ct.bindFramebuffer(k.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let mn=0;mn<Ft;mn++)Ji&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,qt.get(A).__webglTexture,j,xe+mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,qt.get(V).__webglTexture,Pt,nn+mn)),k.blitFramebuffer(Xt,se,Xt+Nt,se+It,$t,ye,$t+Nt,ye+It,k.DEPTH_BUFFER_BIT,k.NEAREST);Ct.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(j!==0||A.isRenderTargetTexture||qt.has(A)){let pe=qt.get(A),an=qt.get(V);Ct.bindFramebuffer(k.READ_FRAMEBUFFER,N),Ct.bindFramebuffer(k.DRAW_FRAMEBUFFER,$);for(let Gn=0;Gn<Ft;Gn++)Ji?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pe.__webglTexture,j,xe+Gn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pe.__webglTexture,j),gs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,an.__webglTexture,Pt,nn+Gn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,an.__webglTexture,Pt),j!==0?k.blitFramebuffer(Xt,se,Xt+Nt,se+It,$t,ye,$t+Nt,ye+It,k.COLOR_BUFFER_BIT,k.NEAREST):gs?k.copyTexSubImage3D(Vt,Pt,$t,ye,nn+Gn,Xt,se,Nt,It):k.copyTexSubImage2D(Vt,Pt,$t,ye,Xt,se,Nt,It);Ct.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else gs?A.isDataTexture||A.isData3DTexture?k.texSubImage3D(Vt,Pt,$t,ye,nn,Nt,It,Ft,Ue,yn,Fe.data):V.isCompressedArrayTexture?k.compressedTexSubImage3D(Vt,Pt,$t,ye,nn,Nt,It,Ft,Ue,Fe.data):k.texSubImage3D(Vt,Pt,$t,ye,nn,Nt,It,Ft,Ue,yn,Fe):A.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Pt,$t,ye,Nt,It,Ue,yn,Fe.data):A.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Pt,$t,ye,Fe.width,Fe.height,Ue,Fe.data):k.texSubImage2D(k.TEXTURE_2D,Pt,$t,ye,Nt,It,Ue,yn,Fe);Ct.pixelStorei(k.UNPACK_ROW_LENGTH,fn),Ct.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Se),Ct.pixelStorei(k.UNPACK_SKIP_PIXELS,ms),Ct.pixelStorei(k.UNPACK_SKIP_ROWS,pn),Ct.pixelStorei(k.UNPACK_SKIP_IMAGES,kr),Pt===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&k.generateMipmap(Vt),Ct.unbindTexture()},this.initRenderTarget=function(A){qt.get(A).__webglFramebuffer===void 0&&Jt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Jt.setTextureCube(A,0):A.isData3DTexture?Jt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Jt.setTexture2DArray(A,0):Jt.setTexture2D(A,0),Ct.unbindTexture()},this.resetState=function(){Z=0,W=0,ut=null,Ct.reset(),Tt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Me._getDrawingBufferColorSpace(t),e.unpackColorSpace=Me._getUnpackColorSpace()}};var v0=10,b0=.8,G1=(n,t)=>[Math.min(...n.map(({p:e})=>e.getComponent(t))),Math.max(...n.map(({p:e})=>e.getComponent(t)))];function H1(n,t){let e=[],i=(o,a)=>o.forEach(l=>e.push({p:new O(...l),radius:a})),s=n.contact_frame,r=new Set(Array.from({length:v0+1},(o,a)=>Math.round(a*s/v0)));for(let o of r)t.body.forEach((a,l)=>{let{a:c,b:d,radius:h}=bi(n,t,o,l);i([c,d],h)}),pr.forEach((a,l)=>i(eo(n,o,l),.06)),t.links.forEach((a,l)=>i(da(n,t,o,l),a.radius_m??0));return i([n.contact_m],.1),e}function S0(n,t,[e,i]){let s=([r,o],a)=>Math.max(r-b0,Math.min(o+b0,a));return n.flatMap(([r,o])=>t.map(a=>({p:new O(s(e,r),s(i,o),a),radius:.03})))}function Sf([n,t],e){let i=e.map((s,r)=>[[...s,0],[...e[(r+1)%e.length],0]]);return Math.min(...i.map(([s,r])=>Hs([n,t,0],s,r)))}function W1({zones:n,obstacles:t}){let e=(i,s)=>i.map((r,o)=>({a:r,b:i[(o+1)%i.length],top:s}));return[...n.filter(({kind:i})=>i==="curtain"||i==="door").map(i=>e(i.polygon_m,i.z_m[1])),...t.map(i=>e(jn(i),i.centre_m[2]+i.size_m[2]/2))]}function M0(n,t,e){let i=H1(n,t),s=[0,1].map(h=>G1(i,h)),r=n.contact_frame,o=[...t.links.keys()],a=[...t.body.keys()].map(h=>bi(n,t,r,h)).concat(o.map(h=>is(n,t,r,h)).filter(h=>!h.position)),l=t.zones.filter(h=>n.sensors.find(({name:u})=>u===h.name)?.detected.includes("1")),c=t.obstacles.map(h=>({item:h,distance:Sf(n.contact_m,jn(h))})).sort((h,u)=>h.distance-u.distance),d=[0,1].map(h=>o.reduce((u,f)=>u+da(n,t,r,f)[0][h],0)/o.length);return{points:i,bounds:s,others:[...l.map(h=>S0(h.polygon_m,h.z_m,s)),...c.slice(0,1).map(({item:h})=>S0(jn(h),[-.5,.5].map(u=>h.centre_m[2]+u*h.size_m[2]),s))],capsules:a.filter(({a:h,b:u,radius:f})=>Hs(n.contact_m,h,u)>f+.03),contact:n.contact_m,person:e.person_xy_m,robot:d,walls:W1(t)}}var $1=8,Mf=n=>[0,1,2].map(t=>n.reduce((e,i)=>e+i[t],0)/n.length),wf=({kind:n,name:t})=>t.toLowerCase().includes(n)?t:`${n} ${t}`,X1=(n,t)=>[...n].sort((e,i)=>Math.hypot(e[0]-t[0],e[1]-t[1])-Math.hypot(i[0]-t[0],i[1]-t[1]));function w0(n,t,e){let i=n.map((s,r)=>Mf([[...s,t],[...n[(r+1)%n.length],t]]));return X1([...i,...n.map(s=>[...s,t])],e)}function E0({replay:n,cell:t,hazard:e,hitting:i,marks:s,colours:r,frame:o}){let a=n.contact_m,l=f=>()=>f,c=()=>{let f=is(n,t,o(),i),m=f.position?no(t.links[i],f):[f.a,f.b],[_,p]=Mf(m),g=Math.max(...m.map(v=>v[2]))+(f.radius??0);return[[_,p,g],Mf(m)]},d=t.zones.map(f=>{let m=f.kind==="curtain"||f.kind==="door",_=w0(f.polygon_m,m?f.z_m[1]:Math.max(...f.z_m),a);return{text:wf(f),kind:"zone",colour:r[f.kind],anchors:l(_)}}),h=t.obstacles.map(f=>({item:f,polygon:jn(f),distance:Sf(a,jn(f))})).sort((f,m)=>f.distance-m.distance).slice(0,$1).map(({item:f,polygon:m})=>{let _=[.5,0,-.45].map(g=>f.centre_m[2]+g*f.size_m[2]),p=_.flatMap(g=>w0(m,g,a));return{text:f.name,kind:"obstacle",anchors:l([[...f.centre_m.slice(0,2),_[0]],...p])}}),u=s.map(({text:f,at:m})=>({text:f,kind:"tick",anchors:l([m])}));return[{text:e.robot_link,kind:"hitting",anchors:c},...d,...h,...u]}var Is=.025,q1=1e3,Y1=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e])));function Z1(n){if(!n.points_m)return n;let t=([i,s,r],[o,a,l])=>o*i+a*s+l*r,e=Y1.map(i=>n.points_m.reduce((s,r)=>t(r,i)>t(s,i)?r:s));return{...n,points_m:[...new Set(e)]}}function Ef(n,t,e,i,s=t.links[i]){let r=is(n,t,e,i);return r.position?{polygon:Wu(no(s,r).map(([o,a])=>[o,a])),radius:0}:{polygon:[r.a.slice(0,2),r.b.slice(0,2)],radius:r.radius}}function J1([n,t],[[e,i],[s,r]],o){let[a,l]=[s-e,r-i],c=a*a+l*l,d=c>0?Math.max(0,Math.min(1,((n-e)*a+(t-i)*l)/c)):0;return(n-e-d*a)**2+(t-i-d*l)**2<=o*o}function T0(n,t,[[e,i],[s,r]]){let[o,a]=[i-e,r-s].map(f=>Math.ceil(f/Is)),l=new Uint8Array(o*a),c=t.links.map(Z1),d=Math.max(1,Math.ceil(n.reduce((f,m)=>f+m.frames,0)/q1));function h({polygon:f,radius:m}){let _=(b,C,w)=>{let x=f.map(B=>B[b]),T=Math.floor((Math.min(...x)-m-C)/Is);return[Math.max(0,T),Math.min(w-1,Math.floor((Math.max(...x)+m-C)/Is))]},[[p,g],[v,S]]=[_(0,e,o),_(1,s,a)];for(let b=v;b<=S;b++)for(let C=p;C<=g;C++){let w=b*o+C,x=[e+(C+.5)*Is,s+(b+.5)*Is];l[w]||=m>0?J1(x,f,m):zl(x,f)}}for(let f of n)for(let m=0;m<f.frames;m+=d)c.forEach((_,p)=>h(Ef(f,t,m,p,_)));let u=[];for(let f=0;f<a;f++)for(let m=0;m<o;m++){let _=m;for(;m<o&&l[f*o+m];)m+=1;m>_&&u.push({x:e+_*Is,y:s+f*Is,width:(m-_)*Is,height:1.2*Is})}return u}var Rr=.1,A0=.4,C0=1.2,R0=.42,P0=.1,K1=[.2,.34,.48].flatMap(n=>[-90,-45,-135,0,180,45,135,90].map(t=>[n*Math.cos(t*Math.PI/180),n*Math.sin(t*Math.PI/180)])),Vo={person:n=>n.person_xy_m,contact:n=>n.contact_point_m};function j1(n,t){let e=new Map;for(let i of n){let[s,r]=t(i),o=[s,r].map(c=>Math.floor(c/Rr+1e-6)),a=o.join(","),l=e.get(a)??{corner:o,hazards:[]};l.hazards.push(i),e.set(a,l)}return[...e.values()]}function Q1({cell:n,scan:t}){let e=(n.robots??[]).flatMap(a=>a.base_m?[a.base_m]:[]),i=[n.start.xy_m,...e,...t.hazards.flatMap(a=>[Vo.person(a),Vo.contact(a)])],s=a=>[0,1].map(l=>[Math.min(...a.map(c=>c[l])),Math.max(...a.map(c=>c[l]))]),r=s(i);return s([...i,...n.obstacles.flatMap(jn),...n.zones.flatMap(a=>a.polygon_m)]).map(([a,l],c)=>[Math.max(a,r[c][0]-C0)-A0,Math.min(l,r[c][1]+C0)+A0])}function I0(n,t,e,i){let s=e.map(([r,o],a)=>R("label",{},R("input",{type:"radio",name:n,value:r,checked:a===0,"data-test":`${n}-${r}`,onchange:()=>i(r)}),` ${o}`));return R("fieldset",{},R("legend",{},t),s)}function L0(n,t){return[0,1].map(e=>{let[i,s]=t[e].map((o,a)=>o+(a===0?.3:-.3)),r=n.map(o=>Math.max(i,Math.min(s,o[e])));return(Math.min(...r)+Math.max(...r))/2})}function D0(n,t,e){let{cell:i,scan:s}=n,r=Q1(n),[[o,a],[l,c]]=r,d=([ot,Et])=>[ot-o,c-Et].map(vt=>Number(vt.toFixed(3))),h=ot=>ot.map(Et=>d(Et).join(",")).join(" "),u=ot=>ot.reduce((Et,vt)=>f(vt)>f(Et)?vt:Et),f=ot=>Ii(ot,s.settings).decides.ratio,m="person",_="cause",p=ne("g",{class:"bins"}),g=ne("path",{class:"sweep"},ne("title",{},"where robots are at some time in the replays of this report")),v=ne("g",{class:"robot"}),S=ne("g",{class:"selected-place"}),b=ne("g",{class:"cause-places"}),C=R("output",{"data-test":"bin",class:"told screen-only"}),w="Point at a bin to read it; click it to see only its hazards in the table.",x=ot=>C.textContent=ot||w;x("");let T=(ot,Et,vt)=>(Object.entries({tabindex:"0",role:"button","aria-label":Et}).forEach(([Bt,zt])=>ot.setAttribute(Bt,zt)),["mouseenter","focus"].forEach(Bt=>ot.addEventListener(Bt,()=>x(Et))),["mouseleave","blur"].forEach(Bt=>ot.addEventListener(Bt,()=>x(""))),ot.addEventListener("click",vt),ot.addEventListener("keydown",Bt=>{(Bt.key==="Enter"||Bt.key===" ")&&(Bt.preventDefault(),Bt.stopPropagation(),vt())}),ot);function B(){let ot=j1(s.hazards,Vo[m]),Et=({hazards:zt})=>_==="count"?zt.length:Math.max(...zt.map(f)),vt=ot.map(Et),[Ht,Bt]=[Math.min(...vt),Math.max(...vt)];p.replaceChildren(...ot.map(zt=>{let[ge,fe]=zt.corner.map(At=>At*Rr),Ne=u(zt.hazards),_e=`${m==="person"?"person at":"contact at"} ${ge.toFixed(1)} to ${(ge+Rr).toFixed(1)}, ${fe.toFixed(1)} to ${(fe+Rr).toFixed(1)} m`,ze=`${_e}: ${de(zt.hazards.length,"hazard")}, worst ${Ze(f(Ne))}, cause ${n.causeOf(Ne.id).number}`,he=()=>{e({name:_e,ids:new Set(zt.hazards.map(At=>At.id))}),t.select(Ne.id)},We=Bt>Ht?(Et(zt)-Ht)/(Bt-Ht):1,[Qe,rn]=d([ge,fe+Rr]),k=_==="cause"?`fill:${ua(n.causeOf(Ne.id))}`:`--heat:${We.toFixed(3)}`;return T(ne("rect",{x:Qe,y:rn,width:Rr,height:Rr,style:k,"data-test":"map-bin"}),ze,he)})),L.textContent=_==="cause"?"Each bin has the colour of its worst cause.":_==="count"?`${de(Ht,"hazard")} (pale) to ${Bt} (dark) in a bin`:`worst ratio ${Ze(Ht)} (pale) to ${Ze(Bt)} (dark)`,F()}function F(){let ot=[];b.replaceChildren(...n.causes.map(Et=>{let[vt,Ht]=d(Vo[m](n.hazard(Et.worst))),Bt=([_e,ze])=>ot.every(([he,We])=>Math.hypot(_e-he,ze-We)>2.2*P0),zt=K1.map(([_e,ze])=>[vt+_e,Ht+ze]),[ge,fe]=zt.find(Bt)??zt[0];ot.push([ge,fe]);let Ne=ne("g",{class:"cause-place","data-test":"place-cause","data-id":Et.id,transform:`translate(${ge.toFixed(3)} ${fe.toFixed(3)})`,style:`--cause:${ua(Et)}`},ne("line",{x2:(vt-ge).toFixed(3),y2:(Ht-fe).toFixed(3)}),ne("circle",{r:P0}),ne("text",{y:.045},String(Et.number)));return T(Ne,`cause ${Et.number}: ${Et.sentence}`,()=>t.select(Et.id))}))}let L=R("span",{class:"note"}),G=([ot,Et])=>ot>o&&ot<a&&Et>l&&Et<c,H=(ot,[Et,vt],Ht)=>{let[Bt,zt]=d([Et,vt]);return ne("text",{x:Bt,y:zt,class:`name ${Ht}`},ot)},N=i.obstacles.map(ot=>ne("polygon",{points:h(jn(ot)),class:"obstacle"},ne("title",{},ot.name))),$=i.zones.map(ot=>ne(ot.polygon_m.length>2?"polygon":"polyline",{points:h(ot.polygon_m),class:`zone ${ot.kind}`},ne("title",{},`${ot.kind} ${ot.name}`))),Z=[...i.obstacles.map(ot=>H(ot.name,L0(jn(ot),r),"obstacle-name")),...i.zones.map(ot=>{let[Et,vt]=[0,1].map(Ht=>Math.max(r[Ht][0]+.05,Math.min(...ot.polygon_m.map(Bt=>Bt[Ht]))));return H(wf(ot),[Et+.05,vt+.05],`zone-name ${ot.kind}`)})],[W,ut]=d(i.start.xy_m),D=ne("g",{class:"start",transform:`translate(${W} ${ut}) rotate(${-i.start.heading_deg})`},ne("circle",{r:.12}),ne("path",{d:"M 0.12 0 H 0.3 M 0.22 -0.07 L 0.3 0 L 0.22 0.07"}),ne("title",{},"start of the person")),q=[a-o,c-l],K=([ot,Et])=>Array.from({length:Math.floor(Et)-Math.ceil(ot)+1},(vt,Ht)=>Math.ceil(ot)+Ht),nt=ne("g",{class:"ruler"},ne("path",{d:`M 0 0 V ${q[1].toFixed(3)} H ${q[0].toFixed(3)}`}),K([r[0][0]+.2,r[0][1]-.15]).map(ot=>[ne("path",{d:`M ${(ot-o).toFixed(3)} ${q[1].toFixed(3)} v 0.05`}),ne("text",{x:(ot-o).toFixed(3),y:(q[1]+.19).toFixed(3)},`${ot} m`)]).flat(),K([r[1][0]+.1,r[1][1]-.1]).map(ot=>[ne("path",{d:`M 0 ${(c-ot).toFixed(3)} h -0.05`}),ne("text",{x:-.08,y:(c-ot+.04).toFixed(3),class:"left"},`${ot} m`)]).flat(),ne("text",{x:-.1,y:(q[1]+.19).toFixed(3),class:"left"},"x, y")),rt=ne("clipPath",{id:"map-frame"},ne("rect",{width:q[0].toFixed(3),height:q[1].toFixed(3)})),tt=ne("svg",{viewBox:`${-R0} 0 ${(q[0]+R0).toFixed(3)} ${(q[1]+.26).toFixed(3)}`,class:"map",role:"group","aria-label":"the cell from above","data-test":"map"},ne("defs",{},rt),ne("g",{"clip-path":"url(#map-frame)"},g,$,N,v,p,S,D),Z.filter((ot,Et)=>G(L0(Et<i.obstacles.length?jn(i.obstacles[Et]):i.zones[Et-i.obstacles.length].polygon_m,r))),b,nt);function _t(ot,Et){let vt=i.links.map((Ht,Bt)=>{let{polygon:zt,radius:ge}=Ef(ot,i,ot.contact_frame,Bt),fe=Ht.name===Et||`${Ht.robot}/${Ht.name}`===Et?"hitting":null,Ne=zt.map(d);if(ge===0)return ne("polygon",{points:h(zt),class:fe});let[[_e,ze],[he,We]]=Ne;return ne("line",{x1:_e,y1:ze,x2:_e===he&&ze===We?he+.001:he,y2:We,"stroke-width":2*ge,class:fe})});v.replaceChildren(...vt,ne("title",{},"robot at the contact of the selected hazard"))}let mt=!1;function xt(){if(!mt){mt=!0;let ot=n.replays.map(({id:vt})=>n.replay(vt)),Et=T0(ot,i,r).map(({x:vt,y:Ht,width:Bt,height:zt})=>`M${(vt-o).toFixed(3)} ${(c-Ht).toFixed(3)}h${Bt.toFixed(3)}v${(-zt).toFixed(3)}h${(-Bt).toFixed(3)}z`);g.setAttribute("d",Et.join(""))}}new IntersectionObserver(ot=>ot.some(Et=>Et.isIntersecting)&&xt(),{rootMargin:"400px"}).observe(tt),t.follow(({hazard:ot,cause:Et})=>{let vt=n.hazard(ot),[Ht,Bt]=d(Vo.person(vt)),[zt,ge]=d(Vo.contact(vt));S.replaceChildren(ne("line",{x1:Ht,y1:Bt,x2:zt,y2:ge}),ne("circle",{cx:Ht,cy:Bt,r:.09},ne("title",{},`${ot}: person`)),ne("path",{d:`M ${zt} ${ge} m -0.06 -0.06 l 0.12 0.12 m 0 -0.12 l -0.12 0.12`},ne("title",{},`${ot}: contact`)));let fe=n.replay(ot)??n.replay(n.cause(Et).worst)??n.replay(n.replays[0]?.id);fe?_t(fe,vt.robot_link):v.replaceChildren()}),B();let wt=n.causes.slice(0,8).map(ot=>R("li",{},Gs(ot),` ${ot.sentence}`));return On("map","Where it happens",R("div",{class:"filters screen-only"},I0("place","bins of",[["person","person"],["contact","contact"]],ot=>(m=ot,B())),I0("colour","colour",[["cause","cause"],["count","number of hazards"],["ratio","worst ratio"]],ot=>(_=ot,B()))),tt,R("p",{class:"map-line"},C," ",L),R("ul",{class:"map-key"},wt),R("p",{class:"note"},"Ring: the selected hazard's person; cross: its contact. Arrow: start. Blue: robot at that contact, and pale where robots go in the replays. Grey: obstacles. Dashed: sensor zones. Numbers: worst way of each cause."))}function tE(n){let{speed_m_s:t,safe_below_m_s:e,limit_n:i,force_n:s,effective_mass_kg:r}=n;return`F = v √(μ k) = ${e>0?`${es(t)} × ${(i/e).toFixed(0)} N/(m/s) = `:""}${ai(s)}; limit ${ai(i)}, met at ${es(e)}. Effective mass of the robot ${r.toFixed(2)} kg; v is the robot's own speed.`}function eE(n,t){let{own:e,approach:i,decides:s,apart:r}=Ii(n,t),o=a=>R("li",{class:a===s?"decides":null},`${a.name}, ${es(a.speed)}: ${ai(a.force)}, ${Ze(a.ratio)} the limit`,a===s?R("b",{}," (decides)"):null);return R("div",{"data-test":"forces"},R("ul",{class:"plain-list"},o(e),o(i)),r?R("p",{class:"flag","data-test":"apart"},`${Nl} ${e.ratio>i.ratio?"Most of the robot's speed is not towards the person.":"Most of the speed is the person's own walking."}`):null)}var N0=(n,t)=>R("ol",{class:"sequence"},Dp(n,t).map(e=>R("li",{},e)));function nE(n,t){let{decides:e}=Ii(n,t),i=`The robot's ${n.robot_link} hits the ${vn(n.body_region)} at ${es(n.speed_m_s)} after ${hn(n.time_s)}: ${Ze(e.ratio)} the limit.`;return Dl(n.body_region)?`${i} A moving robot may not touch it at all, whatever the force.`:i}function Yh(n,t,{short:e=!1}={}){let i=t.action_s,s=n.shortest.actions.join()===n.actions.join(),r=n.bend_fraction<1?`, bent as far as obstacles leave it (${(100*n.bend_fraction).toFixed(0)} %)`:"",o=li([["what",nE(n,t)],["where",`contact at ${Ll(n.contact_point_m)}; the person stands at ${Ll(n.person_xy_m)}, looks to ${((n.person_heading_deg%360+360)%360).toFixed(0)}°${r}`],["begins",n.begins?`at ${Ll(n.begins.xy_m)}, looking to ${n.begins.heading_deg.toFixed(0)}°, ${Il(n.begins)}; times count from then`:""],["force",eE(n,t)],["how computed",e?"":tE(n)],["arm",n.arm&&!e?`${n.arm.side} arm. An arm pose is searched at every instant; the one shown is that at the contact.`:""],["way of the arm",n.through.map(a=>`past ${a.sensor} ${hn(a.since_s)} before the contact${a.until_s>0?", ahead of the body":""}; the robot is where it is when that reports it`).join("; ")],["sensors",`at the contact: ${Op(n.sensors)}`],["programme phase",n.phase===null||e?"":String(n.phase)],["found",e?"":`${Bp(n)}; earliest contact at ${hn(n.earliest_time_s)}${n.first_iteration>0?`; first in iteration ${n.first_iteration}`:""}`],["confirmed",`by a fresh instance without any restore: ${Zr(n.confirmed)}`],["worst sequence",N0(n.actions,i)],["shortest and calmest",e?"":s?"the same sequence":[`${Ze(n.shortest.ratio)}, ${ai(n.shortest.force_n)} at ${hn(n.shortest.time_s)}; confirmed: ${Zr(n.shortest.confirmed)}`,N0(n.shortest.actions,i)]],["replay it",e?"":[Vs(`fmi-hazard replay scan.json ${n.id}`)," in the folder with this report"]]]);return e||o.setAttribute("data-test","facts"),o}var Tf=8,F0=(n,t,e)=>R("table",{class:`plain ${e}`},R("thead",{},R("tr",{},n.map(i=>R("th",{scope:"col"},i)))),R("tbody",{},t.map(i=>R("tr",{},i.map(s=>R("td",{},s))))));function iE({scan:n}){let{certificate:t,spent:e}=n;return Qr(n)?`${jr(n)}.`:t?.complete?`All ${Ee(t.sequences)} sequences of ${t.horizon} actions, ${hn(n.settings.action_s)} each, in this model.`:`${de(e.iterations,"sequence")} of actions; the search is not complete.`}function sE(n,t){let{scan:e,cell:i}=n,{sentence:s,scope:r}=Jp(e),o=n.causes.map(a=>[Gs(a),a.sentence,ca(a)[0],rE(a),t.ofCause(a.id),fr(t.of(a.id))??"–"]);return R("article",{class:"first","data-test":"print-first"},R("p",{class:"kicker"},`${e.tool} · hazard report`),R("h1",{},i.name),R("p",{class:"verdict"},s),R("p",{},R("strong",{},r[0]),` ${r[1]}`),R("h3",{},"Causes, worst first"),F0(["","cause","worst","what to change","decision","PL r"],o,"causes"),R("h3",{},"What the search covered"),li([["cell file",[e.subject.cell_found,"; SHA-256 ",R("code",{},e.subject.cell_sha256)]],["FMU",e.subject.fmus.flatMap((a,l)=>[l>0?"; ":"",`${a.unit?`${a.unit}: `:""}${a.model_name}; SHA-256 `,R("code",{},a.sha256)])],["looked at",iE(n)],["made again by",R("code",{},n.reproduce)]]),R("h3",{},"Assessed by"),R("div",{class:"sign"},["Name","Date","Signature"].map(a=>R("p",{},a))),R("p",{class:"note"},"A hazard is a way, found in the model, for a person to be hit harder than ISO/TS 15066 allows. This report helps an assessment; it does not show that the cell is safe."))}var rE=({advice:n})=>n?.changes[0]?.change??(n?"no single change found":"not looked for");function oE(n,t,e){let i=n.hazard(t.worst),[s,r]=ca(t),o=Bl(t);o.mark(i.body_region);let a=n.topView(t.worst),l=e.of(t.id),c=t.hazards.filter(h=>e.own(h)!==null),d=t.lines.map(({body_region:h,robot_link:u,ratio:f,hazards:m})=>[vn(h),u,Yr(h,f),Ee(m.length)]);return R("article",{"data-test":"print-cause","data-id":t.id},R("h2",{},Gs(t),` ${t.sentence}`),R("p",{class:"severity"},R("b",{},s),` ${r}`),zu(n,t),R("p",{},[...ku(n,t).map(([,h])=>h),t.id].join(" · ")),R("div",{class:"print-pictures"},a?Ul(a):R("p",{class:"note"},"This report carries no drawing of its worst way."),o.element),R("div",{class:"print-columns"},R("div",{},Vu(t)),R("div",{},R("h4",{},"Assessment (ISO 12100)"),li([...Kr.map(({key:h,label:u})=>[u.split(":")[0].toLowerCase(),h==="decision"?e.ofCause(t.id):l[h]]),["PL r",fr(l)??""],["decided apart",c.map(h=>`${h}: ${e.own(h)}`).join(", ")]]))),R("h4",{},`Its worst way, ${t.worst}`),Yh(i,n.scan.settings,{short:!0}),R("h4",{},"Ways by region and link"),F0(["body region","hit by","worst","ways"],d.slice(0,Tf),"lines"),d.length>Tf?R("p",{class:"note"},`And ${de(d.length-Tf,"other pair")} of region and link, less bad; scan.json has them all.`):null)}function U0(n,t){let e=R("section",{class:"print-only",id:"print"});return addEventListener("beforeprint",()=>e.replaceChildren(sE(n,t),...n.causes.map(i=>oE(n,i,t)))),addEventListener("afterprint",()=>e.replaceChildren()),e}var O0=n=>R("code",{class:"hash"},n);function aE(n){let t=n?.result??String(n);switch(t){case"exact":return"exact";case"not_offered":return"not offered";case"differs":return`WRONG, differs by up to ${n.largest.toExponential(2)}`;case"failed":return`FAILED: ${n.reason}`;default:return t}}function lE({subject:n,tool:t}){let e=n.fmus.map(s=>[s.unit?`FMU ${s.unit}`:"FMU",[`${s.model_name}, FMI ${s.fmi_version}, by ${s.generation_tool||"an unnamed tool"}; SHA-256 `,O0(s.sha256)]]),i=[["tool",t],["cell",n.cell],["cell file",[`${n.cell_found}; SHA-256 `,O0(n.cell_sha256)]],...e];return R("div",{},R("h3",{},"Subject"),R("dl",{},i.map(([s,r])=>R("div",{},R("dt",{},s),R("dd",{},r)))),n.couplings.length>0?R("ul",{},n.couplings.map(s=>R("li",{},s))):null)}var B0=n=>n.replaceAll("_"," ");function cE(n){let t=Object.entries(n).map(([e,i])=>{let s=e==="speed_criterion"?Fl(n):typeof i=="boolean"?i?"yes":"no":String(i),r={s:" s",m:" m"}[e.split("_").at(-1)]??"";return[B0(r?e.replace(/_[sm]$/,""):e),`${s}${r}`]});return[R("h3",{},"Settings"),li(t)]}function hE(n){let t=Object.entries(n).map(([e,i])=>[B0(e.replace(/_s$/,"")),typeof i=="object"&&i!==null?aE(i):`${i}${e.endsWith("_s")?" s":""}`]);return[R("h3",{},"Self-test of the FMU"),R("p",{class:"note"},"Whether runs repeat exactly, and what saved states, reset and copies are worth."),li(t)]}function uE({standard_edition:n,tables:t}){let e=t.filter(s=>!s.verified).length,i=t.map(s=>R("tr",{},R("td",{},s.title),R("td",{},s.verified?"verified":"not verified"),R("td",{},s.source),R("td",{},s.confidence)));return R("div",{},R("h3",{},"Limits and tables"),R("p",{},`${n}. ${e} of ${t.length} tables are not yet verified against the purchased standards.`),R("div",{class:"scroll",tabindex:0},R("table",{class:"plain"},R("thead",{},R("tr",{},["table","state","source","confidence"].map(s=>R("th",{scope:"col"},s)))),R("tbody",{},i))))}function k0({scan:n,assumptions:t,reproduce:e}){return On("provenance","What was scanned",R("div",{class:"columns"},lE(n),R("div",{},cE(n.settings)),R("div",{},hE(n.self_test))),uE(n),R("h3",{},"Assumptions"),R("ul",{class:"assumptions","data-test":"assumptions"},t.map(i=>R("li",{},i))),R("h3",{},"Reproduce"),R("p",{class:"note"},"In the folder with this report:"),Vs(e),R("p",{class:"note"},"This page carries three.js (MIT licence, © three.js authors) and uPlot (MIT licence, © 2022 Leon Sorokin); the full texts are at the end of its script."))}function dE(n,t){let e=[...n.keys()].filter(i=>i>0&&n[i]<.01&&n[i-1]>=.01);return e.find(i=>i>=t)??e[0]??-1}function z0(n,t){let e=n.sensors.map(({name:r,detected:o})=>({frame:o.indexOf("1"),kind:"sensor",text:`${r} reports`})).filter(({frame:r})=>r>=0),i=e.length>0?Math.min(...e.map(({frame:r})=>r)):0,s=dE(n.speed_m_s,i);return[...e,{frame:n.contact_frame,kind:"contact",text:"contact"},...s>=0?[{frame:s,kind:"rest",text:`${t.robot_link} stands still`}]:[]].sort((r,o)=>r.frame-o.frame)}function V0(){let n=[],t=1,e=1,i=0,s=.5,r=!1,o=null,a=()=>n.forEach(d=>d({frame:i,playing:r}));function l(d){if(!r)return;o??={now:d,frame:i};let h=o.frame+Math.floor((d-o.now)/1e3*(s/e));h!==i&&(i=Math.min(h,t-1),r=i<t-1,a()),requestAnimationFrame(l)}let c={get frame(){return i},get playing(){return r},load(d,h,u){[t,e]=[d,h],c.seek(u)},seek(d){i=Math.max(0,Math.min(t-1,Math.round(d))),r=!1,a()},pause(){r=!1,a()},toggle(){r=!r,o=null,r&&(i=i>=t-1?0:i,requestAnimationFrame(l)),a()},setSpeed(d){s=d,o=null},follow:d=>n.push(d)};return c}var fE="uplot",pE="u-hz",mE="u-vt",gE="u-title",_E="u-wrap",xE="u-under",yE="u-over",vE="u-axis",Lr="u-off",bE="u-select",SE="u-cursor-x",ME="u-cursor-y",wE="u-cursor-pt",EE="u-legend",TE="u-live",AE="u-inline",CE="u-series",RE="u-marker",G0="u-label",PE="u-value",gl="width",_l="height";var H0="bottom",Go="left",Af="right",Wf="#000",W0=Wf+"0",Cf="mousemove",$0="mousedown",Rf="mouseup",X0="mouseenter",q0="mouseleave",Y0="dblclick",IE="resize",LE="scroll",Z0="change",Qh="dppxchange",$f="--",Zo=typeof window<"u",Nf=Zo?document:null,Wo=Zo?window:null,DE=Zo?navigator:null,Re,Zh;function Ff(){let n=devicePixelRatio;Re!=n&&(Re=n,Zh&&Of(Z0,Zh,Ff),Zh=matchMedia(`(min-resolution: ${Re-.001}dppx) and (max-resolution: ${Re+.001}dppx)`),Dr(Z0,Zh,Ff),Wo.dispatchEvent(new CustomEvent(Qh)))}function gi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Uf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function je(n,t,e){n.style[t]=e+"px"}function Hi(n,t,e,i){let s=Nf.createElement(n);return t!=null&&gi(s,t),e?.insertBefore(s,i),s}function Ti(n,t){return Hi("div",n,t)}var J0=new WeakMap;function ds(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=J0.get(n);r!=o&&(n.style.transform=r,J0.set(n,r),t<0||e<0||t>i||e>s?gi(n,Lr):Uf(n,Lr))}var K0=new WeakMap;function j0(n,t,e){let i=t+e,s=K0.get(n);i!=s&&(K0.set(n,i),n.style.background=t,n.style.borderColor=e)}var Q0=new WeakMap;function t_(n,t,e,i){let s=t+""+e,r=Q0.get(n);s!=r&&(Q0.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Xf={passive:!0},NE={...Xf,capture:!0};function Dr(n,t,e,i){t.addEventListener(n,e,i?NE:Xf)}function Of(n,t,e,i){t.removeEventListener(n,e,Xf)}Zo&&Ff();function Wi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:_i((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function C_(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var R_=n=>n!=null,P_=n=>n!=null&&n>0,nu=C_(R_),FE=C_(P_);function UE(n,t,e,i=0,s=!1){let r=s?FE:nu,o=s?P_:R_;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let d=n[c];o(d)&&(d<a?a=d:d>l&&(l=d))}return[a??Ge,l??-Ge]}function iu(n,t,e,i){let s=i_(n),r=i_(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ls:I_,a=s==1?_i:Ai,l=r==1?Ai:_i,c=a(o(wn(n))),d=l(o(wn(t))),h=$o(e,c),u=$o(e,d);return e==10&&(c<0&&(h=He(h,-c)),d<0&&(u=He(u,-d))),i||e==2?(n=h*s,t=u*r):(n=F_(n,h),t=su(t,u)),[n,t]}function qf(n,t,e,i){let s=iu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Yf=.1,e_={mode:3,pad:Yf},yl={pad:0,soft:null,mode:0},OE={min:yl,max:yl};function tu(n,t,e,i){return ru(e)?n_(n,t,e):(yl.pad=e,yl.soft=i?0:null,yl.mode=i?3:0,n_(n,t,OE))}function Ae(n,t){return n??t}function BE(n,t,e){for(t=Ae(t,0),e=Ae(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function n_(n,t,e){let i=e.min,s=e.max,r=Ae(i.pad,0),o=Ae(s.pad,0),a=Ae(i.hard,-Ge),l=Ae(s.hard,Ge),c=Ae(i.soft,Ge),d=Ae(s.soft,-Ge),h=Ae(i.mode,0),u=Ae(s.mode,0),f=t-n,m=Ls(f),_=Jn(wn(n),wn(t)),p=Ls(_),g=wn(p-m);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Ge&&(r=0),u==2&&d!=-Ge&&(o=0)));let v=f||_||1e3,S=Ls(v),b=$o(10,_i(S)),C=v*(f==0?n==0?.1:1:r),w=He(F_(n-C,b/10),24),x=n>=c&&(h==1||h==3&&w<=c||h==2&&w>=c)?c:Ge,T=Jn(a,w<x&&n>=x?x:$i(x,w)),B=v*(f==0?t==0?.1:1:o),F=He(su(t+B,b/10),24),L=t<=d&&(u==1||u==3&&F>=d||u==2&&F<=d)?d:-Ge,G=$i(l,F>L&&t<=L?L:Jn(L,F));return T==G&&T==0&&(G=100),[T,G]}var kE=new Intl.NumberFormat(Zo?DE.language:"en-US"),Zf=n=>kE.format(n),xi=Math,jh=xi.PI,wn=xi.abs,_i=xi.floor,Mn=xi.round,Ai=xi.ceil,$i=xi.min,Jn=xi.max,$o=xi.pow,i_=xi.sign,Ls=xi.log10,I_=xi.log2,zE=(n,t=1)=>xi.sinh(n)*t,Pf=(n,t=1)=>xi.asinh(n/t),Ge=1/0;function s_(n){return(Ls((n^n>>31)-(n>>31))|0)+1}function Bf(n,t,e){return $i(Jn(n,t),e)}function L_(n){return typeof n=="function"}function we(n){return L_(n)?n:()=>n}var VE=()=>{},D_=n=>n,N_=(n,t)=>t,GE=n=>null,r_=n=>!0,o_=(n,t)=>n==t,HE=/\.\d*?(?=9{6,}|0{6,})/gm,Nr=n=>{if(O_(n)||lr.has(n))return n;let t=`${n}`,e=t.match(HE);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Nr(s)}e${r}`}return He(n,i)};function Pr(n,t){return Nr(He(Nr(n/t))*t)}function su(n,t){return Nr(Ai(Nr(n/t))*t)}function F_(n,t){return Nr(_i(Nr(n/t))*t)}function He(n,t=0){if(O_(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Mn(i)/e}var lr=new Map;function U_(n){return((""+n).split(".")[1]||"").length}function bl(n,t,e,i){let s=[],r=i.map(U_);for(let o=t;o<e;o++){let a=wn(o),l=He($o(n,o),a);for(let c=0;c<i.length;c++){let d=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?d:He(d,h);s.push(u),lr.set(u,h)}}return s}var vl={},Jf=[],Xo=[null,null],ar=Array.isArray,O_=Number.isInteger,WE=n=>n===void 0;function a_(n){return typeof n=="string"}function ru(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function $E(n){return n!=null&&typeof n=="object"}var XE=Object.getPrototypeOf(Uint8Array),B_="__proto__";function qo(n,t=ru){let e;if(ar(n)){let i=n.find(s=>s!=null);if(ar(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=qo(n[s],t)}else e=n.slice()}else if(n instanceof XE)e=n.slice();else if(t(n)){e={};for(let i in n)i!=B_&&(e[i]=qo(n[i],t))}else e=n;return e}function xn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=B_&&(ru(n[s])?xn(n[s],qo(i[s])):n[s]=qo(i[s]))}return n}var qE=0,YE=1,ZE=2;function JE(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function KE(n,t){if(tT(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return eT(o[0])||(o=QE(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let d=0;d<c;d++)e.add(l[d])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let d=a[c],h=Array(s).fill(void 0),u=t?t[o][c]:YE,f=[];for(let m=0;m<d.length;m++){let _=d[m],p=r.get(l[m]);_===null?u!=qE&&(h[p]=_,u==ZE&&f.push(p)):h[p]=_}JE(h,f,s),i.push(h)}}return i}var jE=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function QE(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function tT(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function eT(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,_i((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var k_=["January","February","March","April","May","June","July","August","September","October","November","December"],z_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function V_(n){return n.slice(0,3)}var nT=z_.map(V_),iT=k_.map(V_),sT={MMMM:k_,MMM:iT,WWWW:z_,WWW:nT};function ml(n){return(n<10?"0":"")+n}function rT(n){return(n<10?"00":n<100?"0":"")+n}var oT={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ml(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ml(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ml(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ml(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ml(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>rT(n.getMilliseconds())};function Kf(n,t){t=t||sT;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?oT[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var aT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function lT(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==aT?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var G_=n=>n%1==0,eu=[1,2,2.5,5],cT=bl(10,-32,0,eu),H_=bl(10,0,32,eu),hT=H_.filter(G_),Ir=cT.concat(H_),jf=`
`,W_="{YYYY}",l_=jf+W_,$_="{M}/{D}",xl=jf+$_,Jh=xl+"/{YY}",X_="{aa}",uT="{h}:{mm}",Ho=uT+X_,c_=jf+Ho,h_=":{ss}",De=null;function q_(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?bl(10,0,3,eu).filter(G_):bl(10,-3,0,eu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,W_,De,De,De,De,De,De,1],[s*28,"{MMM}",l_,De,De,De,De,De,1],[s,$_,l_,De,De,De,De,De,1],[i,"{h}"+X_,Jh,De,xl,De,De,De,1],[e,Ho,Jh,De,xl,De,De,De,1],[t,h_,Jh+" "+Ho,De,xl+" "+Ho,De,c_,De,1],[n,h_+".{fff}",Jh+" "+Ho,De,xl+" "+Ho,De,c_,De,1]];function d(h){return(u,f,m,_,p,g)=>{let v=[],S=p>=o,b=p>=r&&p<o,C=h(m),w=He(C*n,3),x=If(C.getFullYear(),S?0:C.getMonth(),b||S?1:C.getDate()),T=He(x*n,3);if(b||S){let B=b?p/r:0,F=S?p/o:0,L=w==T?w:He(If(x.getFullYear()+F,x.getMonth()+B,1)*n,3),G=new Date(Mn(L/n)),H=G.getFullYear(),N=G.getMonth();for(let $=0;L<=_;$++){let Z=If(H+F*$,N+B*$,1),W=Z-h(He(Z*n,3));L=He((+Z+W)*n,3),L<=_&&v.push(L)}}else{let B=p>=s?s:p,F=_i(m)-_i(w),L=T+F+su(w-T,B);v.push(L);let G=h(L),H=G.getHours()+G.getMinutes()/e+G.getSeconds()/i,N=p/i,$=u.axes[f]._space,Z=g/$;for(;L=He(L+p,n==1?0:3),!(L>_);)if(N>1){let W=_i(He(H+N,6))%24,q=h(L).getHours()-W;q>1&&(q=-1),L-=q*i,H=(H+N)%24;let K=v[v.length-1];He((L-K)/p,3)*Z>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,d]}var[dT,fT,pT]=q_(1),[mT,gT,_T]=q_(.001);bl(2,-53,53,[1]);function u_(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function d_(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,d,h,u,f;return i.map(m=>{let _=n(m),p=_.getFullYear(),g=_.getMonth(),v=_.getDate(),S=_.getHours(),b=_.getMinutes(),C=_.getSeconds(),w=p!=l&&a[2]||g!=c&&a[3]||v!=d&&a[4]||S!=h&&a[5]||b!=u&&a[6]||C!=f&&a[7]||a[1];return l=p,c=g,d=v,h=S,u=b,f=C,w(_)})}}function xT(n,t){let e=Kf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function If(n,t,e){return new Date(n,t,e)}function f_(n,t){return t(n)}var yT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function p_(n,t){return(e,i,s,r)=>r==null?$f:t(n(i))}function vT(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function bT(n,t){return n.series[t].fill(n,t)}var ST={show:!0,live:!0,isolate:!1,mount:VE,markers:{show:!0,width:2,stroke:vT,fill:bT,dash:"solid"},idx:null,idxs:null,values:[]};function MT(n,t){let e=n.cursor.points,i=Ti(),s=e.size(n,t);je(i,gl,s),je(i,_l,s);let r=s/-2;je(i,"marginLeft",r),je(i,"marginTop",r);let o=e.width(n,t,s);return o&&je(i,"borderWidth",o),i}function wT(n,t){let e=n.series[t].points;return e._fill||e._stroke}function ET(n,t){let e=n.series[t].points;return e._stroke||e._fill}function TT(n,t){return n.series[t].points.size}var Lf=[0,0];function AT(n,t,e){return Lf[0]=t,Lf[1]=e,Lf}function Kh(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Df(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var CT={show:!0,x:!0,y:!0,lock:!1,move:AT,points:{one:!1,show:MT,size:TT,width:0,stroke:ET,fill:wT},bind:{mousedown:Kh,mouseup:Kh,click:Kh,dblclick:Kh,mousemove:Df,mouseleave:Df,mouseenter:Df},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Y_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Qf=xn({},Y_,{filter:N_}),Z_=xn({},Qf,{size:10}),J_=xn({},Y_,{show:!1}),tp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',K_="bold "+tp,j_=1.5,m_={show:!0,scale:"x",stroke:Wf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:K_,side:2,grid:Qf,ticks:Z_,border:J_,font:tp,lineGap:j_,rotate:0},RT="Value",PT="Time",g_={show:!0,scale:"x",auto:!1,sorted:1,min:Ge,max:-Ge,idxs:[]};function IT(n,t,e,i,s){return t.map(r=>r==null?"":Zf(r))}function LT(n,t,e,i,s,r,o){let a=[],l=lr.get(s)||0;e=o?e:He(su(e,s),l);for(let c=e;c<=i;c=He(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function kf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ls:I_,d=_i(c(e));s=$o(l,d),l==10&&(s=Ir[Wi(s,Ir)]);let h=e,u=s*l;l==10&&(u=Ir[Wi(u,Ir)]);do a.push(h),h=h+s,l==10&&!lr.has(h)&&(h=He(h,lr.get(s))),h>=u&&(s=h,u=s*l,l==10&&(u=Ir[Wi(u,Ir)]));while(h<=i);return a}function DT(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?kf(n,t,Jn(l,e),i,s):[l],d=i>=0&&e<=0?[0]:[];return(e<-l?kf(n,t,Jn(l,-i),-e,s):[l]).reverse().map(u=>-u).concat(d,c)}var Q_=/./,NT=/[12357]/,FT=/[125]/,__=/1/,zf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function UT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,d=l(10,o),h=l(9,o)-d>=c?Q_:l(7,o)-d>=c?NT:l(5,o)-d>=c?FT:__;if(h==__){let u=wn(l(1,o)-d);if(u<c)return zf(t.slice().reverse(),a.distr,h,Ai(c/u)).reverse()}return zf(t,a.distr,h,1)}function OT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=wn(l(1,o)-l(2,o));return c<a?zf(t.slice().reverse(),3,Q_,Ai(a/c)).reverse():t}function BT(n,t,e,i){return i==null?$f:t==null?"":Zf(t)}var x_={show:!0,scale:"y",stroke:Wf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:K_,side:3,grid:Qf,ticks:Z_,border:J_,font:tp,lineGap:j_,rotate:0};function kT(n,t){let e=3+(n||1)*2;return He(e*t,3)}function zT(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=wn(o-r),l=n.series[t],c=a/(l.points.space*Re);return i[1]-i[0]<=c}var y_={scale:null,auto:!0,sorted:0,min:Ge,max:-Ge},tx=(n,t,e,i,s)=>s,v_={show:!0,auto:!0,sorted:0,gaps:tx,alpha:1,facets:[xn({},y_,{scale:"x"}),xn({},y_,{scale:"y"})]},b_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:tx,alpha:1,points:{show:zT,filter:null},values:null,min:Ge,max:-Ge,idxs:[],path:null,clip:null};function VT(n,t,e,i,s){return e/10}var ex={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},GT=xn({},ex,{time:!1,ori:1}),S_={};function nx(n,t){let e=S_[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let d=0;d<e.plots.length;d++)e.plots[d]!=s&&e.plots[d].pub(i,s,r,o,a,l,c)}},n!=null&&(S_[n]=e)),e}var Yo=1,Vf=2;function Fr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],d=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,m=a.width,_=a.height,p=n.valToPosH,g=n.valToPosV;return d.ori==0?e(s,l,c,d,h,p,g,u,f,m,_,au,Jo,cu,sx,ox):e(s,l,c,d,h,g,p,f,u,_,m,lu,Ko,ip,rx,ax)}function ep(n,t){let e=0,i=0,s=Ae(n.bands,Jf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function HT(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ds(n,t,e,i,s,r){return Fr(n,t,(o,a,l,c,d,h,u,f,m,_,p)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),S=c.ori==0?Jo:Ko,b,C;v==1?(b=e,C=i):(b=i,C=e);let w=g(h(a[b],c,_,f)),x=g(u(l[b],d,p,m)),T=g(h(a[C],c,_,f)),B=g(u(r==1?d.max:d.min,d,p,m)),F=new Path2D(s);return S(F,T,B),S(F,w,B),S(F,w,x),F})}function ou(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?cu:ip,l=e;for(let h=0;h<n.length;h++){let u=n[h];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,i,f,i+r),l=u[1]}}let c=e+s-l,d=10;c>0&&a(o,l,i-d/2,c,i+r+d)}return o}function WT(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function np(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,u=c;if(s==1)for(;++c<=i&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let f=r(n[h]),m=u==h?f:r(n[u]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=u+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=f&&a.push([f,m])}return a}function M_(n){return n==0?D_:n==1?Mn:t=>Pr(t,n)}function ix(n){let t=n==0?au:lu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,d=0)=>{c==0&&d==0?i(s,r,o,a,l):(c=$i(c,a/2,l/2),d=$i(d,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,d),e(s,r,o+l,r,o,d),e(s,r,o,r+a,o,c),s.closePath())}}var au=(n,t,e)=>{n.moveTo(t,e)},lu=(n,t,e)=>{n.moveTo(e,t)},Jo=(n,t,e)=>{n.lineTo(t,e)},Ko=(n,t,e)=>{n.lineTo(e,t)},cu=ix(0),ip=ix(1),sx=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},rx=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},ox=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},ax=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function lx(n){return(t,e,i,s,r)=>Fr(t,e,(o,a,l,c,d,h,u,f,m,_,p)=>{let{pxRound:g,points:v}=o,S,b;c.ori==0?(S=au,b=sx):(S=lu,b=rx);let C=He(v.width*Re,3),w=(v.size-v.width)/2*Re,x=He(w*2,3),T=new Path2D,B=new Path2D,{left:F,top:L,width:G,height:H}=t.bbox;cu(B,F-x,L-x,G+x*2,H+x*2);let N=$=>{if(l[$]!=null){let Z=g(h(a[$],c,_,f)),W=g(u(l[$],d,p,m));S(T,Z+w,W),b(T,Z,W,w,0,jh*2)}};if(r)r.forEach(N);else for(let $=i;$<=s;$++)N($);return{stroke:C>0?T:null,fill:T,clip:B,flags:Yo|Vf}})}function cx(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var $T=cx(Jo),XT=cx(Ko);function hx(n){let t=Ae(n?.alignGaps,0);return(e,i,s,r)=>Fr(e,i,(o,a,l,c,d,h,u,f,m,_,p)=>{[s,r]=nu(l,s,r);let g=o.pxRound,v=H=>g(h(H,c,_,f)),S=H=>g(u(H,d,p,m)),b,C;c.ori==0?(b=Jo,C=$T):(b=Ko,C=XT);let w=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yo},T=x.stroke,B=!1;if(r-s>=_*4){let H=rt=>e.posToVal(rt,c.key,!0),N=null,$=null,Z,W,ut,D=v(a[w==1?s:r]),q=v(a[s]),K=v(a[r]),nt=H(w==1?q+1:K-1);for(let rt=w==1?s:r;rt>=s&&rt<=r;rt+=w){let tt=a[rt],mt=(w==1?tt<nt:tt>nt)?D:v(tt),xt=l[rt];mt==D?xt!=null?(W=xt,N==null?(b(T,mt,S(W)),Z=N=$=W):W<N?N=W:W>$&&($=W)):xt===null&&(B=!0):(N!=null&&C(T,D,S(N),S($),S(Z),S(W)),xt!=null?(W=xt,b(T,mt,S(W)),N=$=Z=W):(N=$=null,xt===null&&(B=!0)),D=mt,nt=H(D+w))}N!=null&&N!=$&&ut!=D&&C(T,D,S(N),S($),S(Z),S(W))}else for(let H=w==1?s:r;H>=s&&H<=r;H+=w){let N=l[H];N===null?B=!0:N!=null&&b(T,v(a[H]),S(N))}let[L,G]=ep(e,i);if(o.fill!=null||L!=0){let H=x.fill=new Path2D(T),N=o.fillTo(e,i,o.min,o.max,L),$=S(N),Z=v(a[s]),W=v(a[r]);w==-1&&([W,Z]=[Z,W]),b(H,W,$),b(H,Z,$)}if(!o.spanGaps){let H=[];B&&H.push(...np(a,l,s,r,w,v,t)),x.gaps=H=o.gaps(e,i,s,r,H),x.clip=ou(H,c.ori,f,m,_,p)}return G!=0&&(x.band=G==2?[Ds(e,i,s,r,T,-1),Ds(e,i,s,r,T,1)]:Ds(e,i,s,r,T,G)),x})}function qT(n){let t=Ae(n.align,1),e=Ae(n.ascDesc,!1),i=Ae(n.alignGaps,0),s=Ae(n.extend,!1);return(r,o,a,l)=>Fr(r,o,(c,d,h,u,f,m,_,p,g,v,S)=>{[a,l]=nu(h,a,l);let b=c.pxRound,{left:C,width:w}=r.bbox,x=q=>b(m(q,u,v,p)),T=q=>b(_(q,f,S,g)),B=u.ori==0?Jo:Ko,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yo},L=F.stroke,G=u.dir*(u.ori==0?1:-1),H=T(h[G==1?a:l]),N=x(d[G==1?a:l]),$=N,Z=N;s&&t==-1&&(Z=C,B(L,Z,H)),B(L,N,H);for(let q=G==1?a:l;q>=a&&q<=l;q+=G){let K=h[q];if(K==null)continue;let nt=x(d[q]),rt=T(K);t==1?B(L,nt,H):B(L,$,rt),B(L,nt,rt),H=rt,$=nt}let W=$;s&&t==1&&(W=C+w,B(L,W,H));let[ut,D]=ep(r,o);if(c.fill!=null||ut!=0){let q=F.fill=new Path2D(L),K=c.fillTo(r,o,c.min,c.max,ut),nt=T(K);B(q,W,nt),B(q,Z,nt)}if(!c.spanGaps){let q=[];q.push(...np(d,h,a,l,G,x,i));let K=c.width*Re/2,nt=e||t==1?K:-K,rt=e||t==-1?-K:K;q.forEach(tt=>{tt[0]+=nt,tt[1]+=rt}),F.gaps=q=c.gaps(r,o,a,l,q),F.clip=ou(q,u.ori,p,g,v,S)}return D!=0&&(F.band=D==2?[Ds(r,o,a,l,L,-1),Ds(r,o,a,l,L,1)]:Ds(r,o,a,l,L,D)),F})}function w_(n,t,e,i,s,r,o=Ge){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let d=wn(n[l]-n[a]);d<c&&(c=d,o=wn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function YT(n){n=n||vl;let t=Ae(n.size,[.6,Ge,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=we(s),o=1-t[0],a=Ae(t[1],Ge),l=Ae(t[2],1),c=Ae(n.disp,vl),d=Ae(n.each,f=>{}),{fill:h,stroke:u}=c;return(f,m,_,p)=>Fr(f,m,(g,v,S,b,C,w,x,T,B,F,L)=>{let G=g.pxRound,H=e,N=i*Re,$=a*Re,Z=l*Re,W,ut;b.ori==0?[W,ut]=r(f,m):[ut,W]=r(f,m);let D=b.dir*(b.ori==0?1:-1),q=b.ori==0?cu:ip,K=b.ori==0?d:(At,jt,ce,Ct,Ve,qt,Jt)=>{d(At,jt,ce,Ve,Ct,Jt,qt)},nt=Ae(f.bands,Jf).find(At=>At.series[0]==m),rt=nt!=null?nt.dir:0,tt=g.fillTo(f,m,g.min,g.max,rt),_t=G(x(tt,C,L,B)),mt,xt,wt,ot=F,Et=G(g.width*Re),vt=!1,Ht=null,Bt=null,zt=null,ge=null;h!=null&&(Et==0||u!=null)&&(vt=!0,Ht=h.values(f,m,_,p),Bt=new Map,new Set(Ht).forEach(At=>{At!=null&&Bt.set(At,new Path2D)}),Et>0&&(zt=u.values(f,m,_,p),ge=new Map,new Set(zt).forEach(At=>{At!=null&&ge.set(At,new Path2D)})));let{x0:fe,size:Ne}=c;if(fe!=null&&Ne!=null){H=1,v=fe.values(f,m,_,p),fe.unit==2&&(v=v.map(ce=>f.posToVal(T+ce*F,b.key,!0)));let At=Ne.values(f,m,_,p);Ne.unit==2?xt=At[0]*F:xt=w(At[0],b,F,T)-w(0,b,F,T),ot=w_(v,S,w,b,F,T,ot),wt=ot-xt+N}else ot=w_(v,S,w,b,F,T,ot),wt=ot*o+N,xt=ot-wt;wt<1&&(wt=0),Et>=xt/2&&(Et=0),wt<5&&(G=D_);let _e=wt>0,ze=ot-wt-(_e?Et:0);xt=G(Bf(ze,Z,$)),mt=(H==0?xt/2:H==D?0:xt)-H*D*((H==0?N/2:0)+(_e?Et/2:0));let he={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},We=vt?null:new Path2D,Qe=null;if(nt!=null)Qe=f.data[nt.series[1]];else{let{y0:At,y1:jt}=c;At!=null&&jt!=null&&(S=jt.values(f,m,_,p),Qe=At.values(f,m,_,p))}let rn=W*xt,k=ut*xt;for(let At=D==1?_:p;At>=_&&At<=p;At+=D){let jt=S[At];if(jt==null)continue;if(Qe!=null){let Y=Qe[At]??0;if(jt-Y==0)continue;_t=x(Y,C,L,B)}let ce=b.distr!=2||c!=null?v[At]:At,Ct=w(ce,b,F,T),Ve=x(Ae(jt,tt),C,L,B),qt=G(Ct-mt),Jt=G(Jn(Ve,_t)),P=G($i(Ve,_t)),M=Jt-P;if(jt!=null){let Y=jt<0?k:rn,ft=jt<0?rn:k;vt?(Et>0&&zt[At]!=null&&q(ge.get(zt[At]),qt,P+_i(Et/2),xt,Jn(0,M-Et),Y,ft),Ht[At]!=null&&q(Bt.get(Ht[At]),qt,P+_i(Et/2),xt,Jn(0,M-Et),Y,ft)):q(We,qt,P+_i(Et/2),xt,Jn(0,M-Et),Y,ft),K(f,m,At,qt-Et/2,P,xt+Et,M)}}return Et>0?he.stroke=vt?ge:We:vt||(he._fill=g.width==0?g._fill:g._stroke??g._fill,he.width=0),he.fill=vt?Bt:We,he})}function ZT(n,t){let e=Ae(t?.alignGaps,0);return(i,s,r,o)=>Fr(i,s,(a,l,c,d,h,u,f,m,_,p,g)=>{[r,o]=nu(c,r,o);let v=a.pxRound,S=W=>v(u(W,d,p,m)),b=W=>v(f(W,h,g,_)),C,w,x;d.ori==0?(C=au,x=Jo,w=ox):(C=lu,x=Ko,w=ax);let T=d.dir*(d.ori==0?1:-1),B=S(l[T==1?r:o]),F=B,L=[],G=[];for(let W=T==1?r:o;W>=r&&W<=o;W+=T)if(c[W]!=null){let D=l[W],q=S(D);L.push(F=q),G.push(b(c[W]))}let H={stroke:n(L,G,C,x,w,v),fill:null,clip:null,band:null,gaps:null,flags:Yo},N=H.stroke,[$,Z]=ep(i,s);if(a.fill!=null||$!=0){let W=H.fill=new Path2D(N),ut=a.fillTo(i,s,a.min,a.max,$),D=b(ut);x(W,F,D),x(W,B,D)}if(!a.spanGaps){let W=[];W.push(...np(l,c,r,o,T,S,e)),H.gaps=W=a.gaps(i,s,r,o,W),H.clip=ou(W,d.ori,m,_,p,g)}return Z!=0&&(H.band=Z==2?[Ds(i,s,r,o,N,-1),Ds(i,s,r,o,N,1)]:Ds(i,s,r,o,N,Z)),H})}function JT(n){return ZT(KT,n)}function KT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),d=Array(o-1),h=Array(o-1);for(let u=0;u<o-1;u++)d[u]=t[u+1]-t[u],h[u]=n[u+1]-n[u],c[u]=d[u]/h[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(h[u-1]+h[u])/((2*h[u]+h[u-1])/c[u-1]+(h[u]+2*h[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+h[u]/3,t[u]+l[u]*h[u]/3,n[u+1]-h[u]/3,t[u+1]-l[u+1]*h[u]/3,n[u+1],t[u+1])}return a}var Gf=new Set;function E_(){for(let n of Gf)n.syncRect(!0)}Zo&&(Dr(IE,Wo,E_),Dr(LE,Wo,E_,!0),Dr(Qh,Wo,()=>{Fn.pxRatio=Re}));var jT=hx(),QT=lx();function T_(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Hf(r,o,t,e))}function tA(n,t){return n.map((e,i)=>i==0?{}:xn({},t,e))}function Hf(n,t,e,i){return xn({},t==0?e:i,n)}function ux(n,t,e){return t==null?Xo:[t,e]}var eA=ux;function nA(n,t,e){return t==null?Xo:tu(t,e,Yf,!0)}function dx(n,t,e,i){return t==null?Xo:iu(t,e,n.scales[i].log,!1)}var iA=dx;function fx(n,t,e,i){return t==null?Xo:qf(t,e,n.scales[i].log,!1)}var sA=fx;function rA(n,t,e,i,s){let r=Jn(s_(n),s_(t)),o=t-n,a=Wi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?lr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function A_(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Mn((e=+s)*Re))+"px"),[n,t,e]}function oA(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=He(t[2]*Re,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Fn(n,t,e){let i={mode:Ae(n.mode,1)},s=i.mode;function r(y,E,I,U){let X=E.valToPct(y);return U+I*(E.dir==-1?1-X:X)}function o(y,E,I,U){let X=E.valToPct(y);return U+I*(E.dir==-1?X:1-X)}function a(y,E,I,U){return E.ori==0?r(y,E,I,U):o(y,E,I,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ti(fE);if(n.id!=null&&(c.id=n.id),gi(c,n.class),n.title){let y=Ti(gE,c);y.textContent=n.title}let d=Hi("canvas"),h=i.ctx=d.getContext("2d"),u=Ti(_E,c);Dr("click",u,y=>{y.target===m&&(Xe!=Gr||tn!=Hr)&&Ln.click(i,y)},!0);let f=i.under=Ti(xE,u);u.appendChild(d);let m=i.over=Ti(yE,u);n=qo(n);let _=+Ae(n.pxAlign,1),p=M_(_);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let g=n.ms||.001,v=i.series=s==1?T_(n.series||[],g_,b_,!1):tA(n.series||[null],v_),S=i.axes=T_(n.axes||[],m_,x_,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(y=>{y.fill=we(y.fill||null),y.dir=Ae(y.dir,-1)});let w=s==2?v[1].facets[0].scale:v[0].scale,x={axes:gs,series:ye},T=(n.drawOrder||["axes","series"]).map(y=>x[y]);function B(y){let E=y.distr==3?I=>Ls(I>0?I:y.clamp(i,I,y.min,y.max,y.key)):y.distr==4?I=>Pf(I,y.asinh):y.distr==100?I=>y.fwd(I):I=>I;return I=>{let U=E(I),{_min:X,_max:Q}=y,ht=Q-X;return(U-X)/ht}}function F(y){let E=b[y];if(E==null){let I=(n.scales||vl)[y]||vl;if(I.from!=null){F(I.from);let U=xn({},b[I.from],I,{key:y});U.valToPct=B(U),b[y]=U}else{E=b[y]=xn({},y==w?ex:GT,I),E.key=y;let U=E.time,X=E.range,Q=ar(X);if((y!=w||s==2&&!U)&&(Q&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?e_:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?e_:{mode:1,hard:X[1],soft:X[1]}},Q=!1),!Q&&ru(X))){let ht=X;X=(pt,Mt,Ot)=>Mt==null?Xo:tu(Mt,Ot,ht)}E.range=we(X||(U?eA:y==w?E.distr==3?iA:E.distr==4?sA:ux:E.distr==3?dx:E.distr==4?fx:nA)),E.auto=we(Q?!1:E.auto),E.clamp=we(E.clamp||VT),E._min=E._max=null,E.valToPct=B(E)}}}F("x"),F("y"),s==1&&v.forEach(y=>{F(y.scale)}),S.forEach(y=>{F(y.scale)});for(let y in n.scales)F(y);let L=b[w],G=L.distr,H,N;L.ori==0?(gi(c,pE),H=r,N=o):(gi(c,mE),H=o,N=r);let $={};for(let y in b){let E=b[y];(E.min!=null||E.max!=null)&&($[y]={min:E.min,max:E.max},E.min=E.max=null)}let Z=n.tzDate||(y=>new Date(Mn(y/g))),W=n.fmtDate||Kf,ut=g==1?pT(Z):_T(Z),D=d_(Z,u_(g==1?fT:gT,W)),q=p_(Z,f_(yT,W)),K=[],nt=i.legend=xn({},ST,n.legend),rt=i.cursor=xn({},CT,{drag:{y:s==2}},n.cursor),tt=nt.show,_t=rt.show,mt=nt.markers;nt.idxs=K,mt.width=we(mt.width),mt.dash=we(mt.dash),mt.stroke=we(mt.stroke),mt.fill=we(mt.fill);let xt,wt,ot,Et=[],vt=[],Ht,Bt=!1,zt={};if(nt.live){let y=v[1]?v[1].values:null;Bt=y!=null,Ht=Bt?y(i,1,0):{_:0};for(let E in Ht)zt[E]=$f}if(tt)if(xt=Hi("table",EE,c),ot=Hi("tbody",null,xt),nt.mount(i,xt),Bt){wt=Hi("thead",null,xt,ot);let y=Hi("tr",null,wt);Hi("th",null,y);for(var ge in Ht)Hi("th",G0,y).textContent=ge}else gi(xt,AE),nt.live&&gi(xt,TE);let fe={show:!0},Ne={show:!1};function _e(y,E){if(E==0&&(Bt||!nt.live||s==2))return Xo;let I=[],U=Hi("tr",CE,ot,ot.childNodes[E]);gi(U,y.class),y.show||gi(U,Lr);let X=Hi("th",null,U);if(mt.show){let pt=Ti(RE,X);if(E>0){let Mt=mt.width(i,E);Mt&&(pt.style.border=Mt+"px "+mt.dash(i,E)+" "+mt.stroke(i,E)),pt.style.background=mt.fill(i,E)}}let Q=Ti(G0,X);y.label instanceof HTMLElement?Q.appendChild(y.label):Q.textContent=y.label,E>0&&(mt.show||(Q.style.color=y.width>0?mt.stroke(i,E):mt.fill(i,E)),he("click",X,pt=>{if(rt._lock)return;te(pt);let Mt=v.indexOf(y);if((pt.ctrlKey||pt.metaKey)!=nt.isolate){let Ot=v.some((kt,Gt)=>Gt>0&&Gt!=Mt&&kt.show);v.forEach((kt,Gt)=>{Gt>0&&Ki(Gt,Ot?Gt==Mt?fe:Ne:fe,!0,gn.setSeries)})}else Ki(Mt,{show:!y.show},!0,gn.setSeries)},!1),ee&&he(X0,X,pt=>{rt._lock||(te(pt),Ki(v.indexOf(y),$r,!0,gn.setSeries))},!1));for(var ht in Ht){let pt=Hi("td",PE,U);pt.textContent="--",I.push(pt)}return[U,I]}let ze=new Map;function he(y,E,I,U=!0){let X=ze.get(E)||{},Q=rt.bind[y](i,E,I,U);Q&&(Dr(y,E,X[y]=Q),ze.set(E,X))}function We(y,E,I){let U=ze.get(E)||{};for(let X in U)(y==null||X==y)&&(Of(X,E,U[X]),delete U[X]);y==null&&ze.delete(E)}let Qe=0,rn=0,k=0,At=0,jt=0,ce=0,Ct=jt,Ve=ce,qt=k,Jt=At,P=0,M=0,Y=0,ft=0;i.bbox={};let ct=!1,bt=!1,St=!1,it=!1,at=!1,gt=!1;function z(y,E,I){(I||y!=i.width||E!=i.height)&&lt(y,E),pe(!1),St=!0,bt=!0,Un()}function lt(y,E){i.width=Qe=k=y,i.height=rn=At=E,jt=ce=0,Tt(),Yt();let I=i.bbox;P=I.left=Pr(jt*Re,.5),M=I.top=Pr(ce*Re,.5),Y=I.width=Pr(k*Re,.5),ft=I.height=Pr(At*Re,.5)}let st=3;function Rt(){let y=!1,E=0;for(;!y;){E++;let I=kr(E),U=Ji(E);y=E==st||I&&U,y||(lt(i.width,i.height),bt=!0)}}function yt({width:y,height:E}){z(y,E)}i.setSize=yt;function Tt(){let y=!1,E=!1,I=!1,U=!1;S.forEach((X,Q)=>{if(X.show&&X._show){let{side:ht,_size:pt}=X,Mt=ht%2,Ot=X.label!=null?X.labelSize:0,kt=pt+Ot;kt>0&&(Mt?(k-=kt,ht==3?(jt+=kt,U=!0):I=!0):(At-=kt,ht==0?(ce+=kt,y=!0):E=!0))}}),Yi[0]=y,Yi[1]=I,Yi[2]=E,Yi[3]=U,k-=Ci[1]+Ci[3],jt+=Ci[3],At-=Ci[2]+Ci[0],ce+=Ci[0]}function Yt(){let y=jt+k,E=ce+At,I=jt,U=ce;function X(Q,ht){switch(Q){case 1:return y+=ht,y-ht;case 2:return E+=ht,E-ht;case 3:return I-=ht,I+ht;case 0:return U-=ht,U+ht}}S.forEach((Q,ht)=>{if(Q.show&&Q._show){let pt=Q.side;Q._pos=X(pt,Q._size),Q.label!=null&&(Q._lpos=X(pt,Q.labelSize))}})}if(rt.dataIdx==null){let y=rt.hover,E=y.skip=new Set(y.skip??[]);E.add(void 0);let I=y.prox=we(y.prox),U=y.bias??=0;rt.dataIdx=(X,Q,ht,pt)=>{if(Q==0)return ht;let Mt=ht,Ot=I(X,Q,ht,pt)??Ge,kt=Ot>=0&&Ot<Ge,Gt=L.ori==0?k:At,ae=rt.left,Ce=t[0],Te=t[Q];if(E.has(Te[ht])){Mt=null;let be=null,Qt=null,Zt;if(U==0||U==-1)for(Zt=ht;be==null&&Zt-- >0;)E.has(Te[Zt])||(be=Zt);if(U==0||U==1)for(Zt=ht;Qt==null&&Zt++<Te.length;)E.has(Te[Zt])||(Qt=Zt);if(be!=null||Qt!=null)if(kt){let Ye=be==null?-1/0:H(Ce[be],L,Gt,0),ln=Qt==null?1/0:H(Ce[Qt],L,Gt,0),Rn=ae-Ye,ke=ln-ae;Rn<=ke?Rn<=Ot&&(Mt=be):ke<=Ot&&(Mt=Qt)}else Mt=Qt==null?be:be==null?Qt:ht-be<=Qt-ht?be:Qt}else kt&&wn(ae-H(Ce[ht],L,Gt,0))>Ot&&(Mt=null);return Mt}}let te=y=>{rt.event=y};rt.idxs=K,rt._lock=!1;let dt=rt.points;dt.show=we(dt.show),dt.size=we(dt.size),dt.stroke=we(dt.stroke),dt.width=we(dt.width),dt.fill=we(dt.fill);let Wt=i.focus=xn({},n.focus||{alpha:.3},rt.focus),ee=Wt.prox>=0,Lt=ee&&dt.one,ue=[],$e=[],Vn=[];function ea(y,E){let I=dt.show(i,E);if(I instanceof HTMLElement)return gi(I,wE),gi(I,y.class),ds(I,-10,-10,k,At),m.insertBefore(I,ue[E]),I}function Ur(y,E){if(s==1||E>0){let I=s==1&&b[y.scale].time,U=y.value;y.value=I?a_(U)?p_(Z,f_(U,W)):U||q:U||BT,y.label=y.label||(I?PT:RT)}if(Lt||E>0){y.width=y.width==null?1:y.width,y.paths=y.paths||jT||GE,y.fillTo=we(y.fillTo||HT),y.pxAlign=+Ae(y.pxAlign,_),y.pxRound=M_(y.pxAlign),y.stroke=we(y.stroke||null),y.fill=we(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let I=kT(Jn(1,y.width),1),U=y.points=xn({},{size:I,width:Jn(1,I*.2),stroke:y.stroke,space:I*2,paths:QT,_stroke:null,_fill:null},y.points);U.show=we(U.show),U.filter=we(U.filter),U.fill=we(U.fill),U.stroke=we(U.stroke),U.paths=we(U.paths),U.pxAlign=y.pxAlign}if(tt){let I=_e(y,E);Et.splice(E,0,I[0]),vt.splice(E,0,I[1]),nt.values.push(null)}if(_t){K.splice(E,0,null);let I=null;Lt?E==0&&(I=ea(y,E)):E>0&&(I=ea(y,E)),ue.splice(E,0,I),$e.splice(E,0,0),Vn.splice(E,0,0)}Cn("addSeries",E)}function Au(y,E){E=E??v.length,y=s==1?Hf(y,E,g_,b_):Hf(y,E,{},v_),v.splice(E,0,y),Ur(v[E],E)}i.addSeries=Au;function Al(y){if(v.splice(y,1),tt){nt.values.splice(y,1),vt.splice(y,1);let E=Et.splice(y,1)[0];We(null,E.firstChild),E.remove()}_t&&(K.splice(y,1),ue.splice(y,1)[0].remove(),$e.splice(y,1),Vn.splice(y,1)),Cn("delSeries",y)}i.delSeries=Al;let Yi=[!1,!1,!1,!1];function fs(y,E){if(y._show=y.show,y.show){let I=y.side%2,U=b[y.scale];U==null&&(y.scale=I?v[1].scale:w,U=b[y.scale]);let X=U.time;y.size=we(y.size),y.space=we(y.space),y.rotate=we(y.rotate),ar(y.incrs)&&y.incrs.forEach(ht=>{!lr.has(ht)&&lr.set(ht,U_(ht))}),y.incrs=we(y.incrs||(U.distr==2?hT:X?g==1?dT:mT:Ir)),y.splits=we(y.splits||(X&&U.distr==1?ut:U.distr==3?kf:U.distr==4?DT:LT)),y.stroke=we(y.stroke),y.grid.stroke=we(y.grid.stroke),y.ticks.stroke=we(y.ticks.stroke),y.border.stroke=we(y.border.stroke);let Q=y.values;y.values=ar(Q)&&!ar(Q[0])?we(Q):X?ar(Q)?d_(Z,u_(Q,W)):a_(Q)?xT(Z,Q):Q||D:Q||IT,y.filter=we(y.filter||(U.distr>=3&&U.log==10?UT:U.distr==3&&U.log==2?OT:N_)),y.font=A_(y.font),y.labelFont=A_(y.labelFont),y._size=y.size(i,null,E,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Yi[E]=!0,y._el=Ti(vE,u))}}function ps(y,E,I,U){let[X,Q,ht,pt]=I,Mt=E%2,Ot=0;return Mt==0&&(pt||Q)&&(Ot=E==0&&!X||E==2&&!ht?Mn(m_.size/3):0),Mt==1&&(X||ht)&&(Ot=E==1&&!Q||E==3&&!pt?Mn(x_.size/2):0),Ot}let na=i.padding=(n.padding||[ps,ps,ps,ps]).map(y=>we(Ae(y,ps))),Ci=i._padding=na.map((y,E)=>y(i,E,Yi,0)),on,un=null,dn=null,Zi=s==1?v[0].idxs:null,ii=null,Fs=!1;function ia(y,E){if(t=y??[],i.data=i._data=t,s==2){on=0;for(let I=1;I<v.length;I++)on+=t[I][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ii=t[0],on=ii.length;let I=t;if(G==2){I=t.slice();let U=I[0]=Array(on);for(let X=0;X<on;X++)U[X]=X}i._data=t=I}if(pe(!0),Cn("setData"),G==2&&(St=!0),E!==!1){let I=L;I.auto(i,Fs)?sa():Bs(w,I.min,I.max),it=it||rt.left>=0,gt=!0,Un()}}i.setData=ia;function sa(){Fs=!0;let y,E;s==1&&(on>0?(un=Zi[0]=0,dn=Zi[1]=on-1,y=t[0][un],E=t[0][dn],G==2?(y=un,E=dn):y==E&&(G==3?[y,E]=iu(y,y,L.log,!1):G==4?[y,E]=qf(y,y,L.log,!1):L.time?E=y+Mn(86400/g):[y,E]=tu(y,E,Yf,!0))):(un=Zi[0]=y=null,dn=Zi[1]=E=null)),Bs(w,y,E)}let Or,Us,Br,A,V,et,J,j,Pt,Nt;function It(y,E,I,U,X,Q){y??=W0,I??=Jf,U??="butt",X??=W0,Q??="round",y!=Or&&(h.strokeStyle=Or=y),X!=Us&&(h.fillStyle=Us=X),E!=Br&&(h.lineWidth=Br=E),Q!=V&&(h.lineJoin=V=Q),U!=et&&(h.lineCap=et=U),I!=A&&h.setLineDash(A=I)}function Ft(y,E,I,U){E!=Us&&(h.fillStyle=Us=E),y!=J&&(h.font=J=y),I!=j&&(h.textAlign=j=I),U!=Pt&&(h.textBaseline=Pt=U)}function Xt(y,E,I,U,X=0){if(U.length>0&&y.auto(i,Fs)&&(E==null||E.min==null)){let Q=Ae(un,0),ht=Ae(dn,U.length-1),pt=I.min==null?UE(U,Q,ht,X,y.distr==3):[I.min,I.max];y.min=$i(y.min,I.min=pt[0]),y.max=Jn(y.max,I.max=pt[1])}}let se={min:null,max:null};function xe(){for(let U in b){let X=b[U];$[U]==null&&(X.min==null||$[w]!=null&&X.auto(i,Fs))&&($[U]=se)}for(let U in b){let X=b[U];$[U]==null&&X.from!=null&&$[X.from]!=null&&($[U]=se)}$[w]!=null&&pe(!0);let y={};for(let U in $){let X=$[U];if(X!=null){let Q=y[U]=qo(b[U],$E);if(X.min!=null)xn(Q,X);else if(U!=w||s==2)if(on==0&&Q.from==null){let ht=Q.range(i,null,null,U);Q.min=ht[0],Q.max=ht[1]}else Q.min=Ge,Q.max=-Ge}}if(on>0){v.forEach((U,X)=>{if(s==1){let Q=U.scale,ht=$[Q];if(ht==null)return;let pt=y[Q];if(X==0){let Mt=pt.range(i,pt.min,pt.max,Q);pt.min=Mt[0],pt.max=Mt[1],un=Wi(pt.min,t[0]),dn=Wi(pt.max,t[0]),dn-un>1&&(t[0][un]<pt.min&&un++,t[0][dn]>pt.max&&dn--),U.min=ii[un],U.max=ii[dn]}else U.show&&U.auto&&Xt(pt,ht,U,t[X],U.sorted);U.idxs[0]=un,U.idxs[1]=dn}else if(X>0&&U.show&&U.auto){let[Q,ht]=U.facets,pt=Q.scale,Mt=ht.scale,[Ot,kt]=t[X],Gt=y[pt],ae=y[Mt];Gt!=null&&Xt(Gt,$[pt],Q,Ot,Q.sorted),ae!=null&&Xt(ae,$[Mt],ht,kt,ht.sorted),U.min=ht.min,U.max=ht.max}});for(let U in y){let X=y[U],Q=$[U];if(X.from==null&&(Q==null||Q.min==null)){let ht=X.range(i,X.min==Ge?null:X.min,X.max==-Ge?null:X.max,U);X.min=ht[0],X.max=ht[1]}}}for(let U in y){let X=y[U];if(X.from!=null){let Q=y[X.from];if(Q.min==null)X.min=X.max=null;else{let ht=X.range(i,Q.min,Q.max,U);X.min=ht[0],X.max=ht[1]}}}let E={},I=!1;for(let U in y){let X=y[U],Q=b[U];if(Q.min!=X.min||Q.max!=X.max){Q.min=X.min,Q.max=X.max;let ht=Q.distr;Q._min=ht==3?Ls(Q.min):ht==4?Pf(Q.min,Q.asinh):ht==100?Q.fwd(Q.min):Q.min,Q._max=ht==3?Ls(Q.max):ht==4?Pf(Q.max,Q.asinh):ht==100?Q.fwd(Q.max):Q.max,E[U]=I=!0}}if(I){v.forEach((U,X)=>{s==2?X>0&&E.y&&(U._paths=null):E[U.scale]&&(U._paths=null)});for(let U in E)St=!0,Cn("setScale",U);_t&&rt.left>=0&&(it=gt=!0)}for(let U in $)$[U]=null}function $t(y){let E=Bf(un-1,0,on-1),I=Bf(dn+1,0,on-1);for(;y[E]==null&&E>0;)E--;for(;y[I]==null&&I<on-1;)I++;return[E,I]}function ye(){if(on>0){let y=v.some(E=>E._focus)&&Nt!=Wt.alpha;y&&(h.globalAlpha=Nt=Wt.alpha),v.forEach((E,I)=>{if(I>0&&E.show&&(nn(I,!1),nn(I,!0),E._paths==null)){let U=Nt;Nt!=E.alpha&&(h.globalAlpha=Nt=E.alpha);let X=s==2?[0,t[I][0].length-1]:$t(t[I]);E._paths=E.paths(i,I,X[0],X[1]),Nt!=U&&(h.globalAlpha=Nt=U)}}),v.forEach((E,I)=>{if(I>0&&E.show){let U=Nt;Nt!=E.alpha&&(h.globalAlpha=Nt=E.alpha),E._paths!=null&&Fe(I,!1);{let X=E._paths!=null?E._paths.gaps:null,Q=E.points.show(i,I,un,dn,X),ht=E.points.filter(i,I,Q,X);(Q||ht)&&(E.points._paths=E.points.paths(i,I,un,dn,ht),Fe(I,!0))}Nt!=U&&(h.globalAlpha=Nt=U),Cn("drawSeries",I)}}),y&&(h.globalAlpha=Nt=1)}}function nn(y,E){let I=E?v[y].points:v[y];I._stroke=I.stroke(i,y),I._fill=I.fill(i,y)}function Fe(y,E){let I=E?v[y].points:v[y],{stroke:U,fill:X,clip:Q,flags:ht,_stroke:pt=I._stroke,_fill:Mt=I._fill,_width:Ot=I.width}=I._paths;Ot=He(Ot*Re,3);let kt=null,Gt=Ot%2/2;E&&Mt==null&&(Mt=Ot>0?"#fff":pt);let ae=I.pxAlign==1&&Gt>0;if(ae&&h.translate(Gt,Gt),!E){let Ce=P-Ot/2,Te=M-Ot/2,be=Y+Ot,Qt=ft+Ot;kt=new Path2D,kt.rect(Ce,Te,be,Qt)}E?Vt(pt,Ot,I.dash,I.cap,Mt,U,X,ht,Q):Ue(y,pt,Ot,I.dash,I.cap,Mt,U,X,ht,kt,Q),ae&&h.translate(-Gt,-Gt)}function Ue(y,E,I,U,X,Q,ht,pt,Mt,Ot,kt){let Gt=!1;Mt!=0&&C.forEach((ae,Ce)=>{if(ae.series[0]==y){let Te=v[ae.series[1]],be=t[ae.series[1]],Qt=(Te._paths||vl).band;ar(Qt)&&(Qt=ae.dir==1?Qt[0]:Qt[1]);let Zt,Ye=null;Te.show&&Qt&&BE(be,un,dn)?(Ye=ae.fill(i,Ce)||Q,Zt=Te._paths.clip):Qt=null,Vt(E,I,U,X,Ye,ht,pt,Mt,Ot,kt,Zt,Qt),Gt=!0}}),Gt||Vt(E,I,U,X,Q,ht,pt,Mt,Ot,kt)}let yn=Yo|Vf;function Vt(y,E,I,U,X,Q,ht,pt,Mt,Ot,kt,Gt){It(y,E,I,U,X),(Mt||Ot||Gt)&&(h.save(),Mt&&h.clip(Mt),Ot&&h.clip(Ot)),Gt?(pt&yn)==yn?(h.clip(Gt),kt&&h.clip(kt),Se(X,ht),fn(y,Q,E)):pt&Vf?(Se(X,ht),h.clip(Gt),fn(y,Q,E)):pt&Yo&&(h.save(),h.clip(Gt),kt&&h.clip(kt),Se(X,ht),h.restore(),fn(y,Q,E)):(Se(X,ht),fn(y,Q,E)),(Mt||Ot||Gt)&&h.restore()}function fn(y,E,I){I>0&&(E instanceof Map?E.forEach((U,X)=>{h.strokeStyle=Or=X,h.stroke(U)}):E!=null&&y&&h.stroke(E))}function Se(y,E){E instanceof Map?E.forEach((I,U)=>{h.fillStyle=Us=U,h.fill(I)}):E!=null&&y&&h.fill(E)}function ms(y,E,I,U){let X=S[y],Q;if(U<=0)Q=[0,0];else{let ht=X._space=X.space(i,y,E,I,U),pt=X._incrs=X.incrs(i,y,E,I,U,ht);Q=rA(E,I,pt,U,ht)}return X._found=Q}function pn(y,E,I,U,X,Q,ht,pt,Mt,Ot){let kt=ht%2/2;_==1&&h.translate(kt,kt),It(pt,ht,Mt,Ot,pt),h.beginPath();let Gt,ae,Ce,Te,be=X+(U==0||U==3?-Q:Q);I==0?(ae=X,Te=be):(Gt=X,Ce=be);for(let Qt=0;Qt<y.length;Qt++)E[Qt]!=null&&(I==0?Gt=Ce=y[Qt]:ae=Te=y[Qt],h.moveTo(Gt,ae),h.lineTo(Ce,Te));h.stroke(),_==1&&h.translate(-kt,-kt)}function kr(y){let E=!0;return S.forEach((I,U)=>{if(!I.show)return;let X=b[I.scale];if(X.min==null){I._show&&(E=!1,I._show=!1,pe(!1));return}else I._show||(E=!1,I._show=!0,pe(!1));let Q=I.side,ht=Q%2,{min:pt,max:Mt}=X,[Ot,kt]=ms(U,pt,Mt,ht==0?k:At);if(kt==0)return;let Gt=X.distr==2,ae=I._splits=I.splits(i,U,pt,Mt,Ot,kt,Gt),Ce=X.distr==2?ae.map(Zt=>ii[Zt]):ae,Te=X.distr==2?ii[ae[1]]-ii[ae[0]]:Ot,be=I._values=I.values(i,I.filter(i,Ce,U,kt,Te),U,kt,Te);I._rotate=Q==2?I.rotate(i,be,U,kt):0;let Qt=I._size;I._size=Ai(I.size(i,be,U,y)),Qt!=null&&I._size!=Qt&&(E=!1)}),E}function Ji(y){let E=!0;return na.forEach((I,U)=>{let X=I(i,U,Yi,y);X!=Ci[U]&&(E=!1),Ci[U]=X}),E}function gs(){for(let y=0;y<S.length;y++){let E=S[y];if(!E.show||!E._show)continue;let I=E.side,U=I%2,X,Q,ht=E.stroke(i,y),pt=I==0||I==3?-1:1,[Mt,Ot]=E._found;if(E.label!=null){let Wn=E.labelGap*pt,oi=Mn((E._lpos+Wn)*Re);Ft(E.labelFont[0],ht,"center",I==2?"top":H0),h.save(),U==1?(X=Q=0,h.translate(oi,Mn(M+ft/2)),h.rotate((I==3?-jh:jh)/2)):(X=Mn(P+Y/2),Q=oi);let dr=L_(E.label)?E.label(i,y,Mt,Ot):E.label;h.fillText(dr,X,Q),h.restore()}if(Ot==0)continue;let kt=b[E.scale],Gt=U==0?Y:ft,ae=U==0?P:M,Ce=E._splits,Te=kt.distr==2?Ce.map(Wn=>ii[Wn]):Ce,be=kt.distr==2?ii[Ce[1]]-ii[Ce[0]]:Mt,Qt=E.ticks,Zt=E.border,Ye=Qt.show?Qt.size:0,ln=Mn(Ye*Re),Rn=Mn((E.alignTo==2?E._size-Ye-E.gap:E.gap)*Re),ke=E._rotate*-jh/180,cn=p(E._pos*Re),si=(ln+Rn)*pt,Hn=cn+si;Q=U==0?Hn:0,X=U==1?Hn:0;let yi=E.font[0],Ri=E.align==1?Go:E.align==2?Af:ke>0?Go:ke<0?Af:U==0?"center":I==3?Af:Go,Qi=ke||U==1?"middle":I==2?"top":H0;Ft(yi,ht,Ri,Qi);let ri=E.font[1]*E.lineGap,vi=Ce.map(Wn=>p(a(Wn,kt,Gt,ae))),Pi=E._values;for(let Wn=0;Wn<Pi.length;Wn++){let oi=Pi[Wn];if(oi!=null){U==0?X=vi[Wn]:Q=vi[Wn],oi=""+oi;let dr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let $n=0;$n<dr.length;$n++){let Lp=dr[$n];ke?(h.save(),h.translate(X,Q+$n*ri),h.rotate(ke),h.fillText(Lp,0,0),h.restore()):h.fillText(Lp,X,Q+$n*ri)}}}Qt.show&&pn(vi,Qt.filter(i,Te,y,Ot,be),U,I,cn,ln,He(Qt.width*Re,3),Qt.stroke(i,y),Qt.dash,Qt.cap);let ts=E.grid;ts.show&&pn(vi,ts.filter(i,Te,y,Ot,be),U,U==0?2:1,U==0?M:P,U==0?ft:Y,He(ts.width*Re,3),ts.stroke(i,y),ts.dash,ts.cap),Zt.show&&pn([cn],[1],U==0?1:0,U==0?1:2,U==1?M:P,U==1?ft:Y,He(Zt.width*Re,3),Zt.stroke(i,y),Zt.dash,Zt.cap)}Cn("drawAxes")}function pe(y){v.forEach((E,I)=>{I>0&&(E._paths=null,y&&(s==1?(E.min=null,E.max=null):E.facets.forEach(U=>{U.min=null,U.max=null})))})}let an=!1,Gn=!1,Oe=[];function mn(){Gn=!1;for(let y=0;y<Oe.length;y++)Cn(...Oe[y]);Oe.length=0}function Un(){an||(jE(pp),an=!0)}function Cl(y,E=!1){an=!0,Gn=E,y(i),pp(),E&&Oe.length>0&&queueMicrotask(mn)}i.batch=Cl;function pp(){if(ct&&(xe(),ct=!1),St&&(Rt(),St=!1),bt){if(je(f,Go,jt),je(f,"top",ce),je(f,gl,k),je(f,_l,At),je(m,Go,jt),je(m,"top",ce),je(m,gl,k),je(m,_l,At),je(u,gl,Qe),je(u,_l,rn),d.width=Mn(Qe*Re),d.height=Mn(rn*Re),S.forEach(({_el:y,_show:E,_size:I,_pos:U,side:X})=>{if(y!=null)if(E){let Q=X===3||X===0?I:0,ht=X%2==1;je(y,ht?"left":"top",U-Q),je(y,ht?"width":"height",I),je(y,ht?"top":"left",ht?ce:jt),je(y,ht?"height":"width",ht?At:k),Uf(y,Lr)}else gi(y,Lr)}),Or=Us=Br=V=et=J=j=Pt=A=null,Nt=1,aa(!0),jt!=Ct||ce!=Ve||k!=qt||At!=Jt){pe(!1);let y=k/qt,E=At/Jt;if(_t&&!it&&rt.left>=0){rt.left*=y,rt.top*=E,zr&&ds(zr,Mn(rt.left),0,k,At),Vr&&ds(Vr,0,Mn(rt.top),k,At);for(let I=0;I<ue.length;I++){let U=ue[I];U!=null&&($e[I]*=y,Vn[I]*=E,ds(U,Ai($e[I]),Ai(Vn[I]),k,At))}}if(qe.show&&!at&&qe.left>=0&&qe.width>0){qe.left*=y,qe.width*=y,qe.top*=E,qe.height*=E;for(let I in Du)je(Wr,I,qe[I])}Ct=jt,Ve=ce,qt=k,Jt=At}Cn("setSize"),bt=!1}Qe>0&&rn>0&&(h.clearRect(0,0,d.width,d.height),Cn("drawClear"),T.forEach(y=>y()),Cn("draw")),qe.show&&at&&(Rl(qe),at=!1),_t&&it&&(ur(null,!0,!1),it=!1),nt.show&&nt.live&&gt&&(Iu(),gt=!1),l||(l=!0,i.status=1,Cn("ready")),Fs=!1,an=!1}i.redraw=(y,E)=>{St=E||!1,y!==!1?Bs(w,L.min,L.max):Un()};function Cu(y,E){let I=b[y];if(I.from==null){if(on==0){let U=I.range(i,E.min,E.max,y);E.min=U[0],E.max=U[1]}if(E.min>E.max){let U=E.min;E.min=E.max,E.max=U}if(on>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;y==w&&I.distr==2&&on>0&&(E.min=Wi(E.min,t[0]),E.max=Wi(E.max,t[0]),E.min==E.max&&E.max++),$[y]=E,ct=!0,Un()}}i.setScale=Cu;let Ru,Pu,zr,Vr,mp,gp,Gr,Hr,_p,xp,Xe,tn,Os=!1,Ln=rt.drag,Tn=Ln.x,An=Ln.y;_t&&(rt.x&&(Ru=Ti(SE,m)),rt.y&&(Pu=Ti(ME,m)),L.ori==0?(zr=Ru,Vr=Pu):(zr=Pu,Vr=Ru),Xe=rt.left,tn=rt.top);let qe=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Wr=qe.show?Ti(bE,qe.over?m:f):null;function Rl(y,E){if(qe.show){for(let I in y)qe[I]=y[I],I in Du&&je(Wr,I,y[I]);E!==!1&&Cn("setSelect")}}i.setSelect=Rl;function Qx(y){if(v[y].show)tt&&Uf(Et[y],Lr);else if(tt&&gi(Et[y],Lr),_t){let I=Lt?ue[0]:ue[y];I!=null&&ds(I,-10,-10,k,At)}}function Bs(y,E,I){Cu(y,{min:E,max:I})}function Ki(y,E,I,U){E.focus!=null&&sy(y),E.show!=null&&v.forEach((X,Q)=>{Q>0&&(y==Q||y==null)&&(X.show=E.show,Qx(Q),s==2?(Bs(X.facets[0].scale,null,null),Bs(X.facets[1].scale,null,null)):Bs(X.scale,null,null),Un())}),I!==!1&&Cn("setSeries",y,E),U&&la("setSeries",i,y,E)}i.setSeries=Ki;function ty(y,E){xn(C[y],E)}function ey(y,E){y.fill=we(y.fill||null),y.dir=Ae(y.dir,-1),E=E??C.length,C.splice(E,0,y)}function ny(y){y==null?C.length=0:C.splice(y,1)}i.addBand=ey,i.setBand=ty,i.delBand=ny;function iy(y,E){v[y].alpha=E,_t&&ue[y]!=null&&(ue[y].style.opacity=E),tt&&Et[y]&&(Et[y].style.opacity=E)}let _s,ks,hr,$r={focus:!0};function sy(y){if(y!=hr){let E=y==null,I=Wt.alpha!=1;v.forEach((U,X)=>{if(s==1||X>0){let Q=E||X==0||X==y;U._focus=E?null:Q,I&&iy(X,Q?1:Wt.alpha)}}),hr=y,I&&Un()}}tt&&ee&&he(q0,xt,y=>{rt._lock||(te(y),hr!=null&&Ki(null,$r,!0,gn.setSeries))});function ji(y,E,I){let U=b[E];I&&(y=y/Re-(U.ori==1?ce:jt));let X=k;U.ori==1&&(X=At,y=X-y),U.dir==-1&&(y=X-y);let Q=U._min,ht=U._max,pt=y/X,Mt=Q+(ht-Q)*pt,Ot=U.distr;return Ot==3?$o(10,Mt):Ot==4?zE(Mt,U.asinh):Ot==100?U.bwd(Mt):Mt}function ry(y,E){let I=ji(y,w,E);return Wi(I,t[0],un,dn)}i.valToIdx=y=>Wi(y,t[0]),i.posToIdx=ry,i.posToVal=ji,i.valToPos=(y,E,I)=>b[E].ori==0?r(y,b[E],I?Y:k,I?P:0):o(y,b[E],I?ft:At,I?M:0),i.setCursor=(y,E,I)=>{Xe=y.left,tn=y.top,ur(null,E,I)};function yp(y,E){je(Wr,Go,qe.left=y),je(Wr,gl,qe.width=E)}function vp(y,E){je(Wr,"top",qe.top=y),je(Wr,_l,qe.height=E)}let ra=L.ori==0?yp:vp,oa=L.ori==1?yp:vp;function oy(){if(tt&&nt.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&Bt)continue;let E=nt.values[y],I=0;for(let U in E)vt[y][I++].firstChild.nodeValue=E[U]}}function Iu(y,E){if(y!=null&&(y.idxs?y.idxs.forEach((I,U)=>{K[U]=I}):WE(y.idx)||K.fill(y.idx),nt.idx=K[0]),tt&&nt.live){for(let I=0;I<v.length;I++)(I>0||s==1&&!Bt)&&ay(I,K[I]);oy()}gt=!1,E!==!1&&Cn("setLegend")}i.setLegend=Iu;function ay(y,E){let I=v[y],U=y==0&&G==2?ii:t[y],X;Bt?X=I.values(i,y,E)??zt:(X=I.value(i,E==null?null:U[E],y,E),X=X==null?zt:{_:X}),nt.values[y]=X}function ur(y,E,I){_p=Xe,xp=tn,[Xe,tn]=rt.move(i,Xe,tn),rt.left=Xe,rt.top=tn,_t&&(zr&&ds(zr,Mn(Xe),0,k,At),Vr&&ds(Vr,0,Mn(tn),k,At));let U,X=un>dn;_s=Ge,ks=null;let Q=L.ori==0?k:At,ht=L.ori==1?k:At;if(Xe<0||on==0||X){U=rt.idx=null;for(let pt=0;pt<v.length;pt++){let Mt=ue[pt];Mt!=null&&ds(Mt,-10,-10,k,At)}ee&&Ki(null,$r,!0,y==null&&gn.setSeries),nt.live&&(K.fill(U),gt=!0)}else{let pt,Mt,Ot;s==1&&(pt=L.ori==0?Xe:tn,Mt=ji(pt,w),U=rt.idx=Wi(Mt,t[0],un,dn),Ot=H(t[0][U],L,Q,0));let kt=-10,Gt=-10,ae=0,Ce=0,Te=!0,be="",Qt="";for(let Zt=s==2?1:0;Zt<v.length;Zt++){let Ye=v[Zt],ln=K[Zt],Rn=ln==null?null:s==1?t[Zt][ln]:t[Zt][1][ln],ke=rt.dataIdx(i,Zt,U,Mt),cn=ke==null?null:s==1?t[Zt][ke]:t[Zt][1][ke];if(gt=gt||cn!=Rn||ke!=ln,K[Zt]=ke,Zt>0&&Ye.show){let si=ke==null?-10:ke==U?Ot:H(s==1?t[0][ke]:t[Zt][0][ke],L,Q,0),Hn=cn==null?-10:N(cn,s==1?b[Ye.scale]:b[Ye.facets[1].scale],ht,0);if(ee&&cn!=null){let yi=L.ori==1?Xe:tn,Ri=wn(Wt.dist(i,Zt,ke,Hn,yi));if(Ri<_s){let Qi=Wt.bias;if(Qi!=0){let ri=ji(yi,Ye.scale),vi=cn>=0?1:-1,Pi=ri>=0?1:-1;Pi==vi&&(Pi==1?Qi==1?cn>=ri:cn<=ri:Qi==1?cn<=ri:cn>=ri)&&(_s=Ri,ks=Zt)}else _s=Ri,ks=Zt}}if(gt||Lt){let yi,Ri;L.ori==0?(yi=si,Ri=Hn):(yi=Hn,Ri=si);let Qi,ri,vi,Pi,ts,Wn,oi=!0,dr=dt.bbox;if(dr!=null){oi=!1;let $n=dr(i,Zt);vi=$n.left,Pi=$n.top,Qi=$n.width,ri=$n.height}else vi=yi,Pi=Ri,Qi=ri=dt.size(i,Zt);if(Wn=dt.fill(i,Zt),ts=dt.stroke(i,Zt),Lt)Zt==ks&&_s<=Wt.prox&&(kt=vi,Gt=Pi,ae=Qi,Ce=ri,Te=oi,be=Wn,Qt=ts);else{let $n=ue[Zt];$n!=null&&($e[Zt]=vi,Vn[Zt]=Pi,t_($n,Qi,ri,oi),j0($n,Wn,ts),ds($n,Ai(vi),Ai(Pi),k,At))}}}}if(Lt){let Zt=Wt.prox,Ye=hr==null?_s<=Zt:_s>Zt||ks!=hr;if(gt||Ye){let ln=ue[0];ln!=null&&($e[0]=kt,Vn[0]=Gt,t_(ln,ae,Ce,Te),j0(ln,be,Qt),ds(ln,Ai(kt),Ai(Gt),k,At))}}}if(qe.show&&Os)if(y!=null){let[pt,Mt]=gn.scales,[Ot,kt]=gn.match,[Gt,ae]=y.cursor.sync.scales,Ce=y.cursor.drag;if(Tn=Ce._x,An=Ce._y,Tn||An){let{left:Te,top:be,width:Qt,height:Zt}=y.select,Ye=y.scales[Gt].ori,ln=y.posToVal,Rn,ke,cn,si,Hn,yi=pt!=null&&Ot(pt,Gt),Ri=Mt!=null&&kt(Mt,ae);yi&&Tn?(Ye==0?(Rn=Te,ke=Qt):(Rn=be,ke=Zt),cn=b[pt],si=H(ln(Rn,Gt),cn,Q,0),Hn=H(ln(Rn+ke,Gt),cn,Q,0),ra($i(si,Hn),wn(Hn-si))):ra(0,Q),Ri&&An?(Ye==1?(Rn=Te,ke=Qt):(Rn=be,ke=Zt),cn=b[Mt],si=N(ln(Rn,ae),cn,ht,0),Hn=N(ln(Rn+ke,ae),cn,ht,0),oa($i(si,Hn),wn(Hn-si))):oa(0,ht)}else Nu()}else{let pt=wn(_p-mp),Mt=wn(xp-gp);if(L.ori==1){let ae=pt;pt=Mt,Mt=ae}Tn=Ln.x&&pt>=Ln.dist,An=Ln.y&&Mt>=Ln.dist;let Ot=Ln.uni;Ot!=null?Tn&&An&&(Tn=pt>=Ot,An=Mt>=Ot,!Tn&&!An&&(Mt>pt?An=!0:Tn=!0)):Ln.x&&Ln.y&&(Tn||An)&&(Tn=An=!0);let kt,Gt;Tn&&(L.ori==0?(kt=Gr,Gt=Xe):(kt=Hr,Gt=tn),ra($i(kt,Gt),wn(Gt-kt)),An||oa(0,ht)),An&&(L.ori==1?(kt=Gr,Gt=Xe):(kt=Hr,Gt=tn),oa($i(kt,Gt),wn(Gt-kt)),Tn||ra(0,Q)),!Tn&&!An&&(ra(0,0),oa(0,0))}if(Ln._x=Tn,Ln._y=An,y==null){if(I){if(Ip!=null){let[pt,Mt]=gn.scales;gn.values[0]=pt!=null?ji(L.ori==0?Xe:tn,pt):null,gn.values[1]=Mt!=null?ji(L.ori==1?Xe:tn,Mt):null}la(Cf,i,Xe,tn,k,At,U)}if(ee){let pt=I&&gn.setSeries,Mt=Wt.prox;hr==null?_s<=Mt&&Ki(ks,$r,!0,pt):_s>Mt?Ki(null,$r,!0,pt):ks!=hr&&Ki(ks,$r,!0,pt)}}gt&&(nt.idx=U,Iu()),E!==!1&&Cn("setCursor")}let zs=null;Object.defineProperty(i,"rect",{get(){return zs==null&&aa(!1),zs}});function aa(y=!1){y?zs=null:(zs=m.getBoundingClientRect(),Cn("syncRect",zs))}function bp(y,E,I,U,X,Q,ht){rt._lock||Os&&y!=null&&y.movementX==0&&y.movementY==0||(Lu(y,E,I,U,X,Q,ht,!1,y!=null),y!=null?ur(null,!0,!0):ur(E,!0,!1))}function Lu(y,E,I,U,X,Q,ht,pt,Mt){if(zs==null&&aa(!1),te(y),y!=null)I=y.clientX-zs.left,U=y.clientY-zs.top;else{if(I<0||U<0){Xe=-10,tn=-10;return}let[Ot,kt]=gn.scales,Gt=E.cursor.sync,[ae,Ce]=Gt.values,[Te,be]=Gt.scales,[Qt,Zt]=gn.match,Ye=E.axes[0].side%2==1,ln=L.ori==0?k:At,Rn=L.ori==1?k:At,ke=Ye?Q:X,cn=Ye?X:Q,si=Ye?U:I,Hn=Ye?I:U;if(Te!=null?I=Qt(Ot,Te)?a(ae,b[Ot],ln,0):-10:I=ln*(si/ke),be!=null?U=Zt(kt,be)?a(Ce,b[kt],Rn,0):-10:U=Rn*(Hn/cn),L.ori==1){let yi=I;I=U,U=yi}}Mt&&(E==null||E.cursor.event.type==Cf)&&((I<=1||I>=k-1)&&(I=Pr(I,k)),(U<=1||U>=At-1)&&(U=Pr(U,At))),pt?(mp=I,gp=U,[Gr,Hr]=rt.move(i,I,U)):(Xe=I,tn=U)}let Du={width:0,height:0,left:0,top:0};function Nu(){Rl(Du,!1)}let Sp,Mp,wp,Ep;function Tp(y,E,I,U,X,Q,ht){Os=!0,Tn=An=Ln._x=Ln._y=!1,Lu(y,E,I,U,X,Q,ht,!0,!1),y!=null&&(he(Rf,Nf,Ap,!1),la($0,i,Gr,Hr,k,At,null));let{left:pt,top:Mt,width:Ot,height:kt}=qe;Sp=pt,Mp=Mt,wp=Ot,Ep=kt}function Ap(y,E,I,U,X,Q,ht){Os=Ln._x=Ln._y=!1,Lu(y,E,I,U,X,Q,ht,!1,!0);let{left:pt,top:Mt,width:Ot,height:kt}=qe,Gt=Ot>0||kt>0,ae=Sp!=pt||Mp!=Mt||wp!=Ot||Ep!=kt;if(Gt&&ae&&Rl(qe),Ln.setScale&&Gt&&ae){let Ce=pt,Te=Ot,be=Mt,Qt=kt;if(L.ori==1&&(Ce=Mt,Te=kt,be=pt,Qt=Ot),Tn&&Bs(w,ji(Ce,w),ji(Ce+Te,w)),An)for(let Zt in b){let Ye=b[Zt];Zt!=w&&Ye.from==null&&Ye.min!=Ge&&Bs(Zt,ji(be+Qt,Zt),ji(be,Zt))}Nu()}else rt.lock&&(rt._lock=!rt._lock,ur(E,!0,y!=null));y!=null&&(We(Rf,Nf),la(Rf,i,Xe,tn,k,At,null))}function ly(y,E,I,U,X,Q,ht){if(rt._lock)return;te(y);let pt=Os;if(Os){let Mt=!0,Ot=!0,kt=10,Gt,ae;L.ori==0?(Gt=Tn,ae=An):(Gt=An,ae=Tn),Gt&&ae&&(Mt=Xe<=kt||Xe>=k-kt,Ot=tn<=kt||tn>=At-kt),Gt&&Mt&&(Xe=Xe<Gr?0:k),ae&&Ot&&(tn=tn<Hr?0:At),ur(null,!0,!0),Os=!1}Xe=-10,tn=-10,K.fill(null),ur(null,!0,!0),pt&&(Os=pt)}function Cp(y,E,I,U,X,Q,ht){rt._lock||(te(y),sa(),Nu(),y!=null&&la(Y0,i,Xe,tn,k,At,null))}function Rp(){S.forEach(oA),z(i.width,i.height,!0)}Dr(Qh,Wo,Rp);let Xr={};Xr.mousedown=Tp,Xr.mousemove=bp,Xr.mouseup=Ap,Xr.dblclick=Cp,Xr.setSeries=(y,E,I,U)=>{let X=gn.match[2];I=X(i,E,I),I!=-1&&Ki(I,U,!0,!1)},_t&&(he($0,m,Tp),he(Cf,m,bp),he(X0,m,y=>{te(y),aa(!1)}),he(q0,m,ly),he(Y0,m,Cp),Gf.add(i),i.syncRect=aa);let Pl=i.hooks=n.hooks||{};function Cn(y,E,I){Gn?Oe.push([y,E,I]):y in Pl&&Pl[y].forEach(U=>{U.call(null,i,E,I)})}(n.plugins||[]).forEach(y=>{for(let E in y.hooks)Pl[E]=(Pl[E]||[]).concat(y.hooks[E])});let Pp=(y,E,I)=>I,gn=xn({key:null,setSeries:!1,filters:{pub:r_,sub:r_},scales:[w,v[1]?v[1].scale:null],match:[o_,o_,Pp],values:[null,null]},rt.sync);gn.match.length==2&&gn.match.push(Pp),rt.sync=gn;let Ip=gn.key,Fu=nx(Ip);function la(y,E,I,U,X,Q,ht){gn.filters.pub(y,E,I,U,X,Q,ht)&&Fu.pub(y,E,I,U,X,Q,ht)}Fu.sub(i);function cy(y,E,I,U,X,Q,ht){gn.filters.sub(y,E,I,U,X,Q,ht)&&Xr[y](null,E,I,U,X,Q,ht)}i.pub=cy;function hy(){Fu.unsub(i),Gf.delete(i),ze.clear(),Of(Qh,Wo,Rp),c.remove(),xt?.remove(),Cn("destroy")}i.destroy=hy;function Uu(){Cn("init",n,t),ia(t||n.data,!1),$[w]?Cu(w,$[w]):sa(),at=qe.show&&(qe.width>0||qe.height>0),it=gt=!0,z(n.width,n.height)}return v.forEach(Ur),S.forEach(fs),e?e instanceof HTMLElement?(e.appendChild(c),Uu()):e(i,Uu):Uu(),i}Fn.assign=xn;Fn.fmtNum=Zf;Fn.rangeNum=tu;Fn.rangeLog=iu;Fn.rangeAsinh=qf;Fn.orient=Fr;Fn.pxRatio=Re;Fn.join=KE;Fn.fmtDate=Kf,Fn.tzDate=lT;Fn.sync=nx;{Fn.addGap=WT,Fn.clipGaps=ou;let n=Fn.paths={points:lx};n.linear=hx,n.stepped=qT,n.bars=YT,n.spline=JT}var sp=92,rp=14,px=132,aA="replay",lA=[{key:"force_ratio",title:"a hit at this speed would be",unit:"x",of:"x the limit",limit:1,colour:"--hitting"},{key:"distance_m",title:"gap to what is hit",unit:"m",limit:0,colour:"--accent"},{key:"speed_m_s",title:"speed of the link",unit:"m/s",colour:"--path"}],jo=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function cA(n){return t=>{let e=t.valToPos(n,"y",!0),{ctx:i,bbox:s}=t;i.save(),i.strokeStyle=jo("--ink"),i.setLineDash([6,5]),i.beginPath(),i.moveTo(s.left,e),i.lineTo(s.left+s.width,e),i.stroke(),i.restore()}}function hA(n){return t=>{let{ctx:e,bbox:i}=t;e.save();for(let{frame:s,kind:r}of n()){let o=t.valToPos(t.data[0][s],"x",!0);e.strokeStyle=jo(`--event-${r}`),e.lineWidth=1.5*devicePixelRatio,e.beginPath(),e.moveTo(o,i.top),e.lineTo(o,i.top+i.height),e.stroke()}e.restore()}}function uA(n){return(t,e,i)=>{let s=[e,i,n].filter(l=>l!=null),[r,o]=s.length>0?[Math.min(...s),Math.max(...s)]:[0,1],a=Math.max(.08*(o-r),.02);return[r<0?r-a:r===0?0:Math.max(0,r-a),o+a]}}function mx(n){let t=lA.map(h=>{let u=R("b"),f=R("div",{class:"plot"});return{...h,value:u,box:f,element:R("figure",{},R("figcaption",{},`${h.title} `,u),f)}}),e=R("div",{class:"plots","data-test":"plots"},t.map(h=>h.element)),i=null,s=[],r=0,o=()=>Math.max(i.frames-1,1);function a({colour:h,limit:u,unit:f}){let m={stroke:jo("--ink-soft"),grid:{stroke:jo("--line"),width:1},ticks:{stroke:jo("--line"),width:1},font:"11px system-ui, sans-serif"};return{width:Math.max(e.clientWidth,200),height:px,padding:[6,rp,0,0],legend:{show:!1},cursor:{sync:{key:aA,setSeries:!1},drag:{x:!1,y:!1},y:!1,points:{size:7}},scales:{x:{time:!1,range:(_,p,g)=>[p,g]},y:{range:uA(u)}},axes:[{...m,size:22,gap:2,values:(_,p)=>p.map(g=>`${+g.toFixed(2)} s`)},{...m,size:sp,gap:4,space:24,values:(_,p)=>p.map(g=>`${+g.toFixed(2)} ${f}`)}],series:[{},{stroke:jo(h),width:2,points:{show:!1}}],hooks:{draw:[hA(()=>s),...u===void 0?[]:[cA(u)]]}}}function l(h){let u=R("div",{class:"now"});h.over.append(u),h.now=u;let f=m=>{let{left:_,width:p}=h.over.getBoundingClientRect();n((m.clientX-_)/p*o())};h.over.addEventListener("pointerdown",m=>{h.over.setPointerCapture(m.pointerId),f(m)}),h.over.addEventListener("pointermove",m=>m.buttons===1&&f(m))}function c(){for(let h of t){h.plot?.destroy();let u=[...i[h.key]].map(f=>Number.isFinite(f)?f:null);h.plot=new Fn(a(h),[[...i.time_s],u],h.box),l(h.plot)}d(r)}function d(h){r=h;for(let{plot:u,key:f,value:m,unit:_,of:p}of t){u.now.style.left=`${100*r/o()}%`;let g=i[f][r];m.textContent=Number.isFinite(g)?`${g.toFixed(2)}${p??` ${_}`}`:"none"}}return new ResizeObserver(()=>{for(let{plot:h}of t)h?.setSize({width:Math.max(e.clientWidth,200),height:px})}).observe(e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>i&&c()),{element:e,load(h,u){[i,s,r]=[h,u,0],c()},show:d}}var hu=3,op=18,uu=13;function gx(){let n=R("div",{class:"labels","aria-hidden":"true","data-test":"labels"}),t=[],e=!0,i=(r,o)=>r.left<o.right+hu&&o.left<r.right+hu&&r.top<o.bottom+hu&&o.top<r.bottom+hu;function s({camera:r,width:o,height:a,free:l}){let c=new O,d=u=>(c.set(...u).project(r),[(c.x+1)/2*o,(1-c.y)/2*a]),h=l.map(d).map(([u,f])=>({left:u-uu,right:u+uu,top:f-uu,bottom:f+uu}));for(let u of t){let{label:f,anchors:m,kind:_}=u;u.size?.[0]||(u.size=[f.offsetWidth,f.offsetHeight]);let[p,g]=u.size,S=m().flatMap(b=>{let[C,w]=d(b),x=c.z<1;return(_==="tick"?[[-p/2,-g/2]]:[[-p/2,-g-6],[-p/2,op],[op,-g/2],[-p-op,-g/2]]).map(([B,F])=>({left:C+B,right:C+B+p,top:w+F,bottom:w+F+g,seen:x}))}).find(b=>b.seen&&b.left>=2&&b.right<=o-2&&b.top>=2&&b.bottom<=a-2&&!h.some(C=>i(b,C)));f.style.visibility=S?"visible":"hidden",S&&(h.push(S),f.style.transform=`translate(${S.left.toFixed(1)}px, ${S.top.toFixed(1)}px)`)}}return{element:n,get on(){return e},toggle(){e=!e,n.hidden=!e},set(r){t=r.map(({text:o,kind:a,colour:l,anchors:c})=>({kind:a,anchors:c,label:R("span",{class:`tag ${a}`,style:l?`border-color:${l}`:null},o)})),n.replaceChildren(...t.map(({label:o})=>o))},place:r=>e&&s(r)}}var _x={type:"change"},lp={type:"start"},yx={type:"end"},du=new Js,xx=new Xn,dA=Math.cos(70*of.DEG2RAD),En=new O,ei=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},ap=1e-6,fu=class extends nl{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ir.ROTATE,MIDDLE:ir.DOLLY,RIGHT:ir.PAN},this.touches={ONE:sr.ROTATE,TWO:sr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new Dn,this._lastTargetPosition=new O,this._quat=new Dn().setFromUnitVectors(t.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new No,this._sphericalDelta=new No,this._scale=1,this._panOffset=new O,this._rotateStart=new Dt,this._rotateEnd=new Dt,this._rotateDelta=new Dt,this._panStart=new Dt,this._panEnd=new Dt,this._panDelta=new Dt,this._dollyStart=new Dt,this._dollyEnd=new Dt,this._dollyDelta=new Dt,this._dollyDirection=new O,this._mouse=new Dt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=pA.bind(this),this._onPointerDown=fA.bind(this),this._onPointerUp=mA.bind(this),this._onContextMenu=SA.bind(this),this._onMouseWheel=xA.bind(this),this._onKeyDown=yA.bind(this),this._onTouchStart=vA.bind(this),this._onTouchMove=bA.bind(this),this._onMouseDown=gA.bind(this),this._onMouseMove=_A.bind(this),this._interceptControlDown=MA.bind(this),this._interceptControlUp=wA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(_x),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;En.copy(e).sub(this.target),En.applyQuaternion(this._quat),this._spherical.setFromVector3(En),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(En.setFromSpherical(this._spherical),En.applyQuaternion(this._quatInverse),e.copy(this.target).add(En),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=En.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new O(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=En.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(du.origin.copy(this.object.position),du.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(du.direction))<dA?this.object.lookAt(this.target):(xx.setFromNormalAndCoplanarPoint(this.object.up,this.target),du.intersectPlane(xx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>ap||8*(1-this._lastQuaternion.dot(this.object.quaternion))>ap||this._lastTargetPosition.distanceToSquared(this.target)>ap?(this.dispatchEvent(_x),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){En.setFromMatrixColumn(e,0),En.multiplyScalar(-t),this._panOffset.add(En)}_panUp(t,e){this.screenSpacePanning===!0?En.setFromMatrixColumn(e,1):(En.setFromMatrixColumn(e,0),En.crossVectors(this.object.up,En)),En.multiplyScalar(t),this._panOffset.add(En)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;En.copy(s).sub(this.target);let r=En.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Dt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function fA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function pA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function mA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(yx),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function gA(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ir.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pe.DOLLY;break;case ir.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pe.ROTATE}break;case ir.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(lp)}function _A(n){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function xA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(n.preventDefault(),this.dispatchEvent(lp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(yx))}function yA(n){this.enabled!==!1&&this._handleKeyDown(n)}function vA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case sr.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(n),this.state=Pe.TOUCH_ROTATE;break;case sr.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(n),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case sr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pe.TOUCH_DOLLY_PAN;break;case sr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(lp)}function bA(n){switch(this._trackPointer(n),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pe.NONE}}function SA(n){this.enabled!==!1&&n.preventDefault()}function MA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function wA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var EA=new O(0,0,1),Qo=Math.PI/180;function pu(n,t){return new O(Math.cos(n)*Math.cos(t),Math.sin(n)*Math.cos(t),Math.sin(t))}function cp(n,t,e){let i=Math.abs(t.z)>.999?new O(0,1,0):EA,s=new O().crossVectors(i,t).normalize(),r=new O().crossVectors(t,s),o=[s,r],a=new O;for(let h of[s,r,t]){let u=n.map(({p:f})=>h.dot(f));a.addScaledVector(h,(Math.min(...u)+Math.max(...u))/2)}let l=Math.tan(e.fov*Qo/2),c=[l*e.aspect,l],d=.3;for(let{p:h,radius:u}of n){let f=h.clone().sub(a);o.forEach((m,_)=>{let p=(Math.abs(m.dot(f))+u)/c[_]+t.dot(f)+u;d=Math.max(d,p)})}return{position:a.clone().addScaledVector(t,1.06*d),target:a,distance:d}}var TA=1.25;function mu({points:n,others:t},e,i){let s=cp(n,e,i),r=TA*s.distance,o=n;for(let a of t){let l=cp([...o,...a],e,i);l.distance<=r&&(o=[...o,...a],s=l)}return s}function vx(n,t,{a:e,b:i,top:s}){let[r,o]=[t[0]-n[0],t[1]-n[1]],[a,l]=[i[0]-e[0],i[1]-e[1]],c=r*l-o*a,d=((e[0]-n[0])*l-(e[1]-n[1])*a)/c,h=((e[0]-n[0])*o-(e[1]-n[1])*r)/c;return c!==0&&d>0&&d<1&&h>0&&h<1&&n[2]+d*(t[2]-n[2])<s}function bx(n,t){let{points:e,capsules:i,walls:s,contact:r,person:o,robot:a}=n,l=Math.atan2(a[1]-o[1],a[0]-o[0]),c=24*Qo,d=[];for(let m=-175;m<=180;m+=5){let _=pu(l+m*Qo,c),p=cp(e,_,t),g=p.position.toArray(),v=i.filter(C=>sm(g,r,C)).length,S=s.filter(C=>C.some(w=>vx(g,r,w)||vx(g,[...o,1],w))).length,b=Math.abs(Math.abs(m)-115)/60;d.push({towards:_,distance:p.distance,cost:v+.6*Math.min(S,2)+b})}let h=Math.min(...d.map(m=>m.distance)),u=m=>m.cost+1.5*(m.distance/h-1),f=d.reduce((m,_)=>u(_)<u(m)?_:m);return mu(n,f.towards,t)}function Sx(n,t,e){let{contact:i,person:s,robot:r}=t,o=Math.atan2(r[1]-s[1],r[0]-s[0]);switch(n){case"top":return mu(t,pu(-Math.PI/2,89.9*Qo),e);case"front":return mu(t,pu(-Math.PI/2,6*Qo),e);case"side":return mu(t,pu(0,6*Qo),e);case"contact":{let a=bx(t,e),l=new O(...i),c=a.position.clone().sub(a.target).normalize();return{position:l.clone().addScaledVector(c,1.1),target:l}}case"eye":{let a=new O(...t.head),l=new O(...i);return a.distanceTo(l)<.4&&l.copy(a).add(new O(Math.cos(o),Math.sin(o),-.2)),{position:a,target:l}}default:return bx(t,e)}}var _u=20,gu=.08,AA=.05,Mx=.11,CA=.2,RA=.7,PA=new Bi({color:"#59636f"});function wx(){let n=new Le(new Sr(_u,_u),new Xa({opacity:.18}));return n.receiveShadow=!0,n.position.z=.002,n}function Ex({axis:n,grid:t}){let e=new el(_u,_u,n,t);return e.rotation.x=Math.PI/2,e}var xu=class extends js{constructor(){super(new Ke,new Oi)}set colour(t){this.material.color=new le(t)}fit(t,e){let[[i,s],[r,o]]=t.map(([S,b])=>[S-.05,b+.05]),a=(S,b)=>Array.from({length:Math.max(0,Math.floor(b)-Math.ceil(S)+1)},(C,w)=>Math.ceil(S)+w),l=(S,b,C,w)=>b.every(x=>Math.abs(x-w)>=Math.abs(C-w))?`${S} ${C} m`:`${C}`,[c,d]=[a(i,s),a(r,o)],h=(S,b,C)=>Math.abs(b-C)>Math.abs(S-C)?[b,1]:[S,-1],[[u,f],[m,_]]=[h(i,s,e.x),h(r,o,e.y)],p=.014,g=[i,m,p,s,m,p,u,r,p,u,o,p],v=[];for(let S of c)g.push(S,m,p,S,m+_*gu,p),v.push({text:l("x",c,S,u),at:[S,m+2.6*_*gu,0]});for(let S of d)g.push(u,S,p,u+f*gu,S,p),v.push({text:l("y",d,S,m),at:[u+2.6*f*gu,S,0]});return this.geometry.dispose(),this.geometry=new Ke().setAttribute("position",new ve(g,3)),v}};function IA([n,t,e],i){let s=0;for(let r of i){let o=r.size_m[2]/2,[a,l]=[r.centre_m[2]-o,r.centre_m[2]+o];zl([n,t],jn(r))&&a<e&&(s=Math.max(s,Math.min(l,e)))}return e-s>AA?s:null}function Tx([n,t],e,i,s,r){let o=new Le(new vr(s,1.2*s,i-e,28),PA);return o.rotation.x=Math.PI/2,o.position.set(n,t,(e+i)/2),o.castShadow=!0,o.userData.name=`${r} (drawn by the report; not in the cell file)`,o}function Ax({robots:n,obstacles:t}){return(n??[]).flatMap(({name:e,base_m:i,upright:s})=>{let r=i&&s?IA(i,t):null;return r===null?[]:[Tx(i,r,i[2],Mx,`below ${e}`)]})}function Cx(n,t){return(n.robots??[]).flatMap(({name:e,base_m:i,upright:s})=>{if(!i||!s)return[];let o=n.links.flatMap((c,d)=>c.robot===e?da(t,n,0,d).map(h=>({p:h,radius:c.radius_m??0})):[]).filter(({p:c})=>Math.hypot(c[0]-i[0],c[1]-i[1])<CA),a=Math.min(...o.map(({p:c,radius:d})=>c[2]-d)),l=a-i[2];return l>.01&&l<RA?[Tx(i,i[2],a+.02,.8*Mx,`base of ${e}`)]:[]})}var vu=0,LA=1,DA=new O,Rx=new tl,hp=new Xn,Px=new O,yu=new Fi,bu=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new Su,this.unassigned=new Su,this.vertices=[]}setFromPoints(t){if(t.length>=4){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.vertices.push(new up(t[e]));this._compute()}return this}setFromObject(t){let e=[];return t.updateMatrixWorld(!0),t.traverse(function(i){let s=i.geometry;if(s!==void 0){let r=s.attributes.position;if(r!==void 0)for(let o=0,a=r.count;o<a;o++){let l=new O;l.fromBufferAttribute(r,o).applyMatrix4(i.matrixWorld),e.push(l)}}}),this.setFromPoints(e)}containsPoint(t){let e=this.faces;for(let i=0,s=e.length;i<s;i++)if(e[i].distanceToPoint(t)>this.tolerance)return!1;return!0}intersectRay(t,e){let i=this.faces,s=-1/0,r=1/0;for(let o=0,a=i.length;o<a;o++){let l=i[o],c=l.distanceToPoint(t.origin),d=l.normal.dot(t.direction);if(c>0&&d>=0)return null;let h=d!==0?-c/d:0;if(!(h<=0)&&(d>0?r=Math.min(h,r):s=Math.max(h,s),s>r))return null}return s!==-1/0?t.at(s,e):t.at(r,e),e}intersectsRay(t){return this.intersectRay(t,DA)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(t,e){return t.face=e,e.outside===null?this.assigned.append(t):this.assigned.insertBefore(e.outside,t),e.outside=t,this}_removeVertexFromFace(t,e){return t===e.outside&&(t.next!==null&&t.next.face===e?e.outside=t.next:e.outside=null),this.assigned.remove(t),this}_removeAllVerticesFromFace(t){if(t.outside!==null){let e=t.outside,i=t.outside;for(;i.next!==null&&i.next.face===t;)i=i.next;return this.assigned.removeSubList(e,i),e.prev=i.next=null,t.outside=null,e}}_deleteFaceVertices(t,e){let i=this._removeAllVerticesFromFace(t);if(i!==void 0)if(e===void 0)this.unassigned.appendChain(i);else{let s=i;do{let r=s.next;e.distanceToPoint(s.point)>this.tolerance?this._addVertexToFace(s,e):this.unassigned.append(s),s=r}while(s!==null)}return this}_resolveUnassignedPoints(t){if(this.unassigned.isEmpty()===!1){let e=this.unassigned.first();do{let i=e.next,s=this.tolerance,r=null;for(let o=0;o<t.length;o++){let a=t[o];if(a.mark===vu){let l=a.distanceToPoint(e.point);if(l>s&&(s=l,r=a),s>1e3*this.tolerance)break}}r!==null&&this._addVertexToFace(e,r),e=i}while(e!==null)}return this}_computeExtremes(){let t=new O,e=new O,i=[],s=[];for(let r=0;r<3;r++)i[r]=s[r]=this.vertices[0];t.copy(this.vertices[0].point),e.copy(this.vertices[0].point);for(let r=0,o=this.vertices.length;r<o;r++){let a=this.vertices[r],l=a.point;for(let c=0;c<3;c++)l.getComponent(c)<t.getComponent(c)&&(t.setComponent(c,l.getComponent(c)),i[c]=a);for(let c=0;c<3;c++)l.getComponent(c)>e.getComponent(c)&&(e.setComponent(c,l.getComponent(c)),s[c]=a)}return this.tolerance=3*Number.EPSILON*(Math.max(Math.abs(t.x),Math.abs(e.x))+Math.max(Math.abs(t.y),Math.abs(e.y))+Math.max(Math.abs(t.z),Math.abs(e.z))),{min:i,max:s}}_computeInitialHull(){let t=this.vertices,e=this._computeExtremes(),i=e.min,s=e.max,r=0,o=0;for(let u=0;u<3;u++){let f=s[u].point.getComponent(u)-i[u].point.getComponent(u);f>r&&(r=f,o=u)}let a=i[o],l=s[o],c,d;r=0,Rx.set(a.point,l.point);for(let u=0,f=this.vertices.length;u<f;u++){let m=t[u];if(m!==a&&m!==l){Rx.closestPointToPoint(m.point,!0,Px);let _=Px.distanceToSquared(m.point);_>r&&(r=_,c=m)}}r=-1,hp.setFromCoplanarPoints(a.point,l.point,c.point);for(let u=0,f=this.vertices.length;u<f;u++){let m=t[u];if(m!==a&&m!==l&&m!==c){let _=Math.abs(hp.distanceToPoint(m.point));_>r&&(r=_,d=m)}}let h=[];if(hp.distanceToPoint(d.point)<0){h.push(Xi.create(a,l,c),Xi.create(d,l,a),Xi.create(d,c,l),Xi.create(d,a,c));for(let u=0;u<3;u++){let f=(u+1)%3;h[u+1].getEdge(2).setTwin(h[0].getEdge(f)),h[u+1].getEdge(1).setTwin(h[f+1].getEdge(0))}}else{h.push(Xi.create(a,c,l),Xi.create(d,a,l),Xi.create(d,l,c),Xi.create(d,c,a));for(let u=0;u<3;u++){let f=(u+1)%3;h[u+1].getEdge(2).setTwin(h[0].getEdge((3-u)%3)),h[u+1].getEdge(0).setTwin(h[f+1].getEdge(1))}}for(let u=0;u<4;u++)this.faces.push(h[u]);for(let u=0,f=t.length;u<f;u++){let m=t[u];if(m!==a&&m!==l&&m!==c&&m!==d){r=this.tolerance;let _=null;for(let p=0;p<4;p++){let g=this.faces[p].distanceToPoint(m.point);g>r&&(r=g,_=this.faces[p])}_!==null&&this._addVertexToFace(m,_)}}return this}_reindexFaces(){let t=[];for(let e=0;e<this.faces.length;e++){let i=this.faces[e];i.mark===vu&&t.push(i)}return this.faces=t,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let t,e=0,i=this.assigned.first().face,s=i.outside;do{let r=i.distanceToPoint(s.point);r>e&&(e=r,t=s),s=s.next}while(s!==null&&s.face===i);return t}}_computeHorizon(t,e,i,s){this._deleteFaceVertices(i),i.mark=LA;let r;e===null?r=e=i.getEdge(0):r=e.next;do{let o=r.twin,a=o.face;a.mark===vu&&(a.distanceToPoint(t)>this.tolerance?this._computeHorizon(t,o,a,s):s.push(r)),r=r.next}while(r!==e);return this}_addAdjoiningFace(t,e){let i=Xi.create(t,e.tail(),e.head());return this.faces.push(i),i.getEdge(-1).setTwin(e.twin),i.getEdge(0)}_addNewFaces(t,e){this.newFaces=[];let i=null,s=null;for(let r=0;r<e.length;r++){let o=e[r],a=this._addAdjoiningFace(t,o);i===null?i=a:a.next.setTwin(s),this.newFaces.push(a.face),s=a}return i.next.setTwin(s),this}_addVertexToHull(t){let e=[];return this.unassigned.clear(),this._removeVertexFromFace(t,t.face),this._computeHorizon(t.point,null,t.face,e),this._addNewFaces(t,e),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let t;for(this._computeInitialHull();(t=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(t);return this._reindexFaces(),this._cleanup(),this}},Xi=class n{constructor(){this.normal=new O,this.midpoint=new O,this.area=0,this.constant=0,this.outside=null,this.mark=vu,this.edge=null}static create(t,e,i){let s=new n,r=new Sl(t,s),o=new Sl(e,s),a=new Sl(i,s);return r.next=a.prev=o,o.next=r.prev=a,a.next=o.prev=r,s.edge=r,s.compute()}getEdge(t){let e=this.edge;for(;t>0;)e=e.next,t--;for(;t<0;)e=e.prev,t++;return e}compute(){let t=this.edge.tail(),e=this.edge.head(),i=this.edge.next.head();return yu.set(t.point,e.point,i.point),yu.getNormal(this.normal),yu.getMidpoint(this.midpoint),this.area=yu.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(t){return this.normal.dot(t)-this.constant}},Sl=class{constructor(t,e){this.vertex=t,this.prev=null,this.next=null,this.twin=null,this.face=e}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let t=this.head(),e=this.tail();return e!==null?e.point.distanceTo(t.point):-1}lengthSquared(){let t=this.head(),e=this.tail();return e!==null?e.point.distanceToSquared(t.point):-1}setTwin(t){return this.twin=t,t.twin=this,this}},up=class{constructor(t){this.point=t,this.prev=null,this.next=null,this.face=null}},Su=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(t,e){return e.prev=t.prev,e.next=t,e.prev===null?this.head=e:e.prev.next=e,t.prev=e,this}insertAfter(t,e){return e.prev=t,e.next=t.next,e.next===null?this.tail=e:e.next.prev=e,t.next=e,this}append(t){return this.head===null?this.head=t:this.tail.next=t,t.prev=this.tail,t.next=null,this.tail=t,this}appendChain(t){for(this.head===null?this.head=t:this.tail.next=t,t.prev=this.tail;t.next!==null;)t=t.next;return this.tail=t,this}remove(t){return t.prev===null?this.head=t.next:t.prev.next=t.next,t.next===null?this.tail=t.prev:t.next.prev=t.prev,this}removeSubList(t,e){return t.prev===null?this.head=e.next:t.prev.next=e.next,e.next===null?this.tail=t.prev:e.next.prev=t.prev,this}isEmpty(){return this.head===null}};var Mu=class extends Ke{constructor(t=[]){super();let e=[],i=[],r=new bu().setFromPoints(t).faces;for(let o=0;o<r.length;o++){let a=r[o],l=a.edge;do{let c=l.head().point;e.push(c.x,c.y,c.z),i.push(a.normal.x,a.normal.y,a.normal.z),l=l.next}while(l!==a.edge)}this.setAttribute("position",new ve(e,3)),this.setAttribute("normal",new ve(i,3))}};var Ml=new As(1,28,18),NA=new vr(1,1,1,28,1,!0),FA=new O(0,1,0),cr=class extends di{constructor(t,e){super(),this.tube=new Le(NA,e),this.ends=[new Le(Ml,e),new Le(Ml,e)],this.ends.forEach(i=>i.scale.setScalar(t)),this.radius=t,this.add(this.tube,...this.ends),this.children.forEach(i=>i.castShadow=!0)}place(t,e){let[i,s]=[new O(...t),new O(...e)],r=s.clone().sub(i),o=r.length();this.ends[0].position.copy(i),this.ends[1].position.copy(s),this.tube.visible=o>1e-6,this.tube.visible&&(this.tube.position.copy(i).addScaledVector(r,.5),this.tube.scale.set(this.radius,o,this.radius),this.tube.quaternion.setFromUnitVectors(FA,r.divideScalar(o)))}set material(t){this.children.forEach(e=>e.material=t)}},wl=class extends Le{constructor(t,e,i){if(e){let s=e.flatMap(r=>r.flatMap(o=>t[o]));super(new Ke().setAttribute("position",new ve(s,3)),i),this.geometry.computeVertexNormals()}else super(new Mu(t.map(s=>new O(...s))),i);this.castShadow=!0}place(t,e){this.position.set(...t),this.quaternion.set(...e)}};function Lx({centre_m:n,size_m:t,quaternion:e},i,s){let r=new Qs(...t),o=new Le(r,i);return o.add(new js(new Ua(r),s)),o.position.set(...n),o.quaternion.copy(new Dn(...e)),o}function UA(n,t,e){let i=[];return n.slice(n.length===2?1:0).forEach((s,r)=>{let o=n.at(n.length===2?0:r-1);i.push(...o,t,...s,t,...s,e,...o,t,...s,e,...o,e)}),new Ke().setAttribute("position",new ve(i,3))}function dp(n,t,e){return new La(new Ke().setFromPoints(n.map(([i,s])=>new O(i,s,t))),e)}var Ix={mat:.16,field:.07,curtain:.1,door:.1,post:.07},OA={mat:.55,field:.3,curtain:.26,door:.26,post:.3},wu=class extends di{constructor({kind:t,polygon_m:e,z_m:[i,s]},r){super(),this.kind=t,this.fill=new wi({color:r,transparent:!0,opacity:Ix[t]??.1,side:Ei,depthWrite:!1}),this.edge=new Oi({color:r});let o=Math.max(i,.006);if(t==="curtain"||t==="door")this.add(new Le(UA(e,i,s),this.fill),dp(e,o,this.edge),dp(e,s,this.edge));else{let a=t==="field"?Math.max(s,o):o,l=new Le(new $a(new Po(e.map(([c,d])=>new Dt(c,d)))),this.fill);l.position.z=a,this.add(l,dp(e,a,this.edge))}}set lit(t){let e=t?OA:Ix;this.fill.opacity=e[this.kind]??.2}};function Dx(n,t,e){let i=[];for(let s=1;s<n.length;s++){let[[r,o],[a,l]]=[n[s-1],n[s]],c=Math.hypot(a-r,l-o);if(c>1e-6){let[d,h]=[(o-l)/c*(t/2),(a-r)/c*(t/2)],u=.012;i.push(r+d,o+h,u,r-d,o-h,u,a-d,l-h,u,r+d,o+h,u,a-d,l-h,u,a+d,l+h,u)}}return new Le(new Ke().setAttribute("position",new ve(i,3)),e)}var El={skin:"#e9bd97",shirt:"#8f8467",trousers:"#4b5058",shoes:"#3f352c",cap:"#8a5a2b",touched:"#c2185b"},Nx=[.095,.018,.043],Fx=[.145,.05,.06],Ux=[.13,.22],BA=.4,Kn=Object.fromEntries(Object.entries(El).map(([n,t])=>[n,new Bi({color:t})])),kA=new wi({color:El.touched,transparent:!0,opacity:.1,depthWrite:!1}),zA=new As(1,28,12,0,2*Math.PI,0,Math.PI/2),Ox=new O(1,0,0),qi=n=>new O(...n);function Eu(n,t){let e=new Le(Ml,t);return e.scale.set(...n),e.castShadow=!0,e}function Bx(n){return/head|skull|face|neck/.test(n)?Kn.skin:/thigh|shank|pelvis|leg/.test(n)?Kn.trousers:Kn.shirt}function VA(){let n=new Le(zA,Kn.cap);n.scale.setScalar(1.07),n.position.y=.16;let t=Eu([.72,.09,.74],Kn.cap);t.position.set(.86,.3,0);let e=Eu([.2,.24,.15],Kn.skin);e.position.set(1,-.08,0);let i=new di;return i.add(n,t,e),Object.assign(i,{hat:[n,t],nose:e})}var Tu=class extends di{constructor(t,e){super(),this.cell=t;let{upper_arm_radius_m:i,forearm_radius_m:s,hand_radius_m:r}=t.arm;this.parts=t.body.map(o=>e(new cr(o.radius_m,Bx(o.region)),o.region.replaceAll("_"," "))),this.arms=pr.map(o=>[e(new cr(i,Kn.shirt),`${o} upper arm`),e(new cr(s,Kn.skin),`${o} lower arm`),e(Eu(Nx,Kn.skin),`${o} hand`)]),this.legs=Xu(t),this.feet=this.legs.map(()=>e(Eu(Fx,Kn.shoes),"foot")),this.face=e(VA(),"head"),this.around=e(new Le(Ml,kA),"the hand may be anywhere in this sphere"),this.around.scale.setScalar(r),this.add(...this.parts,...this.arms.flat(),...this.feet,this.face,this.around)}load(t,e){Object.assign(this,{replay:t,hazard:e,head:hm(t,this.cell)});let i=t.arm?pr.indexOf(t.arm.side):-1,s=om(e.body_region);this.touching=i>=0&&s!==void 0?{side:i,limb:s}:null;let r=t.arm?-1:am(t,this.cell,e),o=(l,c)=>l?Kn.touched:c;this.parts.forEach((l,c)=>l.material=o(c===r,Bx(this.cell.body[c].region))),this.arms.forEach((l,c)=>l.forEach((d,h)=>d.material=o(c===i&&h===s,h===0?Kn.shirt:Kn.skin)));let a=r===this.head&&e.body_region==="skull_forehead";this.face.hat.forEach(l=>l.material=o(a,Kn.cap)),this.face.nose.material=o(r===this.head,Kn.skin),this.face.scale.setScalar(this.cell.body[this.head].radius_m)}place(t){let{replay:e,cell:i,touching:s}=this;this.parts.forEach((a,l)=>{let{a:c,b:d}=bi(e,i,t,l);a.place(c,d)});let r=pr.map((a,l)=>eo(e,t,l));this.arms.forEach(([a,l,c],d)=>{let[h,u,f]=r[d];a.place(h,u),l.place(u,f),this.placeHand(c,u,f,t,s?.limb===2&&s.side===d)});let o=qi(rm(e,this.hazard,t));this.feet.forEach((a,l)=>{let{a:c,b:d}=bi(e,i,t,this.legs[l]),h=c[2]<d[2]?c:d;a.position.set(h[0],h[1],Fx[1]).addScaledVector(o,.06),a.quaternion.setFromUnitVectors(Ox,o)}),this.placeFace(r,o,t),this.around.visible=s?.limb===2&&t>=e.contact_frame,this.around.visible&&this.around.position.set(...r[s.side][2])}placeHand(t,e,i,s,r){let{replay:o}=this,a=qi(i),l=a.clone().sub(qi(e)).normalize(),c=2*Nx[0];if(r){let d=qi(eo(o,o.contact_frame,this.touching.side)[2]),h=qi(o.contact_m).sub(d),u=h.length(),f=Math.max(0,Math.min(1,1-(o.contact_frame-s)*o.step/BA));u>.02&&(l.lerp(h.divideScalar(u),f).normalize(),c+=f*(Math.max(Ux[0],Math.min(Ux[1],u))-c))}t.scale.x=c/2,t.position.copy(a).addScaledVector(l,c/2),t.quaternion.setFromUnitVectors(Ox,l)}placeFace([[t],[e]],i,s){let{a:r,b:o}=bi(this.replay,this.cell,s,this.head),a=qi(r).add(qi(o)).multiplyScalar(.5),l=qi(t).sub(qi(e)),c=a.clone().sub(qi(t).add(qi(e)).multiplyScalar(.5));(l.lengthSq()<1e-4||c.lengthSq()<1e-4)&&(c.set(0,0,1),l.crossVectors(c,i));let d=l.cross(c).normalize();c.normalize(),this.face.position.copy(a),this.face.quaternion.copy(new Dn().setFromRotationMatrix(new Be().makeBasis(d,c,new O().crossVectors(d,c))))}set headless(t){this.parts[this.head].visible=!t,this.face.visible=!t}eye(t){return bi(this.replay,this.cell,t,this.head).a}spots(t){return this.parts.map((e,i)=>bi(this.replay,this.cell,t,i).a)}get drawn(){let[t,e]=this.arms[0].map(i=>i.radius);return{upper_arm_radius_m:t,forearm_radius_m:e,hand_sphere_m:this.around.visible?this.around.scale.x:null,touched:this.touching??"body"}}};var ni={robot:"#7894b4",hitting:"#e4572e",person:El.shirt,touched:El.touched,contact:"#ffffff",path:"#2a9d8f",mat:"#d9a400",field:"#3b82f6",curtain:"#16a34a",door:"#0d9488",post:"#9333ea",obstacle:"#8b93a0"},kx={light:{sky:"#eef1f5",grid:"#b9c1cc",axis:"#b9c1cc",mark:"#4d5866"},dark:{sky:"#1b2027",grid:"#3a434f",axis:"#3a434f",mark:"#a3afbd"}},zx=matchMedia("(prefers-color-scheme: dark)"),Vx=n=>new Bi({color:n}),Gx=n=>new Bi({color:n,transparent:!0,opacity:.2,depthWrite:!1}),Ns={robot:Vx(ni.robot),hitting:Vx(ni.hitting),robotShape:Gx(ni.robot),hittingShape:Gx(ni.hitting),obstacle:new Bi({color:ni.obstacle,transparent:!0,opacity:.22,depthWrite:!1}),edge:new Oi({color:ni.obstacle}),path:new wi({color:ni.path})};function GA(n){n.add(new Za("#ffffff","#9aa3b0",2.1));let t=new ja("#ffffff",1.9);return t.position.set(-3,-4,9),t.castShadow=!0,t.shadow.mapSize.set(1024,1024),Object.assign(t.shadow.camera,{left:-5,right:5,top:5,bottom:-5,near:1,far:20}),n.add(t,t.target),t}function HA(){let n=new wi({color:ni.contact,depthTest:!1,transparent:!0}),t=new wi({color:"#000000",depthTest:!1,transparent:!0}),e=new Le(new As(.018,16,12),n),i=new Le(new Lo(.045,.058,40),n),s=new Le(new Lo(.04,.063,40),t);return[e.renderOrder,i.renderOrder,s.renderOrder]=[12,11,10],e.add(i,s),e.materials=[n,t],e}function WA({mesh:n}){let t=e=>[...e.getWorldPosition(new O)];return{at:t(n),shape:t(n.parent),clear:n.parent.material.transparent&&!n.material.transparent}}function Hx(n,t,e,i){let s=new $h({canvas:n,antialias:!0});s.setPixelRatio(Math.min(devicePixelRatio,2)),s.shadowMap.enabled=!0;let r=new Ca,o=new qn(40,1,.02,200);o.up.set(0,0,1);let a=new fu(o,n),l=GA(r),c=[],d=(D,q)=>(D.userData.name=q,c.push(D),D),h=HA(),u=new xu,f=Ax(t);c.push(...f),r.add(wx(),u,h,...f);for(let D of t.obstacles)r.add(d(Lx(D,Ns.obstacle,Ns.edge),D.name));let m=t.zones.map(D=>d(new wu(D,ni[D.kind]??ni.obstacle),`${D.kind} ${D.name}`)),_=t.links.map(D=>{let{radius_m:q,points_m:K,triangles:nt}=D,rt=D.shape==="capsule"?new cr(q,Ns.robot):new wl(K,nt,Ns.robot);return d(rt,t.links.some(tt=>tt.robot!==D.robot)?`${D.robot}/${D.name}`:D.name)}),p=t.looks.map(({link:D,points_m:q,triangles:K})=>{let nt=new wl(q,K,Ns.robot);return _[D].add(nt),_[D].castShadow=!1,{link:D,mesh:nt}}),g=new Tu(t,d);r.add(...m,..._,g);let v=null,S=null,b=null,C=0,w=null,x=null,T=0,B="overview",F=!1;function L(){F||(F=!0,requestAnimationFrame(()=>{F=!1,h.children.forEach(D=>D.quaternion.copy(o.quaternion)),h.scale.setScalar(Math.max(.25,Math.min(2,o.position.distanceTo(h.position)/3.5))),s.render(r,o),e.place({camera:o,width:n.clientWidth,height:n.clientHeight,free:S?[S.contact_m,...g.spots(T)]:[]})}))}function G(){let D=zx.matches?kx.dark:kx.light;r.background=new le(D.sky),u.colour=D.mark,v&&(r.remove(v),v.dispose()),v=Ex(D),r.add(v),L()}function H(){let{clientWidth:D,clientHeight:q}=n;D>0&&q>0&&(s.setSize(D,q,!1),o.aspect=D/q,o.updateProjectionMatrix(),L())}function N(D){B=D,H(),$()}function $(){let D=Sx(B,{...x,head:g.eye(T)},o);if(o.position.copy(D.position),a.target.copy(D.target),a.update(),g.headless=B==="eye",B!=="eye"){let q=u.fit(x.bounds,o.position);e.set(E0({replay:S,cell:t,hazard:g.hazard,hitting:C,marks:q,colours:ni,frame:()=>T}))}L()}let Z=new Dt,W=new Qa;function ut(D){let{left:q,top:K,width:nt,height:rt}=n.getBoundingClientRect();Z.set(2*(D.clientX-q)/nt-1,1-2*(D.clientY-K)/rt),W.setFromCamera(Z,o);let tt=W.intersectObjects(c.filter(xt=>xt.visible),!0),mt=(tt.find(({object:xt})=>xt.material&&!xt.material.transparent&&xt.isMesh)??tt.find(({object:xt})=>xt.isMesh))?.object;for(;mt&&!mt.userData.name;)mt=mt.parent;i(mt?.userData.name??"")}return a.addEventListener("change",L),a.addEventListener("start",()=>{B="free",g.headless=!1}),n.addEventListener("pointermove",D=>D.buttons===0&&ut(D)),n.addEventListener("pointerleave",()=>i("")),zx.addEventListener("change",G),new ResizeObserver(()=>{H(),x&&B!=="free"&&$()}).observe(n),H(),G(),{load(D,q){S=D,b&&(r.remove(b),b.geometry.dispose()),C=lm(S,t,q);let K=nt=>nt===C?"hitting":"robot";_.forEach((nt,rt)=>nt.material=Ns[K(rt)]);for(let{link:nt,mesh:rt}of p)rt.material=Ns[K(nt)],_[nt].material=Ns[`${K(nt)}Shape`];g.load(S,q),b=Dx(cm(S,t),.03,Ns.path),r.add(b),h.position.set(...S.contact_m),w===null&&(w=Cx(t,S),w.forEach(nt=>r.add(nt)),c.push(...w)),x=M0(S,t,q),l.position.set(S.contact_m[0]-3,S.contact_m[1]-4,9),l.target.position.set(S.contact_m[0],S.contact_m[1],0)},show(D){T=D,_.forEach((K,nt)=>{let rt=is(S,t,T,nt);rt.position?K.place(rt.position,rt.quaternion):K.place(rt.a,rt.b)}),g.place(T);let q=T>=S.contact_frame;h.materials.forEach(K=>K.opacity=q?1:.35),m.forEach((K,nt)=>{let rt=S.sensors.find(tt=>tt.name===t.zones[nt].name);K.lit=rt?.detected[T]==="1"}),B==="eye"&&N("eye"),L()},look:N,draw:L,get drawn(){o.updateMatrixWorld();let D=x.points.filter(({p:q})=>{let{x:K,y:nt,z:rt}=q.clone().project(o);return Math.abs(K)>1||Math.abs(nt)>1||rt>1}).length;return{...g.drawn,pedestals:f.length,outside:D,looks:p.map(WA)}}}}function Wx({zones:n,looks:t}){let e=new Set(n.map(r=>r.kind)),i=[["hitting","link that hits"],["touched","part that is hit"],["robot","robot"],["person","person"],["path","way of the person"],["obstacle","obstacle"],...[...e].map(r=>[r,r])],s=r=>R("i",{class:"swatch",style:`background:${ni[r]??ni.obstacle}`});return R("ul",{class:"legend screen-only"},i.map(([r,o])=>R("li",{},s(r),o)),R("li",{},R("i",{class:"swatch ring"}),"contact"),t.length>0?R("li",{},"Clear around the robot: the shapes that are judged."):null,n.length>0?R("li",{},"Zones are filled while they report."):null)}function $x(n){let t=R("canvas",{"data-test":"scene","aria-label":"the cell in three dimensions; drag to turn, wheel to zoom"}),e=R("span",{class:"pointed"}),i=R("div",{class:"flat"}),s=gx(),r=R("div",{class:"stage screen-only"},t,s.element,e),o=R("button",{type:"button","data-test":"names","aria-pressed":"true",title:"Show or hide the names in the picture",onclick:l},"names"),a=null;function l(){s.toggle(),o.setAttribute("aria-pressed",String(s.on)),a?.draw()}function c(){a=null,r.replaceChildren(R("p",{class:"notice","data-test":"no-webgl"},"This browser shows no 3-D graphics (WebGL), so here is the contact seen from above; everything else works."),i)}let d=document.createElement("canvas").getContext("webgl2");if(d){d.getExtension("WEBGL_lose_context")?.loseContext();try{a=Hx(t,n,s,h=>e.textContent=h),t.addEventListener("webglcontextlost",c)}catch{c()}}else c();return{element:r,names:o,get scene(){return a},drawFlat:h=>i.replaceChildren(h?Ul(h):""),show(h){a&&(a.show(h),t.dataset.drawn=JSON.stringify(a.drawn))},look:h=>a?.look(h)}}function $A(n){return[...n.matchAll(/1+/g)].map(t=>[t.index,t.index+t[0].length])}function Xx(n,t){return n.findLastIndex(e=>e.frame<=t)}function qx(n){let t=R("div",{class:"strips",style:`--gutter:${sp}px; --right:${rp}px`,onclick:o}),e=1,i=[],s=c=>c.map(({frame:d,kind:h,text:u})=>R("div",{class:`event ${h}`,style:`left:${100*d/e}%`,title:u})),r=(c,d)=>`left:${100*c/e}%;width:${100*(Math.min(d,e)-c)/e}%`;function o(c){let d=c.target.closest(".track");if(d){let{left:h,width:u}=d.getBoundingClientRect();n((c.clientX-h)/u*e)}}function a(c,d,h,u){return R("div",{class:`strip ${d}`},R("span",{class:"label",title:c},c),R("div",{class:"track"},h,s(u),R("div",{class:"now"})))}function l(c){let d=[];return c.forEach(({name:h,frame:u},f)=>{let m=c[f+1]?.frame??e;d.at(-1)?.name===h?d.at(-1).to=m:d.push({name:h,from:u,to:m})}),d}return{element:t,load(c,d){e=Math.max(c.frames-1,1);let h=c.sensors.map(({name:u,detected:f})=>a(u,"sensor",$A(f).map(([m,_])=>R("div",{class:"on",style:r(m,_),title:`${u} reports the person`})),d));i=l(c.actions).map(({name:u,from:f,to:m})=>{let[_,p=""]=qr(u).split(", "),g=R("div",{class:"action",style:r(f,m),title:qr(u)},R("span",{},_),R("span",{},p));return{from:f,to:m,block:g}}),t.replaceChildren(...h,a("the person","actions",i.map(({block:u})=>u),d))},show(c){t.querySelectorAll(".now").forEach(d=>d.style.left=`${100*c/e}%`),i.forEach(({from:d,to:h,block:u})=>u.classList.toggle("current",c>=d&&(c<h||h>=e)))}}}var XA=[.1,.25,.5,1],qA=[["overview","3/4"],["top","top"],["front","front"],["side","side"],["eye","person's eye"],["contact","contact"]],Tl=(n,t,e,i)=>R("button",{type:"button","data-test":n,title:e,onclick:i},t);function YA(n,t){return n.closest("input, select, textarea, [contenteditable]")||t===" "&&n.closest("button, [role=button], summary")}function Yx(n,{look:t,inView:e}){let i=1,s=0,r=Tl("play","▶ Play","Play or pause (space)",()=>n.toggle()),o=R("input",{type:"range",min:0,step:1,"data-test":"scrub","aria-label":"time",oninput:()=>n.seek(Number(o.value))}),a=p=>()=>n.seek(n.frame+p),l=p=>()=>n.seek(p()),c=R("select",{"data-test":"speed",onchange:()=>n.setSpeed(Number(c.value))},XA.map(p=>R("option",{value:p,selected:p===.5},`${p}x`))),d=qA.map(([p,g])=>Tl(`view-${p}`,g,`View: ${g}`,()=>t(p))),h=R("div",{class:"ticks","aria-hidden":"true"}),u=R("ol",{class:"events","data-test":"events","aria-label":"what happens"}),f=R("div",{class:"transport screen-only"},R("div",{class:"row"},r,Tl("back","◀|","One frame back (left)",a(-1)),Tl("forward","|▶","One frame on (right)",a(1)),R("div",{class:"scrubber"},h,o),Tl("to-contact","Contact","Jump to the contact",l(()=>s)),R("label",{},"speed ",c)),u),m=R("div",{class:"row views screen-only",role:"group","aria-label":"views"},d),_={" ":()=>n.toggle(),ArrowLeft:a(-1),ArrowRight:a(1),Home:l(()=>0),End:l(()=>i-1)};return document.addEventListener("keydown",p=>{let g=_[p.key],v=!p.ctrlKey&&!p.metaKey&&!p.altKey&&!p.shiftKey;g&&v&&e()&&!p.defaultPrevented&&!YA(p.target,p.key)&&(p.preventDefault(),g())}),n.follow(({frame:p,playing:g})=>{o.value=p,r.textContent=g?"❚❚ Pause":"▶ Play"}),{element:f,views:m,load(p,g){[i,s]=[p.frames,p.contact_frame],o.max=i-1,h.replaceChildren(...g.map(({frame:v,kind:S})=>R("i",{class:S,style:`left:${100*v/Math.max(i-1,1)}%`}))),u.replaceChildren(...g.map(({frame:v,kind:S,text:b})=>R("li",{},R("button",{type:"button",class:S,title:`Go to ${hn(v*p.step)}`,onclick:()=>n.seek(v)},R("b",{},hn(v*p.step)),` ${b}`))))}}}function Zx(n,t){let{cell:e,scan:i}=n,s=R("span"),r=$x(e),o=V0(),a=mx(o.seek),l=qx(o.seek),c=R("p",{class:"instant","data-test":"instant"}),d=R("div",{class:"facts"}),h=!1,u=null,f=null,m=Yx(o,{look:r.look,inView:()=>h&&u!==null});new IntersectionObserver(w=>h=w.at(-1).isIntersecting).observe(r.element);function _(w){let x=u.actions[Xx(u.actions,w)]?.name,T=u.sensors.filter(F=>F.detected[w]==="1").map(F=>F.name),B=[`${hn(w*e.step_s)} of ${hn((u.frames-1)*e.step_s)}`,x?`the person ${qr(x)}`:"start"];return u.sensors.length>0&&B.push(T.length>0?`${T.join(", ")} ${T.length>1?"report":"reports"} the person`:"no sensor reports the person"),w===u.contact_frame&&B.push(`contact: ${f.robot_link} hits the ${vn(f.body_region)}`),B.join(" · ")}o.follow(({frame:w})=>{u&&(r.show(w),a.show(w),l.show(w),c.textContent=_(w))}),r.scene?m.views.append(r.names):m.views.hidden=!0;let p=R("p",{class:"shown-hazard"}),g=R("div",{},r.element,m.element,c,m.views,r.scene?Wx(e):null),v=R("div",{class:"notice","data-test":"no-replay"}),S=R("div",{class:"graphs screen-only"},a.element,l.element);function b({hazard:w}){f=n.hazard(w),u=n.replay(w)??null,s.textContent=`${w}: ${f.robot_link} hits the ${vn(f.body_region)}`;let x=n.causeOf(w)?.worst===w;if(p.replaceChildren(R("b",{},x?"Its worst way":"One of its ways"),`: ${f.robot_link} hits the ${vn(f.body_region)} after ${hn(f.time_s)} `,R("span",{class:"id"},w)),d.replaceChildren(Yh(f,i.settings)),g.hidden=u===null,S.hidden=u===null,v.hidden=u!==null,!u){o.pause(),v.replaceChildren(R("p",{},`This report carries the replays of the worst ways only, not of ${w}. To get it, in the folder with this report:`),Vs(`fmi-hazard report . --hazard ${w}`));return}let T=z0(u,f);r.drawFlat(n.topView(w)),r.scene?.load(u,f),m.load(u,T),a.load(u,T),l.load(u,T),o.load(u.frames,e.step_s,u.contact_frame),r.look("overview"),r.show(u.contact_frame)}let C=On("replay","",R("div",{class:"replay"},S,d));return C.querySelector("h2").append("How it comes to this ",s),{picture:R("div",{class:"picture"},p,g,v),element:C,start:()=>t.follow(b)}}var ta=()=>{try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}};function Jx(n){let t=new Map(n.flatMap(c=>c.hazards.map(d=>[d,c.id]))),e=new Map(n.map(c=>[c.id,c.worst])),i=c=>t.has(c)||e.has(c),s=c=>e.has(c)?{cause:c,hazard:e.get(c)}:{cause:t.get(c),hazard:c},r=[],o=i(ta())?ta():n[0]?.id,a=o===void 0?{cause:null,hazard:null}:s(o);function l(c){let d=s(c);d.hazard!==a.hazard&&(a=d,r.forEach(h=>h(a)))}return addEventListener("hashchange",()=>{i(ta())&&l(ta())}),{get now(){return a},get namesHazard(){return t.has(ta())},get unknown(){let c=ta();return/^[CH]-/.test(c)&&!i(c)?c:null},select(c){history.replaceState(null,"",`#${encodeURIComponent(c)}`),l(c)},follow(c){r.push(c),a.hazard!==null&&c(a)}}}function ZA({decisionOf:n,worst:t,counted:e,causeOf:i,settings:s}){let o=l=>l.sequences??l.times_found,a=l=>Ii(l,s);return[["id",l=>l.id,l=>R("a",{href:`#${l.id}`,class:"id"},l.id)],["cause",l=>i(l.id).number,l=>Gs(i(l.id)),!0],["ratio",l=>a(l).decides.ratio,l=>JA(a(l),t),!0],["body region",l=>vn(l.body_region),l=>vn(l.body_region)],["hit by",l=>l.robot_link,l=>l.robot_link],["force: own speed",l=>l.force_n,l=>ai(l.force_n),!0],["force: approach",l=>l.directed_force_n,l=>ai(l.directed_force_n),!0],["limit",l=>l.limit_n,Fp,!0],["speed",l=>l.speed_m_s,l=>es(l.speed_m_s),!0],["safe below",l=>l.safe_below_m_s,Np,!0],["time",l=>l.time_s,l=>hn(l.time_s),!0],[e?"sequences":"times found",l=>Number(o(l)),l=>Ee(o(l)),!0],["report the person",l=>Ou(l.sensors),l=>Ou(l.sensors)],["confirmed",l=>Zr(l.confirmed),l=>Zr(l.confirmed)],["decision",l=>n(l.id),l=>n(l.id)]]}function JA({decides:{ratio:n},own:t,approach:e,apart:i},s){let r=Math.max(s,1.05),o=a=>`${(100*a/r).toFixed(1)}%`;return R("span",{class:"ratio"},i?R("span",{class:"flag","data-test":"apart",title:`${Nl} Own speed ${Ze(t.ratio)}, approach ${Ze(e.ratio)}.`},"differ"):null,R("span",{class:"bar screen-only","aria-hidden":"true"},R("span",{class:n>=1?"over":"under",style:`width:${o(n)}`}),R("span",{class:"mark",style:`left:${o(1)}`})),R("b",{},Ze(n)))}function fp(n,t,e,i){let s=[R("option",{value:""},"all"),...e.map(([r,o])=>R("option",{value:r},o))];return R("label",{},`${n} `,R("select",{"data-test":t,onchange:i},s))}function Kx(n,t,e,i){let s=n.scan.hazards,{settings:r}=n.scan,o=Math.max(...s.map(D=>Ii(D,r).decides.ratio)),a=D=>e.decision(D),l=s.some(D=>D.sequences!==null),c=ZA({decisionOf:a,worst:o,counted:l,causeOf:n.causeOf,settings:r}),d=D=>[...new Set(s.map(D))].sort(),h={column:2,descending:!0},u=null,f=R("input",{type:"search",placeholder:"any text","data-test":"filter",oninput:L}),m=fp("region","filter-region",d(D=>D.body_region).map(D=>[D,vn(D)]),L),_=fp("hit by","filter-link",d(D=>D.robot_link).map(D=>[D,D]),L),p=fp("decision","filter-decision",e.decisions.map(D=>[D,D]),L),g=R("output",{"data-test":"shown"}),v=R("button",{type:"button",hidden:!0,"data-test":"clear-bin",onclick:()=>G(null)}),S=new Map(s.map(D=>[D.id,x(D)])),b=new Map,C=R("tbody",{onkeydown:T}),w=c.map(([D,,,q],K)=>R("th",{scope:"col",class:q?"number":null},R("button",{type:"button","data-test":`sort-${K}`,onclick:()=>B(K)},D)));function x(D){let q=c.map(([,,nt,rt])=>R("td",{class:rt?"number":null},nt(D))),K=R("tr",{"data-test":"row","data-id":D.id,class:D.class},q);return K.addEventListener("click",nt=>{nt.ctrlKey||nt.metaKey||nt.shiftKey||String(getSelection())||(nt.preventDefault(),t.select(D.id))}),K}function T(D){let q={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[D.key],K=q&&D.target.closest("tr")?.[q]?.querySelector("a");K&&(D.preventDefault(),K.focus())}function B(D){let q=!!c[D][3];h={column:D,descending:h.column===D?!h.descending:q},L()}function F(D){let q=(nt,rt)=>!nt.querySelector("select").value||nt.querySelector("select").value===rt,K=f.value.trim().toLowerCase();return(u===null||u.ids.has(D.id))&&q(m,D.body_region)&&q(_,D.robot_link)&&q(p,a(D.id))&&K.split(/\s+/).every(nt=>b.get(D.id).includes(nt))}function L(){let[,D]=c[h.column],q=h.descending?-1:1,nt=[...s].sort((rt,tt)=>q*(D(rt)<D(tt)?-1:D(rt)>D(tt)?1:0)).filter(F);C.replaceChildren(...nt.map(rt=>S.get(rt.id))),g.textContent=nt.length===s.length?`${s.length} shown`:`${nt.length} of ${s.length} shown`,w.forEach((rt,tt)=>{let _t=h.descending?"descending":"ascending";rt.setAttribute("aria-sort",tt===h.column?_t:"none")})}function G(D){u=D,v.hidden=u===null,v.textContent=u===null?"":`only ${u.name} ✕`,Z.open||=u!==null,L()}function H(){for(let D of s)S.get(D.id).lastElementChild.textContent=a(D.id),b.set(D.id,S.get(D.id).textContent.toLowerCase());L()}let N=n.scan.hazards.some(D=>D.class==="head_contact")?R("p",{class:"note"},"“None allowed”: a moving robot may not touch head or throat at all; the ratio is that to the force limit and may be below 1."):null,$=R("button",{type:"button",class:"to-replay screen-only","data-test":"to-replay",onclick:i}),Z=R("details",{"data-test":"ways"},R("summary",{},s.length===1?"The one way, as a row":`All ${Ee(s.length)} ways, one row each`),R("div",{class:"filters screen-only"},R("label",{},"filter ",f),m,_,p,v,g),$,R("div",{class:"scroll",tabindex:0},R("table",{class:"hazards"},R("thead",{},R("tr",{},w)),C)),R("p",{class:"note"},`Force with the robot's own speed, and with the speed of approach (the person's walking included); ${Fl(r)} decides. “differ”: by more than a factor of 2.`),N);e.follow(H),H(),t.follow(({hazard:D})=>{$.textContent=`Show the replay of ${D}`;for(let[q,K]of S)K.setAttribute("aria-selected",q===D),ha(K.querySelector("a"),q===D)});let W=()=>Z.open||=t.namesHazard;return addEventListener("hashchange",W),W(),{element:On("hazards","Every way by itself",Z),setBin:G}}function KA(n){let t=R("p",{class:"notice","data-test":"unknown-id"}),e=()=>{t.hidden=n.unknown===null,t.textContent=n.unknown===null?"":`The address names ${n.unknown}, which this report does not hold.`};return addEventListener("hashchange",e),e(),t}async function jA(n){let t=await nm();n.append(Kp(t));let e=Jx(t.causes);if(n.append(KA(e)),t.causes.length>0){let i=zp(t),s=Zx(t,e),r=Kx(t,e,i,()=>s.picture.scrollIntoView({block:"start"})),o=im(t,e,i);n.append(U0(t,i),qp(t,e,i,{picture:s.picture,assess:o.show}),s.element,R("div",{class:"pair"},D0(t,e,r.setBin),o.element),r.element),s.start()}else n.append(On("hazards","Hazards",R("p",{"data-test":"none"},"None was found. What that is worth is told by what the search covered, below.")));n.append(Qp(t),k0(t))}var jx=document.getElementById("report");jA(jx).catch(n=>{throw jx.append(R("p",{class:"notice"},`This report cannot be shown: ${n.message}. scan.json beside it holds the same results.`)),n});})();
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
