// Checks reports from the command line: node check_report.mjs [--main | --quick | --flat] report.html [more.html]
// With --main only what shows soonest that a report works: picture, scrubber, selection, links, form. With --quick those of them that need
// no 3-D graphics and one that does, and one of eight of the others, by FMI_HAZARD_SAMPLE as in src/sample.rs. With --flat only those that
// need no 3-D graphics: what any report has, and of the others one of eight.

import { CHECKS, checkReport, withBrowsers } from "./report.mjs";

const sample = process.env.FMI_HAZARD_SAMPLE ?? "0";
const needsNone = ({ flat = false, graphics = true }) => flat || !graphics;
const moves = "scrubbing changes the picture";
const isQuick = ({ name, main = false, flat = false }) => (main && flat) || name === moves;
const others = CHECKS.filter((check) => !isQuick(check));
const isTurn = (check, of) => sample === "all" || of.indexOf(check) % 8 === Number(sample) % 8;

const WANTED = {
  "--main": ({ main = false }) => main,
  "--quick": (check) => isQuick(check) || (others.includes(check) && isTurn(check, others)),
  "--flat": (check) => needsNone(check) && (check.bare || isTurn(check, CHECKS)),
};
const option = process.argv[2] in WANTED ? process.argv[2] : null;
const files = process.argv.slice(option === null ? 2 : 3);
if (files.length === 0) {
  console.error("usage: node check_report.mjs [--main | --quick | --flat] report.html [more.html]");
  process.exit(2);
}

let failed = 0;
await withBrowsers(async (browsers) => {
  for (const file of files) {
    console.log(file);
    const hear = (name, error) => {
      console.log(`  ${error ? "FAILED" : "ok"}  ${name}`);
      if (error) {
        failed += 1;
        console.log(`${error.message}`.replace(/^/gm, "          "));
      }
    };
    const quick = option === "--quick" || option === "--flat";
    await checkReport(file, browsers, hear, { quick, ...(option === null ? {} : { wanted: WANTED[option] }) });
  }
});
console.log(failed === 0 ? "All checks passed." : `${failed} checks failed.`);
process.exitCode = failed === 0 ? 0 : 1;
