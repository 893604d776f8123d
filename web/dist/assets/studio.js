class mi extends Error{constructor(e,t){super(t),this.status=e}}const Yf="The studio does not answer.";async function Zf(n){const e=await n.json();if(!n.ok)throw new mi(n.status,e.error??n.statusText);return e}let uo=new AbortController;async function Kf(n,e,t){try{return await Zf(await fetch(`/api/${n}`,{...e,signal:t}))}catch(i){throw t.aborted?new mi(0,"VENT was pressed, and nothing else is done."):i instanceof mi?i:new mi(0,Yf)}}async function ta(n,e={}){return Kf(`${n}?${new URLSearchParams(e)}`,{},uo.signal)}const jf=n=>({method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(n)}),Jf=()=>({arm:Promise.resolve(),read:Promise.resolve(),rest:Promise.resolve()});let kl=Jf();function hn(n,e){const{signal:t}=uo,i=n.startsWith("arm/")?"arm":n==="experiment/runs"?"read":"rest",s=kl[i].then(()=>Kf(n,jf(e),t));return kl[i]=s.catch(()=>{}),s}const em=100,tm=500;async function nm(n=()=>{}){uo.abort(),uo=new AbortController,kl=Jf();const e=()=>fetch("/api/arm/vent",{...jf({}),priority:"high",keepalive:!0,signal:AbortSignal.timeout(tm)});for(let t=1;;++t)try{const i=await e();n(!0),await Zf(i);return}catch(i){if(i instanceof mi)throw i;if(n(!1),t===em)throw new mi(0,Yf)}}const im=2e3,sm=2e3;function Qf(n,e,t){const i=new EventSource("/api/events");let s;const r=()=>{clearTimeout(s),s=setTimeout(()=>t(!1),sm)},a=()=>{r(),t(!0)};r(),i.addEventListener("beat",a);for(const o of Object.keys(n))i.addEventListener(o,l=>{a(),n[o](JSON.parse(l.data))});i.onerror=()=>{const o=i.readyState===EventSource.CLOSED;clearTimeout(s),e(o),o&&setTimeout(()=>Qf(n,e,t),im)}}class rm{constructor(e,t){this.tab=e,this.changed=t,window.addEventListener("beforeunload",i=>{this.isMine&&i.preventDefault()})}status={state:"off",message:"",recording:""};isSeen=!0;frame=null;paused=!1;ownRun=!1;lease="";renewed="";worker=null;ready=null;ventNow=null;isUnanswered=!1;get isMine(){return this.lease!==""&&this.status.state!=="off"}get runs(){return this.status.state==="running"||this.ownRun}get isAlarm(){return this.status.message.includes("NOT CONFIRMED")}get live(){return this.runs&&this.ownRun?this.frame:null}prepare(){const e=new Worker(new URL("/assets/lease_worker.js",import.meta.url),{type:"module"});this.worker=e,this.ready=new Promise((t,i)=>{e.onerror=()=>i(new Error("The page can’t renew its hold on the arm: load it again.")),e.onmessage=({data:s})=>s==="ready"?t():this.drop()}),this.ready.catch(()=>{})}async arm(){await this.ready;const{lease:e}=await hn("arm/arm",{confirmed:!0});this.lease=this.renewed=e,this.renews(!0),this.changed()}async disarm(){await hn("arm/disarm",{lease:this.lease}),this.drop()}async run(e){this.frame=null,this.paused=!1,this.ownRun=!0;try{await hn("arm/run",{...e,lease:this.lease,tab:this.tab()})}catch(t){throw this.ownRun=!1,t}}async pause(e){await hn("arm/pause",{lease:this.lease,paused:e}),this.paused=e,this.changed()}stop(){return hn("arm/stop",{lease:this.lease})}vent(){return this.renewed="",this.renews(!1),this.ventNow?this.ventNow:(this.ventNow=nm(e=>{const t=this.isUnanswered===e;this.isUnanswered=!e,t&&this.changed()}).finally(()=>{this.ventNow=null,this.drop()}),this.changed(),this.ventNow)}get isVenting(){return this.ventNow!==null}renews(e){this.worker?.postMessage(e?this.renewed:"")}sees(e){e!==this.isSeen&&(this.isSeen=e,this.changed())}onStatus(e){this.status=e,this.isVenting||(this.isUnanswered=!1),e.state!=="running"&&(this.frame=null,this.ownRun=!1),e.state==="off"&&this.drop(),this.changed()}onFrame(e){this.frame=e,this.ownRun&&this.changed()}drop(){this.lease=this.renewed="",this.renews(!1),this.changed()}}const zl=.005,ku=.05,Rs=n=>Math.round(n*1e3)/1e3,ho=n=>Math.round(n*100)/100,Cs=([n,e],[t,i])=>[Rs(n+t),Rs(e+i)],xr=([n,e],t)=>[n*Math.cos(t)-e*Math.sin(t),n*Math.sin(t)+e*Math.cos(t)];function am(n){return Object.keys(n)[0]}function Ui(n){if("circle"in n)return[n.circle.x_m,n.circle.y_m];if("rectangle"in n)return[n.rectangle.x_m,n.rectangle.y_m];const e=n.polygon.length;return[0,1].map(t=>n.polygon.reduce((i,s)=>i+s[t],0)/e)}function $c(n){if("polygon"in n)return n.polygon;const e=Ui(n),t=([s,r])=>[e[0]+s,e[1]+r];if("rectangle"in n){const{width_m:s,height_m:r,angle_rad:a}=n.rectangle;return[[-s,-r],[s,-r],[s,r],[-s,r]].map(([l,c])=>t(xr([l/2,c/2],a)))}const i=64;return Array.from({length:i},(s,r)=>t(xr([n.circle.radius_m,0],2*Math.PI*r/i)))}function om([n,e],t){let i=!1;return t.forEach(([s,r],a)=>{const[o,l]=t[(a+1)%t.length];r>e!=l>e&&n<s+(e-r)/(l-r)*(o-s)&&(i=!i)}),i}function ed(n,e){if(e===null)return[];if(e==="goal"){const{x_m:r,y_m:a,theta_rad:o,position_tolerance_m:l}=n.goal,c=[[{of:"goal",part:"size"},[r,a-l]]];if(o!==void 0){const[h,u]=xr([l+ku,0],o);c.push([{of:"goal",part:"turn"},[r+h,a+u]])}return c}const t=n.obstacles[e];if(t===void 0)return[];const[i,s]=Ui(t);if("circle"in t)return[[{of:e,part:"size"},[i+t.circle.radius_m,s]]];if("rectangle"in t){const{width_m:r,angle_rad:a}=t.rectangle,[o,l]=xr([r/2+ku,0],a);return[[{of:e,part:"size"},$c(t)[2]],[{of:e,part:"turn"},[i+o,s+l]]]}return t.polygon.map((r,a)=>[{of:e,part:a},r])}function lm(n,e,t,i){const{goal:s,obstacles:r}=n,a=([l,c])=>Math.hypot(l-t[0],c-t[1]),o=(l,c)=>a(l)<=c;for(const[l,c]of ed(n,e)){const h=l.of==="goal"?[s.x_m,s.y_m]:Ui(r[l.of]);if(o(c,i)&&a(c)<a(h))return l}if(o([s.x_m,s.y_m],Math.max(s.position_tolerance_m,i)))return{of:"goal",part:"body"};for(let l=r.length-1;l>=0;--l)if(om(t,$c(r[l]))||o(Ui(r[l]),i))return{of:l,part:"body"};return null}function fo(n,e,t){const i=n.obstacles.map((s,r)=>r===e?t:s);return{...n,obstacles:i}}function cm(n,e){if("polygon"in n)return{polygon:n.polygon.map(s=>Cs(s,e))};const[t,i]=Cs(Ui(n),e);return"circle"in n?{circle:{...n.circle,x_m:t,y_m:i}}:{rectangle:{...n.rectangle,x_m:t,y_m:i}}}function um(n,e,t){const[i,s]=Ui(n),r=[t[0]-i,t[1]-s];if("circle"in n){const l=Math.max(zl,Rs(Math.hypot(...r)));return{circle:{...n.circle,radius_m:l}}}if("polygon"in n)return{polygon:n.polygon.map((l,c)=>c===e?Cs(t,[0,0]):l)};if(e==="turn"){const l=ho(Math.atan2(r[1],r[0]));return{rectangle:{...n.rectangle,angle_rad:l}}}const[a,o]=xr(r,-n.rectangle.angle_rad).map(l=>Math.max(zl,Rs(2*Math.abs(l))));return{rectangle:{...n.rectangle,width_m:a,height_m:o}}}function hm(n,e,t){const i=[t[0]-n.x_m,t[1]-n.y_m];return e==="turn"?{...n,theta_rad:ho(Math.atan2(i[1],i[0]))}:{...n,position_tolerance_m:Math.max(zl,Rs(Math.hypot(...i)))}}function td(n,e,t,i){const s=[i[0]-t[0],i[1]-t[1]];if(e.of==="goal"){const[a,o]=Cs([n.goal.x_m,n.goal.y_m],s),l=e.part==="body"?{...n.goal,x_m:a,y_m:o}:hm(n.goal,e.part,i);return{...n,goal:l}}const r=n.obstacles[e.of];return fo(n,e.of,e.part==="body"?cm(r,s):um(r,e.part,i))}function fm(n,e,t){if(e===null)return n;if(e==="goal"){const{theta_rad:o}=n.goal;return o===void 0?n:{...n,goal:{...n.goal,theta_rad:ho(o+t)}}}const i=n.obstacles[e];if("circle"in i)return n;if("rectangle"in i){const o=ho(i.rectangle.angle_rad+t);return fo(n,e,{rectangle:{...i.rectangle,angle_rad:o}})}const[s,r]=Ui(i),a=i.polygon.map(o=>Cs([s,r],xr([o[0]-s,o[1]-r],t)));return fo(n,e,{polygon:a})}function dm(n,[e,t]){const[i,s]=Cs([e,t],[0,0]);return n==="circle"?{circle:{x_m:i,y_m:s,radius_m:.04}}:n==="rectangle"?{rectangle:{x_m:i,y_m:s,width_m:.1,height_m:.06,angle_rad:0}}:{polygon:[[.05,-.03],[0,.06],[-.05,-.03]].map(a=>Cs([i,s],a))}}function pm(n,e){return{...n,obstacles:[...n.obstacles,e]}}function mm(n){const e=r=>n[(r+1)%n.length],t=n.map(([r,a],o)=>Math.hypot(e(o)[0]-r,e(o)[1]-a)),i=t.indexOf(Math.max(...t)),s=[Rs((n[i][0]+e(i)[0])/2),Rs((n[i][1]+e(i)[1])/2)];return[...n.slice(0,i+1),s,...n.slice(i+1)]}function gm(n,e){return{...n,obstacles:n.obstacles.filter((t,i)=>i!==e)}}function _m(n,e,t){if(typeof n!="number")return n;const i=t.obstacles.indexOf(e.obstacles[n]);return i>=0?i:t.obstacles.length===e.obstacles.length?n:null}const vm=1e-4,xm=.02,Ii=(n,[e,t])=>[n.x+(e-n.width/2)*n.m_per_px,n.y-(t-n.height/2)*n.m_per_px],sa=(n,[e,t])=>[n.width/2+(e-n.x)/n.m_per_px,n.height/2-(t-n.y)/n.m_per_px];function Ko(n,e,t){const i=Math.min(xm,Math.max(vm,n.m_per_px/e)),[s,r]=Ii(n,t),[a,o]=Ii({...n,m_per_px:i},t);return{...n,m_per_px:i,x:n.x+s-a,y:n.y+r-o}}function zu(n,e,t){return{...n,x:n.x-e*n.m_per_px,y:n.y+t*n.m_per_px}}function Mm(n,e,t){const s=Math.max((t[0]-e[0])/n.width,(t[1]-e[1])/n.height)*1.12;return{...n,m_per_px:s,x:(e[0]+t[0])/2,y:(e[1]+t[1])/2}}function nd(n,e=72){const t=e*n.m_per_px,i=10**Math.floor(Math.log10(t));return i*([1,2,5,10].find(s=>s*i>=t)??10)}function id(n){const e=nd(n),t=Math.max(0,-Math.floor(Math.log10(e))),[i,s]=Ii(n,[0,0]),[r,a]=Ii(n,[n.width,n.height]),o=(c,h)=>{const u=Math.ceil(c/e);return Array.from({length:Math.max(0,Math.floor(h/e)-u+1)},(f,p)=>(u+p)*e)},l=c=>Number(c.toFixed(1));return[...o(i,r).map(c=>({axis:"x",at:l(sa(n,[c,0])[0]),text:`${c.toFixed(t)} m`})).filter(({at:c})=>c>56&&c<n.width-28),...o(a,s).map(c=>({axis:"y",at:l(sa(n,[0,c])[1]),text:c.toFixed(t)})).filter(({at:c})=>c>64&&c<n.height-28)]}function sd(n,e,t){const s=(l,c,h=0)=>{const[u,f]=sa(n,l);return{at:[Math.round(u),Math.round(f-h)],text:String(c)}},r=e?.obstacles??[],a=typeof t=="number"?r[t]:void 0,o=a&&"polygon"in a?a.polygon:[];return[...r.map((l,c)=>s(Ui(l),c)),...o.map((l,c)=>s(l,c,15))]}function U(n,e={},...t){const i=document.createElement(n);for(const[s,r]of Object.entries(e))typeof r=="function"?i.addEventListener(s.slice(2),r):r!==!1&&i.setAttribute(s,r===!0?"":String(r));return i.append(...t.filter(s=>!!s)),i}function Zi(n,e={},...t){const i=document.createElementNS("http://www.w3.org/2000/svg",n);for(const[s,r]of Object.entries(e))i.setAttribute(s,String(r));return i.append(...t),i}const Ct=n=>document.getElementById(n);function rt(n,e,t={}){return U("button",{type:"button",onclick:e,...t},n)}const ws=(n,e,t)=>rt(n,t,{title:e,"aria-label":e});function Qi(n,e){n.textContent!==e&&(n.textContent=e)}function rd(n,e){const t=()=>[...n.querySelectorAll("button, input, select")],i=t().indexOf(document.activeElement);e(),i>=0&&t()[i]?.focus({preventScroll:!0})}function to(n,...e){rd(n,()=>n.replaceChildren(...e))}function Kn(n,e,t=""){return U("label",{class:"field"},U("span",{},n),e,t&&U("small",{},t))}function Sm(n,e,t){const i=U("input",{type:"number",value:String(n),step:e});return i.addEventListener("change",()=>{Number.isFinite(i.valueAsNumber)&&t(i.valueAsNumber)}),i}function Mr(n,e,t){const i=U("input",{type:"checkbox",checked:e});return i.addEventListener("change",()=>t(i.checked)),U("label",{class:"check"},i,n)}function fr(n,e,t,i,s=()=>""){const r=c=>U("option",{value:c,selected:c===e},c.replace(/^(limber|given):/,"")+s(c)),a=n.filter(c=>c.startsWith("limber:")),o=n.filter(c=>!c.startsWith("limber:")),l=U("select",{},i!==void 0&&U("option",{value:""},i));return o.length&&l.append(U("optgroup",{label:"This project"},...o.map(r))),a.length&&l.append(U("optgroup",{label:"Comes with limber"},...a.map(r))),l.value=e,l.addEventListener("change",()=>t(l.value)),l}function Hl(n){return U("dl",{},...n.flatMap(([e,t])=>[U("dt",{},e),U("dd",{},t)]))}const ym="/assets/animation.js",Sr={simple:"Simple model",network:"Network",virtual_arm:"Virtual arm",arm:"The arm"},Em="ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";function jo(n,e){let t="",i=[];for(const s of n){const r=s.map((a,o)=>Math.round(a/e[o%e.length]));r.forEach((a,o)=>{const l=a-(i[o]??0);let c=l<0?-2*l+1:2*l;do{const h=c>=32?32:0;t+=Em[c%32+h],c=Math.floor(c/32)}while(c>0)}),i=r}return t}const Tm=[1e-4,1e-4,.001],Hu=[.01];function wm(n,e,t,i){const{frame_rate_hz:s,appeared:r,setpoints_kpa:a,tracks:o}=i;return{title:n,unit:e.command.unit,environment:t,frame_rate_hz:s,appeared:r,arm:{...e,reach:{cell_m:1,middles_m:[]}},setpoints_kpa:jo(a,Hu),tracks:o.map(l=>({...l,shapes:jo(l.shapes,Tm),pressures_kpa:jo(l.pressures_kpa,Hu),clearances_m:l.clearances_m.map(c=>c===null?null:Number(c.toFixed(4)))}))}}const Vu=n=>n.replace(/[&<>"]/g,e=>`&#${e.charCodeAt(0)};`);function bm(n,e,t,i,s){const r={TITLE:Vu(n.title),STYLE:t,STILL:s,ENDS:n.tracks.map(({key:a,outcome:o})=>`<li>${Sr[a]}: ${Vu(o)}</li>`).join(""),DATA:JSON.stringify(n).replaceAll("<","\\u003c"),SCRIPT:i.replaceAll("<\/script","<\\/script")};return e.replace(/@([A-Z]+)@/g,(a,o)=>r[o])}const Si=([n,e,t,i],s)=>[n,e,t,i*s],Am=(n,e,t)=>n.map((i,s)=>i+(e[s]-i)*t);function Rm(n){const e=getComputedStyle(document.documentElement).getPropertyValue(n).trim();return[...[1,3,5].map(i=>parseInt(e.slice(i,i+2),16)/255),1]}function Gu([n,e],t,i=48){return Array.from({length:i},(s,r)=>{const a=2*Math.PI*r/i;return[n+t*Math.cos(a),e+t*Math.sin(a)]})}const Cm=1200,po=n=>n.length/3,Ps=(n,e)=>({x:n[3*e],y:n[3*e+1],theta:n[3*e+2]}),gi=n=>{const{x:e,y:t}=Ps(n,po(n)-1);return[e,t]};function ad(n,e){n.push(gi(e)),n.length>Cm&&n.shift()}const Ls=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1]);function Wu(n){return n.segments.flatMap((e,t)=>Array(e.gaps).fill(t))}function Xu(n,e=4){const t=[],i=po(n)-1;for(let s=0;s<i;++s){const r=Ps(n,s),a=Ps(n,s+1),o=a.theta-r.theta,l=Math.hypot(a.x-r.x,a.y-r.y),c=Math.atan2(a.y-r.y,a.x-r.x)-o/2;for(let h=0;h<=e;++h){const u=h/e,f=Math.abs(o)<1e-6?u:Math.sin(o*u/2)/Math.sin(o/2),p=c+o*u/2;t.push({x:r.x+l*f*Math.cos(p),y:r.y+l*f*Math.sin(p),theta:c+o*u,gap:s})}}return t}function Pm(n,e,t){return n.plate_radius_m.map((i,s)=>{const r=Ps(e,s),a=Ps(t,s),o=Math.hypot(a.x-r.x,a.y-r.y),c=n.start_share>=1||n.full_after_m<=0?1:n.start_share+(1-n.start_share)*Math.min(1,o/n.full_after_m);return i*c})}function qu(n,e,t){return n[Math.max(0,Math.min(n.length-1,Math.round(t*e)))]}function Lm(n,e){return n.length<=e?n:Array.from({length:e},(t,i)=>n[Math.round(i*(n.length-1)/(e-1))])}function $u(){return Object.fromEntries(["simple","network","virtual_arm","arm","ground","grid","axis","reach","obstacle","goal","body","plate","pressure","plan","tree","select"].map(e=>[e,Rm(`--${e}`)]))}const Dm=9,Ea=({x:n,y:e,theta:t},i)=>[n-i*Math.sin(t),e+i*Math.cos(t)];class od{constructor(e,t){this.painter=e,this.camera=t}palette=$u();paint(e,t){this.camera=t,this.painter.begin(),e.showReach&&e.arm&&this.reach(e.arm),this.grid(),e.showTree&&this.tree(e.showTree),e.environment&&this.environment(e.environment,e.selected,e.hidesGoal),e.path&&this.painter.path(e.path,this.px(2.5),this.palette.goal),e.plan&&e.arm&&this.plan(e.plan,e.arm,e);for(const i of e.figures)e.arm&&this.figure(i,e.arm);e.environment&&this.handles(e.environment,e.selected),this.painter.end()}recolour(){this.palette=$u()}px(e){return e*this.camera.m_per_px}reach({reach:{cell_m:e,middles_m:t}}){const i=e/2;for(let s=0,r;s<t.length;s=r){const[a,o]=[t[s],t[s+1]];for(r=s+2;t[r]===a&&t[r+1]-t[r-1]<1.5*e;)r+=2;const l=t[r-1];this.painter.quad([a-i,o-i],[a+i,o-i],[a+i,l+i],[a-i,l+i],this.palette.reach)}}grid(){const{camera:e,painter:t}=this,i=nd(e),[s,r]=Ii(e,[0,0]),[a,o]=Ii(e,[e.width,e.height]),l=c=>c===0?this.palette.axis:this.palette.grid;for(let c=Math.ceil(s/i);c*i<=a;++c)t.line([c*i,o],[c*i,r],this.px(1),l(c));for(let c=Math.ceil(o/i);c*i<=r;++c)t.line([s,c*i],[a,c*i],this.px(1),l(c))}tree(e){const t=Si(this.palette.tree,.45);for(let i=0;i+3<e.length;i+=4)this.painter.line([e[i],e[i+1]],[e[i+2],e[i+3]],this.px(1),t)}environment({obstacles:e,goal:t},i,s=!1){const{painter:r,palette:a}=this;if(e.forEach((c,h)=>{const u=$c(c);r.polygon(u,Si(a.obstacle,.55));const f=i===h;r.path(u,this.px(f?2.5:1.5),f?a.select:a.obstacle,!0)}),s)return;const o=[t.x_m,t.y_m],l=i==="goal";if(r.disc(o,t.position_tolerance_m,Si(a.goal,.22)),r.ring(o,t.position_tolerance_m,this.px(l?2.5:1.5),l?a.select:a.goal),r.disc(o,this.px(2.5),a.goal),t.theta_rad!==void 0){const c=t.position_tolerance_m+this.px(14),h=[o[0]+c*Math.cos(t.theta_rad),o[1]+c*Math.sin(t.theta_rad)];r.line(o,h,this.px(2),a.goal);const u=f=>[h[0]+this.px(8)*Math.cos(t.theta_rad+f),h[1]+this.px(8)*Math.sin(t.theta_rad+f)];r.triangle(h,u(2.7),u(-2.7),a.goal)}}handles(e,t){for(const[,i]of ed(e,t))this.painter.disc(i,this.px(6.5),this.palette.select),this.painter.disc(i,this.px(4.5),this.palette.ground)}plan(e,t,i){const{painter:s,palette:r}=this,a=i.stale?.35:1,o=Wu(t),l=Lm(e.shapes,Dm);if(i.showTube&&e.tube)for(const c of l){const h=Pm(e.tube,e.shapes[0],c),u=Array.from({length:po(c)},(x,m)=>Ps(c,m)),f=x=>u.map((m,d)=>{const w=t.segments[o[Math.max(0,d-1)]].width_m/2;return Ea(m,x*(w+t.actuator_radius_m+h[d]))}),[p,_]=[f(1),f(-1)];for(let x=0;x+1<u.length;++x)s.quad(p[x],p[x+1],_[x+1],_[x],Si(r.plan,.05*a))}l.forEach((c,h)=>{const u=(h+1)/l.length,f=Xu(c).map(({x:p,y:_})=>[p,_]);s.path(f,this.px(2),Si(r.plan,(.12+.5*u*u)*a))}),s.path(e.shapes.map(gi),this.px(2.5),Si(r.plan,.9*a)),s.disc(gi(e.shapes[e.shapes.length-1]),this.px(4),Si(r.plan,a))}figure(e,t){const{painter:i,palette:s}=this,r=s[e.colour];e.trail&&i.path(e.trail,this.px(1.75),Si(r,.8));const a=Wu(t),o=Xu(e.shape),l=(h,u)=>Ea(o[h],u*t.segments[a[o[h].gap]].width_m/2),c=h=>[o[h].x,o[h].y];if(!e.outlined)for(let h=0;h+1<o.length;++h){if(o[h].gap!==o[h+1].gap)continue;const u=e.pressures_kpa?.[a[o[h].gap]]??0,{lower_kpa:f,upper_kpa:p}=t.segments[a[o[h].gap]];for(const _ of[1,-1]){const x=_<0?u/Math.max(p,1e-9):u/Math.min(f,-1e-9),m=Am(s.body,s.pressure,Math.max(0,Math.min(1,x)));i.quad(l(h,_),l(h+1,_),c(h+1),c(h),Si(m,.92))}}for(const h of[1,-1])i.path(o.map((u,f)=>l(f,h)),this.px(1.5),r);for(let h=0;h<po(e.shape);++h){const u=Ps(e.shape,h),f=t.segments[a[Math.max(0,h-1)]].width_m/2,p=h===0||a[h-1]!==a[h];i.line(Ea(u,f),Ea(u,-f),this.px(p?3:1.25),e.outlined?r:s.plate)}i.disc(gi(e.shape),this.px(3.5),r)}}class Um{constructor(e){this.camera=e}parts=[];begin(){this.parts=[]}end(){}get text(){return this.parts.join("")}triangle(e,t,i,s){this.polygon([e,t,i],s)}quad(e,t,i,s,r){this.polygon([e,t,i,s],r)}polygon(e,t){this.add(`path d="${this.along(e)}Z"`,"fill",t)}line(e,t,i,s){this.path([e,t],i,s)}path(e,t,i,s=!1){if(e.length<2)return;const r=`path fill="none" stroke-linejoin="round" stroke-width="${this.px(t)}" d="${this.along(e)}${s?"Z":""}"`;this.add(r,"stroke",i)}disc(e,t,i){this.add(this.circle(e,t),"fill",i)}ring(e,t,i,s){this.add(`${this.circle(e,t)} fill="none" stroke-width="${this.px(i)}"`,"stroke",s)}circle(e,t){const[i,s]=sa(this.camera,e);return`circle cx="${i.toFixed(2)}" cy="${s.toFixed(2)}" r="${this.px(t)}"`}px(e){return(e/this.camera.m_per_px).toFixed(2)}along(e){return e.map((t,i)=>`${i===0?"M":"L"}${sa(this.camera,t).map(s=>s.toFixed(2)).join(" ")}`).join("")}add(e,t,[i,s,r,a]){const o=[i,s,r].map(l=>Math.round(255*l)).join(",");this.parts.push(`<${e} ${t}="rgb(${o})"${a<1?` ${t}-opacity="${a.toFixed(3)}"`:""}/>`)}}function Im(n,e){const t=new Um(e);new od(t,e).paint(n,e);const i=o=>getComputedStyle(document.documentElement).getPropertyValue(o).trim(),s=id(e).map(({axis:o,at:l,text:c})=>o==="x"?`<text x="${l}" y="${e.height-10}" text-anchor="middle">${c}</text>`:`<text x="${e.width-8}" y="${l+4}" text-anchor="end">${c}</text>`),r=sd(e,n.environment,n.selected).map(({at:[o,l],text:c})=>`<text x="${o}" y="${l+4}" text-anchor="middle" fill="${i("--text")}">${c}</text>`);return`<svg xmlns="http://www.w3.org/2000/svg" ${`width="${e.width}" height="${e.height}" viewBox="0 0 ${e.width} ${e.height}"`} role="img" aria-label="The arm"><rect width="100%" height="100%" fill="${i("--ground")}"/>${t.text}<g font-family="system-ui, sans-serif" font-size="12" fill="${i("--quiet")}">${[...s,...r].join("")}</g></svg>`}const Yu=2;function no(n,e){const t=URL.createObjectURL(e);U("a",{href:t,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}const Vl=n=>Im(n.scene(),n.stage.camera);async function Nm(n){const e=new Image;e.src=`data:image/svg+xml,${encodeURIComponent(n)}`,await e.decode();const t=U("canvas",{width:Yu*e.width,height:Yu*e.height});return t.getContext("2d").drawImage(e,0,0,t.width,t.height),new Promise(i=>t.toBlob(s=>i(s),"image/png"))}async function Fm(n,e){const t=document.querySelector("link[rel=stylesheet]").href,[i,s,r]=await Promise.all(["/animation.html",t,ym].map(async o=>(await fetch(o)).text())),a=wm(n.environment.name,n.arm,n.environment,e);return new Blob([bm(a,i,s,r,Vl(n))],{type:"text/html"})}function yo(n,e){const t=()=>n.environment.name||"limber";return U("div",{class:"row"},rt("PNG",()=>void n.attempt(async()=>no(`${t()}.png`,await Nm(Vl(n)))),{title:"Save the picture as PNG"}),rt("SVG",()=>no(`${t()}.svg`,new Blob([Vl(n)],{type:"image/svg+xml"})),{title:"Save the picture as SVG"}),e!==void 0&&rt("One HTML file",()=>void n.attempt(async()=>{const i=e();i&&(no(`${t()}.html`,await Fm(n,i)),n.say("Saved to your downloads: one file that anybody’s browser plays, with slider and plots"))}),{title:"Save the motion as one HTML file for anybody, with slider and plots"}))}const ld=({middle:n,slope:e},t)=>e.reduce((i,s,r)=>i+s*t[r],n);function Om(n,e,t){const i=n.along.reduce((r,a,o)=>r+a*n.slope[o],0),s=(t-ld(n,e))/i;return e.map((r,a)=>r+s*n.along[a])}const Zu=n=>n<1?`${Math.round(n*1e3)} ms`:`${n.toFixed(1)} s`,ra=n=>`${(n*100).toFixed(2)} cm`,Jo=n=>Math.round(n).toLocaleString("en");function Bm(n,e,t,i){if(e===null)return U("p",{class:"hint"},"Select the goal or an obstacle to edit its numbers.");const s=(l,c)=>Object.entries(l).map(([h,u])=>{const f=h.endsWith("_rad");return Kn({x_m:"x",y_m:"y",radius_m:"Radius",width_m:"Width",height_m:"Height",angle_rad:"Angle",theta_rad:"Heading",position_tolerance_m:"Tolerance",orientation_tolerance_rad:"Heading tolerance"}[h]??h,Sm(u,f?.05:.005,_=>c(h,_)),f?"rad":"m")});if(e==="goal"){const{goal:l}=n,c=Mr("with a heading",l.theta_rad!==void 0,h=>{const{theta_rad:u,orientation_tolerance_rad:f,...p}=l;t({...n,goal:h?{...p,...{theta_rad:0,orientation_tolerance_rad:.3}}:p})});return U("div",{class:"fields"},...s(l,(h,u)=>t({...n,goal:{...l,[h]:u}})),c)}const r=n.obstacles[e],a=l=>t(fo(n,e,l)),o="polygon"in r?r.polygon.flatMap(([l,c],h)=>s({[`x ${h}`]:l,[`y ${h}`]:c},(u,f)=>a({polygon:r.polygon.map((p,_)=>_!==h?p:u.startsWith("x")?[f,p[1]]:[p[0],f])}))):"circle"in r?s(r.circle,(l,c)=>a({circle:{...r.circle,[l]:c}})):s(r.rectangle,(l,c)=>a({rectangle:{...r.rectangle,[l]:c}}));return U("div",{class:"fields"},...o,"polygon"in r&&km(r,a),rt("Delete",i,{class:"danger",id:"delete"}))}function km({polygon:n},e){return U("div",{class:"row"},rt("Add a corner",()=>e({polygon:mm(n)})),...n.length<4?[]:n.map((t,i)=>ws(`− ${i}`,`Remove corner ${i}`,()=>e({polygon:n.filter((s,r)=>r!==i)}))))}function zm(n,e,t){const i=(s,r)=>U("li",{},rt(s,()=>t(r),{"aria-pressed":String(e===r)}));return U("ul",{class:"things"},i("Goal","goal"),...n.obstacles.map((s,r)=>i(`${r} · ${am(s)}`,r)))}function Hm(n,e){return U("div",{class:n?"status busy":"status"},U("strong",{},"A family of arms"),U("p",{},n||"It plans once it knows which arm is yours: from a minute of its motion."),rt("Fit it to the virtual arm",e,{class:"main",disabled:n!==""}),U("p",{class:"hint"},"For a real arm, limber collect --schedule identify records the minute, and limber adapt fits it."))}const Vm="the no-load model's error is not known",Ku=/: --(?:margin-m ([\d.e-]+)|goal-margin-m 0 keeps none)/g;function Gm(n,e){const t=[...n.matchAll(Ku)].map(([,i])=>Number(i)).find(Number.isFinite);return[U("p",{},n.replaceAll(Ku,"")),...t===void 0?[]:[rt(`Keep ${ra(t)}`,()=>e(t),{class:"main"})]]}function Wm(n,e,t,i){const{plan:s,progress:r,result:a,fault:o,searching:l,isCurrent:c}=n;if(o)return U("div",{class:"status bad"},U("strong",{},"Not planned"),U("p",{},o));if(s&&c){const h=a?.queries??r?.queries,u=a?.time_s??r?.time_s;return U("div",{class:t?"status good unsure":"status good","data-cost":s.cost_kpa.toFixed(3)},U("strong",{},t?"Certified, for the simple model alone":"Certified plan",l&&U("em",{}," improving …")),t&&U("p",{class:"warning"},"The arm itself mostly misses such plans, and may collide. Choose a model that has learnt this arm."),Hl([["Cost",`${s.cost_kpa.toFixed(1)} ${e}`],["Duration",`${s.duration_s.toFixed(1)} s`],["Clearance",s.clearance_m===null?"no obstacles":ra(s.clearance_m)],["Ends from the goal’s centre",ra(s.goal_distance_m)],...s.first_s===void 0?[]:[["First certified after",Zu(s.first_s)]],...h&&u?[["Model queries",Jo(h)],["Queries per second",Jo(h/u)]]:[]]),...(s.warnings??a?.warnings??[]).filter(f=>!f.startsWith(Vm)).map(f=>U("p",{class:"warning"},f)))}return l?U("div",{class:"status busy"},U("strong",{},"Searching …"),r&&Hl([["Nodes",Jo(r.nodes)],["Time",Zu(r.time_s)]]),r?.doubt?U("p",{},r.doubt):null):a?U("div",{class:"status bad"},U("strong",{},{limit:"No plan found",invalid_start:"The start is not free",goal_unreachable:"The goal is out of reach",goal_in_collision:"The goal is not free",not_certified:"No plan is certified"}[a.status]??a.status),...Gm(a.reason,i)):U("div",{class:"status"},U("strong",{},"Not planned yet"))}function cd(n,e,t,i=1){const s=[.1,.2,.3,.4,.5,.6,.7,.8,.9].filter(o=>o<i),r=[...new Set([...s,i,e])].sort((o,l)=>o-l),a=U("select",{"aria-label":n},...r.map(o=>U("option",{value:o,selected:o===e},`${Math.round(100*o)} %`)));return a.addEventListener("change",()=>t(Number(a.value))),a}function Xm(n,e){const t=(i,{lower_kpa:s,upper_kpa:r})=>i===0?0:i/(i>0?r:s);return Math.max(0,...e.flatMap(i=>i.map((s,r)=>t(s,n.segments[r]))))}function qm(n,e,t){const i=s=>r=>{r?e.add(s):e.delete(s),t()};return U("ul",{class:"tracks"},...n.tracks.map(({key:s,outcome:r})=>U("li",{},U("i",{class:`swatch ${s}`}),Mr(Sr[s],e.has(s),i(s)),U("small",{},r))))}function Yc(n,e,[t,i],s,r,a){const o=U("output",{"aria-live":"off"},r(s)),l=U("input",{type:"range",min:t,max:i,step:"any",value:String(s),"aria-label":e});return l.addEventListener("keydown",c=>{const h={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageDown:-10,PageUp:10}[c.key];h!==void 0&&(c.preventDefault(),l.valueAsNumber+=h*(i-t)/100,l.dispatchEvent(new Event("input")))}),l.addEventListener("input",()=>{o.textContent=r(l.valueAsNumber),a(l.valueAsNumber)}),U("label",{},U("span",{},n),l,o)}function $m(n,e,t){const{unit:i,name:s}=n.command;return U("div",{class:"sliders"},...n.segments.map(({lower_kpa:r,upper_kpa:a},o)=>Yc(`Segment ${o}`,`Segment ${o}, ${s} in ${i}`,[r,a],e[o],l=>`${l.toFixed(0)} ${i}`,l=>t(o,l))))}const Ym=6,ju=2;function Zm(n,e,t){let i=n;return n.slice(0,e).map((s,r)=>Yc(`e ${r}`,`Number ${r} of the family, in standard deviations`,[Math.min(-ju,s),Math.max(ju,s)],s,a=>a.toFixed(2),a=>{i=i.map((o,l)=>l===r?a:o),t(i)}))}function Km(n,e,t){let i=e;return n.map(s=>{const{text:r,unit:a,low:o,high:l}=s,c=ld(s,e),h=Math.max(0,Math.min(4,2-Math.floor(Math.log10(l-o))));return Yc(r,`${r}, of the arm file ${s.of_arm_file.toFixed(h)}${a}`,[Math.min(o,c),Math.max(l,c)],c,u=>u.toFixed(h)+a,u=>{i=Om(s,i,u),t(i)})})}function jm({traits:n},e,t,i,s){const r=n.length>0?0:Math.min(e.length,Ym);return U("div",{class:"sliders",id:"family"},...r>0||t?Zm(e,t?e.length:r,i):Km(n,e,i),e.length>r&&rt(t?r>0?"Fewer":"What they tell of":`${r>0?"More":"The numbers behind it"}: ${e.length-r}`,s,{"aria-expanded":String(t)}))}const Ta=["virtual_arm","network","simple"];class Jm{constructor(e){this.app=e}now=null;trails=new Map;target=[];family={is_family:!1,e:[],traits:[]};e=[];showsAll=!1;arms=U("section",{hidden:!0});request=0;sending=!1;waiting=!1;sliders=U("div");readout=U("div",{id:"readout"});enter(e){e.append(U("section",{},U("h2",{},`Set points, ${this.app.unit}`),this.sliders,U("div",{class:"row"},rt("All to zero",()=>this.set(this.target.map(()=>0))),rt("Start again from rest",()=>this.restart()))),this.arms,U("section",{},U("h2",{},"Tips"),this.readout,U("p",{class:"hint"},"Bend the arm and go back to zero: the simple model returns to where it was. The virtual arm, held by friction, does not quite.")),U("section",{},U("h2",{},"Save the picture"),yo(this.app))),this.e=[],this.arms.hidden=!0,this.restart(),this.app.model!==""&&this.app.attempt(()=>this.openFamily(this.app.model))}async openFamily(e){this.family=await ta("model",{name:e}),!(e!==this.app.model||this.family.e.length===0)&&this.showFamily()}showFamily(){const{family:e}=this,t=i=>{this.e=i,this.send(!1)};this.arms.hidden=!1,this.arms.replaceChildren(U("h2",{},e.is_family?"Which arm of the family":"Another arm of the model’s family"),U("p",{class:"hint"},"The network becomes that arm. The virtual arm stays as it is."),jm(e,this.e.length?this.e:e.e,this.showsAll,t,()=>{this.showsAll=!this.showsAll,this.showFamily(),this.arms.querySelector("[aria-expanded]")?.focus()}),U("div",{class:"row"},rt(e.is_family?"The family’s middle":"The model’s own arm",()=>{t([]),this.showFamily()})))}leave(){this.now=null,this.app.endWork()}restart(){this.trails.clear(),this.now=null,++this.request,this.set(this.app.arm.segments.map(()=>0),!0)}set(e,t=!1){this.target=e,this.sliders.replaceChildren($m(this.app.arm,e,(i,s)=>{this.target=this.target.map((r,a)=>a===i?s:r),this.send(!1)})),this.send(t)}async send(e){if(this.sending&&!e){this.waiting=!0;return}const{app:t}=this;this.sending=!0,await t.attempt(()=>hn("drive",{tab:t.tab,request:this.request,arm:t.armName,model:t.model,setpoint_kpa:this.target,e:this.e,restart:e})),this.sending=!1,this.waiting&&(this.waiting=!1,this.send(!1))}onDrive(e){if(e.request===this.request){this.now=e;for(const t of Ta){const i=e[t];if(!i)continue;const s=this.trails.get(t)??[];ad(s,i),this.trails.set(t,s)}this.app.refresh()}}onFault(e,t){this.app.say(t)}refresh(){const{now:e}=this;if(!e)return;const t=gi(this.app.arm.rest);this.readout.replaceChildren(U("p",{},"Distance of each tip from where it lay at rest"),Hl(Ta.flatMap(i=>{const s=e[i];return s?[[Sr[i],ra(Ls(gi(s),t))]]:[]})))}scene(){const{now:e}=this;return{environment:null,figures:Ta.flatMap(i=>{const s=e?.[i];if(!e||!s)return[];const r=i===(e.virtual_arm?"virtual_arm":"simple");return[{shape:s,colour:i,trail:this.trails.get(i),outlined:!r,pressures_kpa:r?e.setpoint_kpa:void 0}]}),showReach:!1}}legend(){return[...Ta.filter(e=>e!=="network"||this.app.model!=="").map(e=>[e,Sr[e]]),["pressure","Pressurised side"]]}}function Qm(n){const{armLink:e,modes:t,planner:i}=n;return{tab:({id:s})=>n.onTab(s),plan:s=>i.onPlan(s),progress:s=>i.onProgress(s),tree:s=>i.onTree(s),fitting:s=>t.plan.onFitting(s),fitted:s=>void n.attempt(()=>t.plan.onFitted(s)),result:s=>i.onResult(s),run:s=>t.play.onRun(s),followed:s=>t.follow.onFollowed(s),drive:s=>t.drive.onDrive(s),arm:s=>e.onStatus(s),arm_frame:s=>e.onFrame(s),arm_run:s=>t.play.onArmRun(s),opened:s=>void n.attempt(()=>n.opening.onOpened(s)),measuring:({request:s,share:r})=>t.results.onMeasuring(s,r),measured:s=>t.results.onMeasured(s),fault:({request:s,message:r})=>i.refuse(s)?n.say(r):n.entered.onFault(s,r)}}const Gl=n=>Math.max(0,n.setpoints_kpa.length-1,...n.tracks.map(({shapes:e})=>e.length-1))/n.frame_rate_hz,Ju=({replan:n,obstacle:e},t)=>({replan:n&&t!=="",obstacle:e});function mo({tracks:n}){const e=t=>n.find(({key:i,shapes:s})=>i===t&&s.length>0);return e("arm")??e("virtual_arm")??n[0]}function Wl(n,e,t,i=!1){const s=mo(n).key;return n.tracks.filter(({key:r,shapes:a})=>e.has(r)&&a.length>0).map(({key:r,shapes:a,pressures_kpa:o})=>({shape:qu(a,n.frame_rate_hz,t),pressures_kpa:qu(o,n.frame_rate_hz,t),colour:r,outlined:i||r!==s&&e.has(s),trail:a.slice(0,Math.round(t*n.frame_rate_hz)+1).map(gi)})).sort((r,a)=>Number(r.outlined)-Number(a.outlined))}function eg(n,{appeared:e},t){return!e||t<e.time_s?n:{...n,obstacles:[...n.obstacles,e.obstacle]}}const ud=.005,tg=.04,Qu=.03,go=n=>n.slice(1).reduce((e,t,i)=>e+Ls(n[i],t),0);function ng(n,e=ud){const t=Math.max(1,Math.round(go(n)/e)),i=go(n)/t,s=[n[0]];let r=0;for(let a=1;a<n.length;++a){const o=Ls(n[a-1],n[a]);for(;s.length<t&&r+o>=i*s.length;){const l=(i*s.length-r)/o;s.push([0,1].map(c=>n[a-1][c]+l*(n[a][c]-n[a-1][c])))}r+=o}return[...s,n[n.length-1]]}function ig(n){const e=n.length>2&&Ls(n[0],n[n.length-1])<Qu&&go(n)>4*Qu,t=ng(e?[...n,n[0]]:n),i=Math.round(tg/ud/2),s=t.length-1,r=a=>t[e?(a%s+s)%s:Math.max(0,Math.min(s,a))];return t.map((a,o)=>{const l=e?i:Math.min(i,o,s-o),c=Array.from({length:2*l+1},(h,u)=>r(o+u-l));return[0,1].map(h=>c.reduce((u,f)=>u+f[h],0)/c.length)})}function sg(n,[e,t],i){return Array.from({length:121},(s,r)=>{const a=2*Math.PI*r/120;return n==="circle"?[e+i*Math.cos(a),t+i*Math.sin(a)]:[e+i*Math.sin(a)*Math.cos(a),t+i*Math.sin(a)]})}function rg(n,e){const t=go(n);let i=0;return n.flatMap((s,r)=>(i+=r===0?0:Ls(n[r-1],s),[e*i/t,...s]))}function ag(n){return["time_s,x_m,y_m",...Array.from({length:n.length/3},(t,i)=>[n[3*i].toFixed(4),n[3*i+1].toFixed(5),n[3*i+2].toFixed(5)].join(",")),""].join(`
`)}class hd{constructor(e,t,i=()=>this.toggle()){this.duration_s=e,this.show=t,this.press=rt("Play",i,{class:"main"}),this.slider.addEventListener("input",()=>this.seek(this.slider.valueAsNumber)),this.element=U("div",{class:"play"},this.press,this.slider,this.clock)}element;time_s=0;playing=!1;turn=0;slider=U("input",{type:"range",min:0,step:"any",value:0,"aria-label":"Time in seconds"});clock=U("output",{"aria-live":"off"});press;seek(e){this.playing=!1,this.move(e)}halt(e){this.playing=!1,this.stand(e)}toggle(){this.playing=!this.playing,this.playing&&this.time_s>=this.duration_s()&&(this.time_s=0);const e=++this.turn;let t=performance.now();const i=s=>{if(!this.playing||e!==this.turn)return;const r=this.time_s+Math.max(0,s-t)/1e3;t=s,r>=this.duration_s()?this.playing=!1:requestAnimationFrame(i),this.move(r)};this.playing&&requestAnimationFrame(i),this.move(this.time_s)}move(e){this.stand(Math.max(0,Math.min(e,this.duration_s()))),this.show(this.time_s)}stand(e){this.time_s=e,this.slider.max=String(this.duration_s()),this.slider.value=String(this.time_s),this.slider.setAttribute("aria-valuetext",`${this.time_s.toFixed(1)} seconds`),Qi(this.clock,`${this.time_s.toFixed(1)} s`),Qi(this.press,this.playing?"Pause":"Play")}}const og=!0,jt="u-",lg="uplot",cg=jt+"hz",ug=jt+"vt",hg=jt+"title",fg=jt+"wrap",dg=jt+"under",pg=jt+"over",mg=jt+"axis",Ms=jt+"off",gg=jt+"select",_g=jt+"cursor-x",vg=jt+"cursor-y",xg=jt+"cursor-pt",Mg=jt+"legend",Sg=jt+"live",yg=jt+"inline",Eg=jt+"series",Tg=jt+"marker",eh=jt+"label",wg=jt+"value",Kr="width",jr="height",Gr="top",th="bottom",Zs="left",Qo="right",Zc="#000",nh=Zc+"0",el="mousemove",ih="mousedown",tl="mouseup",sh="mouseenter",rh="mouseleave",ah="dblclick",bg="resize",Ag="scroll",oh="change",_o="dppxchange",Kc="--",Dr=typeof window<"u",Xl=Dr?document:null,mr=Dr?window:null,Rg=Dr?navigator:null;let _t,wa;function ql(){let n=devicePixelRatio;_t!=n&&(_t=n,wa&&Yl(oh,wa,ql),wa=matchMedia(`(min-resolution: ${_t-.001}dppx) and (max-resolution: ${_t+.001}dppx)`),bs(oh,wa,ql),mr.dispatchEvent(new CustomEvent(_o)))}function Ln(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function $l(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Ut(n,e,t){n.style[e]=t+"px"}function Zn(n,e,t,i){let s=Xl.createElement(n);return e!=null&&Ln(s,e),t?.insertBefore(s,i),s}function kn(n,e){return Zn("div",n,e)}const lh=new WeakMap;function ui(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",a=lh.get(n);r!=a&&(n.style.transform=r,lh.set(n,r),e<0||t<0||e>i||t>s?Ln(n,Ms):$l(n,Ms))}const ch=new WeakMap;function uh(n,e,t){let i=e+t,s=ch.get(n);i!=s&&(ch.set(n,i),n.style.background=e,n.style.borderColor=t)}const hh=new WeakMap;function fh(n,e,t,i){let s=e+""+t,r=hh.get(n);s!=r&&(hh.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}const jc={passive:!0},Cg={...jc,capture:!0};function bs(n,e,t,i){e.addEventListener(n,t,i?Cg:jc)}function Yl(n,e,t,i){e.removeEventListener(n,t,jc)}Dr&&ql();function jn(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Dn((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function fd(n){return(t,i,s)=>{let r=-1,a=-1;for(let o=i;o<=s;o++)if(n(t[o])){r=o;break}for(let o=s;o>=i;o--)if(n(t[o])){a=o;break}return[r,a]}}const dd=n=>n!=null,pd=n=>n!=null&&n>0,Eo=fd(dd),Pg=fd(pd);function Lg(n,e,t,i=0,s=!1){let r=s?Pg:Eo,a=s?pd:dd;[e,t]=r(n,e,t);let o=n[e],l=n[e];if(e>-1)if(i==1)o=n[e],l=n[t];else if(i==-1)o=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??bt,l??-bt]}function To(n,e,t,i){let s=mh(n),r=mh(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let a=t==10?Pi:md,o=s==1?Dn:zn,l=r==1?zn:Dn,c=o(a(Yt(n))),h=l(a(Yt(e))),u=yr(t,c),f=yr(t,h);return t==10&&(c<0&&(u=At(u,-c)),h<0&&(f=At(f,-h))),i||t==2?(n=u*s,e=f*r):(n=xd(n,u),e=wo(e,f)),[n,e]}function Jc(n,e,t,i){let s=To(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}const Qc=.1,dh={mode:3,pad:Qc},na={pad:0,soft:null,mode:0},Dg={min:na,max:na};function vo(n,e,t,i){return bo(t)?ph(n,e,t):(na.pad=t,na.soft=i?0:null,na.mode=i?3:0,ph(n,e,Dg))}function pt(n,e){return n??e}function Ug(n,e,t){for(e=pt(e,0),t=pt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function ph(n,e,t){let i=t.min,s=t.max,r=pt(i.pad,0),a=pt(s.pad,0),o=pt(i.hard,-bt),l=pt(s.hard,bt),c=pt(i.soft,bt),h=pt(s.soft,-bt),u=pt(i.mode,0),f=pt(s.mode,0),p=e-n,_=Pi(p),x=vn(Yt(n),Yt(e)),m=Pi(x),d=Yt(m-_);(p<1e-24||d>10)&&(p=0,(n==0||e==0)&&(p=1e-24,u==2&&c!=bt&&(r=0),f==2&&h!=-bt&&(a=0)));let w=p||x||1e3,T=Pi(w),v=yr(10,Dn(T)),H=w*(p==0?n==0?.1:1:r),L=At(xd(n-H,v/10),24),D=n>=c&&(u==1||u==3&&L<=c||u==2&&L>=c)?c:bt,F=vn(o,L<D&&n>=D?D:Qn(D,L)),b=w*(p==0?e==0?.1:1:a),y=At(wo(e+b,v/10),24),P=e<=h&&(f==1||f==3&&y>=h||f==2&&y<=h)?h:-bt,Y=Qn(l,y>P&&e<=P?P:vn(P,y));return F==Y&&F==0&&(Y=100),[F,Y]}const Ig=new Intl.NumberFormat(Dr?Rg.language:"en-US"),eu=n=>Ig.format(n),In=Math,io=In.PI,Yt=In.abs,Dn=In.floor,$t=In.round,zn=In.ceil,Qn=In.min,vn=In.max,yr=In.pow,mh=In.sign,Pi=In.log10,md=In.log2,Ng=(n,e=1)=>In.sinh(n)*e,nl=(n,e=1)=>In.asinh(n/e),bt=1/0;function gh(n){return(Pi((n^n>>31)-(n>>31))|0)+1}function Zl(n,e,t){return Qn(vn(n,e),t)}function gd(n){return typeof n=="function"}function st(n){return gd(n)?n:()=>n}const Fg=()=>{},_d=n=>n,vd=(n,e)=>e,Og=n=>null,_h=n=>!0,vh=(n,e)=>n==e,Bg=/\.\d*?(?=9{6,}|0{6,})/gm,Ds=n=>{if(Sd(n)||es.has(n))return n;const e=`${n}`,t=e.match(Bg);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ds(s)}e${r}`}return At(n,i)};function gs(n,e){return Ds(At(Ds(n/e))*e)}function wo(n,e){return Ds(zn(Ds(n/e))*e)}function xd(n,e){return Ds(Dn(Ds(n/e))*e)}function At(n,e=0){if(Sd(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return $t(i)/t}const es=new Map;function Md(n){return((""+n).split(".")[1]||"").length}function aa(n,e,t,i){let s=[],r=i.map(Md);for(let a=e;a<t;a++){let o=Yt(a),l=At(yr(n,a),o);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${a}`:i[c]*l,u=(a>=0?0:o)+(a>=r[c]?0:r[c]),f=n==10?h:At(h,u);s.push(f),es.set(f,u)}}return s}const ia={},tu=[],Er=[null,null],Yi=Array.isArray,Sd=Number.isInteger,kg=n=>n===void 0;function xh(n){return typeof n=="string"}function bo(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function zg(n){return n!=null&&typeof n=="object"}const Hg=Object.getPrototypeOf(Uint8Array),yd="__proto__";function Tr(n,e=bo){let t;if(Yi(n)){let i=n.find(s=>s!=null);if(Yi(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Tr(n[s],e)}else t=n.slice()}else if(n instanceof Hg)t=n.slice();else if(e(n)){t={};for(let i in n)i!=yd&&(t[i]=Tr(n[i],e))}else t=n;return t}function Gt(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=yd&&(bo(n[s])?Gt(n[s],Tr(i[s])):n[s]=Tr(i[s]))}return n}const Vg=0,Gg=1,Wg=2;function Xg(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let a=e[i];if(a>r){for(s=a-1;s>=0&&n[s]==null;)n[s--]=null;for(s=a+1;s<t&&n[s]==null;)n[r=s++]=null}}}function qg(n,e){if(Zg(n)){let a=n[0].slice();for(let o=1;o<n.length;o++)a.push(...n[o].slice(1));return Kg(a[0])||(a=Yg(a)),a}let t=new Set;for(let a=0;a<n.length;a++){let l=n[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((a,o)=>a-o)],s=i[0].length,r=new Map;for(let a=0;a<s;a++)r.set(i[0][a],a);for(let a=0;a<n.length;a++){let o=n[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],u=Array(s).fill(void 0),f=e?e[a][c]:Gg,p=[];for(let _=0;_<h.length;_++){let x=h[_],m=r.get(l[_]);x===null?f!=Vg&&(u[m]=x,f==Wg&&p.push(m)):u[m]=x}Xg(u,p,s),i.push(u)}}return i}const $g=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Yg(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<n.length;r++){let a=n[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[i[l]];s.push(o)}return s}function Zg(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Kg(n,e=100){const t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=vn(1,Dn((s-i+1)/e));for(let a=n[i],o=i+r;o<=s;o+=r){const l=n[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}const Ed=["January","February","March","April","May","June","July","August","September","October","November","December"],Td=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function wd(n){return n.slice(0,3)}const jg=Td.map(wd),Jg=Ed.map(wd),Qg={MMMM:Ed,MMM:Jg,WWWW:Td,WWW:jg};function Wr(n){return(n<10?"0":"")+n}function e_(n){return(n<10?"00":n<100?"0":"")+n}const t_={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Wr(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Wr(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Wr(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Wr(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Wr(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>e_(n.getMilliseconds())};function nu(n,e){e=e||Qg;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?t_[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}const n_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function i_(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==n_?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}const bd=n=>n%1==0,xo=[1,2,2.5,5],s_=aa(10,-32,0,xo),Ad=aa(10,0,32,xo),r_=Ad.filter(bd),_s=s_.concat(Ad),iu=`
`,Rd="{YYYY}",Mh=iu+Rd,Cd="{M}/{D}",Jr=iu+Cd,ba=Jr+"/{YY}",Pd="{aa}",a_="{h}:{mm}",hr=a_+Pd,Sh=iu+hr,yh=":{ss}",xt=null;function Ld(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,a=s*365,l=(n==1?aa(10,0,3,xo).filter(bd):aa(10,-3,0,xo)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]);const c=[[a,Rd,xt,xt,xt,xt,xt,xt,1],[s*28,"{MMM}",Mh,xt,xt,xt,xt,xt,1],[s,Cd,Mh,xt,xt,xt,xt,xt,1],[i,"{h}"+Pd,ba,xt,Jr,xt,xt,xt,1],[t,hr,ba,xt,Jr,xt,xt,xt,1],[e,yh,ba+" "+hr,xt,Jr+" "+hr,xt,Sh,xt,1],[n,yh+".{fff}",ba+" "+hr,xt,Jr+" "+hr,xt,Sh,xt,1]];function h(u){return(f,p,_,x,m,d)=>{let w=[],T=m>=a,v=m>=r&&m<a,H=u(_),L=At(H*n,3),D=il(H.getFullYear(),T?0:H.getMonth(),v||T?1:H.getDate()),F=At(D*n,3);if(v||T){let b=v?m/r:0,y=T?m/a:0,P=L==F?L:At(il(D.getFullYear()+y,D.getMonth()+b,1)*n,3),Y=new Date($t(P/n)),B=Y.getFullYear(),q=Y.getMonth();for(let K=0;P<=x;K++){let Z=il(B+y*K,q+b*K,1),J=Z-u(At(Z*n,3));P=At((+Z+J)*n,3),P<=x&&w.push(P)}}else{let b=m>=s?s:m,y=Dn(_)-Dn(L),P=F+y+wo(L-F,b);w.push(P);let Y=u(P),B=Y.getHours()+Y.getMinutes()/t+Y.getSeconds()/i,q=m/i,K=f.axes[p]._space,Z=d/K;for(;P=At(P+m,n==1?0:3),!(P>x);)if(q>1){let J=Dn(At(B+q,6))%24,ce=u(P).getHours()-J;ce>1&&(ce=-1),P-=ce*i,B=(B+q)%24;let me=w[w.length-1];At((P-me)/m,3)*Z>=.7&&w.push(P)}else w.push(P)}return w}}return[l,c,h]}const[o_,l_,c_]=Ld(1),[u_,h_,f_]=Ld(.001);aa(2,-53,53,[1]);function Eh(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Th(n,e){return(t,i,s,r,a)=>{let o=e.find(_=>a>=_[0])||e[e.length-1],l,c,h,u,f,p;return i.map(_=>{let x=n(_),m=x.getFullYear(),d=x.getMonth(),w=x.getDate(),T=x.getHours(),v=x.getMinutes(),H=x.getSeconds(),L=m!=l&&o[2]||d!=c&&o[3]||w!=h&&o[4]||T!=u&&o[5]||v!=f&&o[6]||H!=p&&o[7]||o[1];return l=m,c=d,h=w,u=T,f=v,p=H,L(x)})}}function d_(n,e){let t=nu(e);return(i,s,r,a,o)=>s.map(l=>t(n(l)))}function il(n,e,t){return new Date(n,e,t)}function wh(n,e){return e(n)}const p_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function bh(n,e){return(t,i,s,r)=>r==null?Kc:e(n(i))}function m_(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function g_(n,e){return n.series[e].fill(n,e)}const __={show:!0,live:!0,isolate:!1,mount:Fg,markers:{show:!0,width:2,stroke:m_,fill:g_,dash:"solid"},idx:null,idxs:null,values:[]};function v_(n,e){let t=n.cursor.points,i=kn(),s=t.size(n,e);Ut(i,Kr,s),Ut(i,jr,s);let r=s/-2;Ut(i,"marginLeft",r),Ut(i,"marginTop",r);let a=t.width(n,e,s);return a&&Ut(i,"borderWidth",a),i}function x_(n,e){let t=n.series[e].points;return t._fill||t._stroke}function M_(n,e){let t=n.series[e].points;return t._stroke||t._fill}function S_(n,e){return n.series[e].points.size}const sl=[0,0];function y_(n,e,t){return sl[0]=e,sl[1]=t,sl}function Aa(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function rl(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}const E_={show:!0,x:!0,y:!0,lock:!1,move:y_,points:{one:!1,show:v_,size:S_,width:0,stroke:M_,fill:x_},bind:{mousedown:Aa,mouseup:Aa,click:Aa,dblclick:Aa,mousemove:rl,mouseleave:rl,mouseenter:rl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Dd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},su=Gt({},Dd,{filter:vd}),Ud=Gt({},su,{size:10}),Id=Gt({},Dd,{show:!1}),ru='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Nd="bold "+ru,Fd=1.5,Ah={show:!0,scale:"x",stroke:Zc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Nd,side:2,grid:su,ticks:Ud,border:Id,font:ru,lineGap:Fd,rotate:0},T_="Value",w_="Time",Rh={show:!0,scale:"x",auto:!1,sorted:1,min:bt,max:-bt,idxs:[]};function b_(n,e,t,i,s){return e.map(r=>r==null?"":eu(r))}function A_(n,e,t,i,s,r,a){let o=[],l=es.get(s)||0;t=a?t:At(wo(t,s),l);for(let c=t;c<=i;c=At(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function Kl(n,e,t,i,s,r,a){const o=[],l=n.scales[n.axes[e].scale].log,c=l==10?Pi:md,h=Dn(c(t));s=yr(l,h),l==10&&(s=_s[jn(s,_s)]);let u=t,f=s*l;l==10&&(f=_s[jn(f,_s)]);do o.push(u),u=u+s,l==10&&!es.has(u)&&(u=At(u,es.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=_s[jn(f,_s)]));while(u<=i);return o}function R_(n,e,t,i,s,r,a){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Kl(n,e,vn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Kl(n,e,vn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(h,c)}const Od=/./,C_=/[12357]/,P_=/[125]/,Ch=/1/,jl=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function L_(n,e,t,i,s){let r=n.axes[t],a=r.scale,o=n.scales[a],l=n.valToPos,c=r._space,h=l(10,a),u=l(9,a)-h>=c?Od:l(7,a)-h>=c?C_:l(5,a)-h>=c?P_:Ch;if(u==Ch){let f=Yt(l(1,a)-h);if(f<c)return jl(e.slice().reverse(),o.distr,u,zn(c/f)).reverse()}return jl(e,o.distr,u,1)}function D_(n,e,t,i,s){let r=n.axes[t],a=r.scale,o=r._space,l=n.valToPos,c=Yt(l(1,a)-l(2,a));return c<o?jl(e.slice().reverse(),3,Od,zn(o/c)).reverse():e}function U_(n,e,t,i){return i==null?Kc:e==null?"":eu(e)}const Ph={show:!0,scale:"y",stroke:Zc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Nd,side:3,grid:su,ticks:Ud,border:Id,font:ru,lineGap:Fd,rotate:0};function I_(n,e){let t=3+(n||1)*2;return At(t*e,3)}function N_(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),a=n.valToPos(s[i[1]],t,!0),o=Yt(a-r),l=n.series[e],c=o/(l.points.space*_t);return i[1]-i[0]<=c}const Lh={scale:null,auto:!0,sorted:0,min:bt,max:-bt},Bd=(n,e,t,i,s)=>s,Dh={show:!0,auto:!0,sorted:0,gaps:Bd,alpha:1,facets:[Gt({},Lh,{scale:"x"}),Gt({},Lh,{scale:"y"})]},Uh={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Bd,alpha:1,points:{show:N_,filter:null},values:null,min:bt,max:-bt,idxs:[],path:null,clip:null};function F_(n,e,t,i,s){return t/10}const kd={time:og,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},O_=Gt({},kd,{time:!1,ori:1}),Ih={};function zd(n,e){let t=Ih[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,a,o,l,c)}},n!=null&&(Ih[n]=t)),t}const wr=1,Jl=2;function Fs(n,e,t){const i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,a=n.scales,o=n.bbox;let l=r[0],c=i==2?r[1]:r[e],h=i==2?a[s.facets[0].scale]:a[n.series[0].scale],u=i==2?a[s.facets[1].scale]:a[s.scale],f=o.left,p=o.top,_=o.width,x=o.height,m=n.valToPosH,d=n.valToPosV;return h.ori==0?t(s,l,c,h,u,m,d,f,p,_,x,Ro,Ur,Po,Vd,Wd):t(s,l,c,h,u,d,m,p,f,x,_,Co,Ir,lu,Gd,Xd)}function au(n,e){let t=0,i=0,s=pt(n.bands,tu);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function B_(n,e,t,i,s){let r=n.mode,a=n.series[e],o=r==2?a.facets[1].scale:a.scale,l=n.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Li(n,e,t,i,s,r){return Fs(n,e,(a,o,l,c,h,u,f,p,_,x,m)=>{let d=a.pxRound;const w=c.dir*(c.ori==0?1:-1),T=c.ori==0?Ur:Ir;let v,H;w==1?(v=t,H=i):(v=i,H=t);let L=d(u(o[v],c,x,p)),D=d(f(l[v],h,m,_)),F=d(u(o[H],c,x,p)),b=d(f(r==1?h.max:h.min,h,m,_)),y=new Path2D(s);return T(y,F,b),T(y,L,b),T(y,L,D),y})}function Ao(n,e,t,i,s,r){let a=null;if(n.length>0){a=new Path2D;const o=e==0?Po:lu;let l=t;for(let u=0;u<n.length;u++){let f=n[u];if(f[1]>f[0]){let p=f[0]-l;p>0&&o(a,l,i,p,i+r),l=f[1]}}let c=t+s-l,h=10;c>0&&o(a,l,i-h/2,c,i+r+h)}return a}function k_(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function ou(n,e,t,i,s,r,a){let o=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let u=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(n[u]),_=f==u?p:r(n[f]),x=u-s;p=a<=0&&x>=0&&x<l?r(n[x]):p;let d=f+s;_=a>=0&&d>=0&&d<l?r(n[d]):_,_>=p&&o.push([p,_])}return o}function Nh(n){return n==0?_d:n==1?$t:e=>gs(e,n)}function Hd(n){let e=n==0?Ro:Co,t=n==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},i=n==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?i(s,r,a,o,l):(c=Qn(c,o/2,l/2),h=Qn(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}const Ro=(n,e,t)=>{n.moveTo(e,t)},Co=(n,e,t)=>{n.moveTo(t,e)},Ur=(n,e,t)=>{n.lineTo(e,t)},Ir=(n,e,t)=>{n.lineTo(t,e)},Po=Hd(0),lu=Hd(1),Vd=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Gd=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Wd=(n,e,t,i,s,r,a)=>{n.bezierCurveTo(e,t,i,s,r,a)},Xd=(n,e,t,i,s,r,a)=>{n.bezierCurveTo(t,e,s,i,a,r)};function qd(n){return(e,t,i,s,r)=>Fs(e,t,(a,o,l,c,h,u,f,p,_,x,m)=>{let{pxRound:d,points:w}=a,T,v;c.ori==0?(T=Ro,v=Vd):(T=Co,v=Gd);const H=At(w.width*_t,3);let L=(w.size-w.width)/2*_t,D=At(L*2,3),F=new Path2D,b=new Path2D,{left:y,top:P,width:Y,height:B}=e.bbox;Po(b,y-D,P-D,Y+D*2,B+D*2);const q=K=>{if(l[K]!=null){let Z=d(u(o[K],c,x,p)),J=d(f(l[K],h,m,_));T(F,Z+L,J),v(F,Z,J,L,0,io*2)}};if(r)r.forEach(q);else for(let K=i;K<=s;K++)q(K);return{stroke:H>0?F:null,fill:F,clip:b,flags:wr|Jl}})}function $d(n){return(e,t,i,s,r,a)=>{i!=s&&(r!=i&&a!=i&&n(e,t,i),r!=s&&a!=s&&n(e,t,s),n(e,t,a))}}const z_=$d(Ur),H_=$d(Ir);function Yd(n){const e=pt(n?.alignGaps,0);return(t,i,s,r)=>Fs(t,i,(a,o,l,c,h,u,f,p,_,x,m)=>{[s,r]=Eo(l,s,r);let d=a.pxRound,w=B=>d(u(B,c,x,p)),T=B=>d(f(B,h,m,_)),v,H;c.ori==0?(v=Ur,H=z_):(v=Ir,H=H_);const L=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wr},F=D.stroke;let b=!1;if(r-s>=x*4){let B=pe=>t.posToVal(pe,c.key,!0),q=null,K=null,Z,J,Q,he=w(o[L==1?s:r]),ce=w(o[s]),me=w(o[r]),Me=B(L==1?ce+1:me-1);for(let pe=L==1?s:r;pe>=s&&pe<=r;pe+=L){let ie=o[pe],ge=(L==1?ie<Me:ie>Me)?he:w(ie),ae=l[pe];ge==he?ae!=null?(J=ae,q==null?(v(F,ge,T(J)),Z=q=K=J):J<q?q=J:J>K&&(K=J)):ae===null&&(b=!0):(q!=null&&H(F,he,T(q),T(K),T(Z),T(J)),ae!=null?(J=ae,v(F,ge,T(J)),q=K=Z=J):(q=K=null,ae===null&&(b=!0)),he=ge,Me=B(he+L))}q!=null&&q!=K&&Q!=he&&H(F,he,T(q),T(K),T(Z),T(J))}else for(let B=L==1?s:r;B>=s&&B<=r;B+=L){let q=l[B];q===null?b=!0:q!=null&&v(F,w(o[B]),T(q))}let[P,Y]=au(t,i);if(a.fill!=null||P!=0){let B=D.fill=new Path2D(F),q=a.fillTo(t,i,a.min,a.max,P),K=T(q),Z=w(o[s]),J=w(o[r]);L==-1&&([J,Z]=[Z,J]),v(B,J,K),v(B,Z,K)}if(!a.spanGaps){let B=[];b&&B.push(...ou(o,l,s,r,L,w,e)),D.gaps=B=a.gaps(t,i,s,r,B),D.clip=Ao(B,c.ori,p,_,x,m)}return Y!=0&&(D.band=Y==2?[Li(t,i,s,r,F,-1),Li(t,i,s,r,F,1)]:Li(t,i,s,r,F,Y)),D})}function V_(n){const e=pt(n.align,1),t=pt(n.ascDesc,!1),i=pt(n.alignGaps,0),s=pt(n.extend,!1);return(r,a,o,l)=>Fs(r,a,(c,h,u,f,p,_,x,m,d,w,T)=>{[o,l]=Eo(u,o,l);let v=c.pxRound,{left:H,width:L}=r.bbox,D=ce=>v(_(ce,f,w,m)),F=ce=>v(x(ce,p,T,d)),b=f.ori==0?Ur:Ir;const y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wr},P=y.stroke,Y=f.dir*(f.ori==0?1:-1);let B=F(u[Y==1?o:l]),q=D(h[Y==1?o:l]),K=q,Z=q;s&&e==-1&&(Z=H,b(P,Z,B)),b(P,q,B);for(let ce=Y==1?o:l;ce>=o&&ce<=l;ce+=Y){let me=u[ce];if(me==null)continue;let Me=D(h[ce]),pe=F(me);e==1?b(P,Me,B):b(P,K,pe),b(P,Me,pe),B=pe,K=Me}let J=K;s&&e==1&&(J=H+L,b(P,J,B));let[Q,he]=au(r,a);if(c.fill!=null||Q!=0){let ce=y.fill=new Path2D(P),me=c.fillTo(r,a,c.min,c.max,Q),Me=F(me);b(ce,J,Me),b(ce,Z,Me)}if(!c.spanGaps){let ce=[];ce.push(...ou(h,u,o,l,Y,D,i));let me=c.width*_t/2,Me=t||e==1?me:-me,pe=t||e==-1?-me:me;ce.forEach(ie=>{ie[0]+=Me,ie[1]+=pe}),y.gaps=ce=c.gaps(r,a,o,l,ce),y.clip=Ao(ce,f.ori,m,d,w,T)}return he!=0&&(y.band=he==2?[Li(r,a,o,l,P,-1),Li(r,a,o,l,P,1)]:Li(r,a,o,l,P,he)),y})}function Fh(n,e,t,i,s,r,a=bt){if(n.length>1){let o=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(o!=null){let h=Yt(n[l]-n[o]);h<c&&(c=h,a=Yt(t(n[l],i,s,r)-t(n[o],i,s,r)))}o=l}}return a}function G_(n){n=n||ia;const e=pt(n.size,[.6,bt,1]),t=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=st(s),a=1-e[0],o=pt(e[1],bt),l=pt(e[2],1),c=pt(n.disp,ia),h=pt(n.each,p=>{}),{fill:u,stroke:f}=c;return(p,_,x,m)=>Fs(p,_,(d,w,T,v,H,L,D,F,b,y,P)=>{let Y=d.pxRound,B=t,q=i*_t,K=o*_t,Z=l*_t,J,Q;v.ori==0?[J,Q]=r(p,_):[Q,J]=r(p,_);const he=v.dir*(v.ori==0?1:-1);let ce=v.ori==0?Po:lu,me=v.ori==0?h:(V,ee,Se,_e,we,Ye,fe)=>{h(V,ee,Se,we,_e,fe,Ye)},Me=pt(p.bands,tu).find(V=>V.series[0]==_),pe=Me!=null?Me.dir:0,ie=d.fillTo(p,_,d.min,d.max,pe),oe=Y(D(ie,H,P,b)),ge,ae,ke,He=y,Ie=Y(d.width*_t),at=!1,Ze=null,ot=null,k=null,Xt=null;u!=null&&(Ie==0||f!=null)&&(at=!0,Ze=u.values(p,_,x,m),ot=new Map,new Set(Ze).forEach(V=>{V!=null&&ot.set(V,new Path2D)}),Ie>0&&(k=f.values(p,_,x,m),Xt=new Map,new Set(k).forEach(V=>{V!=null&&Xt.set(V,new Path2D)})));let{x0:je,size:Qe}=c;if(je!=null&&Qe!=null){B=1,w=je.values(p,_,x,m),je.unit==2&&(w=w.map(Se=>p.posToVal(F+Se*y,v.key,!0)));let V=Qe.values(p,_,x,m);Qe.unit==2?ae=V[0]*y:ae=L(V[0],v,y,F)-L(0,v,y,F),He=Fh(w,T,L,v,y,F,He),ke=He-ae+q}else He=Fh(w,T,L,v,y,F,He),ke=He*a+q,ae=He-ke;ke<1&&(ke=0),Ie>=ae/2&&(Ie=0),ke<5&&(Y=_d);let Ve=ke>0,ct=He-ke-(Ve?Ie:0);ae=Y(Zl(ct,Z,K)),ge=(B==0?ae/2:B==he?0:ae)-B*he*((B==0?q/2:0)+(Ve?Ie/2:0));const Pe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},R=at?null:new Path2D;let S=null;if(Me!=null)S=p.data[Me.series[1]];else{let{y0:V,y1:ee}=c;V!=null&&ee!=null&&(T=ee.values(p,_,x,m),S=V.values(p,_,x,m))}let $=J*ae,j=Q*ae;for(let V=he==1?x:m;V>=x&&V<=m;V+=he){let ee=T[V];if(ee==null)continue;if(S!=null){let Oe=S[V]??0;if(ee-Oe==0)continue;oe=D(Oe,H,P,b)}let Se=v.distr!=2||c!=null?w[V]:V,_e=L(Se,v,y,F),we=D(pt(ee,ie),H,P,b),Ye=Y(_e-ge),fe=Y(vn(we,oe)),ve=Y(Qn(we,oe)),Ne=fe-ve;if(ee!=null){let Oe=ee<0?j:$,Ee=ee<0?$:j;at?(Ie>0&&k[V]!=null&&ce(Xt.get(k[V]),Ye,ve+Dn(Ie/2),ae,vn(0,Ne-Ie),Oe,Ee),Ze[V]!=null&&ce(ot.get(Ze[V]),Ye,ve+Dn(Ie/2),ae,vn(0,Ne-Ie),Oe,Ee)):ce(R,Ye,ve+Dn(Ie/2),ae,vn(0,Ne-Ie),Oe,Ee),me(p,_,V,Ye-Ie/2,ve,ae+Ie,Ne)}}return Ie>0?Pe.stroke=at?Xt:R:at||(Pe._fill=d.width==0?d._fill:d._stroke??d._fill,Pe.width=0),Pe.fill=at?ot:R,Pe})}function W_(n,e){const t=pt(e?.alignGaps,0);return(i,s,r,a)=>Fs(i,s,(o,l,c,h,u,f,p,_,x,m,d)=>{[r,a]=Eo(c,r,a);let w=o.pxRound,T=J=>w(f(J,h,m,_)),v=J=>w(p(J,u,d,x)),H,L,D;h.ori==0?(H=Ro,D=Ur,L=Wd):(H=Co,D=Ir,L=Xd);const F=h.dir*(h.ori==0?1:-1);let b=T(l[F==1?r:a]),y=b,P=[],Y=[];for(let J=F==1?r:a;J>=r&&J<=a;J+=F)if(c[J]!=null){let he=l[J],ce=T(he);P.push(y=ce),Y.push(v(c[J]))}const B={stroke:n(P,Y,H,D,L,w),fill:null,clip:null,band:null,gaps:null,flags:wr},q=B.stroke;let[K,Z]=au(i,s);if(o.fill!=null||K!=0){let J=B.fill=new Path2D(q),Q=o.fillTo(i,s,o.min,o.max,K),he=v(Q);D(J,y,he),D(J,b,he)}if(!o.spanGaps){let J=[];J.push(...ou(l,c,r,a,F,T,t)),B.gaps=J=o.gaps(i,s,r,a,J),B.clip=Ao(J,h.ori,_,x,m,d)}return Z!=0&&(B.band=Z==2?[Li(i,s,r,a,q,-1),Li(i,s,r,a,q,1)]:Li(i,s,r,a,q,Z)),B})}function X_(n){return W_(q_,n)}function q_(n,e,t,i,s,r){const a=n.length;if(a<2)return null;const o=new Path2D;if(t(o,n[0],e[0]),a==2)i(o,n[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),u=Array(a-1);for(let f=0;f<a-1;f++)h[f]=e[f+1]-e[f],u[f]=n[f+1]-n[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<a-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[a-1]=c[a-2];for(let f=0;f<a-1;f++)s(o,n[f]+u[f]/3,e[f]+l[f]*u[f]/3,n[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,n[f+1],e[f+1])}return o}const Ql=new Set;function Oh(){for(let n of Ql)n.syncRect(!0)}Dr&&(bs(bg,mr,Oh),bs(Ag,mr,Oh,!0),bs(_o,mr,()=>{fn.pxRatio=_t}));const $_=Yd(),Y_=qd();function Bh(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,a)=>ec(r,a,e,t))}function Z_(n,e){return n.map((t,i)=>i==0?{}:Gt({},e,t))}function ec(n,e,t,i){return Gt({},e==0?t:i,n)}function Zd(n,e,t){return e==null?Er:[e,t]}const K_=Zd;function j_(n,e,t){return e==null?Er:vo(e,t,Qc,!0)}function Kd(n,e,t,i){return e==null?Er:To(e,t,n.scales[i].log,!1)}const J_=Kd;function jd(n,e,t,i){return e==null?Er:Jc(e,t,n.scales[i].log,!1)}const Q_=jd;function e0(n,e,t,i,s){let r=vn(gh(n),gh(e)),a=e-n,o=jn(s/i*a,t);do{let l=t[o],c=i*l/a;if(c>=s&&r+(l<5?es.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function kh(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=$t((t=+s)*_t))+"px"),[n,e,t]}function t0(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=At(e[2]*_t,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function fn(n,e,t){const i={mode:pt(n.mode,1)},s=i.mode;function r(g,M,A,C){let I=M.valToPct(g);return C+A*(M.dir==-1?1-I:I)}function a(g,M,A,C){let I=M.valToPct(g);return C+A*(M.dir==-1?I:1-I)}function o(g,M,A,C){return M.ori==0?r(g,M,A,C):a(g,M,A,C)}i.valToPosH=r,i.valToPosV=a;let l=!1;i.status=0;const c=i.root=kn(lg);if(n.id!=null&&(c.id=n.id),Ln(c,n.class),n.title){let g=kn(hg,c);g.textContent=n.title}const h=Zn("canvas"),u=i.ctx=h.getContext("2d"),f=kn(fg,c);bs("click",f,g=>{g.target===_&&(Pt!=Ws||Ft!=Xs)&&an.click(i,g)},!0);const p=i.under=kn(dg,f);f.appendChild(h);const _=i.over=kn(pg,f);n=Tr(n);const x=+pt(n.pxAlign,1),m=Nh(x);(n.plugins||[]).forEach(g=>{g.opts&&(n=g.opts(i,n)||n)});const d=n.ms||.001,w=i.series=s==1?Bh(n.series||[],Rh,Uh,!1):Z_(n.series||[null],Dh),T=i.axes=Bh(n.axes||[],Ah,Ph,!0),v=i.scales={},H=i.bands=n.bands||[];H.forEach(g=>{g.fill=st(g.fill||null),g.dir=pt(g.dir,-1)});const L=s==2?w[1].facets[0].scale:w[0].scale,D={axes:kp,series:Nn},F=(n.drawOrder||["axes","series"]).map(g=>D[g]);function b(g){const M=g.distr==3?A=>Pi(A>0?A:g.clamp(i,A,g.min,g.max,g.key)):g.distr==4?A=>nl(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let C=M(A),{_min:I,_max:X}=g,se=X-I;return(C-I)/se}}function y(g){let M=v[g];if(M==null){let A=(n.scales||ia)[g]||ia;if(A.from!=null){y(A.from);let C=Gt({},v[A.from],A,{key:g});C.valToPct=b(C),v[g]=C}else{M=v[g]=Gt({},g==L?kd:O_,A),M.key=g;let C=M.time,I=M.range,X=Yi(I);if((g!=L||s==2&&!C)&&(X&&(I[0]==null||I[1]==null)&&(I={min:I[0]==null?dh:{mode:1,hard:I[0],soft:I[0]},max:I[1]==null?dh:{mode:1,hard:I[1],soft:I[1]}},X=!1),!X&&bo(I))){let se=I;I=(le,de,Re)=>de==null?Er:vo(de,Re,se)}M.range=st(I||(C?K_:g==L?M.distr==3?J_:M.distr==4?Q_:Zd:M.distr==3?Kd:M.distr==4?jd:j_)),M.auto=st(X?!1:M.auto),M.clamp=st(M.clamp||F_),M._min=M._max=null,M.valToPct=b(M)}}}y("x"),y("y"),s==1&&w.forEach(g=>{y(g.scale)}),T.forEach(g=>{y(g.scale)});for(let g in n.scales)y(g);const P=v[L],Y=P.distr;let B,q;P.ori==0?(Ln(c,cg),B=r,q=a):(Ln(c,ug),B=a,q=r);const K={};for(let g in v){let M=v[g];(M.min!=null||M.max!=null)&&(K[g]={min:M.min,max:M.max},M.min=M.max=null)}const Z=n.tzDate||(g=>new Date($t(g/d))),J=n.fmtDate||nu,Q=d==1?c_(Z):f_(Z),he=Th(Z,Eh(d==1?l_:h_,J)),ce=bh(Z,wh(p_,J)),me=[],Me=i.legend=Gt({},__,n.legend),pe=i.cursor=Gt({},E_,{drag:{y:s==2}},n.cursor),ie=Me.show,oe=pe.show,ge=Me.markers;Me.idxs=me,ge.width=st(ge.width),ge.dash=st(ge.dash),ge.stroke=st(ge.stroke),ge.fill=st(ge.fill);let ae,ke,He,Ie=[],at=[],Ze,ot=!1,k={};if(Me.live){const g=w[1]?w[1].values:null;ot=g!=null,Ze=ot?g(i,1,0):{_:0};for(let M in Ze)k[M]=Kc}if(ie)if(ae=Zn("table",Mg,c),He=Zn("tbody",null,ae),Me.mount(i,ae),ot){ke=Zn("thead",null,ae,He);let g=Zn("tr",null,ke);Zn("th",null,g);for(var Xt in Ze)Zn("th",eh,g).textContent=Xt}else Ln(ae,yg),Me.live&&Ln(ae,Sg);const je={show:!0},Qe={show:!1};function Ve(g,M){if(M==0&&(ot||!Me.live||s==2))return Er;let A=[],C=Zn("tr",Eg,He,He.childNodes[M]);Ln(C,g.class),g.show||Ln(C,Ms);let I=Zn("th",null,C);if(ge.show){let le=kn(Tg,I);if(M>0){let de=ge.width(i,M);de&&(le.style.border=de+"px "+ge.dash(i,M)+" "+ge.stroke(i,M)),le.style.background=ge.fill(i,M)}}let X=kn(eh,I);g.label instanceof HTMLElement?X.appendChild(g.label):X.textContent=g.label,M>0&&(ge.show||(X.style.color=g.width>0?ge.stroke(i,M):ge.fill(i,M)),Pe("click",I,le=>{if(pe._lock)return;qt(le);let de=w.indexOf(g);if((le.ctrlKey||le.metaKey)!=Me.isolate){let Re=w.some((Ce,Le)=>Le>0&&Le!=de&&Ce.show);w.forEach((Ce,Le)=>{Le>0&&ai(Le,Re?Le==de?je:Qe:je,!0,Ht.setSeries)})}else ai(de,{show:!g.show},!0,Ht.setSeries)},!1),_i&&Pe(sh,I,le=>{pe._lock||(qt(le),ai(w.indexOf(g),$s,!0,Ht.setSeries))},!1));for(var se in Ze){let le=Zn("td",wg,C);le.textContent="--",A.push(le)}return[C,A]}const ct=new Map;function Pe(g,M,A,C=!0){const I=ct.get(M)||{},X=pe.bind[g](i,M,A,C);X&&(bs(g,M,I[g]=X),ct.set(M,I))}function R(g,M,A){const C=ct.get(M)||{};for(let I in C)(g==null||I==g)&&(Yl(I,M,C[I]),delete C[I]);g==null&&ct.delete(M)}let S=0,$=0,j=0,V=0,ee=0,Se=0,_e=ee,we=Se,Ye=j,fe=V,ve=0,Ne=0,Oe=0,Ee=0;i.bbox={};let tt=!1,qe=!1,ut=!1,O=!1,xe=!1,te=!1;function re(g,M,A){(A||g!=i.width||M!=i.height)&&be(g,M),zs(!1),ut=!0,qe=!0,Hs()}function be(g,M){i.width=S=j=g,i.height=$=V=M,ee=Se=0,Jt(),mt();let A=i.bbox;ve=A.left=gs(ee*_t,.5),Ne=A.top=gs(Se*_t,.5),Oe=A.width=gs(j*_t,.5),Ee=A.height=gs(V*_t,.5)}const Ae=3;function Ke(){let g=!1,M=0;for(;!g;){M++;let A=Op(M),C=Bp(M);g=M==Ae||A&&C,g||(be(i.width,i.height),qe=!0)}}function It({width:g,height:M}){re(g,M)}i.setSize=It;function Jt(){let g=!1,M=!1,A=!1,C=!1;T.forEach((I,X)=>{if(I.show&&I._show){let{side:se,_size:le}=I,de=se%2,Re=I.label!=null?I.labelSize:0,Ce=le+Re;Ce>0&&(de?(j-=Ce,se==3?(ee+=Ce,C=!0):A=!0):(V-=Ce,se==0?(Se+=Ce,g=!0):M=!0))}}),ii[0]=g,ii[1]=A,ii[2]=M,ii[3]=C,j-=E[1]+E[3],ee+=E[3],V-=E[2]+E[0],Se+=E[0]}function mt(){let g=ee+j,M=Se+V,A=ee,C=Se;function I(X,se){switch(X){case 1:return g+=se,g-se;case 2:return M+=se,M-se;case 3:return A-=se,A+se;case 0:return C-=se,C+se}}T.forEach((X,se)=>{if(X.show&&X._show){let le=X.side;X._pos=I(le,X._size),X.label!=null&&(X._lpos=I(le,X.labelSize))}})}if(pe.dataIdx==null){let g=pe.hover,M=g.skip=new Set(g.skip??[]);M.add(void 0);let A=g.prox=st(g.prox),C=g.bias??=0;pe.dataIdx=(I,X,se,le)=>{if(X==0)return se;let de=se,Re=A(I,X,se,le)??bt,Ce=Re>=0&&Re<bt,Le=P.ori==0?j:V,$e=pe.left,gt=e[0],dt=e[X];if(M.has(dt[se])){de=null;let nt=null,We=null,ze;if(C==0||C==-1)for(ze=se;nt==null&&ze-- >0;)M.has(dt[ze])||(nt=ze);if(C==0||C==1)for(ze=se;We==null&&ze++<dt.length;)M.has(dt[ze])||(We=ze);if(nt!=null||We!=null)if(Ce){let Dt=nt==null?-1/0:B(gt[nt],P,Le,0),Bt=We==null?1/0:B(gt[We],P,Le,0),sn=$e-Dt,St=Bt-$e;sn<=St?sn<=Re&&(de=nt):St<=Re&&(de=We)}else de=We==null?nt:nt==null?We:se-nt<=We-se?nt:We}else Ce&&Yt($e-B(gt[se],P,Le,0))>Re&&(de=null);return de}}const qt=g=>{pe.event=g};pe.idxs=me,pe._lock=!1;let Rt=pe.points;Rt.show=st(Rt.show),Rt.size=st(Rt.size),Rt.stroke=st(Rt.stroke),Rt.width=st(Rt.width),Rt.fill=st(Rt.fill);const wn=i.focus=Gt({},n.focus||{alpha:.3},pe.focus),_i=wn.prox>=0,xn=_i&&Rt.one;let on=[],vi=[],xi=[];function ss(g,M){let A=Rt.show(i,M);if(A instanceof HTMLElement)return Ln(A,xg),Ln(A,g.class),ui(A,-10,-10,j,V),_.insertBefore(A,on[M]),A}function Or(g,M){if(s==1||M>0){let A=s==1&&v[g.scale].time,C=g.value;g.value=A?xh(C)?bh(Z,wh(C,J)):C||ce:C||U_,g.label=g.label||(A?w_:T_)}if(xn||M>0){g.width=g.width==null?1:g.width,g.paths=g.paths||$_||Og,g.fillTo=st(g.fillTo||B_),g.pxAlign=+pt(g.pxAlign,x),g.pxRound=Nh(g.pxAlign),g.stroke=st(g.stroke||null),g.fill=st(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=I_(vn(1,g.width),1),C=g.points=Gt({},{size:A,width:vn(1,A*.2),stroke:g.stroke,space:A*2,paths:Y_,_stroke:null,_fill:null},g.points);C.show=st(C.show),C.filter=st(C.filter),C.fill=st(C.fill),C.stroke=st(C.stroke),C.paths=st(C.paths),C.pxAlign=g.pxAlign}if(ie){let A=Ve(g,M);Ie.splice(M,0,A[0]),at.splice(M,0,A[1]),Me.values.push(null)}if(oe){me.splice(M,0,null);let A=null;xn?M==0&&(A=ss(g,M)):M>0&&(A=ss(g,M)),on.splice(M,0,A),vi.splice(M,0,0),xi.splice(M,0,0)}nn("addSeries",M)}function Bs(g,M){M=M??w.length,g=s==1?ec(g,M,Rh,Uh):ec(g,M,{},Dh),w.splice(M,0,g),Or(w[M],M)}i.addSeries=Bs;function ga(g){if(w.splice(g,1),ie){Me.values.splice(g,1),at.splice(g,1);let M=Ie.splice(g,1)[0];R(null,M.firstChild),M.remove()}oe&&(me.splice(g,1),on.splice(g,1)[0].remove(),vi.splice(g,1),xi.splice(g,1)),nn("delSeries",g)}i.delSeries=ga;const ii=[!1,!1,!1,!1];function Bo(g,M){if(g._show=g.show,g.show){let A=g.side%2,C=v[g.scale];C==null&&(g.scale=A?w[1].scale:L,C=v[g.scale]);let I=C.time;g.size=st(g.size),g.space=st(g.space),g.rotate=st(g.rotate),Yi(g.incrs)&&g.incrs.forEach(se=>{!es.has(se)&&es.set(se,Md(se))}),g.incrs=st(g.incrs||(C.distr==2?r_:I?d==1?o_:u_:_s)),g.splits=st(g.splits||(I&&C.distr==1?Q:C.distr==3?Kl:C.distr==4?R_:A_)),g.stroke=st(g.stroke),g.grid.stroke=st(g.grid.stroke),g.ticks.stroke=st(g.ticks.stroke),g.border.stroke=st(g.border.stroke);let X=g.values;g.values=Yi(X)&&!Yi(X[0])?st(X):I?Yi(X)?Th(Z,Eh(X,J)):xh(X)?d_(Z,X):X||he:X||b_,g.filter=st(g.filter||(C.distr>=3&&C.log==10?L_:C.distr==3&&C.log==2?D_:vd)),g.font=kh(g.font),g.labelFont=kh(g.labelFont),g._size=g.size(i,null,M,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(ii[M]=!0,g._el=kn(mg,f))}}function rs(g,M,A,C){let[I,X,se,le]=A,de=M%2,Re=0;return de==0&&(le||X)&&(Re=M==0&&!I||M==2&&!se?$t(Ah.size/3):0),de==1&&(I||se)&&(Re=M==1&&!X||M==3&&!le?$t(Ph.size/2):0),Re}const _a=i.padding=(n.padding||[rs,rs,rs,rs]).map(g=>st(pt(g,rs))),E=i._padding=_a.map((g,M)=>g(i,M,ii,0));let N,G=null,W=null;const z=s==1?w[0].idxs:null;let ue=null,ye=!1;function Fe(g,M){if(e=g??[],i.data=i._data=e,s==2){N=0;for(let A=1;A<w.length;A++)N+=e[A][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ue=e[0],N=ue.length;let A=e;if(Y==2){A=e.slice();let C=A[0]=Array(N);for(let I=0;I<N;I++)C[I]=I}i._data=e=A}if(zs(!0),nn("setData"),Y==2&&(ut=!0),M!==!1){let A=P;A.auto(i,ye)?De():ki(L,A.min,A.max),O=O||pe.left>=0,te=!0,Hs()}}i.setData=Fe;function De(){ye=!0;let g,M;s==1&&(N>0?(G=z[0]=0,W=z[1]=N-1,g=e[0][G],M=e[0][W],Y==2?(g=G,M=W):g==M&&(Y==3?[g,M]=To(g,g,P.log,!1):Y==4?[g,M]=Jc(g,g,P.log,!1):P.time?M=g+$t(86400/d):[g,M]=vo(g,M,Qc,!0))):(G=z[0]=g=null,W=z[1]=M=null)),ki(L,g,M)}let Ge,Xe,Ue,it,vt,Mt,Qt,lt,Be,Nt;function ht(g,M,A,C,I,X){g??=nh,A??=tu,C??="butt",I??=nh,X??="round",g!=Ge&&(u.strokeStyle=Ge=g),I!=Xe&&(u.fillStyle=Xe=I),M!=Ue&&(u.lineWidth=Ue=M),X!=vt&&(u.lineJoin=vt=X),C!=Mt&&(u.lineCap=Mt=C),A!=it&&u.setLineDash(it=A)}function Mn(g,M,A,C){M!=Xe&&(u.fillStyle=Xe=M),g!=Qt&&(u.font=Qt=g),A!=lt&&(u.textAlign=lt=A),C!=Be&&(u.textBaseline=Be=C)}function si(g,M,A,C,I=0){if(C.length>0&&g.auto(i,ye)&&(M==null||M.min==null)){let X=pt(G,0),se=pt(W,C.length-1),le=A.min==null?Lg(C,X,se,I,g.distr==3):[A.min,A.max];g.min=Qn(g.min,A.min=le[0]),g.max=vn(g.max,A.max=le[1])}}const ln={min:null,max:null};function as(){for(let C in v){let I=v[C];K[C]==null&&(I.min==null||K[L]!=null&&I.auto(i,ye))&&(K[C]=ln)}for(let C in v){let I=v[C];K[C]==null&&I.from!=null&&K[I.from]!=null&&(K[C]=ln)}K[L]!=null&&zs(!0);let g={};for(let C in K){let I=K[C];if(I!=null){let X=g[C]=Tr(v[C],zg);if(I.min!=null)Gt(X,I);else if(C!=L||s==2)if(N==0&&X.from==null){let se=X.range(i,null,null,C);X.min=se[0],X.max=se[1]}else X.min=bt,X.max=-bt}}if(N>0){w.forEach((C,I)=>{if(s==1){let X=C.scale,se=K[X];if(se==null)return;let le=g[X];if(I==0){let de=le.range(i,le.min,le.max,X);le.min=de[0],le.max=de[1],G=jn(le.min,e[0]),W=jn(le.max,e[0]),W-G>1&&(e[0][G]<le.min&&G++,e[0][W]>le.max&&W--),C.min=ue[G],C.max=ue[W]}else C.show&&C.auto&&si(le,se,C,e[I],C.sorted);C.idxs[0]=G,C.idxs[1]=W}else if(I>0&&C.show&&C.auto){let[X,se]=C.facets,le=X.scale,de=se.scale,[Re,Ce]=e[I],Le=g[le],$e=g[de];Le!=null&&si(Le,K[le],X,Re,X.sorted),$e!=null&&si($e,K[de],se,Ce,se.sorted),C.min=se.min,C.max=se.max}});for(let C in g){let I=g[C],X=K[C];if(I.from==null&&(X==null||X.min==null)){let se=I.range(i,I.min==bt?null:I.min,I.max==-bt?null:I.max,C);I.min=se[0],I.max=se[1]}}}for(let C in g){let I=g[C];if(I.from!=null){let X=g[I.from];if(X.min==null)I.min=I.max=null;else{let se=I.range(i,X.min,X.max,C);I.min=se[0],I.max=se[1]}}}let M={},A=!1;for(let C in g){let I=g[C],X=v[C];if(X.min!=I.min||X.max!=I.max){X.min=I.min,X.max=I.max;let se=X.distr;X._min=se==3?Pi(X.min):se==4?nl(X.min,X.asinh):se==100?X.fwd(X.min):X.min,X._max=se==3?Pi(X.max):se==4?nl(X.max,X.asinh):se==100?X.fwd(X.max):X.max,M[C]=A=!0}}if(A){w.forEach((C,I)=>{s==2?I>0&&M.y&&(C._paths=null):M[C.scale]&&(C._paths=null)});for(let C in M)ut=!0,nn("setScale",C);oe&&pe.left>=0&&(O=te=!0)}for(let C in K)K[C]=null}function wt(g){let M=Zl(G-1,0,N-1),A=Zl(W+1,0,N-1);for(;g[M]==null&&M>0;)M--;for(;g[A]==null&&A<N-1;)A++;return[M,A]}function Nn(){if(N>0){let g=w.some(M=>M._focus)&&Nt!=wn.alpha;g&&(u.globalAlpha=Nt=wn.alpha),w.forEach((M,A)=>{if(A>0&&M.show&&(Oi(A,!1),Oi(A,!0),M._paths==null)){let C=Nt;Nt!=M.alpha&&(u.globalAlpha=Nt=M.alpha);let I=s==2?[0,e[A][0].length-1]:wt(e[A]);M._paths=M.paths(i,A,I[0],I[1]),Nt!=C&&(u.globalAlpha=Nt=C)}}),w.forEach((M,A)=>{if(A>0&&M.show){let C=Nt;Nt!=M.alpha&&(u.globalAlpha=Nt=M.alpha),M._paths!=null&&dn(A,!1);{let I=M._paths!=null?M._paths.gaps:null,X=M.points.show(i,A,G,W,I),se=M.points.filter(i,A,X,I);(X||se)&&(M.points._paths=M.points.paths(i,A,G,W,se),dn(A,!0))}Nt!=C&&(u.globalAlpha=Nt=C),nn("drawSeries",A)}}),g&&(u.globalAlpha=Nt=1)}}function Oi(g,M){let A=M?w[g].points:w[g];A._stroke=A.stroke(i,g),A._fill=A.fill(i,g)}function dn(g,M){let A=M?w[g].points:w[g],{stroke:C,fill:I,clip:X,flags:se,_stroke:le=A._stroke,_fill:de=A._fill,_width:Re=A.width}=A._paths;Re=At(Re*_t,3);let Ce=null,Le=Re%2/2;M&&de==null&&(de=Re>0?"#fff":le);let $e=A.pxAlign==1&&Le>0;if($e&&u.translate(Le,Le),!M){let gt=ve-Re/2,dt=Ne-Re/2,nt=Oe+Re,We=Ee+Re;Ce=new Path2D,Ce.rect(gt,dt,nt,We)}M?ks(le,Re,A.dash,A.cap,de,C,I,se,X):ri(g,le,Re,A.dash,A.cap,de,C,I,se,Ce,X),$e&&u.translate(-Le,-Le)}function ri(g,M,A,C,I,X,se,le,de,Re,Ce){let Le=!1;de!=0&&H.forEach(($e,gt)=>{if($e.series[0]==g){let dt=w[$e.series[1]],nt=e[$e.series[1]],We=(dt._paths||ia).band;Yi(We)&&(We=$e.dir==1?We[0]:We[1]);let ze,Dt=null;dt.show&&We&&Ug(nt,G,W)?(Dt=$e.fill(i,gt)||X,ze=dt._paths.clip):We=null,ks(M,A,C,I,Dt,se,le,de,Re,Ce,ze,We),Le=!0}}),Le||ks(M,A,C,I,X,se,le,de,Re,Ce)}const Gn=wr|Jl;function ks(g,M,A,C,I,X,se,le,de,Re,Ce,Le){ht(g,M,A,C,I),(de||Re||Le)&&(u.save(),de&&u.clip(de),Re&&u.clip(Re)),Le?(le&Gn)==Gn?(u.clip(Le),Ce&&u.clip(Ce),xa(I,se),va(g,X,M)):le&Jl?(xa(I,se),u.clip(Le),va(g,X,M)):le&wr&&(u.save(),u.clip(Le),Ce&&u.clip(Ce),xa(I,se),u.restore(),va(g,X,M)):(xa(I,se),va(g,X,M)),(de||Re||Le)&&u.restore()}function va(g,M,A){A>0&&(M instanceof Map?M.forEach((C,I)=>{u.strokeStyle=Ge=I,u.stroke(C)}):M!=null&&g&&u.stroke(M))}function xa(g,M){M instanceof Map?M.forEach((A,C)=>{u.fillStyle=Xe=C,u.fill(A)}):M!=null&&g&&u.fill(M)}function Fp(g,M,A,C){let I=T[g],X;if(C<=0)X=[0,0];else{let se=I._space=I.space(i,g,M,A,C),le=I._incrs=I.incrs(i,g,M,A,C,se);X=e0(M,A,le,C,se)}return I._found=X}function ko(g,M,A,C,I,X,se,le,de,Re){let Ce=se%2/2;x==1&&u.translate(Ce,Ce),ht(le,se,de,Re,le),u.beginPath();let Le,$e,gt,dt,nt=I+(C==0||C==3?-X:X);A==0?($e=I,dt=nt):(Le=I,gt=nt);for(let We=0;We<g.length;We++)M[We]!=null&&(A==0?Le=gt=g[We]:$e=dt=g[We],u.moveTo(Le,$e),u.lineTo(gt,dt));u.stroke(),x==1&&u.translate(-Ce,-Ce)}function Op(g){let M=!0;return T.forEach((A,C)=>{if(!A.show)return;let I=v[A.scale];if(I.min==null){A._show&&(M=!1,A._show=!1,zs(!1));return}else A._show||(M=!1,A._show=!0,zs(!1));let X=A.side,se=X%2,{min:le,max:de}=I,[Re,Ce]=Fp(C,le,de,se==0?j:V);if(Ce==0)return;let Le=I.distr==2,$e=A._splits=A.splits(i,C,le,de,Re,Ce,Le),gt=I.distr==2?$e.map(ze=>ue[ze]):$e,dt=I.distr==2?ue[$e[1]]-ue[$e[0]]:Re,nt=A._values=A.values(i,A.filter(i,gt,C,Ce,dt),C,Ce,dt);A._rotate=X==2?A.rotate(i,nt,C,Ce):0;let We=A._size;A._size=zn(A.size(i,nt,C,g)),We!=null&&A._size!=We&&(M=!1)}),M}function Bp(g){let M=!0;return _a.forEach((A,C)=>{let I=A(i,C,ii,g);I!=E[C]&&(M=!1),E[C]=I}),M}function kp(){for(let g=0;g<T.length;g++){let M=T[g];if(!M.show||!M._show)continue;let A=M.side,C=A%2,I,X,se=M.stroke(i,g),le=A==0||A==3?-1:1,[de,Re]=M._found;if(M.label!=null){let mn=M.labelGap*le,Rn=$t((M._lpos+mn)*_t);Mn(M.labelFont[0],se,"center",A==2?Gr:th),u.save(),C==1?(I=X=0,u.translate(Rn,$t(Ne+Ee/2)),u.rotate((A==3?-io:io)/2)):(I=$t(ve+Oe/2),X=Rn);let cs=gd(M.label)?M.label(i,g,de,Re):M.label;u.fillText(cs,I,X),u.restore()}if(Re==0)continue;let Ce=v[M.scale],Le=C==0?Oe:Ee,$e=C==0?ve:Ne,gt=M._splits,dt=Ce.distr==2?gt.map(mn=>ue[mn]):gt,nt=Ce.distr==2?ue[gt[1]]-ue[gt[0]]:de,We=M.ticks,ze=M.border,Dt=We.show?We.size:0,Bt=$t(Dt*_t),sn=$t((M.alignTo==2?M._size-Dt-M.gap:M.gap)*_t),St=M._rotate*-io/180,kt=m(M._pos*_t),bn=(Bt+sn)*le,pn=kt+bn;X=C==0?pn:0,I=C==1?pn:0;let Fn=M.font[0],Wn=M.align==1?Zs:M.align==2?Qo:St>0?Zs:St<0?Qo:C==0?"center":A==3?Qo:Zs,li=St||C==1?"middle":A==2?Gr:th;Mn(Fn,se,Wn,li);let An=M.font[1]*M.lineGap,On=gt.map(mn=>m(o(mn,Ce,Le,$e))),Xn=M._values;for(let mn=0;mn<Xn.length;mn++){let Rn=Xn[mn];if(Rn!=null){C==0?I=On[mn]:X=On[mn],Rn=""+Rn;let cs=Rn.indexOf(`
`)==-1?[Rn]:Rn.split(/\n/gm);for(let gn=0;gn<cs.length;gn++){let Bu=cs[gn];St?(u.save(),u.translate(I,X+gn*An),u.rotate(St),u.fillText(Bu,0,0),u.restore()):u.fillText(Bu,I,X+gn*An)}}}We.show&&ko(On,We.filter(i,dt,g,Re,nt),C,A,kt,Bt,At(We.width*_t,3),We.stroke(i,g),We.dash,We.cap);let ci=M.grid;ci.show&&ko(On,ci.filter(i,dt,g,Re,nt),C,C==0?2:1,C==0?Ne:ve,C==0?Ee:Oe,At(ci.width*_t,3),ci.stroke(i,g),ci.dash,ci.cap),ze.show&&ko([kt],[1],C==0?1:0,C==0?1:2,C==1?Ne:ve,C==1?Ee:Oe,At(ze.width*_t,3),ze.stroke(i,g),ze.dash,ze.cap)}nn("drawAxes")}function zs(g){w.forEach((M,A)=>{A>0&&(M._paths=null,g&&(s==1?(M.min=null,M.max=null):M.facets.forEach(C=>{C.min=null,C.max=null})))})}let Ma=!1,zo=!1,Br=[];function zp(){zo=!1;for(let g=0;g<Br.length;g++)nn(...Br[g]);Br.length=0}function Hs(){Ma||($g(Mu),Ma=!0)}function Hp(g,M=!1){Ma=!0,zo=M,g(i),Mu(),M&&Br.length>0&&queueMicrotask(zp)}i.batch=Hp;function Mu(){if(tt&&(as(),tt=!1),ut&&(Ke(),ut=!1),qe){if(Ut(p,Zs,ee),Ut(p,Gr,Se),Ut(p,Kr,j),Ut(p,jr,V),Ut(_,Zs,ee),Ut(_,Gr,Se),Ut(_,Kr,j),Ut(_,jr,V),Ut(f,Kr,S),Ut(f,jr,$),h.width=$t(S*_t),h.height=$t($*_t),T.forEach(({_el:g,_show:M,_size:A,_pos:C,side:I})=>{if(g!=null)if(M){let X=I===3||I===0?A:0,se=I%2==1;Ut(g,se?"left":"top",C-X),Ut(g,se?"width":"height",A),Ut(g,se?"top":"left",se?Se:ee),Ut(g,se?"height":"width",se?V:j),$l(g,Ms)}else Ln(g,Ms)}),Ge=Xe=Ue=vt=Mt=Qt=lt=Be=it=null,Nt=1,Hr(!0),ee!=_e||Se!=we||j!=Ye||V!=fe){zs(!1);let g=j/Ye,M=V/fe;if(oe&&!O&&pe.left>=0){pe.left*=g,pe.top*=M,Vs&&ui(Vs,$t(pe.left),0,j,V),Gs&&ui(Gs,0,$t(pe.top),j,V);for(let A=0;A<on.length;A++){let C=on[A];C!=null&&(vi[A]*=g,xi[A]*=M,ui(C,zn(vi[A]),zn(xi[A]),j,V))}}if(Lt.show&&!xe&&Lt.left>=0&&Lt.width>0){Lt.left*=g,Lt.width*=g,Lt.top*=M,Lt.height*=M;for(let A in qo)Ut(qs,A,Lt[A])}_e=ee,we=Se,Ye=j,fe=V}nn("setSize"),qe=!1}S>0&&$>0&&(u.clearRect(0,0,h.width,h.height),nn("drawClear"),F.forEach(g=>g()),nn("draw")),Lt.show&&xe&&(Sa(Lt),xe=!1),oe&&O&&(ls(null,!0,!1),O=!1),Me.show&&Me.live&&te&&(Wo(),te=!1),l||(l=!0,i.status=1,nn("ready")),ye=!1,Ma=!1}i.redraw=(g,M)=>{ut=M||!1,g!==!1?ki(L,P.min,P.max):Hs()};function Ho(g,M){let A=v[g];if(A.from==null){if(N==0){let C=A.range(i,M.min,M.max,g);M.min=C[0],M.max=C[1]}if(M.min>M.max){let C=M.min;M.min=M.max,M.max=C}if(N>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;g==L&&A.distr==2&&N>0&&(M.min=jn(M.min,e[0]),M.max=jn(M.max,e[0]),M.min==M.max&&M.max++),K[g]=M,tt=!0,Hs()}}i.setScale=Ho;let Vo,Go,Vs,Gs,Su,yu,Ws,Xs,Eu,Tu,Pt,Ft,Bi=!1;const an=pe.drag;let en=an.x,tn=an.y;oe&&(pe.x&&(Vo=kn(_g,_)),pe.y&&(Go=kn(vg,_)),P.ori==0?(Vs=Vo,Gs=Go):(Vs=Go,Gs=Vo),Pt=pe.left,Ft=pe.top);const Lt=i.select=Gt({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),qs=Lt.show?kn(gg,Lt.over?_:p):null;function Sa(g,M){if(Lt.show){for(let A in g)Lt[A]=g[A],A in qo&&Ut(qs,A,g[A]);M!==!1&&nn("setSelect")}}i.setSelect=Sa;function Vp(g){if(w[g].show)ie&&$l(Ie[g],Ms);else if(ie&&Ln(Ie[g],Ms),oe){let A=xn?on[0]:on[g];A!=null&&ui(A,-10,-10,j,V)}}function ki(g,M,A){Ho(g,{min:M,max:A})}function ai(g,M,A,C){M.focus!=null&&$p(g),M.show!=null&&w.forEach((I,X)=>{X>0&&(g==X||g==null)&&(I.show=M.show,Vp(X),s==2?(ki(I.facets[0].scale,null,null),ki(I.facets[1].scale,null,null)):ki(I.scale,null,null),Hs())}),A!==!1&&nn("setSeries",g,M),C&&Vr("setSeries",i,g,M)}i.setSeries=ai;function Gp(g,M){Gt(H[g],M)}function Wp(g,M){g.fill=st(g.fill||null),g.dir=pt(g.dir,-1),M=M??H.length,H.splice(M,0,g)}function Xp(g){g==null?H.length=0:H.splice(g,1)}i.addBand=Wp,i.setBand=Gp,i.delBand=Xp;function qp(g,M){w[g].alpha=M,oe&&on[g]!=null&&(on[g].style.opacity=M),ie&&Ie[g]&&(Ie[g].style.opacity=M)}let Mi,zi,os;const $s={focus:!0};function $p(g){if(g!=os){let M=g==null,A=wn.alpha!=1;w.forEach((C,I)=>{if(s==1||I>0){let X=M||I==0||I==g;C._focus=M?null:X,A&&qp(I,X?1:wn.alpha)}}),os=g,A&&Hs()}}ie&&_i&&Pe(rh,ae,g=>{pe._lock||(qt(g),os!=null&&ai(null,$s,!0,Ht.setSeries))});function oi(g,M,A){let C=v[M];A&&(g=g/_t-(C.ori==1?Se:ee));let I=j;C.ori==1&&(I=V,g=I-g),C.dir==-1&&(g=I-g);let X=C._min,se=C._max,le=g/I,de=X+(se-X)*le,Re=C.distr;return Re==3?yr(10,de):Re==4?Ng(de,C.asinh):Re==100?C.bwd(de):de}function Yp(g,M){let A=oi(g,L,M);return jn(A,e[0],G,W)}i.valToIdx=g=>jn(g,e[0]),i.posToIdx=Yp,i.posToVal=oi,i.valToPos=(g,M,A)=>v[M].ori==0?r(g,v[M],A?Oe:j,A?ve:0):a(g,v[M],A?Ee:V,A?Ne:0),i.setCursor=(g,M,A)=>{Pt=g.left,Ft=g.top,ls(null,M,A)};function wu(g,M){Ut(qs,Zs,Lt.left=g),Ut(qs,Kr,Lt.width=M)}function bu(g,M){Ut(qs,Gr,Lt.top=g),Ut(qs,jr,Lt.height=M)}let kr=P.ori==0?wu:bu,zr=P.ori==1?wu:bu;function Zp(){if(ie&&Me.live)for(let g=s==2?1:0;g<w.length;g++){if(g==0&&ot)continue;let M=Me.values[g],A=0;for(let C in M)at[g][A++].firstChild.nodeValue=M[C]}}function Wo(g,M){if(g!=null&&(g.idxs?g.idxs.forEach((A,C)=>{me[C]=A}):kg(g.idx)||me.fill(g.idx),Me.idx=me[0]),ie&&Me.live){for(let A=0;A<w.length;A++)(A>0||s==1&&!ot)&&Kp(A,me[A]);Zp()}te=!1,M!==!1&&nn("setLegend")}i.setLegend=Wo;function Kp(g,M){let A=w[g],C=g==0&&Y==2?ue:e[g],I;ot?I=A.values(i,g,M)??k:(I=A.value(i,M==null?null:C[M],g,M),I=I==null?k:{_:I}),Me.values[g]=I}function ls(g,M,A){Eu=Pt,Tu=Ft,[Pt,Ft]=pe.move(i,Pt,Ft),pe.left=Pt,pe.top=Ft,oe&&(Vs&&ui(Vs,$t(Pt),0,j,V),Gs&&ui(Gs,0,$t(Ft),j,V));let C,I=G>W;Mi=bt,zi=null;let X=P.ori==0?j:V,se=P.ori==1?j:V;if(Pt<0||N==0||I){C=pe.idx=null;for(let le=0;le<w.length;le++){let de=on[le];de!=null&&ui(de,-10,-10,j,V)}_i&&ai(null,$s,!0,g==null&&Ht.setSeries),Me.live&&(me.fill(C),te=!0)}else{let le,de,Re;s==1&&(le=P.ori==0?Pt:Ft,de=oi(le,L),C=pe.idx=jn(de,e[0],G,W),Re=B(e[0][C],P,X,0));let Ce=-10,Le=-10,$e=0,gt=0,dt=!0,nt="",We="";for(let ze=s==2?1:0;ze<w.length;ze++){let Dt=w[ze],Bt=me[ze],sn=Bt==null?null:s==1?e[ze][Bt]:e[ze][1][Bt],St=pe.dataIdx(i,ze,C,de),kt=St==null?null:s==1?e[ze][St]:e[ze][1][St];if(te=te||kt!=sn||St!=Bt,me[ze]=St,ze>0&&Dt.show){let bn=St==null?-10:St==C?Re:B(s==1?e[0][St]:e[ze][0][St],P,X,0),pn=kt==null?-10:q(kt,s==1?v[Dt.scale]:v[Dt.facets[1].scale],se,0);if(_i&&kt!=null){let Fn=P.ori==1?Pt:Ft,Wn=Yt(wn.dist(i,ze,St,pn,Fn));if(Wn<Mi){let li=wn.bias;if(li!=0){let An=oi(Fn,Dt.scale),On=kt>=0?1:-1,Xn=An>=0?1:-1;Xn==On&&(Xn==1?li==1?kt>=An:kt<=An:li==1?kt<=An:kt>=An)&&(Mi=Wn,zi=ze)}else Mi=Wn,zi=ze}}if(te||xn){let Fn,Wn;P.ori==0?(Fn=bn,Wn=pn):(Fn=pn,Wn=bn);let li,An,On,Xn,ci,mn,Rn=!0,cs=Rt.bbox;if(cs!=null){Rn=!1;let gn=cs(i,ze);On=gn.left,Xn=gn.top,li=gn.width,An=gn.height}else On=Fn,Xn=Wn,li=An=Rt.size(i,ze);if(mn=Rt.fill(i,ze),ci=Rt.stroke(i,ze),xn)ze==zi&&Mi<=wn.prox&&(Ce=On,Le=Xn,$e=li,gt=An,dt=Rn,nt=mn,We=ci);else{let gn=on[ze];gn!=null&&(vi[ze]=On,xi[ze]=Xn,fh(gn,li,An,Rn),uh(gn,mn,ci),ui(gn,zn(On),zn(Xn),j,V))}}}}if(xn){let ze=wn.prox,Dt=os==null?Mi<=ze:Mi>ze||zi!=os;if(te||Dt){let Bt=on[0];Bt!=null&&(vi[0]=Ce,xi[0]=Le,fh(Bt,$e,gt,dt),uh(Bt,nt,We),ui(Bt,zn(Ce),zn(Le),j,V))}}}if(Lt.show&&Bi)if(g!=null){let[le,de]=Ht.scales,[Re,Ce]=Ht.match,[Le,$e]=g.cursor.sync.scales,gt=g.cursor.drag;if(en=gt._x,tn=gt._y,en||tn){let{left:dt,top:nt,width:We,height:ze}=g.select,Dt=g.scales[Le].ori,Bt=g.posToVal,sn,St,kt,bn,pn,Fn=le!=null&&Re(le,Le),Wn=de!=null&&Ce(de,$e);Fn&&en?(Dt==0?(sn=dt,St=We):(sn=nt,St=ze),kt=v[le],bn=B(Bt(sn,Le),kt,X,0),pn=B(Bt(sn+St,Le),kt,X,0),kr(Qn(bn,pn),Yt(pn-bn))):kr(0,X),Wn&&tn?(Dt==1?(sn=dt,St=We):(sn=nt,St=ze),kt=v[de],bn=q(Bt(sn,$e),kt,se,0),pn=q(Bt(sn+St,$e),kt,se,0),zr(Qn(bn,pn),Yt(pn-bn))):zr(0,se)}else $o()}else{let le=Yt(Eu-Su),de=Yt(Tu-yu);if(P.ori==1){let $e=le;le=de,de=$e}en=an.x&&le>=an.dist,tn=an.y&&de>=an.dist;let Re=an.uni;Re!=null?en&&tn&&(en=le>=Re,tn=de>=Re,!en&&!tn&&(de>le?tn=!0:en=!0)):an.x&&an.y&&(en||tn)&&(en=tn=!0);let Ce,Le;en&&(P.ori==0?(Ce=Ws,Le=Pt):(Ce=Xs,Le=Ft),kr(Qn(Ce,Le),Yt(Le-Ce)),tn||zr(0,se)),tn&&(P.ori==1?(Ce=Ws,Le=Pt):(Ce=Xs,Le=Ft),zr(Qn(Ce,Le),Yt(Le-Ce)),en||kr(0,X)),!en&&!tn&&(kr(0,0),zr(0,0))}if(an._x=en,an._y=tn,g==null){if(A){if(Ou!=null){let[le,de]=Ht.scales;Ht.values[0]=le!=null?oi(P.ori==0?Pt:Ft,le):null,Ht.values[1]=de!=null?oi(P.ori==1?Pt:Ft,de):null}Vr(el,i,Pt,Ft,j,V,C)}if(_i){let le=A&&Ht.setSeries,de=wn.prox;os==null?Mi<=de&&ai(zi,$s,!0,le):Mi>de?ai(null,$s,!0,le):zi!=os&&ai(zi,$s,!0,le)}}te&&(Me.idx=C,Wo()),M!==!1&&nn("setCursor")}let Hi=null;Object.defineProperty(i,"rect",{get(){return Hi==null&&Hr(!1),Hi}});function Hr(g=!1){g?Hi=null:(Hi=_.getBoundingClientRect(),nn("syncRect",Hi))}function Au(g,M,A,C,I,X,se){pe._lock||Bi&&g!=null&&g.movementX==0&&g.movementY==0||(Xo(g,M,A,C,I,X,se,!1,g!=null),g!=null?ls(null,!0,!0):ls(M,!0,!1))}function Xo(g,M,A,C,I,X,se,le,de){if(Hi==null&&Hr(!1),qt(g),g!=null)A=g.clientX-Hi.left,C=g.clientY-Hi.top;else{if(A<0||C<0){Pt=-10,Ft=-10;return}let[Re,Ce]=Ht.scales,Le=M.cursor.sync,[$e,gt]=Le.values,[dt,nt]=Le.scales,[We,ze]=Ht.match,Dt=M.axes[0].side%2==1,Bt=P.ori==0?j:V,sn=P.ori==1?j:V,St=Dt?X:I,kt=Dt?I:X,bn=Dt?C:A,pn=Dt?A:C;if(dt!=null?A=We(Re,dt)?o($e,v[Re],Bt,0):-10:A=Bt*(bn/St),nt!=null?C=ze(Ce,nt)?o(gt,v[Ce],sn,0):-10:C=sn*(pn/kt),P.ori==1){let Fn=A;A=C,C=Fn}}de&&(M==null||M.cursor.event.type==el)&&((A<=1||A>=j-1)&&(A=gs(A,j)),(C<=1||C>=V-1)&&(C=gs(C,V))),le?(Su=A,yu=C,[Ws,Xs]=pe.move(i,A,C)):(Pt=A,Ft=C)}const qo={width:0,height:0,left:0,top:0};function $o(){Sa(qo,!1)}let Ru,Cu,Pu,Lu;function Du(g,M,A,C,I,X,se){Bi=!0,en=tn=an._x=an._y=!1,Xo(g,M,A,C,I,X,se,!0,!1),g!=null&&(Pe(tl,Xl,Uu,!1),Vr(ih,i,Ws,Xs,j,V,null));let{left:le,top:de,width:Re,height:Ce}=Lt;Ru=le,Cu=de,Pu=Re,Lu=Ce}function Uu(g,M,A,C,I,X,se){Bi=an._x=an._y=!1,Xo(g,M,A,C,I,X,se,!1,!0);let{left:le,top:de,width:Re,height:Ce}=Lt,Le=Re>0||Ce>0,$e=Ru!=le||Cu!=de||Pu!=Re||Lu!=Ce;if(Le&&$e&&Sa(Lt),an.setScale&&Le&&$e){let gt=le,dt=Re,nt=de,We=Ce;if(P.ori==1&&(gt=de,dt=Ce,nt=le,We=Re),en&&ki(L,oi(gt,L),oi(gt+dt,L)),tn)for(let ze in v){let Dt=v[ze];ze!=L&&Dt.from==null&&Dt.min!=bt&&ki(ze,oi(nt+We,ze),oi(nt,ze))}$o()}else pe.lock&&(pe._lock=!pe._lock,ls(M,!0,g!=null));g!=null&&(R(tl,Xl),Vr(tl,i,Pt,Ft,j,V,null))}function jp(g,M,A,C,I,X,se){if(pe._lock)return;qt(g);let le=Bi;if(Bi){let de=!0,Re=!0,Ce=10,Le,$e;P.ori==0?(Le=en,$e=tn):(Le=tn,$e=en),Le&&$e&&(de=Pt<=Ce||Pt>=j-Ce,Re=Ft<=Ce||Ft>=V-Ce),Le&&de&&(Pt=Pt<Ws?0:j),$e&&Re&&(Ft=Ft<Xs?0:V),ls(null,!0,!0),Bi=!1}Pt=-10,Ft=-10,me.fill(null),ls(null,!0,!0),le&&(Bi=le)}function Iu(g,M,A,C,I,X,se){pe._lock||(qt(g),De(),$o(),g!=null&&Vr(ah,i,Pt,Ft,j,V,null))}function Nu(){T.forEach(t0),re(i.width,i.height,!0)}bs(_o,mr,Nu);const Ys={};Ys.mousedown=Du,Ys.mousemove=Au,Ys.mouseup=Uu,Ys.dblclick=Iu,Ys.setSeries=(g,M,A,C)=>{let I=Ht.match[2];A=I(i,M,A),A!=-1&&ai(A,C,!0,!1)},oe&&(Pe(ih,_,Du),Pe(el,_,Au),Pe(sh,_,g=>{qt(g),Hr(!1)}),Pe(rh,_,jp),Pe(ah,_,Iu),Ql.add(i),i.syncRect=Hr);const ya=i.hooks=n.hooks||{};function nn(g,M,A){zo?Br.push([g,M,A]):g in ya&&ya[g].forEach(C=>{C.call(null,i,M,A)})}(n.plugins||[]).forEach(g=>{for(let M in g.hooks)ya[M]=(ya[M]||[]).concat(g.hooks[M])});const Fu=(g,M,A)=>A,Ht=Gt({key:null,setSeries:!1,filters:{pub:_h,sub:_h},scales:[L,w[1]?w[1].scale:null],match:[vh,vh,Fu],values:[null,null]},pe.sync);Ht.match.length==2&&Ht.match.push(Fu),pe.sync=Ht;const Ou=Ht.key,Yo=zd(Ou);function Vr(g,M,A,C,I,X,se){Ht.filters.pub(g,M,A,C,I,X,se)&&Yo.pub(g,M,A,C,I,X,se)}Yo.sub(i);function Jp(g,M,A,C,I,X,se){Ht.filters.sub(g,M,A,C,I,X,se)&&Ys[g](null,M,A,C,I,X,se)}i.pub=Jp;function Qp(){Yo.unsub(i),Ql.delete(i),ct.clear(),Yl(_o,mr,Nu),c.remove(),ae?.remove(),nn("destroy")}i.destroy=Qp;function Zo(){nn("init",n,e),Fe(e||n.data,!1),K[L]?Ho(L,K[L]):De(),xe=Lt.show&&(Lt.width>0||Lt.height>0),O=te=!0,re(n.width,n.height)}return w.forEach(Or),T.forEach(Bo),t?t instanceof HTMLElement?(t.appendChild(c),Zo()):t(i,Zo):Zo(),i}fn.assign=Gt;fn.fmtNum=eu;fn.rangeNum=vo;fn.rangeLog=To;fn.rangeAsinh=Jc;fn.orient=Fs;fn.pxRatio=_t;fn.join=qg;fn.fmtDate=nu,fn.tzDate=i_;fn.sync=zd;{fn.addGap=k_,fn.clipGaps=Ao;let n=fn.paths={points:qd};n.linear=Yd,n.stepped=V_,n.bars=G_,n.spline=X_}const n0=308,zh=84,i0=34,s0="time";function Jd(n,e,t,i){const s=n.tracks.filter(u=>u!==e),r=s.find(({key:u})=>u==="network")??s.find(({key:u})=>u==="simple"),a=n.setpoints_kpa[0]?.length??0,o=(u,f)=>u.map(p=>p[f]),l=u=>u.map(f=>f===null?null:100*f),c=(u,f)=>({name:Sr[u.key],swatch:u.key,values:f}),h=Array.from({length:a},(u,f)=>({title:`Pressure of segment ${f}`,unit:i,series:[{name:"set",swatch:"set",values:o(n.setpoints_kpa,f)},...r?[c(r,o(r.pressures_kpa,f))]:[],c(e,o(e.pressures_kpa,f))]}));return h.push({title:`Tip from the ${Sr[e.key].replace(/^The /,"").toLowerCase()}’s`,unit:"cm",series:s.map(u=>c(u,l(e.shapes.slice(0,u.shapes.length).map((f,p)=>Ls(gi(f),gi(u.shapes[p]))))))},{title:Array.isArray(t)?"Tip from the path":"Tip from the goal’s centre",unit:"cm",series:n.tracks.map(u=>c(u,l(u.shapes.map((f,p)=>Ls(gi(f),Array.isArray(t)?t[Math.min(p,t.length-1)]:[t.x_m,t.y_m])))))}),n.tracks.some(({clearances_m:u})=>u.length>0)&&h.push({title:"Clearance",unit:"cm",series:n.tracks.map(u=>c(u,l(u.clearances_m)))}),h.filter(u=>u.series.length>0)}const al=n=>()=>getComputedStyle(document.documentElement).getPropertyValue(n==="set"?"--quiet":`--${n}`);class Qd{constructor(e){this.seek=e,matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.charts.forEach(({plot:t})=>t.redraw(!1))),new ResizeObserver(()=>{const t=this.element.clientWidth;t>0&&this.charts.forEach(({plot:i})=>i.setSize({width:t,height:zh}))}).observe(this.element)}element=U("div",{class:"plots"});charts=[];time_s=0;show(e,t,i){this.charts.forEach(({plot:s})=>s.destroy()),this.charts=[],this.element.replaceChildren(...e.map(s=>this.chart({...s,series:s.series.filter(({swatch:r})=>r==="set"||i.has(r))},t)))}at(e){this.time_s=e;for(const{plot:t,show:i}of this.charts.filter(({plot:{status:s}})=>s===1))t.setCursor({left:t.valToPos(e,"x"),top:0},!1),i()}chart({title:e,unit:t,series:i},s){const r=Math.max(2,...i.map(({values:p})=>p.length)),a=Array.from({length:r},(p,_)=>_/s),o=i.map(({values:p})=>[...p,...Array(r-p.length).fill(null)]),l=i.map(()=>U("b")),c=U("div",{role:"img","aria-label":`${e} in ${t}, over ${a[r-1].toFixed(1)} s`}),h={show:!0,stroke:al("grid"),width:1},u=new fn({width:this.element.clientWidth||n0,height:zh,padding:[6,2,6,0],legend:{show:!1},cursor:{y:!1,drag:{x:!0,y:!1},sync:{key:s0},points:{size:5}},scales:{x:{time:!1},y:{range:(p,_,x)=>[Math.min(0,_),Math.max(Math.min(0,_)+(t==="cm"?.1:1),x)]}},axes:[{show:!1},{size:i0,gap:3,space:22,font:"10px system-ui, sans-serif",stroke:al("quiet"),grid:h,ticks:{show:!1}}],series:[{},...i.map(({swatch:p})=>({stroke:al(p),width:1.6,points:{show:!1},...p==="set"?{dash:[3,2]}:{}}))],hooks:{ready:[()=>this.at(this.time_s)],setCursor:[()=>f()]}},[a,...o],c),f=()=>i.forEach(({values:p},_)=>{const x=Math.min(p.length-1,u.cursor.idx??Math.round(this.time_s*s));l[_].textContent=p[x]==null?"–":p[x].toFixed(t==="cm"?2:1)});return u.over.addEventListener("click",p=>this.seek(Math.max(0,u.posToVal(p.offsetX,"x")))),u.over.addEventListener("mouseleave",()=>this.at(this.time_s)),this.charts.push({plot:u,show:f}),U("figure",{},U("figcaption",{},`${e}, ${t}`,U("span",{},...i.map(({swatch:p,name:_},x)=>U("span",{},U("i",{class:`swatch ${p}`}),`${_} `,l[x])))),c)}}const r0=["5","10","20","30","60"],a0=.002;class o0{constructor(e){this.app=e}drawn=[];path=[];seconds=20;run=null;request=0;outcome=U("div");plots=new Qd(e=>this.player.seek(e));player=new hd(()=>this.run?Gl(this.run):0,e=>{this.run&&this.plots.at(e),this.app.stage.draw()});enter(e){const t=s=>{this.path=s,this.ask()},i=s=>()=>{const r=this.app.arm.length_m;t(sg(s,[.55*r,.5*r],.1*r))};e.append(U("section",{},U("h2",{},"A path for the tip"),U("p",{class:"hint"},"Draw it on the picture. The virtual arm follows it, closed loop."),U("div",{class:"row"},rt("Circle",i("circle")),rt("Eight",i("eight")),rt("Backwards",()=>t([...this.path].reverse())),rt("CSV",()=>no("path.csv",new Blob([ag(this.timed())],{type:"text/csv"})),{title:"Save the path for limber execute --track"})),U("div",{class:"fields"},Kn("Takes",fr(r0,String(this.seconds),s=>{this.seconds=Number(s),this.ask()}),"s"))),U("section",{},U("h2",{},"Time"),this.player.element),U("section",{},this.outcome),U("section",{},U("h2",{},"Over time"),this.plots.element),U("section",{},U("h2",{},"Save the picture"),yo(this.app))),this.ask()}leave(){this.player.seek(0),this.run=null,++this.request,this.app.endWork()}down(e){return this.drawn=[e],!0}drag(e){const t=this.drawn[this.drawn.length-1];Math.hypot(e[0]-t[0],e[1]-t[1])<a0||(this.drawn.push(e),this.app.stage.draw())}up(e){const{drawn:t,isStroke:i}=this;this.drawn=[],this.app.stage.draw(),!(!i||e)&&(this.path=ig(t),this.ask())}get isStroke(){return this.drawn.length>2}timed(){return this.path.length>1?rg(this.path,this.seconds):[]}say(e,t=!1){this.outcome.replaceChildren(U("p",{class:t?"warning":"hint","aria-live":"polite"},e))}ask(){if(this.run=null,this.player.seek(0),this.plots.show([],1,new Set),this.path.length<2)return this.say("There is no path yet.");this.say("The arm follows …");const{tab:e,armName:t,model:i,environment:s}=this.app,r=++this.request;this.app.attempt(()=>hn("follow",{tab:e,request:r,arm:t,model:i,environment:s,path:this.timed()}).catch(a=>this.onFault(r,a.message)))}onFollowed(e){e.request===this.request&&(this.run=e,this.say(mo(e).outcome),this.plots.show(Jd(e,mo(e),e.wanted_m,this.app.unit),e.frame_rate_hz,this.shown),this.player.seek(0),this.player.toggle())}onFault(e,t){e===this.request&&this.say(t,!0)}get shown(){return new Set(this.run?.tracks.map(({key:e})=>e))}refresh(){}scene(){const{run:e,app:t}=this,i=this.isStroke?this.drawn:this.path,s={shape:t.arm.rest,colour:"virtual_arm"};return{path:i,hidesGoal:!0,figures:e?Wl(e,this.shown,this.player.time_s):[s]}}legend(){return[["goal","The path wanted"],["virtual_arm","Virtual arm"],["pressure","Pressurised side"]]}}class l0{constructor(e){this.value=e}past=[];future=[];before;get now(){return this.value}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}set(e){this.begin(),this.change(e),this.end()}begin(){this.before??=this.value}change(e){this.value=e}end(){this.before!==void 0&&this.before!==this.value&&(this.past.push(this.before),this.future=[]),this.before=void 0}undo(){this.end(),this.step(this.past,this.future)}redo(){this.end(),this.step(this.future,this.past)}step(e,t){const i=e.pop();i!==void 0&&(t.push(this.value),this.value=i)}reset(e){this.value=e,this.past=[],this.future=[],this.before=void 0}}const c0=.002,u0=.01,Hh=.05,Vh=40,tc={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function h0(n,e,t,i){if(e===null)return null;if(t==="["||t==="]")return fm(n,e,t==="["?Hh:-Hh);const s=i?u0:c0,r=tc[t];if(r===void 0)return null;const a={of:e,part:"body"},o=e==="goal"?[n.goal.x_m,n.goal.y_m]:Ui(n.obstacles[e]);return td(n,a,o,[o[0]+s*r[0],o[1]+s*r[1]])}function f0(n,e){if(e in tc){const[t,i]=tc[e];return()=>n.pan(-Vh*t,Vh*i)}return{"+":()=>n.zoom(1.25),"-":()=>n.zoom(.8),0:()=>n.refit()}[e]??null}function d0(n,e){const t=e.ctrlKey||e.metaKey,i=e.key.toLowerCase();if(t&&(i==="z"||i==="y")&&(e.preventDefault(),i==="y"||e.shiftKey?n.redo():n.undo()),t||e.target!==Ct("canvas"))return!1;const s={Escape:()=>n.select(null),Delete:()=>n.removeSelected(),Backspace:()=>n.removeSelected()},r=h0(n.environment,n.selected,e.key,e.shiftKey);return r?n.edit(r):s[e.key]?.(),r!==null||e.key in s}function p0(n,e,t){if(e.target instanceof HTMLInputElement||e.target instanceof HTMLSelectElement)return;const i=t&&d0(n,e);if(e.target!==Ct("canvas")||e.ctrlKey||e.metaKey)return;const s=i?null:f0(n.stage,e.key);(i||s)&&e.preventDefault(),s?.()}function m0(n,e,t){const i={ArrowLeft:e-1,ArrowRight:e+1,Home:0,End:n-1}[t];return i===void 0?void 0:(i+n)%n}class g0{constructor(e){this.planner=e}measured=null;measure(){const{plan:e,isCurrent:t,askedAt_ms:i}=this.planner;!e||!t||this.measured?.request===e.request||(this.measured=e,requestAnimationFrame(s=>{performance.clearMeasures(),performance.measure("certified plan painted",{start:i,end:Math.max(i,s),detail:e.request})}))}}class _0{constructor(e){this.app=e}follows=()=>{};ask(e,t){const{app:i}=this,s=i.planner.expect();this.follows=t,i.attempt(()=>hn("plan/open",{tab:i.tab,request:s,arm:i.armName,model:i.model,plan:e}).catch(r=>{const a=r instanceof mi&&r.status!==0;throw i.planner.refuse(s,!a),r}))}async onOpened({request:e,arm:t,model:i,environment:s,plan:r}){const{app:a,follows:o}=this,l=()=>a.planner.isAwaited(e);if(l()){try{if(!await a.open(t,s,null,l))return}catch(c){throw a.planner.refuse(e,!0),c}a.choose(i),a.planner.take(r),a.isInFile=a.project.environments.includes(s),a.link(a.isInFile?null:a.environment),o()}}}class v0{constructor(e){this.app=e}things=U("div");selection=U("div");status=U("div",{id:"status"});drawn=null;request=0;fitting="";tube=U("label");buttons=null;grip=null;nameOf=null;name=U("input",{type:"text",id:"name","aria-label":"Name to save as"});enter(e){const{app:t}=this,{project:i}=t;this.drawn=null;const s=rt("↶",()=>t.undo(),{title:"Undo (Ctrl+Z)","aria-label":"Undo"}),r=rt("↷",()=>t.redo(),{title:"Redo (Ctrl+Y)","aria-label":"Redo"}),a=rt("Stop",()=>void t.attempt(()=>t.planner.stop())),o=rt("Save plan",()=>void t.attempt(()=>this.savePlan()));this.buttons={undo:s,redo:r,stop:a,savePlan:o},Ct("tools").replaceChildren(ws("●","Add a circle",()=>t.add("circle")),ws("■","Add a rectangle",()=>t.add("rectangle")),ws("▲","Add a polygon",()=>t.add("polygon")),U("i"),s,r,U("i"));const l=p=>void t.attempt(async()=>{let _=!1;try{_=await p()}finally{_?t.reopened():this.show()}}),c=(p,_)=>Mr(p,t.view[_],x=>{t.view[_]=x,_==="tree"&&x&&t.planner.tree===null?t.ask():t.refresh()});this.tube=c("Tube","tube");const h=U("select",{"aria-label":"Seconds to search for"},...[1,5,20].map(p=>U("option",{value:p,selected:p===t.timeLimit_s},`${p} s`)));h.addEventListener("change",()=>t.timeLimit_s=Number(h.value));const u=cd("Share of the pressure limits to plan with",t.limitScale,p=>{t.limitScale=p,t.ask()});this.nameOf!==t.saved&&(this.name.value=t.environment.name),this.nameOf=t.saved;const{margin_m:f}=t;e.append(U("section",{},this.status,f===null?"":U("p",{class:"warning"},`Plans keep ${ra(f)} from obstacles, less than the model’s error asks for. `,rt("Keep all of it",()=>this.keep(null))),U("div",{class:"row"},rt("Plan",()=>t.ask(!0),{class:"main"}),a,o),U("div",{class:"checks"},Mr("Plan while dragging",t.live,p=>t.live=p),c("Search tree","tree"),this.tube,c("Reach","reach")),U("div",{class:"row"},Kn("Search for",h),Kn("Pressures",u))),U("section",{},U("h2",{},"Scene"),Kn("Arm",fr(i.arms,t.armName,p=>l(async()=>t.mayLose("Open another arm?")?await t.open(p,t.environmentName)&&t.choose(t.modelBefore()):!1))),Kn("Model",fr(i.models,t.model,p=>l(async()=>t.choose(p)),"Simple model",p=>i.families.includes(p)?" (family)":"")),Kn("Environment",fr(i.environments,t.environmentName,p=>l(async()=>t.mayLose("Open another environment?")&&t.open(t.armName,p)))),i.plans.length>0&&Kn("Saved plan",fr(i.plans,"",p=>this.openPlan(p),"Open …")),Kn("Name",this.name),U("div",{class:"row"},rt("Save environment",()=>void t.attempt(async()=>this.said(await this.saveEnvironment()))),rt("Copy link",()=>void t.attempt(()=>this.copyLink()),{title:"A link that restores the scene"}))),U("section",{},U("h2",{},"Goal and obstacles"),this.things,this.selection),U("section",{},U("h2",{},"Save the picture"),yo(t)))}leave(){const{app:e}=this;Ct("tools").replaceChildren(),Qi(Ct("said"),""),this.grip=null,e.history.end(),(e.planner.searching||this.fitting)&&e.endWork(),e.planner.giveUp(),e.planner.end(),this.endFitting()}endFitting(){this.fitting="",++this.request}openPlan(e){const{app:t}=this;t.mayLose("Open the plan?")&&(this.endFitting(),t.opening.ask(e,()=>{t.enter("plan"),t.say(`Opened ${e}: its certificate was checked again, and holds`)})),this.show()}keep(e){this.app.margin_m=e,this.app.show(),this.app.ask()}show(){this.name.isConnected&&this.app.show()}down(e,t){const{app:i}=this,s=lm(i.environment,i.selected,e,t);return i.select(s?s.of:null),s?(this.grip={handle:s,from:e,begin:i.environment},i.history.begin(),!0):!1}drag(e,t){this.grip&&(this.app.history.change(td(this.grip.begin,this.grip.handle,this.grip.from,e)),this.app.edited(t))}up(){this.grip=null,this.app.history.end(),this.app.refresh(),this.app.planner.hurry()}refresh(){const{app:e,buttons:t}=this;t&&(t.undo.disabled=!e.history.canUndo,t.redo.disabled=!e.history.canRedo,t.stop.disabled=!e.planner.searching,t.savePlan.disabled=!e.planner.plan||!e.planner.isCurrent,this.showTube(e.planner.plan),to(this.status,e.isFamily?Hm(this.fitting,()=>void this.fit()):Wm(e.planner,e.unit,e.model==="",i=>this.keep(i))),Qi(Ct("said"),this.status.querySelector("strong")?.firstChild?.textContent??""),!(this.drawn?.[0]===e.environment&&this.drawn[1]===e.selected)&&(e.stage.isHeld||(this.drawn=[e.environment,e.selected],to(this.things,zm(e.environment,e.selected,i=>e.select(i))),to(this.selection,Bm(e.environment,e.selected,i=>e.edit(i),()=>e.removeSelected())))))}showTube(e){const t=e!==null&&e.tube===null,i=this.tube.querySelector("input");i===null||i.disabled===t||(i.disabled=t,this.tube.lastChild.textContent=t?"Tube: none in this plan; limber calibrate gives one":"Tube")}scene(){const{app:e}=this,{plan:t,isCurrent:i}=e.planner,{backbone:s}=e.environment.start,r=s?.flat();return{selected:e.selected,plan:t,stale:!i,showTree:e.view.tree?e.planner.tree:null,showTube:e.view.tube,figures:[{shape:r?.length===e.arm.rest.length?r:e.arm.rest,colour:"plate"},...t&&i?[{shape:t.shapes[t.shapes.length-1],colour:"plan",outlined:!0}]:[]]}}legend(){return[["plan","Plan"],["goal","Goal"],["reach","Reached by the simple model, at rest"]]}named(){return{...this.app.environment,name:this.name.value}}async copyLink(){const{app:e}=this,t=e.link(this.named()),i=await navigator.clipboard?.writeText(t).then(()=>!0,()=>!1);e.say(i?"Copied: a link that restores the scene":"The page’s address now restores the scene: copy it from there")}async fit(){const{app:e}=this;this.onFitting({request:++this.request,step:"Asked for …"}),await e.attempt(async()=>{try{await hn("fit",{tab:e.tab,request:this.request,arm:e.armName,model:e.model})}catch(t){throw this.onFitting({request:this.request,step:""}),t}})}onFitting({request:e,step:t}){e===this.request&&(this.fitting=t,this.app.refresh())}onFault(e,t){const{app:i}=this;if(!i.isFamily)return i.planner.onFault(e,t);this.onFitting({request:e,step:""}),i.say(t)}async onFitted({request:e,model:t,error_cm:i}){if(e!==this.request)return;const{app:s}=this;this.fitting="",await s.readProject(),s.choose(t),s.reopened(),s.say(`Fitted: ${t}`+(i===null?"":`, ${i.toFixed(1)} cm off on seconds that it had not seen`))}async savePlan(){const{app:e}=this,t=this.name.value,{number:i}=e.planner,s=e.isChanged||!e.isInFile?await this.saveEnvironment():"";if(s===null)return;const r=await this.save("plan/save",{plan:i},t);r!==null&&this.list("plans",r),this.said(r,s)}async saveEnvironment(){const{app:e}=this,t=e.environment,i=this.named(),s=await this.save("environment",{arm:e.armName,environment:i});return s===null?null:(e.environment===t&&(e.history.change(i),this.nameOf=e.saved=i,e.isInFile=!0,e.environmentName=s,e.link()),this.list("environments",s),s)}list(e,t){const{app:i}=this;i.project={...i.project,[e]:[...new Set([...i.project[e],t])]},this.show()}said(e,t=""){e!==null&&this.app.say(`Saved ${t&&`${t} and `}${e}`)}async save(e,t,i=this.name.value){const{app:s}=this,r=async a=>(await hn(e,{...t,tab:s.tab,name:i.trim(),overwrite:a})).name;try{return await r(!1)}catch(a){if(!(a instanceof mi)||a.status!==412)throw a;return s.confirms(`${a.message}. Replace it?`)?r(!0):null}}}const x0=80;class M0{constructor(e,t){this.tab=e,this.changed=t}plan=null;progress=null;result=null;tree=null;fault="";searching=!1;request=0;awaited=0;opens=2**32;sending=!1;seed=1;scene=null;next=null;asked_ms=0;heard=()=>{};get isCurrent(){return this.plan!==null&&this.plan.request===this.request&&this.awaited===0}get number(){return this.plan?.opened??this.plan?.request}get askedAt_ms(){return this.asked_ms}ask(e,t,i=!1){e.environment!==this.scene?this.seed=1:i&&++this.seed,this.scene=e.environment,this.next={question:{...e,seed:this.seed},asked_ms:t},this.tab()===""&&++this.request,this.begin(),this.send()}begin(){this.searching=!0,this.awaited=0,this.progress=this.result=this.tree=null,this.fault=""}hurry(){this.next!==null&&this.heard()}end(){this.next!==null&&++this.request,this.next=null,this.searching=!1,this.heard()}forget(){this.end(),++this.request,this.awaited=0,this.plan=this.progress=this.result=this.tree=null,this.fault=""}expect(){return this.giveUp(),this.end(),this.awaited=++this.opens,this.awaited}isAwaited(e){return e!==0&&e===this.awaited}giveUp(){this.awaited!==0&&this.forget()}refuse(e,t=!1){return this.isAwaited(e)?(t&&this.giveUp(),this.awaited=0,this.changed(),!0):!1}async stop(){this.end(),this.changed(),await hn("stop",{tab:this.tab()})}take(e){this.awaited=0,this.onPlan({...e,opened:e.request,request:++this.request})}onPlan(e){e.request===this.request&&(this.plan=e,this.heard(),this.changed())}onProgress(e){e.request===this.request&&(this.progress=e,this.changed(!1))}onTree({request:e,tree:t}){e===this.request&&(this.tree=t,this.changed())}onResult(e){e.request===this.request&&(this.result=e,this.tree=e.tree,this.searching=!1,this.heard(),e.status!=="solved"&&(this.plan=null),this.changed())}onFault(e,t){e===this.request&&(this.fault=t,this.plan=null,this.searching=!1,this.heard(),this.changed())}async send(){if(this.sending||this.next===null||this.tab()==="")return;const{question:e,asked_ms:t}=this.next;this.next=null;const i=this.result!==null||this.fault!=="";this.begin(),i&&this.changed(),this.sending=!0,this.asked_ms=t;const s=++this.request,r=new Promise(a=>{this.heard=a,setTimeout(a,x0)});try{await hn("plan",{...e,request:s,tab:this.tab()}),await r}catch(a){this.onFault(s,a.message)}finally{this.sending=!1}this.send()}}const Gh=.1;class S0{constructor(e){this.app=e}element=U("div",{id:"arm-panel"});limitScale=Gh;drawn="";isConfirmed=!1;get isThere(){const{project:e,armName:t}=this.app;return e.driver!==""&&t===e.driver_arm}get isChosen(){return this.isThere&&this.app.armLink.isMine}refresh(e){if(!this.isThere)return;const{status:t,isMine:i,isSeen:s,live:r}=this.app.armLink,a=e?Xm(this.app.arm,e.setpoints_kpa):0,o=JSON.stringify([t,i,s,r?.holds,r?.noticed,this.limitScale,this.isConfirmed,a]);o!==this.drawn&&(this.drawn=o,to(this.element,...this.parts(a)))}parts(e){const{armLink:t,project:i}=this.app,{state:s,message:r,recording:a}=t.status,o=[U("p",{class:"hint"},i.driver)];if(!t.isSeen)o.push(U("p",{class:"warning"},"The studio is not heard: what the arm does is not known."));else if(s==="running"){const l=t.live?.holds??"";o.push(U("p",{class:"status busy"},U("strong",{},l?`Holds: ${l}`:"Moves"))),t.live?.noticed&&o.push(U("p",{class:"warning"},t.live.noticed))}else if(s==="armed"&&!t.isMine)o.push(U("p",{},"Another page has armed the arm."));else if(t.isMine)o.push(...this.armedParts(e));else{const l=rt("Arm",()=>void this.app.attempt(async()=>{this.isConfirmed=!1,this.limitScale=Math.min(Gh,i.driver_limit_scale),await t.arm()}),{class:"danger"});l.disabled=!this.isConfirmed,o.push(Mr("Nobody is within its reach, and I can shut off the supply",this.isConfirmed,c=>{this.isConfirmed=c,this.app.refresh()}),U("div",{class:"row"},l))}return r&&o.push(U("p",{class:t.isAlarm?"alarm":"outcome"},r)),a&&o.push(U("p",{class:"hint"},`Recorded: ${a}`)),o}armedParts(e){const{app:t}=this,i=cd("Share of the pressure limits that the arm may use",this.limitScale,r=>{this.limitScale=r,t.refresh()},t.project.driver_limit_scale),s=e>this.limitScale+.001;return[U("p",{},U("strong",{},"Armed.")," Play moves it; Space, Escape and VENT vent it at once."),Kn("Limits",i),U("p",{class:s?"warning":"hint"},`This plan needs ${Math.ceil(100*e-.1)} % of the limits.`),U("div",{class:"row"},s&&rt(`Plan within ${Math.round(100*this.limitScale)} %`,()=>{t.limitScale=this.limitScale,t.enter("plan"),t.ask()}),rt("Disarm",()=>void t.attempt(()=>t.armLink.disarm())))]}}class y0{constructor(e){this.app=e,this.armPanel=new S0(e)}run=null;shown=new Set(["simple","network","virtual_arm","arm"]);request=0;options={replan:!1,obstacle:!1};trail=[];seen=null;armRun=null;boxes=U("div",{class:"checks"});player=new hd(()=>this.run?Gl(this.run):0,()=>this.app.refresh(),()=>this.toggle());stop=rt("Stop",()=>void this.app.attempt(()=>this.app.armLink.stop().then(()=>{})));tracks=U("div");plots=new Qd(e=>{this.app.armLink.live||this.player.seek(e)});armPanel;enter(e){const{app:t}=this;this.run=null;const i=this.armPanel.isThere&&U("section",{},U("h2",{},"The arm"),this.armPanel.element,U("div",{class:"row"},this.stop))||"";if(!t.planner.plan||!t.planner.isCurrent){e.append(U("section",{},U("p",{},"There is no certified plan to play yet."),rt("Back to Plan",()=>t.enter("plan"),{class:"main"})),t.armLink.isMine&&i||"");return}const s=(r,a)=>Mr(r,this.options[a],o=>{this.options[a]=o,this.armRun=null,this.ask()});this.boxes.replaceChildren(...t.model===""?[]:[s("Closed loop","replan")],s("Drop an obstacle into the way","obstacle")),e.append(U("section",{},U("h2",{},"Time"),this.player.element,this.boxes),i,U("section",{},U("h2",{},"The same plan, moved by"),this.tracks),U("section",{},U("h2",{},"Over time"),this.plots.element),U("section",{},U("h2",{},"Save"),yo(t,()=>this.run))),this.ask()}leave(){this.player.halt(0),++this.request,this.run||this.app.endWork()}ask(){this.run=null,this.player.halt(0),this.tracks.replaceChildren(U("p",{class:"hint","aria-live":"polite"},"Moving the models …")),this.plots.show([],1,this.shown);const{app:e}=this;e.refresh();const t=++this.request;e.attempt(()=>hn("run",{tab:e.tab,request:t,plan:e.planner.number,...Ju(this.options,e.model)}).catch(i=>this.onFault(t,i.message)))}onRun(e){e.request===this.request&&(this.show(e),this.options.obstacle&&!e.appeared&&this.app.say("No obstacle fits into the way: the motion is too short"),this.armPanel.isChosen||this.toggle())}onFault(e,t){e===this.request&&this.tracks.replaceChildren(U("p",{class:"warning"},t))}onArmRun(e){const{app:t,armRun:i}=this;if(!(!i||!t.armLink.ownRun)){if(this.trail=[],i.motion=e,i.plan!==t.planner.plan)return t.say("The arm’s run was of the plan before: it is recorded");this.run&&(this.show(this.run),this.player.seek(Gl(this.run)))}}withArm(e){const{motion:t,plan:i}=this.armRun??{};if(!t||i!==this.app.planner.plan)return e;const s=e.tracks.filter(({key:r})=>r!=="arm"&&r!=="virtual_arm");return{...t,tracks:[...s,...t.tracks]}}show(e){const t=this.withArm(e);this.run=t,this.tracks.replaceChildren(qm(t,this.shown,()=>{this.plot(),this.app.refresh()})),this.plot(),this.player.seek(0)}plot(){const{run:e,app:t}=this;e&&this.plots.show(Jd(e,mo(e),t.environment.goal,t.unit),e.frame_rate_hz,this.shown)}toggle(){const{app:e}=this;if(this.armPanel.isChosen){const{armLink:t}=e;return t.runs?void e.attempt(()=>t.pause(!t.paused)):(this.trail=[],this.armRun={plan:e.planner.plan,environment:e.environment,motion:null},this.player.seek(0),void e.attempt(()=>t.run({...Ju(this.options,e.model),limit_scale:this.armPanel.limitScale,plan:e.planner.number})))}this.run&&this.player.toggle()}refresh(){const{run:e,player:t}=this,{armLink:i}=this.app,{live:s}=i,r=i.runs&&i.ownRun;this.armPanel.refresh(this.app.planner.plan),this.stop.disabled=!i.runs||!i.isMine,s&&(t.halt(s.time_s),s.shape&&s!==this.seen&&ad(this.trail,s.shape),this.seen=s),t.slider.disabled=r;for(const a of this.boxes.querySelectorAll("input"))a.disabled=r;t.press.disabled=r&&!i.isMine,Qi(t.press,r?i.paused?"Go on":"Pause":t.playing?"Pause":this.armPanel.isChosen?"Play on the arm":"Play"),e&&this.plots.at(t.time_s)}scene(){const{run:e,player:{time_s:t}}=this,{armLink:{live:i},environment:s,planner:r,view:a}=this.app,o=a.tree?r.tree:null;if(!i)return e?{environment:eg(s,e,t),figures:Wl(e,this.shown,t),showReach:!1,showTree:o}:{};const l=this.armRun?.environment??s,c=new Set([...this.shown].filter(u=>u!=="arm"&&u!=="virtual_arm")),h=i.shape?[{shape:i.shape,pressures_kpa:i.pressure_kpa,colour:"arm",trail:this.trail}]:[];return{environment:{...l,obstacles:[...l.obstacles,...i.obstacle?[i.obstacle]:[]]},figures:[...h,...e&&l===s?Wl(e,c,t,!0):[]],showReach:!1}}legend(){return[["pressure","Pressurised side"],["goal","Goal"]]}}const Ra=308,ol=150,Ca=34,Wh=8,E0=20,Ks=92,ll={network:["network","Network"],no_load:["simple","Simple model"],hold:["hold","Hold the pose"]};function T0({model:n,planner:e,controller:t,disturbance:i}){return[n==="network"?"network":"simple model",e==="default"?"":e,t==="open"?"":t,i].filter(s=>s!=="").join(", ")}function w0({controller:n,disturbance:e}){const t=e.split(",").filter(i=>i!==""&&i!=="obstacle");return{options:{replan:n==="replan",obstacle:e.split(",").includes("obstacle")},leftOut:[...["open","replan"].includes(n)?[]:[n],...t].join(", ")}}function b0(n){if(n.status!=="solved")return"no plan";const e=n.distance_to_goal_cm===null?"":`, ${n.distance_to_goal_cm.toFixed(2)} cm`;return n.goal_reached===null&&n.collided===null?"not executed":`${n.collided?"collides":n.goal_reached?"arrives":n.stopped_ahead?"stops":"misses"}${e}`}const nc=n=>n==null?"–":n.toFixed(2);function A0({rows:n},e,t,i,s){const r=["Environment","Arrive","Collide","Miss, cm"].map(a=>U("th",{scope:"col"},a));return U("table",{class:"experiment"},U("caption",{},"Runs that arrive and collide; median distance to the goal"),U("thead",{},U("tr",{},...r)),U("tbody",{},...n.flatMap((a,o)=>{const l=rt(a.environment,()=>i(o),{"aria-expanded":String(e===o)}),c=U("tr",{},U("th",{scope:"row"},l,U("small",{},T0(a))),U("td",{},`${a.reached}/${a.trials}`),U("td",{},String(a.collided)),U("td",{},nc(a.distance_to_goal_cm?.median)));return e===o?[c,R0(t,s)]:[c]})))}function R0(n,e){const t=n===null?U("p",{class:"hint"},"Reading …"):U("ul",{class:"runs"},...n.map((i,s)=>U("li",{},rt(`${s} · ${b0(i)}`,()=>e(i),{disabled:i.plan===null,title:"Play this plan"}))));return U("tr",{},U("td",{colspan:4},t))}function C0({frames:n,tip_error_cm:e},t){const i=Object.entries(e).sort(([m])=>m==="network"?1:-1),s=i.flatMap(([,m])=>m).filter(m=>m!==null&&m>0),r=Math.floor(Math.log10(Math.min(1,...s))),a=Math.max(r+1,Math.ceil(Math.log10(Math.max(.01,...s)))),o=Math.log2(Math.max(2,n[n.length-1])),l=m=>Ca+Math.log2(m)/o*(Ra-Ca-4),c=m=>Wh+(a-Math.log10(Math.max(10**r,m)))/(a-r)*(ol-E0-Wh),h=m=>m.map((d,w)=>d===null?"":`${w===0||m[w-1]===null?"M":"L"}${l(n[w]).toFixed(1)} ${c(d).toFixed(1)}`).join(""),u=Array.from({length:a-r+1},(m,d)=>10**(r+d)),f=n.filter((m,d)=>d%3===0),p=m=>m/t<10?`${Number((m/t).toPrecision(2))} s`:`${Math.round(m/t)} s`,_=Zi("svg",{viewBox:`0 0 ${Ra} ${ol}`,role:"img","aria-label":"Mean tip error in cm over the time since the last correction"},...u.flatMap(m=>[Zi("line",{class:"tick",x1:Ca,x2:Ra,y1:c(m),y2:c(m)}),Zi("text",{x:Ca-5,y:c(m)+3.5,"text-anchor":"end"},String(Number(m.toPrecision(1))))]),...f.map(m=>Zi("text",{x:l(m),y:ol-5,"text-anchor":l(m)>Ra-20?"end":"middle"},p(m))),...i.map(([m,d])=>Zi("path",{class:`line ${ll[m]?.[0]}`,d:h(d)}))),x=i.map(([m,d])=>U("tr",{},U("th",{scope:"row"},U("i",{class:`swatch ${ll[m]?.[0]}`}),` ${ll[m]?.[1]??m}`),U("td",{},nc(d[0])),U("td",{},nc(d[d.length-1]))));return U("figure",{},_,U("table",{},U("caption",{},"Mean tip error, cm"),U("thead",{},U("tr",{},U("td",{}),U("th",{scope:"col"},"1 frame"),U("th",{scope:"col"},"never corrected"))),U("tbody",{},...x.reverse())))}const P0=n=>n.filter(e=>e>0).length/n.length;function L0({cells:n,pairs:e},{segments:t,command:i}){const s=Ks/n,r=a=>`${t[a].lower_kpa.toFixed(0)} … ${t[a].upper_kpa.toFixed(0)} ${i.unit}`;return U("div",{class:"maps"},...e.map(({segments:[a,o],frames:l})=>{const c=Math.log1p(Math.max(1,...l)),h=`${Math.round(100*P0(l))} %`,u=Zi("svg",{viewBox:`0 0 ${Ks} ${Ks}`,role:"img","aria-label":`Segment ${a} across, ${r(a)}; segment ${o} up, ${r(o)}: ${h} of the cells are covered`},Zi("rect",{class:"map",width:Ks,height:Ks}),...l.flatMap((f,p)=>f===0?[]:[Zi("rect",{class:"cell",width:s+.1,height:s+.1,x:p%n*s,y:Ks-s*(Math.floor(p/n)+1),opacity:(.2+.8*(Math.log1p(f)/c)).toFixed(2)})]));return U("figure",{},u,U("figcaption",{},`${a} across, ${o} up: ${h}`))}))}class D0{constructor(e){this.app=e}experiment=null;open=null;runs=null;table=U("div");onRecording=U("section");recording="";request=0;measuring=!1;bar=U("progress",{"aria-label":"Share that is measured",max:1,value:0});press=rt("Measure",()=>this.measure(),{class:"main"});stop=rt("Stop",()=>this.end());measured=U("div",{id:"measured","aria-live":"polite"});enter(e){e.append(U("section",{},U("h2",{},"The last experiment"),this.table),this.onRecording),this.onRecording.replaceChildren(),this.experiment=this.runs=this.open=null,this.table.replaceChildren(U("p",{class:"hint"},"Looking …")),this.measured.replaceChildren(),this.app.attempt(async()=>{await this.app.readProject(),this.showRecordings(),this.experiment=await ta("experiment"),this.show()})}showRecordings(){const{recordings:e}=this.app.project;e.includes(this.recording)||(this.recording=e[0]??""),this.onRecording.replaceChildren(U("h2",{},"The model on a recording"),...e.length===0?[U("p",{class:"hint"},"There is no recording in the project folder: limber collect makes one.")]:[Kn("Recording",fr(e,this.recording,t=>this.recording=t)),U("div",{class:"row"},this.press,this.stop,this.bar),this.measured])}leave(){this.measuring&&this.end(),this.app.planner.giveUp()}show(){const{experiment:e}=this;if(!e)return;if(e.folder===""){this.table.replaceChildren(U("p",{class:"hint"},"There is none in the project folder: limber experiment makes one."));return}const t=this.table.contains(document.activeElement);this.table.replaceChildren(U("p",{},e.folder),A0(e,this.open,this.runs,i=>this.toggle(i),i=>this.play(i))),t&&this.open!==null&&this.table.querySelector("[aria-expanded=true]")?.focus()}toggle(e){if(this.open=this.open===e?null:e,this.runs=null,this.show(),this.open===null){this.table.querySelectorAll("[aria-expanded]")[e]?.focus();return}this.app.attempt(async()=>{const{runs:t}=await hn("experiment/runs",{folder:this.experiment?.folder,row:e});this.open===e&&(this.runs=t,this.show())})}play({plan:e}){const{app:t,experiment:i,open:s}=this;if(e===null||i===null||s===null||!t.mayLose("Open the scene of this run?"))return;const{options:r,leftOut:a}=w0(i.rows[s]);this.measuring=!1,this.refresh(),t.opening.ask(e,()=>{Object.assign(t.modes.play.options,r),t.enter("play"),a&&t.say(`Played without what the experiment had: ${a}`)})}measure(){const{app:e}=this;e.planner.giveUp(),this.measuring=!0,this.bar.value=0,this.measured.replaceChildren(),this.refresh(),e.attempt(async()=>{try{await hn("measure",{tab:e.tab,request:++this.request,arm:e.armName,model:e.model,recording:this.recording})}catch(t){this.onFault(this.request,t.message)}})}end(){this.measuring=!1,++this.request,this.refresh(),this.app.endWork()}onMeasuring(e,t){e===this.request&&(this.bar.value=t)}onMeasured(e){if(e.request!==this.request)return;this.measuring=!1;const{frames:t,frames_used:i,frame_rate_hz:s,learnt_from_it:r,horizons:a,coverage:o}=e,l=c=>`${(c/s/60).toFixed(1)} min`;this.measured.replaceChildren(...r?[U("p",{class:"warning"},"The model learnt from this recording: its errors there say nothing.")]:[],U("p",{},i<t?`Its first ${l(i)} of ${l(t)}`:`All of its ${l(t)}`,". Mean tip error in cm, over the time since the last correction:"),C0(a,s),U("p",{},"Pressures that it covers, by pairs of segments"),L0(o,this.app.arm)),this.refresh()}onFault(e,t){!this.measuring||e!==this.request||(this.measuring=!1,this.measured.replaceChildren(U("p",{class:"warning"},t)),this.refresh())}refresh(){this.press.disabled=this.measuring,this.stop.disabled=!this.measuring,this.bar.hidden=!this.measuring}scene(){return{figures:[{shape:this.app.arm.rest,colour:"plate"}]}}legend(){return[["goal","Goal"],["reach","Reached by the simple model, at rest"]]}}const U0=1e5;function I0(n){const e=new TextEncoder().encode(n);return btoa(Array.from(e,i=>String.fromCharCode(i)).join("")).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"")}function N0(n){const e=atob(n.replaceAll("-","+").replaceAll("_","/")),t=Uint8Array.from(e,i=>i.charCodeAt(0));return new TextDecoder("utf-8",{fatal:!0}).decode(t)}const Lo=n=>typeof n=="object"&&n!==null&&!Array.isArray(n);function ic(n,e,t=[]){return Lo(n)&&e.every(i=>i in n)&&Object.entries(n).every(([i,s])=>[...e,...t].includes(i)&&Number.isFinite(s))}const ep=(n,e)=>Array.isArray(n)&&n.every(t=>Array.isArray(t)&&t.every(Number.isFinite)&&(e===void 0||t.length===e));function F0(n){if(!Lo(n)||Object.keys(n).length!==1)return!1;const{circle:e,rectangle:t,polygon:i}=n;return ic(e,["x_m","y_m","radius_m"])||ic(t,["x_m","y_m","width_m","height_m","angle_rad"])||ep(i,2)&&i.length>2}function O0(n){return ic(n,["x_m","y_m","position_tolerance_m"],["theta_rad","orientation_tolerance_rad"])}function B0(n){return n==="rest"||Lo(n)&&ep(n.backbone,3)}function k0(n){if(n.length>U0)return null;try{const e=JSON.parse(N0(n));if(!Lo(e))return null;const{name:t,obstacles:i,start:s,goal:r}=e;return typeof t!="string"||!Array.isArray(i)||!i.every(F0)||!B0(s)||!O0(r)?null:{name:t,obstacles:i,start:s,goal:r}}catch{return null}}function z0({arm:n,model:e,environmentName:t,environment:i}){const s=new URLSearchParams({arm:n,model:e,environment:t});return i&&s.set("scene",I0(JSON.stringify(i))),`#${s}`}function H0(n,e){const{arms:t,models:i,environments:s,first_arm:r,first_model:a}=e,o=new URLSearchParams(n.replace(/^#/,"")),l=o.get("scene"),c=l===null?null:k0(l);if(l!==null&&c===null)throw new mi(0,"The link’s scene can’t be read. Was the link cut off?");const h=(f,p,_,x=!0)=>{const m=o.get(f)??_;if(p.includes(m)||m===_)return m;if(x)throw new mi(0,`The link’s ${f} '${m}' is not in this project.`);return _},u=s.find(f=>f.endsWith("01_pillar"))??s[0];return{arm:h("arm",t,r),model:h("model",["",...i],a),environmentName:h("environment",s,u,c===null),environment:c}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const cu="170",V0=0,Xh=1,G0=2,tp=1,W0=2,Ai=3,ts=0,En=1,fi=2,ji=0,gr=1,qh=2,$h=3,Yh=4,X0=5,Ss=100,q0=101,$0=102,Y0=103,Z0=104,K0=200,j0=201,J0=202,Q0=203,sc=204,rc=205,ev=206,tv=207,nv=208,iv=209,sv=210,rv=211,av=212,ov=213,lv=214,ac=0,oc=1,lc=2,br=3,cc=4,uc=5,hc=6,fc=7,np=0,cv=1,uv=2,Ji=0,hv=1,fv=2,dv=3,pv=4,mv=5,gv=6,_v=7,ip=300,Ar=301,Rr=302,dc=303,pc=304,Do=306,mc=1e3,Es=1001,gc=1002,ni=1003,vv=1004,Pa=1005,di=1006,cl=1007,Ts=1008,Ni=1009,sp=1010,rp=1011,oa=1012,uu=1013,Us=1014,Ri=1015,ha=1016,hu=1017,fu=1018,Cr=1020,ap=35902,op=1021,lp=1022,ti=1023,cp=1024,up=1025,_r=1026,Pr=1027,hp=1028,du=1029,fp=1030,pu=1031,mu=1033,so=33776,ro=33777,ao=33778,oo=33779,_c=35840,vc=35841,xc=35842,Mc=35843,Sc=36196,yc=37492,Ec=37496,Tc=37808,wc=37809,bc=37810,Ac=37811,Rc=37812,Cc=37813,Pc=37814,Lc=37815,Dc=37816,Uc=37817,Ic=37818,Nc=37819,Fc=37820,Oc=37821,lo=36492,Bc=36494,kc=36495,dp=36283,zc=36284,Hc=36285,Vc=36286,xv=3200,Mv=3201,Sv=0,yv=1,Ki="",Hn="srgb",Os="srgb-linear",Uo="linear",yt="srgb",js=7680,Zh=519,Ev=512,Tv=513,wv=514,pp=515,bv=516,Av=517,Rv=518,Cv=519,Kh=35044,jh="300 es",Ci=2e3,Mo=2001;class Nr{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){if(this._listeners===void 0)return!1;const i=this._listeners;return i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){if(this._listeners===void 0)return;const s=this._listeners[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){if(this._listeners===void 0)return;const i=this._listeners[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}}const cn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ul=Math.PI/180,Gc=180/Math.PI;function fa(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(cn[n&255]+cn[n>>8&255]+cn[n>>16&255]+cn[n>>24&255]+"-"+cn[e&255]+cn[e>>8&255]+"-"+cn[e>>16&15|64]+cn[e>>24&255]+"-"+cn[t&63|128]+cn[t>>8&255]+"-"+cn[t>>16&255]+cn[t>>24&255]+cn[i&255]+cn[i>>8&255]+cn[i>>16&255]+cn[i>>24&255]).toLowerCase()}function yn(n,e,t){return Math.max(e,Math.min(t,n))}function Pv(n,e){return(n%e+e)%e}function hl(n,e,t){return(1-t)*n+t*e}function Xr(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Sn(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}class Tt{constructor(e=0,t=0){Tt.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(e,Math.min(t,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(yn(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*i-a*s+e.x,this.y=r*s+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Je{constructor(e,t,i,s,r,a,o,l,c){Je.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c)}set(e,t,i,s,r,a,o,l,c){const h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],p=i[5],_=i[8],x=s[0],m=s[3],d=s[6],w=s[1],T=s[4],v=s[7],H=s[2],L=s[5],D=s[8];return r[0]=a*x+o*w+l*H,r[3]=a*m+o*T+l*L,r[6]=a*d+o*v+l*D,r[1]=c*x+h*w+u*H,r[4]=c*m+h*T+u*L,r[7]=c*d+h*v+u*D,r[2]=f*x+p*w+_*H,r[5]=f*m+p*T+_*L,r[8]=f*d+p*v+_*D,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-i*r*h+i*o*l+s*r*c-s*a*l}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=h*a-o*c,f=o*l-h*r,p=c*r-a*l,_=t*u+i*f+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const x=1/_;return e[0]=u*x,e[1]=(s*c-h*i)*x,e[2]=(o*i-s*a)*x,e[3]=f*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-o*t)*x,e[6]=p*x,e[7]=(i*l-c*t)*x,e[8]=(a*t-i*r)*x,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,a,o){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return this.premultiply(fl.makeScale(e,t)),this}rotate(e){return this.premultiply(fl.makeRotation(-e)),this}translate(e,t){return this.premultiply(fl.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const fl=new Je;function mp(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function So(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Lv(){const n=So("canvas");return n.style.display="block",n}const Jh={};function Qr(n){n in Jh||(Jh[n]=!0,console.warn(n))}function Dv(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}function Uv(n){const e=n.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function Iv(n){const e=n.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}const ft={enabled:!0,workingColorSpace:Os,spaces:{},convert:function(n,e,t){return this.enabled===!1||e===t||!e||!t||(this.spaces[e].transfer===yt&&(n.r=Di(n.r),n.g=Di(n.g),n.b=Di(n.b)),this.spaces[e].primaries!==this.spaces[t].primaries&&(n.applyMatrix3(this.spaces[e].toXYZ),n.applyMatrix3(this.spaces[t].fromXYZ)),this.spaces[t].transfer===yt&&(n.r=vr(n.r),n.g=vr(n.g),n.b=vr(n.b))),n},fromWorkingColorSpace:function(n,e){return this.convert(n,this.workingColorSpace,e)},toWorkingColorSpace:function(n,e){return this.convert(n,e,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===Ki?Uo:this.spaces[n].transfer},getLuminanceCoefficients:function(n,e=this.workingColorSpace){return n.fromArray(this.spaces[e].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,e,t){return n.copy(this.spaces[e].toXYZ).multiply(this.spaces[t].fromXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}};function Di(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function vr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}const Qh=[.64,.33,.3,.6,.15,.06],ef=[.2126,.7152,.0722],tf=[.3127,.329],nf=new Je().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sf=new Je().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ft.define({[Os]:{primaries:Qh,whitePoint:tf,transfer:Uo,toXYZ:nf,fromXYZ:sf,luminanceCoefficients:ef,workingColorSpaceConfig:{unpackColorSpace:Hn},outputColorSpaceConfig:{drawingBufferColorSpace:Hn}},[Hn]:{primaries:Qh,whitePoint:tf,transfer:yt,toXYZ:nf,fromXYZ:sf,luminanceCoefficients:ef,outputColorSpaceConfig:{drawingBufferColorSpace:Hn}}});let Js;class Nv{static getDataURL(e){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let t;if(e instanceof HTMLCanvasElement)t=e;else{Js===void 0&&(Js=So("canvas")),Js.width=e.width,Js.height=e.height;const i=Js.getContext("2d");e instanceof ImageData?i.putImageData(e,0,0):i.drawImage(e,0,0,e.width,e.height),t=Js}return t.width>2048||t.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",e),t.toDataURL("image/jpeg",.6)):t.toDataURL("image/png")}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=So("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Di(r[a]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Di(t[i]/255)*255):t[i]=Di(t[i]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let Fv=0;class gp{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Fv++}),this.uuid=fa(),this.data=e,this.dataReady=!0,this.version=0}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(dl(s[a].image)):r.push(dl(s[a]))}else r=dl(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function dl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Nv.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Ov=0;class Tn extends Nr{constructor(e=Tn.DEFAULT_IMAGE,t=Tn.DEFAULT_MAPPING,i=Es,s=Es,r=di,a=Ts,o=ti,l=Ni,c=Tn.DEFAULT_ANISOTROPY,h=Ki){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ov++}),this.uuid=fa(),this.name="",this.source=new gp(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Tt(0,0),this.repeat=new Tt(1,1),this.center=new Tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Je,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ip)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case mc:e.x=e.x-Math.floor(e.x);break;case Es:e.x=e.x<0?0:1;break;case gc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case mc:e.y=e.y-Math.floor(e.y);break;case Es:e.y=e.y<0?0:1;break;case gc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}Tn.DEFAULT_IMAGE=null;Tn.DEFAULT_MAPPING=ip;Tn.DEFAULT_ANISOTROPY=1;class zt{constructor(e=0,t=0,i=0,s=1){zt.prototype.isVector4=!0,this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*i+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],p=l[5],_=l[9],x=l[2],m=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(_-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(_+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const T=(c+1)/2,v=(p+1)/2,H=(d+1)/2,L=(h+f)/4,D=(u+x)/4,F=(_+m)/4;return T>v&&T>H?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=L/i,r=D/i):v>H?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=L/s,r=F/s):H<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(H),i=D/r,s=F/r),this.set(i,s,r,t),this}let w=Math.sqrt((m-_)*(m-_)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(w)<.001&&(w=1),this.x=(m-_)/w,this.y=(u-x)/w,this.z=(f-h)/w,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this.w=Math.max(e.w,Math.min(t.w,this.w)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this.w=Math.max(e,Math.min(t,this.w)),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(e,Math.min(t,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class Bv extends Nr{constructor(e=1,t=1,i={}){super(),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=1,this.scissor=new zt(0,0,e,t),this.scissorTest=!1,this.viewport=new zt(0,0,e,t);const s={width:e,height:t,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:di,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);const r=new Tn(s,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);r.flipY=!1,r.generateMipmaps=i.generateMipmaps,r.internalFormat=i.internalFormat,this.textures=[];const a=i.count;for(let o=0;o<a;o++)this.textures[o]=r.clone(),this.textures[o].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let i=0,s=e.textures.length;i<s;i++)this.textures[i]=e.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;const t=Object.assign({},e.texture.image);return this.texture.source=new gp(t),this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Is extends Bv{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class _p extends Tn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=Es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class kv extends Tn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=Es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class da{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,a,o){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3];const f=r[a+0],p=r[a+1],_=r[a+2],x=r[a+3];if(o===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u;return}if(o===1){e[t+0]=f,e[t+1]=p,e[t+2]=_,e[t+3]=x;return}if(u!==x||l!==f||c!==p||h!==_){let m=1-o;const d=l*f+c*p+h*_+u*x,w=d>=0?1:-1,T=1-d*d;if(T>Number.EPSILON){const H=Math.sqrt(T),L=Math.atan2(H,d*w);m=Math.sin(m*L)/H,o=Math.sin(o*L)/H}const v=o*w;if(l=l*m+f*v,c=c*m+p*v,h=h*m+_*v,u=u*m+x*v,m===1-o){const H=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=H,c*=H,h*=H,u*=H}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,i,s,r,a){const o=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[a],f=r[a+1],p=r[a+2],_=r[a+3];return e[t]=o*_+h*u+l*p-c*f,e[t+1]=l*_+h*f+c*u-o*p,e[t+2]=c*_+h*p+o*f-l*u,e[t+3]=h*_-o*u-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(i/2),h=o(s/2),u=o(r/2),f=l(i/2),p=l(s/2),_=l(r/2);switch(a){case"XYZ":this._x=f*h*u+c*p*_,this._y=c*p*u-f*h*_,this._z=c*h*_+f*p*u,this._w=c*h*u-f*p*_;break;case"YXZ":this._x=f*h*u+c*p*_,this._y=c*p*u-f*h*_,this._z=c*h*_-f*p*u,this._w=c*h*u+f*p*_;break;case"ZXY":this._x=f*h*u-c*p*_,this._y=c*p*u+f*h*_,this._z=c*h*_+f*p*u,this._w=c*h*u-f*p*_;break;case"ZYX":this._x=f*h*u-c*p*_,this._y=c*p*u+f*h*_,this._z=c*h*_-f*p*u,this._w=c*h*u+f*p*_;break;case"YZX":this._x=f*h*u+c*p*_,this._y=c*p*u+f*h*_,this._z=c*h*_-f*p*u,this._w=c*h*u-f*p*_;break;case"XZY":this._x=f*h*u-c*p*_,this._y=c*p*u-f*h*_,this._z=c*h*_+f*p*u,this._w=c*h*u+f*p*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=i+o+u;if(f>0){const p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(a-s)*p}else if(i>o&&i>u){const p=2*Math.sqrt(1+i-o-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+a)/p,this._z=(r+c)/p}else if(o>u){const p=2*Math.sqrt(1+o-i-u);this._w=(r-c)/p,this._x=(s+a)/p,this._y=.25*p,this._z=(l+h)/p}else{const p=2*Math.sqrt(1+u-i-o);this._w=(a-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<Number.EPSILON?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yn(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-i*c,this._z=r*h+a*c+i*l-s*o,this._w=a*h-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const i=this._x,s=this._y,r=this._z,a=this._w;let o=a*e._w+i*e._x+s*e._y+r*e._z;if(o<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,o=-o):this.copy(e),o>=1)return this._w=a,this._x=i,this._y=s,this._z=r,this;const l=1-o*o;if(l<=Number.EPSILON){const p=1-t;return this._w=p*a+t*this._w,this._x=p*i+t*this._x,this._y=p*s+t*this._y,this._z=p*r+t*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,o),u=Math.sin((1-t)*h)/c,f=Math.sin(t*h)/c;return this._w=a*u+this._w*f,this._x=i*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class ne{constructor(e=0,t=0,i=0){ne.prototype.isVector3=!0,this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(rf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(rf.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*i),h=2*(o*t-r*s),u=2*(r*i-a*t);return this.x=t+l*c+a*u-o*h,this.y=i+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(e,Math.min(t,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return pl.copy(this).projectOnVector(e),this.sub(pl)}reflect(e){return this.sub(pl.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(yn(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const pl=new ne,rf=new da;class pa{constructor(e=new ne(1/0,1/0,1/0),t=new ne(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(qn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(qn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=qn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,qn):qn.fromBufferAttribute(r,a),qn.applyMatrix4(e.matrixWorld),this.expandByPoint(qn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),La.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),La.copy(i.boundingBox)),La.applyMatrix4(e.matrixWorld),this.union(La)}const s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,qn),qn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(qr),Da.subVectors(this.max,qr),Qs.subVectors(e.a,qr),er.subVectors(e.b,qr),tr.subVectors(e.c,qr),Vi.subVectors(er,Qs),Gi.subVectors(tr,er),us.subVectors(Qs,tr);let t=[0,-Vi.z,Vi.y,0,-Gi.z,Gi.y,0,-us.z,us.y,Vi.z,0,-Vi.x,Gi.z,0,-Gi.x,us.z,0,-us.x,-Vi.y,Vi.x,0,-Gi.y,Gi.x,0,-us.y,us.x,0];return!ml(t,Qs,er,tr,Da)||(t=[1,0,0,0,1,0,0,0,1],!ml(t,Qs,er,tr,Da))?!1:(Ua.crossVectors(Vi,Gi),t=[Ua.x,Ua.y,Ua.z],ml(t,Qs,er,tr,Da))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,qn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(qn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(yi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),yi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),yi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),yi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),yi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),yi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),yi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),yi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(yi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}}const yi=[new ne,new ne,new ne,new ne,new ne,new ne,new ne,new ne],qn=new ne,La=new pa,Qs=new ne,er=new ne,tr=new ne,Vi=new ne,Gi=new ne,us=new ne,qr=new ne,Da=new ne,Ua=new ne,hs=new ne;function ml(n,e,t,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){hs.fromArray(n,r);const o=s.x*Math.abs(hs.x)+s.y*Math.abs(hs.y)+s.z*Math.abs(hs.z),l=e.dot(hs),c=t.dot(hs),h=i.dot(hs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}const zv=new pa,$r=new ne,gl=new ne;class gu{constructor(e=new ne,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):zv.setFromPoints(e).getCenter(i);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;$r.subVectors(e,this.center);const t=$r.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector($r,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(gl.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint($r.copy(e.center).add(gl)),this.expandByPoint($r.copy(e.center).sub(gl))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Ei=new ne,_l=new ne,Ia=new ne,Wi=new ne,vl=new ne,Na=new ne,xl=new ne;class Hv{constructor(e=new ne,t=new ne(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ei)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Ei.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ei.copy(this.origin).addScaledVector(this.direction,t),Ei.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){_l.copy(e).add(t).multiplyScalar(.5),Ia.copy(t).sub(e).normalize(),Wi.copy(this.origin).sub(_l);const r=e.distanceTo(t)*.5,a=-this.direction.dot(Ia),o=Wi.dot(this.direction),l=-Wi.dot(Ia),c=Wi.lengthSq(),h=Math.abs(1-a*a);let u,f,p,_;if(h>0)if(u=a*l-o,f=a*o-l,_=r*h,u>=0)if(f>=-_)if(f<=_){const x=1/h;u*=x,f*=x,p=u*(u+a*f+2*o)+f*(a*u+f+2*l)+c}else f=r,u=Math.max(0,-(a*f+o)),p=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(a*f+o)),p=-u*u+f*(f+2*l)+c;else f<=-_?(u=Math.max(0,-(-a*r+o)),f=u>0?-r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c):f<=_?(u=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(u=Math.max(0,-(a*r+o)),f=u>0?r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c);else f=a>0?-r:r,u=Math.max(0,-(a*f+o)),p=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(_l).addScaledVector(Ia,f),p}intersectSphere(e,t){Ei.subVectors(e.center,this.origin);const i=Ei.dot(this.direction),s=Ei.dot(Ei)-i*i,r=e.radius*e.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,a,o,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,a=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,a=(e.min.y-f.y)*h),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(o=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Ei)!==null}intersectTriangle(e,t,i,s,r){vl.subVectors(t,e),Na.subVectors(i,e),xl.crossVectors(vl,Na);let a=this.direction.dot(xl),o;if(a>0){if(s)return null;o=1}else if(a<0)o=-1,a=-a;else return null;Wi.subVectors(this.origin,e);const l=o*this.direction.dot(Na.crossVectors(Wi,Na));if(l<0)return null;const c=o*this.direction.dot(vl.cross(Wi));if(c<0||l+c>a)return null;const h=-o*Wi.dot(xl);return h<0?null:this.at(h/a,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Wt{constructor(e,t,i,s,r,a,o,l,c,h,u,f,p,_,x,m){Wt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c,h,u,f,p,_,x,m)}set(e,t,i,s,r,a,o,l,c,h,u,f,p,_,x,m){const d=this.elements;return d[0]=e,d[4]=t,d[8]=i,d[12]=s,d[1]=r,d[5]=a,d[9]=o,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=p,d[7]=_,d[11]=x,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Wt().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,i=e.elements,s=1/nr.setFromMatrixColumn(e,0).length(),r=1/nr.setFromMatrixColumn(e,1).length(),a=1/nr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){const f=a*h,p=a*u,_=o*h,x=o*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=p+_*c,t[5]=f-x*c,t[9]=-o*l,t[2]=x-f*c,t[6]=_+p*c,t[10]=a*l}else if(e.order==="YXZ"){const f=l*h,p=l*u,_=c*h,x=c*u;t[0]=f+x*o,t[4]=_*o-p,t[8]=a*c,t[1]=a*u,t[5]=a*h,t[9]=-o,t[2]=p*o-_,t[6]=x+f*o,t[10]=a*l}else if(e.order==="ZXY"){const f=l*h,p=l*u,_=c*h,x=c*u;t[0]=f-x*o,t[4]=-a*u,t[8]=_+p*o,t[1]=p+_*o,t[5]=a*h,t[9]=x-f*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){const f=a*h,p=a*u,_=o*h,x=o*u;t[0]=l*h,t[4]=_*c-p,t[8]=f*c+x,t[1]=l*u,t[5]=x*c+f,t[9]=p*c-_,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){const f=a*l,p=a*c,_=o*l,x=o*c;t[0]=l*h,t[4]=x-f*u,t[8]=_*u+p,t[1]=u,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=p*u+_,t[10]=f-x*u}else if(e.order==="XZY"){const f=a*l,p=a*c,_=o*l,x=o*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+x,t[5]=a*h,t[9]=p*u-_,t[2]=_*u-p,t[6]=o*h,t[10]=x*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Vv,e,Gv)}lookAt(e,t,i){const s=this.elements;return Cn.subVectors(e,t),Cn.lengthSq()===0&&(Cn.z=1),Cn.normalize(),Xi.crossVectors(i,Cn),Xi.lengthSq()===0&&(Math.abs(i.z)===1?Cn.x+=1e-4:Cn.z+=1e-4,Cn.normalize(),Xi.crossVectors(i,Cn)),Xi.normalize(),Fa.crossVectors(Cn,Xi),s[0]=Xi.x,s[4]=Fa.x,s[8]=Cn.x,s[1]=Xi.y,s[5]=Fa.y,s[9]=Cn.y,s[2]=Xi.z,s[6]=Fa.z,s[10]=Cn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],p=i[13],_=i[2],x=i[6],m=i[10],d=i[14],w=i[3],T=i[7],v=i[11],H=i[15],L=s[0],D=s[4],F=s[8],b=s[12],y=s[1],P=s[5],Y=s[9],B=s[13],q=s[2],K=s[6],Z=s[10],J=s[14],Q=s[3],he=s[7],ce=s[11],me=s[15];return r[0]=a*L+o*y+l*q+c*Q,r[4]=a*D+o*P+l*K+c*he,r[8]=a*F+o*Y+l*Z+c*ce,r[12]=a*b+o*B+l*J+c*me,r[1]=h*L+u*y+f*q+p*Q,r[5]=h*D+u*P+f*K+p*he,r[9]=h*F+u*Y+f*Z+p*ce,r[13]=h*b+u*B+f*J+p*me,r[2]=_*L+x*y+m*q+d*Q,r[6]=_*D+x*P+m*K+d*he,r[10]=_*F+x*Y+m*Z+d*ce,r[14]=_*b+x*B+m*J+d*me,r[3]=w*L+T*y+v*q+H*Q,r[7]=w*D+T*P+v*K+H*he,r[11]=w*F+T*Y+v*Z+H*ce,r[15]=w*b+T*B+v*J+H*me,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],p=e[14],_=e[3],x=e[7],m=e[11],d=e[15];return _*(+r*l*u-s*c*u-r*o*f+i*c*f+s*o*p-i*l*p)+x*(+t*l*p-t*c*f+r*a*f-s*a*p+s*c*h-r*l*h)+m*(+t*c*u-t*o*p-r*a*u+i*a*p+r*o*h-i*c*h)+d*(-s*o*h-t*l*u+t*o*f+s*a*u-i*a*f+i*l*h)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],p=e[11],_=e[12],x=e[13],m=e[14],d=e[15],w=u*m*c-x*f*c+x*l*p-o*m*p-u*l*d+o*f*d,T=_*f*c-h*m*c-_*l*p+a*m*p+h*l*d-a*f*d,v=h*x*c-_*u*c+_*o*p-a*x*p-h*o*d+a*u*d,H=_*u*l-h*x*l-_*o*f+a*x*f+h*o*m-a*u*m,L=t*w+i*T+s*v+r*H;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/L;return e[0]=w*D,e[1]=(x*f*r-u*m*r-x*s*p+i*m*p+u*s*d-i*f*d)*D,e[2]=(o*m*r-x*l*r+x*s*c-i*m*c-o*s*d+i*l*d)*D,e[3]=(u*l*r-o*f*r-u*s*c+i*f*c+o*s*p-i*l*p)*D,e[4]=T*D,e[5]=(h*m*r-_*f*r+_*s*p-t*m*p-h*s*d+t*f*d)*D,e[6]=(_*l*r-a*m*r-_*s*c+t*m*c+a*s*d-t*l*d)*D,e[7]=(a*f*r-h*l*r+h*s*c-t*f*c-a*s*p+t*l*p)*D,e[8]=v*D,e[9]=(_*u*r-h*x*r-_*i*p+t*x*p+h*i*d-t*u*d)*D,e[10]=(a*x*r-_*o*r+_*i*c-t*x*c-a*i*d+t*o*d)*D,e[11]=(h*o*r-a*u*r-h*i*c+t*u*c+a*i*p-t*o*p)*D,e[12]=H*D,e[13]=(h*x*s-_*u*s+_*i*f-t*x*f-h*i*m+t*u*m)*D,e[14]=(_*o*s-a*x*s-_*i*l+t*x*l+a*i*m-t*o*m)*D,e[15]=(a*u*s-h*o*s+h*i*l-t*u*l-a*i*f+t*o*f)*D,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+i,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,a){return this.set(1,i,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,u=o+o,f=r*c,p=r*h,_=r*u,x=a*h,m=a*u,d=o*u,w=l*c,T=l*h,v=l*u,H=i.x,L=i.y,D=i.z;return s[0]=(1-(x+d))*H,s[1]=(p+v)*H,s[2]=(_-T)*H,s[3]=0,s[4]=(p-v)*L,s[5]=(1-(f+d))*L,s[6]=(m+w)*L,s[7]=0,s[8]=(_+T)*D,s[9]=(m-w)*D,s[10]=(1-(f+x))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;let r=nr.set(s[0],s[1],s[2]).length();const a=nr.set(s[4],s[5],s[6]).length(),o=nr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],$n.copy(this);const c=1/r,h=1/a,u=1/o;return $n.elements[0]*=c,$n.elements[1]*=c,$n.elements[2]*=c,$n.elements[4]*=h,$n.elements[5]*=h,$n.elements[6]*=h,$n.elements[8]*=u,$n.elements[9]*=u,$n.elements[10]*=u,t.setFromRotationMatrix($n),i.x=r,i.y=a,i.z=o,this}makePerspective(e,t,i,s,r,a,o=Ci){const l=this.elements,c=2*r/(t-e),h=2*r/(i-s),u=(t+e)/(t-e),f=(i+s)/(i-s);let p,_;if(o===Ci)p=-(a+r)/(a-r),_=-2*a*r/(a-r);else if(o===Mo)p=-a/(a-r),_=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,s,r,a,o=Ci){const l=this.elements,c=1/(t-e),h=1/(i-s),u=1/(a-r),f=(t+e)*c,p=(i+s)*h;let _,x;if(o===Ci)_=(a+r)*u,x=-2*u;else if(o===Mo)_=r*u,x=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-p,l[2]=0,l[6]=0,l[10]=x,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}}const nr=new ne,$n=new Wt,Vv=new ne(0,0,0),Gv=new ne(1,1,1),Xi=new ne,Fa=new ne,Cn=new ne,af=new Wt,of=new da;class Fi{constructor(e=0,t=0,i=0,s=Fi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(yn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(yn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(yn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,p));break;case"XZY":this._z=Math.asin(-yn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return af.makeRotationFromQuaternion(e),this.setFromRotationMatrix(af,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return of.setFromEuler(this),this.setFromQuaternion(of,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Fi.DEFAULT_ORDER="XYZ";class vp{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let Wv=0;const lf=new ne,ir=new da,Ti=new Wt,Oa=new ne,Yr=new ne,Xv=new ne,qv=new da,cf=new ne(1,0,0),uf=new ne(0,1,0),hf=new ne(0,0,1),ff={type:"added"},$v={type:"removed"},sr={type:"childadded",child:null},Ml={type:"childremoved",child:null};class Un extends Nr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Wv++}),this.uuid=fa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Un.DEFAULT_UP.clone();const e=new ne,t=new Fi,i=new da,s=new ne(1,1,1);function r(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Wt},normalMatrix:{value:new Je}}),this.matrix=new Wt,this.matrixWorld=new Wt,this.matrixAutoUpdate=Un.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new vp,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ir.setFromAxisAngle(e,t),this.quaternion.multiply(ir),this}rotateOnWorldAxis(e,t){return ir.setFromAxisAngle(e,t),this.quaternion.premultiply(ir),this}rotateX(e){return this.rotateOnAxis(cf,e)}rotateY(e){return this.rotateOnAxis(uf,e)}rotateZ(e){return this.rotateOnAxis(hf,e)}translateOnAxis(e,t){return lf.copy(e).applyQuaternion(this.quaternion),this.position.add(lf.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(cf,e)}translateY(e){return this.translateOnAxis(uf,e)}translateZ(e){return this.translateOnAxis(hf,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ti.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Oa.copy(e):Oa.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),Yr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ti.lookAt(Yr,Oa,this.up):Ti.lookAt(Oa,Yr,this.up),this.quaternion.setFromRotationMatrix(Ti),s&&(Ti.extractRotation(s.matrixWorld),ir.setFromRotationMatrix(Ti),this.quaternion.premultiply(ir.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ff),sr.child=e,this.dispatchEvent(sr),sr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent($v),Ml.child=e,this.dispatchEvent(Ml),Ml.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ti.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ti.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ti),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ff),sr.child=e,this.dispatchEvent(sr),sr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yr,e,Xv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yr,qv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){const i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(o=>({boxInitialized:o.boxInitialized,boxMin:o.box.min.toArray(),boxMax:o.box.max.toArray(),sphereInitialized:o.sphereInitialized,sphereRadius:o.sphere.radius,sphereCenter:o.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){const o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),u=a(e.shapes),f=a(e.skeletons),p=a(e.animations),_=a(e.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),_.length>0&&(i.nodes=_)}return i.object=s,i;function a(o){const l=[];for(const c in o){const h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}}Un.DEFAULT_UP=new ne(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Yn=new ne,wi=new ne,Sl=new ne,bi=new ne,rr=new ne,ar=new ne,df=new ne,yl=new ne,El=new ne,Tl=new ne,wl=new zt,bl=new zt,Al=new zt;class ei{constructor(e=new ne,t=new ne,i=new ne){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Yn.subVectors(e,t),s.cross(Yn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Yn.subVectors(s,t),wi.subVectors(i,t),Sl.subVectors(e,t);const a=Yn.dot(Yn),o=Yn.dot(wi),l=Yn.dot(Sl),c=wi.dot(wi),h=wi.dot(Sl),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;const f=1/u,p=(c*l-o*h)*f,_=(a*h-o*l)*f;return r.set(1-p-_,_,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,bi)===null?!1:bi.x>=0&&bi.y>=0&&bi.x+bi.y<=1}static getInterpolation(e,t,i,s,r,a,o,l){return this.getBarycoord(e,t,i,s,bi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,bi.x),l.addScaledVector(a,bi.y),l.addScaledVector(o,bi.z),l)}static getInterpolatedAttribute(e,t,i,s,r,a){return wl.setScalar(0),bl.setScalar(0),Al.setScalar(0),wl.fromBufferAttribute(e,t),bl.fromBufferAttribute(e,i),Al.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(wl,r.x),a.addScaledVector(bl,r.y),a.addScaledVector(Al,r.z),a}static isFrontFacing(e,t,i,s){return Yn.subVectors(i,t),wi.subVectors(e,t),Yn.cross(wi).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Yn.subVectors(this.c,this.b),wi.subVectors(this.a,this.b),Yn.cross(wi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return ei.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return ei.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return ei.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return ei.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return ei.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let a,o;rr.subVectors(s,i),ar.subVectors(r,i),yl.subVectors(e,i);const l=rr.dot(yl),c=ar.dot(yl);if(l<=0&&c<=0)return t.copy(i);El.subVectors(e,s);const h=rr.dot(El),u=ar.dot(El);if(h>=0&&u<=h)return t.copy(s);const f=l*u-h*c;if(f<=0&&l>=0&&h<=0)return a=l/(l-h),t.copy(i).addScaledVector(rr,a);Tl.subVectors(e,r);const p=rr.dot(Tl),_=ar.dot(Tl);if(_>=0&&p<=_)return t.copy(r);const x=p*c-l*_;if(x<=0&&c>=0&&_<=0)return o=c/(c-_),t.copy(i).addScaledVector(ar,o);const m=h*_-p*u;if(m<=0&&u-h>=0&&p-_>=0)return df.subVectors(r,s),o=(u-h)/(u-h+(p-_)),t.copy(s).addScaledVector(df,o);const d=1/(m+x+f);return a=x*d,o=f*d,t.copy(i).addScaledVector(rr,a).addScaledVector(ar,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const xp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qi={h:0,s:0,l:0},Ba={h:0,s:0,l:0};function Rl(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Et{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Hn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ft.toWorkingColorSpace(this,t),this}setRGB(e,t,i,s=ft.workingColorSpace){return this.r=e,this.g=t,this.b=i,ft.toWorkingColorSpace(this,s),this}setHSL(e,t,i,s=ft.workingColorSpace){if(e=Pv(e,1),t=yn(t,0,1),i=yn(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,a=2*i-r;this.r=Rl(a,r,e+1/3),this.g=Rl(a,r,e),this.b=Rl(a,r,e-1/3)}return ft.toWorkingColorSpace(this,s),this}setStyle(e,t=Hn){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Hn){const i=xp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Di(e.r),this.g=Di(e.g),this.b=Di(e.b),this}copyLinearToSRGB(e){return this.r=vr(e.r),this.g=vr(e.g),this.b=vr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Hn){return ft.fromWorkingColorSpace(un.copy(this),e),Math.round(yn(un.r*255,0,255))*65536+Math.round(yn(un.g*255,0,255))*256+Math.round(yn(un.b*255,0,255))}getHexString(e=Hn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ft.workingColorSpace){ft.fromWorkingColorSpace(un.copy(this),t);const i=un.r,s=un.g,r=un.b,a=Math.max(i,s,r),o=Math.min(i,s,r);let l,c;const h=(o+a)/2;if(o===a)l=0,c=0;else{const u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=ft.workingColorSpace){return ft.fromWorkingColorSpace(un.copy(this),t),e.r=un.r,e.g=un.g,e.b=un.b,e}getStyle(e=Hn){ft.fromWorkingColorSpace(un.copy(this),e);const t=un.r,i=un.g,s=un.b;return e!==Hn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(qi),this.setHSL(qi.h+e,qi.s+t,qi.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(qi),e.getHSL(Ba);const i=hl(qi.h,Ba.h,t),s=hl(qi.s,Ba.s,t),r=hl(qi.l,Ba.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const un=new Et;Et.NAMES=xp;let Yv=0;class Io extends Nr{static get type(){return"Material"}get type(){return this.constructor.type}set type(e){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Yv++}),this.uuid=fa(),this.name="",this.blending=gr,this.side=ts,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=sc,this.blendDst=rc,this.blendEquation=Ss,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Et(0,0,0),this.blendAlpha=0,this.depthFunc=br,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=js,this.stencilZFail=js,this.stencilZPass=js,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==gr&&(i.blending=this.blending),this.side!==ts&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==sc&&(i.blendSrc=this.blendSrc),this.blendDst!==rc&&(i.blendDst=this.blendDst),this.blendEquation!==Ss&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==br&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Zh&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==js&&(i.stencilFail=this.stencilFail),this.stencilZFail!==js&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==js&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const a=[];for(const o in r){const l=r[o];delete l.metadata,a.push(l)}return a}if(t){const r=s(e.textures),a=s(e.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class _u extends Io{static get type(){return"MeshBasicMaterial"}constructor(e){super(),this.isMeshBasicMaterial=!0,this.color=new Et(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fi,this.combine=np,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Vt=new ne,ka=new Tt;class Vn{constructor(e,t,i=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Kh,this.updateRanges=[],this.gpuType=Ri,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ka.fromBufferAttribute(this,t),ka.applyMatrix3(e),this.setXY(t,ka.x,ka.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Vt.fromBufferAttribute(this,t),Vt.applyMatrix3(e),this.setXYZ(t,Vt.x,Vt.y,Vt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Vt.fromBufferAttribute(this,t),Vt.applyMatrix4(e),this.setXYZ(t,Vt.x,Vt.y,Vt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Vt.fromBufferAttribute(this,t),Vt.applyNormalMatrix(e),this.setXYZ(t,Vt.x,Vt.y,Vt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Vt.fromBufferAttribute(this,t),Vt.transformDirection(e),this.setXYZ(t,Vt.x,Vt.y,Vt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Xr(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=Sn(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Xr(t,this.array)),t}setX(e,t){return this.normalized&&(t=Sn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Xr(t,this.array)),t}setY(e,t){return this.normalized&&(t=Sn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Xr(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Sn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Xr(t,this.array)),t}setW(e,t){return this.normalized&&(t=Sn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=Sn(t,this.array),i=Sn(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=Sn(t,this.array),i=Sn(i,this.array),s=Sn(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=Sn(t,this.array),i=Sn(i,this.array),s=Sn(s,this.array),r=Sn(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Kh&&(e.usage=this.usage),e}}class Mp extends Vn{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class Sp extends Vn{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class As extends Vn{constructor(e,t,i){super(new Float32Array(e),t,i)}}let Zv=0;const Bn=new Wt,Cl=new Un,or=new ne,Pn=new pa,Zr=new pa,rn=new ne;class is extends Nr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Zv++}),this.uuid=fa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(mp(e)?Sp:Mp)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new Je().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return Bn.makeRotationFromQuaternion(e),this.applyMatrix4(Bn),this}rotateX(e){return Bn.makeRotationX(e),this.applyMatrix4(Bn),this}rotateY(e){return Bn.makeRotationY(e),this.applyMatrix4(Bn),this}rotateZ(e){return Bn.makeRotationZ(e),this.applyMatrix4(Bn),this}translate(e,t,i){return Bn.makeTranslation(e,t,i),this.applyMatrix4(Bn),this}scale(e,t,i){return Bn.makeScale(e,t,i),this.applyMatrix4(Bn),this}lookAt(e){return Cl.lookAt(e),Cl.updateMatrix(),this.applyMatrix4(Cl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(or).negate(),this.translate(or.x,or.y,or.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const a=e[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new As(i,3))}else{for(let i=0,s=t.count;i<s;i++){const r=e[i];t.setXYZ(i,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new pa);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new ne(-1/0,-1/0,-1/0),new ne(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];Pn.setFromBufferAttribute(r),this.morphTargetsRelative?(rn.addVectors(this.boundingBox.min,Pn.min),this.boundingBox.expandByPoint(rn),rn.addVectors(this.boundingBox.max,Pn.max),this.boundingBox.expandByPoint(rn)):(this.boundingBox.expandByPoint(Pn.min),this.boundingBox.expandByPoint(Pn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new gu);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new ne,1/0);return}if(e){const i=this.boundingSphere.center;if(Pn.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){const o=t[r];Zr.setFromBufferAttribute(o),this.morphTargetsRelative?(rn.addVectors(Pn.min,Zr.min),Pn.expandByPoint(rn),rn.addVectors(Pn.max,Zr.max),Pn.expandByPoint(rn)):(Pn.expandByPoint(Zr.min),Pn.expandByPoint(Zr.max))}Pn.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)rn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(rn));if(t)for(let r=0,a=t.length;r<a;r++){const o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)rn.fromBufferAttribute(o,c),l&&(or.fromBufferAttribute(e,c),rn.add(or)),s=Math.max(s,i.distanceToSquared(rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Vn(new Float32Array(4*i.count),4));const a=this.getAttribute("tangent"),o=[],l=[];for(let F=0;F<i.count;F++)o[F]=new ne,l[F]=new ne;const c=new ne,h=new ne,u=new ne,f=new Tt,p=new Tt,_=new Tt,x=new ne,m=new ne;function d(F,b,y){c.fromBufferAttribute(i,F),h.fromBufferAttribute(i,b),u.fromBufferAttribute(i,y),f.fromBufferAttribute(r,F),p.fromBufferAttribute(r,b),_.fromBufferAttribute(r,y),h.sub(c),u.sub(c),p.sub(f),_.sub(f);const P=1/(p.x*_.y-_.x*p.y);isFinite(P)&&(x.copy(h).multiplyScalar(_.y).addScaledVector(u,-p.y).multiplyScalar(P),m.copy(u).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(P),o[F].add(x),o[b].add(x),o[y].add(x),l[F].add(m),l[b].add(m),l[y].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let F=0,b=w.length;F<b;++F){const y=w[F],P=y.start,Y=y.count;for(let B=P,q=P+Y;B<q;B+=3)d(e.getX(B+0),e.getX(B+1),e.getX(B+2))}const T=new ne,v=new ne,H=new ne,L=new ne;function D(F){H.fromBufferAttribute(s,F),L.copy(H);const b=o[F];T.copy(b),T.sub(H.multiplyScalar(H.dot(b))).normalize(),v.crossVectors(L,b);const P=v.dot(l[F])<0?-1:1;a.setXYZW(F,T.x,T.y,T.z,P)}for(let F=0,b=w.length;F<b;++F){const y=w[F],P=y.start,Y=y.count;for(let B=P,q=P+Y;B<q;B+=3)D(e.getX(B+0)),D(e.getX(B+1)),D(e.getX(B+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Vn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);const s=new ne,r=new ne,a=new ne,o=new ne,l=new ne,c=new ne,h=new ne,u=new ne;if(e)for(let f=0,p=e.count;f<p;f+=3){const _=e.getX(f+0),x=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,x),a.fromBufferAttribute(t,m),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(i,_),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),o.add(h),l.add(h),c.add(h),i.setXYZ(_,o.x,o.y,o.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),a.fromBufferAttribute(t,f+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)rn.fromBufferAttribute(e,t),rn.normalize(),e.setXYZ(t,rn.x,rn.y,rn.z)}toNonIndexed(){function e(o,l){const c=o.array,h=o.itemSize,u=o.normalized,f=new c.constructor(l.length*h);let p=0,_=0;for(let x=0,m=l.length;x<m;x++){o.isInterleavedBufferAttribute?p=l[x]*o.data.stride+o.offset:p=l[x]*h;for(let d=0;d<h;d++)f[_++]=c[p++]}return new Vn(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new is,i=this.index.array,s=this.attributes;for(const o in s){const l=s[o],c=e(l,i);t.setAttribute(o,c)}const r=this.morphAttributes;for(const o in r){const l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){const f=c[h],p=e(f,i);l.push(p)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,l=a.length;o<l;o++){const c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const l in i){const c=i[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){const p=c[u];h.push(p.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(e.data.boundingSphere={center:o.center.toArray(),radius:o.radius}),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone(t));const s=e.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(t))}const r=e.morphAttributes;for(const c in r){const h=[],u=r[c];for(let f=0,p=u.length;f<p;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;const a=e.groups;for(let c=0,h=a.length;c<h;c++){const u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}const o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const pf=new Wt,fs=new Hv,za=new gu,mf=new ne,Ha=new ne,Va=new ne,Ga=new ne,Pl=new ne,Wa=new ne,gf=new ne,Xa=new ne;class pi extends Un{constructor(e=new is,t=new _u){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const o=this.morphTargetInfluences;if(r&&o){Wa.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=o[l],u=r[l];h!==0&&(Pl.fromBufferAttribute(u,e),a?Wa.addScaledVector(Pl,h):Wa.addScaledVector(Pl.sub(t),h))}t.add(Wa)}return t}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),za.copy(i.boundingSphere),za.applyMatrix4(r),fs.copy(e.ray).recast(e.near),!(za.containsPoint(fs.origin)===!1&&(fs.intersectSphere(za,mf)===null||fs.origin.distanceToSquared(mf)>(e.far-e.near)**2))&&(pf.copy(r).invert(),fs.copy(e.ray).applyMatrix4(pf),!(i.boundingBox!==null&&fs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,fs)))}_computeIntersections(e,t,i){let s;const r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,p=r.drawRange;if(o!==null)if(Array.isArray(a))for(let _=0,x=f.length;_<x;_++){const m=f[_],d=a[m.materialIndex],w=Math.max(m.start,p.start),T=Math.min(o.count,Math.min(m.start+m.count,p.start+p.count));for(let v=w,H=T;v<H;v+=3){const L=o.getX(v),D=o.getX(v+1),F=o.getX(v+2);s=qa(this,d,e,i,c,h,u,L,D,F),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,p.start),x=Math.min(o.count,p.start+p.count);for(let m=_,d=x;m<d;m+=3){const w=o.getX(m),T=o.getX(m+1),v=o.getX(m+2);s=qa(this,a,e,i,c,h,u,w,T,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let _=0,x=f.length;_<x;_++){const m=f[_],d=a[m.materialIndex],w=Math.max(m.start,p.start),T=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let v=w,H=T;v<H;v+=3){const L=v,D=v+1,F=v+2;s=qa(this,d,e,i,c,h,u,L,D,F),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let m=_,d=x;m<d;m+=3){const w=m,T=m+1,v=m+2;s=qa(this,a,e,i,c,h,u,w,T,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}}function Kv(n,e,t,i,s,r,a,o){let l;if(e.side===En?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,e.side===ts,o),l===null)return null;Xa.copy(o),Xa.applyMatrix4(n.matrixWorld);const c=t.ray.origin.distanceTo(Xa);return c<t.near||c>t.far?null:{distance:c,point:Xa.clone(),object:n}}function qa(n,e,t,i,s,r,a,o,l,c){n.getVertexPosition(o,Ha),n.getVertexPosition(l,Va),n.getVertexPosition(c,Ga);const h=Kv(n,e,t,i,Ha,Va,Ga,gf);if(h){const u=new ne;ei.getBarycoord(gf,Ha,Va,Ga,u),s&&(h.uv=ei.getInterpolatedAttribute(s,o,l,c,u,new Tt)),r&&(h.uv1=ei.getInterpolatedAttribute(r,o,l,c,u,new Tt)),a&&(h.normal=ei.getInterpolatedAttribute(a,o,l,c,u,new ne),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));const f={a:o,b:l,c,normal:new ne,materialIndex:0};ei.getNormal(Ha,Va,Ga,f.normal),h.face=f,h.barycoord=u}return h}class ma extends is{constructor(e=1,t=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const l=[],c=[],h=[],u=[];let f=0,p=0;_("z","y","x",-1,-1,i,t,e,a,r,0),_("z","y","x",1,-1,i,t,-e,a,r,1),_("x","z","y",1,1,e,i,t,s,a,2),_("x","z","y",1,-1,e,i,-t,s,a,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new As(c,3)),this.setAttribute("normal",new As(h,3)),this.setAttribute("uv",new As(u,2));function _(x,m,d,w,T,v,H,L,D,F,b){const y=v/D,P=H/F,Y=v/2,B=H/2,q=L/2,K=D+1,Z=F+1;let J=0,Q=0;const he=new ne;for(let ce=0;ce<Z;ce++){const me=ce*P-B;for(let Me=0;Me<K;Me++){const pe=Me*y-Y;he[x]=pe*w,he[m]=me*T,he[d]=q,c.push(he.x,he.y,he.z),he[x]=0,he[m]=0,he[d]=L>0?1:-1,h.push(he.x,he.y,he.z),u.push(Me/D),u.push(1-ce/F),J+=1}}for(let ce=0;ce<F;ce++)for(let me=0;me<D;me++){const Me=f+me+K*ce,pe=f+me+K*(ce+1),ie=f+(me+1)+K*(ce+1),oe=f+(me+1)+K*ce;l.push(Me,pe,oe),l.push(pe,ie,oe),Q+=6}o.addGroup(p,Q,b),p+=Q,f+=J}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new ma(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function Lr(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone():Array.isArray(s)?e[t][i]=s.slice():e[t][i]=s}}return e}function _n(n){const e={};for(let t=0;t<n.length;t++){const i=Lr(n[t]);for(const s in i)e[s]=i[s]}return e}function jv(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function yp(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ft.workingColorSpace}const Jv={clone:Lr,merge:_n};var Qv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ex=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ns extends Io{static get type(){return"ShaderMaterial"}constructor(e){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Qv,this.fragmentShader=ex,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Lr(e.uniforms),this.uniformsGroups=jv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}}class Ep extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Wt,this.projectionMatrix=new Wt,this.projectionMatrixInverse=new Wt,this.coordinateSystem=Ci}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const $i=new ne,_f=new Tt,vf=new Tt;class Jn extends Ep{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=Gc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(ul*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Gc*2*Math.atan(Math.tan(ul*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){$i.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($i.x,$i.y).multiplyScalar(-e/$i.z),$i.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set($i.x,$i.y).multiplyScalar(-e/$i.z)}getViewSize(e,t){return this.getViewBounds(e,_f,vf),t.subVectors(vf,_f)}setViewOffset(e,t,i,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(ul*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}const o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const lr=-90,cr=1;class tx extends Un{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Jn(lr,cr,e,t);s.layers=this.layers,this.add(s);const r=new Jn(lr,cr,e,t);r.layers=this.layers,this.add(r);const a=new Jn(lr,cr,e,t);a.layers=this.layers,this.add(a);const o=new Jn(lr,cr,e,t);o.layers=this.layers,this.add(o);const l=new Jn(lr,cr,e,t);l.layers=this.layers,this.add(l);const c=new Jn(lr,cr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,a,o,l]=t;for(const c of t)this.remove(c);if(e===Ci)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Mo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const x=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,e.setRenderTarget(i,0,s),e.render(t,r),e.setRenderTarget(i,1,s),e.render(t,a),e.setRenderTarget(i,2,s),e.render(t,o),e.setRenderTarget(i,3,s),e.render(t,l),e.setRenderTarget(i,4,s),e.render(t,c),i.texture.generateMipmaps=x,e.setRenderTarget(i,5,s),e.render(t,h),e.setRenderTarget(u,f,p),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}}class Tp extends Tn{constructor(e,t,i,s,r,a,o,l,c,h){e=e!==void 0?e:[],t=t!==void 0?t:Ar,super(e,t,i,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class nx extends Is{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Tp(s,t.mapping,t.wrapS,t.wrapT,t.magFilter,t.minFilter,t.format,t.type,t.anisotropy,t.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=t.generateMipmaps!==void 0?t.generateMipmaps:!1,this.texture.minFilter=t.minFilter!==void 0?t.minFilter:di}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ma(5,5,5),r=new ns({name:"CubemapFromEquirect",uniforms:Lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:En,blending:ji});r.uniforms.tEquirect.value=t;const a=new pi(s,r),o=t.minFilter;return t.minFilter===Ts&&(t.minFilter=di),new tx(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t,i,s){const r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,s);e.setRenderTarget(r)}}const Ll=new ne,ix=new ne,sx=new Je;class vs{constructor(e=new ne(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=Ll.subVectors(i,t).cross(ix.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const i=e.delta(Ll),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(i,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||sx.getNormalMatrix(e),s=this.coplanarPoint(Ll).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const ds=new gu,$a=new ne;class wp{constructor(e=new vs,t=new vs,i=new vs,s=new vs,r=new vs,a=new vs){this.planes=[e,t,i,s,r,a]}set(e,t,i,s,r,a){const o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ci){const i=this.planes,s=e.elements,r=s[0],a=s[1],o=s[2],l=s[3],c=s[4],h=s[5],u=s[6],f=s[7],p=s[8],_=s[9],x=s[10],m=s[11],d=s[12],w=s[13],T=s[14],v=s[15];if(i[0].setComponents(l-r,f-c,m-p,v-d).normalize(),i[1].setComponents(l+r,f+c,m+p,v+d).normalize(),i[2].setComponents(l+a,f+h,m+_,v+w).normalize(),i[3].setComponents(l-a,f-h,m-_,v-w).normalize(),i[4].setComponents(l-o,f-u,m-x,v-T).normalize(),t===Ci)i[5].setComponents(l+o,f+u,m+x,v+T).normalize();else if(t===Mo)i[5].setComponents(o,u,x,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ds.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ds.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ds)}intersectsSprite(e){return ds.center.set(0,0,0),ds.radius=.7071067811865476,ds.applyMatrix4(e.matrixWorld),this.intersectsSphere(ds)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if($a.x=s.normal.x>0?e.max.x:e.min.x,$a.y=s.normal.y>0?e.max.y:e.min.y,$a.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint($a)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function bp(){let n=null,e=!1,t=null,i=null;function s(r,a){t(r,a),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function rx(n){const e=new WeakMap;function t(o,l){const c=o.array,h=o.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),o.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function i(o,l,c){const h=l.array,u=l.updateRanges;if(n.bindBuffer(c,o),u.length===0)n.bufferSubData(c,0,h);else{u.sort((p,_)=>p.start-_.start);let f=0;for(let p=1;p<u.length;p++){const _=u[f],x=u[p];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++f,u[f]=x)}u.length=f+1;for(let p=0,_=u.length;p<_;p++){const x=u[p];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const l=e.get(o);l&&(n.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}class No extends is{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,a=t/2,o=Math.floor(i),l=Math.floor(s),c=o+1,h=l+1,u=e/o,f=t/l,p=[],_=[],x=[],m=[];for(let d=0;d<h;d++){const w=d*f-a;for(let T=0;T<c;T++){const v=T*u-r;_.push(v,-w,0),x.push(0,0,1),m.push(T/o),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let w=0;w<o;w++){const T=w+c*d,v=w+c*(d+1),H=w+1+c*(d+1),L=w+1+c*d;p.push(T,v,L),p.push(v,H,L)}this.setIndex(p),this.setAttribute("position",new As(_,3)),this.setAttribute("normal",new As(x,3)),this.setAttribute("uv",new As(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new No(e.width,e.height,e.widthSegments,e.heightSegments)}}var ax=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ox=`#ifdef USE_ALPHAHASH
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
#endif`,lx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,cx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ux=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,hx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,fx=`#ifdef USE_AOMAP
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
#endif`,dx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,px=`#ifdef USE_BATCHING
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
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,mx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,gx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,_x=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,vx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,xx=`#ifdef USE_IRIDESCENCE
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
#endif`,Mx=`#ifdef USE_BUMPMAP
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
#endif`,Sx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,yx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ex=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Tx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,wx=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,bx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Ax=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Rx=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,Cx=`#define PI 3.141592653589793
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
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
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
} // validated`,Px=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,Lx=`vec3 transformedNormal = objectNormal;
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
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,Dx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ux=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Ix=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Nx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Fx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ox=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Bx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,kx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,zx=`#ifdef USE_ENVMAP
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
#endif`,Hx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Vx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Gx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Wx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Xx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,qx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,$x=`#ifdef USE_GRADIENTMAP
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
}`,Yx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Zx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Kx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,jx=`uniform bool receiveShadow;
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
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
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
#endif`,Jx=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Qx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,eM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,tM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,nM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,iM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
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
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
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
#endif`,sM=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
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
		vec3 iridescenceF0;
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
		float v = 0.5 / ( gv + gl );
		return saturate(v);
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
		float roughness = material.clearcoatRoughness;
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
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
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
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
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
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
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
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
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
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,rM=`
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
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
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
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,aM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,oM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lM=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,cM=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,uM=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,hM=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,fM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,dM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,pM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,mM=`#if defined( USE_POINTS_UV )
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
#endif`,gM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,_M=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,vM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,xM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,MM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,SM=`#ifdef USE_MORPHTARGETS
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
#endif`,yM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,EM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,TM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,wM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,AM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,RM=`#ifdef USE_NORMALMAP
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
#endif`,CM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,PM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,LM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,DM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,UM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,IM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,NM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,FM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,OM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,BM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,kM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,zM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,HM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
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
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
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
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
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
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,VM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
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
#endif`,GM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
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
#endif`,WM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
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
	#if NUM_POINT_LIGHT_SHADOWS > 0
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
}`,XM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,qM=`#ifdef USE_SKINNING
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
#endif`,$M=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,YM=`#ifdef USE_SKINNING
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
#endif`,ZM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,KM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,jM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,JM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,QM=`#ifdef USE_TRANSMISSION
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
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,eS=`#ifdef USE_TRANSMISSION
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
#endif`,tS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,nS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,iS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const rS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,aS=`uniform sampler2D t2D;
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
}`,oS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lS=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hS=`#include <common>
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
}`,fS=`#if DEPTH_PACKING == 3200
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
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,dS=`#define DISTANCE
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
}`,pS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,mS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,gS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_S=`uniform float scale;
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
}`,vS=`uniform vec3 diffuse;
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
}`,xS=`#include <common>
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
}`,MS=`uniform vec3 diffuse;
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
}`,SS=`#define LAMBERT
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
}`,yS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
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
}`,ES=`#define MATCAP
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
}`,TS=`#define MATCAP
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
}`,wS=`#define NORMAL
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
}`,bS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
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
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,AS=`#define PHONG
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
}`,RS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
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
}`,CS=`#define STANDARD
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
}`,PS=`#define STANDARD
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
#ifdef USE_DISPERSION
	uniform float dispersion;
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
#include <packing>
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
#include <cube_uv_reflection_fragment>
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
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
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
}`,LS=`#define TOON
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
}`,DS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
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
}`,US=`uniform float size;
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
}`,IS=`uniform vec3 diffuse;
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
}`,NS=`#include <common>
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
}`,FS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
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
}`,OS=`uniform float rotation;
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
}`,BS=`uniform vec3 diffuse;
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
}`,et={alphahash_fragment:ax,alphahash_pars_fragment:ox,alphamap_fragment:lx,alphamap_pars_fragment:cx,alphatest_fragment:ux,alphatest_pars_fragment:hx,aomap_fragment:fx,aomap_pars_fragment:dx,batching_pars_vertex:px,batching_vertex:mx,begin_vertex:gx,beginnormal_vertex:_x,bsdfs:vx,iridescence_fragment:xx,bumpmap_pars_fragment:Mx,clipping_planes_fragment:Sx,clipping_planes_pars_fragment:yx,clipping_planes_pars_vertex:Ex,clipping_planes_vertex:Tx,color_fragment:wx,color_pars_fragment:bx,color_pars_vertex:Ax,color_vertex:Rx,common:Cx,cube_uv_reflection_fragment:Px,defaultnormal_vertex:Lx,displacementmap_pars_vertex:Dx,displacementmap_vertex:Ux,emissivemap_fragment:Ix,emissivemap_pars_fragment:Nx,colorspace_fragment:Fx,colorspace_pars_fragment:Ox,envmap_fragment:Bx,envmap_common_pars_fragment:kx,envmap_pars_fragment:zx,envmap_pars_vertex:Hx,envmap_physical_pars_fragment:Jx,envmap_vertex:Vx,fog_vertex:Gx,fog_pars_vertex:Wx,fog_fragment:Xx,fog_pars_fragment:qx,gradientmap_pars_fragment:$x,lightmap_pars_fragment:Yx,lights_lambert_fragment:Zx,lights_lambert_pars_fragment:Kx,lights_pars_begin:jx,lights_toon_fragment:Qx,lights_toon_pars_fragment:eM,lights_phong_fragment:tM,lights_phong_pars_fragment:nM,lights_physical_fragment:iM,lights_physical_pars_fragment:sM,lights_fragment_begin:rM,lights_fragment_maps:aM,lights_fragment_end:oM,logdepthbuf_fragment:lM,logdepthbuf_pars_fragment:cM,logdepthbuf_pars_vertex:uM,logdepthbuf_vertex:hM,map_fragment:fM,map_pars_fragment:dM,map_particle_fragment:pM,map_particle_pars_fragment:mM,metalnessmap_fragment:gM,metalnessmap_pars_fragment:_M,morphinstance_vertex:vM,morphcolor_vertex:xM,morphnormal_vertex:MM,morphtarget_pars_vertex:SM,morphtarget_vertex:yM,normal_fragment_begin:EM,normal_fragment_maps:TM,normal_pars_fragment:wM,normal_pars_vertex:bM,normal_vertex:AM,normalmap_pars_fragment:RM,clearcoat_normal_fragment_begin:CM,clearcoat_normal_fragment_maps:PM,clearcoat_pars_fragment:LM,iridescence_pars_fragment:DM,opaque_fragment:UM,packing:IM,premultiplied_alpha_fragment:NM,project_vertex:FM,dithering_fragment:OM,dithering_pars_fragment:BM,roughnessmap_fragment:kM,roughnessmap_pars_fragment:zM,shadowmap_pars_fragment:HM,shadowmap_pars_vertex:VM,shadowmap_vertex:GM,shadowmask_pars_fragment:WM,skinbase_vertex:XM,skinning_pars_vertex:qM,skinning_vertex:$M,skinnormal_vertex:YM,specularmap_fragment:ZM,specularmap_pars_fragment:KM,tonemapping_fragment:jM,tonemapping_pars_fragment:JM,transmission_fragment:QM,transmission_pars_fragment:eS,uv_pars_fragment:tS,uv_pars_vertex:nS,uv_vertex:iS,worldpos_vertex:sS,background_vert:rS,background_frag:aS,backgroundCube_vert:oS,backgroundCube_frag:lS,cube_vert:cS,cube_frag:uS,depth_vert:hS,depth_frag:fS,distanceRGBA_vert:dS,distanceRGBA_frag:pS,equirect_vert:mS,equirect_frag:gS,linedashed_vert:_S,linedashed_frag:vS,meshbasic_vert:xS,meshbasic_frag:MS,meshlambert_vert:SS,meshlambert_frag:yS,meshmatcap_vert:ES,meshmatcap_frag:TS,meshnormal_vert:wS,meshnormal_frag:bS,meshphong_vert:AS,meshphong_frag:RS,meshphysical_vert:CS,meshphysical_frag:PS,meshtoon_vert:LS,meshtoon_frag:DS,points_vert:US,points_frag:IS,shadow_vert:NS,shadow_frag:FS,sprite_vert:OS,sprite_frag:BS},Te={common:{diffuse:{value:new Et(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Je},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Je}},envmap:{envMap:{value:null},envMapRotation:{value:new Je},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Je}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Je}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Je},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Je},normalScale:{value:new Tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Je},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Je}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Je}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Je}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Et(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Et(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0},uvTransform:{value:new Je}},sprite:{diffuse:{value:new Et(16777215)},opacity:{value:1},center:{value:new Tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Je},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0}}},hi={basic:{uniforms:_n([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.fog]),vertexShader:et.meshbasic_vert,fragmentShader:et.meshbasic_frag},lambert:{uniforms:_n([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new Et(0)}}]),vertexShader:et.meshlambert_vert,fragmentShader:et.meshlambert_frag},phong:{uniforms:_n([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new Et(0)},specular:{value:new Et(1118481)},shininess:{value:30}}]),vertexShader:et.meshphong_vert,fragmentShader:et.meshphong_frag},standard:{uniforms:_n([Te.common,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.roughnessmap,Te.metalnessmap,Te.fog,Te.lights,{emissive:{value:new Et(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:et.meshphysical_vert,fragmentShader:et.meshphysical_frag},toon:{uniforms:_n([Te.common,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.gradientmap,Te.fog,Te.lights,{emissive:{value:new Et(0)}}]),vertexShader:et.meshtoon_vert,fragmentShader:et.meshtoon_frag},matcap:{uniforms:_n([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,{matcap:{value:null}}]),vertexShader:et.meshmatcap_vert,fragmentShader:et.meshmatcap_frag},points:{uniforms:_n([Te.points,Te.fog]),vertexShader:et.points_vert,fragmentShader:et.points_frag},dashed:{uniforms:_n([Te.common,Te.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:et.linedashed_vert,fragmentShader:et.linedashed_frag},depth:{uniforms:_n([Te.common,Te.displacementmap]),vertexShader:et.depth_vert,fragmentShader:et.depth_frag},normal:{uniforms:_n([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,{opacity:{value:1}}]),vertexShader:et.meshnormal_vert,fragmentShader:et.meshnormal_frag},sprite:{uniforms:_n([Te.sprite,Te.fog]),vertexShader:et.sprite_vert,fragmentShader:et.sprite_frag},background:{uniforms:{uvTransform:{value:new Je},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:et.background_vert,fragmentShader:et.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Je}},vertexShader:et.backgroundCube_vert,fragmentShader:et.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:et.cube_vert,fragmentShader:et.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:et.equirect_vert,fragmentShader:et.equirect_frag},distanceRGBA:{uniforms:_n([Te.common,Te.displacementmap,{referencePosition:{value:new ne},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:et.distanceRGBA_vert,fragmentShader:et.distanceRGBA_frag},shadow:{uniforms:_n([Te.lights,Te.fog,{color:{value:new Et(0)},opacity:{value:1}}]),vertexShader:et.shadow_vert,fragmentShader:et.shadow_frag}};hi.physical={uniforms:_n([hi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Je},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Je},clearcoatNormalScale:{value:new Tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Je},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Je},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Je},sheen:{value:0},sheenColor:{value:new Et(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Je},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Je},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Je},transmissionSamplerSize:{value:new Tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Je},attenuationDistance:{value:0},attenuationColor:{value:new Et(0)},specularColor:{value:new Et(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Je},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Je},anisotropyVector:{value:new Tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Je}}]),vertexShader:et.meshphysical_vert,fragmentShader:et.meshphysical_frag};const Ya={r:0,b:0,g:0},ps=new Fi,kS=new Wt;function zS(n,e,t,i,s,r,a){const o=new Et(0);let l=r===!0?0:1,c,h,u=null,f=0,p=null;function _(w){let T=w.isScene===!0?w.background:null;return T&&T.isTexture&&(T=(w.backgroundBlurriness>0?t:e).get(T)),T}function x(w){let T=!1;const v=_(w);v===null?d(o,l):v&&v.isColor&&(d(v,1),T=!0);const H=n.xr.getEnvironmentBlendMode();H==="additive"?i.buffers.color.setClear(0,0,0,1,a):H==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,a),(n.autoClear||T)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(w,T){const v=_(T);v&&(v.isCubeTexture||v.mapping===Do)?(h===void 0&&(h=new pi(new ma(1,1,1),new ns({name:"BackgroundCubeMaterial",uniforms:Lr(hi.backgroundCube.uniforms),vertexShader:hi.backgroundCube.vertexShader,fragmentShader:hi.backgroundCube.fragmentShader,side:En,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(H,L,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),ps.copy(T.backgroundRotation),ps.x*=-1,ps.y*=-1,ps.z*=-1,v.isCubeTexture&&v.isRenderTargetTexture===!1&&(ps.y*=-1,ps.z*=-1),h.material.uniforms.envMap.value=v,h.material.uniforms.flipEnvMap.value=v.isCubeTexture&&v.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(kS.makeRotationFromEuler(ps)),h.material.toneMapped=ft.getTransfer(v.colorSpace)!==yt,(u!==v||f!==v.version||p!==n.toneMapping)&&(h.material.needsUpdate=!0,u=v,f=v.version,p=n.toneMapping),h.layers.enableAll(),w.unshift(h,h.geometry,h.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new pi(new No(2,2),new ns({name:"BackgroundMaterial",uniforms:Lr(hi.background.uniforms),vertexShader:hi.background.vertexShader,fragmentShader:hi.background.fragmentShader,side:ts,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=ft.getTransfer(v.colorSpace)!==yt,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||f!==v.version||p!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,f=v.version,p=n.toneMapping),c.layers.enableAll(),w.unshift(c,c.geometry,c.material,0,0,null))}function d(w,T){w.getRGB(Ya,yp(n)),i.buffers.color.setClear(Ya.r,Ya.g,Ya.b,T,a)}return{getClearColor:function(){return o},setClearColor:function(w,T=1){o.set(w),l=T,d(o,l)},getClearAlpha:function(){return l},setClearAlpha:function(w){l=w,d(o,l)},render:x,addToRenderList:m}}function HS(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null);let r=s,a=!1;function o(y,P,Y,B,q){let K=!1;const Z=u(B,Y,P);r!==Z&&(r=Z,c(r.object)),K=p(y,B,Y,q),K&&_(y,B,Y,q),q!==null&&e.update(q,n.ELEMENT_ARRAY_BUFFER),(K||a)&&(a=!1,v(y,P,Y,B),q!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(q).buffer))}function l(){return n.createVertexArray()}function c(y){return n.bindVertexArray(y)}function h(y){return n.deleteVertexArray(y)}function u(y,P,Y){const B=Y.wireframe===!0;let q=i[y.id];q===void 0&&(q={},i[y.id]=q);let K=q[P.id];K===void 0&&(K={},q[P.id]=K);let Z=K[B];return Z===void 0&&(Z=f(l()),K[B]=Z),Z}function f(y){const P=[],Y=[],B=[];for(let q=0;q<t;q++)P[q]=0,Y[q]=0,B[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:P,enabledAttributes:Y,attributeDivisors:B,object:y,attributes:{},index:null}}function p(y,P,Y,B){const q=r.attributes,K=P.attributes;let Z=0;const J=Y.getAttributes();for(const Q in J)if(J[Q].location>=0){const ce=q[Q];let me=K[Q];if(me===void 0&&(Q==="instanceMatrix"&&y.instanceMatrix&&(me=y.instanceMatrix),Q==="instanceColor"&&y.instanceColor&&(me=y.instanceColor)),ce===void 0||ce.attribute!==me||me&&ce.data!==me.data)return!0;Z++}return r.attributesNum!==Z||r.index!==B}function _(y,P,Y,B){const q={},K=P.attributes;let Z=0;const J=Y.getAttributes();for(const Q in J)if(J[Q].location>=0){let ce=K[Q];ce===void 0&&(Q==="instanceMatrix"&&y.instanceMatrix&&(ce=y.instanceMatrix),Q==="instanceColor"&&y.instanceColor&&(ce=y.instanceColor));const me={};me.attribute=ce,ce&&ce.data&&(me.data=ce.data),q[Q]=me,Z++}r.attributes=q,r.attributesNum=Z,r.index=B}function x(){const y=r.newAttributes;for(let P=0,Y=y.length;P<Y;P++)y[P]=0}function m(y){d(y,0)}function d(y,P){const Y=r.newAttributes,B=r.enabledAttributes,q=r.attributeDivisors;Y[y]=1,B[y]===0&&(n.enableVertexAttribArray(y),B[y]=1),q[y]!==P&&(n.vertexAttribDivisor(y,P),q[y]=P)}function w(){const y=r.newAttributes,P=r.enabledAttributes;for(let Y=0,B=P.length;Y<B;Y++)P[Y]!==y[Y]&&(n.disableVertexAttribArray(Y),P[Y]=0)}function T(y,P,Y,B,q,K,Z){Z===!0?n.vertexAttribIPointer(y,P,Y,q,K):n.vertexAttribPointer(y,P,Y,B,q,K)}function v(y,P,Y,B){x();const q=B.attributes,K=Y.getAttributes(),Z=P.defaultAttributeValues;for(const J in K){const Q=K[J];if(Q.location>=0){let he=q[J];if(he===void 0&&(J==="instanceMatrix"&&y.instanceMatrix&&(he=y.instanceMatrix),J==="instanceColor"&&y.instanceColor&&(he=y.instanceColor)),he!==void 0){const ce=he.normalized,me=he.itemSize,Me=e.get(he);if(Me===void 0)continue;const pe=Me.buffer,ie=Me.type,oe=Me.bytesPerElement,ge=ie===n.INT||ie===n.UNSIGNED_INT||he.gpuType===uu;if(he.isInterleavedBufferAttribute){const ae=he.data,ke=ae.stride,He=he.offset;if(ae.isInstancedInterleavedBuffer){for(let Ie=0;Ie<Q.locationSize;Ie++)d(Q.location+Ie,ae.meshPerAttribute);y.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let Ie=0;Ie<Q.locationSize;Ie++)m(Q.location+Ie);n.bindBuffer(n.ARRAY_BUFFER,pe);for(let Ie=0;Ie<Q.locationSize;Ie++)T(Q.location+Ie,me/Q.locationSize,ie,ce,ke*oe,(He+me/Q.locationSize*Ie)*oe,ge)}else{if(he.isInstancedBufferAttribute){for(let ae=0;ae<Q.locationSize;ae++)d(Q.location+ae,he.meshPerAttribute);y.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=he.meshPerAttribute*he.count)}else for(let ae=0;ae<Q.locationSize;ae++)m(Q.location+ae);n.bindBuffer(n.ARRAY_BUFFER,pe);for(let ae=0;ae<Q.locationSize;ae++)T(Q.location+ae,me/Q.locationSize,ie,ce,me*oe,me/Q.locationSize*ae*oe,ge)}}else if(Z!==void 0){const ce=Z[J];if(ce!==void 0)switch(ce.length){case 2:n.vertexAttrib2fv(Q.location,ce);break;case 3:n.vertexAttrib3fv(Q.location,ce);break;case 4:n.vertexAttrib4fv(Q.location,ce);break;default:n.vertexAttrib1fv(Q.location,ce)}}}}w()}function H(){F();for(const y in i){const P=i[y];for(const Y in P){const B=P[Y];for(const q in B)h(B[q].object),delete B[q];delete P[Y]}delete i[y]}}function L(y){if(i[y.id]===void 0)return;const P=i[y.id];for(const Y in P){const B=P[Y];for(const q in B)h(B[q].object),delete B[q];delete P[Y]}delete i[y.id]}function D(y){for(const P in i){const Y=i[P];if(Y[y.id]===void 0)continue;const B=Y[y.id];for(const q in B)h(B[q].object),delete B[q];delete Y[y.id]}}function F(){b(),a=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:F,resetDefaultState:b,dispose:H,releaseStatesOfGeometry:L,releaseStatesOfProgram:D,initAttributes:x,enableAttribute:m,disableUnusedAttributes:w}}function VS(n,e,t){let i;function s(c){i=c}function r(c,h){n.drawArrays(i,c,h),t.update(h,i,1)}function a(c,h,u){u!==0&&(n.drawArraysInstanced(i,c,h,u),t.update(h,i,u))}function o(c,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,h,0,u);let p=0;for(let _=0;_<u;_++)p+=h[_];t.update(p,i,1)}function l(c,h,u,f){if(u===0)return;const p=e.get("WEBGL_multi_draw");if(p===null)for(let _=0;_<c.length;_++)a(c[_],h[_],f[_]);else{p.multiDrawArraysInstancedWEBGL(i,c,0,h,0,f,0,u);let _=0;for(let x=0;x<u;x++)_+=h[x]*f[x];t.update(_,i,1)}}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o,this.renderMultiDrawInstances=l}function GS(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const D=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(D){return!(D!==ti&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(D){const F=D===ha&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==Ni&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ri&&!F)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=t.logarithmicDepthBuffer===!0,f=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),w=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),H=_>0,L=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:f,maxTextures:p,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:w,maxVaryings:T,maxFragmentUniforms:v,vertexTextures:H,maxSamples:L}}function WS(n){const e=this;let t=null,i=0,s=!1,r=!1;const a=new vs,o=new Je,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){const p=u.length!==0||f||i!==0||s;return s=f,i=u.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,p){const _=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,d=n.get(u);if(!s||_===null||_.length===0||r&&!m)r?h(null):c();else{const w=r?0:i,T=w*4;let v=d.clippingState||null;l.value=v,v=h(_,f,T,p);for(let H=0;H!==T;++H)v[H]=t[H];d.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=w}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(u,f,p,_){const x=u!==null?u.length:0;let m=null;if(x!==0){if(m=l.value,_!==!0||m===null){const d=p+x*4,w=f.matrixWorldInverse;o.getNormalMatrix(w),(m===null||m.length<d)&&(m=new Float32Array(d));for(let T=0,v=p;T!==x;++T,v+=4)a.copy(u[T]).applyMatrix4(w,o),a.normal.toArray(m,v),m[v+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}function XS(n){let e=new WeakMap;function t(a,o){return o===dc?a.mapping=Ar:o===pc&&(a.mapping=Rr),a}function i(a){if(a&&a.isTexture){const o=a.mapping;if(o===dc||o===pc)if(e.has(a)){const l=e.get(a).texture;return t(l,a.mapping)}else{const l=a.image;if(l&&l.height>0){const c=new nx(l.height);return c.fromEquirectangularTexture(n,a),e.set(a,c),a.addEventListener("dispose",s),t(c.texture,a.mapping)}else return null}}return a}function s(a){const o=a.target;o.removeEventListener("dispose",s);const l=e.get(o);l!==void 0&&(e.delete(o),l.dispose())}function r(){e=new WeakMap}return{get:i,dispose:r}}class Ap extends Ep{constructor(e=-1,t=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,a=i+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const dr=4,xf=[.125,.215,.35,.446,.526,.582],ys=20,Dl=new Ap,Mf=new Et;let Ul=null,Il=0,Nl=0,Fl=!1;const xs=(1+Math.sqrt(5))/2,ur=1/xs,Sf=[new ne(-xs,ur,0),new ne(xs,ur,0),new ne(-ur,0,xs),new ne(ur,0,xs),new ne(0,xs,-ur),new ne(0,xs,ur),new ne(-1,1,-1),new ne(1,1,-1),new ne(-1,1,1),new ne(1,1,1)];class yf{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,i=.1,s=100){Ul=this._renderer.getRenderTarget(),Il=this._renderer.getActiveCubeFace(),Nl=this._renderer.getActiveMipmapLevel(),Fl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(e,i,s,r),t>0&&this._blur(r,0,0,t),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=wf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Tf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Ul,Il,Nl),this._renderer.xr.enabled=Fl,e.scissorTest=!1,Za(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===Ar||e.mapping===Rr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Ul=this._renderer.getRenderTarget(),Il=this._renderer.getActiveCubeFace(),Nl=this._renderer.getActiveMipmapLevel(),Fl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:di,minFilter:di,generateMipmaps:!1,type:ha,format:ti,colorSpace:Os,depthBuffer:!1},s=Ef(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Ef(e,t,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=qS(r)),this._blurMaterial=$S(r,e,t)}return s}_compileMaterial(e){const t=new pi(this._lodPlanes[0],e);this._renderer.compile(t,Dl)}_sceneToCubeUV(e,t,i,s){const o=new Jn(90,1,t,i),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,f=h.toneMapping;h.getClearColor(Mf),h.toneMapping=Ji,h.autoClear=!1;const p=new _u({name:"PMREM.Background",side:En,depthWrite:!1,depthTest:!1}),_=new pi(new ma,p);let x=!1;const m=e.background;m?m.isColor&&(p.color.copy(m),e.background=null,x=!0):(p.color.copy(Mf),x=!0);for(let d=0;d<6;d++){const w=d%3;w===0?(o.up.set(0,l[d],0),o.lookAt(c[d],0,0)):w===1?(o.up.set(0,0,l[d]),o.lookAt(0,c[d],0)):(o.up.set(0,l[d],0),o.lookAt(0,0,c[d]));const T=this._cubeSize;Za(s,w*T,d>2?T:0,T,T),h.setRenderTarget(s),x&&h.render(_,o),h.render(e,o)}_.geometry.dispose(),_.material.dispose(),h.toneMapping=f,h.autoClear=u,e.background=m}_textureToCubeUV(e,t){const i=this._renderer,s=e.mapping===Ar||e.mapping===Rr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=wf()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Tf());const r=s?this._cubemapMaterial:this._equirectMaterial,a=new pi(this._lodPlanes[0],r),o=r.uniforms;o.envMap.value=e;const l=this._cubeSize;Za(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(a,Dl)}_applyPMREM(e){const t=this._renderer,i=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const a=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),o=Sf[(s-r-1)%Sf.length];this._blur(e,r-1,r,a,o)}t.autoClear=i}_blur(e,t,i,s,r){const a=this._pingPongRenderTarget;this._halfBlur(e,a,t,i,s,"latitudinal",r),this._halfBlur(a,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,a,o){const l=this._renderer,c=this._blurMaterial;a!=="latitudinal"&&a!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new pi(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[i]-1,_=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*ys-1),x=r/_,m=isFinite(r)?1+Math.floor(h*x):ys;m>ys&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${ys}`);const d=[];let w=0;for(let D=0;D<ys;++D){const F=D/x,b=Math.exp(-F*F/2);d.push(b),D===0?w+=b:D<m&&(w+=2*b)}for(let D=0;D<d.length;D++)d[D]=d[D]/w;f.envMap.value=e.texture,f.samples.value=m,f.weights.value=d,f.latitudinal.value=a==="latitudinal",o&&(f.poleAxis.value=o);const{_lodMax:T}=this;f.dTheta.value=_,f.mipInt.value=T-i;const v=this._sizeLods[s],H=3*v*(s>T-dr?s-T+dr:0),L=4*(this._cubeSize-v);Za(t,H,L,3*v,2*v),l.setRenderTarget(t),l.render(u,Dl)}}function qS(n){const e=[],t=[],i=[];let s=n;const r=n-dr+1+xf.length;for(let a=0;a<r;a++){const o=Math.pow(2,s);t.push(o);let l=1/o;a>n-dr?l=xf[a-n+dr-1]:a===0&&(l=0),i.push(l);const c=1/(o-2),h=-c,u=1+c,f=[h,h,u,h,u,u,h,h,u,u,h,u],p=6,_=6,x=3,m=2,d=1,w=new Float32Array(x*_*p),T=new Float32Array(m*_*p),v=new Float32Array(d*_*p);for(let L=0;L<p;L++){const D=L%3*2/3-1,F=L>2?0:-1,b=[D,F,0,D+2/3,F,0,D+2/3,F+1,0,D,F,0,D+2/3,F+1,0,D,F+1,0];w.set(b,x*_*L),T.set(f,m*_*L);const y=[L,L,L,L,L,L];v.set(y,d*_*L)}const H=new is;H.setAttribute("position",new Vn(w,x)),H.setAttribute("uv",new Vn(T,m)),H.setAttribute("faceIndex",new Vn(v,d)),e.push(H),s>dr&&s--}return{lodPlanes:e,sizeLods:t,sigmas:i}}function Ef(n,e,t){const i=new Is(n,e,t);return i.texture.mapping=Do,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Za(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function $S(n,e,t){const i=new Float32Array(ys),s=new ne(0,1,0);return new ns({name:"SphericalGaussianBlur",defines:{n:ys,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:vu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ji,depthTest:!1,depthWrite:!1})}function Tf(){return new ns({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:vu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ji,depthTest:!1,depthWrite:!1})}function wf(){return new ns({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:vu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ji,depthTest:!1,depthWrite:!1})}function vu(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function YS(n){let e=new WeakMap,t=null;function i(o){if(o&&o.isTexture){const l=o.mapping,c=l===dc||l===pc,h=l===Ar||l===Rr;if(c||h){let u=e.get(o);const f=u!==void 0?u.texture.pmremVersion:0;if(o.isRenderTargetTexture&&o.pmremVersion!==f)return t===null&&(t=new yf(n)),u=c?t.fromEquirectangular(o,u):t.fromCubemap(o,u),u.texture.pmremVersion=o.pmremVersion,e.set(o,u),u.texture;if(u!==void 0)return u.texture;{const p=o.image;return c&&p&&p.height>0||h&&p&&s(p)?(t===null&&(t=new yf(n)),u=c?t.fromEquirectangular(o):t.fromCubemap(o),u.texture.pmremVersion=o.pmremVersion,e.set(o,u),o.addEventListener("dispose",r),u.texture):null}}}return o}function s(o){let l=0;const c=6;for(let h=0;h<c;h++)o[h]!==void 0&&l++;return l===c}function r(o){const l=o.target;l.removeEventListener("dispose",r);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function a(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:i,dispose:a}}function ZS(n){const e={};function t(i){if(e[i]!==void 0)return e[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&Qr("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function KS(n,e,t,i){const s={},r=new WeakMap;function a(u){const f=u.target;f.index!==null&&e.remove(f.index);for(const _ in f.attributes)e.remove(f.attributes[_]);for(const _ in f.morphAttributes){const x=f.morphAttributes[_];for(let m=0,d=x.length;m<d;m++)e.remove(x[m])}f.removeEventListener("dispose",a),delete s[f.id];const p=r.get(f);p&&(e.remove(p),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function o(u,f){return s[f.id]===!0||(f.addEventListener("dispose",a),s[f.id]=!0,t.memory.geometries++),f}function l(u){const f=u.attributes;for(const _ in f)e.update(f[_],n.ARRAY_BUFFER);const p=u.morphAttributes;for(const _ in p){const x=p[_];for(let m=0,d=x.length;m<d;m++)e.update(x[m],n.ARRAY_BUFFER)}}function c(u){const f=[],p=u.index,_=u.attributes.position;let x=0;if(p!==null){const w=p.array;x=p.version;for(let T=0,v=w.length;T<v;T+=3){const H=w[T+0],L=w[T+1],D=w[T+2];f.push(H,L,L,D,D,H)}}else if(_!==void 0){const w=_.array;x=_.version;for(let T=0,v=w.length/3-1;T<v;T+=3){const H=T+0,L=T+1,D=T+2;f.push(H,L,L,D,D,H)}}else return;const m=new(mp(f)?Sp:Mp)(f,1);m.version=x;const d=r.get(u);d&&e.remove(d),r.set(u,m)}function h(u){const f=r.get(u);if(f){const p=u.index;p!==null&&f.version<p.version&&c(u)}else c(u);return r.get(u)}return{get:o,update:l,getWireframeAttribute:h}}function jS(n,e,t){let i;function s(f){i=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function l(f,p){n.drawElements(i,p,r,f*a),t.update(p,i,1)}function c(f,p,_){_!==0&&(n.drawElementsInstanced(i,p,r,f*a,_),t.update(p,i,_))}function h(f,p,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,p,0,r,f,0,_);let m=0;for(let d=0;d<_;d++)m+=p[d];t.update(m,i,1)}function u(f,p,_,x){if(_===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let d=0;d<f.length;d++)c(f[d]/a,p[d],x[d]);else{m.multiDrawElementsInstancedWEBGL(i,p,0,r,f,0,x,0,_);let d=0;for(let w=0;w<_;w++)d+=p[w]*x[w];t.update(d,i,1)}}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function JS(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(r/3);break;case n.LINES:t.lines+=o*(r/2);break;case n.LINE_STRIP:t.lines+=o*(r-1);break;case n.LINE_LOOP:t.lines+=o*r;break;case n.POINTS:t.points+=o*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function QS(n,e,t){const i=new WeakMap,s=new zt;function r(a,o,l){const c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0;let f=i.get(o);if(f===void 0||f.count!==u){let b=function(){D.dispose(),i.delete(o),o.removeEventListener("dispose",b)};f!==void 0&&f.texture.dispose();const p=o.morphAttributes.position!==void 0,_=o.morphAttributes.normal!==void 0,x=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],d=o.morphAttributes.normal||[],w=o.morphAttributes.color||[];let T=0;p===!0&&(T=1),_===!0&&(T=2),x===!0&&(T=3);let v=o.attributes.position.count*T,H=1;v>e.maxTextureSize&&(H=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);const L=new Float32Array(v*H*4*u),D=new _p(L,v,H,u);D.type=Ri,D.needsUpdate=!0;const F=T*4;for(let y=0;y<u;y++){const P=m[y],Y=d[y],B=w[y],q=v*H*4*y;for(let K=0;K<P.count;K++){const Z=K*F;p===!0&&(s.fromBufferAttribute(P,K),L[q+Z+0]=s.x,L[q+Z+1]=s.y,L[q+Z+2]=s.z,L[q+Z+3]=0),_===!0&&(s.fromBufferAttribute(Y,K),L[q+Z+4]=s.x,L[q+Z+5]=s.y,L[q+Z+6]=s.z,L[q+Z+7]=0),x===!0&&(s.fromBufferAttribute(B,K),L[q+Z+8]=s.x,L[q+Z+9]=s.y,L[q+Z+10]=s.z,L[q+Z+11]=B.itemSize===4?s.w:1)}}f={count:u,texture:D,size:new Tt(v,H)},i.set(o,f),o.addEventListener("dispose",b)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];const _=o.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function ey(n,e,t,i){let s=new WeakMap;function r(l){const c=i.render.frame,h=l.geometry,u=e.get(l,h);if(s.get(u)!==c&&(e.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",o)===!1&&l.addEventListener("dispose",o),s.get(l)!==c&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return u}function a(){s=new WeakMap}function o(l){const c=l.target;c.removeEventListener("dispose",o),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:a}}class Rp extends Tn{constructor(e,t,i,s,r,a,o,l,c,h=_r){if(h!==_r&&h!==Pr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&h===_r&&(i=Us),i===void 0&&h===Pr&&(i=Cr),super(null,s,r,a,o,l,h,i,c),this.isDepthTexture=!0,this.image={width:e,height:t},this.magFilter=o!==void 0?o:ni,this.minFilter=l!==void 0?l:ni,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}const Cp=new Tn,bf=new Rp(1,1),Pp=new _p,Lp=new kv,Dp=new Tp,Af=[],Rf=[],Cf=new Float32Array(16),Pf=new Float32Array(9),Lf=new Float32Array(4);function Fr(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=Af[s];if(r===void 0&&(r=new Float32Array(s),Af[s]=r),e!==0){i.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(r,o)}return r}function Zt(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Kt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Fo(n,e){let t=Rf[e];t===void 0&&(t=new Int32Array(e),Rf[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function ty(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function ny(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Zt(t,e))return;n.uniform2fv(this.addr,e),Kt(t,e)}}function iy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Zt(t,e))return;n.uniform3fv(this.addr,e),Kt(t,e)}}function sy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Zt(t,e))return;n.uniform4fv(this.addr,e),Kt(t,e)}}function ry(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Zt(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Kt(t,e)}else{if(Zt(t,i))return;Lf.set(i),n.uniformMatrix2fv(this.addr,!1,Lf),Kt(t,i)}}function ay(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Zt(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Kt(t,e)}else{if(Zt(t,i))return;Pf.set(i),n.uniformMatrix3fv(this.addr,!1,Pf),Kt(t,i)}}function oy(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Zt(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Kt(t,e)}else{if(Zt(t,i))return;Cf.set(i),n.uniformMatrix4fv(this.addr,!1,Cf),Kt(t,i)}}function ly(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function cy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Zt(t,e))return;n.uniform2iv(this.addr,e),Kt(t,e)}}function uy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Zt(t,e))return;n.uniform3iv(this.addr,e),Kt(t,e)}}function hy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Zt(t,e))return;n.uniform4iv(this.addr,e),Kt(t,e)}}function fy(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function dy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Zt(t,e))return;n.uniform2uiv(this.addr,e),Kt(t,e)}}function py(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Zt(t,e))return;n.uniform3uiv(this.addr,e),Kt(t,e)}}function my(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Zt(t,e))return;n.uniform4uiv(this.addr,e),Kt(t,e)}}function gy(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(bf.compareFunction=pp,r=bf):r=Cp,t.setTexture2D(e||r,s)}function _y(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Lp,s)}function vy(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||Dp,s)}function xy(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Pp,s)}function My(n){switch(n){case 5126:return ty;case 35664:return ny;case 35665:return iy;case 35666:return sy;case 35674:return ry;case 35675:return ay;case 35676:return oy;case 5124:case 35670:return ly;case 35667:case 35671:return cy;case 35668:case 35672:return uy;case 35669:case 35673:return hy;case 5125:return fy;case 36294:return dy;case 36295:return py;case 36296:return my;case 35678:case 36198:case 36298:case 36306:case 35682:return gy;case 35679:case 36299:case 36307:return _y;case 35680:case 36300:case 36308:case 36293:return vy;case 36289:case 36303:case 36311:case 36292:return xy}}function Sy(n,e){n.uniform1fv(this.addr,e)}function yy(n,e){const t=Fr(e,this.size,2);n.uniform2fv(this.addr,t)}function Ey(n,e){const t=Fr(e,this.size,3);n.uniform3fv(this.addr,t)}function Ty(n,e){const t=Fr(e,this.size,4);n.uniform4fv(this.addr,t)}function wy(n,e){const t=Fr(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function by(n,e){const t=Fr(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Ay(n,e){const t=Fr(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Ry(n,e){n.uniform1iv(this.addr,e)}function Cy(n,e){n.uniform2iv(this.addr,e)}function Py(n,e){n.uniform3iv(this.addr,e)}function Ly(n,e){n.uniform4iv(this.addr,e)}function Dy(n,e){n.uniform1uiv(this.addr,e)}function Uy(n,e){n.uniform2uiv(this.addr,e)}function Iy(n,e){n.uniform3uiv(this.addr,e)}function Ny(n,e){n.uniform4uiv(this.addr,e)}function Fy(n,e,t){const i=this.cache,s=e.length,r=Fo(t,s);Zt(i,r)||(n.uniform1iv(this.addr,r),Kt(i,r));for(let a=0;a!==s;++a)t.setTexture2D(e[a]||Cp,r[a])}function Oy(n,e,t){const i=this.cache,s=e.length,r=Fo(t,s);Zt(i,r)||(n.uniform1iv(this.addr,r),Kt(i,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Lp,r[a])}function By(n,e,t){const i=this.cache,s=e.length,r=Fo(t,s);Zt(i,r)||(n.uniform1iv(this.addr,r),Kt(i,r));for(let a=0;a!==s;++a)t.setTextureCube(e[a]||Dp,r[a])}function ky(n,e,t){const i=this.cache,s=e.length,r=Fo(t,s);Zt(i,r)||(n.uniform1iv(this.addr,r),Kt(i,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Pp,r[a])}function zy(n){switch(n){case 5126:return Sy;case 35664:return yy;case 35665:return Ey;case 35666:return Ty;case 35674:return wy;case 35675:return by;case 35676:return Ay;case 5124:case 35670:return Ry;case 35667:case 35671:return Cy;case 35668:case 35672:return Py;case 35669:case 35673:return Ly;case 5125:return Dy;case 36294:return Uy;case 36295:return Iy;case 36296:return Ny;case 35678:case 36198:case 36298:case 36306:case 35682:return Fy;case 35679:case 36299:case 36307:return Oy;case 35680:case 36300:case 36308:case 36293:return By;case 36289:case 36303:case 36311:case 36292:return ky}}class Hy{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=My(t.type)}}class Vy{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=zy(t.type)}}class Gy{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(e,t[o.id],i)}}}const Ol=/(\w+)(\])?(\[|\.)?/g;function Df(n,e){n.seq.push(e),n.map[e.id]=e}function Wy(n,e,t){const i=n.name,s=i.length;for(Ol.lastIndex=0;;){const r=Ol.exec(i),a=Ol.lastIndex;let o=r[1];const l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Df(t,c===void 0?new Hy(o,n,e):new Vy(o,n,e));break}else{let u=t.map[o];u===void 0&&(u=new Gy(o),Df(t,u)),t=u}}}class co{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=e.getActiveUniform(t,s),a=e.getUniformLocation(t,r.name);Wy(r,a,this)}}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,a=t.length;r!==a;++r){const o=t[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const a=e[s];a.id in t&&i.push(a)}return i}}function Uf(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const Xy=37297;let qy=0;function $y(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){const o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}const If=new Je;function Yy(n){ft._getMatrix(If,ft.workingColorSpace,n);const e=`mat3( ${If.elements.map(t=>t.toFixed(4))} )`;switch(ft.getTransfer(n)){case Uo:return[e,"LinearTransferOETF"];case yt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Nf(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),s=n.getShaderInfoLog(e).trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const a=parseInt(r[1]);return t.toUpperCase()+`

`+s+`

`+$y(n.getShaderSource(e),a)}else return s}function Zy(n,e){const t=Yy(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function Ky(n,e){let t;switch(e){case hv:t="Linear";break;case fv:t="Reinhard";break;case dv:t="Cineon";break;case pv:t="ACESFilmic";break;case gv:t="AgX";break;case _v:t="Neutral";break;case mv:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const Ka=new ne;function jy(){ft.getLuminanceCoefficients(Ka);const n=Ka.x.toFixed(4),e=Ka.y.toFixed(4),t=Ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Jy(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ea).join(`
`)}function Qy(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function eE(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),a=r.name;let o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function ea(n){return n!==""}function Ff(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Of(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const tE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wc(n){return n.replace(tE,iE)}const nE=new Map;function iE(n,e){let t=et[e];if(t===void 0){const i=nE.get(e);if(i!==void 0)t=et[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return Wc(t)}const sE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Bf(n){return n.replace(sE,rE)}function rE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function kf(n){let e=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function aE(n){let e="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===tp?e="SHADOWMAP_TYPE_PCF":n.shadowMapType===W0?e="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Ai&&(e="SHADOWMAP_TYPE_VSM"),e}function oE(n){let e="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Ar:case Rr:e="ENVMAP_TYPE_CUBE";break;case Do:e="ENVMAP_TYPE_CUBE_UV";break}return e}function lE(n){let e="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case Rr:e="ENVMAP_MODE_REFRACTION";break}return e}function cE(n){let e="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case np:e="ENVMAP_BLENDING_MULTIPLY";break;case cv:e="ENVMAP_BLENDING_MIX";break;case uv:e="ENVMAP_BLENDING_ADD";break}return e}function uE(n){const e=n.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function hE(n,e,t,i){const s=n.getContext(),r=t.defines;let a=t.vertexShader,o=t.fragmentShader;const l=aE(t),c=oE(t),h=lE(t),u=cE(t),f=uE(t),p=Jy(t),_=Qy(r),x=s.createProgram();let m,d,w=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(ea).join(`
`),m.length>0&&(m+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(ea).join(`
`),d.length>0&&(d+=`
`)):(m=[kf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ea).join(`
`),d=[kf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ji?"#define TONE_MAPPING":"",t.toneMapping!==Ji?et.tonemapping_pars_fragment:"",t.toneMapping!==Ji?Ky("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",et.colorspace_pars_fragment,Zy("linearToOutputTexel",t.outputColorSpace),jy(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ea).join(`
`)),a=Wc(a),a=Ff(a,t),a=Of(a,t),o=Wc(o),o=Ff(o,t),o=Of(o,t),a=Bf(a),o=Bf(o),t.isRawShaderMaterial!==!0&&(w=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,d=["#define varying in",t.glslVersion===jh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===jh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);const T=w+m+a,v=w+d+o,H=Uf(s,s.VERTEX_SHADER,T),L=Uf(s,s.FRAGMENT_SHADER,v);s.attachShader(x,H),s.attachShader(x,L),t.index0AttributeName!==void 0?s.bindAttribLocation(x,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function D(P){if(n.debug.checkShaderErrors){const Y=s.getProgramInfoLog(x).trim(),B=s.getShaderInfoLog(H).trim(),q=s.getShaderInfoLog(L).trim();let K=!0,Z=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(K=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,x,H,L);else{const J=Nf(s,H,"vertex"),Q=Nf(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+Y+`
`+J+`
`+Q)}else Y!==""?console.warn("THREE.WebGLProgram: Program Info Log:",Y):(B===""||q==="")&&(Z=!1);Z&&(P.diagnostics={runnable:K,programLog:Y,vertexShader:{log:B,prefix:m},fragmentShader:{log:q,prefix:d}})}s.deleteShader(H),s.deleteShader(L),F=new co(s,x),b=eE(s,x)}let F;this.getUniforms=function(){return F===void 0&&D(this),F};let b;this.getAttributes=function(){return b===void 0&&D(this),b};let y=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return y===!1&&(y=s.getProgramParameter(x,Xy)),y},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=qy++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=H,this.fragmentShader=L,this}let fE=0;class dE{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,i=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(i),a=this._getShaderCacheForMaterial(e);return a.has(s)===!1&&(a.add(s),s.usedTimes++),a.has(r)===!1&&(a.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new pE(e),t.set(e,i)),i}}class pE{constructor(e){this.id=fE++,this.code=e,this.usedTimes=0}}function mE(n,e,t,i,s,r,a){const o=new vp,l=new dE,c=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures;let p=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(b){return c.add(b),b===0?"uv":`uv${b}`}function m(b,y,P,Y,B){const q=Y.fog,K=B.geometry,Z=b.isMeshStandardMaterial?Y.environment:null,J=(b.isMeshStandardMaterial?t:e).get(b.envMap||Z),Q=J&&J.mapping===Do?J.image.height:null,he=_[b.type];b.precision!==null&&(p=s.getMaxPrecision(b.precision),p!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",p,"instead."));const ce=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,me=ce!==void 0?ce.length:0;let Me=0;K.morphAttributes.position!==void 0&&(Me=1),K.morphAttributes.normal!==void 0&&(Me=2),K.morphAttributes.color!==void 0&&(Me=3);let pe,ie,oe,ge;if(he){const mt=hi[he];pe=mt.vertexShader,ie=mt.fragmentShader}else pe=b.vertexShader,ie=b.fragmentShader,l.update(b),oe=l.getVertexShaderID(b),ge=l.getFragmentShaderID(b);const ae=n.getRenderTarget(),ke=n.state.buffers.depth.getReversed(),He=B.isInstancedMesh===!0,Ie=B.isBatchedMesh===!0,at=!!b.map,Ze=!!b.matcap,ot=!!J,k=!!b.aoMap,Xt=!!b.lightMap,je=!!b.bumpMap,Qe=!!b.normalMap,Ve=!!b.displacementMap,ct=!!b.emissiveMap,Pe=!!b.metalnessMap,R=!!b.roughnessMap,S=b.anisotropy>0,$=b.clearcoat>0,j=b.dispersion>0,V=b.iridescence>0,ee=b.sheen>0,Se=b.transmission>0,_e=S&&!!b.anisotropyMap,we=$&&!!b.clearcoatMap,Ye=$&&!!b.clearcoatNormalMap,fe=$&&!!b.clearcoatRoughnessMap,ve=V&&!!b.iridescenceMap,Ne=V&&!!b.iridescenceThicknessMap,Oe=ee&&!!b.sheenColorMap,Ee=ee&&!!b.sheenRoughnessMap,tt=!!b.specularMap,qe=!!b.specularColorMap,ut=!!b.specularIntensityMap,O=Se&&!!b.transmissionMap,xe=Se&&!!b.thicknessMap,te=!!b.gradientMap,re=!!b.alphaMap,be=b.alphaTest>0,Ae=!!b.alphaHash,Ke=!!b.extensions;let It=Ji;b.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(It=n.toneMapping);const Jt={shaderID:he,shaderType:b.type,shaderName:b.name,vertexShader:pe,fragmentShader:ie,defines:b.defines,customVertexShaderID:oe,customFragmentShaderID:ge,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:p,batching:Ie,batchingColor:Ie&&B._colorsTexture!==null,instancing:He,instancingColor:He&&B.instanceColor!==null,instancingMorph:He&&B.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ae===null?n.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:Os,alphaToCoverage:!!b.alphaToCoverage,map:at,matcap:Ze,envMap:ot,envMapMode:ot&&J.mapping,envMapCubeUVHeight:Q,aoMap:k,lightMap:Xt,bumpMap:je,normalMap:Qe,displacementMap:f&&Ve,emissiveMap:ct,normalMapObjectSpace:Qe&&b.normalMapType===yv,normalMapTangentSpace:Qe&&b.normalMapType===Sv,metalnessMap:Pe,roughnessMap:R,anisotropy:S,anisotropyMap:_e,clearcoat:$,clearcoatMap:we,clearcoatNormalMap:Ye,clearcoatRoughnessMap:fe,dispersion:j,iridescence:V,iridescenceMap:ve,iridescenceThicknessMap:Ne,sheen:ee,sheenColorMap:Oe,sheenRoughnessMap:Ee,specularMap:tt,specularColorMap:qe,specularIntensityMap:ut,transmission:Se,transmissionMap:O,thicknessMap:xe,gradientMap:te,opaque:b.transparent===!1&&b.blending===gr&&b.alphaToCoverage===!1,alphaMap:re,alphaTest:be,alphaHash:Ae,combine:b.combine,mapUv:at&&x(b.map.channel),aoMapUv:k&&x(b.aoMap.channel),lightMapUv:Xt&&x(b.lightMap.channel),bumpMapUv:je&&x(b.bumpMap.channel),normalMapUv:Qe&&x(b.normalMap.channel),displacementMapUv:Ve&&x(b.displacementMap.channel),emissiveMapUv:ct&&x(b.emissiveMap.channel),metalnessMapUv:Pe&&x(b.metalnessMap.channel),roughnessMapUv:R&&x(b.roughnessMap.channel),anisotropyMapUv:_e&&x(b.anisotropyMap.channel),clearcoatMapUv:we&&x(b.clearcoatMap.channel),clearcoatNormalMapUv:Ye&&x(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:fe&&x(b.clearcoatRoughnessMap.channel),iridescenceMapUv:ve&&x(b.iridescenceMap.channel),iridescenceThicknessMapUv:Ne&&x(b.iridescenceThicknessMap.channel),sheenColorMapUv:Oe&&x(b.sheenColorMap.channel),sheenRoughnessMapUv:Ee&&x(b.sheenRoughnessMap.channel),specularMapUv:tt&&x(b.specularMap.channel),specularColorMapUv:qe&&x(b.specularColorMap.channel),specularIntensityMapUv:ut&&x(b.specularIntensityMap.channel),transmissionMapUv:O&&x(b.transmissionMap.channel),thicknessMapUv:xe&&x(b.thicknessMap.channel),alphaMapUv:re&&x(b.alphaMap.channel),vertexTangents:!!K.attributes.tangent&&(Qe||S),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,pointsUvs:B.isPoints===!0&&!!K.attributes.uv&&(at||re),fog:!!q,useFog:b.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:b.flatShading===!0,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:ke,skinning:B.isSkinnedMesh===!0,morphTargets:K.morphAttributes.position!==void 0,morphNormals:K.morphAttributes.normal!==void 0,morphColors:K.morphAttributes.color!==void 0,morphTargetsCount:me,morphTextureStride:Me,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:b.dithering,shadowMapEnabled:n.shadowMap.enabled&&P.length>0,shadowMapType:n.shadowMap.type,toneMapping:It,decodeVideoTexture:at&&b.map.isVideoTexture===!0&&ft.getTransfer(b.map.colorSpace)===yt,decodeVideoTextureEmissive:ct&&b.emissiveMap.isVideoTexture===!0&&ft.getTransfer(b.emissiveMap.colorSpace)===yt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===fi,flipSided:b.side===En,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:Ke&&b.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&b.extensions.multiDraw===!0||Ie)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return Jt.vertexUv1s=c.has(1),Jt.vertexUv2s=c.has(2),Jt.vertexUv3s=c.has(3),c.clear(),Jt}function d(b){const y=[];if(b.shaderID?y.push(b.shaderID):(y.push(b.customVertexShaderID),y.push(b.customFragmentShaderID)),b.defines!==void 0)for(const P in b.defines)y.push(P),y.push(b.defines[P]);return b.isRawShaderMaterial===!1&&(w(y,b),T(y,b),y.push(n.outputColorSpace)),y.push(b.customProgramCacheKey),y.join()}function w(b,y){b.push(y.precision),b.push(y.outputColorSpace),b.push(y.envMapMode),b.push(y.envMapCubeUVHeight),b.push(y.mapUv),b.push(y.alphaMapUv),b.push(y.lightMapUv),b.push(y.aoMapUv),b.push(y.bumpMapUv),b.push(y.normalMapUv),b.push(y.displacementMapUv),b.push(y.emissiveMapUv),b.push(y.metalnessMapUv),b.push(y.roughnessMapUv),b.push(y.anisotropyMapUv),b.push(y.clearcoatMapUv),b.push(y.clearcoatNormalMapUv),b.push(y.clearcoatRoughnessMapUv),b.push(y.iridescenceMapUv),b.push(y.iridescenceThicknessMapUv),b.push(y.sheenColorMapUv),b.push(y.sheenRoughnessMapUv),b.push(y.specularMapUv),b.push(y.specularColorMapUv),b.push(y.specularIntensityMapUv),b.push(y.transmissionMapUv),b.push(y.thicknessMapUv),b.push(y.combine),b.push(y.fogExp2),b.push(y.sizeAttenuation),b.push(y.morphTargetsCount),b.push(y.morphAttributeCount),b.push(y.numDirLights),b.push(y.numPointLights),b.push(y.numSpotLights),b.push(y.numSpotLightMaps),b.push(y.numHemiLights),b.push(y.numRectAreaLights),b.push(y.numDirLightShadows),b.push(y.numPointLightShadows),b.push(y.numSpotLightShadows),b.push(y.numSpotLightShadowsWithMaps),b.push(y.numLightProbes),b.push(y.shadowMapType),b.push(y.toneMapping),b.push(y.numClippingPlanes),b.push(y.numClipIntersection),b.push(y.depthPacking)}function T(b,y){o.disableAll(),y.supportsVertexTextures&&o.enable(0),y.instancing&&o.enable(1),y.instancingColor&&o.enable(2),y.instancingMorph&&o.enable(3),y.matcap&&o.enable(4),y.envMap&&o.enable(5),y.normalMapObjectSpace&&o.enable(6),y.normalMapTangentSpace&&o.enable(7),y.clearcoat&&o.enable(8),y.iridescence&&o.enable(9),y.alphaTest&&o.enable(10),y.vertexColors&&o.enable(11),y.vertexAlphas&&o.enable(12),y.vertexUv1s&&o.enable(13),y.vertexUv2s&&o.enable(14),y.vertexUv3s&&o.enable(15),y.vertexTangents&&o.enable(16),y.anisotropy&&o.enable(17),y.alphaHash&&o.enable(18),y.batching&&o.enable(19),y.dispersion&&o.enable(20),y.batchingColor&&o.enable(21),b.push(o.mask),o.disableAll(),y.fog&&o.enable(0),y.useFog&&o.enable(1),y.flatShading&&o.enable(2),y.logarithmicDepthBuffer&&o.enable(3),y.reverseDepthBuffer&&o.enable(4),y.skinning&&o.enable(5),y.morphTargets&&o.enable(6),y.morphNormals&&o.enable(7),y.morphColors&&o.enable(8),y.premultipliedAlpha&&o.enable(9),y.shadowMapEnabled&&o.enable(10),y.doubleSided&&o.enable(11),y.flipSided&&o.enable(12),y.useDepthPacking&&o.enable(13),y.dithering&&o.enable(14),y.transmission&&o.enable(15),y.sheen&&o.enable(16),y.opaque&&o.enable(17),y.pointsUvs&&o.enable(18),y.decodeVideoTexture&&o.enable(19),y.decodeVideoTextureEmissive&&o.enable(20),y.alphaToCoverage&&o.enable(21),b.push(o.mask)}function v(b){const y=_[b.type];let P;if(y){const Y=hi[y];P=Jv.clone(Y.uniforms)}else P=b.uniforms;return P}function H(b,y){let P;for(let Y=0,B=h.length;Y<B;Y++){const q=h[Y];if(q.cacheKey===y){P=q,++P.usedTimes;break}}return P===void 0&&(P=new hE(n,y,b,r),h.push(P)),P}function L(b){if(--b.usedTimes===0){const y=h.indexOf(b);h[y]=h[h.length-1],h.pop(),b.destroy()}}function D(b){l.remove(b)}function F(){l.dispose()}return{getParameters:m,getProgramCacheKey:d,getUniforms:v,acquireProgram:H,releaseProgram:L,releaseShaderCache:D,programs:h,dispose:F}}function gE(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function _E(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.z!==e.z?n.z-e.z:n.id-e.id}function zf(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Hf(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function a(u,f,p,_,x,m){let d=n[e];return d===void 0?(d={id:u.id,object:u,geometry:f,material:p,groupOrder:_,renderOrder:u.renderOrder,z:x,group:m},n[e]=d):(d.id=u.id,d.object=u,d.geometry=f,d.material=p,d.groupOrder=_,d.renderOrder=u.renderOrder,d.z=x,d.group=m),e++,d}function o(u,f,p,_,x,m){const d=a(u,f,p,_,x,m);p.transmission>0?i.push(d):p.transparent===!0?s.push(d):t.push(d)}function l(u,f,p,_,x,m){const d=a(u,f,p,_,x,m);p.transmission>0?i.unshift(d):p.transparent===!0?s.unshift(d):t.unshift(d)}function c(u,f){t.length>1&&t.sort(u||_E),i.length>1&&i.sort(f||zf),s.length>1&&s.sort(f||zf)}function h(){for(let u=e,f=n.length;u<f;u++){const p=n[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:o,unshift:l,finish:h,sort:c}}function vE(){let n=new WeakMap;function e(i,s){const r=n.get(i);let a;return r===void 0?(a=new Hf,n.set(i,[a])):s>=r.length?(a=new Hf,r.push(a)):a=r[s],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function xE(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new ne,color:new Et};break;case"SpotLight":t={position:new ne,direction:new ne,color:new Et,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new ne,color:new Et,distance:0,decay:0};break;case"HemisphereLight":t={direction:new ne,skyColor:new Et,groundColor:new Et};break;case"RectAreaLight":t={color:new Et,position:new ne,halfWidth:new ne,halfHeight:new ne};break}return n[e.id]=t,t}}}function ME(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let SE=0;function yE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function EE(n){const e=new xE,t=ME(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new ne);const s=new ne,r=new Wt,a=new Wt;function o(c){let h=0,u=0,f=0;for(let b=0;b<9;b++)i.probe[b].set(0,0,0);let p=0,_=0,x=0,m=0,d=0,w=0,T=0,v=0,H=0,L=0,D=0;c.sort(yE);for(let b=0,y=c.length;b<y;b++){const P=c[b],Y=P.color,B=P.intensity,q=P.distance,K=P.shadow&&P.shadow.map?P.shadow.map.texture:null;if(P.isAmbientLight)h+=Y.r*B,u+=Y.g*B,f+=Y.b*B;else if(P.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(P.sh.coefficients[Z],B);D++}else if(P.isDirectionalLight){const Z=e.get(P);if(Z.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){const J=P.shadow,Q=t.get(P);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,i.directionalShadow[p]=Q,i.directionalShadowMap[p]=K,i.directionalShadowMatrix[p]=P.shadow.matrix,w++}i.directional[p]=Z,p++}else if(P.isSpotLight){const Z=e.get(P);Z.position.setFromMatrixPosition(P.matrixWorld),Z.color.copy(Y).multiplyScalar(B),Z.distance=q,Z.coneCos=Math.cos(P.angle),Z.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),Z.decay=P.decay,i.spot[x]=Z;const J=P.shadow;if(P.map&&(i.spotLightMap[H]=P.map,H++,J.updateMatrices(P),P.castShadow&&L++),i.spotLightMatrix[x]=J.matrix,P.castShadow){const Q=t.get(P);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,i.spotShadow[x]=Q,i.spotShadowMap[x]=K,v++}x++}else if(P.isRectAreaLight){const Z=e.get(P);Z.color.copy(Y).multiplyScalar(B),Z.halfWidth.set(P.width*.5,0,0),Z.halfHeight.set(0,P.height*.5,0),i.rectArea[m]=Z,m++}else if(P.isPointLight){const Z=e.get(P);if(Z.color.copy(P.color).multiplyScalar(P.intensity),Z.distance=P.distance,Z.decay=P.decay,P.castShadow){const J=P.shadow,Q=t.get(P);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,Q.shadowCameraNear=J.camera.near,Q.shadowCameraFar=J.camera.far,i.pointShadow[_]=Q,i.pointShadowMap[_]=K,i.pointShadowMatrix[_]=P.shadow.matrix,T++}i.point[_]=Z,_++}else if(P.isHemisphereLight){const Z=e.get(P);Z.skyColor.copy(P.color).multiplyScalar(B),Z.groundColor.copy(P.groundColor).multiplyScalar(B),i.hemi[d]=Z,d++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Te.LTC_FLOAT_1,i.rectAreaLTC2=Te.LTC_FLOAT_2):(i.rectAreaLTC1=Te.LTC_HALF_1,i.rectAreaLTC2=Te.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;const F=i.hash;(F.directionalLength!==p||F.pointLength!==_||F.spotLength!==x||F.rectAreaLength!==m||F.hemiLength!==d||F.numDirectionalShadows!==w||F.numPointShadows!==T||F.numSpotShadows!==v||F.numSpotMaps!==H||F.numLightProbes!==D)&&(i.directional.length=p,i.spot.length=x,i.rectArea.length=m,i.point.length=_,i.hemi.length=d,i.directionalShadow.length=w,i.directionalShadowMap.length=w,i.pointShadow.length=T,i.pointShadowMap.length=T,i.spotShadow.length=v,i.spotShadowMap.length=v,i.directionalShadowMatrix.length=w,i.pointShadowMatrix.length=T,i.spotLightMatrix.length=v+H-L,i.spotLightMap.length=H,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=D,F.directionalLength=p,F.pointLength=_,F.spotLength=x,F.rectAreaLength=m,F.hemiLength=d,F.numDirectionalShadows=w,F.numPointShadows=T,F.numSpotShadows=v,F.numSpotMaps=H,F.numLightProbes=D,i.version=SE++)}function l(c,h){let u=0,f=0,p=0,_=0,x=0;const m=h.matrixWorldInverse;for(let d=0,w=c.length;d<w;d++){const T=c[d];if(T.isDirectionalLight){const v=i.directional[u];v.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(m),u++}else if(T.isSpotLight){const v=i.spot[p];v.position.setFromMatrixPosition(T.matrixWorld),v.position.applyMatrix4(m),v.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(m),p++}else if(T.isRectAreaLight){const v=i.rectArea[_];v.position.setFromMatrixPosition(T.matrixWorld),v.position.applyMatrix4(m),a.identity(),r.copy(T.matrixWorld),r.premultiply(m),a.extractRotation(r),v.halfWidth.set(T.width*.5,0,0),v.halfHeight.set(0,T.height*.5,0),v.halfWidth.applyMatrix4(a),v.halfHeight.applyMatrix4(a),_++}else if(T.isPointLight){const v=i.point[f];v.position.setFromMatrixPosition(T.matrixWorld),v.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const v=i.hemi[x];v.direction.setFromMatrixPosition(T.matrixWorld),v.direction.transformDirection(m),x++}}}return{setup:o,setupView:l,state:i}}function Vf(n){const e=new EE(n),t=[],i=[];function s(h){c.camera=h,t.length=0,i.length=0}function r(h){t.push(h)}function a(h){i.push(h)}function o(){e.setup(t)}function l(h){e.setupView(t,h)}const c={lightsArray:t,shadowsArray:i,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:o,setupLightsView:l,pushLight:r,pushShadow:a}}function TE(n){let e=new WeakMap;function t(s,r=0){const a=e.get(s);let o;return a===void 0?(o=new Vf(n),e.set(s,[o])):r>=a.length?(o=new Vf(n),a.push(o)):o=a[r],o}function i(){e=new WeakMap}return{get:t,dispose:i}}class wE extends Io{static get type(){return"MeshDepthMaterial"}constructor(e){super(),this.isMeshDepthMaterial=!0,this.depthPacking=xv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class bE extends Io{static get type(){return"MeshDistanceMaterial"}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const AE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,RE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function CE(n,e,t){let i=new wp;const s=new Tt,r=new Tt,a=new zt,o=new wE({depthPacking:Mv}),l=new bE,c={},h=t.maxTextureSize,u={[ts]:En,[En]:ts,[fi]:fi},f=new ns({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Tt},radius:{value:4}},vertexShader:AE,fragmentShader:RE}),p=f.clone();p.defines.HORIZONTAL_PASS=1;const _=new is;_.setAttribute("position",new Vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const x=new pi(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=tp;let d=this.type;this.render=function(L,D,F){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||L.length===0)return;const b=n.getRenderTarget(),y=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),Y=n.state;Y.setBlending(ji),Y.buffers.color.setClear(1,1,1,1),Y.buffers.depth.setTest(!0),Y.setScissorTest(!1);const B=d!==Ai&&this.type===Ai,q=d===Ai&&this.type!==Ai;for(let K=0,Z=L.length;K<Z;K++){const J=L[K],Q=J.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",J,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);const he=Q.getFrameExtents();if(s.multiply(he),r.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/he.x),s.x=r.x*he.x,Q.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/he.y),s.y=r.y*he.y,Q.mapSize.y=r.y)),Q.map===null||B===!0||q===!0){const me=this.type!==Ai?{minFilter:ni,magFilter:ni}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Is(s.x,s.y,me),Q.map.texture.name=J.name+".shadowMap",Q.camera.updateProjectionMatrix()}n.setRenderTarget(Q.map),n.clear();const ce=Q.getViewportCount();for(let me=0;me<ce;me++){const Me=Q.getViewport(me);a.set(r.x*Me.x,r.y*Me.y,r.x*Me.z,r.y*Me.w),Y.viewport(a),Q.updateMatrices(J,me),i=Q.getFrustum(),v(D,F,Q.camera,J,this.type)}Q.isPointLightShadow!==!0&&this.type===Ai&&w(Q,F),Q.needsUpdate=!1}d=this.type,m.needsUpdate=!1,n.setRenderTarget(b,y,P)};function w(L,D){const F=e.update(x);f.defines.VSM_SAMPLES!==L.blurSamples&&(f.defines.VSM_SAMPLES=L.blurSamples,p.defines.VSM_SAMPLES=L.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new Is(s.x,s.y)),f.uniforms.shadow_pass.value=L.map.texture,f.uniforms.resolution.value=L.mapSize,f.uniforms.radius.value=L.radius,n.setRenderTarget(L.mapPass),n.clear(),n.renderBufferDirect(D,null,F,f,x,null),p.uniforms.shadow_pass.value=L.mapPass.texture,p.uniforms.resolution.value=L.mapSize,p.uniforms.radius.value=L.radius,n.setRenderTarget(L.map),n.clear(),n.renderBufferDirect(D,null,F,p,x,null)}function T(L,D,F,b){let y=null;const P=F.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(P!==void 0)y=P;else if(y=F.isPointLight===!0?l:o,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const Y=y.uuid,B=D.uuid;let q=c[Y];q===void 0&&(q={},c[Y]=q);let K=q[B];K===void 0&&(K=y.clone(),q[B]=K,D.addEventListener("dispose",H)),y=K}if(y.visible=D.visible,y.wireframe=D.wireframe,b===Ai?y.side=D.shadowSide!==null?D.shadowSide:D.side:y.side=D.shadowSide!==null?D.shadowSide:u[D.side],y.alphaMap=D.alphaMap,y.alphaTest=D.alphaTest,y.map=D.map,y.clipShadows=D.clipShadows,y.clippingPlanes=D.clippingPlanes,y.clipIntersection=D.clipIntersection,y.displacementMap=D.displacementMap,y.displacementScale=D.displacementScale,y.displacementBias=D.displacementBias,y.wireframeLinewidth=D.wireframeLinewidth,y.linewidth=D.linewidth,F.isPointLight===!0&&y.isMeshDistanceMaterial===!0){const Y=n.properties.get(y);Y.light=F}return y}function v(L,D,F,b,y){if(L.visible===!1)return;if(L.layers.test(D.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&y===Ai)&&(!L.frustumCulled||i.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(F.matrixWorldInverse,L.matrixWorld);const B=e.update(L),q=L.material;if(Array.isArray(q)){const K=B.groups;for(let Z=0,J=K.length;Z<J;Z++){const Q=K[Z],he=q[Q.materialIndex];if(he&&he.visible){const ce=T(L,he,b,y);L.onBeforeShadow(n,L,D,F,B,ce,Q),n.renderBufferDirect(F,null,B,ce,L,Q),L.onAfterShadow(n,L,D,F,B,ce,Q)}}}else if(q.visible){const K=T(L,q,b,y);L.onBeforeShadow(n,L,D,F,B,K,null),n.renderBufferDirect(F,null,B,K,L,null),L.onAfterShadow(n,L,D,F,B,K,null)}}const Y=L.children;for(let B=0,q=Y.length;B<q;B++)v(Y[B],D,F,b,y)}function H(L){L.target.removeEventListener("dispose",H);for(const F in c){const b=c[F],y=L.target.uuid;y in b&&(b[y].dispose(),delete b[y])}}}const PE={[ac]:oc,[lc]:hc,[cc]:fc,[br]:uc,[oc]:ac,[hc]:lc,[fc]:cc,[uc]:br};function LE(n,e){function t(){let O=!1;const xe=new zt;let te=null;const re=new zt(0,0,0,0);return{setMask:function(be){te!==be&&!O&&(n.colorMask(be,be,be,be),te=be)},setLocked:function(be){O=be},setClear:function(be,Ae,Ke,It,Jt){Jt===!0&&(be*=It,Ae*=It,Ke*=It),xe.set(be,Ae,Ke,It),re.equals(xe)===!1&&(n.clearColor(be,Ae,Ke,It),re.copy(xe))},reset:function(){O=!1,te=null,re.set(-1,0,0,0)}}}function i(){let O=!1,xe=!1,te=null,re=null,be=null;return{setReversed:function(Ae){if(xe!==Ae){const Ke=e.get("EXT_clip_control");xe?Ke.clipControlEXT(Ke.LOWER_LEFT_EXT,Ke.ZERO_TO_ONE_EXT):Ke.clipControlEXT(Ke.LOWER_LEFT_EXT,Ke.NEGATIVE_ONE_TO_ONE_EXT);const It=be;be=null,this.setClear(It)}xe=Ae},getReversed:function(){return xe},setTest:function(Ae){Ae?ae(n.DEPTH_TEST):ke(n.DEPTH_TEST)},setMask:function(Ae){te!==Ae&&!O&&(n.depthMask(Ae),te=Ae)},setFunc:function(Ae){if(xe&&(Ae=PE[Ae]),re!==Ae){switch(Ae){case ac:n.depthFunc(n.NEVER);break;case oc:n.depthFunc(n.ALWAYS);break;case lc:n.depthFunc(n.LESS);break;case br:n.depthFunc(n.LEQUAL);break;case cc:n.depthFunc(n.EQUAL);break;case uc:n.depthFunc(n.GEQUAL);break;case hc:n.depthFunc(n.GREATER);break;case fc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}re=Ae}},setLocked:function(Ae){O=Ae},setClear:function(Ae){be!==Ae&&(xe&&(Ae=1-Ae),n.clearDepth(Ae),be=Ae)},reset:function(){O=!1,te=null,re=null,be=null,xe=!1}}}function s(){let O=!1,xe=null,te=null,re=null,be=null,Ae=null,Ke=null,It=null,Jt=null;return{setTest:function(mt){O||(mt?ae(n.STENCIL_TEST):ke(n.STENCIL_TEST))},setMask:function(mt){xe!==mt&&!O&&(n.stencilMask(mt),xe=mt)},setFunc:function(mt,qt,Rt){(te!==mt||re!==qt||be!==Rt)&&(n.stencilFunc(mt,qt,Rt),te=mt,re=qt,be=Rt)},setOp:function(mt,qt,Rt){(Ae!==mt||Ke!==qt||It!==Rt)&&(n.stencilOp(mt,qt,Rt),Ae=mt,Ke=qt,It=Rt)},setLocked:function(mt){O=mt},setClear:function(mt){Jt!==mt&&(n.clearStencil(mt),Jt=mt)},reset:function(){O=!1,xe=null,te=null,re=null,be=null,Ae=null,Ke=null,It=null,Jt=null}}}const r=new t,a=new i,o=new s,l=new WeakMap,c=new WeakMap;let h={},u={},f=new WeakMap,p=[],_=null,x=!1,m=null,d=null,w=null,T=null,v=null,H=null,L=null,D=new Et(0,0,0),F=0,b=!1,y=null,P=null,Y=null,B=null,q=null;const K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let Z=!1,J=0;const Q=n.getParameter(n.VERSION);Q.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(Q)[1]),Z=J>=1):Q.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),Z=J>=2);let he=null,ce={};const me=n.getParameter(n.SCISSOR_BOX),Me=n.getParameter(n.VIEWPORT),pe=new zt().fromArray(me),ie=new zt().fromArray(Me);function oe(O,xe,te,re){const be=new Uint8Array(4),Ae=n.createTexture();n.bindTexture(O,Ae),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ke=0;Ke<te;Ke++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(xe,0,n.RGBA,1,1,re,0,n.RGBA,n.UNSIGNED_BYTE,be):n.texImage2D(xe+Ke,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,be);return Ae}const ge={};ge[n.TEXTURE_2D]=oe(n.TEXTURE_2D,n.TEXTURE_2D,1),ge[n.TEXTURE_CUBE_MAP]=oe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ge[n.TEXTURE_2D_ARRAY]=oe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ge[n.TEXTURE_3D]=oe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),ae(n.DEPTH_TEST),a.setFunc(br),je(!1),Qe(Xh),ae(n.CULL_FACE),k(ji);function ae(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function ke(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function He(O,xe){return u[O]!==xe?(n.bindFramebuffer(O,xe),u[O]=xe,O===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=xe),O===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=xe),!0):!1}function Ie(O,xe){let te=p,re=!1;if(O){te=f.get(xe),te===void 0&&(te=[],f.set(xe,te));const be=O.textures;if(te.length!==be.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Ae=0,Ke=be.length;Ae<Ke;Ae++)te[Ae]=n.COLOR_ATTACHMENT0+Ae;te.length=be.length,re=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,re=!0);re&&n.drawBuffers(te)}function at(O){return _!==O?(n.useProgram(O),_=O,!0):!1}const Ze={[Ss]:n.FUNC_ADD,[q0]:n.FUNC_SUBTRACT,[$0]:n.FUNC_REVERSE_SUBTRACT};Ze[Y0]=n.MIN,Ze[Z0]=n.MAX;const ot={[K0]:n.ZERO,[j0]:n.ONE,[J0]:n.SRC_COLOR,[sc]:n.SRC_ALPHA,[sv]:n.SRC_ALPHA_SATURATE,[nv]:n.DST_COLOR,[ev]:n.DST_ALPHA,[Q0]:n.ONE_MINUS_SRC_COLOR,[rc]:n.ONE_MINUS_SRC_ALPHA,[iv]:n.ONE_MINUS_DST_COLOR,[tv]:n.ONE_MINUS_DST_ALPHA,[rv]:n.CONSTANT_COLOR,[av]:n.ONE_MINUS_CONSTANT_COLOR,[ov]:n.CONSTANT_ALPHA,[lv]:n.ONE_MINUS_CONSTANT_ALPHA};function k(O,xe,te,re,be,Ae,Ke,It,Jt,mt){if(O===ji){x===!0&&(ke(n.BLEND),x=!1);return}if(x===!1&&(ae(n.BLEND),x=!0),O!==X0){if(O!==m||mt!==b){if((d!==Ss||v!==Ss)&&(n.blendEquation(n.FUNC_ADD),d=Ss,v=Ss),mt)switch(O){case gr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case qh:n.blendFunc(n.ONE,n.ONE);break;case $h:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Yh:n.blendFuncSeparate(n.ZERO,n.SRC_COLOR,n.ZERO,n.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}else switch(O){case gr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case qh:n.blendFunc(n.SRC_ALPHA,n.ONE);break;case $h:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Yh:n.blendFunc(n.ZERO,n.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}w=null,T=null,H=null,L=null,D.set(0,0,0),F=0,m=O,b=mt}return}be=be||xe,Ae=Ae||te,Ke=Ke||re,(xe!==d||be!==v)&&(n.blendEquationSeparate(Ze[xe],Ze[be]),d=xe,v=be),(te!==w||re!==T||Ae!==H||Ke!==L)&&(n.blendFuncSeparate(ot[te],ot[re],ot[Ae],ot[Ke]),w=te,T=re,H=Ae,L=Ke),(It.equals(D)===!1||Jt!==F)&&(n.blendColor(It.r,It.g,It.b,Jt),D.copy(It),F=Jt),m=O,b=!1}function Xt(O,xe){O.side===fi?ke(n.CULL_FACE):ae(n.CULL_FACE);let te=O.side===En;xe&&(te=!te),je(te),O.blending===gr&&O.transparent===!1?k(ji):k(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),a.setFunc(O.depthFunc),a.setTest(O.depthTest),a.setMask(O.depthWrite),r.setMask(O.colorWrite);const re=O.stencilWrite;o.setTest(re),re&&(o.setMask(O.stencilWriteMask),o.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),o.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),ct(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ae(n.SAMPLE_ALPHA_TO_COVERAGE):ke(n.SAMPLE_ALPHA_TO_COVERAGE)}function je(O){y!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),y=O)}function Qe(O){O!==V0?(ae(n.CULL_FACE),O!==P&&(O===Xh?n.cullFace(n.BACK):O===G0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):ke(n.CULL_FACE),P=O}function Ve(O){O!==Y&&(Z&&n.lineWidth(O),Y=O)}function ct(O,xe,te){O?(ae(n.POLYGON_OFFSET_FILL),(B!==xe||q!==te)&&(n.polygonOffset(xe,te),B=xe,q=te)):ke(n.POLYGON_OFFSET_FILL)}function Pe(O){O?ae(n.SCISSOR_TEST):ke(n.SCISSOR_TEST)}function R(O){O===void 0&&(O=n.TEXTURE0+K-1),he!==O&&(n.activeTexture(O),he=O)}function S(O,xe,te){te===void 0&&(he===null?te=n.TEXTURE0+K-1:te=he);let re=ce[te];re===void 0&&(re={type:void 0,texture:void 0},ce[te]=re),(re.type!==O||re.texture!==xe)&&(he!==te&&(n.activeTexture(te),he=te),n.bindTexture(O,xe||ge[O]),re.type=O,re.texture=xe)}function $(){const O=ce[he];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function j(){try{n.compressedTexImage2D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function V(){try{n.compressedTexImage3D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function ee(){try{n.texSubImage2D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Se(){try{n.texSubImage3D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function _e(){try{n.compressedTexSubImage2D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function we(){try{n.compressedTexSubImage3D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ye(){try{n.texStorage2D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function fe(){try{n.texStorage3D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function ve(){try{n.texImage2D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ne(){try{n.texImage3D.apply(n,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Oe(O){pe.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),pe.copy(O))}function Ee(O){ie.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),ie.copy(O))}function tt(O,xe){let te=c.get(xe);te===void 0&&(te=new WeakMap,c.set(xe,te));let re=te.get(O);re===void 0&&(re=n.getUniformBlockIndex(xe,O.name),te.set(O,re))}function qe(O,xe){const re=c.get(xe).get(O);l.get(xe)!==re&&(n.uniformBlockBinding(xe,re,O.__bindingPointIndex),l.set(xe,re))}function ut(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),h={},he=null,ce={},u={},f=new WeakMap,p=[],_=null,x=!1,m=null,d=null,w=null,T=null,v=null,H=null,L=null,D=new Et(0,0,0),F=0,b=!1,y=null,P=null,Y=null,B=null,q=null,pe.set(0,0,n.canvas.width,n.canvas.height),ie.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:ae,disable:ke,bindFramebuffer:He,drawBuffers:Ie,useProgram:at,setBlending:k,setMaterial:Xt,setFlipSided:je,setCullFace:Qe,setLineWidth:Ve,setPolygonOffset:ct,setScissorTest:Pe,activeTexture:R,bindTexture:S,unbindTexture:$,compressedTexImage2D:j,compressedTexImage3D:V,texImage2D:ve,texImage3D:Ne,updateUBOMapping:tt,uniformBlockBinding:qe,texStorage2D:Ye,texStorage3D:fe,texSubImage2D:ee,texSubImage3D:Se,compressedTexSubImage2D:_e,compressedTexSubImage3D:we,scissor:Oe,viewport:Ee,reset:ut}}function Gf(n,e,t,i){const s=DE(i);switch(t){case op:return n*e;case cp:return n*e;case up:return n*e*2;case hp:return n*e/s.components*s.byteLength;case du:return n*e/s.components*s.byteLength;case fp:return n*e*2/s.components*s.byteLength;case pu:return n*e*2/s.components*s.byteLength;case lp:return n*e*3/s.components*s.byteLength;case ti:return n*e*4/s.components*s.byteLength;case mu:return n*e*4/s.components*s.byteLength;case so:case ro:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ao:case oo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case vc:case Mc:return Math.max(n,16)*Math.max(e,8)/4;case _c:case xc:return Math.max(n,8)*Math.max(e,8)/2;case Sc:case yc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ec:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Tc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case wc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case bc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ac:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Rc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Cc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Pc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Lc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Dc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Uc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ic:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Nc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Fc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Oc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case lo:case Bc:case kc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case dp:case zc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Hc:case Vc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function DE(n){switch(n){case Ni:case sp:return{byteLength:1,components:1};case oa:case rp:case ha:return{byteLength:2,components:1};case hu:case fu:return{byteLength:2,components:4};case Us:case uu:case Ri:return{byteLength:4,components:1};case ap:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}function UE(n,e,t,i,s,r,a){const o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Tt,h=new WeakMap;let u;const f=new WeakMap;let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(R,S){return p?new OffscreenCanvas(R,S):So("canvas")}function x(R,S,$){let j=1;const V=Pe(R);if((V.width>$||V.height>$)&&(j=$/Math.max(V.width,V.height)),j<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const ee=Math.floor(j*V.width),Se=Math.floor(j*V.height);u===void 0&&(u=_(ee,Se));const _e=S?_(ee,Se):u;return _e.width=ee,_e.height=Se,_e.getContext("2d").drawImage(R,0,0,ee,Se),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+V.width+"x"+V.height+") to ("+ee+"x"+Se+")."),_e}else return"data"in R&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+V.width+"x"+V.height+")."),R;return R}function m(R){return R.generateMipmaps}function d(R){n.generateMipmap(R)}function w(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(R,S,$,j,V=!1){if(R!==null){if(n[R]!==void 0)return n[R];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ee=S;if(S===n.RED&&($===n.FLOAT&&(ee=n.R32F),$===n.HALF_FLOAT&&(ee=n.R16F),$===n.UNSIGNED_BYTE&&(ee=n.R8)),S===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(ee=n.R8UI),$===n.UNSIGNED_SHORT&&(ee=n.R16UI),$===n.UNSIGNED_INT&&(ee=n.R32UI),$===n.BYTE&&(ee=n.R8I),$===n.SHORT&&(ee=n.R16I),$===n.INT&&(ee=n.R32I)),S===n.RG&&($===n.FLOAT&&(ee=n.RG32F),$===n.HALF_FLOAT&&(ee=n.RG16F),$===n.UNSIGNED_BYTE&&(ee=n.RG8)),S===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(ee=n.RG8UI),$===n.UNSIGNED_SHORT&&(ee=n.RG16UI),$===n.UNSIGNED_INT&&(ee=n.RG32UI),$===n.BYTE&&(ee=n.RG8I),$===n.SHORT&&(ee=n.RG16I),$===n.INT&&(ee=n.RG32I)),S===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),$===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),$===n.UNSIGNED_INT&&(ee=n.RGB32UI),$===n.BYTE&&(ee=n.RGB8I),$===n.SHORT&&(ee=n.RGB16I),$===n.INT&&(ee=n.RGB32I)),S===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),$===n.UNSIGNED_INT&&(ee=n.RGBA32UI),$===n.BYTE&&(ee=n.RGBA8I),$===n.SHORT&&(ee=n.RGBA16I),$===n.INT&&(ee=n.RGBA32I)),S===n.RGB&&$===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),S===n.RGBA){const Se=V?Uo:ft.getTransfer(j);$===n.FLOAT&&(ee=n.RGBA32F),$===n.HALF_FLOAT&&(ee=n.RGBA16F),$===n.UNSIGNED_BYTE&&(ee=Se===yt?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function v(R,S){let $;return R?S===null||S===Us||S===Cr?$=n.DEPTH24_STENCIL8:S===Ri?$=n.DEPTH32F_STENCIL8:S===oa&&($=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Us||S===Cr?$=n.DEPTH_COMPONENT24:S===Ri?$=n.DEPTH_COMPONENT32F:S===oa&&($=n.DEPTH_COMPONENT16),$}function H(R,S){return m(R)===!0||R.isFramebufferTexture&&R.minFilter!==ni&&R.minFilter!==di?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function L(R){const S=R.target;S.removeEventListener("dispose",L),F(S),S.isVideoTexture&&h.delete(S)}function D(R){const S=R.target;S.removeEventListener("dispose",D),y(S)}function F(R){const S=i.get(R);if(S.__webglInit===void 0)return;const $=R.source,j=f.get($);if(j){const V=j[S.__cacheKey];V.usedTimes--,V.usedTimes===0&&b(R),Object.keys(j).length===0&&f.delete($)}i.remove(R)}function b(R){const S=i.get(R);n.deleteTexture(S.__webglTexture);const $=R.source,j=f.get($);delete j[S.__cacheKey],a.memory.textures--}function y(R){const S=i.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),i.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(S.__webglFramebuffer[j]))for(let V=0;V<S.__webglFramebuffer[j].length;V++)n.deleteFramebuffer(S.__webglFramebuffer[j][V]);else n.deleteFramebuffer(S.__webglFramebuffer[j]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[j])}else{if(Array.isArray(S.__webglFramebuffer))for(let j=0;j<S.__webglFramebuffer.length;j++)n.deleteFramebuffer(S.__webglFramebuffer[j]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let j=0;j<S.__webglColorRenderbuffer.length;j++)S.__webglColorRenderbuffer[j]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[j]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}const $=R.textures;for(let j=0,V=$.length;j<V;j++){const ee=i.get($[j]);ee.__webglTexture&&(n.deleteTexture(ee.__webglTexture),a.memory.textures--),i.remove($[j])}i.remove(R)}let P=0;function Y(){P=0}function B(){const R=P;return R>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+s.maxTextures),P+=1,R}function q(R){const S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function K(R,S){const $=i.get(R);if(R.isVideoTexture&&Ve(R),R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){const j=R.image;if(j===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(j.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ie($,R,S);return}}t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+S)}function Z(R,S){const $=i.get(R);if(R.version>0&&$.__version!==R.version){ie($,R,S);return}t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+S)}function J(R,S){const $=i.get(R);if(R.version>0&&$.__version!==R.version){ie($,R,S);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+S)}function Q(R,S){const $=i.get(R);if(R.version>0&&$.__version!==R.version){oe($,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+S)}const he={[mc]:n.REPEAT,[Es]:n.CLAMP_TO_EDGE,[gc]:n.MIRRORED_REPEAT},ce={[ni]:n.NEAREST,[vv]:n.NEAREST_MIPMAP_NEAREST,[Pa]:n.NEAREST_MIPMAP_LINEAR,[di]:n.LINEAR,[cl]:n.LINEAR_MIPMAP_NEAREST,[Ts]:n.LINEAR_MIPMAP_LINEAR},me={[Ev]:n.NEVER,[Cv]:n.ALWAYS,[Tv]:n.LESS,[pp]:n.LEQUAL,[wv]:n.EQUAL,[Rv]:n.GEQUAL,[bv]:n.GREATER,[Av]:n.NOTEQUAL};function Me(R,S){if(S.type===Ri&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===di||S.magFilter===cl||S.magFilter===Pa||S.magFilter===Ts||S.minFilter===di||S.minFilter===cl||S.minFilter===Pa||S.minFilter===Ts)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,he[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,he[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,he[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ce[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ce[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,me[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===ni||S.minFilter!==Pa&&S.minFilter!==Ts||S.type===Ri&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){const $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function pe(R,S){let $=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",L));const j=S.source;let V=f.get(j);V===void 0&&(V={},f.set(j,V));const ee=q(S);if(ee!==R.__cacheKey){V[ee]===void 0&&(V[ee]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,$=!0),V[ee].usedTimes++;const Se=V[R.__cacheKey];Se!==void 0&&(V[R.__cacheKey].usedTimes--,Se.usedTimes===0&&b(S)),R.__cacheKey=ee,R.__webglTexture=V[ee].texture}return $}function ie(R,S,$){let j=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(j=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(j=n.TEXTURE_3D);const V=pe(R,S),ee=S.source;t.bindTexture(j,R.__webglTexture,n.TEXTURE0+$);const Se=i.get(ee);if(ee.version!==Se.__version||V===!0){t.activeTexture(n.TEXTURE0+$);const _e=ft.getPrimaries(ft.workingColorSpace),we=S.colorSpace===Ki?null:ft.getPrimaries(S.colorSpace),Ye=S.colorSpace===Ki||_e===we?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ye);let fe=x(S.image,!1,s.maxTextureSize);fe=ct(S,fe);const ve=r.convert(S.format,S.colorSpace),Ne=r.convert(S.type);let Oe=T(S.internalFormat,ve,Ne,S.colorSpace,S.isVideoTexture);Me(j,S);let Ee;const tt=S.mipmaps,qe=S.isVideoTexture!==!0,ut=Se.__version===void 0||V===!0,O=ee.dataReady,xe=H(S,fe);if(S.isDepthTexture)Oe=v(S.format===Pr,S.type),ut&&(qe?t.texStorage2D(n.TEXTURE_2D,1,Oe,fe.width,fe.height):t.texImage2D(n.TEXTURE_2D,0,Oe,fe.width,fe.height,0,ve,Ne,null));else if(S.isDataTexture)if(tt.length>0){qe&&ut&&t.texStorage2D(n.TEXTURE_2D,xe,Oe,tt[0].width,tt[0].height);for(let te=0,re=tt.length;te<re;te++)Ee=tt[te],qe?O&&t.texSubImage2D(n.TEXTURE_2D,te,0,0,Ee.width,Ee.height,ve,Ne,Ee.data):t.texImage2D(n.TEXTURE_2D,te,Oe,Ee.width,Ee.height,0,ve,Ne,Ee.data);S.generateMipmaps=!1}else qe?(ut&&t.texStorage2D(n.TEXTURE_2D,xe,Oe,fe.width,fe.height),O&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,fe.width,fe.height,ve,Ne,fe.data)):t.texImage2D(n.TEXTURE_2D,0,Oe,fe.width,fe.height,0,ve,Ne,fe.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){qe&&ut&&t.texStorage3D(n.TEXTURE_2D_ARRAY,xe,Oe,tt[0].width,tt[0].height,fe.depth);for(let te=0,re=tt.length;te<re;te++)if(Ee=tt[te],S.format!==ti)if(ve!==null)if(qe){if(O)if(S.layerUpdates.size>0){const be=Gf(Ee.width,Ee.height,S.format,S.type);for(const Ae of S.layerUpdates){const Ke=Ee.data.subarray(Ae*be/Ee.data.BYTES_PER_ELEMENT,(Ae+1)*be/Ee.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,te,0,0,Ae,Ee.width,Ee.height,1,ve,Ke)}S.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,te,0,0,0,Ee.width,Ee.height,fe.depth,ve,Ee.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,te,Oe,Ee.width,Ee.height,fe.depth,0,Ee.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else qe?O&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,te,0,0,0,Ee.width,Ee.height,fe.depth,ve,Ne,Ee.data):t.texImage3D(n.TEXTURE_2D_ARRAY,te,Oe,Ee.width,Ee.height,fe.depth,0,ve,Ne,Ee.data)}else{qe&&ut&&t.texStorage2D(n.TEXTURE_2D,xe,Oe,tt[0].width,tt[0].height);for(let te=0,re=tt.length;te<re;te++)Ee=tt[te],S.format!==ti?ve!==null?qe?O&&t.compressedTexSubImage2D(n.TEXTURE_2D,te,0,0,Ee.width,Ee.height,ve,Ee.data):t.compressedTexImage2D(n.TEXTURE_2D,te,Oe,Ee.width,Ee.height,0,Ee.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):qe?O&&t.texSubImage2D(n.TEXTURE_2D,te,0,0,Ee.width,Ee.height,ve,Ne,Ee.data):t.texImage2D(n.TEXTURE_2D,te,Oe,Ee.width,Ee.height,0,ve,Ne,Ee.data)}else if(S.isDataArrayTexture)if(qe){if(ut&&t.texStorage3D(n.TEXTURE_2D_ARRAY,xe,Oe,fe.width,fe.height,fe.depth),O)if(S.layerUpdates.size>0){const te=Gf(fe.width,fe.height,S.format,S.type);for(const re of S.layerUpdates){const be=fe.data.subarray(re*te/fe.data.BYTES_PER_ELEMENT,(re+1)*te/fe.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,re,fe.width,fe.height,1,ve,Ne,be)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,fe.width,fe.height,fe.depth,ve,Ne,fe.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,Oe,fe.width,fe.height,fe.depth,0,ve,Ne,fe.data);else if(S.isData3DTexture)qe?(ut&&t.texStorage3D(n.TEXTURE_3D,xe,Oe,fe.width,fe.height,fe.depth),O&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,fe.width,fe.height,fe.depth,ve,Ne,fe.data)):t.texImage3D(n.TEXTURE_3D,0,Oe,fe.width,fe.height,fe.depth,0,ve,Ne,fe.data);else if(S.isFramebufferTexture){if(ut)if(qe)t.texStorage2D(n.TEXTURE_2D,xe,Oe,fe.width,fe.height);else{let te=fe.width,re=fe.height;for(let be=0;be<xe;be++)t.texImage2D(n.TEXTURE_2D,be,Oe,te,re,0,ve,Ne,null),te>>=1,re>>=1}}else if(tt.length>0){if(qe&&ut){const te=Pe(tt[0]);t.texStorage2D(n.TEXTURE_2D,xe,Oe,te.width,te.height)}for(let te=0,re=tt.length;te<re;te++)Ee=tt[te],qe?O&&t.texSubImage2D(n.TEXTURE_2D,te,0,0,ve,Ne,Ee):t.texImage2D(n.TEXTURE_2D,te,Oe,ve,Ne,Ee);S.generateMipmaps=!1}else if(qe){if(ut){const te=Pe(fe);t.texStorage2D(n.TEXTURE_2D,xe,Oe,te.width,te.height)}O&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ve,Ne,fe)}else t.texImage2D(n.TEXTURE_2D,0,Oe,ve,Ne,fe);m(S)&&d(j),Se.__version=ee.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function oe(R,S,$){if(S.image.length!==6)return;const j=pe(R,S),V=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+$);const ee=i.get(V);if(V.version!==ee.__version||j===!0){t.activeTexture(n.TEXTURE0+$);const Se=ft.getPrimaries(ft.workingColorSpace),_e=S.colorSpace===Ki?null:ft.getPrimaries(S.colorSpace),we=S.colorSpace===Ki||Se===_e?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,we);const Ye=S.isCompressedTexture||S.image[0].isCompressedTexture,fe=S.image[0]&&S.image[0].isDataTexture,ve=[];for(let re=0;re<6;re++)!Ye&&!fe?ve[re]=x(S.image[re],!0,s.maxCubemapSize):ve[re]=fe?S.image[re].image:S.image[re],ve[re]=ct(S,ve[re]);const Ne=ve[0],Oe=r.convert(S.format,S.colorSpace),Ee=r.convert(S.type),tt=T(S.internalFormat,Oe,Ee,S.colorSpace),qe=S.isVideoTexture!==!0,ut=ee.__version===void 0||j===!0,O=V.dataReady;let xe=H(S,Ne);Me(n.TEXTURE_CUBE_MAP,S);let te;if(Ye){qe&&ut&&t.texStorage2D(n.TEXTURE_CUBE_MAP,xe,tt,Ne.width,Ne.height);for(let re=0;re<6;re++){te=ve[re].mipmaps;for(let be=0;be<te.length;be++){const Ae=te[be];S.format!==ti?Oe!==null?qe?O&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be,0,0,Ae.width,Ae.height,Oe,Ae.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be,tt,Ae.width,Ae.height,0,Ae.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?O&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be,0,0,Ae.width,Ae.height,Oe,Ee,Ae.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be,tt,Ae.width,Ae.height,0,Oe,Ee,Ae.data)}}}else{if(te=S.mipmaps,qe&&ut){te.length>0&&xe++;const re=Pe(ve[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,xe,tt,re.width,re.height)}for(let re=0;re<6;re++)if(fe){qe?O&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ve[re].width,ve[re].height,Oe,Ee,ve[re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,tt,ve[re].width,ve[re].height,0,Oe,Ee,ve[re].data);for(let be=0;be<te.length;be++){const Ke=te[be].image[re].image;qe?O&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be+1,0,0,Ke.width,Ke.height,Oe,Ee,Ke.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be+1,tt,Ke.width,Ke.height,0,Oe,Ee,Ke.data)}}else{qe?O&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,Oe,Ee,ve[re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,tt,Oe,Ee,ve[re]);for(let be=0;be<te.length;be++){const Ae=te[be];qe?O&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be+1,0,0,Oe,Ee,Ae.image[re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,be+1,tt,Oe,Ee,Ae.image[re])}}}m(S)&&d(n.TEXTURE_CUBE_MAP),ee.__version=V.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function ge(R,S,$,j,V,ee){const Se=r.convert($.format,$.colorSpace),_e=r.convert($.type),we=T($.internalFormat,Se,_e,$.colorSpace),Ye=i.get(S),fe=i.get($);if(fe.__renderTarget=S,!Ye.__hasExternalTextures){const ve=Math.max(1,S.width>>ee),Ne=Math.max(1,S.height>>ee);V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?t.texImage3D(V,ee,we,ve,Ne,S.depth,0,Se,_e,null):t.texImage2D(V,ee,we,ve,Ne,0,Se,_e,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Qe(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,j,V,fe.__webglTexture,0,je(S)):(V===n.TEXTURE_2D||V>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&V<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,j,V,fe.__webglTexture,ee),t.bindFramebuffer(n.FRAMEBUFFER,null)}function ae(R,S,$){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){const j=S.depthTexture,V=j&&j.isDepthTexture?j.type:null,ee=v(S.stencilBuffer,V),Se=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=je(S);Qe(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e,ee,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e,ee,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ee,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,R)}else{const j=S.textures;for(let V=0;V<j.length;V++){const ee=j[V],Se=r.convert(ee.format,ee.colorSpace),_e=r.convert(ee.type),we=T(ee.internalFormat,Se,_e,ee.colorSpace),Ye=je(S);$&&Qe(S)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Ye,we,S.width,S.height):Qe(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Ye,we,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,we,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ke(R,S){if(S&&S.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const j=i.get(S.depthTexture);j.__renderTarget=S,(!j.__webglTexture||S.depthTexture.image.width!==S.width||S.depthTexture.image.height!==S.height)&&(S.depthTexture.image.width=S.width,S.depthTexture.image.height=S.height,S.depthTexture.needsUpdate=!0),K(S.depthTexture,0);const V=j.__webglTexture,ee=je(S);if(S.depthTexture.format===_r)Qe(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,V,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,V,0);else if(S.depthTexture.format===Pr)Qe(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,V,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,V,0);else throw new Error("Unknown depthTexture format")}function He(R){const S=i.get(R),$=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){const j=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),j){const V=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,j.removeEventListener("dispose",V)};j.addEventListener("dispose",V),S.__depthDisposeCallback=V}S.__boundDepthTexture=j}if(R.depthTexture&&!S.__autoAllocateDepthBuffer){if($)throw new Error("target.depthTexture not supported in Cube render targets");ke(S.__webglFramebuffer,R)}else if($){S.__webglDepthbuffer=[];for(let j=0;j<6;j++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[j]),S.__webglDepthbuffer[j]===void 0)S.__webglDepthbuffer[j]=n.createRenderbuffer(),ae(S.__webglDepthbuffer[j],R,!1);else{const V=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ee=S.__webglDepthbuffer[j];n.bindRenderbuffer(n.RENDERBUFFER,ee),n.framebufferRenderbuffer(n.FRAMEBUFFER,V,n.RENDERBUFFER,ee)}}else if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),ae(S.__webglDepthbuffer,R,!1);else{const j=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,V=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,V),n.framebufferRenderbuffer(n.FRAMEBUFFER,j,n.RENDERBUFFER,V)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Ie(R,S,$){const j=i.get(R);S!==void 0&&ge(j.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&He(R)}function at(R){const S=R.texture,$=i.get(R),j=i.get(S);R.addEventListener("dispose",D);const V=R.textures,ee=R.isWebGLCubeRenderTarget===!0,Se=V.length>1;if(Se||(j.__webglTexture===void 0&&(j.__webglTexture=n.createTexture()),j.__version=S.version,a.memory.textures++),ee){$.__webglFramebuffer=[];for(let _e=0;_e<6;_e++)if(S.mipmaps&&S.mipmaps.length>0){$.__webglFramebuffer[_e]=[];for(let we=0;we<S.mipmaps.length;we++)$.__webglFramebuffer[_e][we]=n.createFramebuffer()}else $.__webglFramebuffer[_e]=n.createFramebuffer()}else{if(S.mipmaps&&S.mipmaps.length>0){$.__webglFramebuffer=[];for(let _e=0;_e<S.mipmaps.length;_e++)$.__webglFramebuffer[_e]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(Se)for(let _e=0,we=V.length;_e<we;_e++){const Ye=i.get(V[_e]);Ye.__webglTexture===void 0&&(Ye.__webglTexture=n.createTexture(),a.memory.textures++)}if(R.samples>0&&Qe(R)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let _e=0;_e<V.length;_e++){const we=V[_e];$.__webglColorRenderbuffer[_e]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[_e]);const Ye=r.convert(we.format,we.colorSpace),fe=r.convert(we.type),ve=T(we.internalFormat,Ye,fe,we.colorSpace,R.isXRRenderTarget===!0),Ne=je(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,Ne,ve,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.RENDERBUFFER,$.__webglColorRenderbuffer[_e])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),ae($.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ee){t.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture),Me(n.TEXTURE_CUBE_MAP,S);for(let _e=0;_e<6;_e++)if(S.mipmaps&&S.mipmaps.length>0)for(let we=0;we<S.mipmaps.length;we++)ge($.__webglFramebuffer[_e][we],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,we);else ge($.__webglFramebuffer[_e],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0);m(S)&&d(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Se){for(let _e=0,we=V.length;_e<we;_e++){const Ye=V[_e],fe=i.get(Ye);t.bindTexture(n.TEXTURE_2D,fe.__webglTexture),Me(n.TEXTURE_2D,Ye),ge($.__webglFramebuffer,R,Ye,n.COLOR_ATTACHMENT0+_e,n.TEXTURE_2D,0),m(Ye)&&d(n.TEXTURE_2D)}t.unbindTexture()}else{let _e=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(_e=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(_e,j.__webglTexture),Me(_e,S),S.mipmaps&&S.mipmaps.length>0)for(let we=0;we<S.mipmaps.length;we++)ge($.__webglFramebuffer[we],R,S,n.COLOR_ATTACHMENT0,_e,we);else ge($.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,_e,0);m(S)&&d(_e),t.unbindTexture()}R.depthBuffer&&He(R)}function Ze(R){const S=R.textures;for(let $=0,j=S.length;$<j;$++){const V=S[$];if(m(V)){const ee=w(R),Se=i.get(V).__webglTexture;t.bindTexture(ee,Se),d(ee),t.unbindTexture()}}}const ot=[],k=[];function Xt(R){if(R.samples>0){if(Qe(R)===!1){const S=R.textures,$=R.width,j=R.height;let V=n.COLOR_BUFFER_BIT;const ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(R),_e=S.length>1;if(_e)for(let we=0;we<S.length;we++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+we,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+we,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let we=0;we<S.length;we++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(V|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(V|=n.STENCIL_BUFFER_BIT)),_e){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[we]);const Ye=i.get(S[we]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Ye,0)}n.blitFramebuffer(0,0,$,j,0,0,$,j,V,n.NEAREST),l===!0&&(ot.length=0,k.length=0,ot.push(n.COLOR_ATTACHMENT0+we),R.depthBuffer&&R.resolveDepthBuffer===!1&&(ot.push(ee),k.push(ee),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,k)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,ot))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),_e)for(let we=0;we<S.length;we++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+we,n.RENDERBUFFER,Se.__webglColorRenderbuffer[we]);const Ye=i.get(S[we]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+we,n.TEXTURE_2D,Ye,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&l){const S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function je(R){return Math.min(s.maxSamples,R.samples)}function Qe(R){const S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ve(R){const S=a.render.frame;h.get(R)!==S&&(h.set(R,S),R.update())}function ct(R,S){const $=R.colorSpace,j=R.format,V=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||$!==Os&&$!==Ki&&(ft.getTransfer($)===yt?(j!==ti||V!==Ni)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",$)),S}function Pe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=B,this.resetTextureUnits=Y,this.setTexture2D=K,this.setTexture2DArray=Z,this.setTexture3D=J,this.setTextureCube=Q,this.rebindTextures=Ie,this.setupRenderTarget=at,this.updateRenderTargetMipmap=Ze,this.updateMultisampleRenderTarget=Xt,this.setupDepthRenderbuffer=He,this.setupFrameBufferTexture=ge,this.useMultisampledRTT=Qe}function IE(n,e){function t(i,s=Ki){let r;const a=ft.getTransfer(s);if(i===Ni)return n.UNSIGNED_BYTE;if(i===hu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===fu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ap)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===sp)return n.BYTE;if(i===rp)return n.SHORT;if(i===oa)return n.UNSIGNED_SHORT;if(i===uu)return n.INT;if(i===Us)return n.UNSIGNED_INT;if(i===Ri)return n.FLOAT;if(i===ha)return n.HALF_FLOAT;if(i===op)return n.ALPHA;if(i===lp)return n.RGB;if(i===ti)return n.RGBA;if(i===cp)return n.LUMINANCE;if(i===up)return n.LUMINANCE_ALPHA;if(i===_r)return n.DEPTH_COMPONENT;if(i===Pr)return n.DEPTH_STENCIL;if(i===hp)return n.RED;if(i===du)return n.RED_INTEGER;if(i===fp)return n.RG;if(i===pu)return n.RG_INTEGER;if(i===mu)return n.RGBA_INTEGER;if(i===so||i===ro||i===ao||i===oo)if(a===yt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===so)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ro)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ao)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===oo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===so)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ro)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ao)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===oo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===_c||i===vc||i===xc||i===Mc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===_c)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===vc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===xc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Mc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Sc||i===yc||i===Ec)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Sc||i===yc)return a===yt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ec)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Tc||i===wc||i===bc||i===Ac||i===Rc||i===Cc||i===Pc||i===Lc||i===Dc||i===Uc||i===Ic||i===Nc||i===Fc||i===Oc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Tc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===wc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===bc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ac)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Rc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Cc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Pc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Lc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Dc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Uc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ic)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Nc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Fc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Oc)return a===yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===lo||i===Bc||i===kc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===lo)return a===yt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Bc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===kc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===dp||i===zc||i===Hc||i===Vc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===lo)return r.COMPRESSED_RED_RGTC1_EXT;if(i===zc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Hc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Vc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Cr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}class NE extends Jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.cameras=e}}class ja extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}}const FE={type:"move"};class Bl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ja,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ja,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new ne,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new ne),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ja,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new ne,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new ne),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,a=null;const o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(const x of e.hand.values()){const m=t.getJointPose(x,i),d=this._getHandJoint(c,x);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),p=.02,_=.005;c.inputState.pinching&&f>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));o!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.rotation,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(FE)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new ja;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}const OE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,BE=`
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

}`;class kE{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,i){if(this.texture===null){const s=new Tn,r=e.properties.get(s);r.__webglTexture=t.texture,(t.depthNear!=i.depthNear||t.depthFar!=i.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new ns({vertexShader:OE,fragmentShader:BE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new pi(new No(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class zE extends Nr{constructor(e,t){super();const i=this;let s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,f=null,p=null,_=null;const x=new kE,m=t.getContextAttributes();let d=null,w=null;const T=[],v=[],H=new Tt;let L=null;const D=new Jn;D.viewport=new zt;const F=new Jn;F.viewport=new zt;const b=[D,F],y=new NE;let P=null,Y=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ie){let oe=T[ie];return oe===void 0&&(oe=new Bl,T[ie]=oe),oe.getTargetRaySpace()},this.getControllerGrip=function(ie){let oe=T[ie];return oe===void 0&&(oe=new Bl,T[ie]=oe),oe.getGripSpace()},this.getHand=function(ie){let oe=T[ie];return oe===void 0&&(oe=new Bl,T[ie]=oe),oe.getHandSpace()};function B(ie){const oe=v.indexOf(ie.inputSource);if(oe===-1)return;const ge=T[oe];ge!==void 0&&(ge.update(ie.inputSource,ie.frame,c||a),ge.dispatchEvent({type:ie.type,data:ie.inputSource}))}function q(){s.removeEventListener("select",B),s.removeEventListener("selectstart",B),s.removeEventListener("selectend",B),s.removeEventListener("squeeze",B),s.removeEventListener("squeezestart",B),s.removeEventListener("squeezeend",B),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",K);for(let ie=0;ie<T.length;ie++){const oe=v[ie];oe!==null&&(v[ie]=null,T[ie].disconnect(oe))}P=null,Y=null,x.reset(),e.setRenderTarget(d),p=null,f=null,u=null,s=null,w=null,pe.stop(),i.isPresenting=!1,e.setPixelRatio(L),e.setSize(H.width,H.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ie){r=ie,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ie){o=ie,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(ie){c=ie},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ie){if(s=ie,s!==null){if(d=e.getRenderTarget(),s.addEventListener("select",B),s.addEventListener("selectstart",B),s.addEventListener("selectend",B),s.addEventListener("squeeze",B),s.addEventListener("squeezestart",B),s.addEventListener("squeezeend",B),s.addEventListener("end",q),s.addEventListener("inputsourceschange",K),m.xrCompatible!==!0&&await t.makeXRCompatible(),L=e.getPixelRatio(),e.getSize(H),s.renderState.layers===void 0){const oe={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,oe),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),w=new Is(p.framebufferWidth,p.framebufferHeight,{format:ti,type:Ni,colorSpace:e.outputColorSpace,stencilBuffer:m.stencil})}else{let oe=null,ge=null,ae=null;m.depth&&(ae=m.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,oe=m.stencil?Pr:_r,ge=m.stencil?Cr:Us);const ke={colorFormat:t.RGBA8,depthFormat:ae,scaleFactor:r};u=new XRWebGLBinding(s,t),f=u.createProjectionLayer(ke),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),w=new Is(f.textureWidth,f.textureHeight,{format:ti,type:Ni,depthTexture:new Rp(f.textureWidth,f.textureHeight,ge,void 0,void 0,void 0,void 0,void 0,void 0,oe),stencilBuffer:m.stencil,colorSpace:e.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),pe.setContext(s),pe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return x.getDepthTexture()};function K(ie){for(let oe=0;oe<ie.removed.length;oe++){const ge=ie.removed[oe],ae=v.indexOf(ge);ae>=0&&(v[ae]=null,T[ae].disconnect(ge))}for(let oe=0;oe<ie.added.length;oe++){const ge=ie.added[oe];let ae=v.indexOf(ge);if(ae===-1){for(let He=0;He<T.length;He++)if(He>=v.length){v.push(ge),ae=He;break}else if(v[He]===null){v[He]=ge,ae=He;break}if(ae===-1)break}const ke=T[ae];ke&&ke.connect(ge)}}const Z=new ne,J=new ne;function Q(ie,oe,ge){Z.setFromMatrixPosition(oe.matrixWorld),J.setFromMatrixPosition(ge.matrixWorld);const ae=Z.distanceTo(J),ke=oe.projectionMatrix.elements,He=ge.projectionMatrix.elements,Ie=ke[14]/(ke[10]-1),at=ke[14]/(ke[10]+1),Ze=(ke[9]+1)/ke[5],ot=(ke[9]-1)/ke[5],k=(ke[8]-1)/ke[0],Xt=(He[8]+1)/He[0],je=Ie*k,Qe=Ie*Xt,Ve=ae/(-k+Xt),ct=Ve*-k;if(oe.matrixWorld.decompose(ie.position,ie.quaternion,ie.scale),ie.translateX(ct),ie.translateZ(Ve),ie.matrixWorld.compose(ie.position,ie.quaternion,ie.scale),ie.matrixWorldInverse.copy(ie.matrixWorld).invert(),ke[10]===-1)ie.projectionMatrix.copy(oe.projectionMatrix),ie.projectionMatrixInverse.copy(oe.projectionMatrixInverse);else{const Pe=Ie+Ve,R=at+Ve,S=je-ct,$=Qe+(ae-ct),j=Ze*at/R*Pe,V=ot*at/R*Pe;ie.projectionMatrix.makePerspective(S,$,j,V,Pe,R),ie.projectionMatrixInverse.copy(ie.projectionMatrix).invert()}}function he(ie,oe){oe===null?ie.matrixWorld.copy(ie.matrix):ie.matrixWorld.multiplyMatrices(oe.matrixWorld,ie.matrix),ie.matrixWorldInverse.copy(ie.matrixWorld).invert()}this.updateCamera=function(ie){if(s===null)return;let oe=ie.near,ge=ie.far;x.texture!==null&&(x.depthNear>0&&(oe=x.depthNear),x.depthFar>0&&(ge=x.depthFar)),y.near=F.near=D.near=oe,y.far=F.far=D.far=ge,(P!==y.near||Y!==y.far)&&(s.updateRenderState({depthNear:y.near,depthFar:y.far}),P=y.near,Y=y.far),D.layers.mask=ie.layers.mask|2,F.layers.mask=ie.layers.mask|4,y.layers.mask=D.layers.mask|F.layers.mask;const ae=ie.parent,ke=y.cameras;he(y,ae);for(let He=0;He<ke.length;He++)he(ke[He],ae);ke.length===2?Q(y,D,F):y.projectionMatrix.copy(D.projectionMatrix),ce(ie,y,ae)};function ce(ie,oe,ge){ge===null?ie.matrix.copy(oe.matrixWorld):(ie.matrix.copy(ge.matrixWorld),ie.matrix.invert(),ie.matrix.multiply(oe.matrixWorld)),ie.matrix.decompose(ie.position,ie.quaternion,ie.scale),ie.updateMatrixWorld(!0),ie.projectionMatrix.copy(oe.projectionMatrix),ie.projectionMatrixInverse.copy(oe.projectionMatrixInverse),ie.isPerspectiveCamera&&(ie.fov=Gc*2*Math.atan(1/ie.projectionMatrix.elements[5]),ie.zoom=1)}this.getCamera=function(){return y},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(ie){l=ie,f!==null&&(f.fixedFoveation=ie),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ie)},this.hasDepthSensing=function(){return x.texture!==null},this.getDepthSensingMesh=function(){return x.getMesh(y)};let me=null;function Me(ie,oe){if(h=oe.getViewerPose(c||a),_=oe,h!==null){const ge=h.views;p!==null&&(e.setRenderTargetFramebuffer(w,p.framebuffer),e.setRenderTarget(w));let ae=!1;ge.length!==y.cameras.length&&(y.cameras.length=0,ae=!0);for(let He=0;He<ge.length;He++){const Ie=ge[He];let at=null;if(p!==null)at=p.getViewport(Ie);else{const ot=u.getViewSubImage(f,Ie);at=ot.viewport,He===0&&(e.setRenderTargetTextures(w,ot.colorTexture,f.ignoreDepthValues?void 0:ot.depthStencilTexture),e.setRenderTarget(w))}let Ze=b[He];Ze===void 0&&(Ze=new Jn,Ze.layers.enable(He),Ze.viewport=new zt,b[He]=Ze),Ze.matrix.fromArray(Ie.transform.matrix),Ze.matrix.decompose(Ze.position,Ze.quaternion,Ze.scale),Ze.projectionMatrix.fromArray(Ie.projectionMatrix),Ze.projectionMatrixInverse.copy(Ze.projectionMatrix).invert(),Ze.viewport.set(at.x,at.y,at.width,at.height),He===0&&(y.matrix.copy(Ze.matrix),y.matrix.decompose(y.position,y.quaternion,y.scale)),ae===!0&&y.cameras.push(Ze)}const ke=s.enabledFeatures;if(ke&&ke.includes("depth-sensing")){const He=u.getDepthInformation(ge[0]);He&&He.isValid&&He.texture&&x.init(e,He,s.renderState)}}for(let ge=0;ge<T.length;ge++){const ae=v[ge],ke=T[ge];ae!==null&&ke!==void 0&&ke.update(ae,oe,c||a)}me&&me(ie,oe),oe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:oe}),_=null}const pe=new bp;pe.setAnimationLoop(Me),this.setAnimationLoop=function(ie){me=ie},this.dispose=function(){}}}const ms=new Fi,HE=new Wt;function VE(n,e){function t(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function i(m,d){d.color.getRGB(m.fogColor.value,yp(n)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,w,T,v){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(m,d):d.isMeshToonMaterial?(r(m,d),u(m,d)):d.isMeshPhongMaterial?(r(m,d),h(m,d)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,v)):d.isMeshMatcapMaterial?(r(m,d),_(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),x(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(a(m,d),d.isLineDashedMaterial&&o(m,d)):d.isPointsMaterial?l(m,d,w,T):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,t(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,t(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===En&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,t(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===En&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,t(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,t(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);const w=e.get(d),T=w.envMap,v=w.envMapRotation;T&&(m.envMap.value=T,ms.copy(v),ms.x*=-1,ms.y*=-1,ms.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(ms.y*=-1,ms.z*=-1),m.envMapRotation.value.setFromMatrix4(HE.makeRotationFromEuler(ms)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,m.aoMapTransform))}function a(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,t(d.map,m.mapTransform))}function o(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,w,T){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*w,m.scale.value=T*.5,d.map&&(m.map.value=d.map,t(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,t(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function h(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function u(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,w){m.ior.value=d.ior,d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===En&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=w.texture,m.transmissionSamplerSize.value.set(w.width,w.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,d){d.matcap&&(m.matcap.value=d.matcap)}function x(m,d){const w=e.get(d).light;m.referencePosition.value.setFromMatrixPosition(w.matrixWorld),m.nearDistance.value=w.shadow.camera.near,m.farDistance.value=w.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function GE(n,e,t,i){let s={},r={},a=[];const o=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(w,T){const v=T.program;i.uniformBlockBinding(w,v)}function c(w,T){let v=s[w.id];v===void 0&&(_(w),v=h(w),s[w.id]=v,w.addEventListener("dispose",m));const H=T.program;i.updateUBOMapping(w,H);const L=e.render.frame;r[w.id]!==L&&(f(w),r[w.id]=L)}function h(w){const T=u();w.__bindingPointIndex=T;const v=n.createBuffer(),H=w.__size,L=w.usage;return n.bindBuffer(n.UNIFORM_BUFFER,v),n.bufferData(n.UNIFORM_BUFFER,H,L),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,T,v),v}function u(){for(let w=0;w<o;w++)if(a.indexOf(w)===-1)return a.push(w),w;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(w){const T=s[w.id],v=w.uniforms,H=w.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let L=0,D=v.length;L<D;L++){const F=Array.isArray(v[L])?v[L]:[v[L]];for(let b=0,y=F.length;b<y;b++){const P=F[b];if(p(P,L,b,H)===!0){const Y=P.__offset,B=Array.isArray(P.value)?P.value:[P.value];let q=0;for(let K=0;K<B.length;K++){const Z=B[K],J=x(Z);typeof Z=="number"||typeof Z=="boolean"?(P.__data[0]=Z,n.bufferSubData(n.UNIFORM_BUFFER,Y+q,P.__data)):Z.isMatrix3?(P.__data[0]=Z.elements[0],P.__data[1]=Z.elements[1],P.__data[2]=Z.elements[2],P.__data[3]=0,P.__data[4]=Z.elements[3],P.__data[5]=Z.elements[4],P.__data[6]=Z.elements[5],P.__data[7]=0,P.__data[8]=Z.elements[6],P.__data[9]=Z.elements[7],P.__data[10]=Z.elements[8],P.__data[11]=0):(Z.toArray(P.__data,q),q+=J.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,Y,P.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function p(w,T,v,H){const L=w.value,D=T+"_"+v;if(H[D]===void 0)return typeof L=="number"||typeof L=="boolean"?H[D]=L:H[D]=L.clone(),!0;{const F=H[D];if(typeof L=="number"||typeof L=="boolean"){if(F!==L)return H[D]=L,!0}else if(F.equals(L)===!1)return F.copy(L),!0}return!1}function _(w){const T=w.uniforms;let v=0;const H=16;for(let D=0,F=T.length;D<F;D++){const b=Array.isArray(T[D])?T[D]:[T[D]];for(let y=0,P=b.length;y<P;y++){const Y=b[y],B=Array.isArray(Y.value)?Y.value:[Y.value];for(let q=0,K=B.length;q<K;q++){const Z=B[q],J=x(Z),Q=v%H,he=Q%J.boundary,ce=Q+he;v+=he,ce!==0&&H-ce<J.storage&&(v+=H-ce),Y.__data=new Float32Array(J.storage/Float32Array.BYTES_PER_ELEMENT),Y.__offset=v,v+=J.storage}}}const L=v%H;return L>0&&(v+=H-L),w.__size=v,w.__cache={},this}function x(w){const T={boundary:0,storage:0};return typeof w=="number"||typeof w=="boolean"?(T.boundary=4,T.storage=4):w.isVector2?(T.boundary=8,T.storage=8):w.isVector3||w.isColor?(T.boundary=16,T.storage=12):w.isVector4?(T.boundary=16,T.storage=16):w.isMatrix3?(T.boundary=48,T.storage=48):w.isMatrix4?(T.boundary=64,T.storage=64):w.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",w),T}function m(w){const T=w.target;T.removeEventListener("dispose",m);const v=a.indexOf(T.__bindingPointIndex);a.splice(v,1),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function d(){for(const w in s)n.deleteBuffer(s[w]);a=[],s={},r={}}return{bind:l,update:c,dispose:d}}class WE{constructor(e={}){const{canvas:t=Lv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=a;const _=new Uint32Array(4),x=new Int32Array(4);let m=null,d=null;const w=[],T=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=Hn,this.toneMapping=Ji,this.toneMappingExposure=1;const v=this;let H=!1,L=0,D=0,F=null,b=-1,y=null;const P=new zt,Y=new zt;let B=null;const q=new Et(0);let K=0,Z=t.width,J=t.height,Q=1,he=null,ce=null;const me=new zt(0,0,Z,J),Me=new zt(0,0,Z,J);let pe=!1;const ie=new wp;let oe=!1,ge=!1;const ae=new Wt,ke=new Wt,He=new ne,Ie=new zt,at={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Ze=!1;function ot(){return F===null?Q:1}let k=i;function Xt(E,N){return t.getContext(E,N)}try{const E={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${cu}`),t.addEventListener("webglcontextlost",re,!1),t.addEventListener("webglcontextrestored",be,!1),t.addEventListener("webglcontextcreationerror",Ae,!1),k===null){const N="webgl2";if(k=Xt(N,E),k===null)throw Xt(N)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let je,Qe,Ve,ct,Pe,R,S,$,j,V,ee,Se,_e,we,Ye,fe,ve,Ne,Oe,Ee,tt,qe,ut,O;function xe(){je=new ZS(k),je.init(),qe=new IE(k,je),Qe=new GS(k,je,e,qe),Ve=new LE(k,je),Qe.reverseDepthBuffer&&f&&Ve.buffers.depth.setReversed(!0),ct=new JS(k),Pe=new gE,R=new UE(k,je,Ve,Pe,Qe,qe,ct),S=new XS(v),$=new YS(v),j=new rx(k),ut=new HS(k,j),V=new KS(k,j,ct,ut),ee=new ey(k,V,j,ct),Oe=new QS(k,Qe,R),fe=new WS(Pe),Se=new mE(v,S,$,je,Qe,ut,fe),_e=new VE(v,Pe),we=new vE,Ye=new TE(je),Ne=new zS(v,S,$,Ve,ee,p,l),ve=new CE(v,ee,Qe),O=new GE(k,ct,Qe,Ve),Ee=new VS(k,je,ct),tt=new jS(k,je,ct),ct.programs=Se.programs,v.capabilities=Qe,v.extensions=je,v.properties=Pe,v.renderLists=we,v.shadowMap=ve,v.state=Ve,v.info=ct}xe();const te=new zE(v,k);this.xr=te,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){const E=je.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){const E=je.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(E){E!==void 0&&(Q=E,this.setSize(Z,J,!1))},this.getSize=function(E){return E.set(Z,J)},this.setSize=function(E,N,G=!0){if(te.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Z=E,J=N,t.width=Math.floor(E*Q),t.height=Math.floor(N*Q),G===!0&&(t.style.width=E+"px",t.style.height=N+"px"),this.setViewport(0,0,E,N)},this.getDrawingBufferSize=function(E){return E.set(Z*Q,J*Q).floor()},this.setDrawingBufferSize=function(E,N,G){Z=E,J=N,Q=G,t.width=Math.floor(E*G),t.height=Math.floor(N*G),this.setViewport(0,0,E,N)},this.getCurrentViewport=function(E){return E.copy(P)},this.getViewport=function(E){return E.copy(me)},this.setViewport=function(E,N,G,W){E.isVector4?me.set(E.x,E.y,E.z,E.w):me.set(E,N,G,W),Ve.viewport(P.copy(me).multiplyScalar(Q).round())},this.getScissor=function(E){return E.copy(Me)},this.setScissor=function(E,N,G,W){E.isVector4?Me.set(E.x,E.y,E.z,E.w):Me.set(E,N,G,W),Ve.scissor(Y.copy(Me).multiplyScalar(Q).round())},this.getScissorTest=function(){return pe},this.setScissorTest=function(E){Ve.setScissorTest(pe=E)},this.setOpaqueSort=function(E){he=E},this.setTransparentSort=function(E){ce=E},this.getClearColor=function(E){return E.copy(Ne.getClearColor())},this.setClearColor=function(){Ne.setClearColor.apply(Ne,arguments)},this.getClearAlpha=function(){return Ne.getClearAlpha()},this.setClearAlpha=function(){Ne.setClearAlpha.apply(Ne,arguments)},this.clear=function(E=!0,N=!0,G=!0){let W=0;if(E){let z=!1;if(F!==null){const ue=F.texture.format;z=ue===mu||ue===pu||ue===du}if(z){const ue=F.texture.type,ye=ue===Ni||ue===Us||ue===oa||ue===Cr||ue===hu||ue===fu,Fe=Ne.getClearColor(),De=Ne.getClearAlpha(),Ge=Fe.r,Xe=Fe.g,Ue=Fe.b;ye?(_[0]=Ge,_[1]=Xe,_[2]=Ue,_[3]=De,k.clearBufferuiv(k.COLOR,0,_)):(x[0]=Ge,x[1]=Xe,x[2]=Ue,x[3]=De,k.clearBufferiv(k.COLOR,0,x))}else W|=k.COLOR_BUFFER_BIT}N&&(W|=k.DEPTH_BUFFER_BIT),G&&(W|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k.clear(W)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",re,!1),t.removeEventListener("webglcontextrestored",be,!1),t.removeEventListener("webglcontextcreationerror",Ae,!1),we.dispose(),Ye.dispose(),Pe.dispose(),S.dispose(),$.dispose(),ee.dispose(),ut.dispose(),O.dispose(),Se.dispose(),te.dispose(),te.removeEventListener("sessionstart",wn),te.removeEventListener("sessionend",_i),xn.stop()};function re(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),H=!0}function be(){console.log("THREE.WebGLRenderer: Context Restored."),H=!1;const E=ct.autoReset,N=ve.enabled,G=ve.autoUpdate,W=ve.needsUpdate,z=ve.type;xe(),ct.autoReset=E,ve.enabled=N,ve.autoUpdate=G,ve.needsUpdate=W,ve.type=z}function Ae(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function Ke(E){const N=E.target;N.removeEventListener("dispose",Ke),It(N)}function It(E){Jt(E),Pe.remove(E)}function Jt(E){const N=Pe.get(E).programs;N!==void 0&&(N.forEach(function(G){Se.releaseProgram(G)}),E.isShaderMaterial&&Se.releaseShaderCache(E))}this.renderBufferDirect=function(E,N,G,W,z,ue){N===null&&(N=at);const ye=z.isMesh&&z.matrixWorld.determinant()<0,Fe=Bo(E,N,G,W,z);Ve.setMaterial(W,ye);let De=G.index,Ge=1;if(W.wireframe===!0){if(De=V.getWireframeAttribute(G),De===void 0)return;Ge=2}const Xe=G.drawRange,Ue=G.attributes.position;let it=Xe.start*Ge,vt=(Xe.start+Xe.count)*Ge;ue!==null&&(it=Math.max(it,ue.start*Ge),vt=Math.min(vt,(ue.start+ue.count)*Ge)),De!==null?(it=Math.max(it,0),vt=Math.min(vt,De.count)):Ue!=null&&(it=Math.max(it,0),vt=Math.min(vt,Ue.count));const Mt=vt-it;if(Mt<0||Mt===1/0)return;ut.setup(z,W,Fe,G,De);let Qt,lt=Ee;if(De!==null&&(Qt=j.get(De),lt=tt,lt.setIndex(Qt)),z.isMesh)W.wireframe===!0?(Ve.setLineWidth(W.wireframeLinewidth*ot()),lt.setMode(k.LINES)):lt.setMode(k.TRIANGLES);else if(z.isLine){let Be=W.linewidth;Be===void 0&&(Be=1),Ve.setLineWidth(Be*ot()),z.isLineSegments?lt.setMode(k.LINES):z.isLineLoop?lt.setMode(k.LINE_LOOP):lt.setMode(k.LINE_STRIP)}else z.isPoints?lt.setMode(k.POINTS):z.isSprite&&lt.setMode(k.TRIANGLES);if(z.isBatchedMesh)if(z._multiDrawInstances!==null)lt.renderMultiDrawInstances(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount,z._multiDrawInstances);else if(je.get("WEBGL_multi_draw"))lt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{const Be=z._multiDrawStarts,Nt=z._multiDrawCounts,ht=z._multiDrawCount,Mn=De?j.get(De).bytesPerElement:1,si=Pe.get(W).currentProgram.getUniforms();for(let ln=0;ln<ht;ln++)si.setValue(k,"_gl_DrawID",ln),lt.render(Be[ln]/Mn,Nt[ln])}else if(z.isInstancedMesh)lt.renderInstances(it,Mt,z.count);else if(G.isInstancedBufferGeometry){const Be=G._maxInstanceCount!==void 0?G._maxInstanceCount:1/0,Nt=Math.min(G.instanceCount,Be);lt.renderInstances(it,Mt,Nt)}else lt.render(it,Mt)};function mt(E,N,G){E.transparent===!0&&E.side===fi&&E.forceSinglePass===!1?(E.side=En,E.needsUpdate=!0,Bs(E,N,G),E.side=ts,E.needsUpdate=!0,Bs(E,N,G),E.side=fi):Bs(E,N,G)}this.compile=function(E,N,G=null){G===null&&(G=E),d=Ye.get(G),d.init(N),T.push(d),G.traverseVisible(function(z){z.isLight&&z.layers.test(N.layers)&&(d.pushLight(z),z.castShadow&&d.pushShadow(z))}),E!==G&&E.traverseVisible(function(z){z.isLight&&z.layers.test(N.layers)&&(d.pushLight(z),z.castShadow&&d.pushShadow(z))}),d.setupLights();const W=new Set;return E.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;const ue=z.material;if(ue)if(Array.isArray(ue))for(let ye=0;ye<ue.length;ye++){const Fe=ue[ye];mt(Fe,G,z),W.add(Fe)}else mt(ue,G,z),W.add(ue)}),T.pop(),d=null,W},this.compileAsync=function(E,N,G=null){const W=this.compile(E,N,G);return new Promise(z=>{function ue(){if(W.forEach(function(ye){Pe.get(ye).currentProgram.isReady()&&W.delete(ye)}),W.size===0){z(E);return}setTimeout(ue,10)}je.get("KHR_parallel_shader_compile")!==null?ue():setTimeout(ue,10)})};let qt=null;function Rt(E){qt&&qt(E)}function wn(){xn.stop()}function _i(){xn.start()}const xn=new bp;xn.setAnimationLoop(Rt),typeof self<"u"&&xn.setContext(self),this.setAnimationLoop=function(E){qt=E,te.setAnimationLoop(E),E===null?xn.stop():xn.start()},te.addEventListener("sessionstart",wn),te.addEventListener("sessionend",_i),this.render=function(E,N){if(N!==void 0&&N.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(H===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),te.enabled===!0&&te.isPresenting===!0&&(te.cameraAutoUpdate===!0&&te.updateCamera(N),N=te.getCamera()),E.isScene===!0&&E.onBeforeRender(v,E,N,F),d=Ye.get(E,T.length),d.init(N),T.push(d),ke.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),ie.setFromProjectionMatrix(ke),ge=this.localClippingEnabled,oe=fe.init(this.clippingPlanes,ge),m=we.get(E,w.length),m.init(),w.push(m),te.enabled===!0&&te.isPresenting===!0){const ue=v.xr.getDepthSensingMesh();ue!==null&&on(ue,N,-1/0,v.sortObjects)}on(E,N,0,v.sortObjects),m.finish(),v.sortObjects===!0&&m.sort(he,ce),Ze=te.enabled===!1||te.isPresenting===!1||te.hasDepthSensing()===!1,Ze&&Ne.addToRenderList(m,E),this.info.render.frame++,oe===!0&&fe.beginShadows();const G=d.state.shadowsArray;ve.render(G,E,N),oe===!0&&fe.endShadows(),this.info.autoReset===!0&&this.info.reset();const W=m.opaque,z=m.transmissive;if(d.setupLights(),N.isArrayCamera){const ue=N.cameras;if(z.length>0)for(let ye=0,Fe=ue.length;ye<Fe;ye++){const De=ue[ye];xi(W,z,E,De)}Ze&&Ne.render(E);for(let ye=0,Fe=ue.length;ye<Fe;ye++){const De=ue[ye];vi(m,E,De,De.viewport)}}else z.length>0&&xi(W,z,E,N),Ze&&Ne.render(E),vi(m,E,N);F!==null&&(R.updateMultisampleRenderTarget(F),R.updateRenderTargetMipmap(F)),E.isScene===!0&&E.onAfterRender(v,E,N),ut.resetDefaultState(),b=-1,y=null,T.pop(),T.length>0?(d=T[T.length-1],oe===!0&&fe.setGlobalState(v.clippingPlanes,d.state.camera)):d=null,w.pop(),w.length>0?m=w[w.length-1]:m=null};function on(E,N,G,W){if(E.visible===!1)return;if(E.layers.test(N.layers)){if(E.isGroup)G=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(N);else if(E.isLight)d.pushLight(E),E.castShadow&&d.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||ie.intersectsSprite(E)){W&&Ie.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ke);const ye=ee.update(E),Fe=E.material;Fe.visible&&m.push(E,ye,Fe,G,Ie.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||ie.intersectsObject(E))){const ye=ee.update(E),Fe=E.material;if(W&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ie.copy(E.boundingSphere.center)):(ye.boundingSphere===null&&ye.computeBoundingSphere(),Ie.copy(ye.boundingSphere.center)),Ie.applyMatrix4(E.matrixWorld).applyMatrix4(ke)),Array.isArray(Fe)){const De=ye.groups;for(let Ge=0,Xe=De.length;Ge<Xe;Ge++){const Ue=De[Ge],it=Fe[Ue.materialIndex];it&&it.visible&&m.push(E,ye,it,G,Ie.z,Ue)}}else Fe.visible&&m.push(E,ye,Fe,G,Ie.z,null)}}const ue=E.children;for(let ye=0,Fe=ue.length;ye<Fe;ye++)on(ue[ye],N,G,W)}function vi(E,N,G,W){const z=E.opaque,ue=E.transmissive,ye=E.transparent;d.setupLightsView(G),oe===!0&&fe.setGlobalState(v.clippingPlanes,G),W&&Ve.viewport(P.copy(W)),z.length>0&&ss(z,N,G),ue.length>0&&ss(ue,N,G),ye.length>0&&ss(ye,N,G),Ve.buffers.depth.setTest(!0),Ve.buffers.depth.setMask(!0),Ve.buffers.color.setMask(!0),Ve.setPolygonOffset(!1)}function xi(E,N,G,W){if((G.isScene===!0?G.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[W.id]===void 0&&(d.state.transmissionRenderTarget[W.id]=new Is(1,1,{generateMipmaps:!0,type:je.has("EXT_color_buffer_half_float")||je.has("EXT_color_buffer_float")?ha:Ni,minFilter:Ts,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ft.workingColorSpace}));const ue=d.state.transmissionRenderTarget[W.id],ye=W.viewport||P;ue.setSize(ye.z,ye.w);const Fe=v.getRenderTarget();v.setRenderTarget(ue),v.getClearColor(q),K=v.getClearAlpha(),K<1&&v.setClearColor(16777215,.5),v.clear(),Ze&&Ne.render(G);const De=v.toneMapping;v.toneMapping=Ji;const Ge=W.viewport;if(W.viewport!==void 0&&(W.viewport=void 0),d.setupLightsView(W),oe===!0&&fe.setGlobalState(v.clippingPlanes,W),ss(E,G,W),R.updateMultisampleRenderTarget(ue),R.updateRenderTargetMipmap(ue),je.has("WEBGL_multisampled_render_to_texture")===!1){let Xe=!1;for(let Ue=0,it=N.length;Ue<it;Ue++){const vt=N[Ue],Mt=vt.object,Qt=vt.geometry,lt=vt.material,Be=vt.group;if(lt.side===fi&&Mt.layers.test(W.layers)){const Nt=lt.side;lt.side=En,lt.needsUpdate=!0,Or(Mt,G,W,Qt,lt,Be),lt.side=Nt,lt.needsUpdate=!0,Xe=!0}}Xe===!0&&(R.updateMultisampleRenderTarget(ue),R.updateRenderTargetMipmap(ue))}v.setRenderTarget(Fe),v.setClearColor(q,K),Ge!==void 0&&(W.viewport=Ge),v.toneMapping=De}function ss(E,N,G){const W=N.isScene===!0?N.overrideMaterial:null;for(let z=0,ue=E.length;z<ue;z++){const ye=E[z],Fe=ye.object,De=ye.geometry,Ge=W===null?ye.material:W,Xe=ye.group;Fe.layers.test(G.layers)&&Or(Fe,N,G,De,Ge,Xe)}}function Or(E,N,G,W,z,ue){E.onBeforeRender(v,N,G,W,z,ue),E.modelViewMatrix.multiplyMatrices(G.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),z.onBeforeRender(v,N,G,W,E,ue),z.transparent===!0&&z.side===fi&&z.forceSinglePass===!1?(z.side=En,z.needsUpdate=!0,v.renderBufferDirect(G,N,W,z,E,ue),z.side=ts,z.needsUpdate=!0,v.renderBufferDirect(G,N,W,z,E,ue),z.side=fi):v.renderBufferDirect(G,N,W,z,E,ue),E.onAfterRender(v,N,G,W,z,ue)}function Bs(E,N,G){N.isScene!==!0&&(N=at);const W=Pe.get(E),z=d.state.lights,ue=d.state.shadowsArray,ye=z.state.version,Fe=Se.getParameters(E,z.state,ue,N,G),De=Se.getProgramCacheKey(Fe);let Ge=W.programs;W.environment=E.isMeshStandardMaterial?N.environment:null,W.fog=N.fog,W.envMap=(E.isMeshStandardMaterial?$:S).get(E.envMap||W.environment),W.envMapRotation=W.environment!==null&&E.envMap===null?N.environmentRotation:E.envMapRotation,Ge===void 0&&(E.addEventListener("dispose",Ke),Ge=new Map,W.programs=Ge);let Xe=Ge.get(De);if(Xe!==void 0){if(W.currentProgram===Xe&&W.lightsStateVersion===ye)return ii(E,Fe),Xe}else Fe.uniforms=Se.getUniforms(E),E.onBeforeCompile(Fe,v),Xe=Se.acquireProgram(Fe,De),Ge.set(De,Xe),W.uniforms=Fe.uniforms;const Ue=W.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ue.clippingPlanes=fe.uniform),ii(E,Fe),W.needsLights=_a(E),W.lightsStateVersion=ye,W.needsLights&&(Ue.ambientLightColor.value=z.state.ambient,Ue.lightProbe.value=z.state.probe,Ue.directionalLights.value=z.state.directional,Ue.directionalLightShadows.value=z.state.directionalShadow,Ue.spotLights.value=z.state.spot,Ue.spotLightShadows.value=z.state.spotShadow,Ue.rectAreaLights.value=z.state.rectArea,Ue.ltc_1.value=z.state.rectAreaLTC1,Ue.ltc_2.value=z.state.rectAreaLTC2,Ue.pointLights.value=z.state.point,Ue.pointLightShadows.value=z.state.pointShadow,Ue.hemisphereLights.value=z.state.hemi,Ue.directionalShadowMap.value=z.state.directionalShadowMap,Ue.directionalShadowMatrix.value=z.state.directionalShadowMatrix,Ue.spotShadowMap.value=z.state.spotShadowMap,Ue.spotLightMatrix.value=z.state.spotLightMatrix,Ue.spotLightMap.value=z.state.spotLightMap,Ue.pointShadowMap.value=z.state.pointShadowMap,Ue.pointShadowMatrix.value=z.state.pointShadowMatrix),W.currentProgram=Xe,W.uniformsList=null,Xe}function ga(E){if(E.uniformsList===null){const N=E.currentProgram.getUniforms();E.uniformsList=co.seqWithValue(N.seq,E.uniforms)}return E.uniformsList}function ii(E,N){const G=Pe.get(E);G.outputColorSpace=N.outputColorSpace,G.batching=N.batching,G.batchingColor=N.batchingColor,G.instancing=N.instancing,G.instancingColor=N.instancingColor,G.instancingMorph=N.instancingMorph,G.skinning=N.skinning,G.morphTargets=N.morphTargets,G.morphNormals=N.morphNormals,G.morphColors=N.morphColors,G.morphTargetsCount=N.morphTargetsCount,G.numClippingPlanes=N.numClippingPlanes,G.numIntersection=N.numClipIntersection,G.vertexAlphas=N.vertexAlphas,G.vertexTangents=N.vertexTangents,G.toneMapping=N.toneMapping}function Bo(E,N,G,W,z){N.isScene!==!0&&(N=at),R.resetTextureUnits();const ue=N.fog,ye=W.isMeshStandardMaterial?N.environment:null,Fe=F===null?v.outputColorSpace:F.isXRRenderTarget===!0?F.texture.colorSpace:Os,De=(W.isMeshStandardMaterial?$:S).get(W.envMap||ye),Ge=W.vertexColors===!0&&!!G.attributes.color&&G.attributes.color.itemSize===4,Xe=!!G.attributes.tangent&&(!!W.normalMap||W.anisotropy>0),Ue=!!G.morphAttributes.position,it=!!G.morphAttributes.normal,vt=!!G.morphAttributes.color;let Mt=Ji;W.toneMapped&&(F===null||F.isXRRenderTarget===!0)&&(Mt=v.toneMapping);const Qt=G.morphAttributes.position||G.morphAttributes.normal||G.morphAttributes.color,lt=Qt!==void 0?Qt.length:0,Be=Pe.get(W),Nt=d.state.lights;if(oe===!0&&(ge===!0||E!==y)){const dn=E===y&&W.id===b;fe.setState(W,E,dn)}let ht=!1;W.version===Be.__version?(Be.needsLights&&Be.lightsStateVersion!==Nt.state.version||Be.outputColorSpace!==Fe||z.isBatchedMesh&&Be.batching===!1||!z.isBatchedMesh&&Be.batching===!0||z.isBatchedMesh&&Be.batchingColor===!0&&z.colorTexture===null||z.isBatchedMesh&&Be.batchingColor===!1&&z.colorTexture!==null||z.isInstancedMesh&&Be.instancing===!1||!z.isInstancedMesh&&Be.instancing===!0||z.isSkinnedMesh&&Be.skinning===!1||!z.isSkinnedMesh&&Be.skinning===!0||z.isInstancedMesh&&Be.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Be.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Be.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Be.instancingMorph===!1&&z.morphTexture!==null||Be.envMap!==De||W.fog===!0&&Be.fog!==ue||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==fe.numPlanes||Be.numIntersection!==fe.numIntersection)||Be.vertexAlphas!==Ge||Be.vertexTangents!==Xe||Be.morphTargets!==Ue||Be.morphNormals!==it||Be.morphColors!==vt||Be.toneMapping!==Mt||Be.morphTargetsCount!==lt)&&(ht=!0):(ht=!0,Be.__version=W.version);let Mn=Be.currentProgram;ht===!0&&(Mn=Bs(W,N,z));let si=!1,ln=!1,as=!1;const wt=Mn.getUniforms(),Nn=Be.uniforms;if(Ve.useProgram(Mn.program)&&(si=!0,ln=!0,as=!0),W.id!==b&&(b=W.id,ln=!0),si||y!==E){Ve.buffers.depth.getReversed()?(ae.copy(E.projectionMatrix),Uv(ae),Iv(ae),wt.setValue(k,"projectionMatrix",ae)):wt.setValue(k,"projectionMatrix",E.projectionMatrix),wt.setValue(k,"viewMatrix",E.matrixWorldInverse);const ri=wt.map.cameraPosition;ri!==void 0&&ri.setValue(k,He.setFromMatrixPosition(E.matrixWorld)),Qe.logarithmicDepthBuffer&&wt.setValue(k,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(W.isMeshPhongMaterial||W.isMeshToonMaterial||W.isMeshLambertMaterial||W.isMeshBasicMaterial||W.isMeshStandardMaterial||W.isShaderMaterial)&&wt.setValue(k,"isOrthographic",E.isOrthographicCamera===!0),y!==E&&(y=E,ln=!0,as=!0)}if(z.isSkinnedMesh){wt.setOptional(k,z,"bindMatrix"),wt.setOptional(k,z,"bindMatrixInverse");const dn=z.skeleton;dn&&(dn.boneTexture===null&&dn.computeBoneTexture(),wt.setValue(k,"boneTexture",dn.boneTexture,R))}z.isBatchedMesh&&(wt.setOptional(k,z,"batchingTexture"),wt.setValue(k,"batchingTexture",z._matricesTexture,R),wt.setOptional(k,z,"batchingIdTexture"),wt.setValue(k,"batchingIdTexture",z._indirectTexture,R),wt.setOptional(k,z,"batchingColorTexture"),z._colorsTexture!==null&&wt.setValue(k,"batchingColorTexture",z._colorsTexture,R));const Oi=G.morphAttributes;if((Oi.position!==void 0||Oi.normal!==void 0||Oi.color!==void 0)&&Oe.update(z,G,Mn),(ln||Be.receiveShadow!==z.receiveShadow)&&(Be.receiveShadow=z.receiveShadow,wt.setValue(k,"receiveShadow",z.receiveShadow)),W.isMeshGouraudMaterial&&W.envMap!==null&&(Nn.envMap.value=De,Nn.flipEnvMap.value=De.isCubeTexture&&De.isRenderTargetTexture===!1?-1:1),W.isMeshStandardMaterial&&W.envMap===null&&N.environment!==null&&(Nn.envMapIntensity.value=N.environmentIntensity),ln&&(wt.setValue(k,"toneMappingExposure",v.toneMappingExposure),Be.needsLights&&rs(Nn,as),ue&&W.fog===!0&&_e.refreshFogUniforms(Nn,ue),_e.refreshMaterialUniforms(Nn,W,Q,J,d.state.transmissionRenderTarget[E.id]),co.upload(k,ga(Be),Nn,R)),W.isShaderMaterial&&W.uniformsNeedUpdate===!0&&(co.upload(k,ga(Be),Nn,R),W.uniformsNeedUpdate=!1),W.isSpriteMaterial&&wt.setValue(k,"center",z.center),wt.setValue(k,"modelViewMatrix",z.modelViewMatrix),wt.setValue(k,"normalMatrix",z.normalMatrix),wt.setValue(k,"modelMatrix",z.matrixWorld),W.isShaderMaterial||W.isRawShaderMaterial){const dn=W.uniformsGroups;for(let ri=0,Gn=dn.length;ri<Gn;ri++){const ks=dn[ri];O.update(ks,Mn),O.bind(ks,Mn)}}return Mn}function rs(E,N){E.ambientLightColor.needsUpdate=N,E.lightProbe.needsUpdate=N,E.directionalLights.needsUpdate=N,E.directionalLightShadows.needsUpdate=N,E.pointLights.needsUpdate=N,E.pointLightShadows.needsUpdate=N,E.spotLights.needsUpdate=N,E.spotLightShadows.needsUpdate=N,E.rectAreaLights.needsUpdate=N,E.hemisphereLights.needsUpdate=N}function _a(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return F},this.setRenderTargetTextures=function(E,N,G){Pe.get(E.texture).__webglTexture=N,Pe.get(E.depthTexture).__webglTexture=G;const W=Pe.get(E);W.__hasExternalTextures=!0,W.__autoAllocateDepthBuffer=G===void 0,W.__autoAllocateDepthBuffer||je.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),W.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(E,N){const G=Pe.get(E);G.__webglFramebuffer=N,G.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(E,N=0,G=0){F=E,L=N,D=G;let W=!0,z=null,ue=!1,ye=!1;if(E){const De=Pe.get(E);if(De.__useDefaultFramebuffer!==void 0)Ve.bindFramebuffer(k.FRAMEBUFFER,null),W=!1;else if(De.__webglFramebuffer===void 0)R.setupRenderTarget(E);else if(De.__hasExternalTextures)R.rebindTextures(E,Pe.get(E.texture).__webglTexture,Pe.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){const Ue=E.depthTexture;if(De.__boundDepthTexture!==Ue){if(Ue!==null&&Pe.has(Ue)&&(E.width!==Ue.image.width||E.height!==Ue.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");R.setupDepthRenderbuffer(E)}}const Ge=E.texture;(Ge.isData3DTexture||Ge.isDataArrayTexture||Ge.isCompressedArrayTexture)&&(ye=!0);const Xe=Pe.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Xe[N])?z=Xe[N][G]:z=Xe[N],ue=!0):E.samples>0&&R.useMultisampledRTT(E)===!1?z=Pe.get(E).__webglMultisampledFramebuffer:Array.isArray(Xe)?z=Xe[G]:z=Xe,P.copy(E.viewport),Y.copy(E.scissor),B=E.scissorTest}else P.copy(me).multiplyScalar(Q).floor(),Y.copy(Me).multiplyScalar(Q).floor(),B=pe;if(Ve.bindFramebuffer(k.FRAMEBUFFER,z)&&W&&Ve.drawBuffers(E,z),Ve.viewport(P),Ve.scissor(Y),Ve.setScissorTest(B),ue){const De=Pe.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+N,De.__webglTexture,G)}else if(ye){const De=Pe.get(E.texture),Ge=N||0;k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,De.__webglTexture,G||0,Ge)}b=-1},this.readRenderTargetPixels=function(E,N,G,W,z,ue,ye){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Fe=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&ye!==void 0&&(Fe=Fe[ye]),Fe){Ve.bindFramebuffer(k.FRAMEBUFFER,Fe);try{const De=E.texture,Ge=De.format,Xe=De.type;if(!Qe.textureFormatReadable(Ge)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Qe.textureTypeReadable(Xe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=E.width-W&&G>=0&&G<=E.height-z&&k.readPixels(N,G,W,z,qe.convert(Ge),qe.convert(Xe),ue)}finally{const De=F!==null?Pe.get(F).__webglFramebuffer:null;Ve.bindFramebuffer(k.FRAMEBUFFER,De)}}},this.readRenderTargetPixelsAsync=async function(E,N,G,W,z,ue,ye){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Fe=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&ye!==void 0&&(Fe=Fe[ye]),Fe){const De=E.texture,Ge=De.format,Xe=De.type;if(!Qe.textureFormatReadable(Ge))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Qe.textureTypeReadable(Xe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(N>=0&&N<=E.width-W&&G>=0&&G<=E.height-z){Ve.bindFramebuffer(k.FRAMEBUFFER,Fe);const Ue=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,Ue),k.bufferData(k.PIXEL_PACK_BUFFER,ue.byteLength,k.STREAM_READ),k.readPixels(N,G,W,z,qe.convert(Ge),qe.convert(Xe),0);const it=F!==null?Pe.get(F).__webglFramebuffer:null;Ve.bindFramebuffer(k.FRAMEBUFFER,it);const vt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Dv(k,vt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,Ue),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,ue),k.deleteBuffer(Ue),k.deleteSync(vt),ue}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(E,N=null,G=0){E.isTexture!==!0&&(Qr("WebGLRenderer: copyFramebufferToTexture function signature has changed."),N=arguments[0]||null,E=arguments[1]);const W=Math.pow(2,-G),z=Math.floor(E.image.width*W),ue=Math.floor(E.image.height*W),ye=N!==null?N.x:0,Fe=N!==null?N.y:0;R.setTexture2D(E,0),k.copyTexSubImage2D(k.TEXTURE_2D,G,0,0,ye,Fe,z,ue),Ve.unbindTexture()},this.copyTextureToTexture=function(E,N,G=null,W=null,z=0){E.isTexture!==!0&&(Qr("WebGLRenderer: copyTextureToTexture function signature has changed."),W=arguments[0]||null,E=arguments[1],N=arguments[2],z=arguments[3]||0,G=null);let ue,ye,Fe,De,Ge,Xe,Ue,it,vt;const Mt=E.isCompressedTexture?E.mipmaps[z]:E.image;G!==null?(ue=G.max.x-G.min.x,ye=G.max.y-G.min.y,Fe=G.isBox3?G.max.z-G.min.z:1,De=G.min.x,Ge=G.min.y,Xe=G.isBox3?G.min.z:0):(ue=Mt.width,ye=Mt.height,Fe=Mt.depth||1,De=0,Ge=0,Xe=0),W!==null?(Ue=W.x,it=W.y,vt=W.z):(Ue=0,it=0,vt=0);const Qt=qe.convert(N.format),lt=qe.convert(N.type);let Be;N.isData3DTexture?(R.setTexture3D(N,0),Be=k.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(R.setTexture2DArray(N,0),Be=k.TEXTURE_2D_ARRAY):(R.setTexture2D(N,0),Be=k.TEXTURE_2D),k.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,N.flipY),k.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),k.pixelStorei(k.UNPACK_ALIGNMENT,N.unpackAlignment);const Nt=k.getParameter(k.UNPACK_ROW_LENGTH),ht=k.getParameter(k.UNPACK_IMAGE_HEIGHT),Mn=k.getParameter(k.UNPACK_SKIP_PIXELS),si=k.getParameter(k.UNPACK_SKIP_ROWS),ln=k.getParameter(k.UNPACK_SKIP_IMAGES);k.pixelStorei(k.UNPACK_ROW_LENGTH,Mt.width),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Mt.height),k.pixelStorei(k.UNPACK_SKIP_PIXELS,De),k.pixelStorei(k.UNPACK_SKIP_ROWS,Ge),k.pixelStorei(k.UNPACK_SKIP_IMAGES,Xe);const as=E.isDataArrayTexture||E.isData3DTexture,wt=N.isDataArrayTexture||N.isData3DTexture;if(E.isRenderTargetTexture||E.isDepthTexture){const Nn=Pe.get(E),Oi=Pe.get(N),dn=Pe.get(Nn.__renderTarget),ri=Pe.get(Oi.__renderTarget);Ve.bindFramebuffer(k.READ_FRAMEBUFFER,dn.__webglFramebuffer),Ve.bindFramebuffer(k.DRAW_FRAMEBUFFER,ri.__webglFramebuffer);for(let Gn=0;Gn<Fe;Gn++)as&&k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Pe.get(E).__webglTexture,z,Xe+Gn),E.isDepthTexture?(wt&&k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Pe.get(N).__webglTexture,z,vt+Gn),k.blitFramebuffer(De,Ge,ue,ye,Ue,it,ue,ye,k.DEPTH_BUFFER_BIT,k.NEAREST)):wt?k.copyTexSubImage3D(Be,z,Ue,it,vt+Gn,De,Ge,ue,ye):k.copyTexSubImage2D(Be,z,Ue,it,vt+Gn,De,Ge,ue,ye);Ve.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ve.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else wt?E.isDataTexture||E.isData3DTexture?k.texSubImage3D(Be,z,Ue,it,vt,ue,ye,Fe,Qt,lt,Mt.data):N.isCompressedArrayTexture?k.compressedTexSubImage3D(Be,z,Ue,it,vt,ue,ye,Fe,Qt,Mt.data):k.texSubImage3D(Be,z,Ue,it,vt,ue,ye,Fe,Qt,lt,Mt):E.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,z,Ue,it,ue,ye,Qt,lt,Mt.data):E.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,z,Ue,it,Mt.width,Mt.height,Qt,Mt.data):k.texSubImage2D(k.TEXTURE_2D,z,Ue,it,ue,ye,Qt,lt,Mt);k.pixelStorei(k.UNPACK_ROW_LENGTH,Nt),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ht),k.pixelStorei(k.UNPACK_SKIP_PIXELS,Mn),k.pixelStorei(k.UNPACK_SKIP_ROWS,si),k.pixelStorei(k.UNPACK_SKIP_IMAGES,ln),z===0&&N.generateMipmaps&&k.generateMipmap(Be),Ve.unbindTexture()},this.copyTextureToTexture3D=function(E,N,G=null,W=null,z=0){return E.isTexture!==!0&&(Qr("WebGLRenderer: copyTextureToTexture3D function signature has changed."),G=arguments[0]||null,W=arguments[1]||null,E=arguments[2],N=arguments[3],z=arguments[4]||0),Qr('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(E,N,G,W,z)},this.initRenderTarget=function(E){Pe.get(E).__webglFramebuffer===void 0&&R.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?R.setTextureCube(E,0):E.isData3DTexture?R.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?R.setTexture2DArray(E,0):R.setTexture2D(E,0),Ve.unbindTexture()},this.resetState=function(){L=0,D=0,F=null,Ve.reset(),ut.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ci}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorspace=ft._getDrawingBufferColorSpace(e),t.unpackColorSpace=ft._getUnpackColorSpace()}}class XE extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Fi,this.environmentIntensity=1,this.environmentRotation=new Fi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}const qE={triangulate:function(n,e,t=2){const i=e&&e.length,s=i?e[0]*t:n.length;let r=Up(n,0,s,t,!0);const a=[];if(!r||r.next===r.prev)return a;let o,l,c,h,u,f,p;if(i&&(r=jE(n,e,r,t)),n.length>80*t){o=c=n[0],l=h=n[1];for(let _=t;_<s;_+=t)u=n[_],f=n[_+1],u<o&&(o=u),f<l&&(l=f),u>c&&(c=u),f>h&&(h=f);p=Math.max(c-o,h-l),p=p!==0?32767/p:0}return la(r,a,t,o,l,p,0),a}};function Up(n,e,t,i,s){let r,a;if(s===lT(n,e,t,i)>0)for(r=e;r<t;r+=i)a=Wf(r,n[r],n[r+1],a);else for(r=t-i;r>=e;r-=i)a=Wf(r,n[r],n[r+1],a);return a&&Oo(a,a.next)&&(ua(a),a=a.next),a}function Ns(n,e){if(!n)return n;e||(e=n);let t=n,i;do if(i=!1,!t.steiner&&(Oo(t,t.next)||Ot(t.prev,t,t.next)===0)){if(ua(t),t=e=t.prev,t===t.next)break;i=!0}else t=t.next;while(i||t!==e);return e}function la(n,e,t,i,s,r,a){if(!n)return;!a&&r&&nT(n,i,s,r);let o=n,l,c;for(;n.prev!==n.next;){if(l=n.prev,c=n.next,r?YE(n,i,s,r):$E(n)){e.push(l.i/t|0),e.push(n.i/t|0),e.push(c.i/t|0),ua(n),n=c.next,o=c.next;continue}if(n=c,n===o){a?a===1?(n=ZE(Ns(n),e,t),la(n,e,t,i,s,r,2)):a===2&&KE(n,e,t,i,s,r):la(Ns(n),e,t,i,s,r,1);break}}}function $E(n){const e=n.prev,t=n,i=n.next;if(Ot(e,t,i)>=0)return!1;const s=e.x,r=t.x,a=i.x,o=e.y,l=t.y,c=i.y,h=s<r?s<a?s:a:r<a?r:a,u=o<l?o<c?o:c:l<c?l:c,f=s>r?s>a?s:a:r>a?r:a,p=o>l?o>c?o:c:l>c?l:c;let _=i.next;for(;_!==e;){if(_.x>=h&&_.x<=f&&_.y>=u&&_.y<=p&&pr(s,o,r,l,a,c,_.x,_.y)&&Ot(_.prev,_,_.next)>=0)return!1;_=_.next}return!0}function YE(n,e,t,i){const s=n.prev,r=n,a=n.next;if(Ot(s,r,a)>=0)return!1;const o=s.x,l=r.x,c=a.x,h=s.y,u=r.y,f=a.y,p=o<l?o<c?o:c:l<c?l:c,_=h<u?h<f?h:f:u<f?u:f,x=o>l?o>c?o:c:l>c?l:c,m=h>u?h>f?h:f:u>f?u:f,d=Xc(p,_,e,t,i),w=Xc(x,m,e,t,i);let T=n.prevZ,v=n.nextZ;for(;T&&T.z>=d&&v&&v.z<=w;){if(T.x>=p&&T.x<=x&&T.y>=_&&T.y<=m&&T!==s&&T!==a&&pr(o,h,l,u,c,f,T.x,T.y)&&Ot(T.prev,T,T.next)>=0||(T=T.prevZ,v.x>=p&&v.x<=x&&v.y>=_&&v.y<=m&&v!==s&&v!==a&&pr(o,h,l,u,c,f,v.x,v.y)&&Ot(v.prev,v,v.next)>=0))return!1;v=v.nextZ}for(;T&&T.z>=d;){if(T.x>=p&&T.x<=x&&T.y>=_&&T.y<=m&&T!==s&&T!==a&&pr(o,h,l,u,c,f,T.x,T.y)&&Ot(T.prev,T,T.next)>=0)return!1;T=T.prevZ}for(;v&&v.z<=w;){if(v.x>=p&&v.x<=x&&v.y>=_&&v.y<=m&&v!==s&&v!==a&&pr(o,h,l,u,c,f,v.x,v.y)&&Ot(v.prev,v,v.next)>=0)return!1;v=v.nextZ}return!0}function ZE(n,e,t){let i=n;do{const s=i.prev,r=i.next.next;!Oo(s,r)&&Ip(s,i,i.next,r)&&ca(s,r)&&ca(r,s)&&(e.push(s.i/t|0),e.push(i.i/t|0),e.push(r.i/t|0),ua(i),ua(i.next),i=n=r),i=i.next}while(i!==n);return Ns(i)}function KE(n,e,t,i,s,r){let a=n;do{let o=a.next.next;for(;o!==a.prev;){if(a.i!==o.i&&rT(a,o)){let l=Np(a,o);a=Ns(a,a.next),l=Ns(l,l.next),la(a,e,t,i,s,r,0),la(l,e,t,i,s,r,0);return}o=o.next}a=a.next}while(a!==n)}function jE(n,e,t,i){const s=[];let r,a,o,l,c;for(r=0,a=e.length;r<a;r++)o=e[r]*i,l=r<a-1?e[r+1]*i:n.length,c=Up(n,o,l,i,!1),c===c.next&&(c.steiner=!0),s.push(sT(c));for(s.sort(JE),r=0;r<s.length;r++)t=QE(s[r],t);return t}function JE(n,e){return n.x-e.x}function QE(n,e){const t=eT(n,e);if(!t)return e;const i=Np(t,n);return Ns(i,i.next),Ns(t,t.next)}function eT(n,e){let t=e,i=-1/0,s;const r=n.x,a=n.y;do{if(a<=t.y&&a>=t.next.y&&t.next.y!==t.y){const f=t.x+(a-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(f<=r&&f>i&&(i=f,s=t.x<t.next.x?t:t.next,f===r))return s}t=t.next}while(t!==e);if(!s)return null;const o=s,l=s.x,c=s.y;let h=1/0,u;t=s;do r>=t.x&&t.x>=l&&r!==t.x&&pr(a<c?r:i,a,l,c,a<c?i:r,a,t.x,t.y)&&(u=Math.abs(a-t.y)/(r-t.x),ca(t,n)&&(u<h||u===h&&(t.x>s.x||t.x===s.x&&tT(s,t)))&&(s=t,h=u)),t=t.next;while(t!==o);return s}function tT(n,e){return Ot(n.prev,n,e.prev)<0&&Ot(e.next,n,n.next)<0}function nT(n,e,t,i){let s=n;do s.z===0&&(s.z=Xc(s.x,s.y,e,t,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,iT(s)}function iT(n){let e,t,i,s,r,a,o,l,c=1;do{for(t=n,n=null,r=null,a=0;t;){for(a++,i=t,o=0,e=0;e<c&&(o++,i=i.nextZ,!!i);e++);for(l=c;o>0||l>0&&i;)o!==0&&(l===0||!i||t.z<=i.z)?(s=t,t=t.nextZ,o--):(s=i,i=i.nextZ,l--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;t=i}r.nextZ=null,c*=2}while(a>1);return n}function Xc(n,e,t,i,s){return n=(n-t)*s|0,e=(e-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,n|e<<1}function sT(n){let e=n,t=n;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==n);return t}function pr(n,e,t,i,s,r,a,o){return(s-a)*(e-o)>=(n-a)*(r-o)&&(n-a)*(i-o)>=(t-a)*(e-o)&&(t-a)*(r-o)>=(s-a)*(i-o)}function rT(n,e){return n.next.i!==e.i&&n.prev.i!==e.i&&!aT(n,e)&&(ca(n,e)&&ca(e,n)&&oT(n,e)&&(Ot(n.prev,n,e.prev)||Ot(n,e.prev,e))||Oo(n,e)&&Ot(n.prev,n,n.next)>0&&Ot(e.prev,e,e.next)>0)}function Ot(n,e,t){return(e.y-n.y)*(t.x-e.x)-(e.x-n.x)*(t.y-e.y)}function Oo(n,e){return n.x===e.x&&n.y===e.y}function Ip(n,e,t,i){const s=Qa(Ot(n,e,t)),r=Qa(Ot(n,e,i)),a=Qa(Ot(t,i,n)),o=Qa(Ot(t,i,e));return!!(s!==r&&a!==o||s===0&&Ja(n,t,e)||r===0&&Ja(n,i,e)||a===0&&Ja(t,n,i)||o===0&&Ja(t,e,i))}function Ja(n,e,t){return e.x<=Math.max(n.x,t.x)&&e.x>=Math.min(n.x,t.x)&&e.y<=Math.max(n.y,t.y)&&e.y>=Math.min(n.y,t.y)}function Qa(n){return n>0?1:n<0?-1:0}function aT(n,e){let t=n;do{if(t.i!==n.i&&t.next.i!==n.i&&t.i!==e.i&&t.next.i!==e.i&&Ip(t,t.next,n,e))return!0;t=t.next}while(t!==n);return!1}function ca(n,e){return Ot(n.prev,n,n.next)<0?Ot(n,e,n.next)>=0&&Ot(n,n.prev,e)>=0:Ot(n,e,n.prev)<0||Ot(n,n.next,e)<0}function oT(n,e){let t=n,i=!1;const s=(n.x+e.x)/2,r=(n.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(i=!i),t=t.next;while(t!==n);return i}function Np(n,e){const t=new qc(n.i,n.x,n.y),i=new qc(e.i,e.x,e.y),s=n.next,r=e.prev;return n.next=e,e.prev=n,t.next=s,s.prev=t,i.next=t,t.prev=i,r.next=i,i.prev=r,i}function Wf(n,e,t,i){const s=new qc(n,e,t);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function ua(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function qc(n,e,t){this.i=n,this.x=e,this.y=t,this.prev=null,this.next=null,this.z=0,this.prevZ=null,this.nextZ=null,this.steiner=!1}function lT(n,e,t,i){let s=0;for(let r=e,a=t-i;r<t;r+=i)s+=(n[a]-n[r])*(n[r+1]+n[a+1]),a=r;return s}class xu{static area(e){const t=e.length;let i=0;for(let s=t-1,r=0;r<t;s=r++)i+=e[s].x*e[r].y-e[r].x*e[s].y;return i*.5}static isClockWise(e){return xu.area(e)<0}static triangulateShape(e,t){const i=[],s=[],r=[];Xf(e),qf(i,e);let a=e.length;t.forEach(Xf);for(let l=0;l<t.length;l++)s.push(a),a+=t[l].length,qf(i,t[l]);const o=qE.triangulate(i,s);for(let l=0;l<o.length;l+=3)r.push(o.slice(l,l+3));return r}}function Xf(n){const e=n.length;e>2&&n[e-1].equals(n[0])&&n.pop()}function qf(n,e){for(let t=0;t<e.length;t++)n.push(e[t].x),n.push(e[t].y)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:cu}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=cu);class cT{positions=new Float32Array(3*4096);colours=new Float32Array(4*4096);count=0;geometry=new is;mesh;constructor(){const e=new _u({vertexColors:!0,transparent:!0,depthTest:!1,side:fi,forceSinglePass:!0});this.mesh=new pi(this.geometry,e),this.mesh.frustumCulled=!1,this.attach()}begin(){this.count=0}end(){for(const e of["position","color"])this.geometry.getAttribute(e).needsUpdate=!0;this.geometry.setDrawRange(0,this.count)}triangle(e,t,i,s){3*(this.count+3)>this.positions.length&&this.grow();for(const[r,a]of[e,t,i])this.positions[3*this.count]=r,this.positions[3*this.count+1]=a,this.colours.set(s,4*this.count),++this.count}quad(e,t,i,s,r){this.triangle(e,t,i,r),this.triangle(e,i,s,r)}polygon(e,t){const i=e.map(([s,r])=>new Tt(s,r));for(const[s,r,a]of xu.triangulateShape(i,[]))this.triangle(e[s],e[r],e[a],t)}line(e,t,i,s){const r=Math.hypot(t[0]-e[0],t[1]-e[1]);if(r===0)return;const a=(e[1]-t[1])/r*(i/2),o=(t[0]-e[0])/r*(i/2);this.quad([e[0]+a,e[1]+o],[t[0]+a,t[1]+o],[t[0]-a,t[1]-o],[e[0]-a,e[1]-o],s)}path(e,t,i,s=!1){const r=e.length;if(r<2)return;const a=l=>{const c=e[s?(l+r-1)%r:Math.max(0,l-1)],h=e[s?(l+1)%r:Math.min(r-1,l+1)],[u,f]=e[l],p=Math.atan2(f-c[1],u-c[0]),_=Math.atan2(h[1]-f,h[0]-u),x=c===e[l]?_:p,m=h===e[l]?p:_,d=Math.atan2(Math.sin(m-x),Math.cos(m-x))/2,w=t/2/Math.max(.3,Math.cos(d)),T=x+d+Math.PI/2,v=w*Math.cos(T),H=w*Math.sin(T);return[[u+v,f+H],[u-v,f-H]]};let o=a(0);for(let l=1;l<r+(s?1:0);++l){const c=a(l%r);this.quad(o[0],c[0],c[1],o[1],i),o=c}}disc([e,t],i,s){const r=Gu([e,t],i);r.forEach((a,o)=>this.triangle([e,t],a,r[(o+1)%r.length],s))}ring(e,t,i,s){this.path(Gu(e,t),i,s,!0)}attach(){this.geometry.setAttribute("position",new Vn(this.positions,3)),this.geometry.setAttribute("color",new Vn(this.colours,4))}grow(){const e=t=>{const i=new Float32Array(2*t.length);return i.set(t),i};this.positions=e(this.positions),this.colours=e(this.colours),this.geometry.dispose(),this.attach()}}const uT=22,hT=9;class fT{constructor(e,t,i){this.canvas=e,this.scene=t,this.events=i,this.renderer=new WE({canvas:e,antialias:!0,alpha:!0}),this.renderer.outputColorSpace=Os,this.renderer.setClearColor(0,0),this.picture=new od(this.painter,this.camera),this.world.add(this.painter.mesh),this.view.position.z=1,e.after(this.labels),new ResizeObserver(()=>this.resize()).observe(e.parentElement),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{this.picture.recolour(),this.draw()}),e.addEventListener("pointerdown",s=>this.down(s)),e.addEventListener("pointermove",s=>this.move(s)),e.addEventListener("pointerup",s=>this.up(s)),e.addEventListener("pointercancel",s=>this.up(s)),e.addEventListener("wheel",s=>this.wheel(s),{passive:!1}),e.addEventListener("webglcontextrestored",()=>this.draw())}camera={x:.35,y:0,m_per_px:.001,width:1,height:1};renderer;view=new Ap;world=new XE;painter=new cT;picture;pointers=new Map;labels=U("div",{class:"grid-labels","aria-hidden":"true"});grabbed=!1;due=!1;fitTo=[[-.1,-.5],[.8,.5]];painted=()=>{};get isHeld(){return this.grabbed}draw(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due&&this.drawNow()}))}fit(e,t){this.fitTo=[e,t],this.refit()}refit(){this.camera=Mm(this.camera,...this.fitTo),this.draw()}zoom(e){this.camera=Ko(this.camera,e,[this.camera.width/2,this.camera.height/2]),this.draw()}pan(e,t){this.camera=zu(this.camera,e,t),this.draw()}drawNow(){this.due=!1;const{x:e,y:t,m_per_px:i,width:s,height:r}=this.camera;Object.assign(this.view,{left:e-s/2*i,right:e+s/2*i,top:t+r/2*i,bottom:t-r/2*i}),this.view.updateProjectionMatrix();const a=this.scene();this.picture.paint(a,this.camera),this.renderer.render(this.world,this.view),this.label(a),this.painted()}label({environment:e,selected:t}){const i=id(this.camera),s=sd(this.camera,e,t),r=JSON.stringify([i,s]);this.labels.dataset.shown!==r&&(this.labels.dataset.shown=r,this.labels.replaceChildren(...i.map(({axis:a,at:o,text:l})=>{const c=U("span",{class:a},l);return c.style[a==="x"?"left":"top"]=`${o}px`,c}),...s.map(({at:[a,o],text:l})=>{const c=U("span",{class:"thing"},l);return Object.assign(c.style,{left:`${a}px`,top:`${o}px`}),c})))}resize(){const{clientWidth:e,clientHeight:t}=this.canvas.parentElement;if(e===0||t===0)return;const i=this.camera.width===1;this.camera={...this.camera,width:e,height:t},this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.setSize(e,t,!1),i&&this.refit(),this.drawNow()}at(e){const t=this.canvas.getBoundingClientRect();return[e.clientX-t.left,e.clientY-t.top]}down(e){if(this.canvas.setPointerCapture(e.pointerId),this.pointers.set(e.pointerId,this.at(e)),this.pointers.size>1){this.letGo(!0);return}const t=(e.pointerType==="touch"?uT:hT)*this.camera.m_per_px;this.grabbed=this.events.down(Ii(this.camera,this.at(e)),t,e)}move(e){const t=this.pointers.get(e.pointerId);if(!t)return;const i=this.at(e);this.pointers.set(e.pointerId,i),this.pointers.size===2?this.pinch(e.pointerId,t,i):this.grabbed?this.events.drag(Ii(this.camera,i),e):this.pan(i[0]-t[0],i[1]-t[1])}pinch(e,t,i){const s=[...this.pointers].find(([a])=>a!==e)[1],r=a=>Math.hypot(a[0]-s[0],a[1]-s[1]);this.camera=zu(this.camera,(i[0]-t[0])/2,(i[1]-t[1])/2),r(t)>0&&(this.camera=Ko(this.camera,r(i)/r(t),s)),this.draw()}up(e){this.pointers.delete(e.pointerId),this.letGo(e.type==="pointercancel")}letGo(e){const t=this.grabbed;this.grabbed=!1,t&&this.events.up(e)}wheel(e){e.preventDefault(),this.camera=Ko(this.camera,Math.exp(-e.deltaY*.0015),this.at(e)),this.draw()}}const dT="VENT is not answered: shut off the supply.";function pT(n){const{driver:e}=n.project;Ct("arm").hidden=e==="",e!==""&&n.armLink.prepare();const t=()=>void n.attempt(()=>n.armLink.vent());for(const i of["pointerdown","click"])Ct("vent").addEventListener(i,t);document.addEventListener("keydown",i=>mT(n,i,t),{capture:!0})}function mT(n,e,t){const{runs:i,isMine:s}=n.armLink,r=e.target instanceof HTMLInputElement||e.target instanceof HTMLSelectElement;e.key!==" "&&e.key!=="Escape"||!(i||s&&!r)||(e.preventDefault(),e.stopImmediatePropagation(),e.repeat||t())}function gT({armLink:n}){const{status:{state:e,message:t},isMine:i,isSeen:s,isVenting:r,isUnanswered:a}=n,o={off:"",armed:i?"armed here":"armed by another page",running:"the arm moves"};Qi(Ct("arm-state"),r?"Venting …":s?o[e]:"the arm is not seen"),Ct("arm-state").className=s?e:"lost";const l=Ct("arm-message"),c=a||n.isAlarm;l.className=c?"alarm":"outcome",l.setAttribute("role",c?"alert":"status"),Qi(l,a?dT:t)}const _T=40,eo="The studio does not answer. Is limber studio still running, in fewer than five tabs?",$f="The studio was started again: open the address that it has printed.";class vT{project;saved=null;isInFile=!0;arm;armName="";model="";environmentName="";history=new l0({name:"untitled",obstacles:[],start:"rest",goal:{x_m:.4,y_m:.2,position_tolerance_m:.02}});selected=null;tab="";live=!0;timeLimit_s=5;limitScale=1;margin_m=null;view={tree:!1,tube:!1,reach:!0};planner=new M0(()=>this.tab,(e=!0)=>this.refreshSoon(e));opening=new _0(this);armLink=new rm(()=>this.tab,()=>this.armChanged());stage;modes={plan:new v0(this),play:new y0(this),follow:new o0(this),drive:new Jm(this),results:new D0(this)};mode="plan";latency=new g0(this.planner);models=new Map;choice=0;due=!1;late;get environment(){return this.history.now}get unit(){return this.arm.command.unit}get entered(){return this.modes[this.mode]}get isChanged(){return this.environment!==this.saved}get isFamily(){return this.project.families.includes(this.model)}async readProject(){this.project=await ta("project")}async readAgain(){const e=JSON.stringify(this.project);await this.readProject(),this.mode==="plan"&&JSON.stringify(this.project)!==e&&this.show()}async start(){await this.readProject(),pT(this),this.stage=new fT(Ct("canvas"),()=>this.scene(),{down:(t,i,s)=>this.down(t,i,s),drag:(t,i)=>this.entered.drag?.(t,i.timeStamp),up:t=>this.entered.up?.(t)}),this.stage.painted=()=>this.painted(),Ct("tools").after(ws("−","Zoom out",()=>this.stage.zoom(.8)),ws("+","Zoom in",()=>this.stage.zoom(1.25)),ws("⤢","Show everything",()=>this.stage.refit())),Ct("folder").textContent=`${this.project.folder} · limber ${this.project.version}`,await this.attempt(async()=>void await this.openLink(location.hash)),this.environmentName||await this.openLink(""),addEventListener("hashchange",()=>void this.attempt(async()=>{await this.openLink(location.hash,!0)&&this.replan()}));const e=Object.keys(this.modes).map(t=>{const i=Ct(`mode-${t}`);return i.addEventListener("click",()=>this.enter(t)),i});for(const[t,i]of e.entries())i.addEventListener("keydown",({key:s})=>e[m0(e.length,t,s)??t].focus());document.addEventListener("keydown",t=>p0(this,t,this.mode==="plan")),addEventListener("beforeunload",t=>{this.isChanged&&t.preventDefault()}),this.enter("plan"),addEventListener("focus",()=>void this.readAgain().catch(()=>{})),Qf(Qm(this),t=>this.lost(t),t=>this.armLink.sees(t))}onTab(e){if(this.tab=e,this.armLink.renews(!0),[eo,$f].includes(Ct("notice").textContent)&&this.say(""),this.mode==="plan"&&!this.isFamily)return this.ask();this.planner.forget(),this.enter(this.mode)}lost(e){if(this.tab="",this.armLink.sees(!1),!e)return this.say(eo);this.armLink.renews(!1),this.readProject().then(()=>this.say(eo),t=>this.say(t.status===403?$f:eo))}say(e){Qi(Ct("notice"),e)}async attempt(e){try{this.say(""),await e()}catch(t){this.say(t.message)}}confirms(e){return this.armLink.runs?(this.say("Not while the arm moves"),!1):confirm(e)}mayLose(e){return!this.isChanged||this.confirms(`What you changed is not saved. ${e}`)}async open(e,t,i=null,s=()=>!0){const r=++this.choice,a=e===this.armName?this.arm:await ta("arm",{name:e}),o=i??await ta("environment",{name:t,arm:e});if(r!==this.choice||!s())return!1;if(this.forget(),a!==this.arm){const{length_m:l}=a;this.arm=a,this.armName=e,this.stage.fit([-.12*l,-.78*l],[1.12*l,.78*l])}return this.history.reset(o),this.saved=this.environment,this.isInFile=i===null,this.environmentName=t,this.selected=this.margin_m=null,!0}choose(e){return++this.choice,this.model=e,this.models.set(this.armName,e),this.margin_m=null,!0}modelBefore(){const e=this.models.get(this.armName)??"";return this.project.models.includes(e)?e:""}async openLink(e,t=!1){const{arm:i,model:s,environmentName:r,environment:a}=H0(e,this.project);if(a&&i===this.armName)this.history.set(a),this.environmentName=r,this.selected=null,this.saved=this.environment,this.isInFile=!1;else{if(t&&!this.mayLose("Open the link?"))return this.link(),!1;if(!await this.open(i,r,a))return!1}return this.choose(s)}link(e=null){const{armName:t,model:i,environmentName:s}=this;return history.replaceState(null,"",z0({arm:t,model:i,environmentName:s,environment:e})),location.href}reopened(){this.link(),this.replan()}replan(){this.forget(),this.enter(this.mode),this.mode==="plan"&&this.ask()}enter(e){this.entered.leave();const t=e!==this.mode;this.mode=e;for(const i of Object.keys(this.modes)){const s=Ct(`mode-${i}`);s.ariaSelected=String(i===e),s.tabIndex=i===e?0:-1}t&&Ct("panel").contains(document.activeElement)&&Ct(`mode-${e}`).focus(),this.show(),t&&e==="plan"&&this.readAgain().catch(()=>{})}show(){const e=this.entered,t=Ct("panel");rd(t,()=>{t.replaceChildren(),e.enter(t),Ct("legend").replaceChildren(...e.legend().map(([i,s])=>U("li",{},U("i",{class:`swatch ${i}`}),s))),this.refresh()})}ask(e=!1){this.question(performance.now(),e),this.refresh()}question(e,t=!1){if(this.isFamily)return this.forget();this.planner.ask({arm:this.armName,model:this.model,environment:this.environment,time_limit_s:this.timeLimit_s,tree:this.view.tree,limit_scale:this.limitScale,margin_m:this.margin_m},e,t)}endWork(){this.tab!==""&&hn("stop",{tab:this.tab}).catch(()=>{})}forget(){this.planner.searching&&this.endWork(),this.planner.forget()}armChanged(){gT(this),this.refresh()}edit(e){this.stage.isHeld||(this.history.set(e),this.edited())}edited(e){this.live?this.question(e??performance.now()):this.forget(),e===void 0?this.refresh():this.live?this.late??=setTimeout(()=>this.refreshSoon(),_T):this.refreshSoon()}select(e){this.selected=e,this.refresh()}add(e){if(this.stage.isHeld)return;const{width:t,height:i}=this.stage.camera,s=Ii(this.stage.camera,[t/2,i/4]);this.selected=this.environment.obstacles.length,this.edit(pm(this.environment,dm(e,s))),Ct("canvas").focus()}removeSelected(){if(typeof this.selected!="number"||this.stage.isHeld)return;const e=this.selected;this.selected=null,this.edit(gm(this.environment,e)),Ct("canvas").focus()}undo(){this.turnBack(()=>this.history.undo())}redo(){this.turnBack(()=>this.history.redo())}turnBack(e){if(this.stage.isHeld)return;const t=this.environment;e(),this.selected=_m(this.selected,t,this.environment),this.edited()}refresh(){this.arm&&(this.entered.refresh(),this.stage.draw())}refreshSoon(e=!0){e&&this.stage.draw(),!this.due&&(this.due=!0,requestAnimationFrame(()=>{this.due=!1,this.entered.refresh()}))}painted(){clearTimeout(this.late),this.late=void 0,this.latency.measure()}scene(){return{arm:this.arm??null,environment:this.environment,selected:null,plan:null,stale:!1,showTree:null,showTube:!1,showReach:this.view.reach,figures:[],...this.arm?this.entered.scene():{}}}down(e,t,i){return Ct("canvas").focus({preventScroll:!0}),i.button<=0&&(this.entered.down?.(e,t)??!1)}}(async()=>{await new vT().start()})().catch(n=>{Ct("notice").textContent=n instanceof Error?n.message:String(n)});
