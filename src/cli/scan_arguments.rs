//! The options of `fmi-hazard scan`, and the command line that gives the same result again.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::Duration;

use clap::ValueEnum;
use clap::builder::PossibleValue;

use super::hosting::HostingArguments;
use super::merge_by::MergeBy;
use super::output::Format;
use crate::cell::Workcell;
use crate::cell::file::format::{PeopleFrom, SearchTable};
use crate::scan::moved::relative_to;
use crate::scan::options::Method;
use crate::scan::reachability::Until;
use crate::scan::risk_reduction::{ReachabilityBudget, RiskReductionBudget};
use crate::scan::{Exhaustive, ScanOptions, StateChoice, StrategyName};
use crate::search::exhaustive::Budget;
use crate::sim::answers::Share;

/// When a scan is over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum StopAt {
    /// At the first hazard; auto then ends with its quick part, if that found one.
    First,
    /// When the budget is spent.
    #[default]
    Budget,
}

/// Where people come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum From {
    /// The cell's starts.
    Start,
    /// Anywhere that no sensor sees, at any moment.
    Anywhere,
    /// Anywhere first, then the cell's starts.
    Both,
}

/// States of the FMU that a scan from anywhere steps from, unless told otherwise.
pub(super) const MOST_STATES: usize = 300_000;

/// What a scan that is resumed was told already.
const OTHERS: [&str; 29] = [
    "from",
    "until",
    "presses",
    "partition",
    "parts",
    "path",
    "cell",
    "begin",
    "strategy",
    "seed",
    "iterations",
    "stop_at",
    "out",
    "format",
    "baseline",
    "write_baseline",
    "time",
    "paper_iterations",
    "no_advice",
    "state",
    "in_process",
    "trust_fmu",
    "fmu_timeout",
    "fmu_memory",
    "max_states",
    "max_memory",
    "max_work",
    "merge",
    "workers",
];

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A cell file (.toml), or an FMU with a cell file beside it or inside it
    #[arg(required_unless_present = "resume")]
    pub(super) path: Option<PathBuf>,
    /// Go on with the interrupted scan whose results are in this folder, as it was started; it ends with the same result
    /// as one that was not interrupted
    #[arg(long, value_name = "DIR", conflicts_with_all = OTHERS)]
    pub(super) resume: Option<PathBuf>,
    /// The cell file of an FMU that has none of its own
    #[arg(long)]
    pub(super) cell: Option<PathBuf>,
    /// Only this one of the cell's beginnings, from 1, when it has several starts or times (default: one after the other,
    /// each with its results in a folder of its own)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(super) begin: Option<u32>,
    /// Where people begin (default: what the cell file says, else both, anywhere with half
    /// of the time and results in a folder of its own; the starts alone where they are several, where known hazards are named, or
    /// with options that only such scans have)
    #[arg(long, value_enum)]
    pub(super) from: Option<From>,
    /// From anywhere: how long after the start of the FMU, for instance 6s, or 2cycles of what the robots do while nobody comes
    /// [default: 4s]
    #[arg(long, value_name = "TIME", value_parser = until)]
    pub(super) until: Option<Until>,
    /// From anywhere: how often controls of the cell are worked at most, all together
    #[arg(long, value_name = "N", default_value_t = PRESSES)]
    pub(super) presses: u32,
    /// From anywhere: only this part of the floor, for instance 2/4, the second of four; others may be looked at elsewhere
    #[arg(long, value_name = "PART")]
    pub(super) partition: Option<Share>,
    /// From anywhere: with what the parts found whose results are in this folder (once for each); the result is that of one scan
    /// that was not divided
    #[arg(long, value_name = "DIR", conflicts_with = "partition")]
    pub(super) parts: Vec<PathBuf>,
    /// How sequences are chosen
    #[arg(long, value_enum, default_value = "auto")]
    strategy: Choice,
    /// Seed of the random generator (default: the cell's, else 1)
    #[arg(long)]
    pub(super) seed: Option<u64>,
    /// Sequences to try; for auto, in its quick part (default: the cell's, else 320 as in the paper)
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..))]
    pub(super) iterations: Option<u32>,
    /// When to stop
    #[arg(long, value_enum, default_value_t)]
    pub(super) stop_at: StopAt,
    /// Folder for the results (default: out/<cell name>)
    #[arg(long)]
    pub(super) out: Option<PathBuf>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Format,
    /// Results of an earlier scan whose hazards are known: the exit code, JUnit and SARIF then tell of new and worse ones
    #[arg(long, value_name = "SCAN")]
    pub(super) baseline: Option<PathBuf>,
    /// Keep this scan's result as the baseline: in the file that --baseline or the cell's fail_on.baseline names, else
    /// baseline.json beside the cell file. Known hazards are not looked up then
    #[arg(long)]
    pub(super) write_baseline: bool,
    /// Longest time for all of it, trying the FMU out included, for instance 90s, 5m or 2h; what was not looked at then is told
    /// [default: 10m for auto; none for others]
    #[arg(long, value_name = "TIME", value_parser = time)]
    time: Option<Duration>,
    /// Check only the posture of each sequence, so that iterations compare with the paper's
    #[arg(long)]
    pub(super) paper_iterations: bool,
    /// Do not look for changes of the cell that would be enough against what is found. That takes up to a minute or two, and
    /// is not done for cells with several beginnings
    #[arg(long)]
    pub(super) no_advice: bool,
    /// How FMU states are brought back. A complete scan has the same hazards and counts, as far as what the FMU did was run
    /// again from the start; its certificate says how far
    #[arg(long, value_enum, default_value_t)]
    pub(super) state: StateChoice,
    #[command(flatten)]
    pub(super) hosting: HostingArguments,
    #[command(flatten)]
    exhaustive: ExhaustiveArguments,
}

/// How a scan searches: one of the strategies, all sequences, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Choice {
    Auto,
    Exhaustive,
    One(StrategyName),
}

impl ValueEnum for Choice {
    fn value_variants<'a>() -> &'a [Self] {
        static ALL: LazyLock<Vec<Choice>> = LazyLock::new(|| {
            let strategies = StrategyName::value_variants().iter().map(|&name| Choice::One(name));
            [Choice::Auto, Choice::Exhaustive].into_iter().chain(strategies).collect()
        });
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Auto => Some(PossibleValue::new("auto").help(
                "`exhaustive`, as far as time and budget go, and `hybrid` beside it for a small part of the cost",
            )),
            Self::Exhaustive => Some(PossibleValue::new("exhaustive").help(
                "Every sequence there is, equal states once: a complete list of hazards, or the proof that there is none \
                 in the model",
            )),
            Self::One(name) => name.to_possible_value(),
        }
    }
}

#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Exhaustive search")]
struct ExhaustiveArguments {
    /// Most distinct states [default: 20000000; with --from anywhere, of the FMU: 300000]
    #[arg(long)]
    max_states: Option<usize>,
    /// Most memory for states, MB
    #[arg(long, default_value_t = 4_000)]
    max_memory: usize,
    /// Most work of arm searches, millions of joint-angle boxes [default: 600 for auto, a few minutes; none for
    /// exhaustive]
    #[arg(long)]
    max_work: Option<u64>,
    /// How equal states of the FMU are told
    #[arg(long, value_enum, default_value_t = MergeBy::Auto)]
    merge: MergeBy,
    /// Threads (default: one a core); the result is the same
    #[arg(long)]
    workers: Option<usize>,
}

/// Most states of a search of all sequences, unless told otherwise.
const SEQUENCE_STATES: usize = 20_000_000;

impl Default for ExhaustiveArguments {
    fn default() -> Self {
        Self { max_states: None, max_memory: 4_000, max_work: None, merge: MergeBy::Auto, workers: None }
    }
}

impl Arguments {
    /// How it searches from a beginning: what the command line says, else what the cell says.
    pub(super) fn options(&self, cell: &SearchTable) -> ScanOptions {
        ScanOptions {
            method: self.method(),
            seed: self.seed.unwrap_or(cell.seed),
            iterations: self.iterations.unwrap_or(cell.iterations),
            stop_at_first: self.stop_at == StopAt::First,
            posture_sweep: !self.paper_iterations,
            state: self.state,
        }
    }

    /// How sequences are chosen.
    fn method(&self) -> Method {
        let cores = || std::thread::available_parallelism().map_or(1, Into::into);
        if let Choice::One(name) = self.strategy {
            return Method::Strategy(name);
        }
        let own = &self.exhaustive;
        let auto = self.strategy == Choice::Auto;
        let work = own.max_work.or_else(|| auto.then_some(AUTO_WORK)).map_or(u64::MAX, |w| w * 1_000_000);
        let budget = Budget {
            states: own.max_states.unwrap_or(SEQUENCE_STATES),
            bytes: own.max_memory * 1_000_000,
            work,
            drop: true,
        };
        let how = Exhaustive { budget, merge: own.merge.into(), workers: own.workers.unwrap_or_else(cores) };
        if auto { Method::Auto(StrategyName::default(), how) } else { Method::Exhaustive(how) }
    }

    /// Threads.
    pub(super) fn workers(&self) -> usize {
        self.exhaustive.workers.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into))
    }

    /// Most states of the FMU of a scan from anywhere, where each is a step and not an action.
    pub(super) fn most_states(&self) -> usize {
        self.exhaustive.max_states.unwrap_or(MOST_STATES)
    }

    /// Where people come from in this cell.
    pub(super) fn people_from(&self, cell: &Workcell) -> From {
        let said = cell.from.map(|from| match from {
            PeopleFrom::Start => From::Start,
            PeopleFrom::Anywhere => From::Anywhere,
            PeopleFrom::Both => From::Both,
        });
        let known = self.baseline.is_some() || self.write_baseline || cell.baseline.is_some();
        let alone = known || cell.beginnings.len() > 1 || self.of_starts().is_some() || self.format == Format::Json;
        // From anywhere the transient force alone is looked at.
        let alone = alone || !cell.judges_by_force_alone();
        let usual = if alone { From::Start } else { From::Both };
        self.from.or(said).unwrap_or(usual)
    }

    /// An option that only a scan from the cell's starts has.
    pub(super) fn of_starts(&self) -> Option<&'static str> {
        let given = [
            ("--begin", self.begin.is_some()),
            ("--strategy", self.strategy != Choice::Auto),
            ("--seed", self.seed.is_some()),
            ("--iterations", self.iterations.is_some()),
            ("--stop-at", self.stop_at != StopAt::default()),
            ("--paper-iterations", self.paper_iterations),
        ];
        given.into_iter().find(|(_, is)| *is).map(|(option, _)| option)
    }

    /// A limit that only a scan from the cell's starts has. Its states from anywhere are those of the FMU alone.
    pub(super) fn limit_of_starts(&self) -> Option<&'static str> {
        let usual = ExhaustiveArguments::default();
        let ExhaustiveArguments { max_states: _, max_memory, max_work, merge, workers: _ } = &self.exhaustive;
        let given = [
            ("--max-memory", *max_memory != usual.max_memory),
            ("--max-work", max_work.is_some()),
            ("--merge", *merge != usual.merge),
        ];
        given.into_iter().find(|(_, is)| *is).map(|(option, _)| option)
    }

    /// Whether people are asked for from anywhere and from the starts in so many words.
    pub(super) fn asks_for_both(&self, cell: &Workcell) -> bool {
        match (self.from, cell.from) {
            (Some(from), _) => from == From::Both,
            (None, said) => said == Some(PeopleFrom::Both),
        }
    }

    /// An option that only a scan from anywhere has.
    pub(super) fn of_anywhere(&self) -> Option<&'static str> {
        let given = [
            ("--presses", self.presses != PRESSES),
            ("--partition", self.partition.is_some()),
            ("--parts", !self.parts.is_empty()),
        ];
        given.into_iter().find(|(_, is)| *is).map(|(option, _)| option)
    }

    /// How long after the start of the FMU a scan from anywhere looks.
    pub(super) fn until(&self) -> Until {
        self.until.unwrap_or(UNTIL)
    }

    /// The same as an argument.
    fn until_words(&self) -> String {
        until_words(self.until())
    }

    /// How far a scan from anywhere looks, in words.
    pub(super) fn extent(&self) -> String {
        match self.presses {
            PRESSES => self.until_words(),
            presses => format!("{} with {presses} presses", self.until_words()),
        }
    }

    /// How hard changes against what is found are looked for; not at all in a cell with `several` beginnings. From anywhere too where the
    /// scan is.
    pub(super) fn advice(&self, cell: &Workcell, several: bool) -> Option<RiskReductionBudget> {
        let usual = RiskReductionBudget::usual();
        let workers = self.exhaustive.workers.unwrap_or(usual.workers);
        let from_anywhere = matches!(self.people_from(cell), From::Anywhere | From::Both);
        let everywhere = from_anywhere.then(|| ReachabilityBudget {
            until: self.until(),
            presses: self.presses,
            states: self.most_states(),
            searches: ReachabilityBudget::OF_A_SCAN,
        });
        (!self.no_advice && !several).then_some(RiskReductionBudget { workers, everywhere, ..usual })
    }

    /// The longest time.
    pub(super) fn time(&self) -> Option<Duration> {
        self.time.or_else(|| (self.strategy == Choice::Auto).then_some(AUTO_TIME))
    }

    /// The command that gives the result of `options` again, in the folder `out` of the results. What only says how to come by it (threads, saved states,
    /// folders) is left out. `beginning` is that of a cell with several. A scan from anywhere has no options.
    pub(super) fn reproduce(
        &self,
        path: &Path,
        out: &Path,
        beginning: Option<usize>,
        options: Option<&ScanOptions>,
    ) -> String {
        let mut words = vec!["fmi-hazard".to_owned(), "scan".to_owned(), relative_to(path, out)];
        let mut add = |option: &str, value: Option<String>| {
            words.push(option.to_owned());
            words.extend(value);
        };
        if let Some(cell) = &self.cell {
            add("--cell", Some(relative_to(cell, out)));
        }
        if let Some(number) = beginning {
            add("--begin", Some(number.to_string()));
        }
        if let Some(options) = options {
            // The cell file may say otherwise.
            if self.from == Some(From::Start) {
                add("--from", Some("start".to_owned()));
            }
            let strategy = self.strategy.to_possible_value().map(|value| value.get_name().to_owned());
            add("--strategy", strategy);
            add("--seed", Some(options.seed.to_string()));
            add("--iterations", Some(options.iterations.to_string()));
            if options.stop_at_first {
                add("--stop-at", Some("first".to_owned()));
            }
            if !options.posture_sweep {
                add("--paper-iterations", None);
            }
        } else {
            add("--from", Some("anywhere".to_owned()));
            add("--until", Some(self.until_words()));
            if self.presses != PRESSES {
                add("--presses", Some(self.presses.to_string()));
            }
            if let Some(share) = self.partition {
                add("--partition", Some(share.to_string()));
            }
        }
        if self.no_advice {
            add("--no-advice", None);
        }
        let (own, usual) = (&self.exhaustive, ExhaustiveArguments::default());
        if let Some(states) = own.max_states {
            add("--max-states", Some(states.to_string()));
        }
        if own.max_memory != usual.max_memory {
            add("--max-memory", Some(own.max_memory.to_string()));
        }
        if let Some(work) = own.max_work {
            add("--max-work", Some(work.to_string()));
        }
        if let Some(merge) = own.merge.to_possible_value().filter(|_| own.merge != usual.merge) {
            add("--merge", Some(merge.get_name().to_owned()));
        }
        if let Some(time) = self.time {
            add("--time", Some(short(time)));
        }
        self.hosting.told(&mut add);
        // Nothing to quote it with is needed but for a zero byte, which no path holds.
        shlex::try_join(words.iter().map(String::as_str)).unwrap_or_default()
    }

    /// What is run of an example: the quick search alone, `iterations` sequences.
    pub(super) fn of_example(path: PathBuf, out: PathBuf, iterations: u32) -> Self {
        Self {
            from: None,
            until: None,
            presses: PRESSES,
            partition: None,
            parts: Vec::new(),
            path: Some(path),
            resume: None,
            cell: None,
            begin: None,
            strategy: Choice::One(StrategyName::Hybrid),
            seed: None,
            iterations: Some(iterations),
            stop_at: StopAt::default(),
            out: Some(out),
            format: Format::default(),
            baseline: None,
            write_baseline: false,
            time: None,
            paper_iterations: false,
            no_advice: false,
            state: StateChoice::default(),
            hosting: HostingArguments::default(),
            exhaustive: ExhaustiveArguments::default(),
        }
    }
}

/// How often controls are worked from anywhere, unless told otherwise.
pub(super) const PRESSES: u32 = 1;

/// How long after the start of the FMU is looked, unless told otherwise.
pub(super) const UNTIL: Until = Until::Seconds(4.0);

/// As it is given: without spaces.
fn short(time: Duration) -> String {
    humantime::format_duration(time).to_string().replace(' ', "")
}

/// Time of `auto`.
const AUTO_TIME: Duration = Duration::from_secs(600);

/// When a scan from anywhere ends.
pub(super) fn until(text: &str) -> Result<Until, String> {
    let Some(count) = text.strip_suffix("cycles").or_else(|| text.strip_suffix("cycle")) else {
        return time(text).map(|time| Until::Seconds(time.as_secs_f64())).map_err(|e| format!("{e}, or as 2cycles"));
    };
    match count.trim().parse() {
        Ok(count) if (1..=1000).contains(&count) => Ok(Until::Cycles(count)),
        _ => Err("give a number of cycles, for instance 2cycles".to_owned()),
    }
}

/// The same as an argument.
fn until_words(until: Until) -> String {
    match until {
        Until::Seconds(seconds) => short(Duration::from_secs_f64(seconds)),
        Until::Cycles(count) => format!("{count}cycles"),
    }
}

/// A time of a second at least.
fn time(text: &str) -> Result<Duration, String> {
    let time = humantime::parse_duration(text).map_err(|e| format!("{e}: give it as 90s, 5m or 2h"))?;
    if time < Duration::from_secs(1) { Err("it is shorter than a second".to_owned()) } else { Ok(time) }
}

/// Work of the exhaustive part of `auto`, millions of boxes.
const AUTO_WORK: u64 = 600;
