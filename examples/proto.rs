#![allow(missing_docs, clippy::all)]
use fmi_hazard::search::exhaustive::*; use fmi_hazard::sim::expansion::*; use std::ops::ControlFlow;
fn main(){ let a: Vec<String>=std::env::args().collect();
 let p=fmi_hazard::scan::prepare::prepare(std::path::Path::new(&a[1]),None).unwrap();
 let merge = if a.get(2).is_some_and(|s| s=="h") {Merge::History} else {Merge::Auto};
 let mut e=Expander::new(p.cell.clone(),p.binding.clone(),p.plant(),p.policy(fmi_hazard::scan::StateChoice::Auto),merge,2).unwrap();
 let t=std::time::Instant::now(); let mut n=0u64; let mut last=usize::MAX; let mut worst=0.0f64;
 let mut g=std::collections::BTreeMap::new();
 let acc=exhaust(&mut e, Budget{states:usize::MAX,bytes:usize::MAX,drop:true}, &mut |told| { match told { Told::Met(m)=>{n+=1; worst=worst.max(m.unsafe_state.contact.ratio()); *g.entry((format!("{:?}",m.unsafe_state.contact.region), m.unsafe_state.contact.link)).or_insert(0u64)+=1;}, Told::Progress{depth,of,..}=>{ if depth!=last {last=depth; eprintln!("level {depth} states {of} t {:?}", t.elapsed());}}}; ControlFlow::Continue(())}).unwrap();
 let f=|b:&num_bigint::BigUint| b.to_string();
 println!("{:?} total {} hazardous {} harmless {} excluded {} noteval {} pairs {} worst {worst} t {:?} questions {} fmu steps {} nodes {} merges {:?}", acc.levels.iter().map(|l|(l.states,l.dropped)).collect::<Vec<_>>(), f(&acc.total), f(&acc.hazardous), f(&acc.harmless), f(&acc.excluded), f(&acc.not_evaluated), n, t.elapsed(), e.questions(), e.recall().steps(), e.recall().states(), e.recall().merges());
 println!("p = {}", f(&acc.hazardous).parse::<f64>().unwrap()/f(&acc.total).parse::<f64>().unwrap());
 println!("incomplete {} armchecks {} bytes {} bybytes {} {:?}", e.coverage().arm_checks_incomplete, e.coverage().arm_checks, e.bytes(), e.merges_by_bytes(), g);
}
